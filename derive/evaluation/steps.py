"""The order in which formulas are computed: every distinct part once, each from parts before it.

Whoever evaluates says what one node takes: an operation of its own arithmetic, and the nodes that it works on.
"""

from __future__ import annotations

from collections.abc import Callable, Hashable, Iterable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Generic, TypeVar

if TYPE_CHECKING:  # trees are evaluated without SymPy
    from radartrack.derive.symbolic import Expr

Node = TypeVar("Node")
Operation = TypeVar("Operation")


@dataclass(frozen=True)
class Steps(Generic[Operation]):
    """Operations in order, over slots: the first hold what is given, each step fills the next.

    Attributes:
        given: how many slots are filled at the start.
        steps: operations, and the slots of their operands.
        results: the slots of what was asked for.
    """

    given: int
    steps: tuple[tuple[Operation, tuple[int, ...]], ...]
    results: tuple[int, ...]


def steps(
    roots: Iterable[Node],
    given: Sequence[Node],
    step: Callable[[Node], tuple[Operation, Sequence[Node]]],
    key: Callable[[Node], Hashable] = lambda node: node,
) -> Steps[Operation]:
    """Plan the computation of some nodes.

    Args:
        roots: what is wanted.
        given: the nodes whose values are there at the start.
        step: the operation that makes a node, and the nodes that it works on.
        key: what tells nodes apart.
    """
    slots: dict[Hashable, int] = {key(node): slot for slot, node in enumerate(given)}
    planned: list[tuple[Operation, tuple[int, ...]]] = []

    def slot(node: Node) -> int:
        name = key(node)
        if name not in slots:
            operation, operands = step(node)
            places = tuple(map(slot, operands))
            slots[name] = len(given) + len(planned)
            planned.append((operation, places))
        return slots[name]

    results = tuple(map(slot, roots))
    return Steps(len(given), tuple(planned), results)


def leaves(expression: Expr) -> set[Expr]:
    """The symbols and numbers that occur."""
    if not expression.args:
        return {expression}
    return set().union(*(leaves(argument) for argument in expression.args))
