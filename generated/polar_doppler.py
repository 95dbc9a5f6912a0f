"""NumPy functions of the quantities polar_doppler.*.

Written by radartrack regenerate, generator 1, derivation 4b2841b2be3ef4a2; not to be edited.
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


def map(*, r: npt.ArrayLike, beta: npt.ArrayLike, rdot: npt.ArrayLike) -> Floats:
    """Map from the measured quantities to coordinates.

    Name: polar_doppler.map.
    Definition: h.
    Conditioning: no expectation is taken.
    Source: Duan et al. 2005 range rate as a pseudo-measurement.

    Args:
        r: range [m], 1 to 1e+08.
        beta: azimuth, counter-clockwise from the x axis [rad], -3.1416 to 3.1416.
        rdot: range rate [m/s], -10000 to 10000.

    Returns:
        Shape of the broadcast arguments + (3), unit [m, m, m^2/s].

    Accuracy: at most 3.01 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 9.01.
    """
    arguments = _floats(r, beta, rdot)
    r, beta, rdot = arguments
    cos_beta = np.cos(beta)
    sin_beta = np.sin(beta)
    result = _empty(arguments, (3,))
    result[..., 0] = cos_beta * r
    result[..., 1] = r * sin_beta
    result[..., 2] = r * rdot
    return result


def jacobian(*, r: npt.ArrayLike, beta: npt.ArrayLike, rdot: npt.ArrayLike) -> Floats:
    """First derivatives of the map, [out, in].

    Name: polar_doppler.jacobian.
    Definition: dh/dtheta.
    Conditioning: no expectation is taken.
    Source: Prosov (6)-(7).

    Args:
        r: range [m], 1 to 1e+08.
        beta: azimuth, counter-clockwise from the x axis [rad], -3.1416 to 3.1416.
        rdot: range rate [m/s], -10000 to 10000.

    Returns:
        Shape of the broadcast arguments + (3, 3), unit [m, m, m^2/s] × [1/m, 1/rad, s/m].

    Accuracy: at most 3.01 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 9.01.
    """
    arguments = _floats(r, beta, rdot)
    r, beta, rdot = arguments
    cos_beta = np.cos(beta)
    sin_beta = np.sin(beta)
    result = _empty(arguments, (3, 3))
    result[..., 0, 0] = cos_beta
    result[..., 0, 1] = -r * sin_beta
    result[..., 0, 2] = 0.0
    result[..., 1, 0] = sin_beta
    result[..., 1, 1] = cos_beta * r
    result[..., 1, 2] = 0.0
    result[..., 2, 0] = rdot
    result[..., 2, 1] = 0.0
    result[..., 2, 2] = r
    return result


def hessian(*, r: npt.ArrayLike, beta: npt.ArrayLike, rdot: npt.ArrayLike) -> Floats:
    """Second derivatives of the map, [out, in, in].

    Name: polar_doppler.hessian.
    Definition: d2h/dtheta2.
    Conditioning: no expectation is taken.
    Source: Prosov (6)-(7).

    Args:
        r: range [m], 1 to 1e+08.
        beta: azimuth, counter-clockwise from the x axis [rad], -3.1416 to 3.1416.
        rdot: range rate [m/s], -10000 to 10000.

    Returns:
        Shape of the broadcast arguments + (3, 3, 3), unit [m, m, m^2/s] × [1/m, 1/rad, s/m] × [1/m, 1/rad,
        s/m].

    Accuracy: at most 3.01 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 9.01.
    """
    arguments = _floats(r, beta, rdot)
    r, beta, rdot = arguments
    cos_beta = np.cos(beta)
    sin_beta = np.sin(beta)
    result = _empty(arguments, (3, 3, 3))
    result[..., 0, 0, 0] = 0.0
    result[..., 0, 0, 1] = -sin_beta
    result[..., 0, 0, 2] = 0.0
    result[..., 0, 1, 0] = result[..., 0, 0, 1]
    result[..., 0, 1, 1] = -cos_beta * r
    result[..., 0, 1, 2] = 0.0
    result[..., 0, 2, 0] = 0.0
    result[..., 0, 2, 1] = 0.0
    result[..., 0, 2, 2] = 0.0
    result[..., 1, 0, 0] = 0.0
    result[..., 1, 0, 1] = cos_beta
    result[..., 1, 0, 2] = 0.0
    result[..., 1, 1, 0] = cos_beta
    result[..., 1, 1, 1] = -r * sin_beta
    result[..., 1, 1, 2] = 0.0
    result[..., 1, 2, 0] = 0.0
    result[..., 1, 2, 1] = 0.0
    result[..., 1, 2, 2] = 0.0
    result[..., 2, 0, 0] = 0.0
    result[..., 2, 0, 1] = 0.0
    result[..., 2, 0, 2] = 1.0
    result[..., 2, 1, 0] = 0.0
    result[..., 2, 1, 1] = 0.0
    result[..., 2, 1, 2] = 0.0
    result[..., 2, 2, 0] = 1.0
    result[..., 2, 2, 1] = 0.0
    result[..., 2, 2, 2] = 0.0
    return result


def bias_second_order(
    *,
    r: npt.ArrayLike,
    beta: npt.ArrayLike,
    rdot: npt.ArrayLike,
    sigma_r: npt.ArrayLike,
    sigma_beta: npt.ArrayLike,
    sigma_rdot: npt.ArrayLike,
    rho: npt.ArrayLike,
) -> Floats:
    """Bias of the plain conversion to second order.

    Name: polar_doppler.bias.second_order.
    Definition: L h.
    Conditioning: truth-conditioned: the measured symbols stand for the true values.
    Source: Prosov (7).

    Args:
        r: range [m], 1 to 1e+08.
        beta: azimuth, counter-clockwise from the x axis [rad], -3.1416 to 3.1416.
        rdot: range rate [m/s], -10000 to 10000.
        sigma_r: standard deviation of the error of r [m], 0.001 to 10000.
        sigma_beta: standard deviation of the error of beta [rad], 1e-09 to 1.
        sigma_rdot: standard deviation of the error of rdot [m/s], 0.0001 to 1000.
        rho: correlation of the errors of r and rdot [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (3), unit [m, m, m^2/s].

    Accuracy: at most 6.01 ulp anywhere in this domain with independent errors, proved for elementary
    functions within 1 ulp (float64); with correlations up to 0.99 in size at most 6.01; in float32, with
    functions within 4 of its ulp, at most 12.1.
    """
    arguments = _floats(r, beta, rdot, sigma_r, sigma_beta, sigma_rdot, rho)
    r, beta, rdot, sigma_r, sigma_beta, sigma_rdot, rho = arguments
    cos_beta = np.cos(beta)
    sin_beta = np.sin(beta)
    part_0_cos_beta = -0.5 * r * sigma_beta**2
    result = _empty(arguments, (3,))
    result[..., 0] = cos_beta * part_0_cos_beta
    result[..., 1] = part_0_cos_beta * sin_beta
    result[..., 2] = rho * sigma_r * sigma_rdot
    return result


def covariance_linear(
    *,
    r: npt.ArrayLike,
    beta: npt.ArrayLike,
    rdot: npt.ArrayLike,
    sigma_r: npt.ArrayLike,
    sigma_beta: npt.ArrayLike,
    sigma_rdot: npt.ArrayLike,
    rho: npt.ArrayLike,
) -> Floats:
    """Covariance of the linearised conversion.

    Name: polar_doppler.covariance.linear.
    Definition: J K J'.
    Conditioning: truth-conditioned: the measured symbols stand for the true values.
    Source: Prosov (9); Gao et al. 2020 (1), doi:10.12126/see.2020.02.013.

    Args:
        r: range [m], 1 to 1e+08.
        beta: azimuth, counter-clockwise from the x axis [rad], -3.1416 to 3.1416.
        rdot: range rate [m/s], -10000 to 10000.
        sigma_r: standard deviation of the error of r [m], 0.001 to 10000.
        sigma_beta: standard deviation of the error of beta [rad], 1e-09 to 1.
        sigma_rdot: standard deviation of the error of rdot [m/s], 0.0001 to 1000.
        rho: correlation of the errors of r and rdot [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (3, 3), unit [m, m, m^2/s] × [m, m, m^2/s].

    Accuracy: at most 13.1 ulp anywhere in this domain with independent errors, proved for elementary
    functions within 1 ulp (float64); with correlations up to 0.99 in size at most 1100; in float32, with
    functions within 4 of its ulp, at most 261.
    """
    arguments = _floats(r, beta, rdot, sigma_r, sigma_beta, sigma_rdot, rho)
    r, beta, rdot, sigma_r, sigma_beta, sigma_rdot, rho = arguments
    cos_beta = np.cos(beta)
    sin_beta = np.sin(beta)
    r_squared = r**2
    sigma_beta_squared = sigma_beta**2
    part_00_sin_beta2 = r_squared * sigma_beta_squared
    sigma_r_squared = sigma_r**2
    part_01_cos_beta_sin_beta = sigma_r_squared - r_squared * sigma_beta_squared
    part_02_cos_beta = r * rho * sigma_r * sigma_rdot + rdot * sigma_r_squared
    cos_beta_squared = cos_beta**2
    sin_beta_squared = sin_beta**2
    result = _empty(arguments, (3, 3))
    result[..., 0, 0] = cos_beta_squared * sigma_r_squared + part_00_sin_beta2 * sin_beta_squared
    result[..., 0, 1] = cos_beta * part_01_cos_beta_sin_beta * sin_beta
    result[..., 0, 2] = cos_beta * part_02_cos_beta
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = cos_beta_squared * part_00_sin_beta2 + sigma_r_squared * sin_beta_squared
    result[..., 1, 2] = part_02_cos_beta * sin_beta
    result[..., 2, 0] = result[..., 0, 2]
    result[..., 2, 1] = result[..., 1, 2]
    result[..., 2, 2] = (
        2.0 * r * rdot * rho * sigma_r * sigma_rdot
        + r_squared * sigma_rdot**2
        + rdot**2 * sigma_r_squared
    )
    return result


def covariance_second_order(
    *,
    r: npt.ArrayLike,
    beta: npt.ArrayLike,
    rdot: npt.ArrayLike,
    sigma_r: npt.ArrayLike,
    sigma_beta: npt.ArrayLike,
    sigma_rdot: npt.ArrayLike,
    rho: npt.ArrayLike,
) -> Floats:
    """Covariance of the conversion's quadratic Taylor polynomial.

    Name: polar_doppler.covariance.second_order.
    Definition: J K J' + tr(G_a K G_b K)/2.
    Conditioning: truth-conditioned: the measured symbols stand for the true values.
    Source: Bar-Shalom & Li 1995.

    Args:
        r: range [m], 1 to 1e+08.
        beta: azimuth, counter-clockwise from the x axis [rad], -3.1416 to 3.1416.
        rdot: range rate [m/s], -10000 to 10000.
        sigma_r: standard deviation of the error of r [m], 0.001 to 10000.
        sigma_beta: standard deviation of the error of beta [rad], 1e-09 to 1.
        sigma_rdot: standard deviation of the error of rdot [m/s], 0.0001 to 1000.
        rho: correlation of the errors of r and rdot [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (3, 3), unit [m, m, m^2/s] × [m, m, m^2/s].

    Accuracy: at most 22.3 ulp anywhere in this domain with independent errors, proved for elementary
    functions within 1 ulp (float64); with correlations up to 0.99 in size at most 1100; in float32, with
    functions within 4 of its ulp, at most 243.
    """
    arguments = _floats(r, beta, rdot, sigma_r, sigma_beta, sigma_rdot, rho)
    r, beta, rdot, sigma_r, sigma_beta, sigma_rdot, rho = arguments
    cos_beta = np.cos(beta)
    sin_beta = np.sin(beta)
    r_squared = r**2
    sigma_beta_squared = sigma_beta**2
    product_1 = 0.5 * r_squared * sigma_beta_squared**2
    sigma_r_squared = sigma_r**2
    part_00_cos_beta2 = product_1 + sigma_r_squared
    part_00_sin_beta2 = r_squared * sigma_beta_squared + sigma_beta_squared * sigma_r_squared
    part_01_cos_beta_sin_beta = (
        product_1
        - r_squared * sigma_beta_squared
        - sigma_beta_squared * sigma_r_squared
        + sigma_r_squared
    )
    part_02_cos_beta = r * rho * sigma_r * sigma_rdot + rdot * sigma_r_squared
    cos_beta_squared = cos_beta**2
    sin_beta_squared = sin_beta**2
    sigma_rdot_squared = sigma_rdot**2
    result = _empty(arguments, (3, 3))
    result[..., 0, 0] = cos_beta_squared * part_00_cos_beta2 + part_00_sin_beta2 * sin_beta_squared
    result[..., 0, 1] = cos_beta * part_01_cos_beta_sin_beta * sin_beta
    result[..., 0, 2] = cos_beta * part_02_cos_beta
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = cos_beta_squared * part_00_sin_beta2 + part_00_cos_beta2 * sin_beta_squared
    result[..., 1, 2] = part_02_cos_beta * sin_beta
    result[..., 2, 0] = result[..., 0, 2]
    result[..., 2, 1] = result[..., 1, 2]
    result[..., 2, 2] = (
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
    rdot: npt.ArrayLike,
    sigma_r: npt.ArrayLike,
    sigma_beta: npt.ArrayLike,
    sigma_rdot: npt.ArrayLike,
    rho: npt.ArrayLike,
) -> Floats:
    """Standard deviation of each coordinate of the linearised conversion.

    Name: polar_doppler.std.linear.
    Definition: sqrt((J K J')_aa).
    Conditioning: truth-conditioned: the measured symbols stand for the true values.
    Source: Gao et al. 2020 (1), doi:10.12126/see.2020.02.013.

    Args:
        r: range [m], 1 to 1e+08.
        beta: azimuth, counter-clockwise from the x axis [rad], -3.1416 to 3.1416.
        rdot: range rate [m/s], -10000 to 10000.
        sigma_r: standard deviation of the error of r [m], 0.001 to 10000.
        sigma_beta: standard deviation of the error of beta [rad], 1e-09 to 1.
        sigma_rdot: standard deviation of the error of rdot [m/s], 0.0001 to 1000.
        rho: correlation of the errors of r and rdot [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (3), unit [m, m, m^2/s].

    Accuracy: at most 7.51 ulp anywhere in this domain with independent errors, proved for elementary
    functions within 1 ulp (float64); with correlations up to 0.99 in size at most 550; in float32, with
    functions within 4 of its ulp, at most 132.
    """
    arguments = _floats(r, beta, rdot, sigma_r, sigma_beta, sigma_rdot, rho)
    r, beta, rdot, sigma_r, sigma_beta, sigma_rdot, rho = arguments
    cos_beta = np.cos(beta)
    sin_beta = np.sin(beta)
    r_squared = r**2
    part_0_sin_beta2 = r_squared * sigma_beta**2
    cos_beta_squared = cos_beta**2
    sigma_r_squared = sigma_r**2
    sin_beta_squared = sin_beta**2
    result = _empty(arguments, (3,))
    result[..., 0] = np.sqrt(cos_beta_squared * sigma_r_squared + part_0_sin_beta2 * sin_beta_squared)
    result[..., 1] = np.sqrt(cos_beta_squared * part_0_sin_beta2 + sigma_r_squared * sin_beta_squared)
    result[..., 2] = np.sqrt(2.0 * r * rdot * rho * sigma_r * sigma_rdot + r_squared * sigma_rdot**2 + rdot**2 * sigma_r_squared)
    return result


def validity_linear(
    *,
    r: npt.ArrayLike,
    beta: npt.ArrayLike,
    rdot: npt.ArrayLike,
    sigma_r: npt.ArrayLike,
    sigma_beta: npt.ArrayLike,
    sigma_rdot: npt.ArrayLike,
    rho: npt.ArrayLike,
) -> Floats:
    """Leading term that the linear formulas neglect, root mean square, over the linear standard deviation, one a measured quantity.

    Name: polar_doppler.validity.linear.
    Definition: sqrt(E[(J^-1 (w.d)^2 h)_i^2])/(2 sigma_i).
    Conditioning: truth-conditioned: the measured symbols stand for the true values.
    Source: Prosov the question of validity.

    Args:
        r: range [m], 1 to 1e+08.
        beta: azimuth, counter-clockwise from the x axis [rad], -3.1416 to 3.1416.
        rdot: range rate [m/s], -10000 to 10000.
        sigma_r: standard deviation of the error of r [m], 0.001 to 10000.
        sigma_beta: standard deviation of the error of beta [rad], 1e-09 to 1.
        sigma_rdot: standard deviation of the error of rdot [m/s], 0.0001 to 1000.
        rho: correlation of the errors of r and rdot [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (3), unit 1.

    Accuracy: at most 10.4 ulp anywhere in this domain with independent errors, proved for elementary
    functions within 1 ulp (float64); with correlations up to 0.99 in size at most 12; in float32, with
    functions within 4 of its ulp, at most 248.
    """
    arguments = _floats(r, beta, rdot, sigma_r, sigma_beta, sigma_rdot, rho)
    r, beta, rdot, sigma_r, sigma_beta, sigma_rdot, rho = arguments
    complement_of_rho = np.sqrt((1.0 - rho) * (1.0 + rho))
    sigma_beta_squared = sigma_beta**2
    term_1 = 1.0 / r
    sigma_r_squared = sigma_r**2
    sigma_rdot_squared = sigma_rdot**2
    result = _empty(arguments, (3,))
    result[..., 0] = 0.5 * r * sigma_beta_squared * np.sqrt(3.0) / sigma_r
    result[..., 1] = sigma_r * term_1
    result[..., 2] = np.sqrt((rho * sigma_r * sigma_rdot + 0.5 * r * rdot * sigma_beta_squared)**2 + 2.0 * rho**2 * sigma_r_squared * sigma_rdot_squared + complement_of_rho**2 * sigma_r_squared * sigma_rdot_squared + 0.5 * r**2 * rdot**2 * sigma_beta_squared**2) * term_1 / sigma_rdot
    return result


def validity_second_order(
    *,
    r: npt.ArrayLike,
    beta: npt.ArrayLike,
    rdot: npt.ArrayLike,
    sigma_r: npt.ArrayLike,
    sigma_beta: npt.ArrayLike,
    sigma_rdot: npt.ArrayLike,
    rho: npt.ArrayLike,
) -> Floats:
    """Leading term that the second-order formulas neglect, root mean square, over the linear standard deviation, one a measured quantity.

    Name: polar_doppler.validity.second_order.
    Definition: sqrt(E[(J^-1 (w.d)^3 h)_i^2])/(6 sigma_i).
    Conditioning: truth-conditioned: the measured symbols stand for the true values.
    Source: Prosov the question of validity.

    Args:
        r: range [m], 1 to 1e+08.
        beta: azimuth, counter-clockwise from the x axis [rad], -3.1416 to 3.1416.
        rdot: range rate [m/s], -10000 to 10000.
        sigma_r: standard deviation of the error of r [m], 0.001 to 10000.
        sigma_beta: standard deviation of the error of beta [rad], 1e-09 to 1.
        sigma_rdot: standard deviation of the error of rdot [m/s], 0.0001 to 1000.
        rho: correlation of the errors of r and rdot [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (3), unit 1.

    Accuracy: at most 8.01 ulp anywhere in this domain with independent errors, proved for elementary
    functions within 1 ulp (float64); with correlations up to 0.99 in size at most 8.01.
    """
    arguments = _floats(r, beta, rdot, sigma_r, sigma_beta, sigma_rdot, rho)
    r, beta, rdot, sigma_r, sigma_beta, sigma_rdot, rho = arguments
    sigma_beta_squared = sigma_beta**2
    term_1 = np.sqrt(3.0)
    result = _empty(arguments, (3,))
    result[..., 0] = 0.5 * sigma_beta_squared * term_1
    result[..., 1] = sigma_beta_squared * np.sqrt(15.0) / 6.0
    result[..., 2] = 0.5 * np.abs(rdot) * sigma_beta_squared * sigma_r * term_1 / (r * sigma_rdot)
    return result


def covariance_third_order(
    *,
    r: npt.ArrayLike,
    beta: npt.ArrayLike,
    rdot: npt.ArrayLike,
    sigma_r: npt.ArrayLike,
    sigma_beta: npt.ArrayLike,
    sigma_rdot: npt.ArrayLike,
    rho: npt.ArrayLike,
) -> Floats:
    """Covariance of the conversion's cubic Taylor polynomial.

    Name: polar_doppler.covariance.third_order.
    Definition: E[p p'] - E[p] E[p]', p = h + (w.d) h + (w.d)^2 h/2 + (w.d)^3 h/6.
    Conditioning: truth-conditioned: the measured symbols stand for the true values.
    Source: Bar-Shalom & Li 1995.

    Args:
        r: range [m], 1 to 1e+08.
        beta: azimuth, counter-clockwise from the x axis [rad], -3.1416 to 3.1416.
        rdot: range rate [m/s], -10000 to 10000.
        sigma_r: standard deviation of the error of r [m], 0.001 to 10000.
        sigma_beta: standard deviation of the error of beta [rad], 1e-09 to 1.
        sigma_rdot: standard deviation of the error of rdot [m/s], 0.0001 to 1000.
        rho: correlation of the errors of r and rdot [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (3, 3), unit [m, m, m^2/s] × [m, m, m^2/s].

    Accuracy: at most 92.3 ulp anywhere in this domain with independent errors, proved for elementary
    functions within 1 ulp (float64); with correlations up to 0.99 in size at most 1100.
    """
    arguments = _floats(r, beta, rdot, sigma_r, sigma_beta, sigma_rdot, rho)
    r, beta, rdot, sigma_r, sigma_beta, sigma_rdot, rho = arguments
    cos_beta = np.cos(beta)
    sin_beta = np.sin(beta)
    sigma_beta_squared = sigma_beta**2
    sigma_r_squared = sigma_r**2
    sigma_beta_squared_squared = sigma_beta_squared**2
    product_1 = 0.75 * sigma_beta_squared_squared * sigma_r_squared
    r_squared = r**2
    part_00_cos_beta2 = (
        product_1
        - sigma_beta_squared * sigma_r_squared
        + 0.5 * r_squared * sigma_beta_squared_squared
        + sigma_r_squared
    )
    sigma_beta_squared_cubed = sigma_beta_squared * sigma_beta_squared**2
    part_00_sin_beta2 = (
        5.0 * r_squared * sigma_beta_squared_cubed / 12.0
        - r_squared * sigma_beta_squared_squared
        + r_squared * sigma_beta_squared
        + sigma_beta_squared * sigma_r_squared
    )
    part_01_cos_beta_sin_beta = (
        1.5 * r_squared * sigma_beta_squared_squared
        - 2.0 * sigma_beta_squared * sigma_r_squared
        - 5.0 * r_squared * sigma_beta_squared_cubed / 12.0
        - r_squared * sigma_beta_squared
        + product_1
        + sigma_r_squared
    )
    part_02_cos_beta = (
        r * rho * sigma_r * sigma_rdot
        - 0.5 * r * rho * sigma_beta_squared * sigma_r * sigma_rdot
        - 0.5 * rdot * sigma_beta_squared * sigma_r_squared
        + rdot * sigma_r_squared
    )
    cos_beta_squared = cos_beta**2
    sin_beta_squared = sin_beta**2
    sigma_rdot_squared = sigma_rdot**2
    result = _empty(arguments, (3, 3))
    result[..., 0, 0] = cos_beta_squared * part_00_cos_beta2 + part_00_sin_beta2 * sin_beta_squared
    result[..., 0, 1] = cos_beta * part_01_cos_beta_sin_beta * sin_beta
    result[..., 0, 2] = cos_beta * part_02_cos_beta
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = cos_beta_squared * part_00_sin_beta2 + part_00_cos_beta2 * sin_beta_squared
    result[..., 1, 2] = part_02_cos_beta * sin_beta
    result[..., 2, 0] = result[..., 0, 2]
    result[..., 2, 1] = result[..., 1, 2]
    result[..., 2, 2] = (
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
    rdot: npt.ArrayLike,
    sigma_r: npt.ArrayLike,
    sigma_beta: npt.ArrayLike,
    sigma_rdot: npt.ArrayLike,
    rho: npt.ArrayLike,
) -> Floats:
    """Exact bias of the plain conversion h(z).

    Name: polar_doppler.bias.truth.
    Definition: (e^L - 1) h.
    Conditioning: truth-conditioned: the measured symbols stand for the true values.
    Source: Lerro & Bar-Shalom 1993, doi:10.1109/7.220948.

    Args:
        r: range [m], 1 to 1e+08.
        beta: azimuth, counter-clockwise from the x axis [rad], -3.1416 to 3.1416.
        rdot: range rate [m/s], -10000 to 10000.
        sigma_r: standard deviation of the error of r [m], 0.001 to 10000.
        sigma_beta: standard deviation of the error of beta [rad], 1e-09 to 1.
        sigma_rdot: standard deviation of the error of rdot [m/s], 0.0001 to 1000.
        rho: correlation of the errors of r and rdot [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (3), unit [m, m, m^2/s].

    Accuracy: at most 8.01 ulp anywhere in this domain with independent errors, proved for elementary
    functions within 1 ulp (float64); with correlations up to 0.99 in size at most 8.01; in float32, with
    functions within 4 of its ulp, at most 20.1.
    """
    arguments = _floats(r, beta, rdot, sigma_r, sigma_beta, sigma_rdot, rho)
    r, beta, rdot, sigma_r, sigma_beta, sigma_rdot, rho = arguments
    cos_beta = np.cos(beta)
    sin_beta = np.sin(beta)
    shortfall_beta = -np.expm1(-0.5 * sigma_beta**2)
    part_0_cos_beta = -r * shortfall_beta
    result = _empty(arguments, (3,))
    result[..., 0] = cos_beta * part_0_cos_beta
    result[..., 1] = part_0_cos_beta * sin_beta
    result[..., 2] = rho * sigma_r * sigma_rdot
    return result


def bias_averaged(
    *,
    r: npt.ArrayLike,
    beta: npt.ArrayLike,
    rdot: npt.ArrayLike,
    sigma_r: npt.ArrayLike,
    sigma_beta: npt.ArrayLike,
    sigma_rdot: npt.ArrayLike,
    rho: npt.ArrayLike,
) -> Floats:
    """Exact bias of the plain conversion, averaged over the truth.

    Name: polar_doppler.bias.averaged.
    Definition: (e^2L - e^L) h.
    Conditioning: measurement-conditioned: the measured symbols stand for the measurement.
    Source: Lerro & Bar-Shalom 1993, doi:10.1109/7.220948.

    Args:
        r: range [m], 1 to 1e+08.
        beta: azimuth, counter-clockwise from the x axis [rad], -3.1416 to 3.1416.
        rdot: range rate [m/s], -10000 to 10000.
        sigma_r: standard deviation of the error of r [m], 0.001 to 10000.
        sigma_beta: standard deviation of the error of beta [rad], 1e-09 to 1.
        sigma_rdot: standard deviation of the error of rdot [m/s], 0.0001 to 1000.
        rho: correlation of the errors of r and rdot [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (3), unit [m, m, m^2/s].

    Accuracy: at most 12.1 ulp anywhere in this domain with independent errors, proved for elementary
    functions within 1 ulp (float64); with correlations up to 0.99 in size at most 12.1; in float32, with
    functions within 4 of its ulp, at most 30.1.
    """
    arguments = _floats(r, beta, rdot, sigma_r, sigma_beta, sigma_rdot, rho)
    r, beta, rdot, sigma_r, sigma_beta, sigma_rdot, rho = arguments
    cos_beta = np.cos(beta)
    sin_beta = np.sin(beta)
    attenuation_beta = np.exp(-0.5 * sigma_beta**2)
    shortfall_beta = -np.expm1(-0.5 * sigma_beta**2)
    part_0_cos_beta = -attenuation_beta * r * shortfall_beta
    result = _empty(arguments, (3,))
    result[..., 0] = cos_beta * part_0_cos_beta
    result[..., 1] = part_0_cos_beta * sin_beta
    result[..., 2] = rho * sigma_r * sigma_rdot
    return result


def covariance_truth(
    *,
    r: npt.ArrayLike,
    beta: npt.ArrayLike,
    rdot: npt.ArrayLike,
    sigma_r: npt.ArrayLike,
    sigma_beta: npt.ArrayLike,
    sigma_rdot: npt.ArrayLike,
    rho: npt.ArrayLike,
) -> Floats:
    """Exact covariance of the plain conversion h(z).

    Name: polar_doppler.covariance.truth.
    Definition: C = e^L(h h') - (e^L h)(e^L h)'.
    Conditioning: truth-conditioned: the measured symbols stand for the true values.
    Source: Lerro & Bar-Shalom 1993, doi:10.1109/7.220948.

    Args:
        r: range [m], 1 to 1e+08.
        beta: azimuth, counter-clockwise from the x axis [rad], -3.1416 to 3.1416.
        rdot: range rate [m/s], -10000 to 10000.
        sigma_r: standard deviation of the error of r [m], 0.001 to 10000.
        sigma_beta: standard deviation of the error of beta [rad], 1e-09 to 1.
        sigma_rdot: standard deviation of the error of rdot [m/s], 0.0001 to 1000.
        rho: correlation of the errors of r and rdot [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (3, 3), unit [m, m, m^2/s] × [m, m, m^2/s].

    Accuracy: at most 32.1 ulp anywhere in this domain with independent errors, proved for elementary
    functions within 1 ulp (float64); with correlations up to 0.99 in size at most 1100; in float32, with
    functions within 4 of its ulp, at most 243.
    """
    arguments = _floats(r, beta, rdot, sigma_r, sigma_beta, sigma_rdot, rho)
    r, beta, rdot, sigma_r, sigma_beta, sigma_rdot, rho = arguments
    cos_beta = np.cos(beta)
    sin_beta = np.sin(beta)
    attenuation_beta = np.exp(-0.5 * sigma_beta**2)
    shortfall_beta = -np.expm1(-0.5 * sigma_beta**2)
    attenuation_beta_squared = attenuation_beta**2
    r_squared = r**2
    sum_1 = 1.0 + 2.0 * attenuation_beta + attenuation_beta_squared
    attenuation_beta_squared_squared = attenuation_beta_squared**2
    sigma_r_squared = sigma_r**2
    sum_2 = 0.5 + 0.5 * attenuation_beta_squared_squared
    part_00_cos_beta2 = 0.5 * r_squared * shortfall_beta**2 * sum_1 + sigma_r_squared * sum_2
    sum_3 = 1.0 + attenuation_beta + attenuation_beta * attenuation_beta_squared + attenuation_beta_squared
    part_00_sin_beta2 = (
        0.5 * r_squared * shortfall_beta * sum_3
        + 0.5 * shortfall_beta * sigma_r_squared * sum_3
    )
    part_01_cos_beta_sin_beta = (
        (-1.0 - attenuation_beta) * attenuation_beta_squared * r_squared * shortfall_beta
        + attenuation_beta_squared_squared * sigma_r_squared
    )
    part_02_cos_beta = (
        attenuation_beta * r * rho * sigma_r * sigma_rdot
        + attenuation_beta * rdot * sigma_r_squared
    )
    cos_beta_squared = cos_beta**2
    sin_beta_squared = sin_beta**2
    sigma_rdot_squared = sigma_rdot**2
    result = _empty(arguments, (3, 3))
    result[..., 0, 0] = cos_beta_squared * part_00_cos_beta2 + part_00_sin_beta2 * sin_beta_squared
    result[..., 0, 1] = cos_beta * part_01_cos_beta_sin_beta * sin_beta
    result[..., 0, 2] = cos_beta * part_02_cos_beta
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = cos_beta_squared * part_00_sin_beta2 + part_00_cos_beta2 * sin_beta_squared
    result[..., 1, 2] = part_02_cos_beta * sin_beta
    result[..., 2, 0] = result[..., 0, 2]
    result[..., 2, 1] = result[..., 1, 2]
    result[..., 2, 2] = (
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
    rdot: npt.ArrayLike,
    sigma_r: npt.ArrayLike,
    sigma_beta: npt.ArrayLike,
    sigma_rdot: npt.ArrayLike,
    rho: npt.ArrayLike,
) -> Floats:
    """Exact covariance of the plain conversion, averaged over the truth.

    Name: polar_doppler.covariance.averaged.
    Definition: e^L C.
    Conditioning: measurement-conditioned: the measured symbols stand for the measurement.
    Source: Lerro & Bar-Shalom 1993; Prosov (11), doi:10.1109/7.220948.

    Args:
        r: range [m], 1 to 1e+08.
        beta: azimuth, counter-clockwise from the x axis [rad], -3.1416 to 3.1416.
        rdot: range rate [m/s], -10000 to 10000.
        sigma_r: standard deviation of the error of r [m], 0.001 to 10000.
        sigma_beta: standard deviation of the error of beta [rad], 1e-09 to 1.
        sigma_rdot: standard deviation of the error of rdot [m/s], 0.0001 to 1000.
        rho: correlation of the errors of r and rdot [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (3, 3), unit [m, m, m^2/s] × [m, m, m^2/s].

    Accuracy: at most 41.4 ulp anywhere in this domain with independent errors, proved for elementary
    functions within 1 ulp (float64); with correlations up to 0.99 in size at most 1310; in float32, with
    functions within 4 of its ulp, at most 242.
    """
    arguments = _floats(r, beta, rdot, sigma_r, sigma_beta, sigma_rdot, rho)
    r, beta, rdot, sigma_r, sigma_beta, sigma_rdot, rho = arguments
    cos_beta = np.cos(beta)
    sin_beta = np.sin(beta)
    attenuation_beta = np.exp(-sigma_beta**2)
    shortfall_beta = -np.expm1(-sigma_beta**2)
    attenuation_beta_squared = attenuation_beta**2
    r_squared = r**2
    sum_1 = 1.0 + attenuation_beta + attenuation_beta_squared
    product_1 = attenuation_beta * attenuation_beta_squared
    sigma_r_squared = sigma_r**2
    sum_2 = 1.0 - 0.5 * attenuation_beta - 0.5 * product_1 + attenuation_beta_squared**2
    part_00_cos_beta2 = 0.5 * r_squared * shortfall_beta**2 * sum_1 + sigma_r_squared * sum_2
    sum_3 = 2.0 + 2.0 * product_1 + attenuation_beta + attenuation_beta_squared
    part_00_sin_beta2 = (
        0.5 * (1.0 + product_1) * r_squared * shortfall_beta
        + 0.5 * shortfall_beta * sigma_r_squared * sum_3
    )
    sum_4 = attenuation_beta - shortfall_beta
    part_01_cos_beta_sin_beta = product_1 * sigma_r_squared * sum_4 - product_1 * r_squared * shortfall_beta
    part_02_cos_beta = (
        attenuation_beta * r * rho * sigma_r * sigma_rdot
        + attenuation_beta * rdot * sigma_r_squared
    )
    cos_beta_squared = cos_beta**2
    sin_beta_squared = sin_beta**2
    sigma_rdot_squared = sigma_rdot**2
    result = _empty(arguments, (3, 3))
    result[..., 0, 0] = cos_beta_squared * part_00_cos_beta2 + part_00_sin_beta2 * sin_beta_squared
    result[..., 0, 1] = cos_beta * part_01_cos_beta_sin_beta * sin_beta
    result[..., 0, 2] = cos_beta * part_02_cos_beta
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = cos_beta_squared * part_00_sin_beta2 + part_00_cos_beta2 * sin_beta_squared
    result[..., 1, 2] = part_02_cos_beta * sin_beta
    result[..., 2, 0] = result[..., 0, 2]
    result[..., 2, 1] = result[..., 1, 2]
    result[..., 2, 2] = (
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
    rdot: npt.ArrayLike,
    sigma_r: npt.ArrayLike,
    sigma_beta: npt.ArrayLike,
    sigma_rdot: npt.ArrayLike,
    rho: npt.ArrayLike,
) -> Floats:
    """Exactly unbiased estimate of the position.

    Name: polar_doppler.unbiased.estimate.
    Definition: u = e^-L h.
    Conditioning: measurement-conditioned: the measured symbols stand for the measurement.
    Source: Mo et al. 1998, doi:10.1109/7.705921.

    Args:
        r: range [m], 1 to 1e+08.
        beta: azimuth, counter-clockwise from the x axis [rad], -3.1416 to 3.1416.
        rdot: range rate [m/s], -10000 to 10000.
        sigma_r: standard deviation of the error of r [m], 0.001 to 10000.
        sigma_beta: standard deviation of the error of beta [rad], 1e-09 to 1.
        sigma_rdot: standard deviation of the error of rdot [m/s], 0.0001 to 1000.
        rho: correlation of the errors of r and rdot [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (3), unit [m, m, m^2/s].

    Accuracy: at most 7.01 ulp anywhere in this domain with independent errors, proved for elementary
    functions within 1 ulp (float64); in float32, with functions within 4 of its ulp, at most 19.1.
    """
    arguments = _floats(r, beta, rdot, sigma_r, sigma_beta, sigma_rdot, rho)
    r, beta, rdot, sigma_r, sigma_beta, sigma_rdot, rho = arguments
    cos_beta = np.cos(beta)
    sin_beta = np.sin(beta)
    attenuation_beta = np.exp(-0.5 * sigma_beta**2)
    part_0_cos_beta = r / attenuation_beta
    result = _empty(arguments, (3,))
    result[..., 0] = cos_beta * part_0_cos_beta
    result[..., 1] = part_0_cos_beta * sin_beta
    result[..., 2] = r * rdot - rho * sigma_r * sigma_rdot
    return result


def unbiased_covariance(
    *,
    r: npt.ArrayLike,
    beta: npt.ArrayLike,
    rdot: npt.ArrayLike,
    sigma_r: npt.ArrayLike,
    sigma_beta: npt.ArrayLike,
    sigma_rdot: npt.ArrayLike,
    rho: npt.ArrayLike,
) -> Floats:
    """Error covariance of the unbiased estimate u.

    Name: polar_doppler.unbiased.covariance.
    Definition: u u' - u (e^L h)' - (e^L h) u' + e^L(h h').
    Conditioning: measurement-conditioned: the measured symbols stand for the measurement.
    Source: Mo et al. 1998, doi:10.1109/7.705921.

    Args:
        r: range [m], 1 to 1e+08.
        beta: azimuth, counter-clockwise from the x axis [rad], -3.1416 to 3.1416.
        rdot: range rate [m/s], -10000 to 10000.
        sigma_r: standard deviation of the error of r [m], 0.001 to 10000.
        sigma_beta: standard deviation of the error of beta [rad], 1e-09 to 1.
        sigma_rdot: standard deviation of the error of rdot [m/s], 0.0001 to 1000.
        rho: correlation of the errors of r and rdot [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (3, 3), unit [m, m, m^2/s] × [m, m, m^2/s].

    Accuracy: at most 135 ulp anywhere in this domain with independent errors, proved for elementary functions
    within 1 ulp (float64); with correlations up to 0.99 in size at most 1200.
    """
    arguments = _floats(r, beta, rdot, sigma_r, sigma_beta, sigma_rdot, rho)
    r, beta, rdot, sigma_r, sigma_beta, sigma_rdot, rho = arguments
    cos_beta = np.cos(beta)
    sin_beta = np.sin(beta)
    attenuation_beta = np.exp(-0.5 * sigma_beta**2)
    shortfall_beta = -np.expm1(-0.5 * sigma_beta**2)
    term_1 = 1.0 / attenuation_beta**2
    attenuation_beta_squared = attenuation_beta**2
    product_1 = attenuation_beta * attenuation_beta_squared
    attenuation_beta_squared_squared = attenuation_beta_squared**2
    r_squared = r**2
    shortfall_beta_squared = shortfall_beta**2
    sum_1 = (
        2.0
        + 2.0 * product_1
        + 3.0 * attenuation_beta_squared
        + 4.0 * attenuation_beta
        + attenuation_beta_squared_squared
    )
    sigma_r_squared = sigma_r**2
    sum_2 = 0.5 + 0.5 * attenuation_beta_squared_squared
    part_00_cos_beta2 = 0.5 * r_squared * shortfall_beta_squared * sum_1 * term_1 + sigma_r_squared * sum_2
    sum_3 = 1.0 + attenuation_beta + attenuation_beta_squared + product_1
    part_00_sin_beta2 = (
        0.5 * r_squared * shortfall_beta * sum_3
        + 0.5 * shortfall_beta * sigma_r_squared * sum_3
    )
    sum_4 = (
        12.0 * product_1 * shortfall_beta_squared
        - 2.0 * attenuation_beta * attenuation_beta_squared**2
        + 13.0 * attenuation_beta_squared * shortfall_beta * shortfall_beta_squared
        + 3.0 * attenuation_beta_squared_squared * shortfall_beta
        + 6.0 * attenuation_beta * shortfall_beta_squared**2
        + shortfall_beta * shortfall_beta_squared**2
    )
    part_01_cos_beta_sin_beta = (
        attenuation_beta_squared_squared * sigma_r_squared
        + r_squared * shortfall_beta * sum_4 * term_1
    )
    sum_5 = attenuation_beta_squared - 2.0 * shortfall_beta_squared - 4.0 * attenuation_beta * shortfall_beta
    part_02_cos_beta = (
        attenuation_beta * rdot * sigma_r_squared
        + r * rho * sigma_r * sigma_rdot * sum_5 / attenuation_beta
    )
    cos_beta_squared = cos_beta**2
    sin_beta_squared = sin_beta**2
    sigma_rdot_squared = sigma_rdot**2
    result = _empty(arguments, (3, 3))
    result[..., 0, 0] = cos_beta_squared * part_00_cos_beta2 + part_00_sin_beta2 * sin_beta_squared
    result[..., 0, 1] = cos_beta * part_01_cos_beta_sin_beta * sin_beta
    result[..., 0, 2] = cos_beta * part_02_cos_beta
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = cos_beta_squared * part_00_sin_beta2 + part_00_cos_beta2 * sin_beta_squared
    result[..., 1, 2] = part_02_cos_beta * sin_beta
    result[..., 2, 0] = result[..., 0, 2]
    result[..., 2, 1] = result[..., 1, 2]
    result[..., 2, 2] = (
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
    rdot: npt.ArrayLike,
    sigma_r: npt.ArrayLike,
    sigma_beta: npt.ArrayLike,
    sigma_rdot: npt.ArrayLike,
    rho: npt.ArrayLike,
) -> Floats:
    """Posterior mean of the position under a flat prior.

    Name: polar_doppler.posterior.estimate.
    Definition: e^L h.
    Conditioning: measurement-conditioned: the measured symbols stand for the measurement.
    Source: Duan et al. 2004 modified unbiased, doi:10.1109/TAES.2004.1386889.

    Args:
        r: range [m], 1 to 1e+08.
        beta: azimuth, counter-clockwise from the x axis [rad], -3.1416 to 3.1416.
        rdot: range rate [m/s], -10000 to 10000.
        sigma_r: standard deviation of the error of r [m], 0.001 to 10000.
        sigma_beta: standard deviation of the error of beta [rad], 1e-09 to 1.
        sigma_rdot: standard deviation of the error of rdot [m/s], 0.0001 to 1000.
        rho: correlation of the errors of r and rdot [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (3), unit [m, m, m^2/s].

    Accuracy: at most 7.01 ulp anywhere in this domain with independent errors, proved for elementary
    functions within 1 ulp (float64); in float32, with functions within 4 of its ulp, at most 19.1.
    """
    arguments = _floats(r, beta, rdot, sigma_r, sigma_beta, sigma_rdot, rho)
    r, beta, rdot, sigma_r, sigma_beta, sigma_rdot, rho = arguments
    cos_beta = np.cos(beta)
    sin_beta = np.sin(beta)
    attenuation_beta = np.exp(-0.5 * sigma_beta**2)
    part_0_cos_beta = attenuation_beta * r
    result = _empty(arguments, (3,))
    result[..., 0] = cos_beta * part_0_cos_beta
    result[..., 1] = part_0_cos_beta * sin_beta
    result[..., 2] = r * rdot + rho * sigma_r * sigma_rdot
    return result


def posterior_covariance(
    *,
    r: npt.ArrayLike,
    beta: npt.ArrayLike,
    rdot: npt.ArrayLike,
    sigma_r: npt.ArrayLike,
    sigma_beta: npt.ArrayLike,
    sigma_rdot: npt.ArrayLike,
    rho: npt.ArrayLike,
) -> Floats:
    """Posterior covariance of the position under a flat prior.

    Name: polar_doppler.posterior.covariance.
    Definition: e^L(h h') - (e^L h)(e^L h)'.
    Conditioning: measurement-conditioned: the measured symbols stand for the measurement.
    Source: Duan et al. 2004 modified unbiased, doi:10.1109/TAES.2004.1386889.

    Args:
        r: range [m], 1 to 1e+08.
        beta: azimuth, counter-clockwise from the x axis [rad], -3.1416 to 3.1416.
        rdot: range rate [m/s], -10000 to 10000.
        sigma_r: standard deviation of the error of r [m], 0.001 to 10000.
        sigma_beta: standard deviation of the error of beta [rad], 1e-09 to 1.
        sigma_rdot: standard deviation of the error of rdot [m/s], 0.0001 to 1000.
        rho: correlation of the errors of r and rdot [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (3, 3), unit [m, m, m^2/s] × [m, m, m^2/s].

    Accuracy: at most 32.1 ulp anywhere in this domain with independent errors, proved for elementary
    functions within 1 ulp (float64); with correlations up to 0.99 in size at most 1100; in float32, with
    functions within 4 of its ulp, at most 243.
    """
    arguments = _floats(r, beta, rdot, sigma_r, sigma_beta, sigma_rdot, rho)
    r, beta, rdot, sigma_r, sigma_beta, sigma_rdot, rho = arguments
    cos_beta = np.cos(beta)
    sin_beta = np.sin(beta)
    attenuation_beta = np.exp(-0.5 * sigma_beta**2)
    shortfall_beta = -np.expm1(-0.5 * sigma_beta**2)
    attenuation_beta_squared = attenuation_beta**2
    r_squared = r**2
    sum_1 = 1.0 + 2.0 * attenuation_beta + attenuation_beta_squared
    attenuation_beta_squared_squared = attenuation_beta_squared**2
    sigma_r_squared = sigma_r**2
    sum_2 = 0.5 + 0.5 * attenuation_beta_squared_squared
    part_00_cos_beta2 = 0.5 * r_squared * shortfall_beta**2 * sum_1 + sigma_r_squared * sum_2
    sum_3 = 1.0 + attenuation_beta + attenuation_beta * attenuation_beta_squared + attenuation_beta_squared
    part_00_sin_beta2 = (
        0.5 * r_squared * shortfall_beta * sum_3
        + 0.5 * shortfall_beta * sigma_r_squared * sum_3
    )
    part_01_cos_beta_sin_beta = (
        (-1.0 - attenuation_beta) * attenuation_beta_squared * r_squared * shortfall_beta
        + attenuation_beta_squared_squared * sigma_r_squared
    )
    part_02_cos_beta = (
        attenuation_beta * r * rho * sigma_r * sigma_rdot
        + attenuation_beta * rdot * sigma_r_squared
    )
    cos_beta_squared = cos_beta**2
    sin_beta_squared = sin_beta**2
    sigma_rdot_squared = sigma_rdot**2
    result = _empty(arguments, (3, 3))
    result[..., 0, 0] = cos_beta_squared * part_00_cos_beta2 + part_00_sin_beta2 * sin_beta_squared
    result[..., 0, 1] = cos_beta * part_01_cos_beta_sin_beta * sin_beta
    result[..., 0, 2] = cos_beta * part_02_cos_beta
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = cos_beta_squared * part_00_sin_beta2 + part_00_cos_beta2 * sin_beta_squared
    result[..., 1, 2] = part_02_cos_beta * sin_beta
    result[..., 2, 0] = result[..., 0, 2]
    result[..., 2, 1] = result[..., 1, 2]
    result[..., 2, 2] = (
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
    rdot: npt.ArrayLike,
    sigma_r: npt.ArrayLike,
    sigma_beta: npt.ArrayLike,
    sigma_rdot: npt.ArrayLike,
    rho: npt.ArrayLike,
    predicted_sigma_r: npt.ArrayLike,
    predicted_sigma_beta: npt.ArrayLike,
    predicted_sigma_rdot: npt.ArrayLike,
    predicted_rho: npt.ArrayLike,
) -> Floats:
    """Covariance of the unbiased estimate u, averaged over a prediction.

    Name: polar_doppler.decorrelated.covariance.
    Definition: e^Lp [e^L(u u') - h h'].
    Conditioning: averaged over a prediction: the measured symbols stand for the predicted mean.
    Source: Bordonaro et al. 2014 decorrelated; Mo et al. 1998 R_m where Kp = K, R_t where Kp = 0,
    doi:10.1109/TAES.2014.120563, doi:10.1109/7.705921.

    Args:
        r: range [m], 1 to 1e+08.
        beta: azimuth, counter-clockwise from the x axis [rad], -3.1416 to 3.1416.
        rdot: range rate [m/s], -10000 to 10000.
        sigma_r: standard deviation of the error of r [m], 0.001 to 10000.
        sigma_beta: standard deviation of the error of beta [rad], 1e-09 to 1.
        sigma_rdot: standard deviation of the error of rdot [m/s], 0.0001 to 1000.
        rho: correlation of the errors of r and rdot [1], -1 to 1.
        predicted_sigma_r: standard deviation of the prediction of r [m], 0.001 to 10000.
        predicted_sigma_beta: standard deviation of the prediction of beta [rad], 1e-09 to 1.
        predicted_sigma_rdot: standard deviation of the prediction of rdot [m/s], 0.0001 to 1000.
        predicted_rho: correlation of the predictions of r and rdot [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (3, 3), unit [m, m, m^2/s] × [m, m, m^2/s].

    Accuracy: at most 51.1 ulp anywhere in this domain with independent errors, proved for elementary
    functions within 1 ulp (float64); with correlations up to 0.99 in size at most 1500.
    """
    arguments = _floats(r, beta, rdot, sigma_r, sigma_beta, sigma_rdot, rho, predicted_sigma_r, predicted_sigma_beta, predicted_sigma_rdot, predicted_rho)
    r, beta, rdot, sigma_r, sigma_beta, sigma_rdot, rho, predicted_sigma_r, predicted_sigma_beta, predicted_sigma_rdot, predicted_rho = arguments
    cos_beta = np.cos(beta)
    sin_beta = np.sin(beta)
    attenuation_predicted_beta = np.exp(-0.5 * predicted_sigma_beta**2)
    shortfall_predicted_beta = -np.expm1(-0.5 * predicted_sigma_beta**2)
    attenuation_beta = np.exp(-sigma_beta**2)
    shortfall_beta = -np.expm1(-sigma_beta**2)
    predicted_sigma_r_squared = predicted_sigma_r**2
    term_1 = 1.0 / attenuation_beta
    attenuation_predicted_beta_squared = attenuation_predicted_beta**2
    sum_1 = 1.0 + attenuation_predicted_beta
    sum_2 = 1.0 + attenuation_predicted_beta_squared
    sum_3 = 0.5 * shortfall_beta**2 * term_1 + 0.5 * shortfall_beta * shortfall_predicted_beta * sum_1 * sum_2
    r_squared = r**2
    attenuation_predicted_beta_squared_squared = attenuation_predicted_beta_squared**2
    sigma_r_squared = sigma_r**2
    sum_4 = 1.0 + attenuation_beta**2 * attenuation_predicted_beta_squared_squared
    part_00_cos_beta2 = (
        predicted_sigma_r_squared * sum_3
        + r_squared * sum_3
        + 0.5 * sigma_r_squared * sum_4 * term_1
    )
    sum_5 = 1.0 + attenuation_beta * attenuation_predicted_beta_squared_squared
    shortfall_predicted_beta_squared = shortfall_predicted_beta**2
    sum_6 = (
        2.0 * attenuation_beta * attenuation_predicted_beta * shortfall_predicted_beta
        + 2.0 * attenuation_predicted_beta * shortfall_beta * shortfall_predicted_beta
        + attenuation_beta * shortfall_predicted_beta_squared
        + attenuation_predicted_beta_squared * shortfall_beta
        + shortfall_beta * shortfall_predicted_beta_squared
    )
    sum_7 = 1.0 + attenuation_beta * attenuation_predicted_beta_squared
    part_00_sin_beta2 = (
        0.5 * predicted_sigma_r_squared * shortfall_beta * sum_5 * term_1
        + 0.5 * r_squared * shortfall_beta * sum_5 * term_1
        + 0.5 * sigma_r_squared * sum_6 * sum_7 * term_1
    )
    part_01_cos_beta_sin_beta = (
        attenuation_beta * attenuation_predicted_beta_squared_squared * sigma_r_squared
        - attenuation_predicted_beta_squared_squared * predicted_sigma_r_squared * shortfall_beta
        - attenuation_predicted_beta_squared_squared * r_squared * shortfall_beta
    )
    part_02_cos_beta = (
        attenuation_predicted_beta * r * rho * sigma_r * sigma_rdot
        + attenuation_predicted_beta * rdot * sigma_r_squared
    )
    cos_beta_squared = cos_beta**2
    sin_beta_squared = sin_beta**2
    sigma_rdot_squared = sigma_rdot**2
    result = _empty(arguments, (3, 3))
    result[..., 0, 0] = cos_beta_squared * part_00_cos_beta2 + part_00_sin_beta2 * sin_beta_squared
    result[..., 0, 1] = cos_beta * part_01_cos_beta_sin_beta * sin_beta
    result[..., 0, 2] = cos_beta * part_02_cos_beta
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = cos_beta_squared * part_00_sin_beta2 + part_00_cos_beta2 * sin_beta_squared
    result[..., 1, 2] = part_02_cos_beta * sin_beta
    result[..., 2, 0] = result[..., 0, 2]
    result[..., 2, 1] = result[..., 1, 2]
    result[..., 2, 2] = (
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
    rdot: npt.ArrayLike,
    sigma_r: npt.ArrayLike,
    sigma_beta: npt.ArrayLike,
    sigma_rdot: npt.ArrayLike,
    rho: npt.ArrayLike,
) -> Floats:
    """Covariance of the unbiased estimate u about the true position, R_t of Mo et al..

    Name: polar_doppler.unbiased.covariance.truth.
    Definition: e^L(u u') - h h'.
    Conditioning: truth-conditioned: the measured symbols stand for the true values.
    Source: Mo et al. 1998 R_t, doi:10.1109/7.705921.

    Args:
        r: range [m], 1 to 1e+08.
        beta: azimuth, counter-clockwise from the x axis [rad], -3.1416 to 3.1416.
        rdot: range rate [m/s], -10000 to 10000.
        sigma_r: standard deviation of the error of r [m], 0.001 to 10000.
        sigma_beta: standard deviation of the error of beta [rad], 1e-09 to 1.
        sigma_rdot: standard deviation of the error of rdot [m/s], 0.0001 to 1000.
        rho: correlation of the errors of r and rdot [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (3, 3), unit [m, m, m^2/s] × [m, m, m^2/s].

    Accuracy: at most 29.1 ulp anywhere in this domain with independent errors, proved for elementary
    functions within 1 ulp (float64); with correlations up to 0.99 in size at most 1100; in float32, with
    functions within 4 of its ulp, at most 243.
    """
    arguments = _floats(r, beta, rdot, sigma_r, sigma_beta, sigma_rdot, rho)
    r, beta, rdot, sigma_r, sigma_beta, sigma_rdot, rho = arguments
    cos_beta = np.cos(beta)
    sin_beta = np.sin(beta)
    attenuation_beta = np.exp(-sigma_beta**2)
    shortfall_beta = -np.expm1(-sigma_beta**2)
    term_1 = 1.0 / attenuation_beta
    r_squared = r**2
    sigma_r_squared = sigma_r**2
    part_00_cos_beta2 = (
        0.5 * r_squared * shortfall_beta**2 * term_1
        + 0.5 * (1.0 + attenuation_beta**2) * sigma_r_squared * term_1
    )
    sum_1 = 1.0 + attenuation_beta
    part_00_sin_beta2 = (
        0.5 * r_squared * shortfall_beta * sum_1 * term_1
        + 0.5 * shortfall_beta * sigma_r_squared * sum_1 * term_1
    )
    part_01_cos_beta_sin_beta = attenuation_beta * sigma_r_squared - r_squared * shortfall_beta
    part_02_cos_beta = r * rho * sigma_r * sigma_rdot + rdot * sigma_r_squared
    cos_beta_squared = cos_beta**2
    sin_beta_squared = sin_beta**2
    sigma_rdot_squared = sigma_rdot**2
    result = _empty(arguments, (3, 3))
    result[..., 0, 0] = cos_beta_squared * part_00_cos_beta2 + part_00_sin_beta2 * sin_beta_squared
    result[..., 0, 1] = cos_beta * part_01_cos_beta_sin_beta * sin_beta
    result[..., 0, 2] = cos_beta * part_02_cos_beta
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = cos_beta_squared * part_00_sin_beta2 + part_00_cos_beta2 * sin_beta_squared
    result[..., 1, 2] = part_02_cos_beta * sin_beta
    result[..., 2, 0] = result[..., 0, 2]
    result[..., 2, 1] = result[..., 1, 2]
    result[..., 2, 2] = (
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
    rdot: npt.ArrayLike,
    sigma_r: npt.ArrayLike,
    sigma_beta: npt.ArrayLike,
    sigma_rdot: npt.ArrayLike,
    rho: npt.ArrayLike,
) -> Floats:
    """Covariance of the unbiased estimate u, averaged over the truth, R_m of Mo et al..

    Name: polar_doppler.unbiased.covariance.averaged.
    Definition: e^L [e^L(u u') - h h'].
    Conditioning: measurement-conditioned: the measured symbols stand for the measurement.
    Source: Mo et al. 1998 R_m, doi:10.1109/7.705921.

    Args:
        r: range [m], 1 to 1e+08.
        beta: azimuth, counter-clockwise from the x axis [rad], -3.1416 to 3.1416.
        rdot: range rate [m/s], -10000 to 10000.
        sigma_r: standard deviation of the error of r [m], 0.001 to 10000.
        sigma_beta: standard deviation of the error of beta [rad], 1e-09 to 1.
        sigma_rdot: standard deviation of the error of rdot [m/s], 0.0001 to 1000.
        rho: correlation of the errors of r and rdot [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (3, 3), unit [m, m, m^2/s] × [m, m, m^2/s].

    Accuracy: at most 102 ulp anywhere in this domain with independent errors, proved for elementary functions
    within 1 ulp (float64); with correlations up to 0.99 in size at most 1300; in float32, with functions
    within 4 of its ulp, at most 313.
    """
    arguments = _floats(r, beta, rdot, sigma_r, sigma_beta, sigma_rdot, rho)
    r, beta, rdot, sigma_r, sigma_beta, sigma_rdot, rho = arguments
    cos_beta = np.cos(beta)
    sin_beta = np.sin(beta)
    attenuation_beta = np.exp(-0.5 * sigma_beta**2)
    shortfall_beta = -np.expm1(-0.5 * sigma_beta**2)
    term_1 = 1.0 / attenuation_beta**2
    attenuation_beta_squared = attenuation_beta**2
    product_1 = attenuation_beta * attenuation_beta_squared
    attenuation_beta_squared_squared = attenuation_beta_squared**2
    product_2 = attenuation_beta * attenuation_beta_squared**2
    attenuation_beta_squared_cubed = attenuation_beta_squared * attenuation_beta_squared**2
    r_squared = r**2
    shortfall_beta_squared = shortfall_beta**2
    sum_1 = (
        1.0
        + 2.0 * attenuation_beta
        + 2.0 * attenuation_beta_squared
        + 2.0 * attenuation_beta_squared_squared
        + 2.0 * product_1
        + 2.0 * product_2
        + attenuation_beta_squared_cubed
    )
    sigma_r_squared = sigma_r**2
    sum_2 = (
        2.0
        - attenuation_beta_squared
        - attenuation_beta_squared_cubed
        + 2.0 * (attenuation_beta_squared**2)**2
    )
    part_00_cos_beta2 = (
        0.5 * r_squared * shortfall_beta_squared * sum_1 * term_1
        + 0.5 * sigma_r_squared * sum_2 * term_1
    )
    product_3 = attenuation_beta * attenuation_beta_squared * attenuation_beta_squared**2
    sum_3 = 1.0 + attenuation_beta + attenuation_beta_squared_cubed + product_3
    sum_4 = (
        2.0
        + 2.0 * attenuation_beta
        + 2.0 * attenuation_beta_squared_cubed
        + 2.0 * product_3
        + attenuation_beta_squared
        + attenuation_beta_squared_squared
        + product_1
        + product_2
    )
    part_00_sin_beta2 = (
        0.5 * r_squared * shortfall_beta * sum_3 * term_1
        + 0.5 * shortfall_beta * sigma_r_squared * sum_4 * term_1
    )
    sum_5 = attenuation_beta_squared - 2.0 * attenuation_beta * shortfall_beta - shortfall_beta_squared
    part_01_cos_beta_sin_beta = (
        (-1.0 - attenuation_beta) * attenuation_beta_squared_squared * r_squared * shortfall_beta
        + attenuation_beta_squared_squared * sigma_r_squared * sum_5
    )
    part_02_cos_beta = (
        attenuation_beta * r * rho * sigma_r * sigma_rdot
        + attenuation_beta * rdot * sigma_r_squared
    )
    cos_beta_squared = cos_beta**2
    sin_beta_squared = sin_beta**2
    sigma_rdot_squared = sigma_rdot**2
    result = _empty(arguments, (3, 3))
    result[..., 0, 0] = cos_beta_squared * part_00_cos_beta2 + part_00_sin_beta2 * sin_beta_squared
    result[..., 0, 1] = cos_beta * part_01_cos_beta_sin_beta * sin_beta
    result[..., 0, 2] = cos_beta * part_02_cos_beta
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = cos_beta_squared * part_00_sin_beta2 + part_00_cos_beta2 * sin_beta_squared
    result[..., 1, 2] = part_02_cos_beta * sin_beta
    result[..., 2, 0] = result[..., 0, 2]
    result[..., 2, 1] = result[..., 1, 2]
    result[..., 2, 2] = (
        2.0 * r * rdot * rho * sigma_r * sigma_rdot
        + 3.0 * sigma_r_squared * sigma_rdot_squared
        + 3.0 * rho**2 * sigma_r_squared * sigma_rdot_squared
        + r_squared * sigma_rdot_squared
        + rdot**2 * sigma_r_squared
    )
    return result
