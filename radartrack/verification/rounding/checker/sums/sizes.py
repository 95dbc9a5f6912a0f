"""The sizes that sums are made of in one box of the domain: where the logarithm of each lies."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, field
from fractions import Fraction
from functools import cached_property
from itertools import product as pairs_of
from typing import Any

from radartrack.verification.rounding.checker.sums.ball_ends import Ball, Rational
from radartrack.verification.rounding.checker.sums.products_of_powers import (
    Key,
    Polynomial,
    Signed,
    normalised,
    product_of,
    product_with_signs,
    put,
)

MOST_VALUE = 120  # monomials of a sum that is multiplied out; beyond, it is taken as a whole


@dataclass(frozen=True)
class Curve:
    """How a size depends on an argument of a function.

    Attributes:
        argument: a product of powers that is the argument's size.
        low: of the logarithm of that.
        high: likewise.
        ends: of the function by those of the argument's size; of either sign.
    """

    argument: Key
    low: Ball
    high: Ball
    ends: Callable[[Ball, Ball], tuple[Ball, Ball]]

    def logarithms(self, low: Ball, high: Ball) -> tuple[Ball, Ball]:
        """Of its size, by those of the argument's."""
        sizes = [abs(end) for end in self.ends(low.exp(), high.exp())]
        return min(size.lower() for size in sizes).log().lower(), max(size.upper() for size in sizes).log().upper()


@dataclass
class Sizes:
    """The sizes, the signs that are not known, and how they hang together.

    Attributes:
        flint: the module.
        most_value: monomials of a sum that is multiplied out; beyond, it is taken as a whole.
        atoms: the ends of each size.
        carriers: those that stand for a sign.
        waves: sine and cosine of an angle.
        shares: those that stand for what is not known of a part of a sum.
        curves: those that are functions of an argument.
        known: what stands for a value, by its name.
    """

    flint: Any
    most_value: int = field(default=MOST_VALUE, kw_only=True)
    atoms: list[tuple[Ball, Ball]] = field(default_factory=list, init=False)
    carriers: set[int] = field(default_factory=set, init=False)
    waves: list[tuple[int, int]] = field(default_factory=list, init=False)
    shares: set[int] = field(default_factory=set, init=False)
    curves: dict[int, Curve] = field(default_factory=dict, init=False)
    known: dict[Any, Any] = field(default_factory=dict, init=False)

    def ball(self, value: float) -> Ball:
        """A number as it is."""
        return self.flint.arb(value)

    def rational(self, value: float | Fraction) -> Rational:
        """A number as it is."""
        exact = Fraction(value)
        return self.flint.fmpq(exact.numerator, exact.denominator)

    @cached_property
    def one(self) -> Ball:
        """1."""
        return self.ball(1)

    def atom(self, low: Ball, high: Ball) -> Key:
        """A size that is not taken apart."""
        self.atoms.append((low, high))
        return ((len(self.atoms) - 1, 1.0),)

    def carrier(self) -> Key:
        """A sign that is not known: its square is 1."""
        key = self.atom(self.ball(0), self.ball(0))
        self.carriers.add(key[0][0])
        return key

    def with_sign(self, key: Key, sign: int) -> Signed:
        """A value of this size; of a sign that is not known where that is 0."""
        if sign:
            return {key: self.rational(sign)}
        return {product_with_signs(key, self.carrier(), self.carriers): self.rational(1)}

    def whole(self, value: Signed, sign: int, low: Ball, high: Ball) -> tuple[Signed, Polynomial]:
        """A value as one size and a sign; the same value is the same size again."""
        name, turn = normalised(value)
        if name in self.known:
            number = self.known[name][0][0][0]
            ends = self.atoms[number]
            self.atoms[number] = (max(ends[0], low), min(ends[1], high))
        else:
            self.known[name] = self.atom(low, high), () if sign else self.carrier(), sign * turn or 1
        size, carrier, turned = self.known[name]
        if sign:
            return {size: self.rational(sign)}, {size: self.one}
        return {product_with_signs(size, carrier, self.carriers): self.rational(turned * turn)}, {size: self.one}

    def bare(self, key: Key) -> Key:
        """A product of powers without signs."""
        return tuple(part for part in key if part[0] not in self.carriers) if self.carriers else key

    def bounds(self, sum_: Polynomial) -> tuple[Ball, Ball]:
        """Of the logarithm of a sum."""
        ends = [self.monomial(key, coefficient) for key, coefficient in sum_.items()]
        low, high = (sum((end[i].exp() for end in ends), self.ball(0)) for i in (0, 1))
        return (low.log() if low.lower() > 0 else self.ball(-math.inf)).lower(), high.log().upper()

    def monomial(self, key: Key, coefficient: Ball) -> tuple[Ball, Ball]:
        """Of the logarithm of one product of powers."""
        low, high = (
            end.log() if end > 0 else self.ball(-math.inf) for end in (coefficient.lower(), coefficient.upper())
        )
        for number, exponent in key:
            ends = self.atoms[number]
            first, last = (ends[0], ends[1]) if exponent > 0 else (ends[1], ends[0])
            low, high = low + first * exponent, high + last * exponent
        return low, high

    def within(self, parts: dict[Key, tuple[Ball, Ball]]) -> Polynomial:
        """Sizes that are known within limits: what is not known is one size more, as balls are too wide to multiply."""
        found: Polynomial = {}
        for key, (low, high) in parts.items():
            if high < low * (1 + 1e-6):
                found[key] = low.union(high)
            else:
                share = self.atom(low.log().lower(), high.log().upper())
                self.shares.add(share[0][0])
                found[product_of(key, share)] = self.one
        return found

    def plain(self, value: Signed) -> Polynomial | None:
        """A sum whose terms have one sign as they stand."""
        if len({c > 0 for c in value.values()}) != 1 or any(n in self.carriers for key in value for n, _ in key):
            return None
        return {key: abs(self.flint.arb(c)) for key, c in value.items()}

    def product(self, a: Signed, b: Signed) -> Signed | None:
        """The product of two sums with signs, unless it has too many terms."""
        if len(a) * len(b) > 4 * self.most_value:
            return None
        found: Signed = {}
        for (i, x), (j, y) in pairs_of(a.items(), b.items()):
            put(found, product_with_signs(i, j, self.carriers), x * y)
        return found
