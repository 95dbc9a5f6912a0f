"""Straight lines and straight flights by definition: from points, eigenvectors and integrals over Gaussian errors."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from itertools import product
from typing import Any

import mpmath

from radartrack.derive.language.tensor import Tensor
from radartrack.verification.second_derivations.direct_series import derivatives
from radartrack.verification.second_derivations.point_sets import (
    OrdinaryFit,
    WeightedPoint,
    objective,
    points_with,
    principal_axis,
    squared_distance,
)
from radartrack.verification.second_derivations.van_loan_motion import moved

METHOD = "weighted points, eigenvectors and integrals over errors"
Number = Any
At = Mapping[str, Number]


def _scalar(value: Callable[[At], Number]) -> Callable[[At], Tensor[Number]]:
    return lambda at: Tensor((), (value(at),))


def _distance(at: At) -> Number:
    return _signed(at["x"], at["y"], at["k"], at["d"])


def _signed(x: Number, y: Number, slope: Number, intercept: Number) -> Number:
    """To the foot of the perpendicular; positive above the line."""
    size = mpmath.sqrt(squared_distance(x, y, slope, intercept))
    return size if y > slope * x + intercept else -size


def _derivatives(order: int) -> Callable[[At], Tensor[Number]]:
    def tensor(at: At) -> Tensor[Number]:
        found = derivatives([objective(points_with(at), at["k"], at["d"], order)], order, 2)
        return Tensor(found.shape[1:], found.entries)

    return tensor


def _intercept(at: At) -> Number:
    """The vertex of a parabola."""
    terms = objective(points_with(at), at["k"], mpmath.mpf(0), 2).terms
    return -terms[0, 1, 0] / terms[0, 2, 0] / 2


def _slope(at: At) -> Number:
    x, y, _ = principal_axis(points_with(at))
    return y / x


def _inclination(at: At) -> Number:
    x, y, _ = principal_axis(points_with(at))
    return mpmath.atan2(y, x)


def _ordinary(sums: At) -> OrdinaryFit:
    """A fit of x over t, the sums being those of the formulas."""
    names = {"W": "n", "mean_x": "mean_t", "S_xx": "S_tt", "S_xy": "S_tx", "S_yy": "S_xx"}
    return OrdinaryFit(points_with({name: sums[of] for name, of in names.items() if of in sums}))


def _ordinary_variance(at: At) -> Number:
    fit = _ordinary(at)
    return fit.residual_squares / fit.degrees_of_freedom


def _spread_of_size(of: Callable[[Number], Number]) -> Number:
    """The standard deviation of |f(w)| for w ~ N(0, 1) and f odd, by integration over the half of it."""

    def mean(power: int) -> Number:
        density = 2 / mpmath.sqrt(2 * mpmath.pi)
        return density * mpmath.quad(lambda w: abs(of(w)) ** power * mpmath.exp(-(w**2) / 2), [0, 2, 6, mpmath.inf])

    return mpmath.sqrt(mean(2) - mean(1) ** 2)


def _mean_size(_: At) -> Number:
    whole = mpmath.quad(lambda w: mpmath.exp(-(w**2) / 2), [0, 2, 6, mpmath.inf])
    return mpmath.quad(lambda w: w * mpmath.exp(-(w**2) / 2), [0, 2, 6, mpmath.inf]) / whole


def _residual(at: At) -> Number:
    position, _ = moved([at["d"], at["v"]], at["t"])
    return at["x"] - position


def _motion_distance(at: At) -> Number:
    return _signed(at["c"] * at["t"], at["x"], at["v"] / at["c"], at["d"])


def _printed(speed: Number, sigma: Number, c: Number) -> Number:
    return _spread_of_size(lambda w: _signed(mpmath.mpf(0), sigma * w, speed / c, mpmath.mpf(0)))


def _printed_position(at: At) -> Number:
    both = [_printed(at[f"v_{axis}"], at[f"sigma_{axis}"], at["c"]) for axis in "xy"]
    return _root_mean_square(*both)


def _population(at: At) -> list[WeightedPoint]:
    """Four plots with the moments of many, in the plane of c t and x."""
    quarter = mpmath.mpf(1) / 4
    signs = product((-1, 1), repeat=2)
    times = [(early * at["std_t"], off * at["sigma_x"]) for early, off in signs]
    return [WeightedPoint(quarter, at["c"] * t, at["v"] * t + error) for t, error in times]


def _slope_limit(at: At) -> Number:
    x, y, _ = principal_axis(_population(at))
    return at["c"] * y / x


def _root_mean_square(*deviations: Number) -> Number:
    """Of a coordinate of a vector of errors, each being either way as large as it is deviant."""
    ways = list(product((-1, 1), repeat=len(deviations)))
    squares = [sum((way * each) ** 2 for way, each in zip(signs, deviations, strict=True)) for signs in ways]
    return mpmath.sqrt(mpmath.fsum(squares) / len(ways) / len(deviations))


DERIVATIONS: dict[str, Callable[[At], Tensor[Number]]] = {
    "line.distance": _scalar(_distance),
    "line.objective": _scalar(lambda at: objective(points_with(at), at["k"], at["d"]).value),
    "line.gradient": _derivatives(1),
    "line.hessian": _derivatives(2),
    "line.intercept": _scalar(_intercept),
    "line.slope": _scalar(_slope),
    "line.inclination": _scalar(_inclination),
    "line.ordinary.slope": _scalar(lambda at: _ordinary(at).intercept_and_slope[1]),
    "line.ordinary.leverage": _scalar(lambda at: _ordinary(at).leverage(at["t"])),
    "line.ordinary.degrees_of_freedom": _scalar(lambda at: _ordinary(at).degrees_of_freedom),
    "line.ordinary.variance": _scalar(_ordinary_variance),
    "line.folded_mean_factor": _scalar(_mean_size),
    "line.folded_std_factor": _scalar(lambda _: _spread_of_size(lambda w: w)),
    "line.folded_std": _scalar(lambda at: _spread_of_size(lambda w: at["sigma_l"] * w)),
    "line.motion.residual": _scalar(_residual),
    "line.motion.distance": _scalar(_motion_distance),
    "line.motion.printed_std": _scalar(lambda at: _printed(at["v"], at["sigma_x"], at["c"])),
    "line.motion.printed_position_std": _scalar(_printed_position),
    "line.motion.slope_limit": _scalar(_slope_limit),
    "line.motion.variance_limit": _scalar(lambda at: principal_axis(_population(at))[2]),
    "line.position_std": _scalar(lambda at: _root_mean_square(at["sigma_x"], at["sigma_y"])),
    "line.position_std_in_space": _scalar(
        lambda at: _root_mean_square(at["sigma_x"], at["sigma_y"], at["sigma_z"]),
    ),
}
