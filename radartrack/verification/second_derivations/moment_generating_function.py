"""Expectations of polynomials times waves from derivatives of the moment generating function, exact.

E[z^α e^(a·z)] = ∂^α/∂s^α exp(s·θ + sᵀKs/2) at s = a, for z ~ N(θ, K). Neither the operator e^L nor its rules for
polynomials occur; only sums, products and derivatives of polynomials do.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property

from radartrack.derive import symbolic as sp
from radartrack.derive.algebra.exponential_polynomial import ExponentialPolynomial, ring_over
from radartrack.derive.language.model import Covariance, Model
from radartrack.derive.symbolic import Expr, PolyElement, Symbol

Monomial = tuple[int, ...]


class GeneratingFunction:
    """The expectations of a model whose map is polynomial × trigonometric.

    Raises:
        NotExponentialPolynomial: when the map is not.
    """

    def __init__(self, model: Model) -> None:
        self._model = model
        self._duals = tuple(sp.Symbol(f"dual_{variable.name}", real=True) for variable in model.measured)
        self.ring = ring_over((*model.symbols, *self._duals))
        self.h = [self.read(expression) for expression in model.map]
        self._moments: dict[tuple[Covariance, Monomial, tuple[PolyElement, ...]], ExponentialPolynomial] = {}

    def read(self, expression: Expr) -> ExponentialPolynomial:
        """A derived formula in the algebra of this class, where equality is decidable."""
        return ExponentialPolynomial.read(expression, self.ring)

    @cached_property
    def u(self) -> list[ExponentialPolynomial]:
        """The expectation with −K in place of K; kept only where its own expectation is h, which defines it."""
        opposite = tuple(tuple(-entry for entry in row) for row in self._model.covariance)
        found = [self._expectation(h, opposite) for h in self.h]
        if [self.noise(u) for u in found] != self.h:
            raise ArithmeticError(f"no unbiased estimate of {self._model.name} was found")
        return found

    def noise(self, value: ExponentialPolynomial) -> ExponentialPolynomial:
        """Average over the measurement error."""
        return self._expectation(value, self._model.covariance)

    def prediction(self, value: ExponentialPolynomial) -> ExponentialPolynomial:
        """Average over the error of a prediction."""
        return self._expectation(value, self._model.prediction_covariance)

    def _expectation(self, value: ExponentialPolynomial, covariance: Covariance) -> ExponentialPolynomial:
        ring, total = self.ring, ExponentialPolynomial(self.ring, {})
        places = [ring.symbols.index(variable) for variable in self._model.measured]
        for exponent, coefficient in value.terms.items():
            slopes = tuple(exponent.diff(ring(variable)) for variable in self._model.measured)
            linear = sum((s * ring(v) for s, v in zip(slopes, self._model.measured, strict=True)), ring.zero)
            for monomial, number in coefficient.terms():
                powers = tuple(monomial[place] for place in places)
                rest = ring.from_dict({tuple(0 if n in places else power for n, power in enumerate(monomial)): number})
                outer = ExponentialPolynomial(ring, {exponent - linear: rest})
                total = total + outer * self._moment(covariance, powers, slopes)
        return total

    def _moment(
        self, covariance: Covariance, powers: Monomial, slopes: tuple[PolyElement, ...]
    ) -> ExponentialPolynomial:
        key = (covariance, powers, slopes)
        if key not in self._moments:
            self._moments[key] = self._derived(covariance, powers, slopes)
        return self._moments[key]

    def _derived(
        self, covariance: Covariance, powers: Monomial, slopes: tuple[PolyElement, ...]
    ) -> ExponentialPolynomial:
        ring = self.ring
        exponent = _logarithm(ring, self._model.measured, self._duals, covariance)
        factor = ring.one
        for dual, power in zip(self._duals, powers, strict=True):
            for _ in range(power):
                factor = factor.diff(ring(dual)) + factor * exponent.diff(ring(dual))
        at = [(ring(dual), slope) for dual, slope in zip(self._duals, slopes, strict=True)]
        return ExponentialPolynomial(ring, {exponent.compose(at): factor.compose(at)})


def _logarithm(
    ring: sp.PolyRing, variables: Sequence[Symbol], duals: Sequence[Symbol], covariance: Covariance
) -> PolyElement:
    """s·θ + sᵀKs/2."""
    total = sum((ring(s) * ring(v) for s, v in zip(duals, variables, strict=True)), ring.zero)
    half = sp.QQ_I(sp.QQ(1, 2), 0)
    for row, first in zip(covariance, duals, strict=True):
        for entry, second in zip(row, duals, strict=True):
            total = total + ring.from_expr(entry) * ring(first) * ring(second) * half
    return total
