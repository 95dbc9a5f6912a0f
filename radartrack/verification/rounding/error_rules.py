"""What each operation of a generated function does to the errors of its operands, over many boxes at once.

Errors are counted in u = 2⁻⁵³. A value carries two bounds of its error, one relative to the exact value and one
absolute, and whichever is smaller counts: products keep the first small, differences only the second.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from itertools import count
from itertools import product as product_of

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
MOST_PARTS = 200
_serial = count()


@dataclass(frozen=True, eq=False)
class Atom:
    """A size that is not taken apart: an argument, a sine, a sum; `serial` is the order of their making."""

    size: Enclosure
    serial: int = field(default_factory=lambda: next(_serial))


Key = tuple[tuple[Atom, float], ...]
Parts = Mapping[Key, Array]  # powers of atoms → the logarithm of their coefficient


def whole(size: Enclosure) -> Parts:
    """A size as one atom."""
    return {((Atom(size), 1.0),): np.zeros_like(size.middle)}


def merged(*several: Parts) -> Parts:
    """The sum."""
    found: dict[Key, Array] = {}
    for parts in several:
        for key, part in parts.items():
            found[key] = np.logaddexp(found[key], part) + SLACK if key in found else part
    return found


def multiplied(first: Parts, second: Parts) -> Parts:
    """The product, multiplied out."""
    found: dict[Key, Array] = {}
    for (one, part), (other, factor) in product_of(first.items(), second.items()):
        powers = dict(one)
        for name, exponent in other:
            powers[name] = powers.get(name, 0.0) + exponent
        key = _key(powers)
        found[key] = np.logaddexp(found[key], part + factor) + SLACK if key in found else part + factor
    if len(found) > MOST_PARTS:
        raise NotAnalysed(f"more than {MOST_PARTS} terms multiplied out")
    return found


def _key(powers: Mapping[Atom, float]) -> Key:
    return tuple(sorted(((one, exponent) for one, exponent in powers.items() if exponent), key=lambda p: p[0].serial))


def raised(parts: Parts, exponent: float, size: Enclosure) -> Parts:
    """A power of one part; of more, it is taken as a whole."""
    if len(parts) != 1:
        parts = whole(size)
    ((key, part),) = parts.items()
    return {tuple((one, power * exponent) for one, power in key): part * exponent}


def times(parts: Parts, factor: Array | float) -> Parts:
    """The parts times a positive number, one a box."""
    with np.errstate(divide="ignore"):
        shift = np.log(factor)
    return {key: part + shift for key, part in parts.items()}


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
        parts: the same multiplied out: products of powers, the first of which are arguments, by what they are of.
        errors: of the error, likewise; None where that is the relative error times the parts.
        makeup: parts that the value is the sum of, all of one sign; None where there are none.
        tiny: logarithm that a computed value is not below, unless it is zero.
    """

    size: Enclosure
    sign: Signs
    relative: Array
    error: Enclosure | None
    terms: Enclosure
    tiny: Array
    parts: Parts
    errors: Parts | None = None
    makeup: Parts | None = None

    @cached_property
    def error_parts(self) -> Parts:
        """The error multiplied out."""
        if self.error is None:
            return {}
        if self.errors is not None:
            return self.errors
        return times(self.parts, self.relative)

    @cached_property
    def is_exact(self) -> bool:
        """Whether the computed value is the exact one."""
        return self.error is None


def settled(
    size: Enclosure,
    sign: Signs,
    relative: Array,
    error: Enclosure | None,
    terms: Enclosure,
    tiny: Array,
    parts: Parts | None = None,
    errors: Parts | None = None,
    makeup: Parts | None = None,
) -> Value:
    """A value with both bounds of its error as small as either makes them; out of range, there is no bound."""
    legal = (tiny >= FLOOR) & (size.high <= CEILING)
    relative = np.where(legal, relative, np.inf)
    if parts is None:
        parts = makeup = whole(size)
    if error is None:
        return Value(size, sign, relative, size.times(relative), terms, tiny, parts, None, makeup)
    error = error.times(np.where(legal, 1.0, np.inf))
    with np.errstate(over="ignore", invalid="ignore"):
        quotient = np.exp((error / size).high)
    relative = np.fmin(relative, np.where(np.isnan(quotient), np.inf, quotient))
    by_relative = size.times(relative)
    smaller = by_relative.middle + by_relative.above < error.middle + error.above
    error = either(smaller, by_relative, error)
    errors = {} if errors is None or not legal.all() else errors
    return Value(size, sign, relative, error, terms, tiny, parts, errors or None, makeup)


def exact(size: Enclosure, sign: Signs, *, number: bool = False) -> Value:
    """An argument or a number, as it is given."""
    parts: Parts = {(): size.middle + size.above} if number else whole(size)
    return Value(size, sign, np.zeros_like(size.middle), None, size, size.low, parts, None, parts)


def inexact(value: Value | None) -> Value | None:
    """A number that is rounded as it is written down."""
    if value is None:
        return None
    relative, parts = value.relative + 1.0, value.parts
    return settled(value.size, value.sign, relative, None, value.size, value.tiny, parts, None, value.makeup)


def _rounded(relative: Array, roundings: float) -> Array:
    """A relative error after one more operation."""
    return np.asarray((relative + roundings + U * relative * roundings) * (1 + SLACK))


def _joint(first: Array, second: Array) -> Array:
    return np.asarray(first + second + U * first * second)


def product(first: Value, second: Value, roundings: float = 1.0) -> Value:
    """first · second."""
    size, sign = first.size * second.size, (first.sign * second.sign).astype(np.int8)
    relative = _rounded(_joint(first.relative, second.relative), roundings)
    error = errors = None
    product_parts = multiplied(first.parts, second.parts)
    if not np.isfinite(relative).all() or first.errors is not None or second.errors is not None:
        parts = []
        if first.error is not None:
            parts.append(second.size * first.error)
        if second.error is not None:
            parts.append(first.size * second.error)
        if first.error is not None and second.error is not None:
            parts.append((first.error * second.error).times(U))
        error = total([total(parts).times(1 + U * roundings), size.times(roundings)])
        both = multiplied(first.error_parts, second.error_parts)
        errors = merged(
            times(multiplied(first.parts, second.error_parts), 1 + U * roundings),
            times(multiplied(first.error_parts, second.parts), 1 + U * roundings),
            times(both, U * (1 + U * roundings)),
            times(product_parts, roundings),
        )
    tiny = first.tiny + second.tiny
    terms = first.terms * second.terms
    makeup = _both(first.makeup, second.makeup, multiplied)
    return settled(size, sign, relative, error, terms, tiny, product_parts, errors, makeup)


def _both(first: Parts | None, second: Parts | None, joined: Callable[[Parts, Parts], Parts]) -> Parts | None:
    return None if first is None or second is None else joined(first, second)


def square(value: Value) -> Value:
    """value², which has no sign."""
    same = product(value, value, 2 * ULPS["square"])
    return replace(same, sign=np.ones_like(same.sign))


def scaled(value: Value, factor: float) -> Value:
    """A value times a number that is plus or minus a power of two, which rounds nothing."""
    size, sign = value.size.times(abs(factor)), (value.sign * np.sign(factor)).astype(np.int8)
    error = None if value.error is None else value.error.times(abs(factor))
    shift = float(np.log(abs(factor)))
    terms, parts = value.terms.times(abs(factor)), times(value.parts, abs(factor))
    errors, makeup = (kept and times(kept, abs(factor)) for kept in (value.errors, value.makeup))
    return Value(size, sign, value.relative, error, terms, value.tiny + shift, parts, errors, makeup)


def quotient(above: Value, below: Value) -> Value:
    """above / below, where the divisor is known well enough."""
    with np.errstate(divide="ignore", invalid="ignore"):
        shrunk = 1 - U * below.relative
        worse = np.where(shrunk > 0.5, below.relative / shrunk, np.inf)
    size, sign = above.size / below.size, (above.sign * below.sign).astype(np.int8)
    relative = _rounded(_joint(above.relative, worse), 1.0)
    error = errors = None
    inverse = raised(below.makeup or {}, -1.0, below.size)
    parts = multiplied(above.parts, inverse)
    if above.error is not None and (above.errors is not None or not np.isfinite(relative).all()):
        safe = np.where(np.isfinite(worse), worse, 1.0)
        own = (above.error / below.size).times((1 + U) * (1 + U * safe))
        error = total([own, size.times(1 + (1 + U) * safe)]).times(np.where(np.isfinite(worse), 1.0, np.inf))
        if np.isfinite(worse).all():
            inherited = multiplied(above.error_parts, inverse)
            errors = merged(times(inherited, (1 + U) * (1 + U * safe)), times(parts, 1 + (1 + U) * safe))
    tiny = above.tiny - np.where(np.isfinite(below.size.high), below.size.high, np.inf) - 1e-6
    makeup = above.makeup and multiplied(above.makeup, inverse)
    return settled(size, sign, relative, error, above.terms / below.size, tiny, parts, errors, makeup)


def root(value: Value) -> Value:
    """√value."""
    if not (value.sign > 0).all():
        raise NotAnalysed("the root of what may be negative")
    with np.errstate(divide="ignore", invalid="ignore"):
        part = U * value.relative
        half = np.where(part < 0.5, value.relative / (1 + np.sqrt(1 - np.minimum(part, 0.5))), np.inf)
    size = value.size.power(0.5)
    parts = raised(value.makeup or {}, 0.5, size.power(2.0))
    terms, tiny = value.terms.power(0.5), value.tiny / 2 - 1e-6
    return settled(size, value.sign, _rounded(half, 1.0), None, terms, tiny, parts, None, parts)


def sum_of(first: Value, second: Value) -> Value:
    """first + second."""
    together = first.sign * second.sign
    errors = [value.error for value in (first, second) if value.error is not None]
    own = total(errors).times(1 + U) if errors else None
    terms = total([first.terms, second.terms])
    parts = merged(first.parts, second.parts)
    if (together > 0).all():
        size = total([first.size, second.size])
        shared = np.maximum(first.relative, second.relative)
        if own is not None:
            with np.errstate(over="ignore", invalid="ignore"):
                weighed = np.exp((own / size).high)
            shared = np.fmin(shared, weighed)
        tiny = np.maximum(first.tiny, second.tiny) - 1e-6
        relative, makeup = _rounded(shared, 1.0), _both(first.makeup, second.makeup, merged)
        if own is None or (first.errors is None and second.errors is None):
            return settled(size, first.sign, relative, None, terms, tiny, parts, None, makeup)
        in_parts = merged(times(merged(first.error_parts, second.error_parts), 1 + U), parts)
        return settled(size, first.sign, relative, total([own, size]), terms, tiny, parts, in_parts, makeup)
    larger = _middle_or_most(first) >= _middle_or_most(second)
    major, minor = either(larger, first.size, second.size), either(larger, second.size, first.size)
    leading = np.where(larger, first.sign, second.sign)
    ratio = minor / major
    certain = (ratio.high < CERTAIN) & (leading != 0)
    left = remainder(ratio)
    definite = major * either(together < 0, left, _one_or_less(left, ratio))
    size = either(certain, definite, _of_either_sign(first, second))
    sign = np.where(certain, leading, 0).astype(np.int8)
    relative = np.full_like(size.middle, 1.0 if own is None else np.inf)
    tiny = np.minimum(first.tiny, second.tiny) - SPACING
    makeup = whole(size) if certain.all() else None
    if own is None:
        return settled(size, sign, relative, None, terms, tiny, parts, None, makeup)
    in_parts = merged(times(merged(first.error_parts, second.error_parts), 1 + U), parts)
    return settled(size, sign, relative, total([own, size]), terms, tiny, parts, in_parts, makeup)


def _middle_or_most(value: Value) -> Array:
    return np.where(value.sign == 0, value.size.high, value.size.middle)


def _one_or_less(left: Enclosure, ratio: Enclosure) -> Enclosure:
    """1 ± q, between 1 − q and 1 + q."""
    low, high = left.low, np.log1p(np.exp(np.minimum(ratio.high, 0.0))) + SLACK
    zero = np.zeros_like(low)
    return Enclosure(zero, np.zeros_like(left.slopes), -low, high, low, high)


def _of_either_sign(first: Value, second: Value) -> Enclosure:
    """The size of a sum whose sign is not known; of a difference it is at most that of the ends of the two."""
    size = total([first.size, second.size]).without_floor()
    ends = (first.size.low, first.size.high), (second.size.low, second.size.high)
    with np.errstate(all="ignore"):
        apart = [
            high + np.log1p(-np.exp(np.minimum(low - high, 0.0)))
            for high, low in ((ends[0][1], ends[1][0]), (ends[1][1], ends[0][0]))
        ]
    most = np.where(first.sign * second.sign < 0, np.maximum(*apart) + SLACK * (1 + np.abs(size.high)), size.most)
    return replace(size, most=np.minimum(size.most, np.where(np.isnan(most), np.inf, most) + 1e-9))


def hypotenuse(first: Value, second: Value) -> Value:
    """√(first² + second²), by the library's function; the vector changes by no more than its entries, relative."""
    size = total([first.size.power(2.0), second.size.power(2.0)]).power(0.5)
    relative = _rounded(np.maximum(first.relative, second.relative), 2 * ULPS["hypot"])
    sign = np.ones_like(first.sign)
    return settled(size, sign, relative, None, size, np.maximum(first.tiny, second.tiny) - 1e-6)


def magnitude(value: Value) -> Value:
    """|value|."""
    return replace(value, sign=np.ones_like(value.sign), terms=value.size)


def direction(y: Value, x: Value) -> Value:
    """The angle of (x, y): half the sine of twice the angle, which is below the angle, is its condition."""
    pi = np.full_like(y.size.middle, np.log(np.pi) + SLACK)
    size = Enclosure(pi, np.zeros_like(y.size.slopes), np.full_like(pi, np.inf), np.zeros_like(pi), -np.inf + pi, pi)
    both = _joint(x.relative, y.relative) * (1 + 1e-9)
    tiny = y.tiny - np.maximum(x.size.high, y.size.high) - 1.0
    return settled(size, np.zeros_like(y.sign), _rounded(both, 2 * ULPS["arctan2"]), None, size, tiny)


def exponential(value: Value) -> Value:
    """e^value, of an argument whose sign is known."""
    negative = bool((value.sign < 0).all())
    if not negative and not (value.sign > 0).all():
        raise NotAnalysed("the exponential of what may have either sign")

    def logarithm(of: Array) -> Array:
        return np.asarray(-np.exp(of) if negative else np.exp(of))

    size = curve(value.size, logarithm, logarithm, concave=negative)
    relative = _rounded(_change(value), 2 * ULPS["exp"])
    return settled(size, np.ones_like(value.sign), relative, None, size, size.low - 1e-6)


def _change(value: Value) -> Array:
    """By how much e^value changes, relative, with the error of its argument, in u."""
    if value.error is None:
        return np.zeros_like(value.relative)
    with np.errstate(over="ignore"):
        off = np.exp(np.minimum(value.error.high, 700.0))
    return np.where(off * U < 0.01, off * (1 + off * U), np.inf)


def exponential_less_one(value: Value) -> Value:
    """e^value − 1, of an argument whose sign is known; its condition is below 1 on the left, x/(1 − e^−x) right."""
    negative = bool((value.sign < 0).all())
    if not negative and not (value.sign > 0).all():
        raise NotAnalysed("expm1 of what may have either sign")

    def logarithm(of: Array) -> Array:
        return np.asarray(np.log(-np.expm1(-np.exp(of))) if negative else np.log(np.expm1(np.exp(of))))

    def slope(of: Array) -> Array:
        x = np.exp(of)
        return np.asarray(x / np.expm1(x) if negative else -x / np.expm1(-x))

    size = curve(value.size, logarithm, slope, concave=negative)
    part = np.minimum(U * value.relative, 0.5)
    condition = np.ones_like(part) if negative else slope(value.size.high + 1e-6)
    moved = np.where(U * value.relative < 1e-3, value.relative * condition / (1 - part) * (1 + 1e-3), np.inf)
    moved = np.where(value.relative * U < 1e-9, value.relative * condition * (1 + 1e-8), moved)
    return settled(size, value.sign, _rounded(moved, 2 * ULPS["expm1"]), None, size, size.low - 1e-6)
