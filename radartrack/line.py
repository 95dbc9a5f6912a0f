"""Straight lines through tracks, and the measurement deviations that they show.

A target on a straight course at constant speed draws a straight line x = slope t + intercept, and likewise in
y. `fit` finds such lines, `measurement_std` the deviations of the measured coordinates about them, as printed
by Gao, Dong and Zhang (2020), and in the form that is consistent. `to_plane` converts plots to coordinates
first.

All arrays compute in float64, whatever they come in. Tracks are vectorised: the last axis runs over the plots
of a track, all the others over tracks.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, fields, replace
from typing import Any, Literal, NamedTuple, TypeAlias, get_args

import numpy as np
from numpy.typing import ArrayLike, NDArray

from radartrack import chi_square
from radartrack._arrays.validation import (
    ANGLE,
    RANGE,
    Domain,
    RealArray,
    broadcast_shape,
    one_of,
    positive_number,
    real_arrays,
    real_number,
    require_trailing_shape,
    require_within,
    whole_number,
)
from radartrack.generated import line as formulas
from radartrack.generated import spherical

__all__ = ["Fit", "Interval", "MeasurementStd", "fit", "measurement_std", "to_plane"]


def __dir__() -> list[str]:
    return __all__


Method: TypeAlias = Literal["ordinary", "perpendicular", "reweighted"]
StdMethod: TypeAlias = Literal["consistent", "printed"]
Floats: TypeAlias = NDArray[np.float64]
Flags: TypeAlias = NDArray[np.bool_]
Counts: TypeAlias = NDArray[np.intp]

TIME = Domain(" s", 1e100, 1e10, "squares of larger numbers overflow", signed=True)
COORDINATE = Domain(" m", 1e100, 1e10, "squares of larger numbers overflow", signed=True)
WEIGHT = Domain("", 1e50, 1e10, "their products with squares overflow")
GUARD = float(np.sqrt(np.finfo(np.float64).eps))
NEGLIGIBLE = 1e-100  # squares of such shares do not underflow yet
STEEPEST = 1e200  # times any time that is allowed it does not overflow
ISOTROPIC = 64 * float(np.finfo(np.float64).eps)  # rounding of the sums leaves a tenth of this


@dataclass(frozen=True, slots=True)
class Fit:
    """Straight lines x = slope t + intercept, one a track.

    Attributes:
        mean_t: weighted mean of the times [s], shape (...).
        mean_x: weighted mean of the coordinates [m], shape (...); the line passes through both means. Of an
            "ordinary" line it is the coordinate at the mean time as that is rounded.
        slope: slope [m/s], shape (...); infinite for a vertical line, NaN where the plots determine no line.
        weights: weight of each squared distance in the sum that the line makes least, shape (..., n).
        iterations: number of weighted solutions, shape (...); 0 without reweighting.
        converged: whether the line is determined and, with reweighting, the stopping rule was met, shape
            (...).
    """

    mean_t: Floats
    mean_x: Floats
    slope: Floats
    weights: Floats
    iterations: Counts
    converged: Flags

    @property
    def intercept(self) -> Floats:
        """The coordinate at time zero [m], shape (...); not finite where the slope is not."""
        with np.errstate(invalid="ignore"):
            return formulas.intercept(k=self.slope, mean_x=self.mean_t, mean_y=self.mean_x).astype(np.float64)

    def at(self, t: ArrayLike) -> Floats:
        """The coordinate [m] at times of shape (..., m)."""
        return self.mean_x[..., np.newaxis] + self._travelled(t)

    def residual(self, t: ArrayLike, x: ArrayLike) -> Floats:
        """How far x lies above the line [m], shape (..., n)."""
        return self._moved(x) - self._travelled(t)

    def distance(self, t: ArrayLike, x: ArrayLike) -> Floats:
        """Perpendicular distance from the line in the plane of t and x, as pure numbers; (3) of Gao et al.

        Positive above the line, for a vertical one to its left; shape (..., n).
        """
        cosine, sine = _direction(self.slope[..., np.newaxis])
        return self._moved(x) * cosine - self._elapsed(t) * sine

    def _elapsed(self, t: ArrayLike) -> Floats:
        return _read("t", t, TIME) - self.mean_t[..., np.newaxis]

    def _moved(self, x: ArrayLike) -> Floats:
        return _read("x", x, COORDINATE) - self.mean_x[..., np.newaxis]

    def _travelled(self, t: ArrayLike) -> Floats:
        """Not a number beside an infinite slope at the mean time."""
        with np.errstate(invalid="ignore"):
            return self.slope[..., np.newaxis] * self._elapsed(t)


class _Centred(NamedTuple):
    """Plots about their weighted mean, each coordinate over a scale at which its largest value is about 1.

    Attributes:
        mean_t: weighted mean of the times, shape (...).
        mean_x: weighted mean of the coordinates, shape (...).
        lost: what rounding has added to the mean time, over its scale, shape (...).
        scale_t: 0 where all times are the same, shape (...).
        scale_x: 0 where all coordinates are the same, shape (...).
        S_tt: weighted sum of the squares of the scaled times about their mean, shape (...).
        S_tx: of their products with the coordinates.
        S_xx: of the squares of the coordinates.
    """

    mean_t: Floats
    mean_x: Floats
    lost: Floats
    scale_t: Floats
    scale_x: Floats
    S_tt: Floats
    S_tx: Floats
    S_xx: Floats


def fit(
    t: ArrayLike,
    x: ArrayLike,
    *,
    weights: ArrayLike | None = None,
    method: Method = "ordinary",
    max_iterations: int = 100,
) -> Fit:
    """Fit a straight line to each track.

    "ordinary" makes the squares of the residuals along x least; "perpendicular" those of the distances at
    right angles to the line (Gao et al. 2020, (4)), which is only sensible for t and x in one unit;
    "reweighted" is the printed iteration of Gao et al. 2020, 2.1: from the perpendicular line on, each plot
    gets the weight 1/|l| of its distance l, divided by the sum of all, the squares of the weighted distances
    are made least (5), and so on until the sum of the weighted distances (7) is no longer less than the time
    before. The line of the last step is returned.

    A distance counts in a weight as at least 1.5e-8 times the root mean square distance of the plots from the
    first line (the square root of the machine precision), so that a plot on the line does not divide by zero;
    where all plots lie on the line the weights are equal. Plots that determine no line give NaN, and
    `converged` is False: for "ordinary" identical times, for the others plots that coincide or, to within
    rounding, scatter alike in all directions, be it with the weights of a later step. Times that differ in the
    last bit are not identical.

    Args:
        t: times [s], shape (..., n), n at least 2.
        x: coordinates [m], shape (..., n); broadcasts with t.
        weights: weights of the squared distances, not negative, at least one of a track positive; shape (...,
            n). One of less than 1e-100 of the largest of its track counts as 0. Not for "reweighted", which
            makes its own.
        method: which squares are made least.
        max_iterations: the largest number of weighted solutions of "reweighted".

    Raises:
        TypeError: an argument is not made of real numbers.
        ValueError: an argument is out of its domain, the shapes do not broadcast, there are too few plots, or
            the slope of a track exceeds 1e200.
    """
    chosen: Method = one_of("method", method, get_args(Method))
    if chosen == "reweighted" and weights is not None:
        raise ValueError("weights must be None for method 'reweighted', which computes them; got an array")
    max_iterations = whole_number("max_iterations", max_iterations, 1)
    given = {"t": t, "x": x, "weights": 1.0 if weights is None else weights}
    arrays = _plots(given, {"t": TIME, "x": COORDINATE, "weights": WEIGHT}, least=2)
    if not np.all(arrays["weights"].sum(axis=-1) > 0):
        raise ValueError("weights must have a positive sum for each track; got a track of zeros")
    if chosen == "reweighted":
        return _reweighted(arrays["t"], arrays["x"], max_iterations)
    return _solved(arrays["t"], arrays["x"], arrays["weights"], chosen)


class Interval(NamedTuple):
    """Limits of a confidence interval for the deviations of x and y [m], shape (..., 2) each."""

    lower: Floats
    upper: Floats


@dataclass(frozen=True, slots=True)
class MeasurementStd:
    """Standard deviations of the measured coordinates of tracks.

    Attributes:
        x: standard deviation along x [m], shape (...).
        y: standard deviation along y [m], shape (...).
        degrees_of_freedom: of each variance; None for the printed method, which has no such count.
        converged: whether both lines were found, shape (...); without a line a deviation is NaN.
    """

    x: Floats
    y: Floats
    degrees_of_freedom: int | None
    converged: Flags

    @property
    def position(self) -> Floats:
        """Root mean square of both, (10) of Gao et al. [m], shape (...)."""
        return position_std(self.x, self.y)

    def bound(self, multiple: float) -> Floats:
        """So many times the deviations of x, y and position [m], shape (..., 3).

        A Gaussian error stays within twice its true deviation in 95.4 % and within three times in 99.7 % of
        cases.

        Raises:
            TypeError: the multiple is no real number.
            ValueError: it is not finite, or not more than 0.
        """
        return positive_number("multiple", multiple) * np.stack([self.x, self.y, self.position], axis=-1)

    def interval(self, confidence: float = 0.95) -> Interval:
        """Confidence interval for the true deviations along x and y, for independent Gaussian errors.

        Raises:
            TypeError: the confidence is no real number.
            ValueError: for the printed method, and for a confidence that is not between 0 and 1.
        """
        if self.degrees_of_freedom is None:
            raise ValueError("interval needs method 'consistent'; the printed deviations have no known distribution")
        if not 0 < real_number("confidence", confidence) < 1:
            raise ValueError(f"confidence must be between 0 and 1; got {confidence!r}")
        estimates = np.stack([self.x, self.y], axis=-1)
        tail, freedom = (1 - confidence) / 2, self.degrees_of_freedom
        most, least = (found(tail, freedom) for found in (chi_square.upper_quantile, chi_square.quantile))
        return Interval(estimates * np.sqrt(freedom) / np.sqrt(most), estimates * np.sqrt(freedom) / np.sqrt(least))


def measurement_std(
    t: ArrayLike,
    x: ArrayLike,
    y: ArrayLike,
    method: StdMethod = "consistent",
    *,
    max_iterations: int = 100,
) -> MeasurementStd:
    """Estimate the standard deviations of the measured coordinates about a straight course at constant speed.

    "consistent" fits x and y to t by ordinary least squares and divides the sum of the squared residuals by n
    - 2; its square is unbiased at every speed. "printed" is Gao et al. 2020, (8) to (10): the standard
    deviation of the absolute distances from reweighted perpendicular lines in the planes of (t, x) and (t,
    y). It estimates about 0.603/sqrt(1 + speed^2) of the deviation, the speed along the coordinate being
    taken as a pure number, and is offered to study the paper, not to be used.

    Args:
        t: times [s], shape (..., n), n at least 3.
        x: coordinates [m], shape (..., n).
        y: coordinates [m], shape (..., n).
        method: which estimate.
        max_iterations: of the reweighted lines of the printed method.

    Raises:
        TypeError: an argument is not made of real numbers.
        ValueError: an argument is out of its domain, the shapes do not broadcast, or there are too few plots.
    """
    chosen: StdMethod = one_of("method", method, get_args(StdMethod))
    domains = {"t": TIME, "x": COORDINATE, "y": COORDINATE}
    arrays = _plots({"t": t, "x": x, "y": y}, domains, least=3)
    times, coordinates = arrays["t"], (arrays["x"], arrays["y"])
    if chosen == "printed":
        lines = [fit(times, values, method="reweighted", max_iterations=max_iterations) for values in coordinates]
        distances = [line.distance(times, values) for line, values in zip(lines, coordinates, strict=True)]
        along_x, along_y = (_deviation(np.abs(distance)) for distance in distances)
        return MeasurementStd(along_x, along_y, None, lines[0].converged & lines[1].converged)
    lines = [fit(times, values) for values in coordinates]
    freedom = int(formulas.ordinary_degrees_of_freedom(n=times.shape[-1]))
    residuals = [line.residual(times, values) for line, values in zip(lines, coordinates, strict=True)]
    along_x, along_y = (_norm(residual) / np.sqrt(freedom) for residual in residuals)
    return MeasurementStd(along_x, along_y, freedom, lines[0].converged & lines[1].converged)


def to_plane(
    r: ArrayLike, azimuth: ArrayLike, elevation: ArrayLike = 0.0, *, site: ArrayLike = (0.0, 0.0)
) -> tuple[Floats, Floats]:
    """Convert plots to x and y in a common plane, (1) of Gao et al. without the height.

    A two-coordinate radar measures no elevation; with 0 in its place, as in the paper, a target at height h
    and slant range r appears r - sqrt(r^2 - h^2) too far out.

    Args:
        r: slant range [m].
        azimuth: azimuth [rad], clockwise from the y axis.
        elevation: elevation [rad].
        site: x and y of the radar [m], shape (..., 2); broadcasts with the plots.

    Returns:
        x and y [m], of the shape that the arguments broadcast to.

    Raises:
        TypeError: an argument is not made of real numbers.
        ValueError: an argument is out of its domain, or the shapes do not broadcast.
    """
    arrays = real_arrays({"r": r, "azimuth": azimuth, "elevation": elevation, "site": site})
    for name, domain in (("r", RANGE), ("azimuth", ANGLE), ("elevation", ANGLE), ("site", COORDINATE)):
        require_within(name, arrays[name], domain)
    origin = arrays.pop("site").astype(np.float64)
    require_trailing_shape("site", origin, (2,))
    broadcast_shape({**arrays, "site": origin[..., 0]})
    exact = {name: array.astype(np.float64) for name, array in arrays.items()}
    position = spherical.map(r=exact["r"], beta=exact["azimuth"], epsilon=exact["elevation"])
    plane = position[..., :2] + origin
    return plane[..., 0], plane[..., 1]


def position_std(along_x: Floats, along_y: Floats) -> Floats:
    """Root mean square of both deviations, (10) of Gao et al., where their squares would underflow too."""
    scale = _positive(np.maximum(along_x, along_y))
    return scale * formulas.position_std(sigma_x=along_x / scale, sigma_y=along_y / scale).astype(np.float64)


def bounded_product(mixed: Floats, first: Floats, second: Floats) -> Floats:
    """A mixed moment, which rounding and underflow do not lift above the geometric mean of the two variances."""
    most = np.sqrt(first) * np.sqrt(second)
    return np.clip(mixed, -most, most)


def _plots(given: Mapping[str, ArrayLike], domains: Mapping[str, Domain], least: int) -> dict[str, Floats]:
    """The arguments as float64 of one shape, checked."""
    arrays = {name: array.astype(np.float64, order="C") for name, array in real_arrays(given).items()}
    for name, array in arrays.items():
        require_within(name, array, domains[name])
    shape = broadcast_shape(arrays)
    if not shape or shape[-1] < least:
        raise ValueError(f"t must have at least {least} plots on its last axis; got the shape {shape}")
    return {name: np.broadcast_to(array, shape) for name, array in arrays.items()}


def _read(name: str, given: ArrayLike, domain: Domain) -> Floats:
    array = real_arrays({name: given})[name].astype(np.float64)
    require_within(name, array, domain)
    return array


def _centred(t: Floats, x: Floats, weights: Floats, *, one_unit: bool) -> _Centred:
    """Counted from the plot of most weight, plots that coincide with it are exactly at 0.

    So times are the same if and only if the scale is 0, and in the sums about the mean no rounding error has the
    weight of more than what is there: each is right to some rounding errors, however unequal the weights.
    """
    heaviest = np.argmax(weights, axis=-1)[..., np.newaxis]
    most, first_t, first_x = (np.take_along_axis(values, heaviest, -1) for values in (weights, t, x))
    counted = weights >= NEGLIGIBLE * most
    share = np.where(counted, weights / most, 0.0)
    share = share / share.sum(axis=-1, keepdims=True)
    elapsed, moved = np.where(counted, t - first_t, 0.0), np.where(counted, x - first_x, 0.0)
    scale_t, scale_x = (np.abs(values).max(axis=-1, keepdims=True) for values in (elapsed, moved))
    if one_unit:
        scale_t = scale_x = np.maximum(scale_t, scale_x)
    elapsed, moved = elapsed / _positive(scale_t), moved / _positive(scale_x)
    mean_elapsed, mean_moved = (np.sum(share * values, axis=-1, keepdims=True) for values in (elapsed, moved))
    elapsed, moved = elapsed - mean_elapsed, moved - mean_moved
    mean_t, mean_x = first_t + scale_t * mean_elapsed, first_x + scale_x * mean_moved
    lost = (mean_t - first_t) / _positive(scale_t) - mean_elapsed
    squares = (np.sum(share * product, axis=-1) for product in (elapsed * elapsed, elapsed * moved, moved * moved))
    return _Centred(*(values[..., 0] for values in (mean_t, mean_x, lost, scale_t, scale_x)), *squares)


def _positive(scale: Floats) -> Floats:
    """The scale, or 1 where there is nothing to scale."""
    return np.where(scale > 0, scale, 1.0)


def _norm(values: Floats) -> Floats:
    """The root of the sum of squares over the last axis, where they would underflow too."""
    scale = _positive(np.abs(values).max(axis=-1, keepdims=True))
    norm: Floats = scale[..., 0] * np.sqrt(np.sum((values / scale) ** 2, axis=-1))
    return norm


def _deviation(values: Floats) -> Floats:
    """The standard deviation of a sample, shape (..., n)."""
    deviation: Floats = _norm(values - values.mean(axis=-1, keepdims=True)) / np.sqrt(values.shape[-1] - 1)
    return deviation


def _solved(t: Floats, x: Floats, weights: Floats, method: Method) -> Fit:
    plots = _centred(t, x, weights, one_unit=method != "ordinary")
    slope, mean_x = _ordinary(plots) if method == "ordinary" else (_perpendicular_slope(plots), plots.mean_x)
    none = np.zeros(slope.shape, np.intp)
    return Fit(plots.mean_t, mean_x, slope, weights, none, ~np.isnan(slope))


def _ordinary(plots: _Centred) -> tuple[Floats, Floats]:
    """The slope, and the coordinate at the mean time as that is rounded."""
    known = plots.scale_t > 0
    scaled = formulas.ordinary_slope(S_tt=np.where(known, plots.S_tt, 1.0), S_tx=plots.S_tx)
    with np.errstate(over="ignore", invalid="ignore"):
        slope = np.where(scaled == 0, 0.0, scaled * (plots.scale_x / _positive(plots.scale_t)))
    slope = np.where(known, slope, np.nan)
    _require_representable(slope)
    return slope, plots.mean_x + np.where(known, scaled * plots.scale_x * plots.lost, 0.0)


def _perpendicular_slope(plots: _Centred) -> Floats:
    """The generated root, and its limits where the mixed sum vanishes."""
    S_tt, S_tx, S_xx = plots.S_tt, plots.S_tx, plots.S_xx
    tilted = S_tx != 0
    with np.errstate(over="ignore"):
        slope = formulas.slope(S_xx=S_tt, S_xy=np.where(tilted, S_tx, 1.0), S_yy=S_xx)
    _require_representable(slope)
    straight = np.where(S_tt > S_xx, 0.0, np.inf)
    alike = np.hypot(2 * S_tx, S_tt - S_xx) <= ISOTROPIC * (S_tt + S_xx)
    return np.where(alike, np.nan, np.where(tilted, slope, straight))


def _require_representable(slope: RealArray) -> None:
    if np.any(np.abs(slope) > STEEPEST):
        raise ValueError(f"t must differ by more beside x: the slope of a track exceeds {STEEPEST:g}")


def _direction(slope: Floats) -> tuple[Floats, Floats]:
    """Cosine and sine of the inclination; the sine of a vertical line is 1."""
    vertical = np.isinf(slope)
    cosine = 1.0 / np.hypot(1.0, slope)
    return cosine, np.where(vertical, np.sign(slope), np.where(vertical, 0.0, slope) * cosine)


def _reweighted(t: Floats, x: Floats, max_iterations: int) -> Fit:
    """The printed iteration on all tracks at once; a track that has met the stopping rule is left alone."""
    t_rows, x_rows = (values.reshape(-1, t.shape[-1]) for values in (t, x))
    line = _solved(t_rows, x_rows, np.ones_like(t_rows), "perpendicular")
    floor = GUARD * _norm(line.distance(t_rows, x_rows))[:, np.newaxis] / np.sqrt(t.shape[-1])
    active = np.flatnonzero(line.converged)
    line = replace(line, converged=np.zeros_like(line.converged))
    before = np.full(len(t_rows), np.inf)
    for _ in range(max_iterations):
        times, values = t_rows[active], x_rows[active]
        shares = _shares(_taken(line, active).distance(times, values), floor[active])
        better = _solved(times, values, shares**2, "perpendicular")
        total = np.sum(shares * np.abs(better.distance(times, values)), axis=-1)
        stops = ~(total < before[active])
        found = stops & better.converged
        line = _put(line, active, replace(better, iterations=line.iterations[active] + 1, converged=found))
        before[active] = total
        active = active[~stops]
        if not active.size:
            break
    return _map(line, lambda field: field.reshape(t.shape[:-1] + field.shape[1:]))


def _shares(distance: Floats, floor: Floats) -> Floats:
    """The printed weights 1/|l| over their sum, with the guard; equal ones where every distance is zero."""
    inverse: Floats = 1.0 / np.where(floor > 0, np.maximum(np.abs(distance) / _positive(floor), 1.0), 1.0)
    total: Floats = inverse.sum(axis=-1, keepdims=True)
    return inverse / total


def _map(line: Fit, change: Callable[[NDArray[Any]], NDArray[Any]]) -> Fit:
    return Fit(*(change(getattr(line, field.name)) for field in fields(line)))


def _taken(line: Fit, index: Counts) -> Fit:
    return _map(line, lambda field: field[index])


def _put(line: Fit, index: Counts, other: Fit) -> Fit:
    """The fit with some tracks replaced by others."""
    merged = _map(line, np.copy)
    for field in fields(line):
        getattr(merged, field.name)[index] = getattr(other, field.name)
    return merged
