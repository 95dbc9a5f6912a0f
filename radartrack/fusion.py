"""Fusion of several radars: weights, straight lines through the plots of all, and covariance-weighted means.

The weights of least variance are inversely proportional to the variances of unbiased, independent
measurements (`radartrack.derive.tracks.fusion_weights` derives them with a Lagrange multiplier). They do not change
when all deviations are multiplied by one number. The deviations may come from

- `stated_std`: the stated deviations of range and azimuth, the same wherever the target is;
- `propagated_covariance`: the stated deviations carried over to x and y at each plot;
- `line.measurement_std` or a `VarianceTable`: the scatter of plots about straight courses.

Errors of tracks are not independent: `fuse_correlated` takes their cross covariance, which `cross_covariances` and
`steady_cross_covariance` know of common process noise, and `covariance_intersection` serves where nothing is known of
it. `registration` estimates constant biases of radars.
"""

from collections.abc import Sequence
from typing import Literal, NamedTuple, TypeAlias, get_args

import numpy as np
from numpy.typing import ArrayLike, NDArray

from radartrack import line
from radartrack._arrays.validation import (
    ANGLE,
    ANGLE_STD,
    COVARIANCE,
    RANGE,
    Domain,
    broadcast_shape,
    one_of,
    real_arrays,
    require_covariance,
    require_finite,
    require_trailing_shape,
    require_within,
    whole_number,
)
from radartrack._conversion.sensors import AzimuthFrom
from radartrack._filtering.beliefs import Motion as LinearMotion
from radartrack._fusion import common_process
from radartrack._fusion.best_share import CRITERIA, Criterion, pencil_of
from radartrack._fusion.common_process import Filtered
from radartrack._fusion.registration import Plots, estimated
from radartrack._fusion.whitened_least_squares import (
    applied,
    factorised,
    least_squares,
    of_most_accurate,
    squares,
    whitener,
)
from radartrack.generated import fusion as formulas
from radartrack.generated import spherical
from radartrack.line import COORDINATE, TIME, WEIGHT

__all__ = [
    "Filtered",
    "Fused",
    "Intersection",
    "Motion",
    "Registration",
    "covariance_intersection",
    "cross_covariances",
    "fuse",
    "fuse_correlated",
    "fuse_lines",
    "fuse_plots",
    "position_std",
    "propagated_covariance",
    "registration",
    "stated_std",
    "steady_cross_covariance",
    "weights",
]


def __dir__() -> list[str]:
    return __all__


Floats: TypeAlias = NDArray[np.float64]
FirstLayer: TypeAlias = Literal["equal", "reweighted"]

STD = Domain(" m", 1e100, 1e10, "squares of larger numbers overflow")
SHARE = Domain("", 1.0, 1.0, "a weight is a share of the whole")
POSITIVE = Domain(" m", 1e100, 1e10, "squares of larger numbers overflow, and a deviation weighs", smallest=1e-30)
WEIGHING = ANGLE_STD._replace(reason="an azimuth weighs, by one over its variance", smallest=1e-30)


class Fused(NamedTuple):
    """A fused mean, shape (..., d), and the covariance of its error, shape (..., d, d)."""

    mean: Floats
    covariance: Floats


class Intersection(NamedTuple):
    """A fused mean, shape (..., d), a covariance that its error does not exceed, and the weight of the first, (...)."""

    mean: Floats
    covariance: Floats
    weight: Floats


class Registration(NamedTuple):
    """Estimated biases of radars, measured minus true.

    Attributes:
        range_bias: shape (..., radars) [m].
        azimuth_bias: shape (..., radars) [rad].
        covariance: of the errors of both, (range, azimuth) of one radar after the other, (..., 2 radars, 2 radars).
    """

    range_bias: Floats
    azimuth_bias: Floats
    covariance: Floats


class Motion(NamedTuple):
    """Straight motions at constant speed in the plane.

    Attributes:
        time: the time at which position and velocity are given [s], shape (...).
        position: x and y [m], shape (..., 2).
        velocity: along x and y [m/s], shape (..., 2).
        covariance: of the errors of (x, y, vx, vy), shape (..., 4, 4); None where the weights do not tell it.
    """

    time: Floats
    position: Floats
    velocity: Floats
    covariance: Floats | None

    def at(self, t: ArrayLike) -> Floats:
        """Positions [m] at times of shape (..., m), shape (..., m, 2)."""
        elapsed = _read({"t": t}, {"t": TIME})["t"] - self.time[..., np.newaxis]
        return self.position[..., np.newaxis, :] + elapsed[..., np.newaxis] * self.velocity[..., np.newaxis, :]


def weights(std: ArrayLike) -> Floats:
    """The weights of unbiased, independent measurements of one thing with the least variance of their mean.

    Args:
        std: standard deviations, positive, in one unit, shape (..., n).

    Returns:
        Weights that sum to 1, shape (..., n).

    Raises:
        TypeError: the deviations are no real numbers.
        ValueError: a deviation is not positive and finite, or there is none.

    Source: Gao et al. 2020, section 3, doi:10.12126/see.2020.02.013; the best linear unbiased ones are those of Aitken
    1936, doi:10.1017/S0370164600014346.
    """
    deviations = _read({"std": std}, {"std": STD})["std"]
    if not deviations.ndim or not deviations.shape[-1]:
        raise ValueError(f"std must have at least one deviation on its last axis; got shape {deviations.shape}")
    if not np.all(deviations > 0):
        raise ValueError("std must be positive; got 0")
    inverse: Floats = (deviations.min(axis=-1, keepdims=True) / deviations) ** 2
    total: Floats = inverse.sum(axis=-1, keepdims=True)
    return inverse / total


def stated_std(range_std: ArrayLike, azimuth_std: ArrayLike, reference_range: ArrayLike) -> Floats:
    """A deviation of position from stated polar deviations, whatever the range of the target.

    Metres and radians only add after the radians are multiplied by a length. Weights from stated deviations
    take one length for all radars and all plots; here it is an argument. The result is the root mean square
    of the deviations along and across the line of sight at that range.

    Args:
        range_std: standard deviation of the range [m].
        azimuth_std: standard deviation of the azimuth [rad].
        reference_range: the length [m].

    Returns:
        Deviations [m], of the shape that the arguments broadcast to.

    Raises:
        TypeError: an argument is not made of real numbers.
        ValueError: an argument is out of its domain, or the shapes do not broadcast.

    Source: Gao et al. 2020, section 3, doi:10.12126/see.2020.02.013, who leave the length open.
    """
    arrays = _read(
        {"range_std": range_std, "azimuth_std": azimuth_std, "reference_range": reference_range},
        {"range_std": RANGE, "azimuth_std": ANGLE_STD, "reference_range": RANGE},
    )
    broadcast_shape(arrays)
    across = formulas.cross_range_std(r=arrays["reference_range"], sigma_beta=arrays["azimuth_std"])
    return line.position_std(arrays["range_std"], across.astype(np.float64))


def propagated_covariance(
    r: ArrayLike,
    azimuth: ArrayLike,
    range_std: ArrayLike,
    azimuth_std: ArrayLike,
    elevation: ArrayLike = 0.0,
    elevation_std: ArrayLike = 0.0,
) -> Floats:
    """The covariance of x and y that error propagation gives for plots (Gao et al. 2020, section 1).

    For a two-coordinate radar elevation and its deviation stay 0; what the missing elevation does to x and y
    is then no part of the covariance.

    Args:
        r: slant ranges [m].
        azimuth: azimuths [rad], clockwise from the y axis.
        range_std: standard deviations of the ranges [m].
        azimuth_std: standard deviations of the azimuths [rad].
        elevation: elevations [rad].
        elevation_std: standard deviations of the elevations [rad].

    Returns:
        Covariances [m^2], shape (..., 2, 2); `position_std` makes one deviation of each.

    Raises:
        TypeError: an argument is not made of real numbers.
        ValueError: an argument is out of its domain, or the shapes do not broadcast.

    Source: Gao et al. 2020, section 1, doi:10.12126/see.2020.02.013.
    """
    arrays = _read(
        {
            "r": r, "azimuth": azimuth, "elevation": elevation,
            "range_std": range_std, "azimuth_std": azimuth_std, "elevation_std": elevation_std,
        },
        {
            "r": RANGE, "azimuth": ANGLE, "elevation": ANGLE,
            "range_std": RANGE, "azimuth_std": ANGLE_STD, "elevation_std": ANGLE_STD,
        },
    )  # fmt: skip
    broadcast_shape(arrays)
    covariance = spherical.covariance_linear(
        r=arrays["r"], beta=arrays["azimuth"], epsilon=arrays["elevation"],
        sigma_r=arrays["range_std"], sigma_beta=arrays["azimuth_std"], sigma_epsilon=arrays["elevation_std"],
        rho=0.0,
    )  # fmt: skip
    plane = covariance[..., :2, :2].astype(np.float64)
    mixed = line.bounded_product(plane[..., 0, 1], plane[..., 0, 0], plane[..., 1, 1])
    plane[..., 0, 1] = plane[..., 1, 0] = mixed
    return plane


def position_std(covariance: ArrayLike) -> Floats:
    """One deviation from the covariance of x and y: the root mean square of both, (10) of Gao et al. [m].

    Args:
        covariance: covariances [m^2], shape (..., 2, 2).

    Returns:
        Deviations [m], shape (...).

    Raises:
        TypeError: the covariance is not made of real numbers.
        ValueError: an entry is not finite, a covariance is not symmetric and positive semidefinite, or the shape
            does not fit.

    Source: Gao et al. 2020, (10), doi:10.12126/see.2020.02.013.
    """
    matrices = _read({"covariance": covariance}, {"covariance": COVARIANCE})["covariance"]
    require_trailing_shape("covariance", matrices, (2, 2))
    require_covariance("covariance", matrices)
    along_x, along_y = np.moveaxis(np.sqrt(np.diagonal(matrices, axis1=-2, axis2=-1)), -1, 0)
    return line.position_std(along_x, along_y)


def fuse(mean: ArrayLike, covariance: ArrayLike) -> Fused:
    """The best linear unbiased estimate from independent measurements of one point, by their covariances.

    Each measurement gets the matrix weight M P^-1, with P its covariance and M the fused covariance, the
    inverse of the sum of all P^-1. Computed by an orthogonal factorisation.

    Args:
        mean: unbiased measurements, shape (..., n, d); `radartrack.convert` makes them of plots.
        covariance: covariances of their errors, positive definite, shape (..., n, d, d).

    Returns:
        Mean, shape (..., d), and covariance of its error, shape (..., d, d).

    Raises:
        TypeError: an argument is not made of real numbers.
        ValueError: an entry is not finite, a covariance is not symmetric and positive definite, the covariances
            are too unequal to fuse in double precision, or the shapes do not fit.

    Source: Aitken 1936, doi:10.1017/S0370164600014346.
    """
    arrays = _read({"mean": mean, "covariance": covariance}, {"mean": COORDINATE, "covariance": COVARIANCE})
    points, errors = arrays["mean"], arrays["covariance"]
    if points.ndim < 2 or 0 in points.shape[-2:]:
        raise ValueError(f"mean must have shape (..., n, d) with n and d from 1; got {points.shape}")
    size = points.shape[-1]
    require_trailing_shape("covariance", errors, (points.shape[-2], size, size))
    shape = broadcast_shape({"mean": points[..., 0], "covariance": errors[..., 0, 0]})
    white = whitener("covariance", errors)
    origin = of_most_accurate(np.broadcast_to(points, (*shape, size)), white)
    estimate = least_squares(np.eye(size), white, points - origin)
    return Fused(estimate.value + origin[..., 0, :], squares(estimate.root))


def fuse_correlated(mean: ArrayLike, covariance: ArrayLike, cross_covariance: ArrayLike) -> Fused:
    """The best linear unbiased estimate from two whose errors are correlated, as those of tracks of one target are.

    Args:
        mean: unbiased estimates, shape (..., 2, d).
        covariance: covariances of their errors, shape (..., 2, d, d).
        cross_covariance: E[e1 e2'], shape (..., d, d); `cross_covariances` and `steady_cross_covariance` make it.

    Returns:
        Mean, shape (..., d), and covariance of its error, shape (..., d, d).

    Raises:
        TypeError: an argument is not made of real numbers.
        ValueError: an entry is not finite, the covariance of both together is not symmetric and positive definite, or
            the shapes do not fit.

    Source: Bar-Shalom & Campo 1986, (9) and (10), doi:10.1109/TAES.1986.310815.
    """
    given = {"mean": mean, "covariance": covariance, "cross_covariance": cross_covariance}
    arrays = _read(given, {"mean": COORDINATE, "covariance": COVARIANCE, "cross_covariance": COVARIANCE})
    points, errors, cross = arrays.values()
    size = _size_of_two(points, errors)
    require_trailing_shape("cross_covariance", cross, (size, size))
    shape = broadcast_shape(
        {"mean": points[..., 0, 0], "covariance": errors[..., 0, 0, 0], "cross_covariance": cross[..., 0, 0]}
    )
    joint = np.empty((*shape, 2 * size, 2 * size))
    joint[..., :size, :size], joint[..., size:, size:] = errors[..., 0, :, :], errors[..., 1, :, :]
    joint[..., :size, size:], joint[..., size:, :size] = cross, np.swapaxes(cross, -1, -2)
    white = whitener("covariance with cross_covariance", joint).matrix
    both = np.broadcast_to(points, (*shape, 2, size))
    origin = _of_more_accurate(both, errors)
    rows = white @ np.concatenate([np.eye(size)] * 2)
    differences = (both - origin[..., np.newaxis, :]).reshape(*shape, 2 * size)
    estimate = factorised(rows[..., np.newaxis, :, :], applied(white, differences)[..., np.newaxis, :])
    return Fused(estimate.value + origin, squares(estimate.root))


def covariance_intersection(
    mean: ArrayLike,
    covariance: ArrayLike,
    criterion: Criterion = "trace",
    weight: ArrayLike | None = None,
) -> Intersection:
    """An estimate from two whose errors are correlated in a way that nobody knows.

    The covariance is P = (w P1^-1 + (1 - w) P2^-1)^-1, the mean P (w P1^-1 m1 + (1 - w) P2^-1 m2). If P1 and P2 are not
    too small, nor is P, whatever the correlation. The weight makes the trace or the determinant of P least; both are
    convex functions of it, and the search ends at the last digit. Of two covariances that are the same it is a half.

    Args:
        mean: unbiased estimates, shape (..., 2, d). Of more than two fuse two at a time.
        covariance: covariances of their errors, positive definite, shape (..., 2, d, d).
        criterion: "trace", which adds variances as they are, of metres and of metres per second too, or
            "determinant", which does not depend on units.
        weight: w from 0 to 1, shape (...), where it is not to be searched for.

    Returns:
        Mean, covariance and weight.

    Raises:
        TypeError: an argument is not made of real numbers, or the criterion is no text.
        ValueError: an entry is not finite, a covariance is not symmetric and positive definite, the two are too
            unequal for double precision, a weight is not from 0 to 1, the word is unknown, or the shapes do not fit.

    Source: Julier & Uhlmann 1997, doi:10.1109/ACC.1997.609105.
    """
    chosen: Criterion = one_of("criterion", criterion, CRITERIA)
    given = {"mean": mean, "covariance": covariance} | ({} if weight is None else {"weight": weight})
    arrays = _read(given, {"mean": COORDINATE, "covariance": COVARIANCE, "weight": SHARE})
    points, errors = arrays["mean"], arrays["covariance"]
    size = _size_of_two(points, errors)
    require_covariance("covariance", errors)
    shape = broadcast_shape(
        {"mean": points[..., 0, 0], "covariance": errors[..., 0, 0, 0]}
        | ({} if weight is None else {"weight": arrays["weight"]})
    )
    whitener("covariance", errors)  # which refuses what is singular
    pencil = pencil_of(errors[..., 0, :, :], errors[..., 1, :, :])
    share = arrays["weight"] if weight is not None else pencil.best_share(chosen)
    both = np.broadcast_to(points, (*shape, 2, size))
    origin = _of_more_accurate(both, errors)
    one, other = (applied(pencil.inverse, both[..., k, :] - origin) for k in (0, 1))
    w, mixed = share[..., np.newaxis], pencil.mixed(share)
    fused = origin + applied(pencil.axes, w * pencil.ratios / mixed * one + (1 - w) / mixed * other)
    found = np.broadcast_to(pencil.intersected(share), (*shape, size, size))
    return Intersection(fused, found.copy(), np.broadcast_to(share, shape).copy())


def cross_covariances(motion: LinearMotion, first: Filtered, second: Filtered, start: ArrayLike = 0.0) -> Floats:
    """The cross covariance of two filters' errors after each scan, which the common process noise makes.

    X goes to (1 - K1 H1) (F X F' + Q) (1 - K2 H2)' from scan to scan, for radars whose errors are independent and scans
    at the same times.

    Args:
        motion: F and Q that both filters use, of `rt.kalman.motion`.
        first: the covariances of the first filter, as `rt.kalman.run` gives them, its H and its R.
        second: likewise.
        start: the cross covariance before the first scan, shape (..., n, n); 0 where tracks were started from plots of
            their own.

    Returns:
        Cross covariances, shape (..., scans, n, n).

    Raises:
        TypeError: an argument is not made of real numbers, or `seen` not of booleans.
        ValueError: the shapes do not fit, a number is not finite, a covariance is none, or the result overflows.

    Source: Bar-Shalom & Campo 1986, (5), doi:10.1109/TAES.1986.310815.
    """
    return common_process.recursion(motion, first, second, start)


def steady_cross_covariance(motion: LinearMotion, first: Filtered, second: Filtered) -> Floats:
    """What `cross_covariances` comes to in the steady state.

    Args:
        motion: F and Q that both filters use.
        first: the steady covariance of the first filter after an update, shape (..., n, n), its H and its R.
        second: likewise.

    Returns:
        Cross covariances, shape (..., n, n).

    Raises:
        TypeError: an argument is not made of real numbers.
        ValueError: the shapes do not fit, a number is not finite, a covariance is none, or the filters are in no steady
            state.

    Source: Bar-Shalom & Campo 1986, doi:10.1109/TAES.1986.310815; `fusion.cross_covariance.steady` is the closed form
    for alpha-beta filters.
    """
    return common_process.steady(motion, first, second)


def registration(
    r: ArrayLike,
    azimuth: ArrayLike,
    range_std: ArrayLike,
    azimuth_std: ArrayLike,
    sites: ArrayLike,
    *,
    azimuth_from: AzimuthFrom = "x",
    reference: int | None = None,
) -> Registration:
    """Constant biases of range and azimuth of several radars, from targets that two or more of them see.

    Positions and biases are estimated together, by least squares in range and azimuth (Gauss and Newton), each target's
    position being taken out before the biases are found. That is the most likely answer for Gaussian errors. Angle
    errors bend positions; what is left of that in the biases is of the order of the square of an azimuth's deviation
    times the range, and does not shrink with more targets.

    Args:
        r: ranges [m], shape (..., radars, targets); NaN where a radar does not see a target.
        azimuth: azimuths [rad], of that shape too.
        range_std: standard deviations of the ranges [m]; broadcast with them.
        azimuth_std: standard deviations of the azimuths [rad]; broadcast with them.
        sites: x and y of each radar [m], shape (radars, 2).
        azimuth_from: "x" for counter-clockwise from the x axis, "y" for clockwise from the y axis.
        reference: the number of a radar that has no bias; None where all may have some.

    Returns:
        Biases, and the covariance of their errors; those of the reference are zero.

    Raises:
        TypeError: an argument is not made of real numbers.
        ValueError: a number is out of its domain, the shapes do not fit, the targets do not determine the biases, or
            the plots are not of common targets.

    Source: Dana 1990, Registration: a prerequisite for multiple sensor tracking; Lin, Kirubarajan & Bar-Shalom 2004.
    """
    axis: AzimuthFrom = one_of("azimuth_from", azimuth_from, get_args(AzimuthFrom))
    values = real_arrays(
        {"r": r, "azimuth": azimuth, "range_std": range_std, "azimuth_std": azimuth_std, "sites": sites}
    )
    domains = {"r": RANGE, "azimuth": ANGLE, "range_std": POSITIVE, "azimuth_std": WEIGHING, "sites": COORDINATE}
    for name, array in values.items():
        require_within(name, np.where(np.isnan(array), 0, array) if name in {"r", "azimuth"} else array, domains[name])
    places = values.pop("sites").astype(np.float64)
    shape = broadcast_shape(values)
    if len(shape) < 2 or shape[-2] < 2 or not shape[-1]:
        raise ValueError(f"r must have shape (..., radars, targets), of two radars or more; got {shape}")
    if places.shape != (shape[-2], 2):
        raise ValueError(f"sites must have shape {(shape[-2], 2)}; got {places.shape}")
    unknown = np.ones((shape[-2], 2), dtype=bool)
    if reference is not None:
        unknown[whole_number("reference", reference, 0, shape[-2] - 1)] = False
    spread = {name: np.broadcast_to(array.astype(np.float64), shape) for name, array in values.items()}
    measured = np.stack([spread["r"], spread["azimuth"]], axis=-1)
    deviations = np.stack([spread["range_std"], spread["azimuth_std"]], axis=-1)
    found = estimated(Plots(measured, deviations, places, axis), unknown)
    require_finite("the bias", found.bias)
    return Registration(found.bias[..., 0], found.bias[..., 1], found.covariance)


def _of_more_accurate(points: Floats, errors: Floats) -> Floats:
    """Each coordinate of the one of two estimates that has less variance along it, (..., d).

    Counted from there no rounding error of a poor estimate is taken for one of the good one.
    """
    variances = np.broadcast_to(np.diagonal(errors, axis1=-2, axis2=-1), points.shape)
    return np.where(variances[..., 0, :] <= variances[..., 1, :], points[..., 0, :], points[..., 1, :])


def _size_of_two(points: Floats, errors: Floats) -> int:
    """The number of components of two estimates."""
    if points.ndim < 2 or points.shape[-2] != 2 or not points.shape[-1]:
        raise ValueError(f"mean must have shape (..., 2, d), with d from 1; got {points.shape}")
    size: int = points.shape[-1]
    require_trailing_shape("covariance", errors, (2, size, size))
    return size


def fuse_lines(
    t: Sequence[ArrayLike],
    x: Sequence[ArrayLike],
    y: Sequence[ArrayLike],
    radar_weights: ArrayLike,
    *,
    first_layer: FirstLayer = "equal",
) -> Motion:
    """The two-layer weighted straight line of several radars, which Gao et al. 2020, section 3, name.

    x and y of all plots are fitted to time by a weighted ordinary least squares each. In the sum of squares,
    plot i of radar j has the weight a_ij W_j. The second layer, W_j, is the radar's weight, of `weights`. The
    first layer, a_ij, is within the radar: "equal", all 1; or "reweighted", the squares of the weights of the
    printed iteration on this radar's own plots (`line.fit`), made to have the mean 1.

    With first layer "equal" and W_j inversely proportional to the variances along a coordinate, these are the
    weights of least variance for that coordinate by itself. `fuse_plots` has a covariance for each plot.

    Args:
        t: for each radar the times of its plots [s], shape (..., n_j); together at least two different times.
        x: for each radar the coordinates in the common plane [m], shape (..., n_j).
        y: likewise.
        radar_weights: weights W_j, not negative, at least one positive; shape (..., radars).
        first_layer: how the plots of one radar are weighted among themselves.

    Returns:
        The motion, with no covariance, as the weights do not tell it.

    Raises:
        TypeError: an argument is not made of real numbers.
        ValueError: an argument is out of its domain, numbers of radars differ, there is none, the shapes do not
            broadcast, or the times of the plots do not determine a motion. A plot with less than 1e-100 of the
            largest weight counts as none.

    Source: Gao et al. 2020, section 3, doi:10.12126/see.2020.02.013.
    """
    layer: FirstLayer = one_of("first_layer", first_layer, get_args(FirstLayer))
    between = _read({"radar_weights": radar_weights}, {"radar_weights": WEIGHT})["radar_weights"]
    for name, given in (("t", t), ("x", x), ("y", y)):
        if not isinstance(given, Sequence) and not (isinstance(given, np.ndarray) and given.ndim):
            raise TypeError(f"{name} must be a list of arrays, one a radar; got {given!r}"[:200])
    if not len(t) == len(x) == len(y):
        raise ValueError(f"t, x and y must be given for the same radars; got {len(t)}, {len(x)} and {len(y)}")
    if not len(t):
        raise ValueError("t must hold the times of at least one radar; got none")
    require_trailing_shape("radar_weights", between, (len(t),))
    largest = between.max(axis=-1, keepdims=True)
    if not np.all(largest > 0):
        raise ValueError("radar_weights must have a positive one for each track; got a track of zeros")
    between = between / largest
    fits = [_fused_line(t, coordinate, between, layer) for coordinate in (x, y)]
    if not all(np.all(fit.converged) for fit in fits):
        raise ValueError("t must hold at least two different times with positive weights; got a track without")
    time = fits[0].mean_t
    position = np.stack([fit.at(time[..., np.newaxis])[..., 0] for fit in fits], axis=-1)
    return Motion(time, position, np.stack([fit.slope for fit in fits], axis=-1), None)


def fuse_plots(t: ArrayLike, position: ArrayLike, covariance: ArrayLike) -> Motion:
    """The best linear unbiased straight motion through plots with covariances, of one radar or of many.

    Args:
        t: times [s], shape (..., n), at least two of them different.
        position: x and y of the plots [m], shape (..., n, 2).
        covariance: covariances of their errors [m^2], positive definite, shape (..., n, 2, 2).

    Returns:
        The motion, with the covariance of its errors.

    Raises:
        TypeError: an argument is not made of real numbers.
        ValueError: an entry is not finite, a covariance is not symmetric and positive definite, the covariances
            are too unequal to fuse in double precision, the shapes do not fit, or all times of a track are the
            same, or so close that a velocity or its variance is not finite.

    Source: Aitken 1936, doi:10.1017/S0370164600014346.
    """
    arrays = _read(
        {"t": t, "position": position, "covariance": covariance},
        {"t": TIME, "position": COORDINATE, "covariance": COVARIANCE},
    )
    times, points, errors = arrays["t"], arrays["position"], arrays["covariance"]
    require_trailing_shape("position", points, (2,))
    require_trailing_shape("covariance", errors, (2, 2))
    shape = broadcast_shape({"t": times, "position": points[..., 0], "covariance": errors[..., 0, 0]})
    if not shape or shape[-1] < 2:
        raise ValueError(f"t must hold at least two different times for each track; got plots of shape {shape}")
    times, points = np.broadcast_to(times, shape), np.broadcast_to(points, (*shape, 2))
    middle = times[..., :1] + (times - times[..., :1]).mean(axis=-1, keepdims=True)
    scale = np.abs(times - times[..., :1]).max(axis=-1, keepdims=True)
    if not np.all(scale > 0):
        raise ValueError("t must hold at least two different times for each track; got a track without")
    white = whitener("covariance", errors)
    origin, start = (of_most_accurate(values, white) for values in (points, np.stack([times] * 2, axis=-1)))
    design = _design((times[..., np.newaxis] - start) / scale[..., np.newaxis])
    estimate = least_squares(design, white, points - origin)
    with np.errstate(over="ignore", invalid="ignore"):
        change = _change(middle - start[..., 0, :], scale)
        state, covariance = applied(change, estimate.value), squares(change @ estimate.root)
    if not (np.all(np.isfinite(state)) and np.all(np.isfinite(covariance))):
        raise ValueError("t must differ by more: the velocity of a track or its variance is not finite")
    return Motion(middle[..., 0], state[..., :2] + origin[..., 0, :], state[..., 2:], covariance)


def _fused_line(t: Sequence[ArrayLike], x: Sequence[ArrayLike], between: Floats, first_layer: FirstLayer) -> line.Fit:
    """The line of one coordinate through the plots of all radars."""
    layers = [_plots_of_radar(j, t[j], x[j], first_layer) for j in range(len(t))]
    shape = broadcast_shape(
        {f"plots of radar {j}": times[..., 0] for j, (times, _, _) in enumerate(layers)}
        | {"radar_weights": between[..., 0]}
    )
    weighted = [(times, values, own * between[..., j : j + 1]) for j, (times, values, own) in enumerate(layers)]
    joined = (
        np.concatenate([np.broadcast_to(part, shape + part.shape[-1:]) for part in parts], axis=-1)
        for parts in zip(*weighted, strict=True)
    )
    times, values, total = joined
    return line.fit(times, values, weights=total)


def _plots_of_radar(number: int, t: ArrayLike, x: ArrayLike, first_layer: FirstLayer) -> tuple[Floats, Floats, Floats]:
    """Times, coordinates and first-layer weights of one radar, all of one shape."""
    names = f"t of radar {number}", f"coordinates of radar {number}"
    arrays = _read(dict(zip(names, (t, x), strict=True)), dict(zip(names, (TIME, COORDINATE), strict=True)))
    shape = broadcast_shape(arrays)
    if not shape or not shape[-1]:
        raise ValueError(f"t of radar {number} must have at least one plot on its last axis; got shape {shape}")
    times, values = (np.broadcast_to(array, shape) for array in arrays.values())
    if first_layer == "equal" or shape[-1] == 1:  # one plot has all the weight of its radar
        return times, values, np.ones(shape)
    own = line.fit(times, values, method="reweighted").weights
    mean: Floats = own.mean(axis=-1, keepdims=True)
    return times, values, own / mean


def _design(elapsed: Floats) -> Floats:
    """The rows by which (x, y, vx, vy) gives x and y at times from the start of each, shape (..., 2, 4)."""
    one = np.broadcast_to(np.eye(2), (*elapsed.shape, 2))
    return np.concatenate([one, one * elapsed[..., np.newaxis]], axis=-1)


def _change(elapsed: Floats, scale: Floats) -> Floats:
    """From a state at the start of each coordinate, in units of a scale, to one after these times, in seconds."""
    velocity = np.concatenate([np.zeros((2, 2)), np.eye(2)], axis=-1) / scale[..., np.newaxis]
    return np.concatenate([_design(elapsed / scale), velocity], axis=-2)


def _read(given: dict[str, ArrayLike], domains: dict[str, Domain]) -> dict[str, Floats]:
    """The arguments as float64, each checked against its domain."""
    arrays = {name: array.astype(np.float64, order="C") for name, array in real_arrays(given).items()}
    for name, array in arrays.items():
        require_within(name, array, domains[name])
    return arrays
