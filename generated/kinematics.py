"""NumPy functions of the quantities kinematics.*.

Written by radartrack regenerate, generator 1, derivation 3c363e96be34a8d4; not to be edited.
"""

import numpy as np
import numpy.typing as npt

__all__ = [
    "constant_acceleration_process_noise",
    "constant_acceleration_transition",
    "constant_jerk_process_noise",
    "constant_jerk_transition",
    "constant_position_process_noise",
    "constant_position_transition",
    "constant_velocity_process_noise",
    "constant_velocity_transition",
    "plane_observation",
    "plane_transition",
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


def constant_position_transition(*, T: npt.ArrayLike) -> Floats:
    """Transition of position of one axis from scan to scan, with white noise in the velocity.

    Name: kinematics.constant_position.transition.
    Definition: F = e^(AT).
    Conditioning: no expectation is taken.
    Source: Bar-Shalom, Li & Kirubarajan 2001 6.2, doi:10.1002/0471221279.

    Args:
        T: time from scan to scan [s], 0.001 to 1000.

    Returns:
        Shape of the broadcast arguments + (1, 1), unit 1.

    Accuracy: at most 0 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
    """
    arguments = _floats(T)
    T, = arguments
    result = _empty(arguments, (1, 1))
    result[..., 0, 0] = 1.0
    return result


def constant_position_process_noise(*, T: npt.ArrayLike, q: npt.ArrayLike) -> Floats:
    """Covariance of the process noise of position of one axis from scan to scan, with white noise in the velocity.

    Name: kinematics.constant_position.process_noise.
    Definition: Q = q int_0^T e^(As) g g' e^(As)' ds.
    Conditioning: no expectation is taken.
    Source: Bar-Shalom, Li & Kirubarajan 2001 6.2, doi:10.1002/0471221279.

    Args:
        T: time from scan to scan [s], 0.001 to 1000.
        q: intensity of the white noise in the velocity [m^2/s], 1e-09 to 1e+06.

    Returns:
        Shape of the broadcast arguments + (1, 1), unit m^2.

    Accuracy: at most 0.5 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
    """
    arguments = _floats(T, q)
    T, q = arguments
    result = _empty(arguments, (1, 1))
    result[..., 0, 0] = T * q
    return result


def constant_velocity_transition(*, T: npt.ArrayLike) -> Floats:
    """Transition of position and velocity of one axis from scan to scan, with white noise in the acceleration.

    Name: kinematics.constant_velocity.transition.
    Definition: F = e^(AT).
    Conditioning: no expectation is taken.
    Source: Bar-Shalom, Li & Kirubarajan 2001 6.2, doi:10.1002/0471221279.

    Args:
        T: time from scan to scan [s], 0.001 to 1000.

    Returns:
        Shape of the broadcast arguments + (2, 2), unit [m, m/s] × [1/m, s/m].

    Accuracy: at most 0 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
    """
    arguments = _floats(T)
    T, = arguments
    result = _empty(arguments, (2, 2))
    result[..., 0, 0] = 1.0
    result[..., 0, 1] = T
    result[..., 1, 0] = 0.0
    result[..., 1, 1] = 1.0
    return result


def constant_velocity_process_noise(*, T: npt.ArrayLike, q: npt.ArrayLike) -> Floats:
    """Covariance of the process noise of position and velocity of one axis from scan to scan, with white noise in the acceleration.

    Name: kinematics.constant_velocity.process_noise.
    Definition: Q = q int_0^T e^(As) g g' e^(As)' ds.
    Conditioning: no expectation is taken.
    Source: Bar-Shalom, Li & Kirubarajan 2001 6.2, doi:10.1002/0471221279.

    Args:
        T: time from scan to scan [s], 0.001 to 1000.
        q: intensity of the white noise in the acceleration [m^2/s^3], 1e-09 to 1e+06.

    Returns:
        Shape of the broadcast arguments + (2, 2), unit [m, m/s] × [m, m/s].

    Accuracy: at most 2 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
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


def constant_acceleration_transition(*, T: npt.ArrayLike) -> Floats:
    """Transition of position, velocity and acceleration of one axis from scan to scan, with white noise in the jerk.

    Name: kinematics.constant_acceleration.transition.
    Definition: F = e^(AT).
    Conditioning: no expectation is taken.
    Source: Bar-Shalom, Li & Kirubarajan 2001 6.2, doi:10.1002/0471221279.

    Args:
        T: time from scan to scan [s], 0.001 to 1000.

    Returns:
        Shape of the broadcast arguments + (3, 3), unit [m, m/s, m/s^2] × [1/m, s/m, s^2/m].

    Accuracy: at most 0.5 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
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


def constant_acceleration_process_noise(*, T: npt.ArrayLike, q: npt.ArrayLike) -> Floats:
    """Covariance of the process noise of position, velocity and acceleration of one axis from scan to scan, with white noise in the jerk.

    Name: kinematics.constant_acceleration.process_noise.
    Definition: Q = q int_0^T e^(As) g g' e^(As)' ds.
    Conditioning: no expectation is taken.
    Source: Bar-Shalom, Li & Kirubarajan 2001 6.2, doi:10.1002/0471221279.

    Args:
        T: time from scan to scan [s], 0.001 to 1000.
        q: intensity of the white noise in the jerk [m^2/s^5], 1e-09 to 1e+06.

    Returns:
        Shape of the broadcast arguments + (3, 3), unit [m, m/s, m/s^2] × [m, m/s, m/s^2].

    Accuracy: at most 3.5 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
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


def constant_jerk_transition(*, T: npt.ArrayLike) -> Floats:
    """Transition of position, velocity, acceleration and jerk of one axis from scan to scan, with white noise in the derivative of the jerk.

    Name: kinematics.constant_jerk.transition.
    Definition: F = e^(AT).
    Conditioning: no expectation is taken.
    Source: Bar-Shalom, Li & Kirubarajan 2001 6.2, doi:10.1002/0471221279.

    Args:
        T: time from scan to scan [s], 0.001 to 1000.

    Returns:
        Shape of the broadcast arguments + (4, 4), unit [m, m/s, m/s^2, m/s^3] × [1/m, s/m, s^2/m, s^3/m].

    Accuracy: at most 1.5 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
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


def constant_jerk_process_noise(*, T: npt.ArrayLike, q: npt.ArrayLike) -> Floats:
    """Covariance of the process noise of position, velocity, acceleration and jerk of one axis from scan to scan, with white noise in the derivative of the jerk.

    Name: kinematics.constant_jerk.process_noise.
    Definition: Q = q int_0^T e^(As) g g' e^(As)' ds.
    Conditioning: no expectation is taken.
    Source: Bar-Shalom, Li & Kirubarajan 2001 6.2, doi:10.1002/0471221279.

    Args:
        T: time from scan to scan [s], 0.001 to 1000.
        q: intensity of the white noise in the derivative of the jerk [m^2/s^7], 1e-09 to 1e+06.

    Returns:
        Shape of the broadcast arguments + (4, 4), unit [m, m/s, m/s^2, m/s^3] × [m, m/s, m/s^2, m/s^3].

    Accuracy: at most 4 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
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


def plane_transition(*, T: npt.ArrayLike) -> Floats:
    """Transition of (x, vx, y, vy) from scan to scan at constant velocity.

    Name: kinematics.plane.transition.
    Definition: one block e^(AT) for each axis.
    Conditioning: no expectation is taken.
    Source: Prosov F.

    Args:
        T: time from scan to scan [s], 0.001 to 1000.

    Returns:
        Shape of the broadcast arguments + (4, 4), unit [m, m/s, m, m/s] × [1/m, s/m, 1/m, s/m].

    Accuracy: at most 0 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
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

    Name: kinematics.plane.observation.
    Definition: the derivative of the position by the state.
    Conditioning: no expectation is taken.
    Source: Prosov H_2.

    Returns:
        Shape of the broadcast arguments + (2, 4), unit [m, m] × [1/m, s/m, 1/m, s/m].

    Accuracy: at most 0 ulp from 50-digit arithmetic at 500 points of this domain (float64, independent
    errors).
    """
    return np.array([[1.0, 0.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0]])[()]
