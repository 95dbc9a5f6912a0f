"""NumPy functions of the quantities initiation.*.

Written by radartrack regenerate, generator 1, derivation 13feed92288a652b; not to be edited.
"""

import numpy as np
import numpy.typing as npt

__all__ = [
    "one_plot_polar_doppler_covariance",
    "one_plot_polar_doppler_estimate",
    "one_plot_spherical_doppler_covariance",
    "one_plot_spherical_doppler_estimate",
    "two_plots_covariance",
    "two_plots_estimate",
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


def one_plot_polar_doppler_estimate(
    *,
    r: npt.ArrayLike,
    beta: npt.ArrayLike,
    rdot: npt.ArrayLike,
    sigma_r: npt.ArrayLike,
    sigma_beta: npt.ArrayLike,
    sigma_rdot: npt.ArrayLike,
    rho: npt.ArrayLike,
    sigma_v: npt.ArrayLike,
) -> Floats:
    """Mean of position and velocity given one plot of polar_doppler.

    Name: initiation.one_plot.polar_doppler.estimate.
    Definition: E[h | plot].
    Conditioning: measurement-conditioned: the measured symbols stand for the measurement.
    Source: Bar-Shalom, Li & Kirubarajan 2001 one-point initialisation, doi:10.1002/0471221279.

    Args:
        r: range [m], 1 to 1e+08.
        beta: azimuth, counter-clockwise from the x axis [rad], -3.1416 to 3.1416.
        rdot: range rate [m/s], -10000 to 10000.
        sigma_r: standard deviation of the error of r [m], 0.001 to 10000.
        sigma_beta: standard deviation of the error of beta [rad], 1e-09 to 1.
        sigma_rdot: standard deviation of the error of rdot [m/s], 0.0001 to 1000.
        rho: correlation of the errors of r and rdot [1], -1 to 1.
        sigma_v: standard deviation of each component of targets' velocities [m/s], 1 to 1000.

    Returns:
        Shape of the broadcast arguments + (4), unit [m, m, m/s, m/s].

    Accuracy: at most 15.1 ulp anywhere in this domain with independent errors, proved for elementary
    functions within 1 ulp (float64); in float32, with functions within 4 of its ulp, at most 27.1.
    """
    arguments = _floats(r, beta, rdot, sigma_r, sigma_beta, sigma_rdot, rho, sigma_v)
    r, beta, rdot, sigma_r, sigma_beta, sigma_rdot, rho, sigma_v = arguments
    sigma_v_squared = sigma_v**2
    total_variance = sigma_rdot**2 + sigma_v_squared
    term_1 = 1.0 / total_variance
    share_of_the_plot = sigma_v_squared * term_1
    likely_range = r - rdot * rho * sigma_r * sigma_rdot * term_1
    likely_rate = rdot * share_of_the_plot
    cos_beta = np.cos(beta)
    sin_beta = np.sin(beta)
    attenuation_beta = np.exp(-0.5 * sigma_beta**2)
    part_0_cos_beta = attenuation_beta * likely_range
    part_2_cos_beta = attenuation_beta * likely_rate
    result = _empty(arguments, (4,))
    result[..., 0] = cos_beta * part_0_cos_beta
    result[..., 1] = part_0_cos_beta * sin_beta
    result[..., 2] = cos_beta * part_2_cos_beta
    result[..., 3] = part_2_cos_beta * sin_beta
    return result


def one_plot_polar_doppler_covariance(
    *,
    r: npt.ArrayLike,
    beta: npt.ArrayLike,
    rdot: npt.ArrayLike,
    sigma_r: npt.ArrayLike,
    sigma_beta: npt.ArrayLike,
    sigma_rdot: npt.ArrayLike,
    rho: npt.ArrayLike,
    sigma_v: npt.ArrayLike,
) -> Floats:
    """Covariance of position and velocity given one plot of polar_doppler.

    Name: initiation.one_plot.polar_doppler.covariance.
    Definition: E[h h' | plot] - E[h | plot] E[h | plot]'.
    Conditioning: measurement-conditioned: the measured symbols stand for the measurement.
    Source: Bar-Shalom, Li & Kirubarajan 2001 one-point initialisation, doi:10.1002/0471221279.

    Args:
        r: range [m], 1 to 1e+08.
        beta: azimuth, counter-clockwise from the x axis [rad], -3.1416 to 3.1416.
        rdot: range rate [m/s], -10000 to 10000.
        sigma_r: standard deviation of the error of r [m], 0.001 to 10000.
        sigma_beta: standard deviation of the error of beta [rad], 1e-09 to 1.
        sigma_rdot: standard deviation of the error of rdot [m/s], 0.0001 to 1000.
        rho: correlation of the errors of r and rdot [1], -1 to 1.
        sigma_v: standard deviation of each component of targets' velocities [m/s], 1 to 1000.

    Returns:
        Shape of the broadcast arguments + (4, 4), unit [m, m, m/s, m/s] × [m, m, m/s, m/s].

    Accuracy: at most 51.4 ulp anywhere in this domain with independent errors, proved for elementary
    functions within 1 ulp (float64).
    """
    arguments = _floats(r, beta, rdot, sigma_r, sigma_beta, sigma_rdot, rho, sigma_v)
    r, beta, rdot, sigma_r, sigma_beta, sigma_rdot, rho, sigma_v = arguments
    sigma_v_squared = sigma_v**2
    total_variance = sigma_rdot**2 + sigma_v_squared
    term_1 = 1.0 / total_variance
    share_of_the_plot = sigma_v_squared * term_1
    spread_of_the_range = np.sqrt((1.0 - rho) * (1.0 + rho) + rho**2 * share_of_the_plot)
    likely_range = r - rdot * rho * sigma_r * sigma_rdot * term_1
    likely_rate = rdot * share_of_the_plot
    sigma_likely_range = sigma_r * spread_of_the_range
    term_2 = np.sqrt(share_of_the_plot)
    sigma_likely_rate = sigma_rdot * term_2
    likely_rho = rho * term_2 / spread_of_the_range
    cos_beta = np.cos(beta)
    sin_beta = np.sin(beta)
    attenuation_beta = np.exp(-sigma_beta**2)
    shortfall_beta = -np.expm1(-sigma_beta**2)
    likely_range_squared = likely_range**2
    shortfall_beta_squared = shortfall_beta**2
    attenuation_beta_squared = attenuation_beta**2
    sum_1 = 0.5 + 0.5 * attenuation_beta_squared
    sigma_likely_range_squared = sigma_likely_range**2
    part_00_cos_beta2 = (
        0.5 * likely_range_squared * shortfall_beta_squared
        + sigma_likely_range_squared * sum_1
    )
    sum_2 = 1.0 + attenuation_beta
    part_00_sin_beta2 = (
        0.5 * likely_range_squared * shortfall_beta * sum_2
        + 0.5 * shortfall_beta * sigma_likely_range_squared * sum_2
    )
    part_01_cos_beta_sin_beta = (
        attenuation_beta_squared * sigma_likely_range_squared
        - attenuation_beta * likely_range_squared * shortfall_beta
    )
    part_02_cos_beta2 = (
        0.5 * likely_range * likely_rate * shortfall_beta_squared
        + likely_rho * sigma_likely_range * sigma_likely_rate * sum_1
    )
    part_02_sin_beta2 = (
        0.5 * likely_range * likely_rate * shortfall_beta * sum_2
        + 0.5 * likely_rho * shortfall_beta * sigma_likely_range * sigma_likely_rate * sum_2
    )
    part_03_cos_beta_sin_beta = (
        attenuation_beta_squared * likely_rho * sigma_likely_range * sigma_likely_rate
        - attenuation_beta * likely_range * likely_rate * shortfall_beta
    )
    likely_rate_squared = likely_rate**2
    sigma_likely_rate_squared = sigma_likely_rate**2
    part_22_cos_beta2 = (
        0.5 * likely_rate_squared * shortfall_beta_squared
        + 0.5 * shortfall_beta * sigma_v_squared * sum_2
        + sigma_likely_rate_squared * sum_1
    )
    part_22_sin_beta2 = (
        0.5 * likely_rate_squared * shortfall_beta * sum_2
        + 0.5 * shortfall_beta * sigma_likely_rate_squared * sum_2
        + sigma_v_squared * sum_1
    )
    part_23_cos_beta_sin_beta = (
        attenuation_beta_squared * sigma_likely_rate_squared
        - attenuation_beta * likely_rate_squared * shortfall_beta
        - attenuation_beta_squared * sigma_v_squared
    )
    cos_beta_squared = cos_beta**2
    sin_beta_squared = sin_beta**2
    result = _empty(arguments, (4, 4))
    result[..., 0, 0] = cos_beta_squared * part_00_cos_beta2 + part_00_sin_beta2 * sin_beta_squared
    result[..., 0, 1] = cos_beta * part_01_cos_beta_sin_beta * sin_beta
    result[..., 0, 2] = cos_beta_squared * part_02_cos_beta2 + part_02_sin_beta2 * sin_beta_squared
    result[..., 0, 3] = cos_beta * part_03_cos_beta_sin_beta * sin_beta
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = cos_beta_squared * part_00_sin_beta2 + part_00_cos_beta2 * sin_beta_squared
    result[..., 1, 2] = result[..., 0, 3]
    result[..., 1, 3] = cos_beta_squared * part_02_sin_beta2 + part_02_cos_beta2 * sin_beta_squared
    result[..., 2, 0] = result[..., 0, 2]
    result[..., 2, 1] = result[..., 0, 3]
    result[..., 2, 2] = cos_beta_squared * part_22_cos_beta2 + part_22_sin_beta2 * sin_beta_squared
    result[..., 2, 3] = cos_beta * part_23_cos_beta_sin_beta * sin_beta
    result[..., 3, 0] = result[..., 0, 3]
    result[..., 3, 1] = result[..., 1, 3]
    result[..., 3, 2] = result[..., 2, 3]
    result[..., 3, 3] = cos_beta_squared * part_22_sin_beta2 + part_22_cos_beta2 * sin_beta_squared
    return result


def one_plot_spherical_doppler_estimate(
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
    sigma_v: npt.ArrayLike,
) -> Floats:
    """Mean of position and velocity given one plot of spherical_doppler.

    Name: initiation.one_plot.spherical_doppler.estimate.
    Definition: E[h | plot].
    Conditioning: measurement-conditioned: the measured symbols stand for the measurement.
    Source: Bar-Shalom, Li & Kirubarajan 2001 one-point initialisation, doi:10.1002/0471221279.

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
        sigma_v: standard deviation of each component of targets' velocities [m/s], 1 to 1000.

    Returns:
        Shape of the broadcast arguments + (6), unit [m, m, m, m/s, m/s, m/s].

    Accuracy: at most 22.1 ulp anywhere in this domain with independent errors, proved for elementary
    functions within 1 ulp (float64).
    """
    arguments = _floats(r, beta, epsilon, rdot, sigma_r, sigma_beta, sigma_epsilon, sigma_rdot, rho, sigma_v)
    r, beta, epsilon, rdot, sigma_r, sigma_beta, sigma_epsilon, sigma_rdot, rho, sigma_v = arguments
    sigma_v_squared = sigma_v**2
    total_variance = sigma_rdot**2 + sigma_v_squared
    term_1 = 1.0 / total_variance
    share_of_the_plot = sigma_v_squared * term_1
    likely_range = r - rdot * rho * sigma_r * sigma_rdot * term_1
    likely_rate = rdot * share_of_the_plot
    cos_beta = np.cos(beta)
    sin_beta = np.sin(beta)
    cos_epsilon = np.cos(epsilon)
    sin_epsilon = np.sin(epsilon)
    attenuation_beta = np.exp(-0.5 * sigma_beta**2)
    attenuation_epsilon = np.exp(-0.5 * sigma_epsilon**2)
    part_0_cos_epsilon_sin_beta = attenuation_beta * attenuation_epsilon * likely_range
    part_3_cos_epsilon_sin_beta = attenuation_beta * attenuation_epsilon * likely_rate
    result = _empty(arguments, (6,))
    result[..., 0] = cos_epsilon * part_0_cos_epsilon_sin_beta * sin_beta
    result[..., 1] = cos_beta * cos_epsilon * part_0_cos_epsilon_sin_beta
    result[..., 2] = attenuation_epsilon * likely_range * sin_epsilon
    result[..., 3] = cos_epsilon * part_3_cos_epsilon_sin_beta * sin_beta
    result[..., 4] = cos_beta * cos_epsilon * part_3_cos_epsilon_sin_beta
    result[..., 5] = attenuation_epsilon * likely_rate * sin_epsilon
    return result


def one_plot_spherical_doppler_covariance(
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
    sigma_v: npt.ArrayLike,
) -> Floats:
    """Covariance of position and velocity given one plot of spherical_doppler.

    Name: initiation.one_plot.spherical_doppler.covariance.
    Definition: E[h h' | plot] - E[h | plot] E[h | plot]'.
    Conditioning: measurement-conditioned: the measured symbols stand for the measurement.
    Source: Bar-Shalom, Li & Kirubarajan 2001 one-point initialisation, doi:10.1002/0471221279.

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
        sigma_v: standard deviation of each component of targets' velocities [m/s], 1 to 1000.

    Returns:
        Shape of the broadcast arguments + (6, 6), unit [m, m, m, m/s, m/s, m/s] × [m, m, m, m/s, m/s, m/s].

    Accuracy: at most 284 ulp anywhere in this domain with independent errors, proved for elementary functions
    within 1 ulp (float64).
    """
    arguments = _floats(r, beta, epsilon, rdot, sigma_r, sigma_beta, sigma_epsilon, sigma_rdot, rho, sigma_v)
    r, beta, epsilon, rdot, sigma_r, sigma_beta, sigma_epsilon, sigma_rdot, rho, sigma_v = arguments
    sigma_v_squared = sigma_v**2
    total_variance = sigma_rdot**2 + sigma_v_squared
    term_1 = 1.0 / total_variance
    share_of_the_plot = sigma_v_squared * term_1
    spread_of_the_range = np.sqrt((1.0 - rho) * (1.0 + rho) + rho**2 * share_of_the_plot)
    likely_range = r - rdot * rho * sigma_r * sigma_rdot * term_1
    likely_rate = rdot * share_of_the_plot
    sigma_likely_range = sigma_r * spread_of_the_range
    term_2 = np.sqrt(share_of_the_plot)
    sigma_likely_rate = sigma_rdot * term_2
    likely_rho = rho * term_2 / spread_of_the_range
    cos_beta = np.cos(beta)
    sin_beta = np.sin(beta)
    cos_epsilon = np.cos(epsilon)
    sin_epsilon = np.sin(epsilon)
    attenuation_beta = np.exp(-0.5 * sigma_beta**2)
    shortfall_beta = -np.expm1(-0.5 * sigma_beta**2)
    attenuation_epsilon = np.exp(-sigma_epsilon**2)
    shortfall_epsilon = -np.expm1(-sigma_epsilon**2)
    sum_1 = 1.0 + attenuation_beta
    attenuation_beta_squared = attenuation_beta**2
    sum_2 = 1.0 + attenuation_beta_squared
    attenuation_epsilon_squared = attenuation_epsilon**2
    sum_3 = 1.0 + attenuation_epsilon_squared
    likely_range_squared = likely_range**2
    sigma_likely_range_squared = sigma_likely_range**2
    part_00_cos_beta2_cos_epsilon2 = (
        0.25 * likely_range_squared * shortfall_beta * sum_1 * sum_2 * sum_3
        + 0.25 * shortfall_beta * sigma_likely_range_squared * sum_1 * sum_2 * sum_3
    )
    sum_4 = 1.0 + attenuation_epsilon
    part_00_cos_beta2_sin_epsilon2 = (
        0.25 * likely_range_squared * shortfall_beta * shortfall_epsilon * sum_1 * sum_2 * sum_4
        + 0.25 * shortfall_beta * shortfall_epsilon * sigma_likely_range_squared * sum_1 * sum_2 * sum_4
    )
    shortfall_beta_squared = shortfall_beta**2
    product_1 = shortfall_beta * shortfall_beta_squared
    shortfall_epsilon_squared = shortfall_epsilon**2
    attenuation_beta_squared_squared = attenuation_beta_squared**2
    shortfall_beta_squared_squared = shortfall_beta_squared**2
    sum_5 = (
        2.0 * attenuation_beta * attenuation_epsilon * product_1 * shortfall_epsilon
        + 2.0 * attenuation_beta * attenuation_epsilon_squared * product_1
        + 2.0 * attenuation_beta_squared * attenuation_epsilon * shortfall_beta_squared * shortfall_epsilon
        + 2.0 * attenuation_beta_squared * attenuation_epsilon_squared * shortfall_beta_squared
        + 1.5 * attenuation_beta_squared * shortfall_beta_squared * shortfall_epsilon_squared
        + attenuation_beta * attenuation_beta_squared * shortfall_beta * shortfall_epsilon_squared
        + attenuation_beta * product_1 * shortfall_epsilon_squared
        + 0.5 * attenuation_beta_squared_squared * shortfall_epsilon_squared
        + 0.5 * attenuation_epsilon * shortfall_beta_squared_squared * shortfall_epsilon
        + 0.5 * attenuation_epsilon_squared * shortfall_beta_squared_squared
        + 0.25 * shortfall_beta_squared_squared * shortfall_epsilon_squared
    )
    product_2 = 0.25 * attenuation_beta_squared_squared * attenuation_epsilon_squared
    sum_6 = 0.25 + 0.25 * attenuation_beta_squared_squared + 0.25 * attenuation_epsilon_squared + product_2
    part_00_cos_epsilon2_sin_beta2 = likely_range_squared * sum_5 + sigma_likely_range_squared * sum_6
    sum_7 = (
        1.0
        + attenuation_beta_squared_squared
        + attenuation_beta_squared_squared * attenuation_epsilon
        + attenuation_epsilon
    )
    part_00_sin_beta2_sin_epsilon2 = (
        0.25 * likely_range_squared * shortfall_epsilon * sum_7
        + 0.25 * shortfall_epsilon * sigma_likely_range_squared * sum_7
    )
    sum_8 = (
        attenuation_beta_squared * shortfall_epsilon_squared
        - 2.0 * attenuation_epsilon * shortfall_beta_squared * shortfall_epsilon
        - 2.0 * attenuation_epsilon_squared * shortfall_beta_squared
        - 4.0 * attenuation_beta * attenuation_epsilon * shortfall_beta * shortfall_epsilon
        - 4.0 * attenuation_beta * attenuation_epsilon_squared * shortfall_beta
    )
    part_01_cos_beta_cos_epsilon2_sin_beta = (
        0.5 * attenuation_beta_squared * likely_range_squared * sum_8
        + 0.5 * attenuation_beta_squared_squared * sigma_likely_range_squared * sum_3
    )
    part_01_cos_beta_sin_beta_sin_epsilon2 = (
        0.5 * attenuation_beta_squared_squared * likely_range_squared * shortfall_epsilon * sum_4
        + 0.5 * attenuation_beta_squared_squared * shortfall_epsilon * sigma_likely_range_squared * sum_4
    )
    part_02_cos_epsilon_sin_beta_sin_epsilon = (
        attenuation_beta * attenuation_epsilon_squared * sigma_likely_range_squared
        - attenuation_beta * attenuation_epsilon * likely_range_squared * shortfall_epsilon
    )
    part_03_cos_beta2_cos_epsilon2 = (
        0.25 * likely_range * likely_rate * shortfall_beta * sum_1 * sum_2 * sum_3
        + 0.25 * likely_rho * shortfall_beta * sigma_likely_range * sigma_likely_rate * sum_1 * sum_2 * sum_3
    )
    part_03_cos_beta2_sin_epsilon2 = (
        0.25 * likely_range * likely_rate * shortfall_beta * shortfall_epsilon * sum_1 * sum_2 * sum_4
        + 0.25 * likely_rho * shortfall_beta * shortfall_epsilon * sigma_likely_range * sigma_likely_rate * sum_1 * sum_2 * sum_4
    )
    part_03_cos_epsilon2_sin_beta2 = (
        likely_range * likely_rate * sum_5
        + likely_rho * sigma_likely_range * sigma_likely_rate * sum_6
    )
    part_03_sin_beta2_sin_epsilon2 = (
        0.25 * likely_range * likely_rate * shortfall_epsilon * sum_7
        + 0.25 * likely_rho * shortfall_epsilon * sigma_likely_range * sigma_likely_rate * sum_7
    )
    part_04_cos_beta_cos_epsilon2_sin_beta = (
        0.5 * attenuation_beta_squared * likely_range * likely_rate * sum_8
        + 0.5 * attenuation_beta_squared_squared * likely_rho * sigma_likely_range * sigma_likely_rate * sum_3
    )
    part_04_cos_beta_sin_beta_sin_epsilon2 = (
        0.5 * attenuation_beta_squared_squared * likely_range * likely_rate * shortfall_epsilon * sum_4
        + 0.5 * attenuation_beta_squared_squared * likely_rho * shortfall_epsilon * sigma_likely_range * sigma_likely_rate * sum_4
    )
    part_05_cos_epsilon_sin_beta_sin_epsilon = (
        attenuation_beta * attenuation_epsilon_squared * likely_rho * sigma_likely_range * sigma_likely_rate
        - attenuation_beta * attenuation_epsilon * likely_range * likely_rate * shortfall_epsilon
    )
    part_22_cos_epsilon2 = (
        0.5 * likely_range_squared * shortfall_epsilon * sum_4
        + 0.5 * shortfall_epsilon * sigma_likely_range_squared * sum_4
    )
    sum_9 = 0.5 + 0.5 * attenuation_epsilon_squared
    part_22_sin_epsilon2 = (
        0.5 * likely_range_squared * shortfall_epsilon_squared
        + sigma_likely_range_squared * sum_9
    )
    part_25_cos_epsilon2 = (
        0.5 * likely_range * likely_rate * shortfall_epsilon * sum_4
        + 0.5 * likely_rho * shortfall_epsilon * sigma_likely_range * sigma_likely_rate * sum_4
    )
    part_25_sin_epsilon2 = (
        0.5 * likely_range * likely_rate * shortfall_epsilon_squared
        + likely_rho * sigma_likely_range * sigma_likely_rate * sum_9
    )
    likely_rate_squared = likely_rate**2
    sigma_likely_rate_squared = sigma_likely_rate**2
    sum_10 = 0.75 - 0.25 * attenuation_epsilon_squared + 0.25 * attenuation_beta_squared_squared + product_2
    part_33_cos_beta2_cos_epsilon2 = (
        0.25 * likely_rate_squared * shortfall_beta * sum_1 * sum_2 * sum_3
        + 0.25 * shortfall_beta * sigma_likely_rate_squared * sum_1 * sum_2 * sum_3
        + sigma_v_squared * sum_10
    )
    sum_11 = (
        0.75
        - 0.25 * attenuation_beta_squared_squared * attenuation_epsilon_squared
        + 0.25 * attenuation_beta_squared_squared
        + 0.25 * attenuation_epsilon_squared
    )
    part_33_cos_beta2_sin_epsilon2 = (
        0.25 * likely_rate_squared * shortfall_beta * shortfall_epsilon * sum_1 * sum_2 * sum_4
        + 0.25 * shortfall_beta * shortfall_epsilon * sigma_likely_rate_squared * sum_1 * sum_2 * sum_4
        + sigma_v_squared * sum_11
    )
    sum_12 = 0.25 * shortfall_beta * sum_1 * sum_2 * sum_3 + 0.5 * shortfall_epsilon * sum_4
    part_33_cos_epsilon2_sin_beta2 = (
        likely_rate_squared * sum_5
        + sigma_likely_rate_squared * sum_6
        + sigma_v_squared * sum_12
    )
    sum_13 = 0.75 - 0.25 * attenuation_beta_squared_squared + 0.25 * attenuation_epsilon_squared + product_2
    part_33_sin_beta2_sin_epsilon2 = (
        0.25 * likely_rate_squared * shortfall_epsilon * sum_7
        + 0.25 * shortfall_epsilon * sigma_likely_rate_squared * sum_7
        + sigma_v_squared * sum_13
    )
    sum_14 = -1.0 - attenuation_epsilon_squared
    part_34_cos_beta_cos_epsilon2_sin_beta = (
        0.5 * attenuation_beta_squared * likely_rate_squared * sum_8
        + 0.5 * attenuation_beta_squared_squared * sigma_likely_rate_squared * sum_3
        + 0.5 * attenuation_beta_squared_squared * sigma_v_squared * sum_14
    )
    part_34_cos_beta_sin_beta_sin_epsilon2 = (
        0.5 * attenuation_beta_squared_squared * likely_rate_squared * shortfall_epsilon * sum_4
        + 0.5 * attenuation_beta_squared_squared * shortfall_epsilon * sigma_likely_rate_squared * sum_4
        + 0.5 * (-1.0 - attenuation_epsilon) * attenuation_beta_squared_squared * shortfall_epsilon * sigma_v_squared
    )
    part_35_cos_epsilon_sin_beta_sin_epsilon = (
        attenuation_beta * attenuation_epsilon_squared * sigma_likely_rate_squared
        - attenuation_beta * attenuation_epsilon * likely_rate_squared * shortfall_epsilon
        - attenuation_beta * attenuation_epsilon_squared * sigma_v_squared
    )
    part_55_cos_epsilon2 = (
        0.5 * likely_rate_squared * shortfall_epsilon * sum_4
        + 0.5 * shortfall_epsilon * sigma_likely_rate_squared * sum_4
        + sigma_v_squared * sum_9
    )
    part_55_sin_epsilon2 = (
        0.5 * likely_rate_squared * shortfall_epsilon_squared
        + 0.5 * shortfall_epsilon * sigma_v_squared * sum_4
        + sigma_likely_rate_squared * sum_9
    )
    cos_beta_squared = cos_beta**2
    cos_epsilon_squared = cos_epsilon**2
    sin_epsilon_squared = sin_epsilon**2
    sin_beta_squared = sin_beta**2
    result = _empty(arguments, (6, 6))
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
    result[..., 0, 3] = (
        cos_beta_squared * cos_epsilon_squared * part_03_cos_beta2_cos_epsilon2
        + cos_beta_squared * part_03_cos_beta2_sin_epsilon2 * sin_epsilon_squared
        + cos_epsilon_squared * part_03_cos_epsilon2_sin_beta2 * sin_beta_squared
        + part_03_sin_beta2_sin_epsilon2 * sin_beta_squared * sin_epsilon_squared
    )
    result[..., 0, 4] = (
        cos_beta * cos_epsilon_squared * part_04_cos_beta_cos_epsilon2_sin_beta * sin_beta
        + cos_beta * part_04_cos_beta_sin_beta_sin_epsilon2 * sin_beta * sin_epsilon_squared
    )
    result[..., 0, 5] = cos_epsilon * part_05_cos_epsilon_sin_beta_sin_epsilon * sin_beta * sin_epsilon
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = (
        cos_beta_squared * cos_epsilon_squared * part_00_cos_epsilon2_sin_beta2
        + cos_beta_squared * part_00_sin_beta2_sin_epsilon2 * sin_epsilon_squared
        + cos_epsilon_squared * part_00_cos_beta2_cos_epsilon2 * sin_beta_squared
        + part_00_cos_beta2_sin_epsilon2 * sin_beta_squared * sin_epsilon_squared
    )
    result[..., 1, 2] = cos_beta * cos_epsilon * part_02_cos_epsilon_sin_beta_sin_epsilon * sin_epsilon
    result[..., 1, 3] = result[..., 0, 4]
    result[..., 1, 4] = (
        cos_beta_squared * cos_epsilon_squared * part_03_cos_epsilon2_sin_beta2
        + cos_beta_squared * part_03_sin_beta2_sin_epsilon2 * sin_epsilon_squared
        + cos_epsilon_squared * part_03_cos_beta2_cos_epsilon2 * sin_beta_squared
        + part_03_cos_beta2_sin_epsilon2 * sin_beta_squared * sin_epsilon_squared
    )
    result[..., 1, 5] = cos_beta * cos_epsilon * part_05_cos_epsilon_sin_beta_sin_epsilon * sin_epsilon
    result[..., 2, 0] = result[..., 0, 2]
    result[..., 2, 1] = result[..., 1, 2]
    result[..., 2, 2] = (
        cos_epsilon_squared * part_22_cos_epsilon2
        + part_22_sin_epsilon2 * sin_epsilon_squared
    )
    result[..., 2, 3] = result[..., 0, 5]
    result[..., 2, 4] = result[..., 1, 5]
    result[..., 2, 5] = (
        cos_epsilon_squared * part_25_cos_epsilon2
        + part_25_sin_epsilon2 * sin_epsilon_squared
    )
    result[..., 3, 0] = result[..., 0, 3]
    result[..., 3, 1] = result[..., 0, 4]
    result[..., 3, 2] = result[..., 0, 5]
    result[..., 3, 3] = (
        cos_beta_squared * cos_epsilon_squared * part_33_cos_beta2_cos_epsilon2
        + cos_beta_squared * part_33_cos_beta2_sin_epsilon2 * sin_epsilon_squared
        + cos_epsilon_squared * part_33_cos_epsilon2_sin_beta2 * sin_beta_squared
        + part_33_sin_beta2_sin_epsilon2 * sin_beta_squared * sin_epsilon_squared
    )
    result[..., 3, 4] = (
        cos_beta * cos_epsilon_squared * part_34_cos_beta_cos_epsilon2_sin_beta * sin_beta
        + cos_beta * part_34_cos_beta_sin_beta_sin_epsilon2 * sin_beta * sin_epsilon_squared
    )
    result[..., 3, 5] = cos_epsilon * part_35_cos_epsilon_sin_beta_sin_epsilon * sin_beta * sin_epsilon
    result[..., 4, 0] = result[..., 0, 4]
    result[..., 4, 1] = result[..., 1, 4]
    result[..., 4, 2] = result[..., 1, 5]
    result[..., 4, 3] = result[..., 3, 4]
    result[..., 4, 4] = (
        cos_beta_squared * cos_epsilon_squared * part_33_cos_epsilon2_sin_beta2
        + cos_beta_squared * part_33_sin_beta2_sin_epsilon2 * sin_epsilon_squared
        + cos_epsilon_squared * part_33_cos_beta2_cos_epsilon2 * sin_beta_squared
        + part_33_cos_beta2_sin_epsilon2 * sin_beta_squared * sin_epsilon_squared
    )
    result[..., 4, 5] = cos_beta * cos_epsilon * part_35_cos_epsilon_sin_beta_sin_epsilon * sin_epsilon
    result[..., 5, 0] = result[..., 0, 5]
    result[..., 5, 1] = result[..., 1, 5]
    result[..., 5, 2] = result[..., 2, 5]
    result[..., 5, 3] = result[..., 3, 5]
    result[..., 5, 4] = result[..., 4, 5]
    result[..., 5, 5] = (
        cos_epsilon_squared * part_55_cos_epsilon2
        + part_55_sin_epsilon2 * sin_epsilon_squared
    )
    return result


def two_plots_estimate(*, first: npt.ArrayLike, second: npt.ArrayLike, T: npt.ArrayLike) -> Floats:
    """Position and velocity along an axis at the second of two plots.

    Name: initiation.two_plots.estimate.
    Definition: (second, (second - first)/T).
    Conditioning: no expectation is taken.
    Source: Bar-Shalom, Li & Kirubarajan 2001 two-point differencing, doi:10.1002/0471221279.

    Args:
        first: a coordinate of the first plot [m], -1e+06 to 1e+06.
        second: a coordinate of the second plot [m], -1e+06 to 1e+06.
        T: time from the first plot to the second [s], 0.001 to 1000.

    Returns:
        Shape of the broadcast arguments + (2), unit [m, m/s].

    Accuracy: at most 2.01 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 2.01. Errors are measured against the
    sizes of the terms.
    """
    arguments = _floats(first, second, T)
    first, second, T = arguments
    result = _empty(arguments, (2,))
    result[..., 0] = second
    result[..., 1] = (second - first) / T
    return result


def two_plots_covariance(
    *,
    first_covariance: npt.ArrayLike,
    second_covariance: npt.ArrayLike,
    T: npt.ArrayLike,
) -> Floats:
    """Covariance of positions and velocities along two axes at the second of two plots.

    Name: initiation.two_plots.covariance.
    Definition: W diag(C1, C2) W'.
    Conditioning: measurement-conditioned: the measured symbols stand for the measurement.
    Source: Bar-Shalom, Li & Kirubarajan 2001 two-point differencing, doi:10.1002/0471221279.

    Args:
        first_covariance: covariance of two coordinates of the first plot [m^2], -1e+08 to 1e+08.
        second_covariance: covariance of two coordinates of the second plot [m^2], -1e+08 to 1e+08.
        T: time from the first plot to the second [s], 0.001 to 1000.

    Returns:
        Shape of the broadcast arguments + (2, 2), unit [m, m/s] × [m, m/s].

    Accuracy: at most 4.01 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 4.01. Errors are measured against the
    sizes of the terms.
    """
    arguments = _floats(first_covariance, second_covariance, T)
    first_covariance, second_covariance, T = arguments
    divisor_1 = T
    sum_1 = first_covariance + second_covariance
    result = _empty(arguments, (2, 2))
    result[..., 0, 0] = second_covariance
    result[..., 0, 1] = second_covariance / divisor_1
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = sum_1 / divisor_1**2
    return result
