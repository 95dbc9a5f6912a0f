"""NumPy functions of the quantities ruv.*.

Written by radartrack regenerate, generator 1, derivation d7a4e53301a79877; not to be edited.
"""

import numpy as np
import numpy.typing as npt

__all__ = [
    "bias_averaged_fourth_order",
    "bias_averaged_second_order",
    "bias_second_order",
    "bias_truth_fourth_order",
    "bias_truth_second_order",
    "covariance_averaged_fourth_order",
    "covariance_averaged_second_order",
    "covariance_averaged_semidefinite",
    "covariance_linear",
    "covariance_second_order",
    "covariance_truth_fourth_order",
    "covariance_truth_second_order",
    "decorrelated_covariance_fourth_order",
    "decorrelated_covariance_second_order",
    "decorrelated_covariance_semidefinite",
    "hessian",
    "jacobian",
    "map",
    "posterior_covariance_fourth_order",
    "posterior_covariance_second_order",
    "posterior_covariance_semidefinite",
    "posterior_estimate_fourth_order",
    "posterior_estimate_second_order",
    "std_linear",
    "std_position",
    "unbiased_covariance_fourth_order",
    "unbiased_covariance_second_order",
    "unbiased_covariance_semidefinite",
    "unbiased_estimate_fourth_order",
    "unbiased_estimate_second_order",
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


def map(*, r: npt.ArrayLike, u: npt.ArrayLike, v: npt.ArrayLike) -> Floats:
    """Map from the measured quantities to coordinates.

    Name: ruv.map.
    Definition: h.
    Conditioning: no expectation is taken.
    Source: Bar-Shalom, Willett & Tian 2011 direction cosines.

    Args:
        r: range [m], 1 to 1e+08.
        u: direction cosine along the x axis; u^2 + v^2 < 1 [1], -0.6 to 0.6.
        v: direction cosine along the y axis; u^2 + v^2 < 1 [1], -0.6 to 0.6.

    Returns:
        Shape of the broadcast arguments + (3), unit m.

    Accuracy: at most 6.93 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 6.93.
    """
    arguments = _floats(r, u, v)
    r, u, v = arguments
    root_1 = np.sqrt(1.0 - u**2 - v**2)
    result = _empty(arguments, (3,))
    result[..., 0] = r * u
    result[..., 1] = r * v
    result[..., 2] = r * root_1
    return result


def jacobian(*, r: npt.ArrayLike, u: npt.ArrayLike, v: npt.ArrayLike) -> Floats:
    """First derivatives of the map, [out, in].

    Name: ruv.jacobian.
    Definition: dh/dtheta.
    Conditioning: no expectation is taken.
    Source: Prosov (6)-(7).

    Args:
        r: range [m], 1 to 1e+08.
        u: direction cosine along the x axis; u^2 + v^2 < 1 [1], -0.6 to 0.6.
        v: direction cosine along the y axis; u^2 + v^2 < 1 [1], -0.6 to 0.6.

    Returns:
        Shape of the broadcast arguments + (3, 3), unit [m, m, m] × [1/m, 1, 1].

    Accuracy: at most 6.01 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 6.01.
    """
    arguments = _floats(r, u, v)
    r, u, v = arguments
    root_1 = np.sqrt(1.0 - u**2 - v**2)
    term_1 = 1.0 / root_1
    result = _empty(arguments, (3, 3))
    result[..., 0, 0] = u
    result[..., 0, 1] = r
    result[..., 0, 2] = 0.0
    result[..., 1, 0] = v
    result[..., 1, 1] = 0.0
    result[..., 1, 2] = r
    result[..., 2, 0] = root_1
    result[..., 2, 1] = -r * term_1 * u
    result[..., 2, 2] = -r * term_1 * v
    return result


def hessian(*, r: npt.ArrayLike, u: npt.ArrayLike, v: npt.ArrayLike) -> Floats:
    """Second derivatives of the map, [out, in, in].

    Name: ruv.hessian.
    Definition: d2h/dtheta2.
    Conditioning: no expectation is taken.
    Source: Prosov (6)-(7).

    Args:
        r: range [m], 1 to 1e+08.
        u: direction cosine along the x axis; u^2 + v^2 < 1 [1], -0.6 to 0.6.
        v: direction cosine along the y axis; u^2 + v^2 < 1 [1], -0.6 to 0.6.

    Returns:
        Shape of the broadcast arguments + (3, 3, 3), unit [m, m, m] × [1/m, 1, 1] × [1/m, 1, 1].

    Accuracy: at most 23.9 ulp anywhere in this domain, proved for elementary functions within 1 ulp
    (float64); in float32, with functions within 4 of its ulp, at most 185.
    """
    arguments = _floats(r, u, v)
    r, u, v = arguments
    u_squared = u**2
    v_squared = v**2
    root_1 = np.sqrt(1.0 - u_squared - v_squared)
    divisor_2 = u_squared - 1.0 + v_squared
    term_1 = 1.0 / root_1
    term_2 = 1.0 / divisor_2
    result = _empty(arguments, (3, 3, 3))
    result[..., 0, 0, 0] = 0.0
    result[..., 0, 0, 1] = 1.0
    result[..., 0, 0, 2] = 0.0
    result[..., 0, 1, 0] = 1.0
    result[..., 0, 1, 1] = 0.0
    result[..., 0, 1, 2] = 0.0
    result[..., 0, 2, 0] = 0.0
    result[..., 0, 2, 1] = 0.0
    result[..., 0, 2, 2] = 0.0
    result[..., 1, 0, 0] = 0.0
    result[..., 1, 0, 1] = 0.0
    result[..., 1, 0, 2] = 1.0
    result[..., 1, 1, 0] = 0.0
    result[..., 1, 1, 1] = 0.0
    result[..., 1, 1, 2] = 0.0
    result[..., 1, 2, 0] = 1.0
    result[..., 1, 2, 1] = 0.0
    result[..., 1, 2, 2] = 0.0
    result[..., 2, 0, 0] = 0.0
    result[..., 2, 0, 1] = -term_1 * u
    result[..., 2, 0, 2] = -term_1 * v
    result[..., 2, 1, 0] = result[..., 2, 0, 1]
    result[..., 2, 1, 1] = -r * term_1 * term_2 * (1.0 + v) * (v - 1.0)
    result[..., 2, 1, 2] = -r * u * v / (root_1 * root_1**2)
    result[..., 2, 2, 0] = result[..., 2, 0, 2]
    result[..., 2, 2, 1] = result[..., 2, 1, 2]
    result[..., 2, 2, 2] = -r * term_1 * term_2 * (1.0 + u) * (u - 1.0)
    return result


def bias_second_order(
    *,
    r: npt.ArrayLike,
    u: npt.ArrayLike,
    v: npt.ArrayLike,
    sigma_r: npt.ArrayLike,
    sigma_u: npt.ArrayLike,
    sigma_v: npt.ArrayLike,
    rho: npt.ArrayLike,
) -> Floats:
    """Bias of the plain conversion to second order.

    Name: ruv.bias.second_order.
    Definition: L h.
    Conditioning: truth-conditioned: the measured symbols stand for the true values.
    Source: Prosov (7).

    Args:
        r: range [m], 1 to 1e+08.
        u: direction cosine along the x axis; u^2 + v^2 < 1 [1], -0.6 to 0.6.
        v: direction cosine along the y axis; u^2 + v^2 < 1 [1], -0.6 to 0.6.
        sigma_r: standard deviation of the error of r [m], 0.001 to 10000.
        sigma_u: standard deviation of the error of u [1], 1e-09 to 0.1.
        sigma_v: standard deviation of the error of v [1], 1e-09 to 0.1.
        rho: correlation of the errors of u and v [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (3), unit m.

    Accuracy: at most 29.9 ulp anywhere in this domain with independent errors, proved for elementary
    functions within 1 ulp (float64); with correlations up to 0.99 in size at most 105; in float32, with
    functions within 4 of its ulp, at most 29.9.
    """
    arguments = _floats(r, u, v, sigma_r, sigma_u, sigma_v, rho)
    r, u, v, sigma_r, sigma_u, sigma_v, rho = arguments
    root_1 = np.sqrt(1.0 - u**2 - v**2)
    sum_1 = (
        0.5 * r * sigma_u**2 * (1.0 + v) * (v - 1.0)
        - r * rho * sigma_u * sigma_v * u * v
        + 0.5 * r * sigma_v**2 * (1.0 + u) * (u - 1.0)
    )
    result = _empty(arguments, (3,))
    result[..., 0] = 0.0
    result[..., 1] = 0.0
    result[..., 2] = sum_1 / (root_1 * root_1**2)
    return result


def covariance_linear(
    *,
    r: npt.ArrayLike,
    u: npt.ArrayLike,
    v: npt.ArrayLike,
    sigma_r: npt.ArrayLike,
    sigma_u: npt.ArrayLike,
    sigma_v: npt.ArrayLike,
    rho: npt.ArrayLike,
) -> Floats:
    """Covariance of the linearised conversion.

    Name: ruv.covariance.linear.
    Definition: J K J'.
    Conditioning: truth-conditioned: the measured symbols stand for the true values.
    Source: Prosov (9); Gao et al. 2020 (1), doi:10.12126/see.2020.02.013.

    Args:
        r: range [m], 1 to 1e+08.
        u: direction cosine along the x axis; u^2 + v^2 < 1 [1], -0.6 to 0.6.
        v: direction cosine along the y axis; u^2 + v^2 < 1 [1], -0.6 to 0.6.
        sigma_r: standard deviation of the error of r [m], 0.001 to 10000.
        sigma_u: standard deviation of the error of u [1], 1e-09 to 0.1.
        sigma_v: standard deviation of the error of v [1], 1e-09 to 0.1.
        rho: correlation of the errors of u and v [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (3, 3), unit m^2.

    Accuracy: at most 40.2 ulp anywhere in this domain with independent errors, proved for elementary
    functions within 1 ulp (float64); with correlations up to 0.99 in size at most 1720; in float32, with
    functions within 4 of its ulp, at most 262.
    """
    arguments = _floats(r, u, v, sigma_r, sigma_u, sigma_v, rho)
    r, u, v, sigma_r, sigma_u, sigma_v, rho = arguments
    u_squared = u**2
    v_squared = v**2
    root_1 = np.sqrt(1.0 - u_squared - v_squared)
    r_squared = r**2
    sigma_u_squared = sigma_u**2
    sigma_r_squared = sigma_r**2
    sum_1 = u_squared - 1.0 + v_squared
    term_1 = 1.0 / root_1
    sum_2 = (
        -r_squared * rho * sigma_u * sigma_v * v
        - r_squared * sigma_u_squared * u
        - sigma_r_squared * sum_1 * u
    )
    sigma_v_squared = sigma_v**2
    sum_3 = (
        -r_squared * rho * sigma_u * sigma_v * u
        - r_squared * sigma_v_squared * v
        - sigma_r_squared * sum_1 * v
    )
    sum_4 = (
        2.0 * r_squared * rho * sigma_u * sigma_v * u * v
        + r_squared * sigma_u_squared * u_squared
        + r_squared * sigma_v_squared * v_squared
        + sigma_r_squared * sum_1**2
    )
    result = _empty(arguments, (3, 3))
    result[..., 0, 0] = r_squared * sigma_u_squared + sigma_r_squared * u_squared
    result[..., 0, 1] = r_squared * rho * sigma_u * sigma_v + sigma_r_squared * u * v
    result[..., 0, 2] = sum_2 * term_1
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = r_squared * sigma_v_squared + sigma_r_squared * v_squared
    result[..., 1, 2] = sum_3 * term_1
    result[..., 2, 0] = result[..., 0, 2]
    result[..., 2, 1] = result[..., 1, 2]
    result[..., 2, 2] = sum_4 / root_1**2
    return result


def covariance_second_order(
    *,
    r: npt.ArrayLike,
    u: npt.ArrayLike,
    v: npt.ArrayLike,
    sigma_r: npt.ArrayLike,
    sigma_u: npt.ArrayLike,
    sigma_v: npt.ArrayLike,
    rho: npt.ArrayLike,
) -> Floats:
    """Covariance of the conversion's quadratic Taylor polynomial.

    Name: ruv.covariance.second_order.
    Definition: J K J' + tr(G_a K G_b K)/2.
    Conditioning: truth-conditioned: the measured symbols stand for the true values.
    Source: Bar-Shalom & Li 1995.

    Args:
        r: range [m], 1 to 1e+08.
        u: direction cosine along the x axis; u^2 + v^2 < 1 [1], -0.6 to 0.6.
        v: direction cosine along the y axis; u^2 + v^2 < 1 [1], -0.6 to 0.6.
        sigma_r: standard deviation of the error of r [m], 0.001 to 10000.
        sigma_u: standard deviation of the error of u [1], 1e-09 to 0.1.
        sigma_v: standard deviation of the error of v [1], 1e-09 to 0.1.
        rho: correlation of the errors of u and v [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (3, 3), unit m^2.

    Accuracy: at most 84.1 ulp anywhere in this domain with independent errors, proved for elementary
    functions within 1 ulp (float64).
    """
    arguments = _floats(r, u, v, sigma_r, sigma_u, sigma_v, rho)
    r, u, v, sigma_r, sigma_u, sigma_v, rho = arguments
    u_squared = u**2
    v_squared = v**2
    root_1 = np.sqrt(1.0 - u_squared - v_squared)
    r_squared = r**2
    sigma_u_squared = sigma_u**2
    sigma_r_squared = sigma_r**2
    sum_1 = u_squared - 1.0 + v_squared
    term_1 = 1.0 / root_1
    sum_2 = (
        -r_squared * rho * sigma_u * sigma_v * v
        - r_squared * sigma_u_squared * u
        - rho * sigma_r_squared * sigma_u * sigma_v * v
        - sigma_r_squared * sigma_u_squared * u
        - sigma_r_squared * sum_1 * u
    )
    sigma_v_squared = sigma_v**2
    sum_3 = (
        -r_squared * rho * sigma_u * sigma_v * u
        - r_squared * sigma_v_squared * v
        - rho * sigma_r_squared * sigma_u * sigma_v * u
        - sigma_r_squared * sigma_v_squared * v
        - sigma_r_squared * sum_1 * v
    )
    sum_4 = 1.0 + v
    sum_5 = v - 1.0
    sum_6 = 1.0 + u
    sum_7 = u - 1.0
    sum_1_squared = sum_1**2
    sum_8 = 1.0 - u_squared - v_squared + 2.0 * u_squared * v_squared
    sum_9 = (
        2.0 * r_squared * rho * sigma_u * sigma_v * sum_1_squared * u * v
        - 2.0 * r_squared * rho * sigma_u * sigma_u_squared * sigma_v * sum_4 * sum_5 * u * v
        - 2.0 * r_squared * rho * sigma_u * sigma_v * sigma_v_squared * sum_6 * sum_7 * u * v
        + 2.0 * rho * sigma_r_squared * sigma_u * sigma_v * sum_1_squared * u * v
        + 0.5 * r_squared * sigma_u_squared**2 * sum_4**2 * sum_5**2
        + r_squared * rho**2 * sigma_u_squared * sigma_v_squared * sum_8
        + r_squared * sigma_u_squared * sigma_v_squared * u_squared * v_squared
        + r_squared * sigma_u_squared * sum_1_squared * u_squared
        + 0.5 * r_squared * sigma_v_squared**2 * sum_6**2 * sum_7**2
        + r_squared * sigma_v_squared * sum_1_squared * v_squared
        + sigma_r_squared * sigma_u_squared * sum_1_squared * u_squared
        + sigma_r_squared * sigma_v_squared * sum_1_squared * v_squared
        + sigma_r_squared * sum_1_squared**2
    )
    result = _empty(arguments, (3, 3))
    result[..., 0, 0] = (
        r_squared * sigma_u_squared
        + sigma_r_squared * sigma_u_squared
        + sigma_r_squared * u_squared
    )
    result[..., 0, 1] = (
        r_squared * rho * sigma_u * sigma_v
        + rho * sigma_r_squared * sigma_u * sigma_v
        + sigma_r_squared * u * v
    )
    result[..., 0, 2] = sum_2 * term_1
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = (
        r_squared * sigma_v_squared
        + sigma_r_squared * sigma_v_squared
        + sigma_r_squared * v_squared
    )
    result[..., 1, 2] = sum_3 * term_1
    result[..., 2, 0] = result[..., 0, 2]
    result[..., 2, 1] = result[..., 1, 2]
    result[..., 2, 2] = sum_9 / (root_1 * root_1**2)**2
    return result


def std_linear(
    *,
    r: npt.ArrayLike,
    u: npt.ArrayLike,
    v: npt.ArrayLike,
    sigma_r: npt.ArrayLike,
    sigma_u: npt.ArrayLike,
    sigma_v: npt.ArrayLike,
    rho: npt.ArrayLike,
) -> Floats:
    """Standard deviation of each coordinate of the linearised conversion.

    Name: ruv.std.linear.
    Definition: sqrt((J K J')_aa).
    Conditioning: truth-conditioned: the measured symbols stand for the true values.
    Source: Gao et al. 2020 (1), doi:10.12126/see.2020.02.013.

    Args:
        r: range [m], 1 to 1e+08.
        u: direction cosine along the x axis; u^2 + v^2 < 1 [1], -0.6 to 0.6.
        v: direction cosine along the y axis; u^2 + v^2 < 1 [1], -0.6 to 0.6.
        sigma_r: standard deviation of the error of r [m], 0.001 to 10000.
        sigma_u: standard deviation of the error of u [1], 1e-09 to 0.1.
        sigma_v: standard deviation of the error of v [1], 1e-09 to 0.1.
        rho: correlation of the errors of u and v [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (3), unit m.

    Accuracy: at most 20.6 ulp anywhere in this domain with independent errors, proved for elementary
    functions within 1 ulp (float64); with correlations up to 0.99 in size at most 856; in float32, with
    functions within 4 of its ulp, at most 132.
    """
    arguments = _floats(r, u, v, sigma_r, sigma_u, sigma_v, rho)
    r, u, v, sigma_r, sigma_u, sigma_v, rho = arguments
    u_squared = u**2
    v_squared = v**2
    divisor_1 = 1.0 - u_squared - v_squared
    r_squared = r**2
    sigma_u_squared = sigma_u**2
    sigma_r_squared = sigma_r**2
    sigma_v_squared = sigma_v**2
    result = _empty(arguments, (3,))
    result[..., 0] = np.sqrt(r_squared * sigma_u_squared + sigma_r_squared * u_squared)
    result[..., 1] = np.sqrt(r_squared * sigma_v_squared + sigma_r_squared * v_squared)
    result[..., 2] = np.sqrt(2.0 * r_squared * rho * sigma_u * sigma_v * u * v + r_squared * sigma_u_squared * u_squared + r_squared * sigma_v_squared * v_squared + (u_squared - 1.0 + v_squared)**2 * sigma_r_squared) / np.sqrt(divisor_1)
    return result


def std_position(
    *,
    r: npt.ArrayLike,
    u: npt.ArrayLike,
    v: npt.ArrayLike,
    sigma_r: npt.ArrayLike,
    sigma_u: npt.ArrayLike,
    sigma_v: npt.ArrayLike,
    rho: npt.ArrayLike,
) -> Floats:
    """Root mean square of the coordinates' standard deviations, linearised.

    Name: ruv.std.position.
    Definition: sqrt(tr(J K J')/n).
    Conditioning: truth-conditioned: the measured symbols stand for the true values.
    Source: Gao et al. 2020 (2), doi:10.12126/see.2020.02.013.

    Args:
        r: range [m], 1 to 1e+08.
        u: direction cosine along the x axis; u^2 + v^2 < 1 [1], -0.6 to 0.6.
        v: direction cosine along the y axis; u^2 + v^2 < 1 [1], -0.6 to 0.6.
        sigma_r: standard deviation of the error of r [m], 0.001 to 10000.
        sigma_u: standard deviation of the error of u [1], 1e-09 to 0.1.
        sigma_v: standard deviation of the error of v [1], 1e-09 to 0.1.
        rho: correlation of the errors of u and v [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments, unit m.

    Accuracy: at most 20.1 ulp anywhere in this domain with independent errors, proved for elementary
    functions within 1 ulp (float64); with correlations up to 0.99 in size at most 20.3.
    """
    arguments = _floats(r, u, v, sigma_r, sigma_u, sigma_v, rho)
    r, u, v, sigma_r, sigma_u, sigma_v, rho = arguments
    u_squared = u**2
    v_squared = v**2
    divisor_1 = 1.0 - u_squared - v_squared
    r_squared = r**2
    sigma_u_squared = sigma_u**2
    sigma_v_squared = sigma_v**2
    sigma_r_squared = sigma_r**2
    sum_1 = (
        2.0 * r_squared * rho * sigma_u * sigma_v * u * v
        + r_squared * sigma_u_squared * u_squared
        + r_squared * sigma_v_squared * v_squared
        + (u_squared - 1.0 + v_squared)**2 * sigma_r_squared
    )
    result = _empty(arguments, ())
    result[...] = np.sqrt(r_squared * sigma_u_squared / 3.0 + r_squared * sigma_v_squared / 3.0 + sigma_r_squared * u_squared / 3.0 + sigma_r_squared * v_squared / 3.0 + sum_1 / (divisor_1 * 3.0))
    return result[()]


def validity_linear(
    *,
    r: npt.ArrayLike,
    u: npt.ArrayLike,
    v: npt.ArrayLike,
    sigma_r: npt.ArrayLike,
    sigma_u: npt.ArrayLike,
    sigma_v: npt.ArrayLike,
    rho: npt.ArrayLike,
) -> Floats:
    """Leading term that the linear formulas neglect, root mean square, over the linear standard deviation, one a measured quantity.

    Name: ruv.validity.linear.
    Definition: sqrt(E[(J^-1 (w.d)^2 h)_i^2])/(2 sigma_i).
    Conditioning: truth-conditioned: the measured symbols stand for the true values.
    Source: Prosov the question of validity.

    Args:
        r: range [m], 1 to 1e+08.
        u: direction cosine along the x axis; u^2 + v^2 < 1 [1], -0.6 to 0.6.
        v: direction cosine along the y axis; u^2 + v^2 < 1 [1], -0.6 to 0.6.
        sigma_r: standard deviation of the error of r [m], 0.001 to 10000.
        sigma_u: standard deviation of the error of u [1], 1e-09 to 0.1.
        sigma_v: standard deviation of the error of v [1], 1e-09 to 0.1.
        rho: correlation of the errors of u and v [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (3), unit 1.

    Accuracy: at most 60.2 ulp anywhere in this domain with independent errors, proved for elementary
    functions within 1 ulp (float64).
    """
    arguments = _floats(r, u, v, sigma_r, sigma_u, sigma_v, rho)
    r, u, v, sigma_r, sigma_u, sigma_v, rho = arguments
    u_squared = u**2
    v_squared = v**2
    divisor_1 = 1.0 - u_squared - v_squared
    complement_of_rho = np.sqrt((1.0 - rho) * (1.0 + rho))
    term_1 = 1.0 / divisor_1
    product_1 = -r * rho * sigma_u * sigma_v * term_1 * u * v
    complement_of_rho_squared = complement_of_rho**2
    sigma_v_squared = sigma_v**2
    sum_1 = 1.0 + u
    sum_2 = u - 1.0
    rho_squared = rho**2
    product_2 = 0.5 * r * rho_squared * sigma_v_squared * sum_1 * sum_2 * term_1
    sigma_u_squared = sigma_u**2
    sum_3 = 1.0 + v
    sum_4 = v - 1.0
    product_3 = 0.5 * r * sigma_u_squared * sum_3 * sum_4 * term_1
    sum_1_squared = sum_1**2
    sum_2_squared = sum_2**2
    complement_of_rho_squared_squared = complement_of_rho_squared**2
    term_2 = 1.0 / divisor_1**2
    r_squared = r**2
    sigma_v_squared_squared = sigma_v_squared**2
    term_3 = 1.0 / r
    product_4 = -0.5 * r * rho_squared * sigma_v_squared * sum_1 * sum_2 * term_1 * u
    product_5 = -0.5 * r * sigma_u_squared * sum_3 * sum_4 * term_1 * u
    product_6 = r * rho * sigma_u * sigma_v * term_1 * u_squared * v
    sigma_r_squared = sigma_r**2
    product_7 = -0.5 * r * rho_squared * sigma_u_squared * sum_3 * sum_4 * term_1 * v
    product_8 = -0.5 * r * sigma_v_squared * sum_1 * sum_2 * term_1 * v
    product_9 = r * rho * sigma_u * sigma_v * term_1 * u * v_squared
    result = _empty(arguments, (3,))
    result[..., 0] = np.sqrt((0.5 * complement_of_rho_squared * r * sigma_v_squared * sum_1 * sum_2 * term_1 + product_1 + product_2 + product_3)**2 + 2.0 * (product_1 + product_2 + product_3)**2 + (r * rho * sigma_v * sum_1 * sum_2 * term_1 - r * sigma_u * term_1 * u * v)**2 * complement_of_rho_squared * sigma_v_squared + 0.5 * complement_of_rho_squared_squared * r_squared * sigma_v_squared_squared * sum_1_squared * sum_2_squared * term_2) / sigma_r
    result[..., 1] = np.sqrt((product_4 - 0.5 * complement_of_rho_squared * r * sigma_v_squared * sum_1 * sum_2 * term_1 * u + product_5 + product_6)**2 + 2.0 * (product_4 + product_5 + product_6)**2 + (r * sigma_u * term_1 * u_squared * v - r * rho * sigma_v * sum_1 * sum_2 * term_1 * u)**2 * complement_of_rho_squared * sigma_v_squared + 0.5 * complement_of_rho_squared_squared * r_squared * sigma_v_squared_squared * sum_1_squared * sum_2_squared * term_2 * u_squared + sigma_r_squared * sigma_u_squared) * term_3 / sigma_u
    result[..., 2] = np.sqrt((product_7 - 0.5 * complement_of_rho_squared * r * sigma_u_squared * sum_3 * sum_4 * term_1 * v + product_8 + product_9)**2 + 2.0 * (product_7 + product_8 + product_9)**2 + (r * sigma_v * term_1 * u * v_squared - r * rho * sigma_u * sum_3 * sum_4 * term_1 * v)**2 * complement_of_rho_squared * sigma_u_squared + 0.5 * complement_of_rho_squared_squared * r_squared * sigma_u_squared**2 * sum_3**2 * sum_4**2 * term_2 * v_squared + sigma_r_squared * sigma_v_squared) * term_3 / sigma_v
    return result


def validity_second_order(
    *,
    r: npt.ArrayLike,
    u: npt.ArrayLike,
    v: npt.ArrayLike,
    sigma_r: npt.ArrayLike,
    sigma_u: npt.ArrayLike,
    sigma_v: npt.ArrayLike,
    rho: npt.ArrayLike,
) -> Floats:
    """Leading term that the second-order formulas neglect, root mean square, over the linear standard deviation, one a measured quantity.

    Name: ruv.validity.second_order.
    Definition: sqrt(E[(J^-1 (w.d)^3 h)_i^2])/(6 sigma_i).
    Conditioning: truth-conditioned: the measured symbols stand for the true values.
    Source: Prosov the question of validity.

    Args:
        r: range [m], 1 to 1e+08.
        u: direction cosine along the x axis; u^2 + v^2 < 1 [1], -0.6 to 0.6.
        v: direction cosine along the y axis; u^2 + v^2 < 1 [1], -0.6 to 0.6.
        sigma_r: standard deviation of the error of r [m], 0.001 to 10000.
        sigma_u: standard deviation of the error of u [1], 1e-09 to 0.1.
        sigma_v: standard deviation of the error of v [1], 1e-09 to 0.1.
        rho: correlation of the errors of u and v [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (3), unit 1.

    Accuracy: at most 160 ulp anywhere in this domain with independent errors, proved for elementary functions
    within 1 ulp (float64).
    """
    arguments = _floats(r, u, v, sigma_r, sigma_u, sigma_v, rho)
    r, u, v, sigma_r, sigma_u, sigma_v, rho = arguments
    u_squared = u**2
    v_squared = v**2
    divisor_1 = 1.0 - u_squared - v_squared
    complement_of_rho = np.sqrt((1.0 - rho) * (1.0 + rho))
    sum_1 = 1.0 - v_squared + 2.0 * u_squared
    term_1 = 1.0 / divisor_1**2
    sigma_u_squared = sigma_u**2
    complement_of_rho_squared = complement_of_rho**2
    sigma_v_squared = sigma_v**2
    product_1 = sigma_v * sigma_v_squared
    sum_2 = 1.0 + u
    sum_3 = u - 1.0
    rho_squared = rho**2
    sum_4 = u_squared - 1.0 - 2.0 * v_squared
    product_2 = rho * rho_squared
    product_3 = sigma_u * sigma_u_squared
    sum_5 = 1.0 + v
    sum_6 = v - 1.0
    product_4 = -0.5 * r * sigma_u_squared * sum_1 * term_1 * v
    product_5 = 1.5 * r * rho_squared * sigma_v_squared * sum_2 * sum_3 * term_1 * v
    product_6 = r * rho * sigma_u * sigma_v * sum_4 * term_1 * u
    complement_of_rho_squared_squared = complement_of_rho_squared**2
    sigma_v_squared_squared = sigma_v_squared**2
    term_2 = 1.0 / divisor_1
    product_7 = -rho * sigma_u * sigma_v * term_2 * u * v
    product_8 = 0.5 * rho_squared * sigma_v_squared * sum_2 * sum_3 * term_2
    product_9 = 0.5 * sigma_u_squared * sum_5 * sum_6 * term_2
    sigma_r_squared = sigma_r**2
    sum_2_squared = sum_2**2
    sum_3_squared = sum_3**2
    complement_of_rho_squared_cubed = complement_of_rho_squared * complement_of_rho_squared**2
    term_3 = 1.0 / (divisor_1**2)**2
    r_squared = r**2
    sigma_v_squared_cubed = sigma_v_squared * sigma_v_squared**2
    term_4 = 1.0 / r
    product_10 = -1.5 * r * rho_squared * sigma_v_squared * sum_2 * sum_3 * term_1 * u * v
    product_11 = -r * rho * sigma_u * sigma_v * sum_4 * term_1 * u_squared
    product_12 = 0.5 * r * sigma_u_squared * sum_1 * term_1 * u * v
    product_13 = -0.5 * rho_squared * sigma_v_squared * sum_2 * sum_3 * term_2 * u
    product_14 = -0.5 * sigma_u_squared * sum_5 * sum_6 * term_2 * u
    product_15 = rho * sigma_u * sigma_v * term_2 * u_squared * v
    product_16 = -1.5 * r * rho_squared * sigma_v_squared * sum_2 * sum_3 * term_1 * v_squared
    product_17 = -r * rho * sigma_u * sigma_v * sum_4 * term_1 * u * v
    product_18 = 0.5 * r * sigma_u_squared * sum_1 * term_1 * v_squared
    product_19 = -0.5 * rho_squared * sigma_v_squared * sum_2 * sum_3 * term_2 * v
    product_20 = -0.5 * sigma_u_squared * sum_5 * sum_6 * term_2 * v
    product_21 = rho * sigma_u * sigma_v * term_2 * u * v_squared
    result = _empty(arguments, (3,))
    result[..., 0] = np.sqrt((1.5 * complement_of_rho_squared * product_1 * r * rho * sum_2 * sum_3 * term_1 * v - 1.5 * r * rho * sigma_u_squared * sigma_v * sum_1 * term_1 * v + 1.5 * product_1 * product_2 * r * sum_2 * sum_3 * term_1 * v + 1.5 * product_3 * r * sum_5 * sum_6 * term_1 * u + 1.5 * r * rho_squared * sigma_u * sigma_v_squared * sum_4 * term_1 * u + 0.5 * complement_of_rho_squared * r * sigma_u * sigma_v_squared * sum_4 * term_1 * u)**2 + 2.0 * (product_4 + product_5 + product_6)**2 * complement_of_rho_squared * sigma_v_squared + 2.0 * (1.5 * r * rho * sigma_v * sum_2 * sum_3 * term_1 * v + 0.5 * r * sigma_u * sum_4 * term_1 * u)**2 * complement_of_rho_squared_squared * sigma_v_squared_squared + 2.0 * (product_7 + product_8 + product_9)**2 * sigma_r_squared + 1.5 * complement_of_rho_squared_cubed * r_squared * sigma_v_squared_cubed * sum_2_squared * sum_3_squared * term_3 * v_squared + 6.0 * (0.5 * product_1 * product_2 * r * sum_2 * sum_3 * term_1 * v - 0.5 * r * rho * sigma_u_squared * sigma_v * sum_1 * term_1 * v + 0.5 * product_3 * r * sum_5 * sum_6 * term_1 * u + 0.5 * r * rho_squared * sigma_u * sigma_v_squared * sum_4 * term_1 * u)**2 + (rho * sigma_v * sum_2 * sum_3 * term_2 - sigma_u * term_2 * u * v)**2 * complement_of_rho_squared * sigma_r_squared * sigma_v_squared + (1.5 * complement_of_rho_squared * r * sigma_v_squared * sum_2 * sum_3 * term_1 * v + product_4 + product_5 + product_6)**2 * complement_of_rho_squared * sigma_v_squared + 0.5 * complement_of_rho_squared_squared * sigma_r_squared * sigma_v_squared_squared * sum_2_squared * sum_3_squared * term_1 + (0.5 * complement_of_rho_squared * sigma_v_squared * sum_2 * sum_3 * term_2 + product_7 + product_8 + product_9)**2 * sigma_r_squared) / sigma_r
    result[..., 1] = np.sqrt((1.5 * r * rho * sigma_u_squared * sigma_v * sum_1 * term_1 * u * v - 1.5 * complement_of_rho_squared * product_1 * r * rho * sum_2 * sum_3 * term_1 * u * v - 1.5 * product_1 * product_2 * r * sum_2 * sum_3 * term_1 * u * v - 1.5 * product_3 * r * sum_5 * sum_6 * term_1 * u_squared - 1.5 * r * rho_squared * sigma_u * sigma_v_squared * sum_4 * term_1 * u_squared - 0.5 * complement_of_rho_squared * r * sigma_u * sigma_v_squared * sum_4 * term_1 * u_squared)**2 + 2.0 * (product_10 + product_11 + product_12)**2 * complement_of_rho_squared * sigma_v_squared + 2.0 * (-1.5 * r * rho * sigma_v * sum_2 * sum_3 * term_1 * u * v - 0.5 * r * sigma_u * sum_4 * term_1 * u_squared)**2 * complement_of_rho_squared_squared * sigma_v_squared_squared + 2.0 * (product_13 + product_14 + product_15)**2 * sigma_r_squared + 1.5 * complement_of_rho_squared_cubed * r_squared * sigma_v_squared_cubed * sum_2_squared * sum_3_squared * term_3 * u_squared * v_squared + 6.0 * (0.5 * r * rho * sigma_u_squared * sigma_v * sum_1 * term_1 * u * v - 0.5 * product_1 * product_2 * r * sum_2 * sum_3 * term_1 * u * v - 0.5 * product_3 * r * sum_5 * sum_6 * term_1 * u_squared - 0.5 * r * rho_squared * sigma_u * sigma_v_squared * sum_4 * term_1 * u_squared)**2 + (sigma_u * term_2 * u_squared * v - rho * sigma_v * sum_2 * sum_3 * term_2 * u)**2 * complement_of_rho_squared * sigma_r_squared * sigma_v_squared + (product_10 - 1.5 * complement_of_rho_squared * r * sigma_v_squared * sum_2 * sum_3 * term_1 * u * v + product_11 + product_12)**2 * complement_of_rho_squared * sigma_v_squared + 0.5 * complement_of_rho_squared_squared * sigma_r_squared * sigma_v_squared_squared * sum_2_squared * sum_3_squared * term_1 * u_squared + (product_13 - 0.5 * complement_of_rho_squared * sigma_v_squared * sum_2 * sum_3 * term_2 * u + product_14 + product_15)**2 * sigma_r_squared) * term_4 / sigma_u
    result[..., 2] = np.sqrt((1.5 * r * rho * sigma_u_squared * sigma_v * sum_1 * term_1 * v_squared - 1.5 * complement_of_rho_squared * product_1 * r * rho * sum_2 * sum_3 * term_1 * v_squared - 1.5 * product_1 * product_2 * r * sum_2 * sum_3 * term_1 * v_squared - 1.5 * product_3 * r * sum_5 * sum_6 * term_1 * u * v - 1.5 * r * rho_squared * sigma_u * sigma_v_squared * sum_4 * term_1 * u * v - 0.5 * complement_of_rho_squared * r * sigma_u * sigma_v_squared * sum_4 * term_1 * u * v)**2 + 2.0 * (product_16 + product_17 + product_18)**2 * complement_of_rho_squared * sigma_v_squared + 2.0 * (-1.5 * r * rho * sigma_v * sum_2 * sum_3 * term_1 * v_squared - 0.5 * r * sigma_u * sum_4 * term_1 * u * v)**2 * complement_of_rho_squared_squared * sigma_v_squared_squared + 2.0 * (product_19 + product_20 + product_21)**2 * sigma_r_squared + 1.5 * complement_of_rho_squared_cubed * r_squared * sigma_v_squared_cubed * sum_2_squared * sum_3_squared * term_3 * v_squared**2 + 6.0 * (0.5 * r * rho * sigma_u_squared * sigma_v * sum_1 * term_1 * v_squared - 0.5 * product_1 * product_2 * r * sum_2 * sum_3 * term_1 * v_squared - 0.5 * product_3 * r * sum_5 * sum_6 * term_1 * u * v - 0.5 * r * rho_squared * sigma_u * sigma_v_squared * sum_4 * term_1 * u * v)**2 + (sigma_u * term_2 * u * v_squared - rho * sigma_v * sum_2 * sum_3 * term_2 * v)**2 * complement_of_rho_squared * sigma_r_squared * sigma_v_squared + (product_16 - 1.5 * complement_of_rho_squared * r * sigma_v_squared * sum_2 * sum_3 * term_1 * v_squared + product_17 + product_18)**2 * complement_of_rho_squared * sigma_v_squared + 0.5 * complement_of_rho_squared_squared * sigma_r_squared * sigma_v_squared_squared * sum_2_squared * sum_3_squared * term_1 * v_squared + (product_19 - 0.5 * complement_of_rho_squared * sigma_v_squared * sum_2 * sum_3 * term_2 * v + product_20 + product_21)**2 * sigma_r_squared) * term_4 / sigma_v
    return result


def bias_truth_second_order(
    *,
    r: npt.ArrayLike,
    u: npt.ArrayLike,
    v: npt.ArrayLike,
    sigma_r: npt.ArrayLike,
    sigma_u: npt.ArrayLike,
    sigma_v: npt.ArrayLike,
    rho: npt.ArrayLike,
) -> Floats:
    """Bias of the plain conversion h(z), to second order.

    Name: ruv.bias.truth.second_order.
    Definition: (e^L - 1) h to sigma^2.
    Conditioning: truth-conditioned: the measured symbols stand for the true values.
    Source: Lerro & Bar-Shalom 1993, doi:10.1109/7.220948.

    Args:
        r: range [m], 1 to 1e+08.
        u: direction cosine along the x axis; u^2 + v^2 < 1 [1], -0.6 to 0.6.
        v: direction cosine along the y axis; u^2 + v^2 < 1 [1], -0.6 to 0.6.
        sigma_r: standard deviation of the error of r [m], 0.001 to 10000.
        sigma_u: standard deviation of the error of u [1], 1e-09 to 0.1.
        sigma_v: standard deviation of the error of v [1], 1e-09 to 0.1.
        rho: correlation of the errors of u and v [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (3), unit m.

    Accuracy: at most 29.9 ulp anywhere in this domain with independent errors, proved for elementary
    functions within 1 ulp (float64); with correlations up to 0.99 in size at most 105; in float32, with
    functions within 4 of its ulp, at most 29.9.
    """
    arguments = _floats(r, u, v, sigma_r, sigma_u, sigma_v, rho)
    r, u, v, sigma_r, sigma_u, sigma_v, rho = arguments
    root_1 = np.sqrt(1.0 - u**2 - v**2)
    sum_1 = (
        0.5 * r * sigma_u**2 * (1.0 + v) * (v - 1.0)
        - r * rho * sigma_u * sigma_v * u * v
        + 0.5 * r * sigma_v**2 * (1.0 + u) * (u - 1.0)
    )
    result = _empty(arguments, (3,))
    result[..., 0] = 0.0
    result[..., 1] = 0.0
    result[..., 2] = sum_1 / (root_1 * root_1**2)
    return result


def bias_truth_fourth_order(
    *,
    r: npt.ArrayLike,
    u: npt.ArrayLike,
    v: npt.ArrayLike,
    sigma_r: npt.ArrayLike,
    sigma_u: npt.ArrayLike,
    sigma_v: npt.ArrayLike,
    rho: npt.ArrayLike,
) -> Floats:
    """Bias of the plain conversion h(z), to fourth order.

    Name: ruv.bias.truth.fourth_order.
    Definition: (e^L - 1) h to sigma^4.
    Conditioning: truth-conditioned: the measured symbols stand for the true values.
    Source: Lerro & Bar-Shalom 1993, doi:10.1109/7.220948.

    Args:
        r: range [m], 1 to 1e+08.
        u: direction cosine along the x axis; u^2 + v^2 < 1 [1], -0.6 to 0.6.
        v: direction cosine along the y axis; u^2 + v^2 < 1 [1], -0.6 to 0.6.
        sigma_r: standard deviation of the error of r [m], 0.001 to 10000.
        sigma_u: standard deviation of the error of u [1], 1e-09 to 0.1.
        sigma_v: standard deviation of the error of v [1], 1e-09 to 0.1.
        rho: correlation of the errors of u and v [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (3), unit m.

    Accuracy: at most 82.5 ulp anywhere in this domain with independent errors, proved for elementary
    functions within 1 ulp (float64); in float32, with functions within 4 of its ulp, at most 271.
    """
    arguments = _floats(r, u, v, sigma_r, sigma_u, sigma_v, rho)
    r, u, v, sigma_r, sigma_u, sigma_v, rho = arguments
    u_squared = u**2
    v_squared = v**2
    root_1 = np.sqrt(1.0 - u_squared - v_squared)
    sigma_u_squared = sigma_u**2
    sum_1 = 3.0 - 3.0 * v_squared + 2.0 * u_squared
    sigma_v_squared = sigma_v**2
    sum_2 = 1.0 + u
    sum_3 = u - 1.0
    sum_4 = u_squared - 1.0 - 4.0 * v_squared
    term_1 = (u_squared - 1.0 + v_squared)**2
    sum_5 = 3.0 * u_squared - 3.0 - 2.0 * v_squared
    sum_6 = 1.0 + v
    sum_7 = v - 1.0
    sum_8 = 1.0 - v_squared + 4.0 * u_squared
    sum_9 = (
        2.0 * u_squared**2
        - 1.0
        - 11.0 * u_squared * v_squared
        - u_squared
        - v_squared
        + 2.0 * v_squared**2
    )
    sum_10 = (
        0.375 * r * sigma_u_squared**2 * sum_6 * sum_7 * sum_8
        - 1.5 * r * rho * sigma_u * sigma_u_squared * sigma_v * sum_1 * u * v
        - 0.375 * r * sigma_v_squared**2 * sum_2 * sum_3 * sum_4
        - r * rho * sigma_u * sigma_v * term_1 * u * v
        + 1.5 * r * rho * sigma_u * sigma_v * sigma_v_squared * sum_5 * u * v
        + 0.5 * r * rho**2 * sigma_u_squared * sigma_v_squared * sum_9
        + 0.25 * r * sigma_u_squared * sigma_v_squared * sum_9
        + 0.5 * r * sigma_u_squared * sum_6 * sum_7 * term_1
        + 0.5 * r * sigma_v_squared * sum_2 * sum_3 * term_1
    )
    result = _empty(arguments, (3,))
    result[..., 0] = 0.0
    result[..., 1] = 0.0
    result[..., 2] = sum_10 / (root_1 * (root_1 * root_1**2)**2)
    return result


def bias_averaged_second_order(
    *,
    r: npt.ArrayLike,
    u: npt.ArrayLike,
    v: npt.ArrayLike,
    sigma_r: npt.ArrayLike,
    sigma_u: npt.ArrayLike,
    sigma_v: npt.ArrayLike,
    rho: npt.ArrayLike,
) -> Floats:
    """Bias of the plain conversion, averaged over the truth, to second order.

    Name: ruv.bias.averaged.second_order.
    Definition: (e^2L - e^L) h to sigma^2.
    Conditioning: measurement-conditioned: the measured symbols stand for the measurement.
    Source: Lerro & Bar-Shalom 1993, doi:10.1109/7.220948.

    Args:
        r: range [m], 1 to 1e+08.
        u: direction cosine along the x axis; u^2 + v^2 < 1 [1], -0.6 to 0.6.
        v: direction cosine along the y axis; u^2 + v^2 < 1 [1], -0.6 to 0.6.
        sigma_r: standard deviation of the error of r [m], 0.001 to 10000.
        sigma_u: standard deviation of the error of u [1], 1e-09 to 0.1.
        sigma_v: standard deviation of the error of v [1], 1e-09 to 0.1.
        rho: correlation of the errors of u and v [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (3), unit m.

    Accuracy: at most 29.9 ulp anywhere in this domain with independent errors, proved for elementary
    functions within 1 ulp (float64); with correlations up to 0.99 in size at most 105; in float32, with
    functions within 4 of its ulp, at most 29.9.
    """
    arguments = _floats(r, u, v, sigma_r, sigma_u, sigma_v, rho)
    r, u, v, sigma_r, sigma_u, sigma_v, rho = arguments
    root_1 = np.sqrt(1.0 - u**2 - v**2)
    sum_1 = (
        0.5 * r * sigma_u**2 * (1.0 + v) * (v - 1.0)
        - r * rho * sigma_u * sigma_v * u * v
        + 0.5 * r * sigma_v**2 * (1.0 + u) * (u - 1.0)
    )
    result = _empty(arguments, (3,))
    result[..., 0] = 0.0
    result[..., 1] = 0.0
    result[..., 2] = sum_1 / (root_1 * root_1**2)
    return result


def bias_averaged_fourth_order(
    *,
    r: npt.ArrayLike,
    u: npt.ArrayLike,
    v: npt.ArrayLike,
    sigma_r: npt.ArrayLike,
    sigma_u: npt.ArrayLike,
    sigma_v: npt.ArrayLike,
    rho: npt.ArrayLike,
) -> Floats:
    """Bias of the plain conversion, averaged over the truth, to fourth order.

    Name: ruv.bias.averaged.fourth_order.
    Definition: (e^2L - e^L) h to sigma^4.
    Conditioning: measurement-conditioned: the measured symbols stand for the measurement.
    Source: Lerro & Bar-Shalom 1993, doi:10.1109/7.220948.

    Args:
        r: range [m], 1 to 1e+08.
        u: direction cosine along the x axis; u^2 + v^2 < 1 [1], -0.6 to 0.6.
        v: direction cosine along the y axis; u^2 + v^2 < 1 [1], -0.6 to 0.6.
        sigma_r: standard deviation of the error of r [m], 0.001 to 10000.
        sigma_u: standard deviation of the error of u [1], 1e-09 to 0.1.
        sigma_v: standard deviation of the error of v [1], 1e-09 to 0.1.
        rho: correlation of the errors of u and v [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (3), unit m.

    Accuracy: at most 82.5 ulp anywhere in this domain with independent errors, proved for elementary
    functions within 1 ulp (float64); in float32, with functions within 4 of its ulp, at most 427.
    """
    arguments = _floats(r, u, v, sigma_r, sigma_u, sigma_v, rho)
    r, u, v, sigma_r, sigma_u, sigma_v, rho = arguments
    u_squared = u**2
    v_squared = v**2
    root_1 = np.sqrt(1.0 - u_squared - v_squared)
    sigma_u_squared = sigma_u**2
    sum_1 = 3.0 - 3.0 * v_squared + 2.0 * u_squared
    sigma_v_squared = sigma_v**2
    sum_2 = 1.0 + u
    sum_3 = u - 1.0
    sum_4 = u_squared - 1.0 - 4.0 * v_squared
    term_1 = (u_squared - 1.0 + v_squared)**2
    sum_5 = (
        2.0 * u_squared**2
        - 1.0
        - 11.0 * u_squared * v_squared
        - u_squared
        - v_squared
        + 2.0 * v_squared**2
    )
    sum_6 = 3.0 * u_squared - 3.0 - 2.0 * v_squared
    sum_7 = 1.0 + v
    sum_8 = v - 1.0
    sum_9 = 1.0 - v_squared + 4.0 * u_squared
    sum_10 = (
        1.5 * r * rho**2 * sigma_u_squared * sigma_v_squared * sum_5
        - 4.5 * r * rho * sigma_u * sigma_u_squared * sigma_v * sum_1 * u * v
        - 1.125 * r * sigma_v_squared**2 * sum_2 * sum_3 * sum_4
        - r * rho * sigma_u * sigma_v * term_1 * u * v
        + 0.75 * r * sigma_u_squared * sigma_v_squared * sum_5
        + 1.125 * r * sigma_u_squared**2 * sum_7 * sum_8 * sum_9
        + 4.5 * r * rho * sigma_u * sigma_v * sigma_v_squared * sum_6 * u * v
        + 0.5 * r * sigma_u_squared * sum_7 * sum_8 * term_1
        + 0.5 * r * sigma_v_squared * sum_2 * sum_3 * term_1
    )
    result = _empty(arguments, (3,))
    result[..., 0] = 0.0
    result[..., 1] = 0.0
    result[..., 2] = sum_10 / (root_1 * (root_1 * root_1**2)**2)
    return result


def covariance_truth_second_order(
    *,
    r: npt.ArrayLike,
    u: npt.ArrayLike,
    v: npt.ArrayLike,
    sigma_r: npt.ArrayLike,
    sigma_u: npt.ArrayLike,
    sigma_v: npt.ArrayLike,
    rho: npt.ArrayLike,
) -> Floats:
    """Covariance of the plain conversion h(z), to second order.

    Name: ruv.covariance.truth.second_order.
    Definition: C = e^L(h h') - (e^L h)(e^L h)' to sigma^2.
    Conditioning: truth-conditioned: the measured symbols stand for the true values.
    Source: Lerro & Bar-Shalom 1993, doi:10.1109/7.220948.

    Args:
        r: range [m], 1 to 1e+08.
        u: direction cosine along the x axis; u^2 + v^2 < 1 [1], -0.6 to 0.6.
        v: direction cosine along the y axis; u^2 + v^2 < 1 [1], -0.6 to 0.6.
        sigma_r: standard deviation of the error of r [m], 0.001 to 10000.
        sigma_u: standard deviation of the error of u [1], 1e-09 to 0.1.
        sigma_v: standard deviation of the error of v [1], 1e-09 to 0.1.
        rho: correlation of the errors of u and v [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (3, 3), unit m^2.

    Accuracy: at most 40.2 ulp anywhere in this domain with independent errors, proved for elementary
    functions within 1 ulp (float64); with correlations up to 0.99 in size at most 1720; in float32, with
    functions within 4 of its ulp, at most 262.
    """
    arguments = _floats(r, u, v, sigma_r, sigma_u, sigma_v, rho)
    r, u, v, sigma_r, sigma_u, sigma_v, rho = arguments
    u_squared = u**2
    v_squared = v**2
    root_1 = np.sqrt(1.0 - u_squared - v_squared)
    r_squared = r**2
    sigma_u_squared = sigma_u**2
    sigma_r_squared = sigma_r**2
    sum_1 = u_squared - 1.0 + v_squared
    term_1 = 1.0 / root_1
    sum_2 = (
        -r_squared * rho * sigma_u * sigma_v * v
        - r_squared * sigma_u_squared * u
        - sigma_r_squared * sum_1 * u
    )
    sigma_v_squared = sigma_v**2
    sum_3 = (
        -r_squared * rho * sigma_u * sigma_v * u
        - r_squared * sigma_v_squared * v
        - sigma_r_squared * sum_1 * v
    )
    sum_4 = (
        2.0 * r_squared * rho * sigma_u * sigma_v * u * v
        + r_squared * sigma_u_squared * u_squared
        + r_squared * sigma_v_squared * v_squared
        + sigma_r_squared * sum_1**2
    )
    result = _empty(arguments, (3, 3))
    result[..., 0, 0] = r_squared * sigma_u_squared + sigma_r_squared * u_squared
    result[..., 0, 1] = r_squared * rho * sigma_u * sigma_v + sigma_r_squared * u * v
    result[..., 0, 2] = sum_2 * term_1
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = r_squared * sigma_v_squared + sigma_r_squared * v_squared
    result[..., 1, 2] = sum_3 * term_1
    result[..., 2, 0] = result[..., 0, 2]
    result[..., 2, 1] = result[..., 1, 2]
    result[..., 2, 2] = sum_4 / root_1**2
    return result


def covariance_truth_fourth_order(
    *,
    r: npt.ArrayLike,
    u: npt.ArrayLike,
    v: npt.ArrayLike,
    sigma_r: npt.ArrayLike,
    sigma_u: npt.ArrayLike,
    sigma_v: npt.ArrayLike,
    rho: npt.ArrayLike,
) -> Floats:
    """Covariance of the plain conversion h(z), to fourth order.

    Name: ruv.covariance.truth.fourth_order.
    Definition: C = e^L(h h') - (e^L h)(e^L h)' to sigma^4.
    Conditioning: truth-conditioned: the measured symbols stand for the true values.
    Source: Lerro & Bar-Shalom 1993, doi:10.1109/7.220948.

    Args:
        r: range [m], 1 to 1e+08.
        u: direction cosine along the x axis; u^2 + v^2 < 1 [1], -0.6 to 0.6.
        v: direction cosine along the y axis; u^2 + v^2 < 1 [1], -0.6 to 0.6.
        sigma_r: standard deviation of the error of r [m], 0.001 to 10000.
        sigma_u: standard deviation of the error of u [1], 1e-09 to 0.1.
        sigma_v: standard deviation of the error of v [1], 1e-09 to 0.1.
        rho: correlation of the errors of u and v [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (3, 3), unit m^2.

    Accuracy: at most 108 ulp anywhere in this domain with independent errors, proved for elementary functions
    within 1 ulp (float64); in float32, with functions within 4 of its ulp, at most 107.
    """
    arguments = _floats(r, u, v, sigma_r, sigma_u, sigma_v, rho)
    r, u, v, sigma_r, sigma_u, sigma_v, rho = arguments
    u_squared = u**2
    v_squared = v**2
    root_1 = np.sqrt(1.0 - u_squared - v_squared)
    r_squared = r**2
    sigma_u_squared = sigma_u**2
    sigma_r_squared = sigma_r**2
    sum_1 = 1.0 - v_squared + 2.0 * u_squared
    product_1 = sigma_u * sigma_u_squared
    sum_2 = u_squared - 1.0 + v_squared
    sum_2_squared = sum_2**2
    sum_3 = 1.0 + v
    sum_4 = v - 1.0
    sum_5 = 2.0 * u_squared - 3.0 + 3.0 * v_squared
    sigma_v_squared = sigma_v**2
    sum_6 = 1.0 + u
    sum_7 = u - 1.0
    product_2 = sum_2 * sum_2_squared
    product_3 = sigma_v * sigma_v_squared
    sigma_u_squared_squared = sigma_u_squared**2
    rho_squared = rho**2
    sum_8 = u_squared - 1.0 - 2.0 * v_squared
    term_1 = 1.0 / (root_1 * (root_1**2)**2)
    sum_9 = (
        1.5 * product_3 * r_squared * rho * sigma_u * sum_6 * sum_7 * v
        - 1.5 * product_1 * r_squared * rho * sigma_v * sum_1 * v
        - product_2 * sigma_r_squared * u
        - r_squared * sigma_u_squared * sum_2_squared * u
        - r_squared * rho * sigma_u * sigma_v * sum_2_squared * v
        - 0.5 * sigma_r_squared * sigma_u_squared * sum_2 * sum_5 * u
        - 0.5 * sigma_r_squared * sigma_v_squared * sum_2 * sum_6 * sum_7 * u
        - rho * sigma_r_squared * sigma_u * sigma_v * sum_2 * sum_3 * sum_4 * v
        + 1.5 * r_squared * sigma_u_squared_squared * sum_3 * sum_4 * u
        + r_squared * rho_squared * sigma_u_squared * sigma_v_squared * sum_8 * u
        + 0.5 * r_squared * sigma_u_squared * sigma_v_squared * sum_8 * u
    )
    sum_10 = 2.0 * v_squared - 3.0 + 3.0 * u_squared
    sigma_v_squared_squared = sigma_v_squared**2
    sum_11 = (
        1.5 * product_1 * r_squared * rho * sigma_v * sum_3 * sum_4 * u
        - product_2 * sigma_r_squared * v
        - r_squared * rho_squared * sigma_u_squared * sigma_v_squared * sum_1 * v
        - 0.5 * r_squared * sigma_u_squared * sigma_v_squared * sum_1 * v
        - r_squared * sigma_v_squared * sum_2_squared * v
        - r_squared * rho * sigma_u * sigma_v * sum_2_squared * u
        - 0.5 * sigma_r_squared * sigma_u_squared * sum_2 * sum_3 * sum_4 * v
        - 0.5 * sigma_r_squared * sigma_v_squared * sum_10 * sum_2 * v
        - rho * sigma_r_squared * sigma_u * sigma_v * sum_2 * sum_6 * sum_7 * u
        + 1.5 * product_3 * r_squared * rho * sigma_u * sum_8 * u
        + 1.5 * r_squared * sigma_v_squared_squared * sum_6 * sum_7 * v
    )
    sum_12 = 4.0 * u_squared - 4.0 - 3.0 * v_squared
    sum_13 = 1.0 - v_squared + 6.0 * u_squared
    sum_14 = 4.0 - 4.0 * v_squared + 3.0 * u_squared
    u_squared_squared = u_squared**2
    v_squared_squared = v_squared**2
    sum_15 = (
        1.0
        - 2.0 * u_squared_squared
        - 2.0 * v_squared_squared
        + 10.0 * u_squared * v_squared
        + u_squared
        + v_squared
    )
    sum_16 = 5.0 * u_squared * v_squared - u_squared_squared - v_squared_squared + u_squared + v_squared
    sum_17 = u_squared - 1.0 - 6.0 * v_squared
    sum_18 = (
        2.0 * product_1 * r_squared * rho * sigma_v * sum_14 * u * v
        - 2.0 * product_3 * r_squared * rho * sigma_u * sum_12 * u * v
        - 0.5 * r_squared * sigma_u_squared_squared * sum_13 * sum_3 * sum_4
        + 2.0 * r_squared * rho * sigma_u * sigma_v * sum_2_squared * u * v
        + product_2 * sigma_r_squared * sigma_u_squared
        + product_2 * sigma_r_squared * sigma_v_squared
        + r_squared * rho_squared * sigma_u_squared * sigma_v_squared * sum_15
        + r_squared * sigma_u_squared * sigma_v_squared * sum_16
        + r_squared * sigma_u_squared * sum_2_squared * u_squared
        + r_squared * sigma_v_squared * sum_2_squared * v_squared
        + 0.5 * r_squared * sigma_v_squared_squared * sum_17 * sum_6 * sum_7
        + sigma_r_squared * sum_2_squared**2
    )
    result = _empty(arguments, (3, 3))
    result[..., 0, 0] = (
        r_squared * sigma_u_squared
        + sigma_r_squared * sigma_u_squared
        + sigma_r_squared * u_squared
    )
    result[..., 0, 1] = (
        r_squared * rho * sigma_u * sigma_v
        + rho * sigma_r_squared * sigma_u * sigma_v
        + sigma_r_squared * u * v
    )
    result[..., 0, 2] = sum_9 * term_1
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = (
        r_squared * sigma_v_squared
        + sigma_r_squared * sigma_v_squared
        + sigma_r_squared * v_squared
    )
    result[..., 1, 2] = sum_11 * term_1
    result[..., 2, 0] = result[..., 0, 2]
    result[..., 2, 1] = result[..., 1, 2]
    result[..., 2, 2] = sum_18 / (root_1 * root_1**2)**2
    return result


def covariance_averaged_second_order(
    *,
    r: npt.ArrayLike,
    u: npt.ArrayLike,
    v: npt.ArrayLike,
    sigma_r: npt.ArrayLike,
    sigma_u: npt.ArrayLike,
    sigma_v: npt.ArrayLike,
    rho: npt.ArrayLike,
) -> Floats:
    """Covariance of the plain conversion, averaged over the truth, to second order.

    Name: ruv.covariance.averaged.second_order.
    Definition: e^L C to sigma^2.
    Conditioning: measurement-conditioned: the measured symbols stand for the measurement.
    Source: Lerro & Bar-Shalom 1993; Prosov (11), doi:10.1109/7.220948.

    Args:
        r: range [m], 1 to 1e+08.
        u: direction cosine along the x axis; u^2 + v^2 < 1 [1], -0.6 to 0.6.
        v: direction cosine along the y axis; u^2 + v^2 < 1 [1], -0.6 to 0.6.
        sigma_r: standard deviation of the error of r [m], 0.001 to 10000.
        sigma_u: standard deviation of the error of u [1], 1e-09 to 0.1.
        sigma_v: standard deviation of the error of v [1], 1e-09 to 0.1.
        rho: correlation of the errors of u and v [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (3, 3), unit m^2.

    Accuracy: at most 40.2 ulp anywhere in this domain with independent errors, proved for elementary
    functions within 1 ulp (float64); with correlations up to 0.99 in size at most 1720; in float32, with
    functions within 4 of its ulp, at most 262.
    """
    arguments = _floats(r, u, v, sigma_r, sigma_u, sigma_v, rho)
    r, u, v, sigma_r, sigma_u, sigma_v, rho = arguments
    u_squared = u**2
    v_squared = v**2
    root_1 = np.sqrt(1.0 - u_squared - v_squared)
    r_squared = r**2
    sigma_u_squared = sigma_u**2
    sigma_r_squared = sigma_r**2
    sum_1 = u_squared - 1.0 + v_squared
    term_1 = 1.0 / root_1
    sum_2 = (
        -r_squared * rho * sigma_u * sigma_v * v
        - r_squared * sigma_u_squared * u
        - sigma_r_squared * sum_1 * u
    )
    sigma_v_squared = sigma_v**2
    sum_3 = (
        -r_squared * rho * sigma_u * sigma_v * u
        - r_squared * sigma_v_squared * v
        - sigma_r_squared * sum_1 * v
    )
    sum_4 = (
        2.0 * r_squared * rho * sigma_u * sigma_v * u * v
        + r_squared * sigma_u_squared * u_squared
        + r_squared * sigma_v_squared * v_squared
        + sigma_r_squared * sum_1**2
    )
    result = _empty(arguments, (3, 3))
    result[..., 0, 0] = r_squared * sigma_u_squared + sigma_r_squared * u_squared
    result[..., 0, 1] = r_squared * rho * sigma_u * sigma_v + sigma_r_squared * u * v
    result[..., 0, 2] = sum_2 * term_1
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = r_squared * sigma_v_squared + sigma_r_squared * v_squared
    result[..., 1, 2] = sum_3 * term_1
    result[..., 2, 0] = result[..., 0, 2]
    result[..., 2, 1] = result[..., 1, 2]
    result[..., 2, 2] = sum_4 / root_1**2
    return result


def covariance_averaged_fourth_order(
    *,
    r: npt.ArrayLike,
    u: npt.ArrayLike,
    v: npt.ArrayLike,
    sigma_r: npt.ArrayLike,
    sigma_u: npt.ArrayLike,
    sigma_v: npt.ArrayLike,
    rho: npt.ArrayLike,
) -> Floats:
    """Covariance of the plain conversion, averaged over the truth, to fourth order.

    Name: ruv.covariance.averaged.fourth_order.
    Definition: e^L C to sigma^4.
    Conditioning: measurement-conditioned: the measured symbols stand for the measurement.
    Source: Lerro & Bar-Shalom 1993; Prosov (11), doi:10.1109/7.220948.

    Args:
        r: range [m], 1 to 1e+08.
        u: direction cosine along the x axis; u^2 + v^2 < 1 [1], -0.6 to 0.6.
        v: direction cosine along the y axis; u^2 + v^2 < 1 [1], -0.6 to 0.6.
        sigma_r: standard deviation of the error of r [m], 0.001 to 10000.
        sigma_u: standard deviation of the error of u [1], 1e-09 to 0.1.
        sigma_v: standard deviation of the error of v [1], 1e-09 to 0.1.
        rho: correlation of the errors of u and v [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (3, 3), unit m^2.

    Accuracy: at most 202 ulp anywhere in this domain with independent errors, proved for elementary functions
    within 1 ulp (float64); in float32, with functions within 4 of its ulp, at most 216.
    """
    arguments = _floats(r, u, v, sigma_r, sigma_u, sigma_v, rho)
    r, u, v, sigma_r, sigma_u, sigma_v, rho = arguments
    u_squared = u**2
    v_squared = v**2
    root_1 = np.sqrt(1.0 - u_squared - v_squared)
    sigma_r_squared = sigma_r**2
    sigma_u_squared = sigma_u**2
    r_squared = r**2
    sum_1 = 1.0 - v_squared + 2.0 * u_squared
    product_1 = sigma_u * sigma_u_squared
    sum_2 = u_squared - 1.0 + v_squared
    sum_2_squared = sum_2**2
    sum_3 = 3.0 * v_squared - 3.0 + u_squared
    sum_4 = 3.0 * u_squared - 4.0 + 4.0 * v_squared
    sigma_v_squared = sigma_v**2
    sum_5 = 1.0 + u
    sum_6 = u - 1.0
    product_2 = sum_2 * sum_2_squared
    rho_squared = rho**2
    sum_7 = u_squared - 1.0 - 2.0 * v_squared
    product_3 = sigma_v * sigma_v_squared
    sigma_u_squared_squared = sigma_u_squared**2
    sum_8 = 1.0 + v
    sum_9 = v - 1.0
    term_1 = 1.0 / (root_1 * (root_1**2)**2)
    sum_10 = (
        2.0 * r_squared * rho_squared * sigma_u_squared * sigma_v_squared * sum_7 * u
        - 3.0 * product_1 * r_squared * rho * sigma_v * sum_1 * v
        - product_2 * sigma_r_squared * u
        - r_squared * sigma_u_squared * sum_2_squared * u
        - r_squared * rho * sigma_u * sigma_v * sum_2_squared * v
        - sigma_r_squared * sigma_u_squared * sum_2 * sum_4 * u
        - sigma_r_squared * sigma_v_squared * sum_2 * sum_5 * sum_6 * u
        - rho * sigma_r_squared * sigma_u * sigma_v * sum_2 * sum_3 * v
        + 3.0 * product_3 * r_squared * rho * sigma_u * sum_5 * sum_6 * v
        + 3.0 * r_squared * sigma_u_squared_squared * sum_8 * sum_9 * u
        + r_squared * sigma_u_squared * sigma_v_squared * sum_7 * u
    )
    sum_11 = 3.0 * u_squared - 3.0 + v_squared
    sum_12 = 3.0 * v_squared - 4.0 + 4.0 * u_squared
    sigma_v_squared_squared = sigma_v_squared**2
    sum_13 = (
        3.0 * product_1 * r_squared * rho * sigma_v * sum_8 * sum_9 * u
        - 2.0 * r_squared * rho_squared * sigma_u_squared * sigma_v_squared * sum_1 * v
        - product_2 * sigma_r_squared * v
        - r_squared * sigma_u_squared * sigma_v_squared * sum_1 * v
        - r_squared * sigma_v_squared * sum_2_squared * v
        - r_squared * rho * sigma_u * sigma_v * sum_2_squared * u
        - sigma_r_squared * sigma_u_squared * sum_2 * sum_8 * sum_9 * v
        - sigma_r_squared * sigma_v_squared * sum_12 * sum_2 * v
        - rho * sigma_r_squared * sigma_u * sigma_v * sum_11 * sum_2 * u
        + 3.0 * product_3 * r_squared * rho * sigma_u * sum_7 * u
        + 3.0 * r_squared * sigma_v_squared_squared * sum_5 * sum_6 * v
    )
    sum_14 = 1.0 - v_squared + 4.0 * u_squared
    sum_15 = 3.0 * u_squared - 3.0 - 2.0 * v_squared
    sum_16 = u_squared - 1.0 - 4.0 * v_squared
    sum_17 = 3.0 - 3.0 * v_squared + 2.0 * u_squared
    u_squared_squared = u_squared**2
    v_squared_squared = v_squared**2
    sum_18 = (
        3.0
        - 4.0 * u_squared_squared
        - 4.0 * v_squared_squared
        + 22.0 * u_squared * v_squared
        + u_squared
        + v_squared
    )
    sum_19 = (
        11.0 * u_squared * v_squared
        - 2.0 * u_squared_squared
        - 2.0 * v_squared_squared
        + 2.0 * u_squared
        + 2.0 * v_squared
    )
    sum_20 = 2.0 * v_squared - 2.0 + 3.0 * u_squared
    sum_21 = 2.0 * u_squared - 2.0 + 3.0 * v_squared
    sum_22 = (
        2.0 * r_squared * rho * sigma_u * sigma_v * sum_2_squared * u * v
        - 1.5 * r_squared * sigma_u_squared_squared * sum_14 * sum_8 * sum_9
        - 6.0 * product_3 * r_squared * rho * sigma_u * sum_15 * u * v
        + 2.0 * rho * sigma_r_squared * sigma_u * sigma_v * sum_2_squared * u * v
        + 1.5 * r_squared * sigma_v_squared_squared * sum_16 * sum_5 * sum_6
        + 6.0 * product_1 * r_squared * rho * sigma_v * sum_17 * u * v
        + r_squared * rho_squared * sigma_u_squared * sigma_v_squared * sum_18
        + r_squared * sigma_u_squared * sigma_v_squared * sum_19
        + r_squared * sigma_u_squared * sum_2_squared * u_squared
        + r_squared * sigma_v_squared * sum_2_squared * v_squared
        + sigma_r_squared * sigma_u_squared * sum_20 * sum_2_squared
        + sigma_r_squared * sigma_v_squared * sum_21 * sum_2_squared
        + sigma_r_squared * sum_2_squared**2
    )
    result = _empty(arguments, (3, 3))
    result[..., 0, 0] = (
        3.0 * sigma_r_squared * sigma_u_squared
        + r_squared * sigma_u_squared
        + sigma_r_squared * u_squared
    )
    result[..., 0, 1] = (
        3.0 * rho * sigma_r_squared * sigma_u * sigma_v
        + r_squared * rho * sigma_u * sigma_v
        + sigma_r_squared * u * v
    )
    result[..., 0, 2] = sum_10 * term_1
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = (
        3.0 * sigma_r_squared * sigma_v_squared
        + r_squared * sigma_v_squared
        + sigma_r_squared * v_squared
    )
    result[..., 1, 2] = sum_13 * term_1
    result[..., 2, 0] = result[..., 0, 2]
    result[..., 2, 1] = result[..., 1, 2]
    result[..., 2, 2] = sum_22 / (root_1 * root_1**2)**2
    return result


def unbiased_estimate_second_order(
    *,
    r: npt.ArrayLike,
    u: npt.ArrayLike,
    v: npt.ArrayLike,
    sigma_r: npt.ArrayLike,
    sigma_u: npt.ArrayLike,
    sigma_v: npt.ArrayLike,
    rho: npt.ArrayLike,
) -> Floats:
    """Unbiased estimate of the position, to second order.

    Name: ruv.unbiased.estimate.second_order.
    Definition: u = e^-L h to sigma^2.
    Conditioning: measurement-conditioned: the measured symbols stand for the measurement.
    Source: Mo et al. 1998, doi:10.1109/7.705921.

    Args:
        r: range [m], 1 to 1e+08.
        u: direction cosine along the x axis; u^2 + v^2 < 1 [1], -0.6 to 0.6.
        v: direction cosine along the y axis; u^2 + v^2 < 1 [1], -0.6 to 0.6.
        sigma_r: standard deviation of the error of r [m], 0.001 to 10000.
        sigma_u: standard deviation of the error of u [1], 1e-09 to 0.1.
        sigma_v: standard deviation of the error of v [1], 1e-09 to 0.1.
        rho: correlation of the errors of u and v [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (3), unit m.

    Accuracy: at most 46.1 ulp anywhere in this domain with independent errors, proved for elementary
    functions within 1 ulp (float64); with correlations up to 0.99 in size at most 55.8; in float32, with
    functions within 4 of its ulp, at most 46.5.
    """
    arguments = _floats(r, u, v, sigma_r, sigma_u, sigma_v, rho)
    r, u, v, sigma_r, sigma_u, sigma_v, rho = arguments
    u_squared = u**2
    v_squared = v**2
    root_1 = np.sqrt(1.0 - u_squared - v_squared)
    sum_1 = (
        (u_squared - 1.0 + v_squared)**2 * r
        - 0.5 * r * sigma_u**2 * (1.0 + v) * (v - 1.0)
        - 0.5 * r * sigma_v**2 * (1.0 + u) * (u - 1.0)
        + r * rho * sigma_u * sigma_v * u * v
    )
    result = _empty(arguments, (3,))
    result[..., 0] = r * u
    result[..., 1] = r * v
    result[..., 2] = sum_1 / (root_1 * root_1**2)
    return result


def unbiased_estimate_fourth_order(
    *,
    r: npt.ArrayLike,
    u: npt.ArrayLike,
    v: npt.ArrayLike,
    sigma_r: npt.ArrayLike,
    sigma_u: npt.ArrayLike,
    sigma_v: npt.ArrayLike,
    rho: npt.ArrayLike,
) -> Floats:
    """Unbiased estimate of the position, to fourth order.

    Name: ruv.unbiased.estimate.fourth_order.
    Definition: u = e^-L h to sigma^4.
    Conditioning: measurement-conditioned: the measured symbols stand for the measurement.
    Source: Mo et al. 1998, doi:10.1109/7.705921.

    Args:
        r: range [m], 1 to 1e+08.
        u: direction cosine along the x axis; u^2 + v^2 < 1 [1], -0.6 to 0.6.
        v: direction cosine along the y axis; u^2 + v^2 < 1 [1], -0.6 to 0.6.
        sigma_r: standard deviation of the error of r [m], 0.001 to 10000.
        sigma_u: standard deviation of the error of u [1], 1e-09 to 0.1.
        sigma_v: standard deviation of the error of v [1], 1e-09 to 0.1.
        rho: correlation of the errors of u and v [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (3), unit m.

    Accuracy: at most 78.6 ulp anywhere in this domain with independent errors, proved for elementary
    functions within 1 ulp (float64); with correlations up to 0.99 in size at most 136; in float32, with
    functions within 4 of its ulp, at most 78.6.
    """
    arguments = _floats(r, u, v, sigma_r, sigma_u, sigma_v, rho)
    r, u, v, sigma_r, sigma_u, sigma_v, rho = arguments
    u_squared = u**2
    v_squared = v**2
    root_1 = np.sqrt(1.0 - u_squared - v_squared)
    sigma_u_squared = sigma_u**2
    sum_1 = 3.0 - 3.0 * v_squared + 2.0 * u_squared
    sigma_v_squared = sigma_v**2
    sum_2 = 1.0 + u
    sum_3 = u - 1.0
    sum_4 = u_squared - 1.0 - 4.0 * v_squared
    sum_5 = u_squared - 1.0 + v_squared
    sum_5_squared = sum_5**2
    sum_6 = 1.0 + v
    sum_7 = v - 1.0
    sum_8 = 3.0 * u_squared - 3.0 - 2.0 * v_squared
    sum_9 = 1.0 - v_squared + 4.0 * u_squared
    sum_10 = (
        2.0 * u_squared**2
        - 1.0
        - 11.0 * u_squared * v_squared
        - u_squared
        - v_squared
        + 2.0 * v_squared**2
    )
    sum_11 = (
        0.375 * r * sigma_u_squared**2 * sum_6 * sum_7 * sum_9
        - 1.5 * r * rho * sigma_u * sigma_u_squared * sigma_v * sum_1 * u * v
        - 0.375 * r * sigma_v_squared**2 * sum_2 * sum_3 * sum_4
        - 0.5 * r * sigma_u_squared * sum_5_squared * sum_6 * sum_7
        - 0.5 * r * sigma_v_squared * sum_2 * sum_3 * sum_5_squared
        + 1.5 * r * rho * sigma_u * sigma_v * sigma_v_squared * sum_8 * u * v
        + 0.5 * r * rho**2 * sigma_u_squared * sigma_v_squared * sum_10
        + 0.25 * r * sigma_u_squared * sigma_v_squared * sum_10
        + r * sum_5_squared**2
        + r * rho * sigma_u * sigma_v * sum_5_squared * u * v
    )
    result = _empty(arguments, (3,))
    result[..., 0] = r * u
    result[..., 1] = r * v
    result[..., 2] = sum_11 / (root_1 * (root_1 * root_1**2)**2)
    return result


def unbiased_covariance_second_order(
    *,
    r: npt.ArrayLike,
    u: npt.ArrayLike,
    v: npt.ArrayLike,
    sigma_r: npt.ArrayLike,
    sigma_u: npt.ArrayLike,
    sigma_v: npt.ArrayLike,
    rho: npt.ArrayLike,
) -> Floats:
    """Error covariance of the unbiased estimate u, to second order.

    Name: ruv.unbiased.covariance.second_order.
    Definition: u u' - u (e^L h)' - (e^L h) u' + e^L(h h') to sigma^2.
    Conditioning: measurement-conditioned: the measured symbols stand for the measurement.
    Source: Mo et al. 1998, doi:10.1109/7.705921.

    Args:
        r: range [m], 1 to 1e+08.
        u: direction cosine along the x axis; u^2 + v^2 < 1 [1], -0.6 to 0.6.
        v: direction cosine along the y axis; u^2 + v^2 < 1 [1], -0.6 to 0.6.
        sigma_r: standard deviation of the error of r [m], 0.001 to 10000.
        sigma_u: standard deviation of the error of u [1], 1e-09 to 0.1.
        sigma_v: standard deviation of the error of v [1], 1e-09 to 0.1.
        rho: correlation of the errors of u and v [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (3, 3), unit m^2.

    Accuracy: at most 40.2 ulp anywhere in this domain with independent errors, proved for elementary
    functions within 1 ulp (float64); with correlations up to 0.99 in size at most 1720; in float32, with
    functions within 4 of its ulp, at most 262.
    """
    arguments = _floats(r, u, v, sigma_r, sigma_u, sigma_v, rho)
    r, u, v, sigma_r, sigma_u, sigma_v, rho = arguments
    u_squared = u**2
    v_squared = v**2
    root_1 = np.sqrt(1.0 - u_squared - v_squared)
    r_squared = r**2
    sigma_u_squared = sigma_u**2
    sigma_r_squared = sigma_r**2
    sum_1 = u_squared - 1.0 + v_squared
    term_1 = 1.0 / root_1
    sum_2 = (
        -r_squared * rho * sigma_u * sigma_v * v
        - r_squared * sigma_u_squared * u
        - sigma_r_squared * sum_1 * u
    )
    sigma_v_squared = sigma_v**2
    sum_3 = (
        -r_squared * rho * sigma_u * sigma_v * u
        - r_squared * sigma_v_squared * v
        - sigma_r_squared * sum_1 * v
    )
    sum_4 = (
        2.0 * r_squared * rho * sigma_u * sigma_v * u * v
        + r_squared * sigma_u_squared * u_squared
        + r_squared * sigma_v_squared * v_squared
        + sigma_r_squared * sum_1**2
    )
    result = _empty(arguments, (3, 3))
    result[..., 0, 0] = r_squared * sigma_u_squared + sigma_r_squared * u_squared
    result[..., 0, 1] = r_squared * rho * sigma_u * sigma_v + sigma_r_squared * u * v
    result[..., 0, 2] = sum_2 * term_1
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = r_squared * sigma_v_squared + sigma_r_squared * v_squared
    result[..., 1, 2] = sum_3 * term_1
    result[..., 2, 0] = result[..., 0, 2]
    result[..., 2, 1] = result[..., 1, 2]
    result[..., 2, 2] = sum_4 / root_1**2
    return result


def unbiased_covariance_fourth_order(
    *,
    r: npt.ArrayLike,
    u: npt.ArrayLike,
    v: npt.ArrayLike,
    sigma_r: npt.ArrayLike,
    sigma_u: npt.ArrayLike,
    sigma_v: npt.ArrayLike,
    rho: npt.ArrayLike,
) -> Floats:
    """Error covariance of the unbiased estimate u, to fourth order.

    Name: ruv.unbiased.covariance.fourth_order.
    Definition: u u' - u (e^L h)' - (e^L h) u' + e^L(h h') to sigma^4.
    Conditioning: measurement-conditioned: the measured symbols stand for the measurement.
    Source: Mo et al. 1998, doi:10.1109/7.705921.

    Args:
        r: range [m], 1 to 1e+08.
        u: direction cosine along the x axis; u^2 + v^2 < 1 [1], -0.6 to 0.6.
        v: direction cosine along the y axis; u^2 + v^2 < 1 [1], -0.6 to 0.6.
        sigma_r: standard deviation of the error of r [m], 0.001 to 10000.
        sigma_u: standard deviation of the error of u [1], 1e-09 to 0.1.
        sigma_v: standard deviation of the error of v [1], 1e-09 to 0.1.
        rho: correlation of the errors of u and v [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (3, 3), unit m^2.

    Accuracy: at most 108 ulp anywhere in this domain with independent errors, proved for elementary functions
    within 1 ulp (float64); in float32, with functions within 4 of its ulp, at most 108.
    """
    arguments = _floats(r, u, v, sigma_r, sigma_u, sigma_v, rho)
    r, u, v, sigma_r, sigma_u, sigma_v, rho = arguments
    u_squared = u**2
    v_squared = v**2
    root_1 = np.sqrt(1.0 - u_squared - v_squared)
    r_squared = r**2
    sigma_u_squared = sigma_u**2
    sigma_r_squared = sigma_r**2
    sum_1 = 1.0 - v_squared + 2.0 * u_squared
    product_1 = sigma_u * sigma_u_squared
    sum_2 = u_squared - 1.0 + v_squared
    sum_2_squared = sum_2**2
    sum_3 = 1.0 + v
    sum_4 = v - 1.0
    sum_5 = 2.0 * u_squared - 3.0 + 3.0 * v_squared
    sigma_v_squared = sigma_v**2
    sum_6 = 1.0 + u
    sum_7 = u - 1.0
    product_2 = sum_2 * sum_2_squared
    product_3 = sigma_v * sigma_v_squared
    sigma_u_squared_squared = sigma_u_squared**2
    rho_squared = rho**2
    sum_8 = u_squared - 1.0 - 2.0 * v_squared
    term_1 = 1.0 / (root_1 * (root_1**2)**2)
    sum_9 = (
        1.5 * product_3 * r_squared * rho * sigma_u * sum_6 * sum_7 * v
        - 1.5 * product_1 * r_squared * rho * sigma_v * sum_1 * v
        - product_2 * sigma_r_squared * u
        - r_squared * sigma_u_squared * sum_2_squared * u
        - r_squared * rho * sigma_u * sigma_v * sum_2_squared * v
        - 0.5 * sigma_r_squared * sigma_u_squared * sum_2 * sum_5 * u
        - 0.5 * sigma_r_squared * sigma_v_squared * sum_2 * sum_6 * sum_7 * u
        - rho * sigma_r_squared * sigma_u * sigma_v * sum_2 * sum_3 * sum_4 * v
        + 1.5 * r_squared * sigma_u_squared_squared * sum_3 * sum_4 * u
        + r_squared * rho_squared * sigma_u_squared * sigma_v_squared * sum_8 * u
        + 0.5 * r_squared * sigma_u_squared * sigma_v_squared * sum_8 * u
    )
    sum_10 = 2.0 * v_squared - 3.0 + 3.0 * u_squared
    sigma_v_squared_squared = sigma_v_squared**2
    sum_11 = (
        1.5 * product_1 * r_squared * rho * sigma_v * sum_3 * sum_4 * u
        - product_2 * sigma_r_squared * v
        - r_squared * rho_squared * sigma_u_squared * sigma_v_squared * sum_1 * v
        - 0.5 * r_squared * sigma_u_squared * sigma_v_squared * sum_1 * v
        - r_squared * sigma_v_squared * sum_2_squared * v
        - r_squared * rho * sigma_u * sigma_v * sum_2_squared * u
        - 0.5 * sigma_r_squared * sigma_u_squared * sum_2 * sum_3 * sum_4 * v
        - 0.5 * sigma_r_squared * sigma_v_squared * sum_10 * sum_2 * v
        - rho * sigma_r_squared * sigma_u * sigma_v * sum_2 * sum_6 * sum_7 * u
        + 1.5 * product_3 * r_squared * rho * sigma_u * sum_8 * u
        + 1.5 * r_squared * sigma_v_squared_squared * sum_6 * sum_7 * v
    )
    sum_12 = 2.0 * u_squared - 2.0 - v_squared
    sum_13 = 2.0 - 2.0 * v_squared + u_squared
    u_squared_squared = u_squared**2
    v_squared_squared = v_squared**2
    sum_14 = (
        1.0
        - 2.0 * u_squared_squared
        - 2.0 * v_squared_squared
        + 14.0 * u_squared * v_squared
        + u_squared
        + v_squared
    )
    sum_15 = 2.0 - u_squared - u_squared_squared - v_squared - v_squared_squared + 7.0 * u_squared * v_squared
    sum_16 = (
        2.0 * r_squared * rho * sigma_u * sigma_v * sum_2_squared * u * v
        - 1.5 * r_squared * sigma_u_squared_squared * sum_1 * sum_3 * sum_4
        - 6.0 * product_3 * r_squared * rho * sigma_u * sum_12 * u * v
        + 1.5 * r_squared * sigma_v_squared_squared * sum_6 * sum_7 * sum_8
        + 6.0 * product_1 * r_squared * rho * sigma_v * sum_13 * u * v
        + product_2 * sigma_r_squared * sigma_u_squared
        + product_2 * sigma_r_squared * sigma_v_squared
        + r_squared * rho_squared * sigma_u_squared * sigma_v_squared * sum_14
        + r_squared * sigma_u_squared * sigma_v_squared * sum_15
        + r_squared * sigma_u_squared * sum_2_squared * u_squared
        + r_squared * sigma_v_squared * sum_2_squared * v_squared
        + sigma_r_squared * sum_2_squared**2
    )
    result = _empty(arguments, (3, 3))
    result[..., 0, 0] = (
        r_squared * sigma_u_squared
        + sigma_r_squared * sigma_u_squared
        + sigma_r_squared * u_squared
    )
    result[..., 0, 1] = (
        r_squared * rho * sigma_u * sigma_v
        + rho * sigma_r_squared * sigma_u * sigma_v
        + sigma_r_squared * u * v
    )
    result[..., 0, 2] = sum_9 * term_1
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = (
        r_squared * sigma_v_squared
        + sigma_r_squared * sigma_v_squared
        + sigma_r_squared * v_squared
    )
    result[..., 1, 2] = sum_11 * term_1
    result[..., 2, 0] = result[..., 0, 2]
    result[..., 2, 1] = result[..., 1, 2]
    result[..., 2, 2] = sum_16 / (root_1 * root_1**2)**2
    return result


def posterior_estimate_second_order(
    *,
    r: npt.ArrayLike,
    u: npt.ArrayLike,
    v: npt.ArrayLike,
    sigma_r: npt.ArrayLike,
    sigma_u: npt.ArrayLike,
    sigma_v: npt.ArrayLike,
    rho: npt.ArrayLike,
) -> Floats:
    """Posterior mean of the position under a flat prior, to second order.

    Name: ruv.posterior.estimate.second_order.
    Definition: e^L h to sigma^2.
    Conditioning: measurement-conditioned: the measured symbols stand for the measurement.
    Source: Duan et al. 2004 modified unbiased, doi:10.1109/TAES.2004.1386889.

    Args:
        r: range [m], 1 to 1e+08.
        u: direction cosine along the x axis; u^2 + v^2 < 1 [1], -0.6 to 0.6.
        v: direction cosine along the y axis; u^2 + v^2 < 1 [1], -0.6 to 0.6.
        sigma_r: standard deviation of the error of r [m], 0.001 to 10000.
        sigma_u: standard deviation of the error of u [1], 1e-09 to 0.1.
        sigma_v: standard deviation of the error of v [1], 1e-09 to 0.1.
        rho: correlation of the errors of u and v [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (3), unit m.

    Accuracy: at most 61 ulp anywhere in this domain with independent errors, proved for elementary functions
    within 1 ulp (float64); with correlations up to 0.99 in size at most 65.9; in float32, with functions
    within 4 of its ulp, at most 61.7.
    """
    arguments = _floats(r, u, v, sigma_r, sigma_u, sigma_v, rho)
    r, u, v, sigma_r, sigma_u, sigma_v, rho = arguments
    u_squared = u**2
    v_squared = v**2
    root_1 = np.sqrt(1.0 - u_squared - v_squared)
    sum_1 = (
        (u_squared - 1.0 + v_squared)**2 * r
        - r * rho * sigma_u * sigma_v * u * v
        + 0.5 * r * sigma_u**2 * (1.0 + v) * (v - 1.0)
        + 0.5 * r * sigma_v**2 * (1.0 + u) * (u - 1.0)
    )
    result = _empty(arguments, (3,))
    result[..., 0] = r * u
    result[..., 1] = r * v
    result[..., 2] = sum_1 / (root_1 * root_1**2)
    return result


def posterior_estimate_fourth_order(
    *,
    r: npt.ArrayLike,
    u: npt.ArrayLike,
    v: npt.ArrayLike,
    sigma_r: npt.ArrayLike,
    sigma_u: npt.ArrayLike,
    sigma_v: npt.ArrayLike,
    rho: npt.ArrayLike,
) -> Floats:
    """Posterior mean of the position under a flat prior, to fourth order.

    Name: ruv.posterior.estimate.fourth_order.
    Definition: e^L h to sigma^4.
    Conditioning: measurement-conditioned: the measured symbols stand for the measurement.
    Source: Duan et al. 2004 modified unbiased, doi:10.1109/TAES.2004.1386889.

    Args:
        r: range [m], 1 to 1e+08.
        u: direction cosine along the x axis; u^2 + v^2 < 1 [1], -0.6 to 0.6.
        v: direction cosine along the y axis; u^2 + v^2 < 1 [1], -0.6 to 0.6.
        sigma_r: standard deviation of the error of r [m], 0.001 to 10000.
        sigma_u: standard deviation of the error of u [1], 1e-09 to 0.1.
        sigma_v: standard deviation of the error of v [1], 1e-09 to 0.1.
        rho: correlation of the errors of u and v [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (3), unit m.

    Accuracy: at most 151 ulp anywhere in this domain with independent errors, proved for elementary functions
    within 1 ulp (float64); with correlations up to 0.99 in size at most 188; in float32, with functions
    within 4 of its ulp, at most 153.
    """
    arguments = _floats(r, u, v, sigma_r, sigma_u, sigma_v, rho)
    r, u, v, sigma_r, sigma_u, sigma_v, rho = arguments
    u_squared = u**2
    v_squared = v**2
    root_1 = np.sqrt(1.0 - u_squared - v_squared)
    sigma_u_squared = sigma_u**2
    sum_1 = 3.0 - 3.0 * v_squared + 2.0 * u_squared
    sigma_v_squared = sigma_v**2
    sum_2 = 1.0 + u
    sum_3 = u - 1.0
    sum_4 = u_squared - 1.0 - 4.0 * v_squared
    sum_5 = u_squared - 1.0 + v_squared
    sum_5_squared = sum_5**2
    sum_6 = 3.0 * u_squared - 3.0 - 2.0 * v_squared
    sum_7 = 1.0 + v
    sum_8 = v - 1.0
    sum_9 = 1.0 - v_squared + 4.0 * u_squared
    sum_10 = (
        2.0 * u_squared**2
        - 1.0
        - 11.0 * u_squared * v_squared
        - u_squared
        - v_squared
        + 2.0 * v_squared**2
    )
    sum_11 = (
        0.375 * r * sigma_u_squared**2 * sum_7 * sum_8 * sum_9
        - 1.5 * r * rho * sigma_u * sigma_u_squared * sigma_v * sum_1 * u * v
        - 0.375 * r * sigma_v_squared**2 * sum_2 * sum_3 * sum_4
        - r * rho * sigma_u * sigma_v * sum_5_squared * u * v
        + 1.5 * r * rho * sigma_u * sigma_v * sigma_v_squared * sum_6 * u * v
        + 0.5 * r * rho**2 * sigma_u_squared * sigma_v_squared * sum_10
        + 0.25 * r * sigma_u_squared * sigma_v_squared * sum_10
        + 0.5 * r * sigma_u_squared * sum_5_squared * sum_7 * sum_8
        + 0.5 * r * sigma_v_squared * sum_2 * sum_3 * sum_5_squared
        + r * sum_5_squared**2
    )
    result = _empty(arguments, (3,))
    result[..., 0] = r * u
    result[..., 1] = r * v
    result[..., 2] = sum_11 / (root_1 * (root_1 * root_1**2)**2)
    return result


def posterior_covariance_second_order(
    *,
    r: npt.ArrayLike,
    u: npt.ArrayLike,
    v: npt.ArrayLike,
    sigma_r: npt.ArrayLike,
    sigma_u: npt.ArrayLike,
    sigma_v: npt.ArrayLike,
    rho: npt.ArrayLike,
) -> Floats:
    """Posterior covariance of the position under a flat prior, to second order.

    Name: ruv.posterior.covariance.second_order.
    Definition: e^L(h h') - (e^L h)(e^L h)' to sigma^2.
    Conditioning: measurement-conditioned: the measured symbols stand for the measurement.
    Source: Duan et al. 2004 modified unbiased, doi:10.1109/TAES.2004.1386889.

    Args:
        r: range [m], 1 to 1e+08.
        u: direction cosine along the x axis; u^2 + v^2 < 1 [1], -0.6 to 0.6.
        v: direction cosine along the y axis; u^2 + v^2 < 1 [1], -0.6 to 0.6.
        sigma_r: standard deviation of the error of r [m], 0.001 to 10000.
        sigma_u: standard deviation of the error of u [1], 1e-09 to 0.1.
        sigma_v: standard deviation of the error of v [1], 1e-09 to 0.1.
        rho: correlation of the errors of u and v [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (3, 3), unit m^2.

    Accuracy: at most 40.2 ulp anywhere in this domain with independent errors, proved for elementary
    functions within 1 ulp (float64); with correlations up to 0.99 in size at most 1720; in float32, with
    functions within 4 of its ulp, at most 262.
    """
    arguments = _floats(r, u, v, sigma_r, sigma_u, sigma_v, rho)
    r, u, v, sigma_r, sigma_u, sigma_v, rho = arguments
    u_squared = u**2
    v_squared = v**2
    root_1 = np.sqrt(1.0 - u_squared - v_squared)
    r_squared = r**2
    sigma_u_squared = sigma_u**2
    sigma_r_squared = sigma_r**2
    sum_1 = u_squared - 1.0 + v_squared
    term_1 = 1.0 / root_1
    sum_2 = (
        -r_squared * rho * sigma_u * sigma_v * v
        - r_squared * sigma_u_squared * u
        - sigma_r_squared * sum_1 * u
    )
    sigma_v_squared = sigma_v**2
    sum_3 = (
        -r_squared * rho * sigma_u * sigma_v * u
        - r_squared * sigma_v_squared * v
        - sigma_r_squared * sum_1 * v
    )
    sum_4 = (
        2.0 * r_squared * rho * sigma_u * sigma_v * u * v
        + r_squared * sigma_u_squared * u_squared
        + r_squared * sigma_v_squared * v_squared
        + sigma_r_squared * sum_1**2
    )
    result = _empty(arguments, (3, 3))
    result[..., 0, 0] = r_squared * sigma_u_squared + sigma_r_squared * u_squared
    result[..., 0, 1] = r_squared * rho * sigma_u * sigma_v + sigma_r_squared * u * v
    result[..., 0, 2] = sum_2 * term_1
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = r_squared * sigma_v_squared + sigma_r_squared * v_squared
    result[..., 1, 2] = sum_3 * term_1
    result[..., 2, 0] = result[..., 0, 2]
    result[..., 2, 1] = result[..., 1, 2]
    result[..., 2, 2] = sum_4 / root_1**2
    return result


def posterior_covariance_fourth_order(
    *,
    r: npt.ArrayLike,
    u: npt.ArrayLike,
    v: npt.ArrayLike,
    sigma_r: npt.ArrayLike,
    sigma_u: npt.ArrayLike,
    sigma_v: npt.ArrayLike,
    rho: npt.ArrayLike,
) -> Floats:
    """Posterior covariance of the position under a flat prior, to fourth order.

    Name: ruv.posterior.covariance.fourth_order.
    Definition: e^L(h h') - (e^L h)(e^L h)' to sigma^4.
    Conditioning: measurement-conditioned: the measured symbols stand for the measurement.
    Source: Duan et al. 2004 modified unbiased, doi:10.1109/TAES.2004.1386889.

    Args:
        r: range [m], 1 to 1e+08.
        u: direction cosine along the x axis; u^2 + v^2 < 1 [1], -0.6 to 0.6.
        v: direction cosine along the y axis; u^2 + v^2 < 1 [1], -0.6 to 0.6.
        sigma_r: standard deviation of the error of r [m], 0.001 to 10000.
        sigma_u: standard deviation of the error of u [1], 1e-09 to 0.1.
        sigma_v: standard deviation of the error of v [1], 1e-09 to 0.1.
        rho: correlation of the errors of u and v [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (3, 3), unit m^2.

    Accuracy: at most 108 ulp anywhere in this domain with independent errors, proved for elementary functions
    within 1 ulp (float64); in float32, with functions within 4 of its ulp, at most 107.
    """
    arguments = _floats(r, u, v, sigma_r, sigma_u, sigma_v, rho)
    r, u, v, sigma_r, sigma_u, sigma_v, rho = arguments
    u_squared = u**2
    v_squared = v**2
    root_1 = np.sqrt(1.0 - u_squared - v_squared)
    r_squared = r**2
    sigma_u_squared = sigma_u**2
    sigma_r_squared = sigma_r**2
    sum_1 = 1.0 - v_squared + 2.0 * u_squared
    product_1 = sigma_u * sigma_u_squared
    sum_2 = u_squared - 1.0 + v_squared
    sum_2_squared = sum_2**2
    sum_3 = 1.0 + v
    sum_4 = v - 1.0
    sum_5 = 2.0 * u_squared - 3.0 + 3.0 * v_squared
    sigma_v_squared = sigma_v**2
    sum_6 = 1.0 + u
    sum_7 = u - 1.0
    product_2 = sum_2 * sum_2_squared
    product_3 = sigma_v * sigma_v_squared
    sigma_u_squared_squared = sigma_u_squared**2
    rho_squared = rho**2
    sum_8 = u_squared - 1.0 - 2.0 * v_squared
    term_1 = 1.0 / (root_1 * (root_1**2)**2)
    sum_9 = (
        1.5 * product_3 * r_squared * rho * sigma_u * sum_6 * sum_7 * v
        - 1.5 * product_1 * r_squared * rho * sigma_v * sum_1 * v
        - product_2 * sigma_r_squared * u
        - r_squared * sigma_u_squared * sum_2_squared * u
        - r_squared * rho * sigma_u * sigma_v * sum_2_squared * v
        - 0.5 * sigma_r_squared * sigma_u_squared * sum_2 * sum_5 * u
        - 0.5 * sigma_r_squared * sigma_v_squared * sum_2 * sum_6 * sum_7 * u
        - rho * sigma_r_squared * sigma_u * sigma_v * sum_2 * sum_3 * sum_4 * v
        + 1.5 * r_squared * sigma_u_squared_squared * sum_3 * sum_4 * u
        + r_squared * rho_squared * sigma_u_squared * sigma_v_squared * sum_8 * u
        + 0.5 * r_squared * sigma_u_squared * sigma_v_squared * sum_8 * u
    )
    sum_10 = 2.0 * v_squared - 3.0 + 3.0 * u_squared
    sigma_v_squared_squared = sigma_v_squared**2
    sum_11 = (
        1.5 * product_1 * r_squared * rho * sigma_v * sum_3 * sum_4 * u
        - product_2 * sigma_r_squared * v
        - r_squared * rho_squared * sigma_u_squared * sigma_v_squared * sum_1 * v
        - 0.5 * r_squared * sigma_u_squared * sigma_v_squared * sum_1 * v
        - r_squared * sigma_v_squared * sum_2_squared * v
        - r_squared * rho * sigma_u * sigma_v * sum_2_squared * u
        - 0.5 * sigma_r_squared * sigma_u_squared * sum_2 * sum_3 * sum_4 * v
        - 0.5 * sigma_r_squared * sigma_v_squared * sum_10 * sum_2 * v
        - rho * sigma_r_squared * sigma_u * sigma_v * sum_2 * sum_6 * sum_7 * u
        + 1.5 * product_3 * r_squared * rho * sigma_u * sum_8 * u
        + 1.5 * r_squared * sigma_v_squared_squared * sum_6 * sum_7 * v
    )
    sum_12 = 4.0 * u_squared - 4.0 - 3.0 * v_squared
    sum_13 = 1.0 - v_squared + 6.0 * u_squared
    sum_14 = 4.0 - 4.0 * v_squared + 3.0 * u_squared
    u_squared_squared = u_squared**2
    v_squared_squared = v_squared**2
    sum_15 = (
        1.0
        - 2.0 * u_squared_squared
        - 2.0 * v_squared_squared
        + 10.0 * u_squared * v_squared
        + u_squared
        + v_squared
    )
    sum_16 = 5.0 * u_squared * v_squared - u_squared_squared - v_squared_squared + u_squared + v_squared
    sum_17 = u_squared - 1.0 - 6.0 * v_squared
    sum_18 = (
        2.0 * product_1 * r_squared * rho * sigma_v * sum_14 * u * v
        - 2.0 * product_3 * r_squared * rho * sigma_u * sum_12 * u * v
        - 0.5 * r_squared * sigma_u_squared_squared * sum_13 * sum_3 * sum_4
        + 2.0 * r_squared * rho * sigma_u * sigma_v * sum_2_squared * u * v
        + product_2 * sigma_r_squared * sigma_u_squared
        + product_2 * sigma_r_squared * sigma_v_squared
        + r_squared * rho_squared * sigma_u_squared * sigma_v_squared * sum_15
        + r_squared * sigma_u_squared * sigma_v_squared * sum_16
        + r_squared * sigma_u_squared * sum_2_squared * u_squared
        + r_squared * sigma_v_squared * sum_2_squared * v_squared
        + 0.5 * r_squared * sigma_v_squared_squared * sum_17 * sum_6 * sum_7
        + sigma_r_squared * sum_2_squared**2
    )
    result = _empty(arguments, (3, 3))
    result[..., 0, 0] = (
        r_squared * sigma_u_squared
        + sigma_r_squared * sigma_u_squared
        + sigma_r_squared * u_squared
    )
    result[..., 0, 1] = (
        r_squared * rho * sigma_u * sigma_v
        + rho * sigma_r_squared * sigma_u * sigma_v
        + sigma_r_squared * u * v
    )
    result[..., 0, 2] = sum_9 * term_1
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = (
        r_squared * sigma_v_squared
        + sigma_r_squared * sigma_v_squared
        + sigma_r_squared * v_squared
    )
    result[..., 1, 2] = sum_11 * term_1
    result[..., 2, 0] = result[..., 0, 2]
    result[..., 2, 1] = result[..., 1, 2]
    result[..., 2, 2] = sum_18 / (root_1 * root_1**2)**2
    return result


def decorrelated_covariance_second_order(
    *,
    r: npt.ArrayLike,
    u: npt.ArrayLike,
    v: npt.ArrayLike,
    sigma_r: npt.ArrayLike,
    sigma_u: npt.ArrayLike,
    sigma_v: npt.ArrayLike,
    rho: npt.ArrayLike,
    predicted_sigma_r: npt.ArrayLike,
    predicted_sigma_u: npt.ArrayLike,
    predicted_sigma_v: npt.ArrayLike,
    predicted_rho: npt.ArrayLike,
) -> Floats:
    """Covariance of the unbiased estimate u, averaged over a prediction, to second order.

    Name: ruv.decorrelated.covariance.second_order.
    Definition: e^Lp [e^L(u u') - h h'] to sigma^2.
    Conditioning: averaged over a prediction: the measured symbols stand for the predicted mean.
    Source: Bordonaro et al. 2014 decorrelated; Mo et al. 1998 R_m where Kp = K, R_t where Kp = 0,
    doi:10.1109/TAES.2014.120563, doi:10.1109/7.705921.

    Args:
        r: range [m], 1 to 1e+08.
        u: direction cosine along the x axis; u^2 + v^2 < 1 [1], -0.6 to 0.6.
        v: direction cosine along the y axis; u^2 + v^2 < 1 [1], -0.6 to 0.6.
        sigma_r: standard deviation of the error of r [m], 0.001 to 10000.
        sigma_u: standard deviation of the error of u [1], 1e-09 to 0.1.
        sigma_v: standard deviation of the error of v [1], 1e-09 to 0.1.
        rho: correlation of the errors of u and v [1], -1 to 1.
        predicted_sigma_r: standard deviation of the prediction of r [m], 0.001 to 10000.
        predicted_sigma_u: standard deviation of the prediction of u [1], 1e-09 to 0.1.
        predicted_sigma_v: standard deviation of the prediction of v [1], 1e-09 to 0.1.
        predicted_rho: correlation of the predictions of u and v [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (3, 3), unit m^2.

    Accuracy: at most 40.2 ulp anywhere in this domain with independent errors, proved for elementary
    functions within 1 ulp (float64); with correlations up to 0.99 in size at most 1720; in float32, with
    functions within 4 of its ulp, at most 262.
    """
    arguments = _floats(r, u, v, sigma_r, sigma_u, sigma_v, rho, predicted_sigma_r, predicted_sigma_u, predicted_sigma_v, predicted_rho)
    r, u, v, sigma_r, sigma_u, sigma_v, rho, predicted_sigma_r, predicted_sigma_u, predicted_sigma_v, predicted_rho = arguments
    u_squared = u**2
    v_squared = v**2
    root_1 = np.sqrt(1.0 - u_squared - v_squared)
    r_squared = r**2
    sigma_u_squared = sigma_u**2
    sigma_r_squared = sigma_r**2
    sum_1 = u_squared - 1.0 + v_squared
    term_1 = 1.0 / root_1
    sum_2 = (
        -r_squared * rho * sigma_u * sigma_v * v
        - r_squared * sigma_u_squared * u
        - sigma_r_squared * sum_1 * u
    )
    sigma_v_squared = sigma_v**2
    sum_3 = (
        -r_squared * rho * sigma_u * sigma_v * u
        - r_squared * sigma_v_squared * v
        - sigma_r_squared * sum_1 * v
    )
    sum_4 = (
        2.0 * r_squared * rho * sigma_u * sigma_v * u * v
        + r_squared * sigma_u_squared * u_squared
        + r_squared * sigma_v_squared * v_squared
        + sigma_r_squared * sum_1**2
    )
    result = _empty(arguments, (3, 3))
    result[..., 0, 0] = r_squared * sigma_u_squared + sigma_r_squared * u_squared
    result[..., 0, 1] = r_squared * rho * sigma_u * sigma_v + sigma_r_squared * u * v
    result[..., 0, 2] = sum_2 * term_1
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = r_squared * sigma_v_squared + sigma_r_squared * v_squared
    result[..., 1, 2] = sum_3 * term_1
    result[..., 2, 0] = result[..., 0, 2]
    result[..., 2, 1] = result[..., 1, 2]
    result[..., 2, 2] = sum_4 / root_1**2
    return result


def decorrelated_covariance_fourth_order(
    *,
    r: npt.ArrayLike,
    u: npt.ArrayLike,
    v: npt.ArrayLike,
    sigma_r: npt.ArrayLike,
    sigma_u: npt.ArrayLike,
    sigma_v: npt.ArrayLike,
    rho: npt.ArrayLike,
    predicted_sigma_r: npt.ArrayLike,
    predicted_sigma_u: npt.ArrayLike,
    predicted_sigma_v: npt.ArrayLike,
    predicted_rho: npt.ArrayLike,
) -> Floats:
    """Covariance of the unbiased estimate u, averaged over a prediction, to fourth order.

    Name: ruv.decorrelated.covariance.fourth_order.
    Definition: e^Lp [e^L(u u') - h h'] to sigma^4.
    Conditioning: averaged over a prediction: the measured symbols stand for the predicted mean.
    Source: Bordonaro et al. 2014 decorrelated; Mo et al. 1998 R_m where Kp = K, R_t where Kp = 0,
    doi:10.1109/TAES.2014.120563, doi:10.1109/7.705921.

    Args:
        r: range [m], 1 to 1e+08.
        u: direction cosine along the x axis; u^2 + v^2 < 1 [1], -0.6 to 0.6.
        v: direction cosine along the y axis; u^2 + v^2 < 1 [1], -0.6 to 0.6.
        sigma_r: standard deviation of the error of r [m], 0.001 to 10000.
        sigma_u: standard deviation of the error of u [1], 1e-09 to 0.1.
        sigma_v: standard deviation of the error of v [1], 1e-09 to 0.1.
        rho: correlation of the errors of u and v [1], -1 to 1.
        predicted_sigma_r: standard deviation of the prediction of r [m], 0.001 to 10000.
        predicted_sigma_u: standard deviation of the prediction of u [1], 1e-09 to 0.1.
        predicted_sigma_v: standard deviation of the prediction of v [1], 1e-09 to 0.1.
        predicted_rho: correlation of the predictions of u and v [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (3, 3), unit m^2.

    Accuracy: at most 123 ulp anywhere in this domain with independent errors, proved for elementary functions
    within 1 ulp (float64).
    """
    arguments = _floats(r, u, v, sigma_r, sigma_u, sigma_v, rho, predicted_sigma_r, predicted_sigma_u, predicted_sigma_v, predicted_rho)
    r, u, v, sigma_r, sigma_u, sigma_v, rho, predicted_sigma_r, predicted_sigma_u, predicted_sigma_v, predicted_rho = arguments
    u_squared = u**2
    v_squared = v**2
    root_1 = np.sqrt(1.0 - u_squared - v_squared)
    predicted_sigma_r_squared = predicted_sigma_r**2
    sigma_u_squared = sigma_u**2
    predicted_sigma_u_squared = predicted_sigma_u**2
    sigma_r_squared = sigma_r**2
    r_squared = r**2
    sum_1 = 1.0 - v_squared + 2.0 * u_squared
    sum_2 = u_squared - 1.0 + v_squared
    sum_3 = 1.0 + v
    sum_4 = v - 1.0
    sum_2_squared = sum_2**2
    sum_5 = 2.0 * u_squared - 3.0 + 3.0 * v_squared
    predicted_sigma_v_squared = predicted_sigma_v**2
    sum_6 = 1.0 + u
    sum_7 = u - 1.0
    product_1 = sum_2 * sum_2_squared
    sum_8 = u_squared - 1.0 - 2.0 * v_squared
    term_1 = 1.0 / (root_1 * (root_1**2)**2)
    sum_9 = (
        1.5 * predicted_sigma_u_squared * r_squared * sigma_u_squared * sum_3 * sum_4 * u
        - predicted_sigma_r_squared * sigma_u_squared * sum_2_squared * u
        - predicted_sigma_r_squared * rho * sigma_u * sigma_v * sum_2_squared * v
        - 0.5 * predicted_sigma_u_squared * r_squared * rho * sigma_u * sigma_v * sum_1 * v
        - 0.5 * predicted_sigma_u_squared * sigma_r_squared * sum_2 * sum_5 * u
        - 0.5 * predicted_sigma_v_squared * sigma_r_squared * sum_2 * sum_6 * sum_7 * u
        - product_1 * sigma_r_squared * u
        - predicted_rho * predicted_sigma_u * predicted_sigma_v * r_squared * sigma_u_squared * sum_1 * v
        - r_squared * sigma_u_squared * sum_2_squared * u
        - r_squared * rho * sigma_u * sigma_v * sum_2_squared * v
        - sigma_r_squared * sigma_u_squared * sum_2_squared * u
        - predicted_rho * predicted_sigma_u * predicted_sigma_v * sigma_r_squared * sum_2 * sum_3 * sum_4 * v
        - rho * sigma_r_squared * sigma_u * sigma_v * sum_2_squared * v
        + 1.5 * predicted_sigma_v_squared * r_squared * rho * sigma_u * sigma_v * sum_6 * sum_7 * v
        + 0.5 * predicted_sigma_v_squared * r_squared * sigma_u_squared * sum_8 * u
        + predicted_rho * predicted_sigma_u * predicted_sigma_v * r_squared * rho * sigma_u * sigma_v * sum_8 * u
    )
    sigma_v_squared = sigma_v**2
    sum_10 = 2.0 * v_squared - 3.0 + 3.0 * u_squared
    sum_11 = (
        1.5 * predicted_sigma_u_squared * r_squared * rho * sigma_u * sigma_v * sum_3 * sum_4 * u
        - predicted_sigma_r_squared * sigma_v_squared * sum_2_squared * v
        - predicted_sigma_r_squared * rho * sigma_u * sigma_v * sum_2_squared * u
        - 0.5 * predicted_sigma_u_squared * r_squared * sigma_v_squared * sum_1 * v
        - 0.5 * predicted_sigma_u_squared * sigma_r_squared * sum_2 * sum_3 * sum_4 * v
        - 0.5 * predicted_sigma_v_squared * sigma_r_squared * sum_10 * sum_2 * v
        - product_1 * sigma_r_squared * v
        - r_squared * sigma_v_squared * sum_2_squared * v
        - predicted_rho * predicted_sigma_u * predicted_sigma_v * r_squared * rho * sigma_u * sigma_v * sum_1 * v
        - r_squared * rho * sigma_u * sigma_v * sum_2_squared * u
        - sigma_r_squared * sigma_v_squared * sum_2_squared * v
        - predicted_rho * predicted_sigma_u * predicted_sigma_v * sigma_r_squared * sum_2 * sum_6 * sum_7 * u
        - rho * sigma_r_squared * sigma_u * sigma_v * sum_2_squared * u
        + 1.5 * predicted_sigma_v_squared * r_squared * sigma_v_squared * sum_6 * sum_7 * v
        + 0.5 * predicted_sigma_v_squared * r_squared * rho * sigma_u * sigma_v * sum_8 * u
        + predicted_rho * predicted_sigma_u * predicted_sigma_v * r_squared * sigma_v_squared * sum_8 * u
    )
    sum_12 = u_squared**2 - 1.0 - 6.0 * u_squared * v_squared + v_squared**2
    sum_13 = 3.0 * u_squared - 3.0 - v_squared
    sum_14 = 1.0 - v_squared + 3.0 * u_squared
    sum_15 = u_squared - 1.0 - 3.0 * v_squared
    sum_16 = 3.0 - 3.0 * v_squared + u_squared
    sum_17 = 1.0 - u_squared - v_squared + 2.0 * u_squared * v_squared
    sum_18 = (
        2.0 * predicted_sigma_r_squared * rho * sigma_u * sigma_v * sum_2_squared * u * v
        - 2.0 * predicted_sigma_v_squared * r_squared * rho * sigma_u * sigma_v * sum_13 * u * v
        - 2.0 * r_squared * rho * sigma_u * sigma_u_squared * sigma_v * sum_3 * sum_4 * u * v
        - 2.0 * r_squared * rho * sigma_u * sigma_v * sigma_v_squared * sum_6 * sum_7 * u * v
        - 2.0 * predicted_rho * predicted_sigma_u * predicted_sigma_v * r_squared * rho * sigma_u * sigma_v * sum_12
        - 4.0 * predicted_rho * predicted_sigma_u * predicted_sigma_v * r_squared * sigma_v_squared * u * (u_squared - 1.0 - v_squared) * v
        - predicted_sigma_u_squared * r_squared * sigma_u_squared * sum_14 * sum_3 * sum_4
        - predicted_sigma_v_squared * r_squared * sigma_u_squared * sum_15 * u_squared
        + 2.0 * predicted_sigma_u_squared * r_squared * rho * sigma_u * sigma_v * sum_16 * u * v
        + 2.0 * r_squared * rho * sigma_u * sigma_v * sum_2_squared * u * v
        + 2.0 * rho * sigma_r_squared * sigma_u * sigma_v * sum_2_squared * u * v
        + 4.0 * predicted_rho * predicted_sigma_u * predicted_sigma_v * r_squared * sigma_u_squared * u * (1.0 - v_squared + u_squared) * v
        + predicted_sigma_r_squared * sigma_u_squared * sum_2_squared * u_squared
        + predicted_sigma_r_squared * sigma_v_squared * sum_2_squared * v_squared
        + predicted_sigma_u_squared * product_1 * sigma_r_squared
        + predicted_sigma_u_squared * r_squared * sigma_v_squared * sum_14 * v_squared
        + predicted_sigma_v_squared * product_1 * sigma_r_squared
        + predicted_sigma_v_squared * r_squared * sigma_v_squared * sum_15 * sum_6 * sum_7
        + 0.5 * r_squared * sigma_u_squared**2 * sum_3**2 * sum_4**2
        + r_squared * rho**2 * sigma_u_squared * sigma_v_squared * sum_17
        + r_squared * sigma_u_squared * sigma_v_squared * u_squared * v_squared
        + r_squared * sigma_u_squared * sum_2_squared * u_squared
        + 0.5 * r_squared * sigma_v_squared**2 * sum_6**2 * sum_7**2
        + r_squared * sigma_v_squared * sum_2_squared * v_squared
        + sigma_r_squared * sigma_u_squared * sum_2_squared * u_squared
        + sigma_r_squared * sigma_v_squared * sum_2_squared * v_squared
        + sigma_r_squared * sum_2_squared**2
    )
    result = _empty(arguments, (3, 3))
    result[..., 0, 0] = (
        predicted_sigma_r_squared * sigma_u_squared
        + predicted_sigma_u_squared * sigma_r_squared
        + r_squared * sigma_u_squared
        + sigma_r_squared * sigma_u_squared
        + sigma_r_squared * u_squared
    )
    result[..., 0, 1] = (
        predicted_sigma_r_squared * rho * sigma_u * sigma_v
        + r_squared * rho * sigma_u * sigma_v
        + predicted_rho * predicted_sigma_u * predicted_sigma_v * sigma_r_squared
        + rho * sigma_r_squared * sigma_u * sigma_v
        + sigma_r_squared * u * v
    )
    result[..., 0, 2] = sum_9 * term_1
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = (
        predicted_sigma_r_squared * sigma_v_squared
        + predicted_sigma_v_squared * sigma_r_squared
        + r_squared * sigma_v_squared
        + sigma_r_squared * sigma_v_squared
        + sigma_r_squared * v_squared
    )
    result[..., 1, 2] = sum_11 * term_1
    result[..., 2, 0] = result[..., 0, 2]
    result[..., 2, 1] = result[..., 1, 2]
    result[..., 2, 2] = sum_18 / (root_1 * root_1**2)**2
    return result


def covariance_averaged_semidefinite(
    *,
    r: npt.ArrayLike,
    u: npt.ArrayLike,
    v: npt.ArrayLike,
    sigma_r: npt.ArrayLike,
    sigma_u: npt.ArrayLike,
    sigma_v: npt.ArrayLike,
    rho: npt.ArrayLike,
) -> Floats:
    """Covariance of the plain conversion, averaged over the truth, to fourth order, completed to a sum of squares.

    Name: ruv.covariance.averaged.semidefinite.
    Definition: e^L C to sigma^4 + dg K dg', g = 2 L h.
    Conditioning: measurement-conditioned: the measured symbols stand for the measurement.
    Source: Lerro & Bar-Shalom 1993; Prosov (11), doi:10.1109/7.220948.

    Args:
        r: range [m], 1 to 1e+08.
        u: direction cosine along the x axis; u^2 + v^2 < 1 [1], -0.6 to 0.6.
        v: direction cosine along the y axis; u^2 + v^2 < 1 [1], -0.6 to 0.6.
        sigma_r: standard deviation of the error of r [m], 0.001 to 10000.
        sigma_u: standard deviation of the error of u [1], 1e-09 to 0.1.
        sigma_v: standard deviation of the error of v [1], 1e-09 to 0.1.
        rho: correlation of the errors of u and v [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (3, 3), unit m^2.

    Accuracy: at most 369 ulp anywhere in this domain with independent errors, proved for elementary functions
    within 1 ulp (float64).
    """
    arguments = _floats(r, u, v, sigma_r, sigma_u, sigma_v, rho)
    r, u, v, sigma_r, sigma_u, sigma_v, rho = arguments
    u_squared = u**2
    v_squared = v**2
    root_1 = np.sqrt(1.0 - u_squared - v_squared)
    sigma_r_squared = sigma_r**2
    sigma_u_squared = sigma_u**2
    r_squared = r**2
    sum_1 = 1.0 - v_squared + 2.0 * u_squared
    product_1 = sigma_u * sigma_u_squared
    sum_2 = u_squared - 1.0 + v_squared
    sum_2_squared = sum_2**2
    sum_3 = 3.0 * v_squared - 3.0 + u_squared
    sum_4 = 3.0 * u_squared - 4.0 + 4.0 * v_squared
    sigma_v_squared = sigma_v**2
    sum_5 = 1.0 + u
    sum_6 = u - 1.0
    product_2 = sum_2 * sum_2_squared
    rho_squared = rho**2
    sum_7 = u_squared - 1.0 - 2.0 * v_squared
    product_3 = sigma_v * sigma_v_squared
    sigma_u_squared_squared = sigma_u_squared**2
    sum_8 = 1.0 + v
    sum_9 = v - 1.0
    term_1 = 1.0 / (root_1 * (root_1**2)**2)
    sum_10 = (
        2.0 * r_squared * rho_squared * sigma_u_squared * sigma_v_squared * sum_7 * u
        - 3.0 * product_1 * r_squared * rho * sigma_v * sum_1 * v
        - product_2 * sigma_r_squared * u
        - r_squared * sigma_u_squared * sum_2_squared * u
        - r_squared * rho * sigma_u * sigma_v * sum_2_squared * v
        - sigma_r_squared * sigma_u_squared * sum_2 * sum_4 * u
        - sigma_r_squared * sigma_v_squared * sum_2 * sum_5 * sum_6 * u
        - rho * sigma_r_squared * sigma_u * sigma_v * sum_2 * sum_3 * v
        + 3.0 * product_3 * r_squared * rho * sigma_u * sum_5 * sum_6 * v
        + 3.0 * r_squared * sigma_u_squared_squared * sum_8 * sum_9 * u
        + r_squared * sigma_u_squared * sigma_v_squared * sum_7 * u
    )
    sum_11 = 3.0 * u_squared - 3.0 + v_squared
    sum_12 = 3.0 * v_squared - 4.0 + 4.0 * u_squared
    sigma_v_squared_squared = sigma_v_squared**2
    sum_13 = (
        3.0 * product_1 * r_squared * rho * sigma_v * sum_8 * sum_9 * u
        - 2.0 * r_squared * rho_squared * sigma_u_squared * sigma_v_squared * sum_1 * v
        - product_2 * sigma_r_squared * v
        - r_squared * sigma_u_squared * sigma_v_squared * sum_1 * v
        - r_squared * sigma_v_squared * sum_2_squared * v
        - r_squared * rho * sigma_u * sigma_v * sum_2_squared * u
        - sigma_r_squared * sigma_u_squared * sum_2 * sum_8 * sum_9 * v
        - sigma_r_squared * sigma_v_squared * sum_12 * sum_2 * v
        - rho * sigma_r_squared * sigma_u * sigma_v * sum_11 * sum_2 * u
        + 3.0 * product_3 * r_squared * rho * sigma_u * sum_7 * u
        + 3.0 * r_squared * sigma_v_squared_squared * sum_5 * sum_6 * v
    )
    sum_14 = 1.0 - v_squared + 4.0 * u_squared
    u_squared_squared = u_squared**2
    v_squared_squared = v_squared**2
    sum_15 = (
        2.0 * u_squared
        - 7.0
        - 17.0 * u_squared * v_squared
        + 2.0 * v_squared
        + 5.0 * u_squared_squared
        + 5.0 * v_squared_squared
    )
    sum_16 = 3.0 * u_squared - 3.0 - 2.0 * v_squared
    sum_17 = (
        4.0 * u_squared_squared
        - 3.0
        - 22.0 * u_squared * v_squared
        - u_squared
        - v_squared
        + 4.0 * v_squared_squared
    )
    sum_18 = (
        2.0 * u_squared_squared
        - 11.0 * u_squared * v_squared
        - 2.0 * u_squared
        - 2.0 * v_squared
        + 2.0 * v_squared_squared
    )
    sum_2_squared_squared = sum_2_squared**2
    sum_19 = u_squared - 1.0 - 4.0 * v_squared
    product_4 = 11.0 * u_squared * v_squared
    u_squared_cubed = u_squared * u_squared**2
    sum_20 = (
        11.0 * u_squared * v_squared_squared
        - 14.0 * u_squared_squared * v_squared
        - 3.0 * v_squared_squared
        - 4.0 * u_squared_squared
        + 2.0 * u_squared
        + 2.0 * u_squared_cubed
        + 3.0 * v_squared
        + product_4
    )
    v_squared_cubed = v_squared * v_squared**2
    sum_21 = (
        11.0 * u_squared_squared * v_squared
        - 14.0 * u_squared * v_squared_squared
        - 3.0 * u_squared_squared
        - 4.0 * v_squared_squared
        + 2.0 * v_squared
        + 2.0 * v_squared_cubed
        + 3.0 * u_squared
        + product_4
    )
    sum_22 = 3.0 - 3.0 * v_squared + 2.0 * u_squared
    sum_8_squared = sum_8**2
    sum_9_squared = sum_9**2
    sum_5_squared = sum_5**2
    sum_6_squared = sum_6**2
    product_5 = 10.0 * u_squared * v_squared
    sum_23 = (
        10.0 * u_squared * v_squared_squared
        - 16.0 * u_squared_squared * v_squared
        - 2.0 * u_squared_squared
        - 6.0 * v_squared_squared
        + 6.0 * v_squared
        + product_5
        + u_squared
        + u_squared_cubed
    )
    sum_24 = (
        10.0 * u_squared_squared * v_squared
        - 16.0 * u_squared * v_squared_squared
        - 2.0 * v_squared_squared
        - 6.0 * u_squared_squared
        + 6.0 * u_squared
        + product_5
        + v_squared
        + v_squared_cubed
    )
    sum_25 = 2.0 * v_squared - 2.0 + 3.0 * u_squared
    sum_26 = 2.0 * u_squared - 2.0 + 3.0 * v_squared
    sum_27 = (
        18.0 * r_squared * rho * sigma_u * sigma_v * sigma_v_squared**2 * sum_5 * sum_6 * sum_7 * u * v
        - 18.0 * r_squared * rho * sigma_u * sigma_u_squared**2 * sigma_v * sum_1 * sum_8 * sum_9 * u * v
        - 1.5 * r_squared * sigma_u_squared_squared * sum_14 * sum_2_squared * sum_8 * sum_9
        - 4.0 * product_1 * product_3 * r_squared * rho * sum_15 * u * v
        - 4.0 * product_1 * rho * sigma_r_squared * sigma_v * sum_2_squared * sum_8 * sum_9 * u * v
        - 4.0 * product_3 * rho * sigma_r_squared * sigma_u * sum_2_squared * sum_5 * sum_6 * u * v
        - 6.0 * product_3 * r_squared * rho * sigma_u * sum_16 * sum_2_squared * u * v
        - 8.0 * product_1 * product_3 * r_squared * rho * rho_squared * sum_1 * sum_7 * u * v
        - r_squared * rho_squared * sigma_u_squared * sigma_v_squared * sum_17 * sum_2_squared
        - r_squared * sigma_u_squared * sigma_v_squared * sum_18 * sum_2_squared
        + 2.0 * r_squared * rho * sigma_u * sigma_v * sum_2_squared_squared * u * v
        + 2.0 * sigma_r_squared * sigma_u_squared * sigma_v_squared * sum_2_squared * sum_5 * sum_6 * sum_8 * sum_9
        + 2.0 * rho * sigma_r_squared * sigma_u * sigma_v * sum_2_squared_squared * u * v
        + 1.5 * r_squared * sigma_v_squared_squared * sum_19 * sum_2_squared * sum_5 * sum_6
        + 4.0 * r_squared * rho_squared * sigma_u_squared * sigma_v_squared_squared * sum_20
        + 4.0 * r_squared * rho_squared * sigma_u_squared_squared * sigma_v_squared * sum_21
        + 4.0 * rho_squared * sigma_r_squared * sigma_u_squared * sigma_v_squared * sum_2_squared * u_squared * v_squared
        + 6.0 * product_1 * r_squared * rho * sigma_v * sum_22 * sum_2_squared * u * v
        + 9.0 * r_squared * sigma_u_squared * sigma_u_squared**2 * sum_8_squared * sum_9_squared * u_squared
        + 9.0 * r_squared * sigma_v_squared * sigma_v_squared**2 * sum_5_squared * sum_6_squared * v_squared
        + r_squared * sigma_u_squared * sigma_v_squared_squared * sum_23
        + r_squared * sigma_u_squared * sum_2_squared_squared * u_squared
        + r_squared * sigma_u_squared_squared * sigma_v_squared * sum_24
        + r_squared * sigma_v_squared * sum_2_squared_squared * v_squared
        + sigma_r_squared * sigma_u_squared * sum_25 * sum_2_squared_squared
        + sigma_r_squared * sigma_u_squared_squared * sum_2_squared * sum_8_squared * sum_9_squared
        + sigma_r_squared * sigma_v_squared * sum_26 * sum_2_squared_squared
        + sigma_r_squared * sigma_v_squared_squared * sum_2_squared * sum_5_squared * sum_6_squared
        + sigma_r_squared * sum_2_squared * sum_2_squared**2
    )
    result = _empty(arguments, (3, 3))
    result[..., 0, 0] = (
        3.0 * sigma_r_squared * sigma_u_squared
        + r_squared * sigma_u_squared
        + sigma_r_squared * u_squared
    )
    result[..., 0, 1] = (
        3.0 * rho * sigma_r_squared * sigma_u * sigma_v
        + r_squared * rho * sigma_u * sigma_v
        + sigma_r_squared * u * v
    )
    result[..., 0, 2] = sum_10 * term_1
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = (
        3.0 * sigma_r_squared * sigma_v_squared
        + r_squared * sigma_v_squared
        + sigma_r_squared * v_squared
    )
    result[..., 1, 2] = sum_13 * term_1
    result[..., 2, 0] = result[..., 0, 2]
    result[..., 2, 1] = result[..., 1, 2]
    result[..., 2, 2] = sum_27 / (root_1 * (root_1**2)**2)**2
    return result


def unbiased_covariance_semidefinite(
    *,
    r: npt.ArrayLike,
    u: npt.ArrayLike,
    v: npt.ArrayLike,
    sigma_r: npt.ArrayLike,
    sigma_u: npt.ArrayLike,
    sigma_v: npt.ArrayLike,
    rho: npt.ArrayLike,
) -> Floats:
    """Error covariance of the unbiased estimate u, to fourth order, completed to a sum of squares.

    Name: ruv.unbiased.covariance.semidefinite.
    Definition: u u' - u (e^L h)' - (e^L h) u' + e^L(h h') to sigma^4 + dg K dg', g = L h.
    Conditioning: measurement-conditioned: the measured symbols stand for the measurement.
    Source: Mo et al. 1998, doi:10.1109/7.705921.

    Args:
        r: range [m], 1 to 1e+08.
        u: direction cosine along the x axis; u^2 + v^2 < 1 [1], -0.6 to 0.6.
        v: direction cosine along the y axis; u^2 + v^2 < 1 [1], -0.6 to 0.6.
        sigma_r: standard deviation of the error of r [m], 0.001 to 10000.
        sigma_u: standard deviation of the error of u [1], 1e-09 to 0.1.
        sigma_v: standard deviation of the error of v [1], 1e-09 to 0.1.
        rho: correlation of the errors of u and v [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (3, 3), unit m^2.

    Accuracy: at most 200 ulp anywhere in this domain with independent errors, proved for elementary functions
    within 1 ulp (float64).
    """
    arguments = _floats(r, u, v, sigma_r, sigma_u, sigma_v, rho)
    r, u, v, sigma_r, sigma_u, sigma_v, rho = arguments
    u_squared = u**2
    v_squared = v**2
    root_1 = np.sqrt(1.0 - u_squared - v_squared)
    r_squared = r**2
    sigma_u_squared = sigma_u**2
    sigma_r_squared = sigma_r**2
    sum_1 = 1.0 - v_squared + 2.0 * u_squared
    product_1 = sigma_u * sigma_u_squared
    sum_2 = u_squared - 1.0 + v_squared
    sum_2_squared = sum_2**2
    sum_3 = 1.0 + v
    sum_4 = v - 1.0
    sum_5 = 2.0 * u_squared - 3.0 + 3.0 * v_squared
    sigma_v_squared = sigma_v**2
    sum_6 = 1.0 + u
    sum_7 = u - 1.0
    product_2 = sum_2 * sum_2_squared
    product_3 = sigma_v * sigma_v_squared
    sigma_u_squared_squared = sigma_u_squared**2
    rho_squared = rho**2
    sum_8 = u_squared - 1.0 - 2.0 * v_squared
    term_1 = 1.0 / (root_1 * (root_1**2)**2)
    sum_9 = (
        1.5 * product_3 * r_squared * rho * sigma_u * sum_6 * sum_7 * v
        - 1.5 * product_1 * r_squared * rho * sigma_v * sum_1 * v
        - product_2 * sigma_r_squared * u
        - r_squared * sigma_u_squared * sum_2_squared * u
        - r_squared * rho * sigma_u * sigma_v * sum_2_squared * v
        - 0.5 * sigma_r_squared * sigma_u_squared * sum_2 * sum_5 * u
        - 0.5 * sigma_r_squared * sigma_v_squared * sum_2 * sum_6 * sum_7 * u
        - rho * sigma_r_squared * sigma_u * sigma_v * sum_2 * sum_3 * sum_4 * v
        + 1.5 * r_squared * sigma_u_squared_squared * sum_3 * sum_4 * u
        + r_squared * rho_squared * sigma_u_squared * sigma_v_squared * sum_8 * u
        + 0.5 * r_squared * sigma_u_squared * sigma_v_squared * sum_8 * u
    )
    sum_10 = 2.0 * v_squared - 3.0 + 3.0 * u_squared
    sigma_v_squared_squared = sigma_v_squared**2
    sum_11 = (
        1.5 * product_1 * r_squared * rho * sigma_v * sum_3 * sum_4 * u
        - product_2 * sigma_r_squared * v
        - r_squared * rho_squared * sigma_u_squared * sigma_v_squared * sum_1 * v
        - 0.5 * r_squared * sigma_u_squared * sigma_v_squared * sum_1 * v
        - r_squared * sigma_v_squared * sum_2_squared * v
        - r_squared * rho * sigma_u * sigma_v * sum_2_squared * u
        - 0.5 * sigma_r_squared * sigma_u_squared * sum_2 * sum_3 * sum_4 * v
        - 0.5 * sigma_r_squared * sigma_v_squared * sum_10 * sum_2 * v
        - rho * sigma_r_squared * sigma_u * sigma_v * sum_2 * sum_6 * sum_7 * u
        + 1.5 * product_3 * r_squared * rho * sigma_u * sum_8 * u
        + 1.5 * r_squared * sigma_v_squared_squared * sum_6 * sum_7 * v
    )
    sum_12 = 2.0 * u_squared - 2.0 - v_squared
    u_squared_squared = u_squared**2
    v_squared_squared = v_squared**2
    sum_13 = (
        2.0 * u_squared_squared
        - 1.0
        - 14.0 * u_squared * v_squared
        - u_squared
        - v_squared
        + 2.0 * v_squared_squared
    )
    sum_14 = (
        2.0 * u_squared
        - 7.0
        - 17.0 * u_squared * v_squared
        + 2.0 * v_squared
        + 5.0 * u_squared_squared
        + 5.0 * v_squared_squared
    )
    sum_15 = u_squared - 2.0 - 7.0 * u_squared * v_squared + u_squared_squared + v_squared + v_squared_squared
    sum_2_squared_squared = sum_2_squared**2
    sum_16 = 2.0 - 2.0 * v_squared + u_squared
    sum_3_squared = sum_3**2
    sum_4_squared = sum_4**2
    sum_6_squared = sum_6**2
    sum_7_squared = sum_7**2
    product_4 = 11.0 * u_squared * v_squared
    u_squared_cubed = u_squared * u_squared**2
    sum_17 = (
        11.0 * u_squared * v_squared_squared
        - 14.0 * u_squared_squared * v_squared
        - 3.0 * v_squared_squared
        - 4.0 * u_squared_squared
        + 2.0 * u_squared
        + 2.0 * u_squared_cubed
        + 3.0 * v_squared
        + product_4
    )
    v_squared_cubed = v_squared * v_squared**2
    sum_18 = (
        11.0 * u_squared_squared * v_squared
        - 14.0 * u_squared * v_squared_squared
        - 3.0 * u_squared_squared
        - 4.0 * v_squared_squared
        + 2.0 * v_squared
        + 2.0 * v_squared_cubed
        + 3.0 * u_squared
        + product_4
    )
    product_5 = 10.0 * u_squared * v_squared
    sum_19 = (
        10.0 * u_squared * v_squared_squared
        - 16.0 * u_squared_squared * v_squared
        - 2.0 * u_squared_squared
        - 6.0 * v_squared_squared
        + 6.0 * v_squared
        + product_5
        + u_squared
        + u_squared_cubed
    )
    sum_20 = (
        10.0 * u_squared_squared * v_squared
        - 16.0 * u_squared * v_squared_squared
        - 2.0 * v_squared_squared
        - 6.0 * u_squared_squared
        + 6.0 * u_squared
        + product_5
        + v_squared
        + v_squared_cubed
    )
    product_6 = sum_2 * sum_2_squared**2
    sum_21 = (
        2.0 * r_squared * rho * sigma_u * sigma_v * sum_2_squared_squared * u * v
        - 2.0 * product_1 * product_3 * r_squared * rho * rho_squared * sum_1 * sum_8 * u * v
        - 1.5 * r_squared * sigma_u_squared_squared * sum_1 * sum_2_squared * sum_3 * sum_4
        - 6.0 * product_3 * r_squared * rho * sigma_u * sum_12 * sum_2_squared * u * v
        - 4.5 * r_squared * rho * sigma_u * sigma_u_squared**2 * sigma_v * sum_1 * sum_3 * sum_4 * u * v
        - product_1 * product_3 * r_squared * rho * sum_14 * u * v
        - product_1 * rho * sigma_r_squared * sigma_v * sum_2_squared * sum_3 * sum_4 * u * v
        - product_3 * rho * sigma_r_squared * sigma_u * sum_2_squared * sum_6 * sum_7 * u * v
        - r_squared * rho_squared * sigma_u_squared * sigma_v_squared * sum_13 * sum_2_squared
        - r_squared * sigma_u_squared * sigma_v_squared * sum_15 * sum_2_squared
        + 1.5 * r_squared * sigma_v_squared_squared * sum_2_squared * sum_6 * sum_7 * sum_8
        + 6.0 * product_1 * r_squared * rho * sigma_v * sum_16 * sum_2_squared * u * v
        + 2.25 * r_squared * sigma_u_squared * sigma_u_squared**2 * sum_3_squared * sum_4_squared * u_squared
        + 4.5 * r_squared * rho * sigma_u * sigma_v * sigma_v_squared**2 * sum_6 * sum_7 * sum_8 * u * v
        + 2.25 * r_squared * sigma_v_squared * sigma_v_squared**2 * sum_6_squared * sum_7_squared * v_squared
        + product_6 * sigma_r_squared * sigma_u_squared
        + product_6 * sigma_r_squared * sigma_v_squared
        + r_squared * rho_squared * sigma_u_squared * sigma_v_squared_squared * sum_17
        + r_squared * rho_squared * sigma_u_squared_squared * sigma_v_squared * sum_18
        + 0.25 * r_squared * sigma_u_squared * sigma_v_squared_squared * sum_19
        + r_squared * sigma_u_squared * sum_2_squared_squared * u_squared
        + 0.25 * r_squared * sigma_u_squared_squared * sigma_v_squared * sum_20
        + r_squared * sigma_v_squared * sum_2_squared_squared * v_squared
        + rho_squared * sigma_r_squared * sigma_u_squared * sigma_v_squared * sum_2_squared * u_squared * v_squared
        + 0.5 * sigma_r_squared * sigma_u_squared * sigma_v_squared * sum_2_squared * sum_3 * sum_4 * sum_6 * sum_7
        + 0.25 * sigma_r_squared * sigma_u_squared_squared * sum_2_squared * sum_3_squared * sum_4_squared
        + 0.25 * sigma_r_squared * sigma_v_squared_squared * sum_2_squared * sum_6_squared * sum_7_squared
        + sigma_r_squared * sum_2_squared * sum_2_squared**2
    )
    result = _empty(arguments, (3, 3))
    result[..., 0, 0] = (
        r_squared * sigma_u_squared
        + sigma_r_squared * sigma_u_squared
        + sigma_r_squared * u_squared
    )
    result[..., 0, 1] = (
        r_squared * rho * sigma_u * sigma_v
        + rho * sigma_r_squared * sigma_u * sigma_v
        + sigma_r_squared * u * v
    )
    result[..., 0, 2] = sum_9 * term_1
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = (
        r_squared * sigma_v_squared
        + sigma_r_squared * sigma_v_squared
        + sigma_r_squared * v_squared
    )
    result[..., 1, 2] = sum_11 * term_1
    result[..., 2, 0] = result[..., 0, 2]
    result[..., 2, 1] = result[..., 1, 2]
    result[..., 2, 2] = sum_21 / (root_1 * (root_1**2)**2)**2
    return result


def posterior_covariance_semidefinite(
    *,
    r: npt.ArrayLike,
    u: npt.ArrayLike,
    v: npt.ArrayLike,
    sigma_r: npt.ArrayLike,
    sigma_u: npt.ArrayLike,
    sigma_v: npt.ArrayLike,
    rho: npt.ArrayLike,
) -> Floats:
    """Posterior covariance of the position under a flat prior, to fourth order, completed to a sum of squares.

    Name: ruv.posterior.covariance.semidefinite.
    Definition: e^L(h h') - (e^L h)(e^L h)' to sigma^4 + dg K dg', g = L h.
    Conditioning: measurement-conditioned: the measured symbols stand for the measurement.
    Source: Duan et al. 2004 modified unbiased, doi:10.1109/TAES.2004.1386889.

    Args:
        r: range [m], 1 to 1e+08.
        u: direction cosine along the x axis; u^2 + v^2 < 1 [1], -0.6 to 0.6.
        v: direction cosine along the y axis; u^2 + v^2 < 1 [1], -0.6 to 0.6.
        sigma_r: standard deviation of the error of r [m], 0.001 to 10000.
        sigma_u: standard deviation of the error of u [1], 1e-09 to 0.1.
        sigma_v: standard deviation of the error of v [1], 1e-09 to 0.1.
        rho: correlation of the errors of u and v [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (3, 3), unit m^2.

    Accuracy: at most 170 ulp anywhere in this domain with independent errors, proved for elementary functions
    within 1 ulp (float64).
    """
    arguments = _floats(r, u, v, sigma_r, sigma_u, sigma_v, rho)
    r, u, v, sigma_r, sigma_u, sigma_v, rho = arguments
    u_squared = u**2
    v_squared = v**2
    root_1 = np.sqrt(1.0 - u_squared - v_squared)
    r_squared = r**2
    sigma_u_squared = sigma_u**2
    sigma_r_squared = sigma_r**2
    sum_1 = 1.0 - v_squared + 2.0 * u_squared
    product_1 = sigma_u * sigma_u_squared
    sum_2 = u_squared - 1.0 + v_squared
    sum_2_squared = sum_2**2
    sum_3 = 1.0 + v
    sum_4 = v - 1.0
    sum_5 = 2.0 * u_squared - 3.0 + 3.0 * v_squared
    sigma_v_squared = sigma_v**2
    sum_6 = 1.0 + u
    sum_7 = u - 1.0
    product_2 = sum_2 * sum_2_squared
    product_3 = sigma_v * sigma_v_squared
    sigma_u_squared_squared = sigma_u_squared**2
    rho_squared = rho**2
    sum_8 = u_squared - 1.0 - 2.0 * v_squared
    term_1 = 1.0 / (root_1 * (root_1**2)**2)
    sum_9 = (
        1.5 * product_3 * r_squared * rho * sigma_u * sum_6 * sum_7 * v
        - 1.5 * product_1 * r_squared * rho * sigma_v * sum_1 * v
        - product_2 * sigma_r_squared * u
        - r_squared * sigma_u_squared * sum_2_squared * u
        - r_squared * rho * sigma_u * sigma_v * sum_2_squared * v
        - 0.5 * sigma_r_squared * sigma_u_squared * sum_2 * sum_5 * u
        - 0.5 * sigma_r_squared * sigma_v_squared * sum_2 * sum_6 * sum_7 * u
        - rho * sigma_r_squared * sigma_u * sigma_v * sum_2 * sum_3 * sum_4 * v
        + 1.5 * r_squared * sigma_u_squared_squared * sum_3 * sum_4 * u
        + r_squared * rho_squared * sigma_u_squared * sigma_v_squared * sum_8 * u
        + 0.5 * r_squared * sigma_u_squared * sigma_v_squared * sum_8 * u
    )
    sum_10 = 2.0 * v_squared - 3.0 + 3.0 * u_squared
    sigma_v_squared_squared = sigma_v_squared**2
    sum_11 = (
        1.5 * product_1 * r_squared * rho * sigma_v * sum_3 * sum_4 * u
        - product_2 * sigma_r_squared * v
        - r_squared * rho_squared * sigma_u_squared * sigma_v_squared * sum_1 * v
        - 0.5 * r_squared * sigma_u_squared * sigma_v_squared * sum_1 * v
        - r_squared * sigma_v_squared * sum_2_squared * v
        - r_squared * rho * sigma_u * sigma_v * sum_2_squared * u
        - 0.5 * sigma_r_squared * sigma_u_squared * sum_2 * sum_3 * sum_4 * v
        - 0.5 * sigma_r_squared * sigma_v_squared * sum_10 * sum_2 * v
        - rho * sigma_r_squared * sigma_u * sigma_v * sum_2 * sum_6 * sum_7 * u
        + 1.5 * product_3 * r_squared * rho * sigma_u * sum_8 * u
        + 1.5 * r_squared * sigma_v_squared_squared * sum_6 * sum_7 * v
    )
    sum_12 = 4.0 * u_squared - 4.0 - 3.0 * v_squared
    u_squared_squared = u_squared**2
    v_squared_squared = v_squared**2
    sum_13 = (
        2.0 * u_squared_squared
        - 1.0
        - 10.0 * u_squared * v_squared
        - u_squared
        - v_squared
        + 2.0 * v_squared_squared
    )
    sum_14 = (
        2.0 * u_squared
        - 7.0
        - 17.0 * u_squared * v_squared
        + 2.0 * v_squared
        + 5.0 * u_squared_squared
        + 5.0 * v_squared_squared
    )
    sum_15 = u_squared_squared - 5.0 * u_squared * v_squared - u_squared - v_squared + v_squared_squared
    sum_16 = 1.0 - v_squared + 6.0 * u_squared
    sum_17 = 4.0 - 4.0 * v_squared + 3.0 * u_squared
    sum_2_squared_squared = sum_2_squared**2
    sum_3_squared = sum_3**2
    sum_4_squared = sum_4**2
    sum_6_squared = sum_6**2
    sum_7_squared = sum_7**2
    product_4 = 11.0 * u_squared * v_squared
    u_squared_cubed = u_squared * u_squared**2
    sum_18 = (
        11.0 * u_squared * v_squared_squared
        - 14.0 * u_squared_squared * v_squared
        - 3.0 * v_squared_squared
        - 4.0 * u_squared_squared
        + 2.0 * u_squared
        + 2.0 * u_squared_cubed
        + 3.0 * v_squared
        + product_4
    )
    v_squared_cubed = v_squared * v_squared**2
    sum_19 = (
        11.0 * u_squared_squared * v_squared
        - 14.0 * u_squared * v_squared_squared
        - 3.0 * u_squared_squared
        - 4.0 * v_squared_squared
        + 2.0 * v_squared
        + 2.0 * v_squared_cubed
        + 3.0 * u_squared
        + product_4
    )
    product_5 = 10.0 * u_squared * v_squared
    sum_20 = (
        10.0 * u_squared * v_squared_squared
        - 16.0 * u_squared_squared * v_squared
        - 2.0 * u_squared_squared
        - 6.0 * v_squared_squared
        + 6.0 * v_squared
        + product_5
        + u_squared
        + u_squared_cubed
    )
    sum_21 = (
        10.0 * u_squared_squared * v_squared
        - 16.0 * u_squared * v_squared_squared
        - 2.0 * v_squared_squared
        - 6.0 * u_squared_squared
        + 6.0 * u_squared
        + product_5
        + v_squared
        + v_squared_cubed
    )
    sum_22 = u_squared - 1.0 - 6.0 * v_squared
    product_6 = sum_2 * sum_2_squared**2
    sum_23 = (
        2.0 * product_1 * r_squared * rho * sigma_v * sum_17 * sum_2_squared * u * v
        - 2.0 * product_1 * product_3 * r_squared * rho * rho_squared * sum_1 * sum_8 * u * v
        - 2.0 * product_3 * r_squared * rho * sigma_u * sum_12 * sum_2_squared * u * v
        - 4.5 * r_squared * rho * sigma_u * sigma_u_squared**2 * sigma_v * sum_1 * sum_3 * sum_4 * u * v
        - product_1 * product_3 * r_squared * rho * sum_14 * u * v
        - product_1 * rho * sigma_r_squared * sigma_v * sum_2_squared * sum_3 * sum_4 * u * v
        - product_3 * rho * sigma_r_squared * sigma_u * sum_2_squared * sum_6 * sum_7 * u * v
        - r_squared * rho_squared * sigma_u_squared * sigma_v_squared * sum_13 * sum_2_squared
        - r_squared * sigma_u_squared * sigma_v_squared * sum_15 * sum_2_squared
        - 0.5 * r_squared * sigma_u_squared_squared * sum_16 * sum_2_squared * sum_3 * sum_4
        + 2.0 * r_squared * rho * sigma_u * sigma_v * sum_2_squared_squared * u * v
        + 2.25 * r_squared * sigma_u_squared * sigma_u_squared**2 * sum_3_squared * sum_4_squared * u_squared
        + 4.5 * r_squared * rho * sigma_u * sigma_v * sigma_v_squared**2 * sum_6 * sum_7 * sum_8 * u * v
        + 2.25 * r_squared * sigma_v_squared * sigma_v_squared**2 * sum_6_squared * sum_7_squared * v_squared
        + product_6 * sigma_r_squared * sigma_u_squared
        + product_6 * sigma_r_squared * sigma_v_squared
        + r_squared * rho_squared * sigma_u_squared * sigma_v_squared_squared * sum_18
        + r_squared * rho_squared * sigma_u_squared_squared * sigma_v_squared * sum_19
        + 0.25 * r_squared * sigma_u_squared * sigma_v_squared_squared * sum_20
        + r_squared * sigma_u_squared * sum_2_squared_squared * u_squared
        + 0.25 * r_squared * sigma_u_squared_squared * sigma_v_squared * sum_21
        + r_squared * sigma_v_squared * sum_2_squared_squared * v_squared
        + 0.5 * r_squared * sigma_v_squared_squared * sum_22 * sum_2_squared * sum_6 * sum_7
        + rho_squared * sigma_r_squared * sigma_u_squared * sigma_v_squared * sum_2_squared * u_squared * v_squared
        + 0.5 * sigma_r_squared * sigma_u_squared * sigma_v_squared * sum_2_squared * sum_3 * sum_4 * sum_6 * sum_7
        + 0.25 * sigma_r_squared * sigma_u_squared_squared * sum_2_squared * sum_3_squared * sum_4_squared
        + 0.25 * sigma_r_squared * sigma_v_squared_squared * sum_2_squared * sum_6_squared * sum_7_squared
        + sigma_r_squared * sum_2_squared * sum_2_squared**2
    )
    result = _empty(arguments, (3, 3))
    result[..., 0, 0] = (
        r_squared * sigma_u_squared
        + sigma_r_squared * sigma_u_squared
        + sigma_r_squared * u_squared
    )
    result[..., 0, 1] = (
        r_squared * rho * sigma_u * sigma_v
        + rho * sigma_r_squared * sigma_u * sigma_v
        + sigma_r_squared * u * v
    )
    result[..., 0, 2] = sum_9 * term_1
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = (
        r_squared * sigma_v_squared
        + sigma_r_squared * sigma_v_squared
        + sigma_r_squared * v_squared
    )
    result[..., 1, 2] = sum_11 * term_1
    result[..., 2, 0] = result[..., 0, 2]
    result[..., 2, 1] = result[..., 1, 2]
    result[..., 2, 2] = sum_23 / (root_1 * (root_1**2)**2)**2
    return result


def decorrelated_covariance_semidefinite(
    *,
    r: npt.ArrayLike,
    u: npt.ArrayLike,
    v: npt.ArrayLike,
    sigma_r: npt.ArrayLike,
    sigma_u: npt.ArrayLike,
    sigma_v: npt.ArrayLike,
    rho: npt.ArrayLike,
    predicted_sigma_r: npt.ArrayLike,
    predicted_sigma_u: npt.ArrayLike,
    predicted_sigma_v: npt.ArrayLike,
    predicted_rho: npt.ArrayLike,
) -> Floats:
    """Covariance of the unbiased estimate u, averaged over a prediction, to fourth order, completed to a sum of squares.

    Name: ruv.decorrelated.covariance.semidefinite.
    Definition: e^Lp [e^L(u u') - h h'] to sigma^4 + dg K dg', g = Lp h.
    Conditioning: averaged over a prediction: the measured symbols stand for the predicted mean.
    Source: Bordonaro et al. 2014 decorrelated; Mo et al. 1998 R_m where Kp = K, R_t where Kp = 0,
    doi:10.1109/TAES.2014.120563, doi:10.1109/7.705921.

    Args:
        r: range [m], 1 to 1e+08.
        u: direction cosine along the x axis; u^2 + v^2 < 1 [1], -0.6 to 0.6.
        v: direction cosine along the y axis; u^2 + v^2 < 1 [1], -0.6 to 0.6.
        sigma_r: standard deviation of the error of r [m], 0.001 to 10000.
        sigma_u: standard deviation of the error of u [1], 1e-09 to 0.1.
        sigma_v: standard deviation of the error of v [1], 1e-09 to 0.1.
        rho: correlation of the errors of u and v [1], -1 to 1.
        predicted_sigma_r: standard deviation of the prediction of r [m], 0.001 to 10000.
        predicted_sigma_u: standard deviation of the prediction of u [1], 1e-09 to 0.1.
        predicted_sigma_v: standard deviation of the prediction of v [1], 1e-09 to 0.1.
        predicted_rho: correlation of the predictions of u and v [1], -1 to 1.

    Returns:
        Shape of the broadcast arguments + (3, 3), unit m^2.

    Accuracy: at most 235 ulp anywhere in this domain with independent errors, proved for elementary functions
    within 1 ulp (float64).
    """
    arguments = _floats(r, u, v, sigma_r, sigma_u, sigma_v, rho, predicted_sigma_r, predicted_sigma_u, predicted_sigma_v, predicted_rho)
    r, u, v, sigma_r, sigma_u, sigma_v, rho, predicted_sigma_r, predicted_sigma_u, predicted_sigma_v, predicted_rho = arguments
    u_squared = u**2
    v_squared = v**2
    root_1 = np.sqrt(1.0 - u_squared - v_squared)
    predicted_sigma_r_squared = predicted_sigma_r**2
    sigma_u_squared = sigma_u**2
    predicted_sigma_u_squared = predicted_sigma_u**2
    sigma_r_squared = sigma_r**2
    r_squared = r**2
    sum_1 = 1.0 - v_squared + 2.0 * u_squared
    sum_2 = u_squared - 1.0 + v_squared
    sum_3 = 1.0 + v
    sum_4 = v - 1.0
    sum_2_squared = sum_2**2
    sum_5 = 2.0 * u_squared - 3.0 + 3.0 * v_squared
    predicted_sigma_v_squared = predicted_sigma_v**2
    sum_6 = 1.0 + u
    sum_7 = u - 1.0
    product_1 = sum_2 * sum_2_squared
    sum_8 = u_squared - 1.0 - 2.0 * v_squared
    term_1 = 1.0 / (root_1 * (root_1**2)**2)
    sum_9 = (
        1.5 * predicted_sigma_u_squared * r_squared * sigma_u_squared * sum_3 * sum_4 * u
        - predicted_sigma_r_squared * sigma_u_squared * sum_2_squared * u
        - predicted_sigma_r_squared * rho * sigma_u * sigma_v * sum_2_squared * v
        - 0.5 * predicted_sigma_u_squared * r_squared * rho * sigma_u * sigma_v * sum_1 * v
        - 0.5 * predicted_sigma_u_squared * sigma_r_squared * sum_2 * sum_5 * u
        - 0.5 * predicted_sigma_v_squared * sigma_r_squared * sum_2 * sum_6 * sum_7 * u
        - product_1 * sigma_r_squared * u
        - predicted_rho * predicted_sigma_u * predicted_sigma_v * r_squared * sigma_u_squared * sum_1 * v
        - r_squared * sigma_u_squared * sum_2_squared * u
        - r_squared * rho * sigma_u * sigma_v * sum_2_squared * v
        - sigma_r_squared * sigma_u_squared * sum_2_squared * u
        - predicted_rho * predicted_sigma_u * predicted_sigma_v * sigma_r_squared * sum_2 * sum_3 * sum_4 * v
        - rho * sigma_r_squared * sigma_u * sigma_v * sum_2_squared * v
        + 1.5 * predicted_sigma_v_squared * r_squared * rho * sigma_u * sigma_v * sum_6 * sum_7 * v
        + 0.5 * predicted_sigma_v_squared * r_squared * sigma_u_squared * sum_8 * u
        + predicted_rho * predicted_sigma_u * predicted_sigma_v * r_squared * rho * sigma_u * sigma_v * sum_8 * u
    )
    sigma_v_squared = sigma_v**2
    sum_10 = 2.0 * v_squared - 3.0 + 3.0 * u_squared
    sum_11 = (
        1.5 * predicted_sigma_u_squared * r_squared * rho * sigma_u * sigma_v * sum_3 * sum_4 * u
        - predicted_sigma_r_squared * sigma_v_squared * sum_2_squared * v
        - predicted_sigma_r_squared * rho * sigma_u * sigma_v * sum_2_squared * u
        - 0.5 * predicted_sigma_u_squared * r_squared * sigma_v_squared * sum_1 * v
        - 0.5 * predicted_sigma_u_squared * sigma_r_squared * sum_2 * sum_3 * sum_4 * v
        - 0.5 * predicted_sigma_v_squared * sigma_r_squared * sum_10 * sum_2 * v
        - product_1 * sigma_r_squared * v
        - r_squared * sigma_v_squared * sum_2_squared * v
        - predicted_rho * predicted_sigma_u * predicted_sigma_v * r_squared * rho * sigma_u * sigma_v * sum_1 * v
        - r_squared * rho * sigma_u * sigma_v * sum_2_squared * u
        - sigma_r_squared * sigma_v_squared * sum_2_squared * v
        - predicted_rho * predicted_sigma_u * predicted_sigma_v * sigma_r_squared * sum_2 * sum_6 * sum_7 * u
        - rho * sigma_r_squared * sigma_u * sigma_v * sum_2_squared * u
        + 1.5 * predicted_sigma_v_squared * r_squared * sigma_v_squared * sum_6 * sum_7 * v
        + 0.5 * predicted_sigma_v_squared * r_squared * rho * sigma_u * sigma_v * sum_8 * u
        + predicted_rho * predicted_sigma_u * predicted_sigma_v * r_squared * sigma_v_squared * sum_8 * u
    )
    predicted_rho_squared = predicted_rho**2
    u_squared_squared = u_squared**2
    v_squared_squared = v_squared**2
    sum_12 = u_squared_squared - 1.0 - 6.0 * u_squared * v_squared + v_squared_squared
    sum_13 = 3.0 * u_squared - 3.0 - v_squared
    product_2 = predicted_sigma_u * predicted_sigma_u_squared
    predicted_sigma_u_squared_squared = predicted_sigma_u_squared**2
    product_3 = predicted_sigma_v * predicted_sigma_v_squared
    sum_14 = (
        4.0 * u_squared
        - 5.0
        - 7.0 * u_squared * v_squared
        + 4.0 * v_squared
        + u_squared_squared
        + v_squared_squared
    )
    sum_15 = 1.0 - v_squared + 3.0 * u_squared
    sum_16 = u_squared - 1.0 - 3.0 * v_squared
    sum_2_squared_squared = sum_2_squared**2
    sum_17 = 3.0 - 3.0 * v_squared + u_squared
    predicted_sigma_v_squared_squared = predicted_sigma_v_squared**2
    sum_3_squared = sum_3**2
    sum_4_squared = sum_4**2
    sum_6_squared = sum_6**2
    sum_7_squared = sum_7**2
    sum_1_squared = sum_1**2
    sum_8_squared = sum_8**2
    product_4 = 7.0 * u_squared * v_squared
    sum_18 = (
        3.0 * u_squared
        - 10.0 * u_squared * v_squared_squared
        - 2.0 * v_squared_squared
        - 3.0 * u_squared_squared
        + 7.0 * u_squared_squared * v_squared
        + product_4
        + v_squared
        + v_squared * v_squared**2
    )
    sum_19 = (
        3.0 * v_squared
        - 10.0 * u_squared_squared * v_squared
        - 2.0 * u_squared_squared
        - 3.0 * v_squared_squared
        + 7.0 * u_squared * v_squared_squared
        + product_4
        + u_squared
        + u_squared * u_squared**2
    )
    product_5 = sum_2 * sum_2_squared**2
    sum_20 = 1.0 - u_squared - v_squared + 2.0 * u_squared * v_squared
    sum_21 = (
        2.0 * predicted_sigma_r_squared * rho * sigma_u * sigma_v * sum_2_squared_squared * u * v
        - 2.0 * predicted_rho_squared * predicted_sigma_u_squared * predicted_sigma_v_squared * r_squared * rho * sigma_u * sigma_v * sum_1 * sum_8 * u * v
        - 2.0 * predicted_sigma_v_squared * r_squared * rho * sigma_u * sigma_v * sum_13 * sum_2_squared * u * v
        - 2.0 * r_squared * rho * sigma_u * sigma_u_squared * sigma_v * sum_2_squared * sum_3 * sum_4 * u * v
        - 2.0 * r_squared * rho * sigma_u * sigma_v * sigma_v_squared * sum_2_squared * sum_6 * sum_7 * u * v
        - 2.0 * predicted_rho * predicted_sigma_u * predicted_sigma_v * r_squared * rho * sigma_u * sigma_v * sum_12 * sum_2_squared
        - 1.5 * predicted_sigma_u_squared * predicted_sigma_v_squared * r_squared * sigma_v_squared * sum_1 * sum_6 * sum_7 * v_squared
        - 1.5 * predicted_sigma_u_squared_squared * r_squared * rho * sigma_u * sigma_v * sum_1 * sum_3 * sum_4 * u * v
        - 3.0 * predicted_rho * predicted_sigma_v * product_2 * r_squared * sigma_u_squared * sum_1 * sum_3 * sum_4 * u * v
        - 4.0 * predicted_rho * predicted_sigma_u * predicted_sigma_v * r_squared * sigma_v_squared * sum_2_squared * u * (u_squared - 1.0 - v_squared) * v
        - predicted_sigma_u_squared * predicted_sigma_v_squared * r_squared * rho * sigma_u * sigma_v * sum_14 * u * v
        - predicted_sigma_u_squared * r_squared * sigma_u_squared * sum_15 * sum_2_squared * sum_3 * sum_4
        - predicted_sigma_v_squared * r_squared * sigma_u_squared * sum_16 * sum_2_squared * u_squared
        - predicted_rho * predicted_sigma_v * product_2 * r_squared * sigma_v_squared * sum_1 * sum_8 * u * v
        - predicted_rho * predicted_sigma_v * product_2 * sigma_r_squared * sum_2_squared * sum_3 * sum_4 * u * v
        - predicted_rho * predicted_sigma_u * product_3 * r_squared * sigma_u_squared * sum_1 * sum_8 * u * v
        - predicted_rho * predicted_sigma_u * product_3 * sigma_r_squared * sum_2_squared * sum_6 * sum_7 * u * v
        + 2.0 * predicted_sigma_u_squared * r_squared * rho * sigma_u * sigma_v * sum_17 * sum_2_squared * u * v
        + 2.0 * r_squared * rho * sigma_u * sigma_v * sum_2_squared_squared * u * v
        + 2.0 * rho * sigma_r_squared * sigma_u * sigma_v * sum_2_squared_squared * u * v
        + 1.5 * predicted_sigma_u_squared * predicted_sigma_v_squared * r_squared * sigma_u_squared * sum_3 * sum_4 * sum_8 * u_squared
        + 1.5 * predicted_sigma_v_squared_squared * r_squared * rho * sigma_u * sigma_v * sum_6 * sum_7 * sum_8 * u * v
        + 3.0 * predicted_rho * predicted_sigma_u * product_3 * r_squared * sigma_v_squared * sum_6 * sum_7 * sum_8 * u * v
        + 4.0 * predicted_rho * predicted_sigma_u * predicted_sigma_v * r_squared * sigma_u_squared * sum_2_squared * u * (1.0 - v_squared + u_squared) * v
        + 2.25 * predicted_sigma_u_squared_squared * r_squared * sigma_u_squared * sum_3_squared * sum_4_squared * u_squared
        + 2.25 * predicted_sigma_v_squared_squared * r_squared * sigma_v_squared * sum_6_squared * sum_7_squared * v_squared
        + predicted_rho_squared * predicted_sigma_u_squared * predicted_sigma_v_squared * r_squared * sigma_u_squared * sum_1_squared * v_squared
        + predicted_rho_squared * predicted_sigma_u_squared * predicted_sigma_v_squared * r_squared * sigma_v_squared * sum_8_squared * u_squared
        + predicted_rho_squared * predicted_sigma_u_squared * predicted_sigma_v_squared * sigma_r_squared * sum_2_squared * u_squared * v_squared
        + predicted_sigma_r_squared * sigma_u_squared * sum_2_squared_squared * u_squared
        + predicted_sigma_r_squared * sigma_v_squared * sum_2_squared_squared * v_squared
        + 0.5 * predicted_sigma_u_squared * predicted_sigma_v_squared * sigma_r_squared * sum_2_squared * sum_3 * sum_4 * sum_6 * sum_7
        + predicted_sigma_u_squared * product_5 * sigma_r_squared
        + predicted_sigma_u_squared * r_squared * sigma_v_squared * sum_15 * sum_2_squared * v_squared
        + 0.25 * predicted_sigma_u_squared_squared * r_squared * sigma_v_squared * sum_1_squared * v_squared
        + 0.25 * predicted_sigma_u_squared_squared * sigma_r_squared * sum_2_squared * sum_3_squared * sum_4_squared
        + predicted_sigma_v_squared * product_5 * sigma_r_squared
        + predicted_sigma_v_squared * r_squared * sigma_v_squared * sum_16 * sum_2_squared * sum_6 * sum_7
        + 0.25 * predicted_sigma_v_squared_squared * r_squared * sigma_u_squared * sum_8_squared * u_squared
        + 0.25 * predicted_sigma_v_squared_squared * sigma_r_squared * sum_2_squared * sum_6_squared * sum_7_squared
        + predicted_rho * predicted_sigma_v * product_2 * r_squared * rho * sigma_u * sigma_v * sum_18
        + predicted_rho * predicted_sigma_u * product_3 * r_squared * rho * sigma_u * sigma_v * sum_19
        + 0.5 * r_squared * sigma_u_squared**2 * sum_2_squared * sum_3_squared * sum_4_squared
        + r_squared * rho**2 * sigma_u_squared * sigma_v_squared * sum_20 * sum_2_squared
        + r_squared * sigma_u_squared * sigma_v_squared * sum_2_squared * u_squared * v_squared
        + r_squared * sigma_u_squared * sum_2_squared_squared * u_squared
        + 0.5 * r_squared * sigma_v_squared**2 * sum_2_squared * sum_6_squared * sum_7_squared
        + r_squared * sigma_v_squared * sum_2_squared_squared * v_squared
        + sigma_r_squared * sigma_u_squared * sum_2_squared_squared * u_squared
        + sigma_r_squared * sigma_v_squared * sum_2_squared_squared * v_squared
        + sigma_r_squared * sum_2_squared * sum_2_squared**2
    )
    result = _empty(arguments, (3, 3))
    result[..., 0, 0] = (
        predicted_sigma_r_squared * sigma_u_squared
        + predicted_sigma_u_squared * sigma_r_squared
        + r_squared * sigma_u_squared
        + sigma_r_squared * sigma_u_squared
        + sigma_r_squared * u_squared
    )
    result[..., 0, 1] = (
        predicted_sigma_r_squared * rho * sigma_u * sigma_v
        + r_squared * rho * sigma_u * sigma_v
        + predicted_rho * predicted_sigma_u * predicted_sigma_v * sigma_r_squared
        + rho * sigma_r_squared * sigma_u * sigma_v
        + sigma_r_squared * u * v
    )
    result[..., 0, 2] = sum_9 * term_1
    result[..., 1, 0] = result[..., 0, 1]
    result[..., 1, 1] = (
        predicted_sigma_r_squared * sigma_v_squared
        + predicted_sigma_v_squared * sigma_r_squared
        + r_squared * sigma_v_squared
        + sigma_r_squared * sigma_v_squared
        + sigma_r_squared * v_squared
    )
    result[..., 1, 2] = sum_11 * term_1
    result[..., 2, 0] = result[..., 0, 2]
    result[..., 2, 1] = result[..., 1, 2]
    result[..., 2, 2] = sum_21 / (root_1 * (root_1**2)**2)**2
    return result
