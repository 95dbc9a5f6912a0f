"""Hypothesis strategies over the physical domains, edges included; what is found shrinks to plain numbers.

    @given(strategies.plots("polar"))
    def test_my_conversion(plot): ...

They need the extra `testing`.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from typing import Any, Literal, NamedTuple

import numpy as np
import numpy.typing as npt
from hypothesis import strategies as st
from hypothesis.strategies import DrawFn, SearchStrategy

from radartrack import simulate
from radartrack._arrays.validation import one_of, whole_number
from radartrack._conversion.sensors import DIRECTION, MARGIN, SENSORS, SensorName
from radartrack._observation.sights import SIGHTS
from radartrack.derive.catalogue import find
from radartrack.derive.evaluation.floating_point import RoughEvaluator
from radartrack.derive.language.quantity import Quantity
from radartrack.derive.language.variable import Variable
from radartrack.derive.sensors import models

__all__ = ["Track", "arguments", "correlated_noise", "covariances", "plots", "tracks"]

Array = npt.NDArray[np.floating[Any]]
Motion = Literal["straight", "accelerated", "turning"]
MOTIONS: Mapping[Motion, type[simulate.Target]] = {
    "straight": simulate.Straight,
    "accelerated": simulate.Accelerated,
    "turning": simulate.Turning,
}

PLAIN = (1.0, 10.0, 1000.0)  # what the scales of a positive number shrink to
QUARTER = math.pi / 2
OUTERMOST = 0.99  # of the unit circle, where directions end
ROUNDING = 1e-9
FARTHEST, FASTEST = 1e5, 500.0  # m and m/s along an axis, of targets
SMALL = 1e-3  # m or m/s, or the length of a row, below which there is nothing
SMALLEST, LARGEST = -6, 4  # decimal exponents of deviations of a covariance


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


def arguments(name: str) -> SearchStrategy[dict[str, float]]:
    """Values of all symbols of a quantity, by name, in SI units and radians, wherever the quantity has a value.

    Args:
        name: of the quantity, `polar.covariance.truth`.

    Raises:
        UnknownQuantity: there is none of that name.
    """
    quantity = find(name)
    return _points(quantity).filter(_has_value(quantity))


def plots(sensor: SensorName) -> SearchStrategy[dict[str, float]]:
    """One plot with its noise, by the names of the arguments of `radartrack.convert`: zero range and no baseline too.

    Args:
        sensor: "polar", "spherical", "polar_doppler", "spherical_doppler", "ruv" or "bistatic".

    Raises:
        ValueError: there is no such sensor.
    """
    model = SENSORS[one_of("sensor", sensor, SENSORS)]
    symbols = {symbol.name: symbol for symbol in models()[model.module].symbols}
    values = {name: _value(symbols[symbol]) for name, (symbol, _) in model.arguments.items()}
    values |= {name: st.just(0.0) | values[name] for name in ("r", "baseline") if name in values}
    return st.fixed_dictionaries(values).map(_inside_the_unit_circle if "u" in values else dict)


def correlated_noise(sensor: SensorName) -> SearchStrategy[Array]:
    """The covariance of what a sensor measures, shape (m, m) in the order of its quantities; fully correlated too.

    Args:
        sensor: as for `plots`.

    Raises:
        ValueError: there is no such sensor.
    """
    return plots(sensor).map(lambda plot: simulate.noise_covariance(sensor, plot))


@st.composite
def covariances(draw: DrawFn, n: int) -> Array:
    """Symmetric positive semidefinite matrices, shape (n, n): independent, correlated, of any rank and on any scales.

    Args:
        draw: Hypothesis's.
        n: rows, at least 1.

    Raises:
        TypeError, ValueError: n is no whole number, or less than 1.
    """
    size = whole_number("n", n, 1)
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
    exponents = draw(st.lists(st.floats(SMALLEST, LARGEST), min_size=size, max_size=size))
    deviations = 10.0 ** np.array(exponents)
    return np.asarray(correlations * np.outer(deviations, deviations))


@st.composite
def tracks(draw: DrawFn, motion: Motion, sensor: SensorName) -> Track:
    """A target in motion and what a radar sees of it, on any side of the radar.

    Args:
        draw: Hypothesis's.
        motion: "straight", "accelerated" or "turning".
        sensor: as for `plots`.

    Raises:
        ValueError: there is no such motion or sensor.
    """
    one_of("motion", motion, MOTIONS)
    model = SENSORS[one_of("sensor", sensor, SENSORS)]
    symbols = {symbol.name: symbol for symbol in models()[model.module].symbols}
    in_plane = "z" not in SIGHTS[sensor].state
    place, speed = (st.floats(-end, end).map(_clear) for end in (FARTHEST, FASTEST))
    position = [draw(place), draw(place), *([] if in_plane else [draw(st.floats(0, FARTHEST / 10))])]
    position[0] = position[0] or 1000.0  # beside the radar, not in it
    velocity = [draw(speed) for _ in position]
    acceleration = st.lists(st.floats(-5, 5), min_size=len(position), max_size=len(position))
    more: Mapping[Motion, SearchStrategy[tuple[Any, ...]]] = {
        "straight": st.just(()),
        "accelerated": st.tuples(acceleration),
        "turning": st.tuples(st.floats(-0.1, 0.1)),
    }
    make: Callable[..., simulate.Target] = MOTIONS[motion]
    target = make(position, velocity, *draw(more[motion]))
    noise = {name: draw(_value(symbols[symbol])) for name, (symbol, _) in model.noise.items()}
    known = {name: draw(_value(symbols[symbol])) for name, (symbol, _) in model.parameters.items()}
    radar = simulate.Radar(sensor, draw(st.sampled_from([1.0, 4.0, 10.0])), noise, known=known)
    seen = simulate.plots(target, radar, scans=draw(st.integers(1, 12)), seed=draw(st.integers(0, 1000)))
    return Track(target, radar, seen)


def _clear(value: float) -> float:
    """Without what is so small that its square vanishes."""
    return value if abs(value) > SMALL else 0.0


@st.composite
def _points(draw: DrawFn, quantity: Quantity) -> dict[str, float]:
    found: dict[str, float] = {}
    for symbol in sorted(quantity.symbols, key=lambda one: one.at_most is not None):
        bound = found.get(symbol.at_most.name) if symbol.at_most is not None else None
        found[symbol.name] = draw(_value(symbol if bound is None else symbol.below(bound)))
    return {symbol.name: found[symbol.name] for symbol in quantity.symbols}


def _value(symbol: Variable) -> SearchStrategy[float]:
    """Plain values first, to which others shrink, then the edges, then all over the domain, on all scales."""
    low, high = float(symbol.low), float(symbol.high)
    if symbol.whole:
        return st.integers(math.ceil(low), math.floor(high)).map(float)
    within = st.floats(low, high)
    if symbol.is_angle:
        edges: Sequence[float] = (0.0, QUARTER, -QUARTER, math.pi, -math.pi, high, low)
    elif low > 0:
        edges = (*PLAIN, low, high)
        within = st.floats(math.log10(low), math.log10(high)).map(lambda exponent: _clipped(10.0**exponent, low, high))
    else:
        edges = (0.0, *PLAIN, low, high)
    return st.sampled_from([edge for edge in edges if low <= edge <= high]) | within


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
