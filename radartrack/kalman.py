"""Kalman filters for polynomial motion with process noise, and extended updates, over any number of tracks at once.

The covariance of a track depends on what is observed, not on the values. So tracks that start from one
covariance and miss nothing share one, and it is computed once. Arrays are worked on with the tracks along the
last axis, component by component: that is fast, and the result for a track has the same bits however many
others are filtered with it. What overflows is not finite in the result, and is refused there.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from itertools import repeat
from typing import Literal, NamedTuple, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray

from radartrack._arrays import linear_motions, patterns
from radartrack._arrays.batches import fill
from radartrack._arrays.validation import (
    RealArray,
    one_of,
    real_arrays,
    require_covariance,
    require_finite,
    require_trailing_shape,
    whole_number,
)
from radartrack._conversion.sensors import AzimuthFrom
from radartrack._observation.sights import SIGHTS, Sight, SightName, site_of

UpdateOrder: TypeAlias = Literal[1, 2]

EXTENDED_BLOCK = 2048  # tracks; their factors and derivatives stay in the cache
POLYNOMIAL = ("constant_position", "constant_velocity", "constant_acceleration", "constant_jerk")


class Belief(NamedTuple):
    """Means, shape (..., n), and covariances, shape (..., n, n), or (n, n) where all tracks share one."""

    mean: RealArray
    covariance: RealArray


class Motion(NamedTuple):
    """The transition F and the covariance of the process noise Q from scan to scan, shape (n, n)."""

    transition: RealArray
    process_noise: RealArray


def constant_velocity(period: float, intensity: float) -> Motion:
    """Position and velocity of one axis, with white noise in the acceleration.

    Args:
        period: time from scan to scan [s].
        intensity: of the noise [m^2/s^3].

    """
    return polynomial_motion(1, period, intensity)


def constant_acceleration(period: float, intensity: float) -> Motion:
    """Position, velocity and acceleration of one axis, with white noise in the jerk.

    Args:
        period: time from scan to scan [s].
        intensity: of the noise [m^2/s^5].

    """
    return polynomial_motion(2, period, intensity)


def polynomial_motion(degree: int, period: float, intensity: float) -> Motion:
    """A position and its first `degree` derivatives, with white noise in the next one.

    Args:
        degree: 0 to 3.
        period: time from scan to scan [s].
        intensity: of the noise [m^2/s^(2 degree + 1)].

    Raises:
        TypeError: the degree is no whole number, or another argument no real one.
        ValueError: the degree is not from 0 to 3, the period is not positive, the intensity is negative, or the
            matrices overflow or lose their digits.

    Source: Bar-Shalom, Li & Kirubarajan 2001, 6.2.

    """
    return motion(POLYNOMIAL[whole_number("degree", degree, 0, len(POLYNOMIAL) - 1)], period, intensity=intensity)


def motion(name: str, period: float, *, axes: int = 1, **parameters: float) -> Motion:
    """A linear motion by its name, from scan to scan.

    | name | of each axis | parameters |
    |---|---|---|
    | `constant_position` to `constant_jerk` | a position and 0 to 3 derivatives | `intensity`, `std` or `jump_std` |
    | `singer` | position, velocity, acceleration | `time_constant`, `std` |
    | `ornstein_uhlenbeck` | position, velocity | `time_constant`, `intensity` |
    | `turn.known_rate` | position, velocity; two axes, (x, vx, y, vy) | `rate`, and `intensity` or `std` |

    Args:
        name: one of these.
        period: time from scan to scan [s].
        axes: how many axes move like that, each on its own, one block after the other.
        **parameters: `intensity` of white noise in the derivative after the last [m^2/s^(2n - 1), n components], or
            `std` of that derivative where it is constant over a period [m/s^n], or `jump_std` of jumps of the last one
            at each scan [m/s^(n - 1)]; for Singer `std` is that of the acceleration [m/s^2]; `time_constant` [s] after
            which a correlation is 1/e; `rate` of the turn, counter-clockwise from x to y [rad/s], 0 and less too.

    Raises:
        TypeError: an argument is no real number, the name no text, or axes no whole number.
        ValueError: the name is not known, the parameters are not those of the motion, period or time constant are not
            positive, a noise is negative, axes is not 1 to 3 (1 for a turn), or matrices overflow or lose their digits.

    """
    return Motion(*linear_motions.matrices(name, period, axes, parameters))


class _Observation(NamedTuple):
    """Independent measurements of variance one: values (m, tracks), and what they measure, (m, n, tracks or 1)."""

    values: RealArray
    rows: RealArray


class _Sensor(NamedTuple):
    """H and R, and what they are with independent errors of variance one where nothing is missing.

    Attributes:
        matrix: H, (m, n), or (m, n, tracks) where each track has its own.
        noise: R, (m, m), or (m, m, tracks) where each track has its own.
        across: the transpose of the whitening, (m, m, 1 or tracks).
        rows: what is measured then, (m, n, 1 or tracks).

    """

    matrix: RealArray
    noise: RealArray
    across: RealArray
    rows: RealArray


def predict(belief: Belief, motion: Motion) -> Belief:
    """Move beliefs by one scan.

    Raises:
        TypeError: a part is not made of real numbers.
        ValueError: the shapes do not fit, a number is not finite, a covariance is none, or the result overflows.

    """
    tracks, mean, covariance = _tracks_last(belief, ())
    with np.errstate(over="ignore", invalid="ignore"):
        moved = _predicted(mean, covariance, _checked(motion, len(mean)))
    return _tracks_first(*moved, tracks)


def update(belief: Belief, measured: ArrayLike, matrix: ArrayLike, noise: ArrayLike) -> Belief:
    """Combine beliefs with measurements, in factors (Bierman 1977), which keeps covariances positive.

    Args:
        belief: of n components.
        measured: shape (..., m); NaN where one is missing.
        matrix: H, what is measured by the state, shape (m, n).
        noise: R, the covariance of the measurement errors, shape (m, m), or (..., m, m) where tracks differ.

    Returns:
        Means, shape (..., n), and covariances, shape (..., n, n), a read-only view where all tracks share
        one.

    Raises:
        TypeError: an argument is not made of real numbers.
        ValueError: the shapes do not fit, a measurement is infinite, another number is not finite, a covariance is
            none, R is not positive definite, or the result overflows.

    """
    values, H, R = _measurement(measured, matrix, noise, np.shape(belief.mean)[-1:])
    tracks, mean, covariance = _tracks_last(belief, _common(values.shape[:-1], R.shape[:-2]))
    flat = np.broadcast_to(values, (*tracks, len(H))).reshape(-1, len(H))
    with np.errstate(over="ignore", invalid="ignore"):
        [sensor] = _sensors(H, R[..., np.newaxis, :, :] if R.ndim > 2 else R, tracks, 1)
        updated = _updated(mean, covariance, _whitened(flat.T, sensor))
    return _tracks_first(*updated, tracks)


def update_with(
    sensor: SightName,
    belief: Belief,
    measured: ArrayLike,
    noise: ArrayLike,
    order: UpdateOrder = 1,
    azimuth_from: AzimuthFrom | None = None,
    **site: ArrayLike,
) -> Belief:
    """Combine beliefs with what a sensor measured: the extended Kalman update, of first or of second order.

    With g what `rt.observe` says of the mean, J its Jacobian, G its Hessian and P the covariance, the measurement is
    that of a linear sensor J, of g, with errors of covariance R; at the second order of g + tr(G P)/2, with errors of
    covariance R + tr(G_a P G_b P)/2 (Bar-Shalom, Willett and Tian 2011). An azimuth is compared the short way round.

    A quantity that has no derivative at the mean tells nothing, as if it were missing: azimuth and elevation where the
    mean lies on the vertical axis, and all of them at the radar; the others count. Near such a place the first order
    believes too much, and the second takes the quantity for as poor as it is. A measured elevation of 90 degrees leaves
    the azimuth without meaning: let it be missing.

    Args:
        sensor: the name of a function of `rt.observe`.
        belief: of n components; the first are those that the function of this name takes, and others are not measured.
        measured: what it measures, in its order, shape (..., m); NaN where missing. Angles may be wrapped or not.
        noise: R, the covariance of the measurement errors, shape (m, m), or (..., m, m) where tracks differ.
        order: 1, extended, or 2, second-order extended.
        azimuth_from: as the function of this name takes it; None for its default. Some have none.
        site: `baseline`, shape (...), or `receiver`, shape (..., 3), where the function of this name takes it.

    Returns:
        Means, shape (..., n), and covariances, shape (..., n, n).

    Raises:
        TypeError: an argument is not made of real numbers, or a site is missing or of no use.
        ValueError: the shapes do not fit, a measurement is infinite, another number is not finite or out of place, a
            covariance is none, R is not positive definite, a word is unknown, or the result overflows.

    """
    sight = SIGHTS[one_of("sensor", sensor, SIGHTS)]
    second = whole_number("order", order, 1, 2) == 2
    places = sight.order(azimuth_from)
    arrays = real_arrays({"mean": belief.mean, "measured": measured, "noise": noise, **site_of(sight, site)})
    values, R = _measured_values(arrays, len(sight.outputs))
    size = len(sight.state)
    if arrays["mean"].shape[-1:] < (size,):
        raise ValueError(f"mean must have at least {size} components, {sight.state}; got shape {arrays['mean'].shape}")
    sight.read_state("mean", arrays["mean"][..., :size])
    there = sight.read_site(arrays)
    others = _common(values.shape[:-1], R.shape[:-2])
    for symbol, array in there.items():
        others = _common(others, array.shape, symbol)
    tracks, mean, covariance = _tracks_last(belief, others)
    spread = {
        symbol: np.broadcast_to(array, tracks).reshape(-1) if array.ndim else array for symbol, array in there.items()
    }
    seen = np.broadcast_to(values, (*tracks, len(sight.outputs))).reshape(-1, len(sight.outputs))
    errors = R if R.ndim == 2 else np.broadcast_to(R, (*tracks, *R.shape[-2:])).reshape(-1, *R.shape[-2:])
    dtype, shape = np.result_type(mean, covariance, seen, errors), (len(seen), len(mean))
    means, covariances = np.empty(shape, dtype), np.empty((*shape, len(mean)), dtype)
    look = _Look(sight, places, second, spread, errors)

    def block(own: NDArray[np.intp], new_means: RealArray, new_covariances: RealArray) -> None:
        few = covariance if covariance.shape[-1] == 1 else covariance[..., own]
        with np.errstate(over="ignore", invalid="ignore"):
            observation = look.observation(mean[:, own], few, seen[own].T, own)
            step, updated = _updated(np.zeros_like(mean[:, own]), few, observation)
        new_means[...] = (mean[:, own] + step).T
        new_covariances[...] = np.moveaxis(updated, -1, 0)

    fill(block, [np.arange(len(seen))], [means, covariances], EXTENDED_BLOCK)
    return _tracks_first(means.T, np.moveaxis(covariances, 0, -1), tracks)


def run(start: Belief, motion: Motion, measured: ArrayLike, matrix: ArrayLike, noise: ArrayLike) -> Belief:
    """Predict and update, scan by scan.

    Args:
        start: beliefs at the scan before the first measured one, of n components.
        motion: F and Q.
        measured: shape (..., scans, m); NaN where one is missing.
        matrix: H, what is measured by the state, shape (m, n).
        noise: R, the covariance of the measurement errors, shape (m, m), or (..., scans, m, m) where they differ.

    Returns:
        Means after each scan, shape (..., scans, n), and covariances, shape (..., scans, n, n), a read-only
        view where all tracks share them.

    Raises:
        TypeError: an argument is not made of real numbers.
        ValueError: the shapes do not fit, a measurement is infinite, another number is not finite, a covariance is
            none, R is not positive definite, or the result overflows.

    """
    values, H, R = _measurement(measured, matrix, noise, np.shape(start.mean)[-1:])
    if values.ndim < 2:
        raise ValueError(f"measured must have shape (..., scans, m); got shape {values.shape}")
    *others, scans = _common(values.shape[:-1], R.shape[:-2])
    tracks, mean, covariance = _tracks_last(start, tuple(others))
    checked = _checked(motion, len(mean))
    flat = np.broadcast_to(values, (*tracks, scans, len(H))).reshape(math.prod(tracks), scans, len(H))
    means = np.empty((scans, *mean.shape), mean.dtype)
    covariances = []
    with np.errstate(over="ignore", invalid="ignore"):
        sensors = zip(np.ascontiguousarray(np.moveaxis(flat, 0, -1)), _sensors(H, R, tracks, scans), strict=True)
        for number, (scan, sensor) in enumerate(sensors):
            predicted = _predicted(mean, covariance, checked)
            mean, covariance = _updated(*predicted, _whitened(scan, sensor))
            means[number] = mean
            covariances.append(covariance)
    return _tracks_first(means, _stacked(covariances, len(mean)), tracks)


class _Look(NamedTuple):
    """How a sensor looks at many tracks.

    Attributes:
        sight: what it measures.
        places: of the components, in the order in which the formulas take them.
        second: whether curvature counts.
        site: the other site, by symbol, one for all tracks or one for each.
        noise: R, (m, m) or (tracks, m, m).

    """

    sight: Sight
    places: list[int]
    second: bool
    site: dict[str, RealArray]
    noise: RealArray

    def observation(
        self, mean: RealArray, covariance: RealArray, measured: RealArray, own: NDArray[np.intp]
    ) -> _Observation:
        """What some tracks, with means (n, tracks), learn of the error of the mean from measurements (m, tracks)."""
        sight, places = self.sight, self.places
        site = {symbol: array[own] if array.ndim else array for symbol, array in self.site.items()}
        components = [mean[place] + 0.0 for place in places]
        near = sight.off_poles(components, site)
        rows = np.zeros((len(measured), *mean.shape), mean.dtype)
        jacobian = sight.evaluate("jacobian", near, site)
        rows[:, places] = np.moveaxis(jacobian, 0, -1)
        predicted = sight.evaluate("map", components, site).T
        noise = self.noise if self.noise.ndim == 2 else np.moveaxis(self.noise[own], 0, -1)
        if self.second:
            shift, spread = _curvature(sight.evaluate("hessian", near, site), covariance, places)
            predicted = predicted + shift
            noise, lost = _with_spread(noise if noise.ndim == 3 else noise[..., np.newaxis], spread)
            rows[np.swapaxes(np.broadcast_to(lost, (mean.shape[0], *lost.shape)), 0, 1)] = 0
        innovation = measured - predicted
        for place in sight.azimuths:
            innovation[place] -= 2 * np.pi * np.round(innovation[place] / (2 * np.pi))
        innovation[~rows.any(axis=1)] = np.nan
        return _whitened(innovation, _sensor_of(rows, noise))


def _curvature(hessian: RealArray, covariance: RealArray, places: list[int]) -> tuple[RealArray, RealArray]:
    """tr(G P)/2, (m, tracks), and tr(G_a P G_b P)/2, (m, m, tracks)."""
    curvature = np.ascontiguousarray(np.moveaxis(hessian, 0, -1))
    turned = _combination(np.moveaxis(curvature, 2, 0)[:, :, :, np.newaxis], covariance[np.ix_(places, places)])
    size, tracks = len(turned), turned.shape[-1]
    flat, across = (part.reshape(size, -1, tracks) for part in (turned, turned.swapaxes(1, 2)))
    spread = np.empty((size, size, tracks), turned.dtype)
    for i in range(size):
        for j in range(i + 1):
            spread[i, j] = spread[j, i] = np.einsum("pt,pt->t", flat[i], across[j]) / 2
    return np.trace(turned, axis1=1, axis2=2) / 2, spread


def _with_spread(noise: RealArray, spread: RealArray) -> tuple[RealArray, NDArray[np.bool_]]:
    """R with what curvature adds, (m, m, tracks), and what is lost in that, (m, tracks): its square overflows."""
    lost = ~(np.sqrt(np.finfo(spread.dtype).max) >= np.diagonal(spread).T)
    alone = np.eye(len(spread), dtype=spread.dtype)[..., np.newaxis]
    return np.where(lost | lost[:, np.newaxis], alone, noise + spread), lost


def _predicted(mean: RealArray, covariance: RealArray, motion: Motion) -> tuple[RealArray, RealArray]:
    F, Q = motion
    moved = _combination(F.T[:, :, np.newaxis], mean[:, np.newaxis])
    upper, variances = _factored(covariance)
    columns = _combination(F.T[:, :, np.newaxis, np.newaxis], upper[:, np.newaxis])
    return moved, _product(columns, variances) + Q[:, :, np.newaxis]


def _updated(mean: RealArray, covariance: RealArray, observation: _Observation) -> tuple[RealArray, RealArray]:
    """The belief after independent measurements of variance one, taken one by one; so no matrix is inverted."""
    factors = _factored(covariance)
    for value, row in zip(*observation, strict=True):
        gain, factors = _measured(factors, row)
        mean = mean + gain * (value - _combination(row, mean))
    told = (observation.rows != 0).any(axis=(0, 1))  # what measures nothing leaves the last bit as it was
    return mean, np.where(told, _product(*factors), covariance)


def _measured(factors: tuple[RealArray, RealArray], row: RealArray) -> tuple[RealArray, tuple[RealArray, RealArray]]:
    """The gain of a measurement of variance one, and the factors after it (Bierman 1977, V.3).

    Differences of covariances, in the form of Joseph too, turn negative where the measurement is better than what was
    believed by as many digits as a float has.
    """
    upper, variances = factors
    along = _combination(row[:, np.newaxis], upper)
    weighted = variances * along
    gain, total = np.zeros_like(weighted), np.ones_like(weighted[0])
    columns, reduced = [], []
    for place, column in enumerate(np.moveaxis(upper, 1, 0)):
        before, total = total, total + along[place] * weighted[place]
        reduced.append(variances[place] * (before / total))
        columns.append(column - gain * (along[place] / before))
        gain = gain + column * weighted[place]
    return gain / total, (np.stack(columns, axis=1), np.stack(reduced))


def _factored(covariance: RealArray) -> tuple[RealArray, RealArray]:
    """Columns U, upper triangular with a diagonal of ones, and variances D with U D U' the covariance.

    Where others determine a component but for rounding, its own variance counts as what rounding may have been: so
    nothing is believed better than the covariance can say.
    """
    size = len(covariance)
    upper, rest = np.zeros_like(covariance), covariance.copy()
    variances = np.zeros_like(covariance[0])
    for j in reversed(range(size)):
        rounding = size * np.finfo(covariance.dtype).eps * covariance[j, j]
        kept = rest[j, j] > rounding
        variances[j] = np.where(kept, rest[j, j], rounding)
        upper[:j, j] = np.where(kept, rest[:j, j], 0) / np.where(kept, rest[j, j], 1)
        upper[j, j] = 1
        rest[:j, :j] -= upper[:j, j] * upper[:j, np.newaxis, j] * variances[j]
    return upper, variances


def _product(columns: RealArray, variances: RealArray) -> RealArray:
    """Columns times variances times the columns transposed: a sum of squares, symmetric to the last bit."""
    roots = np.moveaxis(columns * np.sqrt(variances), 1, 0)
    return _combination(roots[:, np.newaxis], roots[:, :, np.newaxis])


def _combination(coefficients: RealArray, parts: RealArray) -> RealArray:
    """The sum of coefficient times part along the first axis, always in the same order."""
    total: RealArray = coefficients[0] * parts[0]
    for coefficient, part in zip(coefficients[1:], parts[1:], strict=True):
        total = total + coefficient * part
    return total


def _whitened(values: RealArray, sensor: _Sensor) -> _Observation:
    """Measurements, (m, tracks), with their errors made independent; a missing one measures nothing."""
    seen = ~np.isnan(values)
    if seen.all():
        return _Observation(_combination(sensor.across, values[:, np.newaxis]), sensor.rows)
    across = _whitening_of_each(seen, sensor.noise).swapaxes(0, 1)
    present = np.where(seen, values, 0.0)
    return _Observation(_combination(across, present[:, np.newaxis]), _rows(across, sensor.matrix))


def _sensors(matrix: RealArray, noise: RealArray, tracks: tuple[int, ...], scans: int) -> Iterator[_Sensor]:
    """The sensor at each scan, the same one where the noise is one matrix."""
    if noise.ndim == 2:
        across = _whitening(np.ones(len(noise), dtype=bool), noise).T[..., np.newaxis]
        yield from repeat(_Sensor(matrix, noise, across, _rows(across, matrix)), scans)
        return
    size = len(matrix)
    leading = (1,) if math.prod(noise.shape[:-3]) == 1 else tracks
    spread = np.broadcast_to(
        noise.reshape(1, *noise.shape[-3:]) if leading == (1,) else noise, (*leading, scans, size, size)
    )
    for part in np.moveaxis(spread, -3, 0):
        own = np.ascontiguousarray(np.moveaxis(part.reshape(-1, size, size), 0, -1))
        across = _whitening_of_each(np.ones((size, 1), dtype=bool), own).swapaxes(0, 1)
        yield _Sensor(matrix, own, across, _rows(across, matrix))


def _sensor_of(matrix: RealArray, noise: RealArray) -> _Sensor:
    """The sensor of tracks that each have an H, (m, n, tracks), and one R, (m, m), or one each, (m, m, tracks)."""
    if noise.ndim == 2:
        across = _whitening(np.ones(len(noise), dtype=bool), noise).T[..., np.newaxis]
    else:
        across = _whitening_of_each(np.ones((len(noise), 1), dtype=bool), noise).swapaxes(0, 1)
    return _Sensor(matrix, noise, across, _rows(across, matrix))


def _rows(across: RealArray, matrix: RealArray) -> RealArray:
    """What whitened measurements measure, (m, n, tracks or 1)."""
    of_each = matrix if matrix.ndim == 3 else matrix[..., np.newaxis]
    return _combination(across[:, :, np.newaxis], of_each[:, np.newaxis])


def _whitening_of_each(seen: NDArray[np.bool_], noise: RealArray) -> RealArray:
    """The whitening of each track, (m, m, tracks), from one noise for all or one for each, (m, m, tracks)."""
    if noise.ndim > 2:
        both = seen[:, np.newaxis] & seen
        alone = np.where(both, noise, np.eye(len(noise))[..., np.newaxis])
        return np.where(both, np.moveaxis(_inverse_root(np.moveaxis(alone, -1, 0)), 0, -1), 0.0)
    first, which = patterns.distinct(seen.T)
    return np.stack([_whitening(pattern, noise) for pattern in seen.T[first]], axis=-1)[..., which]


def _whitening(seen: NDArray[np.bool_], noise: RealArray) -> RealArray:
    """What makes the errors of the measurements that are seen independent, of variance one; 0 for the others."""
    result = np.zeros_like(noise)
    chosen = np.ix_(seen, seen)
    result[chosen] = _inverse_root(noise[chosen])
    return result


def _inverse_root(noise: RealArray) -> RealArray:
    """Inverses of the Cholesky factors of matrices, (..., m, m)."""
    try:
        return np.linalg.inv(np.linalg.cholesky(noise))
    except np.linalg.LinAlgError:
        raise ValueError("noise must be symmetric and positive definite; got a matrix that is not") from None


def _common(measured: tuple[int, ...], noise: tuple[int, ...], name: str = "noise") -> tuple[int, ...]:
    """The leading shape of measurements and their noise together, or of something else that is named."""
    try:
        return np.broadcast_shapes(measured, noise)
    except ValueError:
        raise ValueError(f"measured and {name} must broadcast; got leading shapes {measured} and {noise}") from None


def _tracks_last(belief: Belief, others: tuple[int, ...]) -> tuple[tuple[int, ...], RealArray, RealArray]:
    """The shape of the tracks, means (n, tracks), and covariances (n, n, tracks), or (n, n, 1) if shared."""
    arrays = real_arrays({"mean": belief.mean, "covariance": belief.covariance})
    mean, covariance = arrays["mean"], arrays["covariance"]
    if mean.ndim == 0:
        raise ValueError("mean must have shape (..., n); got a single number")
    require_finite("mean", mean)
    size = mean.shape[-1]
    require_trailing_shape("covariance", covariance, (size, size))
    try:
        tracks = np.broadcast_shapes(mean.shape[:-1], others)
        np.broadcast_to(covariance, (*tracks, size, size))
    except ValueError:
        shapes = f"{mean.shape} of mean, {covariance.shape} of covariance and {others} of the measured tracks"
        raise ValueError(f"shapes must broadcast; got {shapes}") from None
    flat = np.ascontiguousarray(np.broadcast_to(mean, (*tracks, size)).reshape(-1, size).T)
    leading = zip(covariance.strides, covariance.shape[:-2], strict=False)
    if all(length == 1 or (length > 0 and stride == 0) for stride, length in leading):
        shared = covariance[(0,) * (covariance.ndim - 2)]
        require_covariance("covariance", shared)
        return tracks, flat, shared[..., np.newaxis]
    require_covariance("covariance", covariance)
    spread = np.broadcast_to(covariance, (*tracks, size, size)).reshape(-1, size, size)
    return tracks, flat, np.ascontiguousarray(np.moveaxis(spread, 0, -1))


def _tracks_first(mean: RealArray, covariance: RealArray, tracks: tuple[int, ...]) -> Belief:
    """Means (..., n) and covariances (..., n, n) of all tracks, all of them finite."""
    means, covariances = np.moveaxis(mean, -1, 0), np.moveaxis(covariance, -1, 0)
    require_finite("the mean of the result", means)
    require_finite("the covariance of the result", covariances)
    first = means.reshape(*tracks, *means.shape[1:])
    if len(covariances) == 1:
        return Belief(first, np.broadcast_to(covariances[0], (*tracks, *covariances.shape[1:])))
    return Belief(first, covariances.reshape(*tracks, *covariances.shape[1:]))


def _stacked(covariances: list[RealArray], size: int) -> RealArray:
    """The covariances of successive scans, which are shared until a track misses something."""
    if not covariances:
        return np.empty((0, size, size, 1))
    widest = max(covariance.shape[-1] for covariance in covariances)
    return np.stack([np.broadcast_to(part, (*part.shape[:-1], widest)) for part in covariances])


def _measurement(
    measured: ArrayLike, matrix: ArrayLike, noise: ArrayLike, size: tuple[int, ...]
) -> tuple[RealArray, RealArray, RealArray]:
    arrays = real_arrays({"measured": measured, "matrix": matrix, "noise": noise})
    H = arrays["matrix"]
    if H.ndim != 2 or not H.size or not np.isfinite(H).all():
        raise ValueError(f"matrix must be finite, of shape (m, n), neither of them 0; got {H.tolist()}")
    if H.shape[1:] != size:
        raise ValueError(f"matrix must have {size[0]} columns, one a component; got {H.shape[1]}")
    values, R = _measured_values(arrays, len(H))
    return values, H, R


def _measured_values(arrays: dict[str, RealArray], size: int) -> tuple[RealArray, RealArray]:
    values, R = arrays["measured"], arrays["noise"]
    require_trailing_shape("noise", R, (size, size))
    require_trailing_shape("measured", values, (size,))
    if np.isinf(values).any():
        raise ValueError(f"measured must be finite, or NaN where missing; got {np.isinf(values).sum()} infinite")
    require_finite("noise", R)
    if not np.array_equal(R, np.swapaxes(R, -1, -2)):
        raise ValueError("noise must be symmetric and positive definite; got a matrix that is not")
    return values, R


def _checked(motion: Motion, size: int) -> Motion:
    arrays = real_arrays({"transition": motion.transition, "process_noise": motion.process_noise})
    for name, array in arrays.items():
        if array.shape != (size, size) or not np.isfinite(array).all():
            raise ValueError(f"{name} must be finite, of shape ({size}, {size}); got {array.tolist()}")
    require_covariance("process_noise", arrays["process_noise"])
    return Motion(arrays["transition"], arrays["process_noise"])
