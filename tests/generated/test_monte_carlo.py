"""Moments against simulated measurements.

Each entry of each moment is the mean of something that one draw gives; it is compared with the mean over DRAWS
draws. All comparisons together raise a false alarm with probability FALSE_ALARM at most (normal quantile, shared
out evenly). An error of DETECTABLE standard deviations of a draw, 2 % of them, is found with probability 0.999.
"""

from collections.abc import Callable, Mapping
from statistics import NormalDist

import numpy as np
import pytest

from radartrack.derive.catalogue import catalogue
from radartrack.derive.language.quantity import Quantity
from tests import conversions, maps
from tests.quadrature import square

Columns = Mapping[str, np.ndarray | float]

DRAWS = 200_000
FALSE_ALARM = 1e-6
POINT = {"r": 900.0, "beta": 2.2, "epsilon": 0.6, "rdot": -120.0, "rho": 0.6}
POINT |= {"sigma_r": 150.0, "sigma_beta": 0.5, "sigma_epsilon": 0.3, "sigma_rdot": 40.0}
POINT |= {"predicted_sigma_r": 80.0, "predicted_sigma_beta": 0.3, "predicted_sigma_epsilon": 0.2}
POINT |= {"predicted_sigma_rdot": 20.0, "predicted_rho": -0.4}


def value(model: str, row: str, point: Columns) -> np.ndarray:
    quantity = catalogue()[f"{model}.{row}"]
    return conversions.generated(quantity)(**{symbol.name: point[symbol.name] for symbol in quantity.symbols})


class Simulation:
    """Draws of true values and measurements of one model."""

    def __init__(self, model: str) -> None:
        self.model = model
        self.generator = np.random.Generator(np.random.Philox(int.from_bytes(model.encode()[:8])))

    def moved(self, point: Columns, prefix: str = "") -> Columns:
        """The point with an error added; which sign it has does not matter."""
        covariance = maps.covariance(self.model, POINT, prefix)
        errors = self.generator.standard_normal((DRAWS, len(covariance))) @ np.linalg.cholesky(covariance).T
        names = maps.measured(self.model)
        return {**point, **{name: point[name] + errors[:, i] for i, name in enumerate(names)}}

    def h(self, point: Columns) -> np.ndarray:
        return maps.position(self.model, point)

    def u(self, point: Columns) -> np.ndarray:
        return value(self.model, "unbiased.estimate", point)

    def bias_truth(self) -> np.ndarray:
        return self.h(self.moved(POINT)) - self.h(POINT)

    def covariance_truth(self) -> np.ndarray:
        return square(self.bias_truth() - value(self.model, "bias.truth", POINT))

    def bias_averaged(self) -> np.ndarray:
        truth = self.moved(POINT)
        return self.h(self.moved(truth)) - self.h(truth)

    def covariance_averaged(self) -> np.ndarray:
        truth = self.moved(POINT)
        return square(self.h(self.moved(truth)) - self.h(truth) - value(self.model, "bias.truth", truth))

    def posterior_estimate(self) -> np.ndarray:
        return self.h(self.moved(POINT))

    def posterior_covariance(self) -> np.ndarray:
        return square(self.h(self.moved(POINT)) - value(self.model, "posterior.estimate", POINT))

    def unbiased_covariance(self) -> np.ndarray:
        return square(self.u(POINT) - self.h(self.moved(POINT)))

    def decorrelated_covariance(self) -> np.ndarray:
        truth = self.moved(POINT, "predicted_")
        return square(self.u(self.moved(truth)) - self.h(truth))


SIMULATED: dict[str, Callable[[Simulation], np.ndarray]] = {
    "bias.truth": Simulation.bias_truth,
    "bias.averaged": Simulation.bias_averaged,
    "covariance.truth": Simulation.covariance_truth,
    "covariance.averaged": Simulation.covariance_averaged,
    "posterior.estimate": Simulation.posterior_estimate,
    "posterior.covariance": Simulation.posterior_covariance,
    "unbiased.covariance": Simulation.unbiased_covariance,
    "decorrelated.covariance": Simulation.decorrelated_covariance,
}
MOMENTS = conversions.of(*SIMULATED)
COMPARISONS = sum(int(np.prod(quantity.shape)) for quantity in MOMENTS)
THRESHOLD = -NormalDist().inv_cdf(FALSE_ALARM / 2 / COMPARISONS)
DETECTABLE = (THRESHOLD + NormalDist().inv_cdf(0.999)) / DRAWS**0.5


def deviation(draws: np.ndarray, expected: np.ndarray) -> np.ndarray:
    """By how many of its standard deviations the mean of the draws is off."""
    return np.abs(draws.mean(axis=0) - expected) / (draws.std(axis=0) / len(draws) ** 0.5)


@pytest.mark.parametrize("quantity", MOMENTS, ids=conversions.ids)
def test_the_moment_is_the_mean_over_simulated_measurements_and_errors_of_two_percent_are_found(
    quantity: Quantity,
):
    row = conversions.row(quantity)
    draws, expected = SIMULATED[row](Simulation(quantity.module)), value(quantity.module, row, POINT)
    assert deviation(draws, expected).max() < THRESHOLD
    for sign in (-1, 1):
        wrong = draws.mean(axis=0) + sign * DETECTABLE * draws.std(axis=0)
        assert deviation(draws, wrong).min() > THRESHOLD


def test_the_smallest_detectable_error_is_what_the_module_states():
    assert pytest.approx(0.02, abs=0.002) == DETECTABLE
