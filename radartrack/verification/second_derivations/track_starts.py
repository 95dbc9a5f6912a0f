"""First states of tracks from moments of the line of sight: whatever lies across it is isotropic.

With e the line of sight, s the radial velocity and sigma_v the deviation of what is known of velocities, the velocity
has the second moments E[s^2] E[e e'] + sigma_v^2 (1 - E[e e']), and with the position E[r s] E[e e'].
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

import mpmath

from radartrack.derive.language.tensor import Tensor

METHOD = "moments of the line of sight"
Number = Any
At = Mapping[str, Number]


def _along(at: At) -> tuple[Any, Any]:
    """Mean and covariance of range and radial velocity, in information form."""
    r, rate = at["sigma_r"], at["sigma_rdot"]
    noise = mpmath.matrix([[r**2, at["rho"] * r * rate], [at["rho"] * r * rate, rate**2]])
    information = noise**-1
    covariance = (information + mpmath.diag([0, at["sigma_v"] ** -2])) ** -1
    return covariance * information * mpmath.matrix([at["r"], at["rdot"]]), covariance


def _waves(angle: Number, deviation: Number) -> dict[str, Number]:
    """Means of cosine, sine, their squares and their product."""
    once, twice = mpmath.exp(-(deviation**2) / 2), mpmath.exp(-2 * deviation**2)
    return {
        "c": once * mpmath.cos(angle),
        "s": once * mpmath.sin(angle),
        "cc": (1 + twice * mpmath.cos(2 * angle)) / 2,
        "ss": (1 - twice * mpmath.cos(2 * angle)) / 2,
        "cs": twice * mpmath.sin(2 * angle) / 2,
    }


def _sight(at: At) -> tuple[Any, Any]:
    """Mean and second moments of the line of sight."""
    azimuth = _waves(at["beta"], at["sigma_beta"])
    if "epsilon" not in at:
        mean = mpmath.matrix([azimuth["c"], azimuth["s"]])
        return mean, mpmath.matrix([[azimuth["cc"], azimuth["cs"]], [azimuth["cs"], azimuth["ss"]]])
    up = _waves(at["epsilon"], at["sigma_epsilon"])
    mean = mpmath.matrix([up["c"] * azimuth["s"], up["c"] * azimuth["c"], up["s"]])
    x_y, x_z, y_z = up["cc"] * azimuth["cs"], up["cs"] * azimuth["s"], up["cs"] * azimuth["c"]
    return mean, mpmath.matrix(
        [[up["cc"] * azimuth["ss"], x_y, x_z], [x_y, up["cc"] * azimuth["cc"], y_z], [x_z, y_z, up["ss"]]]
    )


def _estimate(at: At) -> Tensor[Number]:
    likely, _ = _along(at)
    mean, _ = _sight(at)
    size = len(mean)
    return Tensor((2 * size,), tuple(likely[k // size] * mean[k % size] for k in range(2 * size)))


def _covariance(at: At) -> Tensor[Number]:
    likely, covariance = _along(at)
    mean, square = _sight(at)
    size = len(mean)

    def entry(i: int, j: int) -> Number:
        (a, m), (b, n) = divmod(i, size), divmod(j, size)
        moment = (likely[a] * likely[b] + covariance[a, b]) * square[m, n]
        if a == b == 1:
            moment += at["sigma_v"] ** 2 * (int(m == n) - square[m, n])
        return moment - likely[a] * mean[m] * likely[b] * mean[n]

    return Tensor.build((2 * size, 2 * size), entry)


def _weights(at: At) -> Any:
    """Of the line through both plots: its value and slope at the second."""
    return mpmath.matrix([[1, -at["T"]], [1, 0]]) ** -1


def _line(at: At) -> Tensor[Number]:
    found = _weights(at) * mpmath.matrix([at["first"], at["second"]])
    return Tensor((2,), (found[0], found[1]))


def _line_covariance(at: At) -> Tensor[Number]:
    weights = _weights(at)
    found = weights * mpmath.diag([at["first_covariance"], at["second_covariance"]]) * weights.T
    return Tensor.build((2, 2), lambda i, j: found[i, j])


DERIVATIONS: dict[str, Callable[[At], Tensor[Number]]] = {
    **{f"initiation.one_plot.{sensor}.estimate": _estimate for sensor in ("polar_doppler", "spherical_doppler")},
    **{f"initiation.one_plot.{sensor}.covariance": _covariance for sensor in ("polar_doppler", "spherical_doppler")},
    "initiation.two_plots.estimate": _line,
    "initiation.two_plots.covariance": _line_covariance,
}
