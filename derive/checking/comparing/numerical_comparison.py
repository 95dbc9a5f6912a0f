"""Tells by numbers of many digits whether two formulas differ, and where."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from enum import Enum, auto
from functools import cached_property

import mpmath

from radartrack.derive.evaluation.many_digits import Evaluator, NotComputed, Number
from radartrack.derive.evaluation.points import Point
from radartrack.derive.language.tensor import Tensor
from radartrack.derive.symbolic import Expr, Symbol

MORE_DIGITS = (150, 450)  # the second where the first leave it open
NOISE = 1e-50
STABLE = 1e-6  # what more digits may change in a value that is one
LARGEST = 1e300


class Here(Enum):
    """What is found at a point where no difference is."""

    AGREE = auto()
    OUTSIDE = auto()  # what was derived has no real value
    UNKNOWN = auto()  # what was derived has one, and one of the two could not be computed


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
    """Two formulas in the same symbols, ready to be evaluated; atan2(0, 0), which languages call zero, is no value."""

    def __init__(self, printed: Expr, derived: Expr, symbols: Sequence[Symbol]) -> None:
        self.printed = printed
        self._symbols = symbols
        self._derived = derived
        self._evaluator = Evaluator(Tensor((2,), (printed, derived)), symbols, strict=True)

    def at(self, point: Point, *, thorough: bool = False) -> Values | Imaginary | Here:
        """What is found at a point: both values when they differ beyond the rounding of many digits.

        What is left of two equal formulas is rounding, which shrinks when more digits are carried; so does what
        rounding leaves of the imaginary part of a real number. A value that more digits change is none, nor is one
        that other last digits of what it is made of change.

        Args:
            point: the values of the symbols.
            thorough: whether more digits are carried even where the values agree.
        """
        rough = self._evaluated(point)
        if isinstance(rough, Here):
            return rough
        values = Values(point, *rough)
        if all(map(is_real, rough)) and values.relative <= NOISE and not thorough:
            return Here.AGREE
        for more_digits in MORE_DIGITS:
            fine = self._evaluated(point, more_digits, noise=1)
            if isinstance(fine, Here):
                return fine
            found = _found(point, rough, fine)
            if isinstance(found, Here) and found is not Here.UNKNOWN:
                return found
            other = self._evaluated(point, more_digits, noise=-1)
            if found is not Here.UNKNOWN and not isinstance(other, Here):
                confirmed = _found(point, fine, other)
                if isinstance(confirmed, type(found)):
                    return confirmed
            rough = fine
        return Here.UNKNOWN

    def differ_at(self, point: Point) -> Values | None:
        """Both values where they are real and differ, else None."""
        found = self.at(point)
        return found if isinstance(found, Values) else None

    def agree_at(self, points: Iterable[Point]) -> bool:
        """Whether the formulas agree at all of these points that are no points outside."""
        agree = False
        for point in points:
            found = self.at(point)
            if found is not Here.AGREE and found is not Here.OUTSIDE:
                return False
            agree = agree or found is Here.AGREE
        return agree

    def _evaluated(self, point: Point, more_digits: int = 0, *, noise: int = 0) -> tuple[Number, Number] | Here:
        try:
            values = [point[symbol.name] for symbol in self._symbols]
            printed, derived = self._evaluator(values, more_digits, noise=noise)
        except (ArithmeticError, ValueError):
            return Here.UNKNOWN if self._is_defined(point) else Here.OUTSIDE
        return printed, derived

    def _is_defined(self, point: Point) -> bool:
        """Whether what was derived has a real value, as far as can be told."""
        try:
            (derived,) = self._derived_alone([point[symbol.name] for symbol in self._symbols])
        except (NotComputed, OverflowError):
            return True
        except (ArithmeticError, ValueError):
            return False
        return is_real(derived)

    @cached_property
    def _derived_alone(self) -> Evaluator:
        return Evaluator(Tensor((1,), (self._derived,)), self._symbols, strict=True)


def _found(point: Point, rough: tuple[Number, Number], fine: tuple[Number, Number]) -> Values | Imaginary | Here:
    """What the values at two precisions say."""
    printed, derived = map(_real_part, rough, fine)
    if derived is None:
        return Here.OUTSIDE
    if printed is None:
        return Imaginary(point, derived) if _is_stable(mpmath.im(rough[0]), mpmath.im(fine[0])) else Here.UNKNOWN
    if not (is_real(printed) and is_real(derived)):
        return Here.UNKNOWN
    values = Values(point, printed, derived)
    before, after = mpmath.re(rough[0]) - mpmath.re(rough[1]), values.difference
    if values.relative <= NOISE or abs(after) < abs(before) / 2:
        return Here.AGREE
    return values if _is_stable(before, after) else Here.UNKNOWN


def _is_stable(before: Number, after: Number) -> bool:
    """Whether more digits leave a value as it is."""
    return bool(abs(after - before) <= STABLE * abs(after))


def _real_part(rough: Number, fine: Number) -> Number | None:
    """A number without the imaginary part that rounding leaves; None where it has another."""
    imaginary = abs(mpmath.im(fine))
    if not imaginary:
        return mpmath.re(fine)
    is_rounding = imaginary <= NOISE * abs(fine) or imaginary < abs(mpmath.im(rough)) / 2
    return mpmath.re(fine) if is_rounding else None


def is_real(value: Number) -> bool:
    """Whether it is a real number of any size that a float may have."""
    return not isinstance(value, mpmath.mpc) and bool(abs(value) < LARGEST)
