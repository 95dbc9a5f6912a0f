"""NumPy functions of the quantities spherical.*.

Written by radartrack regenerate, generator 1, derivation ea10d1083c3754bb; not to be edited.
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

    Accuracy: at most 110 ulp anywhere in this domain with independent errors, proved for elementary functions
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
    product_1 = attenuation_beta_squared * attenuation_epsilon_squared
    shortfall_epsilon_squared = shortfall_epsilon**2
    product_2 = attenuation_beta_squared * shortfall_epsilon_squared
    sum_1 = (
        attenuation_beta_squared * attenuation_epsilon * shortfall_epsilon
        - 2.0 * attenuation_beta * attenuation_epsilon * shortfall_beta * shortfall_epsilon
        - 2.0 * attenuation_beta * attenuation_epsilon_squared * shortfall_beta
        - attenuation_epsilon * shortfall_beta_squared * shortfall_epsilon
        - attenuation_epsilon_squared * shortfall_beta_squared
        + product_1
        + product_2
    )
    rho_squared = rho**2
    sigma_r_squared = sigma_r**2
    product_3 = attenuation_beta * attenuation_beta_squared
    sum_2 = (
        1.0
        + attenuation_beta
        + attenuation_beta * attenuation_epsilon_squared
        + attenuation_beta_squared
        + attenuation_epsilon_squared
        + attenuation_epsilon_squared * product_3
        + product_1
        + product_3
    )
    r_squared = r**2
    part_00_cos_beta2_cos_epsilon2 = (
        attenuation_beta_squared * rho_squared * sigma_beta_squared * sigma_r_squared * sum_1
        + 0.25 * r_squared * shortfall_beta * sum_2
        + 0.25 * shortfall_beta * sigma_r_squared * sum_2
    )
    attenuation_beta_squared_squared = attenuation_beta_squared**2
    sum_3 = 1.0 + attenuation_epsilon
    sum_4 = (
        1.0
        + attenuation_beta
        + attenuation_beta * attenuation_epsilon
        + attenuation_beta_squared
        + attenuation_beta_squared * attenuation_epsilon
        + attenuation_epsilon
        + attenuation_epsilon * product_3
        + product_3
    )
    part_00_cos_beta2_sin_epsilon2 = (
        attenuation_beta_squared_squared * rho_squared * shortfall_epsilon * sigma_beta_squared * sigma_r_squared * sum_3
        + 0.25 * r_squared * shortfall_beta * shortfall_epsilon * sum_4
        + 0.25 * shortfall_beta * shortfall_epsilon * sigma_r_squared * sum_4
    )
    sum_5 = -1.0 - attenuation_epsilon_squared
    product_4 = shortfall_beta * shortfall_beta_squared
    shortfall_beta_squared_squared = shortfall_beta_squared**2
    sum_6 = (
        2.0 * attenuation_beta * attenuation_epsilon * product_4 * shortfall_epsilon
        + 2.0 * attenuation_beta * attenuation_epsilon_squared * product_4
        + 2.0 * attenuation_beta_squared * attenuation_epsilon * shortfall_beta_squared * shortfall_epsilon
        + 2.0 * attenuation_beta_squared * attenuation_epsilon_squared * shortfall_beta_squared
        + 1.5 * attenuation_beta_squared * shortfall_beta_squared * shortfall_epsilon_squared
        + attenuation_beta * product_4 * shortfall_epsilon_squared
        + 0.5 * attenuation_beta_squared_squared * shortfall_epsilon_squared
        + 0.5 * attenuation_epsilon * shortfall_beta_squared_squared * shortfall_epsilon
        + 0.5 * attenuation_epsilon_squared * shortfall_beta_squared_squared
        + product_3 * shortfall_beta * shortfall_epsilon_squared
        + 0.25 * shortfall_beta_squared_squared * shortfall_epsilon_squared
    )
    sum_7 = (
        0.25
        + 0.25 * attenuation_beta_squared_squared * attenuation_epsilon_squared
        + 0.25 * attenuation_beta_squared_squared
        + 0.25 * attenuation_epsilon_squared
    )
    part_00_cos_epsilon2_sin_beta2 = (
        attenuation_beta_squared_squared * rho_squared * sigma_beta_squared * sigma_r_squared * sum_5
        + r_squared * sum_6
        + sigma_r_squared * sum_7
    )
    sum_8 = -1.0 - attenuation_epsilon
    sum_9 = (
        1.0
        + attenuation_beta_squared_squared
        + attenuation_beta_squared_squared * attenuation_epsilon
        + attenuation_epsilon
    )
    part_00_sin_beta2_sin_epsilon2 = (
        attenuation_beta_squared_squared * rho_squared * shortfall_epsilon * sigma_beta_squared * sigma_r_squared * sum_8
        + 0.25 * r_squared * shortfall_epsilon * sum_9
        + 0.25 * shortfall_epsilon * sigma_r_squared * sum_9
    )
    sum_10 = (
        product_2
        - 2.0 * attenuation_epsilon * shortfall_beta_squared * shortfall_epsilon
        - 2.0 * attenuation_epsilon_squared * shortfall_beta_squared
        - 4.0 * attenuation_beta * attenuation_epsilon * shortfall_beta * shortfall_epsilon
        - 4.0 * attenuation_beta * attenuation_epsilon_squared * shortfall_beta
    )
    product_5 = 2.0 * attenuation_beta * attenuation_epsilon_squared * shortfall_beta
    product_6 = 2.0 * attenuation_beta * attenuation_epsilon * shortfall_beta * shortfall_epsilon
    product_7 = attenuation_epsilon_squared * shortfall_beta_squared
    product_8 = attenuation_epsilon * shortfall_beta_squared * shortfall_epsilon
    sum_11 = (
        product_5
        - 2.0 * attenuation_beta_squared * shortfall_epsilon_squared
        - 3.0 * attenuation_beta_squared * attenuation_epsilon * shortfall_epsilon
        - 3.0 * attenuation_beta_squared * attenuation_epsilon_squared
        + product_6
        + product_7
        + product_8
    )
    sum_12 = 1.0 + attenuation_epsilon_squared
    part_01_cos_beta_cos_epsilon2_sin_beta = (
        0.5 * attenuation_beta_squared * r_squared * sum_10
        + attenuation_beta_squared * rho_squared * sigma_beta_squared * sigma_r_squared * sum_11
        + 0.5 * attenuation_beta_squared_squared * sigma_r_squared * sum_12
    )
    part_01_cos_beta_sin_beta_sin_epsilon2 = (
        2.0 * attenuation_beta_squared_squared * rho_squared * shortfall_epsilon * sigma_beta_squared * sigma_r_squared * sum_8
        + 0.5 * attenuation_beta_squared_squared * r_squared * shortfall_epsilon * sum_3
        + 0.5 * attenuation_beta_squared_squared * shortfall_epsilon * sigma_r_squared * sum_3
    )
    part_02_cos_epsilon_sin_beta_sin_epsilon = (
        attenuation_beta * attenuation_epsilon_squared * sigma_r_squared
        - attenuation_beta * attenuation_epsilon * r_squared * shortfall_epsilon
        - attenuation_beta * attenuation_epsilon_squared * rho_squared * sigma_beta_squared * sigma_r_squared
    )
    part_22_cos_epsilon2 = (
        0.5 * r_squared * shortfall_epsilon * sum_3
        + 0.5 * shortfall_epsilon * sigma_r_squared * sum_3
    )
    sum_13 = 0.5 + 0.5 * attenuation_epsilon_squared
    part_22_sin_epsilon2 = 0.5 * r_squared * shortfall_epsilon_squared + sigma_r_squared * sum_13
    cos_epsilon_squared = cos_epsilon**2
    sin_epsilon_squared = sin_epsilon**2
    cos_beta_squared = cos_beta**2
    sin_beta_squared = sin_beta**2
    sum_14 = (
        product_5
        - attenuation_beta_squared * attenuation_epsilon * shortfall_epsilon
        - attenuation_beta_squared * attenuation_epsilon_squared
        - attenuation_beta_squared * shortfall_epsilon_squared
        + product_6
        + product_7
        + product_8
    )
    sum_15 = attenuation_epsilon - shortfall_epsilon
    sum_16 = shortfall_epsilon - attenuation_epsilon
    result = _empty(arguments, (3, 3))
    result[..., 0, 0] = (
        2.0 * attenuation_beta_squared * cos_beta * cos_epsilon_squared * r * rho * sigma_beta * sigma_r * sin_beta * sum_1
        + 2.0 * attenuation_beta_squared_squared * cos_beta * r * rho * shortfall_epsilon * sigma_beta * sigma_r * sin_beta * sin_epsilon_squared * sum_3
        + cos_beta_squared * cos_epsilon_squared * part_00_cos_beta2_cos_epsilon2
        + cos_beta_squared * part_00_cos_beta2_sin_epsilon2 * sin_epsilon_squared
        + cos_epsilon_squared * part_00_cos_epsilon2_sin_beta2 * sin_beta_squared
        + part_00_sin_beta2_sin_epsilon2 * sin_beta_squared * sin_epsilon_squared
    )
    result[..., 0, 1] = (
        attenuation_beta_squared * cos_beta_squared * cos_epsilon_squared * r * rho * sigma_beta * sigma_r * sum_1
        + attenuation_beta_squared * cos_epsilon_squared * r * rho * sigma_beta * sigma_r * sin_beta_squared * sum_14
        + attenuation_beta_squared_squared * cos_beta_squared * r * rho * shortfall_epsilon * sigma_beta * sigma_r * sin_epsilon_squared * sum_3
        + attenuation_beta_squared_squared * r * rho * shortfall_epsilon * sigma_beta * sigma_r * sin_beta_squared * sin_epsilon_squared * sum_8
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
        + 2.0 * attenuation_beta_squared_squared * cos_beta * r * rho * shortfall_epsilon * sigma_beta * sigma_r * sin_beta * sin_epsilon_squared * sum_8
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

    Accuracy: at most 668 ulp anywhere in this domain with independent errors, proved for elementary functions
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
    product_13 = -attenuation_beta_squared * attenuation_epsilon
    product_14 = -attenuation_beta_squared * product_2
    product_15 = -attenuation_beta * attenuation_epsilon
    product_16 = -attenuation_beta * product_2
    r_squared = r**2
    sum_2 = (
        1.0
        + attenuation_beta
        + attenuation_beta * attenuation_epsilon_squared_squared
        + attenuation_beta_squared
        + attenuation_beta_squared * attenuation_epsilon_squared_squared
        + attenuation_epsilon_squared_squared
        + attenuation_epsilon_squared_squared * product_12
        + product_12
        + product_13
        + product_14
        + product_15
        + product_16
    )
    product_17 = 2.0 * attenuation_beta * attenuation_epsilon_squared_squared
    sum_3 = (
        2.0
        + 2.0 * attenuation_beta
        + 2.0 * attenuation_beta_squared
        + 2.0 * attenuation_beta_squared * attenuation_epsilon_squared_squared
        + 2.0 * attenuation_epsilon_squared_squared
        + 2.0 * attenuation_epsilon_squared_squared * product_12
        + 2.0 * product_12
        + product_13
        + product_14
        + product_15
        + product_16
        + product_17
    )
    part_00_cos_beta2_cos_epsilon2 = (
        0.25 * attenuation_beta * rho_squared * sigma_beta_squared * sigma_r_squared * sum_1
        + 0.25 * r_squared * shortfall_beta * sum_2
        + 0.25 * shortfall_beta * sigma_r_squared * sum_3
    )
    sum_4 = (
        16.0 * product_1 * product_12
        - 12.0 * attenuation_beta_squared * attenuation_epsilon * shortfall_beta * shortfall_epsilon_squared
        - 2.0 * product_2 * product_4
        - 24.0 * attenuation_beta_squared * product_2 * shortfall_beta
        - 3.0 * attenuation_beta * attenuation_epsilon * shortfall_beta_squared * shortfall_epsilon_squared
        - 3.0 * attenuation_epsilon_squared * product_4 * shortfall_epsilon
        - 36.0 * attenuation_beta_squared * attenuation_epsilon_squared * shortfall_beta * shortfall_epsilon
        - 6.0 * attenuation_beta * product_2 * shortfall_beta_squared
        - 9.0 * attenuation_beta * attenuation_epsilon_squared * shortfall_beta_squared * shortfall_epsilon
        - attenuation_epsilon * product_4 * shortfall_epsilon_squared
        + 44.0 * product_12 * product_2
        + 54.0 * attenuation_epsilon * product_12 * shortfall_epsilon_squared
        + 66.0 * attenuation_epsilon_squared * product_12 * shortfall_epsilon
    )
    sum_5 = (
        1.0
        + attenuation_beta
        + attenuation_beta * product_2
        + attenuation_beta_squared
        + attenuation_beta_squared * product_2
        + attenuation_epsilon
        + attenuation_epsilon * product_12
        + attenuation_epsilon_squared
        + attenuation_epsilon_squared * product_12
        + product_12
        + product_12 * product_2
        + product_2
    )
    product_18 = 2.0 * attenuation_beta * product_2
    sum_6 = (
        2.0
        + 2.0 * attenuation_beta
        + 2.0 * attenuation_beta_squared
        + 2.0 * attenuation_beta_squared * product_2
        + 2.0 * attenuation_epsilon
        + 2.0 * attenuation_epsilon * product_12
        + 2.0 * attenuation_epsilon_squared
        + 2.0 * attenuation_epsilon_squared * product_12
        + 2.0 * product_12
        + 2.0 * product_12 * product_2
        + 2.0 * product_2
        + attenuation_beta * attenuation_epsilon
        + attenuation_beta * attenuation_epsilon_squared
        + attenuation_beta_squared * attenuation_epsilon
        + attenuation_beta_squared * attenuation_epsilon_squared
        + product_18
    )
    part_00_cos_beta2_sin_epsilon2 = (
        0.25 * attenuation_beta * rho_squared * shortfall_epsilon * sigma_beta_squared * sigma_r_squared * sum_4
        + 0.25 * r_squared * shortfall_beta * shortfall_epsilon * sum_5
        + 0.25 * shortfall_beta * shortfall_epsilon * sigma_r_squared * sum_6
    )
    sum_7 = (
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
    sum_8 = (
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
    sum_9 = (
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
        0.25 * attenuation_beta * rho_squared * sigma_beta_squared * sigma_r_squared * sum_7
        + r_squared * sum_8
        + sigma_r_squared * sum_9
    )
    sum_10 = (
        9.0 * attenuation_beta_squared * attenuation_epsilon
        - 16.0 * attenuation_epsilon * product_12
        - 16.0 * attenuation_epsilon_squared * product_12
        - 16.0 * product_12
        - 16.0 * product_12 * product_2
        - attenuation_epsilon
        - attenuation_epsilon_squared
        + 9.0 * attenuation_beta_squared * attenuation_epsilon_squared
    )
    product_19 = -attenuation_epsilon * product_12
    product_20 = -attenuation_epsilon_squared * product_12
    product_21 = -attenuation_beta * attenuation_epsilon_squared
    sum_11 = (
        1.0
        + attenuation_beta_squared_squared
        + attenuation_beta_squared_squared * attenuation_epsilon
        + attenuation_beta_squared_squared * attenuation_epsilon_squared
        + attenuation_beta_squared_squared * product_2
        + attenuation_epsilon
        + attenuation_epsilon_squared
        + product_15
        + product_19
        + product_2
        + product_20
        + product_21
    )
    sum_12 = (
        2.0
        + 2.0 * attenuation_beta_squared_squared
        + 2.0 * attenuation_beta_squared_squared * attenuation_epsilon
        + 2.0 * attenuation_beta_squared_squared * attenuation_epsilon_squared
        + 2.0 * attenuation_beta_squared_squared * product_2
        + 2.0 * attenuation_epsilon
        + 2.0 * attenuation_epsilon_squared
        + 2.0 * product_2
        + product_15
        + product_19
        + product_20
        + product_21
    )
    part_00_sin_beta2_sin_epsilon2 = (
        0.25 * attenuation_beta * rho_squared * shortfall_epsilon * sigma_beta_squared * sigma_r_squared * sum_10
        + 0.25 * r_squared * shortfall_epsilon * sum_11
        + 0.25 * shortfall_epsilon * sigma_r_squared * sum_12
    )
    product_22 = -2.0 * attenuation_epsilon_squared_squared * shortfall_beta
    product_23 = -3.0 * attenuation_epsilon_squared * shortfall_beta * shortfall_epsilon_squared
    product_24 = -4.0 * product_2 * shortfall_beta * shortfall_epsilon
    product_25 = -attenuation_epsilon * product_1 * shortfall_beta
    sum_13 = (
        3.0 * attenuation_beta * attenuation_epsilon * product_1
        + 3.0 * attenuation_beta * attenuation_epsilon_squared * shortfall_epsilon_squared
        + attenuation_beta * shortfall_epsilon_squared_squared
        + product_22
        + product_23
        + product_24
        + product_25
    )
    sum_14 = (
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
    product_26 = 4.0 * attenuation_beta * product_2 * shortfall_epsilon
    sum_15 = (
        2.0 * attenuation_beta * shortfall_epsilon_squared_squared
        + 7.0 * attenuation_beta * attenuation_epsilon * product_1
        + 9.0 * attenuation_beta * attenuation_epsilon_squared * shortfall_epsilon_squared
        + product_17
        + product_22
        + product_23
        + product_24
        + product_25
        + product_26
    )
    part_01_cos_beta_cos_epsilon2_sin_beta = (
        0.5 * product_12 * r_squared * sum_13
        + 0.5 * product_12 * rho_squared * sigma_beta_squared * sigma_r_squared * sum_14
        + 0.5 * product_12 * sigma_r_squared * sum_15
    )
    product_27 = -2.0 * product_2 * shortfall_beta
    product_28 = -3.0 * attenuation_epsilon_squared * shortfall_beta * shortfall_epsilon
    product_29 = -attenuation_epsilon * shortfall_beta * shortfall_epsilon_squared
    sum_16 = (
        3.0 * attenuation_beta * attenuation_epsilon * shortfall_epsilon_squared
        + 3.0 * attenuation_beta * attenuation_epsilon_squared * shortfall_epsilon
        + attenuation_beta * product_1
        + product_18
        + product_27
        + product_28
        + product_29
    )
    sum_17 = (
        18.0 * product_2 * shortfall_beta
        - 16.0 * attenuation_beta * product_1
        - 46.0 * attenuation_beta * product_2
        - 55.0 * attenuation_beta * attenuation_epsilon * shortfall_epsilon_squared
        - 69.0 * attenuation_beta * attenuation_epsilon_squared * shortfall_epsilon
        + 27.0 * attenuation_epsilon_squared * shortfall_beta * shortfall_epsilon
        + 9.0 * attenuation_epsilon * shortfall_beta * shortfall_epsilon_squared
    )
    sum_18 = (
        2.0 * attenuation_beta * product_1
        + 6.0 * attenuation_beta * product_2
        + 7.0 * attenuation_beta * attenuation_epsilon * shortfall_epsilon_squared
        + 9.0 * attenuation_beta * attenuation_epsilon_squared * shortfall_epsilon
        + product_27
        + product_28
        + product_29
    )
    part_01_cos_beta_sin_beta_sin_epsilon2 = (
        0.5 * product_12 * r_squared * shortfall_epsilon * sum_16
        + 0.5 * product_12 * rho_squared * shortfall_epsilon * sigma_beta_squared * sigma_r_squared * sum_17
        + 0.5 * product_12 * shortfall_epsilon * sigma_r_squared * sum_18
    )
    sum_19 = shortfall_epsilon - attenuation_epsilon
    sum_20 = attenuation_epsilon - shortfall_epsilon
    part_02_cos_epsilon_sin_beta_sin_epsilon = (
        2.0 * attenuation_beta * product_2 * rho_squared * sigma_beta_squared * sigma_r_squared * sum_19
        - attenuation_beta * product_2 * r_squared * shortfall_epsilon
        + attenuation_beta * product_2 * sigma_r_squared * sum_20
    )
    sum_21 = 2.0 + 2.0 * product_2 + attenuation_epsilon + attenuation_epsilon_squared
    part_22_cos_epsilon2 = (
        0.5 * (1.0 + product_2) * r_squared * shortfall_epsilon
        + 0.5 * shortfall_epsilon * sigma_r_squared * sum_21
    )
    sum_22 = 1.0 + attenuation_epsilon + attenuation_epsilon_squared
    sum_23 = 1.0 - 0.5 * attenuation_epsilon - 0.5 * product_2 + attenuation_epsilon_squared_squared
    part_22_sin_epsilon2 = 0.5 * r_squared * shortfall_epsilon_squared * sum_22 + sigma_r_squared * sum_23
    sum_24 = (
        13.0 * attenuation_beta * attenuation_epsilon * product_1
        - 12.0 * product_2 * shortfall_beta * shortfall_epsilon
        - 3.0 * attenuation_epsilon * product_1 * shortfall_beta
        - 6.0 * attenuation_epsilon_squared_squared * shortfall_beta
        - 9.0 * attenuation_epsilon_squared * shortfall_beta * shortfall_epsilon_squared
        + 15.0 * attenuation_beta * attenuation_epsilon_squared * shortfall_epsilon_squared
        + 4.0 * attenuation_beta * shortfall_epsilon_squared_squared
        + product_17
        + product_26
    )
    cos_epsilon_squared = cos_epsilon**2
    sum_25 = (
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
    sum_26 = (
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
    sum_27 = (
        3.0 * attenuation_epsilon * shortfall_beta * shortfall_epsilon_squared
        - 10.0 * attenuation_beta * product_2
        - 13.0 * attenuation_beta * attenuation_epsilon * shortfall_epsilon_squared
        - 15.0 * attenuation_beta * attenuation_epsilon_squared * shortfall_epsilon
        - 4.0 * attenuation_beta * product_1
        + 6.0 * product_2 * shortfall_beta
        + 9.0 * attenuation_epsilon_squared * shortfall_beta * shortfall_epsilon
    )
    sum_28 = attenuation_epsilon - 3.0 * shortfall_epsilon
    sum_29 = 3.0 * shortfall_epsilon - attenuation_epsilon
    result = _empty(arguments, (3, 3))
    result[..., 0, 0] = (
        cos_beta * cos_epsilon_squared * product_12 * r * rho * sigma_beta * sigma_r * sin_beta * sum_24
        + cos_beta * product_12 * r * rho * shortfall_epsilon * sigma_beta * sigma_r * sin_beta * sin_epsilon_squared * sum_25
        + cos_beta_squared * cos_epsilon_squared * part_00_cos_beta2_cos_epsilon2
        + cos_beta_squared * part_00_cos_beta2_sin_epsilon2 * sin_epsilon_squared
        + cos_epsilon_squared * part_00_cos_epsilon2_sin_beta2 * sin_beta_squared
        + part_00_sin_beta2_sin_epsilon2 * sin_beta_squared * sin_epsilon_squared
    )
    result[..., 0, 1] = (
        cos_beta * cos_epsilon_squared * part_01_cos_beta_cos_epsilon2_sin_beta * sin_beta
        + cos_beta * part_01_cos_beta_sin_beta_sin_epsilon2 * sin_beta * sin_epsilon_squared
        + 0.5 * cos_beta_squared * cos_epsilon_squared * product_12 * r * rho * sigma_beta * sigma_r * sum_24
        + 0.5 * cos_beta_squared * product_12 * r * rho * shortfall_epsilon * sigma_beta * sigma_r * sin_epsilon_squared * sum_25
        + 0.5 * cos_epsilon_squared * product_12 * r * rho * sigma_beta * sigma_r * sin_beta_squared * sum_26
        + 0.5 * product_12 * r * rho * shortfall_epsilon * sigma_beta * sigma_r * sin_beta_squared * sin_epsilon_squared * sum_27
    )
    result[..., 0, 2] = (
        attenuation_beta * cos_beta * cos_epsilon * product_2 * r * rho * sigma_beta * sigma_r * sin_epsilon * sum_28
        + cos_epsilon * part_02_cos_epsilon_sin_beta_sin_epsilon * sin_beta * sin_epsilon
    )
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = (
        cos_beta * cos_epsilon_squared * product_12 * r * rho * sigma_beta * sigma_r * sin_beta * sum_26
        + cos_beta * product_12 * r * rho * shortfall_epsilon * sigma_beta * sigma_r * sin_beta * sin_epsilon_squared * sum_27
        + cos_beta_squared * cos_epsilon_squared * part_00_cos_epsilon2_sin_beta2
        + cos_beta_squared * part_00_sin_beta2_sin_epsilon2 * sin_epsilon_squared
        + cos_epsilon_squared * part_00_cos_beta2_cos_epsilon2 * sin_beta_squared
        + part_00_cos_beta2_sin_epsilon2 * sin_beta_squared * sin_epsilon_squared
    )
    result[..., 1, 2] = (
        attenuation_beta * cos_epsilon * product_2 * r * rho * sigma_beta * sigma_r * sin_beta * sin_epsilon * sum_29
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

    Accuracy: at most 222 ulp anywhere in this domain with independent errors, proved for elementary functions
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
    attenuation_beta_squared_cubed = attenuation_beta_squared * attenuation_beta_squared**2
    attenuation_epsilon_squared = attenuation_epsilon**2
    product_1 = attenuation_epsilon * attenuation_epsilon_squared
    product_2 = attenuation_beta_squared_cubed * product_1
    rho_squared = rho**2
    sigma_r_squared = sigma_r**2
    sum_1 = (
        1.0
        + 2.0 * attenuation_beta_squared * attenuation_epsilon
        + attenuation_beta_squared_cubed * attenuation_epsilon
        + product_2
    )
    product_3 = attenuation_beta * attenuation_beta_squared
    sum_2 = (
        1.0
        + attenuation_beta
        + attenuation_beta * attenuation_epsilon_squared
        + attenuation_beta_squared
        + attenuation_beta_squared * attenuation_epsilon_squared
        + attenuation_epsilon_squared
        + attenuation_epsilon_squared * product_3
        + product_3
    )
    r_squared = r**2
    part_00_cos_beta2_cos_epsilon2 = (
        0.25 * r_squared * shortfall_beta * sum_2
        + rho_squared * sigma_beta_squared * sigma_r_squared * sum_1 * term_1 * term_2
        + 0.25 * shortfall_beta * sigma_r_squared * sum_2
    )
    attenuation_beta_squared_squared = attenuation_beta_squared**2
    sum_3 = 1.0 + attenuation_epsilon
    sum_4 = (
        1.0
        + attenuation_beta
        + attenuation_beta * attenuation_epsilon
        + attenuation_beta_squared
        + attenuation_beta_squared * attenuation_epsilon
        + attenuation_epsilon
        + attenuation_epsilon * product_3
        + product_3
    )
    part_00_cos_beta2_sin_epsilon2 = (
        attenuation_beta_squared_squared * rho_squared * shortfall_epsilon * sigma_beta_squared * sigma_r_squared * sum_3
        + 0.25 * r_squared * shortfall_beta * shortfall_epsilon * sum_4
        + 0.25 * shortfall_beta * shortfall_epsilon * sigma_r_squared * sum_4
    )
    sum_5 = -1.0 - attenuation_epsilon_squared
    shortfall_beta_squared = shortfall_beta**2
    shortfall_beta_squared_cubed = shortfall_beta_squared * shortfall_beta_squared**2
    shortfall_epsilon_squared = shortfall_epsilon**2
    product_4 = attenuation_beta * attenuation_beta_squared**2
    shortfall_beta_squared_squared = shortfall_beta_squared**2
    product_5 = shortfall_beta * shortfall_beta_squared
    product_6 = shortfall_epsilon * shortfall_epsilon_squared
    product_7 = shortfall_beta * shortfall_beta_squared**2
    sum_6 = (
        12.0 * attenuation_epsilon * shortfall_beta_squared_cubed * shortfall_epsilon_squared
        + 12.0 * attenuation_epsilon_squared * shortfall_beta_squared_cubed * shortfall_epsilon
        + 138.0 * attenuation_beta_squared_squared * attenuation_epsilon * shortfall_beta_squared * shortfall_epsilon_squared
        + 16.0 * attenuation_epsilon_squared * product_4 * shortfall_beta * shortfall_epsilon
        + 166.0 * attenuation_beta_squared * attenuation_epsilon_squared * shortfall_beta_squared_squared * shortfall_epsilon
        + 173.0 * attenuation_beta_squared * attenuation_epsilon * shortfall_beta_squared_squared * shortfall_epsilon_squared
        + 184.0 * attenuation_epsilon_squared * product_3 * product_5 * shortfall_epsilon
        + 212.0 * attenuation_epsilon * product_3 * product_5 * shortfall_epsilon_squared
        + 24.0 * attenuation_beta * product_1 * product_7
        + 24.0 * attenuation_beta * product_6 * product_7
        + 24.0 * attenuation_beta_squared_squared * product_1 * shortfall_beta_squared
        + 24.0 * product_4 * product_6 * shortfall_beta
        + 4.0 * attenuation_beta_squared_cubed * product_6
        + 4.0 * product_1 * shortfall_beta_squared_cubed
        + 4.0 * product_6 * shortfall_beta_squared_cubed
        + 44.0 * attenuation_epsilon * product_4 * shortfall_beta * shortfall_epsilon_squared
        + 54.0 * attenuation_beta_squared * product_1 * shortfall_beta_squared_squared
        + 56.0 * product_1 * product_3 * product_5
        + 6.0 * attenuation_beta_squared_cubed * attenuation_epsilon * shortfall_epsilon_squared
        + 60.0 * attenuation_beta_squared * product_6 * shortfall_beta_squared_squared
        + 60.0 * attenuation_beta_squared_squared * product_6 * shortfall_beta_squared
        + 72.0 * attenuation_beta * attenuation_epsilon * product_7 * shortfall_epsilon_squared
        + 72.0 * attenuation_beta * attenuation_epsilon_squared * product_7 * shortfall_epsilon
        + 80.0 * product_3 * product_5 * product_6
        + 96.0 * attenuation_beta_squared_squared * attenuation_epsilon_squared * shortfall_beta_squared * shortfall_epsilon
    )
    sum_7 = (
        0.25
        + 0.25 * attenuation_beta_squared_squared * attenuation_epsilon_squared
        + 0.25 * attenuation_beta_squared_squared
        + 0.25 * attenuation_epsilon_squared
    )
    part_00_cos_epsilon2_sin_beta2 = (
        attenuation_beta_squared_squared * rho_squared * sigma_beta_squared * sigma_r_squared * sum_5
        + 0.25 * r_squared * sum_6 * term_1 * term_2
        + sigma_r_squared * sum_7
    )
    sum_8 = -1.0 - attenuation_epsilon
    sum_9 = (
        1.0
        + attenuation_beta_squared_squared
        + attenuation_beta_squared_squared * attenuation_epsilon
        + attenuation_epsilon
    )
    part_00_sin_beta2_sin_epsilon2 = (
        attenuation_beta_squared_squared * rho_squared * shortfall_epsilon * sigma_beta_squared * sigma_r_squared * sum_8
        + 0.25 * r_squared * shortfall_epsilon * sum_9
        + 0.25 * shortfall_epsilon * sigma_r_squared * sum_9
    )
    sum_10 = 1.0 + attenuation_epsilon_squared
    sum_11 = (
        104.0 * attenuation_epsilon * product_3 * product_5 * shortfall_epsilon_squared
        - 4.0 * product_1 * product_4 * shortfall_beta
        + 12.0 * attenuation_beta * product_1 * product_7
        + 12.0 * attenuation_beta * product_6 * product_7
        + 12.0 * product_4 * product_6 * shortfall_beta
        + 2.0 * attenuation_beta_squared_cubed * product_6
        + 2.0 * product_1 * shortfall_beta_squared_cubed
        + 2.0 * product_6 * shortfall_beta_squared_cubed
        + 20.0 * attenuation_epsilon * product_4 * shortfall_beta * shortfall_epsilon_squared
        + 24.0 * product_1 * product_3 * product_5
        + 26.0 * attenuation_beta_squared * product_1 * shortfall_beta_squared_squared
        + 3.0 * attenuation_beta_squared_cubed * attenuation_epsilon * shortfall_epsilon_squared
        + 30.0 * attenuation_beta_squared * product_6 * shortfall_beta_squared_squared
        + 30.0 * attenuation_beta_squared_squared * product_6 * shortfall_beta_squared
        + 36.0 * attenuation_beta * attenuation_epsilon * product_7 * shortfall_epsilon_squared
        + 36.0 * attenuation_beta * attenuation_epsilon_squared * product_7 * shortfall_epsilon
        + 4.0 * attenuation_epsilon_squared * product_4 * shortfall_beta * shortfall_epsilon
        + 40.0 * product_3 * product_5 * product_6
        + 42.0 * attenuation_beta_squared_squared * attenuation_epsilon_squared * shortfall_beta_squared * shortfall_epsilon
        + 6.0 * attenuation_beta_squared_squared * product_1 * shortfall_beta_squared
        + 6.0 * attenuation_epsilon * shortfall_beta_squared_cubed * shortfall_epsilon_squared
        + 6.0 * attenuation_epsilon_squared * shortfall_beta_squared_cubed * shortfall_epsilon
        + 66.0 * attenuation_beta_squared_squared * attenuation_epsilon * shortfall_beta_squared * shortfall_epsilon_squared
        + 82.0 * attenuation_beta_squared * attenuation_epsilon_squared * shortfall_beta_squared_squared * shortfall_epsilon
        + 86.0 * attenuation_beta_squared * attenuation_epsilon * shortfall_beta_squared_squared * shortfall_epsilon_squared
        + 88.0 * attenuation_epsilon_squared * product_3 * product_5 * shortfall_epsilon
    )
    sum_12 = (
        -1.0
        - 2.0 * attenuation_beta_squared * attenuation_epsilon
        - 2.0 * attenuation_beta_squared_cubed * attenuation_epsilon
        - 2.0 * attenuation_beta_squared_cubed * product_1
    )
    part_01_cos_beta_cos_epsilon2_sin_beta = (
        0.5 * attenuation_beta_squared_squared * sigma_r_squared * sum_10
        + 0.5 * r_squared * sum_11 * term_1 * term_2
        + rho_squared * sigma_beta_squared * sigma_r_squared * sum_12 * term_1 * term_2
    )
    part_01_cos_beta_sin_beta_sin_epsilon2 = (
        2.0 * attenuation_beta_squared_squared * rho_squared * shortfall_epsilon * sigma_beta_squared * sigma_r_squared * sum_8
        + 0.5 * attenuation_beta_squared_squared * r_squared * shortfall_epsilon * sum_3
        + 0.5 * attenuation_beta_squared_squared * shortfall_epsilon * sigma_r_squared * sum_3
    )
    term_3 = 1.0 / attenuation_beta
    sum_13 = (
        2.0 * attenuation_beta * attenuation_epsilon_squared * shortfall_beta
        - attenuation_beta_squared * attenuation_epsilon_squared
        + 2.0 * attenuation_beta * shortfall_beta * shortfall_epsilon_squared
        + 2.0 * attenuation_epsilon * shortfall_beta_squared * shortfall_epsilon
        + 4.0 * attenuation_beta * attenuation_epsilon * shortfall_beta * shortfall_epsilon
        + attenuation_beta_squared * attenuation_epsilon * shortfall_epsilon
        + attenuation_beta_squared * shortfall_epsilon_squared
        + attenuation_epsilon_squared * shortfall_beta_squared
        + shortfall_beta_squared * shortfall_epsilon_squared
    )
    part_02_cos_epsilon_sin_beta_sin_epsilon = (
        attenuation_beta * attenuation_epsilon_squared * sigma_r_squared
        - attenuation_beta * attenuation_epsilon_squared * rho_squared * sigma_beta_squared * sigma_r_squared
        + r_squared * shortfall_epsilon * sum_13 * term_1 * term_3
    )
    part_22_cos_epsilon2 = (
        0.5 * r_squared * shortfall_epsilon * sum_3
        + 0.5 * shortfall_epsilon * sigma_r_squared * sum_3
    )
    sum_14 = 0.5 + 0.5 * attenuation_epsilon_squared
    part_22_sin_epsilon2 = (
        0.5 * (2.0 + attenuation_epsilon) * r_squared * shortfall_epsilon_squared * term_1
        + sigma_r_squared * sum_14
    )
    sin_epsilon_squared = sin_epsilon**2
    sum_15 = (
        product_2
        - 15.0 * attenuation_beta_squared * product_1 * shortfall_beta_squared_squared
        - 15.0 * attenuation_beta_squared * product_6 * shortfall_beta_squared_squared
        - 15.0 * attenuation_beta_squared_squared * product_1 * shortfall_beta_squared
        - 15.0 * attenuation_beta_squared_squared * product_6 * shortfall_beta_squared
        - 18.0 * attenuation_beta * attenuation_epsilon * product_7 * shortfall_epsilon_squared
        - 18.0 * attenuation_beta * attenuation_epsilon_squared * product_7 * shortfall_epsilon
        - 18.0 * attenuation_epsilon * product_4 * shortfall_beta * shortfall_epsilon_squared
        - 18.0 * attenuation_epsilon_squared * product_4 * shortfall_beta * shortfall_epsilon
        - 2.0 * attenuation_beta_squared_cubed * attenuation_epsilon * shortfall_epsilon_squared
        - 20.0 * product_1 * product_3 * product_5
        - 20.0 * product_3 * product_5 * product_6
        - 3.0 * attenuation_epsilon * shortfall_beta_squared_cubed * shortfall_epsilon_squared
        - 3.0 * attenuation_epsilon_squared * shortfall_beta_squared_cubed * shortfall_epsilon
        - 45.0 * attenuation_beta_squared * attenuation_epsilon * shortfall_beta_squared_squared * shortfall_epsilon_squared
        - 45.0 * attenuation_beta_squared * attenuation_epsilon_squared * shortfall_beta_squared_squared * shortfall_epsilon
        - 45.0 * attenuation_beta_squared_squared * attenuation_epsilon * shortfall_beta_squared * shortfall_epsilon_squared
        - 45.0 * attenuation_beta_squared_squared * attenuation_epsilon_squared * shortfall_beta_squared * shortfall_epsilon
        - 6.0 * attenuation_beta * product_1 * product_7
        - 6.0 * attenuation_beta * product_6 * product_7
        - 6.0 * product_1 * product_4 * shortfall_beta
        - 6.0 * product_4 * product_6 * shortfall_beta
        - 60.0 * attenuation_epsilon * product_3 * product_5 * shortfall_epsilon_squared
        - 60.0 * attenuation_epsilon_squared * product_3 * product_5 * shortfall_epsilon
        - attenuation_beta_squared_cubed * attenuation_epsilon_squared * shortfall_epsilon
        - attenuation_beta_squared_cubed * product_6
        - product_1 * shortfall_beta_squared_cubed
        - product_6 * shortfall_beta_squared_cubed
    )
    cos_epsilon_squared = cos_epsilon**2
    cos_beta_squared = cos_beta**2
    sin_beta_squared = sin_beta**2
    sum_16 = (
        15.0 * attenuation_beta_squared * product_1 * shortfall_beta_squared_squared
        - attenuation_beta_squared_cubed * product_1
        + 15.0 * attenuation_beta_squared * product_6 * shortfall_beta_squared_squared
        + 15.0 * attenuation_beta_squared_squared * product_1 * shortfall_beta_squared
        + 15.0 * attenuation_beta_squared_squared * product_6 * shortfall_beta_squared
        + 18.0 * attenuation_beta * attenuation_epsilon * product_7 * shortfall_epsilon_squared
        + 18.0 * attenuation_beta * attenuation_epsilon_squared * product_7 * shortfall_epsilon
        + 18.0 * attenuation_epsilon * product_4 * shortfall_beta * shortfall_epsilon_squared
        + 18.0 * attenuation_epsilon_squared * product_4 * shortfall_beta * shortfall_epsilon
        + 2.0 * attenuation_beta_squared_cubed * attenuation_epsilon * shortfall_epsilon_squared
        + 20.0 * product_1 * product_3 * product_5
        + 20.0 * product_3 * product_5 * product_6
        + 3.0 * attenuation_epsilon * shortfall_beta_squared_cubed * shortfall_epsilon_squared
        + 3.0 * attenuation_epsilon_squared * shortfall_beta_squared_cubed * shortfall_epsilon
        + 45.0 * attenuation_beta_squared * attenuation_epsilon * shortfall_beta_squared_squared * shortfall_epsilon_squared
        + 45.0 * attenuation_beta_squared * attenuation_epsilon_squared * shortfall_beta_squared_squared * shortfall_epsilon
        + 45.0 * attenuation_beta_squared_squared * attenuation_epsilon * shortfall_beta_squared * shortfall_epsilon_squared
        + 45.0 * attenuation_beta_squared_squared * attenuation_epsilon_squared * shortfall_beta_squared * shortfall_epsilon
        + 6.0 * attenuation_beta * product_1 * product_7
        + 6.0 * attenuation_beta * product_6 * product_7
        + 6.0 * product_1 * product_4 * shortfall_beta
        + 6.0 * product_4 * product_6 * shortfall_beta
        + 60.0 * attenuation_epsilon * product_3 * product_5 * shortfall_epsilon_squared
        + 60.0 * attenuation_epsilon_squared * product_3 * product_5 * shortfall_epsilon
        + attenuation_beta_squared_cubed * attenuation_epsilon_squared * shortfall_epsilon
        + attenuation_beta_squared_cubed * product_6
        + product_1 * shortfall_beta_squared_cubed
        + product_6 * shortfall_beta_squared_cubed
    )
    sum_17 = (
        attenuation_beta_squared * product_1
        - 2.0 * attenuation_beta * attenuation_epsilon_squared * shortfall_beta * shortfall_epsilon
        - 2.0 * attenuation_beta * product_6 * shortfall_beta
        - 2.0 * attenuation_epsilon * shortfall_beta_squared * shortfall_epsilon_squared
        - 3.0 * attenuation_beta_squared * attenuation_epsilon * shortfall_epsilon_squared
        - 3.0 * attenuation_beta_squared * attenuation_epsilon_squared * shortfall_epsilon
        - 4.0 * attenuation_beta * attenuation_epsilon * shortfall_beta * shortfall_epsilon_squared
        - attenuation_beta_squared * product_6
        - attenuation_epsilon_squared * shortfall_beta_squared * shortfall_epsilon
        - product_6 * shortfall_beta_squared
    )
    sum_18 = (
        2.0 * attenuation_beta * attenuation_epsilon_squared * shortfall_beta * shortfall_epsilon
        - attenuation_beta_squared * product_1
        + 2.0 * attenuation_beta * product_6 * shortfall_beta
        + 2.0 * attenuation_epsilon * shortfall_beta_squared * shortfall_epsilon_squared
        + 3.0 * attenuation_beta_squared * attenuation_epsilon * shortfall_epsilon_squared
        + 3.0 * attenuation_beta_squared * attenuation_epsilon_squared * shortfall_epsilon
        + 4.0 * attenuation_beta * attenuation_epsilon * shortfall_beta * shortfall_epsilon_squared
        + attenuation_beta_squared * product_6
        + attenuation_epsilon_squared * shortfall_beta_squared * shortfall_epsilon
        + product_6 * shortfall_beta_squared
    )
    result = _empty(arguments, (3, 3))
    result[..., 0, 0] = (
        2.0 * attenuation_beta_squared_squared * cos_beta * r * rho * shortfall_epsilon * sigma_beta * sigma_r * sin_beta * sin_epsilon_squared * sum_3
        + 2.0 * cos_beta * cos_epsilon_squared * r * rho * sigma_beta * sigma_r * sin_beta * sum_15 * term_1 * term_2
        + cos_beta_squared * cos_epsilon_squared * part_00_cos_beta2_cos_epsilon2
        + cos_beta_squared * part_00_cos_beta2_sin_epsilon2 * sin_epsilon_squared
        + cos_epsilon_squared * part_00_cos_epsilon2_sin_beta2 * sin_beta_squared
        + part_00_sin_beta2_sin_epsilon2 * sin_beta_squared * sin_epsilon_squared
    )
    result[..., 0, 1] = (
        attenuation_beta_squared_squared * cos_beta_squared * r * rho * shortfall_epsilon * sigma_beta * sigma_r * sin_epsilon_squared * sum_3
        + attenuation_beta_squared_squared * r * rho * shortfall_epsilon * sigma_beta * sigma_r * sin_beta_squared * sin_epsilon_squared * sum_8
        + cos_beta * cos_epsilon_squared * part_01_cos_beta_cos_epsilon2_sin_beta * sin_beta
        + cos_beta * part_01_cos_beta_sin_beta_sin_epsilon2 * sin_beta * sin_epsilon_squared
        + cos_beta_squared * cos_epsilon_squared * r * rho * sigma_beta * sigma_r * sum_15 * term_1 * term_2
        + cos_epsilon_squared * r * rho * sigma_beta * sigma_r * sin_beta_squared * sum_16 * term_1 * term_2
    )
    result[..., 0, 2] = (
        cos_beta * cos_epsilon * r * rho * sigma_beta * sigma_r * sin_epsilon * sum_17 * term_1 * term_3
        + cos_epsilon * part_02_cos_epsilon_sin_beta_sin_epsilon * sin_beta * sin_epsilon
    )
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = (
        2.0 * attenuation_beta_squared_squared * cos_beta * r * rho * shortfall_epsilon * sigma_beta * sigma_r * sin_beta * sin_epsilon_squared * sum_8
        + 2.0 * cos_beta * cos_epsilon_squared * r * rho * sigma_beta * sigma_r * sin_beta * sum_16 * term_1 * term_2
        + cos_beta_squared * cos_epsilon_squared * part_00_cos_epsilon2_sin_beta2
        + cos_beta_squared * part_00_sin_beta2_sin_epsilon2 * sin_epsilon_squared
        + cos_epsilon_squared * part_00_cos_beta2_cos_epsilon2 * sin_beta_squared
        + part_00_cos_beta2_sin_epsilon2 * sin_beta_squared * sin_epsilon_squared
    )
    result[..., 1, 2] = (
        cos_beta * cos_epsilon * part_02_cos_epsilon_sin_beta_sin_epsilon * sin_epsilon
        + cos_epsilon * r * rho * sigma_beta * sigma_r * sin_beta * sin_epsilon * sum_18 * term_1 * term_3
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

    Accuracy: at most 110 ulp anywhere in this domain with independent errors, proved for elementary functions
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
    product_1 = attenuation_beta_squared * attenuation_epsilon_squared
    shortfall_epsilon_squared = shortfall_epsilon**2
    product_2 = attenuation_beta_squared * shortfall_epsilon_squared
    sum_1 = (
        attenuation_beta_squared * attenuation_epsilon * shortfall_epsilon
        - 2.0 * attenuation_beta * attenuation_epsilon * shortfall_beta * shortfall_epsilon
        - 2.0 * attenuation_beta * attenuation_epsilon_squared * shortfall_beta
        - attenuation_epsilon * shortfall_beta_squared * shortfall_epsilon
        - attenuation_epsilon_squared * shortfall_beta_squared
        + product_1
        + product_2
    )
    rho_squared = rho**2
    sigma_r_squared = sigma_r**2
    product_3 = attenuation_beta * attenuation_beta_squared
    sum_2 = (
        1.0
        + attenuation_beta
        + attenuation_beta * attenuation_epsilon_squared
        + attenuation_beta_squared
        + attenuation_epsilon_squared
        + attenuation_epsilon_squared * product_3
        + product_1
        + product_3
    )
    r_squared = r**2
    part_00_cos_beta2_cos_epsilon2 = (
        attenuation_beta_squared * rho_squared * sigma_beta_squared * sigma_r_squared * sum_1
        + 0.25 * r_squared * shortfall_beta * sum_2
        + 0.25 * shortfall_beta * sigma_r_squared * sum_2
    )
    attenuation_beta_squared_squared = attenuation_beta_squared**2
    sum_3 = 1.0 + attenuation_epsilon
    sum_4 = (
        1.0
        + attenuation_beta
        + attenuation_beta * attenuation_epsilon
        + attenuation_beta_squared
        + attenuation_beta_squared * attenuation_epsilon
        + attenuation_epsilon
        + attenuation_epsilon * product_3
        + product_3
    )
    part_00_cos_beta2_sin_epsilon2 = (
        attenuation_beta_squared_squared * rho_squared * shortfall_epsilon * sigma_beta_squared * sigma_r_squared * sum_3
        + 0.25 * r_squared * shortfall_beta * shortfall_epsilon * sum_4
        + 0.25 * shortfall_beta * shortfall_epsilon * sigma_r_squared * sum_4
    )
    sum_5 = -1.0 - attenuation_epsilon_squared
    product_4 = shortfall_beta * shortfall_beta_squared
    shortfall_beta_squared_squared = shortfall_beta_squared**2
    sum_6 = (
        2.0 * attenuation_beta * attenuation_epsilon * product_4 * shortfall_epsilon
        + 2.0 * attenuation_beta * attenuation_epsilon_squared * product_4
        + 2.0 * attenuation_beta_squared * attenuation_epsilon * shortfall_beta_squared * shortfall_epsilon
        + 2.0 * attenuation_beta_squared * attenuation_epsilon_squared * shortfall_beta_squared
        + 1.5 * attenuation_beta_squared * shortfall_beta_squared * shortfall_epsilon_squared
        + attenuation_beta * product_4 * shortfall_epsilon_squared
        + 0.5 * attenuation_beta_squared_squared * shortfall_epsilon_squared
        + 0.5 * attenuation_epsilon * shortfall_beta_squared_squared * shortfall_epsilon
        + 0.5 * attenuation_epsilon_squared * shortfall_beta_squared_squared
        + product_3 * shortfall_beta * shortfall_epsilon_squared
        + 0.25 * shortfall_beta_squared_squared * shortfall_epsilon_squared
    )
    sum_7 = (
        0.25
        + 0.25 * attenuation_beta_squared_squared * attenuation_epsilon_squared
        + 0.25 * attenuation_beta_squared_squared
        + 0.25 * attenuation_epsilon_squared
    )
    part_00_cos_epsilon2_sin_beta2 = (
        attenuation_beta_squared_squared * rho_squared * sigma_beta_squared * sigma_r_squared * sum_5
        + r_squared * sum_6
        + sigma_r_squared * sum_7
    )
    sum_8 = -1.0 - attenuation_epsilon
    sum_9 = (
        1.0
        + attenuation_beta_squared_squared
        + attenuation_beta_squared_squared * attenuation_epsilon
        + attenuation_epsilon
    )
    part_00_sin_beta2_sin_epsilon2 = (
        attenuation_beta_squared_squared * rho_squared * shortfall_epsilon * sigma_beta_squared * sigma_r_squared * sum_8
        + 0.25 * r_squared * shortfall_epsilon * sum_9
        + 0.25 * shortfall_epsilon * sigma_r_squared * sum_9
    )
    sum_10 = (
        product_2
        - 2.0 * attenuation_epsilon * shortfall_beta_squared * shortfall_epsilon
        - 2.0 * attenuation_epsilon_squared * shortfall_beta_squared
        - 4.0 * attenuation_beta * attenuation_epsilon * shortfall_beta * shortfall_epsilon
        - 4.0 * attenuation_beta * attenuation_epsilon_squared * shortfall_beta
    )
    product_5 = 2.0 * attenuation_beta * attenuation_epsilon_squared * shortfall_beta
    product_6 = 2.0 * attenuation_beta * attenuation_epsilon * shortfall_beta * shortfall_epsilon
    product_7 = attenuation_epsilon_squared * shortfall_beta_squared
    product_8 = attenuation_epsilon * shortfall_beta_squared * shortfall_epsilon
    sum_11 = (
        product_5
        - 2.0 * attenuation_beta_squared * shortfall_epsilon_squared
        - 3.0 * attenuation_beta_squared * attenuation_epsilon * shortfall_epsilon
        - 3.0 * attenuation_beta_squared * attenuation_epsilon_squared
        + product_6
        + product_7
        + product_8
    )
    sum_12 = 1.0 + attenuation_epsilon_squared
    part_01_cos_beta_cos_epsilon2_sin_beta = (
        0.5 * attenuation_beta_squared * r_squared * sum_10
        + attenuation_beta_squared * rho_squared * sigma_beta_squared * sigma_r_squared * sum_11
        + 0.5 * attenuation_beta_squared_squared * sigma_r_squared * sum_12
    )
    part_01_cos_beta_sin_beta_sin_epsilon2 = (
        2.0 * attenuation_beta_squared_squared * rho_squared * shortfall_epsilon * sigma_beta_squared * sigma_r_squared * sum_8
        + 0.5 * attenuation_beta_squared_squared * r_squared * shortfall_epsilon * sum_3
        + 0.5 * attenuation_beta_squared_squared * shortfall_epsilon * sigma_r_squared * sum_3
    )
    part_02_cos_epsilon_sin_beta_sin_epsilon = (
        attenuation_beta * attenuation_epsilon_squared * sigma_r_squared
        - attenuation_beta * attenuation_epsilon * r_squared * shortfall_epsilon
        - attenuation_beta * attenuation_epsilon_squared * rho_squared * sigma_beta_squared * sigma_r_squared
    )
    part_22_cos_epsilon2 = (
        0.5 * r_squared * shortfall_epsilon * sum_3
        + 0.5 * shortfall_epsilon * sigma_r_squared * sum_3
    )
    sum_13 = 0.5 + 0.5 * attenuation_epsilon_squared
    part_22_sin_epsilon2 = 0.5 * r_squared * shortfall_epsilon_squared + sigma_r_squared * sum_13
    cos_epsilon_squared = cos_epsilon**2
    sin_epsilon_squared = sin_epsilon**2
    cos_beta_squared = cos_beta**2
    sin_beta_squared = sin_beta**2
    sum_14 = (
        product_5
        - attenuation_beta_squared * attenuation_epsilon * shortfall_epsilon
        - attenuation_beta_squared * attenuation_epsilon_squared
        - attenuation_beta_squared * shortfall_epsilon_squared
        + product_6
        + product_7
        + product_8
    )
    sum_15 = attenuation_epsilon - shortfall_epsilon
    sum_16 = shortfall_epsilon - attenuation_epsilon
    result = _empty(arguments, (3, 3))
    result[..., 0, 0] = (
        2.0 * attenuation_beta_squared * cos_beta * cos_epsilon_squared * r * rho * sigma_beta * sigma_r * sin_beta * sum_1
        + 2.0 * attenuation_beta_squared_squared * cos_beta * r * rho * shortfall_epsilon * sigma_beta * sigma_r * sin_beta * sin_epsilon_squared * sum_3
        + cos_beta_squared * cos_epsilon_squared * part_00_cos_beta2_cos_epsilon2
        + cos_beta_squared * part_00_cos_beta2_sin_epsilon2 * sin_epsilon_squared
        + cos_epsilon_squared * part_00_cos_epsilon2_sin_beta2 * sin_beta_squared
        + part_00_sin_beta2_sin_epsilon2 * sin_beta_squared * sin_epsilon_squared
    )
    result[..., 0, 1] = (
        attenuation_beta_squared * cos_beta_squared * cos_epsilon_squared * r * rho * sigma_beta * sigma_r * sum_1
        + attenuation_beta_squared * cos_epsilon_squared * r * rho * sigma_beta * sigma_r * sin_beta_squared * sum_14
        + attenuation_beta_squared_squared * cos_beta_squared * r * rho * shortfall_epsilon * sigma_beta * sigma_r * sin_epsilon_squared * sum_3
        + attenuation_beta_squared_squared * r * rho * shortfall_epsilon * sigma_beta * sigma_r * sin_beta_squared * sin_epsilon_squared * sum_8
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
        + 2.0 * attenuation_beta_squared_squared * cos_beta * r * rho * shortfall_epsilon * sigma_beta * sigma_r * sin_beta * sin_epsilon_squared * sum_8
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

    Accuracy: at most 398 ulp anywhere in this domain with independent errors, proved for elementary functions
    within 1 ulp (float64).
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
    product_2 = -attenuation_epsilon_squared * shortfall_beta * shortfall_predicted_epsilon
    product_3 = -attenuation_epsilon * shortfall_beta * shortfall_epsilon * shortfall_predicted_epsilon
    product_4 = attenuation_beta * attenuation_epsilon * shortfall_epsilon * shortfall_predicted_epsilon
    shortfall_epsilon_squared = shortfall_epsilon**2
    product_5 = attenuation_beta * attenuation_predicted_epsilon * shortfall_epsilon_squared
    product_6 = attenuation_beta * shortfall_epsilon_squared * shortfall_predicted_epsilon
    sum_2 = (
        product_2
        - 2.0 * attenuation_epsilon * attenuation_predicted_epsilon * shortfall_beta * shortfall_epsilon
        - 2.0 * attenuation_epsilon_squared * attenuation_predicted_epsilon * shortfall_beta
        + product_3
        + product_4
        + product_5
        + product_6
    )
    predicted_rho_squared = predicted_rho**2
    predicted_sigma_r_squared = predicted_sigma_r**2
    term_2 = 1.0 / attenuation_beta
    shortfall_predicted_beta_squared = shortfall_predicted_beta**2
    product_7 = 12.0 * attenuation_beta * attenuation_epsilon_squared * attenuation_predicted_beta_squared * attenuation_predicted_epsilon * shortfall_beta * shortfall_predicted_beta_squared
    product_8 = 12.0 * attenuation_beta * attenuation_epsilon * attenuation_predicted_beta_squared * attenuation_predicted_epsilon * shortfall_beta * shortfall_epsilon * shortfall_predicted_beta_squared
    product_9 = attenuation_predicted_beta * attenuation_predicted_beta_squared
    product_10 = 12.0 * attenuation_beta * attenuation_epsilon * product_9 * shortfall_beta * shortfall_epsilon * shortfall_predicted_beta * shortfall_predicted_epsilon
    product_11 = shortfall_predicted_beta * shortfall_predicted_beta_squared
    product_12 = 12.0 * attenuation_beta * attenuation_epsilon * attenuation_predicted_beta * product_11 * shortfall_beta * shortfall_epsilon * shortfall_predicted_epsilon
    product_13 = 12.0 * attenuation_beta * attenuation_predicted_beta_squared * attenuation_predicted_epsilon * shortfall_beta * shortfall_epsilon_squared * shortfall_predicted_beta_squared
    product_14 = 12.0 * attenuation_beta * attenuation_predicted_beta_squared * shortfall_beta * shortfall_epsilon_squared * shortfall_predicted_beta_squared * shortfall_predicted_epsilon
    shortfall_beta_squared = shortfall_beta**2
    product_15 = 12.0 * attenuation_epsilon_squared * attenuation_predicted_beta_squared * attenuation_predicted_epsilon * shortfall_beta_squared * shortfall_predicted_beta_squared
    product_16 = 12.0 * attenuation_epsilon * attenuation_predicted_beta_squared * attenuation_predicted_epsilon * shortfall_beta_squared * shortfall_epsilon * shortfall_predicted_beta_squared
    product_17 = 12.0 * attenuation_epsilon * attenuation_predicted_beta_squared * shortfall_beta_squared * shortfall_epsilon * shortfall_predicted_beta_squared * shortfall_predicted_epsilon
    product_18 = 18.0 * attenuation_beta * attenuation_epsilon * attenuation_predicted_beta_squared * shortfall_beta * shortfall_epsilon * shortfall_predicted_beta_squared * shortfall_predicted_epsilon
    product_19 = 2.0 * attenuation_beta * attenuation_epsilon_squared * attenuation_predicted_beta_squared_squared * shortfall_beta * shortfall_predicted_epsilon
    shortfall_predicted_beta_squared_squared = shortfall_predicted_beta_squared**2
    product_20 = 2.0 * attenuation_beta * attenuation_epsilon_squared * attenuation_predicted_epsilon * shortfall_beta * shortfall_predicted_beta_squared_squared
    product_21 = 2.0 * attenuation_beta * attenuation_epsilon * attenuation_predicted_epsilon * shortfall_beta * shortfall_epsilon * shortfall_predicted_beta_squared_squared
    product_22 = 2.0 * attenuation_beta * attenuation_predicted_beta_squared_squared * attenuation_predicted_epsilon * shortfall_beta * shortfall_epsilon_squared
    product_23 = 2.0 * attenuation_beta * attenuation_predicted_beta_squared_squared * shortfall_beta * shortfall_epsilon_squared * shortfall_predicted_epsilon
    product_24 = 2.0 * attenuation_beta * attenuation_predicted_epsilon * shortfall_beta * shortfall_epsilon_squared * shortfall_predicted_beta_squared_squared
    product_25 = 2.0 * attenuation_beta * shortfall_beta * shortfall_epsilon_squared * shortfall_predicted_beta_squared_squared * shortfall_predicted_epsilon
    product_26 = 2.0 * attenuation_epsilon_squared * attenuation_predicted_beta_squared_squared * attenuation_predicted_epsilon * shortfall_beta_squared
    product_27 = 2.0 * attenuation_epsilon_squared * attenuation_predicted_epsilon * shortfall_beta_squared * shortfall_predicted_beta_squared_squared
    product_28 = 2.0 * attenuation_epsilon * attenuation_predicted_beta_squared_squared * attenuation_predicted_epsilon * shortfall_beta_squared * shortfall_epsilon
    product_29 = 2.0 * attenuation_epsilon * attenuation_predicted_beta_squared_squared * shortfall_beta_squared * shortfall_epsilon * shortfall_predicted_epsilon
    product_30 = 2.0 * attenuation_epsilon * attenuation_predicted_epsilon * shortfall_beta_squared * shortfall_epsilon * shortfall_predicted_beta_squared_squared
    product_31 = 2.0 * attenuation_epsilon * shortfall_beta_squared * shortfall_epsilon * shortfall_predicted_beta_squared_squared * shortfall_predicted_epsilon
    product_32 = 3.0 * attenuation_beta * attenuation_epsilon * shortfall_beta * shortfall_epsilon * shortfall_predicted_beta_squared_squared * shortfall_predicted_epsilon
    attenuation_beta_squared = attenuation_beta**2
    product_33 = 4.0 * attenuation_beta_squared * attenuation_epsilon * product_9 * shortfall_epsilon * shortfall_predicted_beta * shortfall_predicted_epsilon
    product_34 = 4.0 * attenuation_beta_squared * attenuation_epsilon * attenuation_predicted_beta * product_11 * shortfall_epsilon * shortfall_predicted_epsilon
    product_35 = 4.0 * attenuation_beta_squared * attenuation_predicted_epsilon * product_9 * shortfall_epsilon_squared * shortfall_predicted_beta
    product_36 = 4.0 * attenuation_beta_squared * product_9 * shortfall_epsilon_squared * shortfall_predicted_beta * shortfall_predicted_epsilon
    product_37 = 4.0 * attenuation_beta_squared * attenuation_predicted_beta * attenuation_predicted_epsilon * product_11 * shortfall_epsilon_squared
    product_38 = 4.0 * attenuation_beta_squared * attenuation_predicted_beta * product_11 * shortfall_epsilon_squared * shortfall_predicted_epsilon
    product_39 = 4.0 * attenuation_beta * attenuation_epsilon_squared * product_9 * shortfall_beta * shortfall_predicted_beta * shortfall_predicted_epsilon
    product_40 = 4.0 * attenuation_beta * attenuation_epsilon_squared * attenuation_predicted_beta_squared_squared * attenuation_predicted_epsilon * shortfall_beta
    product_41 = 4.0 * attenuation_beta * attenuation_epsilon_squared * attenuation_predicted_beta * product_11 * shortfall_beta * shortfall_predicted_epsilon
    product_42 = 4.0 * attenuation_beta * attenuation_epsilon * attenuation_predicted_beta_squared_squared * attenuation_predicted_epsilon * shortfall_beta * shortfall_epsilon
    product_43 = 4.0 * attenuation_beta * attenuation_epsilon * attenuation_predicted_beta_squared_squared * shortfall_beta * shortfall_epsilon * shortfall_predicted_epsilon
    product_44 = 4.0 * attenuation_epsilon_squared * product_9 * shortfall_beta_squared * shortfall_predicted_beta * shortfall_predicted_epsilon
    product_45 = 4.0 * attenuation_epsilon_squared * attenuation_predicted_beta * product_11 * shortfall_beta_squared * shortfall_predicted_epsilon
    product_46 = 4.0 * attenuation_predicted_epsilon * product_9 * shortfall_beta_squared * shortfall_epsilon_squared * shortfall_predicted_beta
    product_47 = 4.0 * product_9 * shortfall_beta_squared * shortfall_epsilon_squared * shortfall_predicted_beta * shortfall_predicted_epsilon
    product_48 = 4.0 * attenuation_predicted_beta * attenuation_predicted_epsilon * product_11 * shortfall_beta_squared * shortfall_epsilon_squared
    product_49 = 4.0 * attenuation_predicted_beta * product_11 * shortfall_beta_squared * shortfall_epsilon_squared * shortfall_predicted_epsilon
    product_50 = 6.0 * attenuation_beta_squared * attenuation_epsilon * attenuation_predicted_beta_squared * shortfall_epsilon * shortfall_predicted_beta_squared * shortfall_predicted_epsilon
    product_51 = 6.0 * attenuation_beta_squared * attenuation_predicted_beta_squared * attenuation_predicted_epsilon * shortfall_epsilon_squared * shortfall_predicted_beta_squared
    product_52 = 6.0 * attenuation_beta_squared * attenuation_predicted_beta_squared * shortfall_epsilon_squared * shortfall_predicted_beta_squared * shortfall_predicted_epsilon
    product_53 = 6.0 * attenuation_beta * attenuation_epsilon_squared * attenuation_predicted_beta_squared * shortfall_beta * shortfall_predicted_beta_squared * shortfall_predicted_epsilon
    product_54 = 6.0 * attenuation_epsilon_squared * attenuation_predicted_beta_squared * shortfall_beta_squared * shortfall_predicted_beta_squared * shortfall_predicted_epsilon
    product_55 = 6.0 * attenuation_predicted_beta_squared * attenuation_predicted_epsilon * shortfall_beta_squared * shortfall_epsilon_squared * shortfall_predicted_beta_squared
    product_56 = 6.0 * attenuation_predicted_beta_squared * shortfall_beta_squared * shortfall_epsilon_squared * shortfall_predicted_beta_squared * shortfall_predicted_epsilon
    product_57 = 8.0 * attenuation_beta * attenuation_epsilon_squared * attenuation_predicted_epsilon * product_9 * shortfall_beta * shortfall_predicted_beta
    product_58 = 8.0 * attenuation_beta * attenuation_epsilon_squared * attenuation_predicted_beta * attenuation_predicted_epsilon * product_11 * shortfall_beta
    product_59 = 8.0 * attenuation_beta * attenuation_epsilon * attenuation_predicted_epsilon * product_9 * shortfall_beta * shortfall_epsilon * shortfall_predicted_beta
    product_60 = 8.0 * attenuation_beta * attenuation_epsilon * attenuation_predicted_beta * attenuation_predicted_epsilon * product_11 * shortfall_beta * shortfall_epsilon
    product_61 = 8.0 * attenuation_beta * attenuation_predicted_epsilon * product_9 * shortfall_beta * shortfall_epsilon_squared * shortfall_predicted_beta
    product_62 = 8.0 * attenuation_beta * product_9 * shortfall_beta * shortfall_epsilon_squared * shortfall_predicted_beta * shortfall_predicted_epsilon
    product_63 = 8.0 * attenuation_beta * attenuation_predicted_beta * attenuation_predicted_epsilon * product_11 * shortfall_beta * shortfall_epsilon_squared
    product_64 = 8.0 * attenuation_beta * attenuation_predicted_beta * product_11 * shortfall_beta * shortfall_epsilon_squared * shortfall_predicted_epsilon
    product_65 = 8.0 * attenuation_epsilon_squared * attenuation_predicted_epsilon * product_9 * shortfall_beta_squared * shortfall_predicted_beta
    product_66 = 8.0 * attenuation_epsilon_squared * attenuation_predicted_beta * attenuation_predicted_epsilon * product_11 * shortfall_beta_squared
    product_67 = 8.0 * attenuation_epsilon * attenuation_predicted_epsilon * product_9 * shortfall_beta_squared * shortfall_epsilon * shortfall_predicted_beta
    product_68 = 8.0 * attenuation_epsilon * product_9 * shortfall_beta_squared * shortfall_epsilon * shortfall_predicted_beta * shortfall_predicted_epsilon
    product_69 = 8.0 * attenuation_epsilon * attenuation_predicted_beta * attenuation_predicted_epsilon * product_11 * shortfall_beta_squared * shortfall_epsilon
    product_70 = 8.0 * attenuation_epsilon * attenuation_predicted_beta * product_11 * shortfall_beta_squared * shortfall_epsilon * shortfall_predicted_epsilon
    product_71 = attenuation_beta_squared * attenuation_epsilon * shortfall_epsilon * shortfall_predicted_beta_squared_squared * shortfall_predicted_epsilon
    product_72 = attenuation_beta_squared * attenuation_predicted_epsilon * shortfall_epsilon_squared * shortfall_predicted_beta_squared_squared
    product_73 = attenuation_beta_squared * shortfall_epsilon_squared * shortfall_predicted_beta_squared_squared * shortfall_predicted_epsilon
    product_74 = attenuation_beta * attenuation_epsilon_squared * shortfall_beta * shortfall_predicted_beta_squared_squared * shortfall_predicted_epsilon
    product_75 = attenuation_epsilon_squared * attenuation_predicted_beta_squared_squared * shortfall_beta_squared * shortfall_predicted_epsilon
    product_76 = attenuation_epsilon_squared * shortfall_beta_squared * shortfall_predicted_beta_squared_squared * shortfall_predicted_epsilon
    product_77 = attenuation_predicted_beta_squared_squared * attenuation_predicted_epsilon * shortfall_beta_squared * shortfall_epsilon_squared
    product_78 = attenuation_predicted_beta_squared_squared * shortfall_beta_squared * shortfall_epsilon_squared * shortfall_predicted_epsilon
    product_79 = attenuation_predicted_epsilon * shortfall_beta_squared * shortfall_epsilon_squared * shortfall_predicted_beta_squared_squared
    product_80 = shortfall_beta_squared * shortfall_epsilon_squared * shortfall_predicted_beta_squared_squared * shortfall_predicted_epsilon
    sum_3 = (
        product_10
        + product_12
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
        + product_23
        + product_24
        + product_25
        + product_26
        + product_27
        + product_28
        + product_29
        + product_30
        + product_31
        + product_32
        + product_33
        + product_34
        + product_35
        + product_36
        + product_37
        + product_38
        + product_39
        + product_40
        + product_41
        + product_42
        + product_43
        + product_44
        + product_45
        + product_46
        + product_47
        + product_48
        + product_49
        + product_50
        + product_51
        + product_52
        + product_53
        + product_54
        + product_55
        + product_56
        + product_57
        + product_58
        + product_59
        + product_60
        + product_61
        + product_62
        + product_63
        + product_64
        + product_65
        + product_66
        + product_67
        + product_68
        + product_69
        + product_7
        + product_70
        + product_71
        + product_72
        + product_73
        + product_74
        + product_75
        + product_76
        + product_77
        + product_78
        + product_79
        + product_8
        + product_80
    )
    r_squared = r**2
    sum_4 = (
        1.0
        + attenuation_beta_squared * attenuation_epsilon_squared * attenuation_predicted_beta_squared_squared * attenuation_predicted_epsilon
        + attenuation_beta_squared * attenuation_predicted_beta_squared_squared
        + product_1
    )
    rho_squared = rho**2
    sigma_r_squared = sigma_r**2
    product_81 = 12.0 * attenuation_beta_squared * attenuation_epsilon * attenuation_predicted_beta_squared * attenuation_predicted_epsilon * shortfall_epsilon * shortfall_predicted_beta_squared
    product_82 = 12.0 * attenuation_beta_squared * attenuation_epsilon * attenuation_predicted_beta_squared * shortfall_epsilon * shortfall_predicted_beta_squared * shortfall_predicted_epsilon
    product_83 = 12.0 * attenuation_beta * attenuation_epsilon_squared * attenuation_predicted_beta_squared * shortfall_beta * shortfall_predicted_beta_squared * shortfall_predicted_epsilon
    product_84 = 16.0 * attenuation_beta * attenuation_epsilon * attenuation_predicted_epsilon * product_9 * shortfall_beta * shortfall_epsilon * shortfall_predicted_beta
    product_85 = 16.0 * attenuation_beta * attenuation_epsilon * product_9 * shortfall_beta * shortfall_epsilon * shortfall_predicted_beta * shortfall_predicted_epsilon
    product_86 = 16.0 * attenuation_beta * attenuation_epsilon * attenuation_predicted_beta * attenuation_predicted_epsilon * product_11 * shortfall_beta * shortfall_epsilon
    product_87 = 16.0 * attenuation_beta * attenuation_epsilon * attenuation_predicted_beta * product_11 * shortfall_beta * shortfall_epsilon * shortfall_predicted_epsilon
    product_88 = 2.0 * attenuation_beta_squared * attenuation_epsilon * attenuation_predicted_epsilon * shortfall_epsilon * shortfall_predicted_beta_squared_squared
    product_89 = 2.0 * attenuation_beta_squared * attenuation_epsilon * shortfall_epsilon * shortfall_predicted_beta_squared_squared * shortfall_predicted_epsilon
    product_90 = 2.0 * attenuation_beta * attenuation_epsilon_squared * shortfall_beta * shortfall_predicted_beta_squared_squared * shortfall_predicted_epsilon
    product_91 = 24.0 * attenuation_beta * attenuation_epsilon * attenuation_predicted_beta_squared * attenuation_predicted_epsilon * shortfall_beta * shortfall_epsilon * shortfall_predicted_beta_squared
    product_92 = 24.0 * attenuation_beta * attenuation_epsilon * attenuation_predicted_beta_squared * shortfall_beta * shortfall_epsilon * shortfall_predicted_beta_squared * shortfall_predicted_epsilon
    product_93 = 4.0 * attenuation_beta_squared * attenuation_epsilon_squared * product_9 * shortfall_predicted_beta * shortfall_predicted_epsilon
    product_94 = 4.0 * attenuation_beta_squared * attenuation_epsilon_squared * attenuation_predicted_beta * product_11 * shortfall_predicted_epsilon
    product_95 = 4.0 * attenuation_beta * attenuation_epsilon * attenuation_predicted_epsilon * shortfall_beta * shortfall_epsilon * shortfall_predicted_beta_squared_squared
    product_96 = 4.0 * attenuation_beta * attenuation_epsilon * shortfall_beta * shortfall_epsilon * shortfall_predicted_beta_squared_squared * shortfall_predicted_epsilon
    product_97 = 6.0 * attenuation_beta_squared * attenuation_epsilon_squared * attenuation_predicted_beta_squared * shortfall_predicted_beta_squared * shortfall_predicted_epsilon
    product_98 = 8.0 * attenuation_beta_squared * attenuation_epsilon * attenuation_predicted_epsilon * product_9 * shortfall_epsilon * shortfall_predicted_beta
    product_99 = 8.0 * attenuation_beta_squared * attenuation_epsilon * product_9 * shortfall_epsilon * shortfall_predicted_beta * shortfall_predicted_epsilon
    product_100 = 8.0 * attenuation_beta_squared * attenuation_epsilon * attenuation_predicted_beta * attenuation_predicted_epsilon * product_11 * shortfall_epsilon
    product_101 = 8.0 * attenuation_beta_squared * attenuation_epsilon * attenuation_predicted_beta * product_11 * shortfall_epsilon * shortfall_predicted_epsilon
    product_102 = 8.0 * attenuation_beta * attenuation_epsilon_squared * product_9 * shortfall_beta * shortfall_predicted_beta * shortfall_predicted_epsilon
    product_103 = 8.0 * attenuation_beta * attenuation_epsilon_squared * attenuation_predicted_beta * product_11 * shortfall_beta * shortfall_predicted_epsilon
    product_104 = attenuation_beta_squared * attenuation_epsilon_squared * shortfall_predicted_beta_squared_squared * shortfall_predicted_epsilon
    sum_5 = (
        12.0 * attenuation_beta_squared * attenuation_epsilon_squared * attenuation_predicted_beta_squared * attenuation_predicted_epsilon * shortfall_predicted_beta_squared
        + 16.0 * attenuation_beta * attenuation_epsilon_squared * attenuation_predicted_beta * attenuation_predicted_epsilon * product_11 * shortfall_beta
        + 16.0 * attenuation_beta * attenuation_epsilon_squared * attenuation_predicted_epsilon * product_9 * shortfall_beta * shortfall_predicted_beta
        + 2.0 * attenuation_beta_squared * attenuation_epsilon_squared * attenuation_predicted_epsilon * shortfall_predicted_beta_squared_squared
        + 24.0 * attenuation_beta * attenuation_epsilon_squared * attenuation_predicted_beta_squared * attenuation_predicted_epsilon * shortfall_beta * shortfall_predicted_beta_squared
        + 4.0 * attenuation_beta * attenuation_epsilon_squared * attenuation_predicted_epsilon * shortfall_beta * shortfall_predicted_beta_squared_squared
        + 8.0 * attenuation_beta_squared * attenuation_epsilon_squared * attenuation_predicted_beta * attenuation_predicted_epsilon * product_11
        + 8.0 * attenuation_beta_squared * attenuation_epsilon_squared * attenuation_predicted_epsilon * product_9 * shortfall_predicted_beta
        + product_100
        + product_101
        + product_102
        + product_103
        + product_104
        + product_13
        + product_14
        + product_15
        + product_16
        + product_17
        + product_19
        + product_22
        + product_23
        + product_24
        + product_25
        + product_26
        + product_27
        + product_28
        + product_29
        + product_30
        + product_31
        + product_35
        + product_36
        + product_37
        + product_38
        + product_40
        + product_42
        + product_43
        + product_44
        + product_45
        + product_46
        + product_47
        + product_48
        + product_49
        + product_51
        + product_52
        + product_54
        + product_55
        + product_56
        + product_61
        + product_62
        + product_63
        + product_64
        + product_65
        + product_66
        + product_67
        + product_68
        + product_69
        + product_70
        + product_72
        + product_73
        + product_75
        + product_76
        + product_77
        + product_78
        + product_79
        + product_80
        + product_81
        + product_82
        + product_83
        + product_84
        + product_85
        + product_86
        + product_87
        + product_88
        + product_89
        + product_90
        + product_91
        + product_92
        + product_93
        + product_94
        + product_95
        + product_96
        + product_97
        + product_98
        + product_99
    )
    part_00_cos_beta2_cos_epsilon2 = (
        attenuation_beta * attenuation_predicted_beta_squared_squared * predicted_rho * predicted_sigma_beta * predicted_sigma_r * rho * sigma_beta * sigma_r * sum_1 * term_1
        + attenuation_predicted_beta_squared_squared * predicted_rho_squared * predicted_sigma_beta_squared * predicted_sigma_r_squared * sum_2 * term_1
        + 0.25 * predicted_sigma_r_squared * sum_3 * term_1 * term_2
        + 0.25 * r_squared * sum_3 * term_1 * term_2
        + 0.25 * rho_squared * sigma_beta_squared * sigma_r_squared * sum_4 * term_1 * term_2
        + 0.25 * sigma_r_squared * sum_5 * term_1 * term_2
    )
    sum_6 = (
        2.0 * attenuation_epsilon * attenuation_predicted_epsilon * shortfall_epsilon
        + 2.0 * attenuation_epsilon * shortfall_epsilon * shortfall_predicted_epsilon
        + attenuation_epsilon_squared * shortfall_predicted_epsilon
        + attenuation_predicted_epsilon * shortfall_epsilon_squared
        + shortfall_epsilon_squared * shortfall_predicted_epsilon
    )
    sum_7 = (
        2.0 * attenuation_beta * attenuation_epsilon * attenuation_predicted_epsilon * shortfall_epsilon
        + product_2
        + product_3
        + product_4
        + product_5
        + product_6
    )
    sum_8 = (
        product_10
        + product_100
        + product_12
        + product_13
        + product_14
        + product_16
        + product_17
        + product_18
        + product_19
        + product_22
        + product_23
        + product_24
        + product_25
        + product_28
        + product_29
        + product_30
        + product_31
        + product_32
        + product_33
        + product_34
        + product_35
        + product_36
        + product_37
        + product_38
        + product_39
        + product_41
        + product_42
        + product_43
        + product_44
        + product_45
        + product_46
        + product_47
        + product_48
        + product_49
        + product_50
        + product_51
        + product_52
        + product_53
        + product_54
        + product_55
        + product_56
        + product_61
        + product_62
        + product_63
        + product_64
        + product_67
        + product_68
        + product_69
        + product_70
        + product_71
        + product_72
        + product_73
        + product_74
        + product_75
        + product_76
        + product_77
        + product_78
        + product_79
        + product_80
        + product_81
        + product_84
        + product_86
        + product_88
        + product_91
        + product_95
        + product_98
    )
    product_105 = 2.0 * attenuation_beta_squared * attenuation_predicted_beta_squared_squared * attenuation_predicted_epsilon * shortfall_epsilon_squared
    product_106 = 2.0 * attenuation_beta_squared * attenuation_predicted_beta_squared_squared * shortfall_epsilon_squared * shortfall_predicted_epsilon
    product_107 = 4.0 * attenuation_beta_squared * attenuation_epsilon * attenuation_predicted_beta_squared_squared * attenuation_predicted_epsilon * shortfall_epsilon
    sum_9 = (
        2.0 * attenuation_beta_squared * attenuation_epsilon_squared * attenuation_predicted_beta_squared_squared * shortfall_predicted_epsilon
        + 4.0 * attenuation_beta_squared * attenuation_epsilon * attenuation_predicted_beta_squared_squared * shortfall_epsilon * shortfall_predicted_epsilon
        + product_100
        + product_101
        + product_102
        + product_103
        + product_104
        + product_105
        + product_106
        + product_107
        + product_13
        + product_14
        + product_16
        + product_17
        + product_19
        + product_22
        + product_23
        + product_24
        + product_25
        + product_28
        + product_29
        + product_30
        + product_31
        + product_35
        + product_36
        + product_37
        + product_38
        + product_42
        + product_43
        + product_44
        + product_45
        + product_46
        + product_47
        + product_48
        + product_49
        + product_51
        + product_52
        + product_54
        + product_55
        + product_56
        + product_61
        + product_62
        + product_63
        + product_64
        + product_67
        + product_68
        + product_69
        + product_70
        + product_72
        + product_73
        + product_75
        + product_76
        + product_77
        + product_78
        + product_79
        + product_80
        + product_81
        + product_82
        + product_83
        + product_84
        + product_85
        + product_86
        + product_87
        + product_88
        + product_89
        + product_90
        + product_91
        + product_92
        + product_93
        + product_94
        + product_95
        + product_96
        + product_97
        + product_98
        + product_99
    )
    sum_10 = (
        product_100
        + product_101
        + product_102
        + product_103
        + product_104
        + product_13
        + product_14
        + product_16
        + product_17
        + product_19
        + product_22
        + product_23
        + product_24
        + product_25
        + product_28
        + product_29
        + product_30
        + product_31
        + product_35
        + product_36
        + product_37
        + product_38
        + product_42
        + product_43
        + product_44
        + product_45
        + product_46
        + product_47
        + product_48
        + product_49
        + product_51
        + product_52
        + product_54
        + product_55
        + product_56
        + product_61
        + product_62
        + product_63
        + product_64
        + product_67
        + product_68
        + product_69
        + product_70
        + product_72
        + product_73
        + product_75
        + product_76
        + product_77
        + product_78
        + product_79
        + product_80
        + product_81
        + product_82
        + product_83
        + product_84
        + product_85
        + product_86
        + product_87
        + product_88
        + product_89
        + product_90
        + product_91
        + product_92
        + product_93
        + product_94
        + product_95
        + product_96
        + product_97
        + product_98
        + product_99
    )
    part_00_cos_beta2_sin_epsilon2 = (
        attenuation_beta * attenuation_predicted_beta_squared_squared * predicted_rho * predicted_sigma_beta * predicted_sigma_r * rho * sigma_beta * sigma_r * sum_6 * term_1
        + attenuation_predicted_beta_squared_squared * predicted_rho_squared * predicted_sigma_beta_squared * predicted_sigma_r_squared * sum_7 * term_1
        + 0.25 * predicted_sigma_r_squared * sum_8 * term_1 * term_2
        + 0.25 * r_squared * sum_8 * term_1 * term_2
        + 0.25 * rho_squared * sigma_beta_squared * sigma_r_squared * sum_9 * term_1 * term_2
        + 0.25 * sigma_r_squared * sum_10 * term_1 * term_2
    )
    sum_11 = -1.0 - attenuation_epsilon_squared * attenuation_predicted_epsilon
    product_108 = -attenuation_beta * attenuation_epsilon * shortfall_epsilon * shortfall_predicted_epsilon
    product_109 = -attenuation_beta * attenuation_predicted_epsilon * shortfall_epsilon_squared
    product_110 = -attenuation_beta * shortfall_epsilon_squared * shortfall_predicted_epsilon
    product_111 = attenuation_epsilon_squared * shortfall_beta * shortfall_predicted_epsilon
    product_112 = attenuation_epsilon * shortfall_beta * shortfall_epsilon * shortfall_predicted_epsilon
    sum_12 = (
        2.0 * attenuation_epsilon * attenuation_predicted_epsilon * shortfall_beta * shortfall_epsilon
        + 2.0 * attenuation_epsilon_squared * attenuation_predicted_epsilon * shortfall_beta
        + product_108
        + product_109
        + product_110
        + product_111
        + product_112
    )
    product_113 = 2.0 * attenuation_beta_squared * attenuation_epsilon * attenuation_predicted_beta_squared_squared * shortfall_epsilon * shortfall_predicted_epsilon
    product_114 = 2.0 * attenuation_beta * attenuation_epsilon * attenuation_predicted_beta_squared_squared * shortfall_beta * shortfall_epsilon * shortfall_predicted_epsilon
    sum_13 = (
        product_10
        + product_105
        + product_106
        + product_113
        + product_114
        + product_12
        + product_13
        + product_14
        + product_15
        + product_16
        + product_17
        + product_18
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
        + product_31
        + product_32
        + product_33
        + product_34
        + product_35
        + product_36
        + product_37
        + product_38
        + product_39
        + product_41
        + product_44
        + product_45
        + product_46
        + product_47
        + product_48
        + product_49
        + product_50
        + product_51
        + product_52
        + product_53
        + product_54
        + product_55
        + product_56
        + product_57
        + product_58
        + product_59
        + product_60
        + product_61
        + product_62
        + product_63
        + product_64
        + product_65
        + product_66
        + product_67
        + product_68
        + product_69
        + product_7
        + product_70
        + product_71
        + product_72
        + product_73
        + product_74
        + product_75
        + product_76
        + product_77
        + product_78
        + product_79
        + product_8
        + product_80
    )
    part_00_cos_epsilon2_sin_beta2 = (
        attenuation_beta * attenuation_predicted_beta_squared_squared * predicted_rho * predicted_sigma_beta * predicted_sigma_r * rho * sigma_beta * sigma_r * sum_11 * term_1
        + attenuation_predicted_beta_squared_squared * predicted_rho_squared * predicted_sigma_beta_squared * predicted_sigma_r_squared * sum_12 * term_1
        + 0.25 * predicted_sigma_r_squared * sum_13 * term_1 * term_2
        + 0.25 * r_squared * sum_13 * term_1 * term_2
        + 0.25 * rho_squared * sigma_beta_squared * sigma_r_squared * sum_5 * term_1 * term_2
        + 0.25 * sigma_r_squared * sum_4 * term_1 * term_2
    )
    sum_14 = (
        -2.0 * attenuation_epsilon * attenuation_predicted_epsilon * shortfall_epsilon
        - 2.0 * attenuation_epsilon * shortfall_epsilon * shortfall_predicted_epsilon
        - attenuation_epsilon_squared * shortfall_predicted_epsilon
        - attenuation_predicted_epsilon * shortfall_epsilon_squared
        - shortfall_epsilon_squared * shortfall_predicted_epsilon
    )
    sum_15 = (
        product_108
        - 2.0 * attenuation_beta * attenuation_epsilon * attenuation_predicted_epsilon * shortfall_epsilon
        + product_109
        + product_110
        + product_111
        + product_112
    )
    sum_16 = (
        product_10
        + product_100
        + product_105
        + product_106
        + product_107
        + product_113
        + product_114
        + product_12
        + product_13
        + product_14
        + product_16
        + product_17
        + product_18
        + product_22
        + product_23
        + product_24
        + product_25
        + product_28
        + product_29
        + product_30
        + product_31
        + product_32
        + product_33
        + product_34
        + product_35
        + product_36
        + product_37
        + product_38
        + product_39
        + product_41
        + product_42
        + product_44
        + product_45
        + product_46
        + product_47
        + product_48
        + product_49
        + product_50
        + product_51
        + product_52
        + product_53
        + product_54
        + product_55
        + product_56
        + product_61
        + product_62
        + product_63
        + product_64
        + product_67
        + product_68
        + product_69
        + product_70
        + product_71
        + product_72
        + product_73
        + product_74
        + product_75
        + product_76
        + product_77
        + product_78
        + product_79
        + product_80
        + product_81
        + product_84
        + product_86
        + product_88
        + product_91
        + product_95
        + product_98
    )
    part_00_sin_beta2_sin_epsilon2 = (
        attenuation_beta * attenuation_predicted_beta_squared_squared * predicted_rho * predicted_sigma_beta * predicted_sigma_r * rho * sigma_beta * sigma_r * sum_14 * term_1
        + attenuation_predicted_beta_squared_squared * predicted_rho_squared * predicted_sigma_beta_squared * predicted_sigma_r_squared * sum_15 * term_1
        + 0.25 * predicted_sigma_r_squared * sum_16 * term_1 * term_2
        + 0.25 * r_squared * sum_16 * term_1 * term_2
        + 0.25 * rho_squared * sigma_beta_squared * sigma_r_squared * sum_10 * term_1 * term_2
        + 0.25 * sigma_r_squared * sum_9 * term_1 * term_2
    )
    part_00_cos_beta_cos_epsilon2_sin_beta = (
        2.0 * attenuation_predicted_beta_squared_squared * predicted_rho * predicted_sigma_beta * predicted_sigma_r * r * sum_2 * term_1
        + attenuation_beta * attenuation_predicted_beta_squared_squared * r * rho * sigma_beta * sigma_r * sum_1 * term_1
    )
    part_00_cos_beta_sin_beta_sin_epsilon2 = (
        2.0 * attenuation_predicted_beta_squared_squared * predicted_rho * predicted_sigma_beta * predicted_sigma_r * r * sum_7 * term_1
        + attenuation_beta * attenuation_predicted_beta_squared_squared * r * rho * sigma_beta * sigma_r * sum_6 * term_1
    )
    part_01_cos_beta2_cos_epsilon2 = (
        0.5 * attenuation_beta * attenuation_predicted_beta_squared_squared * r * rho * sigma_beta * sigma_r * sum_1 * term_1
        + attenuation_predicted_beta_squared_squared * predicted_rho * predicted_sigma_beta * predicted_sigma_r * r * sum_2 * term_1
    )
    part_01_cos_beta2_sin_epsilon2 = (
        0.5 * attenuation_beta * attenuation_predicted_beta_squared_squared * r * rho * sigma_beta * sigma_r * sum_6 * term_1
        + attenuation_predicted_beta_squared_squared * predicted_rho * predicted_sigma_beta * predicted_sigma_r * r * sum_7 * term_1
    )
    part_01_cos_beta_cos_epsilon2_sin_beta = (
        2.0 * attenuation_beta * attenuation_predicted_beta_squared_squared * predicted_rho * predicted_sigma_beta * predicted_sigma_r * rho * sigma_beta * sigma_r * sum_11 * term_1
        + 2.0 * attenuation_predicted_beta_squared_squared * predicted_rho_squared * predicted_sigma_beta_squared * predicted_sigma_r_squared * sum_12 * term_1
        + 0.5 * attenuation_beta * attenuation_predicted_beta_squared_squared * rho_squared * sigma_beta_squared * sigma_r_squared * sum_11 * term_1
        + 0.5 * attenuation_beta * attenuation_predicted_beta_squared_squared * sigma_r_squared * sum_1 * term_1
        + 0.5 * attenuation_predicted_beta_squared_squared * predicted_sigma_r_squared * sum_2 * term_1
        + 0.5 * attenuation_predicted_beta_squared_squared * r_squared * sum_2 * term_1
    )
    part_01_cos_beta_sin_beta_sin_epsilon2 = (
        2.0 * attenuation_beta * attenuation_predicted_beta_squared_squared * predicted_rho * predicted_sigma_beta * predicted_sigma_r * rho * sigma_beta * sigma_r * sum_14 * term_1
        + 2.0 * attenuation_predicted_beta_squared_squared * predicted_rho_squared * predicted_sigma_beta_squared * predicted_sigma_r_squared * sum_15 * term_1
        + 0.5 * attenuation_beta * attenuation_predicted_beta_squared_squared * rho_squared * sigma_beta_squared * sigma_r_squared * sum_14 * term_1
        + 0.5 * attenuation_beta * attenuation_predicted_beta_squared_squared * sigma_r_squared * sum_6 * term_1
        + 0.5 * attenuation_predicted_beta_squared_squared * predicted_sigma_r_squared * sum_7 * term_1
        + 0.5 * attenuation_predicted_beta_squared_squared * r_squared * sum_7 * term_1
    )
    part_01_cos_epsilon2_sin_beta2 = (
        0.5 * attenuation_beta * attenuation_predicted_beta_squared_squared * r * rho * sigma_beta * sigma_r * sum_11 * term_1
        + attenuation_predicted_beta_squared_squared * predicted_rho * predicted_sigma_beta * predicted_sigma_r * r * sum_12 * term_1
    )
    part_01_sin_beta2_sin_epsilon2 = (
        0.5 * attenuation_beta * attenuation_predicted_beta_squared_squared * r * rho * sigma_beta * sigma_r * sum_14 * term_1
        + attenuation_predicted_beta_squared_squared * predicted_rho * predicted_sigma_beta * predicted_sigma_r * r * sum_15 * term_1
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
        2.0 * attenuation_predicted_beta_squared_squared * predicted_rho * predicted_sigma_beta * predicted_sigma_r * r * sum_12 * term_1
        + attenuation_beta * attenuation_predicted_beta_squared_squared * r * rho * sigma_beta * sigma_r * sum_11 * term_1
    )
    part_11_cos_beta_sin_beta_sin_epsilon2 = (
        2.0 * attenuation_predicted_beta_squared_squared * predicted_rho * predicted_sigma_beta * predicted_sigma_r * r * sum_15 * term_1
        + attenuation_beta * attenuation_predicted_beta_squared_squared * r * rho * sigma_beta * sigma_r * sum_14 * term_1
    )
    sum_17 = 1.0 + attenuation_epsilon * attenuation_predicted_epsilon
    part_22_cos_epsilon2 = (
        0.5 * predicted_sigma_r_squared * shortfall_epsilon * sum_17 * term_1
        + 0.5 * r_squared * shortfall_epsilon * sum_17 * term_1
        + 0.5 * sigma_r_squared * sum_6 * term_1
    )
    sum_18 = shortfall_epsilon - shortfall_epsilon * shortfall_predicted_epsilon + shortfall_predicted_epsilon
    part_22_sin_epsilon2 = (
        0.5 * predicted_sigma_r_squared * shortfall_epsilon * sum_18 * term_1
        + 0.5 * r_squared * shortfall_epsilon * sum_18 * term_1
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

    Accuracy: at most 90.2 ulp anywhere in this domain with independent errors, proved for elementary
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
    shortfall_epsilon_squared = shortfall_epsilon**2
    shortfall_beta_squared = shortfall_beta**2
    sum_5 = (
        2.0 * attenuation_beta * shortfall_beta * shortfall_epsilon_squared
        + 2.0 * attenuation_beta_squared * shortfall_epsilon_squared
        + 2.0 * attenuation_epsilon * shortfall_beta_squared * shortfall_epsilon
        + 2.0 * attenuation_epsilon_squared * shortfall_beta_squared
        + shortfall_beta_squared * shortfall_epsilon_squared
    )
    part_00_cos_epsilon2_sin_beta2 = (
        0.25 * r_squared * sum_5 * term_1 * term_2
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
    sum_8 = (
        attenuation_beta * shortfall_epsilon_squared
        - 2.0 * attenuation_epsilon * shortfall_beta * shortfall_epsilon
        - 2.0 * attenuation_epsilon_squared * shortfall_beta
    )
    part_01_cos_beta_cos_epsilon2_sin_beta = (
        0.5 * attenuation_beta * rho_squared * sigma_beta_squared * sigma_r_squared * sum_6 * term_2
        + 0.5 * attenuation_beta * sigma_r_squared * sum_7 * term_2
        + 0.5 * r_squared * sum_8 * term_2
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

    Accuracy: at most 2330 ulp anywhere in this domain with independent errors, proved for elementary
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
    product_3 = -attenuation_beta_squared * attenuation_epsilon
    product_4 = -attenuation_beta_squared * product_2
    product_5 = attenuation_beta * attenuation_beta_squared
    product_6 = -attenuation_epsilon * product_5
    product_7 = -product_2 * product_5
    attenuation_beta_squared_squared = attenuation_beta_squared**2
    product_8 = -attenuation_beta_squared_squared * attenuation_epsilon
    product_9 = -attenuation_beta_squared_squared * product_2
    product_10 = attenuation_beta * attenuation_beta_squared**2
    product_11 = -attenuation_epsilon * product_10
    product_12 = -product_10 * product_2
    product_13 = attenuation_beta * attenuation_beta_squared * attenuation_beta_squared**2
    r_squared = r**2
    sum_2 = (
        1.0
        + attenuation_beta
        + attenuation_beta * attenuation_epsilon_squared_squared
        + attenuation_beta_squared
        + attenuation_beta_squared * attenuation_epsilon_squared_squared
        + attenuation_beta_squared_cubed
        + attenuation_beta_squared_cubed * attenuation_epsilon_squared_squared
        + attenuation_beta_squared_squared
        + attenuation_beta_squared_squared * attenuation_epsilon_squared_squared
        + attenuation_epsilon_squared_squared
        + attenuation_epsilon_squared_squared * product_10
        + attenuation_epsilon_squared_squared * product_13
        + attenuation_epsilon_squared_squared * product_5
        + product_10
        + product_11
        + product_12
        + product_13
        + product_3
        + product_4
        + product_5
        + product_6
        + product_7
        + product_8
        + product_9
    )
    product_14 = 2.0 * attenuation_beta_squared * attenuation_epsilon_squared_squared
    sum_3 = (
        2.0
        + 2.0 * attenuation_beta
        + 2.0 * attenuation_beta * attenuation_epsilon_squared_squared
        + 2.0 * attenuation_beta_squared
        + 2.0 * attenuation_beta_squared_cubed
        + 2.0 * attenuation_beta_squared_cubed * attenuation_epsilon_squared_squared
        + 2.0 * attenuation_beta_squared_squared
        + 2.0 * attenuation_beta_squared_squared * attenuation_epsilon_squared_squared
        + 2.0 * attenuation_epsilon_squared_squared
        + 2.0 * attenuation_epsilon_squared_squared * product_10
        + 2.0 * attenuation_epsilon_squared_squared * product_13
        + 2.0 * attenuation_epsilon_squared_squared * product_5
        + 2.0 * product_10
        + 2.0 * product_13
        + 2.0 * product_5
        + product_11
        + product_12
        + product_14
        + product_3
        + product_4
        + product_6
        + product_7
        + product_8
        + product_9
    )
    part_00_cos_beta2_cos_epsilon2 = (
        0.25 * r_squared * shortfall_beta * sum_2 * term_1 * term_3
        + 0.25 * rho_squared * sigma_beta_squared * sigma_r_squared * sum_1 * term_1 * term_3
        + 0.25 * shortfall_beta * sigma_r_squared * sum_3 * term_1 * term_3
    )
    sum_4 = (
        1.0
        + attenuation_beta
        + attenuation_beta * attenuation_epsilon
        + attenuation_beta * attenuation_epsilon_squared
        + attenuation_beta * product_2
        + attenuation_beta_squared
        + attenuation_beta_squared * product_2
        + attenuation_beta_squared_cubed
        + attenuation_beta_squared_cubed * attenuation_epsilon
        + attenuation_beta_squared_cubed * attenuation_epsilon_squared
        + attenuation_beta_squared_cubed * product_2
        + attenuation_beta_squared_squared
        + attenuation_beta_squared_squared * product_2
        + attenuation_epsilon
        + attenuation_epsilon * product_13
        + attenuation_epsilon_squared
        + attenuation_epsilon_squared * product_13
        + product_10
        + product_10 * product_2
        + product_13
        + product_13 * product_2
        + product_2
        + product_2 * product_5
        + product_5
    )
    product_15 = 2.0 * attenuation_beta_squared * product_2
    sum_5 = (
        2.0
        + 2.0 * attenuation_beta
        + 2.0 * attenuation_beta * attenuation_epsilon
        + 2.0 * attenuation_beta * attenuation_epsilon_squared
        + 2.0 * attenuation_beta * product_2
        + 2.0 * attenuation_beta_squared
        + 2.0 * attenuation_beta_squared_cubed
        + 2.0 * attenuation_beta_squared_cubed * attenuation_epsilon
        + 2.0 * attenuation_beta_squared_cubed * attenuation_epsilon_squared
        + 2.0 * attenuation_beta_squared_cubed * product_2
        + 2.0 * attenuation_beta_squared_squared
        + 2.0 * attenuation_beta_squared_squared * product_2
        + 2.0 * attenuation_epsilon
        + 2.0 * attenuation_epsilon * product_13
        + 2.0 * attenuation_epsilon_squared
        + 2.0 * attenuation_epsilon_squared * product_13
        + 2.0 * product_10
        + 2.0 * product_10 * product_2
        + 2.0 * product_13
        + 2.0 * product_13 * product_2
        + 2.0 * product_2
        + 2.0 * product_2 * product_5
        + 2.0 * product_5
        + attenuation_beta_squared * attenuation_epsilon
        + attenuation_beta_squared * attenuation_epsilon_squared
        + attenuation_beta_squared_squared * attenuation_epsilon
        + attenuation_beta_squared_squared * attenuation_epsilon_squared
        + attenuation_epsilon * product_10
        + attenuation_epsilon * product_5
        + attenuation_epsilon_squared * product_10
        + attenuation_epsilon_squared * product_5
        + product_15
    )
    sum_6 = (
        1.0
        - 4.0 * attenuation_beta_squared_cubed * attenuation_epsilon_squared
        + 9.0 * attenuation_epsilon * term_2
        + 9.0 * attenuation_epsilon_squared * term_2
        + 9.0 * product_2 * term_2
        + 9.0 * term_2
        + attenuation_epsilon
        + attenuation_epsilon_squared
        + product_1
        + product_2
    )
    part_00_cos_beta2_sin_epsilon2 = (
        0.25 * r_squared * shortfall_beta * shortfall_epsilon * sum_4 * term_1 * term_3
        + 0.25 * rho_squared * shortfall_epsilon * sigma_beta_squared * sigma_r_squared * sum_6 * term_1 * term_3
        + 0.25 * shortfall_beta * shortfall_epsilon * sigma_r_squared * sum_5 * term_1 * term_3
    )
    shortfall_beta_squared = shortfall_beta**2
    product_16 = shortfall_beta * shortfall_beta_squared**2
    shortfall_beta_squared_cubed = shortfall_beta_squared * shortfall_beta_squared**2
    shortfall_beta_squared_squared = shortfall_beta_squared**2
    shortfall_epsilon_squared = shortfall_epsilon**2
    product_17 = shortfall_epsilon * shortfall_epsilon_squared
    product_18 = shortfall_beta * shortfall_beta_squared
    product_19 = shortfall_beta * shortfall_beta_squared * shortfall_beta_squared**2
    product_20 = 16.0 * attenuation_beta * attenuation_epsilon_squared_squared * product_19
    shortfall_epsilon_squared_squared = shortfall_epsilon_squared**2
    term_4 = (shortfall_beta_squared**2)**2
    product_21 = 2.0 * attenuation_epsilon_squared_squared * term_4
    product_22 = 28.0 * attenuation_beta_squared * shortfall_beta_squared_cubed * shortfall_epsilon_squared_squared
    product_23 = 28.0 * attenuation_beta_squared_cubed * shortfall_beta_squared * shortfall_epsilon_squared_squared
    product_24 = 32.0 * attenuation_beta * product_19 * product_2 * shortfall_epsilon
    product_25 = 32.0 * attenuation_beta * attenuation_epsilon * product_17 * product_19
    product_26 = 4.0 * product_2 * shortfall_epsilon * term_4
    product_27 = 4.0 * attenuation_epsilon * product_17 * term_4
    product_28 = 48.0 * attenuation_beta * attenuation_epsilon_squared * product_19 * shortfall_epsilon_squared
    product_29 = 56.0 * product_16 * product_5 * shortfall_epsilon_squared_squared
    product_30 = 56.0 * product_10 * product_18 * shortfall_epsilon_squared_squared
    product_31 = 6.0 * attenuation_epsilon_squared * shortfall_epsilon_squared * term_4
    product_32 = 70.0 * attenuation_beta_squared_squared * shortfall_beta_squared_squared * shortfall_epsilon_squared_squared
    product_33 = 8.0 * product_13 * shortfall_beta * shortfall_epsilon_squared_squared
    product_34 = 8.0 * attenuation_beta * product_19 * shortfall_epsilon_squared_squared
    product_35 = shortfall_epsilon_squared_squared * term_4
    sum_7 = (
        100.0 * attenuation_epsilon_squared_squared * product_16 * product_5
        + 108.0 * attenuation_beta_squared * product_2 * shortfall_beta_squared_cubed * shortfall_epsilon
        + 110.0 * attenuation_beta_squared_squared * attenuation_epsilon_squared_squared * shortfall_beta_squared_squared
        + 111.0 * attenuation_beta_squared * attenuation_epsilon * product_17 * shortfall_beta_squared_cubed
        + 120.0 * attenuation_beta_squared_cubed * attenuation_epsilon_squared * shortfall_beta_squared * shortfall_epsilon_squared
        + 144.0 * product_10 * product_18 * product_2 * shortfall_epsilon
        + 165.0 * attenuation_beta_squared * attenuation_epsilon_squared * shortfall_beta_squared_cubed * shortfall_epsilon_squared
        + 2.0 * shortfall_epsilon_squared_squared * term_2
        + 200.0 * product_16 * product_2 * product_5 * shortfall_epsilon
        + 204.0 * attenuation_epsilon * product_10 * product_17 * product_18
        + 218.0 * attenuation_epsilon * product_16 * product_17 * product_5
        + 220.0 * attenuation_beta_squared_squared * product_2 * shortfall_beta_squared_squared * shortfall_epsilon
        + 24.0 * attenuation_beta_squared_cubed * attenuation_epsilon_squared_squared * shortfall_beta_squared
        + 24.0 * attenuation_epsilon * product_13 * product_17 * shortfall_beta
        + 24.0 * attenuation_epsilon_squared * product_13 * shortfall_beta * shortfall_epsilon_squared
        + 265.0 * attenuation_beta_squared_squared * attenuation_epsilon * product_17 * shortfall_beta_squared_squared
        + 276.0 * attenuation_epsilon_squared * product_10 * product_18 * shortfall_epsilon_squared
        + 318.0 * attenuation_epsilon_squared * product_16 * product_5 * shortfall_epsilon_squared
        + 375.0 * attenuation_beta_squared_squared * attenuation_epsilon_squared * shortfall_beta_squared_squared * shortfall_epsilon_squared
        + 48.0 * attenuation_beta_squared_cubed * product_2 * shortfall_beta_squared * shortfall_epsilon
        + 54.0 * attenuation_beta_squared * attenuation_epsilon_squared_squared * shortfall_beta_squared_cubed
        + 6.0 * attenuation_epsilon * product_17 * term_2
        + 6.0 * attenuation_epsilon_squared * shortfall_epsilon_squared * term_2
        + 72.0 * attenuation_epsilon_squared_squared * product_10 * product_18
        + 96.0 * attenuation_beta_squared_cubed * attenuation_epsilon * product_17 * shortfall_beta_squared
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
        + product_31
        + product_32
        + product_33
        + product_34
        + product_35
    )
    sum_8 = (
        112.0 * attenuation_beta_squared * attenuation_epsilon * product_17 * shortfall_beta_squared_cubed
        - 16.0 * product_2 * shortfall_epsilon * term_2
        - 28.0 * attenuation_epsilon * product_17 * term_2
        - 36.0 * attenuation_epsilon_squared * shortfall_epsilon_squared * term_2
        - 8.0 * attenuation_epsilon_squared_squared * term_2
        - 8.0 * shortfall_epsilon_squared_squared * term_2
        + 112.0 * attenuation_beta_squared * product_2 * shortfall_beta_squared_cubed * shortfall_epsilon
        + 112.0 * attenuation_epsilon_squared_squared * product_10 * product_18
        + 112.0 * attenuation_epsilon_squared_squared * product_16 * product_5
        + 116.0 * attenuation_beta_squared_cubed * attenuation_epsilon * product_17 * shortfall_beta_squared
        + 128.0 * attenuation_beta_squared_cubed * product_2 * shortfall_beta_squared * shortfall_epsilon
        + 140.0 * attenuation_beta_squared_squared * attenuation_epsilon_squared_squared * shortfall_beta_squared_squared
        + 168.0 * attenuation_beta_squared * attenuation_epsilon_squared * shortfall_beta_squared_cubed * shortfall_epsilon_squared
        + 180.0 * attenuation_beta_squared_cubed * attenuation_epsilon_squared * shortfall_beta_squared * shortfall_epsilon_squared
        + 224.0 * attenuation_epsilon * product_10 * product_17 * product_18
        + 224.0 * attenuation_epsilon * product_16 * product_17 * product_5
        + 224.0 * product_10 * product_18 * product_2 * shortfall_epsilon
        + 224.0 * product_16 * product_2 * product_5 * shortfall_epsilon
        + 280.0 * attenuation_beta_squared_squared * attenuation_epsilon * product_17 * shortfall_beta_squared_squared
        + 280.0 * attenuation_beta_squared_squared * product_2 * shortfall_beta_squared_squared * shortfall_epsilon
        + 32.0 * attenuation_epsilon_squared_squared * product_13 * shortfall_beta
        + 336.0 * attenuation_epsilon_squared * product_10 * product_18 * shortfall_epsilon_squared
        + 336.0 * attenuation_epsilon_squared * product_16 * product_5 * shortfall_epsilon_squared
        + 40.0 * attenuation_epsilon * product_13 * product_17 * shortfall_beta
        + 420.0 * attenuation_beta_squared_squared * attenuation_epsilon_squared * shortfall_beta_squared_squared * shortfall_epsilon_squared
        + 56.0 * attenuation_beta_squared * attenuation_epsilon_squared_squared * shortfall_beta_squared_cubed
        + 64.0 * attenuation_beta_squared_cubed * attenuation_epsilon_squared_squared * shortfall_beta_squared
        + 64.0 * product_13 * product_2 * shortfall_beta * shortfall_epsilon
        + 72.0 * attenuation_epsilon_squared * product_13 * shortfall_beta * shortfall_epsilon_squared
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
        + product_31
        + product_32
        + product_33
        + product_34
        + product_35
    )
    product_36 = -attenuation_beta_squared_cubed * attenuation_epsilon
    sum_9 = (
        2.0
        - attenuation_beta_squared_cubed * product_2
        + 2.0 * attenuation_epsilon_squared_squared
        + 2.0 * attenuation_epsilon_squared_squared * term_2
        + 2.0 * term_2
        + product_3
        + product_36
        + product_4
    )
    part_00_cos_epsilon2_sin_beta2 = (
        0.25 * r_squared * sum_7 * term_1 * term_3
        + 0.25 * rho_squared * sigma_beta_squared * sigma_r_squared * sum_8 * term_1 * term_3
        + 0.25 * sigma_r_squared * sum_9 * term_1 * term_3
    )
    product_37 = -attenuation_beta_squared * attenuation_epsilon_squared
    product_38 = -attenuation_beta_squared_cubed * attenuation_epsilon_squared
    sum_10 = (
        1.0
        + attenuation_epsilon
        + attenuation_epsilon * term_2
        + attenuation_epsilon_squared
        + attenuation_epsilon_squared * term_2
        + product_2
        + product_2 * term_2
        + product_3
        + product_36
        + product_37
        + product_38
        + term_2
    )
    sum_11 = (
        112.0 * attenuation_beta_squared * attenuation_epsilon * shortfall_beta_squared_cubed * shortfall_epsilon_squared
        - 24.0 * product_2 * term_2
        - 28.0 * attenuation_epsilon * shortfall_epsilon_squared * term_2
        - 36.0 * attenuation_epsilon_squared * shortfall_epsilon * term_2
        - 8.0 * product_17 * term_2
        + 112.0 * attenuation_beta_squared * product_2 * shortfall_beta_squared_cubed
        + 116.0 * attenuation_beta_squared_cubed * attenuation_epsilon * shortfall_beta_squared * shortfall_epsilon_squared
        + 120.0 * attenuation_beta_squared_cubed * product_2 * shortfall_beta_squared
        + 168.0 * attenuation_beta_squared * attenuation_epsilon_squared * shortfall_beta_squared_cubed * shortfall_epsilon
        + 180.0 * attenuation_beta_squared_cubed * attenuation_epsilon_squared * shortfall_beta_squared * shortfall_epsilon
        + 224.0 * attenuation_epsilon * product_10 * product_18 * shortfall_epsilon_squared
        + 224.0 * attenuation_epsilon * product_16 * product_5 * shortfall_epsilon_squared
        + 224.0 * product_10 * product_18 * product_2
        + 224.0 * product_16 * product_2 * product_5
        + 28.0 * attenuation_beta_squared * product_17 * shortfall_beta_squared_cubed
        + 28.0 * attenuation_beta_squared_cubed * product_17 * shortfall_beta_squared
        + 280.0 * attenuation_beta_squared_squared * attenuation_epsilon * shortfall_beta_squared_squared * shortfall_epsilon_squared
        + 280.0 * attenuation_beta_squared_squared * product_2 * shortfall_beta_squared_squared
        + 32.0 * attenuation_beta * attenuation_epsilon * product_19 * shortfall_epsilon_squared
        + 32.0 * attenuation_beta * product_19 * product_2
        + 336.0 * attenuation_epsilon_squared * product_10 * product_18 * shortfall_epsilon
        + 336.0 * attenuation_epsilon_squared * product_16 * product_5 * shortfall_epsilon
        + 4.0 * attenuation_epsilon * shortfall_epsilon_squared * term_4
        + 4.0 * product_2 * term_4
        + 40.0 * attenuation_epsilon * product_13 * shortfall_beta * shortfall_epsilon_squared
        + 420.0 * attenuation_beta_squared_squared * attenuation_epsilon_squared * shortfall_beta_squared_squared * shortfall_epsilon
        + 48.0 * attenuation_beta * attenuation_epsilon_squared * product_19 * shortfall_epsilon
        + 48.0 * product_13 * product_2 * shortfall_beta
        + 56.0 * product_10 * product_17 * product_18
        + 56.0 * product_16 * product_17 * product_5
        + 6.0 * attenuation_epsilon_squared * shortfall_epsilon * term_4
        + 70.0 * attenuation_beta_squared_squared * product_17 * shortfall_beta_squared_squared
        + 72.0 * attenuation_epsilon_squared * product_13 * shortfall_beta * shortfall_epsilon
        + 8.0 * attenuation_beta * product_17 * product_19
        + 8.0 * product_13 * product_17 * shortfall_beta
        + product_17 * term_4
    )
    sum_12 = (
        2.0
        + 2.0 * attenuation_epsilon
        + 2.0 * attenuation_epsilon * term_2
        + 2.0 * attenuation_epsilon_squared
        + 2.0 * attenuation_epsilon_squared * term_2
        + 2.0 * product_2
        + 2.0 * product_2 * term_2
        + 2.0 * term_2
        + product_3
        + product_36
        + product_37
        + product_38
    )
    part_00_sin_beta2_sin_epsilon2 = (
        0.25 * r_squared * shortfall_epsilon * sum_10 * term_1 * term_3
        + 0.25 * rho_squared * shortfall_epsilon * sigma_beta_squared * sigma_r_squared * sum_11 * term_1 * term_3
        + 0.25 * shortfall_epsilon * sigma_r_squared * sum_12 * term_1 * term_3
    )
    product_39 = -2.0 * attenuation_beta * attenuation_epsilon * product_17 * shortfall_beta
    product_40 = -2.0 * attenuation_epsilon_squared_squared * shortfall_beta_squared
    product_41 = -3.0 * attenuation_epsilon_squared * shortfall_beta_squared * shortfall_epsilon_squared
    product_42 = -4.0 * attenuation_beta * attenuation_epsilon_squared_squared * shortfall_beta
    product_43 = -4.0 * product_2 * shortfall_beta_squared * shortfall_epsilon
    product_44 = -6.0 * attenuation_beta * attenuation_epsilon_squared * shortfall_beta * shortfall_epsilon_squared
    product_45 = -8.0 * attenuation_beta * product_2 * shortfall_beta * shortfall_epsilon
    product_46 = -attenuation_epsilon * product_17 * shortfall_beta_squared
    sum_13 = (
        3.0 * attenuation_beta_squared * attenuation_epsilon * product_17
        + 3.0 * attenuation_beta_squared * attenuation_epsilon_squared * shortfall_epsilon_squared
        + attenuation_beta_squared * shortfall_epsilon_squared_squared
        + product_39
        + product_40
        + product_41
        + product_42
        + product_43
        + product_44
        + product_45
        + product_46
    )
    sum_14 = (
        12.0 * attenuation_epsilon_squared * shortfall_beta_squared * shortfall_epsilon_squared
        - 10.0 * attenuation_beta_squared * attenuation_epsilon_squared_squared
        - 20.0 * attenuation_beta_squared * product_2 * shortfall_epsilon
        - 32.0 * attenuation_beta_squared * attenuation_epsilon * product_17
        - 42.0 * attenuation_beta_squared * attenuation_epsilon_squared * shortfall_epsilon_squared
        - 9.0 * attenuation_beta_squared * shortfall_epsilon_squared_squared
        + 16.0 * attenuation_beta * attenuation_epsilon_squared_squared * shortfall_beta
        + 16.0 * product_2 * shortfall_beta_squared * shortfall_epsilon
        + 24.0 * attenuation_beta * attenuation_epsilon_squared * shortfall_beta * shortfall_epsilon_squared
        + 32.0 * attenuation_beta * product_2 * shortfall_beta * shortfall_epsilon
        + 4.0 * attenuation_epsilon * product_17 * shortfall_beta_squared
        + 8.0 * attenuation_beta * attenuation_epsilon * product_17 * shortfall_beta
        + 8.0 * attenuation_epsilon_squared_squared * shortfall_beta_squared
    )
    product_47 = 4.0 * attenuation_beta_squared * product_2 * shortfall_epsilon
    sum_15 = (
        2.0 * attenuation_beta_squared * shortfall_epsilon_squared_squared
        + 7.0 * attenuation_beta_squared * attenuation_epsilon * product_17
        + 9.0 * attenuation_beta_squared * attenuation_epsilon_squared * shortfall_epsilon_squared
        + product_14
        + product_39
        + product_40
        + product_41
        + product_42
        + product_43
        + product_44
        + product_45
        + product_46
        + product_47
    )
    part_01_cos_beta_cos_epsilon2_sin_beta = (
        0.5 * attenuation_beta_squared_squared * r_squared * sum_13 * term_1
        + 0.5 * attenuation_beta_squared_squared * rho_squared * sigma_beta_squared * sigma_r_squared * sum_14 * term_1
        + 0.5 * attenuation_beta_squared_squared * sigma_r_squared * sum_15 * term_1
    )
    product_48 = -2.0 * attenuation_beta * attenuation_epsilon * shortfall_beta * shortfall_epsilon_squared
    product_49 = -2.0 * product_2 * shortfall_beta_squared
    product_50 = -3.0 * attenuation_epsilon_squared * shortfall_beta_squared * shortfall_epsilon
    product_51 = -4.0 * attenuation_beta * product_2 * shortfall_beta
    product_52 = -6.0 * attenuation_beta * attenuation_epsilon_squared * shortfall_beta * shortfall_epsilon
    product_53 = -attenuation_epsilon * shortfall_beta_squared * shortfall_epsilon_squared
    sum_16 = (
        3.0 * attenuation_beta_squared * attenuation_epsilon * shortfall_epsilon_squared
        + 3.0 * attenuation_beta_squared * attenuation_epsilon_squared * shortfall_epsilon
        + attenuation_beta_squared * product_17
        + product_15
        + product_48
        + product_49
        + product_50
        + product_51
        + product_52
        + product_53
    )
    sum_17 = (
        12.0 * attenuation_epsilon_squared * shortfall_beta_squared * shortfall_epsilon
        - 28.0 * attenuation_beta_squared * product_2
        - 32.0 * attenuation_beta_squared * attenuation_epsilon * shortfall_epsilon_squared
        - 42.0 * attenuation_beta_squared * attenuation_epsilon_squared * shortfall_epsilon
        - 9.0 * attenuation_beta_squared * product_17
        + 16.0 * attenuation_beta * product_2 * shortfall_beta
        + 24.0 * attenuation_beta * attenuation_epsilon_squared * shortfall_beta * shortfall_epsilon
        + 4.0 * attenuation_epsilon * shortfall_beta_squared * shortfall_epsilon_squared
        + 8.0 * attenuation_beta * attenuation_epsilon * shortfall_beta * shortfall_epsilon_squared
        + 8.0 * product_2 * shortfall_beta_squared
    )
    sum_18 = (
        2.0 * attenuation_beta_squared * product_17
        + 6.0 * attenuation_beta_squared * product_2
        + 7.0 * attenuation_beta_squared * attenuation_epsilon * shortfall_epsilon_squared
        + 9.0 * attenuation_beta_squared * attenuation_epsilon_squared * shortfall_epsilon
        + product_48
        + product_49
        + product_50
        + product_51
        + product_52
        + product_53
    )
    part_01_cos_beta_sin_beta_sin_epsilon2 = (
        0.5 * attenuation_beta_squared_squared * r_squared * shortfall_epsilon * sum_16 * term_1
        + 0.5 * attenuation_beta_squared_squared * rho_squared * shortfall_epsilon * sigma_beta_squared * sigma_r_squared * sum_17 * term_1
        + 0.5 * attenuation_beta_squared_squared * shortfall_epsilon * sigma_r_squared * sum_18 * term_1
    )
    sum_19 = shortfall_epsilon - attenuation_epsilon
    sum_20 = attenuation_epsilon - shortfall_epsilon
    part_02_cos_epsilon_sin_beta_sin_epsilon = (
        attenuation_beta * attenuation_epsilon_squared * rho_squared * sigma_beta_squared * sigma_r_squared * sum_19
        - attenuation_beta * attenuation_epsilon_squared * r_squared * shortfall_epsilon
        + attenuation_beta * attenuation_epsilon_squared * sigma_r_squared * sum_20
    )
    sum_21 = 2.0 + 2.0 * product_2 + attenuation_epsilon + attenuation_epsilon_squared
    part_22_cos_epsilon2 = (
        0.5 * (1.0 + product_2) * r_squared * shortfall_epsilon * term_1
        + 0.5 * shortfall_epsilon * sigma_r_squared * sum_21 * term_1
    )
    sum_22 = 1.0 + attenuation_epsilon + attenuation_epsilon_squared
    sum_23 = 2.0 - attenuation_epsilon - product_2 + 2.0 * attenuation_epsilon_squared_squared
    part_22_sin_epsilon2 = (
        0.5 * r_squared * shortfall_epsilon_squared * sum_22 * term_1
        + 0.5 * sigma_r_squared * sum_23 * term_1
    )
    sum_24 = (
        10.0 * attenuation_beta_squared * attenuation_epsilon * product_17
        - 12.0 * attenuation_beta * attenuation_epsilon_squared * shortfall_beta * shortfall_epsilon_squared
        - 16.0 * attenuation_beta * product_2 * shortfall_beta * shortfall_epsilon
        - 2.0 * attenuation_epsilon * product_17 * shortfall_beta_squared
        - 4.0 * attenuation_beta * attenuation_epsilon * product_17 * shortfall_beta
        - 4.0 * attenuation_epsilon_squared_squared * shortfall_beta_squared
        - 6.0 * attenuation_epsilon_squared * shortfall_beta_squared * shortfall_epsilon_squared
        - 8.0 * attenuation_beta * attenuation_epsilon_squared_squared * shortfall_beta
        - 8.0 * product_2 * shortfall_beta_squared * shortfall_epsilon
        + 12.0 * attenuation_beta_squared * attenuation_epsilon_squared * shortfall_epsilon_squared
        + 3.0 * attenuation_beta_squared * shortfall_epsilon_squared_squared
        + product_14
        + product_47
    )
    cos_epsilon_squared = cos_epsilon**2
    sum_25 = (
        10.0 * attenuation_beta_squared * attenuation_epsilon * shortfall_epsilon_squared
        - 12.0 * attenuation_beta * attenuation_epsilon_squared * shortfall_beta * shortfall_epsilon
        - 2.0 * attenuation_epsilon * shortfall_beta_squared * shortfall_epsilon_squared
        - 4.0 * attenuation_beta * attenuation_epsilon * shortfall_beta * shortfall_epsilon_squared
        - 4.0 * product_2 * shortfall_beta_squared
        - 6.0 * attenuation_epsilon_squared * shortfall_beta_squared * shortfall_epsilon
        - 8.0 * attenuation_beta * product_2 * shortfall_beta
        + 12.0 * attenuation_beta_squared * attenuation_epsilon_squared * shortfall_epsilon
        + 3.0 * attenuation_beta_squared * product_17
        + 8.0 * attenuation_beta_squared * product_2
    )
    sin_epsilon_squared = sin_epsilon**2
    cos_beta_squared = cos_beta**2
    sin_beta_squared = sin_beta**2
    sum_26 = (
        12.0 * attenuation_beta * attenuation_epsilon_squared * shortfall_beta * shortfall_epsilon_squared
        - 10.0 * attenuation_beta_squared * attenuation_epsilon * product_17
        - 12.0 * attenuation_beta_squared * attenuation_epsilon_squared * shortfall_epsilon_squared
        - 2.0 * attenuation_beta_squared * attenuation_epsilon_squared_squared
        - 3.0 * attenuation_beta_squared * shortfall_epsilon_squared_squared
        - 4.0 * attenuation_beta_squared * product_2 * shortfall_epsilon
        + 16.0 * attenuation_beta * product_2 * shortfall_beta * shortfall_epsilon
        + 2.0 * attenuation_epsilon * product_17 * shortfall_beta_squared
        + 4.0 * attenuation_beta * attenuation_epsilon * product_17 * shortfall_beta
        + 4.0 * attenuation_epsilon_squared_squared * shortfall_beta_squared
        + 6.0 * attenuation_epsilon_squared * shortfall_beta_squared * shortfall_epsilon_squared
        + 8.0 * attenuation_beta * attenuation_epsilon_squared_squared * shortfall_beta
        + 8.0 * product_2 * shortfall_beta_squared * shortfall_epsilon
    )
    sum_27 = (
        12.0 * attenuation_beta * attenuation_epsilon_squared * shortfall_beta * shortfall_epsilon
        - 10.0 * attenuation_beta_squared * attenuation_epsilon * shortfall_epsilon_squared
        - 12.0 * attenuation_beta_squared * attenuation_epsilon_squared * shortfall_epsilon
        - 3.0 * attenuation_beta_squared * product_17
        - 8.0 * attenuation_beta_squared * product_2
        + 2.0 * attenuation_epsilon * shortfall_beta_squared * shortfall_epsilon_squared
        + 4.0 * attenuation_beta * attenuation_epsilon * shortfall_beta * shortfall_epsilon_squared
        + 4.0 * product_2 * shortfall_beta_squared
        + 6.0 * attenuation_epsilon_squared * shortfall_beta_squared * shortfall_epsilon
        + 8.0 * attenuation_beta * product_2 * shortfall_beta
    )
    sum_28 = attenuation_epsilon - 2.0 * shortfall_epsilon
    sum_29 = 2.0 * shortfall_epsilon - attenuation_epsilon
    result = _empty(arguments, (3, 3))
    result[..., 0, 0] = (
        attenuation_beta_squared_squared * cos_beta * cos_epsilon_squared * r * rho * sigma_beta * sigma_r * sin_beta * sum_24 * term_1
        + attenuation_beta_squared_squared * cos_beta * r * rho * shortfall_epsilon * sigma_beta * sigma_r * sin_beta * sin_epsilon_squared * sum_25 * term_1
        + cos_beta_squared * cos_epsilon_squared * part_00_cos_beta2_cos_epsilon2
        + cos_beta_squared * part_00_cos_beta2_sin_epsilon2 * sin_epsilon_squared
        + cos_epsilon_squared * part_00_cos_epsilon2_sin_beta2 * sin_beta_squared
        + part_00_sin_beta2_sin_epsilon2 * sin_beta_squared * sin_epsilon_squared
    )
    result[..., 0, 1] = (
        0.5 * attenuation_beta_squared_squared * cos_beta_squared * cos_epsilon_squared * r * rho * sigma_beta * sigma_r * sum_24 * term_1
        + 0.5 * attenuation_beta_squared_squared * cos_beta_squared * r * rho * shortfall_epsilon * sigma_beta * sigma_r * sin_epsilon_squared * sum_25 * term_1
        + 0.5 * attenuation_beta_squared_squared * cos_epsilon_squared * r * rho * sigma_beta * sigma_r * sin_beta_squared * sum_26 * term_1
        + 0.5 * attenuation_beta_squared_squared * r * rho * shortfall_epsilon * sigma_beta * sigma_r * sin_beta_squared * sin_epsilon_squared * sum_27 * term_1
        + cos_beta * cos_epsilon_squared * part_01_cos_beta_cos_epsilon2_sin_beta * sin_beta
        + cos_beta * part_01_cos_beta_sin_beta_sin_epsilon2 * sin_beta * sin_epsilon_squared
    )
    result[..., 0, 2] = (
        attenuation_beta * attenuation_epsilon_squared * cos_beta * cos_epsilon * r * rho * sigma_beta * sigma_r * sin_epsilon * sum_28
        + cos_epsilon * part_02_cos_epsilon_sin_beta_sin_epsilon * sin_beta * sin_epsilon
    )
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = (
        attenuation_beta_squared_squared * cos_beta * cos_epsilon_squared * r * rho * sigma_beta * sigma_r * sin_beta * sum_26 * term_1
        + attenuation_beta_squared_squared * cos_beta * r * rho * shortfall_epsilon * sigma_beta * sigma_r * sin_beta * sin_epsilon_squared * sum_27 * term_1
        + cos_beta_squared * cos_epsilon_squared * part_00_cos_epsilon2_sin_beta2
        + cos_beta_squared * part_00_sin_beta2_sin_epsilon2 * sin_epsilon_squared
        + cos_epsilon_squared * part_00_cos_beta2_cos_epsilon2 * sin_beta_squared
        + part_00_cos_beta2_sin_epsilon2 * sin_beta_squared * sin_epsilon_squared
    )
    result[..., 1, 2] = (
        attenuation_beta * attenuation_epsilon_squared * cos_epsilon * r * rho * sigma_beta * sigma_r * sin_beta * sin_epsilon * sum_29
        + cos_beta * cos_epsilon * part_02_cos_epsilon_sin_beta_sin_epsilon * sin_epsilon
    )
    result[..., 2, 0] = result[..., 0, 2]
    result[..., 2, 1] = result[..., 1, 2]
    result[..., 2, 2] = (
        cos_epsilon_squared * part_22_cos_epsilon2
        + part_22_sin_epsilon2 * sin_epsilon_squared
    )
    return result
