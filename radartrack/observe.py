"""What a radar measures of a Cartesian state, with first and second derivatives, for extended Kalman filters.

Positions are relative to the radar. Azimuths are in (-pi, pi], elevations in [-pi/2, pi/2]. At the radar, and
for azimuth and elevation on the vertical axis above and below it, the measurement is still a number (an angle or
a direction cosine that is not defined is 0), and every derivative that does not exist is 0: a filter that uses
it learns nothing from that plot. For derivatives, a coordinate of a position smaller than 1e-100 m, in float32
than 1e-12 m, counts as zero.
"""

from collections.abc import Callable, Mapping, Sequence
from typing import Literal, NamedTuple, TypeAlias, get_args

import numpy as np
from numpy.typing import ArrayLike

from radartrack._arrays.validation import (
    RANGE_RATE as SPEED,
)
from radartrack._arrays.validation import (
    Domain,
    RealArray,
    broadcast_shape,
    one_of,
    real_arrays,
    require_covariance,
    require_trailing_shape,
    require_within,
)
from radartrack._conversion.sensors import SENSORS, AzimuthFrom, SensorName
from radartrack.generated import observe as formulas

Order: TypeAlias = Literal["linear", "second_order"]

POSITION = Domain(" m", 1e150, 1e15, "squares of larger numbers overflow", signed=True)
PROJECTED = Domain("", 1e200, 1e20, "squares of larger deviations overflow", signed=True)
POLE = {np.dtype(np.float64): 1e-100, np.dtype(np.float32): 1e-12}

_STATES: Mapping[SensorName, tuple[str, ...]] = {
    "polar": ("x", "y"),
    "spherical": ("x", "y", "z"),
    "polar_doppler": ("x", "y", "vx", "vy"),
    "ruv": ("x", "y", "z"),
}
_EXCHANGED = {"x": "y", "y": "x", "vx": "vy", "vy": "vx"}


class Observed(NamedTuple):
    """What is measured, (..., m), and its derivatives by the state, (..., m, n) and (..., m, n, n)."""

    measurement: RealArray
    jacobian: RealArray
    hessian: RealArray


class Projected(NamedTuple):
    """Mean, shape (..., m), and covariance, shape (..., m, m), of what will be measured."""

    mean: RealArray
    covariance: RealArray


def polar(state: ArrayLike, azimuth_from: AzimuthFrom = "x") -> Observed:
    """Observe range [m] and azimuth [rad] of a position in the plane.

    Args:
        state: x and y [m], shape (..., 2), from -1e150 to 1e150, in float32 from -1e15 to 1e15.
        azimuth_from: "x", counter-clockwise from the x axis, or "y", clockwise from the y axis (compass).

    Returns:
        Measurement, Jacobian and Hessian; float32 where the state is, and float64 otherwise
        (Bar-Shalom, Willett and Tian 2011, extended Kalman filter).

    Raises:
        TypeError: the state is not made of real numbers.
        ValueError: a number is not finite or lies outside the interval above, the shape is another one, or the
            word is unknown.

    """
    return _read("polar", state, azimuth_from)


def spherical(state: ArrayLike, azimuth_from: AzimuthFrom = "y") -> Observed:
    """Observe range [m], azimuth [rad] and elevation [rad] of a position in space.

    Args:
        state: x, y and z [m], shape (..., 3), each as for `polar`.
        azimuth_from: "y", clockwise from the y axis (compass), or "x", counter-clockwise from the x axis.

    Returns:
        As `polar`.

    Raises:
        TypeError: as for `polar`.
        ValueError: as for `polar`.

    """
    return _read("spherical", state, azimuth_from)


def polar_doppler(state: ArrayLike, azimuth_from: AzimuthFrom = "x") -> Observed:
    """Observe range [m], azimuth [rad] and range rate [m/s] of a position and velocity in the plane.

    At the radar the range rate counts as 0.

    Args:
        state: x, y [m], vx and vy [m/s], shape (..., 4), positions as for `polar`, speeds from -1e50 to 1e50, in
            float32 from -1e8 to 1e8.
        azimuth_from: "x", counter-clockwise from the x axis, or "y", clockwise from the y axis (compass).

    Returns:
        As `polar`.

    Raises:
        TypeError: as for `polar`.
        ValueError: as for `polar`.

    """
    return _read("polar_doppler", state, azimuth_from)


def ruv(state: ArrayLike) -> Observed:
    """Observe range [m] and the direction cosines u and v of a position in space.

    They do not tell a position from its mirror image behind the array, at negative z.

    Args:
        state: x, y and z [m], z along the normal of the array, shape (..., 3), each as for `polar`.

    Returns:
        As `polar`.

    Raises:
        TypeError: as for `polar`.
        ValueError: as for `polar`.

    """
    return _read("ruv", state, None)


def project(
    sensor: SensorName,
    mean: ArrayLike,
    covariance: ArrayLike,
    order: Order = "linear",
    azimuth_from: AzimuthFrom | None = None,
) -> Projected:
    """Carry a predicted Cartesian state over to what will be measured, as `predicted` of the conversions takes it.

    With g the observation, J its Jacobian and G its Hessian at the mean, P the covariance (Bar-Shalom, Willett
    and Tian 2011, first- and second-order extended Kalman filter):

    - linear: g and J P J';
    - second_order: g + tr(G P)/2 and J P J' + tr(G_a P G_b P)/2.

    Args:
        sensor: "polar", "spherical", "polar_doppler" or "ruv".
        mean: the state, as the function of this name takes it, shape (..., n).
        covariance: of the state, shape (..., n, n).
        order: the terms kept.
        azimuth_from: as the function of this name takes it; None for its default. "ruv" has none.

    Returns:
        Mean and covariance of the measured quantities. The mean azimuth is not wrapped; at "second_order" a mean
        elevation near the vertical may lie beyond it.

    Raises:
        TypeError: an argument is not made of real numbers.
        ValueError: a number is not finite or out of place, a shape is another one, the covariance is none, a
            word is unknown, or the mean lies where a direction has no derivative: at the radar, and with
            "spherical" on the vertical axis.

    """
    name = one_of("sensor", sensor, _STATES)
    second = one_of("order", order, get_args(Order)) == "second_order"
    arrays = real_arrays({"mean": mean, "covariance": covariance})
    size = len(_STATES[name])
    require_trailing_shape("covariance", arrays["covariance"], (size, size))
    require_covariance("covariance", arrays["covariance"])
    default = SENSORS[name].azimuth_from
    if default is None and azimuth_from is not None:
        raise ValueError(f"azimuth_from must be None for sensor {name!r}; got {azimuth_from!r}")
    chosen = default if azimuth_from is None else azimuth_from
    observed = _observe(name, "mean", arrays["mean"], chosen)
    broadcast_shape({"mean": arrays["mean"][..., 0], "covariance": arrays["covariance"][..., 0, 0]})
    _require_derivatives(name, arrays["mean"])
    with np.errstate(over="ignore", invalid="ignore"):  # what overflows is refused below
        projected = _moments(observed, arrays["covariance"], second=second)
    for part, values in projected._asdict().items():
        require_within(f"projected {part}", values, PROJECTED)
    return projected


def _read(sensor: SensorName, state: ArrayLike, azimuth_from: AzimuthFrom | None) -> Observed:
    return _observe(sensor, "state", real_arrays({"state": state})["state"], azimuth_from)


def _observe(sensor: SensorName, name: str, values: RealArray, azimuth_from: AzimuthFrom | None) -> Observed:
    coordinates = _STATES[sensor]
    require_trailing_shape(name, values, (len(coordinates),))
    for place, coordinate in enumerate(coordinates):
        domain = SPEED if coordinate in {"vx", "vy"} else POSITION
        require_within(f"{coordinate} of {name}", values[..., place], domain)
    order = [coordinates.index(_EXCHANGED.get(c, c)) for c in coordinates]
    if not SENSORS[sensor].is_turned(azimuth_from):
        order = list(range(len(coordinates)))
    state = values[..., order] + 0.0  # -0.0 becomes 0.0, so that the azimuth behind the radar is +pi
    near = _off_pole(state, coordinates)
    return Observed(
        _formula(sensor, "map", state),
        _formula(sensor, "jacobian", near)[..., order],
        _formula(sensor, "hessian", near)[..., order][..., order, :],
    )


def _formula(sensor: SensorName, kind: str, state: RealArray) -> RealArray:
    function: Callable[..., RealArray] = getattr(formulas, f"{sensor}_{kind}")
    return function(**dict(zip(_STATES[sensor], np.moveaxis(state, -1, 0), strict=True)))


def _off_pole(state: RealArray, coordinates: Sequence[str]) -> RealArray:
    """The state with coordinates of the position that are too small to divide by twice set to zero."""
    is_position = np.array([coordinate in {"x", "y", "z"} for coordinate in coordinates])
    return np.where(is_position & (np.abs(state) < POLE[state.dtype]), 0, state)


def _require_derivatives(sensor: SensorName, mean: RealArray) -> None:
    axes = 3 if sensor == "ruv" else 2
    place = "the radar" if axes == len(_STATES[sensor]) or sensor == "polar_doppler" else "the vertical axis"
    offset = np.abs(mean[..., :axes]).max(axis=-1)
    away = POSITION._replace(signed=False, smallest=POLE[mean.dtype], reason="there is no derivative nearer to it")
    require_within(f"mean's distance from {place}", offset, away)


def _moments(observed: Observed, covariance: RealArray, *, second: bool) -> Projected:
    """Both products are taken of a root of the covariance, so that no variance comes out negative."""
    measurement, jacobian, hessian = observed
    root = _root(covariance)
    linear = jacobian @ root
    projected = linear @ np.swapaxes(linear, -1, -2)
    if second:
        curved = np.swapaxes(root, -1, -2)[..., np.newaxis, :, :] @ hessian @ root[..., np.newaxis, :, :]
        measurement = measurement + np.trace(curved, axis1=-2, axis2=-1) / 2
        flat = curved.reshape(*curved.shape[:-2], curved.shape[-1] ** 2)
        projected = projected + flat @ np.swapaxes(flat, -1, -2) / 2
    symmetric = (projected + np.swapaxes(projected, -1, -2)) / 2
    return Projected(np.broadcast_to(measurement, symmetric.shape[:-1]).copy(), symmetric)


def _root(covariance: RealArray) -> RealArray:
    """R with R Rᵀ the covariance, from its correlations, as its units differ; rounding may leave one singular."""
    deviations = np.sqrt(np.diagonal(covariance, axis1=-2, axis2=-1))
    scale = deviations[..., :, np.newaxis] * deviations[..., np.newaxis, :]
    correlations = np.divide(covariance, scale, out=np.zeros_like(covariance), where=scale > 0)
    eigenvalues, vectors = np.linalg.eigh(correlations)
    root: RealArray = deviations[..., np.newaxis] * vectors * np.sqrt(np.maximum(eigenvalues, 0))[..., np.newaxis, :]
    return root
