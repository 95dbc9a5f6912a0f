"""The mean square of a polynomial in correlated Gaussian errors, as a sum in which nothing cancels.

By its moments it is a sum of products of coefficients; where errors are correlated, terms of both signs meet there and
lose every digit near full correlation. Written in independent standard errors, as a sum over Hermite polynomials,
the polynomial's mean square is Σ α! c_α²: a sum of squares. Both are the same, which is proved for coefficients
that are symbols, whatever these stand for.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import product
from math import factorial, prod
from typing import TYPE_CHECKING

from radartrack.derive import symbolic as sp
from radartrack.derive.algebra.common_denominator import even_powers
from radartrack.derive.algebra.exponential_polynomial import ExponentialPolynomial, ring_over
from radartrack.derive.language.model import Model
from radartrack.derive.language.stable_form import NotProved
from radartrack.derive.moments.gaussian_operator import GaussianOperator
from radartrack.derive.symbolic import Expr, PolyElement, PolyRing, Symbol

if TYPE_CHECKING:
    from radartrack.derive.symbolic import PolyCoefficient

Errors = tuple[Symbol, ...]
Powers = tuple[int, ...]


@dataclass(frozen=True)
class Complement:
    """√(1 − ρ²) of one correlation."""

    correlation: Symbol

    @property
    def symbol(self) -> Symbol:
        """Named after the correlation."""
        return sp.Symbol(f"complement_of_{self.correlation.name}", nonnegative=True)

    @property
    def definition(self) -> Expr:
        """In a form that keeps its digits at full correlation."""
        return sp.sqrt((1 - self.correlation) * (1 + self.correlation))


class MeanSquare:
    """Mean squares over the errors of one model.

    Args:
        model: its measured quantities, deviations and correlations say how the errors are distributed.
        coefficients: every symbol that a polynomial may have as a coefficient.
    """

    def __init__(self, model: Model, coefficients: Sequence[Symbol]) -> None:
        self._model = model
        self._complements = [Complement(rho) for rho in model.correlations.values()]
        self._errors = tuple(sp.Symbol(f"error_of_{variable.name}", real=True) for variable in model.measured)
        roots = [complement.symbol for complement in self._complements]
        self._symbols = [*coefficients, *model.noise_symbols, *roots, *self._errors]
        self._ring = PolyRing(self._symbols, sp.QQ)

    @property
    def definitions(self) -> dict[Symbol, Expr]:
        """The intermediates of the results."""
        return {complement.symbol: complement.definition for complement in self._complements}

    def of(self, polynomial: Mapping[Powers, Symbol]) -> Expr:
        """E[(Σ c_n w^n)²] for w ~ N(0, K); the polynomial maps the powers n of the errors to c_n.

        Where an error has several correlations there is no square root of K without a quotient; the mean square is
        then its moments, and its absolute value, as rounding may bring it just below zero.

        Raises:
            NotProved: when the two ways to it do not agree.
        """
        moments = self._by_moments(polynomial)
        if all(value > 0 and not any(power % 2 for power in powers) for powers, value in moments.terms()):
            return moments.as_expr()
        if not self._is_paired:
            return sp.Abs(moments.as_expr())
        candidates = (list(self._squares(polynomial, leading)) for leading in product(*self._model.correlations))
        squares = min(candidates, key=lambda found: sum(len(c.terms()) for _, c in found))
        if self._without_complements(sum((c**2 * weight for weight, c in squares), self._ring.zero)) != moments:
            raise NotProved(f"the squares {squares} are not the moments {moments}")
        return sp.Add(*(sp.Rational(weight) * sp.factor(c.as_expr()) ** 2 for weight, c in squares))

    @property
    def _is_paired(self) -> bool:
        joined = [variable for pair in self._model.correlations for variable in pair]
        return len(set(joined)) == len(joined)

    def _by_moments(self, polynomial: Mapping[Powers, Symbol]) -> PolyElement:
        """By the operator: e^L of the square, at zero error."""
        ring = ring_over(self._symbols)
        value = sum((ring.from_expr(self._term(powers, c)) for powers, c in polynomial.items()), ring.zero)
        operator = GaussianOperator(self._errors, self._model.covariance)
        mean = operator.exponential(ExponentialPolynomial.constant(ring, value**2)).expression()
        return self._ring.from_expr(mean.xreplace({error: sp.Integer(0) for error in self._errors}))

    def _squares(self, polynomial: Mapping[Powers, Symbol], leading: Errors) -> Iterator[tuple[int, PolyElement]]:
        """α! and the amplitude of each product of Hermite polynomials of orders α in independent standard errors.

        One error of each correlated pair leads: it is a standard error of its own.
        """
        errors = list(map(self._ring, self._errors))
        value = sum((self._ring.from_expr(self._term(powers, c)) for powers, c in polynomial.items()), self._ring.zero)
        standardised = value.compose(list(zip(errors, self._in_standard_errors(leading), strict=True)))
        amplitudes: dict[Powers, PolyElement] = {}
        size = len(errors)
        for powers, number in standardised.terms():
            rest = self._ring.from_dict({(*powers[:-size], *[0] * size): number})
            for orders, weight in _in_hermite(powers[-size:]):
                amplitudes[orders] = amplitudes.get(orders, self._ring.zero) + rest * weight
        return ((prod(map(factorial, orders)), c) for orders, c in sorted(amplitudes.items()) if c)

    def _in_standard_errors(self, leading: Errors) -> list[PolyElement]:
        """Each error as a sum of independent standard errors, for which its own symbols stand."""
        ring, measured = self._ring, self._model.measured
        standard = {variable: ring(error) for variable, error in zip(measured, self._errors, strict=True)}
        mixed = dict(standard)
        for complement, pair in zip(self._complements, self._model.correlations, strict=True):
            (first,) = set(pair) & set(leading)
            (second,) = set(pair) - {first}
            rho, root = ring(complement.correlation), ring(complement.symbol)
            mixed[second] = rho * standard[first] + root * standard[second]
        return [ring(sigma) * mixed[v] for v, sigma in zip(measured, self._model.deviations, strict=True)]

    def _without_complements(self, value: PolyElement) -> PolyElement:
        """With every even power of a complement written in its correlation."""
        for complement in self._complements:
            value = even_powers(value, complement.symbol, 1 - self._ring(complement.correlation) ** 2)
        return value

    def _term(self, powers: Powers, coefficient: Symbol) -> Expr:
        return sp.Mul(coefficient, *(error**power for error, power in zip(self._errors, powers, strict=True)))


def _in_hermite(powers: Powers) -> Iterator[tuple[Powers, PolyCoefficient]]:
    """A product of powers as a sum over products of Hermite polynomials: their orders and the weight of each."""
    for halves in product(*(range(power // 2 + 1) for power in powers)):
        orders = tuple(n - 2 * j for n, j in zip(powers, halves, strict=True))
        shares = (2**j * factorial(j) * factorial(order) for j, order in zip(halves, orders, strict=True))
        yield orders, sp.QQ(prod(map(factorial, powers)), prod(shares))
