"""Sums of few sizes that are known within limits, cell by cell: their ends, and their errors by them.

Where terms of both signs differ little, one box says too little of a sum; a few hundred evaluations of it are cheaper
than as many boxes of a whole function.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, NamedTuple

Ball = Any
Ends = Mapping[int, tuple[Ball, Ball]]  # of the logarithms of sizes, by their numbers
Terms = Mapping[tuple[tuple[int, float], ...], Ball]

MOST = 96  # cells of a sum
REACH = 80.0  # of logarithms, all sizes together: cells of wider ones would be too many
SHARP = 2.0  # a cell's ends may differ by this factor


class Cell(NamedTuple):
    """A part of the box, and the ends of a sum on it."""

    sizes: Ends
    low: Ball
    high: Ball
    decisive: int  # the size that it changes most with


def cells(value: Terms, whole: Ends) -> list[Cell] | None:
    """The box in parts in which a sum is known well; None where it has no sign that is seen.

    Args:
        value: the sum; coefficients may have either sign.
        whole: where its sizes lie.
    """
    found: list[Cell] = []
    waiting = [whole]
    if sum(float(high - low) for low, high in whole.values()) > REACH:
        cell = _cell(value, whole)
        return [cell] if _sign(cell) else None
    sign = _sign(_cell(value, _middle(whole)))
    while waiting:
        cell = _cell(value, waiting.pop())
        full = len(found) + len(waiting) + 1 >= MOST
        if _sign(cell) and (full or _is_sharp(cell)):
            found.append(cell)
        elif full or not _sign(_cell(value, _middle(cell.sizes))) == sign:
            return None
        else:
            waiting += _halves(cell)
    return found


def ends(of: list[Cell]) -> tuple[Ball, Ball]:
    """Of the sum, all over the box."""
    return min(cell.low for cell in of), max(cell.high for cell in of)


def largest_share(error: Terms, of: list[Cell], others: Ends) -> Ball | None:
    """A number κ with error ≤ κ · |sum| all over the box, if there is one; `others` are sizes of the error alone."""
    shares = [sum_on(error, {**others, **cell.sizes}) / min(abs(cell.low), abs(cell.high)) for cell in of]
    return max(share.upper() for share in shares) if all(share.is_finite() for share in shares) else None


def _sign(cell: Cell) -> int:
    return 1 if cell.low > 0 else -1 if cell.high < 0 else 0


def _is_sharp(cell: Cell) -> bool:
    near, far = sorted((abs(cell.low), abs(cell.high)))
    return bool(far < SHARP * near)


def _middle(sizes: Ends) -> Ends:
    return {n: (((low + high) / 2).mid(),) * 2 for n, (low, high) in sizes.items()}


def _halves(cell: Cell) -> list[Ends]:
    low, high = cell.sizes[cell.decisive]
    middle = ((low + high) / 2).mid()
    return [{**cell.sizes, cell.decisive: ends} for ends in ((low, middle), (middle, high))]


def _cell(value: Terms, sizes: Ends) -> Cell:
    """The ends of a sum on a cell: at an end of every size with which it grows or falls, by its slopes in the others."""
    slopes = {n: sum_on({k: c * dict(k).get(n, 0) for k, c in value.items() if n in dict(k)}, sizes) for n in sizes}
    turning = [n for n, slope in slopes.items() if slope.contains(0)]
    middle = _middle(sizes)
    changes = {n: abs(slope).upper() * (sizes[n][1] - sizes[n][0]) for n, slope in slopes.items()}
    away = sum((changes[n] for n in turning), 0) / 2
    ends = []
    for side in (0, 1):
        there = {n: _end(sizes[n], slopes[n], side) for n in sizes}
        plain, centred = sum_on(value, there), sum_on(value, {**there, **{n: middle[n] for n in turning}})
        ends.append((plain, centred))
    low = max(ends[0][0].lower(), (ends[0][1] - away).lower())
    high = min(ends[1][0].upper(), (ends[1][1] + away).upper())
    return Cell(sizes, low, high, max(changes, key=lambda n: float(changes[n]), default=0))


def _end(ends: tuple[Ball, Ball], slope: Ball, side: int) -> tuple[Ball, Ball]:
    if slope > 0:
        return ends[side], ends[side]
    return (ends[1 - side], ends[1 - side]) if slope < 0 else ends


def sum_on(value: Terms, sizes: Ends) -> Ball:
    """A sum with every size anywhere between its ends."""
    total = 0
    for key, coefficient in value.items():
        low = high = coefficient * 0
        for n, exponent in key:
            first, last = sizes[n] if exponent > 0 else sizes[n][::-1]
            low, high = low + first * exponent, high + last * exponent
        total = total + coefficient * low.exp().union(high.exp())
    return total
