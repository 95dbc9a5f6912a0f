"""Intermediate results as the checker knows them: where they lie, and how far off they are."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

from radartrack.verification.rounding.checker.sums.ball_ends import Ball
from radartrack.verification.rounding.checker.sums.products_of_powers import Polynomial, Signed


class Refused(ValueError):
    """The certificate does not show what it claims."""


class Undefined(Refused):
    """The formula divides by zero all over the box: nothing is said of it there."""


@dataclass(frozen=True, eq=False)
class Precision:
    """A binary format, and what is assumed of the elementary functions in it.

    Attributes:
        bits: of the significand.
        normal: binary logarithm below which a number may not be normal.
        largest: binary logarithm that no number may reach.
        ulps: error of each elementary function, in units of the last place of the exact value.
    """

    bits: int
    normal: int
    largest: int
    ulps: dict[str, float]

    @property
    def underflow(self) -> float:
        """In units of rounding what a result that is too small to be normal is off by: half a distance of numbers."""
        return 2.0**self.normal


DOUBLE = Precision(53, -1021, 1023, {"sin": 1, "cos": 1, "exp": 1, "expm1": 1, "hypot": 1, "arctan2": 1, "square": 1})
SINGLE = Precision(24, -125, 127, {"sin": 4, "cos": 4, "exp": 4, "expm1": 4, "hypot": 4, "arctan2": 4, "square": 1})


@dataclass(frozen=True)
class Number:
    """What is known of an intermediate result in one box.

    Attributes:
        sign: 1, −1, or 0 where it is not known.
        low: of the logarithm of its size; minus infinity where nothing keeps it from zero.
        high: likewise.
        relative: bound of its error by itself, in units of rounding; None where there is none.
        size: a sum that the size is at most.
        exactly: a sum that the size is.
        error: a sum that the error is at most, in units of rounding.
        terms: the sum of the sizes of its terms.
        tiny: binary logarithm that a computed value is not below, unless it is zero.
        value: a sum with signs that it is.
        grid: binary logarithm of what it is a multiple of, where that is known.
    """

    sign: int
    low: Ball
    high: Ball
    relative: Ball | None
    size: Polynomial
    exactly: Polynomial
    error: Polynomial
    terms: Polynomial
    tiny: float
    value: Signed
    grid: int | None = None

    @cached_property
    def is_exact(self) -> bool:
        """Whether the computed value is the exact one."""
        return not self.error
