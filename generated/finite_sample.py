"""NumPy functions of the quantities finite_sample.*.

Written by radartrack regenerate, generator 1, derivation 563693996ade7f60; not to be edited.
"""

import numpy as np
import numpy.typing as npt

__all__ = [
    "C",
    "degree0_gain",
    "degree0_range_at_lag_covariance",
    "degree0_range_at_lag_range_weights",
    "degree0_range_correlation",
    "degree0_range_covariance",
    "degree0_range_design",
    "degree0_range_gain_of_perfect_rate",
    "degree0_range_information",
    "degree0_range_precision",
    "degree0_range_range_weights",
    "degree0_range_rate_at_lag_covariance",
    "degree0_range_rate_at_lag_range_weights",
    "degree0_range_rate_at_lag_rate_weights",
    "degree0_range_rate_correlation",
    "degree0_range_rate_covariance",
    "degree0_range_rate_design",
    "degree0_range_rate_information",
    "degree0_range_rate_precision",
    "degree0_range_rate_range_weights",
    "degree0_range_rate_rate_weights",
    "degree1_gain",
    "degree1_range_at_lag_covariance",
    "degree1_range_at_lag_range_weights",
    "degree1_range_correlation",
    "degree1_range_covariance",
    "degree1_range_design",
    "degree1_range_gain_of_perfect_rate",
    "degree1_range_information",
    "degree1_range_precision",
    "degree1_range_range_weights",
    "degree1_range_rate_at_lag_covariance",
    "degree1_range_rate_at_lag_range_weights",
    "degree1_range_rate_at_lag_rate_weights",
    "degree1_range_rate_correlation",
    "degree1_range_rate_covariance",
    "degree1_range_rate_design",
    "degree1_range_rate_information",
    "degree1_range_rate_precision",
    "degree1_range_rate_range_weights",
    "degree1_range_rate_rate_weights",
    "degree2_gain",
    "degree2_range_at_lag_covariance",
    "degree2_range_at_lag_range_weights",
    "degree2_range_correlation",
    "degree2_range_covariance",
    "degree2_range_design",
    "degree2_range_gain_of_perfect_rate",
    "degree2_range_information",
    "degree2_range_precision",
    "degree2_range_range_weights",
    "degree2_range_rate_at_lag_covariance",
    "degree2_range_rate_at_lag_range_weights",
    "degree2_range_rate_at_lag_rate_weights",
    "degree2_range_rate_correlation",
    "degree2_range_rate_covariance",
    "degree2_range_rate_design",
    "degree2_range_rate_information",
    "degree2_range_rate_precision",
    "degree2_range_rate_range_weights",
    "degree2_range_rate_rate_weights",
    "degree3_gain",
    "degree3_range_at_lag_covariance",
    "degree3_range_at_lag_range_weights",
    "degree3_range_correlation",
    "degree3_range_covariance",
    "degree3_range_design",
    "degree3_range_gain_of_perfect_rate",
    "degree3_range_information",
    "degree3_range_precision",
    "degree3_range_range_weights",
    "degree3_range_rate_at_lag_covariance",
    "degree3_range_rate_at_lag_range_weights",
    "degree3_range_rate_at_lag_rate_weights",
    "degree3_range_rate_correlation",
    "degree3_range_rate_covariance",
    "degree3_range_rate_design",
    "degree3_range_rate_information",
    "degree3_range_rate_precision",
    "degree3_range_rate_range_weights",
    "degree3_range_rate_rate_weights",
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


def C(*, sigma_r: npt.ArrayLike, sigma_v: npt.ArrayLike, T: npt.ArrayLike) -> Floats:
    """Weight of the range rate beside the range.

    Name: finite_sample.C.
    Definition: C = sigma_r^2/(T^2 sigma_v^2).
    Conditioning: no expectation is taken.
    Source: Gorshkov & Zavizhenets (6).

    Args:
        sigma_r: standard deviation of the error of the range [m], 0.001 to 10000.
        sigma_v: standard deviation of the error of the range rate [m/s], 0.0001 to 10000.
        T: time from scan to scan [s], 0.001 to 1000.

    Returns:
        Shape of the broadcast arguments, unit 1.

    Accuracy: at most 8.01 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 8.01.
    """
    arguments = _floats(sigma_r, sigma_v, T)
    sigma_r, sigma_v, T = arguments
    divisor_1 = T
    divisor_2 = sigma_v
    result = _empty(arguments, ())
    result[...] = sigma_r**2 / (divisor_1**2 * divisor_2**2)
    return result[()]


def degree0_range_design(*, k: npt.ArrayLike, j: npt.ArrayLike, T: npt.ArrayLike) -> Floats:
    """Observations of scan j by range from k scans of range.

    Name: finite_sample.degree0.range.design.
    Definition: H_j.
    Conditioning: no expectation is taken.
    Source: Gorshkov & Zavizhenets (3)-(4).

    Args:
        k: number of scans [1], 1 to 1e+06.
        j: number of the scan that is weighted, 1 the oldest, k the newest [1], 1 to 1e+06.
        T: time from scan to scan [s], 0.001 to 1000.

    Returns:
        Shape of the broadcast arguments + (1, 1), unit 1.

    Accuracy: at most 0 ulp anywhere in this domain, proved for elementary functions within 1 ulp (float64);
    in float32, with functions within 4 of its ulp, at most 0.
    """
    arguments = _floats(k, j, T)
    k, j, T = arguments
    result = _empty(arguments, (1, 1))
    result[..., 0, 0] = 1.0
    return result


def degree0_range_precision(*, sigma_r: npt.ArrayLike) -> Floats:
    """Inverse variances of the observations of one scan, for range from k scans of range.

    Name: finite_sample.degree0.range.precision.
    Definition: Q_theta.
    Conditioning: no expectation is taken.
    Source: Gorshkov & Zavizhenets (5).

    Args:
        sigma_r: standard deviation of the error of the range [m], 0.001 to 10000.

    Returns:
        Shape of the broadcast arguments + (1, 1), unit 1/m^2.

    Accuracy: at most 3.01 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 3.01.
    """
    arguments = _floats(sigma_r)
    sigma_r, = arguments
    result = _empty(arguments, (1, 1))
    result[..., 0, 0] = 1.0 / sigma_r**2
    return result


def degree0_range_information(*, k: npt.ArrayLike, T: npt.ArrayLike, sigma_r: npt.ArrayLike) -> Floats:
    """Information matrix of range from k scans of range.

    Name: finite_sample.degree0.range.information.
    Definition: Q = sum_j H_j' Q_theta H_j.
    Conditioning: no expectation is taken.
    Source: Gorshkov & Zavizhenets (2), (6).

    Args:
        k: number of scans [1], 1 to 1e+06.
        T: time from scan to scan [s], 0.001 to 1000.
        sigma_r: standard deviation of the error of the range [m], 0.001 to 10000.

    Returns:
        Shape of the broadcast arguments + (1, 1), unit 1/m^2.

    Accuracy: at most 3.01 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 3.01.
    """
    arguments = _floats(k, T, sigma_r)
    k, T, sigma_r = arguments
    result = _empty(arguments, (1, 1))
    result[..., 0, 0] = k / sigma_r**2
    return result


def degree0_range_covariance(*, k: npt.ArrayLike, T: npt.ArrayLike, sigma_r: npt.ArrayLike) -> Floats:
    """Error covariance of range from k scans of range, at the newest scan.

    Name: finite_sample.degree0.range.covariance.
    Definition: R = (sum_j H_j' Q_theta H_j)^-1.
    Conditioning: no expectation is taken.
    Source: Gorshkov & Zavizhenets (2), (7)-(12).

    Args:
        k: number of scans [1], 1 to 1e+06.
        T: time from scan to scan [s], 0.001 to 1000.
        sigma_r: standard deviation of the error of the range [m], 0.001 to 10000.

    Returns:
        Shape of the broadcast arguments + (1, 1), unit m^2.

    Accuracy: at most 4.01 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 4.01.
    """
    arguments = _floats(k, T, sigma_r)
    k, T, sigma_r = arguments
    per_constant = 1.0 / k
    result = _empty(arguments, (1, 1))
    result[..., 0, 0] = per_constant * sigma_r**2
    return result


def degree0_range_correlation(*, k: npt.ArrayLike) -> Floats:
    """Correlation of the errors of range from k scans of range, at the newest scan.

    Name: finite_sample.degree0.range.correlation.
    Definition: R_mn / sqrt(R_mm R_nn).
    Conditioning: no expectation is taken.
    Source: Gorshkov & Zavizhenets (10)-(12).

    Args:
        k: number of scans [1], 1 to 1e+06.

    Returns:
        Shape of the broadcast arguments + (1, 1), unit 1.

    Accuracy: at most 0 ulp anywhere in this domain, proved for elementary functions within 1 ulp (float64);
    in float32, with functions within 4 of its ulp, at most 0.
    """
    arguments = _floats(k)
    k, = arguments
    result = _empty(arguments, (1, 1))
    result[..., 0, 0] = 1.0
    return result


def degree0_range_range_weights(*, k: npt.ArrayLike, j: npt.ArrayLike, T: npt.ArrayLike) -> Floats:
    """Weights of the range of scan j in the estimate of range from k scans of range, at the newest scan.

    Name: finite_sample.degree0.range.range_weights.
    Definition: W_j = R H_j' Q_theta.
    Conditioning: no expectation is taken.
    Source: Gorshkov & Zavizhenets (13)-(20).

    Args:
        k: number of scans [1], 1 to 1e+06.
        j: number of the scan that is weighted, 1 the oldest, k the newest [1], 1 to 1e+06.
        T: time from scan to scan [s], 0.001 to 1000.

    Returns:
        Shape of the broadcast arguments + (1), unit 1.

    Accuracy: at most 0.708 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 0.708. Errors are measured against the
    weights of this, the first and the last scan and the root mean square of all.
    """
    arguments = _floats(k, j, T)
    k, j, T = arguments
    per_constant = 1.0 / k
    result = _empty(arguments, (1,))
    result[..., 0] = per_constant
    return result


def degree0_range_at_lag_covariance(
    *,
    k: npt.ArrayLike,
    T: npt.ArrayLike,
    sigma_r: npt.ArrayLike,
    tau: npt.ArrayLike,
) -> Floats:
    """Error covariance of range from k scans of range, tau scans after the newest one.

    Name: finite_sample.degree0.range.at_lag.covariance.
    Definition: R = (sum_j H_j' Q_theta H_j)^-1.
    Conditioning: no expectation is taken.
    Source: Gorshkov & Zavizhenets (2), (7)-(12).

    Args:
        k: number of scans [1], 1 to 1e+06.
        T: time from scan to scan [s], 0.001 to 1000.
        sigma_r: standard deviation of the error of the range [m], 0.001 to 10000.
        tau: scans from the newest one to the time of the estimate, less than 0 to smooth [1], -1e+06 to 1e+06.

    Returns:
        Shape of the broadcast arguments + (1, 1), unit m^2.

    Accuracy: at most 4.01 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 4.01.
    """
    arguments = _floats(k, T, sigma_r, tau)
    k, T, sigma_r, tau = arguments
    per_constant = 1.0 / k
    result = _empty(arguments, (1, 1))
    result[..., 0, 0] = per_constant * sigma_r**2
    return result


def degree0_range_at_lag_range_weights(
    *,
    k: npt.ArrayLike,
    j: npt.ArrayLike,
    T: npt.ArrayLike,
    tau: npt.ArrayLike,
) -> Floats:
    """Weights of the range of scan j in the estimate of range from k scans of range, tau scans after the newest one.

    Name: finite_sample.degree0.range.at_lag.range_weights.
    Definition: W_j = R H_j' Q_theta.
    Conditioning: no expectation is taken.
    Source: Gorshkov & Zavizhenets (13)-(20).

    Args:
        k: number of scans [1], 1 to 1e+06.
        j: number of the scan that is weighted, 1 the oldest, k the newest [1], 1 to 1e+06.
        T: time from scan to scan [s], 0.001 to 1000.
        tau: scans from the newest one to the time of the estimate, less than 0 to smooth [1], -1e+06 to 1e+06.

    Returns:
        Shape of the broadcast arguments + (1), unit 1.

    Accuracy: at most 0.708 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 0.708. Errors are measured against the
    weights of this, the first and the last scan and the root mean square of all.
    """
    arguments = _floats(k, j, T, tau)
    k, j, T, tau = arguments
    per_constant = 1.0 / k
    result = _empty(arguments, (1,))
    result[..., 0] = per_constant
    return result


def degree0_range_rate_design(*, k: npt.ArrayLike, j: npt.ArrayLike, T: npt.ArrayLike) -> Floats:
    """Observations of scan j by range from k scans of range and range rate.

    Name: finite_sample.degree0.range_rate.design.
    Definition: H_j.
    Conditioning: no expectation is taken.
    Source: Gorshkov & Zavizhenets (3)-(4).

    Args:
        k: number of scans [1], 1 to 1e+06.
        j: number of the scan that is weighted, 1 the oldest, k the newest [1], 1 to 1e+06.
        T: time from scan to scan [s], 0.001 to 1000.

    Returns:
        Shape of the broadcast arguments + (2, 1), unit [m, m/s] × [1/m].

    Accuracy: at most 0 ulp anywhere in this domain, proved for elementary functions within 1 ulp (float64);
    in float32, with functions within 4 of its ulp, at most 0.
    """
    arguments = _floats(k, j, T)
    k, j, T = arguments
    result = _empty(arguments, (2, 1))
    result[..., 0, 0] = 1.0
    result[..., 1, 0] = 0.0
    return result


def degree0_range_rate_precision(*, sigma_r: npt.ArrayLike, T: npt.ArrayLike, C: npt.ArrayLike) -> Floats:
    """Inverse variances of the observations of one scan, for range from k scans of range and range rate.

    Name: finite_sample.degree0.range_rate.precision.
    Definition: Q_theta.
    Conditioning: no expectation is taken.
    Source: Gorshkov & Zavizhenets (5).

    Args:
        sigma_r: standard deviation of the error of the range [m], 0.001 to 10000.
        T: time from scan to scan [s], 0.001 to 1000.
        C: sigma_r^2/(T^2 sigma_v^2), the weight of the range rate [1], 0 to 1e+12.

    Returns:
        Shape of the broadcast arguments + (2, 2), unit [1/m, s/m] × [1/m, s/m].

    Accuracy: at most 7.01 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 7.01.
    """
    arguments = _floats(sigma_r, T, C)
    sigma_r, T, C = arguments
    term_1 = 1.0 / sigma_r**2
    result = _empty(arguments, (2, 2))
    result[..., 0, 0] = term_1
    result[..., 0, 1] = 0.0
    result[..., 1, 0] = 0.0
    result[..., 1, 1] = C * T**2 * term_1
    return result


def degree0_range_rate_information(
    *,
    k: npt.ArrayLike,
    T: npt.ArrayLike,
    sigma_r: npt.ArrayLike,
    C: npt.ArrayLike,
) -> Floats:
    """Information matrix of range from k scans of range and range rate.

    Name: finite_sample.degree0.range_rate.information.
    Definition: Q = sum_j H_j' Q_theta H_j.
    Conditioning: no expectation is taken.
    Source: Gorshkov & Zavizhenets (2), (6).

    Args:
        k: number of scans [1], 1 to 1e+06.
        T: time from scan to scan [s], 0.001 to 1000.
        sigma_r: standard deviation of the error of the range [m], 0.001 to 10000.
        C: sigma_r^2/(T^2 sigma_v^2), the weight of the range rate [1], 0 to 1e+12.

    Returns:
        Shape of the broadcast arguments + (1, 1), unit 1/m^2.

    Accuracy: at most 3.01 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 3.01.
    """
    arguments = _floats(k, T, sigma_r, C)
    k, T, sigma_r, C = arguments
    result = _empty(arguments, (1, 1))
    result[..., 0, 0] = k / sigma_r**2
    return result


def degree0_range_rate_covariance(
    *,
    k: npt.ArrayLike,
    T: npt.ArrayLike,
    sigma_r: npt.ArrayLike,
    C: npt.ArrayLike,
) -> Floats:
    """Error covariance of range from k scans of range and range rate, at the newest scan.

    Name: finite_sample.degree0.range_rate.covariance.
    Definition: R = (sum_j H_j' Q_theta H_j)^-1.
    Conditioning: no expectation is taken.
    Source: Gorshkov & Zavizhenets (2), (7)-(12).

    Args:
        k: number of scans [1], 1 to 1e+06.
        T: time from scan to scan [s], 0.001 to 1000.
        sigma_r: standard deviation of the error of the range [m], 0.001 to 10000.
        C: sigma_r^2/(T^2 sigma_v^2), the weight of the range rate [1], 0 to 1e+12.

    Returns:
        Shape of the broadcast arguments + (1, 1), unit m^2.

    Accuracy: at most 4.01 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 4.01.
    """
    arguments = _floats(k, T, sigma_r, C)
    k, T, sigma_r, C = arguments
    per_constant = 1.0 / k
    result = _empty(arguments, (1, 1))
    result[..., 0, 0] = per_constant * sigma_r**2
    return result


def degree0_range_rate_correlation(*, k: npt.ArrayLike, C: npt.ArrayLike) -> Floats:
    """Correlation of the errors of range from k scans of range and range rate, at the newest scan.

    Name: finite_sample.degree0.range_rate.correlation.
    Definition: R_mn / sqrt(R_mm R_nn).
    Conditioning: no expectation is taken.
    Source: Gorshkov & Zavizhenets (10)-(12).

    Args:
        k: number of scans [1], 1 to 1e+06.
        C: sigma_r^2/(T^2 sigma_v^2), the weight of the range rate [1], 0 to 1e+12.

    Returns:
        Shape of the broadcast arguments + (1, 1), unit 1.

    Accuracy: at most 0 ulp anywhere in this domain, proved for elementary functions within 1 ulp (float64);
    in float32, with functions within 4 of its ulp, at most 0.
    """
    arguments = _floats(k, C)
    k, C = arguments
    result = _empty(arguments, (1, 1))
    result[..., 0, 0] = 1.0
    return result


def degree0_range_rate_range_weights(
    *,
    k: npt.ArrayLike,
    j: npt.ArrayLike,
    T: npt.ArrayLike,
    C: npt.ArrayLike,
) -> Floats:
    """Weights of the range of scan j in the estimate of range from k scans of range and range rate, at the newest scan.

    Name: finite_sample.degree0.range_rate.range_weights.
    Definition: W_j = R H_j' Q_theta.
    Conditioning: no expectation is taken.
    Source: Gorshkov & Zavizhenets (13)-(20).

    Args:
        k: number of scans [1], 1 to 1e+06.
        j: number of the scan that is weighted, 1 the oldest, k the newest [1], 1 to 1e+06.
        T: time from scan to scan [s], 0.001 to 1000.
        C: sigma_r^2/(T^2 sigma_v^2), the weight of the range rate [1], 0 to 1e+12.

    Returns:
        Shape of the broadcast arguments + (1), unit 1.

    Accuracy: at most 0.708 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 0.708. Errors are measured against the
    weights of this, the first and the last scan and the root mean square of all.
    """
    arguments = _floats(k, j, T, C)
    k, j, T, C = arguments
    per_constant = 1.0 / k
    result = _empty(arguments, (1,))
    result[..., 0] = per_constant
    return result


def degree0_range_rate_rate_weights(
    *,
    k: npt.ArrayLike,
    j: npt.ArrayLike,
    T: npt.ArrayLike,
    C: npt.ArrayLike,
) -> Floats:
    """Weights of the rate of scan j in the estimate of range from k scans of range and range rate, at the newest scan.

    Name: finite_sample.degree0.range_rate.rate_weights.
    Definition: W_j = R H_j' Q_theta.
    Conditioning: no expectation is taken.
    Source: Gorshkov & Zavizhenets (13)-(20).

    Args:
        k: number of scans [1], 1 to 1e+06.
        j: number of the scan that is weighted, 1 the oldest, k the newest [1], 1 to 1e+06.
        T: time from scan to scan [s], 0.001 to 1000.
        C: sigma_r^2/(T^2 sigma_v^2), the weight of the range rate [1], 0 to 1e+12.

    Returns:
        Shape of the broadcast arguments + (1), unit s.

    Accuracy: at most 0 ulp anywhere in this domain, proved for elementary functions within 1 ulp (float64);
    in float32, with functions within 4 of its ulp, at most 0. Errors are measured against the weights of
    this, the first and the last scan and the root mean square of all.
    """
    arguments = _floats(k, j, T, C)
    k, j, T, C = arguments
    result = _empty(arguments, (1,))
    result[..., 0] = 0.0
    return result


def degree0_range_rate_at_lag_covariance(
    *,
    k: npt.ArrayLike,
    T: npt.ArrayLike,
    sigma_r: npt.ArrayLike,
    C: npt.ArrayLike,
    tau: npt.ArrayLike,
) -> Floats:
    """Error covariance of range from k scans of range and range rate, tau scans after the newest one.

    Name: finite_sample.degree0.range_rate.at_lag.covariance.
    Definition: R = (sum_j H_j' Q_theta H_j)^-1.
    Conditioning: no expectation is taken.
    Source: Gorshkov & Zavizhenets (2), (7)-(12).

    Args:
        k: number of scans [1], 1 to 1e+06.
        T: time from scan to scan [s], 0.001 to 1000.
        sigma_r: standard deviation of the error of the range [m], 0.001 to 10000.
        C: sigma_r^2/(T^2 sigma_v^2), the weight of the range rate [1], 0 to 1e+12.
        tau: scans from the newest one to the time of the estimate, less than 0 to smooth [1], -1e+06 to 1e+06.

    Returns:
        Shape of the broadcast arguments + (1, 1), unit m^2.

    Accuracy: at most 4.01 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 4.01.
    """
    arguments = _floats(k, T, sigma_r, C, tau)
    k, T, sigma_r, C, tau = arguments
    per_constant = 1.0 / k
    result = _empty(arguments, (1, 1))
    result[..., 0, 0] = per_constant * sigma_r**2
    return result


def degree0_range_rate_at_lag_range_weights(
    *,
    k: npt.ArrayLike,
    j: npt.ArrayLike,
    T: npt.ArrayLike,
    C: npt.ArrayLike,
    tau: npt.ArrayLike,
) -> Floats:
    """Weights of the range of scan j in the estimate of range from k scans of range and range rate, tau scans after the newest one.

    Name: finite_sample.degree0.range_rate.at_lag.range_weights.
    Definition: W_j = R H_j' Q_theta.
    Conditioning: no expectation is taken.
    Source: Gorshkov & Zavizhenets (13)-(20).

    Args:
        k: number of scans [1], 1 to 1e+06.
        j: number of the scan that is weighted, 1 the oldest, k the newest [1], 1 to 1e+06.
        T: time from scan to scan [s], 0.001 to 1000.
        C: sigma_r^2/(T^2 sigma_v^2), the weight of the range rate [1], 0 to 1e+12.
        tau: scans from the newest one to the time of the estimate, less than 0 to smooth [1], -1e+06 to 1e+06.

    Returns:
        Shape of the broadcast arguments + (1), unit 1.

    Accuracy: at most 0.708 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 0.708. Errors are measured against the
    weights of this, the first and the last scan and the root mean square of all.
    """
    arguments = _floats(k, j, T, C, tau)
    k, j, T, C, tau = arguments
    per_constant = 1.0 / k
    result = _empty(arguments, (1,))
    result[..., 0] = per_constant
    return result


def degree0_range_rate_at_lag_rate_weights(
    *,
    k: npt.ArrayLike,
    j: npt.ArrayLike,
    T: npt.ArrayLike,
    C: npt.ArrayLike,
    tau: npt.ArrayLike,
) -> Floats:
    """Weights of the rate of scan j in the estimate of range from k scans of range and range rate, tau scans after the newest one.

    Name: finite_sample.degree0.range_rate.at_lag.rate_weights.
    Definition: W_j = R H_j' Q_theta.
    Conditioning: no expectation is taken.
    Source: Gorshkov & Zavizhenets (13)-(20).

    Args:
        k: number of scans [1], 1 to 1e+06.
        j: number of the scan that is weighted, 1 the oldest, k the newest [1], 1 to 1e+06.
        T: time from scan to scan [s], 0.001 to 1000.
        C: sigma_r^2/(T^2 sigma_v^2), the weight of the range rate [1], 0 to 1e+12.
        tau: scans from the newest one to the time of the estimate, less than 0 to smooth [1], -1e+06 to 1e+06.

    Returns:
        Shape of the broadcast arguments + (1), unit s.

    Accuracy: at most 0 ulp anywhere in this domain, proved for elementary functions within 1 ulp (float64);
    in float32, with functions within 4 of its ulp, at most 0. Errors are measured against the weights of
    this, the first and the last scan and the root mean square of all.
    """
    arguments = _floats(k, j, T, C, tau)
    k, j, T, C, tau = arguments
    result = _empty(arguments, (1,))
    result[..., 0] = 0.0
    return result


def degree0_gain(*, k: npt.ArrayLike, C: npt.ArrayLike) -> Floats:
    """Part of the standard deviations of range that the range rate removes, at the newest scan.

    Name: finite_sample.degree0.gain.
    Definition: K_x = 1 - sqrt(R_xx with range rate / R_xx without).
    Conditioning: no expectation is taken.
    Source: Gorshkov & Zavizhenets (22).

    Args:
        k: number of scans [1], 1 to 1e+06.
        C: sigma_r^2/(T^2 sigma_v^2), the weight of the range rate [1], 0 to 1e+12.

    Returns:
        Shape of the broadcast arguments + (1), unit 1.

    Accuracy: at most 0 ulp anywhere in this domain, proved for elementary functions within 1 ulp (float64);
    in float32, with functions within 4 of its ulp, at most 0. Errors are measured against itself.
    """
    arguments = _floats(k, C)
    k, C = arguments
    result = _empty(arguments, (1,))
    result[..., 0] = 0.0
    return result


def degree0_range_gain_of_perfect_rate(*, k: npt.ArrayLike) -> Floats:
    """Part of the standard deviation of the range, of range, that errorless range rates would remove.

    Name: finite_sample.degree0.range_gain_of_perfect_rate.
    Definition: limit of K_r for C to infinity.
    Conditioning: no expectation is taken.
    Source: Gorshkov & Zavizhenets (22).

    Args:
        k: number of scans [1], 1 to 1e+06.

    Returns:
        Shape of the broadcast arguments, unit 1.

    Accuracy: at most 0 ulp anywhere in this domain, proved for elementary functions within 1 ulp (float64);
    in float32, with functions within 4 of its ulp, at most 0.
    """
    arguments = _floats(k)
    k, = arguments
    result = _empty(arguments, ())
    result[...] = 0.0
    return result[()]


def degree1_range_design(*, k: npt.ArrayLike, j: npt.ArrayLike, T: npt.ArrayLike) -> Floats:
    """Observations of scan j by range and range rate from k scans of range.

    Name: finite_sample.degree1.range.design.
    Definition: H_j.
    Conditioning: no expectation is taken.
    Source: Gorshkov & Zavizhenets (3)-(4).

    Args:
        k: number of scans [1], 1 to 1e+06.
        j: number of the scan that is weighted, 1 the oldest, k the newest [1], 1 to 1e+06.
        T: time from scan to scan [s], 0.001 to 1000.

    Returns:
        Shape of the broadcast arguments + (1, 2), unit [m] × [1/m, s/m].

    Accuracy: at most 1.01 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 1.01.
    """
    arguments = _floats(k, j, T)
    k, j, T = arguments
    result = _empty(arguments, (1, 2))
    result[..., 0, 0] = 1.0
    result[..., 0, 1] = T * (j - k)
    return result


def degree1_range_precision(*, sigma_r: npt.ArrayLike) -> Floats:
    """Inverse variances of the observations of one scan, for range and range rate from k scans of range.

    Name: finite_sample.degree1.range.precision.
    Definition: Q_theta.
    Conditioning: no expectation is taken.
    Source: Gorshkov & Zavizhenets (5).

    Args:
        sigma_r: standard deviation of the error of the range [m], 0.001 to 10000.

    Returns:
        Shape of the broadcast arguments + (1, 1), unit 1/m^2.

    Accuracy: at most 3.01 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 3.01.
    """
    arguments = _floats(sigma_r)
    sigma_r, = arguments
    result = _empty(arguments, (1, 1))
    result[..., 0, 0] = 1.0 / sigma_r**2
    return result


def degree1_range_information(*, k: npt.ArrayLike, T: npt.ArrayLike, sigma_r: npt.ArrayLike) -> Floats:
    """Information matrix of range and range rate from k scans of range.

    Name: finite_sample.degree1.range.information.
    Definition: Q = sum_j H_j' Q_theta H_j.
    Conditioning: no expectation is taken.
    Source: Gorshkov & Zavizhenets (2), (6).

    Args:
        k: number of scans [1], 1 to 1e+06.
        T: time from scan to scan [s], 0.001 to 1000.
        sigma_r: standard deviation of the error of the range [m], 0.001 to 10000.

    Returns:
        Shape of the broadcast arguments + (2, 2), unit [1/m, s/m] × [1/m, s/m].

    Accuracy: at most 10.1 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 10.1.
    """
    arguments = _floats(k, T, sigma_r)
    k, T, sigma_r = arguments
    term_1 = 1.0 / sigma_r**2
    sum_1 = k - 1.0
    result = _empty(arguments, (2, 2))
    result[..., 0, 0] = k * term_1
    result[..., 0, 1] = -0.5 * T * k * sum_1 * term_1
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = (2.0 * k - 1.0) * T**2 * k * sum_1 * term_1 / 6.0
    return result


def degree1_range_covariance(*, k: npt.ArrayLike, T: npt.ArrayLike, sigma_r: npt.ArrayLike) -> Floats:
    """Error covariance of range and range rate from k scans of range, at the newest scan.

    Name: finite_sample.degree1.range.covariance.
    Definition: R = (sum_j H_j' Q_theta H_j)^-1.
    Conditioning: no expectation is taken.
    Source: Gorshkov & Zavizhenets (2), (7)-(12).

    Args:
        k: number of scans [1], 2 to 1e+06.
        T: time from scan to scan [s], 0.001 to 1000.
        sigma_r: standard deviation of the error of the range [m], 0.001 to 10000.

    Returns:
        Shape of the broadcast arguments + (2, 2), unit [m, m/s] × [m, m/s].

    Accuracy: at most 9.01 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 11.1.
    """
    arguments = _floats(k, T, sigma_r)
    k, T, sigma_r = arguments
    span = (1.0 + k) * (k - 1.0)
    middle = 0.5 * k - 0.5
    per_constant = 1.0 / k
    term_1 = per_constant
    per_slope = 12.0 * term_1 / span
    sigma_r_squared = sigma_r**2
    sum_1 = middle**2 * per_slope + per_constant
    result = _empty(arguments, (2, 2))
    result[..., 0, 0] = sigma_r_squared * sum_1
    result[..., 0, 1] = middle * per_slope * sigma_r_squared / T
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = per_slope * sigma_r_squared / T**2
    return result


def degree1_range_correlation(*, k: npt.ArrayLike) -> Floats:
    """Correlation of the errors of range and range rate from k scans of range, at the newest scan.

    Name: finite_sample.degree1.range.correlation.
    Definition: R_mn / sqrt(R_mm R_nn).
    Conditioning: no expectation is taken.
    Source: Gorshkov & Zavizhenets (10)-(12).

    Args:
        k: number of scans [1], 2 to 1e+06.

    Returns:
        Shape of the broadcast arguments + (2, 2), unit 1.

    Accuracy: at most 2.48 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 2.48.
    """
    arguments = _floats(k)
    k, = arguments
    k_beyond_2 = k - 2.0
    result = _empty(arguments, (2, 2))
    result[..., 0, 0] = 1.0
    result[..., 0, 1] = np.sqrt(3.0) / np.sqrt((6.0 + 4.0 * k_beyond_2) / (1.0 + k_beyond_2))
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = 1.0
    return result


def degree1_range_range_weights(*, k: npt.ArrayLike, j: npt.ArrayLike, T: npt.ArrayLike) -> Floats:
    """Weights of the range of scan j in the estimate of range and range rate from k scans of range, at the newest scan.

    Name: finite_sample.degree1.range.range_weights.
    Definition: W_j = R H_j' Q_theta.
    Conditioning: no expectation is taken.
    Source: Gorshkov & Zavizhenets (13)-(20).

    Args:
        k: number of scans [1], 2 to 1e+06.
        j: number of the scan that is weighted, 1 the oldest, k the newest [1], 1 to 1e+06.
        T: time from scan to scan [s], 0.001 to 1000.

    Returns:
        Shape of the broadcast arguments + (2), unit [1, 1/s].

    Accuracy: at most 25.9 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 30.1. Errors are measured against the
    weights of this, the first and the last scan and the root mean square of all.
    """
    arguments = _floats(k, j, T)
    k, j, T = arguments
    span = (1.0 + k) * (k - 1.0)
    middle = 0.5 * k - 0.5
    scan_position = j - 0.5 - 0.5 * k
    per_constant = 1.0 / k
    term_1 = per_constant
    per_slope = 12.0 * term_1 / span
    result = _empty(arguments, (2,))
    result[..., 0] = middle * per_slope * scan_position + per_constant
    result[..., 1] = per_slope * scan_position / T
    return result


def degree1_range_at_lag_covariance(
    *,
    k: npt.ArrayLike,
    T: npt.ArrayLike,
    sigma_r: npt.ArrayLike,
    tau: npt.ArrayLike,
) -> Floats:
    """Error covariance of range and range rate from k scans of range, tau scans after the newest one.

    Name: finite_sample.degree1.range.at_lag.covariance.
    Definition: R = (sum_j H_j' Q_theta H_j)^-1.
    Conditioning: no expectation is taken.
    Source: Gorshkov & Zavizhenets (2), (7)-(12).

    Args:
        k: number of scans [1], 2 to 1e+06.
        T: time from scan to scan [s], 0.001 to 1000.
        sigma_r: standard deviation of the error of the range [m], 0.001 to 10000.
        tau: scans from the newest one to the time of the estimate, less than 0 to smooth [1], -1e+06 to 1e+06.

    Returns:
        Shape of the broadcast arguments + (2, 2), unit [m, m/s] × [m, m/s].

    Accuracy: at most 12.1 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 13.1.
    """
    arguments = _floats(k, T, sigma_r, tau)
    k, T, sigma_r, tau = arguments
    span = (1.0 + k) * (k - 1.0)
    middle = 0.5 * k - 0.5
    position = middle + tau
    per_constant = 1.0 / k
    term_1 = per_constant
    per_slope = 12.0 * term_1 / span
    sigma_r_squared = sigma_r**2
    sum_1 = per_constant + per_slope * position**2
    result = _empty(arguments, (2, 2))
    result[..., 0, 0] = sigma_r_squared * sum_1
    result[..., 0, 1] = per_slope * position * sigma_r_squared / T
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = per_slope * sigma_r_squared / T**2
    return result


def degree1_range_at_lag_range_weights(
    *,
    k: npt.ArrayLike,
    j: npt.ArrayLike,
    T: npt.ArrayLike,
    tau: npt.ArrayLike,
) -> Floats:
    """Weights of the range of scan j in the estimate of range and range rate from k scans of range, tau scans after the newest one.

    Name: finite_sample.degree1.range.at_lag.range_weights.
    Definition: W_j = R H_j' Q_theta.
    Conditioning: no expectation is taken.
    Source: Gorshkov & Zavizhenets (13)-(20).

    Args:
        k: number of scans [1], 2 to 1e+06.
        j: number of the scan that is weighted, 1 the oldest, k the newest [1], 1 to 1e+06.
        T: time from scan to scan [s], 0.001 to 1000.
        tau: scans from the newest one to the time of the estimate, less than 0 to smooth [1], -1e+06 to 1e+06.

    Returns:
        Shape of the broadcast arguments + (2), unit [1, 1/s].

    Accuracy: at most 34 ulp anywhere in this domain, proved for elementary functions within 1 ulp (float64);
    in float32, with functions within 4 of its ulp, at most 40.5. Errors are measured against the weights of
    this, the first and the last scan and the root mean square of all.
    """
    arguments = _floats(k, j, T, tau)
    k, j, T, tau = arguments
    span = (1.0 + k) * (k - 1.0)
    middle = 0.5 * k - 0.5
    position = middle + tau
    scan_position = j - 0.5 - 0.5 * k
    per_constant = 1.0 / k
    term_1 = per_constant
    per_slope = 12.0 * term_1 / span
    result = _empty(arguments, (2,))
    result[..., 0] = per_constant + per_slope * position * scan_position
    result[..., 1] = per_slope * scan_position / T
    return result


def degree1_range_rate_design(*, k: npt.ArrayLike, j: npt.ArrayLike, T: npt.ArrayLike) -> Floats:
    """Observations of scan j by range and range rate from k scans of range and range rate (where C > 0, k from 1 on).

    Name: finite_sample.degree1.range_rate.design.
    Definition: H_j.
    Conditioning: no expectation is taken.
    Source: Gorshkov & Zavizhenets (3)-(4).

    Args:
        k: number of scans [1], 1 to 1e+06.
        j: number of the scan that is weighted, 1 the oldest, k the newest [1], 1 to 1e+06.
        T: time from scan to scan [s], 0.001 to 1000.

    Returns:
        Shape of the broadcast arguments + (2, 2), unit [m, m/s] × [1/m, s/m].

    Accuracy: at most 1.01 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 1.01.
    """
    arguments = _floats(k, j, T)
    k, j, T = arguments
    result = _empty(arguments, (2, 2))
    result[..., 0, 0] = 1.0
    result[..., 0, 1] = T * (j - k)
    result[..., 1, 0] = 0.0
    result[..., 1, 1] = 1.0
    return result


def degree1_range_rate_precision(*, sigma_r: npt.ArrayLike, T: npt.ArrayLike, C: npt.ArrayLike) -> Floats:
    """Inverse variances of the observations of one scan, for range and range rate from k scans of range and range rate (where C > 0, k from 1 on).

    Name: finite_sample.degree1.range_rate.precision.
    Definition: Q_theta.
    Conditioning: no expectation is taken.
    Source: Gorshkov & Zavizhenets (5).

    Args:
        sigma_r: standard deviation of the error of the range [m], 0.001 to 10000.
        T: time from scan to scan [s], 0.001 to 1000.
        C: sigma_r^2/(T^2 sigma_v^2), the weight of the range rate [1], 0 to 1e+12.

    Returns:
        Shape of the broadcast arguments + (2, 2), unit [1/m, s/m] × [1/m, s/m].

    Accuracy: at most 7.01 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 7.01.
    """
    arguments = _floats(sigma_r, T, C)
    sigma_r, T, C = arguments
    term_1 = 1.0 / sigma_r**2
    result = _empty(arguments, (2, 2))
    result[..., 0, 0] = term_1
    result[..., 0, 1] = 0.0
    result[..., 1, 0] = 0.0
    result[..., 1, 1] = C * T**2 * term_1
    return result


def degree1_range_rate_information(
    *,
    k: npt.ArrayLike,
    T: npt.ArrayLike,
    sigma_r: npt.ArrayLike,
    C: npt.ArrayLike,
) -> Floats:
    """Information matrix of range and range rate from k scans of range and range rate (where C > 0, k from 1 on).

    Name: finite_sample.degree1.range_rate.information.
    Definition: Q = sum_j H_j' Q_theta H_j.
    Conditioning: no expectation is taken.
    Source: Gorshkov & Zavizhenets (2), (6).

    Args:
        k: number of scans [1], 1 to 1e+06.
        T: time from scan to scan [s], 0.001 to 1000.
        sigma_r: standard deviation of the error of the range [m], 0.001 to 10000.
        C: sigma_r^2/(T^2 sigma_v^2), the weight of the range rate [1], 0 to 1e+12.

    Returns:
        Shape of the broadcast arguments + (2, 2), unit [1/m, s/m] × [1/m, s/m].

    Accuracy: at most 11.1 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 19.6.
    """
    arguments = _floats(k, T, sigma_r, C)
    k, T, sigma_r, C = arguments
    term_1 = 1.0 / sigma_r**2
    sum_1 = 1.0 - 3.0 * k + 2.0 * k**2 + 6.0 * C
    result = _empty(arguments, (2, 2))
    result[..., 0, 0] = k * term_1
    result[..., 0, 1] = -0.5 * T * k * (k - 1.0) * term_1
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = T**2 * k * sum_1 * term_1 / 6.0
    return result


def degree1_range_rate_covariance(
    *,
    k: npt.ArrayLike,
    T: npt.ArrayLike,
    sigma_r: npt.ArrayLike,
    C: npt.ArrayLike,
) -> Floats:
    """Error covariance of range and range rate from k scans of range and range rate (where C > 0, k from 1 on), at the newest scan.

    Name: finite_sample.degree1.range_rate.covariance.
    Definition: R = (sum_j H_j' Q_theta H_j)^-1.
    Conditioning: no expectation is taken.
    Source: Gorshkov & Zavizhenets (2), (7)-(12).

    Args:
        k: number of scans [1], 2 to 1e+06.
        T: time from scan to scan [s], 0.001 to 1000.
        sigma_r: standard deviation of the error of the range [m], 0.001 to 10000.
        C: sigma_r^2/(T^2 sigma_v^2), the weight of the range rate [1], 0 to 1e+12.

    Returns:
        Shape of the broadcast arguments + (2, 2), unit [m, m/s] × [m, m/s].

    Accuracy: at most 11.1 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 12.1.
    """
    arguments = _floats(k, T, sigma_r, C)
    k, T, sigma_r, C = arguments
    span = (1.0 + k) * (k - 1.0)
    middle = 0.5 * k - 0.5
    per_constant = 1.0 / k
    term_1 = per_constant
    per_slope = 12.0 * term_1 / (12.0 * C + span)
    sigma_r_squared = sigma_r**2
    sum_1 = middle**2 * per_slope + per_constant
    result = _empty(arguments, (2, 2))
    result[..., 0, 0] = sigma_r_squared * sum_1
    result[..., 0, 1] = middle * per_slope * sigma_r_squared / T
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = per_slope * sigma_r_squared / T**2
    return result


def degree1_range_rate_correlation(*, k: npt.ArrayLike, C: npt.ArrayLike) -> Floats:
    """Correlation of the errors of range and range rate from k scans of range and range rate (where C > 0, k from 1 on), at the newest scan.

    Name: finite_sample.degree1.range_rate.correlation.
    Definition: R_mn / sqrt(R_mm R_nn).
    Conditioning: no expectation is taken.
    Source: Gorshkov & Zavizhenets (10)-(12).

    Args:
        k: number of scans [1], 2 to 1e+06.
        C: sigma_r^2/(T^2 sigma_v^2), the weight of the range rate [1], 0 to 1e+12.

    Returns:
        Shape of the broadcast arguments + (2, 2), unit 1.

    Accuracy: at most 17.1 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 17.1.
    """
    arguments = _floats(k, C)
    k, C = arguments
    k_beyond_2 = k - 2.0
    k_beyond_2_squared = k_beyond_2**2
    sum_1 = 3.0 + 12.0 * C + 4.0 * k_beyond_2 + k_beyond_2_squared
    sum_2 = 6.0 + 10.0 * k_beyond_2 + 12.0 * C + 4.0 * k_beyond_2_squared
    result = _empty(arguments, (2, 2))
    result[..., 0, 0] = 1.0
    result[..., 0, 1] = (6.0 + 6.0 * k_beyond_2) * np.sqrt(3.0) / (np.sqrt(sum_2 / sum_1**2) * sum_1 * 6.0)
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = 1.0
    return result


def degree1_range_rate_range_weights(
    *,
    k: npt.ArrayLike,
    j: npt.ArrayLike,
    T: npt.ArrayLike,
    C: npt.ArrayLike,
) -> Floats:
    """Weights of the range of scan j in the estimate of range and range rate from k scans of range and range rate (where C > 0, k from 1 on), at the newest scan.

    Name: finite_sample.degree1.range_rate.range_weights.
    Definition: W_j = R H_j' Q_theta.
    Conditioning: no expectation is taken.
    Source: Gorshkov & Zavizhenets (13)-(20).

    Args:
        k: number of scans [1], 2 to 1e+06.
        j: number of the scan that is weighted, 1 the oldest, k the newest [1], 1 to 1e+06.
        T: time from scan to scan [s], 0.001 to 1000.
        C: sigma_r^2/(T^2 sigma_v^2), the weight of the range rate [1], 0 to 1e+12.

    Returns:
        Shape of the broadcast arguments + (2), unit [1, 1/s].

    Accuracy: at most 34.4 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 34.4. Errors are measured against the
    weights of this, the first and the last scan and the root mean square of all.
    """
    arguments = _floats(k, j, T, C)
    k, j, T, C = arguments
    span = (1.0 + k) * (k - 1.0)
    middle = 0.5 * k - 0.5
    scan_position = j - 0.5 - 0.5 * k
    per_constant = 1.0 / k
    term_1 = per_constant
    per_slope = 12.0 * term_1 / (12.0 * C + span)
    result = _empty(arguments, (2,))
    result[..., 0] = middle * per_slope * scan_position + per_constant
    result[..., 1] = per_slope * scan_position / T
    return result


def degree1_range_rate_rate_weights(
    *,
    k: npt.ArrayLike,
    j: npt.ArrayLike,
    T: npt.ArrayLike,
    C: npt.ArrayLike,
) -> Floats:
    """Weights of the rate of scan j in the estimate of range and range rate from k scans of range and range rate (where C > 0, k from 1 on), at the newest scan.

    Name: finite_sample.degree1.range_rate.rate_weights.
    Definition: W_j = R H_j' Q_theta.
    Conditioning: no expectation is taken.
    Source: Gorshkov & Zavizhenets (13)-(20).

    Args:
        k: number of scans [1], 2 to 1e+06.
        j: number of the scan that is weighted, 1 the oldest, k the newest [1], 1 to 1e+06.
        T: time from scan to scan [s], 0.001 to 1000.
        C: sigma_r^2/(T^2 sigma_v^2), the weight of the range rate [1], 0 to 1e+12.

    Returns:
        Shape of the broadcast arguments + (2), unit [s, 1].

    Accuracy: at most 7.01 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64). Errors are measured against the weights of this, the first and the last scan and the root mean
    square of all.
    """
    arguments = _floats(k, j, T, C)
    k, j, T, C = arguments
    span = (1.0 + k) * (k - 1.0)
    middle = 0.5 * k - 0.5
    per_slope = 12.0 / ((12.0 * C + span) * k)
    result = _empty(arguments, (2,))
    result[..., 0] = C * T * middle * per_slope
    result[..., 1] = C * per_slope
    return result


def degree1_range_rate_at_lag_covariance(
    *,
    k: npt.ArrayLike,
    T: npt.ArrayLike,
    sigma_r: npt.ArrayLike,
    C: npt.ArrayLike,
    tau: npt.ArrayLike,
) -> Floats:
    """Error covariance of range and range rate from k scans of range and range rate (where C > 0, k from 1 on), tau scans after the newest one.

    Name: finite_sample.degree1.range_rate.at_lag.covariance.
    Definition: R = (sum_j H_j' Q_theta H_j)^-1.
    Conditioning: no expectation is taken.
    Source: Gorshkov & Zavizhenets (2), (7)-(12).

    Args:
        k: number of scans [1], 2 to 1e+06.
        T: time from scan to scan [s], 0.001 to 1000.
        sigma_r: standard deviation of the error of the range [m], 0.001 to 10000.
        C: sigma_r^2/(T^2 sigma_v^2), the weight of the range rate [1], 0 to 1e+12.
        tau: scans from the newest one to the time of the estimate, less than 0 to smooth [1], -1e+06 to 1e+06.

    Returns:
        Shape of the broadcast arguments + (2, 2), unit [m, m/s] × [m, m/s].

    Accuracy: at most 14.1 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 14.1.
    """
    arguments = _floats(k, T, sigma_r, C, tau)
    k, T, sigma_r, C, tau = arguments
    span = (1.0 + k) * (k - 1.0)
    middle = 0.5 * k - 0.5
    position = middle + tau
    per_constant = 1.0 / k
    term_1 = per_constant
    per_slope = 12.0 * term_1 / (12.0 * C + span)
    sigma_r_squared = sigma_r**2
    sum_1 = per_constant + per_slope * position**2
    result = _empty(arguments, (2, 2))
    result[..., 0, 0] = sigma_r_squared * sum_1
    result[..., 0, 1] = per_slope * position * sigma_r_squared / T
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = per_slope * sigma_r_squared / T**2
    return result


def degree1_range_rate_at_lag_range_weights(
    *,
    k: npt.ArrayLike,
    j: npt.ArrayLike,
    T: npt.ArrayLike,
    C: npt.ArrayLike,
    tau: npt.ArrayLike,
) -> Floats:
    """Weights of the range of scan j in the estimate of range and range rate from k scans of range and range rate (where C > 0, k from 1 on), tau scans after the newest one.

    Name: finite_sample.degree1.range_rate.at_lag.range_weights.
    Definition: W_j = R H_j' Q_theta.
    Conditioning: no expectation is taken.
    Source: Gorshkov & Zavizhenets (13)-(20).

    Args:
        k: number of scans [1], 2 to 1e+06.
        j: number of the scan that is weighted, 1 the oldest, k the newest [1], 1 to 1e+06.
        T: time from scan to scan [s], 0.001 to 1000.
        C: sigma_r^2/(T^2 sigma_v^2), the weight of the range rate [1], 0 to 1e+12.
        tau: scans from the newest one to the time of the estimate, less than 0 to smooth [1], -1e+06 to 1e+06.

    Returns:
        Shape of the broadcast arguments + (2), unit [1, 1/s].

    Accuracy: at most 45.4 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 45.4. Errors are measured against the
    weights of this, the first and the last scan and the root mean square of all.
    """
    arguments = _floats(k, j, T, C, tau)
    k, j, T, C, tau = arguments
    span = (1.0 + k) * (k - 1.0)
    middle = 0.5 * k - 0.5
    position = middle + tau
    scan_position = j - 0.5 - 0.5 * k
    per_constant = 1.0 / k
    term_1 = per_constant
    per_slope = 12.0 * term_1 / (12.0 * C + span)
    result = _empty(arguments, (2,))
    result[..., 0] = per_constant + per_slope * position * scan_position
    result[..., 1] = per_slope * scan_position / T
    return result


def degree1_range_rate_at_lag_rate_weights(
    *,
    k: npt.ArrayLike,
    j: npt.ArrayLike,
    T: npt.ArrayLike,
    C: npt.ArrayLike,
    tau: npt.ArrayLike,
) -> Floats:
    """Weights of the rate of scan j in the estimate of range and range rate from k scans of range and range rate (where C > 0, k from 1 on), tau scans after the newest one.

    Name: finite_sample.degree1.range_rate.at_lag.rate_weights.
    Definition: W_j = R H_j' Q_theta.
    Conditioning: no expectation is taken.
    Source: Gorshkov & Zavizhenets (13)-(20).

    Args:
        k: number of scans [1], 2 to 1e+06.
        j: number of the scan that is weighted, 1 the oldest, k the newest [1], 1 to 1e+06.
        T: time from scan to scan [s], 0.001 to 1000.
        C: sigma_r^2/(T^2 sigma_v^2), the weight of the range rate [1], 0 to 1e+12.
        tau: scans from the newest one to the time of the estimate, less than 0 to smooth [1], -1e+06 to 1e+06.

    Returns:
        Shape of the broadcast arguments + (2), unit [s, 1].

    Accuracy: at most 8.01 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64). Errors are measured against the weights of this, the first and the last scan and the root mean
    square of all.
    """
    arguments = _floats(k, j, T, C, tau)
    k, j, T, C, tau = arguments
    span = (1.0 + k) * (k - 1.0)
    middle = 0.5 * k - 0.5
    position = middle + tau
    per_slope = 12.0 / ((12.0 * C + span) * k)
    result = _empty(arguments, (2,))
    result[..., 0] = C * T * per_slope * position
    result[..., 1] = C * per_slope
    return result


def degree1_gain(*, k: npt.ArrayLike, C: npt.ArrayLike) -> Floats:
    """Part of the standard deviations of range and range rate that the range rate removes, at the newest scan.

    Name: finite_sample.degree1.gain.
    Definition: K_x = 1 - sqrt(R_xx with range rate / R_xx without).
    Conditioning: no expectation is taken.
    Source: Gorshkov & Zavizhenets (22).

    Args:
        k: number of scans [1], 2 to 1e+06.
        C: sigma_r^2/(T^2 sigma_v^2), the weight of the range rate [1], 0 to 1e+12.

    Returns:
        Shape of the broadcast arguments + (2), unit 1.

    Accuracy: at most 20.1 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64). Errors are measured against itself.
    """
    arguments = _floats(k, C)
    k, C = arguments
    k_beyond_2 = k - 2.0
    term_1 = 1.0 / (3.0 + 2.0 * k_beyond_2)
    k_beyond_2_squared = k_beyond_2**2
    term_2 = 1.0 / (3.0 + 12.0 * C + 4.0 * k_beyond_2 + k_beyond_2_squared)
    sum_1 = 3.0 + 2.0 * k_beyond_2_squared + 5.0 * k_beyond_2 + 6.0 * C
    term_3 = np.sqrt(3.0 + k_beyond_2)
    sum_2 = 1.0 + k_beyond_2
    result = _empty(arguments, (2,))
    result[..., 0] = 18.0 * C * sum_2 * term_1 * term_2 / (1.0 + np.sqrt(sum_1 * term_1 * term_2) * term_3)
    result[..., 1] = 12.0 * C * term_2 / (1.0 + np.sqrt(sum_2 * term_2) * term_3)
    return result


def degree1_range_gain_of_perfect_rate(*, k: npt.ArrayLike) -> Floats:
    """Part of the standard deviation of the range, of range and range rate, that errorless range rates would remove.

    Name: finite_sample.degree1.range_gain_of_perfect_rate.
    Definition: limit of K_r for C to infinity.
    Conditioning: no expectation is taken.
    Source: Gorshkov & Zavizhenets (22).

    Args:
        k: number of scans [1], 2 to 1e+06.

    Returns:
        Shape of the broadcast arguments, unit 1.

    Accuracy: at most 9.51 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 9.51.
    """
    arguments = _floats(k)
    k, = arguments
    term_1 = 1.0 / (2.0 * k - 1.0)
    result = _empty(arguments, ())
    result[...] = 1.5 * (k - 1.0) * term_1 / (1.0 + 0.5 * np.sqrt(2.0) * np.sqrt(1.0 + k) * np.sqrt(term_1))
    return result[()]


def degree2_range_design(*, k: npt.ArrayLike, j: npt.ArrayLike, T: npt.ArrayLike) -> Floats:
    """Observations of scan j by range and two derivatives from k scans of range.

    Name: finite_sample.degree2.range.design.
    Definition: H_j.
    Conditioning: no expectation is taken.
    Source: Gorshkov & Zavizhenets (3)-(4).

    Args:
        k: number of scans [1], 1 to 1e+06.
        j: number of the scan that is weighted, 1 the oldest, k the newest [1], 1 to 1e+06.
        T: time from scan to scan [s], 0.001 to 1000.

    Returns:
        Shape of the broadcast arguments + (1, 3), unit [m] × [1/m, s/m, s^2/m].

    Accuracy: at most 3.01 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 5.01.
    """
    arguments = _floats(k, j, T)
    k, j, T = arguments
    sum_1 = j - k
    result = _empty(arguments, (1, 3))
    result[..., 0, 0] = 1.0
    result[..., 0, 1] = T * sum_1
    result[..., 0, 2] = 0.5 * T**2 * sum_1**2
    return result


def degree2_range_precision(*, sigma_r: npt.ArrayLike) -> Floats:
    """Inverse variances of the observations of one scan, for range and two derivatives from k scans of range.

    Name: finite_sample.degree2.range.precision.
    Definition: Q_theta.
    Conditioning: no expectation is taken.
    Source: Gorshkov & Zavizhenets (5).

    Args:
        sigma_r: standard deviation of the error of the range [m], 0.001 to 10000.

    Returns:
        Shape of the broadcast arguments + (1, 1), unit 1/m^2.

    Accuracy: at most 3.01 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 3.01.
    """
    arguments = _floats(sigma_r)
    sigma_r, = arguments
    result = _empty(arguments, (1, 1))
    result[..., 0, 0] = 1.0 / sigma_r**2
    return result


def degree2_range_information(*, k: npt.ArrayLike, T: npt.ArrayLike, sigma_r: npt.ArrayLike) -> Floats:
    """Information matrix of range and two derivatives from k scans of range.

    Name: finite_sample.degree2.range.information.
    Definition: Q = sum_j H_j' Q_theta H_j.
    Conditioning: no expectation is taken.
    Source: Gorshkov & Zavizhenets (2), (6).

    Args:
        k: number of scans [1], 1 to 1e+06.
        T: time from scan to scan [s], 0.001 to 1000.
        sigma_r: standard deviation of the error of the range [m], 0.001 to 10000.

    Returns:
        Shape of the broadcast arguments + (3, 3), unit [1/m, s/m, s^2/m] × [1/m, s/m, s^2/m].

    Accuracy: at most 15.1 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64).
    """
    arguments = _floats(k, T, sigma_r)
    k, T, sigma_r = arguments
    term_1 = 1.0 / sigma_r**2
    sum_1 = k - 1.0
    sum_2 = 2.0 * k - 1.0
    T_squared = T**2
    k_squared = k**2
    sum_3 = 3.0 * k_squared - 1.0 - 3.0 * k
    result = _empty(arguments, (3, 3))
    result[..., 0, 0] = k * term_1
    result[..., 0, 1] = -0.5 * T * k * sum_1 * term_1
    result[..., 0, 2] = T_squared * k * sum_1 * sum_2 * term_1 / 12.0
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = T_squared * k * sum_1 * sum_2 * term_1 / 6.0
    result[..., 1, 2] = -0.125 * T * T_squared * k_squared * sum_1**2 * term_1
    result[..., 2, 0] = result[..., 0, 2]
    result[..., 2, 1] = result[..., 1, 2]
    result[..., 2, 2] = T_squared**2 * k * sum_1 * sum_2 * sum_3 * term_1 / 120.0
    return result


def degree2_range_covariance(*, k: npt.ArrayLike, T: npt.ArrayLike, sigma_r: npt.ArrayLike) -> Floats:
    """Error covariance of range and two derivatives from k scans of range, at the newest scan.

    Name: finite_sample.degree2.range.covariance.
    Definition: R = (sum_j H_j' Q_theta H_j)^-1.
    Conditioning: no expectation is taken.
    Source: Gorshkov & Zavizhenets (2), (7)-(12).

    Args:
        k: number of scans [1], 3 to 1e+06.
        T: time from scan to scan [s], 0.001 to 1000.
        sigma_r: standard deviation of the error of the range [m], 0.001 to 10000.

    Returns:
        Shape of the broadcast arguments + (3, 3), unit [m, m/s, m/s^2] × [m, m/s, m/s^2].

    Accuracy: at most 15.1 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64).
    """
    arguments = _floats(k, T, sigma_r)
    k, T, sigma_r = arguments
    sum_1 = k - 1.0
    span = (1.0 + k) * sum_1
    sum_2 = k - 2.0
    bend = (2.0 + k) * sum_2
    middle = 0.5 * k - 0.5
    per_constant = 1.0 / k
    term_1 = per_constant
    term_2 = 1.0 / span
    per_slope = 12.0 * term_1 * term_2
    per_curvature = 180.0 * term_1 * term_2 / bend
    middle_squared = middle**2
    sigma_r_squared = sigma_r**2
    sum_3 = middle_squared * per_slope + per_constant + per_curvature * sum_1**2 * sum_2**2 / 36.0
    sum_4 = middle * per_curvature * sum_1 * sum_2 / 3.0 + middle * per_slope
    term_3 = 1.0 / T**2
    sum_5 = 4.0 * middle_squared * per_curvature + per_slope
    result = _empty(arguments, (3, 3))
    result[..., 0, 0] = sigma_r_squared * sum_3
    result[..., 0, 1] = sigma_r_squared * sum_4 / T
    result[..., 0, 2] = per_curvature * sigma_r_squared * sum_1 * sum_2 * term_3 / 3.0
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = sigma_r_squared * sum_5 * term_3
    result[..., 1, 2] = 4.0 * middle * per_curvature * sigma_r_squared / (T * T**2)
    result[..., 2, 0] = result[..., 0, 2]
    result[..., 2, 1] = result[..., 1, 2]
    result[..., 2, 2] = 4.0 * per_curvature * sigma_r_squared / (T**2)**2
    return result


def degree2_range_correlation(*, k: npt.ArrayLike) -> Floats:
    """Correlation of the errors of range and two derivatives from k scans of range, at the newest scan.

    Name: finite_sample.degree2.range.correlation.
    Definition: R_mn / sqrt(R_mm R_nn).
    Conditioning: no expectation is taken.
    Source: Gorshkov & Zavizhenets (10)-(12).

    Args:
        k: number of scans [1], 3 to 1e+06.

    Returns:
        Shape of the broadcast arguments + (3, 3), unit 1.

    Accuracy: at most 7.51 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 12.
    """
    arguments = _floats(k)
    k, = arguments
    k_beyond_3 = k - 3.0
    sum_1 = 1.0 + k_beyond_3
    term_1 = 1.0 / sum_1
    sum_2 = 2.0 + k_beyond_3
    term_2 = 1.0 / sum_2
    sum_3 = 5.0 + 2.0 * k_beyond_3
    sum_4 = 13.0 + 8.0 * k_beyond_3
    sum_5 = 60.0 + 45.0 * k_beyond_3 + 9.0 * k_beyond_3**2
    result = _empty(arguments, (3, 3))
    result[..., 0, 0] = 1.0
    result[..., 0, 1] = (90.0 + 36.0 * k_beyond_3) * np.sqrt(3.0) / (np.sqrt(sum_3 * sum_4 * sum_5 * term_1 * term_2) * 6.0)
    result[..., 0, 2] = np.sqrt(5.0) / np.sqrt(sum_5 * term_1 * term_2)
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = 1.0
    result[..., 1, 2] = np.sqrt(15.0) * term_1 / np.sqrt(sum_3 * sum_4 / (sum_1**2 * sum_2**2))
    result[..., 2, 0] = result[..., 0, 2]
    result[..., 2, 1] = result[..., 1, 2]
    result[..., 2, 2] = 1.0
    return result


def degree2_range_range_weights(*, k: npt.ArrayLike, j: npt.ArrayLike, T: npt.ArrayLike) -> Floats:
    """Weights of the range of scan j in the estimate of range and two derivatives from k scans of range, at the newest scan.

    Name: finite_sample.degree2.range.range_weights.
    Definition: W_j = R H_j' Q_theta.
    Conditioning: no expectation is taken.
    Source: Gorshkov & Zavizhenets (13)-(20).

    Args:
        k: number of scans [1], 3 to 1e+06.
        j: number of the scan that is weighted, 1 the oldest, k the newest [1], 1 to 1e+06.
        T: time from scan to scan [s], 0.001 to 1000.

    Returns:
        Shape of the broadcast arguments + (3), unit [1, 1/s, 1/s^2].

    Accuracy: at most 414 ulp anywhere in this domain, proved for elementary functions within 1 ulp (float64);
    in float32, with functions within 4 of its ulp, at most 537. Errors are measured against the weights of
    this, the first and the last scan and the root mean square of all.
    """
    arguments = _floats(k, j, T)
    k, j, T = arguments
    sum_1 = k - 1.0
    span = (1.0 + k) * sum_1
    sum_2 = k - 2.0
    bend = (2.0 + k) * sum_2
    middle = 0.5 * k - 0.5
    scan_position = j - 0.5 - 0.5 * k
    scan_reach = (k - j) * (j - 1.0)
    per_constant = 1.0 / k
    term_1 = per_constant
    term_2 = 1.0 / span
    per_slope = 12.0 * term_1 * term_2
    per_curvature = 180.0 * term_1 * term_2 / bend
    sum_3 = sum_1 * sum_2 / 6.0 - scan_reach
    sum_4 = 2.0 * middle * per_curvature * sum_3 + per_slope * scan_position
    sum_5 = sum_1 * sum_2 / 3.0 - 2.0 * scan_reach
    result = _empty(arguments, (3,))
    result[..., 0] = (
        middle * per_slope * scan_position
        + per_constant
        + per_curvature * sum_1 * sum_2 * sum_3 / 6.0
    )
    result[..., 1] = sum_4 / T
    result[..., 2] = per_curvature * sum_5 / T**2
    return result


def degree2_range_at_lag_covariance(
    *,
    k: npt.ArrayLike,
    T: npt.ArrayLike,
    sigma_r: npt.ArrayLike,
    tau: npt.ArrayLike,
) -> Floats:
    """Error covariance of range and two derivatives from k scans of range, tau scans after the newest one.

    Name: finite_sample.degree2.range.at_lag.covariance.
    Definition: R = (sum_j H_j' Q_theta H_j)^-1.
    Conditioning: no expectation is taken.
    Source: Gorshkov & Zavizhenets (2), (7)-(12).

    Args:
        k: number of scans [1], 3 to 1e+06.
        T: time from scan to scan [s], 0.001 to 1000.
        sigma_r: standard deviation of the error of the range [m], 0.001 to 10000.
        tau: scans from the newest one to the time of the estimate, less than 0 to smooth [1], -1e+06 to 1e+06.

    Returns:
        Shape of the broadcast arguments + (3, 3), unit [m, m/s, m/s^2] × [m, m/s, m/s^2].

    Accuracy: measured, not proved: at most 6 ulp from 50-digit arithmetic at 500 points of this domain
    (float64, independent errors).
    """
    arguments = _floats(k, T, sigma_r, tau)
    k, T, sigma_r, tau = arguments
    sum_1 = k - 1.0
    span = (1.0 + k) * sum_1
    sum_2 = k - 2.0
    bend = (2.0 + k) * sum_2
    middle = 0.5 * k - 0.5
    position = middle + tau
    reach = -(k - 1.0 + tau) * tau
    term_1 = (middle**2)**2
    nearness = term_1 / (4.0 * reach**2 + term_1)
    per_constant = 1.0 / k
    term_2 = per_constant
    term_3 = 1.0 / span
    per_slope = 12.0 * term_2 * term_3
    per_curvature = 180.0 * term_2 * term_3 / bend
    sum_3 = 1.0 - nearness
    position_squared = position**2
    sum_4 = position_squared - span / 12.0
    sum_5 = sum_1 * sum_2 / 6.0 - reach
    sum_6 = nearness * sum_5 + sum_3 * sum_4
    sigma_r_squared = sigma_r**2
    sum_7 = per_constant + per_curvature * sum_6**2 + per_slope * position_squared
    sum_8 = 2.0 * per_curvature * position * sum_6 + per_slope * position
    term_4 = 1.0 / T**2
    sum_9 = 2.0 * nearness * sum_5 + 2.0 * sum_3 * sum_4
    sum_10 = 4.0 * per_curvature * position_squared + per_slope
    result = _empty(arguments, (3, 3))
    result[..., 0, 0] = sigma_r_squared * sum_7
    result[..., 0, 1] = sigma_r_squared * sum_8 / T
    result[..., 0, 2] = per_curvature * sigma_r_squared * sum_9 * term_4
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = sigma_r_squared * sum_10 * term_4
    result[..., 1, 2] = 4.0 * per_curvature * position * sigma_r_squared / (T * T**2)
    result[..., 2, 0] = result[..., 0, 2]
    result[..., 2, 1] = result[..., 1, 2]
    result[..., 2, 2] = 4.0 * per_curvature * sigma_r_squared / (T**2)**2
    return result


def degree2_range_at_lag_range_weights(
    *,
    k: npt.ArrayLike,
    j: npt.ArrayLike,
    T: npt.ArrayLike,
    tau: npt.ArrayLike,
) -> Floats:
    """Weights of the range of scan j in the estimate of range and two derivatives from k scans of range, tau scans after the newest one.

    Name: finite_sample.degree2.range.at_lag.range_weights.
    Definition: W_j = R H_j' Q_theta.
    Conditioning: no expectation is taken.
    Source: Gorshkov & Zavizhenets (13)-(20).

    Args:
        k: number of scans [1], 3 to 1e+06.
        j: number of the scan that is weighted, 1 the oldest, k the newest [1], 1 to 1e+06.
        T: time from scan to scan [s], 0.001 to 1000.
        tau: scans from the newest one to the time of the estimate, less than 0 to smooth [1], -1e+06 to 1e+06.

    Returns:
        Shape of the broadcast arguments + (3), unit [1, 1/s, 1/s^2].

    Accuracy: measured, not proved: at most 3 ulp from 50-digit arithmetic at 500 points of this domain
    (float64, independent errors). Errors are measured against the weights of this, the first and the last
    scan and the root mean square of all.
    """
    arguments = _floats(k, j, T, tau)
    k, j, T, tau = arguments
    sum_1 = k - 1.0
    span = (1.0 + k) * sum_1
    sum_2 = k - 2.0
    bend = (2.0 + k) * sum_2
    middle = 0.5 * k - 0.5
    position = middle + tau
    reach = -(k - 1.0 + tau) * tau
    term_1 = (middle**2)**2
    nearness = term_1 / (4.0 * reach**2 + term_1)
    scan_position = j - 0.5 - 0.5 * k
    scan_reach = (k - j) * (j - 1.0)
    per_constant = 1.0 / k
    term_2 = per_constant
    term_3 = 1.0 / span
    per_slope = 12.0 * term_2 * term_3
    per_curvature = 180.0 * term_2 * term_3 / bend
    product_1 = sum_1 * sum_2 / 6.0
    sum_3 = product_1 - scan_reach
    sum_4 = (1.0 - nearness) * (position**2 - span / 12.0) + nearness * (product_1 - reach)
    sum_5 = 2.0 * per_curvature * position * sum_3 + per_slope * scan_position
    sum_6 = sum_1 * sum_2 / 3.0 - 2.0 * scan_reach
    result = _empty(arguments, (3,))
    result[..., 0] = per_constant + per_curvature * sum_3 * sum_4 + per_slope * position * scan_position
    result[..., 1] = sum_5 / T
    result[..., 2] = per_curvature * sum_6 / T**2
    return result


def degree2_range_rate_design(*, k: npt.ArrayLike, j: npt.ArrayLike, T: npt.ArrayLike) -> Floats:
    """Observations of scan j by range and two derivatives from k scans of range and range rate (where C > 0, k from 2 on).

    Name: finite_sample.degree2.range_rate.design.
    Definition: H_j.
    Conditioning: no expectation is taken.
    Source: Gorshkov & Zavizhenets (3)-(4).

    Args:
        k: number of scans [1], 1 to 1e+06.
        j: number of the scan that is weighted, 1 the oldest, k the newest [1], 1 to 1e+06.
        T: time from scan to scan [s], 0.001 to 1000.

    Returns:
        Shape of the broadcast arguments + (2, 3), unit [m, m/s] × [1/m, s/m, s^2/m].

    Accuracy: at most 3.01 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 5.01.
    """
    arguments = _floats(k, j, T)
    k, j, T = arguments
    sum_1 = j - k
    result = _empty(arguments, (2, 3))
    result[..., 0, 0] = 1.0
    result[..., 0, 1] = T * sum_1
    result[..., 0, 2] = 0.5 * T**2 * sum_1**2
    result[..., 1, 0] = 0.0
    result[..., 1, 1] = 1.0
    result[..., 1, 2] = result[..., 0, 1]
    return result


def degree2_range_rate_precision(*, sigma_r: npt.ArrayLike, T: npt.ArrayLike, C: npt.ArrayLike) -> Floats:
    """Inverse variances of the observations of one scan, for range and two derivatives from k scans of range and range rate (where C > 0, k from 2 on).

    Name: finite_sample.degree2.range_rate.precision.
    Definition: Q_theta.
    Conditioning: no expectation is taken.
    Source: Gorshkov & Zavizhenets (5).

    Args:
        sigma_r: standard deviation of the error of the range [m], 0.001 to 10000.
        T: time from scan to scan [s], 0.001 to 1000.
        C: sigma_r^2/(T^2 sigma_v^2), the weight of the range rate [1], 0 to 1e+12.

    Returns:
        Shape of the broadcast arguments + (2, 2), unit [1/m, s/m] × [1/m, s/m].

    Accuracy: at most 7.01 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 7.01.
    """
    arguments = _floats(sigma_r, T, C)
    sigma_r, T, C = arguments
    term_1 = 1.0 / sigma_r**2
    result = _empty(arguments, (2, 2))
    result[..., 0, 0] = term_1
    result[..., 0, 1] = 0.0
    result[..., 1, 0] = 0.0
    result[..., 1, 1] = C * T**2 * term_1
    return result


def degree2_range_rate_information(
    *,
    k: npt.ArrayLike,
    T: npt.ArrayLike,
    sigma_r: npt.ArrayLike,
    C: npt.ArrayLike,
) -> Floats:
    """Information matrix of range and two derivatives from k scans of range and range rate (where C > 0, k from 2 on).

    Name: finite_sample.degree2.range_rate.information.
    Definition: Q = sum_j H_j' Q_theta H_j.
    Conditioning: no expectation is taken.
    Source: Gorshkov & Zavizhenets (2), (6).

    Args:
        k: number of scans [1], 1 to 1e+06.
        T: time from scan to scan [s], 0.001 to 1000.
        sigma_r: standard deviation of the error of the range [m], 0.001 to 10000.
        C: sigma_r^2/(T^2 sigma_v^2), the weight of the range rate [1], 0 to 1e+12.

    Returns:
        Shape of the broadcast arguments + (3, 3), unit [1/m, s/m, s^2/m] × [1/m, s/m, s^2/m].

    Accuracy: at most 19.1 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64).
    """
    arguments = _floats(k, T, sigma_r, C)
    k, T, sigma_r, C = arguments
    term_1 = 1.0 / sigma_r**2
    sum_1 = k - 1.0
    sum_2 = 2.0 * k - 1.0
    T_squared = T**2
    k_squared = k**2
    sum_3 = 1.0 - 3.0 * k + 2.0 * k_squared + 6.0 * C
    sum_4 = 20.0 * C - 1.0 - 3.0 * k + 3.0 * k_squared
    result = _empty(arguments, (3, 3))
    result[..., 0, 0] = k * term_1
    result[..., 0, 1] = -0.5 * T * k * sum_1 * term_1
    result[..., 0, 2] = T_squared * k * sum_1 * sum_2 * term_1 / 12.0
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = T_squared * k * sum_3 * term_1 / 6.0
    result[..., 1, 2] = -0.125 * T * T_squared * k * (4.0 * C - k + k_squared) * sum_1 * term_1
    result[..., 2, 0] = result[..., 0, 2]
    result[..., 2, 1] = result[..., 1, 2]
    result[..., 2, 2] = T_squared**2 * k * sum_1 * sum_2 * sum_4 * term_1 / 120.0
    return result


def degree2_range_rate_covariance(
    *,
    k: npt.ArrayLike,
    T: npt.ArrayLike,
    sigma_r: npt.ArrayLike,
    C: npt.ArrayLike,
) -> Floats:
    """Error covariance of range and two derivatives from k scans of range and range rate (where C > 0, k from 2 on), at the newest scan.

    Name: finite_sample.degree2.range_rate.covariance.
    Definition: R = (sum_j H_j' Q_theta H_j)^-1.
    Conditioning: no expectation is taken.
    Source: Gorshkov & Zavizhenets (2), (7)-(12).

    Args:
        k: number of scans [1], 3 to 1e+06.
        T: time from scan to scan [s], 0.001 to 1000.
        sigma_r: standard deviation of the error of the range [m], 0.001 to 10000.
        C: sigma_r^2/(T^2 sigma_v^2), the weight of the range rate [1], 0 to 1e+12.

    Returns:
        Shape of the broadcast arguments + (3, 3), unit [m, m/s, m/s^2] × [m, m/s, m/s^2].

    Accuracy: at most 16.1 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64).
    """
    arguments = _floats(k, T, sigma_r, C)
    k, T, sigma_r, C = arguments
    sum_1 = k - 1.0
    span = (1.0 + k) * sum_1
    sum_2 = k - 2.0
    bend = (2.0 + k) * sum_2
    middle = 0.5 * k - 0.5
    per_constant = 1.0 / k
    term_1 = per_constant
    per_slope = 12.0 * term_1 / (12.0 * C + span)
    per_curvature = 180.0 * term_1 / ((60.0 * C + bend) * span)
    middle_squared = middle**2
    sigma_r_squared = sigma_r**2
    sum_3 = middle_squared * per_slope + per_constant + per_curvature * sum_1**2 * sum_2**2 / 36.0
    sum_4 = middle * per_curvature * sum_1 * sum_2 / 3.0 + middle * per_slope
    term_2 = 1.0 / T**2
    sum_5 = 4.0 * middle_squared * per_curvature + per_slope
    result = _empty(arguments, (3, 3))
    result[..., 0, 0] = sigma_r_squared * sum_3
    result[..., 0, 1] = sigma_r_squared * sum_4 / T
    result[..., 0, 2] = per_curvature * sigma_r_squared * sum_1 * sum_2 * term_2 / 3.0
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = sigma_r_squared * sum_5 * term_2
    result[..., 1, 2] = 4.0 * middle * per_curvature * sigma_r_squared / (T * T**2)
    result[..., 2, 0] = result[..., 0, 2]
    result[..., 2, 1] = result[..., 1, 2]
    result[..., 2, 2] = 4.0 * per_curvature * sigma_r_squared / (T**2)**2
    return result


def degree2_range_rate_correlation(*, k: npt.ArrayLike, C: npt.ArrayLike) -> Floats:
    """Correlation of the errors of range and two derivatives from k scans of range and range rate (where C > 0, k from 2 on), at the newest scan.

    Name: finite_sample.degree2.range_rate.correlation.
    Definition: R_mn / sqrt(R_mm R_nn).
    Conditioning: no expectation is taken.
    Source: Gorshkov & Zavizhenets (10)-(12).

    Args:
        k: number of scans [1], 3 to 1e+06.
        C: sigma_r^2/(T^2 sigma_v^2), the weight of the range rate [1], 0 to 1e+12.

    Returns:
        Shape of the broadcast arguments + (3, 3), unit 1.

    Accuracy: at most 42.6 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64).
    """
    arguments = _floats(k, C)
    k, C = arguments
    k_beyond_3 = k - 3.0
    k_beyond_3_squared = k_beyond_3**2
    sum_1 = 8.0 + 12.0 * C + 6.0 * k_beyond_3 + k_beyond_3_squared
    term_1 = 1.0 / sum_1
    sum_2 = 5.0 + 6.0 * k_beyond_3 + 60.0 * C + k_beyond_3_squared
    term_2 = 1.0 / sum_2
    term_3 = 1.0 / sum_2**2
    sum_3 = 5.0 + 2.0 * k_beyond_3
    sum_4 = 52.0 + 120.0 * C + 45.0 * k_beyond_3 + 8.0 * k_beyond_3_squared
    C_squared = C**2
    product_1 = k_beyond_3 * k_beyond_3_squared
    sum_5 = (
        480.0
        + 108.0 * k_beyond_3_squared**2
        + 1122.0 * k_beyond_3_squared
        + 1200.0 * k_beyond_3
        + 2400.0 * C * k_beyond_3_squared
        + 2880.0 * C_squared
        + 312.0 * C * product_1
        + 501.0 * product_1
        + 5160.0 * C
        + 6168.0 * C * k_beyond_3
        + 720.0 * C_squared * k_beyond_3
        + 9.0 * k_beyond_3 * k_beyond_3_squared**2
    )
    sum_6 = 2.0 + k_beyond_3
    sum_7 = 4.0 + 20.0 * C + 5.0 * k_beyond_3 + k_beyond_3_squared
    term_4 = 1.0 / sum_6
    result = _empty(arguments, (3, 3))
    result[..., 0, 0] = 1.0
    result[..., 0, 1] = 3.0 * np.sqrt(3.0) * sum_3 * sum_6 * sum_7 * term_1 * term_2 / np.sqrt(sum_3 * sum_4 * sum_5 * term_3 / sum_1**2)
    result[..., 0, 2] = (60.0 + 60.0 * k_beyond_3) * np.sqrt(5.0) * term_2 / (np.sqrt(sum_5 * term_1 * term_3 * term_4) * 60.0)
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = 1.0
    result[..., 1, 2] = np.sqrt(15.0) * term_2 / np.sqrt(sum_3 * sum_4 * term_1 * term_3 * term_4)
    result[..., 2, 0] = result[..., 0, 2]
    result[..., 2, 1] = result[..., 1, 2]
    result[..., 2, 2] = 1.0
    return result


def degree2_range_rate_range_weights(
    *,
    k: npt.ArrayLike,
    j: npt.ArrayLike,
    T: npt.ArrayLike,
    C: npt.ArrayLike,
) -> Floats:
    """Weights of the range of scan j in the estimate of range and two derivatives from k scans of range and range rate (where C > 0, k from 2 on), at the newest scan.

    Name: finite_sample.degree2.range_rate.range_weights.
    Definition: W_j = R H_j' Q_theta.
    Conditioning: no expectation is taken.
    Source: Gorshkov & Zavizhenets (13)-(20).

    Args:
        k: number of scans [1], 3 to 1e+06.
        j: number of the scan that is weighted, 1 the oldest, k the newest [1], 1 to 1e+06.
        T: time from scan to scan [s], 0.001 to 1000.
        C: sigma_r^2/(T^2 sigma_v^2), the weight of the range rate [1], 0 to 1e+12.

    Returns:
        Shape of the broadcast arguments + (3), unit [1, 1/s, 1/s^2].

    Accuracy: at most 583 ulp anywhere in this domain, proved for elementary functions within 1 ulp (float64);
    in float32, with functions within 4 of its ulp, at most 583. Errors are measured against the weights of
    this, the first and the last scan and the root mean square of all.
    """
    arguments = _floats(k, j, T, C)
    k, j, T, C = arguments
    sum_1 = k - 1.0
    span = (1.0 + k) * sum_1
    sum_2 = k - 2.0
    bend = (2.0 + k) * sum_2
    middle = 0.5 * k - 0.5
    scan_position = j - 0.5 - 0.5 * k
    scan_reach = (k - j) * (j - 1.0)
    per_constant = 1.0 / k
    term_1 = per_constant
    per_slope = 12.0 * term_1 / (12.0 * C + span)
    per_curvature = 180.0 * term_1 / ((60.0 * C + bend) * span)
    sum_3 = sum_1 * sum_2 / 6.0 - scan_reach
    sum_4 = 2.0 * middle * per_curvature * sum_3 + per_slope * scan_position
    sum_5 = sum_1 * sum_2 / 3.0 - 2.0 * scan_reach
    result = _empty(arguments, (3,))
    result[..., 0] = (
        middle * per_slope * scan_position
        + per_constant
        + per_curvature * sum_1 * sum_2 * sum_3 / 6.0
    )
    result[..., 1] = sum_4 / T
    result[..., 2] = per_curvature * sum_5 / T**2
    return result


def degree2_range_rate_rate_weights(
    *,
    k: npt.ArrayLike,
    j: npt.ArrayLike,
    T: npt.ArrayLike,
    C: npt.ArrayLike,
) -> Floats:
    """Weights of the rate of scan j in the estimate of range and two derivatives from k scans of range and range rate (where C > 0, k from 2 on), at the newest scan.

    Name: finite_sample.degree2.range_rate.rate_weights.
    Definition: W_j = R H_j' Q_theta.
    Conditioning: no expectation is taken.
    Source: Gorshkov & Zavizhenets (13)-(20).

    Args:
        k: number of scans [1], 3 to 1e+06.
        j: number of the scan that is weighted, 1 the oldest, k the newest [1], 1 to 1e+06.
        T: time from scan to scan [s], 0.001 to 1000.
        C: sigma_r^2/(T^2 sigma_v^2), the weight of the range rate [1], 0 to 1e+12.

    Returns:
        Shape of the broadcast arguments + (3), unit [s, 1, 1/s].

    Accuracy: at most 58 ulp anywhere in this domain, proved for elementary functions within 1 ulp (float64).
    Errors are measured against the weights of this, the first and the last scan and the root mean square of
    all.
    """
    arguments = _floats(k, j, T, C)
    k, j, T, C = arguments
    sum_1 = k - 1.0
    span = (1.0 + k) * sum_1
    sum_2 = k - 2.0
    bend = (2.0 + k) * sum_2
    middle = 0.5 * k - 0.5
    scan_position = j - 0.5 - 0.5 * k
    term_1 = 1.0 / k
    per_slope = 12.0 * term_1 / (12.0 * C + span)
    per_curvature = 180.0 * term_1 / ((60.0 * C + bend) * span)
    sum_3 = middle * per_slope + per_curvature * scan_position * sum_1 * sum_2 / 3.0
    sum_4 = 4.0 * middle * per_curvature * scan_position + per_slope
    result = _empty(arguments, (3,))
    result[..., 0] = C * T * sum_3
    result[..., 1] = C * sum_4
    result[..., 2] = 4.0 * C * per_curvature * scan_position / T
    return result


def degree2_range_rate_at_lag_covariance(
    *,
    k: npt.ArrayLike,
    T: npt.ArrayLike,
    sigma_r: npt.ArrayLike,
    C: npt.ArrayLike,
    tau: npt.ArrayLike,
) -> Floats:
    """Error covariance of range and two derivatives from k scans of range and range rate (where C > 0, k from 2 on), tau scans after the newest one.

    Name: finite_sample.degree2.range_rate.at_lag.covariance.
    Definition: R = (sum_j H_j' Q_theta H_j)^-1.
    Conditioning: no expectation is taken.
    Source: Gorshkov & Zavizhenets (2), (7)-(12).

    Args:
        k: number of scans [1], 3 to 1e+06.
        T: time from scan to scan [s], 0.001 to 1000.
        sigma_r: standard deviation of the error of the range [m], 0.001 to 10000.
        C: sigma_r^2/(T^2 sigma_v^2), the weight of the range rate [1], 0 to 1e+12.
        tau: scans from the newest one to the time of the estimate, less than 0 to smooth [1], -1e+06 to 1e+06.

    Returns:
        Shape of the broadcast arguments + (3, 3), unit [m, m/s, m/s^2] × [m, m/s, m/s^2].

    Accuracy: measured, not proved: at most 6.5 ulp from 50-digit arithmetic at 500 points of this domain
    (float64, independent errors).
    """
    arguments = _floats(k, T, sigma_r, C, tau)
    k, T, sigma_r, C, tau = arguments
    sum_1 = k - 1.0
    span = (1.0 + k) * sum_1
    sum_2 = k - 2.0
    bend = (2.0 + k) * sum_2
    middle = 0.5 * k - 0.5
    position = middle + tau
    reach = -(k - 1.0 + tau) * tau
    term_1 = (middle**2)**2
    nearness = term_1 / (4.0 * reach**2 + term_1)
    per_constant = 1.0 / k
    term_2 = per_constant
    per_slope = 12.0 * term_2 / (12.0 * C + span)
    per_curvature = 180.0 * term_2 / ((60.0 * C + bend) * span)
    sum_3 = 1.0 - nearness
    position_squared = position**2
    sum_4 = position_squared - span / 12.0
    sum_5 = sum_1 * sum_2 / 6.0 - reach
    sum_6 = nearness * sum_5 + sum_3 * sum_4
    sigma_r_squared = sigma_r**2
    sum_7 = per_constant + per_curvature * sum_6**2 + per_slope * position_squared
    sum_8 = 2.0 * per_curvature * position * sum_6 + per_slope * position
    term_3 = 1.0 / T**2
    sum_9 = 2.0 * nearness * sum_5 + 2.0 * sum_3 * sum_4
    sum_10 = 4.0 * per_curvature * position_squared + per_slope
    result = _empty(arguments, (3, 3))
    result[..., 0, 0] = sigma_r_squared * sum_7
    result[..., 0, 1] = sigma_r_squared * sum_8 / T
    result[..., 0, 2] = per_curvature * sigma_r_squared * sum_9 * term_3
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = sigma_r_squared * sum_10 * term_3
    result[..., 1, 2] = 4.0 * per_curvature * position * sigma_r_squared / (T * T**2)
    result[..., 2, 0] = result[..., 0, 2]
    result[..., 2, 1] = result[..., 1, 2]
    result[..., 2, 2] = 4.0 * per_curvature * sigma_r_squared / (T**2)**2
    return result


def degree2_range_rate_at_lag_range_weights(
    *,
    k: npt.ArrayLike,
    j: npt.ArrayLike,
    T: npt.ArrayLike,
    C: npt.ArrayLike,
    tau: npt.ArrayLike,
) -> Floats:
    """Weights of the range of scan j in the estimate of range and two derivatives from k scans of range and range rate (where C > 0, k from 2 on), tau scans after the newest one.

    Name: finite_sample.degree2.range_rate.at_lag.range_weights.
    Definition: W_j = R H_j' Q_theta.
    Conditioning: no expectation is taken.
    Source: Gorshkov & Zavizhenets (13)-(20).

    Args:
        k: number of scans [1], 3 to 1e+06.
        j: number of the scan that is weighted, 1 the oldest, k the newest [1], 1 to 1e+06.
        T: time from scan to scan [s], 0.001 to 1000.
        C: sigma_r^2/(T^2 sigma_v^2), the weight of the range rate [1], 0 to 1e+12.
        tau: scans from the newest one to the time of the estimate, less than 0 to smooth [1], -1e+06 to 1e+06.

    Returns:
        Shape of the broadcast arguments + (3), unit [1, 1/s, 1/s^2].

    Accuracy: measured, not proved: at most 3 ulp from 50-digit arithmetic at 500 points of this domain
    (float64, independent errors). Errors are measured against the weights of this, the first and the last
    scan and the root mean square of all.
    """
    arguments = _floats(k, j, T, C, tau)
    k, j, T, C, tau = arguments
    sum_1 = k - 1.0
    span = (1.0 + k) * sum_1
    sum_2 = k - 2.0
    bend = (2.0 + k) * sum_2
    middle = 0.5 * k - 0.5
    position = middle + tau
    reach = -(k - 1.0 + tau) * tau
    term_1 = (middle**2)**2
    nearness = term_1 / (4.0 * reach**2 + term_1)
    scan_position = j - 0.5 - 0.5 * k
    scan_reach = (k - j) * (j - 1.0)
    per_constant = 1.0 / k
    term_2 = per_constant
    per_slope = 12.0 * term_2 / (12.0 * C + span)
    per_curvature = 180.0 * term_2 / ((60.0 * C + bend) * span)
    product_1 = sum_1 * sum_2 / 6.0
    sum_3 = product_1 - scan_reach
    sum_4 = (1.0 - nearness) * (position**2 - span / 12.0) + nearness * (product_1 - reach)
    sum_5 = 2.0 * per_curvature * position * sum_3 + per_slope * scan_position
    sum_6 = sum_1 * sum_2 / 3.0 - 2.0 * scan_reach
    result = _empty(arguments, (3,))
    result[..., 0] = per_constant + per_curvature * sum_3 * sum_4 + per_slope * position * scan_position
    result[..., 1] = sum_5 / T
    result[..., 2] = per_curvature * sum_6 / T**2
    return result


def degree2_range_rate_at_lag_rate_weights(
    *,
    k: npt.ArrayLike,
    j: npt.ArrayLike,
    T: npt.ArrayLike,
    C: npt.ArrayLike,
    tau: npt.ArrayLike,
) -> Floats:
    """Weights of the rate of scan j in the estimate of range and two derivatives from k scans of range and range rate (where C > 0, k from 2 on), tau scans after the newest one.

    Name: finite_sample.degree2.range_rate.at_lag.rate_weights.
    Definition: W_j = R H_j' Q_theta.
    Conditioning: no expectation is taken.
    Source: Gorshkov & Zavizhenets (13)-(20).

    Args:
        k: number of scans [1], 3 to 1e+06.
        j: number of the scan that is weighted, 1 the oldest, k the newest [1], 1 to 1e+06.
        T: time from scan to scan [s], 0.001 to 1000.
        C: sigma_r^2/(T^2 sigma_v^2), the weight of the range rate [1], 0 to 1e+12.
        tau: scans from the newest one to the time of the estimate, less than 0 to smooth [1], -1e+06 to 1e+06.

    Returns:
        Shape of the broadcast arguments + (3), unit [s, 1, 1/s].

    Accuracy: measured, not proved: at most 3 ulp from 50-digit arithmetic at 500 points of this domain
    (float64, independent errors). Errors are measured against the weights of this, the first and the last
    scan and the root mean square of all.
    """
    arguments = _floats(k, j, T, C, tau)
    k, j, T, C, tau = arguments
    sum_1 = k - 1.0
    span = (1.0 + k) * sum_1
    sum_2 = k - 2.0
    bend = (2.0 + k) * sum_2
    middle = 0.5 * k - 0.5
    position = middle + tau
    reach = -(k - 1.0 + tau) * tau
    term_1 = (middle**2)**2
    nearness = term_1 / (4.0 * reach**2 + term_1)
    scan_position = j - 0.5 - 0.5 * k
    term_2 = 1.0 / k
    per_slope = 12.0 * term_2 / (12.0 * C + span)
    per_curvature = 180.0 * term_2 / ((60.0 * C + bend) * span)
    sum_3 = (1.0 - nearness) * (position**2 - span / 12.0) + (sum_1 * sum_2 / 6.0 - reach) * nearness
    sum_4 = 2.0 * per_curvature * scan_position * sum_3 + per_slope * position
    sum_5 = 4.0 * per_curvature * position * scan_position + per_slope
    result = _empty(arguments, (3,))
    result[..., 0] = C * T * sum_4
    result[..., 1] = C * sum_5
    result[..., 2] = 4.0 * C * per_curvature * scan_position / T
    return result


def degree2_gain(*, k: npt.ArrayLike, C: npt.ArrayLike) -> Floats:
    """Part of the standard deviations of range and two derivatives that the range rate removes, at the newest scan.

    Name: finite_sample.degree2.gain.
    Definition: K_x = 1 - sqrt(R_xx with range rate / R_xx without).
    Conditioning: no expectation is taken.
    Source: Gorshkov & Zavizhenets (22).

    Args:
        k: number of scans [1], 3 to 1e+06.
        C: sigma_r^2/(T^2 sigma_v^2), the weight of the range rate [1], 0 to 1e+12.

    Returns:
        Shape of the broadcast arguments + (3), unit 1.

    Accuracy: at most 37.6 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64). Errors are measured against itself.
    """
    arguments = _floats(k, C)
    k, C = arguments
    k_beyond_3 = k - 3.0
    k_beyond_3_squared = k_beyond_3**2
    term_1 = 1.0 / (20.0 + 15.0 * k_beyond_3 + 3.0 * k_beyond_3_squared)
    term_2 = 1.0 / (8.0 + 12.0 * C + 6.0 * k_beyond_3 + k_beyond_3_squared)
    term_3 = 1.0 / (5.0 + 6.0 * k_beyond_3 + 60.0 * C + k_beyond_3_squared)
    product_1 = k_beyond_3 * k_beyond_3_squared
    C_squared = C**2
    sum_1 = (
        160.0
        + 104.0 * C * product_1
        + 167.0 * product_1
        + 1720.0 * C
        + 2056.0 * C * k_beyond_3
        + 240.0 * C_squared * k_beyond_3
        + 3.0 * k_beyond_3 * k_beyond_3_squared**2
        + 36.0 * k_beyond_3_squared**2
        + 374.0 * k_beyond_3_squared
        + 400.0 * k_beyond_3
        + 800.0 * C * k_beyond_3_squared
        + 960.0 * C_squared
    )
    term_4 = np.sqrt(5.0 + k_beyond_3)
    sum_2 = 2.0 + k_beyond_3
    sum_3 = 55.0 + 14.0 * k_beyond_3_squared + 240.0 * C + 69.0 * k_beyond_3
    term_5 = 1.0 / (13.0 + 8.0 * k_beyond_3)
    sum_4 = 1.0 + k_beyond_3
    sum_5 = 52.0 + 120.0 * C + 45.0 * k_beyond_3 + 8.0 * k_beyond_3_squared
    sum_6 = (
        485.0
        + 286.0 * k_beyond_3_squared
        + 38.0 * product_1
        + 480.0 * C * k_beyond_3
        + 658.0 * k_beyond_3
        + 780.0 * C
    )
    result = _empty(arguments, (3,))
    result[..., 0] = 4.0 * (5.0 + 2.0 * k_beyond_3) * C * sum_2 * sum_3 * term_1 * term_2 * term_3 / (1.0 + np.sqrt(sum_1 * term_1 * term_2 * term_3) * term_4)
    result[..., 1] = 12.0 * C * sum_6 * term_2 * term_3 * term_5 / (1.0 + np.sqrt(sum_2 * sum_4 * sum_5 * term_2 * term_3 * term_5) * term_4)
    result[..., 2] = 60.0 * C * term_3 / (1.0 + np.sqrt(sum_4 * term_3) * term_4)
    return result


def degree2_range_gain_of_perfect_rate(*, k: npt.ArrayLike) -> Floats:
    """Part of the standard deviation of the range, of range and two derivatives, that errorless range rates would remove.

    Name: finite_sample.degree2.range_gain_of_perfect_rate.
    Definition: limit of K_r for C to infinity.
    Conditioning: no expectation is taken.
    Source: Gorshkov & Zavizhenets (22).

    Args:
        k: number of scans [1], 3 to 1e+06.

    Returns:
        Shape of the broadcast arguments, unit 1.

    Accuracy: at most 13.6 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 22.1.
    """
    arguments = _floats(k)
    k, = arguments
    term_1 = 1.0 / (2.0 - 3.0 * k + 3.0 * k**2)
    result = _empty(arguments, ())
    result[...] = 4.0 * (2.0 * k - 1.0) * (k - 1.0) * term_1 / ((1.0 + np.sqrt(3.0) * np.sqrt(1.0 + k) * np.sqrt(2.0 + k) * np.sqrt(term_1) / 3.0) * 3.0)
    return result[()]


def degree3_range_design(*, k: npt.ArrayLike, j: npt.ArrayLike, T: npt.ArrayLike) -> Floats:
    """Observations of scan j by range and three derivatives from k scans of range.

    Name: finite_sample.degree3.range.design.
    Definition: H_j.
    Conditioning: no expectation is taken.
    Source: Gorshkov & Zavizhenets (3)-(4).

    Args:
        k: number of scans [1], 1 to 1e+06.
        j: number of the scan that is weighted, 1 the oldest, k the newest [1], 1 to 1e+06.
        T: time from scan to scan [s], 0.001 to 1000.

    Returns:
        Shape of the broadcast arguments + (1, 4), unit [m] × [1/m, s/m, s^2/m, s^3/m].

    Accuracy: at most 6.01 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 8.01.
    """
    arguments = _floats(k, j, T)
    k, j, T = arguments
    sum_1 = j - k
    sum_1_squared = sum_1**2
    T_squared = T**2
    result = _empty(arguments, (1, 4))
    result[..., 0, 0] = 1.0
    result[..., 0, 1] = T * sum_1
    result[..., 0, 2] = 0.5 * T_squared * sum_1_squared
    result[..., 0, 3] = T * T_squared * sum_1 * sum_1_squared / 6.0
    return result


def degree3_range_precision(*, sigma_r: npt.ArrayLike) -> Floats:
    """Inverse variances of the observations of one scan, for range and three derivatives from k scans of range.

    Name: finite_sample.degree3.range.precision.
    Definition: Q_theta.
    Conditioning: no expectation is taken.
    Source: Gorshkov & Zavizhenets (5).

    Args:
        sigma_r: standard deviation of the error of the range [m], 0.001 to 10000.

    Returns:
        Shape of the broadcast arguments + (1, 1), unit 1/m^2.

    Accuracy: at most 3.01 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 3.01.
    """
    arguments = _floats(sigma_r)
    sigma_r, = arguments
    result = _empty(arguments, (1, 1))
    result[..., 0, 0] = 1.0 / sigma_r**2
    return result


def degree3_range_information(*, k: npt.ArrayLike, T: npt.ArrayLike, sigma_r: npt.ArrayLike) -> Floats:
    """Information matrix of range and three derivatives from k scans of range.

    Name: finite_sample.degree3.range.information.
    Definition: Q = sum_j H_j' Q_theta H_j.
    Conditioning: no expectation is taken.
    Source: Gorshkov & Zavizhenets (2), (6).

    Args:
        k: number of scans [1], 1 to 1e+06.
        T: time from scan to scan [s], 0.001 to 1000.
        sigma_r: standard deviation of the error of the range [m], 0.001 to 10000.

    Returns:
        Shape of the broadcast arguments + (4, 4), unit [1/m, s/m, s^2/m, s^3/m] × [1/m, s/m, s^2/m, s^3/m].

    Accuracy: at most 67.4 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64).
    """
    arguments = _floats(k, T, sigma_r)
    k, T, sigma_r = arguments
    term_1 = 1.0 / sigma_r**2
    sum_1 = k - 1.0
    sum_2 = 2.0 * k - 1.0
    T_squared = T**2
    sum_1_squared = sum_1**2
    product_1 = T * T_squared
    k_squared = k**2
    sum_3 = 3.0 * k_squared - 1.0 - 3.0 * k
    T_squared_squared = T_squared**2
    sum_4 = 2.0 * k_squared - 1.0 - 2.0 * k
    sum_5 = 1.0 - 6.0 * k * k_squared + 3.0 * k + 3.0 * k_squared**2
    result = _empty(arguments, (4, 4))
    result[..., 0, 0] = k * term_1
    result[..., 0, 1] = -0.5 * T * k * sum_1 * term_1
    result[..., 0, 2] = T_squared * k * sum_1 * sum_2 * term_1 / 12.0
    result[..., 0, 3] = -k_squared * product_1 * sum_1_squared * term_1 / 24.0
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = T_squared * k * sum_1 * sum_2 * term_1 / 6.0
    result[..., 1, 2] = -0.125 * k_squared * product_1 * sum_1_squared * term_1
    result[..., 1, 3] = T_squared_squared * k * sum_1 * sum_2 * sum_3 * term_1 / 180.0
    result[..., 2, 0] = result[..., 0, 2]
    result[..., 2, 1] = result[..., 1, 2]
    result[..., 2, 2] = T_squared_squared * k * sum_1 * sum_2 * sum_3 * term_1 / 120.0
    result[..., 2, 3] = -T * T_squared**2 * k_squared * sum_1_squared * sum_4 * term_1 / 144.0
    result[..., 3, 0] = result[..., 0, 3]
    result[..., 3, 1] = result[..., 1, 3]
    result[..., 3, 2] = result[..., 2, 3]
    result[..., 3, 3] = T_squared * T_squared**2 * k * sum_1 * sum_2 * sum_5 * term_1 / 1512.0
    return result


def degree3_range_covariance(*, k: npt.ArrayLike, T: npt.ArrayLike, sigma_r: npt.ArrayLike) -> Floats:
    """Error covariance of range and three derivatives from k scans of range, at the newest scan.

    Name: finite_sample.degree3.range.covariance.
    Definition: R = (sum_j H_j' Q_theta H_j)^-1.
    Conditioning: no expectation is taken.
    Source: Gorshkov & Zavizhenets (2), (7)-(12).

    Args:
        k: number of scans [1], 4 to 1e+06.
        T: time from scan to scan [s], 0.001 to 1000.
        sigma_r: standard deviation of the error of the range [m], 0.001 to 10000.

    Returns:
        Shape of the broadcast arguments + (4, 4), unit [m, m/s, m/s^2, m/s^3] × [m, m/s, m/s^2, m/s^3].

    Accuracy: at most 28.4 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64).
    """
    arguments = _floats(k, T, sigma_r)
    k, T, sigma_r = arguments
    sum_1 = k - 1.0
    span = (1.0 + k) * sum_1
    sum_2 = k - 2.0
    bend = (2.0 + k) * sum_2
    middle = 0.5 * k - 0.5
    per_constant = 1.0 / k
    term_1 = per_constant
    term_2 = 1.0 / span
    per_slope = 12.0 * term_1 * term_2
    term_3 = 1.0 / bend
    per_curvature = 180.0 * term_1 * term_2 * term_3
    sum_3 = k - 3.0
    per_cubic = 2800.0 * term_1 * term_2 * term_3 / ((3.0 + k) * sum_3)
    sum_2_squared = sum_2**2
    middle_squared = middle**2
    sigma_r_squared = sigma_r**2
    sum_4 = (
        middle_squared * per_cubic * sum_2_squared * sum_3**2 / 100.0
        + middle_squared * per_slope
        + per_constant
        + per_curvature * sum_1**2 * sum_2_squared / 36.0
    )
    sum_5 = 6.0 * k - 6.0
    sum_6 = 3.0 * k / 10.0 - 1.0 / 10.0 + sum_2 * sum_5 / 10.0
    sum_7 = (
        middle * per_cubic * sum_2 * sum_3 * sum_6 / 10.0
        + middle * per_curvature * sum_1 * sum_2 / 3.0
        + middle * per_slope
    )
    term_4 = 1.0 / T**2
    sum_8 = 3.0 * middle_squared * per_cubic * sum_2 * sum_3 / 5.0 + per_curvature * sum_1 * sum_2 / 3.0
    term_5 = 1.0 / (T * T**2)
    sum_9 = 4.0 * middle_squared * per_curvature + per_cubic * sum_6**2 + per_slope
    sum_10 = 4.0 * middle * per_curvature + 6.0 * middle * per_cubic * sum_6
    term_6 = 1.0 / (T**2)**2
    sum_11 = 3.0 * sum_2 * sum_5 / 5.0 - 3.0 / 5.0 + 9.0 * k / 5.0
    sum_12 = 36.0 * middle_squared * per_cubic + 4.0 * per_curvature
    result = _empty(arguments, (4, 4))
    result[..., 0, 0] = sigma_r_squared * sum_4
    result[..., 0, 1] = sigma_r_squared * sum_7 / T
    result[..., 0, 2] = sigma_r_squared * sum_8 * term_4
    result[..., 0, 3] = 3.0 * middle * per_cubic * sigma_r_squared * sum_2 * sum_3 * term_5 / 5.0
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = sigma_r_squared * sum_9 * term_4
    result[..., 1, 2] = sigma_r_squared * sum_10 * term_5
    result[..., 1, 3] = per_cubic * sigma_r_squared * sum_11 * term_6
    result[..., 2, 0] = result[..., 0, 2]
    result[..., 2, 1] = result[..., 1, 2]
    result[..., 2, 2] = sigma_r_squared * sum_12 * term_6
    result[..., 2, 3] = 36.0 * middle * per_cubic * sigma_r_squared / (T * (T**2)**2)
    result[..., 3, 0] = result[..., 0, 3]
    result[..., 3, 1] = result[..., 1, 3]
    result[..., 3, 2] = result[..., 2, 3]
    result[..., 3, 3] = 36.0 * per_cubic * sigma_r_squared / (T * T**2)**2
    return result


def degree3_range_correlation(*, k: npt.ArrayLike) -> Floats:
    """Correlation of the errors of range and three derivatives from k scans of range, at the newest scan.

    Name: finite_sample.degree3.range.correlation.
    Definition: R_mn / sqrt(R_mm R_nn).
    Conditioning: no expectation is taken.
    Source: Gorshkov & Zavizhenets (10)-(12).

    Args:
        k: number of scans [1], 4 to 1e+06.

    Returns:
        Shape of the broadcast arguments + (4, 4), unit 1.

    Accuracy: at most 20.1 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64).
    """
    arguments = _floats(k)
    k, = arguments
    k_beyond_4 = k - 4.0
    sum_1 = 1.0 + k_beyond_4
    term_1 = 1.0 / sum_1
    sum_2 = 2.0 + k_beyond_4
    term_2 = 1.0 / sum_2
    sum_3 = 3.0 + k_beyond_4
    term_3 = 1.0 / sum_3
    k_beyond_4_squared = k_beyond_4**2
    sum_4 = (
        74200.0
        + 109200.0 * k_beyond_4
        + 1200.0 * k_beyond_4_squared**2
        + 13800.0 * k_beyond_4 * k_beyond_4_squared
        + 58800.0 * k_beyond_4_squared
    )
    sum_5 = 7.0 + 2.0 * k_beyond_4
    sum_6 = 15.0 + 7.0 * k_beyond_4 + k_beyond_4_squared
    sum_7 = 1540.0 + 120.0 * k_beyond_4_squared + 840.0 * k_beyond_4
    sum_8 = 23.0 + 9.0 * k_beyond_4
    term_4 = 1.0 / sum_1**2
    term_5 = 1.0 / sum_2**2
    term_6 = 1.0 / sum_3**2
    sum_9 = 78960.0 + 10080.0 * k_beyond_4_squared + 55440.0 * k_beyond_4
    result = _empty(arguments, (4, 4))
    result[..., 0, 0] = 1.0
    result[..., 0, 1] = 0.25 * np.sqrt(2.0) * sum_7 / np.sqrt(sum_4 * sum_5 * sum_6 * term_1 * term_2 * term_3)
    result[..., 0, 2] = (1680.0 + 480.0 * k_beyond_4) * np.sqrt(5.0) / (np.abs(sum_5) * np.sqrt(sum_6 * sum_8 * term_1 * term_2 * term_3) * 240.0)
    result[..., 0, 3] = 0.25 * np.sqrt(14.0) / np.sqrt(sum_5 * sum_6 * term_1 * term_2 * term_3)
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = 1.0
    result[..., 1, 2] = 5.0 * (10.0 + 3.0 * k_beyond_4) * (7.0 + 3.0 * k_beyond_4) * np.sqrt(10.0) * term_1 * term_2 / np.sqrt(sum_4 * sum_5 * sum_8 * term_4 * term_5 * term_6)
    result[..., 1, 3] = np.sqrt(7.0) * sum_9 * term_1 * term_2 * term_3 / (np.sqrt(sum_4 * term_4 * term_5 * term_6) * 840.0)
    result[..., 2, 0] = result[..., 0, 2]
    result[..., 2, 1] = result[..., 1, 2]
    result[..., 2, 2] = 1.0
    result[..., 2, 3] = 0.5 * np.sqrt(70.0) * term_1 * term_2 / np.sqrt(sum_5 * sum_8 * term_4 * term_5 * term_6)
    result[..., 3, 0] = result[..., 0, 3]
    result[..., 3, 1] = result[..., 1, 3]
    result[..., 3, 2] = result[..., 2, 3]
    result[..., 3, 3] = 1.0
    return result


def degree3_range_range_weights(*, k: npt.ArrayLike, j: npt.ArrayLike, T: npt.ArrayLike) -> Floats:
    """Weights of the range of scan j in the estimate of range and three derivatives from k scans of range, at the newest scan.

    Name: finite_sample.degree3.range.range_weights.
    Definition: W_j = R H_j' Q_theta.
    Conditioning: no expectation is taken.
    Source: Gorshkov & Zavizhenets (13)-(20).

    Args:
        k: number of scans [1], 4 to 1e+06.
        j: number of the scan that is weighted, 1 the oldest, k the newest [1], 1 to 1e+06.
        T: time from scan to scan [s], 0.001 to 1000.

    Returns:
        Shape of the broadcast arguments + (4), unit [1, 1/s, 1/s^2, 1/s^3].

    Accuracy: at most 894 ulp anywhere in this domain, proved for elementary functions within 1 ulp (float64).
    Errors are measured against the weights of this, the first and the last scan and the root mean square of
    all.
    """
    arguments = _floats(k, j, T)
    k, j, T = arguments
    sum_1 = k - 1.0
    span = (1.0 + k) * sum_1
    sum_2 = k - 2.0
    bend = (2.0 + k) * sum_2
    middle = 0.5 * k - 0.5
    scan_position = j - 0.5 - 0.5 * k
    scan_reach = (k - j) * (j - 1.0)
    per_constant = 1.0 / k
    term_1 = per_constant
    term_2 = 1.0 / span
    per_slope = 12.0 * term_1 * term_2
    term_3 = 1.0 / bend
    per_curvature = 180.0 * term_1 * term_2 * term_3
    sum_3 = k - 3.0
    per_cubic = 2800.0 * term_1 * term_2 * term_3 / ((3.0 + k) * sum_3)
    sum_4 = sum_2 * sum_3 / 10.0 - scan_reach
    sum_5 = sum_1 * sum_2 / 6.0 - scan_reach
    sum_6 = 3.0 * k / 10.0 - 1.0 / 10.0 + (6.0 * k - 6.0) * sum_2 / 10.0
    sum_7 = (
        2.0 * middle * per_curvature * sum_5
        + per_cubic * scan_position * sum_4 * sum_6
        + per_slope * scan_position
    )
    sum_8 = sum_1 * sum_2 / 3.0 - 2.0 * scan_reach
    sum_9 = 6.0 * middle * per_cubic * scan_position * sum_4 + per_curvature * sum_8
    result = _empty(arguments, (4,))
    result[..., 0] = (
        middle * per_cubic * scan_position * sum_2 * sum_3 * sum_4 / 10.0
        + middle * per_slope * scan_position
        + per_constant
        + per_curvature * sum_1 * sum_2 * sum_5 / 6.0
    )
    result[..., 1] = sum_7 / T
    result[..., 2] = sum_9 / T**2
    result[..., 3] = 6.0 * per_cubic * scan_position * sum_4 / (T * T**2)
    return result


def degree3_range_at_lag_covariance(
    *,
    k: npt.ArrayLike,
    T: npt.ArrayLike,
    sigma_r: npt.ArrayLike,
    tau: npt.ArrayLike,
) -> Floats:
    """Error covariance of range and three derivatives from k scans of range, tau scans after the newest one.

    Name: finite_sample.degree3.range.at_lag.covariance.
    Definition: R = (sum_j H_j' Q_theta H_j)^-1.
    Conditioning: no expectation is taken.
    Source: Gorshkov & Zavizhenets (2), (7)-(12).

    Args:
        k: number of scans [1], 4 to 1e+06.
        T: time from scan to scan [s], 0.001 to 1000.
        sigma_r: standard deviation of the error of the range [m], 0.001 to 10000.
        tau: scans from the newest one to the time of the estimate, less than 0 to smooth [1], -1e+06 to 1e+06.

    Returns:
        Shape of the broadcast arguments + (4, 4), unit [m, m/s, m/s^2, m/s^3] × [m, m/s, m/s^2, m/s^3].

    Accuracy: measured, not proved: at most 8 ulp from 50-digit arithmetic at 500 points of this domain
    (float64, independent errors).
    """
    arguments = _floats(k, T, sigma_r, tau)
    k, T, sigma_r, tau = arguments
    sum_1 = k - 1.0
    span = (1.0 + k) * sum_1
    sum_2 = k - 2.0
    bend = (2.0 + k) * sum_2
    middle = 0.5 * k - 0.5
    position = middle + tau
    reach = -(k - 1.0 + tau) * tau
    term_1 = (middle**2)**2
    nearness = term_1 / (4.0 * reach**2 + term_1)
    per_constant = 1.0 / k
    term_2 = per_constant
    term_3 = 1.0 / span
    per_slope = 12.0 * term_2 * term_3
    term_4 = 1.0 / bend
    per_curvature = 180.0 * term_2 * term_3 * term_4
    sum_3 = k - 3.0
    per_cubic = 2800.0 * term_2 * term_3 * term_4 / ((3.0 + k) * sum_3)
    sum_4 = sum_2 * sum_3 / 10.0 - reach
    position_squared = position**2
    sum_5 = 1.0 - nearness
    sum_6 = position_squared - span / 12.0
    sum_7 = sum_1 * sum_2 / 6.0 - reach
    sum_8 = nearness * sum_7 + sum_5 * sum_6
    sigma_r_squared = sigma_r**2
    sum_9 = (
        per_constant
        + per_cubic * position_squared * sum_4**2
        + per_curvature * sum_8**2
        + per_slope * position_squared
    )
    sum_10 = 7.0 / 20.0 - 3.0 * k**2 / 20.0 + 3.0 * position_squared
    sum_11 = 3.0 * k / 10.0 - 1.0 / 10.0 - 3.0 * reach + (6.0 * k - 6.0) * sum_2 / 10.0
    sum_12 = nearness * sum_11 + sum_10 * sum_5
    sum_13 = (
        2.0 * per_curvature * position * sum_8
        + per_cubic * position * sum_12 * sum_4
        + per_slope * position
    )
    sum_14 = 2.0 * nearness * sum_7 + 2.0 * sum_5 * sum_6
    term_5 = 1.0 / T**2
    sum_15 = 6.0 * per_cubic * position_squared * sum_4 + per_curvature * sum_14
    term_6 = 1.0 / (T * T**2)
    sum_16 = 4.0 * per_curvature * position_squared + per_cubic * sum_12**2 + per_slope
    sum_17 = 4.0 * per_curvature * position + 6.0 * per_cubic * position * sum_12
    term_7 = 1.0 / (T**2)**2
    sum_18 = 6.0 * nearness * sum_11 + 6.0 * sum_10 * sum_5
    sum_19 = 36.0 * per_cubic * position_squared + 4.0 * per_curvature
    result = _empty(arguments, (4, 4))
    result[..., 0, 0] = sigma_r_squared * sum_9
    result[..., 0, 1] = sigma_r_squared * sum_13 / T
    result[..., 0, 2] = sigma_r_squared * sum_15 * term_5
    result[..., 0, 3] = 6.0 * per_cubic * position * sigma_r_squared * sum_4 * term_6
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = sigma_r_squared * sum_16 * term_5
    result[..., 1, 2] = sigma_r_squared * sum_17 * term_6
    result[..., 1, 3] = per_cubic * sigma_r_squared * sum_18 * term_7
    result[..., 2, 0] = result[..., 0, 2]
    result[..., 2, 1] = result[..., 1, 2]
    result[..., 2, 2] = sigma_r_squared * sum_19 * term_7
    result[..., 2, 3] = 36.0 * per_cubic * position * sigma_r_squared / (T * (T**2)**2)
    result[..., 3, 0] = result[..., 0, 3]
    result[..., 3, 1] = result[..., 1, 3]
    result[..., 3, 2] = result[..., 2, 3]
    result[..., 3, 3] = 36.0 * per_cubic * sigma_r_squared / (T * T**2)**2
    return result


def degree3_range_at_lag_range_weights(
    *,
    k: npt.ArrayLike,
    j: npt.ArrayLike,
    T: npt.ArrayLike,
    tau: npt.ArrayLike,
) -> Floats:
    """Weights of the range of scan j in the estimate of range and three derivatives from k scans of range, tau scans after the newest one.

    Name: finite_sample.degree3.range.at_lag.range_weights.
    Definition: W_j = R H_j' Q_theta.
    Conditioning: no expectation is taken.
    Source: Gorshkov & Zavizhenets (13)-(20).

    Args:
        k: number of scans [1], 4 to 1e+06.
        j: number of the scan that is weighted, 1 the oldest, k the newest [1], 1 to 1e+06.
        T: time from scan to scan [s], 0.001 to 1000.
        tau: scans from the newest one to the time of the estimate, less than 0 to smooth [1], -1e+06 to 1e+06.

    Returns:
        Shape of the broadcast arguments + (4), unit [1, 1/s, 1/s^2, 1/s^3].

    Accuracy: measured, not proved: at most 4 ulp from 50-digit arithmetic at 500 points of this domain
    (float64, independent errors). Errors are measured against the weights of this, the first and the last
    scan and the root mean square of all.
    """
    arguments = _floats(k, j, T, tau)
    k, j, T, tau = arguments
    sum_1 = k - 1.0
    span = (1.0 + k) * sum_1
    sum_2 = k - 2.0
    bend = (2.0 + k) * sum_2
    middle = 0.5 * k - 0.5
    position = middle + tau
    reach = -(k - 1.0 + tau) * tau
    term_1 = (middle**2)**2
    nearness = term_1 / (4.0 * reach**2 + term_1)
    scan_position = j - 0.5 - 0.5 * k
    scan_reach = (k - j) * (j - 1.0)
    per_constant = 1.0 / k
    term_2 = per_constant
    term_3 = 1.0 / span
    per_slope = 12.0 * term_2 * term_3
    term_4 = 1.0 / bend
    per_curvature = 180.0 * term_2 * term_3 * term_4
    sum_3 = k - 3.0
    per_cubic = 2800.0 * term_2 * term_3 * term_4 / ((3.0 + k) * sum_3)
    product_1 = sum_2 * sum_3 / 10.0
    sum_4 = product_1 - scan_reach
    product_2 = sum_1 * sum_2 / 6.0
    sum_5 = product_2 - scan_reach
    sum_6 = 1.0 - nearness
    position_squared = position**2
    sum_7 = nearness * (product_2 - reach) + (position_squared - span / 12.0) * sum_6
    sum_8 = 7.0 / 20.0 - 3.0 * k**2 / 20.0 + 3.0 * position_squared
    sum_9 = 3.0 * k / 10.0 - 1.0 / 10.0 - 3.0 * reach + (6.0 * k - 6.0) * sum_2 / 10.0
    sum_10 = nearness * sum_9 + sum_6 * sum_8
    sum_11 = (
        2.0 * per_curvature * position * sum_5
        + per_cubic * scan_position * sum_10 * sum_4
        + per_slope * scan_position
    )
    sum_12 = sum_1 * sum_2 / 3.0 - 2.0 * scan_reach
    sum_13 = 6.0 * per_cubic * position * scan_position * sum_4 + per_curvature * sum_12
    result = _empty(arguments, (4,))
    result[..., 0] = (
        per_constant
        + per_cubic * position * (product_1 - reach) * scan_position * sum_4
        + per_curvature * sum_5 * sum_7
        + per_slope * position * scan_position
    )
    result[..., 1] = sum_11 / T
    result[..., 2] = sum_13 / T**2
    result[..., 3] = 6.0 * per_cubic * scan_position * sum_4 / (T * T**2)
    return result


def degree3_range_rate_design(*, k: npt.ArrayLike, j: npt.ArrayLike, T: npt.ArrayLike) -> Floats:
    """Observations of scan j by range and three derivatives from k scans of range and range rate (where C > 0, k from 2 on).

    Name: finite_sample.degree3.range_rate.design.
    Definition: H_j.
    Conditioning: no expectation is taken.
    Source: Gorshkov & Zavizhenets (3)-(4).

    Args:
        k: number of scans [1], 1 to 1e+06.
        j: number of the scan that is weighted, 1 the oldest, k the newest [1], 1 to 1e+06.
        T: time from scan to scan [s], 0.001 to 1000.

    Returns:
        Shape of the broadcast arguments + (2, 4), unit [m, m/s] × [1/m, s/m, s^2/m, s^3/m].

    Accuracy: at most 6.01 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 8.01.
    """
    arguments = _floats(k, j, T)
    k, j, T = arguments
    sum_1 = j - k
    sum_1_squared = sum_1**2
    T_squared = T**2
    result = _empty(arguments, (2, 4))
    result[..., 0, 0] = 1.0
    result[..., 0, 1] = T * sum_1
    result[..., 0, 2] = 0.5 * T_squared * sum_1_squared
    result[..., 0, 3] = T * T_squared * sum_1 * sum_1_squared / 6.0
    result[..., 1, 0] = 0.0
    result[..., 1, 1] = 1.0
    result[..., 1, 2] = result[..., 0, 1]
    result[..., 1, 3] = result[..., 0, 2]
    return result


def degree3_range_rate_precision(*, sigma_r: npt.ArrayLike, T: npt.ArrayLike, C: npt.ArrayLike) -> Floats:
    """Inverse variances of the observations of one scan, for range and three derivatives from k scans of range and range rate (where C > 0, k from 2 on).

    Name: finite_sample.degree3.range_rate.precision.
    Definition: Q_theta.
    Conditioning: no expectation is taken.
    Source: Gorshkov & Zavizhenets (5).

    Args:
        sigma_r: standard deviation of the error of the range [m], 0.001 to 10000.
        T: time from scan to scan [s], 0.001 to 1000.
        C: sigma_r^2/(T^2 sigma_v^2), the weight of the range rate [1], 0 to 1e+12.

    Returns:
        Shape of the broadcast arguments + (2, 2), unit [1/m, s/m] × [1/m, s/m].

    Accuracy: at most 7.01 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 7.01.
    """
    arguments = _floats(sigma_r, T, C)
    sigma_r, T, C = arguments
    term_1 = 1.0 / sigma_r**2
    result = _empty(arguments, (2, 2))
    result[..., 0, 0] = term_1
    result[..., 0, 1] = 0.0
    result[..., 1, 0] = 0.0
    result[..., 1, 1] = C * T**2 * term_1
    return result


def degree3_range_rate_information(
    *,
    k: npt.ArrayLike,
    T: npt.ArrayLike,
    sigma_r: npt.ArrayLike,
    C: npt.ArrayLike,
) -> Floats:
    """Information matrix of range and three derivatives from k scans of range and range rate (where C > 0, k from 2 on).

    Name: finite_sample.degree3.range_rate.information.
    Definition: Q = sum_j H_j' Q_theta H_j.
    Conditioning: no expectation is taken.
    Source: Gorshkov & Zavizhenets (2), (6).

    Args:
        k: number of scans [1], 1 to 1e+06.
        T: time from scan to scan [s], 0.001 to 1000.
        sigma_r: standard deviation of the error of the range [m], 0.001 to 10000.
        C: sigma_r^2/(T^2 sigma_v^2), the weight of the range rate [1], 0 to 1e+12.

    Returns:
        Shape of the broadcast arguments + (4, 4), unit [1/m, s/m, s^2/m, s^3/m] × [1/m, s/m, s^2/m, s^3/m].

    Accuracy: at most 57 ulp anywhere in this domain, proved for elementary functions within 1 ulp (float64).
    """
    arguments = _floats(k, T, sigma_r, C)
    k, T, sigma_r, C = arguments
    term_1 = 1.0 / sigma_r**2
    sum_1 = k - 1.0
    sum_2 = 2.0 * k - 1.0
    T_squared = T**2
    sum_1_squared = sum_1**2
    product_1 = T * T_squared
    k_squared = k**2
    sum_3 = 1.0 - 3.0 * k + 2.0 * k_squared + 6.0 * C
    T_squared_squared = T_squared**2
    sum_4 = 15.0 * C - 1.0 - 3.0 * k + 3.0 * k_squared
    sum_5 = 20.0 * C - 1.0 - 3.0 * k + 3.0 * k_squared
    sum_6 = 18.0 * C - 1.0 - 2.0 * k + 2.0 * k_squared
    sum_7 = (
        5.0
        - 189.0 * C * k
        - 30.0 * k * k_squared
        - 63.0 * C
        + 15.0 * k
        + 15.0 * k_squared**2
        + 189.0 * C * k_squared
    )
    result = _empty(arguments, (4, 4))
    result[..., 0, 0] = k * term_1
    result[..., 0, 1] = -0.5 * T * k * sum_1 * term_1
    result[..., 0, 2] = T_squared * k * sum_1 * sum_2 * term_1 / 12.0
    result[..., 0, 3] = -k_squared * product_1 * sum_1_squared * term_1 / 24.0
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = T_squared * k * sum_3 * term_1 / 6.0
    result[..., 1, 2] = -0.125 * k * (4.0 * C - k + k_squared) * product_1 * sum_1 * term_1
    result[..., 1, 3] = T_squared_squared * k * sum_1 * sum_2 * sum_4 * term_1 / 180.0
    result[..., 2, 0] = result[..., 0, 2]
    result[..., 2, 1] = result[..., 1, 2]
    result[..., 2, 2] = T_squared_squared * k * sum_1 * sum_2 * sum_5 * term_1 / 120.0
    result[..., 2, 3] = -T * T_squared**2 * k_squared * sum_1_squared * sum_6 * term_1 / 144.0
    result[..., 3, 0] = result[..., 0, 3]
    result[..., 3, 1] = result[..., 1, 3]
    result[..., 3, 2] = result[..., 2, 3]
    result[..., 3, 3] = T_squared * T_squared**2 * k * sum_1 * sum_2 * sum_7 * term_1 / 7560.0
    return result


def degree3_range_rate_covariance(
    *,
    k: npt.ArrayLike,
    T: npt.ArrayLike,
    sigma_r: npt.ArrayLike,
    C: npt.ArrayLike,
) -> Floats:
    """Error covariance of range and three derivatives from k scans of range and range rate (where C > 0, k from 2 on), at the newest scan.

    Name: finite_sample.degree3.range_rate.covariance.
    Definition: R = (sum_j H_j' Q_theta H_j)^-1.
    Conditioning: no expectation is taken.
    Source: Gorshkov & Zavizhenets (2), (7)-(12).

    Args:
        k: number of scans [1], 4 to 1e+06.
        T: time from scan to scan [s], 0.001 to 1000.
        sigma_r: standard deviation of the error of the range [m], 0.001 to 10000.
        C: sigma_r^2/(T^2 sigma_v^2), the weight of the range rate [1], 0 to 1e+12.

    Returns:
        Shape of the broadcast arguments + (4, 4), unit [m, m/s, m/s^2, m/s^3] × [m, m/s, m/s^2, m/s^3].

    Accuracy: measured, not proved: at most 6.5 ulp from 50-digit arithmetic at 500 points of this domain
    (float64, independent errors).
    """
    arguments = _floats(k, T, sigma_r, C)
    k, T, sigma_r, C = arguments
    sum_1 = k - 1.0
    span = (1.0 + k) * sum_1
    sum_2 = k - 2.0
    bend = (2.0 + k) * sum_2
    term_1 = 1.0 / (12.0 * C + span)
    range_share = span * term_1
    rate_share = 12.0 * C * term_1
    middle = 0.5 * k - 0.5
    per_constant = 1.0 / k
    term_2 = per_constant
    per_slope = 12.0 * term_1 * term_2
    term_3 = 1.0 / span
    per_curvature = 180.0 * term_2 * term_3 / (60.0 * C + bend)
    sum_3 = k - 3.0
    per_cubic = term_2 * term_3 / (C * bend / 20.0 + bend * (3.0 + k) * sum_3 / 2800.0 + (1.0 + k**2)**2 * rate_share / 1200.0)
    sum_4 = range_share * sum_2 * sum_3 / 10.0 + (0.5 - 0.5 * k) * rate_share
    middle_squared = middle**2
    sigma_r_squared = sigma_r**2
    sum_5 = (
        middle_squared * per_cubic * sum_4**2
        + middle_squared * per_slope
        + per_constant
        + per_curvature * sum_1**2 * sum_2**2 / 36.0
    )
    sum_6 = 3.0 * k / 10.0 - 1.0 / 10.0 + (6.0 * k - 6.0) * sum_2 / 10.0
    sum_7 = range_share * sum_6 + 0.5 * rate_share * sum_1 * sum_2
    sum_8 = (
        middle * per_cubic * sum_4 * sum_7
        + middle * per_curvature * sum_1 * sum_2 / 3.0
        + middle * per_slope
    )
    term_4 = 1.0 / T**2
    sum_9 = 6.0 * middle_squared * per_cubic * sum_4 + per_curvature * sum_1 * sum_2 / 3.0
    term_5 = 1.0 / (T * T**2)
    sum_10 = 4.0 * middle_squared * per_curvature + per_cubic * sum_7**2 + per_slope
    sum_11 = 4.0 * middle * per_curvature + 6.0 * middle * per_cubic * sum_7
    term_6 = 1.0 / (T**2)**2
    sum_12 = 3.0 * rate_share * sum_1 * sum_2 + 6.0 * range_share * sum_6
    sum_13 = 36.0 * middle_squared * per_cubic + 4.0 * per_curvature
    result = _empty(arguments, (4, 4))
    result[..., 0, 0] = sigma_r_squared * sum_5
    result[..., 0, 1] = sigma_r_squared * sum_8 / T
    result[..., 0, 2] = sigma_r_squared * sum_9 * term_4
    result[..., 0, 3] = 6.0 * middle * per_cubic * sigma_r_squared * sum_4 * term_5
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = sigma_r_squared * sum_10 * term_4
    result[..., 1, 2] = sigma_r_squared * sum_11 * term_5
    result[..., 1, 3] = per_cubic * sigma_r_squared * sum_12 * term_6
    result[..., 2, 0] = result[..., 0, 2]
    result[..., 2, 1] = result[..., 1, 2]
    result[..., 2, 2] = sigma_r_squared * sum_13 * term_6
    result[..., 2, 3] = 36.0 * middle * per_cubic * sigma_r_squared / (T * (T**2)**2)
    result[..., 3, 0] = result[..., 0, 3]
    result[..., 3, 1] = result[..., 1, 3]
    result[..., 3, 2] = result[..., 2, 3]
    result[..., 3, 3] = 36.0 * per_cubic * sigma_r_squared / (T * T**2)**2
    return result


def degree3_range_rate_correlation(*, k: npt.ArrayLike, C: npt.ArrayLike) -> Floats:
    """Correlation of the errors of range and three derivatives from k scans of range and range rate (where C > 0, k from 2 on), at the newest scan.

    Name: finite_sample.degree3.range_rate.correlation.
    Definition: R_mn / sqrt(R_mm R_nn).
    Conditioning: no expectation is taken.
    Source: Gorshkov & Zavizhenets (10)-(12).

    Args:
        k: number of scans [1], 4 to 1e+06.
        C: sigma_r^2/(T^2 sigma_v^2), the weight of the range rate [1], 0 to 1e+12.

    Returns:
        Shape of the broadcast arguments + (4, 4), unit 1.

    Accuracy: measured, not proved: at most 1.5 ulp from 50-digit arithmetic at 500 points of this domain
    (float64, independent errors).
    """
    arguments = _floats(k, C)
    k, C = arguments
    k_beyond_4 = k - 4.0
    k_beyond_4_squared = k_beyond_4**2
    sum_1 = 12.0 + 60.0 * C + 8.0 * k_beyond_4 + k_beyond_4_squared
    term_1 = 1.0 / sum_1
    product_1 = k_beyond_4 * k_beyond_4_squared
    C_squared = C**2
    k_beyond_4_squared_squared = k_beyond_4_squared**2
    product_2 = k_beyond_4 * k_beyond_4_squared**2
    k_beyond_4_squared_cubed = k_beyond_4_squared * k_beyond_4_squared**2
    sum_2 = (
        1260.0
        + 1056.0 * product_1
        + 13440.0 * C_squared * k_beyond_4
        + 16480.0 * C * k_beyond_4_squared
        + 1680.0 * C_squared * k_beyond_4_squared
        + 180.0 * C * k_beyond_4_squared_squared
        + 20160.0 * C_squared
        + 226.0 * k_beyond_4_squared_squared
        + 24.0 * product_2
        + 2545.0 * k_beyond_4_squared
        + 2880.0 * C * product_1
        + 2952.0 * k_beyond_4
        + 34300.0 * C
        + 39680.0 * C * k_beyond_4
        + k_beyond_4_squared_cubed
    )
    term_2 = 1.0 / sum_2
    term_3 = 1.0 / sum_1**2
    term_4 = 1.0 / sum_2**2
    product_3 = k_beyond_4 * k_beyond_4_squared * k_beyond_4_squared**2
    sum_3 = (
        4452000.0
        + 10171000.0 * k_beyond_4_squared
        + 103680.0 * C * product_2
        + 10410400.0 * k_beyond_4
        + 11730240.0 * C * product_1
        + 1200.0 * product_3
        + 1663200.0 * k_beyond_4_squared_squared
        + 1759680.0 * C * k_beyond_4_squared_squared
        + 22982400.0 * C_squared
        + 24192000.0 * C_squared * k_beyond_4
        + 29400.0 * k_beyond_4_squared_cubed
        + 300600.0 * product_2
        + 38489760.0 * C * k_beyond_4_squared
        + 39799200.0 * C
        + 5379400.0 * product_1
        + 62250720.0 * C * k_beyond_4
        + 8164800.0 * C_squared * k_beyond_4_squared
        + 907200.0 * C_squared * product_1
    )
    product_4 = C * C_squared
    sum_4 = (
        302400.0
        + 100800.0 * product_1 * product_4
        + 1044000.0 * k_beyond_4
        + 1245016.0 * product_1
        + 1310400.0 * k_beyond_4_squared * product_4
        + 1523184.0 * k_beyond_4_squared
        + 16.0 * k_beyond_4 * (k_beyond_4_squared**2)**2
        + 18379320.0 * C * k_beyond_4_squared
        + 19485120.0 * C * k_beyond_4
        + 208760.0 * product_2
        + 2160.0 * C * product_3
        + 23724960.0 * C_squared * k_beyond_4_squared
        + 2860320.0 * C * k_beyond_4_squared_squared
        + 29719200.0 * C_squared
        + 42503520.0 * C_squared * k_beyond_4
        + 44872.0 * k_beyond_4_squared_cubed
        + 46080.0 * C_squared * product_2
        + 472.0 * (k_beyond_4_squared**2)**2
        + 51000.0 * C * k_beyond_4_squared_cubed
        + 514200.0 * C * product_2
        + 5241600.0 * k_beyond_4 * product_4
        + 6048000.0 * product_4
        + 6080.0 * product_3
        + 632944.0 * k_beyond_4_squared_squared
        + 6469440.0 * C_squared * product_1
        + 8652000.0 * C
        + 866880.0 * C_squared * k_beyond_4_squared_squared
        + 9437160.0 * C * product_1
    )
    sum_5 = 3.0 + k_beyond_4
    sum_6 = (
        4620.0
        + 10069.0 * k_beyond_4_squared
        + 1055.0 * k_beyond_4_squared_squared
        + 11144.0 * k_beyond_4
        + 126.0 * product_2
        + 35280.0 * C_squared * k_beyond_4
        + 41670.0 * C * k_beyond_4_squared
        + 4480.0 * product_1
        + 5040.0 * C_squared * k_beyond_4_squared
        + 582.0 * C * k_beyond_4_squared_squared
        + 6.0 * k_beyond_4_squared_cubed
        + 68040.0 * C_squared
        + 72660.0 * C
        + 8148.0 * C * product_1
        + 92064.0 * C * k_beyond_4
    )
    term_5 = 1.0 / sum_5
    sum_7 = (
        41731200.0
        + 118540800.0 * C_squared * k_beyond_4
        + 141595200.0 * C * k_beyond_4_squared
        + 177811200.0 * C_squared
        + 19353600.0 * C_squared * k_beyond_4_squared
        + 1944000.0 * C * k_beyond_4_squared_squared
        + 23591520.0 * product_1
        + 25920.0 * k_beyond_4_squared_cubed
        + 261475200.0 * C
        + 27475200.0 * C * product_1
        + 317059200.0 * C * k_beyond_4
        + 5101920.0 * k_beyond_4_squared_squared
        + 571680.0 * product_2
        + 59666400.0 * k_beyond_4_squared
        + 78330240.0 * k_beyond_4
    )
    k_squared = k**2
    product_5 = k * k_squared
    k_squared_squared = k_squared**2
    product_6 = k * k_squared**2
    sum_8 = (
        100800.0 * C_squared * product_5
        - 5760.0
        - 1713600.0 * C_squared * k_squared
        - 18480.0 * product_5
        - 198000.0 * C * k_squared_squared
        - 2640.0 * k_squared * k_squared**2
        - 3360.0 * k_squared
        - 417600.0 * C * k
        - 705600.0 * C_squared
        + 11760.0 * k_squared_squared
        + 129600.0 * C
        + 16320.0 * k
        + 1680.0 * product_6
        + 171600.0 * C * k_squared
        + 254400.0 * C * product_5
        + 2620800.0 * C_squared * k
        + 36000.0 * C * product_6
        + 480.0 * k * k_squared * k_squared**2
    )
    sum_9 = 1512000.0 + 100800.0 * k_beyond_4_squared + 1209600.0 * C + 806400.0 * k_beyond_4
    sum_10 = 6.0 - 4.0 * k_squared - 60.0 * C + k + product_5
    sum_11 = (
        7560000.0
        + 1023000.0 * k_beyond_4_squared_squared
        + 11403600.0 * k_beyond_4_squared
        + 117000.0 * product_2
        + 14580000.0 * k_beyond_4
        + 19958400.0 * C_squared * k_beyond_4
        + 25401600.0 * C_squared
        + 29066400.0 * C * k_beyond_4_squared
        + 3628800.0 * C_squared * k_beyond_4_squared
        + 417600.0 * C * k_beyond_4_squared_squared
        + 4623000.0 * product_1
        + 51508800.0 * C
        + 5400.0 * k_beyond_4_squared_cubed
        + 5774400.0 * C * product_1
        + 63626400.0 * C * k_beyond_4
    )
    sum_12 = (
        394800.0
        + 10080.0 * product_1
        + 100800.0 * C * k_beyond_4
        + 105840.0 * k_beyond_4_squared
        + 201600.0 * C
        + 356160.0 * k_beyond_4
    )
    sum_13 = 756000.0 + 403200.0 * k_beyond_4 + 50400.0 * k_beyond_4_squared + 604800.0 * C
    result = _empty(arguments, (4, 4))
    result[..., 0, 0] = 1.0
    result[..., 0, 1] = 20.0 * (2.0 + k_beyond_4) * sum_5 * sum_6 * term_1 * term_2 / np.sqrt(sum_3 * sum_4 * term_3 * term_4)
    result[..., 0, 2] = sum_8 * term_1 * term_2 / np.sqrt(sum_4 * sum_7 * term_3 * term_4 * term_5)
    result[..., 0, 3] = 840.0 * sum_10 * sum_5 * term_2 / np.sqrt(sum_4 * sum_9 * term_1 * term_4 * term_5)
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = 1.0
    result[..., 1, 2] = sum_11 * term_1 * term_2 / np.sqrt(sum_3 * sum_7 * term_3 * term_4 * term_5)
    result[..., 1, 3] = sum_12 * term_2 / np.sqrt(sum_3 * sum_9 * term_1 * term_4 * term_5)
    result[..., 2, 0] = result[..., 0, 2]
    result[..., 2, 1] = result[..., 1, 2]
    result[..., 2, 2] = 1.0
    result[..., 2, 3] = sum_13 * term_2 / np.sqrt(sum_7 * sum_9 * term_1 * term_4 / sum_5**2)
    result[..., 3, 0] = result[..., 0, 3]
    result[..., 3, 1] = result[..., 1, 3]
    result[..., 3, 2] = result[..., 2, 3]
    result[..., 3, 3] = 1.0
    return result


def degree3_range_rate_range_weights(
    *,
    k: npt.ArrayLike,
    j: npt.ArrayLike,
    T: npt.ArrayLike,
    C: npt.ArrayLike,
) -> Floats:
    """Weights of the range of scan j in the estimate of range and three derivatives from k scans of range and range rate (where C > 0, k from 2 on), at the newest scan.

    Name: finite_sample.degree3.range_rate.range_weights.
    Definition: W_j = R H_j' Q_theta.
    Conditioning: no expectation is taken.
    Source: Gorshkov & Zavizhenets (13)-(20).

    Args:
        k: number of scans [1], 4 to 1e+06.
        j: number of the scan that is weighted, 1 the oldest, k the newest [1], 1 to 1e+06.
        T: time from scan to scan [s], 0.001 to 1000.
        C: sigma_r^2/(T^2 sigma_v^2), the weight of the range rate [1], 0 to 1e+12.

    Returns:
        Shape of the broadcast arguments + (4), unit [1, 1/s, 1/s^2, 1/s^3].

    Accuracy: measured, not proved: at most 6.5 ulp from 50-digit arithmetic at 500 points of this domain
    (float64, independent errors). Errors are measured against the weights of this, the first and the last
    scan and the root mean square of all.
    """
    arguments = _floats(k, j, T, C)
    k, j, T, C = arguments
    sum_1 = k - 1.0
    span = (1.0 + k) * sum_1
    sum_2 = k - 2.0
    bend = (2.0 + k) * sum_2
    term_1 = 1.0 / (12.0 * C + span)
    range_share = span * term_1
    rate_share = 12.0 * C * term_1
    middle = 0.5 * k - 0.5
    scan_position = j - 0.5 - 0.5 * k
    scan_reach = (k - j) * (j - 1.0)
    per_constant = 1.0 / k
    term_2 = per_constant
    per_slope = 12.0 * term_1 * term_2
    term_3 = 1.0 / span
    per_curvature = 180.0 * term_2 * term_3 / (60.0 * C + bend)
    sum_3 = k - 3.0
    per_cubic = term_2 * term_3 / (C * bend / 20.0 + bend * (3.0 + k) * sum_3 / 2800.0 + (1.0 + k**2)**2 * rate_share / 1200.0)
    product_1 = range_share * sum_2 * sum_3 / 10.0
    product_2 = (0.5 - 0.5 * k) * rate_share
    sum_4 = product_1 - scan_reach + product_2
    sum_5 = sum_1 * sum_2 / 6.0 - scan_reach
    sum_6 = 3.0 * k / 10.0 - 1.0 / 10.0 + (6.0 * k - 6.0) * sum_2 / 10.0
    sum_7 = range_share * sum_6 + 0.5 * rate_share * sum_1 * sum_2
    sum_8 = (
        2.0 * middle * per_curvature * sum_5
        + per_cubic * scan_position * sum_4 * sum_7
        + per_slope * scan_position
    )
    sum_9 = sum_1 * sum_2 / 3.0 - 2.0 * scan_reach
    sum_10 = 6.0 * middle * per_cubic * scan_position * sum_4 + per_curvature * sum_9
    result = _empty(arguments, (4,))
    result[..., 0] = (
        middle * per_cubic * (product_1 + product_2) * scan_position * sum_4
        + middle * per_slope * scan_position
        + per_constant
        + per_curvature * sum_1 * sum_2 * sum_5 / 6.0
    )
    result[..., 1] = sum_8 / T
    result[..., 2] = sum_10 / T**2
    result[..., 3] = 6.0 * per_cubic * scan_position * sum_4 / (T * T**2)
    return result


def degree3_range_rate_rate_weights(
    *,
    k: npt.ArrayLike,
    j: npt.ArrayLike,
    T: npt.ArrayLike,
    C: npt.ArrayLike,
) -> Floats:
    """Weights of the rate of scan j in the estimate of range and three derivatives from k scans of range and range rate (where C > 0, k from 2 on), at the newest scan.

    Name: finite_sample.degree3.range_rate.rate_weights.
    Definition: W_j = R H_j' Q_theta.
    Conditioning: no expectation is taken.
    Source: Gorshkov & Zavizhenets (13)-(20).

    Args:
        k: number of scans [1], 4 to 1e+06.
        j: number of the scan that is weighted, 1 the oldest, k the newest [1], 1 to 1e+06.
        T: time from scan to scan [s], 0.001 to 1000.
        C: sigma_r^2/(T^2 sigma_v^2), the weight of the range rate [1], 0 to 1e+12.

    Returns:
        Shape of the broadcast arguments + (4), unit [s, 1, 1/s, 1/s^2].

    Accuracy: measured, not proved: at most 8.5 ulp from 50-digit arithmetic at 500 points of this domain
    (float64, independent errors). Errors are measured against the weights of this, the first and the last
    scan and the root mean square of all.
    """
    arguments = _floats(k, j, T, C)
    k, j, T, C = arguments
    sum_1 = k - 1.0
    span = (1.0 + k) * sum_1
    sum_2 = k - 2.0
    bend = (2.0 + k) * sum_2
    term_1 = 1.0 / (12.0 * C + span)
    range_share = span * term_1
    rate_share = 12.0 * C * term_1
    middle = 0.5 * k - 0.5
    scan_position = j - 0.5 - 0.5 * k
    scan_reach = (k - j) * (j - 1.0)
    term_2 = 1.0 / k
    per_slope = 12.0 * term_1 * term_2
    term_3 = 1.0 / span
    per_curvature = 180.0 * term_2 * term_3 / (60.0 * C + bend)
    sum_3 = k - 3.0
    per_cubic = term_2 * term_3 / (C * bend / 20.0 + bend * (3.0 + k) * sum_3 / 2800.0 + (1.0 + k**2)**2 * rate_share / 1200.0)
    sum_4 = 3.0 * k / 10.0 - 1.0 / 10.0 + (6.0 * k - 6.0) * sum_2 / 10.0
    product_1 = range_share * sum_4
    product_2 = 0.5 * rate_share * sum_1 * sum_2
    sum_5 = product_1 - 3.0 * scan_reach + product_2
    sum_6 = range_share * sum_2 * sum_3 / 10.0 + (0.5 - 0.5 * k) * rate_share
    sum_7 = (
        middle * per_cubic * sum_5 * sum_6
        + middle * per_slope
        + per_curvature * scan_position * sum_1 * sum_2 / 3.0
    )
    sum_8 = (
        4.0 * middle * per_curvature * scan_position
        + per_cubic * (product_1 + product_2) * sum_5
        + per_slope
    )
    sum_9 = 4.0 * per_curvature * scan_position + 6.0 * middle * per_cubic * sum_5
    sum_10 = 3.0 * rate_share * sum_1 * sum_2 - 18.0 * scan_reach + 6.0 * range_share * sum_4
    result = _empty(arguments, (4,))
    result[..., 0] = C * T * sum_7
    result[..., 1] = C * sum_8
    result[..., 2] = C * sum_9 / T
    result[..., 3] = C * per_cubic * sum_10 / T**2
    return result


def degree3_range_rate_at_lag_covariance(
    *,
    k: npt.ArrayLike,
    T: npt.ArrayLike,
    sigma_r: npt.ArrayLike,
    C: npt.ArrayLike,
    tau: npt.ArrayLike,
) -> Floats:
    """Error covariance of range and three derivatives from k scans of range and range rate (where C > 0, k from 2 on), tau scans after the newest one.

    Name: finite_sample.degree3.range_rate.at_lag.covariance.
    Definition: R = (sum_j H_j' Q_theta H_j)^-1.
    Conditioning: no expectation is taken.
    Source: Gorshkov & Zavizhenets (2), (7)-(12).

    Args:
        k: number of scans [1], 4 to 1e+06.
        T: time from scan to scan [s], 0.001 to 1000.
        sigma_r: standard deviation of the error of the range [m], 0.001 to 10000.
        C: sigma_r^2/(T^2 sigma_v^2), the weight of the range rate [1], 0 to 1e+12.
        tau: scans from the newest one to the time of the estimate, less than 0 to smooth [1], -1e+06 to 1e+06.

    Returns:
        Shape of the broadcast arguments + (4, 4), unit [m, m/s, m/s^2, m/s^3] × [m, m/s, m/s^2, m/s^3].

    Accuracy: measured, not proved: at most 6.5 ulp from 50-digit arithmetic at 500 points of this domain
    (float64, independent errors).
    """
    arguments = _floats(k, T, sigma_r, C, tau)
    k, T, sigma_r, C, tau = arguments
    sum_1 = k - 1.0
    span = (1.0 + k) * sum_1
    sum_2 = k - 2.0
    bend = (2.0 + k) * sum_2
    term_1 = 1.0 / (12.0 * C + span)
    range_share = span * term_1
    rate_share = 12.0 * C * term_1
    middle = 0.5 * k - 0.5
    position = middle + tau
    reach = -(k - 1.0 + tau) * tau
    term_2 = (middle**2)**2
    nearness = term_2 / (4.0 * reach**2 + term_2)
    per_constant = 1.0 / k
    term_3 = per_constant
    per_slope = 12.0 * term_1 * term_3
    term_4 = 1.0 / span
    per_curvature = 180.0 * term_3 * term_4 / (60.0 * C + bend)
    sum_3 = k - 3.0
    k_squared = k**2
    per_cubic = term_3 * term_4 / (C * bend / 20.0 + bend * (3.0 + k) * sum_3 / 2800.0 + (1.0 + k_squared)**2 * rate_share / 1200.0)
    sum_4 = range_share * sum_2 * sum_3 / 10.0 - reach + (0.5 - 0.5 * k) * rate_share
    position_squared = position**2
    sum_5 = 1.0 - nearness
    sum_6 = position_squared - span / 12.0
    sum_7 = sum_1 * sum_2 / 6.0 - reach
    sum_8 = nearness * sum_7 + sum_5 * sum_6
    sigma_r_squared = sigma_r**2
    sum_9 = (
        per_constant
        + per_cubic * position_squared * sum_4**2
        + per_curvature * sum_8**2
        + per_slope * position_squared
    )
    sum_10 = 3.0 * k_squared / 20.0 - 7.0 / 20.0
    sum_11 = 3.0 * position_squared - range_share * sum_10 - 0.25 * rate_share * span
    sum_12 = 3.0 * k / 10.0 - 1.0 / 10.0 + (6.0 * k - 6.0) * sum_2 / 10.0
    sum_13 = range_share * sum_12 - 3.0 * reach + 0.5 * rate_share * sum_1 * sum_2
    sum_14 = nearness * sum_13 + sum_11 * sum_5
    sum_15 = (
        2.0 * per_curvature * position * sum_8
        + per_cubic * position * sum_14 * sum_4
        + per_slope * position
    )
    sum_16 = 2.0 * nearness * sum_7 + 2.0 * sum_5 * sum_6
    term_5 = 1.0 / T**2
    sum_17 = 6.0 * per_cubic * position_squared * sum_4 + per_curvature * sum_16
    term_6 = 1.0 / (T * T**2)
    sum_18 = 4.0 * per_curvature * position_squared + per_cubic * sum_14**2 + per_slope
    sum_19 = 4.0 * per_curvature * position + 6.0 * per_cubic * position * sum_14
    term_7 = 1.0 / (T**2)**2
    sum_20 = 6.0 * nearness * sum_13 + 6.0 * sum_11 * sum_5
    sum_21 = 36.0 * per_cubic * position_squared + 4.0 * per_curvature
    result = _empty(arguments, (4, 4))
    result[..., 0, 0] = sigma_r_squared * sum_9
    result[..., 0, 1] = sigma_r_squared * sum_15 / T
    result[..., 0, 2] = sigma_r_squared * sum_17 * term_5
    result[..., 0, 3] = 6.0 * per_cubic * position * sigma_r_squared * sum_4 * term_6
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = sigma_r_squared * sum_18 * term_5
    result[..., 1, 2] = sigma_r_squared * sum_19 * term_6
    result[..., 1, 3] = per_cubic * sigma_r_squared * sum_20 * term_7
    result[..., 2, 0] = result[..., 0, 2]
    result[..., 2, 1] = result[..., 1, 2]
    result[..., 2, 2] = sigma_r_squared * sum_21 * term_7
    result[..., 2, 3] = 36.0 * per_cubic * position * sigma_r_squared / (T * (T**2)**2)
    result[..., 3, 0] = result[..., 0, 3]
    result[..., 3, 1] = result[..., 1, 3]
    result[..., 3, 2] = result[..., 2, 3]
    result[..., 3, 3] = 36.0 * per_cubic * sigma_r_squared / (T * T**2)**2
    return result


def degree3_range_rate_at_lag_range_weights(
    *,
    k: npt.ArrayLike,
    j: npt.ArrayLike,
    T: npt.ArrayLike,
    C: npt.ArrayLike,
    tau: npt.ArrayLike,
) -> Floats:
    """Weights of the range of scan j in the estimate of range and three derivatives from k scans of range and range rate (where C > 0, k from 2 on), tau scans after the newest one.

    Name: finite_sample.degree3.range_rate.at_lag.range_weights.
    Definition: W_j = R H_j' Q_theta.
    Conditioning: no expectation is taken.
    Source: Gorshkov & Zavizhenets (13)-(20).

    Args:
        k: number of scans [1], 4 to 1e+06.
        j: number of the scan that is weighted, 1 the oldest, k the newest [1], 1 to 1e+06.
        T: time from scan to scan [s], 0.001 to 1000.
        C: sigma_r^2/(T^2 sigma_v^2), the weight of the range rate [1], 0 to 1e+12.
        tau: scans from the newest one to the time of the estimate, less than 0 to smooth [1], -1e+06 to 1e+06.

    Returns:
        Shape of the broadcast arguments + (4), unit [1, 1/s, 1/s^2, 1/s^3].

    Accuracy: measured, not proved: at most 6 ulp from 50-digit arithmetic at 500 points of this domain
    (float64, independent errors). Errors are measured against the weights of this, the first and the last
    scan and the root mean square of all.
    """
    arguments = _floats(k, j, T, C, tau)
    k, j, T, C, tau = arguments
    sum_1 = k - 1.0
    span = (1.0 + k) * sum_1
    sum_2 = k - 2.0
    bend = (2.0 + k) * sum_2
    term_1 = 1.0 / (12.0 * C + span)
    range_share = span * term_1
    rate_share = 12.0 * C * term_1
    middle = 0.5 * k - 0.5
    position = middle + tau
    reach = -(k - 1.0 + tau) * tau
    term_2 = (middle**2)**2
    nearness = term_2 / (4.0 * reach**2 + term_2)
    scan_position = j - 0.5 - 0.5 * k
    scan_reach = (k - j) * (j - 1.0)
    per_constant = 1.0 / k
    term_3 = per_constant
    per_slope = 12.0 * term_1 * term_3
    term_4 = 1.0 / span
    per_curvature = 180.0 * term_3 * term_4 / (60.0 * C + bend)
    sum_3 = k - 3.0
    k_squared = k**2
    per_cubic = term_3 * term_4 / (C * bend / 20.0 + bend * (3.0 + k) * sum_3 / 2800.0 + (1.0 + k_squared)**2 * rate_share / 1200.0)
    product_1 = range_share * sum_2 * sum_3 / 10.0
    product_2 = (0.5 - 0.5 * k) * rate_share
    sum_4 = product_1 - scan_reach + product_2
    product_3 = sum_1 * sum_2 / 6.0
    sum_5 = product_3 - scan_reach
    sum_6 = 1.0 - nearness
    position_squared = position**2
    sum_7 = nearness * (product_3 - reach) + (position_squared - span / 12.0) * sum_6
    sum_8 = 3.0 * k_squared / 20.0 - 7.0 / 20.0
    sum_9 = 3.0 * position_squared - range_share * sum_8 - 0.25 * rate_share * span
    sum_10 = 3.0 * k / 10.0 - 1.0 / 10.0 + (6.0 * k - 6.0) * sum_2 / 10.0
    sum_11 = range_share * sum_10 - 3.0 * reach + 0.5 * rate_share * sum_1 * sum_2
    sum_12 = nearness * sum_11 + sum_6 * sum_9
    sum_13 = (
        2.0 * per_curvature * position * sum_5
        + per_cubic * scan_position * sum_12 * sum_4
        + per_slope * scan_position
    )
    sum_14 = sum_1 * sum_2 / 3.0 - 2.0 * scan_reach
    sum_15 = 6.0 * per_cubic * position * scan_position * sum_4 + per_curvature * sum_14
    result = _empty(arguments, (4,))
    result[..., 0] = (
        per_constant
        + per_cubic * position * (product_1 - reach + product_2) * scan_position * sum_4
        + per_curvature * sum_5 * sum_7
        + per_slope * position * scan_position
    )
    result[..., 1] = sum_13 / T
    result[..., 2] = sum_15 / T**2
    result[..., 3] = 6.0 * per_cubic * scan_position * sum_4 / (T * T**2)
    return result


def degree3_range_rate_at_lag_rate_weights(
    *,
    k: npt.ArrayLike,
    j: npt.ArrayLike,
    T: npt.ArrayLike,
    C: npt.ArrayLike,
    tau: npt.ArrayLike,
) -> Floats:
    """Weights of the rate of scan j in the estimate of range and three derivatives from k scans of range and range rate (where C > 0, k from 2 on), tau scans after the newest one.

    Name: finite_sample.degree3.range_rate.at_lag.rate_weights.
    Definition: W_j = R H_j' Q_theta.
    Conditioning: no expectation is taken.
    Source: Gorshkov & Zavizhenets (13)-(20).

    Args:
        k: number of scans [1], 4 to 1e+06.
        j: number of the scan that is weighted, 1 the oldest, k the newest [1], 1 to 1e+06.
        T: time from scan to scan [s], 0.001 to 1000.
        C: sigma_r^2/(T^2 sigma_v^2), the weight of the range rate [1], 0 to 1e+12.
        tau: scans from the newest one to the time of the estimate, less than 0 to smooth [1], -1e+06 to 1e+06.

    Returns:
        Shape of the broadcast arguments + (4), unit [s, 1, 1/s, 1/s^2].

    Accuracy: measured, not proved: at most 7 ulp from 50-digit arithmetic at 500 points of this domain
    (float64, independent errors). Errors are measured against the weights of this, the first and the last
    scan and the root mean square of all.
    """
    arguments = _floats(k, j, T, C, tau)
    k, j, T, C, tau = arguments
    sum_1 = k - 1.0
    span = (1.0 + k) * sum_1
    sum_2 = k - 2.0
    bend = (2.0 + k) * sum_2
    term_1 = 1.0 / (12.0 * C + span)
    range_share = span * term_1
    rate_share = 12.0 * C * term_1
    middle = 0.5 * k - 0.5
    position = middle + tau
    reach = -(k - 1.0 + tau) * tau
    term_2 = (middle**2)**2
    nearness = term_2 / (4.0 * reach**2 + term_2)
    scan_position = j - 0.5 - 0.5 * k
    scan_reach = (k - j) * (j - 1.0)
    term_3 = 1.0 / k
    per_slope = 12.0 * term_1 * term_3
    term_4 = 1.0 / span
    per_curvature = 180.0 * term_3 * term_4 / (60.0 * C + bend)
    sum_3 = k - 3.0
    k_squared = k**2
    per_cubic = term_3 * term_4 / (C * bend / 20.0 + bend * (3.0 + k) * sum_3 / 2800.0 + (1.0 + k_squared)**2 * rate_share / 1200.0)
    sum_4 = 1.0 - nearness
    position_squared = position**2
    sum_5 = (sum_1 * sum_2 / 6.0 - reach) * nearness + (position_squared - span / 12.0) * sum_4
    sum_6 = 3.0 * k / 10.0 - 1.0 / 10.0 + (6.0 * k - 6.0) * sum_2 / 10.0
    product_1 = range_share * sum_6
    product_2 = 0.5 * rate_share * sum_1 * sum_2
    sum_7 = product_1 - 3.0 * scan_reach + product_2
    sum_8 = range_share * sum_2 * sum_3 / 10.0 - reach + (0.5 - 0.5 * k) * rate_share
    sum_9 = (
        2.0 * per_curvature * scan_position * sum_5
        + per_cubic * position * sum_7 * sum_8
        + per_slope * position
    )
    sum_10 = 3.0 * k_squared / 20.0 - 7.0 / 20.0
    sum_11 = 3.0 * position_squared - range_share * sum_10 - 0.25 * rate_share * span
    sum_12 = product_1 - 3.0 * reach + product_2
    sum_13 = nearness * sum_12 + sum_11 * sum_4
    sum_14 = 4.0 * per_curvature * position * scan_position + per_cubic * sum_13 * sum_7 + per_slope
    sum_15 = 4.0 * per_curvature * scan_position + 6.0 * per_cubic * position * sum_7
    sum_16 = 3.0 * rate_share * sum_1 * sum_2 - 18.0 * scan_reach + 6.0 * range_share * sum_6
    result = _empty(arguments, (4,))
    result[..., 0] = C * T * sum_9
    result[..., 1] = C * sum_14
    result[..., 2] = C * sum_15 / T
    result[..., 3] = C * per_cubic * sum_16 / T**2
    return result


def degree3_gain(*, k: npt.ArrayLike, C: npt.ArrayLike) -> Floats:
    """Part of the standard deviations of range and three derivatives that the range rate removes, at the newest scan.

    Name: finite_sample.degree3.gain.
    Definition: K_x = 1 - sqrt(R_xx with range rate / R_xx without).
    Conditioning: no expectation is taken.
    Source: Gorshkov & Zavizhenets (22).

    Args:
        k: number of scans [1], 4 to 1e+06.
        C: sigma_r^2/(T^2 sigma_v^2), the weight of the range rate [1], 0 to 1e+12.

    Returns:
        Shape of the broadcast arguments + (4), unit 1.

    Accuracy: at most 102 ulp anywhere in this domain, proved for elementary functions within 1 ulp (float64).
    Errors are measured against itself.
    """
    arguments = _floats(k, C)
    k, C = arguments
    k_beyond_4 = k - 4.0
    term_1 = 1.0 / (7.0 + 2.0 * k_beyond_4)
    k_beyond_4_squared = k_beyond_4**2
    term_2 = 1.0 / (15.0 + 7.0 * k_beyond_4 + k_beyond_4_squared)
    term_3 = 1.0 / (12.0 + 60.0 * C + 8.0 * k_beyond_4 + k_beyond_4_squared)
    product_1 = k_beyond_4 * k_beyond_4_squared
    C_squared = C**2
    k_beyond_4_squared_squared = k_beyond_4_squared**2
    product_2 = k_beyond_4 * k_beyond_4_squared**2
    k_beyond_4_squared_cubed = k_beyond_4_squared * k_beyond_4_squared**2
    term_4 = 1.0 / (1260.0 + 1056.0 * product_1 + 13440.0 * C_squared * k_beyond_4 + 16480.0 * C * k_beyond_4_squared + 1680.0 * C_squared * k_beyond_4_squared + 180.0 * C * k_beyond_4_squared_squared + 20160.0 * C_squared + 226.0 * k_beyond_4_squared_squared + 24.0 * product_2 + 2545.0 * k_beyond_4_squared + 2880.0 * C * product_1 + 2952.0 * k_beyond_4 + 34300.0 * C + 39680.0 * C * k_beyond_4 + k_beyond_4_squared_cubed)
    product_3 = C * C_squared
    product_4 = k_beyond_4 * (k_beyond_4_squared**2)**2
    product_5 = k_beyond_4 * k_beyond_4_squared * k_beyond_4_squared**2
    term_5 = (k_beyond_4_squared**2)**2
    sum_1 = (
        37800.0
        + 1081500.0 * C
        + 108360.0 * C_squared * k_beyond_4_squared_squared
        + 1179645.0 * C * product_1
        + 12600.0 * product_1 * product_3
        + 130500.0 * k_beyond_4
        + 155627.0 * product_1
        + 163800.0 * k_beyond_4_squared * product_3
        + 190398.0 * k_beyond_4_squared
        + 2.0 * product_4
        + 2297415.0 * C * k_beyond_4_squared
        + 2435640.0 * C * k_beyond_4
        + 26095.0 * product_2
        + 270.0 * C * product_5
        + 2965620.0 * C_squared * k_beyond_4_squared
        + 357540.0 * C * k_beyond_4_squared_squared
        + 3714900.0 * C_squared
        + 5312940.0 * C_squared * k_beyond_4
        + 5609.0 * k_beyond_4_squared_cubed
        + 5760.0 * C_squared * product_2
        + 59.0 * term_5
        + 6375.0 * C * k_beyond_4_squared_cubed
        + 64275.0 * C * product_2
        + 655200.0 * k_beyond_4 * product_3
        + 756000.0 * product_3
        + 760.0 * product_5
        + 79118.0 * k_beyond_4_squared_squared
        + 808680.0 * C_squared * product_1
    )
    term_6 = np.sqrt(6.0 + k_beyond_4)
    term_7 = np.sqrt(7.0 + k_beyond_4)
    sum_2 = 2.0 + k_beyond_4
    sum_3 = 3.0 + k_beyond_4
    sum_4 = (
        191100.0
        + 1125.0 * k_beyond_4_squared_cubed
        + 12505.0 * product_2
        + 2116800.0 * C_squared * k_beyond_4
        + 2240700.0 * C * k_beyond_4_squared
        + 253887.0 * product_1
        + 2848860.0 * C
        + 3175200.0 * C_squared
        + 37800.0 * C_squared * product_1
        + 3840.0 * C * product_2
        + 4096260.0 * C * k_beyond_4
        + 42.0 * product_5
        + 491400.0 * C_squared * k_beyond_4_squared
        + 491869.0 * k_beyond_4_squared
        + 492044.0 * k_beyond_4
        + 593400.0 * C * product_1
        + 74384.0 * k_beyond_4_squared_squared
        + 76440.0 * C * k_beyond_4_squared_squared
    )
    term_8 = 1.0 / (371.0 + 294.0 * k_beyond_4_squared + 546.0 * k_beyond_4 + 6.0 * k_beyond_4_squared_squared + 69.0 * product_1)
    sum_5 = 1.0 + k_beyond_4
    sum_6 = (
        111300.0
        + 134485.0 * product_1
        + 1556268.0 * C * k_beyond_4
        + 204120.0 * C_squared * k_beyond_4_squared
        + 22680.0 * C_squared * product_1
        + 254275.0 * k_beyond_4_squared
        + 2592.0 * C * product_2
        + 260260.0 * k_beyond_4
        + 293256.0 * C * product_1
        + 30.0 * product_5
        + 41580.0 * k_beyond_4_squared_squared
        + 43992.0 * C * k_beyond_4_squared_squared
        + 574560.0 * C_squared
        + 604800.0 * C_squared * k_beyond_4
        + 735.0 * k_beyond_4_squared_cubed
        + 7515.0 * product_2
        + 962244.0 * C * k_beyond_4_squared
        + 994980.0 * C
    )
    sum_7 = (
        163255260.0
        + 1030390620.0 * C
        + 1041642000.0 * C_squared * k_beyond_4_squared
        + 1152.0 * k_beyond_4_squared * (k_beyond_4_squared**2)**2
        + 115668000.0 * C_squared * k_beyond_4_squared_squared
        + 1199520000.0 * C_squared * k_beyond_4
        + 132258411.0 * product_2
        + 14742000.0 * C_squared * product_2
        + 188235360.0 * C * product_2
        + 1951778220.0 * C * product_1
        + 2415240.0 * C * product_5
        + 2707710600.0 * C * k_beyond_4
        + 28470060.0 * C * k_beyond_4_squared_cubed
        + 3065273400.0 * C * k_beyond_4_squared
        + 33524922.0 * k_beyond_4_squared_cubed
        + 356715301.0 * k_beyond_4_squared_squared
        + 40590.0 * product_4
        + 469476000.0 * C_squared * product_1
        + 530358416.0 * k_beyond_4
        + 560952000.0 * C_squared
        + 5731737.0 * product_5
        + 632136.0 * term_5
        + 650168170.0 * product_1
        + 756000.0 * C_squared * k_beyond_4_squared_cubed
        + 764137410.0 * C * k_beyond_4_squared_squared
        + 767368553.0 * k_beyond_4_squared
        + 87930.0 * C * term_5
    )
    term_9 = 1.0 / (23.0 + 9.0 * k_beyond_4)
    sum_8 = (
        28980.0
        + 123480.0 * C_squared
        + 13440.0 * C_squared * k_beyond_4_squared
        + 1350.0 * C * k_beyond_4_squared_squared
        + 16383.0 * product_1
        + 18.0 * k_beyond_4_squared_cubed
        + 181580.0 * C
        + 19080.0 * C * product_1
        + 220180.0 * C * k_beyond_4
        + 3543.0 * k_beyond_4_squared_squared
        + 397.0 * product_2
        + 41435.0 * k_beyond_4_squared
        + 54396.0 * k_beyond_4
        + 82320.0 * C_squared * k_beyond_4
        + 98330.0 * C * k_beyond_4_squared
    )
    sum_9 = (
        6318648.0
        + 114514.0 * k_beyond_4_squared_cubed
        + 12589920.0 * C_squared * k_beyond_4_squared
        + 15636600.0 * k_beyond_4
        + 16614270.0 * k_beyond_4_squared
        + 181440.0 * C_squared * k_beyond_4_squared_squared
        + 19385160.0 * C * product_1
        + 19474560.0 * C_squared
        + 21120.0 * C * k_beyond_4_squared_cubed
        + 2550240.0 * C_squared * product_1
        + 26167680.0 * C_squared * k_beyond_4
        + 297.0 * term_5
        + 35991480.0 * C
        + 3602279.0 * k_beyond_4_squared_squared
        + 4167780.0 * C * k_beyond_4_squared_squared
        + 465720.0 * C * product_2
        + 49517340.0 * C * k_beyond_4_squared
        + 66024840.0 * C * k_beyond_4
        + 821614.0 * product_2
        + 8916.0 * product_5
        + 9888878.0 * product_1
    )
    sum_10 = 15.0 + 12.0 * C + 8.0 * k_beyond_4 + k_beyond_4_squared
    sum_11 = (
        1189.0
        + 1352.0 * k_beyond_4
        + 480.0 * C * k_beyond_4
        + 553.0 * k_beyond_4_squared
        + 6.0 * k_beyond_4_squared_squared
        + 60.0 * C * k_beyond_4_squared
        + 720.0 * C
        + 96.0 * product_1
    )
    result = _empty(arguments, (4,))
    result[..., 0] = 5.0 * C * sum_2 * sum_3 * sum_4 * term_1 * term_2 * term_3 * term_4 / (1.0 + np.sqrt(sum_1 * term_1 * term_2 * term_3 * term_4) * term_6 * term_7)
    result[..., 1] = 4.0 * C * sum_7 * term_3 * term_4 * term_8 / ((1.0 + np.sqrt(5.0) * np.sqrt(sum_2 * sum_3 * sum_5 * sum_6 * term_3 * term_4 * term_8) * term_6 * term_7 / 5.0) * 5.0)
    result[..., 2] = 10.0 * C * sum_9 * term_1 * term_3 * term_4 * term_9 / (1.0 + np.sqrt(sum_2 * sum_5 * sum_8 * term_1 * term_3 * term_4 * term_9) * term_6 * term_7)
    result[..., 3] = 28.0 * C * sum_11 * term_4 / (1.0 + np.sqrt(sum_10 * sum_2 * sum_5 * term_4) * term_6 * term_7)
    return result


def degree3_range_gain_of_perfect_rate(*, k: npt.ArrayLike) -> Floats:
    """Part of the standard deviation of the range, of range and three derivatives, that errorless range rates would remove.

    Name: finite_sample.degree3.range_gain_of_perfect_rate.
    Definition: limit of K_r for C to infinity.
    Conditioning: no expectation is taken.
    Source: Gorshkov & Zavizhenets (22).

    Args:
        k: number of scans [1], 4 to 1e+06.

    Returns:
        Shape of the broadcast arguments, unit 1.

    Accuracy: at most 17.6 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 25.8.
    """
    arguments = _floats(k)
    k, = arguments
    term_1 = 1.0 / (2.0 * k - 1.0)
    k_squared = k**2
    term_2 = 1.0 / (3.0 - k + k_squared)
    result = _empty(arguments, ())
    result[...] = 1.875 * (k - 1.0) * (2.0 - k + k_squared) * term_1 * term_2 / (1.0 + 0.25 * np.sqrt(2.0) * np.sqrt(1.0 + k) * np.sqrt(2.0 + k) * np.sqrt(3.0 + k) * np.sqrt(term_1 * term_2))
    return result[()]
