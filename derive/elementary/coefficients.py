"""The numbers that sine, cosine and exponential are computed with."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache

import mpmath

from radartrack.derive.elementary.minimax import BITS, Real, Sought, polynomial, rounded
from radartrack.derive.elementary.precision import Precision

WIDER = 1.0001  # than the reduced interval: the multiple that is taken off is rounded from a rounded quotient
NEAREST = 2.0**-10  # share of the interval next to zero where there is nothing left to approximate


@cache
def sine(precision: Precision) -> tuple[float, ...]:
    """Of y², for sin y = y + y³ Σ: the error counts relative to sin y, |y| ≤ π/4."""

    def series(square: Real) -> Real:
        y = mpmath.sqrt(square)
        return (mpmath.sin(y) / y - 1) / square

    def weight(square: Real) -> Real:
        y = mpmath.sqrt(square)
        return square * y / mpmath.sin(y)

    return polynomial(Sought(series, weight, _squares()), precision.powers[0], precision.bits)


@cache
def cosine(precision: Precision) -> tuple[float, ...]:
    """Of y², for cos y = 1 − y²/2 + y⁴ Σ: the error counts relative to cos y, |y| ≤ π/4."""

    def series(square: Real) -> Real:
        return (mpmath.cos(mpmath.sqrt(square)) - 1 + square / 2) / square**2

    def weight(square: Real) -> Real:
        return square**2 / mpmath.cos(mpmath.sqrt(square))

    return polynomial(Sought(series, weight, _squares()), precision.powers[1], precision.bits)


@cache
def exponential(precision: Precision) -> tuple[float, ...]:
    """Of y, for e^y = 1 + y + y²/2 + y³ Σ: the error counts relative to e^y − 1, |y| ≤ ½ ln 2."""

    def series(y: Real) -> Real:
        return (mpmath.expm1(y) - y - y**2 / 2) / y**3

    def weight(y: Real) -> Real:
        return abs(y**3 / mpmath.expm1(y))

    with mpmath.workprec(BITS):
        end = mpmath.log(2) / 2 * WIDER
    return polynomial(Sought(series, weight, (-end, end)), precision.powers[2], precision.bits)


@cache
def right_angle(precision: Precision) -> tuple[float, ...]:
    """π/2 in parts, all but the last so short that multiples of them are exact, and differences too."""
    short = precision.bits - precision.quarter_bits - 2
    return _in_parts([short] * precision.exact_parts + [precision.bits])


@cache
def pieces_of_right_angle(bits: int) -> tuple[float, ...]:
    """π/2 in three parts of so many bits."""
    return _in_parts([bits] * 3)


def _in_parts(bits: Sequence[int]) -> tuple[float, ...]:
    with mpmath.workprec(BITS):
        rest, found = mpmath.pi / 2, list[float]()
        for each in bits:
            found.append(rounded(rest, each))
            rest -= found[-1]
    return tuple(found)


@cache
def doubling(precision: Precision) -> tuple[float, float]:
    """ln 2 in two parts, multiples of the first without rounding."""
    with mpmath.workprec(BITS):
        first = rounded(mpmath.log(2), precision.bits - precision.doubling_bits)
        return first, rounded(mpmath.log(2) - first, precision.bits)


@cache
def inverses(precision: Precision) -> tuple[float, float]:
    """2/π and 1/ln 2."""
    with mpmath.workprec(BITS):
        return rounded(2 / mpmath.pi, precision.bits), rounded(1 / mpmath.log(2), precision.bits)


def _squares() -> tuple[Real, Real]:
    with mpmath.workprec(BITS):
        end = (mpmath.pi / 4 * WIDER) ** 2
        return end * NEAREST, end
