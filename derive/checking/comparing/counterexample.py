"""Where a printed formula is wrong: a round point at which it matters, and the worst over the domain."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from itertools import chain
from operator import itemgetter

import mpmath

from radartrack.derive.checking.comparing.domain_search import summits
from radartrack.derive.checking.comparing.numerical_comparison import (
    LARGEST,
    NOISE,
    Comparison,
    Imaginary,
    Values,
    is_real,
)
from radartrack.derive.checking.comparing.question_domain import Domain
from radartrack.derive.checking.comparing.working_domain import WORDS
from radartrack.derive.checking.reporting.verdict import Counterexample
from radartrack.derive.evaluation.floating_point import RoughEvaluator
from radartrack.derive.evaluation.many_digits import Evaluator, Number
from radartrack.derive.evaluation.points import Point
from radartrack.derive.language.tensor import Index, Tensor
from radartrack.derive.language.variable import Variable
from radartrack.derive.symbolic import Expr

MATTERS = 0.01  # a relative difference that nobody overlooks
TELLS = 1e9  # one beyond which the derived value may only happen to vanish at a point
DOMAIN_POINTS = 40
STEP = 0.5
NEARLY_NOTHING = 0.05  # of its floor: where a scale is less, a difference is not measured against it
SAME = 1e-6  # relative differences that are one but for rounding


def find_difference(comparison: Comparison, domain: Domain) -> Values | None:
    """The plainest round point at which the formulas differ by an amount that matters, else where they differ most.

    Points of ordinary size come after the round ones, then points all over the domain. A point at which the derived
    value vanishes, as a difference does where all symbols are alike, tells less than any other.
    """
    found: list[Values] = []
    others = chain(domain.ordinary(6), domain.spread(12))
    for points in (domain.round(), others):
        for point in points:
            values = comparison.differ_at(point)
            if values is not None and (MATTERS <= values.relative <= TELLS or (points is others and not found)):
                return values
            found += [values] if values else []
        if found and all(values.relative < MATTERS for values in found):
            return max(found, key=lambda values: values.relative)
    return found[0] if found else None


@dataclass(frozen=True)
class Worst:
    """A relative difference and where it is."""

    relative: float
    point: Point


class Relative:
    """The difference of two formulas relative to a scale, ready to be evaluated.

    Args:
        printed, derived: the formulas.
        squared_scale: its square, up to its sign; where that is zero, the printed formula is the scale.
        symbols: of them all.
        squared_floor: the square of what the scale may not vanish beside, as the entry of a vector does on an axis:
            there every difference is beyond all measure, and tells nothing.
    """

    def __init__(
        self,
        printed: Expr,
        derived: Expr,
        squared_scale: Expr,
        symbols: Sequence[Variable],
        squared_floor: Expr | None = None,
    ) -> None:
        expressions = (
            printed - derived,
            printed,
            squared_scale,
            squared_scale if squared_floor is None else squared_floor,
        )
        self._names = [symbol.name for symbol in symbols]
        self._exact = Evaluator(Tensor((4,), expressions), symbols)
        self._rough = RoughEvaluator(expressions, symbols)

    def at(self, point: Point, *, anywhere: bool = False) -> Worst:
        """What it is at a point; nothing where a formula has no real value, or the scale nearly vanishes.

        Args:
            point: the values of the symbols.
            anywhere: whether the scale may vanish.
        """
        try:
            difference, printed, square, floor = self._exact([point[name] for name in self._names])
        except (ArithmeticError, ValueError):
            return Worst(0.0, point)
        if not anywhere and abs(square) < NEARLY_NOTHING**2 * abs(floor):
            return Worst(0.0, point)
        size = mpmath.sqrt(abs(square)) or abs(printed)
        compared = size and all(is_real(value) or _is_nearly_real(value) for value in (difference, printed))
        return Worst(float(abs(difference) / size) if compared else 0.0, point)

    def at_most(self, point: Point) -> float:
        """A bound on what it is, found in floating point."""
        values = self._rough([point[name] for name in self._names])
        if values is None:
            return math.inf
        (difference, error), _, (square, wrong), _ = values
        return (abs(difference) + error) / math.sqrt(abs(square) - wrong) if abs(square) > wrong else math.inf

    def at_least(self, point: Point) -> float:
        """A bound from below; nothing where floating point cannot tell."""
        values = self._rough([point[name] for name in self._names])
        if values is None:
            return 0.0
        (difference, error), _, (square, wrong), (floor, _) = values
        if abs(difference) <= 2 * error or abs(square) <= 2 * wrong or abs(square) < NEARLY_NOTHING**2 * abs(floor):
            return 0.0
        return (abs(difference) - error) / math.sqrt(abs(square) + wrong)


def worst_over_domain(relative: Relative, domain: Domain, start: Point) -> Worst:
    """The largest relative difference among points of the domain, and where steps from its corners and zeros lead."""
    here = relative.at(start, anywhere=True)
    best = _largest(here if here.relative <= TELLS else relative.at(start), domain.spread(DOMAIN_POINTS), relative)
    for symbol in domain.symbols:
        moved = [best.point | {symbol.name: value} for value in _neighbours(symbol, best.point, STEP)]
        best = _largest(best, filter(domain.contains, moved), relative)
    starts = [best.point, *domain.ordinary(DOMAIN_POINTS)]
    return _largest(best, summits(relative.at_least, domain.limited, domain.contains, starts), relative)


def _is_nearly_real(value: Number) -> bool:
    """Whether an imaginary part is rounding."""
    return bool(abs(value) < LARGEST and abs(mpmath.im(value)) <= NOISE * abs(value))


def _largest(best: Worst, points: Iterable[Point], relative: Relative) -> Worst:
    """The largest of all; only what may exceed the best by more than rounding is evaluated exactly."""
    bounds = sorted(((relative.at_most(point), point) for point in points), key=itemgetter(0), reverse=True)
    for bound, point in bounds:
        enough = best.relative * (1 + SAME)
        if bound > enough and (found := relative.at(point)).relative > enough:
            best = found
    return best


def counterexample(
    values: Values, entry: Index, worst: Worst | None, symbols: Sequence[Variable], measured_against: str = ""
) -> Counterexample:
    """The point and the worst of the domain, where it was looked for, as data."""
    return Counterexample(
        point=values.point,
        entry=entry,
        printed=float(values.printed),
        derived=float(values.derived),
        relative_difference=values.relative,
        units=_units(symbols),
        largest_relative_difference=max(worst.relative, values.relative) if worst else None,
        largest_at=worst.point if worst else {},
        measured_against=measured_against,
    )


def measured_against(beside: str) -> str:
    """What differences are measured against, and where: "the derived value where radars work"."""
    return f"the derived value {WORDS}" + (
        f" and it is at least {NEARLY_NOTHING * 100:g} % of {beside}" if beside else ""
    )


def example(values: Values | Imaginary | None, entry: Index, symbols: Sequence[Variable]) -> Counterexample | None:
    """What was found at a point, for people; nothing where nothing was."""
    match values:
        case Values():
            return counterexample(values, entry, None, symbols)
        case Imaginary():
            return unreal_counterexample(values, entry, symbols)
        case None:
            return None


def unreal_counterexample(imaginary: Imaginary, entry: Index, symbols: Sequence[Variable]) -> Counterexample:
    """A point at which what is printed is no real number as data."""
    return Counterexample(imaginary.point, entry, None, float(imaginary.derived), None, _units(symbols))


def _units(symbols: Sequence[Variable]) -> dict[str, str]:
    return {symbol.name: str(symbol.unit) for symbol in symbols}


def _neighbours(symbol: Variable, point: Point, step: float) -> list[float]:
    """The ends of the domain, and a step to either side."""
    value = point[symbol.name]
    high = min(symbol.high, point.get(symbol.at_most.name, symbol.high)) if symbol.at_most else symbol.high
    if symbol.low > 0:
        factor = (high / symbol.low) ** (step / 4)
        beside = [value / factor, value * factor]
    else:
        beside = [value - (high - symbol.low) * step / 4, value + (high - symbol.low) * step / 4]
    inside = [v for v in (symbol.low, *beside, high) if symbol.low <= v <= high]
    return [float(round(v)) for v in inside] if symbol.whole else inside
