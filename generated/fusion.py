"""NumPy functions of the quantities fusion.*.

Written by radartrack regenerate, generator 1, derivation 3d5fc6b0cea06a9b; not to be edited.
"""

import numpy as np
import numpy.typing as npt

__all__ = [
    "correlated_variance",
    "correlated_weights",
    "covariance_intersection_covariance",
    "cross_covariance_steady",
    "cross_covariance_updated",
    "cross_range_std",
    "matrix_weights_two",
    "variance_three",
    "variance_two",
    "weight",
    "weights_three",
    "weights_two",
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


def weights_two(*, sigma_1: npt.ArrayLike, sigma_2: npt.ArrayLike) -> Floats:
    """Weights of two unbiased measurements of one thing.

    Name: fusion.weights.two.
    Definition: argmin of the fused variance, weights summing to 1.
    Conditioning: truth-conditioned: the measured symbols stand for the true values.
    Source: Aitken 1936, doi:10.1017/S0370164600014346.

    Args:
        sigma_1: standard deviation of measurement 1 [m], 0.01 to 1e+05.
        sigma_2: standard deviation of measurement 2 [m], 0.01 to 1e+05.

    Returns:
        Shape of the broadcast arguments + (2), unit 1.

    Accuracy: at most 7.01 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 7.01.
    """
    arguments = _floats(sigma_1, sigma_2)
    sigma_1, sigma_2 = arguments
    sigma_1_squared = sigma_1**2
    sigma_2_squared = sigma_2**2
    divisor_1 = sigma_1_squared + sigma_2_squared
    term_1 = 1.0 / divisor_1
    result = _empty(arguments, (2,))
    result[..., 0] = sigma_2_squared * term_1
    result[..., 1] = sigma_1_squared * term_1
    return result


def variance_two(*, sigma_1: npt.ArrayLike, sigma_2: npt.ArrayLike) -> Floats:
    """Variance of the best weighted mean of two measurements.

    Name: fusion.variance.two.
    Definition: sum of w^2 sigma^2.
    Conditioning: truth-conditioned: the measured symbols stand for the true values.
    Source: Aitken 1936, doi:10.1017/S0370164600014346.

    Args:
        sigma_1: standard deviation of measurement 1 [m], 0.01 to 1e+05.
        sigma_2: standard deviation of measurement 2 [m], 0.01 to 1e+05.

    Returns:
        Shape of the broadcast arguments, unit m^2.

    Accuracy: at most 9.01 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 9.01.
    """
    arguments = _floats(sigma_1, sigma_2)
    sigma_1, sigma_2 = arguments
    sigma_1_squared = sigma_1**2
    sigma_2_squared = sigma_2**2
    result = _empty(arguments, ())
    result[...] = sigma_1_squared * sigma_2_squared / (sigma_1_squared + sigma_2_squared)
    return result[()]


def weights_three(*, sigma_1: npt.ArrayLike, sigma_2: npt.ArrayLike, sigma_3: npt.ArrayLike) -> Floats:
    """Weights of three unbiased measurements of one thing.

    Name: fusion.weights.three.
    Definition: argmin of the fused variance, weights summing to 1.
    Conditioning: truth-conditioned: the measured symbols stand for the true values.
    Source: Aitken 1936, doi:10.1017/S0370164600014346.

    Args:
        sigma_1: standard deviation of measurement 1 [m], 0.01 to 1e+05.
        sigma_2: standard deviation of measurement 2 [m], 0.01 to 1e+05.
        sigma_3: standard deviation of measurement 3 [m], 0.01 to 1e+05.

    Returns:
        Shape of the broadcast arguments + (3), unit 1.

    Accuracy: at most 14.1 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 14.1.
    """
    arguments = _floats(sigma_1, sigma_2, sigma_3)
    sigma_1, sigma_2, sigma_3 = arguments
    sigma_1_squared = sigma_1**2
    sigma_2_squared = sigma_2**2
    sigma_3_squared = sigma_3**2
    divisor_1 = (
        sigma_1_squared * sigma_2_squared
        + sigma_1_squared * sigma_3_squared
        + sigma_2_squared * sigma_3_squared
    )
    term_1 = 1.0 / divisor_1
    result = _empty(arguments, (3,))
    result[..., 0] = sigma_2_squared * sigma_3_squared * term_1
    result[..., 1] = sigma_1_squared * sigma_3_squared * term_1
    result[..., 2] = sigma_1_squared * sigma_2_squared * term_1
    return result


def variance_three(*, sigma_1: npt.ArrayLike, sigma_2: npt.ArrayLike, sigma_3: npt.ArrayLike) -> Floats:
    """Variance of the best weighted mean of three measurements.

    Name: fusion.variance.three.
    Definition: sum of w^2 sigma^2.
    Conditioning: truth-conditioned: the measured symbols stand for the true values.
    Source: Aitken 1936, doi:10.1017/S0370164600014346.

    Args:
        sigma_1: standard deviation of measurement 1 [m], 0.01 to 1e+05.
        sigma_2: standard deviation of measurement 2 [m], 0.01 to 1e+05.
        sigma_3: standard deviation of measurement 3 [m], 0.01 to 1e+05.

    Returns:
        Shape of the broadcast arguments, unit m^2.

    Accuracy: at most 16.1 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 16.1.
    """
    arguments = _floats(sigma_1, sigma_2, sigma_3)
    sigma_1, sigma_2, sigma_3 = arguments
    sigma_1_squared = sigma_1**2
    sigma_2_squared = sigma_2**2
    sigma_3_squared = sigma_3**2
    result = _empty(arguments, ())
    result[...] = sigma_1_squared * sigma_2_squared * sigma_3_squared / (sigma_1_squared * sigma_2_squared + sigma_1_squared * sigma_3_squared + sigma_2_squared * sigma_3_squared)
    return result[()]


def weight(*, sigma_1: npt.ArrayLike, information: npt.ArrayLike) -> Floats:
    """Weight of one measurement among any number.

    Name: fusion.weight.
    Definition: argmin of the fused variance, weights summing to 1.
    Conditioning: truth-conditioned: the measured symbols stand for the true values.
    Source: Aitken 1936, doi:10.1017/S0370164600014346.

    Args:
        sigma_1: standard deviation of measurement 1 [m], 0.01 to 1e+05.
        information: sum of 1/sigma^2 over all measurements [1/m^2], 1e-10 to 1e+06.

    Returns:
        Shape of the broadcast arguments, unit 1.

    Accuracy: at most 4.01 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 4.01.
    """
    arguments = _floats(sigma_1, information)
    sigma_1, information = arguments
    result = _empty(arguments, ())
    result[...] = 1.0 / (information * sigma_1**2)
    return result[()]


def matrix_weights_two(
    *,
    sigma_x1: npt.ArrayLike,
    sigma_y1: npt.ArrayLike,
    rho_1: npt.ArrayLike,
    sigma_x2: npt.ArrayLike,
    sigma_y2: npt.ArrayLike,
    rho_2: npt.ArrayLike,
) -> Floats:
    """Weight of the first of two measurements in the plane, [out, in].

    Name: fusion.matrix_weights.two.
    Definition: argmin of the trace of the fused covariance, weights summing to the unit matrix.
    Conditioning: truth-conditioned: the measured symbols stand for the true values.
    Source: Aitken 1936, doi:10.1017/S0370164600014346.

    Args:
        sigma_x1: standard deviation of x of measurement 1 [m], 0.01 to 1e+05.
        sigma_y1: standard deviation of y of measurement 1 [m], 0.01 to 1e+05.
        rho_1: correlation of the errors of x and y of measurement 1 [1], -0.999 to 0.999.
        sigma_x2: standard deviation of x of measurement 2 [m], 0.01 to 1e+05.
        sigma_y2: standard deviation of y of measurement 2 [m], 0.01 to 1e+05.
        rho_2: correlation of the errors of x and y of measurement 2 [1], -0.999 to 0.999.

    Returns:
        Shape of the broadcast arguments + (2, 2), unit 1.

    Accuracy: at most 15.1 ulp anywhere in this domain with independent errors, proved for elementary
    functions within 1 ulp (float64); in float32, with functions within 4 of its ulp, at most 15.1.
    """
    arguments = _floats(sigma_x1, sigma_y1, rho_1, sigma_x2, sigma_y2, rho_2)
    sigma_x1, sigma_y1, rho_1, sigma_x2, sigma_y2, rho_2 = arguments
    sigma_x1_squared = sigma_x1**2
    sigma_y1_squared = sigma_y1**2
    sigma_y2_squared = sigma_y2**2
    sigma_x2_squared = sigma_x2**2
    rho_2_squared = rho_2**2
    divisor_1 = (
        2.0 * rho_1 * rho_2 * sigma_x1 * sigma_x2 * sigma_y1 * sigma_y2
        - sigma_x1_squared * sigma_y1_squared
        - sigma_x1_squared * sigma_y2_squared
        - sigma_x2_squared * sigma_y1_squared
        - sigma_x2_squared * sigma_y2_squared
        + rho_2_squared * sigma_x2_squared * sigma_y2_squared
        + rho_1**2 * sigma_x1_squared * sigma_y1_squared
    )
    term_1 = 1.0 / divisor_1
    sum_1 = (
        rho_1 * rho_2 * sigma_x1 * sigma_y1 * sigma_y2
        - sigma_x2 * sigma_y1_squared
        - sigma_x2 * sigma_y2_squared
        + rho_2_squared * sigma_x2 * sigma_y2_squared
    )
    sum_2 = rho_1 * sigma_x2 * sigma_y1 - rho_2 * sigma_x1 * sigma_y2
    sum_3 = rho_1 * sigma_x1 * sigma_y2 - rho_2 * sigma_x2 * sigma_y1
    sum_4 = (
        rho_1 * rho_2 * sigma_x1 * sigma_x2 * sigma_y1
        - sigma_x1_squared * sigma_y2
        - sigma_x2_squared * sigma_y2
        + rho_2_squared * sigma_x2_squared * sigma_y2
    )
    result = _empty(arguments, (2, 2))
    result[..., 0, 0] = sigma_x2 * sum_1 * term_1
    result[..., 0, 1] = sigma_x1 * sigma_x2 * sum_2 * term_1
    result[..., 1, 0] = sigma_y1 * sigma_y2 * sum_3 * term_1
    result[..., 1, 1] = sigma_y2 * sum_4 * term_1
    return result


def cross_range_std(*, r: npt.ArrayLike, sigma_beta: npt.ArrayLike) -> Floats:
    """Error across the line of sight from an error of azimuth.

    Name: fusion.cross_range_std.
    Definition: r times the error of azimuth.
    Conditioning: truth-conditioned: the measured symbols stand for the true values.
    Source: Gao et al. 2020 introduction, doi:10.12126/see.2020.02.013.

    Args:
        r: range [m], 1 to 1e+08.
        sigma_beta: standard deviation of the error of beta [rad], 1e-09 to 1.

    Returns:
        Shape of the broadcast arguments, unit m.

    Accuracy: at most 1.01 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 1.01.
    """
    arguments = _floats(r, sigma_beta)
    r, sigma_beta = arguments
    result = _empty(arguments, ())
    result[...] = r * sigma_beta
    return result[()]


def cross_covariance_updated(
    *,
    cross_00: npt.ArrayLike,
    cross_01: npt.ArrayLike,
    cross_10: npt.ArrayLike,
    cross_11: npt.ArrayLike,
    alpha_1: npt.ArrayLike,
    beta_1: npt.ArrayLike,
    alpha_2: npt.ArrayLike,
    beta_2: npt.ArrayLike,
    sigma_w: npt.ArrayLike,
    T: npt.ArrayLike,
) -> Floats:
    """Cross covariance of the errors of two alpha-beta filters of one target after a scan, from that before.

    Name: fusion.cross_covariance.updated.
    Definition: (1 - K1 H) (F X F' + Q) (1 - K2 H)'.
    Conditioning: no expectation is taken.
    Source: Bar-Shalom & Campo 1986, doi:10.1109/TAES.1986.310815.

    Args:
        cross_00: cross covariance of position in filter 1 and position in filter 2 [m^2], -1e+06 to 1e+06.
        cross_01: cross covariance of position in filter 1 and velocity in filter 2 [m^2/s], -1e+06 to 1e+06.
        cross_10: cross covariance of velocity in filter 1 and position in filter 2 [m^2/s], -1e+06 to 1e+06.
        cross_11: cross covariance of velocity in filter 1 and velocity in filter 2 [m^2/s^2], -1e+06 to 1e+06.
        alpha_1: gain of the position in filter 1 [1], 0.001 to 1.
        beta_1: gain of the velocity in filter 1, times T [1], 1e-06 to 2.
        alpha_2: gain of the position in filter 2 [1], 0.001 to 1.
        beta_2: gain of the velocity in filter 2, times T [1], 1e-06 to 2.
        sigma_w: standard deviation of the acceleration, constant over a period [m/s^2], 1e-06 to 1000.
        T: time from scan to scan [s], 0.001 to 1000.

    Returns:
        Shape of the broadcast arguments + (2, 2), unit [m, m/s] × [m, m/s].

    Accuracy: at most 23.1 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 23.1. Errors are measured against the
    sizes of the terms.
    """
    arguments = _floats(cross_00, cross_01, cross_10, cross_11, alpha_1, beta_1, alpha_2, beta_2, sigma_w, T)
    cross_00, cross_01, cross_10, cross_11, alpha_1, beta_1, alpha_2, beta_2, sigma_w, T = arguments
    sum_1 = 1.0 - alpha_1
    sum_2 = 1.0 - alpha_2
    product_1 = T * cross_11
    T_squared = T**2
    sigma_w_squared = sigma_w**2
    sum_3 = T * (cross_10 + product_1) + T * cross_01 + 0.25 * T_squared**2 * sigma_w_squared + cross_00
    term_1 = 1.0 / T
    product_2 = 0.5 * T * T_squared * sigma_w_squared
    sum_4 = cross_01 - beta_2 * sum_3 * term_1 + product_1 + product_2
    sum_5 = cross_10 + product_1 + product_2
    result = _empty(arguments, (2, 2))
    result[..., 0, 0] = sum_1 * sum_2 * sum_3
    result[..., 0, 1] = sum_1 * sum_4
    result[..., 1, 0] = sum_2 * sum_5 - beta_1 * sum_2 * sum_3 * term_1
    result[..., 1, 1] = (
        T_squared * sigma_w_squared
        - beta_1 * sum_4 * term_1
        - beta_2 * sum_5 * term_1
        + cross_11
    )
    return result


def cross_covariance_steady(
    *,
    index_1: npt.ArrayLike,
    index_2: npt.ArrayLike,
    sigma_w: npt.ArrayLike,
    T: npt.ArrayLike,
) -> Floats:
    """Steady cross covariance of the errors of two alpha-beta filters of one target.

    Name: fusion.cross_covariance.steady.
    Definition: X = (1 - K1 H) (F X F' + Q) (1 - K2 H)'.
    Conditioning: no expectation is taken.
    Source: Bar-Shalom & Campo 1986, doi:10.1109/TAES.1986.310815.

    Args:
        index_1: tracking index T^2 sigma_w/sigma_r of filter 1 [1], 1e-09 to 1000.
        index_2: tracking index T^2 sigma_w/sigma_r of filter 2 [1], 1e-09 to 1000.
        sigma_w: standard deviation of the acceleration, constant over a period [m/s^2], 1e-06 to 1000.
        T: time from scan to scan [s], 0.001 to 1000.

    Returns:
        Shape of the broadcast arguments + (2, 2), unit [m, m/s] × [m, m/s].

    Accuracy: at most 53.1 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64). Errors are measured against itself.
    """
    arguments = _floats(index_1, index_2, sigma_w, T)
    index_1, index_2, sigma_w, T = arguments
    term_1 = 1.0 / index_1
    w_1 = np.sqrt(1.0 + 8.0 * term_1)
    excess_1 = 8.0 * term_1 / (1.0 + w_1)
    term_2 = 1.0 / index_2
    w_2 = np.sqrt(1.0 + 8.0 * term_2)
    excess_2 = 8.0 * term_2 / (1.0 + w_2)
    term_3 = 1.0 / (8.0 * term_1 + 8.0 * term_2)
    T_squared = T**2
    excess_1_squared = excess_1**2
    excess_2_squared = excess_2**2
    sigma_w_squared = sigma_w**2
    sum_1 = excess_1 + w_1**2 + w_1 * w_2 + w_2 + w_2**2
    result = _empty(arguments, (2, 2))
    result[..., 0, 0] = T_squared**2 * (excess_1 * w_2 + excess_2) * excess_1_squared * excess_2_squared * sigma_w_squared * term_3 / (16.0 * w_1 + 16.0 * w_2)
    result[..., 0, 1] = T * T_squared * excess_1_squared * excess_2_squared * sigma_w_squared * term_3 * (2.0 + w_1 + w_2) / (8.0 * w_1 + 8.0 * w_2)
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = T_squared * excess_1 * excess_2 * sigma_w_squared * sum_1 * term_3 / (2.0 * w_1 + 2.0 * w_2)
    return result


def correlated_weights(*, sigma_1: npt.ArrayLike, sigma_2: npt.ArrayLike, rho_12: npt.ArrayLike) -> Floats:
    """Weights of two unbiased measurements of one thing, or of two tracks, with correlated errors.

    Name: fusion.correlated.weights.
    Definition: argmin of the fused variance, weights summing to 1.
    Conditioning: truth-conditioned: the measured symbols stand for the true values.
    Source: Bar-Shalom & Campo 1986, doi:10.1109/TAES.1986.310815.

    Args:
        sigma_1: standard deviation of measurement 1 [m], 0.01 to 1e+05.
        sigma_2: standard deviation of measurement 2 [m], 0.01 to 1e+05.
        rho_12: correlation of both errors [1], -0.999 to 0.999.

    Returns:
        Shape of the broadcast arguments + (2), unit 1.

    Accuracy: at most 8.01 ulp anywhere in this domain with independent errors, proved for elementary
    functions within 1 ulp (float64); with correlations up to 0.99 in size at most 10.1; in float32, with
    functions within 4 of its ulp, at most 8.01. Errors are measured against the sizes of the terms.
    """
    arguments = _floats(sigma_1, sigma_2, rho_12)
    sigma_1, sigma_2, rho_12 = arguments
    term_1 = 1.0 / ((sigma_1 - sigma_2)**2 + 2.0 * (1.0 - rho_12) * sigma_1 * sigma_2)
    result = _empty(arguments, (2,))
    result[..., 0] = (sigma_2 - rho_12 * sigma_1) * sigma_2 * term_1
    result[..., 1] = (sigma_1 - rho_12 * sigma_2) * sigma_1 * term_1
    return result


def correlated_variance(*, sigma_1: npt.ArrayLike, sigma_2: npt.ArrayLike, rho_12: npt.ArrayLike) -> Floats:
    """Variance of the fused mean of two measurements or tracks with correlated errors.

    Name: fusion.correlated.variance.
    Definition: w1^2 sigma_1^2 + w2^2 sigma_2^2 + 2 w1 w2 rho sigma_1 sigma_2.
    Conditioning: truth-conditioned: the measured symbols stand for the true values.
    Source: Bar-Shalom & Campo 1986, doi:10.1109/TAES.1986.310815.

    Args:
        sigma_1: standard deviation of measurement 1 [m], 0.01 to 1e+05.
        sigma_2: standard deviation of measurement 2 [m], 0.01 to 1e+05.
        rho_12: correlation of both errors [1], -0.999 to 0.999.

    Returns:
        Shape of the broadcast arguments, unit m^2.

    Accuracy: at most 13.1 ulp anywhere in this domain with independent errors, proved for elementary
    functions within 1 ulp (float64); with correlations up to 0.99 in size at most 15.1; in float32, with
    functions within 4 of its ulp, at most 13.1.
    """
    arguments = _floats(sigma_1, sigma_2, rho_12)
    sigma_1, sigma_2, rho_12 = arguments
    sum_1 = 1.0 - rho_12
    result = _empty(arguments, ())
    result[...] = (1.0 + rho_12) * sigma_1**2 * sigma_2**2 * sum_1 / ((sigma_1 - sigma_2)**2 + 2.0 * sigma_1 * sigma_2 * sum_1)
    return result[()]


def covariance_intersection_covariance(
    *,
    sigma_x1: npt.ArrayLike,
    sigma_y1: npt.ArrayLike,
    rho_1: npt.ArrayLike,
    sigma_x2: npt.ArrayLike,
    sigma_y2: npt.ArrayLike,
    rho_2: npt.ArrayLike,
    weight: npt.ArrayLike,
) -> Floats:
    """Covariance in the plane by covariance intersection, whatever the correlation of both errors.

    Name: fusion.covariance_intersection.covariance.
    Definition: (w P1^-1 + (1 - w) P2^-1)^-1.
    Conditioning: no expectation is taken.
    Source: Julier & Uhlmann 1997, doi:10.1109/ACC.1997.609105.

    Args:
        sigma_x1: standard deviation of x of measurement 1 [m], 0.01 to 1e+05.
        sigma_y1: standard deviation of y of measurement 1 [m], 0.01 to 1e+05.
        rho_1: correlation of the errors of x and y of measurement 1 [1], -0.999 to 0.999.
        sigma_x2: standard deviation of x of measurement 2 [m], 0.01 to 1e+05.
        sigma_y2: standard deviation of y of measurement 2 [m], 0.01 to 1e+05.
        rho_2: correlation of the errors of x and y of measurement 2 [1], -0.999 to 0.999.
        weight: share of the first in the information, from 0 to 1 [1], 0.001 to 0.999.

    Returns:
        Shape of the broadcast arguments + (2, 2), unit m^2.

    Accuracy: at most 38.1 ulp anywhere in this domain with independent errors, proved for elementary
    functions within 1 ulp (float64).
    """
    arguments = _floats(sigma_x1, sigma_y1, rho_1, sigma_x2, sigma_y2, rho_2, weight)
    sigma_x1, sigma_y1, rho_1, sigma_x2, sigma_y2, rho_2, weight = arguments
    sum_1 = 1.0 - weight
    sum_2 = 1.0 - rho_1
    sum_3 = 1.0 + rho_1
    sigma_x1_squared = sigma_x1**2
    sigma_y1_squared = sigma_y1**2
    sum_4 = 1.0 - rho_2
    sum_5 = 1.0 + rho_2
    sigma_x2_squared = sigma_x2**2
    sigma_y2_squared = sigma_y2**2
    sum_6 = 0.5 * sum_2 * sum_5 + 0.5 * sum_3 * sum_4
    sum_7 = (
        (sigma_x1 * sigma_y2 - sigma_x2 * sigma_y1)**2
        + 2.0 * sigma_x1 * sigma_x2 * sigma_y1 * sigma_y2 * sum_6
    )
    term_1 = 1.0 / (sigma_x1_squared * sigma_y1_squared * sum_1**2 * sum_2 * sum_3 + sigma_x2_squared * sigma_y2_squared * sum_4 * sum_5 * weight**2 + sum_1 * sum_7 * weight)
    sum_8 = (
        sigma_x1_squared * sigma_x2_squared * sigma_y1_squared * sum_1 * sum_2 * sum_3
        + sigma_x1_squared * sigma_x2_squared * sigma_y2_squared * sum_4 * sum_5 * weight
    )
    sum_9 = (
        rho_2 * sigma_x1_squared * sigma_x2 * sigma_y1_squared * sigma_y2 * sum_1 * sum_2 * sum_3
        + rho_1 * sigma_x1 * sigma_x2_squared * sigma_y1 * sigma_y2_squared * sum_4 * sum_5 * weight
    )
    sum_10 = (
        sigma_x1_squared * sigma_y1_squared * sigma_y2_squared * sum_1 * sum_2 * sum_3
        + sigma_x2_squared * sigma_y1_squared * sigma_y2_squared * sum_4 * sum_5 * weight
    )
    result = _empty(arguments, (2, 2))
    result[..., 0, 0] = sum_8 * term_1
    result[..., 0, 1] = sum_9 * term_1
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = sum_10 * term_1
    return result
