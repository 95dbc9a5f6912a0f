"""Sums of products of powers of sizes: what is known of errors, sizes and exact values."""

from __future__ import annotations

from itertools import product as pairs_of
from typing import Any

from radartrack.verification.rounding.checker.sums.ball_ends import Ball, Rational

Key = tuple[tuple[int, float], ...]  # atoms, by their numbers, and their exponents
Polynomial = dict[Key, Ball]  # coefficients are not negative
Signed = dict[Key, Rational]  # of any sign; atoms may be carriers of a sign
NOTHING: Polynomial = {}


def product_of(first: Key, second: Key, power: float = 1.0) -> Key:
    """The product of one by a power of the other."""
    exponents = dict(first)
    for number, exponent in second:
        exponents[number] = exponents.get(number, 0.0) + power * exponent
    return tuple(sorted((number, exponent) for number, exponent in exponents.items() if exponent))


def half(key: Key) -> Key:
    """The root."""
    return tuple((number, exponent / 2) for number, exponent in key)


def reciprocal(key: Key) -> Key:
    """One by a product of powers."""
    return tuple((number, -exponent) for number, exponent in key)


def product_with_signs(first: Key, second: Key, carriers: set[int]) -> Key:
    """The product of two, in which the square of a sign is 1."""
    found = product_of(first, second)
    if carriers:
        return tuple((n, e % 2 if n in carriers else e) for n, e in found if n not in carriers or e % 2)
    return found


def plus(*sums: Polynomial) -> Polynomial:
    """The sum."""
    found: Polynomial = {}
    for one in sums:
        for key, coefficient in one.items():
            found[key] = found[key] + coefficient if key in found else coefficient
    return found


def times(first: Polynomial, second: Polynomial) -> Polynomial:
    """The product."""
    found: Polynomial = {}
    for (i, a), (j, b) in pairs_of(first.items(), second.items()):
        key = product_of(i, j)
        found[key] = found[key] + a * b if key in found else a * b
    return found


def scaled(one: Polynomial, factor: Ball) -> Polynomial:
    """So many times a sum."""
    return {key: coefficient * factor for key, coefficient in one.items()}


def total(a: Signed, b: Signed) -> Signed:
    """The sum of two sums with signs."""
    found = dict(a)
    for key, coefficient in b.items():
        put(found, key, coefficient)
    return found


def put(sum_: Signed, key: Key, coefficient: Rational) -> None:
    """Add a term to a sum, in place."""
    found = sum_.get(key, 0) + coefficient
    if found == 0:
        sum_.pop(key, None)
    else:
        sum_[key] = found


def is_mixed(value: Signed) -> bool:
    """Whether its terms have both signs."""
    return len({c > 0 for c in value.values()}) > 1


def common_factor(value: Signed) -> Key:
    """What all terms have as a factor."""
    each = [dict(key) for key in value]
    least = ((n, min(one.get(n, 0.0) for one in each)) for n in sorted({n for one in each for n in one}))
    return tuple((n, exponent) for n, exponent in least if exponent)


def normalised(value: Signed) -> tuple[Any, int]:
    """A name of a value and of its opposite, and which of the two it is."""
    first = min(value)
    turn = 1 if value[first] > 0 else -1
    return frozenset((key, str(c * turn)) for key, c in value.items()), turn
