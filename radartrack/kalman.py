"""Kalman filters, plain and extended, over any number of tracks at once.

The covariance of a track depends on what is observed, not on the values. So tracks that start from one
covariance and miss nothing share one, and it is computed once. Arrays are worked on with the tracks along the
last axis, component by component: that is fast, and the result for a track has the same bits however many
others are filtered with it. What overflows is not finite in the result, and is refused there.
"""

from __future__ import annotations

import math
from typing import Literal, TypeAlias

import numpy as np
from numpy.typing import ArrayLike

from radartrack._arrays import linear_motions
from radartrack._arrays.validation import (
    RealArray,
    one_of,
    real_arrays,
    whole_number,
)
from radartrack._conversion.sensors import AzimuthFrom
from radartrack._filtering.beliefs import (
    Belief,
    Motion,
    checked_motion,
    common,
    flat_tracks,
    in_blocks,
    measured_values,
    require_belief,
    tracks_first,
    tracks_last,
)
from radartrack._filtering.elimination import checked_covariances
from radartrack._filtering.extended import Look
from radartrack._filtering.factors import updated, widened
from radartrack._filtering.moved_beliefs import predicted
from radartrack._filtering.nonlinear_motion import GROUPINGS, Grouping, NonlinearMotion, known_motion
from radartrack._filtering.refinement import refined
from radartrack._filtering.whitening import sensors, whitened
from radartrack._observation.sights import SIGHTS, SightName, site_of

__all__ = [
    "POLYNOMIAL",
    "Belief",
    "Motion",
    "NonlinearMotion",
    "constant_acceleration",
    "constant_velocity",
    "motion",
    "nonlinear_motion",
    "polynomial_motion",
    "predict",
    "run",
    "run_with",
    "update",
    "update_with",
]


def __dir__() -> list[str]:
    return __all__


Order: TypeAlias = Literal[1, 2]

POLYNOMIAL = ("constant_position", "constant_velocity", "constant_acceleration", "constant_jerk")


def constant_velocity(period: float, intensity: float) -> Motion:
    """Position and velocity of one axis, with white noise in the acceleration.

    Args:
        period: time from scan to scan [s].
        intensity: of the noise [m^2/s^3].

    Returns:
        F and Q, shape (2, 2).

    Raises:
        TypeError: an argument is no real number.
        ValueError: as `polynomial_motion`.

    Source: Bar-Shalom, Li & Kirubarajan 2001, 6.2.2, doi:10.1002/0471221279.

    """
    return polynomial_motion(1, period, intensity)


def constant_acceleration(period: float, intensity: float) -> Motion:
    """Position, velocity and acceleration of one axis, with white noise in the jerk.

    Args:
        period: time from scan to scan [s].
        intensity: of the noise [m^2/s^5].

    Returns:
        F and Q, shape (3, 3).

    Raises:
        TypeError: an argument is no real number.
        ValueError: as `polynomial_motion`.

    Source: Bar-Shalom, Li & Kirubarajan 2001, 6.2.3, doi:10.1002/0471221279.

    """
    return polynomial_motion(2, period, intensity)


def polynomial_motion(degree: int, period: float, intensity: float) -> Motion:
    """A position and its first `degree` derivatives, with white noise in the next one.

    Args:
        degree: 0 to 3.
        period: time from scan to scan [s].
        intensity: of the noise [m^2/s^(2 degree + 1)].

    Returns:
        F and Q, shape (degree + 1, degree + 1).

    Raises:
        TypeError: the degree is no whole number, or another argument no real one.
        ValueError: the degree is not from 0 to 3, the period is not positive, the intensity is negative, or the
            matrices overflow or lose their digits.

    Source: Bar-Shalom, Li & Kirubarajan 2001, 6.2, doi:10.1002/0471221279.

    """
    return motion(POLYNOMIAL[whole_number("degree", degree, 0, len(POLYNOMIAL) - 1)], period, intensity=intensity)


def motion(name: str, period: float, *, axes: int = 1, grouped: Grouping = "axis", **parameters: float) -> Motion:
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
        axes: how many axes move like that, each on its own.
        grouped: "axis" for one axis after the other, (x, vx, y, vy), or "derivative" for positions first, (x, y, vx,
            vy), as `update_with` and `rt.initiate` have them.
        **parameters: `intensity` of white noise in the derivative after the last [m^2/s^(2n - 1), n components], or
            `std` of that derivative where it is constant over a period [m/s^n], or `jump_std` of jumps of the last one
            at each scan [m/s^(n - 1)]; for Singer `std` is that of the acceleration [m/s^2]; `time_constant` [s] after
            which a correlation is 1/e; `rate` of the turn, counter-clockwise from x to y [rad/s], 0 and less too.

    Returns:
        F and Q, shape (n, n), n the components of all axes.

    Raises:
        TypeError: an argument is no real number, the name or the grouping no text, or axes no whole number.
        ValueError: the name is not known, the parameters are not those of the motion, period or time constant are not
            positive, a noise is negative, axes is not 1 to 3 (1 for a turn), or matrices overflow or lose their digits.

    Source: Bar-Shalom, Li & Kirubarajan 2001, 6.2-6.3 and 11.7, doi:10.1002/0471221279; Singer 1970,
    doi:10.1109/TAES.1970.310128; Uhlenbeck & Ornstein 1930, doi:10.1103/PhysRev.36.823.

    """
    F, Q = linear_motions.matrices(name, period, axes, parameters)
    if one_of("grouped", grouped, GROUPINGS) == "derivative":
        blocks = 2 if name.startswith("turn.") else axes
        order = np.arange(len(F)).reshape(blocks, -1).T.ravel()
        F, Q = (matrix[np.ix_(order, order)] for matrix in (F, Q))
    return Motion(F, Q)


def nonlinear_motion(
    name: str, period: float, *, std: float, turn_std: float, grouped: Grouping = "axis"
) -> NonlinearMotion:
    """A motion whose rate of turn belongs to the state, from scan to scan.

    | name | state | `std` is of |
    |---|---|---|
    | `turn.unknown_rate` | (x, vx, y, vy, omega) | the acceleration along each axis |
    | `ctrv` | (x, y, speed, heading, omega) | the acceleration along the heading |

    Args:
        name: one of these.
        period: time from scan to scan [s].
        std: standard deviation of the acceleration, constant over a period [m/s^2].
        turn_std: standard deviation of the acceleration of the turn, constant over a period [rad/s^2].
        grouped: as `motion` takes it: "derivative" for (x, y, vx, vy, omega); `ctrv` has one order.

    Returns:
        The functions of the motion, of states (..., 5).

    Raises:
        TypeError: an argument is no real number, or a word no text.
        ValueError: a word is not known, the period is not positive, or a deviation is negative.

    Source: Bar-Shalom, Li & Kirubarajan 2001, 11.7, doi:10.1002/0471221279; the noise is what the accelerations leave
    to first order, `motion.turn.unknown_rate.process_noise.piecewise` and `motion.ctrv.process_noise.piecewise`.

    """
    return known_motion(name, period, std, turn_std, grouped)


def predict(belief: Belief, motion: Motion | NonlinearMotion, order: Order = 1) -> Belief:
    """Move beliefs by one scan.

    Args:
        belief: of n components.
        motion: of `motion`, of `nonlinear_motion`, or made of functions of one's own.
        order: for a nonlinear motion 1, extended, or 2, second-order extended: mean and covariance of its quadratic
            Taylor polynomial. Of a linear one both are the same.

    Returns:
        Means, shape (..., n), and covariances, shape (..., n, n), a read-only view where all tracks share one.

    Raises:
        TypeError: a part is not made of real numbers.
        ValueError: the shapes do not fit, a number is not finite, a covariance is none, or the result overflows.

    Source: Bar-Shalom, Li & Kirubarajan 2001, 5.2 and 10.3, doi:10.1002/0471221279.

    """
    second = whole_number("order", order, 1, 2) == 2
    require_belief("belief", belief)
    tracks, mean, covariance = flat_tracks(belief, ())
    checked = _checked(motion, mean.shape[-1])

    def step(at: RealArray, believed: RealArray, _: slice = slice(None)) -> tuple[RealArray, RealArray]:
        return predicted(at, believed, checked, second=second)

    if not isinstance(checked, NonlinearMotion):
        dtype = np.result_type(mean, *checked)
        mean = mean.astype(dtype, copy=False)
        if len(covariance) > 1:
            means, covariances = in_blocks(mean, covariance, step)
            return Belief(
                means.reshape(*tracks, *means.shape[1:]), covariances.reshape(*tracks, *covariances.shape[1:])
            )
    last = np.ascontiguousarray(np.moveaxis(covariance, 0, -1))
    with np.errstate(over="ignore", invalid="ignore"):
        moved = step(np.ascontiguousarray(mean.T), widened(checked_covariances("covariance", last), mean.dtype))
    return tracks_first(*moved, tracks)


def update(belief: Belief, measured: ArrayLike, matrix: ArrayLike, noise: ArrayLike) -> Belief:
    """Combine beliefs with measurements, in factors (Bierman 1977), which keeps covariances positive.

    Args:
        belief: of n components.
        measured: shape (..., m); NaN where one is missing.
        matrix: H, what is measured by the state, shape (m, n).
        noise: R, the covariance of the measurement errors, shape (m, m), or (..., m, m) where tracks differ; they
            may be fully correlated.

    Returns:
        Means, shape (..., n), and covariances, shape (..., n, n), a read-only view where all tracks share
        one.

    Raises:
        TypeError: an argument is not made of real numbers.
        ValueError: the shapes do not fit, a measurement is infinite, another number is not finite, a covariance is
            none, a variance of R is 0, or the result overflows.

    Source: Bierman 1977, V.3.

    """
    require_belief("belief", belief)
    values, H, R = _measurement(measured, matrix, noise, belief)
    tracks, mean, covariance = tracks_last(belief, common(values.shape[:-1], R.shape[:-2]), values.dtype)
    flat = np.broadcast_to(values, (*tracks, len(H))).reshape(-1, len(H))
    with np.errstate(over="ignore", invalid="ignore"):
        [sensor] = sensors(H, R[..., np.newaxis, :, :] if R.ndim > 2 else R, tracks, 1)
        after = updated(mean, covariance, whitened(flat.T, sensor))
    return tracks_first(*after, tracks)


def update_with(
    sensor: SightName,
    belief: Belief,
    measured: ArrayLike,
    noise: ArrayLike,
    order: Order = 1,
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
        noise: R, the covariance of the measurement errors, shape (m, m), or (..., m, m) where tracks differ; they
            may be fully correlated.
        order: 1, extended, or 2, second-order extended.
        azimuth_from: as the function of this name takes it; None for its default. Some have none.
        site: `baseline`, shape (...), or `receiver`, shape (..., 3), where the function of this name takes it.

    Returns:
        Means, shape (..., n), and covariances, shape (..., n, n).

    Raises:
        TypeError: an argument is not made of real numbers, or a site is missing or of no use.
        ValueError: the shapes do not fit, a measurement is infinite, another number is not finite or out of place, a
            covariance is none, a variance of R is 0, a word is unknown, or the result overflows.

    Source: Bar-Shalom, Willett & Tian 2011, first- and second-order extended Kalman filter.

    """
    sight = SIGHTS[one_of("sensor", sensor, SIGHTS)]
    second = whole_number("order", order, 1, 2) == 2
    places = sight.order(azimuth_from)
    require_belief("belief", belief)
    arrays = real_arrays({"mean": belief.mean, "measured": measured, "noise": noise, **site_of(sight, site)})
    values, R = measured_values(arrays["measured"], noise, len(sight.outputs))
    size = len(sight.state)
    if arrays["mean"].shape[-1:] < (size,):
        raise ValueError(f"mean must have at least {size} components, {sight.state}; got shape {arrays['mean'].shape}")
    sight.read_state("mean", arrays["mean"][..., :size])
    there = sight.read_site(arrays)
    others = common(values.shape[:-1], R.shape[:-2])
    for symbol, array in there.items():
        others = common(others, array.shape, symbol)
    tracks, mean, covariance = flat_tracks(belief, others)
    spread = {
        symbol: np.broadcast_to(array, tracks).reshape(-1) if array.ndim else array for symbol, array in there.items()
    }
    seen = np.broadcast_to(values, (*tracks, len(sight.outputs))).reshape(-1, len(sight.outputs))
    errors = R if R.ndim == 2 else np.broadcast_to(R, (*tracks, *R.shape[-2:])).reshape(-1, *R.shape[-2:])
    dtype = np.result_type(mean, covariance, seen, errors)
    mean, seen, errors = (array.astype(dtype, copy=False) for array in (mean, seen, errors))
    look = Look(sight, places, second, spread, errors)

    def step(at: RealArray, believed: RealArray, own: slice) -> tuple[RealArray, RealArray]:
        moved, reduced = refined(believed, look.told(at, believed, seen[own].T, own))
        return at + moved, reduced

    means, covariances = in_blocks(mean, covariance, step)
    return Belief(means.reshape(*tracks, *means.shape[1:]), covariances.reshape(*tracks, *covariances.shape[1:]))


def run(
    start: Belief,
    motion: Motion | NonlinearMotion,
    measured: ArrayLike,
    matrix: ArrayLike,
    noise: ArrayLike,
    order: Order = 1,
) -> Belief:
    """Predict and update, scan by scan.

    Args:
        start: beliefs at the scan before the first measured one, of n components.
        motion: as `predict` takes it.
        measured: shape (..., scans, m); NaN where one is missing.
        matrix: H, what is measured by the state, shape (m, n).
        noise: R, the covariance of the measurement errors, shape (m, m), or (..., scans, m, m) where they differ; they
            may be fully correlated.
        order: as `predict` takes it.

    Returns:
        Means after each scan, shape (..., scans, n), and covariances, shape (..., scans, n, n), a read-only
        view where all tracks share them.

    Raises:
        TypeError: an argument is not made of real numbers.
        ValueError: the shapes do not fit, a measurement is infinite, another number is not finite, a covariance is
            none, a variance of R is 0, or the result overflows.

    Source: Bar-Shalom, Li & Kirubarajan 2001, 5.2, doi:10.1002/0471221279; Bierman 1977, V.3.

    """
    second = whole_number("order", order, 1, 2) == 2
    require_belief("start", start)
    values, H, R = _measurement(measured, matrix, noise, start)
    if values.ndim < 2:
        raise ValueError(f"measured must have shape (..., scans, m); got shape {values.shape}")
    *others, scans = common(values.shape[:-1], R.shape[:-2])
    checked = _checked(motion, H.shape[1])
    dtype = np.result_type(values, *(() if isinstance(checked, NonlinearMotion) else checked))
    values, H, R = (array.astype(dtype, copy=False) for array in (values, H, R))
    tracks, mean, covariance = tracks_last(start, tuple(others), dtype)
    flat = np.broadcast_to(values, (*tracks, scans, len(H))).reshape(math.prod(tracks), scans, len(H))
    means = np.empty((scans, *mean.shape), mean.dtype)
    covariances = []
    with np.errstate(over="ignore", invalid="ignore"):
        looks = zip(np.ascontiguousarray(np.moveaxis(flat, 0, -1)), sensors(H, R, tracks, scans), strict=True)
        for number, (scan, sensor) in enumerate(looks):
            before = predicted(mean, covariance, checked, second=second)
            mean, covariance = updated(*before, whitened(scan, sensor))
            means[number] = mean
            covariances.append(covariance)
    return tracks_first(means, _stacked(covariances, len(mean)), tracks)


def run_with(
    sensor: SightName,
    start: Belief,
    motion: Motion | NonlinearMotion,
    measured: ArrayLike,
    noise: ArrayLike,
    order: Order = 1,
    azimuth_from: AzimuthFrom | None = None,
    **site: ArrayLike,
) -> Belief:
    """Predict and update with what a sensor measured, scan by scan: an extended Kalman filter.

    A range rate that is far better than the velocity across times the error of an angle makes it too sure, of either
    order; the documents on tracks have numbers, and say what helps.

    Args:
        sensor: the name of a function of `rt.observe`.
        start: beliefs at the scan before the first measured one, of n components, in the order of `update_with`.
        motion: as `predict` takes it, in that order too: `grouped="derivative"` makes it so.
        measured: what the sensor measures, in its order, shape (..., scans, m); NaN where missing.
        noise: R, the covariance of the measurement errors, shape (m, m), or (..., scans, m, m) where they differ; they
            may be fully correlated.
        order: 1, extended, or 2, second-order extended, of motion and sensor.
        azimuth_from: as `update_with` takes it.
        site: as `update_with` takes it.

    Returns:
        Means after each scan, shape (..., scans, n), and covariances, shape (..., scans, n, n).

    Raises:
        TypeError: as `update_with`.
        ValueError: as `update_with` and `predict`.

    Source: Bar-Shalom, Willett & Tian 2011, first- and second-order extended Kalman filter.

    """
    sight = SIGHTS[one_of("sensor", sensor, SIGHTS)]
    require_belief("start", start)
    given = {"mean": start.mean, "covariance": start.covariance, "measured": measured, "noise": noise}
    arrays = real_arrays({**given, **site_of(sight, site)})
    values, R = measured_values(arrays["measured"], noise, len(sight.outputs))
    if values.ndim < 2:
        raise ValueError(f"measured must have shape (..., scans, m); got shape {values.shape}")
    *leading, scans = common(values.shape[:-1], R.shape[:-2])
    others = tuple(leading)
    for symbol, array in sight.read_site(arrays).items():
        others = common(others, array.shape, symbol)
    tracks, mean, covariance = flat_tracks(start, others)
    size = mean.shape[-1]
    values = np.broadcast_to(values, (*others, scans, len(sight.outputs)))
    checked = _checked(motion, size)
    dtype = np.result_type(values, *(() if isinstance(checked, NonlinearMotion) else checked))
    spread = np.broadcast_to(covariance, (len(mean), size, size)).reshape(*tracks, size, size)
    belief = Belief(mean.reshape(*tracks, size).astype(dtype), spread)
    means, covariances = np.empty((*tracks, scans, size), dtype), np.empty((*tracks, scans, size, size), dtype)
    if not scans:  # what is out of place is refused all the same
        nothing, errors = np.full(len(sight.outputs), np.nan), R if R.ndim == 2 else np.eye(len(sight.outputs))
        update_with(sensor, predict(belief, motion, order), nothing, errors, order, azimuth_from, **site)
    for number in range(scans):
        errors = R if R.ndim == 2 else R[..., number if R.shape[-3] > 1 else 0, :, :]
        before = predict(belief, motion, order)
        belief = update_with(sensor, before, values[..., number, :], errors, order, azimuth_from, **site)
        means[..., number, :], covariances[..., number, :, :] = belief
    return Belief(means, covariances)


def _checked(motion: Motion | NonlinearMotion, size: int) -> Motion | NonlinearMotion:
    """A motion of so many components."""
    if not isinstance(motion, NonlinearMotion):
        return checked_motion(motion, size)
    if motion.size != size:
        raise ValueError(f"mean must have the {motion.size} components of the motion; got {size}")
    return motion


def _stacked(covariances: list[RealArray], size: int) -> RealArray:
    """The covariances of successive scans, which are shared until a track misses something."""
    if not covariances:
        return np.empty((0, size, size, 1))
    widest = max(covariance.shape[-1] for covariance in covariances)
    return np.stack([np.broadcast_to(part, (*part.shape[:-1], widest)) for part in covariances])


def _measurement(
    measured: ArrayLike, matrix: ArrayLike, noise: ArrayLike, belief: Belief
) -> tuple[RealArray, RealArray, RealArray]:
    """What is measured, H and R, in float32 where what is believed is too."""
    given = {"measured": measured, "matrix": matrix, "noise": noise}
    arrays = real_arrays({**given, "mean": belief.mean, "covariance": belief.covariance})
    H, mean = arrays["matrix"], arrays["mean"]
    if H.ndim != 2 or not H.size or not np.isfinite(H).all():
        raise ValueError(f"matrix must be finite, of shape (m, n), neither of them 0; got {H.tolist()}")
    if mean.ndim and H.shape[1:] != mean.shape[-1:]:  # a single number is refused beside the covariance
        raise ValueError(f"matrix must have {mean.shape[-1]} columns, one a component; got {H.shape[1]}")
    values, R = measured_values(arrays["measured"], noise, len(H))
    return values, H, R.astype(values.dtype, copy=False)
