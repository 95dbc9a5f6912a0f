"""A part of a formula that a function cuts to a whole number: T**3//3, int(T), a quotient of whole numbers in C."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from functools import partial
from itertools import chain, combinations

import numpy as np

from radartrack.derive.evaluation.tree_values import Program, Values
from radartrack.derive.formula.printing import to_text
from radartrack.derive.formula.tree import Name, Number, Path, Product, Quotient, Tree, replace_at, walk
from radartrack.testing.calling.called_function import Array
from radartrack.testing.diagnosis import Slip
from radartrack.testing.wanted import Expected

LONGEST = 120  # nodes of a formula whose parts are tried
FACTORS = 5  # of a product of which all parts are tried
COST = 2.0
SAME = 1e-9  # of an entry
FEWEST = 6  # points at which the function is as it would be with the part cut, and other than as it stands
CUT: dict[str, Callable[[float], float]] = {
    "rounded down to a whole number": math.floor,
    "cut to a whole number": math.trunc,
    "rounded to a whole number": round,
}
Factor = tuple[Tree, bool]  # and whether it stands above the line
PART = "cut"  # the name under which the values of a part stand in the formula


def rounded_part(trees: Sequence[Tree], expected: Expected, found: Array, place: int) -> Slip | None:
    """The part that the function has as a whole number; None without any.

    Args:
        trees: ways to write the entry.
        expected: the exact values on all scales.
        found: what the function has there, shape (points, entries).
        place: of the entry.
    """
    points = [expected.point(n) for n in range(expected.count)]
    target, exact = found[:, place], expected.values[:, place]
    index = (expected.wanted.places[place],) if expected.wanted.shape else ()
    for tree in trees:
        for part, in_place in _parts(tree):
            program, edited = Program(part), Program(in_place(Name(PART)))
            values = [one[0] for one in map(program, points) if one is not None]
            if len(values) < len(points):
                continue
            for words, cut in CUT.items():
                having = [edited({**point, PART: cut(value)}) for point, value in zip(points, values, strict=True)]
                if _is_so(having, target, exact):
                    return Slip(index, f"{to_text(part)} is {words}", "", "", COST)
    return None


def _parts(tree: Tree) -> Iterator[tuple[Tree, Callable[[Tree], Tree]]]:
    """Parts, products of some of the factors of a term too, and what makes the whole of them."""
    nodes = list(walk(tree))
    for path, node in nodes if len(nodes) <= LONGEST else ():
        if isinstance(node, Number):
            continue
        above, below = _factors(node)
        if 1 < len(above) + len(below) <= FACTORS:
            for chosen, others in _splits(above, below):
                yield chosen, partial(_beside, tree, path, others)
        yield node, partial(replace_at, tree, path)


def _beside(tree: Tree, path: Path, others: Sequence[Factor], part: Tree) -> Tree:
    """The whole with a part beside the other factors of a term."""
    return replace_at(tree, path, _quotient([(part, True), *others]))


def _factors(node: Tree) -> tuple[tuple[Tree, ...], tuple[Tree, ...]]:
    """Those above the line and those below it."""
    above, below = (node.numerator, node.denominator) if isinstance(node, Quotient) else (node, None)
    return tuple(() if one is None else one.factors if isinstance(one, Product) else (one,) for one in (above, below))  # type: ignore[return-value]


def _splits(above: Sequence[Tree], below: Sequence[Tree]) -> Iterator[tuple[Tree, list[Factor]]]:
    """The product of some of the factors, and the rest of them."""
    factors = [*((one, True) for one in above), *((one, False) for one in below)]
    for size in range(1, len(factors)):
        for chosen in combinations(range(len(factors)), size):
            rest = [factor for place, factor in enumerate(factors) if place not in chosen]
            yield _quotient([factors[place] for place in chosen]), rest


def _quotient(factors: Sequence[Factor]) -> Tree:
    above, below = ([one for one, is_above in factors if is_above is wanted] for wanted in (True, False))
    numerator, denominator = (
        Product(tuple(one)) if len(one) > 1 else next(iter(one), Number("1")) for one in (above, below)
    )
    return Quotient(numerator, denominator) if below else numerator


def _is_so(having: Sequence[Values | None], target: Array, exact: Array) -> bool:
    """Whether the function is the edited formula everywhere, and at enough points not the formula as it stands."""
    if None in having:
        return False
    values = np.array(list(chain.from_iterable(one for one in having if one is not None)))
    with np.errstate(all="ignore"):
        size = np.maximum(np.abs(exact), np.abs(values))
        near, apart = np.abs(values - target) <= SAME * size, np.abs(values - exact) > SAME * size
    return bool(near.all()) and int((apart & (values != 0)).sum()) >= FEWEST
