"""The first state of a track: position and velocity, with their covariance, from one plot or from two.

One plot tells the position and, with a range rate, the radial velocity. What it does not tell is what is known of all
targets: each component of a velocity has the mean 0 and one standard deviation. If all that is known is a highest
speed, every velocity up to it as likely as another, that deviation is the highest speed over 2 in the plane, and over
sqrt(5) in space. Given plot and prior the mean and covariance are exact for closed forms, angles of any error included.

Two plots tell the velocity as the difference of the positions over the time between them, with no prior. Their range
rates are then used one after the other, by second-order extended updates.

The plots have the names of the arguments of the conversions, and what `rt.simulate` makes has them too:

    rt.initiate.one_plot("polar_doppler", {**measured, **radar.noise}, velocity_std=100.0)
"""

from collections.abc import Callable, Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from radartrack import convert, observe
from radartrack._arrays.batches import fill
from radartrack._arrays.validation import (
    DOUBLE,
    Domain,
    RealArray,
    broadcast_shape,
    by_name,
    one_of,
    real_arrays,
    require_finite,
    require_within,
)
from radartrack._conversion.semidefinite import cast, roots, squares
from radartrack._conversion.sensors import SENSORS, AzimuthFrom, Sensor, SensorName
from radartrack.convert import Converted
from radartrack.generated import initiation as formulas
from radartrack.kalman import Belief

__all__ = ["one_plot", "two_plots"]


def __dir__() -> list[str]:
    return __all__


VELOCITY_STD = Domain(" m/s", 1e6, 1e6, "no target is so fast", smallest=1e-3)
PERIOD = Domain(" s", 1e9, 1e9, "plots farther apart belong to no track", smallest=1e-6)
_WITHOUT_RATE: Mapping[SensorName, SensorName] = {"polar_doppler": "polar", "spherical_doppler": "spherical"}
_RATE = ("range_rate", "range_rate_std", "correlation")
_TOLD_BY_RATE = ("r", "range_std", *_RATE)
BLOCK = 1024  # tracks; their second derivatives stay in the cache

Plot = Mapping[str, ArrayLike]


def one_plot(
    sensor: SensorName, plot: Plot, velocity_std: ArrayLike, azimuth_from: AzimuthFrom | None = None
) -> Belief:
    """Start tracks from one plot each.

    Args:
        sensor: a conversion's name.
        plot: the arguments of the conversion of this name, by name; all broadcast. `correlation` is 0 if left out.
        velocity_std: what is known before of each component of the velocity, its standard deviation [m/s], from 1e-3
            to 1e6.
        azimuth_from: as the conversion takes it; None for its default. "ruv" has none.

    Returns:
        Means (x, y, vx, vy) or (x, y, z, vx, vy, vz) [m, m/s], shape (..., n), and covariances, shape (..., n, n),
        given the plot. Where the errors of range and range rate are correlated, what is known of the velocity tells
        of the range too.

    Raises:
        TypeError: an argument is missing, is none of the conversion's, or is not made of real numbers.
        ValueError: a number is out of place, the shapes do not broadcast, or the word is unknown.

    Source: Bar-Shalom, Li & Kirubarajan 2001, one-point initialisation, doi:10.1002/0471221279; here exact for errors
    of any size.

    """
    model = SENSORS[one_of("sensor", sensor, SENSORS)]
    arrays = real_arrays({**_read(model, plot), "velocity_std": velocity_std})
    model.chosen_axis(azimuth_from)
    require_within("velocity_std", arrays["velocity_std"], VELOCITY_STD)
    shape = broadcast_shape(arrays)
    if "range_rate" not in model.coordinates:
        return _without_rate(model, arrays, shape, azimuth_from)
    values = {**model.read({name: arrays[name] for name in model.arguments}), "sigma_v": arrays["velocity_std"]}
    found: list[RealArray] = []
    for moment in ("estimate", "covariance"):
        formula: Callable[..., RealArray] = getattr(formulas, f"one_plot_{model.module}_{moment}")
        found.append(formula(**values))
    mean, covariance = _oriented(model, azimuth_from, *found)
    return Belief(mean, cast(covariance, covariance.dtype))


def two_plots(
    sensor: SensorName, first: Plot, second: Plot, period: ArrayLike, azimuth_from: AzimuthFrom | None = None
) -> Belief:
    """Start tracks from two plots each, at the time of the second.

    Args:
        sensor: a conversion's name.
        first: the arguments of the conversion of this name, by name; all broadcast. `correlation` is 0 if left out.
        second: likewise.
        period: the time from the first plot to the second [s], from 1e-6 to 1e9.
        azimuth_from: as the conversion takes it; None for its default. "ruv" has none.

    Returns:
        Means (x, y, vx, vy) or (x, y, z, vx, vy, vz) [m, m/s], shape (..., n), and covariances, shape (..., n, n): of
        the second position and of the difference over the period, given plots whose errors are independent of each
        other and of a target that flies straight from one to the other; then, of plots with a range rate, after that of
        the first and of the second. Computed in float64, and in float32 where every array given is.

    Raises:
        TypeError: as for `one_plot`.
        ValueError: as for `one_plot`; also where a result overflows.

    Source: Bar-Shalom, Li & Kirubarajan 2001, two-point differencing, doi:10.1002/0471221279; the range rates by the
    second-order extended Kalman filter of Bar-Shalom, Willett & Tian 2011.

    """
    model = SENSORS[one_of("sensor", sensor, SENSORS)]
    axis = model.chosen_axis(azimuth_from)
    both = {
        f"{name} of {word}": value
        for word, plot in (("first", first), ("second", second))
        for name, value in _read(model, plot).items()
    }
    dtype = real_arrays({"period": period, **both})["period"].dtype
    plots = [_doubled(model, _arrays(model, plot)) for plot in (first, second)]
    T = real_arrays({"period": period})["period"].astype(np.float64)
    require_within("period", T, PERIOD)
    broadcast_shape({**{f"{name} of first": a for name, a in plots[0].items()}, **plots[1], "period": T})
    (p1, c1), (p2, c2) = (_position(model, plot, axis) for plot in plots)
    if "range_rate" not in model.coordinates:
        return _finite(*_difference(p1, c1, p2, c2, T), dtype)
    return _finite(*_with_rates(model, ((p1, c1), (p2, c2)), plots, T, axis), dtype)


def _read(model: Sensor, plot: Plot) -> dict[str, ArrayLike]:
    given = {"correlation": 0.0} | by_name("a plot", plot)
    if set(given) != set(model.arguments):
        raise TypeError(f"a plot must have the arguments {[*model.arguments]}; got {sorted(plot)}")
    return {name: given[name] for name in model.arguments}


def _arrays(model: Sensor, plot: Plot) -> dict[str, RealArray]:
    arrays = real_arrays(_read(model, plot))
    model.read(arrays)
    return arrays


def _doubled(model: Sensor, arrays: Mapping[str, RealArray]) -> dict[str, RealArray]:
    """In float64, in which an elevation of 90 degrees in float32 is beyond the vertical."""
    return {
        name: np.clip(values.astype(np.float64), *model.arguments[name].domain.bounds(DOUBLE))
        for name, values in arrays.items()
    }


def _without_rate(
    model: Sensor, arrays: Mapping[str, RealArray], shape: tuple[int, ...], azimuth_from: AzimuthFrom | None
) -> Belief:
    """The position as the posterior conversion has it, and of the velocity what was known before."""
    position, spread = _position(model, arrays, model.chosen_axis(azimuth_from))
    size = position.shape[-1]
    mean = np.zeros((*shape, 2 * size), position.dtype)
    covariance = np.zeros((*shape, 2 * size, 2 * size), position.dtype)
    mean[..., :size], covariance[..., :size, :size] = position, spread
    velocities = range(size, 2 * size)
    covariance[..., velocities, velocities] = arrays["velocity_std"][..., np.newaxis] ** 2
    return Belief(mean, covariance)


def _position(model: Sensor, plot: Mapping[str, RealArray], axis: AzimuthFrom | None) -> Converted:
    """Mean and covariance of the position, given the plot without a range rate."""
    name = _WITHOUT_RATE.get(model.module, model.module)
    left_out = _RATE if name != model.module else ()
    arguments = {key: plot[key] for key in model.arguments if key not in left_out}
    function: Callable[..., Converted] = getattr(convert, name)
    return function(**arguments, method="posterior", **({} if axis is None else {"azimuth_from": axis}))


def _oriented(
    model: Sensor, azimuth_from: AzimuthFrom | None, mean: RealArray, covariance: RealArray
) -> tuple[RealArray, RealArray]:
    """With x and y exchanged, and vx and vy, where the azimuth is counted from the other axis."""
    if not model.is_turned(model.chosen_axis(azimuth_from)):
        return mean, covariance
    size = mean.shape[-1] // 2
    order = [1, 0, *range(2, size)]
    order += [size + place for place in order]
    return mean[..., order], covariance[..., order, :][..., order]


def _difference(first: RealArray, of_first: RealArray, second: RealArray, of_second: RealArray, T: RealArray) -> Belief:
    """Position and velocity at the second of two positions, with their covariance."""
    per_axis = formulas.two_plots_estimate(first=first, second=second, T=T[..., np.newaxis])
    per_pair = formulas.two_plots_covariance(
        first_covariance=of_first, second_covariance=of_second, T=T[..., np.newaxis, np.newaxis]
    )
    size = 2 * first.shape[-1]
    mean = np.swapaxes(per_axis, -1, -2).reshape(*per_axis.shape[:-2], size)
    together = np.moveaxis(per_pair, [-2, -4, -1, -3], [-4, -3, -2, -1])
    return Belief(mean, together.reshape(*per_pair.shape[:-4], size, size))


def _with_rates(
    model: Sensor,
    positions: Sequence[tuple[RealArray, RealArray]],
    plots: Sequence[Mapping[str, RealArray]],
    T: RealArray,
    axis: AzimuthFrom | None,
) -> Belief:
    """Position and velocity at the second of two positions, then after the range rates of both plots, in blocks."""
    told = [plot[name] for plot in plots for name in _TOLD_BY_RATE]
    leading = [(mean.shape[:-1], covariance.shape[:-2]) for mean, covariance in positions]
    shape = np.broadcast_shapes(T.shape, *(array.shape for array in told), *leading[0], *leading[1])
    flat = [_flat(array, shape, axes) for pair in positions for axes, array in enumerate(pair, start=1)]
    flat += [_flat(array, shape, 0) for array in (T, *told)]
    size = 2 * positions[0][0].shape[-1]
    means, covariances = np.empty((len(flat[0]), size)), np.empty((len(flat[0]), size, size))

    def block(*arrays: RealArray) -> None:
        p1, c1, p2, c2, period, *rates, mean, covariance = arrays
        pair = _Pair(np.concatenate([p1, p2], axis=-1), _side_by_side(c1, c2), period)
        with np.errstate(over="ignore", invalid="ignore", divide="ignore"):  # what overflows is refused
            for place in range(len(plots)):
                own = rates[place * len(_TOLD_BY_RATE) :]
                pair = _with_rate(model, pair, place, dict(zip(_TOLD_BY_RATE, own, strict=False)), axis)
            mean[...], root = pair.state(1)
            covariance[...] = squares(root)

    fill(block, flat, [means, covariances], BLOCK)
    return Belief(means.reshape(*shape, size), covariances.reshape(*shape, size, size))


def _flat(array: RealArray, shape: tuple[int, ...], axes: int) -> RealArray:
    """An array with its leading shape broadcast and made one axis; the last axes stay as they are."""
    last = array.shape[array.ndim - axes :]
    return np.broadcast_to(array, (*shape, *last)).reshape(-1, *last)


class _Pair(NamedTuple):
    """Two positions of a target, of which its velocity is the difference over the period.

    The covariance is a root times its transpose: however exact a range rate is, it stays positive semidefinite, and
    what a plot says of its own position is not lost beside a plot that says little.

    Attributes:
        mean: of both positions, one after the other, shape (..., 2n).
        root: shape (..., 2n, 2n).
        T: the period, shape (...).
    """

    mean: RealArray
    root: RealArray
    T: RealArray

    def state(self, place: int) -> tuple[RealArray, RealArray]:
        """Position and velocity at one of the plots, shape (..., 2n), and the root of their covariance."""
        size = self.mean.shape[-1] // 2
        parts = []
        for rows in (self.mean[..., np.newaxis], self.root):
            both = rows[..., :size, :], rows[..., size:, :]
            velocity = (both[1] - both[0]) / self.T[..., np.newaxis, np.newaxis]
            parts.append(np.concatenate(np.broadcast_arrays(both[place], velocity), axis=-2))
        return parts[0][..., 0], parts[1]


def _side_by_side(first: RealArray, second: RealArray) -> RealArray:
    """The root of the covariance of what is independent."""
    size = first.shape[-1]
    root = np.zeros((*np.broadcast_shapes(first.shape[:-2], second.shape[:-2]), 2 * size, 2 * size))
    root[..., :size, :size], root[..., size:, size:] = roots(first), roots(second)
    return root


def _with_rate(
    model: Sensor, pair: _Pair, place: int, plot: Mapping[str, RealArray], axis: AzimuthFrom | None
) -> _Pair:
    """A second-order extended update with the range rate of a plot whose range the pair holds already.

    The error of the range rate is a multiple of that of the range, and one that is independent of it: so what is new is
    the range rate less that multiple of the range. The root is updated as by Potter (Battin 1964).
    """
    mean, root = pair.state(place)
    r_std, rate_std, correlation = (plot[name] for name in ("range_std", "range_rate_std", "correlation"))
    multiple = correlation * rate_std / np.where(r_std > 0, r_std, np.inf)
    own = rate_std**2 * np.where(r_std > 0, (1 - correlation) * (1 + correlation), 1)
    see: Callable[..., observe.Observed] = getattr(observe, model.module)
    g, J, G = see(mean, azimuth_from=axis)
    expected = g[..., -1] - multiple * g[..., 0]
    row = J[..., -1, :] - multiple[..., np.newaxis] * J[..., 0, :]
    curvature = G[..., -1, :, :] - multiple[..., np.newaxis, np.newaxis] * G[..., 0, :, :]
    turned = np.swapaxes(root, -1, -2) @ curvature @ root
    innovation = plot["range_rate"] - multiple * plot["r"] - expected - np.trace(turned, axis1=-2, axis2=-1) / 2
    along = (row[..., np.newaxis, :] @ root)[..., 0, :]
    unknown = (turned**2).sum(axis=(-2, -1)) / 2 + own
    total = (along**2).sum(axis=-1) + unknown
    weight = along / np.where(total == 0, 1, total)[..., np.newaxis]
    step = (pair.root @ weight[..., np.newaxis])[..., 0]
    share = 1 / (1 + np.sqrt(unknown / np.where(total == 0, 1, total)))
    reduced = pair.root - step[..., np.newaxis] * (share[..., np.newaxis] * along)[..., np.newaxis, :]
    return pair._replace(mean=pair.mean + step * innovation[..., np.newaxis], root=reduced)


def _finite(mean: RealArray, covariance: RealArray, dtype: np.dtype[Any]) -> Belief:
    with np.errstate(over="ignore", invalid="ignore"):  # what overflows is refused
        mean, covariance = mean.astype(dtype), cast(covariance, dtype)
    require_finite("the mean of the result", mean)
    require_finite("the covariance of the result", covariance)
    return Belief(mean, covariance)
