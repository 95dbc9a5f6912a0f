"""Conversions over arrays; mean, shape (..., n), and covariance, shape (..., n, n), are filled.

Written by radartrack regenerate, generator 1, derivation 36e022ba116239c7; not to be edited.
"""

import numpy as np
import numpy.typing as npt

Floats = npt.NDArray[np.floating]


def polar_linear(
    r: Floats,
    beta: Floats,
    sigma_r: Floats,
    sigma_beta: Floats,
    rho: Floats,
    mean: Floats,
    covariance: Floats,
) -> None:
    """Conversion polar, linear.

    Mean: map from the measured quantities to coordinates. Covariance: covariance of the linearised
    conversion.
    """
    cos_beta = np.cos(beta)
    sin_beta = np.sin(beta)
    part_00_cos_beta_sin_beta = -2.0 * r * rho * sigma_beta * sigma_r
    r_squared = r**2
    sigma_beta_squared = sigma_beta**2
    part_00_sin_beta2 = r_squared * sigma_beta_squared
    part_01_cos_beta2 = r * rho * sigma_beta * sigma_r
    sigma_r_squared = sigma_r**2
    part_01_cos_beta_sin_beta = sigma_r_squared - r_squared * sigma_beta_squared
    cos_beta_squared = cos_beta**2
    sin_beta_squared = sin_beta**2
    mean[..., 0] = cos_beta * r
    mean[..., 1] = r * sin_beta
    covariance[..., 0, 0] = (
        cos_beta * part_00_cos_beta_sin_beta * sin_beta
        + cos_beta_squared * sigma_r_squared
        + part_00_sin_beta2 * sin_beta_squared
    )
    covariance[..., 0, 1] = (
        cos_beta * part_01_cos_beta_sin_beta * sin_beta
        - part_01_cos_beta2 * sin_beta_squared
        + cos_beta_squared * part_01_cos_beta2
    )
    covariance[..., 1, 0] = covariance[..., 0, 1]
    covariance[..., 1, 1] = (
        cos_beta_squared * part_00_sin_beta2
        - cos_beta * part_00_cos_beta_sin_beta * sin_beta
        + sigma_r_squared * sin_beta_squared
    )


def polar_second_order(
    r: Floats,
    beta: Floats,
    sigma_r: Floats,
    sigma_beta: Floats,
    rho: Floats,
    mean: Floats,
    covariance: Floats,
) -> None:
    """Conversion polar, second_order.

    Mean: map from the measured quantities to coordinates less the bias of the plain conversion to second
    order. Covariance: covariance of the conversion's quadratic Taylor polynomial.
    """
    cos_beta = np.cos(beta)
    sin_beta = np.sin(beta)
    sigma_beta_squared = sigma_beta**2
    part_0_cos_beta = -0.5 * r * sigma_beta_squared
    part_0_sin_beta = -rho * sigma_beta * sigma_r
    r_squared = r**2
    product_1 = 0.5 * r_squared * sigma_beta_squared**2
    sigma_r_squared = sigma_r**2
    part_00_cos_beta2 = product_1 + sigma_r_squared
    product_2 = sigma_beta * sigma_beta_squared
    part_00_cos_beta_sin_beta = 2.0 * product_2 * r * rho * sigma_r - 2.0 * r * rho * sigma_beta * sigma_r
    rho_squared = rho**2
    part_00_sin_beta2 = (
        r_squared * sigma_beta_squared
        + rho_squared * sigma_beta_squared * sigma_r_squared
        + sigma_beta_squared * sigma_r_squared
    )
    part_01_cos_beta2 = r * rho * sigma_beta * sigma_r - product_2 * r * rho * sigma_r
    part_01_cos_beta_sin_beta = (
        product_1
        - r_squared * sigma_beta_squared
        - rho_squared * sigma_beta_squared * sigma_r_squared
        - sigma_beta_squared * sigma_r_squared
        + sigma_r_squared
    )
    cos_beta_squared = cos_beta**2
    sin_beta_squared = sin_beta**2
    mean[..., 0] = cos_beta * r - cos_beta * part_0_cos_beta - part_0_sin_beta * sin_beta
    mean[..., 1] = cos_beta * part_0_sin_beta - part_0_cos_beta * sin_beta + r * sin_beta
    covariance[..., 0, 0] = (
        cos_beta * part_00_cos_beta_sin_beta * sin_beta
        + cos_beta_squared * part_00_cos_beta2
        + part_00_sin_beta2 * sin_beta_squared
    )
    covariance[..., 0, 1] = (
        cos_beta * part_01_cos_beta_sin_beta * sin_beta
        - part_01_cos_beta2 * sin_beta_squared
        + cos_beta_squared * part_01_cos_beta2
    )
    covariance[..., 1, 0] = covariance[..., 0, 1]
    covariance[..., 1, 1] = (
        cos_beta_squared * part_00_sin_beta2
        - cos_beta * part_00_cos_beta_sin_beta * sin_beta
        + part_00_cos_beta2 * sin_beta_squared
    )


def polar_averaged(
    r: Floats,
    beta: Floats,
    sigma_r: Floats,
    sigma_beta: Floats,
    rho: Floats,
    mean: Floats,
    covariance: Floats,
) -> None:
    """Conversion polar, averaged.

    Mean: map from the measured quantities to coordinates less the exact bias of the plain conversion,
    averaged over the truth. Covariance: exact covariance of the plain conversion, averaged over the truth.
    """
    cos_beta = np.cos(beta)
    sin_beta = np.sin(beta)
    sigma_beta_squared = sigma_beta**2
    attenuation_beta = np.exp(-0.5 * sigma_beta_squared)
    shortfall_beta = -np.expm1(-0.5 * sigma_beta_squared)
    part_0_cos_beta = -attenuation_beta * r * shortfall_beta
    attenuation_beta_2 = np.exp(-sigma_beta_squared)
    shortfall_beta_2 = -np.expm1(-sigma_beta_squared)
    shortfall_beta_2_squared = shortfall_beta_2**2
    product_1 = -3.0 * attenuation_beta_2 * shortfall_beta_2_squared
    attenuation_beta_2_squared = attenuation_beta_2**2
    product_2 = attenuation_beta_2 * attenuation_beta_2_squared
    rho_squared = rho**2
    sigma_r_squared = sigma_r**2
    sum_1 = (
        6.0 * attenuation_beta_2_squared * shortfall_beta_2
        - 8.0 * product_2
        - shortfall_beta_2 * shortfall_beta_2_squared
        + product_1
    )
    r_squared = r**2
    sum_2 = 1.0 + attenuation_beta_2 + attenuation_beta_2_squared
    sum_3 = 1.0 - 0.5 * attenuation_beta_2 - 0.5 * product_2 + attenuation_beta_2_squared**2
    part_00_cos_beta2 = (
        0.5 * attenuation_beta_2 * rho_squared * sigma_beta_squared * sigma_r_squared * sum_1
        + 0.5 * r_squared * shortfall_beta_2_squared * sum_2
        + sigma_r_squared * sum_3
    )
    sum_4 = (
        6.0 * product_2
        - 12.0 * attenuation_beta_2_squared * shortfall_beta_2
        - shortfall_beta_2 * shortfall_beta_2_squared
        + product_1
    )
    sum_5 = 2.0 + 2.0 * product_2 + attenuation_beta_2 + attenuation_beta_2_squared
    part_00_sin_beta2 = (
        0.5 * attenuation_beta_2 * rho_squared * sigma_beta_squared * sigma_r_squared * sum_4
        + 0.5 * (1.0 + product_2) * r_squared * shortfall_beta_2
        + 0.5 * shortfall_beta_2 * sigma_r_squared * sum_5
    )
    sum_6 = 9.0 * shortfall_beta_2 - 7.0 * attenuation_beta_2
    sum_7 = attenuation_beta_2 - shortfall_beta_2
    part_01_cos_beta_sin_beta = (
        product_2 * rho_squared * sigma_beta_squared * sigma_r_squared * sum_6
        - product_2 * r_squared * shortfall_beta_2
        + product_2 * sigma_r_squared * sum_7
    )
    sum_8 = shortfall_beta - attenuation_beta
    sum_9 = attenuation_beta - shortfall_beta
    sum_10 = 3.0 * shortfall_beta_2 - attenuation_beta_2
    cos_beta_squared = cos_beta**2
    sin_beta_squared = sin_beta**2
    sum_11 = attenuation_beta_2 - 3.0 * shortfall_beta_2
    mean[..., 0] = (
        cos_beta * r
        - attenuation_beta * rho * sigma_beta * sigma_r * sin_beta * sum_8
        - cos_beta * part_0_cos_beta
    )
    mean[..., 1] = (
        r * sin_beta
        - attenuation_beta * cos_beta * rho * sigma_beta * sigma_r * sum_9
        - part_0_cos_beta * sin_beta
    )
    covariance[..., 0, 0] = (
        2.0 * cos_beta * product_2 * r * rho * sigma_beta * sigma_r * sin_beta * sum_10
        + cos_beta_squared * part_00_cos_beta2
        + part_00_sin_beta2 * sin_beta_squared
    )
    covariance[..., 0, 1] = (
        cos_beta * part_01_cos_beta_sin_beta * sin_beta
        + cos_beta_squared * product_2 * r * rho * sigma_beta * sigma_r * sum_11
        + product_2 * r * rho * sigma_beta * sigma_r * sin_beta_squared * sum_10
    )
    covariance[..., 1, 0] = covariance[..., 0, 1]
    covariance[..., 1, 1] = (
        2.0 * cos_beta * product_2 * r * rho * sigma_beta * sigma_r * sin_beta * sum_11
        + cos_beta_squared * part_00_sin_beta2
        + part_00_cos_beta2 * sin_beta_squared
    )


def polar_unbiased(
    r: Floats,
    beta: Floats,
    sigma_r: Floats,
    sigma_beta: Floats,
    rho: Floats,
    mean: Floats,
    covariance: Floats,
) -> None:
    """Conversion polar, unbiased.

    Mean: exactly unbiased estimate of the position. Covariance: error covariance of the unbiased estimate u.
    """
    cos_beta = np.cos(beta)
    sin_beta = np.sin(beta)
    sigma_beta_squared = sigma_beta**2
    attenuation_beta = np.exp(-0.5 * sigma_beta_squared)
    term_1 = 1.0 / attenuation_beta
    part_0_cos_beta = r * term_1
    part_0_sin_beta = rho * sigma_beta * sigma_r * term_1
    attenuation_beta_2 = np.exp(-sigma_beta_squared)
    shortfall_beta = -np.expm1(-sigma_beta_squared)
    attenuation_beta_2_squared = attenuation_beta_2**2
    rho_squared = rho**2
    sigma_r_squared = sigma_r**2
    term_2 = 1.0 / attenuation_beta_2
    r_squared = r**2
    shortfall_beta_squared = shortfall_beta**2
    sum_1 = 0.5 + 0.5 * attenuation_beta_2_squared
    part_00_cos_beta2 = (
        0.5 * (2.0 + attenuation_beta_2) * r_squared * shortfall_beta_squared * term_2
        - 2.0 * attenuation_beta_2_squared * rho_squared * sigma_beta_squared * sigma_r_squared
        + sigma_r_squared * sum_1
    )
    product_1 = attenuation_beta_2 * attenuation_beta_2_squared
    sum_2 = 1.0 + 2.0 * attenuation_beta_2 + 2.0 * product_1
    sum_3 = 1.0 + attenuation_beta_2
    part_00_sin_beta2 = (
        0.5 * r_squared * shortfall_beta * sum_3
        + rho_squared * sigma_beta_squared * sigma_r_squared * sum_2 * term_2
        + 0.5 * shortfall_beta * sigma_r_squared * sum_3
    )
    sum_4 = -1.0 - 2.0 * attenuation_beta_2 - 4.0 * product_1
    sum_5 = attenuation_beta_2 * shortfall_beta - attenuation_beta_2_squared + shortfall_beta_squared
    part_01_cos_beta_sin_beta = (
        attenuation_beta_2_squared * sigma_r_squared
        + r_squared * shortfall_beta * sum_5 * term_2
        + rho_squared * sigma_beta_squared * sigma_r_squared * sum_4 * term_2
    )
    product_2 = shortfall_beta * shortfall_beta_squared
    sum_6 = (
        3.0 * attenuation_beta_2 * shortfall_beta_squared
        - product_1
        + 3.0 * attenuation_beta_2_squared * shortfall_beta
        + product_2
    )
    cos_beta_squared = cos_beta**2
    sin_beta_squared = sin_beta**2
    sum_7 = (
        product_1
        - 3.0 * attenuation_beta_2 * shortfall_beta_squared
        - 3.0 * attenuation_beta_2_squared * shortfall_beta
        - product_2
    )
    mean[..., 0] = cos_beta * part_0_cos_beta + part_0_sin_beta * sin_beta
    mean[..., 1] = part_0_cos_beta * sin_beta - cos_beta * part_0_sin_beta
    covariance[..., 0, 0] = (
        2.0 * cos_beta * r * rho * sigma_beta * sigma_r * sin_beta * sum_6 * term_2
        + cos_beta_squared * part_00_cos_beta2
        + part_00_sin_beta2 * sin_beta_squared
    )
    covariance[..., 0, 1] = (
        cos_beta * part_01_cos_beta_sin_beta * sin_beta
        + cos_beta_squared * r * rho * sigma_beta * sigma_r * sum_7 * term_2
        + r * rho * sigma_beta * sigma_r * sin_beta_squared * sum_6 * term_2
    )
    covariance[..., 1, 0] = covariance[..., 0, 1]
    covariance[..., 1, 1] = (
        2.0 * cos_beta * r * rho * sigma_beta * sigma_r * sin_beta * sum_7 * term_2
        + cos_beta_squared * part_00_sin_beta2
        + part_00_cos_beta2 * sin_beta_squared
    )


def polar_posterior(
    r: Floats,
    beta: Floats,
    sigma_r: Floats,
    sigma_beta: Floats,
    rho: Floats,
    mean: Floats,
    covariance: Floats,
) -> None:
    """Conversion polar, posterior.

    Mean: posterior mean of the position under a flat prior. Covariance: posterior covariance of the position
    under a flat prior.
    """
    cos_beta = np.cos(beta)
    sin_beta = np.sin(beta)
    sigma_beta_squared = sigma_beta**2
    attenuation_beta = np.exp(-0.5 * sigma_beta_squared)
    part_0_cos_beta = attenuation_beta * r
    part_0_sin_beta = -attenuation_beta * rho * sigma_beta * sigma_r
    attenuation_beta_2 = np.exp(-sigma_beta_squared)
    shortfall_beta = -np.expm1(-sigma_beta_squared)
    attenuation_beta_2_squared = attenuation_beta_2**2
    rho_squared = rho**2
    sigma_r_squared = sigma_r**2
    r_squared = r**2
    sum_1 = 0.5 + 0.5 * attenuation_beta_2_squared
    part_00_cos_beta2 = (
        0.5 * r_squared * shortfall_beta**2
        - 2.0 * attenuation_beta_2_squared * rho_squared * sigma_beta_squared * sigma_r_squared
        + sigma_r_squared * sum_1
    )
    sum_2 = attenuation_beta_2 - shortfall_beta
    sum_3 = 1.0 + attenuation_beta_2
    part_00_sin_beta2 = (
        attenuation_beta_2 * rho_squared * sigma_beta_squared * sigma_r_squared * sum_2
        + 0.5 * r_squared * shortfall_beta * sum_3
        + 0.5 * shortfall_beta * sigma_r_squared * sum_3
    )
    sum_4 = shortfall_beta - 3.0 * attenuation_beta_2
    part_01_cos_beta_sin_beta = (
        attenuation_beta_2 * rho_squared * sigma_beta_squared * sigma_r_squared * sum_4
        - attenuation_beta_2 * r_squared * shortfall_beta
        + attenuation_beta_2_squared * sigma_r_squared
    )
    sum_5 = shortfall_beta - attenuation_beta_2
    cos_beta_squared = cos_beta**2
    sin_beta_squared = sin_beta**2
    mean[..., 0] = cos_beta * part_0_cos_beta + part_0_sin_beta * sin_beta
    mean[..., 1] = part_0_cos_beta * sin_beta - cos_beta * part_0_sin_beta
    covariance[..., 0, 0] = (
        2.0 * attenuation_beta_2 * cos_beta * r * rho * sigma_beta * sigma_r * sin_beta * sum_5
        + cos_beta_squared * part_00_cos_beta2
        + part_00_sin_beta2 * sin_beta_squared
    )
    covariance[..., 0, 1] = (
        attenuation_beta_2 * cos_beta_squared * r * rho * sigma_beta * sigma_r * sum_2
        + attenuation_beta_2 * r * rho * sigma_beta * sigma_r * sin_beta_squared * sum_5
        + cos_beta * part_01_cos_beta_sin_beta * sin_beta
    )
    covariance[..., 1, 0] = covariance[..., 0, 1]
    covariance[..., 1, 1] = (
        2.0 * attenuation_beta_2 * cos_beta * r * rho * sigma_beta * sigma_r * sin_beta * sum_2
        + cos_beta_squared * part_00_sin_beta2
        + part_00_cos_beta2 * sin_beta_squared
    )


def polar_doppler_linear(
    r: Floats,
    beta: Floats,
    rdot: Floats,
    sigma_r: Floats,
    sigma_beta: Floats,
    sigma_rdot: Floats,
    rho: Floats,
    mean: Floats,
    covariance: Floats,
) -> None:
    """Conversion polar_doppler, linear.

    Mean: map from the measured quantities to coordinates. Covariance: covariance of the linearised
    conversion.
    """
    cos_beta = np.cos(beta)
    sin_beta = np.sin(beta)
    r_squared = r**2
    sigma_beta_squared = sigma_beta**2
    part_00_sin_beta2 = r_squared * sigma_beta_squared
    sigma_r_squared = sigma_r**2
    part_01_cos_beta_sin_beta = sigma_r_squared - r_squared * sigma_beta_squared
    part_02_cos_beta = r * rho * sigma_r * sigma_rdot + rdot * sigma_r_squared
    cos_beta_squared = cos_beta**2
    sin_beta_squared = sin_beta**2
    mean[..., 0] = cos_beta * r
    mean[..., 1] = r * sin_beta
    mean[..., 2] = r * rdot
    covariance[..., 0, 0] = cos_beta_squared * sigma_r_squared + part_00_sin_beta2 * sin_beta_squared
    covariance[..., 0, 1] = cos_beta * part_01_cos_beta_sin_beta * sin_beta
    covariance[..., 0, 2] = cos_beta * part_02_cos_beta
    covariance[..., 1, 0] = covariance[..., 0, 1]
    covariance[..., 1, 1] = cos_beta_squared * part_00_sin_beta2 + sigma_r_squared * sin_beta_squared
    covariance[..., 1, 2] = part_02_cos_beta * sin_beta
    covariance[..., 2, 0] = covariance[..., 0, 2]
    covariance[..., 2, 1] = covariance[..., 1, 2]
    covariance[..., 2, 2] = (
        2.0 * r * rdot * rho * sigma_r * sigma_rdot
        + r_squared * sigma_rdot**2
        + rdot**2 * sigma_r_squared
    )


def polar_doppler_second_order(
    r: Floats,
    beta: Floats,
    rdot: Floats,
    sigma_r: Floats,
    sigma_beta: Floats,
    sigma_rdot: Floats,
    rho: Floats,
    mean: Floats,
    covariance: Floats,
) -> None:
    """Conversion polar_doppler, second_order.

    Mean: map from the measured quantities to coordinates less the bias of the plain conversion to second
    order. Covariance: covariance of the conversion's quadratic Taylor polynomial.
    """
    cos_beta = np.cos(beta)
    sin_beta = np.sin(beta)
    sigma_beta_squared = sigma_beta**2
    part_0_cos_beta = -0.5 * r * sigma_beta_squared
    r_squared = r**2
    product_1 = 0.5 * r_squared * sigma_beta_squared**2
    sigma_r_squared = sigma_r**2
    part_00_cos_beta2 = product_1 + sigma_r_squared
    part_00_sin_beta2 = r_squared * sigma_beta_squared + sigma_beta_squared * sigma_r_squared
    part_01_cos_beta_sin_beta = (
        product_1
        - r_squared * sigma_beta_squared
        - sigma_beta_squared * sigma_r_squared
        + sigma_r_squared
    )
    part_02_cos_beta = r * rho * sigma_r * sigma_rdot + rdot * sigma_r_squared
    cos_beta_squared = cos_beta**2
    sin_beta_squared = sin_beta**2
    sigma_rdot_squared = sigma_rdot**2
    mean[..., 0] = cos_beta * r - cos_beta * part_0_cos_beta
    mean[..., 1] = r * sin_beta - part_0_cos_beta * sin_beta
    mean[..., 2] = r * rdot - rho * sigma_r * sigma_rdot
    covariance[..., 0, 0] = cos_beta_squared * part_00_cos_beta2 + part_00_sin_beta2 * sin_beta_squared
    covariance[..., 0, 1] = cos_beta * part_01_cos_beta_sin_beta * sin_beta
    covariance[..., 0, 2] = cos_beta * part_02_cos_beta
    covariance[..., 1, 0] = covariance[..., 0, 1]
    covariance[..., 1, 1] = cos_beta_squared * part_00_sin_beta2 + part_00_cos_beta2 * sin_beta_squared
    covariance[..., 1, 2] = part_02_cos_beta * sin_beta
    covariance[..., 2, 0] = covariance[..., 0, 2]
    covariance[..., 2, 1] = covariance[..., 1, 2]
    covariance[..., 2, 2] = (
        2.0 * r * rdot * rho * sigma_r * sigma_rdot
        + r_squared * sigma_rdot_squared
        + rdot**2 * sigma_r_squared
        + sigma_r_squared * sigma_rdot_squared
        + rho**2 * sigma_r_squared * sigma_rdot_squared
    )


def polar_doppler_averaged(
    r: Floats,
    beta: Floats,
    rdot: Floats,
    sigma_r: Floats,
    sigma_beta: Floats,
    sigma_rdot: Floats,
    rho: Floats,
    mean: Floats,
    covariance: Floats,
) -> None:
    """Conversion polar_doppler, averaged.

    Mean: map from the measured quantities to coordinates less the exact bias of the plain conversion,
    averaged over the truth. Covariance: exact covariance of the plain conversion, averaged over the truth.
    """
    cos_beta = np.cos(beta)
    sin_beta = np.sin(beta)
    sigma_beta_squared = sigma_beta**2
    attenuation_beta = np.exp(-0.5 * sigma_beta_squared)
    shortfall_beta = -np.expm1(-0.5 * sigma_beta_squared)
    part_0_cos_beta = -attenuation_beta * r * shortfall_beta
    attenuation_beta_2 = np.exp(-sigma_beta_squared)
    shortfall_beta_2 = -np.expm1(-sigma_beta_squared)
    attenuation_beta_2_squared = attenuation_beta_2**2
    r_squared = r**2
    sum_1 = 1.0 + attenuation_beta_2 + attenuation_beta_2_squared
    product_1 = attenuation_beta_2 * attenuation_beta_2_squared
    sigma_r_squared = sigma_r**2
    sum_2 = 1.0 - 0.5 * attenuation_beta_2 - 0.5 * product_1 + attenuation_beta_2_squared**2
    part_00_cos_beta2 = 0.5 * r_squared * shortfall_beta_2**2 * sum_1 + sigma_r_squared * sum_2
    sum_3 = 2.0 + 2.0 * product_1 + attenuation_beta_2 + attenuation_beta_2_squared
    part_00_sin_beta2 = (
        0.5 * (1.0 + product_1) * r_squared * shortfall_beta_2
        + 0.5 * shortfall_beta_2 * sigma_r_squared * sum_3
    )
    sum_4 = attenuation_beta_2 - shortfall_beta_2
    part_01_cos_beta_sin_beta = product_1 * sigma_r_squared * sum_4 - product_1 * r_squared * shortfall_beta_2
    part_02_cos_beta = (
        attenuation_beta_2 * r * rho * sigma_r * sigma_rdot
        + attenuation_beta_2 * rdot * sigma_r_squared
    )
    cos_beta_squared = cos_beta**2
    sin_beta_squared = sin_beta**2
    sigma_rdot_squared = sigma_rdot**2
    mean[..., 0] = cos_beta * r - cos_beta * part_0_cos_beta
    mean[..., 1] = r * sin_beta - part_0_cos_beta * sin_beta
    mean[..., 2] = r * rdot - rho * sigma_r * sigma_rdot
    covariance[..., 0, 0] = cos_beta_squared * part_00_cos_beta2 + part_00_sin_beta2 * sin_beta_squared
    covariance[..., 0, 1] = cos_beta * part_01_cos_beta_sin_beta * sin_beta
    covariance[..., 0, 2] = cos_beta * part_02_cos_beta
    covariance[..., 1, 0] = covariance[..., 0, 1]
    covariance[..., 1, 1] = cos_beta_squared * part_00_sin_beta2 + part_00_cos_beta2 * sin_beta_squared
    covariance[..., 1, 2] = part_02_cos_beta * sin_beta
    covariance[..., 2, 0] = covariance[..., 0, 2]
    covariance[..., 2, 1] = covariance[..., 1, 2]
    covariance[..., 2, 2] = (
        2.0 * r * rdot * rho * sigma_r * sigma_rdot
        + 3.0 * sigma_r_squared * sigma_rdot_squared
        + 3.0 * rho**2 * sigma_r_squared * sigma_rdot_squared
        + r_squared * sigma_rdot_squared
        + rdot**2 * sigma_r_squared
    )


def polar_doppler_unbiased(
    r: Floats,
    beta: Floats,
    rdot: Floats,
    sigma_r: Floats,
    sigma_beta: Floats,
    sigma_rdot: Floats,
    rho: Floats,
    mean: Floats,
    covariance: Floats,
) -> None:
    """Conversion polar_doppler, unbiased.

    Mean: exactly unbiased estimate of the position. Covariance: error covariance of the unbiased estimate u.
    """
    cos_beta = np.cos(beta)
    sin_beta = np.sin(beta)
    attenuation_beta = np.exp(-0.5 * sigma_beta**2)
    term_1 = 1.0 / attenuation_beta
    part_0_cos_beta = r * term_1
    shortfall_beta = -np.expm1(-0.5 * sigma_beta**2)
    term_2 = 1.0 / attenuation_beta**2
    attenuation_beta_squared = attenuation_beta**2
    product_1 = attenuation_beta * attenuation_beta_squared
    attenuation_beta_squared_squared = attenuation_beta_squared**2
    r_squared = r**2
    shortfall_beta_squared = shortfall_beta**2
    sum_1 = (
        2.0
        + 2.0 * product_1
        + 3.0 * attenuation_beta_squared
        + 4.0 * attenuation_beta
        + attenuation_beta_squared_squared
    )
    sigma_r_squared = sigma_r**2
    sum_2 = 0.5 + 0.5 * attenuation_beta_squared_squared
    part_00_cos_beta2 = 0.5 * r_squared * shortfall_beta_squared * sum_1 * term_2 + sigma_r_squared * sum_2
    sum_3 = 1.0 + attenuation_beta + attenuation_beta_squared + product_1
    part_00_sin_beta2 = (
        0.5 * r_squared * shortfall_beta * sum_3
        + 0.5 * shortfall_beta * sigma_r_squared * sum_3
    )
    sum_4 = (
        12.0 * product_1 * shortfall_beta_squared
        - 2.0 * attenuation_beta * attenuation_beta_squared**2
        + 13.0 * attenuation_beta_squared * shortfall_beta * shortfall_beta_squared
        + 3.0 * attenuation_beta_squared_squared * shortfall_beta
        + 6.0 * attenuation_beta * shortfall_beta_squared**2
        + shortfall_beta * shortfall_beta_squared**2
    )
    part_01_cos_beta_sin_beta = (
        attenuation_beta_squared_squared * sigma_r_squared
        + r_squared * shortfall_beta * sum_4 * term_2
    )
    sum_5 = attenuation_beta_squared - 2.0 * shortfall_beta_squared - 4.0 * attenuation_beta * shortfall_beta
    part_02_cos_beta = (
        attenuation_beta * rdot * sigma_r_squared
        + r * rho * sigma_r * sigma_rdot * sum_5 * term_1
    )
    cos_beta_squared = cos_beta**2
    sin_beta_squared = sin_beta**2
    sigma_rdot_squared = sigma_rdot**2
    mean[..., 0] = cos_beta * part_0_cos_beta
    mean[..., 1] = part_0_cos_beta * sin_beta
    mean[..., 2] = r * rdot - rho * sigma_r * sigma_rdot
    covariance[..., 0, 0] = cos_beta_squared * part_00_cos_beta2 + part_00_sin_beta2 * sin_beta_squared
    covariance[..., 0, 1] = cos_beta * part_01_cos_beta_sin_beta * sin_beta
    covariance[..., 0, 2] = cos_beta * part_02_cos_beta
    covariance[..., 1, 0] = covariance[..., 0, 1]
    covariance[..., 1, 1] = cos_beta_squared * part_00_sin_beta2 + part_00_cos_beta2 * sin_beta_squared
    covariance[..., 1, 2] = part_02_cos_beta * sin_beta
    covariance[..., 2, 0] = covariance[..., 0, 2]
    covariance[..., 2, 1] = covariance[..., 1, 2]
    covariance[..., 2, 2] = (
        2.0 * r * rdot * rho * sigma_r * sigma_rdot
        + 5.0 * rho**2 * sigma_r_squared * sigma_rdot_squared
        + r_squared * sigma_rdot_squared
        + rdot**2 * sigma_r_squared
        + sigma_r_squared * sigma_rdot_squared
    )


def polar_doppler_posterior(
    r: Floats,
    beta: Floats,
    rdot: Floats,
    sigma_r: Floats,
    sigma_beta: Floats,
    sigma_rdot: Floats,
    rho: Floats,
    mean: Floats,
    covariance: Floats,
) -> None:
    """Conversion polar_doppler, posterior.

    Mean: posterior mean of the position under a flat prior. Covariance: posterior covariance of the position
    under a flat prior.
    """
    cos_beta = np.cos(beta)
    sin_beta = np.sin(beta)
    attenuation_beta = np.exp(-0.5 * sigma_beta**2)
    part_0_cos_beta = attenuation_beta * r
    shortfall_beta = -np.expm1(-0.5 * sigma_beta**2)
    attenuation_beta_squared = attenuation_beta**2
    r_squared = r**2
    sum_1 = 1.0 + 2.0 * attenuation_beta + attenuation_beta_squared
    attenuation_beta_squared_squared = attenuation_beta_squared**2
    sigma_r_squared = sigma_r**2
    sum_2 = 0.5 + 0.5 * attenuation_beta_squared_squared
    part_00_cos_beta2 = 0.5 * r_squared * shortfall_beta**2 * sum_1 + sigma_r_squared * sum_2
    sum_3 = 1.0 + attenuation_beta + attenuation_beta * attenuation_beta_squared + attenuation_beta_squared
    part_00_sin_beta2 = (
        0.5 * r_squared * shortfall_beta * sum_3
        + 0.5 * shortfall_beta * sigma_r_squared * sum_3
    )
    part_01_cos_beta_sin_beta = (
        (-1.0 - attenuation_beta) * attenuation_beta_squared * r_squared * shortfall_beta
        + attenuation_beta_squared_squared * sigma_r_squared
    )
    part_02_cos_beta = (
        attenuation_beta * r * rho * sigma_r * sigma_rdot
        + attenuation_beta * rdot * sigma_r_squared
    )
    cos_beta_squared = cos_beta**2
    sin_beta_squared = sin_beta**2
    sigma_rdot_squared = sigma_rdot**2
    mean[..., 0] = cos_beta * part_0_cos_beta
    mean[..., 1] = part_0_cos_beta * sin_beta
    mean[..., 2] = r * rdot + rho * sigma_r * sigma_rdot
    covariance[..., 0, 0] = cos_beta_squared * part_00_cos_beta2 + part_00_sin_beta2 * sin_beta_squared
    covariance[..., 0, 1] = cos_beta * part_01_cos_beta_sin_beta * sin_beta
    covariance[..., 0, 2] = cos_beta * part_02_cos_beta
    covariance[..., 1, 0] = covariance[..., 0, 1]
    covariance[..., 1, 1] = cos_beta_squared * part_00_sin_beta2 + part_00_cos_beta2 * sin_beta_squared
    covariance[..., 1, 2] = part_02_cos_beta * sin_beta
    covariance[..., 2, 0] = covariance[..., 0, 2]
    covariance[..., 2, 1] = covariance[..., 1, 2]
    covariance[..., 2, 2] = (
        2.0 * r * rdot * rho * sigma_r * sigma_rdot
        + r_squared * sigma_rdot_squared
        + rdot**2 * sigma_r_squared
        + sigma_r_squared * sigma_rdot_squared
        + rho**2 * sigma_r_squared * sigma_rdot_squared
    )


def ruv_linear(
    r: Floats,
    u: Floats,
    v: Floats,
    sigma_r: Floats,
    sigma_u: Floats,
    sigma_v: Floats,
    rho: Floats,
    mean: Floats,
    covariance: Floats,
) -> None:
    """Conversion ruv, linear.

    Mean: map from the measured quantities to coordinates. Covariance: covariance of the linearised
    conversion.
    """
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
    mean[..., 0] = r * u
    mean[..., 1] = r * v
    mean[..., 2] = r * root_1
    covariance[..., 0, 0] = r_squared * sigma_u_squared + sigma_r_squared * u_squared
    covariance[..., 0, 1] = r_squared * rho * sigma_u * sigma_v + sigma_r_squared * u * v
    covariance[..., 0, 2] = sum_2 * term_1
    covariance[..., 1, 0] = covariance[..., 0, 1]
    covariance[..., 1, 1] = r_squared * sigma_v_squared + sigma_r_squared * v_squared
    covariance[..., 1, 2] = sum_3 * term_1
    covariance[..., 2, 0] = covariance[..., 0, 2]
    covariance[..., 2, 1] = covariance[..., 1, 2]
    covariance[..., 2, 2] = sum_4 / root_1**2


def ruv_second_order(
    r: Floats,
    u: Floats,
    v: Floats,
    sigma_r: Floats,
    sigma_u: Floats,
    sigma_v: Floats,
    rho: Floats,
    mean: Floats,
    covariance: Floats,
) -> None:
    """Conversion ruv, second_order.

    Mean: map from the measured quantities to coordinates less the bias of the plain conversion to second
    order. Covariance: covariance of the conversion's quadratic Taylor polynomial.
    """
    u_squared = u**2
    v_squared = v**2
    root_1 = np.sqrt(1.0 - u_squared - v_squared)
    sigma_u_squared = sigma_u**2
    sum_1 = 1.0 + v
    sum_2 = v - 1.0
    sigma_v_squared = sigma_v**2
    sum_3 = 1.0 + u
    sum_4 = u - 1.0
    sum_5 = (
        0.5 * r * sigma_u_squared * sum_1 * sum_2
        - r * rho * sigma_u * sigma_v * u * v
        + 0.5 * r * sigma_v_squared * sum_3 * sum_4
    )
    r_squared = r**2
    sigma_r_squared = sigma_r**2
    sum_6 = u_squared - 1.0 + v_squared
    term_1 = 1.0 / root_1
    sum_7 = (
        -r_squared * rho * sigma_u * sigma_v * v
        - r_squared * sigma_u_squared * u
        - rho * sigma_r_squared * sigma_u * sigma_v * v
        - sigma_r_squared * sigma_u_squared * u
        - sigma_r_squared * sum_6 * u
    )
    sum_8 = (
        -r_squared * rho * sigma_u * sigma_v * u
        - r_squared * sigma_v_squared * v
        - rho * sigma_r_squared * sigma_u * sigma_v * u
        - sigma_r_squared * sigma_v_squared * v
        - sigma_r_squared * sum_6 * v
    )
    sum_6_squared = sum_6**2
    sum_9 = 1.0 - u_squared - v_squared + 2.0 * u_squared * v_squared
    sum_10 = (
        2.0 * r_squared * rho * sigma_u * sigma_v * sum_6_squared * u * v
        - 2.0 * r_squared * rho * sigma_u * sigma_u_squared * sigma_v * sum_1 * sum_2 * u * v
        - 2.0 * r_squared * rho * sigma_u * sigma_v * sigma_v_squared * sum_3 * sum_4 * u * v
        + 2.0 * rho * sigma_r_squared * sigma_u * sigma_v * sum_6_squared * u * v
        + 0.5 * r_squared * sigma_u_squared**2 * sum_1**2 * sum_2**2
        + r_squared * rho**2 * sigma_u_squared * sigma_v_squared * sum_9
        + r_squared * sigma_u_squared * sigma_v_squared * u_squared * v_squared
        + r_squared * sigma_u_squared * sum_6_squared * u_squared
        + 0.5 * r_squared * sigma_v_squared**2 * sum_3**2 * sum_4**2
        + r_squared * sigma_v_squared * sum_6_squared * v_squared
        + sigma_r_squared * sigma_u_squared * sum_6_squared * u_squared
        + sigma_r_squared * sigma_v_squared * sum_6_squared * v_squared
        + sigma_r_squared * sum_6_squared**2
    )
    mean[..., 0] = r * u
    mean[..., 1] = r * v
    mean[..., 2] = r * root_1 - sum_5 / (root_1 * root_1**2)
    covariance[..., 0, 0] = (
        r_squared * sigma_u_squared
        + sigma_r_squared * sigma_u_squared
        + sigma_r_squared * u_squared
    )
    covariance[..., 0, 1] = (
        r_squared * rho * sigma_u * sigma_v
        + rho * sigma_r_squared * sigma_u * sigma_v
        + sigma_r_squared * u * v
    )
    covariance[..., 0, 2] = sum_7 * term_1
    covariance[..., 1, 0] = covariance[..., 0, 1]
    covariance[..., 1, 1] = (
        r_squared * sigma_v_squared
        + sigma_r_squared * sigma_v_squared
        + sigma_r_squared * v_squared
    )
    covariance[..., 1, 2] = sum_8 * term_1
    covariance[..., 2, 0] = covariance[..., 0, 2]
    covariance[..., 2, 1] = covariance[..., 1, 2]
    covariance[..., 2, 2] = sum_10 / (root_1 * root_1**2)**2


def ruv_averaged(
    r: Floats,
    u: Floats,
    v: Floats,
    sigma_r: Floats,
    sigma_u: Floats,
    sigma_v: Floats,
    rho: Floats,
    mean: Floats,
    covariance: Floats,
) -> None:
    """Conversion ruv, averaged.

    Mean: map from the measured quantities to coordinates less the bias of the plain conversion, averaged over
    the truth, to fourth order. Covariance: covariance of the plain conversion, averaged over the truth, to
    fourth order.
    """
    u_squared = u**2
    v_squared = v**2
    root_1 = np.sqrt(1.0 - u_squared - v_squared)
    sum_1 = 3.0 - 3.0 * v_squared + 2.0 * u_squared
    sigma_u_squared = sigma_u**2
    product_1 = sigma_u * sigma_u_squared
    sigma_v_squared = sigma_v**2
    sigma_v_squared_squared = sigma_v_squared**2
    sum_2 = 1.0 + u
    sum_3 = u - 1.0
    sum_4 = u_squared - 1.0 - 4.0 * v_squared
    sum_5 = u_squared - 1.0 + v_squared
    sum_5_squared = sum_5**2
    u_squared_squared = u_squared**2
    v_squared_squared = v_squared**2
    sum_6 = (
        2.0 * u_squared_squared
        - 1.0
        - 11.0 * u_squared * v_squared
        - u_squared
        - v_squared
        + 2.0 * v_squared_squared
    )
    rho_squared = rho**2
    sum_7 = 3.0 * u_squared - 3.0 - 2.0 * v_squared
    product_2 = sigma_v * sigma_v_squared
    sum_8 = 1.0 - v_squared + 4.0 * u_squared
    sigma_u_squared_squared = sigma_u_squared**2
    sum_9 = 1.0 + v
    sum_10 = v - 1.0
    sum_11 = (
        1.5 * r * rho_squared * sigma_u_squared * sigma_v_squared * sum_6
        - 4.5 * product_1 * r * rho * sigma_v * sum_1 * u * v
        - 1.125 * r * sigma_v_squared_squared * sum_2 * sum_3 * sum_4
        - r * rho * sigma_u * sigma_v * sum_5_squared * u * v
        + 0.75 * r * sigma_u_squared * sigma_v_squared * sum_6
        + 4.5 * product_2 * r * rho * sigma_u * sum_7 * u * v
        + 1.125 * r * sigma_u_squared_squared * sum_10 * sum_8 * sum_9
        + 0.5 * r * sigma_u_squared * sum_10 * sum_5_squared * sum_9
        + 0.5 * r * sigma_v_squared * sum_2 * sum_3 * sum_5_squared
    )
    sigma_r_squared = sigma_r**2
    r_squared = r**2
    sum_12 = 1.0 - v_squared + 2.0 * u_squared
    sum_13 = 3.0 * v_squared - 3.0 + u_squared
    sum_14 = 3.0 * u_squared - 4.0 + 4.0 * v_squared
    product_3 = sum_5 * sum_5_squared
    sum_15 = u_squared - 1.0 - 2.0 * v_squared
    term_1 = 1.0 / (root_1 * (root_1**2)**2)
    sum_16 = (
        2.0 * r_squared * rho_squared * sigma_u_squared * sigma_v_squared * sum_15 * u
        - 3.0 * product_1 * r_squared * rho * sigma_v * sum_12 * v
        - product_3 * sigma_r_squared * u
        - r_squared * sigma_u_squared * sum_5_squared * u
        - r_squared * rho * sigma_u * sigma_v * sum_5_squared * v
        - sigma_r_squared * sigma_u_squared * sum_14 * sum_5 * u
        - sigma_r_squared * sigma_v_squared * sum_2 * sum_3 * sum_5 * u
        - rho * sigma_r_squared * sigma_u * sigma_v * sum_13 * sum_5 * v
        + 3.0 * product_2 * r_squared * rho * sigma_u * sum_2 * sum_3 * v
        + 3.0 * r_squared * sigma_u_squared_squared * sum_10 * sum_9 * u
        + r_squared * sigma_u_squared * sigma_v_squared * sum_15 * u
    )
    sum_17 = 3.0 * u_squared - 3.0 + v_squared
    sum_18 = 3.0 * v_squared - 4.0 + 4.0 * u_squared
    sum_19 = (
        3.0 * product_1 * r_squared * rho * sigma_v * sum_10 * sum_9 * u
        - 2.0 * r_squared * rho_squared * sigma_u_squared * sigma_v_squared * sum_12 * v
        - product_3 * sigma_r_squared * v
        - r_squared * sigma_u_squared * sigma_v_squared * sum_12 * v
        - r_squared * sigma_v_squared * sum_5_squared * v
        - r_squared * rho * sigma_u * sigma_v * sum_5_squared * u
        - sigma_r_squared * sigma_u_squared * sum_10 * sum_5 * sum_9 * v
        - sigma_r_squared * sigma_v_squared * sum_18 * sum_5 * v
        - rho * sigma_r_squared * sigma_u * sigma_v * sum_17 * sum_5 * u
        + 3.0 * product_2 * r_squared * rho * sigma_u * sum_15 * u
        + 3.0 * r_squared * sigma_v_squared_squared * sum_2 * sum_3 * v
    )
    sum_20 = (
        3.0
        - 4.0 * u_squared_squared
        - 4.0 * v_squared_squared
        + 22.0 * u_squared * v_squared
        + u_squared
        + v_squared
    )
    sum_21 = (
        11.0 * u_squared * v_squared
        - 2.0 * u_squared_squared
        - 2.0 * v_squared_squared
        + 2.0 * u_squared
        + 2.0 * v_squared
    )
    sum_22 = 2.0 * v_squared - 2.0 + 3.0 * u_squared
    sum_23 = 2.0 * u_squared - 2.0 + 3.0 * v_squared
    sum_24 = (
        2.0 * r_squared * rho * sigma_u * sigma_v * sum_5_squared * u * v
        - 1.5 * r_squared * sigma_u_squared_squared * sum_10 * sum_8 * sum_9
        - 6.0 * product_2 * r_squared * rho * sigma_u * sum_7 * u * v
        + 2.0 * rho * sigma_r_squared * sigma_u * sigma_v * sum_5_squared * u * v
        + 1.5 * r_squared * sigma_v_squared_squared * sum_2 * sum_3 * sum_4
        + 6.0 * product_1 * r_squared * rho * sigma_v * sum_1 * u * v
        + r_squared * rho_squared * sigma_u_squared * sigma_v_squared * sum_20
        + r_squared * sigma_u_squared * sigma_v_squared * sum_21
        + r_squared * sigma_u_squared * sum_5_squared * u_squared
        + r_squared * sigma_v_squared * sum_5_squared * v_squared
        + sigma_r_squared * sigma_u_squared * sum_22 * sum_5_squared
        + sigma_r_squared * sigma_v_squared * sum_23 * sum_5_squared
        + sigma_r_squared * sum_5_squared**2
    )
    mean[..., 0] = r * u
    mean[..., 1] = r * v
    mean[..., 2] = r * root_1 - sum_11 / (root_1 * (root_1 * root_1**2)**2)
    covariance[..., 0, 0] = (
        3.0 * sigma_r_squared * sigma_u_squared
        + r_squared * sigma_u_squared
        + sigma_r_squared * u_squared
    )
    covariance[..., 0, 1] = (
        3.0 * rho * sigma_r_squared * sigma_u * sigma_v
        + r_squared * rho * sigma_u * sigma_v
        + sigma_r_squared * u * v
    )
    covariance[..., 0, 2] = sum_16 * term_1
    covariance[..., 1, 0] = covariance[..., 0, 1]
    covariance[..., 1, 1] = (
        3.0 * sigma_r_squared * sigma_v_squared
        + r_squared * sigma_v_squared
        + sigma_r_squared * v_squared
    )
    covariance[..., 1, 2] = sum_19 * term_1
    covariance[..., 2, 0] = covariance[..., 0, 2]
    covariance[..., 2, 1] = covariance[..., 1, 2]
    covariance[..., 2, 2] = sum_24 / (root_1 * root_1**2)**2


def ruv_unbiased(
    r: Floats,
    u: Floats,
    v: Floats,
    sigma_r: Floats,
    sigma_u: Floats,
    sigma_v: Floats,
    rho: Floats,
    mean: Floats,
    covariance: Floats,
) -> None:
    """Conversion ruv, unbiased.

    Mean: unbiased estimate of the position, to fourth order. Covariance: error covariance of the unbiased
    estimate u, to fourth order.
    """
    u_squared = u**2
    v_squared = v**2
    root_1 = np.sqrt(1.0 - u_squared - v_squared)
    sigma_u_squared = sigma_u**2
    product_1 = sigma_u * sigma_u_squared
    sum_1 = 3.0 - 3.0 * v_squared + 2.0 * u_squared
    sigma_v_squared = sigma_v**2
    sigma_v_squared_squared = sigma_v_squared**2
    sum_2 = 1.0 + u
    sum_3 = u - 1.0
    sum_4 = u_squared - 1.0 - 4.0 * v_squared
    sum_5 = u_squared - 1.0 + v_squared
    sum_5_squared = sum_5**2
    sum_6 = 1.0 + v
    sum_7 = v - 1.0
    product_2 = sigma_v * sigma_v_squared
    sum_8 = 3.0 * u_squared - 3.0 - 2.0 * v_squared
    sigma_u_squared_squared = sigma_u_squared**2
    sum_9 = 1.0 - v_squared + 4.0 * u_squared
    sum_5_squared_squared = sum_5_squared**2
    u_squared_squared = u_squared**2
    v_squared_squared = v_squared**2
    sum_10 = (
        2.0 * u_squared_squared
        - 1.0
        - 11.0 * u_squared * v_squared
        - u_squared
        - v_squared
        + 2.0 * v_squared_squared
    )
    rho_squared = rho**2
    sum_11 = (
        1.5 * product_2 * r * rho * sigma_u * sum_8 * u * v
        - 1.5 * product_1 * r * rho * sigma_v * sum_1 * u * v
        - 0.375 * r * sigma_v_squared_squared * sum_2 * sum_3 * sum_4
        - 0.5 * r * sigma_u_squared * sum_5_squared * sum_6 * sum_7
        - 0.5 * r * sigma_v_squared * sum_2 * sum_3 * sum_5_squared
        + 0.375 * r * sigma_u_squared_squared * sum_6 * sum_7 * sum_9
        + 0.5 * r * rho_squared * sigma_u_squared * sigma_v_squared * sum_10
        + 0.25 * r * sigma_u_squared * sigma_v_squared * sum_10
        + r * rho * sigma_u * sigma_v * sum_5_squared * u * v
        + r * sum_5_squared_squared
    )
    r_squared = r**2
    sigma_r_squared = sigma_r**2
    sum_12 = 1.0 - v_squared + 2.0 * u_squared
    sum_13 = 2.0 * u_squared - 3.0 + 3.0 * v_squared
    product_3 = sum_5 * sum_5_squared
    sum_14 = u_squared - 1.0 - 2.0 * v_squared
    term_1 = 1.0 / (root_1 * (root_1**2)**2)
    sum_15 = (
        1.5 * product_2 * r_squared * rho * sigma_u * sum_2 * sum_3 * v
        - 1.5 * product_1 * r_squared * rho * sigma_v * sum_12 * v
        - product_3 * sigma_r_squared * u
        - r_squared * sigma_u_squared * sum_5_squared * u
        - r_squared * rho * sigma_u * sigma_v * sum_5_squared * v
        - 0.5 * sigma_r_squared * sigma_u_squared * sum_13 * sum_5 * u
        - 0.5 * sigma_r_squared * sigma_v_squared * sum_2 * sum_3 * sum_5 * u
        - rho * sigma_r_squared * sigma_u * sigma_v * sum_5 * sum_6 * sum_7 * v
        + 1.5 * r_squared * sigma_u_squared_squared * sum_6 * sum_7 * u
        + r_squared * rho_squared * sigma_u_squared * sigma_v_squared * sum_14 * u
        + 0.5 * r_squared * sigma_u_squared * sigma_v_squared * sum_14 * u
    )
    sum_16 = 2.0 * v_squared - 3.0 + 3.0 * u_squared
    sum_17 = (
        1.5 * product_1 * r_squared * rho * sigma_v * sum_6 * sum_7 * u
        - product_3 * sigma_r_squared * v
        - r_squared * rho_squared * sigma_u_squared * sigma_v_squared * sum_12 * v
        - 0.5 * r_squared * sigma_u_squared * sigma_v_squared * sum_12 * v
        - r_squared * sigma_v_squared * sum_5_squared * v
        - r_squared * rho * sigma_u * sigma_v * sum_5_squared * u
        - 0.5 * sigma_r_squared * sigma_u_squared * sum_5 * sum_6 * sum_7 * v
        - 0.5 * sigma_r_squared * sigma_v_squared * sum_16 * sum_5 * v
        - rho * sigma_r_squared * sigma_u * sigma_v * sum_2 * sum_3 * sum_5 * u
        + 1.5 * product_2 * r_squared * rho * sigma_u * sum_14 * u
        + 1.5 * r_squared * sigma_v_squared_squared * sum_2 * sum_3 * v
    )
    sum_18 = 2.0 * u_squared - 2.0 - v_squared
    sum_19 = 2.0 - 2.0 * v_squared + u_squared
    sum_20 = (
        1.0
        - 2.0 * u_squared_squared
        - 2.0 * v_squared_squared
        + 14.0 * u_squared * v_squared
        + u_squared
        + v_squared
    )
    sum_21 = 2.0 - u_squared - u_squared_squared - v_squared - v_squared_squared + 7.0 * u_squared * v_squared
    sum_22 = (
        2.0 * r_squared * rho * sigma_u * sigma_v * sum_5_squared * u * v
        - 1.5 * r_squared * sigma_u_squared_squared * sum_12 * sum_6 * sum_7
        - 6.0 * product_2 * r_squared * rho * sigma_u * sum_18 * u * v
        + 1.5 * r_squared * sigma_v_squared_squared * sum_14 * sum_2 * sum_3
        + 6.0 * product_1 * r_squared * rho * sigma_v * sum_19 * u * v
        + product_3 * sigma_r_squared * sigma_u_squared
        + product_3 * sigma_r_squared * sigma_v_squared
        + r_squared * rho_squared * sigma_u_squared * sigma_v_squared * sum_20
        + r_squared * sigma_u_squared * sigma_v_squared * sum_21
        + r_squared * sigma_u_squared * sum_5_squared * u_squared
        + r_squared * sigma_v_squared * sum_5_squared * v_squared
        + sigma_r_squared * sum_5_squared_squared
    )
    mean[..., 0] = r * u
    mean[..., 1] = r * v
    mean[..., 2] = sum_11 / (root_1 * (root_1 * root_1**2)**2)
    covariance[..., 0, 0] = (
        r_squared * sigma_u_squared
        + sigma_r_squared * sigma_u_squared
        + sigma_r_squared * u_squared
    )
    covariance[..., 0, 1] = (
        r_squared * rho * sigma_u * sigma_v
        + rho * sigma_r_squared * sigma_u * sigma_v
        + sigma_r_squared * u * v
    )
    covariance[..., 0, 2] = sum_15 * term_1
    covariance[..., 1, 0] = covariance[..., 0, 1]
    covariance[..., 1, 1] = (
        r_squared * sigma_v_squared
        + sigma_r_squared * sigma_v_squared
        + sigma_r_squared * v_squared
    )
    covariance[..., 1, 2] = sum_17 * term_1
    covariance[..., 2, 0] = covariance[..., 0, 2]
    covariance[..., 2, 1] = covariance[..., 1, 2]
    covariance[..., 2, 2] = sum_22 / (root_1 * root_1**2)**2


def ruv_posterior(
    r: Floats,
    u: Floats,
    v: Floats,
    sigma_r: Floats,
    sigma_u: Floats,
    sigma_v: Floats,
    rho: Floats,
    mean: Floats,
    covariance: Floats,
) -> None:
    """Conversion ruv, posterior.

    Mean: posterior mean of the position under a flat prior, to fourth order. Covariance: posterior covariance
    of the position under a flat prior, to fourth order.
    """
    u_squared = u**2
    v_squared = v**2
    root_1 = np.sqrt(1.0 - u_squared - v_squared)
    sigma_u_squared = sigma_u**2
    product_1 = sigma_u * sigma_u_squared
    sum_1 = 3.0 - 3.0 * v_squared + 2.0 * u_squared
    sigma_v_squared = sigma_v**2
    sigma_v_squared_squared = sigma_v_squared**2
    sum_2 = 1.0 + u
    sum_3 = u - 1.0
    sum_4 = u_squared - 1.0 - 4.0 * v_squared
    sum_5 = u_squared - 1.0 + v_squared
    sum_5_squared = sum_5**2
    product_2 = sigma_v * sigma_v_squared
    sum_6 = 3.0 * u_squared - 3.0 - 2.0 * v_squared
    sigma_u_squared_squared = sigma_u_squared**2
    sum_7 = 1.0 + v
    sum_8 = v - 1.0
    sum_9 = 1.0 - v_squared + 4.0 * u_squared
    sum_5_squared_squared = sum_5_squared**2
    u_squared_squared = u_squared**2
    v_squared_squared = v_squared**2
    sum_10 = (
        2.0 * u_squared_squared
        - 1.0
        - 11.0 * u_squared * v_squared
        - u_squared
        - v_squared
        + 2.0 * v_squared_squared
    )
    rho_squared = rho**2
    sum_11 = (
        1.5 * product_2 * r * rho * sigma_u * sum_6 * u * v
        - 1.5 * product_1 * r * rho * sigma_v * sum_1 * u * v
        - 0.375 * r * sigma_v_squared_squared * sum_2 * sum_3 * sum_4
        - r * rho * sigma_u * sigma_v * sum_5_squared * u * v
        + 0.375 * r * sigma_u_squared_squared * sum_7 * sum_8 * sum_9
        + 0.5 * r * rho_squared * sigma_u_squared * sigma_v_squared * sum_10
        + 0.25 * r * sigma_u_squared * sigma_v_squared * sum_10
        + 0.5 * r * sigma_u_squared * sum_5_squared * sum_7 * sum_8
        + 0.5 * r * sigma_v_squared * sum_2 * sum_3 * sum_5_squared
        + r * sum_5_squared_squared
    )
    r_squared = r**2
    sigma_r_squared = sigma_r**2
    sum_12 = 1.0 - v_squared + 2.0 * u_squared
    sum_13 = 2.0 * u_squared - 3.0 + 3.0 * v_squared
    product_3 = sum_5 * sum_5_squared
    sum_14 = u_squared - 1.0 - 2.0 * v_squared
    term_1 = 1.0 / (root_1 * (root_1**2)**2)
    sum_15 = (
        1.5 * product_2 * r_squared * rho * sigma_u * sum_2 * sum_3 * v
        - 1.5 * product_1 * r_squared * rho * sigma_v * sum_12 * v
        - product_3 * sigma_r_squared * u
        - r_squared * sigma_u_squared * sum_5_squared * u
        - r_squared * rho * sigma_u * sigma_v * sum_5_squared * v
        - 0.5 * sigma_r_squared * sigma_u_squared * sum_13 * sum_5 * u
        - 0.5 * sigma_r_squared * sigma_v_squared * sum_2 * sum_3 * sum_5 * u
        - rho * sigma_r_squared * sigma_u * sigma_v * sum_5 * sum_7 * sum_8 * v
        + 1.5 * r_squared * sigma_u_squared_squared * sum_7 * sum_8 * u
        + r_squared * rho_squared * sigma_u_squared * sigma_v_squared * sum_14 * u
        + 0.5 * r_squared * sigma_u_squared * sigma_v_squared * sum_14 * u
    )
    sum_16 = 2.0 * v_squared - 3.0 + 3.0 * u_squared
    sum_17 = (
        1.5 * product_1 * r_squared * rho * sigma_v * sum_7 * sum_8 * u
        - product_3 * sigma_r_squared * v
        - r_squared * rho_squared * sigma_u_squared * sigma_v_squared * sum_12 * v
        - 0.5 * r_squared * sigma_u_squared * sigma_v_squared * sum_12 * v
        - r_squared * sigma_v_squared * sum_5_squared * v
        - r_squared * rho * sigma_u * sigma_v * sum_5_squared * u
        - 0.5 * sigma_r_squared * sigma_u_squared * sum_5 * sum_7 * sum_8 * v
        - 0.5 * sigma_r_squared * sigma_v_squared * sum_16 * sum_5 * v
        - rho * sigma_r_squared * sigma_u * sigma_v * sum_2 * sum_3 * sum_5 * u
        + 1.5 * product_2 * r_squared * rho * sigma_u * sum_14 * u
        + 1.5 * r_squared * sigma_v_squared_squared * sum_2 * sum_3 * v
    )
    sum_18 = 4.0 * u_squared - 4.0 - 3.0 * v_squared
    sum_19 = 1.0 - v_squared + 6.0 * u_squared
    sum_20 = 4.0 - 4.0 * v_squared + 3.0 * u_squared
    sum_21 = (
        1.0
        - 2.0 * u_squared_squared
        - 2.0 * v_squared_squared
        + 10.0 * u_squared * v_squared
        + u_squared
        + v_squared
    )
    sum_22 = 5.0 * u_squared * v_squared - u_squared_squared - v_squared_squared + u_squared + v_squared
    sum_23 = u_squared - 1.0 - 6.0 * v_squared
    sum_24 = (
        2.0 * product_1 * r_squared * rho * sigma_v * sum_20 * u * v
        - 2.0 * product_2 * r_squared * rho * sigma_u * sum_18 * u * v
        - 0.5 * r_squared * sigma_u_squared_squared * sum_19 * sum_7 * sum_8
        + 2.0 * r_squared * rho * sigma_u * sigma_v * sum_5_squared * u * v
        + product_3 * sigma_r_squared * sigma_u_squared
        + product_3 * sigma_r_squared * sigma_v_squared
        + r_squared * rho_squared * sigma_u_squared * sigma_v_squared * sum_21
        + r_squared * sigma_u_squared * sigma_v_squared * sum_22
        + r_squared * sigma_u_squared * sum_5_squared * u_squared
        + r_squared * sigma_v_squared * sum_5_squared * v_squared
        + 0.5 * r_squared * sigma_v_squared_squared * sum_2 * sum_23 * sum_3
        + sigma_r_squared * sum_5_squared_squared
    )
    mean[..., 0] = r * u
    mean[..., 1] = r * v
    mean[..., 2] = sum_11 / (root_1 * (root_1 * root_1**2)**2)
    covariance[..., 0, 0] = (
        r_squared * sigma_u_squared
        + sigma_r_squared * sigma_u_squared
        + sigma_r_squared * u_squared
    )
    covariance[..., 0, 1] = (
        r_squared * rho * sigma_u * sigma_v
        + rho * sigma_r_squared * sigma_u * sigma_v
        + sigma_r_squared * u * v
    )
    covariance[..., 0, 2] = sum_15 * term_1
    covariance[..., 1, 0] = covariance[..., 0, 1]
    covariance[..., 1, 1] = (
        r_squared * sigma_v_squared
        + sigma_r_squared * sigma_v_squared
        + sigma_r_squared * v_squared
    )
    covariance[..., 1, 2] = sum_17 * term_1
    covariance[..., 2, 0] = covariance[..., 0, 2]
    covariance[..., 2, 1] = covariance[..., 1, 2]
    covariance[..., 2, 2] = sum_24 / (root_1 * root_1**2)**2


def spherical_linear(
    r: Floats,
    beta: Floats,
    epsilon: Floats,
    sigma_r: Floats,
    sigma_beta: Floats,
    sigma_epsilon: Floats,
    rho: Floats,
    mean: Floats,
    covariance: Floats,
) -> None:
    """Conversion spherical, linear.

    Mean: map from the measured quantities to coordinates. Covariance: covariance of the linearised
    conversion.
    """
    cos_beta = np.cos(beta)
    sin_beta = np.sin(beta)
    cos_epsilon = np.cos(epsilon)
    sin_epsilon = np.sin(epsilon)
    r_squared = r**2
    sigma_beta_squared = sigma_beta**2
    part_00_cos_beta2_cos_epsilon2 = r_squared * sigma_beta_squared
    part_00_cos_beta_cos_epsilon2_sin_beta = 2.0 * r * rho * sigma_beta * sigma_r
    sigma_epsilon_squared = sigma_epsilon**2
    part_00_sin_beta2_sin_epsilon2 = r_squared * sigma_epsilon_squared
    part_01_cos_beta2_cos_epsilon2 = r * rho * sigma_beta * sigma_r
    sigma_r_squared = sigma_r**2
    part_01_cos_beta_cos_epsilon2_sin_beta = sigma_r_squared - r_squared * sigma_beta_squared
    part_02_cos_epsilon_sin_beta_sin_epsilon = sigma_r_squared - r_squared * sigma_epsilon_squared
    cos_beta_squared = cos_beta**2
    cos_epsilon_squared = cos_epsilon**2
    sin_beta_squared = sin_beta**2
    sin_epsilon_squared = sin_epsilon**2
    mean[..., 0] = cos_epsilon * r * sin_beta
    mean[..., 1] = cos_beta * cos_epsilon * r
    mean[..., 2] = r * sin_epsilon
    covariance[..., 0, 0] = (
        cos_beta * cos_epsilon_squared * part_00_cos_beta_cos_epsilon2_sin_beta * sin_beta
        + cos_beta_squared * cos_epsilon_squared * part_00_cos_beta2_cos_epsilon2
        + cos_epsilon_squared * sigma_r_squared * sin_beta_squared
        + part_00_sin_beta2_sin_epsilon2 * sin_beta_squared * sin_epsilon_squared
    )
    covariance[..., 0, 1] = (
        cos_beta * cos_epsilon_squared * part_01_cos_beta_cos_epsilon2_sin_beta * sin_beta
        - cos_epsilon_squared * part_01_cos_beta2_cos_epsilon2 * sin_beta_squared
        + cos_beta * part_00_sin_beta2_sin_epsilon2 * sin_beta * sin_epsilon_squared
        + cos_beta_squared * cos_epsilon_squared * part_01_cos_beta2_cos_epsilon2
    )
    covariance[..., 0, 2] = (
        cos_beta * cos_epsilon * part_01_cos_beta2_cos_epsilon2 * sin_epsilon
        + cos_epsilon * part_02_cos_epsilon_sin_beta_sin_epsilon * sin_beta * sin_epsilon
    )
    covariance[..., 1, 0] = covariance[..., 0, 1]
    covariance[..., 1, 1] = (
        cos_beta_squared * cos_epsilon_squared * sigma_r_squared
        - cos_beta * cos_epsilon_squared * part_00_cos_beta_cos_epsilon2_sin_beta * sin_beta
        + cos_beta_squared * part_00_sin_beta2_sin_epsilon2 * sin_epsilon_squared
        + cos_epsilon_squared * part_00_cos_beta2_cos_epsilon2 * sin_beta_squared
    )
    covariance[..., 1, 2] = (
        cos_beta * cos_epsilon * part_02_cos_epsilon_sin_beta_sin_epsilon * sin_epsilon
        - cos_epsilon * part_01_cos_beta2_cos_epsilon2 * sin_beta * sin_epsilon
    )
    covariance[..., 2, 0] = covariance[..., 0, 2]
    covariance[..., 2, 1] = covariance[..., 1, 2]
    covariance[..., 2, 2] = (
        cos_epsilon_squared * part_00_sin_beta2_sin_epsilon2
        + sigma_r_squared * sin_epsilon_squared
    )


def spherical_second_order(
    r: Floats,
    beta: Floats,
    epsilon: Floats,
    sigma_r: Floats,
    sigma_beta: Floats,
    sigma_epsilon: Floats,
    rho: Floats,
    mean: Floats,
    covariance: Floats,
) -> None:
    """Conversion spherical, second_order.

    Mean: map from the measured quantities to coordinates less the bias of the plain conversion to second
    order. Covariance: covariance of the conversion's quadratic Taylor polynomial.
    """
    cos_beta = np.cos(beta)
    sin_beta = np.sin(beta)
    cos_epsilon = np.cos(epsilon)
    sin_epsilon = np.sin(epsilon)
    part_0_cos_beta_cos_epsilon = rho * sigma_beta * sigma_r
    sigma_beta_squared = sigma_beta**2
    sigma_epsilon_squared = sigma_epsilon**2
    part_0_cos_epsilon_sin_beta = -0.5 * r * sigma_beta_squared - 0.5 * r * sigma_epsilon_squared
    r_squared = r**2
    rho_squared = rho**2
    sigma_r_squared = sigma_r**2
    part_00_cos_beta2_cos_epsilon2 = (
        r_squared * sigma_beta_squared
        + rho_squared * sigma_beta_squared * sigma_r_squared
        + sigma_beta_squared * sigma_r_squared
    )
    part_00_cos_beta2_sin_epsilon2 = r_squared * sigma_beta_squared * sigma_epsilon_squared
    product_1 = sigma_beta * sigma_beta_squared
    part_00_cos_beta_cos_epsilon2_sin_beta = (
        2.0 * r * rho * sigma_beta * sigma_r
        - 2.0 * product_1 * r * rho * sigma_r
    )
    part_00_cos_beta_sin_beta_sin_epsilon2 = 2.0 * r * rho * sigma_beta * sigma_epsilon_squared * sigma_r
    product_2 = 0.5 * r_squared * sigma_beta_squared**2
    product_3 = 0.5 * r_squared * sigma_epsilon_squared**2
    part_00_cos_epsilon2_sin_beta2 = product_2 + product_3 + sigma_r_squared
    product_4 = r_squared * sigma_epsilon_squared
    product_5 = sigma_epsilon_squared * sigma_r_squared
    part_00_sin_beta2_sin_epsilon2 = product_4 + product_5
    product_6 = r * rho * sigma_beta * sigma_r
    part_01_cos_beta2_cos_epsilon2 = product_6 - product_1 * r * rho * sigma_r
    part_01_cos_beta2_sin_epsilon2 = r * rho * sigma_beta * sigma_epsilon_squared * sigma_r
    part_01_cos_beta_cos_epsilon2_sin_beta = (
        product_2
        - r_squared * sigma_beta_squared
        - rho_squared * sigma_beta_squared * sigma_r_squared
        - sigma_beta_squared * sigma_r_squared
        + product_3
        + sigma_r_squared
    )
    part_01_cos_beta_sin_beta_sin_epsilon2 = (
        product_4
        - r_squared * sigma_beta_squared * sigma_epsilon_squared
        + product_5
    )
    part_02_cos_beta_cos_epsilon_sin_epsilon = (
        product_6
        - r * rho * sigma_beta * sigma_epsilon_squared * sigma_r
    )
    part_02_cos_epsilon_sin_beta_sin_epsilon = (
        product_3
        - r_squared * sigma_epsilon_squared
        - sigma_epsilon_squared * sigma_r_squared
        + sigma_r_squared
    )
    part_22_sin_epsilon2 = product_3 + sigma_r_squared
    cos_beta_squared = cos_beta**2
    cos_epsilon_squared = cos_epsilon**2
    sin_epsilon_squared = sin_epsilon**2
    sin_beta_squared = sin_beta**2
    mean[..., 0] = (
        cos_epsilon * r * sin_beta
        - cos_beta * cos_epsilon * part_0_cos_beta_cos_epsilon
        - cos_epsilon * part_0_cos_epsilon_sin_beta * sin_beta
    )
    mean[..., 1] = (
        cos_beta * cos_epsilon * r
        - cos_beta * cos_epsilon * part_0_cos_epsilon_sin_beta
        + cos_epsilon * part_0_cos_beta_cos_epsilon * sin_beta
    )
    mean[..., 2] = 0.5 * r * sigma_epsilon_squared * sin_epsilon + r * sin_epsilon
    covariance[..., 0, 0] = (
        cos_beta * cos_epsilon_squared * part_00_cos_beta_cos_epsilon2_sin_beta * sin_beta
        + cos_beta * part_00_cos_beta_sin_beta_sin_epsilon2 * sin_beta * sin_epsilon_squared
        + cos_beta_squared * cos_epsilon_squared * part_00_cos_beta2_cos_epsilon2
        + cos_beta_squared * part_00_cos_beta2_sin_epsilon2 * sin_epsilon_squared
        + cos_epsilon_squared * part_00_cos_epsilon2_sin_beta2 * sin_beta_squared
        + part_00_sin_beta2_sin_epsilon2 * sin_beta_squared * sin_epsilon_squared
    )
    covariance[..., 0, 1] = (
        cos_beta * cos_epsilon_squared * part_01_cos_beta_cos_epsilon2_sin_beta * sin_beta
        - cos_epsilon_squared * part_01_cos_beta2_cos_epsilon2 * sin_beta_squared
        - part_01_cos_beta2_sin_epsilon2 * sin_beta_squared * sin_epsilon_squared
        + cos_beta * part_01_cos_beta_sin_beta_sin_epsilon2 * sin_beta * sin_epsilon_squared
        + cos_beta_squared * cos_epsilon_squared * part_01_cos_beta2_cos_epsilon2
        + cos_beta_squared * part_01_cos_beta2_sin_epsilon2 * sin_epsilon_squared
    )
    covariance[..., 0, 2] = (
        cos_beta * cos_epsilon * part_02_cos_beta_cos_epsilon_sin_epsilon * sin_epsilon
        + cos_epsilon * part_02_cos_epsilon_sin_beta_sin_epsilon * sin_beta * sin_epsilon
    )
    covariance[..., 1, 0] = covariance[..., 0, 1]
    covariance[..., 1, 1] = (
        cos_beta_squared * cos_epsilon_squared * part_00_cos_epsilon2_sin_beta2
        - cos_beta * cos_epsilon_squared * part_00_cos_beta_cos_epsilon2_sin_beta * sin_beta
        - cos_beta * part_00_cos_beta_sin_beta_sin_epsilon2 * sin_beta * sin_epsilon_squared
        + cos_beta_squared * part_00_sin_beta2_sin_epsilon2 * sin_epsilon_squared
        + cos_epsilon_squared * part_00_cos_beta2_cos_epsilon2 * sin_beta_squared
        + part_00_cos_beta2_sin_epsilon2 * sin_beta_squared * sin_epsilon_squared
    )
    covariance[..., 1, 2] = (
        cos_beta * cos_epsilon * part_02_cos_epsilon_sin_beta_sin_epsilon * sin_epsilon
        - cos_epsilon * part_02_cos_beta_cos_epsilon_sin_epsilon * sin_beta * sin_epsilon
    )
    covariance[..., 2, 0] = covariance[..., 0, 2]
    covariance[..., 2, 1] = covariance[..., 1, 2]
    covariance[..., 2, 2] = (
        cos_epsilon_squared * part_00_sin_beta2_sin_epsilon2
        + part_22_sin_epsilon2 * sin_epsilon_squared
    )


def spherical_averaged(
    r: Floats,
    beta: Floats,
    epsilon: Floats,
    sigma_r: Floats,
    sigma_beta: Floats,
    sigma_epsilon: Floats,
    rho: Floats,
    mean: Floats,
    covariance: Floats,
) -> None:
    """Conversion spherical, averaged.

    Mean: map from the measured quantities to coordinates less the exact bias of the plain conversion,
    averaged over the truth. Covariance: exact covariance of the plain conversion, averaged over the truth.
    """
    cos_beta = np.cos(beta)
    sin_beta = np.sin(beta)
    cos_epsilon = np.cos(epsilon)
    sin_epsilon = np.sin(epsilon)
    sigma_beta_squared = sigma_beta**2
    attenuation_beta = np.exp(-0.5 * sigma_beta_squared)
    shortfall_beta = -np.expm1(-0.5 * sigma_beta_squared)
    sigma_epsilon_squared = sigma_epsilon**2
    attenuation_epsilon = np.exp(-0.5 * sigma_epsilon_squared)
    shortfall_epsilon = -np.expm1(-0.5 * sigma_epsilon_squared)
    product_1 = shortfall_beta * shortfall_epsilon
    sum_1 = product_1 - shortfall_beta - shortfall_epsilon
    part_0_cos_epsilon_sin_beta = attenuation_beta * attenuation_epsilon * r * sum_1
    attenuation_beta_2 = np.exp(-sigma_beta_squared)
    shortfall_beta_2 = -np.expm1(-sigma_beta_squared)
    attenuation_epsilon_2 = np.exp(-sigma_epsilon_squared)
    shortfall_epsilon_2 = -np.expm1(-sigma_epsilon_squared)
    attenuation_beta_2_squared = attenuation_beta_2**2
    shortfall_epsilon_2_squared = shortfall_epsilon_2**2
    product_2 = shortfall_epsilon_2 * shortfall_epsilon_2_squared
    attenuation_epsilon_2_squared = attenuation_epsilon_2**2
    product_3 = attenuation_epsilon_2 * attenuation_epsilon_2_squared
    shortfall_beta_2_squared = shortfall_beta_2**2
    product_4 = -12.0 * attenuation_beta_2 * product_3 * shortfall_beta_2_squared * shortfall_epsilon_2
    attenuation_epsilon_2_squared_squared = attenuation_epsilon_2_squared**2
    product_5 = shortfall_beta_2 * shortfall_beta_2_squared
    product_6 = -2.0 * attenuation_epsilon_2_squared_squared * product_5
    product_7 = -3.0 * attenuation_beta_2 * attenuation_epsilon_2 * product_2 * shortfall_beta_2_squared
    product_8 = -3.0 * attenuation_epsilon_2_squared * product_5 * shortfall_epsilon_2_squared
    product_9 = -4.0 * product_3 * product_5 * shortfall_epsilon_2
    product_10 = -6.0 * attenuation_beta_2 * attenuation_epsilon_2_squared_squared * shortfall_beta_2_squared
    product_11 = -9.0 * attenuation_beta_2 * attenuation_epsilon_2_squared * shortfall_beta_2_squared * shortfall_epsilon_2_squared
    product_12 = -attenuation_epsilon_2 * product_2 * product_5
    product_13 = attenuation_beta_2 * attenuation_beta_2_squared
    shortfall_epsilon_2_squared_squared = shortfall_epsilon_2_squared**2
    rho_squared = rho**2
    sigma_r_squared = sigma_r**2
    sum_2 = (
        12.0 * attenuation_epsilon_2_squared_squared * product_13
        - 12.0 * attenuation_beta_2_squared * attenuation_epsilon_2 * product_2 * shortfall_beta_2
        - 24.0 * attenuation_beta_2_squared * attenuation_epsilon_2_squared_squared * shortfall_beta_2
        - 36.0 * attenuation_beta_2_squared * attenuation_epsilon_2_squared * shortfall_beta_2 * shortfall_epsilon_2_squared
        - 48.0 * attenuation_beta_2_squared * product_3 * shortfall_beta_2 * shortfall_epsilon_2
        + 16.0 * product_13 * shortfall_epsilon_2_squared_squared
        + 24.0 * product_13 * product_3 * shortfall_epsilon_2
        + 54.0 * attenuation_epsilon_2 * product_13 * product_2
        + 66.0 * attenuation_epsilon_2_squared * product_13 * shortfall_epsilon_2_squared
        + product_10
        + product_11
        + product_12
        + product_4
        + product_6
        + product_7
        + product_8
        + product_9
    )
    product_14 = -attenuation_beta_2_squared * attenuation_epsilon_2
    product_15 = -attenuation_beta_2_squared * product_3
    product_16 = -attenuation_beta_2 * attenuation_epsilon_2
    product_17 = -attenuation_beta_2 * product_3
    r_squared = r**2
    sum_3 = (
        1.0
        + attenuation_beta_2
        + attenuation_beta_2 * attenuation_epsilon_2_squared_squared
        + attenuation_beta_2_squared
        + attenuation_beta_2_squared * attenuation_epsilon_2_squared_squared
        + attenuation_epsilon_2_squared_squared
        + attenuation_epsilon_2_squared_squared * product_13
        + product_13
        + product_14
        + product_15
        + product_16
        + product_17
    )
    product_18 = 2.0 * attenuation_beta_2 * attenuation_epsilon_2_squared_squared
    sum_4 = (
        2.0
        + 2.0 * attenuation_beta_2
        + 2.0 * attenuation_beta_2_squared
        + 2.0 * attenuation_beta_2_squared * attenuation_epsilon_2_squared_squared
        + 2.0 * attenuation_epsilon_2_squared_squared
        + 2.0 * attenuation_epsilon_2_squared_squared * product_13
        + 2.0 * product_13
        + product_14
        + product_15
        + product_16
        + product_17
        + product_18
    )
    part_00_cos_beta2_cos_epsilon2 = (
        0.25 * attenuation_beta_2 * rho_squared * sigma_beta_squared * sigma_r_squared * sum_2
        + 0.25 * r_squared * shortfall_beta_2 * sum_3
        + 0.25 * shortfall_beta_2 * sigma_r_squared * sum_4
    )
    sum_5 = (
        16.0 * product_13 * product_2
        - 12.0 * attenuation_beta_2_squared * attenuation_epsilon_2 * shortfall_beta_2 * shortfall_epsilon_2_squared
        - 2.0 * product_3 * product_5
        - 24.0 * attenuation_beta_2_squared * product_3 * shortfall_beta_2
        - 3.0 * attenuation_beta_2 * attenuation_epsilon_2 * shortfall_beta_2_squared * shortfall_epsilon_2_squared
        - 3.0 * attenuation_epsilon_2_squared * product_5 * shortfall_epsilon_2
        - 36.0 * attenuation_beta_2_squared * attenuation_epsilon_2_squared * shortfall_beta_2 * shortfall_epsilon_2
        - 6.0 * attenuation_beta_2 * product_3 * shortfall_beta_2_squared
        - 9.0 * attenuation_beta_2 * attenuation_epsilon_2_squared * shortfall_beta_2_squared * shortfall_epsilon_2
        - attenuation_epsilon_2 * product_5 * shortfall_epsilon_2_squared
        + 44.0 * product_13 * product_3
        + 54.0 * attenuation_epsilon_2 * product_13 * shortfall_epsilon_2_squared
        + 66.0 * attenuation_epsilon_2_squared * product_13 * shortfall_epsilon_2
    )
    sum_6 = (
        1.0
        + attenuation_beta_2
        + attenuation_beta_2 * product_3
        + attenuation_beta_2_squared
        + attenuation_beta_2_squared * product_3
        + attenuation_epsilon_2
        + attenuation_epsilon_2 * product_13
        + attenuation_epsilon_2_squared
        + attenuation_epsilon_2_squared * product_13
        + product_13
        + product_13 * product_3
        + product_3
    )
    product_19 = 2.0 * attenuation_beta_2 * product_3
    sum_7 = (
        2.0
        + 2.0 * attenuation_beta_2
        + 2.0 * attenuation_beta_2_squared
        + 2.0 * attenuation_beta_2_squared * product_3
        + 2.0 * attenuation_epsilon_2
        + 2.0 * attenuation_epsilon_2 * product_13
        + 2.0 * attenuation_epsilon_2_squared
        + 2.0 * attenuation_epsilon_2_squared * product_13
        + 2.0 * product_13
        + 2.0 * product_13 * product_3
        + 2.0 * product_3
        + attenuation_beta_2 * attenuation_epsilon_2
        + attenuation_beta_2 * attenuation_epsilon_2_squared
        + attenuation_beta_2_squared * attenuation_epsilon_2
        + attenuation_beta_2_squared * attenuation_epsilon_2_squared
        + product_19
    )
    part_00_cos_beta2_sin_epsilon2 = (
        0.25 * attenuation_beta_2 * rho_squared * shortfall_epsilon_2 * sigma_beta_squared * sigma_r_squared * sum_5
        + 0.25 * r_squared * shortfall_beta_2 * shortfall_epsilon_2 * sum_6
        + 0.25 * shortfall_beta_2 * shortfall_epsilon_2 * sigma_r_squared * sum_7
    )
    sum_8 = (
        12.0 * attenuation_beta_2_squared * attenuation_epsilon_2_squared_squared * shortfall_beta_2
        - 16.0 * attenuation_epsilon_2_squared_squared * product_13
        - 16.0 * product_13 * shortfall_epsilon_2_squared_squared
        - 32.0 * product_13 * product_3 * shortfall_epsilon_2
        - 56.0 * attenuation_epsilon_2 * product_13 * product_2
        - 72.0 * attenuation_epsilon_2_squared * product_13 * shortfall_epsilon_2_squared
        + 18.0 * attenuation_beta_2_squared * attenuation_epsilon_2_squared * shortfall_beta_2 * shortfall_epsilon_2_squared
        + 24.0 * attenuation_beta_2_squared * product_3 * shortfall_beta_2 * shortfall_epsilon_2
        + 6.0 * attenuation_beta_2_squared * attenuation_epsilon_2 * product_2 * shortfall_beta_2
        + product_10
        + product_11
        + product_12
        + product_4
        + product_6
        + product_7
        + product_8
        + product_9
    )
    attenuation_beta_2_squared_squared = attenuation_beta_2_squared**2
    shortfall_beta_2_squared_squared = shortfall_beta_2_squared**2
    sum_9 = (
        3.75 * attenuation_beta_2 * attenuation_epsilon_2 * product_2 * product_5
        + 5.25 * attenuation_beta_2 * attenuation_epsilon_2_squared * product_5 * shortfall_epsilon_2_squared
        + 5.25 * attenuation_beta_2_squared * attenuation_epsilon_2 * product_2 * shortfall_beta_2_squared
        + 6.75 * attenuation_beta_2_squared * attenuation_epsilon_2_squared * shortfall_beta_2_squared * shortfall_epsilon_2_squared
        + 1.5 * attenuation_beta_2 * attenuation_epsilon_2_squared_squared * product_5
        + 3.0 * attenuation_beta_2 * product_3 * product_5 * shortfall_epsilon_2
        + 1.5 * attenuation_beta_2_squared * attenuation_epsilon_2_squared_squared * shortfall_beta_2_squared
        + 3.0 * attenuation_beta_2_squared * product_3 * shortfall_beta_2_squared * shortfall_epsilon_2
        + 1.5 * attenuation_beta_2_squared * shortfall_beta_2_squared * shortfall_epsilon_2_squared_squared
        + 1.5 * attenuation_beta_2_squared_squared * attenuation_epsilon_2 * product_2
        + 1.5 * attenuation_beta_2_squared_squared * attenuation_epsilon_2_squared * shortfall_epsilon_2_squared
        + 3.0 * attenuation_epsilon_2 * product_13 * product_2 * shortfall_beta_2
        + 3.0 * attenuation_epsilon_2_squared * product_13 * shortfall_beta_2 * shortfall_epsilon_2_squared
        + 1.5 * attenuation_epsilon_2_squared * shortfall_beta_2_squared_squared * shortfall_epsilon_2_squared
        + attenuation_beta_2 * product_5 * shortfall_epsilon_2_squared_squared
        + 0.5 * attenuation_beta_2_squared_squared * shortfall_epsilon_2_squared_squared
        + attenuation_epsilon_2 * product_2 * shortfall_beta_2_squared_squared
        + 0.5 * attenuation_epsilon_2_squared_squared * shortfall_beta_2_squared_squared
        + product_13 * shortfall_beta_2 * shortfall_epsilon_2_squared_squared
        + product_3 * shortfall_beta_2_squared_squared * shortfall_epsilon_2
        + 0.25 * shortfall_beta_2_squared_squared * shortfall_epsilon_2_squared_squared
    )
    sum_10 = (
        0.5
        - 0.25 * attenuation_beta_2 * attenuation_epsilon_2
        - 0.25 * attenuation_beta_2 * product_3
        - 0.25 * attenuation_epsilon_2 * product_13
        - 0.25 * product_13 * product_3
        + 0.5 * attenuation_beta_2_squared_squared * attenuation_epsilon_2_squared_squared
        + 0.5 * attenuation_beta_2_squared_squared
        + 0.5 * attenuation_epsilon_2_squared_squared
    )
    part_00_cos_epsilon2_sin_beta2 = (
        0.25 * attenuation_beta_2 * rho_squared * sigma_beta_squared * sigma_r_squared * sum_8
        + r_squared * sum_9
        + sigma_r_squared * sum_10
    )
    sum_11 = (
        9.0 * attenuation_beta_2_squared * attenuation_epsilon_2
        - 16.0 * attenuation_epsilon_2 * product_13
        - 16.0 * attenuation_epsilon_2_squared * product_13
        - 16.0 * product_13
        - 16.0 * product_13 * product_3
        - attenuation_epsilon_2
        - attenuation_epsilon_2_squared
        + 9.0 * attenuation_beta_2_squared * attenuation_epsilon_2_squared
    )
    product_20 = -attenuation_epsilon_2 * product_13
    product_21 = -attenuation_epsilon_2_squared * product_13
    product_22 = -attenuation_beta_2 * attenuation_epsilon_2_squared
    sum_12 = (
        1.0
        + attenuation_beta_2_squared_squared
        + attenuation_beta_2_squared_squared * attenuation_epsilon_2
        + attenuation_beta_2_squared_squared * attenuation_epsilon_2_squared
        + attenuation_beta_2_squared_squared * product_3
        + attenuation_epsilon_2
        + attenuation_epsilon_2_squared
        + product_16
        + product_20
        + product_21
        + product_22
        + product_3
    )
    sum_13 = (
        2.0
        + 2.0 * attenuation_beta_2_squared_squared
        + 2.0 * attenuation_beta_2_squared_squared * attenuation_epsilon_2
        + 2.0 * attenuation_beta_2_squared_squared * attenuation_epsilon_2_squared
        + 2.0 * attenuation_beta_2_squared_squared * product_3
        + 2.0 * attenuation_epsilon_2
        + 2.0 * attenuation_epsilon_2_squared
        + 2.0 * product_3
        + product_16
        + product_20
        + product_21
        + product_22
    )
    part_00_sin_beta2_sin_epsilon2 = (
        0.25 * attenuation_beta_2 * rho_squared * shortfall_epsilon_2 * sigma_beta_squared * sigma_r_squared * sum_11
        + 0.25 * r_squared * shortfall_epsilon_2 * sum_12
        + 0.25 * shortfall_epsilon_2 * sigma_r_squared * sum_13
    )
    product_23 = -2.0 * attenuation_epsilon_2_squared_squared * shortfall_beta_2
    product_24 = -3.0 * attenuation_epsilon_2_squared * shortfall_beta_2 * shortfall_epsilon_2_squared
    product_25 = -4.0 * product_3 * shortfall_beta_2 * shortfall_epsilon_2
    product_26 = -attenuation_epsilon_2 * product_2 * shortfall_beta_2
    sum_14 = (
        3.0 * attenuation_beta_2 * attenuation_epsilon_2 * product_2
        + 3.0 * attenuation_beta_2 * attenuation_epsilon_2_squared * shortfall_epsilon_2_squared
        + attenuation_beta_2 * shortfall_epsilon_2_squared_squared
        + product_23
        + product_24
        + product_25
        + product_26
    )
    sum_15 = (
        18.0 * attenuation_epsilon_2_squared_squared * shortfall_beta_2
        - 14.0 * attenuation_beta_2 * attenuation_epsilon_2_squared_squared
        - 16.0 * attenuation_beta_2 * shortfall_epsilon_2_squared_squared
        - 28.0 * attenuation_beta_2 * product_3 * shortfall_epsilon_2
        - 55.0 * attenuation_beta_2 * attenuation_epsilon_2 * product_2
        - 69.0 * attenuation_beta_2 * attenuation_epsilon_2_squared * shortfall_epsilon_2_squared
        + 27.0 * attenuation_epsilon_2_squared * shortfall_beta_2 * shortfall_epsilon_2_squared
        + 36.0 * product_3 * shortfall_beta_2 * shortfall_epsilon_2
        + 9.0 * attenuation_epsilon_2 * product_2 * shortfall_beta_2
    )
    product_27 = 4.0 * attenuation_beta_2 * product_3 * shortfall_epsilon_2
    sum_16 = (
        2.0 * attenuation_beta_2 * shortfall_epsilon_2_squared_squared
        + 7.0 * attenuation_beta_2 * attenuation_epsilon_2 * product_2
        + 9.0 * attenuation_beta_2 * attenuation_epsilon_2_squared * shortfall_epsilon_2_squared
        + product_18
        + product_23
        + product_24
        + product_25
        + product_26
        + product_27
    )
    part_01_cos_beta_cos_epsilon2_sin_beta = (
        0.5 * product_13 * r_squared * sum_14
        + 0.5 * product_13 * rho_squared * sigma_beta_squared * sigma_r_squared * sum_15
        + 0.5 * product_13 * sigma_r_squared * sum_16
    )
    product_28 = -2.0 * product_3 * shortfall_beta_2
    product_29 = -3.0 * attenuation_epsilon_2_squared * shortfall_beta_2 * shortfall_epsilon_2
    product_30 = -attenuation_epsilon_2 * shortfall_beta_2 * shortfall_epsilon_2_squared
    sum_17 = (
        3.0 * attenuation_beta_2 * attenuation_epsilon_2 * shortfall_epsilon_2_squared
        + 3.0 * attenuation_beta_2 * attenuation_epsilon_2_squared * shortfall_epsilon_2
        + attenuation_beta_2 * product_2
        + product_19
        + product_28
        + product_29
        + product_30
    )
    sum_18 = (
        18.0 * product_3 * shortfall_beta_2
        - 16.0 * attenuation_beta_2 * product_2
        - 46.0 * attenuation_beta_2 * product_3
        - 55.0 * attenuation_beta_2 * attenuation_epsilon_2 * shortfall_epsilon_2_squared
        - 69.0 * attenuation_beta_2 * attenuation_epsilon_2_squared * shortfall_epsilon_2
        + 27.0 * attenuation_epsilon_2_squared * shortfall_beta_2 * shortfall_epsilon_2
        + 9.0 * attenuation_epsilon_2 * shortfall_beta_2 * shortfall_epsilon_2_squared
    )
    sum_19 = (
        2.0 * attenuation_beta_2 * product_2
        + 6.0 * attenuation_beta_2 * product_3
        + 7.0 * attenuation_beta_2 * attenuation_epsilon_2 * shortfall_epsilon_2_squared
        + 9.0 * attenuation_beta_2 * attenuation_epsilon_2_squared * shortfall_epsilon_2
        + product_28
        + product_29
        + product_30
    )
    part_01_cos_beta_sin_beta_sin_epsilon2 = (
        0.5 * product_13 * r_squared * shortfall_epsilon_2 * sum_17
        + 0.5 * product_13 * rho_squared * shortfall_epsilon_2 * sigma_beta_squared * sigma_r_squared * sum_18
        + 0.5 * product_13 * shortfall_epsilon_2 * sigma_r_squared * sum_19
    )
    sum_20 = shortfall_epsilon_2 - attenuation_epsilon_2
    sum_21 = attenuation_epsilon_2 - shortfall_epsilon_2
    part_02_cos_epsilon_sin_beta_sin_epsilon = (
        2.0 * attenuation_beta_2 * product_3 * rho_squared * sigma_beta_squared * sigma_r_squared * sum_20
        - attenuation_beta_2 * product_3 * r_squared * shortfall_epsilon_2
        + attenuation_beta_2 * product_3 * sigma_r_squared * sum_21
    )
    sum_22 = 2.0 + 2.0 * product_3 + attenuation_epsilon_2 + attenuation_epsilon_2_squared
    part_22_cos_epsilon2 = (
        0.5 * (1.0 + product_3) * r_squared * shortfall_epsilon_2
        + 0.5 * shortfall_epsilon_2 * sigma_r_squared * sum_22
    )
    sum_23 = 1.0 + attenuation_epsilon_2 + attenuation_epsilon_2_squared
    sum_24 = 1.0 - 0.5 * attenuation_epsilon_2 - 0.5 * product_3 + attenuation_epsilon_2_squared_squared
    part_22_sin_epsilon2 = 0.5 * r_squared * shortfall_epsilon_2_squared * sum_23 + sigma_r_squared * sum_24
    sum_25 = (
        attenuation_beta * attenuation_epsilon
        - attenuation_beta * shortfall_epsilon
        - attenuation_epsilon * shortfall_beta
        - shortfall_beta * shortfall_epsilon
    )
    sum_26 = (
        attenuation_beta * shortfall_epsilon
        - attenuation_beta * attenuation_epsilon
        + attenuation_epsilon * shortfall_beta
        + product_1
    )
    sum_27 = (
        13.0 * attenuation_beta_2 * attenuation_epsilon_2 * product_2
        - 12.0 * product_3 * shortfall_beta_2 * shortfall_epsilon_2
        - 3.0 * attenuation_epsilon_2 * product_2 * shortfall_beta_2
        - 6.0 * attenuation_epsilon_2_squared_squared * shortfall_beta_2
        - 9.0 * attenuation_epsilon_2_squared * shortfall_beta_2 * shortfall_epsilon_2_squared
        + 15.0 * attenuation_beta_2 * attenuation_epsilon_2_squared * shortfall_epsilon_2_squared
        + 4.0 * attenuation_beta_2 * shortfall_epsilon_2_squared_squared
        + product_18
        + product_27
    )
    cos_epsilon_squared = cos_epsilon**2
    sum_28 = (
        10.0 * attenuation_beta_2 * product_3
        - 3.0 * attenuation_epsilon_2 * shortfall_beta_2 * shortfall_epsilon_2_squared
        - 6.0 * product_3 * shortfall_beta_2
        - 9.0 * attenuation_epsilon_2_squared * shortfall_beta_2 * shortfall_epsilon_2
        + 13.0 * attenuation_beta_2 * attenuation_epsilon_2 * shortfall_epsilon_2_squared
        + 15.0 * attenuation_beta_2 * attenuation_epsilon_2_squared * shortfall_epsilon_2
        + 4.0 * attenuation_beta_2 * product_2
    )
    sin_epsilon_squared = sin_epsilon**2
    cos_beta_squared = cos_beta**2
    sin_beta_squared = sin_beta**2
    sum_29 = (
        12.0 * product_3 * shortfall_beta_2 * shortfall_epsilon_2
        - 13.0 * attenuation_beta_2 * attenuation_epsilon_2 * product_2
        - 15.0 * attenuation_beta_2 * attenuation_epsilon_2_squared * shortfall_epsilon_2_squared
        - 2.0 * attenuation_beta_2 * attenuation_epsilon_2_squared_squared
        - 4.0 * attenuation_beta_2 * product_3 * shortfall_epsilon_2
        - 4.0 * attenuation_beta_2 * shortfall_epsilon_2_squared_squared
        + 3.0 * attenuation_epsilon_2 * product_2 * shortfall_beta_2
        + 6.0 * attenuation_epsilon_2_squared_squared * shortfall_beta_2
        + 9.0 * attenuation_epsilon_2_squared * shortfall_beta_2 * shortfall_epsilon_2_squared
    )
    sum_30 = (
        3.0 * attenuation_epsilon_2 * shortfall_beta_2 * shortfall_epsilon_2_squared
        - 10.0 * attenuation_beta_2 * product_3
        - 13.0 * attenuation_beta_2 * attenuation_epsilon_2 * shortfall_epsilon_2_squared
        - 15.0 * attenuation_beta_2 * attenuation_epsilon_2_squared * shortfall_epsilon_2
        - 4.0 * attenuation_beta_2 * product_2
        + 6.0 * product_3 * shortfall_beta_2
        + 9.0 * attenuation_epsilon_2_squared * shortfall_beta_2 * shortfall_epsilon_2
    )
    sum_31 = attenuation_epsilon_2 - 3.0 * shortfall_epsilon_2
    sum_32 = 3.0 * shortfall_epsilon_2 - attenuation_epsilon_2
    mean[..., 0] = (
        cos_epsilon * r * sin_beta
        - attenuation_beta * attenuation_epsilon * cos_beta * cos_epsilon * rho * sigma_beta * sigma_r * sum_25
        - cos_epsilon * part_0_cos_epsilon_sin_beta * sin_beta
    )
    mean[..., 1] = (
        cos_beta * cos_epsilon * r
        - attenuation_beta * attenuation_epsilon * cos_epsilon * rho * sigma_beta * sigma_r * sin_beta * sum_26
        - cos_beta * cos_epsilon * part_0_cos_epsilon_sin_beta
    )
    mean[..., 2] = attenuation_epsilon * r * shortfall_epsilon * sin_epsilon + r * sin_epsilon
    covariance[..., 0, 0] = (
        cos_beta * cos_epsilon_squared * product_13 * r * rho * sigma_beta * sigma_r * sin_beta * sum_27
        + cos_beta * product_13 * r * rho * shortfall_epsilon_2 * sigma_beta * sigma_r * sin_beta * sin_epsilon_squared * sum_28
        + cos_beta_squared * cos_epsilon_squared * part_00_cos_beta2_cos_epsilon2
        + cos_beta_squared * part_00_cos_beta2_sin_epsilon2 * sin_epsilon_squared
        + cos_epsilon_squared * part_00_cos_epsilon2_sin_beta2 * sin_beta_squared
        + part_00_sin_beta2_sin_epsilon2 * sin_beta_squared * sin_epsilon_squared
    )
    covariance[..., 0, 1] = (
        cos_beta * cos_epsilon_squared * part_01_cos_beta_cos_epsilon2_sin_beta * sin_beta
        + cos_beta * part_01_cos_beta_sin_beta_sin_epsilon2 * sin_beta * sin_epsilon_squared
        + 0.5 * cos_beta_squared * cos_epsilon_squared * product_13 * r * rho * sigma_beta * sigma_r * sum_27
        + 0.5 * cos_beta_squared * product_13 * r * rho * shortfall_epsilon_2 * sigma_beta * sigma_r * sin_epsilon_squared * sum_28
        + 0.5 * cos_epsilon_squared * product_13 * r * rho * sigma_beta * sigma_r * sin_beta_squared * sum_29
        + 0.5 * product_13 * r * rho * shortfall_epsilon_2 * sigma_beta * sigma_r * sin_beta_squared * sin_epsilon_squared * sum_30
    )
    covariance[..., 0, 2] = (
        attenuation_beta_2 * cos_beta * cos_epsilon * product_3 * r * rho * sigma_beta * sigma_r * sin_epsilon * sum_31
        + cos_epsilon * part_02_cos_epsilon_sin_beta_sin_epsilon * sin_beta * sin_epsilon
    )
    covariance[..., 1, 0] = covariance[..., 0, 1]
    covariance[..., 1, 1] = (
        cos_beta * cos_epsilon_squared * product_13 * r * rho * sigma_beta * sigma_r * sin_beta * sum_29
        + cos_beta * product_13 * r * rho * shortfall_epsilon_2 * sigma_beta * sigma_r * sin_beta * sin_epsilon_squared * sum_30
        + cos_beta_squared * cos_epsilon_squared * part_00_cos_epsilon2_sin_beta2
        + cos_beta_squared * part_00_sin_beta2_sin_epsilon2 * sin_epsilon_squared
        + cos_epsilon_squared * part_00_cos_beta2_cos_epsilon2 * sin_beta_squared
        + part_00_cos_beta2_sin_epsilon2 * sin_beta_squared * sin_epsilon_squared
    )
    covariance[..., 1, 2] = (
        attenuation_beta_2 * cos_epsilon * product_3 * r * rho * sigma_beta * sigma_r * sin_beta * sin_epsilon * sum_32
        + cos_beta * cos_epsilon * part_02_cos_epsilon_sin_beta_sin_epsilon * sin_epsilon
    )
    covariance[..., 2, 0] = covariance[..., 0, 2]
    covariance[..., 2, 1] = covariance[..., 1, 2]
    covariance[..., 2, 2] = (
        cos_epsilon_squared * part_22_cos_epsilon2
        + part_22_sin_epsilon2 * sin_epsilon_squared
    )


def spherical_unbiased(
    r: Floats,
    beta: Floats,
    epsilon: Floats,
    sigma_r: Floats,
    sigma_beta: Floats,
    sigma_epsilon: Floats,
    rho: Floats,
    mean: Floats,
    covariance: Floats,
) -> None:
    """Conversion spherical, unbiased.

    Mean: exactly unbiased estimate of the position. Covariance: error covariance of the unbiased estimate u.
    """
    cos_beta = np.cos(beta)
    sin_beta = np.sin(beta)
    cos_epsilon = np.cos(epsilon)
    sin_epsilon = np.sin(epsilon)
    sigma_beta_squared = sigma_beta**2
    attenuation_beta = np.exp(-0.5 * sigma_beta_squared)
    sigma_epsilon_squared = sigma_epsilon**2
    attenuation_epsilon = np.exp(-0.5 * sigma_epsilon_squared)
    term_1 = 1.0 / attenuation_beta
    term_2 = 1.0 / attenuation_epsilon
    part_0_cos_beta_cos_epsilon = -rho * sigma_beta * sigma_r * term_1 * term_2
    part_0_cos_epsilon_sin_beta = r * term_1 * term_2
    shortfall_beta = -np.expm1(-0.5 * sigma_beta_squared)
    attenuation_epsilon_2 = np.exp(-sigma_epsilon_squared)
    shortfall_epsilon = -np.expm1(-sigma_epsilon_squared)
    term_3 = 1.0 / attenuation_epsilon_2
    term_4 = 1.0 / attenuation_beta**2
    attenuation_beta_squared = attenuation_beta**2
    attenuation_beta_squared_cubed = attenuation_beta_squared * attenuation_beta_squared**2
    attenuation_epsilon_2_squared = attenuation_epsilon_2**2
    product_1 = attenuation_epsilon_2 * attenuation_epsilon_2_squared
    product_2 = attenuation_beta_squared_cubed * product_1
    rho_squared = rho**2
    sigma_r_squared = sigma_r**2
    sum_1 = (
        1.0
        + 2.0 * attenuation_beta_squared * attenuation_epsilon_2
        + attenuation_beta_squared_cubed * attenuation_epsilon_2
        + product_2
    )
    product_3 = attenuation_beta * attenuation_beta_squared
    sum_2 = (
        1.0
        + attenuation_beta
        + attenuation_beta * attenuation_epsilon_2_squared
        + attenuation_beta_squared
        + attenuation_beta_squared * attenuation_epsilon_2_squared
        + attenuation_epsilon_2_squared
        + attenuation_epsilon_2_squared * product_3
        + product_3
    )
    r_squared = r**2
    part_00_cos_beta2_cos_epsilon2 = (
        0.25 * r_squared * shortfall_beta * sum_2
        + rho_squared * sigma_beta_squared * sigma_r_squared * sum_1 * term_3 * term_4
        + 0.25 * shortfall_beta * sigma_r_squared * sum_2
    )
    attenuation_beta_squared_squared = attenuation_beta_squared**2
    sum_3 = 1.0 + attenuation_epsilon_2
    sum_4 = (
        1.0
        + attenuation_beta
        + attenuation_beta * attenuation_epsilon_2
        + attenuation_beta_squared
        + attenuation_beta_squared * attenuation_epsilon_2
        + attenuation_epsilon_2
        + attenuation_epsilon_2 * product_3
        + product_3
    )
    part_00_cos_beta2_sin_epsilon2 = (
        attenuation_beta_squared_squared * rho_squared * shortfall_epsilon * sigma_beta_squared * sigma_r_squared * sum_3
        + 0.25 * r_squared * shortfall_beta * shortfall_epsilon * sum_4
        + 0.25 * shortfall_beta * shortfall_epsilon * sigma_r_squared * sum_4
    )
    sum_5 = -1.0 - attenuation_epsilon_2_squared
    shortfall_beta_squared = shortfall_beta**2
    shortfall_beta_squared_cubed = shortfall_beta_squared * shortfall_beta_squared**2
    shortfall_epsilon_squared = shortfall_epsilon**2
    product_4 = attenuation_beta * attenuation_beta_squared**2
    shortfall_beta_squared_squared = shortfall_beta_squared**2
    product_5 = shortfall_beta * shortfall_beta_squared
    product_6 = shortfall_epsilon * shortfall_epsilon_squared
    product_7 = shortfall_beta * shortfall_beta_squared**2
    sum_6 = (
        12.0 * attenuation_epsilon_2 * shortfall_beta_squared_cubed * shortfall_epsilon_squared
        + 12.0 * attenuation_epsilon_2_squared * shortfall_beta_squared_cubed * shortfall_epsilon
        + 138.0 * attenuation_beta_squared_squared * attenuation_epsilon_2 * shortfall_beta_squared * shortfall_epsilon_squared
        + 16.0 * attenuation_epsilon_2_squared * product_4 * shortfall_beta * shortfall_epsilon
        + 166.0 * attenuation_beta_squared * attenuation_epsilon_2_squared * shortfall_beta_squared_squared * shortfall_epsilon
        + 173.0 * attenuation_beta_squared * attenuation_epsilon_2 * shortfall_beta_squared_squared * shortfall_epsilon_squared
        + 184.0 * attenuation_epsilon_2_squared * product_3 * product_5 * shortfall_epsilon
        + 212.0 * attenuation_epsilon_2 * product_3 * product_5 * shortfall_epsilon_squared
        + 24.0 * attenuation_beta * product_1 * product_7
        + 24.0 * attenuation_beta * product_6 * product_7
        + 24.0 * attenuation_beta_squared_squared * product_1 * shortfall_beta_squared
        + 24.0 * product_4 * product_6 * shortfall_beta
        + 4.0 * attenuation_beta_squared_cubed * product_6
        + 4.0 * product_1 * shortfall_beta_squared_cubed
        + 4.0 * product_6 * shortfall_beta_squared_cubed
        + 44.0 * attenuation_epsilon_2 * product_4 * shortfall_beta * shortfall_epsilon_squared
        + 54.0 * attenuation_beta_squared * product_1 * shortfall_beta_squared_squared
        + 56.0 * product_1 * product_3 * product_5
        + 6.0 * attenuation_beta_squared_cubed * attenuation_epsilon_2 * shortfall_epsilon_squared
        + 60.0 * attenuation_beta_squared * product_6 * shortfall_beta_squared_squared
        + 60.0 * attenuation_beta_squared_squared * product_6 * shortfall_beta_squared
        + 72.0 * attenuation_beta * attenuation_epsilon_2 * product_7 * shortfall_epsilon_squared
        + 72.0 * attenuation_beta * attenuation_epsilon_2_squared * product_7 * shortfall_epsilon
        + 80.0 * product_3 * product_5 * product_6
        + 96.0 * attenuation_beta_squared_squared * attenuation_epsilon_2_squared * shortfall_beta_squared * shortfall_epsilon
    )
    sum_7 = (
        0.25
        + 0.25 * attenuation_beta_squared_squared * attenuation_epsilon_2_squared
        + 0.25 * attenuation_beta_squared_squared
        + 0.25 * attenuation_epsilon_2_squared
    )
    part_00_cos_epsilon2_sin_beta2 = (
        attenuation_beta_squared_squared * rho_squared * sigma_beta_squared * sigma_r_squared * sum_5
        + 0.25 * r_squared * sum_6 * term_3 * term_4
        + sigma_r_squared * sum_7
    )
    sum_8 = -1.0 - attenuation_epsilon_2
    sum_9 = (
        1.0
        + attenuation_beta_squared_squared
        + attenuation_beta_squared_squared * attenuation_epsilon_2
        + attenuation_epsilon_2
    )
    part_00_sin_beta2_sin_epsilon2 = (
        attenuation_beta_squared_squared * rho_squared * shortfall_epsilon * sigma_beta_squared * sigma_r_squared * sum_8
        + 0.25 * r_squared * shortfall_epsilon * sum_9
        + 0.25 * shortfall_epsilon * sigma_r_squared * sum_9
    )
    sum_10 = 1.0 + attenuation_epsilon_2_squared
    sum_11 = (
        104.0 * attenuation_epsilon_2 * product_3 * product_5 * shortfall_epsilon_squared
        - 4.0 * product_1 * product_4 * shortfall_beta
        + 12.0 * attenuation_beta * product_1 * product_7
        + 12.0 * attenuation_beta * product_6 * product_7
        + 12.0 * product_4 * product_6 * shortfall_beta
        + 2.0 * attenuation_beta_squared_cubed * product_6
        + 2.0 * product_1 * shortfall_beta_squared_cubed
        + 2.0 * product_6 * shortfall_beta_squared_cubed
        + 20.0 * attenuation_epsilon_2 * product_4 * shortfall_beta * shortfall_epsilon_squared
        + 24.0 * product_1 * product_3 * product_5
        + 26.0 * attenuation_beta_squared * product_1 * shortfall_beta_squared_squared
        + 3.0 * attenuation_beta_squared_cubed * attenuation_epsilon_2 * shortfall_epsilon_squared
        + 30.0 * attenuation_beta_squared * product_6 * shortfall_beta_squared_squared
        + 30.0 * attenuation_beta_squared_squared * product_6 * shortfall_beta_squared
        + 36.0 * attenuation_beta * attenuation_epsilon_2 * product_7 * shortfall_epsilon_squared
        + 36.0 * attenuation_beta * attenuation_epsilon_2_squared * product_7 * shortfall_epsilon
        + 4.0 * attenuation_epsilon_2_squared * product_4 * shortfall_beta * shortfall_epsilon
        + 40.0 * product_3 * product_5 * product_6
        + 42.0 * attenuation_beta_squared_squared * attenuation_epsilon_2_squared * shortfall_beta_squared * shortfall_epsilon
        + 6.0 * attenuation_beta_squared_squared * product_1 * shortfall_beta_squared
        + 6.0 * attenuation_epsilon_2 * shortfall_beta_squared_cubed * shortfall_epsilon_squared
        + 6.0 * attenuation_epsilon_2_squared * shortfall_beta_squared_cubed * shortfall_epsilon
        + 66.0 * attenuation_beta_squared_squared * attenuation_epsilon_2 * shortfall_beta_squared * shortfall_epsilon_squared
        + 82.0 * attenuation_beta_squared * attenuation_epsilon_2_squared * shortfall_beta_squared_squared * shortfall_epsilon
        + 86.0 * attenuation_beta_squared * attenuation_epsilon_2 * shortfall_beta_squared_squared * shortfall_epsilon_squared
        + 88.0 * attenuation_epsilon_2_squared * product_3 * product_5 * shortfall_epsilon
    )
    sum_12 = (
        -1.0
        - 2.0 * attenuation_beta_squared * attenuation_epsilon_2
        - 2.0 * attenuation_beta_squared_cubed * attenuation_epsilon_2
        - 2.0 * attenuation_beta_squared_cubed * product_1
    )
    part_01_cos_beta_cos_epsilon2_sin_beta = (
        0.5 * attenuation_beta_squared_squared * sigma_r_squared * sum_10
        + 0.5 * r_squared * sum_11 * term_3 * term_4
        + rho_squared * sigma_beta_squared * sigma_r_squared * sum_12 * term_3 * term_4
    )
    part_01_cos_beta_sin_beta_sin_epsilon2 = (
        2.0 * attenuation_beta_squared_squared * rho_squared * shortfall_epsilon * sigma_beta_squared * sigma_r_squared * sum_8
        + 0.5 * attenuation_beta_squared_squared * r_squared * shortfall_epsilon * sum_3
        + 0.5 * attenuation_beta_squared_squared * shortfall_epsilon * sigma_r_squared * sum_3
    )
    sum_13 = (
        2.0 * attenuation_beta * attenuation_epsilon_2_squared * shortfall_beta
        - attenuation_beta_squared * attenuation_epsilon_2_squared
        + 2.0 * attenuation_beta * shortfall_beta * shortfall_epsilon_squared
        + 2.0 * attenuation_epsilon_2 * shortfall_beta_squared * shortfall_epsilon
        + 4.0 * attenuation_beta * attenuation_epsilon_2 * shortfall_beta * shortfall_epsilon
        + attenuation_beta_squared * attenuation_epsilon_2 * shortfall_epsilon
        + attenuation_beta_squared * shortfall_epsilon_squared
        + attenuation_epsilon_2_squared * shortfall_beta_squared
        + shortfall_beta_squared * shortfall_epsilon_squared
    )
    part_02_cos_epsilon_sin_beta_sin_epsilon = (
        attenuation_beta * attenuation_epsilon_2_squared * sigma_r_squared
        - attenuation_beta * attenuation_epsilon_2_squared * rho_squared * sigma_beta_squared * sigma_r_squared
        + r_squared * shortfall_epsilon * sum_13 * term_1 * term_3
    )
    part_22_cos_epsilon2 = (
        0.5 * r_squared * shortfall_epsilon * sum_3
        + 0.5 * shortfall_epsilon * sigma_r_squared * sum_3
    )
    sum_14 = 0.5 + 0.5 * attenuation_epsilon_2_squared
    part_22_sin_epsilon2 = (
        0.5 * (2.0 + attenuation_epsilon_2) * r_squared * shortfall_epsilon_squared * term_3
        + sigma_r_squared * sum_14
    )
    sin_epsilon_squared = sin_epsilon**2
    sum_15 = (
        product_2
        - 15.0 * attenuation_beta_squared * product_1 * shortfall_beta_squared_squared
        - 15.0 * attenuation_beta_squared * product_6 * shortfall_beta_squared_squared
        - 15.0 * attenuation_beta_squared_squared * product_1 * shortfall_beta_squared
        - 15.0 * attenuation_beta_squared_squared * product_6 * shortfall_beta_squared
        - 18.0 * attenuation_beta * attenuation_epsilon_2 * product_7 * shortfall_epsilon_squared
        - 18.0 * attenuation_beta * attenuation_epsilon_2_squared * product_7 * shortfall_epsilon
        - 18.0 * attenuation_epsilon_2 * product_4 * shortfall_beta * shortfall_epsilon_squared
        - 18.0 * attenuation_epsilon_2_squared * product_4 * shortfall_beta * shortfall_epsilon
        - 2.0 * attenuation_beta_squared_cubed * attenuation_epsilon_2 * shortfall_epsilon_squared
        - 20.0 * product_1 * product_3 * product_5
        - 20.0 * product_3 * product_5 * product_6
        - 3.0 * attenuation_epsilon_2 * shortfall_beta_squared_cubed * shortfall_epsilon_squared
        - 3.0 * attenuation_epsilon_2_squared * shortfall_beta_squared_cubed * shortfall_epsilon
        - 45.0 * attenuation_beta_squared * attenuation_epsilon_2 * shortfall_beta_squared_squared * shortfall_epsilon_squared
        - 45.0 * attenuation_beta_squared * attenuation_epsilon_2_squared * shortfall_beta_squared_squared * shortfall_epsilon
        - 45.0 * attenuation_beta_squared_squared * attenuation_epsilon_2 * shortfall_beta_squared * shortfall_epsilon_squared
        - 45.0 * attenuation_beta_squared_squared * attenuation_epsilon_2_squared * shortfall_beta_squared * shortfall_epsilon
        - 6.0 * attenuation_beta * product_1 * product_7
        - 6.0 * attenuation_beta * product_6 * product_7
        - 6.0 * product_1 * product_4 * shortfall_beta
        - 6.0 * product_4 * product_6 * shortfall_beta
        - 60.0 * attenuation_epsilon_2 * product_3 * product_5 * shortfall_epsilon_squared
        - 60.0 * attenuation_epsilon_2_squared * product_3 * product_5 * shortfall_epsilon
        - attenuation_beta_squared_cubed * attenuation_epsilon_2_squared * shortfall_epsilon
        - attenuation_beta_squared_cubed * product_6
        - product_1 * shortfall_beta_squared_cubed
        - product_6 * shortfall_beta_squared_cubed
    )
    cos_epsilon_squared = cos_epsilon**2
    cos_beta_squared = cos_beta**2
    sin_beta_squared = sin_beta**2
    sum_16 = (
        15.0 * attenuation_beta_squared * product_1 * shortfall_beta_squared_squared
        - attenuation_beta_squared_cubed * product_1
        + 15.0 * attenuation_beta_squared * product_6 * shortfall_beta_squared_squared
        + 15.0 * attenuation_beta_squared_squared * product_1 * shortfall_beta_squared
        + 15.0 * attenuation_beta_squared_squared * product_6 * shortfall_beta_squared
        + 18.0 * attenuation_beta * attenuation_epsilon_2 * product_7 * shortfall_epsilon_squared
        + 18.0 * attenuation_beta * attenuation_epsilon_2_squared * product_7 * shortfall_epsilon
        + 18.0 * attenuation_epsilon_2 * product_4 * shortfall_beta * shortfall_epsilon_squared
        + 18.0 * attenuation_epsilon_2_squared * product_4 * shortfall_beta * shortfall_epsilon
        + 2.0 * attenuation_beta_squared_cubed * attenuation_epsilon_2 * shortfall_epsilon_squared
        + 20.0 * product_1 * product_3 * product_5
        + 20.0 * product_3 * product_5 * product_6
        + 3.0 * attenuation_epsilon_2 * shortfall_beta_squared_cubed * shortfall_epsilon_squared
        + 3.0 * attenuation_epsilon_2_squared * shortfall_beta_squared_cubed * shortfall_epsilon
        + 45.0 * attenuation_beta_squared * attenuation_epsilon_2 * shortfall_beta_squared_squared * shortfall_epsilon_squared
        + 45.0 * attenuation_beta_squared * attenuation_epsilon_2_squared * shortfall_beta_squared_squared * shortfall_epsilon
        + 45.0 * attenuation_beta_squared_squared * attenuation_epsilon_2 * shortfall_beta_squared * shortfall_epsilon_squared
        + 45.0 * attenuation_beta_squared_squared * attenuation_epsilon_2_squared * shortfall_beta_squared * shortfall_epsilon
        + 6.0 * attenuation_beta * product_1 * product_7
        + 6.0 * attenuation_beta * product_6 * product_7
        + 6.0 * product_1 * product_4 * shortfall_beta
        + 6.0 * product_4 * product_6 * shortfall_beta
        + 60.0 * attenuation_epsilon_2 * product_3 * product_5 * shortfall_epsilon_squared
        + 60.0 * attenuation_epsilon_2_squared * product_3 * product_5 * shortfall_epsilon
        + attenuation_beta_squared_cubed * attenuation_epsilon_2_squared * shortfall_epsilon
        + attenuation_beta_squared_cubed * product_6
        + product_1 * shortfall_beta_squared_cubed
        + product_6 * shortfall_beta_squared_cubed
    )
    sum_17 = (
        attenuation_beta_squared * product_1
        - 2.0 * attenuation_beta * attenuation_epsilon_2_squared * shortfall_beta * shortfall_epsilon
        - 2.0 * attenuation_beta * product_6 * shortfall_beta
        - 2.0 * attenuation_epsilon_2 * shortfall_beta_squared * shortfall_epsilon_squared
        - 3.0 * attenuation_beta_squared * attenuation_epsilon_2 * shortfall_epsilon_squared
        - 3.0 * attenuation_beta_squared * attenuation_epsilon_2_squared * shortfall_epsilon
        - 4.0 * attenuation_beta * attenuation_epsilon_2 * shortfall_beta * shortfall_epsilon_squared
        - attenuation_beta_squared * product_6
        - attenuation_epsilon_2_squared * shortfall_beta_squared * shortfall_epsilon
        - product_6 * shortfall_beta_squared
    )
    sum_18 = (
        2.0 * attenuation_beta * attenuation_epsilon_2_squared * shortfall_beta * shortfall_epsilon
        - attenuation_beta_squared * product_1
        + 2.0 * attenuation_beta * product_6 * shortfall_beta
        + 2.0 * attenuation_epsilon_2 * shortfall_beta_squared * shortfall_epsilon_squared
        + 3.0 * attenuation_beta_squared * attenuation_epsilon_2 * shortfall_epsilon_squared
        + 3.0 * attenuation_beta_squared * attenuation_epsilon_2_squared * shortfall_epsilon
        + 4.0 * attenuation_beta * attenuation_epsilon_2 * shortfall_beta * shortfall_epsilon_squared
        + attenuation_beta_squared * product_6
        + attenuation_epsilon_2_squared * shortfall_beta_squared * shortfall_epsilon
        + product_6 * shortfall_beta_squared
    )
    mean[..., 0] = (
        cos_beta * cos_epsilon * part_0_cos_beta_cos_epsilon
        + cos_epsilon * part_0_cos_epsilon_sin_beta * sin_beta
    )
    mean[..., 1] = (
        cos_beta * cos_epsilon * part_0_cos_epsilon_sin_beta
        - cos_epsilon * part_0_cos_beta_cos_epsilon * sin_beta
    )
    mean[..., 2] = r * sin_epsilon * term_2
    covariance[..., 0, 0] = (
        2.0 * attenuation_beta_squared_squared * cos_beta * r * rho * shortfall_epsilon * sigma_beta * sigma_r * sin_beta * sin_epsilon_squared * sum_3
        + 2.0 * cos_beta * cos_epsilon_squared * r * rho * sigma_beta * sigma_r * sin_beta * sum_15 * term_3 * term_4
        + cos_beta_squared * cos_epsilon_squared * part_00_cos_beta2_cos_epsilon2
        + cos_beta_squared * part_00_cos_beta2_sin_epsilon2 * sin_epsilon_squared
        + cos_epsilon_squared * part_00_cos_epsilon2_sin_beta2 * sin_beta_squared
        + part_00_sin_beta2_sin_epsilon2 * sin_beta_squared * sin_epsilon_squared
    )
    covariance[..., 0, 1] = (
        attenuation_beta_squared_squared * cos_beta_squared * r * rho * shortfall_epsilon * sigma_beta * sigma_r * sin_epsilon_squared * sum_3
        + attenuation_beta_squared_squared * r * rho * shortfall_epsilon * sigma_beta * sigma_r * sin_beta_squared * sin_epsilon_squared * sum_8
        + cos_beta * cos_epsilon_squared * part_01_cos_beta_cos_epsilon2_sin_beta * sin_beta
        + cos_beta * part_01_cos_beta_sin_beta_sin_epsilon2 * sin_beta * sin_epsilon_squared
        + cos_beta_squared * cos_epsilon_squared * r * rho * sigma_beta * sigma_r * sum_15 * term_3 * term_4
        + cos_epsilon_squared * r * rho * sigma_beta * sigma_r * sin_beta_squared * sum_16 * term_3 * term_4
    )
    covariance[..., 0, 2] = (
        cos_beta * cos_epsilon * r * rho * sigma_beta * sigma_r * sin_epsilon * sum_17 * term_1 * term_3
        + cos_epsilon * part_02_cos_epsilon_sin_beta_sin_epsilon * sin_beta * sin_epsilon
    )
    covariance[..., 1, 0] = covariance[..., 0, 1]
    covariance[..., 1, 1] = (
        2.0 * attenuation_beta_squared_squared * cos_beta * r * rho * shortfall_epsilon * sigma_beta * sigma_r * sin_beta * sin_epsilon_squared * sum_8
        + 2.0 * cos_beta * cos_epsilon_squared * r * rho * sigma_beta * sigma_r * sin_beta * sum_16 * term_3 * term_4
        + cos_beta_squared * cos_epsilon_squared * part_00_cos_epsilon2_sin_beta2
        + cos_beta_squared * part_00_sin_beta2_sin_epsilon2 * sin_epsilon_squared
        + cos_epsilon_squared * part_00_cos_beta2_cos_epsilon2 * sin_beta_squared
        + part_00_cos_beta2_sin_epsilon2 * sin_beta_squared * sin_epsilon_squared
    )
    covariance[..., 1, 2] = (
        cos_beta * cos_epsilon * part_02_cos_epsilon_sin_beta_sin_epsilon * sin_epsilon
        + cos_epsilon * r * rho * sigma_beta * sigma_r * sin_beta * sin_epsilon * sum_18 * term_1 * term_3
    )
    covariance[..., 2, 0] = covariance[..., 0, 2]
    covariance[..., 2, 1] = covariance[..., 1, 2]
    covariance[..., 2, 2] = (
        cos_epsilon_squared * part_22_cos_epsilon2
        + part_22_sin_epsilon2 * sin_epsilon_squared
    )


def spherical_posterior(
    r: Floats,
    beta: Floats,
    epsilon: Floats,
    sigma_r: Floats,
    sigma_beta: Floats,
    sigma_epsilon: Floats,
    rho: Floats,
    mean: Floats,
    covariance: Floats,
) -> None:
    """Conversion spherical, posterior.

    Mean: posterior mean of the position under a flat prior. Covariance: posterior covariance of the position
    under a flat prior.
    """
    cos_beta = np.cos(beta)
    sin_beta = np.sin(beta)
    cos_epsilon = np.cos(epsilon)
    sin_epsilon = np.sin(epsilon)
    sigma_beta_squared = sigma_beta**2
    attenuation_beta = np.exp(-0.5 * sigma_beta_squared)
    sigma_epsilon_squared = sigma_epsilon**2
    attenuation_epsilon = np.exp(-0.5 * sigma_epsilon_squared)
    part_0_cos_beta_cos_epsilon = attenuation_beta * attenuation_epsilon * rho * sigma_beta * sigma_r
    part_0_cos_epsilon_sin_beta = attenuation_beta * attenuation_epsilon * r
    shortfall_beta = -np.expm1(-0.5 * sigma_beta_squared)
    attenuation_epsilon_2 = np.exp(-sigma_epsilon_squared)
    shortfall_epsilon = -np.expm1(-sigma_epsilon_squared)
    attenuation_beta_squared = attenuation_beta**2
    attenuation_epsilon_2_squared = attenuation_epsilon_2**2
    shortfall_beta_squared = shortfall_beta**2
    product_1 = attenuation_beta_squared * attenuation_epsilon_2_squared
    shortfall_epsilon_squared = shortfall_epsilon**2
    product_2 = attenuation_beta_squared * shortfall_epsilon_squared
    sum_1 = (
        attenuation_beta_squared * attenuation_epsilon_2 * shortfall_epsilon
        - 2.0 * attenuation_beta * attenuation_epsilon_2 * shortfall_beta * shortfall_epsilon
        - 2.0 * attenuation_beta * attenuation_epsilon_2_squared * shortfall_beta
        - attenuation_epsilon_2 * shortfall_beta_squared * shortfall_epsilon
        - attenuation_epsilon_2_squared * shortfall_beta_squared
        + product_1
        + product_2
    )
    rho_squared = rho**2
    sigma_r_squared = sigma_r**2
    product_3 = attenuation_beta * attenuation_beta_squared
    sum_2 = (
        1.0
        + attenuation_beta
        + attenuation_beta * attenuation_epsilon_2_squared
        + attenuation_beta_squared
        + attenuation_epsilon_2_squared
        + attenuation_epsilon_2_squared * product_3
        + product_1
        + product_3
    )
    r_squared = r**2
    part_00_cos_beta2_cos_epsilon2 = (
        attenuation_beta_squared * rho_squared * sigma_beta_squared * sigma_r_squared * sum_1
        + 0.25 * r_squared * shortfall_beta * sum_2
        + 0.25 * shortfall_beta * sigma_r_squared * sum_2
    )
    attenuation_beta_squared_squared = attenuation_beta_squared**2
    sum_3 = 1.0 + attenuation_epsilon_2
    sum_4 = (
        1.0
        + attenuation_beta
        + attenuation_beta * attenuation_epsilon_2
        + attenuation_beta_squared
        + attenuation_beta_squared * attenuation_epsilon_2
        + attenuation_epsilon_2
        + attenuation_epsilon_2 * product_3
        + product_3
    )
    part_00_cos_beta2_sin_epsilon2 = (
        attenuation_beta_squared_squared * rho_squared * shortfall_epsilon * sigma_beta_squared * sigma_r_squared * sum_3
        + 0.25 * r_squared * shortfall_beta * shortfall_epsilon * sum_4
        + 0.25 * shortfall_beta * shortfall_epsilon * sigma_r_squared * sum_4
    )
    sum_5 = -1.0 - attenuation_epsilon_2_squared
    product_4 = shortfall_beta * shortfall_beta_squared
    shortfall_beta_squared_squared = shortfall_beta_squared**2
    sum_6 = (
        2.0 * attenuation_beta * attenuation_epsilon_2 * product_4 * shortfall_epsilon
        + 2.0 * attenuation_beta * attenuation_epsilon_2_squared * product_4
        + 2.0 * attenuation_beta_squared * attenuation_epsilon_2 * shortfall_beta_squared * shortfall_epsilon
        + 2.0 * attenuation_beta_squared * attenuation_epsilon_2_squared * shortfall_beta_squared
        + 1.5 * attenuation_beta_squared * shortfall_beta_squared * shortfall_epsilon_squared
        + attenuation_beta * product_4 * shortfall_epsilon_squared
        + 0.5 * attenuation_beta_squared_squared * shortfall_epsilon_squared
        + 0.5 * attenuation_epsilon_2 * shortfall_beta_squared_squared * shortfall_epsilon
        + 0.5 * attenuation_epsilon_2_squared * shortfall_beta_squared_squared
        + product_3 * shortfall_beta * shortfall_epsilon_squared
        + 0.25 * shortfall_beta_squared_squared * shortfall_epsilon_squared
    )
    sum_7 = (
        0.25
        + 0.25 * attenuation_beta_squared_squared * attenuation_epsilon_2_squared
        + 0.25 * attenuation_beta_squared_squared
        + 0.25 * attenuation_epsilon_2_squared
    )
    part_00_cos_epsilon2_sin_beta2 = (
        attenuation_beta_squared_squared * rho_squared * sigma_beta_squared * sigma_r_squared * sum_5
        + r_squared * sum_6
        + sigma_r_squared * sum_7
    )
    sum_8 = -1.0 - attenuation_epsilon_2
    sum_9 = (
        1.0
        + attenuation_beta_squared_squared
        + attenuation_beta_squared_squared * attenuation_epsilon_2
        + attenuation_epsilon_2
    )
    part_00_sin_beta2_sin_epsilon2 = (
        attenuation_beta_squared_squared * rho_squared * shortfall_epsilon * sigma_beta_squared * sigma_r_squared * sum_8
        + 0.25 * r_squared * shortfall_epsilon * sum_9
        + 0.25 * shortfall_epsilon * sigma_r_squared * sum_9
    )
    sum_10 = (
        product_2
        - 2.0 * attenuation_epsilon_2 * shortfall_beta_squared * shortfall_epsilon
        - 2.0 * attenuation_epsilon_2_squared * shortfall_beta_squared
        - 4.0 * attenuation_beta * attenuation_epsilon_2 * shortfall_beta * shortfall_epsilon
        - 4.0 * attenuation_beta * attenuation_epsilon_2_squared * shortfall_beta
    )
    product_5 = 2.0 * attenuation_beta * attenuation_epsilon_2_squared * shortfall_beta
    product_6 = 2.0 * attenuation_beta * attenuation_epsilon_2 * shortfall_beta * shortfall_epsilon
    product_7 = attenuation_epsilon_2_squared * shortfall_beta_squared
    product_8 = attenuation_epsilon_2 * shortfall_beta_squared * shortfall_epsilon
    sum_11 = (
        product_5
        - 2.0 * attenuation_beta_squared * shortfall_epsilon_squared
        - 3.0 * attenuation_beta_squared * attenuation_epsilon_2 * shortfall_epsilon
        - 3.0 * attenuation_beta_squared * attenuation_epsilon_2_squared
        + product_6
        + product_7
        + product_8
    )
    sum_12 = 1.0 + attenuation_epsilon_2_squared
    part_01_cos_beta_cos_epsilon2_sin_beta = (
        0.5 * attenuation_beta_squared * r_squared * sum_10
        + attenuation_beta_squared * rho_squared * sigma_beta_squared * sigma_r_squared * sum_11
        + 0.5 * attenuation_beta_squared_squared * sigma_r_squared * sum_12
    )
    part_01_cos_beta_sin_beta_sin_epsilon2 = (
        2.0 * attenuation_beta_squared_squared * rho_squared * shortfall_epsilon * sigma_beta_squared * sigma_r_squared * sum_8
        + 0.5 * attenuation_beta_squared_squared * r_squared * shortfall_epsilon * sum_3
        + 0.5 * attenuation_beta_squared_squared * shortfall_epsilon * sigma_r_squared * sum_3
    )
    part_02_cos_epsilon_sin_beta_sin_epsilon = (
        attenuation_beta * attenuation_epsilon_2_squared * sigma_r_squared
        - attenuation_beta * attenuation_epsilon_2 * r_squared * shortfall_epsilon
        - attenuation_beta * attenuation_epsilon_2_squared * rho_squared * sigma_beta_squared * sigma_r_squared
    )
    part_22_cos_epsilon2 = (
        0.5 * r_squared * shortfall_epsilon * sum_3
        + 0.5 * shortfall_epsilon * sigma_r_squared * sum_3
    )
    sum_13 = 0.5 + 0.5 * attenuation_epsilon_2_squared
    part_22_sin_epsilon2 = 0.5 * r_squared * shortfall_epsilon_squared + sigma_r_squared * sum_13
    cos_epsilon_squared = cos_epsilon**2
    sin_epsilon_squared = sin_epsilon**2
    cos_beta_squared = cos_beta**2
    sin_beta_squared = sin_beta**2
    sum_14 = (
        product_5
        - attenuation_beta_squared * attenuation_epsilon_2 * shortfall_epsilon
        - attenuation_beta_squared * attenuation_epsilon_2_squared
        - attenuation_beta_squared * shortfall_epsilon_squared
        + product_6
        + product_7
        + product_8
    )
    sum_15 = attenuation_epsilon_2 - shortfall_epsilon
    sum_16 = shortfall_epsilon - attenuation_epsilon_2
    mean[..., 0] = (
        cos_beta * cos_epsilon * part_0_cos_beta_cos_epsilon
        + cos_epsilon * part_0_cos_epsilon_sin_beta * sin_beta
    )
    mean[..., 1] = (
        cos_beta * cos_epsilon * part_0_cos_epsilon_sin_beta
        - cos_epsilon * part_0_cos_beta_cos_epsilon * sin_beta
    )
    mean[..., 2] = attenuation_epsilon * r * sin_epsilon
    covariance[..., 0, 0] = (
        2.0 * attenuation_beta_squared * cos_beta * cos_epsilon_squared * r * rho * sigma_beta * sigma_r * sin_beta * sum_1
        + 2.0 * attenuation_beta_squared_squared * cos_beta * r * rho * shortfall_epsilon * sigma_beta * sigma_r * sin_beta * sin_epsilon_squared * sum_3
        + cos_beta_squared * cos_epsilon_squared * part_00_cos_beta2_cos_epsilon2
        + cos_beta_squared * part_00_cos_beta2_sin_epsilon2 * sin_epsilon_squared
        + cos_epsilon_squared * part_00_cos_epsilon2_sin_beta2 * sin_beta_squared
        + part_00_sin_beta2_sin_epsilon2 * sin_beta_squared * sin_epsilon_squared
    )
    covariance[..., 0, 1] = (
        attenuation_beta_squared * cos_beta_squared * cos_epsilon_squared * r * rho * sigma_beta * sigma_r * sum_1
        + attenuation_beta_squared * cos_epsilon_squared * r * rho * sigma_beta * sigma_r * sin_beta_squared * sum_14
        + attenuation_beta_squared_squared * cos_beta_squared * r * rho * shortfall_epsilon * sigma_beta * sigma_r * sin_epsilon_squared * sum_3
        + attenuation_beta_squared_squared * r * rho * shortfall_epsilon * sigma_beta * sigma_r * sin_beta_squared * sin_epsilon_squared * sum_8
        + cos_beta * cos_epsilon_squared * part_01_cos_beta_cos_epsilon2_sin_beta * sin_beta
        + cos_beta * part_01_cos_beta_sin_beta_sin_epsilon2 * sin_beta * sin_epsilon_squared
    )
    covariance[..., 0, 2] = (
        attenuation_beta * attenuation_epsilon_2 * cos_beta * cos_epsilon * r * rho * sigma_beta * sigma_r * sin_epsilon * sum_15
        + cos_epsilon * part_02_cos_epsilon_sin_beta_sin_epsilon * sin_beta * sin_epsilon
    )
    covariance[..., 1, 0] = covariance[..., 0, 1]
    covariance[..., 1, 1] = (
        2.0 * attenuation_beta_squared * cos_beta * cos_epsilon_squared * r * rho * sigma_beta * sigma_r * sin_beta * sum_14
        + 2.0 * attenuation_beta_squared_squared * cos_beta * r * rho * shortfall_epsilon * sigma_beta * sigma_r * sin_beta * sin_epsilon_squared * sum_8
        + cos_beta_squared * cos_epsilon_squared * part_00_cos_epsilon2_sin_beta2
        + cos_beta_squared * part_00_sin_beta2_sin_epsilon2 * sin_epsilon_squared
        + cos_epsilon_squared * part_00_cos_beta2_cos_epsilon2 * sin_beta_squared
        + part_00_cos_beta2_sin_epsilon2 * sin_beta_squared * sin_epsilon_squared
    )
    covariance[..., 1, 2] = (
        attenuation_beta * attenuation_epsilon_2 * cos_epsilon * r * rho * sigma_beta * sigma_r * sin_beta * sin_epsilon * sum_16
        + cos_beta * cos_epsilon * part_02_cos_epsilon_sin_beta_sin_epsilon * sin_epsilon
    )
    covariance[..., 2, 0] = covariance[..., 0, 2]
    covariance[..., 2, 1] = covariance[..., 1, 2]
    covariance[..., 2, 2] = (
        cos_epsilon_squared * part_22_cos_epsilon2
        + part_22_sin_epsilon2 * sin_epsilon_squared
    )
