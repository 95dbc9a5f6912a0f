"""NumPy functions of the quantities finite_sample.*.

Written by radartrack regenerate, generator 1, derivation 41413b7b31fecd4c; not to be edited.
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

    Accuracy: at most 2.5 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
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

    Accuracy: at most 0 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
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

    Accuracy: at most 1.5 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
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

    Accuracy: at most 1.5 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
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

    Accuracy: at most 2 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
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

    Accuracy: at most 0 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
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

    Accuracy: at most 0.5 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
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

    Accuracy: at most 2 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
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

    Accuracy: at most 0.5 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
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

    Accuracy: at most 0 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
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

    Accuracy: at most 2.5 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
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

    Accuracy: at most 1.5 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
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

    Accuracy: at most 2 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
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

    Accuracy: at most 0 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
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

    Accuracy: at most 0.5 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
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

    Accuracy: at most 0 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
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

    Accuracy: at most 2 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
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

    Accuracy: at most 0.5 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
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

    Accuracy: at most 0 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
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

    Accuracy: at most 0 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
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

    Accuracy: at most 0 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
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

    Accuracy: at most 0.5 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
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

    Accuracy: at most 1.5 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
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

    Accuracy: at most 3 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
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

    Accuracy: at most 3.5 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
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

    Accuracy: at most 1.5 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
    """
    arguments = _floats(k)
    k, = arguments
    result = _empty(arguments, (2, 2))
    result[..., 0, 0] = 1.0
    result[..., 0, 1] = np.sqrt(3.0) / np.sqrt((4.0 * k - 2.0) / (k - 1.0))
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

    Accuracy: at most 3 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
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

    Accuracy: at most 3.5 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
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

    Accuracy: at most 3.5 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
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

    Accuracy: at most 0.5 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
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

    Accuracy: at most 2.5 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
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

    Accuracy: at most 3 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
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

    Accuracy: at most 3 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
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

    Accuracy: at most 2 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
    """
    arguments = _floats(k, C)
    k, C = arguments
    k_squared = k**2
    sum_1 = 12.0 * C - 1.0 + k_squared
    sum_2 = 2.0 - 6.0 * k + 12.0 * C + 4.0 * k_squared
    result = _empty(arguments, (2, 2))
    result[..., 0, 0] = 1.0
    result[..., 0, 1] = (6.0 * k - 6.0) * np.sqrt(3.0) / (np.sqrt(sum_2 / sum_1**2) * sum_1 * 6.0)
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

    Accuracy: at most 3.5 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
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

    Accuracy: at most 2.5 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
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

    Accuracy: at most 3 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
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

    Accuracy: at most 4 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
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

    Accuracy: at most 2.5 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
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

    Accuracy: at most 4 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
    """
    arguments = _floats(k, C)
    k, C = arguments
    k_squared = k**2
    term_1 = 1.0 / (12.0 * C - 1.0 + k_squared)
    term_2 = 1.0 / (2.0 * k - 1.0)
    sum_1 = 1.0 - 3.0 * k + 2.0 * k_squared + 6.0 * C
    term_3 = np.sqrt(1.0 + k)
    sum_2 = k - 1.0
    result = _empty(arguments, (2,))
    result[..., 0] = 18.0 * C * sum_2 * term_1 * term_2 / (1.0 + np.sqrt(sum_1 * term_1 * term_2) * term_3)
    result[..., 1] = 12.0 * C * term_1 / (1.0 + np.sqrt(sum_2 * term_1) * term_3)
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

    Accuracy: at most 2.5 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
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

    Accuracy: at most 1.5 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
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

    Accuracy: at most 1.5 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
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

    Accuracy: at most 4.5 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
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

    Accuracy: at most 4 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
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

    Accuracy: at most 1 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
    """
    arguments = _floats(k)
    k, = arguments
    sum_1 = k - 1.0
    term_1 = 1.0 / sum_1
    sum_2 = k - 2.0
    term_2 = 1.0 / sum_2
    sum_3 = 2.0 * k - 1.0
    sum_4 = 8.0 * k - 11.0
    sum_5 = 6.0 - 9.0 * k + 9.0 * k**2
    result = _empty(arguments, (3, 3))
    result[..., 0, 0] = 1.0
    result[..., 0, 1] = (36.0 * k - 18.0) * np.sqrt(3.0) / (np.sqrt(sum_3 * sum_4 * sum_5 * term_1 * term_2) * 6.0)
    result[..., 0, 2] = np.sqrt(5.0) / np.sqrt(sum_5 * term_1 * term_2)
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = 1.0
    result[..., 1, 2] = np.sqrt(15.0) * term_2 / np.sqrt(sum_3 * sum_4 / (sum_1**2 * sum_2**2))
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

    Accuracy: at most 6 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
    """
    arguments = _floats(k, j, T)
    k, j, T = arguments
    sum_1 = k - 1.0
    span = (1.0 + k) * sum_1
    sum_2 = k - 2.0
    bend = (2.0 + k) * sum_2
    middle = 0.5 * k - 0.5
    scan_position = j - 0.5 - 0.5 * k
    per_constant = 1.0 / k
    term_1 = per_constant
    term_2 = 1.0 / span
    per_slope = 12.0 * term_1 * term_2
    per_curvature = 180.0 * term_1 * term_2 / bend
    scan_position_squared = scan_position**2
    sum_3 = scan_position_squared - span / 12.0
    sum_4 = 2.0 * middle * per_curvature * sum_3 + per_slope * scan_position
    sum_5 = 2.0 * scan_position_squared - span / 6.0
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

    Accuracy: at most 4.5 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
    """
    arguments = _floats(k, T, sigma_r, tau)
    k, T, sigma_r, tau = arguments
    span = (1.0 + k) * (k - 1.0)
    bend = (2.0 + k) * (k - 2.0)
    middle = 0.5 * k - 0.5
    position = middle + tau
    per_constant = 1.0 / k
    term_1 = per_constant
    term_2 = 1.0 / span
    per_slope = 12.0 * term_1 * term_2
    per_curvature = 180.0 * term_1 * term_2 / bend
    position_squared = position**2
    sum_1 = position_squared - span / 12.0
    sigma_r_squared = sigma_r**2
    sum_2 = per_constant + per_curvature * sum_1**2 + per_slope * position_squared
    sum_3 = 2.0 * per_curvature * position * sum_1 + per_slope * position
    term_3 = 1.0 / T**2
    sum_4 = 2.0 * position_squared - span / 6.0
    sum_5 = 4.0 * per_curvature * position_squared + per_slope
    result = _empty(arguments, (3, 3))
    result[..., 0, 0] = sigma_r_squared * sum_2
    result[..., 0, 1] = sigma_r_squared * sum_3 / T
    result[..., 0, 2] = per_curvature * sigma_r_squared * sum_4 * term_3
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = sigma_r_squared * sum_5 * term_3
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

    Accuracy: at most 6 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
    """
    arguments = _floats(k, j, T, tau)
    k, j, T, tau = arguments
    span = (1.0 + k) * (k - 1.0)
    bend = (2.0 + k) * (k - 2.0)
    middle = 0.5 * k - 0.5
    position = middle + tau
    scan_position = j - 0.5 - 0.5 * k
    per_constant = 1.0 / k
    term_1 = per_constant
    term_2 = 1.0 / span
    per_slope = 12.0 * term_1 * term_2
    per_curvature = 180.0 * term_1 * term_2 / bend
    scan_position_squared = scan_position**2
    sum_1 = scan_position_squared - span / 12.0
    sum_2 = 2.0 * per_curvature * position * sum_1 + per_slope * scan_position
    sum_3 = 2.0 * scan_position_squared - span / 6.0
    result = _empty(arguments, (3,))
    result[..., 0] = (
        per_constant
        + per_curvature * (position**2 - span / 12.0) * sum_1
        + per_slope * position * scan_position
    )
    result[..., 1] = sum_2 / T
    result[..., 2] = per_curvature * sum_3 / T**2
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

    Accuracy: at most 1.5 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
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

    Accuracy: at most 2.5 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
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

    Accuracy: at most 4 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
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

    Accuracy: at most 3.5 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
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

    Accuracy: at most 1 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
    """
    arguments = _floats(k, C)
    k, C = arguments
    k_squared = k**2
    sum_1 = 12.0 * C - 1.0 + k_squared
    term_1 = 1.0 / sum_1
    sum_2 = 60.0 * C - 4.0 + k_squared
    term_2 = 1.0 / sum_2
    term_3 = 1.0 / sum_2**2
    sum_3 = 120.0 * C - 11.0 - 3.0 * k + 8.0 * k_squared
    sum_4 = 2.0 * k - 1.0
    product_1 = k * k_squared
    C_squared = C**2
    sum_5 = (
        12.0
        - 168.0 * C
        - 24.0 * k
        - 27.0 * k_squared**2
        - 408.0 * C * k_squared
        + 15.0 * k_squared
        + 15.0 * product_1
        + 192.0 * C * k
        + 312.0 * C * product_1
        + 720.0 * C_squared
        + 720.0 * C_squared * k
        + 9.0 * k * k_squared**2
    )
    sum_6 = k - 1.0
    term_4 = 1.0 / sum_6
    result = _empty(arguments, (3, 3))
    result[..., 0, 0] = 1.0
    result[..., 0, 1] = 3.0 * (20.0 * C - 2.0 - k + k_squared) * np.sqrt(3.0) * sum_4 * sum_6 * term_1 * term_2 / np.sqrt(sum_3 * sum_4 * sum_5 * term_3 / sum_1**2)
    result[..., 0, 2] = (60.0 * k - 120.0) * np.sqrt(5.0) * term_2 / (np.sqrt(sum_5 * term_1 * term_3 * term_4) * 60.0)
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

    Accuracy: at most 6.5 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
    """
    arguments = _floats(k, j, T, C)
    k, j, T, C = arguments
    sum_1 = k - 1.0
    span = (1.0 + k) * sum_1
    sum_2 = k - 2.0
    bend = (2.0 + k) * sum_2
    middle = 0.5 * k - 0.5
    scan_position = j - 0.5 - 0.5 * k
    per_constant = 1.0 / k
    term_1 = per_constant
    per_slope = 12.0 * term_1 / (12.0 * C + span)
    per_curvature = 180.0 * term_1 / ((60.0 * C + bend) * span)
    scan_position_squared = scan_position**2
    sum_3 = scan_position_squared - span / 12.0
    sum_4 = 2.0 * middle * per_curvature * sum_3 + per_slope * scan_position
    sum_5 = 2.0 * scan_position_squared - span / 6.0
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

    Accuracy: at most 5 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
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

    Accuracy: at most 5 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
    """
    arguments = _floats(k, T, sigma_r, C, tau)
    k, T, sigma_r, C, tau = arguments
    span = (1.0 + k) * (k - 1.0)
    bend = (2.0 + k) * (k - 2.0)
    middle = 0.5 * k - 0.5
    position = middle + tau
    per_constant = 1.0 / k
    term_1 = per_constant
    per_slope = 12.0 * term_1 / (12.0 * C + span)
    per_curvature = 180.0 * term_1 / ((60.0 * C + bend) * span)
    position_squared = position**2
    sum_1 = position_squared - span / 12.0
    sigma_r_squared = sigma_r**2
    sum_2 = per_constant + per_curvature * sum_1**2 + per_slope * position_squared
    sum_3 = 2.0 * per_curvature * position * sum_1 + per_slope * position
    term_2 = 1.0 / T**2
    sum_4 = 2.0 * position_squared - span / 6.0
    sum_5 = 4.0 * per_curvature * position_squared + per_slope
    result = _empty(arguments, (3, 3))
    result[..., 0, 0] = sigma_r_squared * sum_2
    result[..., 0, 1] = sigma_r_squared * sum_3 / T
    result[..., 0, 2] = per_curvature * sigma_r_squared * sum_4 * term_2
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = sigma_r_squared * sum_5 * term_2
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

    Accuracy: at most 6.5 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
    """
    arguments = _floats(k, j, T, C, tau)
    k, j, T, C, tau = arguments
    span = (1.0 + k) * (k - 1.0)
    bend = (2.0 + k) * (k - 2.0)
    middle = 0.5 * k - 0.5
    position = middle + tau
    scan_position = j - 0.5 - 0.5 * k
    per_constant = 1.0 / k
    term_1 = per_constant
    per_slope = 12.0 * term_1 / (12.0 * C + span)
    per_curvature = 180.0 * term_1 / ((60.0 * C + bend) * span)
    scan_position_squared = scan_position**2
    sum_1 = scan_position_squared - span / 12.0
    sum_2 = 2.0 * per_curvature * position * sum_1 + per_slope * scan_position
    sum_3 = 2.0 * scan_position_squared - span / 6.0
    result = _empty(arguments, (3,))
    result[..., 0] = (
        per_constant
        + per_curvature * (position**2 - span / 12.0) * sum_1
        + per_slope * position * scan_position
    )
    result[..., 1] = sum_2 / T
    result[..., 2] = per_curvature * sum_3 / T**2
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

    Accuracy: at most 6 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
    """
    arguments = _floats(k, j, T, C, tau)
    k, j, T, C, tau = arguments
    span = (1.0 + k) * (k - 1.0)
    bend = (2.0 + k) * (k - 2.0)
    middle = 0.5 * k - 0.5
    position = middle + tau
    scan_position = j - 0.5 - 0.5 * k
    term_1 = 1.0 / k
    per_slope = 12.0 * term_1 / (12.0 * C + span)
    per_curvature = 180.0 * term_1 / ((60.0 * C + bend) * span)
    sum_1 = 2.0 * per_curvature * (position**2 - span / 12.0) * scan_position + per_slope * position
    sum_2 = 4.0 * per_curvature * position * scan_position + per_slope
    result = _empty(arguments, (3,))
    result[..., 0] = C * T * sum_1
    result[..., 1] = C * sum_2
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

    Accuracy: at most 5 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
    """
    arguments = _floats(k, C)
    k, C = arguments
    k_squared = k**2
    term_1 = 1.0 / (12.0 * C - 1.0 + k_squared)
    term_2 = 1.0 / (2.0 - 3.0 * k + 3.0 * k_squared)
    term_3 = 1.0 / (60.0 * C - 4.0 + k_squared)
    product_1 = k * k_squared
    C_squared = C**2
    sum_1 = (
        4.0
        - 136.0 * C * k_squared
        - 56.0 * C
        - 8.0 * k
        - 9.0 * k_squared**2
        + 104.0 * C * product_1
        + 240.0 * C_squared
        + 240.0 * C_squared * k
        + 3.0 * k * k_squared**2
        + 5.0 * k_squared
        + 5.0 * product_1
        + 64.0 * C * k
    )
    term_4 = np.sqrt(2.0 + k)
    sum_2 = k - 1.0
    sum_3 = 14.0 * k_squared - 26.0 - 15.0 * k + 240.0 * C
    term_5 = 1.0 / (8.0 * k - 11.0)
    sum_4 = k - 2.0
    sum_5 = 120.0 * C - 11.0 - 3.0 * k + 8.0 * k_squared
    sum_6 = 59.0 - 32.0 * k - 56.0 * k_squared - 660.0 * C + 38.0 * product_1 + 480.0 * C * k
    result = _empty(arguments, (3,))
    result[..., 0] = 4.0 * (2.0 * k - 1.0) * C * sum_2 * sum_3 * term_1 * term_2 * term_3 / (1.0 + np.sqrt(sum_1 * term_1 * term_2 * term_3) * term_4)
    result[..., 1] = 12.0 * C * sum_6 * term_1 * term_3 * term_5 / (1.0 + np.sqrt(sum_2 * sum_4 * sum_5 * term_1 * term_3 * term_5) * term_4)
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

    Accuracy: at most 2.5 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
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

    Accuracy: at most 2.5 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
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

    Accuracy: at most 1.5 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
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

    Accuracy: at most 6 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
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

    Accuracy: at most 6.5 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
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

    Accuracy: at most 1.5 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
    """
    arguments = _floats(k)
    k, = arguments
    sum_1 = k - 1.0
    term_1 = 1.0 / sum_1
    sum_2 = k - 2.0
    term_2 = 1.0 / sum_2
    sum_3 = k - 3.0
    term_3 = 1.0 / sum_3
    k_squared = k**2
    sum_4 = 2200.0 - 5400.0 * k * k_squared - 6000.0 * k + 1200.0 * k_squared**2 + 8400.0 * k_squared
    sum_5 = 2.0 * k - 1.0
    sum_6 = 3.0 - k + k_squared
    sum_7 = 100.0 - 120.0 * k + 120.0 * k_squared
    sum_8 = 9.0 * k - 13.0
    term_4 = 1.0 / sum_1**2
    term_5 = 1.0 / sum_2**2
    term_6 = 1.0 / sum_3**2
    sum_9 = 18480.0 - 25200.0 * k + 10080.0 * k_squared
    result = _empty(arguments, (4, 4))
    result[..., 0, 0] = 1.0
    result[..., 0, 1] = 0.25 * np.sqrt(2.0) * sum_7 / np.sqrt(sum_4 * sum_5 * sum_6 * term_1 * term_2 * term_3)
    result[..., 0, 2] = (480.0 * k - 240.0) * np.sqrt(5.0) / (np.abs(sum_5) * np.sqrt(sum_6 * sum_8 * term_1 * term_2 * term_3) * 240.0)
    result[..., 0, 3] = 0.25 * np.sqrt(14.0) / np.sqrt(sum_5 * sum_6 * term_1 * term_2 * term_3)
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = 1.0
    result[..., 1, 2] = 5.0 * (3.0 * k - 2.0) * (3.0 * k - 5.0) * np.sqrt(10.0) * term_2 * term_3 / np.sqrt(sum_4 * sum_5 * sum_8 * term_4 * term_5 * term_6)
    result[..., 1, 3] = np.sqrt(7.0) * sum_9 * term_1 * term_2 * term_3 / (np.sqrt(sum_4 * term_4 * term_5 * term_6) * 840.0)
    result[..., 2, 0] = result[..., 0, 2]
    result[..., 2, 1] = result[..., 1, 2]
    result[..., 2, 2] = 1.0
    result[..., 2, 3] = 0.5 * np.sqrt(70.0) * term_2 * term_3 / np.sqrt(sum_5 * sum_8 * term_4 * term_5 * term_6)
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

    Accuracy: at most 7 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
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
    scan_position_squared = scan_position**2
    sum_5 = scan_position_squared - span / 12.0
    sum_6 = 3.0 * k / 10.0 - 1.0 / 10.0 + (6.0 * k - 6.0) * sum_2 / 10.0
    sum_7 = (
        2.0 * middle * per_curvature * sum_5
        + per_cubic * scan_position * sum_4 * sum_6
        + per_slope * scan_position
    )
    sum_8 = 2.0 * scan_position_squared - span / 6.0
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

    Accuracy: at most 5.5 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
    """
    arguments = _floats(k, T, sigma_r, tau)
    k, T, sigma_r, tau = arguments
    span = (1.0 + k) * (k - 1.0)
    sum_1 = k - 2.0
    bend = (2.0 + k) * sum_1
    middle = 0.5 * k - 0.5
    position = middle + tau
    reach = -(k - 1.0 + tau) * tau
    per_constant = 1.0 / k
    term_1 = per_constant
    term_2 = 1.0 / span
    per_slope = 12.0 * term_1 * term_2
    term_3 = 1.0 / bend
    per_curvature = 180.0 * term_1 * term_2 * term_3
    sum_2 = k - 3.0
    per_cubic = 2800.0 * term_1 * term_2 * term_3 / ((3.0 + k) * sum_2)
    sum_3 = sum_1 * sum_2 / 10.0 - reach
    position_squared = position**2
    sum_4 = position_squared - span / 12.0
    sigma_r_squared = sigma_r**2
    sum_5 = (
        per_constant
        + per_cubic * position_squared * sum_3**2
        + per_curvature * sum_4**2
        + per_slope * position_squared
    )
    k_squared = k**2
    sum_6 = 7.0 / 20.0 - 3.0 * k_squared / 20.0 + 3.0 * position_squared
    sum_7 = (
        2.0 * per_curvature * position * sum_4
        + per_cubic * position * sum_3 * sum_6
        + per_slope * position
    )
    sum_8 = 2.0 * position_squared - span / 6.0
    term_4 = 1.0 / T**2
    sum_9 = 6.0 * per_cubic * position_squared * sum_3 + per_curvature * sum_8
    term_5 = 1.0 / (T * T**2)
    sum_10 = 4.0 * per_curvature * position_squared + per_cubic * sum_6**2 + per_slope
    sum_11 = 4.0 * per_curvature * position + 6.0 * per_cubic * position * sum_6
    term_6 = 1.0 / (T**2)**2
    sum_12 = 21.0 / 10.0 - 9.0 * k_squared / 10.0 + 18.0 * position_squared
    sum_13 = 36.0 * per_cubic * position_squared + 4.0 * per_curvature
    result = _empty(arguments, (4, 4))
    result[..., 0, 0] = sigma_r_squared * sum_5
    result[..., 0, 1] = sigma_r_squared * sum_7 / T
    result[..., 0, 2] = sigma_r_squared * sum_9 * term_4
    result[..., 0, 3] = 6.0 * per_cubic * position * sigma_r_squared * sum_3 * term_5
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = sigma_r_squared * sum_10 * term_4
    result[..., 1, 2] = sigma_r_squared * sum_11 * term_5
    result[..., 1, 3] = per_cubic * sigma_r_squared * sum_12 * term_6
    result[..., 2, 0] = result[..., 0, 2]
    result[..., 2, 1] = result[..., 1, 2]
    result[..., 2, 2] = sigma_r_squared * sum_13 * term_6
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

    Accuracy: at most 7 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
    """
    arguments = _floats(k, j, T, tau)
    k, j, T, tau = arguments
    span = (1.0 + k) * (k - 1.0)
    sum_1 = k - 2.0
    bend = (2.0 + k) * sum_1
    middle = 0.5 * k - 0.5
    position = middle + tau
    reach = -(k - 1.0 + tau) * tau
    scan_position = j - 0.5 - 0.5 * k
    scan_reach = (k - j) * (j - 1.0)
    per_constant = 1.0 / k
    term_1 = per_constant
    term_2 = 1.0 / span
    per_slope = 12.0 * term_1 * term_2
    term_3 = 1.0 / bend
    per_curvature = 180.0 * term_1 * term_2 * term_3
    sum_2 = k - 3.0
    per_cubic = 2800.0 * term_1 * term_2 * term_3 / ((3.0 + k) * sum_2)
    product_1 = sum_1 * sum_2 / 10.0
    sum_3 = product_1 - scan_reach
    position_squared = position**2
    scan_position_squared = scan_position**2
    sum_4 = scan_position_squared - span / 12.0
    sum_5 = 7.0 / 20.0 - 3.0 * k**2 / 20.0 + 3.0 * position_squared
    sum_6 = (
        2.0 * per_curvature * position * sum_4
        + per_cubic * scan_position * sum_3 * sum_5
        + per_slope * scan_position
    )
    sum_7 = 2.0 * scan_position_squared - span / 6.0
    sum_8 = 6.0 * per_cubic * position * scan_position * sum_3 + per_curvature * sum_7
    result = _empty(arguments, (4,))
    result[..., 0] = (
        per_constant
        + per_cubic * position * (product_1 - reach) * scan_position * sum_3
        + per_curvature * (position_squared - span / 12.0) * sum_4
        + per_slope * position * scan_position
    )
    result[..., 1] = sum_6 / T
    result[..., 2] = sum_8 / T**2
    result[..., 3] = 6.0 * per_cubic * scan_position * sum_3 / (T * T**2)
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

    Accuracy: at most 2.5 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
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

    Accuracy: at most 2.5 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
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

    Accuracy: at most 4.5 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
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

    Accuracy: at most 6.5 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
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

    Accuracy: at most 2.5 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
    """
    arguments = _floats(k, C)
    k, C = arguments
    k_squared = k**2
    k_squared_squared = k_squared**2
    C_squared = C**2
    k_squared_cubed = k_squared * k_squared**2
    sum_1 = (
        1020.0 * C
        - 36.0
        - 14.0 * k_squared_squared
        - 6720.0 * C_squared
        - 800.0 * C * k_squared
        + 1680.0 * C_squared * k_squared
        + 180.0 * C * k_squared_squared
        + 49.0 * k_squared
        + k_squared_cubed
    )
    term_1 = 1.0 / sum_1
    sum_2 = 60.0 * C - 4.0 + k_squared
    term_2 = 1.0 / sum_2
    term_3 = 1.0 / sum_1**2
    term_4 = 1.0 / sum_2**2
    product_1 = k * k_squared
    product_2 = C * C_squared
    product_3 = k * k_squared**2
    product_4 = k * k_squared * k_squared**2
    sum_3 = (
        10080.0 * C
        - 576.0
        - 104.0 * (k_squared**2)**2
        - 1072.0 * k_squared
        - 1192.0 * product_1
        - 179040.0 * C_squared * k_squared
        - 22080.0 * C * k_squared_squared
        - 27840.0 * C_squared * product_1
        - 403200.0 * product_2
        - 403200.0 * k * product_2
        - 4320.0 * C_squared
        - 44160.0 * C * k
        - 54720.0 * C_squared * k_squared_squared
        - 840.0 * product_3
        - 9480.0 * C * k_squared_cubed
        + 100800.0 * k_squared * product_2
        + 100800.0 * product_1 * product_2
        + 15960.0 * C * product_3
        + 16.0 * k * (k_squared**2)**2
        + 1680.0 * k_squared_squared
        + 17640.0 * C * product_1
        + 1824.0 * k
        + 192.0 * product_4
        + 2160.0 * C * product_4
        + 27480.0 * C * k_squared
        + 298080.0 * C_squared * k
        + 46080.0 * C_squared * product_3
        + 72.0 * k_squared_cubed
    )
    sum_4 = (
        103680.0 * C * product_3
        - 8800.0
        - 1209600.0 * C_squared
        - 15800.0 * product_1
        - 1800.0 * product_3
        - 2721600.0 * C_squared * k_squared
        - 313920.0 * C * k_squared_squared
        - 383520.0 * C * k
        - 4200.0 * k_squared_cubed
        - 7400.0 * k_squared
        + 1200.0 * product_4
        + 15200.0 * k
        + 164160.0 * C * product_1
        + 19200.0 * k_squared_squared
        + 206880.0 * C
        + 2419200.0 * C_squared * k
        + 300960.0 * C * k_squared
        + 907200.0 * C_squared * product_1
    )
    sum_5 = k - 1.0
    sum_6 = (
        60.0
        - 11.0 * k_squared
        - 1164.0 * C * product_1
        - 1356.0 * C
        - 18.0 * product_3
        - 234.0 * C * k_squared
        - 25.0 * k_squared_squared
        - 32.0 * k
        - 5040.0 * C_squared * k
        + 5040.0 * C_squared * k_squared
        + 582.0 * C * k_squared_squared
        + 6.0 * k_squared_cubed
        + 7560.0 * C_squared
        + 80.0 * product_1
        + 816.0 * C * k
    )
    term_5 = 1.0 / sum_5
    sum_7 = (
        74880.0
        - 110880.0 * k_squared_squared
        - 1483200.0 * C * k_squared
        - 1987200.0 * C
        - 201600.0 * k
        - 3628800.0 * C * product_1
        - 36288000.0 * C_squared * k
        - 50400.0 * product_3
        + 10080.0 * k_squared
        + 13305600.0 * C_squared
        + 19353600.0 * C_squared * k_squared
        + 1944000.0 * C * k_squared_squared
        + 252000.0 * product_1
        + 25920.0 * k_squared_cubed
        + 5443200.0 * C * k
    )
    sum_8 = (
        100800.0 * C_squared * product_1
        - 5760.0
        - 1713600.0 * C_squared * k_squared
        - 18480.0 * product_1
        - 198000.0 * C * k_squared_squared
        - 2640.0 * k_squared_cubed
        - 3360.0 * k_squared
        - 417600.0 * C * k
        - 705600.0 * C_squared
        + 11760.0 * k_squared_squared
        + 129600.0 * C
        + 16320.0 * k
        + 1680.0 * product_3
        + 171600.0 * C * k_squared
        + 254400.0 * C * product_1
        + 2620800.0 * C_squared * k
        + 36000.0 * C * product_3
        + 480.0 * product_4
    )
    sum_9 = 100800.0 * k_squared - 100800.0 + 1209600.0 * C
    sum_10 = 6.0 - 4.0 * k_squared - 60.0 * C + k + product_1
    sum_11 = (
        24000.0
        - 12600.0 * product_3
        - 136800.0 * C * k_squared
        - 21000.0 * k_squared_squared
        - 50400.0 * k
        - 590400.0 * C
        - 8400.0 * k_squared
        - 907200.0 * C * product_1
        - 9072000.0 * C_squared * k
        + 1360800.0 * C * k
        + 3628800.0 * C_squared
        + 3628800.0 * C_squared * k_squared
        + 417600.0 * C * k_squared_squared
        + 5400.0 * k_squared_cubed
        + 63000.0 * product_1
    )
    sum_12 = (
        18480.0
        - 15120.0 * k_squared
        - 201600.0 * C
        - 6720.0 * k
        + 10080.0 * product_1
        + 100800.0 * C * k
    )
    sum_13 = 50400.0 * k_squared - 50400.0 + 604800.0 * C
    result = _empty(arguments, (4, 4))
    result[..., 0, 0] = 1.0
    result[..., 0, 1] = 20.0 * (k - 2.0) * sum_5 * sum_6 * term_1 * term_2 / np.sqrt(sum_3 * sum_4 * term_3 * term_4)
    result[..., 0, 2] = sum_8 * term_1 * term_2 / np.sqrt(sum_3 * sum_7 * term_3 * term_4 * term_5)
    result[..., 0, 3] = 840.0 * sum_10 * sum_5 * term_1 / np.sqrt(sum_3 * sum_9 * term_2 * term_3 * term_5)
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = 1.0
    result[..., 1, 2] = sum_11 * term_1 * term_2 / np.sqrt(sum_4 * sum_7 * term_3 * term_4 * term_5)
    result[..., 1, 3] = sum_12 * term_1 / np.sqrt(sum_4 * sum_9 * term_2 * term_3 * term_5)
    result[..., 2, 0] = result[..., 0, 2]
    result[..., 2, 1] = result[..., 1, 2]
    result[..., 2, 2] = 1.0
    result[..., 2, 3] = sum_13 * term_1 / np.sqrt(sum_7 * sum_9 * term_2 * term_3 / sum_5**2)
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

    Accuracy: at most 8 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
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
    scan_position_squared = scan_position**2
    sum_5 = scan_position_squared - span / 12.0
    sum_6 = 3.0 * k / 10.0 - 1.0 / 10.0 + (6.0 * k - 6.0) * sum_2 / 10.0
    sum_7 = range_share * sum_6 + 0.5 * rate_share * sum_1 * sum_2
    sum_8 = (
        2.0 * middle * per_curvature * sum_5
        + per_cubic * scan_position * sum_4 * sum_7
        + per_slope * scan_position
    )
    sum_9 = 2.0 * scan_position_squared - span / 6.0
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

    Accuracy: at most 8.5 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
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
    term_2 = 1.0 / k
    per_slope = 12.0 * term_1 * term_2
    term_3 = 1.0 / span
    per_curvature = 180.0 * term_2 * term_3 / (60.0 * C + bend)
    sum_3 = k - 3.0
    k_squared = k**2
    per_cubic = term_2 * term_3 / (C * bend / 20.0 + bend * (3.0 + k) * sum_3 / 2800.0 + (1.0 + k_squared)**2 * rate_share / 1200.0)
    sum_4 = 3.0 * k_squared / 20.0 - 7.0 / 20.0
    scan_position_squared = scan_position**2
    sum_5 = 3.0 * scan_position_squared - range_share * sum_4 - 0.25 * rate_share * span
    sum_6 = range_share * sum_2 * sum_3 / 10.0 + (0.5 - 0.5 * k) * rate_share
    sum_7 = (
        middle * per_cubic * sum_5 * sum_6
        + middle * per_slope
        + per_curvature * scan_position * sum_1 * sum_2 / 3.0
    )
    sum_8 = 3.0 * k / 10.0 - 1.0 / 10.0 + (6.0 * k - 6.0) * sum_2 / 10.0
    sum_9 = range_share * sum_8 + 0.5 * rate_share * sum_1 * sum_2
    sum_10 = 4.0 * middle * per_curvature * scan_position + per_cubic * sum_5 * sum_9 + per_slope
    sum_11 = 4.0 * per_curvature * scan_position + 6.0 * middle * per_cubic * sum_5
    sum_12 = 18.0 * scan_position_squared - 1.5 * rate_share * span - 6.0 * range_share * sum_4
    result = _empty(arguments, (4,))
    result[..., 0] = C * T * sum_7
    result[..., 1] = C * sum_10
    result[..., 2] = C * sum_11 / T
    result[..., 3] = C * per_cubic * sum_12 / T**2
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

    Accuracy: at most 6 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
    """
    arguments = _floats(k, T, sigma_r, C, tau)
    k, T, sigma_r, C, tau = arguments
    span = (1.0 + k) * (k - 1.0)
    sum_1 = k - 2.0
    bend = (2.0 + k) * sum_1
    term_1 = 1.0 / (12.0 * C + span)
    range_share = span * term_1
    rate_share = 12.0 * C * term_1
    middle = 0.5 * k - 0.5
    position = middle + tau
    reach = -(k - 1.0 + tau) * tau
    per_constant = 1.0 / k
    term_2 = per_constant
    per_slope = 12.0 * term_1 * term_2
    term_3 = 1.0 / span
    per_curvature = 180.0 * term_2 * term_3 / (60.0 * C + bend)
    sum_2 = k - 3.0
    k_squared = k**2
    per_cubic = term_2 * term_3 / (C * bend / 20.0 + bend * (3.0 + k) * sum_2 / 2800.0 + (1.0 + k_squared)**2 * rate_share / 1200.0)
    sum_3 = range_share * sum_1 * sum_2 / 10.0 - reach + (0.5 - 0.5 * k) * rate_share
    position_squared = position**2
    sum_4 = position_squared - span / 12.0
    sigma_r_squared = sigma_r**2
    sum_5 = (
        per_constant
        + per_cubic * position_squared * sum_3**2
        + per_curvature * sum_4**2
        + per_slope * position_squared
    )
    sum_6 = 3.0 * k_squared / 20.0 - 7.0 / 20.0
    sum_7 = 3.0 * position_squared - range_share * sum_6 - 0.25 * rate_share * span
    sum_8 = (
        2.0 * per_curvature * position * sum_4
        + per_cubic * position * sum_3 * sum_7
        + per_slope * position
    )
    sum_9 = 2.0 * position_squared - span / 6.0
    term_4 = 1.0 / T**2
    sum_10 = 6.0 * per_cubic * position_squared * sum_3 + per_curvature * sum_9
    term_5 = 1.0 / (T * T**2)
    sum_11 = 4.0 * per_curvature * position_squared + per_cubic * sum_7**2 + per_slope
    sum_12 = 4.0 * per_curvature * position + 6.0 * per_cubic * position * sum_7
    term_6 = 1.0 / (T**2)**2
    sum_13 = 18.0 * position_squared - 1.5 * rate_share * span - 6.0 * range_share * sum_6
    sum_14 = 36.0 * per_cubic * position_squared + 4.0 * per_curvature
    result = _empty(arguments, (4, 4))
    result[..., 0, 0] = sigma_r_squared * sum_5
    result[..., 0, 1] = sigma_r_squared * sum_8 / T
    result[..., 0, 2] = sigma_r_squared * sum_10 * term_4
    result[..., 0, 3] = 6.0 * per_cubic * position * sigma_r_squared * sum_3 * term_5
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = sigma_r_squared * sum_11 * term_4
    result[..., 1, 2] = sigma_r_squared * sum_12 * term_5
    result[..., 1, 3] = per_cubic * sigma_r_squared * sum_13 * term_6
    result[..., 2, 0] = result[..., 0, 2]
    result[..., 2, 1] = result[..., 1, 2]
    result[..., 2, 2] = sigma_r_squared * sum_14 * term_6
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

    Accuracy: at most 9 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
    """
    arguments = _floats(k, j, T, C, tau)
    k, j, T, C, tau = arguments
    span = (1.0 + k) * (k - 1.0)
    sum_1 = k - 2.0
    bend = (2.0 + k) * sum_1
    term_1 = 1.0 / (12.0 * C + span)
    range_share = span * term_1
    rate_share = 12.0 * C * term_1
    middle = 0.5 * k - 0.5
    position = middle + tau
    reach = -(k - 1.0 + tau) * tau
    scan_position = j - 0.5 - 0.5 * k
    scan_reach = (k - j) * (j - 1.0)
    per_constant = 1.0 / k
    term_2 = per_constant
    per_slope = 12.0 * term_1 * term_2
    term_3 = 1.0 / span
    per_curvature = 180.0 * term_2 * term_3 / (60.0 * C + bend)
    sum_2 = k - 3.0
    k_squared = k**2
    per_cubic = term_2 * term_3 / (C * bend / 20.0 + bend * (3.0 + k) * sum_2 / 2800.0 + (1.0 + k_squared)**2 * rate_share / 1200.0)
    product_1 = range_share * sum_1 * sum_2 / 10.0
    product_2 = (0.5 - 0.5 * k) * rate_share
    sum_3 = product_1 - scan_reach + product_2
    position_squared = position**2
    scan_position_squared = scan_position**2
    sum_4 = scan_position_squared - span / 12.0
    sum_5 = 3.0 * k_squared / 20.0 - 7.0 / 20.0
    sum_6 = 3.0 * position_squared - range_share * sum_5 - 0.25 * rate_share * span
    sum_7 = (
        2.0 * per_curvature * position * sum_4
        + per_cubic * scan_position * sum_3 * sum_6
        + per_slope * scan_position
    )
    sum_8 = 2.0 * scan_position_squared - span / 6.0
    sum_9 = 6.0 * per_cubic * position * scan_position * sum_3 + per_curvature * sum_8
    result = _empty(arguments, (4,))
    result[..., 0] = (
        per_constant
        + per_cubic * position * (product_1 - reach + product_2) * scan_position * sum_3
        + per_curvature * (position_squared - span / 12.0) * sum_4
        + per_slope * position * scan_position
    )
    result[..., 1] = sum_7 / T
    result[..., 2] = sum_9 / T**2
    result[..., 3] = 6.0 * per_cubic * scan_position * sum_3 / (T * T**2)
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

    Accuracy: at most 12 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
    """
    arguments = _floats(k, j, T, C, tau)
    k, j, T, C, tau = arguments
    span = (1.0 + k) * (k - 1.0)
    sum_1 = k - 2.0
    bend = (2.0 + k) * sum_1
    term_1 = 1.0 / (12.0 * C + span)
    range_share = span * term_1
    rate_share = 12.0 * C * term_1
    middle = 0.5 * k - 0.5
    position = middle + tau
    reach = -(k - 1.0 + tau) * tau
    scan_position = j - 0.5 - 0.5 * k
    term_2 = 1.0 / k
    per_slope = 12.0 * term_1 * term_2
    term_3 = 1.0 / span
    per_curvature = 180.0 * term_2 * term_3 / (60.0 * C + bend)
    sum_2 = k - 3.0
    k_squared = k**2
    per_cubic = term_2 * term_3 / (C * bend / 20.0 + bend * (3.0 + k) * sum_2 / 2800.0 + (1.0 + k_squared)**2 * rate_share / 1200.0)
    position_squared = position**2
    sum_3 = 3.0 * k_squared / 20.0 - 7.0 / 20.0
    product_1 = -range_share * sum_3
    product_2 = -0.25 * rate_share * span
    scan_position_squared = scan_position**2
    sum_4 = 3.0 * scan_position_squared + product_1 + product_2
    sum_5 = range_share * sum_1 * sum_2 / 10.0 - reach + (0.5 - 0.5 * k) * rate_share
    sum_6 = (
        2.0 * per_curvature * (position_squared - span / 12.0) * scan_position
        + per_cubic * position * sum_4 * sum_5
        + per_slope * position
    )
    sum_7 = 3.0 * position_squared + product_1 + product_2
    sum_8 = 4.0 * per_curvature * position * scan_position + per_cubic * sum_4 * sum_7 + per_slope
    sum_9 = 4.0 * per_curvature * scan_position + 6.0 * per_cubic * position * sum_4
    sum_10 = 18.0 * scan_position_squared - 1.5 * rate_share * span - 6.0 * range_share * sum_3
    result = _empty(arguments, (4,))
    result[..., 0] = C * T * sum_6
    result[..., 1] = C * sum_8
    result[..., 2] = C * sum_9 / T
    result[..., 3] = C * per_cubic * sum_10 / T**2
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

    Accuracy: at most 13 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
    """
    arguments = _floats(k, C)
    k, C = arguments
    k_squared = k**2
    k_squared_squared = k_squared**2
    C_squared = C**2
    k_squared_cubed = k_squared * k_squared**2
    term_1 = 1.0 / (1020.0 * C - 36.0 - 14.0 * k_squared_squared - 6720.0 * C_squared - 800.0 * C * k_squared + 1680.0 * C_squared * k_squared + 180.0 * C * k_squared_squared + 49.0 * k_squared + k_squared_cubed)
    term_2 = 1.0 / (2.0 * k - 1.0)
    term_3 = 1.0 / (60.0 * C - 4.0 + k_squared)
    term_4 = 1.0 / (3.0 - k + k_squared)
    product_1 = k * k_squared**2
    term_5 = (k_squared**2)**2
    product_2 = k * k_squared
    product_3 = C * C_squared
    product_4 = k * (k_squared**2)**2
    product_5 = k * k_squared * k_squared**2
    sum_1 = (
        1260.0 * C
        - 72.0
        - 105.0 * product_1
        - 1185.0 * C * k_squared_cubed
        - 13.0 * term_5
        - 134.0 * k_squared
        - 149.0 * product_2
        - 22380.0 * C_squared * k_squared
        - 2760.0 * C * k_squared_squared
        - 3480.0 * C_squared * product_2
        - 50400.0 * product_3
        - 50400.0 * k * product_3
        - 540.0 * C_squared
        - 5520.0 * C * k
        - 6840.0 * C_squared * k_squared_squared
        + 12600.0 * k_squared * product_3
        + 12600.0 * product_2 * product_3
        + 1995.0 * C * product_1
        + 2.0 * product_4
        + 210.0 * k_squared_squared
        + 2205.0 * C * product_2
        + 228.0 * k
        + 24.0 * product_5
        + 270.0 * C * product_5
        + 3435.0 * C * k_squared
        + 37260.0 * C_squared * k
        + 5760.0 * C_squared * product_1
        + 9.0 * k_squared_cubed
    )
    term_6 = np.sqrt(2.0 + k)
    term_7 = np.sqrt(3.0 + k)
    sum_2 = k - 1.0
    sum_3 = k - 2.0
    sum_4 = (
        1116.0
        - 12.0 * k
        - 15240.0 * C * product_2
        - 26100.0 * C
        - 279.0 * k_squared
        - 360.0 * C * k_squared_squared
        - 383.0 * product_1
        - 51.0 * k_squared_cubed
        + 151200.0 * C_squared
        + 204.0 * k_squared_squared
        + 37800.0 * C_squared * k_squared
        + 37800.0 * C_squared * product_2
        + 3840.0 * C * product_1
        + 42.0 * product_5
        + 420.0 * C * k
        + 540.0 * C * k_squared
        + 863.0 * product_2
    )
    term_8 = 1.0 / (11.0 - 27.0 * product_2 - 30.0 * k + 42.0 * k_squared + 6.0 * k_squared_squared)
    sum_5 = k - 3.0
    sum_6 = (
        22680.0 * C_squared * product_2
        - 220.0
        - 105.0 * k_squared_cubed
        - 185.0 * k_squared
        - 30240.0 * C_squared
        - 395.0 * product_2
        - 45.0 * product_1
        - 68040.0 * C_squared * k_squared
        - 7848.0 * C * k_squared_squared
        - 9588.0 * C * k
        + 2592.0 * C * product_1
        + 30.0 * product_5
        + 380.0 * k
        + 4104.0 * C * product_2
        + 480.0 * k_squared_squared
        + 5172.0 * C
        + 60480.0 * C_squared * k
        + 7524.0 * C * k_squared
    )
    sum_7 = (
        101160.0 * k
        - 39252.0
        - 147060.0 * C * product_2
        - 19782000.0 * C_squared * k_squared
        - 2187390.0 * C * k_squared_squared
        - 2486520.0 * C * k
        - 3402000.0 * C_squared * product_1
        - 398520.0 * C * product_5
        - 40710.0 * product_2
        - 47106.0 * k_squared_cubed
        - 51765.0 * product_1
        - 5490.0 * product_4
        - 5544000.0 * C_squared
        - 91951.0 * k_squared
        + 1152.0 * k_squared * (k_squared**2)**2
        + 1333440.0 * C * product_1
        + 134761.0 * k_squared_squared
        + 15120000.0 * C_squared * k
        + 2268000.0 * C_squared * k_squared_squared
        + 235980.0 * C * k_squared_cubed
        + 2721000.0 * C * k_squared
        + 336.0 * term_5
        + 35865.0 * product_5
        + 756000.0 * C_squared * k_squared_cubed
        + 87930.0 * C * term_5
        + 938940.0 * C
        + 9828000.0 * C_squared * product_2
    )
    term_9 = 1.0 / (9.0 * k - 13.0)
    sum_8 = (
        52.0
        - 1030.0 * C * k_squared
        - 1380.0 * C
        - 140.0 * k
        - 2520.0 * C * product_2
        - 25200.0 * C_squared * k
        - 35.0 * product_1
        - 77.0 * k_squared_squared
        + 13440.0 * C_squared * k_squared
        + 1350.0 * C * k_squared_squared
        + 175.0 * product_2
        + 18.0 * k_squared_cubed
        + 3780.0 * C * k
        + 7.0 * k_squared
        + 9240.0 * C_squared
    )
    sum_9 = (
        1411200.0 * C_squared * k
        - 3144.0
        - 10.0 * k_squared
        - 11074.0 * product_2
        - 2078.0 * k_squared_cubed
        - 217560.0 * C * k
        - 352800.0 * C_squared * product_2
        - 41160.0 * C * product_1
        - 524160.0 * C_squared
        - 588.0 * product_5
        - 594720.0 * C_squared * k_squared
        - 77820.0 * C * k_squared_squared
        + 181440.0 * C_squared * k_squared_squared
        + 182280.0 * C * product_2
        + 21120.0 * C * k_squared_cubed
        + 297.0 * term_5
        + 3759.0 * k_squared_squared
        + 42300.0 * C * k_squared
        + 4606.0 * product_1
        + 81240.0 * C
        + 8232.0 * k
    )
    sum_10 = 21.0 - 23.0 * k_squared - 240.0 * C + 6.0 * k_squared_squared + 60.0 * C * k_squared
    result = _empty(arguments, (4,))
    result[..., 0] = 5.0 * C * sum_2 * sum_3 * sum_4 * term_1 * term_2 * term_3 * term_4 / (1.0 + np.sqrt(sum_1 * term_1 * term_2 * term_3 * term_4) * term_6 * term_7)
    result[..., 1] = 4.0 * C * sum_7 * term_1 * term_3 * term_8 / ((1.0 + np.sqrt(5.0) * np.sqrt(sum_2 * sum_3 * sum_5 * sum_6 * term_1 * term_3 * term_8) * term_6 * term_7 / 5.0) * 5.0)
    result[..., 2] = 10.0 * C * sum_9 * term_1 * term_2 * term_3 * term_9 / (1.0 + np.sqrt(sum_3 * sum_5 * sum_8 * term_1 * term_2 * term_3 * term_9) * term_6 * term_7)
    result[..., 3] = 28.0 * C * sum_10 * term_1 / (1.0 + np.sqrt((12.0 * C - 1.0 + k_squared) * sum_3 * sum_5 * term_1) * term_6 * term_7)
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

    Accuracy: at most 2.5 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
    """
    arguments = _floats(k)
    k, = arguments
    term_1 = 1.0 / (2.0 * k - 1.0)
    k_squared = k**2
    term_2 = 1.0 / (3.0 - k + k_squared)
    result = _empty(arguments, ())
    result[...] = 1.875 * (k - 1.0) * (2.0 - k + k_squared) * term_1 * term_2 / (1.0 + 0.25 * np.sqrt(2.0) * np.sqrt(1.0 + k) * np.sqrt(2.0 + k) * np.sqrt(3.0 + k) * np.sqrt(term_1 * term_2))
    return result[()]
