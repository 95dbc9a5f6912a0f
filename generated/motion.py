"""NumPy functions of the quantities motion.*.

Written by radartrack regenerate, generator 1, derivation bc42b7a19bb1131d; not to be edited.
"""

import numpy as np
import numpy.typing as npt

__all__ = [
    "constant_acceleration_process_noise_continuous",
    "constant_acceleration_process_noise_piecewise",
    "constant_acceleration_process_noise_wiener_sequence",
    "constant_acceleration_transition",
    "constant_jerk_process_noise_continuous",
    "constant_jerk_process_noise_piecewise",
    "constant_jerk_process_noise_wiener_sequence",
    "constant_jerk_transition",
    "constant_position_process_noise_continuous",
    "constant_position_process_noise_piecewise",
    "constant_position_process_noise_wiener_sequence",
    "constant_position_transition",
    "constant_velocity_process_noise_continuous",
    "constant_velocity_process_noise_piecewise",
    "constant_velocity_process_noise_wiener_sequence",
    "constant_velocity_transition",
    "ctrv_hessian",
    "ctrv_jacobian",
    "ctrv_map",
    "ctrv_process_noise_piecewise",
    "ornstein_uhlenbeck_process_noise",
    "ornstein_uhlenbeck_transition",
    "plane_observation",
    "plane_transition",
    "singer_process_noise",
    "singer_transition",
    "turn_known_rate_process_noise_continuous",
    "turn_known_rate_process_noise_piecewise",
    "turn_known_rate_transition",
    "turn_unknown_rate_hessian",
    "turn_unknown_rate_jacobian",
    "turn_unknown_rate_map",
    "turn_unknown_rate_process_noise_piecewise",
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


def _remainder(x: Floats, order: int) -> Floats:
    """e^x less the terms of its series below the order; where these would cancel, by the rest of the series."""
    is_small = np.abs(x) < order
    small, large = np.where(is_small, x, 0.0), np.where(is_small, 0.0, x)
    rest, series, term = np.ones_like(small), np.zeros_like(large), np.ones_like(large)
    for n in range(order + 30, order, -1):
        rest = 1.0 + small * rest / n
    for n in range(order):
        series = series + term
        term = term * large / (n + 1)
        rest = rest * small / (n + 1)
    return np.where(is_small, rest, np.exp(large) - series)


def _stumpff(x: Floats, order: int) -> Floats:
    """1/n! - x^2/(n+2)! + x^4/(n+4)! - ..., by this series; where it is long, by cosine or sine less its beginning."""
    is_small = np.abs(x) < order
    small, large = np.where(is_small, x * x, 0.0), np.where(is_small, 1.0, x)
    series = np.ones_like(small)
    for n in range(order + 30, order, -2):
        series = 1.0 - small * series / (n * (n - 1))
    closed, term = (np.sin(large) / large, 1.0) if order % 2 else (np.cos(large), 1.0)
    for n in range(order % 2, order, 2):
        closed = (term - closed) / large**2
        term /= (n + 1) * (n + 2)
    return np.where(is_small, series * term, closed)


def constant_position_transition(*, T: npt.ArrayLike) -> Floats:
    """Transition of position of one axis from scan to scan.

    Name: motion.constant_position.transition.
    Definition: F = e^(AT).
    Conditioning: no expectation is taken.
    Source: Bar-Shalom, Li & Kirubarajan 2001 6.2-6.3, doi:10.1002/0471221279.

    Args:
        T: time from scan to scan [s], 0.001 to 1000.

    Returns:
        Shape of the broadcast arguments + (1, 1), unit 1.

    Accuracy: at most 0 ulp anywhere in this domain, proved for elementary functions within 1 ulp (float64);
    in float32, with functions within 4 of its ulp, at most 0.
    """
    arguments = _floats(T)
    T, = arguments
    result = _empty(arguments, (1, 1))
    result[..., 0, 0] = 1.0
    return result


def constant_position_process_noise_continuous(*, T: npt.ArrayLike, q: npt.ArrayLike) -> Floats:
    """Covariance of the process noise of position of one axis from scan to scan, with white noise in the velocity.

    Name: motion.constant_position.process_noise.continuous.
    Definition: Q = q int_0^T e^(As) G G' e^(As)' ds.
    Conditioning: no expectation is taken.
    Source: Bar-Shalom, Li & Kirubarajan 2001 6.2-6.3, doi:10.1002/0471221279.

    Args:
        T: time from scan to scan [s], 0.001 to 1000.
        q: intensity of the white noise in the velocity [m^2/s], 1e-09 to 1e+06.

    Returns:
        Shape of the broadcast arguments + (1, 1), unit m^2.

    Accuracy: at most 1.01 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 1.01.
    """
    arguments = _floats(T, q)
    T, q = arguments
    result = _empty(arguments, (1, 1))
    result[..., 0, 0] = T * q
    return result


def constant_position_process_noise_piecewise(*, T: npt.ArrayLike, sigma_w: npt.ArrayLike) -> Floats:
    """Covariance of the process noise of position of one axis from scan to scan, with a velocity that is noise, constant over a period.

    Name: motion.constant_position.process_noise.piecewise.
    Definition: Q = sigma_w^2 g g', g = int_0^T e^(As) G ds.
    Conditioning: no expectation is taken.
    Source: Bar-Shalom, Li & Kirubarajan 2001 6.2-6.3, doi:10.1002/0471221279.

    Args:
        T: time from scan to scan [s], 0.001 to 1000.
        sigma_w: standard deviation of the velocity, constant over a period [m/s], 1e-06 to 1000.

    Returns:
        Shape of the broadcast arguments + (1, 1), unit m^2.

    Accuracy: at most 5.01 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 5.01.
    """
    arguments = _floats(T, sigma_w)
    T, sigma_w = arguments
    result = _empty(arguments, (1, 1))
    result[..., 0, 0] = T**2 * sigma_w**2
    return result


def constant_position_process_noise_wiener_sequence(*, T: npt.ArrayLike, sigma_w: npt.ArrayLike) -> Floats:
    """Covariance of the process noise of position of one axis from scan to scan, with jumps of the position at each scan, a Wiener sequence.

    Name: motion.constant_position.process_noise.wiener_sequence.
    Definition: Q = sigma_w^2 F G (F G)'.
    Conditioning: no expectation is taken.
    Source: Bar-Shalom, Li & Kirubarajan 2001 6.2-6.3, doi:10.1002/0471221279.

    Args:
        T: time from scan to scan [s], 0.001 to 1000.
        sigma_w: standard deviation of the jump of the position at a scan [m], 1e-06 to 1000.

    Returns:
        Shape of the broadcast arguments + (1, 1), unit m^2.

    Accuracy: at most 2.01 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 2.01.
    """
    arguments = _floats(T, sigma_w)
    T, sigma_w = arguments
    result = _empty(arguments, (1, 1))
    result[..., 0, 0] = sigma_w**2
    return result


def constant_velocity_transition(*, T: npt.ArrayLike) -> Floats:
    """Transition of position and velocity of one axis from scan to scan.

    Name: motion.constant_velocity.transition.
    Definition: F = e^(AT).
    Conditioning: no expectation is taken.
    Source: Bar-Shalom, Li & Kirubarajan 2001 6.2-6.3, doi:10.1002/0471221279.

    Args:
        T: time from scan to scan [s], 0.001 to 1000.

    Returns:
        Shape of the broadcast arguments + (2, 2), unit [m, m/s] × [1/m, s/m].

    Accuracy: at most 0 ulp anywhere in this domain, proved for elementary functions within 1 ulp (float64);
    in float32, with functions within 4 of its ulp, at most 0.
    """
    arguments = _floats(T)
    T, = arguments
    result = _empty(arguments, (2, 2))
    result[..., 0, 0] = 1.0
    result[..., 0, 1] = T
    result[..., 1, 0] = 0.0
    result[..., 1, 1] = 1.0
    return result


def constant_velocity_process_noise_continuous(*, T: npt.ArrayLike, q: npt.ArrayLike) -> Floats:
    """Covariance of the process noise of position and velocity of one axis from scan to scan, with white noise in the acceleration.

    Name: motion.constant_velocity.process_noise.continuous.
    Definition: Q = q int_0^T e^(As) G G' e^(As)' ds.
    Conditioning: no expectation is taken.
    Source: Bar-Shalom, Li & Kirubarajan 2001 6.2-6.3, doi:10.1002/0471221279.

    Args:
        T: time from scan to scan [s], 0.001 to 1000.
        q: intensity of the white noise in the acceleration [m^2/s^3], 1e-09 to 1e+06.

    Returns:
        Shape of the broadcast arguments + (2, 2), unit [m, m/s] × [m, m/s].

    Accuracy: at most 5.01 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 5.01.
    """
    arguments = _floats(T, q)
    T, q = arguments
    T_squared = T**2
    result = _empty(arguments, (2, 2))
    result[..., 0, 0] = T * T_squared * q / 3.0
    result[..., 0, 1] = 0.5 * T_squared * q
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = T * q
    return result


def constant_velocity_process_noise_piecewise(*, T: npt.ArrayLike, sigma_w: npt.ArrayLike) -> Floats:
    """Covariance of the process noise of position and velocity of one axis from scan to scan, with an acceleration that is noise, constant over a period.

    Name: motion.constant_velocity.process_noise.piecewise.
    Definition: Q = sigma_w^2 g g', g = int_0^T e^(As) G ds.
    Conditioning: no expectation is taken.
    Source: Bar-Shalom, Li & Kirubarajan 2001 6.2-6.3, doi:10.1002/0471221279.

    Args:
        T: time from scan to scan [s], 0.001 to 1000.
        sigma_w: standard deviation of the acceleration, constant over a period [m/s^2], 1e-06 to 1000.

    Returns:
        Shape of the broadcast arguments + (2, 2), unit [m, m/s] × [m, m/s].

    Accuracy: at most 9.01 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 9.01.
    """
    arguments = _floats(T, sigma_w)
    T, sigma_w = arguments
    T_squared = T**2
    sigma_w_squared = sigma_w**2
    result = _empty(arguments, (2, 2))
    result[..., 0, 0] = 0.25 * T_squared**2 * sigma_w_squared
    result[..., 0, 1] = 0.5 * T * T_squared * sigma_w_squared
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = T_squared * sigma_w_squared
    return result


def constant_velocity_process_noise_wiener_sequence(*, T: npt.ArrayLike, sigma_w: npt.ArrayLike) -> Floats:
    """Covariance of the process noise of position and velocity of one axis from scan to scan, with jumps of the velocity at each scan, a Wiener sequence.

    Name: motion.constant_velocity.process_noise.wiener_sequence.
    Definition: Q = sigma_w^2 F G (F G)'.
    Conditioning: no expectation is taken.
    Source: Bar-Shalom, Li & Kirubarajan 2001 6.2-6.3, doi:10.1002/0471221279.

    Args:
        T: time from scan to scan [s], 0.001 to 1000.
        sigma_w: standard deviation of the jump of the velocity at a scan [m/s], 1e-06 to 1000.

    Returns:
        Shape of the broadcast arguments + (2, 2), unit [m, m/s] × [m, m/s].

    Accuracy: at most 5.01 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 5.01.
    """
    arguments = _floats(T, sigma_w)
    T, sigma_w = arguments
    sigma_w_squared = sigma_w**2
    result = _empty(arguments, (2, 2))
    result[..., 0, 0] = T**2 * sigma_w_squared
    result[..., 0, 1] = T * sigma_w_squared
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = sigma_w_squared
    return result


def constant_acceleration_transition(*, T: npt.ArrayLike) -> Floats:
    """Transition of position, velocity and acceleration of one axis from scan to scan.

    Name: motion.constant_acceleration.transition.
    Definition: F = e^(AT).
    Conditioning: no expectation is taken.
    Source: Bar-Shalom, Li & Kirubarajan 2001 6.2-6.3, doi:10.1002/0471221279.

    Args:
        T: time from scan to scan [s], 0.001 to 1000.

    Returns:
        Shape of the broadcast arguments + (3, 3), unit [m, m/s, m/s^2] × [1/m, s/m, s^2/m].

    Accuracy: at most 2.01 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 2.01.
    """
    arguments = _floats(T)
    T, = arguments
    result = _empty(arguments, (3, 3))
    result[..., 0, 0] = 1.0
    result[..., 0, 1] = T
    result[..., 0, 2] = 0.5 * T**2
    result[..., 1, 0] = 0.0
    result[..., 1, 1] = 1.0
    result[..., 1, 2] = T
    result[..., 2, 0] = 0.0
    result[..., 2, 1] = 0.0
    result[..., 2, 2] = 1.0
    return result


def constant_acceleration_process_noise_continuous(*, T: npt.ArrayLike, q: npt.ArrayLike) -> Floats:
    """Covariance of the process noise of position, velocity and acceleration of one axis from scan to scan, with white noise in the jerk.

    Name: motion.constant_acceleration.process_noise.continuous.
    Definition: Q = q int_0^T e^(As) G G' e^(As)' ds.
    Conditioning: no expectation is taken.
    Source: Bar-Shalom, Li & Kirubarajan 2001 6.2-6.3, doi:10.1002/0471221279.

    Args:
        T: time from scan to scan [s], 0.001 to 1000.
        q: intensity of the white noise in the jerk [m^2/s^5], 1e-09 to 1e+06.

    Returns:
        Shape of the broadcast arguments + (3, 3), unit [m, m/s, m/s^2] × [m, m/s, m/s^2].

    Accuracy: at most 9.01 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 9.01.
    """
    arguments = _floats(T, q)
    T, q = arguments
    T_squared = T**2
    product_1 = T * T_squared
    result = _empty(arguments, (3, 3))
    result[..., 0, 0] = T * T_squared**2 * q / 20.0
    result[..., 0, 1] = 0.125 * T_squared**2 * q
    result[..., 0, 2] = product_1 * q / 6.0
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = product_1 * q / 3.0
    result[..., 1, 2] = 0.5 * T_squared * q
    result[..., 2, 0] = result[..., 0, 2]
    result[..., 2, 1] = result[..., 1, 2]
    result[..., 2, 2] = T * q
    return result


def constant_acceleration_process_noise_piecewise(*, T: npt.ArrayLike, sigma_w: npt.ArrayLike) -> Floats:
    """Covariance of the process noise of position, velocity and acceleration of one axis from scan to scan, with a jerk that is noise, constant over a period.

    Name: motion.constant_acceleration.process_noise.piecewise.
    Definition: Q = sigma_w^2 g g', g = int_0^T e^(As) G ds.
    Conditioning: no expectation is taken.
    Source: Bar-Shalom, Li & Kirubarajan 2001 6.2-6.3, doi:10.1002/0471221279.

    Args:
        T: time from scan to scan [s], 0.001 to 1000.
        sigma_w: standard deviation of the jerk, constant over a period [m/s^3], 1e-06 to 1000.

    Returns:
        Shape of the broadcast arguments + (3, 3), unit [m, m/s, m/s^2] × [m, m/s, m/s^2].

    Accuracy: at most 13.1 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 13.1.
    """
    arguments = _floats(T, sigma_w)
    T, sigma_w = arguments
    T_squared = T**2
    sigma_w_squared = sigma_w**2
    T_squared_squared = T_squared**2
    result = _empty(arguments, (3, 3))
    result[..., 0, 0] = T_squared * T_squared**2 * sigma_w_squared / 36.0
    result[..., 0, 1] = T * T_squared**2 * sigma_w_squared / 12.0
    result[..., 0, 2] = T_squared_squared * sigma_w_squared / 6.0
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = 0.25 * T_squared_squared * sigma_w_squared
    result[..., 1, 2] = 0.5 * T * T_squared * sigma_w_squared
    result[..., 2, 0] = result[..., 0, 2]
    result[..., 2, 1] = result[..., 1, 2]
    result[..., 2, 2] = T_squared * sigma_w_squared
    return result


def constant_acceleration_process_noise_wiener_sequence(
    *,
    T: npt.ArrayLike,
    sigma_w: npt.ArrayLike,
) -> Floats:
    """Covariance of the process noise of position, velocity and acceleration of one axis from scan to scan, with jumps of the acceleration at each scan, a Wiener sequence.

    Name: motion.constant_acceleration.process_noise.wiener_sequence.
    Definition: Q = sigma_w^2 F G (F G)'.
    Conditioning: no expectation is taken.
    Source: Bar-Shalom, Li & Kirubarajan 2001 6.2-6.3, doi:10.1002/0471221279.

    Args:
        T: time from scan to scan [s], 0.001 to 1000.
        sigma_w: standard deviation of the jump of the acceleration at a scan [m/s^2], 1e-06 to 1000.

    Returns:
        Shape of the broadcast arguments + (3, 3), unit [m, m/s, m/s^2] × [m, m/s, m/s^2].

    Accuracy: at most 9.01 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 9.01.
    """
    arguments = _floats(T, sigma_w)
    T, sigma_w = arguments
    T_squared = T**2
    sigma_w_squared = sigma_w**2
    result = _empty(arguments, (3, 3))
    result[..., 0, 0] = 0.25 * T_squared**2 * sigma_w_squared
    result[..., 0, 1] = 0.5 * T * T_squared * sigma_w_squared
    result[..., 0, 2] = 0.5 * T_squared * sigma_w_squared
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = T_squared * sigma_w_squared
    result[..., 1, 2] = T * sigma_w_squared
    result[..., 2, 0] = result[..., 0, 2]
    result[..., 2, 1] = result[..., 1, 2]
    result[..., 2, 2] = sigma_w_squared
    return result


def constant_jerk_transition(*, T: npt.ArrayLike) -> Floats:
    """Transition of position, velocity, acceleration and jerk of one axis from scan to scan.

    Name: motion.constant_jerk.transition.
    Definition: F = e^(AT).
    Conditioning: no expectation is taken.
    Source: Bar-Shalom, Li & Kirubarajan 2001 6.2-6.3, doi:10.1002/0471221279.

    Args:
        T: time from scan to scan [s], 0.001 to 1000.

    Returns:
        Shape of the broadcast arguments + (4, 4), unit [m, m/s, m/s^2, m/s^3] × [1/m, s/m, s^2/m, s^3/m].

    Accuracy: at most 4.01 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 4.01.
    """
    arguments = _floats(T)
    T, = arguments
    T_squared = T**2
    result = _empty(arguments, (4, 4))
    result[..., 0, 0] = 1.0
    result[..., 0, 1] = T
    result[..., 0, 2] = 0.5 * T_squared
    result[..., 0, 3] = T * T_squared / 6.0
    result[..., 1, 0] = 0.0
    result[..., 1, 1] = 1.0
    result[..., 1, 2] = T
    result[..., 1, 3] = result[..., 0, 2]
    result[..., 2, 0] = 0.0
    result[..., 2, 1] = 0.0
    result[..., 2, 2] = 1.0
    result[..., 2, 3] = T
    result[..., 3, 0] = 0.0
    result[..., 3, 1] = 0.0
    result[..., 3, 2] = 0.0
    result[..., 3, 3] = 1.0
    return result


def constant_jerk_process_noise_continuous(*, T: npt.ArrayLike, q: npt.ArrayLike) -> Floats:
    """Covariance of the process noise of position, velocity, acceleration and jerk of one axis from scan to scan, with white noise in the derivative of the jerk.

    Name: motion.constant_jerk.process_noise.continuous.
    Definition: Q = q int_0^T e^(As) G G' e^(As)' ds.
    Conditioning: no expectation is taken.
    Source: Bar-Shalom, Li & Kirubarajan 2001 6.2-6.3, doi:10.1002/0471221279.

    Args:
        T: time from scan to scan [s], 0.001 to 1000.
        q: intensity of the white noise in the derivative of the jerk [m^2/s^7], 1e-09 to 1e+06.

    Returns:
        Shape of the broadcast arguments + (4, 4), unit [m, m/s, m/s^2, m/s^3] × [m, m/s, m/s^2, m/s^3].

    Accuracy: at most 12.1 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 12.1.
    """
    arguments = _floats(T, q)
    T, q = arguments
    T_squared = T**2
    product_1 = T * T_squared**2
    T_squared_squared = T_squared**2
    product_2 = T * T_squared
    result = _empty(arguments, (4, 4))
    result[..., 0, 0] = T * T_squared * T_squared**2 * q / 252.0
    result[..., 0, 1] = T_squared * T_squared**2 * q / 72.0
    result[..., 0, 2] = product_1 * q / 30.0
    result[..., 0, 3] = T_squared_squared * q / 24.0
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = product_1 * q / 20.0
    result[..., 1, 2] = 0.125 * T_squared_squared * q
    result[..., 1, 3] = product_2 * q / 6.0
    result[..., 2, 0] = result[..., 0, 2]
    result[..., 2, 1] = result[..., 1, 2]
    result[..., 2, 2] = product_2 * q / 3.0
    result[..., 2, 3] = 0.5 * T_squared * q
    result[..., 3, 0] = result[..., 0, 3]
    result[..., 3, 1] = result[..., 1, 3]
    result[..., 3, 2] = result[..., 2, 3]
    result[..., 3, 3] = T * q
    return result


def constant_jerk_process_noise_piecewise(*, T: npt.ArrayLike, sigma_w: npt.ArrayLike) -> Floats:
    """Covariance of the process noise of position, velocity, acceleration and jerk of one axis from scan to scan, with a derivative of the jerk that is noise, constant over a period.

    Name: motion.constant_jerk.process_noise.piecewise.
    Definition: Q = sigma_w^2 g g', g = int_0^T e^(As) G ds.
    Conditioning: no expectation is taken.
    Source: Bar-Shalom, Li & Kirubarajan 2001 6.2-6.3, doi:10.1002/0471221279.

    Args:
        T: time from scan to scan [s], 0.001 to 1000.
        sigma_w: standard deviation of the derivative of the jerk, constant over a period [m/s^4], 1e-06 to 1000.

    Returns:
        Shape of the broadcast arguments + (4, 4), unit [m, m/s, m/s^2, m/s^3] × [m, m/s, m/s^2, m/s^3].

    Accuracy: at most 18.1 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 31.6.
    """
    arguments = _floats(T, sigma_w)
    T, sigma_w = arguments
    T_squared = T**2
    sigma_w_squared = sigma_w**2
    T_squared_cubed = T_squared * T_squared**2
    product_1 = T * T_squared**2
    T_squared_squared = T_squared**2
    result = _empty(arguments, (4, 4))
    result[..., 0, 0] = (T_squared**2)**2 * sigma_w_squared / 576.0
    result[..., 0, 1] = T * T_squared * T_squared**2 * sigma_w_squared / 144.0
    result[..., 0, 2] = T_squared_cubed * sigma_w_squared / 48.0
    result[..., 0, 3] = product_1 * sigma_w_squared / 24.0
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = T_squared_cubed * sigma_w_squared / 36.0
    result[..., 1, 2] = product_1 * sigma_w_squared / 12.0
    result[..., 1, 3] = T_squared_squared * sigma_w_squared / 6.0
    result[..., 2, 0] = result[..., 0, 2]
    result[..., 2, 1] = result[..., 1, 2]
    result[..., 2, 2] = 0.25 * T_squared_squared * sigma_w_squared
    result[..., 2, 3] = 0.5 * T * T_squared * sigma_w_squared
    result[..., 3, 0] = result[..., 0, 3]
    result[..., 3, 1] = result[..., 1, 3]
    result[..., 3, 2] = result[..., 2, 3]
    result[..., 3, 3] = T_squared * sigma_w_squared
    return result


def constant_jerk_process_noise_wiener_sequence(*, T: npt.ArrayLike, sigma_w: npt.ArrayLike) -> Floats:
    """Covariance of the process noise of position, velocity, acceleration and jerk of one axis from scan to scan, with jumps of the jerk at each scan, a Wiener sequence.

    Name: motion.constant_jerk.process_noise.wiener_sequence.
    Definition: Q = sigma_w^2 F G (F G)'.
    Conditioning: no expectation is taken.
    Source: Bar-Shalom, Li & Kirubarajan 2001 6.2-6.3, doi:10.1002/0471221279.

    Args:
        T: time from scan to scan [s], 0.001 to 1000.
        sigma_w: standard deviation of the jump of the jerk at a scan [m/s^3], 1e-06 to 1000.

    Returns:
        Shape of the broadcast arguments + (4, 4), unit [m, m/s, m/s^2, m/s^3] × [m, m/s, m/s^2, m/s^3].

    Accuracy: at most 13.1 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 13.1.
    """
    arguments = _floats(T, sigma_w)
    T, sigma_w = arguments
    T_squared = T**2
    sigma_w_squared = sigma_w**2
    T_squared_squared = T_squared**2
    product_1 = T * T_squared
    result = _empty(arguments, (4, 4))
    result[..., 0, 0] = T_squared * T_squared**2 * sigma_w_squared / 36.0
    result[..., 0, 1] = T * T_squared**2 * sigma_w_squared / 12.0
    result[..., 0, 2] = T_squared_squared * sigma_w_squared / 6.0
    result[..., 0, 3] = product_1 * sigma_w_squared / 6.0
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = 0.25 * T_squared_squared * sigma_w_squared
    result[..., 1, 2] = 0.5 * product_1 * sigma_w_squared
    result[..., 1, 3] = 0.5 * T_squared * sigma_w_squared
    result[..., 2, 0] = result[..., 0, 2]
    result[..., 2, 1] = result[..., 1, 2]
    result[..., 2, 2] = T_squared * sigma_w_squared
    result[..., 2, 3] = T * sigma_w_squared
    result[..., 3, 0] = result[..., 0, 3]
    result[..., 3, 1] = result[..., 1, 3]
    result[..., 3, 2] = result[..., 2, 3]
    result[..., 3, 3] = sigma_w_squared
    return result


def plane_transition(*, T: npt.ArrayLike) -> Floats:
    """Transition of (x, vx, y, vy) from scan to scan at constant velocity.

    Name: motion.plane.transition.
    Definition: one block e^(AT) for each axis.
    Conditioning: no expectation is taken.
    Source: Prosov F.

    Args:
        T: time from scan to scan [s], 0.001 to 1000.

    Returns:
        Shape of the broadcast arguments + (4, 4), unit [m, m/s, m, m/s] × [1/m, s/m, 1/m, s/m].

    Accuracy: at most 0 ulp anywhere in this domain, proved for elementary functions within 1 ulp (float64);
    in float32, with functions within 4 of its ulp, at most 0.
    """
    arguments = _floats(T)
    T, = arguments
    result = _empty(arguments, (4, 4))
    result[..., 0, 0] = 1.0
    result[..., 0, 1] = T
    result[..., 0, 2] = 0.0
    result[..., 0, 3] = 0.0
    result[..., 1, 0] = 0.0
    result[..., 1, 1] = 1.0
    result[..., 1, 2] = 0.0
    result[..., 1, 3] = 0.0
    result[..., 2, 0] = 0.0
    result[..., 2, 1] = 0.0
    result[..., 2, 2] = 1.0
    result[..., 2, 3] = T
    result[..., 3, 0] = 0.0
    result[..., 3, 1] = 0.0
    result[..., 3, 2] = 0.0
    result[..., 3, 3] = 1.0
    return result


def plane_observation() -> Floats:
    """Position (x, y) from the state (x, vx, y, vy).

    Name: motion.plane.observation.
    Definition: the derivative of the position by the state.
    Conditioning: no expectation is taken.
    Source: Prosov H_2.

    Returns:
        Shape of the broadcast arguments + (2, 4), unit [m, m] × [1/m, s/m, 1/m, s/m].

    Accuracy: at most 0 ulp anywhere in this domain, proved for elementary functions within 1 ulp (float64);
    in float32, with functions within 4 of its ulp, at most 0.
    """
    return np.array([[1.0, 0.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0]])[()]


def singer_transition(*, T: npt.ArrayLike, alpha: npt.ArrayLike) -> Floats:
    """Transition of position, velocity and acceleration of one axis from scan to scan.

    Name: motion.singer.transition.
    Definition: F = e^(AT).
    Conditioning: no expectation is taken.
    Source: Singer 1970, doi:10.1109/TAES.1970.310128.

    Args:
        T: time from scan to scan [s], 0.001 to 1000.
        alpha: one over the time constant [1/s], 1e-06 to 1.

    Returns:
        Shape of the broadcast arguments + (3, 3), unit [m, m/s, m/s^2] × [1/m, s/m, s^2/m].

    Accuracy: at most 22 ulp anywhere in this domain, proved for elementary functions within 1 ulp (float64);
    in float32, with functions within 4 of its ulp, at most 25.9.
    """
    arguments = _floats(T, alpha)
    T, alpha = arguments
    decay = T * alpha
    rest_0 = np.exp(-decay)
    rest_1 = -np.expm1(-decay)
    rest_2 = _remainder(-decay, 2)
    result = _empty(arguments, (3, 3))
    result[..., 0, 0] = 1.0
    result[..., 0, 1] = T
    result[..., 0, 2] = rest_2 / alpha**2
    result[..., 1, 0] = 0.0
    result[..., 1, 1] = 1.0
    result[..., 1, 2] = rest_1 / alpha
    result[..., 2, 0] = 0.0
    result[..., 2, 1] = 0.0
    result[..., 2, 2] = rest_0
    return result


def singer_process_noise(*, T: npt.ArrayLike, alpha: npt.ArrayLike, sigma_m: npt.ArrayLike) -> Floats:
    """Covariance of the process noise of position, velocity and acceleration of one axis from scan to scan, with a correlated acceleration.

    Name: motion.singer.process_noise.
    Definition: Q = q int_0^T e^(As) G G' e^(As)' ds, q = 2 alpha sigma_m^2.
    Conditioning: no expectation is taken.
    Source: Singer 1970, doi:10.1109/TAES.1970.310128.

    Args:
        T: time from scan to scan [s], 0.001 to 1000.
        alpha: one over the time constant [1/s], 1e-06 to 1.
        sigma_m: standard deviation of the acceleration [m/s^2], 1e-06 to 1000.

    Returns:
        Shape of the broadcast arguments + (3, 3), unit [m, m/s, m/s^2] × [m, m/s, m/s^2].

    Accuracy: at most 453 ulp anywhere in this domain, proved for elementary functions within 1 ulp (float64).
    """
    arguments = _floats(T, alpha, sigma_m)
    T, alpha, sigma_m = arguments
    decay = T * alpha
    near = np.less(decay, 2.0)
    rest_0 = np.exp(-decay)
    rest_1 = -np.expm1(-decay)
    rest_2 = _remainder(-decay, 2)
    rest_3 = -_remainder(-decay, 3)
    rest_4 = _remainder(-decay, 4)
    rest_5 = -_remainder(-decay, 5)
    sum_1 = 1.0 - near
    decay_squared = decay**2
    term_1 = np.expm1(-2.0 * decay)
    sum_2 = decay - 2.0 * decay * rest_0 - decay_squared - 0.5 * term_1 + decay * decay_squared / 3.0
    sum_3 = rest_2 * rest_3 - rest_1 * rest_4 - rest_2 * rest_4 + 0.5 * rest_3**2 + rest_5
    sigma_m_squared = sigma_m**2
    rest_2_squared = rest_2**2
    term_2 = 1.0 / alpha**2
    sum_4 = (rest_3 - 0.5 * rest_2_squared) * near + (-decay * rest_0 - 0.5 * term_1) * sum_1
    rest_1_squared = rest_1**2
    sum_5 = rest_1 * rest_2 - rest_3 + 0.5 * rest_2_squared
    sum_6 = near * sum_5 + (rest_2 - 0.5 * rest_1_squared) * sum_1
    result = _empty(arguments, (3, 3))
    result[..., 0, 0] = 2.0 * (near * sum_3 + sum_1 * sum_2) * sigma_m_squared / (alpha**2)**2
    result[..., 0, 1] = rest_2_squared * sigma_m_squared / (alpha * alpha**2)
    result[..., 0, 2] = 2.0 * sigma_m_squared * sum_4 * term_2
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = 2.0 * sigma_m_squared * sum_6 * term_2
    result[..., 1, 2] = rest_1_squared * sigma_m_squared / alpha
    result[..., 2, 0] = result[..., 0, 2]
    result[..., 2, 1] = result[..., 1, 2]
    result[..., 2, 2] = -sigma_m_squared * term_1
    return result


def ornstein_uhlenbeck_transition(*, T: npt.ArrayLike, alpha: npt.ArrayLike) -> Floats:
    """Transition of position and velocity of one axis from scan to scan.

    Name: motion.ornstein_uhlenbeck.transition.
    Definition: F = e^(AT).
    Conditioning: no expectation is taken.
    Source: Uhlenbeck & Ornstein 1930, doi:10.1103/PhysRev.36.823.

    Args:
        T: time from scan to scan [s], 0.001 to 1000.
        alpha: one over the time constant [1/s], 1e-06 to 1.

    Returns:
        Shape of the broadcast arguments + (2, 2), unit [m, m/s] × [1/m, s/m].

    Accuracy: at most 12.4 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 713.
    """
    arguments = _floats(T, alpha)
    T, alpha = arguments
    decay = T * alpha
    rest_0 = np.exp(-decay)
    rest_1 = -np.expm1(-decay)
    result = _empty(arguments, (2, 2))
    result[..., 0, 0] = 1.0
    result[..., 0, 1] = rest_1 / alpha
    result[..., 1, 0] = 0.0
    result[..., 1, 1] = rest_0
    return result


def ornstein_uhlenbeck_process_noise(*, T: npt.ArrayLike, alpha: npt.ArrayLike, q: npt.ArrayLike) -> Floats:
    """Covariance of the process noise of position and velocity of one axis from scan to scan, with a velocity that is an Ornstein-Uhlenbeck process.

    Name: motion.ornstein_uhlenbeck.process_noise.
    Definition: Q = q int_0^T e^(As) G G' e^(As)' ds.
    Conditioning: no expectation is taken.
    Source: Uhlenbeck & Ornstein 1930, doi:10.1103/PhysRev.36.823.

    Args:
        T: time from scan to scan [s], 0.001 to 1000.
        alpha: one over the time constant [1/s], 1e-06 to 1.
        q: intensity of the white noise that drives the velocity [m^2/s^3], 1e-09 to 1e+06.

    Returns:
        Shape of the broadcast arguments + (2, 2), unit [m, m/s] × [m, m/s].

    Accuracy: at most 149 ulp anywhere in this domain, proved for elementary functions within 1 ulp (float64).
    """
    arguments = _floats(T, alpha, q)
    T, alpha, q = arguments
    decay = T * alpha
    near = np.less(decay, 2.0)
    rest_1 = -np.expm1(-decay)
    rest_2 = _remainder(-decay, 2)
    rest_3 = -_remainder(-decay, 3)
    rest_1_squared = rest_1**2
    sum_1 = rest_1 * rest_2 - rest_3 + 0.5 * rest_2**2
    sum_2 = (rest_2 - 0.5 * rest_1_squared) * (1.0 - near) + near * sum_1
    result = _empty(arguments, (2, 2))
    result[..., 0, 0] = q * sum_2 / (alpha * alpha**2)
    result[..., 0, 1] = 0.5 * q * rest_1_squared / alpha**2
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = -0.5 * np.expm1(-2.0 * decay) * q / alpha
    return result


def turn_known_rate_transition(*, T: npt.ArrayLike, omega: npt.ArrayLike) -> Floats:
    """Transition of (x, vx, y, vy) in a turn of known rate from scan to scan.

    Name: motion.turn.known_rate.transition.
    Definition: F = e^(AT).
    Conditioning: no expectation is taken.
    Source: Bar-Shalom, Li & Kirubarajan 2001 11.7, doi:10.1002/0471221279.

    Args:
        T: time from scan to scan [s], 0.001 to 10.
        omega: rate of the turn, counter-clockwise [rad/s], -0.5 to 0.5.

    Returns:
        Shape of the broadcast arguments + (4, 4), unit [m, m/s, m, m/s] × [1/m, s/m, 1/m, s/m].

    Accuracy: at most 28.3 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 65.2.
    """
    arguments = _floats(T, omega)
    T, omega = arguments
    product_1 = T * omega
    T_squared = T**2
    term_1 = _stumpff(product_1, 2)
    sin_product_1 = np.sin(product_1)
    result = _empty(arguments, (4, 4))
    result[..., 0, 0] = 1.0
    result[..., 0, 1] = T * _stumpff(product_1, 1)
    result[..., 0, 2] = 0.0
    result[..., 0, 3] = -T_squared * omega * term_1
    result[..., 1, 0] = 0.0
    result[..., 1, 1] = np.cos(product_1)
    result[..., 1, 2] = 0.0
    result[..., 1, 3] = -sin_product_1
    result[..., 2, 0] = 0.0
    result[..., 2, 1] = T_squared * omega * term_1
    result[..., 2, 2] = 1.0
    result[..., 2, 3] = result[..., 0, 1]
    result[..., 3, 0] = 0.0
    result[..., 3, 1] = sin_product_1
    result[..., 3, 2] = 0.0
    result[..., 3, 3] = result[..., 1, 1]
    return result


def turn_known_rate_process_noise_continuous(
    *,
    T: npt.ArrayLike,
    omega: npt.ArrayLike,
    q: npt.ArrayLike,
) -> Floats:
    """Covariance of the process noise of (x, vx, y, vy) in a turn of known rate from scan to scan, with white noise in the acceleration along both axes.

    Name: motion.turn.known_rate.process_noise.continuous.
    Definition: Q = q int_0^T e^(As) G G' e^(As)' ds.
    Conditioning: no expectation is taken.
    Source: Bar-Shalom, Li & Kirubarajan 2001 11.7, doi:10.1002/0471221279.

    Args:
        T: time from scan to scan [s], 0.001 to 10.
        omega: rate of the turn, counter-clockwise [rad/s], -0.5 to 0.5.
        q: intensity of the white noise in the acceleration along each axis [m^2/s^3], 1e-09 to 1e+06.

    Returns:
        Shape of the broadcast arguments + (4, 4), unit [m, m/s, m, m/s] × [m, m/s, m, m/s].

    Accuracy: at most 40 ulp anywhere in this domain, proved for elementary functions within 1 ulp (float64);
    in float32, with functions within 4 of its ulp, at most 92.1.
    """
    arguments = _floats(T, omega, q)
    T, omega, q = arguments
    T_squared = T**2
    product_1 = T * T_squared
    product_2 = T * omega
    term_1 = _stumpff(product_2, 3)
    result = _empty(arguments, (4, 4))
    result[..., 0, 0] = 2.0 * product_1 * q * term_1
    result[..., 0, 1] = T_squared * q * _stumpff(product_2, 2)
    result[..., 0, 2] = 0.0
    result[..., 0, 3] = omega * product_1 * q * term_1
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = T * q
    result[..., 1, 2] = -omega * product_1 * q * term_1
    result[..., 1, 3] = 0.0
    result[..., 2, 0] = 0.0
    result[..., 2, 1] = result[..., 1, 2]
    result[..., 2, 2] = result[..., 0, 0]
    result[..., 2, 3] = result[..., 0, 1]
    result[..., 3, 0] = result[..., 0, 3]
    result[..., 3, 1] = 0.0
    result[..., 3, 2] = result[..., 0, 1]
    result[..., 3, 3] = result[..., 1, 1]
    return result


def turn_known_rate_process_noise_piecewise(
    *,
    T: npt.ArrayLike,
    omega: npt.ArrayLike,
    sigma_w: npt.ArrayLike,
) -> Floats:
    """Covariance of the process noise of (x, vx, y, vy) in a turn of known rate from scan to scan, with accelerations along both axes that are noise, constant over a period.

    Name: motion.turn.known_rate.process_noise.piecewise.
    Definition: Q = sigma_w^2 g g', g = int_0^T e^(As) G ds.
    Conditioning: no expectation is taken.
    Source: Bar-Shalom, Li & Kirubarajan 2001 11.7, doi:10.1002/0471221279.

    Args:
        T: time from scan to scan [s], 0.001 to 10.
        omega: rate of the turn, counter-clockwise [rad/s], -0.5 to 0.5.
        sigma_w: standard deviation of the acceleration along each axis, constant over a period [m/s^2], 1e-06 to 1000.

    Returns:
        Shape of the broadcast arguments + (4, 4), unit [m, m/s, m, m/s] × [m, m/s, m, m/s].

    Accuracy: at most 139 ulp anywhere in this domain, proved for elementary functions within 1 ulp (float64).
    """
    arguments = _floats(T, omega, sigma_w)
    T, omega, sigma_w = arguments
    T_squared = T**2
    T_squared_squared = T_squared**2
    product_1 = T * omega
    term_1 = _stumpff(product_1, 2)
    term_1_squared = term_1**2
    omega_squared = omega**2
    term_2 = _stumpff(product_1, 3)
    sigma_w_squared = sigma_w**2
    sum_1 = T_squared * T_squared**2 * omega_squared * term_2**2 + T_squared_squared * term_1_squared
    term_3 = _stumpff(product_1, 1)
    sum_2 = T * T_squared**2 * omega_squared * term_1 * term_2 + T * T_squared * term_1 * term_3
    sum_3 = T_squared_squared * omega * term_1_squared - T_squared_squared * omega * term_2 * term_3
    sum_4 = T_squared * term_3**2 + T_squared_squared * omega_squared * term_1_squared
    sum_5 = T_squared_squared * omega * term_2 * term_3 - T_squared_squared * omega * term_1_squared
    result = _empty(arguments, (4, 4))
    result[..., 0, 0] = sigma_w_squared * sum_1
    result[..., 0, 1] = sigma_w_squared * sum_2
    result[..., 0, 2] = 0.0
    result[..., 0, 3] = sigma_w_squared * sum_3
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = sigma_w_squared * sum_4
    result[..., 1, 2] = sigma_w_squared * sum_5
    result[..., 1, 3] = 0.0
    result[..., 2, 0] = 0.0
    result[..., 2, 1] = result[..., 1, 2]
    result[..., 2, 2] = result[..., 0, 0]
    result[..., 2, 3] = result[..., 0, 1]
    result[..., 3, 0] = result[..., 0, 3]
    result[..., 3, 1] = 0.0
    result[..., 3, 2] = result[..., 0, 1]
    result[..., 3, 3] = result[..., 1, 1]
    return result


def turn_unknown_rate_map(
    *,
    x: npt.ArrayLike,
    vx: npt.ArrayLike,
    y: npt.ArrayLike,
    vy: npt.ArrayLike,
    omega: npt.ArrayLike,
    T: npt.ArrayLike,
) -> Floats:
    """(x, vx, y, vy, omega) in a turn of unknown rate, a period later.

    Name: motion.turn.unknown_rate.map.
    Definition: f.
    Conditioning: no expectation is taken.
    Source: Bar-Shalom, Li & Kirubarajan 2001 11.7, doi:10.1002/0471221279.

    Args:
        x: position along the x axis [m], -1e+06 to 1e+06.
        vx: velocity along the x axis [m/s], -1000 to 1000.
        y: position along the y axis [m], -1e+06 to 1e+06.
        vy: velocity along the y axis [m/s], -1000 to 1000.
        omega: rate of the turn, counter-clockwise [rad/s], -0.5 to 0.5.
        T: time from scan to scan [s], 0.001 to 10.

    Returns:
        Shape of the broadcast arguments + (5), unit [m, m/s, m, m/s, rad/s].

    Accuracy: at most 43 ulp anywhere in this domain, proved for elementary functions within 1 ulp (float64).
    Errors are measured against what its terms are at most at any rate.
    """
    arguments = _floats(x, vx, y, vy, omega, T)
    x, vx, y, vy, omega, T = arguments
    T_squared = T**2
    product_1 = T * omega
    term_1 = _stumpff(product_1, 2)
    term_2 = _stumpff(product_1, 1)
    sin_product_1 = np.sin(product_1)
    cos_product_1 = np.cos(product_1)
    result = _empty(arguments, (5,))
    result[..., 0] = T * term_2 * vx - T_squared * omega * term_1 * vy + x
    result[..., 1] = cos_product_1 * vx - sin_product_1 * vy
    result[..., 2] = T_squared * omega * term_1 * vx + T * term_2 * vy + y
    result[..., 3] = cos_product_1 * vy + sin_product_1 * vx
    result[..., 4] = omega
    return result


def turn_unknown_rate_jacobian(
    *,
    x: npt.ArrayLike,
    vx: npt.ArrayLike,
    y: npt.ArrayLike,
    vy: npt.ArrayLike,
    omega: npt.ArrayLike,
    T: npt.ArrayLike,
) -> Floats:
    """First derivatives of (x, vx, y, vy, omega) in a turn of unknown rate, a period later, [out, in].

    Name: motion.turn.unknown_rate.jacobian.
    Definition: df/dstate.
    Conditioning: no expectation is taken.
    Source: Bar-Shalom, Li & Kirubarajan 2001 11.7, doi:10.1002/0471221279.

    Args:
        x: position along the x axis [m], -1e+06 to 1e+06.
        vx: velocity along the x axis [m/s], -1000 to 1000.
        y: position along the y axis [m], -1e+06 to 1e+06.
        vy: velocity along the y axis [m/s], -1000 to 1000.
        omega: rate of the turn, counter-clockwise [rad/s], -0.5 to 0.5.
        T: time from scan to scan [s], 0.001 to 10.

    Returns:
        Shape of the broadcast arguments + (5, 5), unit [m, m/s, m, m/s, rad/s] × [1/m, s/m, 1/m, s/m, s/rad].

    Accuracy: at most 36.2 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64). Errors are measured against what its terms are at most at any rate.
    """
    arguments = _floats(x, vx, y, vy, omega, T)
    x, vx, y, vy, omega, T = arguments
    product_1 = T * omega
    T_squared = T**2
    term_1 = _stumpff(product_1, 2)
    product_2 = T * T_squared
    term_2 = _stumpff(product_1, 3)
    sum_1 = term_1 - term_2
    T_squared_squared = T_squared**2
    omega_squared = omega**2
    sum_2 = term_2 - 2.0 * _stumpff(product_1, 4)
    cos_product_1 = np.cos(product_1)
    sin_product_1 = np.sin(product_1)
    result = _empty(arguments, (5, 5))
    result[..., 0, 0] = 1.0
    result[..., 0, 1] = T * _stumpff(product_1, 1)
    result[..., 0, 2] = 0.0
    result[..., 0, 3] = -T_squared * omega * term_1
    result[..., 0, 4] = (
        T_squared_squared * omega_squared * sum_2 * vy
        - T_squared * term_1 * vy
        - omega * product_2 * sum_1 * vx
    )
    result[..., 1, 0] = 0.0
    result[..., 1, 1] = cos_product_1
    result[..., 1, 2] = 0.0
    result[..., 1, 3] = -sin_product_1
    result[..., 1, 4] = -T * cos_product_1 * vy - T * sin_product_1 * vx
    result[..., 2, 0] = 0.0
    result[..., 2, 1] = T_squared * omega * term_1
    result[..., 2, 2] = 1.0
    result[..., 2, 3] = result[..., 0, 1]
    result[..., 2, 4] = (
        T_squared * term_1 * vx
        - T_squared_squared * omega_squared * sum_2 * vx
        - omega * product_2 * sum_1 * vy
    )
    result[..., 3, 0] = 0.0
    result[..., 3, 1] = sin_product_1
    result[..., 3, 2] = 0.0
    result[..., 3, 3] = cos_product_1
    result[..., 3, 4] = T * cos_product_1 * vx - T * sin_product_1 * vy
    result[..., 4, 0] = 0.0
    result[..., 4, 1] = 0.0
    result[..., 4, 2] = 0.0
    result[..., 4, 3] = 0.0
    result[..., 4, 4] = 1.0
    return result


def turn_unknown_rate_hessian(
    *,
    x: npt.ArrayLike,
    vx: npt.ArrayLike,
    y: npt.ArrayLike,
    vy: npt.ArrayLike,
    omega: npt.ArrayLike,
    T: npt.ArrayLike,
) -> Floats:
    """Second derivatives of (x, vx, y, vy, omega) in a turn of unknown rate, a period later, [out, in, in].

    Name: motion.turn.unknown_rate.hessian.
    Definition: d2f/dstate2.
    Conditioning: no expectation is taken.
    Source: Bar-Shalom, Li & Kirubarajan 2001 11.7, doi:10.1002/0471221279.

    Args:
        x: position along the x axis [m], -1e+06 to 1e+06.
        vx: velocity along the x axis [m/s], -1000 to 1000.
        y: position along the y axis [m], -1e+06 to 1e+06.
        vy: velocity along the y axis [m/s], -1000 to 1000.
        omega: rate of the turn, counter-clockwise [rad/s], -0.5 to 0.5.
        T: time from scan to scan [s], 0.001 to 10.

    Returns:
        Shape of the broadcast arguments + (5, 5, 5), unit [m, m/s, m, m/s, rad/s] × [1/m, s/m, 1/m, s/m,
        s/rad] × [1/m, s/m, 1/m, s/m, s/rad].

    Accuracy: at most 40 ulp anywhere in this domain, proved for elementary functions within 1 ulp (float64).
    Errors are measured against what its terms are at most at any rate.
    """
    arguments = _floats(x, vx, y, vy, omega, T)
    x, vx, y, vy, omega, T = arguments
    T_squared = T**2
    product_1 = T * T_squared
    product_2 = T * omega
    term_1 = _stumpff(product_2, 3)
    term_2 = _stumpff(product_2, 2)
    sum_1 = term_2 - term_1
    omega_squared = omega**2
    term_3 = _stumpff(product_2, 4)
    sum_2 = term_1 - 2.0 * term_3
    sum_3 = T_squared * omega_squared * sum_2 - term_2
    product_3 = omega * omega_squared
    term_4 = _stumpff(product_2, 5)
    sum_4 = 8.0 * _stumpff(product_2, 6) - 5.0 * term_4 + term_3
    sum_5 = 3.0 * term_4 - 3.0 * term_3 + term_1
    sum_6 = (
        3.0 * T * omega * sum_2 * vy
        - product_1 * product_3 * sum_4 * vy
        - sum_1 * vx
        + T_squared * omega_squared * sum_5 * vx
    )
    sin_product_2 = np.sin(product_2)
    cos_product_2 = np.cos(product_2)
    sum_7 = sin_product_2 * vy - cos_product_2 * vx
    sum_8 = term_2 - T_squared * omega_squared * sum_2
    sum_9 = (
        T_squared * omega_squared * sum_5 * vy
        - 3.0 * T * omega * sum_2 * vx
        - sum_1 * vy
        + product_1 * product_3 * sum_4 * vx
    )
    sum_10 = cos_product_2 * vy + sin_product_2 * vx
    result = _empty(arguments, (5, 5, 5))
    result[..., 0, 0, 0] = 0.0
    result[..., 0, 0, 1] = 0.0
    result[..., 0, 0, 2] = 0.0
    result[..., 0, 0, 3] = 0.0
    result[..., 0, 0, 4] = 0.0
    result[..., 0, 1, 0] = 0.0
    result[..., 0, 1, 1] = 0.0
    result[..., 0, 1, 2] = 0.0
    result[..., 0, 1, 3] = 0.0
    result[..., 0, 1, 4] = -omega * product_1 * sum_1
    result[..., 0, 2, 0] = 0.0
    result[..., 0, 2, 1] = 0.0
    result[..., 0, 2, 2] = 0.0
    result[..., 0, 2, 3] = 0.0
    result[..., 0, 2, 4] = 0.0
    result[..., 0, 3, 0] = 0.0
    result[..., 0, 3, 1] = 0.0
    result[..., 0, 3, 2] = 0.0
    result[..., 0, 3, 3] = 0.0
    result[..., 0, 3, 4] = T_squared * sum_3
    result[..., 0, 4, 0] = 0.0
    result[..., 0, 4, 1] = result[..., 0, 1, 4]
    result[..., 0, 4, 2] = 0.0
    result[..., 0, 4, 3] = result[..., 0, 3, 4]
    result[..., 0, 4, 4] = product_1 * sum_6
    result[..., 1, 0, 0] = 0.0
    result[..., 1, 0, 1] = 0.0
    result[..., 1, 0, 2] = 0.0
    result[..., 1, 0, 3] = 0.0
    result[..., 1, 0, 4] = 0.0
    result[..., 1, 1, 0] = 0.0
    result[..., 1, 1, 1] = 0.0
    result[..., 1, 1, 2] = 0.0
    result[..., 1, 1, 3] = 0.0
    result[..., 1, 1, 4] = -T * sin_product_2
    result[..., 1, 2, 0] = 0.0
    result[..., 1, 2, 1] = 0.0
    result[..., 1, 2, 2] = 0.0
    result[..., 1, 2, 3] = 0.0
    result[..., 1, 2, 4] = 0.0
    result[..., 1, 3, 0] = 0.0
    result[..., 1, 3, 1] = 0.0
    result[..., 1, 3, 2] = 0.0
    result[..., 1, 3, 3] = 0.0
    result[..., 1, 3, 4] = -T * cos_product_2
    result[..., 1, 4, 0] = 0.0
    result[..., 1, 4, 1] = result[..., 1, 1, 4]
    result[..., 1, 4, 2] = 0.0
    result[..., 1, 4, 3] = result[..., 1, 3, 4]
    result[..., 1, 4, 4] = T_squared * sum_7
    result[..., 2, 0, 0] = 0.0
    result[..., 2, 0, 1] = 0.0
    result[..., 2, 0, 2] = 0.0
    result[..., 2, 0, 3] = 0.0
    result[..., 2, 0, 4] = 0.0
    result[..., 2, 1, 0] = 0.0
    result[..., 2, 1, 1] = 0.0
    result[..., 2, 1, 2] = 0.0
    result[..., 2, 1, 3] = 0.0
    result[..., 2, 1, 4] = T_squared * sum_8
    result[..., 2, 2, 0] = 0.0
    result[..., 2, 2, 1] = 0.0
    result[..., 2, 2, 2] = 0.0
    result[..., 2, 2, 3] = 0.0
    result[..., 2, 2, 4] = 0.0
    result[..., 2, 3, 0] = 0.0
    result[..., 2, 3, 1] = 0.0
    result[..., 2, 3, 2] = 0.0
    result[..., 2, 3, 3] = 0.0
    result[..., 2, 3, 4] = result[..., 0, 1, 4]
    result[..., 2, 4, 0] = 0.0
    result[..., 2, 4, 1] = result[..., 2, 1, 4]
    result[..., 2, 4, 2] = 0.0
    result[..., 2, 4, 3] = result[..., 0, 1, 4]
    result[..., 2, 4, 4] = product_1 * sum_9
    result[..., 3, 0, 0] = 0.0
    result[..., 3, 0, 1] = 0.0
    result[..., 3, 0, 2] = 0.0
    result[..., 3, 0, 3] = 0.0
    result[..., 3, 0, 4] = 0.0
    result[..., 3, 1, 0] = 0.0
    result[..., 3, 1, 1] = 0.0
    result[..., 3, 1, 2] = 0.0
    result[..., 3, 1, 3] = 0.0
    result[..., 3, 1, 4] = T * cos_product_2
    result[..., 3, 2, 0] = 0.0
    result[..., 3, 2, 1] = 0.0
    result[..., 3, 2, 2] = 0.0
    result[..., 3, 2, 3] = 0.0
    result[..., 3, 2, 4] = 0.0
    result[..., 3, 3, 0] = 0.0
    result[..., 3, 3, 1] = 0.0
    result[..., 3, 3, 2] = 0.0
    result[..., 3, 3, 3] = 0.0
    result[..., 3, 3, 4] = result[..., 1, 1, 4]
    result[..., 3, 4, 0] = 0.0
    result[..., 3, 4, 1] = result[..., 3, 1, 4]
    result[..., 3, 4, 2] = 0.0
    result[..., 3, 4, 3] = result[..., 1, 1, 4]
    result[..., 3, 4, 4] = -T_squared * sum_10
    result[..., 4, 0, 0] = 0.0
    result[..., 4, 0, 1] = 0.0
    result[..., 4, 0, 2] = 0.0
    result[..., 4, 0, 3] = 0.0
    result[..., 4, 0, 4] = 0.0
    result[..., 4, 1, 0] = 0.0
    result[..., 4, 1, 1] = 0.0
    result[..., 4, 1, 2] = 0.0
    result[..., 4, 1, 3] = 0.0
    result[..., 4, 1, 4] = 0.0
    result[..., 4, 2, 0] = 0.0
    result[..., 4, 2, 1] = 0.0
    result[..., 4, 2, 2] = 0.0
    result[..., 4, 2, 3] = 0.0
    result[..., 4, 2, 4] = 0.0
    result[..., 4, 3, 0] = 0.0
    result[..., 4, 3, 1] = 0.0
    result[..., 4, 3, 2] = 0.0
    result[..., 4, 3, 3] = 0.0
    result[..., 4, 3, 4] = 0.0
    result[..., 4, 4, 0] = 0.0
    result[..., 4, 4, 1] = 0.0
    result[..., 4, 4, 2] = 0.0
    result[..., 4, 4, 3] = 0.0
    result[..., 4, 4, 4] = 0.0
    return result


def ctrv_map(
    *,
    x: npt.ArrayLike,
    y: npt.ArrayLike,
    speed: npt.ArrayLike,
    heading: npt.ArrayLike,
    omega: npt.ArrayLike,
    T: npt.ArrayLike,
) -> Floats:
    """(x, y, speed, heading, omega) at constant turn rate and velocity, a period later.

    Name: motion.ctrv.map.
    Definition: f.
    Conditioning: no expectation is taken.
    Source: Bar-Shalom, Li & Kirubarajan 2001 11.7, doi:10.1002/0471221279.

    Args:
        x: position along the x axis [m], -1e+06 to 1e+06.
        y: position along the y axis [m], -1e+06 to 1e+06.
        speed: speed along the heading [m/s], -1000 to 1000.
        heading: direction of the velocity, counter-clockwise from the x axis [rad], -3.1416 to 3.1416.
        omega: rate of the turn, counter-clockwise [rad/s], -0.5 to 0.5.
        T: time from scan to scan [s], 0.001 to 10.

    Returns:
        Shape of the broadcast arguments + (5), unit [m, m, m/s, rad, rad/s].

    Accuracy: at most 18.7 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64). Errors are measured against what its terms are at most at any rate.
    """
    arguments = _floats(x, y, speed, heading, omega, T)
    x, y, speed, heading, omega, T = arguments
    T_squared = T**2
    sin_heading = np.sin(heading)
    product_1 = T * omega
    term_1 = _stumpff(product_1, 2)
    cos_heading = np.cos(heading)
    term_2 = _stumpff(product_1, 1)
    sum_1 = T * cos_heading * term_2 - T_squared * omega * sin_heading * term_1
    sum_2 = T_squared * cos_heading * omega * term_1 + T * sin_heading * term_2
    result = _empty(arguments, (5,))
    result[..., 0] = speed * sum_1 + x
    result[..., 1] = speed * sum_2 + y
    result[..., 2] = speed
    result[..., 3] = heading + product_1
    result[..., 4] = omega
    return result


def ctrv_jacobian(
    *,
    x: npt.ArrayLike,
    y: npt.ArrayLike,
    speed: npt.ArrayLike,
    heading: npt.ArrayLike,
    omega: npt.ArrayLike,
    T: npt.ArrayLike,
) -> Floats:
    """First derivatives of (x, y, speed, heading, omega) at constant turn rate and velocity, a period later, [out, in].

    Name: motion.ctrv.jacobian.
    Definition: df/dstate.
    Conditioning: no expectation is taken.
    Source: Bar-Shalom, Li & Kirubarajan 2001 11.7, doi:10.1002/0471221279.

    Args:
        x: position along the x axis [m], -1e+06 to 1e+06.
        y: position along the y axis [m], -1e+06 to 1e+06.
        speed: speed along the heading [m/s], -1000 to 1000.
        heading: direction of the velocity, counter-clockwise from the x axis [rad], -3.1416 to 3.1416.
        omega: rate of the turn, counter-clockwise [rad/s], -0.5 to 0.5.
        T: time from scan to scan [s], 0.001 to 10.

    Returns:
        Shape of the broadcast arguments + (5, 5), unit [m, m, m/s, rad, rad/s] × [1/m, 1/m, s/m, 1/rad,
        s/rad].

    Accuracy: at most 44 ulp anywhere in this domain, proved for elementary functions within 1 ulp (float64).
    Errors are measured against what its terms are at most at any rate.
    """
    arguments = _floats(x, y, speed, heading, omega, T)
    x, y, speed, heading, omega, T = arguments
    T_squared = T**2
    sin_heading = np.sin(heading)
    product_1 = T * omega
    term_1 = _stumpff(product_1, 2)
    cos_heading = np.cos(heading)
    term_2 = _stumpff(product_1, 1)
    sum_1 = T * cos_heading * term_2 - T_squared * omega * sin_heading * term_1
    sum_2 = -T_squared * cos_heading * omega * term_1 - T * sin_heading * term_2
    product_2 = T * T_squared
    term_3 = _stumpff(product_1, 3)
    sum_3 = term_1 - term_3
    T_squared_squared = T_squared**2
    omega_squared = omega**2
    sum_4 = term_3 - 2.0 * _stumpff(product_1, 4)
    sum_5 = (
        T_squared_squared * omega_squared * sin_heading * sum_4
        - T_squared * sin_heading * term_1
        - cos_heading * omega * product_2 * sum_3
    )
    sum_6 = (
        T_squared * cos_heading * term_1
        - T_squared_squared * cos_heading * omega_squared * sum_4
        - omega * product_2 * sin_heading * sum_3
    )
    result = _empty(arguments, (5, 5))
    result[..., 0, 0] = 1.0
    result[..., 0, 1] = 0.0
    result[..., 0, 2] = sum_1
    result[..., 0, 3] = speed * sum_2
    result[..., 0, 4] = speed * sum_5
    result[..., 1, 0] = 0.0
    result[..., 1, 1] = 1.0
    result[..., 1, 2] = T_squared * cos_heading * omega * term_1 + T * sin_heading * term_2
    result[..., 1, 3] = speed * sum_1
    result[..., 1, 4] = speed * sum_6
    result[..., 2, 0] = 0.0
    result[..., 2, 1] = 0.0
    result[..., 2, 2] = 1.0
    result[..., 2, 3] = 0.0
    result[..., 2, 4] = 0.0
    result[..., 3, 0] = 0.0
    result[..., 3, 1] = 0.0
    result[..., 3, 2] = 0.0
    result[..., 3, 3] = 1.0
    result[..., 3, 4] = T
    result[..., 4, 0] = 0.0
    result[..., 4, 1] = 0.0
    result[..., 4, 2] = 0.0
    result[..., 4, 3] = 0.0
    result[..., 4, 4] = 1.0
    return result


def ctrv_hessian(
    *,
    x: npt.ArrayLike,
    y: npt.ArrayLike,
    speed: npt.ArrayLike,
    heading: npt.ArrayLike,
    omega: npt.ArrayLike,
    T: npt.ArrayLike,
) -> Floats:
    """Second derivatives of (x, y, speed, heading, omega) at constant turn rate and velocity, a period later, [out, in, in].

    Name: motion.ctrv.hessian.
    Definition: d2f/dstate2.
    Conditioning: no expectation is taken.
    Source: Bar-Shalom, Li & Kirubarajan 2001 11.7, doi:10.1002/0471221279.

    Args:
        x: position along the x axis [m], -1e+06 to 1e+06.
        y: position along the y axis [m], -1e+06 to 1e+06.
        speed: speed along the heading [m/s], -1000 to 1000.
        heading: direction of the velocity, counter-clockwise from the x axis [rad], -3.1416 to 3.1416.
        omega: rate of the turn, counter-clockwise [rad/s], -0.5 to 0.5.
        T: time from scan to scan [s], 0.001 to 10.

    Returns:
        Shape of the broadcast arguments + (5, 5, 5), unit [m, m, m/s, rad, rad/s] × [1/m, 1/m, s/m, 1/rad,
        s/rad] × [1/m, 1/m, s/m, 1/rad, s/rad].

    Accuracy: at most 45 ulp anywhere in this domain, proved for elementary functions within 1 ulp (float64).
    Errors are measured against what its terms are at most at any rate.
    """
    arguments = _floats(x, y, speed, heading, omega, T)
    x, y, speed, heading, omega, T = arguments
    cos_heading = np.cos(heading)
    product_1 = T * omega
    term_1 = _stumpff(product_1, 2)
    sin_heading = np.sin(heading)
    term_2 = _stumpff(product_1, 1)
    sum_1 = T * cos_heading * omega * term_1 + sin_heading * term_2
    T_squared = T**2
    term_3 = _stumpff(product_1, 3)
    sum_2 = term_1 - term_3
    omega_squared = omega**2
    term_4 = _stumpff(product_1, 4)
    sum_3 = term_3 - 2.0 * term_4
    sum_4 = (
        T_squared * omega_squared * sin_heading * sum_3
        - T * cos_heading * omega * sum_2
        - sin_heading * term_1
    )
    sum_5 = T * omega * sin_heading * term_1 - cos_heading * term_2
    sum_6 = (
        T_squared * cos_heading * omega_squared * sum_3
        - cos_heading * term_1
        + T * omega * sin_heading * sum_2
    )
    product_2 = T * T_squared
    term_5 = _stumpff(product_1, 5)
    sum_7 = 3.0 * term_5 - 3.0 * term_4 + term_3
    product_3 = omega * omega_squared
    sum_8 = 8.0 * _stumpff(product_1, 6) - 5.0 * term_5 + term_4
    sum_9 = (
        cos_heading * sum_2
        - 3.0 * T * omega * sin_heading * sum_3
        - T_squared * cos_heading * omega_squared * sum_7
        + product_2 * product_3 * sin_heading * sum_8
    )
    sum_10 = cos_heading * term_2 - T * omega * sin_heading * term_1
    sum_11 = (
        cos_heading * term_1
        - T_squared * cos_heading * omega_squared * sum_3
        - T * omega * sin_heading * sum_2
    )
    sum_12 = (
        T * cos_heading * omega * sum_2
        - T_squared * omega_squared * sin_heading * sum_3
        + sin_heading * term_1
    )
    sum_13 = (
        3.0 * T * cos_heading * omega * sum_3
        - T_squared * omega_squared * sin_heading * sum_7
        - cos_heading * product_2 * product_3 * sum_8
        + sin_heading * sum_2
    )
    result = _empty(arguments, (5, 5, 5))
    result[..., 0, 0, 0] = 0.0
    result[..., 0, 0, 1] = 0.0
    result[..., 0, 0, 2] = 0.0
    result[..., 0, 0, 3] = 0.0
    result[..., 0, 0, 4] = 0.0
    result[..., 0, 1, 0] = 0.0
    result[..., 0, 1, 1] = 0.0
    result[..., 0, 1, 2] = 0.0
    result[..., 0, 1, 3] = 0.0
    result[..., 0, 1, 4] = 0.0
    result[..., 0, 2, 0] = 0.0
    result[..., 0, 2, 1] = 0.0
    result[..., 0, 2, 2] = 0.0
    result[..., 0, 2, 3] = -T * sum_1
    result[..., 0, 2, 4] = T_squared * sum_4
    result[..., 0, 3, 0] = 0.0
    result[..., 0, 3, 1] = 0.0
    result[..., 0, 3, 2] = result[..., 0, 2, 3]
    result[..., 0, 3, 3] = T * speed * sum_5
    result[..., 0, 3, 4] = T_squared * speed * sum_6
    result[..., 0, 4, 0] = 0.0
    result[..., 0, 4, 1] = 0.0
    result[..., 0, 4, 2] = result[..., 0, 2, 4]
    result[..., 0, 4, 3] = result[..., 0, 3, 4]
    result[..., 0, 4, 4] = -product_2 * speed * sum_9
    result[..., 1, 0, 0] = 0.0
    result[..., 1, 0, 1] = 0.0
    result[..., 1, 0, 2] = 0.0
    result[..., 1, 0, 3] = 0.0
    result[..., 1, 0, 4] = 0.0
    result[..., 1, 1, 0] = 0.0
    result[..., 1, 1, 1] = 0.0
    result[..., 1, 1, 2] = 0.0
    result[..., 1, 1, 3] = 0.0
    result[..., 1, 1, 4] = 0.0
    result[..., 1, 2, 0] = 0.0
    result[..., 1, 2, 1] = 0.0
    result[..., 1, 2, 2] = 0.0
    result[..., 1, 2, 3] = T * sum_10
    result[..., 1, 2, 4] = T_squared * sum_11
    result[..., 1, 3, 0] = 0.0
    result[..., 1, 3, 1] = 0.0
    result[..., 1, 3, 2] = result[..., 1, 2, 3]
    result[..., 1, 3, 3] = -T * speed * sum_1
    result[..., 1, 3, 4] = -T_squared * speed * sum_12
    result[..., 1, 4, 0] = 0.0
    result[..., 1, 4, 1] = 0.0
    result[..., 1, 4, 2] = result[..., 1, 2, 4]
    result[..., 1, 4, 3] = result[..., 1, 3, 4]
    result[..., 1, 4, 4] = -product_2 * speed * sum_13
    result[..., 2, 0, 0] = 0.0
    result[..., 2, 0, 1] = 0.0
    result[..., 2, 0, 2] = 0.0
    result[..., 2, 0, 3] = 0.0
    result[..., 2, 0, 4] = 0.0
    result[..., 2, 1, 0] = 0.0
    result[..., 2, 1, 1] = 0.0
    result[..., 2, 1, 2] = 0.0
    result[..., 2, 1, 3] = 0.0
    result[..., 2, 1, 4] = 0.0
    result[..., 2, 2, 0] = 0.0
    result[..., 2, 2, 1] = 0.0
    result[..., 2, 2, 2] = 0.0
    result[..., 2, 2, 3] = 0.0
    result[..., 2, 2, 4] = 0.0
    result[..., 2, 3, 0] = 0.0
    result[..., 2, 3, 1] = 0.0
    result[..., 2, 3, 2] = 0.0
    result[..., 2, 3, 3] = 0.0
    result[..., 2, 3, 4] = 0.0
    result[..., 2, 4, 0] = 0.0
    result[..., 2, 4, 1] = 0.0
    result[..., 2, 4, 2] = 0.0
    result[..., 2, 4, 3] = 0.0
    result[..., 2, 4, 4] = 0.0
    result[..., 3, 0, 0] = 0.0
    result[..., 3, 0, 1] = 0.0
    result[..., 3, 0, 2] = 0.0
    result[..., 3, 0, 3] = 0.0
    result[..., 3, 0, 4] = 0.0
    result[..., 3, 1, 0] = 0.0
    result[..., 3, 1, 1] = 0.0
    result[..., 3, 1, 2] = 0.0
    result[..., 3, 1, 3] = 0.0
    result[..., 3, 1, 4] = 0.0
    result[..., 3, 2, 0] = 0.0
    result[..., 3, 2, 1] = 0.0
    result[..., 3, 2, 2] = 0.0
    result[..., 3, 2, 3] = 0.0
    result[..., 3, 2, 4] = 0.0
    result[..., 3, 3, 0] = 0.0
    result[..., 3, 3, 1] = 0.0
    result[..., 3, 3, 2] = 0.0
    result[..., 3, 3, 3] = 0.0
    result[..., 3, 3, 4] = 0.0
    result[..., 3, 4, 0] = 0.0
    result[..., 3, 4, 1] = 0.0
    result[..., 3, 4, 2] = 0.0
    result[..., 3, 4, 3] = 0.0
    result[..., 3, 4, 4] = 0.0
    result[..., 4, 0, 0] = 0.0
    result[..., 4, 0, 1] = 0.0
    result[..., 4, 0, 2] = 0.0
    result[..., 4, 0, 3] = 0.0
    result[..., 4, 0, 4] = 0.0
    result[..., 4, 1, 0] = 0.0
    result[..., 4, 1, 1] = 0.0
    result[..., 4, 1, 2] = 0.0
    result[..., 4, 1, 3] = 0.0
    result[..., 4, 1, 4] = 0.0
    result[..., 4, 2, 0] = 0.0
    result[..., 4, 2, 1] = 0.0
    result[..., 4, 2, 2] = 0.0
    result[..., 4, 2, 3] = 0.0
    result[..., 4, 2, 4] = 0.0
    result[..., 4, 3, 0] = 0.0
    result[..., 4, 3, 1] = 0.0
    result[..., 4, 3, 2] = 0.0
    result[..., 4, 3, 3] = 0.0
    result[..., 4, 3, 4] = 0.0
    result[..., 4, 4, 0] = 0.0
    result[..., 4, 4, 1] = 0.0
    result[..., 4, 4, 2] = 0.0
    result[..., 4, 4, 3] = 0.0
    result[..., 4, 4, 4] = 0.0
    return result


def turn_unknown_rate_process_noise_piecewise(
    *,
    T: npt.ArrayLike,
    vx: npt.ArrayLike,
    vy: npt.ArrayLike,
    omega: npt.ArrayLike,
    sigma_w: npt.ArrayLike,
    sigma_omega: npt.ArrayLike,
) -> Floats:
    """Covariance of the process noise of (x, vx, y, vy, omega) in a turn of unknown rate, with accelerations along both axes and of the turn that are noise, constant over a period, to first order.

    Name: motion.turn.unknown_rate.process_noise.piecewise.
    Definition: Q = sum of sigma^2 g g', g = d(state a period later)/d(acceleration).
    Conditioning: no expectation is taken.
    Source: Bar-Shalom, Li & Kirubarajan 2001 11.7, doi:10.1002/0471221279.

    Args:
        T: time from scan to scan [s], 0.001 to 10.
        vx: velocity along the x axis [m/s], -1000 to 1000.
        vy: velocity along the y axis [m/s], -1000 to 1000.
        omega: rate of the turn, counter-clockwise [rad/s], -0.5 to 0.5.
        sigma_w: standard deviation of the acceleration along each axis, constant over a period [m/s^2], 1e-06 to 1000.
        sigma_omega: standard deviation of the acceleration of the turn, constant over a period [rad/s^2], 1e-09 to 1.

    Returns:
        Shape of the broadcast arguments + (5, 5), unit [m, m/s, m, m/s, rad/s] × [m, m/s, m, m/s, rad/s].

    Accuracy: at most 119 ulp anywhere in this domain, proved for elementary functions within 1 ulp (float64).
    Errors are measured against what its terms are at most at any rate.
    """
    arguments = _floats(T, vx, vy, omega, sigma_w, sigma_omega)
    T, vx, vy, omega, sigma_w, sigma_omega = arguments
    T_squared = T**2
    product_1 = T * T_squared
    product_2 = T * omega
    term_1 = _stumpff(product_2, 2)
    term_2 = _stumpff(product_2, 1)
    term_3 = _stumpff(product_2, 3)
    sum_1 = 0.5 * term_2 - term_1 + term_3
    T_squared_squared = T_squared**2
    sum_2 = _stumpff(product_2, 4) - term_3 + 0.5 * term_1
    sum_3 = -T_squared_squared * omega * sum_2 * vx - product_1 * sum_1 * vy
    sigma_omega_squared = sigma_omega**2
    term_1_squared = term_1**2
    omega_squared = omega**2
    sigma_w_squared = sigma_w**2
    sum_4 = T_squared * T_squared**2 * omega_squared * term_3**2 + T_squared_squared * term_1_squared
    product_3 = sigma_w_squared * sum_4
    sin_product_2 = np.sin(product_2)
    cos_product_2 = np.cos(product_2)
    sum_5 = cos_product_2 * vy + sin_product_2 * vx
    sum_6 = T * T_squared**2 * omega_squared * term_1 * term_3 + product_1 * term_1 * term_2
    product_4 = sigma_w_squared * sum_6
    sum_7 = product_1 * sum_1 * vx - T_squared_squared * omega * sum_2 * vy
    sum_8 = cos_product_2 * vx - sin_product_2 * vy
    sum_9 = T_squared_squared * omega * term_1_squared - T_squared_squared * omega * term_2 * term_3
    sum_10 = T_squared * term_2**2 + T_squared_squared * omega_squared * term_1_squared
    product_5 = sigma_w_squared * sum_10
    sum_11 = T_squared_squared * omega * term_2 * term_3 - T_squared_squared * omega * term_1_squared
    result = _empty(arguments, (5, 5))
    result[..., 0, 0] = product_3 + sigma_omega_squared * sum_3**2
    result[..., 0, 1] = product_4 - 0.5 * T_squared * sigma_omega_squared * sum_3 * sum_5
    result[..., 0, 2] = sigma_omega_squared * sum_3 * sum_7
    result[..., 0, 3] = 0.5 * T_squared * sigma_omega_squared * sum_3 * sum_8 + sigma_w_squared * sum_9
    result[..., 0, 4] = T * sigma_omega_squared * sum_3
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = 0.25 * T_squared_squared * sigma_omega_squared * sum_5**2 + product_5
    result[..., 1, 2] = sigma_w_squared * sum_11 - 0.5 * T_squared * sigma_omega_squared * sum_5 * sum_7
    result[..., 1, 3] = -0.25 * T_squared_squared * sigma_omega_squared * sum_5 * sum_8
    result[..., 1, 4] = -0.5 * product_1 * sigma_omega_squared * sum_5
    result[..., 2, 0] = result[..., 0, 2]
    result[..., 2, 1] = result[..., 1, 2]
    result[..., 2, 2] = product_3 + sigma_omega_squared * sum_7**2
    result[..., 2, 3] = 0.5 * T_squared * sigma_omega_squared * sum_7 * sum_8 + product_4
    result[..., 2, 4] = T * sigma_omega_squared * sum_7
    result[..., 3, 0] = result[..., 0, 3]
    result[..., 3, 1] = result[..., 1, 3]
    result[..., 3, 2] = result[..., 2, 3]
    result[..., 3, 3] = 0.25 * T_squared_squared * sigma_omega_squared * sum_8**2 + product_5
    result[..., 3, 4] = 0.5 * product_1 * sigma_omega_squared * sum_8
    result[..., 4, 0] = result[..., 0, 4]
    result[..., 4, 1] = result[..., 1, 4]
    result[..., 4, 2] = result[..., 2, 4]
    result[..., 4, 3] = result[..., 3, 4]
    result[..., 4, 4] = T_squared * sigma_omega_squared
    return result


def ctrv_process_noise_piecewise(
    *,
    T: npt.ArrayLike,
    speed: npt.ArrayLike,
    heading: npt.ArrayLike,
    omega: npt.ArrayLike,
    sigma_w: npt.ArrayLike,
    sigma_omega: npt.ArrayLike,
) -> Floats:
    """Covariance of the process noise of (x, y, speed, heading, omega) at constant turn rate and velocity, with accelerations along the heading and of the turn that are noise, constant over a period, to first order.

    Name: motion.ctrv.process_noise.piecewise.
    Definition: Q = sum of sigma^2 g g', g = d(state a period later)/d(acceleration).
    Conditioning: no expectation is taken.
    Source: Bar-Shalom, Li & Kirubarajan 2001 11.7, doi:10.1002/0471221279.

    Args:
        T: time from scan to scan [s], 0.001 to 10.
        speed: speed along the heading [m/s], -1000 to 1000.
        heading: direction of the velocity, counter-clockwise from the x axis [rad], -3.1416 to 3.1416.
        omega: rate of the turn, counter-clockwise [rad/s], -0.5 to 0.5.
        sigma_w: standard deviation of the acceleration along the heading, constant over a period [m/s^2], 1e-06 to 1000.
        sigma_omega: standard deviation of the acceleration of the turn, constant over a period [rad/s^2], 1e-09 to 1.

    Returns:
        Shape of the broadcast arguments + (5, 5), unit [m, m, m/s, rad, rad/s] × [m, m, m/s, rad, rad/s].

    Accuracy: at most 43.3 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64). Errors are measured against what its terms are at most at any rate.
    """
    arguments = _floats(T, speed, heading, omega, sigma_w, sigma_omega)
    T, speed, heading, omega, sigma_w, sigma_omega = arguments
    T_squared = T**2
    product_1 = T * T_squared
    sin_heading = np.sin(heading)
    product_2 = T * omega
    term_1 = _stumpff(product_2, 2)
    term_2 = _stumpff(product_2, 1)
    term_3 = _stumpff(product_2, 3)
    sum_1 = 0.5 * term_2 - term_1 + term_3
    T_squared_squared = T_squared**2
    cos_heading = np.cos(heading)
    sum_2 = _stumpff(product_2, 4) - term_3 + 0.5 * term_1
    sum_3 = T_squared_squared * cos_heading * omega * sum_2 + product_1 * sin_heading * sum_1
    sigma_omega_squared = sigma_omega**2
    speed_squared = speed**2
    sum_4 = term_1 - term_3
    sum_5 = term_2 - term_1
    sum_6 = T_squared * cos_heading * sum_5 - omega * product_1 * sin_heading * sum_4
    sigma_w_squared = sigma_w**2
    sum_7 = cos_heading * product_1 * sum_1 - T_squared_squared * omega * sin_heading * sum_2
    sum_8 = T_squared * sin_heading * sum_5 + cos_heading * omega * product_1 * sum_4
    result = _empty(arguments, (5, 5))
    result[..., 0, 0] = sigma_omega_squared * speed_squared * sum_3**2 + sigma_w_squared * sum_6**2
    result[..., 0, 1] = sigma_w_squared * sum_6 * sum_8 - sigma_omega_squared * speed_squared * sum_3 * sum_7
    result[..., 0, 2] = T * sigma_w_squared * sum_6
    result[..., 0, 3] = -0.5 * T_squared * sigma_omega_squared * speed * sum_3
    result[..., 0, 4] = -T * sigma_omega_squared * speed * sum_3
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = sigma_omega_squared * speed_squared * sum_7**2 + sigma_w_squared * sum_8**2
    result[..., 1, 2] = T * sigma_w_squared * sum_8
    result[..., 1, 3] = 0.5 * T_squared * sigma_omega_squared * speed * sum_7
    result[..., 1, 4] = T * sigma_omega_squared * speed * sum_7
    result[..., 2, 0] = result[..., 0, 2]
    result[..., 2, 1] = result[..., 1, 2]
    result[..., 2, 2] = T_squared * sigma_w_squared
    result[..., 2, 3] = 0.0
    result[..., 2, 4] = 0.0
    result[..., 3, 0] = result[..., 0, 3]
    result[..., 3, 1] = result[..., 1, 3]
    result[..., 3, 2] = 0.0
    result[..., 3, 3] = 0.25 * T_squared_squared * sigma_omega_squared
    result[..., 3, 4] = 0.5 * product_1 * sigma_omega_squared
    result[..., 4, 0] = result[..., 0, 4]
    result[..., 4, 1] = result[..., 1, 4]
    result[..., 4, 2] = 0.0
    result[..., 4, 3] = result[..., 3, 4]
    result[..., 4, 4] = T_squared * sigma_omega_squared
    return result
