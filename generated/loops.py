"""Conversions as loops over plots; mean[plot, n] and covariance[plot, n, n] are filled, in arrays or in dictionaries.

Written by radartrack regenerate, generator 1, derivation bdb76c5b64c05bdd; not to be edited.
"""

import math
from collections.abc import MutableMapping, Sequence

Floats = Sequence[float]
Filled = MutableMapping[tuple[int, ...], float]


def bistatic_linear(
    all_path: Floats,
    all_beta: Floats,
    all_baseline: Floats,
    all_sigma_path: Floats,
    all_sigma_beta: Floats,
    all_rho: Floats,
    mean: Filled,
    covariance: Filled,
) -> None:
    """Conversion bistatic, linear.

    Mean: map from the measured quantities to coordinates. Covariance: covariance of the linearised
    conversion.
    """
    for i in range(len(all_path)):
        path = all_path[i]
        beta = all_beta[i]
        baseline = all_baseline[i]
        sigma_path = all_sigma_path[i]
        sigma_beta = all_sigma_beta[i]
        rho = all_rho[i]
        cos_beta = math.cos(beta)
        divisor_1 = 2.0 * path - 2.0 * baseline * cos_beta
        term_1 = 1.0 / divisor_1
        sum_1 = baseline + path
        sum_2 = baseline - path
        sin_beta = math.sin(beta)
        term_2 = 1.0 / (divisor_1**2)**2
        sum_3 = baseline - 2.0 * cos_beta * path
        path_squared = path**2
        sum_4 = path_squared + baseline * sum_3
        sum_4_squared = sum_4**2
        sigma_path_squared = sigma_path**2
        sum_5 = 4.0 * path * sigma_beta * sin_beta * sum_1 * sum_2 + 8.0 * cos_beta * rho * sigma_path * sum_4
        sum_6 = (
            4.0 * cos_beta**2 * sigma_path_squared * sum_4_squared
            + path * sigma_beta * sin_beta * sum_1 * sum_2 * sum_5
        )
        sum_7 = baseline - cos_beta * path
        sum_8 = (
            4.0 * path * sigma_beta * sin_beta * sum_1 * sum_2 * sum_7
            + 4.0 * (cos_beta * sum_3 + path) * rho * sigma_path * sum_4
        )
        sum_9 = (
            4.0 * cos_beta * sigma_path_squared * sin_beta * sum_4_squared
            + sigma_beta * sum_1 * sum_2 * sum_8
        )
        sin_beta_squared = sin_beta**2
        sum_10 = 4.0 * baseline * cos_beta - (6.0 - 4.0 * sin_beta_squared) * path
        sum_11 = (baseline**2 - path * sum_10) * baseline - 4.0 * cos_beta * path * path_squared
        sum_12 = path_squared**2 + baseline * sum_11
        sum_13 = 4.0 * sigma_beta * sum_1 * sum_2 * sum_7 + 8.0 * rho * sigma_path * sin_beta * sum_4
        sum_14 = (
            4.0 * sigma_path_squared * sin_beta_squared * sum_12
            + sigma_beta * sum_1 * sum_13 * sum_2 * sum_7
        )
        mean[i, 0] = -cos_beta * sum_1 * sum_2 * term_1
        mean[i, 1] = -sin_beta * sum_1 * sum_2 * term_1
        covariance[i, 0, 0] = sum_6 * term_2
        covariance[i, 0, 1] = sum_9 * term_2
        covariance[i, 1, 0] = covariance[i, 0, 1]
        covariance[i, 1, 1] = sum_14 * term_2


def bistatic_second_order(
    all_path: Floats,
    all_beta: Floats,
    all_baseline: Floats,
    all_sigma_path: Floats,
    all_sigma_beta: Floats,
    all_rho: Floats,
    mean: Filled,
    covariance: Filled,
) -> None:
    """Conversion bistatic, second_order.

    Mean: map from the measured quantities to coordinates less the bias of the plain conversion to second
    order. Covariance: covariance of the conversion's quadratic Taylor polynomial.
    """
    for i in range(len(all_path)):
        path = all_path[i]
        beta = all_beta[i]
        baseline = all_baseline[i]
        sigma_path = all_sigma_path[i]
        sigma_beta = all_sigma_beta[i]
        rho = all_rho[i]
        cos_beta = math.cos(beta)
        divisor_1 = 2.0 * path - 2.0 * baseline * cos_beta
        product_1 = baseline * cos_beta
        divisor_1_2 = product_1 - path
        divisor_2 = divisor_1_2
        term_1 = 1.0 / divisor_1
        sum_1 = baseline + path
        sum_2 = baseline - path
        baseline_squared = baseline**2
        sigma_path_squared = sigma_path**2
        sin_beta = math.sin(beta)
        sin_beta_squared = sin_beta**2
        product_2 = -cos_beta * path
        cos_beta_squared = cos_beta**2
        sum_3 = 2.0 - cos_beta_squared
        product_3 = baseline * sum_3
        sum_4 = product_2 + product_3
        path_squared = path**2
        sum_5 = baseline * (path + product_1) - 3.0 * cos_beta * path_squared
        product_4 = path * path_squared
        sum_6 = product_4 + baseline * sum_5
        sum_7 = 0.5 * rho * sigma_path * sin_beta * sum_6 + 0.25 * path * sigma_beta * sum_1 * sum_2 * sum_4
        term_2 = 1.0 / (divisor_1_2 * divisor_1_2**2)
        sum_8 = 0.5 * baseline_squared * cos_beta * sigma_path_squared * sin_beta_squared + sigma_beta * sum_7
        product_5 = -cos_beta * product_4
        product_6 = -3.0 * cos_beta * path
        sum_9 = 3.0 * cos_beta_squared * path_squared + baseline * (product_3 + product_6)
        sum_10 = product_5 + baseline * sum_9
        sum_11 = baseline * (2.0 * baseline + product_2) - path_squared
        sum_12 = 0.25 * sigma_beta * sin_beta * sum_1 * sum_11 * sum_2 + 0.5 * rho * sigma_path * sum_10
        sum_13 = 0.5 * baseline_squared * sigma_path_squared * sin_beta * sin_beta_squared + sigma_beta * sum_12
        term_3 = 1.0 / (divisor_1**2)**2
        term_4 = 1.0 / divisor_2**2
        sum_1_squared = sum_1**2
        sum_2_squared = sum_2**2
        product_7 = -2.0 * cos_beta * path
        sum_14 = 1.0 - sin_beta_squared
        product_8 = baseline * sum_14
        sum_15 = baseline * (product_7 + product_8) + path_squared
        product_9 = path * path_squared**2
        product_10 = -6.0 * cos_beta * product_9
        sum_16 = 2.0 * cos_beta * path + product_8
        sum_17 = baseline * sum_16 - (5.0 - 6.0 * sin_beta_squared) * path_squared
        sum_18 = baseline * sum_17 - 4.0 * cos_beta * product_4
        path_squared_squared = path_squared**2
        sum_19 = (11.0 - 9.0 * sin_beta_squared) * path_squared_squared + baseline * sum_18
        path_squared_cubed = path_squared * path_squared**2
        sum_20 = baseline * (product_10 + baseline * sum_19) + path_squared_cubed
        sum_21 = divisor_1_2
        sum_21_squared = sum_21**2
        sum_22 = baseline + product_7
        sum_23 = path_squared + baseline * sum_22
        sigma_beta_squared = sigma_beta**2
        sum_24 = 8.0 * cos_beta * sum_21_squared * sum_23 + 8.0 * sigma_beta_squared * sum_4 * sum_6
        sum_25 = 3.0 - 3.0 * sin_beta_squared
        product_11 = cos_beta * path
        sum_26 = baseline * (product_11 + product_8) - path_squared * sum_25
        product_12 = cos_beta * product_4
        sum_27 = (4.0 + 2.0 * sin_beta_squared) * cos_beta * path + product_8
        sum_28 = baseline * sum_27 - (7.0 - 8.0 * sin_beta_squared) * path_squared
        sum_29 = baseline * sum_28 - (6.0 + 2.0 * sin_beta_squared) * cos_beta * product_4
        sum_30 = (13.0 - 11.0 * sin_beta_squared) * path_squared_squared + baseline * sum_29
        sum_31 = baseline * (product_10 + baseline * sum_30) + path_squared_cubed
        sum_32 = (
            16.0 * baseline_squared * (product_12 + baseline * sum_26) * sigma_path * sin_beta
            + 4.0 * rho * sigma_beta * sum_31
        )
        sum_33 = sigma_path * sin_beta * sum_32 + path * sum_1 * sum_2 * sum_24
        sum_34 = 4.0 * sigma_beta * sigma_path * sin_beta * sum_20 + rho * sum_33
        sum_35 = (
            4.0 * path_squared * sigma_beta * sin_beta * sum_15 * sum_1_squared * sum_2_squared
            + sigma_path * sum_34
        )
        sum_36 = (
            2.0 * (product_11 - baseline * sum_3)**2 * path_squared * sigma_beta * sigma_beta_squared * sum_1_squared * sum_2_squared
            + sin_beta * sum_35
        )
        sum_23_squared = sum_23**2
        baseline_squared_squared = baseline_squared**2
        sin_beta_squared_squared = sin_beta_squared**2
        sum_37 = (
            4.0 * cos_beta_squared * sum_21_squared * sum_23_squared
            + 8.0 * (1.0 - sin_beta) * baseline_squared_squared * sigma_path_squared * (1.0 + sin_beta) * sin_beta_squared_squared
        )
        sum_38 = sigma_path_squared * sum_37 + sigma_beta * sum_36
        sum_39 = 1.0 - 2.0 * sin_beta_squared
        sum_40 = (1.0 + 2.0 * sin_beta_squared) * baseline * cos_beta - (3.0 - 4.0 * sin_beta_squared) * path
        sum_41 = (3.0 - 6.0 * sin_beta_squared) * cos_beta * path_squared + baseline * sum_40
        sum_42 = baseline * sum_41 - product_4 * sum_39
        sum_43 = (
            4.0 * (cos_beta * sum_22 + path) * sum_1 * sum_2 * sum_21_squared * sum_23
            + 8.0 * baseline_squared * sigma_path_squared * sin_beta_squared * sum_42
        )
        sum_44 = 3.0 + sin_beta_squared
        sum_45 = (2.0 + 2.0 * sin_beta_squared) * baseline - cos_beta * path * sum_44
        sum_46 = baseline * sum_45 - 2.0 * path_squared * sin_beta_squared
        sum_47 = baseline + product_2
        sum_48 = 2.0 * (product_12 + baseline * sum_46) * sigma_beta_squared + 4.0 * sum_21_squared * sum_47
        sum_49 = 8.0 * path + cos_beta * (3.0 * baseline + product_7)
        sum_50 = cos_beta * sum_49 - 4.0 * baseline
        sum_51 = (13.0 - 10.0 * cos_beta_squared) * path_squared + baseline * sum_50
        sum_52 = baseline * sum_51 - (14.0 - 2.0 * cos_beta_squared) * cos_beta * product_4
        sum_53 = 2.0 + 11.0 * cos_beta_squared
        sum_54 = path_squared_squared * sum_53 + baseline * sum_52
        sum_55 = cos_beta * sum_54 - 4.0 * baseline * baseline_squared * path
        sum_56 = baseline * sum_55 - 6.0 * cos_beta_squared * product_9
        rho_squared = rho**2
        sum_57 = cos_beta * path_squared_cubed + baseline * sum_56
        sum_58 = 4.0 * sum_10 * sum_6 - 4.0 * rho_squared * sum_57
        sum_59 = sigma_path_squared * sum_58 + path * sum_1_squared * sum_2_squared * sum_48
        sum_60 = 1.0 + (3.0 + 2.0 * sin_beta_squared) * sin_beta_squared
        sum_61 = baseline * sum_60 - (4.0 + 12.0 * sin_beta_squared) * cos_beta * path
        sum_62 = 6.0 + (1.0 - 6.0 * sin_beta_squared) * sin_beta_squared
        sum_63 = path_squared * sum_62 + baseline * sum_61
        sum_64 = baseline * sum_63 - (4.0 - 4.0 * sin_beta_squared) * cos_beta * product_4
        sum_65 = path_squared_squared * sum_39 + baseline * sum_64
        sum_66 = 2.0 * baseline * baseline_squared**2 * cos_beta * sin_beta_squared + path * sum_65
        sum_67 = 4.0 * rho * sigma_beta * sigma_path * sum_1 * sum_2 * sum_66 + sin_beta * sum_59
        sum_68 = rho * sigma_path * sum_43 + sigma_beta * sum_67
        product_13 = 8.0 * baseline_squared_squared * sigma_path_squared * sin_beta_squared_squared
        sum_69 = 4.0 * sum_21_squared * sum_23_squared + product_13
        sum_70 = cos_beta * sigma_path_squared * sin_beta * sum_69 + sigma_beta * sum_68
        sum_71 = baseline * (1.0 + sin_beta_squared) + product_6
        sum_72 = path_squared * sum_25 + baseline * sum_71
        sum_73 = (
            16.0 * baseline_squared * (product_5 + baseline * sum_72) * sigma_path_squared * sin_beta_squared
            + 8.0 * sum_1 * sum_2 * sum_21_squared * sum_23 * sum_47
        )
        sum_74 = 4.0 * baseline * cos_beta + path * sum_44
        sum_75 = 4.0 * baseline_squared - path * sum_74
        sum_76 = 2.0 * cos_beta * product_4 + baseline * sum_75
        sum_77 = path_squared_squared + baseline * sum_76
        sum_78 = 2.0 * sigma_beta_squared * sin_beta_squared * sum_77 + 4.0 * sum_21_squared * sum_47**2
        sum_79 = 8.0 * rho * sigma_beta * sigma_path * sin_beta * sum_10 * sum_11 + sum_1 * sum_2 * sum_78
        sum_80 = 10.0 * path + cos_beta * (5.0 * baseline + product_7)
        sum_81 = cos_beta * sum_80 - 12.0 * baseline
        sum_82 = (33.0 - 12.0 * cos_beta_squared) * path_squared + baseline * sum_81
        sum_83 = baseline * sum_82 - (20.0 - 2.0 * cos_beta_squared) * cos_beta * product_4
        sum_84 = 14.0 * baseline_squared + 2.0 * path_squared
        sum_85 = cos_beta * sum_83 - path * sum_84
        sum_86 = 8.0 * baseline_squared - 6.0 * path_squared
        sum_87 = cos_beta * sum_85 + baseline * sum_86
        sum_88 = 2.0 + cos_beta_squared * sum_53
        sum_89 = path_squared_squared * sum_88 + baseline * sum_87
        sum_90 = baseline * sum_89 - 6.0 * cos_beta * cos_beta_squared * product_9
        sum_91 = cos_beta_squared * path_squared_cubed + baseline * sum_90
        sum_92 = 4.0 * (product_12 - baseline * sum_9)**2 + 4.0 * rho_squared * sum_91
        sum_93 = sigma_path_squared * sum_92 + sum_1 * sum_2 * sum_79
        sum_94 = rho * sigma_path * sin_beta * sum_73 + sigma_beta * sum_93
        sum_95 = 15.0 - (18.0 - 4.0 * sin_beta_squared) * sin_beta_squared
        sum_96 = (6.0 - 4.0 * sin_beta_squared) * baseline * cos_beta - path * sum_95
        sum_97 = baseline_squared * sum_14 - path * sum_96
        sum_98 = baseline * sum_97 - (20.0 - 12.0 * sin_beta_squared) * cos_beta * product_4
        sum_99 = (15.0 - 13.0 * sin_beta_squared) * path_squared_squared + baseline * sum_98
        sum_100 = 4.0 * baseline * (product_10 + baseline * sum_99) + 4.0 * path_squared_cubed + product_13
        sum_101 = sigma_path_squared * sin_beta_squared * sum_100 + sigma_beta * sum_94
        mean[i, 0] = -cos_beta * sum_1 * sum_2 * term_1 - sum_8 * term_2
        mean[i, 1] = -sin_beta * sum_1 * sum_2 * term_1 - sum_13 * term_2
        covariance[i, 0, 0] = sum_38 * term_3 * term_4
        covariance[i, 0, 1] = sum_70 * term_3 * term_4
        covariance[i, 1, 0] = covariance[i, 0, 1]
        covariance[i, 1, 1] = sum_101 * term_3 * term_4


def bistatic_averaged(
    all_path: Floats,
    all_beta: Floats,
    all_baseline: Floats,
    all_sigma_path: Floats,
    all_sigma_beta: Floats,
    all_rho: Floats,
    mean: Filled,
    covariance: Filled,
) -> None:
    """Conversion bistatic, averaged.

    Mean: map from the measured quantities to coordinates less the bias of the plain conversion, averaged over
    the truth, to fourth order. Covariance: covariance of the plain conversion, averaged over the truth, to
    fourth order, completed to a sum of squares.
    """
    for i in range(len(all_path)):
        path = all_path[i]
        beta = all_beta[i]
        baseline = all_baseline[i]
        sigma_path = all_sigma_path[i]
        sigma_beta = all_sigma_beta[i]
        rho = all_rho[i]
        cos_beta = math.cos(beta)
        product_1 = -2.0 * baseline * cos_beta
        divisor_1 = 2.0 * path + product_1
        sum_1 = baseline + path
        sum_2 = baseline - path
        sigma_path_squared = sigma_path**2
        sin_beta = math.sin(beta)
        sin_beta_squared = sin_beta**2
        sum_3 = 2.0 - 2.0 * sin_beta_squared
        sum_4 = 1.0 - sin_beta_squared
        sum_5 = baseline * cos_beta * sum_4 - path * sum_3
        path_squared = path**2
        baseline_squared = baseline**2
        sum_6 = 144.0 * cos_beta * sigma_path_squared + 16.0 * cos_beta * path_squared + 16.0 * baseline * sum_5
        product_2 = -3.0 * cos_beta * path
        cos_beta_squared = cos_beta**2
        product_3 = (3.0 - cos_beta_squared) * baseline
        sum_7 = cos_beta * (product_2 + product_3) + path
        product_4 = baseline * cos_beta
        sum_8 = product_4 - path
        sum_8_squared = sum_8**2
        sum_9 = baseline * (path + product_4) - 3.0 * cos_beta * path_squared
        product_5 = path * path_squared
        sum_10 = (
            144.0 * baseline_squared * sigma_path_squared * sum_7
            + 16.0 * (product_5 + baseline * sum_9) * sum_8_squared
        )
        product_6 = path * path_squared**2
        path_squared_squared = path_squared**2
        product_7 = -11.0 * cos_beta * path
        product_8 = (6.0 - cos_beta_squared) * baseline
        sum_11 = baseline * (product_7 + product_8) - (29.0 - 3.0 * cos_beta_squared) * path_squared
        sum_12 = 18.0 * baseline * path + cos_beta * sum_11
        sum_13 = baseline * sum_12 - (7.0 - 17.0 * cos_beta_squared) * product_5
        sum_14 = 5.0 * cos_beta * path_squared_squared + baseline * sum_13
        sum_15 = 13.0 * path + cos_beta * (4.0 * baseline + product_2)
        sum_16 = cos_beta * sum_15 - 6.0 * baseline
        sum_17 = (7.0 - 9.0 * cos_beta_squared) * path_squared + baseline * sum_16
        rho_squared = rho**2
        sum_18 = cos_beta * sum_17 - 6.0 * baseline * path
        sum_19 = (
            (24.0 + 48.0 * rho_squared) * baseline_squared * sigma_path * sum_18
            - 24.0 * (baseline * sum_14 - product_6) * rho * sigma_beta * sin_beta
        )
        product_9 = -cos_beta * product_5
        product_10 = (20.0 - cos_beta_squared) * baseline
        sum_20 = 20.0 * path + cos_beta * (product_10 + product_7)
        sum_21 = cos_beta * sum_20 - 24.0 * baseline
        sum_22 = (8.0 - 11.0 * cos_beta_squared) * path_squared + baseline * sum_21
        sigma_beta_squared = sigma_beta**2
        product_11 = -cos_beta * path
        product_12 = (2.0 - cos_beta_squared) * baseline
        sum_23 = (
            8.0 * (product_11 + product_12) * sum_8_squared
            - 6.0 * (product_9 + baseline * sum_22) * sigma_beta_squared
        )
        sum_24 = path * sum_1 * sum_2 * sum_23 - sigma_path * sum_19
        sum_25 = rho * sigma_path * sin_beta * sum_10 + sigma_beta * sum_24
        term_1 = 1.0 / (divisor_1**2)**2
        sum_26 = baseline_squared * sigma_path_squared * sin_beta_squared * sum_6 + sigma_beta * sum_25
        term_2 = 1.0 / divisor_1
        sum_27 = cos_beta * sum_1 * sum_2 - sum_26 * term_1
        product_13 = -2.0 * cos_beta * path
        sum_28 = (
            144.0 * sigma_path_squared
            + 16.0 * baseline * (product_13 + baseline * sum_4)
            + 16.0 * path_squared
        )
        sum_29 = baseline * (3.0 + sin_beta_squared) + product_2
        sum_30 = 3.0 * cos_beta_squared * path_squared + baseline * (product_12 + product_2)
        sum_31 = (
            144.0 * baseline_squared * sigma_path_squared * sin_beta_squared * sum_29
            + 16.0 * (product_9 + baseline * sum_30) * sum_8_squared
        )
        sum_32 = 20.0 * path + cos_beta * (8.0 * baseline + product_11)
        sum_33 = cos_beta * sum_32 - 24.0 * baseline
        sum_34 = (20.0 - 11.0 * cos_beta_squared) * path_squared + baseline * sum_33
        sum_35 = baseline * sum_34 - 11.0 * cos_beta * product_5
        sum_36 = baseline * sum_35 - path_squared_squared
        sum_37 = 2.0 * baseline + product_11
        sum_38 = baseline * sum_37 - path_squared
        sum_39 = 8.0 * sum_38 * sum_8_squared - 6.0 * sigma_beta_squared * sum_36
        sum_40 = cos_beta * (5.0 * path + cos_beta * sum_37) - 4.0 * baseline
        sum_41 = 1.0 - 3.0 * cos_beta_squared
        sum_42 = path_squared * sum_41 + baseline * sum_40
        sum_43 = (
            sum_1 * sum_2 * sum_39
            - (72.0 + 144.0 * rho_squared) * baseline_squared * sigma_path_squared * sum_42
        )
        sum_44 = product_10 - 19.0 * cos_beta * path
        sum_45 = baseline * sum_44 - (31.0 - 3.0 * cos_beta_squared) * path_squared
        sum_46 = 32.0 * baseline * path + cos_beta * sum_45
        sum_47 = 20.0 * path_squared - 24.0 * baseline_squared + cos_beta * sum_46
        sum_48 = baseline * sum_47 - (21.0 - 17.0 * cos_beta_squared) * cos_beta * product_5
        sum_49 = 5.0 * cos_beta_squared * path_squared_squared + baseline * sum_48
        sum_50 = baseline * sum_49 - cos_beta * product_6
        sum_51 = sin_beta * sum_43 - 24.0 * rho * sigma_beta * sigma_path * sum_50
        sum_52 = rho * sigma_path * sum_31 + sigma_beta * sum_51
        sum_53 = (
            baseline_squared * sigma_path_squared * sin_beta * sin_beta_squared * sum_28
            + sigma_beta * sum_52
        )
        sum_54 = sin_beta * sum_1 * sum_2 - sum_53 * term_1
        term_3 = 1.0 / ((divisor_1**2)**2)**2
        sum_8_squared_squared = sum_8_squared**2
        sum_55 = baseline + product_13
        sum_56 = path_squared + baseline * sum_55
        sum_57 = baseline * sum_3 - (2.0 - 3.0 * sin_beta_squared) * cos_beta * path
        product_14 = -9.0 * cos_beta * path
        sum_58 = baseline * (product_14 + product_3) - (3.0 - 9.0 * cos_beta_squared) * path_squared
        sum_59 = 3.0 * baseline * path + cos_beta * sum_58
        sum_60 = product_5 * sum_41 + baseline * sum_59
        sum_61 = (
            4608.0 * baseline_squared * sigma_path_squared * sin_beta_squared * sum_57
            + 768.0 * cos_beta * sum_60 * sum_8_squared
        )
        sum_62 = (
            128.0 * cos_beta * path * sum_1 * sum_2 * sum_56 * sum_8_squared_squared
            + baseline_squared * sigma_path_squared * sum_61
        )
        product_15 = -cos_beta * path_squared_squared
        product_16 = -4.0 * cos_beta * path
        sum_63 = baseline * (product_12 + product_16) - (7.0 - 3.0 * cos_beta_squared) * path_squared
        sum_64 = 4.0 * baseline * path + cos_beta * sum_63
        sum_65 = 4.0 * cos_beta_squared * product_5 + baseline * sum_64
        sum_66 = product_15 + baseline * sum_65
        sum_67 = baseline * (product_16 + product_8) - path_squared
        sum_68 = 34.0 * path + cos_beta * (7.0 * baseline + product_13)
        sum_69 = cos_beta * sum_68 - 18.0 * baseline
        sum_70 = (37.0 - 25.0 * cos_beta_squared) * path_squared + baseline * sum_69
        sum_71 = cos_beta * sum_70 - 18.0 * baseline * path
        sum_72 = baseline * sum_71 - (6.0 + 16.0 * cos_beta_squared) * product_5
        sum_73 = 7.0 * cos_beta * path_squared_squared + baseline * sum_72
        sum_74 = 128.0 * sum_73 * sum_8_squared - 384.0 * sigma_beta_squared * sum_66 * sum_67
        product_17 = -(3.0 - 3.0 * sin_beta_squared) * path_squared_squared
        sum_75 = 8.0 + (9.0 - 18.0 * sin_beta_squared) * sin_beta_squared
        sum_76 = 4.0 + 3.0 * sin_beta_squared
        sum_77 = 7.0 - sin_beta_squared * sum_76
        sum_78 = baseline * sum_77 - (8.0 - 24.0 * sin_beta_squared) * cos_beta * path
        sum_79 = baseline * sum_78 - path_squared * sum_75
        product_18 = (12.0 - 12.0 * sin_beta_squared) * cos_beta * product_5
        sum_80 = baseline * (product_18 + baseline * sum_79) + product_17
        path_squared_cubed = path_squared * path_squared**2
        product_19 = cos_beta * (5.0 * baseline + product_16)
        sum_81 = cos_beta * (30.0 * path + product_19) - 7.0 * baseline
        sum_82 = (63.0 - 50.0 * cos_beta_squared) * path_squared + baseline * sum_81
        sum_83 = baseline * sum_82 - (48.0 - 12.0 * cos_beta_squared) * cos_beta * product_5
        sum_84 = 22.0 * baseline_squared - 12.0 * path_squared
        sum_85 = cos_beta * sum_83 - path * sum_84
        sum_86 = baseline * sum_85 - (21.0 - 49.0 * cos_beta_squared) * cos_beta * path_squared_squared
        sum_87 = 2.0 * path_squared + 7.0 * baseline_squared
        sum_88 = cos_beta * sum_86 - path_squared * sum_87
        sum_89 = (18.0 - 30.0 * cos_beta_squared) * cos_beta * product_6 + baseline * sum_88
        sum_90 = baseline * sum_89 - (3.0 - 5.0 * cos_beta_squared) * path_squared_cubed
        term_4 = (path_squared**2)**2
        product_20 = -cos_beta_squared * term_4
        product_21 = path * path_squared * path_squared**2
        product_22 = 8.0 * cos_beta * cos_beta_squared * product_21
        sum_91 = 4.0 - (2.0 - 22.0 * cos_beta_squared) * cos_beta_squared
        sum_92 = 120.0 - 72.0 * cos_beta_squared
        sum_93 = 16.0 - cos_beta_squared * sum_92
        sum_94 = 204.0 - 21.0 * cos_beta_squared
        sum_95 = 225.0 - cos_beta_squared * sum_94
        sum_96 = 224.0 - 88.0 * cos_beta_squared
        sum_97 = 162.0 - 18.0 * cos_beta_squared
        product_23 = (4.0 - cos_beta_squared) * baseline
        sum_98 = product_23 - 16.0 * cos_beta * path
        sum_99 = baseline * sum_98 - path_squared * sum_97
        sum_100 = 80.0 * baseline * path + cos_beta * sum_99
        sum_101 = 192.0 * path_squared - 4.0 * baseline_squared + cos_beta * sum_100
        sum_102 = baseline * sum_101 - cos_beta * product_5 * sum_96
        sum_103 = baseline * sum_102 - path_squared_squared * sum_95
        sum_104 = 64.0 * baseline_squared - 128.0 * path_squared
        sum_105 = cos_beta * sum_103 - baseline * path * sum_104
        sum_106 = baseline * sum_105 - product_6 * sum_93
        sum_107 = 40.0 * baseline_squared - 28.0 * path_squared
        sum_108 = cos_beta * sum_106 - baseline * path_squared * sum_107
        sum_109 = baseline * sum_108 - path_squared_cubed * sum_91
        sum_110 = product_22 + baseline * sum_109
        sum_111 = product_20 + baseline * sum_110
        sum_112 = 48.0 * path + cos_beta * (5.0 * baseline + product_14)
        sum_113 = cos_beta * sum_112 - 10.0 * baseline
        sum_114 = (81.0 - 51.0 * cos_beta_squared) * path_squared + baseline * sum_113
        sum_115 = baseline * sum_114 - (92.0 - 24.0 * cos_beta_squared) * cos_beta * product_5
        sum_116 = 34.0 * baseline_squared - 28.0 * path_squared
        sum_117 = cos_beta * sum_115 - path * sum_116
        sum_118 = baseline * sum_117 - (11.0 - 36.0 * cos_beta_squared) * cos_beta * path_squared_squared
        sum_119 = (1.0 - 6.0 * cos_beta_squared) * product_6 + baseline * sum_118
        product_24 = baseline * baseline_squared
        sum_120 = cos_beta * sum_119 - 10.0 * path_squared * product_24
        sum_121 = cos_beta * (2.0 * baseline + product_2) + path
        sum_122 = 19.0 - (16.0 + 3.0 * sin_beta_squared) * sin_beta_squared
        sum_123 = baseline * sum_122 - (32.0 - 60.0 * sin_beta_squared) * cos_beta * path
        sum_124 = 4.0 - (45.0 - 45.0 * sin_beta_squared) * sin_beta_squared
        sum_125 = path_squared * sum_124 + baseline * sum_123
        sum_126 = product_18 + baseline * sum_125
        sum_127 = product_17 + baseline * sum_126
        sum_128 = 1024.0 * rho * sigma_beta * sum_121 * sum_66 + 512.0 * sigma_path * sin_beta * sum_127
        sum_129 = 1.0 + (10.0 + 13.0 * cos_beta_squared) * cos_beta_squared
        sum_130 = 105.0 - 12.0 * cos_beta_squared
        sum_131 = 114.0 - cos_beta_squared * sum_130
        sum_132 = 128.0 - 46.0 * cos_beta_squared
        sum_133 = product_23 - 10.0 * cos_beta * path
        sum_134 = baseline * sum_133 - (72.0 - 9.0 * cos_beta_squared) * path_squared
        sum_135 = 38.0 * baseline * path + cos_beta * sum_134
        sum_136 = 93.0 * path_squared - 4.0 * baseline_squared + cos_beta * sum_135
        sum_137 = baseline * sum_136 - cos_beta * product_5 * sum_132
        sum_138 = baseline * sum_137 - path_squared_squared * sum_131
        sum_139 = 28.0 * baseline_squared - 74.0 * path_squared
        sum_140 = cos_beta * sum_138 - baseline * path * sum_139
        sum_141 = 2.0 + (66.0 - 36.0 * cos_beta_squared) * cos_beta_squared
        sum_142 = product_6 * sum_141 + baseline * sum_140
        sum_143 = 22.0 * baseline_squared - 7.0 * path_squared
        sum_144 = cos_beta * sum_142 - baseline * path_squared * sum_143
        sum_145 = baseline * sum_144 - path_squared_cubed * sum_129
        sum_146 = product_22 + baseline * sum_145
        sum_147 = product_20 + baseline * sum_146
        sum_148 = 3.0 - 7.0 * cos_beta_squared
        sum_149 = 102.0 - 30.0 * cos_beta_squared
        product_25 = -14.0 * cos_beta * path
        sum_150 = 72.0 * path + cos_beta * (7.0 * baseline + product_25)
        sum_151 = cos_beta * sum_150 - 11.0 * baseline
        sum_152 = 111.0 - 88.0 * cos_beta_squared
        sum_153 = path_squared * sum_152 + baseline * sum_151
        sum_154 = baseline * sum_153 - cos_beta * product_5 * sum_149
        sum_155 = 50.0 * baseline_squared - 24.0 * path_squared
        sum_156 = cos_beta * sum_154 - path * sum_155
        sum_157 = baseline * sum_156 - (27.0 - 77.0 * cos_beta_squared) * cos_beta * path_squared_squared
        sum_158 = 11.0 * baseline_squared - 2.0 * path_squared
        sum_159 = cos_beta * sum_157 - path_squared * sum_158
        sum_160 = (18.0 - 42.0 * cos_beta_squared) * cos_beta * product_6 + baseline * sum_159
        sum_161 = baseline * sum_160 - path_squared_cubed * sum_148
        sum_162 = (
            512.0 * sigma_beta_squared * sum_147
            - baseline_squared * sigma_path * sin_beta * sum_128
            + 64.0 * sum_161 * sum_8_squared
        )
        sum_163 = 512.0 * baseline_squared * sigma_beta * sigma_path * sin_beta * sum_120 + rho * sum_162
        sum_164 = (
            64.0 * sigma_beta_squared * sum_111
            - 256.0 * baseline_squared * sigma_path_squared * sin_beta_squared * sum_80
            + 64.0 * sum_8_squared * sum_90
            + rho * sum_163
        )
        sum_165 = path * rho * sigma_beta * sin_beta * sum_1 * sum_2 * sum_74 + sigma_path * sum_164
        sum_1_squared = sum_1**2
        sum_2_squared = sum_2**2
        sum_166 = 25.0 + sin_beta_squared * (10.0 + sin_beta_squared)
        sum_167 = baseline * sum_166 - (40.0 + 8.0 * sin_beta_squared) * cos_beta * path
        sum_168 = (6.0 - 18.0 * sin_beta_squared) * path_squared + baseline * sum_167
        sum_169 = 8.0 * cos_beta * product_5 + baseline * sum_168
        sum_170 = path_squared_squared + baseline * sum_169
        sum_171 = (40.0 - 7.0 * cos_beta_squared) * baseline - 22.0 * cos_beta * path
        sum_172 = 28.0 * path + cos_beta * sum_171
        sum_173 = cos_beta * sum_172 - 36.0 * baseline
        sum_174 = 4.0 - 7.0 * cos_beta_squared
        sum_175 = path_squared * sum_174 + baseline * sum_173
        sum_176 = 32.0 * sum_175 * sum_8_squared - 64.0 * sigma_beta_squared * sin_beta_squared * sum_170
        sum_177 = 4.0 - 4.0 * sin_beta_squared
        sum_178 = 1.0 - (2.0 - sin_beta_squared) * sin_beta_squared
        sum_179 = baseline * sum_178 - cos_beta * path * sum_177
        sum_180 = (6.0 - 6.0 * sin_beta_squared) * path_squared + baseline * sum_179
        sum_181 = baseline * sum_180 - 4.0 * cos_beta * product_5
        sum_182 = path_squared_squared + baseline * sum_181
        sum_183 = 64.0 * sin_beta_squared * sum_182 - sigma_beta_squared * sum_176
        sum_184 = path_squared * sum_183 * sum_1_squared * sum_2_squared - sigma_path * sum_165
        sum_185 = rho * sigma_path * sin_beta * sum_62 + sigma_beta * sum_184
        sum_56_squared = sum_56**2
        sum_186 = 2.0 * path_squared + baseline * (product_16 + product_3)
        sum_187 = (
            2304.0 * (1.0 - sin_beta) * baseline_squared * sigma_path_squared * (1.0 + sin_beta) * sin_beta_squared**2
            + 384.0 * (1.0 - cos_beta) * (1.0 + cos_beta) * cos_beta_squared * sum_186 * sum_8_squared
        )
        sum_188 = (
            64.0 * cos_beta_squared * sum_56_squared * sum_8_squared_squared
            + baseline_squared * sigma_path_squared * sum_187
        )
        sum_189 = sigma_path_squared * sum_188 + sigma_beta * sum_185
        sum_190 = 5.0 - 6.0 * sin_beta_squared
        sum_191 = 5.0 * baseline * cos_beta - path * sum_190
        sum_192 = 62.0 - (77.0 - 18.0 * sin_beta_squared) * sin_beta_squared
        sum_193 = (5.0 + 2.0 * sin_beta_squared) * baseline * cos_beta - (51.0 - 18.0 * sin_beta_squared) * path
        sum_194 = 33.0 * path - 7.0 * baseline * cos_beta + sin_beta_squared * sum_193
        sum_195 = baseline * sum_194 - cos_beta * path_squared * sum_192
        sum_196 = 103.0 - 42.0 * sin_beta_squared
        sum_197 = 58.0 - sin_beta_squared * sum_196
        sum_198 = product_5 * sum_197 + baseline * sum_195
        sum_199 = baseline * sum_198 - (27.0 - 30.0 * sin_beta_squared) * cos_beta * path_squared_squared
        sum_200 = (
            384.0 * product_6 * sum_190
            - 2304.0 * baseline_squared * sigma_path_squared * sin_beta_squared * sum_191
            + 384.0 * baseline * sum_199
        )
        sum_201 = (
            64.0 * (cos_beta * sum_55 + path) * sum_1 * sum_2 * sum_56 * sum_8_squared_squared
            - baseline_squared * sigma_path_squared * sin_beta_squared * sum_200
        )
        sum_202 = 8.0 - 11.0 * sin_beta_squared
        sum_203 = 5.0 + sin_beta_squared
        sum_204 = baseline * cos_beta * sum_203 - path * sum_202
        sum_205 = baseline * sum_204 - 6.0 * cos_beta * path_squared * sin_beta_squared
        product_26 = product_5 * sum_177
        sum_206 = product_26 + baseline * sum_205
        sum_207 = product_15 + baseline * sum_206
        sum_208 = baseline * cos_beta * (11.0 + sin_beta_squared) - (20.0 - 26.0 * sin_beta_squared) * path
        sum_209 = (6.0 - 15.0 * sin_beta_squared) * cos_beta * path_squared + baseline * sum_208
        sum_210 = product_26 + baseline * sum_209
        sum_211 = product_15 + baseline * sum_210
        sum_212 = 25.0 - 24.0 * sin_beta_squared
        sum_213 = 32.0 - (17.0 + 18.0 * sin_beta_squared) * sin_beta_squared
        sum_214 = 29.0 - (41.0 + 6.0 * sin_beta_squared) * sin_beta_squared
        sum_215 = baseline * sum_214 - (4.0 - 51.0 * sin_beta_squared) * cos_beta * path
        sum_216 = baseline * sum_215 - path_squared * sum_213
        sum_217 = (13.0 + 5.0 * sin_beta_squared) * cos_beta * product_24 - path * sum_216
        sum_218 = baseline * sum_217 - cos_beta * path_squared_squared * sum_212
        sum_219 = product_6 * sum_190 + baseline * sum_218
        sum_220 = 1536.0 * sigma_path * sin_beta * sum_211 + 512.0 * rho * sigma_beta * sum_219
        sum_221 = 212.0 - 24.0 * cos_beta_squared
        sum_222 = 104.0 - cos_beta_squared * sum_221
        sum_223 = 308.0 - 129.0 * cos_beta_squared
        sum_224 = 194.0 - 18.0 * cos_beta_squared
        sum_225 = (24.0 - 2.0 * cos_beta_squared) * baseline - 41.0 * cos_beta * path
        sum_226 = baseline * sum_225 - path_squared * sum_224
        sum_227 = 139.0 * baseline * path + cos_beta * sum_226
        sum_228 = 214.0 * path_squared - 36.0 * baseline_squared + cos_beta * sum_227
        sum_229 = baseline * sum_228 - cos_beta * product_5 * sum_223
        sum_230 = baseline * sum_229 - path_squared_squared * sum_222
        sum_231 = 72.0 * baseline_squared - 55.0 * path_squared
        sum_232 = cos_beta * sum_230 - baseline * path * sum_231
        sum_233 = 1.0 + (89.0 - 72.0 * cos_beta_squared) * cos_beta_squared
        sum_234 = product_6 * sum_233 + baseline * sum_232
        sum_235 = baseline * sum_234 - (16.0 + 26.0 * cos_beta_squared) * cos_beta * path_squared_cubed
        sum_236 = 16.0 * cos_beta_squared * product_21 + baseline * sum_235
        sum_237 = baseline * sum_236 - 2.0 * cos_beta * term_4
        sum_238 = 106.0 - 30.0 * cos_beta_squared
        sum_239 = 112.0 * path + cos_beta * (13.0 * baseline + product_25)
        sum_240 = cos_beta * sum_239 - 36.0 * baseline
        sum_241 = 83.0 - 110.0 * cos_beta_squared
        sum_242 = path_squared * sum_241 + baseline * sum_240
        sum_243 = baseline * sum_242 - cos_beta * product_5 * sum_238
        sum_244 = 36.0 * baseline_squared - 8.0 * path_squared
        sum_245 = cos_beta * sum_243 - path * sum_244
        sum_246 = (14.0 + 77.0 * cos_beta_squared) * cos_beta * path_squared_squared + baseline * sum_245
        sum_247 = baseline * sum_246 - 42.0 * cos_beta_squared * product_6
        sum_248 = 7.0 * cos_beta * path_squared_cubed + baseline * sum_247
        sum_249 = (
            256.0 * sigma_beta_squared * sum_237
            - baseline_squared * sigma_path * sin_beta * sum_220
            + 64.0 * sum_248 * sum_8_squared
        )
        sum_250 = 125.0 - 144.0 * sin_beta_squared
        sum_251 = 112.0 + 96.0 * sin_beta_squared
        sum_252 = 172.0 - sin_beta_squared * sum_251
        sum_253 = 14.0 - 291.0 * sin_beta_squared
        sum_254 = 226.0 + 36.0 * sin_beta_squared
        sum_255 = 154.0 - sin_beta_squared * sum_254
        sum_256 = baseline * sum_255 - cos_beta * path * sum_253
        sum_257 = baseline * sum_256 - path_squared * sum_252
        sum_258 = (71.0 + 37.0 * sin_beta_squared) * cos_beta * product_24 - path * sum_257
        sum_259 = baseline * sum_258 - cos_beta * path_squared_squared * sum_250
        sum_260 = (22.0 - 24.0 * sin_beta_squared) * product_6 + baseline * sum_259
        sum_261 = 128.0 * baseline_squared * sigma_beta * sigma_path * sin_beta * sum_260 - rho * sum_249
        sum_262 = cos_beta * (56.0 * path + product_19) - 18.0 * baseline
        sum_263 = (49.0 - 58.0 * cos_beta_squared) * path_squared + baseline * sum_262
        sum_264 = baseline * sum_263 - (62.0 - 12.0 * cos_beta_squared) * cos_beta * product_5
        sum_265 = 18.0 * baseline_squared + 2.0 * path_squared
        sum_266 = cos_beta * sum_264 - path * sum_265
        sum_267 = (16.0 + 49.0 * cos_beta_squared) * cos_beta * path_squared_squared + baseline * sum_266
        sum_268 = baseline * sum_267 - 30.0 * cos_beta_squared * product_6
        sum_269 = 5.0 * cos_beta * path_squared_cubed + baseline * sum_268
        sum_270 = 10.0 - (94.0 - 72.0 * cos_beta_squared) * cos_beta_squared
        sum_271 = 196.0 - 21.0 * cos_beta_squared
        sum_272 = 121.0 - cos_beta_squared * sum_271
        sum_273 = 280.0 - 126.0 * cos_beta_squared
        sum_274 = 190.0 - 18.0 * cos_beta_squared
        sum_275 = (24.0 - cos_beta_squared) * baseline - 46.0 * cos_beta * path
        sum_276 = baseline * sum_275 - path_squared * sum_274
        sum_277 = 146.0 * baseline * path + cos_beta * sum_276
        sum_278 = 188.0 * path_squared - 36.0 * baseline_squared + cos_beta * sum_277
        sum_279 = baseline * sum_278 - cos_beta * product_5 * sum_273
        sum_280 = baseline * sum_279 - path_squared_squared * sum_272
        sum_281 = 72.0 * baseline_squared - 74.0 * path_squared
        sum_282 = cos_beta * sum_280 - baseline * path * sum_281
        sum_283 = baseline * sum_282 - product_6 * sum_270
        sum_284 = baseline * sum_283 - (2.0 + 22.0 * cos_beta_squared) * cos_beta * path_squared_cubed
        sum_285 = 8.0 * cos_beta_squared * product_21 + baseline * sum_284
        sum_286 = baseline * sum_285 - cos_beta * term_4
        sum_287 = (
            64.0 * sigma_beta_squared * sum_286
            - 768.0 * baseline_squared * sigma_path_squared * sin_beta_squared * sum_207
            - rho * sum_261
            + 64.0 * sum_269 * sum_8_squared
        )
        product_27 = -7.0 * cos_beta * path
        sum_288 = 40.0 * path + cos_beta * (16.0 * baseline + product_27)
        sum_289 = cos_beta * sum_288 - 36.0 * baseline
        sum_290 = (16.0 - 22.0 * cos_beta_squared) * path_squared + baseline * sum_289
        sum_291 = baseline * sum_290 - 7.0 * cos_beta * product_5
        sum_292 = baseline + product_11
        sum_293 = 64.0 * sum_292 * sum_8_squared - 32.0 * sigma_beta_squared * sum_291
        sum_294 = 4.0 * path + cos_beta * (4.0 * baseline + product_11)
        sum_295 = cos_beta * sum_294 - 6.0 * baseline
        sum_296 = (4.0 - 4.0 * cos_beta_squared) * path_squared + baseline * sum_295
        sum_297 = product_9 + baseline * sum_296
        sigma_beta_squared_squared = sigma_beta_squared**2
        sum_298 = sum_293 * sum_8_squared - 64.0 * sigma_beta_squared_squared * sum_297 * sum_67
        sum_299 = path * sum_1_squared * sum_298 * sum_2_squared - sigma_path_squared * sum_287
        sum_300 = 1.0 + (38.0 - 36.0 * sin_beta_squared) * sin_beta_squared
        sum_301 = 14.0 - (52.0 + 32.0 * sin_beta_squared) * sin_beta_squared
        sum_302 = 2.0 + (6.0 + 4.0 * sin_beta_squared) * sin_beta_squared
        sum_303 = 32.0 + (29.0 + 2.0 * sin_beta_squared) * sin_beta_squared
        sum_304 = baseline * sum_303 - (98.0 + 32.0 * sin_beta_squared) * cos_beta * path
        sum_305 = 36.0 - (91.0 + 6.0 * sin_beta_squared) * sin_beta_squared
        sum_306 = path_squared * sum_305 + baseline * sum_304
        sum_307 = 3.0 * baseline + 8.0 * cos_beta * path
        sum_308 = 21.0 * path_squared - baseline * sum_307 + sin_beta_squared * sum_306
        sum_309 = cos_beta * product_24 * sum_302 + path * sum_308
        sum_310 = baseline * sum_309 - cos_beta * path_squared_squared * sum_301
        sum_311 = baseline * sum_310 - product_6 * sum_300
        sum_312 = 4.0 * cos_beta * path_squared_cubed + baseline * sum_311
        sum_313 = baseline * sum_312 - (1.0 - 2.0 * sin_beta_squared) * product_21
        sum_314 = 107.0 * path + cos_beta * (22.0 * baseline + product_16)
        sum_315 = 13.0 * baseline_squared - path * sum_314
        sum_316 = 83.0 * baseline * path + cos_beta * sum_315
        sum_317 = 119.0 * path_squared - 18.0 * baseline_squared + cos_beta * sum_316
        sum_318 = baseline * sum_317 - (91.0 - 50.0 * cos_beta_squared) * cos_beta * product_5
        sum_319 = 54.0 * baseline_squared - path_squared
        sum_320 = cos_beta * sum_318 - path * sum_319
        sum_321 = baseline * sum_320 - (3.0 - 32.0 * cos_beta_squared) * cos_beta * path_squared_squared
        sum_322 = (7.0 - 14.0 * cos_beta_squared) * product_6 + baseline * sum_321
        sum_323 = 64.0 * sum_322 * sum_8_squared - 192.0 * sigma_beta_squared * sum_313
        sum_324 = sin_beta * sum_299 - rho * sigma_beta * sigma_path * sum_1 * sum_2 * sum_323
        sum_325 = rho * sigma_path * sum_201 + sigma_beta * sum_324
        sum_326 = 12.0 - 9.0 * sin_beta_squared
        sum_327 = 1.0 + sin_beta_squared
        sum_328 = baseline * cos_beta * sum_327 - (10.0 - 2.0 * sin_beta_squared) * path
        sum_329 = 8.0 * path + product_1 + sin_beta_squared * sum_328
        sum_330 = baseline * sum_329 - cos_beta * path_squared * sum_326
        sum_331 = (8.0 - 8.0 * sin_beta_squared) * product_5 + baseline * sum_330
        sum_332 = (
            384.0 * baseline * sum_331
            - 2304.0 * baseline_squared * cos_beta * sigma_path_squared * sin_beta_squared
            - 768.0 * cos_beta * path_squared_squared
        )
        sum_333 = (
            64.0 * cos_beta * sum_56_squared * sum_8_squared_squared
            - baseline_squared * sigma_path_squared * sin_beta_squared * sum_332
        )
        sum_334 = sigma_path_squared * sin_beta * sum_333 + sigma_beta * sum_325
        sum_335 = 5.0 - sin_beta_squared * (4.0 + sin_beta_squared)
        sum_336 = baseline * sum_335 - (23.0 - 11.0 * sin_beta_squared) * cos_beta * path
        sum_337 = 42.0 - (45.0 - 9.0 * sin_beta_squared) * sin_beta_squared
        sum_338 = path_squared * sum_337 + baseline * sum_336
        sum_339 = baseline * sum_338 - (38.0 - 21.0 * sin_beta_squared) * cos_beta * product_5
        sum_340 = (17.0 - 15.0 * sin_beta_squared) * path_squared_squared + baseline * sum_339
        sum_341 = (
            13824.0 * baseline_squared * sigma_path_squared * sin_beta_squared * sum_292
            - 2304.0 * cos_beta * product_6
            + 768.0 * baseline * sum_340
        )
        sum_342 = (
            128.0 * sum_1 * sum_2 * sum_292 * sum_56 * sum_8_squared_squared
            + baseline_squared * sigma_path_squared * sin_beta_squared * sum_341
        )
        sum_343 = 47.0 * path + cos_beta * (32.0 * baseline + product_27)
        sum_344 = 28.0 * baseline_squared - path * sum_343
        sum_345 = 52.0 * baseline * path + cos_beta * sum_344
        sum_346 = 28.0 * path_squared - 36.0 * baseline_squared + cos_beta * sum_345
        sum_347 = baseline * sum_346 - (26.0 - 22.0 * cos_beta_squared) * cos_beta * product_5
        sum_348 = baseline * sum_347 - path_squared_squared * sum_148
        sum_349 = 64.0 * sum_292**2 * sum_8_squared - 32.0 * sigma_beta_squared * sum_348
        sum_350 = 64.0 * sigma_beta_squared_squared * sum_297**2 + sum_349 * sum_8_squared
        product_28 = 4.0 * cos_beta * product_5
        sum_351 = baseline * (8.0 + sin_beta_squared) + product_25
        sum_352 = (3.0 - 6.0 * sin_beta_squared) * path_squared + baseline * sum_351
        sum_353 = product_28 + baseline * sum_352
        sum_354 = baseline * sum_353 - path_squared_squared
        sum_355 = (27.0 + 9.0 * sin_beta_squared) * baseline - (68.0 + 6.0 * sin_beta_squared) * cos_beta * path
        sum_356 = (38.0 - 63.0 * sin_beta_squared) * path_squared + baseline * sum_355
        sum_357 = (24.0 + 16.0 * sin_beta_squared) * cos_beta * product_5 + baseline * sum_356
        sum_358 = baseline * sum_357 - path_squared_squared * sum_212
        sum_359 = 4.0 * cos_beta * product_6 + baseline * sum_358
        sum_360 = baseline * (17.0 + sin_beta_squared) - 32.0 * cos_beta * path
        sum_361 = (12.0 - 15.0 * sin_beta_squared) * path_squared + baseline * sum_360
        sum_362 = product_28 + baseline * sum_361
        sum_363 = baseline * sum_362 - path_squared_squared
        sum_364 = baseline * sum_203 - cos_beta * path * (13.0 + sin_beta_squared)
        sum_365 = path_squared * sum_202 + baseline * sum_364
        sum_366 = cos_beta * product_5 * sum_76 + baseline * sum_365
        sum_367 = baseline * sum_366 - (5.0 - 4.0 * sin_beta_squared) * path_squared_squared
        sum_368 = cos_beta * product_6 + baseline * sum_367
        sum_369 = 1536.0 * sigma_path * sin_beta * sum_363 + 3072.0 * rho * sigma_beta * sum_368
        sum_370 = 768.0 * sigma_beta * sum_359 + rho * sum_369
        sum_371 = 768.0 * sigma_path * sin_beta * sum_354 + rho * sum_370
        product_29 = -8.0 * cos_beta * product_21
        sum_372 = 86.0 - (83.0 + 12.0 * sin_beta_squared) * sin_beta_squared
        sum_373 = 31.0 + sin_beta_squared * (22.0 + sin_beta_squared)
        sum_374 = baseline * sum_373 - (95.0 + 31.0 * sin_beta_squared) * cos_beta * path
        sum_375 = 67.0 - (124.0 + 9.0 * sin_beta_squared) * sin_beta_squared
        sum_376 = path_squared * sum_375 + baseline * sum_374
        sum_377 = (58.0 + 83.0 * sin_beta_squared) * cos_beta * product_5 + baseline * sum_376
        sum_378 = baseline * sum_377 - path_squared_squared * sum_372
        sum_379 = (13.0 - 36.0 * sin_beta_squared) * cos_beta * product_6 + baseline * sum_378
        sum_380 = (19.0 - 13.0 * sin_beta_squared) * path_squared_cubed + baseline * sum_379
        sum_381 = product_29 + baseline * sum_380
        sum_382 = 146.0 + 21.0 * sin_beta_squared
        sum_383 = 122.0 - sin_beta_squared * sum_382
        sum_384 = 140.0 + 76.0 * sin_beta_squared
        sum_385 = 49.0 + sin_beta_squared * (58.0 + sin_beta_squared)
        sum_386 = baseline * sum_385 - cos_beta * path * sum_384
        sum_387 = 214.0 + 18.0 * sin_beta_squared
        sum_388 = 76.0 - sin_beta_squared * sum_387
        sum_389 = path_squared * sum_388 + baseline * sum_386
        sum_390 = 112.0 + 164.0 * sin_beta_squared
        sum_391 = cos_beta * product_5 * sum_390 + baseline * sum_389
        sum_392 = baseline * sum_391 - path_squared_squared * sum_383
        sum_393 = (4.0 - 72.0 * sin_beta_squared) * cos_beta * product_6 + baseline * sum_392
        sum_394 = (28.0 - 22.0 * sin_beta_squared) * path_squared_cubed + baseline * sum_393
        sum_395 = product_29 + baseline * sum_394
        sum_396 = 512.0 * rho_squared * (baseline * sum_381 + term_4) + 64.0 * baseline * sum_395 + 64.0 * term_4
        sum_397 = baseline_squared * sigma_path * sin_beta * sum_371 + sigma_beta_squared * sum_396
        sum_398 = 8.0 - (4.0 + 49.0 * cos_beta_squared) * cos_beta_squared
        sum_399 = cos_beta * (86.0 * path + product_19) - 38.0 * baseline
        sum_400 = 117.0 - 66.0 * cos_beta_squared
        sum_401 = path_squared * sum_400 + baseline * sum_399
        sum_402 = baseline * sum_401 - (88.0 - 12.0 * cos_beta_squared) * cos_beta * product_5
        sum_403 = 100.0 * baseline_squared - 16.0 * path_squared
        sum_404 = cos_beta * sum_402 - path * sum_403
        sum_405 = 36.0 * baseline_squared - 6.0 * path_squared
        sum_406 = cos_beta * sum_404 + baseline * sum_405
        sum_407 = baseline * sum_406 - path_squared_squared * sum_398
        sum_408 = (12.0 - 30.0 * cos_beta_squared) * cos_beta * product_6 + baseline * sum_407
        sum_409 = 10.0 + (22.0 - 77.0 * cos_beta_squared) * cos_beta_squared
        sum_410 = 140.0 - 30.0 * cos_beta_squared
        sum_411 = 166.0 * path + cos_beta * (19.0 * baseline + product_25)
        sum_412 = cos_beta * sum_411 - 88.0 * baseline
        sum_413 = 207.0 - 132.0 * cos_beta_squared
        sum_414 = path_squared * sum_413 + baseline * sum_412
        sum_415 = baseline * sum_414 - cos_beta * product_5 * sum_410
        sum_416 = 170.0 * baseline_squared - 50.0 * path_squared
        sum_417 = cos_beta * sum_415 - path * sum_416
        sum_418 = 72.0 * baseline_squared - 30.0 * path_squared
        sum_419 = cos_beta * sum_417 + baseline * sum_418
        sum_420 = baseline * sum_419 - path_squared_squared * sum_409
        sum_421 = (24.0 - 42.0 * cos_beta_squared) * cos_beta * product_6 + baseline * sum_420
        sum_422 = baseline * sum_421 - path_squared_cubed * sum_174
        sum_423 = (
            64.0 * rho_squared * sum_422
            - 64.0 * (2.0 - 5.0 * cos_beta_squared) * path_squared_cubed
            + 64.0 * baseline * sum_408
        )
        sum_424 = sin_beta_squared * sum_397 + sum_423 * sum_8_squared
        sum_425 = 46.0 * path + cos_beta * (13.0 * baseline + product_13)
        sum_426 = cos_beta * sum_425 - 36.0 * baseline
        sum_427 = (13.0 - 25.0 * cos_beta_squared) * path_squared + baseline * sum_426
        sum_428 = baseline * sum_427 - 16.0 * cos_beta * product_5
        sum_429 = 7.0 * path_squared_squared + baseline * sum_428
        sum_430 = product_8 - 8.0 * cos_beta * path
        sum_431 = baseline * sum_430 - (3.0 - 3.0 * cos_beta_squared) * path_squared
        sum_432 = product_28 + baseline * sum_431
        sum_433 = baseline * sum_432 - path_squared_squared
        sum_434 = 128.0 * sum_292 * sum_429 * sum_8_squared + 384.0 * sigma_beta_squared * sum_297 * sum_433
        sum_435 = rho * sigma_beta * sin_beta * sum_1 * sum_2 * sum_434 - sigma_path * sum_424
        sum_436 = sum_1_squared * sum_2_squared * sum_350 - sigma_path * sum_435
        sum_437 = rho * sigma_path * sin_beta * sum_342 + sigma_beta * sum_436
        sum_438 = 56.0 - (72.0 - 20.0 * sin_beta_squared) * sin_beta_squared
        sum_439 = 54.0 - (30.0 - 4.0 * sin_beta_squared) * sin_beta_squared
        sum_440 = (12.0 - 4.0 * sin_beta_squared) * baseline * cos_beta - path * sum_439
        sum_441 = 28.0 * path - 8.0 * baseline * cos_beta + sin_beta_squared * sum_440
        sum_442 = baseline_squared * sum_178 + path * sum_441
        sum_443 = baseline * sum_442 - cos_beta * product_5 * sum_438
        sum_444 = 110.0 - 41.0 * sin_beta_squared
        sum_445 = 70.0 - sin_beta_squared * sum_444
        sum_446 = path_squared_squared * sum_445 + baseline * sum_443
        sum_447 = baseline * sum_446 - (56.0 - 44.0 * sin_beta_squared) * cos_beta * product_6
        sum_448 = (28.0 - 26.0 * sin_beta_squared) * path_squared_cubed + baseline * sum_447
        sum_449 = product_29 + baseline * sum_448
        sum_450 = 2.0 - sin_beta_squared * sum_327
        sum_451 = baseline * sum_450 - (8.0 - 2.0 * sin_beta_squared) * cos_beta * path
        sum_452 = path_squared * sum_326 + baseline * sum_451
        sum_453 = baseline * sum_452 - 8.0 * cos_beta * product_5
        sum_454 = (
            2304.0 * baseline_squared * sigma_path_squared * sin_beta_squared
            + 384.0 * baseline * sum_453
            + 768.0 * path_squared_squared
        )
        sum_455 = (
            64.0 * baseline * sum_449
            + 64.0 * term_4
            + baseline_squared * sigma_path_squared * sin_beta_squared * sum_454
        )
        sum_456 = sigma_path_squared * sin_beta_squared * sum_455 + sigma_beta * sum_437
        mean[i, 0] = -sum_27 * term_2
        mean[i, 1] = -sum_54 * term_2
        covariance[i, 0, 0] = sum_189 * term_3
        covariance[i, 0, 1] = sum_334 * term_3
        covariance[i, 1, 0] = covariance[i, 0, 1]
        covariance[i, 1, 1] = sum_456 * term_3


def bistatic_unbiased(
    all_path: Floats,
    all_beta: Floats,
    all_baseline: Floats,
    all_sigma_path: Floats,
    all_sigma_beta: Floats,
    all_rho: Floats,
    mean: Filled,
    covariance: Filled,
) -> None:
    """Conversion bistatic, unbiased.

    Mean: unbiased estimate of the position, to fourth order. Covariance: error covariance of the unbiased
    estimate u, to fourth order, completed to a sum of squares.
    """
    for i in range(len(all_path)):
        path = all_path[i]
        beta = all_beta[i]
        baseline = all_baseline[i]
        sigma_path = all_sigma_path[i]
        sigma_beta = all_sigma_beta[i]
        rho = all_rho[i]
        cos_beta = math.cos(beta)
        divisor_1 = 2.0 * path - 2.0 * baseline * cos_beta
        sigma_path_squared = sigma_path**2
        sin_beta = math.sin(beta)
        sin_beta_squared = sin_beta**2
        sum_1 = 2.0 - 2.0 * sin_beta_squared
        sum_2 = 1.0 - sin_beta_squared
        sum_3 = baseline * cos_beta * sum_2 - path * sum_1
        path_squared = path**2
        baseline_squared = baseline**2
        sum_4 = 16.0 * cos_beta * path_squared - 48.0 * cos_beta * sigma_path_squared + 16.0 * baseline * sum_3
        product_1 = -3.0 * cos_beta * path
        cos_beta_squared = cos_beta**2
        sum_5 = (3.0 - cos_beta_squared) * baseline + product_1
        product_2 = baseline * cos_beta
        sum_6 = product_2 - path
        sum_6_squared = sum_6**2
        sum_7 = baseline * (path + product_2) - 3.0 * cos_beta * path_squared
        product_3 = path * path_squared
        sum_8 = (
            16.0 * (product_3 + baseline * sum_7) * sum_6_squared
            - 48.0 * baseline_squared * (cos_beta * sum_5 + path) * sigma_path_squared
        )
        product_4 = -cos_beta * product_3
        product_5 = -11.0 * cos_beta * path
        product_6 = (20.0 - cos_beta_squared) * baseline
        sum_9 = 20.0 * path + cos_beta * (product_5 + product_6)
        sum_10 = cos_beta * sum_9 - 24.0 * baseline
        sum_11 = (8.0 - 11.0 * cos_beta_squared) * path_squared + baseline * sum_10
        sigma_beta_squared = sigma_beta**2
        product_7 = -cos_beta * path
        product_8 = (2.0 - cos_beta_squared) * baseline
        sum_12 = baseline + path
        sum_13 = baseline - path
        sum_14 = (
            2.0 * (product_4 + baseline * sum_11) * sigma_beta_squared
            + 8.0 * (product_7 + product_8) * sum_6_squared
        )
        product_9 = path * path_squared**2
        path_squared_squared = path_squared**2
        product_10 = 5.0 * cos_beta * path_squared_squared
        product_11 = (6.0 - cos_beta_squared) * baseline
        sum_15 = baseline * (product_11 + product_5) - (29.0 - 3.0 * cos_beta_squared) * path_squared
        sum_16 = 18.0 * baseline * path + cos_beta * sum_15
        sum_17 = baseline * sum_16 - (7.0 - 17.0 * cos_beta_squared) * product_3
        sum_18 = baseline * (product_10 + baseline * sum_17) - product_9
        sum_19 = 13.0 * path + cos_beta * (4.0 * baseline + product_1)
        sum_20 = cos_beta * sum_19 - 6.0 * baseline
        sum_21 = (7.0 - 9.0 * cos_beta_squared) * path_squared + baseline * sum_20
        rho_squared = rho**2
        sum_22 = cos_beta * sum_21 - 6.0 * baseline * path
        sum_23 = (
            (8.0 + 16.0 * rho_squared) * baseline_squared * sigma_path * sum_22
            - 8.0 * rho * sigma_beta * sin_beta * sum_18
        )
        sum_24 = path * sum_12 * sum_13 * sum_14 + sigma_path * sum_23
        sum_25 = rho * sigma_path * sin_beta * sum_8 + sigma_beta * sum_24
        sum_6_squared_squared = sum_6_squared**2
        term_1 = 1.0 / (divisor_1 * (divisor_1**2)**2)
        sum_26 = (
            16.0 * cos_beta * sum_12 * sum_13 * sum_6_squared_squared
            - baseline_squared * sigma_path_squared * sin_beta_squared * sum_4
            - sigma_beta * sum_25
        )
        sum_27 = 2.0 * baseline + product_7
        sum_28 = baseline * sum_27 - path_squared
        sum_29 = 16.0 * sum_6_squared - 8.0 * sigma_beta_squared * sum_28
        sum_30 = 20.0 * path + cos_beta * (8.0 * baseline + product_7)
        sum_31 = cos_beta * sum_30 - 24.0 * baseline
        sum_32 = (20.0 - 11.0 * cos_beta_squared) * path_squared + baseline * sum_31
        sum_33 = baseline * sum_32 - 11.0 * cos_beta * product_3
        sigma_beta_squared_squared = sigma_beta_squared**2
        sum_34 = baseline * sum_33 - path_squared_squared
        sum_35 = sum_29 * sum_6_squared - 2.0 * sigma_beta_squared_squared * sum_34
        product_12 = -2.0 * cos_beta * path
        sum_36 = (
            16.0 * baseline * (product_12 + baseline * sum_2)
            - 48.0 * sigma_path_squared
            + 16.0 * path_squared
        )
        sum_37 = cos_beta * (5.0 * path + cos_beta * sum_27) - 4.0 * baseline
        sum_38 = (1.0 - 3.0 * cos_beta_squared) * path_squared + baseline * sum_37
        sum_39 = baseline * (3.0 + sin_beta_squared) + product_1
        sum_40 = 48.0 * rho * sigma_path * sin_beta * sum_39 - (24.0 + 48.0 * rho_squared) * sigma_beta * sum_38
        sum_41 = sin_beta_squared * sum_36 - sigma_beta * sum_40
        sum_42 = sum_12 * sum_13 * sum_35 - baseline_squared * sigma_path_squared * sum_41
        sum_43 = 3.0 * cos_beta_squared * path_squared + baseline * (product_1 + product_8)
        sum_44 = product_6 - 19.0 * cos_beta * path
        sum_45 = baseline * sum_44 - (31.0 - 3.0 * cos_beta_squared) * path_squared
        product_13 = 32.0 * baseline * path
        sum_46 = 20.0 * path_squared - 24.0 * baseline_squared + cos_beta * (cos_beta * sum_45 + product_13)
        sum_47 = baseline * sum_46 - (21.0 - 17.0 * cos_beta_squared) * cos_beta * product_3
        sum_48 = 5.0 * cos_beta_squared * path_squared_squared + baseline * sum_47
        sum_49 = baseline * sum_48 - cos_beta * product_9
        sum_50 = 16.0 * (product_4 + baseline * sum_43) * sum_6_squared + 8.0 * sigma_beta_squared * sum_49
        sum_51 = sin_beta * sum_42 - rho * sigma_beta * sigma_path * sum_50
        term_2 = 1.0 / ((divisor_1**2)**2)**2
        sum_52 = baseline + product_12
        sum_53 = path_squared + baseline * sum_52
        sum_54 = baseline * sum_1 - (2.0 - 3.0 * sin_beta_squared) * cos_beta * path
        product_14 = -5.0 * cos_beta * path
        sum_55 = baseline * (product_14 + product_8) - (3.0 - 6.0 * cos_beta_squared) * path_squared
        sum_56 = 2.0 * baseline * path + cos_beta * sum_55
        sum_57 = 1.0 - 2.0 * cos_beta_squared
        sum_58 = product_3 * sum_57 + baseline * sum_56
        sum_59 = (
            1152.0 * baseline_squared * sigma_path_squared * sin_beta_squared * sum_54
            + 768.0 * cos_beta * sum_58 * sum_6_squared
        )
        sum_60 = (
            128.0 * cos_beta * path * sum_12 * sum_13 * sum_53 * sum_6_squared_squared
            + baseline_squared * sigma_path_squared * sum_59
        )
        product_15 = -cos_beta * path_squared_squared
        product_16 = -4.0 * cos_beta * path
        sum_61 = baseline * (product_16 + product_8) - (7.0 - 3.0 * cos_beta_squared) * path_squared
        sum_62 = 4.0 * baseline * path + cos_beta * sum_61
        sum_63 = 4.0 * cos_beta_squared * product_3 + baseline * sum_62
        sum_64 = product_15 + baseline * sum_63
        sum_65 = baseline * (product_11 + product_16) - path_squared
        sum_66 = 20.0 * path + cos_beta * (5.0 * baseline + product_7)
        sum_67 = cos_beta * sum_66 - 12.0 * baseline
        sum_68 = (29.0 - 17.0 * cos_beta_squared) * path_squared + baseline * sum_67
        sum_69 = cos_beta * sum_68 - 12.0 * baseline * path
        sum_70 = baseline * sum_69 - (6.0 + 11.0 * cos_beta_squared) * product_3
        sum_71 = (
            128.0 * (product_10 + baseline * sum_70) * sum_6_squared
            - 96.0 * sigma_beta_squared * sum_64 * sum_65
        )
        product_17 = -(3.0 - 3.0 * sin_beta_squared) * path_squared_squared
        sum_72 = 8.0 + (9.0 - 18.0 * sin_beta_squared) * sin_beta_squared
        sum_73 = 4.0 + 3.0 * sin_beta_squared
        sum_74 = 7.0 - sin_beta_squared * sum_73
        sum_75 = baseline * sum_74 - (8.0 - 24.0 * sin_beta_squared) * cos_beta * path
        sum_76 = baseline * sum_75 - path_squared * sum_72
        product_18 = (12.0 - 12.0 * sin_beta_squared) * cos_beta * product_3
        sum_77 = baseline * (product_18 + baseline * sum_76) + product_17
        term_3 = (path_squared**2)**2
        product_19 = -cos_beta_squared * term_3
        product_20 = path * path_squared * path_squared**2
        product_21 = 8.0 * cos_beta * cos_beta_squared * product_20
        path_squared_cubed = path_squared * path_squared**2
        sum_78 = 4.0 - (2.0 - 22.0 * cos_beta_squared) * cos_beta_squared
        sum_79 = 120.0 - 72.0 * cos_beta_squared
        sum_80 = 16.0 - cos_beta_squared * sum_79
        sum_81 = 204.0 - 21.0 * cos_beta_squared
        sum_82 = 225.0 - cos_beta_squared * sum_81
        sum_83 = 224.0 - 88.0 * cos_beta_squared
        sum_84 = 162.0 - 18.0 * cos_beta_squared
        product_22 = (4.0 - cos_beta_squared) * baseline
        sum_85 = product_22 - 16.0 * cos_beta * path
        sum_86 = baseline * sum_85 - path_squared * sum_84
        sum_87 = 80.0 * baseline * path + cos_beta * sum_86
        sum_88 = 192.0 * path_squared - 4.0 * baseline_squared + cos_beta * sum_87
        sum_89 = baseline * sum_88 - cos_beta * product_3 * sum_83
        sum_90 = baseline * sum_89 - path_squared_squared * sum_82
        sum_91 = 64.0 * baseline_squared - 128.0 * path_squared
        sum_92 = cos_beta * sum_90 - baseline * path * sum_91
        sum_93 = baseline * sum_92 - product_9 * sum_80
        sum_94 = 40.0 * baseline_squared - 28.0 * path_squared
        sum_95 = cos_beta * sum_93 - baseline * path_squared * sum_94
        sum_96 = baseline * sum_95 - path_squared_cubed * sum_78
        sum_97 = baseline * (product_21 + baseline * sum_96) + product_19
        product_23 = -6.0 * cos_beta * path
        sum_98 = 26.0 * path + cos_beta * (2.0 * baseline + product_23)
        sum_99 = cos_beta * sum_98 - 3.0 * baseline
        sum_100 = (32.0 - 26.0 * cos_beta_squared) * path_squared + baseline * sum_99
        sum_101 = baseline * sum_100 - (34.0 - 10.0 * cos_beta_squared) * cos_beta * product_3
        sum_102 = 18.0 * baseline_squared - 12.0 * path_squared
        sum_103 = cos_beta * sum_101 - path * sum_102
        sum_104 = baseline * sum_103 - (11.0 - 24.0 * cos_beta_squared) * cos_beta * path_squared_squared
        sum_105 = 6.0 - 12.0 * cos_beta_squared
        sum_106 = product_9 * sum_105 + baseline * sum_104
        product_24 = baseline * baseline_squared
        sum_107 = cos_beta * sum_106 - 3.0 * path_squared * product_24
        sum_108 = baseline * sum_107 - path_squared_cubed * sum_57
        sum_109 = 5.0 * baseline - 9.0 * cos_beta * path
        sum_110 = 48.0 * path + cos_beta * sum_109
        sum_111 = cos_beta * sum_110 - 10.0 * baseline
        sum_112 = (81.0 - 51.0 * cos_beta_squared) * path_squared + baseline * sum_111
        sum_113 = baseline * sum_112 - (92.0 - 24.0 * cos_beta_squared) * cos_beta * product_3
        sum_114 = 34.0 * baseline_squared - 28.0 * path_squared
        sum_115 = cos_beta * sum_113 - path * sum_114
        sum_116 = baseline * sum_115 - (11.0 - 36.0 * cos_beta_squared) * cos_beta * path_squared_squared
        sum_117 = (1.0 - 6.0 * cos_beta_squared) * product_9 + baseline * sum_116
        sum_118 = cos_beta * sum_117 - 10.0 * path_squared * product_24
        sum_119 = 19.0 - (16.0 + 3.0 * sin_beta_squared) * sin_beta_squared
        sum_120 = baseline * sum_119 - (32.0 - 60.0 * sin_beta_squared) * cos_beta * path
        sum_121 = 4.0 - (45.0 - 45.0 * sin_beta_squared) * sin_beta_squared
        sum_122 = path_squared * sum_121 + baseline * sum_120
        sum_123 = product_18 + baseline * sum_122
        sum_124 = product_17 + baseline * sum_123
        sum_125 = cos_beta * (2.0 * baseline + product_1) + path
        sum_126 = 128.0 * sigma_path * sin_beta * sum_124 + 256.0 * rho * sigma_beta * sum_125 * sum_64
        sum_127 = 1.0 + (10.0 + 13.0 * cos_beta_squared) * cos_beta_squared
        sum_128 = 105.0 - 12.0 * cos_beta_squared
        sum_129 = 114.0 - cos_beta_squared * sum_128
        sum_130 = 128.0 - 46.0 * cos_beta_squared
        sum_131 = product_22 - 10.0 * cos_beta * path
        sum_132 = baseline * sum_131 - (72.0 - 9.0 * cos_beta_squared) * path_squared
        sum_133 = 38.0 * baseline * path + cos_beta * sum_132
        sum_134 = 93.0 * path_squared - 4.0 * baseline_squared + cos_beta * sum_133
        sum_135 = baseline * sum_134 - cos_beta * product_3 * sum_130
        sum_136 = baseline * sum_135 - path_squared_squared * sum_129
        sum_137 = 28.0 * baseline_squared - 74.0 * path_squared
        sum_138 = cos_beta * sum_136 - baseline * path * sum_137
        sum_139 = 2.0 + (66.0 - 36.0 * cos_beta_squared) * cos_beta_squared
        sum_140 = product_9 * sum_139 + baseline * sum_138
        sum_141 = 22.0 * baseline_squared - 7.0 * path_squared
        sum_142 = cos_beta * sum_140 - baseline * path_squared * sum_141
        sum_143 = baseline * sum_142 - path_squared_cubed * sum_127
        sum_144 = product_21 + baseline * sum_143
        sum_145 = product_19 + baseline * sum_144
        sum_146 = 40.0 * path + cos_beta * (7.0 * baseline + product_23)
        sum_147 = cos_beta * sum_146 - 9.0 * baseline
        sum_148 = (79.0 - 64.0 * cos_beta_squared) * path_squared + baseline * sum_147
        sum_149 = baseline * sum_148 - (62.0 - 14.0 * cos_beta_squared) * cos_beta * product_3
        sum_150 = 30.0 * baseline_squared - 24.0 * path_squared
        sum_151 = cos_beta * sum_149 - path * sum_150
        sum_152 = baseline * sum_151 - (37.0 - 69.0 * cos_beta_squared) * cos_beta * path_squared_squared
        sum_153 = 6.0 * path_squared + 9.0 * baseline_squared
        sum_154 = cos_beta * sum_152 - path_squared * sum_153
        sum_155 = (30.0 - 42.0 * cos_beta_squared) * cos_beta * product_9 + baseline * sum_154
        sum_156 = baseline * sum_155 - (5.0 - 7.0 * cos_beta_squared) * path_squared_cubed
        sum_157 = (
            128.0 * sigma_beta_squared * sum_145
            - baseline_squared * sigma_path * sin_beta * sum_126
            + 64.0 * sum_156 * sum_6_squared
        )
        sum_158 = 128.0 * baseline_squared * sigma_beta * sigma_path * sin_beta * sum_118 + rho * sum_157
        sum_159 = (
            16.0 * sigma_beta_squared * sum_97
            - 64.0 * baseline_squared * sigma_path_squared * sin_beta_squared * sum_77
            + 64.0 * sum_108 * sum_6_squared
            + rho * sum_158
        )
        sum_160 = path * rho * sigma_beta * sin_beta * sum_12 * sum_13 * sum_71 + sigma_path * sum_159
        sum_12_squared = sum_12**2
        sum_13_squared = sum_13**2
        sum_161 = 25.0 + sin_beta_squared * (10.0 + sin_beta_squared)
        sum_162 = baseline * sum_161 - (40.0 + 8.0 * sin_beta_squared) * cos_beta * path
        sum_163 = (6.0 - 18.0 * sin_beta_squared) * path_squared + baseline * sum_162
        sum_164 = 8.0 * cos_beta * product_3 + baseline * sum_163
        sum_165 = path_squared_squared + baseline * sum_164
        product_25 = -14.0 * cos_beta * path
        sum_166 = (26.0 - 5.0 * cos_beta_squared) * baseline + product_25
        sum_167 = 20.0 * path + cos_beta * sum_166
        sum_168 = cos_beta * sum_167 - 24.0 * baseline
        sum_169 = (2.0 - 5.0 * cos_beta_squared) * path_squared + baseline * sum_168
        sum_170 = 32.0 * sum_169 * sum_6_squared - 16.0 * sigma_beta_squared * sin_beta_squared * sum_165
        product_26 = -4.0 * cos_beta * product_3
        sum_171 = 4.0 - 4.0 * sin_beta_squared
        sum_172 = 1.0 - (2.0 - sin_beta_squared) * sin_beta_squared
        sum_173 = baseline * sum_172 - cos_beta * path * sum_171
        sum_174 = (6.0 - 6.0 * sin_beta_squared) * path_squared + baseline * sum_173
        sum_175 = product_26 + baseline * sum_174
        sum_176 = path_squared_squared + baseline * sum_175
        sum_177 = 64.0 * sin_beta_squared * sum_176 - sigma_beta_squared * sum_170
        sum_178 = path_squared * sum_12_squared * sum_13_squared * sum_177 - sigma_path * sum_160
        sum_179 = rho * sigma_path * sin_beta * sum_60 + sigma_beta * sum_178
        sum_53_squared = sum_53**2
        sum_180 = baseline * (product_12 + product_8) + path_squared
        sin_beta_squared_squared = sin_beta_squared**2
        sum_181 = (
            384.0 * (1.0 - cos_beta) * (1.0 + cos_beta) * cos_beta_squared * sum_180 * sum_6_squared
            + 576.0 * (1.0 - sin_beta) * baseline_squared * sigma_path_squared * (1.0 + sin_beta) * sin_beta_squared_squared
        )
        sum_182 = (
            64.0 * cos_beta_squared * sum_53_squared * sum_6_squared_squared
            + baseline_squared * sigma_path_squared * sum_181
        )
        sum_183 = sigma_path_squared * sum_182 + sigma_beta * sum_179
        sum_184 = 5.0 - 6.0 * sin_beta_squared
        sum_185 = 5.0 * baseline * cos_beta - path * sum_184
        sum_186 = 36.0 - (46.0 - 12.0 * sin_beta_squared) * sin_beta_squared
        sum_187 = (2.0 + 2.0 * sin_beta_squared) * baseline * cos_beta - (28.0 - 9.0 * sin_beta_squared) * path
        sum_188 = 19.0 * path - 4.0 * baseline * cos_beta + sin_beta_squared * sum_187
        sum_189 = baseline * sum_188 - cos_beta * path_squared * sum_186
        sum_190 = 34.0 - (64.0 - 28.0 * sin_beta_squared) * sin_beta_squared
        sum_191 = product_3 * sum_190 + baseline * sum_189
        sum_192 = baseline * sum_191 - (16.0 - 20.0 * sin_beta_squared) * cos_beta * path_squared_squared
        sum_193 = (
            384.0 * (3.0 - 4.0 * sin_beta_squared) * product_9
            - 576.0 * baseline_squared * sigma_path_squared * sin_beta_squared * sum_185
            + 384.0 * baseline * sum_192
        )
        sum_194 = (
            64.0 * (cos_beta * sum_52 + path) * sum_12 * sum_13 * sum_53 * sum_6_squared_squared
            - baseline_squared * sigma_path_squared * sin_beta_squared * sum_193
        )
        sum_195 = 8.0 - 11.0 * sin_beta_squared
        sum_196 = 5.0 + sin_beta_squared
        sum_197 = baseline * cos_beta * sum_196 - path * sum_195
        sum_198 = baseline * sum_197 - 6.0 * cos_beta * path_squared * sin_beta_squared
        product_27 = product_3 * sum_171
        sum_199 = product_27 + baseline * sum_198
        sum_200 = product_15 + baseline * sum_199
        sum_201 = 25.0 - 24.0 * sin_beta_squared
        sum_202 = 32.0 - (17.0 + 18.0 * sin_beta_squared) * sin_beta_squared
        sum_203 = 29.0 - (41.0 + 6.0 * sin_beta_squared) * sin_beta_squared
        sum_204 = baseline * sum_203 - (4.0 - 51.0 * sin_beta_squared) * cos_beta * path
        sum_205 = baseline * sum_204 - path_squared * sum_202
        sum_206 = (13.0 + 5.0 * sin_beta_squared) * cos_beta * product_24 - path * sum_205
        sum_207 = baseline * sum_206 - cos_beta * path_squared_squared * sum_201
        sum_208 = product_9 * sum_184 + baseline * sum_207
        sum_209 = baseline * cos_beta * (11.0 + sin_beta_squared) - (20.0 - 26.0 * sin_beta_squared) * path
        sum_210 = (6.0 - 15.0 * sin_beta_squared) * cos_beta * path_squared + baseline * sum_209
        sum_211 = product_27 + baseline * sum_210
        sum_212 = product_15 + baseline * sum_211
        sum_213 = 128.0 * rho * sigma_beta * sum_208 + 384.0 * sigma_path * sin_beta * sum_212
        sum_214 = 68.0 * path + cos_beta * (9.0 * baseline + product_23)
        sum_215 = cos_beta * sum_214 - 24.0 * baseline
        sum_216 = (71.0 - 74.0 * cos_beta_squared) * path_squared + baseline * sum_215
        sum_217 = baseline * sum_216 - (86.0 - 14.0 * cos_beta_squared) * cos_beta * product_3
        sum_218 = 24.0 * baseline_squared + 4.0 * path_squared
        sum_219 = cos_beta * sum_217 - path * sum_218
        sum_220 = (22.0 + 69.0 * cos_beta_squared) * cos_beta * path_squared_squared + baseline * sum_219
        sum_221 = baseline * sum_220 - 42.0 * cos_beta_squared * product_9
        sum_222 = 7.0 * cos_beta * path_squared_cubed + baseline * sum_221
        sum_223 = 212.0 - 24.0 * cos_beta_squared
        sum_224 = 104.0 - cos_beta_squared * sum_223
        sum_225 = 308.0 - 129.0 * cos_beta_squared
        sum_226 = 194.0 - 18.0 * cos_beta_squared
        sum_227 = (24.0 - 2.0 * cos_beta_squared) * baseline - 41.0 * cos_beta * path
        sum_228 = baseline * sum_227 - path_squared * sum_226
        sum_229 = 139.0 * baseline * path + cos_beta * sum_228
        sum_230 = 214.0 * path_squared - 36.0 * baseline_squared + cos_beta * sum_229
        sum_231 = baseline * sum_230 - cos_beta * product_3 * sum_225
        sum_232 = baseline * sum_231 - path_squared_squared * sum_224
        sum_233 = 72.0 * baseline_squared - 55.0 * path_squared
        sum_234 = cos_beta * sum_232 - baseline * path * sum_233
        sum_235 = 1.0 + (89.0 - 72.0 * cos_beta_squared) * cos_beta_squared
        sum_236 = product_9 * sum_235 + baseline * sum_234
        sum_237 = baseline * sum_236 - (16.0 + 26.0 * cos_beta_squared) * cos_beta * path_squared_cubed
        sum_238 = 16.0 * cos_beta_squared * product_20 + baseline * sum_237
        sum_239 = baseline * sum_238 - 2.0 * cos_beta * term_3
        sum_240 = (
            64.0 * sigma_beta_squared * sum_239
            - baseline_squared * sigma_path * sin_beta * sum_213
            + 64.0 * sum_222 * sum_6_squared
        )
        sum_241 = 125.0 - 144.0 * sin_beta_squared
        sum_242 = 112.0 + 96.0 * sin_beta_squared
        sum_243 = 172.0 - sin_beta_squared * sum_242
        sum_244 = 14.0 - 291.0 * sin_beta_squared
        sum_245 = 226.0 + 36.0 * sin_beta_squared
        sum_246 = 154.0 - sin_beta_squared * sum_245
        sum_247 = baseline * sum_246 - cos_beta * path * sum_244
        sum_248 = baseline * sum_247 - path_squared * sum_243
        sum_249 = (71.0 + 37.0 * sin_beta_squared) * cos_beta * product_24 - path * sum_248
        sum_250 = baseline * sum_249 - cos_beta * path_squared_squared * sum_241
        sum_251 = (22.0 - 24.0 * sin_beta_squared) * product_9 + baseline * sum_250
        sum_252 = 32.0 * baseline_squared * sigma_beta * sigma_path * sin_beta * sum_251 - rho * sum_240
        sum_253 = 17.0 * path + cos_beta * (3.0 * baseline + product_1)
        sum_254 = cos_beta * sum_253 - 6.0 * baseline
        sum_255 = (14.0 - 17.0 * cos_beta_squared) * path_squared + baseline * sum_254
        sum_256 = baseline * sum_255 - (17.0 - 5.0 * cos_beta_squared) * cos_beta * product_3
        sum_257 = 6.0 * baseline_squared - 2.0 * path_squared
        sum_258 = cos_beta * sum_256 - path * sum_257
        sum_259 = (1.0 + 12.0 * cos_beta_squared) * cos_beta * path_squared_squared + baseline * sum_258
        sum_260 = baseline * sum_259 - 6.0 * cos_beta_squared * product_9
        sum_261 = cos_beta * path_squared_cubed + baseline * sum_260
        sum_262 = 10.0 - (94.0 - 72.0 * cos_beta_squared) * cos_beta_squared
        sum_263 = 196.0 - 21.0 * cos_beta_squared
        sum_264 = 121.0 - cos_beta_squared * sum_263
        sum_265 = 280.0 - 126.0 * cos_beta_squared
        sum_266 = 190.0 - 18.0 * cos_beta_squared
        sum_267 = (24.0 - cos_beta_squared) * baseline - 46.0 * cos_beta * path
        sum_268 = baseline * sum_267 - path_squared * sum_266
        sum_269 = 146.0 * baseline * path + cos_beta * sum_268
        sum_270 = 188.0 * path_squared - 36.0 * baseline_squared + cos_beta * sum_269
        sum_271 = baseline * sum_270 - cos_beta * product_3 * sum_265
        sum_272 = baseline * sum_271 - path_squared_squared * sum_264
        sum_273 = 72.0 * baseline_squared - 74.0 * path_squared
        sum_274 = cos_beta * sum_272 - baseline * path * sum_273
        sum_275 = baseline * sum_274 - product_9 * sum_262
        sum_276 = baseline * sum_275 - (2.0 + 22.0 * cos_beta_squared) * cos_beta * path_squared_cubed
        sum_277 = 8.0 * cos_beta_squared * product_20 + baseline * sum_276
        sum_278 = baseline * sum_277 - cos_beta * term_3
        sum_279 = (
            128.0 * sum_261 * sum_6_squared
            - 192.0 * baseline_squared * sigma_path_squared * sin_beta_squared * sum_200
            - rho * sum_252
            + 16.0 * sigma_beta_squared * sum_278
        )
        sum_280 = 26.0 * path + cos_beta * (11.0 * baseline + product_14)
        sum_281 = cos_beta * sum_280 - 24.0 * baseline
        sum_282 = (11.0 - 14.0 * cos_beta_squared) * path_squared + baseline * sum_281
        sum_283 = baseline * sum_282 - 5.0 * cos_beta * product_3
        sum_284 = baseline + product_7
        sum_285 = 64.0 * sum_284 * sum_6_squared - 32.0 * sigma_beta_squared * sum_283
        sum_286 = 4.0 * path + cos_beta * (4.0 * baseline + product_7)
        sum_287 = cos_beta * sum_286 - 6.0 * baseline
        sum_288 = (4.0 - 4.0 * cos_beta_squared) * path_squared + baseline * sum_287
        sum_289 = product_4 + baseline * sum_288
        sum_290 = sum_285 * sum_6_squared - 16.0 * sigma_beta_squared_squared * sum_289 * sum_65
        sum_291 = path * sum_12_squared * sum_13_squared * sum_290 - sigma_path_squared * sum_279
        sum_292 = 1.0 + (38.0 - 36.0 * sin_beta_squared) * sin_beta_squared
        sum_293 = 14.0 - (52.0 + 32.0 * sin_beta_squared) * sin_beta_squared
        sum_294 = 2.0 + (6.0 + 4.0 * sin_beta_squared) * sin_beta_squared
        sum_295 = 32.0 + (29.0 + 2.0 * sin_beta_squared) * sin_beta_squared
        sum_296 = baseline * sum_295 - (98.0 + 32.0 * sin_beta_squared) * cos_beta * path
        sum_297 = 36.0 - (91.0 + 6.0 * sin_beta_squared) * sin_beta_squared
        sum_298 = path_squared * sum_297 + baseline * sum_296
        sum_299 = 3.0 * baseline + 8.0 * cos_beta * path
        sum_300 = 21.0 * path_squared - baseline * sum_299 + sin_beta_squared * sum_298
        sum_301 = cos_beta * product_24 * sum_294 + path * sum_300
        sum_302 = baseline * sum_301 - cos_beta * path_squared_squared * sum_293
        sum_303 = baseline * sum_302 - product_9 * sum_292
        sum_304 = 4.0 * cos_beta * path_squared_cubed + baseline * sum_303
        sum_305 = baseline * sum_304 - (1.0 - 2.0 * sin_beta_squared) * product_20
        sum_306 = 124.0 - 68.0 * cos_beta_squared
        sum_307 = 143.0 * path + cos_beta * (28.0 * baseline + product_16)
        sum_308 = 19.0 * baseline_squared - path * sum_307
        sum_309 = 104.0 * baseline * path + cos_beta * sum_308
        sum_310 = 167.0 * path_squared - 24.0 * baseline_squared + cos_beta * sum_309
        sum_311 = baseline * sum_310 - cos_beta * product_3 * sum_306
        sum_312 = 2.0 * path_squared + 72.0 * baseline_squared
        sum_313 = cos_beta * sum_311 - path * sum_312
        sum_314 = baseline * sum_313 - (3.0 - 44.0 * cos_beta_squared) * cos_beta * path_squared_squared
        sum_315 = (10.0 - 20.0 * cos_beta_squared) * product_9 + baseline * sum_314
        sum_316 = 32.0 * sum_315 * sum_6_squared - 48.0 * sigma_beta_squared * sum_305
        sum_317 = sin_beta * sum_291 - rho * sigma_beta * sigma_path * sum_12 * sum_13 * sum_316
        sum_318 = rho * sigma_path * sum_194 + sigma_beta * sum_317
        sum_319 = 1.0 - sin_beta_squared_squared
        sum_320 = baseline * cos_beta * sum_319 - path * sum_171
        sum_321 = 6.0 - 4.0 * sin_beta_squared
        sum_322 = cos_beta * path_squared * sum_321 + baseline * sum_320
        sum_323 = baseline * sum_322 - product_3 * sum_171
        sum_324 = (
            384.0 * cos_beta * path_squared_squared
            + 384.0 * baseline * sum_323
            + 576.0 * baseline_squared * cos_beta * sigma_path_squared * sin_beta_squared
        )
        sum_325 = (
            64.0 * cos_beta * sum_53_squared * sum_6_squared_squared
            + baseline_squared * sigma_path_squared * sin_beta_squared * sum_324
        )
        sum_326 = sigma_path_squared * sin_beta * sum_325 + sigma_beta * sum_318
        sum_327 = 3.0 - sin_beta_squared * (2.0 + sin_beta_squared)
        sum_328 = baseline * sum_327 - (14.0 - 6.0 * sin_beta_squared) * cos_beta * path
        sum_329 = 26.0 - (28.0 - 6.0 * sin_beta_squared) * sin_beta_squared
        sum_330 = path_squared * sum_329 + baseline * sum_328
        sum_331 = baseline * sum_330 - (24.0 - 14.0 * sin_beta_squared) * cos_beta * product_3
        sum_332 = (11.0 - 10.0 * sin_beta_squared) * path_squared_squared + baseline * sum_331
        sum_333 = (
            3456.0 * baseline_squared * sigma_path_squared * sin_beta_squared * sum_284
            - 1536.0 * cos_beta * product_9
            + 768.0 * baseline * sum_332
        )
        sum_334 = (
            128.0 * sum_12 * sum_13 * sum_284 * sum_53 * sum_6_squared_squared
            + baseline_squared * sigma_path_squared * sin_beta_squared * sum_333
        )
        sum_335 = 31.0 * path + cos_beta * (22.0 * baseline + product_14)
        sum_336 = 20.0 * baseline_squared - path * sum_335
        sum_337 = cos_beta * sum_336 + product_13
        sum_338 = 20.0 * path_squared - 24.0 * baseline_squared + cos_beta * sum_337
        sum_339 = baseline * sum_338 - (16.0 - 14.0 * cos_beta_squared) * cos_beta * product_3
        sum_340 = baseline * sum_339 - (3.0 - 5.0 * cos_beta_squared) * path_squared_squared
        sum_341 = 64.0 * sum_284**2 * sum_6_squared - 32.0 * sigma_beta_squared * sum_340
        sum_342 = 16.0 * sigma_beta_squared_squared * sum_289**2 + sum_341 * sum_6_squared
        product_28 = 4.0 * cos_beta * product_3
        sum_343 = baseline * (8.0 + sin_beta_squared) + product_25
        sum_344 = (3.0 - 6.0 * sin_beta_squared) * path_squared + baseline * sum_343
        sum_345 = product_28 + baseline * sum_344
        sum_346 = baseline * sum_345 - path_squared_squared
        sum_347 = (27.0 + 9.0 * sin_beta_squared) * baseline - (68.0 + 6.0 * sin_beta_squared) * cos_beta * path
        sum_348 = (38.0 - 63.0 * sin_beta_squared) * path_squared + baseline * sum_347
        sum_349 = (24.0 + 16.0 * sin_beta_squared) * cos_beta * product_3 + baseline * sum_348
        sum_350 = baseline * sum_349 - path_squared_squared * sum_201
        sum_351 = 4.0 * cos_beta * product_9 + baseline * sum_350
        sum_352 = baseline * (17.0 + sin_beta_squared) - 32.0 * cos_beta * path
        sum_353 = (12.0 - 15.0 * sin_beta_squared) * path_squared + baseline * sum_352
        sum_354 = product_28 + baseline * sum_353
        sum_355 = baseline * sum_354 - path_squared_squared
        sum_356 = baseline * sum_196 - cos_beta * path * (13.0 + sin_beta_squared)
        sum_357 = path_squared * sum_195 + baseline * sum_356
        sum_358 = cos_beta * product_3 * sum_73 + baseline * sum_357
        sum_359 = baseline * sum_358 - (5.0 - 4.0 * sin_beta_squared) * path_squared_squared
        sum_360 = cos_beta * product_9 + baseline * sum_359
        sum_361 = 384.0 * sigma_path * sin_beta * sum_355 + 768.0 * rho * sigma_beta * sum_360
        sum_362 = 192.0 * sigma_beta * sum_351 + rho * sum_361
        sum_363 = 192.0 * sigma_path * sin_beta * sum_346 + rho * sum_362
        product_29 = -8.0 * cos_beta * product_20
        sum_364 = 86.0 - (83.0 + 12.0 * sin_beta_squared) * sin_beta_squared
        sum_365 = 31.0 + sin_beta_squared * (22.0 + sin_beta_squared)
        sum_366 = baseline * sum_365 - (95.0 + 31.0 * sin_beta_squared) * cos_beta * path
        sum_367 = 67.0 - (124.0 + 9.0 * sin_beta_squared) * sin_beta_squared
        sum_368 = path_squared * sum_367 + baseline * sum_366
        sum_369 = (58.0 + 83.0 * sin_beta_squared) * cos_beta * product_3 + baseline * sum_368
        sum_370 = baseline * sum_369 - path_squared_squared * sum_364
        sum_371 = (13.0 - 36.0 * sin_beta_squared) * cos_beta * product_9 + baseline * sum_370
        sum_372 = (19.0 - 13.0 * sin_beta_squared) * path_squared_cubed + baseline * sum_371
        sum_373 = product_29 + baseline * sum_372
        sum_374 = 146.0 + 21.0 * sin_beta_squared
        sum_375 = 122.0 - sin_beta_squared * sum_374
        sum_376 = 140.0 + 76.0 * sin_beta_squared
        sum_377 = 49.0 + sin_beta_squared * (58.0 + sin_beta_squared)
        sum_378 = baseline * sum_377 - cos_beta * path * sum_376
        sum_379 = 214.0 + 18.0 * sin_beta_squared
        sum_380 = 76.0 - sin_beta_squared * sum_379
        sum_381 = path_squared * sum_380 + baseline * sum_378
        sum_382 = 112.0 + 164.0 * sin_beta_squared
        sum_383 = cos_beta * product_3 * sum_382 + baseline * sum_381
        sum_384 = baseline * sum_383 - path_squared_squared * sum_375
        sum_385 = (4.0 - 72.0 * sin_beta_squared) * cos_beta * product_9 + baseline * sum_384
        sum_386 = (28.0 - 22.0 * sin_beta_squared) * path_squared_cubed + baseline * sum_385
        sum_387 = product_29 + baseline * sum_386
        sum_388 = 128.0 * rho_squared * (baseline * sum_373 + term_3) + 16.0 * baseline * sum_387 + 16.0 * term_3
        sum_389 = baseline_squared * sigma_path * sin_beta * sum_363 + sigma_beta_squared * sum_388
        sum_390 = 48.0 * path + cos_beta * (10.0 * baseline + product_23)
        sum_391 = cos_beta * sum_390 - 33.0 * baseline
        sum_392 = (72.0 - 42.0 * cos_beta_squared) * path_squared + baseline * sum_391
        sum_393 = baseline * sum_392 - (44.0 - 10.0 * cos_beta_squared) * cos_beta * product_3
        sum_394 = 48.0 * baseline_squared - 14.0 * path_squared
        sum_395 = cos_beta * sum_393 - path * sum_394
        sum_396 = 24.0 * baseline_squared - 15.0 * path_squared
        sum_397 = cos_beta * sum_395 + baseline * sum_396
        sum_398 = baseline * sum_397 - (9.0 - 24.0 * cos_beta_squared) * cos_beta_squared * path_squared_squared
        sum_399 = cos_beta * product_9 * sum_105 + baseline * sum_398
        sum_400 = 6.0 - (12.0 + 69.0 * cos_beta_squared) * cos_beta_squared
        sum_401 = 124.0 - 14.0 * cos_beta_squared
        sum_402 = 102.0 * path + cos_beta * (11.0 * baseline + product_23)
        sum_403 = cos_beta * sum_402 - 54.0 * baseline
        sum_404 = 171.0 - 84.0 * cos_beta_squared
        sum_405 = path_squared * sum_404 + baseline * sum_403
        sum_406 = baseline * sum_405 - cos_beta * product_3 * sum_401
        sum_407 = 126.0 * baseline_squared - 10.0 * path_squared
        sum_408 = cos_beta * sum_406 - path * sum_407
        sum_409 = 48.0 * baseline_squared - 12.0 * path_squared
        sum_410 = cos_beta * sum_408 + baseline * sum_409
        sum_411 = baseline * sum_410 - path_squared_squared * sum_400
        sum_412 = (12.0 - 42.0 * cos_beta_squared) * cos_beta * product_9 + baseline * sum_411
        sum_413 = baseline * sum_412 - (2.0 - 7.0 * cos_beta_squared) * path_squared_cubed
        sum_414 = 64.0 * rho_squared * sum_413 - 64.0 * path_squared_cubed * sum_57 + 64.0 * baseline * sum_399
        sum_415 = sin_beta_squared * sum_389 + sum_414 * sum_6_squared
        sum_416 = 101.0 * path + cos_beta * (18.0 * baseline + product_12)
        sum_417 = 19.0 * baseline_squared - path * sum_416
        sum_418 = 106.0 * baseline * path + cos_beta * sum_417
        sum_419 = 19.0 * path_squared - 48.0 * baseline_squared + cos_beta * sum_418
        sum_420 = baseline * sum_419 - (32.0 - 34.0 * cos_beta_squared) * cos_beta * product_3
        sum_421 = (7.0 + 22.0 * cos_beta_squared) * path_squared_squared + baseline * sum_420
        sum_422 = baseline * sum_421 - 10.0 * cos_beta * product_9
        sum_423 = product_11 - 8.0 * cos_beta * path
        sum_424 = baseline * sum_423 - (3.0 - 3.0 * cos_beta_squared) * path_squared
        sum_425 = product_28 + baseline * sum_424
        sum_426 = baseline * sum_425 - path_squared_squared
        sum_427 = 64.0 * sum_422 * sum_6_squared + 96.0 * sigma_beta_squared * sum_289 * sum_426
        sum_428 = rho * sigma_beta * sin_beta * sum_12 * sum_13 * sum_427 - sigma_path * sum_415
        sum_429 = sum_12_squared * sum_13_squared * sum_342 - sigma_path * sum_428
        sum_430 = rho * sigma_path * sin_beta * sum_334 + sigma_beta * sum_429
        sum_431 = 56.0 - (72.0 - 20.0 * sin_beta_squared) * sin_beta_squared
        sum_432 = 54.0 - (30.0 - 4.0 * sin_beta_squared) * sin_beta_squared
        sum_433 = (12.0 - 4.0 * sin_beta_squared) * baseline * cos_beta - path * sum_432
        sum_434 = 28.0 * path - 8.0 * baseline * cos_beta + sin_beta_squared * sum_433
        sum_435 = baseline_squared * sum_172 + path * sum_434
        sum_436 = baseline * sum_435 - cos_beta * product_3 * sum_431
        sum_437 = 110.0 - 41.0 * sin_beta_squared
        sum_438 = 70.0 - sin_beta_squared * sum_437
        sum_439 = path_squared_squared * sum_438 + baseline * sum_436
        sum_440 = baseline * sum_439 - (56.0 - 44.0 * sin_beta_squared) * cos_beta * product_9
        sum_441 = (28.0 - 26.0 * sin_beta_squared) * path_squared_cubed + baseline * sum_440
        sum_442 = product_29 + baseline * sum_441
        sum_443 = product_16 + baseline * sum_319
        sum_444 = path_squared * sum_321 + baseline * sum_443
        sum_445 = product_26 + baseline * sum_444
        sum_446 = (
            384.0 * path_squared_squared
            + 384.0 * baseline * sum_445
            + 576.0 * baseline_squared * sigma_path_squared * sin_beta_squared
        )
        sum_447 = (
            64.0 * baseline * sum_442
            + 64.0 * term_3
            + baseline_squared * sigma_path_squared * sin_beta_squared * sum_446
        )
        sum_448 = sigma_path_squared * sin_beta_squared * sum_447 + sigma_beta * sum_430
        mean[i, 0] = -sum_26 * term_1
        mean[i, 1] = -sum_51 * term_1
        covariance[i, 0, 0] = sum_183 * term_2
        covariance[i, 0, 1] = sum_326 * term_2
        covariance[i, 1, 0] = covariance[i, 0, 1]
        covariance[i, 1, 1] = sum_448 * term_2


def bistatic_posterior(
    all_path: Floats,
    all_beta: Floats,
    all_baseline: Floats,
    all_sigma_path: Floats,
    all_sigma_beta: Floats,
    all_rho: Floats,
    mean: Filled,
    covariance: Filled,
) -> None:
    """Conversion bistatic, posterior.

    Mean: posterior mean of the position under a flat prior, to fourth order. Covariance: posterior covariance
    of the position under a flat prior, to fourth order, completed to a sum of squares.
    """
    for i in range(len(all_path)):
        path = all_path[i]
        beta = all_beta[i]
        baseline = all_baseline[i]
        sigma_path = all_sigma_path[i]
        sigma_beta = all_sigma_beta[i]
        rho = all_rho[i]
        cos_beta = math.cos(beta)
        divisor_1 = 2.0 * path - 2.0 * baseline * cos_beta
        product_1 = baseline * cos_beta
        sum_1 = product_1 - path
        sum_1_squared = sum_1**2
        sum_1_squared_squared = sum_1_squared**2
        sum_2 = baseline + path
        sum_3 = baseline - path
        sin_beta = math.sin(beta)
        sin_beta_squared = sin_beta**2
        sum_4 = 2.0 - 2.0 * sin_beta_squared
        sum_5 = 1.0 - sin_beta_squared
        sum_6 = baseline * cos_beta * sum_5 - path * sum_4
        path_squared = path**2
        sigma_path_squared = sigma_path**2
        baseline_squared = baseline**2
        sum_7 = 16.0 * cos_beta * path_squared + 16.0 * baseline * sum_6 + 48.0 * cos_beta * sigma_path_squared
        sum_8 = baseline * (path + product_1) - 3.0 * cos_beta * path_squared
        product_2 = path * path_squared
        product_3 = -3.0 * cos_beta * path
        cos_beta_squared = cos_beta**2
        sum_9 = (3.0 - cos_beta_squared) * baseline + product_3
        sum_10 = (
            16.0 * (product_2 + baseline * sum_8) * sum_1_squared
            + 48.0 * baseline_squared * (cos_beta * sum_9 + path) * sigma_path_squared
        )
        product_4 = path * path_squared**2
        path_squared_squared = path_squared**2
        product_5 = -11.0 * cos_beta * path
        product_6 = (6.0 - cos_beta_squared) * baseline
        sum_11 = baseline * (product_5 + product_6) - (29.0 - 3.0 * cos_beta_squared) * path_squared
        sum_12 = 18.0 * baseline * path + cos_beta * sum_11
        sum_13 = baseline * sum_12 - (7.0 - 17.0 * cos_beta_squared) * product_2
        sum_14 = 5.0 * cos_beta * path_squared_squared + baseline * sum_13
        sum_15 = 13.0 * path + cos_beta * (4.0 * baseline + product_3)
        sum_16 = cos_beta * sum_15 - 6.0 * baseline
        sum_17 = (7.0 - 9.0 * cos_beta_squared) * path_squared + baseline * sum_16
        rho_squared = rho**2
        sum_18 = cos_beta * sum_17 - 6.0 * baseline * path
        sum_19 = (
            (8.0 + 16.0 * rho_squared) * baseline_squared * sigma_path * sum_18
            - 8.0 * (baseline * sum_14 - product_4) * rho * sigma_beta * sin_beta
        )
        product_7 = -cos_beta * product_2
        product_8 = (20.0 - cos_beta_squared) * baseline
        sum_20 = 20.0 * path + cos_beta * (product_5 + product_8)
        sum_21 = cos_beta * sum_20 - 24.0 * baseline
        sum_22 = (8.0 - 11.0 * cos_beta_squared) * path_squared + baseline * sum_21
        sigma_beta_squared = sigma_beta**2
        product_9 = -cos_beta * path
        product_10 = (2.0 - cos_beta_squared) * baseline
        sum_23 = (
            8.0 * (product_10 + product_9) * sum_1_squared
            - 2.0 * (product_7 + baseline * sum_22) * sigma_beta_squared
        )
        sum_24 = path * sum_2 * sum_23 * sum_3 - sigma_path * sum_19
        sum_25 = rho * sigma_path * sin_beta * sum_10 + sigma_beta * sum_24
        term_1 = 1.0 / (divisor_1 * (divisor_1**2)**2)
        sum_26 = (
            16.0 * cos_beta * sum_1_squared_squared * sum_2 * sum_3
            + baseline_squared * sigma_path_squared * sin_beta_squared * sum_7
            + sigma_beta * sum_25
        )
        sum_27 = 2.0 * baseline + product_9
        sum_28 = baseline * sum_27 - path_squared
        sum_29 = 16.0 * sum_1_squared + 8.0 * sigma_beta_squared * sum_28
        sum_30 = 20.0 * path + cos_beta * (8.0 * baseline + product_9)
        sum_31 = cos_beta * sum_30 - 24.0 * baseline
        sum_32 = (20.0 - 11.0 * cos_beta_squared) * path_squared + baseline * sum_31
        sum_33 = baseline * sum_32 - 11.0 * cos_beta * product_2
        sigma_beta_squared_squared = sigma_beta_squared**2
        sum_34 = baseline * sum_33 - path_squared_squared
        sum_35 = sum_1_squared * sum_29 - 2.0 * sigma_beta_squared_squared * sum_34
        product_11 = -2.0 * cos_beta * path
        sum_36 = (
            16.0 * baseline * (product_11 + baseline * sum_5)
            + 16.0 * path_squared
            + 48.0 * sigma_path_squared
        )
        sum_37 = cos_beta * (5.0 * path + cos_beta * sum_27) - 4.0 * baseline
        sum_38 = 1.0 - 3.0 * cos_beta_squared
        sum_39 = path_squared * sum_38 + baseline * sum_37
        sum_40 = baseline * (3.0 + sin_beta_squared) + product_3
        sum_41 = 48.0 * rho * sigma_path * sin_beta * sum_40 - (24.0 + 48.0 * rho_squared) * sigma_beta * sum_39
        sum_42 = sin_beta_squared * sum_36 + sigma_beta * sum_41
        sum_43 = baseline_squared * sigma_path_squared * sum_42 + sum_2 * sum_3 * sum_35
        sum_44 = product_8 - 19.0 * cos_beta * path
        sum_45 = baseline * sum_44 - (31.0 - 3.0 * cos_beta_squared) * path_squared
        sum_46 = 32.0 * baseline * path + cos_beta * sum_45
        sum_47 = 20.0 * path_squared - 24.0 * baseline_squared + cos_beta * sum_46
        sum_48 = baseline * sum_47 - (21.0 - 17.0 * cos_beta_squared) * cos_beta * product_2
        sum_49 = 5.0 * cos_beta_squared * path_squared_squared + baseline * sum_48
        sum_50 = baseline * sum_49 - cos_beta * product_4
        sum_51 = 3.0 * cos_beta_squared * path_squared + baseline * (product_10 + product_3)
        sum_52 = 16.0 * (product_7 + baseline * sum_51) * sum_1_squared - 8.0 * sigma_beta_squared * sum_50
        sum_53 = sin_beta * sum_43 + rho * sigma_beta * sigma_path * sum_52
        term_2 = 1.0 / ((divisor_1**2)**2)**2
        sum_54 = baseline + product_11
        sum_55 = path_squared + baseline * sum_54
        sum_56 = baseline * sum_4 - (2.0 - 3.0 * sin_beta_squared) * cos_beta * path
        product_12 = (4.0 - cos_beta_squared) * baseline
        sum_57 = product_12 - 13.0 * cos_beta * path
        sum_58 = baseline * sum_57 - (3.0 - 12.0 * cos_beta_squared) * path_squared
        product_13 = 4.0 * baseline * path
        sum_59 = baseline * (cos_beta * sum_58 + product_13) + (1.0 - 4.0 * cos_beta_squared) * product_2
        sum_60 = (
            1152.0 * baseline_squared * sigma_path_squared * sin_beta_squared * sum_56
            + 256.0 * cos_beta * sum_1_squared * sum_59
        )
        sum_61 = (
            128.0 * cos_beta * path * sum_1_squared_squared * sum_2 * sum_3 * sum_55
            + baseline_squared * sigma_path_squared * sum_60
        )
        product_14 = -cos_beta * path_squared_squared
        product_15 = -4.0 * cos_beta * path
        sum_62 = baseline * (product_10 + product_15) - (7.0 - 3.0 * cos_beta_squared) * path_squared
        sum_63 = 4.0 * cos_beta_squared * product_2 + baseline * (cos_beta * sum_62 + product_13)
        sum_64 = product_14 + baseline * sum_63
        sum_65 = baseline * (product_15 + product_6) - path_squared
        sum_66 = 16.0 * path + cos_beta * (3.0 * baseline + product_9)
        sum_67 = cos_beta * sum_66 - 8.0 * baseline
        sum_68 = (15.0 - 11.0 * cos_beta_squared) * path_squared + baseline * sum_67
        sum_69 = cos_beta * sum_68 - 8.0 * baseline * path
        sum_70 = baseline * sum_69 - (2.0 + 7.0 * cos_beta_squared) * product_2
        sum_71 = 3.0 * cos_beta * path_squared_squared + baseline * sum_70
        sum_72 = 128.0 * sum_1_squared * sum_71 - 96.0 * sigma_beta_squared * sum_64 * sum_65
        product_16 = -(3.0 - 3.0 * sin_beta_squared) * path_squared_squared
        sum_73 = 8.0 + (9.0 - 18.0 * sin_beta_squared) * sin_beta_squared
        sum_74 = 4.0 + 3.0 * sin_beta_squared
        sum_75 = 7.0 - sin_beta_squared * sum_74
        sum_76 = baseline * sum_75 - (8.0 - 24.0 * sin_beta_squared) * cos_beta * path
        sum_77 = baseline * sum_76 - path_squared * sum_73
        sum_78 = 12.0 - 12.0 * sin_beta_squared
        product_17 = cos_beta * product_2 * sum_78
        sum_79 = baseline * (product_17 + baseline * sum_77) + product_16
        term_3 = (path_squared**2)**2
        product_18 = -cos_beta_squared * term_3
        product_19 = path * path_squared * path_squared**2
        product_20 = 8.0 * cos_beta * cos_beta_squared * product_19
        path_squared_cubed = path_squared * path_squared**2
        sum_80 = 4.0 - (2.0 - 22.0 * cos_beta_squared) * cos_beta_squared
        sum_81 = 120.0 - 72.0 * cos_beta_squared
        sum_82 = 16.0 - cos_beta_squared * sum_81
        sum_83 = 204.0 - 21.0 * cos_beta_squared
        sum_84 = 225.0 - cos_beta_squared * sum_83
        sum_85 = 224.0 - 88.0 * cos_beta_squared
        sum_86 = 162.0 - 18.0 * cos_beta_squared
        sum_87 = product_12 - 16.0 * cos_beta * path
        sum_88 = baseline * sum_87 - path_squared * sum_86
        sum_89 = 80.0 * baseline * path + cos_beta * sum_88
        sum_90 = 192.0 * path_squared - 4.0 * baseline_squared + cos_beta * sum_89
        sum_91 = baseline * sum_90 - cos_beta * product_2 * sum_85
        sum_92 = baseline * sum_91 - path_squared_squared * sum_84
        sum_93 = 64.0 * baseline_squared - 128.0 * path_squared
        sum_94 = cos_beta * sum_92 - baseline * path * sum_93
        sum_95 = baseline * sum_94 - product_4 * sum_82
        sum_96 = 40.0 * baseline_squared - 28.0 * path_squared
        sum_97 = cos_beta * sum_95 - baseline * path_squared * sum_96
        sum_98 = baseline * sum_97 - path_squared_cubed * sum_80
        sum_99 = baseline * (product_20 + baseline * sum_98) + product_18
        sum_100 = 1.0 - 2.0 * cos_beta_squared
        product_21 = cos_beta * (2.0 * baseline + product_11)
        sum_101 = cos_beta * (14.0 * path + product_21) - 3.0 * baseline
        sum_102 = 28.0 - 22.0 * cos_beta_squared
        sum_103 = path_squared * sum_102 + baseline * sum_101
        sum_104 = baseline * sum_103 - (22.0 - 6.0 * cos_beta_squared) * cos_beta * product_2
        sum_105 = 10.0 * baseline_squared - 4.0 * path_squared
        sum_106 = cos_beta * sum_104 - path * sum_105
        sum_107 = baseline * sum_106 - (7.0 - 20.0 * cos_beta_squared) * cos_beta * path_squared_squared
        sum_108 = 6.0 - 12.0 * cos_beta_squared
        product_22 = product_4 * sum_108
        sum_109 = product_22 + baseline * sum_107
        product_23 = baseline * baseline_squared
        sum_110 = cos_beta * sum_109 - 3.0 * path_squared * product_23
        sum_111 = baseline * sum_110 - path_squared_cubed * sum_100
        sum_112 = 5.0 * baseline - 9.0 * cos_beta * path
        sum_113 = 48.0 * path + cos_beta * sum_112
        sum_114 = cos_beta * sum_113 - 10.0 * baseline
        sum_115 = (81.0 - 51.0 * cos_beta_squared) * path_squared + baseline * sum_114
        sum_116 = baseline * sum_115 - (92.0 - 24.0 * cos_beta_squared) * cos_beta * product_2
        sum_117 = 34.0 * baseline_squared - 28.0 * path_squared
        sum_118 = cos_beta * sum_116 - path * sum_117
        sum_119 = baseline * sum_118 - (11.0 - 36.0 * cos_beta_squared) * cos_beta * path_squared_squared
        sum_120 = (1.0 - 6.0 * cos_beta_squared) * product_4 + baseline * sum_119
        sum_121 = cos_beta * sum_120 - 10.0 * path_squared * product_23
        sum_122 = 19.0 - (16.0 + 3.0 * sin_beta_squared) * sin_beta_squared
        sum_123 = baseline * sum_122 - (32.0 - 60.0 * sin_beta_squared) * cos_beta * path
        sum_124 = 4.0 - (45.0 - 45.0 * sin_beta_squared) * sin_beta_squared
        sum_125 = path_squared * sum_124 + baseline * sum_123
        sum_126 = product_17 + baseline * sum_125
        sum_127 = product_16 + baseline * sum_126
        sum_128 = cos_beta * (2.0 * baseline + product_3) + path
        sum_129 = 128.0 * sigma_path * sin_beta * sum_127 + 256.0 * rho * sigma_beta * sum_128 * sum_64
        sum_130 = 1.0 + (10.0 + 13.0 * cos_beta_squared) * cos_beta_squared
        sum_131 = 105.0 - 12.0 * cos_beta_squared
        sum_132 = 114.0 - cos_beta_squared * sum_131
        sum_133 = 128.0 - 46.0 * cos_beta_squared
        product_24 = -10.0 * cos_beta * path
        sum_134 = baseline * (product_12 + product_24) - (72.0 - 9.0 * cos_beta_squared) * path_squared
        sum_135 = 38.0 * baseline * path + cos_beta * sum_134
        sum_136 = 93.0 * path_squared - 4.0 * baseline_squared + cos_beta * sum_135
        sum_137 = baseline * sum_136 - cos_beta * product_2 * sum_133
        sum_138 = baseline * sum_137 - path_squared_squared * sum_132
        sum_139 = 28.0 * baseline_squared - 74.0 * path_squared
        sum_140 = cos_beta * sum_138 - baseline * path * sum_139
        sum_141 = 2.0 + (66.0 - 36.0 * cos_beta_squared) * cos_beta_squared
        sum_142 = product_4 * sum_141 + baseline * sum_140
        sum_143 = 22.0 * baseline_squared - 7.0 * path_squared
        sum_144 = cos_beta * sum_142 - baseline * path_squared * sum_143
        sum_145 = baseline * sum_144 - path_squared_cubed * sum_130
        sum_146 = product_20 + baseline * sum_145
        sum_147 = product_18 + baseline * sum_146
        product_25 = -(46.0 - 14.0 * cos_beta_squared) * cos_beta * product_2
        product_26 = -6.0 * cos_beta * path
        sum_148 = 32.0 * path + cos_beta * (3.0 * baseline + product_26)
        sum_149 = cos_beta * sum_148 - 5.0 * baseline
        sum_150 = (51.0 - 40.0 * cos_beta_squared) * path_squared + baseline * sum_149
        sum_151 = product_25 + baseline * sum_150
        sum_152 = 22.0 * baseline_squared - 8.0 * path_squared
        sum_153 = cos_beta * sum_151 - path * sum_152
        sum_154 = baseline * sum_153 - (9.0 - 33.0 * cos_beta_squared) * cos_beta * path_squared_squared
        sum_155 = 5.0 * baseline_squared - 2.0 * path_squared
        sum_156 = cos_beta * sum_154 - path_squared * sum_155
        sum_157 = (6.0 - 18.0 * cos_beta_squared) * cos_beta * product_4 + baseline * sum_156
        sum_158 = baseline * sum_157 - path_squared_cubed * sum_38
        sum_159 = (
            128.0 * sigma_beta_squared * sum_147
            - baseline_squared * sigma_path * sin_beta * sum_129
            + 64.0 * sum_158 * sum_1_squared
        )
        sum_160 = 128.0 * baseline_squared * sigma_beta * sigma_path * sin_beta * sum_121 + rho * sum_159
        sum_161 = (
            16.0 * sigma_beta_squared * sum_99
            - 64.0 * baseline_squared * sigma_path_squared * sin_beta_squared * sum_79
            + 64.0 * sum_111 * sum_1_squared
            + rho * sum_160
        )
        sum_162 = path * rho * sigma_beta * sin_beta * sum_2 * sum_3 * sum_72 + sigma_path * sum_161
        sum_2_squared = sum_2**2
        sum_3_squared = sum_3**2
        sum_163 = 25.0 + sin_beta_squared * (10.0 + sin_beta_squared)
        sum_164 = baseline * sum_163 - (40.0 + 8.0 * sin_beta_squared) * cos_beta * path
        sum_165 = (6.0 - 18.0 * sin_beta_squared) * path_squared + baseline * sum_164
        sum_166 = 8.0 * cos_beta * product_2 + baseline * sum_165
        sum_167 = path_squared_squared + baseline * sum_166
        sum_168 = (18.0 - 3.0 * cos_beta_squared) * baseline + product_24
        sum_169 = 12.0 * path + cos_beta * sum_168
        sum_170 = cos_beta * sum_169 - 16.0 * baseline
        sum_171 = 2.0 - 3.0 * cos_beta_squared
        sum_172 = path_squared * sum_171 + baseline * sum_170
        sum_173 = 32.0 * sum_172 * sum_1_squared - 16.0 * sigma_beta_squared * sin_beta_squared * sum_167
        sum_174 = 4.0 - 4.0 * sin_beta_squared
        sum_175 = 1.0 - (2.0 - sin_beta_squared) * sin_beta_squared
        sum_176 = baseline * sum_175 - cos_beta * path * sum_174
        sum_177 = (6.0 - 6.0 * sin_beta_squared) * path_squared + baseline * sum_176
        sum_178 = baseline * sum_177 - 4.0 * cos_beta * product_2
        sum_179 = path_squared_squared + baseline * sum_178
        sum_180 = 64.0 * sin_beta_squared * sum_179 - sigma_beta_squared * sum_173
        sum_181 = path_squared * sum_180 * sum_2_squared * sum_3_squared - sigma_path * sum_162
        sum_182 = rho * sigma_path * sin_beta * sum_61 + sigma_beta * sum_181
        sum_55_squared = sum_55**2
        sum_183 = 3.0 * path_squared + baseline * (product_12 + product_26)
        sum_184 = (
            128.0 * (1.0 - cos_beta) * (1.0 + cos_beta) * cos_beta_squared * sum_183 * sum_1_squared
            + 576.0 * (1.0 - sin_beta) * baseline_squared * sigma_path_squared * (1.0 + sin_beta) * sin_beta_squared**2
        )
        sum_185 = (
            64.0 * cos_beta_squared * sum_1_squared_squared * sum_55_squared
            + baseline_squared * sigma_path_squared * sum_184
        )
        sum_186 = sigma_path_squared * sum_185 + sigma_beta * sum_182
        sum_187 = 5.0 - 6.0 * sin_beta_squared
        sum_188 = 5.0 * baseline * cos_beta - path * sum_187
        sum_189 = 108.0 - 24.0 * sin_beta_squared
        sum_190 = 88.0 - sin_beta_squared * sum_189
        sum_191 = (8.0 + 2.0 * sin_beta_squared) * baseline * cos_beta - (74.0 - 27.0 * sin_beta_squared) * path
        sum_192 = 47.0 * path - 10.0 * baseline * cos_beta + sin_beta_squared * sum_191
        sum_193 = baseline * sum_192 - cos_beta * path_squared * sum_190
        sum_194 = 142.0 - 56.0 * sin_beta_squared
        sum_195 = 82.0 - sin_beta_squared * sum_194
        sum_196 = product_2 * sum_195 + baseline * sum_193
        sum_197 = baseline * sum_196 - (38.0 - 40.0 * sin_beta_squared) * cos_beta * path_squared_squared
        sum_198 = (
            128.0 * (7.0 - 8.0 * sin_beta_squared) * product_4
            - 576.0 * baseline_squared * sigma_path_squared * sin_beta_squared * sum_188
            + 128.0 * baseline * sum_197
        )
        sum_199 = (
            64.0 * (cos_beta * sum_54 + path) * sum_1_squared_squared * sum_2 * sum_3 * sum_55
            - baseline_squared * sigma_path_squared * sin_beta_squared * sum_198
        )
        sum_200 = 8.0 - 11.0 * sin_beta_squared
        sum_201 = 5.0 + sin_beta_squared
        sum_202 = baseline * cos_beta * sum_201 - path * sum_200
        sum_203 = baseline * sum_202 - 6.0 * cos_beta * path_squared * sin_beta_squared
        product_27 = product_2 * sum_174
        sum_204 = product_27 + baseline * sum_203
        sum_205 = product_14 + baseline * sum_204
        sum_206 = 25.0 - 24.0 * sin_beta_squared
        sum_207 = 32.0 - (17.0 + 18.0 * sin_beta_squared) * sin_beta_squared
        sum_208 = 29.0 - (41.0 + 6.0 * sin_beta_squared) * sin_beta_squared
        sum_209 = baseline * sum_208 - (4.0 - 51.0 * sin_beta_squared) * cos_beta * path
        sum_210 = baseline * sum_209 - path_squared * sum_207
        sum_211 = (13.0 + 5.0 * sin_beta_squared) * cos_beta * product_23 - path * sum_210
        sum_212 = baseline * sum_211 - cos_beta * path_squared_squared * sum_206
        sum_213 = product_4 * sum_187 + baseline * sum_212
        sum_214 = baseline * cos_beta * (11.0 + sin_beta_squared) - (20.0 - 26.0 * sin_beta_squared) * path
        sum_215 = (6.0 - 15.0 * sin_beta_squared) * cos_beta * path_squared + baseline * sum_214
        sum_216 = product_27 + baseline * sum_215
        sum_217 = product_14 + baseline * sum_216
        sum_218 = 128.0 * rho * sigma_beta * sum_213 + 384.0 * sigma_path * sin_beta * sum_217
        sum_219 = 52.0 * path + cos_beta * (5.0 * baseline + product_26)
        sum_220 = cos_beta * sum_219 - 16.0 * baseline
        sum_221 = (35.0 - 50.0 * cos_beta_squared) * path_squared + baseline * sum_220
        sum_222 = product_25 + baseline * sum_221
        sum_223 = 16.0 * baseline_squared - 4.0 * path_squared
        sum_224 = cos_beta * sum_222 - path * sum_223
        sum_225 = (6.0 + 33.0 * cos_beta_squared) * cos_beta * path_squared_squared + baseline * sum_224
        sum_226 = baseline * sum_225 - 18.0 * cos_beta_squared * product_4
        sum_227 = 3.0 * cos_beta * path_squared_cubed + baseline * sum_226
        sum_228 = 212.0 - 24.0 * cos_beta_squared
        sum_229 = 104.0 - cos_beta_squared * sum_228
        sum_230 = 308.0 - 129.0 * cos_beta_squared
        sum_231 = 194.0 - 18.0 * cos_beta_squared
        sum_232 = (24.0 - 2.0 * cos_beta_squared) * baseline - 41.0 * cos_beta * path
        sum_233 = baseline * sum_232 - path_squared * sum_231
        sum_234 = 139.0 * baseline * path + cos_beta * sum_233
        sum_235 = 214.0 * path_squared - 36.0 * baseline_squared + cos_beta * sum_234
        sum_236 = baseline * sum_235 - cos_beta * product_2 * sum_230
        sum_237 = baseline * sum_236 - path_squared_squared * sum_229
        sum_238 = 72.0 * baseline_squared - 55.0 * path_squared
        sum_239 = cos_beta * sum_237 - baseline * path * sum_238
        sum_240 = 1.0 + (89.0 - 72.0 * cos_beta_squared) * cos_beta_squared
        sum_241 = product_4 * sum_240 + baseline * sum_239
        sum_242 = baseline * sum_241 - (16.0 + 26.0 * cos_beta_squared) * cos_beta * path_squared_cubed
        sum_243 = 16.0 * cos_beta_squared * product_19 + baseline * sum_242
        sum_244 = baseline * sum_243 - 2.0 * cos_beta * term_3
        sum_245 = (
            64.0 * sigma_beta_squared * sum_244
            - baseline_squared * sigma_path * sin_beta * sum_218
            + 64.0 * sum_1_squared * sum_227
        )
        sum_246 = 125.0 - 144.0 * sin_beta_squared
        sum_247 = 112.0 + 96.0 * sin_beta_squared
        sum_248 = 172.0 - sin_beta_squared * sum_247
        sum_249 = 14.0 - 291.0 * sin_beta_squared
        sum_250 = 226.0 + 36.0 * sin_beta_squared
        sum_251 = 154.0 - sin_beta_squared * sum_250
        sum_252 = baseline * sum_251 - cos_beta * path * sum_249
        sum_253 = baseline * sum_252 - path_squared * sum_248
        sum_254 = (71.0 + 37.0 * sin_beta_squared) * cos_beta * product_23 - path * sum_253
        sum_255 = baseline * sum_254 - cos_beta * path_squared_squared * sum_246
        sum_256 = (22.0 - 24.0 * sin_beta_squared) * product_4 + baseline * sum_255
        sum_257 = 32.0 * baseline_squared * sigma_beta * sigma_path * sin_beta * sum_256 - rho * sum_245
        sum_258 = baseline + product_9
        sum_259 = 13.0 * path + cos_beta * sum_258
        sum_260 = cos_beta * sum_259 - 4.0 * baseline
        sum_261 = (10.0 - 13.0 * cos_beta_squared) * path_squared + baseline * sum_260
        sum_262 = baseline * sum_261 - (13.0 - 3.0 * cos_beta_squared) * cos_beta * product_2
        sum_263 = (3.0 + 10.0 * cos_beta_squared) * path_squared_squared + baseline * sum_262
        sum_264 = cos_beta * sum_263 - 4.0 * path * product_23
        sum_265 = baseline * sum_264 - 6.0 * cos_beta_squared * product_4
        sum_266 = cos_beta * path_squared_cubed + baseline * sum_265
        sum_267 = 10.0 - (94.0 - 72.0 * cos_beta_squared) * cos_beta_squared
        sum_268 = 196.0 - 21.0 * cos_beta_squared
        sum_269 = 121.0 - cos_beta_squared * sum_268
        sum_270 = 280.0 - 126.0 * cos_beta_squared
        sum_271 = 190.0 - 18.0 * cos_beta_squared
        sum_272 = (24.0 - cos_beta_squared) * baseline - 46.0 * cos_beta * path
        sum_273 = baseline * sum_272 - path_squared * sum_271
        sum_274 = 146.0 * baseline * path + cos_beta * sum_273
        sum_275 = 188.0 * path_squared - 36.0 * baseline_squared + cos_beta * sum_274
        sum_276 = baseline * sum_275 - cos_beta * product_2 * sum_270
        sum_277 = baseline * sum_276 - path_squared_squared * sum_269
        sum_278 = 72.0 * baseline_squared - 74.0 * path_squared
        sum_279 = cos_beta * sum_277 - baseline * path * sum_278
        sum_280 = baseline * sum_279 - product_4 * sum_267
        sum_281 = baseline * sum_280 - (2.0 + 22.0 * cos_beta_squared) * cos_beta * path_squared_cubed
        sum_282 = 8.0 * cos_beta_squared * product_19 + baseline * sum_281
        sum_283 = baseline * sum_282 - cos_beta * term_3
        sum_284 = (
            128.0 * sum_1_squared * sum_266
            - 192.0 * baseline_squared * sigma_path_squared * sin_beta_squared * sum_205
            - rho * sum_257
            + 16.0 * sigma_beta_squared * sum_283
        )
        sum_285 = 18.0 * path + cos_beta * (7.0 * baseline + product_3)
        sum_286 = cos_beta * sum_285 - 16.0 * baseline
        sum_287 = (7.0 - 10.0 * cos_beta_squared) * path_squared + baseline * sum_286
        sum_288 = baseline * sum_287 - 3.0 * cos_beta * product_2
        sum_289 = 64.0 * sum_1_squared * sum_258 - 32.0 * sigma_beta_squared * sum_288
        sum_290 = 4.0 * path + cos_beta * (4.0 * baseline + product_9)
        sum_291 = cos_beta * sum_290 - 6.0 * baseline
        sum_292 = (4.0 - 4.0 * cos_beta_squared) * path_squared + baseline * sum_291
        sum_293 = product_7 + baseline * sum_292
        sum_294 = sum_1_squared * sum_289 - 16.0 * sigma_beta_squared_squared * sum_293 * sum_65
        sum_295 = path * sum_294 * sum_2_squared * sum_3_squared - sigma_path_squared * sum_284
        sum_296 = 1.0 + (38.0 - 36.0 * sin_beta_squared) * sin_beta_squared
        sum_297 = 14.0 - (52.0 + 32.0 * sin_beta_squared) * sin_beta_squared
        sum_298 = 2.0 + (6.0 + 4.0 * sin_beta_squared) * sin_beta_squared
        sum_299 = 32.0 + (29.0 + 2.0 * sin_beta_squared) * sin_beta_squared
        sum_300 = baseline * sum_299 - (98.0 + 32.0 * sin_beta_squared) * cos_beta * path
        sum_301 = 36.0 - (91.0 + 6.0 * sin_beta_squared) * sin_beta_squared
        sum_302 = path_squared * sum_301 + baseline * sum_300
        sum_303 = 3.0 * baseline + 8.0 * cos_beta * path
        sum_304 = 21.0 * path_squared - baseline * sum_303 + sin_beta_squared * sum_302
        sum_305 = cos_beta * product_23 * sum_298 + path * sum_304
        sum_306 = baseline * sum_305 - cos_beta * path_squared_squared * sum_297
        sum_307 = baseline * sum_306 - product_4 * sum_296
        sum_308 = 4.0 * cos_beta * path_squared_cubed + baseline * sum_307
        sum_309 = baseline * sum_308 - (1.0 - 2.0 * sin_beta_squared) * product_19
        sum_310 = 95.0 * path + cos_beta * (20.0 * baseline + product_15)
        sum_311 = 11.0 * baseline_squared - path * sum_310
        sum_312 = 76.0 * baseline * path + cos_beta * sum_311
        sum_313 = 103.0 * path_squared - 16.0 * baseline_squared + cos_beta * sum_312
        sum_314 = baseline * sum_313 - (80.0 - 44.0 * cos_beta_squared) * cos_beta * product_2
        sum_315 = 48.0 * baseline_squared - 2.0 * path_squared
        sum_316 = cos_beta * sum_314 - path * sum_315
        sum_317 = baseline * sum_316 - (3.0 - 28.0 * cos_beta_squared) * cos_beta * path_squared_squared
        sum_318 = product_22 + baseline * sum_317
        sum_319 = 32.0 * sum_1_squared * sum_318 - 48.0 * sigma_beta_squared * sum_309
        sum_320 = sin_beta * sum_295 - rho * sigma_beta * sigma_path * sum_2 * sum_3 * sum_319
        sum_321 = rho * sigma_path * sum_199 + sigma_beta * sum_320
        sum_322 = 18.0 - 14.0 * sin_beta_squared
        sum_323 = 2.0 + sin_beta_squared
        sum_324 = baseline * cos_beta * sum_323 - (16.0 - 4.0 * sin_beta_squared) * path
        sum_325 = 12.0 * path - 3.0 * baseline * cos_beta + sin_beta_squared * sum_324
        sum_326 = baseline * sum_325 - cos_beta * path_squared * sum_322
        sum_327 = product_2 * sum_78 + baseline * sum_326
        sum_328 = (
            128.0 * baseline * sum_327
            - 384.0 * cos_beta * path_squared_squared
            - 576.0 * baseline_squared * cos_beta * sigma_path_squared * sin_beta_squared
        )
        sum_329 = (
            64.0 * cos_beta * sum_1_squared_squared * sum_55_squared
            - baseline_squared * sigma_path_squared * sin_beta_squared * sum_328
        )
        sum_330 = sigma_path_squared * sin_beta * sum_329 + sigma_beta * sum_321
        sum_331 = 7.0 - sin_beta_squared * (6.0 + sin_beta_squared)
        sum_332 = baseline * sum_331 - (32.0 - 16.0 * sin_beta_squared) * cos_beta * path
        sum_333 = 58.0 - (62.0 - 12.0 * sin_beta_squared) * sin_beta_squared
        sum_334 = path_squared * sum_333 + baseline * sum_332
        sum_335 = baseline * sum_334 - (52.0 - 28.0 * sin_beta_squared) * cos_beta * product_2
        sum_336 = (23.0 - 20.0 * sin_beta_squared) * path_squared_squared + baseline * sum_335
        sum_337 = (
            256.0 * baseline * sum_336
            - 1024.0 * cos_beta * product_4
            + 3456.0 * baseline_squared * sigma_path_squared * sin_beta_squared * sum_258
        )
        sum_338 = (
            128.0 * sum_1_squared_squared * sum_2 * sum_258 * sum_3 * sum_55
            + baseline_squared * sigma_path_squared * sin_beta_squared * sum_337
        )
        sum_339 = 21.0 * path + cos_beta * (14.0 * baseline + product_3)
        sum_340 = 12.0 * baseline_squared - path * sum_339
        sum_341 = 24.0 * baseline * path + cos_beta * sum_340
        sum_342 = 12.0 * path_squared - 16.0 * baseline_squared + cos_beta * sum_341
        sum_343 = baseline * sum_342 - (12.0 - 10.0 * cos_beta_squared) * cos_beta * product_2
        sum_344 = baseline * sum_343 - path_squared_squared * sum_38
        sum_345 = 64.0 * sum_1_squared * sum_258**2 - 32.0 * sigma_beta_squared * sum_344
        sum_346 = 16.0 * sigma_beta_squared_squared * sum_293**2 + sum_1_squared * sum_345
        product_28 = 4.0 * cos_beta * product_2
        sum_347 = baseline * (8.0 + sin_beta_squared) - 14.0 * cos_beta * path
        sum_348 = (3.0 - 6.0 * sin_beta_squared) * path_squared + baseline * sum_347
        sum_349 = product_28 + baseline * sum_348
        sum_350 = baseline * sum_349 - path_squared_squared
        sum_351 = (27.0 + 9.0 * sin_beta_squared) * baseline - (68.0 + 6.0 * sin_beta_squared) * cos_beta * path
        sum_352 = (38.0 - 63.0 * sin_beta_squared) * path_squared + baseline * sum_351
        sum_353 = (24.0 + 16.0 * sin_beta_squared) * cos_beta * product_2 + baseline * sum_352
        sum_354 = baseline * sum_353 - path_squared_squared * sum_206
        sum_355 = 4.0 * cos_beta * product_4 + baseline * sum_354
        sum_356 = baseline * (17.0 + sin_beta_squared) - 32.0 * cos_beta * path
        sum_357 = (12.0 - 15.0 * sin_beta_squared) * path_squared + baseline * sum_356
        sum_358 = product_28 + baseline * sum_357
        sum_359 = baseline * sum_358 - path_squared_squared
        sum_360 = baseline * sum_201 - cos_beta * path * (13.0 + sin_beta_squared)
        sum_361 = path_squared * sum_200 + baseline * sum_360
        sum_362 = cos_beta * product_2 * sum_74 + baseline * sum_361
        sum_363 = baseline * sum_362 - (5.0 - 4.0 * sin_beta_squared) * path_squared_squared
        sum_364 = cos_beta * product_4 + baseline * sum_363
        sum_365 = 384.0 * sigma_path * sin_beta * sum_359 + 768.0 * rho * sigma_beta * sum_364
        sum_366 = 192.0 * sigma_beta * sum_355 + rho * sum_365
        sum_367 = 192.0 * sigma_path * sin_beta * sum_350 + rho * sum_366
        product_29 = -8.0 * cos_beta * product_19
        sum_368 = 86.0 - (83.0 + 12.0 * sin_beta_squared) * sin_beta_squared
        sum_369 = 31.0 + sin_beta_squared * (22.0 + sin_beta_squared)
        sum_370 = baseline * sum_369 - (95.0 + 31.0 * sin_beta_squared) * cos_beta * path
        sum_371 = 67.0 - (124.0 + 9.0 * sin_beta_squared) * sin_beta_squared
        sum_372 = path_squared * sum_371 + baseline * sum_370
        sum_373 = (58.0 + 83.0 * sin_beta_squared) * cos_beta * product_2 + baseline * sum_372
        sum_374 = baseline * sum_373 - path_squared_squared * sum_368
        sum_375 = (13.0 - 36.0 * sin_beta_squared) * cos_beta * product_4 + baseline * sum_374
        sum_376 = (19.0 - 13.0 * sin_beta_squared) * path_squared_cubed + baseline * sum_375
        sum_377 = product_29 + baseline * sum_376
        sum_378 = 146.0 + 21.0 * sin_beta_squared
        sum_379 = 122.0 - sin_beta_squared * sum_378
        sum_380 = 140.0 + 76.0 * sin_beta_squared
        sum_381 = 49.0 + sin_beta_squared * (58.0 + sin_beta_squared)
        sum_382 = baseline * sum_381 - cos_beta * path * sum_380
        sum_383 = 214.0 + 18.0 * sin_beta_squared
        sum_384 = 76.0 - sin_beta_squared * sum_383
        sum_385 = path_squared * sum_384 + baseline * sum_382
        sum_386 = 112.0 + 164.0 * sin_beta_squared
        sum_387 = cos_beta * product_2 * sum_386 + baseline * sum_385
        sum_388 = baseline * sum_387 - path_squared_squared * sum_379
        sum_389 = (4.0 - 72.0 * sin_beta_squared) * cos_beta * product_4 + baseline * sum_388
        sum_390 = (28.0 - 22.0 * sin_beta_squared) * path_squared_cubed + baseline * sum_389
        sum_391 = product_29 + baseline * sum_390
        sum_392 = 128.0 * rho_squared * (baseline * sum_377 + term_3) + 16.0 * baseline * sum_391 + 16.0 * term_3
        sum_393 = baseline_squared * sigma_path * sin_beta * sum_367 + sigma_beta_squared * sum_392
        sum_394 = 4.0 + (1.0 - 20.0 * cos_beta_squared) * cos_beta_squared
        sum_395 = cos_beta * (40.0 * path + product_21) - 17.0 * baseline
        sum_396 = (48.0 - 30.0 * cos_beta_squared) * path_squared + baseline * sum_395
        sum_397 = baseline * sum_396 - (36.0 - 6.0 * cos_beta_squared) * cos_beta * product_2
        sum_398 = 44.0 * baseline_squared - 10.0 * path_squared
        sum_399 = cos_beta * sum_397 - path * sum_398
        sum_400 = 16.0 * baseline_squared - 3.0 * path_squared
        sum_401 = cos_beta * sum_399 + baseline * sum_400
        sum_402 = baseline * sum_401 - path_squared_squared * sum_394
        sum_403 = cos_beta * product_4 * sum_108 + baseline * sum_402
        sum_404 = 6.0 + (12.0 - 33.0 * cos_beta_squared) * cos_beta_squared
        sum_405 = 78.0 * path + cos_beta * (7.0 * baseline + product_26)
        sum_406 = cos_beta * sum_405 - 38.0 * baseline
        sum_407 = (87.0 - 60.0 * cos_beta_squared) * path_squared + baseline * sum_406
        sum_408 = baseline * sum_407 - (60.0 - 14.0 * cos_beta_squared) * cos_beta * product_2
        sum_409 = 78.0 * baseline_squared - 26.0 * path_squared
        sum_410 = cos_beta * sum_408 - path * sum_409
        sum_411 = 32.0 * baseline_squared - 12.0 * path_squared
        sum_412 = cos_beta * sum_410 + baseline * sum_411
        sum_413 = baseline * sum_412 - path_squared_squared * sum_404
        sum_414 = (12.0 - 18.0 * cos_beta_squared) * cos_beta * product_4 + baseline * sum_413
        sum_415 = baseline * sum_414 - path_squared_cubed * sum_171
        sum_416 = 64.0 * rho_squared * sum_415 - 64.0 * path_squared_cubed * sum_100 + 64.0 * baseline * sum_403
        sum_417 = sin_beta_squared * sum_393 + sum_1_squared * sum_416
        sum_418 = 61.0 * path + cos_beta * (14.0 * baseline + product_11)
        sum_419 = 11.0 * baseline_squared - path * sum_418
        sum_420 = 74.0 * baseline * path + cos_beta * sum_419
        sum_421 = 11.0 * path_squared - 32.0 * baseline_squared + cos_beta * sum_420
        sum_422 = baseline * sum_421 - cos_beta * product_2 * sum_102
        sum_423 = (7.0 + 14.0 * cos_beta_squared) * path_squared_squared + baseline * sum_422
        sum_424 = baseline * sum_423 - 6.0 * cos_beta * product_4
        sum_425 = product_6 - 8.0 * cos_beta * path
        sum_426 = baseline * sum_425 - (3.0 - 3.0 * cos_beta_squared) * path_squared
        sum_427 = product_28 + baseline * sum_426
        sum_428 = baseline * sum_427 - path_squared_squared
        sum_429 = 64.0 * sum_1_squared * sum_424 + 96.0 * sigma_beta_squared * sum_293 * sum_428
        sum_430 = rho * sigma_beta * sin_beta * sum_2 * sum_3 * sum_429 - sigma_path * sum_417
        sum_431 = sum_2_squared * sum_346 * sum_3_squared - sigma_path * sum_430
        sum_432 = rho * sigma_path * sin_beta * sum_338 + sigma_beta * sum_431
        sum_433 = 56.0 - (72.0 - 20.0 * sin_beta_squared) * sin_beta_squared
        sum_434 = 54.0 - (30.0 - 4.0 * sin_beta_squared) * sin_beta_squared
        sum_435 = 12.0 - 4.0 * sin_beta_squared
        sum_436 = baseline * cos_beta * sum_435 - path * sum_434
        sum_437 = 28.0 * path - 8.0 * baseline * cos_beta + sin_beta_squared * sum_436
        sum_438 = baseline_squared * sum_175 + path * sum_437
        sum_439 = baseline * sum_438 - cos_beta * product_2 * sum_433
        sum_440 = 110.0 - 41.0 * sin_beta_squared
        sum_441 = 70.0 - sin_beta_squared * sum_440
        sum_442 = path_squared_squared * sum_441 + baseline * sum_439
        sum_443 = baseline * sum_442 - (56.0 - 44.0 * sin_beta_squared) * cos_beta * product_4
        sum_444 = (28.0 - 26.0 * sin_beta_squared) * path_squared_cubed + baseline * sum_443
        sum_445 = product_29 + baseline * sum_444
        sum_446 = 3.0 - sin_beta_squared * sum_323
        sum_447 = baseline * sum_446 - cos_beta * path * sum_435
        sum_448 = path_squared * sum_322 + baseline * sum_447
        sum_449 = baseline * sum_448 - 12.0 * cos_beta * product_2
        sum_450 = (
            128.0 * baseline * sum_449
            + 384.0 * path_squared_squared
            + 576.0 * baseline_squared * sigma_path_squared * sin_beta_squared
        )
        sum_451 = (
            64.0 * baseline * sum_445
            + 64.0 * term_3
            + baseline_squared * sigma_path_squared * sin_beta_squared * sum_450
        )
        sum_452 = sigma_path_squared * sin_beta_squared * sum_451 + sigma_beta * sum_432
        mean[i, 0] = -sum_26 * term_1
        mean[i, 1] = -sum_53 * term_1
        covariance[i, 0, 0] = sum_186 * term_2
        covariance[i, 0, 1] = sum_330 * term_2
        covariance[i, 1, 0] = covariance[i, 0, 1]
        covariance[i, 1, 1] = sum_452 * term_2


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


def spherical_doppler_linear(
    all_r: Floats,
    all_beta: Floats,
    all_epsilon: Floats,
    all_rdot: Floats,
    all_sigma_r: Floats,
    all_sigma_beta: Floats,
    all_sigma_epsilon: Floats,
    all_sigma_rdot: Floats,
    all_rho: Floats,
    mean: Filled,
    covariance: Filled,
) -> None:
    """Conversion spherical_doppler, linear.

    Mean: map from the measured quantities to coordinates. Covariance: covariance of the linearised
    conversion.
    """
    for i in range(len(all_r)):
        r = all_r[i]
        beta = all_beta[i]
        epsilon = all_epsilon[i]
        rdot = all_rdot[i]
        sigma_r = all_sigma_r[i]
        sigma_beta = all_sigma_beta[i]
        sigma_epsilon = all_sigma_epsilon[i]
        sigma_rdot = all_sigma_rdot[i]
        rho = all_rho[i]
        cos_beta = math.cos(beta)
        sin_beta = math.sin(beta)
        cos_epsilon = math.cos(epsilon)
        sin_epsilon = math.sin(epsilon)
        r_squared = r**2
        sigma_beta_squared = sigma_beta**2
        part_00_cos_beta2_cos_epsilon2 = r_squared * sigma_beta_squared
        sigma_epsilon_squared = sigma_epsilon**2
        part_00_sin_beta2_sin_epsilon2 = r_squared * sigma_epsilon_squared
        sigma_r_squared = sigma_r**2
        part_01_cos_beta_cos_epsilon2_sin_beta = sigma_r_squared - r_squared * sigma_beta_squared
        part_02_cos_epsilon_sin_beta_sin_epsilon = sigma_r_squared - r_squared * sigma_epsilon_squared
        sum_1 = r * rho * sigma_rdot + rdot * sigma_r
        part_03_cos_epsilon_sin_beta = sigma_r * sum_1
        cos_beta_squared = cos_beta**2
        sin_beta_squared = sin_beta**2
        cos_epsilon_squared = cos_epsilon**2
        sum_2 = cos_beta_squared * part_00_cos_beta2_cos_epsilon2 + sigma_r_squared * sin_beta_squared
        sin_epsilon_squared = sin_epsilon**2
        product_1 = part_00_sin_beta2_sin_epsilon2 * sin_epsilon_squared
        sum_3 = cos_epsilon_squared * part_01_cos_beta_cos_epsilon2_sin_beta + product_1
        sum_4 = cos_epsilon_squared * sigma_r_squared + product_1
        sum_5 = 2.0 * rdot * rho * sigma_r + r * sigma_rdot
        mean[i, 0] = cos_epsilon * r * sin_beta
        mean[i, 1] = cos_beta * cos_epsilon * r
        mean[i, 2] = r * sin_epsilon
        mean[i, 3] = r * rdot
        covariance[i, 0, 0] = (
            cos_epsilon_squared * sum_2
            + part_00_sin_beta2_sin_epsilon2 * sin_beta_squared * sin_epsilon_squared
        )
        covariance[i, 0, 1] = cos_beta * sin_beta * sum_3
        covariance[i, 0, 2] = cos_epsilon * part_02_cos_epsilon_sin_beta_sin_epsilon * sin_beta * sin_epsilon
        covariance[i, 0, 3] = cos_epsilon * part_03_cos_epsilon_sin_beta * sin_beta
        covariance[i, 1, 0] = covariance[i, 0, 1]
        covariance[i, 1, 1] = (
            cos_beta_squared * sum_4
            + cos_epsilon_squared * part_00_cos_beta2_cos_epsilon2 * sin_beta_squared
        )
        covariance[i, 1, 2] = cos_beta * cos_epsilon * part_02_cos_epsilon_sin_beta_sin_epsilon * sin_epsilon
        covariance[i, 1, 3] = cos_beta * cos_epsilon * part_03_cos_epsilon_sin_beta
        covariance[i, 2, 0] = covariance[i, 0, 2]
        covariance[i, 2, 1] = covariance[i, 1, 2]
        covariance[i, 2, 2] = (
            cos_epsilon_squared * part_00_sin_beta2_sin_epsilon2
            + sigma_r_squared * sin_epsilon_squared
        )
        covariance[i, 2, 3] = part_03_cos_epsilon_sin_beta * sin_epsilon
        covariance[i, 3, 0] = covariance[i, 0, 3]
        covariance[i, 3, 1] = covariance[i, 1, 3]
        covariance[i, 3, 2] = covariance[i, 2, 3]
        covariance[i, 3, 3] = rdot**2 * sigma_r_squared + r * sigma_rdot * sum_5


def spherical_doppler_second_order(
    all_r: Floats,
    all_beta: Floats,
    all_epsilon: Floats,
    all_rdot: Floats,
    all_sigma_r: Floats,
    all_sigma_beta: Floats,
    all_sigma_epsilon: Floats,
    all_sigma_rdot: Floats,
    all_rho: Floats,
    mean: Filled,
    covariance: Filled,
) -> None:
    """Conversion spherical_doppler, second_order.

    Mean: map from the measured quantities to coordinates less the bias of the plain conversion to second
    order. Covariance: covariance of the conversion's quadratic Taylor polynomial.
    """
    for i in range(len(all_r)):
        r = all_r[i]
        beta = all_beta[i]
        epsilon = all_epsilon[i]
        rdot = all_rdot[i]
        sigma_r = all_sigma_r[i]
        sigma_beta = all_sigma_beta[i]
        sigma_epsilon = all_sigma_epsilon[i]
        sigma_rdot = all_sigma_rdot[i]
        rho = all_rho[i]
        cos_beta = math.cos(beta)
        sin_beta = math.sin(beta)
        cos_epsilon = math.cos(epsilon)
        sin_epsilon = math.sin(epsilon)
        sigma_beta_squared = sigma_beta**2
        sigma_epsilon_squared = sigma_epsilon**2
        sum_1 = 0.5 * sigma_beta_squared + 0.5 * sigma_epsilon_squared
        part_0_cos_epsilon_sin_beta = -r * sum_1
        r_squared = r**2
        sigma_r_squared = sigma_r**2
        sum_2 = r_squared + sigma_r_squared
        part_00_cos_beta2_cos_epsilon2 = sigma_beta_squared * sum_2
        part_00_cos_beta2_sin_epsilon2 = r_squared * sigma_beta_squared * sigma_epsilon_squared
        sigma_epsilon_squared_squared = sigma_epsilon_squared**2
        sum_3 = 0.5 * sigma_beta_squared**2 + 0.5 * sigma_epsilon_squared_squared
        part_00_cos_epsilon2_sin_beta2 = r_squared * sum_3 + sigma_r_squared
        part_00_sin_beta2_sin_epsilon2 = sigma_epsilon_squared * sum_2
        sum_4 = (1.0 - 0.5 * sigma_beta_squared) * sigma_beta_squared - 0.5 * sigma_epsilon_squared_squared
        sum_5 = 1.0 - sigma_beta_squared
        part_01_cos_beta_cos_epsilon2_sin_beta = sigma_r_squared * sum_5 - r_squared * sum_4
        sum_6 = r_squared * sum_5 + sigma_r_squared
        part_01_cos_beta_sin_beta_sin_epsilon2 = sigma_epsilon_squared * sum_6
        sum_7 = 1.0 - 0.5 * sigma_epsilon_squared
        sum_8 = r_squared * sum_7 + sigma_r_squared
        part_02_cos_epsilon_sin_beta_sin_epsilon = sigma_r_squared - sigma_epsilon_squared * sum_8
        sum_9 = r * rho * sigma_rdot + rdot * sigma_r
        part_03_cos_epsilon_sin_beta = sigma_r * sum_9
        part_22_sin_epsilon2 = 0.5 * r_squared * sigma_epsilon_squared_squared + sigma_r_squared
        sum_10 = part_0_cos_epsilon_sin_beta - r
        sum_11 = 1.0 + 0.5 * sigma_epsilon_squared
        cos_beta_squared = cos_beta**2
        cos_epsilon_squared = cos_epsilon**2
        sin_epsilon_squared = sin_epsilon**2
        sum_12 = (
            cos_epsilon_squared * part_00_cos_beta2_cos_epsilon2
            + part_00_cos_beta2_sin_epsilon2 * sin_epsilon_squared
        )
        sum_13 = (
            cos_epsilon_squared * part_00_cos_epsilon2_sin_beta2
            + part_00_sin_beta2_sin_epsilon2 * sin_epsilon_squared
        )
        sin_beta_squared = sin_beta**2
        sum_14 = (
            cos_epsilon_squared * part_01_cos_beta_cos_epsilon2_sin_beta
            + part_01_cos_beta_sin_beta_sin_epsilon2 * sin_epsilon_squared
        )
        sigma_rdot_squared = sigma_rdot**2
        sum_15 = rdot**2 + (1.0 + rho**2) * sigma_rdot_squared
        sum_16 = 2.0 * r * rdot * rho * sigma_rdot + sigma_r * sum_15
        mean[i, 0] = -cos_epsilon * sin_beta * sum_10
        mean[i, 1] = -cos_beta * cos_epsilon * sum_10
        mean[i, 2] = r * sin_epsilon * sum_11
        mean[i, 3] = r * rdot - rho * sigma_r * sigma_rdot
        covariance[i, 0, 0] = cos_beta_squared * sum_12 + sin_beta_squared * sum_13
        covariance[i, 0, 1] = cos_beta * sin_beta * sum_14
        covariance[i, 0, 2] = cos_epsilon * part_02_cos_epsilon_sin_beta_sin_epsilon * sin_beta * sin_epsilon
        covariance[i, 0, 3] = cos_epsilon * part_03_cos_epsilon_sin_beta * sin_beta
        covariance[i, 1, 0] = covariance[i, 0, 1]
        covariance[i, 1, 1] = cos_beta_squared * sum_13 + sin_beta_squared * sum_12
        covariance[i, 1, 2] = cos_beta * cos_epsilon * part_02_cos_epsilon_sin_beta_sin_epsilon * sin_epsilon
        covariance[i, 1, 3] = cos_beta * cos_epsilon * part_03_cos_epsilon_sin_beta
        covariance[i, 2, 0] = covariance[i, 0, 2]
        covariance[i, 2, 1] = covariance[i, 1, 2]
        covariance[i, 2, 2] = (
            cos_epsilon_squared * part_00_sin_beta2_sin_epsilon2
            + part_22_sin_epsilon2 * sin_epsilon_squared
        )
        covariance[i, 2, 3] = part_03_cos_epsilon_sin_beta * sin_epsilon
        covariance[i, 3, 0] = covariance[i, 0, 3]
        covariance[i, 3, 1] = covariance[i, 1, 3]
        covariance[i, 3, 2] = covariance[i, 2, 3]
        covariance[i, 3, 3] = r_squared * sigma_rdot_squared + sigma_r * sum_16


def spherical_doppler_averaged(
    all_r: Floats,
    all_beta: Floats,
    all_epsilon: Floats,
    all_rdot: Floats,
    all_sigma_r: Floats,
    all_sigma_beta: Floats,
    all_sigma_epsilon: Floats,
    all_sigma_rdot: Floats,
    all_rho: Floats,
    mean: Filled,
    covariance: Filled,
) -> None:
    """Conversion spherical_doppler, averaged.

    Mean: map from the measured quantities to coordinates less the exact bias of the plain conversion,
    averaged over the truth. Covariance: exact covariance of the plain conversion, averaged over the truth.
    """
    for i in range(len(all_r)):
        r = all_r[i]
        beta = all_beta[i]
        epsilon = all_epsilon[i]
        rdot = all_rdot[i]
        sigma_r = all_sigma_r[i]
        sigma_beta = all_sigma_beta[i]
        sigma_epsilon = all_sigma_epsilon[i]
        sigma_rdot = all_sigma_rdot[i]
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
        sum_2 = 1.0 + attenuation_beta_2
        sum_3 = 1.0 - attenuation_epsilon_2 * sum_2
        attenuation_epsilon_2_squared = attenuation_epsilon_2**2
        sum_4 = 1.0 - attenuation_epsilon_2 + attenuation_beta_2 * sum_3
        sum_5 = 1.0 + attenuation_beta_2 + attenuation_epsilon_2_squared * sum_4
        sum_6 = 1.0 - attenuation_epsilon_2 * sum_5 + attenuation_beta_2 * sum_2
        attenuation_epsilon_2_squared_squared = attenuation_epsilon_2_squared**2
        r_squared = r**2
        sum_7 = 1.0 + attenuation_beta_2 * sum_6 + attenuation_epsilon_2_squared_squared
        sum_8 = 2.0 + 2.0 * attenuation_beta_2
        sum_9 = 1.0 - attenuation_epsilon_2 * sum_8
        sum_10 = 1.0 - 2.0 * attenuation_epsilon_2 + attenuation_beta_2 * sum_9
        sum_11 = 1.0 + attenuation_beta_2 + attenuation_epsilon_2_squared * sum_10
        product_1 = attenuation_beta_2 * sum_8
        sum_12 = 2.0 - attenuation_epsilon_2 * sum_11 + product_1
        sigma_r_squared = sigma_r**2
        sum_13 = 2.0 + 2.0 * attenuation_epsilon_2_squared_squared + attenuation_beta_2 * sum_12
        sum_14 = 0.25 * r_squared * sum_7 + 0.25 * sigma_r_squared * sum_13
        part_00_cos_beta2_cos_epsilon2 = shortfall_beta_2 * sum_14
        product_2 = attenuation_epsilon_2 * (1.0 + attenuation_epsilon_2)
        sum_15 = 1.0 + product_2
        product_3 = attenuation_epsilon_2 * sum_15
        product_4 = attenuation_epsilon_2 * attenuation_epsilon_2_squared
        sum_16 = 1.0 + attenuation_beta_2 * (1.0 + product_3) + product_4
        sum_17 = 1.0 + attenuation_beta_2 * sum_16 + product_4
        sum_18 = 1.0 + attenuation_beta_2 * sum_17 + product_3
        sum_19 = 2.0 + 2.0 * attenuation_epsilon_2
        sum_20 = 1.0 + 2.0 * attenuation_epsilon_2 + attenuation_beta_2 * sum_19
        sum_21 = 1.0 + 2.0 * attenuation_beta_2 + attenuation_epsilon_2 * sum_20
        sum_22 = 1.0 + 2.0 * attenuation_epsilon_2
        product_5 = attenuation_epsilon_2 * sum_22
        sum_23 = 1.0 + attenuation_beta_2 * sum_21 + product_5
        sum_24 = 2.0 + attenuation_epsilon_2 * sum_23 + product_1
        product_6 = attenuation_epsilon_2 * sum_19
        sum_25 = 2.0 + product_6
        sum_26 = 2.0 + attenuation_beta_2 * sum_24 + attenuation_epsilon_2 * sum_25
        sum_27 = 0.25 * r_squared * sum_18 + 0.25 * sigma_r_squared * sum_26
        part_00_cos_beta2_sin_epsilon2 = shortfall_beta_2 * shortfall_epsilon_2 * sum_27
        attenuation_beta_2_squared = attenuation_beta_2**2
        attenuation_beta_2_squared_squared = attenuation_beta_2_squared**2
        sum_28 = 1.5 * attenuation_epsilon_2 + 1.5 * shortfall_epsilon_2
        shortfall_epsilon_2_squared = shortfall_epsilon_2**2
        sum_29 = attenuation_epsilon_2 * sum_28 + 0.5 * shortfall_epsilon_2_squared
        product_7 = attenuation_beta_2 * attenuation_beta_2_squared
        sum_30 = 3.0 * attenuation_epsilon_2 + 3.0 * shortfall_epsilon_2
        sum_31 = attenuation_epsilon_2 * sum_30 + shortfall_epsilon_2_squared
        sum_32 = 1.5 * attenuation_epsilon_2 + 3.0 * shortfall_epsilon_2
        sum_33 = attenuation_beta_2 * sum_32 + shortfall_beta_2 * sum_32
        sum_34 = 5.25 * shortfall_beta_2 + 6.75 * attenuation_beta_2
        sum_35 = attenuation_epsilon_2 * sum_33 + shortfall_epsilon_2_squared * sum_34
        sum_36 = 0.5 * attenuation_epsilon_2 + shortfall_epsilon_2
        shortfall_beta_2_squared = shortfall_beta_2**2
        sum_37 = 1.5 * shortfall_epsilon_2_squared + attenuation_epsilon_2 * sum_36
        sum_38 = attenuation_beta_2 * sum_35 + shortfall_beta_2_squared * sum_37
        sum_39 = 3.75 * shortfall_beta_2 + 5.25 * attenuation_beta_2
        product_8 = shortfall_epsilon_2 * shortfall_epsilon_2_squared
        sum_40 = attenuation_beta_2 * sum_39 + shortfall_beta_2_squared
        sum_41 = attenuation_epsilon_2 * sum_38 + product_8 * sum_40
        sum_42 = 1.5 * attenuation_beta_2 + shortfall_beta_2
        shortfall_epsilon_2_squared_squared = shortfall_epsilon_2_squared**2
        sum_43 = attenuation_beta_2 * sum_42 + 0.25 * shortfall_beta_2_squared
        sum_44 = attenuation_epsilon_2 * sum_41 + shortfall_epsilon_2_squared_squared * sum_43
        sum_45 = product_7 * shortfall_epsilon_2_squared * sum_31 + shortfall_beta_2 * sum_44
        sum_46 = (
            attenuation_beta_2_squared_squared * shortfall_epsilon_2_squared * sum_29
            + shortfall_beta_2 * sum_45
        )
        sum_47 = 0.25 - 0.5 * attenuation_beta_2 * attenuation_epsilon_2
        sum_48 = 0.25 + attenuation_epsilon_2_squared * sum_47
        sum_49 = 0.25 + attenuation_beta_2_squared * sum_48 + 0.25 * attenuation_epsilon_2_squared
        sum_50 = 0.5 * product_7 - attenuation_epsilon_2 * sum_49
        sum_51 = 0.5 + attenuation_beta_2 * sum_50 + 0.5 * attenuation_epsilon_2_squared_squared
        part_00_cos_epsilon2_sin_beta2 = r_squared * sum_46 + sigma_r_squared * sum_51
        sum_52 = 1.0 - attenuation_beta_2 * sum_15 + attenuation_epsilon_2
        sum_53 = 1.0 + attenuation_beta_2_squared * sum_52 + attenuation_epsilon_2
        sum_54 = 1.0 - attenuation_beta_2 * sum_53 + product_2
        sum_55 = 1.0 + attenuation_beta_2_squared_squared + attenuation_epsilon_2 * sum_54
        sum_56 = 1.0 - attenuation_beta_2 * sum_25 + attenuation_epsilon_2
        sum_57 = 1.0 + attenuation_beta_2_squared * sum_56 + attenuation_epsilon_2
        sum_58 = 2.0 - attenuation_beta_2 * sum_57 + product_6
        sum_59 = 2.0 + 2.0 * attenuation_beta_2_squared_squared + attenuation_epsilon_2 * sum_58
        sum_60 = 0.25 * r_squared * sum_55 + 0.25 * sigma_r_squared * sum_59
        part_00_sin_beta2_sin_epsilon2 = shortfall_epsilon_2 * sum_60
        sum_61 = 3.0 * attenuation_epsilon_2 + shortfall_epsilon_2
        sum_62 = attenuation_beta_2 * sum_30 - shortfall_beta_2 * sum_61
        sum_63 = 4.0 * attenuation_epsilon_2_squared * shortfall_beta_2 - shortfall_epsilon_2 * sum_62
        sum_64 = 2.0 * product_4 * shortfall_beta_2 + shortfall_epsilon_2 * sum_63
        sum_65 = attenuation_beta_2 * shortfall_epsilon_2_squared_squared - attenuation_epsilon_2 * sum_64
        sum_66 = 2.0 * attenuation_epsilon_2 + 4.0 * shortfall_epsilon_2
        sum_67 = attenuation_beta_2 * sum_66 - shortfall_beta_2 * sum_66
        sum_68 = 9.0 * attenuation_beta_2 - 3.0 * shortfall_beta_2
        sum_69 = attenuation_epsilon_2 * sum_67 + shortfall_epsilon_2_squared * sum_68
        sum_70 = 7.0 * attenuation_beta_2 - shortfall_beta_2
        sum_71 = attenuation_epsilon_2 * sum_69 + product_8 * sum_70
        sum_72 = 2.0 * attenuation_beta_2 * shortfall_epsilon_2_squared_squared + attenuation_epsilon_2 * sum_71
        sum_73 = 0.5 * r_squared * sum_65 + 0.5 * sigma_r_squared * sum_72
        part_01_cos_beta_cos_epsilon2_sin_beta = product_7 * sum_73
        sum_74 = 2.0 * attenuation_epsilon_2 + 3.0 * shortfall_epsilon_2
        product_9 = -shortfall_beta_2 * sum_74
        sum_75 = attenuation_beta_2 * sum_74 + product_9
        sum_76 = 3.0 * attenuation_beta_2 - shortfall_beta_2
        sum_77 = attenuation_epsilon_2 * sum_75 + shortfall_epsilon_2_squared * sum_76
        sum_78 = attenuation_beta_2 * product_8 + attenuation_epsilon_2 * sum_77
        sum_79 = 6.0 * attenuation_epsilon_2 + 9.0 * shortfall_epsilon_2
        sum_80 = attenuation_beta_2 * sum_79 + product_9
        sum_81 = attenuation_epsilon_2 * sum_80 + shortfall_epsilon_2_squared * sum_70
        sum_82 = 2.0 * attenuation_beta_2 * product_8 + attenuation_epsilon_2 * sum_81
        sum_83 = 0.5 * r_squared * sum_78 + 0.5 * sigma_r_squared * sum_82
        part_01_cos_beta_sin_beta_sin_epsilon2 = product_7 * shortfall_epsilon_2 * sum_83
        sum_84 = attenuation_epsilon_2 - shortfall_epsilon_2
        sum_85 = r_squared * shortfall_epsilon_2 - sigma_r_squared * sum_84
        part_02_cos_epsilon_sin_beta_sin_epsilon = -attenuation_beta_2 * product_4 * sum_85
        sum_86 = r * rho * sigma_rdot + rdot * sigma_r
        part_03_cos_epsilon_sin_beta = attenuation_beta_2 * attenuation_epsilon_2 * sigma_r * sum_86
        sum_87 = 2.0 + attenuation_epsilon_2 * (1.0 + product_5)
        sum_88 = 0.5 * (1.0 + product_4) * r_squared + 0.5 * sigma_r_squared * sum_87
        part_22_cos_epsilon2 = shortfall_epsilon_2 * sum_88
        sum_89 = 0.5 + (0.5 - attenuation_epsilon_2) * attenuation_epsilon_2_squared
        sum_90 = 1.0 - attenuation_epsilon_2 * sum_89
        part_22_sin_epsilon2 = 0.5 * r_squared * shortfall_epsilon_2_squared * sum_15 + sigma_r_squared * sum_90
        part_23_sin_epsilon = attenuation_epsilon_2 * sigma_r * sum_86
        sum_91 = part_0_cos_epsilon_sin_beta - r
        sum_92 = 1.0 + attenuation_epsilon * shortfall_epsilon
        cos_beta_squared = cos_beta**2
        cos_epsilon_squared = cos_epsilon**2
        sin_epsilon_squared = sin_epsilon**2
        sum_93 = (
            cos_epsilon_squared * part_00_cos_beta2_cos_epsilon2
            + part_00_cos_beta2_sin_epsilon2 * sin_epsilon_squared
        )
        sum_94 = (
            cos_epsilon_squared * part_00_cos_epsilon2_sin_beta2
            + part_00_sin_beta2_sin_epsilon2 * sin_epsilon_squared
        )
        sin_beta_squared = sin_beta**2
        sum_95 = (
            cos_epsilon_squared * part_01_cos_beta_cos_epsilon2_sin_beta
            + part_01_cos_beta_sin_beta_sin_epsilon2 * sin_epsilon_squared
        )
        sigma_rdot_squared = sigma_rdot**2
        sum_96 = rdot**2 + (3.0 + 3.0 * rho**2) * sigma_rdot_squared
        sum_97 = 2.0 * r * rdot * rho * sigma_rdot + sigma_r * sum_96
        mean[i, 0] = -cos_epsilon * sin_beta * sum_91
        mean[i, 1] = -cos_beta * cos_epsilon * sum_91
        mean[i, 2] = r * sin_epsilon * sum_92
        mean[i, 3] = r * rdot - rho * sigma_r * sigma_rdot
        covariance[i, 0, 0] = cos_beta_squared * sum_93 + sin_beta_squared * sum_94
        covariance[i, 0, 1] = cos_beta * sin_beta * sum_95
        covariance[i, 0, 2] = cos_epsilon * part_02_cos_epsilon_sin_beta_sin_epsilon * sin_beta * sin_epsilon
        covariance[i, 0, 3] = cos_epsilon * part_03_cos_epsilon_sin_beta * sin_beta
        covariance[i, 1, 0] = covariance[i, 0, 1]
        covariance[i, 1, 1] = cos_beta_squared * sum_94 + sin_beta_squared * sum_93
        covariance[i, 1, 2] = cos_beta * cos_epsilon * part_02_cos_epsilon_sin_beta_sin_epsilon * sin_epsilon
        covariance[i, 1, 3] = cos_beta * cos_epsilon * part_03_cos_epsilon_sin_beta
        covariance[i, 2, 0] = covariance[i, 0, 2]
        covariance[i, 2, 1] = covariance[i, 1, 2]
        covariance[i, 2, 2] = (
            cos_epsilon_squared * part_22_cos_epsilon2
            + part_22_sin_epsilon2 * sin_epsilon_squared
        )
        covariance[i, 2, 3] = part_23_sin_epsilon * sin_epsilon
        covariance[i, 3, 0] = covariance[i, 0, 3]
        covariance[i, 3, 1] = covariance[i, 1, 3]
        covariance[i, 3, 2] = covariance[i, 2, 3]
        covariance[i, 3, 3] = r_squared * sigma_rdot_squared + sigma_r * sum_97


def spherical_doppler_unbiased(
    all_r: Floats,
    all_beta: Floats,
    all_epsilon: Floats,
    all_rdot: Floats,
    all_sigma_r: Floats,
    all_sigma_beta: Floats,
    all_sigma_epsilon: Floats,
    all_sigma_rdot: Floats,
    all_rho: Floats,
    mean: Filled,
    covariance: Filled,
) -> None:
    """Conversion spherical_doppler, unbiased.

    Mean: exactly unbiased estimate of the position. Covariance: error covariance of the unbiased estimate u.
    """
    for i in range(len(all_r)):
        r = all_r[i]
        beta = all_beta[i]
        epsilon = all_epsilon[i]
        rdot = all_rdot[i]
        sigma_r = all_sigma_r[i]
        sigma_beta = all_sigma_beta[i]
        sigma_epsilon = all_sigma_epsilon[i]
        sigma_rdot = all_sigma_rdot[i]
        rho = all_rho[i]
        cos_beta = math.cos(beta)
        sin_beta = math.sin(beta)
        cos_epsilon = math.cos(epsilon)
        sin_epsilon = math.sin(epsilon)
        attenuation_beta = math.exp(-0.5 * sigma_beta**2)
        attenuation_epsilon = math.exp(-0.5 * sigma_epsilon**2)
        term_1 = 1.0 / attenuation_beta
        term_2 = 1.0 / attenuation_epsilon
        part_0_cos_epsilon_sin_beta = r * term_1 * term_2
        shortfall_beta = -math.expm1(-0.5 * sigma_beta**2)
        shortfall_epsilon = -math.expm1(-0.5 * sigma_epsilon**2)
        attenuation_epsilon_squared = attenuation_epsilon**2
        attenuation_epsilon_squared_squared = attenuation_epsilon_squared**2
        sum_1 = 1.0 + attenuation_epsilon_squared_squared
        sum_2 = 1.0 + attenuation_beta * sum_1 + attenuation_epsilon_squared_squared
        sum_3 = 1.0 + attenuation_beta * sum_2 + attenuation_epsilon_squared_squared
        r_squared = r**2
        sigma_r_squared = sigma_r**2
        sum_4 = 0.25 * r_squared + 0.25 * sigma_r_squared
        sum_5 = 1.0 + attenuation_beta * sum_3 + attenuation_epsilon_squared_squared
        part_00_cos_beta2_cos_epsilon2 = shortfall_beta * sum_4 * sum_5
        sum_6 = 1.0 + attenuation_epsilon
        sum_7 = 1.0 + attenuation_beta * sum_6 + attenuation_epsilon
        sum_8 = 1.0 + attenuation_beta + attenuation_epsilon * sum_7
        product_1 = attenuation_epsilon * sum_6
        sum_9 = 1.0 + attenuation_beta * sum_8 + product_1
        sum_10 = 1.0 + attenuation_beta * (1.0 + attenuation_beta) + attenuation_epsilon * sum_9
        product_2 = attenuation_epsilon * (1.0 + product_1)
        sum_11 = 1.0 + attenuation_beta * sum_10 + product_2
        part_00_cos_beta2_sin_epsilon2 = shortfall_beta * shortfall_epsilon * sum_11 * sum_4
        term_3 = 1.0 / attenuation_beta**2
        attenuation_beta_squared = attenuation_beta**2
        attenuation_beta_squared_cubed = attenuation_beta_squared * attenuation_beta_squared**2
        shortfall_epsilon_squared = shortfall_epsilon**2
        shortfall_epsilon_squared_squared = shortfall_epsilon_squared**2
        product_3 = shortfall_epsilon * shortfall_epsilon_squared
        sum_12 = 24.0 * attenuation_epsilon + 56.0 * shortfall_epsilon
        sum_13 = 54.0 * shortfall_epsilon_squared + attenuation_epsilon * sum_12
        sum_14 = 24.0 * product_3 + attenuation_epsilon * sum_13
        sum_15 = 4.0 * shortfall_epsilon_squared_squared + attenuation_epsilon * sum_14
        shortfall_beta_squared = shortfall_beta**2
        shortfall_beta_squared_squared = shortfall_beta_squared**2
        product_4 = shortfall_beta * shortfall_beta_squared
        sum_16 = 24.0 * attenuation_beta + 56.0 * shortfall_beta
        sum_17 = 54.0 * shortfall_beta_squared + attenuation_beta * sum_16
        sum_18 = 24.0 * product_4 + attenuation_beta * sum_17
        sum_19 = 4.0 * shortfall_beta_squared_squared + attenuation_beta * sum_18
        sum_20 = 192.0 * shortfall_epsilon + 32.0 * attenuation_epsilon
        sum_21 = 192.0 * attenuation_epsilon + 648.0 * shortfall_epsilon
        sum_22 = attenuation_beta * sum_20 + shortfall_beta * sum_21
        sum_23 = 1032.0 * shortfall_beta + 368.0 * attenuation_beta
        sum_24 = attenuation_epsilon * sum_22 + shortfall_epsilon_squared * sum_23
        sum_25 = 1032.0 * shortfall_epsilon + 368.0 * attenuation_epsilon
        sum_26 = 1488.0 * shortfall_epsilon_squared + attenuation_epsilon * sum_25
        sum_27 = attenuation_beta * sum_24 + shortfall_beta_squared * sum_26
        sum_28 = 332.0 * attenuation_beta + 858.0 * shortfall_beta
        sum_29 = 1172.0 * shortfall_beta_squared + attenuation_beta * sum_28
        sum_30 = attenuation_epsilon * sum_27 + product_3 * sum_29
        sum_31 = 332.0 * attenuation_epsilon + 858.0 * shortfall_epsilon
        sum_32 = 1172.0 * shortfall_epsilon_squared + attenuation_epsilon * sum_31
        sum_33 = 893.0 * product_3 + attenuation_epsilon * sum_32
        sum_34 = attenuation_beta * sum_30 + product_4 * sum_33
        sum_35 = 144.0 * attenuation_beta + 360.0 * shortfall_beta
        sum_36 = 480.0 * shortfall_beta_squared + attenuation_beta * sum_35
        sum_37 = 360.0 * product_4 + attenuation_beta * sum_36
        sum_38 = attenuation_epsilon * sum_34 + shortfall_epsilon_squared_squared * sum_37
        sum_39 = 144.0 * attenuation_epsilon + 360.0 * shortfall_epsilon
        sum_40 = 480.0 * shortfall_epsilon_squared + attenuation_epsilon * sum_39
        sum_41 = 360.0 * product_3 + attenuation_epsilon * sum_40
        sum_42 = 144.0 * shortfall_epsilon_squared_squared + attenuation_epsilon * sum_41
        sum_43 = attenuation_beta * sum_38 + shortfall_beta_squared_squared * sum_42
        sum_44 = 24.0 * attenuation_beta + 60.0 * shortfall_beta
        sum_45 = 80.0 * shortfall_beta_squared + attenuation_beta * sum_44
        sum_46 = 60.0 * product_4 + attenuation_beta * sum_45
        product_5 = shortfall_epsilon * shortfall_epsilon_squared**2
        sum_47 = 24.0 * shortfall_beta_squared_squared + attenuation_beta * sum_46
        sum_48 = attenuation_epsilon * sum_43 + product_5 * sum_47
        sum_49 = 24.0 * attenuation_epsilon + 60.0 * shortfall_epsilon
        sum_50 = 80.0 * shortfall_epsilon_squared + attenuation_epsilon * sum_49
        sum_51 = 60.0 * product_3 + attenuation_epsilon * sum_50
        sum_52 = 24.0 * shortfall_epsilon_squared_squared + attenuation_epsilon * sum_51
        product_6 = shortfall_beta * shortfall_beta_squared**2
        sum_53 = 4.0 * product_5 + attenuation_epsilon * sum_52
        sum_54 = attenuation_beta * sum_48 + product_6 * sum_53
        sum_55 = (
            attenuation_epsilon_squared * attenuation_epsilon_squared**2 * shortfall_beta * sum_19
            + shortfall_epsilon * sum_54
        )
        term_4 = 1.0 / attenuation_epsilon**2
        sum_56 = attenuation_beta_squared_cubed * shortfall_epsilon_squared * sum_15 + shortfall_beta * sum_55
        attenuation_beta_squared_squared = attenuation_beta_squared**2
        sum_57 = 0.25 + 0.25 * attenuation_epsilon_squared_squared
        sum_58 = 0.25 + attenuation_beta_squared_squared * sum_57 + 0.25 * attenuation_epsilon_squared_squared
        part_00_cos_epsilon2_sin_beta2 = 0.25 * r_squared * sum_56 * term_3 * term_4 + sigma_r_squared * sum_58
        sum_59 = 1.0 + attenuation_beta_squared_squared * sum_6 + attenuation_epsilon
        sum_60 = 1.0 + attenuation_beta_squared_squared + attenuation_epsilon * sum_59
        sum_61 = 1.0 + attenuation_beta_squared_squared + attenuation_epsilon * sum_60
        part_00_sin_beta2_sin_epsilon2 = shortfall_epsilon * sum_4 * sum_61
        sum_62 = 12.0 * attenuation_beta + 30.0 * shortfall_beta
        sum_63 = 40.0 * shortfall_beta_squared + attenuation_beta * sum_62
        sum_64 = 30.0 * product_4 + attenuation_beta * sum_63
        sum_65 = 12.0 * shortfall_beta_squared_squared + attenuation_beta * sum_64
        sum_66 = 2.0 * product_6 + attenuation_beta * sum_65
        sum_67 = 12.0 * shortfall_epsilon + 2.0 * attenuation_epsilon
        sum_68 = 30.0 * shortfall_epsilon_squared + attenuation_epsilon * sum_67
        sum_69 = 40.0 * product_3 + attenuation_epsilon * sum_68
        sum_70 = 30.0 * shortfall_epsilon_squared_squared + attenuation_epsilon * sum_69
        sum_71 = 12.0 * product_5 + attenuation_epsilon * sum_70
        sum_72 = 180.0 * shortfall_beta + 72.0 * attenuation_beta
        sum_73 = 240.0 * shortfall_beta_squared + attenuation_beta * sum_72
        sum_74 = 180.0 * product_4 + attenuation_beta * sum_73
        sum_75 = 72.0 * shortfall_beta_squared_squared + attenuation_beta * sum_74
        sum_76 = 12.0 * attenuation_epsilon + 72.0 * shortfall_epsilon
        sum_77 = 180.0 * shortfall_epsilon_squared + attenuation_epsilon * sum_76
        sum_78 = 240.0 * product_3 + attenuation_epsilon * sum_77
        sum_79 = 180.0 * shortfall_epsilon_squared_squared + attenuation_epsilon * sum_78
        sum_80 = 164.0 * attenuation_beta + 426.0 * shortfall_beta
        sum_81 = 584.0 * shortfall_beta_squared + attenuation_beta * sum_80
        sum_82 = 446.0 * product_4 + attenuation_beta * sum_81
        sum_83 = 164.0 * shortfall_epsilon + 26.0 * attenuation_epsilon
        sum_84 = 426.0 * shortfall_epsilon_squared + attenuation_epsilon * sum_83
        sum_85 = 584.0 * product_3 + attenuation_epsilon * sum_84
        sum_86 = 176.0 * attenuation_beta + 504.0 * shortfall_beta
        sum_87 = 736.0 * shortfall_beta_squared + attenuation_beta * sum_86
        sum_88 = 176.0 * shortfall_epsilon + 24.0 * attenuation_epsilon
        sum_89 = 504.0 * shortfall_epsilon_squared + attenuation_epsilon * sum_88
        sum_90 = 306.0 * shortfall_beta + 84.0 * attenuation_beta
        sum_91 = 6.0 * attenuation_epsilon + 84.0 * shortfall_epsilon
        sum_92 = 4.0 * attenuation_epsilon - 8.0 * shortfall_epsilon
        sum_93 = attenuation_beta * sum_92 - shortfall_beta * sum_91
        sum_94 = attenuation_epsilon * sum_93 - shortfall_epsilon_squared * sum_90
        sum_95 = attenuation_beta * sum_94 - shortfall_beta_squared * sum_89
        sum_96 = attenuation_epsilon * sum_95 - product_3 * sum_87
        sum_97 = attenuation_beta * sum_96 - product_4 * sum_85
        sum_98 = attenuation_epsilon * sum_97 - shortfall_epsilon_squared_squared * sum_82
        sum_99 = attenuation_beta * sum_98 - shortfall_beta_squared_squared * sum_79
        sum_100 = attenuation_epsilon * sum_99 - product_5 * sum_75
        sum_101 = attenuation_beta * sum_100 - product_6 * sum_71
        sum_102 = (
            attenuation_epsilon * sum_101
            - shortfall_epsilon_squared * shortfall_epsilon_squared**2 * sum_66
        )
        sum_103 = 12.0 * attenuation_epsilon + 28.0 * shortfall_epsilon
        sum_104 = 27.0 * shortfall_epsilon_squared + attenuation_epsilon * sum_103
        sum_105 = 12.0 * product_3 + attenuation_epsilon * sum_104
        sum_106 = 2.0 * shortfall_epsilon_squared_squared + attenuation_epsilon * sum_105
        sum_107 = attenuation_beta_squared_cubed * shortfall_epsilon_squared * sum_106 - shortfall_beta * sum_102
        part_01_cos_beta_cos_epsilon2_sin_beta = (
            0.5 * attenuation_beta_squared_squared * sigma_r_squared * sum_1
            + 0.5 * r_squared * sum_107 * term_3 * term_4
        )
        sum_108 = 1.0 + product_2
        sum_109 = 0.5 * r_squared + 0.5 * sigma_r_squared
        part_01_cos_beta_sin_beta_sin_epsilon2 = attenuation_beta_squared_squared * shortfall_epsilon * sum_108 * sum_109
        sum_110 = 2.0 * shortfall_beta + attenuation_beta
        sum_111 = attenuation_beta * sum_110 + shortfall_beta_squared
        sum_112 = 12.0 * shortfall_beta + 6.0 * attenuation_beta
        sum_113 = 6.0 * shortfall_beta_squared + attenuation_beta * sum_112
        sum_114 = 13.0 * attenuation_beta + 28.0 * shortfall_beta
        sum_115 = 14.0 * shortfall_beta_squared + attenuation_beta * sum_114
        sum_116 = 2.0 * attenuation_epsilon + 9.0 * shortfall_epsilon
        sum_117 = 16.0 * shortfall_epsilon_squared + attenuation_epsilon * sum_116
        sum_118 = 12.0 * attenuation_beta + 32.0 * shortfall_beta
        sum_119 = 18.0 * shortfall_epsilon + 4.0 * attenuation_epsilon
        sum_120 = 2.0 * attenuation_epsilon - 3.0 * shortfall_epsilon
        sum_121 = attenuation_beta * sum_120 - shortfall_beta * sum_119
        sum_122 = attenuation_epsilon * sum_121 - shortfall_epsilon_squared * sum_118
        sum_123 = attenuation_beta * sum_122 - shortfall_beta_squared * sum_117
        sum_124 = attenuation_epsilon * sum_123 - product_3 * sum_115
        sum_125 = attenuation_epsilon * sum_124 - shortfall_epsilon_squared_squared * sum_113
        sum_126 = attenuation_epsilon * sum_125 - product_5 * sum_111
        part_02_cos_epsilon_sin_beta_sin_epsilon = (
            attenuation_beta * attenuation_epsilon_squared_squared * sigma_r_squared
            - r_squared * shortfall_epsilon * sum_126 * term_1 * term_4
        )
        sum_127 = 2.0 * attenuation_epsilon + 4.0 * shortfall_epsilon
        sum_128 = 2.0 * shortfall_epsilon_squared + attenuation_epsilon * sum_127
        sum_129 = 2.0 * attenuation_beta + 4.0 * shortfall_beta
        sum_130 = 4.0 * attenuation_epsilon + 8.0 * shortfall_epsilon
        sum_131 = attenuation_epsilon - 4.0 * shortfall_epsilon
        sum_132 = attenuation_beta * sum_131 - shortfall_beta * sum_130
        sum_133 = attenuation_epsilon * sum_132 - shortfall_epsilon_squared * sum_129
        sum_134 = attenuation_beta * sum_133 - shortfall_beta_squared * sum_128
        sum_135 = (
            attenuation_beta * attenuation_epsilon * rdot * sigma_r
            + r * rho * sigma_rdot * sum_134 * term_1 * term_2
        )
        part_03_cos_epsilon_sin_beta = sigma_r * sum_135
        part_22_cos_epsilon2 = shortfall_epsilon * sum_108 * sum_109
        sum_136 = 3.0 + attenuation_epsilon * (2.0 + attenuation_epsilon)
        sum_137 = 4.0 + attenuation_epsilon * sum_136
        sum_138 = 2.0 + attenuation_epsilon * sum_137
        sum_139 = 0.5 + 0.5 * attenuation_epsilon_squared_squared
        part_22_sin_epsilon2 = (
            0.5 * r_squared * shortfall_epsilon_squared * sum_138 * term_4
            + sigma_r_squared * sum_139
        )
        sum_140 = attenuation_epsilon * sum_131 - 2.0 * shortfall_epsilon_squared
        sum_141 = attenuation_epsilon * rdot * sigma_r + r * rho * sigma_rdot * sum_140 * term_2
        part_23_sin_epsilon = sigma_r * sum_141
        cos_beta_squared = cos_beta**2
        cos_epsilon_squared = cos_epsilon**2
        sin_epsilon_squared = sin_epsilon**2
        sum_142 = (
            cos_epsilon_squared * part_00_cos_beta2_cos_epsilon2
            + part_00_cos_beta2_sin_epsilon2 * sin_epsilon_squared
        )
        sum_143 = (
            cos_epsilon_squared * part_00_cos_epsilon2_sin_beta2
            + part_00_sin_beta2_sin_epsilon2 * sin_epsilon_squared
        )
        sin_beta_squared = sin_beta**2
        sum_144 = (
            cos_epsilon_squared * part_01_cos_beta_cos_epsilon2_sin_beta
            + part_01_cos_beta_sin_beta_sin_epsilon2 * sin_epsilon_squared
        )
        sigma_rdot_squared = sigma_rdot**2
        sum_145 = rdot**2 + (1.0 + 5.0 * rho**2) * sigma_rdot_squared
        sum_146 = 2.0 * r * rdot * rho * sigma_rdot + sigma_r * sum_145
        mean[i, 0] = cos_epsilon * part_0_cos_epsilon_sin_beta * sin_beta
        mean[i, 1] = cos_beta * cos_epsilon * part_0_cos_epsilon_sin_beta
        mean[i, 2] = r * sin_epsilon * term_2
        mean[i, 3] = r * rdot - rho * sigma_r * sigma_rdot
        covariance[i, 0, 0] = cos_beta_squared * sum_142 + sin_beta_squared * sum_143
        covariance[i, 0, 1] = cos_beta * sin_beta * sum_144
        covariance[i, 0, 2] = cos_epsilon * part_02_cos_epsilon_sin_beta_sin_epsilon * sin_beta * sin_epsilon
        covariance[i, 0, 3] = cos_epsilon * part_03_cos_epsilon_sin_beta * sin_beta
        covariance[i, 1, 0] = covariance[i, 0, 1]
        covariance[i, 1, 1] = cos_beta_squared * sum_143 + sin_beta_squared * sum_142
        covariance[i, 1, 2] = cos_beta * cos_epsilon * part_02_cos_epsilon_sin_beta_sin_epsilon * sin_epsilon
        covariance[i, 1, 3] = cos_beta * cos_epsilon * part_03_cos_epsilon_sin_beta
        covariance[i, 2, 0] = covariance[i, 0, 2]
        covariance[i, 2, 1] = covariance[i, 1, 2]
        covariance[i, 2, 2] = (
            cos_epsilon_squared * part_22_cos_epsilon2
            + part_22_sin_epsilon2 * sin_epsilon_squared
        )
        covariance[i, 2, 3] = part_23_sin_epsilon * sin_epsilon
        covariance[i, 3, 0] = covariance[i, 0, 3]
        covariance[i, 3, 1] = covariance[i, 1, 3]
        covariance[i, 3, 2] = covariance[i, 2, 3]
        covariance[i, 3, 3] = r_squared * sigma_rdot_squared + sigma_r * sum_146


def spherical_doppler_posterior(
    all_r: Floats,
    all_beta: Floats,
    all_epsilon: Floats,
    all_rdot: Floats,
    all_sigma_r: Floats,
    all_sigma_beta: Floats,
    all_sigma_epsilon: Floats,
    all_sigma_rdot: Floats,
    all_rho: Floats,
    mean: Filled,
    covariance: Filled,
) -> None:
    """Conversion spherical_doppler, posterior.

    Mean: posterior mean of the position under a flat prior. Covariance: posterior covariance of the position
    under a flat prior.
    """
    for i in range(len(all_r)):
        r = all_r[i]
        beta = all_beta[i]
        epsilon = all_epsilon[i]
        rdot = all_rdot[i]
        sigma_r = all_sigma_r[i]
        sigma_beta = all_sigma_beta[i]
        sigma_epsilon = all_sigma_epsilon[i]
        sigma_rdot = all_sigma_rdot[i]
        rho = all_rho[i]
        cos_beta = math.cos(beta)
        sin_beta = math.sin(beta)
        cos_epsilon = math.cos(epsilon)
        sin_epsilon = math.sin(epsilon)
        attenuation_beta = math.exp(-0.5 * sigma_beta**2)
        attenuation_epsilon = math.exp(-0.5 * sigma_epsilon**2)
        part_0_cos_epsilon_sin_beta = attenuation_beta * attenuation_epsilon * r
        shortfall_beta = -math.expm1(-0.5 * sigma_beta**2)
        shortfall_epsilon = -math.expm1(-0.5 * sigma_epsilon**2)
        attenuation_epsilon_squared = attenuation_epsilon**2
        attenuation_epsilon_squared_squared = attenuation_epsilon_squared**2
        sum_1 = 1.0 + attenuation_epsilon_squared_squared
        sum_2 = 1.0 + attenuation_beta * sum_1 + attenuation_epsilon_squared_squared
        sum_3 = 1.0 + attenuation_beta * sum_2 + attenuation_epsilon_squared_squared
        r_squared = r**2
        sigma_r_squared = sigma_r**2
        sum_4 = 0.25 * r_squared + 0.25 * sigma_r_squared
        sum_5 = 1.0 + attenuation_beta * sum_3 + attenuation_epsilon_squared_squared
        part_00_cos_beta2_cos_epsilon2 = shortfall_beta * sum_4 * sum_5
        sum_6 = 1.0 + attenuation_epsilon
        sum_7 = 1.0 + attenuation_beta * sum_6 + attenuation_epsilon
        sum_8 = 1.0 + attenuation_beta + attenuation_epsilon * sum_7
        product_1 = attenuation_epsilon * sum_6
        sum_9 = 1.0 + attenuation_beta * sum_8 + product_1
        sum_10 = 1.0 + attenuation_beta * (1.0 + attenuation_beta) + attenuation_epsilon * sum_9
        product_2 = attenuation_epsilon * (1.0 + product_1)
        sum_11 = 1.0 + attenuation_beta * sum_10 + product_2
        part_00_cos_beta2_sin_epsilon2 = shortfall_beta * shortfall_epsilon * sum_11 * sum_4
        attenuation_beta_squared = attenuation_beta**2
        attenuation_beta_squared_squared = attenuation_beta_squared**2
        sum_12 = 2.0 * attenuation_epsilon + 2.0 * shortfall_epsilon
        shortfall_epsilon_squared = shortfall_epsilon**2
        sum_13 = attenuation_epsilon * sum_12 + 0.5 * shortfall_epsilon_squared
        sum_14 = 4.0 * attenuation_epsilon + 4.0 * shortfall_epsilon
        sum_15 = attenuation_epsilon * sum_14 + shortfall_epsilon_squared
        sum_16 = 2.0 * attenuation_epsilon + 4.0 * shortfall_epsilon
        product_3 = shortfall_beta * sum_16
        sum_17 = attenuation_beta * sum_16 + product_3
        sum_18 = 6.0 * shortfall_beta + 8.0 * attenuation_beta
        sum_19 = attenuation_epsilon * sum_17 + shortfall_epsilon_squared * sum_18
        sum_20 = 0.5 * attenuation_epsilon + shortfall_epsilon
        shortfall_beta_squared = shortfall_beta**2
        sum_21 = 1.5 * shortfall_epsilon_squared + attenuation_epsilon * sum_20
        sum_22 = attenuation_beta * sum_19 + shortfall_beta_squared * sum_21
        sum_23 = 4.0 * shortfall_beta + 6.0 * attenuation_beta
        product_4 = shortfall_epsilon * shortfall_epsilon_squared
        sum_24 = attenuation_beta * sum_23 + shortfall_beta_squared
        sum_25 = attenuation_epsilon * sum_22 + product_4 * sum_24
        sum_26 = 1.5 * attenuation_beta + shortfall_beta
        shortfall_epsilon_squared_squared = shortfall_epsilon_squared**2
        sum_27 = attenuation_beta * sum_26 + 0.25 * shortfall_beta_squared
        sum_28 = attenuation_epsilon * sum_25 + shortfall_epsilon_squared_squared * sum_27
        sum_29 = (
            attenuation_beta * attenuation_beta_squared * shortfall_epsilon_squared * sum_15
            + shortfall_beta * sum_28
        )
        sum_30 = attenuation_beta_squared_squared * shortfall_epsilon_squared * sum_13 + shortfall_beta * sum_29
        sum_31 = 0.25 + 0.25 * attenuation_epsilon_squared_squared
        sum_32 = 0.25 + attenuation_beta_squared_squared * sum_31 + 0.25 * attenuation_epsilon_squared_squared
        part_00_cos_epsilon2_sin_beta2 = r_squared * sum_30 + sigma_r_squared * sum_32
        sum_33 = 1.0 + attenuation_beta_squared_squared * sum_6 + attenuation_epsilon
        sum_34 = 1.0 + attenuation_beta_squared_squared + attenuation_epsilon * sum_33
        sum_35 = 1.0 + attenuation_beta_squared_squared + attenuation_epsilon * sum_34
        part_00_sin_beta2_sin_epsilon2 = shortfall_epsilon * sum_35 * sum_4
        sum_36 = 4.0 * attenuation_epsilon + 8.0 * shortfall_epsilon
        sum_37 = attenuation_beta * sum_36 + product_3
        sum_38 = 2.0 * shortfall_beta + 4.0 * attenuation_beta
        sum_39 = attenuation_epsilon * sum_37 + shortfall_epsilon_squared * sum_38
        sum_40 = 4.0 * attenuation_beta_squared * shortfall_epsilon_squared - shortfall_beta * sum_39
        sum_41 = 4.0 * attenuation_beta_squared * product_4 + attenuation_epsilon * sum_40
        sum_42 = attenuation_beta_squared * shortfall_epsilon_squared_squared + attenuation_epsilon * sum_41
        sum_43 = 0.5 * attenuation_beta_squared * sigma_r_squared * sum_1 + 0.5 * r_squared * sum_42
        part_01_cos_beta_cos_epsilon2_sin_beta = attenuation_beta_squared * sum_43
        sum_44 = 1.0 + product_2
        sum_45 = 0.5 * r_squared + 0.5 * sigma_r_squared
        part_01_cos_beta_sin_beta_sin_epsilon2 = attenuation_beta_squared_squared * shortfall_epsilon * sum_44 * sum_45
        sum_46 = attenuation_epsilon_squared * sigma_r_squared - r_squared * shortfall_epsilon * sum_6
        part_02_cos_epsilon_sin_beta_sin_epsilon = attenuation_beta * attenuation_epsilon_squared * sum_46
        sum_47 = r * rho * sigma_rdot + rdot * sigma_r
        part_03_cos_epsilon_sin_beta = attenuation_beta * attenuation_epsilon * sigma_r * sum_47
        part_22_cos_epsilon2 = shortfall_epsilon * sum_44 * sum_45
        sum_48 = 1.0 + attenuation_epsilon * (2.0 + attenuation_epsilon)
        sum_49 = 0.5 + 0.5 * attenuation_epsilon_squared_squared
        part_22_sin_epsilon2 = 0.5 * r_squared * shortfall_epsilon_squared * sum_48 + sigma_r_squared * sum_49
        part_23_sin_epsilon = attenuation_epsilon * sigma_r * sum_47
        cos_beta_squared = cos_beta**2
        cos_epsilon_squared = cos_epsilon**2
        sin_epsilon_squared = sin_epsilon**2
        sum_50 = (
            cos_epsilon_squared * part_00_cos_beta2_cos_epsilon2
            + part_00_cos_beta2_sin_epsilon2 * sin_epsilon_squared
        )
        sum_51 = (
            cos_epsilon_squared * part_00_cos_epsilon2_sin_beta2
            + part_00_sin_beta2_sin_epsilon2 * sin_epsilon_squared
        )
        sin_beta_squared = sin_beta**2
        sum_52 = (
            cos_epsilon_squared * part_01_cos_beta_cos_epsilon2_sin_beta
            + part_01_cos_beta_sin_beta_sin_epsilon2 * sin_epsilon_squared
        )
        sigma_rdot_squared = sigma_rdot**2
        sum_53 = rdot**2 + (1.0 + rho**2) * sigma_rdot_squared
        sum_54 = 2.0 * r * rdot * rho * sigma_rdot + sigma_r * sum_53
        mean[i, 0] = cos_epsilon * part_0_cos_epsilon_sin_beta * sin_beta
        mean[i, 1] = cos_beta * cos_epsilon * part_0_cos_epsilon_sin_beta
        mean[i, 2] = attenuation_epsilon * r * sin_epsilon
        mean[i, 3] = r * rdot + rho * sigma_r * sigma_rdot
        covariance[i, 0, 0] = cos_beta_squared * sum_50 + sin_beta_squared * sum_51
        covariance[i, 0, 1] = cos_beta * sin_beta * sum_52
        covariance[i, 0, 2] = cos_epsilon * part_02_cos_epsilon_sin_beta_sin_epsilon * sin_beta * sin_epsilon
        covariance[i, 0, 3] = cos_epsilon * part_03_cos_epsilon_sin_beta * sin_beta
        covariance[i, 1, 0] = covariance[i, 0, 1]
        covariance[i, 1, 1] = cos_beta_squared * sum_51 + sin_beta_squared * sum_50
        covariance[i, 1, 2] = cos_beta * cos_epsilon * part_02_cos_epsilon_sin_beta_sin_epsilon * sin_epsilon
        covariance[i, 1, 3] = cos_beta * cos_epsilon * part_03_cos_epsilon_sin_beta
        covariance[i, 2, 0] = covariance[i, 0, 2]
        covariance[i, 2, 1] = covariance[i, 1, 2]
        covariance[i, 2, 2] = (
            cos_epsilon_squared * part_22_cos_epsilon2
            + part_22_sin_epsilon2 * sin_epsilon_squared
        )
        covariance[i, 2, 3] = part_23_sin_epsilon * sin_epsilon
        covariance[i, 3, 0] = covariance[i, 0, 3]
        covariance[i, 3, 1] = covariance[i, 1, 3]
        covariance[i, 3, 2] = covariance[i, 2, 3]
        covariance[i, 3, 3] = r_squared * sigma_rdot_squared + sigma_r * sum_54
