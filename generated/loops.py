"""Conversions as loops over plots; mean[plot, n] and covariance[plot, n, n] are filled, in arrays or in dictionaries.

Written by radartrack regenerate, generator 1, derivation 78dee844b7a41827; not to be edited.
"""

import math
from collections.abc import MutableMapping, Sequence

Floats = Sequence[float]
Filled = MutableMapping[tuple[int, ...], float]


def polar_linear(
    all_r: Floats,
    all_beta: Floats,
    all_sigma_r: Floats,
    all_sigma_beta: Floats,
    all_rho: Floats,
    mean: Filled,
    covariance: Filled,
) -> None:
    """Conversion polar, linear.

    Mean: map from the measured quantities to coordinates. Covariance: covariance of the linearised
    conversion.
    """
    for i in range(len(all_r)):
        r = all_r[i]
        beta = all_beta[i]
        sigma_r = all_sigma_r[i]
        sigma_beta = all_sigma_beta[i]
        rho = all_rho[i]
        cos_beta = math.cos(beta)
        sin_beta = math.sin(beta)
        part_00_cos_beta_sin_beta = -2.0 * r * rho * sigma_beta * sigma_r
        r_squared = r**2
        sigma_beta_squared = sigma_beta**2
        part_00_sin_beta2 = r_squared * sigma_beta_squared
        part_01_cos_beta2 = r * rho * sigma_beta * sigma_r
        sigma_r_squared = sigma_r**2
        part_01_cos_beta_sin_beta = sigma_r_squared - r_squared * sigma_beta_squared
        sum_1 = cos_beta * sigma_r_squared + part_00_cos_beta_sin_beta * sin_beta
        sin_beta_squared = sin_beta**2
        sum_2 = cos_beta * part_01_cos_beta2 + part_01_cos_beta_sin_beta * sin_beta
        sum_3 = cos_beta * part_00_sin_beta2 - part_00_cos_beta_sin_beta * sin_beta
        mean[i, 0] = cos_beta * r
        mean[i, 1] = r * sin_beta
        covariance[i, 0, 0] = cos_beta * sum_1 + part_00_sin_beta2 * sin_beta_squared
        covariance[i, 0, 1] = cos_beta * sum_2 - part_01_cos_beta2 * sin_beta_squared
        covariance[i, 1, 0] = covariance[i, 0, 1]
        covariance[i, 1, 1] = cos_beta * sum_3 + sigma_r_squared * sin_beta_squared


def polar_second_order(
    all_r: Floats,
    all_beta: Floats,
    all_sigma_r: Floats,
    all_sigma_beta: Floats,
    all_rho: Floats,
    mean: Filled,
    covariance: Filled,
) -> None:
    """Conversion polar, second_order.

    Mean: map from the measured quantities to coordinates less the bias of the plain conversion to second
    order. Covariance: covariance of the conversion's quadratic Taylor polynomial.
    """
    for i in range(len(all_r)):
        r = all_r[i]
        beta = all_beta[i]
        sigma_r = all_sigma_r[i]
        sigma_beta = all_sigma_beta[i]
        rho = all_rho[i]
        cos_beta = math.cos(beta)
        sin_beta = math.sin(beta)
        sigma_beta_squared = sigma_beta**2
        part_0_cos_beta = -0.5 * r * sigma_beta_squared
        part_0_sin_beta = -rho * sigma_beta * sigma_r
        r_squared = r**2
        sigma_r_squared = sigma_r**2
        part_00_cos_beta2 = 0.5 * r_squared * sigma_beta_squared**2 + sigma_r_squared
        part_00_cos_beta_sin_beta = -(2.0 - 2.0 * sigma_beta_squared) * r * rho * sigma_beta * sigma_r
        product_1 = (1.0 + rho**2) * sigma_r_squared
        part_00_sin_beta2 = (product_1 + r_squared) * sigma_beta_squared
        part_01_cos_beta2 = (1.0 - sigma_beta_squared) * r * rho * sigma_beta * sigma_r
        sum_1 = product_1 + (1.0 - 0.5 * sigma_beta_squared) * r_squared
        part_01_cos_beta_sin_beta = sigma_r_squared - sigma_beta_squared * sum_1
        sum_2 = part_0_cos_beta - r
        sum_3 = cos_beta * part_00_cos_beta2 + part_00_cos_beta_sin_beta * sin_beta
        sin_beta_squared = sin_beta**2
        sum_4 = cos_beta * part_01_cos_beta2 + part_01_cos_beta_sin_beta * sin_beta
        sum_5 = cos_beta * part_00_sin_beta2 - part_00_cos_beta_sin_beta * sin_beta
        mean[i, 0] = -cos_beta * sum_2 - part_0_sin_beta * sin_beta
        mean[i, 1] = cos_beta * part_0_sin_beta - sin_beta * sum_2
        covariance[i, 0, 0] = cos_beta * sum_3 + part_00_sin_beta2 * sin_beta_squared
        covariance[i, 0, 1] = cos_beta * sum_4 - part_01_cos_beta2 * sin_beta_squared
        covariance[i, 1, 0] = covariance[i, 0, 1]
        covariance[i, 1, 1] = cos_beta * sum_5 + part_00_cos_beta2 * sin_beta_squared


def polar_averaged(
    all_r: Floats,
    all_beta: Floats,
    all_sigma_r: Floats,
    all_sigma_beta: Floats,
    all_rho: Floats,
    mean: Filled,
    covariance: Filled,
) -> None:
    """Conversion polar, averaged.

    Mean: map from the measured quantities to coordinates less the exact bias of the plain conversion,
    averaged over the truth. Covariance: exact covariance of the plain conversion, averaged over the truth.
    """
    for i in range(len(all_r)):
        r = all_r[i]
        beta = all_beta[i]
        sigma_r = all_sigma_r[i]
        sigma_beta = all_sigma_beta[i]
        rho = all_rho[i]
        cos_beta = math.cos(beta)
        sin_beta = math.sin(beta)
        sigma_beta_squared = sigma_beta**2
        attenuation_beta = math.exp(-0.5 * sigma_beta_squared)
        shortfall_beta = -math.expm1(-0.5 * sigma_beta_squared)
        part_0_cos_beta = -attenuation_beta * r * shortfall_beta
        attenuation_beta_2 = math.exp(-sigma_beta_squared)
        shortfall_beta_2 = -math.expm1(-sigma_beta_squared)
        r_squared = r**2
        shortfall_beta_2_squared = shortfall_beta_2**2
        sum_1 = 1.0 + attenuation_beta_2 * (1.0 + attenuation_beta_2)
        attenuation_beta_2_squared = attenuation_beta_2**2
        sum_2 = 0.5 + (0.5 - attenuation_beta_2) * attenuation_beta_2_squared
        sum_3 = 8.0 * attenuation_beta_2 - 6.0 * shortfall_beta_2
        sum_4 = 3.0 * shortfall_beta_2_squared + attenuation_beta_2 * sum_3
        product_1 = shortfall_beta_2 * shortfall_beta_2_squared
        rho_squared = rho**2
        sum_5 = attenuation_beta_2 * sum_4 + product_1
        sigma_r_squared = sigma_r**2
        sum_6 = (
            1.0
            - 0.5 * attenuation_beta_2 * rho_squared * sigma_beta_squared * sum_5
            - attenuation_beta_2 * sum_2
        )
        part_00_cos_beta2 = 0.5 * r_squared * shortfall_beta_2_squared * sum_1 + sigma_r_squared * sum_6
        sum_7 = 6.0 * attenuation_beta_2 - 12.0 * shortfall_beta_2
        sum_8 = attenuation_beta_2 * sum_7 - 3.0 * shortfall_beta_2_squared
        sum_9 = attenuation_beta_2 * sum_8 - product_1
        product_2 = attenuation_beta_2 * attenuation_beta_2_squared
        sum_10 = 1.0 + (1.0 + 2.0 * attenuation_beta_2) * attenuation_beta_2
        sum_11 = 2.0 + attenuation_beta_2 * sum_10
        sum_12 = 0.5 * (1.0 + product_2) * r_squared + 0.5 * sigma_r_squared * sum_11
        part_00_sin_beta2 = (
            0.5 * attenuation_beta_2 * rho_squared * sigma_beta_squared * sigma_r_squared * sum_9
            + shortfall_beta_2 * sum_12
        )
        sum_13 = 7.0 * attenuation_beta_2 - 9.0 * shortfall_beta_2
        sum_14 = attenuation_beta_2 - rho_squared * sigma_beta_squared * sum_13 - shortfall_beta_2
        sum_15 = r_squared * shortfall_beta_2 - sigma_r_squared * sum_14
        part_01_cos_beta_sin_beta = -product_2 * sum_15
        sum_16 = part_0_cos_beta - r
        sum_17 = attenuation_beta - shortfall_beta
        sum_18 = attenuation_beta_2 - 3.0 * shortfall_beta_2
        product_3 = 2.0 * product_2 * r * rho * sigma_beta * sigma_r * sin_beta * sum_18
        sum_19 = product_3 - cos_beta * part_00_cos_beta2
        sin_beta_squared = sin_beta**2
        sum_20 = cos_beta * part_00_sin_beta2 + product_3
        mean[i, 0] = attenuation_beta * rho * sigma_beta * sigma_r * sin_beta * sum_17 - cos_beta * sum_16
        mean[i, 1] = -attenuation_beta * cos_beta * rho * sigma_beta * sigma_r * sum_17 - sin_beta * sum_16
        covariance[i, 0, 0] = part_00_sin_beta2 * sin_beta_squared - cos_beta * sum_19
        covariance[i, 0, 1] = (
            cos_beta * part_01_cos_beta_sin_beta * sin_beta
            + (cos_beta**2 - sin_beta_squared) * product_2 * r * rho * sigma_beta * sigma_r * sum_18
        )
        covariance[i, 1, 0] = covariance[i, 0, 1]
        covariance[i, 1, 1] = cos_beta * sum_20 + part_00_cos_beta2 * sin_beta_squared


def polar_unbiased(
    all_r: Floats,
    all_beta: Floats,
    all_sigma_r: Floats,
    all_sigma_beta: Floats,
    all_rho: Floats,
    mean: Filled,
    covariance: Filled,
) -> None:
    """Conversion polar, unbiased.

    Mean: exactly unbiased estimate of the position. Covariance: error covariance of the unbiased estimate u.
    """
    for i in range(len(all_r)):
        r = all_r[i]
        beta = all_beta[i]
        sigma_r = all_sigma_r[i]
        sigma_beta = all_sigma_beta[i]
        rho = all_rho[i]
        cos_beta = math.cos(beta)
        sin_beta = math.sin(beta)
        sigma_beta_squared = sigma_beta**2
        attenuation_beta = math.exp(-0.5 * sigma_beta_squared)
        term_1 = 1.0 / attenuation_beta
        part_0_cos_beta = r * term_1
        part_0_sin_beta = rho * sigma_beta * sigma_r * term_1
        attenuation_beta_2 = math.exp(-sigma_beta_squared)
        shortfall_beta = -math.expm1(-sigma_beta_squared)
        term_2 = 1.0 / attenuation_beta_2
        r_squared = r**2
        shortfall_beta_squared = shortfall_beta**2
        attenuation_beta_2_squared = attenuation_beta_2**2
        rho_squared = rho**2
        sigma_r_squared = sigma_r**2
        sum_1 = (
            0.5
            - 2.0 * attenuation_beta_2_squared * rho_squared * sigma_beta_squared
            + 0.5 * attenuation_beta_2_squared
        )
        part_00_cos_beta2 = (
            0.5 * (2.0 + attenuation_beta_2) * r_squared * shortfall_beta_squared * term_2
            + sigma_r_squared * sum_1
        )
        sum_2 = 2.0 + 2.0 * attenuation_beta_2_squared
        sum_3 = 1.0 + attenuation_beta_2 * sum_2
        sum_4 = 0.5 * r_squared + 0.5 * sigma_r_squared
        part_00_sin_beta2 = (
            rho_squared * sigma_beta_squared * sigma_r_squared * sum_3 * term_2
            + (1.0 + attenuation_beta_2) * shortfall_beta * sum_4
        )
        sum_5 = 2.0 + 4.0 * attenuation_beta_2_squared
        sum_6 = 1.0 + attenuation_beta_2 * sum_5
        sum_7 = attenuation_beta_2 - shortfall_beta
        sum_8 = attenuation_beta_2 * sum_7 - shortfall_beta_squared
        sum_9 = r_squared * shortfall_beta * sum_8 + rho_squared * sigma_beta_squared * sigma_r_squared * sum_6
        part_01_cos_beta_sin_beta = attenuation_beta_2_squared * sigma_r_squared - sum_9 * term_2
        sum_10 = attenuation_beta_2 - 3.0 * shortfall_beta
        sum_11 = attenuation_beta_2 * sum_10 - 3.0 * shortfall_beta_squared
        sum_12 = attenuation_beta_2 * sum_11 - shortfall_beta * shortfall_beta_squared
        sum_13 = cos_beta * part_00_cos_beta2 - 2.0 * r * rho * sigma_beta * sigma_r * sin_beta * sum_12 * term_2
        sin_beta_squared = sin_beta**2
        sum_14 = 2.0 * r * rho * sigma_beta * sigma_r * sin_beta * sum_12 * term_2 + cos_beta * part_00_sin_beta2
        mean[i, 0] = cos_beta * part_0_cos_beta + part_0_sin_beta * sin_beta
        mean[i, 1] = part_0_cos_beta * sin_beta - cos_beta * part_0_sin_beta
        covariance[i, 0, 0] = cos_beta * sum_13 + part_00_sin_beta2 * sin_beta_squared
        covariance[i, 0, 1] = (
            cos_beta * part_01_cos_beta_sin_beta * sin_beta
            + (cos_beta**2 - sin_beta_squared) * r * rho * sigma_beta * sigma_r * sum_12 * term_2
        )
        covariance[i, 1, 0] = covariance[i, 0, 1]
        covariance[i, 1, 1] = cos_beta * sum_14 + part_00_cos_beta2 * sin_beta_squared


def polar_posterior(
    all_r: Floats,
    all_beta: Floats,
    all_sigma_r: Floats,
    all_sigma_beta: Floats,
    all_rho: Floats,
    mean: Filled,
    covariance: Filled,
) -> None:
    """Conversion polar, posterior.

    Mean: posterior mean of the position under a flat prior. Covariance: posterior covariance of the position
    under a flat prior.
    """
    for i in range(len(all_r)):
        r = all_r[i]
        beta = all_beta[i]
        sigma_r = all_sigma_r[i]
        sigma_beta = all_sigma_beta[i]
        rho = all_rho[i]
        cos_beta = math.cos(beta)
        sin_beta = math.sin(beta)
        sigma_beta_squared = sigma_beta**2
        attenuation_beta = math.exp(-0.5 * sigma_beta_squared)
        part_0_cos_beta = attenuation_beta * r
        part_0_sin_beta = -attenuation_beta * rho * sigma_beta * sigma_r
        attenuation_beta_2 = math.exp(-sigma_beta_squared)
        shortfall_beta = -math.expm1(-sigma_beta_squared)
        r_squared = r**2
        attenuation_beta_2_squared = attenuation_beta_2**2
        rho_squared = rho**2
        sigma_r_squared = sigma_r**2
        sum_1 = (
            0.5
            - 2.0 * attenuation_beta_2_squared * rho_squared * sigma_beta_squared
            + 0.5 * attenuation_beta_2_squared
        )
        part_00_cos_beta2 = 0.5 * r_squared * shortfall_beta**2 + sigma_r_squared * sum_1
        sum_2 = attenuation_beta_2 - shortfall_beta
        sum_3 = 0.5 * r_squared + 0.5 * sigma_r_squared
        part_00_sin_beta2 = (
            attenuation_beta_2 * rho_squared * sigma_beta_squared * sigma_r_squared * sum_2
            + (1.0 + attenuation_beta_2) * shortfall_beta * sum_3
        )
        sum_4 = 3.0 * attenuation_beta_2 - shortfall_beta
        sum_5 = attenuation_beta_2 - rho_squared * sigma_beta_squared * sum_4
        sum_6 = r_squared * shortfall_beta - sigma_r_squared * sum_5
        part_01_cos_beta_sin_beta = -attenuation_beta_2 * sum_6
        product_1 = 2.0 * attenuation_beta_2 * r * rho * sigma_beta * sigma_r * sin_beta * sum_2
        sum_7 = product_1 - cos_beta * part_00_cos_beta2
        sin_beta_squared = sin_beta**2
        sum_8 = cos_beta * part_00_sin_beta2 + product_1
        mean[i, 0] = cos_beta * part_0_cos_beta + part_0_sin_beta * sin_beta
        mean[i, 1] = part_0_cos_beta * sin_beta - cos_beta * part_0_sin_beta
        covariance[i, 0, 0] = part_00_sin_beta2 * sin_beta_squared - cos_beta * sum_7
        covariance[i, 0, 1] = (
            attenuation_beta_2 * (cos_beta**2 - sin_beta_squared) * r * rho * sigma_beta * sigma_r * sum_2
            + cos_beta * part_01_cos_beta_sin_beta * sin_beta
        )
        covariance[i, 1, 0] = covariance[i, 0, 1]
        covariance[i, 1, 1] = cos_beta * sum_8 + part_00_cos_beta2 * sin_beta_squared


def polar_doppler_linear(
    all_r: Floats,
    all_beta: Floats,
    all_rdot: Floats,
    all_sigma_r: Floats,
    all_sigma_beta: Floats,
    all_sigma_rdot: Floats,
    all_rho: Floats,
    mean: Filled,
    covariance: Filled,
) -> None:
    """Conversion polar_doppler, linear.

    Mean: map from the measured quantities to coordinates. Covariance: covariance of the linearised
    conversion.
    """
    for i in range(len(all_r)):
        r = all_r[i]
        beta = all_beta[i]
        rdot = all_rdot[i]
        sigma_r = all_sigma_r[i]
        sigma_beta = all_sigma_beta[i]
        sigma_rdot = all_sigma_rdot[i]
        rho = all_rho[i]
        cos_beta = math.cos(beta)
        sin_beta = math.sin(beta)
        r_squared = r**2
        sigma_beta_squared = sigma_beta**2
        part_00_sin_beta2 = r_squared * sigma_beta_squared
        sigma_r_squared = sigma_r**2
        part_01_cos_beta_sin_beta = sigma_r_squared - r_squared * sigma_beta_squared
        sum_1 = r * rho * sigma_rdot + rdot * sigma_r
        part_02_cos_beta = sigma_r * sum_1
        cos_beta_squared = cos_beta**2
        sin_beta_squared = sin_beta**2
        sum_2 = 2.0 * rdot * rho * sigma_r + r * sigma_rdot
        mean[i, 0] = cos_beta * r
        mean[i, 1] = r * sin_beta
        mean[i, 2] = r * rdot
        covariance[i, 0, 0] = cos_beta_squared * sigma_r_squared + part_00_sin_beta2 * sin_beta_squared
        covariance[i, 0, 1] = cos_beta * part_01_cos_beta_sin_beta * sin_beta
        covariance[i, 0, 2] = cos_beta * part_02_cos_beta
        covariance[i, 1, 0] = covariance[i, 0, 1]
        covariance[i, 1, 1] = cos_beta_squared * part_00_sin_beta2 + sigma_r_squared * sin_beta_squared
        covariance[i, 1, 2] = part_02_cos_beta * sin_beta
        covariance[i, 2, 0] = covariance[i, 0, 2]
        covariance[i, 2, 1] = covariance[i, 1, 2]
        covariance[i, 2, 2] = rdot**2 * sigma_r_squared + r * sigma_rdot * sum_2


def polar_doppler_second_order(
    all_r: Floats,
    all_beta: Floats,
    all_rdot: Floats,
    all_sigma_r: Floats,
    all_sigma_beta: Floats,
    all_sigma_rdot: Floats,
    all_rho: Floats,
    mean: Filled,
    covariance: Filled,
) -> None:
    """Conversion polar_doppler, second_order.

    Mean: map from the measured quantities to coordinates less the bias of the plain conversion to second
    order. Covariance: covariance of the conversion's quadratic Taylor polynomial.
    """
    for i in range(len(all_r)):
        r = all_r[i]
        beta = all_beta[i]
        rdot = all_rdot[i]
        sigma_r = all_sigma_r[i]
        sigma_beta = all_sigma_beta[i]
        sigma_rdot = all_sigma_rdot[i]
        rho = all_rho[i]
        cos_beta = math.cos(beta)
        sin_beta = math.sin(beta)
        sigma_beta_squared = sigma_beta**2
        part_0_cos_beta = -0.5 * r * sigma_beta_squared
        r_squared = r**2
        sigma_r_squared = sigma_r**2
        part_00_cos_beta2 = 0.5 * r_squared * sigma_beta_squared**2 + sigma_r_squared
        part_00_sin_beta2 = (r_squared + sigma_r_squared) * sigma_beta_squared
        sum_1 = (1.0 - 0.5 * sigma_beta_squared) * r_squared + sigma_r_squared
        part_01_cos_beta_sin_beta = sigma_r_squared - sigma_beta_squared * sum_1
        sum_2 = r * rho * sigma_rdot + rdot * sigma_r
        part_02_cos_beta = sigma_r * sum_2
        sum_3 = part_0_cos_beta - r
        cos_beta_squared = cos_beta**2
        sin_beta_squared = sin_beta**2
        sigma_rdot_squared = sigma_rdot**2
        sum_4 = rdot**2 + (1.0 + rho**2) * sigma_rdot_squared
        sum_5 = 2.0 * r * rdot * rho * sigma_rdot + sigma_r * sum_4
        mean[i, 0] = -cos_beta * sum_3
        mean[i, 1] = -sin_beta * sum_3
        mean[i, 2] = r * rdot - rho * sigma_r * sigma_rdot
        covariance[i, 0, 0] = cos_beta_squared * part_00_cos_beta2 + part_00_sin_beta2 * sin_beta_squared
        covariance[i, 0, 1] = cos_beta * part_01_cos_beta_sin_beta * sin_beta
        covariance[i, 0, 2] = cos_beta * part_02_cos_beta
        covariance[i, 1, 0] = covariance[i, 0, 1]
        covariance[i, 1, 1] = cos_beta_squared * part_00_sin_beta2 + part_00_cos_beta2 * sin_beta_squared
        covariance[i, 1, 2] = part_02_cos_beta * sin_beta
        covariance[i, 2, 0] = covariance[i, 0, 2]
        covariance[i, 2, 1] = covariance[i, 1, 2]
        covariance[i, 2, 2] = r_squared * sigma_rdot_squared + sigma_r * sum_5


def polar_doppler_averaged(
    all_r: Floats,
    all_beta: Floats,
    all_rdot: Floats,
    all_sigma_r: Floats,
    all_sigma_beta: Floats,
    all_sigma_rdot: Floats,
    all_rho: Floats,
    mean: Filled,
    covariance: Filled,
) -> None:
    """Conversion polar_doppler, averaged.

    Mean: map from the measured quantities to coordinates less the exact bias of the plain conversion,
    averaged over the truth. Covariance: exact covariance of the plain conversion, averaged over the truth.
    """
    for i in range(len(all_r)):
        r = all_r[i]
        beta = all_beta[i]
        rdot = all_rdot[i]
        sigma_r = all_sigma_r[i]
        sigma_beta = all_sigma_beta[i]
        sigma_rdot = all_sigma_rdot[i]
        rho = all_rho[i]
        cos_beta = math.cos(beta)
        sin_beta = math.sin(beta)
        sigma_beta_squared = sigma_beta**2
        attenuation_beta = math.exp(-0.5 * sigma_beta_squared)
        shortfall_beta = -math.expm1(-0.5 * sigma_beta_squared)
        part_0_cos_beta = -attenuation_beta * r * shortfall_beta
        attenuation_beta_2 = math.exp(-sigma_beta_squared)
        shortfall_beta_2 = -math.expm1(-sigma_beta_squared)
        r_squared = r**2
        sum_1 = 1.0 + attenuation_beta_2 * (1.0 + attenuation_beta_2)
        attenuation_beta_2_squared = attenuation_beta_2**2
        sum_2 = 0.5 + (0.5 - attenuation_beta_2) * attenuation_beta_2_squared
        sigma_r_squared = sigma_r**2
        sum_3 = 1.0 - attenuation_beta_2 * sum_2
        part_00_cos_beta2 = 0.5 * r_squared * shortfall_beta_2**2 * sum_1 + sigma_r_squared * sum_3
        product_1 = attenuation_beta_2 * attenuation_beta_2_squared
        sum_4 = 1.0 + (1.0 + 2.0 * attenuation_beta_2) * attenuation_beta_2
        sum_5 = 2.0 + attenuation_beta_2 * sum_4
        sum_6 = 0.5 * (1.0 + product_1) * r_squared + 0.5 * sigma_r_squared * sum_5
        part_00_sin_beta2 = shortfall_beta_2 * sum_6
        sum_7 = attenuation_beta_2 - shortfall_beta_2
        sum_8 = r_squared * shortfall_beta_2 - sigma_r_squared * sum_7
        part_01_cos_beta_sin_beta = -product_1 * sum_8
        sum_9 = r * rho * sigma_rdot + rdot * sigma_r
        part_02_cos_beta = attenuation_beta_2 * sigma_r * sum_9
        sum_10 = part_0_cos_beta - r
        cos_beta_squared = cos_beta**2
        sin_beta_squared = sin_beta**2
        sigma_rdot_squared = sigma_rdot**2
        sum_11 = rdot**2 + (3.0 + 3.0 * rho**2) * sigma_rdot_squared
        sum_12 = 2.0 * r * rdot * rho * sigma_rdot + sigma_r * sum_11
        mean[i, 0] = -cos_beta * sum_10
        mean[i, 1] = -sin_beta * sum_10
        mean[i, 2] = r * rdot - rho * sigma_r * sigma_rdot
        covariance[i, 0, 0] = cos_beta_squared * part_00_cos_beta2 + part_00_sin_beta2 * sin_beta_squared
        covariance[i, 0, 1] = cos_beta * part_01_cos_beta_sin_beta * sin_beta
        covariance[i, 0, 2] = cos_beta * part_02_cos_beta
        covariance[i, 1, 0] = covariance[i, 0, 1]
        covariance[i, 1, 1] = cos_beta_squared * part_00_sin_beta2 + part_00_cos_beta2 * sin_beta_squared
        covariance[i, 1, 2] = part_02_cos_beta * sin_beta
        covariance[i, 2, 0] = covariance[i, 0, 2]
        covariance[i, 2, 1] = covariance[i, 1, 2]
        covariance[i, 2, 2] = r_squared * sigma_rdot_squared + sigma_r * sum_12


def polar_doppler_unbiased(
    all_r: Floats,
    all_beta: Floats,
    all_rdot: Floats,
    all_sigma_r: Floats,
    all_sigma_beta: Floats,
    all_sigma_rdot: Floats,
    all_rho: Floats,
    mean: Filled,
    covariance: Filled,
) -> None:
    """Conversion polar_doppler, unbiased.

    Mean: exactly unbiased estimate of the position. Covariance: error covariance of the unbiased estimate u.
    """
    for i in range(len(all_r)):
        r = all_r[i]
        beta = all_beta[i]
        rdot = all_rdot[i]
        sigma_r = all_sigma_r[i]
        sigma_beta = all_sigma_beta[i]
        sigma_rdot = all_sigma_rdot[i]
        rho = all_rho[i]
        cos_beta = math.cos(beta)
        sin_beta = math.sin(beta)
        attenuation_beta = math.exp(-0.5 * sigma_beta**2)
        term_1 = 1.0 / attenuation_beta
        part_0_cos_beta = r * term_1
        shortfall_beta = -math.expm1(-0.5 * sigma_beta**2)
        sum_1 = 3.0 + attenuation_beta * (2.0 + attenuation_beta)
        term_2 = 1.0 / attenuation_beta**2
        r_squared = r**2
        shortfall_beta_squared = shortfall_beta**2
        sum_2 = 2.0 + attenuation_beta * (4.0 + attenuation_beta * sum_1)
        term_3 = (attenuation_beta**2)**2
        sigma_r_squared = sigma_r**2
        part_00_cos_beta2 = (
            0.5 * r_squared * shortfall_beta_squared * sum_2 * term_2
            + sigma_r_squared * (0.5 + 0.5 * term_3)
        )
        sum_3 = 1.0 + attenuation_beta * (1.0 + attenuation_beta)
        sum_4 = 0.5 * r_squared + 0.5 * sigma_r_squared
        part_00_sin_beta2 = (1.0 + attenuation_beta * sum_3) * shortfall_beta * sum_4
        sum_5 = 2.0 * attenuation_beta - 3.0 * shortfall_beta
        sum_6 = attenuation_beta * sum_5 - 12.0 * shortfall_beta_squared
        sum_7 = attenuation_beta * sum_6 - 13.0 * shortfall_beta * shortfall_beta_squared
        sum_8 = attenuation_beta * sum_7 - 6.0 * shortfall_beta_squared**2
        sum_9 = attenuation_beta * sum_8 - shortfall_beta * shortfall_beta_squared**2
        part_01_cos_beta_sin_beta = sigma_r_squared * term_3 - r_squared * shortfall_beta * sum_9 * term_2
        sum_10 = attenuation_beta - 4.0 * shortfall_beta
        sum_11 = attenuation_beta * sum_10 - 2.0 * shortfall_beta_squared
        sum_12 = attenuation_beta * rdot * sigma_r + r * rho * sigma_rdot * sum_11 * term_1
        part_02_cos_beta = sigma_r * sum_12
        cos_beta_squared = cos_beta**2
        sin_beta_squared = sin_beta**2
        sigma_rdot_squared = sigma_rdot**2
        sum_13 = rdot**2 + (1.0 + 5.0 * rho**2) * sigma_rdot_squared
        sum_14 = 2.0 * r * rdot * rho * sigma_rdot + sigma_r * sum_13
        mean[i, 0] = cos_beta * part_0_cos_beta
        mean[i, 1] = part_0_cos_beta * sin_beta
        mean[i, 2] = r * rdot - rho * sigma_r * sigma_rdot
        covariance[i, 0, 0] = cos_beta_squared * part_00_cos_beta2 + part_00_sin_beta2 * sin_beta_squared
        covariance[i, 0, 1] = cos_beta * part_01_cos_beta_sin_beta * sin_beta
        covariance[i, 0, 2] = cos_beta * part_02_cos_beta
        covariance[i, 1, 0] = covariance[i, 0, 1]
        covariance[i, 1, 1] = cos_beta_squared * part_00_sin_beta2 + part_00_cos_beta2 * sin_beta_squared
        covariance[i, 1, 2] = part_02_cos_beta * sin_beta
        covariance[i, 2, 0] = covariance[i, 0, 2]
        covariance[i, 2, 1] = covariance[i, 1, 2]
        covariance[i, 2, 2] = r_squared * sigma_rdot_squared + sigma_r * sum_14


def polar_doppler_posterior(
    all_r: Floats,
    all_beta: Floats,
    all_rdot: Floats,
    all_sigma_r: Floats,
    all_sigma_beta: Floats,
    all_sigma_rdot: Floats,
    all_rho: Floats,
    mean: Filled,
    covariance: Filled,
) -> None:
    """Conversion polar_doppler, posterior.

    Mean: posterior mean of the position under a flat prior. Covariance: posterior covariance of the position
    under a flat prior.
    """
    for i in range(len(all_r)):
        r = all_r[i]
        beta = all_beta[i]
        rdot = all_rdot[i]
        sigma_r = all_sigma_r[i]
        sigma_beta = all_sigma_beta[i]
        sigma_rdot = all_sigma_rdot[i]
        rho = all_rho[i]
        cos_beta = math.cos(beta)
        sin_beta = math.sin(beta)
        attenuation_beta = math.exp(-0.5 * sigma_beta**2)
        part_0_cos_beta = attenuation_beta * r
        shortfall_beta = -math.expm1(-0.5 * sigma_beta**2)
        r_squared = r**2
        sum_1 = 1.0 + attenuation_beta * (2.0 + attenuation_beta)
        attenuation_beta_squared = attenuation_beta**2
        sigma_r_squared = sigma_r**2
        sum_2 = 0.5 + 0.5 * attenuation_beta_squared**2
        part_00_cos_beta2 = 0.5 * r_squared * shortfall_beta**2 * sum_1 + sigma_r_squared * sum_2
        sum_3 = 1.0 + attenuation_beta
        sum_4 = 1.0 + attenuation_beta * (1.0 + attenuation_beta * sum_3)
        sum_5 = 0.5 * r_squared + 0.5 * sigma_r_squared
        part_00_sin_beta2 = shortfall_beta * sum_4 * sum_5
        sum_6 = attenuation_beta_squared * sigma_r_squared - r_squared * shortfall_beta * sum_3
        part_01_cos_beta_sin_beta = attenuation_beta_squared * sum_6
        sum_7 = r * rho * sigma_rdot + rdot * sigma_r
        part_02_cos_beta = attenuation_beta * sigma_r * sum_7
        cos_beta_squared = cos_beta**2
        sin_beta_squared = sin_beta**2
        sigma_rdot_squared = sigma_rdot**2
        sum_8 = rdot**2 + (1.0 + rho**2) * sigma_rdot_squared
        sum_9 = 2.0 * r * rdot * rho * sigma_rdot + sigma_r * sum_8
        mean[i, 0] = cos_beta * part_0_cos_beta
        mean[i, 1] = part_0_cos_beta * sin_beta
        mean[i, 2] = r * rdot + rho * sigma_r * sigma_rdot
        covariance[i, 0, 0] = cos_beta_squared * part_00_cos_beta2 + part_00_sin_beta2 * sin_beta_squared
        covariance[i, 0, 1] = cos_beta * part_01_cos_beta_sin_beta * sin_beta
        covariance[i, 0, 2] = cos_beta * part_02_cos_beta
        covariance[i, 1, 0] = covariance[i, 0, 1]
        covariance[i, 1, 1] = cos_beta_squared * part_00_sin_beta2 + part_00_cos_beta2 * sin_beta_squared
        covariance[i, 1, 2] = part_02_cos_beta * sin_beta
        covariance[i, 2, 0] = covariance[i, 0, 2]
        covariance[i, 2, 1] = covariance[i, 1, 2]
        covariance[i, 2, 2] = r_squared * sigma_rdot_squared + sigma_r * sum_9


def ruv_linear(
    all_r: Floats,
    all_u: Floats,
    all_v: Floats,
    all_sigma_r: Floats,
    all_sigma_u: Floats,
    all_sigma_v: Floats,
    all_rho: Floats,
    mean: Filled,
    covariance: Filled,
) -> None:
    """Conversion ruv, linear.

    Mean: map from the measured quantities to coordinates. Covariance: covariance of the linearised
    conversion.
    """
    for i in range(len(all_r)):
        r = all_r[i]
        u = all_u[i]
        v = all_v[i]
        sigma_r = all_sigma_r[i]
        sigma_u = all_sigma_u[i]
        sigma_v = all_sigma_v[i]
        rho = all_rho[i]
        u_squared = u**2
        v_squared = v**2
        sum_1 = 1.0 - u_squared - v_squared
        root_1 = math.sqrt(sum_1)
        r_squared = r**2
        sigma_r_squared = sigma_r**2
        term_1 = 1.0 / root_1
        product_1 = sigma_u * u
        sum_2 = (product_1 + rho * sigma_v * v) * r_squared * sigma_u - sigma_r_squared * sum_1 * u
        sigma_v_squared = sigma_v**2
        sum_3 = rho * sigma_u * u + sigma_v * v
        sum_4 = r_squared * sigma_v * sum_3 - sigma_r_squared * sum_1 * v
        sum_5 = 2.0 * rho * sigma_v * v + product_1
        sum_6 = sigma_v_squared * v_squared + sigma_u * sum_5 * u
        sum_7 = r_squared * sum_6 + (u_squared - 1.0 + v_squared)**2 * sigma_r_squared
        mean[i, 0] = r * u
        mean[i, 1] = r * v
        mean[i, 2] = r * root_1
        covariance[i, 0, 0] = r_squared * sigma_u**2 + sigma_r_squared * u_squared
        covariance[i, 0, 1] = r_squared * rho * sigma_u * sigma_v + sigma_r_squared * u * v
        covariance[i, 0, 2] = -sum_2 * term_1
        covariance[i, 1, 0] = covariance[i, 0, 1]
        covariance[i, 1, 1] = r_squared * sigma_v_squared + sigma_r_squared * v_squared
        covariance[i, 1, 2] = -sum_4 * term_1
        covariance[i, 2, 0] = covariance[i, 0, 2]
        covariance[i, 2, 1] = covariance[i, 1, 2]
        covariance[i, 2, 2] = sum_7 / root_1**2


def ruv_second_order(
    all_r: Floats,
    all_u: Floats,
    all_v: Floats,
    all_sigma_r: Floats,
    all_sigma_u: Floats,
    all_sigma_v: Floats,
    all_rho: Floats,
    mean: Filled,
    covariance: Filled,
) -> None:
    """Conversion ruv, second_order.

    Mean: map from the measured quantities to coordinates less the bias of the plain conversion to second
    order. Covariance: covariance of the conversion's quadratic Taylor polynomial.
    """
    for i in range(len(all_r)):
        r = all_r[i]
        u = all_u[i]
        v = all_v[i]
        sigma_r = all_sigma_r[i]
        sigma_u = all_sigma_u[i]
        sigma_v = all_sigma_v[i]
        rho = all_rho[i]
        u_squared = u**2
        v_squared = v**2
        sum_1 = 1.0 - u_squared - v_squared
        root_1 = math.sqrt(sum_1)
        sum_2 = 1.0 - v
        sum_3 = 1.0 + v
        sum_4 = rho * sigma_v * u * v + 0.5 * sigma_u * sum_2 * sum_3
        sum_5 = 1.0 - u
        sigma_v_squared = sigma_v**2
        sum_6 = 1.0 + u
        sum_7 = 0.5 * sigma_v_squared * sum_5 * sum_6 + sigma_u * sum_4
        sum_8 = root_1 + sum_7 / (root_1 * root_1**2)
        r_squared = r**2
        sigma_u_squared = sigma_u**2
        sigma_r_squared = sigma_r**2
        term_1 = 1.0 / root_1
        product_1 = sigma_u * u
        sum_9 = product_1 + rho * sigma_v * v
        sum_10 = r_squared * sum_9 + sigma_r_squared * sum_9
        sum_11 = sigma_r_squared * sum_1 * u - sigma_u * sum_10
        sum_12 = rho * sigma_u * u + sigma_v * v
        sum_13 = r_squared * sum_12 + sigma_r_squared * sum_12
        sum_14 = sigma_r_squared * sum_1 * v - sigma_v * sum_13
        term_2 = (u_squared - 1.0 + v_squared)**2
        sum_15 = 2.0 * sigma_v_squared * sum_5 * sum_6 + 2.0 * term_2
        sum_16 = 1.0 - (1.0 - 2.0 * v_squared) * u_squared - v_squared
        sum_17 = 2.0 * sigma_u * sum_2 * sum_3 * u * v + rho * sigma_v * sum_16
        sum_18 = rho * sum_17 + sigma_v * u_squared * v_squared
        sum_19 = 0.5 * (v - 1.0)**2 * sigma_u_squared * sum_3**2 + sigma_v * sum_18 + term_2 * u_squared
        sum_20 = rho * sigma_v * sum_15 * u * v + sigma_u * sum_19
        sum_21 = 0.5 * (u - 1.0)**2 * sigma_v_squared * sum_6**2 + term_2 * v_squared
        sum_22 = sigma_v_squared * sum_21 + sigma_u * sum_20
        sum_23 = 2.0 * rho * sigma_v * v + product_1
        sum_24 = sigma_v_squared * v_squared + sigma_u * sum_23 * u + term_2
        sum_25 = r_squared * sum_22 + sigma_r_squared * sum_24 * term_2
        mean[i, 0] = r * u
        mean[i, 1] = r * v
        mean[i, 2] = r * sum_8
        covariance[i, 0, 0] = r_squared * sigma_u_squared + sigma_r_squared * (sigma_u_squared + u_squared)
        covariance[i, 0, 1] = (r_squared + sigma_r_squared) * rho * sigma_u * sigma_v + sigma_r_squared * u * v
        covariance[i, 0, 2] = sum_11 * term_1
        covariance[i, 1, 0] = covariance[i, 0, 1]
        covariance[i, 1, 1] = r_squared * sigma_v_squared + sigma_r_squared * (sigma_v_squared + v_squared)
        covariance[i, 1, 2] = sum_14 * term_1
        covariance[i, 2, 0] = covariance[i, 0, 2]
        covariance[i, 2, 1] = covariance[i, 1, 2]
        covariance[i, 2, 2] = sum_25 / (root_1 * root_1**2)**2


def ruv_averaged(
    all_r: Floats,
    all_u: Floats,
    all_v: Floats,
    all_sigma_r: Floats,
    all_sigma_u: Floats,
    all_sigma_v: Floats,
    all_rho: Floats,
    mean: Filled,
    covariance: Filled,
) -> None:
    """Conversion ruv, averaged.

    Mean: map from the measured quantities to coordinates less the bias of the plain conversion, averaged over
    the truth, to fourth order. Covariance: covariance of the plain conversion, averaged over the truth, to
    fourth order, completed to a sum of squares.
    """
    for i in range(len(all_r)):
        r = all_r[i]
        u = all_u[i]
        v = all_v[i]
        sigma_r = all_sigma_r[i]
        sigma_u = all_sigma_u[i]
        sigma_v = all_sigma_v[i]
        rho = all_rho[i]
        u_squared = u**2
        v_squared = v**2
        sum_1 = 1.0 - u_squared - v_squared
        root_1 = math.sqrt(sum_1)
        sum_2 = u_squared - 1.0 + v_squared
        sum_2_squared = sum_2**2
        sum_3 = 3.0 - 3.0 * u_squared + 2.0 * v_squared
        sigma_v_squared = sigma_v**2
        sum_4 = 4.5 * sigma_v_squared * sum_3 + sum_2_squared
        sum_5 = 1.0 - v
        sum_6 = 1.0 - v_squared + 4.0 * u_squared
        sigma_u_squared = sigma_u**2
        sum_7 = 1.0 + v
        sum_8 = 1.125 * sigma_u_squared * sum_6 + 0.5 * sum_2_squared
        sum_9 = 1.0 - 2.0 * u_squared + 11.0 * v_squared
        sum_10 = 1.0 + sum_9 * u_squared + (1.0 - 2.0 * v_squared) * v_squared
        sum_11 = 3.0 - 3.0 * v_squared + 2.0 * u_squared
        sum_12 = 1.5 * rho * sigma_v * sum_10 + 4.5 * sigma_u * sum_11 * u * v
        sum_13 = 0.75 * sigma_v * sum_10 + rho * sum_12
        sum_14 = sigma_v * sum_13 + sum_5 * sum_7 * sum_8
        sum_15 = sigma_u * sum_14 + rho * sigma_v * sum_4 * u * v
        sum_16 = 1.0 - u
        sum_17 = 1.0 - u_squared + 4.0 * v_squared
        sum_18 = 1.0 + u
        sum_19 = 1.125 * sigma_v_squared * sum_17 + 0.5 * sum_2_squared
        sum_20 = sigma_v_squared * sum_16 * sum_18 * sum_19 + sigma_u * sum_15
        sum_21 = root_1 + sum_20 / (root_1 * (root_1 * root_1**2)**2)
        r_squared = r**2
        sigma_r_squared = sigma_r**2
        sum_22 = 3.0 * sigma_u_squared + u_squared
        sum_23 = 3.0 * sigma_r_squared + r_squared
        term_1 = 1.0 / (root_1 * (root_1**2)**2)
        product_1 = sum_2 * sum_2_squared
        sum_24 = product_1 + sigma_v_squared * sum_1 * sum_16 * sum_18
        sum_25 = 3.0 * sigma_v_squared * sum_16 * sum_18 + sum_2_squared
        sum_26 = 1.0 - v_squared + 2.0 * u_squared
        product_2 = 3.0 * sigma_u_squared * sum_5 * sum_7
        sum_27 = 1.0 - u_squared + 2.0 * v_squared
        rho_squared = rho**2
        sum_28 = product_2 + (1.0 + 2.0 * rho_squared) * sigma_v_squared * sum_27 + sum_2_squared
        sum_29 = 3.0 * rho * sigma_u * sigma_v * sum_26 * v + sum_28 * u
        sum_30 = rho * sigma_v * sum_25 * v + sigma_u * sum_29
        sum_31 = 3.0 - 3.0 * v_squared - u_squared
        sum_32 = 4.0 - 3.0 * u_squared - 4.0 * v_squared
        sum_33 = rho * sigma_v * sum_31 * v + sigma_u * sum_32 * u
        sum_34 = r_squared * sum_30 + sigma_r_squared * sum_1 * sum_33
        sum_35 = sigma_r_squared * sum_24 * u + sigma_u * sum_34
        sum_36 = 3.0 * sigma_v_squared + v_squared
        sum_37 = product_1 + sigma_u_squared * sum_1 * sum_5 * sum_7
        sum_38 = 3.0 * sigma_v_squared * sum_27 + product_2 + sum_2_squared
        sum_39 = 2.0 * rho * sigma_u * sigma_v * sum_26 * v + sum_38 * u
        sum_40 = sigma_u * sigma_v * sum_26 * v + rho * sum_39
        sum_41 = sigma_v * sum_25 * v + sigma_u * sum_40
        sum_42 = 3.0 - 3.0 * u_squared - v_squared
        sum_43 = 4.0 - 3.0 * v_squared - 4.0 * u_squared
        sum_44 = rho * sigma_u * sum_42 * u + sigma_v * sum_43 * v
        sum_45 = r_squared * sum_41 + sigma_r_squared * sum_1 * sum_44
        sum_46 = sigma_r_squared * sum_37 * v + sigma_v * sum_45
        sum_47 = 2.0 * sum_2_squared + 6.0 * sigma_v_squared * sum_3
        sum_48 = 2.0 * sum_2_squared + 4.0 * sigma_v_squared * sum_16 * sum_18
        sum_49 = r_squared * sum_47 + sigma_r_squared * sum_48
        sigma_v_squared_squared = sigma_v_squared**2
        sum_50 = 18.0 * r_squared * sigma_v_squared_squared * sum_16 * sum_18 * sum_27 + sum_2_squared * sum_49
        sum_51 = 2.0 - 2.0 * v_squared - 3.0 * u_squared
        term_2 = (v - 1.0)**2
        sum_52 = 2.0 * sigma_v * sum_16 * sum_18 + 4.0 * rho * sigma_u * u * v
        sum_53 = 4.0 * rho_squared * sigma_v * u_squared * v_squared + sum_5 * sum_52 * sum_7
        sum_54 = sum_2_squared * sum_51 - sigma_u_squared * sum_7**2 * term_2 - sigma_v * sum_53
        sum_55 = 1.5 * sum_2_squared * sum_5 * sum_6 + 9.0 * sigma_u_squared * sum_7 * term_2 * u_squared
        sum_56 = 18.0 * sigma_u_squared * sum_26 * sum_5 * sum_7 + 6.0 * sum_11 * sum_2_squared
        sum_57 = 2.0 - 2.0 * u_squared + 11.0 * v_squared
        sum_58 = sum_57 * u_squared + (2.0 - 2.0 * v_squared) * v_squared
        sum_59 = 2.0 - 17.0 * v_squared + 5.0 * u_squared
        sum_60 = 7.0 - sum_59 * u_squared - (2.0 + 5.0 * v_squared) * v_squared
        sum_61 = 1.0 - 4.0 * u_squared + 22.0 * v_squared
        sum_62 = 3.0 + sum_61 * u_squared + (1.0 - 4.0 * v_squared) * v_squared
        sum_63 = 4.0 - 2.0 * u_squared + 14.0 * v_squared
        sum_64 = 2.0 - sum_63 * u_squared + (11.0 + 11.0 * v_squared) * v_squared
        sum_65 = sum_64 * u_squared + (3.0 - 3.0 * v_squared) * v_squared
        sum_66 = 11.0 - 14.0 * v_squared + 11.0 * u_squared
        sum_67 = 2.0 - (4.0 - 2.0 * v_squared) * v_squared + sum_66 * u_squared
        sum_68 = sum_67 * v_squared + (3.0 - 3.0 * u_squared) * u_squared
        sum_69 = 4.0 * sigma_u * sum_68 + 8.0 * rho * sigma_v * sum_26 * sum_27 * u * v
        sum_70 = 4.0 * sigma_v_squared * sum_65 + sum_2_squared * sum_62 + sigma_u * sum_69
        sum_71 = 4.0 * sigma_u * sigma_v * sum_60 * u * v + rho * sum_70
        sum_72 = 10.0 - 16.0 * v_squared + 10.0 * u_squared
        sum_73 = 1.0 - (2.0 - v_squared) * v_squared + sum_72 * u_squared
        sum_74 = sum_73 * v_squared + (6.0 - 6.0 * u_squared) * u_squared
        sum_75 = 2.0 - u_squared + 16.0 * v_squared
        sum_76 = 1.0 - sum_75 * u_squared + (10.0 + 10.0 * v_squared) * v_squared
        sum_77 = sum_76 * u_squared + (6.0 - 6.0 * v_squared) * v_squared
        sum_78 = sigma_u_squared * sum_74 + sigma_v_squared * sum_77 + sum_2_squared * sum_58 + rho * sum_71
        sum_79 = rho * sigma_u * sum_56 * u * v + sigma_v * sum_78
        sum_80 = sigma_u_squared * sum_55 * sum_7 + sum_2_squared**2 * u_squared + sigma_v * sum_79
        sum_81 = r_squared * sum_80 - sigma_r_squared * sum_2_squared * sum_54
        sum_82 = rho * sigma_v * sum_50 * u * v + sigma_u * sum_81
        sum_83 = 2.0 - 2.0 * u_squared - 3.0 * v_squared
        sum_18_squared = sum_18**2
        term_3 = (u - 1.0)**2
        sum_84 = sum_2_squared * sum_83 - sigma_v_squared * sum_18_squared * term_3
        sum_85 = 1.5 * sigma_v_squared * sum_16 * sum_17 * sum_18 + sum_2_squared * v_squared
        sum_86 = r_squared * sum_85 - sigma_r_squared * sum_84
        sum_87 = (
            9.0 * r_squared * sigma_v_squared_squared * sum_18_squared * term_3 * v_squared
            + sum_2_squared * sum_86
        )
        sum_88 = sigma_r_squared * sum_2_squared * sum_2_squared**2 + sigma_v_squared * sum_87 + sigma_u * sum_82
        mean[i, 0] = r * u
        mean[i, 1] = r * v
        mean[i, 2] = r * sum_21
        covariance[i, 0, 0] = r_squared * sigma_u_squared + sigma_r_squared * sum_22
        covariance[i, 0, 1] = sigma_r_squared * u * v + rho * sigma_u * sigma_v * sum_23
        covariance[i, 0, 2] = -sum_35 * term_1
        covariance[i, 1, 0] = covariance[i, 0, 1]
        covariance[i, 1, 1] = r_squared * sigma_v_squared + sigma_r_squared * sum_36
        covariance[i, 1, 2] = -sum_46 * term_1
        covariance[i, 2, 0] = covariance[i, 0, 2]
        covariance[i, 2, 1] = covariance[i, 1, 2]
        covariance[i, 2, 2] = sum_88 / (root_1 * (root_1**2)**2)**2


def ruv_unbiased(
    all_r: Floats,
    all_u: Floats,
    all_v: Floats,
    all_sigma_r: Floats,
    all_sigma_u: Floats,
    all_sigma_v: Floats,
    all_rho: Floats,
    mean: Filled,
    covariance: Filled,
) -> None:
    """Conversion ruv, unbiased.

    Mean: unbiased estimate of the position, to fourth order. Covariance: error covariance of the unbiased
    estimate u, to fourth order, completed to a sum of squares.
    """
    for i in range(len(all_r)):
        r = all_r[i]
        u = all_u[i]
        v = all_v[i]
        sigma_r = all_sigma_r[i]
        sigma_u = all_sigma_u[i]
        sigma_v = all_sigma_v[i]
        rho = all_rho[i]
        u_squared = u**2
        v_squared = v**2
        sum_1 = 1.0 - u_squared - v_squared
        root_1 = math.sqrt(sum_1)
        sum_2 = u_squared - 1.0 + v_squared
        sum_2_squared = sum_2**2
        sum_2_squared_squared = sum_2_squared**2
        sigma_v_squared = sigma_v**2
        sum_3 = 3.0 - 3.0 * u_squared + 2.0 * v_squared
        sum_4 = sum_2_squared - 1.5 * sigma_v_squared * sum_3
        sigma_u_squared = sigma_u**2
        sum_5 = 1.0 - v_squared + 4.0 * u_squared
        sum_6 = 1.0 - v
        sum_7 = 1.0 + v
        sum_8 = 0.5 * sum_2_squared - 0.375 * sigma_u_squared * sum_5
        sum_9 = 3.0 - 3.0 * v_squared + 2.0 * u_squared
        sum_10 = 1.0 - 2.0 * u_squared + 11.0 * v_squared
        product_1 = (1.0 - 2.0 * v_squared) * v_squared
        sum_11 = 1.0 + product_1 + sum_10 * u_squared
        sum_12 = 1.5 * sigma_u * sum_9 * u * v + 0.5 * rho * sigma_v * sum_11
        sum_13 = 0.25 * sigma_v * sum_11 + rho * sum_12
        sum_14 = sum_6 * sum_7 * sum_8 - sigma_v * sum_13
        sum_15 = sigma_u * sum_14 + rho * sigma_v * sum_4 * u * v
        sum_16 = 1.0 - u_squared + 4.0 * v_squared
        sum_17 = 1.0 - u
        sum_18 = 1.0 + u
        sum_19 = 0.5 * sum_2_squared - 0.375 * sigma_v_squared * sum_16
        sum_20 = sigma_v_squared * sum_17 * sum_18 * sum_19 + sigma_u * sum_15 + sum_2_squared_squared
        r_squared = r**2
        sigma_r_squared = sigma_r**2
        term_1 = 1.0 / (root_1 * (root_1**2)**2)
        product_2 = sum_2 * sum_2_squared
        sum_21 = product_2 + 0.5 * sigma_v_squared * sum_1 * sum_17 * sum_18
        sum_22 = 1.5 * sigma_v_squared * sum_17 * sum_18 + sum_2_squared
        sum_23 = 1.0 - v_squared + 2.0 * u_squared
        product_3 = 1.5 * sigma_u_squared * sum_6 * sum_7
        sum_24 = 1.0 - u_squared + 2.0 * v_squared
        rho_squared = rho**2
        sum_25 = product_3 + (0.5 + rho_squared) * sigma_v_squared * sum_24 + sum_2_squared
        sum_26 = 1.5 * rho * sigma_u * sigma_v * sum_23 * v + sum_25 * u
        sum_27 = rho * sigma_v * sum_22 * v + sigma_u * sum_26
        sum_28 = 3.0 - 2.0 * u_squared - 3.0 * v_squared
        sum_29 = 0.5 * sigma_u * sum_28 * u + rho * sigma_v * sum_6 * sum_7 * v
        sum_30 = r_squared * sum_27 + sigma_r_squared * sum_1 * sum_29
        sum_31 = sigma_r_squared * sum_21 * u + sigma_u * sum_30
        sum_32 = product_2 + 0.5 * sigma_u_squared * sum_1 * sum_6 * sum_7
        sum_33 = 1.5 * sigma_v_squared * sum_24 + product_3 + sum_2_squared
        sum_34 = rho * sigma_u * sigma_v * sum_23 * v + sum_33 * u
        sum_35 = 0.5 * sigma_u * sigma_v * sum_23 * v + rho * sum_34
        sum_36 = sigma_v * sum_22 * v + sigma_u * sum_35
        sum_37 = 3.0 - 2.0 * v_squared - 3.0 * u_squared
        sum_38 = rho * sigma_u * sum_17 * sum_18 * u + 0.5 * sigma_v * sum_37 * v
        sum_39 = r_squared * sum_36 + sigma_r_squared * sum_1 * sum_38
        sum_40 = sigma_r_squared * sum_32 * v + sigma_v * sum_39
        sum_41 = 2.0 - 2.0 * u_squared + v_squared
        sum_42 = 6.0 * sum_2_squared * sum_41 + 4.5 * sigma_v_squared * sum_17 * sum_18 * sum_24
        sum_43 = 2.0 * sum_2_squared_squared + sigma_v_squared * sum_42
        sum_44 = r_squared * sum_43 + sigma_r_squared * sigma_v_squared * sum_17 * sum_18 * sum_2_squared
        term_2 = (v - 1.0)**2
        sum_45 = 1.5 * sum_23 * sum_2_squared * sum_6 + 2.25 * sigma_u_squared * sum_7 * term_2 * u_squared
        sum_46 = 2.0 - 2.0 * v_squared + u_squared
        sum_47 = 6.0 * sum_2_squared * sum_46 + 4.5 * sigma_u_squared * sum_23 * sum_6 * sum_7
        sum_48 = 1.0 - 7.0 * v_squared + u_squared
        sum_49 = 2.0 - sum_48 * u_squared - v_squared * (1.0 + v_squared)
        sum_50 = 1.0 - 2.0 * u_squared + 14.0 * v_squared
        sum_51 = 1.0 + product_1 + sum_50 * u_squared
        sum_52 = 11.0 - 14.0 * v_squared + 11.0 * u_squared
        sum_53 = 2.0 - (4.0 - 2.0 * v_squared) * v_squared + sum_52 * u_squared
        sum_54 = sum_53 * v_squared + (3.0 - 3.0 * u_squared) * u_squared
        sum_55 = 2.0 * rho * sigma_v * sum_23 * sum_24 * u * v + sigma_u * sum_54
        sum_56 = 4.0 - 2.0 * u_squared + 14.0 * v_squared
        sum_57 = 2.0 - sum_56 * u_squared + (11.0 + 11.0 * v_squared) * v_squared
        sum_58 = sum_57 * u_squared + (3.0 - 3.0 * v_squared) * v_squared
        sum_59 = sigma_v_squared * sum_58 + sum_2_squared * sum_51 + sigma_u * sum_55
        sum_60 = 2.0 - 17.0 * v_squared + 5.0 * u_squared
        sum_61 = 7.0 - sum_60 * u_squared - (2.0 + 5.0 * v_squared) * v_squared
        sum_62 = rho * sum_59 + sigma_u * sigma_v * sum_61 * u * v
        sum_63 = 10.0 - 16.0 * v_squared + 10.0 * u_squared
        sum_64 = 1.0 - (2.0 - v_squared) * v_squared + sum_63 * u_squared
        sum_65 = sum_64 * v_squared + (6.0 - 6.0 * u_squared) * u_squared
        sum_66 = 2.0 - u_squared + 16.0 * v_squared
        sum_67 = 1.0 - sum_66 * u_squared + (10.0 + 10.0 * v_squared) * v_squared
        sum_68 = sum_67 * u_squared + (6.0 - 6.0 * v_squared) * v_squared
        sum_69 = (
            0.25 * sigma_u_squared * sum_65
            + 0.25 * sigma_v_squared * sum_68
            + sum_2_squared * sum_49
            + rho * sum_62
        )
        sum_70 = rho * sigma_u * sum_47 * u * v + sigma_v * sum_69
        sum_71 = sigma_u_squared * sum_45 * sum_7 + sum_2_squared_squared * u_squared + sigma_v * sum_70
        sum_72 = rho * sigma_u * u * v + 0.5 * sigma_v * sum_17 * sum_18
        sum_73 = rho_squared * sigma_v * u_squared * v_squared + sum_6 * sum_7 * sum_72
        sum_74 = product_2 + 0.25 * sigma_u_squared * sum_7**2 * term_2 + sigma_v * sum_73
        sum_75 = r_squared * sum_71 + sigma_r_squared * sum_2_squared * sum_74
        sum_76 = rho * sigma_v * sum_44 * u * v + sigma_u * sum_75
        sum_77 = 1.5 * sigma_v_squared * sum_17 * sum_18 * sum_24 + sum_2_squared * v_squared
        sum_18_squared = sum_18**2
        term_3 = (u - 1.0)**2
        sum_78 = product_2 + 0.25 * sigma_v_squared * sum_18_squared * term_3
        sum_79 = r_squared * sum_77 + sigma_r_squared * sum_78
        sum_80 = (
            2.25 * r_squared * sigma_v_squared**2 * sum_18_squared * term_3 * v_squared
            + sum_2_squared * sum_79
        )
        sum_81 = sigma_r_squared * sum_2_squared * sum_2_squared**2 + sigma_v_squared * sum_80 + sigma_u * sum_76
        mean[i, 0] = r * u
        mean[i, 1] = r * v
        mean[i, 2] = r * sum_20 / (root_1 * (root_1 * root_1**2)**2)
        covariance[i, 0, 0] = r_squared * sigma_u_squared + sigma_r_squared * (sigma_u_squared + u_squared)
        covariance[i, 0, 1] = (r_squared + sigma_r_squared) * rho * sigma_u * sigma_v + sigma_r_squared * u * v
        covariance[i, 0, 2] = -sum_31 * term_1
        covariance[i, 1, 0] = covariance[i, 0, 1]
        covariance[i, 1, 1] = r_squared * sigma_v_squared + sigma_r_squared * (sigma_v_squared + v_squared)
        covariance[i, 1, 2] = -sum_40 * term_1
        covariance[i, 2, 0] = covariance[i, 0, 2]
        covariance[i, 2, 1] = covariance[i, 1, 2]
        covariance[i, 2, 2] = sum_81 / (root_1 * (root_1**2)**2)**2


def ruv_posterior(
    all_r: Floats,
    all_u: Floats,
    all_v: Floats,
    all_sigma_r: Floats,
    all_sigma_u: Floats,
    all_sigma_v: Floats,
    all_rho: Floats,
    mean: Filled,
    covariance: Filled,
) -> None:
    """Conversion ruv, posterior.

    Mean: posterior mean of the position under a flat prior, to fourth order. Covariance: posterior covariance
    of the position under a flat prior, to fourth order, completed to a sum of squares.
    """
    for i in range(len(all_r)):
        r = all_r[i]
        u = all_u[i]
        v = all_v[i]
        sigma_r = all_sigma_r[i]
        sigma_u = all_sigma_u[i]
        sigma_v = all_sigma_v[i]
        rho = all_rho[i]
        u_squared = u**2
        v_squared = v**2
        sum_1 = 1.0 - u_squared - v_squared
        root_1 = math.sqrt(sum_1)
        sum_2 = u_squared - 1.0 + v_squared
        sum_2_squared = sum_2**2
        sum_2_squared_squared = sum_2_squared**2
        sigma_v_squared = sigma_v**2
        sum_3 = 3.0 - 3.0 * u_squared + 2.0 * v_squared
        sum_4 = 1.5 * sigma_v_squared * sum_3 + sum_2_squared
        sum_5 = 1.0 - v
        sigma_u_squared = sigma_u**2
        sum_6 = 1.0 - v_squared + 4.0 * u_squared
        sum_7 = 1.0 + v
        sum_8 = 0.375 * sigma_u_squared * sum_6 + 0.5 * sum_2_squared
        sum_9 = 3.0 - 3.0 * v_squared + 2.0 * u_squared
        sum_10 = 1.0 - 2.0 * u_squared + 11.0 * v_squared
        product_1 = (1.0 - 2.0 * v_squared) * v_squared
        sum_11 = 1.0 + product_1 + sum_10 * u_squared
        sum_12 = 1.5 * sigma_u * sum_9 * u * v + 0.5 * rho * sigma_v * sum_11
        sum_13 = 0.25 * sigma_v * sum_11 + rho * sum_12
        sum_14 = sigma_v * sum_13 + sum_5 * sum_7 * sum_8
        sum_15 = sigma_u * sum_14 + rho * sigma_v * sum_4 * u * v
        sum_16 = 1.0 - u
        sum_17 = 1.0 - u_squared + 4.0 * v_squared
        sum_18 = 1.0 + u
        sum_19 = 0.375 * sigma_v_squared * sum_17 + 0.5 * sum_2_squared
        sum_20 = sum_2_squared_squared - sigma_v_squared * sum_16 * sum_18 * sum_19 - sigma_u * sum_15
        r_squared = r**2
        sigma_r_squared = sigma_r**2
        term_1 = 1.0 / (root_1 * (root_1**2)**2)
        product_2 = sum_2 * sum_2_squared
        sum_21 = product_2 + 0.5 * sigma_v_squared * sum_1 * sum_16 * sum_18
        sum_22 = 1.5 * sigma_v_squared * sum_16 * sum_18 + sum_2_squared
        sum_23 = 1.0 - v_squared + 2.0 * u_squared
        product_3 = 1.5 * sigma_u_squared * sum_5 * sum_7
        sum_24 = 1.0 - u_squared + 2.0 * v_squared
        rho_squared = rho**2
        sum_25 = product_3 + (0.5 + rho_squared) * sigma_v_squared * sum_24 + sum_2_squared
        sum_26 = 1.5 * rho * sigma_u * sigma_v * sum_23 * v + sum_25 * u
        sum_27 = rho * sigma_v * sum_22 * v + sigma_u * sum_26
        sum_28 = 3.0 - 2.0 * u_squared - 3.0 * v_squared
        sum_29 = 0.5 * sigma_u * sum_28 * u + rho * sigma_v * sum_5 * sum_7 * v
        sum_30 = r_squared * sum_27 + sigma_r_squared * sum_1 * sum_29
        sum_31 = sigma_r_squared * sum_21 * u + sigma_u * sum_30
        sum_32 = product_2 + 0.5 * sigma_u_squared * sum_1 * sum_5 * sum_7
        sum_33 = 1.5 * sigma_v_squared * sum_24 + product_3 + sum_2_squared
        sum_34 = rho * sigma_u * sigma_v * sum_23 * v + sum_33 * u
        sum_35 = 0.5 * sigma_u * sigma_v * sum_23 * v + rho * sum_34
        sum_36 = sigma_v * sum_22 * v + sigma_u * sum_35
        sum_37 = 3.0 - 2.0 * v_squared - 3.0 * u_squared
        sum_38 = rho * sigma_u * sum_16 * sum_18 * u + 0.5 * sigma_v * sum_37 * v
        sum_39 = r_squared * sum_36 + sigma_r_squared * sum_1 * sum_38
        sum_40 = sigma_r_squared * sum_32 * v + sigma_v * sum_39
        sum_41 = 4.0 - 4.0 * u_squared + 3.0 * v_squared
        sum_42 = 2.0 * sum_2_squared * sum_41 + 4.5 * sigma_v_squared * sum_16 * sum_18 * sum_24
        sum_43 = 2.0 * sum_2_squared_squared + sigma_v_squared * sum_42
        sum_44 = r_squared * sum_43 + sigma_r_squared * sigma_v_squared * sum_16 * sum_18 * sum_2_squared
        sum_45 = 1.0 - v_squared + 6.0 * u_squared
        term_2 = (v - 1.0)**2
        sum_46 = 2.25 * sigma_u_squared * sum_7 * term_2 * u_squared + 0.5 * sum_2_squared * sum_45 * sum_5
        sum_47 = 4.0 - 4.0 * v_squared + 3.0 * u_squared
        sum_48 = 2.0 * sum_2_squared * sum_47 + 4.5 * sigma_u_squared * sum_23 * sum_5 * sum_7
        sum_49 = 1.0 - u_squared + 5.0 * v_squared
        sum_50 = sum_49 * u_squared + (1.0 - v_squared) * v_squared
        sum_51 = 1.0 - 2.0 * u_squared + 10.0 * v_squared
        sum_52 = 1.0 + product_1 + sum_51 * u_squared
        sum_53 = 11.0 - 14.0 * v_squared + 11.0 * u_squared
        sum_54 = 2.0 - (4.0 - 2.0 * v_squared) * v_squared + sum_53 * u_squared
        sum_55 = sum_54 * v_squared + (3.0 - 3.0 * u_squared) * u_squared
        sum_56 = 2.0 * rho * sigma_v * sum_23 * sum_24 * u * v + sigma_u * sum_55
        sum_57 = 4.0 - 2.0 * u_squared + 14.0 * v_squared
        sum_58 = 2.0 - sum_57 * u_squared + (11.0 + 11.0 * v_squared) * v_squared
        sum_59 = sum_58 * u_squared + (3.0 - 3.0 * v_squared) * v_squared
        sum_60 = sigma_v_squared * sum_59 + sum_2_squared * sum_52 + sigma_u * sum_56
        sum_61 = 2.0 - 17.0 * v_squared + 5.0 * u_squared
        sum_62 = 7.0 - sum_61 * u_squared - (2.0 + 5.0 * v_squared) * v_squared
        sum_63 = rho * sum_60 + sigma_u * sigma_v * sum_62 * u * v
        sum_64 = 10.0 - 16.0 * v_squared + 10.0 * u_squared
        sum_65 = 1.0 - (2.0 - v_squared) * v_squared + sum_64 * u_squared
        sum_66 = sum_65 * v_squared + (6.0 - 6.0 * u_squared) * u_squared
        sum_67 = 2.0 - u_squared + 16.0 * v_squared
        sum_68 = 1.0 - sum_67 * u_squared + (10.0 + 10.0 * v_squared) * v_squared
        sum_69 = sum_68 * u_squared + (6.0 - 6.0 * v_squared) * v_squared
        sum_70 = (
            0.25 * sigma_u_squared * sum_66
            + 0.25 * sigma_v_squared * sum_69
            + sum_2_squared * sum_50
            + rho * sum_63
        )
        sum_71 = rho * sigma_u * sum_48 * u * v + sigma_v * sum_70
        sum_72 = sigma_u_squared * sum_46 * sum_7 + sum_2_squared_squared * u_squared + sigma_v * sum_71
        sum_73 = rho * sigma_u * u * v + 0.5 * sigma_v * sum_16 * sum_18
        sum_74 = rho_squared * sigma_v * u_squared * v_squared + sum_5 * sum_7 * sum_73
        sum_75 = product_2 + 0.25 * sigma_u_squared * sum_7**2 * term_2 + sigma_v * sum_74
        sum_76 = r_squared * sum_72 + sigma_r_squared * sum_2_squared * sum_75
        sum_77 = rho * sigma_v * sum_44 * u * v + sigma_u * sum_76
        sum_78 = 1.0 - u_squared + 6.0 * v_squared
        sum_79 = 0.5 * sigma_v_squared * sum_16 * sum_18 * sum_78 + sum_2_squared * v_squared
        sum_18_squared = sum_18**2
        term_3 = (u - 1.0)**2
        sum_80 = product_2 + 0.25 * sigma_v_squared * sum_18_squared * term_3
        sum_81 = r_squared * sum_79 + sigma_r_squared * sum_80
        sum_82 = (
            2.25 * r_squared * sigma_v_squared**2 * sum_18_squared * term_3 * v_squared
            + sum_2_squared * sum_81
        )
        sum_83 = sigma_r_squared * sum_2_squared * sum_2_squared**2 + sigma_v_squared * sum_82 + sigma_u * sum_77
        mean[i, 0] = r * u
        mean[i, 1] = r * v
        mean[i, 2] = r * sum_20 / (root_1 * (root_1 * root_1**2)**2)
        covariance[i, 0, 0] = r_squared * sigma_u_squared + sigma_r_squared * (sigma_u_squared + u_squared)
        covariance[i, 0, 1] = (r_squared + sigma_r_squared) * rho * sigma_u * sigma_v + sigma_r_squared * u * v
        covariance[i, 0, 2] = -sum_31 * term_1
        covariance[i, 1, 0] = covariance[i, 0, 1]
        covariance[i, 1, 1] = r_squared * sigma_v_squared + sigma_r_squared * (sigma_v_squared + v_squared)
        covariance[i, 1, 2] = -sum_40 * term_1
        covariance[i, 2, 0] = covariance[i, 0, 2]
        covariance[i, 2, 1] = covariance[i, 1, 2]
        covariance[i, 2, 2] = sum_83 / (root_1 * (root_1**2)**2)**2


def spherical_linear(
    all_r: Floats,
    all_beta: Floats,
    all_epsilon: Floats,
    all_sigma_r: Floats,
    all_sigma_beta: Floats,
    all_sigma_epsilon: Floats,
    all_rho: Floats,
    mean: Filled,
    covariance: Filled,
) -> None:
    """Conversion spherical, linear.

    Mean: map from the measured quantities to coordinates. Covariance: covariance of the linearised
    conversion.
    """
    for i in range(len(all_r)):
        r = all_r[i]
        beta = all_beta[i]
        epsilon = all_epsilon[i]
        sigma_r = all_sigma_r[i]
        sigma_beta = all_sigma_beta[i]
        sigma_epsilon = all_sigma_epsilon[i]
        rho = all_rho[i]
        cos_beta = math.cos(beta)
        sin_beta = math.sin(beta)
        cos_epsilon = math.cos(epsilon)
        sin_epsilon = math.sin(epsilon)
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
        sum_1 = cos_beta * part_00_cos_beta2_cos_epsilon2 + part_00_cos_beta_cos_epsilon2_sin_beta * sin_beta
        sin_beta_squared = sin_beta**2
        cos_epsilon_squared = cos_epsilon**2
        sum_2 = cos_beta * sum_1 + sigma_r_squared * sin_beta_squared
        sin_epsilon_squared = sin_epsilon**2
        product_1 = cos_beta * part_01_cos_beta2_cos_epsilon2
        sum_3 = part_01_cos_beta_cos_epsilon2_sin_beta * sin_beta + product_1
        sum_4 = cos_epsilon_squared * sum_3 + part_00_sin_beta2_sin_epsilon2 * sin_beta * sin_epsilon_squared
        sum_5 = part_02_cos_epsilon_sin_beta_sin_epsilon * sin_beta + product_1
        sum_6 = cos_epsilon_squared * sigma_r_squared + part_00_sin_beta2_sin_epsilon2 * sin_epsilon_squared
        sum_7 = cos_beta * sum_6 - cos_epsilon_squared * part_00_cos_beta_cos_epsilon2_sin_beta * sin_beta
        sum_8 = cos_beta * part_02_cos_epsilon_sin_beta_sin_epsilon - part_01_cos_beta2_cos_epsilon2 * sin_beta
        mean[i, 0] = cos_epsilon * r * sin_beta
        mean[i, 1] = cos_beta * cos_epsilon * r
        mean[i, 2] = r * sin_epsilon
        covariance[i, 0, 0] = (
            cos_epsilon_squared * sum_2
            + part_00_sin_beta2_sin_epsilon2 * sin_beta_squared * sin_epsilon_squared
        )
        covariance[i, 0, 1] = (
            cos_beta * sum_4
            - cos_epsilon_squared * part_01_cos_beta2_cos_epsilon2 * sin_beta_squared
        )
        covariance[i, 0, 2] = cos_epsilon * sin_epsilon * sum_5
        covariance[i, 1, 0] = covariance[i, 0, 1]
        covariance[i, 1, 1] = (
            cos_beta * sum_7
            + cos_epsilon_squared * part_00_cos_beta2_cos_epsilon2 * sin_beta_squared
        )
        covariance[i, 1, 2] = cos_epsilon * sin_epsilon * sum_8
        covariance[i, 2, 0] = covariance[i, 0, 2]
        covariance[i, 2, 1] = covariance[i, 1, 2]
        covariance[i, 2, 2] = (
            cos_epsilon_squared * part_00_sin_beta2_sin_epsilon2
            + sigma_r_squared * sin_epsilon_squared
        )


def spherical_second_order(
    all_r: Floats,
    all_beta: Floats,
    all_epsilon: Floats,
    all_sigma_r: Floats,
    all_sigma_beta: Floats,
    all_sigma_epsilon: Floats,
    all_rho: Floats,
    mean: Filled,
    covariance: Filled,
) -> None:
    """Conversion spherical, second_order.

    Mean: map from the measured quantities to coordinates less the bias of the plain conversion to second
    order. Covariance: covariance of the conversion's quadratic Taylor polynomial.
    """
    for i in range(len(all_r)):
        r = all_r[i]
        beta = all_beta[i]
        epsilon = all_epsilon[i]
        sigma_r = all_sigma_r[i]
        sigma_beta = all_sigma_beta[i]
        sigma_epsilon = all_sigma_epsilon[i]
        rho = all_rho[i]
        cos_beta = math.cos(beta)
        sin_beta = math.sin(beta)
        cos_epsilon = math.cos(epsilon)
        sin_epsilon = math.sin(epsilon)
        part_0_cos_beta_cos_epsilon = rho * sigma_beta * sigma_r
        sigma_beta_squared = sigma_beta**2
        sigma_epsilon_squared = sigma_epsilon**2
        sum_1 = 0.5 * sigma_beta_squared + 0.5 * sigma_epsilon_squared
        part_0_cos_epsilon_sin_beta = -r * sum_1
        r_squared = r**2
        sigma_r_squared = sigma_r**2
        product_1 = (1.0 + rho**2) * sigma_r_squared
        part_00_cos_beta2_cos_epsilon2 = (product_1 + r_squared) * sigma_beta_squared
        part_00_cos_beta2_sin_epsilon2 = r_squared * sigma_beta_squared * sigma_epsilon_squared
        part_00_cos_beta_cos_epsilon2_sin_beta = (2.0 - 2.0 * sigma_beta_squared) * r * rho * sigma_beta * sigma_r
        part_00_cos_beta_sin_beta_sin_epsilon2 = 2.0 * r * rho * sigma_beta * sigma_epsilon_squared * sigma_r
        sigma_epsilon_squared_squared = sigma_epsilon_squared**2
        sum_2 = 0.5 * sigma_beta_squared**2 + 0.5 * sigma_epsilon_squared_squared
        part_00_cos_epsilon2_sin_beta2 = r_squared * sum_2 + sigma_r_squared
        part_00_sin_beta2_sin_epsilon2 = (r_squared + sigma_r_squared) * sigma_epsilon_squared
        sum_3 = 1.0 - sigma_beta_squared
        part_01_cos_beta2_cos_epsilon2 = r * rho * sigma_beta * sigma_r * sum_3
        part_01_cos_beta2_sin_epsilon2 = r * rho * sigma_beta * sigma_epsilon_squared * sigma_r
        sum_4 = product_1 + (1.0 - 0.5 * sigma_beta_squared) * r_squared
        product_2 = 0.5 * r_squared * sigma_epsilon_squared_squared
        part_01_cos_beta_cos_epsilon2_sin_beta = product_2 - sigma_beta_squared * sum_4 + sigma_r_squared
        sum_5 = r_squared * sum_3 + sigma_r_squared
        part_01_cos_beta_sin_beta_sin_epsilon2 = sigma_epsilon_squared * sum_5
        part_02_cos_beta_cos_epsilon_sin_epsilon = (1.0 - sigma_epsilon_squared) * r * rho * sigma_beta * sigma_r
        sum_6 = 1.0 - 0.5 * sigma_epsilon_squared
        sum_7 = r_squared * sum_6 + sigma_r_squared
        part_02_cos_epsilon_sin_beta_sin_epsilon = sigma_r_squared - sigma_epsilon_squared * sum_7
        part_22_sin_epsilon2 = product_2 + sigma_r_squared
        sum_8 = part_0_cos_epsilon_sin_beta - r
        sum_9 = cos_beta * part_0_cos_beta_cos_epsilon + sin_beta * sum_8
        sum_10 = cos_beta * sum_8 - part_0_cos_beta_cos_epsilon * sin_beta
        sum_11 = 1.0 + 0.5 * sigma_epsilon_squared
        cos_epsilon_squared = cos_epsilon**2
        sin_epsilon_squared = sin_epsilon**2
        sum_12 = (
            cos_epsilon_squared * part_00_cos_beta2_cos_epsilon2
            + part_00_cos_beta2_sin_epsilon2 * sin_epsilon_squared
        )
        sum_13 = (
            cos_epsilon_squared * part_00_cos_beta_cos_epsilon2_sin_beta
            + part_00_cos_beta_sin_beta_sin_epsilon2 * sin_epsilon_squared
        )
        sum_14 = cos_beta * sum_12 + sin_beta * sum_13
        sum_15 = (
            cos_epsilon_squared * part_00_cos_epsilon2_sin_beta2
            + part_00_sin_beta2_sin_epsilon2 * sin_epsilon_squared
        )
        sin_beta_squared = sin_beta**2
        sum_16 = (
            cos_epsilon_squared * part_01_cos_beta2_cos_epsilon2
            + part_01_cos_beta2_sin_epsilon2 * sin_epsilon_squared
        )
        sum_17 = (
            cos_epsilon_squared * part_01_cos_beta_cos_epsilon2_sin_beta
            + part_01_cos_beta_sin_beta_sin_epsilon2 * sin_epsilon_squared
        )
        sum_18 = cos_beta * sum_16 + sin_beta * sum_17
        sum_19 = (
            cos_beta * part_02_cos_beta_cos_epsilon_sin_epsilon
            + part_02_cos_epsilon_sin_beta_sin_epsilon * sin_beta
        )
        sum_20 = cos_beta * sum_15 - sin_beta * sum_13
        sum_21 = (
            cos_beta * part_02_cos_epsilon_sin_beta_sin_epsilon
            - part_02_cos_beta_cos_epsilon_sin_epsilon * sin_beta
        )
        mean[i, 0] = -cos_epsilon * sum_9
        mean[i, 1] = -cos_epsilon * sum_10
        mean[i, 2] = r * sin_epsilon * sum_11
        covariance[i, 0, 0] = cos_beta * sum_14 + sin_beta_squared * sum_15
        covariance[i, 0, 1] = cos_beta * sum_18 - sin_beta_squared * sum_16
        covariance[i, 0, 2] = cos_epsilon * sin_epsilon * sum_19
        covariance[i, 1, 0] = covariance[i, 0, 1]
        covariance[i, 1, 1] = cos_beta * sum_20 + sin_beta_squared * sum_12
        covariance[i, 1, 2] = cos_epsilon * sin_epsilon * sum_21
        covariance[i, 2, 0] = covariance[i, 0, 2]
        covariance[i, 2, 1] = covariance[i, 1, 2]
        covariance[i, 2, 2] = (
            cos_epsilon_squared * part_00_sin_beta2_sin_epsilon2
            + part_22_sin_epsilon2 * sin_epsilon_squared
        )


def spherical_averaged(
    all_r: Floats,
    all_beta: Floats,
    all_epsilon: Floats,
    all_sigma_r: Floats,
    all_sigma_beta: Floats,
    all_sigma_epsilon: Floats,
    all_rho: Floats,
    mean: Filled,
    covariance: Filled,
) -> None:
    """Conversion spherical, averaged.

    Mean: map from the measured quantities to coordinates less the exact bias of the plain conversion,
    averaged over the truth. Covariance: exact covariance of the plain conversion, averaged over the truth.
    """
    for i in range(len(all_r)):
        r = all_r[i]
        beta = all_beta[i]
        epsilon = all_epsilon[i]
        sigma_r = all_sigma_r[i]
        sigma_beta = all_sigma_beta[i]
        sigma_epsilon = all_sigma_epsilon[i]
        rho = all_rho[i]
        cos_beta = math.cos(beta)
        sin_beta = math.sin(beta)
        cos_epsilon = math.cos(epsilon)
        sin_epsilon = math.sin(epsilon)
        sigma_beta_squared = sigma_beta**2
        attenuation_beta = math.exp(-0.5 * sigma_beta_squared)
        shortfall_beta = -math.expm1(-0.5 * sigma_beta_squared)
        sigma_epsilon_squared = sigma_epsilon**2
        attenuation_epsilon = math.exp(-0.5 * sigma_epsilon_squared)
        shortfall_epsilon = -math.expm1(-0.5 * sigma_epsilon_squared)
        sum_1 = (1.0 - shortfall_epsilon) * shortfall_beta + shortfall_epsilon
        part_0_cos_epsilon_sin_beta = -attenuation_beta * attenuation_epsilon * r * sum_1
        attenuation_beta_2 = math.exp(-sigma_beta_squared)
        shortfall_beta_2 = -math.expm1(-sigma_beta_squared)
        attenuation_epsilon_2 = math.exp(-sigma_epsilon_squared)
        shortfall_epsilon_2 = -math.expm1(-sigma_epsilon_squared)
        attenuation_beta_2_squared = attenuation_beta_2**2
        product_1 = attenuation_beta_2 * attenuation_beta_2_squared
        shortfall_epsilon_2_squared = shortfall_epsilon_2**2
        shortfall_epsilon_2_squared_squared = shortfall_epsilon_2_squared**2
        product_2 = 16.0 * product_1 * shortfall_epsilon_2_squared_squared
        sum_2 = 2.0 * attenuation_epsilon_2 + 4.0 * shortfall_epsilon_2
        sum_3 = 3.0 * shortfall_epsilon_2_squared + attenuation_epsilon_2 * sum_2
        product_3 = shortfall_epsilon_2 * shortfall_epsilon_2_squared
        sum_4 = attenuation_epsilon_2 * sum_3 + product_3
        shortfall_beta_2_squared = shortfall_beta_2**2
        product_4 = shortfall_beta_2 * shortfall_beta_2_squared
        sum_5 = 12.0 * shortfall_epsilon_2 + 6.0 * attenuation_epsilon_2
        sum_6 = 9.0 * shortfall_epsilon_2_squared + attenuation_epsilon_2 * sum_5
        sum_7 = 24.0 * attenuation_epsilon_2 + 48.0 * shortfall_epsilon_2
        sum_8 = 12.0 * attenuation_epsilon_2 + 24.0 * shortfall_epsilon_2
        sum_9 = attenuation_beta_2 * sum_8 - shortfall_beta_2 * sum_7
        sum_10 = 66.0 * attenuation_beta_2 - 36.0 * shortfall_beta_2
        sum_11 = attenuation_epsilon_2 * sum_9 + shortfall_epsilon_2_squared * sum_10
        sum_12 = attenuation_beta_2 * sum_11 - shortfall_beta_2_squared * sum_6
        sum_13 = 54.0 * attenuation_beta_2 - 12.0 * shortfall_beta_2
        sum_14 = attenuation_beta_2 * sum_13 - 3.0 * shortfall_beta_2_squared
        sum_15 = attenuation_epsilon_2 * sum_12 + product_3 * sum_14
        sum_16 = attenuation_beta_2 * sum_15 - product_4 * sum_4
        rho_squared = rho**2
        sigma_r_squared = sigma_r**2
        sum_17 = attenuation_epsilon_2 * sum_16 + product_2
        sum_18 = 1.0 + attenuation_beta_2
        sum_19 = 1.0 - attenuation_epsilon_2 * sum_18
        attenuation_epsilon_2_squared = attenuation_epsilon_2**2
        sum_20 = 1.0 - attenuation_epsilon_2 + attenuation_beta_2 * sum_19
        sum_21 = 1.0 + attenuation_beta_2 + attenuation_epsilon_2_squared * sum_20
        sum_22 = 1.0 - attenuation_epsilon_2 * sum_21 + attenuation_beta_2 * sum_18
        attenuation_epsilon_2_squared_squared = attenuation_epsilon_2_squared**2
        r_squared = r**2
        sum_23 = 1.0 + attenuation_beta_2 * sum_22 + attenuation_epsilon_2_squared_squared
        sum_24 = 2.0 + 2.0 * attenuation_beta_2
        sum_25 = 1.0 - attenuation_epsilon_2 * sum_24
        sum_26 = 1.0 - 2.0 * attenuation_epsilon_2 + attenuation_beta_2 * sum_25
        sum_27 = 1.0 + attenuation_beta_2 + attenuation_epsilon_2_squared * sum_26
        product_5 = attenuation_beta_2 * sum_24
        sum_28 = 2.0 - attenuation_epsilon_2 * sum_27 + product_5
        sum_29 = 2.0 + 2.0 * attenuation_epsilon_2_squared_squared + attenuation_beta_2 * sum_28
        sum_30 = 0.25 * r_squared * sum_23 + 0.25 * sigma_r_squared * sum_29
        part_00_cos_beta2_cos_epsilon2 = (
            0.25 * attenuation_beta_2 * rho_squared * sigma_beta_squared * sigma_r_squared * sum_17
            + shortfall_beta_2 * sum_30
        )
        sum_31 = 2.0 * attenuation_epsilon_2 + 3.0 * shortfall_epsilon_2
        sum_32 = attenuation_epsilon_2 * sum_31 + shortfall_epsilon_2_squared
        sum_33 = 6.0 * attenuation_epsilon_2 + 9.0 * shortfall_epsilon_2
        sum_34 = 3.0 * shortfall_epsilon_2_squared + attenuation_epsilon_2 * sum_33
        sum_35 = 24.0 * attenuation_epsilon_2 + 36.0 * shortfall_epsilon_2
        sum_36 = 44.0 * attenuation_epsilon_2 + 66.0 * shortfall_epsilon_2
        sum_37 = attenuation_beta_2 * sum_36 - shortfall_beta_2 * sum_35
        sum_38 = attenuation_epsilon_2 * sum_37 + shortfall_epsilon_2_squared * sum_13
        sum_39 = attenuation_beta_2 * sum_38 - shortfall_beta_2_squared * sum_34
        sum_40 = attenuation_beta_2 * sum_39 - product_4 * sum_32
        sum_41 = 16.0 * product_1 * product_3 + attenuation_epsilon_2 * sum_40
        product_6 = attenuation_epsilon_2 * (1.0 + attenuation_epsilon_2)
        sum_42 = 1.0 + product_6
        product_7 = attenuation_epsilon_2 * sum_42
        product_8 = attenuation_epsilon_2 * attenuation_epsilon_2_squared
        sum_43 = 1.0 + attenuation_beta_2 * (1.0 + product_7) + product_8
        sum_44 = 1.0 + attenuation_beta_2 * sum_43 + product_8
        sum_45 = 1.0 + attenuation_beta_2 * sum_44 + product_7
        sum_46 = 2.0 + 2.0 * attenuation_epsilon_2
        sum_47 = 1.0 + 2.0 * attenuation_epsilon_2 + attenuation_beta_2 * sum_46
        sum_48 = 1.0 + 2.0 * attenuation_beta_2 + attenuation_epsilon_2 * sum_47
        sum_49 = 1.0 + 2.0 * attenuation_epsilon_2
        product_9 = attenuation_epsilon_2 * sum_49
        sum_50 = 1.0 + attenuation_beta_2 * sum_48 + product_9
        sum_51 = 2.0 + attenuation_epsilon_2 * sum_50 + product_5
        product_10 = attenuation_epsilon_2 * sum_46
        sum_52 = 2.0 + product_10
        sum_53 = 2.0 + attenuation_beta_2 * sum_51 + attenuation_epsilon_2 * sum_52
        sum_54 = 0.25 * r_squared * sum_45 + 0.25 * sigma_r_squared * sum_53
        sum_55 = (
            0.25 * attenuation_beta_2 * rho_squared * sigma_beta_squared * sigma_r_squared * sum_41
            + shortfall_beta_2 * sum_54
        )
        part_00_cos_beta2_sin_epsilon2 = shortfall_epsilon_2 * sum_55
        attenuation_beta_2_squared_squared = attenuation_beta_2_squared**2
        sum_56 = 1.5 * attenuation_epsilon_2 + 1.5 * shortfall_epsilon_2
        sum_57 = attenuation_epsilon_2 * sum_56 + 0.5 * shortfall_epsilon_2_squared
        sum_58 = 3.0 * attenuation_epsilon_2 + 3.0 * shortfall_epsilon_2
        sum_59 = attenuation_epsilon_2 * sum_58 + shortfall_epsilon_2_squared
        sum_60 = 1.5 * attenuation_epsilon_2 + 3.0 * shortfall_epsilon_2
        sum_61 = attenuation_beta_2 * sum_60 + shortfall_beta_2 * sum_60
        sum_62 = 5.25 * shortfall_beta_2 + 6.75 * attenuation_beta_2
        sum_63 = attenuation_epsilon_2 * sum_61 + shortfall_epsilon_2_squared * sum_62
        sum_64 = 0.5 * attenuation_epsilon_2 + shortfall_epsilon_2
        sum_65 = 1.5 * shortfall_epsilon_2_squared + attenuation_epsilon_2 * sum_64
        sum_66 = attenuation_beta_2 * sum_63 + shortfall_beta_2_squared * sum_65
        sum_67 = 3.75 * shortfall_beta_2 + 5.25 * attenuation_beta_2
        sum_68 = attenuation_beta_2 * sum_67 + shortfall_beta_2_squared
        sum_69 = attenuation_epsilon_2 * sum_66 + product_3 * sum_68
        sum_70 = 1.5 * attenuation_beta_2 + shortfall_beta_2
        sum_71 = attenuation_beta_2 * sum_70 + 0.25 * shortfall_beta_2_squared
        sum_72 = attenuation_epsilon_2 * sum_69 + shortfall_epsilon_2_squared_squared * sum_71
        sum_73 = product_1 * shortfall_epsilon_2_squared * sum_59 + shortfall_beta_2 * sum_72
        sum_74 = (
            attenuation_beta_2_squared_squared * shortfall_epsilon_2_squared * sum_57
            + shortfall_beta_2 * sum_73
        )
        sum_75 = 16.0 * attenuation_epsilon_2 + 32.0 * shortfall_epsilon_2
        sum_76 = attenuation_beta_2 * sum_75 - shortfall_beta_2 * sum_8
        sum_77 = 72.0 * attenuation_beta_2 - 18.0 * shortfall_beta_2
        sum_78 = attenuation_epsilon_2 * sum_76 + shortfall_epsilon_2_squared * sum_77
        sum_79 = attenuation_beta_2 * sum_78 + shortfall_beta_2_squared * sum_6
        sum_80 = 56.0 * attenuation_beta_2 - 6.0 * shortfall_beta_2
        sum_81 = 3.0 * shortfall_beta_2_squared + attenuation_beta_2 * sum_80
        sum_82 = attenuation_epsilon_2 * sum_79 + product_3 * sum_81
        sum_83 = attenuation_beta_2 * sum_82 + product_4 * sum_4
        sum_84 = attenuation_epsilon_2 * sum_83 + product_2
        sum_85 = 0.25 - 0.5 * attenuation_beta_2 * attenuation_epsilon_2
        sum_86 = 0.25 + attenuation_epsilon_2_squared * sum_85
        sum_87 = 0.25 + attenuation_beta_2_squared * sum_86 + 0.25 * attenuation_epsilon_2_squared
        sum_88 = 0.5 * product_1 - attenuation_epsilon_2 * sum_87
        sum_89 = (
            0.5
            - 0.25 * attenuation_beta_2 * rho_squared * sigma_beta_squared * sum_84
            + attenuation_beta_2 * sum_88
            + 0.5 * attenuation_epsilon_2_squared_squared
        )
        part_00_cos_epsilon2_sin_beta2 = r_squared * sum_74 + sigma_r_squared * sum_89
        sum_90 = 1.0 - attenuation_beta_2 * sum_42 + attenuation_epsilon_2
        sum_91 = 1.0 + attenuation_beta_2_squared * sum_90 + attenuation_epsilon_2
        sum_92 = 1.0 - attenuation_beta_2 * sum_91 + product_6
        sum_93 = 1.0 + attenuation_beta_2_squared_squared + attenuation_epsilon_2 * sum_92
        sum_94 = 16.0 + 16.0 * attenuation_epsilon_2
        sum_95 = 16.0 + attenuation_epsilon_2 * sum_94
        sum_96 = 9.0 - attenuation_beta_2 * sum_95 + 9.0 * attenuation_epsilon_2
        sum_97 = 1.0 - attenuation_beta_2_squared * sum_96 + attenuation_epsilon_2
        sum_98 = 16.0 * product_1 + attenuation_epsilon_2 * sum_97
        sum_99 = 1.0 - attenuation_beta_2 * sum_52 + attenuation_epsilon_2
        sum_100 = 1.0 + attenuation_beta_2_squared * sum_99 + attenuation_epsilon_2
        sum_101 = 2.0 - attenuation_beta_2 * sum_100 + product_10
        sum_102 = (
            0.5
            - 0.25 * attenuation_beta_2 * rho_squared * sigma_beta_squared * sum_98
            + 0.5 * attenuation_beta_2_squared_squared
            + 0.25 * attenuation_epsilon_2 * sum_101
        )
        sum_103 = 0.25 * r_squared * sum_93 + sigma_r_squared * sum_102
        part_00_sin_beta2_sin_epsilon2 = shortfall_epsilon_2 * sum_103
        sum_104 = 3.0 * attenuation_epsilon_2 + shortfall_epsilon_2
        sum_105 = attenuation_beta_2 * sum_58 - shortfall_beta_2 * sum_104
        sum_106 = 4.0 * attenuation_epsilon_2_squared * shortfall_beta_2 - shortfall_epsilon_2 * sum_105
        sum_107 = 2.0 * product_8 * shortfall_beta_2 + shortfall_epsilon_2 * sum_106
        product_11 = attenuation_beta_2 * shortfall_epsilon_2_squared_squared
        sum_108 = product_11 - attenuation_epsilon_2 * sum_107
        sum_109 = 18.0 * attenuation_epsilon_2 + 36.0 * shortfall_epsilon_2
        sum_110 = 14.0 * attenuation_epsilon_2 + 28.0 * shortfall_epsilon_2
        sum_111 = attenuation_beta_2 * sum_110 - shortfall_beta_2 * sum_109
        sum_112 = 69.0 * attenuation_beta_2 - 27.0 * shortfall_beta_2
        sum_113 = attenuation_epsilon_2 * sum_111 + shortfall_epsilon_2_squared * sum_112
        sum_114 = 55.0 * attenuation_beta_2 - 9.0 * shortfall_beta_2
        sum_115 = attenuation_epsilon_2 * sum_113 + product_3 * sum_114
        sum_116 = (
            16.0 * attenuation_beta_2 * shortfall_epsilon_2_squared_squared
            + attenuation_epsilon_2 * sum_115
        )
        product_12 = attenuation_beta_2 * sum_2
        sum_117 = product_12 - shortfall_beta_2 * sum_2
        sum_118 = 9.0 * attenuation_beta_2 - 3.0 * shortfall_beta_2
        sum_119 = attenuation_epsilon_2 * sum_117 + shortfall_epsilon_2_squared * sum_118
        sum_120 = 7.0 * attenuation_beta_2 - shortfall_beta_2
        sum_121 = attenuation_epsilon_2 * sum_119 + product_3 * sum_120
        sum_122 = (
            0.5 * attenuation_epsilon_2 * sum_121
            - 0.5 * rho_squared * sigma_beta_squared * sum_116
            + product_11
        )
        sum_123 = 0.5 * r_squared * sum_108 + sigma_r_squared * sum_122
        part_01_cos_beta_cos_epsilon2_sin_beta = product_1 * sum_123
        product_13 = attenuation_beta_2 * product_3
        product_14 = -shortfall_beta_2 * sum_31
        sum_124 = attenuation_beta_2 * sum_31 + product_14
        sum_125 = 3.0 * attenuation_beta_2 - shortfall_beta_2
        sum_126 = attenuation_epsilon_2 * sum_124 + shortfall_epsilon_2_squared * sum_125
        sum_127 = attenuation_epsilon_2 * sum_126 + product_13
        sum_128 = 18.0 * attenuation_epsilon_2 + 27.0 * shortfall_epsilon_2
        sum_129 = 46.0 * attenuation_epsilon_2 + 69.0 * shortfall_epsilon_2
        sum_130 = attenuation_beta_2 * sum_129 - shortfall_beta_2 * sum_128
        sum_131 = attenuation_epsilon_2 * sum_130 + shortfall_epsilon_2_squared * sum_114
        sum_132 = 16.0 * attenuation_beta_2 * product_3 + attenuation_epsilon_2 * sum_131
        sum_133 = attenuation_beta_2 * sum_33 + product_14
        sum_134 = attenuation_epsilon_2 * sum_133 + shortfall_epsilon_2_squared * sum_120
        sum_135 = (
            0.5 * attenuation_epsilon_2 * sum_134
            - 0.5 * rho_squared * sigma_beta_squared * sum_132
            + product_13
        )
        sum_136 = 0.5 * r_squared * sum_127 + sigma_r_squared * sum_135
        part_01_cos_beta_sin_beta_sin_epsilon2 = product_1 * shortfall_epsilon_2 * sum_136
        sum_137 = 1.0 - 2.0 * rho_squared * sigma_beta_squared
        sum_138 = attenuation_epsilon_2 - shortfall_epsilon_2
        sum_139 = r_squared * shortfall_epsilon_2 - sigma_r_squared * sum_137 * sum_138
        part_02_cos_epsilon_sin_beta_sin_epsilon = -attenuation_beta_2 * product_8 * sum_139
        sum_140 = 2.0 + attenuation_epsilon_2 * (1.0 + product_9)
        sum_141 = 0.5 * (1.0 + product_8) * r_squared + 0.5 * sigma_r_squared * sum_140
        part_22_cos_epsilon2 = shortfall_epsilon_2 * sum_141
        sum_142 = 0.5 + (0.5 - attenuation_epsilon_2) * attenuation_epsilon_2_squared
        sum_143 = 1.0 - attenuation_epsilon_2 * sum_142
        part_22_sin_epsilon2 = 0.5 * r_squared * shortfall_epsilon_2_squared * sum_42 + sigma_r_squared * sum_143
        sum_144 = attenuation_epsilon + shortfall_epsilon
        sum_145 = attenuation_epsilon - shortfall_epsilon
        sum_146 = attenuation_beta * sum_145 - shortfall_beta * sum_144
        sum_147 = part_0_cos_epsilon_sin_beta - r
        sum_148 = (
            attenuation_beta * attenuation_epsilon * cos_beta * rho * sigma_beta * sigma_r * sum_146
            + sin_beta * sum_147
        )
        sum_149 = (
            attenuation_beta * attenuation_epsilon * rho * sigma_beta * sigma_r * sin_beta * sum_146
            - cos_beta * sum_147
        )
        sum_150 = 1.0 + attenuation_epsilon * shortfall_epsilon
        sum_151 = product_12 - shortfall_beta_2 * sum_5
        sum_152 = 15.0 * attenuation_beta_2 - 9.0 * shortfall_beta_2
        sum_153 = attenuation_epsilon_2 * sum_151 + shortfall_epsilon_2_squared * sum_152
        sum_154 = 13.0 * attenuation_beta_2 - 3.0 * shortfall_beta_2
        sum_155 = attenuation_epsilon_2 * sum_153 + product_3 * sum_154
        sum_156 = 4.0 * attenuation_beta_2 * shortfall_epsilon_2_squared_squared + attenuation_epsilon_2 * sum_155
        cos_epsilon_squared = cos_epsilon**2
        sum_157 = 10.0 * attenuation_epsilon_2 + 15.0 * shortfall_epsilon_2
        sum_158 = attenuation_beta_2 * sum_157 - shortfall_beta_2 * sum_33
        sum_159 = attenuation_epsilon_2 * sum_158 + shortfall_epsilon_2_squared * sum_154
        sum_160 = 4.0 * attenuation_beta_2 * product_3 + attenuation_epsilon_2 * sum_159
        sin_epsilon_squared = sin_epsilon**2
        sum_161 = cos_epsilon_squared * sum_156 + shortfall_epsilon_2 * sin_epsilon_squared * sum_160
        product_15 = product_1 * r * rho * sigma_beta * sigma_r * sin_beta * sum_161
        sum_162 = (
            cos_epsilon_squared * part_00_cos_beta2_cos_epsilon2
            + part_00_cos_beta2_sin_epsilon2 * sin_epsilon_squared
        )
        sum_163 = cos_beta * sum_162 + product_15
        sum_164 = (
            cos_epsilon_squared * part_00_cos_epsilon2_sin_beta2
            + part_00_sin_beta2_sin_epsilon2 * sin_epsilon_squared
        )
        sin_beta_squared = sin_beta**2
        sum_165 = 0.5 * cos_beta**2 - 0.5 * sin_beta_squared
        sum_166 = (
            cos_epsilon_squared * sum_156 * sum_165
            + shortfall_epsilon_2 * sin_epsilon_squared * sum_160 * sum_165
        )
        sum_167 = (
            cos_epsilon_squared * part_01_cos_beta_cos_epsilon2_sin_beta
            + part_01_cos_beta_sin_beta_sin_epsilon2 * sin_epsilon_squared
        )
        sum_168 = attenuation_epsilon_2 - 3.0 * shortfall_epsilon_2
        sum_169 = (
            attenuation_beta_2 * cos_beta * product_8 * r * rho * sigma_beta * sigma_r * sum_168
            + part_02_cos_epsilon_sin_beta_sin_epsilon * sin_beta
        )
        sum_170 = product_15 - cos_beta * sum_164
        sum_171 = (
            attenuation_beta_2 * product_8 * r * rho * sigma_beta * sigma_r * sin_beta * sum_168
            - cos_beta * part_02_cos_epsilon_sin_beta_sin_epsilon
        )
        mean[i, 0] = -cos_epsilon * sum_148
        mean[i, 1] = cos_epsilon * sum_149
        mean[i, 2] = r * sin_epsilon * sum_150
        covariance[i, 0, 0] = cos_beta * sum_163 + sin_beta_squared * sum_164
        covariance[i, 0, 1] = (
            cos_beta * sin_beta * sum_167
            + product_1 * r * rho * sigma_beta * sigma_r * sum_166
        )
        covariance[i, 0, 2] = cos_epsilon * sin_epsilon * sum_169
        covariance[i, 1, 0] = covariance[i, 0, 1]
        covariance[i, 1, 1] = sin_beta_squared * sum_162 - cos_beta * sum_170
        covariance[i, 1, 2] = -cos_epsilon * sin_epsilon * sum_171
        covariance[i, 2, 0] = covariance[i, 0, 2]
        covariance[i, 2, 1] = covariance[i, 1, 2]
        covariance[i, 2, 2] = (
            cos_epsilon_squared * part_22_cos_epsilon2
            + part_22_sin_epsilon2 * sin_epsilon_squared
        )


def spherical_unbiased(
    all_r: Floats,
    all_beta: Floats,
    all_epsilon: Floats,
    all_sigma_r: Floats,
    all_sigma_beta: Floats,
    all_sigma_epsilon: Floats,
    all_rho: Floats,
    mean: Filled,
    covariance: Filled,
) -> None:
    """Conversion spherical, unbiased.

    Mean: exactly unbiased estimate of the position. Covariance: error covariance of the unbiased estimate u.
    """
    for i in range(len(all_r)):
        r = all_r[i]
        beta = all_beta[i]
        epsilon = all_epsilon[i]
        sigma_r = all_sigma_r[i]
        sigma_beta = all_sigma_beta[i]
        sigma_epsilon = all_sigma_epsilon[i]
        rho = all_rho[i]
        cos_beta = math.cos(beta)
        sin_beta = math.sin(beta)
        cos_epsilon = math.cos(epsilon)
        sin_epsilon = math.sin(epsilon)
        sigma_beta_squared = sigma_beta**2
        attenuation_beta = math.exp(-0.5 * sigma_beta_squared)
        sigma_epsilon_squared = sigma_epsilon**2
        attenuation_epsilon = math.exp(-0.5 * sigma_epsilon_squared)
        term_1 = 1.0 / attenuation_beta
        term_2 = 1.0 / attenuation_epsilon
        part_0_cos_beta_cos_epsilon = -rho * sigma_beta * sigma_r * term_1 * term_2
        part_0_cos_epsilon_sin_beta = r * term_1 * term_2
        shortfall_beta = -math.expm1(-0.5 * sigma_beta_squared)
        attenuation_epsilon_2 = math.exp(-sigma_epsilon_squared)
        shortfall_epsilon = -math.expm1(-sigma_epsilon_squared)
        term_3 = 1.0 / attenuation_epsilon_2
        term_4 = 1.0 / attenuation_beta**2
        attenuation_beta_squared = attenuation_beta**2
        attenuation_beta_squared_squared = attenuation_beta_squared**2
        attenuation_epsilon_2_squared = attenuation_epsilon_2**2
        sum_1 = 1.0 + attenuation_epsilon_2_squared
        sum_2 = 2.0 + attenuation_beta_squared_squared * sum_1
        rho_squared = rho**2
        sigma_r_squared = sigma_r**2
        sum_3 = 1.0 + attenuation_beta_squared * attenuation_epsilon_2 * sum_2
        sum_4 = 1.0 + attenuation_beta * sum_1 + attenuation_epsilon_2_squared
        sum_5 = 1.0 + attenuation_beta * sum_4 + attenuation_epsilon_2_squared
        r_squared = r**2
        sum_6 = 0.25 * r_squared + 0.25 * sigma_r_squared
        sum_7 = 1.0 + attenuation_beta * sum_5 + attenuation_epsilon_2_squared
        part_00_cos_beta2_cos_epsilon2 = (
            rho_squared * sigma_beta_squared * sigma_r_squared * sum_3 * term_3 * term_4
            + shortfall_beta * sum_6 * sum_7
        )
        sum_8 = 1.0 + attenuation_epsilon_2
        sum_9 = 1.0 + attenuation_beta * sum_8 + attenuation_epsilon_2
        sum_10 = 1.0 + attenuation_beta * sum_9 + attenuation_epsilon_2
        sum_11 = 1.0 + attenuation_beta * sum_10 + attenuation_epsilon_2
        sum_12 = (
            attenuation_beta_squared_squared * rho_squared * sigma_beta_squared * sigma_r_squared * sum_8
            + shortfall_beta * sum_11 * sum_6
        )
        part_00_cos_beta2_sin_epsilon2 = shortfall_epsilon * sum_12
        attenuation_beta_squared_cubed = attenuation_beta_squared * attenuation_beta_squared**2
        shortfall_epsilon_squared = shortfall_epsilon**2
        sum_13 = 4.0 * shortfall_epsilon + 6.0 * attenuation_epsilon_2
        sum_14 = 16.0 * attenuation_epsilon_2 + 44.0 * shortfall_epsilon
        sum_15 = 24.0 * shortfall_epsilon_squared + attenuation_epsilon_2 * sum_14
        sum_16 = 24.0 * attenuation_epsilon_2 + 96.0 * shortfall_epsilon
        sum_17 = 184.0 * shortfall_epsilon + 56.0 * attenuation_epsilon_2
        sum_18 = attenuation_beta * sum_16 + shortfall_beta * sum_17
        sum_19 = 138.0 * attenuation_beta + 212.0 * shortfall_beta
        sum_20 = attenuation_epsilon_2 * sum_18 + shortfall_epsilon_squared * sum_19
        sum_21 = 166.0 * shortfall_epsilon + 54.0 * attenuation_epsilon_2
        shortfall_beta_squared = shortfall_beta**2
        sum_22 = 173.0 * shortfall_epsilon_squared + attenuation_epsilon_2 * sum_21
        sum_23 = attenuation_beta * sum_20 + shortfall_beta_squared * sum_22
        sum_24 = 60.0 * attenuation_beta + 80.0 * shortfall_beta
        product_1 = shortfall_epsilon * shortfall_epsilon_squared
        sum_25 = 60.0 * shortfall_beta_squared + attenuation_beta * sum_24
        sum_26 = attenuation_epsilon_2 * sum_23 + product_1 * sum_25
        sum_27 = 24.0 * attenuation_epsilon_2 + 72.0 * shortfall_epsilon
        sum_28 = 72.0 * shortfall_epsilon_squared + attenuation_epsilon_2 * sum_27
        product_2 = shortfall_beta * shortfall_beta_squared
        sum_29 = 24.0 * product_1 + attenuation_epsilon_2 * sum_28
        sum_30 = attenuation_beta * sum_26 + product_2 * sum_29
        sum_31 = 12.0 * shortfall_epsilon + 4.0 * attenuation_epsilon_2
        sum_32 = 12.0 * shortfall_epsilon_squared + attenuation_epsilon_2 * sum_31
        shortfall_beta_squared_squared = shortfall_beta_squared**2
        sum_33 = 4.0 * product_1 + attenuation_epsilon_2 * sum_32
        sum_34 = attenuation_beta * sum_30 + shortfall_beta_squared_squared * sum_33
        sum_35 = (
            attenuation_beta * attenuation_beta_squared**2 * shortfall_epsilon * sum_15
            + shortfall_beta * sum_34
        )
        sum_36 = attenuation_beta_squared_cubed * shortfall_epsilon_squared * sum_13 + shortfall_beta * sum_35
        sum_37 = 0.25 + 0.25 * attenuation_epsilon_2_squared
        sum_38 = (
            0.25
            - attenuation_beta_squared_squared * rho_squared * sigma_beta_squared * sum_1
            + attenuation_beta_squared_squared * sum_37
            + 0.25 * attenuation_epsilon_2_squared
        )
        part_00_cos_epsilon2_sin_beta2 = 0.25 * r_squared * sum_36 * term_3 * term_4 + sigma_r_squared * sum_38
        sum_39 = 1.0 + attenuation_beta_squared_squared * sum_8 + attenuation_epsilon_2
        sum_40 = (
            sum_39 * sum_6
            - attenuation_beta_squared_squared * rho_squared * sigma_beta_squared * sigma_r_squared * sum_8
        )
        part_00_sin_beta2_sin_epsilon2 = shortfall_epsilon * sum_40
        sum_41 = 2.0 + 2.0 * attenuation_epsilon_2_squared
        sum_42 = 2.0 + attenuation_beta_squared_squared * sum_41
        sum_43 = 1.0 + attenuation_beta_squared * attenuation_epsilon_2 * sum_42
        sum_44 = 2.0 * attenuation_epsilon_2 + 6.0 * shortfall_epsilon
        sum_45 = 6.0 * shortfall_epsilon_squared + attenuation_epsilon_2 * sum_44
        product_3 = shortfall_beta * shortfall_beta_squared**2
        sum_46 = 2.0 * product_1 + attenuation_epsilon_2 * sum_45
        sum_47 = 12.0 * attenuation_epsilon_2 + 36.0 * shortfall_epsilon
        sum_48 = 36.0 * shortfall_epsilon_squared + attenuation_epsilon_2 * sum_47
        sum_49 = 12.0 * product_1 + attenuation_epsilon_2 * sum_48
        sum_50 = 26.0 * attenuation_epsilon_2 + 82.0 * shortfall_epsilon
        sum_51 = 86.0 * shortfall_epsilon_squared + attenuation_epsilon_2 * sum_50
        sum_52 = 30.0 * product_1 + attenuation_epsilon_2 * sum_51
        sum_53 = 12.0 * attenuation_beta + 30.0 * shortfall_beta
        sum_54 = 40.0 * shortfall_beta_squared + attenuation_beta * sum_53
        sum_55 = 24.0 * attenuation_epsilon_2 + 88.0 * shortfall_epsilon
        sum_56 = 104.0 * shortfall_epsilon_squared + attenuation_epsilon_2 * sum_55
        sum_57 = 20.0 * attenuation_beta + 66.0 * shortfall_beta
        sum_58 = 42.0 * shortfall_epsilon + 6.0 * attenuation_epsilon_2
        sum_59 = 4.0 * attenuation_epsilon_2 - 4.0 * shortfall_epsilon
        sum_60 = attenuation_beta * sum_59 - shortfall_beta * sum_58
        sum_61 = attenuation_epsilon_2 * sum_60 - shortfall_epsilon_squared * sum_57
        sum_62 = attenuation_beta * sum_61 - shortfall_beta_squared * sum_56
        sum_63 = attenuation_epsilon_2 * sum_62 - product_1 * sum_54
        sum_64 = attenuation_beta * sum_63 - product_2 * sum_52
        sum_65 = attenuation_beta * sum_64 - shortfall_beta_squared_squared * sum_49
        sum_66 = attenuation_beta * sum_65 - product_3 * sum_46
        sum_67 = 2.0 * shortfall_epsilon + 3.0 * attenuation_epsilon_2
        sum_68 = attenuation_beta_squared_cubed * shortfall_epsilon_squared * sum_67 - shortfall_beta * sum_66
        sum_69 = 0.5 * r_squared * sum_68 - rho_squared * sigma_beta_squared * sigma_r_squared * sum_43
        part_01_cos_beta_cos_epsilon2_sin_beta = (
            0.5 * attenuation_beta_squared_squared * sigma_r_squared * sum_1
            + sum_69 * term_3 * term_4
        )
        sum_70 = 0.5 - 2.0 * rho_squared * sigma_beta_squared
        sum_71 = 0.5 * r_squared + sigma_r_squared * sum_70
        part_01_cos_beta_sin_beta_sin_epsilon2 = attenuation_beta_squared_squared * shortfall_epsilon * sum_71 * sum_8
        sum_72 = 2.0 * shortfall_epsilon + attenuation_epsilon_2
        sum_73 = attenuation_epsilon_2 * sum_72 + shortfall_epsilon_squared
        sum_74 = 2.0 * shortfall_beta + attenuation_beta
        sum_75 = 2.0 * attenuation_epsilon_2 + 4.0 * shortfall_epsilon
        sum_76 = attenuation_epsilon_2 - shortfall_epsilon
        product_4 = attenuation_beta * sum_76
        sum_77 = product_4 - shortfall_beta * sum_75
        sum_78 = attenuation_epsilon_2 * sum_77 - shortfall_epsilon_squared * sum_74
        sum_79 = attenuation_beta * sum_78 - shortfall_beta_squared * sum_73
        sum_80 = 1.0 - rho_squared * sigma_beta_squared
        part_02_cos_epsilon_sin_beta_sin_epsilon = (
            attenuation_beta * attenuation_epsilon_2_squared * sigma_r_squared * sum_80
            - r_squared * shortfall_epsilon * sum_79 * term_1 * term_3
        )
        sum_81 = 0.5 * r_squared + 0.5 * sigma_r_squared
        part_22_cos_epsilon2 = shortfall_epsilon * sum_8 * sum_81
        sum_82 = 0.5 + 0.5 * attenuation_epsilon_2_squared
        part_22_sin_epsilon2 = (
            0.5 * (2.0 + attenuation_epsilon_2) * r_squared * shortfall_epsilon_squared * term_3
            + sigma_r_squared * sum_82
        )
        sum_83 = cos_beta * part_0_cos_beta_cos_epsilon + part_0_cos_epsilon_sin_beta * sin_beta
        sum_84 = cos_beta * part_0_cos_epsilon_sin_beta - part_0_cos_beta_cos_epsilon * sin_beta
        cos_epsilon_squared = cos_epsilon**2
        sin_epsilon_squared = sin_epsilon**2
        sum_85 = (
            cos_epsilon_squared * part_00_cos_beta2_cos_epsilon2
            + part_00_cos_beta2_sin_epsilon2 * sin_epsilon_squared
        )
        sum_86 = 3.0 * shortfall_epsilon + attenuation_epsilon_2
        sum_87 = 3.0 * shortfall_epsilon_squared + attenuation_epsilon_2 * sum_86
        sum_88 = attenuation_epsilon_2 * sum_87 + product_1
        sum_89 = 18.0 * shortfall_epsilon + 6.0 * attenuation_epsilon_2
        sum_90 = 18.0 * shortfall_epsilon_squared + attenuation_epsilon_2 * sum_89
        sum_91 = 6.0 * product_1 + attenuation_epsilon_2 * sum_90
        sum_92 = 15.0 * attenuation_epsilon_2 + 45.0 * shortfall_epsilon
        sum_93 = 45.0 * shortfall_epsilon_squared + attenuation_epsilon_2 * sum_92
        sum_94 = 15.0 * product_1 + attenuation_epsilon_2 * sum_93
        sum_95 = 20.0 * attenuation_epsilon_2 + 60.0 * shortfall_epsilon
        sum_96 = 60.0 * shortfall_epsilon_squared + attenuation_epsilon_2 * sum_95
        sum_97 = 20.0 * product_1 + attenuation_epsilon_2 * sum_96
        sum_98 = 6.0 * shortfall_beta + attenuation_beta
        sum_99 = 15.0 * shortfall_beta_squared + attenuation_beta * sum_98
        sum_100 = 18.0 * shortfall_beta + 2.0 * attenuation_beta
        sum_101 = product_4 - shortfall_beta * sum_89
        sum_102 = attenuation_epsilon_2 * sum_101 - shortfall_epsilon_squared * sum_100
        sum_103 = attenuation_beta * sum_102 - shortfall_beta_squared * sum_93
        sum_104 = attenuation_epsilon_2 * sum_103 - product_1 * sum_99
        sum_105 = attenuation_beta * sum_104 - product_2 * sum_97
        sum_106 = attenuation_beta * sum_105 - shortfall_beta_squared_squared * sum_94
        sum_107 = attenuation_beta * sum_106 - product_3 * sum_91
        sum_108 = attenuation_beta * sum_107 - shortfall_beta_squared * shortfall_beta_squared**2 * sum_88
        sum_109 = (
            2.0 * attenuation_beta_squared_squared * shortfall_epsilon * sin_epsilon_squared * sum_8
            + 2.0 * cos_epsilon_squared * sum_108 * term_3 * term_4
        )
        sum_110 = cos_beta * sum_85 + r * rho * sigma_beta * sigma_r * sin_beta * sum_109
        sum_111 = (
            cos_epsilon_squared * part_00_cos_epsilon2_sin_beta2
            + part_00_sin_beta2_sin_epsilon2 * sin_epsilon_squared
        )
        sin_beta_squared = sin_beta**2
        sum_112 = (
            attenuation_beta_squared_squared * shortfall_epsilon * sin_epsilon_squared * sum_8
            + cos_epsilon_squared * sum_108 * term_3 * term_4
        )
        sum_113 = (
            cos_epsilon_squared * part_01_cos_beta_cos_epsilon2_sin_beta
            + part_01_cos_beta_sin_beta_sin_epsilon2 * sin_epsilon_squared
        )
        sum_114 = cos_beta * r * rho * sigma_beta * sigma_r * sum_112 + sin_beta * sum_113
        sum_115 = 3.0 * attenuation_epsilon_2 + 3.0 * shortfall_epsilon
        sum_116 = attenuation_beta * sum_115 + shortfall_beta * sum_75
        sum_117 = attenuation_epsilon_2 * sum_116 + shortfall_epsilon_squared * sum_74
        sum_118 = attenuation_beta * sum_117 + shortfall_beta_squared * sum_73
        sum_119 = (
            attenuation_beta_squared * attenuation_epsilon_2 * attenuation_epsilon_2_squared
            - shortfall_epsilon * sum_118
        )
        sum_120 = (
            cos_beta * r * rho * sigma_beta * sigma_r * sum_119 * term_1 * term_3
            + part_02_cos_epsilon_sin_beta_sin_epsilon * sin_beta
        )
        sum_121 = cos_beta * sum_111 - r * rho * sigma_beta * sigma_r * sin_beta * sum_109
        sum_122 = (
            cos_beta * part_02_cos_epsilon_sin_beta_sin_epsilon
            - r * rho * sigma_beta * sigma_r * sin_beta * sum_119 * term_1 * term_3
        )
        mean[i, 0] = cos_epsilon * sum_83
        mean[i, 1] = cos_epsilon * sum_84
        mean[i, 2] = r * sin_epsilon * term_2
        covariance[i, 0, 0] = cos_beta * sum_110 + sin_beta_squared * sum_111
        covariance[i, 0, 1] = cos_beta * sum_114 - r * rho * sigma_beta * sigma_r * sin_beta_squared * sum_112
        covariance[i, 0, 2] = cos_epsilon * sin_epsilon * sum_120
        covariance[i, 1, 0] = covariance[i, 0, 1]
        covariance[i, 1, 1] = cos_beta * sum_121 + sin_beta_squared * sum_85
        covariance[i, 1, 2] = cos_epsilon * sin_epsilon * sum_122
        covariance[i, 2, 0] = covariance[i, 0, 2]
        covariance[i, 2, 1] = covariance[i, 1, 2]
        covariance[i, 2, 2] = (
            cos_epsilon_squared * part_22_cos_epsilon2
            + part_22_sin_epsilon2 * sin_epsilon_squared
        )


def spherical_posterior(
    all_r: Floats,
    all_beta: Floats,
    all_epsilon: Floats,
    all_sigma_r: Floats,
    all_sigma_beta: Floats,
    all_sigma_epsilon: Floats,
    all_rho: Floats,
    mean: Filled,
    covariance: Filled,
) -> None:
    """Conversion spherical, posterior.

    Mean: posterior mean of the position under a flat prior. Covariance: posterior covariance of the position
    under a flat prior.
    """
    for i in range(len(all_r)):
        r = all_r[i]
        beta = all_beta[i]
        epsilon = all_epsilon[i]
        sigma_r = all_sigma_r[i]
        sigma_beta = all_sigma_beta[i]
        sigma_epsilon = all_sigma_epsilon[i]
        rho = all_rho[i]
        cos_beta = math.cos(beta)
        sin_beta = math.sin(beta)
        cos_epsilon = math.cos(epsilon)
        sin_epsilon = math.sin(epsilon)
        sigma_beta_squared = sigma_beta**2
        attenuation_beta = math.exp(-0.5 * sigma_beta_squared)
        sigma_epsilon_squared = sigma_epsilon**2
        attenuation_epsilon = math.exp(-0.5 * sigma_epsilon_squared)
        part_0_cos_beta_cos_epsilon = attenuation_beta * attenuation_epsilon * rho * sigma_beta * sigma_r
        part_0_cos_epsilon_sin_beta = attenuation_beta * attenuation_epsilon * r
        shortfall_beta = -math.expm1(-0.5 * sigma_beta_squared)
        attenuation_epsilon_2 = math.exp(-sigma_epsilon_squared)
        shortfall_epsilon = -math.expm1(-sigma_epsilon_squared)
        attenuation_beta_squared = attenuation_beta**2
        shortfall_epsilon_squared = shortfall_epsilon**2
        product_1 = attenuation_beta_squared * shortfall_epsilon_squared
        sum_1 = attenuation_epsilon_2 + shortfall_epsilon
        shortfall_beta_squared = shortfall_beta**2
        product_2 = -shortfall_beta_squared * sum_1
        sum_2 = 2.0 * attenuation_epsilon_2 + 2.0 * shortfall_epsilon
        product_3 = -shortfall_beta * sum_2
        sum_3 = attenuation_beta * sum_1 + product_3
        sum_4 = attenuation_beta * sum_3 + product_2
        sum_5 = attenuation_epsilon_2 * sum_4 + product_1
        rho_squared = rho**2
        sigma_r_squared = sigma_r**2
        attenuation_epsilon_2_squared = attenuation_epsilon_2**2
        sum_6 = 1.0 + attenuation_epsilon_2_squared
        sum_7 = 1.0 + attenuation_beta * sum_6 + attenuation_epsilon_2_squared
        sum_8 = 1.0 + attenuation_beta * sum_7 + attenuation_epsilon_2_squared
        r_squared = r**2
        sum_9 = 0.25 * r_squared + 0.25 * sigma_r_squared
        sum_10 = 1.0 + attenuation_beta * sum_8 + attenuation_epsilon_2_squared
        part_00_cos_beta2_cos_epsilon2 = (
            attenuation_beta_squared * rho_squared * sigma_beta_squared * sigma_r_squared * sum_5
            + shortfall_beta * sum_10 * sum_9
        )
        attenuation_beta_squared_squared = attenuation_beta_squared**2
        sum_11 = 1.0 + attenuation_epsilon_2
        sum_12 = 1.0 + attenuation_beta * sum_11 + attenuation_epsilon_2
        sum_13 = 1.0 + attenuation_beta * sum_12 + attenuation_epsilon_2
        sum_14 = 1.0 + attenuation_beta * sum_13 + attenuation_epsilon_2
        sum_15 = (
            attenuation_beta_squared_squared * rho_squared * sigma_beta_squared * sigma_r_squared * sum_11
            + shortfall_beta * sum_14 * sum_9
        )
        part_00_cos_beta2_sin_epsilon2 = shortfall_epsilon * sum_15
        product_4 = shortfall_beta * sum_2
        sum_16 = attenuation_beta * sum_2 + product_4
        sum_17 = 1.5 * attenuation_beta + shortfall_beta
        sum_18 = attenuation_epsilon_2 * sum_16 + shortfall_epsilon_squared * sum_17
        sum_19 = 0.5 * attenuation_epsilon_2 + 0.5 * shortfall_epsilon
        sum_20 = attenuation_epsilon_2 * sum_19 + 0.25 * shortfall_epsilon_squared
        sum_21 = attenuation_beta * sum_18 + shortfall_beta_squared * sum_20
        sum_22 = attenuation_beta * attenuation_beta_squared * shortfall_epsilon_squared + shortfall_beta * sum_21
        sum_23 = 0.5 * attenuation_beta_squared_squared * shortfall_epsilon_squared + shortfall_beta * sum_22
        sum_24 = 0.25 + 0.25 * attenuation_epsilon_2_squared
        sum_25 = (
            0.25
            - attenuation_beta_squared_squared * rho_squared * sigma_beta_squared * sum_6
            + attenuation_beta_squared_squared * sum_24
            + 0.25 * attenuation_epsilon_2_squared
        )
        part_00_cos_epsilon2_sin_beta2 = r_squared * sum_23 + sigma_r_squared * sum_25
        sum_26 = 1.0 + attenuation_beta_squared_squared * sum_11 + attenuation_epsilon_2
        sum_27 = (
            sum_26 * sum_9
            - attenuation_beta_squared_squared * rho_squared * sigma_beta_squared * sigma_r_squared * sum_11
        )
        part_00_sin_beta2_sin_epsilon2 = shortfall_epsilon * sum_27
        sum_28 = 4.0 * attenuation_epsilon_2 + 4.0 * shortfall_epsilon
        sum_29 = attenuation_beta * sum_28 + product_4
        sum_30 = product_1 - attenuation_epsilon_2 * shortfall_beta * sum_29
        sum_31 = 3.0 * attenuation_epsilon_2 + 3.0 * shortfall_epsilon
        sum_32 = attenuation_beta * sum_31 + product_3
        sum_33 = attenuation_beta * sum_32 + product_2
        sum_34 = 2.0 * attenuation_beta_squared * shortfall_epsilon_squared + attenuation_epsilon_2 * sum_33
        sum_35 = 0.5 * attenuation_beta_squared * sum_6 - rho_squared * sigma_beta_squared * sum_34
        sum_36 = 0.5 * r_squared * sum_30 + sigma_r_squared * sum_35
        part_01_cos_beta_cos_epsilon2_sin_beta = attenuation_beta_squared * sum_36
        sum_37 = 0.5 - 2.0 * rho_squared * sigma_beta_squared
        sum_38 = 0.5 * r_squared + sigma_r_squared * sum_37
        part_01_cos_beta_sin_beta_sin_epsilon2 = attenuation_beta_squared_squared * shortfall_epsilon * sum_11 * sum_38
        sum_39 = 1.0 - rho_squared * sigma_beta_squared
        sum_40 = attenuation_epsilon_2 * sigma_r_squared * sum_39 - r_squared * shortfall_epsilon
        part_02_cos_epsilon_sin_beta_sin_epsilon = attenuation_beta * attenuation_epsilon_2 * sum_40
        sum_41 = 0.5 * r_squared + 0.5 * sigma_r_squared
        part_22_cos_epsilon2 = shortfall_epsilon * sum_11 * sum_41
        sum_42 = 0.5 + 0.5 * attenuation_epsilon_2_squared
        part_22_sin_epsilon2 = 0.5 * r_squared * shortfall_epsilon_squared + sigma_r_squared * sum_42
        sum_43 = cos_beta * part_0_cos_beta_cos_epsilon + part_0_cos_epsilon_sin_beta * sin_beta
        sum_44 = cos_beta * part_0_cos_epsilon_sin_beta - part_0_cos_beta_cos_epsilon * sin_beta
        sin_epsilon_squared = sin_epsilon**2
        cos_epsilon_squared = cos_epsilon**2
        sum_45 = (
            2.0 * attenuation_beta_squared * shortfall_epsilon * sin_epsilon_squared * sum_11
            + 2.0 * cos_epsilon_squared * sum_5
        )
        product_5 = attenuation_beta_squared * r * rho * sigma_beta * sigma_r * sin_beta * sum_45
        sum_46 = (
            cos_epsilon_squared * part_00_cos_beta2_cos_epsilon2
            + part_00_cos_beta2_sin_epsilon2 * sin_epsilon_squared
        )
        sum_47 = (
            cos_epsilon_squared * part_00_cos_epsilon2_sin_beta2
            + part_00_sin_beta2_sin_epsilon2 * sin_epsilon_squared
        )
        sin_beta_squared = sin_beta**2
        sum_48 = cos_beta**2 - sin_beta_squared
        sum_49 = (
            attenuation_beta_squared * shortfall_epsilon * sin_epsilon_squared * sum_11 * sum_48
            + cos_epsilon_squared * sum_48 * sum_5
        )
        sum_50 = (
            cos_epsilon_squared * part_01_cos_beta_cos_epsilon2_sin_beta
            + part_01_cos_beta_sin_beta_sin_epsilon2 * sin_epsilon_squared
        )
        sum_51 = attenuation_epsilon_2 - shortfall_epsilon
        sum_52 = (
            attenuation_beta * attenuation_epsilon_2 * cos_beta * r * rho * sigma_beta * sigma_r * sum_51
            + part_02_cos_epsilon_sin_beta_sin_epsilon * sin_beta
        )
        sum_53 = (
            attenuation_beta * attenuation_epsilon_2 * r * rho * sigma_beta * sigma_r * sin_beta * sum_51
            - cos_beta * part_02_cos_epsilon_sin_beta_sin_epsilon
        )
        mean[i, 0] = cos_epsilon * sum_43
        mean[i, 1] = cos_epsilon * sum_44
        mean[i, 2] = attenuation_epsilon * r * sin_epsilon
        covariance[i, 0, 0] = cos_beta * (cos_beta * sum_46 + product_5) + sin_beta_squared * sum_47
        covariance[i, 0, 1] = (
            attenuation_beta_squared * r * rho * sigma_beta * sigma_r * sum_49
            + cos_beta * sin_beta * sum_50
        )
        covariance[i, 0, 2] = cos_epsilon * sin_epsilon * sum_52
        covariance[i, 1, 0] = covariance[i, 0, 1]
        covariance[i, 1, 1] = sin_beta_squared * sum_46 - (product_5 - cos_beta * sum_47) * cos_beta
        covariance[i, 1, 2] = -cos_epsilon * sin_epsilon * sum_53
        covariance[i, 2, 0] = covariance[i, 0, 2]
        covariance[i, 2, 1] = covariance[i, 1, 2]
        covariance[i, 2, 2] = (
            cos_epsilon_squared * part_22_cos_epsilon2
            + part_22_sin_epsilon2 * sin_epsilon_squared
        )
