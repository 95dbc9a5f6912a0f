"""NumPy functions of the quantities spherical_doppler.*.

Written by radartrack regenerate, generator 1, derivation 59949510cc001a53; not to be edited.
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

    Accuracy: at most 158 ulp anywhere in this domain with independent errors, proved for elementary functions
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
    sum_1 = 1.0 + attenuation_beta
    attenuation_beta_squared = attenuation_beta**2
    sum_2 = 1.0 + attenuation_beta_squared
    attenuation_epsilon_squared = attenuation_epsilon**2
    attenuation_epsilon_squared_squared = attenuation_epsilon_squared**2
    sum_3 = 1.0 + attenuation_epsilon_squared_squared
    r_squared = r**2
    sigma_r_squared = sigma_r**2
    part_00_cos_beta2_cos_epsilon2 = (
        0.25 * r_squared * shortfall_beta * sum_1 * sum_2 * sum_3
        + 0.25 * shortfall_beta * sigma_r_squared * sum_1 * sum_2 * sum_3
    )
    sum_4 = 1.0 + attenuation_epsilon
    sum_5 = 1.0 + attenuation_epsilon_squared
    part_00_cos_beta2_sin_epsilon2 = (
        0.25 * r_squared * shortfall_beta * shortfall_epsilon * sum_1 * sum_2 * sum_4 * sum_5
        + 0.25 * shortfall_beta * shortfall_epsilon * sigma_r_squared * sum_1 * sum_2 * sum_4 * sum_5
    )
    shortfall_beta_squared = shortfall_beta**2
    attenuation_beta_squared_squared = attenuation_beta_squared**2
    shortfall_epsilon_squared = shortfall_epsilon**2
    product_1 = shortfall_epsilon * shortfall_epsilon_squared
    product_2 = shortfall_beta * shortfall_beta_squared
    shortfall_epsilon_squared_squared = shortfall_epsilon_squared**2
    shortfall_beta_squared_squared = shortfall_beta_squared**2
    product_3 = attenuation_epsilon * attenuation_epsilon_squared
    product_4 = attenuation_beta * attenuation_beta_squared
    sum_6 = (
        2.0 * attenuation_beta * attenuation_epsilon_squared_squared * product_2
        + 2.0 * attenuation_beta_squared * attenuation_epsilon_squared_squared * shortfall_beta_squared
        + 2.0 * attenuation_beta_squared_squared * attenuation_epsilon * product_1
        + 2.0 * attenuation_beta_squared_squared * attenuation_epsilon_squared * shortfall_epsilon_squared
        + 1.5 * attenuation_beta_squared * shortfall_beta_squared * shortfall_epsilon_squared_squared
        + 1.5 * attenuation_epsilon_squared * shortfall_beta_squared_squared * shortfall_epsilon_squared
        + 4.0 * attenuation_beta * attenuation_epsilon * product_1 * product_2
        + 4.0 * attenuation_beta * product_2 * product_3 * shortfall_epsilon
        + 4.0 * attenuation_beta_squared * product_3 * shortfall_beta_squared * shortfall_epsilon
        + 4.0 * attenuation_epsilon * product_1 * product_4 * shortfall_beta
        + 4.0 * attenuation_epsilon_squared * product_4 * shortfall_beta * shortfall_epsilon_squared
        + 6.0 * attenuation_beta * attenuation_epsilon_squared * product_2 * shortfall_epsilon_squared
        + 6.0 * attenuation_beta_squared * attenuation_epsilon * product_1 * shortfall_beta_squared
        + 8.0 * attenuation_beta_squared * attenuation_epsilon_squared * shortfall_beta_squared * shortfall_epsilon_squared
        + attenuation_beta * product_2 * shortfall_epsilon_squared_squared
        + 0.5 * attenuation_beta_squared_squared * shortfall_epsilon_squared_squared
        + attenuation_epsilon * product_1 * shortfall_beta_squared_squared
        + 0.5 * attenuation_epsilon_squared_squared * shortfall_beta_squared_squared
        + product_3 * shortfall_beta_squared_squared * shortfall_epsilon
        + product_4 * shortfall_beta * shortfall_epsilon_squared_squared
        + 0.25 * shortfall_beta_squared_squared * shortfall_epsilon_squared_squared
    )
    sum_7 = (
        0.25
        + 0.25 * attenuation_beta_squared_squared * attenuation_epsilon_squared_squared
        + 0.25 * attenuation_beta_squared_squared
        + 0.25 * attenuation_epsilon_squared_squared
    )
    part_00_cos_epsilon2_sin_beta2 = r_squared * sum_6 + sigma_r_squared * sum_7
    sum_8 = 1.0 + attenuation_beta_squared_squared
    part_00_sin_beta2_sin_epsilon2 = (
        0.25 * r_squared * shortfall_epsilon * sum_4 * sum_5 * sum_8
        + 0.25 * shortfall_epsilon * sigma_r_squared * sum_4 * sum_5 * sum_8
    )
    sum_9 = (
        4.0 * attenuation_beta_squared * attenuation_epsilon * product_1
        - 2.0 * attenuation_epsilon_squared * shortfall_beta_squared * shortfall_epsilon_squared
        - 2.0 * attenuation_epsilon_squared_squared * shortfall_beta_squared
        - 4.0 * attenuation_beta * attenuation_epsilon_squared * shortfall_beta * shortfall_epsilon_squared
        - 4.0 * attenuation_beta * attenuation_epsilon_squared_squared * shortfall_beta
        - 4.0 * product_3 * shortfall_beta_squared * shortfall_epsilon
        - 8.0 * attenuation_beta * product_3 * shortfall_beta * shortfall_epsilon
        + 4.0 * attenuation_beta_squared * attenuation_epsilon_squared * shortfall_epsilon_squared
        + attenuation_beta_squared * shortfall_epsilon_squared_squared
    )
    part_01_cos_beta_cos_epsilon2_sin_beta = (
        0.5 * attenuation_beta_squared * r_squared * sum_9
        + 0.5 * attenuation_beta_squared_squared * sigma_r_squared * sum_3
    )
    sum_10 = 1.0 + attenuation_epsilon + attenuation_epsilon_squared + product_3
    part_01_cos_beta_sin_beta_sin_epsilon2 = (
        0.5 * attenuation_beta_squared_squared * r_squared * shortfall_epsilon * sum_10
        + 0.5 * attenuation_beta_squared_squared * shortfall_epsilon * sigma_r_squared * sum_10
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
        0.5 * r_squared * shortfall_epsilon * sum_10
        + 0.5 * shortfall_epsilon * sigma_r_squared * sum_10
    )
    sum_11 = 1.0 + 2.0 * attenuation_epsilon + attenuation_epsilon_squared
    sum_12 = 0.5 + 0.5 * attenuation_epsilon_squared_squared
    part_22_sin_epsilon2 = 0.5 * r_squared * shortfall_epsilon_squared * sum_11 + sigma_r_squared * sum_12
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

    Accuracy: at most 797 ulp anywhere in this domain with independent errors, proved for elementary functions
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
    sum_1 = 1.0 + attenuation_beta
    product_1 = -attenuation_beta * attenuation_epsilon
    attenuation_epsilon_squared = attenuation_epsilon**2
    product_2 = attenuation_epsilon * attenuation_epsilon_squared
    product_3 = -attenuation_beta * product_2
    attenuation_beta_squared = attenuation_beta**2
    attenuation_epsilon_squared_squared = attenuation_epsilon_squared**2
    r_squared = r**2
    sum_2 = (
        1.0
        + attenuation_beta_squared
        + attenuation_beta_squared * attenuation_epsilon_squared_squared
        + attenuation_epsilon_squared_squared
        + product_1
        + product_3
    )
    sigma_r_squared = sigma_r**2
    sum_3 = (
        2.0
        + 2.0 * attenuation_beta_squared
        + 2.0 * attenuation_beta_squared * attenuation_epsilon_squared_squared
        + 2.0 * attenuation_epsilon_squared_squared
        + product_1
        + product_3
    )
    part_00_cos_beta2_cos_epsilon2 = (
        0.25 * r_squared * shortfall_beta * sum_1 * sum_2
        + 0.25 * shortfall_beta * sigma_r_squared * sum_1 * sum_3
    )
    sum_4 = 1.0 + attenuation_epsilon
    sum_5 = (
        1.0
        + attenuation_beta_squared
        + attenuation_beta_squared * attenuation_epsilon_squared
        + attenuation_epsilon_squared
        + product_1
    )
    sum_6 = (
        2.0
        + 2.0 * attenuation_beta_squared
        + 2.0 * attenuation_beta_squared * attenuation_epsilon_squared
        + 2.0 * attenuation_epsilon_squared
        + product_1
    )
    part_00_cos_beta2_sin_epsilon2 = (
        0.25 * r_squared * shortfall_beta * shortfall_epsilon * sum_1 * sum_4 * sum_5
        + 0.25 * shortfall_beta * shortfall_epsilon * sigma_r_squared * sum_1 * sum_4 * sum_6
    )
    shortfall_beta_squared = shortfall_beta**2
    product_4 = shortfall_beta * shortfall_beta_squared
    shortfall_epsilon_squared = shortfall_epsilon**2
    product_5 = shortfall_epsilon * shortfall_epsilon_squared
    shortfall_epsilon_squared_squared = shortfall_epsilon_squared**2
    product_6 = attenuation_beta * attenuation_beta_squared
    attenuation_beta_squared_squared = attenuation_beta_squared**2
    shortfall_beta_squared_squared = shortfall_beta_squared**2
    sum_7 = (
        3.75 * attenuation_beta * attenuation_epsilon * product_4 * product_5
        + 5.25 * attenuation_beta * attenuation_epsilon_squared * product_4 * shortfall_epsilon_squared
        + 5.25 * attenuation_beta_squared * attenuation_epsilon * product_5 * shortfall_beta_squared
        + 6.75 * attenuation_beta_squared * attenuation_epsilon_squared * shortfall_beta_squared * shortfall_epsilon_squared
        + 1.5 * attenuation_beta * attenuation_epsilon_squared_squared * product_4
        + 3.0 * attenuation_beta * product_2 * product_4 * shortfall_epsilon
        + 1.5 * attenuation_beta_squared * attenuation_epsilon_squared_squared * shortfall_beta_squared
        + 3.0 * attenuation_beta_squared * product_2 * shortfall_beta_squared * shortfall_epsilon
        + 1.5 * attenuation_beta_squared * shortfall_beta_squared * shortfall_epsilon_squared_squared
        + 1.5 * attenuation_beta_squared_squared * attenuation_epsilon * product_5
        + 1.5 * attenuation_beta_squared_squared * attenuation_epsilon_squared * shortfall_epsilon_squared
        + 3.0 * attenuation_epsilon * product_5 * product_6 * shortfall_beta
        + 3.0 * attenuation_epsilon_squared * product_6 * shortfall_beta * shortfall_epsilon_squared
        + 1.5 * attenuation_epsilon_squared * shortfall_beta_squared_squared * shortfall_epsilon_squared
        + attenuation_beta * product_4 * shortfall_epsilon_squared_squared
        + 0.5 * attenuation_beta_squared_squared * shortfall_epsilon_squared_squared
        + attenuation_epsilon * product_5 * shortfall_beta_squared_squared
        + 0.5 * attenuation_epsilon_squared_squared * shortfall_beta_squared_squared
        + product_2 * shortfall_beta_squared_squared * shortfall_epsilon
        + product_6 * shortfall_beta * shortfall_epsilon_squared_squared
        + 0.25 * shortfall_beta_squared_squared * shortfall_epsilon_squared_squared
    )
    sum_8 = (
        0.5
        - 0.25 * attenuation_beta * attenuation_epsilon
        - 0.25 * attenuation_beta * product_2
        - 0.25 * attenuation_epsilon * product_6
        - 0.25 * product_2 * product_6
        + 0.5 * attenuation_beta_squared_squared * attenuation_epsilon_squared_squared
        + 0.5 * attenuation_beta_squared_squared
        + 0.5 * attenuation_epsilon_squared_squared
    )
    part_00_cos_epsilon2_sin_beta2 = r_squared * sum_7 + sigma_r_squared * sum_8
    product_7 = -attenuation_epsilon * product_6
    sum_9 = (
        1.0
        + attenuation_beta_squared_squared
        + attenuation_beta_squared_squared * attenuation_epsilon_squared
        + attenuation_epsilon_squared
        + product_1
        + product_7
    )
    sum_10 = (
        2.0
        + 2.0 * attenuation_beta_squared_squared
        + 2.0 * attenuation_beta_squared_squared * attenuation_epsilon_squared
        + 2.0 * attenuation_epsilon_squared
        + product_1
        + product_7
    )
    part_00_sin_beta2_sin_epsilon2 = (
        0.25 * r_squared * shortfall_epsilon * sum_4 * sum_9
        + 0.25 * shortfall_epsilon * sigma_r_squared * sum_10 * sum_4
    )
    product_8 = -2.0 * attenuation_epsilon_squared_squared * shortfall_beta
    product_9 = -3.0 * attenuation_epsilon_squared * shortfall_beta * shortfall_epsilon_squared
    product_10 = -4.0 * product_2 * shortfall_beta * shortfall_epsilon
    product_11 = -attenuation_epsilon * product_5 * shortfall_beta
    sum_11 = (
        3.0 * attenuation_beta * attenuation_epsilon * product_5
        + 3.0 * attenuation_beta * attenuation_epsilon_squared * shortfall_epsilon_squared
        + attenuation_beta * shortfall_epsilon_squared_squared
        + product_10
        + product_11
        + product_8
        + product_9
    )
    sum_12 = (
        2.0 * attenuation_beta * attenuation_epsilon_squared_squared
        + 2.0 * attenuation_beta * shortfall_epsilon_squared_squared
        + 4.0 * attenuation_beta * product_2 * shortfall_epsilon
        + 7.0 * attenuation_beta * attenuation_epsilon * product_5
        + 9.0 * attenuation_beta * attenuation_epsilon_squared * shortfall_epsilon_squared
        + product_10
        + product_11
        + product_8
        + product_9
    )
    part_01_cos_beta_cos_epsilon2_sin_beta = (
        0.5 * product_6 * r_squared * sum_11
        + 0.5 * product_6 * sigma_r_squared * sum_12
    )
    product_12 = -2.0 * product_2 * shortfall_beta
    product_13 = -3.0 * attenuation_epsilon_squared * shortfall_beta * shortfall_epsilon
    product_14 = -attenuation_epsilon * shortfall_beta * shortfall_epsilon_squared
    sum_13 = (
        2.0 * attenuation_beta * product_2
        + 3.0 * attenuation_beta * attenuation_epsilon * shortfall_epsilon_squared
        + 3.0 * attenuation_beta * attenuation_epsilon_squared * shortfall_epsilon
        + attenuation_beta * product_5
        + product_12
        + product_13
        + product_14
    )
    sum_14 = (
        2.0 * attenuation_beta * product_5
        + 6.0 * attenuation_beta * product_2
        + 7.0 * attenuation_beta * attenuation_epsilon * shortfall_epsilon_squared
        + 9.0 * attenuation_beta * attenuation_epsilon_squared * shortfall_epsilon
        + product_12
        + product_13
        + product_14
    )
    part_01_cos_beta_sin_beta_sin_epsilon2 = (
        0.5 * product_6 * r_squared * shortfall_epsilon * sum_13
        + 0.5 * product_6 * shortfall_epsilon * sigma_r_squared * sum_14
    )
    sum_15 = attenuation_epsilon - shortfall_epsilon
    part_02_cos_epsilon_sin_beta_sin_epsilon = (
        attenuation_beta * product_2 * sigma_r_squared * sum_15
        - attenuation_beta * product_2 * r_squared * shortfall_epsilon
    )
    part_03_cos_epsilon_sin_beta = (
        attenuation_beta * attenuation_epsilon * r * rho * sigma_r * sigma_rdot
        + attenuation_beta * attenuation_epsilon * rdot * sigma_r_squared
    )
    sum_16 = 2.0 + 2.0 * product_2 + attenuation_epsilon + attenuation_epsilon_squared
    part_22_cos_epsilon2 = (
        0.5 * (1.0 + product_2) * r_squared * shortfall_epsilon
        + 0.5 * shortfall_epsilon * sigma_r_squared * sum_16
    )
    sum_17 = 1.0 + attenuation_epsilon + attenuation_epsilon_squared
    sum_18 = 1.0 - 0.5 * attenuation_epsilon - 0.5 * product_2 + attenuation_epsilon_squared_squared
    part_22_sin_epsilon2 = 0.5 * r_squared * shortfall_epsilon_squared * sum_17 + sigma_r_squared * sum_18
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

    Accuracy: at most 302 ulp anywhere in this domain with independent errors, proved for elementary functions
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
    sum_1 = 1.0 + attenuation_beta
    attenuation_beta_squared = attenuation_beta**2
    sum_2 = 1.0 + attenuation_beta_squared
    attenuation_epsilon_squared = attenuation_epsilon**2
    attenuation_epsilon_squared_squared = attenuation_epsilon_squared**2
    sum_3 = 1.0 + attenuation_epsilon_squared_squared
    r_squared = r**2
    sigma_r_squared = sigma_r**2
    part_00_cos_beta2_cos_epsilon2 = (
        0.25 * r_squared * shortfall_beta * sum_1 * sum_2 * sum_3
        + 0.25 * shortfall_beta * sigma_r_squared * sum_1 * sum_2 * sum_3
    )
    sum_4 = 1.0 + attenuation_epsilon
    sum_5 = 1.0 + attenuation_epsilon_squared
    part_00_cos_beta2_sin_epsilon2 = (
        0.25 * r_squared * shortfall_beta * shortfall_epsilon * sum_1 * sum_2 * sum_4 * sum_5
        + 0.25 * shortfall_beta * shortfall_epsilon * sigma_r_squared * sum_1 * sum_2 * sum_4 * sum_5
    )
    term_1 = 1.0 / attenuation_beta**2
    shortfall_beta_squared = shortfall_beta**2
    product_1 = attenuation_beta_squared * attenuation_epsilon_squared
    product_2 = attenuation_beta_squared * attenuation_epsilon_squared_squared
    attenuation_beta_squared_squared = attenuation_beta_squared**2
    product_3 = attenuation_beta_squared_squared * attenuation_epsilon_squared
    product_4 = attenuation_beta_squared_squared * attenuation_epsilon_squared_squared
    term_2 = 1.0 / attenuation_epsilon**2
    sum_6 = 4.0 + product_1 + product_2 + product_3 + product_4
    shortfall_epsilon_squared = shortfall_epsilon**2
    sum_7 = 2.0 + attenuation_epsilon_squared
    product_5 = 0.5 * shortfall_epsilon_squared * sum_4**2 * sum_7 * term_2
    sum_8 = (
        product_5
        + 0.25 * shortfall_beta * shortfall_epsilon * sum_1 * sum_4 * sum_6 * term_1 * term_2
        + 0.5 * (2.0 + attenuation_beta_squared) * shortfall_beta_squared * sum_1**2 * term_1
    )
    sum_9 = (
        0.25
        + 0.25 * attenuation_beta_squared_squared * attenuation_epsilon_squared_squared
        + 0.25 * attenuation_beta_squared_squared
        + 0.25 * attenuation_epsilon_squared_squared
    )
    part_00_cos_epsilon2_sin_beta2 = r_squared * sum_8 + sigma_r_squared * sum_9
    sum_10 = 1.0 + attenuation_beta_squared_squared
    part_00_sin_beta2_sin_epsilon2 = (
        0.25 * r_squared * shortfall_epsilon * sum_10 * sum_4 * sum_5
        + 0.25 * shortfall_epsilon * sigma_r_squared * sum_10 * sum_4 * sum_5
    )
    sum_11 = (
        attenuation_beta_squared_squared
        - 2.0 * attenuation_beta * attenuation_beta_squared * shortfall_beta
        - 4.0 * attenuation_beta * shortfall_beta * shortfall_beta_squared
        - 5.0 * attenuation_beta_squared * shortfall_beta_squared
        - shortfall_beta_squared**2
    )
    sum_12 = 2.0 + product_1 + product_2 + product_3 + product_4
    sum_13 = (
        product_5
        - shortfall_beta * sum_1 * sum_11 * term_1
        + 0.5 * shortfall_beta * shortfall_epsilon * sum_1 * sum_12 * sum_4 * term_1 * term_2
    )
    part_01_cos_beta_cos_epsilon2_sin_beta = (
        0.5 * attenuation_beta_squared_squared * sigma_r_squared * sum_3
        + r_squared * sum_13
    )
    product_6 = attenuation_epsilon * attenuation_epsilon_squared
    sum_14 = 1.0 + attenuation_epsilon + attenuation_epsilon_squared + product_6
    part_01_cos_beta_sin_beta_sin_epsilon2 = (
        0.5 * attenuation_beta_squared_squared * r_squared * shortfall_epsilon * sum_14
        + 0.5 * attenuation_beta_squared_squared * shortfall_epsilon * sigma_r_squared * sum_14
    )
    sum_15 = (
        attenuation_epsilon_squared_squared
        - 2.0 * product_6 * shortfall_epsilon
        - 4.0 * attenuation_epsilon * shortfall_epsilon * shortfall_epsilon_squared
        - 5.0 * attenuation_epsilon_squared * shortfall_epsilon_squared
        - shortfall_epsilon_squared**2
    )
    term_3 = 1.0 / attenuation_beta
    sum_16 = (
        1.0
        + attenuation_beta * attenuation_epsilon_squared
        + attenuation_beta * attenuation_epsilon_squared_squared
    )
    sum_17 = (
        shortfall_beta * shortfall_epsilon * sum_16 * sum_4 * term_2 * term_3
        - shortfall_epsilon * sum_15 * sum_4 * term_2
    )
    part_02_cos_epsilon_sin_beta_sin_epsilon = (
        attenuation_beta * attenuation_epsilon_squared_squared * sigma_r_squared
        + r_squared * sum_17
    )
    term_4 = 1.0 / attenuation_epsilon
    sum_18 = (
        attenuation_epsilon_squared
        - 2.0 * shortfall_epsilon_squared
        - 4.0 * attenuation_epsilon * shortfall_epsilon
    )
    sum_19 = 2.0 + 3.0 * attenuation_beta * attenuation_epsilon_squared
    sum_20 = sum_18 * term_4 - shortfall_beta * sum_19 * term_3 * term_4
    part_03_cos_epsilon_sin_beta = (
        attenuation_beta * attenuation_epsilon * rdot * sigma_r_squared
        + r * rho * sigma_r * sigma_rdot * sum_20
    )
    part_22_cos_epsilon2 = (
        0.5 * r_squared * shortfall_epsilon * sum_14
        + 0.5 * shortfall_epsilon * sigma_r_squared * sum_14
    )
    sum_21 = (
        2.0
        + 2.0 * product_6
        + 3.0 * attenuation_epsilon_squared
        + 4.0 * attenuation_epsilon
        + attenuation_epsilon_squared_squared
    )
    sum_22 = 0.5 + 0.5 * attenuation_epsilon_squared_squared
    part_22_sin_epsilon2 = (
        0.5 * r_squared * shortfall_epsilon_squared * sum_21 * term_2
        + sigma_r_squared * sum_22
    )
    part_23_sin_epsilon = (
        attenuation_epsilon * rdot * sigma_r_squared
        + r * rho * sigma_r * sigma_rdot * sum_18 * term_4
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

    Accuracy: at most 158 ulp anywhere in this domain with independent errors, proved for elementary functions
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
    sum_1 = 1.0 + attenuation_beta
    attenuation_beta_squared = attenuation_beta**2
    sum_2 = 1.0 + attenuation_beta_squared
    attenuation_epsilon_squared = attenuation_epsilon**2
    attenuation_epsilon_squared_squared = attenuation_epsilon_squared**2
    sum_3 = 1.0 + attenuation_epsilon_squared_squared
    r_squared = r**2
    sigma_r_squared = sigma_r**2
    part_00_cos_beta2_cos_epsilon2 = (
        0.25 * r_squared * shortfall_beta * sum_1 * sum_2 * sum_3
        + 0.25 * shortfall_beta * sigma_r_squared * sum_1 * sum_2 * sum_3
    )
    sum_4 = 1.0 + attenuation_epsilon
    sum_5 = 1.0 + attenuation_epsilon_squared
    part_00_cos_beta2_sin_epsilon2 = (
        0.25 * r_squared * shortfall_beta * shortfall_epsilon * sum_1 * sum_2 * sum_4 * sum_5
        + 0.25 * shortfall_beta * shortfall_epsilon * sigma_r_squared * sum_1 * sum_2 * sum_4 * sum_5
    )
    shortfall_beta_squared = shortfall_beta**2
    attenuation_beta_squared_squared = attenuation_beta_squared**2
    shortfall_epsilon_squared = shortfall_epsilon**2
    product_1 = shortfall_epsilon * shortfall_epsilon_squared
    product_2 = shortfall_beta * shortfall_beta_squared
    shortfall_epsilon_squared_squared = shortfall_epsilon_squared**2
    shortfall_beta_squared_squared = shortfall_beta_squared**2
    product_3 = attenuation_epsilon * attenuation_epsilon_squared
    product_4 = attenuation_beta * attenuation_beta_squared
    sum_6 = (
        2.0 * attenuation_beta * attenuation_epsilon_squared_squared * product_2
        + 2.0 * attenuation_beta_squared * attenuation_epsilon_squared_squared * shortfall_beta_squared
        + 2.0 * attenuation_beta_squared_squared * attenuation_epsilon * product_1
        + 2.0 * attenuation_beta_squared_squared * attenuation_epsilon_squared * shortfall_epsilon_squared
        + 1.5 * attenuation_beta_squared * shortfall_beta_squared * shortfall_epsilon_squared_squared
        + 1.5 * attenuation_epsilon_squared * shortfall_beta_squared_squared * shortfall_epsilon_squared
        + 4.0 * attenuation_beta * attenuation_epsilon * product_1 * product_2
        + 4.0 * attenuation_beta * product_2 * product_3 * shortfall_epsilon
        + 4.0 * attenuation_beta_squared * product_3 * shortfall_beta_squared * shortfall_epsilon
        + 4.0 * attenuation_epsilon * product_1 * product_4 * shortfall_beta
        + 4.0 * attenuation_epsilon_squared * product_4 * shortfall_beta * shortfall_epsilon_squared
        + 6.0 * attenuation_beta * attenuation_epsilon_squared * product_2 * shortfall_epsilon_squared
        + 6.0 * attenuation_beta_squared * attenuation_epsilon * product_1 * shortfall_beta_squared
        + 8.0 * attenuation_beta_squared * attenuation_epsilon_squared * shortfall_beta_squared * shortfall_epsilon_squared
        + attenuation_beta * product_2 * shortfall_epsilon_squared_squared
        + 0.5 * attenuation_beta_squared_squared * shortfall_epsilon_squared_squared
        + attenuation_epsilon * product_1 * shortfall_beta_squared_squared
        + 0.5 * attenuation_epsilon_squared_squared * shortfall_beta_squared_squared
        + product_3 * shortfall_beta_squared_squared * shortfall_epsilon
        + product_4 * shortfall_beta * shortfall_epsilon_squared_squared
        + 0.25 * shortfall_beta_squared_squared * shortfall_epsilon_squared_squared
    )
    sum_7 = (
        0.25
        + 0.25 * attenuation_beta_squared_squared * attenuation_epsilon_squared_squared
        + 0.25 * attenuation_beta_squared_squared
        + 0.25 * attenuation_epsilon_squared_squared
    )
    part_00_cos_epsilon2_sin_beta2 = r_squared * sum_6 + sigma_r_squared * sum_7
    sum_8 = 1.0 + attenuation_beta_squared_squared
    part_00_sin_beta2_sin_epsilon2 = (
        0.25 * r_squared * shortfall_epsilon * sum_4 * sum_5 * sum_8
        + 0.25 * shortfall_epsilon * sigma_r_squared * sum_4 * sum_5 * sum_8
    )
    sum_9 = (
        4.0 * attenuation_beta_squared * attenuation_epsilon * product_1
        - 2.0 * attenuation_epsilon_squared * shortfall_beta_squared * shortfall_epsilon_squared
        - 2.0 * attenuation_epsilon_squared_squared * shortfall_beta_squared
        - 4.0 * attenuation_beta * attenuation_epsilon_squared * shortfall_beta * shortfall_epsilon_squared
        - 4.0 * attenuation_beta * attenuation_epsilon_squared_squared * shortfall_beta
        - 4.0 * product_3 * shortfall_beta_squared * shortfall_epsilon
        - 8.0 * attenuation_beta * product_3 * shortfall_beta * shortfall_epsilon
        + 4.0 * attenuation_beta_squared * attenuation_epsilon_squared * shortfall_epsilon_squared
        + attenuation_beta_squared * shortfall_epsilon_squared_squared
    )
    part_01_cos_beta_cos_epsilon2_sin_beta = (
        0.5 * attenuation_beta_squared * r_squared * sum_9
        + 0.5 * attenuation_beta_squared_squared * sigma_r_squared * sum_3
    )
    sum_10 = 1.0 + attenuation_epsilon + attenuation_epsilon_squared + product_3
    part_01_cos_beta_sin_beta_sin_epsilon2 = (
        0.5 * attenuation_beta_squared_squared * r_squared * shortfall_epsilon * sum_10
        + 0.5 * attenuation_beta_squared_squared * shortfall_epsilon * sigma_r_squared * sum_10
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
        0.5 * r_squared * shortfall_epsilon * sum_10
        + 0.5 * shortfall_epsilon * sigma_r_squared * sum_10
    )
    sum_11 = 1.0 + 2.0 * attenuation_epsilon + attenuation_epsilon_squared
    sum_12 = 0.5 + 0.5 * attenuation_epsilon_squared_squared
    part_22_sin_epsilon2 = 0.5 * r_squared * shortfall_epsilon_squared * sum_11 + sigma_r_squared * sum_12
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

    Accuracy: at most 726 ulp anywhere in this domain with independent errors, proved for elementary functions
    within 1 ulp (float64).
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
    predicted_sigma_r_squared = predicted_sigma_r**2
    term_1 = 1.0 / attenuation_beta
    term_2 = 1.0 / attenuation_epsilon
    attenuation_predicted_beta_squared = attenuation_predicted_beta**2
    attenuation_predicted_beta_squared_squared = attenuation_predicted_beta_squared**2
    sum_1 = 1.0 + attenuation_beta * attenuation_predicted_beta_squared_squared
    attenuation_epsilon_squared = attenuation_epsilon**2
    attenuation_predicted_epsilon_squared = attenuation_predicted_epsilon**2
    attenuation_predicted_epsilon_squared_squared = attenuation_predicted_epsilon_squared**2
    product_1 = attenuation_epsilon_squared * attenuation_predicted_epsilon_squared_squared
    sum_2 = 1.0 + product_1
    product_2 = attenuation_predicted_epsilon * attenuation_predicted_epsilon_squared
    shortfall_predicted_epsilon_squared = shortfall_predicted_epsilon**2
    product_3 = shortfall_predicted_epsilon * shortfall_predicted_epsilon_squared
    shortfall_predicted_epsilon_squared_squared = shortfall_predicted_epsilon_squared**2
    sum_3 = (
        4.0 * attenuation_epsilon * attenuation_predicted_epsilon * product_3
        + 4.0 * attenuation_epsilon * product_2 * shortfall_predicted_epsilon
        + 4.0 * attenuation_predicted_epsilon * product_3 * shortfall_epsilon
        + 4.0 * product_2 * shortfall_epsilon * shortfall_predicted_epsilon
        + 6.0 * attenuation_epsilon * attenuation_predicted_epsilon_squared * shortfall_predicted_epsilon_squared
        + 6.0 * attenuation_predicted_epsilon_squared * shortfall_epsilon * shortfall_predicted_epsilon_squared
        + attenuation_epsilon * shortfall_predicted_epsilon_squared_squared
        + attenuation_predicted_epsilon_squared_squared * shortfall_epsilon
        + shortfall_epsilon * shortfall_predicted_epsilon_squared_squared
    )
    sum_4 = 1.0 + attenuation_predicted_beta
    sum_5 = 1.0 + attenuation_predicted_beta_squared
    sum_6 = (
        0.25 * shortfall_beta * sum_1 * sum_2 * term_1 * term_2
        + 0.25 * shortfall_epsilon * shortfall_predicted_beta * sum_3 * sum_4 * sum_5 * term_2
    )
    r_squared = r**2
    shortfall_predicted_beta_squared = shortfall_predicted_beta**2
    sum_7 = (
        2.0 * attenuation_beta * attenuation_predicted_beta * shortfall_predicted_beta
        + 2.0 * attenuation_predicted_beta * shortfall_beta * shortfall_predicted_beta
        + attenuation_beta * shortfall_predicted_beta_squared
        + attenuation_predicted_beta_squared * shortfall_beta
        + shortfall_beta * shortfall_predicted_beta_squared
    )
    sum_8 = 1.0 + attenuation_beta * attenuation_predicted_beta_squared
    sigma_r_squared = sigma_r**2
    part_00_cos_beta2_cos_epsilon2 = (
        predicted_sigma_r_squared * sum_6
        + r_squared * sum_6
        + 0.25 * sigma_r_squared * sum_2 * sum_7 * sum_8 * term_1 * term_2
    )
    sum_9 = (
        2.0 * attenuation_epsilon * attenuation_predicted_epsilon * shortfall_predicted_epsilon
        + 2.0 * attenuation_predicted_epsilon * shortfall_epsilon * shortfall_predicted_epsilon
        + attenuation_epsilon * shortfall_predicted_epsilon_squared
        + attenuation_predicted_epsilon_squared * shortfall_epsilon
        + shortfall_epsilon * shortfall_predicted_epsilon_squared
    )
    sum_10 = 1.0 + attenuation_epsilon * attenuation_predicted_epsilon_squared
    sum_11 = 1.0 + attenuation_epsilon * attenuation_predicted_epsilon_squared_squared
    sum_12 = (
        0.25 * shortfall_beta * sum_1 * sum_10 * sum_9 * term_1 * term_2
        + 0.25 * shortfall_epsilon * shortfall_predicted_beta * sum_11 * sum_4 * sum_5 * term_2
    )
    part_00_cos_beta2_sin_epsilon2 = (
        predicted_sigma_r_squared * sum_12
        + r_squared * sum_12
        + 0.25 * sigma_r_squared * sum_10 * sum_7 * sum_8 * sum_9 * term_1 * term_2
    )
    product_4 = attenuation_predicted_beta * attenuation_predicted_beta_squared
    product_5 = shortfall_predicted_beta * shortfall_predicted_beta_squared
    shortfall_predicted_beta_squared_squared = shortfall_predicted_beta_squared**2
    sum_13 = (
        4.0 * attenuation_beta * attenuation_predicted_beta * product_5
        + 4.0 * attenuation_beta * product_4 * shortfall_predicted_beta
        + 4.0 * attenuation_predicted_beta * product_5 * shortfall_beta
        + 4.0 * product_4 * shortfall_beta * shortfall_predicted_beta
        + 6.0 * attenuation_beta * attenuation_predicted_beta_squared * shortfall_predicted_beta_squared
        + 6.0 * attenuation_predicted_beta_squared * shortfall_beta * shortfall_predicted_beta_squared
        + attenuation_beta * shortfall_predicted_beta_squared_squared
        + attenuation_predicted_beta_squared_squared * shortfall_beta
        + shortfall_beta * shortfall_predicted_beta_squared_squared
    )
    sum_14 = 1.0 + attenuation_predicted_beta_squared_squared
    sum_15 = (
        0.25 * shortfall_beta * sum_13 * sum_2 * term_1 * term_2
        + 0.25 * shortfall_epsilon * sum_14 * sum_3 * term_2
    )
    attenuation_beta_squared = attenuation_beta**2
    product_6 = attenuation_beta_squared * attenuation_predicted_beta_squared_squared
    sum_16 = (
        1.0
        + attenuation_beta_squared * attenuation_epsilon_squared * attenuation_predicted_beta_squared_squared * attenuation_predicted_epsilon_squared_squared
        + product_1
        + product_6
    )
    part_00_cos_epsilon2_sin_beta2 = (
        predicted_sigma_r_squared * sum_15
        + r_squared * sum_15
        + 0.25 * sigma_r_squared * sum_16 * term_1 * term_2
    )
    sum_17 = 1.0 + attenuation_predicted_epsilon
    sum_18 = 1.0 + attenuation_predicted_epsilon_squared
    sum_19 = 1.0 + product_6
    sum_20 = (
        0.25 * shortfall_beta * shortfall_predicted_epsilon * sum_13 * sum_17 * sum_18 * term_1
        + 0.25 * shortfall_epsilon * sum_11 * sum_19 * term_1 * term_2
    )
    part_00_sin_beta2_sin_epsilon2 = (
        predicted_sigma_r_squared * sum_20
        + r_squared * sum_20
        + 0.25 * sigma_r_squared * sum_10 * sum_19 * sum_9 * term_1 * term_2
    )
    sum_21 = 1.0 + attenuation_predicted_epsilon_squared_squared
    sum_22 = (
        0.5 * attenuation_beta * attenuation_predicted_beta_squared_squared * shortfall_epsilon * sum_3 * term_2
        - 0.5 * attenuation_predicted_beta_squared_squared * shortfall_beta * sum_21
    )
    part_01_cos_beta_cos_epsilon2_sin_beta = (
        0.5 * attenuation_beta * attenuation_predicted_beta_squared_squared * sigma_r_squared * sum_2 * term_2
        + predicted_sigma_r_squared * sum_22
        + r_squared * sum_22
    )
    sum_23 = (
        0.5 * attenuation_beta * attenuation_predicted_beta_squared_squared * shortfall_epsilon * sum_11 * term_2
        - 0.5 * attenuation_predicted_beta_squared_squared * shortfall_beta * shortfall_predicted_epsilon * sum_17 * sum_18
    )
    part_01_cos_beta_sin_beta_sin_epsilon2 = (
        0.5 * attenuation_beta * attenuation_predicted_beta_squared_squared * sigma_r_squared * sum_10 * sum_9 * term_2
        + predicted_sigma_r_squared * sum_23
        + r_squared * sum_23
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
    part_22_cos_epsilon2 = (
        0.5 * predicted_sigma_r_squared * shortfall_epsilon * sum_11 * term_2
        + 0.5 * r_squared * shortfall_epsilon * sum_11 * term_2
        + 0.5 * sigma_r_squared * sum_10 * sum_9 * term_2
    )
    sum_24 = (
        0.5 * shortfall_epsilon**2 * term_2
        + 0.5 * shortfall_epsilon * shortfall_predicted_epsilon * sum_17 * sum_18
    )
    part_22_sin_epsilon2 = (
        predicted_sigma_r_squared * sum_24
        + r_squared * sum_24
        + 0.5 * sigma_r_squared * sum_2 * term_2
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

    Accuracy: at most 73.6 ulp anywhere in this domain with independent errors, proved for elementary
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
    shortfall_beta_squared = shortfall_beta**2
    shortfall_epsilon_squared = shortfall_epsilon**2
    sum_3 = (
        0.25 * shortfall_beta_squared * shortfall_epsilon_squared * term_1 * term_2
        + 0.5 * shortfall_beta_squared * term_1
        + 0.5 * shortfall_epsilon_squared * term_2
    )
    attenuation_beta_squared = attenuation_beta**2
    sum_4 = (
        1.0
        + attenuation_beta_squared
        + attenuation_beta_squared * attenuation_epsilon_squared
        + attenuation_epsilon_squared
    )
    part_00_cos_epsilon2_sin_beta2 = r_squared * sum_3 + 0.25 * sigma_r_squared * sum_4 * term_1 * term_2
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
    sum_7 = 0.5 * attenuation_beta * shortfall_epsilon_squared * term_2 - shortfall_beta
    part_01_cos_beta_cos_epsilon2_sin_beta = (
        0.5 * attenuation_beta * sigma_r_squared * sum_6 * term_2
        + r_squared * sum_7
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

    Accuracy: measured, not proved: at most 9 ulp from 50-digit arithmetic at 500 points of this domain
    (float64, independent errors).
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
    sum_1 = 1.0 + attenuation_beta
    term_1 = 1.0 / attenuation_beta**2
    attenuation_beta_squared = attenuation_beta**2
    sum_2 = 1.0 + attenuation_beta_squared
    attenuation_epsilon_squared = attenuation_epsilon**2
    product_1 = -attenuation_beta_squared * attenuation_epsilon_squared
    attenuation_epsilon_squared_cubed = attenuation_epsilon_squared * attenuation_epsilon_squared**2
    product_2 = -attenuation_beta_squared * attenuation_epsilon_squared_cubed
    attenuation_beta_squared_squared = attenuation_beta_squared**2
    term_2 = (attenuation_epsilon_squared**2)**2
    term_3 = 1.0 / attenuation_epsilon**2
    r_squared = r**2
    sum_3 = (
        1.0
        + attenuation_beta_squared_squared
        + attenuation_beta_squared_squared * term_2
        + product_1
        + product_2
        + term_2
    )
    sigma_r_squared = sigma_r**2
    sum_4 = (
        2.0
        + 2.0 * attenuation_beta_squared_squared
        + 2.0 * attenuation_beta_squared_squared * term_2
        + 2.0 * term_2
        + product_1
        + product_2
    )
    part_00_cos_beta2_cos_epsilon2 = (
        0.25 * r_squared * shortfall_beta * sum_1 * sum_2 * sum_3 * term_1 * term_3
        + 0.25 * shortfall_beta * sigma_r_squared * sum_1 * sum_2 * sum_4 * term_1 * term_3
    )
    attenuation_epsilon_squared_squared = attenuation_epsilon_squared**2
    sum_5 = 1.0 + attenuation_epsilon
    sum_6 = 1.0 + attenuation_epsilon_squared
    sum_7 = (
        1.0
        + attenuation_beta_squared_squared
        + attenuation_beta_squared_squared * attenuation_epsilon_squared_squared
        + attenuation_epsilon_squared_squared
        + product_1
    )
    sum_8 = (
        2.0
        + 2.0 * attenuation_beta_squared_squared
        + 2.0 * attenuation_beta_squared_squared * attenuation_epsilon_squared_squared
        + 2.0 * attenuation_epsilon_squared_squared
        + product_1
    )
    part_00_cos_beta2_sin_epsilon2 = (
        0.25 * r_squared * shortfall_beta * shortfall_epsilon * sum_1 * sum_2 * sum_5 * sum_6 * sum_7 * term_1 * term_3
        + 0.25 * shortfall_beta * shortfall_epsilon * sigma_r_squared * sum_1 * sum_2 * sum_5 * sum_6 * sum_8 * term_1 * term_3
    )
    product_3 = attenuation_beta * attenuation_beta_squared
    shortfall_beta_squared = shortfall_beta**2
    product_4 = shortfall_beta * shortfall_beta_squared**2
    term_4 = (attenuation_beta_squared**2)**2
    product_5 = attenuation_epsilon * attenuation_epsilon_squared
    shortfall_epsilon_squared = shortfall_epsilon**2
    product_6 = shortfall_epsilon * shortfall_epsilon_squared**2
    shortfall_beta_squared_squared = shortfall_beta_squared**2
    shortfall_epsilon_squared_squared = shortfall_epsilon_squared**2
    product_7 = attenuation_beta * attenuation_beta_squared**2
    product_8 = shortfall_beta * shortfall_beta_squared
    attenuation_beta_squared_cubed = attenuation_beta_squared * attenuation_beta_squared**2
    product_9 = attenuation_epsilon * attenuation_epsilon_squared**2
    product_10 = shortfall_epsilon * shortfall_epsilon_squared
    shortfall_beta_squared_cubed = shortfall_beta_squared * shortfall_beta_squared**2
    shortfall_epsilon_squared_cubed = shortfall_epsilon_squared * shortfall_epsilon_squared**2
    product_11 = shortfall_epsilon * shortfall_epsilon_squared * shortfall_epsilon_squared**2
    product_12 = shortfall_beta * shortfall_beta_squared * shortfall_beta_squared**2
    term_5 = (shortfall_epsilon_squared**2)**2
    term_6 = (shortfall_beta_squared**2)**2
    product_13 = attenuation_epsilon * attenuation_epsilon_squared * attenuation_epsilon_squared**2
    product_14 = attenuation_beta * attenuation_beta_squared * attenuation_beta_squared**2
    sum_9 = (
        100.0 * product_3 * product_4 * term_2
        + 100.0 * product_5 * product_6 * term_4
        + 110.0 * attenuation_beta_squared_squared * shortfall_beta_squared_squared * term_2
        + 110.0 * attenuation_epsilon_squared_squared * shortfall_epsilon_squared_squared * term_4
        + 1248.0 * attenuation_beta_squared_cubed * product_10 * product_9 * shortfall_beta_squared
        + 1248.0 * attenuation_epsilon_squared_cubed * product_7 * product_8 * shortfall_epsilon_squared
        + 1472.0 * attenuation_beta_squared_cubed * product_5 * product_6 * shortfall_beta_squared
        + 1472.0 * attenuation_epsilon_squared_cubed * product_3 * product_4 * shortfall_epsilon_squared
        + 1548.0 * attenuation_beta_squared * product_10 * product_9 * shortfall_beta_squared_cubed
        + 1548.0 * attenuation_epsilon_squared * product_7 * product_8 * shortfall_epsilon_squared_cubed
        + 1562.0 * attenuation_beta_squared * product_5 * product_6 * shortfall_beta_squared_cubed
        + 1562.0 * attenuation_epsilon_squared * product_3 * product_4 * shortfall_epsilon_squared_cubed
        + 16.0 * attenuation_beta * product_12 * term_2
        + 16.0 * attenuation_epsilon * product_11 * term_4
        + 1720.0 * attenuation_beta_squared_cubed * attenuation_epsilon_squared_squared * shortfall_beta_squared * shortfall_epsilon_squared_squared
        + 1720.0 * attenuation_beta_squared_squared * attenuation_epsilon_squared_cubed * shortfall_beta_squared_squared * shortfall_epsilon_squared
        + 1945.0 * attenuation_beta_squared * attenuation_epsilon_squared_squared * shortfall_beta_squared_cubed * shortfall_epsilon_squared_squared
        + 1945.0 * attenuation_beta_squared_squared * attenuation_epsilon_squared * shortfall_beta_squared_squared * shortfall_epsilon_squared_cubed
        + 2.0 * term_2 * term_6
        + 2.0 * term_4 * term_5
        + 216.0 * attenuation_beta_squared * product_13 * shortfall_beta_squared_cubed * shortfall_epsilon
        + 216.0 * attenuation_epsilon_squared * product_14 * shortfall_beta * shortfall_epsilon_squared_cubed
        + 224.0 * attenuation_beta * attenuation_epsilon_squared * product_12 * shortfall_epsilon_squared_cubed
        + 224.0 * attenuation_beta * attenuation_epsilon_squared_cubed * product_12 * shortfall_epsilon_squared
        + 224.0 * attenuation_beta_squared * attenuation_epsilon * product_11 * shortfall_beta_squared_cubed
        + 224.0 * attenuation_beta_squared_cubed * attenuation_epsilon * product_11 * shortfall_beta_squared
        + 24.0 * attenuation_beta_squared_cubed * shortfall_beta_squared * term_2
        + 24.0 * attenuation_epsilon_squared_cubed * shortfall_epsilon_squared * term_4
        + 2736.0 * product_10 * product_7 * product_8 * product_9
        + 28.0 * attenuation_beta_squared * shortfall_beta_squared_cubed * term_5
        + 28.0 * attenuation_beta_squared_cubed * shortfall_beta_squared * term_5
        + 28.0 * attenuation_epsilon_squared * shortfall_epsilon_squared_cubed * term_6
        + 28.0 * attenuation_epsilon_squared_cubed * shortfall_epsilon_squared * term_6
        + 288.0 * product_10 * product_14 * product_9 * shortfall_beta
        + 288.0 * product_13 * product_7 * product_8 * shortfall_epsilon
        + 3016.0 * product_10 * product_3 * product_4 * product_9
        + 3016.0 * product_5 * product_6 * product_7 * product_8
        + 3100.0 * product_3 * product_4 * product_5 * product_6
        + 3620.0 * attenuation_beta_squared_squared * product_10 * product_9 * shortfall_beta_squared_squared
        + 3620.0 * attenuation_epsilon_squared_squared * product_7 * product_8 * shortfall_epsilon_squared_squared
        + 3830.0 * attenuation_beta_squared_squared * product_5 * product_6 * shortfall_beta_squared_squared
        + 3830.0 * attenuation_epsilon_squared_squared * product_3 * product_4 * shortfall_epsilon_squared_squared
        + 400.0 * product_13 * product_3 * product_4 * shortfall_epsilon
        + 400.0 * product_14 * product_5 * product_6 * shortfall_beta
        + 440.0 * attenuation_beta_squared_squared * product_13 * shortfall_beta_squared_squared * shortfall_epsilon
        + 440.0 * attenuation_epsilon_squared_squared * product_14 * shortfall_beta * shortfall_epsilon_squared_squared
        + 448.0 * attenuation_beta * product_10 * product_12 * product_9
        + 448.0 * attenuation_beta * product_12 * product_5 * product_6
        + 448.0 * attenuation_epsilon * product_11 * product_3 * product_4
        + 448.0 * attenuation_epsilon * product_11 * product_7 * product_8
        + 4675.0 * attenuation_beta_squared_squared * attenuation_epsilon_squared_squared * shortfall_beta_squared_squared * shortfall_epsilon_squared_squared
        + 528.0 * attenuation_beta_squared_cubed * attenuation_epsilon_squared_cubed * shortfall_beta_squared * shortfall_epsilon_squared
        + 54.0 * attenuation_beta_squared * shortfall_beta_squared_cubed * term_2
        + 54.0 * attenuation_epsilon_squared * shortfall_epsilon_squared_cubed * term_4
        + 56.0 * product_10 * product_9 * term_6
        + 56.0 * product_3 * product_4 * term_5
        + 56.0 * product_5 * product_6 * term_6
        + 56.0 * product_7 * product_8 * term_5
        + 560.0 * attenuation_beta * attenuation_epsilon_squared_squared * product_12 * shortfall_epsilon_squared_squared
        + 560.0 * attenuation_beta_squared_squared * attenuation_epsilon * product_11 * shortfall_beta_squared_squared
        + 64.0 * attenuation_beta * attenuation_epsilon * product_11 * product_12
        + 64.0 * attenuation_beta * product_12 * product_13 * shortfall_epsilon
        + 64.0 * attenuation_epsilon * product_11 * product_14 * shortfall_beta
        + 70.0 * attenuation_beta_squared_squared * shortfall_beta_squared_squared * term_5
        + 70.0 * attenuation_epsilon_squared_squared * shortfall_epsilon_squared_squared * term_6
        + 72.0 * product_10 * product_9 * term_4
        + 72.0 * product_7 * product_8 * term_2
        + 768.0 * attenuation_beta_squared * attenuation_epsilon_squared_cubed * shortfall_beta_squared_cubed * shortfall_epsilon_squared
        + 768.0 * attenuation_beta_squared_cubed * attenuation_epsilon_squared * shortfall_beta_squared * shortfall_epsilon_squared_cubed
        + 783.0 * attenuation_beta_squared * attenuation_epsilon_squared * shortfall_beta_squared_cubed * shortfall_epsilon_squared_cubed
        + 8.0 * attenuation_beta * product_12 * term_5
        + 8.0 * attenuation_epsilon * product_11 * term_6
        + 8.0 * product_13 * shortfall_epsilon * term_6
        + 8.0 * product_14 * shortfall_beta * term_5
        + 96.0 * attenuation_beta_squared_cubed * product_13 * shortfall_beta_squared * shortfall_epsilon
        + 96.0 * attenuation_epsilon_squared_cubed * product_14 * shortfall_beta * shortfall_epsilon_squared
        + term_5 * term_6
    )
    product_15 = -attenuation_beta_squared_cubed * attenuation_epsilon_squared
    sum_10 = (
        2.0
        - attenuation_beta_squared_cubed * attenuation_epsilon_squared_cubed
        + 2.0 * term_2
        + 2.0 * term_2 * term_4
        + 2.0 * term_4
        + product_1
        + product_15
        + product_2
    )
    part_00_cos_epsilon2_sin_beta2 = (
        0.25 * r_squared * sum_9 * term_1 * term_3
        + 0.25 * sigma_r_squared * sum_10 * term_1 * term_3
    )
    sum_11 = (
        1.0
        + attenuation_epsilon_squared_squared
        + attenuation_epsilon_squared_squared * term_4
        + product_1
        + product_15
        + term_4
    )
    sum_12 = (
        2.0
        + 2.0 * attenuation_epsilon_squared_squared
        + 2.0 * attenuation_epsilon_squared_squared * term_4
        + 2.0 * term_4
        + product_1
        + product_15
    )
    part_00_sin_beta2_sin_epsilon2 = (
        0.25 * r_squared * shortfall_epsilon * sum_11 * sum_5 * sum_6 * term_1 * term_3
        + 0.25 * shortfall_epsilon * sigma_r_squared * sum_12 * sum_5 * sum_6 * term_1 * term_3
    )
    product_16 = -12.0 * attenuation_beta * product_5 * product_6 * shortfall_beta
    product_17 = -15.0 * attenuation_epsilon_squared_squared * shortfall_beta_squared * shortfall_epsilon_squared_squared
    product_18 = -16.0 * attenuation_beta * product_13 * shortfall_beta * shortfall_epsilon
    product_19 = -16.0 * attenuation_epsilon_squared_cubed * shortfall_beta_squared * shortfall_epsilon_squared
    product_20 = -2.0 * attenuation_beta * attenuation_epsilon_squared * shortfall_beta * shortfall_epsilon_squared_cubed
    product_21 = -2.0 * shortfall_beta_squared * term_2
    product_22 = -20.0 * product_10 * product_9 * shortfall_beta_squared
    product_23 = -30.0 * attenuation_beta * attenuation_epsilon_squared_squared * shortfall_beta * shortfall_epsilon_squared_squared
    product_24 = -32.0 * attenuation_beta * attenuation_epsilon_squared_cubed * shortfall_beta * shortfall_epsilon_squared
    product_25 = -4.0 * attenuation_beta * shortfall_beta * term_2
    product_26 = -40.0 * attenuation_beta * product_10 * product_9 * shortfall_beta
    product_27 = -6.0 * product_5 * product_6 * shortfall_beta_squared
    product_28 = -8.0 * product_13 * shortfall_beta_squared * shortfall_epsilon
    product_29 = -attenuation_epsilon_squared * shortfall_beta_squared * shortfall_epsilon_squared_cubed
    sum_13 = (
        12.0 * attenuation_beta_squared * attenuation_epsilon_squared_cubed * shortfall_epsilon_squared
        + 27.0 * attenuation_beta_squared * attenuation_epsilon_squared * shortfall_epsilon_squared_cubed
        + 36.0 * attenuation_beta_squared * product_10 * product_9
        + 50.0 * attenuation_beta_squared * product_5 * product_6
        + 55.0 * attenuation_beta_squared * attenuation_epsilon_squared_squared * shortfall_epsilon_squared_squared
        + 8.0 * attenuation_beta_squared * attenuation_epsilon * product_11
        + attenuation_beta_squared * term_5
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
    )
    sum_14 = (
        106.0 * attenuation_beta_squared * product_5 * product_6
        + 125.0 * attenuation_beta_squared * attenuation_epsilon_squared_squared * shortfall_epsilon_squared_squared
        + 16.0 * attenuation_beta_squared * attenuation_epsilon * product_11
        + 2.0 * attenuation_beta_squared * term_2
        + 2.0 * attenuation_beta_squared * term_5
        + 40.0 * attenuation_beta_squared * attenuation_epsilon_squared_cubed * shortfall_epsilon_squared
        + 55.0 * attenuation_beta_squared * attenuation_epsilon_squared * shortfall_epsilon_squared_cubed
        + 8.0 * attenuation_beta_squared * product_13 * shortfall_epsilon
        + 92.0 * attenuation_beta_squared * product_10 * product_9
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
    )
    part_01_cos_beta_cos_epsilon2_sin_beta = (
        0.5 * attenuation_beta_squared_squared * r_squared * sum_13 * term_3
        + 0.5 * attenuation_beta_squared_squared * sigma_r_squared * sum_14 * term_3
    )
    product_30 = -2.0 * attenuation_beta * attenuation_epsilon_squared * shortfall_beta * shortfall_epsilon_squared
    product_31 = -2.0 * attenuation_beta * attenuation_epsilon_squared_squared * shortfall_beta
    product_32 = -2.0 * product_5 * shortfall_beta_squared * shortfall_epsilon
    product_33 = -4.0 * attenuation_beta * product_5 * shortfall_beta * shortfall_epsilon
    product_34 = -attenuation_epsilon_squared * shortfall_beta_squared * shortfall_epsilon_squared
    product_35 = -attenuation_epsilon_squared_squared * shortfall_beta_squared
    sum_15 = (
        2.0 * attenuation_beta_squared * product_5 * shortfall_epsilon
        + 4.0 * attenuation_beta_squared * attenuation_epsilon * product_10
        + 5.0 * attenuation_beta_squared * attenuation_epsilon_squared * shortfall_epsilon_squared
        + attenuation_beta_squared * attenuation_epsilon_squared_squared
        + attenuation_beta_squared * shortfall_epsilon_squared_squared
        + product_30
        + product_31
        + product_32
        + product_33
        + product_34
        + product_35
    )
    sum_16 = (
        11.0 * attenuation_beta_squared * attenuation_epsilon_squared * shortfall_epsilon_squared
        + 2.0 * attenuation_beta_squared * shortfall_epsilon_squared_squared
        + 3.0 * attenuation_beta_squared * attenuation_epsilon_squared_squared
        + 6.0 * attenuation_beta_squared * product_5 * shortfall_epsilon
        + 8.0 * attenuation_beta_squared * attenuation_epsilon * product_10
        + product_30
        + product_31
        + product_32
        + product_33
        + product_34
        + product_35
    )
    part_01_cos_beta_sin_beta_sin_epsilon2 = (
        0.5 * attenuation_beta_squared_squared * r_squared * shortfall_epsilon * sum_15 * sum_5 * sum_6 * term_3
        + 0.5 * attenuation_beta_squared_squared * shortfall_epsilon * sigma_r_squared * sum_16 * sum_5 * sum_6 * term_3
    )
    sum_17 = (
        attenuation_epsilon_squared
        - 2.0 * attenuation_epsilon * shortfall_epsilon
        - shortfall_epsilon_squared
    )
    part_02_cos_epsilon_sin_beta_sin_epsilon = (
        (-1.0 - attenuation_epsilon) * attenuation_beta * attenuation_epsilon_squared_squared * r_squared * shortfall_epsilon
        + attenuation_beta * attenuation_epsilon_squared_squared * sigma_r_squared * sum_17
    )
    part_03_cos_epsilon_sin_beta = (
        attenuation_beta * attenuation_epsilon * r * rho * sigma_r * sigma_rdot
        + attenuation_beta * attenuation_epsilon * rdot * sigma_r_squared
    )
    sum_18 = 1.0 + attenuation_epsilon + attenuation_epsilon_squared_cubed + product_13
    sum_19 = (
        2.0
        + 2.0 * attenuation_epsilon
        + 2.0 * attenuation_epsilon_squared_cubed
        + 2.0 * product_13
        + attenuation_epsilon_squared
        + attenuation_epsilon_squared_squared
        + product_5
        + product_9
    )
    part_22_cos_epsilon2 = (
        0.5 * r_squared * shortfall_epsilon * sum_18 * term_3
        + 0.5 * shortfall_epsilon * sigma_r_squared * sum_19 * term_3
    )
    sum_20 = (
        1.0
        + 2.0 * attenuation_epsilon
        + 2.0 * attenuation_epsilon_squared
        + 2.0 * attenuation_epsilon_squared_squared
        + 2.0 * product_5
        + 2.0 * product_9
        + attenuation_epsilon_squared_cubed
    )
    sum_21 = 2.0 - attenuation_epsilon_squared - attenuation_epsilon_squared_cubed + 2.0 * term_2
    part_22_sin_epsilon2 = (
        0.5 * r_squared * shortfall_epsilon_squared * sum_20 * term_3
        + 0.5 * sigma_r_squared * sum_21 * term_3
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
