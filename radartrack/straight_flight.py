"""Several radars around one straight flight: how good the fused line is with weights from different sources.

The setting is that of figure 1 of Gao, Dong and Zhang (2020), which shows radars of both kinds around a
straight flight without giving numbers. The numbers here are this project's; each of the situations changes
one thing.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import NamedTuple, TypeAlias

import numpy as np
from numpy.typing import NDArray

from radartrack import fusion, line
from radartrack._arrays import repeated_trials
from radartrack._arrays.repeated_trials import Estimate
from radartrack._arrays.validation import RealArray, positive_number, real_number, whole_number
from radartrack.simulate import Radar, Seed, Straight, plots

Floats: TypeAlias = NDArray[np.float64]
REFERENCE_RANGE = 100e3
EVALUATED = 21


@dataclass(frozen=True, slots=True)
class Station:
    """A radar as it is stated, and how it differs from that.

    Attributes:
        radar: of the sensor "spherical", with the stated deviations, and with constant errors that nobody states;
            it counts the azimuth from the y axis and misses nothing.
        has_elevation: False for a two-coordinate radar, whose elevations count as 0.
        ageing: the true deviations over the stated ones, more than 0.

    Raises:
        TypeError: the ageing is no real number.
        ValueError: the radar is another, a deviation of its range or azimuth is 0, or the ageing out of place.
    """

    radar: Radar
    has_elevation: bool = True
    ageing: float = 1.0

    def __post_init__(self) -> None:
        radar = self.radar
        if radar.sensor != "spherical" or radar.azimuth_from == "x" or radar.detection_probability < 1:
            raise ValueError(f"radar must be spherical, with its azimuth from y, and miss nothing; got {radar}")
        if not (radar.noise["range_std"] > 0 and radar.noise["azimuth_std"] > 0):
            raise ValueError(f"radar must have positive deviations of range and azimuth; got {radar.noise}")
        positive_number("ageing", self.ageing)

    @property
    def site(self) -> tuple[float, float]:
        """x and y of the radar [m]."""
        x, y, *_ = self.radar.site
        return x, y

    def as_it_is(self) -> Radar:
        """The radar with its true deviations."""
        age = {name: self.ageing if name.endswith("_std") else 1.0 for name in self.radar.noise}
        return replace(self.radar, noise={name: value * age[name] for name, value in self.radar.noise.items()})

    def deviations(self) -> tuple[float, float, float]:
        """What is stated of range [m], azimuth and elevation [rad]; 0 for an elevation that is not measured."""
        range_std, azimuth_std, elevation_std = (
            self.radar.noise[f"{n}_std"] for n in ("range", "azimuth", "elevation")
        )
        return range_std, azimuth_std, elevation_std if self.has_elevation else 0.0


class Plots(NamedTuple):
    """The plots of one radar over many runs: times (n,), and measured values, each (runs, n)."""

    t: RealArray
    r: RealArray
    azimuth: RealArray
    elevation: RealArray
    x: Floats
    y: Floats


class Comparison(NamedTuple):
    """Errors by source of the weights, and how mean square errors differ from those with propagated weights.

    Attributes:
        rmse: root mean square error of the fused positions along the flight [m], by source of weights.
        excess: mean square error over that with propagated weights, less 1, with its interval; run by run.
    """

    rmse: Mapping[str, Estimate]
    excess: Mapping[str, Estimate]


FLIGHT = Straight(position=(-40e3, 20e3, 8000.0), velocity=(200.0, 60.0))
DURATION = 400.0


def _station(site: tuple[float, float], range_std: float, degrees: float, period: float) -> Station:
    angle = float(np.radians(degrees))
    return Station(
        Radar("spherical", period, {"range_std": range_std, "azimuth_std": angle, "elevation_std": angle}, site)
    )


CALIBRATED = (
    _station((-30e3, -20e3), 60.0, 0.20, 5.0),
    _station((45e3, 0.0), 100.0, 0.30, 10.0),
    _station((0.0, 110e3), 80.0, 0.25, 10.0),
    _station((-120e3, 60e3), 120.0, 0.35, 10.0),
)


def situations() -> dict[str, tuple[Station, ...]]:
    """Radars as stated, some without elevation, some aged, and one with constant errors."""
    first, second, third, fourth = CALIBRATED
    biased = replace(second.radar, bias={"r": 300.0, "azimuth": float(np.radians(0.5))})
    return {
        "calibrated": CALIBRATED,
        "no elevation": (
            first,
            replace(second, has_elevation=False),
            third,
            replace(fourth, has_elevation=False),
        ),
        "aged": (replace(first, ageing=3.0), second, replace(third, ageing=2.0), fourth),
        "biased": (first, replace(second, radar=biased), third, fourth),
    }


def compare(
    stations: Sequence[Station] = CALIBRATED,
    *,
    runs: int = 1000,
    seed: int = 0,
    confidence: float = repeated_trials.CONFIDENCE,
) -> Comparison:
    """Fuse the plots of all radars in many runs with weights from each source, and compare the lines.

    The sources are "equal"; "stated", the stated deviations at 100 km for all; "propagated", error
    propagation at the plots of each radar; "printed" and "consistent", the scatter of each radar's plots
    about its own line; and "covariance", which is no weight a radar but the propagated covariance of each
    plot.

    Args:
        stations: the radars, one at least, each with three plots or more.
        runs: number of runs, at least 2.
        seed: of the simulation.
        confidence: of the intervals, which are normal approximations; between 0 and 1.

    Raises:
        TypeError: the number of runs is not whole, or the confidence no real number.
        ValueError: an argument is out of place.
    """
    runs = whole_number("runs", runs, 2)
    if not 0 < real_number("confidence", confidence) < 1:
        raise ValueError(f"confidence must be between 0 and 1; got {confidence!r}")
    if not stations or any(_scans(station.radar) < 3 for station in stations):
        periods = [station.radar.period for station in stations]
        raise ValueError(f"stations must be one or more, of periods up to {DURATION / 2:g} s; got periods {periods}")
    seen = [plots_of(station, runs, (seed, number)) for number, station in enumerate(stations)]
    times = np.linspace(0.0, DURATION, EVALUATED)
    motions = {name: fused(name, stations, seen) for name in _SOURCES}
    motions["covariance"] = _by_covariance(stations, seen)
    truth = FLIGHT.states(times)[:, :2]
    squares = {
        name: np.mean(np.sum((motion.at(times) - truth) ** 2, axis=-1), axis=-1) for name, motion in motions.items()
    }
    return Comparison(
        {name: repeated_trials.root_mean(errors, confidence) for name, errors in squares.items()},
        {name: repeated_trials.excess(errors, squares["propagated"], confidence) for name, errors in squares.items()},
    )


def plots_of(station: Station, runs: int, seed: Seed) -> Plots:
    """What one radar sees of the flight, converted as by Gao et al. 2020, without the height."""
    radar = station.as_it_is()
    seen = plots(FLIGHT, radar, scans=_scans(radar), trials=runs, seed=seed)
    r, azimuth = seen.measured["r"], seen.measured["azimuth"]
    elevation = seen.measured["elevation"] if station.has_elevation else np.zeros_like(r)
    return Plots(seen.t, r, azimuth, elevation, *line.to_plane(r, azimuth, elevation, site=station.site))


def _scans(radar: Radar) -> int:
    return int(DURATION / radar.period) + 1


def fused(source: str, stations: Sequence[Station], seen: Sequence[Plots]) -> fusion.Motion:
    """The line through the plots of all radars, with a weight for each radar from one of the sources."""
    weights = _SOURCES[source](stations, seen)
    return fusion.fuse_lines([p.t for p in seen], [p.x for p in seen], [p.y for p in seen], weights)


def _by_covariance(stations: Sequence[Station], seen: Sequence[Plots]) -> fusion.Motion:
    times = np.concatenate([p.t for p in seen])
    positions = np.concatenate([np.stack([p.x, p.y], axis=-1) for p in seen], axis=-2)
    pairs = zip(stations, seen, strict=True)
    return fusion.fuse_plots(times, positions, np.concatenate([_covariance(*pair) for pair in pairs], axis=-3))


def _covariance(station: Station, seen: Plots) -> Floats:
    range_std, azimuth_std, elevation_std = station.deviations()
    return fusion.propagated_covariance(seen.r, seen.azimuth, range_std, azimuth_std, seen.elevation, elevation_std)


def _equal(stations: Sequence[Station], _: Sequence[Plots]) -> Floats:
    return fusion.weights(np.ones(len(stations)))


def _stated(stations: Sequence[Station], _: Sequence[Plots]) -> Floats:
    deviations = [fusion.stated_std(*station.deviations()[:2], REFERENCE_RANGE) for station in stations]
    return fusion.weights(np.stack(deviations, axis=-1))


def _propagated(stations: Sequence[Station], seen: Sequence[Plots]) -> Floats:
    deviations = [fusion.position_std(_covariance(*pair)) for pair in zip(stations, seen, strict=True)]
    return fusion.weights(np.stack([np.sqrt(np.mean(d**2, axis=-1)) for d in deviations], axis=-1))


def _by_scatter(method: line.StdMethod) -> "Source":
    def weigh(_: Sequence[Station], seen: Sequence[Plots]) -> Floats:
        return fusion.weights(np.stack([line.measurement_std(p.t, p.x, p.y, method).position for p in seen], axis=-1))

    return weigh


Source: TypeAlias = Callable[[Sequence[Station], Sequence[Plots]], Floats]

_SOURCES: Mapping[str, Source] = {
    "equal": _equal,
    "stated": _stated,
    "propagated": _propagated,
    "printed": _by_scatter("printed"),
    "consistent": _by_scatter("consistent"),
}
