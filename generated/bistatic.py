"""NumPy functions of the quantities bistatic.*.

Written by radartrack regenerate, generator 1, derivation c665183dbeef7f96; not to be edited.
"""

import numpy as np
import numpy.typing as npt

__all__ = [
    "bias_averaged_fourth_order",
    "bias_averaged_second_order",
    "bias_second_order",
    "bias_truth_fourth_order",
    "bias_truth_second_order",
    "covariance_averaged_fourth_order",
    "covariance_averaged_second_order",
    "covariance_averaged_semidefinite",
    "covariance_linear",
    "covariance_second_order",
    "covariance_truth_fourth_order",
    "covariance_truth_second_order",
    "decorrelated_covariance_fourth_order",
    "decorrelated_covariance_second_order",
    "decorrelated_covariance_semidefinite",
    "hessian",
    "jacobian",
    "map",
    "posterior_covariance_fourth_order",
    "posterior_covariance_second_order",
    "posterior_covariance_semidefinite",
    "posterior_estimate_fourth_order",
    "posterior_estimate_second_order",
    "std_linear",
    "std_position",
    "unbiased_covariance_fourth_order",
    "unbiased_covariance_second_order",
    "unbiased_covariance_semidefinite",
    "unbiased_estimate_fourth_order",
    "unbiased_estimate_second_order",
    "validity_linear",
    "validity_second_order",
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


def map(*, path: npt.ArrayLike, beta: npt.ArrayLike, baseline: npt.ArrayLike) -> Floats:
    """Map from the measured quantities to coordinates.

    Name: bistatic.map.
    Definition: h.
    Conditioning: no expectation is taken.
    Source: Willis 1991 bistatic triangle.

    Args:
        path: length of the path from transmitter to target to receiver [m], 30000 to 1e+06.
        beta: azimuth at the receiver, counter-clockwise from the x axis, where the transmitter stands [rad], -3.1416 to 3.1416.
        baseline: distance from transmitter to receiver; less than the path [m], 1 to 20000.

    Returns:
        Shape of the broadcast arguments + (2), unit m.

    Accuracy: at most 2 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
    """
    arguments = _floats(path, beta, baseline)
    path, beta, baseline = arguments
    cos_beta = np.cos(beta)
    divisor_1 = 2.0 * path - 2.0 * baseline * cos_beta
    term_1 = 1.0 / divisor_1
    sum_1 = baseline + path
    sum_2 = baseline - path
    result = _empty(arguments, (2,))
    result[..., 0] = -cos_beta * sum_1 * sum_2 * term_1
    result[..., 1] = -np.sin(beta) * sum_1 * sum_2 * term_1
    return result


def jacobian(*, path: npt.ArrayLike, beta: npt.ArrayLike, baseline: npt.ArrayLike) -> Floats:
    """First derivatives of the map, [out, in].

    Name: bistatic.jacobian.
    Definition: dh/dtheta.
    Conditioning: no expectation is taken.
    Source: Prosov (6)-(7).

    Args:
        path: length of the path from transmitter to target to receiver [m], 30000 to 1e+06.
        beta: azimuth at the receiver, counter-clockwise from the x axis, where the transmitter stands [rad], -3.1416 to 3.1416.
        baseline: distance from transmitter to receiver; less than the path [m], 1 to 20000.

    Returns:
        Shape of the broadcast arguments + (2, 2), unit [m, m] × [1/m, 1/rad].

    Accuracy: at most 3 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
    """
    arguments = _floats(path, beta, baseline)
    path, beta, baseline = arguments
    cos_beta = np.cos(beta)
    divisor_1 = 2.0 * path - 2.0 * baseline * cos_beta
    sum_1 = baseline**2 - 2.0 * baseline * cos_beta * path + path**2
    term_1 = 1.0 / divisor_1**2
    sum_2 = baseline + path
    sum_3 = baseline - path
    sin_beta = np.sin(beta)
    result = _empty(arguments, (2, 2))
    result[..., 0, 0] = 2.0 * cos_beta * sum_1 * term_1
    result[..., 0, 1] = 2.0 * path * sin_beta * sum_2 * sum_3 * term_1
    result[..., 1, 0] = 2.0 * sin_beta * sum_1 * term_1
    result[..., 1, 1] = 2.0 * (baseline - cos_beta * path) * sum_2 * sum_3 * term_1
    return result


def hessian(*, path: npt.ArrayLike, beta: npt.ArrayLike, baseline: npt.ArrayLike) -> Floats:
    """Second derivatives of the map, [out, in, in].

    Name: bistatic.hessian.
    Definition: d2h/dtheta2.
    Conditioning: no expectation is taken.
    Source: Prosov (6)-(7).

    Args:
        path: length of the path from transmitter to target to receiver [m], 30000 to 1e+06.
        beta: azimuth at the receiver, counter-clockwise from the x axis, where the transmitter stands [rad], -3.1416 to 3.1416.
        baseline: distance from transmitter to receiver; less than the path [m], 1 to 20000.

    Returns:
        Shape of the broadcast arguments + (2, 2, 2), unit [m, m] × [1/m, 1/rad] × [1/m, 1/rad].

    Accuracy: at most 5.5 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
    """
    arguments = _floats(path, beta, baseline)
    path, beta, baseline = arguments
    cos_beta = np.cos(beta)
    divisor_1 = baseline * cos_beta - path
    baseline_squared = baseline**2
    term_1 = 1.0 / (divisor_1 * divisor_1**2)
    sin_beta = np.sin(beta)
    sin_beta_squared = sin_beta**2
    path_squared = path**2
    product_1 = baseline * baseline_squared
    product_2 = path * path_squared
    sum_1 = (
        baseline_squared * path
        - 3.0 * baseline * cos_beta * path_squared
        + cos_beta * product_1
        + product_2
    )
    sum_2 = baseline + path
    sum_3 = baseline - path
    cos_beta_squared = cos_beta**2
    sum_4 = cos_beta * path - 2.0 * baseline + baseline * cos_beta_squared
    sum_5 = (
        3.0 * baseline_squared * cos_beta * path
        - 2.0 * product_1
        - 3.0 * baseline * cos_beta_squared * path_squared
        + cos_beta * product_2
        + cos_beta_squared * product_1
    )
    sum_6 = 2.0 * baseline_squared - baseline * cos_beta * path - path_squared
    result = _empty(arguments, (2, 2, 2))
    result[..., 0, 0, 0] = baseline_squared * cos_beta * sin_beta_squared * term_1
    result[..., 0, 0, 1] = 0.5 * sin_beta * sum_1 * term_1
    result[..., 0, 1, 0] = result[..., 0, 0, 1]
    result[..., 0, 1, 1] = -0.5 * path * sum_2 * sum_3 * sum_4 * term_1
    result[..., 1, 0, 0] = baseline_squared * sin_beta * sin_beta_squared * term_1
    result[..., 1, 0, 1] = -0.5 * sum_5 * term_1
    result[..., 1, 1, 0] = result[..., 1, 0, 1]
    result[..., 1, 1, 1] = 0.5 * sin_beta * sum_2 * sum_3 * sum_6 * term_1
    return result


def bias_second_order(
    *,
    path: npt.ArrayLike,
    beta: npt.ArrayLike,
    baseline: npt.ArrayLike,
    sigma_path: npt.ArrayLike,
    sigma_beta: npt.ArrayLike,
    rho: npt.ArrayLike,
) -> Floats:
    """Bias of the plain conversion to second order.

    Name: bistatic.bias.second_order.
    Definition: L h.
    Conditioning: truth-conditioned: the measured symbols stand for the true values.
    Source: Prosov (7).

    Args:
        path: length of the path from transmitter to target to receiver [m], 30000 to 1e+06.
        beta: azimuth at the receiver, counter-clockwise from the x axis, where the transmitter stands [rad], -3.1416 to 3.1416.
        baseline: distance from transmitter to receiver; less than the path [m], 1 to 20000.
        sigma_path: standard deviation of the error of path [m], 0.001 to 1000.
        sigma_beta: standard deviation of the error of beta [rad], 1e-09 to 0.1.
        rho: correlation of the errors of path and beta [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (2), unit m.

    Accuracy: at most 5.5 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
    """
    arguments = _floats(path, beta, baseline, sigma_path, sigma_beta, rho)
    path, beta, baseline, sigma_path, sigma_beta, rho = arguments
    cos_beta = np.cos(beta)
    divisor_1 = baseline * cos_beta - path
    sum_1 = baseline + path
    sum_2 = baseline - path
    cos_beta_squared = cos_beta**2
    sigma_beta_squared = sigma_beta**2
    sum_3 = cos_beta * path - 2.0 * baseline + baseline * cos_beta_squared
    baseline_squared = baseline**2
    sigma_path_squared = sigma_path**2
    sin_beta = np.sin(beta)
    sin_beta_squared = sin_beta**2
    path_squared = path**2
    product_1 = baseline * baseline_squared
    product_2 = path * path_squared
    sum_4 = (
        baseline_squared * path
        - 3.0 * baseline * cos_beta * path_squared
        + cos_beta * product_1
        + product_2
    )
    term_1 = 1.0 / (divisor_1 * divisor_1**2)
    sum_5 = (
        0.5 * baseline_squared * cos_beta * sigma_path_squared * sin_beta_squared
        - 0.25 * path * sigma_beta_squared * sum_1 * sum_2 * sum_3
        + 0.5 * rho * sigma_beta * sigma_path * sin_beta * sum_4
    )
    sum_6 = (
        3.0 * baseline_squared * cos_beta * path
        - 2.0 * product_1
        - 3.0 * baseline * cos_beta_squared * path_squared
        + cos_beta * product_2
        + cos_beta_squared * product_1
    )
    sum_7 = 2.0 * baseline_squared - baseline * cos_beta * path - path_squared
    sum_8 = (
        0.5 * baseline_squared * sigma_path_squared * sin_beta * sin_beta_squared
        - 0.5 * rho * sigma_beta * sigma_path * sum_6
        + 0.25 * sigma_beta_squared * sin_beta * sum_1 * sum_2 * sum_7
    )
    result = _empty(arguments, (2,))
    result[..., 0] = sum_5 * term_1
    result[..., 1] = sum_8 * term_1
    return result


def covariance_linear(
    *,
    path: npt.ArrayLike,
    beta: npt.ArrayLike,
    baseline: npt.ArrayLike,
    sigma_path: npt.ArrayLike,
    sigma_beta: npt.ArrayLike,
    rho: npt.ArrayLike,
) -> Floats:
    """Covariance of the linearised conversion.

    Name: bistatic.covariance.linear.
    Definition: J K J'.
    Conditioning: truth-conditioned: the measured symbols stand for the true values.
    Source: Prosov (9); Gao et al. 2020 (1), doi:10.12126/see.2020.02.013.

    Args:
        path: length of the path from transmitter to target to receiver [m], 30000 to 1e+06.
        beta: azimuth at the receiver, counter-clockwise from the x axis, where the transmitter stands [rad], -3.1416 to 3.1416.
        baseline: distance from transmitter to receiver; less than the path [m], 1 to 20000.
        sigma_path: standard deviation of the error of path [m], 0.001 to 1000.
        sigma_beta: standard deviation of the error of beta [rad], 1e-09 to 0.1.
        rho: correlation of the errors of path and beta [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (2, 2), unit m^2.

    Accuracy: at most 9 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
    """
    arguments = _floats(path, beta, baseline, sigma_path, sigma_beta, rho)
    path, beta, baseline, sigma_path, sigma_beta, rho = arguments
    cos_beta = np.cos(beta)
    divisor_1 = 2.0 * path - 2.0 * baseline * cos_beta
    sum_1 = baseline + path
    sum_1_squared = sum_1**2
    sum_2 = baseline - path
    sum_2_squared = sum_2**2
    path_squared = path**2
    sigma_beta_squared = sigma_beta**2
    sin_beta = np.sin(beta)
    sin_beta_squared = sin_beta**2
    baseline_squared = baseline**2
    sum_3 = baseline_squared - 2.0 * baseline * cos_beta * path + path_squared
    sum_3_squared = sum_3**2
    cos_beta_squared = cos_beta**2
    sigma_path_squared = sigma_path**2
    term_1 = 1.0 / (divisor_1**2)**2
    sum_4 = (
        4.0 * cos_beta_squared * sigma_path_squared * sum_3_squared
        + 4.0 * path_squared * sigma_beta_squared * sin_beta_squared * sum_1_squared * sum_2_squared
        + 8.0 * cos_beta * path * rho * sigma_beta * sigma_path * sin_beta * sum_1 * sum_2 * sum_3
    )
    sum_5 = baseline - cos_beta * path
    sum_6 = baseline * cos_beta - 2.0 * cos_beta_squared * path + path
    sum_7 = (
        4.0 * cos_beta * sigma_path_squared * sin_beta * sum_3_squared
        + 4.0 * path * sigma_beta_squared * sin_beta * sum_1_squared * sum_2_squared * sum_5
        + 4.0 * rho * sigma_beta * sigma_path * sum_1 * sum_2 * sum_3 * sum_6
    )
    sum_8 = (
        6.0 * baseline_squared * path_squared
        - 4.0 * baseline * baseline_squared * cos_beta * path
        - 4.0 * baseline_squared * path_squared * sin_beta_squared
        - 4.0 * baseline * cos_beta * path * path_squared
        + baseline_squared**2
        + path_squared**2
    )
    sum_9 = (
        4.0 * sigma_beta_squared * sum_1_squared * sum_2_squared * sum_5**2
        + 4.0 * sigma_path_squared * sin_beta_squared * sum_8
        + 8.0 * rho * sigma_beta * sigma_path * sin_beta * sum_1 * sum_2 * sum_3 * sum_5
    )
    result = _empty(arguments, (2, 2))
    result[..., 0, 0] = sum_4 * term_1
    result[..., 0, 1] = sum_7 * term_1
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = sum_9 * term_1
    return result


def covariance_second_order(
    *,
    path: npt.ArrayLike,
    beta: npt.ArrayLike,
    baseline: npt.ArrayLike,
    sigma_path: npt.ArrayLike,
    sigma_beta: npt.ArrayLike,
    rho: npt.ArrayLike,
) -> Floats:
    """Covariance of the conversion's quadratic Taylor polynomial.

    Name: bistatic.covariance.second_order.
    Definition: J K J' + tr(G_a K G_b K)/2.
    Conditioning: truth-conditioned: the measured symbols stand for the true values.
    Source: Bar-Shalom & Li 1995.

    Args:
        path: length of the path from transmitter to target to receiver [m], 30000 to 1e+06.
        beta: azimuth at the receiver, counter-clockwise from the x axis, where the transmitter stands [rad], -3.1416 to 3.1416.
        baseline: distance from transmitter to receiver; less than the path [m], 1 to 20000.
        sigma_path: standard deviation of the error of path [m], 0.001 to 1000.
        sigma_beta: standard deviation of the error of beta [rad], 1e-09 to 0.1.
        rho: correlation of the errors of path and beta [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (2, 2), unit m^2.

    Accuracy: at most 12.5 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
    """
    arguments = _floats(path, beta, baseline, sigma_path, sigma_beta, rho)
    path, beta, baseline, sigma_path, sigma_beta, rho = arguments
    cos_beta = np.cos(beta)
    divisor_1 = 2.0 * path - 2.0 * baseline * cos_beta
    product_1 = baseline * cos_beta
    divisor_2 = product_1 - path
    baseline_squared = baseline**2
    path_squared = path**2
    sin_beta = np.sin(beta)
    sin_beta_squared = sin_beta**2
    product_2 = -3.0 * baseline * path_squared * sin_beta_squared
    product_3 = baseline * baseline_squared
    product_4 = path * path_squared
    product_5 = -cos_beta * product_4
    product_6 = 3.0 * baseline * path_squared
    product_7 = product_3 * sin_beta_squared
    sigma_path_squared = sigma_path**2
    product_8 = sigma_path * sigma_path_squared
    product_9 = sin_beta * sin_beta_squared
    sum_1 = product_2 - baseline_squared * cos_beta * path - product_3 + product_5 + product_6 + product_7
    sum_2 = baseline + path
    sum_2_squared = sum_2**2
    sum_3 = baseline - path
    sum_3_squared = sum_3**2
    sigma_beta_squared = sigma_beta**2
    sum_4 = (
        2.0 * baseline * cos_beta * path
        - baseline_squared
        - path_squared
        + baseline_squared * sin_beta_squared
    )
    path_squared_squared = path_squared**2
    product_10 = baseline * baseline_squared**2
    baseline_squared_squared = baseline_squared**2
    baseline_squared_cubed = baseline_squared * baseline_squared**2
    path_squared_cubed = path_squared * path_squared**2
    product_11 = path * path_squared**2
    product_12 = 6.0 * baseline * cos_beta * product_11
    product_13 = baseline_squared_cubed * sin_beta_squared
    rho_squared = rho**2
    sum_5 = (
        11.0 * baseline_squared * path_squared_squared * sin_beta_squared
        - 13.0 * baseline_squared * path_squared_squared
        - 2.0 * cos_beta * path * product_10 * sin_beta_squared
        - 4.0 * cos_beta * path * product_10
        - 8.0 * baseline_squared_squared * path_squared * sin_beta_squared
        - baseline_squared_cubed
        - path_squared_cubed
        + 2.0 * cos_beta * product_3 * product_4 * sin_beta_squared
        + 6.0 * cos_beta * product_3 * product_4
        + 7.0 * baseline_squared_squared * path_squared
        + product_12
        + product_13
    )
    sum_6 = (
        4.0 * cos_beta * product_3 * product_4
        - 11.0 * baseline_squared * path_squared_squared
        - 2.0 * cos_beta * path * product_10
        - 6.0 * baseline_squared_squared * path_squared * sin_beta_squared
        - baseline_squared_cubed
        - path_squared_cubed
        + 5.0 * baseline_squared_squared * path_squared
        + 9.0 * baseline_squared * path_squared_squared * sin_beta_squared
        + product_12
        + product_13
    )
    sigma_path_squared_squared = sigma_path_squared**2
    sin_beta_squared_squared = sin_beta_squared**2
    product_14 = cos_beta * product_3
    sum_7 = baseline_squared * path - 3.0 * baseline * cos_beta * path_squared + product_14 + product_4
    cos_beta_squared = cos_beta**2
    sum_8 = cos_beta * path - 2.0 * baseline + baseline * cos_beta_squared
    product_15 = sigma_beta * sigma_beta_squared
    sigma_beta_squared_squared = sigma_beta_squared**2
    sum_9 = baseline_squared - 2.0 * baseline * cos_beta * path + path_squared
    sum_9_squared = sum_9**2
    sum_10 = divisor_2
    sum_10_squared = sum_10**2
    term_1 = 1.0 / (divisor_1**2)**2
    term_2 = 1.0 / divisor_2**2
    sum_11 = (
        2.0 * path_squared * sigma_beta_squared_squared * sum_2_squared * sum_3_squared * sum_8**2
        - 16.0 * baseline_squared * product_8 * product_9 * rho * sigma_beta * sum_1
        - 4.0 * path_squared * sigma_beta_squared * sin_beta_squared * sum_2_squared * sum_3_squared * sum_4
        - 4.0 * rho_squared * sigma_beta_squared * sigma_path_squared * sin_beta_squared * sum_5
        - 4.0 * sigma_beta_squared * sigma_path_squared * sin_beta_squared * sum_6
        - 8.0 * baseline_squared_squared * sigma_path_squared_squared * (1.0 + sin_beta) * (sin_beta - 1.0) * sin_beta_squared_squared
        - 8.0 * path * product_15 * rho * sigma_path * sin_beta * sum_2 * sum_3 * sum_7 * sum_8
        + 4.0 * cos_beta_squared * sigma_path_squared * sum_10_squared * sum_9_squared
        + 8.0 * cos_beta * path * rho * sigma_beta * sigma_path * sin_beta * sum_10_squared * sum_2 * sum_3 * sum_9
    )
    product_16 = cos_beta * cos_beta_squared
    cos_beta_squared_squared = cos_beta_squared**2
    sum_12 = (
        11.0 * baseline_squared * path_squared_squared * product_16
        - 10.0 * baseline_squared_squared * path_squared * product_16
        - 14.0 * cos_beta_squared * product_3 * product_4
        - 2.0 * cos_beta_squared_squared * path * product_10
        - 4.0 * baseline_squared_cubed * cos_beta
        - 4.0 * path * product_10
        - 6.0 * baseline * cos_beta_squared * product_11
        + 13.0 * baseline_squared_squared * cos_beta * path_squared
        + 2.0 * baseline_squared * cos_beta * path_squared_squared
        + 2.0 * cos_beta_squared_squared * product_3 * product_4
        + 3.0 * baseline_squared_cubed * product_16
        + 8.0 * cos_beta_squared * path * product_10
        + cos_beta * path_squared_cubed
    )
    product_17 = cos_beta * product_4
    sum_13 = (
        3.0 * baseline_squared * cos_beta * path
        - 2.0 * product_3
        - 3.0 * baseline * cos_beta_squared * path_squared
        + cos_beta_squared * product_3
        + product_17
    )
    product_18 = -3.0 * baseline_squared * cos_beta * path
    sum_14 = (
        2.0 * product_3
        - 2.0 * baseline * path_squared * sin_beta_squared
        - baseline_squared * cos_beta * path * sin_beta_squared
        + 2.0 * product_3 * sin_beta_squared
        + product_17
        + product_18
    )
    sum_15 = baseline - cos_beta * path
    sum_16 = (
        2.0 * baseline_squared_squared * path * sin_beta_squared_squared
        - 12.0 * cos_beta * path_squared * product_3 * sin_beta_squared
        - 2.0 * product_11 * sin_beta_squared
        - 4.0 * cos_beta * path_squared * product_3
        - 4.0 * baseline * cos_beta * path_squared_squared
        - 6.0 * baseline_squared * product_4 * sin_beta_squared_squared
        + 2.0 * cos_beta * product_10 * sin_beta_squared
        + 3.0 * baseline_squared_squared * path * sin_beta_squared
        + 4.0 * baseline * cos_beta * path_squared_squared * sin_beta_squared
        + 6.0 * baseline_squared * product_4
        + baseline_squared * product_4 * sin_beta_squared
        + baseline_squared_squared * path
        + product_11
    )
    sum_17 = path - 2.0 * cos_beta_squared * path + product_1
    sum_18 = (
        2.0 * cos_beta * product_3 * sin_beta_squared
        - 3.0 * baseline_squared * path
        - 6.0 * baseline * cos_beta * path_squared * sin_beta_squared
        - product_4
        + 2.0 * product_4 * sin_beta_squared
        + 3.0 * baseline * cos_beta * path_squared
        + 4.0 * baseline_squared * path * sin_beta_squared
        + product_14
    )
    sum_19 = (
        2.0 * path * sigma_beta_squared_squared * sin_beta * sum_14 * sum_2_squared * sum_3_squared
        - 4.0 * rho_squared * sigma_beta_squared * sigma_path_squared * sin_beta * sum_12
        - 4.0 * sigma_beta_squared * sigma_path_squared * sin_beta * sum_13 * sum_7
        + 4.0 * cos_beta * sigma_path_squared * sin_beta * sum_10_squared * sum_9_squared
        + 4.0 * product_15 * rho * sigma_path * sum_16 * sum_2 * sum_3
        + 4.0 * path * sigma_beta_squared * sin_beta * sum_10_squared * sum_15 * sum_2_squared * sum_3_squared
        + 4.0 * rho * sigma_beta * sigma_path * sum_10_squared * sum_17 * sum_2 * sum_3 * sum_9
        + 8.0 * baseline_squared * product_8 * rho * sigma_beta * sin_beta_squared * sum_18
        + 8.0 * baseline_squared_squared * cos_beta * sigma_path_squared_squared * sin_beta * sin_beta_squared**2
    )
    sum_20 = (
        13.0 * baseline_squared * path_squared_squared * sin_beta_squared
        - 12.0 * cos_beta * product_3 * product_4 * sin_beta_squared
        - 15.0 * baseline_squared * path_squared_squared
        - 15.0 * baseline_squared_squared * path_squared
        - 4.0 * baseline_squared_squared * path_squared * sin_beta_squared_squared
        - 4.0 * cos_beta * path * product_10 * sin_beta_squared
        - baseline_squared_cubed
        - path_squared_cubed
        + 18.0 * baseline_squared_squared * path_squared * sin_beta_squared
        + 20.0 * cos_beta * product_3 * product_4
        + 6.0 * cos_beta * path * product_10
        + product_12
        + product_13
    )
    sum_21 = 2.0 * baseline_squared - baseline * cos_beta * path - path_squared
    sum_22 = product_18 + product_2 + product_3 + product_5 + product_6 + product_7
    sum_23 = (
        2.0 * baseline * cos_beta * product_4
        - 3.0 * baseline_squared * path_squared
        - 4.0 * cos_beta * path * product_3
        - baseline_squared * path_squared * sin_beta_squared
        + 4.0 * baseline_squared_squared
        + path_squared_squared
    )
    product_19 = cos_beta * cos_beta_squared**2
    sum_24 = (
        10.0 * path * product_10 * product_16
        - 12.0 * baseline_squared_cubed * cos_beta_squared
        - 12.0 * baseline_squared_squared * cos_beta_squared_squared * path_squared
        - 14.0 * cos_beta * path * product_10
        - 2.0 * cos_beta * product_3 * product_4
        - 2.0 * path * product_10 * product_19
        - 20.0 * product_16 * product_3 * product_4
        - 6.0 * baseline_squared_squared * path_squared
        - 6.0 * baseline * product_11 * product_16
        + 11.0 * baseline_squared * cos_beta_squared_squared * path_squared_squared
        + 2.0 * baseline_squared * cos_beta_squared * path_squared_squared
        + 2.0 * baseline_squared * path_squared_squared
        + 2.0 * product_19 * product_3 * product_4
        + 33.0 * baseline_squared_squared * cos_beta_squared * path_squared
        + 5.0 * baseline_squared_cubed * cos_beta_squared_squared
        + 8.0 * baseline_squared_cubed
        + cos_beta_squared * path_squared_cubed
    )
    sum_25 = (
        16.0 * baseline_squared * product_8 * product_9 * rho * sigma_beta * sum_22
        - 4.0 * sigma_path_squared * sin_beta_squared * sum_20
        - 8.0 * product_15 * rho * sigma_path * sin_beta * sum_13 * sum_2 * sum_21 * sum_3
        + 2.0 * sigma_beta_squared_squared * sin_beta_squared * sum_23 * sum_2_squared * sum_3_squared
        + 4.0 * rho_squared * sigma_beta_squared * sigma_path_squared * sum_24
        + 4.0 * sigma_beta_squared * sigma_path_squared * sum_13**2
        + 4.0 * sigma_beta_squared * sum_10_squared * sum_15**2 * sum_2_squared * sum_3_squared
        + 8.0 * baseline_squared_squared * sigma_path_squared_squared * sin_beta_squared * sin_beta_squared**2
        + 8.0 * rho * sigma_beta * sigma_path * sin_beta * sum_10_squared * sum_15 * sum_2 * sum_3 * sum_9
    )
    result = _empty(arguments, (2, 2))
    result[..., 0, 0] = sum_11 * term_1 * term_2
    result[..., 0, 1] = sum_19 * term_1 * term_2
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = sum_25 * term_1 * term_2
    return result


def std_linear(
    *,
    path: npt.ArrayLike,
    beta: npt.ArrayLike,
    baseline: npt.ArrayLike,
    sigma_path: npt.ArrayLike,
    sigma_beta: npt.ArrayLike,
    rho: npt.ArrayLike,
) -> Floats:
    """Standard deviation of each coordinate of the linearised conversion.

    Name: bistatic.std.linear.
    Definition: sqrt((J K J')_aa).
    Conditioning: truth-conditioned: the measured symbols stand for the true values.
    Source: Gao et al. 2020 (1), doi:10.12126/see.2020.02.013.

    Args:
        path: length of the path from transmitter to target to receiver [m], 30000 to 1e+06.
        beta: azimuth at the receiver, counter-clockwise from the x axis, where the transmitter stands [rad], -3.1416 to 3.1416.
        baseline: distance from transmitter to receiver; less than the path [m], 1 to 20000.
        sigma_path: standard deviation of the error of path [m], 0.001 to 1000.
        sigma_beta: standard deviation of the error of beta [rad], 1e-09 to 0.1.
        rho: correlation of the errors of path and beta [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (2), unit m.

    Accuracy: at most 3.5 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
    """
    arguments = _floats(path, beta, baseline, sigma_path, sigma_beta, rho)
    path, beta, baseline, sigma_path, sigma_beta, rho = arguments
    cos_beta = np.cos(beta)
    divisor_1 = 2.0 * path - 2.0 * baseline * cos_beta
    term_1 = 1.0 / divisor_1**2
    sum_1 = baseline + path
    sum_1_squared = sum_1**2
    sum_2 = baseline - path
    sum_2_squared = sum_2**2
    path_squared = path**2
    sigma_beta_squared = sigma_beta**2
    sin_beta = np.sin(beta)
    sin_beta_squared = sin_beta**2
    baseline_squared = baseline**2
    sum_3 = baseline_squared - 2.0 * baseline * cos_beta * path + path_squared
    sigma_path_squared = sigma_path**2
    sum_4 = baseline - cos_beta * path
    sum_5 = (
        6.0 * baseline_squared * path_squared
        - 4.0 * baseline * baseline_squared * cos_beta * path
        - 4.0 * baseline_squared * path_squared * sin_beta_squared
        - 4.0 * baseline * cos_beta * path * path_squared
        + baseline_squared**2
        + path_squared**2
    )
    result = _empty(arguments, (2,))
    result[..., 0] = np.sqrt(4.0 * cos_beta**2 * sigma_path_squared * sum_3**2 + 4.0 * path_squared * sigma_beta_squared * sin_beta_squared * sum_1_squared * sum_2_squared + 8.0 * cos_beta * path * rho * sigma_beta * sigma_path * sin_beta * sum_1 * sum_2 * sum_3) * term_1
    result[..., 1] = np.sqrt(4.0 * sigma_beta_squared * sum_1_squared * sum_2_squared * sum_4**2 + 4.0 * sigma_path_squared * sin_beta_squared * sum_5 + 8.0 * rho * sigma_beta * sigma_path * sin_beta * sum_1 * sum_2 * sum_3 * sum_4) * term_1
    return result


def std_position(
    *,
    path: npt.ArrayLike,
    beta: npt.ArrayLike,
    baseline: npt.ArrayLike,
    sigma_path: npt.ArrayLike,
    sigma_beta: npt.ArrayLike,
    rho: npt.ArrayLike,
) -> Floats:
    """Root mean square of the coordinates' standard deviations, linearised.

    Name: bistatic.std.position.
    Definition: sqrt(tr(J K J')/n).
    Conditioning: truth-conditioned: the measured symbols stand for the true values.
    Source: Gao et al. 2020 (2), doi:10.12126/see.2020.02.013.

    Args:
        path: length of the path from transmitter to target to receiver [m], 30000 to 1e+06.
        beta: azimuth at the receiver, counter-clockwise from the x axis, where the transmitter stands [rad], -3.1416 to 3.1416.
        baseline: distance from transmitter to receiver; less than the path [m], 1 to 20000.
        sigma_path: standard deviation of the error of path [m], 0.001 to 1000.
        sigma_beta: standard deviation of the error of beta [rad], 1e-09 to 0.1.
        rho: correlation of the errors of path and beta [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments, unit m.

    Accuracy: at most 4.5 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
    """
    arguments = _floats(path, beta, baseline, sigma_path, sigma_beta, rho)
    path, beta, baseline, sigma_path, sigma_beta, rho = arguments
    cos_beta = np.cos(beta)
    divisor_1 = 2.0 * path - 2.0 * baseline * cos_beta
    sum_1 = baseline + path
    sum_1_squared = sum_1**2
    sum_2 = baseline - path
    sum_2_squared = sum_2**2
    path_squared = path**2
    sigma_beta_squared = sigma_beta**2
    sin_beta = np.sin(beta)
    sin_beta_squared = sin_beta**2
    baseline_squared = baseline**2
    sum_3 = baseline_squared - 2.0 * baseline * cos_beta * path + path_squared
    sigma_path_squared = sigma_path**2
    term_1 = 1.0 / (divisor_1**2)**2
    sum_4 = (
        4.0 * cos_beta**2 * sigma_path_squared * sum_3**2
        + 4.0 * path_squared * sigma_beta_squared * sin_beta_squared * sum_1_squared * sum_2_squared
        + 8.0 * cos_beta * path * rho * sigma_beta * sigma_path * sin_beta * sum_1 * sum_2 * sum_3
    )
    sum_5 = baseline - cos_beta * path
    sum_6 = (
        6.0 * baseline_squared * path_squared
        - 4.0 * baseline * baseline_squared * cos_beta * path
        - 4.0 * baseline_squared * path_squared * sin_beta_squared
        - 4.0 * baseline * cos_beta * path * path_squared
        + baseline_squared**2
        + path_squared**2
    )
    sum_7 = (
        4.0 * sigma_beta_squared * sum_1_squared * sum_2_squared * sum_5**2
        + 4.0 * sigma_path_squared * sin_beta_squared * sum_6
        + 8.0 * rho * sigma_beta * sigma_path * sin_beta * sum_1 * sum_2 * sum_3 * sum_5
    )
    result = _empty(arguments, ())
    result[...] = np.sqrt(0.5 * sum_4 * term_1 + 0.5 * sum_7 * term_1)
    return result[()]


def validity_linear(
    *,
    path: npt.ArrayLike,
    beta: npt.ArrayLike,
    baseline: npt.ArrayLike,
    sigma_path: npt.ArrayLike,
    sigma_beta: npt.ArrayLike,
    rho: npt.ArrayLike,
) -> Floats:
    """Leading term that the linear formulas neglect, root mean square, over the linear standard deviation, one a measured quantity.

    Name: bistatic.validity.linear.
    Definition: sqrt(E[(J^-1 (w.d)^2 h)_i^2])/(2 sigma_i).
    Conditioning: truth-conditioned: the measured symbols stand for the true values.
    Source: Prosov the question of validity.

    Args:
        path: length of the path from transmitter to target to receiver [m], 30000 to 1e+06.
        beta: azimuth at the receiver, counter-clockwise from the x axis, where the transmitter stands [rad], -3.1416 to 3.1416.
        baseline: distance from transmitter to receiver; less than the path [m], 1 to 20000.
        sigma_path: standard deviation of the error of path [m], 0.001 to 1000.
        sigma_beta: standard deviation of the error of beta [rad], 1e-09 to 0.1.
        rho: correlation of the errors of path and beta [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (2), unit 1.

    Accuracy: at most 3.5 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
    """
    arguments = _floats(path, beta, baseline, sigma_path, sigma_beta, rho)
    path, beta, baseline, sigma_path, sigma_beta, rho = arguments
    cos_beta = np.cos(beta)
    divisor_1 = 2.0 * path - 2.0 * baseline * cos_beta
    complement_of_rho = np.sqrt((1.0 - rho) * (1.0 + rho))
    baseline_squared = baseline**2
    path_squared = path**2
    sum_1 = baseline_squared - 2.0 * baseline * cos_beta * path + path_squared
    term_1 = 1.0 / divisor_1
    sigma_path_squared = sigma_path**2
    sin_beta = np.sin(beta)
    product_1 = -2.0 * baseline_squared * sigma_path_squared * sin_beta**2 * term_1
    sum_2 = baseline + path
    sum_3 = baseline - path
    product_2 = -2.0 * baseline * rho * sigma_beta * sigma_path * sin_beta * sum_2 * sum_3 * term_1
    complement_of_rho_squared = complement_of_rho**2
    sigma_beta_squared = sigma_beta**2
    product_3 = 0.5 * path * rho**2 * sigma_beta_squared * sum_2 * sum_3
    sum_1_squared = sum_1**2
    result = _empty(arguments, (2,))
    result[..., 0] = np.sqrt((0.5 * complement_of_rho_squared * path * sigma_beta_squared * sum_2 * sum_3 + product_1 + product_2 + product_3)**2 + 2.0 * (product_1 + product_2 + product_3)**2 + 0.5 * complement_of_rho_squared**2 * path_squared * sigma_beta_squared**2 * sum_2**2 * sum_3**2 + (path * rho * sigma_beta * sum_2 * sum_3 - 2.0 * baseline * sigma_path * sin_beta * sum_2 * sum_3 * term_1)**2 * complement_of_rho_squared * sigma_beta_squared) / (np.abs(sum_1) * sigma_path)
    result[..., 1] = np.sqrt(3.0 * (-2.0 * baseline * sigma_beta * sin_beta * sum_1 * sum_2 * sum_3 * term_1 - 2.0 * rho * sigma_path * sum_1_squared * term_1)**2 * sigma_beta_squared + 4.0 * complement_of_rho_squared * sigma_beta_squared * sigma_path_squared * sum_1_squared**2 / divisor_1**2) / (np.abs(2.0 * baseline * cos_beta * path * path_squared - 2.0 * baseline * baseline_squared * cos_beta * path - path_squared**2 + baseline_squared**2) * sigma_beta)
    return result


def validity_second_order(
    *,
    path: npt.ArrayLike,
    beta: npt.ArrayLike,
    baseline: npt.ArrayLike,
    sigma_path: npt.ArrayLike,
    sigma_beta: npt.ArrayLike,
    rho: npt.ArrayLike,
) -> Floats:
    """Leading term that the second-order formulas neglect, root mean square, over the linear standard deviation, one a measured quantity.

    Name: bistatic.validity.second_order.
    Definition: sqrt(E[(J^-1 (w.d)^3 h)_i^2])/(6 sigma_i).
    Conditioning: truth-conditioned: the measured symbols stand for the true values.
    Source: Prosov the question of validity.

    Args:
        path: length of the path from transmitter to target to receiver [m], 30000 to 1e+06.
        beta: azimuth at the receiver, counter-clockwise from the x axis, where the transmitter stands [rad], -3.1416 to 3.1416.
        baseline: distance from transmitter to receiver; less than the path [m], 1 to 20000.
        sigma_path: standard deviation of the error of path [m], 0.001 to 1000.
        sigma_beta: standard deviation of the error of beta [rad], 1e-09 to 0.1.
        rho: correlation of the errors of path and beta [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (2), unit 1.

    Accuracy: at most 3.5 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
    """
    arguments = _floats(path, beta, baseline, sigma_path, sigma_beta, rho)
    path, beta, baseline, sigma_path, sigma_beta, rho = arguments
    cos_beta = np.cos(beta)
    divisor_1 = 2.0 * path - 2.0 * baseline * cos_beta
    complement_of_rho = np.sqrt((1.0 - rho) * (1.0 + rho))
    baseline_squared = baseline**2
    path_squared = path**2
    sum_1 = baseline_squared - 2.0 * baseline * cos_beta * path + path_squared
    baseline_squared_squared = baseline_squared**2
    product_1 = path * path_squared
    cos_beta_squared = cos_beta**2
    path_squared_squared = path_squared**2
    sum_2 = (
        3.0 * baseline_squared * path_squared
        - 2.0 * baseline_squared_squared
        - 4.0 * baseline * cos_beta * product_1
        + baseline_squared * cos_beta_squared * path_squared
        + baseline_squared_squared * cos_beta_squared
        + path_squared_squared
    )
    complement_of_rho_squared = complement_of_rho**2
    term_1 = 1.0 / divisor_1**2
    sigma_beta_squared = sigma_beta**2
    term_2 = 1.0 / divisor_1
    sum_3 = baseline + path
    sum_4 = baseline - path
    rho_squared = rho**2
    product_2 = rho * rho_squared
    product_3 = sigma_beta * sigma_beta_squared
    sin_beta = np.sin(beta)
    sigma_path_squared = sigma_path**2
    product_4 = sigma_path * sigma_path_squared
    sin_beta_squared = sin_beta**2
    sum_5 = baseline - cos_beta * path
    product_5 = -3.0 * baseline * path * rho_squared * sigma_beta_squared * sin_beta * sum_3 * sum_4 * term_2
    product_6 = -4.0 * rho * sigma_beta * sigma_path * sum_2 * term_1
    product_7 = 8.0 * baseline_squared * sigma_path_squared * sin_beta * sum_5 * term_1
    complement_of_rho_squared_squared = complement_of_rho_squared**2
    sum_6 = (
        4.0 * baseline_squared * cos_beta_squared
        - 6.0 * baseline_squared
        + baseline * cos_beta * path
        + path_squared
    )
    result = _empty(arguments, (2,))
    result[..., 0] = np.sqrt((12.0 * baseline_squared * product_4 * sin_beta_squared * term_1 - 2.0 * complement_of_rho_squared * sigma_beta_squared * sigma_path * sum_2 * term_1 - 3.0 * baseline * complement_of_rho_squared * path * product_3 * rho * sin_beta * sum_3 * sum_4 * term_2 - 3.0 * baseline * path * product_2 * product_3 * sin_beta * sum_3 * sum_4 * term_2 - 6.0 * rho_squared * sigma_beta_squared * sigma_path * sum_2 * term_1 + 24.0 * baseline_squared * rho * sigma_beta * sigma_path_squared * sin_beta * sum_5 * term_1)**2 + 2.0 * (product_5 + product_6 + product_7)**2 * complement_of_rho_squared * sigma_beta_squared + 2.0 * (-2.0 * sigma_path * sum_2 * term_1 - 3.0 * baseline * path * rho * sigma_beta * sin_beta * sum_3 * sum_4 * term_2)**2 * complement_of_rho_squared_squared * sigma_beta_squared**2 + 6.0 * (4.0 * baseline_squared * product_4 * sin_beta_squared * term_1 - 2.0 * rho_squared * sigma_beta_squared * sigma_path * sum_2 * term_1 - baseline * path * product_2 * product_3 * sin_beta * sum_3 * sum_4 * term_2 + 8.0 * baseline_squared * rho * sigma_beta * sigma_path_squared * sin_beta * sum_5 * term_1)**2 + 6.0 * baseline_squared * complement_of_rho_squared * complement_of_rho_squared**2 * path_squared * sigma_beta_squared * sigma_beta_squared**2 * sin_beta_squared * sum_3**2 * sum_4**2 * term_1 + (product_5 - 3.0 * baseline * complement_of_rho_squared * path * sigma_beta_squared * sin_beta * sum_3 * sum_4 * term_2 + product_6 + product_7)**2 * complement_of_rho_squared * sigma_beta_squared) / (np.abs(sum_1) * sigma_path)
    result[..., 1] = np.sqrt(3.0 * (8.0 * baseline_squared * sigma_beta * sin_beta * sum_1 * sum_5 * term_1 + 8.0 * baseline_squared * rho * sigma_path * sin_beta_squared * sum_1 * term_1)**2 * complement_of_rho_squared * sigma_beta_squared * sigma_path_squared + 32.0 * baseline_squared_squared * complement_of_rho_squared_squared * sigma_beta_squared * sigma_path_squared**2 * sin_beta_squared**2 * sum_1**2 / (divisor_1**2)**2 + 6.0 * (4.0 * baseline_squared * rho_squared * sigma_path_squared * sin_beta_squared * sum_1 * term_1 - 2.0 * sigma_beta_squared * sum_1 * sum_3 * sum_4 * sum_6 * term_1 / 3.0 + 8.0 * baseline_squared * rho * sigma_beta * sigma_path * sin_beta * sum_1 * sum_5 * term_1)**2 * sigma_beta_squared + (12.0 * baseline_squared * rho_squared * sigma_path_squared * sin_beta_squared * sum_1 * term_1 - 2.0 * sigma_beta_squared * sum_1 * sum_3 * sum_4 * sum_6 * term_1 + 24.0 * baseline_squared * rho * sigma_beta * sigma_path * sin_beta * sum_1 * sum_5 * term_1 + 4.0 * baseline_squared * complement_of_rho_squared * sigma_path_squared * sin_beta_squared * sum_1 * term_1)**2 * sigma_beta_squared) / (np.abs(2.0 * baseline * baseline_squared * cos_beta * path - 2.0 * baseline * cos_beta * product_1 - baseline_squared_squared + path_squared_squared) * sigma_beta)
    return result


def bias_truth_second_order(
    *,
    path: npt.ArrayLike,
    beta: npt.ArrayLike,
    baseline: npt.ArrayLike,
    sigma_path: npt.ArrayLike,
    sigma_beta: npt.ArrayLike,
    rho: npt.ArrayLike,
) -> Floats:
    """Bias of the plain conversion h(z), to second order.

    Name: bistatic.bias.truth.second_order.
    Definition: (e^L - 1) h to sigma^2.
    Conditioning: truth-conditioned: the measured symbols stand for the true values.
    Source: Lerro & Bar-Shalom 1993, doi:10.1109/7.220948.

    Args:
        path: length of the path from transmitter to target to receiver [m], 30000 to 1e+06.
        beta: azimuth at the receiver, counter-clockwise from the x axis, where the transmitter stands [rad], -3.1416 to 3.1416.
        baseline: distance from transmitter to receiver; less than the path [m], 1 to 20000.
        sigma_path: standard deviation of the error of path [m], 0.001 to 1000.
        sigma_beta: standard deviation of the error of beta [rad], 1e-09 to 0.1.
        rho: correlation of the errors of path and beta [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (2), unit m.

    Accuracy: at most 5.5 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
    """
    arguments = _floats(path, beta, baseline, sigma_path, sigma_beta, rho)
    path, beta, baseline, sigma_path, sigma_beta, rho = arguments
    cos_beta = np.cos(beta)
    divisor_1 = 2.0 * path - 2.0 * baseline * cos_beta
    baseline_squared = baseline**2
    sigma_path_squared = sigma_path**2
    sin_beta = np.sin(beta)
    sin_beta_squared = sin_beta**2
    path_squared = path**2
    product_1 = baseline * baseline_squared
    product_2 = path * path_squared
    sum_1 = (
        baseline_squared * path
        - 3.0 * baseline * cos_beta * path_squared
        + cos_beta * product_1
        + product_2
    )
    sum_2 = baseline + path
    sum_3 = baseline - path
    cos_beta_squared = cos_beta**2
    sigma_beta_squared = sigma_beta**2
    sum_4 = cos_beta * path - 2.0 * baseline + baseline * cos_beta_squared
    term_1 = 1.0 / (divisor_1 * divisor_1**2)
    sum_5 = (
        2.0 * path * sigma_beta_squared * sum_2 * sum_3 * sum_4
        - 4.0 * baseline_squared * cos_beta * sigma_path_squared * sin_beta_squared
        - 4.0 * rho * sigma_beta * sigma_path * sin_beta * sum_1
    )
    sum_6 = 2.0 * baseline_squared - baseline * cos_beta * path - path_squared
    sum_7 = (
        3.0 * baseline_squared * cos_beta * path
        - 2.0 * product_1
        - 3.0 * baseline * cos_beta_squared * path_squared
        + cos_beta * product_2
        + cos_beta_squared * product_1
    )
    sum_8 = (
        4.0 * rho * sigma_beta * sigma_path * sum_7
        - 2.0 * sigma_beta_squared * sin_beta * sum_2 * sum_3 * sum_6
        - 4.0 * baseline_squared * sigma_path_squared * sin_beta * sin_beta_squared
    )
    result = _empty(arguments, (2,))
    result[..., 0] = sum_5 * term_1
    result[..., 1] = sum_8 * term_1
    return result


def bias_truth_fourth_order(
    *,
    path: npt.ArrayLike,
    beta: npt.ArrayLike,
    baseline: npt.ArrayLike,
    sigma_path: npt.ArrayLike,
    sigma_beta: npt.ArrayLike,
    rho: npt.ArrayLike,
) -> Floats:
    """Bias of the plain conversion h(z), to fourth order.

    Name: bistatic.bias.truth.fourth_order.
    Definition: (e^L - 1) h to sigma^4.
    Conditioning: truth-conditioned: the measured symbols stand for the true values.
    Source: Lerro & Bar-Shalom 1993, doi:10.1109/7.220948.

    Args:
        path: length of the path from transmitter to target to receiver [m], 30000 to 1e+06.
        beta: azimuth at the receiver, counter-clockwise from the x axis, where the transmitter stands [rad], -3.1416 to 3.1416.
        baseline: distance from transmitter to receiver; less than the path [m], 1 to 20000.
        sigma_path: standard deviation of the error of path [m], 0.001 to 1000.
        sigma_beta: standard deviation of the error of beta [rad], 1e-09 to 0.1.
        rho: correlation of the errors of path and beta [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (2), unit m.

    Accuracy: at most 5.5 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
    """
    arguments = _floats(path, beta, baseline, sigma_path, sigma_beta, rho)
    path, beta, baseline, sigma_path, sigma_beta, rho = arguments
    cos_beta = np.cos(beta)
    divisor_1 = 2.0 * path - 2.0 * baseline * cos_beta
    term_1 = (baseline * cos_beta - path)**2
    path_squared = path**2
    baseline_squared = baseline**2
    product_1 = baseline * baseline_squared
    product_2 = path * path_squared
    sin_beta = np.sin(beta)
    sum_1 = (
        baseline_squared * path
        - 3.0 * baseline * cos_beta * path_squared
        + cos_beta * product_1
        + product_2
    )
    sum_2 = baseline + path
    sum_3 = baseline - path
    cos_beta_squared = cos_beta**2
    product_3 = cos_beta * cos_beta_squared
    cos_beta_squared_squared = cos_beta_squared**2
    product_4 = cos_beta * product_2
    sigma_beta_squared = sigma_beta**2
    sigma_beta_squared_squared = sigma_beta_squared**2
    sum_4 = (
        11.0 * baseline_squared * path * product_3
        - 20.0 * baseline_squared * cos_beta * path
        - 20.0 * cos_beta_squared * product_1
        - 8.0 * baseline * path_squared
        + 11.0 * baseline * cos_beta_squared * path_squared
        + 24.0 * product_1
        + cos_beta_squared_squared * product_1
        + product_4
    )
    sigma_path_squared = sigma_path**2
    sigma_path_squared_squared = sigma_path_squared**2
    sin_beta_squared = sin_beta**2
    sum_5 = (
        13.0 * baseline * cos_beta_squared * path
        - 3.0 * baseline * cos_beta_squared_squared * path
        - 6.0 * baseline * path
        - 6.0 * baseline_squared * cos_beta
        - 9.0 * path_squared * product_3
        + 4.0 * baseline_squared * product_3
        + 7.0 * cos_beta * path_squared
    )
    rho_squared = rho**2
    sum_6 = (
        2.0 * baseline * path
        - 2.0 * baseline * path * sin_beta_squared
        - baseline_squared * cos_beta
        - cos_beta * path_squared
        + baseline_squared * cos_beta * sin_beta_squared
    )
    product_5 = sigma_path * sigma_path_squared
    sum_7 = 3.0 * cos_beta_squared * path - 3.0 * baseline * cos_beta - path + baseline * product_3
    sum_8 = cos_beta * path - 2.0 * baseline + baseline * cos_beta_squared
    baseline_squared_squared = baseline_squared**2
    path_squared_squared = path_squared**2
    product_6 = baseline * baseline_squared**2
    product_7 = path * path_squared**2
    product_8 = sigma_beta * sigma_beta_squared
    sum_9 = (
        11.0 * baseline_squared_squared * cos_beta_squared * path
        - 17.0 * baseline_squared * cos_beta_squared * product_2
        - 18.0 * baseline_squared_squared * path
        - 3.0 * path_squared * product_1 * product_3
        - 5.0 * baseline * cos_beta * path_squared_squared
        - 6.0 * cos_beta * product_6
        + 29.0 * cos_beta * path_squared * product_1
        + 7.0 * baseline_squared * product_2
        + product_3 * product_6
        + product_7
    )
    term_2 = 1.0 / (divisor_1 * (divisor_1**2)**2)
    sum_10 = (
        16.0 * baseline_squared * rho_squared * sigma_beta_squared * sigma_path_squared * sum_5
        - 16.0 * rho * sigma_beta * sigma_path * sin_beta * sum_1 * term_1
        - 2.0 * path * sigma_beta_squared_squared * sum_2 * sum_3 * sum_4
        - 48.0 * baseline_squared * cos_beta * sigma_path_squared_squared * sin_beta_squared
        + 16.0 * baseline_squared * sigma_path_squared * sin_beta_squared * sum_6
        + 48.0 * baseline_squared * product_5 * rho * sigma_beta * sin_beta * sum_7
        + 8.0 * baseline_squared * sigma_beta_squared * sigma_path_squared * sum_5
        + 8.0 * product_8 * rho * sigma_path * sin_beta * sum_9
        + 8.0 * path * sigma_beta_squared * sum_2 * sum_3 * sum_8 * term_1
    )
    sum_11 = 3.0 * baseline - 3.0 * cos_beta * path + baseline * sin_beta_squared
    product_9 = sin_beta * sin_beta_squared
    sum_12 = (
        19.0 * baseline_squared_squared * path * product_3
        - 17.0 * baseline_squared * product_2 * product_3
        - 20.0 * cos_beta_squared * product_6
        - 20.0 * path_squared * product_1
        - 3.0 * cos_beta_squared_squared * path_squared * product_1
        - 32.0 * baseline_squared_squared * cos_beta * path
        - 5.0 * baseline * cos_beta_squared * path_squared_squared
        + 21.0 * baseline_squared * cos_beta * product_2
        + 24.0 * product_6
        + 31.0 * cos_beta_squared * path_squared * product_1
        + cos_beta * product_7
        + cos_beta_squared_squared * product_6
    )
    sum_13 = 2.0 * baseline_squared - baseline * cos_beta * path - path_squared
    sum_14 = (
        2.0 * baseline * cos_beta * path
        - baseline_squared
        - path_squared
        + baseline_squared * sin_beta_squared
    )
    sum_15 = (
        3.0 * baseline_squared * cos_beta * path
        - 2.0 * product_1
        - 3.0 * baseline * cos_beta_squared * path_squared
        + cos_beta_squared * product_1
        + product_4
    )
    sum_16 = (
        20.0 * baseline_squared * path_squared
        - 11.0 * baseline_squared * cos_beta_squared * path_squared
        - 11.0 * baseline * cos_beta * product_2
        - 24.0 * baseline_squared_squared
        - path_squared_squared
        - path * product_1 * product_3
        + 20.0 * cos_beta * path * product_1
        + 8.0 * baseline_squared_squared * cos_beta_squared
    )
    sum_17 = (
        2.0 * baseline_squared * cos_beta_squared
        - 3.0 * cos_beta_squared * path_squared
        - 4.0 * baseline_squared
        - baseline * path * product_3
        + 5.0 * baseline * cos_beta * path
        + path_squared
    )
    sum_18 = (
        16.0 * baseline_squared * product_9 * sigma_path_squared * sum_14
        - 48.0 * baseline_squared * product_5 * rho * sigma_beta * sin_beta_squared * sum_11
        - 48.0 * baseline_squared * product_9 * sigma_path_squared_squared
        - 8.0 * product_8 * rho * sigma_path * sum_12
        - 8.0 * sigma_beta_squared * sin_beta * sum_13 * sum_2 * sum_3 * term_1
        + 16.0 * rho * sigma_beta * sigma_path * sum_15 * term_1
        + 2.0 * sigma_beta_squared_squared * sin_beta * sum_16 * sum_2 * sum_3
        + 24.0 * baseline_squared * sigma_beta_squared * sigma_path_squared * sin_beta * sum_17
        + 48.0 * baseline_squared * rho_squared * sigma_beta_squared * sigma_path_squared * sin_beta * sum_17
    )
    result = _empty(arguments, (2,))
    result[..., 0] = sum_10 * term_2
    result[..., 1] = sum_18 * term_2
    return result


def bias_averaged_second_order(
    *,
    path: npt.ArrayLike,
    beta: npt.ArrayLike,
    baseline: npt.ArrayLike,
    sigma_path: npt.ArrayLike,
    sigma_beta: npt.ArrayLike,
    rho: npt.ArrayLike,
) -> Floats:
    """Bias of the plain conversion, averaged over the truth, to second order.

    Name: bistatic.bias.averaged.second_order.
    Definition: (e^2L - e^L) h to sigma^2.
    Conditioning: measurement-conditioned: the measured symbols stand for the measurement.
    Source: Lerro & Bar-Shalom 1993, doi:10.1109/7.220948.

    Args:
        path: length of the path from transmitter to target to receiver [m], 30000 to 1e+06.
        beta: azimuth at the receiver, counter-clockwise from the x axis, where the transmitter stands [rad], -3.1416 to 3.1416.
        baseline: distance from transmitter to receiver; less than the path [m], 1 to 20000.
        sigma_path: standard deviation of the error of path [m], 0.001 to 1000.
        sigma_beta: standard deviation of the error of beta [rad], 1e-09 to 0.1.
        rho: correlation of the errors of path and beta [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (2), unit m.

    Accuracy: at most 5.5 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
    """
    arguments = _floats(path, beta, baseline, sigma_path, sigma_beta, rho)
    path, beta, baseline, sigma_path, sigma_beta, rho = arguments
    cos_beta = np.cos(beta)
    divisor_1 = 2.0 * path - 2.0 * baseline * cos_beta
    baseline_squared = baseline**2
    sigma_path_squared = sigma_path**2
    sin_beta = np.sin(beta)
    sin_beta_squared = sin_beta**2
    path_squared = path**2
    product_1 = baseline * baseline_squared
    product_2 = path * path_squared
    sum_1 = (
        baseline_squared * path
        - 3.0 * baseline * cos_beta * path_squared
        + cos_beta * product_1
        + product_2
    )
    sum_2 = baseline + path
    sum_3 = baseline - path
    cos_beta_squared = cos_beta**2
    sigma_beta_squared = sigma_beta**2
    sum_4 = cos_beta * path - 2.0 * baseline + baseline * cos_beta_squared
    term_1 = 1.0 / (divisor_1 * divisor_1**2)
    sum_5 = (
        2.0 * path * sigma_beta_squared * sum_2 * sum_3 * sum_4
        - 4.0 * baseline_squared * cos_beta * sigma_path_squared * sin_beta_squared
        - 4.0 * rho * sigma_beta * sigma_path * sin_beta * sum_1
    )
    sum_6 = 2.0 * baseline_squared - baseline * cos_beta * path - path_squared
    sum_7 = (
        3.0 * baseline_squared * cos_beta * path
        - 2.0 * product_1
        - 3.0 * baseline * cos_beta_squared * path_squared
        + cos_beta * product_2
        + cos_beta_squared * product_1
    )
    sum_8 = (
        4.0 * rho * sigma_beta * sigma_path * sum_7
        - 2.0 * sigma_beta_squared * sin_beta * sum_2 * sum_3 * sum_6
        - 4.0 * baseline_squared * sigma_path_squared * sin_beta * sin_beta_squared
    )
    result = _empty(arguments, (2,))
    result[..., 0] = sum_5 * term_1
    result[..., 1] = sum_8 * term_1
    return result


def bias_averaged_fourth_order(
    *,
    path: npt.ArrayLike,
    beta: npt.ArrayLike,
    baseline: npt.ArrayLike,
    sigma_path: npt.ArrayLike,
    sigma_beta: npt.ArrayLike,
    rho: npt.ArrayLike,
) -> Floats:
    """Bias of the plain conversion, averaged over the truth, to fourth order.

    Name: bistatic.bias.averaged.fourth_order.
    Definition: (e^2L - e^L) h to sigma^4.
    Conditioning: measurement-conditioned: the measured symbols stand for the measurement.
    Source: Lerro & Bar-Shalom 1993, doi:10.1109/7.220948.

    Args:
        path: length of the path from transmitter to target to receiver [m], 30000 to 1e+06.
        beta: azimuth at the receiver, counter-clockwise from the x axis, where the transmitter stands [rad], -3.1416 to 3.1416.
        baseline: distance from transmitter to receiver; less than the path [m], 1 to 20000.
        sigma_path: standard deviation of the error of path [m], 0.001 to 1000.
        sigma_beta: standard deviation of the error of beta [rad], 1e-09 to 0.1.
        rho: correlation of the errors of path and beta [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (2), unit m.

    Accuracy: at most 6 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
    """
    arguments = _floats(path, beta, baseline, sigma_path, sigma_beta, rho)
    path, beta, baseline, sigma_path, sigma_beta, rho = arguments
    cos_beta = np.cos(beta)
    divisor_1 = 2.0 * path - 2.0 * baseline * cos_beta
    baseline_squared = baseline**2
    sigma_path_squared = sigma_path**2
    sigma_path_squared_squared = sigma_path_squared**2
    sin_beta = np.sin(beta)
    sin_beta_squared = sin_beta**2
    term_1 = (baseline * cos_beta - path)**2
    path_squared = path**2
    product_1 = baseline * baseline_squared
    product_2 = path * path_squared
    sum_1 = (
        baseline_squared * path
        - 3.0 * baseline * cos_beta * path_squared
        + cos_beta * product_1
        + product_2
    )
    sum_2 = baseline + path
    sum_3 = baseline - path
    cos_beta_squared = cos_beta**2
    product_3 = cos_beta * cos_beta_squared
    cos_beta_squared_squared = cos_beta_squared**2
    product_4 = cos_beta * product_2
    sigma_beta_squared = sigma_beta**2
    sigma_beta_squared_squared = sigma_beta_squared**2
    sum_4 = (
        11.0 * baseline_squared * path * product_3
        - 20.0 * baseline_squared * cos_beta * path
        - 20.0 * cos_beta_squared * product_1
        - 8.0 * baseline * path_squared
        + 11.0 * baseline * cos_beta_squared * path_squared
        + 24.0 * product_1
        + cos_beta_squared_squared * product_1
        + product_4
    )
    product_5 = sigma_path * sigma_path_squared
    sum_5 = 3.0 * cos_beta_squared * path - 3.0 * baseline * cos_beta - path + baseline * product_3
    sum_6 = (
        2.0 * baseline * path
        - 2.0 * baseline * path * sin_beta_squared
        - baseline_squared * cos_beta
        - cos_beta * path_squared
        + baseline_squared * cos_beta * sin_beta_squared
    )
    sum_7 = (
        13.0 * baseline * cos_beta_squared * path
        - 3.0 * baseline * cos_beta_squared_squared * path
        - 6.0 * baseline * path
        - 6.0 * baseline_squared * cos_beta
        - 9.0 * path_squared * product_3
        + 4.0 * baseline_squared * product_3
        + 7.0 * cos_beta * path_squared
    )
    baseline_squared_squared = baseline_squared**2
    path_squared_squared = path_squared**2
    product_6 = baseline * baseline_squared**2
    product_7 = path * path_squared**2
    product_8 = sigma_beta * sigma_beta_squared
    sum_8 = (
        11.0 * baseline_squared_squared * cos_beta_squared * path
        - 17.0 * baseline_squared * cos_beta_squared * product_2
        - 18.0 * baseline_squared_squared * path
        - 3.0 * path_squared * product_1 * product_3
        - 5.0 * baseline * cos_beta * path_squared_squared
        - 6.0 * cos_beta * product_6
        + 29.0 * cos_beta * path_squared * product_1
        + 7.0 * baseline_squared * product_2
        + product_3 * product_6
        + product_7
    )
    rho_squared = rho**2
    sum_9 = cos_beta * path - 2.0 * baseline + baseline * cos_beta_squared
    term_2 = 1.0 / (divisor_1 * (divisor_1**2)**2)
    sum_10 = (
        144.0 * baseline_squared * product_5 * rho * sigma_beta * sin_beta * sum_5
        - 144.0 * baseline_squared * cos_beta * sigma_path_squared_squared * sin_beta_squared
        - 16.0 * rho * sigma_beta * sigma_path * sin_beta * sum_1 * term_1
        - 6.0 * path * sigma_beta_squared_squared * sum_2 * sum_3 * sum_4
        + 16.0 * baseline_squared * sigma_path_squared * sin_beta_squared * sum_6
        + 24.0 * baseline_squared * sigma_beta_squared * sigma_path_squared * sum_7
        + 24.0 * product_8 * rho * sigma_path * sin_beta * sum_8
        + 48.0 * baseline_squared * rho_squared * sigma_beta_squared * sigma_path_squared * sum_7
        + 8.0 * path * sigma_beta_squared * sum_2 * sum_3 * sum_9 * term_1
    )
    sum_11 = 3.0 * baseline - 3.0 * cos_beta * path + baseline * sin_beta_squared
    product_9 = sin_beta * sin_beta_squared
    sum_12 = (
        19.0 * baseline_squared_squared * path * product_3
        - 17.0 * baseline_squared * product_2 * product_3
        - 20.0 * cos_beta_squared * product_6
        - 20.0 * path_squared * product_1
        - 3.0 * cos_beta_squared_squared * path_squared * product_1
        - 32.0 * baseline_squared_squared * cos_beta * path
        - 5.0 * baseline * cos_beta_squared * path_squared_squared
        + 21.0 * baseline_squared * cos_beta * product_2
        + 24.0 * product_6
        + 31.0 * cos_beta_squared * path_squared * product_1
        + cos_beta * product_7
        + cos_beta_squared_squared * product_6
    )
    sum_13 = 2.0 * baseline_squared - baseline * cos_beta * path - path_squared
    sum_14 = (
        2.0 * baseline_squared * cos_beta_squared
        - 3.0 * cos_beta_squared * path_squared
        - 4.0 * baseline_squared
        - baseline * path * product_3
        + 5.0 * baseline * cos_beta * path
        + path_squared
    )
    sum_15 = (
        2.0 * baseline * cos_beta * path
        - baseline_squared
        - path_squared
        + baseline_squared * sin_beta_squared
    )
    sum_16 = (
        3.0 * baseline_squared * cos_beta * path
        - 2.0 * product_1
        - 3.0 * baseline * cos_beta_squared * path_squared
        + cos_beta_squared * product_1
        + product_4
    )
    sum_17 = (
        20.0 * baseline_squared * path_squared
        - 11.0 * baseline_squared * cos_beta_squared * path_squared
        - 11.0 * baseline * cos_beta * product_2
        - 24.0 * baseline_squared_squared
        - path_squared_squared
        - path * product_1 * product_3
        + 20.0 * cos_beta * path * product_1
        + 8.0 * baseline_squared_squared * cos_beta_squared
    )
    sum_18 = (
        144.0 * baseline_squared * rho_squared * sigma_beta_squared * sigma_path_squared * sin_beta * sum_14
        - 144.0 * baseline_squared * product_5 * rho * sigma_beta * sin_beta_squared * sum_11
        - 144.0 * baseline_squared * product_9 * sigma_path_squared_squared
        - 24.0 * product_8 * rho * sigma_path * sum_12
        - 8.0 * sigma_beta_squared * sin_beta * sum_13 * sum_2 * sum_3 * term_1
        + 16.0 * baseline_squared * product_9 * sigma_path_squared * sum_15
        + 16.0 * rho * sigma_beta * sigma_path * sum_16 * term_1
        + 6.0 * sigma_beta_squared_squared * sin_beta * sum_17 * sum_2 * sum_3
        + 72.0 * baseline_squared * sigma_beta_squared * sigma_path_squared * sin_beta * sum_14
    )
    result = _empty(arguments, (2,))
    result[..., 0] = sum_10 * term_2
    result[..., 1] = sum_18 * term_2
    return result


def covariance_truth_second_order(
    *,
    path: npt.ArrayLike,
    beta: npt.ArrayLike,
    baseline: npt.ArrayLike,
    sigma_path: npt.ArrayLike,
    sigma_beta: npt.ArrayLike,
    rho: npt.ArrayLike,
) -> Floats:
    """Covariance of the plain conversion h(z), to second order.

    Name: bistatic.covariance.truth.second_order.
    Definition: C = e^L(h h') - (e^L h)(e^L h)' to sigma^2.
    Conditioning: truth-conditioned: the measured symbols stand for the true values.
    Source: Lerro & Bar-Shalom 1993, doi:10.1109/7.220948.

    Args:
        path: length of the path from transmitter to target to receiver [m], 30000 to 1e+06.
        beta: azimuth at the receiver, counter-clockwise from the x axis, where the transmitter stands [rad], -3.1416 to 3.1416.
        baseline: distance from transmitter to receiver; less than the path [m], 1 to 20000.
        sigma_path: standard deviation of the error of path [m], 0.001 to 1000.
        sigma_beta: standard deviation of the error of beta [rad], 1e-09 to 0.1.
        rho: correlation of the errors of path and beta [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (2, 2), unit m^2.

    Accuracy: at most 9 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
    """
    arguments = _floats(path, beta, baseline, sigma_path, sigma_beta, rho)
    path, beta, baseline, sigma_path, sigma_beta, rho = arguments
    cos_beta = np.cos(beta)
    divisor_1 = 2.0 * path - 2.0 * baseline * cos_beta
    sum_1 = baseline + path
    sum_1_squared = sum_1**2
    sum_2 = baseline - path
    sum_2_squared = sum_2**2
    path_squared = path**2
    sigma_beta_squared = sigma_beta**2
    sin_beta = np.sin(beta)
    sin_beta_squared = sin_beta**2
    baseline_squared = baseline**2
    sum_3 = baseline_squared - 2.0 * baseline * cos_beta * path + path_squared
    sum_3_squared = sum_3**2
    cos_beta_squared = cos_beta**2
    sigma_path_squared = sigma_path**2
    term_1 = 1.0 / (divisor_1**2)**2
    sum_4 = (
        4.0 * cos_beta_squared * sigma_path_squared * sum_3_squared
        + 4.0 * path_squared * sigma_beta_squared * sin_beta_squared * sum_1_squared * sum_2_squared
        + 8.0 * cos_beta * path * rho * sigma_beta * sigma_path * sin_beta * sum_1 * sum_2 * sum_3
    )
    sum_5 = baseline - cos_beta * path
    sum_6 = baseline * cos_beta - 2.0 * cos_beta_squared * path + path
    sum_7 = (
        4.0 * cos_beta * sigma_path_squared * sin_beta * sum_3_squared
        + 4.0 * path * sigma_beta_squared * sin_beta * sum_1_squared * sum_2_squared * sum_5
        + 4.0 * rho * sigma_beta * sigma_path * sum_1 * sum_2 * sum_3 * sum_6
    )
    sum_8 = (
        6.0 * baseline_squared * path_squared
        - 4.0 * baseline * baseline_squared * cos_beta * path
        - 4.0 * baseline_squared * path_squared * sin_beta_squared
        - 4.0 * baseline * cos_beta * path * path_squared
        + baseline_squared**2
        + path_squared**2
    )
    sum_9 = (
        4.0 * sigma_beta_squared * sum_1_squared * sum_2_squared * sum_5**2
        + 4.0 * sigma_path_squared * sin_beta_squared * sum_8
        + 8.0 * rho * sigma_beta * sigma_path * sin_beta * sum_1 * sum_2 * sum_3 * sum_5
    )
    result = _empty(arguments, (2, 2))
    result[..., 0, 0] = sum_4 * term_1
    result[..., 0, 1] = sum_7 * term_1
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = sum_9 * term_1
    return result


def covariance_truth_fourth_order(
    *,
    path: npt.ArrayLike,
    beta: npt.ArrayLike,
    baseline: npt.ArrayLike,
    sigma_path: npt.ArrayLike,
    sigma_beta: npt.ArrayLike,
    rho: npt.ArrayLike,
) -> Floats:
    """Covariance of the plain conversion h(z), to fourth order.

    Name: bistatic.covariance.truth.fourth_order.
    Definition: C = e^L(h h') - (e^L h)(e^L h)' to sigma^4.
    Conditioning: truth-conditioned: the measured symbols stand for the true values.
    Source: Lerro & Bar-Shalom 1993, doi:10.1109/7.220948.

    Args:
        path: length of the path from transmitter to target to receiver [m], 30000 to 1e+06.
        beta: azimuth at the receiver, counter-clockwise from the x axis, where the transmitter stands [rad], -3.1416 to 3.1416.
        baseline: distance from transmitter to receiver; less than the path [m], 1 to 20000.
        sigma_path: standard deviation of the error of path [m], 0.001 to 1000.
        sigma_beta: standard deviation of the error of beta [rad], 1e-09 to 0.1.
        rho: correlation of the errors of path and beta [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (2, 2), unit m^2.

    Accuracy: at most 9.5 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
    """
    arguments = _floats(path, beta, baseline, sigma_path, sigma_beta, rho)
    path, beta, baseline, sigma_path, sigma_beta, rho = arguments
    cos_beta = np.cos(beta)
    divisor_1 = 2.0 * path - 2.0 * baseline * cos_beta
    sum_1 = baseline + path
    sum_1_squared = sum_1**2
    sum_2 = baseline - path
    sum_2_squared = sum_2**2
    baseline_squared = baseline**2
    path_squared = path**2
    sin_beta = np.sin(beta)
    sin_beta_squared = sin_beta**2
    product_1 = baseline_squared * sin_beta_squared
    sigma_beta_squared = sigma_beta**2
    sum_3 = 2.0 * baseline * cos_beta * path - baseline_squared - path_squared + product_1
    cos_beta_squared = cos_beta**2
    product_2 = cos_beta * cos_beta_squared
    product_3 = path * path_squared**2
    product_4 = -18.0 * baseline * product_2 * product_3
    product_5 = baseline * baseline_squared**2
    baseline_squared_squared = baseline_squared**2
    cos_beta_squared_squared = cos_beta_squared**2
    product_6 = baseline * baseline_squared
    product_7 = path * path_squared
    baseline_squared_cubed = baseline_squared * baseline_squared**2
    product_8 = cos_beta * cos_beta_squared**2
    product_9 = -6.0 * path * product_5 * product_8
    path_squared_squared = path_squared**2
    path_squared_cubed = path_squared * path_squared**2
    product_10 = 14.0 * product_6 * product_7 * product_8
    product_11 = 3.0 * cos_beta_squared * path_squared_cubed
    product_12 = 33.0 * baseline_squared * cos_beta_squared_squared * path_squared_squared
    product_13 = 6.0 * baseline * cos_beta * product_3
    rho_squared = rho**2
    sigma_path_squared = sigma_path**2
    sum_4 = (
        2.0 * baseline_squared * path_squared_squared
        - 22.0 * cos_beta * path * product_5
        - 40.0 * baseline_squared_squared * cos_beta_squared_squared * path_squared
        - 46.0 * product_2 * product_6 * product_7
        - 5.0 * baseline_squared_cubed * cos_beta_squared
        - 5.0 * baseline_squared_squared * path_squared
        - 9.0 * baseline_squared * cos_beta_squared * path_squared_squared
        - path_squared_cubed
        + 3.0 * baseline_squared_cubed * cos_beta_squared_squared
        + 32.0 * path * product_2 * product_5
        + 51.0 * baseline_squared_squared * cos_beta_squared * path_squared
        + 8.0 * cos_beta * product_6 * product_7
        + product_10
        + product_11
        + product_12
        + product_13
        + product_4
        + product_9
    )
    product_14 = -12.0 * baseline * product_2 * product_3
    product_15 = -2.0 * path * product_5 * product_8
    product_16 = -3.0 * baseline_squared_squared * path_squared
    product_17 = 2.0 * baseline_squared_cubed * cos_beta_squared_squared
    product_18 = 2.0 * cos_beta_squared * path_squared_cubed
    product_19 = 20.0 * baseline_squared * cos_beta_squared_squared * path_squared_squared
    product_20 = 6.0 * product_6 * product_7 * product_8
    sum_5 = (
        14.0 * path * product_2 * product_5
        - 10.0 * cos_beta * path * product_5
        - 22.0 * baseline_squared_squared * cos_beta_squared_squared * path_squared
        - 22.0 * product_2 * product_6 * product_7
        - 3.0 * baseline_squared_cubed * cos_beta_squared
        - 7.0 * baseline_squared * cos_beta_squared * path_squared_squared
        - path_squared_cubed
        + 28.0 * baseline_squared_squared * cos_beta_squared * path_squared
        + 4.0 * cos_beta * product_6 * product_7
        + product_13
        + product_14
        + product_15
        + product_16
        + product_17
        + product_18
        + product_19
        + product_20
    )
    product_21 = sigma_beta * sigma_beta_squared
    sum_6 = (
        15.0 * baseline_squared * cos_beta * path_squared
        - 11.0 * baseline_squared * path_squared * product_2
        - 2.0 * baseline * product_7
        - 7.0 * baseline * cos_beta_squared * product_7
        - 8.0 * baseline_squared_squared * cos_beta
        - 8.0 * path * product_6
        - cos_beta_squared_squared * path * product_6
        + 16.0 * cos_beta_squared * path * product_6
        + 3.0 * baseline_squared_squared * product_2
        + 3.0 * cos_beta * path_squared_squared
    )
    product_22 = sigma_path * sigma_path_squared
    sum_7 = (
        13.0 * baseline_squared * cos_beta_squared * path
        - 12.0 * baseline * path_squared * product_2
        - 4.0 * baseline_squared * path
        - 4.0 * cos_beta * product_6
        - product_7
        + 3.0 * baseline * cos_beta * path_squared
        + 4.0 * cos_beta_squared * product_7
        + product_2 * product_6
    )
    sum_8 = baseline_squared - 2.0 * baseline * cos_beta * path + path_squared
    sum_8_squared = sum_8**2
    product_23 = baseline * cos_beta
    term_1 = (product_23 - path)**2
    sigma_path_squared_squared = sigma_path_squared**2
    sum_9 = (
        6.0 * baseline * cos_beta * path
        - 3.0 * path_squared
        - 4.0 * baseline_squared
        + baseline_squared * cos_beta_squared
    )
    sigma_beta_squared_squared = sigma_beta_squared**2
    sum_10 = (
        10.0 * baseline * path * product_2
        - 12.0 * baseline * cos_beta * path
        - 18.0 * baseline_squared * cos_beta_squared
        - 2.0 * path_squared
        + 16.0 * baseline_squared
        + 3.0 * baseline_squared * cos_beta_squared_squared
        + 3.0 * cos_beta_squared * path_squared
    )
    term_2 = 1.0 / (divisor_1 * divisor_1**2)**2
    sum_11 = (
        16.0 * cos_beta_squared * sigma_path_squared * sum_8_squared * term_1
        - 16.0 * path_squared * sigma_beta_squared * sin_beta_squared * sum_1_squared * sum_2_squared * sum_3
        - 16.0 * rho_squared * sigma_beta_squared * sigma_path_squared * sum_4
        - 16.0 * sigma_beta_squared * sigma_path_squared * sum_5
        - 32.0 * path * product_21 * rho * sigma_path * sin_beta * sum_1 * sum_2 * sum_6
        - 64.0 * baseline_squared * cos_beta * product_22 * rho * sigma_beta * sin_beta * sum_7
        + 32.0 * baseline_squared * (1.0 + cos_beta) * (cos_beta - 1.0) * cos_beta_squared * sigma_path_squared_squared * sum_9
        + 32.0 * cos_beta * path * rho * sigma_beta * sigma_path * sin_beta * sum_1 * sum_2 * sum_8 * term_1
        + 8.0 * path_squared * sigma_beta_squared_squared * sum_10 * sum_1_squared * sum_2_squared
    )
    sum_12 = (
        14.0 * cos_beta_squared_squared * product_6 * product_7
        - 16.0 * baseline_squared_cubed * cos_beta
        - 16.0 * path * product_5
        - 18.0 * baseline * cos_beta_squared * product_3
        - 46.0 * cos_beta_squared * product_6 * product_7
        - 50.0 * baseline_squared_squared * path_squared * product_2
        - 6.0 * cos_beta_squared_squared * path * product_5
        + 3.0 * cos_beta * path_squared_cubed
        + 33.0 * baseline_squared * path_squared_squared * product_2
        + 35.0 * baseline_squared_squared * cos_beta * path_squared
        + 4.0 * product_6 * product_7
        + 5.0 * baseline_squared_cubed * product_2
        + 52.0 * cos_beta_squared * path * product_5
        + 6.0 * baseline_squared * cos_beta * path_squared_squared
    )
    sum_13 = (
        10.0 * baseline_squared * path_squared_squared * product_2
        - 13.0 * baseline_squared_squared * path_squared * product_2
        - 13.0 * cos_beta_squared * product_6 * product_7
        - 4.0 * baseline_squared_cubed * cos_beta
        - 4.0 * path * product_5
        - 6.0 * baseline * cos_beta_squared * product_3
        - cos_beta_squared_squared * path * product_5
        + 10.0 * baseline_squared_squared * cos_beta * path_squared
        + 13.0 * cos_beta_squared * path * product_5
        + 3.0 * baseline_squared * cos_beta * path_squared_squared
        + 3.0 * cos_beta_squared_squared * product_6 * product_7
        + baseline_squared_cubed * product_2
        + cos_beta * path_squared_cubed
    )
    sum_14 = (
        18.0 * baseline_squared * cos_beta * path
        - 10.0 * baseline * cos_beta_squared * path_squared
        - 16.0 * product_6
        - 3.0 * baseline_squared * path * product_2
        - 3.0 * cos_beta * product_7
        + 7.0 * cos_beta_squared * product_6
        + 7.0 * baseline * path_squared
    )
    sum_15 = (
        103.0 * cos_beta * path_squared * product_6
        - 12.0 * cos_beta_squared * product_3
        - 16.0 * cos_beta * product_5
        - 20.0 * baseline_squared_squared * cos_beta_squared_squared * path
        - 3.0 * baseline * cos_beta * path_squared_squared
        - 48.0 * baseline_squared_squared * path
        - 80.0 * baseline_squared * cos_beta_squared * product_7
        - 95.0 * path_squared * product_2 * product_6
        + 11.0 * product_2 * product_5
        + 2.0 * baseline_squared * product_7
        + 28.0 * baseline * path_squared_squared * product_2
        + 4.0 * path_squared * product_6 * product_8
        + 44.0 * baseline_squared * cos_beta_squared_squared * product_7
        + 6.0 * product_3
        + 76.0 * baseline_squared_squared * cos_beta_squared * path
    )
    sum_16 = baseline - cos_beta * path
    sum_17 = path - 2.0 * cos_beta_squared * path + product_23
    sum_18 = (
        10.0 * cos_beta * product_6
        - 24.0 * baseline * cos_beta * path_squared * sin_beta_squared
        - 27.0 * baseline_squared * path
        - 7.0 * product_7
        + 2.0 * cos_beta * product_6 * sin_beta_squared
        + 24.0 * baseline * cos_beta * path_squared
        + 31.0 * baseline_squared * path * sin_beta_squared
        + 8.0 * product_7 * sin_beta_squared
    )
    product_24 = sin_beta * sin_beta_squared
    sum_19 = (
        3.0 * baseline_squared * cos_beta
        - 6.0 * baseline * path
        + 3.0 * cos_beta * path_squared
        + 6.0 * baseline * path * sin_beta_squared
        + baseline_squared * cos_beta * sin_beta_squared
    )
    sum_20 = (
        16.0 * cos_beta * sigma_path_squared * sin_beta * sum_8_squared * term_1
        - 16.0 * rho_squared * sigma_beta_squared * sigma_path_squared * sin_beta * sum_12
        - 32.0 * sigma_beta_squared * sigma_path_squared * sin_beta * sum_13
        - 8.0 * product_21 * rho * sigma_path * sum_1 * sum_15 * sum_2
        - 8.0 * path * sigma_beta_squared_squared * sin_beta * sum_14 * sum_1_squared * sum_2_squared
        + 16.0 * path * sigma_beta_squared * sin_beta * sum_16 * sum_1_squared * sum_2_squared * term_1
        + 16.0 * rho * sigma_beta * sigma_path * sum_1 * sum_17 * sum_2 * sum_8 * term_1
        + 32.0 * baseline_squared * product_22 * rho * sigma_beta * sin_beta_squared * sum_18
        + 32.0 * baseline_squared * product_24 * sigma_path_squared_squared * sum_19
    )
    sin_beta_squared_squared = sin_beta_squared**2
    sum_21 = (
        13.0 * baseline_squared * path_squared_squared * sin_beta_squared
        - 12.0 * cos_beta * product_6 * product_7 * sin_beta_squared
        - 15.0 * baseline_squared * path_squared_squared
        - 15.0 * baseline_squared_squared * path_squared
        - 4.0 * baseline_squared_squared * path_squared * sin_beta_squared_squared
        - 4.0 * cos_beta * path * product_5 * sin_beta_squared
        - baseline_squared_cubed
        - path_squared_cubed
        + 18.0 * baseline_squared_squared * path_squared * sin_beta_squared
        + 20.0 * cos_beta * product_6 * product_7
        + 6.0 * cos_beta * path * product_5
        + baseline_squared_cubed * sin_beta_squared
        + product_13
    )
    sum_22 = (
        10.0 * baseline * product_2 * product_7
        - 12.0 * baseline * cos_beta * product_7
        - 14.0 * path * product_2 * product_6
        - 16.0 * baseline_squared_squared
        - 21.0 * baseline_squared * cos_beta_squared * path_squared
        - path_squared_squared
        + 12.0 * baseline_squared * path_squared
        + 12.0 * baseline_squared_squared * cos_beta_squared
        + 24.0 * cos_beta * path * product_6
        + 3.0 * baseline_squared * cos_beta_squared_squared * path_squared
        + 3.0 * cos_beta_squared * path_squared_squared
    )
    sum_23 = (
        12.0 * baseline * cos_beta * product_3
        - 12.0 * baseline_squared * cos_beta_squared * path_squared_squared
        - 12.0 * baseline_squared_squared * path_squared
        - 2.0 * path_squared_cubed
        - 38.0 * baseline_squared_cubed * cos_beta_squared
        - 6.0 * baseline_squared * path_squared_squared
        - 60.0 * baseline_squared_squared * cos_beta_squared_squared * path_squared
        - 60.0 * product_2 * product_6 * product_7
        - 78.0 * cos_beta * path * product_5
        + 26.0 * cos_beta * product_6 * product_7
        + 32.0 * baseline_squared_cubed
        + 7.0 * baseline_squared_cubed * cos_beta_squared_squared
        + 78.0 * path * product_2 * product_5
        + 87.0 * baseline_squared_squared * cos_beta_squared * path_squared
        + product_10
        + product_11
        + product_12
        + product_4
        + product_9
    )
    sum_24 = (
        11.0 * product_5 * sin_beta_squared
        - 14.0 * baseline_squared_squared * cos_beta * path * sin_beta_squared
        - 2.0 * path_squared * product_6 * sin_beta_squared_squared
        - 21.0 * baseline * path_squared_squared
        - 57.0 * path_squared * product_6 * sin_beta_squared
        - 60.0 * baseline_squared_squared * cos_beta * path
        + 14.0 * baseline * path_squared_squared * sin_beta_squared
        + 21.0 * product_5
        + 22.0 * baseline_squared * cos_beta * product_7 * sin_beta_squared
        + 48.0 * path_squared * product_6
        + 6.0 * baseline_squared * cos_beta * product_7
        + 6.0 * cos_beta * product_3
    )
    sum_25 = (
        10.0 * cos_beta * product_6 * product_7
        - 17.0 * baseline_squared_cubed * cos_beta_squared
        - 30.0 * baseline_squared_squared * cos_beta_squared_squared * path_squared
        - 36.0 * product_2 * product_6 * product_7
        - 4.0 * baseline_squared * path_squared_squared
        - 44.0 * cos_beta * path * product_5
        - baseline_squared * cos_beta_squared * path_squared_squared
        - path_squared_cubed
        + 16.0 * baseline_squared_cubed
        + 40.0 * path * product_2 * product_5
        + 48.0 * baseline_squared_squared * cos_beta_squared * path_squared
        + product_13
        + product_14
        + product_15
        + product_16
        + product_17
        + product_18
        + product_19
        + product_20
    )
    sum_26 = 3.0 * baseline_squared - 6.0 * baseline * cos_beta * path + 3.0 * path_squared + product_1
    sum_27 = (
        15.0 * baseline * path_squared
        - 12.0 * baseline * path_squared * sin_beta_squared
        - 18.0 * baseline_squared * cos_beta * path
        - 4.0 * cos_beta * product_7
        + 7.0 * product_6
        + product_6 * sin_beta_squared
    )
    sum_28 = (
        16.0 * product_21 * rho * sigma_path * sin_beta * sum_1 * sum_2 * sum_24
        - 16.0 * sigma_path_squared * sin_beta_squared * sum_21
        - 8.0 * sigma_beta_squared_squared * sum_1_squared * sum_22 * sum_2_squared
        + 16.0 * rho_squared * sigma_beta_squared * sigma_path_squared * sum_23
        + 16.0 * sigma_beta_squared * sigma_path_squared * sum_25
        + 16.0 * sigma_beta_squared * sum_16**2 * sum_1_squared * sum_2_squared * term_1
        + 32.0 * baseline_squared * sigma_path_squared_squared * sin_beta_squared_squared * sum_26
        + 32.0 * rho * sigma_beta * sigma_path * sin_beta * sum_1 * sum_16 * sum_2 * sum_8 * term_1
        + 64.0 * baseline_squared * product_22 * product_24 * rho * sigma_beta * sum_27
    )
    result = _empty(arguments, (2, 2))
    result[..., 0, 0] = sum_11 * term_2
    result[..., 0, 1] = sum_20 * term_2
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = sum_28 * term_2
    return result


def covariance_averaged_second_order(
    *,
    path: npt.ArrayLike,
    beta: npt.ArrayLike,
    baseline: npt.ArrayLike,
    sigma_path: npt.ArrayLike,
    sigma_beta: npt.ArrayLike,
    rho: npt.ArrayLike,
) -> Floats:
    """Covariance of the plain conversion, averaged over the truth, to second order.

    Name: bistatic.covariance.averaged.second_order.
    Definition: e^L C to sigma^2.
    Conditioning: measurement-conditioned: the measured symbols stand for the measurement.
    Source: Lerro & Bar-Shalom 1993; Prosov (11), doi:10.1109/7.220948.

    Args:
        path: length of the path from transmitter to target to receiver [m], 30000 to 1e+06.
        beta: azimuth at the receiver, counter-clockwise from the x axis, where the transmitter stands [rad], -3.1416 to 3.1416.
        baseline: distance from transmitter to receiver; less than the path [m], 1 to 20000.
        sigma_path: standard deviation of the error of path [m], 0.001 to 1000.
        sigma_beta: standard deviation of the error of beta [rad], 1e-09 to 0.1.
        rho: correlation of the errors of path and beta [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (2, 2), unit m^2.

    Accuracy: at most 9 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
    """
    arguments = _floats(path, beta, baseline, sigma_path, sigma_beta, rho)
    path, beta, baseline, sigma_path, sigma_beta, rho = arguments
    cos_beta = np.cos(beta)
    divisor_1 = 2.0 * path - 2.0 * baseline * cos_beta
    sum_1 = baseline + path
    sum_1_squared = sum_1**2
    sum_2 = baseline - path
    sum_2_squared = sum_2**2
    path_squared = path**2
    sigma_beta_squared = sigma_beta**2
    sin_beta = np.sin(beta)
    sin_beta_squared = sin_beta**2
    baseline_squared = baseline**2
    sum_3 = baseline_squared - 2.0 * baseline * cos_beta * path + path_squared
    sum_3_squared = sum_3**2
    cos_beta_squared = cos_beta**2
    sigma_path_squared = sigma_path**2
    term_1 = 1.0 / (divisor_1**2)**2
    sum_4 = (
        4.0 * cos_beta_squared * sigma_path_squared * sum_3_squared
        + 4.0 * path_squared * sigma_beta_squared * sin_beta_squared * sum_1_squared * sum_2_squared
        + 8.0 * cos_beta * path * rho * sigma_beta * sigma_path * sin_beta * sum_1 * sum_2 * sum_3
    )
    sum_5 = baseline - cos_beta * path
    sum_6 = baseline * cos_beta - 2.0 * cos_beta_squared * path + path
    sum_7 = (
        4.0 * cos_beta * sigma_path_squared * sin_beta * sum_3_squared
        + 4.0 * path * sigma_beta_squared * sin_beta * sum_1_squared * sum_2_squared * sum_5
        + 4.0 * rho * sigma_beta * sigma_path * sum_1 * sum_2 * sum_3 * sum_6
    )
    sum_8 = (
        6.0 * baseline_squared * path_squared
        - 4.0 * baseline * baseline_squared * cos_beta * path
        - 4.0 * baseline_squared * path_squared * sin_beta_squared
        - 4.0 * baseline * cos_beta * path * path_squared
        + baseline_squared**2
        + path_squared**2
    )
    sum_9 = (
        4.0 * sigma_beta_squared * sum_1_squared * sum_2_squared * sum_5**2
        + 4.0 * sigma_path_squared * sin_beta_squared * sum_8
        + 8.0 * rho * sigma_beta * sigma_path * sin_beta * sum_1 * sum_2 * sum_3 * sum_5
    )
    result = _empty(arguments, (2, 2))
    result[..., 0, 0] = sum_4 * term_1
    result[..., 0, 1] = sum_7 * term_1
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = sum_9 * term_1
    return result


def covariance_averaged_fourth_order(
    *,
    path: npt.ArrayLike,
    beta: npt.ArrayLike,
    baseline: npt.ArrayLike,
    sigma_path: npt.ArrayLike,
    sigma_beta: npt.ArrayLike,
    rho: npt.ArrayLike,
) -> Floats:
    """Covariance of the plain conversion, averaged over the truth, to fourth order.

    Name: bistatic.covariance.averaged.fourth_order.
    Definition: e^L C to sigma^4.
    Conditioning: measurement-conditioned: the measured symbols stand for the measurement.
    Source: Lerro & Bar-Shalom 1993; Prosov (11), doi:10.1109/7.220948.

    Args:
        path: length of the path from transmitter to target to receiver [m], 30000 to 1e+06.
        beta: azimuth at the receiver, counter-clockwise from the x axis, where the transmitter stands [rad], -3.1416 to 3.1416.
        baseline: distance from transmitter to receiver; less than the path [m], 1 to 20000.
        sigma_path: standard deviation of the error of path [m], 0.001 to 1000.
        sigma_beta: standard deviation of the error of beta [rad], 1e-09 to 0.1.
        rho: correlation of the errors of path and beta [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (2, 2), unit m^2.

    Accuracy: at most 11.5 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
    """
    arguments = _floats(path, beta, baseline, sigma_path, sigma_beta, rho)
    path, beta, baseline, sigma_path, sigma_beta, rho = arguments
    cos_beta = np.cos(beta)
    divisor_1 = 2.0 * path - 2.0 * baseline * cos_beta
    sum_1 = baseline + path
    sum_1_squared = sum_1**2
    sum_2 = baseline - path
    sum_2_squared = sum_2**2
    baseline_squared = baseline**2
    path_squared = path**2
    sin_beta = np.sin(beta)
    sin_beta_squared = sin_beta**2
    product_1 = baseline_squared * sin_beta_squared
    sigma_beta_squared = sigma_beta**2
    sum_3 = 2.0 * baseline * cos_beta * path - baseline_squared - path_squared + product_1
    product_2 = baseline * baseline_squared
    cos_beta_squared = cos_beta**2
    product_3 = cos_beta * cos_beta_squared
    product_4 = path * path_squared
    baseline_squared_squared = baseline_squared**2
    baseline_squared_cubed = baseline_squared * baseline_squared**2
    product_5 = baseline * baseline_squared**2
    product_6 = cos_beta * cos_beta_squared**2
    product_7 = -14.0 * path * product_5 * product_6
    path_squared_squared = path_squared**2
    path_squared_cubed = path_squared * path_squared**2
    product_8 = path * path_squared**2
    product_9 = -42.0 * baseline * product_3 * product_8
    cos_beta_squared_squared = cos_beta_squared**2
    product_10 = 18.0 * baseline * cos_beta * product_8
    product_11 = 30.0 * product_2 * product_4 * product_6
    product_12 = 7.0 * cos_beta_squared * path_squared_cubed
    product_13 = 77.0 * baseline_squared * cos_beta_squared_squared * path_squared_squared
    rho_squared = rho**2
    sigma_path_squared = sigma_path**2
    sum_4 = (
        111.0 * baseline_squared_squared * cos_beta_squared * path_squared
        - 102.0 * product_2 * product_3 * product_4
        - 11.0 * baseline_squared_cubed * cos_beta_squared
        - 11.0 * baseline_squared_squared * path_squared
        - 27.0 * baseline_squared * cos_beta_squared * path_squared_squared
        - 3.0 * path_squared_cubed
        - 50.0 * cos_beta * path * product_5
        - 88.0 * baseline_squared_squared * cos_beta_squared_squared * path_squared
        + 2.0 * baseline_squared * path_squared_squared
        + 24.0 * cos_beta * product_2 * product_4
        + 7.0 * baseline_squared_cubed * cos_beta_squared_squared
        + 72.0 * path * product_3 * product_5
        + product_10
        + product_11
        + product_12
        + product_13
        + product_7
        + product_9
    )
    product_14 = -30.0 * baseline * product_3 * product_8
    product_15 = -4.0 * path * product_5 * product_6
    product_16 = 12.0 * product_2 * product_4 * product_6
    product_17 = 49.0 * baseline_squared * cos_beta_squared_squared * path_squared_squared
    product_18 = 5.0 * baseline_squared_cubed * cos_beta_squared_squared
    product_19 = 5.0 * cos_beta_squared * path_squared_cubed
    sum_5 = (
        12.0 * cos_beta * product_2 * product_4
        - 2.0 * baseline_squared * path_squared_squared
        - 21.0 * baseline_squared * cos_beta_squared * path_squared_squared
        - 22.0 * cos_beta * path * product_5
        - 3.0 * path_squared_cubed
        - 48.0 * product_2 * product_3 * product_4
        - 50.0 * baseline_squared_squared * cos_beta_squared_squared * path_squared
        - 7.0 * baseline_squared_cubed * cos_beta_squared
        - 7.0 * baseline_squared_squared * path_squared
        + 30.0 * path * product_3 * product_5
        + 63.0 * baseline_squared_squared * cos_beta_squared * path_squared
        + product_10
        + product_14
        + product_15
        + product_16
        + product_17
        + product_18
        + product_19
    )
    product_20 = sigma_path * sigma_path_squared
    sum_6 = (
        3.0 * baseline * cos_beta * path_squared
        - 3.0 * baseline_squared * path
        - 3.0 * cos_beta * product_2
        - 9.0 * baseline * path_squared * product_3
        - product_4
        + 3.0 * cos_beta_squared * product_4
        + 9.0 * baseline_squared * cos_beta_squared * path
        + product_2 * product_3
    )
    product_21 = sigma_beta * sigma_beta_squared
    sum_7 = (
        34.0 * cos_beta_squared * path * product_2
        - 16.0 * baseline * cos_beta_squared * product_4
        - 18.0 * baseline_squared_squared * cos_beta
        - 18.0 * path * product_2
        - 2.0 * cos_beta_squared_squared * path * product_2
        - 25.0 * baseline_squared * path_squared * product_3
        - 6.0 * baseline * product_4
        + 37.0 * baseline_squared * cos_beta * path_squared
        + 7.0 * baseline_squared_squared * product_3
        + 7.0 * cos_beta * path_squared_squared
    )
    sum_8 = baseline_squared - 2.0 * baseline * cos_beta * path + path_squared
    sum_8_squared = sum_8**2
    product_22 = baseline * cos_beta
    term_1 = (product_22 - path)**2
    sigma_beta_squared_squared = sigma_beta_squared**2
    sum_9 = (
        22.0 * baseline * path * product_3
        - 28.0 * baseline * cos_beta * path
        - 4.0 * path_squared
        - 40.0 * baseline_squared * cos_beta_squared
        + 36.0 * baseline_squared
        + 7.0 * baseline_squared * cos_beta_squared_squared
        + 7.0 * cos_beta_squared * path_squared
    )
    sigma_path_squared_squared = sigma_path_squared**2
    sum_10 = (
        4.0 * baseline * cos_beta * path
        - 2.0 * path_squared
        - 3.0 * baseline_squared
        + baseline_squared * cos_beta_squared
    )
    term_2 = 1.0 / (divisor_1 * divisor_1**2)**2
    sum_11 = (
        16.0 * cos_beta_squared * sigma_path_squared * sum_8_squared * term_1
        - 16.0 * path_squared * sigma_beta_squared * sin_beta_squared * sum_1_squared * sum_2_squared * sum_3
        - 16.0 * rho_squared * sigma_beta_squared * sigma_path_squared * sum_4
        - 16.0 * sigma_beta_squared * sigma_path_squared * sum_5
        - 192.0 * baseline_squared * cos_beta * product_20 * rho * sigma_beta * sin_beta * sum_6
        - 32.0 * path * product_21 * rho * sigma_path * sin_beta * sum_1 * sum_2 * sum_7
        + 32.0 * cos_beta * path * rho * sigma_beta * sigma_path * sin_beta * sum_1 * sum_2 * sum_8 * term_1
        + 8.0 * path_squared * sigma_beta_squared_squared * sum_1_squared * sum_2_squared * sum_9
        + 96.0 * baseline_squared * (1.0 + cos_beta) * (cos_beta - 1.0) * cos_beta_squared * sigma_path_squared_squared * sum_10
    )
    sum_12 = (
        112.0 * cos_beta_squared * path * product_5
        - 106.0 * cos_beta_squared * product_2 * product_4
        - 110.0 * baseline_squared_squared * path_squared * product_3
        - 14.0 * cos_beta_squared_squared * path * product_5
        - 36.0 * baseline_squared_cubed * cos_beta
        - 36.0 * path * product_5
        - 42.0 * baseline * cos_beta_squared * product_8
        + 13.0 * baseline_squared_cubed * product_3
        + 14.0 * baseline_squared * cos_beta * path_squared_squared
        + 30.0 * cos_beta_squared_squared * product_2 * product_4
        + 7.0 * cos_beta * path_squared_cubed
        + 77.0 * baseline_squared * path_squared_squared * product_3
        + 8.0 * product_2 * product_4
        + 83.0 * baseline_squared_squared * cos_beta * path_squared
    )
    sum_13 = (
        119.0 * cos_beta * path_squared * product_2
        - 107.0 * path_squared * product_2 * product_3
        - 14.0 * cos_beta_squared * product_8
        - 18.0 * cos_beta * product_5
        - 22.0 * baseline_squared_squared * cos_beta_squared_squared * path
        - 3.0 * baseline * cos_beta * path_squared_squared
        - 54.0 * baseline_squared_squared * path
        - 91.0 * baseline_squared * cos_beta_squared * product_4
        + 13.0 * product_3 * product_5
        + 32.0 * baseline * path_squared_squared * product_3
        + 4.0 * path_squared * product_2 * product_6
        + 50.0 * baseline_squared * cos_beta_squared_squared * product_4
        + 7.0 * product_8
        + 83.0 * baseline_squared_squared * cos_beta_squared * path
        + baseline_squared * product_4
    )
    sum_14 = (
        12.0 * cos_beta_squared_squared * product_2 * product_4
        - 18.0 * baseline_squared_cubed * cos_beta
        - 18.0 * path * product_5
        - 2.0 * product_2 * product_4
        - 30.0 * baseline * cos_beta_squared * product_8
        - 4.0 * cos_beta_squared_squared * path * product_5
        - 58.0 * baseline_squared_squared * path_squared * product_3
        - 62.0 * cos_beta_squared * product_2 * product_4
        + 16.0 * baseline_squared * cos_beta * path_squared_squared
        + 49.0 * baseline_squared * path_squared_squared * product_3
        + 49.0 * baseline_squared_squared * cos_beta * path_squared
        + 5.0 * baseline_squared_cubed * product_3
        + 5.0 * cos_beta * path_squared_cubed
        + 56.0 * cos_beta_squared * path * product_5
    )
    sum_15 = (
        16.0 * cos_beta_squared * product_2
        - 22.0 * baseline * cos_beta_squared * path_squared
        - 36.0 * product_2
        - 7.0 * baseline_squared * path * product_3
        - 7.0 * cos_beta * product_4
        + 16.0 * baseline * path_squared
        + 40.0 * baseline_squared * cos_beta * path
    )
    sum_16 = baseline - cos_beta * path
    sum_17 = path - 2.0 * cos_beta_squared * path + product_22
    sum_18 = (
        17.0 * baseline * cos_beta * path_squared
        - 18.0 * baseline * cos_beta * path_squared * sin_beta_squared
        - 19.0 * baseline_squared * path
        - 5.0 * product_4
        + 2.0 * cos_beta * product_2 * sin_beta_squared
        + 22.0 * baseline_squared * path * sin_beta_squared
        + 6.0 * product_4 * sin_beta_squared
        + 7.0 * cos_beta * product_2
    )
    product_23 = sin_beta * sin_beta_squared
    sum_19 = (
        2.0 * baseline_squared * cos_beta
        - 4.0 * baseline * path
        + 2.0 * cos_beta * path_squared
        + 4.0 * baseline * path * sin_beta_squared
        + baseline_squared * cos_beta * sin_beta_squared
    )
    sum_20 = (
        16.0 * cos_beta * sigma_path_squared * sin_beta * sum_8_squared * term_1
        - 16.0 * product_21 * rho * sigma_path * sum_1 * sum_13 * sum_2
        - 16.0 * rho_squared * sigma_beta_squared * sigma_path_squared * sin_beta * sum_12
        - 16.0 * sigma_beta_squared * sigma_path_squared * sin_beta * sum_14
        - 8.0 * path * sigma_beta_squared_squared * sin_beta * sum_15 * sum_1_squared * sum_2_squared
        + 16.0 * path * sigma_beta_squared * sin_beta * sum_16 * sum_1_squared * sum_2_squared * term_1
        + 16.0 * rho * sigma_beta * sigma_path * sum_1 * sum_17 * sum_2 * sum_8 * term_1
        + 96.0 * baseline_squared * product_20 * rho * sigma_beta * sin_beta_squared * sum_18
        + 96.0 * baseline_squared * product_23 * sigma_path_squared_squared * sum_19
    )
    sin_beta_squared_squared = sin_beta_squared**2
    sum_21 = (
        13.0 * baseline_squared * path_squared_squared * sin_beta_squared
        - 12.0 * cos_beta * product_2 * product_4 * sin_beta_squared
        - 15.0 * baseline_squared * path_squared_squared
        - 15.0 * baseline_squared_squared * path_squared
        - 4.0 * baseline_squared_squared * path_squared * sin_beta_squared_squared
        - 4.0 * cos_beta * path * product_5 * sin_beta_squared
        - baseline_squared_cubed
        - path_squared_cubed
        + 18.0 * baseline_squared_squared * path_squared * sin_beta_squared
        + 20.0 * cos_beta * product_2 * product_4
        + 6.0 * cos_beta * path * product_5
        + 6.0 * baseline * cos_beta * product_8
        + baseline_squared_cubed * sin_beta_squared
    )
    sum_22 = (
        13.0 * baseline_squared * path_squared
        - 16.0 * baseline * cos_beta * product_4
        - 2.0 * path * product_2 * product_3
        - 25.0 * baseline_squared * cos_beta_squared * path_squared
        - 36.0 * baseline_squared_squared
        + 13.0 * baseline_squared_squared * cos_beta_squared
        + 46.0 * cos_beta * path * product_2
        + 7.0 * path_squared_squared
    )
    sum_23 = (
        22.0 * baseline * product_3 * product_4
        - 26.0 * baseline * cos_beta * product_4
        - 3.0 * path_squared_squared
        - 32.0 * path * product_2 * product_3
        - 36.0 * baseline_squared_squared
        - 47.0 * baseline_squared * cos_beta_squared * path_squared
        + 28.0 * baseline_squared * path_squared
        + 28.0 * baseline_squared_squared * cos_beta_squared
        + 52.0 * cos_beta * path * product_2
        + 7.0 * baseline_squared * cos_beta_squared_squared * path_squared
        + 7.0 * cos_beta_squared * path_squared_squared
    )
    sum_24 = (
        166.0 * path * product_3 * product_5
        - 10.0 * baseline_squared * path_squared_squared
        - 132.0 * baseline_squared_squared * cos_beta_squared_squared * path_squared
        - 140.0 * product_2 * product_3 * product_4
        - 170.0 * cos_beta * path * product_5
        - 22.0 * baseline_squared * cos_beta_squared * path_squared_squared
        - 30.0 * baseline_squared_squared * path_squared
        - 4.0 * path_squared_cubed
        - 88.0 * baseline_squared_cubed * cos_beta_squared
        + 19.0 * baseline_squared_cubed * cos_beta_squared_squared
        + 207.0 * baseline_squared_squared * cos_beta_squared * path_squared
        + 24.0 * baseline * cos_beta * product_8
        + 50.0 * cos_beta * product_2 * product_4
        + 72.0 * baseline_squared_cubed
        + product_11
        + product_12
        + product_13
        + product_7
        + product_9
    )
    sum_25 = (
        117.0 * baseline_squared_squared * cos_beta_squared * path_squared
        - 100.0 * cos_beta * path * product_5
        - 2.0 * path_squared_cubed
        - 38.0 * baseline_squared_cubed * cos_beta_squared
        - 6.0 * baseline_squared_squared * path_squared
        - 66.0 * baseline_squared_squared * cos_beta_squared_squared * path_squared
        - 8.0 * baseline_squared * path_squared_squared
        - 88.0 * product_2 * product_3 * product_4
        + 12.0 * baseline * cos_beta * product_8
        + 16.0 * cos_beta * product_2 * product_4
        + 36.0 * baseline_squared_cubed
        + 4.0 * baseline_squared * cos_beta_squared * path_squared_squared
        + 86.0 * path * product_3 * product_5
        + product_14
        + product_15
        + product_16
        + product_17
        + product_18
        + product_19
    )
    sum_26 = (
        11.0 * baseline * path_squared
        - 13.0 * baseline_squared * cos_beta * path
        - 3.0 * cos_beta * product_4
        - 9.0 * baseline * path_squared * sin_beta_squared
        + 5.0 * product_2
        + product_2 * sin_beta_squared
    )
    sum_27 = 2.0 * baseline_squared - 4.0 * baseline * cos_beta * path + 2.0 * path_squared + product_1
    sum_28 = (
        16.0 * rho_squared * sigma_beta_squared * sigma_path_squared * sum_24
        - 16.0 * sigma_path_squared * sin_beta_squared * sum_21
        - 32.0 * product_21 * rho * sigma_path * sin_beta * sum_1 * sum_16 * sum_2 * sum_22
        - 8.0 * sigma_beta_squared_squared * sum_1_squared * sum_23 * sum_2_squared
        + 16.0 * sigma_beta_squared * sigma_path_squared * sum_25
        + 16.0 * sigma_beta_squared * sum_16**2 * sum_1_squared * sum_2_squared * term_1
        + 192.0 * baseline_squared * product_20 * product_23 * rho * sigma_beta * sum_26
        + 32.0 * rho * sigma_beta * sigma_path * sin_beta * sum_1 * sum_16 * sum_2 * sum_8 * term_1
        + 96.0 * baseline_squared * sigma_path_squared_squared * sin_beta_squared_squared * sum_27
    )
    result = _empty(arguments, (2, 2))
    result[..., 0, 0] = sum_11 * term_2
    result[..., 0, 1] = sum_20 * term_2
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = sum_28 * term_2
    return result


def unbiased_estimate_second_order(
    *,
    path: npt.ArrayLike,
    beta: npt.ArrayLike,
    baseline: npt.ArrayLike,
    sigma_path: npt.ArrayLike,
    sigma_beta: npt.ArrayLike,
    rho: npt.ArrayLike,
) -> Floats:
    """Unbiased estimate of the position, to second order.

    Name: bistatic.unbiased.estimate.second_order.
    Definition: u = e^-L h to sigma^2.
    Conditioning: measurement-conditioned: the measured symbols stand for the measurement.
    Source: Mo et al. 1998, doi:10.1109/7.705921.

    Args:
        path: length of the path from transmitter to target to receiver [m], 30000 to 1e+06.
        beta: azimuth at the receiver, counter-clockwise from the x axis, where the transmitter stands [rad], -3.1416 to 3.1416.
        baseline: distance from transmitter to receiver; less than the path [m], 1 to 20000.
        sigma_path: standard deviation of the error of path [m], 0.001 to 1000.
        sigma_beta: standard deviation of the error of beta [rad], 1e-09 to 0.1.
        rho: correlation of the errors of path and beta [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (2), unit m.

    Accuracy: at most 3 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
    """
    arguments = _floats(path, beta, baseline, sigma_path, sigma_beta, rho)
    path, beta, baseline, sigma_path, sigma_beta, rho = arguments
    cos_beta = np.cos(beta)
    divisor_1 = 2.0 * path - 2.0 * baseline * cos_beta
    sum_1 = baseline + path
    sum_2 = baseline - path
    cos_beta_squared = cos_beta**2
    sigma_beta_squared = sigma_beta**2
    sum_3 = cos_beta * path - 2.0 * baseline + baseline * cos_beta_squared
    term_1 = (baseline * cos_beta - path)**2
    baseline_squared = baseline**2
    sigma_path_squared = sigma_path**2
    sin_beta = np.sin(beta)
    sin_beta_squared = sin_beta**2
    path_squared = path**2
    product_1 = baseline * baseline_squared
    product_2 = path * path_squared
    sum_4 = (
        baseline_squared * path
        - 3.0 * baseline * cos_beta * path_squared
        + cos_beta * product_1
        + product_2
    )
    term_2 = 1.0 / (divisor_1 * divisor_1**2)
    sum_5 = (
        4.0 * baseline_squared * cos_beta * sigma_path_squared * sin_beta_squared
        - 2.0 * path * sigma_beta_squared * sum_1 * sum_2 * sum_3
        - 4.0 * cos_beta * sum_1 * sum_2 * term_1
        + 4.0 * rho * sigma_beta * sigma_path * sin_beta * sum_4
    )
    sum_6 = (
        3.0 * baseline_squared * cos_beta * path
        - 2.0 * product_1
        - 3.0 * baseline * cos_beta_squared * path_squared
        + cos_beta * product_2
        + cos_beta_squared * product_1
    )
    sum_7 = 2.0 * baseline_squared - baseline * cos_beta * path - path_squared
    sum_8 = (
        2.0 * sigma_beta_squared * sin_beta * sum_1 * sum_2 * sum_7
        - 4.0 * sin_beta * sum_1 * sum_2 * term_1
        - 4.0 * rho * sigma_beta * sigma_path * sum_6
        + 4.0 * baseline_squared * sigma_path_squared * sin_beta * sin_beta_squared
    )
    result = _empty(arguments, (2,))
    result[..., 0] = sum_5 * term_2
    result[..., 1] = sum_8 * term_2
    return result


def unbiased_estimate_fourth_order(
    *,
    path: npt.ArrayLike,
    beta: npt.ArrayLike,
    baseline: npt.ArrayLike,
    sigma_path: npt.ArrayLike,
    sigma_beta: npt.ArrayLike,
    rho: npt.ArrayLike,
) -> Floats:
    """Unbiased estimate of the position, to fourth order.

    Name: bistatic.unbiased.estimate.fourth_order.
    Definition: u = e^-L h to sigma^4.
    Conditioning: measurement-conditioned: the measured symbols stand for the measurement.
    Source: Mo et al. 1998, doi:10.1109/7.705921.

    Args:
        path: length of the path from transmitter to target to receiver [m], 30000 to 1e+06.
        beta: azimuth at the receiver, counter-clockwise from the x axis, where the transmitter stands [rad], -3.1416 to 3.1416.
        baseline: distance from transmitter to receiver; less than the path [m], 1 to 20000.
        sigma_path: standard deviation of the error of path [m], 0.001 to 1000.
        sigma_beta: standard deviation of the error of beta [rad], 1e-09 to 0.1.
        rho: correlation of the errors of path and beta [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (2), unit m.

    Accuracy: at most 3.5 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
    """
    arguments = _floats(path, beta, baseline, sigma_path, sigma_beta, rho)
    path, beta, baseline, sigma_path, sigma_beta, rho = arguments
    cos_beta = np.cos(beta)
    divisor_1 = 2.0 * path - 2.0 * baseline * cos_beta
    sum_1 = baseline * cos_beta - path
    sum_1_squared = sum_1**2
    sum_1_squared_squared = sum_1_squared**2
    sum_2 = baseline + path
    sum_3 = baseline - path
    baseline_squared = baseline**2
    sin_beta = np.sin(beta)
    sin_beta_squared = sin_beta**2
    path_squared = path**2
    sigma_path_squared = sigma_path**2
    sum_4 = (
        2.0 * baseline * path
        - 2.0 * baseline * path * sin_beta_squared
        - baseline_squared * cos_beta
        - cos_beta * path_squared
        + baseline_squared * cos_beta * sin_beta_squared
    )
    product_1 = baseline * baseline_squared
    cos_beta_squared = cos_beta**2
    product_2 = cos_beta * cos_beta_squared
    cos_beta_squared_squared = cos_beta_squared**2
    product_3 = path * path_squared
    product_4 = cos_beta * product_3
    sigma_beta_squared = sigma_beta**2
    sigma_beta_squared_squared = sigma_beta_squared**2
    sum_5 = (
        11.0 * baseline_squared * path * product_2
        - 20.0 * baseline_squared * cos_beta * path
        - 20.0 * cos_beta_squared * product_1
        - 8.0 * baseline * path_squared
        + 11.0 * baseline * cos_beta_squared * path_squared
        + 24.0 * product_1
        + cos_beta_squared_squared * product_1
        + product_4
    )
    sigma_path_squared_squared = sigma_path_squared**2
    sum_6 = cos_beta * path - 2.0 * baseline + baseline * cos_beta_squared
    sum_7 = (
        13.0 * baseline * cos_beta_squared * path
        - 3.0 * baseline * cos_beta_squared_squared * path
        - 6.0 * baseline * path
        - 6.0 * baseline_squared * cos_beta
        - 9.0 * path_squared * product_2
        + 4.0 * baseline_squared * product_2
        + 7.0 * cos_beta * path_squared
    )
    rho_squared = rho**2
    sum_8 = (
        baseline_squared * path
        - 3.0 * baseline * cos_beta * path_squared
        + cos_beta * product_1
        + product_3
    )
    product_5 = sigma_path * sigma_path_squared
    sum_9 = 3.0 * cos_beta_squared * path - 3.0 * baseline * cos_beta - path + baseline * product_2
    baseline_squared_squared = baseline_squared**2
    path_squared_squared = path_squared**2
    product_6 = baseline * baseline_squared**2
    product_7 = path * path_squared**2
    product_8 = sigma_beta * sigma_beta_squared
    sum_10 = (
        11.0 * baseline_squared_squared * cos_beta_squared * path
        - 17.0 * baseline_squared * cos_beta_squared * product_3
        - 18.0 * baseline_squared_squared * path
        - 3.0 * path_squared * product_1 * product_2
        - 5.0 * baseline * cos_beta * path_squared_squared
        - 6.0 * cos_beta * product_6
        + 29.0 * cos_beta * path_squared * product_1
        + 7.0 * baseline_squared * product_3
        + product_2 * product_6
        + product_7
    )
    term_1 = 1.0 / (divisor_1 * (divisor_1**2)**2)
    sum_11 = (
        16.0 * baseline_squared * rho_squared * sigma_beta_squared * sigma_path_squared * sum_7
        - 16.0 * baseline_squared * sigma_path_squared * sin_beta_squared * sum_4
        - 16.0 * cos_beta * sum_1_squared_squared * sum_2 * sum_3
        - 2.0 * path * sigma_beta_squared_squared * sum_2 * sum_3 * sum_5
        - 48.0 * baseline_squared * cos_beta * sigma_path_squared_squared * sin_beta_squared
        - 8.0 * path * sigma_beta_squared * sum_1_squared * sum_2 * sum_3 * sum_6
        + 16.0 * rho * sigma_beta * sigma_path * sin_beta * sum_1_squared * sum_8
        + 48.0 * baseline_squared * product_5 * rho * sigma_beta * sin_beta * sum_9
        + 8.0 * baseline_squared * sigma_beta_squared * sigma_path_squared * sum_7
        + 8.0 * product_8 * rho * sigma_path * sin_beta * sum_10
    )
    product_9 = sin_beta * sin_beta_squared
    sum_12 = (
        2.0 * baseline * cos_beta * path
        - baseline_squared
        - path_squared
        + baseline_squared * sin_beta_squared
    )
    sum_13 = (
        3.0 * baseline_squared * cos_beta * path
        - 2.0 * product_1
        - 3.0 * baseline * cos_beta_squared * path_squared
        + cos_beta_squared * product_1
        + product_4
    )
    sum_14 = 3.0 * baseline - 3.0 * cos_beta * path + baseline * sin_beta_squared
    sum_15 = (
        19.0 * baseline_squared_squared * path * product_2
        - 17.0 * baseline_squared * product_2 * product_3
        - 20.0 * cos_beta_squared * product_6
        - 20.0 * path_squared * product_1
        - 3.0 * cos_beta_squared_squared * path_squared * product_1
        - 32.0 * baseline_squared_squared * cos_beta * path
        - 5.0 * baseline * cos_beta_squared * path_squared_squared
        + 21.0 * baseline_squared * cos_beta * product_3
        + 24.0 * product_6
        + 31.0 * cos_beta_squared * path_squared * product_1
        + cos_beta * product_7
        + cos_beta_squared_squared * product_6
    )
    sum_16 = (
        20.0 * baseline_squared * path_squared
        - 11.0 * baseline_squared * cos_beta_squared * path_squared
        - 11.0 * baseline * cos_beta * product_3
        - 24.0 * baseline_squared_squared
        - path_squared_squared
        - path * product_1 * product_2
        + 20.0 * cos_beta * path * product_1
        + 8.0 * baseline_squared_squared * cos_beta_squared
    )
    sum_17 = (
        2.0 * baseline_squared * cos_beta_squared
        - 3.0 * cos_beta_squared * path_squared
        - 4.0 * baseline_squared
        - baseline * path * product_2
        + 5.0 * baseline * cos_beta * path
        + path_squared
    )
    sum_18 = 2.0 * baseline_squared - baseline * cos_beta * path - path_squared
    sum_19 = (
        2.0 * sigma_beta_squared_squared * sin_beta * sum_16 * sum_2 * sum_3
        - 16.0 * baseline_squared * product_9 * sigma_path_squared * sum_12
        - 16.0 * sin_beta * sum_1_squared_squared * sum_2 * sum_3
        - 16.0 * rho * sigma_beta * sigma_path * sum_13 * sum_1_squared
        - 48.0 * baseline_squared * product_5 * rho * sigma_beta * sin_beta_squared * sum_14
        - 48.0 * baseline_squared * product_9 * sigma_path_squared_squared
        - 8.0 * product_8 * rho * sigma_path * sum_15
        + 24.0 * baseline_squared * sigma_beta_squared * sigma_path_squared * sin_beta * sum_17
        + 48.0 * baseline_squared * rho_squared * sigma_beta_squared * sigma_path_squared * sin_beta * sum_17
        + 8.0 * sigma_beta_squared * sin_beta * sum_18 * sum_1_squared * sum_2 * sum_3
    )
    result = _empty(arguments, (2,))
    result[..., 0] = sum_11 * term_1
    result[..., 1] = sum_19 * term_1
    return result


def unbiased_covariance_second_order(
    *,
    path: npt.ArrayLike,
    beta: npt.ArrayLike,
    baseline: npt.ArrayLike,
    sigma_path: npt.ArrayLike,
    sigma_beta: npt.ArrayLike,
    rho: npt.ArrayLike,
) -> Floats:
    """Error covariance of the unbiased estimate u, to second order.

    Name: bistatic.unbiased.covariance.second_order.
    Definition: u u' - u (e^L h)' - (e^L h) u' + e^L(h h') to sigma^2.
    Conditioning: measurement-conditioned: the measured symbols stand for the measurement.
    Source: Mo et al. 1998, doi:10.1109/7.705921.

    Args:
        path: length of the path from transmitter to target to receiver [m], 30000 to 1e+06.
        beta: azimuth at the receiver, counter-clockwise from the x axis, where the transmitter stands [rad], -3.1416 to 3.1416.
        baseline: distance from transmitter to receiver; less than the path [m], 1 to 20000.
        sigma_path: standard deviation of the error of path [m], 0.001 to 1000.
        sigma_beta: standard deviation of the error of beta [rad], 1e-09 to 0.1.
        rho: correlation of the errors of path and beta [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (2, 2), unit m^2.

    Accuracy: at most 9 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
    """
    arguments = _floats(path, beta, baseline, sigma_path, sigma_beta, rho)
    path, beta, baseline, sigma_path, sigma_beta, rho = arguments
    cos_beta = np.cos(beta)
    divisor_1 = 2.0 * path - 2.0 * baseline * cos_beta
    sum_1 = baseline + path
    sum_1_squared = sum_1**2
    sum_2 = baseline - path
    sum_2_squared = sum_2**2
    path_squared = path**2
    sigma_beta_squared = sigma_beta**2
    sin_beta = np.sin(beta)
    sin_beta_squared = sin_beta**2
    baseline_squared = baseline**2
    sum_3 = baseline_squared - 2.0 * baseline * cos_beta * path + path_squared
    sum_3_squared = sum_3**2
    cos_beta_squared = cos_beta**2
    sigma_path_squared = sigma_path**2
    term_1 = 1.0 / (divisor_1**2)**2
    sum_4 = (
        4.0 * cos_beta_squared * sigma_path_squared * sum_3_squared
        + 4.0 * path_squared * sigma_beta_squared * sin_beta_squared * sum_1_squared * sum_2_squared
        + 8.0 * cos_beta * path * rho * sigma_beta * sigma_path * sin_beta * sum_1 * sum_2 * sum_3
    )
    sum_5 = baseline - cos_beta * path
    sum_6 = baseline * cos_beta - 2.0 * cos_beta_squared * path + path
    sum_7 = (
        4.0 * cos_beta * sigma_path_squared * sin_beta * sum_3_squared
        + 4.0 * path * sigma_beta_squared * sin_beta * sum_1_squared * sum_2_squared * sum_5
        + 4.0 * rho * sigma_beta * sigma_path * sum_1 * sum_2 * sum_3 * sum_6
    )
    sum_8 = (
        6.0 * baseline_squared * path_squared
        - 4.0 * baseline * baseline_squared * cos_beta * path
        - 4.0 * baseline_squared * path_squared * sin_beta_squared
        - 4.0 * baseline * cos_beta * path * path_squared
        + baseline_squared**2
        + path_squared**2
    )
    sum_9 = (
        4.0 * sigma_beta_squared * sum_1_squared * sum_2_squared * sum_5**2
        + 4.0 * sigma_path_squared * sin_beta_squared * sum_8
        + 8.0 * rho * sigma_beta * sigma_path * sin_beta * sum_1 * sum_2 * sum_3 * sum_5
    )
    result = _empty(arguments, (2, 2))
    result[..., 0, 0] = sum_4 * term_1
    result[..., 0, 1] = sum_7 * term_1
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = sum_9 * term_1
    return result


def unbiased_covariance_fourth_order(
    *,
    path: npt.ArrayLike,
    beta: npt.ArrayLike,
    baseline: npt.ArrayLike,
    sigma_path: npt.ArrayLike,
    sigma_beta: npt.ArrayLike,
    rho: npt.ArrayLike,
) -> Floats:
    """Error covariance of the unbiased estimate u, to fourth order.

    Name: bistatic.unbiased.covariance.fourth_order.
    Definition: u u' - u (e^L h)' - (e^L h) u' + e^L(h h') to sigma^4.
    Conditioning: measurement-conditioned: the measured symbols stand for the measurement.
    Source: Mo et al. 1998, doi:10.1109/7.705921.

    Args:
        path: length of the path from transmitter to target to receiver [m], 30000 to 1e+06.
        beta: azimuth at the receiver, counter-clockwise from the x axis, where the transmitter stands [rad], -3.1416 to 3.1416.
        baseline: distance from transmitter to receiver; less than the path [m], 1 to 20000.
        sigma_path: standard deviation of the error of path [m], 0.001 to 1000.
        sigma_beta: standard deviation of the error of beta [rad], 1e-09 to 0.1.
        rho: correlation of the errors of path and beta [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (2, 2), unit m^2.

    Accuracy: at most 9.5 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
    """
    arguments = _floats(path, beta, baseline, sigma_path, sigma_beta, rho)
    path, beta, baseline, sigma_path, sigma_beta, rho = arguments
    cos_beta = np.cos(beta)
    divisor_1 = 2.0 * path - 2.0 * baseline * cos_beta
    sum_1 = baseline + path
    sum_1_squared = sum_1**2
    sum_2 = baseline - path
    sum_2_squared = sum_2**2
    baseline_squared = baseline**2
    path_squared = path**2
    sin_beta = np.sin(beta)
    sin_beta_squared = sin_beta**2
    product_1 = baseline_squared * sin_beta_squared
    sigma_beta_squared = sigma_beta**2
    sum_3 = 2.0 * baseline * cos_beta * path - baseline_squared - path_squared + product_1
    product_2 = baseline * baseline_squared**2
    cos_beta_squared = cos_beta**2
    path_squared_squared = path_squared**2
    product_3 = cos_beta * cos_beta_squared
    product_4 = path * path_squared**2
    product_5 = -42.0 * baseline * product_3 * product_4
    path_squared_cubed = path_squared * path_squared**2
    product_6 = -6.0 * baseline_squared * path_squared_squared
    product_7 = cos_beta * cos_beta_squared**2
    product_8 = -6.0 * path * product_2 * product_7
    product_9 = baseline * baseline_squared
    product_10 = path * path_squared
    baseline_squared_squared = baseline_squared**2
    cos_beta_squared_squared = cos_beta_squared**2
    baseline_squared_cubed = baseline_squared * baseline_squared**2
    product_11 = 14.0 * product_10 * product_7 * product_9
    product_12 = 69.0 * baseline_squared * cos_beta_squared_squared * path_squared_squared
    product_13 = 7.0 * cos_beta_squared * path_squared_cubed
    rho_squared = rho**2
    sigma_path_squared = sigma_path**2
    sum_4 = (
        24.0 * cos_beta * product_10 * product_9
        - 30.0 * cos_beta * path * product_2
        - 37.0 * baseline_squared * cos_beta_squared * path_squared_squared
        - 5.0 * path_squared_cubed
        - 62.0 * product_10 * product_3 * product_9
        - 64.0 * baseline_squared_squared * cos_beta_squared_squared * path_squared
        - 9.0 * baseline_squared_cubed * cos_beta_squared
        - 9.0 * baseline_squared_squared * path_squared
        + 30.0 * baseline * cos_beta * product_4
        + 40.0 * path * product_2 * product_3
        + 7.0 * baseline_squared_cubed * cos_beta_squared_squared
        + 79.0 * baseline_squared_squared * cos_beta_squared * path_squared
        + product_11
        + product_12
        + product_13
        + product_5
        + product_6
        + product_8
    )
    product_14 = -12.0 * baseline * product_3 * product_4
    product_15 = 10.0 * product_10 * product_7 * product_9
    product_16 = 2.0 * cos_beta_squared * path_squared_cubed
    product_17 = 24.0 * baseline_squared * cos_beta_squared_squared * path_squared_squared
    product_18 = 6.0 * baseline * cos_beta * product_4
    sum_5 = (
        12.0 * cos_beta * product_10 * product_9
        - 11.0 * baseline_squared * cos_beta_squared * path_squared_squared
        - 18.0 * cos_beta * path * product_2
        - 26.0 * baseline_squared_squared * cos_beta_squared_squared * path_squared
        - 3.0 * baseline_squared_cubed * cos_beta_squared
        - 3.0 * baseline_squared_squared * path_squared
        - 34.0 * product_10 * product_3 * product_9
        - path_squared_cubed
        + 2.0 * baseline_squared_cubed * cos_beta_squared_squared
        + 26.0 * path * product_2 * product_3
        + 32.0 * baseline_squared_squared * cos_beta_squared * path_squared
        + product_14
        + product_15
        + product_16
        + product_17
        + product_18
        + product_8
    )
    product_19 = sigma_path * sigma_path_squared
    sum_6 = (
        2.0 * cos_beta_squared * product_10
        - 2.0 * baseline_squared * path
        - 2.0 * cos_beta * product_9
        - 6.0 * baseline * path_squared * product_3
        - product_10
        + 3.0 * baseline * cos_beta * path_squared
        + 5.0 * baseline_squared * cos_beta_squared * path
        + product_3 * product_9
    )
    product_20 = sigma_beta * sigma_beta_squared
    sum_7 = (
        20.0 * cos_beta_squared * path * product_9
        - 11.0 * baseline * cos_beta_squared * product_10
        - 12.0 * baseline_squared_squared * cos_beta
        - 12.0 * path * product_9
        - 17.0 * baseline_squared * path_squared * product_3
        - 6.0 * baseline * product_10
        - cos_beta_squared_squared * path * product_9
        + 29.0 * baseline_squared * cos_beta * path_squared
        + 5.0 * baseline_squared_squared * product_3
        + 5.0 * cos_beta * path_squared_squared
    )
    product_21 = -2.0 * baseline * cos_beta * path
    sum_8 = baseline_squared + path_squared + product_1 + product_21
    sigma_path_squared_squared = sigma_path_squared**2
    sum_9 = baseline_squared + path_squared + product_21
    sum_9_squared = sum_9**2
    product_22 = baseline * cos_beta
    term_1 = (product_22 - path)**2
    sigma_beta_squared_squared = sigma_beta_squared**2
    sum_10 = (
        14.0 * baseline * path * product_3
        - 2.0 * path_squared
        - 20.0 * baseline * cos_beta * path
        - 26.0 * baseline_squared * cos_beta_squared
        + 24.0 * baseline_squared
        + 5.0 * baseline_squared * cos_beta_squared_squared
        + 5.0 * cos_beta_squared * path_squared
    )
    term_2 = 1.0 / (divisor_1 * divisor_1**2)**2
    sum_11 = (
        16.0 * cos_beta_squared * sigma_path_squared * sum_9_squared * term_1
        - 16.0 * path_squared * sigma_beta_squared * sin_beta_squared * sum_1_squared * sum_2_squared * sum_3
        - 16.0 * rho_squared * sigma_beta_squared * sigma_path_squared * sum_4
        - 16.0 * sigma_beta_squared * sigma_path_squared * sum_5
        - 192.0 * baseline_squared * cos_beta * product_19 * rho * sigma_beta * sin_beta * sum_6
        - 32.0 * path * product_20 * rho * sigma_path * sin_beta * sum_1 * sum_2 * sum_7
        - 96.0 * baseline_squared * sigma_path_squared_squared * (1.0 + sin_beta) * (sin_beta - 1.0) * sin_beta_squared * sum_8
        + 32.0 * cos_beta * path * rho * sigma_beta * sigma_path * sin_beta * sum_1 * sum_2 * sum_9 * term_1
        + 8.0 * path_squared * sigma_beta_squared_squared * sum_10 * sum_1_squared * sum_2_squared
    )
    sum_12 = (
        14.0 * cos_beta_squared_squared * product_10 * product_9
        - 24.0 * baseline_squared_cubed * cos_beta
        - 24.0 * path * product_2
        - 4.0 * product_10 * product_9
        - 42.0 * baseline * cos_beta_squared * product_4
        - 6.0 * cos_beta_squared_squared * path * product_2
        - 74.0 * baseline_squared_squared * path_squared * product_3
        - 86.0 * cos_beta_squared * product_10 * product_9
        + 22.0 * baseline_squared * cos_beta * path_squared_squared
        + 68.0 * cos_beta_squared * path * product_2
        + 69.0 * baseline_squared * path_squared_squared * product_3
        + 7.0 * cos_beta * path_squared_cubed
        + 71.0 * baseline_squared_squared * cos_beta * path_squared
        + 9.0 * baseline_squared_cubed * product_3
    )
    sum_13 = (
        12.0 * baseline_squared * path_squared_squared * product_3
        - 17.0 * baseline_squared_squared * path_squared * product_3
        - 17.0 * cos_beta_squared * product_10 * product_9
        - 3.0 * cos_beta_squared_squared * path * product_2
        - 6.0 * baseline_squared_cubed * cos_beta
        - 6.0 * baseline * cos_beta_squared * product_4
        - 6.0 * path * product_2
        + 14.0 * baseline_squared_squared * cos_beta * path_squared
        + 17.0 * cos_beta_squared * path * product_2
        + 2.0 * product_10 * product_9
        + 3.0 * baseline_squared_cubed * product_3
        + 5.0 * cos_beta_squared_squared * product_10 * product_9
        + baseline_squared * cos_beta * path_squared_squared
        + cos_beta * path_squared_cubed
    )
    sum_14 = (
        11.0 * cos_beta_squared * product_9
        - 14.0 * baseline * cos_beta_squared * path_squared
        - 24.0 * product_9
        - 5.0 * baseline_squared * path * product_3
        - 5.0 * cos_beta * product_10
        + 11.0 * baseline * path_squared
        + 26.0 * baseline_squared * cos_beta * path
    )
    sum_15 = (
        10.0 * product_4
        - 124.0 * baseline_squared * cos_beta_squared * product_10
        - 143.0 * path_squared * product_3 * product_9
        - 2.0 * baseline_squared * product_10
        - 20.0 * cos_beta_squared * product_4
        - 24.0 * cos_beta * product_2
        - 28.0 * baseline_squared_squared * cos_beta_squared_squared * path
        - 3.0 * baseline * cos_beta * path_squared_squared
        - 72.0 * baseline_squared_squared * path
        + 104.0 * baseline_squared_squared * cos_beta_squared * path
        + 167.0 * cos_beta * path_squared * product_9
        + 19.0 * product_2 * product_3
        + 4.0 * path_squared * product_7 * product_9
        + 44.0 * baseline * path_squared_squared * product_3
        + 68.0 * baseline_squared * cos_beta_squared_squared * product_10
    )
    sum_16 = baseline - cos_beta * path
    sum_17 = path - 2.0 * cos_beta_squared * path + product_22
    sum_18 = (
        10.0 * baseline * cos_beta * path_squared
        - 11.0 * baseline_squared * path
        - 12.0 * baseline * cos_beta * path_squared * sin_beta_squared
        - 3.0 * product_10
        + 13.0 * baseline_squared * path * sin_beta_squared
        + 2.0 * cos_beta * product_9 * sin_beta_squared
        + 4.0 * cos_beta * product_9
        + 4.0 * product_10 * sin_beta_squared
    )
    product_23 = sin_beta * sin_beta_squared
    sum_19 = (
        2.0 * baseline * path * sin_beta_squared
        - 2.0 * baseline * path
        + baseline_squared * cos_beta
        + baseline_squared * cos_beta * sin_beta_squared
        + cos_beta * path_squared
    )
    sum_20 = (
        16.0 * cos_beta * sigma_path_squared * sin_beta * sum_9_squared * term_1
        - 16.0 * rho_squared * sigma_beta_squared * sigma_path_squared * sin_beta * sum_12
        - 32.0 * sigma_beta_squared * sigma_path_squared * sin_beta * sum_13
        - 8.0 * product_20 * rho * sigma_path * sum_1 * sum_15 * sum_2
        - 8.0 * path * sigma_beta_squared_squared * sin_beta * sum_14 * sum_1_squared * sum_2_squared
        + 16.0 * path * sigma_beta_squared * sin_beta * sum_16 * sum_1_squared * sum_2_squared * term_1
        + 16.0 * rho * sigma_beta * sigma_path * sum_1 * sum_17 * sum_2 * sum_9 * term_1
        + 96.0 * baseline_squared * product_19 * rho * sigma_beta * sin_beta_squared * sum_18
        + 96.0 * baseline_squared * product_23 * sigma_path_squared_squared * sum_19
    )
    sum_21 = (
        106.0 * baseline_squared_squared * cos_beta * path
        - 10.0 * cos_beta * product_4
        - 101.0 * cos_beta_squared * path_squared * product_9
        - 18.0 * baseline_squared_squared * path * product_3
        - 32.0 * baseline_squared * cos_beta * product_10
        - 48.0 * product_2
        + 19.0 * cos_beta_squared * product_2
        + 19.0 * path_squared * product_9
        + 2.0 * cos_beta_squared_squared * path_squared * product_9
        + 22.0 * baseline * cos_beta_squared * path_squared_squared
        + 34.0 * baseline_squared * product_10 * product_3
        + 7.0 * baseline * path_squared_squared
    )
    product_24 = -15.0 * baseline_squared_squared * path_squared
    sin_beta_squared_squared = sin_beta_squared**2
    sum_22 = (
        13.0 * baseline_squared * path_squared_squared * sin_beta_squared
        - 12.0 * cos_beta * product_10 * product_9 * sin_beta_squared
        - 15.0 * baseline_squared * path_squared_squared
        - 4.0 * baseline_squared_squared * path_squared * sin_beta_squared_squared
        - 4.0 * cos_beta * path * product_2 * sin_beta_squared
        - baseline_squared_cubed
        - path_squared_cubed
        + 18.0 * baseline_squared_squared * path_squared * sin_beta_squared
        + 20.0 * cos_beta * product_10 * product_9
        + 6.0 * cos_beta * path * product_2
        + baseline_squared_cubed * sin_beta_squared
        + product_18
        + product_24
    )
    sum_23 = (
        14.0 * baseline * product_10 * product_3
        - 16.0 * baseline * cos_beta * product_10
        - 22.0 * path * product_3 * product_9
        - 24.0 * baseline_squared_squared
        - 3.0 * path_squared_squared
        - 31.0 * baseline_squared * cos_beta_squared * path_squared
        + 20.0 * baseline_squared * path_squared
        + 20.0 * baseline_squared_squared * cos_beta_squared
        + 32.0 * cos_beta * path * product_9
        + 5.0 * baseline_squared * cos_beta_squared_squared * path_squared
        + 5.0 * cos_beta_squared * path_squared_squared
    )
    sum_24 = (
        10.0 * cos_beta * product_10 * product_9
        - 12.0 * baseline_squared_squared * path_squared
        - 124.0 * product_10 * product_3 * product_9
        - 126.0 * cos_beta * path * product_2
        - 2.0 * path_squared_cubed
        - 54.0 * baseline_squared_cubed * cos_beta_squared
        - 84.0 * baseline_squared_squared * cos_beta_squared_squared * path_squared
        + 102.0 * path * product_2 * product_3
        + 11.0 * baseline_squared_cubed * cos_beta_squared_squared
        + 12.0 * baseline_squared * cos_beta_squared * path_squared_squared
        + 12.0 * baseline * cos_beta * product_4
        + 171.0 * baseline_squared_squared * cos_beta_squared * path_squared
        + 48.0 * baseline_squared_cubed
        + product_11
        + product_12
        + product_13
        + product_5
        + product_6
        + product_8
    )
    sum_25 = (
        10.0 * baseline_squared_cubed * cos_beta_squared_squared
        - 33.0 * baseline_squared_cubed * cos_beta_squared
        - 42.0 * baseline_squared_squared * cos_beta_squared_squared * path_squared
        - 44.0 * product_10 * product_3 * product_9
        - 48.0 * cos_beta * path * product_2
        - 9.0 * baseline_squared * cos_beta_squared * path_squared_squared
        - path_squared_cubed
        + 14.0 * cos_beta * product_10 * product_9
        + 24.0 * baseline_squared_cubed
        + 48.0 * path * product_2 * product_3
        + 72.0 * baseline_squared_squared * cos_beta_squared * path_squared
        + product_14
        + product_15
        + product_16
        + product_17
        + product_18
        + product_24
        + product_8
    )
    sum_26 = (
        3.0 * product_9
        - 2.0 * cos_beta * product_10
        - 6.0 * baseline * path_squared * sin_beta_squared
        - 8.0 * baseline_squared * cos_beta * path
        + 7.0 * baseline * path_squared
        + product_9 * sin_beta_squared
    )
    sum_27 = (
        16.0 * rho_squared * sigma_beta_squared * sigma_path_squared * sum_24
        - 16.0 * product_20 * rho * sigma_path * sin_beta * sum_1 * sum_2 * sum_21
        - 16.0 * sigma_path_squared * sin_beta_squared * sum_22
        - 8.0 * sigma_beta_squared_squared * sum_1_squared * sum_23 * sum_2_squared
        + 16.0 * sigma_beta_squared * sigma_path_squared * sum_25
        + 16.0 * sigma_beta_squared * sum_16**2 * sum_1_squared * sum_2_squared * term_1
        + 192.0 * baseline_squared * product_19 * product_23 * rho * sigma_beta * sum_26
        + 32.0 * rho * sigma_beta * sigma_path * sin_beta * sum_1 * sum_16 * sum_2 * sum_9 * term_1
        + 96.0 * baseline_squared * sigma_path_squared_squared * sin_beta_squared_squared * sum_8
    )
    result = _empty(arguments, (2, 2))
    result[..., 0, 0] = sum_11 * term_2
    result[..., 0, 1] = sum_20 * term_2
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = sum_27 * term_2
    return result


def posterior_estimate_second_order(
    *,
    path: npt.ArrayLike,
    beta: npt.ArrayLike,
    baseline: npt.ArrayLike,
    sigma_path: npt.ArrayLike,
    sigma_beta: npt.ArrayLike,
    rho: npt.ArrayLike,
) -> Floats:
    """Posterior mean of the position under a flat prior, to second order.

    Name: bistatic.posterior.estimate.second_order.
    Definition: e^L h to sigma^2.
    Conditioning: measurement-conditioned: the measured symbols stand for the measurement.
    Source: Duan et al. 2004 modified unbiased, doi:10.1109/TAES.2004.1386889.

    Args:
        path: length of the path from transmitter to target to receiver [m], 30000 to 1e+06.
        beta: azimuth at the receiver, counter-clockwise from the x axis, where the transmitter stands [rad], -3.1416 to 3.1416.
        baseline: distance from transmitter to receiver; less than the path [m], 1 to 20000.
        sigma_path: standard deviation of the error of path [m], 0.001 to 1000.
        sigma_beta: standard deviation of the error of beta [rad], 1e-09 to 0.1.
        rho: correlation of the errors of path and beta [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (2), unit m.

    Accuracy: at most 3.5 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
    """
    arguments = _floats(path, beta, baseline, sigma_path, sigma_beta, rho)
    path, beta, baseline, sigma_path, sigma_beta, rho = arguments
    cos_beta = np.cos(beta)
    divisor_1 = 2.0 * path - 2.0 * baseline * cos_beta
    term_1 = (baseline * cos_beta - path)**2
    sum_1 = baseline + path
    sum_2 = baseline - path
    baseline_squared = baseline**2
    sigma_path_squared = sigma_path**2
    sin_beta = np.sin(beta)
    sin_beta_squared = sin_beta**2
    path_squared = path**2
    product_1 = baseline * baseline_squared
    product_2 = path * path_squared
    sum_3 = (
        baseline_squared * path
        - 3.0 * baseline * cos_beta * path_squared
        + cos_beta * product_1
        + product_2
    )
    cos_beta_squared = cos_beta**2
    sigma_beta_squared = sigma_beta**2
    sum_4 = cos_beta * path - 2.0 * baseline + baseline * cos_beta_squared
    term_2 = 1.0 / (divisor_1 * divisor_1**2)
    sum_5 = (
        2.0 * path * sigma_beta_squared * sum_1 * sum_2 * sum_4
        - 4.0 * baseline_squared * cos_beta * sigma_path_squared * sin_beta_squared
        - 4.0 * cos_beta * sum_1 * sum_2 * term_1
        - 4.0 * rho * sigma_beta * sigma_path * sin_beta * sum_3
    )
    sum_6 = 2.0 * baseline_squared - baseline * cos_beta * path - path_squared
    sum_7 = (
        3.0 * baseline_squared * cos_beta * path
        - 2.0 * product_1
        - 3.0 * baseline * cos_beta_squared * path_squared
        + cos_beta * product_2
        + cos_beta_squared * product_1
    )
    sum_8 = (
        4.0 * rho * sigma_beta * sigma_path * sum_7
        - 2.0 * sigma_beta_squared * sin_beta * sum_1 * sum_2 * sum_6
        - 4.0 * baseline_squared * sigma_path_squared * sin_beta * sin_beta_squared
        - 4.0 * sin_beta * sum_1 * sum_2 * term_1
    )
    result = _empty(arguments, (2,))
    result[..., 0] = sum_5 * term_2
    result[..., 1] = sum_8 * term_2
    return result


def posterior_estimate_fourth_order(
    *,
    path: npt.ArrayLike,
    beta: npt.ArrayLike,
    baseline: npt.ArrayLike,
    sigma_path: npt.ArrayLike,
    sigma_beta: npt.ArrayLike,
    rho: npt.ArrayLike,
) -> Floats:
    """Posterior mean of the position under a flat prior, to fourth order.

    Name: bistatic.posterior.estimate.fourth_order.
    Definition: e^L h to sigma^4.
    Conditioning: measurement-conditioned: the measured symbols stand for the measurement.
    Source: Duan et al. 2004 modified unbiased, doi:10.1109/TAES.2004.1386889.

    Args:
        path: length of the path from transmitter to target to receiver [m], 30000 to 1e+06.
        beta: azimuth at the receiver, counter-clockwise from the x axis, where the transmitter stands [rad], -3.1416 to 3.1416.
        baseline: distance from transmitter to receiver; less than the path [m], 1 to 20000.
        sigma_path: standard deviation of the error of path [m], 0.001 to 1000.
        sigma_beta: standard deviation of the error of beta [rad], 1e-09 to 0.1.
        rho: correlation of the errors of path and beta [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (2), unit m.

    Accuracy: at most 4 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
    """
    arguments = _floats(path, beta, baseline, sigma_path, sigma_beta, rho)
    path, beta, baseline, sigma_path, sigma_beta, rho = arguments
    cos_beta = np.cos(beta)
    divisor_1 = 2.0 * path - 2.0 * baseline * cos_beta
    sum_1 = baseline * cos_beta - path
    sum_1_squared = sum_1**2
    sum_1_squared_squared = sum_1_squared**2
    sum_2 = baseline + path
    sum_3 = baseline - path
    path_squared = path**2
    baseline_squared = baseline**2
    product_1 = baseline * baseline_squared
    product_2 = path * path_squared
    sin_beta = np.sin(beta)
    sum_4 = (
        baseline_squared * path
        - 3.0 * baseline * cos_beta * path_squared
        + cos_beta * product_1
        + product_2
    )
    cos_beta_squared = cos_beta**2
    product_3 = cos_beta * cos_beta_squared
    cos_beta_squared_squared = cos_beta_squared**2
    product_4 = cos_beta * product_2
    sigma_beta_squared = sigma_beta**2
    sigma_beta_squared_squared = sigma_beta_squared**2
    sum_5 = (
        11.0 * baseline_squared * path * product_3
        - 20.0 * baseline_squared * cos_beta * path
        - 20.0 * cos_beta_squared * product_1
        - 8.0 * baseline * path_squared
        + 11.0 * baseline * cos_beta_squared * path_squared
        + 24.0 * product_1
        + cos_beta_squared_squared * product_1
        + product_4
    )
    sigma_path_squared = sigma_path**2
    sigma_path_squared_squared = sigma_path_squared**2
    sin_beta_squared = sin_beta**2
    sum_6 = (
        13.0 * baseline * cos_beta_squared * path
        - 3.0 * baseline * cos_beta_squared_squared * path
        - 6.0 * baseline * path
        - 6.0 * baseline_squared * cos_beta
        - 9.0 * path_squared * product_3
        + 4.0 * baseline_squared * product_3
        + 7.0 * cos_beta * path_squared
    )
    rho_squared = rho**2
    sum_7 = (
        2.0 * baseline * path
        - 2.0 * baseline * path * sin_beta_squared
        - baseline_squared * cos_beta
        - cos_beta * path_squared
        + baseline_squared * cos_beta * sin_beta_squared
    )
    product_5 = sigma_path * sigma_path_squared
    sum_8 = 3.0 * cos_beta_squared * path - 3.0 * baseline * cos_beta - path + baseline * product_3
    sum_9 = cos_beta * path - 2.0 * baseline + baseline * cos_beta_squared
    baseline_squared_squared = baseline_squared**2
    path_squared_squared = path_squared**2
    product_6 = baseline * baseline_squared**2
    product_7 = path * path_squared**2
    product_8 = sigma_beta * sigma_beta_squared
    sum_10 = (
        11.0 * baseline_squared_squared * cos_beta_squared * path
        - 17.0 * baseline_squared * cos_beta_squared * product_2
        - 18.0 * baseline_squared_squared * path
        - 3.0 * path_squared * product_1 * product_3
        - 5.0 * baseline * cos_beta * path_squared_squared
        - 6.0 * cos_beta * product_6
        + 29.0 * cos_beta * path_squared * product_1
        + 7.0 * baseline_squared * product_2
        + product_3 * product_6
        + product_7
    )
    term_1 = 1.0 / (divisor_1 * (divisor_1**2)**2)
    sum_11 = (
        16.0 * baseline_squared * rho_squared * sigma_beta_squared * sigma_path_squared * sum_6
        - 16.0 * cos_beta * sum_1_squared_squared * sum_2 * sum_3
        - 16.0 * rho * sigma_beta * sigma_path * sin_beta * sum_1_squared * sum_4
        - 2.0 * path * sigma_beta_squared_squared * sum_2 * sum_3 * sum_5
        - 48.0 * baseline_squared * cos_beta * sigma_path_squared_squared * sin_beta_squared
        + 16.0 * baseline_squared * sigma_path_squared * sin_beta_squared * sum_7
        + 48.0 * baseline_squared * product_5 * rho * sigma_beta * sin_beta * sum_8
        + 8.0 * baseline_squared * sigma_beta_squared * sigma_path_squared * sum_6
        + 8.0 * product_8 * rho * sigma_path * sin_beta * sum_10
        + 8.0 * path * sigma_beta_squared * sum_1_squared * sum_2 * sum_3 * sum_9
    )
    sum_12 = 3.0 * baseline - 3.0 * cos_beta * path + baseline * sin_beta_squared
    product_9 = sin_beta * sin_beta_squared
    sum_13 = (
        19.0 * baseline_squared_squared * path * product_3
        - 17.0 * baseline_squared * product_2 * product_3
        - 20.0 * cos_beta_squared * product_6
        - 20.0 * path_squared * product_1
        - 3.0 * cos_beta_squared_squared * path_squared * product_1
        - 32.0 * baseline_squared_squared * cos_beta * path
        - 5.0 * baseline * cos_beta_squared * path_squared_squared
        + 21.0 * baseline_squared * cos_beta * product_2
        + 24.0 * product_6
        + 31.0 * cos_beta_squared * path_squared * product_1
        + cos_beta * product_7
        + cos_beta_squared_squared * product_6
    )
    sum_14 = 2.0 * baseline_squared - baseline * cos_beta * path - path_squared
    sum_15 = (
        2.0 * baseline * cos_beta * path
        - baseline_squared
        - path_squared
        + baseline_squared * sin_beta_squared
    )
    sum_16 = (
        3.0 * baseline_squared * cos_beta * path
        - 2.0 * product_1
        - 3.0 * baseline * cos_beta_squared * path_squared
        + cos_beta_squared * product_1
        + product_4
    )
    sum_17 = (
        20.0 * baseline_squared * path_squared
        - 11.0 * baseline_squared * cos_beta_squared * path_squared
        - 11.0 * baseline * cos_beta * product_2
        - 24.0 * baseline_squared_squared
        - path_squared_squared
        - path * product_1 * product_3
        + 20.0 * cos_beta * path * product_1
        + 8.0 * baseline_squared_squared * cos_beta_squared
    )
    sum_18 = (
        2.0 * baseline_squared * cos_beta_squared
        - 3.0 * cos_beta_squared * path_squared
        - 4.0 * baseline_squared
        - baseline * path * product_3
        + 5.0 * baseline * cos_beta * path
        + path_squared
    )
    sum_19 = (
        16.0 * baseline_squared * product_9 * sigma_path_squared * sum_15
        - 16.0 * sin_beta * sum_1_squared_squared * sum_2 * sum_3
        - 48.0 * baseline_squared * product_5 * rho * sigma_beta * sin_beta_squared * sum_12
        - 48.0 * baseline_squared * product_9 * sigma_path_squared_squared
        - 8.0 * product_8 * rho * sigma_path * sum_13
        - 8.0 * sigma_beta_squared * sin_beta * sum_14 * sum_1_squared * sum_2 * sum_3
        + 16.0 * rho * sigma_beta * sigma_path * sum_16 * sum_1_squared
        + 2.0 * sigma_beta_squared_squared * sin_beta * sum_17 * sum_2 * sum_3
        + 24.0 * baseline_squared * sigma_beta_squared * sigma_path_squared * sin_beta * sum_18
        + 48.0 * baseline_squared * rho_squared * sigma_beta_squared * sigma_path_squared * sin_beta * sum_18
    )
    result = _empty(arguments, (2,))
    result[..., 0] = sum_11 * term_1
    result[..., 1] = sum_19 * term_1
    return result


def posterior_covariance_second_order(
    *,
    path: npt.ArrayLike,
    beta: npt.ArrayLike,
    baseline: npt.ArrayLike,
    sigma_path: npt.ArrayLike,
    sigma_beta: npt.ArrayLike,
    rho: npt.ArrayLike,
) -> Floats:
    """Posterior covariance of the position under a flat prior, to second order.

    Name: bistatic.posterior.covariance.second_order.
    Definition: e^L(h h') - (e^L h)(e^L h)' to sigma^2.
    Conditioning: measurement-conditioned: the measured symbols stand for the measurement.
    Source: Duan et al. 2004 modified unbiased, doi:10.1109/TAES.2004.1386889.

    Args:
        path: length of the path from transmitter to target to receiver [m], 30000 to 1e+06.
        beta: azimuth at the receiver, counter-clockwise from the x axis, where the transmitter stands [rad], -3.1416 to 3.1416.
        baseline: distance from transmitter to receiver; less than the path [m], 1 to 20000.
        sigma_path: standard deviation of the error of path [m], 0.001 to 1000.
        sigma_beta: standard deviation of the error of beta [rad], 1e-09 to 0.1.
        rho: correlation of the errors of path and beta [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (2, 2), unit m^2.

    Accuracy: at most 9 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
    """
    arguments = _floats(path, beta, baseline, sigma_path, sigma_beta, rho)
    path, beta, baseline, sigma_path, sigma_beta, rho = arguments
    cos_beta = np.cos(beta)
    divisor_1 = 2.0 * path - 2.0 * baseline * cos_beta
    sum_1 = baseline + path
    sum_1_squared = sum_1**2
    sum_2 = baseline - path
    sum_2_squared = sum_2**2
    path_squared = path**2
    sigma_beta_squared = sigma_beta**2
    sin_beta = np.sin(beta)
    sin_beta_squared = sin_beta**2
    baseline_squared = baseline**2
    sum_3 = baseline_squared - 2.0 * baseline * cos_beta * path + path_squared
    sum_3_squared = sum_3**2
    cos_beta_squared = cos_beta**2
    sigma_path_squared = sigma_path**2
    term_1 = 1.0 / (divisor_1**2)**2
    sum_4 = (
        4.0 * cos_beta_squared * sigma_path_squared * sum_3_squared
        + 4.0 * path_squared * sigma_beta_squared * sin_beta_squared * sum_1_squared * sum_2_squared
        + 8.0 * cos_beta * path * rho * sigma_beta * sigma_path * sin_beta * sum_1 * sum_2 * sum_3
    )
    sum_5 = baseline - cos_beta * path
    sum_6 = baseline * cos_beta - 2.0 * cos_beta_squared * path + path
    sum_7 = (
        4.0 * cos_beta * sigma_path_squared * sin_beta * sum_3_squared
        + 4.0 * path * sigma_beta_squared * sin_beta * sum_1_squared * sum_2_squared * sum_5
        + 4.0 * rho * sigma_beta * sigma_path * sum_1 * sum_2 * sum_3 * sum_6
    )
    sum_8 = (
        6.0 * baseline_squared * path_squared
        - 4.0 * baseline * baseline_squared * cos_beta * path
        - 4.0 * baseline_squared * path_squared * sin_beta_squared
        - 4.0 * baseline * cos_beta * path * path_squared
        + baseline_squared**2
        + path_squared**2
    )
    sum_9 = (
        4.0 * sigma_beta_squared * sum_1_squared * sum_2_squared * sum_5**2
        + 4.0 * sigma_path_squared * sin_beta_squared * sum_8
        + 8.0 * rho * sigma_beta * sigma_path * sin_beta * sum_1 * sum_2 * sum_3 * sum_5
    )
    result = _empty(arguments, (2, 2))
    result[..., 0, 0] = sum_4 * term_1
    result[..., 0, 1] = sum_7 * term_1
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = sum_9 * term_1
    return result


def posterior_covariance_fourth_order(
    *,
    path: npt.ArrayLike,
    beta: npt.ArrayLike,
    baseline: npt.ArrayLike,
    sigma_path: npt.ArrayLike,
    sigma_beta: npt.ArrayLike,
    rho: npt.ArrayLike,
) -> Floats:
    """Posterior covariance of the position under a flat prior, to fourth order.

    Name: bistatic.posterior.covariance.fourth_order.
    Definition: e^L(h h') - (e^L h)(e^L h)' to sigma^4.
    Conditioning: measurement-conditioned: the measured symbols stand for the measurement.
    Source: Duan et al. 2004 modified unbiased, doi:10.1109/TAES.2004.1386889.

    Args:
        path: length of the path from transmitter to target to receiver [m], 30000 to 1e+06.
        beta: azimuth at the receiver, counter-clockwise from the x axis, where the transmitter stands [rad], -3.1416 to 3.1416.
        baseline: distance from transmitter to receiver; less than the path [m], 1 to 20000.
        sigma_path: standard deviation of the error of path [m], 0.001 to 1000.
        sigma_beta: standard deviation of the error of beta [rad], 1e-09 to 0.1.
        rho: correlation of the errors of path and beta [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (2, 2), unit m^2.

    Accuracy: at most 9.5 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
    """
    arguments = _floats(path, beta, baseline, sigma_path, sigma_beta, rho)
    path, beta, baseline, sigma_path, sigma_beta, rho = arguments
    cos_beta = np.cos(beta)
    divisor_1 = 2.0 * path - 2.0 * baseline * cos_beta
    sum_1 = baseline + path
    sum_1_squared = sum_1**2
    sum_2 = baseline - path
    sum_2_squared = sum_2**2
    baseline_squared = baseline**2
    path_squared = path**2
    sin_beta = np.sin(beta)
    sin_beta_squared = sin_beta**2
    product_1 = baseline_squared * sin_beta_squared
    sigma_beta_squared = sigma_beta**2
    sum_3 = 2.0 * baseline * cos_beta * path - baseline_squared - path_squared + product_1
    cos_beta_squared = cos_beta**2
    product_2 = cos_beta * cos_beta_squared
    product_3 = path * path_squared**2
    product_4 = -18.0 * baseline * product_2 * product_3
    product_5 = baseline * baseline_squared**2
    baseline_squared_squared = baseline_squared**2
    cos_beta_squared_squared = cos_beta_squared**2
    product_6 = baseline * baseline_squared
    product_7 = path * path_squared
    baseline_squared_cubed = baseline_squared * baseline_squared**2
    product_8 = cos_beta * cos_beta_squared**2
    product_9 = -6.0 * path * product_5 * product_8
    path_squared_squared = path_squared**2
    path_squared_cubed = path_squared * path_squared**2
    product_10 = 14.0 * product_6 * product_7 * product_8
    product_11 = 3.0 * cos_beta_squared * path_squared_cubed
    product_12 = 33.0 * baseline_squared * cos_beta_squared_squared * path_squared_squared
    product_13 = 6.0 * baseline * cos_beta * product_3
    rho_squared = rho**2
    sigma_path_squared = sigma_path**2
    sum_4 = (
        2.0 * baseline_squared * path_squared_squared
        - 22.0 * cos_beta * path * product_5
        - 40.0 * baseline_squared_squared * cos_beta_squared_squared * path_squared
        - 46.0 * product_2 * product_6 * product_7
        - 5.0 * baseline_squared_cubed * cos_beta_squared
        - 5.0 * baseline_squared_squared * path_squared
        - 9.0 * baseline_squared * cos_beta_squared * path_squared_squared
        - path_squared_cubed
        + 3.0 * baseline_squared_cubed * cos_beta_squared_squared
        + 32.0 * path * product_2 * product_5
        + 51.0 * baseline_squared_squared * cos_beta_squared * path_squared
        + 8.0 * cos_beta * product_6 * product_7
        + product_10
        + product_11
        + product_12
        + product_13
        + product_4
        + product_9
    )
    product_14 = -12.0 * baseline * product_2 * product_3
    product_15 = -2.0 * path * product_5 * product_8
    product_16 = -3.0 * baseline_squared_squared * path_squared
    product_17 = 2.0 * baseline_squared_cubed * cos_beta_squared_squared
    product_18 = 2.0 * cos_beta_squared * path_squared_cubed
    product_19 = 20.0 * baseline_squared * cos_beta_squared_squared * path_squared_squared
    product_20 = 6.0 * product_6 * product_7 * product_8
    sum_5 = (
        14.0 * path * product_2 * product_5
        - 10.0 * cos_beta * path * product_5
        - 22.0 * baseline_squared_squared * cos_beta_squared_squared * path_squared
        - 22.0 * product_2 * product_6 * product_7
        - 3.0 * baseline_squared_cubed * cos_beta_squared
        - 7.0 * baseline_squared * cos_beta_squared * path_squared_squared
        - path_squared_cubed
        + 28.0 * baseline_squared_squared * cos_beta_squared * path_squared
        + 4.0 * cos_beta * product_6 * product_7
        + product_13
        + product_14
        + product_15
        + product_16
        + product_17
        + product_18
        + product_19
        + product_20
    )
    product_21 = sigma_beta * sigma_beta_squared
    sum_6 = (
        15.0 * baseline_squared * cos_beta * path_squared
        - 11.0 * baseline_squared * path_squared * product_2
        - 2.0 * baseline * product_7
        - 7.0 * baseline * cos_beta_squared * product_7
        - 8.0 * baseline_squared_squared * cos_beta
        - 8.0 * path * product_6
        - cos_beta_squared_squared * path * product_6
        + 16.0 * cos_beta_squared * path * product_6
        + 3.0 * baseline_squared_squared * product_2
        + 3.0 * cos_beta * path_squared_squared
    )
    product_22 = sigma_path * sigma_path_squared
    sum_7 = (
        13.0 * baseline_squared * cos_beta_squared * path
        - 12.0 * baseline * path_squared * product_2
        - 4.0 * baseline_squared * path
        - 4.0 * cos_beta * product_6
        - product_7
        + 3.0 * baseline * cos_beta * path_squared
        + 4.0 * cos_beta_squared * product_7
        + product_2 * product_6
    )
    sum_8 = baseline_squared - 2.0 * baseline * cos_beta * path + path_squared
    sum_8_squared = sum_8**2
    product_23 = baseline * cos_beta
    term_1 = (product_23 - path)**2
    sigma_path_squared_squared = sigma_path_squared**2
    sum_9 = (
        6.0 * baseline * cos_beta * path
        - 3.0 * path_squared
        - 4.0 * baseline_squared
        + baseline_squared * cos_beta_squared
    )
    sigma_beta_squared_squared = sigma_beta_squared**2
    sum_10 = (
        10.0 * baseline * path * product_2
        - 12.0 * baseline * cos_beta * path
        - 18.0 * baseline_squared * cos_beta_squared
        - 2.0 * path_squared
        + 16.0 * baseline_squared
        + 3.0 * baseline_squared * cos_beta_squared_squared
        + 3.0 * cos_beta_squared * path_squared
    )
    term_2 = 1.0 / (divisor_1 * divisor_1**2)**2
    sum_11 = (
        16.0 * cos_beta_squared * sigma_path_squared * sum_8_squared * term_1
        - 16.0 * path_squared * sigma_beta_squared * sin_beta_squared * sum_1_squared * sum_2_squared * sum_3
        - 16.0 * rho_squared * sigma_beta_squared * sigma_path_squared * sum_4
        - 16.0 * sigma_beta_squared * sigma_path_squared * sum_5
        - 32.0 * path * product_21 * rho * sigma_path * sin_beta * sum_1 * sum_2 * sum_6
        - 64.0 * baseline_squared * cos_beta * product_22 * rho * sigma_beta * sin_beta * sum_7
        + 32.0 * baseline_squared * (1.0 + cos_beta) * (cos_beta - 1.0) * cos_beta_squared * sigma_path_squared_squared * sum_9
        + 32.0 * cos_beta * path * rho * sigma_beta * sigma_path * sin_beta * sum_1 * sum_2 * sum_8 * term_1
        + 8.0 * path_squared * sigma_beta_squared_squared * sum_10 * sum_1_squared * sum_2_squared
    )
    sum_12 = (
        14.0 * cos_beta_squared_squared * product_6 * product_7
        - 16.0 * baseline_squared_cubed * cos_beta
        - 16.0 * path * product_5
        - 18.0 * baseline * cos_beta_squared * product_3
        - 46.0 * cos_beta_squared * product_6 * product_7
        - 50.0 * baseline_squared_squared * path_squared * product_2
        - 6.0 * cos_beta_squared_squared * path * product_5
        + 3.0 * cos_beta * path_squared_cubed
        + 33.0 * baseline_squared * path_squared_squared * product_2
        + 35.0 * baseline_squared_squared * cos_beta * path_squared
        + 4.0 * product_6 * product_7
        + 5.0 * baseline_squared_cubed * product_2
        + 52.0 * cos_beta_squared * path * product_5
        + 6.0 * baseline_squared * cos_beta * path_squared_squared
    )
    sum_13 = (
        10.0 * baseline_squared * path_squared_squared * product_2
        - 13.0 * baseline_squared_squared * path_squared * product_2
        - 13.0 * cos_beta_squared * product_6 * product_7
        - 4.0 * baseline_squared_cubed * cos_beta
        - 4.0 * path * product_5
        - 6.0 * baseline * cos_beta_squared * product_3
        - cos_beta_squared_squared * path * product_5
        + 10.0 * baseline_squared_squared * cos_beta * path_squared
        + 13.0 * cos_beta_squared * path * product_5
        + 3.0 * baseline_squared * cos_beta * path_squared_squared
        + 3.0 * cos_beta_squared_squared * product_6 * product_7
        + baseline_squared_cubed * product_2
        + cos_beta * path_squared_cubed
    )
    sum_14 = (
        18.0 * baseline_squared * cos_beta * path
        - 10.0 * baseline * cos_beta_squared * path_squared
        - 16.0 * product_6
        - 3.0 * baseline_squared * path * product_2
        - 3.0 * cos_beta * product_7
        + 7.0 * cos_beta_squared * product_6
        + 7.0 * baseline * path_squared
    )
    sum_15 = (
        103.0 * cos_beta * path_squared * product_6
        - 12.0 * cos_beta_squared * product_3
        - 16.0 * cos_beta * product_5
        - 20.0 * baseline_squared_squared * cos_beta_squared_squared * path
        - 3.0 * baseline * cos_beta * path_squared_squared
        - 48.0 * baseline_squared_squared * path
        - 80.0 * baseline_squared * cos_beta_squared * product_7
        - 95.0 * path_squared * product_2 * product_6
        + 11.0 * product_2 * product_5
        + 2.0 * baseline_squared * product_7
        + 28.0 * baseline * path_squared_squared * product_2
        + 4.0 * path_squared * product_6 * product_8
        + 44.0 * baseline_squared * cos_beta_squared_squared * product_7
        + 6.0 * product_3
        + 76.0 * baseline_squared_squared * cos_beta_squared * path
    )
    sum_16 = baseline - cos_beta * path
    sum_17 = path - 2.0 * cos_beta_squared * path + product_23
    sum_18 = (
        10.0 * cos_beta * product_6
        - 24.0 * baseline * cos_beta * path_squared * sin_beta_squared
        - 27.0 * baseline_squared * path
        - 7.0 * product_7
        + 2.0 * cos_beta * product_6 * sin_beta_squared
        + 24.0 * baseline * cos_beta * path_squared
        + 31.0 * baseline_squared * path * sin_beta_squared
        + 8.0 * product_7 * sin_beta_squared
    )
    product_24 = sin_beta * sin_beta_squared
    sum_19 = (
        3.0 * baseline_squared * cos_beta
        - 6.0 * baseline * path
        + 3.0 * cos_beta * path_squared
        + 6.0 * baseline * path * sin_beta_squared
        + baseline_squared * cos_beta * sin_beta_squared
    )
    sum_20 = (
        16.0 * cos_beta * sigma_path_squared * sin_beta * sum_8_squared * term_1
        - 16.0 * rho_squared * sigma_beta_squared * sigma_path_squared * sin_beta * sum_12
        - 32.0 * sigma_beta_squared * sigma_path_squared * sin_beta * sum_13
        - 8.0 * product_21 * rho * sigma_path * sum_1 * sum_15 * sum_2
        - 8.0 * path * sigma_beta_squared_squared * sin_beta * sum_14 * sum_1_squared * sum_2_squared
        + 16.0 * path * sigma_beta_squared * sin_beta * sum_16 * sum_1_squared * sum_2_squared * term_1
        + 16.0 * rho * sigma_beta * sigma_path * sum_1 * sum_17 * sum_2 * sum_8 * term_1
        + 32.0 * baseline_squared * product_22 * rho * sigma_beta * sin_beta_squared * sum_18
        + 32.0 * baseline_squared * product_24 * sigma_path_squared_squared * sum_19
    )
    sin_beta_squared_squared = sin_beta_squared**2
    sum_21 = (
        13.0 * baseline_squared * path_squared_squared * sin_beta_squared
        - 12.0 * cos_beta * product_6 * product_7 * sin_beta_squared
        - 15.0 * baseline_squared * path_squared_squared
        - 15.0 * baseline_squared_squared * path_squared
        - 4.0 * baseline_squared_squared * path_squared * sin_beta_squared_squared
        - 4.0 * cos_beta * path * product_5 * sin_beta_squared
        - baseline_squared_cubed
        - path_squared_cubed
        + 18.0 * baseline_squared_squared * path_squared * sin_beta_squared
        + 20.0 * cos_beta * product_6 * product_7
        + 6.0 * cos_beta * path * product_5
        + baseline_squared_cubed * sin_beta_squared
        + product_13
    )
    sum_22 = (
        10.0 * baseline * product_2 * product_7
        - 12.0 * baseline * cos_beta * product_7
        - 14.0 * path * product_2 * product_6
        - 16.0 * baseline_squared_squared
        - 21.0 * baseline_squared * cos_beta_squared * path_squared
        - path_squared_squared
        + 12.0 * baseline_squared * path_squared
        + 12.0 * baseline_squared_squared * cos_beta_squared
        + 24.0 * cos_beta * path * product_6
        + 3.0 * baseline_squared * cos_beta_squared_squared * path_squared
        + 3.0 * cos_beta_squared * path_squared_squared
    )
    sum_23 = (
        12.0 * baseline * cos_beta * product_3
        - 12.0 * baseline_squared * cos_beta_squared * path_squared_squared
        - 12.0 * baseline_squared_squared * path_squared
        - 2.0 * path_squared_cubed
        - 38.0 * baseline_squared_cubed * cos_beta_squared
        - 6.0 * baseline_squared * path_squared_squared
        - 60.0 * baseline_squared_squared * cos_beta_squared_squared * path_squared
        - 60.0 * product_2 * product_6 * product_7
        - 78.0 * cos_beta * path * product_5
        + 26.0 * cos_beta * product_6 * product_7
        + 32.0 * baseline_squared_cubed
        + 7.0 * baseline_squared_cubed * cos_beta_squared_squared
        + 78.0 * path * product_2 * product_5
        + 87.0 * baseline_squared_squared * cos_beta_squared * path_squared
        + product_10
        + product_11
        + product_12
        + product_4
        + product_9
    )
    sum_24 = (
        11.0 * product_5 * sin_beta_squared
        - 14.0 * baseline_squared_squared * cos_beta * path * sin_beta_squared
        - 2.0 * path_squared * product_6 * sin_beta_squared_squared
        - 21.0 * baseline * path_squared_squared
        - 57.0 * path_squared * product_6 * sin_beta_squared
        - 60.0 * baseline_squared_squared * cos_beta * path
        + 14.0 * baseline * path_squared_squared * sin_beta_squared
        + 21.0 * product_5
        + 22.0 * baseline_squared * cos_beta * product_7 * sin_beta_squared
        + 48.0 * path_squared * product_6
        + 6.0 * baseline_squared * cos_beta * product_7
        + 6.0 * cos_beta * product_3
    )
    sum_25 = (
        10.0 * cos_beta * product_6 * product_7
        - 17.0 * baseline_squared_cubed * cos_beta_squared
        - 30.0 * baseline_squared_squared * cos_beta_squared_squared * path_squared
        - 36.0 * product_2 * product_6 * product_7
        - 4.0 * baseline_squared * path_squared_squared
        - 44.0 * cos_beta * path * product_5
        - baseline_squared * cos_beta_squared * path_squared_squared
        - path_squared_cubed
        + 16.0 * baseline_squared_cubed
        + 40.0 * path * product_2 * product_5
        + 48.0 * baseline_squared_squared * cos_beta_squared * path_squared
        + product_13
        + product_14
        + product_15
        + product_16
        + product_17
        + product_18
        + product_19
        + product_20
    )
    sum_26 = 3.0 * baseline_squared - 6.0 * baseline * cos_beta * path + 3.0 * path_squared + product_1
    sum_27 = (
        15.0 * baseline * path_squared
        - 12.0 * baseline * path_squared * sin_beta_squared
        - 18.0 * baseline_squared * cos_beta * path
        - 4.0 * cos_beta * product_7
        + 7.0 * product_6
        + product_6 * sin_beta_squared
    )
    sum_28 = (
        16.0 * product_21 * rho * sigma_path * sin_beta * sum_1 * sum_2 * sum_24
        - 16.0 * sigma_path_squared * sin_beta_squared * sum_21
        - 8.0 * sigma_beta_squared_squared * sum_1_squared * sum_22 * sum_2_squared
        + 16.0 * rho_squared * sigma_beta_squared * sigma_path_squared * sum_23
        + 16.0 * sigma_beta_squared * sigma_path_squared * sum_25
        + 16.0 * sigma_beta_squared * sum_16**2 * sum_1_squared * sum_2_squared * term_1
        + 32.0 * baseline_squared * sigma_path_squared_squared * sin_beta_squared_squared * sum_26
        + 32.0 * rho * sigma_beta * sigma_path * sin_beta * sum_1 * sum_16 * sum_2 * sum_8 * term_1
        + 64.0 * baseline_squared * product_22 * product_24 * rho * sigma_beta * sum_27
    )
    result = _empty(arguments, (2, 2))
    result[..., 0, 0] = sum_11 * term_2
    result[..., 0, 1] = sum_20 * term_2
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = sum_28 * term_2
    return result


def decorrelated_covariance_second_order(
    *,
    path: npt.ArrayLike,
    beta: npt.ArrayLike,
    baseline: npt.ArrayLike,
    sigma_path: npt.ArrayLike,
    sigma_beta: npt.ArrayLike,
    rho: npt.ArrayLike,
    predicted_sigma_path: npt.ArrayLike,
    predicted_sigma_beta: npt.ArrayLike,
    predicted_rho: npt.ArrayLike,
) -> Floats:
    """Covariance of the unbiased estimate u, averaged over a prediction, to second order.

    Name: bistatic.decorrelated.covariance.second_order.
    Definition: e^Lp [e^L(u u') - h h'] to sigma^2.
    Conditioning: averaged over a prediction: the measured symbols stand for the predicted mean.
    Source: Bordonaro et al. 2014 decorrelated; Mo et al. 1998 R_m where Kp = K, R_t where Kp = 0,
    doi:10.1109/TAES.2014.120563, doi:10.1109/7.705921.

    Args:
        path: length of the path from transmitter to target to receiver [m], 30000 to 1e+06.
        beta: azimuth at the receiver, counter-clockwise from the x axis, where the transmitter stands [rad], -3.1416 to 3.1416.
        baseline: distance from transmitter to receiver; less than the path [m], 1 to 20000.
        sigma_path: standard deviation of the error of path [m], 0.001 to 1000.
        sigma_beta: standard deviation of the error of beta [rad], 1e-09 to 0.1.
        rho: correlation of the errors of path and beta [1], -1 to 1.
        predicted_sigma_path: standard deviation of the prediction of path [m], 0.001 to 1000.
        predicted_sigma_beta: standard deviation of the prediction of beta [rad], 1e-09 to 0.1.
        predicted_rho: correlation of the predictions of path and beta [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (2, 2), unit m^2.

    Accuracy: at most 9 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
    """
    arguments = _floats(path, beta, baseline, sigma_path, sigma_beta, rho, predicted_sigma_path, predicted_sigma_beta, predicted_rho)
    path, beta, baseline, sigma_path, sigma_beta, rho, predicted_sigma_path, predicted_sigma_beta, predicted_rho = arguments
    cos_beta = np.cos(beta)
    divisor_1 = 2.0 * path - 2.0 * baseline * cos_beta
    sum_1 = baseline + path
    sum_1_squared = sum_1**2
    sum_2 = baseline - path
    sum_2_squared = sum_2**2
    path_squared = path**2
    sigma_beta_squared = sigma_beta**2
    sin_beta = np.sin(beta)
    sin_beta_squared = sin_beta**2
    baseline_squared = baseline**2
    sum_3 = baseline_squared - 2.0 * baseline * cos_beta * path + path_squared
    sum_3_squared = sum_3**2
    cos_beta_squared = cos_beta**2
    sigma_path_squared = sigma_path**2
    term_1 = 1.0 / (divisor_1**2)**2
    sum_4 = (
        4.0 * cos_beta_squared * sigma_path_squared * sum_3_squared
        + 4.0 * path_squared * sigma_beta_squared * sin_beta_squared * sum_1_squared * sum_2_squared
        + 8.0 * cos_beta * path * rho * sigma_beta * sigma_path * sin_beta * sum_1 * sum_2 * sum_3
    )
    sum_5 = baseline - cos_beta * path
    sum_6 = baseline * cos_beta - 2.0 * cos_beta_squared * path + path
    sum_7 = (
        4.0 * cos_beta * sigma_path_squared * sin_beta * sum_3_squared
        + 4.0 * path * sigma_beta_squared * sin_beta * sum_1_squared * sum_2_squared * sum_5
        + 4.0 * rho * sigma_beta * sigma_path * sum_1 * sum_2 * sum_3 * sum_6
    )
    sum_8 = (
        6.0 * baseline_squared * path_squared
        - 4.0 * baseline * baseline_squared * cos_beta * path
        - 4.0 * baseline_squared * path_squared * sin_beta_squared
        - 4.0 * baseline * cos_beta * path * path_squared
        + baseline_squared**2
        + path_squared**2
    )
    sum_9 = (
        4.0 * sigma_beta_squared * sum_1_squared * sum_2_squared * sum_5**2
        + 4.0 * sigma_path_squared * sin_beta_squared * sum_8
        + 8.0 * rho * sigma_beta * sigma_path * sin_beta * sum_1 * sum_2 * sum_3 * sum_5
    )
    result = _empty(arguments, (2, 2))
    result[..., 0, 0] = sum_4 * term_1
    result[..., 0, 1] = sum_7 * term_1
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = sum_9 * term_1
    return result


def decorrelated_covariance_fourth_order(
    *,
    path: npt.ArrayLike,
    beta: npt.ArrayLike,
    baseline: npt.ArrayLike,
    sigma_path: npt.ArrayLike,
    sigma_beta: npt.ArrayLike,
    rho: npt.ArrayLike,
    predicted_sigma_path: npt.ArrayLike,
    predicted_sigma_beta: npt.ArrayLike,
    predicted_rho: npt.ArrayLike,
) -> Floats:
    """Covariance of the unbiased estimate u, averaged over a prediction, to fourth order.

    Name: bistatic.decorrelated.covariance.fourth_order.
    Definition: e^Lp [e^L(u u') - h h'] to sigma^4.
    Conditioning: averaged over a prediction: the measured symbols stand for the predicted mean.
    Source: Bordonaro et al. 2014 decorrelated; Mo et al. 1998 R_m where Kp = K, R_t where Kp = 0,
    doi:10.1109/TAES.2014.120563, doi:10.1109/7.705921.

    Args:
        path: length of the path from transmitter to target to receiver [m], 30000 to 1e+06.
        beta: azimuth at the receiver, counter-clockwise from the x axis, where the transmitter stands [rad], -3.1416 to 3.1416.
        baseline: distance from transmitter to receiver; less than the path [m], 1 to 20000.
        sigma_path: standard deviation of the error of path [m], 0.001 to 1000.
        sigma_beta: standard deviation of the error of beta [rad], 1e-09 to 0.1.
        rho: correlation of the errors of path and beta [1], -1 to 1.
        predicted_sigma_path: standard deviation of the prediction of path [m], 0.001 to 1000.
        predicted_sigma_beta: standard deviation of the prediction of beta [rad], 1e-09 to 0.1.
        predicted_rho: correlation of the predictions of path and beta [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (2, 2), unit m^2.

    Accuracy: at most 10 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
    """
    arguments = _floats(path, beta, baseline, sigma_path, sigma_beta, rho, predicted_sigma_path, predicted_sigma_beta, predicted_rho)
    path, beta, baseline, sigma_path, sigma_beta, rho, predicted_sigma_path, predicted_sigma_beta, predicted_rho = arguments
    cos_beta = np.cos(beta)
    divisor_1 = 2.0 * path - 2.0 * baseline * cos_beta
    sum_1 = baseline + path
    sum_1_squared = sum_1**2
    sum_2 = baseline - path
    sum_2_squared = sum_2**2
    baseline_squared = baseline**2
    path_squared = path**2
    sin_beta = np.sin(beta)
    sin_beta_squared = sin_beta**2
    sigma_beta_squared = sigma_beta**2
    sum_3 = (
        2.0 * baseline * cos_beta * path
        - baseline_squared
        - path_squared
        + baseline_squared * sin_beta_squared
    )
    cos_beta_squared = cos_beta**2
    product_1 = cos_beta * cos_beta_squared
    product_2 = path * path_squared**2
    product_3 = -12.0 * baseline * product_1 * product_2
    baseline_squared_squared = baseline_squared**2
    cos_beta_squared_squared = cos_beta_squared**2
    product_4 = baseline * baseline_squared
    product_5 = path * path_squared
    path_squared_squared = path_squared**2
    product_6 = -2.0 * baseline_squared * path_squared_squared
    product_7 = baseline * baseline_squared**2
    product_8 = cos_beta * cos_beta_squared**2
    product_9 = -2.0 * path * product_7 * product_8
    baseline_squared_cubed = baseline_squared * baseline_squared**2
    product_10 = -3.0 * baseline_squared_cubed * cos_beta_squared
    product_11 = -6.0 * cos_beta * path * product_7
    path_squared_cubed = path_squared * path_squared**2
    product_12 = 10.0 * path * product_1 * product_7
    product_13 = 14.0 * baseline_squared * cos_beta_squared_squared * path_squared_squared
    product_14 = 2.0 * baseline_squared_cubed * cos_beta_squared_squared
    product_15 = 2.0 * cos_beta_squared * path_squared_cubed
    product_16 = 6.0 * product_4 * product_5 * product_8
    product_17 = 6.0 * baseline * cos_beta * product_2
    predicted_sigma_beta_squared = predicted_sigma_beta**2
    sigma_path_squared = sigma_path**2
    sum_4 = (
        20.0 * baseline_squared_squared * cos_beta_squared * path_squared
        - 16.0 * baseline_squared_squared * cos_beta_squared_squared * path_squared
        - 18.0 * product_1 * product_4 * product_5
        - baseline_squared_squared * path_squared
        - path_squared_cubed
        + baseline_squared * cos_beta_squared * path_squared_squared
        + product_10
        + product_11
        + product_12
        + product_13
        + product_14
        + product_15
        + product_16
        + product_17
        + product_3
        + product_6
        + product_9
    )
    product_18 = -15.0 * baseline_squared * path_squared_squared
    product_19 = 8.0 * cos_beta * product_4 * product_5
    product_20 = baseline_squared_cubed * sin_beta_squared
    predicted_sigma_path_squared = predicted_sigma_path**2
    sum_5 = (
        15.0 * baseline_squared * path_squared_squared * sin_beta_squared
        - 12.0 * baseline_squared_squared * path_squared * sin_beta_squared
        - baseline_squared_cubed
        - path_squared_cubed
        + 9.0 * baseline_squared_squared * path_squared
        + product_11
        + product_17
        + product_18
        + product_19
        + product_20
    )
    rho_squared = rho**2
    sum_6 = (
        11.0 * baseline_squared * path_squared_squared * sin_beta_squared
        - 13.0 * baseline_squared * path_squared_squared
        - 2.0 * cos_beta * path * product_7 * sin_beta_squared
        - 4.0 * cos_beta * path * product_7
        - 8.0 * baseline_squared_squared * path_squared * sin_beta_squared
        - baseline_squared_cubed
        - path_squared_cubed
        + 2.0 * cos_beta * product_4 * product_5 * sin_beta_squared
        + 6.0 * cos_beta * product_4 * product_5
        + 7.0 * baseline_squared_squared * path_squared
        + product_17
        + product_20
    )
    sum_7 = (
        4.0 * cos_beta * product_4 * product_5
        - 11.0 * baseline_squared * path_squared_squared
        - 2.0 * cos_beta * path * product_7
        - 6.0 * baseline_squared_squared * path_squared * sin_beta_squared
        - baseline_squared_cubed
        - path_squared_cubed
        + 5.0 * baseline_squared_squared * path_squared
        + 9.0 * baseline_squared * path_squared_squared * sin_beta_squared
        + product_17
        + product_20
    )
    sigma_path_squared_squared = sigma_path_squared**2
    sin_beta_squared_squared = sin_beta_squared**2
    sum_8 = (
        12.0 * cos_beta_squared * path * product_4
        - 2.0 * baseline * product_5
        - 3.0 * baseline * cos_beta_squared * product_5
        - 4.0 * path * product_4
        - 6.0 * baseline_squared_squared * cos_beta
        - 8.0 * baseline_squared * path_squared * product_1
        - cos_beta_squared_squared * path * product_4
        + 2.0 * baseline_squared_squared * product_1
        + 2.0 * cos_beta * path_squared_squared
        + 8.0 * baseline_squared * cos_beta * path_squared
    )
    product_21 = cos_beta * product_4
    sum_9 = baseline_squared * path - 3.0 * baseline * cos_beta * path_squared + product_21 + product_5
    sum_10 = cos_beta * path - 2.0 * baseline + baseline * cos_beta_squared
    product_22 = sigma_beta * sigma_beta_squared
    product_23 = -14.0 * cos_beta * path * product_7
    product_24 = -24.0 * baseline_squared_squared * cos_beta_squared_squared * path_squared
    product_25 = -28.0 * product_1 * product_4 * product_5
    product_26 = -4.0 * path * product_7 * product_8
    product_27 = 22.0 * baseline_squared * cos_beta_squared_squared * path_squared_squared
    product_28 = 8.0 * product_4 * product_5 * product_8
    sum_11 = (
        20.0 * path * product_1 * product_7
        - 3.0 * baseline_squared_squared * path_squared
        - 9.0 * baseline_squared * cos_beta_squared * path_squared_squared
        - path_squared_cubed
        + 30.0 * baseline_squared_squared * cos_beta_squared * path_squared
        + product_10
        + product_14
        + product_15
        + product_17
        + product_19
        + product_23
        + product_24
        + product_25
        + product_26
        + product_27
        + product_28
        + product_3
    )
    product_29 = 3.0 * baseline * cos_beta * path_squared
    product_30 = product_1 * product_4
    sum_12 = (
        4.0 * cos_beta_squared * product_5
        - 2.0 * baseline_squared * path
        - 2.0 * product_5
        - 3.0 * cos_beta * product_4
        - 9.0 * baseline * path_squared * product_1
        + 8.0 * baseline_squared * cos_beta_squared * path
        + product_29
        + product_30
    )
    product_31 = -3.0 * baseline_squared * path
    sum_13 = (
        6.0 * baseline_squared * cos_beta_squared * path
        - 2.0 * cos_beta * product_4
        - 6.0 * baseline * path_squared * product_1
        + cos_beta_squared * product_5
        + product_29
        + product_30
        + product_31
    )
    product_32 = -3.0 * baseline * path_squared * sin_beta_squared
    product_33 = -cos_beta * product_5
    product_34 = 3.0 * baseline * path_squared
    product_35 = product_4 * sin_beta_squared
    product_36 = sigma_path * sigma_path_squared
    product_37 = sin_beta * sin_beta_squared
    sum_14 = (
        product_32
        - baseline_squared * cos_beta * path
        - product_4
        + product_33
        + product_34
        + product_35
    )
    sum_15 = (
        10.0 * baseline_squared
        - 11.0 * baseline_squared * cos_beta_squared
        - 8.0 * baseline * cos_beta * path
        - path_squared
        + 2.0 * baseline_squared * cos_beta_squared_squared
        + 2.0 * cos_beta_squared * path_squared
        + 6.0 * baseline * path * product_1
    )
    sum_16 = baseline_squared - 2.0 * baseline * cos_beta * path + path_squared
    sum_16_squared = sum_16**2
    product_38 = baseline * cos_beta
    term_1 = (product_38 - path)**2
    sum_17 = (
        2.0 * baseline_squared * cos_beta_squared
        - 3.0 * path_squared
        - 5.0 * baseline_squared
        + 6.0 * baseline * cos_beta * path
    )
    sum_18 = (
        3.0 * path * product_4 * sin_beta_squared
        - 3.0 * baseline_squared * cos_beta * path_squared * sin_beta_squared
        - 3.0 * baseline * product_5 * sin_beta_squared
        - 4.0 * baseline_squared * cos_beta * path_squared
        - cos_beta * path_squared_squared
        + 4.0 * baseline * product_5
        + baseline_squared_squared * cos_beta
        + baseline_squared_squared * cos_beta * sin_beta_squared
    )
    sigma_beta_squared_squared = sigma_beta_squared**2
    term_2 = 1.0 / (divisor_1 * divisor_1**2)**2
    sum_19 = (
        16.0 * cos_beta_squared * sigma_path_squared * sum_16_squared * term_1
        - 16.0 * path_squared * sigma_beta_squared * sin_beta_squared * sum_1_squared * sum_2_squared * sum_3
        - 16.0 * predicted_sigma_beta_squared * sigma_path_squared * sum_4
        - 16.0 * predicted_sigma_path_squared * sigma_beta_squared * sin_beta_squared * sum_5
        - 16.0 * rho_squared * sigma_beta_squared * sigma_path_squared * sin_beta_squared * sum_6
        - 16.0 * sigma_beta_squared * sigma_path_squared * sin_beta_squared * sum_7
        - 32.0 * baseline_squared_squared * sigma_path_squared_squared * (1.0 + sin_beta) * (sin_beta - 1.0) * sin_beta_squared_squared
        - 32.0 * path * predicted_sigma_beta_squared * rho * sigma_beta * sigma_path * sin_beta * sum_1 * sum_2 * sum_8
        - 32.0 * path * product_22 * rho * sigma_path * sin_beta * sum_1 * sum_10 * sum_2 * sum_9
        - 32.0 * predicted_rho * predicted_sigma_beta * predicted_sigma_path * rho * sigma_beta * sigma_path * sum_11
        - 64.0 * baseline_squared * cos_beta * predicted_sigma_path_squared * rho * sigma_beta * sigma_path * sin_beta * sum_13
        - 64.0 * baseline_squared * cos_beta * predicted_rho * predicted_sigma_beta * predicted_sigma_path * sigma_path_squared * sin_beta * sum_12
        - 64.0 * baseline_squared * product_36 * product_37 * rho * sigma_beta * sum_14
        + 16.0 * path_squared * predicted_sigma_beta_squared * sigma_beta_squared * sum_15 * sum_1_squared * sum_2_squared
        + 32.0 * baseline_squared * (1.0 + cos_beta) * (cos_beta - 1.0) * cos_beta_squared * predicted_sigma_path_squared * sigma_path_squared * sum_17
        + 32.0 * cos_beta * path * rho * sigma_beta * sigma_path * sin_beta * sum_1 * sum_16 * sum_2 * term_1
        + 64.0 * path * predicted_rho * predicted_sigma_beta * predicted_sigma_path * sigma_beta_squared * sin_beta * sum_1 * sum_18 * sum_2
        + 8.0 * path_squared * sigma_beta_squared_squared * sum_10**2 * sum_1_squared * sum_2_squared
    )
    product_39 = -4.0 * baseline_squared_cubed * cos_beta
    product_40 = -6.0 * baseline * cos_beta_squared * product_2
    product_41 = baseline_squared_cubed * product_1
    product_42 = cos_beta * path_squared_cubed
    sum_20 = (
        12.0 * cos_beta_squared * path * product_7
        - 12.0 * baseline_squared_squared * path_squared * product_1
        - 18.0 * cos_beta_squared * product_4 * product_5
        - 6.0 * path * product_7
        + 15.0 * baseline_squared * path_squared_squared * product_1
        + 15.0 * baseline_squared_squared * cos_beta * path_squared
        + 2.0 * product_4 * product_5
        + product_39
        + product_40
        + product_41
        + product_42
    )
    product_43 = -10.0 * baseline_squared_squared * path_squared * product_1
    product_44 = -2.0 * cos_beta_squared_squared * path * product_7
    product_45 = 11.0 * baseline_squared * path_squared_squared * product_1
    product_46 = 2.0 * baseline_squared * cos_beta * path_squared_squared
    sum_21 = (
        13.0 * baseline_squared_squared * cos_beta * path_squared
        - 14.0 * cos_beta_squared * product_4 * product_5
        - 4.0 * path * product_7
        + 2.0 * cos_beta_squared_squared * product_4 * product_5
        + 3.0 * baseline_squared_cubed * product_1
        + 8.0 * cos_beta_squared * path * product_7
        + product_39
        + product_40
        + product_42
        + product_43
        + product_44
        + product_45
        + product_46
    )
    product_47 = cos_beta * product_5
    sum_22 = (
        3.0 * baseline_squared * cos_beta * path
        - 2.0 * product_4
        - 3.0 * baseline * cos_beta_squared * path_squared
        + cos_beta_squared * product_4
        + product_47
    )
    sum_23 = (
        3.0 * cos_beta_squared_squared * product_4 * product_5
        - 2.0 * product_4 * product_5
        - 2.0 * path * product_7
        - 3.0 * baseline_squared_cubed * cos_beta
        - 9.0 * cos_beta_squared * product_4 * product_5
        - cos_beta_squared_squared * path * product_7
        + 5.0 * baseline_squared * cos_beta * path_squared_squared
        + 7.0 * baseline_squared * path_squared_squared * product_1
        + 7.0 * baseline_squared_squared * cos_beta * path_squared
        + 9.0 * cos_beta_squared * path * product_7
        + product_40
        + product_41
        + product_42
        + product_43
    )
    sum_24 = (
        12.0 * baseline_squared_squared * cos_beta * path_squared
        - 15.0 * baseline_squared_squared * path_squared * product_1
        - 15.0 * cos_beta_squared * product_4 * product_5
        - 5.0 * baseline_squared_cubed * cos_beta
        - 5.0 * path * product_7
        + 15.0 * cos_beta_squared * path * product_7
        + 2.0 * baseline_squared_cubed * product_1
        + 4.0 * cos_beta_squared_squared * product_4 * product_5
        + product_4 * product_5
        + product_40
        + product_42
        + product_44
        + product_45
        + product_46
    )
    product_48 = -4.0 * cos_beta * product_5
    sum_25 = (
        22.0 * baseline_squared * cos_beta * path
        - 12.0 * baseline * cos_beta_squared * path_squared
        - 20.0 * product_4
        - 4.0 * baseline_squared * path * product_1
        + 9.0 * cos_beta_squared * product_4
        + 9.0 * baseline * path_squared
        + product_48
    )
    sum_26 = baseline - cos_beta * path
    product_49 = 12.0 * baseline * cos_beta * path_squared_squared * sin_beta_squared
    sum_27 = (
        12.0 * baseline_squared_squared * path * sin_beta_squared
        - 12.0 * baseline_squared * product_5 * sin_beta_squared_squared
        - 27.0 * cos_beta * path_squared * product_4 * sin_beta_squared
        - 4.0 * baseline_squared * product_5 * sin_beta_squared
        - 4.0 * product_2 * sin_beta_squared
        - 8.0 * cos_beta * path_squared * product_4
        - 9.0 * baseline * cos_beta * path_squared_squared
        + 14.0 * baseline_squared * product_5
        + 2.0 * product_2
        + 3.0 * cos_beta * product_7 * sin_beta_squared
        + 4.0 * baseline_squared_squared * path * sin_beta_squared_squared
        + cos_beta * product_7
        + product_49
    )
    product_50 = -4.0 * cos_beta * path_squared * product_4
    sum_28 = (
        2.0 * baseline_squared_squared * path * sin_beta_squared_squared
        - 12.0 * cos_beta * path_squared * product_4 * sin_beta_squared
        - 2.0 * product_2 * sin_beta_squared
        - 4.0 * baseline * cos_beta * path_squared_squared
        - 6.0 * baseline_squared * product_5 * sin_beta_squared_squared
        + 2.0 * cos_beta * product_7 * sin_beta_squared
        + 3.0 * baseline_squared_squared * path * sin_beta_squared
        + 4.0 * baseline * cos_beta * path_squared_squared * sin_beta_squared
        + 6.0 * baseline_squared * product_5
        + baseline_squared * product_5 * sin_beta_squared
        + baseline_squared_squared * path
        + product_2
        + product_50
    )
    sum_29 = path - 2.0 * cos_beta_squared * path + product_38
    product_51 = 2.0 * cos_beta * product_4 * sin_beta_squared
    product_52 = 2.0 * product_5 * sin_beta_squared
    product_53 = 9.0 * baseline * cos_beta * path_squared
    sum_30 = (
        15.0 * baseline_squared * path * sin_beta_squared
        - 12.0 * baseline_squared * path
        - 12.0 * baseline * cos_beta * path_squared * sin_beta_squared
        - 2.0 * product_5
        + 5.0 * cos_beta * product_4
        + product_51
        + product_52
        + product_53
    )
    sum_31 = (
        2.0 * baseline_squared * cos_beta * sin_beta_squared
        - 6.0 * baseline * path
        + 3.0 * baseline_squared * cos_beta
        + 3.0 * cos_beta * path_squared
        + 6.0 * baseline * path * sin_beta_squared
    )
    sum_32 = (
        4.0 * baseline_squared * path * sin_beta_squared
        - 6.0 * baseline * cos_beta * path_squared * sin_beta_squared
        - product_5
        + product_21
        + product_29
        + product_31
        + product_51
        + product_52
    )
    sum_33 = (
        10.0 * baseline_squared * path * sin_beta_squared
        - 3.0 * product_5
        - 9.0 * baseline_squared * path
        - 9.0 * baseline * cos_beta * path_squared * sin_beta_squared
        + 3.0 * cos_beta * product_4
        + 4.0 * product_5 * sin_beta_squared
        + cos_beta * product_4 * sin_beta_squared
        + product_53
    )
    product_54 = -3.0 * baseline_squared * cos_beta * path
    sum_34 = (
        2.0 * product_4
        - 2.0 * baseline * path_squared * sin_beta_squared
        - baseline_squared * cos_beta * path * sin_beta_squared
        + 2.0 * product_4 * sin_beta_squared
        + product_47
        + product_54
    )
    sum_35 = (
        16.0 * baseline_squared_squared * path * sin_beta_squared_squared
        - 15.0 * baseline * cos_beta * path_squared_squared
        - 32.0 * baseline_squared * product_5 * sin_beta_squared_squared
        - 4.0 * cos_beta * path_squared * product_4 * sin_beta_squared_squared
        - 57.0 * cos_beta * path_squared * product_4 * sin_beta_squared
        - 6.0 * baseline_squared_squared * path
        - 8.0 * product_2 * sin_beta_squared
        + 18.0 * baseline_squared * product_5
        + 18.0 * baseline_squared * product_5 * sin_beta_squared
        + 18.0 * baseline_squared_squared * path * sin_beta_squared
        + 3.0 * cos_beta * product_7
        + 4.0 * product_2
        + 9.0 * cos_beta * product_7 * sin_beta_squared
        + product_49
        + product_50
    )
    sum_36 = (
        16.0 * cos_beta * sigma_path_squared * sin_beta * sum_16_squared * term_1
        - 16.0 * predicted_sigma_path_squared * sigma_beta_squared * sin_beta * sum_20
        - 16.0 * rho_squared * sigma_beta_squared * sigma_path_squared * sin_beta * sum_21
        - 16.0 * sigma_beta_squared * sigma_path_squared * sin_beta * sum_22 * sum_9
        - 32.0 * predicted_sigma_beta_squared * sigma_path_squared * sin_beta * sum_23
        - 64.0 * predicted_rho * predicted_sigma_beta * predicted_sigma_path * rho * sigma_beta * sigma_path * sin_beta * sum_24
        - 8.0 * path * predicted_sigma_beta_squared * sigma_beta_squared * sin_beta * sum_1_squared * sum_25 * sum_2_squared
        + 16.0 * product_22 * rho * sigma_path * sum_1 * sum_2 * sum_28
        + 16.0 * path * sigma_beta_squared * sin_beta * sum_1_squared * sum_26 * sum_2_squared * term_1
        + 16.0 * predicted_rho * predicted_sigma_beta * predicted_sigma_path * sigma_beta_squared * sum_1 * sum_2 * sum_27
        + 16.0 * rho * sigma_beta * sigma_path * sum_1 * sum_16 * sum_2 * sum_29 * term_1
        + 32.0 * baseline_squared * predicted_sigma_path_squared * product_37 * sigma_path_squared * sum_31
        + 32.0 * baseline_squared * predicted_sigma_path_squared * rho * sigma_beta * sigma_path * sin_beta_squared * sum_30
        + 32.0 * baseline_squared * product_36 * rho * sigma_beta * sin_beta_squared * sum_32
        + 32.0 * baseline_squared_squared * cos_beta * sigma_path_squared_squared * sin_beta * sin_beta_squared**2
        + 64.0 * baseline_squared * predicted_rho * predicted_sigma_beta * predicted_sigma_path * sigma_path_squared * sin_beta_squared * sum_33
        + 8.0 * predicted_sigma_beta_squared * rho * sigma_beta * sigma_path * sum_1 * sum_2 * sum_35
        + 8.0 * path * sigma_beta_squared_squared * sin_beta * sum_1_squared * sum_2_squared * sum_34
    )
    sum_37 = (
        16.0 * baseline_squared * product_1 * product_5
        - 12.0 * baseline_squared_squared * path * product_1
        - 14.0 * baseline_squared * cos_beta * product_5
        - 20.0 * product_7
        - 39.0 * cos_beta_squared * path_squared * product_4
        - 4.0 * cos_beta * product_2
        + 2.0 * cos_beta_squared_squared * path_squared * product_4
        + 46.0 * baseline_squared_squared * cos_beta * path
        + 5.0 * path_squared * product_4
        + 5.0 * baseline * path_squared_squared
        + 6.0 * baseline * cos_beta_squared * path_squared_squared
        + 9.0 * cos_beta_squared * product_7
    )
    sum_38 = (
        14.0 * cos_beta * path * product_4
        - 10.0 * baseline_squared_squared
        - 13.0 * baseline_squared * cos_beta_squared * path_squared
        - 7.0 * baseline * cos_beta * product_5
        - 9.0 * path * product_1 * product_4
        - path_squared_squared
        + 2.0 * baseline_squared * cos_beta_squared_squared * path_squared
        + 2.0 * cos_beta_squared * path_squared_squared
        + 6.0 * baseline * product_1 * product_5
        + 8.0 * baseline_squared * path_squared
        + 8.0 * baseline_squared_squared * cos_beta_squared
    )
    sum_39 = (
        13.0 * baseline_squared * path_squared_squared * sin_beta_squared
        - 12.0 * cos_beta * product_4 * product_5 * sin_beta_squared
        - 15.0 * baseline_squared_squared * path_squared
        - 4.0 * baseline_squared_squared * path_squared * sin_beta_squared_squared
        - 4.0 * cos_beta * path * product_7 * sin_beta_squared
        - baseline_squared_cubed
        - path_squared_cubed
        + 18.0 * baseline_squared_squared * path_squared * sin_beta_squared
        + 20.0 * cos_beta * product_4 * product_5
        + 6.0 * cos_beta * path * product_7
        + product_17
        + product_18
        + product_20
    )
    sum_40 = 2.0 * baseline_squared - baseline * cos_beta * path - path_squared
    product_55 = -2.0 * cos_beta * product_4 * product_5
    sum_41 = (
        10.0 * baseline_squared_cubed
        - 11.0 * baseline_squared_cubed * cos_beta_squared
        - 24.0 * product_1 * product_4 * product_5
        - 32.0 * cos_beta * path * product_7
        - 4.0 * baseline_squared * path_squared_squared
        - path_squared_cubed
        + 28.0 * path * product_1 * product_7
        + 3.0 * baseline_squared_squared * path_squared
        + 36.0 * baseline_squared_squared * cos_beta_squared * path_squared
        + 5.0 * baseline_squared * cos_beta_squared * path_squared_squared
        + product_13
        + product_14
        + product_15
        + product_16
        + product_17
        + product_24
        + product_3
        + product_55
        + product_9
    )
    product_56 = -12.0 * baseline_squared_squared * cos_beta_squared_squared * path_squared
    product_57 = -6.0 * baseline_squared_squared * path_squared
    product_58 = -6.0 * baseline * product_1 * product_2
    product_59 = 33.0 * baseline_squared_squared * cos_beta_squared * path_squared
    product_60 = cos_beta_squared * path_squared_cubed
    sum_42 = (
        10.0 * baseline_squared_cubed
        - 10.0 * baseline_squared_cubed * cos_beta_squared
        - 24.0 * cos_beta * path * product_7
        + 15.0 * baseline_squared * cos_beta_squared_squared * path_squared_squared
        + 18.0 * path * product_1 * product_7
        + baseline_squared_cubed * cos_beta_squared_squared
        + product_19
        + product_25
        + product_56
        + product_57
        + product_58
        + product_59
        + product_60
    )
    sum_43 = (
        11.0 * baseline_squared * cos_beta_squared_squared * path_squared_squared
        - 12.0 * baseline_squared_cubed * cos_beta_squared
        - 20.0 * product_1 * product_4 * product_5
        + 2.0 * baseline_squared * cos_beta_squared * path_squared_squared
        + 2.0 * baseline_squared * path_squared_squared
        + 2.0 * product_4 * product_5 * product_8
        + 5.0 * baseline_squared_cubed * cos_beta_squared_squared
        + 8.0 * baseline_squared_cubed
        + product_12
        + product_23
        + product_55
        + product_56
        + product_57
        + product_58
        + product_59
        + product_60
        + product_9
    )
    sum_44 = (
        2.0 * baseline_squared * sin_beta_squared
        - 6.0 * baseline * cos_beta * path
        + 3.0 * baseline_squared
        + 3.0 * path_squared
    )
    sum_45 = (
        12.0 * cos_beta * product_4 * product_5
        - 25.0 * baseline_squared_cubed * cos_beta_squared
        - 36.0 * baseline_squared_squared * cos_beta_squared_squared * path_squared
        - 40.0 * product_1 * product_4 * product_5
        - 46.0 * cos_beta * path * product_7
        - 5.0 * baseline_squared * cos_beta_squared * path_squared_squared
        - 9.0 * baseline_squared_squared * path_squared
        - path_squared_cubed
        + 20.0 * baseline_squared_cubed
        + 44.0 * path * product_1 * product_7
        + 6.0 * baseline_squared_cubed * cos_beta_squared_squared
        + 60.0 * baseline_squared_squared * cos_beta_squared * path_squared
        + product_15
        + product_17
        + product_26
        + product_27
        + product_28
        + product_3
        + product_6
    )
    sum_46 = (
        16.0 * path_squared * product_4
        - 2.0 * baseline_squared_squared * cos_beta * path * sin_beta_squared
        - 20.0 * baseline_squared_squared * cos_beta * path
        - 21.0 * path_squared * product_4 * sin_beta_squared
        - 7.0 * baseline * path_squared_squared
        + 2.0 * baseline_squared * cos_beta * product_5
        + 2.0 * cos_beta * product_2
        + 3.0 * product_7 * sin_beta_squared
        + 6.0 * baseline_squared * cos_beta * product_5 * sin_beta_squared
        + 6.0 * baseline * path_squared_squared * sin_beta_squared
        + 7.0 * product_7
    )
    sum_47 = (
        12.0 * baseline * path_squared
        - 12.0 * baseline_squared * cos_beta * path
        - 9.0 * baseline * path_squared * sin_beta_squared
        + 4.0 * product_4
        + product_35
        + product_48
    )
    sum_48 = (
        4.0 * product_4
        - 6.0 * baseline * path_squared * sin_beta_squared
        - 9.0 * baseline_squared * cos_beta * path
        + 6.0 * baseline * path_squared
        + product_33
        + product_35
    )
    sum_49 = product_32 + product_33 + product_34 + product_35 + product_4 + product_54
    sum_50 = (
        2.0 * baseline * cos_beta * product_5
        - 3.0 * baseline_squared * path_squared
        - 4.0 * cos_beta * path * product_4
        - baseline_squared * path_squared * sin_beta_squared
        + 4.0 * baseline_squared_squared
        + path_squared_squared
    )
    sum_51 = (
        16.0 * predicted_sigma_beta_squared * sigma_path_squared * sum_41
        - 16.0 * predicted_sigma_beta_squared * sigma_beta_squared * sum_1_squared * sum_2_squared * sum_38
        - 16.0 * predicted_sigma_beta_squared * rho * sigma_beta * sigma_path * sin_beta * sum_1 * sum_2 * sum_37
        - 16.0 * sigma_path_squared * sin_beta_squared * sum_39
        - 32.0 * product_22 * rho * sigma_path * sin_beta * sum_1 * sum_2 * sum_22 * sum_40
        + 16.0 * predicted_sigma_path_squared * sigma_beta_squared * sum_42
        + 16.0 * rho_squared * sigma_beta_squared * sigma_path_squared * sum_43
        + 16.0 * sigma_beta_squared * sigma_path_squared * sum_22**2
        + 16.0 * sigma_beta_squared * sum_1_squared * sum_26**2 * sum_2_squared * term_1
        + 32.0 * baseline_squared * predicted_sigma_path_squared * sigma_path_squared * sin_beta_squared_squared * sum_44
        + 32.0 * baseline_squared_squared * sigma_path_squared_squared * sin_beta_squared * sin_beta_squared**2
        + 32.0 * predicted_rho * predicted_sigma_beta * predicted_sigma_path * sigma_beta_squared * sin_beta * sum_1 * sum_2 * sum_46
        + 32.0 * rho * sigma_beta * sigma_path * sin_beta * sum_1 * sum_16 * sum_2 * sum_26 * term_1
        + 32.0 * predicted_rho * predicted_sigma_beta * predicted_sigma_path * rho * sigma_beta * sigma_path * sum_45
        + 64.0 * baseline_squared * predicted_sigma_path_squared * product_37 * rho * sigma_beta * sigma_path * sum_48
        + 64.0 * baseline_squared * product_36 * product_37 * rho * sigma_beta * sum_49
        + 64.0 * baseline_squared * predicted_rho * predicted_sigma_beta * predicted_sigma_path * product_37 * sigma_path_squared * sum_47
        + 8.0 * sigma_beta_squared_squared * sin_beta_squared * sum_1_squared * sum_2_squared * sum_50
    )
    result = _empty(arguments, (2, 2))
    result[..., 0, 0] = sum_19 * term_2
    result[..., 0, 1] = sum_36 * term_2
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = sum_51 * term_2
    return result


def covariance_averaged_semidefinite(
    *,
    path: npt.ArrayLike,
    beta: npt.ArrayLike,
    baseline: npt.ArrayLike,
    sigma_path: npt.ArrayLike,
    sigma_beta: npt.ArrayLike,
    rho: npt.ArrayLike,
) -> Floats:
    """Covariance of the plain conversion, averaged over the truth, to fourth order, completed to a sum of squares.

    Name: bistatic.covariance.averaged.semidefinite.
    Definition: e^L C to sigma^4 + dg K dg', g = 2 L h.
    Conditioning: measurement-conditioned: the measured symbols stand for the measurement.
    Source: Lerro & Bar-Shalom 1993; Prosov (11), doi:10.1109/7.220948.

    Args:
        path: length of the path from transmitter to target to receiver [m], 30000 to 1e+06.
        beta: azimuth at the receiver, counter-clockwise from the x axis, where the transmitter stands [rad], -3.1416 to 3.1416.
        baseline: distance from transmitter to receiver; less than the path [m], 1 to 20000.
        sigma_path: standard deviation of the error of path [m], 0.001 to 1000.
        sigma_beta: standard deviation of the error of beta [rad], 1e-09 to 0.1.
        rho: correlation of the errors of path and beta [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (2, 2), unit m^2.

    Accuracy: at most 12.5 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
    """
    arguments = _floats(path, beta, baseline, sigma_path, sigma_beta, rho)
    path, beta, baseline, sigma_path, sigma_beta, rho = arguments
    cos_beta = np.cos(beta)
    divisor_1 = 2.0 * path - 2.0 * baseline * cos_beta
    cos_beta_squared = cos_beta**2
    baseline_squared = baseline**2
    baseline_squared_squared = baseline_squared**2
    product_1 = -2.0 * baseline_squared_squared * cos_beta
    product_2 = cos_beta * cos_beta_squared
    path_squared = path**2
    product_3 = baseline * baseline_squared
    product_4 = path * path_squared
    path_squared_squared = path_squared**2
    sum_1 = (
        4.0 * cos_beta_squared * path * product_3
        - 3.0 * baseline_squared * path_squared * product_2
        - 4.0 * baseline * cos_beta_squared * product_4
        - 4.0 * path * product_3
        + 7.0 * baseline_squared * cos_beta * path_squared
        + baseline_squared_squared * product_2
        + cos_beta * path_squared_squared
        + product_1
    )
    rho_squared = rho**2
    product_5 = rho * rho_squared
    sigma_beta_squared = sigma_beta**2
    product_6 = sigma_beta * sigma_beta_squared
    sigma_path_squared = sigma_path**2
    product_7 = sigma_path * sigma_path_squared
    sin_beta = np.sin(beta)
    sum_2 = 2.0 * baseline * cos_beta - 3.0 * cos_beta_squared * path + path
    product_8 = baseline * cos_beta
    sum_3 = product_8 - path
    sum_3_squared = sum_3**2
    cos_beta_squared_squared = cos_beta_squared**2
    sum_4 = baseline + path
    sum_5 = baseline - path
    sum_6 = (
        34.0 * cos_beta_squared * path * product_3
        - 16.0 * baseline * cos_beta_squared * product_4
        - 18.0 * baseline_squared_squared * cos_beta
        - 18.0 * path * product_3
        - 2.0 * cos_beta_squared_squared * path * product_3
        - 25.0 * baseline_squared * path_squared * product_2
        - 6.0 * baseline * product_4
        + 37.0 * baseline_squared * cos_beta * path_squared
        + 7.0 * baseline_squared_squared * product_2
        + 7.0 * cos_beta * path_squared_squared
    )
    sigma_path_squared_cubed = sigma_path_squared * sigma_path_squared**2
    sin_beta_squared = sin_beta**2
    sin_beta_squared_squared = sin_beta_squared**2
    product_9 = -12.0 * baseline * cos_beta * product_4
    product_10 = -3.0 * path_squared_squared * sin_beta_squared
    product_11 = 12.0 * baseline * cos_beta * product_4 * sin_beta_squared
    product_12 = 3.0 * baseline_squared_squared * sin_beta_squared_squared
    product_13 = 8.0 * cos_beta * path * product_3
    product_14 = 9.0 * baseline_squared * path_squared * sin_beta_squared
    sigma_path_squared_squared = sigma_path_squared**2
    sum_7 = (
        3.0 * path_squared_squared
        - 18.0 * baseline_squared * path_squared * sin_beta_squared_squared
        - 24.0 * cos_beta * path * product_3 * sin_beta_squared
        - 7.0 * baseline_squared_squared
        + 4.0 * baseline_squared_squared * sin_beta_squared
        + 8.0 * baseline_squared * path_squared
        + product_10
        + product_11
        + product_12
        + product_13
        + product_14
        + product_9
    )
    product_15 = sigma_path * sigma_path_squared**2
    product_16 = sin_beta * sin_beta_squared
    sum_8 = (
        2.0 * cos_beta * path
        - 2.0 * baseline
        - 3.0 * cos_beta * path * sin_beta_squared
        + 2.0 * baseline * sin_beta_squared
    )
    sum_9 = (
        16.0 * baseline_squared_squared * sin_beta_squared
        - 19.0 * baseline_squared_squared
        - 4.0 * baseline_squared * path_squared
        - 45.0 * baseline_squared * path_squared * sin_beta_squared_squared
        - 60.0 * cos_beta * path * product_3 * sin_beta_squared
        + 3.0 * path_squared_squared
        + 32.0 * cos_beta * path * product_3
        + 45.0 * baseline_squared * path_squared * sin_beta_squared
        + product_10
        + product_11
        + product_12
        + product_9
    )
    product_17 = baseline * baseline_squared**2
    product_18 = path * path_squared**2
    product_19 = cos_beta * cos_beta_squared**2
    product_20 = cos_beta * product_18
    sum_10 = (
        24.0 * baseline_squared * product_19 * product_4
        - 10.0 * cos_beta_squared * product_17
        - 10.0 * path_squared * product_3
        - 11.0 * baseline * cos_beta_squared * path_squared_squared
        - 34.0 * baseline_squared_squared * cos_beta * path
        - 51.0 * cos_beta_squared_squared * path_squared * product_3
        - 6.0 * product_18 * product_2
        - 9.0 * baseline_squared_squared * path * product_19
        - 92.0 * baseline_squared * product_2 * product_4
        + 28.0 * baseline_squared * cos_beta * product_4
        + 36.0 * baseline * cos_beta_squared_squared * path_squared_squared
        + 48.0 * baseline_squared_squared * path * product_2
        + 5.0 * cos_beta_squared_squared * product_17
        + 81.0 * cos_beta_squared * path_squared * product_3
        + product_20
    )
    baseline_squared_cubed = baseline_squared * baseline_squared**2
    product_21 = -14.0 * path * product_17 * product_19
    path_squared_cubed = path_squared * path_squared**2
    product_22 = -42.0 * baseline * product_18 * product_2
    product_23 = 18.0 * baseline * cos_beta * product_18
    product_24 = 30.0 * product_19 * product_3 * product_4
    product_25 = 7.0 * cos_beta_squared * path_squared_cubed
    product_26 = 77.0 * baseline_squared * cos_beta_squared_squared * path_squared_squared
    sum_11 = (
        111.0 * baseline_squared_squared * cos_beta_squared * path_squared
        - 102.0 * product_2 * product_3 * product_4
        - 11.0 * baseline_squared_cubed * cos_beta_squared
        - 11.0 * baseline_squared_squared * path_squared
        - 27.0 * baseline_squared * cos_beta_squared * path_squared_squared
        - 3.0 * path_squared_cubed
        - 50.0 * cos_beta * path * product_17
        - 88.0 * baseline_squared_squared * cos_beta_squared_squared * path_squared
        + 2.0 * baseline_squared * path_squared_squared
        + 24.0 * cos_beta * product_3 * product_4
        + 7.0 * baseline_squared_cubed * cos_beta_squared_squared
        + 72.0 * path * product_17 * product_2
        + product_21
        + product_22
        + product_23
        + product_24
        + product_25
        + product_26
    )
    product_27 = -30.0 * baseline * product_18 * product_2
    product_28 = -4.0 * path * product_17 * product_19
    product_29 = 12.0 * product_19 * product_3 * product_4
    product_30 = 49.0 * baseline_squared * cos_beta_squared_squared * path_squared_squared
    product_31 = 5.0 * baseline_squared_cubed * cos_beta_squared_squared
    product_32 = 5.0 * cos_beta_squared * path_squared_cubed
    sum_12 = (
        12.0 * cos_beta * product_3 * product_4
        - 2.0 * baseline_squared * path_squared_squared
        - 21.0 * baseline_squared * cos_beta_squared * path_squared_squared
        - 22.0 * cos_beta * path * product_17
        - 3.0 * path_squared_cubed
        - 48.0 * product_2 * product_3 * product_4
        - 50.0 * baseline_squared_squared * cos_beta_squared_squared * path_squared
        - 7.0 * baseline_squared_cubed * cos_beta_squared
        - 7.0 * baseline_squared_squared * path_squared
        + 30.0 * path * product_17 * product_2
        + 63.0 * baseline_squared_squared * cos_beta_squared * path_squared
        + product_23
        + product_27
        + product_28
        + product_29
        + product_30
        + product_31
        + product_32
    )
    sum_13 = (
        3.0 * baseline * cos_beta * path_squared
        - 3.0 * baseline_squared * path
        - 3.0 * cos_beta * product_3
        - 9.0 * baseline * path_squared * product_2
        - product_4
        + 3.0 * cos_beta_squared * product_4
        + 9.0 * baseline_squared * cos_beta_squared * path
        + product_2 * product_3
    )
    sum_3_squared_squared = sum_3_squared**2
    sum_14 = baseline_squared - 2.0 * baseline * cos_beta * path + path_squared
    sum_4_squared = sum_4**2
    sum_5_squared = sum_5**2
    sigma_beta_squared_squared = sigma_beta_squared**2
    sum_15 = (
        22.0 * baseline * path * product_2
        - 28.0 * baseline * cos_beta * path
        - 4.0 * path_squared
        - 40.0 * baseline_squared * cos_beta_squared
        + 36.0 * baseline_squared
        + 7.0 * baseline_squared * cos_beta_squared_squared
        + 7.0 * cos_beta_squared * path_squared
    )
    product_33 = 4.0 * baseline * cos_beta * path
    product_34 = baseline_squared * cos_beta_squared
    sum_16 = product_33 - 2.0 * path_squared - 3.0 * baseline_squared + product_34
    sum_17 = path_squared - 6.0 * baseline_squared + product_33 + product_34
    product_35 = sigma_beta * sigma_beta_squared**2
    product_36 = baseline * baseline_squared * baseline_squared**2
    term_1 = (baseline_squared**2)**2
    product_37 = -4.0 * cos_beta_squared_squared * term_1
    product_38 = path * path_squared * path_squared**2
    product_39 = -8.0 * baseline * product_2 * product_38
    cos_beta_squared_cubed = cos_beta_squared * cos_beta_squared**2
    product_40 = 4.0 * cos_beta_squared * term_1
    product_41 = cos_beta_squared_cubed * term_1
    term_2 = (path_squared**2)**2
    product_42 = cos_beta_squared * term_2
    sum_18 = (
        10.0 * baseline_squared * cos_beta_squared * path_squared_cubed
        - 105.0 * baseline_squared_squared * cos_beta_squared_squared * path_squared_squared
        - 2.0 * cos_beta * product_18 * product_3
        - 38.0 * path * product_2 * product_36
        - 46.0 * product_17 * product_19 * product_4
        - 66.0 * product_18 * product_2 * product_3
        - 7.0 * baseline_squared_squared * path_squared_squared
        - 74.0 * cos_beta * product_17 * product_4
        - 9.0 * baseline_squared_cubed * cos_beta_squared_cubed * path_squared
        - 93.0 * baseline_squared_cubed * cos_beta_squared * path_squared
        + 10.0 * path * product_19 * product_36
        + 114.0 * baseline_squared_squared * cos_beta_squared * path_squared_squared
        + 12.0 * baseline_squared_squared * cos_beta_squared_cubed * path_squared_squared
        + 128.0 * product_17 * product_2 * product_4
        + 13.0 * baseline_squared * cos_beta_squared_squared * path_squared_cubed
        + 22.0 * baseline_squared_cubed * path_squared
        + 28.0 * cos_beta * path * product_36
        + 36.0 * product_18 * product_19 * product_3
        + 72.0 * baseline_squared_cubed * cos_beta_squared_squared * path_squared
        + baseline_squared * path_squared_cubed
        + product_37
        + product_39
        + product_40
        + product_41
        + product_42
    )
    product_43 = -4.0 * baseline * cos_beta * product_4
    product_44 = -6.0 * baseline_squared * path_squared * sin_beta_squared
    product_45 = 6.0 * baseline_squared * path_squared
    product_46 = baseline_squared_squared * sin_beta_squared_squared
    sum_19 = (
        4.0 * cos_beta * path * product_3 * sin_beta_squared
        - 2.0 * baseline_squared_squared * sin_beta_squared
        - 4.0 * cos_beta * path * product_3
        + baseline_squared_squared
        + path_squared_squared
        + product_43
        + product_44
        + product_45
        + product_46
    )
    product_47 = 8.0 * baseline * cos_beta * product_4
    sigma_beta_squared_cubed = sigma_beta_squared * sigma_beta_squared**2
    sum_20 = (
        10.0 * baseline_squared_squared * sin_beta_squared
        - 18.0 * baseline_squared * path_squared * sin_beta_squared
        - 40.0 * cos_beta * path * product_3
        - 8.0 * cos_beta * path * product_3 * sin_beta_squared
        + 25.0 * baseline_squared_squared
        + path_squared_squared
        + product_45
        + product_46
        + product_47
    )
    sum_21 = (
        16.0 * cos_beta * product_18 * product_3
        - 120.0 * product_18 * product_2 * product_3
        - 128.0 * cos_beta * product_17 * product_4
        - 18.0 * baseline_squared_cubed * cos_beta_squared_cubed * path_squared
        - 192.0 * baseline_squared_cubed * cos_beta_squared * path_squared
        - 2.0 * baseline_squared * cos_beta_squared * path_squared_cubed
        - 204.0 * baseline_squared_squared * cos_beta_squared_squared * path_squared_squared
        - 28.0 * baseline_squared_squared * path_squared_squared
        - 80.0 * path * product_2 * product_36
        - 88.0 * product_17 * product_19 * product_4
        + 16.0 * path * product_19 * product_36
        + 162.0 * baseline_squared_cubed * cos_beta_squared_squared * path_squared
        + 21.0 * baseline_squared_squared * cos_beta_squared_cubed * path_squared_squared
        + 22.0 * baseline_squared * cos_beta_squared_squared * path_squared_cubed
        + 224.0 * product_17 * product_2 * product_4
        + 225.0 * baseline_squared_squared * cos_beta_squared * path_squared_squared
        + 4.0 * baseline_squared * path_squared_cubed
        + 40.0 * baseline_squared_cubed * path_squared
        + 64.0 * cos_beta * path * product_36
        + 72.0 * product_18 * product_19 * product_3
        + product_37
        + product_39
        + product_40
        + product_41
        + product_42
    )
    sum_14_squared = sum_14**2
    term_3 = 1.0 / ((divisor_1**2)**2)**2
    sum_22 = (
        128.0 * cos_beta * path * rho * sigma_beta * sigma_path * sin_beta * sum_14 * sum_3_squared_squared * sum_4 * sum_5
        - 1024.0 * baseline_squared * product_5 * product_6 * product_7 * sin_beta * sum_1 * sum_2
        - 128.0 * path * product_6 * rho * sigma_path * sin_beta * sum_3_squared * sum_4 * sum_5 * sum_6
        - 2304.0 * baseline_squared_squared * sigma_path_squared_cubed * (1.0 + sin_beta) * (sin_beta - 1.0) * sin_beta_squared_squared
        - 256.0 * baseline_squared * sigma_beta_squared * sigma_path_squared_squared * sin_beta_squared * sum_7
        - 4608.0 * baseline_squared_squared * product_15 * product_16 * rho * sigma_beta * sum_8
        - 512.0 * baseline_squared * product_6 * product_7 * rho * sin_beta * sum_10
        - 512.0 * baseline_squared * rho_squared * sigma_beta_squared * sigma_path_squared_squared * sin_beta_squared * sum_9
        - 64.0 * rho_squared * sigma_beta_squared * sigma_path_squared * sum_11 * sum_3_squared
        - 64.0 * sigma_beta_squared * sigma_path_squared * sum_12 * sum_3_squared
        - 768.0 * baseline_squared * cos_beta * product_7 * rho * sigma_beta * sin_beta * sum_13 * sum_3_squared
        + 32.0 * path_squared * sigma_beta_squared_squared * sum_15 * sum_3_squared * sum_4_squared * sum_5_squared
        + 384.0 * baseline_squared * (1.0 + cos_beta) * (cos_beta - 1.0) * cos_beta_squared * sigma_path_squared_squared * sum_16 * sum_3_squared
        + 384.0 * path * product_35 * rho * sigma_path * sin_beta * sum_1 * sum_17 * sum_4 * sum_5
        + 512.0 * rho_squared * sigma_beta_squared_squared * sigma_path_squared * sum_18
        + 64.0 * cos_beta_squared * sigma_path_squared * sum_14_squared * sum_3_squared_squared
        + 64.0 * path_squared * sigma_beta_squared * sin_beta_squared * sum_19 * sum_4_squared * sum_5_squared
        + 64.0 * path_squared * sigma_beta_squared_cubed * sin_beta_squared * sum_20 * sum_4_squared * sum_5_squared
        + 64.0 * sigma_beta_squared_squared * sigma_path_squared * sum_21
    )
    sum_23 = (
        16.0 * cos_beta_squared * product_3
        - 22.0 * baseline * cos_beta_squared * path_squared
        - 36.0 * product_3
        - 7.0 * baseline_squared * path * product_2
        - 7.0 * cos_beta * product_4
        + 16.0 * baseline * path_squared
        + 40.0 * baseline_squared * cos_beta * path
    )
    product_48 = -6.0 * product_18 * sin_beta_squared
    product_49 = 5.0 * cos_beta * product_17 * sin_beta_squared
    sum_24 = (
        18.0 * baseline_squared_squared * path * sin_beta_squared_squared
        - 103.0 * baseline_squared * product_4 * sin_beta_squared
        - 18.0 * cos_beta * path_squared * product_3 * sin_beta_squared_squared
        - 27.0 * baseline * cos_beta * path_squared_squared
        - 51.0 * baseline_squared_squared * path * sin_beta_squared
        - 62.0 * cos_beta * path_squared * product_3
        - 7.0 * cos_beta * product_17
        + 2.0 * cos_beta * product_17 * sin_beta_squared_squared
        + 30.0 * baseline * cos_beta * path_squared_squared * sin_beta_squared
        + 33.0 * baseline_squared_squared * path
        + 42.0 * baseline_squared * product_4 * sin_beta_squared_squared
        + 5.0 * product_18
        + 58.0 * baseline_squared * product_4
        + 77.0 * cos_beta * path_squared * product_3 * sin_beta_squared
        + product_48
        + product_49
    )
    product_50 = baseline_squared_squared * cos_beta * sin_beta_squared
    sum_25 = (
        2.0 * path * product_3 * sin_beta_squared_squared
        - 10.0 * path * product_3 * sin_beta_squared
        - 12.0 * baseline_squared * cos_beta * path_squared
        - 2.0 * cos_beta * path_squared_squared
        - 8.0 * baseline * product_4 * sin_beta_squared
        + 8.0 * path * product_3
        + 8.0 * baseline * product_4
        + 9.0 * baseline_squared * cos_beta * path_squared * sin_beta_squared
        + baseline_squared_squared * cos_beta * sin_beta_squared_squared
        + product_1
        + product_50
    )
    sum_26 = (
        112.0 * cos_beta_squared * path * product_17
        - 106.0 * cos_beta_squared * product_3 * product_4
        - 110.0 * baseline_squared_squared * path_squared * product_2
        - 14.0 * cos_beta_squared_squared * path * product_17
        - 36.0 * baseline_squared_cubed * cos_beta
        - 36.0 * path * product_17
        - 42.0 * baseline * cos_beta_squared * product_18
        + 13.0 * baseline_squared_cubed * product_2
        + 14.0 * baseline_squared * cos_beta * path_squared_squared
        + 30.0 * cos_beta_squared_squared * product_3 * product_4
        + 7.0 * cos_beta * path_squared_cubed
        + 77.0 * baseline_squared * path_squared_squared * product_2
        + 8.0 * product_3 * product_4
        + 83.0 * baseline_squared_squared * cos_beta * path_squared
    )
    sum_27 = (
        119.0 * cos_beta * path_squared * product_3
        - 107.0 * path_squared * product_2 * product_3
        - 14.0 * cos_beta_squared * product_18
        - 18.0 * cos_beta * product_17
        - 22.0 * baseline_squared_squared * cos_beta_squared_squared * path
        - 3.0 * baseline * cos_beta * path_squared_squared
        - 54.0 * baseline_squared_squared * path
        - 91.0 * baseline_squared * cos_beta_squared * product_4
        + 13.0 * product_17 * product_2
        + 32.0 * baseline * path_squared_squared * product_2
        + 4.0 * path_squared * product_19 * product_3
        + 50.0 * baseline_squared * cos_beta_squared_squared * product_4
        + 7.0 * product_18
        + 83.0 * baseline_squared_squared * cos_beta_squared * path
        + baseline_squared * product_4
    )
    sum_28 = (
        12.0 * cos_beta_squared_squared * product_3 * product_4
        - 18.0 * baseline_squared_cubed * cos_beta
        - 18.0 * path * product_17
        - 2.0 * product_3 * product_4
        - 30.0 * baseline * cos_beta_squared * product_18
        - 4.0 * cos_beta_squared_squared * path * product_17
        - 58.0 * baseline_squared_squared * path_squared * product_2
        - 62.0 * cos_beta_squared * product_3 * product_4
        + 16.0 * baseline_squared * cos_beta * path_squared_squared
        + 49.0 * baseline_squared * path_squared_squared * product_2
        + 49.0 * baseline_squared_squared * cos_beta * path_squared
        + 5.0 * baseline_squared_cubed * product_2
        + 5.0 * cos_beta * path_squared_cubed
        + 56.0 * cos_beta_squared * path * product_17
    )
    sum_29 = (
        14.0 * cos_beta * path_squared * product_3
        - 112.0 * baseline_squared * product_4 * sin_beta_squared
        - 125.0 * baseline * cos_beta * path_squared_squared
        - 154.0 * baseline_squared_squared * path
        - 24.0 * product_18 * sin_beta_squared
        - 291.0 * cos_beta * path_squared * product_3 * sin_beta_squared
        - 96.0 * baseline_squared * product_4 * sin_beta_squared_squared
        + 144.0 * baseline * cos_beta * path_squared_squared * sin_beta_squared
        + 172.0 * baseline_squared * product_4
        + 22.0 * product_18
        + 226.0 * baseline_squared_squared * path * sin_beta_squared
        + 36.0 * baseline_squared_squared * path * sin_beta_squared_squared
        + 37.0 * cos_beta * product_17 * sin_beta_squared
        + 71.0 * cos_beta * product_17
    )
    product_51 = -4.0 * baseline * product_4 * sin_beta_squared
    product_52 = -cos_beta * path_squared_squared
    product_53 = 4.0 * baseline * product_4
    sum_30 = (
        11.0 * baseline_squared_squared * cos_beta
        - 15.0 * baseline_squared * cos_beta * path_squared * sin_beta_squared
        - 20.0 * path * product_3
        + 26.0 * path * product_3 * sin_beta_squared
        + 6.0 * baseline_squared * cos_beta * path_squared
        + product_50
        + product_51
        + product_52
        + product_53
    )
    sin_beta_squared_cubed = sin_beta_squared * sin_beta_squared**2
    sum_31 = (
        2.0 * baseline_squared_cubed * path * sin_beta_squared_cubed
        - 14.0 * cos_beta * path_squared_squared * product_3
        - 3.0 * baseline_squared_cubed * path
        - 32.0 * cos_beta * path_squared * product_17 * sin_beta_squared_squared
        - 38.0 * baseline_squared * product_18 * sin_beta_squared
        - 6.0 * baseline_squared_squared * product_4 * sin_beta_squared_cubed
        - 8.0 * cos_beta * path_squared * product_17
        - 91.0 * baseline_squared_squared * product_4 * sin_beta_squared_squared
        - 98.0 * cos_beta * path_squared * product_17 * sin_beta_squared
        - baseline_squared * product_18
        - product_38
        + 2.0 * cos_beta * product_36
        + 2.0 * product_38 * sin_beta_squared
        + 21.0 * baseline_squared_squared * product_4
        + 29.0 * baseline_squared_cubed * path * sin_beta_squared_squared
        + 32.0 * baseline_squared_cubed * path * sin_beta_squared
        + 32.0 * cos_beta * path_squared_squared * product_3 * sin_beta_squared_squared
        + 36.0 * baseline_squared * product_18 * sin_beta_squared_squared
        + 36.0 * baseline_squared_squared * product_4 * sin_beta_squared
        + 4.0 * baseline * cos_beta * path_squared_cubed
        + 4.0 * cos_beta * product_36 * sin_beta_squared_squared
        + 52.0 * cos_beta * path_squared_squared * product_3 * sin_beta_squared
        + 6.0 * cos_beta * product_36 * sin_beta_squared
    )
    sum_32 = 5.0 * baseline * cos_beta - 5.0 * path + 6.0 * path * sin_beta_squared
    product_54 = sin_beta * sin_beta_squared**2
    product_55 = -18.0 * baseline_squared_cubed * path_squared * product_19
    product_56 = -24.0 * product_2 * term_1
    product_57 = 36.0 * cos_beta * term_1
    product_58 = 72.0 * cos_beta_squared_squared * product_18 * product_3
    product_59 = 72.0 * path * product_36
    sum_33 = (
        104.0 * baseline_squared_squared * cos_beta * path_squared_squared
        - 129.0 * cos_beta_squared_squared * product_17 * product_4
        - 139.0 * cos_beta_squared * path * product_36
        - 16.0 * baseline * cos_beta_squared * product_38
        - 212.0 * baseline_squared_squared * path_squared_squared * product_2
        - 214.0 * baseline_squared_cubed * cos_beta * path_squared
        - 55.0 * product_17 * product_4
        - 89.0 * cos_beta_squared * product_18 * product_3
        - product_18 * product_3
        + 16.0 * baseline_squared * cos_beta * path_squared_cubed
        + 194.0 * baseline_squared_cubed * path_squared * product_2
        + 2.0 * cos_beta * term_2
        + 2.0 * product_19 * term_1
        + 24.0 * baseline_squared_squared * path_squared_squared * product_19
        + 26.0 * baseline_squared * path_squared_cubed * product_2
        + 308.0 * cos_beta_squared * product_17 * product_4
        + 41.0 * cos_beta_squared_squared * path * product_36
        + product_55
        + product_56
        + product_57
        + product_58
        + product_59
    )
    sum_34 = (
        13.0 * cos_beta * product_17
        - 17.0 * baseline_squared * product_4 * sin_beta_squared
        - 18.0 * baseline_squared * product_4 * sin_beta_squared_squared
        - 25.0 * baseline * cos_beta * path_squared_squared
        - 29.0 * baseline_squared_squared * path
        - 51.0 * cos_beta * path_squared * product_3 * sin_beta_squared
        + 24.0 * baseline * cos_beta * path_squared_squared * sin_beta_squared
        + 32.0 * baseline_squared * product_4
        + 4.0 * cos_beta * path_squared * product_3
        + 41.0 * baseline_squared_squared * path * sin_beta_squared
        + 5.0 * product_18
        + 6.0 * baseline_squared_squared * path * sin_beta_squared_squared
        + product_48
        + product_49
    )
    sum_35 = baseline - cos_beta * path
    sum_36 = (
        4.0 * baseline_squared * cos_beta * path
        - 4.0 * baseline * cos_beta_squared * path_squared
        - 6.0 * product_3
        - baseline_squared * path * product_2
        - cos_beta * product_4
        + 4.0 * cos_beta_squared * product_3
        + 4.0 * baseline * path_squared
    )
    sum_37 = path - 2.0 * cos_beta_squared * path + product_8
    sum_38 = (
        10.0 * product_18 * product_3
        - 126.0 * cos_beta_squared_squared * product_17 * product_4
        - 146.0 * cos_beta_squared * path * product_36
        - 188.0 * baseline_squared_cubed * cos_beta * path_squared
        - 196.0 * baseline_squared_squared * path_squared_squared * product_2
        - 74.0 * product_17 * product_4
        - 8.0 * baseline * cos_beta_squared * product_38
        - 94.0 * cos_beta_squared * product_18 * product_3
        + 121.0 * baseline_squared_squared * cos_beta * path_squared_squared
        + 190.0 * baseline_squared_cubed * path_squared * product_2
        + 2.0 * baseline_squared * cos_beta * path_squared_cubed
        + 21.0 * baseline_squared_squared * path_squared_squared * product_19
        + 22.0 * baseline_squared * path_squared_cubed * product_2
        + 280.0 * cos_beta_squared * product_17 * product_4
        + 46.0 * cos_beta_squared_squared * path * product_36
        + cos_beta * term_2
        + product_19 * term_1
        + product_55
        + product_56
        + product_57
        + product_58
        + product_59
    )
    sum_39 = (
        11.0 * path * product_3 * sin_beta_squared
        - 6.0 * baseline_squared * cos_beta * path_squared * sin_beta_squared
        - 8.0 * path * product_3
        + 5.0 * baseline_squared_squared * cos_beta
        + product_50
        + product_51
        + product_52
        + product_53
    )
    sum_40 = (
        128.0 * baseline_squared * product_6 * product_7 * rho * sin_beta_squared * sum_29
        - 32.0 * path * sigma_beta_squared_squared * sin_beta * sum_23 * sum_3_squared * sum_4_squared * sum_5_squared
        - 384.0 * baseline_squared * product_16 * sigma_path_squared_squared * sum_25
        - 384.0 * baseline_squared * product_7 * rho * sigma_beta * sin_beta_squared * sum_24
        - 64.0 * product_6 * rho * sigma_path * sum_27 * sum_3_squared * sum_4 * sum_5
        - 64.0 * rho_squared * sigma_beta_squared * sigma_path_squared * sin_beta * sum_26 * sum_3_squared
        - 64.0 * sigma_beta_squared * sigma_path_squared * sin_beta * sum_28 * sum_3_squared
        + 1536.0 * baseline_squared * product_16 * rho_squared * sigma_beta_squared * sigma_path_squared_squared * sum_30
        + 192.0 * product_35 * rho * sigma_path * sum_31 * sum_4 * sum_5
        + 2304.0 * baseline_squared_squared * cos_beta * product_54 * sigma_path_squared_cubed
        + 2304.0 * baseline_squared_squared * product_15 * rho * sigma_beta * sin_beta_squared_squared * sum_32
        + 256.0 * rho_squared * sigma_beta_squared_squared * sigma_path_squared * sin_beta * sum_33
        + 512.0 * baseline_squared * product_5 * product_6 * product_7 * sin_beta_squared * sum_34
        + 64.0 * cos_beta * sigma_path_squared * sin_beta * sum_14_squared * sum_3_squared_squared
        + 64.0 * path * sigma_beta_squared * sin_beta * sum_35 * sum_3_squared_squared * sum_4_squared * sum_5_squared
        + 64.0 * path * sigma_beta_squared_cubed * sin_beta * sum_17 * sum_36 * sum_4_squared * sum_5_squared
        + 64.0 * sigma_beta_squared_squared * sigma_path_squared * sin_beta * sum_38
        + 64.0 * rho * sigma_beta * sigma_path * sum_14 * sum_37 * sum_3_squared_squared * sum_4 * sum_5
        + 768.0 * baseline_squared * product_16 * sigma_beta_squared * sigma_path_squared_squared * sum_39
    )
    sum_41 = (
        13.0 * baseline_squared * path_squared
        - 16.0 * baseline * cos_beta * product_4
        - 2.0 * path * product_2 * product_3
        - 25.0 * baseline_squared * cos_beta_squared * path_squared
        - 36.0 * baseline_squared_squared
        + 13.0 * baseline_squared_squared * cos_beta_squared
        + 46.0 * cos_beta * path * product_3
        + 7.0 * path_squared_squared
    )
    sum_42 = (
        22.0 * baseline * product_2 * product_4
        - 26.0 * baseline * cos_beta * product_4
        - 3.0 * path_squared_squared
        - 32.0 * path * product_2 * product_3
        - 36.0 * baseline_squared_squared
        - 47.0 * baseline_squared * cos_beta_squared * path_squared
        + 28.0 * baseline_squared * path_squared
        + 28.0 * baseline_squared_squared * cos_beta_squared
        + 52.0 * cos_beta * path * product_3
        + 7.0 * baseline_squared * cos_beta_squared_squared * path_squared
        + 7.0 * cos_beta_squared * path_squared_squared
    )
    product_60 = baseline_squared_squared * sin_beta_squared
    sum_43 = (
        product_13
        - 12.0 * baseline_squared * path_squared
        - 2.0 * baseline_squared_squared
        - 2.0 * cos_beta * path * product_3 * sin_beta_squared
        - 2.0 * path_squared_squared
        + product_14
        + product_46
        + product_47
        + product_60
    )
    sum_44 = (
        15.0 * baseline * path_squared_squared * sin_beta_squared
        - 11.0 * baseline_squared_squared * cos_beta * path * sin_beta_squared
        - 17.0 * baseline * path_squared_squared
        - 21.0 * baseline_squared * cos_beta * product_4 * sin_beta_squared
        - 42.0 * path_squared * product_3
        - 5.0 * product_17
        - 9.0 * path_squared * product_3 * sin_beta_squared_squared
        + 23.0 * baseline_squared_squared * cos_beta * path
        + 3.0 * cos_beta * product_18
        + 38.0 * baseline_squared * cos_beta * product_4
        + 4.0 * product_17 * sin_beta_squared
        + 45.0 * path_squared * product_3 * sin_beta_squared
        + product_17 * sin_beta_squared_squared
    )
    product_61 = 4.0 * baseline * cos_beta * product_4
    sum_45 = (
        12.0 * baseline_squared * path_squared
        - 15.0 * baseline_squared * path_squared * sin_beta_squared
        - 32.0 * cos_beta * path * product_3
        - path_squared_squared
        + 17.0 * baseline_squared_squared
        + product_60
        + product_61
    )
    sum_46 = (
        3.0 * baseline_squared * cos_beta * product_4 * sin_beta_squared
        - 11.0 * path_squared * product_3 * sin_beta_squared
        - 13.0 * baseline_squared_squared * cos_beta * path
        - 5.0 * baseline * path_squared_squared
        - baseline_squared_squared * cos_beta * path * sin_beta_squared
        + 4.0 * baseline_squared * cos_beta * product_4
        + 4.0 * baseline * path_squared_squared * sin_beta_squared
        + 5.0 * product_17
        + 8.0 * path_squared * product_3
        + product_17 * sin_beta_squared
        + product_20
    )
    product_62 = 3.0 * baseline_squared * path_squared
    sum_47 = (
        baseline_squared_squared * cos_beta_squared
        - 3.0 * baseline_squared * cos_beta_squared * path_squared
        - 6.0 * baseline_squared_squared
        + path_squared_squared
        + product_13
        + product_43
        + product_62
    )
    product_63 = -8.0 * baseline * cos_beta * product_38
    product_64 = sin_beta_squared_squared * term_1
    sum_48 = (
        12.0 * baseline_squared_squared * path_squared_squared * sin_beta_squared_squared
        - 124.0 * baseline_squared_cubed * path_squared * sin_beta_squared
        - 13.0 * baseline_squared * path_squared_cubed * sin_beta_squared
        - 31.0 * cos_beta * path * product_36 * sin_beta_squared
        - 36.0 * cos_beta * product_18 * product_3 * sin_beta_squared
        - 86.0 * baseline_squared_squared * path_squared_squared
        - 9.0 * baseline_squared_cubed * path_squared * sin_beta_squared_squared
        - 95.0 * cos_beta * path * product_36
        + 13.0 * cos_beta * product_18 * product_3
        + 19.0 * baseline_squared * path_squared_cubed
        + 22.0 * sin_beta_squared * term_1
        + 31.0 * term_1
        + 58.0 * cos_beta * product_17 * product_4
        + 67.0 * baseline_squared_cubed * path_squared
        + 83.0 * baseline_squared_squared * path_squared_squared * sin_beta_squared
        + 83.0 * cos_beta * product_17 * product_4 * sin_beta_squared
        + product_63
        + product_64
        + term_2
    )
    sum_49 = (
        166.0 * path * product_17 * product_2
        - 10.0 * baseline_squared * path_squared_squared
        - 132.0 * baseline_squared_squared * cos_beta_squared_squared * path_squared
        - 140.0 * product_2 * product_3 * product_4
        - 170.0 * cos_beta * path * product_17
        - 22.0 * baseline_squared * cos_beta_squared * path_squared_squared
        - 30.0 * baseline_squared_squared * path_squared
        - 4.0 * path_squared_cubed
        - 88.0 * baseline_squared_cubed * cos_beta_squared
        + 19.0 * baseline_squared_cubed * cos_beta_squared_squared
        + 207.0 * baseline_squared_squared * cos_beta_squared * path_squared
        + 24.0 * baseline * cos_beta * product_18
        + 50.0 * cos_beta * product_3 * product_4
        + 72.0 * baseline_squared_cubed
        + product_21
        + product_22
        + product_24
        + product_25
        + product_26
    )
    sum_50 = (
        117.0 * baseline_squared_squared * cos_beta_squared * path_squared
        - 100.0 * cos_beta * path * product_17
        - 2.0 * path_squared_cubed
        - 38.0 * baseline_squared_cubed * cos_beta_squared
        - 6.0 * baseline_squared_squared * path_squared
        - 66.0 * baseline_squared_squared * cos_beta_squared_squared * path_squared
        - 8.0 * baseline_squared * path_squared_squared
        - 88.0 * product_2 * product_3 * product_4
        + 12.0 * baseline * cos_beta * product_18
        + 16.0 * cos_beta * product_3 * product_4
        + 36.0 * baseline_squared_cubed
        + 4.0 * baseline_squared * cos_beta_squared * path_squared_squared
        + 86.0 * path * product_17 * product_2
        + product_27
        + product_28
        + product_29
        + product_30
        + product_31
        + product_32
    )
    product_65 = 28.0 * baseline_squared * path_squared_cubed
    sum_51 = (
        112.0 * cos_beta * product_17 * product_4
        - 122.0 * baseline_squared_squared * path_squared_squared
        - 140.0 * cos_beta * path * product_36
        - 18.0 * baseline_squared_cubed * path_squared * sin_beta_squared_squared
        - 214.0 * baseline_squared_cubed * path_squared * sin_beta_squared
        - 22.0 * baseline_squared * path_squared_cubed * sin_beta_squared
        - 72.0 * cos_beta * product_18 * product_3 * sin_beta_squared
        - 76.0 * cos_beta * path * product_36 * sin_beta_squared
        + 146.0 * baseline_squared_squared * path_squared_squared * sin_beta_squared
        + 164.0 * cos_beta * product_17 * product_4 * sin_beta_squared
        + 21.0 * baseline_squared_squared * path_squared_squared * sin_beta_squared_squared
        + 4.0 * cos_beta * product_18 * product_3
        + 49.0 * term_1
        + 58.0 * sin_beta_squared * term_1
        + 76.0 * baseline_squared_cubed * path_squared
        + product_63
        + product_64
        + product_65
        + term_2
    )
    sum_52 = (
        12.0 * cos_beta * path * product_36 * sin_beta_squared
        - 110.0 * baseline_squared_squared * path_squared_squared * sin_beta_squared
        - 2.0 * sin_beta_squared * term_1
        - 20.0 * cos_beta * product_17 * product_4 * sin_beta_squared_squared
        - 26.0 * baseline_squared * path_squared_cubed * sin_beta_squared
        - 4.0 * baseline_squared_cubed * path_squared * sin_beta_squared_cubed
        - 4.0 * cos_beta * path * product_36 * sin_beta_squared_squared
        - 54.0 * baseline_squared_cubed * path_squared * sin_beta_squared
        - 56.0 * cos_beta * product_17 * product_4
        - 56.0 * cos_beta * product_18 * product_3
        - 8.0 * cos_beta * path * product_36
        + 28.0 * baseline_squared_cubed * path_squared
        + 30.0 * baseline_squared_cubed * path_squared * sin_beta_squared_squared
        + 41.0 * baseline_squared_squared * path_squared_squared * sin_beta_squared_squared
        + 44.0 * cos_beta * product_18 * product_3 * sin_beta_squared
        + 70.0 * baseline_squared_squared * path_squared_squared
        + 72.0 * cos_beta * product_17 * product_4 * sin_beta_squared
        + product_63
        + product_64
        + product_65
        + term_1
        + term_2
    )
    sum_53 = (
        16.0 * baseline_squared * cos_beta * product_4 * sin_beta_squared
        - 25.0 * baseline * path_squared_squared
        - 6.0 * baseline_squared_squared * cos_beta * path * sin_beta_squared
        - 63.0 * path_squared * product_3 * sin_beta_squared
        - 68.0 * baseline_squared_squared * cos_beta * path
        + 24.0 * baseline_squared * cos_beta * product_4
        + 24.0 * baseline * path_squared_squared * sin_beta_squared
        + 27.0 * product_17
        + 38.0 * path_squared * product_3
        + 4.0 * cos_beta * product_18
        + 9.0 * product_17 * sin_beta_squared
    )
    sum_54 = (
        8.0 * baseline_squared_squared
        - 14.0 * cos_beta * path * product_3
        - path_squared_squared
        + product_44
        + product_60
        + product_61
        + product_62
    )
    sum_55 = (
        128.0 * rho * sigma_beta * sigma_path * sin_beta * sum_14 * sum_35 * sum_3_squared_squared * sum_4 * sum_5
        - 128.0 * product_6 * rho * sigma_path * sin_beta * sum_35 * sum_3_squared * sum_4 * sum_41 * sum_5
        - 32.0 * sigma_beta_squared_squared * sum_3_squared * sum_42 * sum_4_squared * sum_5_squared
        - 384.0 * baseline_squared * sigma_path_squared_squared * sin_beta_squared_squared * sum_43
        - 768.0 * baseline_squared * product_16 * product_7 * rho * sigma_beta * sum_44
        + 13824.0 * baseline_squared_squared * product_15 * product_54 * rho * sigma_beta * sum_35
        + 1536.0 * baseline_squared * rho_squared * sigma_beta_squared * sigma_path_squared_squared * sin_beta_squared_squared * sum_45
        + 2304.0 * baseline_squared_squared * sigma_path_squared_cubed * sin_beta_squared_cubed
        + 3072.0 * baseline_squared * product_16 * product_5 * product_6 * product_7 * sum_46
        + 384.0 * product_35 * rho * sigma_path * sin_beta * sum_36 * sum_4 * sum_47 * sum_5
        + 512.0 * rho_squared * sigma_beta_squared_squared * sigma_path_squared * sin_beta_squared * sum_48
        + 64.0 * rho_squared * sigma_beta_squared * sigma_path_squared * sum_3_squared * sum_49
        + 64.0 * sigma_beta_squared * sigma_path_squared * sum_3_squared * sum_50
        + 64.0 * sigma_beta_squared * sum_35**2 * sum_3_squared_squared * sum_4_squared * sum_5_squared
        + 64.0 * sigma_beta_squared_cubed * sum_36**2 * sum_4_squared * sum_5_squared
        + 64.0 * sigma_beta_squared_squared * sigma_path_squared * sin_beta_squared * sum_51
        + 64.0 * sigma_path_squared * sin_beta_squared * sum_52
        + 768.0 * baseline_squared * product_16 * product_6 * product_7 * rho * sum_53
        + 768.0 * baseline_squared * sigma_beta_squared * sigma_path_squared_squared * sin_beta_squared_squared * sum_54
    )
    result = _empty(arguments, (2, 2))
    result[..., 0, 0] = sum_22 * term_3
    result[..., 0, 1] = sum_40 * term_3
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = sum_55 * term_3
    return result


def unbiased_covariance_semidefinite(
    *,
    path: npt.ArrayLike,
    beta: npt.ArrayLike,
    baseline: npt.ArrayLike,
    sigma_path: npt.ArrayLike,
    sigma_beta: npt.ArrayLike,
    rho: npt.ArrayLike,
) -> Floats:
    """Error covariance of the unbiased estimate u, to fourth order, completed to a sum of squares.

    Name: bistatic.unbiased.covariance.semidefinite.
    Definition: u u' - u (e^L h)' - (e^L h) u' + e^L(h h') to sigma^4 + dg K dg', g = L h.
    Conditioning: measurement-conditioned: the measured symbols stand for the measurement.
    Source: Mo et al. 1998, doi:10.1109/7.705921.

    Args:
        path: length of the path from transmitter to target to receiver [m], 30000 to 1e+06.
        beta: azimuth at the receiver, counter-clockwise from the x axis, where the transmitter stands [rad], -3.1416 to 3.1416.
        baseline: distance from transmitter to receiver; less than the path [m], 1 to 20000.
        sigma_path: standard deviation of the error of path [m], 0.001 to 1000.
        sigma_beta: standard deviation of the error of beta [rad], 1e-09 to 0.1.
        rho: correlation of the errors of path and beta [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (2, 2), unit m^2.

    Accuracy: at most 12 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
    """
    arguments = _floats(path, beta, baseline, sigma_path, sigma_beta, rho)
    path, beta, baseline, sigma_path, sigma_beta, rho = arguments
    cos_beta = np.cos(beta)
    divisor_1 = 2.0 * path - 2.0 * baseline * cos_beta
    sin_beta = np.sin(beta)
    sin_beta_squared = sin_beta**2
    baseline_squared = baseline**2
    baseline_squared_squared = baseline_squared**2
    sigma_path_squared = sigma_path**2
    product_1 = sigma_path * sigma_path_squared**2
    product_2 = sin_beta * sin_beta_squared
    sum_1 = (
        2.0 * cos_beta * path
        - 2.0 * baseline
        - 3.0 * cos_beta * path * sin_beta_squared
        + 2.0 * baseline * sin_beta_squared
    )
    path_squared = path**2
    product_3 = path * path_squared
    product_4 = -12.0 * baseline * cos_beta * product_3
    path_squared_squared = path_squared**2
    product_5 = -3.0 * path_squared_squared * sin_beta_squared
    sin_beta_squared_squared = sin_beta_squared**2
    product_6 = baseline * baseline_squared
    product_7 = 12.0 * baseline * cos_beta * product_3 * sin_beta_squared
    product_8 = 3.0 * baseline_squared_squared * sin_beta_squared_squared
    product_9 = 32.0 * cos_beta * path * product_6
    rho_squared = rho**2
    sigma_beta_squared = sigma_beta**2
    sigma_path_squared_squared = sigma_path_squared**2
    sum_2 = (
        16.0 * baseline_squared_squared * sin_beta_squared
        - 19.0 * baseline_squared_squared
        - 4.0 * baseline_squared * path_squared
        - 45.0 * baseline_squared * path_squared * sin_beta_squared_squared
        - 60.0 * cos_beta * path * product_6 * sin_beta_squared
        + 3.0 * path_squared_squared
        + 45.0 * baseline_squared * path_squared * sin_beta_squared
        + product_4
        + product_5
        + product_7
        + product_8
        + product_9
    )
    product_10 = baseline * baseline_squared**2
    cos_beta_squared = cos_beta**2
    cos_beta_squared_squared = cos_beta_squared**2
    product_11 = cos_beta * cos_beta_squared
    product_12 = path * path_squared**2
    product_13 = cos_beta * cos_beta_squared**2
    product_14 = cos_beta * product_12
    product_15 = sigma_beta * sigma_beta_squared
    product_16 = sigma_path * sigma_path_squared
    sum_3 = (
        24.0 * baseline_squared * product_13 * product_3
        - 10.0 * cos_beta_squared * product_10
        - 10.0 * path_squared * product_6
        - 11.0 * baseline * cos_beta_squared * path_squared_squared
        - 34.0 * baseline_squared_squared * cos_beta * path
        - 51.0 * cos_beta_squared_squared * path_squared * product_6
        - 6.0 * product_11 * product_12
        - 9.0 * baseline_squared_squared * path * product_13
        - 92.0 * baseline_squared * product_11 * product_3
        + 28.0 * baseline_squared * cos_beta * product_3
        + 36.0 * baseline * cos_beta_squared_squared * path_squared_squared
        + 48.0 * baseline_squared_squared * path * product_11
        + 5.0 * cos_beta_squared_squared * product_10
        + 81.0 * cos_beta_squared * path_squared * product_6
        + product_14
    )
    product_17 = baseline * cos_beta
    sum_4 = product_17 - path
    sum_4_squared = sum_4**2
    sum_5 = baseline + path
    sum_6 = baseline - path
    sum_7 = (
        20.0 * cos_beta_squared * path * product_6
        - 11.0 * baseline * cos_beta_squared * product_3
        - 12.0 * baseline_squared_squared * cos_beta
        - 12.0 * path * product_6
        - 17.0 * baseline_squared * path_squared * product_11
        - 6.0 * baseline * product_3
        - cos_beta_squared_squared * path * product_6
        + 29.0 * baseline_squared * cos_beta * path_squared
        + 5.0 * baseline_squared_squared * product_11
        + 5.0 * cos_beta * path_squared_squared
    )
    sum_8 = (
        4.0 * cos_beta_squared * path * product_6
        - 2.0 * baseline_squared_squared * cos_beta
        - 3.0 * baseline_squared * path_squared * product_11
        - 4.0 * baseline * cos_beta_squared * product_3
        - 4.0 * path * product_6
        + 7.0 * baseline_squared * cos_beta * path_squared
        + baseline_squared_squared * product_11
        + cos_beta * path_squared_squared
    )
    product_18 = rho * rho_squared
    sum_9 = 2.0 * baseline * cos_beta - 3.0 * cos_beta_squared * path + path
    sigma_path_squared_cubed = sigma_path_squared * sigma_path_squared**2
    product_19 = 8.0 * cos_beta * path * product_6
    sum_10 = (
        3.0 * path_squared_squared
        - 18.0 * baseline_squared * path_squared * sin_beta_squared_squared
        - 24.0 * cos_beta * path * product_6 * sin_beta_squared
        - 7.0 * baseline_squared_squared
        + 4.0 * baseline_squared_squared * sin_beta_squared
        + 8.0 * baseline_squared * path_squared
        + 9.0 * baseline_squared * path_squared * sin_beta_squared
        + product_19
        + product_4
        + product_5
        + product_7
        + product_8
    )
    product_20 = -42.0 * baseline * product_11 * product_12
    path_squared_cubed = path_squared * path_squared**2
    product_21 = -6.0 * baseline_squared * path_squared_squared
    product_22 = -6.0 * path * product_10 * product_13
    baseline_squared_cubed = baseline_squared * baseline_squared**2
    product_23 = 14.0 * product_13 * product_3 * product_6
    product_24 = 69.0 * baseline_squared * cos_beta_squared_squared * path_squared_squared
    product_25 = 7.0 * cos_beta_squared * path_squared_cubed
    sum_11 = (
        24.0 * cos_beta * product_3 * product_6
        - 30.0 * cos_beta * path * product_10
        - 37.0 * baseline_squared * cos_beta_squared * path_squared_squared
        - 5.0 * path_squared_cubed
        - 62.0 * product_11 * product_3 * product_6
        - 64.0 * baseline_squared_squared * cos_beta_squared_squared * path_squared
        - 9.0 * baseline_squared_cubed * cos_beta_squared
        - 9.0 * baseline_squared_squared * path_squared
        + 30.0 * baseline * cos_beta * product_12
        + 40.0 * path * product_10 * product_11
        + 7.0 * baseline_squared_cubed * cos_beta_squared_squared
        + 79.0 * baseline_squared_squared * cos_beta_squared * path_squared
        + product_20
        + product_21
        + product_22
        + product_23
        + product_24
        + product_25
    )
    product_26 = -12.0 * baseline * product_11 * product_12
    product_27 = 10.0 * product_13 * product_3 * product_6
    product_28 = 2.0 * cos_beta_squared * path_squared_cubed
    product_29 = 24.0 * baseline_squared * cos_beta_squared_squared * path_squared_squared
    product_30 = 6.0 * baseline * cos_beta * product_12
    sum_12 = (
        12.0 * cos_beta * product_3 * product_6
        - 11.0 * baseline_squared * cos_beta_squared * path_squared_squared
        - 18.0 * cos_beta * path * product_10
        - 26.0 * baseline_squared_squared * cos_beta_squared_squared * path_squared
        - 3.0 * baseline_squared_cubed * cos_beta_squared
        - 3.0 * baseline_squared_squared * path_squared
        - 34.0 * product_11 * product_3 * product_6
        - path_squared_cubed
        + 2.0 * baseline_squared_cubed * cos_beta_squared_squared
        + 26.0 * path * product_10 * product_11
        + 32.0 * baseline_squared_squared * cos_beta_squared * path_squared
        + product_22
        + product_26
        + product_27
        + product_28
        + product_29
        + product_30
    )
    sum_13 = (
        2.0 * cos_beta_squared * product_3
        - 2.0 * baseline_squared * path
        - 2.0 * cos_beta * product_6
        - 6.0 * baseline * path_squared * product_11
        - product_3
        + 3.0 * baseline * cos_beta * path_squared
        + 5.0 * baseline_squared * cos_beta_squared * path
        + product_11 * product_6
    )
    sum_4_squared_squared = sum_4_squared**2
    sum_14 = baseline_squared - 2.0 * baseline * cos_beta * path + path_squared
    product_31 = baseline * baseline_squared * baseline_squared**2
    term_1 = (baseline_squared**2)**2
    product_32 = -4.0 * cos_beta_squared_squared * term_1
    product_33 = path * path_squared * path_squared**2
    product_34 = -8.0 * baseline * product_11 * product_33
    cos_beta_squared_cubed = cos_beta_squared * cos_beta_squared**2
    product_35 = 4.0 * cos_beta_squared * term_1
    product_36 = cos_beta_squared_cubed * term_1
    term_2 = (path_squared**2)**2
    product_37 = cos_beta_squared * term_2
    sigma_beta_squared_squared = sigma_beta_squared**2
    sum_15 = (
        10.0 * baseline_squared * cos_beta_squared * path_squared_cubed
        - 105.0 * baseline_squared_squared * cos_beta_squared_squared * path_squared_squared
        - 2.0 * cos_beta * product_12 * product_6
        - 38.0 * path * product_11 * product_31
        - 46.0 * product_10 * product_13 * product_3
        - 66.0 * product_11 * product_12 * product_6
        - 7.0 * baseline_squared_squared * path_squared_squared
        - 74.0 * cos_beta * product_10 * product_3
        - 9.0 * baseline_squared_cubed * cos_beta_squared_cubed * path_squared
        - 93.0 * baseline_squared_cubed * cos_beta_squared * path_squared
        + 10.0 * path * product_13 * product_31
        + 114.0 * baseline_squared_squared * cos_beta_squared * path_squared_squared
        + 12.0 * baseline_squared_squared * cos_beta_squared_cubed * path_squared_squared
        + 128.0 * product_10 * product_11 * product_3
        + 13.0 * baseline_squared * cos_beta_squared_squared * path_squared_cubed
        + 22.0 * baseline_squared_cubed * path_squared
        + 28.0 * cos_beta * path * product_31
        + 36.0 * product_12 * product_13 * product_6
        + 72.0 * baseline_squared_cubed * cos_beta_squared_squared * path_squared
        + baseline_squared * path_squared_cubed
        + product_32
        + product_34
        + product_35
        + product_36
        + product_37
    )
    sum_5_squared = sum_5**2
    sum_6_squared = sum_6**2
    product_38 = 6.0 * baseline_squared * path_squared
    product_39 = baseline_squared_squared * sin_beta_squared_squared
    sigma_beta_squared_cubed = sigma_beta_squared * sigma_beta_squared**2
    sum_16 = (
        10.0 * baseline_squared_squared * sin_beta_squared
        - 18.0 * baseline_squared * path_squared * sin_beta_squared
        - 40.0 * cos_beta * path * product_6
        - 8.0 * cos_beta * path * product_6 * sin_beta_squared
        + 25.0 * baseline_squared_squared
        + 8.0 * baseline * cos_beta * product_3
        + path_squared_squared
        + product_38
        + product_39
    )
    sum_17 = (
        16.0 * cos_beta * product_12 * product_6
        - 120.0 * product_11 * product_12 * product_6
        - 128.0 * cos_beta * product_10 * product_3
        - 18.0 * baseline_squared_cubed * cos_beta_squared_cubed * path_squared
        - 192.0 * baseline_squared_cubed * cos_beta_squared * path_squared
        - 2.0 * baseline_squared * cos_beta_squared * path_squared_cubed
        - 204.0 * baseline_squared_squared * cos_beta_squared_squared * path_squared_squared
        - 28.0 * baseline_squared_squared * path_squared_squared
        - 80.0 * path * product_11 * product_31
        - 88.0 * product_10 * product_13 * product_3
        + 16.0 * path * product_13 * product_31
        + 162.0 * baseline_squared_cubed * cos_beta_squared_squared * path_squared
        + 21.0 * baseline_squared_squared * cos_beta_squared_cubed * path_squared_squared
        + 22.0 * baseline_squared * cos_beta_squared_squared * path_squared_cubed
        + 224.0 * product_10 * product_11 * product_3
        + 225.0 * baseline_squared_squared * cos_beta_squared * path_squared_squared
        + 4.0 * baseline_squared * path_squared_cubed
        + 40.0 * baseline_squared_cubed * path_squared
        + 64.0 * cos_beta * path * product_31
        + 72.0 * product_12 * product_13 * product_6
        + product_32
        + product_34
        + product_35
        + product_36
        + product_37
    )
    sum_18 = (
        14.0 * baseline * path * product_11
        - 2.0 * path_squared
        - 20.0 * baseline * cos_beta * path
        - 26.0 * baseline_squared * cos_beta_squared
        + 24.0 * baseline_squared
        + 5.0 * baseline_squared * cos_beta_squared_squared
        + 5.0 * cos_beta_squared * path_squared
    )
    product_40 = baseline_squared * cos_beta_squared
    sum_19 = 2.0 * baseline * cos_beta * path - 2.0 * baseline_squared - path_squared + product_40
    product_41 = -4.0 * baseline * cos_beta * product_3
    product_42 = -6.0 * baseline_squared * path_squared * sin_beta_squared
    sum_20 = (
        4.0 * cos_beta * path * product_6 * sin_beta_squared
        - 2.0 * baseline_squared_squared * sin_beta_squared
        - 4.0 * cos_beta * path * product_6
        + baseline_squared_squared
        + path_squared_squared
        + product_38
        + product_39
        + product_41
        + product_42
    )
    sum_14_squared = sum_14**2
    sum_21 = 4.0 * baseline * cos_beta * path - 6.0 * baseline_squared + path_squared + product_40
    product_43 = sigma_beta * sigma_beta_squared**2
    term_3 = 1.0 / ((divisor_1**2)**2)**2
    sum_22 = (
        128.0 * cos_beta * path * rho * sigma_beta * sigma_path * sin_beta * sum_14 * sum_4_squared_squared * sum_5 * sum_6
        - 1152.0 * baseline_squared_squared * product_1 * product_2 * rho * sigma_beta * sum_1
        - 128.0 * baseline_squared * product_15 * product_16 * rho * sin_beta * sum_3
        - 128.0 * baseline_squared * rho_squared * sigma_beta_squared * sigma_path_squared_squared * sin_beta_squared * sum_2
        - 128.0 * path * product_15 * rho * sigma_path * sin_beta * sum_4_squared * sum_5 * sum_6 * sum_7
        - 256.0 * baseline_squared * product_15 * product_16 * product_18 * sin_beta * sum_8 * sum_9
        - 576.0 * baseline_squared_squared * sigma_path_squared_cubed * (1.0 + sin_beta) * (sin_beta - 1.0) * sin_beta_squared_squared
        - 64.0 * baseline_squared * sigma_beta_squared * sigma_path_squared_squared * sin_beta_squared * sum_10
        - 64.0 * rho_squared * sigma_beta_squared * sigma_path_squared * sum_11 * sum_4_squared
        - 64.0 * sigma_beta_squared * sigma_path_squared * sum_12 * sum_4_squared
        - 768.0 * baseline_squared * cos_beta * product_16 * rho * sigma_beta * sin_beta * sum_13 * sum_4_squared
        + 128.0 * rho_squared * sigma_beta_squared_squared * sigma_path_squared * sum_15
        + 16.0 * path_squared * sigma_beta_squared_cubed * sin_beta_squared * sum_16 * sum_5_squared * sum_6_squared
        + 16.0 * sigma_beta_squared_squared * sigma_path_squared * sum_17
        + 32.0 * path_squared * sigma_beta_squared_squared * sum_18 * sum_4_squared * sum_5_squared * sum_6_squared
        + 384.0 * baseline_squared * (1.0 + cos_beta) * (cos_beta - 1.0) * cos_beta_squared * sigma_path_squared_squared * sum_19 * sum_4_squared
        + 64.0 * cos_beta_squared * sigma_path_squared * sum_14_squared * sum_4_squared_squared
        + 64.0 * path_squared * sigma_beta_squared * sin_beta_squared * sum_20 * sum_5_squared * sum_6_squared
        + 96.0 * path * product_43 * rho * sigma_path * sin_beta * sum_21 * sum_5 * sum_6 * sum_8
    )
    sum_23 = (
        12.0 * baseline_squared * path_squared_squared * product_11
        - 17.0 * baseline_squared_squared * path_squared * product_11
        - 17.0 * cos_beta_squared * product_3 * product_6
        - 3.0 * cos_beta_squared_squared * path * product_10
        - 6.0 * baseline_squared_cubed * cos_beta
        - 6.0 * baseline * cos_beta_squared * product_12
        - 6.0 * path * product_10
        + 14.0 * baseline_squared_squared * cos_beta * path_squared
        + 17.0 * cos_beta_squared * path * product_10
        + 2.0 * product_3 * product_6
        + 3.0 * baseline_squared_cubed * product_11
        + 5.0 * cos_beta_squared_squared * product_3 * product_6
        + baseline_squared * cos_beta * path_squared_squared
        + cos_beta * path_squared_cubed
    )
    sum_24 = (
        11.0 * cos_beta_squared * product_6
        - 14.0 * baseline * cos_beta_squared * path_squared
        - 24.0 * product_6
        - 5.0 * baseline_squared * path * product_11
        - 5.0 * cos_beta * product_3
        + 11.0 * baseline * path_squared
        + 26.0 * baseline_squared * cos_beta * path
    )
    sum_25 = (
        10.0 * product_12
        - 124.0 * baseline_squared * cos_beta_squared * product_3
        - 143.0 * path_squared * product_11 * product_6
        - 2.0 * baseline_squared * product_3
        - 20.0 * cos_beta_squared * product_12
        - 24.0 * cos_beta * product_10
        - 28.0 * baseline_squared_squared * cos_beta_squared_squared * path
        - 3.0 * baseline * cos_beta * path_squared_squared
        - 72.0 * baseline_squared_squared * path
        + 104.0 * baseline_squared_squared * cos_beta_squared * path
        + 167.0 * cos_beta * path_squared * product_6
        + 19.0 * product_10 * product_11
        + 4.0 * path_squared * product_13 * product_6
        + 44.0 * baseline * path_squared_squared * product_11
        + 68.0 * baseline_squared * cos_beta_squared_squared * product_3
    )
    sum_26 = (
        19.0 * baseline_squared_squared * path
        - 12.0 * cos_beta * path_squared * product_6 * sin_beta_squared_squared
        - 16.0 * baseline * cos_beta * path_squared_squared
        - 28.0 * baseline_squared_squared * path * sin_beta_squared
        - 36.0 * cos_beta * path_squared * product_6
        - 4.0 * cos_beta * product_10
        - 4.0 * product_12 * sin_beta_squared
        - 64.0 * baseline_squared * product_3 * sin_beta_squared
        + 2.0 * cos_beta * product_10 * sin_beta_squared
        + 2.0 * cos_beta * product_10 * sin_beta_squared_squared
        + 20.0 * baseline * cos_beta * path_squared_squared * sin_beta_squared
        + 28.0 * baseline_squared * product_3 * sin_beta_squared_squared
        + 3.0 * product_12
        + 34.0 * baseline_squared * product_3
        + 46.0 * cos_beta * path_squared * product_6 * sin_beta_squared
        + 9.0 * baseline_squared_squared * path * sin_beta_squared_squared
    )
    product_44 = -4.0 * baseline * product_3 * sin_beta_squared
    product_45 = -cos_beta * path_squared_squared
    product_46 = 4.0 * baseline * product_3
    sum_27 = (
        4.0 * baseline_squared * cos_beta * path_squared * sin_beta_squared
        - 4.0 * path * product_6 * sin_beta_squared
        - 6.0 * baseline_squared * cos_beta * path_squared
        - baseline_squared_squared * cos_beta
        + 4.0 * path * product_6
        + baseline_squared_squared * cos_beta * sin_beta_squared_squared
        + product_44
        + product_45
        + product_46
    )
    sum_28 = (
        14.0 * cos_beta_squared_squared * product_3 * product_6
        - 24.0 * baseline_squared_cubed * cos_beta
        - 24.0 * path * product_10
        - 4.0 * product_3 * product_6
        - 42.0 * baseline * cos_beta_squared * product_12
        - 6.0 * cos_beta_squared_squared * path * product_10
        - 74.0 * baseline_squared_squared * path_squared * product_11
        - 86.0 * cos_beta_squared * product_3 * product_6
        + 22.0 * baseline_squared * cos_beta * path_squared_squared
        + 68.0 * cos_beta_squared * path * product_10
        + 69.0 * baseline_squared * path_squared_squared * product_11
        + 7.0 * cos_beta * path_squared_cubed
        + 71.0 * baseline_squared_squared * cos_beta * path_squared
        + 9.0 * baseline_squared_cubed * product_11
    )
    sum_29 = (
        13.0 * cos_beta * product_10
        - 17.0 * baseline_squared * product_3 * sin_beta_squared
        - 18.0 * baseline_squared * product_3 * sin_beta_squared_squared
        - 25.0 * baseline * cos_beta * path_squared_squared
        - 29.0 * baseline_squared_squared * path
        - 51.0 * cos_beta * path_squared * product_6 * sin_beta_squared
        - 6.0 * product_12 * sin_beta_squared
        + 24.0 * baseline * cos_beta * path_squared_squared * sin_beta_squared
        + 32.0 * baseline_squared * product_3
        + 4.0 * cos_beta * path_squared * product_6
        + 41.0 * baseline_squared_squared * path * sin_beta_squared
        + 5.0 * cos_beta * product_10 * sin_beta_squared
        + 5.0 * product_12
        + 6.0 * baseline_squared_squared * path * sin_beta_squared_squared
    )
    sum_30 = (
        4.0 * baseline_squared * cos_beta * path
        - 4.0 * baseline * cos_beta_squared * path_squared
        - 6.0 * product_6
        - baseline_squared * path * product_11
        - cos_beta * product_3
        + 4.0 * cos_beta_squared * product_6
        + 4.0 * baseline * path_squared
    )
    product_47 = -18.0 * baseline_squared_cubed * path_squared * product_13
    product_48 = -24.0 * product_11 * term_1
    product_49 = 36.0 * cos_beta * term_1
    product_50 = 72.0 * cos_beta_squared_squared * product_12 * product_6
    product_51 = 72.0 * path * product_31
    sum_31 = (
        10.0 * product_12 * product_6
        - 126.0 * cos_beta_squared_squared * product_10 * product_3
        - 146.0 * cos_beta_squared * path * product_31
        - 188.0 * baseline_squared_cubed * cos_beta * path_squared
        - 196.0 * baseline_squared_squared * path_squared_squared * product_11
        - 74.0 * product_10 * product_3
        - 8.0 * baseline * cos_beta_squared * product_33
        - 94.0 * cos_beta_squared * product_12 * product_6
        + 121.0 * baseline_squared_squared * cos_beta * path_squared_squared
        + 190.0 * baseline_squared_cubed * path_squared * product_11
        + 2.0 * baseline_squared * cos_beta * path_squared_cubed
        + 21.0 * baseline_squared_squared * path_squared_squared * product_13
        + 22.0 * baseline_squared * path_squared_cubed * product_11
        + 280.0 * cos_beta_squared * product_10 * product_3
        + 46.0 * cos_beta_squared_squared * path * product_31
        + cos_beta * term_2
        + product_13 * term_1
        + product_47
        + product_48
        + product_49
        + product_50
        + product_51
    )
    product_52 = baseline_squared_squared * cos_beta * sin_beta_squared
    sum_32 = (
        11.0 * path * product_6 * sin_beta_squared
        - 6.0 * baseline_squared * cos_beta * path_squared * sin_beta_squared
        - 8.0 * path * product_6
        + 5.0 * baseline_squared_squared * cos_beta
        + product_44
        + product_45
        + product_46
        + product_52
    )
    sum_33 = (
        14.0 * cos_beta * path_squared * product_6
        - 112.0 * baseline_squared * product_3 * sin_beta_squared
        - 125.0 * baseline * cos_beta * path_squared_squared
        - 154.0 * baseline_squared_squared * path
        - 24.0 * product_12 * sin_beta_squared
        - 291.0 * cos_beta * path_squared * product_6 * sin_beta_squared
        - 96.0 * baseline_squared * product_3 * sin_beta_squared_squared
        + 144.0 * baseline * cos_beta * path_squared_squared * sin_beta_squared
        + 172.0 * baseline_squared * product_3
        + 22.0 * product_12
        + 226.0 * baseline_squared_squared * path * sin_beta_squared
        + 36.0 * baseline_squared_squared * path * sin_beta_squared_squared
        + 37.0 * cos_beta * product_10 * sin_beta_squared
        + 71.0 * cos_beta * product_10
    )
    sum_34 = (
        11.0 * baseline_squared_squared * cos_beta
        - 15.0 * baseline_squared * cos_beta * path_squared * sin_beta_squared
        - 20.0 * path * product_6
        + 26.0 * path * product_6 * sin_beta_squared
        + 6.0 * baseline_squared * cos_beta * path_squared
        + product_44
        + product_45
        + product_46
        + product_52
    )
    sin_beta_squared_cubed = sin_beta_squared * sin_beta_squared**2
    sum_35 = (
        2.0 * baseline_squared_cubed * path * sin_beta_squared_cubed
        - 14.0 * cos_beta * path_squared_squared * product_6
        - 3.0 * baseline_squared_cubed * path
        - 32.0 * cos_beta * path_squared * product_10 * sin_beta_squared_squared
        - 38.0 * baseline_squared * product_12 * sin_beta_squared
        - 6.0 * baseline_squared_squared * product_3 * sin_beta_squared_cubed
        - 8.0 * cos_beta * path_squared * product_10
        - 91.0 * baseline_squared_squared * product_3 * sin_beta_squared_squared
        - 98.0 * cos_beta * path_squared * product_10 * sin_beta_squared
        - baseline_squared * product_12
        - product_33
        + 2.0 * cos_beta * product_31
        + 2.0 * product_33 * sin_beta_squared
        + 21.0 * baseline_squared_squared * product_3
        + 29.0 * baseline_squared_cubed * path * sin_beta_squared_squared
        + 32.0 * baseline_squared_cubed * path * sin_beta_squared
        + 32.0 * cos_beta * path_squared_squared * product_6 * sin_beta_squared_squared
        + 36.0 * baseline_squared * product_12 * sin_beta_squared_squared
        + 36.0 * baseline_squared_squared * product_3 * sin_beta_squared
        + 4.0 * baseline * cos_beta * path_squared_cubed
        + 4.0 * cos_beta * product_31 * sin_beta_squared_squared
        + 52.0 * cos_beta * path_squared_squared * product_6 * sin_beta_squared
        + 6.0 * cos_beta * product_31 * sin_beta_squared
    )
    sum_36 = 5.0 * baseline * cos_beta - 5.0 * path + 6.0 * path * sin_beta_squared
    product_53 = sin_beta * sin_beta_squared**2
    sum_37 = baseline - cos_beta * path
    sum_38 = (
        104.0 * baseline_squared_squared * cos_beta * path_squared_squared
        - 129.0 * cos_beta_squared_squared * product_10 * product_3
        - 139.0 * cos_beta_squared * path * product_31
        - 16.0 * baseline * cos_beta_squared * product_33
        - 212.0 * baseline_squared_squared * path_squared_squared * product_11
        - 214.0 * baseline_squared_cubed * cos_beta * path_squared
        - 55.0 * product_10 * product_3
        - 89.0 * cos_beta_squared * product_12 * product_6
        - product_12 * product_6
        + 16.0 * baseline_squared * cos_beta * path_squared_cubed
        + 194.0 * baseline_squared_cubed * path_squared * product_11
        + 2.0 * cos_beta * term_2
        + 2.0 * product_13 * term_1
        + 24.0 * baseline_squared_squared * path_squared_squared * product_13
        + 26.0 * baseline_squared * path_squared_cubed * product_11
        + 308.0 * cos_beta_squared * product_10 * product_3
        + 41.0 * cos_beta_squared_squared * path * product_31
        + product_47
        + product_48
        + product_49
        + product_50
        + product_51
    )
    sum_39 = path - 2.0 * cos_beta_squared * path + product_17
    sum_40 = (
        128.0 * baseline_squared * product_15 * product_16 * product_18 * sin_beta_squared * sum_29
        - 128.0 * sigma_beta_squared * sigma_path_squared * sin_beta * sum_23 * sum_4_squared
        - 32.0 * product_15 * rho * sigma_path * sum_25 * sum_4_squared * sum_5 * sum_6
        - 32.0 * path * sigma_beta_squared_squared * sin_beta * sum_24 * sum_4_squared * sum_5_squared * sum_6_squared
        - 384.0 * baseline_squared * product_16 * rho * sigma_beta * sin_beta_squared * sum_26
        - 384.0 * baseline_squared * product_2 * sigma_path_squared_squared * sum_27
        - 64.0 * rho_squared * sigma_beta_squared * sigma_path_squared * sin_beta * sum_28 * sum_4_squared
        + 16.0 * path * sigma_beta_squared_cubed * sin_beta * sum_21 * sum_30 * sum_5_squared * sum_6_squared
        + 16.0 * sigma_beta_squared_squared * sigma_path_squared * sin_beta * sum_31
        + 192.0 * baseline_squared * product_2 * sigma_beta_squared * sigma_path_squared_squared * sum_32
        + 32.0 * baseline_squared * product_15 * product_16 * rho * sin_beta_squared * sum_33
        + 384.0 * baseline_squared * product_2 * rho_squared * sigma_beta_squared * sigma_path_squared_squared * sum_34
        + 48.0 * product_43 * rho * sigma_path * sum_35 * sum_5 * sum_6
        + 576.0 * baseline_squared_squared * cos_beta * product_53 * sigma_path_squared_cubed
        + 576.0 * baseline_squared_squared * product_1 * rho * sigma_beta * sin_beta_squared_squared * sum_36
        + 64.0 * cos_beta * sigma_path_squared * sin_beta * sum_14_squared * sum_4_squared_squared
        + 64.0 * rho_squared * sigma_beta_squared_squared * sigma_path_squared * sin_beta * sum_38
        + 64.0 * path * sigma_beta_squared * sin_beta * sum_37 * sum_4_squared_squared * sum_5_squared * sum_6_squared
        + 64.0 * rho * sigma_beta * sigma_path * sum_14 * sum_39 * sum_4_squared_squared * sum_5 * sum_6
    )
    sum_41 = (
        14.0 * baseline * product_11 * product_3
        - 16.0 * baseline * cos_beta * product_3
        - 22.0 * path * product_11 * product_6
        - 24.0 * baseline_squared_squared
        - 3.0 * path_squared_squared
        - 31.0 * baseline_squared * cos_beta_squared * path_squared
        + 20.0 * baseline_squared * path_squared
        + 20.0 * baseline_squared_squared * cos_beta_squared
        + 5.0 * baseline_squared * cos_beta_squared_squared * path_squared
        + 5.0 * cos_beta_squared * path_squared_squared
        + product_9
    )
    product_54 = 4.0 * baseline * cos_beta * product_3
    sum_42 = (
        4.0 * baseline_squared * path_squared * sin_beta_squared
        - 6.0 * baseline_squared * path_squared
        - baseline_squared_squared
        - path_squared_squared
        + 4.0 * cos_beta * path * product_6
        + product_39
        + product_54
    )
    sum_43 = (
        106.0 * baseline_squared_squared * cos_beta * path
        - 10.0 * cos_beta * product_12
        - 101.0 * cos_beta_squared * path_squared * product_6
        - 18.0 * baseline_squared_squared * path * product_11
        - 32.0 * baseline_squared * cos_beta * product_3
        - 48.0 * product_10
        + 19.0 * cos_beta_squared * product_10
        + 19.0 * path_squared * product_6
        + 2.0 * cos_beta_squared_squared * path_squared * product_6
        + 22.0 * baseline * cos_beta_squared * path_squared_squared
        + 34.0 * baseline_squared * product_11 * product_3
        + 7.0 * baseline * path_squared_squared
    )
    product_55 = -6.0 * baseline_squared_squared * cos_beta * path * sin_beta_squared
    product_56 = 24.0 * baseline_squared * cos_beta * product_3
    sum_44 = (
        10.0 * baseline * path_squared_squared * sin_beta_squared
        - 11.0 * baseline * path_squared_squared
        - 14.0 * baseline_squared * cos_beta * product_3 * sin_beta_squared
        - 26.0 * path_squared * product_6
        - 3.0 * product_10
        - 6.0 * path_squared * product_6 * sin_beta_squared_squared
        + 14.0 * baseline_squared_squared * cos_beta * path
        + 2.0 * cos_beta * product_12
        + 2.0 * product_10 * sin_beta_squared
        + 28.0 * path_squared * product_6 * sin_beta_squared
        + product_10 * sin_beta_squared_squared
        + product_55
        + product_56
    )
    product_57 = -8.0 * baseline * cos_beta * product_33
    product_58 = sin_beta_squared_squared * term_1
    sum_45 = (
        12.0 * baseline_squared_squared * path_squared_squared * sin_beta_squared_squared
        - 124.0 * baseline_squared_cubed * path_squared * sin_beta_squared
        - 13.0 * baseline_squared * path_squared_cubed * sin_beta_squared
        - 31.0 * cos_beta * path * product_31 * sin_beta_squared
        - 36.0 * cos_beta * product_12 * product_6 * sin_beta_squared
        - 86.0 * baseline_squared_squared * path_squared_squared
        - 9.0 * baseline_squared_cubed * path_squared * sin_beta_squared_squared
        - 95.0 * cos_beta * path * product_31
        + 13.0 * cos_beta * product_12 * product_6
        + 19.0 * baseline_squared * path_squared_cubed
        + 22.0 * sin_beta_squared * term_1
        + 31.0 * term_1
        + 58.0 * cos_beta * product_10 * product_3
        + 67.0 * baseline_squared_cubed * path_squared
        + 83.0 * baseline_squared_squared * path_squared_squared * sin_beta_squared
        + 83.0 * cos_beta * product_10 * product_3 * sin_beta_squared
        + product_57
        + product_58
        + term_2
    )
    product_59 = 28.0 * baseline_squared * path_squared_cubed
    sum_46 = (
        112.0 * cos_beta * product_10 * product_3
        - 122.0 * baseline_squared_squared * path_squared_squared
        - 140.0 * cos_beta * path * product_31
        - 18.0 * baseline_squared_cubed * path_squared * sin_beta_squared_squared
        - 214.0 * baseline_squared_cubed * path_squared * sin_beta_squared
        - 22.0 * baseline_squared * path_squared_cubed * sin_beta_squared
        - 72.0 * cos_beta * product_12 * product_6 * sin_beta_squared
        - 76.0 * cos_beta * path * product_31 * sin_beta_squared
        + 146.0 * baseline_squared_squared * path_squared_squared * sin_beta_squared
        + 164.0 * cos_beta * product_10 * product_3 * sin_beta_squared
        + 21.0 * baseline_squared_squared * path_squared_squared * sin_beta_squared_squared
        + 4.0 * cos_beta * product_12 * product_6
        + 49.0 * term_1
        + 58.0 * sin_beta_squared * term_1
        + 76.0 * baseline_squared_cubed * path_squared
        + product_57
        + product_58
        + product_59
        + term_2
    )
    sum_47 = (
        16.0 * baseline_squared * cos_beta * product_3 * sin_beta_squared
        - 25.0 * baseline * path_squared_squared
        - 63.0 * path_squared * product_6 * sin_beta_squared
        - 68.0 * baseline_squared_squared * cos_beta * path
        + 24.0 * baseline * path_squared_squared * sin_beta_squared
        + 27.0 * product_10
        + 38.0 * path_squared * product_6
        + 4.0 * cos_beta * product_12
        + 9.0 * product_10 * sin_beta_squared
        + product_55
        + product_56
    )
    product_60 = 3.0 * baseline_squared * path_squared
    product_61 = baseline_squared_squared * sin_beta_squared
    sum_48 = (
        8.0 * baseline_squared_squared
        - 14.0 * cos_beta * path * product_6
        - path_squared_squared
        + product_42
        + product_54
        + product_60
        + product_61
    )
    sum_49 = (
        12.0 * baseline_squared * path_squared
        - 15.0 * baseline_squared * path_squared * sin_beta_squared
        - 32.0 * cos_beta * path * product_6
        - path_squared_squared
        + 17.0 * baseline_squared_squared
        + product_54
        + product_61
    )
    sum_50 = (
        10.0 * cos_beta * product_3 * product_6
        - 12.0 * baseline_squared_squared * path_squared
        - 124.0 * product_11 * product_3 * product_6
        - 126.0 * cos_beta * path * product_10
        - 2.0 * path_squared_cubed
        - 54.0 * baseline_squared_cubed * cos_beta_squared
        - 84.0 * baseline_squared_squared * cos_beta_squared_squared * path_squared
        + 102.0 * path * product_10 * product_11
        + 11.0 * baseline_squared_cubed * cos_beta_squared_squared
        + 12.0 * baseline_squared * cos_beta_squared * path_squared_squared
        + 12.0 * baseline * cos_beta * product_12
        + 171.0 * baseline_squared_squared * cos_beta_squared * path_squared
        + 48.0 * baseline_squared_cubed
        + product_20
        + product_21
        + product_22
        + product_23
        + product_24
        + product_25
    )
    sum_51 = (
        10.0 * baseline_squared_cubed * cos_beta_squared_squared
        - 15.0 * baseline_squared_squared * path_squared
        - 33.0 * baseline_squared_cubed * cos_beta_squared
        - 42.0 * baseline_squared_squared * cos_beta_squared_squared * path_squared
        - 44.0 * product_11 * product_3 * product_6
        - 48.0 * cos_beta * path * product_10
        - 9.0 * baseline_squared * cos_beta_squared * path_squared_squared
        - path_squared_cubed
        + 14.0 * cos_beta * product_3 * product_6
        + 24.0 * baseline_squared_cubed
        + 48.0 * path * product_10 * product_11
        + 72.0 * baseline_squared_squared * cos_beta_squared * path_squared
        + product_22
        + product_26
        + product_27
        + product_28
        + product_29
        + product_30
    )
    sum_52 = (
        12.0 * cos_beta * path * product_31 * sin_beta_squared
        - 110.0 * baseline_squared_squared * path_squared_squared * sin_beta_squared
        - 2.0 * sin_beta_squared * term_1
        - 20.0 * cos_beta * product_10 * product_3 * sin_beta_squared_squared
        - 26.0 * baseline_squared * path_squared_cubed * sin_beta_squared
        - 4.0 * baseline_squared_cubed * path_squared * sin_beta_squared_cubed
        - 4.0 * cos_beta * path * product_31 * sin_beta_squared_squared
        - 54.0 * baseline_squared_cubed * path_squared * sin_beta_squared
        - 56.0 * cos_beta * product_10 * product_3
        - 56.0 * cos_beta * product_12 * product_6
        - 8.0 * cos_beta * path * product_31
        + 28.0 * baseline_squared_cubed * path_squared
        + 30.0 * baseline_squared_cubed * path_squared * sin_beta_squared_squared
        + 41.0 * baseline_squared_squared * path_squared_squared * sin_beta_squared_squared
        + 44.0 * cos_beta * product_12 * product_6 * sin_beta_squared
        + 70.0 * baseline_squared_squared * path_squared_squared
        + 72.0 * cos_beta * product_10 * product_3 * sin_beta_squared
        + product_57
        + product_58
        + product_59
        + term_1
        + term_2
    )
    sum_53 = (
        3.0 * baseline_squared * cos_beta * product_3 * sin_beta_squared
        - 11.0 * path_squared * product_6 * sin_beta_squared
        - 13.0 * baseline_squared_squared * cos_beta * path
        - 5.0 * baseline * path_squared_squared
        - baseline_squared_squared * cos_beta * path * sin_beta_squared
        + 4.0 * baseline_squared * cos_beta * product_3
        + 4.0 * baseline * path_squared_squared * sin_beta_squared
        + 5.0 * product_10
        + 8.0 * path_squared * product_6
        + product_10 * sin_beta_squared
        + product_14
    )
    sum_54 = (
        baseline_squared_squared * cos_beta_squared
        - 3.0 * baseline_squared * cos_beta_squared * path_squared
        - 6.0 * baseline_squared_squared
        + path_squared_squared
        + product_19
        + product_41
        + product_60
    )
    sum_55 = (
        128.0 * rho_squared * sigma_beta_squared_squared * sigma_path_squared * sin_beta_squared * sum_45
        - 32.0 * sigma_beta_squared_squared * sum_41 * sum_4_squared * sum_5_squared * sum_6_squared
        - 384.0 * baseline_squared * sigma_path_squared_squared * sin_beta_squared_squared * sum_42
        - 64.0 * product_15 * rho * sigma_path * sin_beta * sum_43 * sum_4_squared * sum_5 * sum_6
        - 768.0 * baseline_squared * product_16 * product_2 * rho * sigma_beta * sum_44
        + 128.0 * rho * sigma_beta * sigma_path * sin_beta * sum_14 * sum_37 * sum_4_squared_squared * sum_5 * sum_6
        + 16.0 * sigma_beta_squared_cubed * sum_30**2 * sum_5_squared * sum_6_squared
        + 16.0 * sigma_beta_squared_squared * sigma_path_squared * sin_beta_squared * sum_46
        + 192.0 * baseline_squared * product_15 * product_16 * product_2 * rho * sum_47
        + 192.0 * baseline_squared * sigma_beta_squared * sigma_path_squared_squared * sin_beta_squared_squared * sum_48
        + 3456.0 * baseline_squared_squared * product_1 * product_53 * rho * sigma_beta * sum_37
        + 384.0 * baseline_squared * rho_squared * sigma_beta_squared * sigma_path_squared_squared * sin_beta_squared_squared * sum_49
        + 576.0 * baseline_squared_squared * sigma_path_squared_cubed * sin_beta_squared_cubed
        + 64.0 * rho_squared * sigma_beta_squared * sigma_path_squared * sum_4_squared * sum_50
        + 64.0 * sigma_beta_squared * sigma_path_squared * sum_4_squared * sum_51
        + 64.0 * sigma_beta_squared * sum_37**2 * sum_4_squared_squared * sum_5_squared * sum_6_squared
        + 64.0 * sigma_path_squared * sin_beta_squared * sum_52
        + 768.0 * baseline_squared * product_15 * product_16 * product_18 * product_2 * sum_53
        + 96.0 * product_43 * rho * sigma_path * sin_beta * sum_30 * sum_5 * sum_54 * sum_6
    )
    result = _empty(arguments, (2, 2))
    result[..., 0, 0] = sum_22 * term_3
    result[..., 0, 1] = sum_40 * term_3
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = sum_55 * term_3
    return result


def posterior_covariance_semidefinite(
    *,
    path: npt.ArrayLike,
    beta: npt.ArrayLike,
    baseline: npt.ArrayLike,
    sigma_path: npt.ArrayLike,
    sigma_beta: npt.ArrayLike,
    rho: npt.ArrayLike,
) -> Floats:
    """Posterior covariance of the position under a flat prior, to fourth order, completed to a sum of squares.

    Name: bistatic.posterior.covariance.semidefinite.
    Definition: e^L(h h') - (e^L h)(e^L h)' to sigma^4 + dg K dg', g = L h.
    Conditioning: measurement-conditioned: the measured symbols stand for the measurement.
    Source: Duan et al. 2004 modified unbiased, doi:10.1109/TAES.2004.1386889.

    Args:
        path: length of the path from transmitter to target to receiver [m], 30000 to 1e+06.
        beta: azimuth at the receiver, counter-clockwise from the x axis, where the transmitter stands [rad], -3.1416 to 3.1416.
        baseline: distance from transmitter to receiver; less than the path [m], 1 to 20000.
        sigma_path: standard deviation of the error of path [m], 0.001 to 1000.
        sigma_beta: standard deviation of the error of beta [rad], 1e-09 to 0.1.
        rho: correlation of the errors of path and beta [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (2, 2), unit m^2.

    Accuracy: at most 13 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
    """
    arguments = _floats(path, beta, baseline, sigma_path, sigma_beta, rho)
    path, beta, baseline, sigma_path, sigma_beta, rho = arguments
    cos_beta = np.cos(beta)
    divisor_1 = 2.0 * path - 2.0 * baseline * cos_beta
    sin_beta = np.sin(beta)
    sin_beta_squared = sin_beta**2
    baseline_squared = baseline**2
    baseline_squared_squared = baseline_squared**2
    sigma_path_squared = sigma_path**2
    product_1 = sigma_path * sigma_path_squared**2
    product_2 = sin_beta * sin_beta_squared
    sum_1 = (
        2.0 * cos_beta * path
        - 2.0 * baseline
        - 3.0 * cos_beta * path * sin_beta_squared
        + 2.0 * baseline * sin_beta_squared
    )
    path_squared = path**2
    product_3 = path * path_squared
    product_4 = -12.0 * baseline * cos_beta * product_3
    path_squared_squared = path_squared**2
    product_5 = -3.0 * path_squared_squared * sin_beta_squared
    sin_beta_squared_squared = sin_beta_squared**2
    product_6 = baseline * baseline_squared
    product_7 = 12.0 * baseline * cos_beta * product_3 * sin_beta_squared
    product_8 = 3.0 * baseline_squared_squared * sin_beta_squared_squared
    rho_squared = rho**2
    sigma_beta_squared = sigma_beta**2
    sigma_path_squared_squared = sigma_path_squared**2
    sum_2 = (
        16.0 * baseline_squared_squared * sin_beta_squared
        - 19.0 * baseline_squared_squared
        - 4.0 * baseline_squared * path_squared
        - 45.0 * baseline_squared * path_squared * sin_beta_squared_squared
        - 60.0 * cos_beta * path * product_6 * sin_beta_squared
        + 3.0 * path_squared_squared
        + 32.0 * cos_beta * path * product_6
        + 45.0 * baseline_squared * path_squared * sin_beta_squared
        + product_4
        + product_5
        + product_7
        + product_8
    )
    product_9 = baseline * baseline_squared**2
    cos_beta_squared = cos_beta**2
    cos_beta_squared_squared = cos_beta_squared**2
    product_10 = cos_beta * cos_beta_squared
    product_11 = path * path_squared**2
    product_12 = cos_beta * cos_beta_squared**2
    product_13 = cos_beta * product_11
    product_14 = sigma_beta * sigma_beta_squared
    product_15 = sigma_path * sigma_path_squared
    sum_3 = (
        24.0 * baseline_squared * product_12 * product_3
        - 10.0 * cos_beta_squared * product_9
        - 10.0 * path_squared * product_6
        - 11.0 * baseline * cos_beta_squared * path_squared_squared
        - 34.0 * baseline_squared_squared * cos_beta * path
        - 51.0 * cos_beta_squared_squared * path_squared * product_6
        - 6.0 * product_10 * product_11
        - 9.0 * baseline_squared_squared * path * product_12
        - 92.0 * baseline_squared * product_10 * product_3
        + 28.0 * baseline_squared * cos_beta * product_3
        + 36.0 * baseline * cos_beta_squared_squared * path_squared_squared
        + 48.0 * baseline_squared_squared * path * product_10
        + 5.0 * cos_beta_squared_squared * product_9
        + 81.0 * cos_beta_squared * path_squared * product_6
        + product_13
    )
    product_16 = baseline * cos_beta
    sum_4 = product_16 - path
    sum_4_squared = sum_4**2
    product_17 = -8.0 * path * product_6
    sum_5 = baseline + path
    sum_6 = baseline - path
    sum_7 = (
        15.0 * baseline_squared * cos_beta * path_squared
        - 11.0 * baseline_squared * path_squared * product_10
        - 2.0 * baseline * product_3
        - 7.0 * baseline * cos_beta_squared * product_3
        - 8.0 * baseline_squared_squared * cos_beta
        - cos_beta_squared_squared * path * product_6
        + 16.0 * cos_beta_squared * path * product_6
        + 3.0 * baseline_squared_squared * product_10
        + 3.0 * cos_beta * path_squared_squared
        + product_17
    )
    sum_8 = (
        4.0 * cos_beta_squared * path * product_6
        - 2.0 * baseline_squared_squared * cos_beta
        - 3.0 * baseline_squared * path_squared * product_10
        - 4.0 * baseline * cos_beta_squared * product_3
        - 4.0 * path * product_6
        + 7.0 * baseline_squared * cos_beta * path_squared
        + baseline_squared_squared * product_10
        + cos_beta * path_squared_squared
    )
    product_18 = rho * rho_squared
    sum_9 = 2.0 * baseline * cos_beta - 3.0 * cos_beta_squared * path + path
    sum_10 = (
        13.0 * baseline_squared * cos_beta_squared * path
        - 12.0 * baseline * path_squared * product_10
        - 4.0 * baseline_squared * path
        - 4.0 * cos_beta * product_6
        - product_3
        + 3.0 * baseline * cos_beta * path_squared
        + 4.0 * cos_beta_squared * product_3
        + product_10 * product_6
    )
    sigma_path_squared_cubed = sigma_path_squared * sigma_path_squared**2
    product_19 = 8.0 * cos_beta * path * product_6
    sum_11 = (
        3.0 * path_squared_squared
        - 18.0 * baseline_squared * path_squared * sin_beta_squared_squared
        - 24.0 * cos_beta * path * product_6 * sin_beta_squared
        - 7.0 * baseline_squared_squared
        + 4.0 * baseline_squared_squared * sin_beta_squared
        + 8.0 * baseline_squared * path_squared
        + 9.0 * baseline_squared * path_squared * sin_beta_squared
        + product_19
        + product_4
        + product_5
        + product_7
        + product_8
    )
    product_20 = -18.0 * baseline * product_10 * product_11
    baseline_squared_cubed = baseline_squared * baseline_squared**2
    product_21 = -6.0 * path * product_12 * product_9
    path_squared_cubed = path_squared * path_squared**2
    product_22 = 14.0 * product_12 * product_3 * product_6
    product_23 = 3.0 * cos_beta_squared * path_squared_cubed
    product_24 = 33.0 * baseline_squared * cos_beta_squared_squared * path_squared_squared
    product_25 = 6.0 * baseline * cos_beta * product_11
    sum_12 = (
        2.0 * baseline_squared * path_squared_squared
        - 22.0 * cos_beta * path * product_9
        - 40.0 * baseline_squared_squared * cos_beta_squared_squared * path_squared
        - 46.0 * product_10 * product_3 * product_6
        - 5.0 * baseline_squared_cubed * cos_beta_squared
        - 5.0 * baseline_squared_squared * path_squared
        - 9.0 * baseline_squared * cos_beta_squared * path_squared_squared
        - path_squared_cubed
        + 3.0 * baseline_squared_cubed * cos_beta_squared_squared
        + 32.0 * path * product_10 * product_9
        + 51.0 * baseline_squared_squared * cos_beta_squared * path_squared
        + 8.0 * cos_beta * product_3 * product_6
        + product_20
        + product_21
        + product_22
        + product_23
        + product_24
        + product_25
    )
    product_26 = -12.0 * baseline * product_10 * product_11
    product_27 = -2.0 * path * product_12 * product_9
    product_28 = -3.0 * baseline_squared_squared * path_squared
    product_29 = 2.0 * baseline_squared_cubed * cos_beta_squared_squared
    product_30 = 2.0 * cos_beta_squared * path_squared_cubed
    product_31 = 20.0 * baseline_squared * cos_beta_squared_squared * path_squared_squared
    product_32 = 6.0 * product_12 * product_3 * product_6
    sum_13 = (
        14.0 * path * product_10 * product_9
        - 10.0 * cos_beta * path * product_9
        - 22.0 * baseline_squared_squared * cos_beta_squared_squared * path_squared
        - 22.0 * product_10 * product_3 * product_6
        - 3.0 * baseline_squared_cubed * cos_beta_squared
        - 7.0 * baseline_squared * cos_beta_squared * path_squared_squared
        - path_squared_cubed
        + 28.0 * baseline_squared_squared * cos_beta_squared * path_squared
        + 4.0 * cos_beta * product_3 * product_6
        + product_25
        + product_26
        + product_27
        + product_28
        + product_29
        + product_30
        + product_31
        + product_32
    )
    product_33 = baseline_squared * cos_beta_squared
    sum_14 = 6.0 * baseline * cos_beta * path - 3.0 * path_squared - 4.0 * baseline_squared + product_33
    sum_4_squared_squared = sum_4_squared**2
    sum_15 = baseline_squared - 2.0 * baseline * cos_beta * path + path_squared
    product_34 = baseline * baseline_squared * baseline_squared**2
    term_1 = (baseline_squared**2)**2
    product_35 = -4.0 * cos_beta_squared_squared * term_1
    product_36 = path * path_squared * path_squared**2
    product_37 = -8.0 * baseline * product_10 * product_36
    cos_beta_squared_cubed = cos_beta_squared * cos_beta_squared**2
    product_38 = 4.0 * cos_beta_squared * term_1
    product_39 = cos_beta_squared_cubed * term_1
    term_2 = (path_squared**2)**2
    product_40 = cos_beta_squared * term_2
    sigma_beta_squared_squared = sigma_beta_squared**2
    sum_16 = (
        10.0 * baseline_squared * cos_beta_squared * path_squared_cubed
        - 105.0 * baseline_squared_squared * cos_beta_squared_squared * path_squared_squared
        - 2.0 * cos_beta * product_11 * product_6
        - 38.0 * path * product_10 * product_34
        - 46.0 * product_12 * product_3 * product_9
        - 66.0 * product_10 * product_11 * product_6
        - 7.0 * baseline_squared_squared * path_squared_squared
        - 74.0 * cos_beta * product_3 * product_9
        - 9.0 * baseline_squared_cubed * cos_beta_squared_cubed * path_squared
        - 93.0 * baseline_squared_cubed * cos_beta_squared * path_squared
        + 10.0 * path * product_12 * product_34
        + 114.0 * baseline_squared_squared * cos_beta_squared * path_squared_squared
        + 12.0 * baseline_squared_squared * cos_beta_squared_cubed * path_squared_squared
        + 128.0 * product_10 * product_3 * product_9
        + 13.0 * baseline_squared * cos_beta_squared_squared * path_squared_cubed
        + 22.0 * baseline_squared_cubed * path_squared
        + 28.0 * cos_beta * path * product_34
        + 36.0 * product_11 * product_12 * product_6
        + 72.0 * baseline_squared_cubed * cos_beta_squared_squared * path_squared
        + baseline_squared * path_squared_cubed
        + product_35
        + product_37
        + product_38
        + product_39
        + product_40
    )
    sum_5_squared = sum_5**2
    sum_6_squared = sum_6**2
    product_41 = 6.0 * baseline_squared * path_squared
    product_42 = baseline_squared_squared * sin_beta_squared_squared
    sigma_beta_squared_cubed = sigma_beta_squared * sigma_beta_squared**2
    sum_17 = (
        10.0 * baseline_squared_squared * sin_beta_squared
        - 18.0 * baseline_squared * path_squared * sin_beta_squared
        - 40.0 * cos_beta * path * product_6
        - 8.0 * cos_beta * path * product_6 * sin_beta_squared
        + 25.0 * baseline_squared_squared
        + 8.0 * baseline * cos_beta * product_3
        + path_squared_squared
        + product_41
        + product_42
    )
    sum_18 = (
        16.0 * cos_beta * product_11 * product_6
        - 120.0 * product_10 * product_11 * product_6
        - 128.0 * cos_beta * product_3 * product_9
        - 18.0 * baseline_squared_cubed * cos_beta_squared_cubed * path_squared
        - 192.0 * baseline_squared_cubed * cos_beta_squared * path_squared
        - 2.0 * baseline_squared * cos_beta_squared * path_squared_cubed
        - 204.0 * baseline_squared_squared * cos_beta_squared_squared * path_squared_squared
        - 28.0 * baseline_squared_squared * path_squared_squared
        - 80.0 * path * product_10 * product_34
        - 88.0 * product_12 * product_3 * product_9
        + 16.0 * path * product_12 * product_34
        + 162.0 * baseline_squared_cubed * cos_beta_squared_squared * path_squared
        + 21.0 * baseline_squared_squared * cos_beta_squared_cubed * path_squared_squared
        + 22.0 * baseline_squared * cos_beta_squared_squared * path_squared_cubed
        + 224.0 * product_10 * product_3 * product_9
        + 225.0 * baseline_squared_squared * cos_beta_squared * path_squared_squared
        + 4.0 * baseline_squared * path_squared_cubed
        + 40.0 * baseline_squared_cubed * path_squared
        + 64.0 * cos_beta * path * product_34
        + 72.0 * product_11 * product_12 * product_6
        + product_35
        + product_37
        + product_38
        + product_39
        + product_40
    )
    sum_19 = (
        10.0 * baseline * path * product_10
        - 12.0 * baseline * cos_beta * path
        - 18.0 * baseline_squared * cos_beta_squared
        - 2.0 * path_squared
        + 16.0 * baseline_squared
        + 3.0 * baseline_squared * cos_beta_squared_squared
        + 3.0 * cos_beta_squared * path_squared
    )
    product_43 = -4.0 * baseline * cos_beta * product_3
    product_44 = -6.0 * baseline_squared * path_squared * sin_beta_squared
    sum_20 = (
        4.0 * cos_beta * path * product_6 * sin_beta_squared
        - 2.0 * baseline_squared_squared * sin_beta_squared
        - 4.0 * cos_beta * path * product_6
        + baseline_squared_squared
        + path_squared_squared
        + product_41
        + product_42
        + product_43
        + product_44
    )
    sum_15_squared = sum_15**2
    sum_21 = 4.0 * baseline * cos_beta * path - 6.0 * baseline_squared + path_squared + product_33
    product_45 = sigma_beta * sigma_beta_squared**2
    term_3 = 1.0 / ((divisor_1**2)**2)**2
    sum_22 = (
        128.0 * baseline_squared * (1.0 + cos_beta) * (cos_beta - 1.0) * cos_beta_squared * sigma_path_squared_squared * sum_14 * sum_4_squared
        - 1152.0 * baseline_squared_squared * product_1 * product_2 * rho * sigma_beta * sum_1
        - 128.0 * baseline_squared * product_14 * product_15 * rho * sin_beta * sum_3
        - 128.0 * baseline_squared * rho_squared * sigma_beta_squared * sigma_path_squared_squared * sin_beta_squared * sum_2
        - 128.0 * path * product_14 * rho * sigma_path * sin_beta * sum_4_squared * sum_5 * sum_6 * sum_7
        - 256.0 * baseline_squared * cos_beta * product_15 * rho * sigma_beta * sin_beta * sum_10 * sum_4_squared
        - 256.0 * baseline_squared * product_14 * product_15 * product_18 * sin_beta * sum_8 * sum_9
        - 576.0 * baseline_squared_squared * sigma_path_squared_cubed * (1.0 + sin_beta) * (sin_beta - 1.0) * sin_beta_squared_squared
        - 64.0 * baseline_squared * sigma_beta_squared * sigma_path_squared_squared * sin_beta_squared * sum_11
        - 64.0 * rho_squared * sigma_beta_squared * sigma_path_squared * sum_12 * sum_4_squared
        - 64.0 * sigma_beta_squared * sigma_path_squared * sum_13 * sum_4_squared
        + 128.0 * cos_beta * path * rho * sigma_beta * sigma_path * sin_beta * sum_15 * sum_4_squared_squared * sum_5 * sum_6
        + 128.0 * rho_squared * sigma_beta_squared_squared * sigma_path_squared * sum_16
        + 16.0 * path_squared * sigma_beta_squared_cubed * sin_beta_squared * sum_17 * sum_5_squared * sum_6_squared
        + 16.0 * sigma_beta_squared_squared * sigma_path_squared * sum_18
        + 32.0 * path_squared * sigma_beta_squared_squared * sum_19 * sum_4_squared * sum_5_squared * sum_6_squared
        + 64.0 * cos_beta_squared * sigma_path_squared * sum_15_squared * sum_4_squared_squared
        + 64.0 * path_squared * sigma_beta_squared * sin_beta_squared * sum_20 * sum_5_squared * sum_6_squared
        + 96.0 * path * product_45 * rho * sigma_path * sin_beta * sum_21 * sum_5 * sum_6 * sum_8
    )
    sum_23 = (
        108.0 * cos_beta * path_squared * product_6 * sin_beta_squared
        - 10.0 * cos_beta * product_9
        - 142.0 * baseline_squared * product_3 * sin_beta_squared
        - 24.0 * cos_beta * path_squared * product_6 * sin_beta_squared_squared
        - 38.0 * baseline * cos_beta * path_squared_squared
        - 74.0 * baseline_squared_squared * path * sin_beta_squared
        - 8.0 * product_11 * sin_beta_squared
        - 88.0 * cos_beta * path_squared * product_6
        + 2.0 * cos_beta * product_9 * sin_beta_squared_squared
        + 27.0 * baseline_squared_squared * path * sin_beta_squared_squared
        + 40.0 * baseline * cos_beta * path_squared_squared * sin_beta_squared
        + 47.0 * baseline_squared_squared * path
        + 56.0 * baseline_squared * product_3 * sin_beta_squared_squared
        + 7.0 * product_11
        + 8.0 * cos_beta * product_9 * sin_beta_squared
        + 82.0 * baseline_squared * product_3
    )
    sum_24 = (
        12.0 * baseline * product_3
        - 12.0 * baseline * product_3 * sin_beta_squared
        - 16.0 * path * product_6 * sin_beta_squared
        - 18.0 * baseline_squared * cos_beta * path_squared
        - 3.0 * baseline_squared_squared * cos_beta
        - 3.0 * cos_beta * path_squared_squared
        + 12.0 * path * product_6
        + 14.0 * baseline_squared * cos_beta * path_squared * sin_beta_squared
        + 2.0 * baseline_squared_squared * cos_beta * sin_beta_squared
        + 4.0 * path * product_6 * sin_beta_squared_squared
        + baseline_squared_squared * cos_beta * sin_beta_squared_squared
    )
    sum_25 = (
        10.0 * baseline_squared * path_squared_squared * product_10
        - 13.0 * baseline_squared_squared * path_squared * product_10
        - 13.0 * cos_beta_squared * product_3 * product_6
        - 4.0 * baseline_squared_cubed * cos_beta
        - 4.0 * path * product_9
        - 6.0 * baseline * cos_beta_squared * product_11
        - cos_beta_squared_squared * path * product_9
        + 10.0 * baseline_squared_squared * cos_beta * path_squared
        + 13.0 * cos_beta_squared * path * product_9
        + 3.0 * baseline_squared * cos_beta * path_squared_squared
        + 3.0 * cos_beta_squared_squared * product_3 * product_6
        + baseline_squared_cubed * product_10
        + cos_beta * path_squared_cubed
    )
    sum_26 = (
        18.0 * baseline_squared * cos_beta * path
        - 10.0 * baseline * cos_beta_squared * path_squared
        - 16.0 * product_6
        - 3.0 * baseline_squared * path * product_10
        - 3.0 * cos_beta * product_3
        + 7.0 * cos_beta_squared * product_6
        + 7.0 * baseline * path_squared
    )
    sum_27 = (
        103.0 * cos_beta * path_squared * product_6
        - 12.0 * cos_beta_squared * product_11
        - 16.0 * cos_beta * product_9
        - 20.0 * baseline_squared_squared * cos_beta_squared_squared * path
        - 3.0 * baseline * cos_beta * path_squared_squared
        - 48.0 * baseline_squared_squared * path
        - 80.0 * baseline_squared * cos_beta_squared * product_3
        - 95.0 * path_squared * product_10 * product_6
        + 11.0 * product_10 * product_9
        + 2.0 * baseline_squared * product_3
        + 28.0 * baseline * path_squared_squared * product_10
        + 4.0 * path_squared * product_12 * product_6
        + 44.0 * baseline_squared * cos_beta_squared_squared * product_3
        + 6.0 * product_11
        + 76.0 * baseline_squared_squared * cos_beta_squared * path
    )
    sum_28 = (
        14.0 * cos_beta_squared_squared * product_3 * product_6
        - 16.0 * baseline_squared_cubed * cos_beta
        - 16.0 * path * product_9
        - 18.0 * baseline * cos_beta_squared * product_11
        - 46.0 * cos_beta_squared * product_3 * product_6
        - 50.0 * baseline_squared_squared * path_squared * product_10
        - 6.0 * cos_beta_squared_squared * path * product_9
        + 3.0 * cos_beta * path_squared_cubed
        + 33.0 * baseline_squared * path_squared_squared * product_10
        + 35.0 * baseline_squared_squared * cos_beta * path_squared
        + 4.0 * product_3 * product_6
        + 5.0 * baseline_squared_cubed * product_10
        + 52.0 * cos_beta_squared * path * product_9
        + 6.0 * baseline_squared * cos_beta * path_squared_squared
    )
    sum_29 = (
        13.0 * cos_beta * product_9
        - 17.0 * baseline_squared * product_3 * sin_beta_squared
        - 18.0 * baseline_squared * product_3 * sin_beta_squared_squared
        - 25.0 * baseline * cos_beta * path_squared_squared
        - 29.0 * baseline_squared_squared * path
        - 51.0 * cos_beta * path_squared * product_6 * sin_beta_squared
        - 6.0 * product_11 * sin_beta_squared
        + 24.0 * baseline * cos_beta * path_squared_squared * sin_beta_squared
        + 32.0 * baseline_squared * product_3
        + 4.0 * cos_beta * path_squared * product_6
        + 41.0 * baseline_squared_squared * path * sin_beta_squared
        + 5.0 * cos_beta * product_9 * sin_beta_squared
        + 5.0 * product_11
        + 6.0 * baseline_squared_squared * path * sin_beta_squared_squared
    )
    sum_30 = (
        4.0 * baseline_squared * cos_beta * path
        - 4.0 * baseline * cos_beta_squared * path_squared
        - 6.0 * product_6
        - baseline_squared * path * product_10
        - cos_beta * product_3
        + 4.0 * cos_beta_squared * product_6
        + 4.0 * baseline * path_squared
    )
    product_46 = -18.0 * baseline_squared_cubed * path_squared * product_12
    product_47 = -24.0 * product_10 * term_1
    product_48 = 36.0 * cos_beta * term_1
    product_49 = 72.0 * cos_beta_squared_squared * product_11 * product_6
    product_50 = 72.0 * path * product_34
    sum_31 = (
        10.0 * product_11 * product_6
        - 126.0 * cos_beta_squared_squared * product_3 * product_9
        - 146.0 * cos_beta_squared * path * product_34
        - 188.0 * baseline_squared_cubed * cos_beta * path_squared
        - 196.0 * baseline_squared_squared * path_squared_squared * product_10
        - 74.0 * product_3 * product_9
        - 8.0 * baseline * cos_beta_squared * product_36
        - 94.0 * cos_beta_squared * product_11 * product_6
        + 121.0 * baseline_squared_squared * cos_beta * path_squared_squared
        + 190.0 * baseline_squared_cubed * path_squared * product_10
        + 2.0 * baseline_squared * cos_beta * path_squared_cubed
        + 21.0 * baseline_squared_squared * path_squared_squared * product_12
        + 22.0 * baseline_squared * path_squared_cubed * product_10
        + 280.0 * cos_beta_squared * product_3 * product_9
        + 46.0 * cos_beta_squared_squared * path * product_34
        + cos_beta * term_2
        + product_12 * term_1
        + product_46
        + product_47
        + product_48
        + product_49
        + product_50
    )
    product_51 = -4.0 * baseline * product_3 * sin_beta_squared
    product_52 = -cos_beta * path_squared_squared
    product_53 = 4.0 * baseline * product_3
    product_54 = baseline_squared_squared * cos_beta * sin_beta_squared
    sum_32 = (
        11.0 * path * product_6 * sin_beta_squared
        - 6.0 * baseline_squared * cos_beta * path_squared * sin_beta_squared
        + 5.0 * baseline_squared_squared * cos_beta
        + product_17
        + product_51
        + product_52
        + product_53
        + product_54
    )
    sum_33 = (
        14.0 * cos_beta * path_squared * product_6
        - 112.0 * baseline_squared * product_3 * sin_beta_squared
        - 125.0 * baseline * cos_beta * path_squared_squared
        - 154.0 * baseline_squared_squared * path
        - 24.0 * product_11 * sin_beta_squared
        - 291.0 * cos_beta * path_squared * product_6 * sin_beta_squared
        - 96.0 * baseline_squared * product_3 * sin_beta_squared_squared
        + 144.0 * baseline * cos_beta * path_squared_squared * sin_beta_squared
        + 172.0 * baseline_squared * product_3
        + 22.0 * product_11
        + 226.0 * baseline_squared_squared * path * sin_beta_squared
        + 36.0 * baseline_squared_squared * path * sin_beta_squared_squared
        + 37.0 * cos_beta * product_9 * sin_beta_squared
        + 71.0 * cos_beta * product_9
    )
    sum_34 = (
        11.0 * baseline_squared_squared * cos_beta
        - 15.0 * baseline_squared * cos_beta * path_squared * sin_beta_squared
        - 20.0 * path * product_6
        + 26.0 * path * product_6 * sin_beta_squared
        + 6.0 * baseline_squared * cos_beta * path_squared
        + product_51
        + product_52
        + product_53
        + product_54
    )
    sin_beta_squared_cubed = sin_beta_squared * sin_beta_squared**2
    sum_35 = (
        2.0 * baseline_squared_cubed * path * sin_beta_squared_cubed
        - 14.0 * cos_beta * path_squared_squared * product_6
        - 3.0 * baseline_squared_cubed * path
        - 32.0 * cos_beta * path_squared * product_9 * sin_beta_squared_squared
        - 38.0 * baseline_squared * product_11 * sin_beta_squared
        - 6.0 * baseline_squared_squared * product_3 * sin_beta_squared_cubed
        - 8.0 * cos_beta * path_squared * product_9
        - 91.0 * baseline_squared_squared * product_3 * sin_beta_squared_squared
        - 98.0 * cos_beta * path_squared * product_9 * sin_beta_squared
        - baseline_squared * product_11
        - product_36
        + 2.0 * cos_beta * product_34
        + 2.0 * product_36 * sin_beta_squared
        + 21.0 * baseline_squared_squared * product_3
        + 29.0 * baseline_squared_cubed * path * sin_beta_squared_squared
        + 32.0 * baseline_squared_cubed * path * sin_beta_squared
        + 32.0 * cos_beta * path_squared_squared * product_6 * sin_beta_squared_squared
        + 36.0 * baseline_squared * product_11 * sin_beta_squared_squared
        + 36.0 * baseline_squared_squared * product_3 * sin_beta_squared
        + 4.0 * baseline * cos_beta * path_squared_cubed
        + 4.0 * cos_beta * product_34 * sin_beta_squared_squared
        + 52.0 * cos_beta * path_squared_squared * product_6 * sin_beta_squared
        + 6.0 * cos_beta * product_34 * sin_beta_squared
    )
    sum_36 = 5.0 * baseline * cos_beta - 5.0 * path + 6.0 * path * sin_beta_squared
    product_55 = sin_beta * sin_beta_squared**2
    sum_37 = baseline - cos_beta * path
    sum_38 = (
        104.0 * baseline_squared_squared * cos_beta * path_squared_squared
        - 129.0 * cos_beta_squared_squared * product_3 * product_9
        - 139.0 * cos_beta_squared * path * product_34
        - 16.0 * baseline * cos_beta_squared * product_36
        - 212.0 * baseline_squared_squared * path_squared_squared * product_10
        - 214.0 * baseline_squared_cubed * cos_beta * path_squared
        - 55.0 * product_3 * product_9
        - 89.0 * cos_beta_squared * product_11 * product_6
        - product_11 * product_6
        + 16.0 * baseline_squared * cos_beta * path_squared_cubed
        + 194.0 * baseline_squared_cubed * path_squared * product_10
        + 2.0 * cos_beta * term_2
        + 2.0 * product_12 * term_1
        + 24.0 * baseline_squared_squared * path_squared_squared * product_12
        + 26.0 * baseline_squared * path_squared_cubed * product_10
        + 308.0 * cos_beta_squared * product_3 * product_9
        + 41.0 * cos_beta_squared_squared * path * product_34
        + product_46
        + product_47
        + product_48
        + product_49
        + product_50
    )
    sum_39 = path - 2.0 * cos_beta_squared * path + product_16
    sum_40 = (
        128.0 * baseline_squared * product_14 * product_15 * product_18 * sin_beta_squared * sum_29
        - 128.0 * baseline_squared * product_15 * rho * sigma_beta * sin_beta_squared * sum_23
        - 128.0 * baseline_squared * product_2 * sigma_path_squared_squared * sum_24
        - 128.0 * sigma_beta_squared * sigma_path_squared * sin_beta * sum_25 * sum_4_squared
        - 32.0 * product_14 * rho * sigma_path * sum_27 * sum_4_squared * sum_5 * sum_6
        - 32.0 * path * sigma_beta_squared_squared * sin_beta * sum_26 * sum_4_squared * sum_5_squared * sum_6_squared
        - 64.0 * rho_squared * sigma_beta_squared * sigma_path_squared * sin_beta * sum_28 * sum_4_squared
        + 16.0 * path * sigma_beta_squared_cubed * sin_beta * sum_21 * sum_30 * sum_5_squared * sum_6_squared
        + 16.0 * sigma_beta_squared_squared * sigma_path_squared * sin_beta * sum_31
        + 192.0 * baseline_squared * product_2 * sigma_beta_squared * sigma_path_squared_squared * sum_32
        + 32.0 * baseline_squared * product_14 * product_15 * rho * sin_beta_squared * sum_33
        + 384.0 * baseline_squared * product_2 * rho_squared * sigma_beta_squared * sigma_path_squared_squared * sum_34
        + 48.0 * product_45 * rho * sigma_path * sum_35 * sum_5 * sum_6
        + 576.0 * baseline_squared_squared * cos_beta * product_55 * sigma_path_squared_cubed
        + 576.0 * baseline_squared_squared * product_1 * rho * sigma_beta * sin_beta_squared_squared * sum_36
        + 64.0 * cos_beta * sigma_path_squared * sin_beta * sum_15_squared * sum_4_squared_squared
        + 64.0 * rho_squared * sigma_beta_squared_squared * sigma_path_squared * sin_beta * sum_38
        + 64.0 * path * sigma_beta_squared * sin_beta * sum_37 * sum_4_squared_squared * sum_5_squared * sum_6_squared
        + 64.0 * rho * sigma_beta * sigma_path * sum_15 * sum_39 * sum_4_squared_squared * sum_5 * sum_6
    )
    sum_41 = (
        12.0 * baseline * cos_beta * product_3
        - 18.0 * baseline_squared * path_squared
        - 3.0 * baseline_squared_squared
        - 3.0 * path_squared_squared
        - 4.0 * cos_beta * path * product_6 * sin_beta_squared
        + 12.0 * cos_beta * path * product_6
        + 14.0 * baseline_squared * path_squared * sin_beta_squared
        + 2.0 * baseline_squared_squared * sin_beta_squared
        + product_42
    )
    product_56 = 4.0 * cos_beta * product_11
    sum_42 = (
        20.0 * baseline * path_squared_squared * sin_beta_squared
        - 12.0 * path_squared * product_6 * sin_beta_squared_squared
        - 16.0 * baseline_squared_squared * cos_beta * path * sin_beta_squared
        - 23.0 * baseline * path_squared_squared
        - 28.0 * baseline_squared * cos_beta * product_3 * sin_beta_squared
        - 58.0 * path_squared * product_6
        - 7.0 * product_9
        + 32.0 * baseline_squared_squared * cos_beta * path
        + 52.0 * baseline_squared * cos_beta * product_3
        + 6.0 * product_9 * sin_beta_squared
        + 62.0 * path_squared * product_6 * sin_beta_squared
        + product_56
        + product_9 * sin_beta_squared_squared
    )
    product_57 = 12.0 * baseline_squared * path_squared
    sum_43 = (
        10.0 * baseline * product_10 * product_3
        - 14.0 * path * product_10 * product_6
        - 16.0 * baseline_squared_squared
        - 21.0 * baseline_squared * cos_beta_squared * path_squared
        - path_squared_squared
        + 12.0 * baseline_squared_squared * cos_beta_squared
        + 24.0 * cos_beta * path * product_6
        + 3.0 * baseline_squared * cos_beta_squared_squared * path_squared
        + 3.0 * cos_beta_squared * path_squared_squared
        + product_4
        + product_57
    )
    sum_44 = (
        11.0 * cos_beta_squared * product_9
        - 14.0 * baseline_squared_squared * path * product_10
        - 28.0 * baseline_squared * cos_beta * product_3
        - 32.0 * product_9
        - 6.0 * cos_beta * product_11
        - 61.0 * cos_beta_squared * path_squared * product_6
        + 11.0 * path_squared * product_6
        + 14.0 * baseline * cos_beta_squared * path_squared_squared
        + 2.0 * cos_beta_squared_squared * path_squared * product_6
        + 22.0 * baseline_squared * product_10 * product_3
        + 7.0 * baseline * path_squared_squared
        + 74.0 * baseline_squared_squared * cos_beta * path
    )
    product_58 = -8.0 * baseline * cos_beta * product_36
    product_59 = sin_beta_squared_squared * term_1
    sum_45 = (
        12.0 * baseline_squared_squared * path_squared_squared * sin_beta_squared_squared
        - 124.0 * baseline_squared_cubed * path_squared * sin_beta_squared
        - 13.0 * baseline_squared * path_squared_cubed * sin_beta_squared
        - 31.0 * cos_beta * path * product_34 * sin_beta_squared
        - 36.0 * cos_beta * product_11 * product_6 * sin_beta_squared
        - 86.0 * baseline_squared_squared * path_squared_squared
        - 9.0 * baseline_squared_cubed * path_squared * sin_beta_squared_squared
        - 95.0 * cos_beta * path * product_34
        + 13.0 * cos_beta * product_11 * product_6
        + 19.0 * baseline_squared * path_squared_cubed
        + 22.0 * sin_beta_squared * term_1
        + 31.0 * term_1
        + 58.0 * cos_beta * product_3 * product_9
        + 67.0 * baseline_squared_cubed * path_squared
        + 83.0 * baseline_squared_squared * path_squared_squared * sin_beta_squared
        + 83.0 * cos_beta * product_3 * product_9 * sin_beta_squared
        + product_58
        + product_59
        + term_2
    )
    product_60 = 28.0 * baseline_squared * path_squared_cubed
    sum_46 = (
        112.0 * cos_beta * product_3 * product_9
        - 122.0 * baseline_squared_squared * path_squared_squared
        - 140.0 * cos_beta * path * product_34
        - 18.0 * baseline_squared_cubed * path_squared * sin_beta_squared_squared
        - 214.0 * baseline_squared_cubed * path_squared * sin_beta_squared
        - 22.0 * baseline_squared * path_squared_cubed * sin_beta_squared
        - 72.0 * cos_beta * product_11 * product_6 * sin_beta_squared
        - 76.0 * cos_beta * path * product_34 * sin_beta_squared
        + 146.0 * baseline_squared_squared * path_squared_squared * sin_beta_squared
        + 164.0 * cos_beta * product_3 * product_9 * sin_beta_squared
        + 21.0 * baseline_squared_squared * path_squared_squared * sin_beta_squared_squared
        + 4.0 * cos_beta * product_11 * product_6
        + 49.0 * term_1
        + 58.0 * sin_beta_squared * term_1
        + 76.0 * baseline_squared_cubed * path_squared
        + product_58
        + product_59
        + product_60
        + term_2
    )
    sum_47 = (
        16.0 * baseline_squared * cos_beta * product_3 * sin_beta_squared
        - 25.0 * baseline * path_squared_squared
        - 6.0 * baseline_squared_squared * cos_beta * path * sin_beta_squared
        - 63.0 * path_squared * product_6 * sin_beta_squared
        - 68.0 * baseline_squared_squared * cos_beta * path
        + 24.0 * baseline_squared * cos_beta * product_3
        + 24.0 * baseline * path_squared_squared * sin_beta_squared
        + 27.0 * product_9
        + 38.0 * path_squared * product_6
        + 9.0 * product_9 * sin_beta_squared
        + product_56
    )
    product_61 = 3.0 * baseline_squared * path_squared
    product_62 = 4.0 * baseline * cos_beta * product_3
    product_63 = baseline_squared_squared * sin_beta_squared
    sum_48 = (
        8.0 * baseline_squared_squared
        - 14.0 * cos_beta * path * product_6
        - path_squared_squared
        + product_44
        + product_61
        + product_62
        + product_63
    )
    sum_49 = (
        17.0 * baseline_squared_squared
        - 15.0 * baseline_squared * path_squared * sin_beta_squared
        - 32.0 * cos_beta * path * product_6
        - path_squared_squared
        + product_57
        + product_62
        + product_63
    )
    sum_50 = (
        12.0 * baseline * cos_beta * product_11
        - 12.0 * baseline_squared * cos_beta_squared * path_squared_squared
        - 12.0 * baseline_squared_squared * path_squared
        - 2.0 * path_squared_cubed
        - 38.0 * baseline_squared_cubed * cos_beta_squared
        - 6.0 * baseline_squared * path_squared_squared
        - 60.0 * baseline_squared_squared * cos_beta_squared_squared * path_squared
        - 60.0 * product_10 * product_3 * product_6
        - 78.0 * cos_beta * path * product_9
        + 26.0 * cos_beta * product_3 * product_6
        + 32.0 * baseline_squared_cubed
        + 7.0 * baseline_squared_cubed * cos_beta_squared_squared
        + 78.0 * path * product_10 * product_9
        + 87.0 * baseline_squared_squared * cos_beta_squared * path_squared
        + product_20
        + product_21
        + product_22
        + product_23
        + product_24
    )
    sum_51 = (
        10.0 * cos_beta * product_3 * product_6
        - 17.0 * baseline_squared_cubed * cos_beta_squared
        - 30.0 * baseline_squared_squared * cos_beta_squared_squared * path_squared
        - 36.0 * product_10 * product_3 * product_6
        - 4.0 * baseline_squared * path_squared_squared
        - 44.0 * cos_beta * path * product_9
        - baseline_squared * cos_beta_squared * path_squared_squared
        - path_squared_cubed
        + 16.0 * baseline_squared_cubed
        + 40.0 * path * product_10 * product_9
        + 48.0 * baseline_squared_squared * cos_beta_squared * path_squared
        + product_25
        + product_26
        + product_27
        + product_28
        + product_29
        + product_30
        + product_31
        + product_32
    )
    sum_52 = (
        12.0 * cos_beta * path * product_34 * sin_beta_squared
        - 110.0 * baseline_squared_squared * path_squared_squared * sin_beta_squared
        - 2.0 * sin_beta_squared * term_1
        - 20.0 * cos_beta * product_3 * product_9 * sin_beta_squared_squared
        - 26.0 * baseline_squared * path_squared_cubed * sin_beta_squared
        - 4.0 * baseline_squared_cubed * path_squared * sin_beta_squared_cubed
        - 4.0 * cos_beta * path * product_34 * sin_beta_squared_squared
        - 54.0 * baseline_squared_cubed * path_squared * sin_beta_squared
        - 56.0 * cos_beta * product_11 * product_6
        - 56.0 * cos_beta * product_3 * product_9
        - 8.0 * cos_beta * path * product_34
        + 28.0 * baseline_squared_cubed * path_squared
        + 30.0 * baseline_squared_cubed * path_squared * sin_beta_squared_squared
        + 41.0 * baseline_squared_squared * path_squared_squared * sin_beta_squared_squared
        + 44.0 * cos_beta * product_11 * product_6 * sin_beta_squared
        + 70.0 * baseline_squared_squared * path_squared_squared
        + 72.0 * cos_beta * product_3 * product_9 * sin_beta_squared
        + product_58
        + product_59
        + product_60
        + term_1
        + term_2
    )
    sum_53 = (
        3.0 * baseline_squared * cos_beta * product_3 * sin_beta_squared
        - 11.0 * path_squared * product_6 * sin_beta_squared
        - 13.0 * baseline_squared_squared * cos_beta * path
        - 5.0 * baseline * path_squared_squared
        - baseline_squared_squared * cos_beta * path * sin_beta_squared
        + 4.0 * baseline_squared * cos_beta * product_3
        + 4.0 * baseline * path_squared_squared * sin_beta_squared
        + 5.0 * product_9
        + 8.0 * path_squared * product_6
        + product_13
        + product_9 * sin_beta_squared
    )
    sum_54 = (
        baseline_squared_squared * cos_beta_squared
        - 3.0 * baseline_squared * cos_beta_squared * path_squared
        - 6.0 * baseline_squared_squared
        + path_squared_squared
        + product_19
        + product_43
        + product_61
    )
    sum_55 = (
        128.0 * rho_squared * sigma_beta_squared_squared * sigma_path_squared * sin_beta_squared * sum_45
        - 128.0 * baseline_squared * sigma_path_squared_squared * sin_beta_squared_squared * sum_41
        - 256.0 * baseline_squared * product_15 * product_2 * rho * sigma_beta * sum_42
        - 32.0 * sigma_beta_squared_squared * sum_43 * sum_4_squared * sum_5_squared * sum_6_squared
        - 64.0 * product_14 * rho * sigma_path * sin_beta * sum_44 * sum_4_squared * sum_5 * sum_6
        + 128.0 * rho * sigma_beta * sigma_path * sin_beta * sum_15 * sum_37 * sum_4_squared_squared * sum_5 * sum_6
        + 16.0 * sigma_beta_squared_cubed * sum_30**2 * sum_5_squared * sum_6_squared
        + 16.0 * sigma_beta_squared_squared * sigma_path_squared * sin_beta_squared * sum_46
        + 192.0 * baseline_squared * product_14 * product_15 * product_2 * rho * sum_47
        + 192.0 * baseline_squared * sigma_beta_squared * sigma_path_squared_squared * sin_beta_squared_squared * sum_48
        + 3456.0 * baseline_squared_squared * product_1 * product_55 * rho * sigma_beta * sum_37
        + 384.0 * baseline_squared * rho_squared * sigma_beta_squared * sigma_path_squared_squared * sin_beta_squared_squared * sum_49
        + 576.0 * baseline_squared_squared * sigma_path_squared_cubed * sin_beta_squared_cubed
        + 64.0 * rho_squared * sigma_beta_squared * sigma_path_squared * sum_4_squared * sum_50
        + 64.0 * sigma_beta_squared * sigma_path_squared * sum_4_squared * sum_51
        + 64.0 * sigma_beta_squared * sum_37**2 * sum_4_squared_squared * sum_5_squared * sum_6_squared
        + 64.0 * sigma_path_squared * sin_beta_squared * sum_52
        + 768.0 * baseline_squared * product_14 * product_15 * product_18 * product_2 * sum_53
        + 96.0 * product_45 * rho * sigma_path * sin_beta * sum_30 * sum_5 * sum_54 * sum_6
    )
    result = _empty(arguments, (2, 2))
    result[..., 0, 0] = sum_22 * term_3
    result[..., 0, 1] = sum_40 * term_3
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = sum_55 * term_3
    return result


def decorrelated_covariance_semidefinite(
    *,
    path: npt.ArrayLike,
    beta: npt.ArrayLike,
    baseline: npt.ArrayLike,
    sigma_path: npt.ArrayLike,
    sigma_beta: npt.ArrayLike,
    rho: npt.ArrayLike,
    predicted_sigma_path: npt.ArrayLike,
    predicted_sigma_beta: npt.ArrayLike,
    predicted_rho: npt.ArrayLike,
) -> Floats:
    """Covariance of the unbiased estimate u, averaged over a prediction, to fourth order, completed to a sum of squares.

    Name: bistatic.decorrelated.covariance.semidefinite.
    Definition: e^Lp [e^L(u u') - h h'] to sigma^4 + dg K dg', g = Lp h.
    Conditioning: averaged over a prediction: the measured symbols stand for the predicted mean.
    Source: Bordonaro et al. 2014 decorrelated; Mo et al. 1998 R_m where Kp = K, R_t where Kp = 0,
    doi:10.1109/TAES.2014.120563, doi:10.1109/7.705921.

    Args:
        path: length of the path from transmitter to target to receiver [m], 30000 to 1e+06.
        beta: azimuth at the receiver, counter-clockwise from the x axis, where the transmitter stands [rad], -3.1416 to 3.1416.
        baseline: distance from transmitter to receiver; less than the path [m], 1 to 20000.
        sigma_path: standard deviation of the error of path [m], 0.001 to 1000.
        sigma_beta: standard deviation of the error of beta [rad], 1e-09 to 0.1.
        rho: correlation of the errors of path and beta [1], -1 to 1.
        predicted_sigma_path: standard deviation of the prediction of path [m], 0.001 to 1000.
        predicted_sigma_beta: standard deviation of the prediction of beta [rad], 1e-09 to 0.1.
        predicted_rho: correlation of the predictions of path and beta [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (2, 2), unit m^2.

    Accuracy: at most 13 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
    """
    arguments = _floats(path, beta, baseline, sigma_path, sigma_beta, rho, predicted_sigma_path, predicted_sigma_beta, predicted_rho)
    path, beta, baseline, sigma_path, sigma_beta, rho, predicted_sigma_path, predicted_sigma_beta, predicted_rho = arguments
    cos_beta = np.cos(beta)
    divisor_1 = 2.0 * path - 2.0 * baseline * cos_beta
    cos_beta_squared = cos_beta**2
    sum_1 = 2.0 * baseline * cos_beta - 3.0 * cos_beta_squared * path + path
    baseline_squared = baseline**2
    baseline_squared_squared = baseline_squared**2
    product_1 = -2.0 * baseline_squared_squared * cos_beta
    product_2 = cos_beta * cos_beta_squared
    path_squared = path**2
    product_3 = -3.0 * baseline_squared * path_squared * product_2
    product_4 = baseline * baseline_squared
    product_5 = -4.0 * path * product_4
    product_6 = path * path_squared
    product_7 = 7.0 * baseline_squared * cos_beta * path_squared
    product_8 = baseline_squared_squared * product_2
    path_squared_squared = path_squared**2
    product_9 = cos_beta * path_squared_squared
    sum_2 = (
        4.0 * cos_beta_squared * path * product_4
        - 4.0 * baseline * cos_beta_squared * product_6
        + product_1
        + product_3
        + product_5
        + product_7
        + product_8
        + product_9
    )
    predicted_sigma_beta_squared = predicted_sigma_beta**2
    product_10 = predicted_sigma_beta * predicted_sigma_beta_squared
    sigma_path_squared = sigma_path**2
    sin_beta = np.sin(beta)
    sin_beta_squared = sin_beta**2
    sin_beta_squared_squared = sin_beta_squared**2
    product_11 = 4.0 * baseline_squared * path_squared
    predicted_sigma_path_squared = predicted_sigma_path**2
    product_12 = predicted_sigma_path * predicted_sigma_path_squared
    sum_3 = (
        12.0 * baseline * cos_beta * product_6 * sin_beta_squared
        - 11.0 * baseline_squared_squared
        - 12.0 * baseline * cos_beta * product_6
        - 27.0 * baseline_squared * path_squared * sin_beta_squared_squared
        - 3.0 * path_squared_squared * sin_beta_squared
        - 36.0 * cos_beta * path * product_4 * sin_beta_squared
        + 16.0 * cos_beta * path * product_4
        + 21.0 * baseline_squared * path_squared * sin_beta_squared
        + 3.0 * baseline_squared_squared * sin_beta_squared_squared
        + 3.0 * path_squared_squared
        + 8.0 * baseline_squared_squared * sin_beta_squared
        + product_11
    )
    sigma_beta_squared = sigma_beta**2
    cos_beta_squared_squared = cos_beta_squared**2
    product_13 = baseline * baseline_squared**2
    product_14 = cos_beta * cos_beta_squared**2
    product_15 = path * path_squared**2
    sum_4 = (
        12.0 * baseline * cos_beta_squared_squared * path_squared_squared
        - 14.0 * baseline_squared_squared * cos_beta * path
        - 15.0 * cos_beta_squared_squared * path_squared * product_4
        - 2.0 * cos_beta_squared * product_13
        - 2.0 * path_squared * product_4
        - 28.0 * baseline_squared * product_2 * product_6
        - 3.0 * baseline_squared_squared * path * product_14
        - 7.0 * baseline * cos_beta_squared * path_squared_squared
        - cos_beta * product_15
        + 14.0 * baseline_squared * cos_beta * product_6
        + 18.0 * baseline_squared_squared * path * product_2
        + 21.0 * cos_beta_squared * path_squared * product_4
        + 6.0 * baseline_squared * product_14 * product_6
        + cos_beta_squared_squared * product_13
    )
    product_16 = baseline * cos_beta
    sum_5 = product_16 - path
    sum_5_squared = sum_5**2
    product_17 = -3.0 * baseline * cos_beta_squared * product_6
    sum_6 = baseline + path
    sum_7 = baseline - path
    sum_8 = (
        12.0 * cos_beta_squared * path * product_4
        - 2.0 * baseline * product_6
        - 6.0 * baseline_squared_squared * cos_beta
        - 8.0 * baseline_squared * path_squared * product_2
        - cos_beta_squared_squared * path * product_4
        + 2.0 * baseline_squared_squared * product_2
        + 2.0 * cos_beta * path_squared_squared
        + 8.0 * baseline_squared * cos_beta * path_squared
        + product_17
        + product_5
    )
    sum_9 = (
        baseline_squared * path
        - 3.0 * baseline * cos_beta * path_squared
        + cos_beta * product_4
        + product_6
    )
    sum_10 = cos_beta * path - 2.0 * baseline + baseline * cos_beta_squared
    product_18 = sigma_beta * sigma_beta_squared
    product_19 = -12.0 * baseline * product_15 * product_2
    product_20 = -14.0 * cos_beta * path * product_13
    product_21 = -24.0 * baseline_squared_squared * cos_beta_squared_squared * path_squared
    product_22 = -28.0 * product_2 * product_4 * product_6
    baseline_squared_cubed = baseline_squared * baseline_squared**2
    product_23 = -3.0 * baseline_squared_cubed * cos_beta_squared
    product_24 = -4.0 * path * product_13 * product_14
    path_squared_cubed = path_squared * path_squared**2
    product_25 = 2.0 * baseline_squared_cubed * cos_beta_squared_squared
    product_26 = 2.0 * cos_beta_squared * path_squared_cubed
    product_27 = 22.0 * baseline_squared * cos_beta_squared_squared * path_squared_squared
    product_28 = 6.0 * baseline * cos_beta * product_15
    product_29 = 8.0 * cos_beta * product_4 * product_6
    product_30 = 8.0 * product_14 * product_4 * product_6
    sum_11 = (
        20.0 * path * product_13 * product_2
        - 3.0 * baseline_squared_squared * path_squared
        - 9.0 * baseline_squared * cos_beta_squared * path_squared_squared
        - path_squared_cubed
        + 30.0 * baseline_squared_squared * cos_beta_squared * path_squared
        + product_19
        + product_20
        + product_21
        + product_22
        + product_23
        + product_24
        + product_25
        + product_26
        + product_27
        + product_28
        + product_29
        + product_30
    )
    product_31 = -4.0 * baseline * cos_beta * product_6
    product_32 = 4.0 * baseline * cos_beta * product_6 * sin_beta_squared
    product_33 = baseline_squared_squared * sin_beta_squared_squared
    sum_12 = (
        path_squared_squared
        - 3.0 * baseline_squared * path_squared * sin_beta_squared_squared
        - 4.0 * cos_beta * path * product_4 * sin_beta_squared
        - baseline_squared * path_squared * sin_beta_squared
        - baseline_squared_squared
        - path_squared_squared * sin_beta_squared
        + product_11
        + product_31
        + product_32
        + product_33
    )
    predicted_rho_squared = predicted_rho**2
    product_34 = 3.0 * baseline * cos_beta * path_squared
    product_35 = product_2 * product_4
    sum_13 = (
        4.0 * cos_beta_squared * product_6
        - 2.0 * baseline_squared * path
        - 2.0 * product_6
        - 3.0 * cos_beta * product_4
        - 9.0 * baseline * path_squared * product_2
        + 8.0 * baseline_squared * cos_beta_squared * path
        + product_34
        + product_35
    )
    sum_14 = (
        6.0 * baseline_squared * cos_beta_squared * path
        - 2.0 * cos_beta * product_4
        - 3.0 * baseline_squared * path
        - 6.0 * baseline * path_squared * product_2
        + cos_beta_squared * product_6
        + product_34
        + product_35
    )
    sum_15 = (
        12.0 * path_squared * sin_beta_squared
        - 12.0 * baseline * cos_beta * path * sin_beta_squared
        - 4.0 * baseline_squared
        - 4.0 * path_squared
        - 9.0 * path_squared * sin_beta_squared_squared
        + 4.0 * baseline_squared * sin_beta_squared
        + 8.0 * baseline * cos_beta * path
    )
    sum_16 = (
        3.0 * cos_beta_squared * path * product_4
        - 3.0 * path * product_4
        - baseline * product_6
        + product_1
        + product_17
        + product_3
        + product_7
        + product_8
        + product_9
    )
    sum_17 = (
        2.0 * cos_beta * path
        - 2.0 * baseline
        - 3.0 * cos_beta * path * sin_beta_squared
        + 2.0 * baseline * sin_beta_squared
    )
    predicted_sigma_path_squared_squared = predicted_sigma_path_squared**2
    product_36 = sin_beta * sin_beta_squared
    sum_18 = 1.0 + sin_beta
    sum_19 = sin_beta - 1.0
    product_37 = -2.0 * baseline_squared * path_squared_squared
    product_38 = -2.0 * path * product_13 * product_14
    product_39 = 10.0 * path * product_13 * product_2
    product_40 = 14.0 * baseline_squared * cos_beta_squared_squared * path_squared_squared
    product_41 = 6.0 * product_14 * product_4 * product_6
    sum_20 = (
        20.0 * baseline_squared_squared * cos_beta_squared * path_squared
        - 16.0 * baseline_squared_squared * cos_beta_squared_squared * path_squared
        - 18.0 * product_2 * product_4 * product_6
        - 6.0 * cos_beta * path * product_13
        - baseline_squared_squared * path_squared
        - path_squared_cubed
        + baseline_squared * cos_beta_squared * path_squared_squared
        + product_19
        + product_23
        + product_25
        + product_26
        + product_28
        + product_37
        + product_38
        + product_39
        + product_40
        + product_41
    )
    sum_21 = (
        2.0 * baseline_squared * cos_beta_squared
        - 3.0 * path_squared
        - 5.0 * baseline_squared
        + 6.0 * baseline * cos_beta * path
    )
    sum_22 = (
        2.0 * baseline * cos_beta * path
        - baseline_squared
        - path_squared
        + baseline_squared * sin_beta_squared
    )
    sigma_path_squared_squared = sigma_path_squared**2
    sum_5_squared_squared = sum_5_squared**2
    product_42 = -2.0 * baseline * cos_beta * path
    sum_23 = baseline_squared + path_squared + product_42
    sum_6_squared = sum_6**2
    sum_7_squared = sum_7**2
    product_43 = 6.0 * baseline_squared * path_squared
    product_44 = 8.0 * baseline * cos_beta * product_6
    predicted_sigma_beta_squared_squared = predicted_sigma_beta_squared**2
    sum_24 = (
        10.0 * baseline_squared_squared * sin_beta_squared
        - 18.0 * baseline_squared * path_squared * sin_beta_squared
        - 40.0 * cos_beta * path * product_4
        - 8.0 * cos_beta * path * product_4 * sin_beta_squared
        + 25.0 * baseline_squared_squared
        + path_squared_squared
        + product_33
        + product_43
        + product_44
    )
    sum_2_squared = sum_2**2
    product_45 = -3.0 * path_squared * product_4 * sin_beta_squared_squared
    product_46 = -5.0 * baseline * path_squared_squared
    product_47 = -7.0 * baseline_squared * cos_beta * product_6 * sin_beta_squared
    product_48 = 5.0 * baseline * path_squared_squared * sin_beta_squared
    product_49 = product_13 * sin_beta_squared_squared
    product_50 = cos_beta * product_15
    product_51 = sigma_path * sigma_path_squared
    sum_25 = (
        7.0 * path_squared * product_4 * sin_beta_squared
        - 2.0 * product_13 * sin_beta_squared
        - 4.0 * path_squared * product_4
        - baseline_squared_squared * cos_beta * path
        + 8.0 * baseline_squared * cos_beta * product_6
        + baseline_squared_squared * cos_beta * path * sin_beta_squared
        + product_13
        + product_45
        + product_46
        + product_47
        + product_48
        + product_49
        + product_50
    )
    sigma_beta_squared_squared = sigma_beta_squared**2
    sum_26 = (
        4.0 * baseline * cos_beta * path
        - 6.0 * baseline_squared
        + baseline_squared * cos_beta_squared
        + path_squared
    )
    sum_27 = (
        10.0 * cos_beta * product_4
        - 12.0 * baseline * cos_beta * path_squared * sin_beta_squared
        - 18.0 * baseline_squared * path
        - 3.0 * product_6 * sin_beta_squared
        + 2.0 * cos_beta * product_4 * sin_beta_squared
        + 2.0 * product_6
        + 21.0 * baseline_squared * path * sin_beta_squared
        + 3.0 * baseline_squared * path * sin_beta_squared_squared
        + 6.0 * baseline * cos_beta * path_squared
    )
    sum_28 = (
        10.0 * baseline_squared
        - 11.0 * baseline_squared * cos_beta_squared
        - 8.0 * baseline * cos_beta * path
        - path_squared
        + 2.0 * baseline_squared * cos_beta_squared_squared
        + 2.0 * cos_beta_squared * path_squared
        + 6.0 * baseline * path * product_2
    )
    product_52 = -6.0 * baseline_squared * path_squared * sin_beta_squared
    sum_29 = (
        4.0 * cos_beta * path * product_4 * sin_beta_squared
        - 2.0 * baseline_squared_squared * sin_beta_squared
        - 4.0 * cos_beta * path * product_4
        + baseline_squared_squared
        + path_squared_squared
        + product_31
        + product_33
        + product_43
        + product_52
    )
    cos_beta_squared_cubed = cos_beta_squared * cos_beta_squared**2
    term_1 = (baseline_squared**2)**2
    product_53 = baseline * baseline_squared * baseline_squared**2
    product_54 = path * path_squared * path_squared**2
    product_55 = 28.0 * baseline_squared_cubed * path_squared
    term_2 = (path_squared**2)**2
    sum_30 = (
        102.0 * baseline_squared_cubed * cos_beta_squared_squared * path_squared
        - 12.0 * baseline_squared_cubed * cos_beta_squared_cubed * path_squared
        - 126.0 * baseline_squared_cubed * cos_beta_squared * path_squared
        - 138.0 * baseline_squared_squared * cos_beta_squared_squared * path_squared_squared
        - 14.0 * baseline_squared_squared * path_squared_squared
        - 4.0 * cos_beta_squared_squared * term_1
        - 52.0 * path * product_2 * product_53
        - 60.0 * product_13 * product_14 * product_6
        - 8.0 * baseline * product_2 * product_54
        - 84.0 * product_15 * product_2 * product_4
        - 92.0 * cos_beta * product_13 * product_6
        + 12.0 * path * product_14 * product_53
        + 15.0 * baseline_squared_squared * cos_beta_squared_cubed * path_squared_squared
        + 151.0 * baseline_squared_squared * cos_beta_squared * path_squared_squared
        + 16.0 * baseline_squared * cos_beta_squared_squared * path_squared_cubed
        + 160.0 * product_13 * product_2 * product_6
        + 2.0 * baseline_squared * path_squared_cubed
        + 4.0 * cos_beta * product_15 * product_4
        + 4.0 * cos_beta_squared * term_1
        + 40.0 * cos_beta * path * product_53
        + 48.0 * product_14 * product_15 * product_4
        + 6.0 * baseline_squared * cos_beta_squared * path_squared_cubed
        + cos_beta_squared * term_2
        + cos_beta_squared_cubed * term_1
        + product_55
    )
    product_56 = -12.0 * baseline_squared_cubed * path_squared * sin_beta_squared_squared
    product_57 = -2.0 * sin_beta_squared * term_1
    product_58 = -8.0 * baseline * cos_beta * product_54
    product_59 = 15.0 * baseline_squared_squared * path_squared_squared * sin_beta_squared_squared
    product_60 = 28.0 * baseline_squared * path_squared_cubed
    product_61 = sin_beta_squared_squared * term_1
    sum_31 = (
        16.0 * cos_beta * product_13 * product_6
        - 16.0 * cos_beta * product_13 * product_6 * sin_beta_squared
        - 20.0 * baseline_squared_cubed * path_squared
        - 28.0 * baseline_squared * path_squared_cubed * sin_beta_squared
        - 34.0 * baseline_squared_squared * path_squared_squared * sin_beta_squared
        - 4.0 * cos_beta * path * product_53 * sin_beta_squared
        - 44.0 * cos_beta * product_15 * product_4
        + 22.0 * baseline_squared_squared * path_squared_squared
        + 32.0 * baseline_squared_cubed * path_squared * sin_beta_squared
        + 36.0 * cos_beta * product_15 * product_4 * sin_beta_squared
        + 4.0 * cos_beta * path * product_53
        + product_56
        + product_57
        + product_58
        + product_59
        + product_60
        + product_61
        + term_1
        + term_2
    )
    rho_squared = rho**2
    sum_32 = (
        12.0 * cos_beta * product_13 * product_6
        - 10.0 * cos_beta * product_13 * product_6 * sin_beta_squared
        - 14.0 * baseline_squared_cubed * path_squared
        - 2.0 * cos_beta * path * product_53 * sin_beta_squared_squared
        - 24.0 * baseline_squared * path_squared_cubed * sin_beta_squared
        - 24.0 * baseline_squared_squared * path_squared_squared * sin_beta_squared
        - 38.0 * cos_beta * product_15 * product_4
        - 4.0 * baseline_squared_cubed * path_squared * sin_beta_squared_squared
        + 18.0 * baseline_squared_cubed * path_squared * sin_beta_squared
        + 18.0 * baseline_squared_squared * path_squared_squared
        + 2.0 * cos_beta * product_13 * product_6 * sin_beta_squared_squared
        + 2.0 * cos_beta * path * product_53
        + 26.0 * baseline_squared * path_squared_cubed
        + 26.0 * cos_beta * product_15 * product_4 * sin_beta_squared
        + 7.0 * baseline_squared_squared * path_squared_squared * sin_beta_squared_squared
        + product_57
        + product_58
        + product_61
        + term_1
        + term_2
    )
    product_62 = -6.0 * baseline_squared_cubed * path_squared * sin_beta_squared_squared
    product_63 = 9.0 * baseline_squared_squared * path_squared_squared * sin_beta_squared_squared
    sum_33 = (
        14.0 * baseline_squared_cubed * path_squared * sin_beta_squared
        - 22.0 * baseline_squared * path_squared_cubed * sin_beta_squared
        - 22.0 * baseline_squared_squared * path_squared_squared * sin_beta_squared
        - 32.0 * cos_beta * product_15 * product_4
        - 8.0 * baseline_squared_cubed * path_squared
        - 8.0 * cos_beta * product_13 * product_6 * sin_beta_squared
        + 14.0 * baseline_squared_squared * path_squared_squared
        + 24.0 * baseline_squared * path_squared_cubed
        + 24.0 * cos_beta * product_15 * product_4 * sin_beta_squared
        + 8.0 * cos_beta * product_13 * product_6
        + product_57
        + product_58
        + product_61
        + product_62
        + product_63
        + term_1
        + term_2
    )
    sum_23_squared = sum_23**2
    term_3 = 1.0 / ((divisor_1**2)**2)**2
    sum_34 = (
        128.0 * baseline_squared * (1.0 + cos_beta) * (cos_beta - 1.0) * cos_beta_squared * predicted_sigma_path_squared * sigma_path_squared * sum_21 * sum_5_squared
        - 128.0 * baseline_squared * predicted_sigma_beta_squared * predicted_sigma_path_squared * rho * sigma_beta * sigma_path * sin_beta * sum_4
        - 128.0 * baseline_squared * predicted_rho * predicted_sigma_path * product_10 * sigma_path_squared * sin_beta * sum_1 * sum_2
        - 128.0 * baseline_squared * predicted_rho * predicted_sigma_beta * product_12 * sigma_beta_squared * sin_beta * sum_1 * sum_2
        - 128.0 * baseline_squared * predicted_rho * predicted_sigma_beta * product_12 * rho * sigma_beta * sigma_path * sin_beta_squared * sum_3
        - 128.0 * path * predicted_sigma_beta_squared * rho * sigma_beta * sigma_path * sin_beta * sum_5_squared * sum_6 * sum_7 * sum_8
        - 128.0 * path * product_18 * rho * sigma_path * sin_beta * sum_10 * sum_5_squared * sum_6 * sum_7 * sum_9
        - 128.0 * predicted_rho * predicted_sigma_beta * predicted_sigma_path * rho * sigma_beta * sigma_path * sum_11 * sum_5_squared
        - 192.0 * baseline_squared * predicted_sigma_beta_squared * predicted_sigma_path_squared * sigma_path_squared * sin_beta_squared * sum_12
        - 256.0 * baseline_squared * cos_beta * predicted_sigma_path_squared * rho * sigma_beta * sigma_path * sin_beta * sum_14 * sum_5_squared
        - 256.0 * baseline_squared * cos_beta * predicted_rho * predicted_sigma_beta * predicted_sigma_path * sigma_path_squared * sin_beta * sum_13 * sum_5_squared
        - 256.0 * baseline_squared * predicted_rho_squared * predicted_sigma_beta_squared * predicted_sigma_path_squared * rho * sigma_beta * sigma_path * sin_beta * sum_1 * sum_2
        - 256.0 * baseline_squared_squared * predicted_rho_squared * predicted_sigma_beta_squared * predicted_sigma_path_squared * sigma_path_squared * sin_beta_squared * sum_15
        - 256.0 * path * predicted_rho * predicted_sigma_beta * predicted_sigma_path * sigma_beta_squared * sin_beta * sum_16 * sum_5_squared * sum_6 * sum_7
        - 384.0 * baseline_squared_squared * predicted_sigma_path_squared_squared * product_36 * rho * sigma_beta * sigma_path * sum_17
        - 576.0 * baseline_squared_squared * predicted_sigma_path_squared_squared * sigma_path_squared * sin_beta_squared_squared * sum_18 * sum_19
        - 64.0 * baseline_squared_squared * predicted_sigma_path_squared_squared * sigma_beta_squared * sin_beta_squared * sum_15
        - 64.0 * predicted_sigma_beta_squared * sigma_path_squared * sum_20 * sum_5_squared
        - 768.0 * baseline_squared_squared * predicted_rho * predicted_sigma_beta * product_12 * product_36 * sigma_path_squared * sum_17
        + 128.0 * baseline_squared_squared * sigma_path_squared_squared * sin_beta_squared_squared * sum_18 * sum_19 * sum_22
        + 128.0 * cos_beta * path * rho * sigma_beta * sigma_path * sin_beta * sum_23 * sum_5_squared_squared * sum_6 * sum_7
        + 16.0 * path_squared * predicted_sigma_beta_squared_squared * sigma_beta_squared * sin_beta_squared * sum_24 * sum_6_squared * sum_7_squared
        + 16.0 * predicted_sigma_beta_squared_squared * sigma_path_squared * sum_2_squared
        + 256.0 * baseline_squared * product_36 * product_51 * rho * sigma_beta * sum_25
        + 32.0 * path_squared * sigma_beta_squared_squared * sum_10**2 * sum_5_squared * sum_6_squared * sum_7_squared
        + 32.0 * path * predicted_sigma_beta_squared_squared * rho * sigma_beta * sigma_path * sin_beta * sum_2 * sum_26 * sum_6 * sum_7
        + 64.0 * baseline_squared * path * predicted_sigma_beta_squared * predicted_sigma_path_squared * sigma_beta_squared * sin_beta_squared * sum_27 * sum_6 * sum_7
        + 64.0 * cos_beta_squared * sigma_path_squared * sum_23_squared * sum_5_squared_squared
        + 64.0 * path_squared * predicted_sigma_beta_squared * sigma_beta_squared * sum_28 * sum_5_squared * sum_6_squared * sum_7_squared
        + 64.0 * path_squared * sigma_beta_squared * sin_beta_squared * sum_29 * sum_6_squared * sum_7_squared
        + 64.0 * predicted_rho_squared * predicted_sigma_beta_squared * predicted_sigma_path_squared * sigma_beta_squared * sum_2_squared
        + 64.0 * predicted_sigma_path_squared * sigma_beta_squared * sin_beta_squared * sum_31
        + 64.0 * path * predicted_rho * predicted_sigma_path * product_10 * sigma_beta_squared * sin_beta * sum_2 * sum_26 * sum_6 * sum_7
        + 64.0 * predicted_rho * predicted_sigma_path * product_10 * rho * sigma_beta * sigma_path * sum_30
        + 64.0 * rho_squared * sigma_beta_squared * sigma_path_squared * sin_beta_squared * sum_32
        + 64.0 * sigma_beta_squared * sigma_path_squared * sin_beta_squared * sum_33
    )
    product_64 = -2.0 * product_15 * sin_beta_squared
    product_65 = 2.0 * cos_beta * product_13 * sin_beta_squared_squared
    product_66 = 32.0 * baseline_squared * product_6
    sum_35 = (
        11.0 * baseline_squared_squared * path * sin_beta_squared_squared
        - 12.0 * cos_beta * path_squared * product_4 * sin_beta_squared_squared
        - 13.0 * baseline * cos_beta * path_squared_squared
        - 33.0 * baseline_squared_squared * path * sin_beta_squared
        - 38.0 * cos_beta * path_squared * product_4
        - 5.0 * cos_beta * product_13
        - 61.0 * baseline_squared * product_6 * sin_beta_squared
        + 16.0 * baseline * cos_beta * path_squared_squared * sin_beta_squared
        + 2.0 * product_15
        + 22.0 * baseline_squared_squared * path
        + 26.0 * baseline_squared * product_6 * sin_beta_squared_squared
        + 3.0 * cos_beta * product_13 * sin_beta_squared
        + 49.0 * cos_beta * path_squared * product_4 * sin_beta_squared
        + product_64
        + product_65
        + product_66
    )
    product_67 = baseline_squared_squared * cos_beta * sin_beta_squared
    sum_36 = (
        12.0 * path * product_4
        - 12.0 * baseline * product_6 * sin_beta_squared
        - 14.0 * path * product_4 * sin_beta_squared
        - 18.0 * baseline_squared * cos_beta * path_squared
        - 3.0 * baseline_squared_squared * cos_beta
        - 3.0 * cos_beta * path_squared_squared
        + 12.0 * baseline * product_6
        + 13.0 * baseline_squared * cos_beta * path_squared * sin_beta_squared
        + 2.0 * baseline_squared_squared * cos_beta * sin_beta_squared_squared
        + 2.0 * path * product_4 * sin_beta_squared_squared
        + product_67
    )
    sum_37 = (
        10.0 * baseline_squared * product_6
        - 10.0 * cos_beta * path_squared * product_4
        - 25.0 * baseline_squared * product_6 * sin_beta_squared
        - 5.0 * baseline_squared_squared * path * sin_beta_squared
        - 5.0 * baseline * cos_beta * path_squared_squared
        - 6.0 * cos_beta * path_squared * product_4 * sin_beta_squared_squared
        - cos_beta * product_13
        - cos_beta * product_13 * sin_beta_squared
        + 10.0 * baseline * cos_beta * path_squared_squared * sin_beta_squared
        + 14.0 * baseline_squared * product_6 * sin_beta_squared_squared
        + 15.0 * cos_beta * path_squared * product_4 * sin_beta_squared
        + 5.0 * baseline_squared_squared * path
        + product_15
        + product_64
        + product_65
    )
    product_68 = sin_beta * sin_beta_squared**2
    sum_38 = (
        2.0 * baseline * path
        - 2.0 * baseline * path * sin_beta_squared
        - baseline_squared * cos_beta
        - cos_beta * path_squared
        + baseline_squared * cos_beta * sin_beta_squared
    )
    product_69 = -10.0 * baseline_squared_squared * path_squared * product_2
    product_70 = -6.0 * baseline * cos_beta_squared * product_15
    product_71 = baseline_squared_cubed * product_2
    product_72 = cos_beta * path_squared_cubed
    sum_39 = (
        3.0 * cos_beta_squared_squared * product_4 * product_6
        - 2.0 * path * product_13
        - 2.0 * product_4 * product_6
        - 3.0 * baseline_squared_cubed * cos_beta
        - 9.0 * cos_beta_squared * product_4 * product_6
        - cos_beta_squared_squared * path * product_13
        + 5.0 * baseline_squared * cos_beta * path_squared_squared
        + 7.0 * baseline_squared * path_squared_squared * product_2
        + 7.0 * baseline_squared_squared * cos_beta * path_squared
        + 9.0 * cos_beta_squared * path * product_13
        + product_69
        + product_70
        + product_71
        + product_72
    )
    sum_40 = (
        15.0 * baseline_squared_squared * path
        - 15.0 * baseline * cos_beta * path_squared_squared
        - 23.0 * baseline_squared_squared * path * sin_beta_squared
        - 3.0 * cos_beta * product_13
        - 30.0 * cos_beta * path_squared * product_4
        - 4.0 * product_15 * sin_beta_squared
        - 53.0 * baseline_squared * product_6 * sin_beta_squared
        - 9.0 * cos_beta * path_squared * product_4 * sin_beta_squared_squared
        + 17.0 * baseline * cos_beta * path_squared_squared * sin_beta_squared
        + 2.0 * cos_beta * product_13 * sin_beta_squared
        + 22.0 * baseline_squared * product_6 * sin_beta_squared_squared
        + 3.0 * product_15
        + 30.0 * baseline_squared * product_6
        + 37.0 * cos_beta * path_squared * product_4 * sin_beta_squared
        + 8.0 * baseline_squared_squared * path * sin_beta_squared_squared
        + cos_beta * product_13 * sin_beta_squared_squared
    )
    product_73 = -2.0 * cos_beta_squared_squared * path * product_13
    product_74 = 11.0 * baseline_squared * path_squared_squared * product_2
    product_75 = 2.0 * baseline_squared * cos_beta * path_squared_squared
    sum_41 = (
        12.0 * baseline_squared_squared * cos_beta * path_squared
        - 15.0 * baseline_squared_squared * path_squared * product_2
        - 15.0 * cos_beta_squared * product_4 * product_6
        - 5.0 * baseline_squared_cubed * cos_beta
        - 5.0 * path * product_13
        + 15.0 * cos_beta_squared * path * product_13
        + 2.0 * baseline_squared_cubed * product_2
        + 4.0 * cos_beta_squared_squared * product_4 * product_6
        + product_4 * product_6
        + product_70
        + product_72
        + product_73
        + product_74
        + product_75
    )
    sum_42 = (
        24.0 * baseline * cos_beta_squared_squared * product_6
        - 12.0 * baseline_squared_squared * cos_beta
        - 17.0 * cos_beta_squared_squared * path * product_4
        - 24.0 * path * product_4
        - 33.0 * baseline * cos_beta_squared * product_6
        - 4.0 * cos_beta * path_squared_squared
        - 54.0 * baseline_squared * path_squared * product_2
        + 42.0 * baseline_squared * cos_beta * path_squared
        + 51.0 * cos_beta_squared * path * product_4
        + 6.0 * baseline_squared * path_squared * product_14
        + 6.0 * path_squared_squared * product_2
        + 7.0 * baseline * product_6
        + 8.0 * baseline_squared_squared * product_2
    )
    sum_43 = (
        22.0 * baseline_squared * cos_beta * path
        - 12.0 * baseline * cos_beta_squared * path_squared
        - 20.0 * product_4
        - 4.0 * baseline_squared * path * product_2
        - 4.0 * cos_beta * product_6
        + 9.0 * cos_beta_squared * product_4
        + 9.0 * baseline * path_squared
    )
    sum_44 = 2.0 * baseline_squared - baseline * cos_beta * path - path_squared
    product_76 = 12.0 * baseline * path_squared_squared * product_2
    sum_45 = (
        3.0 * baseline * cos_beta * path_squared_squared
        - 12.0 * cos_beta * product_13
        - 16.0 * baseline_squared_squared * cos_beta_squared_squared * path
        - 28.0 * baseline_squared_squared * path
        - 4.0 * baseline_squared * product_6
        - 46.0 * baseline_squared * cos_beta_squared * product_6
        - 65.0 * path_squared * product_2 * product_4
        - 8.0 * cos_beta_squared * product_15
        + 32.0 * baseline_squared * cos_beta_squared_squared * product_6
        + 4.0 * path_squared * product_14 * product_4
        + 4.0 * product_15
        + 50.0 * baseline_squared_squared * cos_beta_squared * path
        + 65.0 * cos_beta * path_squared * product_4
        + 9.0 * product_13 * product_2
        + product_76
    )
    sum_46 = (
        12.0 * baseline_squared * cos_beta_squared_squared * product_6
        - 16.0 * baseline_squared_squared * path
        - 27.0 * path_squared * product_2 * product_4
        - 28.0 * baseline_squared * cos_beta_squared * product_6
        - 3.0 * baseline * cos_beta * path_squared_squared
        - 4.0 * baseline_squared_squared * cos_beta_squared_squared * path
        - 4.0 * cos_beta * product_13
        - 4.0 * cos_beta_squared * product_15
        + 2.0 * baseline_squared * product_6
        + 2.0 * product_15
        + 20.0 * baseline_squared_squared * cos_beta_squared * path
        + 3.0 * product_13 * product_2
        + 35.0 * cos_beta * path_squared * product_4
        + product_76
    )
    product_77 = -4.0 * baseline_squared_cubed * cos_beta
    sum_47 = (
        12.0 * cos_beta_squared * path * product_13
        - 12.0 * baseline_squared_squared * path_squared * product_2
        - 18.0 * cos_beta_squared * product_4 * product_6
        - 6.0 * path * product_13
        + 15.0 * baseline_squared * path_squared_squared * product_2
        + 15.0 * baseline_squared_squared * cos_beta * path_squared
        + 2.0 * product_4 * product_6
        + product_70
        + product_71
        + product_72
        + product_77
    )
    sum_48 = (
        13.0 * baseline_squared_squared * cos_beta * path_squared
        - 14.0 * cos_beta_squared * product_4 * product_6
        - 4.0 * path * product_13
        + 2.0 * cos_beta_squared_squared * product_4 * product_6
        + 3.0 * baseline_squared_cubed * product_2
        + 8.0 * cos_beta_squared * path * product_13
        + product_69
        + product_70
        + product_72
        + product_73
        + product_74
        + product_75
        + product_77
    )
    sum_49 = (
        16.0 * cos_beta * path_squared * product_4
        - 11.0 * baseline_squared * cos_beta_squared * product_6
        - 12.0 * path_squared * product_2 * product_4
        - 2.0 * baseline_squared_squared * cos_beta_squared_squared * path
        - 2.0 * cos_beta * product_13
        - 2.0 * cos_beta_squared * product_15
        - 6.0 * baseline_squared_squared * path
        - baseline_squared * product_6
        + 2.0 * product_13 * product_2
        + 4.0 * baseline * path_squared_squared * product_2
        + 6.0 * baseline_squared * cos_beta_squared_squared * product_6
        + 7.0 * baseline_squared_squared * cos_beta_squared * path
        + product_15
    )
    sum_50 = (
        3.0 * baseline_squared * cos_beta * path
        - 2.0 * product_4
        - 3.0 * baseline * cos_beta_squared * path_squared
        + cos_beta * product_6
        + cos_beta_squared * product_4
    )
    product_78 = -25.0 * baseline * cos_beta * path_squared_squared
    sum_51 = (
        13.0 * cos_beta * product_13
        - 17.0 * baseline_squared * product_6 * sin_beta_squared
        - 18.0 * baseline_squared * product_6 * sin_beta_squared_squared
        - 29.0 * baseline_squared_squared * path
        - 51.0 * cos_beta * path_squared * product_4 * sin_beta_squared
        - 6.0 * product_15 * sin_beta_squared
        + 24.0 * baseline * cos_beta * path_squared_squared * sin_beta_squared
        + 4.0 * cos_beta * path_squared * product_4
        + 41.0 * baseline_squared_squared * path * sin_beta_squared
        + 5.0 * cos_beta * product_13 * sin_beta_squared
        + 5.0 * product_15
        + 6.0 * baseline_squared_squared * path * sin_beta_squared_squared
        + product_66
        + product_78
    )
    sum_52 = (
        4.0 * baseline_squared * cos_beta * path
        - 4.0 * baseline * cos_beta_squared * path_squared
        - 6.0 * product_4
        - baseline_squared * path * product_2
        - cos_beta * product_6
        + 4.0 * cos_beta_squared * product_4
        + 4.0 * baseline * path_squared
    )
    sin_beta_squared_cubed = sin_beta_squared * sin_beta_squared**2
    sum_53 = (
        2.0 * baseline_squared_cubed * path * sin_beta_squared_cubed
        - 14.0 * cos_beta * path_squared_squared * product_4
        - 3.0 * baseline_squared_cubed * path
        - 32.0 * cos_beta * path_squared * product_13 * sin_beta_squared_squared
        - 38.0 * baseline_squared * product_15 * sin_beta_squared
        - 6.0 * baseline_squared_squared * product_6 * sin_beta_squared_cubed
        - 8.0 * cos_beta * path_squared * product_13
        - 91.0 * baseline_squared_squared * product_6 * sin_beta_squared_squared
        - 98.0 * cos_beta * path_squared * product_13 * sin_beta_squared
        - baseline_squared * product_15
        - product_54
        + 2.0 * cos_beta * product_53
        + 2.0 * product_54 * sin_beta_squared
        + 21.0 * baseline_squared_squared * product_6
        + 29.0 * baseline_squared_cubed * path * sin_beta_squared_squared
        + 32.0 * baseline_squared_cubed * path * sin_beta_squared
        + 32.0 * cos_beta * path_squared_squared * product_4 * sin_beta_squared_squared
        + 36.0 * baseline_squared * product_15 * sin_beta_squared_squared
        + 36.0 * baseline_squared_squared * product_6 * sin_beta_squared
        + 4.0 * baseline * cos_beta * path_squared_cubed
        + 4.0 * cos_beta * product_53 * sin_beta_squared_squared
        + 52.0 * cos_beta * path_squared_squared * product_4 * sin_beta_squared
        + 6.0 * cos_beta * product_53 * sin_beta_squared
    )
    product_79 = 3.0 * baseline_squared * path_squared
    sum_54 = (
        8.0 * cos_beta * path * product_4
        - 3.0 * baseline_squared * cos_beta_squared * path_squared
        - 6.0 * baseline_squared_squared
        + baseline_squared_squared * cos_beta_squared
        + path_squared_squared
        + product_31
        + product_79
    )
    product_80 = -4.0 * baseline * product_6 * sin_beta_squared
    product_81 = -cos_beta * path_squared_squared
    product_82 = 4.0 * baseline * product_6
    sum_55 = (
        3.0 * baseline_squared_squared * cos_beta
        - 2.0 * baseline_squared * cos_beta * path_squared
        - 3.0 * baseline_squared * cos_beta * path_squared * sin_beta_squared
        + 6.0 * path * product_4 * sin_beta_squared
        + product_5
        + product_67
        + product_80
        + product_81
        + product_82
    )
    sum_56 = 5.0 * baseline * cos_beta - 5.0 * path + 6.0 * path * sin_beta_squared
    sum_57 = (
        2.0 * baseline_squared * cos_beta
        - 3.0 * cos_beta * path_squared * sin_beta_squared
        - 4.0 * baseline * path
        + 2.0 * cos_beta * path_squared
        + 5.0 * baseline * path * sin_beta_squared
    )
    sum_58 = (
        12.0 * baseline_squared_squared * path * sin_beta_squared_squared
        - 2.0 * cos_beta * path_squared * product_4
        - 24.0 * baseline_squared * product_6 * sin_beta_squared_squared
        - 38.0 * baseline_squared_squared * path
        - 44.0 * baseline_squared * product_6 * sin_beta_squared
        - 87.0 * cos_beta * path_squared * product_4 * sin_beta_squared
        + 17.0 * cos_beta * product_13 * sin_beta_squared
        + 19.0 * cos_beta * product_13
        + 2.0 * product_15
        + 44.0 * baseline_squared * product_6
        + 48.0 * baseline * cos_beta * path_squared_squared * sin_beta_squared
        + 62.0 * baseline_squared_squared * path * sin_beta_squared
        + product_78
    )
    sum_59 = (
        16.0 * path * product_4 * sin_beta_squared
        - 12.0 * path * product_4
        - 9.0 * baseline_squared * cos_beta * path_squared * sin_beta_squared
        + 2.0 * baseline_squared * cos_beta * path_squared
        + 7.0 * baseline_squared_squared * cos_beta
        + product_67
        + product_80
        + product_81
        + product_82
    )
    sum_60 = baseline - cos_beta * path
    sum_61 = (
        128.0 * baseline_squared_cubed * path_squared * product_2
        - 12.0 * baseline_squared_cubed * path_squared * product_14
        - 134.0 * baseline_squared_cubed * cos_beta * path_squared
        - 136.0 * baseline_squared_squared * path_squared_squared * product_2
        - 16.0 * product_2 * term_1
        - 43.0 * product_13 * product_6
        - 61.0 * cos_beta_squared * product_15 * product_4
        - 8.0 * baseline * cos_beta_squared * product_54
        - 85.0 * cos_beta_squared_squared * product_13 * product_6
        - 95.0 * cos_beta_squared * path * product_53
        + 15.0 * baseline_squared_squared * path_squared_squared * product_14
        + 16.0 * baseline_squared * path_squared_cubed * product_2
        + 196.0 * cos_beta_squared * product_13 * product_6
        + 24.0 * cos_beta * term_1
        + 29.0 * cos_beta_squared_squared * path * product_53
        + 3.0 * product_15 * product_4
        + 48.0 * cos_beta_squared_squared * product_15 * product_4
        + 48.0 * path * product_53
        + 6.0 * baseline_squared * cos_beta * path_squared_cubed
        + 75.0 * baseline_squared_squared * cos_beta * path_squared_squared
        + cos_beta * term_2
        + product_14 * term_1
    )
    sum_62 = path - 2.0 * cos_beta_squared * path + product_16
    sum_63 = (
        128.0 * baseline_squared * predicted_rho_squared * predicted_sigma_beta_squared * predicted_sigma_path_squared * rho * sigma_beta * sigma_path * sin_beta_squared * sum_51
        - 128.0 * baseline_squared * predicted_sigma_path_squared * product_36 * sigma_path_squared * sum_36
        - 128.0 * baseline_squared * predicted_sigma_path_squared * rho * sigma_beta * sigma_path * sin_beta_squared * sum_35
        - 128.0 * baseline_squared * product_51 * rho * sigma_beta * sin_beta_squared * sum_37
        - 128.0 * baseline_squared_squared * product_68 * sigma_path_squared_squared * sum_38
        - 128.0 * predicted_sigma_beta_squared * sigma_path_squared * sin_beta * sum_39 * sum_5_squared
        - 256.0 * baseline_squared * predicted_rho * predicted_sigma_beta * predicted_sigma_path * sigma_path_squared * sin_beta_squared * sum_40
        - 256.0 * predicted_rho * predicted_sigma_beta * predicted_sigma_path * rho * sigma_beta * sigma_path * sin_beta * sum_41 * sum_5_squared
        - 32.0 * baseline_squared * predicted_sigma_beta_squared * predicted_sigma_path_squared * sigma_beta_squared * sin_beta * sum_42 * sum_6 * sum_7
        - 32.0 * path * predicted_sigma_beta_squared * sigma_beta_squared * sin_beta * sum_43 * sum_5_squared * sum_6_squared * sum_7_squared
        - 32.0 * predicted_sigma_beta_squared * rho * sigma_beta * sigma_path * sum_45 * sum_5_squared * sum_6 * sum_7
        - 32.0 * path * sigma_beta_squared_squared * sin_beta * sum_10 * sum_44 * sum_5_squared * sum_6_squared * sum_7_squared
        - 64.0 * predicted_sigma_path_squared * sigma_beta_squared * sin_beta * sum_47 * sum_5_squared
        - 64.0 * product_18 * rho * sigma_path * sum_49 * sum_5_squared * sum_6 * sum_7
        - 64.0 * rho_squared * sigma_beta_squared * sigma_path_squared * sin_beta * sum_48 * sum_5_squared
        - 64.0 * sigma_beta_squared * sigma_path_squared * sin_beta * sum_50 * sum_5_squared * sum_9
        - 64.0 * predicted_rho * predicted_sigma_beta * predicted_sigma_path * sigma_beta_squared * sum_46 * sum_5_squared * sum_6 * sum_7
        + 16.0 * path * predicted_sigma_beta_squared_squared * sigma_beta_squared * sin_beta * sum_26 * sum_52 * sum_6_squared * sum_7_squared
        + 16.0 * predicted_sigma_beta_squared_squared * sigma_path_squared * sin_beta * sum_2 * sum_54
        + 16.0 * predicted_sigma_beta_squared_squared * rho * sigma_beta * sigma_path * sum_53 * sum_6 * sum_7
        + 192.0 * baseline_squared * predicted_sigma_beta_squared * predicted_sigma_path_squared * product_36 * sigma_path_squared * sum_55
        + 192.0 * baseline_squared_squared * predicted_sigma_path_squared_squared * product_36 * sigma_beta_squared * sum_57
        + 192.0 * baseline_squared_squared * predicted_sigma_path_squared_squared * rho * sigma_beta * sigma_path * sin_beta_squared_squared * sum_56
        + 32.0 * baseline_squared * predicted_sigma_beta_squared * predicted_sigma_path_squared * rho * sigma_beta * sigma_path * sin_beta_squared * sum_58
        + 32.0 * predicted_rho * predicted_sigma_path * product_10 * sigma_beta_squared * sum_53 * sum_6 * sum_7
        + 384.0 * baseline_squared * predicted_rho * predicted_sigma_beta * product_12 * product_36 * rho * sigma_beta * sigma_path * sum_59
        + 384.0 * baseline_squared_squared * predicted_rho * predicted_sigma_beta * product_12 * sigma_path_squared * sin_beta_squared_squared * sum_56
        + 576.0 * baseline_squared_squared * cos_beta * predicted_sigma_path_squared_squared * product_68 * sigma_path_squared
        + 64.0 * baseline_squared * predicted_rho * predicted_sigma_path * product_10 * sigma_path_squared * sin_beta_squared * sum_51
        + 64.0 * baseline_squared * predicted_rho * predicted_sigma_beta * product_12 * sigma_beta_squared * sin_beta_squared * sum_51
        + 64.0 * cos_beta * sigma_path_squared * sin_beta * sum_23_squared * sum_5_squared_squared
        + 64.0 * predicted_rho_squared * predicted_sigma_beta_squared * predicted_sigma_path_squared * sigma_beta_squared * sin_beta * sum_2 * sum_54
        + 64.0 * predicted_rho * predicted_sigma_path * product_10 * rho * sigma_beta * sigma_path * sin_beta * sum_61
        + 64.0 * path * sigma_beta_squared * sin_beta * sum_5_squared_squared * sum_60 * sum_6_squared * sum_7_squared
        + 64.0 * rho * sigma_beta * sigma_path * sum_23 * sum_5_squared_squared * sum_6 * sum_62 * sum_7
        + 768.0 * baseline_squared_squared * predicted_rho_squared * predicted_sigma_beta_squared * predicted_sigma_path_squared * product_36 * sigma_path_squared * sum_57
    )
    product_83 = -2.0 * cos_beta * path * product_4 * sin_beta_squared
    product_84 = baseline_squared_squared * sin_beta_squared
    sum_64 = (
        12.0 * cos_beta * path * product_4
        - 18.0 * baseline_squared * path_squared
        - 3.0 * baseline_squared_squared
        - 3.0 * path_squared_squared
        + 12.0 * baseline * cos_beta * product_6
        + 13.0 * baseline_squared * path_squared * sin_beta_squared
        + 2.0 * baseline_squared_squared * sin_beta_squared_squared
        + product_83
        + product_84
    )
    product_85 = 5.0 * path_squared * product_4
    product_86 = 6.0 * baseline * cos_beta_squared * path_squared_squared
    sum_65 = (
        22.0 * baseline_squared_squared * cos_beta * path
        - 10.0 * product_13
        - 2.0 * baseline_squared_squared * path * product_2
        - 2.0 * cos_beta * product_15
        - 21.0 * cos_beta_squared * path_squared * product_4
        - 8.0 * baseline_squared * cos_beta * product_6
        + 3.0 * cos_beta_squared * product_13
        + 6.0 * baseline_squared * product_2 * product_6
        + baseline * path_squared_squared
        + product_85
        + product_86
    )
    product_87 = 3.0 * product_13 * sin_beta_squared
    sum_66 = (
        17.0 * baseline * path_squared_squared * sin_beta_squared
        - 10.0 * baseline_squared_squared * cos_beta * path * sin_beta_squared
        - 20.0 * baseline * path_squared_squared
        - 22.0 * baseline_squared * cos_beta * product_6 * sin_beta_squared
        - 4.0 * product_13
        - 40.0 * path_squared * product_4
        - 9.0 * path_squared * product_4 * sin_beta_squared_squared
        + 20.0 * baseline_squared_squared * cos_beta * path
        + 4.0 * cos_beta * product_15
        + 40.0 * baseline_squared * cos_beta * product_6
        + 44.0 * path_squared * product_4 * sin_beta_squared
        + product_49
        + product_87
    )
    sum_67 = (
        17.0 * baseline_squared_squared * cos_beta * path
        - 13.0 * baseline_squared * cos_beta * product_6 * sin_beta_squared
        - 28.0 * path_squared * product_4
        - 4.0 * product_13
        - 6.0 * path_squared * product_4 * sin_beta_squared_squared
        - 7.0 * baseline_squared_squared * cos_beta * path * sin_beta_squared
        - 8.0 * baseline * path_squared_squared
        + 22.0 * baseline_squared * cos_beta * product_6
        + 29.0 * path_squared * product_4 * sin_beta_squared
        + 8.0 * baseline * path_squared_squared * sin_beta_squared
        + product_49
        + product_50
        + product_87
    )
    product_88 = -baseline_squared_squared * cos_beta * path * sin_beta_squared
    sum_68 = (
        10.0 * baseline_squared * cos_beta * product_6
        - 10.0 * path_squared * product_4
        - product_13
        + 11.0 * path_squared * product_4 * sin_beta_squared
        + 5.0 * baseline_squared_squared * cos_beta * path
        + product_45
        + product_46
        + product_47
        + product_48
        + product_49
        + product_50
        + product_88
    )
    product_89 = -9.0 * baseline_squared_squared * path_squared
    sum_69 = (
        12.0 * cos_beta * path * product_13
        - 2.0 * baseline_squared * path_squared_squared * sin_beta_squared
        - 4.0 * baseline_squared_cubed
        - 4.0 * cos_beta * path * product_13 * sin_beta_squared
        - 4.0 * cos_beta * product_4 * product_6
        - baseline_squared_squared * path_squared * sin_beta_squared_squared
        - path_squared_cubed
        + 4.0 * baseline_squared_cubed * sin_beta_squared
        + 6.0 * baseline_squared * path_squared_squared
        + 6.0 * baseline_squared_squared * path_squared * sin_beta_squared
        + product_89
    )
    sum_70 = (
        16.0 * baseline_squared * product_2 * product_6
        - 12.0 * baseline_squared_squared * path * product_2
        - 14.0 * baseline_squared * cos_beta * product_6
        - 20.0 * product_13
        - 39.0 * cos_beta_squared * path_squared * product_4
        - 4.0 * cos_beta * product_15
        + 2.0 * cos_beta_squared_squared * path_squared * product_4
        + 46.0 * baseline_squared_squared * cos_beta * path
        + 5.0 * baseline * path_squared_squared
        + 9.0 * cos_beta_squared * product_13
        + product_85
        + product_86
    )
    sum_71 = (
        14.0 * cos_beta * path * product_4
        - 10.0 * baseline_squared_squared
        - 13.0 * baseline_squared * cos_beta_squared * path_squared
        - 7.0 * baseline * cos_beta * product_6
        - 9.0 * path * product_2 * product_4
        - path_squared_squared
        + 2.0 * baseline_squared * cos_beta_squared_squared * path_squared
        + 2.0 * cos_beta_squared * path_squared_squared
        + 6.0 * baseline * product_2 * product_6
        + 8.0 * baseline_squared * path_squared
        + 8.0 * baseline_squared_squared * cos_beta_squared
    )
    sum_72 = (
        12.0 * cos_beta * product_4 * product_6
        - 25.0 * baseline_squared_cubed * cos_beta_squared
        - 36.0 * baseline_squared_squared * cos_beta_squared_squared * path_squared
        - 40.0 * product_2 * product_4 * product_6
        - 46.0 * cos_beta * path * product_13
        - 5.0 * baseline_squared * cos_beta_squared * path_squared_squared
        - path_squared_cubed
        + 20.0 * baseline_squared_cubed
        + 44.0 * path * product_13 * product_2
        + 6.0 * baseline_squared_cubed * cos_beta_squared_squared
        + 60.0 * baseline_squared_squared * cos_beta_squared * path_squared
        + product_19
        + product_24
        + product_26
        + product_27
        + product_28
        + product_30
        + product_37
        + product_89
    )
    sum_73 = (
        10.0 * sin_beta_squared * term_1
        - 10.0 * baseline_squared * path_squared_cubed * sin_beta_squared
        - 16.0 * cos_beta * path * product_53 * sin_beta_squared
        - 24.0 * cos_beta * product_15 * product_4 * sin_beta_squared
        - 74.0 * baseline_squared_squared * path_squared_squared
        - 80.0 * cos_beta * path * product_53
        - 94.0 * baseline_squared_cubed * path_squared * sin_beta_squared
        + 16.0 * baseline_squared * path_squared_cubed
        + 16.0 * cos_beta * product_15 * product_4
        + 25.0 * term_1
        + 40.0 * cos_beta * product_13 * product_6
        + 56.0 * cos_beta * product_13 * product_6 * sin_beta_squared
        + 62.0 * baseline_squared_squared * path_squared_squared * sin_beta_squared
        + 64.0 * baseline_squared_cubed * path_squared
        + product_58
        + product_61
        + product_62
        + product_63
        + term_2
    )
    sum_74 = (
        2.0 * baseline_squared_squared
        - 5.0 * cos_beta * path * product_4
        - 5.0 * cos_beta * path * product_4 * sin_beta_squared
        - baseline_squared * path_squared * sin_beta_squared_squared
        - path_squared_squared
        + 4.0 * baseline_squared_squared * sin_beta_squared
        + baseline * cos_beta * product_6
        + path_squared_squared * sin_beta_squared
        + product_32
        + product_52
        + product_79
    )
    product_90 = 4.0 * baseline * cos_beta * product_6
    sum_75 = (
        5.0 * baseline_squared_squared
        - 3.0 * baseline_squared * path_squared * sin_beta_squared
        - 8.0 * cos_beta * path * product_4
        - path_squared_squared
        + product_84
        + product_90
    )
    sum_76 = (
        5.0 * baseline_squared_squared * sin_beta_squared
        - 16.0 * cos_beta * path * product_4
        - 19.0 * baseline_squared * path_squared * sin_beta_squared
        - 5.0 * path_squared_squared
        + 7.0 * baseline_squared_squared
        + 8.0 * path_squared_squared * sin_beta_squared
        + product_32
        + product_43
        + product_44
        + product_83
    )
    sum_77 = baseline_squared - path_squared * sin_beta_squared + path_squared + product_42
    sum_78 = (
        3.0 * baseline_squared * cos_beta * product_6 * sin_beta_squared
        - 11.0 * path_squared * product_4 * sin_beta_squared
        - 13.0 * baseline_squared_squared * cos_beta * path
        + 4.0 * baseline_squared * cos_beta * product_6
        + 4.0 * baseline * path_squared_squared * sin_beta_squared
        + 5.0 * product_13
        + 8.0 * path_squared * product_4
        + product_13 * sin_beta_squared
        + product_46
        + product_50
        + product_88
    )
    sum_79 = (
        11.0 * baseline_squared_squared
        - 20.0 * cos_beta * path * product_4
        - 9.0 * baseline_squared * path_squared * sin_beta_squared
        - path_squared_squared
        + product_43
        + product_84
        + product_90
    )
    sum_80 = (
        10.0 * cos_beta * product_15 * product_4
        - 110.0 * cos_beta * path * product_53
        - 154.0 * baseline_squared_cubed * path_squared * sin_beta_squared
        - 16.0 * baseline_squared * path_squared_cubed * sin_beta_squared
        - 46.0 * cos_beta * path * product_53 * sin_beta_squared
        - 48.0 * cos_beta * product_15 * product_4 * sin_beta_squared
        - 98.0 * baseline_squared_squared * path_squared_squared
        + 104.0 * baseline_squared_squared * path_squared_squared * sin_beta_squared
        + 110.0 * cos_beta * product_13 * product_6 * sin_beta_squared
        + 22.0 * baseline_squared * path_squared_cubed
        + 34.0 * sin_beta_squared * term_1
        + 37.0 * term_1
        + 70.0 * baseline_squared_cubed * path_squared
        + 76.0 * cos_beta * product_13 * product_6
        + product_56
        + product_58
        + product_59
        + product_61
        + term_2
    )
    product_91 = -2.0 * cos_beta * product_4 * product_6
    sum_81 = (
        10.0 * baseline_squared_cubed
        - 11.0 * baseline_squared_cubed * cos_beta_squared
        - 24.0 * product_2 * product_4 * product_6
        - 32.0 * cos_beta * path * product_13
        - 4.0 * baseline_squared * path_squared_squared
        - path_squared_cubed
        + 28.0 * path * product_13 * product_2
        + 3.0 * baseline_squared_squared * path_squared
        + 36.0 * baseline_squared_squared * cos_beta_squared * path_squared
        + 5.0 * baseline_squared * cos_beta_squared * path_squared_squared
        + product_19
        + product_21
        + product_25
        + product_26
        + product_28
        + product_38
        + product_40
        + product_41
        + product_91
    )
    product_92 = -12.0 * baseline_squared_squared * cos_beta_squared_squared * path_squared
    product_93 = -6.0 * baseline_squared_squared * path_squared
    product_94 = -6.0 * baseline * product_15 * product_2
    product_95 = 33.0 * baseline_squared_squared * cos_beta_squared * path_squared
    product_96 = cos_beta_squared * path_squared_cubed
    sum_82 = (
        10.0 * baseline_squared_cubed
        - 10.0 * baseline_squared_cubed * cos_beta_squared
        - 24.0 * cos_beta * path * product_13
        + 15.0 * baseline_squared * cos_beta_squared_squared * path_squared_squared
        + 18.0 * path * product_13 * product_2
        + baseline_squared_cubed * cos_beta_squared_squared
        + product_22
        + product_29
        + product_92
        + product_93
        + product_94
        + product_95
        + product_96
    )
    sum_83 = (
        11.0 * baseline_squared * cos_beta_squared_squared * path_squared_squared
        - 12.0 * baseline_squared_cubed * cos_beta_squared
        - 20.0 * product_2 * product_4 * product_6
        + 2.0 * baseline_squared * cos_beta_squared * path_squared_squared
        + 2.0 * baseline_squared * path_squared_squared
        + 2.0 * product_14 * product_4 * product_6
        + 5.0 * baseline_squared_cubed * cos_beta_squared_squared
        + 8.0 * baseline_squared_cubed
        + product_20
        + product_38
        + product_39
        + product_91
        + product_92
        + product_93
        + product_94
        + product_95
        + product_96
    )
    sum_84 = (
        12.0 * cos_beta * path * product_53 * sin_beta_squared
        - 110.0 * baseline_squared_squared * path_squared_squared * sin_beta_squared
        - 20.0 * cos_beta * product_13 * product_6 * sin_beta_squared_squared
        - 26.0 * baseline_squared * path_squared_cubed * sin_beta_squared
        - 4.0 * baseline_squared_cubed * path_squared * sin_beta_squared_cubed
        - 4.0 * cos_beta * path * product_53 * sin_beta_squared_squared
        - 54.0 * baseline_squared_cubed * path_squared * sin_beta_squared
        - 56.0 * cos_beta * product_13 * product_6
        - 56.0 * cos_beta * product_15 * product_4
        - 8.0 * cos_beta * path * product_53
        + 30.0 * baseline_squared_cubed * path_squared * sin_beta_squared_squared
        + 41.0 * baseline_squared_squared * path_squared_squared * sin_beta_squared_squared
        + 44.0 * cos_beta * product_15 * product_4 * sin_beta_squared
        + 70.0 * baseline_squared_squared * path_squared_squared
        + 72.0 * cos_beta * product_13 * product_6 * sin_beta_squared
        + product_55
        + product_57
        + product_58
        + product_60
        + product_61
        + term_1
        + term_2
    )
    sum_85 = (
        1152.0 * baseline_squared_squared * predicted_sigma_path_squared_squared * product_68 * rho * sigma_beta * sigma_path * sum_60
        - 128.0 * baseline_squared * predicted_sigma_path_squared * sigma_path_squared * sin_beta_squared_squared * sum_64
        - 128.0 * baseline_squared_squared * sigma_path_squared_squared * sin_beta_squared_cubed * sum_22
        - 128.0 * product_18 * rho * sigma_path * sin_beta * sum_44 * sum_50 * sum_5_squared * sum_6 * sum_7
        - 128.0 * predicted_rho * predicted_sigma_beta * predicted_sigma_path * sigma_beta_squared * sin_beta * sum_5_squared * sum_6 * sum_65 * sum_7
        - 256.0 * baseline_squared * predicted_sigma_path_squared * product_36 * rho * sigma_beta * sigma_path * sum_67
        - 256.0 * baseline_squared * product_36 * product_51 * rho * sigma_beta * sum_68
        - 256.0 * baseline_squared * predicted_rho * predicted_sigma_beta * predicted_sigma_path * product_36 * sigma_path_squared * sum_66
        - 32.0 * sigma_beta_squared_squared * sin_beta_squared * sum_69 * sum_6_squared * sum_7_squared
        - 64.0 * predicted_sigma_beta_squared * sigma_beta_squared * sum_5_squared * sum_6_squared * sum_71 * sum_7_squared
        - 64.0 * predicted_sigma_beta_squared * rho * sigma_beta * sigma_path * sin_beta * sum_5_squared * sum_6 * sum_7 * sum_70
        + 128.0 * rho * sigma_beta * sigma_path * sin_beta * sum_23 * sum_5_squared_squared * sum_6 * sum_60 * sum_7
        + 128.0 * predicted_rho * predicted_sigma_beta * predicted_sigma_path * rho * sigma_beta * sigma_path * sum_5_squared * sum_72
        + 16.0 * predicted_sigma_beta_squared_squared * sigma_beta_squared * sum_52**2 * sum_6_squared * sum_7_squared
        + 16.0 * predicted_sigma_beta_squared_squared * sigma_path_squared * sin_beta_squared * sum_73
        + 192.0 * baseline_squared * predicted_sigma_beta_squared * predicted_sigma_path_squared * sigma_beta_squared * sin_beta_squared * sum_6 * sum_7 * sum_74
        + 192.0 * baseline_squared * predicted_sigma_beta_squared * predicted_sigma_path_squared * sigma_path_squared * sin_beta_squared_squared * sum_75
        + 192.0 * predicted_sigma_beta_squared * predicted_sigma_path_squared * product_36 * product_4 * rho * sigma_beta * sigma_path * sum_76
        + 2304.0 * baseline_squared_squared * predicted_rho_squared * predicted_sigma_beta_squared * predicted_sigma_path_squared * sigma_path_squared * sin_beta_squared_squared * sum_77
        + 2304.0 * baseline_squared_squared * predicted_rho * predicted_sigma_beta * product_12 * product_68 * sigma_path_squared * sum_60
        + 32.0 * predicted_sigma_beta_squared_squared * rho * sigma_beta * sigma_path * sin_beta * sum_52 * sum_54 * sum_6 * sum_7
        + 384.0 * baseline_squared * predicted_rho * predicted_sigma_path * product_10 * product_36 * sigma_path_squared * sum_78
        + 384.0 * baseline_squared * predicted_rho * predicted_sigma_beta * product_12 * product_36 * sigma_beta_squared * sum_78
        + 384.0 * baseline_squared * predicted_rho * predicted_sigma_beta * product_12 * rho * sigma_beta * sigma_path * sin_beta_squared_squared * sum_79
        + 576.0 * baseline_squared_squared * predicted_sigma_path_squared_squared * sigma_beta_squared * sin_beta_squared_squared * sum_77
        + 576.0 * baseline_squared_squared * predicted_sigma_path_squared_squared * sigma_path_squared * sin_beta_squared_cubed
        + 64.0 * predicted_rho_squared * predicted_sigma_beta_squared * predicted_sigma_path_squared * sigma_beta_squared * sin_beta_squared * sum_73
        + 64.0 * predicted_sigma_beta_squared * sigma_path_squared * sum_5_squared * sum_81
        + 64.0 * predicted_sigma_path_squared * sigma_beta_squared * sum_5_squared * sum_82
        + 64.0 * predicted_rho * predicted_sigma_path * product_10 * sigma_beta_squared * sin_beta * sum_52 * sum_54 * sum_6 * sum_7
        + 64.0 * predicted_rho * predicted_sigma_path * product_10 * rho * sigma_beta * sigma_path * sin_beta_squared * sum_80
        + 64.0 * rho_squared * sigma_beta_squared * sigma_path_squared * sum_5_squared * sum_83
        + 64.0 * sigma_beta_squared * sigma_path_squared * sum_50**2 * sum_5_squared
        + 64.0 * sigma_beta_squared * sum_5_squared_squared * sum_60**2 * sum_6_squared * sum_7_squared
        + 64.0 * sigma_path_squared * sin_beta_squared * sum_84
        + 768.0 * baseline_squared * predicted_rho_squared * predicted_sigma_beta_squared * predicted_sigma_path_squared * product_36 * rho * sigma_beta * sigma_path * sum_78
    )
    result = _empty(arguments, (2, 2))
    result[..., 0, 0] = sum_34 * term_3
    result[..., 0, 1] = sum_63 * term_3
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = sum_85 * term_3
    return result
