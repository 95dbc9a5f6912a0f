"""Several radars around one straight flight: how good the fused line is with weights from different sources.

The setting is that of figure 1 of Gao, Dong and Zhang (2020), which shows radars of both kinds around a
straight flight without giving numbers. The numbers here are this project's; each of the situations changes
one thing.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from statistics import NormalDist
from typing import NamedTuple, TypeAlias

import numpy as np
from numpy.typing import NDArray

from radartrack import fusion, line

Floats: TypeAlias = NDArray[np.float64]
REFERENCE_RANGE = 100e3
EVALUATED = 21


@dataclass(frozen=True, slots=True)
class Radar:
    """A radar, what is stated about its errors, and how they differ from it.

    Attributes:
        site: x and y in the common plane [m]; the height is 0.
        range_std: stated standard deviation of the range [m].
        azimuth_std: stated standard deviation of the azimuth [rad].
        elevation_std: stated standard deviation of the elevation [rad]; None for a two-coordinate radar.
        period: time between plots [s].
        ageing: the true deviations over the stated ones.
        range_bias: constant error of the range [m].
        azimuth_bias: constant error of the azimuth [rad].
    """

    site: tuple[float, float]
    range_std: float
    azimuth_std: float
    elevation_std: float | None
    period: float
    ageing: float = 1.0
    range_bias: float = 0.0
    azimuth_bias: float = 0.0


@dataclass(frozen=True, slots=True)
class Flight:
    """A straight flight at constant speed and height.

    Attributes:
        start: x and y at time zero [m].
        velocity: along x and y [m/s].
        height: height above the plane of the radars [m].
        duration: length of the flight [s].
    """

    start: tuple[float, float]
    velocity: tuple[float, float]
    height: float
    duration: float

    def position(self, t: Floats) -> Floats:
        """x and y [m] at times, shape (..., 2)."""
        x, y = (start + t * speed for start, speed in zip(self.start, self.velocity, strict=True))
        return np.stack([x, y], axis=-1)


class Plots(NamedTuple):
    """The plots of one radar over many runs: times (n,), and measured values, each (runs, n)."""

    t: Floats
    r: Floats
    azimuth: Floats
    elevation: Floats
    x: Floats
    y: Floats


class Estimate(NamedTuple):
    """A value estimated from the runs, and its confidence interval."""

    value: float
    lower: float
    upper: float


class Comparison(NamedTuple):
    """Errors by source of the weights, and how mean square errors differ from those with propagated weights.

    Attributes:
        rmse: root mean square error of the fused positions along the flight [m], by source of weights.
        excess: mean square error over that with propagated weights, less 1, with its interval; run by run.
    """

    rmse: Mapping[str, Estimate]
    excess: Mapping[str, Estimate]


FLIGHT = Flight(start=(-40e3, 20e3), velocity=(200.0, 60.0), height=8000.0, duration=400.0)

_DEGREE = float(np.pi / 180)
CALIBRATED = (
    Radar((-30e3, -20e3), 60.0, 0.20 * _DEGREE, 0.20 * _DEGREE, 5.0),
    Radar((45e3, 0.0), 100.0, 0.30 * _DEGREE, 0.30 * _DEGREE, 10.0),
    Radar((0.0, 110e3), 80.0, 0.25 * _DEGREE, 0.25 * _DEGREE, 10.0),
    Radar((-120e3, 60e3), 120.0, 0.35 * _DEGREE, 0.35 * _DEGREE, 10.0),
)


def situations() -> dict[str, tuple[Radar, ...]]:
    """Radars as stated, some without elevation, some aged, and one with constant errors."""
    first, second, third, fourth = CALIBRATED
    return {
        "calibrated": CALIBRATED,
        "no elevation": (
            first,
            replace(second, elevation_std=None),
            third,
            replace(fourth, elevation_std=None),
        ),
        "aged": (replace(first, ageing=3.0), second, replace(third, ageing=2.0), fourth),
        "biased": (first, replace(second, range_bias=300.0, azimuth_bias=0.5 * _DEGREE), third, fourth),
    }


def compare(
    radars: Sequence[Radar] = CALIBRATED,
    flight: Flight = FLIGHT,
    *,
    runs: int = 1000,
    seed: int = 0,
    confidence: float = 0.95,
) -> Comparison:
    """Fuse the plots of all radars in many runs with weights from each source, and compare the lines.

    The sources are "equal"; "stated", the stated deviations at 100 km for all; "propagated", error
    propagation at the plots of each radar; "printed" and "consistent", the scatter of each radar's plots
    about its own line; and "covariance", which is no weight a radar but the propagated covariance of each
    plot.

    Args:
        radars: the radars.
        flight: the flight.
        runs: number of runs, at least 2.
        seed: of the counter-based generator.
        confidence: of the intervals, which are normal approximations.
    """
    line.require_count("runs", runs, least=2)
    generator = np.random.Generator(np.random.Philox(seed))
    plots = [simulate(radar, flight, runs, generator) for radar in radars]
    times = np.linspace(0.0, flight.duration, EVALUATED)
    motions = {name: _line(plots, weigh(radars, plots)) for name, weigh in _SOURCES.items()}
    motions["covariance"] = _by_covariance(radars, plots)
    truth = flight.position(times)
    squares = {
        name: np.mean(np.sum((motion.at(times) - truth) ** 2, axis=-1), axis=-1) for name, motion in motions.items()
    }
    z = NormalDist().inv_cdf((1 + confidence) / 2)
    return Comparison(
        {name: _root_mean(errors, z) for name, errors in squares.items()},
        {name: _excess(errors, squares["propagated"], z) for name, errors in squares.items()},
    )


def simulate(radar: Radar, flight: Flight, runs: int, generator: np.random.Generator) -> Plots:
    """Plots of one radar with Gaussian polar errors, converted as by Gao et al. 2020, without the height."""
    t = np.arange(0.0, flight.duration + radar.period / 2, radar.period)
    east, north = np.moveaxis(flight.position(t) - np.asarray(radar.site), -1, 0)
    ground = np.hypot(east, north)
    normal = generator.standard_normal((3, runs, t.size)) * radar.ageing
    r = np.hypot(ground, flight.height) + radar.range_bias + radar.range_std * normal[0]
    azimuth = np.arctan2(east, north) + radar.azimuth_bias + radar.azimuth_std * normal[1]
    elevation = np.zeros_like(r)
    if radar.elevation_std is not None:
        elevation = np.arctan2(flight.height, ground) + radar.elevation_std * normal[2]
    return Plots(t, r, azimuth, elevation, *line.to_plane(r, azimuth, elevation, site=radar.site))


def _line(plots: Sequence[Plots], weights: Floats) -> fusion.Motion:
    return fusion.fuse_lines([p.t for p in plots], [p.x for p in plots], [p.y for p in plots], weights)


def _by_covariance(radars: Sequence[Radar], plots: Sequence[Plots]) -> fusion.Motion:
    times = np.concatenate([p.t for p in plots])
    positions = np.concatenate([np.stack([p.x, p.y], axis=-1) for p in plots], axis=-2)
    pairs = zip(radars, plots, strict=True)
    return fusion.fuse_plots(times, positions, np.concatenate([_covariance(*pair) for pair in pairs], axis=-3))


def _covariance(radar: Radar, plots: Plots) -> Floats:
    spread = radar.elevation_std or 0.0
    return fusion.propagated_covariance(
        plots.r, plots.azimuth, radar.range_std, radar.azimuth_std, plots.elevation, spread
    )


def _equal(radars: Sequence[Radar], _: Sequence[Plots]) -> Floats:
    return fusion.weights(np.ones(len(radars)))


def _stated(radars: Sequence[Radar], _: Sequence[Plots]) -> Floats:
    deviations = [fusion.stated_std(radar.range_std, radar.azimuth_std, REFERENCE_RANGE) for radar in radars]
    return fusion.weights(np.stack(deviations, axis=-1))


def _propagated(radars: Sequence[Radar], plots: Sequence[Plots]) -> Floats:
    deviations = [fusion.position_std(_covariance(*pair)) for pair in zip(radars, plots, strict=True)]
    return fusion.weights(np.stack([np.sqrt(np.mean(d**2, axis=-1)) for d in deviations], axis=-1))


def _by_scatter(method: line.StdMethod) -> "Source":
    def weigh(_: Sequence[Radar], plots: Sequence[Plots]) -> Floats:
        return fusion.weights(np.stack([line.measurement_std(p.t, p.x, p.y, method).position for p in plots], axis=-1))

    return weigh


Source: TypeAlias = Callable[[Sequence[Radar], Sequence[Plots]], Floats]

_SOURCES: Mapping[str, Source] = {
    "equal": _equal,
    "stated": _stated,
    "propagated": _propagated,
    "printed": _by_scatter("printed"),
    "consistent": _by_scatter("consistent"),
}


def _root_mean(squares: Floats, z: float) -> Estimate:
    mean, half = squares.mean(), z * squares.std(ddof=1) / np.sqrt(squares.size)
    return Estimate(*(float(np.sqrt(max(value, 0.0))) for value in (mean, mean - half, mean + half)))


def _excess(squares: Floats, reference: Floats, z: float) -> Estimate:
    """The ratio of two means over the same runs, less 1, with an interval by linearisation."""
    ratio = squares.mean() / reference.mean()
    half = z * (squares - ratio * reference).std(ddof=1) / np.sqrt(squares.size) / reference.mean()
    return Estimate(*(float(value) for value in (ratio - 1, ratio - 1 - half, ratio - 1 + half)))
