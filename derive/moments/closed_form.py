"""The closed-form calculus: words over a map that is polynomial times trigonometric, as exponential polynomials."""

from __future__ import annotations

from fractions import Fraction

from radartrack.derive.algebra.exponential_polynomial import ExponentialPolynomial, ring_over
from radartrack.derive.language.model import Model
from radartrack.derive.language.tensor import Tensor
from radartrack.derive.moments.gaussian_operator import GaussianOperator


class Closed:
    """Map and expectations of a model, exact.

    Raises:
        NotExponentialPolynomial: when the map is not polynomial × trigonometric in the measured quantities.
    """

    def __init__(self, model: Model) -> None:
        ring = ring_over(model.symbols)
        self.map: Tensor[ExponentialPolynomial] = model.map.map(lambda h: ExponentialPolynomial.read(h, ring))
        self._measurement = GaussianOperator(model.measured, model.covariance)
        self._prediction = GaussianOperator(model.measured, model.prediction_covariance)
        self.map.map(self._measurement.require_closed)

    def expectation(self, value: ExponentialPolynomial, time: Fraction | int = 1) -> ExponentialPolynomial:
        """e^(tL) f over the measurement error."""
        return self._measurement.exponential(value, time)

    def prediction(self, value: ExponentialPolynomial) -> ExponentialPolynomial:
        """e^(Lₚ) f over the error of a prediction."""
        return self._prediction.exponential(value)
