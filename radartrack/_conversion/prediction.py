"""A prediction of the measured quantities, with all its correlations.

The formulas that average over a prediction know one correlation, that of the pair whose measurement errors are
correlated too. A prediction from a track has the others as well. Given the quantities outside the pair, the pair
has just the covariance that the formulas know, about a mean that is linear in those quantities; so their average
over these, one after the other, by Gauss-Hermite quadrature with enough nodes for rounding to be all that is left,
is the average over the whole prediction.
"""

import math
import reprlib
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray

from radartrack._arrays.validation import (
    RealArray,
    require_covariance,
    require_trailing_shape,
    require_within,
)
from radartrack._conversion.semidefinite import cast, without_nothing
from radartrack._conversion.sensors import Sensor

Prediction: TypeAlias = tuple[ArrayLike, ArrayLike]

MEAN, COVARIANCE = "predicted mean", "predicted covariance"
SERIES_NODES = 8  # exact to the fifteenth degree, and within the five deviations that the series demands


def prediction_arguments(predicted: Prediction | None) -> Mapping[str, ArrayLike]:
    """The two parts of a prediction by the names that messages give them.

    Raises:
        TypeError: it is no pair.

    """
    if not isinstance(predicted, (tuple, list)) or len(predicted) != 2:
        allowed = "a pair (mean, covariance) for method 'decorrelated'"
        raise TypeError(f"predicted must be {allowed}; got {reprlib.repr(predicted)}")
    return {MEAN: predicted[0], COVARIANCE: predicted[1]}


@dataclass(frozen=True, slots=True)
class Predicted:
    """Mean, shape (..., n), and covariance, shape (..., n, n), of the quantities that a sensor measures."""

    sensor: Sensor
    mean: RealArray
    covariance: RealArray

    def require_valid(self) -> None:
        """Check that it is a possible mean and its covariance.

        Raises:
            ValueError: it is none.

        """
        size = len(self.sensor.coordinates)
        require_trailing_shape(MEAN, self.mean, (size,))
        require_trailing_shape(COVARIANCE, self.covariance, (size, size))
        require_covariance(COVARIANCE, self.covariance)
        arguments = [*self.sensor.coordinates.values(), *self.sensor.noise.values()]
        for (name, values), (_, domain) in zip(self.named().items(), arguments, strict=True):
            require_within(name, values, domain)

    def named(self) -> dict[str, RealArray]:
        """Mean, deviations and the one correlation, by the names that messages give them."""
        places = {name: f"{name} of {MEAN}" for name in self.sensor.coordinates}
        places |= {name: f"{name} of {COVARIANCE}" for name in self.sensor.noise}
        values = [*np.moveaxis(self.mean, -1, 0), *self._noise(self.covariance)]
        return dict(zip(places.values(), values, strict=True))

    def require_possible(self, noise: Mapping[str, RealArray]) -> None:
        """Check that measurements of what is predicted, with errors of these deviations, are possible.

        Raises:
            ValueError: they are not.

        """
        symbols = [symbol for symbol, _ in self.sensor.coordinates.values()]
        total = {
            f"sigma_{symbol}": np.hypot(noise[f"sigma_{symbol}"], np.sqrt(self.covariance[..., i, i]))
            for i, symbol in enumerate(symbols)
        }
        means = dict(zip(symbols, np.moveaxis(self.mean, -1, 0), strict=True))
        self.sensor.require_possible({**noise, **means, **total}, f" of {MEAN}")

    def only(self, chosen: NDArray[np.bool_]) -> "Predicted":
        """Those of some plots, in float64; deviations whose squares underflow are 0."""
        mean = self.mean[chosen] if self.mean.ndim > 1 else self.mean
        matrices = self.covariance[chosen] if self.covariance.ndim > 2 else self.covariance
        return Predicted(self.sensor, without_nothing(mean), cast(matrices.astype(np.float64), np.dtype(np.float64)))

    def symbols(self) -> dict[str, RealArray]:
        """Mean, deviations and the one correlation, by the symbols that formulas give them."""
        return self._symbols(self.mean, self.covariance)

    def parts(self) -> Iterator[tuple[float, dict[str, RealArray]]]:
        """Weights that sum to one, each with what the formulas take, by symbol."""
        other = self._other()
        if other is None:
            yield 1.0, self.symbols()
            return
        direction = self._along(other)
        rest = self.covariance - direction[..., :, np.newaxis] * direction[..., np.newaxis, :]
        rest[..., other, :] = rest[..., :, other] = 0
        for node, weight in zip(*_rule(self._nodes(direction)), strict=True):
            given = Predicted(self.sensor, self.mean + float(node) * direction, rest)
            for share, symbols in given.parts():
                yield float(weight) * share, symbols

    def _other(self) -> int | None:
        """The place of a quantity outside the pair that is correlated with any other; None without one."""
        outside = (place for place in range(len(self.sensor.coordinates)) if place not in self.sensor.correlated)
        return next((place for place in outside if np.delete(self.covariance[..., place], place, axis=-1).any()), None)

    def _along(self, other: int) -> RealArray:
        """How far all quantities move together with one standard deviation of one of them."""
        deviation = np.sqrt(np.maximum(self.covariance[..., other, other], 0))[..., np.newaxis]
        along: RealArray = self.covariance[..., other] / np.where(deviation > 0, deviation, 1)
        return along

    def _nodes(self, direction: RealArray) -> int:
        """Enough for polynomials of the fourth degree times sines of twice the angles."""
        if self.sensor.series:
            return SERIES_NODES
        angles = np.abs(direction[..., list(self.sensor.angles)]).sum(axis=-1)
        frequency = 2 * float(angles.max(initial=0))
        count = 6
        while count * math.log(math.e * frequency**2 / (4 * count) + 1e-300) > math.log(1e-18):
            count += 1
        return count

    def _symbols(self, mean: RealArray, covariance: RealArray) -> dict[str, RealArray]:
        values = [*np.moveaxis(mean, -1, 0), *self._noise(covariance)]
        names = [symbol for symbol, _ in self.sensor.coordinates.values()]
        names += [f"predicted_{symbol}" for symbol, _ in self.sensor.noise.values()]
        return dict(zip(names, values, strict=True))

    def _noise(self, covariance: RealArray) -> list[RealArray]:
        """Standard deviations, and the correlation: 0 beside a zero variance, at most 1 despite rounding."""
        variances = np.diagonal(covariance, axis1=-2, axis2=-1)
        deviations = np.sqrt(np.maximum(variances, 0))
        i, j = self.sensor.correlated
        first, second = deviations[..., i], deviations[..., j]
        quotient = covariance[..., i, j] / np.where(first > 0, first, 1) / np.where(second > 0, second, 1)
        return [*np.moveaxis(deviations, -1, 0), np.clip(quotient, -1, 1)]


def _rule(count: int) -> tuple[RealArray, RealArray]:
    """Nodes and weights for the mean over a standard normal variable."""
    nodes, weights = np.polynomial.hermite_e.hermegauss(count)
    return nodes, weights / weights.sum()
