"""Sums of two floating-point numbers that stand for one of twice the digits (Dekker 1971), as arrays."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from radartrack._arrays.validation import RealArray

SPLITTER = 2.0**27 + 1.0  # halves the 53 bits of a float64


class Pair(NamedTuple):
    """A number and what its rounding left."""

    high: RealArray
    low: RealArray

    def __add__(self, other: Pair | RealArray | float) -> Pair:  # type: ignore[override]
        high, low = other if isinstance(other, Pair) else (np.asarray(other), 0.0)
        total = sum_of(self.high, high)
        return Pair(total.high, total.low + (self.low + low))

    def __sub__(self, other: Pair) -> Pair:
        return self + Pair(-other.high, -other.low)

    def __mul__(self, factor: Pair | RealArray | float) -> Pair:  # type: ignore[override]
        high, low = factor if isinstance(factor, Pair) else (np.asarray(factor), 0.0)
        exact = product(self.high, high)
        return Pair(exact.high, exact.low + (self.low * high + self.high * low))

    def squared(self) -> Pair:
        """The square."""
        return self * self

    def rounded(self) -> RealArray:
        """As one number."""
        return np.asarray(self.high + self.low)


def sum_of(first: RealArray, second: RealArray) -> Pair:
    """The exact sum of numbers."""
    total = first + second
    back = total - first
    return Pair(total, (first - (total - back)) + (second - back))


def product(first: RealArray, second: RealArray) -> Pair:
    """The exact product of numbers whose square does not overflow; what would underflow is lost."""
    high = first * second
    (a, b), (c, d) = _halves(first), _halves(second)
    return Pair(high, ((a * c - high) + a * d + b * c) + b * d)


def square_root(square: Pair) -> Pair:
    """The root of what is not negative."""
    high = np.sqrt(np.maximum(square.high, 0.0))
    exact = product(high, high)
    left = (square.high - exact.high) - exact.low + square.low
    return Pair(high, np.divide(left, 2.0 * high, out=np.zeros_like(high), where=high > 0))


def _halves(value: RealArray) -> tuple[RealArray, RealArray]:
    shifted = SPLITTER * value
    high = shifted - (shifted - value)
    return high, value - high
