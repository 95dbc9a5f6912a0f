"""Tells by numbers of many digits whether two formulas differ, and where."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import mpmath

from radartrack.derive.evaluation.many_digits import Evaluator, Number
from radartrack.derive.evaluation.points import Point
from radartrack.derive.language.tensor import Tensor
from radartrack.derive.symbolic import Expr, Symbol

MORE_DIGITS = 150
NOISE = 1e-50
LARGEST = 1e300


@dataclass(frozen=True)
class Values:
    """What is printed and what was derived at one point."""

    point: Point
    printed: Number
    derived: Number

    @property
    def difference(self) -> Number:
        """Printed less derived."""
        return self.printed - self.derived

    @property
    def relative(self) -> float:
        """The difference by the derived value; by the printed one where that is zero."""
        scale = abs(self.derived) or abs(self.printed)
        return float(abs(self.difference) / scale) if scale else 0.0


@dataclass(frozen=True)
class Imaginary:
    """What was derived at a point where what is printed is no real number."""

    point: Point
    derived: Number


class Comparison:
    """Two formulas in the same symbols, ready to be evaluated."""

    def __init__(self, printed: Expr, derived: Expr, symbols: Sequence[Symbol]) -> None:
        self._names = [symbol.name for symbol in symbols]
        self._evaluator = Evaluator(Tensor((2,), (printed, derived)), symbols)

    def at(self, point: Point) -> Values | None:
        """Both values; None where one of them is not a finite real number."""
        return self._values(point)

    def imaginary_at(self, point: Point) -> Imaginary | None:
        """What was derived, where that is a real number and what is printed is none."""
        pair, fine = (self._evaluated(point, more) for more in (0, MORE_DIGITS))
        if pair is None or fine is None or not is_real(pair[1]):
            return None
        rough, exact = (abs(mpmath.im(printed)) for printed, _ in (pair, fine))
        return Imaginary(point, pair[1]) if exact > NOISE * abs(fine[0]) and exact > rough / 2 else None

    def differ_at(self, point: Point) -> Values | None:
        """Both values when they differ beyond the rounding of many digits, else None.

        What is left of two equal formulas is rounding, which shrinks when more digits are carried.
        """
        values = self.at(point)
        if values is None or values.relative <= NOISE:
            return None
        fine = self._values(point, MORE_DIGITS)
        if fine is None or abs(fine.difference) < abs(values.difference) / 2:
            return None
        return fine

    def _values(self, point: Point, more_digits: int = 0) -> Values | None:
        pair = self._evaluated(point, more_digits)
        return Values(point, *pair) if pair is not None and all(map(is_real, pair)) else None

    def _evaluated(self, point: Point, more_digits: int) -> tuple[Number, Number] | None:
        try:
            printed, derived = self._evaluator([point[name] for name in self._names], more_digits)
        except (ArithmeticError, ValueError):
            return None
        return printed, derived


def is_real(value: Number) -> bool:
    """Whether it is a real number of any size that a float may have."""
    return not isinstance(value, mpmath.mpc) and bool(abs(value) < LARGEST)
