"""The operator e^(tL), L = ½ Σ K_ij ∂_i ∂_j: the expectation over a Gaussian error of covariance tK.

E[f(θ + w)] = e^L f(θ) for w ~ N(0, K). On a monomial times e^(a·θ) it is closed form for every t, negative ones
included: the exponential is multiplied by e^(t aᵀKa/2), the monomial is shifted by tKa, and what is left of it is a
polynomial, on which the exponential series ends.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction

from radartrack.derive import symbolic as sp
from radartrack.derive.algebra.exponential_polynomial import ExponentialPolynomial, NotExponentialPolynomial
from radartrack.derive.symbolic import Expr, PolyElement, Symbol


@dataclass(frozen=True)
class GaussianOperator:
    """L for the given variables and error covariance; K is a constant under its differentiation.

    Attributes:
        variables: the measured quantities θ, n symbols.
        covariance: K, n rows of n expressions, polynomials in the deviations and correlations.
    """

    variables: tuple[Symbol, ...]
    covariance: Sequence[Sequence[Expr]]

    def generator(self, value: ExponentialPolynomial) -> ExponentialPolynomial:
        """L f."""
        parts = (
            value.differentiate(first).differentiate(second).scale(weight / 2)
            for row, first in zip(self.covariance, self.variables, strict=True)
            for weight, second in zip(row, self.variables, strict=True)
            if weight != 0
        )
        return ExponentialPolynomial.total(value.ring, parts)

    def require_closed(self, value: ExponentialPolynomial) -> None:
        """Check, without working anything out, that e^(tL) f has a closed form.

        Raises:
            NotExponentialPolynomial: when an exponent of `value` is not linear in the variables.
        """
        for exponent in value.terms:
            for variable in self.variables:
                self._slope(exponent, variable)

    def exponential(self, value: ExponentialPolynomial, time: Fraction | int = 1) -> ExponentialPolynomial:
        """e^(tL) f in closed form.

        Raises:
            NotExponentialPolynomial: when an exponent of `value` is not linear in the variables.
        """
        parts = (self._exponential_of_term(*term, Fraction(time)) for term in value.terms.items())
        return ExponentialPolynomial.total(value.ring, parts)

    def _exponential_of_term(
        self, exponent: PolyElement, coefficient: PolyElement, time: Fraction
    ) -> ExponentialPolynomial:
        ring = exponent.ring
        slopes = [self._slope(exponent, variable) for variable in self.variables]
        scale = ring(sp.QQ_I(sp.QQ(time.numerator, time.denominator), 0))
        shifts = [
            sum((ring.from_expr(weight) * slope for weight, slope in zip(row, slopes, strict=True)), ring.zero) * scale
            for row in self.covariance
        ]
        growth = sum((slope * shift for slope, shift in zip(slopes, shifts, strict=True)), ring.zero)
        polynomial = self._exponential_of_polynomial(coefficient, scale)
        substitution = [(ring(v), ring(v) + s) for v, s in zip(self.variables, shifts, strict=True) if s]
        shifted = polynomial.compose(substitution) if substitution else polynomial
        return ExponentialPolynomial(ring, {exponent + growth * sp.QQ_I(sp.QQ(1, 2), 0): shifted})

    def _slope(self, exponent: PolyElement, variable: Symbol) -> PolyElement:
        """How fast an exponent grows with a variable: a number, or a polynomial in what is no variable, as T in ωT."""
        ring = exponent.ring
        slope = exponent.diff(ring(variable))
        if any(slope.diff(ring(other)) for other in self.variables):
            raise NotExponentialPolynomial(f"the exponent {exponent.as_expr()} is not linear in {variable}")
        return slope

    def _exponential_of_polynomial(self, polynomial: PolyElement, scale: PolyElement) -> PolyElement:
        ring = polynomial.ring
        total, term, order = polynomial, polynomial, 0
        while term:
            order += 1
            value = self.generator(ExponentialPolynomial.constant(ring, term))
            term = value.terms.get(ring.zero, ring.zero) * scale * sp.QQ_I(sp.QQ(1, order), 0)
            total = total + term
        return total
