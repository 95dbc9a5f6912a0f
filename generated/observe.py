"""NumPy functions of the quantities observe.*.

Written by radartrack regenerate, generator 1, derivation 89bc13933d806347; not to be edited.
"""

import numpy as np
import numpy.typing as npt

__all__ = [
    "bearing_hessian",
    "bearing_jacobian",
    "bearing_map",
    "bistatic_hessian",
    "bistatic_jacobian",
    "bistatic_map",
    "bistatic_range_rate_hessian",
    "bistatic_range_rate_jacobian",
    "bistatic_range_rate_map",
    "polar_doppler_hessian",
    "polar_doppler_jacobian",
    "polar_doppler_map",
    "polar_hessian",
    "polar_jacobian",
    "polar_map",
    "range_difference_hessian",
    "range_difference_jacobian",
    "range_difference_map",
    "range_rate_difference_hessian",
    "range_rate_difference_jacobian",
    "range_rate_difference_map",
    "ruv_hessian",
    "ruv_jacobian",
    "ruv_map",
    "spherical_doppler_hessian",
    "spherical_doppler_jacobian",
    "spherical_doppler_map",
    "spherical_hessian",
    "spherical_jacobian",
    "spherical_map",
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


def bearing_map(*, x: npt.ArrayLike, y: npt.ArrayLike) -> Floats:
    """Azimuth of a position in the plane.

    Name: observe.bearing.map.
    Definition: g.
    Conditioning: no expectation is taken.
    Source: Bar-Shalom, Willett & Tian 2011 extended Kalman filter.

    Args:
        x: position along the x axis, from the radar [m], -1e+06 to 1e+06.
        y: position along the y axis, from the radar [m], -1e+06 to 1e+06.

    Returns:
        Shape of the broadcast arguments + (1), unit rad.

    Accuracy: at most 2.01 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 8.01. Errors are measured against the
    sizes of the terms.
    """
    arguments = _floats(x, y)
    x, y = arguments
    result = _empty(arguments, (1,))
    result[..., 0] = np.arctan2(y, x)
    return result


def bearing_jacobian(*, x: npt.ArrayLike, y: npt.ArrayLike) -> Floats:
    """First derivatives of azimuth of a position in the plane, [out, in]; zero where they do not exist, at the radar and for angles on the vertical axis.

    Name: observe.bearing.jacobian.
    Definition: dg/dstate.
    Conditioning: no expectation is taken.
    Source: Bar-Shalom, Willett & Tian 2011 extended Kalman filter.

    Args:
        x: position along the x axis, from the radar [m], -1e+06 to 1e+06.
        y: position along the y axis, from the radar [m], -1e+06 to 1e+06.

    Returns:
        Shape of the broadcast arguments + (1, 2), unit rad/m.

    Accuracy: at most 6.01 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64). Errors are measured against the sizes of the terms.
    """
    arguments = _floats(x, y)
    x, y = arguments
    distance = np.hypot(x, y)
    cos_azimuth = _ratio(x, distance)
    sin_azimuth = _ratio(y, distance)
    result = _empty(arguments, (1, 2))
    result[..., 0, 0] = _ratio(-sin_azimuth, distance)
    result[..., 0, 1] = _ratio(cos_azimuth, distance)
    return result


def bearing_hessian(*, x: npt.ArrayLike, y: npt.ArrayLike) -> Floats:
    """Second derivatives of azimuth of a position in the plane, [out, in, in]; zero where they do not exist, at the radar and for angles on the vertical axis.

    Name: observe.bearing.hessian.
    Definition: d2g/dstate2.
    Conditioning: no expectation is taken.
    Source: Bar-Shalom, Willett & Tian 2011 extended Kalman filter.

    Args:
        x: position along the x axis, from the radar [m], -1e+06 to 1e+06.
        y: position along the y axis, from the radar [m], -1e+06 to 1e+06.

    Returns:
        Shape of the broadcast arguments + (1, 2, 2), unit rad/m^2.

    Accuracy: at most 16.1 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64). Errors are measured against the sizes of the terms.
    """
    arguments = _floats(x, y)
    x, y = arguments
    distance = np.hypot(x, y)
    cos_azimuth = _ratio(x, distance)
    sin_azimuth = _ratio(y, distance)
    distance_squared = distance**2
    result = _empty(arguments, (1, 2, 2))
    result[..., 0, 0, 0] = _ratio(2.0 * cos_azimuth * sin_azimuth, distance_squared)
    result[..., 0, 0, 1] = _ratio(-(cos_azimuth + sin_azimuth) * (cos_azimuth - sin_azimuth), distance_squared)
    result[..., 0, 1, 0] = result[..., 0, 0, 1]
    result[..., 0, 1, 1] = _ratio(-2.0 * cos_azimuth * sin_azimuth, distance_squared)
    return result


def polar_map(*, x: npt.ArrayLike, y: npt.ArrayLike) -> Floats:
    """Range and azimuth of a position in the plane.

    Name: observe.polar.map.
    Definition: g.
    Conditioning: no expectation is taken.
    Source: Bar-Shalom, Willett & Tian 2011 extended Kalman filter.

    Args:
        x: position along the x axis, from the radar [m], -1e+06 to 1e+06.
        y: position along the y axis, from the radar [m], -1e+06 to 1e+06.

    Returns:
        Shape of the broadcast arguments + (2), unit [m, rad].

    Accuracy: at most 2.01 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 8.01. Errors are measured against the
    sizes of the terms.
    """
    arguments = _floats(x, y)
    x, y = arguments
    distance = np.hypot(x, y)
    result = _empty(arguments, (2,))
    result[..., 0] = distance
    result[..., 1] = np.arctan2(y, x)
    return result


def polar_jacobian(*, x: npt.ArrayLike, y: npt.ArrayLike) -> Floats:
    """First derivatives of range and azimuth of a position in the plane, [out, in]; zero where they do not exist, at the radar and for angles on the vertical axis.

    Name: observe.polar.jacobian.
    Definition: dg/dstate.
    Conditioning: no expectation is taken.
    Source: Bar-Shalom, Willett & Tian 2011 extended Kalman filter.

    Args:
        x: position along the x axis, from the radar [m], -1e+06 to 1e+06.
        y: position along the y axis, from the radar [m], -1e+06 to 1e+06.

    Returns:
        Shape of the broadcast arguments + (2, 2), unit [m, rad] × [1/m, 1/m].

    Accuracy: at most 6.01 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64). Errors are measured against the sizes of the terms.
    """
    arguments = _floats(x, y)
    x, y = arguments
    distance = np.hypot(x, y)
    cos_azimuth = _ratio(x, distance)
    sin_azimuth = _ratio(y, distance)
    result = _empty(arguments, (2, 2))
    result[..., 0, 0] = cos_azimuth
    result[..., 0, 1] = sin_azimuth
    result[..., 1, 0] = _ratio(-sin_azimuth, distance)
    result[..., 1, 1] = _ratio(cos_azimuth, distance)
    return result


def polar_hessian(*, x: npt.ArrayLike, y: npt.ArrayLike) -> Floats:
    """Second derivatives of range and azimuth of a position in the plane, [out, in, in]; zero where they do not exist, at the radar and for angles on the vertical axis.

    Name: observe.polar.hessian.
    Definition: d2g/dstate2.
    Conditioning: no expectation is taken.
    Source: Bar-Shalom, Willett & Tian 2011 extended Kalman filter.

    Args:
        x: position along the x axis, from the radar [m], -1e+06 to 1e+06.
        y: position along the y axis, from the radar [m], -1e+06 to 1e+06.

    Returns:
        Shape of the broadcast arguments + (2, 2, 2), unit [m, rad] × [1/m, 1/m] × [1/m, 1/m].

    Accuracy: at most 16.1 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64). Errors are measured against the sizes of the terms.
    """
    arguments = _floats(x, y)
    x, y = arguments
    distance = np.hypot(x, y)
    cos_azimuth = _ratio(x, distance)
    sin_azimuth = _ratio(y, distance)
    distance_squared = distance**2
    result = _empty(arguments, (2, 2, 2))
    result[..., 0, 0, 0] = _ratio(sin_azimuth**2, distance)
    result[..., 0, 0, 1] = _ratio(-cos_azimuth * sin_azimuth, distance)
    result[..., 0, 1, 0] = result[..., 0, 0, 1]
    result[..., 0, 1, 1] = _ratio(cos_azimuth**2, distance)
    result[..., 1, 0, 0] = _ratio(2.0 * cos_azimuth * sin_azimuth, distance_squared)
    result[..., 1, 0, 1] = _ratio(-(cos_azimuth + sin_azimuth) * (cos_azimuth - sin_azimuth), distance_squared)
    result[..., 1, 1, 0] = result[..., 1, 0, 1]
    result[..., 1, 1, 1] = _ratio(-2.0 * cos_azimuth * sin_azimuth, distance_squared)
    return result


def polar_doppler_map(*, x: npt.ArrayLike, y: npt.ArrayLike, vx: npt.ArrayLike, vy: npt.ArrayLike) -> Floats:
    """Range, azimuth and range rate of a position and velocity in the plane.

    Name: observe.polar_doppler.map.
    Definition: g.
    Conditioning: no expectation is taken.
    Source: Bar-Shalom, Willett & Tian 2011 extended Kalman filter.

    Args:
        x: position along the x axis, from the radar [m], -1e+06 to 1e+06.
        y: position along the y axis, from the radar [m], -1e+06 to 1e+06.
        vx: velocity along the x axis [m/s], -1000 to 1000.
        vy: velocity along the y axis [m/s], -1000 to 1000.

    Returns:
        Shape of the broadcast arguments + (3), unit [m, rad, m/s].

    Accuracy: at most 5.01 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64). Errors are measured against the sizes of the terms.
    """
    arguments = _floats(x, y, vx, vy)
    x, y, vx, vy = arguments
    distance = np.hypot(x, y)
    cos_azimuth = _ratio(x, distance)
    sin_azimuth = _ratio(y, distance)
    result = _empty(arguments, (3,))
    result[..., 0] = distance
    result[..., 1] = np.arctan2(y, x)
    result[..., 2] = cos_azimuth * vx + sin_azimuth * vy
    return result


def polar_doppler_jacobian(
    *,
    x: npt.ArrayLike,
    y: npt.ArrayLike,
    vx: npt.ArrayLike,
    vy: npt.ArrayLike,
) -> Floats:
    """First derivatives of range, azimuth and range rate of a position and velocity in the plane, [out, in]; zero where they do not exist, at the radar and for angles on the vertical axis.

    Name: observe.polar_doppler.jacobian.
    Definition: dg/dstate.
    Conditioning: no expectation is taken.
    Source: Bar-Shalom, Willett & Tian 2011 extended Kalman filter.

    Args:
        x: position along the x axis, from the radar [m], -1e+06 to 1e+06.
        y: position along the y axis, from the radar [m], -1e+06 to 1e+06.
        vx: velocity along the x axis [m/s], -1000 to 1000.
        vy: velocity along the y axis [m/s], -1000 to 1000.

    Returns:
        Shape of the broadcast arguments + (3, 4), unit [m, rad, m/s] × [1/m, 1/m, s/m, s/m].

    Accuracy: at most 12.1 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64). Errors are measured against the sizes of the terms.
    """
    arguments = _floats(x, y, vx, vy)
    x, y, vx, vy = arguments
    distance = np.hypot(x, y)
    cos_azimuth = _ratio(x, distance)
    sin_azimuth = _ratio(y, distance)
    sum_1 = cos_azimuth * vy - sin_azimuth * vx
    result = _empty(arguments, (3, 4))
    result[..., 0, 0] = cos_azimuth
    result[..., 0, 1] = sin_azimuth
    result[..., 0, 2] = 0.0
    result[..., 0, 3] = 0.0
    result[..., 1, 0] = _ratio(-sin_azimuth, distance)
    result[..., 1, 1] = _ratio(cos_azimuth, distance)
    result[..., 1, 2] = 0.0
    result[..., 1, 3] = 0.0
    result[..., 2, 0] = _ratio(-sin_azimuth * sum_1, distance)
    result[..., 2, 1] = _ratio(cos_azimuth * sum_1, distance)
    result[..., 2, 2] = cos_azimuth
    result[..., 2, 3] = sin_azimuth
    return result


def polar_doppler_hessian(
    *,
    x: npt.ArrayLike,
    y: npt.ArrayLike,
    vx: npt.ArrayLike,
    vy: npt.ArrayLike,
) -> Floats:
    """Second derivatives of range, azimuth and range rate of a position and velocity in the plane, [out, in, in]; zero where they do not exist, at the radar and for angles on the vertical axis.

    Name: observe.polar_doppler.hessian.
    Definition: d2g/dstate2.
    Conditioning: no expectation is taken.
    Source: Bar-Shalom, Willett & Tian 2011 extended Kalman filter.

    Args:
        x: position along the x axis, from the radar [m], -1e+06 to 1e+06.
        y: position along the y axis, from the radar [m], -1e+06 to 1e+06.
        vx: velocity along the x axis [m/s], -1000 to 1000.
        vy: velocity along the y axis [m/s], -1000 to 1000.

    Returns:
        Shape of the broadcast arguments + (3, 4, 4), unit [m, rad, m/s] × [1/m, 1/m, s/m, s/m] × [1/m, 1/m,
        s/m, s/m].

    Accuracy: at most 23.1 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64). Errors are measured against the sizes of the terms.
    """
    arguments = _floats(x, y, vx, vy)
    x, y, vx, vy = arguments
    distance = np.hypot(x, y)
    cos_azimuth = _ratio(x, distance)
    sin_azimuth = _ratio(y, distance)
    sin_azimuth_squared = sin_azimuth**2
    cos_azimuth_squared = cos_azimuth**2
    distance_squared = distance**2
    sum_1 = 2.0 * cos_azimuth_squared * vy - 3.0 * cos_azimuth * sin_azimuth * vx - sin_azimuth_squared * vy
    sum_2 = 3.0 * cos_azimuth * sin_azimuth * vy - 2.0 * sin_azimuth_squared * vx + cos_azimuth_squared * vx
    result = _empty(arguments, (3, 4, 4))
    result[..., 0, 0, 0] = _ratio(sin_azimuth_squared, distance)
    result[..., 0, 0, 1] = _ratio(-cos_azimuth * sin_azimuth, distance)
    result[..., 0, 0, 2] = 0.0
    result[..., 0, 0, 3] = 0.0
    result[..., 0, 1, 0] = result[..., 0, 0, 1]
    result[..., 0, 1, 1] = _ratio(cos_azimuth_squared, distance)
    result[..., 0, 1, 2] = 0.0
    result[..., 0, 1, 3] = 0.0
    result[..., 0, 2, 0] = 0.0
    result[..., 0, 2, 1] = 0.0
    result[..., 0, 2, 2] = 0.0
    result[..., 0, 2, 3] = 0.0
    result[..., 0, 3, 0] = 0.0
    result[..., 0, 3, 1] = 0.0
    result[..., 0, 3, 2] = 0.0
    result[..., 0, 3, 3] = 0.0
    result[..., 1, 0, 0] = _ratio(2.0 * cos_azimuth * sin_azimuth, distance_squared)
    result[..., 1, 0, 1] = _ratio(-(cos_azimuth + sin_azimuth) * (cos_azimuth - sin_azimuth), distance_squared)
    result[..., 1, 0, 2] = 0.0
    result[..., 1, 0, 3] = 0.0
    result[..., 1, 1, 0] = result[..., 1, 0, 1]
    result[..., 1, 1, 1] = _ratio(-2.0 * cos_azimuth * sin_azimuth, distance_squared)
    result[..., 1, 1, 2] = 0.0
    result[..., 1, 1, 3] = 0.0
    result[..., 1, 2, 0] = 0.0
    result[..., 1, 2, 1] = 0.0
    result[..., 1, 2, 2] = 0.0
    result[..., 1, 2, 3] = 0.0
    result[..., 1, 3, 0] = 0.0
    result[..., 1, 3, 1] = 0.0
    result[..., 1, 3, 2] = 0.0
    result[..., 1, 3, 3] = 0.0
    result[..., 2, 0, 0] = _ratio(sin_azimuth * sum_1, distance_squared)
    result[..., 2, 0, 1] = _ratio(2.0 * cos_azimuth * sin_azimuth_squared * vy - cos_azimuth * cos_azimuth_squared * vy - sin_azimuth * sin_azimuth_squared * vx + 2.0 * cos_azimuth_squared * sin_azimuth * vx, distance_squared)
    result[..., 2, 0, 2] = result[..., 0, 0, 0]
    result[..., 2, 0, 3] = result[..., 0, 0, 1]
    result[..., 2, 1, 0] = result[..., 2, 0, 1]
    result[..., 2, 1, 1] = _ratio(-cos_azimuth * sum_2, distance_squared)
    result[..., 2, 1, 2] = result[..., 0, 0, 1]
    result[..., 2, 1, 3] = result[..., 0, 1, 1]
    result[..., 2, 2, 0] = result[..., 0, 0, 0]
    result[..., 2, 2, 1] = result[..., 0, 0, 1]
    result[..., 2, 2, 2] = 0.0
    result[..., 2, 2, 3] = 0.0
    result[..., 2, 3, 0] = result[..., 0, 0, 1]
    result[..., 2, 3, 1] = result[..., 0, 1, 1]
    result[..., 2, 3, 2] = 0.0
    result[..., 2, 3, 3] = 0.0
    return result


def ruv_map(*, x: npt.ArrayLike, y: npt.ArrayLike, z: npt.ArrayLike) -> Floats:
    """Range and direction cosines of a position in space.

    Name: observe.ruv.map.
    Definition: g.
    Conditioning: no expectation is taken.
    Source: Bar-Shalom, Willett & Tian 2011 extended Kalman filter.

    Args:
        x: position along the x axis, from the radar [m], -1e+06 to 1e+06.
        y: position along the y axis, from the radar [m], -1e+06 to 1e+06.
        z: position along the z axis, from the radar [m], -1e+06 to 1e+06.

    Returns:
        Shape of the broadcast arguments + (3), unit [m, 1, 1].

    Accuracy: at most 5.01 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 17.1. Errors are measured against the
    sizes of the terms.
    """
    arguments = _floats(x, y, z)
    x, y, z = arguments
    ground_distance = np.hypot(x, y)
    distance = np.hypot(ground_distance, z)
    cosine_x = _ratio(x, distance)
    cosine_y = _ratio(y, distance)
    result = _empty(arguments, (3,))
    result[..., 0] = distance
    result[..., 1] = cosine_x
    result[..., 2] = cosine_y
    return result


def ruv_jacobian(*, x: npt.ArrayLike, y: npt.ArrayLike, z: npt.ArrayLike) -> Floats:
    """First derivatives of range and direction cosines of a position in space, [out, in]; zero where they do not exist, at the radar and for angles on the vertical axis.

    Name: observe.ruv.jacobian.
    Definition: dg/dstate.
    Conditioning: no expectation is taken.
    Source: Bar-Shalom, Willett & Tian 2011 extended Kalman filter.

    Args:
        x: position along the x axis, from the radar [m], -1e+06 to 1e+06.
        y: position along the y axis, from the radar [m], -1e+06 to 1e+06.
        z: position along the z axis, from the radar [m], -1e+06 to 1e+06.

    Returns:
        Shape of the broadcast arguments + (3, 3), unit [m, 1, 1] × [1/m, 1/m, 1/m].

    Accuracy: at most 18.1 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64). Errors are measured against the sizes of the terms.
    """
    arguments = _floats(x, y, z)
    x, y, z = arguments
    ground_distance = np.hypot(x, y)
    distance = np.hypot(ground_distance, z)
    cosine_x = _ratio(x, distance)
    cosine_y = _ratio(y, distance)
    cosine_z = _ratio(z, distance)
    cosine_z_squared = cosine_z**2
    result = _empty(arguments, (3, 3))
    result[..., 0, 0] = cosine_x
    result[..., 0, 1] = cosine_y
    result[..., 0, 2] = cosine_z
    result[..., 1, 0] = _ratio(cosine_y**2 + cosine_z_squared, distance)
    result[..., 1, 1] = _ratio(-cosine_x * cosine_y, distance)
    result[..., 1, 2] = _ratio(-cosine_x * cosine_z, distance)
    result[..., 2, 0] = result[..., 1, 1]
    result[..., 2, 1] = _ratio(cosine_x**2 + cosine_z_squared, distance)
    result[..., 2, 2] = _ratio(-cosine_y * cosine_z, distance)
    return result


def ruv_hessian(*, x: npt.ArrayLike, y: npt.ArrayLike, z: npt.ArrayLike) -> Floats:
    """Second derivatives of range and direction cosines of a position in space, [out, in, in]; zero where they do not exist, at the radar and for angles on the vertical axis.

    Name: observe.ruv.hessian.
    Definition: d2g/dstate2.
    Conditioning: no expectation is taken.
    Source: Bar-Shalom, Willett & Tian 2011 extended Kalman filter.

    Args:
        x: position along the x axis, from the radar [m], -1e+06 to 1e+06.
        y: position along the y axis, from the radar [m], -1e+06 to 1e+06.
        z: position along the z axis, from the radar [m], -1e+06 to 1e+06.

    Returns:
        Shape of the broadcast arguments + (3, 3, 3), unit [m, 1, 1] × [1/m, 1/m, 1/m] × [1/m, 1/m, 1/m].

    Accuracy: at most 31.1 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64). Errors are measured against the sizes of the terms.
    """
    arguments = _floats(x, y, z)
    x, y, z = arguments
    ground_distance = np.hypot(x, y)
    distance = np.hypot(ground_distance, z)
    cosine_x = _ratio(x, distance)
    cosine_y = _ratio(y, distance)
    cosine_z = _ratio(z, distance)
    cosine_y_squared = cosine_y**2
    cosine_z_squared = cosine_z**2
    sum_1 = cosine_y_squared + cosine_z_squared
    cosine_x_squared = cosine_x**2
    sum_2 = cosine_x_squared + cosine_z_squared
    distance_squared = distance**2
    sum_3 = 2.0 * cosine_x_squared - cosine_y_squared - cosine_z_squared
    sum_4 = cosine_x_squared - 2.0 * cosine_y_squared + cosine_z_squared
    sum_5 = cosine_x_squared - 2.0 * cosine_z_squared + cosine_y_squared
    result = _empty(arguments, (3, 3, 3))
    result[..., 0, 0, 0] = _ratio(sum_1, distance)
    result[..., 0, 0, 1] = _ratio(-cosine_x * cosine_y, distance)
    result[..., 0, 0, 2] = _ratio(-cosine_x * cosine_z, distance)
    result[..., 0, 1, 0] = result[..., 0, 0, 1]
    result[..., 0, 1, 1] = _ratio(sum_2, distance)
    result[..., 0, 1, 2] = _ratio(-cosine_y * cosine_z, distance)
    result[..., 0, 2, 0] = result[..., 0, 0, 2]
    result[..., 0, 2, 1] = result[..., 0, 1, 2]
    result[..., 0, 2, 2] = _ratio(cosine_x_squared + cosine_y_squared, distance)
    result[..., 1, 0, 0] = _ratio(-3.0 * cosine_x * sum_1, distance_squared)
    result[..., 1, 0, 1] = _ratio(cosine_y * sum_3, distance_squared)
    result[..., 1, 0, 2] = _ratio(cosine_z * sum_3, distance_squared)
    result[..., 1, 1, 0] = result[..., 1, 0, 1]
    result[..., 1, 1, 1] = _ratio(-cosine_x * sum_4, distance_squared)
    result[..., 1, 1, 2] = _ratio(3.0 * cosine_x * cosine_y * cosine_z, distance_squared)
    result[..., 1, 2, 0] = result[..., 1, 0, 2]
    result[..., 1, 2, 1] = result[..., 1, 1, 2]
    result[..., 1, 2, 2] = _ratio(-cosine_x * sum_5, distance_squared)
    result[..., 2, 0, 0] = result[..., 1, 0, 1]
    result[..., 2, 0, 1] = result[..., 1, 1, 1]
    result[..., 2, 0, 2] = result[..., 1, 1, 2]
    result[..., 2, 1, 0] = result[..., 1, 1, 1]
    result[..., 2, 1, 1] = _ratio(-3.0 * cosine_y * sum_2, distance_squared)
    result[..., 2, 1, 2] = _ratio(-cosine_z * sum_4, distance_squared)
    result[..., 2, 2, 0] = result[..., 1, 1, 2]
    result[..., 2, 2, 1] = result[..., 2, 1, 2]
    result[..., 2, 2, 2] = _ratio(-cosine_y * sum_5, distance_squared)
    return result


def spherical_map(*, x: npt.ArrayLike, y: npt.ArrayLike, z: npt.ArrayLike) -> Floats:
    """Range, azimuth and elevation of a position in space.

    Name: observe.spherical.map.
    Definition: g.
    Conditioning: no expectation is taken.
    Source: Bar-Shalom, Willett & Tian 2011 extended Kalman filter.

    Args:
        x: position along the x axis, from the radar [m], -1e+06 to 1e+06.
        y: position along the y axis, from the radar [m], -1e+06 to 1e+06.
        z: position along the z axis, from the radar [m], -1e+06 to 1e+06.

    Returns:
        Shape of the broadcast arguments + (3), unit [m, rad, rad].

    Accuracy: at most 4.01 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 16.1. Errors are measured against the
    sizes of the terms.
    """
    arguments = _floats(x, y, z)
    x, y, z = arguments
    ground_distance = np.hypot(x, y)
    distance = np.hypot(ground_distance, z)
    result = _empty(arguments, (3,))
    result[..., 0] = distance
    result[..., 1] = np.arctan2(x, y)
    result[..., 2] = np.arctan2(z, ground_distance)
    return result


def spherical_jacobian(*, x: npt.ArrayLike, y: npt.ArrayLike, z: npt.ArrayLike) -> Floats:
    """First derivatives of range, azimuth and elevation of a position in space, [out, in]; zero where they do not exist, at the radar and for angles on the vertical axis.

    Name: observe.spherical.jacobian.
    Definition: dg/dstate.
    Conditioning: no expectation is taken.
    Source: Bar-Shalom, Willett & Tian 2011 extended Kalman filter.

    Args:
        x: position along the x axis, from the radar [m], -1e+06 to 1e+06.
        y: position along the y axis, from the radar [m], -1e+06 to 1e+06.
        z: position along the z axis, from the radar [m], -1e+06 to 1e+06.

    Returns:
        Shape of the broadcast arguments + (3, 3), unit [m, rad, rad] × [1/m, 1/m, 1/m].

    Accuracy: at most 16.1 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64). Errors are measured against the sizes of the terms.
    """
    arguments = _floats(x, y, z)
    x, y, z = arguments
    ground_distance = np.hypot(x, y)
    distance = np.hypot(ground_distance, z)
    cosine_x = _ratio(x, distance)
    cosine_y = _ratio(y, distance)
    cosine_z = _ratio(z, distance)
    cos_azimuth = _ratio(y, ground_distance)
    sin_azimuth = _ratio(x, ground_distance)
    cos_elevation = _ratio(ground_distance, distance)
    sin_elevation = cosine_z
    product_1 = cos_elevation * distance
    result = _empty(arguments, (3, 3))
    result[..., 0, 0] = cosine_x
    result[..., 0, 1] = cosine_y
    result[..., 0, 2] = cosine_z
    result[..., 1, 0] = _ratio(cos_azimuth, product_1)
    result[..., 1, 1] = _ratio(-sin_azimuth, product_1)
    result[..., 1, 2] = 0.0
    result[..., 2, 0] = _ratio(-sin_azimuth * sin_elevation, distance)
    result[..., 2, 1] = _ratio(-cos_azimuth * sin_elevation, distance)
    result[..., 2, 2] = _ratio(cos_elevation, distance)
    return result


def spherical_hessian(*, x: npt.ArrayLike, y: npt.ArrayLike, z: npt.ArrayLike) -> Floats:
    """Second derivatives of range, azimuth and elevation of a position in space, [out, in, in]; zero where they do not exist, at the radar and for angles on the vertical axis.

    Name: observe.spherical.hessian.
    Definition: d2g/dstate2.
    Conditioning: no expectation is taken.
    Source: Bar-Shalom, Willett & Tian 2011 extended Kalman filter.

    Args:
        x: position along the x axis, from the radar [m], -1e+06 to 1e+06.
        y: position along the y axis, from the radar [m], -1e+06 to 1e+06.
        z: position along the z axis, from the radar [m], -1e+06 to 1e+06.

    Returns:
        Shape of the broadcast arguments + (3, 3, 3), unit [m, rad, rad] × [1/m, 1/m, 1/m] × [1/m, 1/m, 1/m].

    Accuracy: at most 63.1 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64). Errors are measured against the sizes of the terms.
    """
    arguments = _floats(x, y, z)
    x, y, z = arguments
    ground_distance = np.hypot(x, y)
    distance = np.hypot(ground_distance, z)
    cosine_x = _ratio(x, distance)
    cosine_y = _ratio(y, distance)
    cosine_z = _ratio(z, distance)
    cos_azimuth = _ratio(y, ground_distance)
    sin_azimuth = _ratio(x, ground_distance)
    cos_elevation = _ratio(ground_distance, distance)
    sin_elevation = cosine_z
    cosine_y_squared = cosine_y**2
    cosine_z_squared = cosine_z**2
    cosine_x_squared = cosine_x**2
    cos_elevation_squared = cos_elevation**2
    distance_squared = distance**2
    product_1 = cos_elevation_squared * distance_squared
    sin_azimuth_squared = sin_azimuth**2
    sin_azimuth_squared_squared = sin_azimuth_squared**2
    cos_azimuth_squared = cos_azimuth**2
    sin_elevation_squared = sin_elevation**2
    cos_azimuth_squared_squared = cos_azimuth_squared**2
    sum_1 = (
        cos_azimuth_squared * sin_elevation_squared
        - 2.0 * cos_elevation_squared * sin_azimuth_squared_squared
        - cos_azimuth_squared * cos_elevation_squared * sin_azimuth_squared
        + cos_azimuth_squared_squared * cos_elevation_squared
    )
    product_2 = cos_elevation * distance_squared
    sum_2 = (
        3.0 * cos_azimuth_squared * cos_elevation_squared
        + 3.0 * cos_elevation_squared * sin_azimuth_squared
        + sin_elevation_squared
    )
    sum_3 = (
        cos_azimuth_squared * cos_elevation_squared
        - sin_elevation_squared
        + cos_elevation_squared * sin_azimuth_squared
    )
    sum_4 = (
        2.0 * cos_azimuth_squared_squared * cos_elevation_squared
        - cos_elevation_squared * sin_azimuth_squared_squared
        - sin_azimuth_squared * sin_elevation_squared
        + cos_azimuth_squared * cos_elevation_squared * sin_azimuth_squared
    )
    result = _empty(arguments, (3, 3, 3))
    result[..., 0, 0, 0] = _ratio(cosine_y_squared + cosine_z_squared, distance)
    result[..., 0, 0, 1] = _ratio(-cosine_x * cosine_y, distance)
    result[..., 0, 0, 2] = _ratio(-cosine_x * cosine_z, distance)
    result[..., 0, 1, 0] = result[..., 0, 0, 1]
    result[..., 0, 1, 1] = _ratio(cosine_x_squared + cosine_z_squared, distance)
    result[..., 0, 1, 2] = _ratio(-cosine_y * cosine_z, distance)
    result[..., 0, 2, 0] = result[..., 0, 0, 2]
    result[..., 0, 2, 1] = result[..., 0, 1, 2]
    result[..., 0, 2, 2] = _ratio(cosine_x_squared + cosine_y_squared, distance)
    result[..., 1, 0, 0] = _ratio(-2.0 * cos_azimuth * sin_azimuth, product_1)
    result[..., 1, 0, 1] = _ratio(-(cos_azimuth + sin_azimuth) * (cos_azimuth - sin_azimuth), product_1)
    result[..., 1, 0, 2] = 0.0
    result[..., 1, 1, 0] = result[..., 1, 0, 1]
    result[..., 1, 1, 1] = _ratio(2.0 * cos_azimuth * sin_azimuth, product_1)
    result[..., 1, 1, 2] = 0.0
    result[..., 1, 2, 0] = 0.0
    result[..., 1, 2, 1] = 0.0
    result[..., 1, 2, 2] = 0.0
    result[..., 2, 0, 0] = _ratio(-sin_elevation * sum_1, product_2)
    result[..., 2, 0, 1] = _ratio(cos_azimuth * sin_azimuth * sin_elevation * sum_2, product_2)
    result[..., 2, 0, 2] = _ratio(-sin_azimuth * sum_3, distance_squared)
    result[..., 2, 1, 0] = result[..., 2, 0, 1]
    result[..., 2, 1, 1] = _ratio(sin_elevation * sum_4, product_2)
    result[..., 2, 1, 2] = _ratio(-cos_azimuth * sum_3, distance_squared)
    result[..., 2, 2, 0] = result[..., 2, 0, 2]
    result[..., 2, 2, 1] = result[..., 2, 1, 2]
    result[..., 2, 2, 2] = _ratio(-2.0 * cos_elevation * sin_elevation, distance_squared)
    return result


def spherical_doppler_map(
    *,
    x: npt.ArrayLike,
    y: npt.ArrayLike,
    z: npt.ArrayLike,
    vx: npt.ArrayLike,
    vy: npt.ArrayLike,
    vz: npt.ArrayLike,
) -> Floats:
    """Range, azimuth, elevation and range rate of a position and velocity in space.

    Name: observe.spherical_doppler.map.
    Definition: g.
    Conditioning: no expectation is taken.
    Source: Bar-Shalom, Willett & Tian 2011 extended Kalman filter.

    Args:
        x: position along the x axis, from the radar [m], -1e+06 to 1e+06.
        y: position along the y axis, from the radar [m], -1e+06 to 1e+06.
        z: position along the z axis, from the radar [m], -1e+06 to 1e+06.
        vx: velocity along the x axis [m/s], -1000 to 1000.
        vy: velocity along the y axis [m/s], -1000 to 1000.
        vz: velocity along the z axis [m/s], -1000 to 1000.

    Returns:
        Shape of the broadcast arguments + (4), unit [m, rad, rad, m/s].

    Accuracy: at most 8.01 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64). Errors are measured against the sizes of the terms.
    """
    arguments = _floats(x, y, z, vx, vy, vz)
    x, y, z, vx, vy, vz = arguments
    ground_distance = np.hypot(x, y)
    distance = np.hypot(ground_distance, z)
    cosine_x = _ratio(x, distance)
    cosine_y = _ratio(y, distance)
    cosine_z = _ratio(z, distance)
    result = _empty(arguments, (4,))
    result[..., 0] = distance
    result[..., 1] = np.arctan2(x, y)
    result[..., 2] = np.arctan2(z, ground_distance)
    result[..., 3] = cosine_x * vx + cosine_y * vy + cosine_z * vz
    return result


def spherical_doppler_jacobian(
    *,
    x: npt.ArrayLike,
    y: npt.ArrayLike,
    z: npt.ArrayLike,
    vx: npt.ArrayLike,
    vy: npt.ArrayLike,
    vz: npt.ArrayLike,
) -> Floats:
    """First derivatives of range, azimuth, elevation and range rate of a position and velocity in space, [out, in]; zero where they do not exist, at the radar and for angles on the vertical axis.

    Name: observe.spherical_doppler.jacobian.
    Definition: dg/dstate.
    Conditioning: no expectation is taken.
    Source: Bar-Shalom, Willett & Tian 2011 extended Kalman filter.

    Args:
        x: position along the x axis, from the radar [m], -1e+06 to 1e+06.
        y: position along the y axis, from the radar [m], -1e+06 to 1e+06.
        z: position along the z axis, from the radar [m], -1e+06 to 1e+06.
        vx: velocity along the x axis [m/s], -1000 to 1000.
        vy: velocity along the y axis [m/s], -1000 to 1000.
        vz: velocity along the z axis [m/s], -1000 to 1000.

    Returns:
        Shape of the broadcast arguments + (4, 6), unit [m, rad, rad, m/s] × [1/m, 1/m, 1/m, s/m, s/m, s/m].

    Accuracy: at most 21.1 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64). Errors are measured against the sizes of the terms.
    """
    arguments = _floats(x, y, z, vx, vy, vz)
    x, y, z, vx, vy, vz = arguments
    ground_distance = np.hypot(x, y)
    distance = np.hypot(ground_distance, z)
    cosine_x = _ratio(x, distance)
    cosine_y = _ratio(y, distance)
    cosine_z = _ratio(z, distance)
    cos_azimuth = _ratio(y, ground_distance)
    sin_azimuth = _ratio(x, ground_distance)
    cos_elevation = _ratio(ground_distance, distance)
    sin_elevation = cosine_z
    product_1 = cos_elevation * distance
    cosine_y_squared = cosine_y**2
    cosine_z_squared = cosine_z**2
    cosine_x_squared = cosine_x**2
    result = _empty(arguments, (4, 6))
    result[..., 0, 0] = cosine_x
    result[..., 0, 1] = cosine_y
    result[..., 0, 2] = cosine_z
    result[..., 0, 3] = 0.0
    result[..., 0, 4] = 0.0
    result[..., 0, 5] = 0.0
    result[..., 1, 0] = _ratio(cos_azimuth, product_1)
    result[..., 1, 1] = _ratio(-sin_azimuth, product_1)
    result[..., 1, 2] = 0.0
    result[..., 1, 3] = 0.0
    result[..., 1, 4] = 0.0
    result[..., 1, 5] = 0.0
    result[..., 2, 0] = _ratio(-sin_azimuth * sin_elevation, distance)
    result[..., 2, 1] = _ratio(-cos_azimuth * sin_elevation, distance)
    result[..., 2, 2] = _ratio(cos_elevation, distance)
    result[..., 2, 3] = 0.0
    result[..., 2, 4] = 0.0
    result[..., 2, 5] = 0.0
    result[..., 3, 0] = _ratio(cosine_y_squared * vx - cosine_x * cosine_y * vy - cosine_x * cosine_z * vz + cosine_z_squared * vx, distance)
    result[..., 3, 1] = _ratio(cosine_x_squared * vy - cosine_x * cosine_y * vx - cosine_y * cosine_z * vz + cosine_z_squared * vy, distance)
    result[..., 3, 2] = _ratio(cosine_x_squared * vz - cosine_x * cosine_z * vx - cosine_y * cosine_z * vy + cosine_y_squared * vz, distance)
    result[..., 3, 3] = cosine_x
    result[..., 3, 4] = cosine_y
    result[..., 3, 5] = cosine_z
    return result


def spherical_doppler_hessian(
    *,
    x: npt.ArrayLike,
    y: npt.ArrayLike,
    z: npt.ArrayLike,
    vx: npt.ArrayLike,
    vy: npt.ArrayLike,
    vz: npt.ArrayLike,
) -> Floats:
    """Second derivatives of range, azimuth, elevation and range rate of a position and velocity in space, [out, in, in]; zero where they do not exist, at the radar and for angles on the vertical axis.

    Name: observe.spherical_doppler.hessian.
    Definition: d2g/dstate2.
    Conditioning: no expectation is taken.
    Source: Bar-Shalom, Willett & Tian 2011 extended Kalman filter.

    Args:
        x: position along the x axis, from the radar [m], -1e+06 to 1e+06.
        y: position along the y axis, from the radar [m], -1e+06 to 1e+06.
        z: position along the z axis, from the radar [m], -1e+06 to 1e+06.
        vx: velocity along the x axis [m/s], -1000 to 1000.
        vy: velocity along the y axis [m/s], -1000 to 1000.
        vz: velocity along the z axis [m/s], -1000 to 1000.

    Returns:
        Shape of the broadcast arguments + (4, 6, 6), unit [m, rad, rad, m/s] × [1/m, 1/m, 1/m, s/m, s/m, s/m]
        × [1/m, 1/m, 1/m, s/m, s/m, s/m].

    Accuracy: at most 63.1 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64). Errors are measured against the sizes of the terms.
    """
    arguments = _floats(x, y, z, vx, vy, vz)
    x, y, z, vx, vy, vz = arguments
    ground_distance = np.hypot(x, y)
    distance = np.hypot(ground_distance, z)
    cosine_x = _ratio(x, distance)
    cosine_y = _ratio(y, distance)
    cosine_z = _ratio(z, distance)
    cos_azimuth = _ratio(y, ground_distance)
    sin_azimuth = _ratio(x, ground_distance)
    cos_elevation = _ratio(ground_distance, distance)
    sin_elevation = cosine_z
    cosine_y_squared = cosine_y**2
    cosine_z_squared = cosine_z**2
    cosine_x_squared = cosine_x**2
    cos_elevation_squared = cos_elevation**2
    distance_squared = distance**2
    product_1 = cos_elevation_squared * distance_squared
    sin_azimuth_squared = sin_azimuth**2
    sin_azimuth_squared_squared = sin_azimuth_squared**2
    cos_azimuth_squared = cos_azimuth**2
    sin_elevation_squared = sin_elevation**2
    cos_azimuth_squared_squared = cos_azimuth_squared**2
    sum_1 = (
        cos_azimuth_squared * sin_elevation_squared
        - 2.0 * cos_elevation_squared * sin_azimuth_squared_squared
        - cos_azimuth_squared * cos_elevation_squared * sin_azimuth_squared
        + cos_azimuth_squared_squared * cos_elevation_squared
    )
    product_2 = cos_elevation * distance_squared
    sum_2 = (
        3.0 * cos_azimuth_squared * cos_elevation_squared
        + 3.0 * cos_elevation_squared * sin_azimuth_squared
        + sin_elevation_squared
    )
    sum_3 = (
        cos_azimuth_squared * cos_elevation_squared
        - sin_elevation_squared
        + cos_elevation_squared * sin_azimuth_squared
    )
    sum_4 = (
        2.0 * cos_azimuth_squared_squared * cos_elevation_squared
        - cos_elevation_squared * sin_azimuth_squared_squared
        - sin_azimuth_squared * sin_elevation_squared
        + cos_azimuth_squared * cos_elevation_squared * sin_azimuth_squared
    )
    product_3 = cosine_y * cosine_y_squared
    product_4 = -product_3 * vy
    product_5 = cosine_z * cosine_z_squared
    product_6 = -product_5 * vz
    product_7 = cosine_x * cosine_x_squared
    product_8 = -product_7 * vx
    result = _empty(arguments, (4, 6, 6))
    result[..., 0, 0, 0] = _ratio(cosine_y_squared + cosine_z_squared, distance)
    result[..., 0, 0, 1] = _ratio(-cosine_x * cosine_y, distance)
    result[..., 0, 0, 2] = _ratio(-cosine_x * cosine_z, distance)
    result[..., 0, 0, 3] = 0.0
    result[..., 0, 0, 4] = 0.0
    result[..., 0, 0, 5] = 0.0
    result[..., 0, 1, 0] = result[..., 0, 0, 1]
    result[..., 0, 1, 1] = _ratio(cosine_x_squared + cosine_z_squared, distance)
    result[..., 0, 1, 2] = _ratio(-cosine_y * cosine_z, distance)
    result[..., 0, 1, 3] = 0.0
    result[..., 0, 1, 4] = 0.0
    result[..., 0, 1, 5] = 0.0
    result[..., 0, 2, 0] = result[..., 0, 0, 2]
    result[..., 0, 2, 1] = result[..., 0, 1, 2]
    result[..., 0, 2, 2] = _ratio(cosine_x_squared + cosine_y_squared, distance)
    result[..., 0, 2, 3] = 0.0
    result[..., 0, 2, 4] = 0.0
    result[..., 0, 2, 5] = 0.0
    result[..., 0, 3, 0] = 0.0
    result[..., 0, 3, 1] = 0.0
    result[..., 0, 3, 2] = 0.0
    result[..., 0, 3, 3] = 0.0
    result[..., 0, 3, 4] = 0.0
    result[..., 0, 3, 5] = 0.0
    result[..., 0, 4, 0] = 0.0
    result[..., 0, 4, 1] = 0.0
    result[..., 0, 4, 2] = 0.0
    result[..., 0, 4, 3] = 0.0
    result[..., 0, 4, 4] = 0.0
    result[..., 0, 4, 5] = 0.0
    result[..., 0, 5, 0] = 0.0
    result[..., 0, 5, 1] = 0.0
    result[..., 0, 5, 2] = 0.0
    result[..., 0, 5, 3] = 0.0
    result[..., 0, 5, 4] = 0.0
    result[..., 0, 5, 5] = 0.0
    result[..., 1, 0, 0] = _ratio(-2.0 * cos_azimuth * sin_azimuth, product_1)
    result[..., 1, 0, 1] = _ratio(-(cos_azimuth + sin_azimuth) * (cos_azimuth - sin_azimuth), product_1)
    result[..., 1, 0, 2] = 0.0
    result[..., 1, 0, 3] = 0.0
    result[..., 1, 0, 4] = 0.0
    result[..., 1, 0, 5] = 0.0
    result[..., 1, 1, 0] = result[..., 1, 0, 1]
    result[..., 1, 1, 1] = _ratio(2.0 * cos_azimuth * sin_azimuth, product_1)
    result[..., 1, 1, 2] = 0.0
    result[..., 1, 1, 3] = 0.0
    result[..., 1, 1, 4] = 0.0
    result[..., 1, 1, 5] = 0.0
    result[..., 1, 2, 0] = 0.0
    result[..., 1, 2, 1] = 0.0
    result[..., 1, 2, 2] = 0.0
    result[..., 1, 2, 3] = 0.0
    result[..., 1, 2, 4] = 0.0
    result[..., 1, 2, 5] = 0.0
    result[..., 1, 3, 0] = 0.0
    result[..., 1, 3, 1] = 0.0
    result[..., 1, 3, 2] = 0.0
    result[..., 1, 3, 3] = 0.0
    result[..., 1, 3, 4] = 0.0
    result[..., 1, 3, 5] = 0.0
    result[..., 1, 4, 0] = 0.0
    result[..., 1, 4, 1] = 0.0
    result[..., 1, 4, 2] = 0.0
    result[..., 1, 4, 3] = 0.0
    result[..., 1, 4, 4] = 0.0
    result[..., 1, 4, 5] = 0.0
    result[..., 1, 5, 0] = 0.0
    result[..., 1, 5, 1] = 0.0
    result[..., 1, 5, 2] = 0.0
    result[..., 1, 5, 3] = 0.0
    result[..., 1, 5, 4] = 0.0
    result[..., 1, 5, 5] = 0.0
    result[..., 2, 0, 0] = _ratio(-sin_elevation * sum_1, product_2)
    result[..., 2, 0, 1] = _ratio(cos_azimuth * sin_azimuth * sin_elevation * sum_2, product_2)
    result[..., 2, 0, 2] = _ratio(-sin_azimuth * sum_3, distance_squared)
    result[..., 2, 0, 3] = 0.0
    result[..., 2, 0, 4] = 0.0
    result[..., 2, 0, 5] = 0.0
    result[..., 2, 1, 0] = result[..., 2, 0, 1]
    result[..., 2, 1, 1] = _ratio(sin_elevation * sum_4, product_2)
    result[..., 2, 1, 2] = _ratio(-cos_azimuth * sum_3, distance_squared)
    result[..., 2, 1, 3] = 0.0
    result[..., 2, 1, 4] = 0.0
    result[..., 2, 1, 5] = 0.0
    result[..., 2, 2, 0] = result[..., 2, 0, 2]
    result[..., 2, 2, 1] = result[..., 2, 1, 2]
    result[..., 2, 2, 2] = _ratio(-2.0 * cos_elevation * sin_elevation, distance_squared)
    result[..., 2, 2, 3] = 0.0
    result[..., 2, 2, 4] = 0.0
    result[..., 2, 2, 5] = 0.0
    result[..., 2, 3, 0] = 0.0
    result[..., 2, 3, 1] = 0.0
    result[..., 2, 3, 2] = 0.0
    result[..., 2, 3, 3] = 0.0
    result[..., 2, 3, 4] = 0.0
    result[..., 2, 3, 5] = 0.0
    result[..., 2, 4, 0] = 0.0
    result[..., 2, 4, 1] = 0.0
    result[..., 2, 4, 2] = 0.0
    result[..., 2, 4, 3] = 0.0
    result[..., 2, 4, 4] = 0.0
    result[..., 2, 4, 5] = 0.0
    result[..., 2, 5, 0] = 0.0
    result[..., 2, 5, 1] = 0.0
    result[..., 2, 5, 2] = 0.0
    result[..., 2, 5, 3] = 0.0
    result[..., 2, 5, 4] = 0.0
    result[..., 2, 5, 5] = 0.0
    result[..., 3, 0, 0] = _ratio(2.0 * cosine_x_squared * cosine_y * vy - 3.0 * cosine_x * cosine_y_squared * vx - 3.0 * cosine_x * cosine_z_squared * vx - cosine_y * cosine_z_squared * vy - cosine_y_squared * cosine_z * vz + 2.0 * cosine_x_squared * cosine_z * vz + product_4 + product_6, distance_squared)
    result[..., 3, 0, 1] = _ratio(2.0 * cosine_x * cosine_y_squared * vy - cosine_x * cosine_z_squared * vy - cosine_y * cosine_z_squared * vx - product_3 * vx - product_7 * vy + 2.0 * cosine_x_squared * cosine_y * vx + 3.0 * cosine_x * cosine_y * cosine_z * vz, distance_squared)
    result[..., 3, 0, 2] = _ratio(2.0 * cosine_x * cosine_z_squared * vz - cosine_x * cosine_y_squared * vz - cosine_y_squared * cosine_z * vx - product_5 * vx - product_7 * vz + 2.0 * cosine_x_squared * cosine_z * vx + 3.0 * cosine_x * cosine_y * cosine_z * vy, distance_squared)
    result[..., 3, 0, 3] = result[..., 0, 0, 0]
    result[..., 3, 0, 4] = result[..., 0, 0, 1]
    result[..., 3, 0, 5] = result[..., 0, 0, 2]
    result[..., 3, 1, 0] = result[..., 3, 0, 1]
    result[..., 3, 1, 1] = _ratio(2.0 * cosine_x * cosine_y_squared * vx - 3.0 * cosine_x_squared * cosine_y * vy - 3.0 * cosine_y * cosine_z_squared * vy - cosine_x * cosine_z_squared * vx - cosine_x_squared * cosine_z * vz + 2.0 * cosine_y_squared * cosine_z * vz + product_6 + product_8, distance_squared)
    result[..., 3, 1, 2] = _ratio(2.0 * cosine_y * cosine_z_squared * vz - cosine_x_squared * cosine_y * vz - cosine_x_squared * cosine_z * vy - product_3 * vz - product_5 * vy + 2.0 * cosine_y_squared * cosine_z * vy + 3.0 * cosine_x * cosine_y * cosine_z * vx, distance_squared)
    result[..., 3, 1, 3] = result[..., 0, 0, 1]
    result[..., 3, 1, 4] = result[..., 0, 1, 1]
    result[..., 3, 1, 5] = result[..., 0, 1, 2]
    result[..., 3, 2, 0] = result[..., 3, 0, 2]
    result[..., 3, 2, 1] = result[..., 3, 1, 2]
    result[..., 3, 2, 2] = _ratio(2.0 * cosine_x * cosine_z_squared * vx - 3.0 * cosine_x_squared * cosine_z * vz - 3.0 * cosine_y_squared * cosine_z * vz - cosine_x * cosine_y_squared * vx - cosine_x_squared * cosine_y * vy + 2.0 * cosine_y * cosine_z_squared * vy + product_4 + product_8, distance_squared)
    result[..., 3, 2, 3] = result[..., 0, 0, 2]
    result[..., 3, 2, 4] = result[..., 0, 1, 2]
    result[..., 3, 2, 5] = result[..., 0, 2, 2]
    result[..., 3, 3, 0] = result[..., 0, 0, 0]
    result[..., 3, 3, 1] = result[..., 0, 0, 1]
    result[..., 3, 3, 2] = result[..., 0, 0, 2]
    result[..., 3, 3, 3] = 0.0
    result[..., 3, 3, 4] = 0.0
    result[..., 3, 3, 5] = 0.0
    result[..., 3, 4, 0] = result[..., 0, 0, 1]
    result[..., 3, 4, 1] = result[..., 0, 1, 1]
    result[..., 3, 4, 2] = result[..., 0, 1, 2]
    result[..., 3, 4, 3] = 0.0
    result[..., 3, 4, 4] = 0.0
    result[..., 3, 4, 5] = 0.0
    result[..., 3, 5, 0] = result[..., 0, 0, 2]
    result[..., 3, 5, 1] = result[..., 0, 1, 2]
    result[..., 3, 5, 2] = result[..., 0, 2, 2]
    result[..., 3, 5, 3] = 0.0
    result[..., 3, 5, 4] = 0.0
    result[..., 3, 5, 5] = 0.0
    return result


def bistatic_map(*, x: npt.ArrayLike, y: npt.ArrayLike, baseline: npt.ArrayLike) -> Floats:
    """Length of the path from transmitter to target to receiver, and azimuth at the receiver.

    Name: observe.bistatic.map.
    Definition: g.
    Conditioning: no expectation is taken.
    Source: Bar-Shalom, Willett & Tian 2011 extended Kalman filter.

    Args:
        x: position along the x axis, from the radar [m], -1e+06 to 1e+06.
        y: position along the y axis, from the radar [m], -1e+06 to 1e+06.
        baseline: distance of the transmitter, which stands on the x axis [m], 1 to 1e+05.

    Returns:
        Shape of the broadcast arguments + (2), unit [m, rad].

    Accuracy: at most 4.01 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 10.1. Errors are measured against the
    sizes of the terms.
    """
    arguments = _floats(x, y, baseline)
    x, y, baseline = arguments
    distance = np.hypot(x, y)
    x_from_transmitter = x - baseline
    distance_from_transmitter = np.hypot(x_from_transmitter, y)
    result = _empty(arguments, (2,))
    result[..., 0] = distance + distance_from_transmitter
    result[..., 1] = np.arctan2(y, x)
    return result


def bistatic_jacobian(*, x: npt.ArrayLike, y: npt.ArrayLike, baseline: npt.ArrayLike) -> Floats:
    """First derivatives of length of the path from transmitter to target to receiver, and azimuth at the receiver, [out, in]; at a site its own term is zero.

    Name: observe.bistatic.jacobian.
    Definition: dg/dstate.
    Conditioning: no expectation is taken.
    Source: Bar-Shalom, Willett & Tian 2011 extended Kalman filter.

    Args:
        x: position along the x axis, from the radar [m], -1e+06 to 1e+06.
        y: position along the y axis, from the radar [m], -1e+06 to 1e+06.
        baseline: distance of the transmitter, which stands on the x axis [m], 1 to 1e+05.

    Returns:
        Shape of the broadcast arguments + (2, 2), unit [m, rad] × [1/m, 1/m].

    Accuracy: at most 6.01 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64). Errors are measured against the sizes of the terms.
    """
    arguments = _floats(x, y, baseline)
    x, y, baseline = arguments
    distance = np.hypot(x, y)
    cos_azimuth = _ratio(x, distance)
    sin_azimuth = _ratio(y, distance)
    x_from_transmitter = x - baseline
    distance_from_transmitter = np.hypot(x_from_transmitter, y)
    cos_azimuth_from_transmitter = _ratio(x_from_transmitter, distance_from_transmitter)
    sin_azimuth_from_transmitter = _ratio(y, distance_from_transmitter)
    result = _empty(arguments, (2, 2))
    result[..., 0, 0] = cos_azimuth + cos_azimuth_from_transmitter
    result[..., 0, 1] = sin_azimuth + sin_azimuth_from_transmitter
    result[..., 1, 0] = _ratio(-sin_azimuth, distance)
    result[..., 1, 1] = _ratio(cos_azimuth, distance)
    return result


def bistatic_hessian(*, x: npt.ArrayLike, y: npt.ArrayLike, baseline: npt.ArrayLike) -> Floats:
    """Second derivatives of length of the path from transmitter to target to receiver, and azimuth at the receiver, [out, in, in]; at a site its own term is zero.

    Name: observe.bistatic.hessian.
    Definition: d2g/dstate2.
    Conditioning: no expectation is taken.
    Source: Bar-Shalom, Willett & Tian 2011 extended Kalman filter.

    Args:
        x: position along the x axis, from the radar [m], -1e+06 to 1e+06.
        y: position along the y axis, from the radar [m], -1e+06 to 1e+06.
        baseline: distance of the transmitter, which stands on the x axis [m], 1 to 1e+05.

    Returns:
        Shape of the broadcast arguments + (2, 2, 2), unit [m, rad] × [1/m, 1/m] × [1/m, 1/m].

    Accuracy: at most 17.1 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64). Errors are measured against the sizes of the terms.
    """
    arguments = _floats(x, y, baseline)
    x, y, baseline = arguments
    distance = np.hypot(x, y)
    cos_azimuth = _ratio(x, distance)
    sin_azimuth = _ratio(y, distance)
    x_from_transmitter = x - baseline
    distance_from_transmitter = np.hypot(x_from_transmitter, y)
    cos_azimuth_from_transmitter = _ratio(x_from_transmitter, distance_from_transmitter)
    sin_azimuth_from_transmitter = _ratio(y, distance_from_transmitter)
    distance_squared = distance**2
    result = _empty(arguments, (2, 2, 2))
    result[..., 0, 0, 0] = (
        _ratio(sin_azimuth**2, distance)
        + _ratio(sin_azimuth_from_transmitter**2, distance_from_transmitter)
    )
    result[..., 0, 0, 1] = (
        _ratio(-cos_azimuth * sin_azimuth, distance)
        + _ratio(-cos_azimuth_from_transmitter * sin_azimuth_from_transmitter, distance_from_transmitter)
    )
    result[..., 0, 1, 0] = result[..., 0, 0, 1]
    result[..., 0, 1, 1] = (
        _ratio(cos_azimuth**2, distance)
        + _ratio(cos_azimuth_from_transmitter**2, distance_from_transmitter)
    )
    result[..., 1, 0, 0] = _ratio(2.0 * cos_azimuth * sin_azimuth, distance_squared)
    result[..., 1, 0, 1] = _ratio(-(cos_azimuth + sin_azimuth) * (cos_azimuth - sin_azimuth), distance_squared)
    result[..., 1, 1, 0] = result[..., 1, 0, 1]
    result[..., 1, 1, 1] = _ratio(-2.0 * cos_azimuth * sin_azimuth, distance_squared)
    return result


def bistatic_range_rate_map(
    *,
    x: npt.ArrayLike,
    y: npt.ArrayLike,
    vx: npt.ArrayLike,
    vy: npt.ArrayLike,
    baseline: npt.ArrayLike,
) -> Floats:
    """Rate of the length of the path from transmitter to target to receiver.

    Name: observe.bistatic_range_rate.map.
    Definition: g.
    Conditioning: no expectation is taken.
    Source: Bar-Shalom, Willett & Tian 2011 extended Kalman filter.

    Args:
        x: position along the x axis, from the radar [m], -1e+06 to 1e+06.
        y: position along the y axis, from the radar [m], -1e+06 to 1e+06.
        vx: velocity along the x axis [m/s], -1000 to 1000.
        vy: velocity along the y axis [m/s], -1000 to 1000.
        baseline: distance of the transmitter, which stands on the x axis [m], 1 to 1e+05.

    Returns:
        Shape of the broadcast arguments + (1), unit m/s.

    Accuracy: at most 9.01 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64). Errors are measured against the sizes of the terms.
    """
    arguments = _floats(x, y, vx, vy, baseline)
    x, y, vx, vy, baseline = arguments
    distance = np.hypot(x, y)
    cos_azimuth = _ratio(x, distance)
    sin_azimuth = _ratio(y, distance)
    x_from_transmitter = x - baseline
    distance_from_transmitter = np.hypot(x_from_transmitter, y)
    cos_azimuth_from_transmitter = _ratio(x_from_transmitter, distance_from_transmitter)
    sin_azimuth_from_transmitter = _ratio(y, distance_from_transmitter)
    result = _empty(arguments, (1,))
    result[..., 0] = (
        cos_azimuth * vx
        + cos_azimuth_from_transmitter * vx
        + sin_azimuth * vy
        + sin_azimuth_from_transmitter * vy
    )
    return result


def bistatic_range_rate_jacobian(
    *,
    x: npt.ArrayLike,
    y: npt.ArrayLike,
    vx: npt.ArrayLike,
    vy: npt.ArrayLike,
    baseline: npt.ArrayLike,
) -> Floats:
    """First derivatives of rate of the length of the path from transmitter to target to receiver, [out, in]; at a site its own term is zero.

    Name: observe.bistatic_range_rate.jacobian.
    Definition: dg/dstate.
    Conditioning: no expectation is taken.
    Source: Bar-Shalom, Willett & Tian 2011 extended Kalman filter.

    Args:
        x: position along the x axis, from the radar [m], -1e+06 to 1e+06.
        y: position along the y axis, from the radar [m], -1e+06 to 1e+06.
        vx: velocity along the x axis [m/s], -1000 to 1000.
        vy: velocity along the y axis [m/s], -1000 to 1000.
        baseline: distance of the transmitter, which stands on the x axis [m], 1 to 1e+05.

    Returns:
        Shape of the broadcast arguments + (1, 4), unit [m/s] × [1/m, 1/m, s/m, s/m].

    Accuracy: at most 18.1 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64). Errors are measured against the sizes of the terms.
    """
    arguments = _floats(x, y, vx, vy, baseline)
    x, y, vx, vy, baseline = arguments
    distance = np.hypot(x, y)
    cos_azimuth = _ratio(x, distance)
    sin_azimuth = _ratio(y, distance)
    x_from_transmitter = x - baseline
    distance_from_transmitter = np.hypot(x_from_transmitter, y)
    cos_azimuth_from_transmitter = _ratio(x_from_transmitter, distance_from_transmitter)
    sin_azimuth_from_transmitter = _ratio(y, distance_from_transmitter)
    sum_1 = cos_azimuth * vy - sin_azimuth * vx
    sum_2 = cos_azimuth_from_transmitter * vy - sin_azimuth_from_transmitter * vx
    result = _empty(arguments, (1, 4))
    result[..., 0, 0] = (
        _ratio(-sin_azimuth * sum_1, distance)
        + _ratio(-sin_azimuth_from_transmitter * sum_2, distance_from_transmitter)
    )
    result[..., 0, 1] = (
        _ratio(cos_azimuth * sum_1, distance)
        + _ratio(cos_azimuth_from_transmitter * sum_2, distance_from_transmitter)
    )
    result[..., 0, 2] = cos_azimuth + cos_azimuth_from_transmitter
    result[..., 0, 3] = sin_azimuth + sin_azimuth_from_transmitter
    return result


def bistatic_range_rate_hessian(
    *,
    x: npt.ArrayLike,
    y: npt.ArrayLike,
    vx: npt.ArrayLike,
    vy: npt.ArrayLike,
    baseline: npt.ArrayLike,
) -> Floats:
    """Second derivatives of rate of the length of the path from transmitter to target to receiver, [out, in, in]; at a site its own term is zero.

    Name: observe.bistatic_range_rate.hessian.
    Definition: d2g/dstate2.
    Conditioning: no expectation is taken.
    Source: Bar-Shalom, Willett & Tian 2011 extended Kalman filter.

    Args:
        x: position along the x axis, from the radar [m], -1e+06 to 1e+06.
        y: position along the y axis, from the radar [m], -1e+06 to 1e+06.
        vx: velocity along the x axis [m/s], -1000 to 1000.
        vy: velocity along the y axis [m/s], -1000 to 1000.
        baseline: distance of the transmitter, which stands on the x axis [m], 1 to 1e+05.

    Returns:
        Shape of the broadcast arguments + (1, 4, 4), unit [m/s] × [1/m, 1/m, s/m, s/m] × [1/m, 1/m, s/m,
        s/m].

    Accuracy: at most 32.1 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64). Errors are measured against the sizes of the terms.
    """
    arguments = _floats(x, y, vx, vy, baseline)
    x, y, vx, vy, baseline = arguments
    distance = np.hypot(x, y)
    cos_azimuth = _ratio(x, distance)
    sin_azimuth = _ratio(y, distance)
    x_from_transmitter = x - baseline
    distance_from_transmitter = np.hypot(x_from_transmitter, y)
    cos_azimuth_from_transmitter = _ratio(x_from_transmitter, distance_from_transmitter)
    sin_azimuth_from_transmitter = _ratio(y, distance_from_transmitter)
    sin_azimuth_squared = sin_azimuth**2
    cos_azimuth_squared = cos_azimuth**2
    sum_1 = 2.0 * cos_azimuth_squared * vy - 3.0 * cos_azimuth * sin_azimuth * vx - sin_azimuth_squared * vy
    distance_squared = distance**2
    sin_azimuth_from_transmitter_squared = sin_azimuth_from_transmitter**2
    cos_azimuth_from_transmitter_squared = cos_azimuth_from_transmitter**2
    sum_2 = (
        2.0 * cos_azimuth_from_transmitter_squared * vy
        - 3.0 * cos_azimuth_from_transmitter * sin_azimuth_from_transmitter * vx
        - sin_azimuth_from_transmitter_squared * vy
    )
    distance_from_transmitter_squared = distance_from_transmitter**2
    sum_3 = 3.0 * cos_azimuth * sin_azimuth * vy - 2.0 * sin_azimuth_squared * vx + cos_azimuth_squared * vx
    sum_4 = (
        3.0 * cos_azimuth_from_transmitter * sin_azimuth_from_transmitter * vy
        - 2.0 * sin_azimuth_from_transmitter_squared * vx
        + cos_azimuth_from_transmitter_squared * vx
    )
    result = _empty(arguments, (1, 4, 4))
    result[..., 0, 0, 0] = (
        _ratio(sin_azimuth * sum_1, distance_squared)
        + _ratio(sin_azimuth_from_transmitter * sum_2, distance_from_transmitter_squared)
    )
    result[..., 0, 0, 1] = (
        _ratio(2.0 * cos_azimuth * sin_azimuth_squared * vy - cos_azimuth * cos_azimuth_squared * vy - sin_azimuth * sin_azimuth_squared * vx + 2.0 * cos_azimuth_squared * sin_azimuth * vx, distance_squared)
        + _ratio(2.0 * cos_azimuth_from_transmitter * sin_azimuth_from_transmitter_squared * vy - cos_azimuth_from_transmitter * cos_azimuth_from_transmitter_squared * vy - sin_azimuth_from_transmitter * sin_azimuth_from_transmitter_squared * vx + 2.0 * cos_azimuth_from_transmitter_squared * sin_azimuth_from_transmitter * vx, distance_from_transmitter_squared)
    )
    result[..., 0, 0, 2] = (
        _ratio(sin_azimuth_from_transmitter_squared, distance_from_transmitter)
        + _ratio(sin_azimuth_squared, distance)
    )
    result[..., 0, 0, 3] = (
        _ratio(-cos_azimuth * sin_azimuth, distance)
        + _ratio(-cos_azimuth_from_transmitter * sin_azimuth_from_transmitter, distance_from_transmitter)
    )
    result[..., 0, 1, 0] = result[..., 0, 0, 1]
    result[..., 0, 1, 1] = (
        _ratio(-cos_azimuth * sum_3, distance_squared)
        + _ratio(-cos_azimuth_from_transmitter * sum_4, distance_from_transmitter_squared)
    )
    result[..., 0, 1, 2] = result[..., 0, 0, 3]
    result[..., 0, 1, 3] = (
        _ratio(cos_azimuth_from_transmitter_squared, distance_from_transmitter)
        + _ratio(cos_azimuth_squared, distance)
    )
    result[..., 0, 2, 0] = result[..., 0, 0, 2]
    result[..., 0, 2, 1] = result[..., 0, 0, 3]
    result[..., 0, 2, 2] = 0.0
    result[..., 0, 2, 3] = 0.0
    result[..., 0, 3, 0] = result[..., 0, 0, 3]
    result[..., 0, 3, 1] = result[..., 0, 1, 3]
    result[..., 0, 3, 2] = 0.0
    result[..., 0, 3, 3] = 0.0
    return result


def range_difference_map(
    *,
    x: npt.ArrayLike,
    y: npt.ArrayLike,
    z: npt.ArrayLike,
    receiver_x: npt.ArrayLike,
    receiver_y: npt.ArrayLike,
    receiver_z: npt.ArrayLike,
) -> Floats:
    """Range from the other receiver less that from the origin (time difference of arrival).

    Name: observe.range_difference.map.
    Definition: g.
    Conditioning: no expectation is taken.
    Source: Bar-Shalom, Willett & Tian 2011 extended Kalman filter.

    Args:
        x: position along the x axis, from the radar [m], -1e+06 to 1e+06.
        y: position along the y axis, from the radar [m], -1e+06 to 1e+06.
        z: position along the z axis, from the radar [m], -1e+06 to 1e+06.
        receiver_x: position of the other receiver along the x axis [m], -1e+05 to 1e+05.
        receiver_y: position of the other receiver along the y axis [m], -1e+05 to 1e+05.
        receiver_z: position of the other receiver along the z axis [m], -1e+05 to 1e+05.

    Returns:
        Shape of the broadcast arguments + (1), unit m.

    Accuracy: at most 6.01 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 18.1. Errors are measured against the
    sizes of the terms.
    """
    arguments = _floats(x, y, z, receiver_x, receiver_y, receiver_z)
    x, y, z, receiver_x, receiver_y, receiver_z = arguments
    ground_distance = np.hypot(x, y)
    distance = np.hypot(ground_distance, z)
    x_from_receiver = x - receiver_x
    y_from_receiver = y - receiver_y
    z_from_receiver = z - receiver_z
    ground_distance_from_receiver = np.hypot(x_from_receiver, y_from_receiver)
    distance_from_receiver = np.hypot(ground_distance_from_receiver, z_from_receiver)
    result = _empty(arguments, (1,))
    result[..., 0] = distance_from_receiver - distance
    return result


def range_difference_jacobian(
    *,
    x: npt.ArrayLike,
    y: npt.ArrayLike,
    z: npt.ArrayLike,
    receiver_x: npt.ArrayLike,
    receiver_y: npt.ArrayLike,
    receiver_z: npt.ArrayLike,
) -> Floats:
    """First derivatives of range from the other receiver less that from the origin (time difference of arrival), [out, in]; at a site its own term is zero.

    Name: observe.range_difference.jacobian.
    Definition: dg/dstate.
    Conditioning: no expectation is taken.
    Source: Bar-Shalom, Willett & Tian 2011 extended Kalman filter.

    Args:
        x: position along the x axis, from the radar [m], -1e+06 to 1e+06.
        y: position along the y axis, from the radar [m], -1e+06 to 1e+06.
        z: position along the z axis, from the radar [m], -1e+06 to 1e+06.
        receiver_x: position of the other receiver along the x axis [m], -1e+05 to 1e+05.
        receiver_y: position of the other receiver along the y axis [m], -1e+05 to 1e+05.
        receiver_z: position of the other receiver along the z axis [m], -1e+05 to 1e+05.

    Returns:
        Shape of the broadcast arguments + (1, 3), unit 1.

    Accuracy: at most 8.01 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 20.1. Errors are measured against the
    sizes of the terms.
    """
    arguments = _floats(x, y, z, receiver_x, receiver_y, receiver_z)
    x, y, z, receiver_x, receiver_y, receiver_z = arguments
    ground_distance = np.hypot(x, y)
    distance = np.hypot(ground_distance, z)
    cosine_x = _ratio(x, distance)
    cosine_y = _ratio(y, distance)
    cosine_z = _ratio(z, distance)
    x_from_receiver = x - receiver_x
    y_from_receiver = y - receiver_y
    z_from_receiver = z - receiver_z
    ground_distance_from_receiver = np.hypot(x_from_receiver, y_from_receiver)
    distance_from_receiver = np.hypot(ground_distance_from_receiver, z_from_receiver)
    cosine_x_from_receiver = _ratio(x_from_receiver, distance_from_receiver)
    cosine_y_from_receiver = _ratio(y_from_receiver, distance_from_receiver)
    cosine_z_from_receiver = _ratio(z_from_receiver, distance_from_receiver)
    result = _empty(arguments, (1, 3))
    result[..., 0, 0] = cosine_x_from_receiver - cosine_x
    result[..., 0, 1] = cosine_y_from_receiver - cosine_y
    result[..., 0, 2] = cosine_z_from_receiver - cosine_z
    return result


def range_difference_hessian(
    *,
    x: npt.ArrayLike,
    y: npt.ArrayLike,
    z: npt.ArrayLike,
    receiver_x: npt.ArrayLike,
    receiver_y: npt.ArrayLike,
    receiver_z: npt.ArrayLike,
) -> Floats:
    """Second derivatives of range from the other receiver less that from the origin (time difference of arrival), [out, in, in]; at a site its own term is zero.

    Name: observe.range_difference.hessian.
    Definition: d2g/dstate2.
    Conditioning: no expectation is taken.
    Source: Bar-Shalom, Willett & Tian 2011 extended Kalman filter.

    Args:
        x: position along the x axis, from the radar [m], -1e+06 to 1e+06.
        y: position along the y axis, from the radar [m], -1e+06 to 1e+06.
        z: position along the z axis, from the radar [m], -1e+06 to 1e+06.
        receiver_x: position of the other receiver along the x axis [m], -1e+05 to 1e+05.
        receiver_y: position of the other receiver along the y axis [m], -1e+05 to 1e+05.
        receiver_z: position of the other receiver along the z axis [m], -1e+05 to 1e+05.

    Returns:
        Shape of the broadcast arguments + (1, 3, 3), unit 1/m.

    Accuracy: at most 24.1 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64). Errors are measured against the sizes of the terms.
    """
    arguments = _floats(x, y, z, receiver_x, receiver_y, receiver_z)
    x, y, z, receiver_x, receiver_y, receiver_z = arguments
    ground_distance = np.hypot(x, y)
    distance = np.hypot(ground_distance, z)
    cosine_x = _ratio(x, distance)
    cosine_y = _ratio(y, distance)
    cosine_z = _ratio(z, distance)
    x_from_receiver = x - receiver_x
    y_from_receiver = y - receiver_y
    z_from_receiver = z - receiver_z
    ground_distance_from_receiver = np.hypot(x_from_receiver, y_from_receiver)
    distance_from_receiver = np.hypot(ground_distance_from_receiver, z_from_receiver)
    cosine_x_from_receiver = _ratio(x_from_receiver, distance_from_receiver)
    cosine_y_from_receiver = _ratio(y_from_receiver, distance_from_receiver)
    cosine_z_from_receiver = _ratio(z_from_receiver, distance_from_receiver)
    cosine_y_from_receiver_squared = cosine_y_from_receiver**2
    cosine_z_from_receiver_squared = cosine_z_from_receiver**2
    cosine_x_from_receiver_squared = cosine_x_from_receiver**2
    result = _empty(arguments, (1, 3, 3))
    result[..., 0, 0, 0] = (
        _ratio(-cosine_y**2 - cosine_z**2, distance)
        + _ratio(cosine_y_from_receiver_squared + cosine_z_from_receiver_squared, distance_from_receiver)
    )
    result[..., 0, 0, 1] = (
        _ratio(-cosine_x_from_receiver * cosine_y_from_receiver, distance_from_receiver)
        + _ratio(cosine_x * cosine_y, distance)
    )
    result[..., 0, 0, 2] = (
        _ratio(-cosine_x_from_receiver * cosine_z_from_receiver, distance_from_receiver)
        + _ratio(cosine_x * cosine_z, distance)
    )
    result[..., 0, 1, 0] = result[..., 0, 0, 1]
    result[..., 0, 1, 1] = (
        _ratio(-cosine_x**2 - cosine_z**2, distance)
        + _ratio(cosine_x_from_receiver_squared + cosine_z_from_receiver_squared, distance_from_receiver)
    )
    result[..., 0, 1, 2] = (
        _ratio(-cosine_y_from_receiver * cosine_z_from_receiver, distance_from_receiver)
        + _ratio(cosine_y * cosine_z, distance)
    )
    result[..., 0, 2, 0] = result[..., 0, 0, 2]
    result[..., 0, 2, 1] = result[..., 0, 1, 2]
    result[..., 0, 2, 2] = (
        _ratio(-cosine_x**2 - cosine_y**2, distance)
        + _ratio(cosine_x_from_receiver_squared + cosine_y_from_receiver_squared, distance_from_receiver)
    )
    return result


def range_rate_difference_map(
    *,
    x: npt.ArrayLike,
    y: npt.ArrayLike,
    z: npt.ArrayLike,
    vx: npt.ArrayLike,
    vy: npt.ArrayLike,
    vz: npt.ArrayLike,
    receiver_x: npt.ArrayLike,
    receiver_y: npt.ArrayLike,
    receiver_z: npt.ArrayLike,
) -> Floats:
    """Range rate at the other receiver less that at the origin (frequency difference of arrival).

    Name: observe.range_rate_difference.map.
    Definition: g.
    Conditioning: no expectation is taken.
    Source: Bar-Shalom, Willett & Tian 2011 extended Kalman filter.

    Args:
        x: position along the x axis, from the radar [m], -1e+06 to 1e+06.
        y: position along the y axis, from the radar [m], -1e+06 to 1e+06.
        z: position along the z axis, from the radar [m], -1e+06 to 1e+06.
        vx: velocity along the x axis [m/s], -1000 to 1000.
        vy: velocity along the y axis [m/s], -1000 to 1000.
        vz: velocity along the z axis [m/s], -1000 to 1000.
        receiver_x: position of the other receiver along the x axis [m], -1e+05 to 1e+05.
        receiver_y: position of the other receiver along the y axis [m], -1e+05 to 1e+05.
        receiver_z: position of the other receiver along the z axis [m], -1e+05 to 1e+05.

    Returns:
        Shape of the broadcast arguments + (1), unit m/s.

    Accuracy: at most 13.1 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64). Errors are measured against the sizes of the terms.
    """
    arguments = _floats(x, y, z, vx, vy, vz, receiver_x, receiver_y, receiver_z)
    x, y, z, vx, vy, vz, receiver_x, receiver_y, receiver_z = arguments
    ground_distance = np.hypot(x, y)
    distance = np.hypot(ground_distance, z)
    cosine_x = _ratio(x, distance)
    cosine_y = _ratio(y, distance)
    cosine_z = _ratio(z, distance)
    x_from_receiver = x - receiver_x
    y_from_receiver = y - receiver_y
    z_from_receiver = z - receiver_z
    ground_distance_from_receiver = np.hypot(x_from_receiver, y_from_receiver)
    distance_from_receiver = np.hypot(ground_distance_from_receiver, z_from_receiver)
    cosine_x_from_receiver = _ratio(x_from_receiver, distance_from_receiver)
    cosine_y_from_receiver = _ratio(y_from_receiver, distance_from_receiver)
    cosine_z_from_receiver = _ratio(z_from_receiver, distance_from_receiver)
    result = _empty(arguments, (1,))
    result[..., 0] = (
        cosine_x_from_receiver * vx
        - cosine_x * vx
        - cosine_y * vy
        - cosine_z * vz
        + cosine_y_from_receiver * vy
        + cosine_z_from_receiver * vz
    )
    return result


def range_rate_difference_jacobian(
    *,
    x: npt.ArrayLike,
    y: npt.ArrayLike,
    z: npt.ArrayLike,
    vx: npt.ArrayLike,
    vy: npt.ArrayLike,
    vz: npt.ArrayLike,
    receiver_x: npt.ArrayLike,
    receiver_y: npt.ArrayLike,
    receiver_z: npt.ArrayLike,
) -> Floats:
    """First derivatives of range rate at the other receiver less that at the origin (frequency difference of arrival), [out, in]; at a site its own term is zero.

    Name: observe.range_rate_difference.jacobian.
    Definition: dg/dstate.
    Conditioning: no expectation is taken.
    Source: Bar-Shalom, Willett & Tian 2011 extended Kalman filter.

    Args:
        x: position along the x axis, from the radar [m], -1e+06 to 1e+06.
        y: position along the y axis, from the radar [m], -1e+06 to 1e+06.
        z: position along the z axis, from the radar [m], -1e+06 to 1e+06.
        vx: velocity along the x axis [m/s], -1000 to 1000.
        vy: velocity along the y axis [m/s], -1000 to 1000.
        vz: velocity along the z axis [m/s], -1000 to 1000.
        receiver_x: position of the other receiver along the x axis [m], -1e+05 to 1e+05.
        receiver_y: position of the other receiver along the y axis [m], -1e+05 to 1e+05.
        receiver_z: position of the other receiver along the z axis [m], -1e+05 to 1e+05.

    Returns:
        Shape of the broadcast arguments + (1, 6), unit [m/s] × [1/m, 1/m, 1/m, s/m, s/m, s/m].

    Accuracy: at most 27.1 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64). Errors are measured against the sizes of the terms.
    """
    arguments = _floats(x, y, z, vx, vy, vz, receiver_x, receiver_y, receiver_z)
    x, y, z, vx, vy, vz, receiver_x, receiver_y, receiver_z = arguments
    ground_distance = np.hypot(x, y)
    distance = np.hypot(ground_distance, z)
    cosine_x = _ratio(x, distance)
    cosine_y = _ratio(y, distance)
    cosine_z = _ratio(z, distance)
    x_from_receiver = x - receiver_x
    y_from_receiver = y - receiver_y
    z_from_receiver = z - receiver_z
    ground_distance_from_receiver = np.hypot(x_from_receiver, y_from_receiver)
    distance_from_receiver = np.hypot(ground_distance_from_receiver, z_from_receiver)
    cosine_x_from_receiver = _ratio(x_from_receiver, distance_from_receiver)
    cosine_y_from_receiver = _ratio(y_from_receiver, distance_from_receiver)
    cosine_z_from_receiver = _ratio(z_from_receiver, distance_from_receiver)
    cosine_y_from_receiver_squared = cosine_y_from_receiver**2
    cosine_z_from_receiver_squared = cosine_z_from_receiver**2
    cosine_y_squared = cosine_y**2
    cosine_z_squared = cosine_z**2
    cosine_x_squared = cosine_x**2
    cosine_x_from_receiver_squared = cosine_x_from_receiver**2
    result = _empty(arguments, (1, 6))
    result[..., 0, 0] = (
        _ratio(cosine_y_from_receiver_squared * vx - cosine_x_from_receiver * cosine_y_from_receiver * vy - cosine_x_from_receiver * cosine_z_from_receiver * vz + cosine_z_from_receiver_squared * vx, distance_from_receiver)
        + _ratio(cosine_x * cosine_y * vy - cosine_y_squared * vx - cosine_z_squared * vx + cosine_x * cosine_z * vz, distance)
    )
    result[..., 0, 1] = (
        _ratio(cosine_x_from_receiver_squared * vy - cosine_x_from_receiver * cosine_y_from_receiver * vx - cosine_y_from_receiver * cosine_z_from_receiver * vz + cosine_z_from_receiver_squared * vy, distance_from_receiver)
        + _ratio(cosine_x * cosine_y * vx - cosine_x_squared * vy - cosine_z_squared * vy + cosine_y * cosine_z * vz, distance)
    )
    result[..., 0, 2] = (
        _ratio(cosine_x_from_receiver_squared * vz - cosine_x_from_receiver * cosine_z_from_receiver * vx - cosine_y_from_receiver * cosine_z_from_receiver * vy + cosine_y_from_receiver_squared * vz, distance_from_receiver)
        + _ratio(cosine_x * cosine_z * vx - cosine_x_squared * vz - cosine_y_squared * vz + cosine_y * cosine_z * vy, distance)
    )
    result[..., 0, 3] = cosine_x_from_receiver - cosine_x
    result[..., 0, 4] = cosine_y_from_receiver - cosine_y
    result[..., 0, 5] = cosine_z_from_receiver - cosine_z
    return result


def range_rate_difference_hessian(
    *,
    x: npt.ArrayLike,
    y: npt.ArrayLike,
    z: npt.ArrayLike,
    vx: npt.ArrayLike,
    vy: npt.ArrayLike,
    vz: npt.ArrayLike,
    receiver_x: npt.ArrayLike,
    receiver_y: npt.ArrayLike,
    receiver_z: npt.ArrayLike,
) -> Floats:
    """Second derivatives of range rate at the other receiver less that at the origin (frequency difference of arrival), [out, in, in]; at a site its own term is zero.

    Name: observe.range_rate_difference.hessian.
    Definition: d2g/dstate2.
    Conditioning: no expectation is taken.
    Source: Bar-Shalom, Willett & Tian 2011 extended Kalman filter.

    Args:
        x: position along the x axis, from the radar [m], -1e+06 to 1e+06.
        y: position along the y axis, from the radar [m], -1e+06 to 1e+06.
        z: position along the z axis, from the radar [m], -1e+06 to 1e+06.
        vx: velocity along the x axis [m/s], -1000 to 1000.
        vy: velocity along the y axis [m/s], -1000 to 1000.
        vz: velocity along the z axis [m/s], -1000 to 1000.
        receiver_x: position of the other receiver along the x axis [m], -1e+05 to 1e+05.
        receiver_y: position of the other receiver along the y axis [m], -1e+05 to 1e+05.
        receiver_z: position of the other receiver along the z axis [m], -1e+05 to 1e+05.

    Returns:
        Shape of the broadcast arguments + (1, 6, 6), unit [m/s] × [1/m, 1/m, 1/m, s/m, s/m, s/m] × [1/m, 1/m,
        1/m, s/m, s/m, s/m].

    Accuracy: at most 47.1 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64). Errors are measured against the sizes of the terms.
    """
    arguments = _floats(x, y, z, vx, vy, vz, receiver_x, receiver_y, receiver_z)
    x, y, z, vx, vy, vz, receiver_x, receiver_y, receiver_z = arguments
    ground_distance = np.hypot(x, y)
    distance = np.hypot(ground_distance, z)
    cosine_x = _ratio(x, distance)
    cosine_y = _ratio(y, distance)
    cosine_z = _ratio(z, distance)
    x_from_receiver = x - receiver_x
    y_from_receiver = y - receiver_y
    z_from_receiver = z - receiver_z
    ground_distance_from_receiver = np.hypot(x_from_receiver, y_from_receiver)
    distance_from_receiver = np.hypot(ground_distance_from_receiver, z_from_receiver)
    cosine_x_from_receiver = _ratio(x_from_receiver, distance_from_receiver)
    cosine_y_from_receiver = _ratio(y_from_receiver, distance_from_receiver)
    cosine_z_from_receiver = _ratio(z_from_receiver, distance_from_receiver)
    cosine_x_squared = cosine_x**2
    cosine_y_squared = cosine_y**2
    cosine_z_squared = cosine_z**2
    product_1 = cosine_y * cosine_y_squared
    product_2 = product_1 * vy
    product_3 = cosine_z * cosine_z_squared
    product_4 = product_3 * vz
    distance_squared = distance**2
    cosine_y_from_receiver_squared = cosine_y_from_receiver**2
    cosine_z_from_receiver_squared = cosine_z_from_receiver**2
    product_5 = cosine_y_from_receiver * cosine_y_from_receiver_squared
    product_6 = -product_5 * vy
    product_7 = cosine_z_from_receiver * cosine_z_from_receiver_squared
    product_8 = -product_7 * vz
    cosine_x_from_receiver_squared = cosine_x_from_receiver**2
    distance_from_receiver_squared = distance_from_receiver**2
    product_9 = cosine_x_from_receiver * cosine_x_from_receiver_squared
    product_10 = cosine_x * cosine_x_squared
    product_11 = -product_9 * vx
    product_12 = product_10 * vx
    result = _empty(arguments, (1, 6, 6))
    result[..., 0, 0, 0] = (
        _ratio(2.0 * cosine_x_from_receiver_squared * cosine_y_from_receiver * vy - 3.0 * cosine_x_from_receiver * cosine_y_from_receiver_squared * vx - 3.0 * cosine_x_from_receiver * cosine_z_from_receiver_squared * vx - cosine_y_from_receiver * cosine_z_from_receiver_squared * vy - cosine_y_from_receiver_squared * cosine_z_from_receiver * vz + 2.0 * cosine_x_from_receiver_squared * cosine_z_from_receiver * vz + product_6 + product_8, distance_from_receiver_squared)
        + _ratio(3.0 * cosine_x * cosine_y_squared * vx - 2.0 * cosine_x_squared * cosine_y * vy - 2.0 * cosine_x_squared * cosine_z * vz + 3.0 * cosine_x * cosine_z_squared * vx + cosine_y * cosine_z_squared * vy + cosine_y_squared * cosine_z * vz + product_2 + product_4, distance_squared)
    )
    result[..., 0, 0, 1] = (
        _ratio(cosine_x * cosine_z_squared * vy - 2.0 * cosine_x * cosine_y_squared * vy - 2.0 * cosine_x_squared * cosine_y * vx - 3.0 * cosine_x * cosine_y * cosine_z * vz + cosine_y * cosine_z_squared * vx + product_1 * vx + product_10 * vy, distance_squared)
        + _ratio(2.0 * cosine_x_from_receiver * cosine_y_from_receiver_squared * vy - cosine_x_from_receiver * cosine_z_from_receiver_squared * vy - cosine_y_from_receiver * cosine_z_from_receiver_squared * vx - product_5 * vx - product_9 * vy + 2.0 * cosine_x_from_receiver_squared * cosine_y_from_receiver * vx + 3.0 * cosine_x_from_receiver * cosine_y_from_receiver * cosine_z_from_receiver * vz, distance_from_receiver_squared)
    )
    result[..., 0, 0, 2] = (
        _ratio(cosine_x * cosine_y_squared * vz - 2.0 * cosine_x * cosine_z_squared * vz - 2.0 * cosine_x_squared * cosine_z * vx - 3.0 * cosine_x * cosine_y * cosine_z * vy + cosine_y_squared * cosine_z * vx + product_10 * vz + product_3 * vx, distance_squared)
        + _ratio(2.0 * cosine_x_from_receiver * cosine_z_from_receiver_squared * vz - cosine_x_from_receiver * cosine_y_from_receiver_squared * vz - cosine_y_from_receiver_squared * cosine_z_from_receiver * vx - product_7 * vx - product_9 * vz + 2.0 * cosine_x_from_receiver_squared * cosine_z_from_receiver * vx + 3.0 * cosine_x_from_receiver * cosine_y_from_receiver * cosine_z_from_receiver * vy, distance_from_receiver_squared)
    )
    result[..., 0, 0, 3] = (
        _ratio(-cosine_y_squared - cosine_z_squared, distance)
        + _ratio(cosine_y_from_receiver_squared + cosine_z_from_receiver_squared, distance_from_receiver)
    )
    result[..., 0, 0, 4] = (
        _ratio(-cosine_x_from_receiver * cosine_y_from_receiver, distance_from_receiver)
        + _ratio(cosine_x * cosine_y, distance)
    )
    result[..., 0, 0, 5] = (
        _ratio(-cosine_x_from_receiver * cosine_z_from_receiver, distance_from_receiver)
        + _ratio(cosine_x * cosine_z, distance)
    )
    result[..., 0, 1, 0] = result[..., 0, 0, 1]
    result[..., 0, 1, 1] = (
        _ratio(3.0 * cosine_x_squared * cosine_y * vy - 2.0 * cosine_x * cosine_y_squared * vx - 2.0 * cosine_y_squared * cosine_z * vz + 3.0 * cosine_y * cosine_z_squared * vy + cosine_x * cosine_z_squared * vx + cosine_x_squared * cosine_z * vz + product_12 + product_4, distance_squared)
        + _ratio(2.0 * cosine_x_from_receiver * cosine_y_from_receiver_squared * vx - 3.0 * cosine_x_from_receiver_squared * cosine_y_from_receiver * vy - 3.0 * cosine_y_from_receiver * cosine_z_from_receiver_squared * vy - cosine_x_from_receiver * cosine_z_from_receiver_squared * vx - cosine_x_from_receiver_squared * cosine_z_from_receiver * vz + 2.0 * cosine_y_from_receiver_squared * cosine_z_from_receiver * vz + product_11 + product_8, distance_from_receiver_squared)
    )
    result[..., 0, 1, 2] = (
        _ratio(cosine_x_squared * cosine_y * vz - 2.0 * cosine_y * cosine_z_squared * vz - 2.0 * cosine_y_squared * cosine_z * vy - 3.0 * cosine_x * cosine_y * cosine_z * vx + cosine_x_squared * cosine_z * vy + product_1 * vz + product_3 * vy, distance_squared)
        + _ratio(2.0 * cosine_y_from_receiver * cosine_z_from_receiver_squared * vz - cosine_x_from_receiver_squared * cosine_y_from_receiver * vz - cosine_x_from_receiver_squared * cosine_z_from_receiver * vy - product_5 * vz - product_7 * vy + 2.0 * cosine_y_from_receiver_squared * cosine_z_from_receiver * vy + 3.0 * cosine_x_from_receiver * cosine_y_from_receiver * cosine_z_from_receiver * vx, distance_from_receiver_squared)
    )
    result[..., 0, 1, 3] = result[..., 0, 0, 4]
    result[..., 0, 1, 4] = (
        _ratio(-cosine_x_squared - cosine_z_squared, distance)
        + _ratio(cosine_x_from_receiver_squared + cosine_z_from_receiver_squared, distance_from_receiver)
    )
    result[..., 0, 1, 5] = (
        _ratio(-cosine_y_from_receiver * cosine_z_from_receiver, distance_from_receiver)
        + _ratio(cosine_y * cosine_z, distance)
    )
    result[..., 0, 2, 0] = result[..., 0, 0, 2]
    result[..., 0, 2, 1] = result[..., 0, 1, 2]
    result[..., 0, 2, 2] = (
        _ratio(2.0 * cosine_x_from_receiver * cosine_z_from_receiver_squared * vx - 3.0 * cosine_x_from_receiver_squared * cosine_z_from_receiver * vz - 3.0 * cosine_y_from_receiver_squared * cosine_z_from_receiver * vz - cosine_x_from_receiver * cosine_y_from_receiver_squared * vx - cosine_x_from_receiver_squared * cosine_y_from_receiver * vy + 2.0 * cosine_y_from_receiver * cosine_z_from_receiver_squared * vy + product_11 + product_6, distance_from_receiver_squared)
        + _ratio(3.0 * cosine_x_squared * cosine_z * vz - 2.0 * cosine_x * cosine_z_squared * vx - 2.0 * cosine_y * cosine_z_squared * vy + 3.0 * cosine_y_squared * cosine_z * vz + cosine_x * cosine_y_squared * vx + cosine_x_squared * cosine_y * vy + product_12 + product_2, distance_squared)
    )
    result[..., 0, 2, 3] = result[..., 0, 0, 5]
    result[..., 0, 2, 4] = result[..., 0, 1, 5]
    result[..., 0, 2, 5] = (
        _ratio(-cosine_x_squared - cosine_y_squared, distance)
        + _ratio(cosine_x_from_receiver_squared + cosine_y_from_receiver_squared, distance_from_receiver)
    )
    result[..., 0, 3, 0] = result[..., 0, 0, 3]
    result[..., 0, 3, 1] = result[..., 0, 0, 4]
    result[..., 0, 3, 2] = result[..., 0, 0, 5]
    result[..., 0, 3, 3] = 0.0
    result[..., 0, 3, 4] = 0.0
    result[..., 0, 3, 5] = 0.0
    result[..., 0, 4, 0] = result[..., 0, 0, 4]
    result[..., 0, 4, 1] = result[..., 0, 1, 4]
    result[..., 0, 4, 2] = result[..., 0, 1, 5]
    result[..., 0, 4, 3] = 0.0
    result[..., 0, 4, 4] = 0.0
    result[..., 0, 4, 5] = 0.0
    result[..., 0, 5, 0] = result[..., 0, 0, 5]
    result[..., 0, 5, 1] = result[..., 0, 1, 5]
    result[..., 0, 5, 2] = result[..., 0, 2, 5]
    result[..., 0, 5, 3] = 0.0
    result[..., 0, 5, 4] = 0.0
    result[..., 0, 5, 5] = 0.0
    return result
