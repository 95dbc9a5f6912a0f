"""What each quantity of a measurement model means, as expectations over errors drawn from their distribution.

Nothing here knows a closed form. θ is the true value, w ~ N(0, K) its measurement error, z = θ + w; a
measurement-conditioned quantity averages over θ = z − w, a prediction-conditioned one over θ = θₚ − wₚ.
"""

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cached_property, partial

import numpy as np

from radartrack.derive.catalogue import catalogue
from radartrack.derive.sensors import models
from radartrack.derive.units import RADIAN
from tests import maps
from tests.conversions import generated
from tests.quadrature import Gaussian, Point, square

POLYNOMIAL_ORDER = 3  # exact to degree five; the square of range times range rate has degree four


def enough(deviation: float) -> int:
    """Nodes at which the remainder of Gauss-Hermite quadrature for waves of twice an angle is below rounding."""
    count = POLYNOMIAL_ORDER + 1
    while count * math.log(math.e * deviation**2 / count + 1e-300) > math.log(1e-17):
        count += 1
    return count


@dataclass(frozen=True)
class Expectations:
    """A model at given errors; `order` nodes an angle, or fewer where its deviation is small."""

    model: str
    errors: Mapping[str, float]
    order: int

    @cached_property
    def noise(self) -> Gaussian:
        return self._gaussian("")

    @cached_property
    def prediction(self) -> Gaussian:
        return self._gaussian("predicted_")

    def _gaussian(self, prefix: str) -> Gaussian:
        variables = models()[self.model].measured
        orders = {
            v.name: min(self.order, enough(self.errors[f"{prefix}sigma_{v.name}"]))
            if v.unit == RADIAN
            else POLYNOMIAL_ORDER
            for v in variables
        }
        names = maps.measured(self.model)
        return Gaussian.of(names, maps.covariance(self.model, self.errors, prefix), orders)

    @property
    def h(self) -> Callable[[Point], np.ndarray]:
        return partial(maps.position, self.model)

    def u(self, point: Point) -> np.ndarray:
        """The unbiased estimate as generated: its own test is that E[u(θ + w)] = h(θ)."""
        quantity = catalogue()[f"{self.model}.unbiased.estimate"]
        return generated(quantity)(**{symbol.name: point[symbol.name] for symbol in quantity.symbols})


def bias_truth(of: Expectations, truth: Point) -> np.ndarray:
    return of.noise.expectation(lambda z: of.h(z) - of.h(truth), truth)


def bias_averaged(of: Expectations, z: Point) -> np.ndarray:
    return of.noise.expectation(lambda truth: bias_truth(of, truth), z, sign=-1)


def covariance_truth(of: Expectations, truth: Point) -> np.ndarray:
    return of.noise.covariance(of.h, truth)


def covariance_averaged(of: Expectations, z: Point) -> np.ndarray:
    return of.noise.expectation(lambda truth: covariance_truth(of, truth), z, sign=-1)


def posterior_estimate(of: Expectations, z: Point) -> np.ndarray:
    return of.noise.expectation(of.h, z, sign=-1)


def posterior_covariance(of: Expectations, z: Point) -> np.ndarray:
    return of.noise.covariance(of.h, z, sign=-1)


def unbiased_covariance(of: Expectations, z: Point) -> np.ndarray:
    return of.noise.expectation(lambda truth: square(of.u(z) - of.h(truth)), z, sign=-1)


def decorrelated_covariance(of: Expectations, predicted: Point) -> np.ndarray:
    return of.prediction.expectation(lambda truth: unbiased_covariance_truth(of, truth), predicted, sign=-1)


def unbiased_covariance_truth(of: Expectations, truth: Point) -> np.ndarray:
    return of.noise.expectation(lambda z: square(of.u(z) - of.h(truth)), truth)


def unbiased_covariance_averaged(of: Expectations, z: Point) -> np.ndarray:
    return of.noise.expectation(lambda truth: unbiased_covariance_truth(of, truth), z, sign=-1)


DEFINITIONS: dict[str, Callable[[Expectations, Point], np.ndarray]] = {
    "bias.truth": bias_truth,
    "bias.averaged": bias_averaged,
    "covariance.truth": covariance_truth,
    "covariance.averaged": covariance_averaged,
    "posterior.estimate": posterior_estimate,
    "posterior.covariance": posterior_covariance,
    "unbiased.covariance": unbiased_covariance,
    "unbiased.covariance.truth": unbiased_covariance_truth,
    "unbiased.covariance.averaged": unbiased_covariance_averaged,
    "decorrelated.covariance": decorrelated_covariance,
}
