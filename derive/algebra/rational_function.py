"""Proves that two rational functions are equal, without ever looking for a common divisor.

Denominators stay products of the factors that they are written with; sums are taken over the factors that
differ. Then the difference is zero where one polynomial is zero, however many symbols there are.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable
from dataclasses import dataclass
from functools import reduce

from radartrack.derive import symbolic as sp
from radartrack.derive.symbolic import Expr, PolyElement, PolyRing, Symbol


class NotRational(ValueError):
    """An expression is no rational function of its symbols over the rational numbers."""


def is_zero(expression: Expr) -> bool:
    """Whether a rational function vanishes identically.

    Raises:
        NotRational: it is none, or a denominator vanishes identically.
    """
    symbols = sorted(expression.free_symbols, key=str)
    if not symbols:
        return expression == sp.Integer(0)
    return not _Reader(symbols).read(expression).numerator


@dataclass(frozen=True)
class _Fraction:
    """A numerator over a product of polynomials, each to a power."""

    numerator: PolyElement
    factors: Counter[PolyElement]


class _Reader:
    def __init__(self, symbols: Iterable[Symbol]) -> None:
        self._ring = PolyRing(list(symbols), sp.QQ)
        self._generators = dict(zip(self._ring.symbols, self._ring.gens, strict=True))
        self._known: dict[Expr, _Fraction] = {}

    def read(self, expression: Expr) -> _Fraction:
        if expression not in self._known:
            self._known[expression] = self._read(expression)
        return self._known[expression]

    def _read(self, expression: Expr) -> _Fraction:
        if isinstance(expression, sp.Rational):
            return self._whole(self._ring(sp.QQ(int(expression.p), int(expression.q))))
        if isinstance(expression, sp.Symbol):
            return self._whole(self._generators[expression])
        if isinstance(expression, sp.Add):
            return reduce(self._sum, map(self.read, expression.args))
        if isinstance(expression, sp.Mul):
            return reduce(_product, map(self.read, expression.args))
        if isinstance(expression, sp.Pow) and isinstance(expression.exp, sp.Integer):
            base, exponent = self.read(expression.base), int(expression.exp)
            return reduce(_product, [base if exponent > 0 else self._inverse(base)] * abs(exponent))
        raise NotRational(f"{expression} is no rational function")

    def _whole(self, numerator: PolyElement) -> _Fraction:
        return _Fraction(numerator, Counter())

    def _sum(self, first: _Fraction, second: _Fraction) -> _Fraction:
        common = first.factors | second.factors
        scaled = (self._over(fraction, common) for fraction in (first, second))
        return _Fraction(sum(scaled, start=self._ring.zero), common)

    def _over(self, fraction: _Fraction, common: Counter[PolyElement]) -> PolyElement:
        missing = (common - fraction.factors).elements()
        return reduce(lambda numerator, factor: numerator * factor, missing, fraction.numerator)

    def _inverse(self, fraction: _Fraction) -> _Fraction:
        if not fraction.numerator:
            raise NotRational("a denominator vanishes identically")
        return _Fraction(
            self._over(_Fraction(self._ring.one, Counter()), fraction.factors), Counter([fraction.numerator])
        )


def _product(first: _Fraction, second: _Fraction) -> _Fraction:
    return _Fraction(first.numerator * second.numerator, first.factors + second.factors)
