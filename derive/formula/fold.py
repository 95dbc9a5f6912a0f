"""Works out something about a formula from the same thing about its parts, once for parts that are one object."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from operator import is_
from typing import Generic, TypeVar

from radartrack.derive.formula.tree import Tree, children, with_children

Known = TypeVar("Known")


class Fold(Generic[Known]):
    """What is known of trees by their parts; what was worked out for one tree serves all that share parts with it.

    Args:
        step: works it out for a node, from the node and from what is known of its children, in their order.
    """

    def __init__(self, step: Callable[[Tree, Sequence[Known]], Known]) -> None:
        self._step = step
        self._known: dict[int, tuple[Tree, Known]] = {}  # by identity; the tree is kept for as long

    def __call__(self, tree: Tree) -> Known:
        """What is known of a tree; raises what the step raises."""
        known = self._known.get(id(tree))
        if known is None:
            found = self._step(tree, [self(child) for child in children(tree)])
            known = self._known[id(tree)] = tree, found
        return known[1]


def rebuild(tree: Tree, change: Callable[[Tree], Tree]) -> Tree:
    """The tree with `change` applied to every node, leaves first; what does not change stays the same object."""

    def rebuilt(node: Tree, new: Sequence[Tree]) -> Tree:
        return change(node if all(map(is_, children(node), new)) else with_children(node, tuple(new)))

    return Fold(rebuilt)(tree)


def shared(tree: Tree, change: Callable[[Tree], Tree]) -> Tree:
    """The rebuilt tree with one object for all parts that are equal: what is found out about it is found out once."""
    known: dict[Tree, Tree] = {}

    def one(node: Tree) -> Tree:
        changed = change(node)
        return known.setdefault(changed, changed)

    return rebuild(tree, one)
