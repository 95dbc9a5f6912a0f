"""Sums of few sizes that are known within limits, cell by cell: their ends, and their errors by them.

Where terms of both signs differ little, one box says too little of a sum; a few hundred evaluations of it are cheaper
than as many boxes of a whole function.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from itertools import product
from typing import Any, NamedTuple

Ball = Any
Ends = Mapping[int, tuple[Ball, Ball]]  # of the logarithms of sizes, by their numbers
Key = tuple[tuple[int, float], ...]
Terms = Mapping[Key, Ball]

HALVINGS, MOST = 20, 128  # of the box down to a cell, and cells
CORNERS = 5  # sizes of a sum whose values at all corners are looked at first
RATIO = 1e6  # of the largest of these to the smallest: cells of larger ones would be too many
SHARP = 2.0  # a cell's ends may differ by this factor


class Cell(NamedTuple):
    """A part of the box, and the ends of a sum on it."""

    sizes: Ends
    low: Ball
    high: Ball
    decisive: int  # the size that it changes most with


class Along(NamedTuple):
    """Sizes that are functions of another one."""

    size: int  # that they are functions of
    curves: Mapping[int, Callable[[Ball, Ball], tuple[Ball, Ball]]]  # their ends by those of it

    def __call__(self, sizes: Ends) -> Ends:
        """A cell with theirs."""
        return {**sizes, **{n: curve(*sizes[self.size]) for n, curve in self.curves.items()}}


NONE = Along(0, {})  # no size is one of another


def cells(value: Terms, whole: Ends, along: Along = NONE) -> list[Cell] | None:
    """The box in parts in which a sum is known well; None where it has no sign that is seen.

    Args:
        value: the sum; coefficients may have either sign.
        whole: where its sizes lie.
        along: those of its sizes that are functions of one of these.
    """
    sign, at_once = _at_corners(value, whole, along)
    found: list[Cell] = []
    waiting = [(whole, 0 if at_once else HALVINGS)]
    while waiting:
        sizes, halvings = waiting.pop()
        cell = _cell(value, sizes, along)
        if _sign(cell) and (not halvings or _is_sharp(cell)):
            found.append(cell)
        elif not halvings or len(found) > MOST or not sign * sum_on(value, along(_middle(sizes))) > 0:
            return None
        else:
            waiting += [(half, halvings - 1) for half in _halves(sizes, cell.decisive)]
    return found


def _at_corners(value: Terms, whole: Ends, along: Along) -> tuple[int, bool]:
    """Its sign there, and whether it has one of either kind, or is so large and so small that cells are of no use."""
    if len(whole) > CORNERS:
        return 0, True
    points = ({n: (end, end) for n, end in zip(whole, ends, strict=True)} for ends in product(*whole.values()))
    values = [sum_on(value, along(point)) for point in points]
    signs = {1 if one > 0 else -1 if one < 0 else 0 for one in values}
    sizes = [abs(one) for one in values]
    return min(signs), len(signs) > 1 or signs == {0} or not max(sizes) < RATIO * min(sizes)


def ends(of: list[Cell]) -> tuple[Ball, Ball]:
    """Of the sum, all over the box."""
    return min(cell.low for cell in of), max(cell.high for cell in of)


def largest_share(error: Terms, of: list[Cell], others: Ends) -> Ball | None:
    """A number κ with error ≤ κ · |sum| all over the box, if there is one; `others` are sizes of the error alone."""
    shares = [sum_on(error, {**others, **cell.sizes}) / min(abs(cell.low), abs(cell.high)) for cell in of]
    return max(share.upper() for share in shares) if all(share.is_finite() for share in shares) else None


def _sign(cell: Cell) -> int:
    if not (cell.low.is_finite() and cell.high.is_finite()):
        return 0
    return 1 if cell.low > 0 else -1 if cell.high < 0 else 0


def _is_sharp(cell: Cell) -> bool:
    near, far = sorted((abs(cell.low), abs(cell.high)))
    return bool(far < SHARP * near)


def _middle(sizes: Ends) -> Ends:
    return {n: (((low + high) / 2).mid(),) * 2 for n, (low, high) in sizes.items()}


def _halves(sizes: Ends, decisive: int) -> list[Ends]:
    low, high = sizes[decisive]
    middle = ((low + high) / 2).mid()
    return [{**sizes, decisive: ends} for ends in ((low, middle), (middle, high))]


def _cell(value: Terms, free: Ends, along: Along) -> Cell:
    """The ends of a sum on a cell: at an end of each size with which it grows or falls, by slopes in the others."""
    sizes, slopes = along(free), dict[int, Ball]()
    for key, term in _terms_on(value, sizes):
        for n, exponent in key:
            slopes[n] = slopes.get(n, 0) + term * exponent
    middle = _middle(sizes)
    reach = {n: max((high - middle[n][0]).upper(), (middle[n][0] - low).upper()) for n, (low, high) in sizes.items()}
    changes = {n: abs(slope).upper() * reach[n] for n, slope in slopes.items()}
    bound = {along.size, *along.curves} if along.curves else set()  # one does not move without the others
    turning = [n for n, slope in slopes.items() if n not in bound and not (slope > 0 or slope < 0)]
    away = sum((changes[n] for n in turning), 0)
    found = []
    for side, turn in ((0, -1), (1, 1)):
        there = {**sizes, **{n: _end(sizes[n], slope, side) for n, slope in slopes.items() if n not in bound}}
        found.append([sum_on(value, there)])
        if turning:
            found[-1].append(sum_on(value, {**there, **{n: middle[n] for n in turning}}) + turn * away)
    low, high = max(one.lower() for one in found[0]), min(one.upper() for one in found[1])
    together = {along.size: sum((changes.get(n, 0) for n in bound), 0)} if bound else {}
    return Cell(sizes, low, high, _decisive({n: changes.get(n, 0) for n in free} | together))


def _decisive(changes: Mapping[int, Ball]) -> int:
    return max(changes, key=lambda n: float(changes[n]), default=0)


def _end(ends: tuple[Ball, Ball], slope: Ball, side: int) -> tuple[Ball, Ball]:
    if slope > 0:
        return ends[side], ends[side]
    return (ends[1 - side], ends[1 - side]) if slope < 0 else ends


def sum_on(value: Terms, sizes: Ends) -> Ball:
    """A sum with every size anywhere between its ends."""
    return sum((term for _, term in _terms_on(value, sizes)), 0)


def _terms_on(value: Terms, sizes: Ends) -> Iterator[tuple[Key, Ball]]:
    for key, coefficient in value.items():
        low: Ball = 0
        high: Ball = 0
        for n, exponent in key:
            first, last = sizes[n] if exponent > 0 else sizes[n][::-1]
            low, high = low + first * exponent, high + last * exponent
        yield key, coefficient * low.exp().union(high.exp()) if key else coefficient
