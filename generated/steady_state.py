"""NumPy functions of the quantities steady_state.*.

Written by radartrack regenerate, generator 1, derivation a2f11a633a73485c; not to be edited.
"""

import numpy as np
import numpy.typing as npt

__all__ = [
    "alpha_beta_covariance",
    "alpha_beta_gain",
    "alpha_beta_gamma_covariance",
    "alpha_beta_gamma_gain",
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


def _third(x: Floats) -> Floats:
    """The positive root c of 4 c^3 - 3 c = x, a cosine or hyperbolic cosine and a step of Newton's."""
    wide, flat = np.maximum(x, 1.0), np.minimum(x, 1.0)
    c = np.where(x > 1.0, np.cosh(np.arccosh(wide) / 3.0), np.cos(np.arccos(flat) / 3.0))
    return c - ((4.0 * c**2 - 3.0) * c - x) / (12.0 * c**2 - 3.0)


def alpha_beta_gain(*, index: npt.ArrayLike) -> Floats:
    """Alpha and beta, the steady gains times 1, T, ... of a filter of position and velocity, with an acceleration that is constant over a period.

    Name: steady_state.alpha_beta.gain.
    Definition: K = P H'/(H P H' + sigma_r^2), P = F (1 - K H) P F' + Q.
    Conditioning: no expectation is taken.
    Source: Kalata 1984, doi:10.1109/TAES.1984.310438.

    Args:
        index: tracking index T^2 sigma_w/sigma_r [1], 1e-09 to 1000.

    Returns:
        Shape of the broadcast arguments + (2), unit 1.

    Accuracy: at most 12.1 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 12.1. Errors are measured against
    itself.
    """
    arguments = _floats(index)
    index, = arguments
    w = np.sqrt(1.0 + 8.0 / index)
    term_1 = 1.0 / (1.0 + w)**2
    result = _empty(arguments, (2,))
    result[..., 0] = 4.0 * term_1 * w
    result[..., 1] = 8.0 * term_1
    return result


def alpha_beta_covariance(*, index: npt.ArrayLike, sigma_r: npt.ArrayLike, T: npt.ArrayLike) -> Floats:
    """Steady error covariance of position and velocity after a measurement, with an acceleration that is constant over a period.

    Name: steady_state.alpha_beta.covariance.
    Definition: (1 - K H) P, P = F (1 - K H) P F' + Q.
    Conditioning: no expectation is taken.
    Source: Kalata 1984, doi:10.1109/TAES.1984.310438.

    Args:
        index: tracking index T^2 sigma_w/sigma_r [1], 1e-09 to 1000.
        sigma_r: standard deviation of the error of a measured position [m], 0.001 to 10000.
        T: time from scan to scan [s], 0.001 to 1000.

    Returns:
        Shape of the broadcast arguments + (2, 2), unit [m, m/s] × [m, m/s].

    Accuracy: at most 15.1 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 15.1.
    """
    arguments = _floats(index, sigma_r, T)
    index, sigma_r, T = arguments
    w = np.sqrt(1.0 + 8.0 / index)
    sum_1 = 1.0 + w
    term_1 = 1.0 / sum_1**2
    sigma_r_squared = sigma_r**2
    result = _empty(arguments, (2, 2))
    result[..., 0, 0] = 4.0 * sigma_r_squared * term_1 * w
    result[..., 0, 1] = 8.0 * sigma_r_squared * term_1 / T
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = 4.0 * index * sigma_r_squared / (sum_1 * T**2)
    return result


def alpha_beta_gamma_gain(*, index: npt.ArrayLike) -> Floats:
    """Alpha, beta and gamma, the steady gains times 1, T, ... of a filter of position, velocity and acceleration, with an acceleration that jumps at each scan.

    Name: steady_state.alpha_beta_gamma.gain.
    Definition: K = P H'/(H P H' + sigma_r^2), P = F (1 - K H) P F' + Q.
    Conditioning: no expectation is taken.
    Source: Kalata 1984, doi:10.1109/TAES.1984.310438.

    Args:
        index: tracking index T^2 sigma_w/sigma_r [1], 1e-09 to 1000.

    Returns:
        Shape of the broadcast arguments + (3), unit 1.

    Accuracy: at most 30.4 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 28.3. Errors are measured against
    itself.
    """
    arguments = _floats(index)
    index, = arguments
    term_1 = np.sqrt(3.0)
    w = 2.0 * term_1 * _third(12.0 * term_1 / index) / 3.0
    term_2 = 1.0 / (1.0 + w)**2
    result = _empty(arguments, (3,))
    result[..., 0] = 4.0 * term_2 * w
    result[..., 1] = 8.0 * term_2
    result[..., 2] = 8.0 * term_2 / w
    return result


def alpha_beta_gamma_covariance(*, index: npt.ArrayLike, sigma_r: npt.ArrayLike, T: npt.ArrayLike) -> Floats:
    """Steady error covariance of position, velocity and acceleration after a measurement, with an acceleration that jumps at each scan.

    Name: steady_state.alpha_beta_gamma.covariance.
    Definition: (1 - K H) P, P = F (1 - K H) P F' + Q.
    Conditioning: no expectation is taken.
    Source: Kalata 1984, doi:10.1109/TAES.1984.310438.

    Args:
        index: tracking index T^2 sigma_w/sigma_r [1], 1e-09 to 1000.
        sigma_r: standard deviation of the error of a measured position [m], 0.001 to 10000.
        T: time from scan to scan [s], 0.001 to 1000.

    Returns:
        Shape of the broadcast arguments + (3, 3), unit [m, m/s, m/s^2] × [m, m/s, m/s^2].

    Accuracy: at most 38.4 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 36.4.
    """
    arguments = _floats(index, sigma_r, T)
    index, sigma_r, T = arguments
    term_1 = np.sqrt(3.0)
    w = 2.0 * term_1 * _third(12.0 * term_1 / index) / 3.0
    sum_1 = 1.0 + w
    term_2 = 1.0 / sum_1**2
    sigma_r_squared = sigma_r**2
    term_3 = 1.0 / w
    term_4 = 1.0 / T**2
    term_5 = 1.0 / sum_1
    result = _empty(arguments, (3, 3))
    result[..., 0, 0] = 4.0 * sigma_r_squared * term_2 * w
    result[..., 0, 1] = 8.0 * sigma_r_squared * term_2 / T
    result[..., 0, 2] = 8.0 * sigma_r_squared * term_2 * term_3 * term_4
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = (3.0 * w - 1.0) * index * sigma_r_squared * term_4 * term_5
    result[..., 1, 2] = 4.0 * index * sigma_r_squared * term_5 / (T * T**2)
    result[..., 2, 0] = result[..., 0, 2]
    result[..., 2, 1] = result[..., 1, 2]
    result[..., 2, 2] = 8.0 * index * sigma_r_squared * term_3 * term_5 / (T**2)**2
    return result
