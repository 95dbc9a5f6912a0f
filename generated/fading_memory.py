"""NumPy functions of the quantities fading_memory.*.

Written by radartrack regenerate, generator 1, derivation 9379da4b249ba955; not to be edited.
"""

import numpy as np
import numpy.typing as npt

__all__ = [
    "degree0",
    "degree0_covariance",
    "degree1",
    "degree1_covariance",
    "degree2",
    "degree2_covariance",
    "degree3",
    "degree3_covariance",
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


def degree0(*, theta: npt.ArrayLike) -> Floats:
    """What a residual adds to range, times 1, T, T^2, ..., in a filter of fading memory.

    Name: fading_memory.degree0.
    Definition: S^-1 h_0, S = sum_n theta^n h_n h_n'.
    Conditioning: no expectation is taken.
    Source: Morrison 1969.

    Args:
        theta: fading factor, the weight of a residual by that of the next [1], 0.001 to 0.9999.

    Returns:
        Shape of the broadcast arguments + (1), unit 1.

    Accuracy: at most 1.01 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 1.01.
    """
    arguments = _floats(theta)
    theta, = arguments
    result = _empty(arguments, (1,))
    result[..., 0] = 1.0 - theta
    return result


def degree0_covariance(*, theta: npt.ArrayLike) -> Floats:
    """Error covariance of range in a filter of fading memory, for errors of variance one, times powers of T.

    Name: fading_memory.degree0.covariance.
    Definition: S^-1 (sum_n theta^2n h_n h_n') S^-1.
    Conditioning: no expectation is taken.
    Source: Morrison 1969.

    Args:
        theta: fading factor, the weight of a residual by that of the next [1], 0.001 to 0.9999.

    Returns:
        Shape of the broadcast arguments + (1, 1), unit 1.

    Accuracy: at most 3.01 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 3.01.
    """
    arguments = _floats(theta)
    theta, = arguments
    result = _empty(arguments, (1, 1))
    result[..., 0, 0] = (1.0 - theta) / (1.0 + theta)
    return result


def degree1(*, theta: npt.ArrayLike) -> Floats:
    """What a residual adds to range and range rate, times 1, T, T^2, ..., in a filter of fading memory.

    Name: fading_memory.degree1.
    Definition: S^-1 h_0, S = sum_n theta^n h_n h_n'.
    Conditioning: no expectation is taken.
    Source: Morrison 1969.

    Args:
        theta: fading factor, the weight of a residual by that of the next [1], 0.001 to 0.9999.

    Returns:
        Shape of the broadcast arguments + (2), unit 1.

    Accuracy: at most 3.04 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 3.04.
    """
    arguments = _floats(theta)
    theta, = arguments
    sum_1 = 1.0 - theta
    result = _empty(arguments, (2,))
    result[..., 0] = sum_1 * (1.0 + theta)
    result[..., 1] = sum_1**2
    return result


def degree1_covariance(*, theta: npt.ArrayLike) -> Floats:
    """Error covariance of range and range rate in a filter of fading memory, for errors of variance one, times powers of T.

    Name: fading_memory.degree1.covariance.
    Definition: S^-1 (sum_n theta^2n h_n h_n') S^-1.
    Conditioning: no expectation is taken.
    Source: Morrison 1969.

    Args:
        theta: fading factor, the weight of a residual by that of the next [1], 0.001 to 0.9999.

    Returns:
        Shape of the broadcast arguments + (2, 2), unit 1.

    Accuracy: at most 15.1 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 15.1.
    """
    arguments = _floats(theta)
    theta, = arguments
    term_1 = 1.0 / ((1.0 + theta) * (1.0 + theta)**2)
    sum_1 = 1.0 - theta
    sum_2 = 1.0 + 4.0 * theta + 5.0 * theta**2
    sum_1_squared = sum_1**2
    result = _empty(arguments, (2, 2))
    result[..., 0, 0] = sum_1 * sum_2 * term_1
    result[..., 0, 1] = (1.0 + 3.0 * theta) * sum_1_squared * term_1
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = 2.0 * sum_1 * sum_1_squared * term_1
    return result


def degree2(*, theta: npt.ArrayLike) -> Floats:
    """What a residual adds to range and two derivatives, times 1, T, T^2, ..., in a filter of fading memory.

    Name: fading_memory.degree2.
    Definition: S^-1 h_0, S = sum_n theta^n h_n h_n'.
    Conditioning: no expectation is taken.
    Source: Morrison 1969.

    Args:
        theta: fading factor, the weight of a residual by that of the next [1], 0.001 to 0.9999.

    Returns:
        Shape of the broadcast arguments + (3), unit 1.

    Accuracy: at most 7.01 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 7.01.
    """
    arguments = _floats(theta)
    theta, = arguments
    sum_1 = 1.0 - theta
    sum_1_squared = sum_1**2
    result = _empty(arguments, (3,))
    result[..., 0] = sum_1 * (1.0 + theta + theta**2)
    result[..., 1] = 1.5 * sum_1_squared * (1.0 + theta)
    result[..., 2] = sum_1 * sum_1_squared
    return result


def degree2_covariance(*, theta: npt.ArrayLike) -> Floats:
    """Error covariance of range and two derivatives in a filter of fading memory, for errors of variance one, times powers of T.

    Name: fading_memory.degree2.covariance.
    Definition: S^-1 (sum_n theta^2n h_n h_n') S^-1.
    Conditioning: no expectation is taken.
    Source: Morrison 1969.

    Args:
        theta: fading factor, the weight of a residual by that of the next [1], 0.001 to 0.9999.

    Returns:
        Shape of the broadcast arguments + (3, 3), unit 1.

    Accuracy: at most 27.1 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 27.1.
    """
    arguments = _floats(theta)
    theta, = arguments
    term_1 = 1.0 / ((1.0 + theta) * ((1.0 + theta)**2)**2)
    sum_1 = 1.0 - theta
    theta_squared = theta**2
    sum_2 = 1.0 + 16.0 * theta_squared + 19.0 * theta_squared**2 + 24.0 * theta * theta_squared + 6.0 * theta
    sum_1_squared = sum_1**2
    sum_3 = 1.0 + 2.0 * theta
    sum_4 = 1.0 + 4.0 * theta + 7.0 * theta_squared
    product_1 = sum_1 * sum_1_squared
    sum_5 = 1.0 + 10.0 * theta_squared + 5.0 * theta
    sum_6 = 13.0 + 49.0 * theta_squared + 50.0 * theta
    result = _empty(arguments, (3, 3))
    result[..., 0, 0] = sum_1 * sum_2 * term_1
    result[..., 0, 1] = 1.5 * sum_1_squared * sum_3 * sum_4 * term_1
    result[..., 0, 2] = product_1 * sum_5 * term_1
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = 0.5 * product_1 * sum_6 * term_1
    result[..., 1, 2] = 6.0 * sum_1_squared**2 * sum_3 * term_1
    result[..., 2, 0] = result[..., 0, 2]
    result[..., 2, 1] = result[..., 1, 2]
    result[..., 2, 2] = 6.0 * sum_1 * sum_1_squared**2 * term_1
    return result


def degree3(*, theta: npt.ArrayLike) -> Floats:
    """What a residual adds to range and three derivatives, times 1, T, T^2, ..., in a filter of fading memory.

    Name: fading_memory.degree3.
    Definition: S^-1 h_0, S = sum_n theta^n h_n h_n'.
    Conditioning: no expectation is taken.
    Source: Morrison 1969.

    Args:
        theta: fading factor, the weight of a residual by that of the next [1], 0.001 to 0.9999.

    Returns:
        Shape of the broadcast arguments + (4), unit 1.

    Accuracy: at most 11.1 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 11.1.
    """
    arguments = _floats(theta)
    theta, = arguments
    sum_1 = 1.0 - theta
    sum_2 = 1.0 + theta
    theta_squared = theta**2
    sum_1_squared = sum_1**2
    sum_3 = 11.0 + 11.0 * theta_squared + 14.0 * theta
    result = _empty(arguments, (4,))
    result[..., 0] = sum_1 * sum_2 * (1.0 + theta_squared)
    result[..., 1] = sum_1_squared * sum_3 / 6.0
    result[..., 2] = 2.0 * sum_1 * sum_1_squared * sum_2
    result[..., 3] = sum_1_squared**2
    return result


def degree3_covariance(*, theta: npt.ArrayLike) -> Floats:
    """Error covariance of range and three derivatives in a filter of fading memory, for errors of variance one, times powers of T.

    Name: fading_memory.degree3.covariance.
    Definition: S^-1 (sum_n theta^2n h_n h_n') S^-1.
    Conditioning: no expectation is taken.
    Source: Morrison 1969.

    Args:
        theta: fading factor, the weight of a residual by that of the next [1], 0.001 to 0.9999.

    Returns:
        Shape of the broadcast arguments + (4, 4), unit 1.

    Accuracy: at most 38.1 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 38.1.
    """
    arguments = _floats(theta)
    theta, = arguments
    term_1 = 1.0 / ((1.0 + theta) * ((1.0 + theta) * (1.0 + theta)**2)**2)
    sum_1 = 1.0 - theta
    theta_squared = theta**2
    product_1 = theta * theta_squared**2
    product_2 = theta * theta_squared
    theta_squared_squared = theta_squared**2
    sum_2 = (
        1.0
        + 104.0 * product_1
        + 29.0 * theta_squared
        + 64.0 * product_2
        + 69.0 * theta_squared * theta_squared**2
        + 8.0 * theta
        + 97.0 * theta_squared_squared
    )
    sum_1_squared = sum_1**2
    sum_3 = (
        11.0
        + 340.0 * theta_squared
        + 625.0 * product_1
        + 756.0 * product_2
        + 91.0 * theta
        + 961.0 * theta_squared_squared
    )
    product_3 = sum_1 * sum_1_squared
    sum_4 = 1.0 + 28.0 * theta_squared + 45.0 * theta_squared_squared + 56.0 * product_2 + 8.0 * theta
    sum_1_squared_squared = sum_1_squared**2
    sum_5 = 1.0 + 21.0 * theta_squared + 35.0 * product_2 + 7.0 * theta
    sum_6 = 53.0 + 298.0 * theta + 581.0 * theta_squared_squared + 762.0 * theta_squared + 970.0 * product_2
    sum_7 = 3.0 + 5.0 * theta
    sum_8 = 5.0 + 14.0 * theta + 17.0 * theta_squared
    product_4 = sum_1 * sum_1_squared**2
    sum_9 = 47.0 + 134.0 * theta + 167.0 * theta_squared
    sum_10 = 23.0 + 63.0 * theta_squared + 76.0 * theta
    result = _empty(arguments, (4, 4))
    result[..., 0, 0] = sum_1 * sum_2 * term_1
    result[..., 0, 1] = sum_1_squared * sum_3 * term_1 / 6.0
    result[..., 0, 2] = 2.0 * product_3 * sum_4 * term_1
    result[..., 0, 3] = sum_1_squared_squared * sum_5 * term_1
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = 5.0 * product_3 * sum_6 * term_1 / 18.0
    result[..., 1, 2] = 5.0 * sum_1_squared_squared * sum_7 * sum_8 * term_1 / 3.0
    result[..., 1, 3] = product_4 * sum_9 * term_1 / 3.0
    result[..., 2, 0] = result[..., 0, 2]
    result[..., 2, 1] = result[..., 1, 2]
    result[..., 2, 2] = 2.0 * product_4 * sum_10 * term_1
    result[..., 2, 3] = 10.0 * sum_1_squared * sum_1_squared**2 * sum_7 * term_1
    result[..., 3, 0] = result[..., 0, 3]
    result[..., 3, 1] = result[..., 1, 3]
    result[..., 3, 2] = result[..., 2, 3]
    result[..., 3, 3] = 20.0 * sum_1 * sum_1_squared * sum_1_squared**2 * term_1
    return result
