"""Power series in the displacement from a point and in the size of the errors: differentiation without derivatives.

A map is evaluated on series instead of numbers; its Taylor coefficients come out, by arithmetic alone. Averages over
Gaussian errors follow term by term from their moments (Isserlis). Numbers have many digits.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from itertools import product
from math import comb, prod
from typing import Any

import mpmath

from radartrack.derive import symbolic as sp
from radartrack.derive.symbolic import Expr, Symbol

Number = Any
Powers = tuple[int, ...]


@dataclass(frozen=True)
class Jet:
    """A polynomial in displacements δ and the size ε of the errors, cut off at a total degree.

    Attributes:
        degree: the highest total degree kept.
        terms: powers of δ₁ … δₙ and ε → coefficient.
    """

    degree: int
    terms: Mapping[Powers, Number]

    def __add__(self, other: Jet) -> Jet:
        terms = dict(self.terms)
        for powers, value in other.terms.items():
            terms[powers] = terms.get(powers, 0) + value
        return Jet(self.degree, terms)

    def __neg__(self) -> Jet:
        return self.scaled(-1)

    def __sub__(self, other: Jet) -> Jet:
        return self + -other

    def __mul__(self, other: Jet) -> Jet:
        terms: dict[Powers, Number] = {}
        for first, value in self.terms.items():
            room = self.degree - sum(first)
            for second, factor in other.terms.items():
                if sum(second) <= room:
                    powers = tuple(map(int.__add__, first, second))
                    terms[powers] = terms.get(powers, 0) + value * factor
        return Jet(self.degree, terms)

    def scaled(self, number: Number) -> Jet:
        """Times a number."""
        return Jet(self.degree, {powers: number * value for powers, value in self.terms.items()})

    def only(self, keep: Callable[[Powers], bool]) -> Jet:
        """The terms whose powers are wanted."""
        return Jet(self.degree, {powers: value for powers, value in self.terms.items() if keep(powers)})

    def composed(self, coefficients: Sequence[Number]) -> Jet:
        """Σ cₙ (f − f₀)ⁿ for the series of a function at f₀."""
        rest = self.only(any)
        total = self._constant(coefficients[-1])
        for coefficient in reversed(coefficients[:-1]):
            total = total * rest + self._constant(coefficient)
        return total

    @property
    def value(self) -> Number:
        """Where nothing is displaced and nothing errs."""
        return sum((value for powers, value in self.terms.items() if not any(powers)), mpmath.mpf(0))

    def _constant(self, value: Number) -> Jet:
        size = len(next(iter(self.terms)))
        return Jet(self.degree, {(0,) * size: value})


def jets(expressions: Sequence[Expr], at: Mapping[Symbol, Number], of: Sequence[Symbol], degree: int) -> list[Jet]:
    """The Taylor polynomials of formulas in some of their symbols, the others held fixed."""
    zero = (0,) * (len(of) + 1)
    known: dict[Expr, Jet] = {symbol: Jet(degree, {zero: value}) for symbol, value in at.items()}
    for place, symbol in enumerate(of):
        unit = tuple(int(n == place) for n in range(len(of) + 1))
        known[symbol] = Jet(degree, {zero: at[symbol], unit: mpmath.mpf(1)})
    reader = _Reader(known, zero, degree)
    return [reader.read(expression) for expression in expressions]


class _Reader:
    def __init__(self, known: dict[Expr, Jet], zero: Powers, degree: int) -> None:
        self.known, self.zero, self.degree = known, zero, degree

    def read(self, expression: Expr) -> Jet:
        if expression not in self.known:
            self.known[expression] = self._read(expression)
        return self.known[expression]

    def _read(self, expression: Expr) -> Jet:
        if isinstance(expression, sp.Rational):
            return Jet(self.degree, {self.zero: mpmath.mpf(int(expression.p)) / int(expression.q)})
        if expression in _NUMBERS:
            return Jet(self.degree, {self.zero: +_NUMBERS[expression]})
        operands = [self.read(argument) for argument in expression.args]
        if isinstance(expression, sp.Add):
            return sum(operands[1:], operands[0])
        if isinstance(expression, sp.Mul):
            return prod(operands[1:], start=operands[0])
        if isinstance(expression, sp.Pow):
            return self._power(operands[0], operands[1].value)
        if isinstance(expression, sp.atan2):
            return self._angle(*operands)
        if isinstance(expression, sp.hypot):
            return self._power(operands[0] * operands[0] + operands[1] * operands[1], mpmath.mpf(1) / 2)
        return operands[0].composed(_SERIES[expression.func](operands[0].value, self.degree))

    def _power(self, base: Jet, exponent: Number) -> Jet:
        if exponent == int(exponent) and exponent >= 0:
            return prod([base] * int(exponent), start=Jet(self.degree, {self.zero: mpmath.mpf(1)}))
        start = base.value
        return base.composed([mpmath.binomial(exponent, n) * start ** (exponent - n) for n in range(self.degree + 1)])

    def _angle(self, y: Jet, x: Jet) -> Jet:
        """The angle at the point, and the arc tangent of how far it turns."""
        turned = (y.scaled(x.value) - x.scaled(y.value)) * self._power(
            x.scaled(x.value) + y.scaled(y.value), mpmath.mpf(-1)
        )
        arc = [mpmath.mpf((-1) ** (n // 2)) / n if n % 2 else mpmath.mpf(0) for n in range(1, self.degree + 1)]
        return turned.composed([mpmath.atan2(y.value, x.value), *arc])


def _wave(first: Callable[[Number], Number]) -> Callable[[Number, int], list[Number]]:
    def series(start: Number, degree: int) -> list[Number]:
        turn = mpmath.pi / 2
        return [first(start + n * turn) / mpmath.factorial(n) for n in range(degree + 1)]

    return series


def _by_differences(function: Callable[[Number], Number]) -> Callable[[Number, int], list[Number]]:
    """The series from differences in more digits: no rule of differentiation is used twice."""
    return lambda start, degree: [+value for value in mpmath.taylor(function, start, degree)]


_NUMBERS: dict[Expr, Number] = {sp.pi: mpmath.pi, sp.E: mpmath.e}
_SERIES: dict[type[Expr], Callable[[Number, int], list[Number]]] = {
    sp.sin: _wave(mpmath.sin),
    sp.cos: _wave(mpmath.cos),
    sp.exp: lambda start, degree: [mpmath.exp(start) / mpmath.factorial(n) for n in range(degree + 1)],
    sp.acos: _by_differences(mpmath.acos),
    sp.asin: _by_differences(mpmath.asin),
    sp.atan: _by_differences(mpmath.atan),
    sp.cosh: _by_differences(mpmath.cosh),
    sp.log: _by_differences(mpmath.log),
    sp.sinh: _by_differences(mpmath.sinh),
    sp.tan: _by_differences(mpmath.tan),
    sp.tanh: _by_differences(mpmath.tanh),
}


def averaged(jet: Jet, covariance: Sequence[Sequence[Number]]) -> Jet:
    """E[f(δ + εw)], w ~ N(0, K)."""
    terms: dict[Powers, Number] = {}
    for powers, value in jet.terms.items():
        *places, size = powers
        for taken in product(*(range(power + 1) for power in places)):
            moment = gaussian_moment(taken, covariance)
            if moment:
                ways = prod(comb(power, n) for power, n in zip(places, taken, strict=True))
                left = (*(p - n for p, n in zip(places, taken, strict=True)), size + sum(taken))
                terms[left] = terms.get(left, 0) + value * ways * moment
    return Jet(jet.degree, terms)


def gaussian_moment(powers: Powers, covariance: Sequence[Sequence[Number]]) -> Number:
    """E[w₁^p₁ … wₙ^pₙ]: one factor is paired with each of the others in turn (Isserlis 1918)."""
    if not any(powers):
        return mpmath.mpf(1)
    if sum(powers) % 2:
        return 0
    first = next(place for place, power in enumerate(powers) if power)
    rest = _less(powers, first)
    return sum(
        covariance[first][place] * power * gaussian_moment(_less(rest, place), covariance)
        for place, power in enumerate(rest)
        if power
    )


def _less(powers: Powers, place: int) -> Powers:
    return tuple(power - (n == place) for n, power in enumerate(powers))
