"""The domain of a question: points at which its symbols are inside their limits, and what its conditions set too."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from itertools import chain

import mpmath

from radartrack.derive.checking.comparing.working_domain import working, works
from radartrack.derive.evaluation.many_digits import Evaluator
from radartrack.derive.evaluation.points import (
    Point,
    corner_points,
    domain_points,
    ordinary_points,
    round_points,
    scattered_points,
)
from radartrack.derive.language.tensor import Tensor
from radartrack.derive.language.variable import Variable
from radartrack.derive.symbolic import Expr, Symbol

ORDINARY, SPREAD, SCATTERED = (
    20,
    40,
    40,
)  # points that a formula without proof is compared at, beside round ones and corners
DIGITS = 30
ROUNDING = 1e-12


def everywhere(_: Point) -> bool:
    """That nothing restricts the points."""
    return True


@dataclass(frozen=True)
class Domain:
    """Where a question asks.

    Attributes:
        symbols: those that are free.
        conditions: what others are replaced by. One that is set to a number is where it was put; one that is set to
            a formula has to be inside its limits.
        works_alone: whether only points count at which a radar works.
        where: what else holds at the points that count.
    """

    symbols: Sequence[Variable]
    conditions: Mapping[Symbol, Expr] = field(default_factory=dict)
    works_alone: bool = False
    where: Callable[[Point], bool] = everywhere

    def working(self) -> Domain:
        """The part of it where radars work."""
        return Domain(working(self.symbols), self.conditions, works_alone=True, where=self.where)

    def round(self) -> Iterator[Point]:
        """Round points, the plainest first."""
        return filter(self.contains, round_points(self.limited))

    def ordinary(self, count: int) -> Iterator[Point]:
        """Points of ordinary size."""
        return filter(self.contains, ordinary_points(self.limited, count))

    def spread(self, count: int) -> Iterator[Point]:
        """Points all over the domain."""
        return filter(self.contains, domain_points(self.limited, count))

    def corners(self) -> Iterator[Point]:
        """Where symbols are largest or smallest together: a branch may end only there."""
        return filter(self.contains, corner_points(self.limited))

    def sample(self) -> list[Point]:
        """All of these, each once."""
        scattered = filter(self.contains, scattered_points(self.limited, SCATTERED))
        points = chain(self.round(), self.ordinary(ORDINARY), self.spread(SPREAD), scattered, self.corners())
        return list({tuple(point.values()): point for point in points}.values())

    def contains(self, point: Point) -> bool:
        """Whether all symbols are inside their limits at values of the free ones."""
        values = _evaluated({symbol: self.conditions[symbol] for symbol in self._moving}, self.symbols, point)
        limited = (*self.limited, *self._moving)
        if self.works_alone and values is not None and not works(self.symbols, values):
            return False
        return values is not None and all(_is_inside(symbol, values) for symbol in limited) and self.where(point)

    @cached_property
    def limited(self) -> list[Variable]:
        """The free symbols; one that never exceeds another that is set to a number never exceeds that."""
        fixed = {symbol: value for symbol, value in self.conditions.items() if not value.free_symbols}
        known = _evaluated(fixed, (), {}) or {}
        return [s.below(known[s.at_most.name]) if s.at_most and s.at_most.name in known else s for s in self.symbols]

    @cached_property
    def _moving(self) -> list[Variable]:
        """The symbols that are set to a formula in the free ones."""
        free = set[Symbol](self.symbols)
        replaced = [symbol for symbol in self.conditions if isinstance(symbol, Variable)]
        return [symbol for symbol in replaced if set() < self.conditions[symbol].free_symbols <= free]


def _evaluated(formulas: Mapping[Symbol, Expr], symbols: Sequence[Variable], point: Point) -> Point | None:
    """The point with what these symbols are worth there; None where one has no real value."""
    if not formulas:
        return point
    entries = Tensor((len(formulas),), tuple(formulas.values()))
    try:
        found = Evaluator(entries, symbols, DIGITS)([point[symbol.name] for symbol in symbols])
    except (ArithmeticError, ValueError):
        return None
    if not all(isinstance(value, mpmath.mpf) and mpmath.isfinite(value) for value in found):
        return None
    return {**point, **{symbol.name: float(value) for symbol, value in zip(formulas, found, strict=True)}}


def _is_inside(symbol: Variable, values: Point) -> bool:
    value = values[symbol.name]
    high = min(symbol.high, values.get(symbol.at_most.name, symbol.high)) if symbol.at_most else symbol.high
    low, high = symbol.low - ROUNDING * abs(symbol.low), high + ROUNDING * abs(high)
    return low <= value <= high and (not symbol.whole or abs(value - round(value)) <= ROUNDING * value)
