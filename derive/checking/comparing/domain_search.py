"""Searches a domain for where a function is largest: its corners, its zeros and what is between, then uphill.

Points spread over a domain miss what happens on its edge, where one deviation vanishes beside another or two
coordinates are zero together; there formulas differ most.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Sequence
from heapq import nlargest
from itertools import islice, product

from radartrack.derive.evaluation.points import Point
from radartrack.derive.language.variable import Variable

CORNERS = 256
STARTS = 4
STEPS = (0.25, 0.06, 0.015)  # of the width of the domain, in its logarithm where that is positive
ROUNDS = 8  # uphill with one step, at most
GAIN = 1.001  # what is less is no way up

Height = Callable[[Point], float]


def summits(
    height: Height, symbols: Sequence[Variable], inside: Callable[[Point], bool], starts: Iterable[Point]
) -> list[Point]:
    """Points from which no step leads uphill, the highest first.

    Args:
        height: of a point; nothing where there is none.
        symbols: with the limits of the domain.
        inside: whether a point belongs to it.
        starts: points to begin with, besides those of the edge.
    """
    candidates = [*starts, *filter(inside, edges(symbols))]
    ranked = [(height(point), number) for number, point in enumerate(candidates)]
    found = [_climbed(value, candidates[number], height, symbols, inside) for value, number in nlargest(STARTS, ranked)]
    return [point for _, point in sorted(found, key=lambda pair: pair[0], reverse=True)]


def edges(symbols: Sequence[Variable]) -> Iterator[Point]:
    """Corners of a domain and its zeros, with the middles that fit into their number."""
    values = [_marks(symbol) for symbol in symbols]
    names = [symbol.name for symbol in symbols]
    corners = product(*values)
    step = max(1, math.prod(map(len, values)) // CORNERS)
    step += step % 2 == 0 and step > 1  # odd, or some symbols would always have the same value
    yield from (dict(zip(names, corner, strict=True)) for corner in islice(corners, 0, CORNERS * step, step))


def _marks(symbol: Variable) -> tuple[float, ...]:
    """The ends of a domain, and what is special between them: zero, a right angle, the middle of a scale."""
    low, high = float(symbol.low), float(symbol.high)
    if symbol.low > 0:
        middle = math.sqrt(low * high)
        return tuple(dict.fromkeys((low, float(round(middle)) if symbol.whole else middle, high)))
    between = (0.0, math.pi / 4, math.pi / 2) if symbol.is_angle else (0.0, high / 2)
    return tuple(dict.fromkeys((low, *(value for value in between if low < value < high), high)))


def _climbed(
    value: float, point: Point, height: Height, symbols: Sequence[Variable], inside: Callable[[Point], bool]
) -> tuple[float, Point]:
    for step in STEPS:
        for _ in range(ROUNDS):
            before = value
            for symbol in symbols:
                for moved in _moved(symbol, point, step):
                    if inside(moved) and (found := height(moved)) > value * GAIN:
                        value, point = found, moved
            if value <= before * GAIN:
                break
    return value, point


def _moved(symbol: Variable, point: Point, step: float) -> Iterator[Point]:
    """A step to either side, not beyond the ends of the domain."""
    value, low, high = point[symbol.name], float(symbol.low), float(symbol.high)
    if symbol.at_most and symbol.at_most.name in point:
        high = min(high, point[symbol.at_most.name])
    for way in (-step, step):
        new = value * (high / low) ** way if low > 0 else value + (high - low) * way
        new = min(max(new, low), high)
        if symbol.whole:
            new = (
                float(round(new)) if round(new) != round(value) else min(max(value + math.copysign(1, way), low), high)
            )
        if new != value:
            yield point | {symbol.name: new}
