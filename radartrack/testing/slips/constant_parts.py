"""A constant that a function has inside a formula: added to a part, to all sums at once, or in place of a part."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator

import numpy as np
import numpy.typing as npt

from radartrack.derive.checking.repairing.edit_search import Candidate, Search
from radartrack.derive.evaluation.tree_values import Program, Screen, Values
from radartrack.derive.formula.fold import rebuild
from radartrack.derive.formula.tree import Call, Name, Negation, Number, Power, Sum, Tree, replace_at, walk

FUDGE, OFFSET, OTHER = 1.9, 2.6, 2.7  # the cost of a constant that is added, small or not, and of one for a part
DIGIT = 0.3  # of each more of its digits
STEADY, LAST = 1e-6, 1e-13  # of itself, and of what it is added to, by how much a constant may scatter
VISIBLE, SLIGHT = 1e-11, 1e-2  # of what it is added to, from where on it is one, and up to where it is small
LONGEST = 120  # nodes of a formula to whose sums a constant is added at once
STEPS, FIRST = 6, 1e-6  # of the secant method, and the first of them, of the size of a sum
ALIKE = 1e-4  # of a constant, by which it may scatter where it follows from the whole formula
UNKNOWN = Name("constant")

Constant = tuple[Tree, float]  # and what it costs


def constant_parts(search: Search, screen: Screen, tree: Tree, target: Values) -> Iterator[Candidate]:
    """Edits with a constant.

    Args:
        search: what parts would have to be worth.
        screen: the points.
        tree: the derived formula.
        target: what the function has.
    """
    for part in search.parts(tree):
        if isinstance(part.node, Number):
            continue
        for node, needed, put in _itself_and_root(part.node, part.needed):
            if found := _added(needed, screen(node)):
                yield Candidate(replace_at(tree, part.path, put(_with_term(node, found[0]))), "", found[1])
        if part.path and (found := _constant(np.array(part.needed), np.abs(part.needed), OTHER)):
            yield Candidate(replace_at(tree, part.path, found[0]), "", found[1])
    yield from _in_all_sums(screen, tree, target)


def _itself_and_root(node: Tree, needed: Values) -> Iterator[tuple[Tree, Values, Callable[[Tree], Tree]]]:
    """A part, what it would have to be worth, and what makes the part of it; then the root of a sum likewise."""
    yield node, needed, lambda tree: tree
    if isinstance(node, Sum) and min(needed) > 0:
        yield Call("sqrt", (node,)), tuple(map(math.sqrt, needed)), _squared


def _in_all_sums(screen: Screen, tree: Tree, target: Values) -> Iterator[Candidate]:
    """The same constant in all sums of the formula, or in the roots of all."""
    nodes = [node for _, node in walk(tree)]
    sums = {node for node in nodes if isinstance(node, Sum) and node != tree}
    if len(nodes) > LONGEST or len([node for node in nodes if node in sums]) < 2:
        return

    def with_terms(term: Tree) -> Iterator[Tree]:
        def in_root(node: Tree) -> Tree:
            return _squared(Sum((Call("sqrt", (node,)), term))) if node in sums else node

        yield rebuild(tree, lambda node: _with_term(node, term) if node in sums else node)
        yield rebuild(tree, in_root)

    size = max(min(map(abs, screen(one) or (0.0,))) for one in sums)
    for way, edited in enumerate(with_terms(UNKNOWN)):
        if size and (found := _constant(values := _solved(screen, edited, target, size), np.abs(values), FUDGE, ALIKE)):
            yield Candidate(list(with_terms(found[0]))[way], "", found[1])


def _solved(screen: Screen, tree: Tree, target: Values, size: float) -> npt.NDArray[np.float64]:
    """What the unknown constant would have to be at each point."""
    program = Program(tree)
    found = []
    for place, wanted in enumerate(target):
        point = {name: values[place] for name, values in screen.names.items()}

        def away(constant: float, point: dict[str, float] = point, wanted: float = wanted) -> float:
            value = program({**point, UNKNOWN.name: constant})
            return math.nan if value is None else value[0] - wanted

        before, here = 0.0, FIRST * size
        for _ in range(STEPS):
            slope = (away(here) - away(before)) / (here - before) if here != before else 0.0
            before, here = here, here - away(here) / slope if slope else here
        found.append(here)
    return np.array(found)


def _added(needed: Values, own: Values | None) -> Constant | None:
    """What is added everywhere; None where it varies."""
    if own is None:
        return None
    size, away = np.maximum(np.abs(needed), np.abs(own)), np.subtract(needed, own)
    if not (np.abs(away) > VISIBLE * size).all():
        return None
    return _constant(away, size, FUDGE if (np.abs(away) <= SLIGHT * size).all() else OFFSET)


def _constant(
    values: npt.NDArray[np.float64], size: npt.NDArray[np.float64], cost: float, steady: float = STEADY
) -> Constant | None:
    """The constant that values are, as far as the last digits of their sizes tell; those of one digit are likely."""
    constant = float(np.median(values))
    scatter = np.abs(values - constant)
    if not constant or not (scatter <= steady * abs(constant) + LAST * size).all():
        return None
    text = _short_number(abs(constant), float(scatter.max()))
    term = Number(text)
    return (term if constant > 0 else Negation(term)), cost + DIGIT * (len(text.partition("e")[0].strip("0.")) - 1)


def _short_number(value: float, scatter: float) -> str:
    """As few digits as it may have been written with."""
    near = (f"{value:.{digits}g}" for digits in range(1, 9))
    return next((text for text in near if abs(float(text) - value) <= 2 * scatter + STEADY * value), f"{value:.9g}")


def _with_term(node: Tree, term: Tree) -> Tree:
    return Sum((*(node.terms if isinstance(node, Sum) else (node,)), term))


def _squared(tree: Tree) -> Tree:
    return Power(tree, Number("2"))
