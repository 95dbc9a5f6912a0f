"""Balls of Arb (python-flint), which round outward, and what is known of the numbers that a processor has."""

from __future__ import annotations

import math
from fractions import Fraction
from functools import lru_cache
from typing import Any

Ball = Any
PRECISION = 160  # bits of the balls


class Refused(ValueError):
    """The certificate does not show what it claims, or a statement is none that can be followed."""


@lru_cache(maxsize=1)
def flint() -> Any:
    """python-flint, which is needed for checking alone."""
    import flint as library  # noqa: PLC0415 - an extra of the tests

    library.ctx.prec = PRECISION
    return library


def nearest(value: Fraction, bits: int) -> Fraction:
    """Rounded to so many bits, ties to even; no limit to exponents."""
    if not value:
        return value
    exponent = abs(value.numerator).bit_length() - value.denominator.bit_length()
    exponent -= abs(value) < Fraction(2) ** exponent
    step = Fraction(2) ** (exponent - bits + 1)
    return round(value / step) * step


def point(value: Fraction | float) -> Ball:
    """A number as it is, or but for the precision of balls."""
    number = Fraction(value)
    return flint().arb(flint().fmpq(number.numerator, number.denominator))


def between(low: float, high: float) -> Ball:
    """All numbers from one to another."""
    middle, radius = (Fraction(low) + Fraction(high)) / 2, (Fraction(high) - Fraction(low)) / 2
    return point(middle) + around(point(radius))


def around(radius: Ball) -> Ball:
    """All numbers of at most this size."""
    return flint().arb(0, radius.abs_upper() if hasattr(radius, "abs_upper") else abs(radius).upper())


def half_ulp(size: Ball, bits: int) -> Ball:
    """Of the largest number of this size."""
    top = float(abs(size).upper())
    exponent = math.frexp(top * (1 + 2.0**-50))[1] if top else -1000
    return point(Fraction(2) ** (exponent - bits - 1))


def ulp_at_least(size: Ball, bits: int) -> Ball:
    """Of the smallest number of this size."""
    bottom = float(abs(size).lower())
    if not bottom > 0:
        raise Refused("a result that may vanish has no last place")
    return point(Fraction(2) ** (math.frexp(bottom * (1 - 2.0**-50))[1] - bits))
