"""NumPy functions of the quantities spherical.*.

Written by radartrack regenerate, generator 1, derivation 7f75a8a7f72ff2b2; not to be edited.
"""

import numpy as np
import numpy.typing as npt

__all__ = [
    "bias_averaged",
    "bias_second_order",
    "bias_truth",
    "covariance_averaged",
    "covariance_linear",
    "covariance_second_order",
    "covariance_third_order",
    "covariance_truth",
    "decorrelated_covariance",
    "hessian",
    "jacobian",
    "map",
    "posterior_covariance",
    "posterior_estimate",
    "std_linear",
    "std_position",
    "unbiased_covariance",
    "unbiased_covariance_averaged",
    "unbiased_covariance_truth",
    "unbiased_estimate",
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


def map(*, r: npt.ArrayLike, beta: npt.ArrayLike, epsilon: npt.ArrayLike) -> Floats:
    """Map from the measured quantities to coordinates.

    Name: spherical.map.
    Definition: h.
    Conditioning: no expectation is taken.
    Source: Gao et al. 2020 (1), doi:10.12126/see.2020.02.013.

    Args:
        r: range [m], 1 to 1e+08.
        beta: azimuth, clockwise from the y axis [rad], -3.1416 to 3.1416.
        epsilon: elevation, up from the horizontal plane [rad], -1.5708 to 1.5708.

    Returns:
        Shape of the broadcast arguments + (3), unit m.

    Accuracy: at most 6.01 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 139.
    """
    arguments = _floats(r, beta, epsilon)
    r, beta, epsilon = arguments
    cos_beta = np.cos(beta)
    sin_beta = np.sin(beta)
    cos_epsilon = np.cos(epsilon)
    sin_epsilon = np.sin(epsilon)
    result = _empty(arguments, (3,))
    result[..., 0] = cos_epsilon * r * sin_beta
    result[..., 1] = cos_beta * cos_epsilon * r
    result[..., 2] = r * sin_epsilon
    return result


def jacobian(*, r: npt.ArrayLike, beta: npt.ArrayLike, epsilon: npt.ArrayLike) -> Floats:
    """First derivatives of the map, [out, in].

    Name: spherical.jacobian.
    Definition: dh/dtheta.
    Conditioning: no expectation is taken.
    Source: Prosov (6)-(7).

    Args:
        r: range [m], 1 to 1e+08.
        beta: azimuth, clockwise from the y axis [rad], -3.1416 to 3.1416.
        epsilon: elevation, up from the horizontal plane [rad], -1.5708 to 1.5708.

    Returns:
        Shape of the broadcast arguments + (3, 3), unit [m, m, m] × [1/m, 1/rad, 1/rad].

    Accuracy: at most 6.01 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 110.
    """
    arguments = _floats(r, beta, epsilon)
    r, beta, epsilon = arguments
    cos_beta = np.cos(beta)
    sin_beta = np.sin(beta)
    cos_epsilon = np.cos(epsilon)
    sin_epsilon = np.sin(epsilon)
    result = _empty(arguments, (3, 3))
    result[..., 0, 0] = cos_epsilon * sin_beta
    result[..., 0, 1] = cos_beta * cos_epsilon * r
    result[..., 0, 2] = -r * sin_beta * sin_epsilon
    result[..., 1, 0] = cos_beta * cos_epsilon
    result[..., 1, 1] = -cos_epsilon * r * sin_beta
    result[..., 1, 2] = -cos_beta * r * sin_epsilon
    result[..., 2, 0] = sin_epsilon
    result[..., 2, 1] = 0.0
    result[..., 2, 2] = cos_epsilon * r
    return result


def hessian(*, r: npt.ArrayLike, beta: npt.ArrayLike, epsilon: npt.ArrayLike) -> Floats:
    """Second derivatives of the map, [out, in, in].

    Name: spherical.hessian.
    Definition: d2h/dtheta2.
    Conditioning: no expectation is taken.
    Source: Prosov (6)-(7).

    Args:
        r: range [m], 1 to 1e+08.
        beta: azimuth, clockwise from the y axis [rad], -3.1416 to 3.1416.
        epsilon: elevation, up from the horizontal plane [rad], -1.5708 to 1.5708.

    Returns:
        Shape of the broadcast arguments + (3, 3, 3), unit [m, m, m] × [1/m, 1/rad, 1/rad] × [1/m, 1/rad,
        1/rad].

    Accuracy: at most 4.25 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 80.1.
    """
    arguments = _floats(r, beta, epsilon)
    r, beta, epsilon = arguments
    cos_beta = np.cos(beta)
    sin_beta = np.sin(beta)
    cos_epsilon = np.cos(epsilon)
    sin_epsilon = np.sin(epsilon)
    result = _empty(arguments, (3, 3, 3))
    result[..., 0, 0, 0] = 0.0
    result[..., 0, 0, 1] = cos_beta * cos_epsilon
    result[..., 0, 0, 2] = -sin_beta * sin_epsilon
    result[..., 0, 1, 0] = result[..., 0, 0, 1]
    result[..., 0, 1, 1] = -cos_epsilon * r * sin_beta
    result[..., 0, 1, 2] = -cos_beta * r * sin_epsilon
    result[..., 0, 2, 0] = result[..., 0, 0, 2]
    result[..., 0, 2, 1] = result[..., 0, 1, 2]
    result[..., 0, 2, 2] = result[..., 0, 1, 1]
    result[..., 1, 0, 0] = 0.0
    result[..., 1, 0, 1] = -cos_epsilon * sin_beta
    result[..., 1, 0, 2] = -cos_beta * sin_epsilon
    result[..., 1, 1, 0] = result[..., 1, 0, 1]
    result[..., 1, 1, 1] = -cos_beta * cos_epsilon * r
    result[..., 1, 1, 2] = r * sin_beta * sin_epsilon
    result[..., 1, 2, 0] = result[..., 1, 0, 2]
    result[..., 1, 2, 1] = result[..., 1, 1, 2]
    result[..., 1, 2, 2] = result[..., 1, 1, 1]
    result[..., 2, 0, 0] = 0.0
    result[..., 2, 0, 1] = 0.0
    result[..., 2, 0, 2] = cos_epsilon
    result[..., 2, 1, 0] = 0.0
    result[..., 2, 1, 1] = 0.0
    result[..., 2, 1, 2] = 0.0
    result[..., 2, 2, 0] = cos_epsilon
    result[..., 2, 2, 1] = 0.0
    result[..., 2, 2, 2] = -r * sin_epsilon
    return result


def bias_second_order(
    *,
    r: npt.ArrayLike,
    beta: npt.ArrayLike,
    epsilon: npt.ArrayLike,
    sigma_r: npt.ArrayLike,
    sigma_beta: npt.ArrayLike,
    sigma_epsilon: npt.ArrayLike,
    rho: npt.ArrayLike,
) -> Floats:
    """Bias of the plain conversion to second order.

    Name: spherical.bias.second_order.
    Definition: L h.
    Conditioning: truth-conditioned: the measured symbols stand for the true values.
    Source: Prosov (7).

    Args:
        r: range [m], 1 to 1e+08.
        beta: azimuth, clockwise from the y axis [rad], -3.1416 to 3.1416.
        epsilon: elevation, up from the horizontal plane [rad], -1.5708 to 1.5708.
        sigma_r: standard deviation of the error of r [m], 0.001 to 10000.
        sigma_beta: standard deviation of the error of beta [rad], 1e-09 to 1.
        sigma_epsilon: standard deviation of the error of epsilon [rad], 1e-09 to 1.
        rho: correlation of the errors of r and beta [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (3), unit m.

    Accuracy: at most 10.1 ulp anywhere in this domain with independent errors, proved for elementary
    functions within 1 ulp (float64); with correlations up to 0.99 in size at most 18.5; in float32, with
    functions within 4 of its ulp, at most 27.7.
    """
    arguments = _floats(r, beta, epsilon, sigma_r, sigma_beta, sigma_epsilon, rho)
    r, beta, epsilon, sigma_r, sigma_beta, sigma_epsilon, rho = arguments
    cos_beta = np.cos(beta)
    sin_beta = np.sin(beta)
    cos_epsilon = np.cos(epsilon)
    sin_epsilon = np.sin(epsilon)
    part_0_cos_beta_cos_epsilon = rho * sigma_beta * sigma_r
    sigma_epsilon_squared = sigma_epsilon**2
    part_0_cos_epsilon_sin_beta = -0.5 * r * sigma_beta**2 - 0.5 * r * sigma_epsilon_squared
    result = _empty(arguments, (3,))
    result[..., 0] = (
        cos_beta * cos_epsilon * part_0_cos_beta_cos_epsilon
        + cos_epsilon * part_0_cos_epsilon_sin_beta * sin_beta
    )
    result[..., 1] = (
        cos_beta * cos_epsilon * part_0_cos_epsilon_sin_beta
        - cos_epsilon * part_0_cos_beta_cos_epsilon * sin_beta
    )
    result[..., 2] = -0.5 * r * sigma_epsilon_squared * sin_epsilon
    return result


def covariance_linear(
    *,
    r: npt.ArrayLike,
    beta: npt.ArrayLike,
    epsilon: npt.ArrayLike,
    sigma_r: npt.ArrayLike,
    sigma_beta: npt.ArrayLike,
    sigma_epsilon: npt.ArrayLike,
    rho: npt.ArrayLike,
) -> Floats:
    """Covariance of the linearised conversion.

    Name: spherical.covariance.linear.
    Definition: J K J'.
    Conditioning: truth-conditioned: the measured symbols stand for the true values.
    Source: Prosov (9); Gao et al. 2020 (1), doi:10.12126/see.2020.02.013.

    Args:
        r: range [m], 1 to 1e+08.
        beta: azimuth, clockwise from the y axis [rad], -3.1416 to 3.1416.
        epsilon: elevation, up from the horizontal plane [rad], -1.5708 to 1.5708.
        sigma_r: standard deviation of the error of r [m], 0.001 to 10000.
        sigma_beta: standard deviation of the error of beta [rad], 1e-09 to 1.
        sigma_epsilon: standard deviation of the error of epsilon [rad], 1e-09 to 1.
        rho: correlation of the errors of r and beta [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (3, 3), unit m^2.

    Accuracy: at most 21.1 ulp anywhere in this domain with independent errors, proved for elementary
    functions within 1 ulp (float64); with correlations up to 0.99 in size at most 3690.
    """
    arguments = _floats(r, beta, epsilon, sigma_r, sigma_beta, sigma_epsilon, rho)
    r, beta, epsilon, sigma_r, sigma_beta, sigma_epsilon, rho = arguments
    cos_beta = np.cos(beta)
    sin_beta = np.sin(beta)
    cos_epsilon = np.cos(epsilon)
    sin_epsilon = np.sin(epsilon)
    r_squared = r**2
    sigma_beta_squared = sigma_beta**2
    part_00_cos_beta2_cos_epsilon2 = r_squared * sigma_beta_squared
    part_00_cos_beta_cos_epsilon2_sin_beta = 2.0 * r * rho * sigma_beta * sigma_r
    sigma_epsilon_squared = sigma_epsilon**2
    part_00_sin_beta2_sin_epsilon2 = r_squared * sigma_epsilon_squared
    part_01_cos_beta2_cos_epsilon2 = r * rho * sigma_beta * sigma_r
    sigma_r_squared = sigma_r**2
    part_01_cos_beta_cos_epsilon2_sin_beta = sigma_r_squared - r_squared * sigma_beta_squared
    part_02_cos_epsilon_sin_beta_sin_epsilon = sigma_r_squared - r_squared * sigma_epsilon_squared
    cos_beta_squared = cos_beta**2
    cos_epsilon_squared = cos_epsilon**2
    sin_beta_squared = sin_beta**2
    sin_epsilon_squared = sin_epsilon**2
    result = _empty(arguments, (3, 3))
    result[..., 0, 0] = (
        cos_beta * cos_epsilon_squared * part_00_cos_beta_cos_epsilon2_sin_beta * sin_beta
        + cos_beta_squared * cos_epsilon_squared * part_00_cos_beta2_cos_epsilon2
        + cos_epsilon_squared * sigma_r_squared * sin_beta_squared
        + part_00_sin_beta2_sin_epsilon2 * sin_beta_squared * sin_epsilon_squared
    )
    result[..., 0, 1] = (
        cos_beta * cos_epsilon_squared * part_01_cos_beta_cos_epsilon2_sin_beta * sin_beta
        - cos_epsilon_squared * part_01_cos_beta2_cos_epsilon2 * sin_beta_squared
        + cos_beta * part_00_sin_beta2_sin_epsilon2 * sin_beta * sin_epsilon_squared
        + cos_beta_squared * cos_epsilon_squared * part_01_cos_beta2_cos_epsilon2
    )
    result[..., 0, 2] = (
        cos_beta * cos_epsilon * part_01_cos_beta2_cos_epsilon2 * sin_epsilon
        + cos_epsilon * part_02_cos_epsilon_sin_beta_sin_epsilon * sin_beta * sin_epsilon
    )
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = (
        cos_beta_squared * cos_epsilon_squared * sigma_r_squared
        - cos_beta * cos_epsilon_squared * part_00_cos_beta_cos_epsilon2_sin_beta * sin_beta
        + cos_beta_squared * part_00_sin_beta2_sin_epsilon2 * sin_epsilon_squared
        + cos_epsilon_squared * part_00_cos_beta2_cos_epsilon2 * sin_beta_squared
    )
    result[..., 1, 2] = (
        cos_beta * cos_epsilon * part_02_cos_epsilon_sin_beta_sin_epsilon * sin_epsilon
        - cos_epsilon * part_01_cos_beta2_cos_epsilon2 * sin_beta * sin_epsilon
    )
    result[..., 2, 0] = result[..., 0, 2]
    result[..., 2, 1] = result[..., 1, 2]
    result[..., 2, 2] = (
        cos_epsilon_squared * part_00_sin_beta2_sin_epsilon2
        + sigma_r_squared * sin_epsilon_squared
    )
    return result


def covariance_second_order(
    *,
    r: npt.ArrayLike,
    beta: npt.ArrayLike,
    epsilon: npt.ArrayLike,
    sigma_r: npt.ArrayLike,
    sigma_beta: npt.ArrayLike,
    sigma_epsilon: npt.ArrayLike,
    rho: npt.ArrayLike,
) -> Floats:
    """Covariance of the conversion's quadratic Taylor polynomial.

    Name: spherical.covariance.second_order.
    Definition: J K J' + tr(G_a K G_b K)/2.
    Conditioning: truth-conditioned: the measured symbols stand for the true values.
    Source: Bar-Shalom & Li 1995.

    Args:
        r: range [m], 1 to 1e+08.
        beta: azimuth, clockwise from the y axis [rad], -3.1416 to 3.1416.
        epsilon: elevation, up from the horizontal plane [rad], -1.5708 to 1.5708.
        sigma_r: standard deviation of the error of r [m], 0.001 to 10000.
        sigma_beta: standard deviation of the error of beta [rad], 1e-09 to 1.
        sigma_epsilon: standard deviation of the error of epsilon [rad], 1e-09 to 1.
        rho: correlation of the errors of r and beta [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (3, 3), unit m^2.

    Accuracy: at most 44.8 ulp anywhere in this domain with independent errors, proved for elementary
    functions within 1 ulp (float64).
    """
    arguments = _floats(r, beta, epsilon, sigma_r, sigma_beta, sigma_epsilon, rho)
    r, beta, epsilon, sigma_r, sigma_beta, sigma_epsilon, rho = arguments
    cos_beta = np.cos(beta)
    sin_beta = np.sin(beta)
    cos_epsilon = np.cos(epsilon)
    sin_epsilon = np.sin(epsilon)
    r_squared = r**2
    sigma_beta_squared = sigma_beta**2
    rho_squared = rho**2
    sigma_r_squared = sigma_r**2
    part_00_cos_beta2_cos_epsilon2 = (
        r_squared * sigma_beta_squared
        + rho_squared * sigma_beta_squared * sigma_r_squared
        + sigma_beta_squared * sigma_r_squared
    )
    sigma_epsilon_squared = sigma_epsilon**2
    part_00_cos_beta2_sin_epsilon2 = r_squared * sigma_beta_squared * sigma_epsilon_squared
    product_1 = sigma_beta * sigma_beta_squared
    part_00_cos_beta_cos_epsilon2_sin_beta = (
        2.0 * r * rho * sigma_beta * sigma_r
        - 2.0 * product_1 * r * rho * sigma_r
    )
    part_00_cos_beta_sin_beta_sin_epsilon2 = 2.0 * r * rho * sigma_beta * sigma_epsilon_squared * sigma_r
    product_2 = 0.5 * r_squared * sigma_beta_squared**2
    product_3 = 0.5 * r_squared * sigma_epsilon_squared**2
    part_00_cos_epsilon2_sin_beta2 = product_2 + product_3 + sigma_r_squared
    product_4 = r_squared * sigma_epsilon_squared
    product_5 = sigma_epsilon_squared * sigma_r_squared
    part_00_sin_beta2_sin_epsilon2 = product_4 + product_5
    product_6 = r * rho * sigma_beta * sigma_r
    part_01_cos_beta2_cos_epsilon2 = product_6 - product_1 * r * rho * sigma_r
    part_01_cos_beta2_sin_epsilon2 = r * rho * sigma_beta * sigma_epsilon_squared * sigma_r
    part_01_cos_beta_cos_epsilon2_sin_beta = (
        product_2
        - r_squared * sigma_beta_squared
        - rho_squared * sigma_beta_squared * sigma_r_squared
        - sigma_beta_squared * sigma_r_squared
        + product_3
        + sigma_r_squared
    )
    part_01_cos_beta_sin_beta_sin_epsilon2 = (
        product_4
        - r_squared * sigma_beta_squared * sigma_epsilon_squared
        + product_5
    )
    part_02_cos_beta_cos_epsilon_sin_epsilon = (
        product_6
        - r * rho * sigma_beta * sigma_epsilon_squared * sigma_r
    )
    part_02_cos_epsilon_sin_beta_sin_epsilon = (
        product_3
        - r_squared * sigma_epsilon_squared
        - sigma_epsilon_squared * sigma_r_squared
        + sigma_r_squared
    )
    part_22_sin_epsilon2 = product_3 + sigma_r_squared
    cos_beta_squared = cos_beta**2
    cos_epsilon_squared = cos_epsilon**2
    sin_epsilon_squared = sin_epsilon**2
    sin_beta_squared = sin_beta**2
    result = _empty(arguments, (3, 3))
    result[..., 0, 0] = (
        cos_beta * cos_epsilon_squared * part_00_cos_beta_cos_epsilon2_sin_beta * sin_beta
        + cos_beta * part_00_cos_beta_sin_beta_sin_epsilon2 * sin_beta * sin_epsilon_squared
        + cos_beta_squared * cos_epsilon_squared * part_00_cos_beta2_cos_epsilon2
        + cos_beta_squared * part_00_cos_beta2_sin_epsilon2 * sin_epsilon_squared
        + cos_epsilon_squared * part_00_cos_epsilon2_sin_beta2 * sin_beta_squared
        + part_00_sin_beta2_sin_epsilon2 * sin_beta_squared * sin_epsilon_squared
    )
    result[..., 0, 1] = (
        cos_beta * cos_epsilon_squared * part_01_cos_beta_cos_epsilon2_sin_beta * sin_beta
        - cos_epsilon_squared * part_01_cos_beta2_cos_epsilon2 * sin_beta_squared
        - part_01_cos_beta2_sin_epsilon2 * sin_beta_squared * sin_epsilon_squared
        + cos_beta * part_01_cos_beta_sin_beta_sin_epsilon2 * sin_beta * sin_epsilon_squared
        + cos_beta_squared * cos_epsilon_squared * part_01_cos_beta2_cos_epsilon2
        + cos_beta_squared * part_01_cos_beta2_sin_epsilon2 * sin_epsilon_squared
    )
    result[..., 0, 2] = (
        cos_beta * cos_epsilon * part_02_cos_beta_cos_epsilon_sin_epsilon * sin_epsilon
        + cos_epsilon * part_02_cos_epsilon_sin_beta_sin_epsilon * sin_beta * sin_epsilon
    )
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = (
        cos_beta_squared * cos_epsilon_squared * part_00_cos_epsilon2_sin_beta2
        - cos_beta * cos_epsilon_squared * part_00_cos_beta_cos_epsilon2_sin_beta * sin_beta
        - cos_beta * part_00_cos_beta_sin_beta_sin_epsilon2 * sin_beta * sin_epsilon_squared
        + cos_beta_squared * part_00_sin_beta2_sin_epsilon2 * sin_epsilon_squared
        + cos_epsilon_squared * part_00_cos_beta2_cos_epsilon2 * sin_beta_squared
        + part_00_cos_beta2_sin_epsilon2 * sin_beta_squared * sin_epsilon_squared
    )
    result[..., 1, 2] = (
        cos_beta * cos_epsilon * part_02_cos_epsilon_sin_beta_sin_epsilon * sin_epsilon
        - cos_epsilon * part_02_cos_beta_cos_epsilon_sin_epsilon * sin_beta * sin_epsilon
    )
    result[..., 2, 0] = result[..., 0, 2]
    result[..., 2, 1] = result[..., 1, 2]
    result[..., 2, 2] = (
        cos_epsilon_squared * part_00_sin_beta2_sin_epsilon2
        + part_22_sin_epsilon2 * sin_epsilon_squared
    )
    return result


def std_linear(
    *,
    r: npt.ArrayLike,
    beta: npt.ArrayLike,
    epsilon: npt.ArrayLike,
    sigma_r: npt.ArrayLike,
    sigma_beta: npt.ArrayLike,
    sigma_epsilon: npt.ArrayLike,
    rho: npt.ArrayLike,
) -> Floats:
    """Standard deviation of each coordinate of the linearised conversion.

    Name: spherical.std.linear.
    Definition: sqrt((J K J')_aa).
    Conditioning: truth-conditioned: the measured symbols stand for the true values.
    Source: Gao et al. 2020 (1), doi:10.12126/see.2020.02.013.

    Args:
        r: range [m], 1 to 1e+08.
        beta: azimuth, clockwise from the y axis [rad], -3.1416 to 3.1416.
        epsilon: elevation, up from the horizontal plane [rad], -1.5708 to 1.5708.
        sigma_r: standard deviation of the error of r [m], 0.001 to 10000.
        sigma_beta: standard deviation of the error of beta [rad], 1e-09 to 1.
        sigma_epsilon: standard deviation of the error of epsilon [rad], 1e-09 to 1.
        rho: correlation of the errors of r and beta [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (3), unit m.

    Accuracy: at most 11.6 ulp anywhere in this domain with independent errors, proved for elementary
    functions within 1 ulp (float64); with correlations up to 0.99 in size at most 1850.
    """
    arguments = _floats(r, beta, epsilon, sigma_r, sigma_beta, sigma_epsilon, rho)
    r, beta, epsilon, sigma_r, sigma_beta, sigma_epsilon, rho = arguments
    cos_beta = np.cos(beta)
    sin_beta = np.sin(beta)
    cos_epsilon = np.cos(epsilon)
    sin_epsilon = np.sin(epsilon)
    r_squared = r**2
    part_0_cos_beta2_cos_epsilon2 = r_squared * sigma_beta**2
    part_0_cos_beta_cos_epsilon2_sin_beta = 2.0 * r * rho * sigma_beta * sigma_r
    part_0_sin_beta2_sin_epsilon2 = r_squared * sigma_epsilon**2
    cos_beta_squared = cos_beta**2
    cos_epsilon_squared = cos_epsilon**2
    sigma_r_squared = sigma_r**2
    sin_beta_squared = sin_beta**2
    sin_epsilon_squared = sin_epsilon**2
    result = _empty(arguments, (3,))
    result[..., 0] = np.sqrt(cos_beta * cos_epsilon_squared * part_0_cos_beta_cos_epsilon2_sin_beta * sin_beta + cos_beta_squared * cos_epsilon_squared * part_0_cos_beta2_cos_epsilon2 + cos_epsilon_squared * sigma_r_squared * sin_beta_squared + part_0_sin_beta2_sin_epsilon2 * sin_beta_squared * sin_epsilon_squared)
    result[..., 1] = np.sqrt(cos_beta_squared * cos_epsilon_squared * sigma_r_squared - cos_beta * cos_epsilon_squared * part_0_cos_beta_cos_epsilon2_sin_beta * sin_beta + cos_beta_squared * part_0_sin_beta2_sin_epsilon2 * sin_epsilon_squared + cos_epsilon_squared * part_0_cos_beta2_cos_epsilon2 * sin_beta_squared)
    result[..., 2] = np.sqrt(cos_epsilon_squared * part_0_sin_beta2_sin_epsilon2 + sigma_r_squared * sin_epsilon_squared)
    return result


def std_position(
    *,
    r: npt.ArrayLike,
    beta: npt.ArrayLike,
    epsilon: npt.ArrayLike,
    sigma_r: npt.ArrayLike,
    sigma_beta: npt.ArrayLike,
    sigma_epsilon: npt.ArrayLike,
    rho: npt.ArrayLike,
) -> Floats:
    """Root mean square of the coordinates' standard deviations, linearised.

    Name: spherical.std.position.
    Definition: sqrt(tr(J K J')/n).
    Conditioning: truth-conditioned: the measured symbols stand for the true values.
    Source: Gao et al. 2020 (2), doi:10.12126/see.2020.02.013.

    Args:
        r: range [m], 1 to 1e+08.
        beta: azimuth, clockwise from the y axis [rad], -3.1416 to 3.1416.
        epsilon: elevation, up from the horizontal plane [rad], -1.5708 to 1.5708.
        sigma_r: standard deviation of the error of r [m], 0.001 to 10000.
        sigma_beta: standard deviation of the error of beta [rad], 1e-09 to 1.
        sigma_epsilon: standard deviation of the error of epsilon [rad], 1e-09 to 1.
        rho: correlation of the errors of r and beta [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments, unit m.

    Accuracy: at most 14.6 ulp anywhere in this domain with independent errors, proved for elementary
    functions within 1 ulp (float64); with correlations up to 0.99 in size at most 14.6.
    """
    arguments = _floats(r, beta, epsilon, sigma_r, sigma_beta, sigma_epsilon, rho)
    r, beta, epsilon, sigma_r, sigma_beta, sigma_epsilon, rho = arguments
    cos_beta = np.cos(beta)
    sin_beta = np.sin(beta)
    cos_epsilon = np.cos(epsilon)
    sin_epsilon = np.sin(epsilon)
    r_squared = r**2
    part_0_cos_beta2_cos_epsilon2 = r_squared * sigma_beta**2
    part_0_sin_beta2_sin_epsilon2 = r_squared * sigma_epsilon**2
    cos_beta_squared = cos_beta**2
    cos_epsilon_squared = cos_epsilon**2
    sigma_r_squared = sigma_r**2
    sin_epsilon_squared = sin_epsilon**2
    sin_beta_squared = sin_beta**2
    result = _empty(arguments, ())
    result[...] = np.sqrt(cos_beta_squared * cos_epsilon_squared * part_0_cos_beta2_cos_epsilon2 / 3.0 + cos_beta_squared * cos_epsilon_squared * sigma_r_squared / 3.0 + cos_beta_squared * part_0_sin_beta2_sin_epsilon2 * sin_epsilon_squared / 3.0 + cos_epsilon_squared * part_0_cos_beta2_cos_epsilon2 * sin_beta_squared / 3.0 + cos_epsilon_squared * part_0_sin_beta2_sin_epsilon2 / 3.0 + cos_epsilon_squared * sigma_r_squared * sin_beta_squared / 3.0 + part_0_sin_beta2_sin_epsilon2 * sin_beta_squared * sin_epsilon_squared / 3.0 + sigma_r_squared * sin_epsilon_squared / 3.0)
    return result[()]


def validity_linear(
    *,
    r: npt.ArrayLike,
    beta: npt.ArrayLike,
    epsilon: npt.ArrayLike,
    sigma_r: npt.ArrayLike,
    sigma_beta: npt.ArrayLike,
    sigma_epsilon: npt.ArrayLike,
    rho: npt.ArrayLike,
) -> Floats:
    """Leading term that the linear formulas neglect, root mean square, over the linear standard deviation, one a measured quantity.

    Name: spherical.validity.linear.
    Definition: sqrt(E[(J^-1 (w.d)^2 h)_i^2])/(2 sigma_i).
    Conditioning: truth-conditioned: the measured symbols stand for the true values.
    Source: Prosov the question of validity.

    Args:
        r: range [m], 1 to 1e+08.
        beta: azimuth, clockwise from the y axis [rad], -3.1416 to 3.1416.
        epsilon: elevation, up from the horizontal plane [rad], -1.5708 to 1.5708.
        sigma_r: standard deviation of the error of r [m], 0.001 to 10000.
        sigma_beta: standard deviation of the error of beta [rad], 1e-09 to 1.
        sigma_epsilon: standard deviation of the error of epsilon [rad], 1e-09 to 1.
        rho: correlation of the errors of r and beta [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (3), unit 1.

    Accuracy: at most 16.6 ulp anywhere in this domain with independent errors, proved for elementary
    functions within 1 ulp (float64); with correlations up to 0.99 in size at most 16.6.
    """
    arguments = _floats(r, beta, epsilon, sigma_r, sigma_beta, sigma_epsilon, rho)
    r, beta, epsilon, sigma_r, sigma_beta, sigma_epsilon, rho = arguments
    cos_epsilon = np.cos(epsilon)
    sin_epsilon = np.sin(epsilon)
    cos_epsilon_squared = cos_epsilon**2
    sigma_beta_squared = sigma_beta**2
    sigma_epsilon_squared = sigma_epsilon**2
    r_squared = r**2
    sigma_beta_squared_squared = sigma_beta_squared**2
    cos_epsilon_ = cos_epsilon
    term_1 = 1.0 / r
    sigma_r_squared = sigma_r**2
    sin_epsilon_squared = sin_epsilon**2
    result = _empty(arguments, (3,))
    result[..., 0] = np.sqrt((-0.5 * cos_epsilon_squared * r * sigma_beta_squared - 0.5 * r * sigma_epsilon_squared)**2 + 0.5 * cos_epsilon_squared**2 * r_squared * sigma_beta_squared_squared + 0.5 * r_squared * sigma_epsilon_squared**2) / sigma_r
    result[..., 1] = np.sqrt(2.0 * cos_epsilon_squared * rho**2 * sigma_beta_squared * sigma_r_squared + cos_epsilon_squared * sigma_beta_squared * sigma_r_squared + r_squared * sigma_beta_squared * sigma_epsilon_squared * sin_epsilon_squared) * term_1 / (cos_epsilon_ * sigma_beta)
    result[..., 2] = np.sqrt(0.75 * cos_epsilon_squared * r_squared * sigma_beta_squared_squared * sin_epsilon_squared + sigma_epsilon_squared * sigma_r_squared) * term_1 / sigma_epsilon
    return result


def validity_second_order(
    *,
    r: npt.ArrayLike,
    beta: npt.ArrayLike,
    epsilon: npt.ArrayLike,
    sigma_r: npt.ArrayLike,
    sigma_beta: npt.ArrayLike,
    sigma_epsilon: npt.ArrayLike,
    rho: npt.ArrayLike,
) -> Floats:
    """Leading term that the second-order formulas neglect, root mean square, over the linear standard deviation, one a measured quantity.

    Name: spherical.validity.second_order.
    Definition: sqrt(E[(J^-1 (w.d)^3 h)_i^2])/(6 sigma_i).
    Conditioning: truth-conditioned: the measured symbols stand for the true values.
    Source: Prosov the question of validity.

    Args:
        r: range [m], 1 to 1e+08.
        beta: azimuth, clockwise from the y axis [rad], -3.1416 to 3.1416.
        epsilon: elevation, up from the horizontal plane [rad], -1.5708 to 1.5708.
        sigma_r: standard deviation of the error of r [m], 0.001 to 10000.
        sigma_beta: standard deviation of the error of beta [rad], 1e-09 to 1.
        sigma_epsilon: standard deviation of the error of epsilon [rad], 1e-09 to 1.
        rho: correlation of the errors of r and beta [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (3), unit 1.

    Accuracy: at most 20.1 ulp anywhere in this domain with independent errors, proved for elementary
    functions within 1 ulp (float64); with correlations up to 0.99 in size at most 22.1.
    """
    arguments = _floats(r, beta, epsilon, sigma_r, sigma_beta, sigma_epsilon, rho)
    r, beta, epsilon, sigma_r, sigma_beta, sigma_epsilon, rho = arguments
    cos_epsilon = np.cos(epsilon)
    sin_epsilon = np.sin(epsilon)
    complement_of_rho = np.sqrt((1.0 - rho) * (1.0 + rho))
    cos_epsilon_squared = cos_epsilon**2
    r_squared = r**2
    sigma_beta_squared = sigma_beta**2
    sigma_beta_squared_squared = sigma_beta_squared**2
    sigma_epsilon_squared = sigma_epsilon**2
    sin_epsilon_squared = sin_epsilon**2
    cos_epsilon_squared_squared = cos_epsilon_squared**2
    rho_squared = rho**2
    sigma_r_squared = sigma_r**2
    complement_of_rho_squared = complement_of_rho**2
    sigma_epsilon_squared_squared = sigma_epsilon_squared**2
    cos_epsilon_ = cos_epsilon
    term_1 = 1.0 / r
    result = _empty(arguments, (3,))
    result[..., 0] = np.sqrt(0.75 * cos_epsilon_squared * r_squared * sigma_beta_squared_squared * sigma_epsilon_squared * sin_epsilon_squared + 1.5 * cos_epsilon_squared_squared * rho_squared * sigma_beta_squared_squared * sigma_r_squared + 0.5 * complement_of_rho_squared * cos_epsilon_squared_squared * sigma_beta_squared_squared * sigma_r_squared + 0.5 * complement_of_rho_squared * sigma_epsilon_squared_squared * sigma_r_squared + (-0.5 * cos_epsilon_squared * sigma_beta_squared - 0.5 * sigma_epsilon_squared)**2 * complement_of_rho_squared * sigma_r_squared + 0.5 * rho_squared * sigma_epsilon_squared_squared * sigma_r_squared + (-1.5 * cos_epsilon_squared * sigma_beta_squared - 0.5 * sigma_epsilon_squared)**2 * rho_squared * sigma_r_squared) / sigma_r
    result[..., 1] = np.sqrt(3.0 * rho_squared * sigma_beta_squared * sigma_epsilon_squared * sigma_r_squared * sin_epsilon_squared + complement_of_rho_squared * sigma_beta_squared * sigma_epsilon_squared * sigma_r_squared * sin_epsilon_squared + cos_epsilon_squared * r_squared * sigma_beta_squared * sigma_beta_squared**2 / 6.0 + 0.5 * cos_epsilon_squared * r_squared * sigma_beta_squared * sigma_epsilon_squared_squared + (-0.5 * cos_epsilon * r * sigma_beta_squared - 0.5 * cos_epsilon * r * sigma_epsilon_squared)**2 * sigma_beta_squared) * term_1 / (cos_epsilon_ * sigma_beta)
    result[..., 2] = np.sqrt(3.75 * cos_epsilon_squared * rho_squared * sigma_beta_squared_squared * sigma_r_squared * sin_epsilon_squared + 0.75 * complement_of_rho_squared * cos_epsilon_squared * sigma_beta_squared_squared * sigma_r_squared * sin_epsilon_squared + 0.5 * r_squared * sigma_beta_squared_squared * sigma_epsilon_squared * sin_epsilon_squared**2 + r_squared * sigma_epsilon_squared * sigma_epsilon_squared**2 / 6.0 + (-0.5 * r * sigma_beta_squared * sin_epsilon_squared - 0.5 * r * sigma_epsilon_squared)**2 * sigma_epsilon_squared) * term_1 / sigma_epsilon
    return result


def covariance_third_order(
    *,
    r: npt.ArrayLike,
    beta: npt.ArrayLike,
    epsilon: npt.ArrayLike,
    sigma_r: npt.ArrayLike,
    sigma_beta: npt.ArrayLike,
    sigma_epsilon: npt.ArrayLike,
    rho: npt.ArrayLike,
) -> Floats:
    """Covariance of the conversion's cubic Taylor polynomial.

    Name: spherical.covariance.third_order.
    Definition: E[p p'] - E[p] E[p]', p = h + (w.d) h + (w.d)^2 h/2 + (w.d)^3 h/6.
    Conditioning: truth-conditioned: the measured symbols stand for the true values.
    Source: Bar-Shalom & Li 1995.

    Args:
        r: range [m], 1 to 1e+08.
        beta: azimuth, clockwise from the y axis [rad], -3.1416 to 3.1416.
        epsilon: elevation, up from the horizontal plane [rad], -1.5708 to 1.5708.
        sigma_r: standard deviation of the error of r [m], 0.001 to 10000.
        sigma_beta: standard deviation of the error of beta [rad], 1e-09 to 1.
        sigma_epsilon: standard deviation of the error of epsilon [rad], 1e-09 to 1.
        rho: correlation of the errors of r and beta [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (3, 3), unit m^2.

    Accuracy: at most 357 ulp anywhere in this domain with independent errors, proved for elementary functions
    within 1 ulp (float64).
    """
    arguments = _floats(r, beta, epsilon, sigma_r, sigma_beta, sigma_epsilon, rho)
    r, beta, epsilon, sigma_r, sigma_beta, sigma_epsilon, rho = arguments
    cos_beta = np.cos(beta)
    sin_beta = np.sin(beta)
    cos_epsilon = np.cos(epsilon)
    sin_epsilon = np.sin(epsilon)
    r_squared = r**2
    sigma_beta_squared = sigma_beta**2
    sigma_epsilon_squared = sigma_epsilon**2
    product_1 = -r_squared * sigma_beta_squared * sigma_epsilon_squared
    sigma_beta_squared_squared = sigma_beta_squared**2
    sigma_epsilon_squared_squared = sigma_epsilon_squared**2
    sigma_beta_squared_cubed = sigma_beta_squared * sigma_beta_squared**2
    rho_squared = rho**2
    sigma_r_squared = sigma_r**2
    part_00_cos_beta2_cos_epsilon2 = (
        0.75 * r_squared * sigma_beta_squared * sigma_epsilon_squared_squared
        - r_squared * sigma_beta_squared_squared
        + 5.0 * r_squared * sigma_beta_squared_cubed / 12.0
        + product_1
        + r_squared * sigma_beta_squared
        + 0.5 * r_squared * sigma_beta_squared_squared * sigma_epsilon_squared
        + rho_squared * sigma_beta_squared * sigma_r_squared
        + sigma_beta_squared * sigma_r_squared
    )
    product_2 = r_squared * sigma_beta_squared * sigma_epsilon_squared
    part_00_cos_beta2_sin_epsilon2 = (
        2.0 * rho_squared * sigma_beta_squared * sigma_epsilon_squared * sigma_r_squared
        + product_2
        + sigma_beta_squared * sigma_epsilon_squared * sigma_r_squared
    )
    product_3 = sigma_beta * sigma_beta_squared
    product_4 = sigma_beta * sigma_beta_squared**2
    part_00_cos_beta_cos_epsilon2_sin_beta = (
        2.0 * product_3 * r * rho * sigma_epsilon_squared * sigma_r
        - 2.0 * r * rho * sigma_beta * sigma_epsilon_squared * sigma_r
        - 6.0 * product_3 * r * rho * sigma_r
        + 2.0 * r * rho * sigma_beta * sigma_r
        + 1.5 * r * rho * sigma_beta * sigma_epsilon_squared_squared * sigma_r
        + 2.5 * product_4 * r * rho * sigma_r
    )
    part_00_cos_beta_sin_beta_sin_epsilon2 = (
        4.0 * r * rho * sigma_beta * sigma_epsilon_squared * sigma_r
        - 3.0 * product_3 * r * rho * sigma_epsilon_squared * sigma_r
        - r * rho * sigma_beta * sigma_epsilon_squared_squared * sigma_r
    )
    product_5 = -sigma_epsilon_squared * sigma_r_squared
    product_6 = 3.0 * rho_squared * sigma_beta_squared_squared * sigma_r_squared
    product_7 = 0.75 * sigma_beta_squared_squared * sigma_r_squared
    product_8 = 0.75 * sigma_epsilon_squared_squared * sigma_r_squared
    product_9 = 0.5 * r_squared * sigma_epsilon_squared_squared
    product_10 = rho_squared * sigma_beta_squared * sigma_epsilon_squared * sigma_r_squared
    product_11 = 0.5 * sigma_beta_squared * sigma_epsilon_squared * sigma_r_squared
    part_00_cos_epsilon2_sin_beta2 = (
        product_10
        - 2.0 * rho_squared * sigma_beta_squared * sigma_r_squared
        - sigma_beta_squared * sigma_r_squared
        + product_11
        + product_5
        + product_6
        + product_7
        + product_8
        + product_9
        + 0.5 * r_squared * sigma_beta_squared_squared
        + sigma_r_squared
    )
    product_12 = -r_squared * sigma_epsilon_squared_squared
    product_13 = 0.75 * r_squared * sigma_beta_squared_squared * sigma_epsilon_squared
    sigma_epsilon_squared_cubed = sigma_epsilon_squared * sigma_epsilon_squared**2
    product_14 = 5.0 * r_squared * sigma_epsilon_squared_cubed / 12.0
    product_15 = 0.5 * r_squared * sigma_beta_squared * sigma_epsilon_squared_squared
    product_16 = r_squared * sigma_epsilon_squared
    product_17 = sigma_epsilon_squared * sigma_r_squared
    part_00_sin_beta2_sin_epsilon2 = (
        product_1
        + product_12
        + product_13
        + product_14
        + product_15
        + product_16
        + product_17
    )
    product_18 = r * rho * sigma_beta * sigma_r
    part_01_cos_beta2_cos_epsilon2 = (
        0.75 * r * rho * sigma_beta * sigma_epsilon_squared_squared * sigma_r
        - 3.0 * product_3 * r * rho * sigma_r
        - r * rho * sigma_beta * sigma_epsilon_squared * sigma_r
        + 1.25 * product_4 * r * rho * sigma_r
        + product_18
        + product_3 * r * rho * sigma_epsilon_squared * sigma_r
    )
    part_01_cos_beta2_sin_epsilon2 = (
        2.0 * r * rho * sigma_beta * sigma_epsilon_squared * sigma_r
        - 1.5 * product_3 * r * rho * sigma_epsilon_squared * sigma_r
        - 0.5 * r * rho * sigma_beta * sigma_epsilon_squared_squared * sigma_r
    )
    part_01_cos_beta_cos_epsilon2_sin_beta = (
        1.5 * r_squared * sigma_beta_squared_squared
        - 2.0 * sigma_beta_squared * sigma_r_squared
        - 0.75 * r_squared * sigma_beta_squared * sigma_epsilon_squared_squared
        - 3.0 * rho_squared * sigma_beta_squared * sigma_r_squared
        - 5.0 * r_squared * sigma_beta_squared_cubed / 12.0
        - r_squared * sigma_beta_squared
        - 0.5 * r_squared * sigma_beta_squared_squared * sigma_epsilon_squared
        + product_10
        + product_11
        + product_2
        + product_5
        + product_6
        + product_7
        + product_8
        + product_9
        + sigma_r_squared
    )
    part_01_cos_beta_sin_beta_sin_epsilon2 = (
        product_12
        - 2.0 * r_squared * sigma_beta_squared * sigma_epsilon_squared
        - 2.0 * rho_squared * sigma_beta_squared * sigma_epsilon_squared * sigma_r_squared
        - sigma_beta_squared * sigma_epsilon_squared * sigma_r_squared
        + product_13
        + product_14
        + product_15
        + product_16
        + product_17
    )
    part_02_cos_beta_cos_epsilon_sin_epsilon = (
        1.25 * r * rho * sigma_beta * sigma_epsilon_squared_squared * sigma_r
        - 3.0 * r * rho * sigma_beta * sigma_epsilon_squared * sigma_r
        - 0.5 * product_3 * r * rho * sigma_r
        + product_18
        + 0.25 * product_3 * r * rho * sigma_epsilon_squared * sigma_r
    )
    part_02_cos_epsilon_sin_beta_sin_epsilon = (
        1.5 * r_squared * sigma_epsilon_squared_squared
        - 2.0 * sigma_epsilon_squared * sigma_r_squared
        - 5.0 * r_squared * sigma_epsilon_squared_cubed / 12.0
        - 0.25 * r_squared * sigma_beta_squared * sigma_epsilon_squared_squared
        - r_squared * sigma_epsilon_squared
        - rho_squared * sigma_beta_squared * sigma_r_squared
        - 0.5 * sigma_beta_squared * sigma_r_squared
        + product_8
        + 0.5 * r_squared * sigma_beta_squared * sigma_epsilon_squared
        + 0.5 * rho_squared * sigma_beta_squared * sigma_epsilon_squared * sigma_r_squared
        + 0.25 * sigma_beta_squared * sigma_epsilon_squared * sigma_r_squared
        + sigma_r_squared
    )
    part_22_cos_epsilon2 = product_12 + product_14 + product_16 + product_17
    part_22_sin_epsilon2 = product_5 + product_8 + product_9 + sigma_r_squared
    cos_beta_squared = cos_beta**2
    cos_epsilon_squared = cos_epsilon**2
    sin_epsilon_squared = sin_epsilon**2
    sin_beta_squared = sin_beta**2
    result = _empty(arguments, (3, 3))
    result[..., 0, 0] = (
        cos_beta * cos_epsilon_squared * part_00_cos_beta_cos_epsilon2_sin_beta * sin_beta
        + cos_beta * part_00_cos_beta_sin_beta_sin_epsilon2 * sin_beta * sin_epsilon_squared
        + cos_beta_squared * cos_epsilon_squared * part_00_cos_beta2_cos_epsilon2
        + cos_beta_squared * part_00_cos_beta2_sin_epsilon2 * sin_epsilon_squared
        + cos_epsilon_squared * part_00_cos_epsilon2_sin_beta2 * sin_beta_squared
        + part_00_sin_beta2_sin_epsilon2 * sin_beta_squared * sin_epsilon_squared
    )
    result[..., 0, 1] = (
        cos_beta * cos_epsilon_squared * part_01_cos_beta_cos_epsilon2_sin_beta * sin_beta
        - cos_epsilon_squared * part_01_cos_beta2_cos_epsilon2 * sin_beta_squared
        - part_01_cos_beta2_sin_epsilon2 * sin_beta_squared * sin_epsilon_squared
        + cos_beta * part_01_cos_beta_sin_beta_sin_epsilon2 * sin_beta * sin_epsilon_squared
        + cos_beta_squared * cos_epsilon_squared * part_01_cos_beta2_cos_epsilon2
        + cos_beta_squared * part_01_cos_beta2_sin_epsilon2 * sin_epsilon_squared
    )
    result[..., 0, 2] = (
        cos_beta * cos_epsilon * part_02_cos_beta_cos_epsilon_sin_epsilon * sin_epsilon
        + cos_epsilon * part_02_cos_epsilon_sin_beta_sin_epsilon * sin_beta * sin_epsilon
    )
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = (
        cos_beta_squared * cos_epsilon_squared * part_00_cos_epsilon2_sin_beta2
        - cos_beta * cos_epsilon_squared * part_00_cos_beta_cos_epsilon2_sin_beta * sin_beta
        - cos_beta * part_00_cos_beta_sin_beta_sin_epsilon2 * sin_beta * sin_epsilon_squared
        + cos_beta_squared * part_00_sin_beta2_sin_epsilon2 * sin_epsilon_squared
        + cos_epsilon_squared * part_00_cos_beta2_cos_epsilon2 * sin_beta_squared
        + part_00_cos_beta2_sin_epsilon2 * sin_beta_squared * sin_epsilon_squared
    )
    result[..., 1, 2] = (
        cos_beta * cos_epsilon * part_02_cos_epsilon_sin_beta_sin_epsilon * sin_epsilon
        - cos_epsilon * part_02_cos_beta_cos_epsilon_sin_epsilon * sin_beta * sin_epsilon
    )
    result[..., 2, 0] = result[..., 0, 2]
    result[..., 2, 1] = result[..., 1, 2]
    result[..., 2, 2] = (
        cos_epsilon_squared * part_22_cos_epsilon2
        + part_22_sin_epsilon2 * sin_epsilon_squared
    )
    return result


def bias_truth(
    *,
    r: npt.ArrayLike,
    beta: npt.ArrayLike,
    epsilon: npt.ArrayLike,
    sigma_r: npt.ArrayLike,
    sigma_beta: npt.ArrayLike,
    sigma_epsilon: npt.ArrayLike,
    rho: npt.ArrayLike,
) -> Floats:
    """Exact bias of the plain conversion h(z).

    Name: spherical.bias.truth.
    Definition: (e^L - 1) h.
    Conditioning: truth-conditioned: the measured symbols stand for the true values.
    Source: Lerro & Bar-Shalom 1993, doi:10.1109/7.220948.

    Args:
        r: range [m], 1 to 1e+08.
        beta: azimuth, clockwise from the y axis [rad], -3.1416 to 3.1416.
        epsilon: elevation, up from the horizontal plane [rad], -1.5708 to 1.5708.
        sigma_r: standard deviation of the error of r [m], 0.001 to 10000.
        sigma_beta: standard deviation of the error of beta [rad], 1e-09 to 1.
        sigma_epsilon: standard deviation of the error of epsilon [rad], 1e-09 to 1.
        rho: correlation of the errors of r and beta [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (3), unit m.

    Accuracy: at most 15.6 ulp anywhere in this domain with independent errors, proved for elementary
    functions within 1 ulp (float64); with correlations up to 0.99 in size at most 31.9; in float32, with
    functions within 4 of its ulp, at most 45.4.
    """
    arguments = _floats(r, beta, epsilon, sigma_r, sigma_beta, sigma_epsilon, rho)
    r, beta, epsilon, sigma_r, sigma_beta, sigma_epsilon, rho = arguments
    cos_beta = np.cos(beta)
    sin_beta = np.sin(beta)
    cos_epsilon = np.cos(epsilon)
    sin_epsilon = np.sin(epsilon)
    attenuation_beta = np.exp(-0.5 * sigma_beta**2)
    shortfall_beta = -np.expm1(-0.5 * sigma_beta**2)
    attenuation_epsilon = np.exp(-0.5 * sigma_epsilon**2)
    shortfall_epsilon = -np.expm1(-0.5 * sigma_epsilon**2)
    part_0_cos_beta_cos_epsilon = attenuation_beta * attenuation_epsilon * rho * sigma_beta * sigma_r
    sum_1 = shortfall_beta * shortfall_epsilon - shortfall_beta - shortfall_epsilon
    part_0_cos_epsilon_sin_beta = r * sum_1
    result = _empty(arguments, (3,))
    result[..., 0] = (
        cos_beta * cos_epsilon * part_0_cos_beta_cos_epsilon
        + cos_epsilon * part_0_cos_epsilon_sin_beta * sin_beta
    )
    result[..., 1] = (
        cos_beta * cos_epsilon * part_0_cos_epsilon_sin_beta
        - cos_epsilon * part_0_cos_beta_cos_epsilon * sin_beta
    )
    result[..., 2] = -r * shortfall_epsilon * sin_epsilon
    return result


def bias_averaged(
    *,
    r: npt.ArrayLike,
    beta: npt.ArrayLike,
    epsilon: npt.ArrayLike,
    sigma_r: npt.ArrayLike,
    sigma_beta: npt.ArrayLike,
    sigma_epsilon: npt.ArrayLike,
    rho: npt.ArrayLike,
) -> Floats:
    """Exact bias of the plain conversion, averaged over the truth.

    Name: spherical.bias.averaged.
    Definition: (e^2L - e^L) h.
    Conditioning: measurement-conditioned: the measured symbols stand for the measurement.
    Source: Lerro & Bar-Shalom 1993, doi:10.1109/7.220948.

    Args:
        r: range [m], 1 to 1e+08.
        beta: azimuth, clockwise from the y axis [rad], -3.1416 to 3.1416.
        epsilon: elevation, up from the horizontal plane [rad], -1.5708 to 1.5708.
        sigma_r: standard deviation of the error of r [m], 0.001 to 10000.
        sigma_beta: standard deviation of the error of beta [rad], 1e-09 to 1.
        sigma_epsilon: standard deviation of the error of epsilon [rad], 1e-09 to 1.
        rho: correlation of the errors of r and beta [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (3), unit m.

    Accuracy: at most 23.6 ulp anywhere in this domain with independent errors, proved for elementary
    functions within 1 ulp (float64); in float32, with functions within 4 of its ulp, at most 77.5.
    """
    arguments = _floats(r, beta, epsilon, sigma_r, sigma_beta, sigma_epsilon, rho)
    r, beta, epsilon, sigma_r, sigma_beta, sigma_epsilon, rho = arguments
    cos_beta = np.cos(beta)
    sin_beta = np.sin(beta)
    cos_epsilon = np.cos(epsilon)
    sin_epsilon = np.sin(epsilon)
    attenuation_beta = np.exp(-0.5 * sigma_beta**2)
    shortfall_beta = -np.expm1(-0.5 * sigma_beta**2)
    attenuation_epsilon = np.exp(-0.5 * sigma_epsilon**2)
    shortfall_epsilon = -np.expm1(-0.5 * sigma_epsilon**2)
    product_1 = shortfall_beta * shortfall_epsilon
    sum_1 = product_1 - shortfall_beta - shortfall_epsilon
    part_0_cos_epsilon_sin_beta = attenuation_beta * attenuation_epsilon * r * sum_1
    sum_2 = (
        attenuation_beta * attenuation_epsilon
        - attenuation_beta * shortfall_epsilon
        - attenuation_epsilon * shortfall_beta
        - shortfall_beta * shortfall_epsilon
    )
    sum_3 = (
        attenuation_beta * shortfall_epsilon
        - attenuation_beta * attenuation_epsilon
        + attenuation_epsilon * shortfall_beta
        + product_1
    )
    result = _empty(arguments, (3,))
    result[..., 0] = (
        attenuation_beta * attenuation_epsilon * cos_beta * cos_epsilon * rho * sigma_beta * sigma_r * sum_2
        + cos_epsilon * part_0_cos_epsilon_sin_beta * sin_beta
    )
    result[..., 1] = (
        attenuation_beta * attenuation_epsilon * cos_epsilon * rho * sigma_beta * sigma_r * sin_beta * sum_3
        + cos_beta * cos_epsilon * part_0_cos_epsilon_sin_beta
    )
    result[..., 2] = -attenuation_epsilon * r * shortfall_epsilon * sin_epsilon
    return result


def covariance_truth(
    *,
    r: npt.ArrayLike,
    beta: npt.ArrayLike,
    epsilon: npt.ArrayLike,
    sigma_r: npt.ArrayLike,
    sigma_beta: npt.ArrayLike,
    sigma_epsilon: npt.ArrayLike,
    rho: npt.ArrayLike,
) -> Floats:
    """Exact covariance of the plain conversion h(z).

    Name: spherical.covariance.truth.
    Definition: C = e^L(h h') - (e^L h)(e^L h)'.
    Conditioning: truth-conditioned: the measured symbols stand for the true values.
    Source: Lerro & Bar-Shalom 1993, doi:10.1109/7.220948.

    Args:
        r: range [m], 1 to 1e+08.
        beta: azimuth, clockwise from the y axis [rad], -3.1416 to 3.1416.
        epsilon: elevation, up from the horizontal plane [rad], -1.5708 to 1.5708.
        sigma_r: standard deviation of the error of r [m], 0.001 to 10000.
        sigma_beta: standard deviation of the error of beta [rad], 1e-09 to 1.
        sigma_epsilon: standard deviation of the error of epsilon [rad], 1e-09 to 1.
        rho: correlation of the errors of r and beta [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (3, 3), unit m^2.

    Accuracy: at most 106 ulp anywhere in this domain with independent errors, proved for elementary functions
    within 1 ulp (float64).
    """
    arguments = _floats(r, beta, epsilon, sigma_r, sigma_beta, sigma_epsilon, rho)
    r, beta, epsilon, sigma_r, sigma_beta, sigma_epsilon, rho = arguments
    cos_beta = np.cos(beta)
    sin_beta = np.sin(beta)
    cos_epsilon = np.cos(epsilon)
    sin_epsilon = np.sin(epsilon)
    sigma_beta_squared = sigma_beta**2
    attenuation_beta = np.exp(-0.5 * sigma_beta_squared)
    shortfall_beta = -np.expm1(-0.5 * sigma_beta_squared)
    attenuation_epsilon = np.exp(-sigma_epsilon**2)
    shortfall_epsilon = -np.expm1(-sigma_epsilon**2)
    attenuation_beta_squared = attenuation_beta**2
    attenuation_epsilon_squared = attenuation_epsilon**2
    shortfall_beta_squared = shortfall_beta**2
    shortfall_epsilon_squared = shortfall_epsilon**2
    product_1 = attenuation_beta_squared * shortfall_epsilon_squared
    sum_1 = (
        attenuation_beta_squared * attenuation_epsilon * shortfall_epsilon
        - 2.0 * attenuation_beta * attenuation_epsilon * shortfall_beta * shortfall_epsilon
        - 2.0 * attenuation_beta * attenuation_epsilon_squared * shortfall_beta
        - attenuation_epsilon * shortfall_beta_squared * shortfall_epsilon
        - attenuation_epsilon_squared * shortfall_beta_squared
        + attenuation_beta_squared * attenuation_epsilon_squared
        + product_1
    )
    rho_squared = rho**2
    sigma_r_squared = sigma_r**2
    sum_2 = 1.0 + attenuation_beta
    sum_3 = 1.0 + attenuation_beta_squared
    sum_4 = 1.0 + attenuation_epsilon_squared
    r_squared = r**2
    part_00_cos_beta2_cos_epsilon2 = (
        attenuation_beta_squared * rho_squared * sigma_beta_squared * sigma_r_squared * sum_1
        + 0.25 * r_squared * shortfall_beta * sum_2 * sum_3 * sum_4
        + 0.25 * shortfall_beta * sigma_r_squared * sum_2 * sum_3 * sum_4
    )
    attenuation_beta_squared_squared = attenuation_beta_squared**2
    sum_5 = 1.0 + attenuation_epsilon
    part_00_cos_beta2_sin_epsilon2 = (
        attenuation_beta_squared_squared * rho_squared * shortfall_epsilon * sigma_beta_squared * sigma_r_squared * sum_5
        + 0.25 * r_squared * shortfall_beta * shortfall_epsilon * sum_2 * sum_3 * sum_5
        + 0.25 * shortfall_beta * shortfall_epsilon * sigma_r_squared * sum_2 * sum_3 * sum_5
    )
    sum_6 = -1.0 - attenuation_epsilon_squared
    product_2 = shortfall_beta * shortfall_beta_squared
    shortfall_beta_squared_squared = shortfall_beta_squared**2
    sum_7 = (
        2.0 * attenuation_beta * attenuation_epsilon * product_2 * shortfall_epsilon
        + 2.0 * attenuation_beta * attenuation_epsilon_squared * product_2
        + 2.0 * attenuation_beta_squared * attenuation_epsilon * shortfall_beta_squared * shortfall_epsilon
        + 2.0 * attenuation_beta_squared * attenuation_epsilon_squared * shortfall_beta_squared
        + 1.5 * attenuation_beta_squared * shortfall_beta_squared * shortfall_epsilon_squared
        + attenuation_beta * attenuation_beta_squared * shortfall_beta * shortfall_epsilon_squared
        + attenuation_beta * product_2 * shortfall_epsilon_squared
        + 0.5 * attenuation_beta_squared_squared * shortfall_epsilon_squared
        + 0.5 * attenuation_epsilon * shortfall_beta_squared_squared * shortfall_epsilon
        + 0.5 * attenuation_epsilon_squared * shortfall_beta_squared_squared
        + 0.25 * shortfall_beta_squared_squared * shortfall_epsilon_squared
    )
    sum_8 = (
        0.25
        + 0.25 * attenuation_beta_squared_squared * attenuation_epsilon_squared
        + 0.25 * attenuation_beta_squared_squared
        + 0.25 * attenuation_epsilon_squared
    )
    part_00_cos_epsilon2_sin_beta2 = (
        attenuation_beta_squared_squared * rho_squared * sigma_beta_squared * sigma_r_squared * sum_6
        + r_squared * sum_7
        + sigma_r_squared * sum_8
    )
    sum_9 = -1.0 - attenuation_epsilon
    sum_10 = (
        1.0
        + attenuation_beta_squared_squared
        + attenuation_beta_squared_squared * attenuation_epsilon
        + attenuation_epsilon
    )
    part_00_sin_beta2_sin_epsilon2 = (
        attenuation_beta_squared_squared * rho_squared * shortfall_epsilon * sigma_beta_squared * sigma_r_squared * sum_9
        + 0.25 * r_squared * shortfall_epsilon * sum_10
        + 0.25 * shortfall_epsilon * sigma_r_squared * sum_10
    )
    sum_11 = (
        product_1
        - 2.0 * attenuation_epsilon * shortfall_beta_squared * shortfall_epsilon
        - 2.0 * attenuation_epsilon_squared * shortfall_beta_squared
        - 4.0 * attenuation_beta * attenuation_epsilon * shortfall_beta * shortfall_epsilon
        - 4.0 * attenuation_beta * attenuation_epsilon_squared * shortfall_beta
    )
    product_3 = 2.0 * attenuation_beta * attenuation_epsilon_squared * shortfall_beta
    product_4 = 2.0 * attenuation_beta * attenuation_epsilon * shortfall_beta * shortfall_epsilon
    product_5 = attenuation_epsilon_squared * shortfall_beta_squared
    product_6 = attenuation_epsilon * shortfall_beta_squared * shortfall_epsilon
    sum_12 = (
        product_3
        - 2.0 * attenuation_beta_squared * shortfall_epsilon_squared
        - 3.0 * attenuation_beta_squared * attenuation_epsilon * shortfall_epsilon
        - 3.0 * attenuation_beta_squared * attenuation_epsilon_squared
        + product_4
        + product_5
        + product_6
    )
    part_01_cos_beta_cos_epsilon2_sin_beta = (
        0.5 * attenuation_beta_squared * r_squared * sum_11
        + attenuation_beta_squared * rho_squared * sigma_beta_squared * sigma_r_squared * sum_12
        + 0.5 * attenuation_beta_squared_squared * sigma_r_squared * sum_4
    )
    part_01_cos_beta_sin_beta_sin_epsilon2 = (
        2.0 * attenuation_beta_squared_squared * rho_squared * shortfall_epsilon * sigma_beta_squared * sigma_r_squared * sum_9
        + 0.5 * attenuation_beta_squared_squared * r_squared * shortfall_epsilon * sum_5
        + 0.5 * attenuation_beta_squared_squared * shortfall_epsilon * sigma_r_squared * sum_5
    )
    part_02_cos_epsilon_sin_beta_sin_epsilon = (
        attenuation_beta * attenuation_epsilon_squared * sigma_r_squared
        - attenuation_beta * attenuation_epsilon * r_squared * shortfall_epsilon
        - attenuation_beta * attenuation_epsilon_squared * rho_squared * sigma_beta_squared * sigma_r_squared
    )
    part_22_cos_epsilon2 = (
        0.5 * r_squared * shortfall_epsilon * sum_5
        + 0.5 * shortfall_epsilon * sigma_r_squared * sum_5
    )
    sum_13 = 0.5 + 0.5 * attenuation_epsilon_squared
    part_22_sin_epsilon2 = 0.5 * r_squared * shortfall_epsilon_squared + sigma_r_squared * sum_13
    cos_epsilon_squared = cos_epsilon**2
    sin_epsilon_squared = sin_epsilon**2
    cos_beta_squared = cos_beta**2
    sin_beta_squared = sin_beta**2
    sum_14 = (
        product_3
        - attenuation_beta_squared * attenuation_epsilon * shortfall_epsilon
        - attenuation_beta_squared * attenuation_epsilon_squared
        - attenuation_beta_squared * shortfall_epsilon_squared
        + product_4
        + product_5
        + product_6
    )
    sum_15 = attenuation_epsilon - shortfall_epsilon
    sum_16 = shortfall_epsilon - attenuation_epsilon
    result = _empty(arguments, (3, 3))
    result[..., 0, 0] = (
        2.0 * attenuation_beta_squared * cos_beta * cos_epsilon_squared * r * rho * sigma_beta * sigma_r * sin_beta * sum_1
        + 2.0 * attenuation_beta_squared_squared * cos_beta * r * rho * shortfall_epsilon * sigma_beta * sigma_r * sin_beta * sin_epsilon_squared * sum_5
        + cos_beta_squared * cos_epsilon_squared * part_00_cos_beta2_cos_epsilon2
        + cos_beta_squared * part_00_cos_beta2_sin_epsilon2 * sin_epsilon_squared
        + cos_epsilon_squared * part_00_cos_epsilon2_sin_beta2 * sin_beta_squared
        + part_00_sin_beta2_sin_epsilon2 * sin_beta_squared * sin_epsilon_squared
    )
    result[..., 0, 1] = (
        attenuation_beta_squared * cos_beta_squared * cos_epsilon_squared * r * rho * sigma_beta * sigma_r * sum_1
        + attenuation_beta_squared * cos_epsilon_squared * r * rho * sigma_beta * sigma_r * sin_beta_squared * sum_14
        + attenuation_beta_squared_squared * cos_beta_squared * r * rho * shortfall_epsilon * sigma_beta * sigma_r * sin_epsilon_squared * sum_5
        + attenuation_beta_squared_squared * r * rho * shortfall_epsilon * sigma_beta * sigma_r * sin_beta_squared * sin_epsilon_squared * sum_9
        + cos_beta * cos_epsilon_squared * part_01_cos_beta_cos_epsilon2_sin_beta * sin_beta
        + cos_beta * part_01_cos_beta_sin_beta_sin_epsilon2 * sin_beta * sin_epsilon_squared
    )
    result[..., 0, 2] = (
        attenuation_beta * attenuation_epsilon * cos_beta * cos_epsilon * r * rho * sigma_beta * sigma_r * sin_epsilon * sum_15
        + cos_epsilon * part_02_cos_epsilon_sin_beta_sin_epsilon * sin_beta * sin_epsilon
    )
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = (
        2.0 * attenuation_beta_squared * cos_beta * cos_epsilon_squared * r * rho * sigma_beta * sigma_r * sin_beta * sum_14
        + 2.0 * attenuation_beta_squared_squared * cos_beta * r * rho * shortfall_epsilon * sigma_beta * sigma_r * sin_beta * sin_epsilon_squared * sum_9
        + cos_beta_squared * cos_epsilon_squared * part_00_cos_epsilon2_sin_beta2
        + cos_beta_squared * part_00_sin_beta2_sin_epsilon2 * sin_epsilon_squared
        + cos_epsilon_squared * part_00_cos_beta2_cos_epsilon2 * sin_beta_squared
        + part_00_cos_beta2_sin_epsilon2 * sin_beta_squared * sin_epsilon_squared
    )
    result[..., 1, 2] = (
        attenuation_beta * attenuation_epsilon * cos_epsilon * r * rho * sigma_beta * sigma_r * sin_beta * sin_epsilon * sum_16
        + cos_beta * cos_epsilon * part_02_cos_epsilon_sin_beta_sin_epsilon * sin_epsilon
    )
    result[..., 2, 0] = result[..., 0, 2]
    result[..., 2, 1] = result[..., 1, 2]
    result[..., 2, 2] = (
        cos_epsilon_squared * part_22_cos_epsilon2
        + part_22_sin_epsilon2 * sin_epsilon_squared
    )
    return result


def covariance_averaged(
    *,
    r: npt.ArrayLike,
    beta: npt.ArrayLike,
    epsilon: npt.ArrayLike,
    sigma_r: npt.ArrayLike,
    sigma_beta: npt.ArrayLike,
    sigma_epsilon: npt.ArrayLike,
    rho: npt.ArrayLike,
) -> Floats:
    """Exact covariance of the plain conversion, averaged over the truth.

    Name: spherical.covariance.averaged.
    Definition: e^L C.
    Conditioning: measurement-conditioned: the measured symbols stand for the measurement.
    Source: Lerro & Bar-Shalom 1993; Prosov (11), doi:10.1109/7.220948.

    Args:
        r: range [m], 1 to 1e+08.
        beta: azimuth, clockwise from the y axis [rad], -3.1416 to 3.1416.
        epsilon: elevation, up from the horizontal plane [rad], -1.5708 to 1.5708.
        sigma_r: standard deviation of the error of r [m], 0.001 to 10000.
        sigma_beta: standard deviation of the error of beta [rad], 1e-09 to 1.
        sigma_epsilon: standard deviation of the error of epsilon [rad], 1e-09 to 1.
        rho: correlation of the errors of r and beta [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (3, 3), unit m^2.

    Accuracy: at most 700 ulp anywhere in this domain with independent errors, proved for elementary functions
    within 1 ulp (float64).
    """
    arguments = _floats(r, beta, epsilon, sigma_r, sigma_beta, sigma_epsilon, rho)
    r, beta, epsilon, sigma_r, sigma_beta, sigma_epsilon, rho = arguments
    cos_beta = np.cos(beta)
    sin_beta = np.sin(beta)
    cos_epsilon = np.cos(epsilon)
    sin_epsilon = np.sin(epsilon)
    sigma_beta_squared = sigma_beta**2
    attenuation_beta = np.exp(-sigma_beta_squared)
    shortfall_beta = -np.expm1(-sigma_beta_squared)
    attenuation_epsilon = np.exp(-sigma_epsilon**2)
    shortfall_epsilon = -np.expm1(-sigma_epsilon**2)
    attenuation_beta_squared = attenuation_beta**2
    shortfall_epsilon_squared = shortfall_epsilon**2
    product_1 = shortfall_epsilon * shortfall_epsilon_squared
    attenuation_epsilon_squared = attenuation_epsilon**2
    product_2 = attenuation_epsilon * attenuation_epsilon_squared
    shortfall_beta_squared = shortfall_beta**2
    product_3 = -12.0 * attenuation_beta * product_2 * shortfall_beta_squared * shortfall_epsilon
    attenuation_epsilon_squared_squared = attenuation_epsilon_squared**2
    product_4 = shortfall_beta * shortfall_beta_squared
    product_5 = -2.0 * attenuation_epsilon_squared_squared * product_4
    product_6 = -3.0 * attenuation_beta * attenuation_epsilon * product_1 * shortfall_beta_squared
    product_7 = -3.0 * attenuation_epsilon_squared * product_4 * shortfall_epsilon_squared
    product_8 = -4.0 * product_2 * product_4 * shortfall_epsilon
    product_9 = -6.0 * attenuation_beta * attenuation_epsilon_squared_squared * shortfall_beta_squared
    product_10 = -9.0 * attenuation_beta * attenuation_epsilon_squared * shortfall_beta_squared * shortfall_epsilon_squared
    product_11 = -attenuation_epsilon * product_1 * product_4
    product_12 = attenuation_beta * attenuation_beta_squared
    shortfall_epsilon_squared_squared = shortfall_epsilon_squared**2
    rho_squared = rho**2
    sigma_r_squared = sigma_r**2
    sum_1 = (
        12.0 * attenuation_epsilon_squared_squared * product_12
        - 12.0 * attenuation_beta_squared * attenuation_epsilon * product_1 * shortfall_beta
        - 24.0 * attenuation_beta_squared * attenuation_epsilon_squared_squared * shortfall_beta
        - 36.0 * attenuation_beta_squared * attenuation_epsilon_squared * shortfall_beta * shortfall_epsilon_squared
        - 48.0 * attenuation_beta_squared * product_2 * shortfall_beta * shortfall_epsilon
        + 16.0 * product_12 * shortfall_epsilon_squared_squared
        + 24.0 * product_12 * product_2 * shortfall_epsilon
        + 54.0 * attenuation_epsilon * product_1 * product_12
        + 66.0 * attenuation_epsilon_squared * product_12 * shortfall_epsilon_squared
        + product_10
        + product_11
        + product_3
        + product_5
        + product_6
        + product_7
        + product_8
        + product_9
    )
    sum_2 = 1.0 + attenuation_beta
    product_13 = -attenuation_beta * attenuation_epsilon
    product_14 = -attenuation_beta * product_2
    r_squared = r**2
    sum_3 = (
        1.0
        + attenuation_beta_squared
        + attenuation_beta_squared * attenuation_epsilon_squared_squared
        + attenuation_epsilon_squared_squared
        + product_13
        + product_14
    )
    sum_4 = (
        2.0
        + 2.0 * attenuation_beta_squared
        + 2.0 * attenuation_beta_squared * attenuation_epsilon_squared_squared
        + 2.0 * attenuation_epsilon_squared_squared
        + product_13
        + product_14
    )
    part_00_cos_beta2_cos_epsilon2 = (
        0.25 * attenuation_beta * rho_squared * sigma_beta_squared * sigma_r_squared * sum_1
        + 0.25 * r_squared * shortfall_beta * sum_2 * sum_3
        + 0.25 * shortfall_beta * sigma_r_squared * sum_2 * sum_4
    )
    sum_5 = 1.0 + attenuation_epsilon
    sum_6 = (
        16.0 * product_12 * shortfall_epsilon_squared
        - 12.0 * attenuation_beta_squared * attenuation_epsilon * shortfall_beta * shortfall_epsilon
        - 12.0 * attenuation_beta_squared * attenuation_epsilon_squared * shortfall_beta
        - 3.0 * attenuation_beta * attenuation_epsilon * shortfall_beta_squared * shortfall_epsilon
        - 3.0 * attenuation_beta * attenuation_epsilon_squared * shortfall_beta_squared
        - attenuation_epsilon * product_4 * shortfall_epsilon
        - attenuation_epsilon_squared * product_4
        + 22.0 * attenuation_epsilon * product_12 * shortfall_epsilon
        + 22.0 * attenuation_epsilon_squared * product_12
    )
    sum_7 = (
        1.0
        + attenuation_beta_squared
        + attenuation_beta_squared * attenuation_epsilon_squared
        + attenuation_epsilon_squared
        + product_13
    )
    sum_8 = (
        2.0
        + 2.0 * attenuation_beta_squared
        + 2.0 * attenuation_beta_squared * attenuation_epsilon_squared
        + 2.0 * attenuation_epsilon_squared
        + product_13
    )
    part_00_cos_beta2_sin_epsilon2 = (
        0.25 * attenuation_beta * rho_squared * shortfall_epsilon * sigma_beta_squared * sigma_r_squared * sum_5 * sum_6
        + 0.25 * r_squared * shortfall_beta * shortfall_epsilon * sum_2 * sum_5 * sum_7
        + 0.25 * shortfall_beta * shortfall_epsilon * sigma_r_squared * sum_2 * sum_5 * sum_8
    )
    sum_9 = (
        12.0 * attenuation_beta_squared * attenuation_epsilon_squared_squared * shortfall_beta
        - 16.0 * attenuation_epsilon_squared_squared * product_12
        - 16.0 * product_12 * shortfall_epsilon_squared_squared
        - 32.0 * product_12 * product_2 * shortfall_epsilon
        - 56.0 * attenuation_epsilon * product_1 * product_12
        - 72.0 * attenuation_epsilon_squared * product_12 * shortfall_epsilon_squared
        + 18.0 * attenuation_beta_squared * attenuation_epsilon_squared * shortfall_beta * shortfall_epsilon_squared
        + 24.0 * attenuation_beta_squared * product_2 * shortfall_beta * shortfall_epsilon
        + 6.0 * attenuation_beta_squared * attenuation_epsilon * product_1 * shortfall_beta
        + product_10
        + product_11
        + product_3
        + product_5
        + product_6
        + product_7
        + product_8
        + product_9
    )
    attenuation_beta_squared_squared = attenuation_beta_squared**2
    shortfall_beta_squared_squared = shortfall_beta_squared**2
    sum_10 = (
        3.75 * attenuation_beta * attenuation_epsilon * product_1 * product_4
        + 5.25 * attenuation_beta * attenuation_epsilon_squared * product_4 * shortfall_epsilon_squared
        + 5.25 * attenuation_beta_squared * attenuation_epsilon * product_1 * shortfall_beta_squared
        + 6.75 * attenuation_beta_squared * attenuation_epsilon_squared * shortfall_beta_squared * shortfall_epsilon_squared
        + 1.5 * attenuation_beta * attenuation_epsilon_squared_squared * product_4
        + 3.0 * attenuation_beta * product_2 * product_4 * shortfall_epsilon
        + 1.5 * attenuation_beta_squared * attenuation_epsilon_squared_squared * shortfall_beta_squared
        + 3.0 * attenuation_beta_squared * product_2 * shortfall_beta_squared * shortfall_epsilon
        + 1.5 * attenuation_beta_squared * shortfall_beta_squared * shortfall_epsilon_squared_squared
        + 1.5 * attenuation_beta_squared_squared * attenuation_epsilon * product_1
        + 1.5 * attenuation_beta_squared_squared * attenuation_epsilon_squared * shortfall_epsilon_squared
        + 3.0 * attenuation_epsilon * product_1 * product_12 * shortfall_beta
        + 3.0 * attenuation_epsilon_squared * product_12 * shortfall_beta * shortfall_epsilon_squared
        + 1.5 * attenuation_epsilon_squared * shortfall_beta_squared_squared * shortfall_epsilon_squared
        + attenuation_beta * product_4 * shortfall_epsilon_squared_squared
        + 0.5 * attenuation_beta_squared_squared * shortfall_epsilon_squared_squared
        + attenuation_epsilon * product_1 * shortfall_beta_squared_squared
        + 0.5 * attenuation_epsilon_squared_squared * shortfall_beta_squared_squared
        + product_12 * shortfall_beta * shortfall_epsilon_squared_squared
        + product_2 * shortfall_beta_squared_squared * shortfall_epsilon
        + 0.25 * shortfall_beta_squared_squared * shortfall_epsilon_squared_squared
    )
    sum_11 = (
        0.5
        - 0.25 * attenuation_beta * attenuation_epsilon
        - 0.25 * attenuation_beta * product_2
        - 0.25 * attenuation_epsilon * product_12
        - 0.25 * product_12 * product_2
        + 0.5 * attenuation_beta_squared_squared * attenuation_epsilon_squared_squared
        + 0.5 * attenuation_beta_squared_squared
        + 0.5 * attenuation_epsilon_squared_squared
    )
    part_00_cos_epsilon2_sin_beta2 = (
        0.25 * attenuation_beta * rho_squared * sigma_beta_squared * sigma_r_squared * sum_9
        + r_squared * sum_10
        + sigma_r_squared * sum_11
    )
    sum_12 = (
        16.0 * attenuation_epsilon_squared * product_12
        - 9.0 * attenuation_beta_squared * attenuation_epsilon
        + 16.0 * product_12
        + attenuation_epsilon
    )
    product_15 = -attenuation_epsilon * product_12
    sum_13 = (
        1.0
        + attenuation_beta_squared_squared
        + attenuation_beta_squared_squared * attenuation_epsilon_squared
        + attenuation_epsilon_squared
        + product_13
        + product_15
    )
    sum_14 = (
        2.0
        + 2.0 * attenuation_beta_squared_squared
        + 2.0 * attenuation_beta_squared_squared * attenuation_epsilon_squared
        + 2.0 * attenuation_epsilon_squared
        + product_13
        + product_15
    )
    part_00_sin_beta2_sin_epsilon2 = (
        0.25 * r_squared * shortfall_epsilon * sum_13 * sum_5
        - 0.25 * attenuation_beta * rho_squared * shortfall_epsilon * sigma_beta_squared * sigma_r_squared * sum_12 * sum_5
        + 0.25 * shortfall_epsilon * sigma_r_squared * sum_14 * sum_5
    )
    product_16 = -2.0 * attenuation_epsilon_squared_squared * shortfall_beta
    product_17 = -3.0 * attenuation_epsilon_squared * shortfall_beta * shortfall_epsilon_squared
    product_18 = -4.0 * product_2 * shortfall_beta * shortfall_epsilon
    product_19 = -attenuation_epsilon * product_1 * shortfall_beta
    sum_15 = (
        3.0 * attenuation_beta * attenuation_epsilon * product_1
        + 3.0 * attenuation_beta * attenuation_epsilon_squared * shortfall_epsilon_squared
        + attenuation_beta * shortfall_epsilon_squared_squared
        + product_16
        + product_17
        + product_18
        + product_19
    )
    sum_16 = (
        18.0 * attenuation_epsilon_squared_squared * shortfall_beta
        - 14.0 * attenuation_beta * attenuation_epsilon_squared_squared
        - 16.0 * attenuation_beta * shortfall_epsilon_squared_squared
        - 28.0 * attenuation_beta * product_2 * shortfall_epsilon
        - 55.0 * attenuation_beta * attenuation_epsilon * product_1
        - 69.0 * attenuation_beta * attenuation_epsilon_squared * shortfall_epsilon_squared
        + 27.0 * attenuation_epsilon_squared * shortfall_beta * shortfall_epsilon_squared
        + 36.0 * product_2 * shortfall_beta * shortfall_epsilon
        + 9.0 * attenuation_epsilon * product_1 * shortfall_beta
    )
    product_20 = 2.0 * attenuation_beta * attenuation_epsilon_squared_squared
    product_21 = 4.0 * attenuation_beta * product_2 * shortfall_epsilon
    sum_17 = (
        2.0 * attenuation_beta * shortfall_epsilon_squared_squared
        + 7.0 * attenuation_beta * attenuation_epsilon * product_1
        + 9.0 * attenuation_beta * attenuation_epsilon_squared * shortfall_epsilon_squared
        + product_16
        + product_17
        + product_18
        + product_19
        + product_20
        + product_21
    )
    part_01_cos_beta_cos_epsilon2_sin_beta = (
        0.5 * product_12 * r_squared * sum_15
        + 0.5 * product_12 * rho_squared * sigma_beta_squared * sigma_r_squared * sum_16
        + 0.5 * product_12 * sigma_r_squared * sum_17
    )
    product_22 = -2.0 * product_2 * shortfall_beta
    product_23 = -3.0 * attenuation_epsilon_squared * shortfall_beta * shortfall_epsilon
    product_24 = -attenuation_epsilon * shortfall_beta * shortfall_epsilon_squared
    sum_18 = (
        2.0 * attenuation_beta * product_2
        + 3.0 * attenuation_beta * attenuation_epsilon * shortfall_epsilon_squared
        + 3.0 * attenuation_beta * attenuation_epsilon_squared * shortfall_epsilon
        + attenuation_beta * product_1
        + product_22
        + product_23
        + product_24
    )
    sum_19 = (
        18.0 * product_2 * shortfall_beta
        - 16.0 * attenuation_beta * product_1
        - 46.0 * attenuation_beta * product_2
        - 55.0 * attenuation_beta * attenuation_epsilon * shortfall_epsilon_squared
        - 69.0 * attenuation_beta * attenuation_epsilon_squared * shortfall_epsilon
        + 27.0 * attenuation_epsilon_squared * shortfall_beta * shortfall_epsilon
        + 9.0 * attenuation_epsilon * shortfall_beta * shortfall_epsilon_squared
    )
    sum_20 = (
        2.0 * attenuation_beta * product_1
        + 6.0 * attenuation_beta * product_2
        + 7.0 * attenuation_beta * attenuation_epsilon * shortfall_epsilon_squared
        + 9.0 * attenuation_beta * attenuation_epsilon_squared * shortfall_epsilon
        + product_22
        + product_23
        + product_24
    )
    part_01_cos_beta_sin_beta_sin_epsilon2 = (
        0.5 * product_12 * r_squared * shortfall_epsilon * sum_18
        + 0.5 * product_12 * rho_squared * shortfall_epsilon * sigma_beta_squared * sigma_r_squared * sum_19
        + 0.5 * product_12 * shortfall_epsilon * sigma_r_squared * sum_20
    )
    sum_21 = shortfall_epsilon - attenuation_epsilon
    sum_22 = attenuation_epsilon - shortfall_epsilon
    part_02_cos_epsilon_sin_beta_sin_epsilon = (
        2.0 * attenuation_beta * product_2 * rho_squared * sigma_beta_squared * sigma_r_squared * sum_21
        - attenuation_beta * product_2 * r_squared * shortfall_epsilon
        + attenuation_beta * product_2 * sigma_r_squared * sum_22
    )
    sum_23 = 2.0 + 2.0 * product_2 + attenuation_epsilon + attenuation_epsilon_squared
    part_22_cos_epsilon2 = (
        0.5 * (1.0 + product_2) * r_squared * shortfall_epsilon
        + 0.5 * shortfall_epsilon * sigma_r_squared * sum_23
    )
    sum_24 = 1.0 + attenuation_epsilon + attenuation_epsilon_squared
    sum_25 = 1.0 - 0.5 * attenuation_epsilon - 0.5 * product_2 + attenuation_epsilon_squared_squared
    part_22_sin_epsilon2 = 0.5 * r_squared * shortfall_epsilon_squared * sum_24 + sigma_r_squared * sum_25
    sum_26 = (
        13.0 * attenuation_beta * attenuation_epsilon * product_1
        - 12.0 * product_2 * shortfall_beta * shortfall_epsilon
        - 3.0 * attenuation_epsilon * product_1 * shortfall_beta
        - 6.0 * attenuation_epsilon_squared_squared * shortfall_beta
        - 9.0 * attenuation_epsilon_squared * shortfall_beta * shortfall_epsilon_squared
        + 15.0 * attenuation_beta * attenuation_epsilon_squared * shortfall_epsilon_squared
        + 4.0 * attenuation_beta * shortfall_epsilon_squared_squared
        + product_20
        + product_21
    )
    cos_epsilon_squared = cos_epsilon**2
    sum_27 = (
        10.0 * attenuation_beta * product_2
        - 3.0 * attenuation_epsilon * shortfall_beta * shortfall_epsilon_squared
        - 6.0 * product_2 * shortfall_beta
        - 9.0 * attenuation_epsilon_squared * shortfall_beta * shortfall_epsilon
        + 13.0 * attenuation_beta * attenuation_epsilon * shortfall_epsilon_squared
        + 15.0 * attenuation_beta * attenuation_epsilon_squared * shortfall_epsilon
        + 4.0 * attenuation_beta * product_1
    )
    sin_epsilon_squared = sin_epsilon**2
    cos_beta_squared = cos_beta**2
    sin_beta_squared = sin_beta**2
    sum_28 = (
        12.0 * product_2 * shortfall_beta * shortfall_epsilon
        - 13.0 * attenuation_beta * attenuation_epsilon * product_1
        - 15.0 * attenuation_beta * attenuation_epsilon_squared * shortfall_epsilon_squared
        - 2.0 * attenuation_beta * attenuation_epsilon_squared_squared
        - 4.0 * attenuation_beta * product_2 * shortfall_epsilon
        - 4.0 * attenuation_beta * shortfall_epsilon_squared_squared
        + 3.0 * attenuation_epsilon * product_1 * shortfall_beta
        + 6.0 * attenuation_epsilon_squared_squared * shortfall_beta
        + 9.0 * attenuation_epsilon_squared * shortfall_beta * shortfall_epsilon_squared
    )
    sum_29 = (
        3.0 * attenuation_epsilon * shortfall_beta * shortfall_epsilon_squared
        - 10.0 * attenuation_beta * product_2
        - 13.0 * attenuation_beta * attenuation_epsilon * shortfall_epsilon_squared
        - 15.0 * attenuation_beta * attenuation_epsilon_squared * shortfall_epsilon
        - 4.0 * attenuation_beta * product_1
        + 6.0 * product_2 * shortfall_beta
        + 9.0 * attenuation_epsilon_squared * shortfall_beta * shortfall_epsilon
    )
    sum_30 = attenuation_epsilon - 3.0 * shortfall_epsilon
    sum_31 = 3.0 * shortfall_epsilon - attenuation_epsilon
    result = _empty(arguments, (3, 3))
    result[..., 0, 0] = (
        cos_beta * cos_epsilon_squared * product_12 * r * rho * sigma_beta * sigma_r * sin_beta * sum_26
        + cos_beta * product_12 * r * rho * shortfall_epsilon * sigma_beta * sigma_r * sin_beta * sin_epsilon_squared * sum_27
        + cos_beta_squared * cos_epsilon_squared * part_00_cos_beta2_cos_epsilon2
        + cos_beta_squared * part_00_cos_beta2_sin_epsilon2 * sin_epsilon_squared
        + cos_epsilon_squared * part_00_cos_epsilon2_sin_beta2 * sin_beta_squared
        + part_00_sin_beta2_sin_epsilon2 * sin_beta_squared * sin_epsilon_squared
    )
    result[..., 0, 1] = (
        cos_beta * cos_epsilon_squared * part_01_cos_beta_cos_epsilon2_sin_beta * sin_beta
        + cos_beta * part_01_cos_beta_sin_beta_sin_epsilon2 * sin_beta * sin_epsilon_squared
        + 0.5 * cos_beta_squared * cos_epsilon_squared * product_12 * r * rho * sigma_beta * sigma_r * sum_26
        + 0.5 * cos_beta_squared * product_12 * r * rho * shortfall_epsilon * sigma_beta * sigma_r * sin_epsilon_squared * sum_27
        + 0.5 * cos_epsilon_squared * product_12 * r * rho * sigma_beta * sigma_r * sin_beta_squared * sum_28
        + 0.5 * product_12 * r * rho * shortfall_epsilon * sigma_beta * sigma_r * sin_beta_squared * sin_epsilon_squared * sum_29
    )
    result[..., 0, 2] = (
        attenuation_beta * cos_beta * cos_epsilon * product_2 * r * rho * sigma_beta * sigma_r * sin_epsilon * sum_30
        + cos_epsilon * part_02_cos_epsilon_sin_beta_sin_epsilon * sin_beta * sin_epsilon
    )
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = (
        cos_beta * cos_epsilon_squared * product_12 * r * rho * sigma_beta * sigma_r * sin_beta * sum_28
        + cos_beta * product_12 * r * rho * shortfall_epsilon * sigma_beta * sigma_r * sin_beta * sin_epsilon_squared * sum_29
        + cos_beta_squared * cos_epsilon_squared * part_00_cos_epsilon2_sin_beta2
        + cos_beta_squared * part_00_sin_beta2_sin_epsilon2 * sin_epsilon_squared
        + cos_epsilon_squared * part_00_cos_beta2_cos_epsilon2 * sin_beta_squared
        + part_00_cos_beta2_sin_epsilon2 * sin_beta_squared * sin_epsilon_squared
    )
    result[..., 1, 2] = (
        attenuation_beta * cos_epsilon * product_2 * r * rho * sigma_beta * sigma_r * sin_beta * sin_epsilon * sum_31
        + cos_beta * cos_epsilon * part_02_cos_epsilon_sin_beta_sin_epsilon * sin_epsilon
    )
    result[..., 2, 0] = result[..., 0, 2]
    result[..., 2, 1] = result[..., 1, 2]
    result[..., 2, 2] = (
        cos_epsilon_squared * part_22_cos_epsilon2
        + part_22_sin_epsilon2 * sin_epsilon_squared
    )
    return result


def unbiased_estimate(
    *,
    r: npt.ArrayLike,
    beta: npt.ArrayLike,
    epsilon: npt.ArrayLike,
    sigma_r: npt.ArrayLike,
    sigma_beta: npt.ArrayLike,
    sigma_epsilon: npt.ArrayLike,
    rho: npt.ArrayLike,
) -> Floats:
    """Exactly unbiased estimate of the position.

    Name: spherical.unbiased.estimate.
    Definition: u = e^-L h.
    Conditioning: measurement-conditioned: the measured symbols stand for the measurement.
    Source: Mo et al. 1998, doi:10.1109/7.705921.

    Args:
        r: range [m], 1 to 1e+08.
        beta: azimuth, clockwise from the y axis [rad], -3.1416 to 3.1416.
        epsilon: elevation, up from the horizontal plane [rad], -1.5708 to 1.5708.
        sigma_r: standard deviation of the error of r [m], 0.001 to 10000.
        sigma_beta: standard deviation of the error of beta [rad], 1e-09 to 1.
        sigma_epsilon: standard deviation of the error of epsilon [rad], 1e-09 to 1.
        rho: correlation of the errors of r and beta [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (3), unit m.

    Accuracy: at most 16.1 ulp anywhere in this domain with independent errors, proved for elementary
    functions within 1 ulp (float64); with correlations up to 0.99 in size at most 26.5; in float32, with
    functions within 4 of its ulp, at most 177.
    """
    arguments = _floats(r, beta, epsilon, sigma_r, sigma_beta, sigma_epsilon, rho)
    r, beta, epsilon, sigma_r, sigma_beta, sigma_epsilon, rho = arguments
    cos_beta = np.cos(beta)
    sin_beta = np.sin(beta)
    cos_epsilon = np.cos(epsilon)
    sin_epsilon = np.sin(epsilon)
    attenuation_beta = np.exp(-0.5 * sigma_beta**2)
    attenuation_epsilon = np.exp(-0.5 * sigma_epsilon**2)
    term_1 = 1.0 / attenuation_beta
    term_2 = 1.0 / attenuation_epsilon
    part_0_cos_beta_cos_epsilon = -rho * sigma_beta * sigma_r * term_1 * term_2
    part_0_cos_epsilon_sin_beta = r * term_1 * term_2
    result = _empty(arguments, (3,))
    result[..., 0] = (
        cos_beta * cos_epsilon * part_0_cos_beta_cos_epsilon
        + cos_epsilon * part_0_cos_epsilon_sin_beta * sin_beta
    )
    result[..., 1] = (
        cos_beta * cos_epsilon * part_0_cos_epsilon_sin_beta
        - cos_epsilon * part_0_cos_beta_cos_epsilon * sin_beta
    )
    result[..., 2] = r * sin_epsilon * term_2
    return result


def unbiased_covariance(
    *,
    r: npt.ArrayLike,
    beta: npt.ArrayLike,
    epsilon: npt.ArrayLike,
    sigma_r: npt.ArrayLike,
    sigma_beta: npt.ArrayLike,
    sigma_epsilon: npt.ArrayLike,
    rho: npt.ArrayLike,
) -> Floats:
    """Error covariance of the unbiased estimate u.

    Name: spherical.unbiased.covariance.
    Definition: u u' - u (e^L h)' - (e^L h) u' + e^L(h h').
    Conditioning: measurement-conditioned: the measured symbols stand for the measurement.
    Source: Mo et al. 1998, doi:10.1109/7.705921.

    Args:
        r: range [m], 1 to 1e+08.
        beta: azimuth, clockwise from the y axis [rad], -3.1416 to 3.1416.
        epsilon: elevation, up from the horizontal plane [rad], -1.5708 to 1.5708.
        sigma_r: standard deviation of the error of r [m], 0.001 to 10000.
        sigma_beta: standard deviation of the error of beta [rad], 1e-09 to 1.
        sigma_epsilon: standard deviation of the error of epsilon [rad], 1e-09 to 1.
        rho: correlation of the errors of r and beta [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (3, 3), unit m^2.

    Accuracy: at most 215 ulp anywhere in this domain with independent errors, proved for elementary functions
    within 1 ulp (float64).
    """
    arguments = _floats(r, beta, epsilon, sigma_r, sigma_beta, sigma_epsilon, rho)
    r, beta, epsilon, sigma_r, sigma_beta, sigma_epsilon, rho = arguments
    cos_beta = np.cos(beta)
    sin_beta = np.sin(beta)
    cos_epsilon = np.cos(epsilon)
    sin_epsilon = np.sin(epsilon)
    sigma_beta_squared = sigma_beta**2
    attenuation_beta = np.exp(-0.5 * sigma_beta_squared)
    shortfall_beta = -np.expm1(-0.5 * sigma_beta_squared)
    attenuation_epsilon = np.exp(-sigma_epsilon**2)
    shortfall_epsilon = -np.expm1(-sigma_epsilon**2)
    term_1 = 1.0 / attenuation_epsilon
    term_2 = 1.0 / attenuation_beta**2
    attenuation_beta_squared = attenuation_beta**2
    product_1 = 2.0 * attenuation_beta_squared * attenuation_epsilon
    attenuation_beta_squared_cubed = attenuation_beta_squared * attenuation_beta_squared**2
    attenuation_epsilon_squared = attenuation_epsilon**2
    product_2 = attenuation_epsilon * attenuation_epsilon_squared
    rho_squared = rho**2
    sigma_r_squared = sigma_r**2
    sum_1 = (
        1.0
        + attenuation_beta_squared_cubed * attenuation_epsilon
        + attenuation_beta_squared_cubed * product_2
        + product_1
    )
    sum_2 = 1.0 + attenuation_beta
    sum_3 = 1.0 + attenuation_beta_squared
    sum_4 = 1.0 + attenuation_epsilon_squared
    r_squared = r**2
    part_00_cos_beta2_cos_epsilon2 = (
        0.25 * r_squared * shortfall_beta * sum_2 * sum_3 * sum_4
        + rho_squared * sigma_beta_squared * sigma_r_squared * sum_1 * term_1 * term_2
        + 0.25 * shortfall_beta * sigma_r_squared * sum_2 * sum_3 * sum_4
    )
    attenuation_beta_squared_squared = attenuation_beta_squared**2
    sum_5 = 1.0 + attenuation_epsilon
    part_00_cos_beta2_sin_epsilon2 = (
        attenuation_beta_squared_squared * rho_squared * shortfall_epsilon * sigma_beta_squared * sigma_r_squared * sum_5
        + 0.25 * r_squared * shortfall_beta * shortfall_epsilon * sum_2 * sum_3 * sum_5
        + 0.25 * shortfall_beta * shortfall_epsilon * sigma_r_squared * sum_2 * sum_3 * sum_5
    )
    sum_6 = -1.0 - attenuation_epsilon_squared
    shortfall_beta_squared = shortfall_beta**2
    product_3 = attenuation_beta_squared * attenuation_epsilon
    product_4 = attenuation_beta_squared * attenuation_epsilon_squared
    product_5 = attenuation_beta_squared_squared * attenuation_epsilon
    product_6 = attenuation_beta_squared_squared * attenuation_epsilon_squared
    sum_7 = 4.0 + product_3 + product_4 + product_5 + product_6
    sum_8 = 2.0 + attenuation_epsilon
    shortfall_epsilon_squared = shortfall_epsilon**2
    product_7 = 0.5 * shortfall_epsilon_squared * sum_8 * term_1
    sum_9 = (
        product_7
        + 0.25 * shortfall_beta * shortfall_epsilon * sum_2 * sum_7 * term_1 * term_2
        + 0.5 * (2.0 + attenuation_beta_squared) * shortfall_beta_squared * sum_2**2 * term_2
    )
    sum_10 = (
        0.25
        + 0.25 * attenuation_beta_squared_squared * attenuation_epsilon_squared
        + 0.25 * attenuation_beta_squared_squared
        + 0.25 * attenuation_epsilon_squared
    )
    part_00_cos_epsilon2_sin_beta2 = (
        attenuation_beta_squared_squared * rho_squared * sigma_beta_squared * sigma_r_squared * sum_6
        + r_squared * sum_9
        + sigma_r_squared * sum_10
    )
    sum_11 = -1.0 - attenuation_epsilon
    sum_12 = 1.0 + attenuation_beta_squared_squared + attenuation_epsilon + product_5
    part_00_sin_beta2_sin_epsilon2 = (
        attenuation_beta_squared_squared * rho_squared * shortfall_epsilon * sigma_beta_squared * sigma_r_squared * sum_11
        + 0.25 * r_squared * shortfall_epsilon * sum_12
        + 0.25 * shortfall_epsilon * sigma_r_squared * sum_12
    )
    sum_13 = (
        attenuation_beta_squared_squared
        - 2.0 * attenuation_beta * attenuation_beta_squared * shortfall_beta
        - 4.0 * attenuation_beta * shortfall_beta * shortfall_beta_squared
        - 5.0 * attenuation_beta_squared * shortfall_beta_squared
        - shortfall_beta_squared**2
    )
    sum_14 = 2.0 + product_3 + product_4 + product_5 + product_6
    sum_15 = (
        product_7
        - shortfall_beta * sum_13 * sum_2 * term_2
        + 0.5 * shortfall_beta * shortfall_epsilon * sum_14 * sum_2 * term_1 * term_2
    )
    sum_16 = (
        -1.0
        - 2.0 * attenuation_beta_squared * attenuation_epsilon
        - 2.0 * attenuation_beta_squared_cubed * attenuation_epsilon
        - 2.0 * attenuation_beta_squared_cubed * product_2
    )
    part_01_cos_beta_cos_epsilon2_sin_beta = (
        0.5 * attenuation_beta_squared_squared * sigma_r_squared * sum_4
        + r_squared * sum_15
        + rho_squared * sigma_beta_squared * sigma_r_squared * sum_16 * term_1 * term_2
    )
    part_01_cos_beta_sin_beta_sin_epsilon2 = (
        2.0 * attenuation_beta_squared_squared * rho_squared * shortfall_epsilon * sigma_beta_squared * sigma_r_squared * sum_11
        + 0.5 * attenuation_beta_squared_squared * r_squared * shortfall_epsilon * sum_5
        + 0.5 * attenuation_beta_squared_squared * shortfall_epsilon * sigma_r_squared * sum_5
    )
    sum_17 = attenuation_epsilon_squared - attenuation_epsilon * shortfall_epsilon - shortfall_epsilon_squared
    term_3 = 1.0 / attenuation_beta
    sum_18 = 1.0 + attenuation_beta * attenuation_epsilon + attenuation_beta * attenuation_epsilon_squared
    sum_19 = (
        shortfall_beta * shortfall_epsilon * sum_18 * term_1 * term_3
        - shortfall_epsilon * sum_17 * term_1
    )
    part_02_cos_epsilon_sin_beta_sin_epsilon = (
        attenuation_beta * attenuation_epsilon_squared * sigma_r_squared
        - attenuation_beta * attenuation_epsilon_squared * rho_squared * sigma_beta_squared * sigma_r_squared
        + r_squared * sum_19
    )
    part_22_cos_epsilon2 = (
        0.5 * r_squared * shortfall_epsilon * sum_5
        + 0.5 * shortfall_epsilon * sigma_r_squared * sum_5
    )
    sum_20 = 0.5 + 0.5 * attenuation_epsilon_squared
    part_22_sin_epsilon2 = (
        0.5 * r_squared * shortfall_epsilon_squared * sum_8 * term_1
        + sigma_r_squared * sum_20
    )
    sin_epsilon_squared = sin_epsilon**2
    cos_beta_squared = cos_beta**2
    cos_epsilon_squared = cos_epsilon**2
    sum_21 = (
        1.0
        + attenuation_beta_squared * product_2
        + attenuation_beta_squared_squared * product_2
        + product_3
        + product_5
    )
    sum_22 = (
        product_2
        - 2.0 * attenuation_epsilon * shortfall_epsilon_squared
        - attenuation_epsilon_squared * shortfall_epsilon
        - shortfall_epsilon * shortfall_epsilon_squared
    )
    sum_23 = 2.0 * sum_22 * term_1 - 2.0 * shortfall_beta * sum_2 * sum_21 * term_1 * term_2
    sin_beta_squared = sin_beta**2
    sum_24 = sum_22 * term_1 - shortfall_beta * sum_2 * sum_21 * term_1 * term_2
    sum_25 = shortfall_beta * sum_2 * sum_21 * term_1 * term_2 - sum_22 * term_1
    sum_26 = 1.0 + 2.0 * attenuation_beta_squared * attenuation_epsilon_squared + product_1
    sum_27 = attenuation_beta - shortfall_epsilon * sum_26 * term_1 * term_3
    sum_28 = 2.0 * shortfall_beta * sum_2 * sum_21 * term_1 * term_2 - 2.0 * sum_22 * term_1
    sum_29 = shortfall_epsilon * sum_26 * term_1 * term_3 - attenuation_beta
    result = _empty(arguments, (3, 3))
    result[..., 0, 0] = (
        2.0 * attenuation_beta_squared_squared * cos_beta * r * rho * shortfall_epsilon * sigma_beta * sigma_r * sin_beta * sin_epsilon_squared * sum_5
        + cos_beta * cos_epsilon_squared * r * rho * sigma_beta * sigma_r * sin_beta * sum_23
        + cos_beta_squared * cos_epsilon_squared * part_00_cos_beta2_cos_epsilon2
        + cos_beta_squared * part_00_cos_beta2_sin_epsilon2 * sin_epsilon_squared
        + cos_epsilon_squared * part_00_cos_epsilon2_sin_beta2 * sin_beta_squared
        + part_00_sin_beta2_sin_epsilon2 * sin_beta_squared * sin_epsilon_squared
    )
    result[..., 0, 1] = (
        attenuation_beta_squared_squared * cos_beta_squared * r * rho * shortfall_epsilon * sigma_beta * sigma_r * sin_epsilon_squared * sum_5
        + attenuation_beta_squared_squared * r * rho * shortfall_epsilon * sigma_beta * sigma_r * sin_beta_squared * sin_epsilon_squared * sum_11
        + cos_beta * cos_epsilon_squared * part_01_cos_beta_cos_epsilon2_sin_beta * sin_beta
        + cos_beta * part_01_cos_beta_sin_beta_sin_epsilon2 * sin_beta * sin_epsilon_squared
        + cos_beta_squared * cos_epsilon_squared * r * rho * sigma_beta * sigma_r * sum_24
        + cos_epsilon_squared * r * rho * sigma_beta * sigma_r * sin_beta_squared * sum_25
    )
    result[..., 0, 2] = (
        cos_beta * cos_epsilon * r * rho * sigma_beta * sigma_r * sin_epsilon * sum_27
        + cos_epsilon * part_02_cos_epsilon_sin_beta_sin_epsilon * sin_beta * sin_epsilon
    )
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = (
        2.0 * attenuation_beta_squared_squared * cos_beta * r * rho * shortfall_epsilon * sigma_beta * sigma_r * sin_beta * sin_epsilon_squared * sum_11
        + cos_beta * cos_epsilon_squared * r * rho * sigma_beta * sigma_r * sin_beta * sum_28
        + cos_beta_squared * cos_epsilon_squared * part_00_cos_epsilon2_sin_beta2
        + cos_beta_squared * part_00_sin_beta2_sin_epsilon2 * sin_epsilon_squared
        + cos_epsilon_squared * part_00_cos_beta2_cos_epsilon2 * sin_beta_squared
        + part_00_cos_beta2_sin_epsilon2 * sin_beta_squared * sin_epsilon_squared
    )
    result[..., 1, 2] = (
        cos_beta * cos_epsilon * part_02_cos_epsilon_sin_beta_sin_epsilon * sin_epsilon
        + cos_epsilon * r * rho * sigma_beta * sigma_r * sin_beta * sin_epsilon * sum_29
    )
    result[..., 2, 0] = result[..., 0, 2]
    result[..., 2, 1] = result[..., 1, 2]
    result[..., 2, 2] = (
        cos_epsilon_squared * part_22_cos_epsilon2
        + part_22_sin_epsilon2 * sin_epsilon_squared
    )
    return result


def posterior_estimate(
    *,
    r: npt.ArrayLike,
    beta: npt.ArrayLike,
    epsilon: npt.ArrayLike,
    sigma_r: npt.ArrayLike,
    sigma_beta: npt.ArrayLike,
    sigma_epsilon: npt.ArrayLike,
    rho: npt.ArrayLike,
) -> Floats:
    """Posterior mean of the position under a flat prior.

    Name: spherical.posterior.estimate.
    Definition: e^L h.
    Conditioning: measurement-conditioned: the measured symbols stand for the measurement.
    Source: Duan et al. 2004 modified unbiased, doi:10.1109/TAES.2004.1386889.

    Args:
        r: range [m], 1 to 1e+08.
        beta: azimuth, clockwise from the y axis [rad], -3.1416 to 3.1416.
        epsilon: elevation, up from the horizontal plane [rad], -1.5708 to 1.5708.
        sigma_r: standard deviation of the error of r [m], 0.001 to 10000.
        sigma_beta: standard deviation of the error of beta [rad], 1e-09 to 1.
        sigma_epsilon: standard deviation of the error of epsilon [rad], 1e-09 to 1.
        rho: correlation of the errors of r and beta [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (3), unit m.

    Accuracy: at most 14.1 ulp anywhere in this domain with independent errors, proved for elementary
    functions within 1 ulp (float64); with correlations up to 0.99 in size at most 23.4; in float32, with
    functions within 4 of its ulp, at most 150.
    """
    arguments = _floats(r, beta, epsilon, sigma_r, sigma_beta, sigma_epsilon, rho)
    r, beta, epsilon, sigma_r, sigma_beta, sigma_epsilon, rho = arguments
    cos_beta = np.cos(beta)
    sin_beta = np.sin(beta)
    cos_epsilon = np.cos(epsilon)
    sin_epsilon = np.sin(epsilon)
    attenuation_beta = np.exp(-0.5 * sigma_beta**2)
    attenuation_epsilon = np.exp(-0.5 * sigma_epsilon**2)
    part_0_cos_beta_cos_epsilon = attenuation_beta * attenuation_epsilon * rho * sigma_beta * sigma_r
    part_0_cos_epsilon_sin_beta = attenuation_beta * attenuation_epsilon * r
    result = _empty(arguments, (3,))
    result[..., 0] = (
        cos_beta * cos_epsilon * part_0_cos_beta_cos_epsilon
        + cos_epsilon * part_0_cos_epsilon_sin_beta * sin_beta
    )
    result[..., 1] = (
        cos_beta * cos_epsilon * part_0_cos_epsilon_sin_beta
        - cos_epsilon * part_0_cos_beta_cos_epsilon * sin_beta
    )
    result[..., 2] = attenuation_epsilon * r * sin_epsilon
    return result


def posterior_covariance(
    *,
    r: npt.ArrayLike,
    beta: npt.ArrayLike,
    epsilon: npt.ArrayLike,
    sigma_r: npt.ArrayLike,
    sigma_beta: npt.ArrayLike,
    sigma_epsilon: npt.ArrayLike,
    rho: npt.ArrayLike,
) -> Floats:
    """Posterior covariance of the position under a flat prior.

    Name: spherical.posterior.covariance.
    Definition: e^L(h h') - (e^L h)(e^L h)'.
    Conditioning: measurement-conditioned: the measured symbols stand for the measurement.
    Source: Duan et al. 2004 modified unbiased, doi:10.1109/TAES.2004.1386889.

    Args:
        r: range [m], 1 to 1e+08.
        beta: azimuth, clockwise from the y axis [rad], -3.1416 to 3.1416.
        epsilon: elevation, up from the horizontal plane [rad], -1.5708 to 1.5708.
        sigma_r: standard deviation of the error of r [m], 0.001 to 10000.
        sigma_beta: standard deviation of the error of beta [rad], 1e-09 to 1.
        sigma_epsilon: standard deviation of the error of epsilon [rad], 1e-09 to 1.
        rho: correlation of the errors of r and beta [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (3, 3), unit m^2.

    Accuracy: at most 106 ulp anywhere in this domain with independent errors, proved for elementary functions
    within 1 ulp (float64).
    """
    arguments = _floats(r, beta, epsilon, sigma_r, sigma_beta, sigma_epsilon, rho)
    r, beta, epsilon, sigma_r, sigma_beta, sigma_epsilon, rho = arguments
    cos_beta = np.cos(beta)
    sin_beta = np.sin(beta)
    cos_epsilon = np.cos(epsilon)
    sin_epsilon = np.sin(epsilon)
    sigma_beta_squared = sigma_beta**2
    attenuation_beta = np.exp(-0.5 * sigma_beta_squared)
    shortfall_beta = -np.expm1(-0.5 * sigma_beta_squared)
    attenuation_epsilon = np.exp(-sigma_epsilon**2)
    shortfall_epsilon = -np.expm1(-sigma_epsilon**2)
    attenuation_beta_squared = attenuation_beta**2
    attenuation_epsilon_squared = attenuation_epsilon**2
    shortfall_beta_squared = shortfall_beta**2
    shortfall_epsilon_squared = shortfall_epsilon**2
    product_1 = attenuation_beta_squared * shortfall_epsilon_squared
    sum_1 = (
        attenuation_beta_squared * attenuation_epsilon * shortfall_epsilon
        - 2.0 * attenuation_beta * attenuation_epsilon * shortfall_beta * shortfall_epsilon
        - 2.0 * attenuation_beta * attenuation_epsilon_squared * shortfall_beta
        - attenuation_epsilon * shortfall_beta_squared * shortfall_epsilon
        - attenuation_epsilon_squared * shortfall_beta_squared
        + attenuation_beta_squared * attenuation_epsilon_squared
        + product_1
    )
    rho_squared = rho**2
    sigma_r_squared = sigma_r**2
    sum_2 = 1.0 + attenuation_beta
    sum_3 = 1.0 + attenuation_beta_squared
    sum_4 = 1.0 + attenuation_epsilon_squared
    r_squared = r**2
    part_00_cos_beta2_cos_epsilon2 = (
        attenuation_beta_squared * rho_squared * sigma_beta_squared * sigma_r_squared * sum_1
        + 0.25 * r_squared * shortfall_beta * sum_2 * sum_3 * sum_4
        + 0.25 * shortfall_beta * sigma_r_squared * sum_2 * sum_3 * sum_4
    )
    attenuation_beta_squared_squared = attenuation_beta_squared**2
    sum_5 = 1.0 + attenuation_epsilon
    part_00_cos_beta2_sin_epsilon2 = (
        attenuation_beta_squared_squared * rho_squared * shortfall_epsilon * sigma_beta_squared * sigma_r_squared * sum_5
        + 0.25 * r_squared * shortfall_beta * shortfall_epsilon * sum_2 * sum_3 * sum_5
        + 0.25 * shortfall_beta * shortfall_epsilon * sigma_r_squared * sum_2 * sum_3 * sum_5
    )
    sum_6 = -1.0 - attenuation_epsilon_squared
    product_2 = shortfall_beta * shortfall_beta_squared
    shortfall_beta_squared_squared = shortfall_beta_squared**2
    sum_7 = (
        2.0 * attenuation_beta * attenuation_epsilon * product_2 * shortfall_epsilon
        + 2.0 * attenuation_beta * attenuation_epsilon_squared * product_2
        + 2.0 * attenuation_beta_squared * attenuation_epsilon * shortfall_beta_squared * shortfall_epsilon
        + 2.0 * attenuation_beta_squared * attenuation_epsilon_squared * shortfall_beta_squared
        + 1.5 * attenuation_beta_squared * shortfall_beta_squared * shortfall_epsilon_squared
        + attenuation_beta * attenuation_beta_squared * shortfall_beta * shortfall_epsilon_squared
        + attenuation_beta * product_2 * shortfall_epsilon_squared
        + 0.5 * attenuation_beta_squared_squared * shortfall_epsilon_squared
        + 0.5 * attenuation_epsilon * shortfall_beta_squared_squared * shortfall_epsilon
        + 0.5 * attenuation_epsilon_squared * shortfall_beta_squared_squared
        + 0.25 * shortfall_beta_squared_squared * shortfall_epsilon_squared
    )
    sum_8 = (
        0.25
        + 0.25 * attenuation_beta_squared_squared * attenuation_epsilon_squared
        + 0.25 * attenuation_beta_squared_squared
        + 0.25 * attenuation_epsilon_squared
    )
    part_00_cos_epsilon2_sin_beta2 = (
        attenuation_beta_squared_squared * rho_squared * sigma_beta_squared * sigma_r_squared * sum_6
        + r_squared * sum_7
        + sigma_r_squared * sum_8
    )
    sum_9 = -1.0 - attenuation_epsilon
    sum_10 = (
        1.0
        + attenuation_beta_squared_squared
        + attenuation_beta_squared_squared * attenuation_epsilon
        + attenuation_epsilon
    )
    part_00_sin_beta2_sin_epsilon2 = (
        attenuation_beta_squared_squared * rho_squared * shortfall_epsilon * sigma_beta_squared * sigma_r_squared * sum_9
        + 0.25 * r_squared * shortfall_epsilon * sum_10
        + 0.25 * shortfall_epsilon * sigma_r_squared * sum_10
    )
    sum_11 = (
        product_1
        - 2.0 * attenuation_epsilon * shortfall_beta_squared * shortfall_epsilon
        - 2.0 * attenuation_epsilon_squared * shortfall_beta_squared
        - 4.0 * attenuation_beta * attenuation_epsilon * shortfall_beta * shortfall_epsilon
        - 4.0 * attenuation_beta * attenuation_epsilon_squared * shortfall_beta
    )
    product_3 = 2.0 * attenuation_beta * attenuation_epsilon_squared * shortfall_beta
    product_4 = 2.0 * attenuation_beta * attenuation_epsilon * shortfall_beta * shortfall_epsilon
    product_5 = attenuation_epsilon_squared * shortfall_beta_squared
    product_6 = attenuation_epsilon * shortfall_beta_squared * shortfall_epsilon
    sum_12 = (
        product_3
        - 2.0 * attenuation_beta_squared * shortfall_epsilon_squared
        - 3.0 * attenuation_beta_squared * attenuation_epsilon * shortfall_epsilon
        - 3.0 * attenuation_beta_squared * attenuation_epsilon_squared
        + product_4
        + product_5
        + product_6
    )
    part_01_cos_beta_cos_epsilon2_sin_beta = (
        0.5 * attenuation_beta_squared * r_squared * sum_11
        + attenuation_beta_squared * rho_squared * sigma_beta_squared * sigma_r_squared * sum_12
        + 0.5 * attenuation_beta_squared_squared * sigma_r_squared * sum_4
    )
    part_01_cos_beta_sin_beta_sin_epsilon2 = (
        2.0 * attenuation_beta_squared_squared * rho_squared * shortfall_epsilon * sigma_beta_squared * sigma_r_squared * sum_9
        + 0.5 * attenuation_beta_squared_squared * r_squared * shortfall_epsilon * sum_5
        + 0.5 * attenuation_beta_squared_squared * shortfall_epsilon * sigma_r_squared * sum_5
    )
    part_02_cos_epsilon_sin_beta_sin_epsilon = (
        attenuation_beta * attenuation_epsilon_squared * sigma_r_squared
        - attenuation_beta * attenuation_epsilon * r_squared * shortfall_epsilon
        - attenuation_beta * attenuation_epsilon_squared * rho_squared * sigma_beta_squared * sigma_r_squared
    )
    part_22_cos_epsilon2 = (
        0.5 * r_squared * shortfall_epsilon * sum_5
        + 0.5 * shortfall_epsilon * sigma_r_squared * sum_5
    )
    sum_13 = 0.5 + 0.5 * attenuation_epsilon_squared
    part_22_sin_epsilon2 = 0.5 * r_squared * shortfall_epsilon_squared + sigma_r_squared * sum_13
    cos_epsilon_squared = cos_epsilon**2
    sin_epsilon_squared = sin_epsilon**2
    cos_beta_squared = cos_beta**2
    sin_beta_squared = sin_beta**2
    sum_14 = (
        product_3
        - attenuation_beta_squared * attenuation_epsilon * shortfall_epsilon
        - attenuation_beta_squared * attenuation_epsilon_squared
        - attenuation_beta_squared * shortfall_epsilon_squared
        + product_4
        + product_5
        + product_6
    )
    sum_15 = attenuation_epsilon - shortfall_epsilon
    sum_16 = shortfall_epsilon - attenuation_epsilon
    result = _empty(arguments, (3, 3))
    result[..., 0, 0] = (
        2.0 * attenuation_beta_squared * cos_beta * cos_epsilon_squared * r * rho * sigma_beta * sigma_r * sin_beta * sum_1
        + 2.0 * attenuation_beta_squared_squared * cos_beta * r * rho * shortfall_epsilon * sigma_beta * sigma_r * sin_beta * sin_epsilon_squared * sum_5
        + cos_beta_squared * cos_epsilon_squared * part_00_cos_beta2_cos_epsilon2
        + cos_beta_squared * part_00_cos_beta2_sin_epsilon2 * sin_epsilon_squared
        + cos_epsilon_squared * part_00_cos_epsilon2_sin_beta2 * sin_beta_squared
        + part_00_sin_beta2_sin_epsilon2 * sin_beta_squared * sin_epsilon_squared
    )
    result[..., 0, 1] = (
        attenuation_beta_squared * cos_beta_squared * cos_epsilon_squared * r * rho * sigma_beta * sigma_r * sum_1
        + attenuation_beta_squared * cos_epsilon_squared * r * rho * sigma_beta * sigma_r * sin_beta_squared * sum_14
        + attenuation_beta_squared_squared * cos_beta_squared * r * rho * shortfall_epsilon * sigma_beta * sigma_r * sin_epsilon_squared * sum_5
        + attenuation_beta_squared_squared * r * rho * shortfall_epsilon * sigma_beta * sigma_r * sin_beta_squared * sin_epsilon_squared * sum_9
        + cos_beta * cos_epsilon_squared * part_01_cos_beta_cos_epsilon2_sin_beta * sin_beta
        + cos_beta * part_01_cos_beta_sin_beta_sin_epsilon2 * sin_beta * sin_epsilon_squared
    )
    result[..., 0, 2] = (
        attenuation_beta * attenuation_epsilon * cos_beta * cos_epsilon * r * rho * sigma_beta * sigma_r * sin_epsilon * sum_15
        + cos_epsilon * part_02_cos_epsilon_sin_beta_sin_epsilon * sin_beta * sin_epsilon
    )
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = (
        2.0 * attenuation_beta_squared * cos_beta * cos_epsilon_squared * r * rho * sigma_beta * sigma_r * sin_beta * sum_14
        + 2.0 * attenuation_beta_squared_squared * cos_beta * r * rho * shortfall_epsilon * sigma_beta * sigma_r * sin_beta * sin_epsilon_squared * sum_9
        + cos_beta_squared * cos_epsilon_squared * part_00_cos_epsilon2_sin_beta2
        + cos_beta_squared * part_00_sin_beta2_sin_epsilon2 * sin_epsilon_squared
        + cos_epsilon_squared * part_00_cos_beta2_cos_epsilon2 * sin_beta_squared
        + part_00_cos_beta2_sin_epsilon2 * sin_beta_squared * sin_epsilon_squared
    )
    result[..., 1, 2] = (
        attenuation_beta * attenuation_epsilon * cos_epsilon * r * rho * sigma_beta * sigma_r * sin_beta * sin_epsilon * sum_16
        + cos_beta * cos_epsilon * part_02_cos_epsilon_sin_beta_sin_epsilon * sin_epsilon
    )
    result[..., 2, 0] = result[..., 0, 2]
    result[..., 2, 1] = result[..., 1, 2]
    result[..., 2, 2] = (
        cos_epsilon_squared * part_22_cos_epsilon2
        + part_22_sin_epsilon2 * sin_epsilon_squared
    )
    return result


def decorrelated_covariance(
    *,
    r: npt.ArrayLike,
    beta: npt.ArrayLike,
    epsilon: npt.ArrayLike,
    sigma_r: npt.ArrayLike,
    sigma_beta: npt.ArrayLike,
    sigma_epsilon: npt.ArrayLike,
    rho: npt.ArrayLike,
    predicted_sigma_r: npt.ArrayLike,
    predicted_sigma_beta: npt.ArrayLike,
    predicted_sigma_epsilon: npt.ArrayLike,
    predicted_rho: npt.ArrayLike,
) -> Floats:
    """Covariance of the unbiased estimate u, averaged over a prediction.

    Name: spherical.decorrelated.covariance.
    Definition: e^Lp [e^L(u u') - h h'].
    Conditioning: averaged over a prediction: the measured symbols stand for the predicted mean.
    Source: Bordonaro et al. 2014 decorrelated; Mo et al. 1998 R_m where Kp = K, R_t where Kp = 0,
    doi:10.1109/TAES.2014.120563, doi:10.1109/7.705921.

    Args:
        r: range [m], 1 to 1e+08.
        beta: azimuth, clockwise from the y axis [rad], -3.1416 to 3.1416.
        epsilon: elevation, up from the horizontal plane [rad], -1.5708 to 1.5708.
        sigma_r: standard deviation of the error of r [m], 0.001 to 10000.
        sigma_beta: standard deviation of the error of beta [rad], 1e-09 to 1.
        sigma_epsilon: standard deviation of the error of epsilon [rad], 1e-09 to 1.
        rho: correlation of the errors of r and beta [1], -1 to 1.
        predicted_sigma_r: standard deviation of the prediction of r [m], 0.001 to 10000.
        predicted_sigma_beta: standard deviation of the prediction of beta [rad], 1e-09 to 1.
        predicted_sigma_epsilon: standard deviation of the prediction of epsilon [rad], 1e-09 to 1.
        predicted_rho: correlation of the predictions of r and beta [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (3, 3), unit m^2.

    Accuracy: at most 1090 ulp anywhere in this domain with independent errors, proved for elementary
    functions within 1 ulp (float64).
    """
    arguments = _floats(r, beta, epsilon, sigma_r, sigma_beta, sigma_epsilon, rho, predicted_sigma_r, predicted_sigma_beta, predicted_sigma_epsilon, predicted_rho)
    r, beta, epsilon, sigma_r, sigma_beta, sigma_epsilon, rho, predicted_sigma_r, predicted_sigma_beta, predicted_sigma_epsilon, predicted_rho = arguments
    cos_beta = np.cos(beta)
    sin_beta = np.sin(beta)
    cos_epsilon = np.cos(epsilon)
    sin_epsilon = np.sin(epsilon)
    predicted_sigma_beta_squared = predicted_sigma_beta**2
    attenuation_predicted_beta = np.exp(-0.5 * predicted_sigma_beta_squared)
    shortfall_predicted_beta = -np.expm1(-0.5 * predicted_sigma_beta_squared)
    attenuation_predicted_epsilon = np.exp(-2.0 * predicted_sigma_epsilon**2)
    shortfall_predicted_epsilon = -np.expm1(-2.0 * predicted_sigma_epsilon**2)
    sigma_beta_squared = sigma_beta**2
    attenuation_beta = np.exp(-sigma_beta_squared)
    shortfall_beta = -np.expm1(-sigma_beta_squared)
    attenuation_epsilon = np.exp(-sigma_epsilon**2)
    shortfall_epsilon = -np.expm1(-sigma_epsilon**2)
    term_1 = 1.0 / attenuation_epsilon
    attenuation_epsilon_squared = attenuation_epsilon**2
    product_1 = attenuation_epsilon_squared * attenuation_predicted_epsilon
    sum_1 = 1.0 + product_1
    attenuation_predicted_beta_squared = attenuation_predicted_beta**2
    attenuation_predicted_beta_squared_squared = attenuation_predicted_beta_squared**2
    shortfall_epsilon_squared = shortfall_epsilon**2
    sum_2 = (
        attenuation_beta * attenuation_epsilon * shortfall_epsilon * shortfall_predicted_epsilon
        - 2.0 * attenuation_epsilon * attenuation_predicted_epsilon * shortfall_beta * shortfall_epsilon
        - 2.0 * attenuation_epsilon_squared * attenuation_predicted_epsilon * shortfall_beta
        - attenuation_epsilon * shortfall_beta * shortfall_epsilon * shortfall_predicted_epsilon
        - attenuation_epsilon_squared * shortfall_beta * shortfall_predicted_epsilon
        + attenuation_beta * attenuation_predicted_epsilon * shortfall_epsilon_squared
        + attenuation_beta * shortfall_epsilon_squared * shortfall_predicted_epsilon
    )
    predicted_rho_squared = predicted_rho**2
    predicted_sigma_r_squared = predicted_sigma_r**2
    term_2 = 1.0 / attenuation_beta
    sum_3 = 1.0 + attenuation_beta * attenuation_predicted_beta_squared_squared
    sum_4 = shortfall_epsilon - shortfall_epsilon * shortfall_predicted_epsilon + shortfall_predicted_epsilon
    sum_5 = 1.0 + attenuation_predicted_beta
    sum_6 = 1.0 + attenuation_predicted_beta_squared
    sum_7 = (
        0.25 * shortfall_beta * sum_1 * sum_3 * term_1 * term_2
        + 0.25 * shortfall_epsilon * shortfall_predicted_beta * sum_4 * sum_5 * sum_6 * term_1
    )
    r_squared = r**2
    attenuation_beta_squared = attenuation_beta**2
    product_2 = attenuation_beta_squared * attenuation_predicted_beta_squared_squared
    sum_8 = (
        1.0
        + attenuation_beta_squared * attenuation_epsilon_squared * attenuation_predicted_beta_squared_squared * attenuation_predicted_epsilon
        + product_1
        + product_2
    )
    rho_squared = rho**2
    sigma_r_squared = sigma_r**2
    shortfall_predicted_beta_squared = shortfall_predicted_beta**2
    sum_9 = (
        2.0 * attenuation_beta * attenuation_predicted_beta * shortfall_predicted_beta
        + 2.0 * attenuation_predicted_beta * shortfall_beta * shortfall_predicted_beta
        + attenuation_beta * shortfall_predicted_beta_squared
        + attenuation_predicted_beta_squared * shortfall_beta
        + shortfall_beta * shortfall_predicted_beta_squared
    )
    sum_10 = 1.0 + attenuation_beta * attenuation_predicted_beta_squared
    part_00_cos_beta2_cos_epsilon2 = (
        attenuation_beta * attenuation_predicted_beta_squared_squared * predicted_rho * predicted_sigma_beta * predicted_sigma_r * rho * sigma_beta * sigma_r * sum_1 * term_1
        + attenuation_predicted_beta_squared_squared * predicted_rho_squared * predicted_sigma_beta_squared * predicted_sigma_r_squared * sum_2 * term_1
        + predicted_sigma_r_squared * sum_7
        + r_squared * sum_7
        + 0.25 * rho_squared * sigma_beta_squared * sigma_r_squared * sum_8 * term_1 * term_2
        + 0.25 * sigma_r_squared * sum_1 * sum_10 * sum_9 * term_1 * term_2
    )
    sum_11 = 1.0 + attenuation_epsilon * attenuation_predicted_epsilon
    sum_12 = (
        attenuation_beta * attenuation_predicted_beta_squared_squared * shortfall_epsilon * sum_11 * term_1
        - attenuation_predicted_beta_squared_squared * shortfall_beta * shortfall_predicted_epsilon
    )
    sum_13 = 1.0 + attenuation_epsilon
    sum_14 = (
        attenuation_beta * attenuation_epsilon * attenuation_predicted_beta_squared_squared * shortfall_predicted_epsilon
        + attenuation_beta * attenuation_predicted_beta_squared_squared * shortfall_epsilon * sum_13 * term_1
    )
    sum_15 = (
        0.25 * shortfall_beta * shortfall_predicted_epsilon * sum_3 * term_2
        + 0.25 * shortfall_epsilon * sum_10 * sum_11 * sum_9 * term_1 * term_2
    )
    sum_16 = 1.0 + product_2
    sum_17 = (
        2.0 * attenuation_epsilon * attenuation_predicted_epsilon * shortfall_epsilon
        + 2.0 * attenuation_epsilon * shortfall_epsilon * shortfall_predicted_epsilon
        + attenuation_epsilon_squared * shortfall_predicted_epsilon
        + attenuation_predicted_epsilon * shortfall_epsilon_squared
        + shortfall_epsilon_squared * shortfall_predicted_epsilon
    )
    part_00_cos_beta2_sin_epsilon2 = (
        predicted_rho_squared * predicted_sigma_beta_squared * predicted_sigma_r_squared * sum_12
        + predicted_sigma_r_squared * sum_15
        + r_squared * sum_15
        + 0.25 * rho_squared * sigma_beta_squared * sigma_r_squared * sum_16 * sum_17 * term_1 * term_2
        + 0.25 * sigma_r_squared * sum_10 * sum_17 * sum_9 * term_1 * term_2
        + predicted_rho * predicted_sigma_beta * predicted_sigma_r * rho * sigma_beta * sigma_r * sum_14
    )
    sum_18 = -1.0 - attenuation_epsilon_squared * attenuation_predicted_epsilon
    sum_19 = (
        2.0 * attenuation_epsilon * attenuation_predicted_epsilon * shortfall_beta * shortfall_epsilon
        - attenuation_beta * attenuation_epsilon * shortfall_epsilon * shortfall_predicted_epsilon
        - attenuation_beta * attenuation_predicted_epsilon * shortfall_epsilon_squared
        - attenuation_beta * shortfall_epsilon_squared * shortfall_predicted_epsilon
        + 2.0 * attenuation_epsilon_squared * attenuation_predicted_epsilon * shortfall_beta
        + attenuation_epsilon * shortfall_beta * shortfall_epsilon * shortfall_predicted_epsilon
        + attenuation_epsilon_squared * shortfall_beta * shortfall_predicted_epsilon
    )
    product_3 = attenuation_predicted_beta * attenuation_predicted_beta_squared
    product_4 = shortfall_predicted_beta * shortfall_predicted_beta_squared
    shortfall_predicted_beta_squared_squared = shortfall_predicted_beta_squared**2
    sum_20 = (
        4.0 * attenuation_beta * attenuation_predicted_beta * product_4
        + 4.0 * attenuation_beta * product_3 * shortfall_predicted_beta
        + 4.0 * attenuation_predicted_beta * product_4 * shortfall_beta
        + 4.0 * product_3 * shortfall_beta * shortfall_predicted_beta
        + 6.0 * attenuation_beta * attenuation_predicted_beta_squared * shortfall_predicted_beta_squared
        + 6.0 * attenuation_predicted_beta_squared * shortfall_beta * shortfall_predicted_beta_squared
        + attenuation_beta * shortfall_predicted_beta_squared_squared
        + attenuation_predicted_beta_squared_squared * shortfall_beta
        + shortfall_beta * shortfall_predicted_beta_squared_squared
    )
    sum_21 = 1.0 + attenuation_predicted_beta_squared_squared
    sum_22 = (
        0.25 * shortfall_beta * sum_1 * sum_20 * term_1 * term_2
        + 0.25 * shortfall_epsilon * sum_21 * sum_4 * term_1
    )
    part_00_cos_epsilon2_sin_beta2 = (
        attenuation_beta * attenuation_predicted_beta_squared_squared * predicted_rho * predicted_sigma_beta * predicted_sigma_r * rho * sigma_beta * sigma_r * sum_18 * term_1
        + attenuation_predicted_beta_squared_squared * predicted_rho_squared * predicted_sigma_beta_squared * predicted_sigma_r_squared * sum_19 * term_1
        + predicted_sigma_r_squared * sum_22
        + r_squared * sum_22
        + 0.25 * rho_squared * sigma_beta_squared * sigma_r_squared * sum_1 * sum_10 * sum_9 * term_1 * term_2
        + 0.25 * sigma_r_squared * sum_8 * term_1 * term_2
    )
    sum_23 = (
        attenuation_predicted_beta_squared_squared * shortfall_beta * shortfall_predicted_epsilon
        - attenuation_beta * attenuation_predicted_beta_squared_squared * shortfall_epsilon * sum_11 * term_1
    )
    sum_24 = (
        -attenuation_beta * attenuation_epsilon * attenuation_predicted_beta_squared_squared * shortfall_predicted_epsilon
        - attenuation_beta * attenuation_predicted_beta_squared_squared * shortfall_epsilon * sum_13 * term_1
    )
    sum_25 = (
        0.25 * shortfall_beta * shortfall_predicted_epsilon * sum_20 * term_2
        + 0.25 * shortfall_epsilon * sum_11 * sum_16 * term_1 * term_2
    )
    part_00_sin_beta2_sin_epsilon2 = (
        predicted_rho_squared * predicted_sigma_beta_squared * predicted_sigma_r_squared * sum_23
        + predicted_sigma_r_squared * sum_25
        + r_squared * sum_25
        + 0.25 * rho_squared * sigma_beta_squared * sigma_r_squared * sum_10 * sum_17 * sum_9 * term_1 * term_2
        + 0.25 * sigma_r_squared * sum_16 * sum_17 * term_1 * term_2
        + predicted_rho * predicted_sigma_beta * predicted_sigma_r * rho * sigma_beta * sigma_r * sum_24
    )
    part_00_cos_beta_cos_epsilon2_sin_beta = (
        2.0 * attenuation_predicted_beta_squared_squared * predicted_rho * predicted_sigma_beta * predicted_sigma_r * r * sum_2 * term_1
        + attenuation_beta * attenuation_predicted_beta_squared_squared * r * rho * sigma_beta * sigma_r * sum_1 * term_1
    )
    sum_26 = (
        2.0 * attenuation_beta * attenuation_predicted_beta_squared_squared * shortfall_epsilon * sum_11 * term_1
        - 2.0 * attenuation_predicted_beta_squared_squared * shortfall_beta * shortfall_predicted_epsilon
    )
    part_00_cos_beta_sin_beta_sin_epsilon2 = (
        r * rho * sigma_beta * sigma_r * sum_14
        + predicted_rho * predicted_sigma_beta * predicted_sigma_r * r * sum_26
    )
    part_01_cos_beta2_cos_epsilon2 = (
        0.5 * attenuation_beta * attenuation_predicted_beta_squared_squared * r * rho * sigma_beta * sigma_r * sum_1 * term_1
        + attenuation_predicted_beta_squared_squared * predicted_rho * predicted_sigma_beta * predicted_sigma_r * r * sum_2 * term_1
    )
    sum_27 = (
        0.5 * attenuation_beta * attenuation_epsilon * attenuation_predicted_beta_squared_squared * shortfall_predicted_epsilon
        + 0.5 * attenuation_beta * attenuation_predicted_beta_squared_squared * shortfall_epsilon * sum_13 * term_1
    )
    part_01_cos_beta2_sin_epsilon2 = (
        predicted_rho * predicted_sigma_beta * predicted_sigma_r * r * sum_12
        + r * rho * sigma_beta * sigma_r * sum_27
    )
    part_01_cos_beta_cos_epsilon2_sin_beta = (
        2.0 * attenuation_beta * attenuation_predicted_beta_squared_squared * predicted_rho * predicted_sigma_beta * predicted_sigma_r * rho * sigma_beta * sigma_r * sum_18 * term_1
        + 2.0 * attenuation_predicted_beta_squared_squared * predicted_rho_squared * predicted_sigma_beta_squared * predicted_sigma_r_squared * sum_19 * term_1
        + 0.5 * attenuation_beta * attenuation_predicted_beta_squared_squared * rho_squared * sigma_beta_squared * sigma_r_squared * sum_18 * term_1
        + 0.5 * attenuation_beta * attenuation_predicted_beta_squared_squared * sigma_r_squared * sum_1 * term_1
        + 0.5 * attenuation_predicted_beta_squared_squared * predicted_sigma_r_squared * sum_2 * term_1
        + 0.5 * attenuation_predicted_beta_squared_squared * r_squared * sum_2 * term_1
    )
    sum_28 = (
        2.0 * attenuation_predicted_beta_squared_squared * shortfall_beta * shortfall_predicted_epsilon
        - 2.0 * attenuation_beta * attenuation_predicted_beta_squared_squared * shortfall_epsilon * sum_11 * term_1
    )
    sum_29 = (
        -2.0 * attenuation_beta * attenuation_epsilon * attenuation_predicted_beta_squared_squared * shortfall_predicted_epsilon
        - 2.0 * attenuation_beta * attenuation_predicted_beta_squared_squared * shortfall_epsilon * sum_13 * term_1
    )
    sum_30 = (
        0.5 * attenuation_beta * attenuation_predicted_beta_squared_squared * shortfall_epsilon * sum_11 * term_1
        - 0.5 * attenuation_predicted_beta_squared_squared * shortfall_beta * shortfall_predicted_epsilon
    )
    sum_31 = (
        -0.5 * attenuation_beta * attenuation_epsilon * attenuation_predicted_beta_squared_squared * shortfall_predicted_epsilon
        - 0.5 * attenuation_beta * attenuation_predicted_beta_squared_squared * shortfall_epsilon * sum_13 * term_1
    )
    part_01_cos_beta_sin_beta_sin_epsilon2 = (
        predicted_rho_squared * predicted_sigma_beta_squared * predicted_sigma_r_squared * sum_28
        + predicted_sigma_r_squared * sum_30
        + r_squared * sum_30
        + rho_squared * sigma_beta_squared * sigma_r_squared * sum_31
        + sigma_r_squared * sum_27
        + predicted_rho * predicted_sigma_beta * predicted_sigma_r * rho * sigma_beta * sigma_r * sum_29
    )
    part_01_cos_epsilon2_sin_beta2 = (
        0.5 * attenuation_beta * attenuation_predicted_beta_squared_squared * r * rho * sigma_beta * sigma_r * sum_18 * term_1
        + attenuation_predicted_beta_squared_squared * predicted_rho * predicted_sigma_beta * predicted_sigma_r * r * sum_19 * term_1
    )
    part_01_sin_beta2_sin_epsilon2 = (
        predicted_rho * predicted_sigma_beta * predicted_sigma_r * r * sum_23
        + r * rho * sigma_beta * sigma_r * sum_31
    )
    part_02_cos_beta_cos_epsilon_sin_epsilon = (
        attenuation_epsilon * attenuation_predicted_beta * attenuation_predicted_epsilon * r * rho * sigma_beta * sigma_r
        - 2.0 * attenuation_predicted_beta * attenuation_predicted_epsilon * predicted_rho * predicted_sigma_beta * predicted_sigma_r * r * shortfall_epsilon
    )
    part_02_cos_epsilon_sin_beta_sin_epsilon = (
        attenuation_epsilon * attenuation_predicted_beta * attenuation_predicted_epsilon * sigma_r_squared
        - attenuation_epsilon * attenuation_predicted_beta * attenuation_predicted_epsilon * predicted_rho * predicted_sigma_beta * predicted_sigma_r * rho * sigma_beta * sigma_r
        - attenuation_predicted_beta * attenuation_predicted_epsilon * predicted_sigma_r_squared * shortfall_epsilon
        - attenuation_predicted_beta * attenuation_predicted_epsilon * r_squared * shortfall_epsilon
        + attenuation_predicted_beta * attenuation_predicted_epsilon * predicted_rho_squared * predicted_sigma_beta_squared * predicted_sigma_r_squared * shortfall_epsilon
    )
    part_11_cos_beta_cos_epsilon2_sin_beta = (
        2.0 * attenuation_predicted_beta_squared_squared * predicted_rho * predicted_sigma_beta * predicted_sigma_r * r * sum_19 * term_1
        + attenuation_beta * attenuation_predicted_beta_squared_squared * r * rho * sigma_beta * sigma_r * sum_18 * term_1
    )
    part_11_cos_beta_sin_beta_sin_epsilon2 = (
        r * rho * sigma_beta * sigma_r * sum_24
        + predicted_rho * predicted_sigma_beta * predicted_sigma_r * r * sum_28
    )
    sum_32 = (
        0.5 * attenuation_epsilon * shortfall_predicted_epsilon
        + 0.5 * shortfall_epsilon * sum_13 * term_1
    )
    part_22_cos_epsilon2 = (
        0.5 * predicted_sigma_r_squared * shortfall_epsilon * sum_11 * term_1
        + 0.5 * r_squared * shortfall_epsilon * sum_11 * term_1
        + sigma_r_squared * sum_32
    )
    part_22_sin_epsilon2 = (
        0.5 * predicted_sigma_r_squared * shortfall_epsilon * sum_4 * term_1
        + 0.5 * r_squared * shortfall_epsilon * sum_4 * term_1
        + 0.5 * sigma_r_squared * sum_1 * term_1
    )
    cos_beta_squared = cos_beta**2
    cos_epsilon_squared = cos_epsilon**2
    sin_epsilon_squared = sin_epsilon**2
    sin_beta_squared = sin_beta**2
    result = _empty(arguments, (3, 3))
    result[..., 0, 0] = (
        cos_beta * cos_epsilon_squared * part_00_cos_beta_cos_epsilon2_sin_beta * sin_beta
        + cos_beta * part_00_cos_beta_sin_beta_sin_epsilon2 * sin_beta * sin_epsilon_squared
        + cos_beta_squared * cos_epsilon_squared * part_00_cos_beta2_cos_epsilon2
        + cos_beta_squared * part_00_cos_beta2_sin_epsilon2 * sin_epsilon_squared
        + cos_epsilon_squared * part_00_cos_epsilon2_sin_beta2 * sin_beta_squared
        + part_00_sin_beta2_sin_epsilon2 * sin_beta_squared * sin_epsilon_squared
    )
    result[..., 0, 1] = (
        cos_beta * cos_epsilon_squared * part_01_cos_beta_cos_epsilon2_sin_beta * sin_beta
        + cos_beta * part_01_cos_beta_sin_beta_sin_epsilon2 * sin_beta * sin_epsilon_squared
        + cos_beta_squared * cos_epsilon_squared * part_01_cos_beta2_cos_epsilon2
        + cos_beta_squared * part_01_cos_beta2_sin_epsilon2 * sin_epsilon_squared
        + cos_epsilon_squared * part_01_cos_epsilon2_sin_beta2 * sin_beta_squared
        + part_01_sin_beta2_sin_epsilon2 * sin_beta_squared * sin_epsilon_squared
    )
    result[..., 0, 2] = (
        cos_beta * cos_epsilon * part_02_cos_beta_cos_epsilon_sin_epsilon * sin_epsilon
        + cos_epsilon * part_02_cos_epsilon_sin_beta_sin_epsilon * sin_beta * sin_epsilon
    )
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = (
        cos_beta * cos_epsilon_squared * part_11_cos_beta_cos_epsilon2_sin_beta * sin_beta
        + cos_beta * part_11_cos_beta_sin_beta_sin_epsilon2 * sin_beta * sin_epsilon_squared
        + cos_beta_squared * cos_epsilon_squared * part_00_cos_epsilon2_sin_beta2
        + cos_beta_squared * part_00_sin_beta2_sin_epsilon2 * sin_epsilon_squared
        + cos_epsilon_squared * part_00_cos_beta2_cos_epsilon2 * sin_beta_squared
        + part_00_cos_beta2_sin_epsilon2 * sin_beta_squared * sin_epsilon_squared
    )
    result[..., 1, 2] = (
        cos_beta * cos_epsilon * part_02_cos_epsilon_sin_beta_sin_epsilon * sin_epsilon
        - cos_epsilon * part_02_cos_beta_cos_epsilon_sin_epsilon * sin_beta * sin_epsilon
    )
    result[..., 2, 0] = result[..., 0, 2]
    result[..., 2, 1] = result[..., 1, 2]
    result[..., 2, 2] = (
        cos_epsilon_squared * part_22_cos_epsilon2
        + part_22_sin_epsilon2 * sin_epsilon_squared
    )
    return result


def unbiased_covariance_truth(
    *,
    r: npt.ArrayLike,
    beta: npt.ArrayLike,
    epsilon: npt.ArrayLike,
    sigma_r: npt.ArrayLike,
    sigma_beta: npt.ArrayLike,
    sigma_epsilon: npt.ArrayLike,
    rho: npt.ArrayLike,
) -> Floats:
    """Covariance of the unbiased estimate u about the true position, R_t of Mo et al..

    Name: spherical.unbiased.covariance.truth.
    Definition: e^L(u u') - h h'.
    Conditioning: truth-conditioned: the measured symbols stand for the true values.
    Source: Mo et al. 1998 R_t, doi:10.1109/7.705921.

    Args:
        r: range [m], 1 to 1e+08.
        beta: azimuth, clockwise from the y axis [rad], -3.1416 to 3.1416.
        epsilon: elevation, up from the horizontal plane [rad], -1.5708 to 1.5708.
        sigma_r: standard deviation of the error of r [m], 0.001 to 10000.
        sigma_beta: standard deviation of the error of beta [rad], 1e-09 to 1.
        sigma_epsilon: standard deviation of the error of epsilon [rad], 1e-09 to 1.
        rho: correlation of the errors of r and beta [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (3, 3), unit m^2.

    Accuracy: at most 73.6 ulp anywhere in this domain with independent errors, proved for elementary
    functions within 1 ulp (float64).
    """
    arguments = _floats(r, beta, epsilon, sigma_r, sigma_beta, sigma_epsilon, rho)
    r, beta, epsilon, sigma_r, sigma_beta, sigma_epsilon, rho = arguments
    cos_beta = np.cos(beta)
    sin_beta = np.sin(beta)
    cos_epsilon = np.cos(epsilon)
    sin_epsilon = np.sin(epsilon)
    sigma_beta_squared = sigma_beta**2
    attenuation_beta = np.exp(-sigma_beta_squared)
    shortfall_beta = -np.expm1(-sigma_beta_squared)
    attenuation_epsilon = np.exp(-sigma_epsilon**2)
    shortfall_epsilon = -np.expm1(-sigma_epsilon**2)
    term_1 = 1.0 / attenuation_beta
    term_2 = 1.0 / attenuation_epsilon
    attenuation_beta_squared = attenuation_beta**2
    attenuation_epsilon_squared = attenuation_epsilon**2
    sum_1 = (
        1.0
        + attenuation_beta_squared
        + attenuation_beta_squared * attenuation_epsilon_squared
        + attenuation_epsilon_squared
    )
    rho_squared = rho**2
    sigma_r_squared = sigma_r**2
    sum_2 = (
        1.0
        + attenuation_beta
        + attenuation_beta * attenuation_epsilon_squared
        + attenuation_epsilon_squared
    )
    r_squared = r**2
    part_00_cos_beta2_cos_epsilon2 = (
        0.25 * r_squared * shortfall_beta * sum_2 * term_1 * term_2
        + 0.25 * rho_squared * sigma_beta_squared * sigma_r_squared * sum_1 * term_1 * term_2
        + 0.25 * shortfall_beta * sigma_r_squared * sum_2 * term_1 * term_2
    )
    sum_3 = 1.0 + attenuation_beta + attenuation_beta * attenuation_epsilon + attenuation_epsilon
    sum_4 = (
        1.0
        + attenuation_beta_squared
        + attenuation_beta_squared * attenuation_epsilon
        + attenuation_epsilon
    )
    part_00_cos_beta2_sin_epsilon2 = (
        0.25 * r_squared * shortfall_beta * shortfall_epsilon * sum_3 * term_1 * term_2
        + 0.25 * rho_squared * shortfall_epsilon * sigma_beta_squared * sigma_r_squared * sum_4 * term_1 * term_2
        + 0.25 * shortfall_beta * shortfall_epsilon * sigma_r_squared * sum_3 * term_1 * term_2
    )
    shortfall_beta_squared = shortfall_beta**2
    shortfall_epsilon_squared = shortfall_epsilon**2
    sum_5 = (
        0.25 * shortfall_beta_squared * shortfall_epsilon_squared * term_1 * term_2
        + 0.5 * shortfall_beta_squared * term_1
        + 0.5 * shortfall_epsilon_squared * term_2
    )
    part_00_cos_epsilon2_sin_beta2 = (
        r_squared * sum_5
        + 0.25 * rho_squared * shortfall_beta * sigma_beta_squared * sigma_r_squared * sum_2 * term_1 * term_2
        + 0.25 * sigma_r_squared * sum_1 * term_1 * term_2
    )
    part_00_sin_beta2_sin_epsilon2 = (
        0.25 * r_squared * shortfall_epsilon * sum_4 * term_1 * term_2
        + 0.25 * rho_squared * shortfall_beta * shortfall_epsilon * sigma_beta_squared * sigma_r_squared * sum_3 * term_1 * term_2
        + 0.25 * shortfall_epsilon * sigma_r_squared * sum_4 * term_1 * term_2
    )
    sum_6 = -1.0 - attenuation_epsilon_squared
    sum_7 = 1.0 + attenuation_epsilon_squared
    sum_8 = 0.5 * attenuation_beta * shortfall_epsilon_squared * term_2 - shortfall_beta
    part_01_cos_beta_cos_epsilon2_sin_beta = (
        0.5 * attenuation_beta * rho_squared * sigma_beta_squared * sigma_r_squared * sum_6 * term_2
        + 0.5 * attenuation_beta * sigma_r_squared * sum_7 * term_2
        + r_squared * sum_8
    )
    sum_9 = 1.0 + attenuation_epsilon
    sum_10 = -1.0 - attenuation_epsilon
    part_01_cos_beta_sin_beta_sin_epsilon2 = (
        0.5 * attenuation_beta * r_squared * shortfall_epsilon * sum_9 * term_2
        + 0.5 * attenuation_beta * rho_squared * shortfall_epsilon * sigma_beta_squared * sigma_r_squared * sum_10 * term_2
        + 0.5 * attenuation_beta * shortfall_epsilon * sigma_r_squared * sum_9 * term_2
    )
    part_02_cos_beta_cos_epsilon_sin_epsilon = attenuation_epsilon * r * rho * sigma_beta * sigma_r
    part_02_cos_epsilon_sin_beta_sin_epsilon = (
        attenuation_epsilon * sigma_r_squared
        - r_squared * shortfall_epsilon
    )
    part_22_cos_epsilon2 = (
        0.5 * r_squared * shortfall_epsilon * sum_9 * term_2
        + 0.5 * shortfall_epsilon * sigma_r_squared * sum_9 * term_2
    )
    part_22_sin_epsilon2 = (
        0.5 * r_squared * shortfall_epsilon_squared * term_2
        + 0.5 * sigma_r_squared * sum_7 * term_2
    )
    cos_epsilon_squared = cos_epsilon**2
    sin_epsilon_squared = sin_epsilon**2
    cos_beta_squared = cos_beta**2
    sin_beta_squared = sin_beta**2
    result = _empty(arguments, (3, 3))
    result[..., 0, 0] = (
        attenuation_beta * cos_beta * cos_epsilon_squared * r * rho * sigma_beta * sigma_r * sin_beta * sum_7 * term_2
        + attenuation_beta * cos_beta * r * rho * shortfall_epsilon * sigma_beta * sigma_r * sin_beta * sin_epsilon_squared * sum_9 * term_2
        + cos_beta_squared * cos_epsilon_squared * part_00_cos_beta2_cos_epsilon2
        + cos_beta_squared * part_00_cos_beta2_sin_epsilon2 * sin_epsilon_squared
        + cos_epsilon_squared * part_00_cos_epsilon2_sin_beta2 * sin_beta_squared
        + part_00_sin_beta2_sin_epsilon2 * sin_beta_squared * sin_epsilon_squared
    )
    result[..., 0, 1] = (
        0.5 * attenuation_beta * cos_beta_squared * cos_epsilon_squared * r * rho * sigma_beta * sigma_r * sum_7 * term_2
        + 0.5 * attenuation_beta * cos_beta_squared * r * rho * shortfall_epsilon * sigma_beta * sigma_r * sin_epsilon_squared * sum_9 * term_2
        + 0.5 * attenuation_beta * cos_epsilon_squared * r * rho * sigma_beta * sigma_r * sin_beta_squared * sum_6 * term_2
        + 0.5 * attenuation_beta * r * rho * shortfall_epsilon * sigma_beta * sigma_r * sin_beta_squared * sin_epsilon_squared * sum_10 * term_2
        + cos_beta * cos_epsilon_squared * part_01_cos_beta_cos_epsilon2_sin_beta * sin_beta
        + cos_beta * part_01_cos_beta_sin_beta_sin_epsilon2 * sin_beta * sin_epsilon_squared
    )
    result[..., 0, 2] = (
        cos_beta * cos_epsilon * part_02_cos_beta_cos_epsilon_sin_epsilon * sin_epsilon
        + cos_epsilon * part_02_cos_epsilon_sin_beta_sin_epsilon * sin_beta * sin_epsilon
    )
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = (
        attenuation_beta * cos_beta * cos_epsilon_squared * r * rho * sigma_beta * sigma_r * sin_beta * sum_6 * term_2
        + attenuation_beta * cos_beta * r * rho * shortfall_epsilon * sigma_beta * sigma_r * sin_beta * sin_epsilon_squared * sum_10 * term_2
        + cos_beta_squared * cos_epsilon_squared * part_00_cos_epsilon2_sin_beta2
        + cos_beta_squared * part_00_sin_beta2_sin_epsilon2 * sin_epsilon_squared
        + cos_epsilon_squared * part_00_cos_beta2_cos_epsilon2 * sin_beta_squared
        + part_00_cos_beta2_sin_epsilon2 * sin_beta_squared * sin_epsilon_squared
    )
    result[..., 1, 2] = (
        cos_beta * cos_epsilon * part_02_cos_epsilon_sin_beta_sin_epsilon * sin_epsilon
        - cos_epsilon * part_02_cos_beta_cos_epsilon_sin_epsilon * sin_beta * sin_epsilon
    )
    result[..., 2, 0] = result[..., 0, 2]
    result[..., 2, 1] = result[..., 1, 2]
    result[..., 2, 2] = (
        cos_epsilon_squared * part_22_cos_epsilon2
        + part_22_sin_epsilon2 * sin_epsilon_squared
    )
    return result


def unbiased_covariance_averaged(
    *,
    r: npt.ArrayLike,
    beta: npt.ArrayLike,
    epsilon: npt.ArrayLike,
    sigma_r: npt.ArrayLike,
    sigma_beta: npt.ArrayLike,
    sigma_epsilon: npt.ArrayLike,
    rho: npt.ArrayLike,
) -> Floats:
    """Covariance of the unbiased estimate u, averaged over the truth, R_m of Mo et al..

    Name: spherical.unbiased.covariance.averaged.
    Definition: e^L [e^L(u u') - h h'].
    Conditioning: measurement-conditioned: the measured symbols stand for the measurement.
    Source: Mo et al. 1998 R_m, doi:10.1109/7.705921.

    Args:
        r: range [m], 1 to 1e+08.
        beta: azimuth, clockwise from the y axis [rad], -3.1416 to 3.1416.
        epsilon: elevation, up from the horizontal plane [rad], -1.5708 to 1.5708.
        sigma_r: standard deviation of the error of r [m], 0.001 to 10000.
        sigma_beta: standard deviation of the error of beta [rad], 1e-09 to 1.
        sigma_epsilon: standard deviation of the error of epsilon [rad], 1e-09 to 1.
        rho: correlation of the errors of r and beta [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (3, 3), unit m^2.

    Accuracy: at most 2220 ulp anywhere in this domain with independent errors, proved for elementary
    functions within 1 ulp (float64).
    """
    arguments = _floats(r, beta, epsilon, sigma_r, sigma_beta, sigma_epsilon, rho)
    r, beta, epsilon, sigma_r, sigma_beta, sigma_epsilon, rho = arguments
    cos_beta = np.cos(beta)
    sin_beta = np.sin(beta)
    cos_epsilon = np.cos(epsilon)
    sin_epsilon = np.sin(epsilon)
    sigma_beta_squared = sigma_beta**2
    attenuation_beta = np.exp(-0.5 * sigma_beta_squared)
    shortfall_beta = -np.expm1(-0.5 * sigma_beta_squared)
    attenuation_epsilon = np.exp(-sigma_epsilon**2)
    shortfall_epsilon = -np.expm1(-sigma_epsilon**2)
    term_1 = 1.0 / attenuation_epsilon
    attenuation_beta_squared = attenuation_beta**2
    attenuation_beta_squared_cubed = attenuation_beta_squared * attenuation_beta_squared**2
    product_1 = -4.0 * attenuation_beta_squared_cubed * attenuation_epsilon
    attenuation_epsilon_squared = attenuation_epsilon**2
    product_2 = attenuation_epsilon * attenuation_epsilon_squared
    term_2 = (attenuation_beta_squared**2)**2
    attenuation_epsilon_squared_squared = attenuation_epsilon_squared**2
    term_3 = 1.0 / attenuation_beta**2
    rho_squared = rho**2
    sigma_r_squared = sigma_r**2
    sum_1 = (
        1.0
        - 4.0 * attenuation_beta_squared_cubed * product_2
        + 9.0 * attenuation_epsilon_squared_squared * term_2
        + 9.0 * term_2
        + attenuation_epsilon_squared_squared
        + product_1
    )
    sum_2 = 1.0 + attenuation_beta
    sum_3 = 1.0 + attenuation_beta_squared
    product_3 = -attenuation_beta_squared * attenuation_epsilon
    product_4 = -attenuation_beta_squared * product_2
    attenuation_beta_squared_squared = attenuation_beta_squared**2
    r_squared = r**2
    sum_4 = (
        1.0
        + attenuation_beta_squared_squared
        + attenuation_beta_squared_squared * attenuation_epsilon_squared_squared
        + attenuation_epsilon_squared_squared
        + product_3
        + product_4
    )
    sum_5 = (
        2.0
        + 2.0 * attenuation_beta_squared_squared
        + 2.0 * attenuation_beta_squared_squared * attenuation_epsilon_squared_squared
        + 2.0 * attenuation_epsilon_squared_squared
        + product_3
        + product_4
    )
    part_00_cos_beta2_cos_epsilon2 = (
        0.25 * r_squared * shortfall_beta * sum_2 * sum_3 * sum_4 * term_1 * term_3
        + 0.25 * rho_squared * sigma_beta_squared * sigma_r_squared * sum_1 * term_1 * term_3
        + 0.25 * shortfall_beta * sigma_r_squared * sum_2 * sum_3 * sum_5 * term_1 * term_3
    )
    sum_6 = 1.0 + attenuation_epsilon
    sum_7 = (
        1.0
        + attenuation_beta_squared_squared
        + attenuation_beta_squared_squared * attenuation_epsilon_squared
        + attenuation_epsilon_squared
        + product_3
    )
    sum_8 = (
        2.0
        + 2.0 * attenuation_beta_squared_squared
        + 2.0 * attenuation_beta_squared_squared * attenuation_epsilon_squared
        + 2.0 * attenuation_epsilon_squared
        + product_3
    )
    sum_9 = (
        1.0
        + 9.0 * attenuation_epsilon_squared * term_2
        + 9.0 * term_2
        + attenuation_epsilon_squared
        + product_1
    )
    part_00_cos_beta2_sin_epsilon2 = (
        0.25 * r_squared * shortfall_beta * shortfall_epsilon * sum_2 * sum_3 * sum_6 * sum_7 * term_1 * term_3
        + 0.25 * rho_squared * shortfall_epsilon * sigma_beta_squared * sigma_r_squared * sum_6 * sum_9 * term_1 * term_3
        + 0.25 * shortfall_beta * shortfall_epsilon * sigma_r_squared * sum_2 * sum_3 * sum_6 * sum_8 * term_1 * term_3
    )
    product_5 = attenuation_beta * attenuation_beta_squared
    shortfall_beta_squared = shortfall_beta**2
    product_6 = shortfall_beta * shortfall_beta_squared**2
    shortfall_beta_squared_cubed = shortfall_beta_squared * shortfall_beta_squared**2
    shortfall_beta_squared_squared = shortfall_beta_squared**2
    shortfall_epsilon_squared = shortfall_epsilon**2
    product_7 = shortfall_epsilon * shortfall_epsilon_squared
    product_8 = attenuation_beta * attenuation_beta_squared**2
    product_9 = shortfall_beta * shortfall_beta_squared
    product_10 = shortfall_beta * shortfall_beta_squared * shortfall_beta_squared**2
    shortfall_epsilon_squared_squared = shortfall_epsilon_squared**2
    term_4 = (shortfall_beta_squared**2)**2
    product_11 = attenuation_beta * attenuation_beta_squared * attenuation_beta_squared**2
    sum_10 = (
        100.0 * attenuation_epsilon_squared_squared * product_5 * product_6
        + 108.0 * attenuation_beta_squared * product_2 * shortfall_beta_squared_cubed * shortfall_epsilon
        + 110.0 * attenuation_beta_squared_squared * attenuation_epsilon_squared_squared * shortfall_beta_squared_squared
        + 111.0 * attenuation_beta_squared * attenuation_epsilon * product_7 * shortfall_beta_squared_cubed
        + 120.0 * attenuation_beta_squared_cubed * attenuation_epsilon_squared * shortfall_beta_squared * shortfall_epsilon_squared
        + 144.0 * product_2 * product_8 * product_9 * shortfall_epsilon
        + 16.0 * attenuation_beta * attenuation_epsilon_squared_squared * product_10
        + 165.0 * attenuation_beta_squared * attenuation_epsilon_squared * shortfall_beta_squared_cubed * shortfall_epsilon_squared
        + 2.0 * attenuation_epsilon_squared_squared * term_4
        + 2.0 * shortfall_epsilon_squared_squared * term_2
        + 200.0 * product_2 * product_5 * product_6 * shortfall_epsilon
        + 204.0 * attenuation_epsilon * product_7 * product_8 * product_9
        + 218.0 * attenuation_epsilon * product_5 * product_6 * product_7
        + 220.0 * attenuation_beta_squared_squared * product_2 * shortfall_beta_squared_squared * shortfall_epsilon
        + 24.0 * attenuation_beta_squared_cubed * attenuation_epsilon_squared_squared * shortfall_beta_squared
        + 24.0 * attenuation_epsilon * product_11 * product_7 * shortfall_beta
        + 24.0 * attenuation_epsilon_squared * product_11 * shortfall_beta * shortfall_epsilon_squared
        + 265.0 * attenuation_beta_squared_squared * attenuation_epsilon * product_7 * shortfall_beta_squared_squared
        + 276.0 * attenuation_epsilon_squared * product_8 * product_9 * shortfall_epsilon_squared
        + 28.0 * attenuation_beta_squared * shortfall_beta_squared_cubed * shortfall_epsilon_squared_squared
        + 28.0 * attenuation_beta_squared_cubed * shortfall_beta_squared * shortfall_epsilon_squared_squared
        + 318.0 * attenuation_epsilon_squared * product_5 * product_6 * shortfall_epsilon_squared
        + 32.0 * attenuation_beta * attenuation_epsilon * product_10 * product_7
        + 32.0 * attenuation_beta * product_10 * product_2 * shortfall_epsilon
        + 375.0 * attenuation_beta_squared_squared * attenuation_epsilon_squared * shortfall_beta_squared_squared * shortfall_epsilon_squared
        + 4.0 * attenuation_epsilon * product_7 * term_4
        + 4.0 * product_2 * shortfall_epsilon * term_4
        + 48.0 * attenuation_beta * attenuation_epsilon_squared * product_10 * shortfall_epsilon_squared
        + 48.0 * attenuation_beta_squared_cubed * product_2 * shortfall_beta_squared * shortfall_epsilon
        + 54.0 * attenuation_beta_squared * attenuation_epsilon_squared_squared * shortfall_beta_squared_cubed
        + 56.0 * product_5 * product_6 * shortfall_epsilon_squared_squared
        + 56.0 * product_8 * product_9 * shortfall_epsilon_squared_squared
        + 6.0 * attenuation_epsilon * product_7 * term_2
        + 6.0 * attenuation_epsilon_squared * shortfall_epsilon_squared * term_2
        + 6.0 * attenuation_epsilon_squared * shortfall_epsilon_squared * term_4
        + 70.0 * attenuation_beta_squared_squared * shortfall_beta_squared_squared * shortfall_epsilon_squared_squared
        + 72.0 * attenuation_epsilon_squared_squared * product_8 * product_9
        + 8.0 * attenuation_beta * product_10 * shortfall_epsilon_squared_squared
        + 8.0 * product_11 * shortfall_beta * shortfall_epsilon_squared_squared
        + 96.0 * attenuation_beta_squared_cubed * attenuation_epsilon * product_7 * shortfall_beta_squared
        + shortfall_epsilon_squared_squared * term_4
    )
    sum_11 = (
        4.0 * term_2
        - 16.0 * product_11 * shortfall_beta
        - 28.0 * attenuation_beta_squared * shortfall_beta_squared_cubed
        - 32.0 * attenuation_beta_squared_cubed * shortfall_beta_squared
        - 56.0 * product_5 * product_6
        - 56.0 * product_8 * product_9
        - 70.0 * attenuation_beta_squared_squared * shortfall_beta_squared_squared
        - 8.0 * attenuation_beta * product_10
        - term_4
    )
    sum_12 = (
        112.0 * attenuation_epsilon * product_5 * product_6 * shortfall_epsilon_squared
        - 112.0 * product_2 * product_5 * product_6
        - 112.0 * product_2 * product_8 * product_9
        - 12.0 * attenuation_beta_squared_cubed * attenuation_epsilon_squared * shortfall_beta_squared * shortfall_epsilon
        - 12.0 * attenuation_epsilon_squared * shortfall_epsilon * term_2
        - 140.0 * attenuation_beta_squared_squared * product_2 * shortfall_beta_squared_squared
        - 16.0 * attenuation_beta * product_10 * product_2
        - 2.0 * product_2 * term_4
        - 20.0 * attenuation_epsilon * shortfall_epsilon_squared * term_2
        - 24.0 * attenuation_epsilon_squared * product_11 * shortfall_beta * shortfall_epsilon
        - 32.0 * product_11 * product_2 * shortfall_beta
        - 56.0 * attenuation_beta_squared * product_2 * shortfall_beta_squared_cubed
        - 64.0 * attenuation_beta_squared_cubed * product_2 * shortfall_beta_squared
        - 8.0 * product_7 * term_2
        + 112.0 * attenuation_epsilon * product_8 * product_9 * shortfall_epsilon_squared
        + 140.0 * attenuation_beta_squared_squared * attenuation_epsilon * shortfall_beta_squared_squared * shortfall_epsilon_squared
        + 16.0 * attenuation_beta * attenuation_epsilon * product_10 * shortfall_epsilon_squared
        + 2.0 * attenuation_epsilon * shortfall_epsilon_squared * term_4
        + 28.0 * attenuation_beta_squared * product_7 * shortfall_beta_squared_cubed
        + 28.0 * attenuation_beta_squared_cubed * product_7 * shortfall_beta_squared
        + 52.0 * attenuation_beta_squared_cubed * attenuation_epsilon * shortfall_beta_squared * shortfall_epsilon_squared
        + 56.0 * attenuation_beta_squared * attenuation_epsilon * shortfall_beta_squared_cubed * shortfall_epsilon_squared
        + 56.0 * product_5 * product_6 * product_7
        + 56.0 * product_7 * product_8 * product_9
        + 70.0 * attenuation_beta_squared_squared * product_7 * shortfall_beta_squared_squared
        + 8.0 * attenuation_beta * product_10 * product_7
        + 8.0 * attenuation_epsilon * product_11 * shortfall_beta * shortfall_epsilon_squared
        + 8.0 * product_11 * product_7 * shortfall_beta
        + 8.0 * product_2 * term_2
        + product_7 * term_4
    )
    sum_13 = 0.25 * shortfall_epsilon * sum_12 * term_1 * term_3 - 0.5 * sum_11 * term_3
    product_12 = -attenuation_beta_squared_cubed * attenuation_epsilon
    sum_14 = (
        2.0
        - attenuation_beta_squared_cubed * product_2
        + 2.0 * attenuation_epsilon_squared_squared
        + 2.0 * attenuation_epsilon_squared_squared * term_2
        + 2.0 * term_2
        + product_12
        + product_3
        + product_4
    )
    part_00_cos_epsilon2_sin_beta2 = (
        0.25 * r_squared * sum_10 * term_1 * term_3
        + rho_squared * sigma_beta_squared * sigma_r_squared * sum_13
        + 0.25 * sigma_r_squared * sum_14 * term_1 * term_3
    )
    sum_15 = (
        12.0 * attenuation_epsilon * shortfall_epsilon * term_2
        - 112.0 * attenuation_epsilon * product_5 * product_6 * shortfall_epsilon
        - 112.0 * attenuation_epsilon * product_8 * product_9 * shortfall_epsilon
        - 112.0 * attenuation_epsilon_squared * product_5 * product_6
        - 112.0 * attenuation_epsilon_squared * product_8 * product_9
        - 140.0 * attenuation_beta_squared_squared * attenuation_epsilon * shortfall_beta_squared_squared * shortfall_epsilon
        - 140.0 * attenuation_beta_squared_squared * attenuation_epsilon_squared * shortfall_beta_squared_squared
        - 16.0 * attenuation_beta * attenuation_epsilon * product_10 * shortfall_epsilon
        - 16.0 * attenuation_beta * attenuation_epsilon_squared * product_10
        - 2.0 * attenuation_epsilon * shortfall_epsilon * term_4
        - 2.0 * attenuation_epsilon_squared * term_4
        - 24.0 * attenuation_epsilon * product_11 * shortfall_beta * shortfall_epsilon
        - 24.0 * attenuation_epsilon_squared * product_11 * shortfall_beta
        - 28.0 * attenuation_beta_squared * shortfall_beta_squared_cubed * shortfall_epsilon_squared
        - 28.0 * attenuation_beta_squared_cubed * shortfall_beta_squared * shortfall_epsilon_squared
        - 56.0 * attenuation_beta_squared * attenuation_epsilon * shortfall_beta_squared_cubed * shortfall_epsilon
        - 56.0 * attenuation_beta_squared * attenuation_epsilon_squared * shortfall_beta_squared_cubed
        - 56.0 * product_5 * product_6 * shortfall_epsilon_squared
        - 56.0 * product_8 * product_9 * shortfall_epsilon_squared
        - 60.0 * attenuation_beta_squared_cubed * attenuation_epsilon * shortfall_beta_squared * shortfall_epsilon
        - 60.0 * attenuation_beta_squared_cubed * attenuation_epsilon_squared * shortfall_beta_squared
        - 70.0 * attenuation_beta_squared_squared * shortfall_beta_squared_squared * shortfall_epsilon_squared
        - 8.0 * attenuation_beta * product_10 * shortfall_epsilon_squared
        - 8.0 * product_11 * shortfall_beta * shortfall_epsilon_squared
        - shortfall_epsilon_squared * term_4
        + 12.0 * attenuation_epsilon_squared * term_2
        + 8.0 * shortfall_epsilon_squared * term_2
    )
    sum_16 = (
        1.0
        + attenuation_epsilon_squared
        + attenuation_epsilon_squared * term_2
        + product_12
        + product_3
        + term_2
    )
    sum_17 = (
        2.0
        + 2.0 * attenuation_epsilon_squared
        + 2.0 * attenuation_epsilon_squared * term_2
        + 2.0 * term_2
        + product_12
        + product_3
    )
    part_00_sin_beta2_sin_epsilon2 = (
        0.25 * r_squared * shortfall_epsilon * sum_16 * sum_6 * term_1 * term_3
        - 0.25 * rho_squared * shortfall_epsilon * sigma_beta_squared * sigma_r_squared * sum_15 * sum_6 * term_1 * term_3
        + 0.25 * shortfall_epsilon * sigma_r_squared * sum_17 * sum_6 * term_1 * term_3
    )
    product_13 = -2.0 * attenuation_beta * attenuation_epsilon * product_7 * shortfall_beta
    product_14 = -2.0 * attenuation_epsilon_squared_squared * shortfall_beta_squared
    product_15 = -3.0 * attenuation_epsilon_squared * shortfall_beta_squared * shortfall_epsilon_squared
    product_16 = -4.0 * attenuation_beta * attenuation_epsilon_squared_squared * shortfall_beta
    product_17 = -4.0 * product_2 * shortfall_beta_squared * shortfall_epsilon
    product_18 = -6.0 * attenuation_beta * attenuation_epsilon_squared * shortfall_beta * shortfall_epsilon_squared
    product_19 = -8.0 * attenuation_beta * product_2 * shortfall_beta * shortfall_epsilon
    product_20 = -attenuation_epsilon * product_7 * shortfall_beta_squared
    sum_18 = (
        3.0 * attenuation_beta_squared * attenuation_epsilon * product_7
        + 3.0 * attenuation_beta_squared * attenuation_epsilon_squared * shortfall_epsilon_squared
        + attenuation_beta_squared * shortfall_epsilon_squared_squared
        + product_13
        + product_14
        + product_15
        + product_16
        + product_17
        + product_18
        + product_19
        + product_20
    )
    sum_19 = (
        12.0 * attenuation_epsilon_squared * shortfall_beta_squared * shortfall_epsilon_squared
        - 10.0 * attenuation_beta_squared * attenuation_epsilon_squared_squared
        - 20.0 * attenuation_beta_squared * product_2 * shortfall_epsilon
        - 32.0 * attenuation_beta_squared * attenuation_epsilon * product_7
        - 42.0 * attenuation_beta_squared * attenuation_epsilon_squared * shortfall_epsilon_squared
        - 9.0 * attenuation_beta_squared * shortfall_epsilon_squared_squared
        + 16.0 * attenuation_beta * attenuation_epsilon_squared_squared * shortfall_beta
        + 16.0 * product_2 * shortfall_beta_squared * shortfall_epsilon
        + 24.0 * attenuation_beta * attenuation_epsilon_squared * shortfall_beta * shortfall_epsilon_squared
        + 32.0 * attenuation_beta * product_2 * shortfall_beta * shortfall_epsilon
        + 4.0 * attenuation_epsilon * product_7 * shortfall_beta_squared
        + 8.0 * attenuation_beta * attenuation_epsilon * product_7 * shortfall_beta
        + 8.0 * attenuation_epsilon_squared_squared * shortfall_beta_squared
    )
    product_21 = 2.0 * attenuation_beta_squared * attenuation_epsilon_squared_squared
    product_22 = 4.0 * attenuation_beta_squared * product_2 * shortfall_epsilon
    sum_20 = (
        2.0 * attenuation_beta_squared * shortfall_epsilon_squared_squared
        + 7.0 * attenuation_beta_squared * attenuation_epsilon * product_7
        + 9.0 * attenuation_beta_squared * attenuation_epsilon_squared * shortfall_epsilon_squared
        + product_13
        + product_14
        + product_15
        + product_16
        + product_17
        + product_18
        + product_19
        + product_20
        + product_21
        + product_22
    )
    part_01_cos_beta_cos_epsilon2_sin_beta = (
        0.5 * attenuation_beta_squared_squared * r_squared * sum_18 * term_1
        + 0.5 * attenuation_beta_squared_squared * rho_squared * sigma_beta_squared * sigma_r_squared * sum_19 * term_1
        + 0.5 * attenuation_beta_squared_squared * sigma_r_squared * sum_20 * term_1
    )
    product_23 = -2.0 * attenuation_beta * attenuation_epsilon * shortfall_beta * shortfall_epsilon_squared
    product_24 = -2.0 * product_2 * shortfall_beta_squared
    product_25 = -3.0 * attenuation_epsilon_squared * shortfall_beta_squared * shortfall_epsilon
    product_26 = -4.0 * attenuation_beta * product_2 * shortfall_beta
    product_27 = -6.0 * attenuation_beta * attenuation_epsilon_squared * shortfall_beta * shortfall_epsilon
    product_28 = -attenuation_epsilon * shortfall_beta_squared * shortfall_epsilon_squared
    sum_21 = (
        2.0 * attenuation_beta_squared * product_2
        + 3.0 * attenuation_beta_squared * attenuation_epsilon * shortfall_epsilon_squared
        + 3.0 * attenuation_beta_squared * attenuation_epsilon_squared * shortfall_epsilon
        + attenuation_beta_squared * product_7
        + product_23
        + product_24
        + product_25
        + product_26
        + product_27
        + product_28
    )
    sum_22 = (
        12.0 * attenuation_epsilon_squared * shortfall_beta_squared * shortfall_epsilon
        - 28.0 * attenuation_beta_squared * product_2
        - 32.0 * attenuation_beta_squared * attenuation_epsilon * shortfall_epsilon_squared
        - 42.0 * attenuation_beta_squared * attenuation_epsilon_squared * shortfall_epsilon
        - 9.0 * attenuation_beta_squared * product_7
        + 16.0 * attenuation_beta * product_2 * shortfall_beta
        + 24.0 * attenuation_beta * attenuation_epsilon_squared * shortfall_beta * shortfall_epsilon
        + 4.0 * attenuation_epsilon * shortfall_beta_squared * shortfall_epsilon_squared
        + 8.0 * attenuation_beta * attenuation_epsilon * shortfall_beta * shortfall_epsilon_squared
        + 8.0 * product_2 * shortfall_beta_squared
    )
    sum_23 = (
        2.0 * attenuation_beta_squared * product_7
        + 6.0 * attenuation_beta_squared * product_2
        + 7.0 * attenuation_beta_squared * attenuation_epsilon * shortfall_epsilon_squared
        + 9.0 * attenuation_beta_squared * attenuation_epsilon_squared * shortfall_epsilon
        + product_23
        + product_24
        + product_25
        + product_26
        + product_27
        + product_28
    )
    part_01_cos_beta_sin_beta_sin_epsilon2 = (
        0.5 * attenuation_beta_squared_squared * r_squared * shortfall_epsilon * sum_21 * term_1
        + 0.5 * attenuation_beta_squared_squared * rho_squared * shortfall_epsilon * sigma_beta_squared * sigma_r_squared * sum_22 * term_1
        + 0.5 * attenuation_beta_squared_squared * shortfall_epsilon * sigma_r_squared * sum_23 * term_1
    )
    sum_24 = shortfall_epsilon - attenuation_epsilon
    sum_25 = attenuation_epsilon - shortfall_epsilon
    part_02_cos_epsilon_sin_beta_sin_epsilon = (
        attenuation_beta * attenuation_epsilon_squared * rho_squared * sigma_beta_squared * sigma_r_squared * sum_24
        - attenuation_beta * attenuation_epsilon_squared * r_squared * shortfall_epsilon
        + attenuation_beta * attenuation_epsilon_squared * sigma_r_squared * sum_25
    )
    sum_26 = 2.0 + 2.0 * product_2 + attenuation_epsilon + attenuation_epsilon_squared
    part_22_cos_epsilon2 = (
        0.5 * (1.0 + product_2) * r_squared * shortfall_epsilon * term_1
        + 0.5 * shortfall_epsilon * sigma_r_squared * sum_26 * term_1
    )
    sum_27 = 1.0 + attenuation_epsilon + attenuation_epsilon_squared
    sum_28 = 2.0 - attenuation_epsilon - product_2 + 2.0 * attenuation_epsilon_squared_squared
    part_22_sin_epsilon2 = (
        0.5 * r_squared * shortfall_epsilon_squared * sum_27 * term_1
        + 0.5 * sigma_r_squared * sum_28 * term_1
    )
    sum_29 = (
        10.0 * attenuation_beta_squared * attenuation_epsilon * product_7
        - 12.0 * attenuation_beta * attenuation_epsilon_squared * shortfall_beta * shortfall_epsilon_squared
        - 16.0 * attenuation_beta * product_2 * shortfall_beta * shortfall_epsilon
        - 2.0 * attenuation_epsilon * product_7 * shortfall_beta_squared
        - 4.0 * attenuation_beta * attenuation_epsilon * product_7 * shortfall_beta
        - 4.0 * attenuation_epsilon_squared_squared * shortfall_beta_squared
        - 6.0 * attenuation_epsilon_squared * shortfall_beta_squared * shortfall_epsilon_squared
        - 8.0 * attenuation_beta * attenuation_epsilon_squared_squared * shortfall_beta
        - 8.0 * product_2 * shortfall_beta_squared * shortfall_epsilon
        + 12.0 * attenuation_beta_squared * attenuation_epsilon_squared * shortfall_epsilon_squared
        + 3.0 * attenuation_beta_squared * shortfall_epsilon_squared_squared
        + product_21
        + product_22
    )
    cos_epsilon_squared = cos_epsilon**2
    sum_30 = (
        10.0 * attenuation_beta_squared * attenuation_epsilon * shortfall_epsilon_squared
        - 12.0 * attenuation_beta * attenuation_epsilon_squared * shortfall_beta * shortfall_epsilon
        - 2.0 * attenuation_epsilon * shortfall_beta_squared * shortfall_epsilon_squared
        - 4.0 * attenuation_beta * attenuation_epsilon * shortfall_beta * shortfall_epsilon_squared
        - 4.0 * product_2 * shortfall_beta_squared
        - 6.0 * attenuation_epsilon_squared * shortfall_beta_squared * shortfall_epsilon
        - 8.0 * attenuation_beta * product_2 * shortfall_beta
        + 12.0 * attenuation_beta_squared * attenuation_epsilon_squared * shortfall_epsilon
        + 3.0 * attenuation_beta_squared * product_7
        + 8.0 * attenuation_beta_squared * product_2
    )
    sin_epsilon_squared = sin_epsilon**2
    cos_beta_squared = cos_beta**2
    sin_beta_squared = sin_beta**2
    sum_31 = (
        12.0 * attenuation_beta * attenuation_epsilon_squared * shortfall_beta * shortfall_epsilon_squared
        - 10.0 * attenuation_beta_squared * attenuation_epsilon * product_7
        - 12.0 * attenuation_beta_squared * attenuation_epsilon_squared * shortfall_epsilon_squared
        - 2.0 * attenuation_beta_squared * attenuation_epsilon_squared_squared
        - 3.0 * attenuation_beta_squared * shortfall_epsilon_squared_squared
        - 4.0 * attenuation_beta_squared * product_2 * shortfall_epsilon
        + 16.0 * attenuation_beta * product_2 * shortfall_beta * shortfall_epsilon
        + 2.0 * attenuation_epsilon * product_7 * shortfall_beta_squared
        + 4.0 * attenuation_beta * attenuation_epsilon * product_7 * shortfall_beta
        + 4.0 * attenuation_epsilon_squared_squared * shortfall_beta_squared
        + 6.0 * attenuation_epsilon_squared * shortfall_beta_squared * shortfall_epsilon_squared
        + 8.0 * attenuation_beta * attenuation_epsilon_squared_squared * shortfall_beta
        + 8.0 * product_2 * shortfall_beta_squared * shortfall_epsilon
    )
    sum_32 = (
        12.0 * attenuation_beta * attenuation_epsilon_squared * shortfall_beta * shortfall_epsilon
        - 10.0 * attenuation_beta_squared * attenuation_epsilon * shortfall_epsilon_squared
        - 12.0 * attenuation_beta_squared * attenuation_epsilon_squared * shortfall_epsilon
        - 3.0 * attenuation_beta_squared * product_7
        - 8.0 * attenuation_beta_squared * product_2
        + 2.0 * attenuation_epsilon * shortfall_beta_squared * shortfall_epsilon_squared
        + 4.0 * attenuation_beta * attenuation_epsilon * shortfall_beta * shortfall_epsilon_squared
        + 4.0 * product_2 * shortfall_beta_squared
        + 6.0 * attenuation_epsilon_squared * shortfall_beta_squared * shortfall_epsilon
        + 8.0 * attenuation_beta * product_2 * shortfall_beta
    )
    sum_33 = attenuation_epsilon - 2.0 * shortfall_epsilon
    sum_34 = 2.0 * shortfall_epsilon - attenuation_epsilon
    result = _empty(arguments, (3, 3))
    result[..., 0, 0] = (
        attenuation_beta_squared_squared * cos_beta * cos_epsilon_squared * r * rho * sigma_beta * sigma_r * sin_beta * sum_29 * term_1
        + attenuation_beta_squared_squared * cos_beta * r * rho * shortfall_epsilon * sigma_beta * sigma_r * sin_beta * sin_epsilon_squared * sum_30 * term_1
        + cos_beta_squared * cos_epsilon_squared * part_00_cos_beta2_cos_epsilon2
        + cos_beta_squared * part_00_cos_beta2_sin_epsilon2 * sin_epsilon_squared
        + cos_epsilon_squared * part_00_cos_epsilon2_sin_beta2 * sin_beta_squared
        + part_00_sin_beta2_sin_epsilon2 * sin_beta_squared * sin_epsilon_squared
    )
    result[..., 0, 1] = (
        0.5 * attenuation_beta_squared_squared * cos_beta_squared * cos_epsilon_squared * r * rho * sigma_beta * sigma_r * sum_29 * term_1
        + 0.5 * attenuation_beta_squared_squared * cos_beta_squared * r * rho * shortfall_epsilon * sigma_beta * sigma_r * sin_epsilon_squared * sum_30 * term_1
        + 0.5 * attenuation_beta_squared_squared * cos_epsilon_squared * r * rho * sigma_beta * sigma_r * sin_beta_squared * sum_31 * term_1
        + 0.5 * attenuation_beta_squared_squared * r * rho * shortfall_epsilon * sigma_beta * sigma_r * sin_beta_squared * sin_epsilon_squared * sum_32 * term_1
        + cos_beta * cos_epsilon_squared * part_01_cos_beta_cos_epsilon2_sin_beta * sin_beta
        + cos_beta * part_01_cos_beta_sin_beta_sin_epsilon2 * sin_beta * sin_epsilon_squared
    )
    result[..., 0, 2] = (
        attenuation_beta * attenuation_epsilon_squared * cos_beta * cos_epsilon * r * rho * sigma_beta * sigma_r * sin_epsilon * sum_33
        + cos_epsilon * part_02_cos_epsilon_sin_beta_sin_epsilon * sin_beta * sin_epsilon
    )
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = (
        attenuation_beta_squared_squared * cos_beta * cos_epsilon_squared * r * rho * sigma_beta * sigma_r * sin_beta * sum_31 * term_1
        + attenuation_beta_squared_squared * cos_beta * r * rho * shortfall_epsilon * sigma_beta * sigma_r * sin_beta * sin_epsilon_squared * sum_32 * term_1
        + cos_beta_squared * cos_epsilon_squared * part_00_cos_epsilon2_sin_beta2
        + cos_beta_squared * part_00_sin_beta2_sin_epsilon2 * sin_epsilon_squared
        + cos_epsilon_squared * part_00_cos_beta2_cos_epsilon2 * sin_beta_squared
        + part_00_cos_beta2_sin_epsilon2 * sin_beta_squared * sin_epsilon_squared
    )
    result[..., 1, 2] = (
        attenuation_beta * attenuation_epsilon_squared * cos_epsilon * r * rho * sigma_beta * sigma_r * sin_beta * sin_epsilon * sum_34
        + cos_beta * cos_epsilon * part_02_cos_epsilon_sin_beta_sin_epsilon * sin_epsilon
    )
    result[..., 2, 0] = result[..., 0, 2]
    result[..., 2, 1] = result[..., 1, 2]
    result[..., 2, 2] = (
        cos_epsilon_squared * part_22_cos_epsilon2
        + part_22_sin_epsilon2 * sin_epsilon_squared
    )
    return result
