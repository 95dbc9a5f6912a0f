"""Geodetic latitude, longitude and height, and the position fixed to the Earth."""

from typing import NamedTuple, overload

import numpy as np
from numpy.typing import ArrayLike

from radartrack._arrays.batches import fill
from radartrack._arrays.validation import (
    ANGLE,
    COVARIANCE,
    ELEVATION,
    SINGLE,
    Domain,
    RealArray,
    broadcast_shape,
    real_arrays,
    require_covariance,
    require_parts,
    require_trailing_shape,
    require_within,
)
from radartrack._filtering.moved_beliefs import carried, with_covariance
from radartrack.frames.exact_sines import angle_of
from radartrack.frames.reference_ellipsoid import WGS84, Ellipsoid
from radartrack.generated import frames as formulas
from radartrack.kalman import Belief

BLOCK = 2048  # positions; the many intermediate results of twice the digits stay in the cache
LATITUDE = ELEVATION._replace(reason="from pole to pole")
COORDINATE = Domain(" m", 1e100, 1e10, "squares of larger numbers overflow", signed=True)
FROM_AXIS = Domain(" m", 1e101, 1e11, "nearer to the axis the longitude is hardly known", smallest=1.0)
ABOVE_CURVATURE = Domain(" m", 1e101, 1e11, "deeper, the latitude is hardly known", smallest=-1e6)


class Geodetic(NamedTuple):
    """Latitude and longitude [rad] and height above the ellipsoid [m], each of the same shape."""

    latitude: RealArray
    longitude: RealArray
    height: RealArray


class GeodeticBelief(NamedTuple):
    """The same with the covariance of their errors, in this order, shape (..., 3, 3)."""

    latitude: RealArray
    longitude: RealArray
    height: RealArray
    covariance: RealArray


@overload
def ecef_from_geodetic(
    latitude: ArrayLike,
    longitude: ArrayLike,
    height: ArrayLike = ...,
    covariance: None = ...,
    *,
    ellipsoid: Ellipsoid = ...,
) -> RealArray: ...
@overload
def ecef_from_geodetic(
    latitude: ArrayLike,
    longitude: ArrayLike,
    height: ArrayLike,
    covariance: ArrayLike,
    *,
    ellipsoid: Ellipsoid = ...,
) -> Belief: ...
def ecef_from_geodetic(
    latitude: ArrayLike,
    longitude: ArrayLike,
    height: ArrayLike = 0.0,
    covariance: ArrayLike | None = None,
    *,
    ellipsoid: Ellipsoid = WGS84,
) -> RealArray | Belief:
    """The position fixed to the Earth: x to latitude and longitude 0, z to the north pole.

    Arguments broadcast. It is computed in float64, and is float32 where every array given is. It is right to a
    nanometre up to heights of 2000 km; beyond, coordinates lie farther apart, and each is the nearest or one beside it.

    Args:
        latitude: geodetic [rad], from -pi/2 to pi/2.
        longitude: eastward [rad].
        height: above the ellipsoid [m]; down to the centre of the Earth and beyond, if need be.
        covariance: of the errors of these three, shape (..., 3, 3), if known.
        ellipsoid: that the coordinates are of.

    Returns:
        The position [m], shape (..., 3); with a covariance given also that of its errors, which follows to first
        order: what the curvature of the Earth adds is the variance over twice its radius, a millimetre at 100 m.

    Raises:
        TypeError: an argument is not made of real numbers.
        ValueError: one is not finite or out of place, shapes do not fit, or the covariance is none.

    Source: Hofmann-Wellenhof & Moritz 2006, 5.6.1, doi:10.1007/978-3-211-33545-1.

    """
    where = read_geodetic(latitude, longitude, height)
    position = _position(where, ellipsoid)
    dtype = _type(latitude=latitude, longitude=longitude, height=height, covariance=covariance)
    if covariance is None:
        return position.astype(dtype, copy=False)
    errors = _read_covariance(covariance, position)
    jacobian = _formula("ecef_from_geodetic_jacobian", where, ellipsoid)
    return with_covariance(position.astype(dtype, copy=False), carried(jacobian, errors, dtype))


@overload
def geodetic_from_ecef(position: ArrayLike, covariance: None = ..., *, ellipsoid: Ellipsoid = ...) -> Geodetic: ...
@overload
def geodetic_from_ecef(position: ArrayLike, covariance: ArrayLike, *, ellipsoid: Ellipsoid = ...) -> GeodeticBelief: ...
def geodetic_from_ecef(
    position: ArrayLike, covariance: ArrayLike | None = None, *, ellipsoid: Ellipsoid = WGS84
) -> Geodetic | GeodeticBelief:
    """Latitude, longitude and height of a position fixed to the Earth, wherever it is.

    The normal is that at the nearest point of the ellipsoid. Latitude and longitude are right to half the distance to
    the next number: 0.7 nm on the ground, and 1.4 nm of a longitude beyond 115 degrees. On the axis the longitude is 0.
    At the centre of the Earth both poles are nearest, and in the plane of the equator up to 43 km around it one point
    in the north and one in the south: the northern one is taken.

    Args:
        position: x, y, z [m], shape (..., 3).
        covariance: of the errors of position, shape (..., 3, 3), if known.
        ellipsoid: that the coordinates are to be of.

    Returns:
        Latitude and longitude [rad] and height [m], of shape (...); with a covariance given also that of their errors,
        which follows to first order, shape (..., 3, 3), units rad^2, rad m and m^2.

    Raises:
        TypeError: an argument is not made of real numbers.
        ValueError: one is not finite or out of place, shapes do not fit, the covariance is none, or it is given where
            it has no first order: within a metre of the axis, and more than 1000 km below the ground.

    Source: Hofmann-Wellenhof & Moritz 2006, 5.6.1, doi:10.1007/978-3-211-33545-1.

    """
    arrays = real_arrays({"position": position})
    values = np.asarray(arrays["position"], np.float64)
    require_trailing_shape("position", values, (3,))
    require_within("position", values, COORDINATE)
    flat = np.ascontiguousarray(values.reshape(-1, 3))
    found = np.empty((3, len(flat)))
    _require_ellipsoid(ellipsoid)
    fill(lambda some, *places: _located(some, places, ellipsoid), [flat], list(found), BLOCK)
    where = Geodetic(*(part.reshape(values.shape[:-1])[()] for part in found))
    dtype = _type(position=position, covariance=covariance)
    typed = Geodetic(*(np.asarray(part, dtype)[()] for part in where))
    if covariance is None:
        return typed
    errors = _read_covariance(covariance, values)
    require_within("position's distance from the axis", np.hypot(values[..., 0], values[..., 1]), FROM_AXIS)
    require_within("position's height", where.height, ABOVE_CURVATURE)
    jacobian = _formula("geodetic_from_ecef_jacobian", where, ellipsoid)
    place = with_covariance(np.stack(typed, axis=-1), carried(jacobian, errors, dtype))
    latitude, longitude, height = np.moveaxis(place.mean, -1, 0)
    return GeodeticBelief(latitude, longitude, height, place.covariance)


def ecef_jacobian(
    latitude: ArrayLike, longitude: ArrayLike, height: ArrayLike = 0.0, *, ellipsoid: Ellipsoid = WGS84
) -> RealArray:
    """First derivatives of the position by latitude, longitude and height, [out, in], shape (..., 3, 3).

    Args:
        latitude: geodetic [rad], from -pi/2 to pi/2.
        longitude: eastward [rad].
        height: above the ellipsoid [m].
        ellipsoid: that the coordinates are of.

    Returns:
        Shape (..., 3, 3), units m/rad, m/rad and 1 by column.

    Raises:
        TypeError: an argument is not made of real numbers.
        ValueError: one is not finite or out of place, or shapes do not fit.

    Source: Hofmann-Wellenhof & Moritz 2006, 5.6.1, doi:10.1007/978-3-211-33545-1.

    """
    where = read_geodetic(latitude, longitude, height)
    dtype = _type(latitude=latitude, longitude=longitude, height=height)
    return _formula("ecef_from_geodetic_jacobian", where, ellipsoid).astype(dtype, copy=False)


def geodetic_jacobian(
    latitude: ArrayLike, longitude: ArrayLike, height: ArrayLike = 0.0, *, ellipsoid: Ellipsoid = WGS84
) -> RealArray:
    """First derivatives of latitude, longitude and height by the position, [out, in], shape (..., 3, 3).

    Towards the axis the derivatives of the longitude grow without bound.

    Args:
        latitude: geodetic [rad], from -pi/2 to pi/2.
        longitude: eastward [rad].
        height: above the ellipsoid [m].
        ellipsoid: that the coordinates are of.

    Returns:
        Shape (..., 3, 3), units rad/m, rad/m and 1 by row.

    Raises:
        TypeError: an argument is not made of real numbers.
        ValueError: one is not finite or out of place, or shapes do not fit.

    Source: Hofmann-Wellenhof & Moritz 2006, 5.6.1, doi:10.1007/978-3-211-33545-1.

    """
    where = read_geodetic(latitude, longitude, height)
    dtype = _type(latitude=latitude, longitude=longitude, height=height)
    return _formula("geodetic_from_ecef_jacobian", where, ellipsoid).astype(dtype, copy=False)


def _require_ellipsoid(ellipsoid: Ellipsoid) -> None:
    require_parts("ellipsoid", ellipsoid, ("semi_major_axis", "flattening"), "an Ellipsoid")


def _position(where: Geodetic, ellipsoid: Ellipsoid) -> RealArray:
    _require_ellipsoid(ellipsoid)
    shape = np.broadcast_shapes(*(part.shape for part in where))
    flat = [np.broadcast_to(part, shape).reshape(-1) for part in where]
    found = np.empty((len(flat[0]), 3))

    def fill_in(latitude: RealArray, longitude: RealArray, height: RealArray, position: RealArray) -> None:
        position.T[...] = ellipsoid.position(latitude, longitude, height)

    fill(fill_in, flat, [found], BLOCK)
    return found.reshape(*shape, 3)


def _located(positions: RealArray, places: tuple[RealArray, ...], ellipsoid: Ellipsoid) -> None:
    """Fill in latitude, longitude and height of positions, shape (n, 3)."""
    x, y, z = positions.T + 0.0  # of a zero with a sign the direction would be the other one
    latitude, longitude, height = places
    up, out = np.abs(z), np.hypot(x, y)
    cosine, sine = ellipsoid.normal_through(out, up)
    northern, height[...] = ellipsoid.along_the_normal((x, y, up), np.arctan2(sine, cosine))
    latitude[...] = np.where(z < 0, -northern, northern)
    longitude[...] = angle_of(x, y)


def _formula(name: str, where: Geodetic, ellipsoid: Ellipsoid) -> RealArray:
    _require_ellipsoid(ellipsoid)
    shape = {"semi_major_axis": ellipsoid.semi_major_axis, "flattening": ellipsoid.flattening}
    found: RealArray = getattr(formulas, name)(**where._asdict(), **shape)
    return found


def read_geodetic(latitude: ArrayLike, longitude: ArrayLike, height: ArrayLike) -> Geodetic:
    """Geodetic coordinates in float64.

    Raises:
        TypeError, ValueError: one is no real number or out of place, or the shapes do not broadcast.

    """
    given = {"latitude": latitude, "longitude": longitude, "height": height}
    arrays = {name: real_arrays({name: value})[name] for name, value in given.items()}  # each in its own type
    for (name, values), domain in zip(arrays.items(), (LATITUDE, ANGLE, COORDINATE), strict=True):
        require_within(name, values, domain)
    broadcast_shape(arrays)
    # A latitude of 90 degrees in float32 is beyond the pole in float64.
    doubled = {name: values.astype(np.float64) for name, values in arrays.items()}
    doubled["latitude"] = np.clip(doubled["latitude"], -np.pi / 2, np.pi / 2)
    return Geodetic(**doubled)


def read_covariance(covariance: ArrayLike, size: int) -> RealArray:
    """A covariance in float64, which it is to the rounding of the type that it was given in.

    Raises:
        TypeError, ValueError: it is none, or of another shape.

    """
    [given] = real_arrays({"covariance": covariance}).values()
    require_trailing_shape("covariance", given, (size, size))
    require_covariance("covariance", given)
    errors = given.astype(np.float64, copy=False)
    require_within("covariance", errors, COVARIANCE)
    return errors


def _read_covariance(covariance: ArrayLike, position: RealArray) -> RealArray:
    errors = read_covariance(covariance, 3)
    broadcast_shape({"position": position[..., 0], "covariance": errors[..., 0, 0]})
    return errors


def _type(**given: ArrayLike | None) -> "np.dtype[np.floating]":
    """Float32 where every array given is."""
    arrays = real_arrays({name: value for name, value in given.items() if value is not None})
    single = all(array.dtype == SINGLE for array in arrays.values())
    return np.dtype(np.float32) if single else np.dtype(np.float64)
