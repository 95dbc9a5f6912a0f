"""Detections as plots of our conversions, and what they are converted to as detections again."""

from collections.abc import Callable, Sequence
from typing import Any, Literal, NamedTuple, TypeAlias

import numpy as np
from stonesoup.base import Property
from stonesoup.models.base import GaussianModel, ReversibleModel
from stonesoup.models.measurement import MeasurementModel
from stonesoup.models.measurement.linear import LinearGaussian
from stonesoup.types.array import CovarianceMatrix, StateVector, StateVectors

from radartrack import convert
from radartrack._arrays.validation import RealArray, require_covariance
from radartrack._conversion.prediction import Prediction
from radartrack._conversion.sensors import SENSORS, Sensor
from radartrack.stone_soup.model_geometry import WITHOUT_RATE, Geometry

PlotMethod: TypeAlias = Literal["linear", "second_order", "averaged", "unbiased", "posterior", "decorrelated"]


class PositionAndRangeRate(MeasurementModel, GaussianModel, ReversibleModel):
    """What a plot with a range rate is converted to: a position, and the product of range and range rate.

    With p and v position and velocity about the sensor, the product is p·v: a quadratic function of the state, whose
    derivatives are all there is of it.

    Source: Duan, Han & Rong Li 2005, the pseudo-measurement of range and range rate.
    """

    noise_covar: CovarianceMatrix = Property(doc="Covariance of the position and of the product")
    velocity_mapping: Sequence[int] = Property(doc="Where the velocity is in the state")
    translation_offset: StateVector = Property(doc="The position of the sensor")
    velocity: StateVector = Property(doc="The velocity of the sensor")

    @property
    def ndim_meas(self) -> int:
        """The coordinates of the position, and the product."""
        return len(self.mapping) + 1

    def covar(self, **_: Any) -> Any:
        """The covariance of what is measured."""
        return self.noise_covar

    def function(self, state: Any, noise: Any = False, **_: Any) -> Any:  # noqa: FBT002 - as in Stone Soup
        """What is measured of states."""
        if isinstance(noise, bool) or noise is None:
            noise = self.rvs(num_samples=state.state_vector.shape[1]) if noise else 0
        position, velocity = self._about(state.state_vector)
        product = (position * velocity).sum(axis=0)
        return np.vstack([state.state_vector[list(self.mapping), :], product]).view(StateVectors) + noise

    def jacobian(self, state: Any, **_: Any) -> RealArray:
        """The first derivatives."""
        position, velocity = self._about(state.state_vector)
        derivatives = np.zeros((self.ndim_meas, self.ndim_state))
        derivatives[range(len(self.mapping)), self.mapping] = 1
        derivatives[-1, self.mapping] = velocity[:, 0]
        derivatives[-1, self.velocity_mapping] = position[:, 0]
        return derivatives

    def hessian(self, _: Any, **__: Any) -> RealArray:
        """The second derivatives, which are the same everywhere."""
        derivatives = np.zeros((self.ndim_meas, self.ndim_state, self.ndim_state))
        derivatives[-1, self.mapping, self.velocity_mapping] = 1
        derivatives[-1, self.velocity_mapping, self.mapping] = 1
        return derivatives

    def inverse_function(self, detection: Any, **_: Any) -> Any:
        """States with that position, and the velocity along the line of sight."""
        measured = np.asarray(detection.state_vector, dtype=np.float64)
        states = np.zeros((self.ndim_state, measured.shape[1]))
        states[list(self.mapping)] = measured[:-1]
        about = measured[:-1] - self.translation_offset
        squares = (about**2).sum(axis=0)
        along = measured[-1] / np.where(squares > 0, squares, 1)
        states[list(self.velocity_mapping)] = np.asarray(along * about + self.velocity)
        return states.view(StateVector if states.shape[1] == 1 else StateVectors)

    def _about(self, states: Any) -> tuple[RealArray, RealArray]:
        vectors = np.asarray(states, dtype=np.float64)
        position = vectors[list(self.mapping)] - np.asarray(self.translation_offset, dtype=np.float64)
        return position, vectors[list(self.velocity_mapping)] - np.asarray(self.velocity, dtype=np.float64)


class Plots(NamedTuple):
    """Detections that one conversion takes.

    Attributes:
        sensor: the conversion.
        geometries: of the models.
        measured: the arguments of the conversion, by name, one for each detection.
    """

    sensor: Sensor
    geometries: list[Geometry]
    measured: dict[str, RealArray]


def is_plot(model: Any) -> bool:
    """Whether there is a conversion for what a model measures."""
    try:
        return Geometry.of(model).sensor is not None
    except TypeError:
        return False


def read_plots(detections: Sequence[Any], models: Sequence[Any]) -> Plots:
    """Detections, whose models measure the same, as plots.

    Raises:
        ValueError: a noise is no covariance, or two errors are correlated for which the conversion has no correlation.

    """
    geometries = [Geometry.of(model) for model in models]
    sensor, outputs = geometries[0].sensor, geometries[0].outputs
    if sensor is None:
        raise TypeError(f"a plot must have a range and all angles; {type(models[0]).__name__} has {outputs}")
    places = [outputs.index(name) for name in sensor.coordinates]
    rows = np.stack([np.asarray(detection.state_vector, dtype=np.float64)[places, 0] for detection in detections])
    noise = np.stack([np.asarray(model.covar(), dtype=np.float64)[np.ix_(places, places)] for model in models])
    measured = dict(zip(sensor.coordinates, rows.T, strict=True))
    return Plots(sensor, geometries, measured | _noise(sensor, noise))


def without_rate(plots: Plots) -> Plots:
    """The same plots, of the position alone."""
    if plots.sensor.module not in WITHOUT_RATE:
        return plots
    sensor = SENSORS[WITHOUT_RATE[plots.sensor.module]]  # type: ignore[index]
    zero = np.zeros(len(plots.geometries))  # the other correlation is with the range rate
    measured = {name: plots.measured[name] for name in sensor.arguments} | {"correlation": zero}
    return plots._replace(sensor=sensor, measured=measured)


def converted(plots: Plots, method: str, predicted: Prediction | None = None) -> convert.Converted:
    """Means and covariances in the axes of the state: positions, and the product of range and range rate last.

    Raises:
        ValueError: a plot is out of place for the conversion, or a sensor in the plane is tilted out of it.

    """
    function: Callable[..., convert.Converted] = getattr(convert, plots.sensor.module)
    more = {} if predicted is None else {"predicted": predicted}
    mean, covariance = function(**plots.measured, method=method, azimuth_from="x", **more)
    axes = plots.geometries[0].axes
    back = np.broadcast_to(np.eye(mean.shape[-1]), covariance.shape).copy()
    back[:, :axes, :axes] = np.stack([geometry.back for geometry in plots.geometries])
    turned = (back @ mean[..., np.newaxis])[..., 0]
    turned[:, :axes] += np.stack([geometry.origin[:axes] for geometry in plots.geometries])
    spread = back @ covariance @ np.swapaxes(back, -1, -2)
    return convert.Converted(turned, (spread + np.swapaxes(spread, -1, -2)) / 2)


def model_of(model: Any, geometry: Geometry, covariance: RealArray) -> Any:
    """What measures a converted plot: linear, but for the product of range and range rate."""
    axes = geometry.axes
    places, noise = tuple(geometry.places[:axes]), CovarianceMatrix(covariance)
    if len(covariance) == axes:
        return LinearGaussian(ndim_state=model.ndim_state, mapping=places, noise_covar=noise)
    return PositionAndRangeRate(
        ndim_state=model.ndim_state,
        mapping=places,
        noise_covar=noise,
        velocity_mapping=tuple(geometry.places[axes:]),
        translation_offset=StateVector(geometry.origin[:axes]),
        velocity=StateVector(geometry.origin[axes:]),
    )


def _noise(sensor: Sensor, covariances: RealArray) -> dict[str, RealArray]:
    require_covariance("noise_covar", covariances)
    deviations = np.sqrt(np.diagonal(covariances, axis1=1, axis2=2))
    i, j = sensor.correlated
    product = deviations[:, i] * deviations[:, j]
    correlation = np.divide(covariances[:, i, j], product, out=np.zeros_like(product), where=product > 0)
    others = covariances.copy()
    others[:, i, j] = others[:, j, i] = 0
    others[:, range(others.shape[1]), range(others.shape[1])] = 0
    if others.any():
        names = [*sensor.coordinates]
        allowed = f"without correlations but that of {names[i]} and {names[j]}"
        raise ValueError(f"noise_covar must be {allowed} for the conversion {sensor.module!r}; got others")
    return dict(zip(sensor.noise, [*deviations.T, np.clip(correlation, -1, 1)], strict=True))  # one despite rounding
