"""Hypothesis strategies over the physical domains, edges included; what is found shrinks to plain numbers.

    @given(strategies.plots("polar"))
    def test_my_conversion(plot): ...

Where a function serves a part of the domain, `within={"r": (1e3, 1e5)}` says between which values a quantity is drawn;
the edges are those of that part then.

They need the extra `testing`.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from types import MappingProxyType
from typing import Any, Literal, NamedTuple

import numpy as np
import numpy.typing as npt
from hypothesis import strategies as st
from hypothesis.strategies import DrawFn, SearchStrategy

from radartrack import simulate
from radartrack._arrays.validation import one_of, whole_number
from radartrack._conversion.sensors import DIRECTION, MARGIN, SENSORS, Argument, SensorName
from radartrack._observation.sights import SIGHTS
from radartrack.derive.catalogue import find
from radartrack.derive.evaluation.floating_point import RoughEvaluator
from radartrack.derive.language.quantity import Quantity
from radartrack.derive.language.variable import Variable
from radartrack.derive.sensors import models

__all__ = ["Track", "arguments", "correlated_noise", "covariances", "plots", "tracks"]

Array = npt.NDArray[np.floating[Any]]
Within = Mapping[str, tuple[float, float]]
Motion = Literal["straight", "accelerated", "turning"]
MOTIONS: Mapping[Motion, type[simulate.Target]] = {
    "straight": simulate.Straight,
    "accelerated": simulate.Accelerated,
    "turning": simulate.Turning,
}

ANYWHERE: Within = MappingProxyType({})
PLAIN = (1.0, 10.0, 1000.0)  # what the scales of a positive number shrink to
QUARTER = math.pi / 2
OUTERMOST = 0.99  # of the unit circle, where directions end
ROUNDING = 1e-9
FARTHEST, FASTEST = 1e5, 500.0  # m and m/s along an axis, of targets
SMALL = 1e-3  # m or m/s, or the length of a row, below which there is nothing
SMALLEST, LARGEST = -6, 4  # decimal exponents of deviations of a covariance
CLOSEST = -12  # decimal exponent, in units of the larger end, of values of either sign that are close to zero


class Track(NamedTuple):
    """A target, a radar that sees it, and what that measured.

    Attributes:
        target: of `radartrack.simulate`.
        radar: likewise.
        plots: one trial, at least one scan.
    """

    target: simulate.Target
    radar: simulate.Radar
    plots: simulate.Plots


def arguments(name: str, *, within: Within = ANYWHERE) -> SearchStrategy[dict[str, float]]:
    """Values of all symbols of a quantity, by name, in SI units and radians, wherever the quantity has a value.

    Args:
        name: of the quantity, `polar.covariance.truth`.
        within: symbol → the least and the largest value, in place of those of its domain.

    Raises:
        UnknownQuantity: there is none of that name.
        ValueError: `within` names no symbol of it, or no interval.
    """
    quantity = find(name)
    symbols = _narrowed({symbol.name: symbol for symbol in quantity.symbols}, within)
    return _points(list(symbols.values())).filter(_has_value(quantity))


def plots(sensor: SensorName, *, within: Within = ANYWHERE) -> SearchStrategy[dict[str, float]]:
    """One plot with its noise, by the names of the arguments of `radartrack.convert`: zero range and no baseline too.

    Args:
        sensor: "polar", "spherical", "polar_doppler", "spherical_doppler", "ruv" or "bistatic".
        within: argument → the least and the largest value, in place of those of its domain.

    Raises:
        ValueError: there is no such sensor, or `within` names no argument of it, or no interval.
    """
    model = SENSORS[one_of("sensor", sensor, SENSORS)]
    symbols = _narrowed(_arguments_of(sensor, model.arguments), within)
    values = {name: _value(symbol) for name, symbol in symbols.items()}
    values |= {name: st.just(0.0) | values[name] for name in ("r", "baseline") if name in values and name not in within}
    return st.fixed_dictionaries(values).map(_inside_the_unit_circle if "u" in values else dict)


def correlated_noise(sensor: SensorName, *, within: Within = ANYWHERE) -> SearchStrategy[Array]:
    """The covariance of what a sensor measures, shape (m, m) in the order of its quantities; fully correlated too.

    Args:
        sensor: as for `plots`.
        within: likewise.

    Raises:
        ValueError: as `plots`.
    """
    names = SENSORS[one_of("sensor", sensor, SENSORS)].noise
    return plots(sensor, within=within).map(
        lambda plot: simulate.noise_covariance(sensor, {name: plot[name] for name in names})
    )


@st.composite
def covariances(draw: DrawFn, n: int, *, deviations: Sequence[float] | Array | None = None) -> Array:
    """Symmetric positive semidefinite matrices, shape (n, n): independent, correlated, of any rank and on any scales.

    Args:
        draw: Hypothesis's.
        n: rows, at least 1.
        deviations: the square roots of the diagonal, n of them; drawn on all scales where none are given.

    Raises:
        TypeError, ValueError: n is no whole number, or less than 1, or there are not n deviations.
    """
    size = whole_number("n", n, 1)
    if deviations is not None and len(deviations) != size:
        raise ValueError(f"deviations must be {size}, one for each row; given {len(deviations)}")
    rank = draw(st.integers(0, size))
    correlations = np.eye(size)
    if rank:
        row = st.lists(st.floats(-1, 1), min_size=rank, max_size=rank)
        rows = np.array(draw(st.lists(row, min_size=size, max_size=size)))
        lengths = np.sqrt((rows**2).sum(axis=1))
        rows = np.where(lengths[:, np.newaxis] > SMALL, rows, np.eye(size, rank) + (np.arange(rank) == 0))
        rows /= np.sqrt((rows**2).sum(axis=1))[:, np.newaxis]
        correlations = rows @ rows.T
        correlations = (correlations + correlations.T) / 2
        np.fill_diagonal(correlations, 1.0)
    if deviations is None:
        exponents = draw(st.lists(st.floats(SMALLEST, LARGEST), min_size=size, max_size=size))
        deviations = list(10.0 ** np.array(exponents))
    return np.asarray(correlations * np.outer(deviations, deviations))


@st.composite
def tracks(draw: DrawFn, motion: Motion, sensor: SensorName, *, within: Within = ANYWHERE) -> Track:
    """A target in motion and what a radar sees of it, on any side of the radar, in space also above it.

    Args:
        draw: Hypothesis's.
        motion: "straight", "accelerated" or "turning".
        sensor: as for `plots`.
        within: deviation, correlation or baseline of the radar → the least and the largest value.

    Raises:
        ValueError: there is no such motion or sensor, or `within` names nothing of the radar, or no interval.
    """
    one_of("motion", motion, MOTIONS)
    model = SENSORS[one_of("sensor", sensor, SENSORS)]
    symbols = _narrowed(_arguments_of(sensor, {**model.noise, **model.parameters}), within)
    in_plane = "z" not in SIGHTS[sensor].state
    place, speed = (st.floats(-end, end).map(_clear) for end in (FARTHEST, FASTEST))
    position = [draw(place), draw(place), *([] if in_plane else [_clear(draw(st.floats(0, FARTHEST / 10)))])]
    if sensor == "ruv":
        position[2] += math.hypot(*position[:2])  # in front of the antenna
    if not any(position):
        position[0] = 1000.0  # beside the radar, or above it, not in it
    velocity = [draw(speed) for _ in position]
    acceleration = st.lists(st.floats(-5, 5), min_size=len(position), max_size=len(position))
    more: Mapping[Motion, SearchStrategy[tuple[Any, ...]]] = {
        "straight": st.just(()),
        "accelerated": st.tuples(acceleration),
        "turning": st.tuples(st.floats(-0.1, 0.1)),
    }
    make: Callable[..., simulate.Target] = MOTIONS[motion]
    target = make(position, velocity, *draw(more[motion]))
    noise, known = ({name: draw(_value(symbols[name])) for name in names} for names in (model.noise, model.parameters))
    radar = simulate.Radar(sensor, draw(st.sampled_from([1.0, 4.0, 10.0])), noise, known=known)
    seen = simulate.plots(target, radar, scans=draw(st.integers(1, 12)), seed=draw(st.integers(0, 1000)))
    return Track(target, radar, seen)


def _clear(value: float) -> float:
    """Without what is so small that its square vanishes."""
    return value if abs(value) > SMALL else 0.0


def _arguments_of(sensor: SensorName, names: Mapping[str, Argument]) -> dict[str, Variable]:
    """The symbols of a sensor's arguments, by the names of these."""
    symbols = {symbol.name: symbol for symbol in models()[SENSORS[sensor].module].symbols}
    return {name: symbols[symbol] for name, (symbol, _) in names.items()}


def _narrowed(symbols: Mapping[str, Variable], within: Within) -> dict[str, Variable]:
    """The same with the domains that are asked for."""
    unknown = sorted(within.keys() - symbols.keys())
    if unknown:
        raise ValueError(f"within may name {', '.join(symbols)}; given {', '.join(unknown)}")
    for name, (low, high) in within.items():
        if not (math.isfinite(low) and math.isfinite(high) and low <= high):
            raise ValueError(f"within must give the least and the largest value of {name}; given {(low, high)}")
    return {name: symbol.on(*within[name]) if name in within else symbol for name, symbol in symbols.items()}


@st.composite
def _points(draw: DrawFn, symbols: Sequence[Variable]) -> dict[str, float]:
    found: dict[str, float] = {}
    for symbol in sorted(symbols, key=lambda one: one.at_most is not None):
        bound = found.get(symbol.at_most.name) if symbol.at_most is not None else None
        found[symbol.name] = draw(_value(symbol if bound is None else symbol.below(bound)))
    return {symbol.name: found[symbol.name] for symbol in symbols}


def _value(symbol: Variable) -> SearchStrategy[float]:
    """Plain values first, to which others shrink, then the edges, then all over the domain, on all scales."""
    low, high = float(symbol.low), float(symbol.high)
    if symbol.whole:
        return st.integers(math.ceil(low), math.floor(high)).map(float)
    edges = (0.0, QUARTER, -QUARTER, math.pi, -math.pi) if symbol.is_angle else (0.0, *PLAIN)
    return _among((*edges, high, low), low, high) | _on_all_scales(low, high)


def _among(values: Iterable[float], low: float, high: float) -> SearchStrategy[float]:
    return st.sampled_from([value for value in values if low <= value <= high])


def _on_all_scales(low: float, high: float) -> SearchStrategy[float]:
    """Of what has a sign as many on each scale; of what has both as many anywhere as close to zero."""
    if low > 0:
        return st.floats(math.log10(low), math.log10(high)).map(lambda exponent: _clipped(10.0**exponent, low, high))
    anywhere, size = st.floats(low, high), max(-low, high)
    if not low < 0 < high:
        return anywhere
    close = st.floats(CLOSEST, 0).map(lambda exponent: size * 10.0**exponent)
    return anywhere | st.tuples(close, st.sampled_from([1, -1])).map(lambda one: _clipped(one[0] * one[1], low, high))


def _clipped(value: float, low: float, high: float) -> float:
    return min(max(value, low), high)


def _has_value(quantity: Quantity) -> Callable[[Mapping[str, float]], bool]:
    """Whether a point is none at which the formula divides by zero."""
    evaluator: list[RoughEvaluator] = []

    def has_value(point: Mapping[str, float]) -> bool:
        if not evaluator:
            evaluator.append(RoughEvaluator(list(quantity.expression), quantity.symbols))
        return evaluator[0](list(point.values())) is not None

    return has_value


def _inside_the_unit_circle(plot: dict[str, Any]) -> dict[str, float]:
    """The direction moved inside, and its deviations made so small that it stays there despite its errors."""
    reach = math.hypot(plot["u"], plot["v"])
    factor = min(1.0, OUTERMOST / reach) if reach else 1.0
    room = (DIRECTION.largest - min(reach, OUTERMOST)) * (1 - ROUNDING) / MARGIN
    moved = {name: plot[name] * factor for name in ("u", "v")}
    return plot | moved | {name: min(plot[name], room) for name in ("u_std", "v_std")}
