"""What has the right values in one half plane alone: atan for atan2, a size for a number."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import numpy.typing as npt

from radartrack.derive.evaluation.tree_values import Program
from radartrack.derive.formula.from_expression import to_tree
from radartrack.derive.formula.printing import to_text
from radartrack.derive.formula.tree import Call, Number, Power, Quotient, Sum, Tree, replace_at, walk
from radartrack.testing.calling.called_function import Array
from radartrack.testing.diagnosis import Slip
from radartrack.testing.function_conventions import is_direction
from radartrack.testing.unexplained_difference import region
from radartrack.testing.wanted import Expected

SAME = 1e-6  # of the scale of an entry: an arc cosine near 1 has half of the digits
LONGEST = 120  # nodes of a formula whose parts are tried
COST = 1.3


def half_planes(expected: Expected, found: Array) -> tuple[Slip, ...]:
    """For each entry that is wrong what stands there that is right in a part of the domain; none where one is left.

    Args:
        expected: the exact values on all scales and in all directions.
        found: what the function has there, shape (points, entries).
    """
    slips = []
    for place in np.flatnonzero(_differs(expected, found).any(axis=0)):
        slip = next(_of_entry(expected, found, int(place)), None)
        if slip is None:
            return ()
        slips.append(slip)
    return tuple(slips)


def _of_entry(expected: Expected, found: Array, place: int) -> Iterator[Slip]:
    tree = to_tree(expected.wanted.entries[place])
    differs = _differs(expected, found)[:, place]
    index = (expected.wanted.places[place],) if expected.wanted.shape else ()
    for path, node in walk(tree):
        for other in _others(node) if len(list(walk(tree))) <= LONGEST else ():
            edited = replace_at(tree, path, other)
            values = _values(edited, expected)
            if not _differs(expected, found, place, values).any() and np.isfinite(values).any():
                where = region(expected, differs)
                only = f", which differs {where}" if where.startswith("only") else ""
                yield Slip(index, f"{to_text(other)} for {to_text(node)}{only}", to_text(edited), to_text(tree), COST)


def _others(node: Tree) -> Iterator[Tree]:
    """What has the values of a part where it, or what it is a function of, is positive."""
    match node:
        case Call("atan2", (opposite, adjacent)):
            two = Number("2")
            distance = Call("sqrt", (Sum((Power(opposite, two), Power(adjacent, two))),))
            yield Call("atan", (Quotient(opposite, adjacent),))
            yield Call("asin", (Quotient(opposite, distance),))
            yield Call("acos", (Quotient(adjacent, distance),))
    if not isinstance(node, Number):
        yield Call("abs", (node,))


def _values(tree: Tree, expected: Expected) -> Array:
    """Those of a formula at the points; no number where it has none."""
    program = Program(tree)
    found = [program(expected.point(place)) for place in range(expected.count)]
    return np.array([np.nan if one is None else one[0] for one in found])


def _differs(
    expected: Expected, found: Array, place: int | None = None, values: Array | None = None
) -> npt.NDArray[np.bool_]:
    """Where what the function has is not what is exact, or in one entry another value; nothing is said of no number."""
    chosen = slice(None) if place is None else place
    exact = expected.values[:, chosen] if values is None else values
    with np.errstate(all="ignore"):
        away = found[:, chosen] - exact
        turns = np.array([is_direction(expected.wanted, one) for one in expected.wanted.places])[chosen]
        away = np.where(turns, np.angle(np.exp(1j * away)), away)
        return np.asarray(np.abs(away) > SAME * expected.scales[:, chosen])
