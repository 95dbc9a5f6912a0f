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

    @staticmethod
    def of_difference(first: float, second: float) -> Pair:
        """The exact difference of two numbers."""
        return _sum(np.asarray(first, np.float64), np.asarray(-second, np.float64))

    def __add__(self, other: Pair) -> Pair:  # type: ignore[override]
        total = _sum(self.high, other.high)
        return Pair(total.high, total.low + (self.low + other.low))

    def __sub__(self, other: Pair) -> Pair:
        return self + Pair(-other.high, -other.low)

    def __mul__(self, factor: RealArray | float) -> Pair:  # type: ignore[override]
        exact = product(self.high, np.asarray(factor))
        return Pair(exact.high, exact.low + self.low * factor)

    def squared(self) -> Pair:
        """The square."""
        exact = product(self.high, self.high)
        return Pair(exact.high, exact.low + 2.0 * self.high * self.low)

    def rounded(self) -> RealArray:
        """As one number."""
        return np.asarray(self.high + self.low)


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


def _sum(first: RealArray, second: RealArray) -> Pair:
    total = first + second
    back = total - first
    return Pair(total, (first - (total - back)) + (second - back))


def _halves(value: RealArray) -> tuple[RealArray, RealArray]:
    shifted = SPLITTER * value
    high = shifted - (shifted - value)
    return high, value - high
