"""Conversions as loops over given[symbol][plot]; mean[plot, n] and covariance[plot, n, n] are filled, arrays or dictionaries.

Written by radartrack regenerate, generator 1, derivation 03cbbe67befe6568; not to be edited.
"""

import math
from collections.abc import MutableMapping, Sequence

Floats = Sequence[float]
Filled = MutableMapping[tuple[int, ...], float]


def bistatic_linear(
    given: Sequence[Floats],
    mean: Filled,
    covariance: Filled,
) -> None:
    """Conversion bistatic, linear.

    Mean: map from the measured quantities to coordinates. Covariance: covariance of the linearised
    conversion.
    """
    for i in range(len(given[0])):
        path = given[0][i]
        beta = given[1][i]
        baseline = given[2][i]
        sigma_path = given[3][i]
        sigma_beta = given[4][i]
        rho = given[5][i]
        term_1 = 1.0 / path
        baseline_per_path = baseline * term_1
        cos_beta = math.cos(beta)
        divisor_1 = 2.0 - 2.0 * baseline_per_path * cos_beta
        sigma_path_per_path = sigma_path * term_1
        sum_1 = 1.0 - baseline_per_path
        term_2 = 1.0 / divisor_1
        sum_2 = 1.0 + baseline_per_path
        sin_beta = math.sin(beta)
        sum_3 = baseline_per_path - 2.0 * cos_beta
        sum_4 = 1.0 + baseline_per_path * sum_3
        sum_4_squared = sum_4**2
        sigma_path_per_path_squared = sigma_path_per_path**2
        term_3 = (baseline_per_path - 1.0)**2
        sum_5 = (
            4.0 * sigma_beta * sin_beta * sum_2 * term_3
            - 8.0 * cos_beta * rho * sigma_path_per_path * sum_1 * sum_4
        )
        term_4 = 1.0 / (divisor_1**2)**2
        path_squared = path**2
        sum_6 = (
            4.0 * cos_beta**2 * sigma_path_per_path_squared * sum_4_squared
            + sigma_beta * sin_beta * sum_2 * sum_5
        )
        sum_7 = baseline_per_path - cos_beta
        sum_8 = (
            4.0 * sigma_beta * sin_beta * sum_2 * sum_7 * term_3
            - 4.0 * (1.0 + cos_beta * sum_3) * rho * sigma_path_per_path * sum_1 * sum_4
        )
        sum_9 = (
            4.0 * cos_beta * sigma_path_per_path_squared * sin_beta * sum_4_squared
            + sigma_beta * sum_2 * sum_8
        )
        sin_beta_squared = sin_beta**2
        sum_10 = baseline_per_path - 4.0 * cos_beta
        sum_11 = 6.0 - 4.0 * sin_beta_squared + baseline_per_path * sum_10
        sum_12 = baseline_per_path * sum_11 - 4.0 * cos_beta
        sum_13 = 1.0 + baseline_per_path * sum_12
        sum_14 = (
            4.0 * sigma_beta * sum_2 * sum_7 * term_3
            - 8.0 * rho * sigma_path_per_path * sin_beta * sum_1 * sum_4
        )
        sum_15 = (
            4.0 * sigma_path_per_path_squared * sin_beta_squared * sum_13
            + sigma_beta * sum_14 * sum_2 * sum_7
        )
        mean[i, 0] = cos_beta * path * sum_1 * sum_2 * term_2
        mean[i, 1] = path * sin_beta * sum_1 * sum_2 * term_2
        covariance[i, 0, 0] = path_squared * sum_6 * term_4
        covariance[i, 0, 1] = path_squared * sum_9 * term_4
        covariance[i, 1, 0] = covariance[i, 0, 1]
        covariance[i, 1, 1] = path_squared * sum_15 * term_4


def bistatic_second_order(
    given: Sequence[Floats],
    mean: Filled,
    covariance: Filled,
) -> None:
    """Conversion bistatic, second_order.

    Mean: map from the measured quantities to coordinates less the bias of the plain conversion to second
    order. Covariance: covariance of the conversion's quadratic Taylor polynomial.
    """
    for i in range(len(given[0])):
        path = given[0][i]
        beta = given[1][i]
        baseline = given[2][i]
        sigma_path = given[3][i]
        sigma_beta = given[4][i]
        rho = given[5][i]
        term_1 = 1.0 / path
        baseline_per_path = baseline * term_1
        cos_beta = math.cos(beta)
        divisor_1 = 2.0 - 2.0 * baseline_per_path * cos_beta
        sigma_path_per_path = sigma_path * term_1
        product_1 = baseline_per_path * cos_beta
        divisor_1_2 = product_1 - 1.0
        divisor_2 = divisor_1_2
        sum_1 = 1.0 - baseline_per_path
        term_2 = 1.0 / divisor_1
        sum_2 = 1.0 + baseline_per_path
        sum_3 = baseline_per_path * (1.0 + product_1) - 3.0 * cos_beta
        sum_4 = 1.0 + baseline_per_path * sum_3
        sin_beta = math.sin(beta)
        cos_beta_squared = cos_beta**2
        sum_5 = 2.0 - cos_beta_squared
        product_2 = baseline_per_path * sum_5
        sum_6 = product_2 - cos_beta
        sum_7 = 0.25 * sigma_beta * sum_1 * sum_2 * sum_6 - 0.5 * rho * sigma_path_per_path * sin_beta * sum_4
        baseline_per_path_squared = baseline_per_path**2
        sigma_path_per_path_squared = sigma_path_per_path**2
        sin_beta_squared = sin_beta**2
        term_3 = 1.0 / (divisor_1_2 * divisor_1_2**2)
        sum_8 = (
            0.5 * baseline_per_path_squared * cos_beta * sigma_path_per_path_squared * sin_beta_squared
            - sigma_beta * sum_7
        )
        sum_9 = cos_beta * sum_1 * sum_2 * term_2 - sum_8 * term_3
        sum_10 = 2.0 * baseline_per_path - cos_beta
        sum_11 = 1.0 - baseline_per_path * sum_10
        sum_12 = 3.0 * cos_beta_squared + (product_2 - 3.0 * cos_beta) * baseline_per_path
        sum_13 = baseline_per_path * sum_12 - cos_beta
        sum_14 = 0.5 * rho * sigma_path_per_path * sum_13 + 0.25 * sigma_beta * sin_beta * sum_1 * sum_11 * sum_2
        sum_15 = (
            0.5 * baseline_per_path_squared * sigma_path_per_path_squared * sin_beta * sin_beta_squared
            + sigma_beta * sum_14
        )
        sum_16 = sin_beta * sum_1 * sum_2 * term_2 - sum_15 * term_3
        term_4 = 1.0 / (divisor_1**2)**2
        term_5 = 1.0 / divisor_2**2
        path_squared = path**2
        sum_17 = 1.0 - sin_beta_squared
        product_3 = baseline_per_path * sum_17
        sum_18 = 5.0 - 6.0 * sin_beta_squared - (2.0 * cos_beta + product_3) * baseline_per_path
        sum_19 = 4.0 * cos_beta + baseline_per_path * sum_18
        sum_20 = 11.0 - 9.0 * sin_beta_squared - baseline_per_path * sum_19
        sum_21 = baseline_per_path * sum_20 - 6.0 * cos_beta
        sum_22 = 1.0 + baseline_per_path * sum_21
        sum_23 = divisor_1_2
        sum_23_squared = sum_23**2
        sum_24 = baseline_per_path - 2.0 * cos_beta
        sum_25 = 1.0 + baseline_per_path * sum_24
        sigma_beta_squared = sigma_beta**2
        sum_26 = 8.0 * cos_beta * sum_23_squared * sum_25 + 8.0 * sigma_beta_squared * sum_4 * sum_6
        sum_27 = (4.0 + 2.0 * sin_beta_squared) * cos_beta + product_3
        sum_28 = 7.0 - 8.0 * sin_beta_squared - baseline_per_path * sum_27
        sum_29 = baseline_per_path * sum_28 + (6.0 + 2.0 * sin_beta_squared) * cos_beta
        sum_30 = 13.0 - 11.0 * sin_beta_squared - baseline_per_path * sum_29
        sum_31 = baseline_per_path * sum_30 - 6.0 * cos_beta
        sum_32 = 1.0 + baseline_per_path * sum_31
        sum_33 = 3.0 - 3.0 * sin_beta_squared - baseline_per_path * (cos_beta + product_3)
        sum_34 = baseline_per_path * sum_33 - cos_beta
        sum_35 = (
            16.0 * baseline_per_path_squared * sigma_path_per_path * sin_beta * sum_34
            - 4.0 * rho * sigma_beta * sum_32
        )
        sum_36 = sigma_path_per_path * sin_beta * sum_35 + sum_1 * sum_2 * sum_26
        sum_37 = rho * sum_36 - 4.0 * sigma_beta * sigma_path_per_path * sin_beta * sum_22
        sum_2_squared = sum_2**2
        term_6 = (baseline_per_path - 1.0)**2
        sum_38 = 1.0 + (product_3 - 2.0 * cos_beta) * baseline_per_path
        sum_39 = 4.0 * sigma_beta * sin_beta * sum_2_squared * sum_38 * term_6 - sigma_path_per_path * sum_37
        sum_40 = (
            2.0 * (cos_beta - baseline_per_path * sum_5)**2 * sigma_beta * sigma_beta_squared * sum_2_squared * term_6
            + sin_beta * sum_39
        )
        sum_25_squared = sum_25**2
        baseline_per_path_squared_squared = baseline_per_path_squared**2
        sin_beta_squared_squared = sin_beta_squared**2
        sum_41 = (
            4.0 * cos_beta_squared * sum_23_squared * sum_25_squared
            + 8.0 * (1.0 - sin_beta) * baseline_per_path_squared_squared * sigma_path_per_path_squared * (1.0 + sin_beta) * sin_beta_squared_squared
        )
        sum_42 = sigma_path_per_path_squared * sum_41 + sigma_beta * sum_40
        sum_43 = 3.0 - 4.0 * sin_beta_squared - (1.0 + 2.0 * sin_beta_squared) * baseline_per_path * cos_beta
        sum_44 = (3.0 - 6.0 * sin_beta_squared) * cos_beta - baseline_per_path * sum_43
        sum_45 = 1.0 - 2.0 * sin_beta_squared - baseline_per_path * sum_44
        sum_46 = (
            4.0 * (1.0 + cos_beta * sum_24) * sum_1 * sum_2 * sum_23_squared * sum_25
            + 8.0 * baseline_per_path_squared * sigma_path_per_path_squared * sin_beta_squared * sum_45
        )
        sum_47 = cos_beta * (3.0 + sin_beta_squared) - (2.0 + 2.0 * sin_beta_squared) * baseline_per_path
        sum_48 = 2.0 * sin_beta_squared + baseline_per_path * sum_47
        sum_49 = baseline_per_path * sum_48 - cos_beta
        sum_50 = baseline_per_path - cos_beta
        sum_51 = 4.0 * sum_23_squared * sum_50 - 2.0 * sigma_beta_squared * sum_49
        sum_52 = 3.0 * baseline_per_path - 2.0 * cos_beta
        sum_53 = cos_beta * (8.0 + cos_beta * sum_52) - 4.0 * baseline_per_path
        sum_54 = 13.0 - 10.0 * cos_beta_squared + baseline_per_path * sum_53
        sum_55 = (14.0 - 2.0 * cos_beta_squared) * cos_beta - baseline_per_path * sum_54
        sum_56 = 2.0 - baseline_per_path * sum_55 + 11.0 * cos_beta_squared
        sum_57 = cos_beta * sum_56 - 4.0 * baseline_per_path * baseline_per_path_squared
        sum_58 = baseline_per_path * sum_57 - 6.0 * cos_beta_squared
        rho_squared = rho**2
        sum_59 = baseline_per_path * sum_58 + cos_beta
        sum_60 = 4.0 * sum_13 * sum_4 - 4.0 * rho_squared * sum_59
        sum_61 = sigma_path_per_path_squared * sum_60 + sum_2_squared * sum_51 * term_6
        sum_62 = 3.0 + 2.0 * baseline_per_path * cos_beta + 2.0 * sin_beta_squared
        sum_63 = 1.0 + sin_beta_squared * sum_62
        sum_64 = (4.0 + 12.0 * sin_beta_squared) * cos_beta - baseline_per_path * sum_63
        sum_65 = 6.0 - baseline_per_path * sum_64 + (1.0 - 6.0 * sin_beta_squared) * sin_beta_squared
        sum_66 = (4.0 - 4.0 * sin_beta_squared) * cos_beta - baseline_per_path * sum_65
        sum_67 = 1.0 - 2.0 * sin_beta_squared - baseline_per_path * sum_66
        sum_68 = sin_beta * sum_61 - 4.0 * rho * sigma_beta * sigma_path_per_path * sum_1 * sum_2 * sum_67
        sum_69 = sigma_beta * sum_68 - rho * sigma_path_per_path * sum_46
        product_4 = 8.0 * baseline_per_path_squared_squared * sigma_path_per_path_squared * sin_beta_squared_squared
        sum_70 = 4.0 * sum_23_squared * sum_25_squared + product_4
        sum_71 = cos_beta * sigma_path_per_path_squared * sin_beta * sum_70 + sigma_beta * sum_69
        sum_72 = baseline_per_path * (1.0 + sin_beta_squared) - 3.0 * cos_beta
        sum_73 = 3.0 - 3.0 * sin_beta_squared + baseline_per_path * sum_72
        sum_74 = baseline_per_path * sum_73 - cos_beta
        sum_75 = (
            8.0 * sum_1 * sum_2 * sum_23_squared * sum_25 * sum_50
            - 16.0 * baseline_per_path_squared * sigma_path_per_path_squared * sin_beta_squared * sum_74
        )
        sum_76 = 4.0 * baseline_per_path - 4.0 * cos_beta
        sum_77 = 3.0 - baseline_per_path * sum_76 + sin_beta_squared
        sum_78 = baseline_per_path * sum_77 - 2.0 * cos_beta
        sum_79 = 1.0 - baseline_per_path * sum_78
        sum_80 = 2.0 * sigma_beta_squared * sin_beta_squared * sum_79 + 4.0 * sum_23_squared * sum_50**2
        sum_81 = (
            8.0 * rho * sigma_beta * sigma_path_per_path * sin_beta * sum_1 * sum_11 * sum_13
            + sum_2 * sum_80 * term_6
        )
        sum_82 = 5.0 * baseline_per_path - 2.0 * cos_beta
        sum_83 = cos_beta * (10.0 + cos_beta * sum_82) - 12.0 * baseline_per_path
        sum_84 = 33.0 - 12.0 * cos_beta_squared + baseline_per_path * sum_83
        sum_85 = (20.0 - 2.0 * cos_beta_squared) * cos_beta - baseline_per_path * sum_84
        sum_86 = 2.0 + 14.0 * baseline_per_path_squared + cos_beta * sum_85
        sum_87 = 6.0 - 8.0 * baseline_per_path_squared
        sum_88 = baseline_per_path * sum_87 + cos_beta * sum_86
        sum_89 = 2.0 - baseline_per_path * sum_88 + (2.0 + 11.0 * cos_beta_squared) * cos_beta_squared
        sum_90 = baseline_per_path * sum_89 - 6.0 * cos_beta * cos_beta_squared
        sum_91 = baseline_per_path * sum_90 + cos_beta_squared
        sum_92 = 4.0 * (cos_beta - baseline_per_path * sum_12)**2 + 4.0 * rho_squared * sum_91
        sum_93 = sigma_path_per_path_squared * sum_92 + sum_2 * sum_81
        sum_94 = sigma_beta * sum_93 - rho * sigma_path_per_path * sin_beta * sum_75
        sum_95 = (6.0 - 4.0 * sin_beta_squared) * cos_beta - baseline_per_path * sum_17
        sum_96 = 15.0 - baseline_per_path * sum_95 - (18.0 - 4.0 * sin_beta_squared) * sin_beta_squared
        sum_97 = (20.0 - 12.0 * sin_beta_squared) * cos_beta - baseline_per_path * sum_96
        sum_98 = 15.0 - 13.0 * sin_beta_squared - baseline_per_path * sum_97
        sum_99 = baseline_per_path * sum_98 - 6.0 * cos_beta
        sum_100 = 4.0 + 4.0 * baseline_per_path * sum_99 + product_4
        sum_101 = sigma_path_per_path_squared * sin_beta_squared * sum_100 + sigma_beta * sum_94
        mean[i, 0] = path * sum_9
        mean[i, 1] = path * sum_16
        covariance[i, 0, 0] = path_squared * sum_42 * term_4 * term_5
        covariance[i, 0, 1] = path_squared * sum_71 * term_4 * term_5
        covariance[i, 1, 0] = covariance[i, 0, 1]
        covariance[i, 1, 1] = path_squared * sum_101 * term_4 * term_5


def bistatic_averaged(
    given: Sequence[Floats],
    mean: Filled,
    covariance: Filled,
) -> None:
    """Conversion bistatic, averaged.

    Mean: map from the measured quantities to coordinates less the bias of the plain conversion, averaged over
    the truth, to fourth order. Covariance: covariance of the plain conversion, averaged over the truth, to
    fourth order, completed to a sum of squares.
    """
    for i in range(len(given[0])):
        path = given[0][i]
        beta = given[1][i]
        baseline = given[2][i]
        sigma_path = given[3][i]
        sigma_beta = given[4][i]
        rho = given[5][i]
        term_1 = 1.0 / path
        baseline_per_path = baseline * term_1
        cos_beta = math.cos(beta)
        product_1 = -2.0 * baseline_per_path * cos_beta
        divisor_1 = 2.0 + product_1
        sigma_path_per_path = sigma_path * term_1
        sum_1 = 1.0 - baseline_per_path
        sum_2 = 1.0 + baseline_per_path
        sigma_path_per_path_squared = sigma_path_per_path**2
        sin_beta = math.sin(beta)
        sin_beta_squared = sin_beta**2
        sum_3 = 1.0 - sin_beta_squared
        sum_4 = 2.0 - 2.0 * sin_beta_squared - baseline_per_path * cos_beta * sum_3
        baseline_per_path_squared = baseline_per_path**2
        sum_5 = (
            16.0 * baseline_per_path * sum_4
            - 144.0 * cos_beta * sigma_path_per_path_squared
            - 16.0 * cos_beta
        )
        cos_beta_squared = cos_beta**2
        product_2 = (3.0 - cos_beta_squared) * baseline_per_path
        sum_6 = 1.0 + (product_2 - 3.0 * cos_beta) * cos_beta
        product_3 = baseline_per_path * cos_beta
        sum_7 = product_3 - 1.0
        sum_7_squared = sum_7**2
        sum_8 = baseline_per_path * (1.0 + product_3) - 3.0 * cos_beta
        sum_9 = 1.0 + baseline_per_path * sum_8
        sum_10 = (
            144.0 * baseline_per_path_squared * sigma_path_per_path_squared * sum_6
            + 16.0 * sum_7_squared * sum_9
        )
        product_4 = (20.0 - cos_beta_squared) * baseline_per_path
        sum_11 = 20.0 + (product_4 - 11.0 * cos_beta) * cos_beta
        sum_12 = cos_beta * sum_11 - 24.0 * baseline_per_path
        sum_13 = 8.0 - 11.0 * cos_beta_squared + baseline_per_path * sum_12
        sigma_beta_squared = sigma_beta**2
        sum_14 = baseline_per_path * sum_13 - cos_beta
        product_5 = (2.0 - cos_beta_squared) * baseline_per_path
        sum_15 = 8.0 * (product_5 - cos_beta) * sum_7_squared - 6.0 * sigma_beta_squared * sum_14
        product_6 = (6.0 - cos_beta_squared) * baseline_per_path
        sum_16 = 29.0 - 3.0 * cos_beta_squared - (product_6 - 11.0 * cos_beta) * baseline_per_path
        sum_17 = cos_beta * sum_16 - 18.0 * baseline_per_path
        sum_18 = 7.0 - 17.0 * cos_beta_squared + baseline_per_path * sum_17
        sum_19 = baseline_per_path * sum_18 - 5.0 * cos_beta
        sum_20 = 1.0 + baseline_per_path * sum_19
        sum_21 = 4.0 * baseline_per_path - 3.0 * cos_beta
        sum_22 = cos_beta * (13.0 + cos_beta * sum_21) - 6.0 * baseline_per_path
        sum_23 = 7.0 - 9.0 * cos_beta_squared + baseline_per_path * sum_22
        rho_squared = rho**2
        sum_24 = cos_beta * sum_23 - 6.0 * baseline_per_path
        sum_25 = (
            24.0 * rho * sigma_beta * sin_beta * sum_20
            + (24.0 + 48.0 * rho_squared) * baseline_per_path_squared * sigma_path_per_path * sum_24
        )
        sum_26 = sigma_path_per_path * sum_25 + sum_1 * sum_15 * sum_2
        sum_27 = sigma_beta * sum_26 - rho * sigma_path_per_path * sin_beta * sum_10
        term_2 = 1.0 / (divisor_1**2)**2
        sum_28 = (
            baseline_per_path_squared * sigma_path_per_path_squared * sin_beta_squared * sum_5
            + sigma_beta * sum_27
        )
        term_3 = 1.0 / divisor_1
        sum_29 = cos_beta * sum_1 * sum_2 - sum_28 * term_2
        sum_30 = baseline_per_path * sum_3 - 2.0 * cos_beta
        sum_31 = 16.0 + 144.0 * sigma_path_per_path_squared + 16.0 * baseline_per_path * sum_30
        sum_32 = 8.0 * baseline_per_path - cos_beta
        sum_33 = cos_beta * (20.0 + cos_beta * sum_32) - 24.0 * baseline_per_path
        sum_34 = 20.0 - 11.0 * cos_beta_squared + baseline_per_path * sum_33
        sum_35 = baseline_per_path * sum_34 - 11.0 * cos_beta
        sum_36 = 1.0 - baseline_per_path * sum_35
        sum_37 = 2.0 * baseline_per_path - cos_beta
        sum_38 = 1.0 - baseline_per_path * sum_37
        sum_39 = 8.0 * sum_38 * sum_7_squared - 6.0 * sigma_beta_squared * sum_36
        sum_40 = cos_beta * (5.0 + cos_beta * sum_37) - 4.0 * baseline_per_path
        sum_41 = 1.0 - 3.0 * cos_beta_squared + baseline_per_path * sum_40
        sum_42 = (
            sum_1 * sum_2 * sum_39
            - (72.0 + 144.0 * rho_squared) * baseline_per_path_squared * sigma_path_per_path_squared * sum_41
        )
        sum_43 = 31.0 - 3.0 * cos_beta_squared - (product_4 - 19.0 * cos_beta) * baseline_per_path
        sum_44 = cos_beta * sum_43 - 32.0 * baseline_per_path
        sum_45 = 20.0 - 24.0 * baseline_per_path_squared - cos_beta * sum_44
        sum_46 = (21.0 - 17.0 * cos_beta_squared) * cos_beta - baseline_per_path * sum_45
        sum_47 = baseline_per_path * sum_46 - 5.0 * cos_beta_squared
        sum_48 = baseline_per_path * sum_47 + cos_beta
        sum_49 = 24.0 * rho * sigma_beta * sigma_path_per_path * sum_48 + sin_beta * sum_42
        sum_50 = baseline_per_path * (3.0 + sin_beta_squared) - 3.0 * cos_beta
        sum_51 = 3.0 * cos_beta_squared + (product_5 - 3.0 * cos_beta) * baseline_per_path
        sum_52 = baseline_per_path * sum_51 - cos_beta
        sum_53 = (
            144.0 * baseline_per_path_squared * sigma_path_per_path_squared * sin_beta_squared * sum_50
            + 16.0 * sum_52 * sum_7_squared
        )
        sum_54 = rho * sigma_path_per_path * sum_53 + sigma_beta * sum_49
        sum_55 = (
            baseline_per_path_squared * sigma_path_per_path_squared * sin_beta * sin_beta_squared * sum_31
            + sigma_beta * sum_54
        )
        sum_56 = sin_beta * sum_1 * sum_2 + sum_55 * term_2
        term_4 = 1.0 / ((divisor_1**2)**2)**2
        path_squared = path**2
        sum_57 = (2.0 - 3.0 * sin_beta_squared) * cos_beta - (2.0 - 2.0 * sin_beta_squared) * baseline_per_path
        sum_58 = 3.0 - 9.0 * cos_beta_squared - (product_2 - 9.0 * cos_beta) * baseline_per_path
        sum_59 = cos_beta * sum_58 - 3.0 * baseline_per_path
        sum_60 = 1.0 - 3.0 * cos_beta_squared - baseline_per_path * sum_59
        sum_61 = (
            768.0 * cos_beta * sum_60 * sum_7_squared
            - 4608.0 * baseline_per_path_squared * sigma_path_per_path_squared * sin_beta_squared * sum_57
        )
        sum_7_squared_squared = sum_7_squared**2
        sum_62 = baseline_per_path - 2.0 * cos_beta
        sum_63 = 1.0 + baseline_per_path * sum_62
        sum_64 = (
            128.0 * cos_beta * sum_1 * sum_2 * sum_63 * sum_7_squared_squared
            - baseline_per_path_squared * sigma_path_per_path_squared * sum_61
        )
        sum_2_squared = sum_2**2
        term_5 = (baseline_per_path - 1.0)**2
        sum_65 = 25.0 + sin_beta_squared * (10.0 + sin_beta_squared)
        sum_66 = (40.0 + 8.0 * sin_beta_squared) * cos_beta - baseline_per_path * sum_65
        sum_67 = 6.0 - 18.0 * sin_beta_squared - baseline_per_path * sum_66
        sum_68 = 8.0 * cos_beta + baseline_per_path * sum_67
        sum_69 = 1.0 + baseline_per_path * sum_68
        sum_70 = (40.0 - 7.0 * cos_beta_squared) * baseline_per_path - 22.0 * cos_beta
        sum_71 = cos_beta * (28.0 + cos_beta * sum_70) - 36.0 * baseline_per_path
        sum_72 = 4.0 - 7.0 * cos_beta_squared + baseline_per_path * sum_71
        sum_73 = 32.0 * sum_72 * sum_7_squared - 64.0 * sigma_beta_squared * sin_beta_squared * sum_69
        sum_74 = 2.0 - sin_beta_squared
        sum_75 = 1.0 - sin_beta_squared * sum_74
        sum_76 = (4.0 - 4.0 * sin_beta_squared) * cos_beta - baseline_per_path * sum_75
        sum_77 = 6.0 - 6.0 * sin_beta_squared - baseline_per_path * sum_76
        sum_78 = baseline_per_path * sum_77 - 4.0 * cos_beta
        sum_79 = 1.0 + baseline_per_path * sum_78
        sum_80 = 64.0 * sin_beta_squared * sum_79 - sigma_beta_squared * sum_73
        product_7 = (12.0 - 12.0 * sin_beta_squared) * cos_beta
        sum_81 = 4.0 + 3.0 * sin_beta_squared
        sum_82 = 7.0 - sin_beta_squared * sum_81
        sum_83 = (8.0 - 24.0 * sin_beta_squared) * cos_beta - baseline_per_path * sum_82
        sum_84 = 8.0 + baseline_per_path * sum_83 + (9.0 - 18.0 * sin_beta_squared) * sin_beta_squared
        sum_85 = product_7 - baseline_per_path * sum_84
        sum_86 = 3.0 - 3.0 * sin_beta_squared - baseline_per_path * sum_85
        sum_87 = 2.0 * baseline_per_path - 3.0 * cos_beta
        sum_88 = 7.0 - 3.0 * cos_beta_squared - (product_5 - 4.0 * cos_beta) * baseline_per_path
        sum_89 = cos_beta * sum_88 - 4.0 * baseline_per_path
        sum_90 = baseline_per_path * sum_89 - 4.0 * cos_beta_squared
        sum_91 = baseline_per_path * sum_90 + cos_beta
        sum_92 = 19.0 - (16.0 + 3.0 * sin_beta_squared) * sin_beta_squared
        sum_93 = (32.0 - 60.0 * sin_beta_squared) * cos_beta - baseline_per_path * sum_92
        sum_94 = 4.0 - baseline_per_path * sum_93 - (45.0 - 45.0 * sin_beta_squared) * sin_beta_squared
        sum_95 = baseline_per_path * sum_94 + product_7
        sum_96 = 3.0 - 3.0 * sin_beta_squared - baseline_per_path * sum_95
        sum_97 = (
            1024.0 * (1.0 + cos_beta * sum_87) * rho * sigma_beta * sum_91
            + 512.0 * sigma_path_per_path * sin_beta * sum_96
        )
        sum_98 = 105.0 - 12.0 * cos_beta_squared
        sum_99 = 128.0 - 46.0 * cos_beta_squared
        product_8 = (4.0 - cos_beta_squared) * baseline_per_path
        sum_100 = 72.0 - 9.0 * cos_beta_squared - (product_8 - 10.0 * cos_beta) * baseline_per_path
        sum_101 = cos_beta * sum_100 - 38.0 * baseline_per_path
        sum_102 = 93.0 - 4.0 * baseline_per_path_squared - cos_beta * sum_101
        sum_103 = cos_beta * sum_99 - baseline_per_path * sum_102
        sum_104 = 114.0 - cos_beta_squared * sum_98 + baseline_per_path * sum_103
        sum_105 = 74.0 - 28.0 * baseline_per_path_squared
        sum_106 = cos_beta * sum_104 - baseline_per_path * sum_105
        sum_107 = 2.0 - baseline_per_path * sum_106 + (66.0 - 36.0 * cos_beta_squared) * cos_beta_squared
        sum_108 = 7.0 - 22.0 * baseline_per_path_squared
        sum_109 = baseline_per_path * sum_108 + cos_beta * sum_107
        sum_110 = 1.0 - baseline_per_path * sum_109 + (10.0 + 13.0 * cos_beta_squared) * cos_beta_squared
        sum_111 = baseline_per_path * sum_110 - 8.0 * cos_beta * cos_beta_squared
        sum_112 = baseline_per_path * sum_111 + cos_beta_squared
        sum_113 = 102.0 - 30.0 * cos_beta_squared
        sum_114 = 7.0 * baseline_per_path - 14.0 * cos_beta
        sum_115 = cos_beta * (72.0 + cos_beta * sum_114) - 11.0 * baseline_per_path
        sum_116 = 111.0 - 88.0 * cos_beta_squared + baseline_per_path * sum_115
        sum_117 = cos_beta * sum_113 - baseline_per_path * sum_116
        sum_118 = 24.0 - 50.0 * baseline_per_path_squared - cos_beta * sum_117
        sum_119 = (27.0 - 77.0 * cos_beta_squared) * cos_beta - baseline_per_path * sum_118
        sum_120 = 2.0 - 11.0 * baseline_per_path_squared - cos_beta * sum_119
        sum_121 = baseline_per_path * sum_120 + (18.0 - 42.0 * cos_beta_squared) * cos_beta
        sum_122 = 3.0 - 7.0 * cos_beta_squared - baseline_per_path * sum_121
        sum_123 = (
            512.0 * sigma_beta_squared * sum_112
            - baseline_per_path_squared * sigma_path_per_path * sin_beta * sum_97
            + 64.0 * sum_122 * sum_7_squared
        )
        sum_124 = 5.0 * baseline_per_path - 9.0 * cos_beta
        sum_125 = cos_beta * (48.0 + cos_beta * sum_124) - 10.0 * baseline_per_path
        sum_126 = 81.0 - 51.0 * cos_beta_squared + baseline_per_path * sum_125
        sum_127 = (92.0 - 24.0 * cos_beta_squared) * cos_beta - baseline_per_path * sum_126
        sum_128 = 28.0 - 34.0 * baseline_per_path_squared - cos_beta * sum_127
        sum_129 = (11.0 - 36.0 * cos_beta_squared) * cos_beta - baseline_per_path * sum_128
        sum_130 = 1.0 - 6.0 * cos_beta_squared - baseline_per_path * sum_129
        sum_131 = cos_beta * sum_130 - 10.0 * baseline_per_path * baseline_per_path_squared
        sum_132 = (
            512.0 * baseline_per_path_squared * sigma_beta * sigma_path_per_path * sin_beta * sum_131
            - rho * sum_123
        )
        sum_133 = 5.0 * baseline_per_path - 4.0 * cos_beta
        product_9 = cos_beta * sum_133
        sum_134 = cos_beta * (30.0 + product_9) - 7.0 * baseline_per_path
        sum_135 = 63.0 - 50.0 * cos_beta_squared + baseline_per_path * sum_134
        sum_136 = (48.0 - 12.0 * cos_beta_squared) * cos_beta - baseline_per_path * sum_135
        sum_137 = 12.0 - 22.0 * baseline_per_path_squared - cos_beta * sum_136
        sum_138 = (21.0 - 49.0 * cos_beta_squared) * cos_beta - baseline_per_path * sum_137
        sum_139 = 2.0 + 7.0 * baseline_per_path_squared + cos_beta * sum_138
        sum_140 = (18.0 - 30.0 * cos_beta_squared) * cos_beta - baseline_per_path * sum_139
        sum_141 = 3.0 - 5.0 * cos_beta_squared - baseline_per_path * sum_140
        sum_142 = 120.0 - 72.0 * cos_beta_squared
        sum_143 = 204.0 - 21.0 * cos_beta_squared
        sum_144 = 224.0 - 88.0 * cos_beta_squared
        sum_145 = 162.0 - 18.0 * cos_beta_squared - (product_8 - 16.0 * cos_beta) * baseline_per_path
        sum_146 = cos_beta * sum_145 - 80.0 * baseline_per_path
        sum_147 = 192.0 - 4.0 * baseline_per_path_squared - cos_beta * sum_146
        sum_148 = cos_beta * sum_144 - baseline_per_path * sum_147
        sum_149 = 225.0 - cos_beta_squared * sum_143 + baseline_per_path * sum_148
        sum_150 = 128.0 - 64.0 * baseline_per_path_squared
        sum_151 = cos_beta * sum_149 - baseline_per_path * sum_150
        sum_152 = 16.0 - cos_beta_squared * sum_142 + baseline_per_path * sum_151
        sum_153 = 28.0 - 40.0 * baseline_per_path_squared
        sum_154 = cos_beta * sum_152 - baseline_per_path * sum_153
        sum_155 = 4.0 - (2.0 - 22.0 * cos_beta_squared) * cos_beta_squared + baseline_per_path * sum_154
        sum_156 = baseline_per_path * sum_155 - 8.0 * cos_beta * cos_beta_squared
        sum_157 = baseline_per_path * sum_156 + cos_beta_squared
        sum_158 = (
            64.0 * sigma_beta_squared * sum_157
            - 256.0 * baseline_per_path_squared * sigma_path_per_path_squared * sin_beta_squared * sum_86
            - rho * sum_132
            + 64.0 * sum_141 * sum_7_squared
        )
        sum_159 = 7.0 * baseline_per_path - 2.0 * cos_beta
        sum_160 = cos_beta * (34.0 + cos_beta * sum_159) - 18.0 * baseline_per_path
        sum_161 = 37.0 - 25.0 * cos_beta_squared + baseline_per_path * sum_160
        sum_162 = cos_beta * sum_161 - 18.0 * baseline_per_path
        sum_163 = 6.0 - baseline_per_path * sum_162 + 16.0 * cos_beta_squared
        sum_164 = baseline_per_path * sum_163 - 7.0 * cos_beta
        sum_165 = 1.0 - (product_6 - 4.0 * cos_beta) * baseline_per_path
        sum_166 = 128.0 * sum_164 * sum_7_squared + 384.0 * sigma_beta_squared * sum_165 * sum_91
        sum_167 = rho * sigma_beta * sin_beta * sum_1 * sum_166 * sum_2 - sigma_path_per_path * sum_158
        sum_168 = sum_2_squared * sum_80 * term_5 - sigma_path_per_path * sum_167
        sum_169 = sigma_beta * sum_168 - rho * sigma_path_per_path * sin_beta * sum_64
        sum_63_squared = sum_63**2
        sum_170 = 2.0 + (product_2 - 4.0 * cos_beta) * baseline_per_path
        sum_171 = (
            2304.0 * (1.0 - sin_beta) * baseline_per_path_squared * sigma_path_per_path_squared * (1.0 + sin_beta) * sin_beta_squared**2
            + 384.0 * (1.0 - cos_beta) * (1.0 + cos_beta) * cos_beta_squared * sum_170 * sum_7_squared
        )
        sum_172 = (
            64.0 * cos_beta_squared * sum_63_squared * sum_7_squared_squared
            + baseline_per_path_squared * sigma_path_per_path_squared * sum_171
        )
        sum_173 = sigma_path_per_path_squared * sum_172 + sigma_beta * sum_169
        sum_174 = 103.0 - 42.0 * sin_beta_squared
        sum_175 = 62.0 - (77.0 - 18.0 * sin_beta_squared) * sin_beta_squared
        sum_176 = 51.0 - 18.0 * sin_beta_squared - (5.0 + 2.0 * sin_beta_squared) * baseline_per_path * cos_beta
        sum_177 = 33.0 - 7.0 * baseline_per_path * cos_beta - sin_beta_squared * sum_176
        sum_178 = cos_beta * sum_175 - baseline_per_path * sum_177
        sum_179 = 58.0 - baseline_per_path * sum_178 - sin_beta_squared * sum_174
        sum_180 = (27.0 - 30.0 * sin_beta_squared) * cos_beta - baseline_per_path * sum_179
        sum_181 = 5.0 - 5.0 * baseline_per_path * cos_beta - 6.0 * sin_beta_squared
        sum_182 = (
            1920.0
            - 2304.0 * sin_beta_squared
            - 384.0 * baseline_per_path * sum_180
            + 2304.0 * baseline_per_path_squared * sigma_path_per_path_squared * sin_beta_squared * sum_181
        )
        sum_183 = (
            64.0 * (1.0 + cos_beta * sum_62) * sum_1 * sum_2 * sum_63 * sum_7_squared_squared
            + baseline_per_path_squared * sigma_path_per_path_squared * sin_beta_squared * sum_182
        )
        sum_184 = 16.0 * baseline_per_path - 7.0 * cos_beta
        sum_185 = cos_beta * (40.0 + cos_beta * sum_184) - 36.0 * baseline_per_path
        sum_186 = 16.0 - 22.0 * cos_beta_squared + baseline_per_path * sum_185
        sum_187 = baseline_per_path * sum_186 - 7.0 * cos_beta
        sum_188 = baseline_per_path - cos_beta
        sum_189 = 64.0 * sum_188 * sum_7_squared - 32.0 * sigma_beta_squared * sum_187
        sum_190 = 4.0 * baseline_per_path - cos_beta
        sum_191 = cos_beta * (4.0 + cos_beta * sum_190) - 6.0 * baseline_per_path
        sum_192 = 4.0 - 4.0 * cos_beta_squared + baseline_per_path * sum_191
        sum_193 = baseline_per_path * sum_192 - cos_beta
        sigma_beta_squared_squared = sigma_beta_squared**2
        sum_194 = 64.0 * sigma_beta_squared_squared * sum_165 * sum_193 + sum_189 * sum_7_squared
        sum_195 = 196.0 - 21.0 * cos_beta_squared
        sum_196 = 280.0 - 126.0 * cos_beta_squared
        sum_197 = (24.0 - cos_beta_squared) * baseline_per_path - 46.0 * cos_beta
        sum_198 = 190.0 - 18.0 * cos_beta_squared - baseline_per_path * sum_197
        sum_199 = cos_beta * sum_198 - 146.0 * baseline_per_path
        sum_200 = 188.0 - 36.0 * baseline_per_path_squared - cos_beta * sum_199
        sum_201 = cos_beta * sum_196 - baseline_per_path * sum_200
        sum_202 = 121.0 - cos_beta_squared * sum_195 + baseline_per_path * sum_201
        sum_203 = 74.0 - 72.0 * baseline_per_path_squared
        sum_204 = cos_beta * sum_202 - baseline_per_path * sum_203
        sum_205 = 10.0 - (94.0 - 72.0 * cos_beta_squared) * cos_beta_squared + baseline_per_path * sum_204
        sum_206 = baseline_per_path * sum_205 + (2.0 + 22.0 * cos_beta_squared) * cos_beta
        sum_207 = baseline_per_path * sum_206 - 8.0 * cos_beta_squared
        sum_208 = baseline_per_path * sum_207 + cos_beta
        sum_209 = 5.0 + sin_beta_squared
        sum_210 = 8.0 - 11.0 * sin_beta_squared - baseline_per_path * cos_beta * sum_209
        sum_211 = 6.0 * cos_beta * sin_beta_squared + baseline_per_path * sum_210
        sum_212 = 4.0 - 4.0 * sin_beta_squared - baseline_per_path * sum_211
        sum_213 = baseline_per_path * sum_212 - cos_beta
        sum_214 = 212.0 - 24.0 * cos_beta_squared
        sum_215 = 308.0 - 129.0 * cos_beta_squared
        sum_216 = (24.0 - 2.0 * cos_beta_squared) * baseline_per_path - 41.0 * cos_beta
        sum_217 = 194.0 - 18.0 * cos_beta_squared - baseline_per_path * sum_216
        sum_218 = cos_beta * sum_217 - 139.0 * baseline_per_path
        sum_219 = 214.0 - 36.0 * baseline_per_path_squared - cos_beta * sum_218
        sum_220 = cos_beta * sum_215 - baseline_per_path * sum_219
        sum_221 = 104.0 - cos_beta_squared * sum_214 + baseline_per_path * sum_220
        sum_222 = 55.0 - 72.0 * baseline_per_path_squared
        sum_223 = cos_beta * sum_221 - baseline_per_path * sum_222
        sum_224 = 1.0 - baseline_per_path * sum_223 + (89.0 - 72.0 * cos_beta_squared) * cos_beta_squared
        sum_225 = (16.0 + 26.0 * cos_beta_squared) * cos_beta - baseline_per_path * sum_224
        sum_226 = baseline_per_path * sum_225 - 16.0 * cos_beta_squared
        sum_227 = 2.0 * cos_beta + baseline_per_path * sum_226
        sum_228 = 20.0 - 26.0 * sin_beta_squared - baseline_per_path * cos_beta * (11.0 + sin_beta_squared)
        sum_229 = (6.0 - 15.0 * sin_beta_squared) * cos_beta - baseline_per_path * sum_228
        sum_230 = 4.0 - 4.0 * sin_beta_squared + baseline_per_path * sum_229
        sum_231 = baseline_per_path * sum_230 - cos_beta
        sum_232 = 41.0 + 5.0 * baseline_per_path * cos_beta + 6.0 * sin_beta_squared
        sum_233 = 29.0 - 13.0 * baseline_per_path * cos_beta - sin_beta_squared * sum_232
        sum_234 = (4.0 - 51.0 * sin_beta_squared) * cos_beta - baseline_per_path * sum_233
        sum_235 = 32.0 - (17.0 + 18.0 * sin_beta_squared) * sin_beta_squared + baseline_per_path * sum_234
        sum_236 = (25.0 - 24.0 * sin_beta_squared) * cos_beta - baseline_per_path * sum_235
        sum_237 = 5.0 - 6.0 * sin_beta_squared - baseline_per_path * sum_236
        sum_238 = 1536.0 * sigma_path_per_path * sin_beta * sum_231 + 512.0 * rho * sigma_beta * sum_237
        sum_239 = 106.0 - 30.0 * cos_beta_squared
        sum_240 = 13.0 * baseline_per_path - 14.0 * cos_beta
        sum_241 = cos_beta * (112.0 + cos_beta * sum_240) - 36.0 * baseline_per_path
        sum_242 = 83.0 - 110.0 * cos_beta_squared + baseline_per_path * sum_241
        sum_243 = cos_beta * sum_239 - baseline_per_path * sum_242
        sum_244 = 8.0 - 36.0 * baseline_per_path_squared - cos_beta * sum_243
        sum_245 = baseline_per_path * sum_244 + (14.0 + 77.0 * cos_beta_squared) * cos_beta
        sum_246 = baseline_per_path * sum_245 - 42.0 * cos_beta_squared
        sum_247 = 7.0 * cos_beta + baseline_per_path * sum_246
        sum_248 = (
            64.0 * sum_247 * sum_7_squared
            - 256.0 * sigma_beta_squared * sum_227
            - baseline_per_path_squared * sigma_path_per_path * sin_beta * sum_238
        )
        sum_249 = 125.0 - 144.0 * sin_beta_squared
        sum_250 = 112.0 + 96.0 * sin_beta_squared
        sum_251 = 14.0 - 291.0 * sin_beta_squared
        sum_252 = 226.0 + 36.0 * sin_beta_squared + 37.0 * baseline_per_path * cos_beta
        sum_253 = 154.0 - 71.0 * baseline_per_path * cos_beta - sin_beta_squared * sum_252
        sum_254 = cos_beta * sum_251 - baseline_per_path * sum_253
        sum_255 = 172.0 - sin_beta_squared * sum_250 + baseline_per_path * sum_254
        sum_256 = cos_beta * sum_249 - baseline_per_path * sum_255
        sum_257 = 22.0 - 24.0 * sin_beta_squared - baseline_per_path * sum_256
        sum_258 = (
            128.0 * baseline_per_path_squared * sigma_beta * sigma_path_per_path * sin_beta * sum_257
            - rho * sum_248
        )
        sum_259 = cos_beta * (56.0 + product_9) - 18.0 * baseline_per_path
        sum_260 = 49.0 - 58.0 * cos_beta_squared + baseline_per_path * sum_259
        sum_261 = (62.0 - 12.0 * cos_beta_squared) * cos_beta - baseline_per_path * sum_260
        sum_262 = 2.0 + 18.0 * baseline_per_path_squared + cos_beta * sum_261
        sum_263 = (16.0 + 49.0 * cos_beta_squared) * cos_beta - baseline_per_path * sum_262
        sum_264 = baseline_per_path * sum_263 - 30.0 * cos_beta_squared
        sum_265 = 5.0 * cos_beta + baseline_per_path * sum_264
        sum_266 = (
            64.0 * sum_265 * sum_7_squared
            - 64.0 * sigma_beta_squared * sum_208
            - 768.0 * baseline_per_path_squared * sigma_path_per_path_squared * sin_beta_squared * sum_213
            - rho * sum_258
        )
        sum_267 = sum_194 * sum_2_squared * term_5 - sigma_path_per_path_squared * sum_266
        sum_268 = 14.0 - (52.0 + 32.0 * sin_beta_squared) * sin_beta_squared
        sum_269 = 36.0 - (91.0 + 6.0 * sin_beta_squared) * sin_beta_squared
        sum_270 = 8.0 + (98.0 + 32.0 * sin_beta_squared) * sin_beta_squared
        sum_271 = 29.0 + 2.0 * sin_beta_squared + 4.0 * baseline_per_path * cos_beta
        sum_272 = 32.0 + 6.0 * baseline_per_path * cos_beta + sin_beta_squared * sum_271
        sum_273 = 3.0 - sin_beta_squared * sum_272 + product_1
        sum_274 = baseline_per_path * sum_273 + cos_beta * sum_270
        sum_275 = 21.0 - baseline_per_path * sum_274 + sin_beta_squared * sum_269
        sum_276 = cos_beta * sum_268 - baseline_per_path * sum_275
        sum_277 = 1.0 + baseline_per_path * sum_276 + (38.0 - 36.0 * sin_beta_squared) * sin_beta_squared
        sum_278 = baseline_per_path * sum_277 - 4.0 * cos_beta
        sum_279 = 1.0 - 2.0 * sin_beta_squared + baseline_per_path * sum_278
        sum_280 = 13.0 * baseline_per_path - 22.0 * cos_beta
        sum_281 = 107.0 - 4.0 * cos_beta_squared - baseline_per_path * sum_280
        sum_282 = cos_beta * sum_281 - 83.0 * baseline_per_path
        sum_283 = 119.0 - 18.0 * baseline_per_path_squared - cos_beta * sum_282
        sum_284 = (91.0 - 50.0 * cos_beta_squared) * cos_beta - baseline_per_path * sum_283
        sum_285 = 1.0 - 54.0 * baseline_per_path_squared - cos_beta * sum_284
        sum_286 = (3.0 - 32.0 * cos_beta_squared) * cos_beta - baseline_per_path * sum_285
        sum_287 = 7.0 - 14.0 * cos_beta_squared - baseline_per_path * sum_286
        sum_288 = 192.0 * sigma_beta_squared * sum_279 + 64.0 * sum_287 * sum_7_squared
        sum_289 = rho * sigma_beta * sigma_path_per_path * sum_1 * sum_2 * sum_288 + sin_beta * sum_267
        sum_290 = sigma_beta * sum_289 - rho * sigma_path_per_path * sum_183
        sum_291 = 1.0 + sin_beta_squared
        sum_292 = 10.0 - 2.0 * sin_beta_squared - baseline_per_path * cos_beta * sum_291
        sum_293 = 8.0 - sin_beta_squared * sum_292 + product_1
        sum_294 = (12.0 - 9.0 * sin_beta_squared) * cos_beta - baseline_per_path * sum_293
        sum_295 = 8.0 - 8.0 * sin_beta_squared - baseline_per_path * sum_294
        sum_296 = (
            384.0 * baseline_per_path * sum_295
            - 2304.0 * baseline_per_path_squared * cos_beta * sigma_path_per_path_squared * sin_beta_squared
            - 768.0 * cos_beta
        )
        sum_297 = (
            64.0 * cos_beta * sum_63_squared * sum_7_squared_squared
            - baseline_per_path_squared * sigma_path_per_path_squared * sin_beta_squared * sum_296
        )
        sum_298 = sigma_path_per_path_squared * sin_beta * sum_297 + sigma_beta * sum_290
        sum_299 = 5.0 - sin_beta_squared * (4.0 + sin_beta_squared)
        sum_300 = (23.0 - 11.0 * sin_beta_squared) * cos_beta - baseline_per_path * sum_299
        sum_301 = 42.0 - baseline_per_path * sum_300 - (45.0 - 9.0 * sin_beta_squared) * sin_beta_squared
        sum_302 = (38.0 - 21.0 * sin_beta_squared) * cos_beta - baseline_per_path * sum_301
        sum_303 = 17.0 - 15.0 * sin_beta_squared - baseline_per_path * sum_302
        sum_304 = (
            13824.0 * baseline_per_path_squared * sigma_path_per_path_squared * sin_beta_squared * sum_188
            - 2304.0 * cos_beta
            + 768.0 * baseline_per_path * sum_303
        )
        sum_305 = (
            128.0 * sum_1 * sum_188 * sum_2 * sum_63 * sum_7_squared_squared
            - baseline_per_path_squared * sigma_path_per_path_squared * sin_beta_squared * sum_304
        )
        sum_306 = 28.0 * baseline_per_path - 32.0 * cos_beta
        sum_307 = 47.0 - 7.0 * cos_beta_squared - baseline_per_path * sum_306
        sum_308 = cos_beta * sum_307 - 52.0 * baseline_per_path
        sum_309 = 28.0 - 36.0 * baseline_per_path_squared - cos_beta * sum_308
        sum_310 = (26.0 - 22.0 * cos_beta_squared) * cos_beta - baseline_per_path * sum_309
        sum_311 = 3.0 - 7.0 * cos_beta_squared + baseline_per_path * sum_310
        sum_312 = 32.0 * sigma_beta_squared * sum_311 + 64.0 * sum_188**2 * sum_7_squared
        sum_313 = 64.0 * sigma_beta_squared_squared * sum_193**2 + sum_312 * sum_7_squared
        sum_314 = 31.0 + sin_beta_squared * (22.0 + sin_beta_squared)
        sum_315 = (95.0 + 31.0 * sin_beta_squared) * cos_beta - baseline_per_path * sum_314
        sum_316 = 67.0 - baseline_per_path * sum_315 - (124.0 + 9.0 * sin_beta_squared) * sin_beta_squared
        sum_317 = baseline_per_path * sum_316 + (58.0 + 83.0 * sin_beta_squared) * cos_beta
        sum_318 = 86.0 - baseline_per_path * sum_317 - (83.0 + 12.0 * sin_beta_squared) * sin_beta_squared
        sum_319 = (13.0 - 36.0 * sin_beta_squared) * cos_beta - baseline_per_path * sum_318
        sum_320 = 19.0 - 13.0 * sin_beta_squared + baseline_per_path * sum_319
        sum_321 = baseline_per_path * sum_320 - 8.0 * cos_beta
        sum_322 = 1.0 + baseline_per_path * sum_321
        sum_323 = 146.0 + 21.0 * sin_beta_squared
        sum_324 = 112.0 + 164.0 * sin_beta_squared
        sum_325 = 214.0 + 18.0 * sin_beta_squared
        sum_326 = 140.0 + 76.0 * sin_beta_squared
        sum_327 = 49.0 + sin_beta_squared * (58.0 + sin_beta_squared)
        sum_328 = cos_beta * sum_326 - baseline_per_path * sum_327
        sum_329 = 76.0 - baseline_per_path * sum_328 - sin_beta_squared * sum_325
        sum_330 = baseline_per_path * sum_329 + cos_beta * sum_324
        sum_331 = 122.0 - baseline_per_path * sum_330 - sin_beta_squared * sum_323
        sum_332 = (4.0 - 72.0 * sin_beta_squared) * cos_beta - baseline_per_path * sum_331
        sum_333 = 28.0 - 22.0 * sin_beta_squared + baseline_per_path * sum_332
        sum_334 = baseline_per_path * sum_333 - 8.0 * cos_beta
        sum_335 = 64.0 + 512.0 * rho_squared * sum_322 + 64.0 * baseline_per_path * sum_334
        sum_336 = baseline_per_path * (8.0 + sin_beta_squared) - 14.0 * cos_beta
        sum_337 = 3.0 - 6.0 * sin_beta_squared + baseline_per_path * sum_336
        sum_338 = 4.0 * cos_beta + baseline_per_path * sum_337
        sum_339 = 1.0 - baseline_per_path * sum_338
        sum_340 = (68.0 + 6.0 * sin_beta_squared) * cos_beta - (27.0 + 9.0 * sin_beta_squared) * baseline_per_path
        sum_341 = 38.0 - 63.0 * sin_beta_squared - baseline_per_path * sum_340
        sum_342 = baseline_per_path * sum_341 + (24.0 + 16.0 * sin_beta_squared) * cos_beta
        sum_343 = 25.0 - 24.0 * sin_beta_squared - baseline_per_path * sum_342
        sum_344 = baseline_per_path * sum_343 - 4.0 * cos_beta
        sum_345 = baseline_per_path * (17.0 + sin_beta_squared) - 32.0 * cos_beta
        sum_346 = 12.0 - 15.0 * sin_beta_squared + baseline_per_path * sum_345
        sum_347 = 4.0 * cos_beta + baseline_per_path * sum_346
        sum_348 = 1.0 - baseline_per_path * sum_347
        sum_349 = cos_beta * (13.0 + sin_beta_squared) - baseline_per_path * sum_209
        sum_350 = 8.0 - 11.0 * sin_beta_squared - baseline_per_path * sum_349
        sum_351 = baseline_per_path * sum_350 + cos_beta * sum_81
        sum_352 = 5.0 - 4.0 * sin_beta_squared - baseline_per_path * sum_351
        sum_353 = baseline_per_path * sum_352 - cos_beta
        sum_354 = 1536.0 * sigma_path_per_path * sin_beta * sum_348 + 3072.0 * rho * sigma_beta * sum_353
        sum_355 = 768.0 * sigma_beta * sum_344 + rho * sum_354
        sum_356 = 768.0 * sigma_path_per_path * sin_beta * sum_339 + rho * sum_355
        sum_357 = (
            baseline_per_path_squared * sigma_path_per_path * sin_beta * sum_356
            - sigma_beta_squared * sum_335
        )
        sum_358 = cos_beta * (86.0 + product_9) - 38.0 * baseline_per_path
        sum_359 = 117.0 - 66.0 * cos_beta_squared + baseline_per_path * sum_358
        sum_360 = (88.0 - 12.0 * cos_beta_squared) * cos_beta - baseline_per_path * sum_359
        sum_361 = 16.0 - 100.0 * baseline_per_path_squared - cos_beta * sum_360
        sum_362 = 6.0 - 36.0 * baseline_per_path_squared
        sum_363 = cos_beta * sum_361 - baseline_per_path * sum_362
        sum_364 = 8.0 - baseline_per_path * sum_363 - (4.0 + 49.0 * cos_beta_squared) * cos_beta_squared
        sum_365 = (12.0 - 30.0 * cos_beta_squared) * cos_beta - baseline_per_path * sum_364
        sum_366 = 140.0 - 30.0 * cos_beta_squared
        sum_367 = 19.0 * baseline_per_path - 14.0 * cos_beta
        sum_368 = cos_beta * (166.0 + cos_beta * sum_367) - 88.0 * baseline_per_path
        sum_369 = 207.0 - 132.0 * cos_beta_squared + baseline_per_path * sum_368
        sum_370 = cos_beta * sum_366 - baseline_per_path * sum_369
        sum_371 = 50.0 - 170.0 * baseline_per_path_squared - cos_beta * sum_370
        sum_372 = 30.0 - 72.0 * baseline_per_path_squared
        sum_373 = cos_beta * sum_371 - baseline_per_path * sum_372
        sum_374 = 10.0 - baseline_per_path * sum_373 + (22.0 - 77.0 * cos_beta_squared) * cos_beta_squared
        sum_375 = (24.0 - 42.0 * cos_beta_squared) * cos_beta - baseline_per_path * sum_374
        sum_376 = 4.0 - 7.0 * cos_beta_squared - baseline_per_path * sum_375
        sum_377 = (
            128.0
            - 320.0 * cos_beta_squared
            - 64.0 * baseline_per_path * sum_365
            + 64.0 * rho_squared * sum_376
        )
        sum_378 = sin_beta_squared * sum_357 + sum_377 * sum_7_squared
        sum_379 = 3.0 - 3.0 * cos_beta_squared - (product_6 - 8.0 * cos_beta) * baseline_per_path
        sum_380 = baseline_per_path * sum_379 - 4.0 * cos_beta
        sum_381 = 1.0 + baseline_per_path * sum_380
        sum_382 = 13.0 * baseline_per_path - 2.0 * cos_beta
        sum_383 = cos_beta * (46.0 + cos_beta * sum_382) - 36.0 * baseline_per_path
        sum_384 = 13.0 - 25.0 * cos_beta_squared + baseline_per_path * sum_383
        sum_385 = baseline_per_path * sum_384 - 16.0 * cos_beta
        sum_386 = 7.0 + baseline_per_path * sum_385
        sum_387 = 128.0 * sum_188 * sum_386 * sum_7_squared - 384.0 * sigma_beta_squared * sum_193 * sum_381
        sum_388 = rho * sigma_beta * sin_beta * sum_1 * sum_2 * sum_387 - sigma_path_per_path * sum_378
        sum_389 = sigma_path_per_path * sum_388 + sum_2_squared * sum_313 * term_5
        sum_390 = sigma_beta * sum_389 - rho * sigma_path_per_path * sin_beta * sum_305
        sum_391 = 110.0 - 41.0 * sin_beta_squared
        sum_392 = 56.0 - (72.0 - 20.0 * sin_beta_squared) * sin_beta_squared
        sum_393 = (12.0 - 4.0 * sin_beta_squared) * cos_beta - baseline_per_path * sum_74
        sum_394 = 54.0 - baseline_per_path * sum_393 - (30.0 - 4.0 * sin_beta_squared) * sin_beta_squared
        sum_395 = baseline_per_path - 8.0 * cos_beta
        sum_396 = 28.0 - sin_beta_squared * sum_394 + baseline_per_path * sum_395
        sum_397 = cos_beta * sum_392 - baseline_per_path * sum_396
        sum_398 = 70.0 - baseline_per_path * sum_397 - sin_beta_squared * sum_391
        sum_399 = (56.0 - 44.0 * sin_beta_squared) * cos_beta - baseline_per_path * sum_398
        sum_400 = 28.0 - 26.0 * sin_beta_squared - baseline_per_path * sum_399
        sum_401 = baseline_per_path * sum_400 - 8.0 * cos_beta
        sum_402 = 2.0 - sin_beta_squared * sum_291
        sum_403 = (8.0 - 2.0 * sin_beta_squared) * cos_beta - baseline_per_path * sum_402
        sum_404 = 12.0 - 9.0 * sin_beta_squared - baseline_per_path * sum_403
        sum_405 = baseline_per_path * sum_404 - 8.0 * cos_beta
        sum_406 = (
            768.0
            + 2304.0 * baseline_per_path_squared * sigma_path_per_path_squared * sin_beta_squared
            + 384.0 * baseline_per_path * sum_405
        )
        sum_407 = (
            64.0
            + 64.0 * baseline_per_path * sum_401
            + baseline_per_path_squared * sigma_path_per_path_squared * sin_beta_squared * sum_406
        )
        sum_408 = sigma_path_per_path_squared * sin_beta_squared * sum_407 + sigma_beta * sum_390
        mean[i, 0] = path * sum_29 * term_3
        mean[i, 1] = path * sum_56 * term_3
        covariance[i, 0, 0] = path_squared * sum_173 * term_4
        covariance[i, 0, 1] = path_squared * sum_298 * term_4
        covariance[i, 1, 0] = covariance[i, 0, 1]
        covariance[i, 1, 1] = path_squared * sum_408 * term_4


def bistatic_unbiased(
    given: Sequence[Floats],
    mean: Filled,
    covariance: Filled,
) -> None:
    """Conversion bistatic, unbiased.

    Mean: unbiased estimate of the position, to fourth order. Covariance: error covariance of the unbiased
    estimate u, to fourth order, completed to a sum of squares.
    """
    for i in range(len(given[0])):
        path = given[0][i]
        beta = given[1][i]
        baseline = given[2][i]
        sigma_path = given[3][i]
        sigma_beta = given[4][i]
        rho = given[5][i]
        term_1 = 1.0 / path
        baseline_per_path = baseline * term_1
        sigma_path_per_path = sigma_path * term_1
        cos_beta = math.cos(beta)
        product_1 = -2.0 * baseline_per_path * cos_beta
        divisor_1 = 2.0 + product_1
        sin_beta = math.sin(beta)
        sin_beta_squared = sin_beta**2
        sum_1 = 1.0 - sin_beta_squared
        sum_2 = 2.0 - 2.0 * sin_beta_squared - baseline_per_path * cos_beta * sum_1
        sigma_path_per_path_squared = sigma_path_per_path**2
        baseline_per_path_squared = baseline_per_path**2
        sum_3 = 16.0 * baseline_per_path * sum_2 - 16.0 * cos_beta + 48.0 * cos_beta * sigma_path_per_path_squared
        cos_beta_squared = cos_beta**2
        sum_4 = (3.0 - cos_beta_squared) * baseline_per_path - 3.0 * cos_beta
        product_2 = baseline_per_path * cos_beta
        sum_5 = product_2 - 1.0
        sum_5_squared = sum_5**2
        sum_6 = baseline_per_path * (1.0 + product_2) - 3.0 * cos_beta
        sum_7 = 1.0 + baseline_per_path * sum_6
        sum_8 = (
            16.0 * sum_5_squared * sum_7
            - 48.0 * baseline_per_path_squared * (1.0 + cos_beta * sum_4) * sigma_path_per_path_squared
        )
        sum_9 = 1.0 - baseline_per_path
        product_3 = (20.0 - cos_beta_squared) * baseline_per_path
        sum_10 = 20.0 + (product_3 - 11.0 * cos_beta) * cos_beta
        sum_11 = cos_beta * sum_10 - 24.0 * baseline_per_path
        sum_12 = 8.0 - 11.0 * cos_beta_squared + baseline_per_path * sum_11
        sigma_beta_squared = sigma_beta**2
        sum_13 = baseline_per_path * sum_12 - cos_beta
        product_4 = (2.0 - cos_beta_squared) * baseline_per_path
        sum_14 = 1.0 + baseline_per_path
        sum_15 = 2.0 * sigma_beta_squared * sum_13 + 8.0 * (product_4 - cos_beta) * sum_5_squared
        product_5 = (6.0 - cos_beta_squared) * baseline_per_path
        sum_16 = 29.0 - 3.0 * cos_beta_squared - (product_5 - 11.0 * cos_beta) * baseline_per_path
        sum_17 = cos_beta * sum_16 - 18.0 * baseline_per_path
        sum_18 = 7.0 - 17.0 * cos_beta_squared + baseline_per_path * sum_17
        sum_19 = baseline_per_path * sum_18 - 5.0 * cos_beta
        sum_20 = 1.0 + baseline_per_path * sum_19
        sum_21 = 4.0 * baseline_per_path - 3.0 * cos_beta
        sum_22 = cos_beta * (13.0 + cos_beta * sum_21) - 6.0 * baseline_per_path
        sum_23 = 7.0 - 9.0 * cos_beta_squared + baseline_per_path * sum_22
        rho_squared = rho**2
        sum_24 = cos_beta * sum_23 - 6.0 * baseline_per_path
        sum_25 = (
            8.0 * rho * sigma_beta * sin_beta * sum_20
            + (8.0 + 16.0 * rho_squared) * baseline_per_path_squared * sigma_path_per_path * sum_24
        )
        sum_26 = sum_14 * sum_15 * sum_9 - sigma_path_per_path * sum_25
        sum_27 = sigma_beta * sum_26 - rho * sigma_path_per_path * sin_beta * sum_8
        sum_5_squared_squared = sum_5_squared**2
        term_2 = 1.0 / (divisor_1 * (divisor_1**2)**2)
        sum_28 = (
            16.0 * cos_beta * sum_14 * sum_5_squared_squared * sum_9
            - baseline_per_path_squared * sigma_path_per_path_squared * sin_beta_squared * sum_3
            - sigma_beta * sum_27
        )
        sum_29 = 2.0 * baseline_per_path - cos_beta
        sum_30 = 1.0 - baseline_per_path * sum_29
        sum_31 = 16.0 * sum_5_squared + 8.0 * sigma_beta_squared * sum_30
        sum_32 = 8.0 * baseline_per_path - cos_beta
        sum_33 = cos_beta * (20.0 + cos_beta * sum_32) - 24.0 * baseline_per_path
        sum_34 = 20.0 - 11.0 * cos_beta_squared + baseline_per_path * sum_33
        sum_35 = baseline_per_path * sum_34 - 11.0 * cos_beta
        sigma_beta_squared_squared = sigma_beta_squared**2
        sum_36 = 1.0 - baseline_per_path * sum_35
        sum_37 = 2.0 * sigma_beta_squared_squared * sum_36 + sum_31 * sum_5_squared
        sum_38 = baseline_per_path * sum_1 - 2.0 * cos_beta
        sum_39 = 16.0 - 48.0 * sigma_path_per_path_squared + 16.0 * baseline_per_path * sum_38
        sum_40 = baseline_per_path * (3.0 + sin_beta_squared) - 3.0 * cos_beta
        sum_41 = cos_beta * (5.0 + cos_beta * sum_29) - 4.0 * baseline_per_path
        sum_42 = 1.0 - 3.0 * cos_beta_squared + baseline_per_path * sum_41
        sum_43 = (
            (24.0 + 48.0 * rho_squared) * sigma_beta * sum_42
            - 48.0 * rho * sigma_path_per_path * sin_beta * sum_40
        )
        sum_44 = sin_beta_squared * sum_39 + sigma_beta * sum_43
        sum_45 = baseline_per_path_squared * sigma_path_per_path_squared * sum_44 + sum_14 * sum_37 * sum_9
        sum_46 = 31.0 - 3.0 * cos_beta_squared - (product_3 - 19.0 * cos_beta) * baseline_per_path
        sum_47 = cos_beta * sum_46 - 32.0 * baseline_per_path
        sum_48 = 20.0 - 24.0 * baseline_per_path_squared - cos_beta * sum_47
        sum_49 = (21.0 - 17.0 * cos_beta_squared) * cos_beta - baseline_per_path * sum_48
        sum_50 = baseline_per_path * sum_49 - 5.0 * cos_beta_squared
        sum_51 = baseline_per_path * sum_50 + cos_beta
        sum_52 = 3.0 * cos_beta_squared + (product_4 - 3.0 * cos_beta) * baseline_per_path
        sum_53 = baseline_per_path * sum_52 - cos_beta
        sum_54 = 16.0 * sum_53 * sum_5_squared - 8.0 * sigma_beta_squared * sum_51
        sum_55 = rho * sigma_beta * sigma_path_per_path * sum_54 + sin_beta * sum_45
        term_3 = 1.0 / ((divisor_1**2)**2)**2
        path_squared = path**2
        sum_56 = (2.0 - 3.0 * sin_beta_squared) * cos_beta - (2.0 - 2.0 * sin_beta_squared) * baseline_per_path
        sum_57 = 3.0 - 6.0 * cos_beta_squared - (product_4 - 5.0 * cos_beta) * baseline_per_path
        sum_58 = cos_beta * sum_57 - 2.0 * baseline_per_path
        sum_59 = 1.0 - 2.0 * cos_beta_squared - baseline_per_path * sum_58
        sum_60 = (
            768.0 * cos_beta * sum_59 * sum_5_squared
            - 1152.0 * baseline_per_path_squared * sigma_path_per_path_squared * sin_beta_squared * sum_56
        )
        sum_61 = baseline_per_path - 2.0 * cos_beta
        sum_62 = 1.0 + baseline_per_path * sum_61
        sum_63 = (
            128.0 * cos_beta * sum_14 * sum_5_squared_squared * sum_62 * sum_9
            - baseline_per_path_squared * sigma_path_per_path_squared * sum_60
        )
        sum_14_squared = sum_14**2
        term_4 = (baseline_per_path - 1.0)**2
        sum_64 = 25.0 + sin_beta_squared * (10.0 + sin_beta_squared)
        sum_65 = (40.0 + 8.0 * sin_beta_squared) * cos_beta - baseline_per_path * sum_64
        sum_66 = 6.0 - 18.0 * sin_beta_squared - baseline_per_path * sum_65
        sum_67 = 8.0 * cos_beta + baseline_per_path * sum_66
        sum_68 = 1.0 + baseline_per_path * sum_67
        sum_69 = (26.0 - 5.0 * cos_beta_squared) * baseline_per_path - 14.0 * cos_beta
        sum_70 = cos_beta * (20.0 + cos_beta * sum_69) - 24.0 * baseline_per_path
        sum_71 = 2.0 - 5.0 * cos_beta_squared + baseline_per_path * sum_70
        sum_72 = 32.0 * sum_5_squared * sum_71 - 16.0 * sigma_beta_squared * sin_beta_squared * sum_68
        sum_73 = 2.0 - sin_beta_squared
        sum_74 = 1.0 - sin_beta_squared * sum_73
        sum_75 = (4.0 - 4.0 * sin_beta_squared) * cos_beta - baseline_per_path * sum_74
        sum_76 = 6.0 - 6.0 * sin_beta_squared - baseline_per_path * sum_75
        sum_77 = baseline_per_path * sum_76 - 4.0 * cos_beta
        sum_78 = 1.0 + baseline_per_path * sum_77
        sum_79 = 64.0 * sin_beta_squared * sum_78 - sigma_beta_squared * sum_72
        product_6 = (12.0 - 12.0 * sin_beta_squared) * cos_beta
        sum_80 = 4.0 + 3.0 * sin_beta_squared
        sum_81 = 7.0 - sin_beta_squared * sum_80
        sum_82 = (8.0 - 24.0 * sin_beta_squared) * cos_beta - baseline_per_path * sum_81
        sum_83 = 8.0 + baseline_per_path * sum_82 + (9.0 - 18.0 * sin_beta_squared) * sin_beta_squared
        sum_84 = product_6 - baseline_per_path * sum_83
        sum_85 = 3.0 - 3.0 * sin_beta_squared - baseline_per_path * sum_84
        sum_86 = 19.0 - (16.0 + 3.0 * sin_beta_squared) * sin_beta_squared
        sum_87 = (32.0 - 60.0 * sin_beta_squared) * cos_beta - baseline_per_path * sum_86
        sum_88 = 4.0 - baseline_per_path * sum_87 - (45.0 - 45.0 * sin_beta_squared) * sin_beta_squared
        sum_89 = baseline_per_path * sum_88 + product_6
        sum_90 = 3.0 - 3.0 * sin_beta_squared - baseline_per_path * sum_89
        sum_91 = 2.0 * baseline_per_path - 3.0 * cos_beta
        sum_92 = 7.0 - 3.0 * cos_beta_squared - (product_4 - 4.0 * cos_beta) * baseline_per_path
        sum_93 = cos_beta * sum_92 - 4.0 * baseline_per_path
        sum_94 = baseline_per_path * sum_93 - 4.0 * cos_beta_squared
        sum_95 = baseline_per_path * sum_94 + cos_beta
        sum_96 = (
            128.0 * sigma_path_per_path * sin_beta * sum_90
            + 256.0 * (1.0 + cos_beta * sum_91) * rho * sigma_beta * sum_95
        )
        sum_97 = 105.0 - 12.0 * cos_beta_squared
        sum_98 = 128.0 - 46.0 * cos_beta_squared
        product_7 = (4.0 - cos_beta_squared) * baseline_per_path
        sum_99 = 72.0 - 9.0 * cos_beta_squared - (product_7 - 10.0 * cos_beta) * baseline_per_path
        sum_100 = cos_beta * sum_99 - 38.0 * baseline_per_path
        sum_101 = 93.0 - 4.0 * baseline_per_path_squared - cos_beta * sum_100
        sum_102 = cos_beta * sum_98 - baseline_per_path * sum_101
        sum_103 = 114.0 - cos_beta_squared * sum_97 + baseline_per_path * sum_102
        sum_104 = 74.0 - 28.0 * baseline_per_path_squared
        sum_105 = cos_beta * sum_103 - baseline_per_path * sum_104
        sum_106 = 2.0 - baseline_per_path * sum_105 + (66.0 - 36.0 * cos_beta_squared) * cos_beta_squared
        sum_107 = 7.0 - 22.0 * baseline_per_path_squared
        sum_108 = baseline_per_path * sum_107 + cos_beta * sum_106
        sum_109 = 1.0 - baseline_per_path * sum_108 + (10.0 + 13.0 * cos_beta_squared) * cos_beta_squared
        sum_110 = baseline_per_path * sum_109 - 8.0 * cos_beta * cos_beta_squared
        sum_111 = baseline_per_path * sum_110 + cos_beta_squared
        sum_112 = 7.0 * baseline_per_path - 6.0 * cos_beta
        sum_113 = cos_beta * (40.0 + cos_beta * sum_112) - 9.0 * baseline_per_path
        sum_114 = 79.0 - 64.0 * cos_beta_squared + baseline_per_path * sum_113
        sum_115 = (62.0 - 14.0 * cos_beta_squared) * cos_beta - baseline_per_path * sum_114
        sum_116 = 24.0 - 30.0 * baseline_per_path_squared - cos_beta * sum_115
        sum_117 = (37.0 - 69.0 * cos_beta_squared) * cos_beta - baseline_per_path * sum_116
        sum_118 = 6.0 + 9.0 * baseline_per_path_squared + cos_beta * sum_117
        sum_119 = (30.0 - 42.0 * cos_beta_squared) * cos_beta - baseline_per_path * sum_118
        sum_120 = 5.0 - 7.0 * cos_beta_squared - baseline_per_path * sum_119
        sum_121 = (
            128.0 * sigma_beta_squared * sum_111
            - baseline_per_path_squared * sigma_path_per_path * sin_beta * sum_96
            + 64.0 * sum_120 * sum_5_squared
        )
        sum_122 = 5.0 * baseline_per_path - 9.0 * cos_beta
        sum_123 = cos_beta * (48.0 + cos_beta * sum_122) - 10.0 * baseline_per_path
        sum_124 = 81.0 - 51.0 * cos_beta_squared + baseline_per_path * sum_123
        sum_125 = (92.0 - 24.0 * cos_beta_squared) * cos_beta - baseline_per_path * sum_124
        sum_126 = 28.0 - 34.0 * baseline_per_path_squared - cos_beta * sum_125
        sum_127 = (11.0 - 36.0 * cos_beta_squared) * cos_beta - baseline_per_path * sum_126
        sum_128 = 1.0 - 6.0 * cos_beta_squared - baseline_per_path * sum_127
        product_8 = baseline_per_path * baseline_per_path_squared
        sum_129 = cos_beta * sum_128 - 10.0 * product_8
        sum_130 = (
            128.0 * baseline_per_path_squared * sigma_beta * sigma_path_per_path * sin_beta * sum_129
            - rho * sum_121
        )
        sum_131 = 120.0 - 72.0 * cos_beta_squared
        sum_132 = 204.0 - 21.0 * cos_beta_squared
        sum_133 = 224.0 - 88.0 * cos_beta_squared
        sum_134 = 162.0 - 18.0 * cos_beta_squared - (product_7 - 16.0 * cos_beta) * baseline_per_path
        sum_135 = cos_beta * sum_134 - 80.0 * baseline_per_path
        sum_136 = 192.0 - 4.0 * baseline_per_path_squared - cos_beta * sum_135
        sum_137 = cos_beta * sum_133 - baseline_per_path * sum_136
        sum_138 = 225.0 - cos_beta_squared * sum_132 + baseline_per_path * sum_137
        sum_139 = 128.0 - 64.0 * baseline_per_path_squared
        sum_140 = cos_beta * sum_138 - baseline_per_path * sum_139
        sum_141 = 16.0 - cos_beta_squared * sum_131 + baseline_per_path * sum_140
        sum_142 = 28.0 - 40.0 * baseline_per_path_squared
        sum_143 = cos_beta * sum_141 - baseline_per_path * sum_142
        sum_144 = 4.0 - (2.0 - 22.0 * cos_beta_squared) * cos_beta_squared + baseline_per_path * sum_143
        sum_145 = baseline_per_path * sum_144 - 8.0 * cos_beta * cos_beta_squared
        sum_146 = baseline_per_path * sum_145 + cos_beta_squared
        sum_147 = 2.0 * baseline_per_path - 6.0 * cos_beta
        sum_148 = cos_beta * (26.0 + cos_beta * sum_147) - 3.0 * baseline_per_path
        sum_149 = 32.0 - 26.0 * cos_beta_squared + baseline_per_path * sum_148
        sum_150 = (34.0 - 10.0 * cos_beta_squared) * cos_beta - baseline_per_path * sum_149
        sum_151 = 12.0 - 18.0 * baseline_per_path_squared - cos_beta * sum_150
        sum_152 = (11.0 - 24.0 * cos_beta_squared) * cos_beta - baseline_per_path * sum_151
        sum_153 = 6.0 - 12.0 * cos_beta_squared - baseline_per_path * sum_152
        sum_154 = cos_beta * sum_153 - 3.0 * product_8
        sum_155 = 1.0 - 2.0 * cos_beta_squared - baseline_per_path * sum_154
        sum_156 = (
            16.0 * sigma_beta_squared * sum_146
            - 64.0 * baseline_per_path_squared * sigma_path_per_path_squared * sin_beta_squared * sum_85
            - rho * sum_130
            + 64.0 * sum_155 * sum_5_squared
        )
        sum_157 = 5.0 * baseline_per_path - cos_beta
        sum_158 = cos_beta * (20.0 + cos_beta * sum_157) - 12.0 * baseline_per_path
        sum_159 = 29.0 - 17.0 * cos_beta_squared + baseline_per_path * sum_158
        sum_160 = cos_beta * sum_159 - 12.0 * baseline_per_path
        sum_161 = 6.0 - baseline_per_path * sum_160 + 11.0 * cos_beta_squared
        sum_162 = baseline_per_path * sum_161 - 5.0 * cos_beta
        sum_163 = 1.0 - (product_5 - 4.0 * cos_beta) * baseline_per_path
        sum_164 = 128.0 * sum_162 * sum_5_squared + 96.0 * sigma_beta_squared * sum_163 * sum_95
        sum_165 = rho * sigma_beta * sin_beta * sum_14 * sum_164 * sum_9 - sigma_path_per_path * sum_156
        sum_166 = sum_14_squared * sum_79 * term_4 - sigma_path_per_path * sum_165
        sum_167 = sigma_beta * sum_166 - rho * sigma_path_per_path * sin_beta * sum_63
        sum_62_squared = sum_62**2
        sum_168 = 1.0 + (product_4 - 2.0 * cos_beta) * baseline_per_path
        sin_beta_squared_squared = sin_beta_squared**2
        sum_169 = (
            384.0 * (1.0 - cos_beta) * (1.0 + cos_beta) * cos_beta_squared * sum_168 * sum_5_squared
            + 576.0 * (1.0 - sin_beta) * baseline_per_path_squared * sigma_path_per_path_squared * (1.0 + sin_beta) * sin_beta_squared_squared
        )
        sum_170 = (
            64.0 * cos_beta_squared * sum_5_squared_squared * sum_62_squared
            + baseline_per_path_squared * sigma_path_per_path_squared * sum_169
        )
        sum_171 = sigma_path_per_path_squared * sum_170 + sigma_beta * sum_167
        sum_172 = 36.0 - (46.0 - 12.0 * sin_beta_squared) * sin_beta_squared
        sum_173 = 28.0 - 9.0 * sin_beta_squared - (2.0 + 2.0 * sin_beta_squared) * baseline_per_path * cos_beta
        sum_174 = 19.0 - 4.0 * baseline_per_path * cos_beta - sin_beta_squared * sum_173
        sum_175 = cos_beta * sum_172 - baseline_per_path * sum_174
        sum_176 = 34.0 - baseline_per_path * sum_175 - (64.0 - 28.0 * sin_beta_squared) * sin_beta_squared
        sum_177 = (16.0 - 20.0 * sin_beta_squared) * cos_beta - baseline_per_path * sum_176
        sum_178 = 5.0 - 5.0 * baseline_per_path * cos_beta - 6.0 * sin_beta_squared
        sum_179 = (
            1152.0
            - 1536.0 * sin_beta_squared
            - 384.0 * baseline_per_path * sum_177
            + 576.0 * baseline_per_path_squared * sigma_path_per_path_squared * sin_beta_squared * sum_178
        )
        sum_180 = (
            64.0 * (1.0 + cos_beta * sum_61) * sum_14 * sum_5_squared_squared * sum_62 * sum_9
            + baseline_per_path_squared * sigma_path_per_path_squared * sin_beta_squared * sum_179
        )
        sum_181 = 11.0 * baseline_per_path - 5.0 * cos_beta
        sum_182 = cos_beta * (26.0 + cos_beta * sum_181) - 24.0 * baseline_per_path
        sum_183 = 11.0 - 14.0 * cos_beta_squared + baseline_per_path * sum_182
        sum_184 = baseline_per_path * sum_183 - 5.0 * cos_beta
        sum_185 = baseline_per_path - cos_beta
        sum_186 = 64.0 * sum_185 * sum_5_squared - 32.0 * sigma_beta_squared * sum_184
        sum_187 = 4.0 * baseline_per_path - cos_beta
        sum_188 = cos_beta * (4.0 + cos_beta * sum_187) - 6.0 * baseline_per_path
        sum_189 = 4.0 - 4.0 * cos_beta_squared + baseline_per_path * sum_188
        sum_190 = baseline_per_path * sum_189 - cos_beta
        sum_191 = 16.0 * sigma_beta_squared_squared * sum_163 * sum_190 + sum_186 * sum_5_squared
        sum_192 = 196.0 - 21.0 * cos_beta_squared
        sum_193 = 280.0 - 126.0 * cos_beta_squared
        sum_194 = (24.0 - cos_beta_squared) * baseline_per_path - 46.0 * cos_beta
        sum_195 = 190.0 - 18.0 * cos_beta_squared - baseline_per_path * sum_194
        sum_196 = cos_beta * sum_195 - 146.0 * baseline_per_path
        sum_197 = 188.0 - 36.0 * baseline_per_path_squared - cos_beta * sum_196
        sum_198 = cos_beta * sum_193 - baseline_per_path * sum_197
        sum_199 = 121.0 - cos_beta_squared * sum_192 + baseline_per_path * sum_198
        sum_200 = 74.0 - 72.0 * baseline_per_path_squared
        sum_201 = cos_beta * sum_199 - baseline_per_path * sum_200
        sum_202 = 10.0 - (94.0 - 72.0 * cos_beta_squared) * cos_beta_squared + baseline_per_path * sum_201
        sum_203 = baseline_per_path * sum_202 + (2.0 + 22.0 * cos_beta_squared) * cos_beta
        sum_204 = baseline_per_path * sum_203 - 8.0 * cos_beta_squared
        sum_205 = baseline_per_path * sum_204 + cos_beta
        sum_206 = 5.0 + sin_beta_squared
        sum_207 = 8.0 - 11.0 * sin_beta_squared - baseline_per_path * cos_beta * sum_206
        sum_208 = 6.0 * cos_beta * sin_beta_squared + baseline_per_path * sum_207
        sum_209 = 4.0 - 4.0 * sin_beta_squared - baseline_per_path * sum_208
        sum_210 = baseline_per_path * sum_209 - cos_beta
        sum_211 = 212.0 - 24.0 * cos_beta_squared
        sum_212 = 308.0 - 129.0 * cos_beta_squared
        sum_213 = (24.0 - 2.0 * cos_beta_squared) * baseline_per_path - 41.0 * cos_beta
        sum_214 = 194.0 - 18.0 * cos_beta_squared - baseline_per_path * sum_213
        sum_215 = cos_beta * sum_214 - 139.0 * baseline_per_path
        sum_216 = 214.0 - 36.0 * baseline_per_path_squared - cos_beta * sum_215
        sum_217 = cos_beta * sum_212 - baseline_per_path * sum_216
        sum_218 = 104.0 - cos_beta_squared * sum_211 + baseline_per_path * sum_217
        sum_219 = 55.0 - 72.0 * baseline_per_path_squared
        sum_220 = cos_beta * sum_218 - baseline_per_path * sum_219
        sum_221 = 1.0 - baseline_per_path * sum_220 + (89.0 - 72.0 * cos_beta_squared) * cos_beta_squared
        sum_222 = (16.0 + 26.0 * cos_beta_squared) * cos_beta - baseline_per_path * sum_221
        sum_223 = baseline_per_path * sum_222 - 16.0 * cos_beta_squared
        sum_224 = 2.0 * cos_beta + baseline_per_path * sum_223
        sum_225 = 41.0 + 5.0 * baseline_per_path * cos_beta + 6.0 * sin_beta_squared
        sum_226 = 29.0 - 13.0 * baseline_per_path * cos_beta - sin_beta_squared * sum_225
        sum_227 = (4.0 - 51.0 * sin_beta_squared) * cos_beta - baseline_per_path * sum_226
        sum_228 = 32.0 - (17.0 + 18.0 * sin_beta_squared) * sin_beta_squared + baseline_per_path * sum_227
        sum_229 = (25.0 - 24.0 * sin_beta_squared) * cos_beta - baseline_per_path * sum_228
        sum_230 = 5.0 - 6.0 * sin_beta_squared - baseline_per_path * sum_229
        sum_231 = 20.0 - 26.0 * sin_beta_squared - baseline_per_path * cos_beta * (11.0 + sin_beta_squared)
        sum_232 = (6.0 - 15.0 * sin_beta_squared) * cos_beta - baseline_per_path * sum_231
        sum_233 = 4.0 - 4.0 * sin_beta_squared + baseline_per_path * sum_232
        sum_234 = baseline_per_path * sum_233 - cos_beta
        sum_235 = 128.0 * rho * sigma_beta * sum_230 + 384.0 * sigma_path_per_path * sin_beta * sum_234
        sum_236 = 9.0 * baseline_per_path - 6.0 * cos_beta
        sum_237 = cos_beta * (68.0 + cos_beta * sum_236) - 24.0 * baseline_per_path
        sum_238 = 71.0 - 74.0 * cos_beta_squared + baseline_per_path * sum_237
        sum_239 = (86.0 - 14.0 * cos_beta_squared) * cos_beta - baseline_per_path * sum_238
        sum_240 = 4.0 + 24.0 * baseline_per_path_squared + cos_beta * sum_239
        sum_241 = (22.0 + 69.0 * cos_beta_squared) * cos_beta - baseline_per_path * sum_240
        sum_242 = baseline_per_path * sum_241 - 42.0 * cos_beta_squared
        sum_243 = 7.0 * cos_beta + baseline_per_path * sum_242
        sum_244 = (
            64.0 * sum_243 * sum_5_squared
            - 64.0 * sigma_beta_squared * sum_224
            - baseline_per_path_squared * sigma_path_per_path * sin_beta * sum_235
        )
        sum_245 = 125.0 - 144.0 * sin_beta_squared
        sum_246 = 112.0 + 96.0 * sin_beta_squared
        sum_247 = 14.0 - 291.0 * sin_beta_squared
        sum_248 = 226.0 + 36.0 * sin_beta_squared + 37.0 * baseline_per_path * cos_beta
        sum_249 = 154.0 - 71.0 * baseline_per_path * cos_beta - sin_beta_squared * sum_248
        sum_250 = cos_beta * sum_247 - baseline_per_path * sum_249
        sum_251 = 172.0 - sin_beta_squared * sum_246 + baseline_per_path * sum_250
        sum_252 = cos_beta * sum_245 - baseline_per_path * sum_251
        sum_253 = 22.0 - 24.0 * sin_beta_squared - baseline_per_path * sum_252
        sum_254 = (
            32.0 * baseline_per_path_squared * sigma_beta * sigma_path_per_path * sin_beta * sum_253
            - rho * sum_244
        )
        sum_255 = 3.0 * baseline_per_path - 3.0 * cos_beta
        sum_256 = cos_beta * (17.0 + cos_beta * sum_255) - 6.0 * baseline_per_path
        sum_257 = 14.0 - 17.0 * cos_beta_squared + baseline_per_path * sum_256
        sum_258 = (17.0 - 5.0 * cos_beta_squared) * cos_beta - baseline_per_path * sum_257
        sum_259 = 2.0 - 6.0 * baseline_per_path_squared - cos_beta * sum_258
        sum_260 = baseline_per_path * sum_259 + (1.0 + 12.0 * cos_beta_squared) * cos_beta
        sum_261 = baseline_per_path * sum_260 - 6.0 * cos_beta_squared
        sum_262 = baseline_per_path * sum_261 + cos_beta
        sum_263 = (
            128.0 * sum_262 * sum_5_squared
            - 16.0 * sigma_beta_squared * sum_205
            - 192.0 * baseline_per_path_squared * sigma_path_per_path_squared * sin_beta_squared * sum_210
            - rho * sum_254
        )
        sum_264 = sum_14_squared * sum_191 * term_4 - sigma_path_per_path_squared * sum_263
        sum_265 = 124.0 - 68.0 * cos_beta_squared
        sum_266 = 19.0 * baseline_per_path - 28.0 * cos_beta
        sum_267 = 143.0 - 4.0 * cos_beta_squared - baseline_per_path * sum_266
        sum_268 = cos_beta * sum_267 - 104.0 * baseline_per_path
        sum_269 = 167.0 - 24.0 * baseline_per_path_squared - cos_beta * sum_268
        sum_270 = cos_beta * sum_265 - baseline_per_path * sum_269
        sum_271 = 2.0 + 72.0 * baseline_per_path_squared + cos_beta * sum_270
        sum_272 = baseline_per_path * sum_271 + (3.0 - 44.0 * cos_beta_squared) * cos_beta
        sum_273 = 10.0 - 20.0 * cos_beta_squared - baseline_per_path * sum_272
        sum_274 = 14.0 - (52.0 + 32.0 * sin_beta_squared) * sin_beta_squared
        sum_275 = 36.0 - (91.0 + 6.0 * sin_beta_squared) * sin_beta_squared
        sum_276 = 8.0 + (98.0 + 32.0 * sin_beta_squared) * sin_beta_squared
        sum_277 = 29.0 + 2.0 * sin_beta_squared + 4.0 * baseline_per_path * cos_beta
        sum_278 = 32.0 + 6.0 * baseline_per_path * cos_beta + sin_beta_squared * sum_277
        sum_279 = 3.0 - sin_beta_squared * sum_278 + product_1
        sum_280 = baseline_per_path * sum_279 + cos_beta * sum_276
        sum_281 = 21.0 - baseline_per_path * sum_280 + sin_beta_squared * sum_275
        sum_282 = cos_beta * sum_274 - baseline_per_path * sum_281
        sum_283 = 1.0 + baseline_per_path * sum_282 + (38.0 - 36.0 * sin_beta_squared) * sin_beta_squared
        sum_284 = baseline_per_path * sum_283 - 4.0 * cos_beta
        sum_285 = 1.0 - 2.0 * sin_beta_squared + baseline_per_path * sum_284
        sum_286 = 32.0 * sum_273 * sum_5_squared + 48.0 * sigma_beta_squared * sum_285
        sum_287 = rho * sigma_beta * sigma_path_per_path * sum_14 * sum_286 * sum_9 + sin_beta * sum_264
        sum_288 = sigma_beta * sum_287 - rho * sigma_path_per_path * sum_180
        sum_289 = 1.0 - sin_beta_squared_squared
        sum_290 = 4.0 - 4.0 * sin_beta_squared - baseline_per_path * cos_beta * sum_289
        sum_291 = (6.0 - 4.0 * sin_beta_squared) * cos_beta - baseline_per_path * sum_290
        sum_292 = 4.0 - 4.0 * sin_beta_squared - baseline_per_path * sum_291
        sum_293 = (
            384.0 * baseline_per_path * sum_292
            - 384.0 * cos_beta
            - 576.0 * baseline_per_path_squared * cos_beta * sigma_path_per_path_squared * sin_beta_squared
        )
        sum_294 = (
            64.0 * cos_beta * sum_5_squared_squared * sum_62_squared
            - baseline_per_path_squared * sigma_path_per_path_squared * sin_beta_squared * sum_293
        )
        sum_295 = sigma_path_per_path_squared * sin_beta * sum_294 + sigma_beta * sum_288
        sum_296 = 3.0 - sin_beta_squared * (2.0 + sin_beta_squared)
        sum_297 = (14.0 - 6.0 * sin_beta_squared) * cos_beta - baseline_per_path * sum_296
        sum_298 = 26.0 - baseline_per_path * sum_297 - (28.0 - 6.0 * sin_beta_squared) * sin_beta_squared
        sum_299 = (24.0 - 14.0 * sin_beta_squared) * cos_beta - baseline_per_path * sum_298
        sum_300 = 11.0 - 10.0 * sin_beta_squared - baseline_per_path * sum_299
        sum_301 = (
            3456.0 * baseline_per_path_squared * sigma_path_per_path_squared * sin_beta_squared * sum_185
            - 1536.0 * cos_beta
            + 768.0 * baseline_per_path * sum_300
        )
        sum_302 = (
            128.0 * sum_14 * sum_185 * sum_5_squared_squared * sum_62 * sum_9
            - baseline_per_path_squared * sigma_path_per_path_squared * sin_beta_squared * sum_301
        )
        sum_303 = 20.0 * baseline_per_path - 22.0 * cos_beta
        sum_304 = 31.0 - 5.0 * cos_beta_squared - baseline_per_path * sum_303
        sum_305 = cos_beta * sum_304 - 32.0 * baseline_per_path
        sum_306 = 20.0 - 24.0 * baseline_per_path_squared - cos_beta * sum_305
        sum_307 = (16.0 - 14.0 * cos_beta_squared) * cos_beta - baseline_per_path * sum_306
        sum_308 = 3.0 - 5.0 * cos_beta_squared + baseline_per_path * sum_307
        sum_309 = 32.0 * sigma_beta_squared * sum_308 + 64.0 * sum_185**2 * sum_5_squared
        sum_310 = 16.0 * sigma_beta_squared_squared * sum_190**2 + sum_309 * sum_5_squared
        sum_311 = 31.0 + sin_beta_squared * (22.0 + sin_beta_squared)
        sum_312 = (95.0 + 31.0 * sin_beta_squared) * cos_beta - baseline_per_path * sum_311
        sum_313 = 67.0 - baseline_per_path * sum_312 - (124.0 + 9.0 * sin_beta_squared) * sin_beta_squared
        sum_314 = baseline_per_path * sum_313 + (58.0 + 83.0 * sin_beta_squared) * cos_beta
        sum_315 = 86.0 - baseline_per_path * sum_314 - (83.0 + 12.0 * sin_beta_squared) * sin_beta_squared
        sum_316 = (13.0 - 36.0 * sin_beta_squared) * cos_beta - baseline_per_path * sum_315
        sum_317 = 19.0 - 13.0 * sin_beta_squared + baseline_per_path * sum_316
        sum_318 = baseline_per_path * sum_317 - 8.0 * cos_beta
        sum_319 = 1.0 + baseline_per_path * sum_318
        sum_320 = 146.0 + 21.0 * sin_beta_squared
        sum_321 = 112.0 + 164.0 * sin_beta_squared
        sum_322 = 214.0 + 18.0 * sin_beta_squared
        sum_323 = 140.0 + 76.0 * sin_beta_squared
        sum_324 = 49.0 + sin_beta_squared * (58.0 + sin_beta_squared)
        sum_325 = cos_beta * sum_323 - baseline_per_path * sum_324
        sum_326 = 76.0 - baseline_per_path * sum_325 - sin_beta_squared * sum_322
        sum_327 = baseline_per_path * sum_326 + cos_beta * sum_321
        sum_328 = 122.0 - baseline_per_path * sum_327 - sin_beta_squared * sum_320
        sum_329 = (4.0 - 72.0 * sin_beta_squared) * cos_beta - baseline_per_path * sum_328
        sum_330 = 28.0 - 22.0 * sin_beta_squared + baseline_per_path * sum_329
        sum_331 = baseline_per_path * sum_330 - 8.0 * cos_beta
        sum_332 = 16.0 + 128.0 * rho_squared * sum_319 + 16.0 * baseline_per_path * sum_331
        sum_333 = baseline_per_path * (8.0 + sin_beta_squared) - 14.0 * cos_beta
        sum_334 = 3.0 - 6.0 * sin_beta_squared + baseline_per_path * sum_333
        sum_335 = 4.0 * cos_beta + baseline_per_path * sum_334
        sum_336 = 1.0 - baseline_per_path * sum_335
        sum_337 = (68.0 + 6.0 * sin_beta_squared) * cos_beta - (27.0 + 9.0 * sin_beta_squared) * baseline_per_path
        sum_338 = 38.0 - 63.0 * sin_beta_squared - baseline_per_path * sum_337
        sum_339 = baseline_per_path * sum_338 + (24.0 + 16.0 * sin_beta_squared) * cos_beta
        sum_340 = 25.0 - 24.0 * sin_beta_squared - baseline_per_path * sum_339
        sum_341 = baseline_per_path * sum_340 - 4.0 * cos_beta
        sum_342 = baseline_per_path * (17.0 + sin_beta_squared) - 32.0 * cos_beta
        sum_343 = 12.0 - 15.0 * sin_beta_squared + baseline_per_path * sum_342
        sum_344 = 4.0 * cos_beta + baseline_per_path * sum_343
        sum_345 = 1.0 - baseline_per_path * sum_344
        sum_346 = cos_beta * (13.0 + sin_beta_squared) - baseline_per_path * sum_206
        sum_347 = 8.0 - 11.0 * sin_beta_squared - baseline_per_path * sum_346
        sum_348 = baseline_per_path * sum_347 + cos_beta * sum_80
        sum_349 = 5.0 - 4.0 * sin_beta_squared - baseline_per_path * sum_348
        sum_350 = baseline_per_path * sum_349 - cos_beta
        sum_351 = 384.0 * sigma_path_per_path * sin_beta * sum_345 + 768.0 * rho * sigma_beta * sum_350
        sum_352 = 192.0 * sigma_beta * sum_341 + rho * sum_351
        sum_353 = 192.0 * sigma_path_per_path * sin_beta * sum_336 + rho * sum_352
        sum_354 = (
            baseline_per_path_squared * sigma_path_per_path * sin_beta * sum_353
            - sigma_beta_squared * sum_332
        )
        sum_355 = 10.0 * baseline_per_path - 6.0 * cos_beta
        sum_356 = cos_beta * (48.0 + cos_beta * sum_355) - 33.0 * baseline_per_path
        sum_357 = 72.0 - 42.0 * cos_beta_squared + baseline_per_path * sum_356
        sum_358 = (44.0 - 10.0 * cos_beta_squared) * cos_beta - baseline_per_path * sum_357
        sum_359 = 14.0 - 48.0 * baseline_per_path_squared - cos_beta * sum_358
        sum_360 = 15.0 - 24.0 * baseline_per_path_squared
        sum_361 = cos_beta * sum_359 - baseline_per_path * sum_360
        sum_362 = (9.0 - 24.0 * cos_beta_squared) * cos_beta_squared - baseline_per_path * sum_361
        sum_363 = (6.0 - 12.0 * cos_beta_squared) * cos_beta - baseline_per_path * sum_362
        sum_364 = 124.0 - 14.0 * cos_beta_squared
        sum_365 = 11.0 * baseline_per_path - 6.0 * cos_beta
        sum_366 = cos_beta * (102.0 + cos_beta * sum_365) - 54.0 * baseline_per_path
        sum_367 = 171.0 - 84.0 * cos_beta_squared + baseline_per_path * sum_366
        sum_368 = cos_beta * sum_364 - baseline_per_path * sum_367
        sum_369 = 10.0 - 126.0 * baseline_per_path_squared - cos_beta * sum_368
        sum_370 = 12.0 - 48.0 * baseline_per_path_squared
        sum_371 = cos_beta * sum_369 - baseline_per_path * sum_370
        sum_372 = 6.0 - baseline_per_path * sum_371 - (12.0 + 69.0 * cos_beta_squared) * cos_beta_squared
        sum_373 = (12.0 - 42.0 * cos_beta_squared) * cos_beta - baseline_per_path * sum_372
        sum_374 = 2.0 - 7.0 * cos_beta_squared - baseline_per_path * sum_373
        sum_375 = (
            64.0
            - 128.0 * cos_beta_squared
            - 64.0 * baseline_per_path * sum_363
            + 64.0 * rho_squared * sum_374
        )
        sum_376 = sin_beta_squared * sum_354 + sum_375 * sum_5_squared
        sum_377 = 3.0 - 3.0 * cos_beta_squared - (product_5 - 8.0 * cos_beta) * baseline_per_path
        sum_378 = baseline_per_path * sum_377 - 4.0 * cos_beta
        sum_379 = 1.0 + baseline_per_path * sum_378
        sum_380 = 19.0 * baseline_per_path - 18.0 * cos_beta
        sum_381 = 101.0 - 2.0 * cos_beta_squared - baseline_per_path * sum_380
        sum_382 = cos_beta * sum_381 - 106.0 * baseline_per_path
        sum_383 = 19.0 - 48.0 * baseline_per_path_squared - cos_beta * sum_382
        sum_384 = (32.0 - 34.0 * cos_beta_squared) * cos_beta - baseline_per_path * sum_383
        sum_385 = 7.0 - baseline_per_path * sum_384 + 22.0 * cos_beta_squared
        sum_386 = baseline_per_path * sum_385 - 10.0 * cos_beta
        sum_387 = 64.0 * sum_386 * sum_5_squared - 96.0 * sigma_beta_squared * sum_190 * sum_379
        sum_388 = rho * sigma_beta * sin_beta * sum_14 * sum_387 * sum_9 - sigma_path_per_path * sum_376
        sum_389 = sigma_path_per_path * sum_388 + sum_14_squared * sum_310 * term_4
        sum_390 = sigma_beta * sum_389 - rho * sigma_path_per_path * sin_beta * sum_302
        sum_391 = 110.0 - 41.0 * sin_beta_squared
        sum_392 = 56.0 - (72.0 - 20.0 * sin_beta_squared) * sin_beta_squared
        sum_393 = (12.0 - 4.0 * sin_beta_squared) * cos_beta - baseline_per_path * sum_73
        sum_394 = 54.0 - baseline_per_path * sum_393 - (30.0 - 4.0 * sin_beta_squared) * sin_beta_squared
        sum_395 = baseline_per_path - 8.0 * cos_beta
        sum_396 = 28.0 - sin_beta_squared * sum_394 + baseline_per_path * sum_395
        sum_397 = cos_beta * sum_392 - baseline_per_path * sum_396
        sum_398 = 70.0 - baseline_per_path * sum_397 - sin_beta_squared * sum_391
        sum_399 = (56.0 - 44.0 * sin_beta_squared) * cos_beta - baseline_per_path * sum_398
        sum_400 = 28.0 - 26.0 * sin_beta_squared - baseline_per_path * sum_399
        sum_401 = baseline_per_path * sum_400 - 8.0 * cos_beta
        sum_402 = baseline_per_path * sum_289 - 4.0 * cos_beta
        sum_403 = 6.0 - 4.0 * sin_beta_squared + baseline_per_path * sum_402
        sum_404 = baseline_per_path * sum_403 - 4.0 * cos_beta
        sum_405 = (
            384.0
            + 384.0 * baseline_per_path * sum_404
            + 576.0 * baseline_per_path_squared * sigma_path_per_path_squared * sin_beta_squared
        )
        sum_406 = (
            64.0
            + 64.0 * baseline_per_path * sum_401
            + baseline_per_path_squared * sigma_path_per_path_squared * sin_beta_squared * sum_405
        )
        sum_407 = sigma_path_per_path_squared * sin_beta_squared * sum_406 + sigma_beta * sum_390
        mean[i, 0] = path * sum_28 * term_2
        mean[i, 1] = path * sum_55 * term_2
        covariance[i, 0, 0] = path_squared * sum_171 * term_3
        covariance[i, 0, 1] = path_squared * sum_295 * term_3
        covariance[i, 1, 0] = covariance[i, 0, 1]
        covariance[i, 1, 1] = path_squared * sum_407 * term_3


def bistatic_posterior(
    given: Sequence[Floats],
    mean: Filled,
    covariance: Filled,
) -> None:
    """Conversion bistatic, posterior.

    Mean: posterior mean of the position under a flat prior, to fourth order. Covariance: posterior covariance
    of the position under a flat prior, to fourth order, completed to a sum of squares.
    """
    for i in range(len(given[0])):
        path = given[0][i]
        beta = given[1][i]
        baseline = given[2][i]
        sigma_path = given[3][i]
        sigma_beta = given[4][i]
        rho = given[5][i]
        term_1 = 1.0 / path
        baseline_per_path = baseline * term_1
        sigma_path_per_path = sigma_path * term_1
        cos_beta = math.cos(beta)
        product_1 = -2.0 * baseline_per_path * cos_beta
        divisor_1 = 2.0 + product_1
        product_2 = baseline_per_path * cos_beta
        sum_1 = product_2 - 1.0
        sum_1_squared = sum_1**2
        sum_1_squared_squared = sum_1_squared**2
        sum_2 = 1.0 - baseline_per_path
        sum_3 = 1.0 + baseline_per_path
        sigma_path_per_path_squared = sigma_path_per_path**2
        sin_beta = math.sin(beta)
        sin_beta_squared = sin_beta**2
        sum_4 = 1.0 - sin_beta_squared
        sum_5 = 2.0 - 2.0 * sin_beta_squared - baseline_per_path * cos_beta * sum_4
        baseline_per_path_squared = baseline_per_path**2
        sum_6 = 16.0 * baseline_per_path * sum_5 - 16.0 * cos_beta - 48.0 * cos_beta * sigma_path_per_path_squared
        sum_7 = baseline_per_path * (1.0 + product_2) - 3.0 * cos_beta
        sum_8 = 1.0 + baseline_per_path * sum_7
        cos_beta_squared = cos_beta**2
        sum_9 = (3.0 - cos_beta_squared) * baseline_per_path - 3.0 * cos_beta
        sum_10 = (
            16.0 * sum_1_squared * sum_8
            + 48.0 * baseline_per_path_squared * (1.0 + cos_beta * sum_9) * sigma_path_per_path_squared
        )
        product_3 = (20.0 - cos_beta_squared) * baseline_per_path
        sum_11 = 20.0 + (product_3 - 11.0 * cos_beta) * cos_beta
        sum_12 = cos_beta * sum_11 - 24.0 * baseline_per_path
        sum_13 = 8.0 - 11.0 * cos_beta_squared + baseline_per_path * sum_12
        sigma_beta_squared = sigma_beta**2
        sum_14 = baseline_per_path * sum_13 - cos_beta
        product_4 = (2.0 - cos_beta_squared) * baseline_per_path
        sum_15 = 8.0 * (product_4 - cos_beta) * sum_1_squared - 2.0 * sigma_beta_squared * sum_14
        product_5 = (6.0 - cos_beta_squared) * baseline_per_path
        sum_16 = 29.0 - 3.0 * cos_beta_squared - (product_5 - 11.0 * cos_beta) * baseline_per_path
        sum_17 = cos_beta * sum_16 - 18.0 * baseline_per_path
        sum_18 = 7.0 - 17.0 * cos_beta_squared + baseline_per_path * sum_17
        sum_19 = baseline_per_path * sum_18 - 5.0 * cos_beta
        sum_20 = 1.0 + baseline_per_path * sum_19
        sum_21 = 4.0 * baseline_per_path - 3.0 * cos_beta
        sum_22 = cos_beta * (13.0 + cos_beta * sum_21) - 6.0 * baseline_per_path
        sum_23 = 7.0 - 9.0 * cos_beta_squared + baseline_per_path * sum_22
        rho_squared = rho**2
        sum_24 = cos_beta * sum_23 - 6.0 * baseline_per_path
        sum_25 = (
            8.0 * rho * sigma_beta * sin_beta * sum_20
            + (8.0 + 16.0 * rho_squared) * baseline_per_path_squared * sigma_path_per_path * sum_24
        )
        sum_26 = sigma_path_per_path * sum_25 + sum_15 * sum_2 * sum_3
        sum_27 = sigma_beta * sum_26 - rho * sigma_path_per_path * sin_beta * sum_10
        term_2 = 1.0 / (divisor_1 * (divisor_1**2)**2)
        sum_28 = (
            16.0 * cos_beta * sum_1_squared_squared * sum_2 * sum_3
            + baseline_per_path_squared * sigma_path_per_path_squared * sin_beta_squared * sum_6
            + sigma_beta * sum_27
        )
        sum_29 = 2.0 * baseline_per_path - cos_beta
        sum_30 = 1.0 - baseline_per_path * sum_29
        sum_31 = 16.0 * sum_1_squared - 8.0 * sigma_beta_squared * sum_30
        sum_32 = 8.0 * baseline_per_path - cos_beta
        sum_33 = cos_beta * (20.0 + cos_beta * sum_32) - 24.0 * baseline_per_path
        sum_34 = 20.0 - 11.0 * cos_beta_squared + baseline_per_path * sum_33
        sum_35 = baseline_per_path * sum_34 - 11.0 * cos_beta
        sigma_beta_squared_squared = sigma_beta_squared**2
        sum_36 = 1.0 - baseline_per_path * sum_35
        sum_37 = 2.0 * sigma_beta_squared_squared * sum_36 + sum_1_squared * sum_31
        sum_38 = baseline_per_path * sum_4 - 2.0 * cos_beta
        sum_39 = 16.0 + 16.0 * baseline_per_path * sum_38 + 48.0 * sigma_path_per_path_squared
        sum_40 = baseline_per_path * (3.0 + sin_beta_squared) - 3.0 * cos_beta
        sum_41 = cos_beta * (5.0 + cos_beta * sum_29) - 4.0 * baseline_per_path
        sum_42 = 1.0 - 3.0 * cos_beta_squared + baseline_per_path * sum_41
        sum_43 = (
            (24.0 + 48.0 * rho_squared) * sigma_beta * sum_42
            - 48.0 * rho * sigma_path_per_path * sin_beta * sum_40
        )
        sum_44 = sin_beta_squared * sum_39 - sigma_beta * sum_43
        sum_45 = sum_2 * sum_3 * sum_37 - baseline_per_path_squared * sigma_path_per_path_squared * sum_44
        sum_46 = 3.0 * cos_beta_squared + (product_4 - 3.0 * cos_beta) * baseline_per_path
        sum_47 = baseline_per_path * sum_46 - cos_beta
        sum_48 = 31.0 - 3.0 * cos_beta_squared - (product_3 - 19.0 * cos_beta) * baseline_per_path
        sum_49 = cos_beta * sum_48 - 32.0 * baseline_per_path
        sum_50 = 20.0 - 24.0 * baseline_per_path_squared - cos_beta * sum_49
        sum_51 = (21.0 - 17.0 * cos_beta_squared) * cos_beta - baseline_per_path * sum_50
        sum_52 = baseline_per_path * sum_51 - 5.0 * cos_beta_squared
        sum_53 = baseline_per_path * sum_52 + cos_beta
        sum_54 = 16.0 * sum_1_squared * sum_47 + 8.0 * sigma_beta_squared * sum_53
        sum_55 = sin_beta * sum_45 - rho * sigma_beta * sigma_path_per_path * sum_54
        term_3 = 1.0 / ((divisor_1**2)**2)**2
        path_squared = path**2
        sum_56 = (2.0 - 3.0 * sin_beta_squared) * cos_beta - (2.0 - 2.0 * sin_beta_squared) * baseline_per_path
        product_6 = (4.0 - cos_beta_squared) * baseline_per_path
        sum_57 = 3.0 - 12.0 * cos_beta_squared - (product_6 - 13.0 * cos_beta) * baseline_per_path
        sum_58 = cos_beta * sum_57 - 4.0 * baseline_per_path
        sum_59 = 1.0 - 4.0 * cos_beta_squared - baseline_per_path * sum_58
        sum_60 = (
            256.0 * cos_beta * sum_1_squared * sum_59
            - 1152.0 * baseline_per_path_squared * sigma_path_per_path_squared * sin_beta_squared * sum_56
        )
        sum_61 = baseline_per_path - 2.0 * cos_beta
        sum_62 = 1.0 + baseline_per_path * sum_61
        sum_63 = (
            128.0 * cos_beta * sum_1_squared_squared * sum_2 * sum_3 * sum_62
            - baseline_per_path_squared * sigma_path_per_path_squared * sum_60
        )
        sum_3_squared = sum_3**2
        term_4 = (baseline_per_path - 1.0)**2
        sum_64 = 25.0 + sin_beta_squared * (10.0 + sin_beta_squared)
        sum_65 = (40.0 + 8.0 * sin_beta_squared) * cos_beta - baseline_per_path * sum_64
        sum_66 = 6.0 - 18.0 * sin_beta_squared - baseline_per_path * sum_65
        sum_67 = 8.0 * cos_beta + baseline_per_path * sum_66
        sum_68 = 1.0 + baseline_per_path * sum_67
        sum_69 = (18.0 - 3.0 * cos_beta_squared) * baseline_per_path - 10.0 * cos_beta
        sum_70 = cos_beta * (12.0 + cos_beta * sum_69) - 16.0 * baseline_per_path
        sum_71 = 2.0 - 3.0 * cos_beta_squared + baseline_per_path * sum_70
        sum_72 = 32.0 * sum_1_squared * sum_71 - 16.0 * sigma_beta_squared * sin_beta_squared * sum_68
        sum_73 = 2.0 - sin_beta_squared
        sum_74 = 1.0 - sin_beta_squared * sum_73
        sum_75 = (4.0 - 4.0 * sin_beta_squared) * cos_beta - baseline_per_path * sum_74
        sum_76 = 6.0 - 6.0 * sin_beta_squared - baseline_per_path * sum_75
        sum_77 = baseline_per_path * sum_76 - 4.0 * cos_beta
        sum_78 = 1.0 + baseline_per_path * sum_77
        sum_79 = 64.0 * sin_beta_squared * sum_78 - sigma_beta_squared * sum_72
        product_7 = (12.0 - 12.0 * sin_beta_squared) * cos_beta
        sum_80 = 4.0 + 3.0 * sin_beta_squared
        sum_81 = 7.0 - sin_beta_squared * sum_80
        sum_82 = (8.0 - 24.0 * sin_beta_squared) * cos_beta - baseline_per_path * sum_81
        sum_83 = 8.0 + baseline_per_path * sum_82 + (9.0 - 18.0 * sin_beta_squared) * sin_beta_squared
        sum_84 = product_7 - baseline_per_path * sum_83
        sum_85 = 3.0 - 3.0 * sin_beta_squared - baseline_per_path * sum_84
        sum_86 = 19.0 - (16.0 + 3.0 * sin_beta_squared) * sin_beta_squared
        sum_87 = (32.0 - 60.0 * sin_beta_squared) * cos_beta - baseline_per_path * sum_86
        sum_88 = 4.0 - baseline_per_path * sum_87 - (45.0 - 45.0 * sin_beta_squared) * sin_beta_squared
        sum_89 = baseline_per_path * sum_88 + product_7
        sum_90 = 3.0 - 3.0 * sin_beta_squared - baseline_per_path * sum_89
        sum_91 = 2.0 * baseline_per_path - 3.0 * cos_beta
        sum_92 = 7.0 - 3.0 * cos_beta_squared - (product_4 - 4.0 * cos_beta) * baseline_per_path
        sum_93 = cos_beta * sum_92 - 4.0 * baseline_per_path
        sum_94 = baseline_per_path * sum_93 - 4.0 * cos_beta_squared
        sum_95 = baseline_per_path * sum_94 + cos_beta
        sum_96 = (
            128.0 * sigma_path_per_path * sin_beta * sum_90
            + 256.0 * (1.0 + cos_beta * sum_91) * rho * sigma_beta * sum_95
        )
        sum_97 = 105.0 - 12.0 * cos_beta_squared
        sum_98 = 128.0 - 46.0 * cos_beta_squared
        sum_99 = 72.0 - 9.0 * cos_beta_squared - (product_6 - 10.0 * cos_beta) * baseline_per_path
        sum_100 = cos_beta * sum_99 - 38.0 * baseline_per_path
        sum_101 = 93.0 - 4.0 * baseline_per_path_squared - cos_beta * sum_100
        sum_102 = cos_beta * sum_98 - baseline_per_path * sum_101
        sum_103 = 114.0 - cos_beta_squared * sum_97 + baseline_per_path * sum_102
        sum_104 = 74.0 - 28.0 * baseline_per_path_squared
        sum_105 = cos_beta * sum_103 - baseline_per_path * sum_104
        sum_106 = 2.0 - baseline_per_path * sum_105 + (66.0 - 36.0 * cos_beta_squared) * cos_beta_squared
        sum_107 = 7.0 - 22.0 * baseline_per_path_squared
        sum_108 = baseline_per_path * sum_107 + cos_beta * sum_106
        sum_109 = 1.0 - baseline_per_path * sum_108 + (10.0 + 13.0 * cos_beta_squared) * cos_beta_squared
        sum_110 = baseline_per_path * sum_109 - 8.0 * cos_beta * cos_beta_squared
        sum_111 = baseline_per_path * sum_110 + cos_beta_squared
        product_8 = (46.0 - 14.0 * cos_beta_squared) * cos_beta
        sum_112 = 3.0 * baseline_per_path - 6.0 * cos_beta
        sum_113 = cos_beta * (32.0 + cos_beta * sum_112) - 5.0 * baseline_per_path
        sum_114 = 51.0 - 40.0 * cos_beta_squared + baseline_per_path * sum_113
        sum_115 = product_8 - baseline_per_path * sum_114
        sum_116 = 8.0 - 22.0 * baseline_per_path_squared - cos_beta * sum_115
        sum_117 = (9.0 - 33.0 * cos_beta_squared) * cos_beta - baseline_per_path * sum_116
        sum_118 = 2.0 - 5.0 * baseline_per_path_squared - cos_beta * sum_117
        sum_119 = baseline_per_path * sum_118 + (6.0 - 18.0 * cos_beta_squared) * cos_beta
        sum_120 = 1.0 - 3.0 * cos_beta_squared - baseline_per_path * sum_119
        sum_121 = (
            128.0 * sigma_beta_squared * sum_111
            - baseline_per_path_squared * sigma_path_per_path * sin_beta * sum_96
            + 64.0 * sum_120 * sum_1_squared
        )
        sum_122 = 5.0 * baseline_per_path - 9.0 * cos_beta
        sum_123 = cos_beta * (48.0 + cos_beta * sum_122) - 10.0 * baseline_per_path
        sum_124 = 81.0 - 51.0 * cos_beta_squared + baseline_per_path * sum_123
        sum_125 = (92.0 - 24.0 * cos_beta_squared) * cos_beta - baseline_per_path * sum_124
        sum_126 = 28.0 - 34.0 * baseline_per_path_squared - cos_beta * sum_125
        sum_127 = (11.0 - 36.0 * cos_beta_squared) * cos_beta - baseline_per_path * sum_126
        sum_128 = 1.0 - 6.0 * cos_beta_squared - baseline_per_path * sum_127
        product_9 = baseline_per_path * baseline_per_path_squared
        sum_129 = cos_beta * sum_128 - 10.0 * product_9
        sum_130 = (
            128.0 * baseline_per_path_squared * sigma_beta * sigma_path_per_path * sin_beta * sum_129
            - rho * sum_121
        )
        sum_131 = 120.0 - 72.0 * cos_beta_squared
        sum_132 = 204.0 - 21.0 * cos_beta_squared
        sum_133 = 224.0 - 88.0 * cos_beta_squared
        sum_134 = 162.0 - 18.0 * cos_beta_squared - (product_6 - 16.0 * cos_beta) * baseline_per_path
        sum_135 = cos_beta * sum_134 - 80.0 * baseline_per_path
        sum_136 = 192.0 - 4.0 * baseline_per_path_squared - cos_beta * sum_135
        sum_137 = cos_beta * sum_133 - baseline_per_path * sum_136
        sum_138 = 225.0 - cos_beta_squared * sum_132 + baseline_per_path * sum_137
        sum_139 = 128.0 - 64.0 * baseline_per_path_squared
        sum_140 = cos_beta * sum_138 - baseline_per_path * sum_139
        sum_141 = 16.0 - cos_beta_squared * sum_131 + baseline_per_path * sum_140
        sum_142 = 28.0 - 40.0 * baseline_per_path_squared
        sum_143 = cos_beta * sum_141 - baseline_per_path * sum_142
        sum_144 = 4.0 - (2.0 - 22.0 * cos_beta_squared) * cos_beta_squared + baseline_per_path * sum_143
        sum_145 = baseline_per_path * sum_144 - 8.0 * cos_beta * cos_beta_squared
        sum_146 = baseline_per_path * sum_145 + cos_beta_squared
        sum_147 = 2.0 * baseline_per_path - 2.0 * cos_beta
        product_10 = cos_beta * sum_147
        sum_148 = cos_beta * (14.0 + product_10) - 3.0 * baseline_per_path
        sum_149 = 28.0 - 22.0 * cos_beta_squared + baseline_per_path * sum_148
        sum_150 = (22.0 - 6.0 * cos_beta_squared) * cos_beta - baseline_per_path * sum_149
        sum_151 = 4.0 - 10.0 * baseline_per_path_squared - cos_beta * sum_150
        sum_152 = (7.0 - 20.0 * cos_beta_squared) * cos_beta - baseline_per_path * sum_151
        sum_153 = 6.0 - 12.0 * cos_beta_squared - baseline_per_path * sum_152
        sum_154 = cos_beta * sum_153 - 3.0 * product_9
        sum_155 = 1.0 - 2.0 * cos_beta_squared - baseline_per_path * sum_154
        sum_156 = (
            16.0 * sigma_beta_squared * sum_146
            - 64.0 * baseline_per_path_squared * sigma_path_per_path_squared * sin_beta_squared * sum_85
            - rho * sum_130
            + 64.0 * sum_155 * sum_1_squared
        )
        sum_157 = 3.0 * baseline_per_path - cos_beta
        sum_158 = cos_beta * (16.0 + cos_beta * sum_157) - 8.0 * baseline_per_path
        sum_159 = 15.0 - 11.0 * cos_beta_squared + baseline_per_path * sum_158
        sum_160 = cos_beta * sum_159 - 8.0 * baseline_per_path
        sum_161 = 2.0 - baseline_per_path * sum_160 + 7.0 * cos_beta_squared
        sum_162 = baseline_per_path * sum_161 - 3.0 * cos_beta
        sum_163 = 1.0 - (product_5 - 4.0 * cos_beta) * baseline_per_path
        sum_164 = 128.0 * sum_162 * sum_1_squared + 96.0 * sigma_beta_squared * sum_163 * sum_95
        sum_165 = rho * sigma_beta * sin_beta * sum_164 * sum_2 * sum_3 - sigma_path_per_path * sum_156
        sum_166 = sum_3_squared * sum_79 * term_4 - sigma_path_per_path * sum_165
        sum_167 = sigma_beta * sum_166 - rho * sigma_path_per_path * sin_beta * sum_63
        sum_62_squared = sum_62**2
        sum_168 = 3.0 + (product_6 - 6.0 * cos_beta) * baseline_per_path
        sum_169 = (
            128.0 * (1.0 - cos_beta) * (1.0 + cos_beta) * cos_beta_squared * sum_168 * sum_1_squared
            + 576.0 * (1.0 - sin_beta) * baseline_per_path_squared * sigma_path_per_path_squared * (1.0 + sin_beta) * sin_beta_squared**2
        )
        sum_170 = (
            64.0 * cos_beta_squared * sum_1_squared_squared * sum_62_squared
            + baseline_per_path_squared * sigma_path_per_path_squared * sum_169
        )
        sum_171 = sigma_path_per_path_squared * sum_170 + sigma_beta * sum_167
        sum_172 = 142.0 - 56.0 * sin_beta_squared
        sum_173 = 108.0 - 24.0 * sin_beta_squared
        sum_174 = 88.0 - sin_beta_squared * sum_173
        sum_175 = 74.0 - 27.0 * sin_beta_squared - (8.0 + 2.0 * sin_beta_squared) * baseline_per_path * cos_beta
        sum_176 = 47.0 - 10.0 * baseline_per_path * cos_beta - sin_beta_squared * sum_175
        sum_177 = cos_beta * sum_174 - baseline_per_path * sum_176
        sum_178 = 82.0 - baseline_per_path * sum_177 - sin_beta_squared * sum_172
        sum_179 = (38.0 - 40.0 * sin_beta_squared) * cos_beta - baseline_per_path * sum_178
        sum_180 = 5.0 - 5.0 * baseline_per_path * cos_beta - 6.0 * sin_beta_squared
        sum_181 = (
            896.0
            - 1024.0 * sin_beta_squared
            - 128.0 * baseline_per_path * sum_179
            + 576.0 * baseline_per_path_squared * sigma_path_per_path_squared * sin_beta_squared * sum_180
        )
        sum_182 = (
            64.0 * (1.0 + cos_beta * sum_61) * sum_1_squared_squared * sum_2 * sum_3 * sum_62
            + baseline_per_path_squared * sigma_path_per_path_squared * sin_beta_squared * sum_181
        )
        sum_183 = 7.0 * baseline_per_path - 3.0 * cos_beta
        sum_184 = cos_beta * (18.0 + cos_beta * sum_183) - 16.0 * baseline_per_path
        sum_185 = 7.0 - 10.0 * cos_beta_squared + baseline_per_path * sum_184
        sum_186 = baseline_per_path * sum_185 - 3.0 * cos_beta
        sum_187 = baseline_per_path - cos_beta
        sum_188 = 64.0 * sum_187 * sum_1_squared - 32.0 * sigma_beta_squared * sum_186
        sum_189 = 4.0 * baseline_per_path - cos_beta
        sum_190 = cos_beta * (4.0 + cos_beta * sum_189) - 6.0 * baseline_per_path
        sum_191 = 4.0 - 4.0 * cos_beta_squared + baseline_per_path * sum_190
        sum_192 = baseline_per_path * sum_191 - cos_beta
        sum_193 = 16.0 * sigma_beta_squared_squared * sum_163 * sum_192 + sum_188 * sum_1_squared
        sum_194 = 196.0 - 21.0 * cos_beta_squared
        sum_195 = 280.0 - 126.0 * cos_beta_squared
        sum_196 = (24.0 - cos_beta_squared) * baseline_per_path - 46.0 * cos_beta
        sum_197 = 190.0 - 18.0 * cos_beta_squared - baseline_per_path * sum_196
        sum_198 = cos_beta * sum_197 - 146.0 * baseline_per_path
        sum_199 = 188.0 - 36.0 * baseline_per_path_squared - cos_beta * sum_198
        sum_200 = cos_beta * sum_195 - baseline_per_path * sum_199
        sum_201 = 121.0 - cos_beta_squared * sum_194 + baseline_per_path * sum_200
        sum_202 = 74.0 - 72.0 * baseline_per_path_squared
        sum_203 = cos_beta * sum_201 - baseline_per_path * sum_202
        sum_204 = 10.0 - (94.0 - 72.0 * cos_beta_squared) * cos_beta_squared + baseline_per_path * sum_203
        sum_205 = baseline_per_path * sum_204 + (2.0 + 22.0 * cos_beta_squared) * cos_beta
        sum_206 = baseline_per_path * sum_205 - 8.0 * cos_beta_squared
        sum_207 = baseline_per_path * sum_206 + cos_beta
        sum_208 = 5.0 + sin_beta_squared
        sum_209 = 8.0 - 11.0 * sin_beta_squared - baseline_per_path * cos_beta * sum_208
        sum_210 = 6.0 * cos_beta * sin_beta_squared + baseline_per_path * sum_209
        sum_211 = 4.0 - 4.0 * sin_beta_squared - baseline_per_path * sum_210
        sum_212 = baseline_per_path * sum_211 - cos_beta
        sum_213 = 212.0 - 24.0 * cos_beta_squared
        sum_214 = 308.0 - 129.0 * cos_beta_squared
        sum_215 = (24.0 - 2.0 * cos_beta_squared) * baseline_per_path - 41.0 * cos_beta
        sum_216 = 194.0 - 18.0 * cos_beta_squared - baseline_per_path * sum_215
        sum_217 = cos_beta * sum_216 - 139.0 * baseline_per_path
        sum_218 = 214.0 - 36.0 * baseline_per_path_squared - cos_beta * sum_217
        sum_219 = cos_beta * sum_214 - baseline_per_path * sum_218
        sum_220 = 104.0 - cos_beta_squared * sum_213 + baseline_per_path * sum_219
        sum_221 = 55.0 - 72.0 * baseline_per_path_squared
        sum_222 = cos_beta * sum_220 - baseline_per_path * sum_221
        sum_223 = 1.0 - baseline_per_path * sum_222 + (89.0 - 72.0 * cos_beta_squared) * cos_beta_squared
        sum_224 = (16.0 + 26.0 * cos_beta_squared) * cos_beta - baseline_per_path * sum_223
        sum_225 = baseline_per_path * sum_224 - 16.0 * cos_beta_squared
        sum_226 = 2.0 * cos_beta + baseline_per_path * sum_225
        sum_227 = 41.0 + 5.0 * baseline_per_path * cos_beta + 6.0 * sin_beta_squared
        sum_228 = 29.0 - 13.0 * baseline_per_path * cos_beta - sin_beta_squared * sum_227
        sum_229 = (4.0 - 51.0 * sin_beta_squared) * cos_beta - baseline_per_path * sum_228
        sum_230 = 32.0 - (17.0 + 18.0 * sin_beta_squared) * sin_beta_squared + baseline_per_path * sum_229
        sum_231 = (25.0 - 24.0 * sin_beta_squared) * cos_beta - baseline_per_path * sum_230
        sum_232 = 5.0 - 6.0 * sin_beta_squared - baseline_per_path * sum_231
        sum_233 = 20.0 - 26.0 * sin_beta_squared - baseline_per_path * cos_beta * (11.0 + sin_beta_squared)
        sum_234 = (6.0 - 15.0 * sin_beta_squared) * cos_beta - baseline_per_path * sum_233
        sum_235 = 4.0 - 4.0 * sin_beta_squared + baseline_per_path * sum_234
        sum_236 = baseline_per_path * sum_235 - cos_beta
        sum_237 = 128.0 * rho * sigma_beta * sum_232 + 384.0 * sigma_path_per_path * sin_beta * sum_236
        sum_238 = 5.0 * baseline_per_path - 6.0 * cos_beta
        sum_239 = cos_beta * (52.0 + cos_beta * sum_238) - 16.0 * baseline_per_path
        sum_240 = 35.0 - 50.0 * cos_beta_squared + baseline_per_path * sum_239
        sum_241 = product_8 - baseline_per_path * sum_240
        sum_242 = 4.0 - 16.0 * baseline_per_path_squared - cos_beta * sum_241
        sum_243 = baseline_per_path * sum_242 + (6.0 + 33.0 * cos_beta_squared) * cos_beta
        sum_244 = baseline_per_path * sum_243 - 18.0 * cos_beta_squared
        sum_245 = 3.0 * cos_beta + baseline_per_path * sum_244
        sum_246 = (
            64.0 * sum_1_squared * sum_245
            - 64.0 * sigma_beta_squared * sum_226
            - baseline_per_path_squared * sigma_path_per_path * sin_beta * sum_237
        )
        sum_247 = 125.0 - 144.0 * sin_beta_squared
        sum_248 = 112.0 + 96.0 * sin_beta_squared
        sum_249 = 14.0 - 291.0 * sin_beta_squared
        sum_250 = 226.0 + 36.0 * sin_beta_squared + 37.0 * baseline_per_path * cos_beta
        sum_251 = 154.0 - 71.0 * baseline_per_path * cos_beta - sin_beta_squared * sum_250
        sum_252 = cos_beta * sum_249 - baseline_per_path * sum_251
        sum_253 = 172.0 - sin_beta_squared * sum_248 + baseline_per_path * sum_252
        sum_254 = cos_beta * sum_247 - baseline_per_path * sum_253
        sum_255 = 22.0 - 24.0 * sin_beta_squared - baseline_per_path * sum_254
        sum_256 = (
            32.0 * baseline_per_path_squared * sigma_beta * sigma_path_per_path * sin_beta * sum_255
            - rho * sum_246
        )
        sum_257 = cos_beta * (13.0 + cos_beta * sum_187) - 4.0 * baseline_per_path
        sum_258 = 10.0 - 13.0 * cos_beta_squared + baseline_per_path * sum_257
        sum_259 = (13.0 - 3.0 * cos_beta_squared) * cos_beta - baseline_per_path * sum_258
        sum_260 = 3.0 - baseline_per_path * sum_259 + 10.0 * cos_beta_squared
        sum_261 = cos_beta * sum_260 - 4.0 * product_9
        sum_262 = baseline_per_path * sum_261 - 6.0 * cos_beta_squared
        sum_263 = baseline_per_path * sum_262 + cos_beta
        sum_264 = (
            128.0 * sum_1_squared * sum_263
            - 16.0 * sigma_beta_squared * sum_207
            - 192.0 * baseline_per_path_squared * sigma_path_per_path_squared * sin_beta_squared * sum_212
            - rho * sum_256
        )
        sum_265 = sum_193 * sum_3_squared * term_4 - sigma_path_per_path_squared * sum_264
        sum_266 = 11.0 * baseline_per_path - 20.0 * cos_beta
        sum_267 = 95.0 - 4.0 * cos_beta_squared - baseline_per_path * sum_266
        sum_268 = cos_beta * sum_267 - 76.0 * baseline_per_path
        sum_269 = 103.0 - 16.0 * baseline_per_path_squared - cos_beta * sum_268
        sum_270 = (80.0 - 44.0 * cos_beta_squared) * cos_beta - baseline_per_path * sum_269
        sum_271 = 2.0 - 48.0 * baseline_per_path_squared - cos_beta * sum_270
        sum_272 = (3.0 - 28.0 * cos_beta_squared) * cos_beta - baseline_per_path * sum_271
        sum_273 = 6.0 - 12.0 * cos_beta_squared - baseline_per_path * sum_272
        sum_274 = 14.0 - (52.0 + 32.0 * sin_beta_squared) * sin_beta_squared
        sum_275 = 36.0 - (91.0 + 6.0 * sin_beta_squared) * sin_beta_squared
        sum_276 = 8.0 + (98.0 + 32.0 * sin_beta_squared) * sin_beta_squared
        sum_277 = 29.0 + 2.0 * sin_beta_squared + 4.0 * baseline_per_path * cos_beta
        sum_278 = 32.0 + 6.0 * baseline_per_path * cos_beta + sin_beta_squared * sum_277
        sum_279 = 3.0 - sin_beta_squared * sum_278 + product_1
        sum_280 = baseline_per_path * sum_279 + cos_beta * sum_276
        sum_281 = 21.0 - baseline_per_path * sum_280 + sin_beta_squared * sum_275
        sum_282 = cos_beta * sum_274 - baseline_per_path * sum_281
        sum_283 = 1.0 + baseline_per_path * sum_282 + (38.0 - 36.0 * sin_beta_squared) * sin_beta_squared
        sum_284 = baseline_per_path * sum_283 - 4.0 * cos_beta
        sum_285 = 1.0 - 2.0 * sin_beta_squared + baseline_per_path * sum_284
        sum_286 = 32.0 * sum_1_squared * sum_273 + 48.0 * sigma_beta_squared * sum_285
        sum_287 = rho * sigma_beta * sigma_path_per_path * sum_2 * sum_286 * sum_3 + sin_beta * sum_265
        sum_288 = sigma_beta * sum_287 - rho * sigma_path_per_path * sum_182
        sum_289 = 2.0 + sin_beta_squared
        sum_290 = 16.0 - 4.0 * sin_beta_squared - baseline_per_path * cos_beta * sum_289
        sum_291 = 12.0 - 3.0 * baseline_per_path * cos_beta - sin_beta_squared * sum_290
        sum_292 = (18.0 - 14.0 * sin_beta_squared) * cos_beta - baseline_per_path * sum_291
        sum_293 = 12.0 - 12.0 * sin_beta_squared - baseline_per_path * sum_292
        sum_294 = (
            128.0 * baseline_per_path * sum_293
            - 384.0 * cos_beta
            - 576.0 * baseline_per_path_squared * cos_beta * sigma_path_per_path_squared * sin_beta_squared
        )
        sum_295 = (
            64.0 * cos_beta * sum_1_squared_squared * sum_62_squared
            - baseline_per_path_squared * sigma_path_per_path_squared * sin_beta_squared * sum_294
        )
        sum_296 = sigma_path_per_path_squared * sin_beta * sum_295 + sigma_beta * sum_288
        sum_297 = 7.0 - sin_beta_squared * (6.0 + sin_beta_squared)
        sum_298 = (32.0 - 16.0 * sin_beta_squared) * cos_beta - baseline_per_path * sum_297
        sum_299 = 58.0 - baseline_per_path * sum_298 - (62.0 - 12.0 * sin_beta_squared) * sin_beta_squared
        sum_300 = (52.0 - 28.0 * sin_beta_squared) * cos_beta - baseline_per_path * sum_299
        sum_301 = 23.0 - 20.0 * sin_beta_squared - baseline_per_path * sum_300
        sum_302 = (
            256.0 * baseline_per_path * sum_301
            - 1024.0 * cos_beta
            + 3456.0 * baseline_per_path_squared * sigma_path_per_path_squared * sin_beta_squared * sum_187
        )
        sum_303 = (
            128.0 * sum_187 * sum_1_squared_squared * sum_2 * sum_3 * sum_62
            - baseline_per_path_squared * sigma_path_per_path_squared * sin_beta_squared * sum_302
        )
        sum_304 = 12.0 * baseline_per_path - 14.0 * cos_beta
        sum_305 = 21.0 - 3.0 * cos_beta_squared - baseline_per_path * sum_304
        sum_306 = cos_beta * sum_305 - 24.0 * baseline_per_path
        sum_307 = 12.0 - 16.0 * baseline_per_path_squared - cos_beta * sum_306
        sum_308 = (12.0 - 10.0 * cos_beta_squared) * cos_beta - baseline_per_path * sum_307
        sum_309 = 1.0 - 3.0 * cos_beta_squared + baseline_per_path * sum_308
        sum_310 = 32.0 * sigma_beta_squared * sum_309 + 64.0 * sum_187**2 * sum_1_squared
        sum_311 = 16.0 * sigma_beta_squared_squared * sum_192**2 + sum_1_squared * sum_310
        sum_312 = 31.0 + sin_beta_squared * (22.0 + sin_beta_squared)
        sum_313 = (95.0 + 31.0 * sin_beta_squared) * cos_beta - baseline_per_path * sum_312
        sum_314 = 67.0 - baseline_per_path * sum_313 - (124.0 + 9.0 * sin_beta_squared) * sin_beta_squared
        sum_315 = baseline_per_path * sum_314 + (58.0 + 83.0 * sin_beta_squared) * cos_beta
        sum_316 = 86.0 - baseline_per_path * sum_315 - (83.0 + 12.0 * sin_beta_squared) * sin_beta_squared
        sum_317 = (13.0 - 36.0 * sin_beta_squared) * cos_beta - baseline_per_path * sum_316
        sum_318 = 19.0 - 13.0 * sin_beta_squared + baseline_per_path * sum_317
        sum_319 = baseline_per_path * sum_318 - 8.0 * cos_beta
        sum_320 = 1.0 + baseline_per_path * sum_319
        sum_321 = 146.0 + 21.0 * sin_beta_squared
        sum_322 = 112.0 + 164.0 * sin_beta_squared
        sum_323 = 214.0 + 18.0 * sin_beta_squared
        sum_324 = 140.0 + 76.0 * sin_beta_squared
        sum_325 = 49.0 + sin_beta_squared * (58.0 + sin_beta_squared)
        sum_326 = cos_beta * sum_324 - baseline_per_path * sum_325
        sum_327 = 76.0 - baseline_per_path * sum_326 - sin_beta_squared * sum_323
        sum_328 = baseline_per_path * sum_327 + cos_beta * sum_322
        sum_329 = 122.0 - baseline_per_path * sum_328 - sin_beta_squared * sum_321
        sum_330 = (4.0 - 72.0 * sin_beta_squared) * cos_beta - baseline_per_path * sum_329
        sum_331 = 28.0 - 22.0 * sin_beta_squared + baseline_per_path * sum_330
        sum_332 = baseline_per_path * sum_331 - 8.0 * cos_beta
        sum_333 = 16.0 + 128.0 * rho_squared * sum_320 + 16.0 * baseline_per_path * sum_332
        sum_334 = baseline_per_path * (8.0 + sin_beta_squared) - 14.0 * cos_beta
        sum_335 = 3.0 - 6.0 * sin_beta_squared + baseline_per_path * sum_334
        sum_336 = 4.0 * cos_beta + baseline_per_path * sum_335
        sum_337 = 1.0 - baseline_per_path * sum_336
        sum_338 = (68.0 + 6.0 * sin_beta_squared) * cos_beta - (27.0 + 9.0 * sin_beta_squared) * baseline_per_path
        sum_339 = 38.0 - 63.0 * sin_beta_squared - baseline_per_path * sum_338
        sum_340 = baseline_per_path * sum_339 + (24.0 + 16.0 * sin_beta_squared) * cos_beta
        sum_341 = 25.0 - 24.0 * sin_beta_squared - baseline_per_path * sum_340
        sum_342 = baseline_per_path * sum_341 - 4.0 * cos_beta
        sum_343 = baseline_per_path * (17.0 + sin_beta_squared) - 32.0 * cos_beta
        sum_344 = 12.0 - 15.0 * sin_beta_squared + baseline_per_path * sum_343
        sum_345 = 4.0 * cos_beta + baseline_per_path * sum_344
        sum_346 = 1.0 - baseline_per_path * sum_345
        sum_347 = cos_beta * (13.0 + sin_beta_squared) - baseline_per_path * sum_208
        sum_348 = 8.0 - 11.0 * sin_beta_squared - baseline_per_path * sum_347
        sum_349 = baseline_per_path * sum_348 + cos_beta * sum_80
        sum_350 = 5.0 - 4.0 * sin_beta_squared - baseline_per_path * sum_349
        sum_351 = baseline_per_path * sum_350 - cos_beta
        sum_352 = 384.0 * sigma_path_per_path * sin_beta * sum_346 + 768.0 * rho * sigma_beta * sum_351
        sum_353 = 192.0 * sigma_beta * sum_342 + rho * sum_352
        sum_354 = 192.0 * sigma_path_per_path * sin_beta * sum_337 + rho * sum_353
        sum_355 = (
            baseline_per_path_squared * sigma_path_per_path * sin_beta * sum_354
            - sigma_beta_squared * sum_333
        )
        sum_356 = cos_beta * (40.0 + product_10) - 17.0 * baseline_per_path
        sum_357 = 48.0 - 30.0 * cos_beta_squared + baseline_per_path * sum_356
        sum_358 = (36.0 - 6.0 * cos_beta_squared) * cos_beta - baseline_per_path * sum_357
        sum_359 = 10.0 - 44.0 * baseline_per_path_squared - cos_beta * sum_358
        sum_360 = 3.0 - 16.0 * baseline_per_path_squared
        sum_361 = cos_beta * sum_359 - baseline_per_path * sum_360
        sum_362 = 4.0 - baseline_per_path * sum_361 + (1.0 - 20.0 * cos_beta_squared) * cos_beta_squared
        sum_363 = (6.0 - 12.0 * cos_beta_squared) * cos_beta - baseline_per_path * sum_362
        sum_364 = 7.0 * baseline_per_path - 6.0 * cos_beta
        sum_365 = cos_beta * (78.0 + cos_beta * sum_364) - 38.0 * baseline_per_path
        sum_366 = 87.0 - 60.0 * cos_beta_squared + baseline_per_path * sum_365
        sum_367 = (60.0 - 14.0 * cos_beta_squared) * cos_beta - baseline_per_path * sum_366
        sum_368 = 26.0 - 78.0 * baseline_per_path_squared - cos_beta * sum_367
        sum_369 = 12.0 - 32.0 * baseline_per_path_squared
        sum_370 = cos_beta * sum_368 - baseline_per_path * sum_369
        sum_371 = 6.0 - baseline_per_path * sum_370 + (12.0 - 33.0 * cos_beta_squared) * cos_beta_squared
        sum_372 = (12.0 - 18.0 * cos_beta_squared) * cos_beta - baseline_per_path * sum_371
        sum_373 = 2.0 - 3.0 * cos_beta_squared - baseline_per_path * sum_372
        sum_374 = (
            64.0
            - 128.0 * cos_beta_squared
            - 64.0 * baseline_per_path * sum_363
            + 64.0 * rho_squared * sum_373
        )
        sum_375 = sin_beta_squared * sum_355 + sum_1_squared * sum_374
        sum_376 = 3.0 - 3.0 * cos_beta_squared - (product_5 - 8.0 * cos_beta) * baseline_per_path
        sum_377 = baseline_per_path * sum_376 - 4.0 * cos_beta
        sum_378 = 1.0 + baseline_per_path * sum_377
        sum_379 = 11.0 * baseline_per_path - 14.0 * cos_beta
        sum_380 = 61.0 - 2.0 * cos_beta_squared - baseline_per_path * sum_379
        sum_381 = cos_beta * sum_380 - 74.0 * baseline_per_path
        sum_382 = 11.0 - 32.0 * baseline_per_path_squared - cos_beta * sum_381
        sum_383 = (28.0 - 22.0 * cos_beta_squared) * cos_beta - baseline_per_path * sum_382
        sum_384 = 7.0 - baseline_per_path * sum_383 + 14.0 * cos_beta_squared
        sum_385 = baseline_per_path * sum_384 - 6.0 * cos_beta
        sum_386 = 64.0 * sum_1_squared * sum_385 - 96.0 * sigma_beta_squared * sum_192 * sum_378
        sum_387 = rho * sigma_beta * sin_beta * sum_2 * sum_3 * sum_386 - sigma_path_per_path * sum_375
        sum_388 = sigma_path_per_path * sum_387 + sum_311 * sum_3_squared * term_4
        sum_389 = sigma_beta * sum_388 - rho * sigma_path_per_path * sin_beta * sum_303
        sum_390 = 110.0 - 41.0 * sin_beta_squared
        sum_391 = 56.0 - (72.0 - 20.0 * sin_beta_squared) * sin_beta_squared
        product_11 = (12.0 - 4.0 * sin_beta_squared) * cos_beta
        sum_392 = product_11 - baseline_per_path * sum_73
        sum_393 = 54.0 - baseline_per_path * sum_392 - (30.0 - 4.0 * sin_beta_squared) * sin_beta_squared
        sum_394 = baseline_per_path - 8.0 * cos_beta
        sum_395 = 28.0 - sin_beta_squared * sum_393 + baseline_per_path * sum_394
        sum_396 = cos_beta * sum_391 - baseline_per_path * sum_395
        sum_397 = 70.0 - baseline_per_path * sum_396 - sin_beta_squared * sum_390
        sum_398 = (56.0 - 44.0 * sin_beta_squared) * cos_beta - baseline_per_path * sum_397
        sum_399 = 28.0 - 26.0 * sin_beta_squared - baseline_per_path * sum_398
        sum_400 = baseline_per_path * sum_399 - 8.0 * cos_beta
        sum_401 = 3.0 - sin_beta_squared * sum_289
        sum_402 = product_11 - baseline_per_path * sum_401
        sum_403 = 18.0 - 14.0 * sin_beta_squared - baseline_per_path * sum_402
        sum_404 = baseline_per_path * sum_403 - 12.0 * cos_beta
        sum_405 = (
            384.0
            + 128.0 * baseline_per_path * sum_404
            + 576.0 * baseline_per_path_squared * sigma_path_per_path_squared * sin_beta_squared
        )
        sum_406 = (
            64.0
            + 64.0 * baseline_per_path * sum_400
            + baseline_per_path_squared * sigma_path_per_path_squared * sin_beta_squared * sum_405
        )
        sum_407 = sigma_path_per_path_squared * sin_beta_squared * sum_406 + sigma_beta * sum_389
        mean[i, 0] = path * sum_28 * term_2
        mean[i, 1] = path * sum_55 * term_2
        covariance[i, 0, 0] = path_squared * sum_171 * term_3
        covariance[i, 0, 1] = path_squared * sum_296 * term_3
        covariance[i, 1, 0] = covariance[i, 0, 1]
        covariance[i, 1, 1] = path_squared * sum_407 * term_3


def polar_linear(
    given: Sequence[Floats],
    mean: Filled,
    covariance: Filled,
) -> None:
    """Conversion polar, linear.

    Mean: map from the measured quantities to coordinates. Covariance: covariance of the linearised
    conversion.
    """
    for i in range(len(given[0])):
        r = given[0][i]
        beta = given[1][i]
        sigma_r = given[2][i]
        sigma_beta = given[3][i]
        rho = given[4][i]
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
    given: Sequence[Floats],
    mean: Filled,
    covariance: Filled,
) -> None:
    """Conversion polar, second_order.

    Mean: map from the measured quantities to coordinates less the bias of the plain conversion to second
    order. Covariance: covariance of the conversion's quadratic Taylor polynomial.
    """
    for i in range(len(given[0])):
        r = given[0][i]
        beta = given[1][i]
        sigma_r = given[2][i]
        sigma_beta = given[3][i]
        rho = given[4][i]
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
    given: Sequence[Floats],
    mean: Filled,
    covariance: Filled,
) -> None:
    """Conversion polar, averaged.

    Mean: map from the measured quantities to coordinates less the exact bias of the plain conversion,
    averaged over the truth. Covariance: exact covariance of the plain conversion, averaged over the truth.
    """
    for i in range(len(given[0])):
        r = given[0][i]
        beta = given[1][i]
        sigma_r = given[2][i]
        sigma_beta = given[3][i]
        rho = given[4][i]
        cos_beta = math.cos(beta)
        sin_beta = math.sin(beta)
        sigma_beta_squared = sigma_beta**2
        attenuation_beta = math.exp(-0.5 * sigma_beta_squared)
        shortfall_beta = -math.expm1(-0.5 * sigma_beta_squared)
        part_0_cos_beta = -attenuation_beta * r * shortfall_beta
        attenuation_beta_2 = attenuation_beta**2
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
    given: Sequence[Floats],
    mean: Filled,
    covariance: Filled,
) -> None:
    """Conversion polar, unbiased.

    Mean: exactly unbiased estimate of the position. Covariance: error covariance of the unbiased estimate u.
    """
    for i in range(len(given[0])):
        r = given[0][i]
        beta = given[1][i]
        sigma_r = given[2][i]
        sigma_beta = given[3][i]
        rho = given[4][i]
        cos_beta = math.cos(beta)
        sin_beta = math.sin(beta)
        sigma_beta_squared = sigma_beta**2
        attenuation_beta = math.exp(-0.5 * sigma_beta_squared)
        term_1 = 1.0 / attenuation_beta
        part_0_cos_beta = r * term_1
        part_0_sin_beta = rho * sigma_beta * sigma_r * term_1
        attenuation_beta_2 = attenuation_beta**2
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
    given: Sequence[Floats],
    mean: Filled,
    covariance: Filled,
) -> None:
    """Conversion polar, posterior.

    Mean: posterior mean of the position under a flat prior. Covariance: posterior covariance of the position
    under a flat prior.
    """
    for i in range(len(given[0])):
        r = given[0][i]
        beta = given[1][i]
        sigma_r = given[2][i]
        sigma_beta = given[3][i]
        rho = given[4][i]
        cos_beta = math.cos(beta)
        sin_beta = math.sin(beta)
        sigma_beta_squared = sigma_beta**2
        attenuation_beta = math.exp(-0.5 * sigma_beta_squared)
        part_0_cos_beta = attenuation_beta * r
        part_0_sin_beta = -attenuation_beta * rho * sigma_beta * sigma_r
        attenuation_beta_2 = attenuation_beta**2
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
    given: Sequence[Floats],
    mean: Filled,
    covariance: Filled,
) -> None:
    """Conversion polar_doppler, linear.

    Mean: map from the measured quantities to coordinates. Covariance: covariance of the linearised
    conversion.
    """
    for i in range(len(given[0])):
        r = given[0][i]
        beta = given[1][i]
        rdot = given[2][i]
        sigma_r = given[3][i]
        sigma_beta = given[4][i]
        sigma_rdot = given[5][i]
        rho = given[6][i]
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
    given: Sequence[Floats],
    mean: Filled,
    covariance: Filled,
) -> None:
    """Conversion polar_doppler, second_order.

    Mean: map from the measured quantities to coordinates less the bias of the plain conversion to second
    order. Covariance: covariance of the conversion's quadratic Taylor polynomial.
    """
    for i in range(len(given[0])):
        r = given[0][i]
        beta = given[1][i]
        rdot = given[2][i]
        sigma_r = given[3][i]
        sigma_beta = given[4][i]
        sigma_rdot = given[5][i]
        rho = given[6][i]
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
    given: Sequence[Floats],
    mean: Filled,
    covariance: Filled,
) -> None:
    """Conversion polar_doppler, averaged.

    Mean: map from the measured quantities to coordinates less the exact bias of the plain conversion,
    averaged over the truth. Covariance: exact covariance of the plain conversion, averaged over the truth.
    """
    for i in range(len(given[0])):
        r = given[0][i]
        beta = given[1][i]
        rdot = given[2][i]
        sigma_r = given[3][i]
        sigma_beta = given[4][i]
        sigma_rdot = given[5][i]
        rho = given[6][i]
        cos_beta = math.cos(beta)
        sin_beta = math.sin(beta)
        sigma_beta_squared = sigma_beta**2
        attenuation_beta = math.exp(-0.5 * sigma_beta_squared)
        shortfall_beta = -math.expm1(-0.5 * sigma_beta_squared)
        part_0_cos_beta = -attenuation_beta * r * shortfall_beta
        attenuation_beta_2 = attenuation_beta**2
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
    given: Sequence[Floats],
    mean: Filled,
    covariance: Filled,
) -> None:
    """Conversion polar_doppler, unbiased.

    Mean: exactly unbiased estimate of the position. Covariance: error covariance of the unbiased estimate u.
    """
    for i in range(len(given[0])):
        r = given[0][i]
        beta = given[1][i]
        rdot = given[2][i]
        sigma_r = given[3][i]
        sigma_beta = given[4][i]
        sigma_rdot = given[5][i]
        rho = given[6][i]
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
    given: Sequence[Floats],
    mean: Filled,
    covariance: Filled,
) -> None:
    """Conversion polar_doppler, posterior.

    Mean: posterior mean of the position under a flat prior. Covariance: posterior covariance of the position
    under a flat prior.
    """
    for i in range(len(given[0])):
        r = given[0][i]
        beta = given[1][i]
        rdot = given[2][i]
        sigma_r = given[3][i]
        sigma_beta = given[4][i]
        sigma_rdot = given[5][i]
        rho = given[6][i]
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
    given: Sequence[Floats],
    mean: Filled,
    covariance: Filled,
) -> None:
    """Conversion ruv, linear.

    Mean: map from the measured quantities to coordinates. Covariance: covariance of the linearised
    conversion.
    """
    for i in range(len(given[0])):
        r = given[0][i]
        u = given[1][i]
        v = given[2][i]
        sigma_r = given[3][i]
        sigma_u = given[4][i]
        sigma_v = given[5][i]
        rho = given[6][i]
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
    given: Sequence[Floats],
    mean: Filled,
    covariance: Filled,
) -> None:
    """Conversion ruv, second_order.

    Mean: map from the measured quantities to coordinates less the bias of the plain conversion to second
    order. Covariance: covariance of the conversion's quadratic Taylor polynomial.
    """
    for i in range(len(given[0])):
        r = given[0][i]
        u = given[1][i]
        v = given[2][i]
        sigma_r = given[3][i]
        sigma_u = given[4][i]
        sigma_v = given[5][i]
        rho = given[6][i]
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
    given: Sequence[Floats],
    mean: Filled,
    covariance: Filled,
) -> None:
    """Conversion ruv, averaged.

    Mean: map from the measured quantities to coordinates less the bias of the plain conversion, averaged over
    the truth, to fourth order. Covariance: covariance of the plain conversion, averaged over the truth, to
    fourth order, completed to a sum of squares.
    """
    for i in range(len(given[0])):
        r = given[0][i]
        u = given[1][i]
        v = given[2][i]
        sigma_r = given[3][i]
        sigma_u = given[4][i]
        sigma_v = given[5][i]
        rho = given[6][i]
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
    given: Sequence[Floats],
    mean: Filled,
    covariance: Filled,
) -> None:
    """Conversion ruv, unbiased.

    Mean: unbiased estimate of the position, to fourth order. Covariance: error covariance of the unbiased
    estimate u, to fourth order, completed to a sum of squares.
    """
    for i in range(len(given[0])):
        r = given[0][i]
        u = given[1][i]
        v = given[2][i]
        sigma_r = given[3][i]
        sigma_u = given[4][i]
        sigma_v = given[5][i]
        rho = given[6][i]
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
    given: Sequence[Floats],
    mean: Filled,
    covariance: Filled,
) -> None:
    """Conversion ruv, posterior.

    Mean: posterior mean of the position under a flat prior, to fourth order. Covariance: posterior covariance
    of the position under a flat prior, to fourth order, completed to a sum of squares.
    """
    for i in range(len(given[0])):
        r = given[0][i]
        u = given[1][i]
        v = given[2][i]
        sigma_r = given[3][i]
        sigma_u = given[4][i]
        sigma_v = given[5][i]
        rho = given[6][i]
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
    given: Sequence[Floats],
    mean: Filled,
    covariance: Filled,
) -> None:
    """Conversion spherical, linear.

    Mean: map from the measured quantities to coordinates. Covariance: covariance of the linearised
    conversion.
    """
    for i in range(len(given[0])):
        r = given[0][i]
        beta = given[1][i]
        epsilon = given[2][i]
        sigma_r = given[3][i]
        sigma_beta = given[4][i]
        sigma_epsilon = given[5][i]
        rho = given[6][i]
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
    given: Sequence[Floats],
    mean: Filled,
    covariance: Filled,
) -> None:
    """Conversion spherical, second_order.

    Mean: map from the measured quantities to coordinates less the bias of the plain conversion to second
    order. Covariance: covariance of the conversion's quadratic Taylor polynomial.
    """
    for i in range(len(given[0])):
        r = given[0][i]
        beta = given[1][i]
        epsilon = given[2][i]
        sigma_r = given[3][i]
        sigma_beta = given[4][i]
        sigma_epsilon = given[5][i]
        rho = given[6][i]
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
    given: Sequence[Floats],
    mean: Filled,
    covariance: Filled,
) -> None:
    """Conversion spherical, averaged.

    Mean: map from the measured quantities to coordinates less the exact bias of the plain conversion,
    averaged over the truth. Covariance: exact covariance of the plain conversion, averaged over the truth.
    """
    for i in range(len(given[0])):
        r = given[0][i]
        beta = given[1][i]
        epsilon = given[2][i]
        sigma_r = given[3][i]
        sigma_beta = given[4][i]
        sigma_epsilon = given[5][i]
        rho = given[6][i]
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
        attenuation_beta_2 = attenuation_beta**2
        shortfall_beta_2 = -math.expm1(-sigma_beta_squared)
        attenuation_epsilon_2 = attenuation_epsilon**2
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
    given: Sequence[Floats],
    mean: Filled,
    covariance: Filled,
) -> None:
    """Conversion spherical, unbiased.

    Mean: exactly unbiased estimate of the position. Covariance: error covariance of the unbiased estimate u.
    """
    for i in range(len(given[0])):
        r = given[0][i]
        beta = given[1][i]
        epsilon = given[2][i]
        sigma_r = given[3][i]
        sigma_beta = given[4][i]
        sigma_epsilon = given[5][i]
        rho = given[6][i]
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
        attenuation_epsilon_2 = attenuation_epsilon**2
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
    given: Sequence[Floats],
    mean: Filled,
    covariance: Filled,
) -> None:
    """Conversion spherical, posterior.

    Mean: posterior mean of the position under a flat prior. Covariance: posterior covariance of the position
    under a flat prior.
    """
    for i in range(len(given[0])):
        r = given[0][i]
        beta = given[1][i]
        epsilon = given[2][i]
        sigma_r = given[3][i]
        sigma_beta = given[4][i]
        sigma_epsilon = given[5][i]
        rho = given[6][i]
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
        attenuation_epsilon_2 = attenuation_epsilon**2
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
    given: Sequence[Floats],
    mean: Filled,
    covariance: Filled,
) -> None:
    """Conversion spherical_doppler, linear.

    Mean: map from the measured quantities to coordinates. Covariance: covariance of the linearised
    conversion.
    """
    for i in range(len(given[0])):
        r = given[0][i]
        beta = given[1][i]
        epsilon = given[2][i]
        rdot = given[3][i]
        sigma_r = given[4][i]
        sigma_beta = given[5][i]
        sigma_epsilon = given[6][i]
        sigma_rdot = given[7][i]
        rho = given[8][i]
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
    given: Sequence[Floats],
    mean: Filled,
    covariance: Filled,
) -> None:
    """Conversion spherical_doppler, second_order.

    Mean: map from the measured quantities to coordinates less the bias of the plain conversion to second
    order. Covariance: covariance of the conversion's quadratic Taylor polynomial.
    """
    for i in range(len(given[0])):
        r = given[0][i]
        beta = given[1][i]
        epsilon = given[2][i]
        rdot = given[3][i]
        sigma_r = given[4][i]
        sigma_beta = given[5][i]
        sigma_epsilon = given[6][i]
        sigma_rdot = given[7][i]
        rho = given[8][i]
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
    given: Sequence[Floats],
    mean: Filled,
    covariance: Filled,
) -> None:
    """Conversion spherical_doppler, averaged.

    Mean: map from the measured quantities to coordinates less the exact bias of the plain conversion,
    averaged over the truth. Covariance: exact covariance of the plain conversion, averaged over the truth.
    """
    for i in range(len(given[0])):
        r = given[0][i]
        beta = given[1][i]
        epsilon = given[2][i]
        rdot = given[3][i]
        sigma_r = given[4][i]
        sigma_beta = given[5][i]
        sigma_epsilon = given[6][i]
        sigma_rdot = given[7][i]
        rho = given[8][i]
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
        attenuation_beta_2 = attenuation_beta**2
        shortfall_beta_2 = -math.expm1(-sigma_beta_squared)
        attenuation_epsilon_2 = attenuation_epsilon**2
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
    given: Sequence[Floats],
    mean: Filled,
    covariance: Filled,
) -> None:
    """Conversion spherical_doppler, unbiased.

    Mean: exactly unbiased estimate of the position. Covariance: error covariance of the unbiased estimate u.
    """
    for i in range(len(given[0])):
        r = given[0][i]
        beta = given[1][i]
        epsilon = given[2][i]
        rdot = given[3][i]
        sigma_r = given[4][i]
        sigma_beta = given[5][i]
        sigma_epsilon = given[6][i]
        sigma_rdot = given[7][i]
        rho = given[8][i]
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
    given: Sequence[Floats],
    mean: Filled,
    covariance: Filled,
) -> None:
    """Conversion spherical_doppler, posterior.

    Mean: posterior mean of the position under a flat prior. Covariance: posterior covariance of the position
    under a flat prior.
    """
    for i in range(len(given[0])):
        r = given[0][i]
        beta = given[1][i]
        epsilon = given[2][i]
        rdot = given[3][i]
        sigma_r = given[4][i]
        sigma_beta = given[5][i]
        sigma_epsilon = given[6][i]
        sigma_rdot = given[7][i]
        rho = given[8][i]
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
