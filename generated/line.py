"""NumPy functions of the quantities line.*.

Written by radartrack regenerate, generator 1, derivation 19d700101250bf48; not to be edited.
"""

import numpy as np
import numpy.typing as npt

__all__ = [
    "distance",
    "folded_mean_factor",
    "folded_std",
    "folded_std_factor",
    "gradient",
    "hessian",
    "inclination",
    "intercept",
    "motion_distance",
    "motion_printed_position_std",
    "motion_printed_std",
    "motion_residual",
    "motion_slope_limit",
    "motion_variance_limit",
    "objective",
    "ordinary_degrees_of_freedom",
    "ordinary_leverage",
    "ordinary_slope",
    "ordinary_variance",
    "position_std",
    "position_std_in_space",
    "slope",
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


def distance(*, x: npt.ArrayLike, y: npt.ArrayLike, k: npt.ArrayLike, d: npt.ArrayLike) -> Floats:
    """Perpendicular distance of a point from a line, positive above it.

    Name: line.distance.
    Definition: the least distance to a point of the line.
    Conditioning: no expectation is taken.
    Source: Gao et al. 2020 (3), doi:10.12126/see.2020.02.013.

    Args:
        x: first coordinate of a point [m], -1e+06 to 1e+06.
        y: second coordinate of a point [m], -1e+06 to 1e+06.
        k: slope of the line [1], -10 to 10.
        d: intercept of the line [m], -1e+06 to 1e+06.

    Returns:
        Shape of the broadcast arguments, unit m.

    Accuracy: at most 5.51 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64). Errors are measured against the sizes of the terms.
    """
    arguments = _floats(x, y, k, d)
    x, y, k, d = arguments
    result = _empty(arguments, ())
    result[...] = (y - d - k * x) / np.sqrt(1.0 + k**2)
    return result[()]


def objective(
    *,
    W: npt.ArrayLike,
    mean_x: npt.ArrayLike,
    mean_y: npt.ArrayLike,
    S_xx: npt.ArrayLike,
    S_xy: npt.ArrayLike,
    S_yy: npt.ArrayLike,
    k: npt.ArrayLike,
    d: npt.ArrayLike,
) -> Floats:
    """Weighted sum of the squared perpendicular distances.

    Name: line.objective.
    Definition: sum of w l^2.
    Conditioning: no expectation is taken.
    Source: Gao et al. 2020 (4) with W = n, (5) with the squares of its weights, doi:10.12126/see.2020.02.013.

    Args:
        W: sum of the weights of the points [1], 0.001 to 1e+06.
        mean_x: weighted mean of the first coordinates [m], -1e+06 to 1e+06.
        mean_y: weighted mean of the second coordinates [m], -1e+06 to 1e+06.
        S_xx: weighted sum of (x - mean_x)^2 [m^2], 0.01 to 1e+12.
        S_xy: weighted sum of (x - mean_x)(y - mean_y) [m^2], -1e+08 to 1e+08.
        S_yy: weighted sum of (y - mean_y)^2 [m^2], 0.01 to 1e+12.
        k: slope of the line [1], -10 to 10.
        d: intercept of the line [m], -1e+06 to 1e+06.

    Returns:
        Shape of the broadcast arguments, unit m^2.

    Accuracy: at most 13.1 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64). Errors are measured against the sizes of the terms.
    """
    arguments = _floats(W, mean_x, mean_y, S_xx, S_xy, S_yy, k, d)
    W, mean_x, mean_y, S_xx, S_xy, S_yy, k, d = arguments
    k_squared = k**2
    term_1 = 1.0 / (1.0 + k_squared)
    result = _empty(arguments, ())
    result[...] = (
        S_xx * k_squared * term_1
        - 2.0 * S_xy * k * term_1
        + S_yy * term_1
        + (mean_y - d - k * mean_x)**2 * W * term_1
    )
    return result[()]


def gradient(
    *,
    W: npt.ArrayLike,
    mean_x: npt.ArrayLike,
    mean_y: npt.ArrayLike,
    S_xx: npt.ArrayLike,
    S_xy: npt.ArrayLike,
    S_yy: npt.ArrayLike,
    k: npt.ArrayLike,
    d: npt.ArrayLike,
) -> Floats:
    """Derivatives of the sum of squared distances by slope and intercept.

    Name: line.gradient.
    Definition: d(sum of w l^2)/d(k, d).
    Conditioning: no expectation is taken.
    Source: Gao et al. 2020 (6), doi:10.12126/see.2020.02.013.

    Args:
        W: sum of the weights of the points [1], 0.001 to 1e+06.
        mean_x: weighted mean of the first coordinates [m], -1e+06 to 1e+06.
        mean_y: weighted mean of the second coordinates [m], -1e+06 to 1e+06.
        S_xx: weighted sum of (x - mean_x)^2 [m^2], 0.01 to 1e+12.
        S_xy: weighted sum of (x - mean_x)(y - mean_y) [m^2], -1e+08 to 1e+08.
        S_yy: weighted sum of (y - mean_y)^2 [m^2], 0.01 to 1e+12.
        k: slope of the line [1], -10 to 10.
        d: intercept of the line [m], -1e+06 to 1e+06.

    Returns:
        Shape of the broadcast arguments + (2), unit [m^2, m].

    Accuracy: at most 20.1 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64). Errors are measured against the sizes of the terms.
    """
    arguments = _floats(W, mean_x, mean_y, S_xx, S_xy, S_yy, k, d)
    W, mean_x, mean_y, S_xx, S_xy, S_yy, k, d = arguments
    k_squared = k**2
    stretch = 1.0 + k_squared
    offset = mean_y - d - k * mean_x
    lever = S_xy - S_xx * k + W * mean_x * offset
    misfit = S_yy - 2.0 * S_xy * k + S_xx * k_squared + W * offset**2
    term_1 = 1.0 / stretch
    sum_1 = -2.0 * lever - 2.0 * k * misfit * term_1
    result = _empty(arguments, (2,))
    result[..., 0] = sum_1 * term_1
    result[..., 1] = -2.0 * W * offset * term_1
    return result


def hessian(
    *,
    W: npt.ArrayLike,
    mean_x: npt.ArrayLike,
    mean_y: npt.ArrayLike,
    S_xx: npt.ArrayLike,
    S_xy: npt.ArrayLike,
    S_yy: npt.ArrayLike,
    k: npt.ArrayLike,
    d: npt.ArrayLike,
) -> Floats:
    """Second derivatives of the sum of squared distances by slope and intercept.

    Name: line.hessian.
    Definition: d2(sum of w l^2)/d(k, d)2.
    Conditioning: no expectation is taken.
    Source: Gao et al. 2020 (6), doi:10.12126/see.2020.02.013.

    Args:
        W: sum of the weights of the points [1], 0.001 to 1e+06.
        mean_x: weighted mean of the first coordinates [m], -1e+06 to 1e+06.
        mean_y: weighted mean of the second coordinates [m], -1e+06 to 1e+06.
        S_xx: weighted sum of (x - mean_x)^2 [m^2], 0.01 to 1e+12.
        S_xy: weighted sum of (x - mean_x)(y - mean_y) [m^2], -1e+08 to 1e+08.
        S_yy: weighted sum of (y - mean_y)^2 [m^2], 0.01 to 1e+12.
        k: slope of the line [1], -10 to 10.
        d: intercept of the line [m], -1e+06 to 1e+06.

    Returns:
        Shape of the broadcast arguments + (2, 2), unit [m, 1] × [m, 1].

    Accuracy: at most 31.6 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64). Errors are measured against the sizes of the terms.
    """
    arguments = _floats(W, mean_x, mean_y, S_xx, S_xy, S_yy, k, d)
    W, mean_x, mean_y, S_xx, S_xy, S_yy, k, d = arguments
    k_squared = k**2
    stretch = 1.0 + k_squared
    offset = mean_y - d - k * mean_x
    lever = S_xy - S_xx * k + W * mean_x * offset
    misfit = S_yy - 2.0 * S_xy * k + S_xx * k_squared + W * offset**2
    term_1 = 1.0 / stretch
    sum_1 = 4.0 * k * lever - (1.0 - 3.0 * k_squared) * misfit * term_1
    sum_2 = 2.0 * S_xx + 2.0 * W * mean_x**2 + 2.0 * sum_1 * term_1
    sum_3 = 2.0 * k * offset * term_1 + mean_x
    result = _empty(arguments, (2, 2))
    result[..., 0, 0] = sum_2 * term_1
    result[..., 0, 1] = 2.0 * W * sum_3 * term_1
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = 2.0 * W * term_1
    return result


def intercept(*, k: npt.ArrayLike, mean_x: npt.ArrayLike, mean_y: npt.ArrayLike) -> Floats:
    """Intercept of the line of least squared distances, given its slope.

    Name: line.intercept.
    Definition: the zero of the derivative by d.
    Conditioning: no expectation is taken.
    Source: Gao et al. 2020 (6), doi:10.12126/see.2020.02.013.

    Args:
        k: slope of the line [1], -10 to 10.
        mean_x: weighted mean of the first coordinates [m], -1e+06 to 1e+06.
        mean_y: weighted mean of the second coordinates [m], -1e+06 to 1e+06.

    Returns:
        Shape of the broadcast arguments, unit m.

    Accuracy: at most 2.01 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 237. Errors are measured against the
    sizes of the terms.
    """
    arguments = _floats(k, mean_x, mean_y)
    k, mean_x, mean_y = arguments
    result = _empty(arguments, ())
    result[...] = mean_y - k * mean_x
    return result[()]


def slope(*, S_xx: npt.ArrayLike, S_xy: npt.ArrayLike, S_yy: npt.ArrayLike) -> Floats:
    """Slope of the line of least squared distances; S_xy must not be zero.

    Name: line.slope.
    Definition: the stationary slope where the Hessian is positive.
    Conditioning: no expectation is taken.
    Source: Pearson 1901; Gao et al. 2020 (6), doi:10.1080/14786440109462720, doi:10.12126/see.2020.02.013.

    Args:
        S_xx: weighted sum of (x - mean_x)^2 [m^2], 0.01 to 1e+12.
        S_xy: weighted sum of (x - mean_x)(y - mean_y) [m^2], -1e+08 to 1e+08.
        S_yy: weighted sum of (y - mean_y)^2 [m^2], 0.01 to 1e+12.

    Returns:
        Shape of the broadcast arguments, unit 1.

    Accuracy: at most 6.51 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 124.
    """
    arguments = _floats(S_xx, S_xy, S_yy)
    S_xx, S_xy, S_yy = arguments
    excess = S_xx - S_yy
    Abs_excess = np.abs(excess)
    result = _empty(arguments, ())
    result[...] = (
        0.5 * (Abs_excess - excess) / S_xy
        + 2.0 * S_xy / (Abs_excess + np.sqrt(4.0 * S_xy**2 + excess**2))
    )
    return result[()]


def inclination(*, S_xx: npt.ArrayLike, S_xy: npt.ArrayLike, S_yy: npt.ArrayLike) -> Floats:
    """Angle of the line of least squared distances with the x axis.

    Name: line.inclination.
    Definition: arc tangent of the slope.
    Conditioning: no expectation is taken.
    Source: Pearson 1901, doi:10.1080/14786440109462720.

    Args:
        S_xx: weighted sum of (x - mean_x)^2 [m^2], 0.01 to 1e+12.
        S_xy: weighted sum of (x - mean_x)(y - mean_y) [m^2], -1e+08 to 1e+08.
        S_yy: weighted sum of (y - mean_y)^2 [m^2], 0.01 to 1e+12.

    Returns:
        Shape of the broadcast arguments, unit rad.

    Accuracy: at most 3.01 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 9.01.
    """
    arguments = _floats(S_xx, S_xy, S_yy)
    S_xx, S_xy, S_yy = arguments
    result = _empty(arguments, ())
    result[...] = 0.5 * np.arctan2(2.0 * S_xy, S_xx - S_yy)
    return result[()]


def ordinary_slope(*, S_tt: npt.ArrayLike, S_tx: npt.ArrayLike) -> Floats:
    """Speed fitted by ordinary least squares of a coordinate on time.

    Name: line.ordinary.slope.
    Definition: the zero of the derivative of the sum of squared residuals.
    Conditioning: no expectation is taken.
    Source: Gauss 1823.

    Args:
        S_tt: sum of (t - mean_t)^2 [s^2], 1 to 1e+10.
        S_tx: sum of (t - mean_t)(x - mean_x) [m·s], -1e+08 to 1e+08.

    Returns:
        Shape of the broadcast arguments, unit m/s.

    Accuracy: at most 1.01 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 1.01.
    """
    arguments = _floats(S_tt, S_tx)
    S_tt, S_tx = arguments
    result = _empty(arguments, ())
    result[...] = S_tx / S_tt
    return result[()]


def ordinary_leverage(
    *,
    t: npt.ArrayLike,
    mean_t: npt.ArrayLike,
    n: npt.ArrayLike,
    S_tt: npt.ArrayLike,
) -> Floats:
    """Share of its own error that the fitted line takes from a plot.

    Name: line.ordinary.leverage.
    Definition: 1 - d2(sum of squared residuals)/d(error)2/2.
    Conditioning: no expectation is taken.
    Source: Gauss 1823.

    Args:
        t: time of a plot [s], -10000 to 10000.
        mean_t: mean of the times [s], -10000 to 10000.
        n: number of plots [1], 3 to 1e+06.
        S_tt: sum of (t - mean_t)^2 [s^2], 1 to 1e+10.

    Returns:
        Shape of the broadcast arguments, unit 1.

    Accuracy: at most 6.01 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 240.
    """
    arguments = _floats(t, mean_t, n, S_tt)
    t, mean_t, n, S_tt = arguments
    result = _empty(arguments, ())
    result[...] = (mean_t - t)**2 / S_tt + 1.0 / n
    return result[()]


def ordinary_degrees_of_freedom(*, n: npt.ArrayLike) -> Floats:
    """Expected sum of squared residuals over the variance of one error.

    Name: line.ordinary.degrees_of_freedom.
    Definition: sum of (1 - leverage).
    Conditioning: truth-conditioned: the measured symbols stand for the true values.
    Source: Gauss 1823.

    Args:
        n: number of plots [1], 3 to 1e+06.

    Returns:
        Shape of the broadcast arguments, unit 1.

    Accuracy: at most 1.01 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 1.01.
    """
    arguments = _floats(n)
    n, = arguments
    result = _empty(arguments, ())
    result[...] = n - 2.0
    return result[()]


def ordinary_variance(
    *,
    n: npt.ArrayLike,
    S_tt: npt.ArrayLike,
    S_tx: npt.ArrayLike,
    S_xx: npt.ArrayLike,
) -> Floats:
    """Unbiased estimate of the error variance of a coordinate on a straight track.

    Name: line.ordinary.variance.
    Definition: sum of squared residuals over degrees of freedom.
    Conditioning: measurement-conditioned: the measured symbols stand for the measurement.
    Source: Gauss 1823.

    Args:
        n: number of plots [1], 3 to 1e+06.
        S_tt: sum of (t - mean_t)^2 [s^2], 1 to 1e+10.
        S_tx: sum of (t - mean_t)(x - mean_x) [m·s], -1e+08 to 1e+08.
        S_xx: sum of (x - mean_x)^2 [m^2], 0.01 to 1e+12.

    Returns:
        Shape of the broadcast arguments, unit m^2.

    Accuracy: at most 6.01 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 242. Errors are measured against the
    sizes of the terms.
    """
    arguments = _floats(n, S_tt, S_tx, S_xx)
    n, S_tt, S_tx, S_xx = arguments
    result = _empty(arguments, ())
    result[...] = (S_xx - S_tx**2 / S_tt) / (n - 2.0)
    return result[()]


def folded_mean_factor() -> Floats:
    """Mean of the absolute value of a centred Gaussian over its standard deviation.

    Name: line.folded_mean_factor.
    Definition: E|l| for l ~ N(0, 1).
    Conditioning: truth-conditioned: the measured symbols stand for the true values.
    Source: Leone et al. 1961, doi:10.2307/1266560.

    Returns:
        Shape of the broadcast arguments, unit 1.

    Accuracy: at most 3.51 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 3.51.
    """
    return np.array(np.sqrt(2.0) / np.sqrt(np.pi))[()]


def folded_std_factor() -> Floats:
    """Standard deviation of the absolute value of a centred Gaussian over its own.

    Name: line.folded_std_factor.
    Definition: sqrt(1 - (E|l|)^2) for l ~ N(0, 1).
    Conditioning: truth-conditioned: the measured symbols stand for the true values.
    Source: Leone et al. 1961, doi:10.2307/1266560.

    Returns:
        Shape of the broadcast arguments, unit 1.

    Accuracy: at most 3.26 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 3.26.
    """
    return np.array(np.sqrt(1.0 - 2.0 / np.pi))[()]


def folded_std(*, sigma_l: npt.ArrayLike) -> Floats:
    """What (9) estimates for Gaussian distances.

    Name: line.folded_std.
    Definition: standard deviation of |l|.
    Conditioning: truth-conditioned: the measured symbols stand for the true values.
    Source: Gao et al. 2020 (9), doi:10.12126/see.2020.02.013.

    Args:
        sigma_l: standard deviation of a perpendicular distance [m], 0.01 to 1e+05.

    Returns:
        Shape of the broadcast arguments, unit m.

    Accuracy: at most 4.26 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 4.26.
    """
    arguments = _floats(sigma_l)
    sigma_l, = arguments
    result = _empty(arguments, ())
    result[...] = sigma_l * np.sqrt(1.0 - 2.0 / np.pi)
    return result[()]


def motion_residual(*, t: npt.ArrayLike, x: npt.ArrayLike, v: npt.ArrayLike, d: npt.ArrayLike) -> Floats:
    """Distance of a plot from a motion at constant speed, along the coordinate.

    Name: line.motion.residual.
    Definition: x - v t - d.
    Conditioning: no expectation is taken.
    Source: Gao et al. 2020 2.3, doi:10.12126/see.2020.02.013.

    Args:
        t: time of a plot [s], -10000 to 10000.
        x: coordinate of a plot [m], -1e+06 to 1e+06.
        v: speed of the target along the coordinate [m/s], -10000 to 10000.
        d: coordinate at time zero [m], -1e+06 to 1e+06.

    Returns:
        Shape of the broadcast arguments, unit m.

    Accuracy: at most 2.01 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 237. Errors are measured against the
    sizes of the terms.
    """
    arguments = _floats(t, x, v, d)
    t, x, v, d = arguments
    result = _empty(arguments, ())
    result[...] = x - d - t * v
    return result[()]


def motion_distance(
    *,
    t: npt.ArrayLike,
    x: npt.ArrayLike,
    v: npt.ArrayLike,
    d: npt.ArrayLike,
    c: npt.ArrayLike,
) -> Floats:
    """Perpendicular distance of a plot from a motion, in the plane of c t and x.

    Name: line.motion.distance.
    Definition: (x - v t - d)/sqrt(1 + (v/c)^2).
    Conditioning: no expectation is taken.
    Source: Gao et al. 2020 (3) as used in (8), doi:10.12126/see.2020.02.013.

    Args:
        t: time of a plot [s], -10000 to 10000.
        x: coordinate of a plot [m], -1e+06 to 1e+06.
        v: speed of the target along the coordinate [m/s], -10000 to 10000.
        d: coordinate at time zero [m], -1e+06 to 1e+06.
        c: speed that turns times into lengths, 1 m/s in the print [m/s], 0.01 to 10000.

    Returns:
        Shape of the broadcast arguments, unit m.

    Accuracy: at most 7.01 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64). Errors are measured against the sizes of the terms.
    """
    arguments = _floats(t, x, v, d, c)
    t, x, v, d, c = arguments
    result = _empty(arguments, ())
    result[...] = (x - d - t * v) / np.sqrt(1.0 + v**2 / c**2)
    return result[()]


def motion_printed_std(*, v: npt.ArrayLike, sigma_x: npt.ArrayLike, c: npt.ArrayLike) -> Floats:
    """What (9) estimates from many plots about the true line.

    Name: line.motion.printed_std.
    Definition: standard deviation of |l| for Gaussian errors of x.
    Conditioning: truth-conditioned: the measured symbols stand for the true values.
    Source: Gao et al. 2020 (9), doi:10.12126/see.2020.02.013.

    Args:
        v: speed of the target along the coordinate [m/s], -10000 to 10000.
        sigma_x: standard deviation of the error of x [m], 0.01 to 1e+05.
        c: speed that turns times into lengths, 1 m/s in the print [m/s], 0.01 to 10000.

    Returns:
        Shape of the broadcast arguments, unit m.

    Accuracy: at most 9.26 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 127.
    """
    arguments = _floats(v, sigma_x, c)
    v, sigma_x, c = arguments
    result = _empty(arguments, ())
    result[...] = sigma_x * np.sqrt(1.0 - 2.0 / np.pi) / np.sqrt(1.0 + v**2 / c**2)
    return result[()]


def motion_printed_position_std(
    *,
    v_x: npt.ArrayLike,
    v_y: npt.ArrayLike,
    sigma_x: npt.ArrayLike,
    sigma_y: npt.ArrayLike,
    c: npt.ArrayLike,
) -> Floats:
    """What (10) estimates from many plots about the true lines.

    Name: line.motion.printed_position_std.
    Definition: root mean square of both.
    Conditioning: truth-conditioned: the measured symbols stand for the true values.
    Source: Gao et al. 2020 (10), doi:10.12126/see.2020.02.013.

    Args:
        v_x: speed along x [m/s], -10000 to 10000.
        v_y: speed along y [m/s], -10000 to 10000.
        sigma_x: standard deviation of the error of x [m], 0.01 to 1e+05.
        sigma_y: standard deviation of the error of y [m], 0.01 to 1e+05.
        c: speed that turns times into lengths, 1 m/s in the print [m/s], 0.01 to 10000.

    Returns:
        Shape of the broadcast arguments, unit m.

    Accuracy: at most 9.26 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 127.
    """
    arguments = _floats(v_x, v_y, sigma_x, sigma_y, c)
    v_x, v_y, sigma_x, sigma_y, c = arguments
    sum_1 = 1.0 - 2.0 / np.pi
    term_1 = 1.0 / c**2
    result = _empty(arguments, ())
    result[...] = np.sqrt(0.5 * sigma_x**2 * sum_1 / (1.0 + term_1 * v_x**2) + 0.5 * sigma_y**2 * sum_1 / (1.0 + term_1 * v_y**2))
    return result[()]


def motion_slope_limit(
    *,
    v: npt.ArrayLike,
    sigma_x: npt.ArrayLike,
    std_t: npt.ArrayLike,
    c: npt.ArrayLike,
) -> Floats:
    """Speed to which the perpendicular fit of a coordinate on time tends.

    Name: line.motion.slope_limit.
    Definition: c times the slope of the population.
    Conditioning: truth-conditioned: the measured symbols stand for the true values.
    Source: Gao et al. 2020 (4) as used in 2.2, doi:10.12126/see.2020.02.013.

    Args:
        v: speed of the target along the coordinate, not zero [m/s], 0.01 to 10000.
        sigma_x: standard deviation of the error of x [m], 0.01 to 1e+05.
        std_t: root mean square of the times about their mean [s], 1 to 10000.
        c: speed that turns times into lengths, 1 m/s in the print [m/s], 0.01 to 10000.

    Returns:
        Shape of the broadcast arguments, unit m/s.

    Accuracy: measured, not proved: at most 3.5 ulp from 50-digit arithmetic at 500 points of this domain
    (float64, independent errors). Errors are measured against itself times the condition of the sums of
    squares that it is made of.
    """
    arguments = _floats(v, sigma_x, std_t, c)
    v, sigma_x, std_t, c = arguments
    std_t_squared = std_t**2
    excess = (c + v) * (c - v) * std_t_squared - sigma_x**2
    Abs_excess = np.abs(excess)
    sum_1 = (
        0.5 * (Abs_excess - excess) / (c * v * std_t**2)
        + 2.0 * c * std_t_squared * v / (Abs_excess + np.sqrt(4.0 * c**2 * std_t_squared**2 * v**2 + excess**2))
    )
    result = _empty(arguments, ())
    result[...] = c * sum_1
    return result[()]


def motion_variance_limit(
    *,
    v: npt.ArrayLike,
    sigma_x: npt.ArrayLike,
    std_t: npt.ArrayLike,
    c: npt.ArrayLike,
) -> Floats:
    """Mean squared distance to which the perpendicular fit of a coordinate tends.

    Name: line.motion.variance_limit.
    Definition: the objective per plot at its minimum.
    Conditioning: truth-conditioned: the measured symbols stand for the true values.
    Source: Gao et al. 2020 (4) as used in 2.2, doi:10.12126/see.2020.02.013.

    Args:
        v: speed of the target along the coordinate, not zero [m/s], 0.01 to 10000.
        sigma_x: standard deviation of the error of x [m], 0.01 to 1e+05.
        std_t: root mean square of the times about their mean [s], 1 to 10000.
        c: speed that turns times into lengths, 1 m/s in the print [m/s], 0.01 to 10000.

    Returns:
        Shape of the broadcast arguments, unit m^2.

    Accuracy: measured, not proved: at most 3.5 ulp from 50-digit arithmetic at 500 points of this domain
    (float64, independent errors).
    """
    arguments = _floats(v, sigma_x, std_t, c)
    v, sigma_x, std_t, c = arguments
    c_squared = c**2
    std_t_squared = std_t**2
    sigma_x_squared = sigma_x**2
    v_squared = v**2
    result = _empty(arguments, ())
    result[...] = c_squared * sigma_x_squared * std_t_squared / (0.5 * c_squared * std_t_squared + 0.5 * sigma_x_squared + 0.5 * np.sqrt((c_squared * std_t_squared - sigma_x_squared - std_t_squared * v_squared)**2 + 4.0 * c_squared * std_t_squared**2 * v_squared) + 0.5 * std_t_squared * v_squared)
    return result[()]


def position_std(*, sigma_x: npt.ArrayLike, sigma_y: npt.ArrayLike) -> Floats:
    """Root mean square of the deviations of x and y.

    Name: line.position_std.
    Definition: sqrt((sigma_x^2 + sigma_y^2)/2).
    Conditioning: no expectation is taken.
    Source: Gao et al. 2020 (10), doi:10.12126/see.2020.02.013.

    Args:
        sigma_x: standard deviation of the error of x [m], 0.01 to 1e+05.
        sigma_y: standard deviation of the error of y [m], 0.01 to 1e+05.

    Returns:
        Shape of the broadcast arguments, unit m.

    Accuracy: at most 2.51 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 2.51.
    """
    arguments = _floats(sigma_x, sigma_y)
    sigma_x, sigma_y = arguments
    result = _empty(arguments, ())
    result[...] = np.sqrt(0.5 * sigma_x**2 + 0.5 * sigma_y**2)
    return result[()]


def position_std_in_space(
    *,
    sigma_x: npt.ArrayLike,
    sigma_y: npt.ArrayLike,
    sigma_z: npt.ArrayLike,
) -> Floats:
    """Root mean square of the deviations of x, y and z.

    Name: line.position_std_in_space.
    Definition: sqrt((sigma_x^2 + sigma_y^2 + sigma_z^2)/3).
    Conditioning: no expectation is taken.
    Source: Gao et al. 2020 (2), doi:10.12126/see.2020.02.013.

    Args:
        sigma_x: standard deviation of the error of x [m], 0.01 to 1e+05.
        sigma_y: standard deviation of the error of y [m], 0.01 to 1e+05.
        sigma_z: standard deviation of the error of z [m], 0.01 to 1e+05.

    Returns:
        Shape of the broadcast arguments, unit m.

    Accuracy: at most 3.51 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 3.51.
    """
    arguments = _floats(sigma_x, sigma_y, sigma_z)
    sigma_x, sigma_y, sigma_z = arguments
    result = _empty(arguments, ())
    result[...] = np.sqrt(sigma_x**2 / 3.0 + sigma_y**2 / 3.0 + sigma_z**2 / 3.0)
    return result[()]
