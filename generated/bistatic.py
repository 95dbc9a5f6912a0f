"""NumPy functions of the quantities bistatic.*.

Written by radartrack regenerate, generator 1, derivation c2881b4ad9f74dbd; not to be edited.
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

    Accuracy: at most 23.3 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 41.5.
    """
    arguments = _floats(path, beta, baseline)
    path, beta, baseline = arguments
    baseline_per_path = baseline / path
    cos_beta = np.cos(beta)
    divisor_1 = 2.0 - 2.0 * baseline_per_path * cos_beta
    term_1 = 1.0 / divisor_1
    sum_1 = 1.0 + baseline_per_path
    sum_2 = baseline_per_path - 1.0
    result = _empty(arguments, (2,))
    result[..., 0] = -cos_beta * path * sum_1 * sum_2 * term_1
    result[..., 1] = -path * np.sin(beta) * sum_1 * sum_2 * term_1
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

    Accuracy: at most 128 ulp anywhere in this domain, proved for elementary functions within 1 ulp (float64);
    in float32, with functions within 4 of its ulp, at most 241.
    """
    arguments = _floats(path, beta, baseline)
    path, beta, baseline = arguments
    baseline_per_path = baseline / path
    cos_beta = np.cos(beta)
    product_1 = -2.0 * baseline_per_path * cos_beta
    divisor_1 = 2.0 + product_1
    sum_1 = 1.0 + baseline_per_path**2 + product_1
    term_1 = 1.0 / divisor_1**2
    sum_2 = 1.0 + baseline_per_path
    sum_3 = baseline_per_path - 1.0
    sin_beta = np.sin(beta)
    result = _empty(arguments, (2, 2))
    result[..., 0, 0] = 2.0 * cos_beta * sum_1 * term_1
    result[..., 0, 1] = 2.0 * path * sin_beta * sum_2 * sum_3 * term_1
    result[..., 1, 0] = 2.0 * sin_beta * sum_1 * term_1
    result[..., 1, 1] = 2.0 * (baseline_per_path - cos_beta) * path * sum_2 * sum_3 * term_1
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

    Accuracy: at most 1700 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64).
    """
    arguments = _floats(path, beta, baseline)
    path, beta, baseline = arguments
    term_1 = 1.0 / path
    baseline_per_path = baseline * term_1
    cos_beta = np.cos(beta)
    divisor_1 = baseline_per_path * cos_beta - 1.0
    baseline_per_path_squared = baseline_per_path**2
    term_2 = 1.0 / (divisor_1 * divisor_1**2)
    sin_beta = np.sin(beta)
    sin_beta_squared = sin_beta**2
    product_1 = baseline_per_path * baseline_per_path_squared
    sum_1 = 1.0 - 3.0 * baseline_per_path * cos_beta + baseline_per_path_squared + cos_beta * product_1
    sum_2 = 1.0 + baseline_per_path
    sum_3 = baseline_per_path - 1.0
    cos_beta_squared = cos_beta**2
    sum_4 = baseline_per_path * cos_beta_squared - 2.0 * baseline_per_path + cos_beta
    sum_5 = (
        3.0 * baseline_per_path_squared * cos_beta
        - 2.0 * product_1
        - 3.0 * baseline_per_path * cos_beta_squared
        + cos_beta
        + cos_beta_squared * product_1
    )
    sum_6 = 2.0 * baseline_per_path_squared - 1.0 - baseline_per_path * cos_beta
    result = _empty(arguments, (2, 2, 2))
    result[..., 0, 0, 0] = baseline_per_path_squared * cos_beta * sin_beta_squared * term_1 * term_2
    result[..., 0, 0, 1] = 0.5 * sin_beta * sum_1 * term_2
    result[..., 0, 1, 0] = result[..., 0, 0, 1]
    result[..., 0, 1, 1] = -0.5 * path * sum_2 * sum_3 * sum_4 * term_2
    result[..., 1, 0, 0] = baseline_per_path_squared * sin_beta * sin_beta_squared * term_1 * term_2
    result[..., 1, 0, 1] = -0.5 * sum_5 * term_2
    result[..., 1, 1, 0] = result[..., 1, 0, 1]
    result[..., 1, 1, 1] = 0.5 * path * sin_beta * sum_2 * sum_3 * sum_6 * term_2
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

    Accuracy: at most 343 ulp anywhere in this domain with independent errors, proved for elementary functions
    within 1 ulp (float64); in float32, with functions within 4 of its ulp, at most 563.
    """
    arguments = _floats(path, beta, baseline, sigma_path, sigma_beta, rho)
    path, beta, baseline, sigma_path, sigma_beta, rho = arguments
    term_1 = 1.0 / path
    baseline_per_path = baseline * term_1
    sigma_path_per_path = sigma_path * term_1
    cos_beta = np.cos(beta)
    divisor_1 = baseline_per_path * cos_beta - 1.0
    sum_1 = 1.0 + baseline_per_path
    sum_2 = baseline_per_path - 1.0
    cos_beta_squared = cos_beta**2
    sigma_beta_squared = sigma_beta**2
    sum_3 = baseline_per_path * cos_beta_squared - 2.0 * baseline_per_path + cos_beta
    baseline_per_path_squared = baseline_per_path**2
    sigma_path_per_path_squared = sigma_path_per_path**2
    sin_beta = np.sin(beta)
    sin_beta_squared = sin_beta**2
    product_1 = baseline_per_path * baseline_per_path_squared
    sum_4 = 1.0 - 3.0 * baseline_per_path * cos_beta + baseline_per_path_squared + cos_beta * product_1
    term_2 = 1.0 / (divisor_1 * divisor_1**2)
    sum_5 = (
        0.5 * baseline_per_path_squared * cos_beta * sigma_path_per_path_squared * sin_beta_squared
        - 0.25 * sigma_beta_squared * sum_1 * sum_2 * sum_3
        + 0.5 * rho * sigma_beta * sigma_path_per_path * sin_beta * sum_4
    )
    sum_6 = (
        3.0 * baseline_per_path_squared * cos_beta
        - 2.0 * product_1
        - 3.0 * baseline_per_path * cos_beta_squared
        + cos_beta
        + cos_beta_squared * product_1
    )
    sum_7 = 2.0 * baseline_per_path_squared - 1.0 - baseline_per_path * cos_beta
    sum_8 = (
        0.5 * baseline_per_path_squared * sigma_path_per_path_squared * sin_beta * sin_beta_squared
        - 0.5 * rho * sigma_beta * sigma_path_per_path * sum_6
        + 0.25 * sigma_beta_squared * sin_beta * sum_1 * sum_2 * sum_7
    )
    result = _empty(arguments, (2,))
    result[..., 0] = path * sum_5 * term_2
    result[..., 1] = path * sum_8 * term_2
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

    Accuracy: at most 502 ulp anywhere in this domain with independent errors, proved for elementary functions
    within 1 ulp (float64); with correlations up to 0.99 in size at most 58600. Errors are measured against
    the sum of the variances to first order of independent errors.
    """
    arguments = _floats(path, beta, baseline, sigma_path, sigma_beta, rho)
    path, beta, baseline, sigma_path, sigma_beta, rho = arguments
    term_1 = 1.0 / path
    baseline_per_path = baseline * term_1
    sigma_path_per_path = sigma_path * term_1
    cos_beta = np.cos(beta)
    product_1 = -2.0 * baseline_per_path * cos_beta
    divisor_1 = 2.0 + product_1
    sum_1 = 1.0 + baseline_per_path
    sum_1_squared = sum_1**2
    sum_2 = baseline_per_path - 1.0
    sum_2_squared = sum_2**2
    sigma_beta_squared = sigma_beta**2
    sin_beta = np.sin(beta)
    sin_beta_squared = sin_beta**2
    sum_3 = 1.0 + baseline_per_path**2 + product_1
    sum_3_squared = sum_3**2
    cos_beta_squared = cos_beta**2
    sigma_path_per_path_squared = sigma_path_per_path**2
    term_2 = 1.0 / (divisor_1**2)**2
    path_squared = path**2
    sum_4 = (
        4.0 * cos_beta_squared * sigma_path_per_path_squared * sum_3_squared
        + 4.0 * sigma_beta_squared * sin_beta_squared * sum_1_squared * sum_2_squared
        + 8.0 * cos_beta * rho * sigma_beta * sigma_path_per_path * sin_beta * sum_1 * sum_2 * sum_3
    )
    sum_5 = baseline_per_path - cos_beta
    sum_6 = 1.0 - 2.0 * cos_beta_squared + baseline_per_path * cos_beta
    sum_7 = (
        4.0 * cos_beta * sigma_path_per_path_squared * sin_beta * sum_3_squared
        + 4.0 * sigma_beta_squared * sin_beta * sum_1_squared * sum_2_squared * sum_5
        + 4.0 * rho * sigma_beta * sigma_path_per_path * sum_1 * sum_2 * sum_3 * sum_6
    )
    sum_8 = (
        4.0 * sigma_beta_squared * sum_1_squared * sum_2_squared * sum_5**2
        + 4.0 * sigma_path_per_path_squared * sin_beta_squared * sum_3_squared
        + 8.0 * rho * sigma_beta * sigma_path_per_path * sin_beta * sum_1 * sum_2 * sum_3 * sum_5
    )
    result = _empty(arguments, (2, 2))
    result[..., 0, 0] = path_squared * sum_4 * term_2
    result[..., 0, 1] = path_squared * sum_7 * term_2
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = path_squared * sum_8 * term_2
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

    Accuracy: at most 1840 ulp anywhere in this domain with independent errors, proved for elementary
    functions within 1 ulp (float64). Errors are measured against the sum of the variances to first order of
    independent errors.
    """
    arguments = _floats(path, beta, baseline, sigma_path, sigma_beta, rho)
    path, beta, baseline, sigma_path, sigma_beta, rho = arguments
    term_1 = 1.0 / path
    baseline_per_path = baseline * term_1
    sigma_path_per_path = sigma_path * term_1
    cos_beta = np.cos(beta)
    product_1 = -2.0 * baseline_per_path * cos_beta
    divisor_1 = 2.0 + product_1
    product_2 = baseline_per_path * cos_beta
    divisor_2 = product_2 - 1.0
    sum_1 = 1.0 + baseline_per_path
    sum_1_squared = sum_1**2
    sum_2 = baseline_per_path - 1.0
    sum_2_squared = sum_2**2
    baseline_per_path_squared = baseline_per_path**2
    sin_beta = np.sin(beta)
    sin_beta_squared = sin_beta**2
    product_3 = baseline_per_path_squared * sin_beta_squared
    sigma_beta_squared = sigma_beta**2
    sum_3 = 2.0 * baseline_per_path * cos_beta - 1.0 - baseline_per_path_squared + product_3
    baseline_per_path_squared_squared = baseline_per_path_squared**2
    sigma_path_per_path_squared = sigma_path_per_path**2
    sigma_path_per_path_squared_squared = sigma_path_per_path_squared**2
    sin_beta_squared_squared = sin_beta_squared**2
    product_4 = baseline_per_path * baseline_per_path_squared
    product_5 = cos_beta * product_4
    sum_4 = 1.0 - 3.0 * baseline_per_path * cos_beta + baseline_per_path_squared + product_5
    cos_beta_squared = cos_beta**2
    sum_5 = baseline_per_path * cos_beta_squared - 2.0 * baseline_per_path + cos_beta
    product_6 = sigma_beta * sigma_beta_squared
    product_7 = sigma_path_per_path * sigma_path_per_path_squared
    product_8 = sin_beta * sin_beta_squared
    sigma_beta_squared_squared = sigma_beta_squared**2
    sum_6 = 1.0 + baseline_per_path_squared + product_1
    sum_6_squared = sum_6**2
    sum_7 = divisor_2
    sum_7_squared = sum_7**2
    product_9 = baseline_per_path * baseline_per_path_squared**2
    product_10 = cos_beta * cos_beta_squared
    baseline_per_path_squared_cubed = baseline_per_path_squared * baseline_per_path_squared**2
    rho_squared = rho**2
    sum_8 = (
        1.0
        - 2.0 * product_10 * product_9
        - 6.0 * baseline_per_path * cos_beta
        - 8.0 * baseline_per_path_squared_squared * cos_beta_squared
        - 8.0 * cos_beta * product_4
        + 11.0 * baseline_per_path_squared * cos_beta_squared
        + 2.0 * baseline_per_path_squared
        + 2.0 * product_10 * product_4
        + 6.0 * cos_beta * product_9
        + baseline_per_path_squared_cubed * cos_beta_squared
        + baseline_per_path_squared_squared
    )
    term_2 = 1.0 / (divisor_1**2)**2
    term_3 = 1.0 / divisor_2**2
    path_squared = path**2
    sum_9 = (
        16.0 * baseline_per_path_squared * cos_beta * product_7 * product_8 * rho * sigma_beta * sum_4
        - 4.0 * sigma_beta_squared * sin_beta_squared * sum_1_squared * sum_2_squared * sum_3
        - 8.0 * baseline_per_path_squared_squared * sigma_path_per_path_squared_squared * (1.0 + sin_beta) * (sin_beta - 1.0) * sin_beta_squared_squared
        - 8.0 * product_6 * rho * sigma_path_per_path * sin_beta * sum_1 * sum_2 * sum_4 * sum_5
        + 2.0 * sigma_beta_squared_squared * sum_1_squared * sum_2_squared * sum_5**2
        + 4.0 * cos_beta_squared * sigma_path_per_path_squared * sum_6_squared * sum_7_squared
        + 4.0 * rho_squared * sigma_beta_squared * sigma_path_per_path_squared * sin_beta_squared * sum_8
        + 4.0 * sigma_beta_squared * sigma_path_per_path_squared * sin_beta_squared * sum_4**2
        + 8.0 * cos_beta * rho * sigma_beta * sigma_path_per_path * sin_beta * sum_1 * sum_2 * sum_6 * sum_7_squared
    )
    sum_10 = 2.0 * baseline_per_path_squared - 1.0 - baseline_per_path * cos_beta
    cos_beta_squared_squared = cos_beta_squared**2
    sum_11 = (
        11.0 * baseline_per_path_squared * product_10
        - 10.0 * baseline_per_path_squared_squared * product_10
        - 14.0 * cos_beta_squared * product_4
        - 2.0 * cos_beta_squared_squared * product_9
        - 4.0 * baseline_per_path_squared_cubed * cos_beta
        - 4.0 * product_9
        - 6.0 * baseline_per_path * cos_beta_squared
        + 13.0 * baseline_per_path_squared_squared * cos_beta
        + 2.0 * baseline_per_path_squared * cos_beta
        + 2.0 * cos_beta_squared_squared * product_4
        + 3.0 * baseline_per_path_squared_cubed * product_10
        + 8.0 * cos_beta_squared * product_9
        + cos_beta
    )
    sum_12 = (
        3.0 * baseline_per_path_squared * cos_beta
        - 2.0 * product_4
        - 3.0 * baseline_per_path * cos_beta_squared
        + cos_beta
        + cos_beta_squared * product_4
    )
    sum_13 = baseline_per_path - cos_beta
    sum_14 = 1.0 - 2.0 * cos_beta_squared + product_2
    sum_15 = (
        1.0
        - 12.0 * cos_beta * product_4 * sin_beta_squared
        - 2.0 * sin_beta_squared
        - 4.0 * baseline_per_path * cos_beta
        - 4.0 * cos_beta * product_4
        - 6.0 * baseline_per_path_squared * sin_beta_squared_squared
        + 2.0 * baseline_per_path_squared_squared * sin_beta_squared_squared
        + 2.0 * cos_beta * product_9 * sin_beta_squared
        + 3.0 * baseline_per_path_squared_squared * sin_beta_squared
        + 4.0 * baseline_per_path * cos_beta * sin_beta_squared
        + 6.0 * baseline_per_path_squared
        + baseline_per_path_squared_squared
        + product_3
    )
    sum_16 = (
        2.0 * cos_beta * product_4 * sin_beta_squared
        - 1.0
        - 3.0 * baseline_per_path_squared
        - 6.0 * baseline_per_path * cos_beta * sin_beta_squared
        + 2.0 * sin_beta_squared
        + 3.0 * baseline_per_path * cos_beta
        + 4.0 * baseline_per_path_squared * sin_beta_squared
        + product_5
    )
    sum_17 = (
        4.0 * cos_beta * sigma_path_per_path_squared * sin_beta * sum_6_squared * sum_7_squared
        - 2.0 * sigma_beta_squared_squared * sin_beta * sum_10 * sum_1_squared * sum_2_squared * sum_5
        - 4.0 * rho_squared * sigma_beta_squared * sigma_path_per_path_squared * sin_beta * sum_11
        - 4.0 * sigma_beta_squared * sigma_path_per_path_squared * sin_beta * sum_12 * sum_4
        + 4.0 * product_6 * rho * sigma_path_per_path * sum_1 * sum_15 * sum_2
        + 4.0 * sigma_beta_squared * sin_beta * sum_13 * sum_1_squared * sum_2_squared * sum_7_squared
        + 4.0 * rho * sigma_beta * sigma_path_per_path * sum_1 * sum_14 * sum_2 * sum_6 * sum_7_squared
        + 8.0 * baseline_per_path_squared * product_7 * rho * sigma_beta * sin_beta_squared * sum_16
        + 8.0 * baseline_per_path_squared_squared * cos_beta * sigma_path_per_path_squared_squared * sin_beta * sin_beta_squared**2
    )
    product_11 = cos_beta * cos_beta_squared**2
    sum_18 = (
        10.0 * product_10 * product_9
        - 12.0 * baseline_per_path_squared_cubed * cos_beta_squared
        - 12.0 * baseline_per_path_squared_squared * cos_beta_squared_squared
        - 14.0 * cos_beta * product_9
        - 2.0 * cos_beta * product_4
        - 2.0 * product_11 * product_9
        - 20.0 * product_10 * product_4
        - 6.0 * baseline_per_path * product_10
        - 6.0 * baseline_per_path_squared_squared
        + 11.0 * baseline_per_path_squared * cos_beta_squared_squared
        + 2.0 * baseline_per_path_squared
        + 2.0 * baseline_per_path_squared * cos_beta_squared
        + 2.0 * product_11 * product_4
        + 33.0 * baseline_per_path_squared_squared * cos_beta_squared
        + 5.0 * baseline_per_path_squared_cubed * cos_beta_squared_squared
        + 8.0 * baseline_per_path_squared_cubed
        + cos_beta_squared
    )
    sum_19 = (
        2.0 * sigma_beta_squared_squared * sin_beta_squared * sum_10**2 * sum_1_squared * sum_2_squared
        - 16.0 * baseline_per_path_squared * product_7 * product_8 * rho * sigma_beta * sum_12
        - 8.0 * product_6 * rho * sigma_path_per_path * sin_beta * sum_1 * sum_10 * sum_12 * sum_2
        + 4.0 * rho_squared * sigma_beta_squared * sigma_path_per_path_squared * sum_18
        + 4.0 * sigma_beta_squared * sigma_path_per_path_squared * sum_12**2
        + 4.0 * sigma_beta_squared * sum_13**2 * sum_1_squared * sum_2_squared * sum_7_squared
        + 4.0 * sigma_path_per_path_squared * sin_beta_squared * sum_6_squared * sum_7_squared
        + 8.0 * baseline_per_path_squared_squared * sigma_path_per_path_squared_squared * sin_beta_squared * sin_beta_squared**2
        + 8.0 * rho * sigma_beta * sigma_path_per_path * sin_beta * sum_1 * sum_13 * sum_2 * sum_6 * sum_7_squared
    )
    result = _empty(arguments, (2, 2))
    result[..., 0, 0] = path_squared * sum_9 * term_2 * term_3
    result[..., 0, 1] = path_squared * sum_17 * term_2 * term_3
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = path_squared * sum_19 * term_2 * term_3
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

    Accuracy: measured, not proved: at most 5 ulp from 50-digit arithmetic at 500 points of this domain
    (float64, independent errors).
    """
    arguments = _floats(path, beta, baseline, sigma_path, sigma_beta, rho)
    path, beta, baseline, sigma_path, sigma_beta, rho = arguments
    term_1 = 1.0 / path
    baseline_per_path = baseline * term_1
    sigma_path_per_path = sigma_path * term_1
    cos_beta = np.cos(beta)
    product_1 = -2.0 * baseline_per_path * cos_beta
    divisor_1 = 2.0 + product_1
    term_2 = 1.0 / divisor_1**2
    sum_1 = 1.0 + baseline_per_path
    sum_1_squared = sum_1**2
    sum_2 = baseline_per_path - 1.0
    sum_2_squared = sum_2**2
    sigma_beta_squared = sigma_beta**2
    sin_beta = np.sin(beta)
    sin_beta_squared = sin_beta**2
    sum_3 = 1.0 + baseline_per_path**2 + product_1
    sum_3_squared = sum_3**2
    sigma_path_per_path_squared = sigma_path_per_path**2
    sum_4 = baseline_per_path - cos_beta
    result = _empty(arguments, (2,))
    result[..., 0] = path * np.sqrt(4.0 * cos_beta**2 * sigma_path_per_path_squared * sum_3_squared + 4.0 * sigma_beta_squared * sin_beta_squared * sum_1_squared * sum_2_squared + 8.0 * cos_beta * rho * sigma_beta * sigma_path_per_path * sin_beta * sum_1 * sum_2 * sum_3) * term_2
    result[..., 1] = path * np.sqrt(4.0 * sigma_beta_squared * sum_1_squared * sum_2_squared * sum_4**2 + 4.0 * sigma_path_per_path_squared * sin_beta_squared * sum_3_squared + 8.0 * rho * sigma_beta * sigma_path_per_path * sin_beta * sum_1 * sum_2 * sum_3 * sum_4) * term_2
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

    Accuracy: at most 254 ulp anywhere in this domain with independent errors, proved for elementary functions
    within 1 ulp (float64).
    """
    arguments = _floats(path, beta, baseline, sigma_path, sigma_beta, rho)
    path, beta, baseline, sigma_path, sigma_beta, rho = arguments
    term_1 = 1.0 / path
    baseline_per_path = baseline * term_1
    sigma_path_per_path = sigma_path * term_1
    cos_beta = np.cos(beta)
    product_1 = -2.0 * baseline_per_path * cos_beta
    divisor_1 = 2.0 + product_1
    sum_1 = 1.0 + baseline_per_path
    sum_1_squared = sum_1**2
    sum_2 = baseline_per_path - 1.0
    sum_2_squared = sum_2**2
    sigma_beta_squared = sigma_beta**2
    sin_beta = np.sin(beta)
    sin_beta_squared = sin_beta**2
    sum_3 = 1.0 + baseline_per_path**2 + product_1
    sum_3_squared = sum_3**2
    sigma_path_per_path_squared = sigma_path_per_path**2
    term_2 = 1.0 / (divisor_1**2)**2
    sum_4 = (
        4.0 * cos_beta**2 * sigma_path_per_path_squared * sum_3_squared
        + 4.0 * sigma_beta_squared * sin_beta_squared * sum_1_squared * sum_2_squared
        + 8.0 * cos_beta * rho * sigma_beta * sigma_path_per_path * sin_beta * sum_1 * sum_2 * sum_3
    )
    sum_5 = baseline_per_path - cos_beta
    sum_6 = (
        4.0 * sigma_beta_squared * sum_1_squared * sum_2_squared * sum_5**2
        + 4.0 * sigma_path_per_path_squared * sin_beta_squared * sum_3_squared
        + 8.0 * rho * sigma_beta * sigma_path_per_path * sin_beta * sum_1 * sum_2 * sum_3 * sum_5
    )
    result = _empty(arguments, ())
    result[...] = path * np.sqrt(0.5 * sum_4 * term_2 + 0.5 * sum_6 * term_2)
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

    Accuracy: at most 668 ulp anywhere in this domain with independent errors, proved for elementary functions
    within 1 ulp (float64).
    """
    arguments = _floats(path, beta, baseline, sigma_path, sigma_beta, rho)
    path, beta, baseline, sigma_path, sigma_beta, rho = arguments
    term_1 = 1.0 / path
    baseline_per_path = baseline * term_1
    sigma_path_per_path = sigma_path * term_1
    cos_beta = np.cos(beta)
    product_1 = -2.0 * baseline_per_path * cos_beta
    divisor_1 = 2.0 + product_1
    complement_of_rho = np.sqrt((1.0 - rho) * (1.0 + rho))
    baseline_per_path_squared = baseline_per_path**2
    sum_1 = 1.0 + baseline_per_path_squared + product_1
    term_2 = 1.0 / divisor_1
    sigma_path_per_path_squared = sigma_path_per_path**2
    sin_beta = np.sin(beta)
    product_2 = -2.0 * baseline_per_path_squared * sigma_path_per_path_squared * sin_beta**2 * term_2
    sum_2 = 1.0 + baseline_per_path
    sum_3 = baseline_per_path - 1.0
    product_3 = -2.0 * baseline_per_path * rho * sigma_beta * sigma_path_per_path * sin_beta * sum_2 * sum_3 * term_2
    complement_of_rho_squared = complement_of_rho**2
    sigma_beta_squared = sigma_beta**2
    product_4 = 0.5 * rho**2 * sigma_beta_squared * sum_2 * sum_3
    sum_1_squared = sum_1**2
    result = _empty(arguments, (2,))
    result[..., 0] = np.sqrt((0.5 * complement_of_rho_squared * sigma_beta_squared * sum_2 * sum_3 + product_2 + product_3 + product_4)**2 + 2.0 * (product_2 + product_3 + product_4)**2 + 0.5 * complement_of_rho_squared**2 * sigma_beta_squared**2 * sum_2**2 * sum_3**2 + (rho * sigma_beta * sum_2 * sum_3 - 2.0 * baseline_per_path * sigma_path_per_path * sin_beta * sum_2 * sum_3 * term_2)**2 * complement_of_rho_squared * sigma_beta_squared) / (np.abs(sum_1) * sigma_path_per_path)
    result[..., 1] = np.sqrt(3.0 * (-2.0 * baseline_per_path * sigma_beta * sin_beta * sum_1 * sum_2 * sum_3 * term_2 - 2.0 * rho * sigma_path_per_path * sum_1_squared * term_2)**2 * sigma_beta_squared + 4.0 * complement_of_rho_squared * sigma_beta_squared * sigma_path_per_path_squared * sum_1_squared**2 / divisor_1**2) / (np.abs(1.0 - 2.0 * baseline_per_path * cos_beta - baseline_per_path_squared**2 + 2.0 * baseline_per_path * baseline_per_path_squared * cos_beta) * sigma_beta)
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

    Accuracy: measured, not proved: at most 5 ulp from 50-digit arithmetic at 500 points of this domain
    (float64, independent errors).
    """
    arguments = _floats(path, beta, baseline, sigma_path, sigma_beta, rho)
    path, beta, baseline, sigma_path, sigma_beta, rho = arguments
    term_1 = 1.0 / path
    baseline_per_path = baseline * term_1
    sigma_path_per_path = sigma_path * term_1
    cos_beta = np.cos(beta)
    product_1 = -2.0 * baseline_per_path * cos_beta
    divisor_1 = 2.0 + product_1
    complement_of_rho = np.sqrt((1.0 - rho) * (1.0 + rho))
    baseline_per_path_squared = baseline_per_path**2
    sum_1 = 1.0 + baseline_per_path_squared + product_1
    baseline_per_path_squared_squared = baseline_per_path_squared**2
    cos_beta_squared = cos_beta**2
    sum_2 = (
        1.0
        - 2.0 * baseline_per_path_squared_squared
        - 4.0 * baseline_per_path * cos_beta
        + 3.0 * baseline_per_path_squared
        + baseline_per_path_squared * cos_beta_squared
        + baseline_per_path_squared_squared * cos_beta_squared
    )
    complement_of_rho_squared = complement_of_rho**2
    term_2 = 1.0 / divisor_1**2
    sigma_beta_squared = sigma_beta**2
    term_3 = 1.0 / divisor_1
    sum_3 = 1.0 + baseline_per_path
    sum_4 = baseline_per_path - 1.0
    product_2 = sigma_beta * sigma_beta_squared
    sin_beta = np.sin(beta)
    rho_squared = rho**2
    product_3 = rho * rho_squared
    sigma_path_per_path_squared = sigma_path_per_path**2
    product_4 = sigma_path_per_path * sigma_path_per_path_squared
    sin_beta_squared = sin_beta**2
    sum_5 = baseline_per_path - cos_beta
    product_5 = -3.0 * baseline_per_path * rho_squared * sigma_beta_squared * sin_beta * sum_3 * sum_4 * term_3
    product_6 = -4.0 * rho * sigma_beta * sigma_path_per_path * sum_2 * term_2
    product_7 = 8.0 * baseline_per_path_squared * sigma_path_per_path_squared * sin_beta * sum_5 * term_2
    complement_of_rho_squared_squared = complement_of_rho_squared**2
    sum_6 = (
        1.0
        - 6.0 * baseline_per_path_squared
        + 4.0 * baseline_per_path_squared * cos_beta_squared
        + baseline_per_path * cos_beta
    )
    result = _empty(arguments, (2,))
    result[..., 0] = np.sqrt((12.0 * baseline_per_path_squared * product_4 * sin_beta_squared * term_2 - 2.0 * complement_of_rho_squared * sigma_beta_squared * sigma_path_per_path * sum_2 * term_2 - 3.0 * baseline_per_path * complement_of_rho_squared * product_2 * rho * sin_beta * sum_3 * sum_4 * term_3 - 3.0 * baseline_per_path * product_2 * product_3 * sin_beta * sum_3 * sum_4 * term_3 - 6.0 * rho_squared * sigma_beta_squared * sigma_path_per_path * sum_2 * term_2 + 24.0 * baseline_per_path_squared * rho * sigma_beta * sigma_path_per_path_squared * sin_beta * sum_5 * term_2)**2 + 2.0 * (product_5 + product_6 + product_7)**2 * complement_of_rho_squared * sigma_beta_squared + 2.0 * (-2.0 * sigma_path_per_path * sum_2 * term_2 - 3.0 * baseline_per_path * rho * sigma_beta * sin_beta * sum_3 * sum_4 * term_3)**2 * complement_of_rho_squared_squared * sigma_beta_squared**2 + 6.0 * (4.0 * baseline_per_path_squared * product_4 * sin_beta_squared * term_2 - 2.0 * rho_squared * sigma_beta_squared * sigma_path_per_path * sum_2 * term_2 - baseline_per_path * product_2 * product_3 * sin_beta * sum_3 * sum_4 * term_3 + 8.0 * baseline_per_path_squared * rho * sigma_beta * sigma_path_per_path_squared * sin_beta * sum_5 * term_2)**2 + 6.0 * baseline_per_path_squared * complement_of_rho_squared * complement_of_rho_squared**2 * sigma_beta_squared * sigma_beta_squared**2 * sin_beta_squared * sum_3**2 * sum_4**2 * term_2 + (product_5 - 3.0 * baseline_per_path * complement_of_rho_squared * sigma_beta_squared * sin_beta * sum_3 * sum_4 * term_3 + product_6 + product_7)**2 * complement_of_rho_squared * sigma_beta_squared) / (np.abs(sum_1) * sigma_path_per_path)
    result[..., 1] = np.sqrt(3.0 * (8.0 * baseline_per_path_squared * rho * sigma_path_per_path * sin_beta_squared * sum_1 * term_2 + 8.0 * baseline_per_path_squared * sigma_beta * sin_beta * sum_1 * sum_5 * term_2)**2 * complement_of_rho_squared * sigma_beta_squared * sigma_path_per_path_squared + 32.0 * baseline_per_path_squared_squared * complement_of_rho_squared_squared * sigma_beta_squared * sigma_path_per_path_squared**2 * sin_beta_squared**2 * sum_1**2 / (divisor_1**2)**2 + 6.0 * (4.0 * baseline_per_path_squared * rho_squared * sigma_path_per_path_squared * sin_beta_squared * sum_1 * term_2 - 2.0 * sigma_beta_squared * sum_1 * sum_3 * sum_4 * sum_6 * term_2 / 3.0 + 8.0 * baseline_per_path_squared * rho * sigma_beta * sigma_path_per_path * sin_beta * sum_1 * sum_5 * term_2)**2 * sigma_beta_squared + (12.0 * baseline_per_path_squared * rho_squared * sigma_path_per_path_squared * sin_beta_squared * sum_1 * term_2 - 2.0 * sigma_beta_squared * sum_1 * sum_3 * sum_4 * sum_6 * term_2 + 24.0 * baseline_per_path_squared * rho * sigma_beta * sigma_path_per_path * sin_beta * sum_1 * sum_5 * term_2 + 4.0 * baseline_per_path_squared * complement_of_rho_squared * sigma_path_per_path_squared * sin_beta_squared * sum_1 * term_2)**2 * sigma_beta_squared) / (np.abs(1.0 - 2.0 * baseline_per_path * cos_beta - baseline_per_path_squared_squared + 2.0 * baseline_per_path * baseline_per_path_squared * cos_beta) * sigma_beta)
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

    Accuracy: at most 343 ulp anywhere in this domain with independent errors, proved for elementary functions
    within 1 ulp (float64).
    """
    arguments = _floats(path, beta, baseline, sigma_path, sigma_beta, rho)
    path, beta, baseline, sigma_path, sigma_beta, rho = arguments
    term_1 = 1.0 / path
    baseline_per_path = baseline * term_1
    sigma_path_per_path = sigma_path * term_1
    cos_beta = np.cos(beta)
    divisor_1 = 2.0 - 2.0 * baseline_per_path * cos_beta
    baseline_per_path_squared = baseline_per_path**2
    sigma_path_per_path_squared = sigma_path_per_path**2
    sin_beta = np.sin(beta)
    sin_beta_squared = sin_beta**2
    product_1 = baseline_per_path * baseline_per_path_squared
    sum_1 = 1.0 - 3.0 * baseline_per_path * cos_beta + baseline_per_path_squared + cos_beta * product_1
    sum_2 = 1.0 + baseline_per_path
    sum_3 = baseline_per_path - 1.0
    cos_beta_squared = cos_beta**2
    sigma_beta_squared = sigma_beta**2
    sum_4 = baseline_per_path * cos_beta_squared - 2.0 * baseline_per_path + cos_beta
    term_2 = 1.0 / (divisor_1 * divisor_1**2)
    sum_5 = (
        2.0 * sigma_beta_squared * sum_2 * sum_3 * sum_4
        - 4.0 * baseline_per_path_squared * cos_beta * sigma_path_per_path_squared * sin_beta_squared
        - 4.0 * rho * sigma_beta * sigma_path_per_path * sin_beta * sum_1
    )
    sum_6 = 2.0 * baseline_per_path_squared - 1.0 - baseline_per_path * cos_beta
    sum_7 = (
        3.0 * baseline_per_path_squared * cos_beta
        - 2.0 * product_1
        - 3.0 * baseline_per_path * cos_beta_squared
        + cos_beta
        + cos_beta_squared * product_1
    )
    sum_8 = (
        4.0 * rho * sigma_beta * sigma_path_per_path * sum_7
        - 2.0 * sigma_beta_squared * sin_beta * sum_2 * sum_3 * sum_6
        - 4.0 * baseline_per_path_squared * sigma_path_per_path_squared * sin_beta * sin_beta_squared
    )
    result = _empty(arguments, (2,))
    result[..., 0] = path * sum_5 * term_2
    result[..., 1] = path * sum_8 * term_2
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

    Accuracy: measured, not proved: at most 7 ulp from 50-digit arithmetic at 500 points of this domain
    (float64, independent errors).
    """
    arguments = _floats(path, beta, baseline, sigma_path, sigma_beta, rho)
    path, beta, baseline, sigma_path, sigma_beta, rho = arguments
    term_1 = 1.0 / path
    baseline_per_path = baseline * term_1
    sigma_path_per_path = sigma_path * term_1
    cos_beta = np.cos(beta)
    divisor_1 = 2.0 - 2.0 * baseline_per_path * cos_beta
    term_2 = (baseline_per_path * cos_beta - 1.0)**2
    baseline_per_path_squared = baseline_per_path**2
    sigma_path_per_path_squared = sigma_path_per_path**2
    sin_beta = np.sin(beta)
    sin_beta_squared = sin_beta**2
    product_1 = -3.0 * baseline_per_path * cos_beta
    product_2 = baseline_per_path * baseline_per_path_squared
    sum_1 = 1.0 + baseline_per_path_squared + cos_beta * product_2 + product_1
    sum_2 = 1.0 + baseline_per_path
    sum_3 = baseline_per_path - 1.0
    cos_beta_squared = cos_beta**2
    product_3 = cos_beta * cos_beta_squared
    cos_beta_squared_squared = cos_beta_squared**2
    sigma_beta_squared = sigma_beta**2
    sigma_beta_squared_squared = sigma_beta_squared**2
    sum_4 = (
        11.0 * baseline_per_path * cos_beta_squared
        - 20.0 * baseline_per_path_squared * cos_beta
        - 20.0 * cos_beta_squared * product_2
        - 8.0 * baseline_per_path
        + 11.0 * baseline_per_path_squared * product_3
        + 24.0 * product_2
        + cos_beta
        + cos_beta_squared_squared * product_2
    )
    sigma_path_per_path_squared_squared = sigma_path_per_path_squared**2
    sum_5 = (
        13.0 * baseline_per_path * cos_beta_squared
        - 3.0 * baseline_per_path * cos_beta_squared_squared
        - 6.0 * baseline_per_path
        - 6.0 * baseline_per_path_squared * cos_beta
        - 9.0 * product_3
        + 4.0 * baseline_per_path_squared * product_3
        + 7.0 * cos_beta
    )
    rho_squared = rho**2
    product_4 = sigma_path_per_path * sigma_path_per_path_squared
    sum_6 = 3.0 * cos_beta_squared - 1.0 + baseline_per_path * product_3 + product_1
    sum_7 = baseline_per_path * cos_beta_squared - 2.0 * baseline_per_path + cos_beta
    baseline_per_path_squared_squared = baseline_per_path_squared**2
    product_5 = baseline_per_path * baseline_per_path_squared**2
    product_6 = sigma_beta * sigma_beta_squared
    sum_8 = (
        1.0
        - 17.0 * baseline_per_path_squared * cos_beta_squared
        - 18.0 * baseline_per_path_squared_squared
        - 3.0 * product_2 * product_3
        - 5.0 * baseline_per_path * cos_beta
        - 6.0 * cos_beta * product_5
        + 11.0 * baseline_per_path_squared_squared * cos_beta_squared
        + 29.0 * cos_beta * product_2
        + 7.0 * baseline_per_path_squared
        + product_3 * product_5
    )
    term_3 = 1.0 / (divisor_1 * (divisor_1**2)**2)
    sum_9 = (
        16.0 * baseline_per_path_squared * rho_squared * sigma_beta_squared * sigma_path_per_path_squared * sum_5
        - 16.0 * baseline_per_path_squared * cos_beta * sigma_path_per_path_squared * sin_beta_squared * term_2
        - 16.0 * rho * sigma_beta * sigma_path_per_path * sin_beta * sum_1 * term_2
        - 2.0 * sigma_beta_squared_squared * sum_2 * sum_3 * sum_4
        - 48.0 * baseline_per_path_squared * cos_beta * sigma_path_per_path_squared_squared * sin_beta_squared
        + 48.0 * baseline_per_path_squared * product_4 * rho * sigma_beta * sin_beta * sum_6
        + 8.0 * baseline_per_path_squared * sigma_beta_squared * sigma_path_per_path_squared * sum_5
        + 8.0 * product_6 * rho * sigma_path_per_path * sin_beta * sum_8
        + 8.0 * sigma_beta_squared * sum_2 * sum_3 * sum_7 * term_2
    )
    sum_10 = 3.0 * baseline_per_path - 3.0 * cos_beta + baseline_per_path * sin_beta_squared
    product_7 = sin_beta * sin_beta_squared
    sum_11 = 2.0 * baseline_per_path_squared - 1.0 - baseline_per_path * cos_beta
    sum_12 = (
        19.0 * baseline_per_path_squared_squared * product_3
        - 17.0 * baseline_per_path_squared * product_3
        - 20.0 * cos_beta_squared * product_5
        - 20.0 * product_2
        - 3.0 * cos_beta_squared_squared * product_2
        - 32.0 * baseline_per_path_squared_squared * cos_beta
        - 5.0 * baseline_per_path * cos_beta_squared
        + 21.0 * baseline_per_path_squared * cos_beta
        + 24.0 * product_5
        + 31.0 * cos_beta_squared * product_2
        + cos_beta
        + cos_beta_squared_squared * product_5
    )
    sum_13 = (
        2.0 * baseline_per_path * cos_beta
        - 1.0
        - baseline_per_path_squared
        + baseline_per_path_squared * sin_beta_squared
    )
    sum_14 = (
        3.0 * baseline_per_path_squared * cos_beta
        - 2.0 * product_2
        - 3.0 * baseline_per_path * cos_beta_squared
        + cos_beta
        + cos_beta_squared * product_2
    )
    sum_15 = (
        20.0 * baseline_per_path_squared
        - 1.0
        - 11.0 * baseline_per_path * cos_beta
        - 11.0 * baseline_per_path_squared * cos_beta_squared
        - 24.0 * baseline_per_path_squared_squared
        - product_2 * product_3
        + 20.0 * cos_beta * product_2
        + 8.0 * baseline_per_path_squared_squared * cos_beta_squared
    )
    sum_16 = (
        1.0
        - 3.0 * cos_beta_squared
        - 4.0 * baseline_per_path_squared
        - baseline_per_path * product_3
        + 2.0 * baseline_per_path_squared * cos_beta_squared
        + 5.0 * baseline_per_path * cos_beta
    )
    sum_17 = (
        16.0 * baseline_per_path_squared * product_7 * sigma_path_per_path_squared * sum_13
        - 48.0 * baseline_per_path_squared * product_4 * rho * sigma_beta * sin_beta_squared * sum_10
        - 48.0 * baseline_per_path_squared * product_7 * sigma_path_per_path_squared_squared
        - 8.0 * product_6 * rho * sigma_path_per_path * sum_12
        - 8.0 * sigma_beta_squared * sin_beta * sum_11 * sum_2 * sum_3 * term_2
        + 16.0 * rho * sigma_beta * sigma_path_per_path * sum_14 * term_2
        + 2.0 * sigma_beta_squared_squared * sin_beta * sum_15 * sum_2 * sum_3
        + 24.0 * baseline_per_path_squared * sigma_beta_squared * sigma_path_per_path_squared * sin_beta * sum_16
        + 48.0 * baseline_per_path_squared * rho_squared * sigma_beta_squared * sigma_path_per_path_squared * sin_beta * sum_16
    )
    result = _empty(arguments, (2,))
    result[..., 0] = path * sum_9 * term_3
    result[..., 1] = path * sum_17 * term_3
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

    Accuracy: at most 343 ulp anywhere in this domain with independent errors, proved for elementary functions
    within 1 ulp (float64).
    """
    arguments = _floats(path, beta, baseline, sigma_path, sigma_beta, rho)
    path, beta, baseline, sigma_path, sigma_beta, rho = arguments
    term_1 = 1.0 / path
    baseline_per_path = baseline * term_1
    sigma_path_per_path = sigma_path * term_1
    cos_beta = np.cos(beta)
    divisor_1 = 2.0 - 2.0 * baseline_per_path * cos_beta
    baseline_per_path_squared = baseline_per_path**2
    sigma_path_per_path_squared = sigma_path_per_path**2
    sin_beta = np.sin(beta)
    sin_beta_squared = sin_beta**2
    product_1 = baseline_per_path * baseline_per_path_squared
    sum_1 = 1.0 - 3.0 * baseline_per_path * cos_beta + baseline_per_path_squared + cos_beta * product_1
    sum_2 = 1.0 + baseline_per_path
    sum_3 = baseline_per_path - 1.0
    cos_beta_squared = cos_beta**2
    sigma_beta_squared = sigma_beta**2
    sum_4 = baseline_per_path * cos_beta_squared - 2.0 * baseline_per_path + cos_beta
    term_2 = 1.0 / (divisor_1 * divisor_1**2)
    sum_5 = (
        2.0 * sigma_beta_squared * sum_2 * sum_3 * sum_4
        - 4.0 * baseline_per_path_squared * cos_beta * sigma_path_per_path_squared * sin_beta_squared
        - 4.0 * rho * sigma_beta * sigma_path_per_path * sin_beta * sum_1
    )
    sum_6 = 2.0 * baseline_per_path_squared - 1.0 - baseline_per_path * cos_beta
    sum_7 = (
        3.0 * baseline_per_path_squared * cos_beta
        - 2.0 * product_1
        - 3.0 * baseline_per_path * cos_beta_squared
        + cos_beta
        + cos_beta_squared * product_1
    )
    sum_8 = (
        4.0 * rho * sigma_beta * sigma_path_per_path * sum_7
        - 2.0 * sigma_beta_squared * sin_beta * sum_2 * sum_3 * sum_6
        - 4.0 * baseline_per_path_squared * sigma_path_per_path_squared * sin_beta * sin_beta_squared
    )
    result = _empty(arguments, (2,))
    result[..., 0] = path * sum_5 * term_2
    result[..., 1] = path * sum_8 * term_2
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

    Accuracy: measured, not proved: at most 7.5 ulp from 50-digit arithmetic at 500 points of this domain
    (float64, independent errors).
    """
    arguments = _floats(path, beta, baseline, sigma_path, sigma_beta, rho)
    path, beta, baseline, sigma_path, sigma_beta, rho = arguments
    term_1 = 1.0 / path
    baseline_per_path = baseline * term_1
    sigma_path_per_path = sigma_path * term_1
    cos_beta = np.cos(beta)
    divisor_1 = 2.0 - 2.0 * baseline_per_path * cos_beta
    baseline_per_path_squared = baseline_per_path**2
    sigma_path_per_path_squared = sigma_path_per_path**2
    sigma_path_per_path_squared_squared = sigma_path_per_path_squared**2
    sin_beta = np.sin(beta)
    sin_beta_squared = sin_beta**2
    term_2 = (baseline_per_path * cos_beta - 1.0)**2
    product_1 = -3.0 * baseline_per_path * cos_beta
    product_2 = baseline_per_path * baseline_per_path_squared
    sum_1 = 1.0 + baseline_per_path_squared + cos_beta * product_2 + product_1
    sum_2 = 1.0 + baseline_per_path
    sum_3 = baseline_per_path - 1.0
    cos_beta_squared = cos_beta**2
    product_3 = cos_beta * cos_beta_squared
    cos_beta_squared_squared = cos_beta_squared**2
    sigma_beta_squared = sigma_beta**2
    sigma_beta_squared_squared = sigma_beta_squared**2
    sum_4 = (
        11.0 * baseline_per_path * cos_beta_squared
        - 20.0 * baseline_per_path_squared * cos_beta
        - 20.0 * cos_beta_squared * product_2
        - 8.0 * baseline_per_path
        + 11.0 * baseline_per_path_squared * product_3
        + 24.0 * product_2
        + cos_beta
        + cos_beta_squared_squared * product_2
    )
    product_4 = sigma_path_per_path * sigma_path_per_path_squared
    sum_5 = 3.0 * cos_beta_squared - 1.0 + baseline_per_path * product_3 + product_1
    sum_6 = (
        13.0 * baseline_per_path * cos_beta_squared
        - 3.0 * baseline_per_path * cos_beta_squared_squared
        - 6.0 * baseline_per_path
        - 6.0 * baseline_per_path_squared * cos_beta
        - 9.0 * product_3
        + 4.0 * baseline_per_path_squared * product_3
        + 7.0 * cos_beta
    )
    baseline_per_path_squared_squared = baseline_per_path_squared**2
    product_5 = baseline_per_path * baseline_per_path_squared**2
    product_6 = sigma_beta * sigma_beta_squared
    sum_7 = (
        1.0
        - 17.0 * baseline_per_path_squared * cos_beta_squared
        - 18.0 * baseline_per_path_squared_squared
        - 3.0 * product_2 * product_3
        - 5.0 * baseline_per_path * cos_beta
        - 6.0 * cos_beta * product_5
        + 11.0 * baseline_per_path_squared_squared * cos_beta_squared
        + 29.0 * cos_beta * product_2
        + 7.0 * baseline_per_path_squared
        + product_3 * product_5
    )
    rho_squared = rho**2
    sum_8 = baseline_per_path * cos_beta_squared - 2.0 * baseline_per_path + cos_beta
    term_3 = 1.0 / (divisor_1 * (divisor_1**2)**2)
    sum_9 = (
        144.0 * baseline_per_path_squared * product_4 * rho * sigma_beta * sin_beta * sum_5
        - 144.0 * baseline_per_path_squared * cos_beta * sigma_path_per_path_squared_squared * sin_beta_squared
        - 16.0 * baseline_per_path_squared * cos_beta * sigma_path_per_path_squared * sin_beta_squared * term_2
        - 16.0 * rho * sigma_beta * sigma_path_per_path * sin_beta * sum_1 * term_2
        - 6.0 * sigma_beta_squared_squared * sum_2 * sum_3 * sum_4
        + 24.0 * baseline_per_path_squared * sigma_beta_squared * sigma_path_per_path_squared * sum_6
        + 24.0 * product_6 * rho * sigma_path_per_path * sin_beta * sum_7
        + 48.0 * baseline_per_path_squared * rho_squared * sigma_beta_squared * sigma_path_per_path_squared * sum_6
        + 8.0 * sigma_beta_squared * sum_2 * sum_3 * sum_8 * term_2
    )
    sum_10 = 3.0 * baseline_per_path - 3.0 * cos_beta + baseline_per_path * sin_beta_squared
    product_7 = sin_beta * sin_beta_squared
    sum_11 = (
        19.0 * baseline_per_path_squared_squared * product_3
        - 17.0 * baseline_per_path_squared * product_3
        - 20.0 * cos_beta_squared * product_5
        - 20.0 * product_2
        - 3.0 * cos_beta_squared_squared * product_2
        - 32.0 * baseline_per_path_squared_squared * cos_beta
        - 5.0 * baseline_per_path * cos_beta_squared
        + 21.0 * baseline_per_path_squared * cos_beta
        + 24.0 * product_5
        + 31.0 * cos_beta_squared * product_2
        + cos_beta
        + cos_beta_squared_squared * product_5
    )
    sum_12 = 2.0 * baseline_per_path_squared - 1.0 - baseline_per_path * cos_beta
    sum_13 = (
        1.0
        - 3.0 * cos_beta_squared
        - 4.0 * baseline_per_path_squared
        - baseline_per_path * product_3
        + 2.0 * baseline_per_path_squared * cos_beta_squared
        + 5.0 * baseline_per_path * cos_beta
    )
    sum_14 = (
        2.0 * baseline_per_path * cos_beta
        - 1.0
        - baseline_per_path_squared
        + baseline_per_path_squared * sin_beta_squared
    )
    sum_15 = (
        3.0 * baseline_per_path_squared * cos_beta
        - 2.0 * product_2
        - 3.0 * baseline_per_path * cos_beta_squared
        + cos_beta
        + cos_beta_squared * product_2
    )
    sum_16 = (
        20.0 * baseline_per_path_squared
        - 1.0
        - 11.0 * baseline_per_path * cos_beta
        - 11.0 * baseline_per_path_squared * cos_beta_squared
        - 24.0 * baseline_per_path_squared_squared
        - product_2 * product_3
        + 20.0 * cos_beta * product_2
        + 8.0 * baseline_per_path_squared_squared * cos_beta_squared
    )
    sum_17 = (
        144.0 * baseline_per_path_squared * rho_squared * sigma_beta_squared * sigma_path_per_path_squared * sin_beta * sum_13
        - 144.0 * baseline_per_path_squared * product_4 * rho * sigma_beta * sin_beta_squared * sum_10
        - 144.0 * baseline_per_path_squared * product_7 * sigma_path_per_path_squared_squared
        - 24.0 * product_6 * rho * sigma_path_per_path * sum_11
        - 8.0 * sigma_beta_squared * sin_beta * sum_12 * sum_2 * sum_3 * term_2
        + 16.0 * baseline_per_path_squared * product_7 * sigma_path_per_path_squared * sum_14
        + 16.0 * rho * sigma_beta * sigma_path_per_path * sum_15 * term_2
        + 6.0 * sigma_beta_squared_squared * sin_beta * sum_16 * sum_2 * sum_3
        + 72.0 * baseline_per_path_squared * sigma_beta_squared * sigma_path_per_path_squared * sin_beta * sum_13
    )
    result = _empty(arguments, (2,))
    result[..., 0] = path * sum_9 * term_3
    result[..., 1] = path * sum_17 * term_3
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

    Accuracy: at most 502 ulp anywhere in this domain with independent errors, proved for elementary functions
    within 1 ulp (float64); with correlations up to 0.99 in size at most 58600. Errors are measured against
    the sum of the variances to first order of independent errors.
    """
    arguments = _floats(path, beta, baseline, sigma_path, sigma_beta, rho)
    path, beta, baseline, sigma_path, sigma_beta, rho = arguments
    term_1 = 1.0 / path
    baseline_per_path = baseline * term_1
    sigma_path_per_path = sigma_path * term_1
    cos_beta = np.cos(beta)
    product_1 = -2.0 * baseline_per_path * cos_beta
    divisor_1 = 2.0 + product_1
    sum_1 = 1.0 + baseline_per_path
    sum_1_squared = sum_1**2
    sum_2 = baseline_per_path - 1.0
    sum_2_squared = sum_2**2
    sigma_beta_squared = sigma_beta**2
    sin_beta = np.sin(beta)
    sin_beta_squared = sin_beta**2
    sum_3 = 1.0 + baseline_per_path**2 + product_1
    sum_3_squared = sum_3**2
    cos_beta_squared = cos_beta**2
    sigma_path_per_path_squared = sigma_path_per_path**2
    term_2 = 1.0 / (divisor_1**2)**2
    path_squared = path**2
    sum_4 = (
        4.0 * cos_beta_squared * sigma_path_per_path_squared * sum_3_squared
        + 4.0 * sigma_beta_squared * sin_beta_squared * sum_1_squared * sum_2_squared
        + 8.0 * cos_beta * rho * sigma_beta * sigma_path_per_path * sin_beta * sum_1 * sum_2 * sum_3
    )
    sum_5 = baseline_per_path - cos_beta
    sum_6 = 1.0 - 2.0 * cos_beta_squared + baseline_per_path * cos_beta
    sum_7 = (
        4.0 * cos_beta * sigma_path_per_path_squared * sin_beta * sum_3_squared
        + 4.0 * sigma_beta_squared * sin_beta * sum_1_squared * sum_2_squared * sum_5
        + 4.0 * rho * sigma_beta * sigma_path_per_path * sum_1 * sum_2 * sum_3 * sum_6
    )
    sum_8 = (
        4.0 * sigma_beta_squared * sum_1_squared * sum_2_squared * sum_5**2
        + 4.0 * sigma_path_per_path_squared * sin_beta_squared * sum_3_squared
        + 8.0 * rho * sigma_beta * sigma_path_per_path * sin_beta * sum_1 * sum_2 * sum_3 * sum_5
    )
    result = _empty(arguments, (2, 2))
    result[..., 0, 0] = path_squared * sum_4 * term_2
    result[..., 0, 1] = path_squared * sum_7 * term_2
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = path_squared * sum_8 * term_2
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

    Accuracy: at most 4660 ulp anywhere in this domain with independent errors, proved for elementary
    functions within 1 ulp (float64). Errors are measured against the sum of the variances to first order of
    independent errors.
    """
    arguments = _floats(path, beta, baseline, sigma_path, sigma_beta, rho)
    path, beta, baseline, sigma_path, sigma_beta, rho = arguments
    term_1 = 1.0 / path
    baseline_per_path = baseline * term_1
    sigma_path_per_path = sigma_path * term_1
    cos_beta = np.cos(beta)
    product_1 = -2.0 * baseline_per_path * cos_beta
    divisor_1 = 2.0 + product_1
    sum_1 = 1.0 + baseline_per_path
    sum_1_squared = sum_1**2
    sum_2 = baseline_per_path - 1.0
    sum_2_squared = sum_2**2
    baseline_per_path_squared = baseline_per_path**2
    sin_beta = np.sin(beta)
    sin_beta_squared = sin_beta**2
    product_2 = baseline_per_path_squared * sin_beta_squared
    sigma_beta_squared = sigma_beta**2
    sum_3 = 2.0 * baseline_per_path * cos_beta - 1.0 - baseline_per_path_squared + product_2
    cos_beta_squared = cos_beta**2
    product_3 = cos_beta * cos_beta_squared
    product_4 = -18.0 * baseline_per_path * product_3
    product_5 = baseline_per_path * baseline_per_path_squared**2
    baseline_per_path_squared_squared = baseline_per_path_squared**2
    cos_beta_squared_squared = cos_beta_squared**2
    product_6 = baseline_per_path * baseline_per_path_squared
    baseline_per_path_squared_cubed = baseline_per_path_squared * baseline_per_path_squared**2
    product_7 = cos_beta * cos_beta_squared**2
    product_8 = -6.0 * product_5 * product_7
    product_9 = 14.0 * product_6 * product_7
    product_10 = 33.0 * baseline_per_path_squared * cos_beta_squared_squared
    product_11 = 6.0 * baseline_per_path * cos_beta
    rho_squared = rho**2
    sigma_path_per_path_squared = sigma_path_per_path**2
    sum_4 = (
        2.0 * baseline_per_path_squared
        - 1.0
        - 22.0 * cos_beta * product_5
        - 40.0 * baseline_per_path_squared_squared * cos_beta_squared_squared
        - 46.0 * product_3 * product_6
        - 5.0 * baseline_per_path_squared_cubed * cos_beta_squared
        - 5.0 * baseline_per_path_squared_squared
        - 9.0 * baseline_per_path_squared * cos_beta_squared
        + 3.0 * baseline_per_path_squared_cubed * cos_beta_squared_squared
        + 3.0 * cos_beta_squared
        + 32.0 * product_3 * product_5
        + 51.0 * baseline_per_path_squared_squared * cos_beta_squared
        + 8.0 * cos_beta * product_6
        + product_10
        + product_11
        + product_4
        + product_8
        + product_9
    )
    product_12 = -12.0 * baseline_per_path * product_3
    product_13 = -2.0 * product_5 * product_7
    product_14 = 2.0 * baseline_per_path_squared_cubed * cos_beta_squared_squared
    product_15 = 20.0 * baseline_per_path_squared * cos_beta_squared_squared
    product_16 = 6.0 * product_6 * product_7
    sum_5 = (
        14.0 * product_3 * product_5
        - 1.0
        - 10.0 * cos_beta * product_5
        - 22.0 * baseline_per_path_squared_squared * cos_beta_squared_squared
        - 22.0 * product_3 * product_6
        - 3.0 * baseline_per_path_squared_cubed * cos_beta_squared
        - 3.0 * baseline_per_path_squared_squared
        - 7.0 * baseline_per_path_squared * cos_beta_squared
        + 2.0 * cos_beta_squared
        + 28.0 * baseline_per_path_squared_squared * cos_beta_squared
        + 4.0 * cos_beta * product_6
        + product_11
        + product_12
        + product_13
        + product_14
        + product_15
        + product_16
    )
    product_17 = sigma_beta * sigma_beta_squared
    sum_6 = (
        15.0 * baseline_per_path_squared * cos_beta
        - 11.0 * baseline_per_path_squared * product_3
        - 2.0 * baseline_per_path
        - 7.0 * baseline_per_path * cos_beta_squared
        - 8.0 * baseline_per_path_squared_squared * cos_beta
        - 8.0 * product_6
        - cos_beta_squared_squared * product_6
        + 16.0 * cos_beta_squared * product_6
        + 3.0 * baseline_per_path_squared_squared * product_3
        + 3.0 * cos_beta
    )
    product_18 = sigma_path_per_path * sigma_path_per_path_squared
    sum_7 = (
        13.0 * baseline_per_path_squared * cos_beta_squared
        - 1.0
        - 4.0 * baseline_per_path_squared
        - 4.0 * cos_beta * product_6
        + 3.0 * baseline_per_path * cos_beta
        + 4.0 * cos_beta_squared
        + product_12
        + product_3 * product_6
    )
    sum_8 = 1.0 + baseline_per_path_squared + product_1
    sum_8_squared = sum_8**2
    product_19 = baseline_per_path * cos_beta
    term_2 = (product_19 - 1.0)**2
    sum_9 = baseline_per_path_squared * cos_beta_squared - 3.0 - 4.0 * baseline_per_path_squared + product_11
    sigma_path_per_path_squared_squared = sigma_path_per_path_squared**2
    product_20 = -12.0 * baseline_per_path * cos_beta
    product_21 = 10.0 * baseline_per_path * product_3
    product_22 = 3.0 * baseline_per_path_squared * cos_beta_squared_squared
    sigma_beta_squared_squared = sigma_beta_squared**2
    sum_10 = (
        16.0 * baseline_per_path_squared
        - 2.0
        - 18.0 * baseline_per_path_squared * cos_beta_squared
        + 3.0 * cos_beta_squared
        + product_20
        + product_21
        + product_22
    )
    term_3 = 1.0 / (divisor_1 * divisor_1**2)**2
    path_squared = path**2
    sum_11 = (
        16.0 * cos_beta_squared * sigma_path_per_path_squared * sum_8_squared * term_2
        - 16.0 * rho_squared * sigma_beta_squared * sigma_path_per_path_squared * sum_4
        - 16.0 * sigma_beta_squared * sigma_path_per_path_squared * sum_5
        - 16.0 * sigma_beta_squared * sin_beta_squared * sum_1_squared * sum_2_squared * sum_3
        - 32.0 * product_17 * rho * sigma_path_per_path * sin_beta * sum_1 * sum_2 * sum_6
        - 64.0 * baseline_per_path_squared * cos_beta * product_18 * rho * sigma_beta * sin_beta * sum_7
        + 32.0 * baseline_per_path_squared * (1.0 + cos_beta) * (cos_beta - 1.0) * cos_beta_squared * sigma_path_per_path_squared_squared * sum_9
        + 32.0 * cos_beta * rho * sigma_beta * sigma_path_per_path * sin_beta * sum_1 * sum_2 * sum_8 * term_2
        + 8.0 * sigma_beta_squared_squared * sum_10 * sum_1_squared * sum_2_squared
    )
    product_23 = 6.0 * baseline_per_path_squared * cos_beta
    sum_12 = (
        14.0 * cos_beta_squared_squared * product_6
        - 16.0 * baseline_per_path_squared_cubed * cos_beta
        - 16.0 * product_5
        - 18.0 * baseline_per_path * cos_beta_squared
        - 46.0 * cos_beta_squared * product_6
        - 50.0 * baseline_per_path_squared_squared * product_3
        - 6.0 * cos_beta_squared_squared * product_5
        + 3.0 * cos_beta
        + 33.0 * baseline_per_path_squared * product_3
        + 35.0 * baseline_per_path_squared_squared * cos_beta
        + 4.0 * product_6
        + 5.0 * baseline_per_path_squared_cubed * product_3
        + 52.0 * cos_beta_squared * product_5
        + product_23
    )
    sum_13 = (
        2.0 * product_3 * product_6
        - 1.0
        - 12.0 * cos_beta * product_6
        - 24.0 * baseline_per_path * product_3
        - 4.0 * baseline_per_path_squared
        + 31.0 * baseline_per_path_squared * cos_beta_squared
        + 8.0 * cos_beta_squared
    )
    product_24 = sin_beta * sin_beta_squared
    sum_14 = (
        10.0 * baseline_per_path_squared * product_3
        - 13.0 * baseline_per_path_squared_squared * product_3
        - 13.0 * cos_beta_squared * product_6
        - 4.0 * baseline_per_path_squared_cubed * cos_beta
        - 4.0 * product_5
        - 6.0 * baseline_per_path * cos_beta_squared
        - cos_beta_squared_squared * product_5
        + 10.0 * baseline_per_path_squared_squared * cos_beta
        + 13.0 * cos_beta_squared * product_5
        + 3.0 * baseline_per_path_squared * cos_beta
        + 3.0 * cos_beta_squared_squared * product_6
        + baseline_per_path_squared_cubed * product_3
        + cos_beta
    )
    sum_15 = (
        18.0 * baseline_per_path_squared * cos_beta
        - 10.0 * baseline_per_path * cos_beta_squared
        - 16.0 * product_6
        - 3.0 * baseline_per_path_squared * product_3
        - 3.0 * cos_beta
        + 7.0 * baseline_per_path
        + 7.0 * cos_beta_squared * product_6
    )
    sum_16 = (
        6.0
        - 12.0 * cos_beta_squared
        - 16.0 * cos_beta * product_5
        - 20.0 * baseline_per_path_squared_squared * cos_beta_squared_squared
        - 3.0 * baseline_per_path * cos_beta
        - 48.0 * baseline_per_path_squared_squared
        - 80.0 * baseline_per_path_squared * cos_beta_squared
        - 95.0 * product_3 * product_6
        + 103.0 * cos_beta * product_6
        + 11.0 * product_3 * product_5
        + 2.0 * baseline_per_path_squared
        + 28.0 * baseline_per_path * product_3
        + 4.0 * product_6 * product_7
        + 44.0 * baseline_per_path_squared * cos_beta_squared_squared
        + 76.0 * baseline_per_path_squared_squared * cos_beta_squared
    )
    sum_17 = baseline_per_path - cos_beta
    sum_18 = 1.0 - 2.0 * cos_beta_squared + product_19
    sum_19 = (
        16.0 * cos_beta * sigma_path_per_path_squared * sin_beta * sum_8_squared * term_2
        - 16.0 * rho_squared * sigma_beta_squared * sigma_path_per_path_squared * sin_beta * sum_12
        - 32.0 * baseline_per_path_squared * cos_beta * product_24 * sigma_path_per_path_squared_squared * sum_9
        - 32.0 * baseline_per_path_squared * product_18 * rho * sigma_beta * sin_beta_squared * sum_13
        - 32.0 * sigma_beta_squared * sigma_path_per_path_squared * sin_beta * sum_14
        - 8.0 * product_17 * rho * sigma_path_per_path * sum_1 * sum_16 * sum_2
        - 8.0 * sigma_beta_squared_squared * sin_beta * sum_15 * sum_1_squared * sum_2_squared
        + 16.0 * sigma_beta_squared * sin_beta * sum_17 * sum_1_squared * sum_2_squared * term_2
        + 16.0 * rho * sigma_beta * sigma_path_per_path * sum_1 * sum_18 * sum_2 * sum_8 * term_2
    )
    sum_20 = (
        12.0 * baseline_per_path_squared
        - 1.0
        - 14.0 * product_3 * product_6
        - 16.0 * baseline_per_path_squared_squared
        - 21.0 * baseline_per_path_squared * cos_beta_squared
        + 12.0 * baseline_per_path_squared_squared * cos_beta_squared
        + 24.0 * cos_beta * product_6
        + 3.0 * cos_beta_squared
        + product_20
        + product_21
        + product_22
    )
    sum_21 = (
        12.0 * baseline_per_path * cos_beta
        - 2.0
        - 12.0 * baseline_per_path_squared * cos_beta_squared
        - 12.0 * baseline_per_path_squared_squared
        - 38.0 * baseline_per_path_squared_cubed * cos_beta_squared
        - 6.0 * baseline_per_path_squared
        - 60.0 * baseline_per_path_squared_squared * cos_beta_squared_squared
        - 60.0 * product_3 * product_6
        - 78.0 * cos_beta * product_5
        + 26.0 * cos_beta * product_6
        + 3.0 * cos_beta_squared
        + 32.0 * baseline_per_path_squared_cubed
        + 7.0 * baseline_per_path_squared_cubed * cos_beta_squared_squared
        + 78.0 * product_3 * product_5
        + 87.0 * baseline_per_path_squared_squared * cos_beta_squared
        + product_10
        + product_4
        + product_8
        + product_9
    )
    sum_22 = (
        10.0 * cos_beta * product_6
        - 1.0
        - 17.0 * baseline_per_path_squared_cubed * cos_beta_squared
        - 3.0 * baseline_per_path_squared_squared
        - 30.0 * baseline_per_path_squared_squared * cos_beta_squared_squared
        - 36.0 * product_3 * product_6
        - 4.0 * baseline_per_path_squared
        - 44.0 * cos_beta * product_5
        - baseline_per_path_squared * cos_beta_squared
        + 16.0 * baseline_per_path_squared_cubed
        + 2.0 * cos_beta_squared
        + 40.0 * product_3 * product_5
        + 48.0 * baseline_per_path_squared_squared * cos_beta_squared
        + product_11
        + product_12
        + product_13
        + product_14
        + product_15
        + product_16
    )
    sin_beta_squared_squared = sin_beta_squared**2
    sum_23 = (
        11.0 * product_5 * sin_beta_squared
        - 14.0 * baseline_per_path_squared_squared * cos_beta * sin_beta_squared
        - 2.0 * product_6 * sin_beta_squared_squared
        - 21.0 * baseline_per_path
        - 57.0 * product_6 * sin_beta_squared
        - 60.0 * baseline_per_path_squared_squared * cos_beta
        + 14.0 * baseline_per_path * sin_beta_squared
        + 21.0 * product_5
        + 22.0 * baseline_per_path_squared * cos_beta * sin_beta_squared
        + 48.0 * product_6
        + 6.0 * cos_beta
        + product_23
    )
    sum_24 = 3.0 - 6.0 * baseline_per_path * cos_beta + 3.0 * baseline_per_path_squared + product_2
    sum_25 = (
        15.0 * baseline_per_path
        - 12.0 * baseline_per_path * sin_beta_squared
        - 18.0 * baseline_per_path_squared * cos_beta
        - 4.0 * cos_beta
        + 7.0 * product_6
        + product_6 * sin_beta_squared
    )
    sum_26 = (
        16.0 * product_17 * rho * sigma_path_per_path * sin_beta * sum_1 * sum_2 * sum_23
        - 8.0 * sigma_beta_squared_squared * sum_1_squared * sum_20 * sum_2_squared
        + 16.0 * rho_squared * sigma_beta_squared * sigma_path_per_path_squared * sum_21
        + 16.0 * sigma_beta_squared * sigma_path_per_path_squared * sum_22
        + 16.0 * sigma_beta_squared * sum_17**2 * sum_1_squared * sum_2_squared * term_2
        + 16.0 * sigma_path_per_path_squared * sin_beta_squared * sum_8_squared * term_2
        + 32.0 * baseline_per_path_squared * sigma_path_per_path_squared_squared * sin_beta_squared_squared * sum_24
        + 32.0 * rho * sigma_beta * sigma_path_per_path * sin_beta * sum_1 * sum_17 * sum_2 * sum_8 * term_2
        + 64.0 * baseline_per_path_squared * product_18 * product_24 * rho * sigma_beta * sum_25
    )
    result = _empty(arguments, (2, 2))
    result[..., 0, 0] = path_squared * sum_11 * term_3
    result[..., 0, 1] = path_squared * sum_19 * term_3
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = path_squared * sum_26 * term_3
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

    Accuracy: at most 502 ulp anywhere in this domain with independent errors, proved for elementary functions
    within 1 ulp (float64); with correlations up to 0.99 in size at most 58600. Errors are measured against
    the sum of the variances to first order of independent errors.
    """
    arguments = _floats(path, beta, baseline, sigma_path, sigma_beta, rho)
    path, beta, baseline, sigma_path, sigma_beta, rho = arguments
    term_1 = 1.0 / path
    baseline_per_path = baseline * term_1
    sigma_path_per_path = sigma_path * term_1
    cos_beta = np.cos(beta)
    product_1 = -2.0 * baseline_per_path * cos_beta
    divisor_1 = 2.0 + product_1
    sum_1 = 1.0 + baseline_per_path
    sum_1_squared = sum_1**2
    sum_2 = baseline_per_path - 1.0
    sum_2_squared = sum_2**2
    sigma_beta_squared = sigma_beta**2
    sin_beta = np.sin(beta)
    sin_beta_squared = sin_beta**2
    sum_3 = 1.0 + baseline_per_path**2 + product_1
    sum_3_squared = sum_3**2
    cos_beta_squared = cos_beta**2
    sigma_path_per_path_squared = sigma_path_per_path**2
    term_2 = 1.0 / (divisor_1**2)**2
    path_squared = path**2
    sum_4 = (
        4.0 * cos_beta_squared * sigma_path_per_path_squared * sum_3_squared
        + 4.0 * sigma_beta_squared * sin_beta_squared * sum_1_squared * sum_2_squared
        + 8.0 * cos_beta * rho * sigma_beta * sigma_path_per_path * sin_beta * sum_1 * sum_2 * sum_3
    )
    sum_5 = baseline_per_path - cos_beta
    sum_6 = 1.0 - 2.0 * cos_beta_squared + baseline_per_path * cos_beta
    sum_7 = (
        4.0 * cos_beta * sigma_path_per_path_squared * sin_beta * sum_3_squared
        + 4.0 * sigma_beta_squared * sin_beta * sum_1_squared * sum_2_squared * sum_5
        + 4.0 * rho * sigma_beta * sigma_path_per_path * sum_1 * sum_2 * sum_3 * sum_6
    )
    sum_8 = (
        4.0 * sigma_beta_squared * sum_1_squared * sum_2_squared * sum_5**2
        + 4.0 * sigma_path_per_path_squared * sin_beta_squared * sum_3_squared
        + 8.0 * rho * sigma_beta * sigma_path_per_path * sin_beta * sum_1 * sum_2 * sum_3 * sum_5
    )
    result = _empty(arguments, (2, 2))
    result[..., 0, 0] = path_squared * sum_4 * term_2
    result[..., 0, 1] = path_squared * sum_7 * term_2
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = path_squared * sum_8 * term_2
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

    Accuracy: at most 9260 ulp anywhere in this domain with independent errors, proved for elementary
    functions within 1 ulp (float64). Errors are measured against the sum of the variances to first order of
    independent errors.
    """
    arguments = _floats(path, beta, baseline, sigma_path, sigma_beta, rho)
    path, beta, baseline, sigma_path, sigma_beta, rho = arguments
    term_1 = 1.0 / path
    baseline_per_path = baseline * term_1
    sigma_path_per_path = sigma_path * term_1
    cos_beta = np.cos(beta)
    product_1 = -2.0 * baseline_per_path * cos_beta
    divisor_1 = 2.0 + product_1
    sum_1 = 1.0 + baseline_per_path
    sum_1_squared = sum_1**2
    sum_2 = baseline_per_path - 1.0
    sum_2_squared = sum_2**2
    baseline_per_path_squared = baseline_per_path**2
    sin_beta = np.sin(beta)
    sin_beta_squared = sin_beta**2
    product_2 = baseline_per_path_squared * sin_beta_squared
    sigma_beta_squared = sigma_beta**2
    sum_3 = 2.0 * baseline_per_path * cos_beta - 1.0 - baseline_per_path_squared + product_2
    product_3 = baseline_per_path * baseline_per_path_squared
    cos_beta_squared = cos_beta**2
    product_4 = cos_beta * cos_beta_squared
    baseline_per_path_squared_squared = baseline_per_path_squared**2
    baseline_per_path_squared_cubed = baseline_per_path_squared * baseline_per_path_squared**2
    product_5 = baseline_per_path * baseline_per_path_squared**2
    product_6 = cos_beta * cos_beta_squared**2
    product_7 = -14.0 * product_5 * product_6
    product_8 = -42.0 * baseline_per_path * product_4
    cos_beta_squared_squared = cos_beta_squared**2
    product_9 = 18.0 * baseline_per_path * cos_beta
    product_10 = 30.0 * product_3 * product_6
    product_11 = 77.0 * baseline_per_path_squared * cos_beta_squared_squared
    rho_squared = rho**2
    sigma_path_per_path_squared = sigma_path_per_path**2
    sum_4 = (
        111.0 * baseline_per_path_squared_squared * cos_beta_squared
        - 3.0
        - 102.0 * product_3 * product_4
        - 11.0 * baseline_per_path_squared_cubed * cos_beta_squared
        - 11.0 * baseline_per_path_squared_squared
        - 27.0 * baseline_per_path_squared * cos_beta_squared
        - 50.0 * cos_beta * product_5
        - 88.0 * baseline_per_path_squared_squared * cos_beta_squared_squared
        + 2.0 * baseline_per_path_squared
        + 24.0 * cos_beta * product_3
        + 7.0 * baseline_per_path_squared_cubed * cos_beta_squared_squared
        + 7.0 * cos_beta_squared
        + 72.0 * product_4 * product_5
        + product_10
        + product_11
        + product_7
        + product_8
        + product_9
    )
    product_12 = -30.0 * baseline_per_path * product_4
    product_13 = -4.0 * product_5 * product_6
    product_14 = 12.0 * product_3 * product_6
    product_15 = 49.0 * baseline_per_path_squared * cos_beta_squared_squared
    product_16 = 5.0 * baseline_per_path_squared_cubed * cos_beta_squared_squared
    sum_5 = (
        12.0 * cos_beta * product_3
        - 3.0
        - 2.0 * baseline_per_path_squared
        - 21.0 * baseline_per_path_squared * cos_beta_squared
        - 22.0 * cos_beta * product_5
        - 48.0 * product_3 * product_4
        - 50.0 * baseline_per_path_squared_squared * cos_beta_squared_squared
        - 7.0 * baseline_per_path_squared_cubed * cos_beta_squared
        - 7.0 * baseline_per_path_squared_squared
        + 30.0 * product_4 * product_5
        + 5.0 * cos_beta_squared
        + 63.0 * baseline_per_path_squared_squared * cos_beta_squared
        + product_12
        + product_13
        + product_14
        + product_15
        + product_16
        + product_9
    )
    product_17 = sigma_path_per_path * sigma_path_per_path_squared
    sum_6 = (
        3.0 * baseline_per_path * cos_beta
        - 1.0
        - 3.0 * baseline_per_path_squared
        - 3.0 * cos_beta * product_3
        - 9.0 * baseline_per_path * product_4
        + 3.0 * cos_beta_squared
        + 9.0 * baseline_per_path_squared * cos_beta_squared
        + product_3 * product_4
    )
    product_18 = sigma_beta * sigma_beta_squared
    sum_7 = (
        34.0 * cos_beta_squared * product_3
        - 16.0 * baseline_per_path * cos_beta_squared
        - 18.0 * baseline_per_path_squared_squared * cos_beta
        - 18.0 * product_3
        - 2.0 * cos_beta_squared_squared * product_3
        - 25.0 * baseline_per_path_squared * product_4
        - 6.0 * baseline_per_path
        + 37.0 * baseline_per_path_squared * cos_beta
        + 7.0 * baseline_per_path_squared_squared * product_4
        + 7.0 * cos_beta
    )
    sum_8 = 1.0 + baseline_per_path_squared + product_1
    sum_8_squared = sum_8**2
    product_19 = baseline_per_path * cos_beta
    term_2 = (product_19 - 1.0)**2
    product_20 = 22.0 * baseline_per_path * product_4
    product_21 = 7.0 * baseline_per_path_squared * cos_beta_squared_squared
    sigma_beta_squared_squared = sigma_beta_squared**2
    sum_9 = (
        36.0 * baseline_per_path_squared
        - 4.0
        - 28.0 * baseline_per_path * cos_beta
        - 40.0 * baseline_per_path_squared * cos_beta_squared
        + 7.0 * cos_beta_squared
        + product_20
        + product_21
    )
    sum_10 = (
        4.0 * baseline_per_path * cos_beta
        - 2.0
        - 3.0 * baseline_per_path_squared
        + baseline_per_path_squared * cos_beta_squared
    )
    sigma_path_per_path_squared_squared = sigma_path_per_path_squared**2
    term_3 = 1.0 / (divisor_1 * divisor_1**2)**2
    path_squared = path**2
    sum_11 = (
        16.0 * cos_beta_squared * sigma_path_per_path_squared * sum_8_squared * term_2
        - 16.0 * rho_squared * sigma_beta_squared * sigma_path_per_path_squared * sum_4
        - 16.0 * sigma_beta_squared * sigma_path_per_path_squared * sum_5
        - 16.0 * sigma_beta_squared * sin_beta_squared * sum_1_squared * sum_2_squared * sum_3
        - 192.0 * baseline_per_path_squared * cos_beta * product_17 * rho * sigma_beta * sin_beta * sum_6
        - 32.0 * product_18 * rho * sigma_path_per_path * sin_beta * sum_1 * sum_2 * sum_7
        + 32.0 * cos_beta * rho * sigma_beta * sigma_path_per_path * sin_beta * sum_1 * sum_2 * sum_8 * term_2
        + 8.0 * sigma_beta_squared_squared * sum_1_squared * sum_2_squared * sum_9
        + 96.0 * baseline_per_path_squared * (1.0 + cos_beta) * (cos_beta - 1.0) * cos_beta_squared * sigma_path_per_path_squared_squared * sum_10
    )
    sum_12 = (
        112.0 * cos_beta_squared * product_5
        - 106.0 * cos_beta_squared * product_3
        - 110.0 * baseline_per_path_squared_squared * product_4
        - 14.0 * cos_beta_squared_squared * product_5
        - 36.0 * baseline_per_path_squared_cubed * cos_beta
        - 36.0 * product_5
        - 42.0 * baseline_per_path * cos_beta_squared
        + 13.0 * baseline_per_path_squared_cubed * product_4
        + 14.0 * baseline_per_path_squared * cos_beta
        + 30.0 * cos_beta_squared_squared * product_3
        + 7.0 * cos_beta
        + 77.0 * baseline_per_path_squared * product_4
        + 8.0 * product_3
        + 83.0 * baseline_per_path_squared_squared * cos_beta
    )
    sum_13 = (
        12.0 * cos_beta_squared_squared * product_3
        - 18.0 * baseline_per_path_squared_cubed * cos_beta
        - 18.0 * product_5
        - 2.0 * product_3
        - 30.0 * baseline_per_path * cos_beta_squared
        - 4.0 * cos_beta_squared_squared * product_5
        - 58.0 * baseline_per_path_squared_squared * product_4
        - 62.0 * cos_beta_squared * product_3
        + 16.0 * baseline_per_path_squared * cos_beta
        + 49.0 * baseline_per_path_squared * product_4
        + 49.0 * baseline_per_path_squared_squared * cos_beta
        + 5.0 * baseline_per_path_squared_cubed * product_4
        + 5.0 * cos_beta
        + 56.0 * cos_beta_squared * product_5
    )
    sum_14 = (
        7.0
        - 107.0 * product_3 * product_4
        - 14.0 * cos_beta_squared
        - 18.0 * cos_beta * product_5
        - 22.0 * baseline_per_path_squared_squared * cos_beta_squared_squared
        - 3.0 * baseline_per_path * cos_beta
        - 54.0 * baseline_per_path_squared_squared
        - 91.0 * baseline_per_path_squared * cos_beta_squared
        + 119.0 * cos_beta * product_3
        + 13.0 * product_4 * product_5
        + 32.0 * baseline_per_path * product_4
        + 4.0 * product_3 * product_6
        + 50.0 * baseline_per_path_squared * cos_beta_squared_squared
        + 83.0 * baseline_per_path_squared_squared * cos_beta_squared
        + baseline_per_path_squared
    )
    sum_15 = (
        16.0 * baseline_per_path
        - 22.0 * baseline_per_path * cos_beta_squared
        - 36.0 * product_3
        - 7.0 * baseline_per_path_squared * product_4
        - 7.0 * cos_beta
        + 16.0 * cos_beta_squared * product_3
        + 40.0 * baseline_per_path_squared * cos_beta
    )
    product_22 = sin_beta * sin_beta_squared
    sum_16 = baseline_per_path - cos_beta
    sum_17 = 1.0 - 2.0 * cos_beta_squared + product_19
    sum_18 = (
        17.0 * baseline_per_path * cos_beta
        - 5.0
        - 18.0 * baseline_per_path * cos_beta * sin_beta_squared
        - 19.0 * baseline_per_path_squared
        + 2.0 * cos_beta * product_3 * sin_beta_squared
        + 22.0 * baseline_per_path_squared * sin_beta_squared
        + 6.0 * sin_beta_squared
        + 7.0 * cos_beta * product_3
    )
    sum_19 = (
        16.0 * cos_beta * sigma_path_per_path_squared * sin_beta * sum_8_squared * term_2
        - 16.0 * product_18 * rho * sigma_path_per_path * sum_1 * sum_14 * sum_2
        - 16.0 * rho_squared * sigma_beta_squared * sigma_path_per_path_squared * sin_beta * sum_12
        - 16.0 * sigma_beta_squared * sigma_path_per_path_squared * sin_beta * sum_13
        - 8.0 * sigma_beta_squared_squared * sin_beta * sum_15 * sum_1_squared * sum_2_squared
        - 96.0 * baseline_per_path_squared * cos_beta * product_22 * sigma_path_per_path_squared_squared * sum_10
        + 16.0 * sigma_beta_squared * sin_beta * sum_16 * sum_1_squared * sum_2_squared * term_2
        + 16.0 * rho * sigma_beta * sigma_path_per_path * sum_1 * sum_17 * sum_2 * sum_8 * term_2
        + 96.0 * baseline_per_path_squared * product_17 * rho * sigma_beta * sin_beta_squared * sum_18
    )
    sum_20 = (
        7.0
        - 16.0 * baseline_per_path * cos_beta
        - 2.0 * product_3 * product_4
        - 25.0 * baseline_per_path_squared * cos_beta_squared
        - 36.0 * baseline_per_path_squared_squared
        + 13.0 * baseline_per_path_squared
        + 13.0 * baseline_per_path_squared_squared * cos_beta_squared
        + 46.0 * cos_beta * product_3
    )
    sum_21 = (
        28.0 * baseline_per_path_squared
        - 3.0
        - 26.0 * baseline_per_path * cos_beta
        - 32.0 * product_3 * product_4
        - 36.0 * baseline_per_path_squared_squared
        - 47.0 * baseline_per_path_squared * cos_beta_squared
        + 28.0 * baseline_per_path_squared_squared * cos_beta_squared
        + 52.0 * cos_beta * product_3
        + 7.0 * cos_beta_squared
        + product_20
        + product_21
    )
    sum_22 = (
        166.0 * product_4 * product_5
        - 4.0
        - 10.0 * baseline_per_path_squared
        - 132.0 * baseline_per_path_squared_squared * cos_beta_squared_squared
        - 140.0 * product_3 * product_4
        - 170.0 * cos_beta * product_5
        - 22.0 * baseline_per_path_squared * cos_beta_squared
        - 30.0 * baseline_per_path_squared_squared
        - 88.0 * baseline_per_path_squared_cubed * cos_beta_squared
        + 19.0 * baseline_per_path_squared_cubed * cos_beta_squared_squared
        + 207.0 * baseline_per_path_squared_squared * cos_beta_squared
        + 24.0 * baseline_per_path * cos_beta
        + 50.0 * cos_beta * product_3
        + 7.0 * cos_beta_squared
        + 72.0 * baseline_per_path_squared_cubed
        + product_10
        + product_11
        + product_7
        + product_8
    )
    sum_23 = (
        117.0 * baseline_per_path_squared_squared * cos_beta_squared
        - 2.0
        - 100.0 * cos_beta * product_5
        - 38.0 * baseline_per_path_squared_cubed * cos_beta_squared
        - 6.0 * baseline_per_path_squared_squared
        - 66.0 * baseline_per_path_squared_squared * cos_beta_squared_squared
        - 8.0 * baseline_per_path_squared
        - 88.0 * product_3 * product_4
        + 12.0 * baseline_per_path * cos_beta
        + 16.0 * cos_beta * product_3
        + 36.0 * baseline_per_path_squared_cubed
        + 4.0 * baseline_per_path_squared * cos_beta_squared
        + 5.0 * cos_beta_squared
        + 86.0 * product_4 * product_5
        + product_12
        + product_13
        + product_14
        + product_15
        + product_16
    )
    sum_24 = (
        11.0 * baseline_per_path
        - 13.0 * baseline_per_path_squared * cos_beta
        - 3.0 * cos_beta
        - 9.0 * baseline_per_path * sin_beta_squared
        + 5.0 * product_3
        + product_3 * sin_beta_squared
    )
    sum_25 = 2.0 - 4.0 * baseline_per_path * cos_beta + 2.0 * baseline_per_path_squared + product_2
    sum_26 = (
        16.0 * rho_squared * sigma_beta_squared * sigma_path_per_path_squared * sum_22
        - 32.0 * product_18 * rho * sigma_path_per_path * sin_beta * sum_1 * sum_16 * sum_2 * sum_20
        - 8.0 * sigma_beta_squared_squared * sum_1_squared * sum_21 * sum_2_squared
        + 16.0 * sigma_beta_squared * sigma_path_per_path_squared * sum_23
        + 16.0 * sigma_beta_squared * sum_16**2 * sum_1_squared * sum_2_squared * term_2
        + 16.0 * sigma_path_per_path_squared * sin_beta_squared * sum_8_squared * term_2
        + 192.0 * baseline_per_path_squared * product_17 * product_22 * rho * sigma_beta * sum_24
        + 32.0 * rho * sigma_beta * sigma_path_per_path * sin_beta * sum_1 * sum_16 * sum_2 * sum_8 * term_2
        + 96.0 * baseline_per_path_squared * sigma_path_per_path_squared_squared * sin_beta_squared**2 * sum_25
    )
    result = _empty(arguments, (2, 2))
    result[..., 0, 0] = path_squared * sum_11 * term_3
    result[..., 0, 1] = path_squared * sum_19 * term_3
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = path_squared * sum_26 * term_3
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

    Accuracy: at most 104 ulp anywhere in this domain with independent errors, proved for elementary functions
    within 1 ulp (float64); with correlations up to 0.99 in size at most 238.
    """
    arguments = _floats(path, beta, baseline, sigma_path, sigma_beta, rho)
    path, beta, baseline, sigma_path, sigma_beta, rho = arguments
    term_1 = 1.0 / path
    baseline_per_path = baseline * term_1
    sigma_path_per_path = sigma_path * term_1
    cos_beta = np.cos(beta)
    divisor_1 = 2.0 - 2.0 * baseline_per_path * cos_beta
    sum_1 = 1.0 + baseline_per_path
    sum_2 = baseline_per_path - 1.0
    cos_beta_squared = cos_beta**2
    sigma_beta_squared = sigma_beta**2
    sum_3 = baseline_per_path * cos_beta_squared - 2.0 * baseline_per_path + cos_beta
    term_2 = (baseline_per_path * cos_beta - 1.0)**2
    baseline_per_path_squared = baseline_per_path**2
    sigma_path_per_path_squared = sigma_path_per_path**2
    sin_beta = np.sin(beta)
    sin_beta_squared = sin_beta**2
    product_1 = baseline_per_path * baseline_per_path_squared
    sum_4 = 1.0 - 3.0 * baseline_per_path * cos_beta + baseline_per_path_squared + cos_beta * product_1
    term_3 = 1.0 / (divisor_1 * divisor_1**2)
    sum_5 = (
        4.0 * baseline_per_path_squared * cos_beta * sigma_path_per_path_squared * sin_beta_squared
        - 2.0 * sigma_beta_squared * sum_1 * sum_2 * sum_3
        - 4.0 * cos_beta * sum_1 * sum_2 * term_2
        + 4.0 * rho * sigma_beta * sigma_path_per_path * sin_beta * sum_4
    )
    sum_6 = (
        3.0 * baseline_per_path_squared * cos_beta
        - 2.0 * product_1
        - 3.0 * baseline_per_path * cos_beta_squared
        + cos_beta
        + cos_beta_squared * product_1
    )
    sum_7 = 2.0 * baseline_per_path_squared - 1.0 - baseline_per_path * cos_beta
    sum_8 = (
        2.0 * sigma_beta_squared * sin_beta * sum_1 * sum_2 * sum_7
        - 4.0 * rho * sigma_beta * sigma_path_per_path * sum_6
        - 4.0 * sin_beta * sum_1 * sum_2 * term_2
        + 4.0 * baseline_per_path_squared * sigma_path_per_path_squared * sin_beta * sin_beta_squared
    )
    result = _empty(arguments, (2,))
    result[..., 0] = path * sum_5 * term_3
    result[..., 1] = path * sum_8 * term_3
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

    Accuracy: at most 228 ulp anywhere in this domain with independent errors, proved for elementary functions
    within 1 ulp (float64).
    """
    arguments = _floats(path, beta, baseline, sigma_path, sigma_beta, rho)
    path, beta, baseline, sigma_path, sigma_beta, rho = arguments
    term_1 = 1.0 / path
    baseline_per_path = baseline * term_1
    sigma_path_per_path = sigma_path * term_1
    cos_beta = np.cos(beta)
    divisor_1 = 2.0 - 2.0 * baseline_per_path * cos_beta
    sum_1 = baseline_per_path * cos_beta - 1.0
    sum_1_squared = sum_1**2
    sum_1_squared_squared = sum_1_squared**2
    sum_2 = 1.0 + baseline_per_path
    sum_3 = baseline_per_path - 1.0
    baseline_per_path_squared = baseline_per_path**2
    product_1 = baseline_per_path * baseline_per_path_squared
    cos_beta_squared = cos_beta**2
    product_2 = cos_beta * cos_beta_squared
    cos_beta_squared_squared = cos_beta_squared**2
    sigma_beta_squared = sigma_beta**2
    sigma_beta_squared_squared = sigma_beta_squared**2
    sum_4 = (
        11.0 * baseline_per_path * cos_beta_squared
        - 20.0 * baseline_per_path_squared * cos_beta
        - 20.0 * cos_beta_squared * product_1
        - 8.0 * baseline_per_path
        + 11.0 * baseline_per_path_squared * product_2
        + 24.0 * product_1
        + cos_beta
        + cos_beta_squared_squared * product_1
    )
    sigma_path_per_path_squared = sigma_path_per_path**2
    sigma_path_per_path_squared_squared = sigma_path_per_path_squared**2
    sin_beta = np.sin(beta)
    sin_beta_squared = sin_beta**2
    sum_5 = baseline_per_path * cos_beta_squared - 2.0 * baseline_per_path + cos_beta
    sum_6 = (
        13.0 * baseline_per_path * cos_beta_squared
        - 3.0 * baseline_per_path * cos_beta_squared_squared
        - 6.0 * baseline_per_path
        - 6.0 * baseline_per_path_squared * cos_beta
        - 9.0 * product_2
        + 4.0 * baseline_per_path_squared * product_2
        + 7.0 * cos_beta
    )
    rho_squared = rho**2
    product_3 = -3.0 * baseline_per_path * cos_beta
    sum_7 = 1.0 + baseline_per_path_squared + cos_beta * product_1 + product_3
    product_4 = sigma_path_per_path * sigma_path_per_path_squared
    sum_8 = 3.0 * cos_beta_squared - 1.0 + baseline_per_path * product_2 + product_3
    baseline_per_path_squared_squared = baseline_per_path_squared**2
    product_5 = baseline_per_path * baseline_per_path_squared**2
    product_6 = sigma_beta * sigma_beta_squared
    sum_9 = (
        1.0
        - 17.0 * baseline_per_path_squared * cos_beta_squared
        - 18.0 * baseline_per_path_squared_squared
        - 3.0 * product_1 * product_2
        - 5.0 * baseline_per_path * cos_beta
        - 6.0 * cos_beta * product_5
        + 11.0 * baseline_per_path_squared_squared * cos_beta_squared
        + 29.0 * cos_beta * product_1
        + 7.0 * baseline_per_path_squared
        + product_2 * product_5
    )
    term_2 = 1.0 / (divisor_1 * (divisor_1**2)**2)
    sum_10 = (
        16.0 * baseline_per_path_squared * cos_beta * sigma_path_per_path_squared * sin_beta_squared * sum_1_squared
        - 16.0 * cos_beta * sum_1_squared_squared * sum_2 * sum_3
        - 2.0 * sigma_beta_squared_squared * sum_2 * sum_3 * sum_4
        - 48.0 * baseline_per_path_squared * cos_beta * sigma_path_per_path_squared_squared * sin_beta_squared
        - 8.0 * sigma_beta_squared * sum_1_squared * sum_2 * sum_3 * sum_5
        + 16.0 * baseline_per_path_squared * rho_squared * sigma_beta_squared * sigma_path_per_path_squared * sum_6
        + 16.0 * rho * sigma_beta * sigma_path_per_path * sin_beta * sum_1_squared * sum_7
        + 48.0 * baseline_per_path_squared * product_4 * rho * sigma_beta * sin_beta * sum_8
        + 8.0 * baseline_per_path_squared * sigma_beta_squared * sigma_path_per_path_squared * sum_6
        + 8.0 * product_6 * rho * sigma_path_per_path * sin_beta * sum_9
    )
    product_7 = sin_beta * sin_beta_squared
    sum_11 = (
        2.0 * baseline_per_path * cos_beta
        - 1.0
        - baseline_per_path_squared
        + baseline_per_path_squared * sin_beta_squared
    )
    sum_12 = (
        3.0 * baseline_per_path_squared * cos_beta
        - 2.0 * product_1
        - 3.0 * baseline_per_path * cos_beta_squared
        + cos_beta
        + cos_beta_squared * product_1
    )
    sum_13 = 3.0 * baseline_per_path - 3.0 * cos_beta + baseline_per_path * sin_beta_squared
    sum_14 = (
        19.0 * baseline_per_path_squared_squared * product_2
        - 17.0 * baseline_per_path_squared * product_2
        - 20.0 * cos_beta_squared * product_5
        - 20.0 * product_1
        - 3.0 * cos_beta_squared_squared * product_1
        - 32.0 * baseline_per_path_squared_squared * cos_beta
        - 5.0 * baseline_per_path * cos_beta_squared
        + 21.0 * baseline_per_path_squared * cos_beta
        + 24.0 * product_5
        + 31.0 * cos_beta_squared * product_1
        + cos_beta
        + cos_beta_squared_squared * product_5
    )
    sum_15 = (
        20.0 * baseline_per_path_squared
        - 1.0
        - 11.0 * baseline_per_path * cos_beta
        - 11.0 * baseline_per_path_squared * cos_beta_squared
        - 24.0 * baseline_per_path_squared_squared
        - product_1 * product_2
        + 20.0 * cos_beta * product_1
        + 8.0 * baseline_per_path_squared_squared * cos_beta_squared
    )
    sum_16 = (
        1.0
        - 3.0 * cos_beta_squared
        - 4.0 * baseline_per_path_squared
        - baseline_per_path * product_2
        + 2.0 * baseline_per_path_squared * cos_beta_squared
        + 5.0 * baseline_per_path * cos_beta
    )
    sum_17 = 2.0 * baseline_per_path_squared - 1.0 - baseline_per_path * cos_beta
    sum_18 = (
        2.0 * sigma_beta_squared_squared * sin_beta * sum_15 * sum_2 * sum_3
        - 16.0 * baseline_per_path_squared * product_7 * sigma_path_per_path_squared * sum_11
        - 16.0 * rho * sigma_beta * sigma_path_per_path * sum_12 * sum_1_squared
        - 16.0 * sin_beta * sum_1_squared_squared * sum_2 * sum_3
        - 48.0 * baseline_per_path_squared * product_4 * rho * sigma_beta * sin_beta_squared * sum_13
        - 48.0 * baseline_per_path_squared * product_7 * sigma_path_per_path_squared_squared
        - 8.0 * product_6 * rho * sigma_path_per_path * sum_14
        + 24.0 * baseline_per_path_squared * sigma_beta_squared * sigma_path_per_path_squared * sin_beta * sum_16
        + 48.0 * baseline_per_path_squared * rho_squared * sigma_beta_squared * sigma_path_per_path_squared * sin_beta * sum_16
        + 8.0 * sigma_beta_squared * sin_beta * sum_17 * sum_1_squared * sum_2 * sum_3
    )
    result = _empty(arguments, (2,))
    result[..., 0] = path * sum_10 * term_2
    result[..., 1] = path * sum_18 * term_2
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

    Accuracy: at most 502 ulp anywhere in this domain with independent errors, proved for elementary functions
    within 1 ulp (float64); with correlations up to 0.99 in size at most 58600. Errors are measured against
    the sum of the variances to first order of independent errors.
    """
    arguments = _floats(path, beta, baseline, sigma_path, sigma_beta, rho)
    path, beta, baseline, sigma_path, sigma_beta, rho = arguments
    term_1 = 1.0 / path
    baseline_per_path = baseline * term_1
    sigma_path_per_path = sigma_path * term_1
    cos_beta = np.cos(beta)
    product_1 = -2.0 * baseline_per_path * cos_beta
    divisor_1 = 2.0 + product_1
    sum_1 = 1.0 + baseline_per_path
    sum_1_squared = sum_1**2
    sum_2 = baseline_per_path - 1.0
    sum_2_squared = sum_2**2
    sigma_beta_squared = sigma_beta**2
    sin_beta = np.sin(beta)
    sin_beta_squared = sin_beta**2
    sum_3 = 1.0 + baseline_per_path**2 + product_1
    sum_3_squared = sum_3**2
    cos_beta_squared = cos_beta**2
    sigma_path_per_path_squared = sigma_path_per_path**2
    term_2 = 1.0 / (divisor_1**2)**2
    path_squared = path**2
    sum_4 = (
        4.0 * cos_beta_squared * sigma_path_per_path_squared * sum_3_squared
        + 4.0 * sigma_beta_squared * sin_beta_squared * sum_1_squared * sum_2_squared
        + 8.0 * cos_beta * rho * sigma_beta * sigma_path_per_path * sin_beta * sum_1 * sum_2 * sum_3
    )
    sum_5 = baseline_per_path - cos_beta
    sum_6 = 1.0 - 2.0 * cos_beta_squared + baseline_per_path * cos_beta
    sum_7 = (
        4.0 * cos_beta * sigma_path_per_path_squared * sin_beta * sum_3_squared
        + 4.0 * sigma_beta_squared * sin_beta * sum_1_squared * sum_2_squared * sum_5
        + 4.0 * rho * sigma_beta * sigma_path_per_path * sum_1 * sum_2 * sum_3 * sum_6
    )
    sum_8 = (
        4.0 * sigma_beta_squared * sum_1_squared * sum_2_squared * sum_5**2
        + 4.0 * sigma_path_per_path_squared * sin_beta_squared * sum_3_squared
        + 8.0 * rho * sigma_beta * sigma_path_per_path * sin_beta * sum_1 * sum_2 * sum_3 * sum_5
    )
    result = _empty(arguments, (2, 2))
    result[..., 0, 0] = path_squared * sum_4 * term_2
    result[..., 0, 1] = path_squared * sum_7 * term_2
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = path_squared * sum_8 * term_2
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

    Accuracy: at most 5100 ulp anywhere in this domain with independent errors, proved for elementary
    functions within 1 ulp (float64). Errors are measured against the sum of the variances to first order of
    independent errors.
    """
    arguments = _floats(path, beta, baseline, sigma_path, sigma_beta, rho)
    path, beta, baseline, sigma_path, sigma_beta, rho = arguments
    term_1 = 1.0 / path
    baseline_per_path = baseline * term_1
    sigma_path_per_path = sigma_path * term_1
    cos_beta = np.cos(beta)
    product_1 = -2.0 * baseline_per_path * cos_beta
    divisor_1 = 2.0 + product_1
    sum_1 = 1.0 + baseline_per_path
    sum_1_squared = sum_1**2
    sum_2 = baseline_per_path - 1.0
    sum_2_squared = sum_2**2
    baseline_per_path_squared = baseline_per_path**2
    product_2 = 2.0 * baseline_per_path * cos_beta
    sin_beta = np.sin(beta)
    sin_beta_squared = sin_beta**2
    product_3 = baseline_per_path_squared * sin_beta_squared
    sigma_beta_squared = sigma_beta**2
    sum_3 = product_2 - 1.0 - baseline_per_path_squared + product_3
    product_4 = baseline_per_path * baseline_per_path_squared**2
    cos_beta_squared = cos_beta**2
    product_5 = cos_beta * cos_beta_squared
    product_6 = -42.0 * baseline_per_path * product_5
    product_7 = cos_beta * cos_beta_squared**2
    product_8 = -6.0 * product_4 * product_7
    product_9 = baseline_per_path * baseline_per_path_squared
    baseline_per_path_squared_squared = baseline_per_path_squared**2
    cos_beta_squared_squared = cos_beta_squared**2
    baseline_per_path_squared_cubed = baseline_per_path_squared * baseline_per_path_squared**2
    product_10 = 14.0 * product_7 * product_9
    product_11 = 69.0 * baseline_per_path_squared * cos_beta_squared_squared
    rho_squared = rho**2
    sigma_path_per_path_squared = sigma_path_per_path**2
    sum_4 = (
        24.0 * cos_beta * product_9
        - 5.0
        - 30.0 * cos_beta * product_4
        - 37.0 * baseline_per_path_squared * cos_beta_squared
        - 6.0 * baseline_per_path_squared
        - 62.0 * product_5 * product_9
        - 64.0 * baseline_per_path_squared_squared * cos_beta_squared_squared
        - 9.0 * baseline_per_path_squared_cubed * cos_beta_squared
        - 9.0 * baseline_per_path_squared_squared
        + 30.0 * baseline_per_path * cos_beta
        + 40.0 * product_4 * product_5
        + 7.0 * baseline_per_path_squared_cubed * cos_beta_squared_squared
        + 7.0 * cos_beta_squared
        + 79.0 * baseline_per_path_squared_squared * cos_beta_squared
        + product_10
        + product_11
        + product_6
        + product_8
    )
    product_12 = -12.0 * baseline_per_path * product_5
    product_13 = 10.0 * product_7 * product_9
    product_14 = 24.0 * baseline_per_path_squared * cos_beta_squared_squared
    product_15 = 6.0 * baseline_per_path * cos_beta
    sum_5 = (
        12.0 * cos_beta * product_9
        - 1.0
        - 11.0 * baseline_per_path_squared * cos_beta_squared
        - 18.0 * cos_beta * product_4
        - 26.0 * baseline_per_path_squared_squared * cos_beta_squared_squared
        - 3.0 * baseline_per_path_squared_cubed * cos_beta_squared
        - 3.0 * baseline_per_path_squared_squared
        - 34.0 * product_5 * product_9
        + 2.0 * baseline_per_path_squared_cubed * cos_beta_squared_squared
        + 2.0 * cos_beta_squared
        + 26.0 * product_4 * product_5
        + 32.0 * baseline_per_path_squared_squared * cos_beta_squared
        + product_12
        + product_13
        + product_14
        + product_15
        + product_8
    )
    product_16 = sigma_path_per_path * sigma_path_per_path_squared
    sum_6 = (
        2.0 * cos_beta_squared
        - 1.0
        - 2.0 * baseline_per_path_squared
        - 2.0 * cos_beta * product_9
        - 6.0 * baseline_per_path * product_5
        + 3.0 * baseline_per_path * cos_beta
        + 5.0 * baseline_per_path_squared * cos_beta_squared
        + product_5 * product_9
    )
    product_17 = sigma_beta * sigma_beta_squared
    sum_7 = (
        20.0 * cos_beta_squared * product_9
        - 11.0 * baseline_per_path * cos_beta_squared
        - 12.0 * baseline_per_path_squared_squared * cos_beta
        - 12.0 * product_9
        - 17.0 * baseline_per_path_squared * product_5
        - 6.0 * baseline_per_path
        - cos_beta_squared_squared * product_9
        + 29.0 * baseline_per_path_squared * cos_beta
        + 5.0 * baseline_per_path_squared_squared * product_5
        + 5.0 * cos_beta
    )
    sum_8 = 1.0 + baseline_per_path_squared + product_1 + product_3
    sigma_path_per_path_squared_squared = sigma_path_per_path_squared**2
    sum_9 = 1.0 + baseline_per_path_squared + product_1
    sum_9_squared = sum_9**2
    product_18 = baseline_per_path * cos_beta
    term_2 = (product_18 - 1.0)**2
    product_19 = 14.0 * baseline_per_path * product_5
    product_20 = 5.0 * baseline_per_path_squared * cos_beta_squared_squared
    sigma_beta_squared_squared = sigma_beta_squared**2
    sum_10 = (
        24.0 * baseline_per_path_squared
        - 2.0
        - 20.0 * baseline_per_path * cos_beta
        - 26.0 * baseline_per_path_squared * cos_beta_squared
        + 5.0 * cos_beta_squared
        + product_19
        + product_20
    )
    term_3 = 1.0 / (divisor_1 * divisor_1**2)**2
    path_squared = path**2
    sum_11 = (
        16.0 * cos_beta_squared * sigma_path_per_path_squared * sum_9_squared * term_2
        - 16.0 * rho_squared * sigma_beta_squared * sigma_path_per_path_squared * sum_4
        - 16.0 * sigma_beta_squared * sigma_path_per_path_squared * sum_5
        - 16.0 * sigma_beta_squared * sin_beta_squared * sum_1_squared * sum_2_squared * sum_3
        - 192.0 * baseline_per_path_squared * cos_beta * product_16 * rho * sigma_beta * sin_beta * sum_6
        - 32.0 * product_17 * rho * sigma_path_per_path * sin_beta * sum_1 * sum_2 * sum_7
        - 96.0 * baseline_per_path_squared * sigma_path_per_path_squared_squared * (1.0 + sin_beta) * (sin_beta - 1.0) * sin_beta_squared * sum_8
        + 32.0 * cos_beta * rho * sigma_beta * sigma_path_per_path * sin_beta * sum_1 * sum_2 * sum_9 * term_2
        + 8.0 * sigma_beta_squared_squared * sum_10 * sum_1_squared * sum_2_squared
    )
    sum_12 = (
        14.0 * cos_beta_squared_squared * product_9
        - 24.0 * baseline_per_path_squared_cubed * cos_beta
        - 24.0 * product_4
        - 4.0 * product_9
        - 42.0 * baseline_per_path * cos_beta_squared
        - 6.0 * cos_beta_squared_squared * product_4
        - 74.0 * baseline_per_path_squared_squared * product_5
        - 86.0 * cos_beta_squared * product_9
        + 22.0 * baseline_per_path_squared * cos_beta
        + 68.0 * cos_beta_squared * product_4
        + 69.0 * baseline_per_path_squared * product_5
        + 7.0 * cos_beta
        + 71.0 * baseline_per_path_squared_squared * cos_beta
        + 9.0 * baseline_per_path_squared_cubed * product_5
    )
    sum_13 = (
        12.0 * baseline_per_path_squared * product_5
        - 17.0 * baseline_per_path_squared_squared * product_5
        - 17.0 * cos_beta_squared * product_9
        - 3.0 * cos_beta_squared_squared * product_4
        - 6.0 * baseline_per_path * cos_beta_squared
        - 6.0 * baseline_per_path_squared_cubed * cos_beta
        - 6.0 * product_4
        + 14.0 * baseline_per_path_squared_squared * cos_beta
        + 17.0 * cos_beta_squared * product_4
        + 2.0 * product_9
        + 3.0 * baseline_per_path_squared_cubed * product_5
        + 5.0 * cos_beta_squared_squared * product_9
        + baseline_per_path_squared * cos_beta
        + cos_beta
    )
    sum_14 = (
        11.0 * baseline_per_path
        - 14.0 * baseline_per_path * cos_beta_squared
        - 24.0 * product_9
        - 5.0 * baseline_per_path_squared * product_5
        - 5.0 * cos_beta
        + 11.0 * cos_beta_squared * product_9
        + 26.0 * baseline_per_path_squared * cos_beta
    )
    sum_15 = (
        10.0
        - 124.0 * baseline_per_path_squared * cos_beta_squared
        - 143.0 * product_5 * product_9
        - 2.0 * baseline_per_path_squared
        - 20.0 * cos_beta_squared
        - 24.0 * cos_beta * product_4
        - 28.0 * baseline_per_path_squared_squared * cos_beta_squared_squared
        - 3.0 * baseline_per_path * cos_beta
        - 72.0 * baseline_per_path_squared_squared
        + 104.0 * baseline_per_path_squared_squared * cos_beta_squared
        + 167.0 * cos_beta * product_9
        + 19.0 * product_4 * product_5
        + 4.0 * product_7 * product_9
        + 44.0 * baseline_per_path * product_5
        + 68.0 * baseline_per_path_squared * cos_beta_squared_squared
    )
    product_21 = sin_beta * sin_beta_squared
    sum_16 = baseline_per_path_squared * cos_beta_squared - 1.0 - 2.0 * baseline_per_path_squared + product_2
    sum_17 = baseline_per_path - cos_beta
    sum_18 = 1.0 - 2.0 * cos_beta_squared + product_18
    sum_19 = (
        10.0 * baseline_per_path * cos_beta
        - 3.0
        - 11.0 * baseline_per_path_squared
        - 12.0 * baseline_per_path * cos_beta * sin_beta_squared
        + 13.0 * baseline_per_path_squared * sin_beta_squared
        + 2.0 * cos_beta * product_9 * sin_beta_squared
        + 4.0 * cos_beta * product_9
        + 4.0 * sin_beta_squared
    )
    sum_20 = (
        16.0 * cos_beta * sigma_path_per_path_squared * sin_beta * sum_9_squared * term_2
        - 16.0 * rho_squared * sigma_beta_squared * sigma_path_per_path_squared * sin_beta * sum_12
        - 32.0 * sigma_beta_squared * sigma_path_per_path_squared * sin_beta * sum_13
        - 8.0 * product_17 * rho * sigma_path_per_path * sum_1 * sum_15 * sum_2
        - 8.0 * sigma_beta_squared_squared * sin_beta * sum_14 * sum_1_squared * sum_2_squared
        - 96.0 * baseline_per_path_squared * cos_beta * product_21 * sigma_path_per_path_squared_squared * sum_16
        + 16.0 * sigma_beta_squared * sin_beta * sum_17 * sum_1_squared * sum_2_squared * term_2
        + 16.0 * rho * sigma_beta * sigma_path_per_path * sum_1 * sum_18 * sum_2 * sum_9 * term_2
        + 96.0 * baseline_per_path_squared * product_16 * rho * sigma_beta * sin_beta_squared * sum_19
    )
    sum_21 = (
        106.0 * baseline_per_path_squared_squared * cos_beta
        - 10.0 * cos_beta
        - 101.0 * cos_beta_squared * product_9
        - 18.0 * baseline_per_path_squared_squared * product_5
        - 32.0 * baseline_per_path_squared * cos_beta
        - 48.0 * product_4
        + 19.0 * cos_beta_squared * product_4
        + 19.0 * product_9
        + 2.0 * cos_beta_squared_squared * product_9
        + 22.0 * baseline_per_path * cos_beta_squared
        + 34.0 * baseline_per_path_squared * product_5
        + 7.0 * baseline_per_path
    )
    sum_22 = (
        20.0 * baseline_per_path_squared
        - 3.0
        - 16.0 * baseline_per_path * cos_beta
        - 22.0 * product_5 * product_9
        - 24.0 * baseline_per_path_squared_squared
        - 31.0 * baseline_per_path_squared * cos_beta_squared
        + 20.0 * baseline_per_path_squared_squared * cos_beta_squared
        + 32.0 * cos_beta * product_9
        + 5.0 * cos_beta_squared
        + product_19
        + product_20
    )
    sum_23 = (
        10.0 * cos_beta * product_9
        - 2.0
        - 12.0 * baseline_per_path_squared_squared
        - 124.0 * product_5 * product_9
        - 126.0 * cos_beta * product_4
        - 54.0 * baseline_per_path_squared_cubed * cos_beta_squared
        - 6.0 * baseline_per_path_squared
        - 84.0 * baseline_per_path_squared_squared * cos_beta_squared_squared
        + 102.0 * product_4 * product_5
        + 11.0 * baseline_per_path_squared_cubed * cos_beta_squared_squared
        + 12.0 * baseline_per_path * cos_beta
        + 12.0 * baseline_per_path_squared * cos_beta_squared
        + 171.0 * baseline_per_path_squared_squared * cos_beta_squared
        + 48.0 * baseline_per_path_squared_cubed
        + 7.0 * cos_beta_squared
        + product_10
        + product_11
        + product_6
        + product_8
    )
    sum_24 = (
        10.0 * baseline_per_path_squared_cubed * cos_beta_squared_squared
        - 1.0
        - 15.0 * baseline_per_path_squared_squared
        - 33.0 * baseline_per_path_squared_cubed * cos_beta_squared
        - 42.0 * baseline_per_path_squared_squared * cos_beta_squared_squared
        - 44.0 * product_5 * product_9
        - 48.0 * cos_beta * product_4
        - 9.0 * baseline_per_path_squared * cos_beta_squared
        + 14.0 * cos_beta * product_9
        + 2.0 * cos_beta_squared
        + 24.0 * baseline_per_path_squared_cubed
        + 48.0 * product_4 * product_5
        + 72.0 * baseline_per_path_squared_squared * cos_beta_squared
        + product_12
        + product_13
        + product_14
        + product_15
        + product_8
    )
    sum_25 = (
        3.0 * product_9
        - 2.0 * cos_beta
        - 6.0 * baseline_per_path * sin_beta_squared
        - 8.0 * baseline_per_path_squared * cos_beta
        + 7.0 * baseline_per_path
        + product_9 * sin_beta_squared
    )
    sum_26 = (
        16.0 * rho_squared * sigma_beta_squared * sigma_path_per_path_squared * sum_23
        - 16.0 * product_17 * rho * sigma_path_per_path * sin_beta * sum_1 * sum_2 * sum_21
        - 8.0 * sigma_beta_squared_squared * sum_1_squared * sum_22 * sum_2_squared
        + 16.0 * sigma_beta_squared * sigma_path_per_path_squared * sum_24
        + 16.0 * sigma_beta_squared * sum_17**2 * sum_1_squared * sum_2_squared * term_2
        + 16.0 * sigma_path_per_path_squared * sin_beta_squared * sum_9_squared * term_2
        + 192.0 * baseline_per_path_squared * product_16 * product_21 * rho * sigma_beta * sum_25
        + 32.0 * rho * sigma_beta * sigma_path_per_path * sin_beta * sum_1 * sum_17 * sum_2 * sum_9 * term_2
        + 96.0 * baseline_per_path_squared * sigma_path_per_path_squared_squared * sin_beta_squared**2 * sum_8
    )
    result = _empty(arguments, (2, 2))
    result[..., 0, 0] = path_squared * sum_11 * term_3
    result[..., 0, 1] = path_squared * sum_20 * term_3
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = path_squared * sum_26 * term_3
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

    Accuracy: at most 86.3 ulp anywhere in this domain with independent errors, proved for elementary
    functions within 1 ulp (float64); with correlations up to 0.99 in size at most 196.
    """
    arguments = _floats(path, beta, baseline, sigma_path, sigma_beta, rho)
    path, beta, baseline, sigma_path, sigma_beta, rho = arguments
    term_1 = 1.0 / path
    baseline_per_path = baseline * term_1
    sigma_path_per_path = sigma_path * term_1
    cos_beta = np.cos(beta)
    divisor_1 = 2.0 - 2.0 * baseline_per_path * cos_beta
    term_2 = (baseline_per_path * cos_beta - 1.0)**2
    sum_1 = 1.0 + baseline_per_path
    sum_2 = baseline_per_path - 1.0
    baseline_per_path_squared = baseline_per_path**2
    sigma_path_per_path_squared = sigma_path_per_path**2
    sin_beta = np.sin(beta)
    sin_beta_squared = sin_beta**2
    product_1 = baseline_per_path * baseline_per_path_squared
    sum_3 = 1.0 - 3.0 * baseline_per_path * cos_beta + baseline_per_path_squared + cos_beta * product_1
    cos_beta_squared = cos_beta**2
    sigma_beta_squared = sigma_beta**2
    sum_4 = baseline_per_path * cos_beta_squared - 2.0 * baseline_per_path + cos_beta
    term_3 = 1.0 / (divisor_1 * divisor_1**2)
    sum_5 = (
        2.0 * sigma_beta_squared * sum_1 * sum_2 * sum_4
        - 4.0 * baseline_per_path_squared * cos_beta * sigma_path_per_path_squared * sin_beta_squared
        - 4.0 * cos_beta * sum_1 * sum_2 * term_2
        - 4.0 * rho * sigma_beta * sigma_path_per_path * sin_beta * sum_3
    )
    sum_6 = 2.0 * baseline_per_path_squared - 1.0 - baseline_per_path * cos_beta
    sum_7 = (
        3.0 * baseline_per_path_squared * cos_beta
        - 2.0 * product_1
        - 3.0 * baseline_per_path * cos_beta_squared
        + cos_beta
        + cos_beta_squared * product_1
    )
    sum_8 = (
        4.0 * rho * sigma_beta * sigma_path_per_path * sum_7
        - 2.0 * sigma_beta_squared * sin_beta * sum_1 * sum_2 * sum_6
        - 4.0 * baseline_per_path_squared * sigma_path_per_path_squared * sin_beta * sin_beta_squared
        - 4.0 * sin_beta * sum_1 * sum_2 * term_2
    )
    result = _empty(arguments, (2,))
    result[..., 0] = path * sum_5 * term_3
    result[..., 1] = path * sum_8 * term_3
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

    Accuracy: at most 278 ulp anywhere in this domain with independent errors, proved for elementary functions
    within 1 ulp (float64).
    """
    arguments = _floats(path, beta, baseline, sigma_path, sigma_beta, rho)
    path, beta, baseline, sigma_path, sigma_beta, rho = arguments
    term_1 = 1.0 / path
    baseline_per_path = baseline * term_1
    sigma_path_per_path = sigma_path * term_1
    cos_beta = np.cos(beta)
    divisor_1 = 2.0 - 2.0 * baseline_per_path * cos_beta
    sum_1 = baseline_per_path * cos_beta - 1.0
    sum_1_squared = sum_1**2
    sum_1_squared_squared = sum_1_squared**2
    sum_2 = 1.0 + baseline_per_path
    sum_3 = baseline_per_path - 1.0
    baseline_per_path_squared = baseline_per_path**2
    sigma_path_per_path_squared = sigma_path_per_path**2
    sin_beta = np.sin(beta)
    sin_beta_squared = sin_beta**2
    product_1 = -3.0 * baseline_per_path * cos_beta
    product_2 = baseline_per_path * baseline_per_path_squared
    sum_4 = 1.0 + baseline_per_path_squared + cos_beta * product_2 + product_1
    cos_beta_squared = cos_beta**2
    product_3 = cos_beta * cos_beta_squared
    cos_beta_squared_squared = cos_beta_squared**2
    sigma_beta_squared = sigma_beta**2
    sigma_beta_squared_squared = sigma_beta_squared**2
    sum_5 = (
        11.0 * baseline_per_path * cos_beta_squared
        - 20.0 * baseline_per_path_squared * cos_beta
        - 20.0 * cos_beta_squared * product_2
        - 8.0 * baseline_per_path
        + 11.0 * baseline_per_path_squared * product_3
        + 24.0 * product_2
        + cos_beta
        + cos_beta_squared_squared * product_2
    )
    sigma_path_per_path_squared_squared = sigma_path_per_path_squared**2
    sum_6 = (
        13.0 * baseline_per_path * cos_beta_squared
        - 3.0 * baseline_per_path * cos_beta_squared_squared
        - 6.0 * baseline_per_path
        - 6.0 * baseline_per_path_squared * cos_beta
        - 9.0 * product_3
        + 4.0 * baseline_per_path_squared * product_3
        + 7.0 * cos_beta
    )
    rho_squared = rho**2
    product_4 = sigma_path_per_path * sigma_path_per_path_squared
    sum_7 = 3.0 * cos_beta_squared - 1.0 + baseline_per_path * product_3 + product_1
    sum_8 = baseline_per_path * cos_beta_squared - 2.0 * baseline_per_path + cos_beta
    baseline_per_path_squared_squared = baseline_per_path_squared**2
    product_5 = baseline_per_path * baseline_per_path_squared**2
    product_6 = sigma_beta * sigma_beta_squared
    sum_9 = (
        1.0
        - 17.0 * baseline_per_path_squared * cos_beta_squared
        - 18.0 * baseline_per_path_squared_squared
        - 3.0 * product_2 * product_3
        - 5.0 * baseline_per_path * cos_beta
        - 6.0 * cos_beta * product_5
        + 11.0 * baseline_per_path_squared_squared * cos_beta_squared
        + 29.0 * cos_beta * product_2
        + 7.0 * baseline_per_path_squared
        + product_3 * product_5
    )
    term_2 = 1.0 / (divisor_1 * (divisor_1**2)**2)
    sum_10 = (
        16.0 * baseline_per_path_squared * rho_squared * sigma_beta_squared * sigma_path_per_path_squared * sum_6
        - 16.0 * baseline_per_path_squared * cos_beta * sigma_path_per_path_squared * sin_beta_squared * sum_1_squared
        - 16.0 * cos_beta * sum_1_squared_squared * sum_2 * sum_3
        - 16.0 * rho * sigma_beta * sigma_path_per_path * sin_beta * sum_1_squared * sum_4
        - 2.0 * sigma_beta_squared_squared * sum_2 * sum_3 * sum_5
        - 48.0 * baseline_per_path_squared * cos_beta * sigma_path_per_path_squared_squared * sin_beta_squared
        + 48.0 * baseline_per_path_squared * product_4 * rho * sigma_beta * sin_beta * sum_7
        + 8.0 * baseline_per_path_squared * sigma_beta_squared * sigma_path_per_path_squared * sum_6
        + 8.0 * product_6 * rho * sigma_path_per_path * sin_beta * sum_9
        + 8.0 * sigma_beta_squared * sum_1_squared * sum_2 * sum_3 * sum_8
    )
    sum_11 = 3.0 * baseline_per_path - 3.0 * cos_beta + baseline_per_path * sin_beta_squared
    product_7 = sin_beta * sin_beta_squared
    sum_12 = 2.0 * baseline_per_path_squared - 1.0 - baseline_per_path * cos_beta
    sum_13 = (
        19.0 * baseline_per_path_squared_squared * product_3
        - 17.0 * baseline_per_path_squared * product_3
        - 20.0 * cos_beta_squared * product_5
        - 20.0 * product_2
        - 3.0 * cos_beta_squared_squared * product_2
        - 32.0 * baseline_per_path_squared_squared * cos_beta
        - 5.0 * baseline_per_path * cos_beta_squared
        + 21.0 * baseline_per_path_squared * cos_beta
        + 24.0 * product_5
        + 31.0 * cos_beta_squared * product_2
        + cos_beta
        + cos_beta_squared_squared * product_5
    )
    sum_14 = (
        2.0 * baseline_per_path * cos_beta
        - 1.0
        - baseline_per_path_squared
        + baseline_per_path_squared * sin_beta_squared
    )
    sum_15 = (
        3.0 * baseline_per_path_squared * cos_beta
        - 2.0 * product_2
        - 3.0 * baseline_per_path * cos_beta_squared
        + cos_beta
        + cos_beta_squared * product_2
    )
    sum_16 = (
        20.0 * baseline_per_path_squared
        - 1.0
        - 11.0 * baseline_per_path * cos_beta
        - 11.0 * baseline_per_path_squared * cos_beta_squared
        - 24.0 * baseline_per_path_squared_squared
        - product_2 * product_3
        + 20.0 * cos_beta * product_2
        + 8.0 * baseline_per_path_squared_squared * cos_beta_squared
    )
    sum_17 = (
        1.0
        - 3.0 * cos_beta_squared
        - 4.0 * baseline_per_path_squared
        - baseline_per_path * product_3
        + 2.0 * baseline_per_path_squared * cos_beta_squared
        + 5.0 * baseline_per_path * cos_beta
    )
    sum_18 = (
        16.0 * baseline_per_path_squared * product_7 * sigma_path_per_path_squared * sum_14
        - 16.0 * sin_beta * sum_1_squared_squared * sum_2 * sum_3
        - 48.0 * baseline_per_path_squared * product_4 * rho * sigma_beta * sin_beta_squared * sum_11
        - 48.0 * baseline_per_path_squared * product_7 * sigma_path_per_path_squared_squared
        - 8.0 * product_6 * rho * sigma_path_per_path * sum_13
        - 8.0 * sigma_beta_squared * sin_beta * sum_12 * sum_1_squared * sum_2 * sum_3
        + 16.0 * rho * sigma_beta * sigma_path_per_path * sum_15 * sum_1_squared
        + 2.0 * sigma_beta_squared_squared * sin_beta * sum_16 * sum_2 * sum_3
        + 24.0 * baseline_per_path_squared * sigma_beta_squared * sigma_path_per_path_squared * sin_beta * sum_17
        + 48.0 * baseline_per_path_squared * rho_squared * sigma_beta_squared * sigma_path_per_path_squared * sin_beta * sum_17
    )
    result = _empty(arguments, (2,))
    result[..., 0] = path * sum_10 * term_2
    result[..., 1] = path * sum_18 * term_2
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

    Accuracy: at most 502 ulp anywhere in this domain with independent errors, proved for elementary functions
    within 1 ulp (float64); with correlations up to 0.99 in size at most 58600. Errors are measured against
    the sum of the variances to first order of independent errors.
    """
    arguments = _floats(path, beta, baseline, sigma_path, sigma_beta, rho)
    path, beta, baseline, sigma_path, sigma_beta, rho = arguments
    term_1 = 1.0 / path
    baseline_per_path = baseline * term_1
    sigma_path_per_path = sigma_path * term_1
    cos_beta = np.cos(beta)
    product_1 = -2.0 * baseline_per_path * cos_beta
    divisor_1 = 2.0 + product_1
    sum_1 = 1.0 + baseline_per_path
    sum_1_squared = sum_1**2
    sum_2 = baseline_per_path - 1.0
    sum_2_squared = sum_2**2
    sigma_beta_squared = sigma_beta**2
    sin_beta = np.sin(beta)
    sin_beta_squared = sin_beta**2
    sum_3 = 1.0 + baseline_per_path**2 + product_1
    sum_3_squared = sum_3**2
    cos_beta_squared = cos_beta**2
    sigma_path_per_path_squared = sigma_path_per_path**2
    term_2 = 1.0 / (divisor_1**2)**2
    path_squared = path**2
    sum_4 = (
        4.0 * cos_beta_squared * sigma_path_per_path_squared * sum_3_squared
        + 4.0 * sigma_beta_squared * sin_beta_squared * sum_1_squared * sum_2_squared
        + 8.0 * cos_beta * rho * sigma_beta * sigma_path_per_path * sin_beta * sum_1 * sum_2 * sum_3
    )
    sum_5 = baseline_per_path - cos_beta
    sum_6 = 1.0 - 2.0 * cos_beta_squared + baseline_per_path * cos_beta
    sum_7 = (
        4.0 * cos_beta * sigma_path_per_path_squared * sin_beta * sum_3_squared
        + 4.0 * sigma_beta_squared * sin_beta * sum_1_squared * sum_2_squared * sum_5
        + 4.0 * rho * sigma_beta * sigma_path_per_path * sum_1 * sum_2 * sum_3 * sum_6
    )
    sum_8 = (
        4.0 * sigma_beta_squared * sum_1_squared * sum_2_squared * sum_5**2
        + 4.0 * sigma_path_per_path_squared * sin_beta_squared * sum_3_squared
        + 8.0 * rho * sigma_beta * sigma_path_per_path * sin_beta * sum_1 * sum_2 * sum_3 * sum_5
    )
    result = _empty(arguments, (2, 2))
    result[..., 0, 0] = path_squared * sum_4 * term_2
    result[..., 0, 1] = path_squared * sum_7 * term_2
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = path_squared * sum_8 * term_2
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

    Accuracy: at most 4660 ulp anywhere in this domain with independent errors, proved for elementary
    functions within 1 ulp (float64). Errors are measured against the sum of the variances to first order of
    independent errors.
    """
    arguments = _floats(path, beta, baseline, sigma_path, sigma_beta, rho)
    path, beta, baseline, sigma_path, sigma_beta, rho = arguments
    term_1 = 1.0 / path
    baseline_per_path = baseline * term_1
    sigma_path_per_path = sigma_path * term_1
    cos_beta = np.cos(beta)
    product_1 = -2.0 * baseline_per_path * cos_beta
    divisor_1 = 2.0 + product_1
    sum_1 = 1.0 + baseline_per_path
    sum_1_squared = sum_1**2
    sum_2 = baseline_per_path - 1.0
    sum_2_squared = sum_2**2
    baseline_per_path_squared = baseline_per_path**2
    sin_beta = np.sin(beta)
    sin_beta_squared = sin_beta**2
    product_2 = baseline_per_path_squared * sin_beta_squared
    sigma_beta_squared = sigma_beta**2
    sum_3 = 2.0 * baseline_per_path * cos_beta - 1.0 - baseline_per_path_squared + product_2
    cos_beta_squared = cos_beta**2
    product_3 = cos_beta * cos_beta_squared
    product_4 = -18.0 * baseline_per_path * product_3
    product_5 = baseline_per_path * baseline_per_path_squared**2
    baseline_per_path_squared_squared = baseline_per_path_squared**2
    cos_beta_squared_squared = cos_beta_squared**2
    product_6 = baseline_per_path * baseline_per_path_squared
    baseline_per_path_squared_cubed = baseline_per_path_squared * baseline_per_path_squared**2
    product_7 = cos_beta * cos_beta_squared**2
    product_8 = -6.0 * product_5 * product_7
    product_9 = 14.0 * product_6 * product_7
    product_10 = 33.0 * baseline_per_path_squared * cos_beta_squared_squared
    product_11 = 6.0 * baseline_per_path * cos_beta
    rho_squared = rho**2
    sigma_path_per_path_squared = sigma_path_per_path**2
    sum_4 = (
        2.0 * baseline_per_path_squared
        - 1.0
        - 22.0 * cos_beta * product_5
        - 40.0 * baseline_per_path_squared_squared * cos_beta_squared_squared
        - 46.0 * product_3 * product_6
        - 5.0 * baseline_per_path_squared_cubed * cos_beta_squared
        - 5.0 * baseline_per_path_squared_squared
        - 9.0 * baseline_per_path_squared * cos_beta_squared
        + 3.0 * baseline_per_path_squared_cubed * cos_beta_squared_squared
        + 3.0 * cos_beta_squared
        + 32.0 * product_3 * product_5
        + 51.0 * baseline_per_path_squared_squared * cos_beta_squared
        + 8.0 * cos_beta * product_6
        + product_10
        + product_11
        + product_4
        + product_8
        + product_9
    )
    product_12 = -12.0 * baseline_per_path * product_3
    product_13 = -2.0 * product_5 * product_7
    product_14 = 2.0 * baseline_per_path_squared_cubed * cos_beta_squared_squared
    product_15 = 20.0 * baseline_per_path_squared * cos_beta_squared_squared
    product_16 = 6.0 * product_6 * product_7
    sum_5 = (
        14.0 * product_3 * product_5
        - 1.0
        - 10.0 * cos_beta * product_5
        - 22.0 * baseline_per_path_squared_squared * cos_beta_squared_squared
        - 22.0 * product_3 * product_6
        - 3.0 * baseline_per_path_squared_cubed * cos_beta_squared
        - 3.0 * baseline_per_path_squared_squared
        - 7.0 * baseline_per_path_squared * cos_beta_squared
        + 2.0 * cos_beta_squared
        + 28.0 * baseline_per_path_squared_squared * cos_beta_squared
        + 4.0 * cos_beta * product_6
        + product_11
        + product_12
        + product_13
        + product_14
        + product_15
        + product_16
    )
    product_17 = sigma_beta * sigma_beta_squared
    sum_6 = (
        15.0 * baseline_per_path_squared * cos_beta
        - 11.0 * baseline_per_path_squared * product_3
        - 2.0 * baseline_per_path
        - 7.0 * baseline_per_path * cos_beta_squared
        - 8.0 * baseline_per_path_squared_squared * cos_beta
        - 8.0 * product_6
        - cos_beta_squared_squared * product_6
        + 16.0 * cos_beta_squared * product_6
        + 3.0 * baseline_per_path_squared_squared * product_3
        + 3.0 * cos_beta
    )
    product_18 = sigma_path_per_path * sigma_path_per_path_squared
    sum_7 = (
        13.0 * baseline_per_path_squared * cos_beta_squared
        - 1.0
        - 4.0 * baseline_per_path_squared
        - 4.0 * cos_beta * product_6
        + 3.0 * baseline_per_path * cos_beta
        + 4.0 * cos_beta_squared
        + product_12
        + product_3 * product_6
    )
    sum_8 = 1.0 + baseline_per_path_squared + product_1
    sum_8_squared = sum_8**2
    product_19 = baseline_per_path * cos_beta
    term_2 = (product_19 - 1.0)**2
    sum_9 = baseline_per_path_squared * cos_beta_squared - 3.0 - 4.0 * baseline_per_path_squared + product_11
    sigma_path_per_path_squared_squared = sigma_path_per_path_squared**2
    product_20 = -12.0 * baseline_per_path * cos_beta
    product_21 = 10.0 * baseline_per_path * product_3
    product_22 = 3.0 * baseline_per_path_squared * cos_beta_squared_squared
    sigma_beta_squared_squared = sigma_beta_squared**2
    sum_10 = (
        16.0 * baseline_per_path_squared
        - 2.0
        - 18.0 * baseline_per_path_squared * cos_beta_squared
        + 3.0 * cos_beta_squared
        + product_20
        + product_21
        + product_22
    )
    term_3 = 1.0 / (divisor_1 * divisor_1**2)**2
    path_squared = path**2
    sum_11 = (
        16.0 * cos_beta_squared * sigma_path_per_path_squared * sum_8_squared * term_2
        - 16.0 * rho_squared * sigma_beta_squared * sigma_path_per_path_squared * sum_4
        - 16.0 * sigma_beta_squared * sigma_path_per_path_squared * sum_5
        - 16.0 * sigma_beta_squared * sin_beta_squared * sum_1_squared * sum_2_squared * sum_3
        - 32.0 * product_17 * rho * sigma_path_per_path * sin_beta * sum_1 * sum_2 * sum_6
        - 64.0 * baseline_per_path_squared * cos_beta * product_18 * rho * sigma_beta * sin_beta * sum_7
        + 32.0 * baseline_per_path_squared * (1.0 + cos_beta) * (cos_beta - 1.0) * cos_beta_squared * sigma_path_per_path_squared_squared * sum_9
        + 32.0 * cos_beta * rho * sigma_beta * sigma_path_per_path * sin_beta * sum_1 * sum_2 * sum_8 * term_2
        + 8.0 * sigma_beta_squared_squared * sum_10 * sum_1_squared * sum_2_squared
    )
    product_23 = 6.0 * baseline_per_path_squared * cos_beta
    sum_12 = (
        14.0 * cos_beta_squared_squared * product_6
        - 16.0 * baseline_per_path_squared_cubed * cos_beta
        - 16.0 * product_5
        - 18.0 * baseline_per_path * cos_beta_squared
        - 46.0 * cos_beta_squared * product_6
        - 50.0 * baseline_per_path_squared_squared * product_3
        - 6.0 * cos_beta_squared_squared * product_5
        + 3.0 * cos_beta
        + 33.0 * baseline_per_path_squared * product_3
        + 35.0 * baseline_per_path_squared_squared * cos_beta
        + 4.0 * product_6
        + 5.0 * baseline_per_path_squared_cubed * product_3
        + 52.0 * cos_beta_squared * product_5
        + product_23
    )
    sum_13 = (
        2.0 * product_3 * product_6
        - 1.0
        - 12.0 * cos_beta * product_6
        - 24.0 * baseline_per_path * product_3
        - 4.0 * baseline_per_path_squared
        + 31.0 * baseline_per_path_squared * cos_beta_squared
        + 8.0 * cos_beta_squared
    )
    product_24 = sin_beta * sin_beta_squared
    sum_14 = (
        10.0 * baseline_per_path_squared * product_3
        - 13.0 * baseline_per_path_squared_squared * product_3
        - 13.0 * cos_beta_squared * product_6
        - 4.0 * baseline_per_path_squared_cubed * cos_beta
        - 4.0 * product_5
        - 6.0 * baseline_per_path * cos_beta_squared
        - cos_beta_squared_squared * product_5
        + 10.0 * baseline_per_path_squared_squared * cos_beta
        + 13.0 * cos_beta_squared * product_5
        + 3.0 * baseline_per_path_squared * cos_beta
        + 3.0 * cos_beta_squared_squared * product_6
        + baseline_per_path_squared_cubed * product_3
        + cos_beta
    )
    sum_15 = (
        18.0 * baseline_per_path_squared * cos_beta
        - 10.0 * baseline_per_path * cos_beta_squared
        - 16.0 * product_6
        - 3.0 * baseline_per_path_squared * product_3
        - 3.0 * cos_beta
        + 7.0 * baseline_per_path
        + 7.0 * cos_beta_squared * product_6
    )
    sum_16 = (
        6.0
        - 12.0 * cos_beta_squared
        - 16.0 * cos_beta * product_5
        - 20.0 * baseline_per_path_squared_squared * cos_beta_squared_squared
        - 3.0 * baseline_per_path * cos_beta
        - 48.0 * baseline_per_path_squared_squared
        - 80.0 * baseline_per_path_squared * cos_beta_squared
        - 95.0 * product_3 * product_6
        + 103.0 * cos_beta * product_6
        + 11.0 * product_3 * product_5
        + 2.0 * baseline_per_path_squared
        + 28.0 * baseline_per_path * product_3
        + 4.0 * product_6 * product_7
        + 44.0 * baseline_per_path_squared * cos_beta_squared_squared
        + 76.0 * baseline_per_path_squared_squared * cos_beta_squared
    )
    sum_17 = baseline_per_path - cos_beta
    sum_18 = 1.0 - 2.0 * cos_beta_squared + product_19
    sum_19 = (
        16.0 * cos_beta * sigma_path_per_path_squared * sin_beta * sum_8_squared * term_2
        - 16.0 * rho_squared * sigma_beta_squared * sigma_path_per_path_squared * sin_beta * sum_12
        - 32.0 * baseline_per_path_squared * cos_beta * product_24 * sigma_path_per_path_squared_squared * sum_9
        - 32.0 * baseline_per_path_squared * product_18 * rho * sigma_beta * sin_beta_squared * sum_13
        - 32.0 * sigma_beta_squared * sigma_path_per_path_squared * sin_beta * sum_14
        - 8.0 * product_17 * rho * sigma_path_per_path * sum_1 * sum_16 * sum_2
        - 8.0 * sigma_beta_squared_squared * sin_beta * sum_15 * sum_1_squared * sum_2_squared
        + 16.0 * sigma_beta_squared * sin_beta * sum_17 * sum_1_squared * sum_2_squared * term_2
        + 16.0 * rho * sigma_beta * sigma_path_per_path * sum_1 * sum_18 * sum_2 * sum_8 * term_2
    )
    sum_20 = (
        12.0 * baseline_per_path_squared
        - 1.0
        - 14.0 * product_3 * product_6
        - 16.0 * baseline_per_path_squared_squared
        - 21.0 * baseline_per_path_squared * cos_beta_squared
        + 12.0 * baseline_per_path_squared_squared * cos_beta_squared
        + 24.0 * cos_beta * product_6
        + 3.0 * cos_beta_squared
        + product_20
        + product_21
        + product_22
    )
    sum_21 = (
        12.0 * baseline_per_path * cos_beta
        - 2.0
        - 12.0 * baseline_per_path_squared * cos_beta_squared
        - 12.0 * baseline_per_path_squared_squared
        - 38.0 * baseline_per_path_squared_cubed * cos_beta_squared
        - 6.0 * baseline_per_path_squared
        - 60.0 * baseline_per_path_squared_squared * cos_beta_squared_squared
        - 60.0 * product_3 * product_6
        - 78.0 * cos_beta * product_5
        + 26.0 * cos_beta * product_6
        + 3.0 * cos_beta_squared
        + 32.0 * baseline_per_path_squared_cubed
        + 7.0 * baseline_per_path_squared_cubed * cos_beta_squared_squared
        + 78.0 * product_3 * product_5
        + 87.0 * baseline_per_path_squared_squared * cos_beta_squared
        + product_10
        + product_4
        + product_8
        + product_9
    )
    sum_22 = (
        10.0 * cos_beta * product_6
        - 1.0
        - 17.0 * baseline_per_path_squared_cubed * cos_beta_squared
        - 3.0 * baseline_per_path_squared_squared
        - 30.0 * baseline_per_path_squared_squared * cos_beta_squared_squared
        - 36.0 * product_3 * product_6
        - 4.0 * baseline_per_path_squared
        - 44.0 * cos_beta * product_5
        - baseline_per_path_squared * cos_beta_squared
        + 16.0 * baseline_per_path_squared_cubed
        + 2.0 * cos_beta_squared
        + 40.0 * product_3 * product_5
        + 48.0 * baseline_per_path_squared_squared * cos_beta_squared
        + product_11
        + product_12
        + product_13
        + product_14
        + product_15
        + product_16
    )
    sin_beta_squared_squared = sin_beta_squared**2
    sum_23 = (
        11.0 * product_5 * sin_beta_squared
        - 14.0 * baseline_per_path_squared_squared * cos_beta * sin_beta_squared
        - 2.0 * product_6 * sin_beta_squared_squared
        - 21.0 * baseline_per_path
        - 57.0 * product_6 * sin_beta_squared
        - 60.0 * baseline_per_path_squared_squared * cos_beta
        + 14.0 * baseline_per_path * sin_beta_squared
        + 21.0 * product_5
        + 22.0 * baseline_per_path_squared * cos_beta * sin_beta_squared
        + 48.0 * product_6
        + 6.0 * cos_beta
        + product_23
    )
    sum_24 = 3.0 - 6.0 * baseline_per_path * cos_beta + 3.0 * baseline_per_path_squared + product_2
    sum_25 = (
        15.0 * baseline_per_path
        - 12.0 * baseline_per_path * sin_beta_squared
        - 18.0 * baseline_per_path_squared * cos_beta
        - 4.0 * cos_beta
        + 7.0 * product_6
        + product_6 * sin_beta_squared
    )
    sum_26 = (
        16.0 * product_17 * rho * sigma_path_per_path * sin_beta * sum_1 * sum_2 * sum_23
        - 8.0 * sigma_beta_squared_squared * sum_1_squared * sum_20 * sum_2_squared
        + 16.0 * rho_squared * sigma_beta_squared * sigma_path_per_path_squared * sum_21
        + 16.0 * sigma_beta_squared * sigma_path_per_path_squared * sum_22
        + 16.0 * sigma_beta_squared * sum_17**2 * sum_1_squared * sum_2_squared * term_2
        + 16.0 * sigma_path_per_path_squared * sin_beta_squared * sum_8_squared * term_2
        + 32.0 * baseline_per_path_squared * sigma_path_per_path_squared_squared * sin_beta_squared_squared * sum_24
        + 32.0 * rho * sigma_beta * sigma_path_per_path * sin_beta * sum_1 * sum_17 * sum_2 * sum_8 * term_2
        + 64.0 * baseline_per_path_squared * product_18 * product_24 * rho * sigma_beta * sum_25
    )
    result = _empty(arguments, (2, 2))
    result[..., 0, 0] = path_squared * sum_11 * term_3
    result[..., 0, 1] = path_squared * sum_19 * term_3
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = path_squared * sum_26 * term_3
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

    Accuracy: at most 458 ulp anywhere in this domain with independent errors, proved for elementary functions
    within 1 ulp (float64). Errors are measured against the sum of the variances to first order of independent
    errors.
    """
    arguments = _floats(path, beta, baseline, sigma_path, sigma_beta, rho, predicted_sigma_path, predicted_sigma_beta, predicted_rho)
    path, beta, baseline, sigma_path, sigma_beta, rho, predicted_sigma_path, predicted_sigma_beta, predicted_rho = arguments
    term_1 = 1.0 / path
    baseline_per_path = baseline * term_1
    sigma_path_per_path = sigma_path * term_1
    cos_beta = np.cos(beta)
    product_1 = -2.0 * baseline_per_path * cos_beta
    divisor_1 = 2.0 + product_1
    sum_1 = 1.0 + baseline_per_path
    sum_1_squared = sum_1**2
    sum_2 = baseline_per_path - 1.0
    sum_2_squared = sum_2**2
    sigma_beta_squared = sigma_beta**2
    sin_beta = np.sin(beta)
    sin_beta_squared = sin_beta**2
    sum_3 = 1.0 + baseline_per_path**2 + product_1
    sum_3_squared = sum_3**2
    cos_beta_squared = cos_beta**2
    sigma_path_per_path_squared = sigma_path_per_path**2
    term_2 = 1.0 / (divisor_1**2)**2
    path_squared = path**2
    sum_4 = (
        4.0 * cos_beta_squared * sigma_path_per_path_squared * sum_3_squared
        + 4.0 * sigma_beta_squared * sin_beta_squared * sum_1_squared * sum_2_squared
        + 8.0 * cos_beta * rho * sigma_beta * sigma_path_per_path * sin_beta * sum_1 * sum_2 * sum_3
    )
    sum_5 = baseline_per_path - cos_beta
    sum_6 = 1.0 - 2.0 * cos_beta_squared + baseline_per_path * cos_beta
    sum_7 = (
        4.0 * cos_beta * sigma_path_per_path_squared * sin_beta * sum_3_squared
        + 4.0 * sigma_beta_squared * sin_beta * sum_1_squared * sum_2_squared * sum_5
        + 4.0 * rho * sigma_beta * sigma_path_per_path * sum_1 * sum_2 * sum_3 * sum_6
    )
    sum_8 = (
        4.0 * sigma_beta_squared * sum_1_squared * sum_2_squared * sum_5**2
        + 4.0 * sigma_path_per_path_squared * sin_beta_squared * sum_3_squared
        + 8.0 * rho * sigma_beta * sigma_path_per_path * sin_beta * sum_1 * sum_2 * sum_3 * sum_5
    )
    result = _empty(arguments, (2, 2))
    result[..., 0, 0] = path_squared * sum_4 * term_2
    result[..., 0, 1] = path_squared * sum_7 * term_2
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = path_squared * sum_8 * term_2
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

    Accuracy: measured, not proved: at most 8.5 ulp from 50-digit arithmetic at 500 points of this domain
    (float64, independent errors). Errors are measured against the sum of the variances to first order of
    independent errors.
    """
    arguments = _floats(path, beta, baseline, sigma_path, sigma_beta, rho, predicted_sigma_path, predicted_sigma_beta, predicted_rho)
    path, beta, baseline, sigma_path, sigma_beta, rho, predicted_sigma_path, predicted_sigma_beta, predicted_rho = arguments
    term_1 = 1.0 / path
    baseline_per_path = baseline * term_1
    sigma_path_per_path = sigma_path * term_1
    predicted_sigma_path_per_path = predicted_sigma_path * term_1
    cos_beta = np.cos(beta)
    product_1 = -2.0 * baseline_per_path * cos_beta
    divisor_1 = 2.0 + product_1
    sum_1 = 1.0 + baseline_per_path
    sum_1_squared = sum_1**2
    sum_2 = baseline_per_path - 1.0
    sum_2_squared = sum_2**2
    baseline_per_path_squared = baseline_per_path**2
    sin_beta = np.sin(beta)
    sin_beta_squared = sin_beta**2
    product_2 = baseline_per_path_squared * sin_beta_squared
    sigma_beta_squared = sigma_beta**2
    sum_3 = 2.0 * baseline_per_path * cos_beta - 1.0 - baseline_per_path_squared + product_2
    cos_beta_squared = cos_beta**2
    product_3 = cos_beta * cos_beta_squared
    product_4 = -12.0 * baseline_per_path * product_3
    baseline_per_path_squared_squared = baseline_per_path_squared**2
    cos_beta_squared_squared = cos_beta_squared**2
    product_5 = baseline_per_path * baseline_per_path_squared
    product_6 = baseline_per_path * baseline_per_path_squared**2
    product_7 = cos_beta * cos_beta_squared**2
    product_8 = -2.0 * product_6 * product_7
    baseline_per_path_squared_cubed = baseline_per_path_squared * baseline_per_path_squared**2
    product_9 = -3.0 * baseline_per_path_squared_cubed * cos_beta_squared
    product_10 = 10.0 * product_3 * product_6
    product_11 = 14.0 * baseline_per_path_squared * cos_beta_squared_squared
    product_12 = 2.0 * baseline_per_path_squared_cubed * cos_beta_squared_squared
    product_13 = 6.0 * product_5 * product_7
    product_14 = 6.0 * baseline_per_path * cos_beta
    predicted_sigma_beta_squared = predicted_sigma_beta**2
    sigma_path_per_path_squared = sigma_path_per_path**2
    sum_4 = (
        2.0 * cos_beta_squared
        - 1.0
        - 16.0 * baseline_per_path_squared_squared * cos_beta_squared_squared
        - 18.0 * product_3 * product_5
        - 2.0 * baseline_per_path_squared
        - 6.0 * cos_beta * product_6
        - baseline_per_path_squared_squared
        + 20.0 * baseline_per_path_squared_squared * cos_beta_squared
        + baseline_per_path_squared * cos_beta_squared
        + product_10
        + product_11
        + product_12
        + product_13
        + product_14
        + product_4
        + product_8
        + product_9
    )
    sigma_path_per_path_squared_squared = sigma_path_per_path_squared**2
    sin_beta_squared_squared = sin_beta_squared**2
    product_15 = -14.0 * cos_beta * product_6
    product_16 = -24.0 * baseline_per_path_squared_squared * cos_beta_squared_squared
    product_17 = -28.0 * product_3 * product_5
    product_18 = -4.0 * product_6 * product_7
    product_19 = 22.0 * baseline_per_path_squared * cos_beta_squared_squared
    product_20 = 8.0 * cos_beta * product_5
    product_21 = 8.0 * product_5 * product_7
    sum_5 = (
        2.0 * cos_beta_squared
        - 1.0
        - 3.0 * baseline_per_path_squared_squared
        - 9.0 * baseline_per_path_squared * cos_beta_squared
        + 20.0 * product_3 * product_6
        + 30.0 * baseline_per_path_squared_squared * cos_beta_squared
        + product_12
        + product_14
        + product_15
        + product_16
        + product_17
        + product_18
        + product_19
        + product_20
        + product_21
        + product_4
        + product_9
    )
    product_22 = cos_beta * product_5
    sum_6 = 1.0 - 3.0 * baseline_per_path * cos_beta + baseline_per_path_squared + product_22
    sum_7 = baseline_per_path * cos_beta_squared - 2.0 * baseline_per_path + cos_beta
    product_23 = sigma_beta * sigma_beta_squared
    product_24 = -2.0 * cos_beta * product_5
    product_25 = -6.0 * baseline_per_path * product_3
    product_26 = 3.0 * baseline_per_path * cos_beta
    product_27 = product_3 * product_5
    predicted_sigma_path_per_path_squared = predicted_sigma_path_per_path**2
    sum_8 = (
        6.0 * baseline_per_path_squared * cos_beta_squared
        - 3.0 * baseline_per_path_squared
        + cos_beta_squared
        + product_24
        + product_25
        + product_26
        + product_27
    )
    product_28 = -9.0 * baseline_per_path * product_3
    sum_9 = (
        4.0 * cos_beta_squared
        - 2.0
        - 2.0 * baseline_per_path_squared
        - 3.0 * cos_beta * product_5
        + 8.0 * baseline_per_path_squared * cos_beta_squared
        + product_26
        + product_27
        + product_28
    )
    product_29 = 2.0 * baseline_per_path_squared * cos_beta_squared_squared
    product_30 = 6.0 * baseline_per_path * product_3
    sum_10 = (
        10.0 * baseline_per_path_squared
        - 1.0
        - 11.0 * baseline_per_path_squared * cos_beta_squared
        - 8.0 * baseline_per_path * cos_beta
        + 2.0 * cos_beta_squared
        + product_29
        + product_30
    )
    product_31 = -6.0 * baseline_per_path * cos_beta
    product_32 = -8.0 * cos_beta * product_5
    product_33 = 15.0 * baseline_per_path_squared * cos_beta_squared
    product_34 = 6.0 * cos_beta * product_6
    product_35 = baseline_per_path_squared_cubed * cos_beta_squared
    sum_11 = (
        1.0
        - 12.0 * baseline_per_path_squared_squared * cos_beta_squared
        + 3.0 * baseline_per_path_squared_squared
        + product_31
        + product_32
        + product_33
        + product_34
        + product_35
    )
    sum_12 = 1.0 + baseline_per_path_squared + product_1
    sum_12_squared = sum_12**2
    product_36 = baseline_per_path * cos_beta
    term_2 = (product_36 - 1.0)**2
    product_37 = 2.0 * product_3 * product_5
    rho_squared = rho**2
    sum_13 = (
        1.0
        - 2.0 * product_3 * product_6
        - 8.0 * baseline_per_path_squared_squared * cos_beta_squared
        + 11.0 * baseline_per_path_squared * cos_beta_squared
        + 2.0 * baseline_per_path_squared
        + baseline_per_path_squared_squared
        + product_31
        + product_32
        + product_34
        + product_35
        + product_37
    )
    product_38 = 2.0 * baseline_per_path_squared * cos_beta_squared
    sum_14 = product_14 - 3.0 - 5.0 * baseline_per_path_squared + product_38
    product_39 = -3.0 * baseline_per_path * sin_beta_squared
    sum_15 = (
        10.0 * product_5 * sin_beta_squared
        - 2.0 * cos_beta
        - 7.0 * product_5
        - 8.0 * baseline_per_path_squared * cos_beta * sin_beta_squared
        + 2.0 * baseline_per_path_squared_squared * cos_beta * sin_beta_squared
        + 4.0 * baseline_per_path_squared_squared * cos_beta
        + 5.0 * baseline_per_path
        + product_39
        + product_5 * sin_beta_squared_squared
    )
    product_40 = sigma_path_per_path * sigma_path_per_path_squared
    product_41 = sin_beta * sin_beta_squared
    sum_16 = (
        3.0 * product_5 * sin_beta_squared
        - 3.0 * baseline_per_path_squared * cos_beta * sin_beta_squared
        - 4.0 * baseline_per_path_squared * cos_beta
        - cos_beta
        + 4.0 * baseline_per_path
        + baseline_per_path_squared_squared * cos_beta
        + baseline_per_path_squared_squared * cos_beta * sin_beta_squared
        + product_39
    )
    sigma_beta_squared_squared = sigma_beta_squared**2
    term_3 = 1.0 / (divisor_1 * divisor_1**2)**2
    path_squared = path**2
    sum_17 = (
        16.0 * cos_beta_squared * sigma_path_per_path_squared * sum_12_squared * term_2
        - 16.0 * predicted_sigma_beta_squared * sigma_path_per_path_squared * sum_4
        - 16.0 * sigma_beta_squared * sin_beta_squared * sum_1_squared * sum_2_squared * sum_3
        - 32.0 * baseline_per_path_squared_squared * sigma_path_per_path_squared_squared * (1.0 + sin_beta) * (sin_beta - 1.0) * sin_beta_squared_squared
        - 32.0 * predicted_rho * predicted_sigma_beta * predicted_sigma_path_per_path * rho * sigma_beta * sigma_path_per_path * sum_5
        - 32.0 * product_23 * rho * sigma_path_per_path * sin_beta * sum_1 * sum_2 * sum_6 * sum_7
        - 64.0 * baseline_per_path_squared * cos_beta * predicted_rho * predicted_sigma_beta * predicted_sigma_path_per_path * sigma_path_per_path_squared * sin_beta * sum_9
        - 64.0 * baseline_per_path_squared * cos_beta * predicted_sigma_path_per_path_squared * rho * sigma_beta * sigma_path_per_path * sin_beta * sum_8
        + 16.0 * predicted_sigma_beta_squared * sigma_beta_squared * sum_10 * sum_1_squared * sum_2_squared
        + 16.0 * predicted_sigma_path_per_path_squared * sigma_beta_squared * sin_beta_squared * sum_11
        + 16.0 * rho_squared * sigma_beta_squared * sigma_path_per_path_squared * sin_beta_squared * sum_13
        + 16.0 * sigma_beta_squared * sigma_path_per_path_squared * sin_beta_squared * sum_6**2
        + 32.0 * baseline_per_path_squared * (1.0 + cos_beta) * (cos_beta - 1.0) * cos_beta_squared * predicted_sigma_path_per_path_squared * sigma_path_per_path_squared * sum_14
        + 32.0 * cos_beta * rho * sigma_beta * sigma_path_per_path * sin_beta * sum_1 * sum_12 * sum_2 * term_2
        + 32.0 * predicted_sigma_beta_squared * rho * sigma_beta * sigma_path_per_path * sin_beta * sum_1 * sum_15 * sum_2
        + 64.0 * baseline_per_path_squared * cos_beta * product_40 * product_41 * rho * sigma_beta * sum_6
        + 64.0 * predicted_rho * predicted_sigma_beta * predicted_sigma_path_per_path * sigma_beta_squared * sin_beta * sum_1 * sum_16 * sum_2
        + 8.0 * sigma_beta_squared_squared * sum_1_squared * sum_2_squared * sum_7**2
    )
    product_42 = -12.0 * baseline_per_path_squared_squared * product_3
    product_43 = -4.0 * baseline_per_path_squared_cubed * cos_beta
    product_44 = -6.0 * baseline_per_path * cos_beta_squared
    product_45 = baseline_per_path_squared_cubed * product_3
    sum_18 = (
        12.0 * cos_beta_squared * product_6
        - 18.0 * cos_beta_squared * product_5
        - 6.0 * product_6
        + 15.0 * baseline_per_path_squared * product_3
        + 15.0 * baseline_per_path_squared_squared * cos_beta
        + 2.0 * product_5
        + cos_beta
        + product_42
        + product_43
        + product_44
        + product_45
    )
    product_46 = -10.0 * baseline_per_path_squared_squared * product_3
    product_47 = -2.0 * cos_beta_squared_squared * product_6
    product_48 = 11.0 * baseline_per_path_squared * product_3
    product_49 = 2.0 * baseline_per_path_squared * cos_beta
    product_50 = 2.0 * cos_beta_squared_squared * product_5
    sum_19 = (
        13.0 * baseline_per_path_squared_squared * cos_beta
        - 14.0 * cos_beta_squared * product_5
        - 4.0 * product_6
        + 3.0 * baseline_per_path_squared_cubed * product_3
        + 8.0 * cos_beta_squared * product_6
        + cos_beta
        + product_43
        + product_44
        + product_46
        + product_47
        + product_48
        + product_49
        + product_50
    )
    product_51 = cos_beta_squared * product_5
    sum_20 = (
        3.0 * baseline_per_path_squared * cos_beta
        - 2.0 * product_5
        - 3.0 * baseline_per_path * cos_beta_squared
        + cos_beta
        + product_51
    )
    sum_21 = (
        2.0 * cos_beta_squared
        - 3.0 * baseline_per_path_squared
        - 7.0 * cos_beta * product_5
        + product_26
        + product_33
        + product_37
        + product_4
    )
    product_52 = 9.0 * cos_beta_squared * product_6
    sum_22 = (
        3.0 * cos_beta_squared_squared * product_5
        - 2.0 * product_5
        - 2.0 * product_6
        - 3.0 * baseline_per_path_squared_cubed * cos_beta
        - 9.0 * cos_beta_squared * product_5
        - cos_beta_squared_squared * product_6
        + 5.0 * baseline_per_path_squared * cos_beta
        + 7.0 * baseline_per_path_squared * product_3
        + 7.0 * baseline_per_path_squared_squared * cos_beta
        + cos_beta
        + product_44
        + product_45
        + product_46
        + product_52
    )
    product_53 = -4.0 * cos_beta * product_5
    sum_23 = (
        10.0 * baseline_per_path_squared * cos_beta_squared
        - 1.0
        - baseline_per_path_squared
        + 4.0 * cos_beta_squared
        + product_27
        + product_28
        + product_53
    )
    sum_24 = (
        12.0 * baseline_per_path_squared_squared * cos_beta
        - 15.0 * baseline_per_path_squared_squared * product_3
        - 15.0 * cos_beta_squared * product_5
        - 5.0 * baseline_per_path_squared_cubed * cos_beta
        - 5.0 * product_6
        + 15.0 * cos_beta_squared * product_6
        + 2.0 * baseline_per_path_squared_cubed * product_3
        + 4.0 * cos_beta_squared_squared * product_5
        + cos_beta
        + product_44
        + product_47
        + product_48
        + product_49
        + product_5
    )
    sum_25 = (
        22.0 * baseline_per_path_squared * cos_beta
        - 12.0 * baseline_per_path * cos_beta_squared
        - 20.0 * product_5
        - 4.0 * baseline_per_path_squared * product_3
        - 4.0 * cos_beta
        + 9.0 * baseline_per_path
        + 9.0 * cos_beta_squared * product_5
    )
    sum_26 = 2.0 * baseline_per_path_squared - 1.0 - baseline_per_path * cos_beta
    product_54 = 12.0 * baseline_per_path * cos_beta * sin_beta_squared
    sum_27 = (
        2.0
        - 12.0 * baseline_per_path_squared * sin_beta_squared_squared
        - 27.0 * cos_beta * product_5 * sin_beta_squared
        - 4.0 * baseline_per_path_squared * sin_beta_squared
        - 4.0 * sin_beta_squared
        - 9.0 * baseline_per_path * cos_beta
        + 12.0 * baseline_per_path_squared_squared * sin_beta_squared
        + 14.0 * baseline_per_path_squared
        + 3.0 * cos_beta * product_6 * sin_beta_squared
        + 4.0 * baseline_per_path_squared_squared * sin_beta_squared_squared
        + cos_beta * product_6
        + product_32
        + product_54
    )
    sum_28 = baseline_per_path - cos_beta
    sum_29 = 1.0 - 2.0 * cos_beta_squared + product_36
    sum_30 = (
        1.0
        - 12.0 * cos_beta * product_5 * sin_beta_squared
        - 2.0 * sin_beta_squared
        - 4.0 * baseline_per_path * cos_beta
        - 6.0 * baseline_per_path_squared * sin_beta_squared_squared
        + 2.0 * baseline_per_path_squared_squared * sin_beta_squared_squared
        + 2.0 * cos_beta * product_6 * sin_beta_squared
        + 3.0 * baseline_per_path_squared_squared * sin_beta_squared
        + 4.0 * baseline_per_path * cos_beta * sin_beta_squared
        + 6.0 * baseline_per_path_squared
        + baseline_per_path_squared_squared
        + product_2
        + product_53
    )
    sum_31 = (
        2.0 * cos_beta * product_5 * sin_beta_squared
        - 1.0
        - 3.0 * baseline_per_path_squared
        - 6.0 * baseline_per_path * cos_beta * sin_beta_squared
        + 2.0 * sin_beta_squared
        + 4.0 * baseline_per_path_squared * sin_beta_squared
        + product_22
        + product_26
    )
    sum_32 = (
        4.0
        - 15.0 * baseline_per_path * cos_beta
        - 32.0 * baseline_per_path_squared * sin_beta_squared_squared
        - 4.0 * cos_beta * product_5 * sin_beta_squared_squared
        - 57.0 * cos_beta * product_5 * sin_beta_squared
        - 6.0 * baseline_per_path_squared_squared
        - 8.0 * sin_beta_squared
        + 16.0 * baseline_per_path_squared_squared * sin_beta_squared_squared
        + 18.0 * baseline_per_path_squared
        + 18.0 * baseline_per_path_squared * sin_beta_squared
        + 18.0 * baseline_per_path_squared_squared * sin_beta_squared
        + 3.0 * cos_beta * product_6
        + 9.0 * cos_beta * product_6 * sin_beta_squared
        + product_53
        + product_54
    )
    sum_33 = (
        16.0 * cos_beta * sigma_path_per_path_squared * sin_beta * sum_12_squared * term_2
        - 16.0 * predicted_sigma_path_per_path_squared * sigma_beta_squared * sin_beta * sum_18
        - 16.0 * rho_squared * sigma_beta_squared * sigma_path_per_path_squared * sin_beta * sum_19
        - 16.0 * sigma_beta_squared * sigma_path_per_path_squared * sin_beta * sum_20 * sum_6
        - 32.0 * baseline_per_path_squared * cos_beta * predicted_sigma_path_per_path_squared * product_41 * sigma_path_per_path_squared * sum_14
        - 32.0 * baseline_per_path_squared * predicted_sigma_path_per_path_squared * rho * sigma_beta * sigma_path_per_path * sin_beta_squared * sum_21
        - 32.0 * predicted_sigma_beta_squared * sigma_path_per_path_squared * sin_beta * sum_22
        - 64.0 * baseline_per_path_squared * predicted_rho * predicted_sigma_beta * predicted_sigma_path_per_path * sigma_path_per_path_squared * sin_beta_squared * sum_23
        - 64.0 * predicted_rho * predicted_sigma_beta * predicted_sigma_path_per_path * rho * sigma_beta * sigma_path_per_path * sin_beta * sum_24
        - 8.0 * predicted_sigma_beta_squared * sigma_beta_squared * sin_beta * sum_1_squared * sum_25 * sum_2_squared
        - 8.0 * sigma_beta_squared_squared * sin_beta * sum_1_squared * sum_26 * sum_2_squared * sum_7
        + 16.0 * predicted_rho * predicted_sigma_beta * predicted_sigma_path_per_path * sigma_beta_squared * sum_1 * sum_2 * sum_27
        + 16.0 * product_23 * rho * sigma_path_per_path * sum_1 * sum_2 * sum_30
        + 16.0 * sigma_beta_squared * sin_beta * sum_1_squared * sum_28 * sum_2_squared * term_2
        + 16.0 * rho * sigma_beta * sigma_path_per_path * sum_1 * sum_12 * sum_2 * sum_29 * term_2
        + 32.0 * baseline_per_path_squared * product_40 * rho * sigma_beta * sin_beta_squared * sum_31
        + 32.0 * baseline_per_path_squared_squared * cos_beta * sigma_path_per_path_squared_squared * sin_beta * sin_beta_squared**2
        + 8.0 * predicted_sigma_beta_squared * rho * sigma_beta * sigma_path_per_path * sum_1 * sum_2 * sum_32
    )
    sum_34 = (
        14.0 * cos_beta * product_5
        - 1.0
        - 10.0 * baseline_per_path_squared_squared
        - 13.0 * baseline_per_path_squared * cos_beta_squared
        - 7.0 * baseline_per_path * cos_beta
        - 9.0 * product_3 * product_5
        + 2.0 * cos_beta_squared
        + 8.0 * baseline_per_path_squared
        + 8.0 * baseline_per_path_squared_squared * cos_beta_squared
        + product_29
        + product_30
    )
    sum_35 = (
        16.0 * baseline_per_path_squared * product_3
        - 14.0 * baseline_per_path_squared * cos_beta
        - 20.0 * product_6
        - 39.0 * cos_beta_squared * product_5
        - 4.0 * cos_beta
        + 46.0 * baseline_per_path_squared_squared * cos_beta
        + 5.0 * baseline_per_path
        + 5.0 * product_5
        + 6.0 * baseline_per_path * cos_beta_squared
        + product_42
        + product_50
        + product_52
    )
    sum_36 = 9.0 * baseline_per_path_squared * cos_beta - 5.0 * product_5 + cos_beta + product_44 + product_51
    product_55 = -12.0 * baseline_per_path_squared_squared * cos_beta_squared_squared
    product_56 = 33.0 * baseline_per_path_squared_squared * cos_beta_squared
    sum_37 = (
        10.0 * baseline_per_path_squared_cubed
        - 10.0 * baseline_per_path_squared_cubed * cos_beta_squared
        - 24.0 * cos_beta * product_6
        - 6.0 * baseline_per_path_squared_squared
        + 15.0 * baseline_per_path_squared * cos_beta_squared_squared
        + 18.0 * product_3 * product_6
        + baseline_per_path_squared_cubed * cos_beta_squared_squared
        + cos_beta_squared
        + product_17
        + product_20
        + product_25
        + product_55
        + product_56
    )
    sum_38 = (
        10.0 * baseline_per_path_squared_cubed
        - 1.0
        - 11.0 * baseline_per_path_squared_cubed * cos_beta_squared
        - 24.0 * product_3 * product_5
        - 32.0 * cos_beta * product_6
        - 4.0 * baseline_per_path_squared
        + 2.0 * cos_beta_squared
        + 28.0 * product_3 * product_6
        + 3.0 * baseline_per_path_squared_squared
        + 36.0 * baseline_per_path_squared_squared * cos_beta_squared
        + 5.0 * baseline_per_path_squared * cos_beta_squared
        + product_11
        + product_12
        + product_13
        + product_14
        + product_16
        + product_24
        + product_4
        + product_8
    )
    sum_39 = (
        11.0 * baseline_per_path_squared * cos_beta_squared_squared
        - 12.0 * baseline_per_path_squared_cubed * cos_beta_squared
        - 20.0 * product_3 * product_5
        - 6.0 * baseline_per_path_squared_squared
        + 2.0 * baseline_per_path_squared
        + 2.0 * product_5 * product_7
        + 5.0 * baseline_per_path_squared_cubed * cos_beta_squared_squared
        + 8.0 * baseline_per_path_squared_cubed
        + cos_beta_squared
        + product_10
        + product_15
        + product_24
        + product_25
        + product_38
        + product_55
        + product_56
        + product_8
    )
    sum_40 = (
        3.0
        + 2.0 * baseline_per_path_squared * sin_beta_squared
        + 3.0 * baseline_per_path_squared
        + product_31
    )
    sum_41 = (
        16.0 * product_5
        - 2.0 * baseline_per_path_squared_squared * cos_beta * sin_beta_squared
        - 20.0 * baseline_per_path_squared_squared * cos_beta
        - 21.0 * product_5 * sin_beta_squared
        - 7.0 * baseline_per_path
        + 2.0 * cos_beta
        + 3.0 * product_6 * sin_beta_squared
        + 6.0 * baseline_per_path * sin_beta_squared
        + 6.0 * baseline_per_path_squared * cos_beta * sin_beta_squared
        + 7.0 * product_6
        + product_49
    )
    sum_42 = (
        12.0 * cos_beta * product_5
        - 1.0
        - 2.0 * baseline_per_path_squared
        - 25.0 * baseline_per_path_squared_cubed * cos_beta_squared
        - 36.0 * baseline_per_path_squared_squared * cos_beta_squared_squared
        - 40.0 * product_3 * product_5
        - 46.0 * cos_beta * product_6
        - 5.0 * baseline_per_path_squared * cos_beta_squared
        - 9.0 * baseline_per_path_squared_squared
        + 2.0 * cos_beta_squared
        + 20.0 * baseline_per_path_squared_cubed
        + 44.0 * product_3 * product_6
        + 6.0 * baseline_per_path_squared_cubed * cos_beta_squared_squared
        + 60.0 * baseline_per_path_squared_squared * cos_beta_squared
        + product_14
        + product_18
        + product_19
        + product_21
        + product_4
    )
    sum_43 = (
        12.0 * baseline_per_path
        - 12.0 * baseline_per_path_squared * cos_beta
        - 4.0 * cos_beta
        - 9.0 * baseline_per_path * sin_beta_squared
        + 4.0 * product_5
        + product_5 * sin_beta_squared
    )
    sum_44 = (
        16.0 * predicted_sigma_beta_squared * sigma_path_per_path_squared * sum_38
        - 16.0 * predicted_sigma_beta_squared * sigma_beta_squared * sum_1_squared * sum_2_squared * sum_34
        - 16.0 * predicted_sigma_beta_squared * rho * sigma_beta * sigma_path_per_path * sin_beta * sum_1 * sum_2 * sum_35
        - 32.0 * product_23 * rho * sigma_path_per_path * sin_beta * sum_1 * sum_2 * sum_20 * sum_26
        - 64.0 * baseline_per_path_squared * predicted_sigma_path_per_path_squared * product_41 * rho * sigma_beta * sigma_path_per_path * sum_36
        - 64.0 * baseline_per_path_squared * product_40 * product_41 * rho * sigma_beta * sum_20
        + 16.0 * predicted_sigma_path_per_path_squared * sigma_beta_squared * sum_37
        + 16.0 * rho_squared * sigma_beta_squared * sigma_path_per_path_squared * sum_39
        + 16.0 * sigma_beta_squared * sigma_path_per_path_squared * sum_20**2
        + 16.0 * sigma_beta_squared * sum_1_squared * sum_28**2 * sum_2_squared * term_2
        + 16.0 * sigma_path_per_path_squared * sin_beta_squared * sum_12_squared * term_2
        + 32.0 * baseline_per_path_squared * predicted_sigma_path_per_path_squared * sigma_path_per_path_squared * sin_beta_squared_squared * sum_40
        + 32.0 * baseline_per_path_squared_squared * sigma_path_per_path_squared_squared * sin_beta_squared * sin_beta_squared**2
        + 32.0 * predicted_rho * predicted_sigma_beta * predicted_sigma_path_per_path * sigma_beta_squared * sin_beta * sum_1 * sum_2 * sum_41
        + 32.0 * predicted_rho * predicted_sigma_beta * predicted_sigma_path_per_path * rho * sigma_beta * sigma_path_per_path * sum_42
        + 32.0 * rho * sigma_beta * sigma_path_per_path * sin_beta * sum_1 * sum_12 * sum_2 * sum_28 * term_2
        + 64.0 * baseline_per_path_squared * predicted_rho * predicted_sigma_beta * predicted_sigma_path_per_path * product_41 * sigma_path_per_path_squared * sum_43
        + 8.0 * sigma_beta_squared_squared * sin_beta_squared * sum_1_squared * sum_26**2 * sum_2_squared
    )
    result = _empty(arguments, (2, 2))
    result[..., 0, 0] = path_squared * sum_17 * term_3
    result[..., 0, 1] = path_squared * sum_33 * term_3
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = path_squared * sum_44 * term_3
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

    Accuracy: measured, not proved: at most 8 ulp from 50-digit arithmetic at 500 points of this domain
    (float64, independent errors). Errors are measured against the sum of the variances to first order of
    independent errors.
    """
    arguments = _floats(path, beta, baseline, sigma_path, sigma_beta, rho)
    path, beta, baseline, sigma_path, sigma_beta, rho = arguments
    term_1 = 1.0 / path
    baseline_per_path = baseline * term_1
    sigma_path_per_path = sigma_path * term_1
    cos_beta = np.cos(beta)
    product_1 = -2.0 * baseline_per_path * cos_beta
    divisor_1 = 2.0 + product_1
    cos_beta_squared = cos_beta**2
    baseline_per_path_squared = baseline_per_path**2
    baseline_per_path_squared_squared = baseline_per_path_squared**2
    product_2 = cos_beta * cos_beta_squared
    product_3 = baseline_per_path * baseline_per_path_squared
    product_4 = -4.0 * baseline_per_path * cos_beta_squared
    product_5 = 4.0 * cos_beta_squared * product_3
    product_6 = baseline_per_path_squared_squared * product_2
    sum_1 = (
        7.0 * baseline_per_path_squared * cos_beta
        - 2.0 * baseline_per_path_squared_squared * cos_beta
        - 3.0 * baseline_per_path_squared * product_2
        - 4.0 * product_3
        + cos_beta
        + product_4
        + product_5
        + product_6
    )
    rho_squared = rho**2
    product_7 = rho * rho_squared
    sigma_beta_squared = sigma_beta**2
    product_8 = sigma_beta * sigma_beta_squared
    sigma_path_per_path_squared = sigma_path_per_path**2
    product_9 = sigma_path_per_path * sigma_path_per_path_squared
    sin_beta = np.sin(beta)
    sum_2 = 1.0 - 3.0 * cos_beta_squared + 2.0 * baseline_per_path * cos_beta
    product_10 = baseline_per_path * cos_beta
    sum_3 = product_10 - 1.0
    sum_3_squared = sum_3**2
    product_11 = -16.0 * baseline_per_path * cos_beta_squared
    cos_beta_squared_squared = cos_beta_squared**2
    sum_4 = 1.0 + baseline_per_path
    sum_5 = baseline_per_path - 1.0
    sum_6 = (
        34.0 * cos_beta_squared * product_3
        - 18.0 * baseline_per_path_squared_squared * cos_beta
        - 18.0 * product_3
        - 2.0 * cos_beta_squared_squared * product_3
        - 25.0 * baseline_per_path_squared * product_2
        - 6.0 * baseline_per_path
        + 37.0 * baseline_per_path_squared * cos_beta
        + 7.0 * baseline_per_path_squared_squared * product_2
        + 7.0 * cos_beta
        + product_11
    )
    sigma_path_per_path_squared_cubed = sigma_path_per_path_squared * sigma_path_per_path_squared**2
    sin_beta_squared = sin_beta**2
    sin_beta_squared_squared = sin_beta_squared**2
    product_12 = -12.0 * baseline_per_path * product_2
    product_13 = 3.0 * baseline_per_path_squared_squared * cos_beta_squared_squared
    sigma_path_per_path_squared_squared = sigma_path_per_path_squared**2
    sum_7 = (
        24.0 * product_2 * product_3
        - 10.0 * baseline_per_path_squared_squared * cos_beta_squared
        - 16.0 * cos_beta * product_3
        - 18.0 * baseline_per_path_squared * cos_beta_squared_squared
        - baseline_per_path_squared
        + 27.0 * baseline_per_path_squared * cos_beta_squared
        + 3.0 * cos_beta_squared
        + product_12
        + product_13
    )
    product_14 = sigma_path_per_path * sigma_path_per_path_squared**2
    product_15 = sin_beta * sin_beta_squared
    sum_8 = (
        2.0 * baseline_per_path * sin_beta_squared
        - 2.0 * baseline_per_path
        - 3.0 * cos_beta * sin_beta_squared
        + 2.0 * cos_beta
    )
    product_16 = baseline_per_path * baseline_per_path_squared**2
    product_17 = cos_beta * cos_beta_squared**2
    sum_9 = (
        24.0 * baseline_per_path_squared * product_17
        - 10.0 * cos_beta_squared * product_16
        - 10.0 * product_3
        - 11.0 * baseline_per_path * cos_beta_squared
        - 34.0 * baseline_per_path_squared_squared * cos_beta
        - 51.0 * cos_beta_squared_squared * product_3
        - 6.0 * product_2
        - 9.0 * baseline_per_path_squared_squared * product_17
        - 92.0 * baseline_per_path_squared * product_2
        + 28.0 * baseline_per_path_squared * cos_beta
        + 36.0 * baseline_per_path * cos_beta_squared_squared
        + 48.0 * baseline_per_path_squared_squared * product_2
        + 5.0 * cos_beta_squared_squared * product_16
        + 81.0 * cos_beta_squared * product_3
        + cos_beta
    )
    sum_10 = (
        3.0 * cos_beta_squared
        - 22.0 * baseline_per_path_squared_squared * cos_beta_squared
        - 28.0 * cos_beta * product_3
        - 4.0 * baseline_per_path_squared
        - 45.0 * baseline_per_path_squared * cos_beta_squared_squared
        + 45.0 * baseline_per_path_squared * cos_beta_squared
        + 60.0 * product_2 * product_3
        + product_12
        + product_13
    )
    baseline_per_path_squared_cubed = baseline_per_path_squared * baseline_per_path_squared**2
    product_18 = -14.0 * product_16 * product_17
    product_19 = -42.0 * baseline_per_path * product_2
    product_20 = 18.0 * baseline_per_path * cos_beta
    product_21 = 30.0 * product_17 * product_3
    product_22 = 77.0 * baseline_per_path_squared * cos_beta_squared_squared
    sum_11 = (
        111.0 * baseline_per_path_squared_squared * cos_beta_squared
        - 3.0
        - 102.0 * product_2 * product_3
        - 11.0 * baseline_per_path_squared_cubed * cos_beta_squared
        - 11.0 * baseline_per_path_squared_squared
        - 27.0 * baseline_per_path_squared * cos_beta_squared
        - 50.0 * cos_beta * product_16
        - 88.0 * baseline_per_path_squared_squared * cos_beta_squared_squared
        + 2.0 * baseline_per_path_squared
        + 24.0 * cos_beta * product_3
        + 7.0 * baseline_per_path_squared_cubed * cos_beta_squared_squared
        + 7.0 * cos_beta_squared
        + 72.0 * product_16 * product_2
        + product_18
        + product_19
        + product_20
        + product_21
        + product_22
    )
    product_23 = -30.0 * baseline_per_path * product_2
    product_24 = -4.0 * product_16 * product_17
    product_25 = 12.0 * product_17 * product_3
    product_26 = 49.0 * baseline_per_path_squared * cos_beta_squared_squared
    product_27 = 5.0 * baseline_per_path_squared_cubed * cos_beta_squared_squared
    sum_12 = (
        12.0 * cos_beta * product_3
        - 3.0
        - 2.0 * baseline_per_path_squared
        - 21.0 * baseline_per_path_squared * cos_beta_squared
        - 22.0 * cos_beta * product_16
        - 48.0 * product_2 * product_3
        - 50.0 * baseline_per_path_squared_squared * cos_beta_squared_squared
        - 7.0 * baseline_per_path_squared_cubed * cos_beta_squared
        - 7.0 * baseline_per_path_squared_squared
        + 30.0 * product_16 * product_2
        + 5.0 * cos_beta_squared
        + 63.0 * baseline_per_path_squared_squared * cos_beta_squared
        + product_20
        + product_23
        + product_24
        + product_25
        + product_26
        + product_27
    )
    sum_13 = (
        3.0 * baseline_per_path * cos_beta
        - 1.0
        - 3.0 * baseline_per_path_squared
        - 3.0 * cos_beta * product_3
        - 9.0 * baseline_per_path * product_2
        + 3.0 * cos_beta_squared
        + 9.0 * baseline_per_path_squared * cos_beta_squared
        + product_2 * product_3
    )
    sum_3_squared_squared = sum_3_squared**2
    sum_14 = 1.0 + baseline_per_path_squared + product_1
    sum_4_squared = sum_4**2
    sum_5_squared = sum_5**2
    product_28 = 22.0 * baseline_per_path * product_2
    product_29 = 7.0 * baseline_per_path_squared * cos_beta_squared_squared
    sigma_beta_squared_squared = sigma_beta_squared**2
    sum_15 = (
        36.0 * baseline_per_path_squared
        - 4.0
        - 28.0 * baseline_per_path * cos_beta
        - 40.0 * baseline_per_path_squared * cos_beta_squared
        + 7.0 * cos_beta_squared
        + product_28
        + product_29
    )
    product_30 = 4.0 * baseline_per_path * cos_beta
    product_31 = baseline_per_path_squared * cos_beta_squared
    sum_16 = product_30 - 2.0 - 3.0 * baseline_per_path_squared + product_31
    sum_17 = 1.0 - 6.0 * baseline_per_path_squared + product_30 + product_31
    product_32 = sigma_beta * sigma_beta_squared**2
    product_33 = baseline_per_path * baseline_per_path_squared * baseline_per_path_squared**2
    term_2 = (baseline_per_path_squared**2)**2
    product_34 = -4.0 * cos_beta_squared_squared * term_2
    product_35 = -8.0 * baseline_per_path * product_2
    cos_beta_squared_cubed = cos_beta_squared * cos_beta_squared**2
    product_36 = 4.0 * cos_beta_squared * term_2
    product_37 = cos_beta_squared_cubed * term_2
    sum_18 = (
        10.0 * baseline_per_path_squared * cos_beta_squared
        - 105.0 * baseline_per_path_squared_squared * cos_beta_squared_squared
        - 2.0 * cos_beta * product_3
        - 38.0 * product_2 * product_33
        - 46.0 * product_16 * product_17
        - 66.0 * product_2 * product_3
        - 7.0 * baseline_per_path_squared_squared
        - 74.0 * cos_beta * product_16
        - 9.0 * baseline_per_path_squared_cubed * cos_beta_squared_cubed
        - 93.0 * baseline_per_path_squared_cubed * cos_beta_squared
        + 10.0 * product_17 * product_33
        + 114.0 * baseline_per_path_squared_squared * cos_beta_squared
        + 12.0 * baseline_per_path_squared_squared * cos_beta_squared_cubed
        + 128.0 * product_16 * product_2
        + 13.0 * baseline_per_path_squared * cos_beta_squared_squared
        + 22.0 * baseline_per_path_squared_cubed
        + 28.0 * cos_beta * product_33
        + 36.0 * product_17 * product_3
        + 72.0 * baseline_per_path_squared_cubed * cos_beta_squared_squared
        + baseline_per_path_squared
        + cos_beta_squared
        + product_34
        + product_35
        + product_36
        + product_37
    )
    sigma_beta_squared_cubed = sigma_beta_squared * sigma_beta_squared**2
    sum_14_squared = sum_14**2
    product_38 = 16.0 * cos_beta * product_3
    sum_19 = (
        16.0 * product_17 * product_33
        - 120.0 * product_2 * product_3
        - 128.0 * cos_beta * product_16
        - 18.0 * baseline_per_path_squared_cubed * cos_beta_squared_cubed
        - 192.0 * baseline_per_path_squared_cubed * cos_beta_squared
        - 2.0 * baseline_per_path_squared * cos_beta_squared
        - 204.0 * baseline_per_path_squared_squared * cos_beta_squared_squared
        - 28.0 * baseline_per_path_squared_squared
        - 80.0 * product_2 * product_33
        - 88.0 * product_16 * product_17
        + 162.0 * baseline_per_path_squared_cubed * cos_beta_squared_squared
        + 21.0 * baseline_per_path_squared_squared * cos_beta_squared_cubed
        + 22.0 * baseline_per_path_squared * cos_beta_squared_squared
        + 224.0 * product_16 * product_2
        + 225.0 * baseline_per_path_squared_squared * cos_beta_squared
        + 4.0 * baseline_per_path_squared
        + 40.0 * baseline_per_path_squared_cubed
        + 64.0 * cos_beta * product_33
        + 72.0 * product_17 * product_3
        + cos_beta_squared
        + product_34
        + product_35
        + product_36
        + product_37
        + product_38
    )
    term_3 = 1.0 / ((divisor_1**2)**2)**2
    path_squared = path**2
    sum_20 = (
        128.0 * cos_beta * rho * sigma_beta * sigma_path_per_path * sin_beta * sum_14 * sum_3_squared_squared * sum_4 * sum_5
        - 1024.0 * baseline_per_path_squared * product_7 * product_8 * product_9 * sin_beta * sum_1 * sum_2
        - 128.0 * product_8 * rho * sigma_path_per_path * sin_beta * sum_3_squared * sum_4 * sum_5 * sum_6
        - 2304.0 * baseline_per_path_squared_squared * sigma_path_per_path_squared_cubed * (1.0 + sin_beta) * (sin_beta - 1.0) * sin_beta_squared_squared
        - 256.0 * baseline_per_path_squared * sigma_beta_squared * sigma_path_per_path_squared_squared * sin_beta_squared * sum_7
        - 4608.0 * baseline_per_path_squared_squared * product_14 * product_15 * rho * sigma_beta * sum_8
        - 512.0 * baseline_per_path_squared * product_8 * product_9 * rho * sin_beta * sum_9
        - 512.0 * baseline_per_path_squared * rho_squared * sigma_beta_squared * sigma_path_per_path_squared_squared * sin_beta_squared * sum_10
        - 64.0 * rho_squared * sigma_beta_squared * sigma_path_per_path_squared * sum_11 * sum_3_squared
        - 64.0 * sigma_beta_squared * sigma_path_per_path_squared * sum_12 * sum_3_squared
        - 768.0 * baseline_per_path_squared * cos_beta * product_9 * rho * sigma_beta * sin_beta * sum_13 * sum_3_squared
        + 32.0 * sigma_beta_squared_squared * sum_15 * sum_3_squared * sum_4_squared * sum_5_squared
        + 384.0 * baseline_per_path_squared * (1.0 + cos_beta) * (cos_beta - 1.0) * cos_beta_squared * sigma_path_per_path_squared_squared * sum_16 * sum_3_squared
        + 384.0 * product_32 * rho * sigma_path_per_path * sin_beta * sum_1 * sum_17 * sum_4 * sum_5
        + 512.0 * rho_squared * sigma_beta_squared_squared * sigma_path_per_path_squared * sum_18
        + 64.0 * cos_beta_squared * sigma_path_per_path_squared * sum_14_squared * sum_3_squared_squared
        + 64.0 * sigma_beta_squared * sin_beta_squared * sum_3_squared_squared * sum_4_squared * sum_5_squared
        + 64.0 * sigma_beta_squared_cubed * sin_beta_squared * sum_17**2 * sum_4_squared * sum_5_squared
        + 64.0 * sigma_beta_squared_squared * sigma_path_per_path_squared * sum_19
    )
    sum_21 = (
        26.0 * cos_beta_squared * product_3
        - 12.0 * baseline_per_path_squared_squared * cos_beta
        - 15.0 * baseline_per_path_squared * product_2
        - 6.0 * product_3
        + 9.0 * baseline_per_path_squared * cos_beta
        + cos_beta
        + product_4
        + product_6
    )
    sum_22 = (
        16.0 * baseline_per_path
        - 22.0 * baseline_per_path * cos_beta_squared
        - 36.0 * product_3
        - 7.0 * baseline_per_path_squared * product_2
        - 7.0 * cos_beta
        + 16.0 * cos_beta_squared * product_3
        + 40.0 * baseline_per_path_squared * cos_beta
    )
    sum_23 = (
        2.0 * product_2 * product_3
        - 1.0
        - 18.0 * baseline_per_path * product_2
        - 3.0 * baseline_per_path_squared
        - 9.0 * cos_beta * product_3
        + 22.0 * baseline_per_path_squared * cos_beta_squared
        + 6.0 * cos_beta_squared
        + product_10
    )
    sum_24 = (
        112.0 * cos_beta_squared * product_16
        - 106.0 * cos_beta_squared * product_3
        - 110.0 * baseline_per_path_squared_squared * product_2
        - 14.0 * cos_beta_squared_squared * product_16
        - 36.0 * baseline_per_path_squared_cubed * cos_beta
        - 36.0 * product_16
        - 42.0 * baseline_per_path * cos_beta_squared
        + 13.0 * baseline_per_path_squared_cubed * product_2
        + 14.0 * baseline_per_path_squared * cos_beta
        + 30.0 * cos_beta_squared_squared * product_3
        + 7.0 * cos_beta
        + 77.0 * baseline_per_path_squared * product_2
        + 8.0 * product_3
        + 83.0 * baseline_per_path_squared_squared * cos_beta
    )
    product_39 = 16.0 * baseline_per_path_squared * cos_beta
    sum_25 = (
        12.0 * cos_beta_squared_squared * product_3
        - 18.0 * baseline_per_path_squared_cubed * cos_beta
        - 18.0 * product_16
        - 2.0 * product_3
        - 30.0 * baseline_per_path * cos_beta_squared
        - 4.0 * cos_beta_squared_squared * product_16
        - 58.0 * baseline_per_path_squared_squared * product_2
        - 62.0 * cos_beta_squared * product_3
        + 49.0 * baseline_per_path_squared * product_2
        + 49.0 * baseline_per_path_squared_squared * cos_beta
        + 5.0 * baseline_per_path_squared_cubed * product_2
        + 5.0 * cos_beta
        + 56.0 * cos_beta_squared * product_16
        + product_39
    )
    sum_26 = (
        7.0
        - 107.0 * product_2 * product_3
        - 14.0 * cos_beta_squared
        - 18.0 * cos_beta * product_16
        - 22.0 * baseline_per_path_squared_squared * cos_beta_squared_squared
        - 3.0 * baseline_per_path * cos_beta
        - 54.0 * baseline_per_path_squared_squared
        - 91.0 * baseline_per_path_squared * cos_beta_squared
        + 119.0 * cos_beta * product_3
        + 13.0 * product_16 * product_2
        + 32.0 * baseline_per_path * product_2
        + 4.0 * product_17 * product_3
        + 50.0 * baseline_per_path_squared * cos_beta_squared_squared
        + 83.0 * baseline_per_path_squared_squared * cos_beta_squared
        + baseline_per_path_squared
    )
    sum_27 = (
        22.0
        - 112.0 * baseline_per_path_squared * sin_beta_squared
        - 125.0 * baseline_per_path * cos_beta
        - 154.0 * baseline_per_path_squared_squared
        - 24.0 * sin_beta_squared
        - 291.0 * cos_beta * product_3 * sin_beta_squared
        - 96.0 * baseline_per_path_squared * sin_beta_squared_squared
        + 14.0 * cos_beta * product_3
        + 144.0 * baseline_per_path * cos_beta * sin_beta_squared
        + 172.0 * baseline_per_path_squared
        + 226.0 * baseline_per_path_squared_squared * sin_beta_squared
        + 36.0 * baseline_per_path_squared_squared * sin_beta_squared_squared
        + 37.0 * cos_beta * product_16 * sin_beta_squared
        + 71.0 * cos_beta * product_16
    )
    product_40 = -14.0 * cos_beta * product_3
    sin_beta_squared_cubed = sin_beta_squared * sin_beta_squared**2
    sum_28 = (
        2.0 * baseline_per_path_squared_cubed * sin_beta_squared_cubed
        - 1.0
        - 3.0 * baseline_per_path_squared_cubed
        - 32.0 * cos_beta * product_16 * sin_beta_squared_squared
        - 38.0 * baseline_per_path_squared * sin_beta_squared
        - 6.0 * baseline_per_path_squared_squared * sin_beta_squared_cubed
        - 8.0 * cos_beta * product_16
        - 91.0 * baseline_per_path_squared_squared * sin_beta_squared_squared
        - 98.0 * cos_beta * product_16 * sin_beta_squared
        - baseline_per_path_squared
        + 2.0 * cos_beta * product_33
        + 2.0 * sin_beta_squared
        + 21.0 * baseline_per_path_squared_squared
        + 29.0 * baseline_per_path_squared_cubed * sin_beta_squared_squared
        + 32.0 * baseline_per_path_squared_cubed * sin_beta_squared
        + 32.0 * cos_beta * product_3 * sin_beta_squared_squared
        + 36.0 * baseline_per_path_squared * sin_beta_squared_squared
        + 36.0 * baseline_per_path_squared_squared * sin_beta_squared
        + 4.0 * cos_beta * product_33 * sin_beta_squared_squared
        + 52.0 * cos_beta * product_3 * sin_beta_squared
        + 6.0 * cos_beta * product_33 * sin_beta_squared
        + product_30
        + product_40
    )
    sum_29 = 5.0 * baseline_per_path * cos_beta - 5.0 + 6.0 * sin_beta_squared
    product_41 = sin_beta * sin_beta_squared**2
    product_42 = -18.0 * baseline_per_path_squared_cubed * product_17
    product_43 = -24.0 * product_2 * term_2
    product_44 = 36.0 * cos_beta * term_2
    product_45 = 72.0 * cos_beta_squared_squared * product_3
    sum_30 = (
        104.0 * baseline_per_path_squared_squared * cos_beta
        - 129.0 * cos_beta_squared_squared * product_16
        - 139.0 * cos_beta_squared * product_33
        - 212.0 * baseline_per_path_squared_squared * product_2
        - 214.0 * baseline_per_path_squared_cubed * cos_beta
        - 55.0 * product_16
        - 89.0 * cos_beta_squared * product_3
        - product_3
        + 194.0 * baseline_per_path_squared_cubed * product_2
        + 2.0 * cos_beta
        + 2.0 * product_17 * term_2
        + 24.0 * baseline_per_path_squared_squared * product_17
        + 26.0 * baseline_per_path_squared * product_2
        + 308.0 * cos_beta_squared * product_16
        + 41.0 * cos_beta_squared_squared * product_33
        + 72.0 * product_33
        + product_11
        + product_39
        + product_42
        + product_43
        + product_44
        + product_45
    )
    product_46 = 4.0 * cos_beta * product_3
    sum_31 = (
        5.0
        - 17.0 * baseline_per_path_squared * sin_beta_squared
        - 18.0 * baseline_per_path_squared * sin_beta_squared_squared
        - 25.0 * baseline_per_path * cos_beta
        - 29.0 * baseline_per_path_squared_squared
        - 51.0 * cos_beta * product_3 * sin_beta_squared
        - 6.0 * sin_beta_squared
        + 13.0 * cos_beta * product_16
        + 24.0 * baseline_per_path * cos_beta * sin_beta_squared
        + 32.0 * baseline_per_path_squared
        + 41.0 * baseline_per_path_squared_squared * sin_beta_squared
        + 5.0 * cos_beta * product_16 * sin_beta_squared
        + 6.0 * baseline_per_path_squared_squared * sin_beta_squared_squared
        + product_46
    )
    sum_32 = baseline_per_path - cos_beta
    sum_33 = (
        4.0 * baseline_per_path
        - 6.0 * product_3
        - baseline_per_path_squared * product_2
        - cos_beta
        + 4.0 * baseline_per_path_squared * cos_beta
        + product_4
        + product_5
    )
    sum_34 = (
        10.0 * product_3
        - 126.0 * cos_beta_squared_squared * product_16
        - 146.0 * cos_beta_squared * product_33
        - 188.0 * baseline_per_path_squared_cubed * cos_beta
        - 196.0 * baseline_per_path_squared_squared * product_2
        - 74.0 * product_16
        - 8.0 * baseline_per_path * cos_beta_squared
        - 94.0 * cos_beta_squared * product_3
        + 121.0 * baseline_per_path_squared_squared * cos_beta
        + 190.0 * baseline_per_path_squared_cubed * product_2
        + 2.0 * baseline_per_path_squared * cos_beta
        + 21.0 * baseline_per_path_squared_squared * product_17
        + 22.0 * baseline_per_path_squared * product_2
        + 280.0 * cos_beta_squared * product_16
        + 46.0 * cos_beta_squared_squared * product_33
        + 72.0 * product_33
        + cos_beta
        + product_17 * term_2
        + product_42
        + product_43
        + product_44
        + product_45
    )
    sum_35 = 1.0 - 2.0 * cos_beta_squared + product_10
    sum_36 = (
        11.0 * product_3 * sin_beta_squared
        - 4.0 * baseline_per_path * sin_beta_squared
        - 6.0 * baseline_per_path_squared * cos_beta * sin_beta_squared
        - 8.0 * product_3
        - cos_beta
        + 4.0 * baseline_per_path
        + 5.0 * baseline_per_path_squared_squared * cos_beta
        + baseline_per_path_squared_squared * cos_beta * sin_beta_squared
    )
    sum_37 = (
        128.0 * baseline_per_path_squared * product_8 * product_9 * rho * sin_beta_squared * sum_27
        - 1536.0 * baseline_per_path_squared * product_15 * rho_squared * sigma_beta_squared * sigma_path_per_path_squared_squared * sum_21
        - 32.0 * sigma_beta_squared_squared * sin_beta * sum_22 * sum_3_squared * sum_4_squared * sum_5_squared
        - 384.0 * baseline_per_path_squared * cos_beta * product_15 * sigma_path_per_path_squared_squared * sum_16 * sum_3_squared
        - 384.0 * baseline_per_path_squared * product_9 * rho * sigma_beta * sin_beta_squared * sum_23 * sum_3_squared
        - 64.0 * product_8 * rho * sigma_path_per_path * sum_26 * sum_3_squared * sum_4 * sum_5
        - 64.0 * rho_squared * sigma_beta_squared * sigma_path_per_path_squared * sin_beta * sum_24 * sum_3_squared
        - 64.0 * sigma_beta_squared * sigma_path_per_path_squared * sin_beta * sum_25 * sum_3_squared
        + 192.0 * product_32 * rho * sigma_path_per_path * sum_28 * sum_4 * sum_5
        + 2304.0 * baseline_per_path_squared_squared * cos_beta * product_41 * sigma_path_per_path_squared_cubed
        + 2304.0 * baseline_per_path_squared_squared * product_14 * rho * sigma_beta * sin_beta_squared_squared * sum_29
        + 256.0 * rho_squared * sigma_beta_squared_squared * sigma_path_per_path_squared * sin_beta * sum_30
        + 512.0 * baseline_per_path_squared * product_7 * product_8 * product_9 * sin_beta_squared * sum_31
        + 64.0 * cos_beta * sigma_path_per_path_squared * sin_beta * sum_14_squared * sum_3_squared_squared
        + 64.0 * sigma_beta_squared * sin_beta * sum_32 * sum_3_squared_squared * sum_4_squared * sum_5_squared
        + 64.0 * sigma_beta_squared_cubed * sin_beta * sum_17 * sum_33 * sum_4_squared * sum_5_squared
        + 64.0 * sigma_beta_squared_squared * sigma_path_per_path_squared * sin_beta * sum_34
        + 64.0 * rho * sigma_beta * sigma_path_per_path * sum_14 * sum_35 * sum_3_squared_squared * sum_4 * sum_5
        + 768.0 * baseline_per_path_squared * product_15 * sigma_beta_squared * sigma_path_per_path_squared_squared * sum_36
    )
    sum_38 = (
        7.0
        - 16.0 * baseline_per_path * cos_beta
        - 2.0 * product_2 * product_3
        - 25.0 * baseline_per_path_squared * cos_beta_squared
        - 36.0 * baseline_per_path_squared_squared
        + 13.0 * baseline_per_path_squared
        + 13.0 * baseline_per_path_squared_squared * cos_beta_squared
        + 46.0 * cos_beta * product_3
    )
    sum_39 = (
        1.0
        - 3.0 * baseline_per_path_squared * cos_beta_squared
        - 4.0 * baseline_per_path * cos_beta
        - 6.0 * baseline_per_path_squared_squared
        + 3.0 * baseline_per_path_squared
        + 8.0 * cos_beta * product_3
        + baseline_per_path_squared_squared * cos_beta_squared
    )
    sum_40 = (
        28.0 * baseline_per_path_squared
        - 3.0
        - 26.0 * baseline_per_path * cos_beta
        - 32.0 * product_2 * product_3
        - 36.0 * baseline_per_path_squared_squared
        - 47.0 * baseline_per_path_squared * cos_beta_squared
        + 28.0 * baseline_per_path_squared_squared * cos_beta_squared
        + 52.0 * cos_beta * product_3
        + 7.0 * cos_beta_squared
        + product_28
        + product_29
    )
    sum_41 = (
        13.0 * baseline_per_path_squared * cos_beta
        - 2.0 * baseline_per_path
        - 6.0 * product_3
        - 9.0 * baseline_per_path * cos_beta_squared
        + 3.0 * cos_beta
        + cos_beta_squared * product_3
    )
    product_47 = baseline_per_path_squared_squared * sin_beta_squared
    sum_42 = (
        12.0 * baseline_per_path_squared
        - 1.0
        - 15.0 * baseline_per_path_squared * sin_beta_squared
        - 32.0 * cos_beta * product_3
        + 17.0 * baseline_per_path_squared_squared
        + product_30
        + product_47
    )
    product_48 = -8.0 * baseline_per_path * cos_beta
    product_49 = sin_beta_squared_squared * term_2
    sum_43 = (
        1.0
        - 124.0 * baseline_per_path_squared_cubed * sin_beta_squared
        - 13.0 * baseline_per_path_squared * sin_beta_squared
        - 31.0 * cos_beta * product_33 * sin_beta_squared
        - 36.0 * cos_beta * product_3 * sin_beta_squared
        - 86.0 * baseline_per_path_squared_squared
        - 9.0 * baseline_per_path_squared_cubed * sin_beta_squared_squared
        - 95.0 * cos_beta * product_33
        + 12.0 * baseline_per_path_squared_squared * sin_beta_squared_squared
        + 13.0 * cos_beta * product_3
        + 19.0 * baseline_per_path_squared
        + 22.0 * sin_beta_squared * term_2
        + 31.0 * term_2
        + 58.0 * cos_beta * product_16
        + 67.0 * baseline_per_path_squared_cubed
        + 83.0 * baseline_per_path_squared_squared * sin_beta_squared
        + 83.0 * cos_beta * product_16 * sin_beta_squared
        + product_48
        + product_49
    )
    sum_44 = (
        166.0 * product_16 * product_2
        - 4.0
        - 10.0 * baseline_per_path_squared
        - 132.0 * baseline_per_path_squared_squared * cos_beta_squared_squared
        - 140.0 * product_2 * product_3
        - 170.0 * cos_beta * product_16
        - 22.0 * baseline_per_path_squared * cos_beta_squared
        - 30.0 * baseline_per_path_squared_squared
        - 88.0 * baseline_per_path_squared_cubed * cos_beta_squared
        + 19.0 * baseline_per_path_squared_cubed * cos_beta_squared_squared
        + 207.0 * baseline_per_path_squared_squared * cos_beta_squared
        + 24.0 * baseline_per_path * cos_beta
        + 50.0 * cos_beta * product_3
        + 7.0 * cos_beta_squared
        + 72.0 * baseline_per_path_squared_cubed
        + product_18
        + product_19
        + product_21
        + product_22
    )
    sum_45 = (
        117.0 * baseline_per_path_squared_squared * cos_beta_squared
        - 2.0
        - 100.0 * cos_beta * product_16
        - 38.0 * baseline_per_path_squared_cubed * cos_beta_squared
        - 6.0 * baseline_per_path_squared_squared
        - 66.0 * baseline_per_path_squared_squared * cos_beta_squared_squared
        - 8.0 * baseline_per_path_squared
        - 88.0 * product_2 * product_3
        + 12.0 * baseline_per_path * cos_beta
        + 36.0 * baseline_per_path_squared_cubed
        + 4.0 * baseline_per_path_squared * cos_beta_squared
        + 5.0 * cos_beta_squared
        + 86.0 * product_16 * product_2
        + product_23
        + product_24
        + product_25
        + product_26
        + product_27
        + product_38
    )
    sum_46 = (
        1.0
        - 122.0 * baseline_per_path_squared_squared
        - 140.0 * cos_beta * product_33
        - 18.0 * baseline_per_path_squared_cubed * sin_beta_squared_squared
        - 214.0 * baseline_per_path_squared_cubed * sin_beta_squared
        - 22.0 * baseline_per_path_squared * sin_beta_squared
        - 72.0 * cos_beta * product_3 * sin_beta_squared
        - 76.0 * cos_beta * product_33 * sin_beta_squared
        + 112.0 * cos_beta * product_16
        + 146.0 * baseline_per_path_squared_squared * sin_beta_squared
        + 164.0 * cos_beta * product_16 * sin_beta_squared
        + 21.0 * baseline_per_path_squared_squared * sin_beta_squared_squared
        + 28.0 * baseline_per_path_squared
        + 49.0 * term_2
        + 58.0 * sin_beta_squared * term_2
        + 76.0 * baseline_per_path_squared_cubed
        + product_46
        + product_48
        + product_49
    )
    sum_47 = (
        16.0 * baseline_per_path_squared * cos_beta * sin_beta_squared
        - 25.0 * baseline_per_path
        - 6.0 * baseline_per_path_squared_squared * cos_beta * sin_beta_squared
        - 63.0 * product_3 * sin_beta_squared
        - 68.0 * baseline_per_path_squared_squared * cos_beta
        + 24.0 * baseline_per_path * sin_beta_squared
        + 24.0 * baseline_per_path_squared * cos_beta
        + 27.0 * product_16
        + 38.0 * product_3
        + 4.0 * cos_beta
        + 9.0 * product_16 * sin_beta_squared
    )
    sum_48 = (
        3.0 * baseline_per_path_squared
        - 1.0
        - 6.0 * baseline_per_path_squared * sin_beta_squared
        + 8.0 * baseline_per_path_squared_squared
        + product_30
        + product_40
        + product_47
    )
    sum_49 = (
        128.0 * rho * sigma_beta * sigma_path_per_path * sin_beta * sum_14 * sum_32 * sum_3_squared_squared * sum_4 * sum_5
        - 128.0 * product_8 * rho * sigma_path_per_path * sin_beta * sum_32 * sum_38 * sum_3_squared * sum_4 * sum_5
        - 3072.0 * baseline_per_path_squared * product_15 * product_7 * product_8 * product_9 * sum_32 * sum_39
        - 32.0 * sigma_beta_squared_squared * sum_3_squared * sum_40 * sum_4_squared * sum_5_squared
        - 384.0 * baseline_per_path_squared * sigma_path_per_path_squared_squared * sin_beta_squared_squared * sum_16 * sum_3_squared
        - 768.0 * baseline_per_path_squared * product_15 * product_9 * rho * sigma_beta * sum_3_squared * sum_41
        + 13824.0 * baseline_per_path_squared_squared * product_14 * product_41 * rho * sigma_beta * sum_32
        + 1536.0 * baseline_per_path_squared * rho_squared * sigma_beta_squared * sigma_path_per_path_squared_squared * sin_beta_squared_squared * sum_42
        + 2304.0 * baseline_per_path_squared_squared * sigma_path_per_path_squared_cubed * sin_beta_squared_cubed
        + 384.0 * product_32 * rho * sigma_path_per_path * sin_beta * sum_33 * sum_39 * sum_4 * sum_5
        + 512.0 * rho_squared * sigma_beta_squared_squared * sigma_path_per_path_squared * sin_beta_squared * sum_43
        + 64.0 * rho_squared * sigma_beta_squared * sigma_path_per_path_squared * sum_3_squared * sum_44
        + 64.0 * sigma_beta_squared * sigma_path_per_path_squared * sum_3_squared * sum_45
        + 64.0 * sigma_beta_squared * sum_32**2 * sum_3_squared_squared * sum_4_squared * sum_5_squared
        + 64.0 * sigma_beta_squared_cubed * sum_33**2 * sum_4_squared * sum_5_squared
        + 64.0 * sigma_beta_squared_squared * sigma_path_per_path_squared * sin_beta_squared * sum_46
        + 64.0 * sigma_path_per_path_squared * sin_beta_squared * sum_14_squared * sum_3_squared_squared
        + 768.0 * baseline_per_path_squared * product_15 * product_8 * product_9 * rho * sum_47
        + 768.0 * baseline_per_path_squared * sigma_beta_squared * sigma_path_per_path_squared_squared * sin_beta_squared_squared * sum_48
    )
    result = _empty(arguments, (2, 2))
    result[..., 0, 0] = path_squared * sum_20 * term_3
    result[..., 0, 1] = path_squared * sum_37 * term_3
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = path_squared * sum_49 * term_3
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

    Accuracy: measured, not proved: at most 8.5 ulp from 50-digit arithmetic at 500 points of this domain
    (float64, independent errors). Errors are measured against the sum of the variances to first order of
    independent errors.
    """
    arguments = _floats(path, beta, baseline, sigma_path, sigma_beta, rho)
    path, beta, baseline, sigma_path, sigma_beta, rho = arguments
    term_1 = 1.0 / path
    baseline_per_path = baseline * term_1
    sigma_path_per_path = sigma_path * term_1
    cos_beta = np.cos(beta)
    product_1 = -2.0 * baseline_per_path * cos_beta
    divisor_1 = 2.0 + product_1
    sin_beta = np.sin(beta)
    sin_beta_squared = sin_beta**2
    baseline_per_path_squared = baseline_per_path**2
    baseline_per_path_squared_squared = baseline_per_path_squared**2
    sigma_path_per_path_squared = sigma_path_per_path**2
    product_2 = sigma_path_per_path * sigma_path_per_path_squared**2
    product_3 = sin_beta * sin_beta_squared
    sum_1 = (
        2.0 * baseline_per_path * sin_beta_squared
        - 2.0 * baseline_per_path
        - 3.0 * cos_beta * sin_beta_squared
        + 2.0 * cos_beta
    )
    product_4 = baseline_per_path * baseline_per_path_squared
    product_5 = baseline_per_path * baseline_per_path_squared**2
    cos_beta_squared = cos_beta**2
    product_6 = -11.0 * baseline_per_path * cos_beta_squared
    cos_beta_squared_squared = cos_beta_squared**2
    product_7 = cos_beta * cos_beta_squared
    product_8 = cos_beta * cos_beta_squared**2
    sigma_beta_squared = sigma_beta**2
    product_9 = sigma_beta * sigma_beta_squared
    product_10 = sigma_path_per_path * sigma_path_per_path_squared
    sum_2 = (
        24.0 * baseline_per_path_squared * product_8
        - 10.0 * cos_beta_squared * product_5
        - 10.0 * product_4
        - 34.0 * baseline_per_path_squared_squared * cos_beta
        - 51.0 * cos_beta_squared_squared * product_4
        - 6.0 * product_7
        - 9.0 * baseline_per_path_squared_squared * product_8
        - 92.0 * baseline_per_path_squared * product_7
        + 28.0 * baseline_per_path_squared * cos_beta
        + 36.0 * baseline_per_path * cos_beta_squared_squared
        + 48.0 * baseline_per_path_squared_squared * product_7
        + 5.0 * cos_beta_squared_squared * product_5
        + 81.0 * cos_beta_squared * product_4
        + cos_beta
        + product_6
    )
    product_11 = -12.0 * baseline_per_path * product_7
    product_12 = 3.0 * baseline_per_path_squared_squared * cos_beta_squared_squared
    rho_squared = rho**2
    sigma_path_per_path_squared_squared = sigma_path_per_path_squared**2
    sum_3 = (
        3.0 * cos_beta_squared
        - 22.0 * baseline_per_path_squared_squared * cos_beta_squared
        - 28.0 * cos_beta * product_4
        - 4.0 * baseline_per_path_squared
        - 45.0 * baseline_per_path_squared * cos_beta_squared_squared
        + 45.0 * baseline_per_path_squared * cos_beta_squared
        + 60.0 * product_4 * product_7
        + product_11
        + product_12
    )
    product_13 = baseline_per_path * cos_beta
    sum_4 = product_13 - 1.0
    sum_4_squared = sum_4**2
    product_14 = -12.0 * baseline_per_path_squared_squared * cos_beta
    sum_5 = 1.0 + baseline_per_path
    sum_6 = baseline_per_path - 1.0
    sum_7 = (
        20.0 * cos_beta_squared * product_4
        - 12.0 * product_4
        - 17.0 * baseline_per_path_squared * product_7
        - 6.0 * baseline_per_path
        - cos_beta_squared_squared * product_4
        + 29.0 * baseline_per_path_squared * cos_beta
        + 5.0 * baseline_per_path_squared_squared * product_7
        + 5.0 * cos_beta
        + product_14
        + product_6
    )
    product_15 = 2.0 * baseline_per_path * cos_beta
    product_16 = -4.0 * baseline_per_path * cos_beta_squared
    product_17 = 4.0 * cos_beta_squared * product_4
    product_18 = baseline_per_path_squared_squared * product_7
    sum_8 = (
        7.0 * baseline_per_path_squared * cos_beta
        - 2.0 * baseline_per_path_squared_squared * cos_beta
        - 3.0 * baseline_per_path_squared * product_7
        - 4.0 * product_4
        + cos_beta
        + product_16
        + product_17
        + product_18
    )
    product_19 = rho * rho_squared
    sum_9 = 1.0 - 3.0 * cos_beta_squared + product_15
    sigma_path_per_path_squared_cubed = sigma_path_per_path_squared * sigma_path_per_path_squared**2
    sin_beta_squared_squared = sin_beta_squared**2
    sum_10 = (
        24.0 * product_4 * product_7
        - 10.0 * baseline_per_path_squared_squared * cos_beta_squared
        - 16.0 * cos_beta * product_4
        - 18.0 * baseline_per_path_squared * cos_beta_squared_squared
        - baseline_per_path_squared
        + 27.0 * baseline_per_path_squared * cos_beta_squared
        + 3.0 * cos_beta_squared
        + product_11
        + product_12
    )
    product_20 = -42.0 * baseline_per_path * product_7
    product_21 = -6.0 * product_5 * product_8
    baseline_per_path_squared_cubed = baseline_per_path_squared * baseline_per_path_squared**2
    product_22 = 14.0 * product_4 * product_8
    product_23 = 69.0 * baseline_per_path_squared * cos_beta_squared_squared
    sum_11 = (
        24.0 * cos_beta * product_4
        - 5.0
        - 30.0 * cos_beta * product_5
        - 37.0 * baseline_per_path_squared * cos_beta_squared
        - 6.0 * baseline_per_path_squared
        - 62.0 * product_4 * product_7
        - 64.0 * baseline_per_path_squared_squared * cos_beta_squared_squared
        - 9.0 * baseline_per_path_squared_cubed * cos_beta_squared
        - 9.0 * baseline_per_path_squared_squared
        + 30.0 * baseline_per_path * cos_beta
        + 40.0 * product_5 * product_7
        + 7.0 * baseline_per_path_squared_cubed * cos_beta_squared_squared
        + 7.0 * cos_beta_squared
        + 79.0 * baseline_per_path_squared_squared * cos_beta_squared
        + product_20
        + product_21
        + product_22
        + product_23
    )
    product_24 = 10.0 * product_4 * product_8
    product_25 = 24.0 * baseline_per_path_squared * cos_beta_squared_squared
    product_26 = 6.0 * baseline_per_path * cos_beta
    sum_12 = (
        12.0 * cos_beta * product_4
        - 1.0
        - 11.0 * baseline_per_path_squared * cos_beta_squared
        - 18.0 * cos_beta * product_5
        - 26.0 * baseline_per_path_squared_squared * cos_beta_squared_squared
        - 3.0 * baseline_per_path_squared_cubed * cos_beta_squared
        - 3.0 * baseline_per_path_squared_squared
        - 34.0 * product_4 * product_7
        + 2.0 * baseline_per_path_squared_cubed * cos_beta_squared_squared
        + 2.0 * cos_beta_squared
        + 26.0 * product_5 * product_7
        + 32.0 * baseline_per_path_squared_squared * cos_beta_squared
        + product_11
        + product_21
        + product_24
        + product_25
        + product_26
    )
    product_27 = -2.0 * cos_beta * product_4
    sum_13 = (
        2.0 * cos_beta_squared
        - 1.0
        - 2.0 * baseline_per_path_squared
        - 6.0 * baseline_per_path * product_7
        + 3.0 * baseline_per_path * cos_beta
        + 5.0 * baseline_per_path_squared * cos_beta_squared
        + product_27
        + product_4 * product_7
    )
    product_28 = baseline_per_path * baseline_per_path_squared * baseline_per_path_squared**2
    term_2 = (baseline_per_path_squared**2)**2
    product_29 = -4.0 * cos_beta_squared_squared * term_2
    product_30 = -8.0 * baseline_per_path * product_7
    cos_beta_squared_cubed = cos_beta_squared * cos_beta_squared**2
    product_31 = 4.0 * cos_beta_squared * term_2
    product_32 = cos_beta_squared_cubed * term_2
    sigma_beta_squared_squared = sigma_beta_squared**2
    sum_14 = (
        10.0 * baseline_per_path_squared * cos_beta_squared
        - 105.0 * baseline_per_path_squared_squared * cos_beta_squared_squared
        - 38.0 * product_28 * product_7
        - 46.0 * product_5 * product_8
        - 66.0 * product_4 * product_7
        - 7.0 * baseline_per_path_squared_squared
        - 74.0 * cos_beta * product_5
        - 9.0 * baseline_per_path_squared_cubed * cos_beta_squared_cubed
        - 93.0 * baseline_per_path_squared_cubed * cos_beta_squared
        + 10.0 * product_28 * product_8
        + 114.0 * baseline_per_path_squared_squared * cos_beta_squared
        + 12.0 * baseline_per_path_squared_squared * cos_beta_squared_cubed
        + 128.0 * product_5 * product_7
        + 13.0 * baseline_per_path_squared * cos_beta_squared_squared
        + 22.0 * baseline_per_path_squared_cubed
        + 28.0 * cos_beta * product_28
        + 36.0 * product_4 * product_8
        + 72.0 * baseline_per_path_squared_cubed * cos_beta_squared_squared
        + baseline_per_path_squared
        + cos_beta_squared
        + product_27
        + product_29
        + product_30
        + product_31
        + product_32
    )
    sum_4_squared_squared = sum_4_squared**2
    sum_15 = 1.0 + baseline_per_path_squared + product_1
    sum_5_squared = sum_5**2
    sum_6_squared = sum_6**2
    product_33 = 4.0 * baseline_per_path * cos_beta
    product_34 = baseline_per_path_squared * cos_beta_squared
    sum_16 = 1.0 - 6.0 * baseline_per_path_squared + product_33 + product_34
    sigma_beta_squared_cubed = sigma_beta_squared * sigma_beta_squared**2
    sum_17 = (
        16.0 * cos_beta * product_4
        - 120.0 * product_4 * product_7
        - 128.0 * cos_beta * product_5
        - 18.0 * baseline_per_path_squared_cubed * cos_beta_squared_cubed
        - 192.0 * baseline_per_path_squared_cubed * cos_beta_squared
        - 2.0 * baseline_per_path_squared * cos_beta_squared
        - 204.0 * baseline_per_path_squared_squared * cos_beta_squared_squared
        - 28.0 * baseline_per_path_squared_squared
        - 80.0 * product_28 * product_7
        - 88.0 * product_5 * product_8
        + 16.0 * product_28 * product_8
        + 162.0 * baseline_per_path_squared_cubed * cos_beta_squared_squared
        + 21.0 * baseline_per_path_squared_squared * cos_beta_squared_cubed
        + 22.0 * baseline_per_path_squared * cos_beta_squared_squared
        + 224.0 * product_5 * product_7
        + 225.0 * baseline_per_path_squared_squared * cos_beta_squared
        + 4.0 * baseline_per_path_squared
        + 40.0 * baseline_per_path_squared_cubed
        + 64.0 * cos_beta * product_28
        + 72.0 * product_4 * product_8
        + cos_beta_squared
        + product_29
        + product_30
        + product_31
        + product_32
    )
    product_35 = 14.0 * baseline_per_path * product_7
    product_36 = 5.0 * baseline_per_path_squared * cos_beta_squared_squared
    sum_18 = (
        24.0 * baseline_per_path_squared
        - 2.0
        - 20.0 * baseline_per_path * cos_beta
        - 26.0 * baseline_per_path_squared * cos_beta_squared
        + 5.0 * cos_beta_squared
        + product_35
        + product_36
    )
    sum_19 = product_15 - 1.0 - 2.0 * baseline_per_path_squared + product_34
    sum_15_squared = sum_15**2
    product_37 = sigma_beta * sigma_beta_squared**2
    term_3 = 1.0 / ((divisor_1**2)**2)**2
    path_squared = path**2
    sum_20 = (
        128.0 * cos_beta * rho * sigma_beta * sigma_path_per_path * sin_beta * sum_15 * sum_4_squared_squared * sum_5 * sum_6
        - 1152.0 * baseline_per_path_squared_squared * product_2 * product_3 * rho * sigma_beta * sum_1
        - 128.0 * baseline_per_path_squared * product_10 * product_9 * rho * sin_beta * sum_2
        - 128.0 * baseline_per_path_squared * rho_squared * sigma_beta_squared * sigma_path_per_path_squared_squared * sin_beta_squared * sum_3
        - 128.0 * product_9 * rho * sigma_path_per_path * sin_beta * sum_4_squared * sum_5 * sum_6 * sum_7
        - 256.0 * baseline_per_path_squared * product_10 * product_19 * product_9 * sin_beta * sum_8 * sum_9
        - 576.0 * baseline_per_path_squared_squared * sigma_path_per_path_squared_cubed * (1.0 + sin_beta) * (sin_beta - 1.0) * sin_beta_squared_squared
        - 64.0 * baseline_per_path_squared * sigma_beta_squared * sigma_path_per_path_squared_squared * sin_beta_squared * sum_10
        - 64.0 * rho_squared * sigma_beta_squared * sigma_path_per_path_squared * sum_11 * sum_4_squared
        - 64.0 * sigma_beta_squared * sigma_path_per_path_squared * sum_12 * sum_4_squared
        - 768.0 * baseline_per_path_squared * cos_beta * product_10 * rho * sigma_beta * sin_beta * sum_13 * sum_4_squared
        + 128.0 * rho_squared * sigma_beta_squared_squared * sigma_path_per_path_squared * sum_14
        + 16.0 * sigma_beta_squared_cubed * sin_beta_squared * sum_16**2 * sum_5_squared * sum_6_squared
        + 16.0 * sigma_beta_squared_squared * sigma_path_per_path_squared * sum_17
        + 32.0 * sigma_beta_squared_squared * sum_18 * sum_4_squared * sum_5_squared * sum_6_squared
        + 384.0 * baseline_per_path_squared * (1.0 + cos_beta) * (cos_beta - 1.0) * cos_beta_squared * sigma_path_per_path_squared_squared * sum_19 * sum_4_squared
        + 64.0 * cos_beta_squared * sigma_path_per_path_squared * sum_15_squared * sum_4_squared_squared
        + 64.0 * sigma_beta_squared * sin_beta_squared * sum_4_squared_squared * sum_5_squared * sum_6_squared
        + 96.0 * product_37 * rho * sigma_path_per_path * sin_beta * sum_16 * sum_5 * sum_6 * sum_8
    )
    product_38 = -6.0 * baseline_per_path * cos_beta_squared
    sum_21 = (
        12.0 * baseline_per_path_squared * product_7
        - 17.0 * baseline_per_path_squared_squared * product_7
        - 17.0 * cos_beta_squared * product_4
        - 3.0 * cos_beta_squared_squared * product_5
        - 6.0 * baseline_per_path_squared_cubed * cos_beta
        - 6.0 * product_5
        + 14.0 * baseline_per_path_squared_squared * cos_beta
        + 17.0 * cos_beta_squared * product_5
        + 2.0 * product_4
        + 3.0 * baseline_per_path_squared_cubed * product_7
        + 5.0 * cos_beta_squared_squared * product_4
        + baseline_per_path_squared * cos_beta
        + cos_beta
        + product_38
    )
    sum_22 = (
        11.0 * baseline_per_path
        - 14.0 * baseline_per_path * cos_beta_squared
        - 24.0 * product_4
        - 5.0 * baseline_per_path_squared * product_7
        - 5.0 * cos_beta
        + 11.0 * cos_beta_squared * product_4
        + 26.0 * baseline_per_path_squared * cos_beta
    )
    sum_23 = (
        10.0
        - 124.0 * baseline_per_path_squared * cos_beta_squared
        - 143.0 * product_4 * product_7
        - 2.0 * baseline_per_path_squared
        - 20.0 * cos_beta_squared
        - 24.0 * cos_beta * product_5
        - 28.0 * baseline_per_path_squared_squared * cos_beta_squared_squared
        - 3.0 * baseline_per_path * cos_beta
        - 72.0 * baseline_per_path_squared_squared
        + 104.0 * baseline_per_path_squared_squared * cos_beta_squared
        + 167.0 * cos_beta * product_4
        + 19.0 * product_5 * product_7
        + 4.0 * product_4 * product_8
        + 44.0 * baseline_per_path * product_7
        + 68.0 * baseline_per_path_squared * cos_beta_squared_squared
    )
    sum_24 = (
        13.0 * baseline_per_path_squared * cos_beta_squared
        - 1.0
        - 2.0 * baseline_per_path_squared
        - 6.0 * cos_beta * product_4
        + 2.0 * product_4 * product_7
        + 4.0 * cos_beta_squared
        + product_11
        + product_15
    )
    sum_25 = (
        26.0 * cos_beta_squared * product_4
        - 15.0 * baseline_per_path_squared * product_7
        - 6.0 * product_4
        + 9.0 * baseline_per_path_squared * cos_beta
        + cos_beta
        + product_14
        + product_16
        + product_18
    )
    sum_26 = (
        14.0 * cos_beta_squared_squared * product_4
        - 24.0 * baseline_per_path_squared_cubed * cos_beta
        - 24.0 * product_5
        - 4.0 * product_4
        - 42.0 * baseline_per_path * cos_beta_squared
        - 6.0 * cos_beta_squared_squared * product_5
        - 74.0 * baseline_per_path_squared_squared * product_7
        - 86.0 * cos_beta_squared * product_4
        + 22.0 * baseline_per_path_squared * cos_beta
        + 68.0 * cos_beta_squared * product_5
        + 69.0 * baseline_per_path_squared * product_7
        + 7.0 * cos_beta
        + 71.0 * baseline_per_path_squared_squared * cos_beta
        + 9.0 * baseline_per_path_squared_cubed * product_7
    )
    product_39 = 4.0 * cos_beta * product_4
    sum_27 = (
        5.0
        - 17.0 * baseline_per_path_squared * sin_beta_squared
        - 18.0 * baseline_per_path_squared * sin_beta_squared_squared
        - 25.0 * baseline_per_path * cos_beta
        - 29.0 * baseline_per_path_squared_squared
        - 51.0 * cos_beta * product_4 * sin_beta_squared
        - 6.0 * sin_beta_squared
        + 13.0 * cos_beta * product_5
        + 24.0 * baseline_per_path * cos_beta * sin_beta_squared
        + 32.0 * baseline_per_path_squared
        + 41.0 * baseline_per_path_squared_squared * sin_beta_squared
        + 5.0 * cos_beta * product_5 * sin_beta_squared
        + 6.0 * baseline_per_path_squared_squared * sin_beta_squared_squared
        + product_39
    )
    sum_28 = (
        4.0 * baseline_per_path
        - 6.0 * product_4
        - baseline_per_path_squared * product_7
        - cos_beta
        + 4.0 * baseline_per_path_squared * cos_beta
        + product_16
        + product_17
    )
    product_40 = -18.0 * baseline_per_path_squared_cubed * product_8
    product_41 = -24.0 * product_7 * term_2
    product_42 = 36.0 * cos_beta * term_2
    product_43 = 72.0 * cos_beta_squared_squared * product_4
    sum_29 = (
        10.0 * product_4
        - 126.0 * cos_beta_squared_squared * product_5
        - 146.0 * cos_beta_squared * product_28
        - 188.0 * baseline_per_path_squared_cubed * cos_beta
        - 196.0 * baseline_per_path_squared_squared * product_7
        - 74.0 * product_5
        - 8.0 * baseline_per_path * cos_beta_squared
        - 94.0 * cos_beta_squared * product_4
        + 121.0 * baseline_per_path_squared_squared * cos_beta
        + 190.0 * baseline_per_path_squared_cubed * product_7
        + 2.0 * baseline_per_path_squared * cos_beta
        + 21.0 * baseline_per_path_squared_squared * product_8
        + 22.0 * baseline_per_path_squared * product_7
        + 280.0 * cos_beta_squared * product_5
        + 46.0 * cos_beta_squared_squared * product_28
        + 72.0 * product_28
        + cos_beta
        + product_40
        + product_41
        + product_42
        + product_43
        + product_8 * term_2
    )
    sum_30 = (
        11.0 * product_4 * sin_beta_squared
        - 4.0 * baseline_per_path * sin_beta_squared
        - 6.0 * baseline_per_path_squared * cos_beta * sin_beta_squared
        - 8.0 * product_4
        - cos_beta
        + 4.0 * baseline_per_path
        + 5.0 * baseline_per_path_squared_squared * cos_beta
        + baseline_per_path_squared_squared * cos_beta * sin_beta_squared
    )
    product_44 = 14.0 * cos_beta * product_4
    sum_31 = (
        22.0
        - 112.0 * baseline_per_path_squared * sin_beta_squared
        - 125.0 * baseline_per_path * cos_beta
        - 154.0 * baseline_per_path_squared_squared
        - 24.0 * sin_beta_squared
        - 291.0 * cos_beta * product_4 * sin_beta_squared
        - 96.0 * baseline_per_path_squared * sin_beta_squared_squared
        + 144.0 * baseline_per_path * cos_beta * sin_beta_squared
        + 172.0 * baseline_per_path_squared
        + 226.0 * baseline_per_path_squared_squared * sin_beta_squared
        + 36.0 * baseline_per_path_squared_squared * sin_beta_squared_squared
        + 37.0 * cos_beta * product_5 * sin_beta_squared
        + 71.0 * cos_beta * product_5
        + product_44
    )
    product_45 = -14.0 * cos_beta * product_4
    sin_beta_squared_cubed = sin_beta_squared * sin_beta_squared**2
    sum_32 = (
        2.0 * baseline_per_path_squared_cubed * sin_beta_squared_cubed
        - 1.0
        - 3.0 * baseline_per_path_squared_cubed
        - 32.0 * cos_beta * product_5 * sin_beta_squared_squared
        - 38.0 * baseline_per_path_squared * sin_beta_squared
        - 6.0 * baseline_per_path_squared_squared * sin_beta_squared_cubed
        - 8.0 * cos_beta * product_5
        - 91.0 * baseline_per_path_squared_squared * sin_beta_squared_squared
        - 98.0 * cos_beta * product_5 * sin_beta_squared
        - baseline_per_path_squared
        + 2.0 * cos_beta * product_28
        + 2.0 * sin_beta_squared
        + 21.0 * baseline_per_path_squared_squared
        + 29.0 * baseline_per_path_squared_cubed * sin_beta_squared_squared
        + 32.0 * baseline_per_path_squared_cubed * sin_beta_squared
        + 32.0 * cos_beta * product_4 * sin_beta_squared_squared
        + 36.0 * baseline_per_path_squared * sin_beta_squared_squared
        + 36.0 * baseline_per_path_squared_squared * sin_beta_squared
        + 4.0 * cos_beta * product_28 * sin_beta_squared_squared
        + 52.0 * cos_beta * product_4 * sin_beta_squared
        + 6.0 * cos_beta * product_28 * sin_beta_squared
        + product_33
        + product_45
    )
    sum_33 = 5.0 * baseline_per_path * cos_beta - 5.0 + 6.0 * sin_beta_squared
    product_46 = sin_beta * sin_beta_squared**2
    sum_34 = baseline_per_path - cos_beta
    sum_35 = (
        104.0 * baseline_per_path_squared_squared * cos_beta
        - 129.0 * cos_beta_squared_squared * product_5
        - 139.0 * cos_beta_squared * product_28
        - 16.0 * baseline_per_path * cos_beta_squared
        - 212.0 * baseline_per_path_squared_squared * product_7
        - 214.0 * baseline_per_path_squared_cubed * cos_beta
        - 55.0 * product_5
        - 89.0 * cos_beta_squared * product_4
        - product_4
        + 16.0 * baseline_per_path_squared * cos_beta
        + 194.0 * baseline_per_path_squared_cubed * product_7
        + 2.0 * cos_beta
        + 2.0 * product_8 * term_2
        + 24.0 * baseline_per_path_squared_squared * product_8
        + 26.0 * baseline_per_path_squared * product_7
        + 308.0 * cos_beta_squared * product_5
        + 41.0 * cos_beta_squared_squared * product_28
        + 72.0 * product_28
        + product_40
        + product_41
        + product_42
        + product_43
    )
    sum_36 = 1.0 - 2.0 * cos_beta_squared + product_13
    sum_37 = (
        128.0 * baseline_per_path_squared * product_10 * product_19 * product_9 * sin_beta_squared * sum_27
        - 128.0 * sigma_beta_squared * sigma_path_per_path_squared * sin_beta * sum_21 * sum_4_squared
        - 32.0 * product_9 * rho * sigma_path_per_path * sum_23 * sum_4_squared * sum_5 * sum_6
        - 32.0 * sigma_beta_squared_squared * sin_beta * sum_22 * sum_4_squared * sum_5_squared * sum_6_squared
        - 384.0 * baseline_per_path_squared * cos_beta * product_3 * sigma_path_per_path_squared_squared * sum_19 * sum_4_squared
        - 384.0 * baseline_per_path_squared * product_10 * rho * sigma_beta * sin_beta_squared * sum_24 * sum_4_squared
        - 384.0 * baseline_per_path_squared * product_3 * rho_squared * sigma_beta_squared * sigma_path_per_path_squared_squared * sum_25
        - 64.0 * rho_squared * sigma_beta_squared * sigma_path_per_path_squared * sin_beta * sum_26 * sum_4_squared
        + 16.0 * sigma_beta_squared_cubed * sin_beta * sum_16 * sum_28 * sum_5_squared * sum_6_squared
        + 16.0 * sigma_beta_squared_squared * sigma_path_per_path_squared * sin_beta * sum_29
        + 192.0 * baseline_per_path_squared * product_3 * sigma_beta_squared * sigma_path_per_path_squared_squared * sum_30
        + 32.0 * baseline_per_path_squared * product_10 * product_9 * rho * sin_beta_squared * sum_31
        + 48.0 * product_37 * rho * sigma_path_per_path * sum_32 * sum_5 * sum_6
        + 576.0 * baseline_per_path_squared_squared * cos_beta * product_46 * sigma_path_per_path_squared_cubed
        + 576.0 * baseline_per_path_squared_squared * product_2 * rho * sigma_beta * sin_beta_squared_squared * sum_33
        + 64.0 * cos_beta * sigma_path_per_path_squared * sin_beta * sum_15_squared * sum_4_squared_squared
        + 64.0 * rho_squared * sigma_beta_squared_squared * sigma_path_per_path_squared * sin_beta * sum_35
        + 64.0 * sigma_beta_squared * sin_beta * sum_34 * sum_4_squared_squared * sum_5_squared * sum_6_squared
        + 64.0 * rho * sigma_beta * sigma_path_per_path * sum_15 * sum_36 * sum_4_squared_squared * sum_5 * sum_6
    )
    sum_38 = (
        20.0 * baseline_per_path_squared
        - 3.0
        - 16.0 * baseline_per_path * cos_beta
        - 22.0 * product_4 * product_7
        - 24.0 * baseline_per_path_squared_squared
        - 31.0 * baseline_per_path_squared * cos_beta_squared
        + 20.0 * baseline_per_path_squared_squared * cos_beta_squared
        + 32.0 * cos_beta * product_4
        + 5.0 * cos_beta_squared
        + product_35
        + product_36
    )
    sum_39 = (
        106.0 * baseline_per_path_squared_squared * cos_beta
        - 10.0 * cos_beta
        - 101.0 * cos_beta_squared * product_4
        - 18.0 * baseline_per_path_squared_squared * product_7
        - 32.0 * baseline_per_path_squared * cos_beta
        - 48.0 * product_5
        + 19.0 * cos_beta_squared * product_5
        + 19.0 * product_4
        + 2.0 * cos_beta_squared_squared * product_4
        + 22.0 * baseline_per_path * cos_beta_squared
        + 34.0 * baseline_per_path_squared * product_7
        + 7.0 * baseline_per_path
    )
    sum_40 = (
        1.0
        - 3.0 * baseline_per_path_squared * cos_beta_squared
        - 4.0 * baseline_per_path * cos_beta
        - 6.0 * baseline_per_path_squared_squared
        + 3.0 * baseline_per_path_squared
        + 8.0 * cos_beta * product_4
        + baseline_per_path_squared_squared * cos_beta_squared
    )
    sum_41 = (
        2.0 * cos_beta
        - 4.0 * product_4
        - baseline_per_path
        + 8.0 * baseline_per_path_squared * cos_beta
        + cos_beta_squared * product_4
        + product_38
    )
    product_47 = -8.0 * baseline_per_path * cos_beta
    product_48 = sin_beta_squared_squared * term_2
    sum_42 = (
        1.0
        - 124.0 * baseline_per_path_squared_cubed * sin_beta_squared
        - 13.0 * baseline_per_path_squared * sin_beta_squared
        - 31.0 * cos_beta * product_28 * sin_beta_squared
        - 36.0 * cos_beta * product_4 * sin_beta_squared
        - 86.0 * baseline_per_path_squared_squared
        - 9.0 * baseline_per_path_squared_cubed * sin_beta_squared_squared
        - 95.0 * cos_beta * product_28
        + 12.0 * baseline_per_path_squared_squared * sin_beta_squared_squared
        + 13.0 * cos_beta * product_4
        + 19.0 * baseline_per_path_squared
        + 22.0 * sin_beta_squared * term_2
        + 31.0 * term_2
        + 58.0 * cos_beta * product_5
        + 67.0 * baseline_per_path_squared_cubed
        + 83.0 * baseline_per_path_squared_squared * sin_beta_squared
        + 83.0 * cos_beta * product_5 * sin_beta_squared
        + product_47
        + product_48
    )
    sum_43 = (
        1.0
        - 122.0 * baseline_per_path_squared_squared
        - 140.0 * cos_beta * product_28
        - 18.0 * baseline_per_path_squared_cubed * sin_beta_squared_squared
        - 214.0 * baseline_per_path_squared_cubed * sin_beta_squared
        - 22.0 * baseline_per_path_squared * sin_beta_squared
        - 72.0 * cos_beta * product_4 * sin_beta_squared
        - 76.0 * cos_beta * product_28 * sin_beta_squared
        + 112.0 * cos_beta * product_5
        + 146.0 * baseline_per_path_squared_squared * sin_beta_squared
        + 164.0 * cos_beta * product_5 * sin_beta_squared
        + 21.0 * baseline_per_path_squared_squared * sin_beta_squared_squared
        + 28.0 * baseline_per_path_squared
        + 49.0 * term_2
        + 58.0 * sin_beta_squared * term_2
        + 76.0 * baseline_per_path_squared_cubed
        + product_39
        + product_47
        + product_48
    )
    sum_44 = (
        16.0 * baseline_per_path_squared * cos_beta * sin_beta_squared
        - 25.0 * baseline_per_path
        - 6.0 * baseline_per_path_squared_squared * cos_beta * sin_beta_squared
        - 63.0 * product_4 * sin_beta_squared
        - 68.0 * baseline_per_path_squared_squared * cos_beta
        + 24.0 * baseline_per_path * sin_beta_squared
        + 24.0 * baseline_per_path_squared * cos_beta
        + 27.0 * product_5
        + 38.0 * product_4
        + 4.0 * cos_beta
        + 9.0 * product_5 * sin_beta_squared
    )
    product_49 = baseline_per_path_squared_squared * sin_beta_squared
    sum_45 = (
        3.0 * baseline_per_path_squared
        - 1.0
        - 6.0 * baseline_per_path_squared * sin_beta_squared
        + 8.0 * baseline_per_path_squared_squared
        + product_33
        + product_45
        + product_49
    )
    sum_46 = (
        12.0 * baseline_per_path_squared
        - 1.0
        - 15.0 * baseline_per_path_squared * sin_beta_squared
        - 32.0 * cos_beta * product_4
        + 17.0 * baseline_per_path_squared_squared
        + product_33
        + product_49
    )
    sum_47 = (
        10.0 * cos_beta * product_4
        - 2.0
        - 12.0 * baseline_per_path_squared_squared
        - 124.0 * product_4 * product_7
        - 126.0 * cos_beta * product_5
        - 54.0 * baseline_per_path_squared_cubed * cos_beta_squared
        - 6.0 * baseline_per_path_squared
        - 84.0 * baseline_per_path_squared_squared * cos_beta_squared_squared
        + 102.0 * product_5 * product_7
        + 11.0 * baseline_per_path_squared_cubed * cos_beta_squared_squared
        + 12.0 * baseline_per_path * cos_beta
        + 12.0 * baseline_per_path_squared * cos_beta_squared
        + 171.0 * baseline_per_path_squared_squared * cos_beta_squared
        + 48.0 * baseline_per_path_squared_cubed
        + 7.0 * cos_beta_squared
        + product_20
        + product_21
        + product_22
        + product_23
    )
    sum_48 = (
        10.0 * baseline_per_path_squared_cubed * cos_beta_squared_squared
        - 1.0
        - 15.0 * baseline_per_path_squared_squared
        - 33.0 * baseline_per_path_squared_cubed * cos_beta_squared
        - 42.0 * baseline_per_path_squared_squared * cos_beta_squared_squared
        - 44.0 * product_4 * product_7
        - 48.0 * cos_beta * product_5
        - 9.0 * baseline_per_path_squared * cos_beta_squared
        + 2.0 * cos_beta_squared
        + 24.0 * baseline_per_path_squared_cubed
        + 48.0 * product_5 * product_7
        + 72.0 * baseline_per_path_squared_squared * cos_beta_squared
        + product_11
        + product_21
        + product_24
        + product_25
        + product_26
        + product_44
    )
    sum_49 = (
        128.0 * rho_squared * sigma_beta_squared_squared * sigma_path_per_path_squared * sin_beta_squared * sum_42
        - 32.0 * sigma_beta_squared_squared * sum_38 * sum_4_squared * sum_5_squared * sum_6_squared
        - 384.0 * baseline_per_path_squared * sigma_path_per_path_squared_squared * sin_beta_squared_squared * sum_19 * sum_4_squared
        - 64.0 * product_9 * rho * sigma_path_per_path * sin_beta * sum_39 * sum_4_squared * sum_5 * sum_6
        - 768.0 * baseline_per_path_squared * product_10 * product_19 * product_3 * product_9 * sum_34 * sum_40
        - 768.0 * baseline_per_path_squared * product_10 * product_3 * rho * sigma_beta * sum_41 * sum_4_squared
        + 128.0 * rho * sigma_beta * sigma_path_per_path * sin_beta * sum_15 * sum_34 * sum_4_squared_squared * sum_5 * sum_6
        + 16.0 * sigma_beta_squared_cubed * sum_28**2 * sum_5_squared * sum_6_squared
        + 16.0 * sigma_beta_squared_squared * sigma_path_per_path_squared * sin_beta_squared * sum_43
        + 192.0 * baseline_per_path_squared * product_10 * product_3 * product_9 * rho * sum_44
        + 192.0 * baseline_per_path_squared * sigma_beta_squared * sigma_path_per_path_squared_squared * sin_beta_squared_squared * sum_45
        + 3456.0 * baseline_per_path_squared_squared * product_2 * product_46 * rho * sigma_beta * sum_34
        + 384.0 * baseline_per_path_squared * rho_squared * sigma_beta_squared * sigma_path_per_path_squared_squared * sin_beta_squared_squared * sum_46
        + 576.0 * baseline_per_path_squared_squared * sigma_path_per_path_squared_cubed * sin_beta_squared_cubed
        + 64.0 * rho_squared * sigma_beta_squared * sigma_path_per_path_squared * sum_47 * sum_4_squared
        + 64.0 * sigma_beta_squared * sigma_path_per_path_squared * sum_48 * sum_4_squared
        + 64.0 * sigma_beta_squared * sum_34**2 * sum_4_squared_squared * sum_5_squared * sum_6_squared
        + 64.0 * sigma_path_per_path_squared * sin_beta_squared * sum_15_squared * sum_4_squared_squared
        + 96.0 * product_37 * rho * sigma_path_per_path * sin_beta * sum_28 * sum_40 * sum_5 * sum_6
    )
    result = _empty(arguments, (2, 2))
    result[..., 0, 0] = path_squared * sum_20 * term_3
    result[..., 0, 1] = path_squared * sum_37 * term_3
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = path_squared * sum_49 * term_3
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

    Accuracy: measured, not proved: at most 8 ulp from 50-digit arithmetic at 500 points of this domain
    (float64, independent errors). Errors are measured against the sum of the variances to first order of
    independent errors.
    """
    arguments = _floats(path, beta, baseline, sigma_path, sigma_beta, rho)
    path, beta, baseline, sigma_path, sigma_beta, rho = arguments
    term_1 = 1.0 / path
    baseline_per_path = baseline * term_1
    sigma_path_per_path = sigma_path * term_1
    cos_beta = np.cos(beta)
    product_1 = -2.0 * baseline_per_path * cos_beta
    divisor_1 = 2.0 + product_1
    sin_beta = np.sin(beta)
    sin_beta_squared = sin_beta**2
    baseline_per_path_squared = baseline_per_path**2
    baseline_per_path_squared_squared = baseline_per_path_squared**2
    sigma_path_per_path_squared = sigma_path_per_path**2
    product_2 = sigma_path_per_path * sigma_path_per_path_squared**2
    product_3 = sin_beta * sin_beta_squared
    sum_1 = (
        2.0 * baseline_per_path * sin_beta_squared
        - 2.0 * baseline_per_path
        - 3.0 * cos_beta * sin_beta_squared
        + 2.0 * cos_beta
    )
    product_4 = baseline_per_path * baseline_per_path_squared
    product_5 = baseline_per_path * baseline_per_path_squared**2
    cos_beta_squared = cos_beta**2
    cos_beta_squared_squared = cos_beta_squared**2
    product_6 = cos_beta * cos_beta_squared
    product_7 = cos_beta * cos_beta_squared**2
    sigma_beta_squared = sigma_beta**2
    product_8 = sigma_beta * sigma_beta_squared
    product_9 = sigma_path_per_path * sigma_path_per_path_squared
    sum_2 = (
        24.0 * baseline_per_path_squared * product_7
        - 10.0 * cos_beta_squared * product_5
        - 10.0 * product_4
        - 11.0 * baseline_per_path * cos_beta_squared
        - 34.0 * baseline_per_path_squared_squared * cos_beta
        - 51.0 * cos_beta_squared_squared * product_4
        - 6.0 * product_6
        - 9.0 * baseline_per_path_squared_squared * product_7
        - 92.0 * baseline_per_path_squared * product_6
        + 28.0 * baseline_per_path_squared * cos_beta
        + 36.0 * baseline_per_path * cos_beta_squared_squared
        + 48.0 * baseline_per_path_squared_squared * product_6
        + 5.0 * cos_beta_squared_squared * product_5
        + 81.0 * cos_beta_squared * product_4
        + cos_beta
    )
    product_10 = -12.0 * baseline_per_path * product_6
    product_11 = 3.0 * baseline_per_path_squared_squared * cos_beta_squared_squared
    rho_squared = rho**2
    sigma_path_per_path_squared_squared = sigma_path_per_path_squared**2
    sum_3 = (
        3.0 * cos_beta_squared
        - 22.0 * baseline_per_path_squared_squared * cos_beta_squared
        - 28.0 * cos_beta * product_4
        - 4.0 * baseline_per_path_squared
        - 45.0 * baseline_per_path_squared * cos_beta_squared_squared
        + 45.0 * baseline_per_path_squared * cos_beta_squared
        + 60.0 * product_4 * product_6
        + product_10
        + product_11
    )
    product_12 = baseline_per_path * cos_beta
    sum_4 = product_12 - 1.0
    sum_4_squared = sum_4**2
    sum_5 = 1.0 + baseline_per_path
    sum_6 = baseline_per_path - 1.0
    sum_7 = (
        15.0 * baseline_per_path_squared * cos_beta
        - 11.0 * baseline_per_path_squared * product_6
        - 2.0 * baseline_per_path
        - 7.0 * baseline_per_path * cos_beta_squared
        - 8.0 * baseline_per_path_squared_squared * cos_beta
        - 8.0 * product_4
        - cos_beta_squared_squared * product_4
        + 16.0 * cos_beta_squared * product_4
        + 3.0 * baseline_per_path_squared_squared * product_6
        + 3.0 * cos_beta
    )
    product_13 = -3.0 * baseline_per_path_squared * product_6
    product_14 = -4.0 * baseline_per_path * cos_beta_squared
    product_15 = 4.0 * cos_beta_squared * product_4
    product_16 = baseline_per_path_squared_squared * product_6
    sum_8 = (
        7.0 * baseline_per_path_squared * cos_beta
        - 2.0 * baseline_per_path_squared_squared * cos_beta
        - 4.0 * product_4
        + cos_beta
        + product_13
        + product_14
        + product_15
        + product_16
    )
    product_17 = rho * rho_squared
    sum_9 = 1.0 - 3.0 * cos_beta_squared + 2.0 * baseline_per_path * cos_beta
    sum_10 = (
        13.0 * baseline_per_path_squared * cos_beta_squared
        - 1.0
        - 4.0 * baseline_per_path_squared
        - 4.0 * cos_beta * product_4
        + 3.0 * baseline_per_path * cos_beta
        + 4.0 * cos_beta_squared
        + product_10
        + product_4 * product_6
    )
    sigma_path_per_path_squared_cubed = sigma_path_per_path_squared * sigma_path_per_path_squared**2
    sin_beta_squared_squared = sin_beta_squared**2
    sum_11 = (
        24.0 * product_4 * product_6
        - 10.0 * baseline_per_path_squared_squared * cos_beta_squared
        - 16.0 * cos_beta * product_4
        - 18.0 * baseline_per_path_squared * cos_beta_squared_squared
        - baseline_per_path_squared
        + 27.0 * baseline_per_path_squared * cos_beta_squared
        + 3.0 * cos_beta_squared
        + product_10
        + product_11
    )
    product_18 = -18.0 * baseline_per_path * product_6
    baseline_per_path_squared_cubed = baseline_per_path_squared * baseline_per_path_squared**2
    product_19 = -6.0 * product_5 * product_7
    product_20 = 14.0 * product_4 * product_7
    product_21 = 33.0 * baseline_per_path_squared * cos_beta_squared_squared
    product_22 = 6.0 * baseline_per_path * cos_beta
    product_23 = 8.0 * cos_beta * product_4
    sum_12 = (
        2.0 * baseline_per_path_squared
        - 1.0
        - 22.0 * cos_beta * product_5
        - 40.0 * baseline_per_path_squared_squared * cos_beta_squared_squared
        - 46.0 * product_4 * product_6
        - 5.0 * baseline_per_path_squared_cubed * cos_beta_squared
        - 5.0 * baseline_per_path_squared_squared
        - 9.0 * baseline_per_path_squared * cos_beta_squared
        + 3.0 * baseline_per_path_squared_cubed * cos_beta_squared_squared
        + 3.0 * cos_beta_squared
        + 32.0 * product_5 * product_6
        + 51.0 * baseline_per_path_squared_squared * cos_beta_squared
        + product_18
        + product_19
        + product_20
        + product_21
        + product_22
        + product_23
    )
    product_24 = -2.0 * product_5 * product_7
    product_25 = 2.0 * baseline_per_path_squared_cubed * cos_beta_squared_squared
    product_26 = 20.0 * baseline_per_path_squared * cos_beta_squared_squared
    product_27 = 4.0 * cos_beta * product_4
    product_28 = 6.0 * product_4 * product_7
    sum_13 = (
        14.0 * product_5 * product_6
        - 1.0
        - 10.0 * cos_beta * product_5
        - 22.0 * baseline_per_path_squared_squared * cos_beta_squared_squared
        - 22.0 * product_4 * product_6
        - 3.0 * baseline_per_path_squared_cubed * cos_beta_squared
        - 3.0 * baseline_per_path_squared_squared
        - 7.0 * baseline_per_path_squared * cos_beta_squared
        + 2.0 * cos_beta_squared
        + 28.0 * baseline_per_path_squared_squared * cos_beta_squared
        + product_10
        + product_22
        + product_24
        + product_25
        + product_26
        + product_27
        + product_28
    )
    product_29 = baseline_per_path_squared * cos_beta_squared
    sum_14 = product_22 - 3.0 - 4.0 * baseline_per_path_squared + product_29
    product_30 = baseline_per_path * baseline_per_path_squared * baseline_per_path_squared**2
    term_2 = (baseline_per_path_squared**2)**2
    product_31 = -4.0 * cos_beta_squared_squared * term_2
    product_32 = -8.0 * baseline_per_path * product_6
    cos_beta_squared_cubed = cos_beta_squared * cos_beta_squared**2
    product_33 = 4.0 * cos_beta_squared * term_2
    product_34 = cos_beta_squared_cubed * term_2
    sigma_beta_squared_squared = sigma_beta_squared**2
    sum_15 = (
        10.0 * baseline_per_path_squared * cos_beta_squared
        - 105.0 * baseline_per_path_squared_squared * cos_beta_squared_squared
        - 2.0 * cos_beta * product_4
        - 38.0 * product_30 * product_6
        - 46.0 * product_5 * product_7
        - 66.0 * product_4 * product_6
        - 7.0 * baseline_per_path_squared_squared
        - 74.0 * cos_beta * product_5
        - 9.0 * baseline_per_path_squared_cubed * cos_beta_squared_cubed
        - 93.0 * baseline_per_path_squared_cubed * cos_beta_squared
        + 10.0 * product_30 * product_7
        + 114.0 * baseline_per_path_squared_squared * cos_beta_squared
        + 12.0 * baseline_per_path_squared_squared * cos_beta_squared_cubed
        + 128.0 * product_5 * product_6
        + 13.0 * baseline_per_path_squared * cos_beta_squared_squared
        + 22.0 * baseline_per_path_squared_cubed
        + 28.0 * cos_beta * product_30
        + 36.0 * product_4 * product_7
        + 72.0 * baseline_per_path_squared_cubed * cos_beta_squared_squared
        + baseline_per_path_squared
        + cos_beta_squared
        + product_31
        + product_32
        + product_33
        + product_34
    )
    sum_4_squared_squared = sum_4_squared**2
    sum_16 = 1.0 + baseline_per_path_squared + product_1
    sum_5_squared = sum_5**2
    sum_6_squared = sum_6**2
    product_35 = 4.0 * baseline_per_path * cos_beta
    sum_17 = 1.0 - 6.0 * baseline_per_path_squared + product_29 + product_35
    sigma_beta_squared_cubed = sigma_beta_squared * sigma_beta_squared**2
    sum_18 = (
        16.0 * cos_beta * product_4
        - 120.0 * product_4 * product_6
        - 128.0 * cos_beta * product_5
        - 18.0 * baseline_per_path_squared_cubed * cos_beta_squared_cubed
        - 192.0 * baseline_per_path_squared_cubed * cos_beta_squared
        - 2.0 * baseline_per_path_squared * cos_beta_squared
        - 204.0 * baseline_per_path_squared_squared * cos_beta_squared_squared
        - 28.0 * baseline_per_path_squared_squared
        - 80.0 * product_30 * product_6
        - 88.0 * product_5 * product_7
        + 16.0 * product_30 * product_7
        + 162.0 * baseline_per_path_squared_cubed * cos_beta_squared_squared
        + 21.0 * baseline_per_path_squared_squared * cos_beta_squared_cubed
        + 22.0 * baseline_per_path_squared * cos_beta_squared_squared
        + 224.0 * product_5 * product_6
        + 225.0 * baseline_per_path_squared_squared * cos_beta_squared
        + 4.0 * baseline_per_path_squared
        + 40.0 * baseline_per_path_squared_cubed
        + 64.0 * cos_beta * product_30
        + 72.0 * product_4 * product_7
        + cos_beta_squared
        + product_31
        + product_32
        + product_33
        + product_34
    )
    product_36 = -12.0 * baseline_per_path * cos_beta
    product_37 = 10.0 * baseline_per_path * product_6
    product_38 = 3.0 * baseline_per_path_squared * cos_beta_squared_squared
    sum_19 = (
        16.0 * baseline_per_path_squared
        - 2.0
        - 18.0 * baseline_per_path_squared * cos_beta_squared
        + 3.0 * cos_beta_squared
        + product_36
        + product_37
        + product_38
    )
    sum_16_squared = sum_16**2
    product_39 = sigma_beta * sigma_beta_squared**2
    term_3 = 1.0 / ((divisor_1**2)**2)**2
    path_squared = path**2
    sum_20 = (
        128.0 * baseline_per_path_squared * (1.0 + cos_beta) * (cos_beta - 1.0) * cos_beta_squared * sigma_path_per_path_squared_squared * sum_14 * sum_4_squared
        - 1152.0 * baseline_per_path_squared_squared * product_2 * product_3 * rho * sigma_beta * sum_1
        - 128.0 * baseline_per_path_squared * product_8 * product_9 * rho * sin_beta * sum_2
        - 128.0 * baseline_per_path_squared * rho_squared * sigma_beta_squared * sigma_path_per_path_squared_squared * sin_beta_squared * sum_3
        - 128.0 * product_8 * rho * sigma_path_per_path * sin_beta * sum_4_squared * sum_5 * sum_6 * sum_7
        - 256.0 * baseline_per_path_squared * cos_beta * product_9 * rho * sigma_beta * sin_beta * sum_10 * sum_4_squared
        - 256.0 * baseline_per_path_squared * product_17 * product_8 * product_9 * sin_beta * sum_8 * sum_9
        - 576.0 * baseline_per_path_squared_squared * sigma_path_per_path_squared_cubed * (1.0 + sin_beta) * (sin_beta - 1.0) * sin_beta_squared_squared
        - 64.0 * baseline_per_path_squared * sigma_beta_squared * sigma_path_per_path_squared_squared * sin_beta_squared * sum_11
        - 64.0 * rho_squared * sigma_beta_squared * sigma_path_per_path_squared * sum_12 * sum_4_squared
        - 64.0 * sigma_beta_squared * sigma_path_per_path_squared * sum_13 * sum_4_squared
        + 128.0 * cos_beta * rho * sigma_beta * sigma_path_per_path * sin_beta * sum_16 * sum_4_squared_squared * sum_5 * sum_6
        + 128.0 * rho_squared * sigma_beta_squared_squared * sigma_path_per_path_squared * sum_15
        + 16.0 * sigma_beta_squared_cubed * sin_beta_squared * sum_17**2 * sum_5_squared * sum_6_squared
        + 16.0 * sigma_beta_squared_squared * sigma_path_per_path_squared * sum_18
        + 32.0 * sigma_beta_squared_squared * sum_19 * sum_4_squared * sum_5_squared * sum_6_squared
        + 64.0 * cos_beta_squared * sigma_path_per_path_squared * sum_16_squared * sum_4_squared_squared
        + 64.0 * sigma_beta_squared * sin_beta_squared * sum_4_squared_squared * sum_5_squared * sum_6_squared
        + 96.0 * product_39 * rho * sigma_path_per_path * sin_beta * sum_17 * sum_5 * sum_6 * sum_8
    )
    sum_21 = (
        2.0 * product_4 * product_6
        - 1.0
        - 12.0 * cos_beta * product_4
        - 24.0 * baseline_per_path * product_6
        - 4.0 * baseline_per_path_squared
        + 31.0 * baseline_per_path_squared * cos_beta_squared
        + 8.0 * cos_beta_squared
    )
    sum_22 = (
        10.0 * baseline_per_path_squared * product_6
        - 13.0 * baseline_per_path_squared_squared * product_6
        - 13.0 * cos_beta_squared * product_4
        - 4.0 * baseline_per_path_squared_cubed * cos_beta
        - 4.0 * product_5
        - 6.0 * baseline_per_path * cos_beta_squared
        - cos_beta_squared_squared * product_5
        + 10.0 * baseline_per_path_squared_squared * cos_beta
        + 13.0 * cos_beta_squared * product_5
        + 3.0 * baseline_per_path_squared * cos_beta
        + 3.0 * cos_beta_squared_squared * product_4
        + baseline_per_path_squared_cubed * product_6
        + cos_beta
    )
    product_40 = 18.0 * baseline_per_path_squared * cos_beta
    sum_23 = (
        7.0 * baseline_per_path
        - 10.0 * baseline_per_path * cos_beta_squared
        - 16.0 * product_4
        - 3.0 * cos_beta
        + 7.0 * cos_beta_squared * product_4
        + product_13
        + product_40
    )
    sum_24 = (
        6.0
        - 12.0 * cos_beta_squared
        - 16.0 * cos_beta * product_5
        - 20.0 * baseline_per_path_squared_squared * cos_beta_squared_squared
        - 3.0 * baseline_per_path * cos_beta
        - 48.0 * baseline_per_path_squared_squared
        - 80.0 * baseline_per_path_squared * cos_beta_squared
        - 95.0 * product_4 * product_6
        + 103.0 * cos_beta * product_4
        + 11.0 * product_5 * product_6
        + 2.0 * baseline_per_path_squared
        + 28.0 * baseline_per_path * product_6
        + 4.0 * product_4 * product_7
        + 44.0 * baseline_per_path_squared * cos_beta_squared_squared
        + 76.0 * baseline_per_path_squared_squared * cos_beta_squared
    )
    sum_25 = (
        26.0 * cos_beta_squared * product_4
        - 12.0 * baseline_per_path_squared_squared * cos_beta
        - 15.0 * baseline_per_path_squared * product_6
        - 6.0 * product_4
        + 9.0 * baseline_per_path_squared * cos_beta
        + cos_beta
        + product_14
        + product_16
    )
    sum_26 = (
        14.0 * cos_beta_squared_squared * product_4
        - 16.0 * baseline_per_path_squared_cubed * cos_beta
        - 16.0 * product_5
        - 18.0 * baseline_per_path * cos_beta_squared
        - 46.0 * cos_beta_squared * product_4
        - 50.0 * baseline_per_path_squared_squared * product_6
        - 6.0 * cos_beta_squared_squared * product_5
        + 3.0 * cos_beta
        + 33.0 * baseline_per_path_squared * product_6
        + 35.0 * baseline_per_path_squared_squared * cos_beta
        + 4.0 * product_4
        + 5.0 * baseline_per_path_squared_cubed * product_6
        + 52.0 * cos_beta_squared * product_5
        + 6.0 * baseline_per_path_squared * cos_beta
    )
    sum_27 = (
        5.0
        - 17.0 * baseline_per_path_squared * sin_beta_squared
        - 18.0 * baseline_per_path_squared * sin_beta_squared_squared
        - 25.0 * baseline_per_path * cos_beta
        - 29.0 * baseline_per_path_squared_squared
        - 51.0 * cos_beta * product_4 * sin_beta_squared
        - 6.0 * sin_beta_squared
        + 13.0 * cos_beta * product_5
        + 24.0 * baseline_per_path * cos_beta * sin_beta_squared
        + 32.0 * baseline_per_path_squared
        + 41.0 * baseline_per_path_squared_squared * sin_beta_squared
        + 5.0 * cos_beta * product_5 * sin_beta_squared
        + 6.0 * baseline_per_path_squared_squared * sin_beta_squared_squared
        + product_27
    )
    sum_28 = (
        4.0 * baseline_per_path
        - 6.0 * product_4
        - baseline_per_path_squared * product_6
        - cos_beta
        + 4.0 * baseline_per_path_squared * cos_beta
        + product_14
        + product_15
    )
    product_41 = -18.0 * baseline_per_path_squared_cubed * product_7
    product_42 = -24.0 * product_6 * term_2
    product_43 = 22.0 * baseline_per_path_squared * product_6
    product_44 = 36.0 * cos_beta * term_2
    product_45 = 72.0 * cos_beta_squared_squared * product_4
    sum_29 = (
        10.0 * product_4
        - 126.0 * cos_beta_squared_squared * product_5
        - 146.0 * cos_beta_squared * product_30
        - 188.0 * baseline_per_path_squared_cubed * cos_beta
        - 196.0 * baseline_per_path_squared_squared * product_6
        - 74.0 * product_5
        - 8.0 * baseline_per_path * cos_beta_squared
        - 94.0 * cos_beta_squared * product_4
        + 121.0 * baseline_per_path_squared_squared * cos_beta
        + 190.0 * baseline_per_path_squared_cubed * product_6
        + 2.0 * baseline_per_path_squared * cos_beta
        + 21.0 * baseline_per_path_squared_squared * product_7
        + 280.0 * cos_beta_squared * product_5
        + 46.0 * cos_beta_squared_squared * product_30
        + 72.0 * product_30
        + cos_beta
        + product_41
        + product_42
        + product_43
        + product_44
        + product_45
        + product_7 * term_2
    )
    sum_30 = (
        11.0 * product_4 * sin_beta_squared
        - 4.0 * baseline_per_path * sin_beta_squared
        - 6.0 * baseline_per_path_squared * cos_beta * sin_beta_squared
        - 8.0 * product_4
        - cos_beta
        + 4.0 * baseline_per_path
        + 5.0 * baseline_per_path_squared_squared * cos_beta
        + baseline_per_path_squared_squared * cos_beta * sin_beta_squared
    )
    sum_31 = (
        22.0
        - 112.0 * baseline_per_path_squared * sin_beta_squared
        - 125.0 * baseline_per_path * cos_beta
        - 154.0 * baseline_per_path_squared_squared
        - 24.0 * sin_beta_squared
        - 291.0 * cos_beta * product_4 * sin_beta_squared
        - 96.0 * baseline_per_path_squared * sin_beta_squared_squared
        + 14.0 * cos_beta * product_4
        + 144.0 * baseline_per_path * cos_beta * sin_beta_squared
        + 172.0 * baseline_per_path_squared
        + 226.0 * baseline_per_path_squared_squared * sin_beta_squared
        + 36.0 * baseline_per_path_squared_squared * sin_beta_squared_squared
        + 37.0 * cos_beta * product_5 * sin_beta_squared
        + 71.0 * cos_beta * product_5
    )
    product_46 = -14.0 * cos_beta * product_4
    sin_beta_squared_cubed = sin_beta_squared * sin_beta_squared**2
    sum_32 = (
        2.0 * baseline_per_path_squared_cubed * sin_beta_squared_cubed
        - 1.0
        - 3.0 * baseline_per_path_squared_cubed
        - 32.0 * cos_beta * product_5 * sin_beta_squared_squared
        - 38.0 * baseline_per_path_squared * sin_beta_squared
        - 6.0 * baseline_per_path_squared_squared * sin_beta_squared_cubed
        - 8.0 * cos_beta * product_5
        - 91.0 * baseline_per_path_squared_squared * sin_beta_squared_squared
        - 98.0 * cos_beta * product_5 * sin_beta_squared
        - baseline_per_path_squared
        + 2.0 * cos_beta * product_30
        + 2.0 * sin_beta_squared
        + 21.0 * baseline_per_path_squared_squared
        + 29.0 * baseline_per_path_squared_cubed * sin_beta_squared_squared
        + 32.0 * baseline_per_path_squared_cubed * sin_beta_squared
        + 32.0 * cos_beta * product_4 * sin_beta_squared_squared
        + 36.0 * baseline_per_path_squared * sin_beta_squared_squared
        + 36.0 * baseline_per_path_squared_squared * sin_beta_squared
        + 4.0 * cos_beta * product_30 * sin_beta_squared_squared
        + 52.0 * cos_beta * product_4 * sin_beta_squared
        + 6.0 * cos_beta * product_30 * sin_beta_squared
        + product_35
        + product_46
    )
    sum_33 = 5.0 * baseline_per_path * cos_beta - 5.0 + 6.0 * sin_beta_squared
    product_47 = sin_beta * sin_beta_squared**2
    sum_34 = baseline_per_path - cos_beta
    sum_35 = (
        104.0 * baseline_per_path_squared_squared * cos_beta
        - 129.0 * cos_beta_squared_squared * product_5
        - 139.0 * cos_beta_squared * product_30
        - 16.0 * baseline_per_path * cos_beta_squared
        - 212.0 * baseline_per_path_squared_squared * product_6
        - 214.0 * baseline_per_path_squared_cubed * cos_beta
        - 55.0 * product_5
        - 89.0 * cos_beta_squared * product_4
        - product_4
        + 16.0 * baseline_per_path_squared * cos_beta
        + 194.0 * baseline_per_path_squared_cubed * product_6
        + 2.0 * cos_beta
        + 2.0 * product_7 * term_2
        + 24.0 * baseline_per_path_squared_squared * product_7
        + 26.0 * baseline_per_path_squared * product_6
        + 308.0 * cos_beta_squared * product_5
        + 41.0 * cos_beta_squared_squared * product_30
        + 72.0 * product_30
        + product_41
        + product_42
        + product_44
        + product_45
    )
    sum_36 = 1.0 - 2.0 * cos_beta_squared + product_12
    sum_37 = (
        128.0 * baseline_per_path_squared * product_17 * product_8 * product_9 * sin_beta_squared * sum_27
        - 128.0 * baseline_per_path_squared * cos_beta * product_3 * sigma_path_per_path_squared_squared * sum_14 * sum_4_squared
        - 128.0 * baseline_per_path_squared * product_9 * rho * sigma_beta * sin_beta_squared * sum_21 * sum_4_squared
        - 128.0 * sigma_beta_squared * sigma_path_per_path_squared * sin_beta * sum_22 * sum_4_squared
        - 32.0 * product_8 * rho * sigma_path_per_path * sum_24 * sum_4_squared * sum_5 * sum_6
        - 32.0 * sigma_beta_squared_squared * sin_beta * sum_23 * sum_4_squared * sum_5_squared * sum_6_squared
        - 384.0 * baseline_per_path_squared * product_3 * rho_squared * sigma_beta_squared * sigma_path_per_path_squared_squared * sum_25
        - 64.0 * rho_squared * sigma_beta_squared * sigma_path_per_path_squared * sin_beta * sum_26 * sum_4_squared
        + 16.0 * sigma_beta_squared_cubed * sin_beta * sum_17 * sum_28 * sum_5_squared * sum_6_squared
        + 16.0 * sigma_beta_squared_squared * sigma_path_per_path_squared * sin_beta * sum_29
        + 192.0 * baseline_per_path_squared * product_3 * sigma_beta_squared * sigma_path_per_path_squared_squared * sum_30
        + 32.0 * baseline_per_path_squared * product_8 * product_9 * rho * sin_beta_squared * sum_31
        + 48.0 * product_39 * rho * sigma_path_per_path * sum_32 * sum_5 * sum_6
        + 576.0 * baseline_per_path_squared_squared * cos_beta * product_47 * sigma_path_per_path_squared_cubed
        + 576.0 * baseline_per_path_squared_squared * product_2 * rho * sigma_beta * sin_beta_squared_squared * sum_33
        + 64.0 * cos_beta * sigma_path_per_path_squared * sin_beta * sum_16_squared * sum_4_squared_squared
        + 64.0 * rho_squared * sigma_beta_squared_squared * sigma_path_per_path_squared * sin_beta * sum_35
        + 64.0 * sigma_beta_squared * sin_beta * sum_34 * sum_4_squared_squared * sum_5_squared * sum_6_squared
        + 64.0 * rho * sigma_beta * sigma_path_per_path * sum_16 * sum_36 * sum_4_squared_squared * sum_5 * sum_6
    )
    sum_38 = (
        4.0 * cos_beta
        - 12.0 * baseline_per_path * cos_beta_squared
        - 3.0 * baseline_per_path
        - 8.0 * product_4
        + cos_beta_squared * product_4
        + product_40
    )
    sum_39 = (
        12.0 * baseline_per_path_squared
        - 1.0
        - 14.0 * product_4 * product_6
        - 16.0 * baseline_per_path_squared_squared
        - 21.0 * baseline_per_path_squared * cos_beta_squared
        + 12.0 * baseline_per_path_squared_squared * cos_beta_squared
        + 24.0 * cos_beta * product_4
        + 3.0 * cos_beta_squared
        + product_36
        + product_37
        + product_38
    )
    sum_40 = (
        11.0 * cos_beta_squared * product_5
        - 14.0 * baseline_per_path_squared_squared * product_6
        - 28.0 * baseline_per_path_squared * cos_beta
        - 32.0 * product_5
        - 6.0 * cos_beta
        - 61.0 * cos_beta_squared * product_4
        + 11.0 * product_4
        + 14.0 * baseline_per_path * cos_beta_squared
        + 2.0 * cos_beta_squared_squared * product_4
        + 7.0 * baseline_per_path
        + 74.0 * baseline_per_path_squared_squared * cos_beta
        + product_43
    )
    sum_41 = (
        1.0
        - 3.0 * baseline_per_path_squared * cos_beta_squared
        - 4.0 * baseline_per_path * cos_beta
        - 6.0 * baseline_per_path_squared_squared
        + 3.0 * baseline_per_path_squared
        + baseline_per_path_squared_squared * cos_beta_squared
        + product_23
    )
    product_48 = -8.0 * baseline_per_path * cos_beta
    product_49 = sin_beta_squared_squared * term_2
    sum_42 = (
        1.0
        - 124.0 * baseline_per_path_squared_cubed * sin_beta_squared
        - 13.0 * baseline_per_path_squared * sin_beta_squared
        - 31.0 * cos_beta * product_30 * sin_beta_squared
        - 36.0 * cos_beta * product_4 * sin_beta_squared
        - 86.0 * baseline_per_path_squared_squared
        - 9.0 * baseline_per_path_squared_cubed * sin_beta_squared_squared
        - 95.0 * cos_beta * product_30
        + 12.0 * baseline_per_path_squared_squared * sin_beta_squared_squared
        + 13.0 * cos_beta * product_4
        + 19.0 * baseline_per_path_squared
        + 22.0 * sin_beta_squared * term_2
        + 31.0 * term_2
        + 58.0 * cos_beta * product_5
        + 67.0 * baseline_per_path_squared_cubed
        + 83.0 * baseline_per_path_squared_squared * sin_beta_squared
        + 83.0 * cos_beta * product_5 * sin_beta_squared
        + product_48
        + product_49
    )
    sum_43 = (
        1.0
        - 122.0 * baseline_per_path_squared_squared
        - 140.0 * cos_beta * product_30
        - 18.0 * baseline_per_path_squared_cubed * sin_beta_squared_squared
        - 214.0 * baseline_per_path_squared_cubed * sin_beta_squared
        - 22.0 * baseline_per_path_squared * sin_beta_squared
        - 72.0 * cos_beta * product_4 * sin_beta_squared
        - 76.0 * cos_beta * product_30 * sin_beta_squared
        + 112.0 * cos_beta * product_5
        + 146.0 * baseline_per_path_squared_squared * sin_beta_squared
        + 164.0 * cos_beta * product_5 * sin_beta_squared
        + 21.0 * baseline_per_path_squared_squared * sin_beta_squared_squared
        + 28.0 * baseline_per_path_squared
        + 49.0 * term_2
        + 58.0 * sin_beta_squared * term_2
        + 76.0 * baseline_per_path_squared_cubed
        + product_27
        + product_48
        + product_49
    )
    sum_44 = (
        16.0 * baseline_per_path_squared * cos_beta * sin_beta_squared
        - 25.0 * baseline_per_path
        - 6.0 * baseline_per_path_squared_squared * cos_beta * sin_beta_squared
        - 63.0 * product_4 * sin_beta_squared
        - 68.0 * baseline_per_path_squared_squared * cos_beta
        + 24.0 * baseline_per_path * sin_beta_squared
        + 24.0 * baseline_per_path_squared * cos_beta
        + 27.0 * product_5
        + 38.0 * product_4
        + 4.0 * cos_beta
        + 9.0 * product_5 * sin_beta_squared
    )
    product_50 = baseline_per_path_squared_squared * sin_beta_squared
    sum_45 = (
        3.0 * baseline_per_path_squared
        - 1.0
        - 6.0 * baseline_per_path_squared * sin_beta_squared
        + 8.0 * baseline_per_path_squared_squared
        + product_35
        + product_46
        + product_50
    )
    sum_46 = (
        12.0 * baseline_per_path_squared
        - 1.0
        - 15.0 * baseline_per_path_squared * sin_beta_squared
        - 32.0 * cos_beta * product_4
        + 17.0 * baseline_per_path_squared_squared
        + product_35
        + product_50
    )
    sum_47 = (
        12.0 * baseline_per_path * cos_beta
        - 2.0
        - 12.0 * baseline_per_path_squared * cos_beta_squared
        - 12.0 * baseline_per_path_squared_squared
        - 38.0 * baseline_per_path_squared_cubed * cos_beta_squared
        - 6.0 * baseline_per_path_squared
        - 60.0 * baseline_per_path_squared_squared * cos_beta_squared_squared
        - 60.0 * product_4 * product_6
        - 78.0 * cos_beta * product_5
        + 26.0 * cos_beta * product_4
        + 3.0 * cos_beta_squared
        + 32.0 * baseline_per_path_squared_cubed
        + 7.0 * baseline_per_path_squared_cubed * cos_beta_squared_squared
        + 78.0 * product_5 * product_6
        + 87.0 * baseline_per_path_squared_squared * cos_beta_squared
        + product_18
        + product_19
        + product_20
        + product_21
    )
    sum_48 = (
        10.0 * cos_beta * product_4
        - 1.0
        - 17.0 * baseline_per_path_squared_cubed * cos_beta_squared
        - 3.0 * baseline_per_path_squared_squared
        - 30.0 * baseline_per_path_squared_squared * cos_beta_squared_squared
        - 36.0 * product_4 * product_6
        - 4.0 * baseline_per_path_squared
        - 44.0 * cos_beta * product_5
        - baseline_per_path_squared * cos_beta_squared
        + 16.0 * baseline_per_path_squared_cubed
        + 2.0 * cos_beta_squared
        + 40.0 * product_5 * product_6
        + 48.0 * baseline_per_path_squared_squared * cos_beta_squared
        + product_10
        + product_22
        + product_24
        + product_25
        + product_26
        + product_28
    )
    sum_49 = (
        128.0 * rho_squared * sigma_beta_squared_squared * sigma_path_per_path_squared * sin_beta_squared * sum_42
        - 128.0 * baseline_per_path_squared * sigma_path_per_path_squared_squared * sin_beta_squared_squared * sum_14 * sum_4_squared
        - 256.0 * baseline_per_path_squared * product_3 * product_9 * rho * sigma_beta * sum_38 * sum_4_squared
        - 32.0 * sigma_beta_squared_squared * sum_39 * sum_4_squared * sum_5_squared * sum_6_squared
        - 64.0 * product_8 * rho * sigma_path_per_path * sin_beta * sum_40 * sum_4_squared * sum_5 * sum_6
        - 768.0 * baseline_per_path_squared * product_17 * product_3 * product_8 * product_9 * sum_34 * sum_41
        + 128.0 * rho * sigma_beta * sigma_path_per_path * sin_beta * sum_16 * sum_34 * sum_4_squared_squared * sum_5 * sum_6
        + 16.0 * sigma_beta_squared_cubed * sum_28**2 * sum_5_squared * sum_6_squared
        + 16.0 * sigma_beta_squared_squared * sigma_path_per_path_squared * sin_beta_squared * sum_43
        + 192.0 * baseline_per_path_squared * product_3 * product_8 * product_9 * rho * sum_44
        + 192.0 * baseline_per_path_squared * sigma_beta_squared * sigma_path_per_path_squared_squared * sin_beta_squared_squared * sum_45
        + 3456.0 * baseline_per_path_squared_squared * product_2 * product_47 * rho * sigma_beta * sum_34
        + 384.0 * baseline_per_path_squared * rho_squared * sigma_beta_squared * sigma_path_per_path_squared_squared * sin_beta_squared_squared * sum_46
        + 576.0 * baseline_per_path_squared_squared * sigma_path_per_path_squared_cubed * sin_beta_squared_cubed
        + 64.0 * rho_squared * sigma_beta_squared * sigma_path_per_path_squared * sum_47 * sum_4_squared
        + 64.0 * sigma_beta_squared * sigma_path_per_path_squared * sum_48 * sum_4_squared
        + 64.0 * sigma_beta_squared * sum_34**2 * sum_4_squared_squared * sum_5_squared * sum_6_squared
        + 64.0 * sigma_path_per_path_squared * sin_beta_squared * sum_16_squared * sum_4_squared_squared
        + 96.0 * product_39 * rho * sigma_path_per_path * sin_beta * sum_28 * sum_41 * sum_5 * sum_6
    )
    result = _empty(arguments, (2, 2))
    result[..., 0, 0] = path_squared * sum_20 * term_3
    result[..., 0, 1] = path_squared * sum_37 * term_3
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = path_squared * sum_49 * term_3
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

    Accuracy: measured, not proved: at most 8 ulp from 50-digit arithmetic at 500 points of this domain
    (float64, independent errors). Errors are measured against the sum of the variances to first order of
    independent errors.
    """
    arguments = _floats(path, beta, baseline, sigma_path, sigma_beta, rho, predicted_sigma_path, predicted_sigma_beta, predicted_rho)
    path, beta, baseline, sigma_path, sigma_beta, rho, predicted_sigma_path, predicted_sigma_beta, predicted_rho = arguments
    term_1 = 1.0 / path
    baseline_per_path = baseline * term_1
    sigma_path_per_path = sigma_path * term_1
    predicted_sigma_path_per_path = predicted_sigma_path * term_1
    cos_beta = np.cos(beta)
    product_1 = -2.0 * baseline_per_path * cos_beta
    divisor_1 = 2.0 + product_1
    baseline_per_path_squared = baseline_per_path**2
    baseline_per_path_squared_squared = baseline_per_path_squared**2
    product_2 = baseline_per_path * baseline_per_path_squared
    cos_beta_squared = cos_beta**2
    cos_beta_squared_squared = cos_beta_squared**2
    product_3 = baseline_per_path * baseline_per_path_squared**2
    product_4 = cos_beta * cos_beta_squared
    product_5 = cos_beta * cos_beta_squared**2
    product_6 = 6.0 * baseline_per_path_squared * product_5
    predicted_sigma_beta_squared = predicted_sigma_beta**2
    predicted_sigma_path_per_path_squared = predicted_sigma_path_per_path**2
    sin_beta = np.sin(beta)
    sum_1 = (
        12.0 * baseline_per_path * cos_beta_squared_squared
        - 14.0 * baseline_per_path_squared_squared * cos_beta
        - 15.0 * cos_beta_squared_squared * product_2
        - 2.0 * cos_beta_squared * product_3
        - 2.0 * product_2
        - 28.0 * baseline_per_path_squared * product_4
        - 3.0 * baseline_per_path_squared_squared * product_5
        - 7.0 * baseline_per_path * cos_beta_squared
        - cos_beta
        + 14.0 * baseline_per_path_squared * cos_beta
        + 18.0 * baseline_per_path_squared_squared * product_4
        + 21.0 * cos_beta_squared * product_2
        + cos_beta_squared_squared * product_3
        + product_6
    )
    product_7 = 2.0 * baseline_per_path * cos_beta
    sum_2 = 1.0 - 3.0 * cos_beta_squared + product_7
    product_8 = -2.0 * baseline_per_path_squared_squared * cos_beta
    product_9 = -3.0 * baseline_per_path_squared * product_4
    product_10 = -4.0 * baseline_per_path * cos_beta_squared
    product_11 = 4.0 * cos_beta_squared * product_2
    product_12 = 7.0 * baseline_per_path_squared * cos_beta
    product_13 = baseline_per_path_squared_squared * product_4
    sum_3 = (
        cos_beta
        - 4.0 * product_2
        + product_10
        + product_11
        + product_12
        + product_13
        + product_8
        + product_9
    )
    product_14 = predicted_sigma_path_per_path * predicted_sigma_path_per_path_squared
    sigma_beta_squared = sigma_beta**2
    product_15 = -12.0 * baseline_per_path * product_4
    product_16 = -20.0 * cos_beta * product_2
    sin_beta_squared = sin_beta**2
    sum_4 = (
        3.0 * baseline_per_path_squared_squared * cos_beta_squared_squared
        - 14.0 * baseline_per_path_squared_squared * cos_beta_squared
        - 2.0 * baseline_per_path_squared
        - 27.0 * baseline_per_path_squared * cos_beta_squared_squared
        + 3.0 * cos_beta_squared
        + 33.0 * baseline_per_path_squared * cos_beta_squared
        + 36.0 * product_2 * product_4
        + product_15
        + product_16
    )
    product_17 = predicted_sigma_beta * predicted_sigma_beta_squared
    sigma_path_per_path_squared = sigma_path_per_path**2
    product_18 = baseline_per_path * cos_beta
    sum_5 = product_18 - 1.0
    sum_5_squared = sum_5**2
    product_19 = -14.0 * cos_beta * product_3
    product_20 = -24.0 * baseline_per_path_squared_squared * cos_beta_squared_squared
    product_21 = -28.0 * product_2 * product_4
    baseline_per_path_squared_cubed = baseline_per_path_squared * baseline_per_path_squared**2
    product_22 = -3.0 * baseline_per_path_squared_cubed * cos_beta_squared
    product_23 = -4.0 * product_3 * product_5
    product_24 = 2.0 * baseline_per_path_squared_cubed * cos_beta_squared_squared
    product_25 = 22.0 * baseline_per_path_squared * cos_beta_squared_squared
    product_26 = 6.0 * baseline_per_path * cos_beta
    product_27 = 8.0 * cos_beta * product_2
    product_28 = 8.0 * product_2 * product_5
    sum_6 = (
        2.0 * cos_beta_squared
        - 1.0
        - 3.0 * baseline_per_path_squared_squared
        - 9.0 * baseline_per_path_squared * cos_beta_squared
        + 20.0 * product_3 * product_4
        + 30.0 * baseline_per_path_squared_squared * cos_beta_squared
        + product_15
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
    )
    product_29 = -3.0 * baseline_per_path * cos_beta_squared
    sum_7 = 1.0 + baseline_per_path
    sum_8 = baseline_per_path - 1.0
    sum_9 = (
        12.0 * cos_beta_squared * product_2
        - 2.0 * baseline_per_path
        - 4.0 * product_2
        - 6.0 * baseline_per_path_squared_squared * cos_beta
        - 8.0 * baseline_per_path_squared * product_4
        - cos_beta_squared_squared * product_2
        + 2.0 * baseline_per_path_squared_squared * product_4
        + 2.0 * cos_beta
        + 8.0 * baseline_per_path_squared * cos_beta
        + product_29
    )
    product_30 = -3.0 * baseline_per_path * cos_beta
    sum_10 = 1.0 + baseline_per_path_squared + cos_beta * product_2 + product_30
    sum_11 = baseline_per_path * cos_beta_squared - 2.0 * baseline_per_path + cos_beta
    product_31 = sigma_beta * sigma_beta_squared
    predicted_rho_squared = predicted_rho**2
    product_32 = -2.0 * cos_beta * product_2
    product_33 = -6.0 * baseline_per_path * product_4
    product_34 = 3.0 * baseline_per_path * cos_beta
    product_35 = 6.0 * baseline_per_path_squared * cos_beta_squared
    product_36 = product_2 * product_4
    sum_12 = (
        cos_beta_squared
        - 3.0 * baseline_per_path_squared
        + product_32
        + product_33
        + product_34
        + product_35
        + product_36
    )
    product_37 = -3.0 * cos_beta * product_2
    product_38 = -9.0 * baseline_per_path * product_4
    sum_13 = (
        4.0 * cos_beta_squared
        - 2.0
        - 2.0 * baseline_per_path_squared
        + 8.0 * baseline_per_path_squared * cos_beta_squared
        + product_34
        + product_36
        + product_37
        + product_38
    )
    sum_14 = (
        3.0 * cos_beta_squared * product_2
        - 3.0 * product_2
        - baseline_per_path
        + cos_beta
        + product_12
        + product_13
        + product_29
        + product_8
        + product_9
    )
    sum_15 = (
        2.0 * baseline_per_path * sin_beta_squared
        - 2.0 * baseline_per_path
        - 3.0 * cos_beta * sin_beta_squared
        + 2.0 * cos_beta
    )
    predicted_sigma_path_per_path_squared_squared = predicted_sigma_path_per_path_squared**2
    product_39 = sin_beta * sin_beta_squared
    sum_16 = 1.0 + sin_beta
    sum_17 = sin_beta - 1.0
    sin_beta_squared_squared = sin_beta_squared**2
    product_40 = 4.0 * baseline_per_path * cos_beta
    product_41 = baseline_per_path_squared * cos_beta_squared
    sum_18 = 1.0 - 6.0 * baseline_per_path_squared + product_40 + product_41
    product_42 = -16.0 * baseline_per_path_squared_squared * cos_beta_squared_squared
    product_43 = -2.0 * product_3 * product_5
    product_44 = 10.0 * product_3 * product_4
    product_45 = 14.0 * baseline_per_path_squared * cos_beta_squared_squared
    product_46 = 20.0 * baseline_per_path_squared_squared * cos_beta_squared
    product_47 = 6.0 * product_2 * product_5
    sum_19 = (
        2.0 * cos_beta_squared
        - 1.0
        - 18.0 * product_2 * product_4
        - 2.0 * baseline_per_path_squared
        - 6.0 * cos_beta * product_3
        - baseline_per_path_squared_squared
        + product_15
        + product_22
        + product_24
        + product_26
        + product_41
        + product_42
        + product_43
        + product_44
        + product_45
        + product_46
        + product_47
    )
    product_48 = 2.0 * baseline_per_path_squared * cos_beta_squared
    sum_20 = product_26 - 3.0 - 5.0 * baseline_per_path_squared + product_48
    sum_21 = baseline_per_path_squared * sin_beta_squared - 1.0 - baseline_per_path_squared + product_7
    sigma_path_per_path_squared_squared = sigma_path_per_path_squared**2
    sum_5_squared_squared = sum_5_squared**2
    sum_22 = 1.0 + baseline_per_path_squared + product_1
    sum_7_squared = sum_7**2
    sum_8_squared = sum_8**2
    predicted_sigma_beta_squared_squared = predicted_sigma_beta_squared**2
    sum_3_squared = sum_3**2
    product_49 = sigma_path_per_path * sigma_path_per_path_squared
    sum_2_squared = sum_2**2
    sigma_beta_squared_squared = sigma_beta_squared**2
    product_50 = -11.0 * baseline_per_path_squared * cos_beta_squared
    product_51 = -8.0 * baseline_per_path * cos_beta
    product_52 = 2.0 * baseline_per_path_squared * cos_beta_squared_squared
    product_53 = 6.0 * baseline_per_path * product_4
    sum_23 = (
        10.0 * baseline_per_path_squared
        - 1.0
        + 2.0 * cos_beta_squared
        + product_50
        + product_51
        + product_52
        + product_53
    )
    product_54 = -6.0 * baseline_per_path * cos_beta
    product_55 = -8.0 * cos_beta * product_2
    product_56 = 15.0 * baseline_per_path_squared * cos_beta_squared
    product_57 = 6.0 * cos_beta * product_3
    product_58 = baseline_per_path_squared_cubed * cos_beta_squared
    sum_24 = (
        1.0
        - 12.0 * baseline_per_path_squared_squared * cos_beta_squared
        + 3.0 * baseline_per_path_squared_squared
        + product_54
        + product_55
        + product_56
        + product_57
        + product_58
    )
    cos_beta_squared_cubed = cos_beta_squared * cos_beta_squared**2
    term_2 = (baseline_per_path_squared**2)**2
    product_59 = baseline_per_path * baseline_per_path_squared * baseline_per_path_squared**2
    product_60 = 4.0 * cos_beta * product_2
    sum_25 = (
        102.0 * baseline_per_path_squared_cubed * cos_beta_squared_squared
        - 12.0 * baseline_per_path_squared_cubed * cos_beta_squared_cubed
        - 126.0 * baseline_per_path_squared_cubed * cos_beta_squared
        - 138.0 * baseline_per_path_squared_squared * cos_beta_squared_squared
        - 14.0 * baseline_per_path_squared_squared
        - 4.0 * cos_beta_squared_squared * term_2
        - 52.0 * product_4 * product_59
        - 60.0 * product_3 * product_5
        - 8.0 * baseline_per_path * product_4
        - 84.0 * product_2 * product_4
        - 92.0 * cos_beta * product_3
        + 12.0 * product_5 * product_59
        + 15.0 * baseline_per_path_squared_squared * cos_beta_squared_cubed
        + 151.0 * baseline_per_path_squared_squared * cos_beta_squared
        + 16.0 * baseline_per_path_squared * cos_beta_squared_squared
        + 160.0 * product_3 * product_4
        + 2.0 * baseline_per_path_squared
        + 28.0 * baseline_per_path_squared_cubed
        + 4.0 * cos_beta_squared * term_2
        + 40.0 * cos_beta * product_59
        + 48.0 * product_2 * product_5
        + cos_beta_squared
        + cos_beta_squared_cubed * term_2
        + product_35
        + product_60
    )
    sum_22_squared = sum_22**2
    product_61 = 2.0 * product_2 * product_4
    rho_squared = rho**2
    sum_26 = (
        1.0
        - 2.0 * product_3 * product_4
        - 8.0 * baseline_per_path_squared_squared * cos_beta_squared
        + 11.0 * baseline_per_path_squared * cos_beta_squared
        + 2.0 * baseline_per_path_squared
        + baseline_per_path_squared_squared
        + product_54
        + product_55
        + product_57
        + product_58
        + product_61
    )
    term_3 = 1.0 / ((divisor_1**2)**2)**2
    path_squared = path**2
    sum_27 = (
        128.0 * baseline_per_path_squared * (1.0 + cos_beta) * (cos_beta - 1.0) * cos_beta_squared * predicted_sigma_path_per_path_squared * sigma_path_per_path_squared * sum_20 * sum_5_squared
        - 128.0 * baseline_per_path_squared * predicted_sigma_beta_squared * predicted_sigma_path_per_path_squared * rho * sigma_beta * sigma_path_per_path * sin_beta * sum_1
        - 128.0 * baseline_per_path_squared * predicted_rho * predicted_sigma_path_per_path * product_17 * sigma_path_per_path_squared * sin_beta * sum_2 * sum_3
        - 128.0 * baseline_per_path_squared * predicted_rho * predicted_sigma_beta * product_14 * sigma_beta_squared * sin_beta * sum_2 * sum_3
        - 128.0 * baseline_per_path_squared * predicted_rho * predicted_sigma_beta * product_14 * rho * sigma_beta * sigma_path_per_path * sin_beta_squared * sum_4
        - 128.0 * predicted_sigma_beta_squared * rho * sigma_beta * sigma_path_per_path * sin_beta * sum_5_squared * sum_7 * sum_8 * sum_9
        - 128.0 * predicted_rho * predicted_sigma_beta * predicted_sigma_path_per_path * rho * sigma_beta * sigma_path_per_path * sum_5_squared * sum_6
        - 128.0 * product_31 * rho * sigma_path_per_path * sin_beta * sum_10 * sum_11 * sum_5_squared * sum_7 * sum_8
        - 192.0 * baseline_per_path_squared * cos_beta * predicted_sigma_beta_squared * predicted_sigma_path_per_path_squared * sigma_path_per_path_squared * sin_beta_squared * sum_3
        - 256.0 * baseline_per_path_squared * cos_beta * predicted_rho * predicted_sigma_beta * predicted_sigma_path_per_path * sigma_path_per_path_squared * sin_beta * sum_13 * sum_5_squared
        - 256.0 * baseline_per_path_squared * cos_beta * predicted_sigma_path_per_path_squared * rho * sigma_beta * sigma_path_per_path * sin_beta * sum_12 * sum_5_squared
        - 256.0 * baseline_per_path_squared * predicted_rho_squared * predicted_sigma_beta_squared * predicted_sigma_path_per_path_squared * rho * sigma_beta * sigma_path_per_path * sin_beta * sum_2 * sum_3
        - 256.0 * predicted_rho * predicted_sigma_beta * predicted_sigma_path_per_path * sigma_beta_squared * sin_beta * sum_14 * sum_5_squared * sum_7 * sum_8
        - 384.0 * baseline_per_path_squared_squared * predicted_sigma_path_per_path_squared_squared * product_39 * rho * sigma_beta * sigma_path_per_path * sum_15
        - 576.0 * baseline_per_path_squared_squared * predicted_sigma_path_per_path_squared_squared * sigma_path_per_path_squared * sin_beta_squared_squared * sum_16 * sum_17
        - 64.0 * baseline_per_path_squared * predicted_sigma_beta_squared * predicted_sigma_path_per_path_squared * sigma_beta_squared * sin_beta_squared * sum_18 * sum_2 * sum_7 * sum_8
        - 64.0 * predicted_sigma_beta_squared * sigma_path_per_path_squared * sum_19 * sum_5_squared
        - 768.0 * baseline_per_path_squared_squared * predicted_rho * predicted_sigma_beta * product_14 * product_39 * sigma_path_per_path_squared * sum_15
        + 128.0 * baseline_per_path_squared_squared * sigma_path_per_path_squared_squared * sin_beta_squared_squared * sum_16 * sum_17 * sum_21
        + 128.0 * cos_beta * rho * sigma_beta * sigma_path_per_path * sin_beta * sum_22 * sum_5_squared_squared * sum_7 * sum_8
        + 16.0 * predicted_sigma_beta_squared_squared * sigma_beta_squared * sin_beta_squared * sum_18**2 * sum_7_squared * sum_8_squared
        + 16.0 * predicted_sigma_beta_squared_squared * sigma_path_per_path_squared * sum_3_squared
        + 256.0 * baseline_per_path_squared * cos_beta * product_39 * product_49 * rho * sigma_beta * sum_10 * sum_5_squared
        + 256.0 * baseline_per_path_squared_squared * predicted_rho_squared * predicted_sigma_beta_squared * predicted_sigma_path_per_path_squared * sigma_path_per_path_squared * sin_beta_squared * sum_2_squared
        + 32.0 * predicted_sigma_beta_squared_squared * rho * sigma_beta * sigma_path_per_path * sin_beta * sum_18 * sum_3 * sum_7 * sum_8
        + 32.0 * sigma_beta_squared_squared * sum_11**2 * sum_5_squared * sum_7_squared * sum_8_squared
        + 64.0 * baseline_per_path_squared_squared * predicted_sigma_path_per_path_squared_squared * sigma_beta_squared * sin_beta_squared * sum_2_squared
        + 64.0 * cos_beta_squared * sigma_path_per_path_squared * sum_22_squared * sum_5_squared_squared
        + 64.0 * predicted_rho_squared * predicted_sigma_beta_squared * predicted_sigma_path_per_path_squared * sigma_beta_squared * sum_3_squared
        + 64.0 * predicted_sigma_beta_squared * sigma_beta_squared * sum_23 * sum_5_squared * sum_7_squared * sum_8_squared
        + 64.0 * predicted_rho * predicted_sigma_path_per_path * product_17 * sigma_beta_squared * sin_beta * sum_18 * sum_3 * sum_7 * sum_8
        + 64.0 * predicted_rho * predicted_sigma_path_per_path * product_17 * rho * sigma_beta * sigma_path_per_path * sum_25
        + 64.0 * predicted_sigma_path_per_path_squared * sigma_beta_squared * sin_beta_squared * sum_24 * sum_5_squared
        + 64.0 * rho_squared * sigma_beta_squared * sigma_path_per_path_squared * sin_beta_squared * sum_26 * sum_5_squared
        + 64.0 * sigma_beta_squared * sigma_path_per_path_squared * sin_beta_squared * sum_10**2 * sum_5_squared
        + 64.0 * sigma_beta_squared * sin_beta_squared * sum_5_squared_squared * sum_7_squared * sum_8_squared
    )
    sum_28 = (
        2.0 * cos_beta_squared
        - 3.0 * baseline_per_path_squared
        - 7.0 * cos_beta * product_2
        + product_15
        + product_34
        + product_56
        + product_61
    )
    sum_29 = (
        2.0 * cos_beta_squared
        - 1.0
        - baseline_per_path_squared
        + 4.0 * baseline_per_path_squared * cos_beta_squared
        + product_33
        + product_34
        + product_37
        + product_61
    )
    product_62 = -10.0 * baseline_per_path_squared_squared * product_4
    product_63 = -6.0 * baseline_per_path * cos_beta_squared
    product_64 = 5.0 * baseline_per_path_squared * cos_beta
    product_65 = 9.0 * cos_beta_squared * product_3
    product_66 = baseline_per_path_squared_cubed * product_4
    sum_30 = (
        3.0 * cos_beta_squared_squared * product_2
        - 2.0 * product_2
        - 2.0 * product_3
        - 3.0 * baseline_per_path_squared_cubed * cos_beta
        - 9.0 * cos_beta_squared * product_2
        - cos_beta_squared_squared * product_3
        + 7.0 * baseline_per_path_squared * product_4
        + 7.0 * baseline_per_path_squared_squared * cos_beta
        + cos_beta
        + product_62
        + product_63
        + product_64
        + product_65
        + product_66
    )
    sum_31 = (
        6.0 * cos_beta_squared * product_2
        - 2.0 * product_2
        - 4.0 * baseline_per_path_squared_squared * cos_beta
        + cos_beta
        + product_10
        + product_13
        + product_64
        + product_9
    )
    sum_32 = (
        10.0 * baseline_per_path_squared * cos_beta_squared
        - 1.0
        - 4.0 * cos_beta * product_2
        - baseline_per_path_squared
        + 4.0 * cos_beta_squared
        + product_36
        + product_38
    )
    product_67 = -2.0 * cos_beta_squared_squared * product_3
    product_68 = 11.0 * baseline_per_path_squared * product_4
    product_69 = 2.0 * baseline_per_path_squared * cos_beta
    sum_33 = (
        12.0 * baseline_per_path_squared_squared * cos_beta
        - 15.0 * baseline_per_path_squared_squared * product_4
        - 15.0 * cos_beta_squared * product_2
        - 5.0 * baseline_per_path_squared_cubed * cos_beta
        - 5.0 * product_3
        + 15.0 * cos_beta_squared * product_3
        + 2.0 * baseline_per_path_squared_cubed * product_4
        + 4.0 * cos_beta_squared_squared * product_2
        + cos_beta
        + product_2
        + product_63
        + product_67
        + product_68
        + product_69
    )
    sum_34 = (
        24.0 * baseline_per_path * cos_beta_squared_squared
        - 12.0 * baseline_per_path_squared_squared * cos_beta
        - 17.0 * cos_beta_squared_squared * product_2
        - 24.0 * product_2
        - 33.0 * baseline_per_path * cos_beta_squared
        - 4.0 * cos_beta
        - 54.0 * baseline_per_path_squared * product_4
        + 42.0 * baseline_per_path_squared * cos_beta
        + 51.0 * cos_beta_squared * product_2
        + 6.0 * product_4
        + 7.0 * baseline_per_path
        + 8.0 * baseline_per_path_squared_squared * product_4
        + product_6
    )
    sum_35 = (
        22.0 * baseline_per_path_squared * cos_beta
        - 12.0 * baseline_per_path * cos_beta_squared
        - 20.0 * product_2
        - 4.0 * baseline_per_path_squared * product_4
        - 4.0 * cos_beta
        + 9.0 * baseline_per_path
        + 9.0 * cos_beta_squared * product_2
    )
    sum_36 = 2.0 * baseline_per_path_squared - 1.0 - baseline_per_path * cos_beta
    product_70 = 12.0 * baseline_per_path * product_4
    sum_37 = (
        4.0
        - 12.0 * cos_beta * product_3
        - 28.0 * baseline_per_path_squared_squared
        - 4.0 * baseline_per_path_squared
        - 46.0 * baseline_per_path_squared * cos_beta_squared
        - 65.0 * product_2 * product_4
        - 8.0 * cos_beta_squared
        + 32.0 * baseline_per_path_squared * cos_beta_squared_squared
        + 4.0 * product_2 * product_5
        + 50.0 * baseline_per_path_squared_squared * cos_beta_squared
        + 65.0 * cos_beta * product_2
        + 9.0 * product_3 * product_4
        + product_34
        + product_42
        + product_70
    )
    sum_38 = (
        16.0 * cos_beta_squared * product_2
        - 4.0 * product_2
        - 8.0 * baseline_per_path_squared_squared * cos_beta
        - 9.0 * baseline_per_path_squared * product_4
        + cos_beta
        + product_10
        + product_12
        + product_13
    )
    product_71 = -12.0 * baseline_per_path_squared_squared * product_4
    product_72 = -4.0 * baseline_per_path_squared_cubed * cos_beta
    sum_39 = (
        12.0 * cos_beta_squared * product_3
        - 18.0 * cos_beta_squared * product_2
        - 6.0 * product_3
        + 15.0 * baseline_per_path_squared * product_4
        + 15.0 * baseline_per_path_squared_squared * cos_beta
        + 2.0 * product_2
        + cos_beta
        + product_63
        + product_66
        + product_71
        + product_72
    )
    sum_40 = (
        2.0
        - 16.0 * baseline_per_path_squared_squared
        - 27.0 * product_2 * product_4
        - 28.0 * baseline_per_path_squared * cos_beta_squared
        - 4.0 * baseline_per_path_squared_squared * cos_beta_squared_squared
        - 4.0 * cos_beta * product_3
        - 4.0 * cos_beta_squared
        + 12.0 * baseline_per_path_squared * cos_beta_squared_squared
        + 2.0 * baseline_per_path_squared
        + 3.0 * product_3 * product_4
        + 35.0 * cos_beta * product_2
        + product_30
        + product_46
        + product_70
    )
    product_73 = 2.0 * cos_beta_squared_squared * product_2
    sum_41 = (
        13.0 * baseline_per_path_squared_squared * cos_beta
        - 14.0 * cos_beta_squared * product_2
        - 4.0 * product_3
        + 3.0 * baseline_per_path_squared_cubed * product_4
        + 8.0 * cos_beta_squared * product_3
        + cos_beta
        + product_62
        + product_63
        + product_67
        + product_68
        + product_69
        + product_72
        + product_73
    )
    product_74 = cos_beta_squared * product_2
    sum_42 = 3.0 * baseline_per_path_squared * cos_beta - 2.0 * product_2 + cos_beta + product_29 + product_74
    sum_43 = (
        1.0
        - 12.0 * product_2 * product_4
        - 2.0 * baseline_per_path_squared_squared * cos_beta_squared_squared
        - 2.0 * cos_beta * product_3
        - 2.0 * cos_beta_squared
        - 6.0 * baseline_per_path_squared_squared
        - baseline_per_path_squared
        + 16.0 * cos_beta * product_2
        + 2.0 * product_3 * product_4
        + 4.0 * baseline_per_path * product_4
        + 6.0 * baseline_per_path_squared * cos_beta_squared_squared
        + 7.0 * baseline_per_path_squared_squared * cos_beta_squared
        + product_50
    )
    product_75 = -25.0 * baseline_per_path * cos_beta
    sum_44 = (
        5.0
        - 17.0 * baseline_per_path_squared * sin_beta_squared
        - 18.0 * baseline_per_path_squared * sin_beta_squared_squared
        - 29.0 * baseline_per_path_squared_squared
        - 51.0 * cos_beta * product_2 * sin_beta_squared
        - 6.0 * sin_beta_squared
        + 13.0 * cos_beta * product_3
        + 24.0 * baseline_per_path * cos_beta * sin_beta_squared
        + 32.0 * baseline_per_path_squared
        + 41.0 * baseline_per_path_squared_squared * sin_beta_squared
        + 5.0 * cos_beta * product_3 * sin_beta_squared
        + 6.0 * baseline_per_path_squared_squared * sin_beta_squared_squared
        + product_60
        + product_75
    )
    product_76 = sin_beta * sin_beta_squared**2
    sum_45 = (
        4.0 * baseline_per_path
        - 6.0 * product_2
        - baseline_per_path_squared * product_4
        - cos_beta
        + 4.0 * baseline_per_path_squared * cos_beta
        + product_10
        + product_11
    )
    sum_46 = (
        1.0
        - 3.0 * baseline_per_path_squared * cos_beta_squared
        - 4.0 * baseline_per_path * cos_beta
        - 6.0 * baseline_per_path_squared_squared
        + 3.0 * baseline_per_path_squared
        + baseline_per_path_squared_squared * cos_beta_squared
        + product_27
    )
    sin_beta_squared_cubed = sin_beta_squared * sin_beta_squared**2
    sum_47 = (
        2.0 * baseline_per_path_squared_cubed * sin_beta_squared_cubed
        - 1.0
        - 14.0 * cos_beta * product_2
        - 3.0 * baseline_per_path_squared_cubed
        - 32.0 * cos_beta * product_3 * sin_beta_squared_squared
        - 38.0 * baseline_per_path_squared * sin_beta_squared
        - 6.0 * baseline_per_path_squared_squared * sin_beta_squared_cubed
        - 8.0 * cos_beta * product_3
        - 91.0 * baseline_per_path_squared_squared * sin_beta_squared_squared
        - 98.0 * cos_beta * product_3 * sin_beta_squared
        - baseline_per_path_squared
        + 2.0 * cos_beta * product_59
        + 2.0 * sin_beta_squared
        + 21.0 * baseline_per_path_squared_squared
        + 29.0 * baseline_per_path_squared_cubed * sin_beta_squared_squared
        + 32.0 * baseline_per_path_squared_cubed * sin_beta_squared
        + 32.0 * cos_beta * product_2 * sin_beta_squared_squared
        + 36.0 * baseline_per_path_squared * sin_beta_squared_squared
        + 36.0 * baseline_per_path_squared_squared * sin_beta_squared
        + 4.0 * cos_beta * product_59 * sin_beta_squared_squared
        + 52.0 * cos_beta * product_2 * sin_beta_squared
        + 6.0 * cos_beta * product_59 * sin_beta_squared
        + product_40
    )
    sum_48 = baseline_per_path - cos_beta
    sum_49 = 5.0 * baseline_per_path * cos_beta - 5.0 + 6.0 * sin_beta_squared
    sum_50 = (
        2.0
        - 24.0 * baseline_per_path_squared * sin_beta_squared_squared
        - 38.0 * baseline_per_path_squared_squared
        - 44.0 * baseline_per_path_squared * sin_beta_squared
        - 87.0 * cos_beta * product_2 * sin_beta_squared
        + 12.0 * baseline_per_path_squared_squared * sin_beta_squared_squared
        + 17.0 * cos_beta * product_3 * sin_beta_squared
        + 19.0 * cos_beta * product_3
        + 44.0 * baseline_per_path_squared
        + 48.0 * baseline_per_path * cos_beta * sin_beta_squared
        + 62.0 * baseline_per_path_squared_squared * sin_beta_squared
        + product_32
        + product_75
    )
    product_77 = 16.0 * baseline_per_path_squared * product_4
    sum_51 = (
        128.0 * baseline_per_path_squared_cubed * product_4
        - 12.0 * baseline_per_path_squared_cubed * product_5
        - 134.0 * baseline_per_path_squared_cubed * cos_beta
        - 136.0 * baseline_per_path_squared_squared * product_4
        - 16.0 * product_4 * term_2
        - 43.0 * product_3
        - 61.0 * cos_beta_squared * product_2
        - 8.0 * baseline_per_path * cos_beta_squared
        - 85.0 * cos_beta_squared_squared * product_3
        - 95.0 * cos_beta_squared * product_59
        + 15.0 * baseline_per_path_squared_squared * product_5
        + 196.0 * cos_beta_squared * product_3
        + 24.0 * cos_beta * term_2
        + 29.0 * cos_beta_squared_squared * product_59
        + 3.0 * product_2
        + 48.0 * cos_beta_squared_squared * product_2
        + 48.0 * product_59
        + 6.0 * baseline_per_path_squared * cos_beta
        + 75.0 * baseline_per_path_squared_squared * cos_beta
        + cos_beta
        + product_5 * term_2
        + product_77
    )
    sum_52 = 1.0 - 2.0 * cos_beta_squared + product_18
    sum_53 = (
        128.0 * baseline_per_path_squared * predicted_rho_squared * predicted_sigma_beta_squared * predicted_sigma_path_per_path_squared * rho * sigma_beta * sigma_path_per_path * sin_beta_squared * sum_44
        - 128.0 * baseline_per_path_squared * cos_beta * predicted_sigma_path_per_path_squared * product_39 * sigma_path_per_path_squared * sum_20 * sum_5_squared
        - 128.0 * baseline_per_path_squared * predicted_sigma_path_per_path_squared * rho * sigma_beta * sigma_path_per_path * sin_beta_squared * sum_28 * sum_5_squared
        - 128.0 * baseline_per_path_squared * product_49 * rho * sigma_beta * sin_beta_squared * sum_29 * sum_5_squared
        - 128.0 * predicted_sigma_beta_squared * sigma_path_per_path_squared * sin_beta * sum_30 * sum_5_squared
        - 192.0 * baseline_per_path_squared * predicted_sigma_beta_squared * predicted_sigma_path_per_path_squared * product_39 * sigma_path_per_path_squared * sum_31
        - 256.0 * baseline_per_path_squared * predicted_rho * predicted_sigma_beta * predicted_sigma_path_per_path * sigma_path_per_path_squared * sin_beta_squared * sum_32 * sum_5_squared
        - 256.0 * predicted_rho * predicted_sigma_beta * predicted_sigma_path_per_path * rho * sigma_beta * sigma_path_per_path * sin_beta * sum_33 * sum_5_squared
        - 32.0 * baseline_per_path_squared * predicted_sigma_beta_squared * predicted_sigma_path_per_path_squared * sigma_beta_squared * sin_beta * sum_34 * sum_7 * sum_8
        - 32.0 * predicted_sigma_beta_squared * sigma_beta_squared * sin_beta * sum_35 * sum_5_squared * sum_7_squared * sum_8_squared
        - 32.0 * predicted_sigma_beta_squared * rho * sigma_beta * sigma_path_per_path * sum_37 * sum_5_squared * sum_7 * sum_8
        - 32.0 * sigma_beta_squared_squared * sin_beta * sum_11 * sum_36 * sum_5_squared * sum_7_squared * sum_8_squared
        - 384.0 * baseline_per_path_squared * predicted_rho * predicted_sigma_beta * product_14 * product_39 * rho * sigma_beta * sigma_path_per_path * sum_38
        - 64.0 * predicted_rho * predicted_sigma_beta * predicted_sigma_path_per_path * sigma_beta_squared * sum_40 * sum_5_squared * sum_7 * sum_8
        - 64.0 * predicted_sigma_path_per_path_squared * sigma_beta_squared * sin_beta * sum_39 * sum_5_squared
        - 64.0 * product_31 * rho * sigma_path_per_path * sum_43 * sum_5_squared * sum_7 * sum_8
        - 64.0 * rho_squared * sigma_beta_squared * sigma_path_per_path_squared * sin_beta * sum_41 * sum_5_squared
        - 64.0 * sigma_beta_squared * sigma_path_per_path_squared * sin_beta * sum_10 * sum_42 * sum_5_squared
        + 128.0 * baseline_per_path_squared_squared * cos_beta * product_76 * sigma_path_per_path_squared_squared * sum_5_squared
        + 16.0 * predicted_sigma_beta_squared_squared * sigma_beta_squared * sin_beta * sum_18 * sum_45 * sum_7_squared * sum_8_squared
        + 16.0 * predicted_sigma_beta_squared_squared * rho * sigma_beta * sigma_path_per_path * sum_47 * sum_7 * sum_8
        + 16.0 * predicted_sigma_beta_squared_squared * sigma_path_per_path_squared * sin_beta * sum_3 * sum_46
        + 192.0 * baseline_per_path_squared_squared * predicted_sigma_path_per_path_squared_squared * product_39 * sigma_beta_squared * sum_2 * sum_48
        + 192.0 * baseline_per_path_squared_squared * predicted_sigma_path_per_path_squared_squared * rho * sigma_beta * sigma_path_per_path * sin_beta_squared_squared * sum_49
        + 32.0 * baseline_per_path_squared * predicted_sigma_beta_squared * predicted_sigma_path_per_path_squared * rho * sigma_beta * sigma_path_per_path * sin_beta_squared * sum_50
        + 32.0 * predicted_rho * predicted_sigma_path_per_path * product_17 * sigma_beta_squared * sum_47 * sum_7 * sum_8
        + 384.0 * baseline_per_path_squared_squared * predicted_rho * predicted_sigma_beta * product_14 * sigma_path_per_path_squared * sin_beta_squared_squared * sum_49
        + 576.0 * baseline_per_path_squared_squared * cos_beta * predicted_sigma_path_per_path_squared_squared * product_76 * sigma_path_per_path_squared
        + 64.0 * baseline_per_path_squared * predicted_rho * predicted_sigma_path_per_path * product_17 * sigma_path_per_path_squared * sin_beta_squared * sum_44
        + 64.0 * baseline_per_path_squared * predicted_rho * predicted_sigma_beta * product_14 * sigma_beta_squared * sin_beta_squared * sum_44
        + 64.0 * cos_beta * sigma_path_per_path_squared * sin_beta * sum_22_squared * sum_5_squared_squared
        + 64.0 * predicted_rho_squared * predicted_sigma_beta_squared * predicted_sigma_path_per_path_squared * sigma_beta_squared * sin_beta * sum_3 * sum_46
        + 64.0 * predicted_rho * predicted_sigma_path_per_path * product_17 * rho * sigma_beta * sigma_path_per_path * sin_beta * sum_51
        + 64.0 * sigma_beta_squared * sin_beta * sum_48 * sum_5_squared_squared * sum_7_squared * sum_8_squared
        + 64.0 * rho * sigma_beta * sigma_path_per_path * sum_22 * sum_52 * sum_5_squared_squared * sum_7 * sum_8
        + 768.0 * baseline_per_path_squared_squared * predicted_rho_squared * predicted_sigma_beta_squared * predicted_sigma_path_per_path_squared * product_39 * sigma_path_per_path_squared * sum_2 * sum_48
    )
    product_78 = 6.0 * baseline_per_path * cos_beta_squared
    sum_54 = (
        22.0 * baseline_per_path_squared_squared * cos_beta
        - 10.0 * product_3
        - 2.0 * baseline_per_path_squared_squared * product_4
        - 2.0 * cos_beta
        - 21.0 * cos_beta_squared * product_2
        - 8.0 * baseline_per_path_squared * cos_beta
        + 3.0 * cos_beta_squared * product_3
        + 5.0 * product_2
        + 6.0 * baseline_per_path_squared * product_4
        + baseline_per_path
        + product_78
    )
    sum_55 = 9.0 * baseline_per_path_squared * cos_beta - 5.0 * product_2 + cos_beta + product_63 + product_74
    sum_56 = (
        12.0 * baseline_per_path_squared * cos_beta
        - 3.0 * baseline_per_path
        - 5.0 * product_2
        - 9.0 * baseline_per_path * cos_beta_squared
        + 4.0 * cos_beta
        + product_74
    )
    sum_57 = (
        14.0 * cos_beta * product_2
        - 1.0
        - 10.0 * baseline_per_path_squared_squared
        - 13.0 * baseline_per_path_squared * cos_beta_squared
        - 7.0 * baseline_per_path * cos_beta
        - 9.0 * product_2 * product_4
        + 2.0 * cos_beta_squared
        + 8.0 * baseline_per_path_squared
        + 8.0 * baseline_per_path_squared_squared * cos_beta_squared
        + product_52
        + product_53
    )
    sum_58 = (
        46.0 * baseline_per_path_squared_squared * cos_beta
        - 14.0 * baseline_per_path_squared * cos_beta
        - 20.0 * product_3
        - 39.0 * cos_beta_squared * product_2
        - 4.0 * cos_beta
        + 5.0 * baseline_per_path
        + 5.0 * product_2
        + product_65
        + product_71
        + product_73
        + product_77
        + product_78
    )
    sum_59 = (
        12.0 * cos_beta * product_2
        - 1.0
        - 2.0 * baseline_per_path_squared
        - 25.0 * baseline_per_path_squared_cubed * cos_beta_squared
        - 36.0 * baseline_per_path_squared_squared * cos_beta_squared_squared
        - 40.0 * product_2 * product_4
        - 46.0 * cos_beta * product_3
        - 5.0 * baseline_per_path_squared * cos_beta_squared
        - 9.0 * baseline_per_path_squared_squared
        + 2.0 * cos_beta_squared
        + 20.0 * baseline_per_path_squared_cubed
        + 44.0 * product_3 * product_4
        + 6.0 * baseline_per_path_squared_cubed * cos_beta_squared_squared
        + 60.0 * baseline_per_path_squared_squared * cos_beta_squared
        + product_15
        + product_23
        + product_25
        + product_26
        + product_28
    )
    sum_46_squared = sum_46**2
    product_79 = baseline_per_path_squared_squared * sin_beta_squared
    sum_60 = (
        5.0 * baseline_per_path_squared_squared
        - 1.0
        - 3.0 * baseline_per_path_squared * sin_beta_squared
        + product_40
        + product_55
        + product_79
    )
    sum_61 = (
        4.0 * baseline_per_path * cos_beta * sin_beta_squared
        - 5.0
        - 16.0 * cos_beta * product_2
        - 19.0 * baseline_per_path_squared * sin_beta_squared
        - 2.0 * cos_beta * product_2 * sin_beta_squared
        + 5.0 * baseline_per_path_squared_squared * sin_beta_squared
        + 6.0 * baseline_per_path_squared
        + 7.0 * baseline_per_path_squared_squared
        + 8.0 * baseline_per_path * cos_beta
        + 8.0 * sin_beta_squared
    )
    sum_62 = 1.0 - sin_beta_squared + baseline_per_path_squared + product_1
    sum_63 = (
        11.0 * baseline_per_path_squared_squared
        - 1.0
        - 9.0 * baseline_per_path_squared * sin_beta_squared
        + 6.0 * baseline_per_path_squared
        + product_16
        + product_40
        + product_79
    )
    product_80 = -12.0 * baseline_per_path_squared_squared * cos_beta_squared_squared
    product_81 = 33.0 * baseline_per_path_squared_squared * cos_beta_squared
    sum_64 = (
        10.0 * baseline_per_path_squared_cubed
        - 10.0 * baseline_per_path_squared_cubed * cos_beta_squared
        - 24.0 * cos_beta * product_3
        - 6.0 * baseline_per_path_squared_squared
        + 15.0 * baseline_per_path_squared * cos_beta_squared_squared
        + 18.0 * product_3 * product_4
        + baseline_per_path_squared_cubed * cos_beta_squared_squared
        + cos_beta_squared
        + product_21
        + product_27
        + product_33
        + product_80
        + product_81
    )
    sum_65 = (
        1.0
        - 110.0 * cos_beta * product_59
        - 12.0 * baseline_per_path_squared_cubed * sin_beta_squared_squared
        - 154.0 * baseline_per_path_squared_cubed * sin_beta_squared
        - 16.0 * baseline_per_path_squared * sin_beta_squared
        - 46.0 * cos_beta * product_59 * sin_beta_squared
        - 48.0 * cos_beta * product_2 * sin_beta_squared
        - 98.0 * baseline_per_path_squared_squared
        + 10.0 * cos_beta * product_2
        + 104.0 * baseline_per_path_squared_squared * sin_beta_squared
        + 110.0 * cos_beta * product_3 * sin_beta_squared
        + 15.0 * baseline_per_path_squared_squared * sin_beta_squared_squared
        + 22.0 * baseline_per_path_squared
        + 34.0 * sin_beta_squared * term_2
        + 37.0 * term_2
        + 70.0 * baseline_per_path_squared_cubed
        + 76.0 * cos_beta * product_3
        + product_51
        + sin_beta_squared_squared * term_2
    )
    sum_66 = (
        10.0 * baseline_per_path_squared_cubed
        - 1.0
        - 11.0 * baseline_per_path_squared_cubed * cos_beta_squared
        - 24.0 * product_2 * product_4
        - 32.0 * cos_beta * product_3
        - 4.0 * baseline_per_path_squared
        + 2.0 * cos_beta_squared
        + 28.0 * product_3 * product_4
        + 3.0 * baseline_per_path_squared_squared
        + 36.0 * baseline_per_path_squared_squared * cos_beta_squared
        + 5.0 * baseline_per_path_squared * cos_beta_squared
        + product_15
        + product_20
        + product_24
        + product_26
        + product_32
        + product_43
        + product_45
        + product_47
    )
    sum_67 = (
        11.0 * baseline_per_path_squared * cos_beta_squared_squared
        - 12.0 * baseline_per_path_squared_cubed * cos_beta_squared
        - 20.0 * product_2 * product_4
        - 6.0 * baseline_per_path_squared_squared
        + 2.0 * baseline_per_path_squared
        + 2.0 * product_2 * product_5
        + 5.0 * baseline_per_path_squared_cubed * cos_beta_squared_squared
        + 8.0 * baseline_per_path_squared_cubed
        + cos_beta_squared
        + product_19
        + product_32
        + product_33
        + product_43
        + product_44
        + product_48
        + product_80
        + product_81
    )
    sum_68 = (
        1152.0 * baseline_per_path_squared_squared * predicted_sigma_path_per_path_squared_squared * product_76 * rho * sigma_beta * sigma_path_per_path * sum_48
        - 128.0 * baseline_per_path_squared * predicted_sigma_path_per_path_squared * sigma_path_per_path_squared * sin_beta_squared_squared * sum_20 * sum_5_squared
        - 128.0 * baseline_per_path_squared_squared * sigma_path_per_path_squared_squared * sin_beta_squared_cubed * sum_21
        - 128.0 * predicted_rho * predicted_sigma_beta * predicted_sigma_path_per_path * sigma_beta_squared * sin_beta * sum_54 * sum_5_squared * sum_7 * sum_8
        - 128.0 * product_31 * rho * sigma_path_per_path * sin_beta * sum_36 * sum_42 * sum_5_squared * sum_7 * sum_8
        - 192.0 * baseline_per_path_squared * predicted_sigma_beta_squared * predicted_sigma_path_per_path_squared * sigma_beta_squared * sin_beta_squared * sum_45 * sum_48 * sum_7 * sum_8
        - 256.0 * baseline_per_path_squared * predicted_rho * predicted_sigma_beta * predicted_sigma_path_per_path * product_39 * sigma_path_per_path_squared * sum_56 * sum_5_squared
        - 256.0 * baseline_per_path_squared * predicted_sigma_path_per_path_squared * product_39 * rho * sigma_beta * sigma_path_per_path * sum_55 * sum_5_squared
        - 256.0 * baseline_per_path_squared * product_39 * product_49 * rho * sigma_beta * sum_42 * sum_5_squared
        - 384.0 * baseline_per_path_squared * predicted_rho * predicted_sigma_path_per_path * product_17 * product_39 * sigma_path_per_path_squared * sum_46 * sum_48
        - 384.0 * baseline_per_path_squared * predicted_rho * predicted_sigma_beta * product_14 * product_39 * sigma_beta_squared * sum_46 * sum_48
        - 64.0 * predicted_sigma_beta_squared * sigma_beta_squared * sum_57 * sum_5_squared * sum_7_squared * sum_8_squared
        - 64.0 * predicted_sigma_beta_squared * rho * sigma_beta * sigma_path_per_path * sin_beta * sum_58 * sum_5_squared * sum_7 * sum_8
        - 768.0 * baseline_per_path_squared * predicted_rho_squared * predicted_sigma_beta_squared * predicted_sigma_path_per_path_squared * product_39 * rho * sigma_beta * sigma_path_per_path * sum_46 * sum_48
        + 128.0 * predicted_rho * predicted_sigma_beta * predicted_sigma_path_per_path * rho * sigma_beta * sigma_path_per_path * sum_59 * sum_5_squared
        + 128.0 * rho * sigma_beta * sigma_path_per_path * sin_beta * sum_22 * sum_48 * sum_5_squared_squared * sum_7 * sum_8
        + 16.0 * predicted_sigma_beta_squared_squared * sigma_beta_squared * sum_45**2 * sum_7_squared * sum_8_squared
        + 16.0 * predicted_sigma_beta_squared_squared * sigma_path_per_path_squared * sin_beta_squared * sum_46_squared
        + 192.0 * baseline_per_path_squared * predicted_sigma_beta_squared * predicted_sigma_path_per_path_squared * sigma_path_per_path_squared * sin_beta_squared_squared * sum_60
        + 192.0 * predicted_sigma_beta_squared * predicted_sigma_path_per_path_squared * product_2 * product_39 * rho * sigma_beta * sigma_path_per_path * sum_61
        + 2304.0 * baseline_per_path_squared_squared * predicted_rho_squared * predicted_sigma_beta_squared * predicted_sigma_path_per_path_squared * sigma_path_per_path_squared * sin_beta_squared_squared * sum_62
        + 2304.0 * baseline_per_path_squared_squared * predicted_rho * predicted_sigma_beta * product_14 * product_76 * sigma_path_per_path_squared * sum_48
        + 32.0 * predicted_sigma_beta_squared_squared * rho * sigma_beta * sigma_path_per_path * sin_beta * sum_45 * sum_46 * sum_7 * sum_8
        + 32.0 * sigma_beta_squared_squared * sin_beta_squared * sum_36**2 * sum_5_squared * sum_7_squared * sum_8_squared
        + 384.0 * baseline_per_path_squared * predicted_rho * predicted_sigma_beta * product_14 * rho * sigma_beta * sigma_path_per_path * sin_beta_squared_squared * sum_63
        + 576.0 * baseline_per_path_squared_squared * predicted_sigma_path_per_path_squared_squared * sigma_beta_squared * sin_beta_squared_squared * sum_62
        + 576.0 * baseline_per_path_squared_squared * predicted_sigma_path_per_path_squared_squared * sigma_path_per_path_squared * sin_beta_squared_cubed
        + 64.0 * predicted_rho_squared * predicted_sigma_beta_squared * predicted_sigma_path_per_path_squared * sigma_beta_squared * sin_beta_squared * sum_46_squared
        + 64.0 * predicted_sigma_beta_squared * sigma_path_per_path_squared * sum_5_squared * sum_66
        + 64.0 * predicted_rho * predicted_sigma_path_per_path * product_17 * sigma_beta_squared * sin_beta * sum_45 * sum_46 * sum_7 * sum_8
        + 64.0 * predicted_rho * predicted_sigma_path_per_path * product_17 * rho * sigma_beta * sigma_path_per_path * sin_beta_squared * sum_65
        + 64.0 * predicted_sigma_path_per_path_squared * sigma_beta_squared * sum_5_squared * sum_64
        + 64.0 * rho_squared * sigma_beta_squared * sigma_path_per_path_squared * sum_5_squared * sum_67
        + 64.0 * sigma_beta_squared * sigma_path_per_path_squared * sum_42**2 * sum_5_squared
        + 64.0 * sigma_beta_squared * sum_48**2 * sum_5_squared_squared * sum_7_squared * sum_8_squared
        + 64.0 * sigma_path_per_path_squared * sin_beta_squared * sum_22_squared * sum_5_squared_squared
    )
    result = _empty(arguments, (2, 2))
    result[..., 0, 0] = path_squared * sum_27 * term_3
    result[..., 0, 1] = path_squared * sum_53 * term_3
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = path_squared * sum_68 * term_3
    return result
