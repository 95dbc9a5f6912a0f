"""NumPy functions of the quantities taylor.*.

Written by radartrack regenerate, generator 1, derivation ed0062391832288c; not to be edited.
"""

import numpy as np
import numpy.typing as npt

__all__ = [
    "mean_shift",
    "quadratic_term",
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


def quadratic_term(
    *,
    f_xx: npt.ArrayLike,
    f_xy: npt.ArrayLike,
    f_yy: npt.ArrayLike,
    dx: npt.ArrayLike,
    dy: npt.ArrayLike,
) -> Floats:
    """Quadratic term of Taylor's formula for two variables.

    Name: taylor.quadratic_term.
    Definition: the polynomial of second degree with these second derivatives.
    Conditioning: no expectation is taken.
    Source: Prosov (5).

    Args:
        f_xx: second derivative by the first variable [m], -1e+06 to 1e+06.
        f_xy: mixed derivative [m], -1e+06 to 1e+06.
        f_yy: second derivative by the second variable [m], -1e+06 to 1e+06.
        dx: increment of the first variable, in its unit [1], -1000 to 1000.
        dy: increment of the second variable, in its unit [1], -1000 to 1000.

    Returns:
        Shape of the broadcast arguments, unit m.

    Accuracy: at most 5.01 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64). Errors are measured against the sizes of the terms.
    """
    arguments = _floats(f_xx, f_xy, f_yy, dx, dy)
    f_xx, f_xy, f_yy, dx, dy = arguments
    result = _empty(arguments, ())
    result[...] = 0.5 * dx**2 * f_xx + dx * dy * f_xy + 0.5 * dy**2 * f_yy
    return result[()]


def mean_shift(
    *,
    f_xx: npt.ArrayLike,
    f_xy: npt.ArrayLike,
    f_yy: npt.ArrayLike,
    D_1: npt.ArrayLike,
    D_2: npt.ArrayLike,
    K_12: npt.ArrayLike,
) -> Floats:
    """What the quadratic term adds to the mean of a function of two variables with errors.

    Name: taylor.mean_shift.
    Definition: L f.
    Conditioning: truth-conditioned: the measured symbols stand for the true values.
    Source: Prosov (7).

    Args:
        f_xx: second derivative by the first variable [m], -1e+06 to 1e+06.
        f_xy: mixed derivative [m], -1e+06 to 1e+06.
        f_yy: second derivative by the second variable [m], -1e+06 to 1e+06.
        D_1: variance of the first variable, in its unit squared [1], 1e-12 to 1000.
        D_2: variance of the second variable, in its unit squared [1], 1e-12 to 1000.
        K_12: covariance of the variables, in their units [1], -1000 to 1000.

    Returns:
        Shape of the broadcast arguments, unit m.

    Accuracy: at most 3.01 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 237. Errors are measured against the
    sizes of the terms.
    """
    arguments = _floats(f_xx, f_xy, f_yy, D_1, D_2, K_12)
    f_xx, f_xy, f_yy, D_1, D_2, K_12 = arguments
    result = _empty(arguments, ())
    result[...] = 0.5 * D_1 * f_xx + 0.5 * D_2 * f_yy + K_12 * f_xy
    return result[()]
