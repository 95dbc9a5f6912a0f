"""Simulated targets and radars: what is measured of a known motion, over any number of trials at once.

    target = simulate.Straight(position=(150e3, 0.0), velocity=(200.0, 0.0))
    radar = simulate.Radar("polar", period=10.0, noise={"range_std": 250.0, "azimuth_std": 0.017})
    seen = simulate.plots(target, radar, scans=20, trials=1000, seed=1)
    rt.convert.polar(**seen.measured, **radar.noise)

The measured quantities and the deviations have the names of the arguments of the conversions. Trials come from
one stream, trial after trial: the first thousand of two thousand are the same thousand.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from hashlib import sha256
from typing import NamedTuple, Protocol, TypeAlias

import numpy as np
from numpy.typing import ArrayLike

from radartrack import observe
from radartrack._arrays.validation import (
    RealArray,
    by_name,
    number_between,
    one_of,
    real_arrays,
    real_number,
    require_finite,
    require_parts,
    require_trailing_shape,
    require_within,
    whole_number,
)
from radartrack._conversion.sensors import SENSORS, AzimuthFrom, Sensor, SensorName
from radartrack._observation.sights import SIGHTS

__all__ = ["Accelerated", "Plots", "Radar", "Straight", "Target", "Turning", "noise_covariance", "plots"]


def __dir__() -> list[str]:
    return __all__


Seed: TypeAlias = int | Sequence[int]

AXES = 3
_STATE = ("x", "y", "z", "vx", "vy", "vz")


class Target(Protocol):
    """Something that moves in a known way."""

    def states(self, t: ArrayLike) -> RealArray:
        """Position [m] and velocity [m/s], (x, y, z, vx, vy, vz), at times [s]: shape (..., 6)."""
        ...


@dataclass(frozen=True, slots=True)
class Accelerated:
    """A target with constant acceleration.

    Attributes:
        position: x and y, or x, y and z, at time zero [m]; z is 0 where it is not given.
        velocity: likewise [m/s].
        acceleration: likewise [m/s^2].

    """

    position: Sequence[float]
    velocity: Sequence[float]
    acceleration: Sequence[float] = (0.0, 0.0)

    def __post_init__(self) -> None:
        for name in ("position", "velocity", "acceleration"):
            object.__setattr__(self, name, _numbers(name, getattr(self, name)))

    def states(self, t: ArrayLike) -> RealArray:
        """Position [m] and velocity [m/s] at times [s], shape (..., 6).

        Raises:
            TypeError: the times are not made of real numbers.
            ValueError: a time is not finite, or a state overflows.

        """
        times = _times(t)
        r, v, a = (_vector(each) for each in (self.position, self.velocity, self.acceleration))
        with np.errstate(over="ignore", invalid="ignore"):
            return _finite_states(r + v * times + a * times**2 / 2, v + a * times)


@dataclass(frozen=True, slots=True)
class Straight(Accelerated):
    """A target with constant velocity.

    Attributes:
        position: x and y, or x, y and z, at time zero [m]; z is 0 where it is not given.
        velocity: likewise [m/s].

    """

    acceleration: Sequence[float] = field(default=(0.0, 0.0), init=False)


@dataclass(frozen=True, slots=True)
class Turning:
    """A target that turns in the horizontal plane at a constant rate; its height changes at a constant rate.

    Attributes:
        position: x and y, or x, y and z, at time zero [m]; z is 0 where it is not given.
        velocity: likewise [m/s].
        turn_rate: counter-clockwise [rad/s].

    """

    position: Sequence[float]
    velocity: Sequence[float]
    turn_rate: float

    def __post_init__(self) -> None:
        for name in ("position", "velocity"):
            object.__setattr__(self, name, _numbers(name, getattr(self, name)))
        real_number("turn_rate", self.turn_rate)

    def states(self, t: ArrayLike) -> RealArray:
        """Position [m] and velocity [m/s] at times [s], shape (..., 6).

        Raises:
            TypeError: the times are not made of real numbers.
            ValueError: a time is not finite, or a state overflows.

        """
        times = _times(t)
        x, y, z = _vector(self.position)
        vx, vy, vz = _vector(self.velocity)
        with np.errstate(over="ignore", invalid="ignore"):
            angle = float(self.turn_rate) * times
            sine, cosine = np.sin(angle), np.cos(angle)
            along, across = times * np.sinc(angle / np.pi), times * angle / 2 * np.sinc(angle / (2 * np.pi)) ** 2
            parts = [
                x + vx * along - vy * across, y + vy * along + vx * across, z + vz * times,
                vx * cosine - vy * sine, vy * cosine + vx * sine, np.full_like(times, vz),
            ]  # fmt: skip
        return _finite_states(*parts)


@dataclass(frozen=True, slots=True)
class Radar:
    """A radar: what it measures from where, how often, and with which errors.

    Attributes:
        sensor: a conversion's name, such as "polar" (range and azimuth of a target in the plane). "ruv" does not tell a
            target behind the array, at a z below its own, from its mirror image.
        period: time from scan to scan [s].
        noise: standard deviations, and `correlation` where it is not 0, by the names that the conversion of the
            sensor gives them: {"range_std": 250.0, "azimuth_std": 0.017}.
        site: x and y, or x, y and z, of the radar [m].
        bias: constant errors by measured quantity: {"azimuth": 0.01}, each in size at most what the conversion takes.
        detection_probability: that a scan sees the target; the scans are independent.
        azimuth_from: as the conversion of the sensor takes it; None for its default. "ruv" has none.
        known: what else the conversion takes by name: {"baseline": 20e3} for "bistatic".

    Raises:
        TypeError: a deviation is missing, a name is none of the sensor's, or a value is no real number.
        ValueError: a number lies out of its domain, or a word is unknown.

    """

    sensor: SensorName
    period: float
    noise: Mapping[str, float]
    site: Sequence[float] = (0.0, 0.0)
    bias: Mapping[str, float] = field(default_factory=dict)
    detection_probability: float = 1.0
    azimuth_from: AzimuthFrom | None = None
    known: Mapping[str, float] = field(default_factory=dict)

    def __post_init__(self) -> None:
        model = SENSORS[one_of("sensor", self.sensor, SENSORS)]
        _noise_of(model, self.noise)
        bias, known = (by_name(name, getattr(self, name)) for name in ("bias", "known"))
        if not set(bias) <= set(model.coordinates):
            raise TypeError(f"bias must be of {[*model.coordinates]}; got {[*bias]}")
        for name, value in bias.items():
            domain = model.coordinates[name].domain._replace(signed=True)
            require_within(f"bias of {name}", np.asarray(real_number(f"bias of {name}", value)), domain)
        object.__setattr__(self, "site", _numbers("site", self.site))
        if real_number("period", self.period) <= 0:
            raise ValueError(f"period must be finite and more than 0; got {self.period}")
        number_between("detection_probability", self.detection_probability, 0, 1)
        model.chosen_axis(self.azimuth_from)
        if set(known) != set(model.parameters):
            raise TypeError(f"known must have {[*model.parameters]}; got {[*known]}")
        for name, value in known.items():
            require_within(name, np.asarray(real_number(name, value)), model.parameters[name].domain)
        for name, own in {"noise": by_name("noise", self.noise), "bias": bias, "known": known}.items():
            object.__setattr__(self, name, own)

    def times(self, scans: int) -> RealArray:
        """The times of the first scans [s], from 0 on, shape (scans,).

        Raises:
            TypeError: the count is no whole number.
            ValueError: the count is negative, or a time overflows.

        """
        with np.errstate(over="ignore"):
            times = np.arange(whole_number("scans", scans, 0)) * float(self.period)
        require_finite(f"times of {scans} scans every {self.period} s", times)
        return times

    def truth(self, states: ArrayLike) -> dict[str, RealArray]:
        """What it would measure without errors.

        Args:
            states: (x, y, z, vx, vy, vz) [m, m/s], shape (..., 6).

        Returns:
            Each measured quantity by name [m, rad, m/s], shape (...).

        Raises:
            TypeError: the states are not made of real numbers.
            ValueError: their shape is another, a number is not finite, or a state lies out of what it can see.

        """
        model = SENSORS[self.sensor]
        given = real_arrays({"states": states})["states"].astype(np.float64)
        require_trailing_shape("states", given, (len(_STATE),))
        require_finite("states", given)
        relative = given - np.concatenate([_vector(self.site), np.zeros(AXES)])
        seen = relative[..., [_STATE.index(component) for component in SIGHTS[self.sensor].state]]
        axis = model.chosen_axis(self.azimuth_from)
        options = {**self.known} if axis is None else {**self.known, "azimuth_from": axis}
        see: Callable[..., observe.Observed] = getattr(observe, self.sensor)
        values = see(seen, **options).measurement
        return dict(zip(model.coordinates, np.moveaxis(values, -1, 0), strict=True))

    def noise_covariance(self) -> RealArray:
        """The covariance of the errors of a scan, shape (m, m), in the order of the measured quantities."""
        return noise_covariance(self.sensor, self.noise)


class Plots(NamedTuple):
    """What a radar sees of a target.

    Attributes:
        t: times of the scans [s], shape (scans,).
        measured: each quantity by name, shape (trials, scans); NaN where the target was not detected.
        truth: the same without errors, shape (scans,).
        states: of the target, (x, y, z, vx, vy, vz), shape (scans, 6).

    """

    t: RealArray
    measured: dict[str, RealArray]
    truth: dict[str, RealArray]
    states: RealArray


def plots(target: Target, radar: Radar, *, scans: int, trials: int = 1, seed: Seed = 0) -> Plots:
    """Simulate what a radar measures of a target: truth, plus bias, plus Gaussian errors, where it is detected.

    Angles are not wrapped and nothing is clipped: an azimuth near the end of its interval passes it by its error.

    Args:
        target: what moves.
        radar: what sees it; its first scan is at time zero.
        scans: how many, at least 1.
        trials: how many times over, with independent errors and detections, at least 1.
        seed: of the random numbers; the same one gives the same plots. Several numbers tell streams apart, such as
            (seed, number of the radar).

    Raises:
        TypeError: there is no target or no radar, a count or a seed is no whole number, or the states are not made of
            real numbers.
        ValueError: a count is less than 1, a seed is negative, the target has not one state a time, or one lies out of
            what the radar can see.

    """
    require_parts("target", target, ["states"], "a target with states at times")
    require_parts("radar", radar, ("times", "truth", "noise_covariance"), "a Radar")
    scans, trials = (whole_number(name, count, 1) for name, count in (("scans", scans), ("trials", trials)))
    times = radar.times(scans)
    states = real_arrays({"states of the target": target.states(times)})["states of the target"].astype(np.float64)
    if states.shape != (scans, len(_STATE)):
        raise ValueError(f"states of the target must have shape {(scans, len(_STATE))}; got {states.shape}")
    truth = radar.truth(states)
    errors, detections = (np.random.default_rng(part) for part in np.random.SeedSequence(_entropy(seed)).spawn(2))
    noise = scatter(radar.noise_covariance(), errors.standard_normal((trials, scans, len(truth))))
    missed = detections.random((trials, scans)) >= radar.detection_probability
    measured = {
        name: np.where(missed, np.nan, value + radar.bias.get(name, 0.0) + noise[..., place])
        for place, (name, value) in enumerate(truth.items())
    }
    return Plots(times, measured, truth, states)


def _entropy(seed: Seed) -> int:
    """What seeds the streams: of several numbers a digest, as NumPy would take 0, (0,) and (0, 0) for one."""
    if not isinstance(seed, (Sequence, np.ndarray)) or getattr(seed, "ndim", 1) == 0:
        return whole_number("seed", seed, 0)
    text = ",".join(f"{whole_number('seed', number, 0):x}" for number in seed)
    return int.from_bytes(sha256(text.encode()).digest(), "big")


def noise_covariance(sensor: SensorName, noise: Mapping[str, float]) -> RealArray:
    """The covariance of the errors of measured quantities.

    Args:
        sensor: a conversion's name.
        noise: standard deviations [m, rad, m/s], and `correlation` where it is not 0, by the names that the conversion
            gives them.

    Returns:
        Shape (m, m), in the order of the measured quantities.

    Raises:
        TypeError: a deviation is missing, a name is none of the sensor's, or a value is no real number.
        ValueError: a number lies out of its domain, or the sensor is unknown.

    """
    model = SENSORS[one_of("sensor", sensor, SENSORS)]
    *deviations, correlation = _noise_of(model, noise)
    correlations = np.eye(len(deviations))
    first, second = model.correlated
    correlations[first, second] = correlations[second, first] = correlation
    covariance: RealArray = correlations * np.outer(deviations, deviations)
    return covariance


def _noise_of(model: Sensor, given: Mapping[str, float]) -> list[float]:
    """Deviations and correlation in the order of the sensor's arguments, each in its domain."""
    noise = {"correlation": 0.0} | by_name("noise", given)
    if set(noise) != set(model.noise):
        raise TypeError(f"noise must have {[*model.noise]} (correlation is 0 if left out); got {sorted(given)}")
    for name, argument in model.noise.items():
        require_within(name, np.asarray(real_number(name, noise[name])), argument.domain)
    return [float(noise[name]) for name in model.noise]


def scatter(covariance: RealArray, normal: RealArray) -> RealArray:
    """Errors with this covariance, (m, m), from independent standard normal numbers, both of shape (..., m)."""
    deviations = np.sqrt(np.diagonal(covariance))
    divisors = np.where(deviations > 0, deviations, 1)
    eigenvalues, vectors = np.linalg.eigh(covariance / np.outer(divisors, divisors))
    root = vectors * np.sqrt(np.maximum(eigenvalues, 0)) @ vectors.T  # the one root that is symmetric
    scattered: RealArray = normal @ root * deviations
    return scattered


def _numbers(name: str, given: Sequence[float]) -> tuple[float, ...]:
    """Two or three finite numbers, which no one else can change."""
    array = real_arrays({name: given})[name].astype(np.float64)
    if array.shape not in {(2,), (AXES,)} or not np.isfinite(array).all():
        raise ValueError(f"{name} must be two or three finite numbers; got {given!r}")
    return tuple(array.tolist())


def _vector(given: Sequence[float]) -> RealArray:
    """Three components, the third 0 where it is not given."""
    return np.append(given, np.zeros(AXES - len(given)))


def _times(t: ArrayLike) -> RealArray:
    times = real_arrays({"t": t})["t"].astype(np.float64)
    require_finite("t", times)
    return times[..., np.newaxis]


def _finite_states(*parts: RealArray) -> RealArray:
    states = np.concatenate(parts, axis=-1)
    require_finite("states of the target", states)
    return states
