"""The truncated calculus: words to a stated even order in the deviations, for any smooth map."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from functools import reduce
from math import factorial
from operator import add

from radartrack.derive import symbolic as sp
from radartrack.derive.algebra.differential_ring import DifferentialRing
from radartrack.derive.language.model import Covariance, Model
from radartrack.derive.language.tensor import Tensor
from radartrack.derive.symbolic import Expr, PolyElement


class Series:
    """A power series in the covariance: `terms[n]` is of order n in K, that is of order 2n in the deviations."""

    __slots__ = ("terms",)

    def __init__(self, terms: Sequence[PolyElement]) -> None:
        self.terms = tuple(terms)

    def __add__(self, other: Series) -> Series:
        return Series([a + b for a, b in zip(self.terms, other.terms, strict=True)])

    def __sub__(self, other: Series) -> Series:
        return Series([a - b for a, b in zip(self.terms, other.terms, strict=True)])

    def __mul__(self, other: Series) -> Series:
        def coefficient(n: int) -> PolyElement:
            return reduce(add, (self.terms[k] * other.terms[n - k] for k in range(n + 1)))

        return Series([coefficient(n) for n in range(len(self.terms))])


class Truncated:
    """Map and expectations of a model as series.

    Args:
        model: any model with a smooth map.
        order: the even order in the deviations at which everything is cut off.

    Raises:
        ValueError: for an order that is odd or below two.
    """

    def __init__(self, model: Model, order: int) -> None:
        if order < 2 or order % 2:
            raise ValueError(f"order must be even and at least 2, given {order}")
        self.ring = DifferentialRing(model.map, model.symbols)
        self._variables = model.measured
        self._measurement = self._read(model.covariance)
        self._prediction = self._read(model.prediction_covariance)
        zeros = [self.ring.ring.zero] * (order // 2)
        self.map: Tensor[Series] = model.map.map(lambda h: Series([self.ring.read(h), *zeros]))

    def expectation(self, value: Series, time: Fraction | int = 1) -> Series:
        """e^(tL) f over the measurement error."""
        return self._exponential(value, Fraction(time), self._measurement)

    def prediction(self, value: Series) -> Series:
        """e^(Lₚ) f over the error of a prediction."""
        return self._exponential(value, Fraction(1), self._prediction)

    def completed(self, value: Series, first: Series, second: Series) -> Expr:
        """A covariance to fourth order, completed to a sum of squares: the total and ∂f₁ K ∂g₁ᵀ.

        To fourth order the terms of first derivatives are ∂f K ∂gᵀ + ∂f K ∂g₁ᵀ + ∂f₁ K ∂gᵀ, for functions f + f₁ and
        g + g₁ to second order. Without the last square they need not be positive semidefinite where f₁ is large.
        """
        slopes, others = (
            [self.ring.differentiate(series.terms[1], variable) for variable in self._variables]
            for series in (first, second)
        )
        total = reduce(add, value.terms)
        for slope, row in zip(slopes, self._measurement, strict=True):
            total = reduce(add, (slope * weight * other for weight, other in zip(row, others, strict=True)), total)
        return self.ring.expression(total)

    def total(self, value: Series) -> Expr:
        """The sum of all terms as an expression."""
        return self.ring.expression(reduce(add, value.terms))

    def term(self, value: Series, order: int) -> Expr:
        """The term of an even order in the deviations as an expression."""
        return self.ring.expression(value.terms[order // 2])

    def _read(self, covariance: Covariance) -> list[list[PolyElement]]:
        return [[self.ring.read(entry) for entry in row] for row in covariance]

    def _exponential(self, value: Series, time: Fraction, covariance: list[list[PolyElement]]) -> Series:
        size = len(value.terms)
        total = [self.ring.ring.zero] * size
        for n, term in enumerate(value.terms):
            power = term
            for m in range(size - n):
                weight = time**m / factorial(m)
                total[n + m] = total[n + m] + power * sp.QQ(weight.numerator, weight.denominator)
                if n + m + 1 < size:
                    power = self._generator(power, covariance)
        return Series(total)

    def _generator(self, value: PolyElement, covariance: list[list[PolyElement]]) -> PolyElement:
        """L f = ½ Σ K_ij ∂_i ∂_j f."""
        total = self.ring.ring.zero
        for row, first in zip(covariance, self._variables, strict=True):
            slope = self.ring.differentiate(value, first)
            for weight, second in zip(row, self._variables, strict=True):
                if weight and slope:
                    total = total + self.ring.differentiate(slope, second) * weight
        return total * sp.QQ(1, 2)
