"""What each operation of a generated function does to the errors of its operands, over many boxes at once.

Errors are counted in u = 2⁻⁵³. A value carries two bounds of its error, one relative to the exact value and one
absolute, and whichever is smaller counts: products keep the first small, differences only the second.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
import numpy.typing as npt

from radartrack.verification.rounding.enclosures import (
    CERTAIN,
    SLACK,
    Array,
    Enclosure,
    curve,
    either,
    remainder,
    total,
)

U = 2.0**-53
ULPS = {
    "arctan2": 1.0,
    "cos": 1.0,
    "exp": 1.0,
    "expm1": 1.0,
    "hypot": 1.0,
    "sin": 1.0,
    "square": 1.0,
}
"""Assumed: largest error of each elementary function, in units of the last place of the exact value.

A square is a product where NumPy computes arrays, and a power of the C library for single numbers.
"""
FLOOR, CEILING = -1000 * float(np.log(2.0)), 1000 * float(np.log(2.0))  # of logarithms: beyond may be no normal number
SPACING = 53 * float(np.log(2.0))

Signs = npt.NDArray[np.int8]


class NotAnalysed(ValueError):
    """A statement holds what the rules say nothing of."""


@dataclass(frozen=True)
class Value:
    """One intermediate result.

    Attributes:
        size: of its exact value, without sign.
        sign: 1 or −1 where it is known, else 0; shape (boxes,).
        relative: bound of the error by the exact value, in u; infinite where there is none.
        error: bound of the error, in u; only its upper side means something. None where the value is exact.
        terms: sum of the sizes of the terms that it is made of.
        tiny: logarithm that a computed value is not below, unless it is zero.
    """

    size: Enclosure
    sign: Signs
    relative: Array
    error: Enclosure | None
    terms: Enclosure
    tiny: Array

    @cached_property
    def is_exact(self) -> bool:
        """Whether the computed value is the exact one."""
        return self.error is None


def settled(
    size: Enclosure, sign: Signs, relative: Array, error: Enclosure | None, terms: Enclosure, tiny: Array
) -> Value:
    """A value with both bounds of its error as small as either makes them; out of range, there is no bound."""
    legal = (tiny >= FLOOR) & (size.high <= CEILING)
    relative = np.where(legal, relative, np.inf)
    by_relative = size.times(relative)
    if error is None:
        return Value(size, sign, relative, by_relative, terms, tiny)
    error = error.times(np.where(legal, 1.0, np.inf))
    with np.errstate(over="ignore", invalid="ignore"):
        quotient = np.exp((error / size).high)
    relative = np.fmin(relative, np.where(np.isnan(quotient), np.inf, quotient))
    smaller = by_relative.middle + by_relative.above < error.middle + error.above
    return Value(size, sign, relative, either(smaller, by_relative, error), terms, tiny)


def exact(size: Enclosure, sign: Signs) -> Value:
    """An argument or a number, as it is given."""
    return Value(size, sign, np.zeros_like(size.middle), None, size, size.low)


def inexact(value: Value | None) -> Value | None:
    """A number that is rounded as it is written down."""
    return value and settled(value.size, value.sign, value.relative + 1.0, None, value.size, value.tiny)


def _rounded(relative: Array, roundings: float) -> Array:
    """A relative error after one more operation."""
    return np.asarray((relative + roundings + U * relative * roundings) * (1 + SLACK))


def _joint(first: Array, second: Array) -> Array:
    return np.asarray(first + second + U * first * second)


def product(first: Value, second: Value, roundings: float = 1.0) -> Value:
    """first · second."""
    size, sign = first.size * second.size, (first.sign * second.sign).astype(np.int8)
    relative = _rounded(_joint(first.relative, second.relative), roundings)
    error = None
    if not np.isfinite(relative).all():
        parts = []
        if first.error is not None:
            parts.append(second.size * first.error)
        if second.error is not None:
            parts.append(first.size * second.error)
        if first.error is not None and second.error is not None:
            parts.append((first.error * second.error).times(U))
        error = total([total(parts).times(1 + U * roundings), *([size.times(roundings)] if roundings else [])])
    tiny = first.tiny + second.tiny
    return settled(size, sign, relative, error, first.terms * second.terms, tiny)


def square(value: Value) -> Value:
    """value², which has no sign."""
    same = product(value, value, 2 * ULPS["square"])
    return replace(same, sign=np.ones_like(same.sign))


def scaled(value: Value, factor: float) -> Value:
    """A value times a number that is plus or minus a power of two, which rounds nothing."""
    size, sign = value.size.times(abs(factor)), (value.sign * np.sign(factor)).astype(np.int8)
    error = None if value.error is None else value.error.times(abs(factor))
    shift = float(np.log(abs(factor)))
    return Value(size, sign, value.relative, error, value.terms.times(abs(factor)), value.tiny + shift)


def quotient(above: Value, below: Value) -> Value:
    """above / below, where the divisor is known well enough."""
    with np.errstate(divide="ignore", invalid="ignore"):
        shrunk = 1 - U * below.relative
        worse = np.where(shrunk > 0.5, below.relative / shrunk, np.inf)
    size, sign = above.size / below.size, (above.sign * below.sign).astype(np.int8)
    relative = _rounded(_joint(above.relative, worse), 1.0)
    error = None
    if not np.isfinite(relative).all() and above.error is not None:
        safe = np.where(np.isfinite(worse), worse, 1.0)
        own = (above.error / below.size).times((1 + U) * (1 + U * safe))
        error = total([own, size.times(1 + (1 + U) * safe)]).times(np.where(np.isfinite(worse), 1.0, np.inf))
    tiny = above.tiny - np.where(np.isfinite(below.size.high), below.size.high, np.inf) - 1e-6
    return settled(size, sign, relative, error, above.terms / below.size, tiny)


def root(value: Value) -> Value:
    """√value."""
    if not (value.sign > 0).all():
        raise NotAnalysed("the root of what may be negative")
    with np.errstate(divide="ignore", invalid="ignore"):
        part = U * value.relative
        half = np.where(part < 0.5, value.relative / (1 + np.sqrt(1 - np.minimum(part, 0.5))), np.inf)
    size = value.size.power(0.5)
    return settled(size, value.sign, _rounded(half, 1.0), None, value.terms.power(0.5), value.tiny / 2 - 1e-6)


def sum_of(first: Value, second: Value) -> Value:
    """first + second."""
    together = first.sign * second.sign
    errors = [value.error for value in (first, second) if value.error is not None]
    own = total(errors).times(1 + U) if errors else None
    terms = total([first.terms, second.terms])
    if (together > 0).all():
        size = total([first.size, second.size])
        shared = np.maximum(first.relative, second.relative)
        if own is not None:
            with np.errstate(over="ignore", invalid="ignore"):
                weighed = np.exp((own / size).high)
            shared = np.fmin(shared, weighed)
        tiny = np.maximum(first.tiny, second.tiny) - 1e-6
        return settled(size, first.sign, _rounded(shared, 1.0), None, terms, tiny)
    larger = first.size.middle >= second.size.middle
    major, minor = either(larger, first.size, second.size), either(larger, second.size, first.size)
    ratio = minor / major
    certain = (ratio.high < CERTAIN) & (together < 0)
    definite = major * remainder(ratio)
    either_way = total([first.size, second.size])
    size = either(certain, definite, either_way.without_floor())
    sign = np.where(certain, np.where(larger, first.sign, second.sign), 0).astype(np.int8)
    relative = np.full_like(size.middle, 1.0 if own is None else np.inf)
    error = None if own is None else total([own, size])
    tiny = np.minimum(first.tiny, second.tiny) - SPACING
    return settled(size, sign, relative, error, terms, tiny)


def hypotenuse(first: Value, second: Value) -> Value:
    """√(first² + second²), by the library's function; the errors of both are a vector that is not longer than theirs."""
    size = total([first.size.power(2.0), second.size.power(2.0)]).power(0.5)
    relative = _rounded(np.maximum(first.relative, second.relative), 2 * ULPS["hypot"])
    sign = np.ones_like(first.sign)
    return settled(size, sign, relative, None, size, np.maximum(first.tiny, second.tiny) - 1e-6)


def magnitude(value: Value) -> Value:
    """|value|."""
    return Value(value.size, np.ones_like(value.sign), value.relative, value.error, value.size, value.tiny)


def direction(y: Value, x: Value) -> Value:
    """The angle of (x, y): half the sine of twice the angle, which is below the angle, is its condition."""
    pi = np.full_like(y.size.middle, np.log(np.pi) + SLACK)
    size = Enclosure(pi, np.zeros_like(y.size.slopes), np.full_like(pi, np.inf), np.zeros_like(pi), -np.inf + pi, pi)
    both = _joint(x.relative, y.relative) * (1 + 1e-9)
    tiny = y.tiny - np.maximum(x.size.high, y.size.high) - 1.0
    return settled(size, np.zeros_like(y.sign), _rounded(both, 2 * ULPS["arctan2"]), None, size, tiny)


def exponential(value: Value) -> Value:
    """e^value, of an argument whose sign is known."""
    negative = (value.sign < 0).all()
    if not negative and not (value.sign > 0).all():
        raise NotAnalysed("the exponential of what may have either sign")
    size = curve(value.size, (lambda l: -np.exp(l)) if negative else np.exp, (lambda l: -np.exp(l)) if negative else np.exp, concave=negative)
    return settled(size, np.ones_like(value.sign), _rounded(_change(value), 2 * ULPS["exp"]), None, size, size.low - 1e-6)


def _change(value: Value) -> Array:
    """By how much e^value changes, relative, with the error of its argument, in u."""
    if value.error is None:
        return np.zeros_like(value.relative)
    with np.errstate(over="ignore"):
        off = np.exp(np.minimum(value.error.high, 700.0))
    return np.where(off * U < 0.01, off * (1 + off * U), np.inf)


def exponential_less_one(value: Value) -> Value:
    """e^value − 1, of an argument whose sign is known; its condition is below 1 on the left, x/(1 − e^−x) right."""
    negative = (value.sign < 0).all()
    if not negative and not (value.sign > 0).all():
        raise NotAnalysed("expm1 of what may have either sign")

    def logarithm(l: Array) -> Array:
        return np.log(-np.expm1(-np.exp(l))) if negative else np.log(np.expm1(np.exp(l)))

    def slope(l: Array) -> Array:
        x = np.exp(l)
        return x / np.expm1(x) if negative else -x / np.expm1(-x)

    size = curve(value.size, logarithm, slope, concave=negative)
    part = np.minimum(U * value.relative, 0.5)
    condition = np.ones_like(part) if negative else slope(value.size.high + 1e-6)
    moved = np.where(U * value.relative < 1e-3, value.relative * condition / (1 - part) * (1 + 1e-3), np.inf)
    moved = np.where(value.relative * U < 1e-9, value.relative * condition * (1 + 1e-8), moved)
    return settled(size, value.sign, _rounded(moved, 2 * ULPS["expm1"]), None, size, size.low - 1e-6)
