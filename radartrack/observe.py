"""What a radar measures of a Cartesian state, with first and second derivatives, for extended Kalman filters.

Positions are relative to the radar. Azimuths are in (-pi, pi], elevations in [-pi/2, pi/2]. At the radar, and
for azimuth and elevation on the vertical axis above and below it, the measurement is still a number (an angle or
a direction cosine that is not defined is 0), and every derivative that does not exist is 0: a filter that uses
it learns nothing from that plot. Where two sites observe together, the term of a site is 0 at that site, and so are
its derivatives. For derivatives, a coordinate of a position smaller than 1e-100 m, in float32
than 1e-12 m, counts as zero, and one nearer to another site as there.
"""

import math
from typing import Literal, NamedTuple, TypeAlias, get_args

import numpy as np
from numpy.typing import ArrayLike

from radartrack._arrays.batches import fill
from radartrack._arrays.validation import (
    COVARIANCE,
    RealArray,
    broadcast_shape,
    one_of,
    real_arrays,
    require_covariance,
    require_trailing_shape,
    require_within,
)
from radartrack._conversion.sensors import AzimuthFrom
from radartrack._observation.sights import SIGHTS, Sight, SightName, site_of

__all__ = [
    "Observed",
    "Projected",
    "bearing",
    "bistatic",
    "bistatic_range_rate",
    "polar",
    "polar_doppler",
    "project",
    "range_difference",
    "range_rate_difference",
    "ruv",
    "spherical",
    "spherical_doppler",
]


def __dir__() -> list[str]:
    return __all__


Order: TypeAlias = Literal["linear", "second_order"]

BLOCK = 2048  # states; their second derivatives stay in the cache


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

    Source: Bar-Shalom, Willett & Tian 2011, extended Kalman filter. `observe.polar.map`, `.jacobian` and `.hessian` of
    the formula book.

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

    Source: Bar-Shalom, Willett & Tian 2011, extended Kalman filter. `observe.spherical.map`, `.jacobian` and `.hessian`
    of the formula book.

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

    Source: Bar-Shalom, Willett & Tian 2011, extended Kalman filter. `observe.polar_doppler.map`, `.jacobian` and
    `.hessian` of the formula book.

    """
    return _read("polar_doppler", state, azimuth_from)


def spherical_doppler(state: ArrayLike, azimuth_from: AzimuthFrom = "y") -> Observed:
    """Observe range [m], azimuth [rad], elevation [rad] and range rate [m/s] of a position and velocity in space.

    At the radar the range rate counts as 0.

    Args:
        state: x, y, z [m], vx, vy and vz [m/s], shape (..., 6), each as for `polar_doppler`.
        azimuth_from: "y", clockwise from the y axis (compass), or "x", counter-clockwise from the x axis.

    Returns:
        As `polar`.

    Raises:
        TypeError: as for `polar`.
        ValueError: as for `polar`.

    Source: Bar-Shalom, Willett & Tian 2011, extended Kalman filter. `observe.spherical_doppler.map`, `.jacobian` and
    `.hessian` of the formula book.

    """
    return _read("spherical_doppler", state, azimuth_from)


def bearing(state: ArrayLike, azimuth_from: AzimuthFrom = "x") -> Observed:
    """Observe the azimuth [rad] alone of a position in the plane.

    Args:
        state: as for `polar`.
        azimuth_from: as for `polar`.

    Returns:
        As `polar`.

    Raises:
        TypeError: as for `polar`.
        ValueError: as for `polar`.

    Source: Bar-Shalom, Willett & Tian 2011, extended Kalman filter. `observe.bearing.map`, `.jacobian` and `.hessian`
    of the formula book.

    """
    return _read("bearing", state, azimuth_from)


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

    Source: Bar-Shalom, Willett & Tian 2011, extended Kalman filter. `observe.ruv.map`, `.jacobian` and `.hessian` of
    the formula book.

    """
    return _read("ruv", state, None)


def bistatic(state: ArrayLike, baseline: ArrayLike, azimuth_from: AzimuthFrom = "x") -> Observed:
    """Observe the path [m] from transmitter to target to receiver, and the azimuth [rad] at the receiver.

    The receiver is at the origin.

    Args:
        state: as for `polar`.
        baseline: distance of the transmitter [m], on the axis that the azimuth is counted from, from 0 to 1e100, in
            float32 to 1e10.
        azimuth_from: as for `polar`.

    Returns:
        As `polar`; state and baseline broadcast.

    Raises:
        TypeError: as for `polar`.
        ValueError: as for `polar`; also where state and baseline do not broadcast.

    Source: Bar-Shalom, Willett & Tian 2011, extended Kalman filter. `observe.bistatic.map`, `.jacobian` and `.hessian`
    of the formula book.

    """
    return _read("bistatic", state, azimuth_from, baseline=baseline)


def bistatic_range_rate(state: ArrayLike, baseline: ArrayLike, azimuth_from: AzimuthFrom = "x") -> Observed:
    """Observe the rate [m/s] at which the path from transmitter to target to receiver grows.

    Args:
        state: as for `polar_doppler`.
        baseline: as for `bistatic`.
        azimuth_from: the axis on which the transmitter stands.

    Returns:
        As `bistatic`.

    Raises:
        TypeError: as for `polar`.
        ValueError: as for `bistatic`.

    Source: Bar-Shalom, Willett & Tian 2011, extended Kalman filter. `observe.bistatic_range_rate.map`, `.jacobian` and
    `.hessian` of the formula book.

    """
    return _read("bistatic_range_rate", state, azimuth_from, baseline=baseline)


def range_difference(state: ArrayLike, receiver: ArrayLike) -> Observed:
    """Observe the range [m] from another receiver less that from the origin: the time difference of arrival times c.

    Args:
        state: as for `spherical`.
        receiver: x, y and z of the other receiver [m], shape (..., 3), each as those of the state.

    Returns:
        As `polar`; state and receiver broadcast.

    Raises:
        TypeError: as for `polar`.
        ValueError: as for `polar`; also where state and receiver do not broadcast.

    Source: Bar-Shalom, Willett & Tian 2011, extended Kalman filter. `observe.range_difference.map`, `.jacobian` and
    `.hessian` of the formula book.

    """
    return _read("range_difference", state, None, receiver=receiver)


def range_rate_difference(state: ArrayLike, receiver: ArrayLike) -> Observed:
    """Observe the range rate [m/s] at another receiver less that at the origin: the frequency difference of arrival.

    Both receivers stand still. At a wavelength w, the frequency received there is lower by this over w.

    Args:
        state: as for `spherical_doppler`.
        receiver: as for `range_difference`.

    Returns:
        As `range_difference`.

    Raises:
        TypeError: as for `polar`.
        ValueError: as for `range_difference`.

    Source: Bar-Shalom, Willett & Tian 2011, extended Kalman filter. `observe.range_rate_difference.map`, `.jacobian`
    and `.hessian` of the formula book.

    """
    return _read("range_rate_difference", state, None, receiver=receiver)


def project(
    sensor: SightName,
    mean: ArrayLike,
    covariance: ArrayLike,
    order: Order = "linear",
    azimuth_from: AzimuthFrom | None = None,
    **site: ArrayLike,
) -> Projected:
    """Carry a predicted Cartesian state over to what will be measured, as `predicted` of the conversions takes it.

    With g the observation, J its Jacobian and G its Hessian at the mean, P the covariance (Bar-Shalom, Willett
    and Tian 2011, first- and second-order extended Kalman filter):

    - linear: g and J P J';
    - second_order: g + tr(G P)/2 and J P J' + tr(G_a P G_b P)/2.

    Args:
        sensor: the name of a function above.
        mean: the state, as the function of this name takes it, shape (..., n).
        covariance: of the state, shape (..., n, n).
        order: the terms kept.
        azimuth_from: as the function of this name takes it; None for its default. Some have none.
        site: `baseline` or `receiver`, where the function of this name takes it.

    Returns:
        Mean and covariance of the measured quantities. The mean azimuth is not wrapped; at "second_order" a mean
        elevation near the vertical may lie beyond it.

    Raises:
        TypeError: an argument is not made of real numbers, or a site is missing or of no use.
        ValueError: a number is not finite or out of place, a shape is another one, the covariance is none, a
            word is unknown, or the mean lies where something measured has no derivative: at a site, and with
            "spherical" and "spherical_doppler" on the vertical axis.

    Source: Bar-Shalom, Willett & Tian 2011, first- and second-order extended Kalman filter.

    """
    sight = SIGHTS[one_of("sensor", sensor, SIGHTS)]
    second = one_of("order", order, get_args(Order)) == "second_order"
    arrays = real_arrays({"mean": mean, "covariance": covariance, **site_of(sight, site)})
    size = len(sight.state)
    require_trailing_shape("covariance", arrays["covariance"], (size, size))
    require_covariance(
        "covariance", real_arrays({"covariance": covariance})["covariance"]
    )  # to the rounding of its type
    places = sight.order(azimuth_from)
    sight.read_state("mean", arrays["mean"])
    there = sight.read_site(arrays)
    broadcast_shape({"mean": arrays["mean"][..., 0], **there, "covariance": arrays["covariance"][..., 0, 0]})
    sight.require_derivatives("mean", arrays["mean"][..., places], there)
    observed = _observed(sight, arrays["mean"], there, places)
    with np.errstate(over="ignore", invalid="ignore"):  # what overflows is refused below
        projected = _moments(observed, arrays["covariance"], second=second)
    for part, values in projected._asdict().items():
        require_within(f"projected {part}", values, COVARIANCE)
    return projected


def _read(name: SightName, state: ArrayLike, azimuth_from: AzimuthFrom | None, **site: ArrayLike) -> Observed:
    sight = SIGHTS[name]
    if sight.azimuth_from is not None:  # None is no word for an axis here
        one_of("azimuth_from", azimuth_from, get_args(AzimuthFrom))
    arrays = real_arrays({"state": state, **site})
    sight.read_state("state", arrays["state"])
    there = sight.read_site(arrays)
    broadcast_shape({"state": arrays["state"][..., 0], **there})
    return _observed(sight, arrays["state"], there, sight.order(azimuth_from))


def _observed(sight: Sight, states: RealArray, site: dict[str, RealArray], places: list[int]) -> Observed:
    shape = np.broadcast_shapes(states.shape[:-1], *(array.shape for array in site.values()))
    if math.prod(shape) <= BLOCK:
        return _at_once(sight, states, site, places)
    flat: list[RealArray] = [np.broadcast_to(states, (*shape, states.shape[-1])).reshape(-1, states.shape[-1])]
    flat += [np.broadcast_to(array, shape).reshape(-1) for array in site.values()]
    m, n = len(sight.outputs), len(sight.state)
    found = [np.empty((len(flat[0]), *sizes), states.dtype) for sizes in ((m,), (m, n), (m, n, n))]

    def block(some: RealArray, *others: RealArray) -> None:
        there = dict(zip(site, others, strict=False))
        for part, values in zip(others[len(site) :], _at_once(sight, some, there, places), strict=True):
            part[...] = values

    fill(block, flat, found, BLOCK)
    return Observed(*(part.reshape(*shape, *part.shape[1:]) for part in found))


def _at_once(sight: Sight, states: RealArray, site: dict[str, RealArray], places: list[int]) -> Observed:
    # -0.0 becomes 0.0, so that the azimuth behind the radar is +pi
    components = [states[..., place] + 0.0 for place in places]
    near = sight.off_poles(components, site)
    found = [sight.evaluate("map", components, site)]
    found += [sight.evaluate(kind, near, site) for kind in ("jacobian", "hessian")]
    if places != sorted(places):
        found[1:] = [found[1][..., places], found[2][..., places][..., places, :]]
    return Observed(*found)


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
