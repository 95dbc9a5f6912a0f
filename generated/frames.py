"""NumPy functions of the quantities frames.*.

Written by radartrack regenerate, generator 1, derivation bd7b0116f42b2f03; not to be edited.
"""

import numpy as np
import numpy.typing as npt

__all__ = [
    "antenna_from_enu_jacobian",
    "antenna_from_enu_map",
    "ecef_from_geodetic_jacobian",
    "ecef_from_geodetic_map",
    "enu_from_ecef_jacobian",
    "enu_from_ecef_map",
    "face_from_enu_jacobian",
    "face_from_enu_map",
    "geodetic_from_ecef_jacobian",
]

Floats = npt.NDArray[np.floating]


def _floats(*arguments: npt.ArrayLike) -> tuple[Floats, ...]:
    """The arguments as arrays of one type: float32 where every array is float32, else float64.

    Python numbers follow the arrays; integers and anything narrower than float32 compute in float64.
    """
    typed = [np.asarray(argument) for argument in arguments if hasattr(argument, "dtype")]
    single = bool(typed) and all(array.dtype == np.float32 for array in typed)
    dtype = np.float32 if single else np.float64
    arrays = (np.asarray(argument) for argument in arguments)
    return tuple(array.astype(dtype, casting="same_kind", copy=False) for array in arrays)


def _empty(arguments: tuple[Floats, ...], shape: tuple[int, ...]) -> Floats:
    """Room for a result: the shape that the arguments broadcast to, then the tensor's own."""
    return np.empty(np.broadcast_shapes(*(a.shape for a in arguments)) + shape, arguments[0].dtype)


def _ratio(above: Floats, below: Floats) -> Floats:
    """above / below, and zero where below is zero."""
    shape = np.broadcast_shapes(np.shape(above), np.shape(below))
    quotient = np.zeros(shape, np.result_type(above, below))
    return np.divide(above, below, out=quotient, where=below != 0)


def ecef_from_geodetic_map(
    *,
    latitude: npt.ArrayLike,
    longitude: npt.ArrayLike,
    height: npt.ArrayLike,
    semi_major_axis: npt.ArrayLike,
    flattening: npt.ArrayLike,
) -> Floats:
    """Position (x, y, z) fixed to the Earth, from geodetic latitude, longitude and height.

    Name: frames.ecef_from_geodetic.map.
    Definition: grad max(n'x) + height n, for x on the ellipsoid and n its normal.
    Conditioning: no expectation is taken.
    Source: Hofmann-Wellenhof & Moritz 2006 5.6.1, doi:10.1007/978-3-211-33545-1.

    Args:
        latitude: geodetic latitude [rad], -1.5708 to 1.5708.
        longitude: longitude, eastward [rad], -3.1416 to 3.1416.
        height: height above the ellipsoid [m], -6.3e+06 to 1e+08.
        semi_major_axis: equatorial radius of the ellipsoid [m], 6.3e+06 to 6.5e+06.
        flattening: one less the ratio of the polar radius to the equatorial one [1], 0 to 0.01.

    Returns:
        Shape of the broadcast arguments + (3), unit m.

    Accuracy: at most 8.01 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64). Errors are measured against the sizes of the terms.
    """
    arguments = _floats(latitude, longitude, height, semi_major_axis, flattening)
    latitude, longitude, height, semi_major_axis, flattening = arguments
    cos_latitude = np.cos(latitude)
    sin_latitude = np.sin(latitude)
    cos_longitude = np.cos(longitude)
    sin_longitude = np.sin(longitude)
    squared_eccentricity = (2.0 - flattening) * flattening
    sin_latitude_squared = sin_latitude**2
    root = np.sqrt(1.0 - sin_latitude_squared * squared_eccentricity)
    term_1 = 1.0 / (1.0 + root)
    term_2 = 1.0 / root
    lift = height + semi_major_axis * sin_latitude_squared * squared_eccentricity * term_1 * term_2
    drop = height - (cos_latitude**2 + root) * semi_major_axis * squared_eccentricity * term_1 * term_2
    to_axis = lift + semi_major_axis
    to_equator = drop + semi_major_axis
    result = _empty(arguments, (3,))
    result[..., 0] = cos_latitude * cos_longitude * to_axis
    result[..., 1] = cos_latitude * sin_longitude * to_axis
    result[..., 2] = sin_latitude * to_equator
    return result


def ecef_from_geodetic_jacobian(
    *,
    latitude: npt.ArrayLike,
    longitude: npt.ArrayLike,
    height: npt.ArrayLike,
    semi_major_axis: npt.ArrayLike,
    flattening: npt.ArrayLike,
) -> Floats:
    """First derivatives of the position (x, y, z) by latitude, longitude and height, [out, in].

    Name: frames.ecef_from_geodetic.jacobian.
    Definition: d(x, y, z)/d(latitude, longitude, height).
    Conditioning: no expectation is taken.
    Source: Hofmann-Wellenhof & Moritz 2006 5.6.1, doi:10.1007/978-3-211-33545-1.

    Args:
        latitude: geodetic latitude [rad], -1.5708 to 1.5708.
        longitude: longitude, eastward [rad], -3.1416 to 3.1416.
        height: height above the ellipsoid [m], -6.3e+06 to 1e+08.
        semi_major_axis: equatorial radius of the ellipsoid [m], 6.3e+06 to 6.5e+06.
        flattening: one less the ratio of the polar radius to the equatorial one [1], 0 to 0.01.

    Returns:
        Shape of the broadcast arguments + (3, 3), unit [m, m, m] × [1/rad, 1/rad, 1/m].

    Accuracy: at most 21.2 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64). Errors are measured against the sizes of the terms.
    """
    arguments = _floats(latitude, longitude, height, semi_major_axis, flattening)
    latitude, longitude, height, semi_major_axis, flattening = arguments
    cos_latitude = np.cos(latitude)
    sin_latitude = np.sin(latitude)
    cos_longitude = np.cos(longitude)
    sin_longitude = np.sin(longitude)
    squared_eccentricity = (2.0 - flattening) * flattening
    sin_latitude_squared = sin_latitude**2
    root = np.sqrt(1.0 - sin_latitude_squared * squared_eccentricity)
    lift = height + semi_major_axis * sin_latitude_squared * squared_eccentricity / ((1.0 + root) * root)
    to_axis = lift + semi_major_axis
    to_meridian_centre = height + (1.0 - flattening)**2 * semi_major_axis / (root * root**2)
    result = _empty(arguments, (3, 3))
    result[..., 0, 0] = -cos_longitude * sin_latitude * to_meridian_centre
    result[..., 0, 1] = -cos_latitude * sin_longitude * to_axis
    result[..., 0, 2] = cos_latitude * cos_longitude
    result[..., 1, 0] = -sin_latitude * sin_longitude * to_meridian_centre
    result[..., 1, 1] = cos_latitude * cos_longitude * to_axis
    result[..., 1, 2] = cos_latitude * sin_longitude
    result[..., 2, 0] = cos_latitude * to_meridian_centre
    result[..., 2, 1] = 0.0
    result[..., 2, 2] = sin_latitude
    return result


def geodetic_from_ecef_jacobian(
    *,
    latitude: npt.ArrayLike,
    longitude: npt.ArrayLike,
    height: npt.ArrayLike,
    semi_major_axis: npt.ArrayLike,
    flattening: npt.ArrayLike,
) -> Floats:
    """First derivatives of latitude, longitude and height by the position (x, y, z), [out, in]; those of the longitude are zero on the axis, where they do not exist.

    Name: frames.geodetic_from_ecef.jacobian.
    Definition: the inverse of d(x, y, z)/d(latitude, longitude, height).
    Conditioning: no expectation is taken.
    Source: Hofmann-Wellenhof & Moritz 2006 5.6.1, doi:10.1007/978-3-211-33545-1.

    Args:
        latitude: geodetic latitude [rad], -1.5708 to 1.5708.
        longitude: longitude, eastward [rad], -3.1416 to 3.1416.
        height: height above the ellipsoid [m], -1e+06 to 1e+08.
        semi_major_axis: equatorial radius of the ellipsoid [m], 6.3e+06 to 6.5e+06.
        flattening: one less the ratio of the polar radius to the equatorial one [1], 0 to 0.01.

    Returns:
        Shape of the broadcast arguments + (3, 3), unit [rad, rad, m] × [1/m, 1/m, 1/m].

    Accuracy: at most 20.9 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64).
    """
    arguments = _floats(latitude, longitude, height, semi_major_axis, flattening)
    latitude, longitude, height, semi_major_axis, flattening = arguments
    cos_latitude = np.cos(latitude)
    sin_latitude = np.sin(latitude)
    cos_longitude = np.cos(longitude)
    sin_longitude = np.sin(longitude)
    squared_eccentricity = (2.0 - flattening) * flattening
    sin_latitude_squared = sin_latitude**2
    root = np.sqrt(1.0 - sin_latitude_squared * squared_eccentricity)
    lift = height + semi_major_axis * sin_latitude_squared * squared_eccentricity / ((1.0 + root) * root)
    to_axis = lift + semi_major_axis
    to_meridian_centre = height + (1.0 - flattening)**2 * semi_major_axis / (root * root**2)
    product_1 = cos_latitude * to_axis
    result = _empty(arguments, (3, 3))
    result[..., 0, 0] = _ratio(-cos_longitude * sin_latitude, to_meridian_centre)
    result[..., 0, 1] = _ratio(-sin_latitude * sin_longitude, to_meridian_centre)
    result[..., 0, 2] = _ratio(cos_latitude, to_meridian_centre)
    result[..., 1, 0] = _ratio(-sin_longitude, product_1)
    result[..., 1, 1] = _ratio(cos_longitude, product_1)
    result[..., 1, 2] = 0.0
    result[..., 2, 0] = cos_latitude * cos_longitude
    result[..., 2, 1] = cos_latitude * sin_longitude
    result[..., 2, 2] = sin_latitude
    return result


def enu_from_ecef_map(
    *,
    x: npt.ArrayLike,
    y: npt.ArrayLike,
    z: npt.ArrayLike,
    latitude: npt.ArrayLike,
    longitude: npt.ArrayLike,
    height: npt.ArrayLike,
    semi_major_axis: npt.ArrayLike,
    flattening: npt.ArrayLike,
) -> Floats:
    """Position east, north and up of a site, from that fixed to the Earth.

    Name: frames.enu_from_ecef.map.
    Definition: R (ecef - site).
    Conditioning: no expectation is taken.
    Source: Hofmann-Wellenhof & Moritz 2006 5.6.1, doi:10.1007/978-3-211-33545-1.

    Args:
        x: position along the x axis of the Earth [m], -1e+08 to 1e+08.
        y: position along the y axis of the Earth [m], -1e+08 to 1e+08.
        z: position along the z axis of the Earth [m], -1e+08 to 1e+08.
        latitude: geodetic latitude [rad], -1.5708 to 1.5708.
        longitude: longitude, eastward [rad], -3.1416 to 3.1416.
        height: height above the ellipsoid [m], -10000 to 1e+08.
        semi_major_axis: equatorial radius of the ellipsoid [m], 6.3e+06 to 6.5e+06.
        flattening: one less the ratio of the polar radius to the equatorial one [1], 0 to 0.01.

    Returns:
        Shape of the broadcast arguments + (3), unit m.

    Accuracy: at most 33.6 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64). Errors are measured against the sizes of the terms.
    """
    arguments = _floats(x, y, z, latitude, longitude, height, semi_major_axis, flattening)
    x, y, z, latitude, longitude, height, semi_major_axis, flattening = arguments
    cos_latitude = np.cos(latitude)
    sin_latitude = np.sin(latitude)
    cos_longitude = np.cos(longitude)
    sin_longitude = np.sin(longitude)
    squared_eccentricity = (2.0 - flattening) * flattening
    sin_latitude_squared = sin_latitude**2
    root = np.sqrt(1.0 - sin_latitude_squared * squared_eccentricity)
    term_1 = 1.0 / (1.0 + root)
    term_2 = 1.0 / root
    lift = height + semi_major_axis * sin_latitude_squared * squared_eccentricity * term_1 * term_2
    drop = height - (cos_latitude**2 + root) * semi_major_axis * squared_eccentricity * term_1 * term_2
    to_axis = lift + semi_major_axis
    to_equator = drop + semi_major_axis
    x_from_site = x - cos_latitude * cos_longitude * to_axis
    y_from_site = y - cos_latitude * sin_longitude * to_axis
    z_from_site = z - sin_latitude * to_equator
    result = _empty(arguments, (3,))
    result[..., 0] = cos_longitude * y_from_site - sin_longitude * x_from_site
    result[..., 1] = (
        cos_latitude * z_from_site
        - cos_longitude * sin_latitude * x_from_site
        - sin_latitude * sin_longitude * y_from_site
    )
    result[..., 2] = (
        cos_latitude * cos_longitude * x_from_site
        + cos_latitude * sin_longitude * y_from_site
        + sin_latitude * z_from_site
    )
    return result


def enu_from_ecef_jacobian(*, latitude: npt.ArrayLike, longitude: npt.ArrayLike) -> Floats:
    """Directions east, north and up of a site, in the axes of the Earth, [out, in].

    Name: frames.enu_from_ecef.jacobian.
    Definition: R.
    Conditioning: no expectation is taken.
    Source: Hofmann-Wellenhof & Moritz 2006 5.6.1, doi:10.1007/978-3-211-33545-1.

    Args:
        latitude: geodetic latitude [rad], -1.5708 to 1.5708.
        longitude: longitude, eastward [rad], -3.1416 to 3.1416.

    Returns:
        Shape of the broadcast arguments + (3, 3), unit 1.

    Accuracy: at most 2.89 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 9.82.
    """
    arguments = _floats(latitude, longitude)
    latitude, longitude = arguments
    sin_longitude = np.sin(longitude)
    cos_longitude = np.cos(longitude)
    sin_latitude = np.sin(latitude)
    cos_latitude = np.cos(latitude)
    result = _empty(arguments, (3, 3))
    result[..., 0, 0] = -sin_longitude
    result[..., 0, 1] = cos_longitude
    result[..., 0, 2] = 0.0
    result[..., 1, 0] = -cos_longitude * sin_latitude
    result[..., 1, 1] = -sin_latitude * sin_longitude
    result[..., 1, 2] = cos_latitude
    result[..., 2, 0] = cos_latitude * cos_longitude
    result[..., 2, 1] = cos_latitude * sin_longitude
    result[..., 2, 2] = sin_latitude
    return result


def antenna_from_enu_map(
    *,
    east: npt.ArrayLike,
    north: npt.ArrayLike,
    up: npt.ArrayLike,
    azimuth: npt.ArrayLike,
    tilt: npt.ArrayLike,
    roll: npt.ArrayLike,
) -> Floats:
    """Position along the axes of a radar's antenna, y ahead and z upwards, from that east, north and up of it.

    Name: frames.antenna_from_enu.map.
    Definition: R(roll) R(tilt) R(azimuth) (east, north, up).
    Conditioning: no expectation is taken.
    Source: Crouse 2014 local coordinate systems.

    Args:
        east: position east of the site [m], -1e+08 to 1e+08.
        north: position north of the site [m], -1e+08 to 1e+08.
        up: position above the horizon of the site [m], -1e+08 to 1e+08.
        azimuth: where the radar looks, clockwise from north [rad], -3.1416 to 3.1416.
        tilt: how far it looks up from the horizon [rad], -1.5708 to 1.5708.
        roll: how far it is turned about where it looks, its right side down [rad], -3.1416 to 3.1416.

    Returns:
        Shape of the broadcast arguments + (3), unit m.

    Accuracy: at most 17.5 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64). Errors are measured against the sizes of the terms.
    """
    arguments = _floats(east, north, up, azimuth, tilt, roll)
    east, north, up, azimuth, tilt, roll = arguments
    cos_tilt = np.cos(tilt)
    sin_roll = np.sin(roll)
    cos_azimuth = np.cos(azimuth)
    cos_roll = np.cos(roll)
    sin_azimuth = np.sin(azimuth)
    sin_tilt = np.sin(tilt)
    sum_1 = cos_azimuth * cos_roll + sin_azimuth * sin_roll * sin_tilt
    sum_2 = cos_azimuth * sin_roll * sin_tilt - cos_roll * sin_azimuth
    sum_3 = cos_azimuth * sin_roll - cos_roll * sin_azimuth * sin_tilt
    sum_4 = -cos_azimuth * cos_roll * sin_tilt - sin_azimuth * sin_roll
    result = _empty(arguments, (3,))
    result[..., 0] = east * sum_1 - cos_tilt * sin_roll * up + north * sum_2
    result[..., 1] = cos_azimuth * cos_tilt * north + cos_tilt * east * sin_azimuth + sin_tilt * up
    result[..., 2] = cos_roll * cos_tilt * up + east * sum_3 + north * sum_4
    return result


def antenna_from_enu_jacobian(*, azimuth: npt.ArrayLike, tilt: npt.ArrayLike, roll: npt.ArrayLike) -> Floats:
    """Axes of a radar's antenna, y ahead and z upwards, in terms of east, north and up, [out, in].

    Name: frames.antenna_from_enu.jacobian.
    Definition: R(roll) R(tilt) R(azimuth).
    Conditioning: no expectation is taken.
    Source: Crouse 2014 local coordinate systems.

    Args:
        azimuth: where the radar looks, clockwise from north [rad], -3.1416 to 3.1416.
        tilt: how far it looks up from the horizon [rad], -1.5708 to 1.5708.
        roll: how far it is turned about where it looks, its right side down [rad], -3.1416 to 3.1416.

    Returns:
        Shape of the broadcast arguments + (3, 3), unit 1.

    Accuracy: at most 12.4 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 263. Errors are measured against the
    sizes of the terms.
    """
    arguments = _floats(azimuth, tilt, roll)
    azimuth, tilt, roll = arguments
    cos_azimuth = np.cos(azimuth)
    cos_roll = np.cos(roll)
    sin_azimuth = np.sin(azimuth)
    sin_roll = np.sin(roll)
    sin_tilt = np.sin(tilt)
    cos_tilt = np.cos(tilt)
    result = _empty(arguments, (3, 3))
    result[..., 0, 0] = cos_azimuth * cos_roll + sin_azimuth * sin_roll * sin_tilt
    result[..., 0, 1] = cos_azimuth * sin_roll * sin_tilt - cos_roll * sin_azimuth
    result[..., 0, 2] = -cos_tilt * sin_roll
    result[..., 1, 0] = cos_tilt * sin_azimuth
    result[..., 1, 1] = cos_azimuth * cos_tilt
    result[..., 1, 2] = sin_tilt
    result[..., 2, 0] = cos_azimuth * sin_roll - cos_roll * sin_azimuth * sin_tilt
    result[..., 2, 1] = -cos_azimuth * cos_roll * sin_tilt - sin_azimuth * sin_roll
    result[..., 2, 2] = cos_roll * cos_tilt
    return result


def face_from_enu_map(
    *,
    east: npt.ArrayLike,
    north: npt.ArrayLike,
    up: npt.ArrayLike,
    azimuth: npt.ArrayLike,
    tilt: npt.ArrayLike,
    roll: npt.ArrayLike,
) -> Floats:
    """Position along the axes of a radar's face, z ahead and y upwards, from that east, north and up of it.

    Name: frames.face_from_enu.map.
    Definition: R(roll) R(tilt) R(azimuth) (east, north, up).
    Conditioning: no expectation is taken.
    Source: Crouse 2014 local coordinate systems.

    Args:
        east: position east of the site [m], -1e+08 to 1e+08.
        north: position north of the site [m], -1e+08 to 1e+08.
        up: position above the horizon of the site [m], -1e+08 to 1e+08.
        azimuth: where the radar looks, clockwise from north [rad], -3.1416 to 3.1416.
        tilt: how far it looks up from the horizon [rad], -1.5708 to 1.5708.
        roll: how far it is turned about where it looks, its right side down [rad], -3.1416 to 3.1416.

    Returns:
        Shape of the broadcast arguments + (3), unit m.

    Accuracy: at most 17.5 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64). Errors are measured against the sizes of the terms.
    """
    arguments = _floats(east, north, up, azimuth, tilt, roll)
    east, north, up, azimuth, tilt, roll = arguments
    cos_azimuth = np.cos(azimuth)
    cos_roll = np.cos(roll)
    sin_azimuth = np.sin(azimuth)
    sin_roll = np.sin(roll)
    sin_tilt = np.sin(tilt)
    sum_1 = -cos_azimuth * cos_roll - sin_azimuth * sin_roll * sin_tilt
    sum_2 = cos_roll * sin_azimuth - cos_azimuth * sin_roll * sin_tilt
    cos_tilt = np.cos(tilt)
    sum_3 = cos_azimuth * sin_roll - cos_roll * sin_azimuth * sin_tilt
    sum_4 = -cos_azimuth * cos_roll * sin_tilt - sin_azimuth * sin_roll
    result = _empty(arguments, (3,))
    result[..., 0] = cos_tilt * sin_roll * up + east * sum_1 + north * sum_2
    result[..., 1] = cos_roll * cos_tilt * up + east * sum_3 + north * sum_4
    result[..., 2] = cos_azimuth * cos_tilt * north + cos_tilt * east * sin_azimuth + sin_tilt * up
    return result


def face_from_enu_jacobian(*, azimuth: npt.ArrayLike, tilt: npt.ArrayLike, roll: npt.ArrayLike) -> Floats:
    """Axes of a radar's face, z ahead and y upwards, in terms of east, north and up, [out, in].

    Name: frames.face_from_enu.jacobian.
    Definition: R(roll) R(tilt) R(azimuth).
    Conditioning: no expectation is taken.
    Source: Crouse 2014 local coordinate systems.

    Args:
        azimuth: where the radar looks, clockwise from north [rad], -3.1416 to 3.1416.
        tilt: how far it looks up from the horizon [rad], -1.5708 to 1.5708.
        roll: how far it is turned about where it looks, its right side down [rad], -3.1416 to 3.1416.

    Returns:
        Shape of the broadcast arguments + (3, 3), unit 1.

    Accuracy: at most 12.4 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 263. Errors are measured against the
    sizes of the terms.
    """
    arguments = _floats(azimuth, tilt, roll)
    azimuth, tilt, roll = arguments
    cos_azimuth = np.cos(azimuth)
    cos_roll = np.cos(roll)
    sin_azimuth = np.sin(azimuth)
    sin_roll = np.sin(roll)
    sin_tilt = np.sin(tilt)
    cos_tilt = np.cos(tilt)
    result = _empty(arguments, (3, 3))
    result[..., 0, 0] = -cos_azimuth * cos_roll - sin_azimuth * sin_roll * sin_tilt
    result[..., 0, 1] = cos_roll * sin_azimuth - cos_azimuth * sin_roll * sin_tilt
    result[..., 0, 2] = cos_tilt * sin_roll
    result[..., 1, 0] = cos_azimuth * sin_roll - cos_roll * sin_azimuth * sin_tilt
    result[..., 1, 1] = -cos_azimuth * cos_roll * sin_tilt - sin_azimuth * sin_roll
    result[..., 1, 2] = cos_roll * cos_tilt
    result[..., 2, 0] = cos_tilt * sin_azimuth
    result[..., 2, 1] = cos_azimuth * cos_tilt
    result[..., 2, 2] = sin_tilt
    return result
