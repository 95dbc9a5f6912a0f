"""Where a printed formula is wrong: a round point at which it matters, and the worst over the domain."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from radartrack.derive.checking.comparison import Comparison, Values
from radartrack.derive.checking.points import Point, domain_points, generic_points, round_points
from radartrack.derive.checking.verdict import Counterexample
from radartrack.derive.evaluation import Number
from radartrack.derive.tensor import Index
from radartrack.derive.variable import Variable

MATTERS = 0.01  # a relative difference that nobody overlooks
DOMAIN_POINTS = 40
STEP = 0.5
Scale = Callable[[Point], Number]


def find_difference(comparison: Comparison, symbols: Sequence[Variable]) -> Values | None:
    """The plainest round point at which the formulas differ by an amount that matters, else where they differ most.

    Points of ordinary size come after the round ones, then points all over the domain.
    """
    found: list[Values] = []
    for point in round_points(symbols):
        values = comparison.differ_at(point)
        if values is not None and values.relative >= MATTERS:
            return values
        found += [values] if values else []
    if found:
        return max(found, key=lambda values: values.relative)
    others = (*generic_points(symbols, 6), *domain_points(symbols, 12))
    return next((values for point in others if (values := comparison.differ_at(point))), None)


@dataclass(frozen=True)
class Worst:
    """A relative difference and where it is."""

    relative: float
    point: Point


def worst_over_domain(comparison: Comparison, symbols: Sequence[Variable], scale: Scale, start: Point) -> Worst:
    """The largest difference relative to the scale among points of the domain, improved along each symbol."""

    def measured(point: Point) -> Worst:
        values = comparison.at(point)
        if values is None:
            return Worst(0.0, point)
        size = scale(point) or abs(values.printed)
        return Worst(float(abs(values.difference) / size) if size else 0.0, point)

    points = (start, *domain_points(symbols, DOMAIN_POINTS))
    best = max(map(measured, points), key=lambda worst: worst.relative)
    for symbol in symbols:
        moved = (best.point | {symbol.name: value} for value in _neighbours(symbol, best.point, STEP))
        best = max([best, *map(measured, moved)], key=lambda worst: worst.relative)
    return best


def counterexample(values: Values, entry: Index, worst: Worst, symbols: Sequence[Variable]) -> Counterexample:
    """The point and the worst of the domain as data."""
    return Counterexample(
        point=values.point,
        entry=entry,
        printed=float(values.printed),
        derived=float(values.derived),
        relative_difference=values.relative,
        units={symbol.name: str(symbol.unit) for symbol in symbols},
        largest_relative_difference=worst.relative,
        largest_at=worst.point,
    )


def _neighbours(symbol: Variable, point: Point, step: float) -> list[float]:
    """The ends of the domain, and a step to either side."""
    value = point[symbol.name]
    high = min(symbol.high, point[symbol.at_most.name]) if symbol.at_most else symbol.high
    if symbol.low > 0:
        factor = (high / symbol.low) ** (step / 4)
        beside = [value / factor, value * factor]
    else:
        beside = [value - (high - symbol.low) * step / 4, value + (high - symbol.low) * step / 4]
    inside = [v for v in (symbol.low, *beside, high) if symbol.low <= v <= high]
    return [float(round(v)) for v in inside] if symbol.whole else inside
