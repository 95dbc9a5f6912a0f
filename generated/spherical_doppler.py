"""NumPy functions of the quantities spherical_doppler.*.

Written by radartrack regenerate, generator 1, derivation 415b27661c08e587; not to be edited.
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


def map(*, r: npt.ArrayLike, beta: npt.ArrayLike, epsilon: npt.ArrayLike, rdot: npt.ArrayLike) -> Floats:
    """Map from the measured quantities to coordinates.

    Name: spherical_doppler.map.
    Definition: h.
    Conditioning: no expectation is taken.
    Source: Duan et al. 2005 range rate as a pseudo-measurement.

    Args:
        r: range [m], 1 to 1e+08.
        beta: azimuth, clockwise from the y axis [rad], -3.1416 to 3.1416.
        epsilon: elevation, up from the horizontal plane [rad], -1.5708 to 1.5708.
        rdot: range rate [m/s], -10000 to 10000.

    Returns:
        Shape of the broadcast arguments + (4), unit [m, m, m, m^2/s].

    Accuracy: at most 6.01 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 139.
    """
    arguments = _floats(r, beta, epsilon, rdot)
    r, beta, epsilon, rdot = arguments
    cos_beta = np.cos(beta)
    sin_beta = np.sin(beta)
    cos_epsilon = np.cos(epsilon)
    sin_epsilon = np.sin(epsilon)
    result = _empty(arguments, (4,))
    result[..., 0] = cos_epsilon * r * sin_beta
    result[..., 1] = cos_beta * cos_epsilon * r
    result[..., 2] = r * sin_epsilon
    result[..., 3] = r * rdot
    return result


def jacobian(*, r: npt.ArrayLike, beta: npt.ArrayLike, epsilon: npt.ArrayLike, rdot: npt.ArrayLike) -> Floats:
    """First derivatives of the map, [out, in].

    Name: spherical_doppler.jacobian.
    Definition: dh/dtheta.
    Conditioning: no expectation is taken.
    Source: Prosov (6)-(7).

    Args:
        r: range [m], 1 to 1e+08.
        beta: azimuth, clockwise from the y axis [rad], -3.1416 to 3.1416.
        epsilon: elevation, up from the horizontal plane [rad], -1.5708 to 1.5708.
        rdot: range rate [m/s], -10000 to 10000.

    Returns:
        Shape of the broadcast arguments + (4, 4), unit [m, m, m, m^2/s] × [1/m, 1/rad, 1/rad, s/m].

    Accuracy: at most 6.01 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 110.
    """
    arguments = _floats(r, beta, epsilon, rdot)
    r, beta, epsilon, rdot = arguments
    cos_beta = np.cos(beta)
    sin_beta = np.sin(beta)
    cos_epsilon = np.cos(epsilon)
    sin_epsilon = np.sin(epsilon)
    result = _empty(arguments, (4, 4))
    result[..., 0, 0] = cos_epsilon * sin_beta
    result[..., 0, 1] = cos_beta * cos_epsilon * r
    result[..., 0, 2] = -r * sin_beta * sin_epsilon
    result[..., 0, 3] = 0.0
    result[..., 1, 0] = cos_beta * cos_epsilon
    result[..., 1, 1] = -cos_epsilon * r * sin_beta
    result[..., 1, 2] = -cos_beta * r * sin_epsilon
    result[..., 1, 3] = 0.0
    result[..., 2, 0] = sin_epsilon
    result[..., 2, 1] = 0.0
    result[..., 2, 2] = cos_epsilon * r
    result[..., 2, 3] = 0.0
    result[..., 3, 0] = rdot
    result[..., 3, 1] = 0.0
    result[..., 3, 2] = 0.0
    result[..., 3, 3] = r
    return result


def hessian(*, r: npt.ArrayLike, beta: npt.ArrayLike, epsilon: npt.ArrayLike, rdot: npt.ArrayLike) -> Floats:
    """Second derivatives of the map, [out, in, in].

    Name: spherical_doppler.hessian.
    Definition: d2h/dtheta2.
    Conditioning: no expectation is taken.
    Source: Prosov (6)-(7).

    Args:
        r: range [m], 1 to 1e+08.
        beta: azimuth, clockwise from the y axis [rad], -3.1416 to 3.1416.
        epsilon: elevation, up from the horizontal plane [rad], -1.5708 to 1.5708.
        rdot: range rate [m/s], -10000 to 10000.

    Returns:
        Shape of the broadcast arguments + (4, 4, 4), unit [m, m, m, m^2/s] × [1/m, 1/rad, 1/rad, s/m] × [1/m,
        1/rad, 1/rad, s/m].

    Accuracy: at most 4.25 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 80.1.
    """
    arguments = _floats(r, beta, epsilon, rdot)
    r, beta, epsilon, rdot = arguments
    cos_beta = np.cos(beta)
    sin_beta = np.sin(beta)
    cos_epsilon = np.cos(epsilon)
    sin_epsilon = np.sin(epsilon)
    result = _empty(arguments, (4, 4, 4))
    result[..., 0, 0, 0] = 0.0
    result[..., 0, 0, 1] = cos_beta * cos_epsilon
    result[..., 0, 0, 2] = -sin_beta * sin_epsilon
    result[..., 0, 0, 3] = 0.0
    result[..., 0, 1, 0] = result[..., 0, 0, 1]
    result[..., 0, 1, 1] = -cos_epsilon * r * sin_beta
    result[..., 0, 1, 2] = -cos_beta * r * sin_epsilon
    result[..., 0, 1, 3] = 0.0
    result[..., 0, 2, 0] = result[..., 0, 0, 2]
    result[..., 0, 2, 1] = result[..., 0, 1, 2]
    result[..., 0, 2, 2] = result[..., 0, 1, 1]
    result[..., 0, 2, 3] = 0.0
    result[..., 0, 3, 0] = 0.0
    result[..., 0, 3, 1] = 0.0
    result[..., 0, 3, 2] = 0.0
    result[..., 0, 3, 3] = 0.0
    result[..., 1, 0, 0] = 0.0
    result[..., 1, 0, 1] = -cos_epsilon * sin_beta
    result[..., 1, 0, 2] = -cos_beta * sin_epsilon
    result[..., 1, 0, 3] = 0.0
    result[..., 1, 1, 0] = result[..., 1, 0, 1]
    result[..., 1, 1, 1] = -cos_beta * cos_epsilon * r
    result[..., 1, 1, 2] = r * sin_beta * sin_epsilon
    result[..., 1, 1, 3] = 0.0
    result[..., 1, 2, 0] = result[..., 1, 0, 2]
    result[..., 1, 2, 1] = result[..., 1, 1, 2]
    result[..., 1, 2, 2] = result[..., 1, 1, 1]
    result[..., 1, 2, 3] = 0.0
    result[..., 1, 3, 0] = 0.0
    result[..., 1, 3, 1] = 0.0
    result[..., 1, 3, 2] = 0.0
    result[..., 1, 3, 3] = 0.0
    result[..., 2, 0, 0] = 0.0
    result[..., 2, 0, 1] = 0.0
    result[..., 2, 0, 2] = cos_epsilon
    result[..., 2, 0, 3] = 0.0
    result[..., 2, 1, 0] = 0.0
    result[..., 2, 1, 1] = 0.0
    result[..., 2, 1, 2] = 0.0
    result[..., 2, 1, 3] = 0.0
    result[..., 2, 2, 0] = cos_epsilon
    result[..., 2, 2, 1] = 0.0
    result[..., 2, 2, 2] = -r * sin_epsilon
    result[..., 2, 2, 3] = 0.0
    result[..., 2, 3, 0] = 0.0
    result[..., 2, 3, 1] = 0.0
    result[..., 2, 3, 2] = 0.0
    result[..., 2, 3, 3] = 0.0
    result[..., 3, 0, 0] = 0.0
    result[..., 3, 0, 1] = 0.0
    result[..., 3, 0, 2] = 0.0
    result[..., 3, 0, 3] = 1.0
    result[..., 3, 1, 0] = 0.0
    result[..., 3, 1, 1] = 0.0
    result[..., 3, 1, 2] = 0.0
    result[..., 3, 1, 3] = 0.0
    result[..., 3, 2, 0] = 0.0
    result[..., 3, 2, 1] = 0.0
    result[..., 3, 2, 2] = 0.0
    result[..., 3, 2, 3] = 0.0
    result[..., 3, 3, 0] = 1.0
    result[..., 3, 3, 1] = 0.0
    result[..., 3, 3, 2] = 0.0
    result[..., 3, 3, 3] = 0.0
    return result


def bias_second_order(
    *,
    r: npt.ArrayLike,
    beta: npt.ArrayLike,
    epsilon: npt.ArrayLike,
    rdot: npt.ArrayLike,
    sigma_r: npt.ArrayLike,
    sigma_beta: npt.ArrayLike,
    sigma_epsilon: npt.ArrayLike,
    sigma_rdot: npt.ArrayLike,
    rho: npt.ArrayLike,
) -> Floats:
    """Bias of the plain conversion to second order.

    Name: spherical_doppler.bias.second_order.
    Definition: L h.
    Conditioning: truth-conditioned: the measured symbols stand for the true values.
    Source: Prosov (7).

    Args:
        r: range [m], 1 to 1e+08.
        beta: azimuth, clockwise from the y axis [rad], -3.1416 to 3.1416.
        epsilon: elevation, up from the horizontal plane [rad], -1.5708 to 1.5708.
        rdot: range rate [m/s], -10000 to 10000.
        sigma_r: standard deviation of the error of r [m], 0.001 to 10000.
        sigma_beta: standard deviation of the error of beta [rad], 1e-09 to 1.
        sigma_epsilon: standard deviation of the error of epsilon [rad], 1e-09 to 1.
        sigma_rdot: standard deviation of the error of rdot [m/s], 0.0001 to 1000.
        rho: correlation of the errors of r and rdot [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (4), unit [m, m, m, m^2/s].

    Accuracy: at most 10.1 ulp anywhere in this domain with independent errors, proved for elementary
    functions within 1 ulp (float64); with correlations up to 0.99 in size at most 10.1; in float32, with
    functions within 4 of its ulp, at most 27.7.
    """
    arguments = _floats(r, beta, epsilon, rdot, sigma_r, sigma_beta, sigma_epsilon, sigma_rdot, rho)
    r, beta, epsilon, rdot, sigma_r, sigma_beta, sigma_epsilon, sigma_rdot, rho = arguments
    cos_beta = np.cos(beta)
    sin_beta = np.sin(beta)
    cos_epsilon = np.cos(epsilon)
    sin_epsilon = np.sin(epsilon)
    sigma_epsilon_squared = sigma_epsilon**2
    part_0_cos_epsilon_sin_beta = -0.5 * r * sigma_beta**2 - 0.5 * r * sigma_epsilon_squared
    result = _empty(arguments, (4,))
    result[..., 0] = cos_epsilon * part_0_cos_epsilon_sin_beta * sin_beta
    result[..., 1] = cos_beta * cos_epsilon * part_0_cos_epsilon_sin_beta
    result[..., 2] = -0.5 * r * sigma_epsilon_squared * sin_epsilon
    result[..., 3] = rho * sigma_r * sigma_rdot
    return result


def covariance_linear(
    *,
    r: npt.ArrayLike,
    beta: npt.ArrayLike,
    epsilon: npt.ArrayLike,
    rdot: npt.ArrayLike,
    sigma_r: npt.ArrayLike,
    sigma_beta: npt.ArrayLike,
    sigma_epsilon: npt.ArrayLike,
    sigma_rdot: npt.ArrayLike,
    rho: npt.ArrayLike,
) -> Floats:
    """Covariance of the linearised conversion.

    Name: spherical_doppler.covariance.linear.
    Definition: J K J'.
    Conditioning: truth-conditioned: the measured symbols stand for the true values.
    Source: Prosov (9); Gao et al. 2020 (1), doi:10.12126/see.2020.02.013.

    Args:
        r: range [m], 1 to 1e+08.
        beta: azimuth, clockwise from the y axis [rad], -3.1416 to 3.1416.
        epsilon: elevation, up from the horizontal plane [rad], -1.5708 to 1.5708.
        rdot: range rate [m/s], -10000 to 10000.
        sigma_r: standard deviation of the error of r [m], 0.001 to 10000.
        sigma_beta: standard deviation of the error of beta [rad], 1e-09 to 1.
        sigma_epsilon: standard deviation of the error of epsilon [rad], 1e-09 to 1.
        sigma_rdot: standard deviation of the error of rdot [m/s], 0.0001 to 1000.
        rho: correlation of the errors of r and rdot [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (4, 4), unit [m, m, m, m^2/s] × [m, m, m, m^2/s].

    Accuracy: at most 21.1 ulp anywhere in this domain with independent errors, proved for elementary
    functions within 1 ulp (float64); with correlations up to 0.99 in size at most 1100.
    """
    arguments = _floats(r, beta, epsilon, rdot, sigma_r, sigma_beta, sigma_epsilon, sigma_rdot, rho)
    r, beta, epsilon, rdot, sigma_r, sigma_beta, sigma_epsilon, sigma_rdot, rho = arguments
    cos_beta = np.cos(beta)
    sin_beta = np.sin(beta)
    cos_epsilon = np.cos(epsilon)
    sin_epsilon = np.sin(epsilon)
    r_squared = r**2
    sigma_beta_squared = sigma_beta**2
    part_00_cos_beta2_cos_epsilon2 = r_squared * sigma_beta_squared
    sigma_epsilon_squared = sigma_epsilon**2
    part_00_sin_beta2_sin_epsilon2 = r_squared * sigma_epsilon_squared
    sigma_r_squared = sigma_r**2
    part_01_cos_beta_cos_epsilon2_sin_beta = sigma_r_squared - r_squared * sigma_beta_squared
    part_02_cos_epsilon_sin_beta_sin_epsilon = sigma_r_squared - r_squared * sigma_epsilon_squared
    part_03_cos_epsilon_sin_beta = r * rho * sigma_r * sigma_rdot + rdot * sigma_r_squared
    cos_beta_squared = cos_beta**2
    cos_epsilon_squared = cos_epsilon**2
    sin_beta_squared = sin_beta**2
    sin_epsilon_squared = sin_epsilon**2
    result = _empty(arguments, (4, 4))
    result[..., 0, 0] = (
        cos_beta_squared * cos_epsilon_squared * part_00_cos_beta2_cos_epsilon2
        + cos_epsilon_squared * sigma_r_squared * sin_beta_squared
        + part_00_sin_beta2_sin_epsilon2 * sin_beta_squared * sin_epsilon_squared
    )
    result[..., 0, 1] = (
        cos_beta * cos_epsilon_squared * part_01_cos_beta_cos_epsilon2_sin_beta * sin_beta
        + cos_beta * part_00_sin_beta2_sin_epsilon2 * sin_beta * sin_epsilon_squared
    )
    result[..., 0, 2] = cos_epsilon * part_02_cos_epsilon_sin_beta_sin_epsilon * sin_beta * sin_epsilon
    result[..., 0, 3] = cos_epsilon * part_03_cos_epsilon_sin_beta * sin_beta
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = (
        cos_beta_squared * cos_epsilon_squared * sigma_r_squared
        + cos_beta_squared * part_00_sin_beta2_sin_epsilon2 * sin_epsilon_squared
        + cos_epsilon_squared * part_00_cos_beta2_cos_epsilon2 * sin_beta_squared
    )
    result[..., 1, 2] = cos_beta * cos_epsilon * part_02_cos_epsilon_sin_beta_sin_epsilon * sin_epsilon
    result[..., 1, 3] = cos_beta * cos_epsilon * part_03_cos_epsilon_sin_beta
    result[..., 2, 0] = result[..., 0, 2]
    result[..., 2, 1] = result[..., 1, 2]
    result[..., 2, 2] = (
        cos_epsilon_squared * part_00_sin_beta2_sin_epsilon2
        + sigma_r_squared * sin_epsilon_squared
    )
    result[..., 2, 3] = part_03_cos_epsilon_sin_beta * sin_epsilon
    result[..., 3, 0] = result[..., 0, 3]
    result[..., 3, 1] = result[..., 1, 3]
    result[..., 3, 2] = result[..., 2, 3]
    result[..., 3, 3] = (
        2.0 * r * rdot * rho * sigma_r * sigma_rdot
        + r_squared * sigma_rdot**2
        + rdot**2 * sigma_r_squared
    )
    return result


def covariance_second_order(
    *,
    r: npt.ArrayLike,
    beta: npt.ArrayLike,
    epsilon: npt.ArrayLike,
    rdot: npt.ArrayLike,
    sigma_r: npt.ArrayLike,
    sigma_beta: npt.ArrayLike,
    sigma_epsilon: npt.ArrayLike,
    sigma_rdot: npt.ArrayLike,
    rho: npt.ArrayLike,
) -> Floats:
    """Covariance of the conversion's quadratic Taylor polynomial.

    Name: spherical_doppler.covariance.second_order.
    Definition: J K J' + tr(G_a K G_b K)/2.
    Conditioning: truth-conditioned: the measured symbols stand for the true values.
    Source: Bar-Shalom & Li 1995.

    Args:
        r: range [m], 1 to 1e+08.
        beta: azimuth, clockwise from the y axis [rad], -3.1416 to 3.1416.
        epsilon: elevation, up from the horizontal plane [rad], -1.5708 to 1.5708.
        rdot: range rate [m/s], -10000 to 10000.
        sigma_r: standard deviation of the error of r [m], 0.001 to 10000.
        sigma_beta: standard deviation of the error of beta [rad], 1e-09 to 1.
        sigma_epsilon: standard deviation of the error of epsilon [rad], 1e-09 to 1.
        sigma_rdot: standard deviation of the error of rdot [m/s], 0.0001 to 1000.
        rho: correlation of the errors of r and rdot [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (4, 4), unit [m, m, m, m^2/s] × [m, m, m, m^2/s].

    Accuracy: at most 44.8 ulp anywhere in this domain with independent errors, proved for elementary
    functions within 1 ulp (float64); with correlations up to 0.99 in size at most 1100.
    """
    arguments = _floats(r, beta, epsilon, rdot, sigma_r, sigma_beta, sigma_epsilon, sigma_rdot, rho)
    r, beta, epsilon, rdot, sigma_r, sigma_beta, sigma_epsilon, sigma_rdot, rho = arguments
    cos_beta = np.cos(beta)
    sin_beta = np.sin(beta)
    cos_epsilon = np.cos(epsilon)
    sin_epsilon = np.sin(epsilon)
    r_squared = r**2
    sigma_beta_squared = sigma_beta**2
    sigma_r_squared = sigma_r**2
    part_00_cos_beta2_cos_epsilon2 = r_squared * sigma_beta_squared + sigma_beta_squared * sigma_r_squared
    sigma_epsilon_squared = sigma_epsilon**2
    part_00_cos_beta2_sin_epsilon2 = r_squared * sigma_beta_squared * sigma_epsilon_squared
    product_1 = 0.5 * r_squared * sigma_beta_squared**2
    product_2 = 0.5 * r_squared * sigma_epsilon_squared**2
    part_00_cos_epsilon2_sin_beta2 = product_1 + product_2 + sigma_r_squared
    product_3 = r_squared * sigma_epsilon_squared
    product_4 = sigma_epsilon_squared * sigma_r_squared
    part_00_sin_beta2_sin_epsilon2 = product_3 + product_4
    part_01_cos_beta_cos_epsilon2_sin_beta = (
        product_1
        - r_squared * sigma_beta_squared
        - sigma_beta_squared * sigma_r_squared
        + product_2
        + sigma_r_squared
    )
    part_01_cos_beta_sin_beta_sin_epsilon2 = (
        product_3
        - r_squared * sigma_beta_squared * sigma_epsilon_squared
        + product_4
    )
    part_02_cos_epsilon_sin_beta_sin_epsilon = (
        product_2
        - r_squared * sigma_epsilon_squared
        - sigma_epsilon_squared * sigma_r_squared
        + sigma_r_squared
    )
    part_03_cos_epsilon_sin_beta = r * rho * sigma_r * sigma_rdot + rdot * sigma_r_squared
    part_22_sin_epsilon2 = product_2 + sigma_r_squared
    cos_beta_squared = cos_beta**2
    cos_epsilon_squared = cos_epsilon**2
    sin_epsilon_squared = sin_epsilon**2
    sin_beta_squared = sin_beta**2
    sigma_rdot_squared = sigma_rdot**2
    result = _empty(arguments, (4, 4))
    result[..., 0, 0] = (
        cos_beta_squared * cos_epsilon_squared * part_00_cos_beta2_cos_epsilon2
        + cos_beta_squared * part_00_cos_beta2_sin_epsilon2 * sin_epsilon_squared
        + cos_epsilon_squared * part_00_cos_epsilon2_sin_beta2 * sin_beta_squared
        + part_00_sin_beta2_sin_epsilon2 * sin_beta_squared * sin_epsilon_squared
    )
    result[..., 0, 1] = (
        cos_beta * cos_epsilon_squared * part_01_cos_beta_cos_epsilon2_sin_beta * sin_beta
        + cos_beta * part_01_cos_beta_sin_beta_sin_epsilon2 * sin_beta * sin_epsilon_squared
    )
    result[..., 0, 2] = cos_epsilon * part_02_cos_epsilon_sin_beta_sin_epsilon * sin_beta * sin_epsilon
    result[..., 0, 3] = cos_epsilon * part_03_cos_epsilon_sin_beta * sin_beta
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = (
        cos_beta_squared * cos_epsilon_squared * part_00_cos_epsilon2_sin_beta2
        + cos_beta_squared * part_00_sin_beta2_sin_epsilon2 * sin_epsilon_squared
        + cos_epsilon_squared * part_00_cos_beta2_cos_epsilon2 * sin_beta_squared
        + part_00_cos_beta2_sin_epsilon2 * sin_beta_squared * sin_epsilon_squared
    )
    result[..., 1, 2] = cos_beta * cos_epsilon * part_02_cos_epsilon_sin_beta_sin_epsilon * sin_epsilon
    result[..., 1, 3] = cos_beta * cos_epsilon * part_03_cos_epsilon_sin_beta
    result[..., 2, 0] = result[..., 0, 2]
    result[..., 2, 1] = result[..., 1, 2]
    result[..., 2, 2] = (
        cos_epsilon_squared * part_00_sin_beta2_sin_epsilon2
        + part_22_sin_epsilon2 * sin_epsilon_squared
    )
    result[..., 2, 3] = part_03_cos_epsilon_sin_beta * sin_epsilon
    result[..., 3, 0] = result[..., 0, 3]
    result[..., 3, 1] = result[..., 1, 3]
    result[..., 3, 2] = result[..., 2, 3]
    result[..., 3, 3] = (
        2.0 * r * rdot * rho * sigma_r * sigma_rdot
        + r_squared * sigma_rdot_squared
        + rdot**2 * sigma_r_squared
        + sigma_r_squared * sigma_rdot_squared
        + rho**2 * sigma_r_squared * sigma_rdot_squared
    )
    return result


def std_linear(
    *,
    r: npt.ArrayLike,
    beta: npt.ArrayLike,
    epsilon: npt.ArrayLike,
    rdot: npt.ArrayLike,
    sigma_r: npt.ArrayLike,
    sigma_beta: npt.ArrayLike,
    sigma_epsilon: npt.ArrayLike,
    sigma_rdot: npt.ArrayLike,
    rho: npt.ArrayLike,
) -> Floats:
    """Standard deviation of each coordinate of the linearised conversion.

    Name: spherical_doppler.std.linear.
    Definition: sqrt((J K J')_aa).
    Conditioning: truth-conditioned: the measured symbols stand for the true values.
    Source: Gao et al. 2020 (1), doi:10.12126/see.2020.02.013.

    Args:
        r: range [m], 1 to 1e+08.
        beta: azimuth, clockwise from the y axis [rad], -3.1416 to 3.1416.
        epsilon: elevation, up from the horizontal plane [rad], -1.5708 to 1.5708.
        rdot: range rate [m/s], -10000 to 10000.
        sigma_r: standard deviation of the error of r [m], 0.001 to 10000.
        sigma_beta: standard deviation of the error of beta [rad], 1e-09 to 1.
        sigma_epsilon: standard deviation of the error of epsilon [rad], 1e-09 to 1.
        sigma_rdot: standard deviation of the error of rdot [m/s], 0.0001 to 1000.
        rho: correlation of the errors of r and rdot [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (4), unit [m, m, m, m^2/s].

    Accuracy: at most 11.6 ulp anywhere in this domain with independent errors, proved for elementary
    functions within 1 ulp (float64); with correlations up to 0.99 in size at most 550.
    """
    arguments = _floats(r, beta, epsilon, rdot, sigma_r, sigma_beta, sigma_epsilon, sigma_rdot, rho)
    r, beta, epsilon, rdot, sigma_r, sigma_beta, sigma_epsilon, sigma_rdot, rho = arguments
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
    sin_beta_squared = sin_beta**2
    sin_epsilon_squared = sin_epsilon**2
    result = _empty(arguments, (4,))
    result[..., 0] = np.sqrt(cos_beta_squared * cos_epsilon_squared * part_0_cos_beta2_cos_epsilon2 + cos_epsilon_squared * sigma_r_squared * sin_beta_squared + part_0_sin_beta2_sin_epsilon2 * sin_beta_squared * sin_epsilon_squared)
    result[..., 1] = np.sqrt(cos_beta_squared * cos_epsilon_squared * sigma_r_squared + cos_beta_squared * part_0_sin_beta2_sin_epsilon2 * sin_epsilon_squared + cos_epsilon_squared * part_0_cos_beta2_cos_epsilon2 * sin_beta_squared)
    result[..., 2] = np.sqrt(cos_epsilon_squared * part_0_sin_beta2_sin_epsilon2 + sigma_r_squared * sin_epsilon_squared)
    result[..., 3] = np.sqrt(2.0 * r * rdot * rho * sigma_r * sigma_rdot + r_squared * sigma_rdot**2 + rdot**2 * sigma_r_squared)
    return result


def validity_linear(
    *,
    r: npt.ArrayLike,
    beta: npt.ArrayLike,
    epsilon: npt.ArrayLike,
    rdot: npt.ArrayLike,
    sigma_r: npt.ArrayLike,
    sigma_beta: npt.ArrayLike,
    sigma_epsilon: npt.ArrayLike,
    sigma_rdot: npt.ArrayLike,
    rho: npt.ArrayLike,
) -> Floats:
    """Leading term that the linear formulas neglect, root mean square, over the linear standard deviation, one a measured quantity.

    Name: spherical_doppler.validity.linear.
    Definition: sqrt(E[(J^-1 (w.d)^2 h)_i^2])/(2 sigma_i).
    Conditioning: truth-conditioned: the measured symbols stand for the true values.
    Source: Prosov the question of validity.

    Args:
        r: range [m], 1 to 1e+08.
        beta: azimuth, clockwise from the y axis [rad], -3.1416 to 3.1416.
        epsilon: elevation, up from the horizontal plane [rad], -1.5708 to 1.5708.
        rdot: range rate [m/s], -10000 to 10000.
        sigma_r: standard deviation of the error of r [m], 0.001 to 10000.
        sigma_beta: standard deviation of the error of beta [rad], 1e-09 to 1.
        sigma_epsilon: standard deviation of the error of epsilon [rad], 1e-09 to 1.
        sigma_rdot: standard deviation of the error of rdot [m/s], 0.0001 to 1000.
        rho: correlation of the errors of r and rdot [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (4), unit 1.

    Accuracy: at most 18.6 ulp anywhere in this domain with independent errors, proved for elementary
    functions within 1 ulp (float64); with correlations up to 0.99 in size at most 23.3.
    """
    arguments = _floats(r, beta, epsilon, rdot, sigma_r, sigma_beta, sigma_epsilon, sigma_rdot, rho)
    r, beta, epsilon, rdot, sigma_r, sigma_beta, sigma_epsilon, sigma_rdot, rho = arguments
    cos_epsilon = np.cos(epsilon)
    sin_epsilon = np.sin(epsilon)
    part_7_cos_epsilon2 = 0.5 * r * rdot
    complement_of_rho = np.sqrt((1.0 - rho) * (1.0 + rho))
    cos_epsilon_squared = cos_epsilon**2
    sigma_beta_squared = sigma_beta**2
    sigma_epsilon_squared = sigma_epsilon**2
    cos_epsilon_squared_squared = cos_epsilon_squared**2
    r_squared = r**2
    sigma_beta_squared_squared = sigma_beta_squared**2
    sigma_epsilon_squared_squared = sigma_epsilon_squared**2
    cos_epsilon_ = cos_epsilon
    term_1 = 1.0 / r
    sigma_r_squared = sigma_r**2
    sin_epsilon_squared = sin_epsilon**2
    part_7_cos_epsilon2_squared = part_7_cos_epsilon2**2
    sigma_rdot_squared = sigma_rdot**2
    result = _empty(arguments, (4,))
    result[..., 0] = np.sqrt((-0.5 * cos_epsilon_squared * r * sigma_beta_squared - 0.5 * r * sigma_epsilon_squared)**2 + 0.5 * cos_epsilon_squared_squared * r_squared * sigma_beta_squared_squared + 0.5 * r_squared * sigma_epsilon_squared_squared) / sigma_r
    result[..., 1] = np.sqrt(cos_epsilon_squared * sigma_beta_squared * sigma_r_squared + r_squared * sigma_beta_squared * sigma_epsilon_squared * sin_epsilon_squared) * term_1 / (cos_epsilon_ * sigma_beta)
    result[..., 2] = np.sqrt(0.75 * cos_epsilon_squared * r_squared * sigma_beta_squared_squared * sin_epsilon_squared + sigma_epsilon_squared * sigma_r_squared) * term_1 / sigma_epsilon
    result[..., 3] = np.sqrt((cos_epsilon_squared * part_7_cos_epsilon2 * sigma_beta_squared + part_7_cos_epsilon2 * sigma_epsilon_squared + rho * sigma_r * sigma_rdot)**2 + 2.0 * cos_epsilon_squared_squared * part_7_cos_epsilon2_squared * sigma_beta_squared_squared + 2.0 * part_7_cos_epsilon2_squared * sigma_epsilon_squared_squared + 2.0 * rho**2 * sigma_r_squared * sigma_rdot_squared + complement_of_rho**2 * sigma_r_squared * sigma_rdot_squared) * term_1 / sigma_rdot
    return result


def validity_second_order(
    *,
    r: npt.ArrayLike,
    beta: npt.ArrayLike,
    epsilon: npt.ArrayLike,
    rdot: npt.ArrayLike,
    sigma_r: npt.ArrayLike,
    sigma_beta: npt.ArrayLike,
    sigma_epsilon: npt.ArrayLike,
    sigma_rdot: npt.ArrayLike,
    rho: npt.ArrayLike,
) -> Floats:
    """Leading term that the second-order formulas neglect, root mean square, over the linear standard deviation, one a measured quantity.

    Name: spherical_doppler.validity.second_order.
    Definition: sqrt(E[(J^-1 (w.d)^3 h)_i^2])/(6 sigma_i).
    Conditioning: truth-conditioned: the measured symbols stand for the true values.
    Source: Prosov the question of validity.

    Args:
        r: range [m], 1 to 1e+08.
        beta: azimuth, clockwise from the y axis [rad], -3.1416 to 3.1416.
        epsilon: elevation, up from the horizontal plane [rad], -1.5708 to 1.5708.
        rdot: range rate [m/s], -10000 to 10000.
        sigma_r: standard deviation of the error of r [m], 0.001 to 10000.
        sigma_beta: standard deviation of the error of beta [rad], 1e-09 to 1.
        sigma_epsilon: standard deviation of the error of epsilon [rad], 1e-09 to 1.
        sigma_rdot: standard deviation of the error of rdot [m/s], 0.0001 to 1000.
        rho: correlation of the errors of r and rdot [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (4), unit 1.

    Accuracy: at most 20.6 ulp anywhere in this domain with independent errors, proved for elementary
    functions within 1 ulp (float64); with correlations up to 0.99 in size at most 20.6.
    """
    arguments = _floats(r, beta, epsilon, rdot, sigma_r, sigma_beta, sigma_epsilon, sigma_rdot, rho)
    r, beta, epsilon, rdot, sigma_r, sigma_beta, sigma_epsilon, sigma_rdot, rho = arguments
    cos_epsilon = np.cos(epsilon)
    sin_epsilon = np.sin(epsilon)
    cos_epsilon_squared = cos_epsilon**2
    r_squared = r**2
    sigma_beta_squared = sigma_beta**2
    sigma_beta_squared_squared = sigma_beta_squared**2
    sigma_epsilon_squared = sigma_epsilon**2
    sin_epsilon_squared = sin_epsilon**2
    cos_epsilon_squared_squared = cos_epsilon_squared**2
    sigma_r_squared = sigma_r**2
    sigma_epsilon_squared_squared = sigma_epsilon_squared**2
    cos_epsilon_ = cos_epsilon
    term_1 = 1.0 / r
    rdot_squared = rdot**2
    result = _empty(arguments, (4,))
    result[..., 0] = np.sqrt(0.75 * cos_epsilon_squared * r_squared * sigma_beta_squared_squared * sigma_epsilon_squared * sin_epsilon_squared + 0.5 * cos_epsilon_squared_squared * sigma_beta_squared_squared * sigma_r_squared + 0.5 * sigma_epsilon_squared_squared * sigma_r_squared + (-0.5 * cos_epsilon_squared * sigma_beta_squared - 0.5 * sigma_epsilon_squared)**2 * sigma_r_squared) / sigma_r
    result[..., 1] = np.sqrt(cos_epsilon_squared * r_squared * sigma_beta_squared * sigma_beta_squared**2 / 6.0 + 0.5 * cos_epsilon_squared * r_squared * sigma_beta_squared * sigma_epsilon_squared_squared + (-0.5 * cos_epsilon * r * sigma_beta_squared - 0.5 * cos_epsilon * r * sigma_epsilon_squared)**2 * sigma_beta_squared + sigma_beta_squared * sigma_epsilon_squared * sigma_r_squared * sin_epsilon_squared) * term_1 / (cos_epsilon_ * sigma_beta)
    result[..., 2] = np.sqrt(0.75 * cos_epsilon_squared * sigma_beta_squared_squared * sigma_r_squared * sin_epsilon_squared + 0.5 * r_squared * sigma_beta_squared_squared * sigma_epsilon_squared * sin_epsilon_squared**2 + r_squared * sigma_epsilon_squared * sigma_epsilon_squared**2 / 6.0 + (-0.5 * r * sigma_beta_squared * sin_epsilon_squared - 0.5 * r * sigma_epsilon_squared)**2 * sigma_epsilon_squared) * term_1 / sigma_epsilon
    result[..., 3] = np.sqrt(0.75 * cos_epsilon_squared * r_squared * rdot_squared * sigma_beta_squared_squared * sigma_epsilon_squared * sin_epsilon_squared + 0.5 * cos_epsilon_squared_squared * rdot_squared * sigma_beta_squared_squared * sigma_r_squared + 0.5 * rdot_squared * sigma_epsilon_squared_squared * sigma_r_squared + (0.5 * cos_epsilon_squared * rdot * sigma_beta_squared + 0.5 * rdot * sigma_epsilon_squared)**2 * sigma_r_squared) * term_1 / sigma_rdot
    return result


def covariance_third_order(
    *,
    r: npt.ArrayLike,
    beta: npt.ArrayLike,
    epsilon: npt.ArrayLike,
    rdot: npt.ArrayLike,
    sigma_r: npt.ArrayLike,
    sigma_beta: npt.ArrayLike,
    sigma_epsilon: npt.ArrayLike,
    sigma_rdot: npt.ArrayLike,
    rho: npt.ArrayLike,
) -> Floats:
    """Covariance of the conversion's cubic Taylor polynomial.

    Name: spherical_doppler.covariance.third_order.
    Definition: E[p p'] - E[p] E[p]', p = h + (w.d) h + (w.d)^2 h/2 + (w.d)^3 h/6.
    Conditioning: truth-conditioned: the measured symbols stand for the true values.
    Source: Bar-Shalom & Li 1995.

    Args:
        r: range [m], 1 to 1e+08.
        beta: azimuth, clockwise from the y axis [rad], -3.1416 to 3.1416.
        epsilon: elevation, up from the horizontal plane [rad], -1.5708 to 1.5708.
        rdot: range rate [m/s], -10000 to 10000.
        sigma_r: standard deviation of the error of r [m], 0.001 to 10000.
        sigma_beta: standard deviation of the error of beta [rad], 1e-09 to 1.
        sigma_epsilon: standard deviation of the error of epsilon [rad], 1e-09 to 1.
        sigma_rdot: standard deviation of the error of rdot [m/s], 0.0001 to 1000.
        rho: correlation of the errors of r and rdot [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (4, 4), unit [m, m, m, m^2/s] × [m, m, m, m^2/s].

    Accuracy: at most 662 ulp anywhere in this domain with independent errors, proved for elementary functions
    within 1 ulp (float64).
    """
    arguments = _floats(r, beta, epsilon, rdot, sigma_r, sigma_beta, sigma_epsilon, sigma_rdot, rho)
    r, beta, epsilon, rdot, sigma_r, sigma_beta, sigma_epsilon, sigma_rdot, rho = arguments
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
    sigma_r_squared = sigma_r**2
    part_00_cos_beta2_cos_epsilon2 = (
        0.75 * r_squared * sigma_beta_squared * sigma_epsilon_squared_squared
        - r_squared * sigma_beta_squared_squared
        + 5.0 * r_squared * sigma_beta_squared_cubed / 12.0
        + product_1
        + r_squared * sigma_beta_squared
        + 0.5 * r_squared * sigma_beta_squared_squared * sigma_epsilon_squared
        + sigma_beta_squared * sigma_r_squared
    )
    product_2 = r_squared * sigma_beta_squared * sigma_epsilon_squared
    part_00_cos_beta2_sin_epsilon2 = product_2 + sigma_beta_squared * sigma_epsilon_squared * sigma_r_squared
    product_3 = -sigma_epsilon_squared * sigma_r_squared
    product_4 = 0.75 * sigma_beta_squared_squared * sigma_r_squared
    product_5 = 0.75 * sigma_epsilon_squared_squared * sigma_r_squared
    product_6 = 0.5 * r_squared * sigma_epsilon_squared_squared
    product_7 = 0.5 * sigma_beta_squared * sigma_epsilon_squared * sigma_r_squared
    part_00_cos_epsilon2_sin_beta2 = (
        product_3
        - sigma_beta_squared * sigma_r_squared
        + product_4
        + product_5
        + product_6
        + product_7
        + 0.5 * r_squared * sigma_beta_squared_squared
        + sigma_r_squared
    )
    product_8 = -r_squared * sigma_epsilon_squared_squared
    product_9 = 0.75 * r_squared * sigma_beta_squared_squared * sigma_epsilon_squared
    sigma_epsilon_squared_cubed = sigma_epsilon_squared * sigma_epsilon_squared**2
    product_10 = 5.0 * r_squared * sigma_epsilon_squared_cubed / 12.0
    product_11 = 0.5 * r_squared * sigma_beta_squared * sigma_epsilon_squared_squared
    product_12 = r_squared * sigma_epsilon_squared
    product_13 = sigma_epsilon_squared * sigma_r_squared
    part_00_sin_beta2_sin_epsilon2 = (
        product_1
        + product_10
        + product_11
        + product_12
        + product_13
        + product_8
        + product_9
    )
    part_01_cos_beta_cos_epsilon2_sin_beta = (
        1.5 * r_squared * sigma_beta_squared_squared
        - 2.0 * sigma_beta_squared * sigma_r_squared
        - 0.75 * r_squared * sigma_beta_squared * sigma_epsilon_squared_squared
        - 5.0 * r_squared * sigma_beta_squared_cubed / 12.0
        - r_squared * sigma_beta_squared
        - 0.5 * r_squared * sigma_beta_squared_squared * sigma_epsilon_squared
        + product_2
        + product_3
        + product_4
        + product_5
        + product_6
        + product_7
        + sigma_r_squared
    )
    part_01_cos_beta_sin_beta_sin_epsilon2 = (
        product_10
        - 2.0 * r_squared * sigma_beta_squared * sigma_epsilon_squared
        - sigma_beta_squared * sigma_epsilon_squared * sigma_r_squared
        + product_11
        + product_12
        + product_13
        + product_8
        + product_9
    )
    part_02_cos_epsilon_sin_beta_sin_epsilon = (
        1.5 * r_squared * sigma_epsilon_squared_squared
        - 2.0 * sigma_epsilon_squared * sigma_r_squared
        - 5.0 * r_squared * sigma_epsilon_squared_cubed / 12.0
        - 0.25 * r_squared * sigma_beta_squared * sigma_epsilon_squared_squared
        - r_squared * sigma_epsilon_squared
        - 0.5 * sigma_beta_squared * sigma_r_squared
        + product_5
        + 0.5 * r_squared * sigma_beta_squared * sigma_epsilon_squared
        + 0.25 * sigma_beta_squared * sigma_epsilon_squared * sigma_r_squared
        + sigma_r_squared
    )
    product_14 = -0.5 * r * rho * sigma_epsilon_squared * sigma_r * sigma_rdot
    product_15 = -0.5 * rdot * sigma_epsilon_squared * sigma_r_squared
    product_16 = r * rho * sigma_r * sigma_rdot
    product_17 = rdot * sigma_r_squared
    part_03_cos_epsilon_sin_beta = (
        product_14
        - 0.5 * r * rho * sigma_beta_squared * sigma_r * sigma_rdot
        - 0.5 * rdot * sigma_beta_squared * sigma_r_squared
        + product_15
        + product_16
        + product_17
    )
    part_22_cos_epsilon2 = product_10 + product_12 + product_13 + product_8
    part_22_sin_epsilon2 = product_3 + product_5 + product_6 + sigma_r_squared
    part_23_sin_epsilon = product_14 + product_15 + product_16 + product_17
    cos_beta_squared = cos_beta**2
    cos_epsilon_squared = cos_epsilon**2
    sin_epsilon_squared = sin_epsilon**2
    sin_beta_squared = sin_beta**2
    sigma_rdot_squared = sigma_rdot**2
    result = _empty(arguments, (4, 4))
    result[..., 0, 0] = (
        cos_beta_squared * cos_epsilon_squared * part_00_cos_beta2_cos_epsilon2
        + cos_beta_squared * part_00_cos_beta2_sin_epsilon2 * sin_epsilon_squared
        + cos_epsilon_squared * part_00_cos_epsilon2_sin_beta2 * sin_beta_squared
        + part_00_sin_beta2_sin_epsilon2 * sin_beta_squared * sin_epsilon_squared
    )
    result[..., 0, 1] = (
        cos_beta * cos_epsilon_squared * part_01_cos_beta_cos_epsilon2_sin_beta * sin_beta
        + cos_beta * part_01_cos_beta_sin_beta_sin_epsilon2 * sin_beta * sin_epsilon_squared
    )
    result[..., 0, 2] = cos_epsilon * part_02_cos_epsilon_sin_beta_sin_epsilon * sin_beta * sin_epsilon
    result[..., 0, 3] = cos_epsilon * part_03_cos_epsilon_sin_beta * sin_beta
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = (
        cos_beta_squared * cos_epsilon_squared * part_00_cos_epsilon2_sin_beta2
        + cos_beta_squared * part_00_sin_beta2_sin_epsilon2 * sin_epsilon_squared
        + cos_epsilon_squared * part_00_cos_beta2_cos_epsilon2 * sin_beta_squared
        + part_00_cos_beta2_sin_epsilon2 * sin_beta_squared * sin_epsilon_squared
    )
    result[..., 1, 2] = cos_beta * cos_epsilon * part_02_cos_epsilon_sin_beta_sin_epsilon * sin_epsilon
    result[..., 1, 3] = cos_beta * cos_epsilon * part_03_cos_epsilon_sin_beta
    result[..., 2, 0] = result[..., 0, 2]
    result[..., 2, 1] = result[..., 1, 2]
    result[..., 2, 2] = (
        cos_epsilon_squared * part_22_cos_epsilon2
        + part_22_sin_epsilon2 * sin_epsilon_squared
    )
    result[..., 2, 3] = part_23_sin_epsilon * sin_epsilon
    result[..., 3, 0] = result[..., 0, 3]
    result[..., 3, 1] = result[..., 1, 3]
    result[..., 3, 2] = result[..., 2, 3]
    result[..., 3, 3] = (
        2.0 * r * rdot * rho * sigma_r * sigma_rdot
        + r_squared * sigma_rdot_squared
        + rdot**2 * sigma_r_squared
        + sigma_r_squared * sigma_rdot_squared
        + rho**2 * sigma_r_squared * sigma_rdot_squared
    )
    return result


def bias_truth(
    *,
    r: npt.ArrayLike,
    beta: npt.ArrayLike,
    epsilon: npt.ArrayLike,
    rdot: npt.ArrayLike,
    sigma_r: npt.ArrayLike,
    sigma_beta: npt.ArrayLike,
    sigma_epsilon: npt.ArrayLike,
    sigma_rdot: npt.ArrayLike,
    rho: npt.ArrayLike,
) -> Floats:
    """Exact bias of the plain conversion h(z).

    Name: spherical_doppler.bias.truth.
    Definition: (e^L - 1) h.
    Conditioning: truth-conditioned: the measured symbols stand for the true values.
    Source: Lerro & Bar-Shalom 1993, doi:10.1109/7.220948.

    Args:
        r: range [m], 1 to 1e+08.
        beta: azimuth, clockwise from the y axis [rad], -3.1416 to 3.1416.
        epsilon: elevation, up from the horizontal plane [rad], -1.5708 to 1.5708.
        rdot: range rate [m/s], -10000 to 10000.
        sigma_r: standard deviation of the error of r [m], 0.001 to 10000.
        sigma_beta: standard deviation of the error of beta [rad], 1e-09 to 1.
        sigma_epsilon: standard deviation of the error of epsilon [rad], 1e-09 to 1.
        sigma_rdot: standard deviation of the error of rdot [m/s], 0.0001 to 1000.
        rho: correlation of the errors of r and rdot [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (4), unit [m, m, m, m^2/s].

    Accuracy: at most 15.6 ulp anywhere in this domain with independent errors, proved for elementary
    functions within 1 ulp (float64); with correlations up to 0.99 in size at most 15.6; in float32, with
    functions within 4 of its ulp, at most 45.4.
    """
    arguments = _floats(r, beta, epsilon, rdot, sigma_r, sigma_beta, sigma_epsilon, sigma_rdot, rho)
    r, beta, epsilon, rdot, sigma_r, sigma_beta, sigma_epsilon, sigma_rdot, rho = arguments
    cos_beta = np.cos(beta)
    sin_beta = np.sin(beta)
    cos_epsilon = np.cos(epsilon)
    sin_epsilon = np.sin(epsilon)
    shortfall_beta = -np.expm1(-0.5 * sigma_beta**2)
    shortfall_epsilon = -np.expm1(-0.5 * sigma_epsilon**2)
    sum_1 = shortfall_beta * shortfall_epsilon - shortfall_beta - shortfall_epsilon
    part_0_cos_epsilon_sin_beta = r * sum_1
    result = _empty(arguments, (4,))
    result[..., 0] = cos_epsilon * part_0_cos_epsilon_sin_beta * sin_beta
    result[..., 1] = cos_beta * cos_epsilon * part_0_cos_epsilon_sin_beta
    result[..., 2] = -r * shortfall_epsilon * sin_epsilon
    result[..., 3] = rho * sigma_r * sigma_rdot
    return result


def bias_averaged(
    *,
    r: npt.ArrayLike,
    beta: npt.ArrayLike,
    epsilon: npt.ArrayLike,
    rdot: npt.ArrayLike,
    sigma_r: npt.ArrayLike,
    sigma_beta: npt.ArrayLike,
    sigma_epsilon: npt.ArrayLike,
    sigma_rdot: npt.ArrayLike,
    rho: npt.ArrayLike,
) -> Floats:
    """Exact bias of the plain conversion, averaged over the truth.

    Name: spherical_doppler.bias.averaged.
    Definition: (e^2L - e^L) h.
    Conditioning: measurement-conditioned: the measured symbols stand for the measurement.
    Source: Lerro & Bar-Shalom 1993, doi:10.1109/7.220948.

    Args:
        r: range [m], 1 to 1e+08.
        beta: azimuth, clockwise from the y axis [rad], -3.1416 to 3.1416.
        epsilon: elevation, up from the horizontal plane [rad], -1.5708 to 1.5708.
        rdot: range rate [m/s], -10000 to 10000.
        sigma_r: standard deviation of the error of r [m], 0.001 to 10000.
        sigma_beta: standard deviation of the error of beta [rad], 1e-09 to 1.
        sigma_epsilon: standard deviation of the error of epsilon [rad], 1e-09 to 1.
        sigma_rdot: standard deviation of the error of rdot [m/s], 0.0001 to 1000.
        rho: correlation of the errors of r and rdot [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (4), unit [m, m, m, m^2/s].

    Accuracy: at most 23.6 ulp anywhere in this domain with independent errors, proved for elementary
    functions within 1 ulp (float64); with correlations up to 0.99 in size at most 23.6; in float32, with
    functions within 4 of its ulp, at most 77.5.
    """
    arguments = _floats(r, beta, epsilon, rdot, sigma_r, sigma_beta, sigma_epsilon, sigma_rdot, rho)
    r, beta, epsilon, rdot, sigma_r, sigma_beta, sigma_epsilon, sigma_rdot, rho = arguments
    cos_beta = np.cos(beta)
    sin_beta = np.sin(beta)
    cos_epsilon = np.cos(epsilon)
    sin_epsilon = np.sin(epsilon)
    attenuation_beta = np.exp(-0.5 * sigma_beta**2)
    shortfall_beta = -np.expm1(-0.5 * sigma_beta**2)
    attenuation_epsilon = np.exp(-0.5 * sigma_epsilon**2)
    shortfall_epsilon = -np.expm1(-0.5 * sigma_epsilon**2)
    sum_1 = shortfall_beta * shortfall_epsilon - shortfall_beta - shortfall_epsilon
    part_0_cos_epsilon_sin_beta = attenuation_beta * attenuation_epsilon * r * sum_1
    result = _empty(arguments, (4,))
    result[..., 0] = cos_epsilon * part_0_cos_epsilon_sin_beta * sin_beta
    result[..., 1] = cos_beta * cos_epsilon * part_0_cos_epsilon_sin_beta
    result[..., 2] = -attenuation_epsilon * r * shortfall_epsilon * sin_epsilon
    result[..., 3] = rho * sigma_r * sigma_rdot
    return result


def covariance_truth(
    *,
    r: npt.ArrayLike,
    beta: npt.ArrayLike,
    epsilon: npt.ArrayLike,
    rdot: npt.ArrayLike,
    sigma_r: npt.ArrayLike,
    sigma_beta: npt.ArrayLike,
    sigma_epsilon: npt.ArrayLike,
    sigma_rdot: npt.ArrayLike,
    rho: npt.ArrayLike,
) -> Floats:
    """Exact covariance of the plain conversion h(z).

    Name: spherical_doppler.covariance.truth.
    Definition: C = e^L(h h') - (e^L h)(e^L h)'.
    Conditioning: truth-conditioned: the measured symbols stand for the true values.
    Source: Lerro & Bar-Shalom 1993, doi:10.1109/7.220948.

    Args:
        r: range [m], 1 to 1e+08.
        beta: azimuth, clockwise from the y axis [rad], -3.1416 to 3.1416.
        epsilon: elevation, up from the horizontal plane [rad], -1.5708 to 1.5708.
        rdot: range rate [m/s], -10000 to 10000.
        sigma_r: standard deviation of the error of r [m], 0.001 to 10000.
        sigma_beta: standard deviation of the error of beta [rad], 1e-09 to 1.
        sigma_epsilon: standard deviation of the error of epsilon [rad], 1e-09 to 1.
        sigma_rdot: standard deviation of the error of rdot [m/s], 0.0001 to 1000.
        rho: correlation of the errors of r and rdot [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (4, 4), unit [m, m, m, m^2/s] × [m, m, m, m^2/s].

    Accuracy: at most 171 ulp anywhere in this domain with independent errors, proved for elementary functions
    within 1 ulp (float64).
    """
    arguments = _floats(r, beta, epsilon, rdot, sigma_r, sigma_beta, sigma_epsilon, sigma_rdot, rho)
    r, beta, epsilon, rdot, sigma_r, sigma_beta, sigma_epsilon, sigma_rdot, rho = arguments
    cos_beta = np.cos(beta)
    sin_beta = np.sin(beta)
    cos_epsilon = np.cos(epsilon)
    sin_epsilon = np.sin(epsilon)
    attenuation_beta = np.exp(-0.5 * sigma_beta**2)
    shortfall_beta = -np.expm1(-0.5 * sigma_beta**2)
    attenuation_epsilon = np.exp(-0.5 * sigma_epsilon**2)
    shortfall_epsilon = -np.expm1(-0.5 * sigma_epsilon**2)
    attenuation_beta_squared = attenuation_beta**2
    attenuation_epsilon_squared = attenuation_epsilon**2
    attenuation_epsilon_squared_squared = attenuation_epsilon_squared**2
    product_1 = attenuation_beta * attenuation_beta_squared
    sum_1 = (
        1.0
        + attenuation_beta
        + attenuation_beta * attenuation_epsilon_squared_squared
        + attenuation_beta_squared
        + attenuation_beta_squared * attenuation_epsilon_squared_squared
        + attenuation_epsilon_squared_squared
        + attenuation_epsilon_squared_squared * product_1
        + product_1
    )
    r_squared = r**2
    sigma_r_squared = sigma_r**2
    part_00_cos_beta2_cos_epsilon2 = (
        0.25 * r_squared * shortfall_beta * sum_1
        + 0.25 * shortfall_beta * sigma_r_squared * sum_1
    )
    product_2 = attenuation_epsilon * attenuation_epsilon_squared
    sum_2 = (
        1.0
        + attenuation_beta
        + attenuation_beta * attenuation_epsilon
        + attenuation_beta * attenuation_epsilon_squared
        + attenuation_beta * product_2
        + attenuation_beta_squared
        + attenuation_beta_squared * attenuation_epsilon
        + attenuation_beta_squared * attenuation_epsilon_squared
        + attenuation_beta_squared * product_2
        + attenuation_epsilon
        + attenuation_epsilon * product_1
        + attenuation_epsilon_squared
        + attenuation_epsilon_squared * product_1
        + product_1
        + product_1 * product_2
        + product_2
    )
    part_00_cos_beta2_sin_epsilon2 = (
        0.25 * r_squared * shortfall_beta * shortfall_epsilon * sum_2
        + 0.25 * shortfall_beta * shortfall_epsilon * sigma_r_squared * sum_2
    )
    shortfall_beta_squared = shortfall_beta**2
    attenuation_beta_squared_squared = attenuation_beta_squared**2
    shortfall_epsilon_squared = shortfall_epsilon**2
    product_3 = shortfall_epsilon * shortfall_epsilon_squared
    product_4 = shortfall_beta * shortfall_beta_squared
    shortfall_epsilon_squared_squared = shortfall_epsilon_squared**2
    shortfall_beta_squared_squared = shortfall_beta_squared**2
    sum_3 = (
        2.0 * attenuation_beta * attenuation_epsilon_squared_squared * product_4
        + 2.0 * attenuation_beta_squared * attenuation_epsilon_squared_squared * shortfall_beta_squared
        + 2.0 * attenuation_beta_squared_squared * attenuation_epsilon * product_3
        + 2.0 * attenuation_beta_squared_squared * attenuation_epsilon_squared * shortfall_epsilon_squared
        + 1.5 * attenuation_beta_squared * shortfall_beta_squared * shortfall_epsilon_squared_squared
        + 1.5 * attenuation_epsilon_squared * shortfall_beta_squared_squared * shortfall_epsilon_squared
        + 4.0 * attenuation_beta * attenuation_epsilon * product_3 * product_4
        + 4.0 * attenuation_beta * product_2 * product_4 * shortfall_epsilon
        + 4.0 * attenuation_beta_squared * product_2 * shortfall_beta_squared * shortfall_epsilon
        + 4.0 * attenuation_epsilon * product_1 * product_3 * shortfall_beta
        + 4.0 * attenuation_epsilon_squared * product_1 * shortfall_beta * shortfall_epsilon_squared
        + 6.0 * attenuation_beta * attenuation_epsilon_squared * product_4 * shortfall_epsilon_squared
        + 6.0 * attenuation_beta_squared * attenuation_epsilon * product_3 * shortfall_beta_squared
        + 8.0 * attenuation_beta_squared * attenuation_epsilon_squared * shortfall_beta_squared * shortfall_epsilon_squared
        + attenuation_beta * product_4 * shortfall_epsilon_squared_squared
        + 0.5 * attenuation_beta_squared_squared * shortfall_epsilon_squared_squared
        + attenuation_epsilon * product_3 * shortfall_beta_squared_squared
        + 0.5 * attenuation_epsilon_squared_squared * shortfall_beta_squared_squared
        + product_1 * shortfall_beta * shortfall_epsilon_squared_squared
        + product_2 * shortfall_beta_squared_squared * shortfall_epsilon
        + 0.25 * shortfall_beta_squared_squared * shortfall_epsilon_squared_squared
    )
    sum_4 = (
        0.25
        + 0.25 * attenuation_beta_squared_squared * attenuation_epsilon_squared_squared
        + 0.25 * attenuation_beta_squared_squared
        + 0.25 * attenuation_epsilon_squared_squared
    )
    part_00_cos_epsilon2_sin_beta2 = r_squared * sum_3 + sigma_r_squared * sum_4
    sum_5 = (
        1.0
        + attenuation_beta_squared_squared
        + attenuation_beta_squared_squared * attenuation_epsilon
        + attenuation_beta_squared_squared * attenuation_epsilon_squared
        + attenuation_beta_squared_squared * product_2
        + attenuation_epsilon
        + attenuation_epsilon_squared
        + product_2
    )
    part_00_sin_beta2_sin_epsilon2 = (
        0.25 * r_squared * shortfall_epsilon * sum_5
        + 0.25 * shortfall_epsilon * sigma_r_squared * sum_5
    )
    sum_6 = (
        4.0 * attenuation_beta_squared * attenuation_epsilon * product_3
        - 2.0 * attenuation_epsilon_squared * shortfall_beta_squared * shortfall_epsilon_squared
        - 2.0 * attenuation_epsilon_squared_squared * shortfall_beta_squared
        - 4.0 * attenuation_beta * attenuation_epsilon_squared * shortfall_beta * shortfall_epsilon_squared
        - 4.0 * attenuation_beta * attenuation_epsilon_squared_squared * shortfall_beta
        - 4.0 * product_2 * shortfall_beta_squared * shortfall_epsilon
        - 8.0 * attenuation_beta * product_2 * shortfall_beta * shortfall_epsilon
        + 4.0 * attenuation_beta_squared * attenuation_epsilon_squared * shortfall_epsilon_squared
        + attenuation_beta_squared * shortfall_epsilon_squared_squared
    )
    sum_7 = 1.0 + attenuation_epsilon_squared_squared
    part_01_cos_beta_cos_epsilon2_sin_beta = (
        0.5 * attenuation_beta_squared * r_squared * sum_6
        + 0.5 * attenuation_beta_squared_squared * sigma_r_squared * sum_7
    )
    sum_8 = 1.0 + attenuation_epsilon + attenuation_epsilon_squared + product_2
    part_01_cos_beta_sin_beta_sin_epsilon2 = (
        0.5 * attenuation_beta_squared_squared * r_squared * shortfall_epsilon * sum_8
        + 0.5 * attenuation_beta_squared_squared * shortfall_epsilon * sigma_r_squared * sum_8
    )
    part_02_cos_epsilon_sin_beta_sin_epsilon = (
        (-1.0 - attenuation_epsilon) * attenuation_beta * attenuation_epsilon_squared * r_squared * shortfall_epsilon
        + attenuation_beta * attenuation_epsilon_squared_squared * sigma_r_squared
    )
    part_03_cos_epsilon_sin_beta = (
        attenuation_beta * attenuation_epsilon * r * rho * sigma_r * sigma_rdot
        + attenuation_beta * attenuation_epsilon * rdot * sigma_r_squared
    )
    part_22_cos_epsilon2 = (
        0.5 * r_squared * shortfall_epsilon * sum_8
        + 0.5 * shortfall_epsilon * sigma_r_squared * sum_8
    )
    sum_9 = 1.0 + 2.0 * attenuation_epsilon + attenuation_epsilon_squared
    sum_10 = 0.5 + 0.5 * attenuation_epsilon_squared_squared
    part_22_sin_epsilon2 = 0.5 * r_squared * shortfall_epsilon_squared * sum_9 + sigma_r_squared * sum_10
    part_23_sin_epsilon = (
        attenuation_epsilon * r * rho * sigma_r * sigma_rdot
        + attenuation_epsilon * rdot * sigma_r_squared
    )
    cos_beta_squared = cos_beta**2
    cos_epsilon_squared = cos_epsilon**2
    sin_epsilon_squared = sin_epsilon**2
    sin_beta_squared = sin_beta**2
    sigma_rdot_squared = sigma_rdot**2
    result = _empty(arguments, (4, 4))
    result[..., 0, 0] = (
        cos_beta_squared * cos_epsilon_squared * part_00_cos_beta2_cos_epsilon2
        + cos_beta_squared * part_00_cos_beta2_sin_epsilon2 * sin_epsilon_squared
        + cos_epsilon_squared * part_00_cos_epsilon2_sin_beta2 * sin_beta_squared
        + part_00_sin_beta2_sin_epsilon2 * sin_beta_squared * sin_epsilon_squared
    )
    result[..., 0, 1] = (
        cos_beta * cos_epsilon_squared * part_01_cos_beta_cos_epsilon2_sin_beta * sin_beta
        + cos_beta * part_01_cos_beta_sin_beta_sin_epsilon2 * sin_beta * sin_epsilon_squared
    )
    result[..., 0, 2] = cos_epsilon * part_02_cos_epsilon_sin_beta_sin_epsilon * sin_beta * sin_epsilon
    result[..., 0, 3] = cos_epsilon * part_03_cos_epsilon_sin_beta * sin_beta
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = (
        cos_beta_squared * cos_epsilon_squared * part_00_cos_epsilon2_sin_beta2
        + cos_beta_squared * part_00_sin_beta2_sin_epsilon2 * sin_epsilon_squared
        + cos_epsilon_squared * part_00_cos_beta2_cos_epsilon2 * sin_beta_squared
        + part_00_cos_beta2_sin_epsilon2 * sin_beta_squared * sin_epsilon_squared
    )
    result[..., 1, 2] = cos_beta * cos_epsilon * part_02_cos_epsilon_sin_beta_sin_epsilon * sin_epsilon
    result[..., 1, 3] = cos_beta * cos_epsilon * part_03_cos_epsilon_sin_beta
    result[..., 2, 0] = result[..., 0, 2]
    result[..., 2, 1] = result[..., 1, 2]
    result[..., 2, 2] = (
        cos_epsilon_squared * part_22_cos_epsilon2
        + part_22_sin_epsilon2 * sin_epsilon_squared
    )
    result[..., 2, 3] = part_23_sin_epsilon * sin_epsilon
    result[..., 3, 0] = result[..., 0, 3]
    result[..., 3, 1] = result[..., 1, 3]
    result[..., 3, 2] = result[..., 2, 3]
    result[..., 3, 3] = (
        2.0 * r * rdot * rho * sigma_r * sigma_rdot
        + r_squared * sigma_rdot_squared
        + rdot**2 * sigma_r_squared
        + sigma_r_squared * sigma_rdot_squared
        + rho**2 * sigma_r_squared * sigma_rdot_squared
    )
    return result


def covariance_averaged(
    *,
    r: npt.ArrayLike,
    beta: npt.ArrayLike,
    epsilon: npt.ArrayLike,
    rdot: npt.ArrayLike,
    sigma_r: npt.ArrayLike,
    sigma_beta: npt.ArrayLike,
    sigma_epsilon: npt.ArrayLike,
    sigma_rdot: npt.ArrayLike,
    rho: npt.ArrayLike,
) -> Floats:
    """Exact covariance of the plain conversion, averaged over the truth.

    Name: spherical_doppler.covariance.averaged.
    Definition: e^L C.
    Conditioning: measurement-conditioned: the measured symbols stand for the measurement.
    Source: Lerro & Bar-Shalom 1993; Prosov (11), doi:10.1109/7.220948.

    Args:
        r: range [m], 1 to 1e+08.
        beta: azimuth, clockwise from the y axis [rad], -3.1416 to 3.1416.
        epsilon: elevation, up from the horizontal plane [rad], -1.5708 to 1.5708.
        rdot: range rate [m/s], -10000 to 10000.
        sigma_r: standard deviation of the error of r [m], 0.001 to 10000.
        sigma_beta: standard deviation of the error of beta [rad], 1e-09 to 1.
        sigma_epsilon: standard deviation of the error of epsilon [rad], 1e-09 to 1.
        sigma_rdot: standard deviation of the error of rdot [m/s], 0.0001 to 1000.
        rho: correlation of the errors of r and rdot [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (4, 4), unit [m, m, m, m^2/s] × [m, m, m, m^2/s].

    Accuracy: at most 675 ulp anywhere in this domain with independent errors, proved for elementary functions
    within 1 ulp (float64).
    """
    arguments = _floats(r, beta, epsilon, rdot, sigma_r, sigma_beta, sigma_epsilon, sigma_rdot, rho)
    r, beta, epsilon, rdot, sigma_r, sigma_beta, sigma_epsilon, sigma_rdot, rho = arguments
    cos_beta = np.cos(beta)
    sin_beta = np.sin(beta)
    cos_epsilon = np.cos(epsilon)
    sin_epsilon = np.sin(epsilon)
    attenuation_beta = np.exp(-sigma_beta**2)
    shortfall_beta = -np.expm1(-sigma_beta**2)
    attenuation_epsilon = np.exp(-sigma_epsilon**2)
    shortfall_epsilon = -np.expm1(-sigma_epsilon**2)
    attenuation_beta_squared = attenuation_beta**2
    product_1 = -attenuation_beta_squared * attenuation_epsilon
    attenuation_epsilon_squared = attenuation_epsilon**2
    product_2 = attenuation_epsilon * attenuation_epsilon_squared
    product_3 = -attenuation_beta_squared * product_2
    product_4 = -attenuation_beta * attenuation_epsilon
    product_5 = -attenuation_beta * product_2
    attenuation_epsilon_squared_squared = attenuation_epsilon_squared**2
    product_6 = attenuation_beta * attenuation_beta_squared
    r_squared = r**2
    sum_1 = (
        1.0
        + attenuation_beta
        + attenuation_beta * attenuation_epsilon_squared_squared
        + attenuation_beta_squared
        + attenuation_beta_squared * attenuation_epsilon_squared_squared
        + attenuation_epsilon_squared_squared
        + attenuation_epsilon_squared_squared * product_6
        + product_1
        + product_3
        + product_4
        + product_5
        + product_6
    )
    product_7 = 2.0 * attenuation_beta * attenuation_epsilon_squared_squared
    sigma_r_squared = sigma_r**2
    sum_2 = (
        2.0
        + 2.0 * attenuation_beta
        + 2.0 * attenuation_beta_squared
        + 2.0 * attenuation_beta_squared * attenuation_epsilon_squared_squared
        + 2.0 * attenuation_epsilon_squared_squared
        + 2.0 * attenuation_epsilon_squared_squared * product_6
        + 2.0 * product_6
        + product_1
        + product_3
        + product_4
        + product_5
        + product_7
    )
    part_00_cos_beta2_cos_epsilon2 = (
        0.25 * r_squared * shortfall_beta * sum_1
        + 0.25 * shortfall_beta * sigma_r_squared * sum_2
    )
    sum_3 = (
        1.0
        + attenuation_beta
        + attenuation_beta * product_2
        + attenuation_beta_squared
        + attenuation_beta_squared * product_2
        + attenuation_epsilon
        + attenuation_epsilon * product_6
        + attenuation_epsilon_squared
        + attenuation_epsilon_squared * product_6
        + product_2
        + product_2 * product_6
        + product_6
    )
    product_8 = 2.0 * attenuation_beta * product_2
    sum_4 = (
        2.0
        + 2.0 * attenuation_beta
        + 2.0 * attenuation_beta_squared
        + 2.0 * attenuation_beta_squared * product_2
        + 2.0 * attenuation_epsilon
        + 2.0 * attenuation_epsilon * product_6
        + 2.0 * attenuation_epsilon_squared
        + 2.0 * attenuation_epsilon_squared * product_6
        + 2.0 * product_2
        + 2.0 * product_2 * product_6
        + 2.0 * product_6
        + attenuation_beta * attenuation_epsilon
        + attenuation_beta * attenuation_epsilon_squared
        + attenuation_beta_squared * attenuation_epsilon
        + attenuation_beta_squared * attenuation_epsilon_squared
        + product_8
    )
    part_00_cos_beta2_sin_epsilon2 = (
        0.25 * r_squared * shortfall_beta * shortfall_epsilon * sum_3
        + 0.25 * shortfall_beta * shortfall_epsilon * sigma_r_squared * sum_4
    )
    shortfall_beta_squared = shortfall_beta**2
    product_9 = shortfall_beta * shortfall_beta_squared
    shortfall_epsilon_squared = shortfall_epsilon**2
    product_10 = shortfall_epsilon * shortfall_epsilon_squared
    shortfall_epsilon_squared_squared = shortfall_epsilon_squared**2
    attenuation_beta_squared_squared = attenuation_beta_squared**2
    shortfall_beta_squared_squared = shortfall_beta_squared**2
    sum_5 = (
        3.75 * attenuation_beta * attenuation_epsilon * product_10 * product_9
        + 5.25 * attenuation_beta * attenuation_epsilon_squared * product_9 * shortfall_epsilon_squared
        + 5.25 * attenuation_beta_squared * attenuation_epsilon * product_10 * shortfall_beta_squared
        + 6.75 * attenuation_beta_squared * attenuation_epsilon_squared * shortfall_beta_squared * shortfall_epsilon_squared
        + 1.5 * attenuation_beta * attenuation_epsilon_squared_squared * product_9
        + 3.0 * attenuation_beta * product_2 * product_9 * shortfall_epsilon
        + 1.5 * attenuation_beta_squared * attenuation_epsilon_squared_squared * shortfall_beta_squared
        + 3.0 * attenuation_beta_squared * product_2 * shortfall_beta_squared * shortfall_epsilon
        + 1.5 * attenuation_beta_squared * shortfall_beta_squared * shortfall_epsilon_squared_squared
        + 1.5 * attenuation_beta_squared_squared * attenuation_epsilon * product_10
        + 1.5 * attenuation_beta_squared_squared * attenuation_epsilon_squared * shortfall_epsilon_squared
        + 3.0 * attenuation_epsilon * product_10 * product_6 * shortfall_beta
        + 3.0 * attenuation_epsilon_squared * product_6 * shortfall_beta * shortfall_epsilon_squared
        + 1.5 * attenuation_epsilon_squared * shortfall_beta_squared_squared * shortfall_epsilon_squared
        + attenuation_beta * product_9 * shortfall_epsilon_squared_squared
        + 0.5 * attenuation_beta_squared_squared * shortfall_epsilon_squared_squared
        + attenuation_epsilon * product_10 * shortfall_beta_squared_squared
        + 0.5 * attenuation_epsilon_squared_squared * shortfall_beta_squared_squared
        + product_2 * shortfall_beta_squared_squared * shortfall_epsilon
        + product_6 * shortfall_beta * shortfall_epsilon_squared_squared
        + 0.25 * shortfall_beta_squared_squared * shortfall_epsilon_squared_squared
    )
    sum_6 = (
        0.5
        - 0.25 * attenuation_beta * attenuation_epsilon
        - 0.25 * attenuation_beta * product_2
        - 0.25 * attenuation_epsilon * product_6
        - 0.25 * product_2 * product_6
        + 0.5 * attenuation_beta_squared_squared * attenuation_epsilon_squared_squared
        + 0.5 * attenuation_beta_squared_squared
        + 0.5 * attenuation_epsilon_squared_squared
    )
    part_00_cos_epsilon2_sin_beta2 = r_squared * sum_5 + sigma_r_squared * sum_6
    product_11 = -attenuation_epsilon * product_6
    product_12 = -attenuation_epsilon_squared * product_6
    product_13 = -attenuation_beta * attenuation_epsilon_squared
    sum_7 = (
        1.0
        + attenuation_beta_squared_squared
        + attenuation_beta_squared_squared * attenuation_epsilon
        + attenuation_beta_squared_squared * attenuation_epsilon_squared
        + attenuation_beta_squared_squared * product_2
        + attenuation_epsilon
        + attenuation_epsilon_squared
        + product_11
        + product_12
        + product_13
        + product_2
        + product_4
    )
    sum_8 = (
        2.0
        + 2.0 * attenuation_beta_squared_squared
        + 2.0 * attenuation_beta_squared_squared * attenuation_epsilon
        + 2.0 * attenuation_beta_squared_squared * attenuation_epsilon_squared
        + 2.0 * attenuation_beta_squared_squared * product_2
        + 2.0 * attenuation_epsilon
        + 2.0 * attenuation_epsilon_squared
        + 2.0 * product_2
        + product_11
        + product_12
        + product_13
        + product_4
    )
    part_00_sin_beta2_sin_epsilon2 = (
        0.25 * r_squared * shortfall_epsilon * sum_7
        + 0.25 * shortfall_epsilon * sigma_r_squared * sum_8
    )
    product_14 = -2.0 * attenuation_epsilon_squared_squared * shortfall_beta
    product_15 = -3.0 * attenuation_epsilon_squared * shortfall_beta * shortfall_epsilon_squared
    product_16 = -4.0 * product_2 * shortfall_beta * shortfall_epsilon
    product_17 = -attenuation_epsilon * product_10 * shortfall_beta
    sum_9 = (
        3.0 * attenuation_beta * attenuation_epsilon * product_10
        + 3.0 * attenuation_beta * attenuation_epsilon_squared * shortfall_epsilon_squared
        + attenuation_beta * shortfall_epsilon_squared_squared
        + product_14
        + product_15
        + product_16
        + product_17
    )
    sum_10 = (
        2.0 * attenuation_beta * shortfall_epsilon_squared_squared
        + 4.0 * attenuation_beta * product_2 * shortfall_epsilon
        + 7.0 * attenuation_beta * attenuation_epsilon * product_10
        + 9.0 * attenuation_beta * attenuation_epsilon_squared * shortfall_epsilon_squared
        + product_14
        + product_15
        + product_16
        + product_17
        + product_7
    )
    part_01_cos_beta_cos_epsilon2_sin_beta = (
        0.5 * product_6 * r_squared * sum_9
        + 0.5 * product_6 * sigma_r_squared * sum_10
    )
    product_18 = -2.0 * product_2 * shortfall_beta
    product_19 = -3.0 * attenuation_epsilon_squared * shortfall_beta * shortfall_epsilon
    product_20 = -attenuation_epsilon * shortfall_beta * shortfall_epsilon_squared
    sum_11 = (
        3.0 * attenuation_beta * attenuation_epsilon * shortfall_epsilon_squared
        + 3.0 * attenuation_beta * attenuation_epsilon_squared * shortfall_epsilon
        + attenuation_beta * product_10
        + product_18
        + product_19
        + product_20
        + product_8
    )
    sum_12 = (
        2.0 * attenuation_beta * product_10
        + 6.0 * attenuation_beta * product_2
        + 7.0 * attenuation_beta * attenuation_epsilon * shortfall_epsilon_squared
        + 9.0 * attenuation_beta * attenuation_epsilon_squared * shortfall_epsilon
        + product_18
        + product_19
        + product_20
    )
    part_01_cos_beta_sin_beta_sin_epsilon2 = (
        0.5 * product_6 * r_squared * shortfall_epsilon * sum_11
        + 0.5 * product_6 * shortfall_epsilon * sigma_r_squared * sum_12
    )
    sum_13 = attenuation_epsilon - shortfall_epsilon
    part_02_cos_epsilon_sin_beta_sin_epsilon = (
        attenuation_beta * product_2 * sigma_r_squared * sum_13
        - attenuation_beta * product_2 * r_squared * shortfall_epsilon
    )
    part_03_cos_epsilon_sin_beta = (
        attenuation_beta * attenuation_epsilon * r * rho * sigma_r * sigma_rdot
        + attenuation_beta * attenuation_epsilon * rdot * sigma_r_squared
    )
    sum_14 = 2.0 + 2.0 * product_2 + attenuation_epsilon + attenuation_epsilon_squared
    part_22_cos_epsilon2 = (
        0.5 * (1.0 + product_2) * r_squared * shortfall_epsilon
        + 0.5 * shortfall_epsilon * sigma_r_squared * sum_14
    )
    sum_15 = 1.0 + attenuation_epsilon + attenuation_epsilon_squared
    sum_16 = 1.0 - 0.5 * attenuation_epsilon - 0.5 * product_2 + attenuation_epsilon_squared_squared
    part_22_sin_epsilon2 = 0.5 * r_squared * shortfall_epsilon_squared * sum_15 + sigma_r_squared * sum_16
    part_23_sin_epsilon = (
        attenuation_epsilon * r * rho * sigma_r * sigma_rdot
        + attenuation_epsilon * rdot * sigma_r_squared
    )
    cos_beta_squared = cos_beta**2
    cos_epsilon_squared = cos_epsilon**2
    sin_epsilon_squared = sin_epsilon**2
    sin_beta_squared = sin_beta**2
    sigma_rdot_squared = sigma_rdot**2
    result = _empty(arguments, (4, 4))
    result[..., 0, 0] = (
        cos_beta_squared * cos_epsilon_squared * part_00_cos_beta2_cos_epsilon2
        + cos_beta_squared * part_00_cos_beta2_sin_epsilon2 * sin_epsilon_squared
        + cos_epsilon_squared * part_00_cos_epsilon2_sin_beta2 * sin_beta_squared
        + part_00_sin_beta2_sin_epsilon2 * sin_beta_squared * sin_epsilon_squared
    )
    result[..., 0, 1] = (
        cos_beta * cos_epsilon_squared * part_01_cos_beta_cos_epsilon2_sin_beta * sin_beta
        + cos_beta * part_01_cos_beta_sin_beta_sin_epsilon2 * sin_beta * sin_epsilon_squared
    )
    result[..., 0, 2] = cos_epsilon * part_02_cos_epsilon_sin_beta_sin_epsilon * sin_beta * sin_epsilon
    result[..., 0, 3] = cos_epsilon * part_03_cos_epsilon_sin_beta * sin_beta
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = (
        cos_beta_squared * cos_epsilon_squared * part_00_cos_epsilon2_sin_beta2
        + cos_beta_squared * part_00_sin_beta2_sin_epsilon2 * sin_epsilon_squared
        + cos_epsilon_squared * part_00_cos_beta2_cos_epsilon2 * sin_beta_squared
        + part_00_cos_beta2_sin_epsilon2 * sin_beta_squared * sin_epsilon_squared
    )
    result[..., 1, 2] = cos_beta * cos_epsilon * part_02_cos_epsilon_sin_beta_sin_epsilon * sin_epsilon
    result[..., 1, 3] = cos_beta * cos_epsilon * part_03_cos_epsilon_sin_beta
    result[..., 2, 0] = result[..., 0, 2]
    result[..., 2, 1] = result[..., 1, 2]
    result[..., 2, 2] = (
        cos_epsilon_squared * part_22_cos_epsilon2
        + part_22_sin_epsilon2 * sin_epsilon_squared
    )
    result[..., 2, 3] = part_23_sin_epsilon * sin_epsilon
    result[..., 3, 0] = result[..., 0, 3]
    result[..., 3, 1] = result[..., 1, 3]
    result[..., 3, 2] = result[..., 2, 3]
    result[..., 3, 3] = (
        2.0 * r * rdot * rho * sigma_r * sigma_rdot
        + 3.0 * sigma_r_squared * sigma_rdot_squared
        + 3.0 * rho**2 * sigma_r_squared * sigma_rdot_squared
        + r_squared * sigma_rdot_squared
        + rdot**2 * sigma_r_squared
    )
    return result


def unbiased_estimate(
    *,
    r: npt.ArrayLike,
    beta: npt.ArrayLike,
    epsilon: npt.ArrayLike,
    rdot: npt.ArrayLike,
    sigma_r: npt.ArrayLike,
    sigma_beta: npt.ArrayLike,
    sigma_epsilon: npt.ArrayLike,
    sigma_rdot: npt.ArrayLike,
    rho: npt.ArrayLike,
) -> Floats:
    """Exactly unbiased estimate of the position.

    Name: spherical_doppler.unbiased.estimate.
    Definition: u = e^-L h.
    Conditioning: measurement-conditioned: the measured symbols stand for the measurement.
    Source: Mo et al. 1998, doi:10.1109/7.705921.

    Args:
        r: range [m], 1 to 1e+08.
        beta: azimuth, clockwise from the y axis [rad], -3.1416 to 3.1416.
        epsilon: elevation, up from the horizontal plane [rad], -1.5708 to 1.5708.
        rdot: range rate [m/s], -10000 to 10000.
        sigma_r: standard deviation of the error of r [m], 0.001 to 10000.
        sigma_beta: standard deviation of the error of beta [rad], 1e-09 to 1.
        sigma_epsilon: standard deviation of the error of epsilon [rad], 1e-09 to 1.
        sigma_rdot: standard deviation of the error of rdot [m/s], 0.0001 to 1000.
        rho: correlation of the errors of r and rdot [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (4), unit [m, m, m, m^2/s].

    Accuracy: at most 15.1 ulp anywhere in this domain with independent errors, proved for elementary
    functions within 1 ulp (float64); in float32, with functions within 4 of its ulp, at most 176.
    """
    arguments = _floats(r, beta, epsilon, rdot, sigma_r, sigma_beta, sigma_epsilon, sigma_rdot, rho)
    r, beta, epsilon, rdot, sigma_r, sigma_beta, sigma_epsilon, sigma_rdot, rho = arguments
    cos_beta = np.cos(beta)
    sin_beta = np.sin(beta)
    cos_epsilon = np.cos(epsilon)
    sin_epsilon = np.sin(epsilon)
    attenuation_beta = np.exp(-0.5 * sigma_beta**2)
    attenuation_epsilon = np.exp(-0.5 * sigma_epsilon**2)
    term_1 = 1.0 / attenuation_epsilon
    part_0_cos_epsilon_sin_beta = r * term_1 / attenuation_beta
    result = _empty(arguments, (4,))
    result[..., 0] = cos_epsilon * part_0_cos_epsilon_sin_beta * sin_beta
    result[..., 1] = cos_beta * cos_epsilon * part_0_cos_epsilon_sin_beta
    result[..., 2] = r * sin_epsilon * term_1
    result[..., 3] = r * rdot - rho * sigma_r * sigma_rdot
    return result


def unbiased_covariance(
    *,
    r: npt.ArrayLike,
    beta: npt.ArrayLike,
    epsilon: npt.ArrayLike,
    rdot: npt.ArrayLike,
    sigma_r: npt.ArrayLike,
    sigma_beta: npt.ArrayLike,
    sigma_epsilon: npt.ArrayLike,
    sigma_rdot: npt.ArrayLike,
    rho: npt.ArrayLike,
) -> Floats:
    """Error covariance of the unbiased estimate u.

    Name: spherical_doppler.unbiased.covariance.
    Definition: u u' - u (e^L h)' - (e^L h) u' + e^L(h h').
    Conditioning: measurement-conditioned: the measured symbols stand for the measurement.
    Source: Mo et al. 1998, doi:10.1109/7.705921.

    Args:
        r: range [m], 1 to 1e+08.
        beta: azimuth, clockwise from the y axis [rad], -3.1416 to 3.1416.
        epsilon: elevation, up from the horizontal plane [rad], -1.5708 to 1.5708.
        rdot: range rate [m/s], -10000 to 10000.
        sigma_r: standard deviation of the error of r [m], 0.001 to 10000.
        sigma_beta: standard deviation of the error of beta [rad], 1e-09 to 1.
        sigma_epsilon: standard deviation of the error of epsilon [rad], 1e-09 to 1.
        sigma_rdot: standard deviation of the error of rdot [m/s], 0.0001 to 1000.
        rho: correlation of the errors of r and rdot [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (4, 4), unit [m, m, m, m^2/s] × [m, m, m, m^2/s].

    Accuracy: at most 324 ulp anywhere in this domain with independent errors, proved for elementary functions
    within 1 ulp (float64).
    """
    arguments = _floats(r, beta, epsilon, rdot, sigma_r, sigma_beta, sigma_epsilon, sigma_rdot, rho)
    r, beta, epsilon, rdot, sigma_r, sigma_beta, sigma_epsilon, sigma_rdot, rho = arguments
    cos_beta = np.cos(beta)
    sin_beta = np.sin(beta)
    cos_epsilon = np.cos(epsilon)
    sin_epsilon = np.sin(epsilon)
    attenuation_beta = np.exp(-0.5 * sigma_beta**2)
    shortfall_beta = -np.expm1(-0.5 * sigma_beta**2)
    attenuation_epsilon = np.exp(-0.5 * sigma_epsilon**2)
    shortfall_epsilon = -np.expm1(-0.5 * sigma_epsilon**2)
    attenuation_beta_squared = attenuation_beta**2
    attenuation_epsilon_squared = attenuation_epsilon**2
    attenuation_epsilon_squared_squared = attenuation_epsilon_squared**2
    product_1 = attenuation_beta * attenuation_beta_squared
    sum_1 = (
        1.0
        + attenuation_beta
        + attenuation_beta * attenuation_epsilon_squared_squared
        + attenuation_beta_squared
        + attenuation_beta_squared * attenuation_epsilon_squared_squared
        + attenuation_epsilon_squared_squared
        + attenuation_epsilon_squared_squared * product_1
        + product_1
    )
    r_squared = r**2
    sigma_r_squared = sigma_r**2
    part_00_cos_beta2_cos_epsilon2 = (
        0.25 * r_squared * shortfall_beta * sum_1
        + 0.25 * shortfall_beta * sigma_r_squared * sum_1
    )
    product_2 = attenuation_beta_squared * attenuation_epsilon_squared
    product_3 = attenuation_epsilon * attenuation_epsilon_squared
    sum_2 = (
        1.0
        + attenuation_beta
        + attenuation_beta * attenuation_epsilon
        + attenuation_beta * attenuation_epsilon_squared
        + attenuation_beta * product_3
        + attenuation_beta_squared
        + attenuation_beta_squared * attenuation_epsilon
        + attenuation_beta_squared * product_3
        + attenuation_epsilon
        + attenuation_epsilon * product_1
        + attenuation_epsilon_squared
        + attenuation_epsilon_squared * product_1
        + product_1
        + product_1 * product_3
        + product_2
        + product_3
    )
    part_00_cos_beta2_sin_epsilon2 = (
        0.25 * r_squared * shortfall_beta * shortfall_epsilon * sum_2
        + 0.25 * shortfall_beta * shortfall_epsilon * sigma_r_squared * sum_2
    )
    shortfall_beta_squared = shortfall_beta**2
    product_4 = shortfall_beta * shortfall_beta_squared
    shortfall_epsilon_squared = shortfall_epsilon**2
    attenuation_beta_squared_squared = attenuation_beta_squared**2
    product_5 = shortfall_epsilon * shortfall_epsilon_squared
    shortfall_beta_squared_squared = shortfall_beta_squared**2
    shortfall_epsilon_squared_squared = shortfall_epsilon_squared**2
    product_6 = attenuation_beta * attenuation_beta_squared**2
    product_7 = shortfall_epsilon * shortfall_epsilon_squared**2
    product_8 = attenuation_epsilon * attenuation_epsilon_squared**2
    product_9 = shortfall_beta * shortfall_beta_squared**2
    attenuation_epsilon_squared_cubed = attenuation_epsilon_squared * attenuation_epsilon_squared**2
    shortfall_epsilon_squared_cubed = shortfall_epsilon_squared * shortfall_epsilon_squared**2
    attenuation_beta_squared_cubed = attenuation_beta_squared * attenuation_beta_squared**2
    shortfall_beta_squared_cubed = shortfall_beta_squared * shortfall_beta_squared**2
    term_1 = 1.0 / attenuation_beta**2
    term_2 = 1.0 / attenuation_epsilon**2
    sum_3 = (
        1032.0 * attenuation_beta_squared_squared * product_3 * product_5 * shortfall_beta_squared
        + 1032.0 * attenuation_epsilon_squared_squared * product_1 * product_4 * shortfall_epsilon_squared
        + 1172.0 * attenuation_beta_squared * product_3 * product_5 * shortfall_beta_squared_squared
        + 1172.0 * attenuation_epsilon_squared * product_1 * product_4 * shortfall_epsilon_squared_squared
        + 144.0 * attenuation_beta * attenuation_epsilon * product_7 * product_9
        + 144.0 * attenuation_beta * product_8 * product_9 * shortfall_epsilon
        + 144.0 * attenuation_epsilon * product_6 * product_7 * shortfall_beta
        + 1488.0 * product_1 * product_3 * product_4 * product_5
        + 192.0 * attenuation_beta_squared_squared * product_8 * shortfall_beta_squared * shortfall_epsilon
        + 192.0 * attenuation_epsilon_squared_squared * product_6 * shortfall_beta * shortfall_epsilon_squared
        + 24.0 * attenuation_beta * attenuation_epsilon_squared_cubed * product_9
        + 24.0 * attenuation_beta * product_9 * shortfall_epsilon_squared_cubed
        + 24.0 * attenuation_beta_squared_cubed * attenuation_epsilon * product_7
        + 24.0 * attenuation_beta_squared_cubed * attenuation_epsilon_squared_squared * shortfall_epsilon_squared
        + 24.0 * attenuation_beta_squared_squared * attenuation_epsilon_squared_cubed * shortfall_beta_squared
        + 24.0 * attenuation_epsilon * product_7 * shortfall_beta_squared_cubed
        + 24.0 * product_6 * shortfall_beta * shortfall_epsilon_squared_cubed
        + 24.0 * product_8 * shortfall_beta_squared_cubed * shortfall_epsilon
        + 32.0 * product_6 * product_8 * shortfall_beta * shortfall_epsilon
        + 332.0 * attenuation_beta_squared * product_8 * shortfall_beta_squared_squared * shortfall_epsilon
        + 332.0 * attenuation_epsilon_squared * product_6 * shortfall_beta * shortfall_epsilon_squared_squared
        + 360.0 * attenuation_beta * attenuation_epsilon_squared * product_9 * shortfall_epsilon_squared_squared
        + 360.0 * attenuation_beta * attenuation_epsilon_squared_squared * product_9 * shortfall_epsilon_squared
        + 360.0 * attenuation_beta_squared * attenuation_epsilon * product_7 * shortfall_beta_squared_squared
        + 360.0 * attenuation_beta_squared_squared * attenuation_epsilon * product_7 * shortfall_beta_squared
        + 368.0 * product_1 * product_4 * product_8 * shortfall_epsilon
        + 368.0 * product_3 * product_5 * product_6 * shortfall_beta
        + 4.0 * attenuation_beta_squared_cubed * shortfall_epsilon_squared_cubed
        + 4.0 * attenuation_epsilon_squared_cubed * shortfall_beta_squared_cubed
        + 4.0 * shortfall_beta_squared_cubed * shortfall_epsilon_squared_cubed
        + 480.0 * attenuation_beta * product_3 * product_5 * product_9
        + 480.0 * attenuation_epsilon * product_1 * product_4 * product_7
        + 54.0 * attenuation_beta_squared * attenuation_epsilon_squared_cubed * shortfall_beta_squared_squared
        + 54.0 * attenuation_beta_squared_cubed * attenuation_epsilon_squared * shortfall_epsilon_squared_squared
        + 56.0 * attenuation_beta_squared_cubed * product_3 * product_5
        + 56.0 * attenuation_epsilon_squared_cubed * product_1 * product_4
        + 60.0 * attenuation_beta_squared * shortfall_beta_squared_squared * shortfall_epsilon_squared_cubed
        + 60.0 * attenuation_beta_squared_squared * shortfall_beta_squared * shortfall_epsilon_squared_cubed
        + 60.0 * attenuation_epsilon_squared * shortfall_beta_squared_cubed * shortfall_epsilon_squared_squared
        + 60.0 * attenuation_epsilon_squared_squared * shortfall_beta_squared_cubed * shortfall_epsilon_squared
        + 648.0 * attenuation_beta_squared_squared * attenuation_epsilon_squared_squared * shortfall_beta_squared * shortfall_epsilon_squared
        + 80.0 * product_1 * product_4 * shortfall_epsilon_squared_cubed
        + 80.0 * product_3 * product_5 * shortfall_beta_squared_cubed
        + 858.0 * attenuation_beta_squared * attenuation_epsilon_squared_squared * shortfall_beta_squared_squared * shortfall_epsilon_squared
        + 858.0 * attenuation_beta_squared_squared * attenuation_epsilon_squared * shortfall_beta_squared * shortfall_epsilon_squared_squared
        + 893.0 * attenuation_beta_squared * attenuation_epsilon_squared * shortfall_beta_squared_squared * shortfall_epsilon_squared_squared
    )
    sum_4 = (
        0.25
        + 0.25 * attenuation_beta_squared_squared * attenuation_epsilon_squared_squared
        + 0.25 * attenuation_beta_squared_squared
        + 0.25 * attenuation_epsilon_squared_squared
    )
    part_00_cos_epsilon2_sin_beta2 = 0.25 * r_squared * sum_3 * term_1 * term_2 + sigma_r_squared * sum_4
    sum_5 = (
        1.0
        + attenuation_beta_squared_squared
        + attenuation_beta_squared_squared * attenuation_epsilon
        + attenuation_beta_squared_squared * attenuation_epsilon_squared
        + attenuation_beta_squared_squared * product_3
        + attenuation_epsilon
        + attenuation_epsilon_squared
        + product_3
    )
    part_00_sin_beta2_sin_epsilon2 = (
        0.25 * r_squared * shortfall_epsilon * sum_5
        + 0.25 * shortfall_epsilon * sigma_r_squared * sum_5
    )
    sum_6 = 1.0 + attenuation_epsilon_squared_squared
    sum_7 = (
        12.0 * attenuation_beta * attenuation_epsilon_squared_cubed * product_9
        - 4.0 * attenuation_epsilon_squared_cubed * product_6 * shortfall_beta
        + 12.0 * attenuation_beta * product_9 * shortfall_epsilon_squared_cubed
        + 12.0 * attenuation_beta_squared_cubed * attenuation_epsilon * product_7
        + 12.0 * attenuation_beta_squared_cubed * attenuation_epsilon_squared_squared * shortfall_epsilon_squared
        + 12.0 * attenuation_epsilon * product_7 * shortfall_beta_squared_cubed
        + 12.0 * product_6 * shortfall_beta * shortfall_epsilon_squared_cubed
        + 12.0 * product_8 * shortfall_beta_squared_cubed * shortfall_epsilon
        + 164.0 * attenuation_beta_squared * product_8 * shortfall_beta_squared_squared * shortfall_epsilon
        + 164.0 * attenuation_epsilon_squared * product_6 * shortfall_beta * shortfall_epsilon_squared_squared
        + 176.0 * product_1 * product_4 * product_8 * shortfall_epsilon
        + 176.0 * product_3 * product_5 * product_6 * shortfall_beta
        + 180.0 * attenuation_beta * attenuation_epsilon_squared * product_9 * shortfall_epsilon_squared_squared
        + 180.0 * attenuation_beta * attenuation_epsilon_squared_squared * product_9 * shortfall_epsilon_squared
        + 180.0 * attenuation_beta_squared * attenuation_epsilon * product_7 * shortfall_beta_squared_squared
        + 180.0 * attenuation_beta_squared_squared * attenuation_epsilon * product_7 * shortfall_beta_squared
        + 2.0 * attenuation_beta_squared_cubed * shortfall_epsilon_squared_cubed
        + 2.0 * attenuation_epsilon_squared_cubed * shortfall_beta_squared_cubed
        + 2.0 * shortfall_beta_squared_cubed * shortfall_epsilon_squared_cubed
        + 24.0 * attenuation_epsilon_squared_cubed * product_1 * product_4
        + 240.0 * attenuation_beta * product_3 * product_5 * product_9
        + 240.0 * attenuation_epsilon * product_1 * product_4 * product_7
        + 26.0 * attenuation_beta_squared * attenuation_epsilon_squared_cubed * shortfall_beta_squared_squared
        + 27.0 * attenuation_beta_squared_cubed * attenuation_epsilon_squared * shortfall_epsilon_squared_squared
        + 28.0 * attenuation_beta_squared_cubed * product_3 * product_5
        + 30.0 * attenuation_beta_squared * shortfall_beta_squared_squared * shortfall_epsilon_squared_cubed
        + 30.0 * attenuation_beta_squared_squared * shortfall_beta_squared * shortfall_epsilon_squared_cubed
        + 30.0 * attenuation_epsilon_squared * shortfall_beta_squared_cubed * shortfall_epsilon_squared_squared
        + 30.0 * attenuation_epsilon_squared_squared * shortfall_beta_squared_cubed * shortfall_epsilon_squared
        + 306.0 * attenuation_beta_squared_squared * attenuation_epsilon_squared_squared * shortfall_beta_squared * shortfall_epsilon_squared
        + 40.0 * product_1 * product_4 * shortfall_epsilon_squared_cubed
        + 40.0 * product_3 * product_5 * shortfall_beta_squared_cubed
        + 426.0 * attenuation_beta_squared * attenuation_epsilon_squared_squared * shortfall_beta_squared_squared * shortfall_epsilon_squared
        + 426.0 * attenuation_beta_squared_squared * attenuation_epsilon_squared * shortfall_beta_squared * shortfall_epsilon_squared_squared
        + 446.0 * attenuation_beta_squared * attenuation_epsilon_squared * shortfall_beta_squared_squared * shortfall_epsilon_squared_squared
        + 504.0 * attenuation_beta_squared_squared * product_3 * product_5 * shortfall_beta_squared
        + 504.0 * attenuation_epsilon_squared_squared * product_1 * product_4 * shortfall_epsilon_squared
        + 584.0 * attenuation_beta_squared * product_3 * product_5 * shortfall_beta_squared_squared
        + 584.0 * attenuation_epsilon_squared * product_1 * product_4 * shortfall_epsilon_squared_squared
        + 6.0 * attenuation_beta_squared_squared * attenuation_epsilon_squared_cubed * shortfall_beta_squared
        + 72.0 * attenuation_beta * attenuation_epsilon * product_7 * product_9
        + 72.0 * attenuation_beta * product_8 * product_9 * shortfall_epsilon
        + 72.0 * attenuation_epsilon * product_6 * product_7 * shortfall_beta
        + 736.0 * product_1 * product_3 * product_4 * product_5
        + 8.0 * product_6 * product_8 * shortfall_beta * shortfall_epsilon
        + 84.0 * attenuation_beta_squared_squared * product_8 * shortfall_beta_squared * shortfall_epsilon
        + 84.0 * attenuation_epsilon_squared_squared * product_6 * shortfall_beta * shortfall_epsilon_squared
    )
    part_01_cos_beta_cos_epsilon2_sin_beta = (
        0.5 * attenuation_beta_squared_squared * sigma_r_squared * sum_6
        + 0.5 * r_squared * sum_7 * term_1 * term_2
    )
    sum_8 = 1.0 + attenuation_epsilon + attenuation_epsilon_squared + product_3
    part_01_cos_beta_sin_beta_sin_epsilon2 = (
        0.5 * attenuation_beta_squared_squared * r_squared * shortfall_epsilon * sum_8
        + 0.5 * attenuation_beta_squared_squared * shortfall_epsilon * sigma_r_squared * sum_8
    )
    term_3 = 1.0 / attenuation_beta
    sum_9 = (
        12.0 * attenuation_beta * attenuation_epsilon * shortfall_beta * shortfall_epsilon_squared_squared
        - 2.0 * attenuation_beta_squared * product_8
        + 12.0 * attenuation_beta_squared * product_3 * shortfall_epsilon_squared
        + 13.0 * attenuation_beta_squared * attenuation_epsilon_squared * product_5
        + 14.0 * attenuation_epsilon_squared * product_5 * shortfall_beta_squared
        + 16.0 * product_3 * shortfall_beta_squared * shortfall_epsilon_squared
        + 18.0 * attenuation_beta * attenuation_epsilon_squared_squared * shortfall_beta * shortfall_epsilon
        + 2.0 * attenuation_beta * product_7 * shortfall_beta
        + 2.0 * product_8 * shortfall_beta_squared
        + 28.0 * attenuation_beta * attenuation_epsilon_squared * product_5 * shortfall_beta
        + 3.0 * attenuation_beta_squared * attenuation_epsilon_squared_squared * shortfall_epsilon
        + 32.0 * attenuation_beta * product_3 * shortfall_beta * shortfall_epsilon_squared
        + 4.0 * attenuation_beta * product_8 * shortfall_beta
        + 6.0 * attenuation_beta_squared * attenuation_epsilon * shortfall_epsilon_squared_squared
        + 6.0 * attenuation_epsilon * shortfall_beta_squared * shortfall_epsilon_squared_squared
        + 9.0 * attenuation_epsilon_squared_squared * shortfall_beta_squared * shortfall_epsilon
        + attenuation_beta_squared * product_7
        + product_7 * shortfall_beta_squared
    )
    part_02_cos_epsilon_sin_beta_sin_epsilon = (
        attenuation_beta * attenuation_epsilon_squared_squared * sigma_r_squared
        + r_squared * shortfall_epsilon * sum_9 * term_2 * term_3
    )
    term_4 = 1.0 / attenuation_epsilon
    sum_10 = (
        product_2
        - 2.0 * attenuation_beta_squared * shortfall_epsilon_squared
        - 2.0 * attenuation_epsilon_squared * shortfall_beta_squared
        - 2.0 * shortfall_beta_squared * shortfall_epsilon_squared
        - 4.0 * attenuation_beta * attenuation_epsilon_squared * shortfall_beta
        - 4.0 * attenuation_beta * shortfall_beta * shortfall_epsilon_squared
        - 4.0 * attenuation_beta_squared * attenuation_epsilon * shortfall_epsilon
        - 4.0 * attenuation_epsilon * shortfall_beta_squared * shortfall_epsilon
        - 8.0 * attenuation_beta * attenuation_epsilon * shortfall_beta * shortfall_epsilon
    )
    part_03_cos_epsilon_sin_beta = (
        attenuation_beta * attenuation_epsilon * rdot * sigma_r_squared
        + r * rho * sigma_r * sigma_rdot * sum_10 * term_3 * term_4
    )
    part_22_cos_epsilon2 = (
        0.5 * r_squared * shortfall_epsilon * sum_8
        + 0.5 * shortfall_epsilon * sigma_r_squared * sum_8
    )
    sum_11 = (
        2.0
        + 2.0 * product_3
        + 3.0 * attenuation_epsilon_squared
        + 4.0 * attenuation_epsilon
        + attenuation_epsilon_squared_squared
    )
    sum_12 = 0.5 + 0.5 * attenuation_epsilon_squared_squared
    part_22_sin_epsilon2 = (
        0.5 * r_squared * shortfall_epsilon_squared * sum_11 * term_2
        + sigma_r_squared * sum_12
    )
    sum_13 = (
        attenuation_epsilon_squared
        - 2.0 * shortfall_epsilon_squared
        - 4.0 * attenuation_epsilon * shortfall_epsilon
    )
    part_23_sin_epsilon = (
        attenuation_epsilon * rdot * sigma_r_squared
        + r * rho * sigma_r * sigma_rdot * sum_13 * term_4
    )
    cos_beta_squared = cos_beta**2
    cos_epsilon_squared = cos_epsilon**2
    sin_epsilon_squared = sin_epsilon**2
    sin_beta_squared = sin_beta**2
    sigma_rdot_squared = sigma_rdot**2
    result = _empty(arguments, (4, 4))
    result[..., 0, 0] = (
        cos_beta_squared * cos_epsilon_squared * part_00_cos_beta2_cos_epsilon2
        + cos_beta_squared * part_00_cos_beta2_sin_epsilon2 * sin_epsilon_squared
        + cos_epsilon_squared * part_00_cos_epsilon2_sin_beta2 * sin_beta_squared
        + part_00_sin_beta2_sin_epsilon2 * sin_beta_squared * sin_epsilon_squared
    )
    result[..., 0, 1] = (
        cos_beta * cos_epsilon_squared * part_01_cos_beta_cos_epsilon2_sin_beta * sin_beta
        + cos_beta * part_01_cos_beta_sin_beta_sin_epsilon2 * sin_beta * sin_epsilon_squared
    )
    result[..., 0, 2] = cos_epsilon * part_02_cos_epsilon_sin_beta_sin_epsilon * sin_beta * sin_epsilon
    result[..., 0, 3] = cos_epsilon * part_03_cos_epsilon_sin_beta * sin_beta
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = (
        cos_beta_squared * cos_epsilon_squared * part_00_cos_epsilon2_sin_beta2
        + cos_beta_squared * part_00_sin_beta2_sin_epsilon2 * sin_epsilon_squared
        + cos_epsilon_squared * part_00_cos_beta2_cos_epsilon2 * sin_beta_squared
        + part_00_cos_beta2_sin_epsilon2 * sin_beta_squared * sin_epsilon_squared
    )
    result[..., 1, 2] = cos_beta * cos_epsilon * part_02_cos_epsilon_sin_beta_sin_epsilon * sin_epsilon
    result[..., 1, 3] = cos_beta * cos_epsilon * part_03_cos_epsilon_sin_beta
    result[..., 2, 0] = result[..., 0, 2]
    result[..., 2, 1] = result[..., 1, 2]
    result[..., 2, 2] = (
        cos_epsilon_squared * part_22_cos_epsilon2
        + part_22_sin_epsilon2 * sin_epsilon_squared
    )
    result[..., 2, 3] = part_23_sin_epsilon * sin_epsilon
    result[..., 3, 0] = result[..., 0, 3]
    result[..., 3, 1] = result[..., 1, 3]
    result[..., 3, 2] = result[..., 2, 3]
    result[..., 3, 3] = (
        2.0 * r * rdot * rho * sigma_r * sigma_rdot
        + 5.0 * rho**2 * sigma_r_squared * sigma_rdot_squared
        + r_squared * sigma_rdot_squared
        + rdot**2 * sigma_r_squared
        + sigma_r_squared * sigma_rdot_squared
    )
    return result


def posterior_estimate(
    *,
    r: npt.ArrayLike,
    beta: npt.ArrayLike,
    epsilon: npt.ArrayLike,
    rdot: npt.ArrayLike,
    sigma_r: npt.ArrayLike,
    sigma_beta: npt.ArrayLike,
    sigma_epsilon: npt.ArrayLike,
    sigma_rdot: npt.ArrayLike,
    rho: npt.ArrayLike,
) -> Floats:
    """Posterior mean of the position under a flat prior.

    Name: spherical_doppler.posterior.estimate.
    Definition: e^L h.
    Conditioning: measurement-conditioned: the measured symbols stand for the measurement.
    Source: Duan et al. 2004 modified unbiased, doi:10.1109/TAES.2004.1386889.

    Args:
        r: range [m], 1 to 1e+08.
        beta: azimuth, clockwise from the y axis [rad], -3.1416 to 3.1416.
        epsilon: elevation, up from the horizontal plane [rad], -1.5708 to 1.5708.
        rdot: range rate [m/s], -10000 to 10000.
        sigma_r: standard deviation of the error of r [m], 0.001 to 10000.
        sigma_beta: standard deviation of the error of beta [rad], 1e-09 to 1.
        sigma_epsilon: standard deviation of the error of epsilon [rad], 1e-09 to 1.
        sigma_rdot: standard deviation of the error of rdot [m/s], 0.0001 to 1000.
        rho: correlation of the errors of r and rdot [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (4), unit [m, m, m, m^2/s].

    Accuracy: at most 14.1 ulp anywhere in this domain with independent errors, proved for elementary
    functions within 1 ulp (float64); in float32, with functions within 4 of its ulp, at most 150.
    """
    arguments = _floats(r, beta, epsilon, rdot, sigma_r, sigma_beta, sigma_epsilon, sigma_rdot, rho)
    r, beta, epsilon, rdot, sigma_r, sigma_beta, sigma_epsilon, sigma_rdot, rho = arguments
    cos_beta = np.cos(beta)
    sin_beta = np.sin(beta)
    cos_epsilon = np.cos(epsilon)
    sin_epsilon = np.sin(epsilon)
    attenuation_beta = np.exp(-0.5 * sigma_beta**2)
    attenuation_epsilon = np.exp(-0.5 * sigma_epsilon**2)
    part_0_cos_epsilon_sin_beta = attenuation_beta * attenuation_epsilon * r
    result = _empty(arguments, (4,))
    result[..., 0] = cos_epsilon * part_0_cos_epsilon_sin_beta * sin_beta
    result[..., 1] = cos_beta * cos_epsilon * part_0_cos_epsilon_sin_beta
    result[..., 2] = attenuation_epsilon * r * sin_epsilon
    result[..., 3] = r * rdot + rho * sigma_r * sigma_rdot
    return result


def posterior_covariance(
    *,
    r: npt.ArrayLike,
    beta: npt.ArrayLike,
    epsilon: npt.ArrayLike,
    rdot: npt.ArrayLike,
    sigma_r: npt.ArrayLike,
    sigma_beta: npt.ArrayLike,
    sigma_epsilon: npt.ArrayLike,
    sigma_rdot: npt.ArrayLike,
    rho: npt.ArrayLike,
) -> Floats:
    """Posterior covariance of the position under a flat prior.

    Name: spherical_doppler.posterior.covariance.
    Definition: e^L(h h') - (e^L h)(e^L h)'.
    Conditioning: measurement-conditioned: the measured symbols stand for the measurement.
    Source: Duan et al. 2004 modified unbiased, doi:10.1109/TAES.2004.1386889.

    Args:
        r: range [m], 1 to 1e+08.
        beta: azimuth, clockwise from the y axis [rad], -3.1416 to 3.1416.
        epsilon: elevation, up from the horizontal plane [rad], -1.5708 to 1.5708.
        rdot: range rate [m/s], -10000 to 10000.
        sigma_r: standard deviation of the error of r [m], 0.001 to 10000.
        sigma_beta: standard deviation of the error of beta [rad], 1e-09 to 1.
        sigma_epsilon: standard deviation of the error of epsilon [rad], 1e-09 to 1.
        sigma_rdot: standard deviation of the error of rdot [m/s], 0.0001 to 1000.
        rho: correlation of the errors of r and rdot [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (4, 4), unit [m, m, m, m^2/s] × [m, m, m, m^2/s].

    Accuracy: at most 171 ulp anywhere in this domain with independent errors, proved for elementary functions
    within 1 ulp (float64).
    """
    arguments = _floats(r, beta, epsilon, rdot, sigma_r, sigma_beta, sigma_epsilon, sigma_rdot, rho)
    r, beta, epsilon, rdot, sigma_r, sigma_beta, sigma_epsilon, sigma_rdot, rho = arguments
    cos_beta = np.cos(beta)
    sin_beta = np.sin(beta)
    cos_epsilon = np.cos(epsilon)
    sin_epsilon = np.sin(epsilon)
    attenuation_beta = np.exp(-0.5 * sigma_beta**2)
    shortfall_beta = -np.expm1(-0.5 * sigma_beta**2)
    attenuation_epsilon = np.exp(-0.5 * sigma_epsilon**2)
    shortfall_epsilon = -np.expm1(-0.5 * sigma_epsilon**2)
    attenuation_beta_squared = attenuation_beta**2
    attenuation_epsilon_squared = attenuation_epsilon**2
    attenuation_epsilon_squared_squared = attenuation_epsilon_squared**2
    product_1 = attenuation_beta * attenuation_beta_squared
    sum_1 = (
        1.0
        + attenuation_beta
        + attenuation_beta * attenuation_epsilon_squared_squared
        + attenuation_beta_squared
        + attenuation_beta_squared * attenuation_epsilon_squared_squared
        + attenuation_epsilon_squared_squared
        + attenuation_epsilon_squared_squared * product_1
        + product_1
    )
    r_squared = r**2
    sigma_r_squared = sigma_r**2
    part_00_cos_beta2_cos_epsilon2 = (
        0.25 * r_squared * shortfall_beta * sum_1
        + 0.25 * shortfall_beta * sigma_r_squared * sum_1
    )
    product_2 = attenuation_epsilon * attenuation_epsilon_squared
    sum_2 = (
        1.0
        + attenuation_beta
        + attenuation_beta * attenuation_epsilon
        + attenuation_beta * attenuation_epsilon_squared
        + attenuation_beta * product_2
        + attenuation_beta_squared
        + attenuation_beta_squared * attenuation_epsilon
        + attenuation_beta_squared * attenuation_epsilon_squared
        + attenuation_beta_squared * product_2
        + attenuation_epsilon
        + attenuation_epsilon * product_1
        + attenuation_epsilon_squared
        + attenuation_epsilon_squared * product_1
        + product_1
        + product_1 * product_2
        + product_2
    )
    part_00_cos_beta2_sin_epsilon2 = (
        0.25 * r_squared * shortfall_beta * shortfall_epsilon * sum_2
        + 0.25 * shortfall_beta * shortfall_epsilon * sigma_r_squared * sum_2
    )
    shortfall_beta_squared = shortfall_beta**2
    attenuation_beta_squared_squared = attenuation_beta_squared**2
    shortfall_epsilon_squared = shortfall_epsilon**2
    product_3 = shortfall_epsilon * shortfall_epsilon_squared
    product_4 = shortfall_beta * shortfall_beta_squared
    shortfall_epsilon_squared_squared = shortfall_epsilon_squared**2
    shortfall_beta_squared_squared = shortfall_beta_squared**2
    sum_3 = (
        2.0 * attenuation_beta * attenuation_epsilon_squared_squared * product_4
        + 2.0 * attenuation_beta_squared * attenuation_epsilon_squared_squared * shortfall_beta_squared
        + 2.0 * attenuation_beta_squared_squared * attenuation_epsilon * product_3
        + 2.0 * attenuation_beta_squared_squared * attenuation_epsilon_squared * shortfall_epsilon_squared
        + 1.5 * attenuation_beta_squared * shortfall_beta_squared * shortfall_epsilon_squared_squared
        + 1.5 * attenuation_epsilon_squared * shortfall_beta_squared_squared * shortfall_epsilon_squared
        + 4.0 * attenuation_beta * attenuation_epsilon * product_3 * product_4
        + 4.0 * attenuation_beta * product_2 * product_4 * shortfall_epsilon
        + 4.0 * attenuation_beta_squared * product_2 * shortfall_beta_squared * shortfall_epsilon
        + 4.0 * attenuation_epsilon * product_1 * product_3 * shortfall_beta
        + 4.0 * attenuation_epsilon_squared * product_1 * shortfall_beta * shortfall_epsilon_squared
        + 6.0 * attenuation_beta * attenuation_epsilon_squared * product_4 * shortfall_epsilon_squared
        + 6.0 * attenuation_beta_squared * attenuation_epsilon * product_3 * shortfall_beta_squared
        + 8.0 * attenuation_beta_squared * attenuation_epsilon_squared * shortfall_beta_squared * shortfall_epsilon_squared
        + attenuation_beta * product_4 * shortfall_epsilon_squared_squared
        + 0.5 * attenuation_beta_squared_squared * shortfall_epsilon_squared_squared
        + attenuation_epsilon * product_3 * shortfall_beta_squared_squared
        + 0.5 * attenuation_epsilon_squared_squared * shortfall_beta_squared_squared
        + product_1 * shortfall_beta * shortfall_epsilon_squared_squared
        + product_2 * shortfall_beta_squared_squared * shortfall_epsilon
        + 0.25 * shortfall_beta_squared_squared * shortfall_epsilon_squared_squared
    )
    sum_4 = (
        0.25
        + 0.25 * attenuation_beta_squared_squared * attenuation_epsilon_squared_squared
        + 0.25 * attenuation_beta_squared_squared
        + 0.25 * attenuation_epsilon_squared_squared
    )
    part_00_cos_epsilon2_sin_beta2 = r_squared * sum_3 + sigma_r_squared * sum_4
    sum_5 = (
        1.0
        + attenuation_beta_squared_squared
        + attenuation_beta_squared_squared * attenuation_epsilon
        + attenuation_beta_squared_squared * attenuation_epsilon_squared
        + attenuation_beta_squared_squared * product_2
        + attenuation_epsilon
        + attenuation_epsilon_squared
        + product_2
    )
    part_00_sin_beta2_sin_epsilon2 = (
        0.25 * r_squared * shortfall_epsilon * sum_5
        + 0.25 * shortfall_epsilon * sigma_r_squared * sum_5
    )
    sum_6 = (
        4.0 * attenuation_beta_squared * attenuation_epsilon * product_3
        - 2.0 * attenuation_epsilon_squared * shortfall_beta_squared * shortfall_epsilon_squared
        - 2.0 * attenuation_epsilon_squared_squared * shortfall_beta_squared
        - 4.0 * attenuation_beta * attenuation_epsilon_squared * shortfall_beta * shortfall_epsilon_squared
        - 4.0 * attenuation_beta * attenuation_epsilon_squared_squared * shortfall_beta
        - 4.0 * product_2 * shortfall_beta_squared * shortfall_epsilon
        - 8.0 * attenuation_beta * product_2 * shortfall_beta * shortfall_epsilon
        + 4.0 * attenuation_beta_squared * attenuation_epsilon_squared * shortfall_epsilon_squared
        + attenuation_beta_squared * shortfall_epsilon_squared_squared
    )
    sum_7 = 1.0 + attenuation_epsilon_squared_squared
    part_01_cos_beta_cos_epsilon2_sin_beta = (
        0.5 * attenuation_beta_squared * r_squared * sum_6
        + 0.5 * attenuation_beta_squared_squared * sigma_r_squared * sum_7
    )
    sum_8 = 1.0 + attenuation_epsilon + attenuation_epsilon_squared + product_2
    part_01_cos_beta_sin_beta_sin_epsilon2 = (
        0.5 * attenuation_beta_squared_squared * r_squared * shortfall_epsilon * sum_8
        + 0.5 * attenuation_beta_squared_squared * shortfall_epsilon * sigma_r_squared * sum_8
    )
    part_02_cos_epsilon_sin_beta_sin_epsilon = (
        (-1.0 - attenuation_epsilon) * attenuation_beta * attenuation_epsilon_squared * r_squared * shortfall_epsilon
        + attenuation_beta * attenuation_epsilon_squared_squared * sigma_r_squared
    )
    part_03_cos_epsilon_sin_beta = (
        attenuation_beta * attenuation_epsilon * r * rho * sigma_r * sigma_rdot
        + attenuation_beta * attenuation_epsilon * rdot * sigma_r_squared
    )
    part_22_cos_epsilon2 = (
        0.5 * r_squared * shortfall_epsilon * sum_8
        + 0.5 * shortfall_epsilon * sigma_r_squared * sum_8
    )
    sum_9 = 1.0 + 2.0 * attenuation_epsilon + attenuation_epsilon_squared
    sum_10 = 0.5 + 0.5 * attenuation_epsilon_squared_squared
    part_22_sin_epsilon2 = 0.5 * r_squared * shortfall_epsilon_squared * sum_9 + sigma_r_squared * sum_10
    part_23_sin_epsilon = (
        attenuation_epsilon * r * rho * sigma_r * sigma_rdot
        + attenuation_epsilon * rdot * sigma_r_squared
    )
    cos_beta_squared = cos_beta**2
    cos_epsilon_squared = cos_epsilon**2
    sin_epsilon_squared = sin_epsilon**2
    sin_beta_squared = sin_beta**2
    sigma_rdot_squared = sigma_rdot**2
    result = _empty(arguments, (4, 4))
    result[..., 0, 0] = (
        cos_beta_squared * cos_epsilon_squared * part_00_cos_beta2_cos_epsilon2
        + cos_beta_squared * part_00_cos_beta2_sin_epsilon2 * sin_epsilon_squared
        + cos_epsilon_squared * part_00_cos_epsilon2_sin_beta2 * sin_beta_squared
        + part_00_sin_beta2_sin_epsilon2 * sin_beta_squared * sin_epsilon_squared
    )
    result[..., 0, 1] = (
        cos_beta * cos_epsilon_squared * part_01_cos_beta_cos_epsilon2_sin_beta * sin_beta
        + cos_beta * part_01_cos_beta_sin_beta_sin_epsilon2 * sin_beta * sin_epsilon_squared
    )
    result[..., 0, 2] = cos_epsilon * part_02_cos_epsilon_sin_beta_sin_epsilon * sin_beta * sin_epsilon
    result[..., 0, 3] = cos_epsilon * part_03_cos_epsilon_sin_beta * sin_beta
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = (
        cos_beta_squared * cos_epsilon_squared * part_00_cos_epsilon2_sin_beta2
        + cos_beta_squared * part_00_sin_beta2_sin_epsilon2 * sin_epsilon_squared
        + cos_epsilon_squared * part_00_cos_beta2_cos_epsilon2 * sin_beta_squared
        + part_00_cos_beta2_sin_epsilon2 * sin_beta_squared * sin_epsilon_squared
    )
    result[..., 1, 2] = cos_beta * cos_epsilon * part_02_cos_epsilon_sin_beta_sin_epsilon * sin_epsilon
    result[..., 1, 3] = cos_beta * cos_epsilon * part_03_cos_epsilon_sin_beta
    result[..., 2, 0] = result[..., 0, 2]
    result[..., 2, 1] = result[..., 1, 2]
    result[..., 2, 2] = (
        cos_epsilon_squared * part_22_cos_epsilon2
        + part_22_sin_epsilon2 * sin_epsilon_squared
    )
    result[..., 2, 3] = part_23_sin_epsilon * sin_epsilon
    result[..., 3, 0] = result[..., 0, 3]
    result[..., 3, 1] = result[..., 1, 3]
    result[..., 3, 2] = result[..., 2, 3]
    result[..., 3, 3] = (
        2.0 * r * rdot * rho * sigma_r * sigma_rdot
        + r_squared * sigma_rdot_squared
        + rdot**2 * sigma_r_squared
        + sigma_r_squared * sigma_rdot_squared
        + rho**2 * sigma_r_squared * sigma_rdot_squared
    )
    return result


def decorrelated_covariance(
    *,
    r: npt.ArrayLike,
    beta: npt.ArrayLike,
    epsilon: npt.ArrayLike,
    rdot: npt.ArrayLike,
    sigma_r: npt.ArrayLike,
    sigma_beta: npt.ArrayLike,
    sigma_epsilon: npt.ArrayLike,
    sigma_rdot: npt.ArrayLike,
    rho: npt.ArrayLike,
    predicted_sigma_r: npt.ArrayLike,
    predicted_sigma_beta: npt.ArrayLike,
    predicted_sigma_epsilon: npt.ArrayLike,
    predicted_sigma_rdot: npt.ArrayLike,
    predicted_rho: npt.ArrayLike,
) -> Floats:
    """Covariance of the unbiased estimate u, averaged over a prediction.

    Name: spherical_doppler.decorrelated.covariance.
    Definition: e^Lp [e^L(u u') - h h'].
    Conditioning: averaged over a prediction: the measured symbols stand for the predicted mean.
    Source: Bordonaro et al. 2014 decorrelated; Mo et al. 1998 R_m where Kp = K, R_t where Kp = 0,
    doi:10.1109/TAES.2014.120563, doi:10.1109/7.705921.

    Args:
        r: range [m], 1 to 1e+08.
        beta: azimuth, clockwise from the y axis [rad], -3.1416 to 3.1416.
        epsilon: elevation, up from the horizontal plane [rad], -1.5708 to 1.5708.
        rdot: range rate [m/s], -10000 to 10000.
        sigma_r: standard deviation of the error of r [m], 0.001 to 10000.
        sigma_beta: standard deviation of the error of beta [rad], 1e-09 to 1.
        sigma_epsilon: standard deviation of the error of epsilon [rad], 1e-09 to 1.
        sigma_rdot: standard deviation of the error of rdot [m/s], 0.0001 to 1000.
        rho: correlation of the errors of r and rdot [1], -1 to 1.
        predicted_sigma_r: standard deviation of the prediction of r [m], 0.001 to 10000.
        predicted_sigma_beta: standard deviation of the prediction of beta [rad], 1e-09 to 1.
        predicted_sigma_epsilon: standard deviation of the prediction of epsilon [rad], 1e-09 to 1.
        predicted_sigma_rdot: standard deviation of the prediction of rdot [m/s], 0.0001 to 1000.
        predicted_rho: correlation of the predictions of r and rdot [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (4, 4), unit [m, m, m, m^2/s] × [m, m, m, m^2/s].

    Accuracy: at most 1650 ulp anywhere in this domain with independent errors, proved for elementary
    functions within 1 ulp (float64).
    """
    arguments = _floats(r, beta, epsilon, rdot, sigma_r, sigma_beta, sigma_epsilon, sigma_rdot, rho, predicted_sigma_r, predicted_sigma_beta, predicted_sigma_epsilon, predicted_sigma_rdot, predicted_rho)
    r, beta, epsilon, rdot, sigma_r, sigma_beta, sigma_epsilon, sigma_rdot, rho, predicted_sigma_r, predicted_sigma_beta, predicted_sigma_epsilon, predicted_sigma_rdot, predicted_rho = arguments
    cos_beta = np.cos(beta)
    sin_beta = np.sin(beta)
    cos_epsilon = np.cos(epsilon)
    sin_epsilon = np.sin(epsilon)
    attenuation_predicted_beta = np.exp(-0.5 * predicted_sigma_beta**2)
    shortfall_predicted_beta = -np.expm1(-0.5 * predicted_sigma_beta**2)
    attenuation_predicted_epsilon = np.exp(-0.5 * predicted_sigma_epsilon**2)
    shortfall_predicted_epsilon = -np.expm1(-0.5 * predicted_sigma_epsilon**2)
    attenuation_beta = np.exp(-sigma_beta**2)
    shortfall_beta = -np.expm1(-sigma_beta**2)
    attenuation_epsilon = np.exp(-sigma_epsilon**2)
    shortfall_epsilon = -np.expm1(-sigma_epsilon**2)
    term_1 = 1.0 / attenuation_beta
    term_2 = 1.0 / attenuation_epsilon
    attenuation_predicted_beta_squared = attenuation_predicted_beta**2
    attenuation_predicted_epsilon_squared = attenuation_predicted_epsilon**2
    shortfall_predicted_beta_squared = shortfall_predicted_beta**2
    shortfall_predicted_epsilon_squared = shortfall_predicted_epsilon**2
    product_1 = 108.0 * attenuation_beta * attenuation_epsilon * attenuation_predicted_beta_squared * attenuation_predicted_epsilon_squared * shortfall_beta * shortfall_epsilon * shortfall_predicted_beta_squared * shortfall_predicted_epsilon_squared
    attenuation_epsilon_squared = attenuation_epsilon**2
    attenuation_predicted_epsilon_squared_squared = attenuation_predicted_epsilon_squared**2
    product_2 = 12.0 * attenuation_beta * attenuation_epsilon_squared * attenuation_predicted_beta_squared * attenuation_predicted_epsilon_squared_squared * shortfall_beta * shortfall_predicted_beta_squared
    attenuation_predicted_beta_squared_squared = attenuation_predicted_beta_squared**2
    product_3 = 12.0 * attenuation_beta * attenuation_epsilon_squared * attenuation_predicted_beta_squared_squared * attenuation_predicted_epsilon_squared * shortfall_beta * shortfall_predicted_epsilon_squared
    product_4 = 12.0 * attenuation_beta * attenuation_epsilon * attenuation_predicted_beta_squared * attenuation_predicted_epsilon_squared_squared * shortfall_beta * shortfall_epsilon * shortfall_predicted_beta_squared
    product_5 = attenuation_predicted_beta * attenuation_predicted_beta_squared
    shortfall_predicted_epsilon_squared_squared = shortfall_predicted_epsilon_squared**2
    product_6 = 12.0 * attenuation_beta * attenuation_epsilon * product_5 * shortfall_beta * shortfall_epsilon * shortfall_predicted_beta * shortfall_predicted_epsilon_squared_squared
    product_7 = shortfall_predicted_beta * shortfall_predicted_beta_squared
    product_8 = 12.0 * attenuation_beta * attenuation_epsilon * attenuation_predicted_beta * product_7 * shortfall_beta * shortfall_epsilon * shortfall_predicted_epsilon_squared_squared
    product_9 = attenuation_predicted_epsilon * attenuation_predicted_epsilon_squared
    shortfall_predicted_beta_squared_squared = shortfall_predicted_beta_squared**2
    product_10 = 12.0 * attenuation_beta * attenuation_epsilon * product_9 * shortfall_beta * shortfall_epsilon * shortfall_predicted_beta_squared_squared * shortfall_predicted_epsilon
    product_11 = shortfall_predicted_epsilon * shortfall_predicted_epsilon_squared
    product_12 = 12.0 * attenuation_beta * attenuation_epsilon * attenuation_predicted_epsilon * product_11 * shortfall_beta * shortfall_epsilon * shortfall_predicted_beta_squared_squared
    shortfall_epsilon_squared = shortfall_epsilon**2
    product_13 = 12.0 * attenuation_beta * attenuation_predicted_beta_squared * attenuation_predicted_epsilon_squared_squared * shortfall_beta * shortfall_epsilon_squared * shortfall_predicted_beta_squared
    product_14 = 12.0 * attenuation_beta * attenuation_predicted_beta_squared * shortfall_beta * shortfall_epsilon_squared * shortfall_predicted_beta_squared * shortfall_predicted_epsilon_squared_squared
    product_15 = 12.0 * attenuation_beta * attenuation_predicted_beta_squared_squared * attenuation_predicted_epsilon_squared * shortfall_beta * shortfall_epsilon_squared * shortfall_predicted_epsilon_squared
    product_16 = 12.0 * attenuation_beta * attenuation_predicted_epsilon_squared * shortfall_beta * shortfall_epsilon_squared * shortfall_predicted_beta_squared_squared * shortfall_predicted_epsilon_squared
    shortfall_beta_squared = shortfall_beta**2
    product_17 = 12.0 * attenuation_epsilon_squared * attenuation_predicted_beta_squared * attenuation_predicted_epsilon_squared_squared * shortfall_beta_squared * shortfall_predicted_beta_squared
    product_18 = 12.0 * attenuation_epsilon * attenuation_predicted_beta_squared * attenuation_predicted_epsilon_squared_squared * shortfall_beta_squared * shortfall_epsilon * shortfall_predicted_beta_squared
    product_19 = 12.0 * attenuation_epsilon * attenuation_predicted_beta_squared * shortfall_beta_squared * shortfall_epsilon * shortfall_predicted_beta_squared * shortfall_predicted_epsilon_squared_squared
    product_20 = 12.0 * attenuation_epsilon * attenuation_predicted_beta_squared_squared * attenuation_predicted_epsilon_squared * shortfall_beta_squared * shortfall_epsilon * shortfall_predicted_epsilon_squared
    product_21 = 12.0 * attenuation_epsilon * attenuation_predicted_epsilon_squared * shortfall_beta_squared * shortfall_epsilon * shortfall_predicted_beta_squared_squared * shortfall_predicted_epsilon_squared
    attenuation_beta_squared = attenuation_beta**2
    product_22 = 16.0 * attenuation_beta_squared * attenuation_epsilon * product_5 * product_9 * shortfall_epsilon * shortfall_predicted_beta * shortfall_predicted_epsilon
    product_23 = 16.0 * attenuation_beta_squared * attenuation_epsilon * attenuation_predicted_epsilon * product_11 * product_5 * shortfall_epsilon * shortfall_predicted_beta
    product_24 = 16.0 * attenuation_beta_squared * attenuation_epsilon * attenuation_predicted_beta * product_7 * product_9 * shortfall_epsilon * shortfall_predicted_epsilon
    product_25 = 16.0 * attenuation_beta_squared * attenuation_epsilon * attenuation_predicted_beta * attenuation_predicted_epsilon * product_11 * product_7 * shortfall_epsilon
    product_26 = 16.0 * attenuation_beta_squared * product_5 * product_9 * shortfall_epsilon_squared * shortfall_predicted_beta * shortfall_predicted_epsilon
    product_27 = 16.0 * attenuation_beta_squared * attenuation_predicted_epsilon * product_11 * product_5 * shortfall_epsilon_squared * shortfall_predicted_beta
    product_28 = 16.0 * attenuation_beta_squared * attenuation_predicted_beta * product_7 * product_9 * shortfall_epsilon_squared * shortfall_predicted_epsilon
    product_29 = 16.0 * attenuation_beta_squared * attenuation_predicted_beta * attenuation_predicted_epsilon * product_11 * product_7 * shortfall_epsilon_squared
    product_30 = 16.0 * attenuation_beta * attenuation_epsilon_squared * product_5 * product_9 * shortfall_beta * shortfall_predicted_beta * shortfall_predicted_epsilon
    product_31 = 16.0 * attenuation_beta * attenuation_epsilon_squared * attenuation_predicted_epsilon * product_11 * product_5 * shortfall_beta * shortfall_predicted_beta
    product_32 = 16.0 * attenuation_beta * attenuation_epsilon_squared * attenuation_predicted_beta * product_7 * product_9 * shortfall_beta * shortfall_predicted_epsilon
    product_33 = 16.0 * attenuation_beta * attenuation_epsilon_squared * attenuation_predicted_beta * attenuation_predicted_epsilon * product_11 * product_7 * shortfall_beta
    product_34 = 16.0 * attenuation_beta * attenuation_epsilon * attenuation_predicted_beta_squared_squared * product_9 * shortfall_beta * shortfall_epsilon * shortfall_predicted_epsilon
    product_35 = 16.0 * attenuation_beta * attenuation_epsilon * attenuation_predicted_beta_squared_squared * attenuation_predicted_epsilon * product_11 * shortfall_beta * shortfall_epsilon
    product_36 = 16.0 * attenuation_epsilon_squared * product_5 * product_9 * shortfall_beta_squared * shortfall_predicted_beta * shortfall_predicted_epsilon
    product_37 = 16.0 * attenuation_epsilon_squared * attenuation_predicted_epsilon * product_11 * product_5 * shortfall_beta_squared * shortfall_predicted_beta
    product_38 = 16.0 * attenuation_epsilon_squared * attenuation_predicted_beta * product_7 * product_9 * shortfall_beta_squared * shortfall_predicted_epsilon
    product_39 = 16.0 * attenuation_epsilon_squared * attenuation_predicted_beta * attenuation_predicted_epsilon * product_11 * product_7 * shortfall_beta_squared
    product_40 = 16.0 * product_5 * product_9 * shortfall_beta_squared * shortfall_epsilon_squared * shortfall_predicted_beta * shortfall_predicted_epsilon
    product_41 = 16.0 * attenuation_predicted_epsilon * product_11 * product_5 * shortfall_beta_squared * shortfall_epsilon_squared * shortfall_predicted_beta
    product_42 = 16.0 * attenuation_predicted_beta * product_7 * product_9 * shortfall_beta_squared * shortfall_epsilon_squared * shortfall_predicted_epsilon
    product_43 = 16.0 * attenuation_predicted_beta * attenuation_predicted_epsilon * product_11 * product_7 * shortfall_beta_squared * shortfall_epsilon_squared
    product_44 = 18.0 * attenuation_beta * attenuation_epsilon * attenuation_predicted_beta_squared * shortfall_beta * shortfall_epsilon * shortfall_predicted_beta_squared * shortfall_predicted_epsilon_squared_squared
    product_45 = 18.0 * attenuation_beta * attenuation_epsilon * attenuation_predicted_epsilon_squared * shortfall_beta * shortfall_epsilon * shortfall_predicted_beta_squared_squared * shortfall_predicted_epsilon_squared
    product_46 = 2.0 * attenuation_beta * attenuation_epsilon_squared * attenuation_predicted_beta_squared_squared * shortfall_beta * shortfall_predicted_epsilon_squared_squared
    product_47 = 2.0 * attenuation_beta * attenuation_epsilon_squared * attenuation_predicted_epsilon_squared_squared * shortfall_beta * shortfall_predicted_beta_squared_squared
    product_48 = 2.0 * attenuation_beta * attenuation_epsilon * attenuation_predicted_epsilon_squared_squared * shortfall_beta * shortfall_epsilon * shortfall_predicted_beta_squared_squared
    product_49 = 2.0 * attenuation_beta * attenuation_predicted_beta_squared_squared * attenuation_predicted_epsilon_squared_squared * shortfall_beta * shortfall_epsilon_squared
    product_50 = 2.0 * attenuation_beta * attenuation_predicted_beta_squared_squared * shortfall_beta * shortfall_epsilon_squared * shortfall_predicted_epsilon_squared_squared
    product_51 = 2.0 * attenuation_beta * attenuation_predicted_epsilon_squared_squared * shortfall_beta * shortfall_epsilon_squared * shortfall_predicted_beta_squared_squared
    product_52 = 2.0 * attenuation_beta * shortfall_beta * shortfall_epsilon_squared * shortfall_predicted_beta_squared_squared * shortfall_predicted_epsilon_squared_squared
    product_53 = 2.0 * attenuation_epsilon_squared * attenuation_predicted_beta_squared_squared * attenuation_predicted_epsilon_squared_squared * shortfall_beta_squared
    product_54 = 2.0 * attenuation_epsilon_squared * attenuation_predicted_epsilon_squared_squared * shortfall_beta_squared * shortfall_predicted_beta_squared_squared
    product_55 = 2.0 * attenuation_epsilon * attenuation_predicted_beta_squared_squared * attenuation_predicted_epsilon_squared_squared * shortfall_beta_squared * shortfall_epsilon
    product_56 = 2.0 * attenuation_epsilon * attenuation_predicted_beta_squared_squared * shortfall_beta_squared * shortfall_epsilon * shortfall_predicted_epsilon_squared_squared
    product_57 = 2.0 * attenuation_epsilon * attenuation_predicted_epsilon_squared_squared * shortfall_beta_squared * shortfall_epsilon * shortfall_predicted_beta_squared_squared
    product_58 = 2.0 * attenuation_epsilon * shortfall_beta_squared * shortfall_epsilon * shortfall_predicted_beta_squared_squared * shortfall_predicted_epsilon_squared_squared
    product_59 = 24.0 * attenuation_beta_squared * attenuation_epsilon * attenuation_predicted_beta_squared * product_9 * shortfall_epsilon * shortfall_predicted_beta_squared * shortfall_predicted_epsilon
    product_60 = 24.0 * attenuation_beta_squared * attenuation_epsilon * attenuation_predicted_beta_squared * attenuation_predicted_epsilon * product_11 * shortfall_epsilon * shortfall_predicted_beta_squared
    product_61 = 24.0 * attenuation_beta_squared * attenuation_epsilon * attenuation_predicted_epsilon_squared * product_5 * shortfall_epsilon * shortfall_predicted_beta * shortfall_predicted_epsilon_squared
    product_62 = 24.0 * attenuation_beta_squared * attenuation_epsilon * attenuation_predicted_beta * attenuation_predicted_epsilon_squared * product_7 * shortfall_epsilon * shortfall_predicted_epsilon_squared
    product_63 = 24.0 * attenuation_beta_squared * attenuation_predicted_beta_squared * product_9 * shortfall_epsilon_squared * shortfall_predicted_beta_squared * shortfall_predicted_epsilon
    product_64 = 24.0 * attenuation_beta_squared * attenuation_predicted_beta_squared * attenuation_predicted_epsilon * product_11 * shortfall_epsilon_squared * shortfall_predicted_beta_squared
    product_65 = 24.0 * attenuation_beta_squared * attenuation_predicted_epsilon_squared * product_5 * shortfall_epsilon_squared * shortfall_predicted_beta * shortfall_predicted_epsilon_squared
    product_66 = 24.0 * attenuation_beta_squared * attenuation_predicted_beta * attenuation_predicted_epsilon_squared * product_7 * shortfall_epsilon_squared * shortfall_predicted_epsilon_squared
    product_67 = 24.0 * attenuation_beta * attenuation_epsilon_squared * attenuation_predicted_beta_squared * product_9 * shortfall_beta * shortfall_predicted_beta_squared * shortfall_predicted_epsilon
    product_68 = 24.0 * attenuation_beta * attenuation_epsilon_squared * attenuation_predicted_beta_squared * attenuation_predicted_epsilon * product_11 * shortfall_beta * shortfall_predicted_beta_squared
    product_69 = 24.0 * attenuation_beta * attenuation_epsilon_squared * attenuation_predicted_epsilon_squared * product_5 * shortfall_beta * shortfall_predicted_beta * shortfall_predicted_epsilon_squared
    product_70 = 24.0 * attenuation_beta * attenuation_epsilon_squared * attenuation_predicted_beta * attenuation_predicted_epsilon_squared * product_7 * shortfall_beta * shortfall_predicted_epsilon_squared
    product_71 = 24.0 * attenuation_beta * attenuation_epsilon * attenuation_predicted_beta_squared_squared * attenuation_predicted_epsilon_squared * shortfall_beta * shortfall_epsilon * shortfall_predicted_epsilon_squared
    product_72 = 24.0 * attenuation_epsilon_squared * attenuation_predicted_beta_squared * product_9 * shortfall_beta_squared * shortfall_predicted_beta_squared * shortfall_predicted_epsilon
    product_73 = 24.0 * attenuation_epsilon_squared * attenuation_predicted_beta_squared * attenuation_predicted_epsilon * product_11 * shortfall_beta_squared * shortfall_predicted_beta_squared
    product_74 = 24.0 * attenuation_epsilon_squared * attenuation_predicted_epsilon_squared * product_5 * shortfall_beta_squared * shortfall_predicted_beta * shortfall_predicted_epsilon_squared
    product_75 = 24.0 * attenuation_epsilon_squared * attenuation_predicted_beta * attenuation_predicted_epsilon_squared * product_7 * shortfall_beta_squared * shortfall_predicted_epsilon_squared
    product_76 = 24.0 * attenuation_predicted_beta_squared * product_9 * shortfall_beta_squared * shortfall_epsilon_squared * shortfall_predicted_beta_squared * shortfall_predicted_epsilon
    product_77 = 24.0 * attenuation_predicted_beta_squared * attenuation_predicted_epsilon * product_11 * shortfall_beta_squared * shortfall_epsilon_squared * shortfall_predicted_beta_squared
    product_78 = 24.0 * attenuation_predicted_epsilon_squared * product_5 * shortfall_beta_squared * shortfall_epsilon_squared * shortfall_predicted_beta * shortfall_predicted_epsilon_squared
    product_79 = 24.0 * attenuation_predicted_beta * attenuation_predicted_epsilon_squared * product_7 * shortfall_beta_squared * shortfall_epsilon_squared * shortfall_predicted_epsilon_squared
    product_80 = 3.0 * attenuation_beta * attenuation_epsilon * shortfall_beta * shortfall_epsilon * shortfall_predicted_beta_squared_squared * shortfall_predicted_epsilon_squared_squared
    product_81 = 32.0 * attenuation_beta * product_5 * product_9 * shortfall_beta * shortfall_epsilon_squared * shortfall_predicted_beta * shortfall_predicted_epsilon
    product_82 = 32.0 * attenuation_beta * attenuation_predicted_epsilon * product_11 * product_5 * shortfall_beta * shortfall_epsilon_squared * shortfall_predicted_beta
    product_83 = 32.0 * attenuation_beta * attenuation_predicted_beta * product_7 * product_9 * shortfall_beta * shortfall_epsilon_squared * shortfall_predicted_epsilon
    product_84 = 32.0 * attenuation_beta * attenuation_predicted_beta * attenuation_predicted_epsilon * product_11 * product_7 * shortfall_beta * shortfall_epsilon_squared
    product_85 = 32.0 * attenuation_epsilon * product_5 * product_9 * shortfall_beta_squared * shortfall_epsilon * shortfall_predicted_beta * shortfall_predicted_epsilon
    product_86 = 32.0 * attenuation_epsilon * attenuation_predicted_epsilon * product_11 * product_5 * shortfall_beta_squared * shortfall_epsilon * shortfall_predicted_beta
    product_87 = 32.0 * attenuation_epsilon * attenuation_predicted_beta * product_7 * product_9 * shortfall_beta_squared * shortfall_epsilon * shortfall_predicted_epsilon
    product_88 = 32.0 * attenuation_epsilon * attenuation_predicted_beta * attenuation_predicted_epsilon * product_11 * product_7 * shortfall_beta_squared * shortfall_epsilon
    product_89 = 36.0 * attenuation_beta_squared * attenuation_epsilon * attenuation_predicted_beta_squared * attenuation_predicted_epsilon_squared * shortfall_epsilon * shortfall_predicted_beta_squared * shortfall_predicted_epsilon_squared
    product_90 = 36.0 * attenuation_beta_squared * attenuation_predicted_beta_squared * attenuation_predicted_epsilon_squared * shortfall_epsilon_squared * shortfall_predicted_beta_squared * shortfall_predicted_epsilon_squared
    product_91 = 36.0 * attenuation_beta * attenuation_epsilon_squared * attenuation_predicted_beta_squared * attenuation_predicted_epsilon_squared * shortfall_beta * shortfall_predicted_beta_squared * shortfall_predicted_epsilon_squared
    product_92 = 36.0 * attenuation_epsilon_squared * attenuation_predicted_beta_squared * attenuation_predicted_epsilon_squared * shortfall_beta_squared * shortfall_predicted_beta_squared * shortfall_predicted_epsilon_squared
    product_93 = 36.0 * attenuation_predicted_beta_squared * attenuation_predicted_epsilon_squared * shortfall_beta_squared * shortfall_epsilon_squared * shortfall_predicted_beta_squared * shortfall_predicted_epsilon_squared
    product_94 = 4.0 * attenuation_beta_squared * attenuation_epsilon * product_5 * shortfall_epsilon * shortfall_predicted_beta * shortfall_predicted_epsilon_squared_squared
    product_95 = 4.0 * attenuation_beta_squared * attenuation_epsilon * attenuation_predicted_beta * product_7 * shortfall_epsilon * shortfall_predicted_epsilon_squared_squared
    product_96 = 4.0 * attenuation_beta_squared * attenuation_epsilon * product_9 * shortfall_epsilon * shortfall_predicted_beta_squared_squared * shortfall_predicted_epsilon
    product_97 = 4.0 * attenuation_beta_squared * attenuation_epsilon * attenuation_predicted_epsilon * product_11 * shortfall_epsilon * shortfall_predicted_beta_squared_squared
    product_98 = 4.0 * attenuation_beta_squared * attenuation_predicted_epsilon_squared_squared * product_5 * shortfall_epsilon_squared * shortfall_predicted_beta
    product_99 = 4.0 * attenuation_beta_squared * product_5 * shortfall_epsilon_squared * shortfall_predicted_beta * shortfall_predicted_epsilon_squared_squared
    product_100 = 4.0 * attenuation_beta_squared * attenuation_predicted_beta * attenuation_predicted_epsilon_squared_squared * product_7 * shortfall_epsilon_squared
    product_101 = 4.0 * attenuation_beta_squared * attenuation_predicted_beta * product_7 * shortfall_epsilon_squared * shortfall_predicted_epsilon_squared_squared
    product_102 = 4.0 * attenuation_beta_squared * product_9 * shortfall_epsilon_squared * shortfall_predicted_beta_squared_squared * shortfall_predicted_epsilon
    product_103 = 4.0 * attenuation_beta_squared * attenuation_predicted_epsilon * product_11 * shortfall_epsilon_squared * shortfall_predicted_beta_squared_squared
    product_104 = 4.0 * attenuation_beta * attenuation_epsilon_squared * product_5 * shortfall_beta * shortfall_predicted_beta * shortfall_predicted_epsilon_squared_squared
    product_105 = 4.0 * attenuation_beta * attenuation_epsilon_squared * attenuation_predicted_beta_squared_squared * attenuation_predicted_epsilon_squared_squared * shortfall_beta
    product_106 = 4.0 * attenuation_beta * attenuation_epsilon_squared * attenuation_predicted_beta * product_7 * shortfall_beta * shortfall_predicted_epsilon_squared_squared
    product_107 = 4.0 * attenuation_beta * attenuation_epsilon_squared * product_9 * shortfall_beta * shortfall_predicted_beta_squared_squared * shortfall_predicted_epsilon
    product_108 = 4.0 * attenuation_beta * attenuation_epsilon_squared * attenuation_predicted_epsilon * product_11 * shortfall_beta * shortfall_predicted_beta_squared_squared
    product_109 = 4.0 * attenuation_beta * attenuation_epsilon * attenuation_predicted_beta_squared_squared * attenuation_predicted_epsilon_squared_squared * shortfall_beta * shortfall_epsilon
    product_110 = 4.0 * attenuation_beta * attenuation_epsilon * attenuation_predicted_beta_squared_squared * shortfall_beta * shortfall_epsilon * shortfall_predicted_epsilon_squared_squared
    product_111 = 4.0 * attenuation_epsilon_squared * product_5 * shortfall_beta_squared * shortfall_predicted_beta * shortfall_predicted_epsilon_squared_squared
    product_112 = 4.0 * attenuation_epsilon_squared * attenuation_predicted_beta_squared_squared * product_9 * shortfall_beta_squared * shortfall_predicted_epsilon
    product_113 = 4.0 * attenuation_epsilon_squared * attenuation_predicted_beta_squared_squared * attenuation_predicted_epsilon * product_11 * shortfall_beta_squared
    product_114 = 4.0 * attenuation_epsilon_squared * attenuation_predicted_beta * product_7 * shortfall_beta_squared * shortfall_predicted_epsilon_squared_squared
    product_115 = 4.0 * attenuation_epsilon_squared * product_9 * shortfall_beta_squared * shortfall_predicted_beta_squared_squared * shortfall_predicted_epsilon
    product_116 = 4.0 * attenuation_epsilon_squared * attenuation_predicted_epsilon * product_11 * shortfall_beta_squared * shortfall_predicted_beta_squared_squared
    product_117 = 4.0 * attenuation_predicted_epsilon_squared_squared * product_5 * shortfall_beta_squared * shortfall_epsilon_squared * shortfall_predicted_beta
    product_118 = 4.0 * product_5 * shortfall_beta_squared * shortfall_epsilon_squared * shortfall_predicted_beta * shortfall_predicted_epsilon_squared_squared
    product_119 = 4.0 * attenuation_predicted_beta_squared_squared * product_9 * shortfall_beta_squared * shortfall_epsilon_squared * shortfall_predicted_epsilon
    product_120 = 4.0 * attenuation_predicted_beta_squared_squared * attenuation_predicted_epsilon * product_11 * shortfall_beta_squared * shortfall_epsilon_squared
    product_121 = 4.0 * attenuation_predicted_beta * attenuation_predicted_epsilon_squared_squared * product_7 * shortfall_beta_squared * shortfall_epsilon_squared
    product_122 = 4.0 * attenuation_predicted_beta * product_7 * shortfall_beta_squared * shortfall_epsilon_squared * shortfall_predicted_epsilon_squared_squared
    product_123 = 4.0 * product_9 * shortfall_beta_squared * shortfall_epsilon_squared * shortfall_predicted_beta_squared_squared * shortfall_predicted_epsilon
    product_124 = 4.0 * attenuation_predicted_epsilon * product_11 * shortfall_beta_squared * shortfall_epsilon_squared * shortfall_predicted_beta_squared_squared
    product_125 = 48.0 * attenuation_beta * attenuation_epsilon * product_5 * product_9 * shortfall_beta * shortfall_epsilon * shortfall_predicted_beta * shortfall_predicted_epsilon
    product_126 = 48.0 * attenuation_beta * attenuation_epsilon * attenuation_predicted_epsilon * product_11 * product_5 * shortfall_beta * shortfall_epsilon * shortfall_predicted_beta
    product_127 = 48.0 * attenuation_beta * attenuation_epsilon * attenuation_predicted_beta * product_7 * product_9 * shortfall_beta * shortfall_epsilon * shortfall_predicted_epsilon
    product_128 = 48.0 * attenuation_beta * attenuation_epsilon * attenuation_predicted_beta * attenuation_predicted_epsilon * product_11 * product_7 * shortfall_beta * shortfall_epsilon
    product_129 = 48.0 * attenuation_beta * attenuation_predicted_beta_squared * product_9 * shortfall_beta * shortfall_epsilon_squared * shortfall_predicted_beta_squared * shortfall_predicted_epsilon
    product_130 = 48.0 * attenuation_beta * attenuation_predicted_beta_squared * attenuation_predicted_epsilon * product_11 * shortfall_beta * shortfall_epsilon_squared * shortfall_predicted_beta_squared
    product_131 = 48.0 * attenuation_beta * attenuation_predicted_epsilon_squared * product_5 * shortfall_beta * shortfall_epsilon_squared * shortfall_predicted_beta * shortfall_predicted_epsilon_squared
    product_132 = 48.0 * attenuation_beta * attenuation_predicted_beta * attenuation_predicted_epsilon_squared * product_7 * shortfall_beta * shortfall_epsilon_squared * shortfall_predicted_epsilon_squared
    product_133 = 48.0 * attenuation_epsilon * attenuation_predicted_beta_squared * product_9 * shortfall_beta_squared * shortfall_epsilon * shortfall_predicted_beta_squared * shortfall_predicted_epsilon
    product_134 = 48.0 * attenuation_epsilon * attenuation_predicted_beta_squared * attenuation_predicted_epsilon * product_11 * shortfall_beta_squared * shortfall_epsilon * shortfall_predicted_beta_squared
    product_135 = 48.0 * attenuation_epsilon * attenuation_predicted_epsilon_squared * product_5 * shortfall_beta_squared * shortfall_epsilon * shortfall_predicted_beta * shortfall_predicted_epsilon_squared
    product_136 = 48.0 * attenuation_epsilon * attenuation_predicted_beta * attenuation_predicted_epsilon_squared * product_7 * shortfall_beta_squared * shortfall_epsilon * shortfall_predicted_epsilon_squared
    product_137 = 6.0 * attenuation_beta_squared * attenuation_epsilon * attenuation_predicted_beta_squared * shortfall_epsilon * shortfall_predicted_beta_squared * shortfall_predicted_epsilon_squared_squared
    product_138 = 6.0 * attenuation_beta_squared * attenuation_epsilon * attenuation_predicted_epsilon_squared * shortfall_epsilon * shortfall_predicted_beta_squared_squared * shortfall_predicted_epsilon_squared
    product_139 = 6.0 * attenuation_beta_squared * attenuation_predicted_beta_squared * attenuation_predicted_epsilon_squared_squared * shortfall_epsilon_squared * shortfall_predicted_beta_squared
    product_140 = 6.0 * attenuation_beta_squared * attenuation_predicted_beta_squared * shortfall_epsilon_squared * shortfall_predicted_beta_squared * shortfall_predicted_epsilon_squared_squared
    product_141 = 6.0 * attenuation_beta_squared * attenuation_predicted_epsilon_squared * shortfall_epsilon_squared * shortfall_predicted_beta_squared_squared * shortfall_predicted_epsilon_squared
    product_142 = 6.0 * attenuation_beta * attenuation_epsilon_squared * attenuation_predicted_beta_squared * shortfall_beta * shortfall_predicted_beta_squared * shortfall_predicted_epsilon_squared_squared
    product_143 = 6.0 * attenuation_beta * attenuation_epsilon_squared * attenuation_predicted_epsilon_squared * shortfall_beta * shortfall_predicted_beta_squared_squared * shortfall_predicted_epsilon_squared
    product_144 = 6.0 * attenuation_epsilon_squared * attenuation_predicted_beta_squared * shortfall_beta_squared * shortfall_predicted_beta_squared * shortfall_predicted_epsilon_squared_squared
    product_145 = 6.0 * attenuation_epsilon_squared * attenuation_predicted_beta_squared_squared * attenuation_predicted_epsilon_squared * shortfall_beta_squared * shortfall_predicted_epsilon_squared
    product_146 = 6.0 * attenuation_epsilon_squared * attenuation_predicted_epsilon_squared * shortfall_beta_squared * shortfall_predicted_beta_squared_squared * shortfall_predicted_epsilon_squared
    product_147 = 6.0 * attenuation_predicted_beta_squared * attenuation_predicted_epsilon_squared_squared * shortfall_beta_squared * shortfall_epsilon_squared * shortfall_predicted_beta_squared
    product_148 = 6.0 * attenuation_predicted_beta_squared * shortfall_beta_squared * shortfall_epsilon_squared * shortfall_predicted_beta_squared * shortfall_predicted_epsilon_squared_squared
    product_149 = 6.0 * attenuation_predicted_beta_squared_squared * attenuation_predicted_epsilon_squared * shortfall_beta_squared * shortfall_epsilon_squared * shortfall_predicted_epsilon_squared
    product_150 = 6.0 * attenuation_predicted_epsilon_squared * shortfall_beta_squared * shortfall_epsilon_squared * shortfall_predicted_beta_squared_squared * shortfall_predicted_epsilon_squared
    product_151 = 72.0 * attenuation_beta * attenuation_epsilon * attenuation_predicted_beta_squared * product_9 * shortfall_beta * shortfall_epsilon * shortfall_predicted_beta_squared * shortfall_predicted_epsilon
    product_152 = 72.0 * attenuation_beta * attenuation_epsilon * attenuation_predicted_beta_squared * attenuation_predicted_epsilon * product_11 * shortfall_beta * shortfall_epsilon * shortfall_predicted_beta_squared
    product_153 = 72.0 * attenuation_beta * attenuation_epsilon * attenuation_predicted_epsilon_squared * product_5 * shortfall_beta * shortfall_epsilon * shortfall_predicted_beta * shortfall_predicted_epsilon_squared
    product_154 = 72.0 * attenuation_beta * attenuation_epsilon * attenuation_predicted_beta * attenuation_predicted_epsilon_squared * product_7 * shortfall_beta * shortfall_epsilon * shortfall_predicted_epsilon_squared
    product_155 = 72.0 * attenuation_beta * attenuation_predicted_beta_squared * attenuation_predicted_epsilon_squared * shortfall_beta * shortfall_epsilon_squared * shortfall_predicted_beta_squared * shortfall_predicted_epsilon_squared
    product_156 = 72.0 * attenuation_epsilon * attenuation_predicted_beta_squared * attenuation_predicted_epsilon_squared * shortfall_beta_squared * shortfall_epsilon * shortfall_predicted_beta_squared * shortfall_predicted_epsilon_squared
    product_157 = 8.0 * attenuation_beta * attenuation_epsilon_squared * attenuation_predicted_epsilon_squared_squared * product_5 * shortfall_beta * shortfall_predicted_beta
    product_158 = 8.0 * attenuation_beta * attenuation_epsilon_squared * attenuation_predicted_beta_squared_squared * product_9 * shortfall_beta * shortfall_predicted_epsilon
    product_159 = 8.0 * attenuation_beta * attenuation_epsilon_squared * attenuation_predicted_beta_squared_squared * attenuation_predicted_epsilon * product_11 * shortfall_beta
    product_160 = 8.0 * attenuation_beta * attenuation_epsilon_squared * attenuation_predicted_beta * attenuation_predicted_epsilon_squared_squared * product_7 * shortfall_beta
    product_161 = 8.0 * attenuation_beta * attenuation_epsilon * attenuation_predicted_epsilon_squared_squared * product_5 * shortfall_beta * shortfall_epsilon * shortfall_predicted_beta
    product_162 = 8.0 * attenuation_beta * attenuation_epsilon * attenuation_predicted_beta * attenuation_predicted_epsilon_squared_squared * product_7 * shortfall_beta * shortfall_epsilon
    product_163 = 8.0 * attenuation_beta * attenuation_predicted_epsilon_squared_squared * product_5 * shortfall_beta * shortfall_epsilon_squared * shortfall_predicted_beta
    product_164 = 8.0 * attenuation_beta * product_5 * shortfall_beta * shortfall_epsilon_squared * shortfall_predicted_beta * shortfall_predicted_epsilon_squared_squared
    product_165 = 8.0 * attenuation_beta * attenuation_predicted_beta_squared_squared * product_9 * shortfall_beta * shortfall_epsilon_squared * shortfall_predicted_epsilon
    product_166 = 8.0 * attenuation_beta * attenuation_predicted_beta_squared_squared * attenuation_predicted_epsilon * product_11 * shortfall_beta * shortfall_epsilon_squared
    product_167 = 8.0 * attenuation_beta * attenuation_predicted_beta * attenuation_predicted_epsilon_squared_squared * product_7 * shortfall_beta * shortfall_epsilon_squared
    product_168 = 8.0 * attenuation_beta * attenuation_predicted_beta * product_7 * shortfall_beta * shortfall_epsilon_squared * shortfall_predicted_epsilon_squared_squared
    product_169 = 8.0 * attenuation_beta * product_9 * shortfall_beta * shortfall_epsilon_squared * shortfall_predicted_beta_squared_squared * shortfall_predicted_epsilon
    product_170 = 8.0 * attenuation_beta * attenuation_predicted_epsilon * product_11 * shortfall_beta * shortfall_epsilon_squared * shortfall_predicted_beta_squared_squared
    product_171 = 8.0 * attenuation_epsilon_squared * attenuation_predicted_epsilon_squared_squared * product_5 * shortfall_beta_squared * shortfall_predicted_beta
    product_172 = 8.0 * attenuation_epsilon_squared * attenuation_predicted_beta * attenuation_predicted_epsilon_squared_squared * product_7 * shortfall_beta_squared
    product_173 = 8.0 * attenuation_epsilon * attenuation_predicted_epsilon_squared_squared * product_5 * shortfall_beta_squared * shortfall_epsilon * shortfall_predicted_beta
    product_174 = 8.0 * attenuation_epsilon * product_5 * shortfall_beta_squared * shortfall_epsilon * shortfall_predicted_beta * shortfall_predicted_epsilon_squared_squared
    product_175 = 8.0 * attenuation_epsilon * attenuation_predicted_beta_squared_squared * product_9 * shortfall_beta_squared * shortfall_epsilon * shortfall_predicted_epsilon
    product_176 = 8.0 * attenuation_epsilon * attenuation_predicted_beta_squared_squared * attenuation_predicted_epsilon * product_11 * shortfall_beta_squared * shortfall_epsilon
    product_177 = 8.0 * attenuation_epsilon * attenuation_predicted_beta * attenuation_predicted_epsilon_squared_squared * product_7 * shortfall_beta_squared * shortfall_epsilon
    product_178 = 8.0 * attenuation_epsilon * attenuation_predicted_beta * product_7 * shortfall_beta_squared * shortfall_epsilon * shortfall_predicted_epsilon_squared_squared
    product_179 = 8.0 * attenuation_epsilon * product_9 * shortfall_beta_squared * shortfall_epsilon * shortfall_predicted_beta_squared_squared * shortfall_predicted_epsilon
    product_180 = 8.0 * attenuation_epsilon * attenuation_predicted_epsilon * product_11 * shortfall_beta_squared * shortfall_epsilon * shortfall_predicted_beta_squared_squared
    product_181 = attenuation_beta_squared * attenuation_epsilon * shortfall_epsilon * shortfall_predicted_beta_squared_squared * shortfall_predicted_epsilon_squared_squared
    product_182 = attenuation_beta_squared * attenuation_predicted_epsilon_squared_squared * shortfall_epsilon_squared * shortfall_predicted_beta_squared_squared
    product_183 = attenuation_beta_squared * shortfall_epsilon_squared * shortfall_predicted_beta_squared_squared * shortfall_predicted_epsilon_squared_squared
    product_184 = attenuation_beta * attenuation_epsilon_squared * shortfall_beta * shortfall_predicted_beta_squared_squared * shortfall_predicted_epsilon_squared_squared
    product_185 = attenuation_epsilon_squared * attenuation_predicted_beta_squared_squared * shortfall_beta_squared * shortfall_predicted_epsilon_squared_squared
    product_186 = attenuation_epsilon_squared * shortfall_beta_squared * shortfall_predicted_beta_squared_squared * shortfall_predicted_epsilon_squared_squared
    product_187 = attenuation_predicted_beta_squared_squared * attenuation_predicted_epsilon_squared_squared * shortfall_beta_squared * shortfall_epsilon_squared
    product_188 = attenuation_predicted_beta_squared_squared * shortfall_beta_squared * shortfall_epsilon_squared * shortfall_predicted_epsilon_squared_squared
    product_189 = attenuation_predicted_epsilon_squared_squared * shortfall_beta_squared * shortfall_epsilon_squared * shortfall_predicted_beta_squared_squared
    product_190 = shortfall_beta_squared * shortfall_epsilon_squared * shortfall_predicted_beta_squared_squared * shortfall_predicted_epsilon_squared_squared
    sum_1 = (
        product_1
        + product_10
        + product_100
        + product_101
        + product_102
        + product_103
        + product_104
        + product_105
        + product_106
        + product_107
        + product_108
        + product_109
        + product_110
        + product_111
        + product_112
        + product_113
        + product_114
        + product_115
        + product_116
        + product_117
        + product_118
        + product_119
        + product_12
        + product_120
        + product_121
        + product_122
        + product_123
        + product_124
        + product_125
        + product_126
        + product_127
        + product_128
        + product_129
        + product_13
        + product_130
        + product_131
        + product_132
        + product_133
        + product_134
        + product_135
        + product_136
        + product_137
        + product_138
        + product_139
        + product_14
        + product_140
        + product_141
        + product_142
        + product_143
        + product_144
        + product_145
        + product_146
        + product_147
        + product_148
        + product_149
        + product_15
        + product_150
        + product_151
        + product_152
        + product_153
        + product_154
        + product_155
        + product_156
        + product_157
        + product_158
        + product_159
        + product_16
        + product_160
        + product_161
        + product_162
        + product_163
        + product_164
        + product_165
        + product_166
        + product_167
        + product_168
        + product_169
        + product_17
        + product_170
        + product_171
        + product_172
        + product_173
        + product_174
        + product_175
        + product_176
        + product_177
        + product_178
        + product_179
        + product_18
        + product_180
        + product_181
        + product_182
        + product_183
        + product_184
        + product_185
        + product_186
        + product_187
        + product_188
        + product_189
        + product_19
        + product_190
        + product_2
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
        + product_3
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
        + product_4
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
        + product_6
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
    predicted_sigma_r_squared = predicted_sigma_r**2
    r_squared = r**2
    product_191 = 12.0 * attenuation_beta_squared * attenuation_epsilon * attenuation_predicted_beta_squared * attenuation_predicted_epsilon_squared_squared * shortfall_epsilon * shortfall_predicted_beta_squared
    product_192 = 12.0 * attenuation_beta_squared * attenuation_epsilon * attenuation_predicted_beta_squared * shortfall_epsilon * shortfall_predicted_beta_squared * shortfall_predicted_epsilon_squared_squared
    product_193 = 12.0 * attenuation_beta_squared * attenuation_epsilon * attenuation_predicted_epsilon_squared * shortfall_epsilon * shortfall_predicted_beta_squared_squared * shortfall_predicted_epsilon_squared
    product_194 = 12.0 * attenuation_beta * attenuation_epsilon_squared * attenuation_predicted_beta_squared * shortfall_beta * shortfall_predicted_beta_squared * shortfall_predicted_epsilon_squared_squared
    product_195 = 12.0 * attenuation_beta * attenuation_epsilon_squared * attenuation_predicted_epsilon_squared * shortfall_beta * shortfall_predicted_beta_squared_squared * shortfall_predicted_epsilon_squared
    product_196 = 144.0 * attenuation_beta * attenuation_epsilon * attenuation_predicted_beta_squared * attenuation_predicted_epsilon_squared * shortfall_beta * shortfall_epsilon * shortfall_predicted_beta_squared * shortfall_predicted_epsilon_squared
    product_197 = 16.0 * attenuation_beta_squared * attenuation_epsilon_squared * product_5 * product_9 * shortfall_predicted_beta * shortfall_predicted_epsilon
    product_198 = 16.0 * attenuation_beta_squared * attenuation_epsilon_squared * attenuation_predicted_epsilon * product_11 * product_5 * shortfall_predicted_beta
    product_199 = 16.0 * attenuation_beta_squared * attenuation_epsilon_squared * attenuation_predicted_beta * product_7 * product_9 * shortfall_predicted_epsilon
    product_200 = 16.0 * attenuation_beta_squared * attenuation_epsilon_squared * attenuation_predicted_beta * attenuation_predicted_epsilon * product_11 * product_7
    product_201 = 16.0 * attenuation_beta * attenuation_epsilon * attenuation_predicted_epsilon_squared_squared * product_5 * shortfall_beta * shortfall_epsilon * shortfall_predicted_beta
    product_202 = 16.0 * attenuation_beta * attenuation_epsilon * product_5 * shortfall_beta * shortfall_epsilon * shortfall_predicted_beta * shortfall_predicted_epsilon_squared_squared
    product_203 = 16.0 * attenuation_beta * attenuation_epsilon * attenuation_predicted_beta * attenuation_predicted_epsilon_squared_squared * product_7 * shortfall_beta * shortfall_epsilon
    product_204 = 16.0 * attenuation_beta * attenuation_epsilon * attenuation_predicted_beta * product_7 * shortfall_beta * shortfall_epsilon * shortfall_predicted_epsilon_squared_squared
    product_205 = 16.0 * attenuation_beta * attenuation_epsilon * product_9 * shortfall_beta * shortfall_epsilon * shortfall_predicted_beta_squared_squared * shortfall_predicted_epsilon
    product_206 = 16.0 * attenuation_beta * attenuation_epsilon * attenuation_predicted_epsilon * product_11 * shortfall_beta * shortfall_epsilon * shortfall_predicted_beta_squared_squared
    product_207 = 2.0 * attenuation_beta_squared * attenuation_epsilon * attenuation_predicted_epsilon_squared_squared * shortfall_epsilon * shortfall_predicted_beta_squared_squared
    product_208 = 2.0 * attenuation_beta_squared * attenuation_epsilon * shortfall_epsilon * shortfall_predicted_beta_squared_squared * shortfall_predicted_epsilon_squared_squared
    product_209 = 2.0 * attenuation_beta * attenuation_epsilon_squared * shortfall_beta * shortfall_predicted_beta_squared_squared * shortfall_predicted_epsilon_squared_squared
    product_210 = 24.0 * attenuation_beta_squared * attenuation_epsilon_squared * attenuation_predicted_beta_squared * product_9 * shortfall_predicted_beta_squared * shortfall_predicted_epsilon
    product_211 = 24.0 * attenuation_beta_squared * attenuation_epsilon_squared * attenuation_predicted_beta_squared * attenuation_predicted_epsilon * product_11 * shortfall_predicted_beta_squared
    product_212 = 24.0 * attenuation_beta_squared * attenuation_epsilon_squared * attenuation_predicted_epsilon_squared * product_5 * shortfall_predicted_beta * shortfall_predicted_epsilon_squared
    product_213 = 24.0 * attenuation_beta_squared * attenuation_epsilon_squared * attenuation_predicted_beta * attenuation_predicted_epsilon_squared * product_7 * shortfall_predicted_epsilon_squared
    product_214 = 24.0 * attenuation_beta * attenuation_epsilon * attenuation_predicted_beta_squared * attenuation_predicted_epsilon_squared_squared * shortfall_beta * shortfall_epsilon * shortfall_predicted_beta_squared
    product_215 = 24.0 * attenuation_beta * attenuation_epsilon * attenuation_predicted_beta_squared * shortfall_beta * shortfall_epsilon * shortfall_predicted_beta_squared * shortfall_predicted_epsilon_squared_squared
    product_216 = 24.0 * attenuation_beta * attenuation_epsilon * attenuation_predicted_epsilon_squared * shortfall_beta * shortfall_epsilon * shortfall_predicted_beta_squared_squared * shortfall_predicted_epsilon_squared
    product_217 = 32.0 * attenuation_beta_squared * attenuation_epsilon * product_5 * product_9 * shortfall_epsilon * shortfall_predicted_beta * shortfall_predicted_epsilon
    product_218 = 32.0 * attenuation_beta_squared * attenuation_epsilon * attenuation_predicted_epsilon * product_11 * product_5 * shortfall_epsilon * shortfall_predicted_beta
    product_219 = 32.0 * attenuation_beta_squared * attenuation_epsilon * attenuation_predicted_beta * product_7 * product_9 * shortfall_epsilon * shortfall_predicted_epsilon
    product_220 = 32.0 * attenuation_beta_squared * attenuation_epsilon * attenuation_predicted_beta * attenuation_predicted_epsilon * product_11 * product_7 * shortfall_epsilon
    product_221 = 32.0 * attenuation_beta * attenuation_epsilon_squared * product_5 * product_9 * shortfall_beta * shortfall_predicted_beta * shortfall_predicted_epsilon
    product_222 = 32.0 * attenuation_beta * attenuation_epsilon_squared * attenuation_predicted_epsilon * product_11 * product_5 * shortfall_beta * shortfall_predicted_beta
    product_223 = 32.0 * attenuation_beta * attenuation_epsilon_squared * attenuation_predicted_beta * product_7 * product_9 * shortfall_beta * shortfall_predicted_epsilon
    product_224 = 32.0 * attenuation_beta * attenuation_epsilon_squared * attenuation_predicted_beta * attenuation_predicted_epsilon * product_11 * product_7 * shortfall_beta
    product_225 = 36.0 * attenuation_beta_squared * attenuation_epsilon_squared * attenuation_predicted_beta_squared * attenuation_predicted_epsilon_squared * shortfall_predicted_beta_squared * shortfall_predicted_epsilon_squared
    product_226 = 4.0 * attenuation_beta_squared * attenuation_epsilon_squared * product_5 * shortfall_predicted_beta * shortfall_predicted_epsilon_squared_squared
    product_227 = 4.0 * attenuation_beta_squared * attenuation_epsilon_squared * attenuation_predicted_beta * product_7 * shortfall_predicted_epsilon_squared_squared
    product_228 = 4.0 * attenuation_beta_squared * attenuation_epsilon_squared * product_9 * shortfall_predicted_beta_squared_squared * shortfall_predicted_epsilon
    product_229 = 4.0 * attenuation_beta_squared * attenuation_epsilon_squared * attenuation_predicted_epsilon * product_11 * shortfall_predicted_beta_squared_squared
    product_230 = 4.0 * attenuation_beta * attenuation_epsilon * attenuation_predicted_epsilon_squared_squared * shortfall_beta * shortfall_epsilon * shortfall_predicted_beta_squared_squared
    product_231 = 4.0 * attenuation_beta * attenuation_epsilon * shortfall_beta * shortfall_epsilon * shortfall_predicted_beta_squared_squared * shortfall_predicted_epsilon_squared_squared
    product_232 = 48.0 * attenuation_beta_squared * attenuation_epsilon * attenuation_predicted_beta_squared * product_9 * shortfall_epsilon * shortfall_predicted_beta_squared * shortfall_predicted_epsilon
    product_233 = 48.0 * attenuation_beta_squared * attenuation_epsilon * attenuation_predicted_beta_squared * attenuation_predicted_epsilon * product_11 * shortfall_epsilon * shortfall_predicted_beta_squared
    product_234 = 48.0 * attenuation_beta_squared * attenuation_epsilon * attenuation_predicted_epsilon_squared * product_5 * shortfall_epsilon * shortfall_predicted_beta * shortfall_predicted_epsilon_squared
    product_235 = 48.0 * attenuation_beta_squared * attenuation_epsilon * attenuation_predicted_beta * attenuation_predicted_epsilon_squared * product_7 * shortfall_epsilon * shortfall_predicted_epsilon_squared
    product_236 = 48.0 * attenuation_beta * attenuation_epsilon_squared * attenuation_predicted_beta_squared * product_9 * shortfall_beta * shortfall_predicted_beta_squared * shortfall_predicted_epsilon
    product_237 = 48.0 * attenuation_beta * attenuation_epsilon_squared * attenuation_predicted_beta_squared * attenuation_predicted_epsilon * product_11 * shortfall_beta * shortfall_predicted_beta_squared
    product_238 = 48.0 * attenuation_beta * attenuation_epsilon_squared * attenuation_predicted_epsilon_squared * product_5 * shortfall_beta * shortfall_predicted_beta * shortfall_predicted_epsilon_squared
    product_239 = 48.0 * attenuation_beta * attenuation_epsilon_squared * attenuation_predicted_beta * attenuation_predicted_epsilon_squared * product_7 * shortfall_beta * shortfall_predicted_epsilon_squared
    product_240 = 6.0 * attenuation_beta_squared * attenuation_epsilon_squared * attenuation_predicted_beta_squared * shortfall_predicted_beta_squared * shortfall_predicted_epsilon_squared_squared
    product_241 = 6.0 * attenuation_beta_squared * attenuation_epsilon_squared * attenuation_predicted_epsilon_squared * shortfall_predicted_beta_squared_squared * shortfall_predicted_epsilon_squared
    product_242 = 64.0 * attenuation_beta * attenuation_epsilon * product_5 * product_9 * shortfall_beta * shortfall_epsilon * shortfall_predicted_beta * shortfall_predicted_epsilon
    product_243 = 64.0 * attenuation_beta * attenuation_epsilon * attenuation_predicted_epsilon * product_11 * product_5 * shortfall_beta * shortfall_epsilon * shortfall_predicted_beta
    product_244 = 64.0 * attenuation_beta * attenuation_epsilon * attenuation_predicted_beta * product_7 * product_9 * shortfall_beta * shortfall_epsilon * shortfall_predicted_epsilon
    product_245 = 64.0 * attenuation_beta * attenuation_epsilon * attenuation_predicted_beta * attenuation_predicted_epsilon * product_11 * product_7 * shortfall_beta * shortfall_epsilon
    product_246 = 72.0 * attenuation_beta_squared * attenuation_epsilon * attenuation_predicted_beta_squared * attenuation_predicted_epsilon_squared * shortfall_epsilon * shortfall_predicted_beta_squared * shortfall_predicted_epsilon_squared
    product_247 = 72.0 * attenuation_beta * attenuation_epsilon_squared * attenuation_predicted_beta_squared * attenuation_predicted_epsilon_squared * shortfall_beta * shortfall_predicted_beta_squared * shortfall_predicted_epsilon_squared
    product_248 = 8.0 * attenuation_beta_squared * attenuation_epsilon * attenuation_predicted_epsilon_squared_squared * product_5 * shortfall_epsilon * shortfall_predicted_beta
    product_249 = 8.0 * attenuation_beta_squared * attenuation_epsilon * product_5 * shortfall_epsilon * shortfall_predicted_beta * shortfall_predicted_epsilon_squared_squared
    product_250 = 8.0 * attenuation_beta_squared * attenuation_epsilon * attenuation_predicted_beta * attenuation_predicted_epsilon_squared_squared * product_7 * shortfall_epsilon
    product_251 = 8.0 * attenuation_beta_squared * attenuation_epsilon * attenuation_predicted_beta * product_7 * shortfall_epsilon * shortfall_predicted_epsilon_squared_squared
    product_252 = 8.0 * attenuation_beta_squared * attenuation_epsilon * product_9 * shortfall_epsilon * shortfall_predicted_beta_squared_squared * shortfall_predicted_epsilon
    product_253 = 8.0 * attenuation_beta_squared * attenuation_epsilon * attenuation_predicted_epsilon * product_11 * shortfall_epsilon * shortfall_predicted_beta_squared_squared
    product_254 = 8.0 * attenuation_beta * attenuation_epsilon_squared * product_5 * shortfall_beta * shortfall_predicted_beta * shortfall_predicted_epsilon_squared_squared
    product_255 = 8.0 * attenuation_beta * attenuation_epsilon_squared * attenuation_predicted_beta * product_7 * shortfall_beta * shortfall_predicted_epsilon_squared_squared
    product_256 = 8.0 * attenuation_beta * attenuation_epsilon_squared * product_9 * shortfall_beta * shortfall_predicted_beta_squared_squared * shortfall_predicted_epsilon
    product_257 = 8.0 * attenuation_beta * attenuation_epsilon_squared * attenuation_predicted_epsilon * product_11 * shortfall_beta * shortfall_predicted_beta_squared_squared
    product_258 = 96.0 * attenuation_beta * attenuation_epsilon * attenuation_predicted_beta_squared * product_9 * shortfall_beta * shortfall_epsilon * shortfall_predicted_beta_squared * shortfall_predicted_epsilon
    product_259 = 96.0 * attenuation_beta * attenuation_epsilon * attenuation_predicted_beta_squared * attenuation_predicted_epsilon * product_11 * shortfall_beta * shortfall_epsilon * shortfall_predicted_beta_squared
    product_260 = 96.0 * attenuation_beta * attenuation_epsilon * attenuation_predicted_epsilon_squared * product_5 * shortfall_beta * shortfall_epsilon * shortfall_predicted_beta * shortfall_predicted_epsilon_squared
    product_261 = 96.0 * attenuation_beta * attenuation_epsilon * attenuation_predicted_beta * attenuation_predicted_epsilon_squared * product_7 * shortfall_beta * shortfall_epsilon * shortfall_predicted_epsilon_squared
    product_262 = attenuation_beta_squared * attenuation_epsilon_squared * shortfall_predicted_beta_squared_squared * shortfall_predicted_epsilon_squared_squared
    sigma_r_squared = sigma_r**2
    sum_2 = (
        12.0 * attenuation_beta_squared * attenuation_epsilon_squared * attenuation_predicted_beta_squared * attenuation_predicted_epsilon_squared_squared * shortfall_predicted_beta_squared
        + 16.0 * attenuation_beta * attenuation_epsilon_squared * attenuation_predicted_beta * attenuation_predicted_epsilon_squared_squared * product_7 * shortfall_beta
        + 16.0 * attenuation_beta * attenuation_epsilon_squared * attenuation_predicted_epsilon_squared_squared * product_5 * shortfall_beta * shortfall_predicted_beta
        + 2.0 * attenuation_beta_squared * attenuation_epsilon_squared * attenuation_predicted_epsilon_squared_squared * shortfall_predicted_beta_squared_squared
        + 24.0 * attenuation_beta * attenuation_epsilon_squared * attenuation_predicted_beta_squared * attenuation_predicted_epsilon_squared_squared * shortfall_beta * shortfall_predicted_beta_squared
        + 4.0 * attenuation_beta * attenuation_epsilon_squared * attenuation_predicted_epsilon_squared_squared * shortfall_beta * shortfall_predicted_beta_squared_squared
        + 8.0 * attenuation_beta_squared * attenuation_epsilon_squared * attenuation_predicted_beta * attenuation_predicted_epsilon_squared_squared * product_7
        + 8.0 * attenuation_beta_squared * attenuation_epsilon_squared * attenuation_predicted_epsilon_squared_squared * product_5 * shortfall_predicted_beta
        + product_100
        + product_101
        + product_102
        + product_103
        + product_105
        + product_109
        + product_110
        + product_111
        + product_112
        + product_113
        + product_114
        + product_115
        + product_116
        + product_117
        + product_118
        + product_119
        + product_120
        + product_121
        + product_122
        + product_123
        + product_124
        + product_129
        + product_13
        + product_130
        + product_131
        + product_132
        + product_133
        + product_134
        + product_135
        + product_136
        + product_139
        + product_14
        + product_140
        + product_141
        + product_144
        + product_145
        + product_146
        + product_147
        + product_148
        + product_149
        + product_15
        + product_150
        + product_155
        + product_156
        + product_158
        + product_159
        + product_16
        + product_163
        + product_164
        + product_165
        + product_166
        + product_167
        + product_168
        + product_169
        + product_17
        + product_170
        + product_171
        + product_172
        + product_173
        + product_174
        + product_175
        + product_176
        + product_177
        + product_178
        + product_179
        + product_18
        + product_180
        + product_182
        + product_183
        + product_185
        + product_186
        + product_187
        + product_188
        + product_189
        + product_19
        + product_190
        + product_191
        + product_192
        + product_193
        + product_194
        + product_195
        + product_196
        + product_197
        + product_198
        + product_199
        + product_20
        + product_200
        + product_201
        + product_202
        + product_203
        + product_204
        + product_205
        + product_206
        + product_207
        + product_208
        + product_209
        + product_21
        + product_210
        + product_211
        + product_212
        + product_213
        + product_214
        + product_215
        + product_216
        + product_217
        + product_218
        + product_219
        + product_220
        + product_221
        + product_222
        + product_223
        + product_224
        + product_225
        + product_226
        + product_227
        + product_228
        + product_229
        + product_230
        + product_231
        + product_232
        + product_233
        + product_234
        + product_235
        + product_236
        + product_237
        + product_238
        + product_239
        + product_240
        + product_241
        + product_242
        + product_243
        + product_244
        + product_245
        + product_246
        + product_247
        + product_248
        + product_249
        + product_250
        + product_251
        + product_252
        + product_253
        + product_254
        + product_255
        + product_256
        + product_257
        + product_258
        + product_259
        + product_26
        + product_260
        + product_261
        + product_262
        + product_27
        + product_28
        + product_29
        + product_3
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
        + product_46
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
        + product_63
        + product_64
        + product_65
        + product_66
        + product_71
        + product_72
        + product_73
        + product_74
        + product_75
        + product_76
        + product_77
        + product_78
        + product_79
        + product_81
        + product_82
        + product_83
        + product_84
        + product_85
        + product_86
        + product_87
        + product_88
        + product_90
        + product_92
        + product_93
        + product_98
        + product_99
    )
    part_00_cos_beta2_cos_epsilon2 = (
        0.25 * predicted_sigma_r_squared * sum_1 * term_1 * term_2
        + 0.25 * r_squared * sum_1 * term_1 * term_2
        + 0.25 * sigma_r_squared * sum_2 * term_1 * term_2
    )
    sum_3 = (
        product_1
        + product_10
        + product_100
        + product_101
        + product_102
        + product_103
        + product_104
        + product_106
        + product_107
        + product_108
        + product_109
        + product_110
        + product_111
        + product_112
        + product_113
        + product_114
        + product_115
        + product_116
        + product_117
        + product_118
        + product_119
        + product_12
        + product_120
        + product_121
        + product_122
        + product_123
        + product_124
        + product_125
        + product_126
        + product_127
        + product_128
        + product_129
        + product_13
        + product_130
        + product_131
        + product_132
        + product_133
        + product_134
        + product_135
        + product_136
        + product_137
        + product_138
        + product_139
        + product_14
        + product_140
        + product_141
        + product_142
        + product_143
        + product_144
        + product_145
        + product_146
        + product_147
        + product_148
        + product_149
        + product_15
        + product_150
        + product_151
        + product_152
        + product_153
        + product_154
        + product_155
        + product_156
        + product_158
        + product_159
        + product_16
        + product_163
        + product_164
        + product_165
        + product_166
        + product_167
        + product_168
        + product_169
        + product_170
        + product_173
        + product_174
        + product_175
        + product_176
        + product_177
        + product_178
        + product_179
        + product_18
        + product_180
        + product_181
        + product_182
        + product_183
        + product_184
        + product_185
        + product_186
        + product_187
        + product_188
        + product_189
        + product_19
        + product_190
        + product_191
        + product_20
        + product_201
        + product_203
        + product_207
        + product_21
        + product_214
        + product_22
        + product_23
        + product_230
        + product_24
        + product_248
        + product_25
        + product_250
        + product_26
        + product_27
        + product_28
        + product_29
        + product_3
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
        + product_49
        + product_50
        + product_51
        + product_52
        + product_55
        + product_56
        + product_57
        + product_58
        + product_59
        + product_6
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
    sum_4 = (
        product_100
        + product_101
        + product_102
        + product_103
        + product_109
        + product_110
        + product_111
        + product_112
        + product_113
        + product_114
        + product_115
        + product_116
        + product_117
        + product_118
        + product_119
        + product_120
        + product_121
        + product_122
        + product_123
        + product_124
        + product_129
        + product_13
        + product_130
        + product_131
        + product_132
        + product_133
        + product_134
        + product_135
        + product_136
        + product_139
        + product_14
        + product_140
        + product_141
        + product_144
        + product_145
        + product_146
        + product_147
        + product_148
        + product_149
        + product_15
        + product_150
        + product_155
        + product_156
        + product_158
        + product_159
        + product_16
        + product_163
        + product_164
        + product_165
        + product_166
        + product_167
        + product_168
        + product_169
        + product_170
        + product_173
        + product_174
        + product_175
        + product_176
        + product_177
        + product_178
        + product_179
        + product_18
        + product_180
        + product_182
        + product_183
        + product_185
        + product_186
        + product_187
        + product_188
        + product_189
        + product_19
        + product_190
        + product_191
        + product_192
        + product_193
        + product_194
        + product_195
        + product_196
        + product_197
        + product_198
        + product_199
        + product_20
        + product_200
        + product_201
        + product_202
        + product_203
        + product_204
        + product_205
        + product_206
        + product_207
        + product_208
        + product_209
        + product_21
        + product_210
        + product_211
        + product_212
        + product_213
        + product_214
        + product_215
        + product_216
        + product_217
        + product_218
        + product_219
        + product_220
        + product_221
        + product_222
        + product_223
        + product_224
        + product_225
        + product_226
        + product_227
        + product_228
        + product_229
        + product_230
        + product_231
        + product_232
        + product_233
        + product_234
        + product_235
        + product_236
        + product_237
        + product_238
        + product_239
        + product_240
        + product_241
        + product_242
        + product_243
        + product_244
        + product_245
        + product_246
        + product_247
        + product_248
        + product_249
        + product_250
        + product_251
        + product_252
        + product_253
        + product_254
        + product_255
        + product_256
        + product_257
        + product_258
        + product_259
        + product_26
        + product_260
        + product_261
        + product_262
        + product_27
        + product_28
        + product_29
        + product_3
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
        + product_46
        + product_49
        + product_50
        + product_51
        + product_52
        + product_55
        + product_56
        + product_57
        + product_58
        + product_63
        + product_64
        + product_65
        + product_66
        + product_71
        + product_72
        + product_73
        + product_74
        + product_75
        + product_76
        + product_77
        + product_78
        + product_79
        + product_81
        + product_82
        + product_83
        + product_84
        + product_85
        + product_86
        + product_87
        + product_88
        + product_90
        + product_92
        + product_93
        + product_98
        + product_99
    )
    part_00_cos_beta2_sin_epsilon2 = (
        0.25 * predicted_sigma_r_squared * sum_3 * term_1 * term_2
        + 0.25 * r_squared * sum_3 * term_1 * term_2
        + 0.25 * sigma_r_squared * sum_4 * term_1 * term_2
    )
    product_263 = 12.0 * attenuation_beta_squared * attenuation_epsilon * attenuation_predicted_beta_squared_squared * attenuation_predicted_epsilon_squared * shortfall_epsilon * shortfall_predicted_epsilon_squared
    product_264 = 12.0 * attenuation_beta_squared * attenuation_predicted_beta_squared_squared * attenuation_predicted_epsilon_squared * shortfall_epsilon_squared * shortfall_predicted_epsilon_squared
    product_265 = 12.0 * attenuation_beta * attenuation_epsilon * attenuation_predicted_beta_squared_squared * attenuation_predicted_epsilon_squared * shortfall_beta * shortfall_epsilon * shortfall_predicted_epsilon_squared
    product_266 = 2.0 * attenuation_beta_squared * attenuation_epsilon * attenuation_predicted_beta_squared_squared * shortfall_epsilon * shortfall_predicted_epsilon_squared_squared
    product_267 = 2.0 * attenuation_beta_squared * attenuation_predicted_beta_squared_squared * attenuation_predicted_epsilon_squared_squared * shortfall_epsilon_squared
    product_268 = 2.0 * attenuation_beta_squared * attenuation_predicted_beta_squared_squared * shortfall_epsilon_squared * shortfall_predicted_epsilon_squared_squared
    product_269 = 2.0 * attenuation_beta * attenuation_epsilon * attenuation_predicted_beta_squared_squared * shortfall_beta * shortfall_epsilon * shortfall_predicted_epsilon_squared_squared
    product_270 = 8.0 * attenuation_beta_squared * attenuation_epsilon * attenuation_predicted_beta_squared_squared * product_9 * shortfall_epsilon * shortfall_predicted_epsilon
    product_271 = 8.0 * attenuation_beta_squared * attenuation_epsilon * attenuation_predicted_beta_squared_squared * attenuation_predicted_epsilon * product_11 * shortfall_epsilon
    product_272 = 8.0 * attenuation_beta_squared * attenuation_predicted_beta_squared_squared * product_9 * shortfall_epsilon_squared * shortfall_predicted_epsilon
    product_273 = 8.0 * attenuation_beta_squared * attenuation_predicted_beta_squared_squared * attenuation_predicted_epsilon * product_11 * shortfall_epsilon_squared
    product_274 = 8.0 * attenuation_beta * attenuation_epsilon * attenuation_predicted_beta_squared_squared * product_9 * shortfall_beta * shortfall_epsilon * shortfall_predicted_epsilon
    product_275 = 8.0 * attenuation_beta * attenuation_epsilon * attenuation_predicted_beta_squared_squared * attenuation_predicted_epsilon * product_11 * shortfall_beta * shortfall_epsilon
    sum_5 = (
        product_1
        + product_10
        + product_100
        + product_101
        + product_102
        + product_103
        + product_104
        + product_106
        + product_107
        + product_108
        + product_111
        + product_112
        + product_113
        + product_114
        + product_115
        + product_116
        + product_117
        + product_118
        + product_119
        + product_12
        + product_120
        + product_121
        + product_122
        + product_123
        + product_124
        + product_125
        + product_126
        + product_127
        + product_128
        + product_129
        + product_13
        + product_130
        + product_131
        + product_132
        + product_133
        + product_134
        + product_135
        + product_136
        + product_137
        + product_138
        + product_139
        + product_14
        + product_140
        + product_141
        + product_142
        + product_143
        + product_144
        + product_145
        + product_146
        + product_147
        + product_148
        + product_149
        + product_15
        + product_150
        + product_151
        + product_152
        + product_153
        + product_154
        + product_155
        + product_156
        + product_157
        + product_16
        + product_160
        + product_161
        + product_162
        + product_163
        + product_164
        + product_165
        + product_166
        + product_167
        + product_168
        + product_169
        + product_17
        + product_170
        + product_171
        + product_172
        + product_173
        + product_174
        + product_175
        + product_176
        + product_177
        + product_178
        + product_179
        + product_18
        + product_180
        + product_181
        + product_182
        + product_183
        + product_184
        + product_185
        + product_186
        + product_187
        + product_188
        + product_189
        + product_19
        + product_190
        + product_2
        + product_20
        + product_21
        + product_22
        + product_23
        + product_24
        + product_25
        + product_26
        + product_263
        + product_264
        + product_265
        + product_266
        + product_267
        + product_268
        + product_269
        + product_27
        + product_270
        + product_271
        + product_272
        + product_273
        + product_274
        + product_275
        + product_28
        + product_29
        + product_30
        + product_31
        + product_32
        + product_33
        + product_36
        + product_37
        + product_38
        + product_39
        + product_4
        + product_40
        + product_41
        + product_42
        + product_43
        + product_44
        + product_45
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
        + product_6
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
        + product_70
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
    product_276 = attenuation_epsilon_squared * attenuation_predicted_epsilon_squared_squared
    sum_6 = (
        1.0
        + attenuation_beta_squared * attenuation_epsilon_squared * attenuation_predicted_beta_squared_squared * attenuation_predicted_epsilon_squared_squared
        + attenuation_beta_squared * attenuation_predicted_beta_squared_squared
        + product_276
    )
    part_00_cos_epsilon2_sin_beta2 = (
        0.25 * predicted_sigma_r_squared * sum_5 * term_1 * term_2
        + 0.25 * r_squared * sum_5 * term_1 * term_2
        + 0.25 * sigma_r_squared * sum_6 * term_1 * term_2
    )
    product_277 = 4.0 * attenuation_beta_squared * attenuation_epsilon * attenuation_predicted_beta_squared_squared * attenuation_predicted_epsilon_squared_squared * shortfall_epsilon
    sum_7 = (
        product_1
        + product_10
        + product_100
        + product_101
        + product_102
        + product_103
        + product_104
        + product_106
        + product_107
        + product_108
        + product_109
        + product_111
        + product_112
        + product_113
        + product_114
        + product_115
        + product_116
        + product_117
        + product_118
        + product_119
        + product_12
        + product_120
        + product_121
        + product_122
        + product_123
        + product_124
        + product_125
        + product_126
        + product_127
        + product_128
        + product_129
        + product_13
        + product_130
        + product_131
        + product_132
        + product_133
        + product_134
        + product_135
        + product_136
        + product_137
        + product_138
        + product_139
        + product_14
        + product_140
        + product_141
        + product_142
        + product_143
        + product_144
        + product_145
        + product_146
        + product_147
        + product_148
        + product_149
        + product_15
        + product_150
        + product_151
        + product_152
        + product_153
        + product_154
        + product_155
        + product_156
        + product_16
        + product_163
        + product_164
        + product_165
        + product_166
        + product_167
        + product_168
        + product_169
        + product_170
        + product_173
        + product_174
        + product_175
        + product_176
        + product_177
        + product_178
        + product_179
        + product_18
        + product_180
        + product_181
        + product_182
        + product_183
        + product_184
        + product_185
        + product_186
        + product_187
        + product_188
        + product_189
        + product_19
        + product_190
        + product_191
        + product_20
        + product_201
        + product_203
        + product_207
        + product_21
        + product_214
        + product_22
        + product_23
        + product_230
        + product_24
        + product_248
        + product_25
        + product_250
        + product_26
        + product_263
        + product_264
        + product_265
        + product_266
        + product_267
        + product_268
        + product_269
        + product_27
        + product_270
        + product_271
        + product_272
        + product_273
        + product_274
        + product_275
        + product_277
        + product_28
        + product_29
        + product_30
        + product_31
        + product_32
        + product_33
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
        + product_49
        + product_50
        + product_51
        + product_52
        + product_55
        + product_56
        + product_57
        + product_58
        + product_59
        + product_6
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
        + product_70
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
    sum_8 = (
        12.0 * attenuation_beta_squared * attenuation_epsilon_squared * attenuation_predicted_beta_squared_squared * attenuation_predicted_epsilon_squared * shortfall_predicted_epsilon_squared
        + 16.0 * attenuation_beta_squared * attenuation_epsilon * attenuation_predicted_beta_squared_squared * attenuation_predicted_epsilon * product_11 * shortfall_epsilon
        + 16.0 * attenuation_beta_squared * attenuation_epsilon * attenuation_predicted_beta_squared_squared * product_9 * shortfall_epsilon * shortfall_predicted_epsilon
        + 2.0 * attenuation_beta_squared * attenuation_epsilon_squared * attenuation_predicted_beta_squared_squared * shortfall_predicted_epsilon_squared_squared
        + 24.0 * attenuation_beta_squared * attenuation_epsilon * attenuation_predicted_beta_squared_squared * attenuation_predicted_epsilon_squared * shortfall_epsilon * shortfall_predicted_epsilon_squared
        + 4.0 * attenuation_beta_squared * attenuation_epsilon * attenuation_predicted_beta_squared_squared * shortfall_epsilon * shortfall_predicted_epsilon_squared_squared
        + 8.0 * attenuation_beta_squared * attenuation_epsilon_squared * attenuation_predicted_beta_squared_squared * attenuation_predicted_epsilon * product_11
        + 8.0 * attenuation_beta_squared * attenuation_epsilon_squared * attenuation_predicted_beta_squared_squared * product_9 * shortfall_predicted_epsilon
        + product_100
        + product_101
        + product_102
        + product_103
        + product_109
        + product_110
        + product_111
        + product_112
        + product_113
        + product_114
        + product_115
        + product_116
        + product_117
        + product_118
        + product_119
        + product_120
        + product_121
        + product_122
        + product_123
        + product_124
        + product_129
        + product_13
        + product_130
        + product_131
        + product_132
        + product_133
        + product_134
        + product_135
        + product_136
        + product_139
        + product_14
        + product_140
        + product_141
        + product_144
        + product_145
        + product_146
        + product_147
        + product_148
        + product_149
        + product_15
        + product_150
        + product_155
        + product_156
        + product_158
        + product_159
        + product_16
        + product_163
        + product_164
        + product_165
        + product_166
        + product_167
        + product_168
        + product_169
        + product_170
        + product_173
        + product_174
        + product_175
        + product_176
        + product_177
        + product_178
        + product_179
        + product_18
        + product_180
        + product_182
        + product_183
        + product_185
        + product_186
        + product_187
        + product_188
        + product_189
        + product_19
        + product_190
        + product_191
        + product_192
        + product_193
        + product_194
        + product_195
        + product_196
        + product_197
        + product_198
        + product_199
        + product_20
        + product_200
        + product_201
        + product_202
        + product_203
        + product_204
        + product_205
        + product_206
        + product_207
        + product_208
        + product_209
        + product_21
        + product_210
        + product_211
        + product_212
        + product_213
        + product_214
        + product_215
        + product_216
        + product_217
        + product_218
        + product_219
        + product_220
        + product_221
        + product_222
        + product_223
        + product_224
        + product_225
        + product_226
        + product_227
        + product_228
        + product_229
        + product_230
        + product_231
        + product_232
        + product_233
        + product_234
        + product_235
        + product_236
        + product_237
        + product_238
        + product_239
        + product_240
        + product_241
        + product_242
        + product_243
        + product_244
        + product_245
        + product_246
        + product_247
        + product_248
        + product_249
        + product_250
        + product_251
        + product_252
        + product_253
        + product_254
        + product_255
        + product_256
        + product_257
        + product_258
        + product_259
        + product_26
        + product_260
        + product_261
        + product_262
        + product_264
        + product_267
        + product_268
        + product_27
        + product_272
        + product_273
        + product_277
        + product_28
        + product_29
        + product_3
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
        + product_46
        + product_49
        + product_50
        + product_51
        + product_52
        + product_55
        + product_56
        + product_57
        + product_58
        + product_63
        + product_64
        + product_65
        + product_66
        + product_71
        + product_72
        + product_73
        + product_74
        + product_75
        + product_76
        + product_77
        + product_78
        + product_79
        + product_81
        + product_82
        + product_83
        + product_84
        + product_85
        + product_86
        + product_87
        + product_88
        + product_90
        + product_92
        + product_93
        + product_98
        + product_99
    )
    part_00_sin_beta2_sin_epsilon2 = (
        0.25 * predicted_sigma_r_squared * sum_7 * term_1 * term_2
        + 0.25 * r_squared * sum_7 * term_1 * term_2
        + 0.25 * sigma_r_squared * sum_8 * term_1 * term_2
    )
    sum_9 = 1.0 + product_276
    product_278 = -4.0 * attenuation_epsilon_squared * product_9 * shortfall_beta * shortfall_predicted_epsilon
    product_279 = -4.0 * attenuation_epsilon_squared * attenuation_predicted_epsilon * product_11 * shortfall_beta
    product_280 = -4.0 * attenuation_epsilon * product_9 * shortfall_beta * shortfall_epsilon * shortfall_predicted_epsilon
    product_281 = -4.0 * attenuation_epsilon * attenuation_predicted_epsilon * product_11 * shortfall_beta * shortfall_epsilon
    product_282 = -6.0 * attenuation_epsilon_squared * attenuation_predicted_epsilon_squared * shortfall_beta * shortfall_predicted_epsilon_squared
    product_283 = -6.0 * attenuation_epsilon * attenuation_predicted_epsilon_squared * shortfall_beta * shortfall_epsilon * shortfall_predicted_epsilon_squared
    product_284 = -attenuation_epsilon_squared * shortfall_beta * shortfall_predicted_epsilon_squared_squared
    product_285 = -attenuation_epsilon * shortfall_beta * shortfall_epsilon * shortfall_predicted_epsilon_squared_squared
    product_286 = 4.0 * attenuation_beta * attenuation_epsilon * product_9 * shortfall_epsilon * shortfall_predicted_epsilon
    product_287 = 4.0 * attenuation_beta * attenuation_epsilon * attenuation_predicted_epsilon * product_11 * shortfall_epsilon
    product_288 = 4.0 * attenuation_beta * product_9 * shortfall_epsilon_squared * shortfall_predicted_epsilon
    product_289 = 4.0 * attenuation_beta * attenuation_predicted_epsilon * product_11 * shortfall_epsilon_squared
    product_290 = 6.0 * attenuation_beta * attenuation_epsilon * attenuation_predicted_epsilon_squared * shortfall_epsilon * shortfall_predicted_epsilon_squared
    product_291 = 6.0 * attenuation_beta * attenuation_predicted_epsilon_squared * shortfall_epsilon_squared * shortfall_predicted_epsilon_squared
    product_292 = attenuation_beta * attenuation_epsilon * shortfall_epsilon * shortfall_predicted_epsilon_squared_squared
    product_293 = attenuation_beta * attenuation_predicted_epsilon_squared_squared * shortfall_epsilon_squared
    product_294 = attenuation_beta * shortfall_epsilon_squared * shortfall_predicted_epsilon_squared_squared
    sum_10 = (
        product_278
        - 2.0 * attenuation_epsilon * attenuation_predicted_epsilon_squared_squared * shortfall_beta * shortfall_epsilon
        - 2.0 * attenuation_epsilon_squared * attenuation_predicted_epsilon_squared_squared * shortfall_beta
        + product_279
        + product_280
        + product_281
        + product_282
        + product_283
        + product_284
        + product_285
        + product_286
        + product_287
        + product_288
        + product_289
        + product_290
        + product_291
        + product_292
        + product_293
        + product_294
    )
    part_01_cos_beta_cos_epsilon2_sin_beta = (
        0.5 * attenuation_beta * attenuation_predicted_beta_squared_squared * sigma_r_squared * sum_9 * term_2
        + 0.5 * attenuation_predicted_beta_squared_squared * predicted_sigma_r_squared * sum_10 * term_2
        + 0.5 * attenuation_predicted_beta_squared_squared * r_squared * sum_10 * term_2
    )
    sum_11 = (
        12.0 * attenuation_epsilon * attenuation_predicted_epsilon_squared * shortfall_epsilon * shortfall_predicted_epsilon_squared
        + 2.0 * attenuation_epsilon * attenuation_predicted_epsilon_squared_squared * shortfall_epsilon
        + 2.0 * attenuation_epsilon * shortfall_epsilon * shortfall_predicted_epsilon_squared_squared
        + 4.0 * attenuation_epsilon_squared * attenuation_predicted_epsilon * product_11
        + 4.0 * attenuation_epsilon_squared * product_9 * shortfall_predicted_epsilon
        + 4.0 * attenuation_predicted_epsilon * product_11 * shortfall_epsilon_squared
        + 4.0 * product_9 * shortfall_epsilon_squared * shortfall_predicted_epsilon
        + 6.0 * attenuation_epsilon_squared * attenuation_predicted_epsilon_squared * shortfall_predicted_epsilon_squared
        + 6.0 * attenuation_predicted_epsilon_squared * shortfall_epsilon_squared * shortfall_predicted_epsilon_squared
        + 8.0 * attenuation_epsilon * attenuation_predicted_epsilon * product_11 * shortfall_epsilon
        + 8.0 * attenuation_epsilon * product_9 * shortfall_epsilon * shortfall_predicted_epsilon
        + attenuation_epsilon_squared * shortfall_predicted_epsilon_squared_squared
        + attenuation_predicted_epsilon_squared_squared * shortfall_epsilon_squared
        + shortfall_epsilon_squared * shortfall_predicted_epsilon_squared_squared
    )
    sum_12 = (
        2.0 * attenuation_beta * attenuation_epsilon * attenuation_predicted_epsilon_squared_squared * shortfall_epsilon
        + product_278
        + product_279
        + product_280
        + product_281
        + product_282
        + product_283
        + product_284
        + product_285
        + product_286
        + product_287
        + product_288
        + product_289
        + product_290
        + product_291
        + product_292
        + product_293
        + product_294
    )
    part_01_cos_beta_sin_beta_sin_epsilon2 = (
        0.5 * attenuation_beta * attenuation_predicted_beta_squared_squared * sigma_r_squared * sum_11 * term_2
        + 0.5 * attenuation_predicted_beta_squared_squared * predicted_sigma_r_squared * sum_12 * term_2
        + 0.5 * attenuation_predicted_beta_squared_squared * r_squared * sum_12 * term_2
    )
    part_02_cos_epsilon_sin_beta_sin_epsilon = (
        attenuation_epsilon * attenuation_predicted_beta * attenuation_predicted_epsilon_squared_squared * sigma_r_squared
        - attenuation_predicted_beta * attenuation_predicted_epsilon_squared_squared * predicted_sigma_r_squared * shortfall_epsilon
        - attenuation_predicted_beta * attenuation_predicted_epsilon_squared_squared * r_squared * shortfall_epsilon
    )
    part_03_cos_epsilon_sin_beta = (
        attenuation_predicted_beta * attenuation_predicted_epsilon * r * rho * sigma_r * sigma_rdot
        + attenuation_predicted_beta * attenuation_predicted_epsilon * rdot * sigma_r_squared
    )
    sum_13 = 1.0 + attenuation_epsilon * attenuation_predicted_epsilon_squared_squared
    part_22_cos_epsilon2 = (
        0.5 * predicted_sigma_r_squared * shortfall_epsilon * sum_13 * term_2
        + 0.5 * r_squared * shortfall_epsilon * sum_13 * term_2
        + 0.5 * sigma_r_squared * sum_11 * term_2
    )
    sum_14 = (
        4.0 * attenuation_epsilon * attenuation_predicted_epsilon * product_11
        + 4.0 * attenuation_epsilon * product_9 * shortfall_predicted_epsilon
        + 4.0 * attenuation_predicted_epsilon * product_11 * shortfall_epsilon
        + 4.0 * product_9 * shortfall_epsilon * shortfall_predicted_epsilon
        + 6.0 * attenuation_epsilon * attenuation_predicted_epsilon_squared * shortfall_predicted_epsilon_squared
        + 6.0 * attenuation_predicted_epsilon_squared * shortfall_epsilon * shortfall_predicted_epsilon_squared
        + attenuation_epsilon * shortfall_predicted_epsilon_squared_squared
        + attenuation_predicted_epsilon_squared_squared * shortfall_epsilon
        + shortfall_epsilon * shortfall_predicted_epsilon_squared_squared
    )
    part_22_sin_epsilon2 = (
        0.5 * predicted_sigma_r_squared * shortfall_epsilon * sum_14 * term_2
        + 0.5 * r_squared * shortfall_epsilon * sum_14 * term_2
        + 0.5 * sigma_r_squared * sum_9 * term_2
    )
    part_23_sin_epsilon = (
        attenuation_predicted_epsilon * r * rho * sigma_r * sigma_rdot
        + attenuation_predicted_epsilon * rdot * sigma_r_squared
    )
    cos_beta_squared = cos_beta**2
    cos_epsilon_squared = cos_epsilon**2
    sin_epsilon_squared = sin_epsilon**2
    sin_beta_squared = sin_beta**2
    sigma_rdot_squared = sigma_rdot**2
    result = _empty(arguments, (4, 4))
    result[..., 0, 0] = (
        cos_beta_squared * cos_epsilon_squared * part_00_cos_beta2_cos_epsilon2
        + cos_beta_squared * part_00_cos_beta2_sin_epsilon2 * sin_epsilon_squared
        + cos_epsilon_squared * part_00_cos_epsilon2_sin_beta2 * sin_beta_squared
        + part_00_sin_beta2_sin_epsilon2 * sin_beta_squared * sin_epsilon_squared
    )
    result[..., 0, 1] = (
        cos_beta * cos_epsilon_squared * part_01_cos_beta_cos_epsilon2_sin_beta * sin_beta
        + cos_beta * part_01_cos_beta_sin_beta_sin_epsilon2 * sin_beta * sin_epsilon_squared
    )
    result[..., 0, 2] = cos_epsilon * part_02_cos_epsilon_sin_beta_sin_epsilon * sin_beta * sin_epsilon
    result[..., 0, 3] = cos_epsilon * part_03_cos_epsilon_sin_beta * sin_beta
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = (
        cos_beta_squared * cos_epsilon_squared * part_00_cos_epsilon2_sin_beta2
        + cos_beta_squared * part_00_sin_beta2_sin_epsilon2 * sin_epsilon_squared
        + cos_epsilon_squared * part_00_cos_beta2_cos_epsilon2 * sin_beta_squared
        + part_00_cos_beta2_sin_epsilon2 * sin_beta_squared * sin_epsilon_squared
    )
    result[..., 1, 2] = cos_beta * cos_epsilon * part_02_cos_epsilon_sin_beta_sin_epsilon * sin_epsilon
    result[..., 1, 3] = cos_beta * cos_epsilon * part_03_cos_epsilon_sin_beta
    result[..., 2, 0] = result[..., 0, 2]
    result[..., 2, 1] = result[..., 1, 2]
    result[..., 2, 2] = (
        cos_epsilon_squared * part_22_cos_epsilon2
        + part_22_sin_epsilon2 * sin_epsilon_squared
    )
    result[..., 2, 3] = part_23_sin_epsilon * sin_epsilon
    result[..., 3, 0] = result[..., 0, 3]
    result[..., 3, 1] = result[..., 1, 3]
    result[..., 3, 2] = result[..., 2, 3]
    result[..., 3, 3] = (
        2.0 * predicted_rho * predicted_sigma_r * predicted_sigma_rdot * rho * sigma_r * sigma_rdot
        + 2.0 * r * rdot * rho * sigma_r * sigma_rdot
        + predicted_sigma_r_squared * sigma_rdot_squared
        + r_squared * sigma_rdot_squared
        + predicted_sigma_rdot**2 * sigma_r_squared
        + rdot**2 * sigma_r_squared
        + sigma_r_squared * sigma_rdot_squared
        + rho**2 * sigma_r_squared * sigma_rdot_squared
    )
    return result


def unbiased_covariance_truth(
    *,
    r: npt.ArrayLike,
    beta: npt.ArrayLike,
    epsilon: npt.ArrayLike,
    rdot: npt.ArrayLike,
    sigma_r: npt.ArrayLike,
    sigma_beta: npt.ArrayLike,
    sigma_epsilon: npt.ArrayLike,
    sigma_rdot: npt.ArrayLike,
    rho: npt.ArrayLike,
) -> Floats:
    """Covariance of the unbiased estimate u about the true position, R_t of Mo et al..

    Name: spherical_doppler.unbiased.covariance.truth.
    Definition: e^L(u u') - h h'.
    Conditioning: truth-conditioned: the measured symbols stand for the true values.
    Source: Mo et al. 1998 R_t, doi:10.1109/7.705921.

    Args:
        r: range [m], 1 to 1e+08.
        beta: azimuth, clockwise from the y axis [rad], -3.1416 to 3.1416.
        epsilon: elevation, up from the horizontal plane [rad], -1.5708 to 1.5708.
        rdot: range rate [m/s], -10000 to 10000.
        sigma_r: standard deviation of the error of r [m], 0.001 to 10000.
        sigma_beta: standard deviation of the error of beta [rad], 1e-09 to 1.
        sigma_epsilon: standard deviation of the error of epsilon [rad], 1e-09 to 1.
        sigma_rdot: standard deviation of the error of rdot [m/s], 0.0001 to 1000.
        rho: correlation of the errors of r and rdot [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (4, 4), unit [m, m, m, m^2/s] × [m, m, m, m^2/s].

    Accuracy: at most 90.2 ulp anywhere in this domain with independent errors, proved for elementary
    functions within 1 ulp (float64); with correlations up to 0.99 in size at most 1100.
    """
    arguments = _floats(r, beta, epsilon, rdot, sigma_r, sigma_beta, sigma_epsilon, sigma_rdot, rho)
    r, beta, epsilon, rdot, sigma_r, sigma_beta, sigma_epsilon, sigma_rdot, rho = arguments
    cos_beta = np.cos(beta)
    sin_beta = np.sin(beta)
    cos_epsilon = np.cos(epsilon)
    sin_epsilon = np.sin(epsilon)
    attenuation_beta = np.exp(-sigma_beta**2)
    shortfall_beta = -np.expm1(-sigma_beta**2)
    attenuation_epsilon = np.exp(-sigma_epsilon**2)
    shortfall_epsilon = -np.expm1(-sigma_epsilon**2)
    term_1 = 1.0 / attenuation_beta
    term_2 = 1.0 / attenuation_epsilon
    attenuation_epsilon_squared = attenuation_epsilon**2
    sum_1 = (
        1.0
        + attenuation_beta
        + attenuation_beta * attenuation_epsilon_squared
        + attenuation_epsilon_squared
    )
    r_squared = r**2
    sigma_r_squared = sigma_r**2
    part_00_cos_beta2_cos_epsilon2 = (
        0.25 * r_squared * shortfall_beta * sum_1 * term_1 * term_2
        + 0.25 * shortfall_beta * sigma_r_squared * sum_1 * term_1 * term_2
    )
    sum_2 = 1.0 + attenuation_beta + attenuation_beta * attenuation_epsilon + attenuation_epsilon
    part_00_cos_beta2_sin_epsilon2 = (
        0.25 * r_squared * shortfall_beta * shortfall_epsilon * sum_2 * term_1 * term_2
        + 0.25 * shortfall_beta * shortfall_epsilon * sigma_r_squared * sum_2 * term_1 * term_2
    )
    attenuation_beta_squared = attenuation_beta**2
    shortfall_epsilon_squared = shortfall_epsilon**2
    shortfall_beta_squared = shortfall_beta**2
    sum_3 = (
        2.0 * attenuation_beta * shortfall_beta * shortfall_epsilon_squared
        + 2.0 * attenuation_beta_squared * shortfall_epsilon_squared
        + 2.0 * attenuation_epsilon * shortfall_beta_squared * shortfall_epsilon
        + 2.0 * attenuation_epsilon_squared * shortfall_beta_squared
        + shortfall_beta_squared * shortfall_epsilon_squared
    )
    sum_4 = (
        1.0
        + attenuation_beta_squared
        + attenuation_beta_squared * attenuation_epsilon_squared
        + attenuation_epsilon_squared
    )
    part_00_cos_epsilon2_sin_beta2 = (
        0.25 * r_squared * sum_3 * term_1 * term_2
        + 0.25 * sigma_r_squared * sum_4 * term_1 * term_2
    )
    sum_5 = (
        1.0
        + attenuation_beta_squared
        + attenuation_beta_squared * attenuation_epsilon
        + attenuation_epsilon
    )
    part_00_sin_beta2_sin_epsilon2 = (
        0.25 * r_squared * shortfall_epsilon * sum_5 * term_1 * term_2
        + 0.25 * shortfall_epsilon * sigma_r_squared * sum_5 * term_1 * term_2
    )
    sum_6 = 1.0 + attenuation_epsilon_squared
    sum_7 = (
        attenuation_beta * shortfall_epsilon_squared
        - 2.0 * attenuation_epsilon * shortfall_beta * shortfall_epsilon
        - 2.0 * attenuation_epsilon_squared * shortfall_beta
    )
    part_01_cos_beta_cos_epsilon2_sin_beta = (
        0.5 * attenuation_beta * sigma_r_squared * sum_6 * term_2
        + 0.5 * r_squared * sum_7 * term_2
    )
    sum_8 = 1.0 + attenuation_epsilon
    part_01_cos_beta_sin_beta_sin_epsilon2 = (
        0.5 * attenuation_beta * r_squared * shortfall_epsilon * sum_8 * term_2
        + 0.5 * attenuation_beta * shortfall_epsilon * sigma_r_squared * sum_8 * term_2
    )
    part_02_cos_epsilon_sin_beta_sin_epsilon = (
        attenuation_epsilon * sigma_r_squared
        - r_squared * shortfall_epsilon
    )
    part_03_cos_epsilon_sin_beta = r * rho * sigma_r * sigma_rdot + rdot * sigma_r_squared
    part_22_cos_epsilon2 = (
        0.5 * r_squared * shortfall_epsilon * sum_8 * term_2
        + 0.5 * shortfall_epsilon * sigma_r_squared * sum_8 * term_2
    )
    part_22_sin_epsilon2 = (
        0.5 * r_squared * shortfall_epsilon_squared * term_2
        + 0.5 * sigma_r_squared * sum_6 * term_2
    )
    cos_beta_squared = cos_beta**2
    cos_epsilon_squared = cos_epsilon**2
    sin_epsilon_squared = sin_epsilon**2
    sin_beta_squared = sin_beta**2
    sigma_rdot_squared = sigma_rdot**2
    result = _empty(arguments, (4, 4))
    result[..., 0, 0] = (
        cos_beta_squared * cos_epsilon_squared * part_00_cos_beta2_cos_epsilon2
        + cos_beta_squared * part_00_cos_beta2_sin_epsilon2 * sin_epsilon_squared
        + cos_epsilon_squared * part_00_cos_epsilon2_sin_beta2 * sin_beta_squared
        + part_00_sin_beta2_sin_epsilon2 * sin_beta_squared * sin_epsilon_squared
    )
    result[..., 0, 1] = (
        cos_beta * cos_epsilon_squared * part_01_cos_beta_cos_epsilon2_sin_beta * sin_beta
        + cos_beta * part_01_cos_beta_sin_beta_sin_epsilon2 * sin_beta * sin_epsilon_squared
    )
    result[..., 0, 2] = cos_epsilon * part_02_cos_epsilon_sin_beta_sin_epsilon * sin_beta * sin_epsilon
    result[..., 0, 3] = cos_epsilon * part_03_cos_epsilon_sin_beta * sin_beta
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = (
        cos_beta_squared * cos_epsilon_squared * part_00_cos_epsilon2_sin_beta2
        + cos_beta_squared * part_00_sin_beta2_sin_epsilon2 * sin_epsilon_squared
        + cos_epsilon_squared * part_00_cos_beta2_cos_epsilon2 * sin_beta_squared
        + part_00_cos_beta2_sin_epsilon2 * sin_beta_squared * sin_epsilon_squared
    )
    result[..., 1, 2] = cos_beta * cos_epsilon * part_02_cos_epsilon_sin_beta_sin_epsilon * sin_epsilon
    result[..., 1, 3] = cos_beta * cos_epsilon * part_03_cos_epsilon_sin_beta
    result[..., 2, 0] = result[..., 0, 2]
    result[..., 2, 1] = result[..., 1, 2]
    result[..., 2, 2] = (
        cos_epsilon_squared * part_22_cos_epsilon2
        + part_22_sin_epsilon2 * sin_epsilon_squared
    )
    result[..., 2, 3] = part_03_cos_epsilon_sin_beta * sin_epsilon
    result[..., 3, 0] = result[..., 0, 3]
    result[..., 3, 1] = result[..., 1, 3]
    result[..., 3, 2] = result[..., 2, 3]
    result[..., 3, 3] = (
        2.0 * r * rdot * rho * sigma_r * sigma_rdot
        + r_squared * sigma_rdot_squared
        + rdot**2 * sigma_r_squared
        + sigma_r_squared * sigma_rdot_squared
        + rho**2 * sigma_r_squared * sigma_rdot_squared
    )
    return result


def unbiased_covariance_averaged(
    *,
    r: npt.ArrayLike,
    beta: npt.ArrayLike,
    epsilon: npt.ArrayLike,
    rdot: npt.ArrayLike,
    sigma_r: npt.ArrayLike,
    sigma_beta: npt.ArrayLike,
    sigma_epsilon: npt.ArrayLike,
    sigma_rdot: npt.ArrayLike,
    rho: npt.ArrayLike,
) -> Floats:
    """Covariance of the unbiased estimate u, averaged over the truth, R_m of Mo et al..

    Name: spherical_doppler.unbiased.covariance.averaged.
    Definition: e^L [e^L(u u') - h h'].
    Conditioning: measurement-conditioned: the measured symbols stand for the measurement.
    Source: Mo et al. 1998 R_m, doi:10.1109/7.705921.

    Args:
        r: range [m], 1 to 1e+08.
        beta: azimuth, clockwise from the y axis [rad], -3.1416 to 3.1416.
        epsilon: elevation, up from the horizontal plane [rad], -1.5708 to 1.5708.
        rdot: range rate [m/s], -10000 to 10000.
        sigma_r: standard deviation of the error of r [m], 0.001 to 10000.
        sigma_beta: standard deviation of the error of beta [rad], 1e-09 to 1.
        sigma_epsilon: standard deviation of the error of epsilon [rad], 1e-09 to 1.
        sigma_rdot: standard deviation of the error of rdot [m/s], 0.0001 to 1000.
        rho: correlation of the errors of r and rdot [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (4, 4), unit [m, m, m, m^2/s] × [m, m, m, m^2/s].

    Accuracy: at most 6570 ulp anywhere in this domain with independent errors, proved for elementary
    functions within 1 ulp (float64).
    """
    arguments = _floats(r, beta, epsilon, rdot, sigma_r, sigma_beta, sigma_epsilon, sigma_rdot, rho)
    r, beta, epsilon, rdot, sigma_r, sigma_beta, sigma_epsilon, sigma_rdot, rho = arguments
    cos_beta = np.cos(beta)
    sin_beta = np.sin(beta)
    cos_epsilon = np.cos(epsilon)
    sin_epsilon = np.sin(epsilon)
    attenuation_beta = np.exp(-0.5 * sigma_beta**2)
    shortfall_beta = -np.expm1(-0.5 * sigma_beta**2)
    attenuation_epsilon = np.exp(-0.5 * sigma_epsilon**2)
    shortfall_epsilon = -np.expm1(-0.5 * sigma_epsilon**2)
    term_1 = 1.0 / attenuation_beta**2
    attenuation_beta_squared = attenuation_beta**2
    attenuation_epsilon_squared = attenuation_epsilon**2
    product_1 = -attenuation_beta_squared * attenuation_epsilon_squared
    attenuation_epsilon_squared_cubed = attenuation_epsilon_squared * attenuation_epsilon_squared**2
    product_2 = -attenuation_beta_squared * attenuation_epsilon_squared_cubed
    product_3 = attenuation_beta * attenuation_beta_squared
    product_4 = -attenuation_epsilon_squared * product_3
    product_5 = -attenuation_epsilon_squared_cubed * product_3
    attenuation_beta_squared_squared = attenuation_beta_squared**2
    product_6 = -attenuation_beta_squared_squared * attenuation_epsilon_squared
    product_7 = -attenuation_beta_squared_squared * attenuation_epsilon_squared_cubed
    product_8 = attenuation_beta * attenuation_beta_squared**2
    product_9 = -attenuation_epsilon_squared * product_8
    product_10 = -attenuation_epsilon_squared_cubed * product_8
    term_2 = (attenuation_epsilon_squared**2)**2
    attenuation_beta_squared_cubed = attenuation_beta_squared * attenuation_beta_squared**2
    product_11 = attenuation_beta * attenuation_beta_squared * attenuation_beta_squared**2
    term_3 = 1.0 / attenuation_epsilon**2
    r_squared = r**2
    sum_1 = (
        1.0
        + attenuation_beta
        + attenuation_beta * term_2
        + attenuation_beta_squared
        + attenuation_beta_squared * term_2
        + attenuation_beta_squared_cubed
        + attenuation_beta_squared_cubed * term_2
        + attenuation_beta_squared_squared
        + attenuation_beta_squared_squared * term_2
        + product_1
        + product_10
        + product_11
        + product_11 * term_2
        + product_2
        + product_3
        + product_3 * term_2
        + product_4
        + product_5
        + product_6
        + product_7
        + product_8
        + product_8 * term_2
        + product_9
        + term_2
    )
    product_12 = 2.0 * attenuation_beta_squared * term_2
    sigma_r_squared = sigma_r**2
    sum_2 = (
        2.0
        + 2.0 * attenuation_beta
        + 2.0 * attenuation_beta * term_2
        + 2.0 * attenuation_beta_squared
        + 2.0 * attenuation_beta_squared_cubed
        + 2.0 * attenuation_beta_squared_cubed * term_2
        + 2.0 * attenuation_beta_squared_squared
        + 2.0 * attenuation_beta_squared_squared * term_2
        + 2.0 * product_11
        + 2.0 * product_11 * term_2
        + 2.0 * product_3
        + 2.0 * product_3 * term_2
        + 2.0 * product_8
        + 2.0 * product_8 * term_2
        + 2.0 * term_2
        + product_1
        + product_10
        + product_12
        + product_2
        + product_4
        + product_5
        + product_6
        + product_7
        + product_9
    )
    part_00_cos_beta2_cos_epsilon2 = (
        0.25 * r_squared * shortfall_beta * sum_1 * term_1 * term_3
        + 0.25 * shortfall_beta * sigma_r_squared * sum_2 * term_1 * term_3
    )
    product_13 = attenuation_epsilon * attenuation_epsilon_squared * attenuation_epsilon_squared**2
    product_14 = attenuation_epsilon * attenuation_epsilon_squared
    attenuation_epsilon_squared_squared = attenuation_epsilon_squared**2
    product_15 = attenuation_epsilon * attenuation_epsilon_squared**2
    sum_3 = (
        1.0
        + attenuation_beta
        + attenuation_beta * attenuation_epsilon
        + attenuation_beta * attenuation_epsilon_squared
        + attenuation_beta * attenuation_epsilon_squared_cubed
        + attenuation_beta * attenuation_epsilon_squared_squared
        + attenuation_beta * product_13
        + attenuation_beta * product_14
        + attenuation_beta * product_15
        + attenuation_beta_squared
        + attenuation_beta_squared * attenuation_epsilon
        + attenuation_beta_squared * attenuation_epsilon_squared_cubed
        + attenuation_beta_squared * product_13
        + attenuation_beta_squared_cubed
        + attenuation_beta_squared_cubed * attenuation_epsilon
        + attenuation_beta_squared_cubed * attenuation_epsilon_squared
        + attenuation_beta_squared_cubed * attenuation_epsilon_squared_cubed
        + attenuation_beta_squared_cubed * attenuation_epsilon_squared_squared
        + attenuation_beta_squared_cubed * product_13
        + attenuation_beta_squared_cubed * product_14
        + attenuation_beta_squared_cubed * product_15
        + attenuation_beta_squared_squared
        + attenuation_beta_squared_squared * attenuation_epsilon
        + attenuation_beta_squared_squared * attenuation_epsilon_squared_cubed
        + attenuation_beta_squared_squared * product_13
        + attenuation_epsilon
        + attenuation_epsilon * product_11
        + attenuation_epsilon * product_3
        + attenuation_epsilon * product_8
        + attenuation_epsilon_squared
        + attenuation_epsilon_squared * product_11
        + attenuation_epsilon_squared_cubed
        + attenuation_epsilon_squared_cubed * product_11
        + attenuation_epsilon_squared_cubed * product_3
        + attenuation_epsilon_squared_cubed * product_8
        + attenuation_epsilon_squared_squared
        + attenuation_epsilon_squared_squared * product_11
        + product_11
        + product_11 * product_13
        + product_11 * product_14
        + product_11 * product_15
        + product_13
        + product_13 * product_3
        + product_13 * product_8
        + product_14
        + product_15
        + product_3
        + product_8
    )
    sum_4 = (
        2.0
        + 2.0 * attenuation_beta
        + 2.0 * attenuation_beta * attenuation_epsilon
        + 2.0 * attenuation_beta * attenuation_epsilon_squared
        + 2.0 * attenuation_beta * attenuation_epsilon_squared_cubed
        + 2.0 * attenuation_beta * attenuation_epsilon_squared_squared
        + 2.0 * attenuation_beta * product_13
        + 2.0 * attenuation_beta * product_14
        + 2.0 * attenuation_beta * product_15
        + 2.0 * attenuation_beta_squared
        + 2.0 * attenuation_beta_squared * attenuation_epsilon
        + 2.0 * attenuation_beta_squared * attenuation_epsilon_squared_cubed
        + 2.0 * attenuation_beta_squared * product_13
        + 2.0 * attenuation_beta_squared_cubed
        + 2.0 * attenuation_beta_squared_cubed * attenuation_epsilon
        + 2.0 * attenuation_beta_squared_cubed * attenuation_epsilon_squared
        + 2.0 * attenuation_beta_squared_cubed * attenuation_epsilon_squared_cubed
        + 2.0 * attenuation_beta_squared_cubed * attenuation_epsilon_squared_squared
        + 2.0 * attenuation_beta_squared_cubed * product_13
        + 2.0 * attenuation_beta_squared_cubed * product_14
        + 2.0 * attenuation_beta_squared_cubed * product_15
        + 2.0 * attenuation_beta_squared_squared
        + 2.0 * attenuation_beta_squared_squared * attenuation_epsilon
        + 2.0 * attenuation_beta_squared_squared * attenuation_epsilon_squared_cubed
        + 2.0 * attenuation_beta_squared_squared * product_13
        + 2.0 * attenuation_epsilon
        + 2.0 * attenuation_epsilon * product_11
        + 2.0 * attenuation_epsilon * product_3
        + 2.0 * attenuation_epsilon * product_8
        + 2.0 * attenuation_epsilon_squared
        + 2.0 * attenuation_epsilon_squared * product_11
        + 2.0 * attenuation_epsilon_squared_cubed
        + 2.0 * attenuation_epsilon_squared_cubed * product_11
        + 2.0 * attenuation_epsilon_squared_cubed * product_3
        + 2.0 * attenuation_epsilon_squared_cubed * product_8
        + 2.0 * attenuation_epsilon_squared_squared
        + 2.0 * attenuation_epsilon_squared_squared * product_11
        + 2.0 * product_11
        + 2.0 * product_11 * product_13
        + 2.0 * product_11 * product_14
        + 2.0 * product_11 * product_15
        + 2.0 * product_13
        + 2.0 * product_13 * product_3
        + 2.0 * product_13 * product_8
        + 2.0 * product_14
        + 2.0 * product_15
        + 2.0 * product_3
        + 2.0 * product_8
        + attenuation_beta_squared * attenuation_epsilon_squared
        + attenuation_beta_squared * attenuation_epsilon_squared_squared
        + attenuation_beta_squared * product_14
        + attenuation_beta_squared * product_15
        + attenuation_beta_squared_squared * attenuation_epsilon_squared
        + attenuation_beta_squared_squared * attenuation_epsilon_squared_squared
        + attenuation_beta_squared_squared * product_14
        + attenuation_beta_squared_squared * product_15
        + attenuation_epsilon_squared * product_3
        + attenuation_epsilon_squared * product_8
        + attenuation_epsilon_squared_squared * product_3
        + attenuation_epsilon_squared_squared * product_8
        + product_14 * product_3
        + product_14 * product_8
        + product_15 * product_3
        + product_15 * product_8
    )
    part_00_cos_beta2_sin_epsilon2 = (
        0.25 * r_squared * shortfall_beta * shortfall_epsilon * sum_3 * term_1 * term_3
        + 0.25 * shortfall_beta * shortfall_epsilon * sigma_r_squared * sum_4 * term_1 * term_3
    )
    shortfall_beta_squared = shortfall_beta**2
    product_16 = shortfall_beta * shortfall_beta_squared**2
    term_4 = (attenuation_beta_squared**2)**2
    shortfall_epsilon_squared = shortfall_epsilon**2
    product_17 = shortfall_epsilon * shortfall_epsilon_squared**2
    shortfall_beta_squared_squared = shortfall_beta_squared**2
    shortfall_epsilon_squared_squared = shortfall_epsilon_squared**2
    product_18 = shortfall_beta * shortfall_beta_squared
    product_19 = shortfall_epsilon * shortfall_epsilon_squared
    shortfall_beta_squared_cubed = shortfall_beta_squared * shortfall_beta_squared**2
    shortfall_epsilon_squared_cubed = shortfall_epsilon_squared * shortfall_epsilon_squared**2
    product_20 = shortfall_epsilon * shortfall_epsilon_squared * shortfall_epsilon_squared**2
    product_21 = shortfall_beta * shortfall_beta_squared * shortfall_beta_squared**2
    term_5 = (shortfall_epsilon_squared**2)**2
    term_6 = (shortfall_beta_squared**2)**2
    sum_5 = (
        100.0 * product_14 * product_17 * term_4
        + 100.0 * product_16 * product_3 * term_2
        + 110.0 * attenuation_beta_squared_squared * shortfall_beta_squared_squared * term_2
        + 110.0 * attenuation_epsilon_squared_squared * shortfall_epsilon_squared_squared * term_4
        + 1248.0 * attenuation_beta_squared_cubed * product_15 * product_19 * shortfall_beta_squared
        + 1248.0 * attenuation_epsilon_squared_cubed * product_18 * product_8 * shortfall_epsilon_squared
        + 1472.0 * attenuation_beta_squared_cubed * product_14 * product_17 * shortfall_beta_squared
        + 1472.0 * attenuation_epsilon_squared_cubed * product_16 * product_3 * shortfall_epsilon_squared
        + 1548.0 * attenuation_beta_squared * product_15 * product_19 * shortfall_beta_squared_cubed
        + 1548.0 * attenuation_epsilon_squared * product_18 * product_8 * shortfall_epsilon_squared_cubed
        + 1562.0 * attenuation_beta_squared * product_14 * product_17 * shortfall_beta_squared_cubed
        + 1562.0 * attenuation_epsilon_squared * product_16 * product_3 * shortfall_epsilon_squared_cubed
        + 16.0 * attenuation_beta * product_21 * term_2
        + 16.0 * attenuation_epsilon * product_20 * term_4
        + 1720.0 * attenuation_beta_squared_cubed * attenuation_epsilon_squared_squared * shortfall_beta_squared * shortfall_epsilon_squared_squared
        + 1720.0 * attenuation_beta_squared_squared * attenuation_epsilon_squared_cubed * shortfall_beta_squared_squared * shortfall_epsilon_squared
        + 1945.0 * attenuation_beta_squared * attenuation_epsilon_squared_squared * shortfall_beta_squared_cubed * shortfall_epsilon_squared_squared
        + 1945.0 * attenuation_beta_squared_squared * attenuation_epsilon_squared * shortfall_beta_squared_squared * shortfall_epsilon_squared_cubed
        + 2.0 * term_2 * term_6
        + 2.0 * term_4 * term_5
        + 216.0 * attenuation_beta_squared * product_13 * shortfall_beta_squared_cubed * shortfall_epsilon
        + 216.0 * attenuation_epsilon_squared * product_11 * shortfall_beta * shortfall_epsilon_squared_cubed
        + 224.0 * attenuation_beta * attenuation_epsilon_squared * product_21 * shortfall_epsilon_squared_cubed
        + 224.0 * attenuation_beta * attenuation_epsilon_squared_cubed * product_21 * shortfall_epsilon_squared
        + 224.0 * attenuation_beta_squared * attenuation_epsilon * product_20 * shortfall_beta_squared_cubed
        + 224.0 * attenuation_beta_squared_cubed * attenuation_epsilon * product_20 * shortfall_beta_squared
        + 24.0 * attenuation_beta_squared_cubed * shortfall_beta_squared * term_2
        + 24.0 * attenuation_epsilon_squared_cubed * shortfall_epsilon_squared * term_4
        + 2736.0 * product_15 * product_18 * product_19 * product_8
        + 28.0 * attenuation_beta_squared * shortfall_beta_squared_cubed * term_5
        + 28.0 * attenuation_beta_squared_cubed * shortfall_beta_squared * term_5
        + 28.0 * attenuation_epsilon_squared * shortfall_epsilon_squared_cubed * term_6
        + 28.0 * attenuation_epsilon_squared_cubed * shortfall_epsilon_squared * term_6
        + 288.0 * product_11 * product_15 * product_19 * shortfall_beta
        + 288.0 * product_13 * product_18 * product_8 * shortfall_epsilon
        + 3016.0 * product_14 * product_17 * product_18 * product_8
        + 3016.0 * product_15 * product_16 * product_19 * product_3
        + 3100.0 * product_14 * product_16 * product_17 * product_3
        + 3620.0 * attenuation_beta_squared_squared * product_15 * product_19 * shortfall_beta_squared_squared
        + 3620.0 * attenuation_epsilon_squared_squared * product_18 * product_8 * shortfall_epsilon_squared_squared
        + 3830.0 * attenuation_beta_squared_squared * product_14 * product_17 * shortfall_beta_squared_squared
        + 3830.0 * attenuation_epsilon_squared_squared * product_16 * product_3 * shortfall_epsilon_squared_squared
        + 400.0 * product_11 * product_14 * product_17 * shortfall_beta
        + 400.0 * product_13 * product_16 * product_3 * shortfall_epsilon
        + 440.0 * attenuation_beta_squared_squared * product_13 * shortfall_beta_squared_squared * shortfall_epsilon
        + 440.0 * attenuation_epsilon_squared_squared * product_11 * shortfall_beta * shortfall_epsilon_squared_squared
        + 448.0 * attenuation_beta * product_14 * product_17 * product_21
        + 448.0 * attenuation_beta * product_15 * product_19 * product_21
        + 448.0 * attenuation_epsilon * product_16 * product_20 * product_3
        + 448.0 * attenuation_epsilon * product_18 * product_20 * product_8
        + 4675.0 * attenuation_beta_squared_squared * attenuation_epsilon_squared_squared * shortfall_beta_squared_squared * shortfall_epsilon_squared_squared
        + 528.0 * attenuation_beta_squared_cubed * attenuation_epsilon_squared_cubed * shortfall_beta_squared * shortfall_epsilon_squared
        + 54.0 * attenuation_beta_squared * shortfall_beta_squared_cubed * term_2
        + 54.0 * attenuation_epsilon_squared * shortfall_epsilon_squared_cubed * term_4
        + 56.0 * product_14 * product_17 * term_6
        + 56.0 * product_15 * product_19 * term_6
        + 56.0 * product_16 * product_3 * term_5
        + 56.0 * product_18 * product_8 * term_5
        + 560.0 * attenuation_beta * attenuation_epsilon_squared_squared * product_21 * shortfall_epsilon_squared_squared
        + 560.0 * attenuation_beta_squared_squared * attenuation_epsilon * product_20 * shortfall_beta_squared_squared
        + 64.0 * attenuation_beta * attenuation_epsilon * product_20 * product_21
        + 64.0 * attenuation_beta * product_13 * product_21 * shortfall_epsilon
        + 64.0 * attenuation_epsilon * product_11 * product_20 * shortfall_beta
        + 70.0 * attenuation_beta_squared_squared * shortfall_beta_squared_squared * term_5
        + 70.0 * attenuation_epsilon_squared_squared * shortfall_epsilon_squared_squared * term_6
        + 72.0 * product_15 * product_19 * term_4
        + 72.0 * product_18 * product_8 * term_2
        + 768.0 * attenuation_beta_squared * attenuation_epsilon_squared_cubed * shortfall_beta_squared_cubed * shortfall_epsilon_squared
        + 768.0 * attenuation_beta_squared_cubed * attenuation_epsilon_squared * shortfall_beta_squared * shortfall_epsilon_squared_cubed
        + 783.0 * attenuation_beta_squared * attenuation_epsilon_squared * shortfall_beta_squared_cubed * shortfall_epsilon_squared_cubed
        + 8.0 * attenuation_beta * product_21 * term_5
        + 8.0 * attenuation_epsilon * product_20 * term_6
        + 8.0 * product_11 * shortfall_beta * term_5
        + 8.0 * product_13 * shortfall_epsilon * term_6
        + 96.0 * attenuation_beta_squared_cubed * product_13 * shortfall_beta_squared * shortfall_epsilon
        + 96.0 * attenuation_epsilon_squared_cubed * product_11 * shortfall_beta * shortfall_epsilon_squared
        + term_5 * term_6
    )
    product_22 = -attenuation_beta_squared_cubed * attenuation_epsilon_squared
    sum_6 = (
        2.0
        - attenuation_beta_squared_cubed * attenuation_epsilon_squared_cubed
        + 2.0 * term_2
        + 2.0 * term_2 * term_4
        + 2.0 * term_4
        + product_1
        + product_2
        + product_22
    )
    part_00_cos_epsilon2_sin_beta2 = (
        0.25 * r_squared * sum_5 * term_1 * term_3
        + 0.25 * sigma_r_squared * sum_6 * term_1 * term_3
    )
    product_23 = -attenuation_beta_squared * product_14
    product_24 = -attenuation_beta_squared * attenuation_epsilon_squared_squared
    product_25 = -attenuation_beta_squared * product_15
    product_26 = -attenuation_beta_squared_cubed * product_14
    product_27 = -attenuation_beta_squared_cubed * attenuation_epsilon_squared_squared
    product_28 = -attenuation_beta_squared_cubed * product_15
    sum_7 = (
        1.0
        + attenuation_epsilon
        + attenuation_epsilon * term_4
        + attenuation_epsilon_squared
        + attenuation_epsilon_squared * term_4
        + attenuation_epsilon_squared_cubed
        + attenuation_epsilon_squared_cubed * term_4
        + attenuation_epsilon_squared_squared
        + attenuation_epsilon_squared_squared * term_4
        + product_1
        + product_13
        + product_13 * term_4
        + product_14
        + product_14 * term_4
        + product_15
        + product_15 * term_4
        + product_22
        + product_23
        + product_24
        + product_25
        + product_26
        + product_27
        + product_28
        + term_4
    )
    sum_8 = (
        2.0
        + 2.0 * attenuation_epsilon
        + 2.0 * attenuation_epsilon * term_4
        + 2.0 * attenuation_epsilon_squared
        + 2.0 * attenuation_epsilon_squared * term_4
        + 2.0 * attenuation_epsilon_squared_cubed
        + 2.0 * attenuation_epsilon_squared_cubed * term_4
        + 2.0 * attenuation_epsilon_squared_squared
        + 2.0 * attenuation_epsilon_squared_squared * term_4
        + 2.0 * product_13
        + 2.0 * product_13 * term_4
        + 2.0 * product_14
        + 2.0 * product_14 * term_4
        + 2.0 * product_15
        + 2.0 * product_15 * term_4
        + 2.0 * term_4
        + product_1
        + product_22
        + product_23
        + product_24
        + product_25
        + product_26
        + product_27
        + product_28
    )
    part_00_sin_beta2_sin_epsilon2 = (
        0.25 * r_squared * shortfall_epsilon * sum_7 * term_1 * term_3
        + 0.25 * shortfall_epsilon * sigma_r_squared * sum_8 * term_1 * term_3
    )
    product_29 = -12.0 * attenuation_beta * product_14 * product_17 * shortfall_beta
    product_30 = -15.0 * attenuation_epsilon_squared_squared * shortfall_beta_squared * shortfall_epsilon_squared_squared
    product_31 = -16.0 * attenuation_beta * product_13 * shortfall_beta * shortfall_epsilon
    product_32 = -16.0 * attenuation_epsilon_squared_cubed * shortfall_beta_squared * shortfall_epsilon_squared
    product_33 = -2.0 * attenuation_beta * attenuation_epsilon_squared * shortfall_beta * shortfall_epsilon_squared_cubed
    product_34 = -2.0 * shortfall_beta_squared * term_2
    product_35 = -20.0 * product_15 * product_19 * shortfall_beta_squared
    product_36 = -30.0 * attenuation_beta * attenuation_epsilon_squared_squared * shortfall_beta * shortfall_epsilon_squared_squared
    product_37 = -32.0 * attenuation_beta * attenuation_epsilon_squared_cubed * shortfall_beta * shortfall_epsilon_squared
    product_38 = -4.0 * attenuation_beta * shortfall_beta * term_2
    product_39 = -40.0 * attenuation_beta * product_15 * product_19 * shortfall_beta
    product_40 = -6.0 * product_14 * product_17 * shortfall_beta_squared
    product_41 = -8.0 * product_13 * shortfall_beta_squared * shortfall_epsilon
    product_42 = -attenuation_epsilon_squared * shortfall_beta_squared * shortfall_epsilon_squared_cubed
    sum_9 = (
        12.0 * attenuation_beta_squared * attenuation_epsilon_squared_cubed * shortfall_epsilon_squared
        + 27.0 * attenuation_beta_squared * attenuation_epsilon_squared * shortfall_epsilon_squared_cubed
        + 36.0 * attenuation_beta_squared * product_15 * product_19
        + 50.0 * attenuation_beta_squared * product_14 * product_17
        + 55.0 * attenuation_beta_squared * attenuation_epsilon_squared_squared * shortfall_epsilon_squared_squared
        + 8.0 * attenuation_beta_squared * attenuation_epsilon * product_20
        + attenuation_beta_squared * term_5
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
    )
    sum_10 = (
        106.0 * attenuation_beta_squared * product_14 * product_17
        + 125.0 * attenuation_beta_squared * attenuation_epsilon_squared_squared * shortfall_epsilon_squared_squared
        + 16.0 * attenuation_beta_squared * attenuation_epsilon * product_20
        + 2.0 * attenuation_beta_squared * term_5
        + 40.0 * attenuation_beta_squared * attenuation_epsilon_squared_cubed * shortfall_epsilon_squared
        + 55.0 * attenuation_beta_squared * attenuation_epsilon_squared * shortfall_epsilon_squared_cubed
        + 8.0 * attenuation_beta_squared * product_13 * shortfall_epsilon
        + 92.0 * attenuation_beta_squared * product_15 * product_19
        + product_12
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
    )
    part_01_cos_beta_cos_epsilon2_sin_beta = (
        0.5 * attenuation_beta_squared_squared * r_squared * sum_9 * term_3
        + 0.5 * attenuation_beta_squared_squared * sigma_r_squared * sum_10 * term_3
    )
    product_43 = -12.0 * attenuation_beta * product_14 * shortfall_beta * shortfall_epsilon_squared_squared
    product_44 = -14.0 * attenuation_epsilon_squared_cubed * shortfall_beta_squared * shortfall_epsilon
    product_45 = -15.0 * attenuation_epsilon_squared_squared * product_19 * shortfall_beta_squared
    product_46 = -2.0 * attenuation_beta * attenuation_epsilon_squared * product_17 * shortfall_beta
    product_47 = -20.0 * product_15 * shortfall_beta_squared * shortfall_epsilon_squared
    product_48 = -28.0 * attenuation_beta * attenuation_epsilon_squared_cubed * shortfall_beta * shortfall_epsilon
    product_49 = -30.0 * attenuation_beta * attenuation_epsilon_squared_squared * product_19 * shortfall_beta
    product_50 = -4.0 * product_13 * shortfall_beta_squared
    product_51 = -40.0 * attenuation_beta * product_15 * shortfall_beta * shortfall_epsilon_squared
    product_52 = -6.0 * product_14 * shortfall_beta_squared * shortfall_epsilon_squared_squared
    product_53 = -8.0 * attenuation_beta * product_13 * shortfall_beta
    product_54 = -attenuation_epsilon_squared * product_17 * shortfall_beta_squared
    sum_11 = (
        14.0 * attenuation_beta_squared * attenuation_epsilon_squared_cubed * shortfall_epsilon
        + 27.0 * attenuation_beta_squared * attenuation_epsilon_squared * product_17
        + 36.0 * attenuation_beta_squared * product_15 * shortfall_epsilon_squared
        + 4.0 * attenuation_beta_squared * product_13
        + 50.0 * attenuation_beta_squared * product_14 * shortfall_epsilon_squared_squared
        + 55.0 * attenuation_beta_squared * attenuation_epsilon_squared_squared * product_19
        + 8.0 * attenuation_beta_squared * attenuation_epsilon * shortfall_epsilon_squared_cubed
        + attenuation_beta_squared * product_20
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
    )
    sum_12 = (
        106.0 * attenuation_beta_squared * product_14 * shortfall_epsilon_squared_squared
        + 12.0 * attenuation_beta_squared * product_13
        + 125.0 * attenuation_beta_squared * attenuation_epsilon_squared_squared * product_19
        + 16.0 * attenuation_beta_squared * attenuation_epsilon * shortfall_epsilon_squared_cubed
        + 2.0 * attenuation_beta_squared * product_20
        + 42.0 * attenuation_beta_squared * attenuation_epsilon_squared_cubed * shortfall_epsilon
        + 55.0 * attenuation_beta_squared * attenuation_epsilon_squared * product_17
        + 92.0 * attenuation_beta_squared * product_15 * shortfall_epsilon_squared
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
    )
    part_01_cos_beta_sin_beta_sin_epsilon2 = (
        0.5 * attenuation_beta_squared_squared * r_squared * shortfall_epsilon * sum_11 * term_3
        + 0.5 * attenuation_beta_squared_squared * shortfall_epsilon * sigma_r_squared * sum_12 * term_3
    )
    sum_13 = (
        attenuation_epsilon_squared
        - 2.0 * attenuation_epsilon * shortfall_epsilon
        - shortfall_epsilon_squared
    )
    part_02_cos_epsilon_sin_beta_sin_epsilon = (
        (-1.0 - attenuation_epsilon) * attenuation_beta * attenuation_epsilon_squared_squared * r_squared * shortfall_epsilon
        + attenuation_beta * attenuation_epsilon_squared_squared * sigma_r_squared * sum_13
    )
    part_03_cos_epsilon_sin_beta = (
        attenuation_beta * attenuation_epsilon * r * rho * sigma_r * sigma_rdot
        + attenuation_beta * attenuation_epsilon * rdot * sigma_r_squared
    )
    sum_14 = 1.0 + attenuation_epsilon + attenuation_epsilon_squared_cubed + product_13
    sum_15 = (
        2.0
        + 2.0 * attenuation_epsilon
        + 2.0 * attenuation_epsilon_squared_cubed
        + 2.0 * product_13
        + attenuation_epsilon_squared
        + attenuation_epsilon_squared_squared
        + product_14
        + product_15
    )
    part_22_cos_epsilon2 = (
        0.5 * r_squared * shortfall_epsilon * sum_14 * term_3
        + 0.5 * shortfall_epsilon * sigma_r_squared * sum_15 * term_3
    )
    sum_16 = (
        1.0
        + 2.0 * attenuation_epsilon
        + 2.0 * attenuation_epsilon_squared
        + 2.0 * attenuation_epsilon_squared_squared
        + 2.0 * product_14
        + 2.0 * product_15
        + attenuation_epsilon_squared_cubed
    )
    sum_17 = 2.0 - attenuation_epsilon_squared - attenuation_epsilon_squared_cubed + 2.0 * term_2
    part_22_sin_epsilon2 = (
        0.5 * r_squared * shortfall_epsilon_squared * sum_16 * term_3
        + 0.5 * sigma_r_squared * sum_17 * term_3
    )
    part_23_sin_epsilon = (
        attenuation_epsilon * r * rho * sigma_r * sigma_rdot
        + attenuation_epsilon * rdot * sigma_r_squared
    )
    cos_beta_squared = cos_beta**2
    cos_epsilon_squared = cos_epsilon**2
    sin_epsilon_squared = sin_epsilon**2
    sin_beta_squared = sin_beta**2
    sigma_rdot_squared = sigma_rdot**2
    result = _empty(arguments, (4, 4))
    result[..., 0, 0] = (
        cos_beta_squared * cos_epsilon_squared * part_00_cos_beta2_cos_epsilon2
        + cos_beta_squared * part_00_cos_beta2_sin_epsilon2 * sin_epsilon_squared
        + cos_epsilon_squared * part_00_cos_epsilon2_sin_beta2 * sin_beta_squared
        + part_00_sin_beta2_sin_epsilon2 * sin_beta_squared * sin_epsilon_squared
    )
    result[..., 0, 1] = (
        cos_beta * cos_epsilon_squared * part_01_cos_beta_cos_epsilon2_sin_beta * sin_beta
        + cos_beta * part_01_cos_beta_sin_beta_sin_epsilon2 * sin_beta * sin_epsilon_squared
    )
    result[..., 0, 2] = cos_epsilon * part_02_cos_epsilon_sin_beta_sin_epsilon * sin_beta * sin_epsilon
    result[..., 0, 3] = cos_epsilon * part_03_cos_epsilon_sin_beta * sin_beta
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = (
        cos_beta_squared * cos_epsilon_squared * part_00_cos_epsilon2_sin_beta2
        + cos_beta_squared * part_00_sin_beta2_sin_epsilon2 * sin_epsilon_squared
        + cos_epsilon_squared * part_00_cos_beta2_cos_epsilon2 * sin_beta_squared
        + part_00_cos_beta2_sin_epsilon2 * sin_beta_squared * sin_epsilon_squared
    )
    result[..., 1, 2] = cos_beta * cos_epsilon * part_02_cos_epsilon_sin_beta_sin_epsilon * sin_epsilon
    result[..., 1, 3] = cos_beta * cos_epsilon * part_03_cos_epsilon_sin_beta
    result[..., 2, 0] = result[..., 0, 2]
    result[..., 2, 1] = result[..., 1, 2]
    result[..., 2, 2] = (
        cos_epsilon_squared * part_22_cos_epsilon2
        + part_22_sin_epsilon2 * sin_epsilon_squared
    )
    result[..., 2, 3] = part_23_sin_epsilon * sin_epsilon
    result[..., 3, 0] = result[..., 0, 3]
    result[..., 3, 1] = result[..., 1, 3]
    result[..., 3, 2] = result[..., 2, 3]
    result[..., 3, 3] = (
        2.0 * r * rdot * rho * sigma_r * sigma_rdot
        + 3.0 * sigma_r_squared * sigma_rdot_squared
        + 3.0 * rho**2 * sigma_r_squared * sigma_rdot_squared
        + r_squared * sigma_rdot_squared
        + rdot**2 * sigma_r_squared
    )
    return result
