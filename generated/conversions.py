"""Conversions over arrays; mean, shape (..., n), and covariance, shape (..., n, n), are filled.

Written by radartrack regenerate, generator 1, derivation f035e07357f24eb6; not to be edited.
"""

import numpy as np
import numpy.typing as npt

Floats = npt.NDArray[np.floating]
Filled = Floats


def bistatic_linear(
    path: Floats,
    beta: Floats,
    baseline: Floats,
    sigma_path: Floats,
    sigma_beta: Floats,
    rho: Floats,
    mean: Filled,
    covariance: Filled,
) -> None:
    """Conversion bistatic, linear.

    Mean: map from the measured quantities to coordinates. Covariance: covariance of the linearised
    conversion.
    """
    term_1 = 1.0 / path
    baseline_per_path = baseline * term_1
    cos_beta = np.cos(beta)
    divisor_1 = 2.0 - 2.0 * baseline_per_path * cos_beta
    sigma_path_per_path = sigma_path * term_1
    sum_1 = 1.0 - baseline_per_path
    term_2 = 1.0 / divisor_1
    sum_2 = 1.0 + baseline_per_path
    sin_beta = np.sin(beta)
    sum_3 = baseline_per_path - 2.0 * cos_beta
    sum_4 = 1.0 + baseline_per_path * sum_3
    sum_4_squared = sum_4**2
    sigma_path_per_path_squared = sigma_path_per_path**2
    term_3 = (baseline_per_path - 1.0)**2
    product_1 = sigma_beta * sum_2
    product_5 = product_1 * sin_beta
    product_3 = rho * sigma_path_per_path
    product_6 = sum_1 * sum_4
    product_7 = product_3 * product_6
    del term_1, sigma_path_per_path, sum_4, product_3, product_6
    sum_5 = 4.0 * product_5 * term_3 - 8.0 * cos_beta * product_7
    term_4 = 1.0 / (divisor_1**2)**2
    path_squared = path**2
    product_4 = sigma_path_per_path_squared * sum_4_squared
    sum_6 = 4.0 * cos_beta**2 * product_4 + product_5 * sum_5
    del divisor_1, sigma_path_per_path_squared, sum_4_squared, sum_5
    sum_7 = baseline_per_path - cos_beta
    product_10 = sum_7 * term_3
    sum_8 = 4.0 * product_10 * product_5 - 4.0 * (1.0 + cos_beta * sum_3) * product_7
    del baseline_per_path, term_3, product_5, sum_3
    sum_9 = 4.0 * cos_beta * product_4 * sin_beta + product_1 * sum_8
    sum_10 = 4.0 * product_1 * product_10 - 8.0 * product_7 * sin_beta
    sum_11 = 4.0 * product_4 * sin_beta**2 + product_1 * sum_10 * sum_7
    del sum_8, product_10, product_7, product_1, product_4, sum_10, sum_7
    product_8 = path * sum_1
    product_9 = sum_2 * term_2
    product_11 = product_8 * product_9
    del sum_1, sum_2, term_2, product_8, product_9
    product_2 = path_squared * term_4
    mean[..., 0] = cos_beta * product_11
    mean[..., 1] = product_11 * sin_beta
    del path_squared, term_4, cos_beta, product_11, sin_beta
    covariance[..., 0, 0] = product_2 * sum_6
    covariance[..., 0, 1] = product_2 * sum_9
    covariance[..., 1, 0] = covariance[..., 0, 1]
    covariance[..., 1, 1] = product_2 * sum_11
    del sum_6, sum_9, product_2, sum_11


def bistatic_second_order(
    path: Floats,
    beta: Floats,
    baseline: Floats,
    sigma_path: Floats,
    sigma_beta: Floats,
    rho: Floats,
    mean: Filled,
    covariance: Filled,
) -> None:
    """Conversion bistatic, second_order.

    Mean: map from the measured quantities to coordinates less the bias of the plain conversion to second
    order. Covariance: covariance of the conversion's quadratic Taylor polynomial.
    """
    term_1 = 1.0 / path
    baseline_per_path = baseline * term_1
    cos_beta = np.cos(beta)
    product_7 = baseline_per_path * cos_beta
    divisor_1 = 2.0 - 2.0 * product_7
    sigma_path_per_path = sigma_path * term_1
    product_1 = product_7
    divisor_1_2 = product_1 - 1.0
    divisor_2 = divisor_1_2
    sum_1 = 1.0 - baseline_per_path
    term_2 = 1.0 / divisor_1
    sum_2 = 1.0 + baseline_per_path
    sum_3 = baseline_per_path * (1.0 + product_1) - 3.0 * cos_beta
    sum_4 = 1.0 + baseline_per_path * sum_3
    sin_beta = np.sin(beta)
    cos_beta_squared = cos_beta**2
    sum_5 = 2.0 - cos_beta_squared
    product_16 = baseline_per_path * sum_5
    del term_1, product_1, sum_3, sum_5
    product_2 = product_16
    sum_6 = product_2 - cos_beta
    product_5 = rho * sigma_path_per_path
    product_21 = product_5 * sin_beta
    product_4 = sum_1 * sum_2
    product_19 = product_4 * sigma_beta
    sum_7 = 0.25 * product_19 * sum_6 - 0.5 * product_21 * sum_4
    baseline_per_path_squared = baseline_per_path**2
    sigma_path_per_path_squared = sigma_path_per_path**2
    sin_beta_squared = sin_beta**2
    term_3 = 1.0 / (divisor_1_2 * divisor_1_2**2)
    product_6 = sigma_path_per_path_squared * sin_beta_squared
    product_8 = baseline_per_path_squared * product_6
    sum_8 = 0.5 * cos_beta * product_8 - sigma_beta * sum_7
    product_26 = product_4 * term_2
    sum_9 = cos_beta * product_26 - sum_8 * term_3
    sum_10 = 2.0 * baseline_per_path - cos_beta
    product_14 = baseline_per_path * sum_10
    del sum_7, term_2, sum_8, sum_10
    sum_11 = 1.0 - product_14
    sum_12 = 3.0 * cos_beta_squared + (product_2 - 3.0 * cos_beta) * baseline_per_path
    product_15 = baseline_per_path * sum_12
    sum_13 = product_15 - cos_beta
    product_24 = product_5 * sum_13
    product_9 = sigma_beta * sin_beta
    product_23 = product_9 * sum_11
    sum_14 = 0.25 * product_23 * product_4 + 0.5 * product_24
    sum_15 = 0.5 * product_8 * sin_beta + sigma_beta * sum_14
    sum_16 = product_26 * sin_beta - sum_15 * term_3
    del product_2, sum_12, sum_14, product_26, sum_15, term_3
    term_4 = 1.0 / (divisor_1**2)**2
    term_5 = 1.0 / divisor_2**2
    path_squared = path**2
    sum_17 = divisor_1_2
    sum_17_squared = sum_17**2
    del divisor_1, divisor_2, divisor_1_2, sum_17
    sum_18 = baseline_per_path - 2.0 * cos_beta
    sum_19 = 1.0 + baseline_per_path * sum_18
    sigma_beta_squared = sigma_beta**2
    product_11 = sum_17_squared * sum_19
    product_20 = sigma_beta_squared * sum_6
    sum_20 = 8.0 * cos_beta * product_11 + 8.0 * product_20 * sum_4
    product_3 = cos_beta * sum_18
    sum_21 = baseline_per_path * (6.0 + product_3) - 8.0 * cos_beta
    sum_22 = 8.0 - 2.0 * cos_beta_squared - baseline_per_path * sum_21
    sum_23 = cos_beta * sum_22 - baseline_per_path
    del sum_6, sum_18, sum_21, sum_22
    sum_24 = 2.0 - baseline_per_path * sum_23 + 11.0 * cos_beta_squared
    sum_25 = baseline_per_path * sum_24 - 6.0 * cos_beta
    sum_26 = 1.0 + baseline_per_path * sum_25
    product_18 = cos_beta * sin_beta
    sum_27 = (
        16.0 * baseline_per_path_squared * product_18 * sigma_path_per_path * sum_4
        + 4.0 * rho * sigma_beta * sum_26
    )
    del sum_23, sum_24, sum_25, sum_26
    sum_28 = product_4 * sum_20 - sigma_path_per_path * sin_beta * sum_27
    sum_29 = rho * sum_28 - 4.0 * product_9 * sigma_path_per_path * sum_4**2
    sum_2_squared = sum_2**2
    term_6 = (baseline_per_path - 1.0)**2
    sum_30 = (1.0 - sin_beta_squared) * baseline_per_path - 2.0 * cos_beta
    sum_31 = 1.0 + baseline_per_path * sum_30
    del sum_20, sum_27, sum_28, sum_30
    product_12 = sum_2_squared * term_6
    sum_32 = 4.0 * product_12 * product_9 * sum_31 - sigma_path_per_path * sum_29
    del sum_2_squared, product_9, sigma_path_per_path, sum_29, sum_31
    sum_33 = (
        2.0 * (cos_beta - product_16)**2 * product_12 * sigma_beta * sigma_beta_squared
        + sin_beta * sum_32
    )
    sum_19_squared = sum_19**2
    baseline_per_path_squared_squared = baseline_per_path_squared**2
    sin_beta_squared_squared = sin_beta_squared**2
    product_25 = sum_17_squared * sum_19_squared
    del product_16, sum_32, sum_19, sum_19_squared
    product_17 = baseline_per_path_squared_squared * sigma_path_per_path_squared
    product_22 = product_17 * sin_beta_squared_squared
    sum_34 = 4.0 * cos_beta_squared * product_25 + 8.0 * (1.0 - sin_beta) * product_22 * (1.0 + sin_beta)
    sum_35 = sigma_path_per_path_squared * sum_34 + sigma_beta * sum_33
    del baseline_per_path_squared_squared, product_17, sin_beta_squared_squared, sum_33, sum_34
    sum_36 = 3.0 - 4.0 * sin_beta_squared - (1.0 + 2.0 * sin_beta_squared) * product_7
    sum_37 = (3.0 - 6.0 * sin_beta_squared) * cos_beta - baseline_per_path * sum_36
    sum_38 = 1.0 - 2.0 * sin_beta_squared - baseline_per_path * sum_37
    product_27 = product_11 * product_4
    del sum_36, sum_37, product_11, product_4
    sum_39 = 4.0 * product_27 * (1.0 + product_3) + 8.0 * product_8 * sum_38
    sum_40 = baseline_per_path - cos_beta
    sum_41 = 4.0 * sum_17_squared * sum_40 - 2.0 * product_20 * sum_11
    del product_3, sum_38, product_20, sum_11
    sum_42 = 3.0 * baseline_per_path - 2.0 * cos_beta
    sum_43 = cos_beta * (8.0 + cos_beta * sum_42) - 4.0 * baseline_per_path
    sum_44 = 13.0 - 10.0 * cos_beta_squared + baseline_per_path * sum_43
    sum_45 = (14.0 - 2.0 * cos_beta_squared) * cos_beta - baseline_per_path * sum_44
    sum_46 = 2.0 - baseline_per_path * sum_45 + 11.0 * cos_beta_squared
    del sum_42, sum_43, sum_44, sum_45
    sum_47 = cos_beta * sum_46 - 4.0 * baseline_per_path * baseline_per_path_squared
    sum_48 = baseline_per_path * sum_47 - 6.0 * cos_beta_squared
    rho_squared = rho**2
    sum_49 = baseline_per_path * sum_48 + cos_beta
    sum_50 = 4.0 * sum_13 * sum_4 - 4.0 * rho_squared * sum_49
    del sum_46, sum_47, sum_48, sum_4, sum_49
    sum_51 = product_12 * sum_41 + sigma_path_per_path_squared * sum_50
    sum_52 = 3.0 + 2.0 * product_7 + 2.0 * sin_beta_squared
    del product_12, sum_41, sum_50, product_7
    sum_53 = 1.0 + sin_beta_squared * sum_52
    sum_54 = (4.0 + 12.0 * sin_beta_squared) * cos_beta - baseline_per_path * sum_53
    sum_55 = 6.0 - baseline_per_path * sum_54 + (1.0 - 6.0 * sin_beta_squared) * sin_beta_squared
    sum_56 = (4.0 - 4.0 * sin_beta_squared) * cos_beta - baseline_per_path * sum_55
    del sum_52, sum_53, sum_54, sum_55
    sum_57 = 1.0 - 2.0 * sin_beta_squared - baseline_per_path * sum_56
    sum_58 = sin_beta * sum_51 - 4.0 * product_19 * product_5 * sum_57
    del sum_56, product_19, sin_beta, sum_51, sum_57
    sum_59 = sigma_beta * sum_58 - product_5 * sum_39
    sum_60 = 4.0 * product_25 + 8.0 * product_22
    del product_5, sum_39, sum_58, product_22, product_25
    sum_61 = product_18 * sigma_path_per_path_squared * sum_60 + sigma_beta * sum_59
    sum_62 = 8.0 * product_27 * sum_40 - 16.0 * product_8 * sum_13
    del product_18, sum_59, product_27, product_8, sum_13
    sum_63 = (
        2.0 * (product_14 - 1.0)**2 * sigma_beta_squared * sin_beta_squared
        + 4.0 * sum_17_squared * sum_40**2
    )
    del product_14, sigma_beta_squared, sin_beta_squared, sum_17_squared, sum_40
    sum_64 = 8.0 * product_23 * product_24 * sum_1 + sum_2 * sum_63 * term_6
    del product_23, product_24, sum_1, sum_63, term_6
    sum_65 = 5.0 * baseline_per_path - 2.0 * cos_beta
    sum_66 = cos_beta * (10.0 + cos_beta * sum_65) - 12.0 * baseline_per_path
    sum_67 = 33.0 - 12.0 * cos_beta_squared + baseline_per_path * sum_66
    sum_68 = (20.0 - 2.0 * cos_beta_squared) * cos_beta - baseline_per_path * sum_67
    sum_69 = 2.0 + 14.0 * baseline_per_path_squared + cos_beta * sum_68
    del sum_65, sum_66, sum_67, sum_68
    sum_70 = 6.0 - 8.0 * baseline_per_path_squared
    sum_71 = baseline_per_path * sum_70 + cos_beta * sum_69
    sum_72 = 2.0 - baseline_per_path * sum_71 + (2.0 + 11.0 * cos_beta_squared) * cos_beta_squared
    del baseline_per_path_squared, sum_69, sum_70, sum_71
    sum_73 = baseline_per_path * sum_72 - 6.0 * cos_beta * cos_beta_squared
    sum_74 = baseline_per_path * sum_73 + cos_beta_squared
    del sum_72, baseline_per_path, cos_beta_squared, sum_73
    sum_75 = 4.0 * (cos_beta - product_15)**2 + 4.0 * rho_squared * sum_74
    del cos_beta, product_15, rho_squared, sum_74
    sum_76 = sigma_path_per_path_squared * sum_75 + sum_2 * sum_64
    del sigma_path_per_path_squared, sum_2, sum_64, sum_75
    sum_77 = sigma_beta * sum_76 - product_21 * sum_62
    sum_78 = product_6 * sum_60 + sigma_beta * sum_77
    del product_21, sum_62, sum_76, product_6, sum_60, sum_77
    product_10 = path_squared * term_4
    product_13 = product_10 * term_5
    del path_squared, term_4, product_10, term_5
    mean[..., 0] = path * sum_9
    mean[..., 1] = path * sum_16
    covariance[..., 0, 0] = product_13 * sum_35
    covariance[..., 0, 1] = product_13 * sum_61
    del sum_9, sum_16, sum_35, sum_61
    covariance[..., 1, 0] = covariance[..., 0, 1]
    covariance[..., 1, 1] = product_13 * sum_78


def bistatic_averaged(
    path: Floats,
    beta: Floats,
    baseline: Floats,
    sigma_path: Floats,
    sigma_beta: Floats,
    rho: Floats,
    mean: Filled,
    covariance: Filled,
) -> None:
    """Conversion bistatic, averaged.

    Mean: map from the measured quantities to coordinates less the bias of the plain conversion, averaged over
    the truth, to fourth order. Covariance: covariance of the plain conversion, averaged over the truth, to
    fourth order, completed to a sum of squares.
    """
    term_1 = 1.0 / path
    baseline_per_path = baseline * term_1
    cos_beta = np.cos(beta)
    product_13 = baseline_per_path * cos_beta
    product_1 = -2.0 * product_13
    divisor_1 = 2.0 + product_1
    sigma_path_per_path = sigma_path * term_1
    sum_1 = 1.0 - baseline_per_path
    sum_2 = 1.0 + baseline_per_path
    cos_beta_squared = cos_beta**2
    product_2 = (3.0 - cos_beta_squared) * baseline_per_path
    baseline_per_path_squared = baseline_per_path**2
    sigma_path_per_path_squared = sigma_path_per_path**2
    sum_3 = 1.0 + (product_2 - 3.0 * cos_beta) * cos_beta
    product_3 = product_13
    sum_4 = product_3 - 1.0
    sum_4_squared = sum_4**2
    sum_5 = baseline_per_path * (1.0 + product_3) - 3.0 * cos_beta
    sum_6 = 1.0 + baseline_per_path * sum_5
    del term_1, sum_4, product_3, sum_5
    sin_beta = np.sin(beta)
    product_10 = baseline_per_path_squared * sigma_path_per_path_squared
    sum_7 = 144.0 * product_10 * sum_3 + 16.0 * sum_4_squared * sum_6
    product_4 = (20.0 - cos_beta_squared) * baseline_per_path
    sum_8 = 20.0 + (product_4 - 11.0 * cos_beta) * cos_beta
    sum_9 = cos_beta * sum_8 - 24.0 * baseline_per_path
    sum_10 = 8.0 - 11.0 * cos_beta_squared + baseline_per_path * sum_9
    del sum_3, sum_6, sum_8, sum_9
    sigma_beta_squared = sigma_beta**2
    sum_11 = baseline_per_path * sum_10 - cos_beta
    product_5 = (2.0 - cos_beta_squared) * baseline_per_path
    sum_12 = 8.0 * (product_5 - cos_beta) * sum_4_squared - 6.0 * sigma_beta_squared * sum_11
    product_6 = (6.0 - cos_beta_squared) * baseline_per_path
    sum_13 = 29.0 - 3.0 * cos_beta_squared - (product_6 - 11.0 * cos_beta) * baseline_per_path
    sum_14 = cos_beta * sum_13 - 18.0 * baseline_per_path
    sum_15 = 7.0 - 17.0 * cos_beta_squared + baseline_per_path * sum_14
    del sum_10, sum_11, sum_13, sum_14
    sum_16 = baseline_per_path * sum_15 - 5.0 * cos_beta
    sum_17 = 1.0 + baseline_per_path * sum_16
    sum_18 = 4.0 * baseline_per_path - 3.0 * cos_beta
    sum_19 = cos_beta * (13.0 + cos_beta * sum_18) - 6.0 * baseline_per_path
    sum_20 = 7.0 - 9.0 * cos_beta_squared + baseline_per_path * sum_19
    del sum_15, sum_16, sum_18, sum_19
    rho_squared = rho**2
    sum_21 = cos_beta * sum_20 - 6.0 * baseline_per_path
    product_15 = rho * sigma_beta
    sum_22 = (
        24.0 * product_15 * sin_beta * sum_17
        + (24.0 + 48.0 * rho_squared) * baseline_per_path_squared * sigma_path_per_path * sum_21
    )
    product_14 = sum_1 * sum_2
    del sum_20, sum_17, sum_21, sum_1
    sum_23 = product_14 * sum_12 + sigma_path_per_path * sum_22
    product_11 = sigma_path_per_path * sin_beta
    product_18 = product_11 * rho
    sum_24 = sigma_beta * sum_23 - product_18 * sum_7
    del sum_12, sum_22, sum_23, sum_7
    sin_beta_squared = sin_beta**2
    sum_25 = 144.0 * sigma_path_per_path_squared + 16.0 * sum_4_squared
    term_2 = 1.0 / (divisor_1**2)**2
    product_12 = product_10 * sin_beta_squared
    sum_26 = cos_beta * product_12 * sum_25 - sigma_beta * sum_24
    term_3 = 1.0 / divisor_1
    sum_27 = cos_beta * product_14 + sum_26 * term_2
    sum_28 = (1.0 - sin_beta_squared) * baseline_per_path - 2.0 * cos_beta
    sum_29 = 16.0 + 144.0 * sigma_path_per_path_squared + 16.0 * baseline_per_path * sum_28
    del sum_24, sum_25, sum_26, sum_28
    sum_30 = 8.0 * baseline_per_path - cos_beta
    sum_31 = cos_beta * (20.0 + cos_beta * sum_30) - 24.0 * baseline_per_path
    sum_32 = 20.0 - 11.0 * cos_beta_squared + baseline_per_path * sum_31
    sum_33 = baseline_per_path * sum_32 - 11.0 * cos_beta
    sum_34 = 1.0 - baseline_per_path * sum_33
    del sum_30, sum_31, sum_32, sum_33
    sum_35 = 2.0 * baseline_per_path - cos_beta
    sum_36 = 1.0 - baseline_per_path * sum_35
    sum_37 = 8.0 * sum_36 * sum_4_squared - 6.0 * sigma_beta_squared * sum_34
    sum_38 = cos_beta * (5.0 + cos_beta * sum_35) - 4.0 * baseline_per_path
    sum_39 = 1.0 - 3.0 * cos_beta_squared + baseline_per_path * sum_38
    del sum_34, sum_36, sum_35, sum_38
    sum_40 = product_14 * sum_37 - (72.0 + 144.0 * rho_squared) * product_10 * sum_39
    sum_41 = 31.0 - 3.0 * cos_beta_squared - (product_4 - 19.0 * cos_beta) * baseline_per_path
    sum_42 = cos_beta * sum_41 - 32.0 * baseline_per_path
    del sum_37, sum_39, product_4, sum_41
    sum_43 = 20.0 - 24.0 * baseline_per_path_squared - cos_beta * sum_42
    sum_44 = (21.0 - 17.0 * cos_beta_squared) * cos_beta - baseline_per_path * sum_43
    sum_45 = baseline_per_path * sum_44 - 5.0 * cos_beta_squared
    sum_46 = baseline_per_path * sum_45 + cos_beta
    del sum_42, sum_43, sum_44, sum_45
    product_26 = product_15 * sigma_path_per_path
    sum_47 = 24.0 * product_26 * sum_46 + sin_beta * sum_40
    sum_48 = baseline_per_path * (3.0 + sin_beta_squared) - 3.0 * cos_beta
    sum_49 = 3.0 * cos_beta_squared + (product_5 - 3.0 * cos_beta) * baseline_per_path
    sum_50 = baseline_per_path * sum_49 - cos_beta
    sum_51 = 144.0 * product_12 * sum_48 + 16.0 * sum_4_squared * sum_50
    del sum_40, sum_46, sum_49, sum_48, sum_50
    product_24 = rho * sigma_path_per_path
    sum_52 = product_24 * sum_51 + sigma_beta * sum_47
    sum_53 = product_12 * sin_beta * sum_29 + sigma_beta * sum_52
    del sum_47, sum_51, sum_29, sum_52
    product_19 = product_14 * sin_beta
    sum_54 = product_19 + sum_53 * term_2
    term_4 = 1.0 / ((divisor_1**2)**2)**2
    path_squared = path**2
    sum_55 = (2.0 - 3.0 * sin_beta_squared) * cos_beta - (2.0 - 2.0 * sin_beta_squared) * baseline_per_path
    sum_56 = 3.0 - 9.0 * cos_beta_squared - (product_2 - 9.0 * cos_beta) * baseline_per_path
    sum_57 = cos_beta * sum_56 - 3.0 * baseline_per_path
    del sum_53, term_2, divisor_1, sum_56
    sum_58 = 1.0 - 3.0 * cos_beta_squared - baseline_per_path * sum_57
    sum_59 = 768.0 * cos_beta * sum_4_squared * sum_58 - 4608.0 * product_12 * sum_55
    sum_4_squared_squared = sum_4_squared**2
    sum_60 = baseline_per_path - 2.0 * cos_beta
    sum_61 = 1.0 + baseline_per_path * sum_60
    product_21 = sum_4_squared_squared * sum_61
    product_22 = product_14 * product_21
    del sum_57, sum_55, sum_58, product_21
    sum_62 = 128.0 * cos_beta * product_22 - product_10 * sum_59
    sum_2_squared = sum_2**2
    term_5 = (baseline_per_path - 1.0)**2
    sum_63 = (40.0 - 7.0 * cos_beta_squared) * baseline_per_path - 22.0 * cos_beta
    sum_64 = cos_beta * (28.0 + cos_beta * sum_63) - 36.0 * baseline_per_path
    sum_65 = 4.0 - 7.0 * cos_beta_squared + baseline_per_path * sum_64
    del sum_59, sum_2, sum_63, sum_64
    sum_66 = 64.0 * sin_beta_squared * sum_4_squared - 32.0 * sigma_beta_squared * sum_65
    sum_67 = 1.0 - (product_6 - 4.0 * cos_beta) * baseline_per_path
    sigma_beta_squared_squared = sigma_beta_squared**2
    sum_68 = 64.0 * sigma_beta_squared_squared * sin_beta_squared * sum_67**2 + sum_4_squared * sum_66
    product_7 = cos_beta * cos_beta_squared
    sum_69 = (22.0 - 3.0 * cos_beta_squared) * baseline_per_path - 60.0 * cos_beta
    sum_70 = 45.0 - 45.0 * cos_beta_squared - baseline_per_path * sum_69
    sum_71 = cos_beta * sum_70 - 28.0 * baseline_per_path
    del sum_65, sum_66, sum_69, sum_70
    sum_72 = 12.0 * product_7 + (4.0 - cos_beta * sum_71) * baseline_per_path
    sum_73 = baseline_per_path * sum_72 - 3.0 * cos_beta_squared
    sum_74 = 2.0 * baseline_per_path - 3.0 * cos_beta
    sum_75 = 7.0 - 3.0 * cos_beta_squared - (product_5 - 4.0 * cos_beta) * baseline_per_path
    sum_76 = cos_beta * sum_75 - 4.0 * baseline_per_path
    del sum_71, sum_72, product_5, sum_75
    sum_77 = baseline_per_path * sum_76 - 4.0 * cos_beta_squared
    sum_78 = baseline_per_path * sum_77 + cos_beta
    sum_79 = 1024.0 * (1.0 + cos_beta * sum_74) * product_15 * sum_78 - 512.0 * product_11 * sum_73
    del sum_76, sum_77, sum_73, sum_74
    sum_80 = 105.0 - 12.0 * cos_beta_squared
    sum_81 = 128.0 - 46.0 * cos_beta_squared
    product_8 = (4.0 - cos_beta_squared) * baseline_per_path
    sum_82 = 72.0 - 9.0 * cos_beta_squared - (product_8 - 10.0 * cos_beta) * baseline_per_path
    sum_83 = cos_beta * sum_82 - 38.0 * baseline_per_path
    sum_84 = 93.0 - 4.0 * baseline_per_path_squared - cos_beta * sum_83
    sum_85 = cos_beta * sum_81 - baseline_per_path * sum_84
    del sum_82, sum_83, sum_81, sum_84
    sum_86 = 114.0 - cos_beta_squared * sum_80 + baseline_per_path * sum_85
    sum_87 = 74.0 - 28.0 * baseline_per_path_squared
    sum_88 = cos_beta * sum_86 - baseline_per_path * sum_87
    del sum_80, sum_85, sum_86, sum_87
    sum_89 = 2.0 - baseline_per_path * sum_88 + (66.0 - 36.0 * cos_beta_squared) * cos_beta_squared
    sum_90 = 7.0 - 22.0 * baseline_per_path_squared
    sum_91 = baseline_per_path * sum_90 + cos_beta * sum_89
    sum_92 = 1.0 - baseline_per_path * sum_91 + (10.0 + 13.0 * cos_beta_squared) * cos_beta_squared
    del sum_88, sum_89, sum_90, sum_91
    sum_93 = baseline_per_path * sum_92 - 8.0 * product_7
    sum_94 = baseline_per_path * sum_93 + cos_beta_squared
    sum_95 = 102.0 - 30.0 * cos_beta_squared
    sum_96 = 7.0 * baseline_per_path - 14.0 * cos_beta
    sum_97 = cos_beta * (72.0 + cos_beta * sum_96) - 11.0 * baseline_per_path
    sum_98 = 111.0 - 88.0 * cos_beta_squared + baseline_per_path * sum_97
    del sum_92, sum_93, sum_96, sum_97
    sum_99 = cos_beta * sum_95 - baseline_per_path * sum_98
    sum_100 = 24.0 - 50.0 * baseline_per_path_squared - cos_beta * sum_99
    sum_101 = (27.0 - 77.0 * cos_beta_squared) * cos_beta - baseline_per_path * sum_100
    del sum_95, sum_98, sum_99, sum_100
    sum_102 = 2.0 - 11.0 * baseline_per_path_squared - cos_beta * sum_101
    sum_103 = baseline_per_path * sum_102 + (18.0 - 42.0 * cos_beta_squared) * cos_beta
    sum_104 = 3.0 - 7.0 * cos_beta_squared - baseline_per_path * sum_103
    product_16 = baseline_per_path_squared * product_11
    sum_105 = 512.0 * sigma_beta_squared * sum_94 - product_16 * sum_79 + 64.0 * sum_104 * sum_4_squared
    del sum_101, sum_102, sum_103, sum_104, sum_79, sum_94
    sum_106 = 5.0 * baseline_per_path - 9.0 * cos_beta
    sum_107 = cos_beta * (48.0 + cos_beta * sum_106) - 10.0 * baseline_per_path
    sum_108 = 81.0 - 51.0 * cos_beta_squared + baseline_per_path * sum_107
    sum_109 = (92.0 - 24.0 * cos_beta_squared) * cos_beta - baseline_per_path * sum_108
    sum_110 = 28.0 - 34.0 * baseline_per_path_squared - cos_beta * sum_109
    del sum_106, sum_107, sum_108, sum_109
    sum_111 = (11.0 - 36.0 * cos_beta_squared) * cos_beta - baseline_per_path * sum_110
    sum_112 = 1.0 - 6.0 * cos_beta_squared - baseline_per_path * sum_111
    sum_113 = cos_beta * sum_112 - 10.0 * baseline_per_path * baseline_per_path_squared
    product_25 = product_16 * sigma_beta
    sum_114 = 512.0 * product_25 * sum_113 - rho * sum_105
    del sum_110, sum_111, sum_112, sum_105, sum_113
    sum_115 = (10.0 - 3.0 * cos_beta_squared) * baseline_per_path - 24.0 * cos_beta
    sum_116 = 27.0 - 18.0 * cos_beta_squared - baseline_per_path * sum_115
    sum_117 = cos_beta * sum_116 - 16.0 * baseline_per_path
    sum_118 = 12.0 * product_7 + (1.0 - cos_beta * sum_117) * baseline_per_path
    sum_119 = baseline_per_path * sum_118 - 3.0 * cos_beta_squared
    del sum_115, sum_116, sum_117, sum_118
    sum_120 = 5.0 * baseline_per_path - 4.0 * cos_beta
    product_9 = cos_beta * sum_120
    sum_121 = cos_beta * (30.0 + product_9) - 7.0 * baseline_per_path
    sum_122 = 63.0 - 50.0 * cos_beta_squared + baseline_per_path * sum_121
    sum_123 = (48.0 - 12.0 * cos_beta_squared) * cos_beta - baseline_per_path * sum_122
    sum_124 = 12.0 - 22.0 * baseline_per_path_squared - cos_beta * sum_123
    del sum_120, sum_121, sum_122, sum_123
    sum_125 = (21.0 - 49.0 * cos_beta_squared) * cos_beta - baseline_per_path * sum_124
    sum_126 = 2.0 + 7.0 * baseline_per_path_squared + cos_beta * sum_125
    sum_127 = (18.0 - 30.0 * cos_beta_squared) * cos_beta - baseline_per_path * sum_126
    sum_128 = 3.0 - 5.0 * cos_beta_squared - baseline_per_path * sum_127
    del sum_124, sum_125, sum_126, sum_127
    sum_129 = 120.0 - 72.0 * cos_beta_squared
    sum_130 = 204.0 - 21.0 * cos_beta_squared
    sum_131 = 224.0 - 88.0 * cos_beta_squared
    sum_132 = 162.0 - 18.0 * cos_beta_squared - (product_8 - 16.0 * cos_beta) * baseline_per_path
    sum_133 = cos_beta * sum_132 - 80.0 * baseline_per_path
    sum_134 = 192.0 - 4.0 * baseline_per_path_squared - cos_beta * sum_133
    sum_135 = cos_beta * sum_131 - baseline_per_path * sum_134
    del product_8, sum_132, sum_133, sum_131, sum_134
    sum_136 = 225.0 - cos_beta_squared * sum_130 + baseline_per_path * sum_135
    sum_137 = 128.0 - 64.0 * baseline_per_path_squared
    sum_138 = cos_beta * sum_136 - baseline_per_path * sum_137
    del sum_130, sum_135, sum_136, sum_137
    sum_139 = 16.0 - cos_beta_squared * sum_129 + baseline_per_path * sum_138
    sum_140 = 28.0 - 40.0 * baseline_per_path_squared
    sum_141 = cos_beta * sum_139 - baseline_per_path * sum_140
    del sum_129, sum_138, sum_139, sum_140
    sum_142 = 4.0 - (2.0 - 22.0 * cos_beta_squared) * cos_beta_squared + baseline_per_path * sum_141
    sum_143 = baseline_per_path * sum_142 - 8.0 * product_7
    sum_144 = baseline_per_path * sum_143 + cos_beta_squared
    del sum_141, product_7, sum_142, sum_143
    sum_145 = (
        256.0 * product_12 * sum_119
        - rho * sum_114
        + 64.0 * sigma_beta_squared * sum_144
        + 64.0 * sum_128 * sum_4_squared
    )
    del sum_114, sum_119, sum_128, sum_144
    sum_146 = 7.0 * baseline_per_path - 2.0 * cos_beta
    sum_147 = cos_beta * (34.0 + cos_beta * sum_146) - 18.0 * baseline_per_path
    sum_148 = 37.0 - 25.0 * cos_beta_squared + baseline_per_path * sum_147
    sum_149 = cos_beta * sum_148 - 18.0 * baseline_per_path
    sum_150 = 6.0 - baseline_per_path * sum_149 + 16.0 * cos_beta_squared
    del sum_146, sum_147, sum_148, sum_149
    sum_151 = baseline_per_path * sum_150 - 7.0 * cos_beta
    sum_152 = 128.0 * sum_151 * sum_4_squared + 384.0 * sigma_beta_squared * sum_67 * sum_78
    product_31 = product_15 * product_19
    del sum_150, sum_151, sum_78, product_19
    sum_153 = product_31 * sum_152 - sigma_path_per_path * sum_145
    product_20 = sum_2_squared * term_5
    del sum_145, sum_152, sum_2_squared, term_5
    sum_154 = product_20 * sum_68 - sigma_path_per_path * sum_153
    sum_155 = sigma_beta * sum_154 - product_18 * sum_62
    del sum_153, sum_68, sum_154, sum_62
    sum_61_squared = sum_61**2
    sum_156 = 2.0 + (product_2 - 4.0 * cos_beta) * baseline_per_path
    product_28 = sum_156 * sum_4_squared
    sum_157 = (
        2304.0 * (1.0 - sin_beta) * product_10 * (1.0 + sin_beta) * sin_beta_squared**2
        + 384.0 * (1.0 - cos_beta) * (1.0 + cos_beta) * cos_beta_squared * product_28
    )
    product_30 = sum_4_squared_squared * sum_61_squared
    del sum_61, product_2, sum_156, sum_4_squared_squared, sum_61_squared
    sum_158 = 64.0 * cos_beta_squared * product_30 + product_10 * sum_157
    sum_159 = sigma_path_per_path_squared * sum_158 + sigma_beta * sum_155
    del product_10, sum_157, sum_155, sum_158
    sum_160 = 5.0 - 5.0 * product_13 - 6.0 * sin_beta_squared
    sum_161 = (9.0 - 2.0 * cos_beta_squared) * baseline_per_path - 22.0 * cos_beta
    sum_162 = 1.0 - 18.0 * cos_beta_squared - baseline_per_path * sum_161
    sum_163 = cos_beta * sum_162 - 3.0 * baseline_per_path
    sum_164 = 1.0 - 6.0 * cos_beta_squared - baseline_per_path * sum_163
    sum_165 = 384.0 * sum_164 * sum_4_squared - 2304.0 * product_12 * sum_160
    del sum_161, sum_162, sum_163, sum_160, sum_164
    sum_166 = 64.0 * (1.0 + cos_beta * sum_60) * product_22 - product_12 * sum_165
    sum_167 = 16.0 * baseline_per_path - 7.0 * cos_beta
    sum_168 = cos_beta * (40.0 + cos_beta * sum_167) - 36.0 * baseline_per_path
    sum_169 = 16.0 - 22.0 * cos_beta_squared + baseline_per_path * sum_168
    del sum_165, sum_60, sum_167, sum_168
    sum_170 = baseline_per_path * sum_169 - 7.0 * cos_beta
    sum_171 = baseline_per_path - cos_beta
    product_29 = sum_171 * sum_4_squared
    sum_172 = 64.0 * product_29 - 32.0 * sigma_beta_squared * sum_170
    sum_173 = 4.0 * baseline_per_path - cos_beta
    sum_174 = cos_beta * (4.0 + cos_beta * sum_173) - 6.0 * baseline_per_path
    sum_175 = 4.0 - 4.0 * cos_beta_squared + baseline_per_path * sum_174
    del sum_169, sum_170, sum_173, sum_174
    sum_176 = baseline_per_path * sum_175 - cos_beta
    sum_177 = 64.0 * sigma_beta_squared_squared * sum_176 * sum_67 + sum_172 * sum_4_squared
    sum_178 = 196.0 - 21.0 * cos_beta_squared
    sum_179 = 280.0 - 126.0 * cos_beta_squared
    sum_180 = (24.0 - cos_beta_squared) * baseline_per_path - 46.0 * cos_beta
    sum_181 = 190.0 - 18.0 * cos_beta_squared - baseline_per_path * sum_180
    del sum_175, sum_172, sum_67, sum_180
    sum_182 = cos_beta * sum_181 - 146.0 * baseline_per_path
    sum_183 = 188.0 - 36.0 * baseline_per_path_squared - cos_beta * sum_182
    sum_184 = cos_beta * sum_179 - baseline_per_path * sum_183
    del sum_181, sum_182, sum_179, sum_183
    sum_185 = 121.0 - cos_beta_squared * sum_178 + baseline_per_path * sum_184
    sum_186 = 74.0 - 72.0 * baseline_per_path_squared
    sum_187 = cos_beta * sum_185 - baseline_per_path * sum_186
    del sum_178, sum_184, sum_185, sum_186
    sum_188 = 10.0 - (94.0 - 72.0 * cos_beta_squared) * cos_beta_squared + baseline_per_path * sum_187
    sum_189 = baseline_per_path * sum_188 + (2.0 + 22.0 * cos_beta_squared) * cos_beta
    sum_190 = baseline_per_path * sum_189 - 8.0 * cos_beta_squared
    sum_191 = baseline_per_path * sum_190 + cos_beta
    del sum_187, sum_188, sum_189, sum_190
    sum_192 = 8.0 - 11.0 * sin_beta_squared - product_13 * (5.0 + sin_beta_squared)
    sum_193 = 6.0 * cos_beta * sin_beta_squared + baseline_per_path * sum_192
    sum_194 = 4.0 - 4.0 * sin_beta_squared - baseline_per_path * sum_193
    sum_195 = baseline_per_path * sum_194 - cos_beta
    sum_196 = 212.0 - 24.0 * cos_beta_squared
    sum_197 = 308.0 - 129.0 * cos_beta_squared
    sum_198 = (24.0 - 2.0 * cos_beta_squared) * baseline_per_path - 41.0 * cos_beta
    sum_199 = 194.0 - 18.0 * cos_beta_squared - baseline_per_path * sum_198
    del sum_192, sum_193, sum_194, sum_198
    sum_200 = cos_beta * sum_199 - 139.0 * baseline_per_path
    sum_201 = 214.0 - 36.0 * baseline_per_path_squared - cos_beta * sum_200
    sum_202 = cos_beta * sum_197 - baseline_per_path * sum_201
    del sum_199, sum_200, sum_197, sum_201
    sum_203 = 104.0 - cos_beta_squared * sum_196 + baseline_per_path * sum_202
    sum_204 = 55.0 - 72.0 * baseline_per_path_squared
    sum_205 = cos_beta * sum_203 - baseline_per_path * sum_204
    del sum_196, sum_202, sum_203, sum_204
    sum_206 = 1.0 - baseline_per_path * sum_205 + (89.0 - 72.0 * cos_beta_squared) * cos_beta_squared
    sum_207 = (16.0 + 26.0 * cos_beta_squared) * cos_beta - baseline_per_path * sum_206
    sum_208 = baseline_per_path * sum_207 - 16.0 * cos_beta_squared
    sum_209 = 2.0 * cos_beta + baseline_per_path * sum_208
    del sum_205, sum_206, sum_207, sum_208
    sum_210 = (12.0 - cos_beta_squared) * baseline_per_path - 26.0 * cos_beta
    sum_211 = 9.0 - 15.0 * cos_beta_squared - baseline_per_path * sum_210
    sum_212 = cos_beta * sum_211 - 6.0 * baseline_per_path
    sum_213 = baseline_per_path * sum_212 - 4.0 * cos_beta_squared
    sum_214 = baseline_per_path * sum_213 + cos_beta
    del sum_210, sum_211, sum_212, sum_213
    sum_215 = 41.0 + 5.0 * product_13 + 6.0 * sin_beta_squared
    sum_216 = 29.0 - 13.0 * product_13 - sin_beta_squared * sum_215
    sum_217 = (4.0 - 51.0 * sin_beta_squared) * cos_beta - baseline_per_path * sum_216
    sum_218 = 32.0 - (17.0 + 18.0 * sin_beta_squared) * sin_beta_squared + baseline_per_path * sum_217
    sum_219 = (25.0 - 24.0 * sin_beta_squared) * cos_beta - baseline_per_path * sum_218
    del sum_215, sum_216, sum_217, sum_218
    sum_220 = 5.0 - 6.0 * sin_beta_squared - baseline_per_path * sum_219
    sum_221 = 512.0 * product_15 * sum_220 - 1536.0 * product_11 * sum_214
    sum_222 = 106.0 - 30.0 * cos_beta_squared
    sum_223 = 13.0 * baseline_per_path - 14.0 * cos_beta
    sum_224 = cos_beta * (112.0 + cos_beta * sum_223) - 36.0 * baseline_per_path
    del sum_219, sum_214, sum_220, sum_223
    sum_225 = 83.0 - 110.0 * cos_beta_squared + baseline_per_path * sum_224
    sum_226 = cos_beta * sum_222 - baseline_per_path * sum_225
    sum_227 = 8.0 - 36.0 * baseline_per_path_squared - cos_beta * sum_226
    del sum_224, sum_222, sum_225, sum_226
    sum_228 = baseline_per_path * sum_227 + (14.0 + 77.0 * cos_beta_squared) * cos_beta
    sum_229 = baseline_per_path * sum_228 - 42.0 * cos_beta_squared
    sum_230 = 7.0 * cos_beta + baseline_per_path * sum_229
    sum_231 = 64.0 * sum_230 * sum_4_squared - 256.0 * sigma_beta_squared * sum_209 - product_16 * sum_221
    del sum_227, sum_228, sum_229, sum_209, sum_221, sum_230
    sum_232 = 125.0 - 144.0 * sin_beta_squared
    sum_233 = 112.0 + 96.0 * sin_beta_squared
    sum_234 = 14.0 - 291.0 * sin_beta_squared
    sum_235 = 226.0 + 36.0 * sin_beta_squared + 37.0 * product_13
    sum_236 = 154.0 - 71.0 * product_13 - sin_beta_squared * sum_235
    sum_237 = cos_beta * sum_234 - baseline_per_path * sum_236
    sum_238 = 172.0 - sin_beta_squared * sum_233 + baseline_per_path * sum_237
    del sum_235, sum_234, sum_236, sum_233, sum_237
    sum_239 = cos_beta * sum_232 - baseline_per_path * sum_238
    sum_240 = 22.0 - 24.0 * sin_beta_squared - baseline_per_path * sum_239
    sum_241 = 128.0 * product_25 * sum_240 - rho * sum_231
    del sum_232, sum_238, sum_239, product_25, sum_231, sum_240
    sum_242 = cos_beta * (56.0 + product_9) - 18.0 * baseline_per_path
    sum_243 = 49.0 - 58.0 * cos_beta_squared + baseline_per_path * sum_242
    sum_244 = (62.0 - 12.0 * cos_beta_squared) * cos_beta - baseline_per_path * sum_243
    sum_245 = 2.0 + 18.0 * baseline_per_path_squared + cos_beta * sum_244
    sum_246 = (16.0 + 49.0 * cos_beta_squared) * cos_beta - baseline_per_path * sum_245
    del sum_242, sum_243, sum_244, sum_245
    sum_247 = baseline_per_path * sum_246 - 30.0 * cos_beta_squared
    sum_248 = 5.0 * cos_beta + baseline_per_path * sum_247
    sum_249 = (
        64.0 * sum_248 * sum_4_squared
        - 64.0 * sigma_beta_squared * sum_191
        - 768.0 * product_12 * sum_195
        - rho * sum_241
    )
    del sum_246, sum_247, sum_191, sum_195, sum_241, sum_248
    sum_250 = product_20 * sum_177 - sigma_path_per_path_squared * sum_249
    sum_251 = 14.0 - (52.0 + 32.0 * sin_beta_squared) * sin_beta_squared
    sum_252 = 36.0 - (91.0 + 6.0 * sin_beta_squared) * sin_beta_squared
    sum_253 = 8.0 + (98.0 + 32.0 * sin_beta_squared) * sin_beta_squared
    sum_254 = 29.0 + 2.0 * sin_beta_squared + 4.0 * product_13
    sum_255 = 32.0 + 6.0 * product_13 + sin_beta_squared * sum_254
    del sum_177, sum_249, product_13, sum_254
    sum_256 = 3.0 - sin_beta_squared * sum_255 + product_1
    sum_257 = baseline_per_path * sum_256 + cos_beta * sum_253
    del product_1, sum_255, sum_253, sum_256
    sum_258 = 21.0 - baseline_per_path * sum_257 + sin_beta_squared * sum_252
    sum_259 = cos_beta * sum_251 - baseline_per_path * sum_258
    del sum_252, sum_257, sum_251, sum_258
    sum_260 = 1.0 + baseline_per_path * sum_259 + (38.0 - 36.0 * sin_beta_squared) * sin_beta_squared
    sum_261 = baseline_per_path * sum_260 - 4.0 * cos_beta
    sum_262 = 1.0 - 2.0 * sin_beta_squared + baseline_per_path * sum_261
    sum_263 = 13.0 * baseline_per_path - 22.0 * cos_beta
    sum_264 = 107.0 - 4.0 * cos_beta_squared - baseline_per_path * sum_263
    del sum_259, sum_260, sum_261, sum_263
    sum_265 = cos_beta * sum_264 - 83.0 * baseline_per_path
    sum_266 = 119.0 - 18.0 * baseline_per_path_squared - cos_beta * sum_265
    sum_267 = (91.0 - 50.0 * cos_beta_squared) * cos_beta - baseline_per_path * sum_266
    sum_268 = 1.0 - 54.0 * baseline_per_path_squared - cos_beta * sum_267
    del sum_264, sum_265, sum_266, sum_267
    sum_269 = (3.0 - 32.0 * cos_beta_squared) * cos_beta - baseline_per_path * sum_268
    sum_270 = 7.0 - 14.0 * cos_beta_squared - baseline_per_path * sum_269
    sum_271 = 192.0 * sigma_beta_squared * sum_262 + 64.0 * sum_270 * sum_4_squared
    del sum_268, sum_269, sum_262, sum_270
    sum_272 = product_14 * product_26 * sum_271 + sin_beta * sum_250
    del product_14, product_26, sum_250, sum_271
    sum_273 = sigma_beta * sum_272 - product_24 * sum_166
    sum_274 = 2304.0 * product_12 + 384.0 * product_28
    del product_24, sum_166, sum_272, product_28
    sum_275 = 64.0 * product_30 + product_12 * sum_274
    product_27 = sigma_path_per_path_squared * sum_275
    del product_30, sum_274, sigma_path_per_path_squared, sum_275
    sum_276 = cos_beta * product_27 * sin_beta + sigma_beta * sum_273
    sum_277 = 2.0 + 9.0 * cos_beta_squared + (product_6 - 13.0 * cos_beta) * baseline_per_path
    sum_278 = baseline_per_path * sum_277 - 3.0 * cos_beta
    sum_279 = 13824.0 * product_12 * sum_171 + 768.0 * sum_278 * sum_4_squared
    del sin_beta, sum_273, sum_277, sum_278
    sum_280 = 128.0 * product_22 * sum_171 - product_12 * sum_279
    sum_281 = 28.0 * baseline_per_path - 32.0 * cos_beta
    sum_282 = 47.0 - 7.0 * cos_beta_squared - baseline_per_path * sum_281
    del product_12, product_22, sum_279, sum_281
    sum_283 = cos_beta * sum_282 - 52.0 * baseline_per_path
    sum_284 = 28.0 - 36.0 * baseline_per_path_squared - cos_beta * sum_283
    sum_285 = (26.0 - 22.0 * cos_beta_squared) * cos_beta - baseline_per_path * sum_284
    sum_286 = 3.0 - 7.0 * cos_beta_squared + baseline_per_path * sum_285
    del sum_282, sum_283, sum_284, sum_285
    sum_287 = 32.0 * sigma_beta_squared * sum_286 + 64.0 * sum_171**2 * sum_4_squared
    sum_288 = 64.0 * sigma_beta_squared_squared * sum_176**2 + sum_287 * sum_4_squared
    sum_289 = 31.0 + sin_beta_squared * (22.0 + sin_beta_squared)
    sum_290 = (95.0 + 31.0 * sin_beta_squared) * cos_beta - baseline_per_path * sum_289
    del sum_286, sigma_beta_squared_squared, sum_287, sum_289
    sum_291 = 67.0 - baseline_per_path * sum_290 - (124.0 + 9.0 * sin_beta_squared) * sin_beta_squared
    sum_292 = baseline_per_path * sum_291 + (58.0 + 83.0 * sin_beta_squared) * cos_beta
    sum_293 = 86.0 - baseline_per_path * sum_292 - (83.0 + 12.0 * sin_beta_squared) * sin_beta_squared
    sum_294 = (13.0 - 36.0 * sin_beta_squared) * cos_beta - baseline_per_path * sum_293
    del sum_290, sum_291, sum_292, sum_293
    sum_295 = 19.0 - 13.0 * sin_beta_squared + baseline_per_path * sum_294
    sum_296 = baseline_per_path * sum_295 - 8.0 * cos_beta
    sum_297 = 1.0 + baseline_per_path * sum_296
    sum_298 = 146.0 + 21.0 * sin_beta_squared
    sum_299 = 112.0 + 164.0 * sin_beta_squared
    sum_300 = 214.0 + 18.0 * sin_beta_squared
    sum_301 = 140.0 + 76.0 * sin_beta_squared
    sum_302 = 49.0 + sin_beta_squared * (58.0 + sin_beta_squared)
    sum_303 = cos_beta * sum_301 - baseline_per_path * sum_302
    del sum_294, sum_295, sum_296, sum_301, sum_302
    sum_304 = 76.0 - baseline_per_path * sum_303 - sin_beta_squared * sum_300
    sum_305 = baseline_per_path * sum_304 + cos_beta * sum_299
    del sum_300, sum_303, sum_299, sum_304
    sum_306 = 122.0 - baseline_per_path * sum_305 - sin_beta_squared * sum_298
    sum_307 = (4.0 - 72.0 * sin_beta_squared) * cos_beta - baseline_per_path * sum_306
    sum_308 = 28.0 - 22.0 * sin_beta_squared + baseline_per_path * sum_307
    del sum_298, sum_305, sum_306, sum_307
    sum_309 = baseline_per_path * sum_308 - 8.0 * cos_beta
    sum_310 = 64.0 + 512.0 * rho_squared * sum_297 + 64.0 * baseline_per_path * sum_309
    sum_311 = baseline_per_path * (8.0 + sin_beta_squared) - 14.0 * cos_beta
    sum_312 = 3.0 - 6.0 * sin_beta_squared + baseline_per_path * sum_311
    del sum_308, sum_297, sum_309, sum_311
    sum_313 = 4.0 * cos_beta + baseline_per_path * sum_312
    sum_314 = 1.0 - baseline_per_path * sum_313
    sum_315 = (68.0 + 6.0 * sin_beta_squared) * cos_beta - (27.0 + 9.0 * sin_beta_squared) * baseline_per_path
    sum_316 = 38.0 - 63.0 * sin_beta_squared - baseline_per_path * sum_315
    sum_317 = baseline_per_path * sum_316 + (24.0 + 16.0 * sin_beta_squared) * cos_beta
    del sum_312, sum_313, sum_315, sum_316
    sum_318 = 25.0 - 24.0 * sin_beta_squared - baseline_per_path * sum_317
    sum_319 = baseline_per_path * sum_318 - 4.0 * cos_beta
    sum_320 = baseline_per_path * (17.0 + sin_beta_squared) - 32.0 * cos_beta
    sum_321 = 12.0 - 15.0 * sin_beta_squared + baseline_per_path * sum_320
    sum_322 = 4.0 * cos_beta + baseline_per_path * sum_321
    del sum_317, sum_318, sum_320, sum_321
    sum_323 = 1.0 - baseline_per_path * sum_322
    sum_324 = 3.0 - 3.0 * cos_beta_squared - (product_6 - 8.0 * cos_beta) * baseline_per_path
    sum_325 = baseline_per_path * sum_324 - 4.0 * cos_beta
    sum_326 = 1.0 + baseline_per_path * sum_325
    del sum_322, product_6, sum_324, sum_325
    sum_327 = 1536.0 * product_11 * sum_323 + 3072.0 * product_15 * sum_171 * sum_326
    sum_328 = 768.0 * sigma_beta * sum_319 + rho * sum_327
    del product_15, sum_171, sum_323, sum_319, sum_327
    sum_329 = 768.0 * product_11 * sum_314 + rho * sum_328
    sum_330 = product_16 * sum_329 - sigma_beta_squared * sum_310
    del product_11, sum_314, sum_328, product_16, sum_310, sum_329
    sum_331 = cos_beta * (86.0 + product_9) - 38.0 * baseline_per_path
    sum_332 = 117.0 - 66.0 * cos_beta_squared + baseline_per_path * sum_331
    sum_333 = (88.0 - 12.0 * cos_beta_squared) * cos_beta - baseline_per_path * sum_332
    sum_334 = 16.0 - 100.0 * baseline_per_path_squared - cos_beta * sum_333
    del product_9, sum_331, sum_332, sum_333
    sum_335 = 6.0 - 36.0 * baseline_per_path_squared
    sum_336 = cos_beta * sum_334 - baseline_per_path * sum_335
    sum_337 = 8.0 - baseline_per_path * sum_336 - (4.0 + 49.0 * cos_beta_squared) * cos_beta_squared
    sum_338 = (12.0 - 30.0 * cos_beta_squared) * cos_beta - baseline_per_path * sum_337
    del sum_334, sum_335, sum_336, sum_337
    sum_339 = 140.0 - 30.0 * cos_beta_squared
    sum_340 = 19.0 * baseline_per_path - 14.0 * cos_beta
    sum_341 = cos_beta * (166.0 + cos_beta * sum_340) - 88.0 * baseline_per_path
    sum_342 = 207.0 - 132.0 * cos_beta_squared + baseline_per_path * sum_341
    sum_343 = cos_beta * sum_339 - baseline_per_path * sum_342
    del sum_340, sum_341, sum_339, sum_342
    sum_344 = 50.0 - 170.0 * baseline_per_path_squared - cos_beta * sum_343
    sum_345 = 30.0 - 72.0 * baseline_per_path_squared
    sum_346 = cos_beta * sum_344 - baseline_per_path * sum_345
    del sum_343, baseline_per_path_squared, sum_344, sum_345
    sum_347 = 10.0 - baseline_per_path * sum_346 + (22.0 - 77.0 * cos_beta_squared) * cos_beta_squared
    sum_348 = (24.0 - 42.0 * cos_beta_squared) * cos_beta - baseline_per_path * sum_347
    sum_349 = 4.0 - 7.0 * cos_beta_squared - baseline_per_path * sum_348
    sum_350 = (
        128.0
        - 320.0 * cos_beta_squared
        - 64.0 * baseline_per_path * sum_338
        + 64.0 * rho_squared * sum_349
    )
    del sum_346, sum_347, sum_348, rho_squared, sum_338, sum_349
    sum_351 = sin_beta_squared * sum_330 + sum_350 * sum_4_squared
    sum_352 = 13.0 * baseline_per_path - 2.0 * cos_beta
    sum_353 = cos_beta * (46.0 + cos_beta * sum_352) - 36.0 * baseline_per_path
    del sum_330, sum_350, sum_4_squared, sum_352
    sum_354 = 13.0 - 25.0 * cos_beta_squared + baseline_per_path * sum_353
    sum_355 = baseline_per_path * sum_354 - 16.0 * cos_beta
    del cos_beta_squared, sum_353, cos_beta, sum_354
    sum_356 = 7.0 + baseline_per_path * sum_355
    sum_357 = 128.0 * product_29 * sum_356 - 384.0 * sigma_beta_squared * sum_176 * sum_326
    del baseline_per_path, sum_355, product_29, sigma_beta_squared, sum_176, sum_326, sum_356
    sum_358 = product_31 * sum_357 - sigma_path_per_path * sum_351
    sum_359 = product_20 * sum_288 + sigma_path_per_path * sum_358
    del product_31, sum_351, sum_357, product_20, sigma_path_per_path, sum_288, sum_358
    sum_360 = sigma_beta * sum_359 - product_18 * sum_280
    sum_361 = product_27 * sin_beta_squared + sigma_beta * sum_360
    del product_18, sum_280, sum_359, product_27, sin_beta_squared, sum_360
    product_23 = path * term_3
    product_17 = path_squared * term_4
    mean[..., 0] = product_23 * sum_27
    del term_3, path_squared, term_4, sum_27
    mean[..., 1] = product_23 * sum_54
    covariance[..., 0, 0] = product_17 * sum_159
    covariance[..., 0, 1] = product_17 * sum_276
    del product_23, sum_54, sum_159, sum_276
    covariance[..., 1, 0] = covariance[..., 0, 1]
    covariance[..., 1, 1] = product_17 * sum_361


def bistatic_unbiased(
    path: Floats,
    beta: Floats,
    baseline: Floats,
    sigma_path: Floats,
    sigma_beta: Floats,
    rho: Floats,
    mean: Filled,
    covariance: Filled,
) -> None:
    """Conversion bistatic, unbiased.

    Mean: unbiased estimate of the position, to fourth order. Covariance: error covariance of the unbiased
    estimate u, to fourth order, completed to a sum of squares.
    """
    term_1 = 1.0 / path
    baseline_per_path = baseline * term_1
    sigma_path_per_path = sigma_path * term_1
    cos_beta = np.cos(beta)
    product_11 = baseline_per_path * cos_beta
    product_1 = -2.0 * product_11
    divisor_1 = 2.0 + product_1
    product_2 = product_11
    sum_1 = product_2 - 1.0
    sum_1_squared = sum_1**2
    sum_1_squared_squared = sum_1_squared**2
    sum_2 = 1.0 - baseline_per_path
    sum_3 = 1.0 + baseline_per_path
    sigma_path_per_path_squared = sigma_path_per_path**2
    baseline_per_path_squared = baseline_per_path**2
    sin_beta = np.sin(beta)
    sin_beta_squared = sin_beta**2
    sum_4 = 16.0 * sum_1_squared - 48.0 * sigma_path_per_path_squared
    product_13 = sum_2 * sum_3
    product_17 = product_13 * sum_1_squared_squared
    product_9 = baseline_per_path_squared * sigma_path_per_path_squared
    product_12 = product_9 * sin_beta_squared
    sum_5 = 16.0 * product_17 + product_12 * sum_4
    del term_1, sum_1, sum_2, sum_4
    cos_beta_squared = cos_beta**2
    sum_6 = (3.0 - cos_beta_squared) * baseline_per_path - 3.0 * cos_beta
    sum_7 = baseline_per_path * (1.0 + product_2) - 3.0 * cos_beta
    sum_8 = 1.0 + baseline_per_path * sum_7
    sum_9 = 16.0 * sum_1_squared * sum_8 - 48.0 * (1.0 + cos_beta * sum_6) * product_9
    del product_2, sum_7, sum_6, sum_8
    product_3 = (20.0 - cos_beta_squared) * baseline_per_path
    sum_10 = 20.0 + (product_3 - 11.0 * cos_beta) * cos_beta
    sum_11 = cos_beta * sum_10 - 24.0 * baseline_per_path
    sum_12 = 8.0 - 11.0 * cos_beta_squared + baseline_per_path * sum_11
    sigma_beta_squared = sigma_beta**2
    sum_13 = baseline_per_path * sum_12 - cos_beta
    product_4 = (2.0 - cos_beta_squared) * baseline_per_path
    sum_14 = 2.0 * sigma_beta_squared * sum_13 + 8.0 * (product_4 - cos_beta) * sum_1_squared
    del sum_10, sum_11, sum_12, sum_13
    product_5 = (6.0 - cos_beta_squared) * baseline_per_path
    sum_15 = 29.0 - 3.0 * cos_beta_squared - (product_5 - 11.0 * cos_beta) * baseline_per_path
    sum_16 = cos_beta * sum_15 - 18.0 * baseline_per_path
    sum_17 = 7.0 - 17.0 * cos_beta_squared + baseline_per_path * sum_16
    sum_18 = baseline_per_path * sum_17 - 5.0 * cos_beta
    sum_19 = 1.0 + baseline_per_path * sum_18
    del sum_15, sum_16, sum_17, sum_18
    sum_20 = 4.0 * baseline_per_path - 3.0 * cos_beta
    sum_21 = cos_beta * (13.0 + cos_beta * sum_20) - 6.0 * baseline_per_path
    sum_22 = 7.0 - 9.0 * cos_beta_squared + baseline_per_path * sum_21
    rho_squared = rho**2
    sum_23 = cos_beta * sum_22 - 6.0 * baseline_per_path
    product_14 = rho * sigma_beta
    product_19 = product_14 * sin_beta
    sum_24 = (
        8.0 * product_19 * sum_19
        + (8.0 + 16.0 * rho_squared) * baseline_per_path_squared * sigma_path_per_path * sum_23
    )
    del sum_20, sum_21, sum_22, sum_19, sum_23
    sum_25 = product_13 * sum_14 - sigma_path_per_path * sum_24
    product_10 = sigma_path_per_path * sin_beta
    product_16 = product_10 * rho
    sum_26 = sigma_beta * sum_25 - product_16 * sum_9
    del sum_14, sum_24, sum_25, sum_9
    term_2 = 1.0 / (divisor_1 * (divisor_1**2)**2)
    sum_27 = cos_beta * sum_5 - sigma_beta * sum_26
    sum_28 = 2.0 * baseline_per_path - cos_beta
    sum_29 = 1.0 - baseline_per_path * sum_28
    sum_30 = 16.0 * sum_1_squared + 8.0 * sigma_beta_squared * sum_29
    sum_31 = 8.0 * baseline_per_path - cos_beta
    sum_32 = cos_beta * (20.0 + cos_beta * sum_31) - 24.0 * baseline_per_path
    del sum_26, sum_5, sum_29, sum_31
    sum_33 = 20.0 - 11.0 * cos_beta_squared + baseline_per_path * sum_32
    sum_34 = baseline_per_path * sum_33 - 11.0 * cos_beta
    sigma_beta_squared_squared = sigma_beta_squared**2
    sum_35 = 1.0 - baseline_per_path * sum_34
    sum_36 = 2.0 * sigma_beta_squared_squared * sum_35 + sum_1_squared * sum_30
    del sum_32, sum_33, sum_34, sum_30, sum_35
    sum_37 = (1.0 - sin_beta_squared) * baseline_per_path - 2.0 * cos_beta
    sum_38 = 16.0 - 48.0 * sigma_path_per_path_squared + 16.0 * baseline_per_path * sum_37
    sum_39 = baseline_per_path * (3.0 + sin_beta_squared) - 3.0 * cos_beta
    sum_40 = cos_beta * (5.0 + cos_beta * sum_28) - 4.0 * baseline_per_path
    sum_41 = 1.0 - 3.0 * cos_beta_squared + baseline_per_path * sum_40
    sum_42 = (24.0 + 48.0 * rho_squared) * sigma_beta * sum_41 - 48.0 * product_16 * sum_39
    del sum_37, sum_28, sum_40, sum_39, sum_41
    sum_43 = sin_beta_squared * sum_38 + sigma_beta * sum_42
    sum_44 = product_13 * sum_36 + product_9 * sum_43
    del sum_38, sum_42, sum_36, sum_43
    sum_45 = 31.0 - 3.0 * cos_beta_squared - (product_3 - 19.0 * cos_beta) * baseline_per_path
    sum_46 = cos_beta * sum_45 - 32.0 * baseline_per_path
    sum_47 = 20.0 - 24.0 * baseline_per_path_squared - cos_beta * sum_46
    sum_48 = (21.0 - 17.0 * cos_beta_squared) * cos_beta - baseline_per_path * sum_47
    del product_3, sum_45, sum_46, sum_47
    sum_49 = baseline_per_path * sum_48 - 5.0 * cos_beta_squared
    sum_50 = baseline_per_path * sum_49 + cos_beta
    sum_51 = 3.0 * cos_beta_squared + (product_4 - 3.0 * cos_beta) * baseline_per_path
    sum_52 = baseline_per_path * sum_51 - cos_beta
    sum_53 = 16.0 * sum_1_squared * sum_52 - 8.0 * sigma_beta_squared * sum_50
    del sum_48, sum_49, sum_51, sum_50, sum_52
    product_24 = product_14 * sigma_path_per_path
    sum_54 = product_24 * sum_53 + sin_beta * sum_44
    term_3 = 1.0 / ((divisor_1**2)**2)**2
    path_squared = path**2
    sum_55 = (2.0 - 3.0 * sin_beta_squared) * cos_beta - (2.0 - 2.0 * sin_beta_squared) * baseline_per_path
    sum_56 = 3.0 - 6.0 * cos_beta_squared - (product_4 - 5.0 * cos_beta) * baseline_per_path
    sum_57 = cos_beta * sum_56 - 2.0 * baseline_per_path
    del sum_44, sum_53, divisor_1, sum_56
    sum_58 = 1.0 - 2.0 * cos_beta_squared - baseline_per_path * sum_57
    sum_59 = 768.0 * cos_beta * sum_1_squared * sum_58 - 1152.0 * product_12 * sum_55
    sum_60 = baseline_per_path - 2.0 * cos_beta
    sum_61 = 1.0 + baseline_per_path * sum_60
    product_21 = product_17 * sum_61
    del sum_57, sum_55, sum_58, product_17
    sum_62 = 128.0 * cos_beta * product_21 - product_9 * sum_59
    sum_3_squared = sum_3**2
    term_4 = (baseline_per_path - 1.0)**2
    sum_63 = (26.0 - 5.0 * cos_beta_squared) * baseline_per_path - 14.0 * cos_beta
    sum_64 = cos_beta * (20.0 + cos_beta * sum_63) - 24.0 * baseline_per_path
    sum_65 = 2.0 - 5.0 * cos_beta_squared + baseline_per_path * sum_64
    del sum_59, sum_3, sum_63, sum_64
    sum_66 = 64.0 * sin_beta_squared * sum_1_squared - 32.0 * sigma_beta_squared * sum_65
    sum_67 = 1.0 - (product_5 - 4.0 * cos_beta) * baseline_per_path
    sum_68 = 16.0 * sigma_beta_squared_squared * sin_beta_squared * sum_67**2 + sum_1_squared * sum_66
    product_6 = cos_beta * cos_beta_squared
    sum_69 = (22.0 - 3.0 * cos_beta_squared) * baseline_per_path - 60.0 * cos_beta
    sum_70 = 45.0 - 45.0 * cos_beta_squared - baseline_per_path * sum_69
    sum_71 = cos_beta * sum_70 - 28.0 * baseline_per_path
    del sum_65, sum_66, sum_69, sum_70
    sum_72 = 12.0 * product_6 + (4.0 - cos_beta * sum_71) * baseline_per_path
    sum_73 = baseline_per_path * sum_72 - 3.0 * cos_beta_squared
    sum_74 = 2.0 * baseline_per_path - 3.0 * cos_beta
    sum_75 = 7.0 - 3.0 * cos_beta_squared - (product_4 - 4.0 * cos_beta) * baseline_per_path
    sum_76 = cos_beta * sum_75 - 4.0 * baseline_per_path
    sum_77 = baseline_per_path * sum_76 - 4.0 * cos_beta_squared
    del sum_71, sum_72, sum_75, sum_76
    sum_78 = baseline_per_path * sum_77 + cos_beta
    sum_79 = 256.0 * (1.0 + cos_beta * sum_74) * product_14 * sum_78 - 128.0 * product_10 * sum_73
    sum_80 = 105.0 - 12.0 * cos_beta_squared
    sum_81 = 128.0 - 46.0 * cos_beta_squared
    product_7 = (4.0 - cos_beta_squared) * baseline_per_path
    sum_82 = 72.0 - 9.0 * cos_beta_squared - (product_7 - 10.0 * cos_beta) * baseline_per_path
    sum_83 = cos_beta * sum_82 - 38.0 * baseline_per_path
    del sum_77, sum_73, sum_74, sum_82
    sum_84 = 93.0 - 4.0 * baseline_per_path_squared - cos_beta * sum_83
    sum_85 = cos_beta * sum_81 - baseline_per_path * sum_84
    sum_86 = 114.0 - cos_beta_squared * sum_80 + baseline_per_path * sum_85
    del sum_83, sum_81, sum_84, sum_80, sum_85
    sum_87 = 74.0 - 28.0 * baseline_per_path_squared
    sum_88 = cos_beta * sum_86 - baseline_per_path * sum_87
    sum_89 = 2.0 - baseline_per_path * sum_88 + (66.0 - 36.0 * cos_beta_squared) * cos_beta_squared
    sum_90 = 7.0 - 22.0 * baseline_per_path_squared
    sum_91 = baseline_per_path * sum_90 + cos_beta * sum_89
    del sum_86, sum_87, sum_88, sum_89, sum_90
    sum_92 = 1.0 - baseline_per_path * sum_91 + (10.0 + 13.0 * cos_beta_squared) * cos_beta_squared
    sum_93 = baseline_per_path * sum_92 - 8.0 * product_6
    sum_94 = baseline_per_path * sum_93 + cos_beta_squared
    sum_95 = 7.0 * baseline_per_path - 6.0 * cos_beta
    sum_96 = cos_beta * (40.0 + cos_beta * sum_95) - 9.0 * baseline_per_path
    del sum_91, sum_92, sum_93, sum_95
    sum_97 = 79.0 - 64.0 * cos_beta_squared + baseline_per_path * sum_96
    sum_98 = (62.0 - 14.0 * cos_beta_squared) * cos_beta - baseline_per_path * sum_97
    sum_99 = 24.0 - 30.0 * baseline_per_path_squared - cos_beta * sum_98
    sum_100 = (37.0 - 69.0 * cos_beta_squared) * cos_beta - baseline_per_path * sum_99
    del sum_96, sum_97, sum_98, sum_99
    sum_101 = 6.0 + 9.0 * baseline_per_path_squared + cos_beta * sum_100
    sum_102 = (30.0 - 42.0 * cos_beta_squared) * cos_beta - baseline_per_path * sum_101
    sum_103 = 5.0 - 7.0 * cos_beta_squared - baseline_per_path * sum_102
    product_15 = baseline_per_path_squared * product_10
    sum_104 = 128.0 * sigma_beta_squared * sum_94 - product_15 * sum_79 + 64.0 * sum_103 * sum_1_squared
    del sum_100, sum_101, sum_102, sum_103, sum_79, sum_94
    sum_105 = 5.0 * baseline_per_path - 9.0 * cos_beta
    sum_106 = cos_beta * (48.0 + cos_beta * sum_105) - 10.0 * baseline_per_path
    sum_107 = 81.0 - 51.0 * cos_beta_squared + baseline_per_path * sum_106
    sum_108 = (92.0 - 24.0 * cos_beta_squared) * cos_beta - baseline_per_path * sum_107
    sum_109 = 28.0 - 34.0 * baseline_per_path_squared - cos_beta * sum_108
    del sum_105, sum_106, sum_107, sum_108
    sum_110 = (11.0 - 36.0 * cos_beta_squared) * cos_beta - baseline_per_path * sum_109
    sum_111 = 1.0 - 6.0 * cos_beta_squared - baseline_per_path * sum_110
    product_8 = baseline_per_path * baseline_per_path_squared
    sum_112 = cos_beta * sum_111 - 10.0 * product_8
    product_23 = product_15 * sigma_beta
    sum_113 = 128.0 * product_23 * sum_112 - rho * sum_104
    del sum_109, sum_110, sum_111, sum_104, sum_112
    sum_114 = 120.0 - 72.0 * cos_beta_squared
    sum_115 = 204.0 - 21.0 * cos_beta_squared
    sum_116 = 224.0 - 88.0 * cos_beta_squared
    sum_117 = 162.0 - 18.0 * cos_beta_squared - (product_7 - 16.0 * cos_beta) * baseline_per_path
    sum_118 = cos_beta * sum_117 - 80.0 * baseline_per_path
    sum_119 = 192.0 - 4.0 * baseline_per_path_squared - cos_beta * sum_118
    sum_120 = cos_beta * sum_116 - baseline_per_path * sum_119
    del sum_117, sum_118, sum_116, sum_119
    sum_121 = 225.0 - cos_beta_squared * sum_115 + baseline_per_path * sum_120
    sum_122 = 128.0 - 64.0 * baseline_per_path_squared
    sum_123 = cos_beta * sum_121 - baseline_per_path * sum_122
    del sum_115, sum_120, sum_121, sum_122
    sum_124 = 16.0 - cos_beta_squared * sum_114 + baseline_per_path * sum_123
    sum_125 = 28.0 - 40.0 * baseline_per_path_squared
    sum_126 = cos_beta * sum_124 - baseline_per_path * sum_125
    del sum_114, sum_123, sum_124, sum_125
    sum_127 = 4.0 - (2.0 - 22.0 * cos_beta_squared) * cos_beta_squared + baseline_per_path * sum_126
    sum_128 = baseline_per_path * sum_127 - 8.0 * product_6
    sum_129 = baseline_per_path * sum_128 + cos_beta_squared
    sum_130 = 2.0 * baseline_per_path - 6.0 * cos_beta
    sum_131 = cos_beta * (26.0 + cos_beta * sum_130) - 3.0 * baseline_per_path
    del sum_126, sum_127, sum_128, sum_130
    sum_132 = 32.0 - 26.0 * cos_beta_squared + baseline_per_path * sum_131
    sum_133 = (34.0 - 10.0 * cos_beta_squared) * cos_beta - baseline_per_path * sum_132
    sum_134 = 12.0 - 18.0 * baseline_per_path_squared - cos_beta * sum_133
    sum_135 = (11.0 - 24.0 * cos_beta_squared) * cos_beta - baseline_per_path * sum_134
    del sum_131, sum_132, sum_133, sum_134
    sum_136 = 6.0 - 12.0 * cos_beta_squared - baseline_per_path * sum_135
    sum_137 = cos_beta * sum_136 - 3.0 * product_8
    sum_138 = 1.0 - 2.0 * cos_beta_squared - baseline_per_path * sum_137
    del sum_135, product_8, sum_136, sum_137
    sum_139 = (10.0 - 3.0 * cos_beta_squared) * baseline_per_path - 24.0 * cos_beta
    sum_140 = 27.0 - 18.0 * cos_beta_squared - baseline_per_path * sum_139
    sum_141 = cos_beta * sum_140 - 16.0 * baseline_per_path
    sum_142 = 12.0 * product_6 + (1.0 - cos_beta * sum_141) * baseline_per_path
    del sum_139, sum_140, product_6, sum_141
    sum_143 = baseline_per_path * sum_142 - 3.0 * cos_beta_squared
    sum_144 = (
        16.0 * sigma_beta_squared * sum_129
        - rho * sum_113
        + 64.0 * product_12 * sum_143
        + 64.0 * sum_138 * sum_1_squared
    )
    del sum_142, sum_113, sum_129, sum_138, sum_143
    sum_145 = 5.0 * baseline_per_path - cos_beta
    sum_146 = cos_beta * (20.0 + cos_beta * sum_145) - 12.0 * baseline_per_path
    sum_147 = 29.0 - 17.0 * cos_beta_squared + baseline_per_path * sum_146
    sum_148 = cos_beta * sum_147 - 12.0 * baseline_per_path
    sum_149 = 6.0 - baseline_per_path * sum_148 + 11.0 * cos_beta_squared
    del sum_145, sum_146, sum_147, sum_148
    sum_150 = baseline_per_path * sum_149 - 5.0 * cos_beta
    sum_151 = 128.0 * sum_150 * sum_1_squared + 96.0 * sigma_beta_squared * sum_67 * sum_78
    product_28 = product_13 * product_19
    del sum_149, sum_150, sum_78, product_19
    sum_152 = product_28 * sum_151 - sigma_path_per_path * sum_144
    product_20 = sum_3_squared * term_4
    del sum_144, sum_151, sum_3_squared, term_4
    sum_153 = product_20 * sum_68 - sigma_path_per_path * sum_152
    sum_154 = sigma_beta * sum_153 - product_16 * sum_62
    del sum_152, sum_68, sum_153, sum_62
    sum_61_squared = sum_61**2
    sum_155 = 1.0 + (product_4 - 2.0 * cos_beta) * baseline_per_path
    product_26 = sum_155 * sum_1_squared
    sum_156 = (
        384.0 * (1.0 - cos_beta) * (1.0 + cos_beta) * cos_beta_squared * product_26
        + 576.0 * (1.0 - sin_beta) * product_9 * (1.0 + sin_beta) * sin_beta_squared**2
    )
    product_27 = sum_1_squared_squared * sum_61_squared
    del sum_61, product_4, sum_155, sum_1_squared_squared, sum_61_squared
    sum_157 = 64.0 * cos_beta_squared * product_27 + product_9 * sum_156
    sum_158 = sigma_path_per_path_squared * sum_157 + sigma_beta * sum_154
    del product_9, sum_156, sum_154, sum_157
    sum_159 = 5.0 - 5.0 * product_11 - 6.0 * sin_beta_squared
    sum_160 = (6.0 - 2.0 * cos_beta_squared) * baseline_per_path - 13.0 * cos_beta
    sum_161 = 2.0 - 12.0 * cos_beta_squared - baseline_per_path * sum_160
    sum_162 = cos_beta * sum_161 - 2.0 * baseline_per_path
    sum_163 = 1.0 - 4.0 * cos_beta_squared - baseline_per_path * sum_162
    sum_164 = 384.0 * sum_163 * sum_1_squared - 576.0 * product_12 * sum_159
    del sum_160, sum_161, sum_162, sum_159, sum_163
    sum_165 = 64.0 * (1.0 + cos_beta * sum_60) * product_21 - product_12 * sum_164
    sum_166 = 11.0 * baseline_per_path - 5.0 * cos_beta
    sum_167 = cos_beta * (26.0 + cos_beta * sum_166) - 24.0 * baseline_per_path
    sum_168 = 11.0 - 14.0 * cos_beta_squared + baseline_per_path * sum_167
    del sum_164, sum_60, sum_166, sum_167
    sum_169 = baseline_per_path * sum_168 - 5.0 * cos_beta
    sum_170 = baseline_per_path - cos_beta
    sum_171 = 64.0 * sum_170 * sum_1_squared - 32.0 * sigma_beta_squared * sum_169
    sum_172 = 4.0 * baseline_per_path - cos_beta
    sum_173 = cos_beta * (4.0 + cos_beta * sum_172) - 6.0 * baseline_per_path
    sum_174 = 4.0 - 4.0 * cos_beta_squared + baseline_per_path * sum_173
    del sum_168, sum_169, sum_172, sum_173
    sum_175 = baseline_per_path * sum_174 - cos_beta
    sum_176 = 16.0 * sigma_beta_squared_squared * sum_175 * sum_67 + sum_171 * sum_1_squared
    sum_177 = 196.0 - 21.0 * cos_beta_squared
    sum_178 = 280.0 - 126.0 * cos_beta_squared
    sum_179 = (24.0 - cos_beta_squared) * baseline_per_path - 46.0 * cos_beta
    sum_180 = 190.0 - 18.0 * cos_beta_squared - baseline_per_path * sum_179
    del sum_174, sum_171, sum_67, sum_179
    sum_181 = cos_beta * sum_180 - 146.0 * baseline_per_path
    sum_182 = 188.0 - 36.0 * baseline_per_path_squared - cos_beta * sum_181
    sum_183 = cos_beta * sum_178 - baseline_per_path * sum_182
    del sum_180, sum_181, sum_178, sum_182
    sum_184 = 121.0 - cos_beta_squared * sum_177 + baseline_per_path * sum_183
    sum_185 = 74.0 - 72.0 * baseline_per_path_squared
    sum_186 = cos_beta * sum_184 - baseline_per_path * sum_185
    del sum_177, sum_183, sum_184, sum_185
    sum_187 = 10.0 - (94.0 - 72.0 * cos_beta_squared) * cos_beta_squared + baseline_per_path * sum_186
    sum_188 = baseline_per_path * sum_187 + (2.0 + 22.0 * cos_beta_squared) * cos_beta
    sum_189 = baseline_per_path * sum_188 - 8.0 * cos_beta_squared
    sum_190 = baseline_per_path * sum_189 + cos_beta
    del sum_186, sum_187, sum_188, sum_189
    sum_191 = 8.0 - 11.0 * sin_beta_squared - product_11 * (5.0 + sin_beta_squared)
    sum_192 = 6.0 * cos_beta * sin_beta_squared + baseline_per_path * sum_191
    sum_193 = 4.0 - 4.0 * sin_beta_squared - baseline_per_path * sum_192
    sum_194 = baseline_per_path * sum_193 - cos_beta
    sum_195 = 212.0 - 24.0 * cos_beta_squared
    sum_196 = 308.0 - 129.0 * cos_beta_squared
    sum_197 = (24.0 - 2.0 * cos_beta_squared) * baseline_per_path - 41.0 * cos_beta
    sum_198 = 194.0 - 18.0 * cos_beta_squared - baseline_per_path * sum_197
    del sum_191, sum_192, sum_193, sum_197
    sum_199 = cos_beta * sum_198 - 139.0 * baseline_per_path
    sum_200 = 214.0 - 36.0 * baseline_per_path_squared - cos_beta * sum_199
    sum_201 = cos_beta * sum_196 - baseline_per_path * sum_200
    del sum_198, sum_199, sum_196, sum_200
    sum_202 = 104.0 - cos_beta_squared * sum_195 + baseline_per_path * sum_201
    sum_203 = 55.0 - 72.0 * baseline_per_path_squared
    sum_204 = cos_beta * sum_202 - baseline_per_path * sum_203
    del sum_195, sum_201, sum_202, sum_203
    sum_205 = 1.0 - baseline_per_path * sum_204 + (89.0 - 72.0 * cos_beta_squared) * cos_beta_squared
    sum_206 = (16.0 + 26.0 * cos_beta_squared) * cos_beta - baseline_per_path * sum_205
    sum_207 = baseline_per_path * sum_206 - 16.0 * cos_beta_squared
    sum_208 = 2.0 * cos_beta + baseline_per_path * sum_207
    del sum_204, sum_205, sum_206, sum_207
    sum_209 = (12.0 - cos_beta_squared) * baseline_per_path - 26.0 * cos_beta
    sum_210 = 9.0 - 15.0 * cos_beta_squared - baseline_per_path * sum_209
    sum_211 = cos_beta * sum_210 - 6.0 * baseline_per_path
    sum_212 = baseline_per_path * sum_211 - 4.0 * cos_beta_squared
    sum_213 = baseline_per_path * sum_212 + cos_beta
    del sum_209, sum_210, sum_211, sum_212
    sum_214 = 41.0 + 5.0 * product_11 + 6.0 * sin_beta_squared
    sum_215 = 29.0 - 13.0 * product_11 - sin_beta_squared * sum_214
    sum_216 = (4.0 - 51.0 * sin_beta_squared) * cos_beta - baseline_per_path * sum_215
    sum_217 = 32.0 - (17.0 + 18.0 * sin_beta_squared) * sin_beta_squared + baseline_per_path * sum_216
    sum_218 = (25.0 - 24.0 * sin_beta_squared) * cos_beta - baseline_per_path * sum_217
    del sum_214, sum_215, sum_216, sum_217
    sum_219 = 5.0 - 6.0 * sin_beta_squared - baseline_per_path * sum_218
    sum_220 = 128.0 * product_14 * sum_219 - 384.0 * product_10 * sum_213
    sum_221 = 9.0 * baseline_per_path - 6.0 * cos_beta
    sum_222 = cos_beta * (68.0 + cos_beta * sum_221) - 24.0 * baseline_per_path
    del sum_218, sum_213, sum_219, sum_221
    sum_223 = 71.0 - 74.0 * cos_beta_squared + baseline_per_path * sum_222
    sum_224 = (86.0 - 14.0 * cos_beta_squared) * cos_beta - baseline_per_path * sum_223
    sum_225 = 4.0 + 24.0 * baseline_per_path_squared + cos_beta * sum_224
    sum_226 = (22.0 + 69.0 * cos_beta_squared) * cos_beta - baseline_per_path * sum_225
    del sum_222, sum_223, sum_224, sum_225
    sum_227 = baseline_per_path * sum_226 - 42.0 * cos_beta_squared
    sum_228 = 7.0 * cos_beta + baseline_per_path * sum_227
    sum_229 = 64.0 * sum_1_squared * sum_228 - 64.0 * sigma_beta_squared * sum_208 - product_15 * sum_220
    del sum_226, sum_227, sum_208, sum_220, sum_228
    sum_230 = 125.0 - 144.0 * sin_beta_squared
    sum_231 = 112.0 + 96.0 * sin_beta_squared
    sum_232 = 14.0 - 291.0 * sin_beta_squared
    sum_233 = 226.0 + 36.0 * sin_beta_squared + 37.0 * product_11
    sum_234 = 154.0 - 71.0 * product_11 - sin_beta_squared * sum_233
    sum_235 = cos_beta * sum_232 - baseline_per_path * sum_234
    sum_236 = 172.0 - sin_beta_squared * sum_231 + baseline_per_path * sum_235
    del sum_233, sum_232, sum_234, sum_231, sum_235
    sum_237 = cos_beta * sum_230 - baseline_per_path * sum_236
    sum_238 = 22.0 - 24.0 * sin_beta_squared - baseline_per_path * sum_237
    sum_239 = 32.0 * product_23 * sum_238 - rho * sum_229
    del sum_230, sum_236, sum_237, product_23, sum_229, sum_238
    sum_240 = 3.0 * baseline_per_path - 3.0 * cos_beta
    sum_241 = cos_beta * (17.0 + cos_beta * sum_240) - 6.0 * baseline_per_path
    sum_242 = 14.0 - 17.0 * cos_beta_squared + baseline_per_path * sum_241
    sum_243 = (17.0 - 5.0 * cos_beta_squared) * cos_beta - baseline_per_path * sum_242
    sum_244 = 2.0 - 6.0 * baseline_per_path_squared - cos_beta * sum_243
    del sum_240, sum_241, sum_242, sum_243
    sum_245 = baseline_per_path * sum_244 + (1.0 + 12.0 * cos_beta_squared) * cos_beta
    sum_246 = baseline_per_path * sum_245 - 6.0 * cos_beta_squared
    sum_247 = baseline_per_path * sum_246 + cos_beta
    sum_248 = (
        128.0 * sum_1_squared * sum_247
        - 16.0 * sigma_beta_squared * sum_190
        - 192.0 * product_12 * sum_194
        - rho * sum_239
    )
    del sum_244, sum_245, sum_246, sum_190, sum_194, sum_239, sum_247
    sum_249 = product_20 * sum_176 - sigma_path_per_path_squared * sum_248
    sum_250 = 124.0 - 68.0 * cos_beta_squared
    sum_251 = 19.0 * baseline_per_path - 28.0 * cos_beta
    sum_252 = 143.0 - 4.0 * cos_beta_squared - baseline_per_path * sum_251
    sum_253 = cos_beta * sum_252 - 104.0 * baseline_per_path
    del sum_176, sum_248, sum_251, sum_252
    sum_254 = 167.0 - 24.0 * baseline_per_path_squared - cos_beta * sum_253
    sum_255 = cos_beta * sum_250 - baseline_per_path * sum_254
    sum_256 = 2.0 + 72.0 * baseline_per_path_squared + cos_beta * sum_255
    del sum_253, sum_250, sum_254, sum_255
    sum_257 = baseline_per_path * sum_256 + (3.0 - 44.0 * cos_beta_squared) * cos_beta
    sum_258 = 10.0 - 20.0 * cos_beta_squared - baseline_per_path * sum_257
    sum_259 = 14.0 - (52.0 + 32.0 * sin_beta_squared) * sin_beta_squared
    sum_260 = 36.0 - (91.0 + 6.0 * sin_beta_squared) * sin_beta_squared
    sum_261 = 8.0 + (98.0 + 32.0 * sin_beta_squared) * sin_beta_squared
    sum_262 = 29.0 + 2.0 * sin_beta_squared + 4.0 * product_11
    sum_263 = 32.0 + 6.0 * product_11 + sin_beta_squared * sum_262
    del sum_256, sum_257, product_11, sum_262
    sum_264 = 3.0 - sin_beta_squared * sum_263 + product_1
    sum_265 = baseline_per_path * sum_264 + cos_beta * sum_261
    del product_1, sum_263, sum_261, sum_264
    sum_266 = 21.0 - baseline_per_path * sum_265 + sin_beta_squared * sum_260
    sum_267 = cos_beta * sum_259 - baseline_per_path * sum_266
    del sum_260, sum_265, sum_259, sum_266
    sum_268 = 1.0 + baseline_per_path * sum_267 + (38.0 - 36.0 * sin_beta_squared) * sin_beta_squared
    sum_269 = baseline_per_path * sum_268 - 4.0 * cos_beta
    sum_270 = 1.0 - 2.0 * sin_beta_squared + baseline_per_path * sum_269
    sum_271 = 32.0 * sum_1_squared * sum_258 + 48.0 * sigma_beta_squared * sum_270
    del sum_267, sum_268, sum_269, sum_258, sum_270
    sum_272 = product_13 * product_24 * sum_271 + sin_beta * sum_249
    del product_13, product_24, sum_249, sum_271
    sum_273 = sigma_beta * sum_272 - rho * sigma_path_per_path * sum_165
    sum_274 = 384.0 * product_26 + 576.0 * product_12
    sum_275 = 64.0 * product_27 + product_12 * sum_274
    del sum_165, sum_272, product_26, product_27, sum_274
    product_25 = sigma_path_per_path_squared * sum_275
    sum_276 = cos_beta * product_25 * sin_beta + sigma_beta * sum_273
    del sigma_path_per_path_squared, sum_275, sin_beta, sum_273
    sum_277 = 1.0 + 6.0 * cos_beta_squared + (product_7 - 8.0 * cos_beta) * baseline_per_path
    sum_278 = baseline_per_path * sum_277 - 2.0 * cos_beta
    sum_279 = 3456.0 * product_12 * sum_170 + 768.0 * sum_1_squared * sum_278
    sum_280 = 128.0 * product_21 * sum_170 - product_12 * sum_279
    del product_7, sum_277, sum_278, product_12, product_21, sum_279
    sum_281 = 20.0 * baseline_per_path - 22.0 * cos_beta
    sum_282 = 31.0 - 5.0 * cos_beta_squared - baseline_per_path * sum_281
    sum_283 = cos_beta * sum_282 - 32.0 * baseline_per_path
    sum_284 = 20.0 - 24.0 * baseline_per_path_squared - cos_beta * sum_283
    sum_285 = (16.0 - 14.0 * cos_beta_squared) * cos_beta - baseline_per_path * sum_284
    del sum_281, sum_282, sum_283, sum_284
    sum_286 = 3.0 - 5.0 * cos_beta_squared + baseline_per_path * sum_285
    sum_287 = 32.0 * sigma_beta_squared * sum_286 + 64.0 * sum_170**2 * sum_1_squared
    sum_288 = 16.0 * sigma_beta_squared_squared * sum_175**2 + sum_1_squared * sum_287
    del sum_285, sum_286, sigma_beta_squared_squared, sum_287
    sum_289 = 31.0 + sin_beta_squared * (22.0 + sin_beta_squared)
    sum_290 = (95.0 + 31.0 * sin_beta_squared) * cos_beta - baseline_per_path * sum_289
    sum_291 = 67.0 - baseline_per_path * sum_290 - (124.0 + 9.0 * sin_beta_squared) * sin_beta_squared
    sum_292 = baseline_per_path * sum_291 + (58.0 + 83.0 * sin_beta_squared) * cos_beta
    sum_293 = 86.0 - baseline_per_path * sum_292 - (83.0 + 12.0 * sin_beta_squared) * sin_beta_squared
    del sum_289, sum_290, sum_291, sum_292
    sum_294 = (13.0 - 36.0 * sin_beta_squared) * cos_beta - baseline_per_path * sum_293
    sum_295 = 19.0 - 13.0 * sin_beta_squared + baseline_per_path * sum_294
    sum_296 = baseline_per_path * sum_295 - 8.0 * cos_beta
    sum_297 = 1.0 + baseline_per_path * sum_296
    del sum_293, sum_294, sum_295, sum_296
    sum_298 = 146.0 + 21.0 * sin_beta_squared
    sum_299 = 112.0 + 164.0 * sin_beta_squared
    sum_300 = 214.0 + 18.0 * sin_beta_squared
    sum_301 = 140.0 + 76.0 * sin_beta_squared
    sum_302 = 49.0 + sin_beta_squared * (58.0 + sin_beta_squared)
    sum_303 = cos_beta * sum_301 - baseline_per_path * sum_302
    sum_304 = 76.0 - baseline_per_path * sum_303 - sin_beta_squared * sum_300
    del sum_301, sum_302, sum_300, sum_303
    sum_305 = baseline_per_path * sum_304 + cos_beta * sum_299
    sum_306 = 122.0 - baseline_per_path * sum_305 - sin_beta_squared * sum_298
    del sum_299, sum_304, sum_298, sum_305
    sum_307 = (4.0 - 72.0 * sin_beta_squared) * cos_beta - baseline_per_path * sum_306
    sum_308 = 28.0 - 22.0 * sin_beta_squared + baseline_per_path * sum_307
    sum_309 = baseline_per_path * sum_308 - 8.0 * cos_beta
    sum_310 = 16.0 + 128.0 * rho_squared * sum_297 + 16.0 * baseline_per_path * sum_309
    del sum_306, sum_307, sum_308, sum_297, sum_309
    sum_311 = baseline_per_path * (8.0 + sin_beta_squared) - 14.0 * cos_beta
    sum_312 = 3.0 - 6.0 * sin_beta_squared + baseline_per_path * sum_311
    sum_313 = 4.0 * cos_beta + baseline_per_path * sum_312
    sum_314 = 1.0 - baseline_per_path * sum_313
    sum_315 = (68.0 + 6.0 * sin_beta_squared) * cos_beta - (27.0 + 9.0 * sin_beta_squared) * baseline_per_path
    sum_316 = 38.0 - 63.0 * sin_beta_squared - baseline_per_path * sum_315
    del sum_311, sum_312, sum_313, sum_315
    sum_317 = baseline_per_path * sum_316 + (24.0 + 16.0 * sin_beta_squared) * cos_beta
    sum_318 = 25.0 - 24.0 * sin_beta_squared - baseline_per_path * sum_317
    sum_319 = baseline_per_path * sum_318 - 4.0 * cos_beta
    sum_320 = baseline_per_path * (17.0 + sin_beta_squared) - 32.0 * cos_beta
    sum_321 = 12.0 - 15.0 * sin_beta_squared + baseline_per_path * sum_320
    del sum_316, sum_317, sum_318, sum_320
    sum_322 = 4.0 * cos_beta + baseline_per_path * sum_321
    sum_323 = 1.0 - baseline_per_path * sum_322
    sum_324 = 3.0 - 3.0 * cos_beta_squared - (product_5 - 8.0 * cos_beta) * baseline_per_path
    sum_325 = baseline_per_path * sum_324 - 4.0 * cos_beta
    del sum_321, sum_322, product_5, sum_324
    sum_326 = 1.0 + baseline_per_path * sum_325
    sum_327 = 384.0 * product_10 * sum_323 + 768.0 * product_14 * sum_170 * sum_326
    del sum_325, product_14, sum_170, sum_323
    sum_328 = 192.0 * sigma_beta * sum_319 + rho * sum_327
    sum_329 = 192.0 * product_10 * sum_314 + rho * sum_328
    del sum_319, sum_327, product_10, sum_314, sum_328
    sum_330 = product_15 * sum_329 - sigma_beta_squared * sum_310
    sum_331 = 10.0 * baseline_per_path - 6.0 * cos_beta
    sum_332 = cos_beta * (48.0 + cos_beta * sum_331) - 33.0 * baseline_per_path
    del product_15, sum_310, sum_329, sum_331
    sum_333 = 72.0 - 42.0 * cos_beta_squared + baseline_per_path * sum_332
    sum_334 = (44.0 - 10.0 * cos_beta_squared) * cos_beta - baseline_per_path * sum_333
    sum_335 = 14.0 - 48.0 * baseline_per_path_squared - cos_beta * sum_334
    sum_336 = 15.0 - 24.0 * baseline_per_path_squared
    sum_337 = cos_beta * sum_335 - baseline_per_path * sum_336
    del sum_332, sum_333, sum_334, sum_335, sum_336
    sum_338 = (9.0 - 24.0 * cos_beta_squared) * cos_beta_squared - baseline_per_path * sum_337
    sum_339 = (6.0 - 12.0 * cos_beta_squared) * cos_beta - baseline_per_path * sum_338
    sum_340 = 124.0 - 14.0 * cos_beta_squared
    sum_341 = 11.0 * baseline_per_path - 6.0 * cos_beta
    sum_342 = cos_beta * (102.0 + cos_beta * sum_341) - 54.0 * baseline_per_path
    sum_343 = 171.0 - 84.0 * cos_beta_squared + baseline_per_path * sum_342
    del sum_337, sum_338, sum_341, sum_342
    sum_344 = cos_beta * sum_340 - baseline_per_path * sum_343
    sum_345 = 10.0 - 126.0 * baseline_per_path_squared - cos_beta * sum_344
    sum_346 = 12.0 - 48.0 * baseline_per_path_squared
    sum_347 = cos_beta * sum_345 - baseline_per_path * sum_346
    del sum_340, sum_343, sum_344, sum_345, sum_346
    sum_348 = 6.0 - baseline_per_path * sum_347 - (12.0 + 69.0 * cos_beta_squared) * cos_beta_squared
    sum_349 = (12.0 - 42.0 * cos_beta_squared) * cos_beta - baseline_per_path * sum_348
    sum_350 = 2.0 - 7.0 * cos_beta_squared - baseline_per_path * sum_349
    sum_351 = (
        64.0
        - 128.0 * cos_beta_squared
        - 64.0 * baseline_per_path * sum_339
        + 64.0 * rho_squared * sum_350
    )
    del sum_347, sum_348, sum_349, rho_squared, sum_339, sum_350
    sum_352 = sin_beta_squared * sum_330 + sum_1_squared * sum_351
    sum_353 = 19.0 * baseline_per_path - 18.0 * cos_beta
    sum_354 = 101.0 - 2.0 * cos_beta_squared - baseline_per_path * sum_353
    sum_355 = cos_beta * sum_354 - 106.0 * baseline_per_path
    del sum_330, sum_351, sum_353, sum_354
    sum_356 = 19.0 - 48.0 * baseline_per_path_squared - cos_beta * sum_355
    sum_357 = (32.0 - 34.0 * cos_beta_squared) * cos_beta - baseline_per_path * sum_356
    sum_358 = 7.0 - baseline_per_path * sum_357 + 22.0 * cos_beta_squared
    del baseline_per_path_squared, sum_355, sum_356, cos_beta_squared, sum_357
    sum_359 = baseline_per_path * sum_358 - 10.0 * cos_beta
    sum_360 = 64.0 * sum_1_squared * sum_359 - 96.0 * sigma_beta_squared * sum_175 * sum_326
    del baseline_per_path, cos_beta, sum_358, sigma_beta_squared, sum_175, sum_1_squared, sum_326, sum_359
    sum_361 = product_28 * sum_360 - sigma_path_per_path * sum_352
    sum_362 = product_20 * sum_288 + sigma_path_per_path * sum_361
    del product_28, sum_352, sum_360, product_20, sigma_path_per_path, sum_288, sum_361
    sum_363 = sigma_beta * sum_362 - product_16 * sum_280
    sum_364 = product_25 * sin_beta_squared + sigma_beta * sum_363
    del product_16, sum_280, sum_362, product_25, sin_beta_squared, sum_363
    product_22 = path * term_2
    product_18 = path_squared * term_3
    mean[..., 0] = product_22 * sum_27
    del term_2, path_squared, term_3, sum_27
    mean[..., 1] = product_22 * sum_54
    covariance[..., 0, 0] = product_18 * sum_158
    covariance[..., 0, 1] = product_18 * sum_276
    del product_22, sum_54, sum_158, sum_276
    covariance[..., 1, 0] = covariance[..., 0, 1]
    covariance[..., 1, 1] = product_18 * sum_364


def bistatic_posterior(
    path: Floats,
    beta: Floats,
    baseline: Floats,
    sigma_path: Floats,
    sigma_beta: Floats,
    rho: Floats,
    mean: Filled,
    covariance: Filled,
) -> None:
    """Conversion bistatic, posterior.

    Mean: posterior mean of the position under a flat prior, to fourth order. Covariance: posterior covariance
    of the position under a flat prior, to fourth order, completed to a sum of squares.
    """
    term_1 = 1.0 / path
    baseline_per_path = baseline * term_1
    sigma_path_per_path = sigma_path * term_1
    cos_beta = np.cos(beta)
    product_13 = baseline_per_path * cos_beta
    product_1 = -2.0 * product_13
    divisor_1 = 2.0 + product_1
    term_2 = 1.0 / (divisor_1 * (divisor_1**2)**2)
    product_2 = product_13
    sum_1 = product_2 - 1.0
    sum_1_squared = sum_1**2
    sigma_path_per_path_squared = sigma_path_per_path**2
    baseline_per_path_squared = baseline_per_path**2
    sin_beta = np.sin(beta)
    sin_beta_squared = sin_beta**2
    sum_2 = 16.0 * sum_1_squared + 48.0 * sigma_path_per_path_squared
    sum_1_squared_squared = sum_1_squared**2
    sum_3 = 1.0 - baseline_per_path
    sum_4 = 1.0 + baseline_per_path
    product_15 = sum_3 * sum_4
    product_19 = product_15 * sum_1_squared_squared
    product_11 = baseline_per_path_squared * sigma_path_per_path_squared
    product_14 = product_11 * sin_beta_squared
    sum_5 = 16.0 * product_19 - product_14 * sum_2
    del term_1, sum_1, sum_3, sum_2
    sum_6 = baseline_per_path * (1.0 + product_2) - 3.0 * cos_beta
    sum_7 = 1.0 + baseline_per_path * sum_6
    cos_beta_squared = cos_beta**2
    sum_8 = (3.0 - cos_beta_squared) * baseline_per_path - 3.0 * cos_beta
    sum_9 = 16.0 * sum_1_squared * sum_7 + 48.0 * (1.0 + cos_beta * sum_8) * product_11
    del product_2, sum_6, sum_7, sum_8
    product_3 = (20.0 - cos_beta_squared) * baseline_per_path
    sum_10 = 20.0 + (product_3 - 11.0 * cos_beta) * cos_beta
    sum_11 = cos_beta * sum_10 - 24.0 * baseline_per_path
    sum_12 = 8.0 - 11.0 * cos_beta_squared + baseline_per_path * sum_11
    sigma_beta_squared = sigma_beta**2
    sum_13 = baseline_per_path * sum_12 - cos_beta
    product_4 = (2.0 - cos_beta_squared) * baseline_per_path
    sum_14 = 8.0 * (product_4 - cos_beta) * sum_1_squared - 2.0 * sigma_beta_squared * sum_13
    del sum_10, sum_11, sum_12, sum_13
    product_5 = (6.0 - cos_beta_squared) * baseline_per_path
    sum_15 = 29.0 - 3.0 * cos_beta_squared - (product_5 - 11.0 * cos_beta) * baseline_per_path
    sum_16 = cos_beta * sum_15 - 18.0 * baseline_per_path
    sum_17 = 7.0 - 17.0 * cos_beta_squared + baseline_per_path * sum_16
    sum_18 = baseline_per_path * sum_17 - 5.0 * cos_beta
    sum_19 = 1.0 + baseline_per_path * sum_18
    del sum_15, sum_16, sum_17, sum_18
    sum_20 = 4.0 * baseline_per_path - 3.0 * cos_beta
    sum_21 = cos_beta * (13.0 + cos_beta * sum_20) - 6.0 * baseline_per_path
    sum_22 = 7.0 - 9.0 * cos_beta_squared + baseline_per_path * sum_21
    rho_squared = rho**2
    sum_23 = cos_beta * sum_22 - 6.0 * baseline_per_path
    product_16 = rho * sigma_beta
    product_21 = product_16 * sin_beta
    sum_24 = (
        8.0 * product_21 * sum_19
        + (8.0 + 16.0 * rho_squared) * baseline_per_path_squared * sigma_path_per_path * sum_23
    )
    del sum_20, sum_21, sum_22, sum_19, sum_23
    sum_25 = product_15 * sum_14 + sigma_path_per_path * sum_24
    product_12 = sigma_path_per_path * sin_beta
    product_18 = product_12 * rho
    sum_26 = sigma_beta * sum_25 - product_18 * sum_9
    del sum_14, sum_24, sum_25, sum_9
    sum_27 = cos_beta * sum_5 + sigma_beta * sum_26
    sum_28 = 2.0 * baseline_per_path - cos_beta
    sum_29 = 1.0 - baseline_per_path * sum_28
    sum_30 = 16.0 * sum_1_squared - 8.0 * sigma_beta_squared * sum_29
    sum_31 = 8.0 * baseline_per_path - cos_beta
    sum_32 = cos_beta * (20.0 + cos_beta * sum_31) - 24.0 * baseline_per_path
    del sum_26, sum_5, sum_29, sum_31
    sum_33 = 20.0 - 11.0 * cos_beta_squared + baseline_per_path * sum_32
    sum_34 = baseline_per_path * sum_33 - 11.0 * cos_beta
    sigma_beta_squared_squared = sigma_beta_squared**2
    sum_35 = 1.0 - baseline_per_path * sum_34
    sum_36 = 2.0 * sigma_beta_squared_squared * sum_35 + sum_1_squared * sum_30
    del sum_32, sum_33, sum_34, sum_30, sum_35
    sum_37 = (1.0 - sin_beta_squared) * baseline_per_path - 2.0 * cos_beta
    sum_38 = 16.0 + 16.0 * baseline_per_path * sum_37 + 48.0 * sigma_path_per_path_squared
    sum_39 = baseline_per_path * (3.0 + sin_beta_squared) - 3.0 * cos_beta
    sum_40 = cos_beta * (5.0 + cos_beta * sum_28) - 4.0 * baseline_per_path
    sum_41 = 1.0 - 3.0 * cos_beta_squared + baseline_per_path * sum_40
    sum_42 = (24.0 + 48.0 * rho_squared) * sigma_beta * sum_41 - 48.0 * product_18 * sum_39
    del sum_37, sum_28, sum_40, sum_39, sum_41
    sum_43 = sin_beta_squared * sum_38 - sigma_beta * sum_42
    sum_44 = product_15 * sum_36 - product_11 * sum_43
    del sum_38, sum_42, sum_36, sum_43
    sum_45 = 3.0 * cos_beta_squared + (product_4 - 3.0 * cos_beta) * baseline_per_path
    sum_46 = baseline_per_path * sum_45 - cos_beta
    sum_47 = 31.0 - 3.0 * cos_beta_squared - (product_3 - 19.0 * cos_beta) * baseline_per_path
    sum_48 = cos_beta * sum_47 - 32.0 * baseline_per_path
    sum_49 = 20.0 - 24.0 * baseline_per_path_squared - cos_beta * sum_48
    del sum_45, product_3, sum_47, sum_48
    sum_50 = (21.0 - 17.0 * cos_beta_squared) * cos_beta - baseline_per_path * sum_49
    sum_51 = baseline_per_path * sum_50 - 5.0 * cos_beta_squared
    sum_52 = baseline_per_path * sum_51 + cos_beta
    sum_53 = 16.0 * sum_1_squared * sum_46 + 8.0 * sigma_beta_squared * sum_52
    del sum_49, sum_50, sum_51, sum_46, sum_52
    product_26 = product_16 * sigma_path_per_path
    sum_54 = sin_beta * sum_44 - product_26 * sum_53
    term_3 = 1.0 / ((divisor_1**2)**2)**2
    path_squared = path**2
    sum_55 = (2.0 - 3.0 * sin_beta_squared) * cos_beta - (2.0 - 2.0 * sin_beta_squared) * baseline_per_path
    product_6 = (4.0 - cos_beta_squared) * baseline_per_path
    sum_56 = 3.0 - 12.0 * cos_beta_squared - (product_6 - 13.0 * cos_beta) * baseline_per_path
    sum_57 = cos_beta * sum_56 - 4.0 * baseline_per_path
    del sum_44, sum_53, divisor_1, sum_56
    sum_58 = 1.0 - 4.0 * cos_beta_squared - baseline_per_path * sum_57
    sum_59 = 256.0 * cos_beta * sum_1_squared * sum_58 - 1152.0 * product_14 * sum_55
    sum_60 = baseline_per_path - 2.0 * cos_beta
    sum_61 = 1.0 + baseline_per_path * sum_60
    product_23 = product_19 * sum_61
    del sum_57, sum_55, sum_58, product_19
    sum_62 = 128.0 * cos_beta * product_23 - product_11 * sum_59
    sum_4_squared = sum_4**2
    term_4 = (baseline_per_path - 1.0)**2
    sum_63 = (18.0 - 3.0 * cos_beta_squared) * baseline_per_path - 10.0 * cos_beta
    sum_64 = cos_beta * (12.0 + cos_beta * sum_63) - 16.0 * baseline_per_path
    sum_65 = 2.0 - 3.0 * cos_beta_squared + baseline_per_path * sum_64
    del sum_59, sum_4, sum_63, sum_64
    sum_66 = 64.0 * sin_beta_squared * sum_1_squared - 32.0 * sigma_beta_squared * sum_65
    sum_67 = 1.0 - (product_5 - 4.0 * cos_beta) * baseline_per_path
    sum_68 = 16.0 * sigma_beta_squared_squared * sin_beta_squared * sum_67**2 + sum_1_squared * sum_66
    product_7 = cos_beta * cos_beta_squared
    sum_69 = (22.0 - 3.0 * cos_beta_squared) * baseline_per_path - 60.0 * cos_beta
    sum_70 = 45.0 - 45.0 * cos_beta_squared - baseline_per_path * sum_69
    sum_71 = cos_beta * sum_70 - 28.0 * baseline_per_path
    del sum_65, sum_66, sum_69, sum_70
    sum_72 = 12.0 * product_7 + (4.0 - cos_beta * sum_71) * baseline_per_path
    sum_73 = baseline_per_path * sum_72 - 3.0 * cos_beta_squared
    sum_74 = 2.0 * baseline_per_path - 3.0 * cos_beta
    sum_75 = 7.0 - 3.0 * cos_beta_squared - (product_4 - 4.0 * cos_beta) * baseline_per_path
    sum_76 = cos_beta * sum_75 - 4.0 * baseline_per_path
    del sum_71, sum_72, product_4, sum_75
    sum_77 = baseline_per_path * sum_76 - 4.0 * cos_beta_squared
    sum_78 = baseline_per_path * sum_77 + cos_beta
    sum_79 = 256.0 * (1.0 + cos_beta * sum_74) * product_16 * sum_78 - 128.0 * product_12 * sum_73
    del sum_76, sum_77, sum_73, sum_74
    sum_80 = 105.0 - 12.0 * cos_beta_squared
    sum_81 = 128.0 - 46.0 * cos_beta_squared
    sum_82 = 72.0 - 9.0 * cos_beta_squared - (product_6 - 10.0 * cos_beta) * baseline_per_path
    sum_83 = cos_beta * sum_82 - 38.0 * baseline_per_path
    sum_84 = 93.0 - 4.0 * baseline_per_path_squared - cos_beta * sum_83
    sum_85 = cos_beta * sum_81 - baseline_per_path * sum_84
    del sum_82, sum_83, sum_81, sum_84
    sum_86 = 114.0 - cos_beta_squared * sum_80 + baseline_per_path * sum_85
    sum_87 = 74.0 - 28.0 * baseline_per_path_squared
    sum_88 = cos_beta * sum_86 - baseline_per_path * sum_87
    del sum_80, sum_85, sum_86, sum_87
    sum_89 = 2.0 - baseline_per_path * sum_88 + (66.0 - 36.0 * cos_beta_squared) * cos_beta_squared
    sum_90 = 7.0 - 22.0 * baseline_per_path_squared
    sum_91 = baseline_per_path * sum_90 + cos_beta * sum_89
    sum_92 = 1.0 - baseline_per_path * sum_91 + (10.0 + 13.0 * cos_beta_squared) * cos_beta_squared
    del sum_88, sum_89, sum_90, sum_91
    sum_93 = baseline_per_path * sum_92 - 8.0 * product_7
    sum_94 = baseline_per_path * sum_93 + cos_beta_squared
    product_8 = (46.0 - 14.0 * cos_beta_squared) * cos_beta
    sum_95 = 3.0 * baseline_per_path - 6.0 * cos_beta
    sum_96 = cos_beta * (32.0 + cos_beta * sum_95) - 5.0 * baseline_per_path
    sum_97 = 51.0 - 40.0 * cos_beta_squared + baseline_per_path * sum_96
    del sum_92, sum_93, sum_95, sum_96
    sum_98 = product_8 - baseline_per_path * sum_97
    sum_99 = 8.0 - 22.0 * baseline_per_path_squared - cos_beta * sum_98
    sum_100 = (9.0 - 33.0 * cos_beta_squared) * cos_beta - baseline_per_path * sum_99
    sum_101 = 2.0 - 5.0 * baseline_per_path_squared - cos_beta * sum_100
    del sum_97, sum_98, sum_99, sum_100
    sum_102 = baseline_per_path * sum_101 + (6.0 - 18.0 * cos_beta_squared) * cos_beta
    sum_103 = 1.0 - 3.0 * cos_beta_squared - baseline_per_path * sum_102
    product_17 = baseline_per_path_squared * product_12
    sum_104 = 128.0 * sigma_beta_squared * sum_94 - product_17 * sum_79 + 64.0 * sum_103 * sum_1_squared
    del sum_101, sum_102, sum_103, sum_79, sum_94
    sum_105 = 5.0 * baseline_per_path - 9.0 * cos_beta
    sum_106 = cos_beta * (48.0 + cos_beta * sum_105) - 10.0 * baseline_per_path
    sum_107 = 81.0 - 51.0 * cos_beta_squared + baseline_per_path * sum_106
    sum_108 = (92.0 - 24.0 * cos_beta_squared) * cos_beta - baseline_per_path * sum_107
    sum_109 = 28.0 - 34.0 * baseline_per_path_squared - cos_beta * sum_108
    del sum_105, sum_106, sum_107, sum_108
    sum_110 = (11.0 - 36.0 * cos_beta_squared) * cos_beta - baseline_per_path * sum_109
    sum_111 = 1.0 - 6.0 * cos_beta_squared - baseline_per_path * sum_110
    product_9 = baseline_per_path * baseline_per_path_squared
    sum_112 = cos_beta * sum_111 - 10.0 * product_9
    product_25 = product_17 * sigma_beta
    sum_113 = 128.0 * product_25 * sum_112 - rho * sum_104
    del sum_109, sum_110, sum_111, sum_104, sum_112
    sum_114 = 120.0 - 72.0 * cos_beta_squared
    sum_115 = 204.0 - 21.0 * cos_beta_squared
    sum_116 = 224.0 - 88.0 * cos_beta_squared
    sum_117 = 162.0 - 18.0 * cos_beta_squared - (product_6 - 16.0 * cos_beta) * baseline_per_path
    sum_118 = cos_beta * sum_117 - 80.0 * baseline_per_path
    sum_119 = 192.0 - 4.0 * baseline_per_path_squared - cos_beta * sum_118
    sum_120 = cos_beta * sum_116 - baseline_per_path * sum_119
    del sum_117, sum_118, sum_116, sum_119
    sum_121 = 225.0 - cos_beta_squared * sum_115 + baseline_per_path * sum_120
    sum_122 = 128.0 - 64.0 * baseline_per_path_squared
    sum_123 = cos_beta * sum_121 - baseline_per_path * sum_122
    del sum_115, sum_120, sum_121, sum_122
    sum_124 = 16.0 - cos_beta_squared * sum_114 + baseline_per_path * sum_123
    sum_125 = 28.0 - 40.0 * baseline_per_path_squared
    sum_126 = cos_beta * sum_124 - baseline_per_path * sum_125
    del sum_114, sum_123, sum_124, sum_125
    sum_127 = 4.0 - (2.0 - 22.0 * cos_beta_squared) * cos_beta_squared + baseline_per_path * sum_126
    sum_128 = baseline_per_path * sum_127 - 8.0 * product_7
    sum_129 = baseline_per_path * sum_128 + cos_beta_squared
    sum_130 = 2.0 * baseline_per_path - 2.0 * cos_beta
    product_10 = cos_beta * sum_130
    del sum_126, sum_127, sum_128, sum_130
    sum_131 = cos_beta * (14.0 + product_10) - 3.0 * baseline_per_path
    sum_132 = 28.0 - 22.0 * cos_beta_squared + baseline_per_path * sum_131
    sum_133 = (22.0 - 6.0 * cos_beta_squared) * cos_beta - baseline_per_path * sum_132
    sum_134 = 4.0 - 10.0 * baseline_per_path_squared - cos_beta * sum_133
    sum_135 = (7.0 - 20.0 * cos_beta_squared) * cos_beta - baseline_per_path * sum_134
    del sum_131, sum_132, sum_133, sum_134
    sum_136 = 6.0 - 12.0 * cos_beta_squared - baseline_per_path * sum_135
    sum_137 = cos_beta * sum_136 - 3.0 * product_9
    sum_138 = 1.0 - 2.0 * cos_beta_squared - baseline_per_path * sum_137
    sum_139 = (10.0 - 3.0 * cos_beta_squared) * baseline_per_path - 24.0 * cos_beta
    sum_140 = 27.0 - 18.0 * cos_beta_squared - baseline_per_path * sum_139
    del sum_135, sum_136, sum_137, sum_139
    sum_141 = cos_beta * sum_140 - 16.0 * baseline_per_path
    sum_142 = 12.0 * product_7 + (1.0 - cos_beta * sum_141) * baseline_per_path
    sum_143 = baseline_per_path * sum_142 - 3.0 * cos_beta_squared
    sum_144 = (
        16.0 * sigma_beta_squared * sum_129
        - rho * sum_113
        + 64.0 * product_14 * sum_143
        + 64.0 * sum_138 * sum_1_squared
    )
    del sum_140, sum_141, sum_142, sum_113, sum_129, sum_138, sum_143
    sum_145 = 3.0 * baseline_per_path - cos_beta
    sum_146 = cos_beta * (16.0 + cos_beta * sum_145) - 8.0 * baseline_per_path
    sum_147 = 15.0 - 11.0 * cos_beta_squared + baseline_per_path * sum_146
    sum_148 = cos_beta * sum_147 - 8.0 * baseline_per_path
    sum_149 = 2.0 - baseline_per_path * sum_148 + 7.0 * cos_beta_squared
    del sum_145, sum_146, sum_147, sum_148
    sum_150 = baseline_per_path * sum_149 - 3.0 * cos_beta
    sum_151 = 128.0 * sum_150 * sum_1_squared + 96.0 * sigma_beta_squared * sum_67 * sum_78
    product_30 = product_15 * product_21
    del sum_149, sum_150, sum_78, product_21
    sum_152 = product_30 * sum_151 - sigma_path_per_path * sum_144
    product_22 = sum_4_squared * term_4
    del sum_144, sum_151, sum_4_squared, term_4
    sum_153 = product_22 * sum_68 - sigma_path_per_path * sum_152
    sum_154 = sigma_beta * sum_153 - product_18 * sum_62
    del sum_152, sum_68, sum_153, sum_62
    sum_61_squared = sum_61**2
    sum_155 = 3.0 + (product_6 - 6.0 * cos_beta) * baseline_per_path
    product_28 = sum_155 * sum_1_squared
    sum_156 = (
        128.0 * (1.0 - cos_beta) * (1.0 + cos_beta) * cos_beta_squared * product_28
        + 576.0 * (1.0 - sin_beta) * product_11 * (1.0 + sin_beta) * sin_beta_squared**2
    )
    product_29 = sum_1_squared_squared * sum_61_squared
    del sum_61, product_6, sum_155, sum_1_squared_squared, sum_61_squared
    sum_157 = 64.0 * cos_beta_squared * product_29 + product_11 * sum_156
    sum_158 = sigma_path_per_path_squared * sum_157 + sigma_beta * sum_154
    del product_11, sum_156, sum_154, sum_157
    sum_159 = 5.0 - 5.0 * product_13 - 6.0 * sin_beta_squared
    sum_160 = (12.0 - 2.0 * cos_beta_squared) * baseline_per_path - 31.0 * cos_beta
    sum_161 = 24.0 * product_7 + baseline_per_path * (4.0 + cos_beta * sum_160)
    sum_162 = 1.0 - 8.0 * cos_beta_squared + baseline_per_path * sum_161
    sum_163 = 128.0 * sum_162 * sum_1_squared - 576.0 * product_14 * sum_159
    del product_7, sum_160, sum_161, sum_159, sum_162
    sum_164 = 64.0 * (1.0 + cos_beta * sum_60) * product_23 - product_14 * sum_163
    sum_165 = 7.0 * baseline_per_path - 3.0 * cos_beta
    sum_166 = cos_beta * (18.0 + cos_beta * sum_165) - 16.0 * baseline_per_path
    sum_167 = 7.0 - 10.0 * cos_beta_squared + baseline_per_path * sum_166
    del sum_163, sum_60, sum_165, sum_166
    sum_168 = baseline_per_path * sum_167 - 3.0 * cos_beta
    sum_169 = baseline_per_path - cos_beta
    sum_170 = 64.0 * sum_169 * sum_1_squared - 32.0 * sigma_beta_squared * sum_168
    sum_171 = 4.0 * baseline_per_path - cos_beta
    sum_172 = cos_beta * (4.0 + cos_beta * sum_171) - 6.0 * baseline_per_path
    sum_173 = 4.0 - 4.0 * cos_beta_squared + baseline_per_path * sum_172
    del sum_167, sum_168, sum_171, sum_172
    sum_174 = baseline_per_path * sum_173 - cos_beta
    sum_175 = 16.0 * sigma_beta_squared_squared * sum_174 * sum_67 + sum_170 * sum_1_squared
    sum_176 = 196.0 - 21.0 * cos_beta_squared
    sum_177 = 280.0 - 126.0 * cos_beta_squared
    sum_178 = (24.0 - cos_beta_squared) * baseline_per_path - 46.0 * cos_beta
    sum_179 = 190.0 - 18.0 * cos_beta_squared - baseline_per_path * sum_178
    del sum_173, sum_170, sum_67, sum_178
    sum_180 = cos_beta * sum_179 - 146.0 * baseline_per_path
    sum_181 = 188.0 - 36.0 * baseline_per_path_squared - cos_beta * sum_180
    sum_182 = cos_beta * sum_177 - baseline_per_path * sum_181
    del sum_179, sum_180, sum_177, sum_181
    sum_183 = 121.0 - cos_beta_squared * sum_176 + baseline_per_path * sum_182
    sum_184 = 74.0 - 72.0 * baseline_per_path_squared
    sum_185 = cos_beta * sum_183 - baseline_per_path * sum_184
    del sum_176, sum_182, sum_183, sum_184
    sum_186 = 10.0 - (94.0 - 72.0 * cos_beta_squared) * cos_beta_squared + baseline_per_path * sum_185
    sum_187 = baseline_per_path * sum_186 + (2.0 + 22.0 * cos_beta_squared) * cos_beta
    sum_188 = baseline_per_path * sum_187 - 8.0 * cos_beta_squared
    sum_189 = baseline_per_path * sum_188 + cos_beta
    del sum_185, sum_186, sum_187, sum_188
    sum_190 = 8.0 - 11.0 * sin_beta_squared - product_13 * (5.0 + sin_beta_squared)
    sum_191 = 6.0 * cos_beta * sin_beta_squared + baseline_per_path * sum_190
    sum_192 = 4.0 - 4.0 * sin_beta_squared - baseline_per_path * sum_191
    sum_193 = baseline_per_path * sum_192 - cos_beta
    sum_194 = 212.0 - 24.0 * cos_beta_squared
    sum_195 = 308.0 - 129.0 * cos_beta_squared
    sum_196 = (24.0 - 2.0 * cos_beta_squared) * baseline_per_path - 41.0 * cos_beta
    sum_197 = 194.0 - 18.0 * cos_beta_squared - baseline_per_path * sum_196
    del sum_190, sum_191, sum_192, sum_196
    sum_198 = cos_beta * sum_197 - 139.0 * baseline_per_path
    sum_199 = 214.0 - 36.0 * baseline_per_path_squared - cos_beta * sum_198
    sum_200 = cos_beta * sum_195 - baseline_per_path * sum_199
    del sum_197, sum_198, sum_195, sum_199
    sum_201 = 104.0 - cos_beta_squared * sum_194 + baseline_per_path * sum_200
    sum_202 = 55.0 - 72.0 * baseline_per_path_squared
    sum_203 = cos_beta * sum_201 - baseline_per_path * sum_202
    del sum_194, sum_200, sum_201, sum_202
    sum_204 = 1.0 - baseline_per_path * sum_203 + (89.0 - 72.0 * cos_beta_squared) * cos_beta_squared
    sum_205 = (16.0 + 26.0 * cos_beta_squared) * cos_beta - baseline_per_path * sum_204
    sum_206 = baseline_per_path * sum_205 - 16.0 * cos_beta_squared
    sum_207 = 2.0 * cos_beta + baseline_per_path * sum_206
    del sum_203, sum_204, sum_205, sum_206
    sum_208 = (12.0 - cos_beta_squared) * baseline_per_path - 26.0 * cos_beta
    sum_209 = 9.0 - 15.0 * cos_beta_squared - baseline_per_path * sum_208
    sum_210 = cos_beta * sum_209 - 6.0 * baseline_per_path
    sum_211 = baseline_per_path * sum_210 - 4.0 * cos_beta_squared
    sum_212 = baseline_per_path * sum_211 + cos_beta
    del sum_208, sum_209, sum_210, sum_211
    sum_213 = 41.0 + 5.0 * product_13 + 6.0 * sin_beta_squared
    sum_214 = 29.0 - 13.0 * product_13 - sin_beta_squared * sum_213
    sum_215 = (4.0 - 51.0 * sin_beta_squared) * cos_beta - baseline_per_path * sum_214
    sum_216 = 32.0 - (17.0 + 18.0 * sin_beta_squared) * sin_beta_squared + baseline_per_path * sum_215
    sum_217 = (25.0 - 24.0 * sin_beta_squared) * cos_beta - baseline_per_path * sum_216
    del sum_213, sum_214, sum_215, sum_216
    sum_218 = 5.0 - 6.0 * sin_beta_squared - baseline_per_path * sum_217
    sum_219 = 128.0 * product_16 * sum_218 - 384.0 * product_12 * sum_212
    sum_220 = 5.0 * baseline_per_path - 6.0 * cos_beta
    sum_221 = cos_beta * (52.0 + cos_beta * sum_220) - 16.0 * baseline_per_path
    del sum_217, sum_212, sum_218, sum_220
    sum_222 = 35.0 - 50.0 * cos_beta_squared + baseline_per_path * sum_221
    sum_223 = product_8 - baseline_per_path * sum_222
    sum_224 = 4.0 - 16.0 * baseline_per_path_squared - cos_beta * sum_223
    del sum_221, product_8, sum_222, sum_223
    sum_225 = baseline_per_path * sum_224 + (6.0 + 33.0 * cos_beta_squared) * cos_beta
    sum_226 = baseline_per_path * sum_225 - 18.0 * cos_beta_squared
    sum_227 = 3.0 * cos_beta + baseline_per_path * sum_226
    sum_228 = 64.0 * sum_1_squared * sum_227 - 64.0 * sigma_beta_squared * sum_207 - product_17 * sum_219
    del sum_224, sum_225, sum_226, sum_207, sum_219, sum_227
    sum_229 = 125.0 - 144.0 * sin_beta_squared
    sum_230 = 112.0 + 96.0 * sin_beta_squared
    sum_231 = 14.0 - 291.0 * sin_beta_squared
    sum_232 = 226.0 + 36.0 * sin_beta_squared + 37.0 * product_13
    sum_233 = 154.0 - 71.0 * product_13 - sin_beta_squared * sum_232
    sum_234 = cos_beta * sum_231 - baseline_per_path * sum_233
    sum_235 = 172.0 - sin_beta_squared * sum_230 + baseline_per_path * sum_234
    del sum_232, sum_231, sum_233, sum_230, sum_234
    sum_236 = cos_beta * sum_229 - baseline_per_path * sum_235
    sum_237 = 22.0 - 24.0 * sin_beta_squared - baseline_per_path * sum_236
    sum_238 = 32.0 * product_25 * sum_237 - rho * sum_228
    del sum_229, sum_235, sum_236, product_25, sum_228, sum_237
    sum_239 = cos_beta * (13.0 + cos_beta * sum_169) - 4.0 * baseline_per_path
    sum_240 = 10.0 - 13.0 * cos_beta_squared + baseline_per_path * sum_239
    sum_241 = (13.0 - 3.0 * cos_beta_squared) * cos_beta - baseline_per_path * sum_240
    sum_242 = 3.0 - baseline_per_path * sum_241 + 10.0 * cos_beta_squared
    sum_243 = cos_beta * sum_242 - 4.0 * product_9
    del sum_239, sum_240, sum_241, product_9, sum_242
    sum_244 = baseline_per_path * sum_243 - 6.0 * cos_beta_squared
    sum_245 = baseline_per_path * sum_244 + cos_beta
    sum_246 = (
        128.0 * sum_1_squared * sum_245
        - 16.0 * sigma_beta_squared * sum_189
        - 192.0 * product_14 * sum_193
        - rho * sum_238
    )
    del sum_243, sum_244, sum_189, sum_193, sum_238, sum_245
    sum_247 = product_22 * sum_175 - sigma_path_per_path_squared * sum_246
    sum_248 = 11.0 * baseline_per_path - 20.0 * cos_beta
    sum_249 = 95.0 - 4.0 * cos_beta_squared - baseline_per_path * sum_248
    sum_250 = cos_beta * sum_249 - 76.0 * baseline_per_path
    del sum_175, sum_246, sum_248, sum_249
    sum_251 = 103.0 - 16.0 * baseline_per_path_squared - cos_beta * sum_250
    sum_252 = (80.0 - 44.0 * cos_beta_squared) * cos_beta - baseline_per_path * sum_251
    sum_253 = 2.0 - 48.0 * baseline_per_path_squared - cos_beta * sum_252
    sum_254 = (3.0 - 28.0 * cos_beta_squared) * cos_beta - baseline_per_path * sum_253
    del sum_250, sum_251, sum_252, sum_253
    sum_255 = 6.0 - 12.0 * cos_beta_squared - baseline_per_path * sum_254
    sum_256 = 14.0 - (52.0 + 32.0 * sin_beta_squared) * sin_beta_squared
    sum_257 = 36.0 - (91.0 + 6.0 * sin_beta_squared) * sin_beta_squared
    sum_258 = 8.0 + (98.0 + 32.0 * sin_beta_squared) * sin_beta_squared
    sum_259 = 29.0 + 2.0 * sin_beta_squared + 4.0 * product_13
    sum_260 = 32.0 + 6.0 * product_13 + sin_beta_squared * sum_259
    sum_261 = 3.0 - sin_beta_squared * sum_260 + product_1
    del sum_254, product_13, sum_259, product_1, sum_260
    sum_262 = baseline_per_path * sum_261 + cos_beta * sum_258
    sum_263 = 21.0 - baseline_per_path * sum_262 + sin_beta_squared * sum_257
    del sum_258, sum_261, sum_257, sum_262
    sum_264 = cos_beta * sum_256 - baseline_per_path * sum_263
    sum_265 = 1.0 + baseline_per_path * sum_264 + (38.0 - 36.0 * sin_beta_squared) * sin_beta_squared
    sum_266 = baseline_per_path * sum_265 - 4.0 * cos_beta
    del sum_256, sum_263, sum_264, sum_265
    sum_267 = 1.0 - 2.0 * sin_beta_squared + baseline_per_path * sum_266
    sum_268 = 32.0 * sum_1_squared * sum_255 + 48.0 * sigma_beta_squared * sum_267
    sum_269 = product_15 * product_26 * sum_268 + sin_beta * sum_247
    del sum_266, sum_255, sum_267, product_15, product_26, sum_247, sum_268
    sum_270 = sigma_beta * sum_269 - rho * sigma_path_per_path * sum_164
    sum_271 = 128.0 * product_28 + 576.0 * product_14
    sum_272 = 64.0 * product_29 + product_14 * sum_271
    del sum_164, sum_269, product_28, product_29, sum_271
    product_27 = sigma_path_per_path_squared * sum_272
    sum_273 = cos_beta * product_27 * sin_beta + sigma_beta * sum_270
    del sigma_path_per_path_squared, sum_272, sin_beta, sum_270
    sum_274 = (8.0 - cos_beta_squared) * baseline_per_path - 18.0 * cos_beta
    sum_275 = 3.0 + 12.0 * cos_beta_squared + baseline_per_path * sum_274
    sum_276 = baseline_per_path * sum_275 - 4.0 * cos_beta
    sum_277 = 256.0 * sum_1_squared * sum_276 + 3456.0 * product_14 * sum_169
    sum_278 = 128.0 * product_23 * sum_169 - product_14 * sum_277
    del sum_274, sum_275, sum_276, product_14, product_23, sum_277
    sum_279 = 12.0 * baseline_per_path - 14.0 * cos_beta
    sum_280 = 21.0 - 3.0 * cos_beta_squared - baseline_per_path * sum_279
    sum_281 = cos_beta * sum_280 - 24.0 * baseline_per_path
    sum_282 = 12.0 - 16.0 * baseline_per_path_squared - cos_beta * sum_281
    sum_283 = (12.0 - 10.0 * cos_beta_squared) * cos_beta - baseline_per_path * sum_282
    del sum_279, sum_280, sum_281, sum_282
    sum_284 = 1.0 - 3.0 * cos_beta_squared + baseline_per_path * sum_283
    sum_285 = 32.0 * sigma_beta_squared * sum_284 + 64.0 * sum_169**2 * sum_1_squared
    sum_286 = 16.0 * sigma_beta_squared_squared * sum_174**2 + sum_1_squared * sum_285
    del sum_283, sum_284, sigma_beta_squared_squared, sum_285
    sum_287 = 31.0 + sin_beta_squared * (22.0 + sin_beta_squared)
    sum_288 = (95.0 + 31.0 * sin_beta_squared) * cos_beta - baseline_per_path * sum_287
    sum_289 = 67.0 - baseline_per_path * sum_288 - (124.0 + 9.0 * sin_beta_squared) * sin_beta_squared
    sum_290 = baseline_per_path * sum_289 + (58.0 + 83.0 * sin_beta_squared) * cos_beta
    sum_291 = 86.0 - baseline_per_path * sum_290 - (83.0 + 12.0 * sin_beta_squared) * sin_beta_squared
    del sum_287, sum_288, sum_289, sum_290
    sum_292 = (13.0 - 36.0 * sin_beta_squared) * cos_beta - baseline_per_path * sum_291
    sum_293 = 19.0 - 13.0 * sin_beta_squared + baseline_per_path * sum_292
    sum_294 = baseline_per_path * sum_293 - 8.0 * cos_beta
    sum_295 = 1.0 + baseline_per_path * sum_294
    del sum_291, sum_292, sum_293, sum_294
    sum_296 = 146.0 + 21.0 * sin_beta_squared
    sum_297 = 112.0 + 164.0 * sin_beta_squared
    sum_298 = 214.0 + 18.0 * sin_beta_squared
    sum_299 = 140.0 + 76.0 * sin_beta_squared
    sum_300 = 49.0 + sin_beta_squared * (58.0 + sin_beta_squared)
    sum_301 = cos_beta * sum_299 - baseline_per_path * sum_300
    sum_302 = 76.0 - baseline_per_path * sum_301 - sin_beta_squared * sum_298
    del sum_299, sum_300, sum_298, sum_301
    sum_303 = baseline_per_path * sum_302 + cos_beta * sum_297
    sum_304 = 122.0 - baseline_per_path * sum_303 - sin_beta_squared * sum_296
    del sum_297, sum_302, sum_296, sum_303
    sum_305 = (4.0 - 72.0 * sin_beta_squared) * cos_beta - baseline_per_path * sum_304
    sum_306 = 28.0 - 22.0 * sin_beta_squared + baseline_per_path * sum_305
    sum_307 = baseline_per_path * sum_306 - 8.0 * cos_beta
    sum_308 = 16.0 + 128.0 * rho_squared * sum_295 + 16.0 * baseline_per_path * sum_307
    del sum_304, sum_305, sum_306, sum_295, sum_307
    sum_309 = baseline_per_path * (8.0 + sin_beta_squared) - 14.0 * cos_beta
    sum_310 = 3.0 - 6.0 * sin_beta_squared + baseline_per_path * sum_309
    sum_311 = 4.0 * cos_beta + baseline_per_path * sum_310
    sum_312 = 1.0 - baseline_per_path * sum_311
    sum_313 = (68.0 + 6.0 * sin_beta_squared) * cos_beta - (27.0 + 9.0 * sin_beta_squared) * baseline_per_path
    sum_314 = 38.0 - 63.0 * sin_beta_squared - baseline_per_path * sum_313
    del sum_309, sum_310, sum_311, sum_313
    sum_315 = baseline_per_path * sum_314 + (24.0 + 16.0 * sin_beta_squared) * cos_beta
    sum_316 = 25.0 - 24.0 * sin_beta_squared - baseline_per_path * sum_315
    sum_317 = baseline_per_path * sum_316 - 4.0 * cos_beta
    sum_318 = baseline_per_path * (17.0 + sin_beta_squared) - 32.0 * cos_beta
    sum_319 = 12.0 - 15.0 * sin_beta_squared + baseline_per_path * sum_318
    del sum_314, sum_315, sum_316, sum_318
    sum_320 = 4.0 * cos_beta + baseline_per_path * sum_319
    sum_321 = 1.0 - baseline_per_path * sum_320
    sum_322 = 3.0 - 3.0 * cos_beta_squared - (product_5 - 8.0 * cos_beta) * baseline_per_path
    sum_323 = baseline_per_path * sum_322 - 4.0 * cos_beta
    del sum_319, sum_320, product_5, sum_322
    sum_324 = 1.0 + baseline_per_path * sum_323
    sum_325 = 384.0 * product_12 * sum_321 + 768.0 * product_16 * sum_169 * sum_324
    del sum_323, product_16, sum_169, sum_321
    sum_326 = 192.0 * sigma_beta * sum_317 + rho * sum_325
    sum_327 = 192.0 * product_12 * sum_312 + rho * sum_326
    del sum_317, sum_325, product_12, sum_312, sum_326
    sum_328 = product_17 * sum_327 - sigma_beta_squared * sum_308
    sum_329 = cos_beta * (40.0 + product_10) - 17.0 * baseline_per_path
    del product_17, sum_308, sum_327, product_10
    sum_330 = 48.0 - 30.0 * cos_beta_squared + baseline_per_path * sum_329
    sum_331 = (36.0 - 6.0 * cos_beta_squared) * cos_beta - baseline_per_path * sum_330
    sum_332 = 10.0 - 44.0 * baseline_per_path_squared - cos_beta * sum_331
    sum_333 = 3.0 - 16.0 * baseline_per_path_squared
    sum_334 = cos_beta * sum_332 - baseline_per_path * sum_333
    del sum_329, sum_330, sum_331, sum_332, sum_333
    sum_335 = 4.0 - baseline_per_path * sum_334 + (1.0 - 20.0 * cos_beta_squared) * cos_beta_squared
    sum_336 = (6.0 - 12.0 * cos_beta_squared) * cos_beta - baseline_per_path * sum_335
    sum_337 = 7.0 * baseline_per_path - 6.0 * cos_beta
    sum_338 = cos_beta * (78.0 + cos_beta * sum_337) - 38.0 * baseline_per_path
    sum_339 = 87.0 - 60.0 * cos_beta_squared + baseline_per_path * sum_338
    del sum_334, sum_335, sum_337, sum_338
    sum_340 = (60.0 - 14.0 * cos_beta_squared) * cos_beta - baseline_per_path * sum_339
    sum_341 = 26.0 - 78.0 * baseline_per_path_squared - cos_beta * sum_340
    sum_342 = 12.0 - 32.0 * baseline_per_path_squared
    sum_343 = cos_beta * sum_341 - baseline_per_path * sum_342
    del sum_339, sum_340, sum_341, sum_342
    sum_344 = 6.0 - baseline_per_path * sum_343 + (12.0 - 33.0 * cos_beta_squared) * cos_beta_squared
    sum_345 = (12.0 - 18.0 * cos_beta_squared) * cos_beta - baseline_per_path * sum_344
    sum_346 = 2.0 - 3.0 * cos_beta_squared - baseline_per_path * sum_345
    sum_347 = (
        64.0
        - 128.0 * cos_beta_squared
        - 64.0 * baseline_per_path * sum_336
        + 64.0 * rho_squared * sum_346
    )
    del sum_343, sum_344, sum_345, rho_squared, sum_336, sum_346
    sum_348 = sin_beta_squared * sum_328 + sum_1_squared * sum_347
    sum_349 = 11.0 * baseline_per_path - 14.0 * cos_beta
    sum_350 = 61.0 - 2.0 * cos_beta_squared - baseline_per_path * sum_349
    sum_351 = cos_beta * sum_350 - 74.0 * baseline_per_path
    del sum_328, sum_347, sum_349, sum_350
    sum_352 = 11.0 - 32.0 * baseline_per_path_squared - cos_beta * sum_351
    sum_353 = (28.0 - 22.0 * cos_beta_squared) * cos_beta - baseline_per_path * sum_352
    sum_354 = 7.0 - baseline_per_path * sum_353 + 14.0 * cos_beta_squared
    del baseline_per_path_squared, sum_351, sum_352, cos_beta_squared, sum_353
    sum_355 = baseline_per_path * sum_354 - 6.0 * cos_beta
    sum_356 = 64.0 * sum_1_squared * sum_355 - 96.0 * sigma_beta_squared * sum_174 * sum_324
    del baseline_per_path, cos_beta, sum_354, sigma_beta_squared, sum_174, sum_1_squared, sum_324, sum_355
    sum_357 = product_30 * sum_356 - sigma_path_per_path * sum_348
    sum_358 = product_22 * sum_286 + sigma_path_per_path * sum_357
    del product_30, sum_348, sum_356, product_22, sigma_path_per_path, sum_286, sum_357
    sum_359 = sigma_beta * sum_358 - product_18 * sum_278
    sum_360 = product_27 * sin_beta_squared + sigma_beta * sum_359
    del product_18, sum_278, sum_358, product_27, sin_beta_squared, sum_359
    product_24 = path * term_2
    product_20 = path_squared * term_3
    mean[..., 0] = product_24 * sum_27
    del term_2, path_squared, term_3, sum_27
    mean[..., 1] = product_24 * sum_54
    covariance[..., 0, 0] = product_20 * sum_158
    covariance[..., 0, 1] = product_20 * sum_273
    del product_24, sum_54, sum_158, sum_273
    covariance[..., 1, 0] = covariance[..., 0, 1]
    covariance[..., 1, 1] = product_20 * sum_360


def polar_linear(
    r: Floats,
    beta: Floats,
    sigma_r: Floats,
    sigma_beta: Floats,
    rho: Floats,
    mean: Filled,
    covariance: Filled,
) -> None:
    """Conversion polar, linear.

    Mean: map from the measured quantities to coordinates. Covariance: covariance of the linearised
    conversion.
    """
    cos_beta = np.cos(beta)
    sin_beta = np.sin(beta)
    product_2 = r * rho
    product_4 = sigma_beta * sigma_r
    product_5 = product_2 * product_4
    part_00_cos_beta_sin_beta = -2.0 * product_5
    r_squared = r**2
    sigma_beta_squared = sigma_beta**2
    product_3 = r_squared * sigma_beta_squared
    del product_2, product_4, r_squared, sigma_beta_squared
    part_00_sin_beta2 = product_3
    part_01_cos_beta2 = product_5
    sigma_r_squared = sigma_r**2
    part_01_cos_beta_sin_beta = sigma_r_squared - product_3
    product_1 = part_00_cos_beta_sin_beta * sin_beta
    sum_1 = cos_beta * sigma_r_squared + product_1
    sin_beta_squared = sin_beta**2
    sum_2 = cos_beta * part_01_cos_beta2 + part_01_cos_beta_sin_beta * sin_beta
    del product_5, product_3, part_00_cos_beta_sin_beta, part_01_cos_beta_sin_beta
    sum_3 = cos_beta * part_00_sin_beta2 - product_1
    mean[..., 0] = cos_beta * r
    mean[..., 1] = r * sin_beta
    covariance[..., 0, 0] = cos_beta * sum_1 + part_00_sin_beta2 * sin_beta_squared
    del product_1, sin_beta, part_00_sin_beta2, sum_1
    covariance[..., 0, 1] = cos_beta * sum_2 - part_01_cos_beta2 * sin_beta_squared
    covariance[..., 1, 0] = covariance[..., 0, 1]
    covariance[..., 1, 1] = cos_beta * sum_3 + sigma_r_squared * sin_beta_squared
    del part_01_cos_beta2, sum_2, cos_beta, sigma_r_squared, sin_beta_squared, sum_3


def polar_second_order(
    r: Floats,
    beta: Floats,
    sigma_r: Floats,
    sigma_beta: Floats,
    rho: Floats,
    mean: Filled,
    covariance: Filled,
) -> None:
    """Conversion polar, second_order.

    Mean: map from the measured quantities to coordinates less the bias of the plain conversion to second
    order. Covariance: covariance of the conversion's quadratic Taylor polynomial.
    """
    cos_beta = np.cos(beta)
    sin_beta = np.sin(beta)
    sigma_beta_squared = sigma_beta**2
    part_0_cos_beta = -0.5 * r * sigma_beta_squared
    product_2 = rho * sigma_beta
    product_3 = product_2 * sigma_r
    part_0_sin_beta = -product_3
    r_squared = r**2
    sigma_r_squared = sigma_r**2
    part_00_cos_beta2 = 0.5 * r_squared * sigma_beta_squared**2 + sigma_r_squared
    product_5 = product_3 * r
    part_00_cos_beta_sin_beta = -(2.0 - 2.0 * sigma_beta_squared) * product_5
    product_1 = (1.0 + rho**2) * sigma_r_squared
    part_00_sin_beta2 = (product_1 + r_squared) * sigma_beta_squared
    part_01_cos_beta2 = (1.0 - sigma_beta_squared) * product_5
    sum_1 = product_1 + (1.0 - 0.5 * sigma_beta_squared) * r_squared
    del product_2, product_3, product_5, product_1, r_squared
    part_01_cos_beta_sin_beta = sigma_r_squared - sigma_beta_squared * sum_1
    sum_2 = part_0_cos_beta - r
    del sigma_beta_squared, sigma_r_squared, sum_1, part_0_cos_beta
    product_4 = part_00_cos_beta_sin_beta * sin_beta
    sum_3 = cos_beta * part_00_cos_beta2 + product_4
    sin_beta_squared = sin_beta**2
    sum_4 = cos_beta * part_01_cos_beta2 + part_01_cos_beta_sin_beta * sin_beta
    sum_5 = cos_beta * part_00_sin_beta2 - product_4
    mean[..., 0] = -cos_beta * sum_2 - part_0_sin_beta * sin_beta
    mean[..., 1] = cos_beta * part_0_sin_beta - sin_beta * sum_2
    del part_00_cos_beta_sin_beta, part_01_cos_beta_sin_beta, product_4, part_0_sin_beta, sin_beta, sum_2
    covariance[..., 0, 0] = cos_beta * sum_3 + part_00_sin_beta2 * sin_beta_squared
    covariance[..., 0, 1] = cos_beta * sum_4 - part_01_cos_beta2 * sin_beta_squared
    del part_00_sin_beta2, sum_3, part_01_cos_beta2, sum_4
    covariance[..., 1, 0] = covariance[..., 0, 1]
    covariance[..., 1, 1] = cos_beta * sum_5 + part_00_cos_beta2 * sin_beta_squared
    del cos_beta, part_00_cos_beta2, sin_beta_squared, sum_5


def polar_averaged(
    r: Floats,
    beta: Floats,
    sigma_r: Floats,
    sigma_beta: Floats,
    rho: Floats,
    mean: Filled,
    covariance: Filled,
) -> None:
    """Conversion polar, averaged.

    Mean: map from the measured quantities to coordinates less the exact bias of the plain conversion,
    averaged over the truth. Covariance: exact covariance of the plain conversion, averaged over the truth.
    """
    cos_beta = np.cos(beta)
    sin_beta = np.sin(beta)
    sigma_beta_squared = sigma_beta**2
    attenuation_beta = np.exp(-0.5 * sigma_beta_squared)
    term_1 = np.expm1(-0.5 * sigma_beta_squared)
    shortfall_beta = -term_1
    part_0_cos_beta = -attenuation_beta * r * shortfall_beta
    attenuation_beta_2 = np.exp(-sigma_beta_squared)
    attenuation_beta_less_one = term_1
    sum_1 = 2.0 + attenuation_beta_less_one
    shortfall_beta_2 = -attenuation_beta_less_one * sum_1
    r_squared = r**2
    shortfall_beta_2_squared = shortfall_beta_2**2
    sum_2 = 1.0 + attenuation_beta_2 * (1.0 + attenuation_beta_2)
    attenuation_beta_2_squared = attenuation_beta_2**2
    sum_3 = 0.5 + (0.5 - attenuation_beta_2) * attenuation_beta_2_squared
    sum_4 = 8.0 * attenuation_beta_2 - 6.0 * shortfall_beta_2
    sum_5 = 3.0 * shortfall_beta_2_squared + attenuation_beta_2 * sum_4
    del term_1, attenuation_beta_less_one, sum_1, sum_4
    product_1 = shortfall_beta_2 * shortfall_beta_2_squared
    rho_squared = rho**2
    sum_6 = attenuation_beta_2 * sum_5 + product_1
    sigma_r_squared = sigma_r**2
    product_6 = rho_squared * sigma_beta_squared
    product_8 = attenuation_beta_2 * product_6
    sum_7 = 1.0 - attenuation_beta_2 * sum_3 - 0.5 * product_8 * sum_6
    del sum_5, rho_squared, sigma_beta_squared, sum_3, sum_6
    part_00_cos_beta2 = 0.5 * r_squared * shortfall_beta_2_squared * sum_2 + sigma_r_squared * sum_7
    sum_8 = 6.0 * attenuation_beta_2 - 12.0 * shortfall_beta_2
    sum_9 = attenuation_beta_2 * sum_8 - 3.0 * shortfall_beta_2_squared
    del sum_2, sum_7, shortfall_beta_2_squared, sum_8
    sum_10 = attenuation_beta_2 * sum_9 - product_1
    product_2 = attenuation_beta_2 * attenuation_beta_2_squared
    sum_11 = 1.0 + (1.0 + 2.0 * attenuation_beta_2) * attenuation_beta_2
    sum_12 = 2.0 + attenuation_beta_2 * sum_11
    del product_1, sum_9, attenuation_beta_2_squared, sum_11
    sum_13 = 0.5 * (1.0 + product_2) * r_squared + 0.5 * sigma_r_squared * sum_12
    part_00_sin_beta2 = 0.5 * product_8 * sigma_r_squared * sum_10 + shortfall_beta_2 * sum_13
    del sum_12, product_8, sum_10, sum_13
    sum_14 = 7.0 * attenuation_beta_2 - 9.0 * shortfall_beta_2
    sum_15 = attenuation_beta_2 - product_6 * sum_14 - shortfall_beta_2
    sum_16 = r_squared * shortfall_beta_2 - sigma_r_squared * sum_15
    del product_6, sum_14, r_squared, sigma_r_squared, sum_15
    part_01_cos_beta_sin_beta = -product_2 * sum_16
    sum_17 = part_0_cos_beta - r
    sum_18 = attenuation_beta - shortfall_beta
    sum_19 = attenuation_beta_2 - 3.0 * shortfall_beta_2
    del sum_16, part_0_cos_beta, shortfall_beta, attenuation_beta_2, shortfall_beta_2
    product_4 = rho * sigma_beta
    product_5 = product_4 * sigma_r
    product_10 = product_5 * sin_beta
    product_9 = product_2 * r
    product_11 = product_9 * sum_19
    del product_4, product_2, product_9, sum_19
    product_3 = 2.0 * product_10 * product_11
    sum_20 = product_3 - cos_beta * part_00_cos_beta2
    sin_beta_squared = sin_beta**2
    sum_21 = cos_beta * part_00_sin_beta2 + product_3
    product_7 = attenuation_beta * sum_18
    mean[..., 0] = product_10 * product_7 - cos_beta * sum_17
    del product_3, attenuation_beta, sum_18, product_10
    mean[..., 1] = -cos_beta * product_5 * product_7 - sin_beta * sum_17
    covariance[..., 0, 0] = part_00_sin_beta2 * sin_beta_squared - cos_beta * sum_20
    del product_7, sum_17, part_00_sin_beta2, sum_20
    covariance[..., 0, 1] = (
        cos_beta * part_01_cos_beta_sin_beta * sin_beta
        + (cos_beta**2 - sin_beta_squared) * product_11 * product_5
    )
    del part_01_cos_beta_sin_beta, product_11, product_5, sin_beta
    covariance[..., 1, 0] = covariance[..., 0, 1]
    covariance[..., 1, 1] = cos_beta * sum_21 + part_00_cos_beta2 * sin_beta_squared
    del cos_beta, part_00_cos_beta2, sin_beta_squared, sum_21


def polar_unbiased(
    r: Floats,
    beta: Floats,
    sigma_r: Floats,
    sigma_beta: Floats,
    rho: Floats,
    mean: Filled,
    covariance: Filled,
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
    product_1 = rho * sigma_beta
    product_2 = product_1 * sigma_r
    part_0_sin_beta = product_2 * term_1
    attenuation_beta_2 = attenuation_beta**2
    attenuation_beta_less_one = np.expm1(-0.5 * sigma_beta_squared)
    sum_1 = 2.0 + attenuation_beta_less_one
    shortfall_beta = -attenuation_beta_less_one * sum_1
    del product_1, term_1, attenuation_beta, attenuation_beta_less_one, sum_1
    term_2 = 1.0 / attenuation_beta_2
    r_squared = r**2
    shortfall_beta_squared = shortfall_beta**2
    attenuation_beta_2_squared = attenuation_beta_2**2
    rho_squared = rho**2
    sigma_r_squared = sigma_r**2
    product_4 = rho_squared * sigma_beta_squared
    sum_2 = 0.5 - 2.0 * attenuation_beta_2_squared * product_4 + 0.5 * attenuation_beta_2_squared
    part_00_cos_beta2 = (
        0.5 * (2.0 + attenuation_beta_2) * r_squared * shortfall_beta_squared * term_2
        + sigma_r_squared * sum_2
    )
    sum_3 = 2.0 + 2.0 * attenuation_beta_2_squared
    sum_4 = 1.0 + attenuation_beta_2 * sum_3
    del rho_squared, sigma_beta_squared, sum_2, sum_3
    sum_5 = 0.5 * r_squared + 0.5 * sigma_r_squared
    product_7 = product_4 * sigma_r_squared
    part_00_sin_beta2 = product_7 * sum_4 * term_2 + (1.0 + attenuation_beta_2) * shortfall_beta * sum_5
    sum_6 = 2.0 + 4.0 * attenuation_beta_2_squared
    sum_7 = 1.0 + attenuation_beta_2 * sum_6
    del product_4, sum_4, sum_5, sum_6
    sum_8 = attenuation_beta_2 - shortfall_beta
    sum_9 = attenuation_beta_2 * sum_8 - shortfall_beta_squared
    sum_10 = product_7 * sum_7 + r_squared * shortfall_beta * sum_9
    del sum_8, product_7, r_squared, sum_7, sum_9
    part_01_cos_beta_sin_beta = attenuation_beta_2_squared * sigma_r_squared - sum_10 * term_2
    sum_11 = attenuation_beta_2 - 3.0 * shortfall_beta
    sum_12 = attenuation_beta_2 * sum_11 - 3.0 * shortfall_beta_squared
    del attenuation_beta_2_squared, sigma_r_squared, sum_10, sum_11
    sum_13 = attenuation_beta_2 * sum_12 - shortfall_beta * shortfall_beta_squared
    del attenuation_beta_2, shortfall_beta, shortfall_beta_squared, sum_12
    product_3 = r * sum_13
    product_5 = product_2 * term_2
    product_6 = product_3 * product_5
    del sum_13, product_2, term_2, product_3, product_5
    product_8 = product_6 * sin_beta
    sum_14 = cos_beta * part_00_cos_beta2 - 2.0 * product_8
    sin_beta_squared = sin_beta**2
    sum_15 = 2.0 * product_8 + cos_beta * part_00_sin_beta2
    mean[..., 0] = cos_beta * part_0_cos_beta + part_0_sin_beta * sin_beta
    mean[..., 1] = part_0_cos_beta * sin_beta - cos_beta * part_0_sin_beta
    covariance[..., 0, 0] = cos_beta * sum_14 + part_00_sin_beta2 * sin_beta_squared
    del product_8, part_0_cos_beta, part_0_sin_beta, part_00_sin_beta2, sum_14
    covariance[..., 0, 1] = (
        cos_beta * part_01_cos_beta_sin_beta * sin_beta
        + (cos_beta**2 - sin_beta_squared) * product_6
    )
    covariance[..., 1, 0] = covariance[..., 0, 1]
    covariance[..., 1, 1] = cos_beta * sum_15 + part_00_cos_beta2 * sin_beta_squared
    del part_01_cos_beta_sin_beta, product_6, sin_beta, cos_beta, part_00_cos_beta2, sin_beta_squared, sum_15


def polar_posterior(
    r: Floats,
    beta: Floats,
    sigma_r: Floats,
    sigma_beta: Floats,
    rho: Floats,
    mean: Filled,
    covariance: Filled,
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
    product_3 = rho * sigma_beta
    product_5 = product_3 * sigma_r
    part_0_sin_beta = -attenuation_beta * product_5
    attenuation_beta_2 = attenuation_beta**2
    attenuation_beta_less_one = np.expm1(-0.5 * sigma_beta_squared)
    sum_1 = 2.0 + attenuation_beta_less_one
    shortfall_beta = -attenuation_beta_less_one * sum_1
    del product_3, attenuation_beta, attenuation_beta_less_one, sum_1
    r_squared = r**2
    attenuation_beta_2_squared = attenuation_beta_2**2
    rho_squared = rho**2
    sigma_r_squared = sigma_r**2
    product_4 = rho_squared * sigma_beta_squared
    sum_2 = 0.5 - 2.0 * attenuation_beta_2_squared * product_4 + 0.5 * attenuation_beta_2_squared
    part_00_cos_beta2 = 0.5 * r_squared * shortfall_beta**2 + sigma_r_squared * sum_2
    del rho_squared, sigma_beta_squared, attenuation_beta_2_squared, sum_2
    sum_3 = attenuation_beta_2 - shortfall_beta
    sum_4 = 0.5 * r_squared + 0.5 * sigma_r_squared
    product_2 = attenuation_beta_2 * sum_3
    part_00_sin_beta2 = (
        product_2 * product_4 * sigma_r_squared
        + (1.0 + attenuation_beta_2) * shortfall_beta * sum_4
    )
    sum_5 = 3.0 * attenuation_beta_2 - shortfall_beta
    sum_6 = attenuation_beta_2 - product_4 * sum_5
    del sum_3, sum_4, product_4, sum_5
    sum_7 = r_squared * shortfall_beta - sigma_r_squared * sum_6
    del r_squared, shortfall_beta, sigma_r_squared, sum_6
    part_01_cos_beta_sin_beta = -attenuation_beta_2 * sum_7
    product_6 = product_2 * r
    product_7 = product_5 * product_6
    del attenuation_beta_2, sum_7, product_2, product_5, product_6
    product_1 = 2.0 * product_7 * sin_beta
    sum_8 = product_1 - cos_beta * part_00_cos_beta2
    sin_beta_squared = sin_beta**2
    sum_9 = cos_beta * part_00_sin_beta2 + product_1
    mean[..., 0] = cos_beta * part_0_cos_beta + part_0_sin_beta * sin_beta
    mean[..., 1] = part_0_cos_beta * sin_beta - cos_beta * part_0_sin_beta
    covariance[..., 0, 0] = part_00_sin_beta2 * sin_beta_squared - cos_beta * sum_8
    del product_1, part_0_cos_beta, part_0_sin_beta, part_00_sin_beta2, sum_8
    covariance[..., 0, 1] = (
        cos_beta * part_01_cos_beta_sin_beta * sin_beta
        + (cos_beta**2 - sin_beta_squared) * product_7
    )
    covariance[..., 1, 0] = covariance[..., 0, 1]
    covariance[..., 1, 1] = cos_beta * sum_9 + part_00_cos_beta2 * sin_beta_squared
    del part_01_cos_beta_sin_beta, product_7, sin_beta, cos_beta, part_00_cos_beta2, sin_beta_squared, sum_9


def polar_doppler_linear(
    r: Floats,
    beta: Floats,
    rdot: Floats,
    sigma_r: Floats,
    sigma_beta: Floats,
    sigma_rdot: Floats,
    rho: Floats,
    mean: Filled,
    covariance: Filled,
) -> None:
    """Conversion polar_doppler, linear.

    Mean: map from the measured quantities to coordinates. Covariance: covariance of the linearised
    conversion.
    """
    cos_beta = np.cos(beta)
    sin_beta = np.sin(beta)
    r_squared = r**2
    sigma_beta_squared = sigma_beta**2
    product_2 = r_squared * sigma_beta_squared
    part_00_sin_beta2 = product_2
    sigma_r_squared = sigma_r**2
    part_01_cos_beta_sin_beta = sigma_r_squared - product_2
    product_3 = rdot * sigma_r
    product_1 = r * sigma_rdot
    sum_1 = product_1 * rho + product_3
    part_02_cos_beta = sigma_r * sum_1
    del r_squared, sigma_beta_squared, product_2, sum_1
    cos_beta_squared = cos_beta**2
    sin_beta_squared = sin_beta**2
    sum_2 = 2.0 * product_3 * rho + product_1
    mean[..., 0] = cos_beta * r
    mean[..., 1] = r * sin_beta
    mean[..., 2] = r * rdot
    covariance[..., 0, 0] = cos_beta_squared * sigma_r_squared + part_00_sin_beta2 * sin_beta_squared
    covariance[..., 0, 1] = cos_beta * part_01_cos_beta_sin_beta * sin_beta
    covariance[..., 0, 2] = cos_beta * part_02_cos_beta
    covariance[..., 1, 0] = covariance[..., 0, 1]
    covariance[..., 1, 1] = cos_beta_squared * part_00_sin_beta2 + sigma_r_squared * sin_beta_squared
    del product_3, part_01_cos_beta_sin_beta, cos_beta, cos_beta_squared, part_00_sin_beta2, sin_beta_squared
    covariance[..., 1, 2] = part_02_cos_beta * sin_beta
    covariance[..., 2, 0] = covariance[..., 0, 2]
    covariance[..., 2, 1] = covariance[..., 1, 2]
    covariance[..., 2, 2] = product_1 * sum_2 + rdot**2 * sigma_r_squared
    del part_02_cos_beta, sin_beta, product_1, sigma_r_squared, sum_2


def polar_doppler_second_order(
    r: Floats,
    beta: Floats,
    rdot: Floats,
    sigma_r: Floats,
    sigma_beta: Floats,
    sigma_rdot: Floats,
    rho: Floats,
    mean: Filled,
    covariance: Filled,
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
    sigma_r_squared = sigma_r**2
    part_00_cos_beta2 = 0.5 * r_squared * sigma_beta_squared**2 + sigma_r_squared
    part_00_sin_beta2 = (r_squared + sigma_r_squared) * sigma_beta_squared
    sum_1 = (1.0 - 0.5 * sigma_beta_squared) * r_squared + sigma_r_squared
    part_01_cos_beta_sin_beta = sigma_r_squared - sigma_beta_squared * sum_1
    product_1 = rho * sigma_rdot
    sum_2 = product_1 * r + rdot * sigma_r
    part_02_cos_beta = sigma_r * sum_2
    del sigma_beta_squared, sigma_r_squared, sum_1, sum_2
    sum_3 = part_0_cos_beta - r
    cos_beta_squared = cos_beta**2
    sin_beta_squared = sin_beta**2
    sigma_rdot_squared = sigma_rdot**2
    sum_4 = rdot**2 + (1.0 + rho**2) * sigma_rdot_squared
    product_2 = r * rdot
    sum_5 = 2.0 * product_1 * product_2 + sigma_r * sum_4
    mean[..., 0] = -cos_beta * sum_3
    mean[..., 1] = -sin_beta * sum_3
    mean[..., 2] = product_2 - product_1 * sigma_r
    del part_0_cos_beta, sum_4, sum_3, product_1, product_2
    covariance[..., 0, 0] = cos_beta_squared * part_00_cos_beta2 + part_00_sin_beta2 * sin_beta_squared
    covariance[..., 0, 1] = cos_beta * part_01_cos_beta_sin_beta * sin_beta
    covariance[..., 0, 2] = cos_beta * part_02_cos_beta
    covariance[..., 1, 0] = covariance[..., 0, 1]
    covariance[..., 1, 1] = cos_beta_squared * part_00_sin_beta2 + part_00_cos_beta2 * sin_beta_squared
    del part_01_cos_beta_sin_beta, cos_beta, cos_beta_squared, part_00_cos_beta2, part_00_sin_beta2, sin_beta_squared
    covariance[..., 1, 2] = part_02_cos_beta * sin_beta
    covariance[..., 2, 0] = covariance[..., 0, 2]
    covariance[..., 2, 1] = covariance[..., 1, 2]
    covariance[..., 2, 2] = r_squared * sigma_rdot_squared + sigma_r * sum_5
    del part_02_cos_beta, sin_beta, r_squared, sigma_rdot_squared, sum_5


def polar_doppler_averaged(
    r: Floats,
    beta: Floats,
    rdot: Floats,
    sigma_r: Floats,
    sigma_beta: Floats,
    sigma_rdot: Floats,
    rho: Floats,
    mean: Filled,
    covariance: Filled,
) -> None:
    """Conversion polar_doppler, averaged.

    Mean: map from the measured quantities to coordinates less the exact bias of the plain conversion,
    averaged over the truth. Covariance: exact covariance of the plain conversion, averaged over the truth.
    """
    cos_beta = np.cos(beta)
    sin_beta = np.sin(beta)
    sigma_beta_squared = sigma_beta**2
    attenuation_beta = np.exp(-0.5 * sigma_beta_squared)
    term_1 = np.expm1(-0.5 * sigma_beta_squared)
    shortfall_beta = -term_1
    part_0_cos_beta = -attenuation_beta * r * shortfall_beta
    attenuation_beta_2 = np.exp(-sigma_beta_squared)
    attenuation_beta_less_one = term_1
    del attenuation_beta, shortfall_beta, sigma_beta_squared, term_1
    sum_1 = 2.0 + attenuation_beta_less_one
    shortfall_beta_2 = -attenuation_beta_less_one * sum_1
    r_squared = r**2
    sum_2 = 1.0 + attenuation_beta_2 * (1.0 + attenuation_beta_2)
    attenuation_beta_2_squared = attenuation_beta_2**2
    sum_3 = 0.5 + (0.5 - attenuation_beta_2) * attenuation_beta_2_squared
    sigma_r_squared = sigma_r**2
    sum_4 = 1.0 - attenuation_beta_2 * sum_3
    part_00_cos_beta2 = 0.5 * r_squared * shortfall_beta_2**2 * sum_2 + sigma_r_squared * sum_4
    del attenuation_beta_less_one, sum_1, sum_3, sum_2, sum_4
    product_1 = attenuation_beta_2 * attenuation_beta_2_squared
    sum_5 = 1.0 + (1.0 + 2.0 * attenuation_beta_2) * attenuation_beta_2
    sum_6 = 2.0 + attenuation_beta_2 * sum_5
    sum_7 = 0.5 * (1.0 + product_1) * r_squared + 0.5 * sigma_r_squared * sum_6
    part_00_sin_beta2 = shortfall_beta_2 * sum_7
    del attenuation_beta_2_squared, sum_5, sum_6, sum_7
    sum_8 = attenuation_beta_2 - shortfall_beta_2
    sum_9 = r_squared * shortfall_beta_2 - sigma_r_squared * sum_8
    part_01_cos_beta_sin_beta = -product_1 * sum_9
    del shortfall_beta_2, sigma_r_squared, sum_8, product_1, sum_9
    product_2 = rho * sigma_rdot
    sum_10 = product_2 * r + rdot * sigma_r
    part_02_cos_beta = attenuation_beta_2 * sigma_r * sum_10
    sum_11 = part_0_cos_beta - r
    cos_beta_squared = cos_beta**2
    sin_beta_squared = sin_beta**2
    sigma_rdot_squared = sigma_rdot**2
    sum_12 = rdot**2 + (3.0 + 3.0 * rho**2) * sigma_rdot_squared
    product_3 = r * rdot
    sum_13 = 2.0 * product_2 * product_3 + sigma_r * sum_12
    del attenuation_beta_2, sum_10, part_0_cos_beta, sum_12
    mean[..., 0] = -cos_beta * sum_11
    mean[..., 1] = -sin_beta * sum_11
    mean[..., 2] = product_3 - product_2 * sigma_r
    covariance[..., 0, 0] = cos_beta_squared * part_00_cos_beta2 + part_00_sin_beta2 * sin_beta_squared
    covariance[..., 0, 1] = cos_beta * part_01_cos_beta_sin_beta * sin_beta
    del sum_11, product_2, product_3, part_01_cos_beta_sin_beta
    covariance[..., 0, 2] = cos_beta * part_02_cos_beta
    covariance[..., 1, 0] = covariance[..., 0, 1]
    covariance[..., 1, 1] = cos_beta_squared * part_00_sin_beta2 + part_00_cos_beta2 * sin_beta_squared
    del cos_beta, cos_beta_squared, part_00_cos_beta2, part_00_sin_beta2, sin_beta_squared
    covariance[..., 1, 2] = part_02_cos_beta * sin_beta
    covariance[..., 2, 0] = covariance[..., 0, 2]
    covariance[..., 2, 1] = covariance[..., 1, 2]
    covariance[..., 2, 2] = r_squared * sigma_rdot_squared + sigma_r * sum_13
    del part_02_cos_beta, sin_beta, r_squared, sigma_rdot_squared, sum_13


def polar_doppler_unbiased(
    r: Floats,
    beta: Floats,
    rdot: Floats,
    sigma_r: Floats,
    sigma_beta: Floats,
    sigma_rdot: Floats,
    rho: Floats,
    mean: Filled,
    covariance: Filled,
) -> None:
    """Conversion polar_doppler, unbiased.

    Mean: exactly unbiased estimate of the position. Covariance: error covariance of the unbiased estimate u.
    """
    cos_beta = np.cos(beta)
    sin_beta = np.sin(beta)
    attenuation_beta = np.exp(-0.5 * sigma_beta**2)
    term_1 = 1.0 / attenuation_beta
    product_3 = r * term_1
    part_0_cos_beta = product_3
    shortfall_beta = -np.expm1(-0.5 * sigma_beta**2)
    sum_1 = 3.0 + attenuation_beta * (2.0 + attenuation_beta)
    term_2 = 1.0 / attenuation_beta**2
    r_squared = r**2
    shortfall_beta_squared = shortfall_beta**2
    sum_2 = 2.0 + attenuation_beta * (4.0 + attenuation_beta * sum_1)
    term_3 = (attenuation_beta**2)**2
    sigma_r_squared = sigma_r**2
    product_4 = r_squared * term_2
    part_00_cos_beta2 = (
        0.5 * product_4 * shortfall_beta_squared * sum_2
        + sigma_r_squared * (0.5 + 0.5 * term_3)
    )
    del term_1, sum_1, term_2, sum_2
    sum_3 = 1.0 + attenuation_beta * (1.0 + attenuation_beta)
    sum_4 = 0.5 * r_squared + 0.5 * sigma_r_squared
    part_00_sin_beta2 = (1.0 + attenuation_beta * sum_3) * shortfall_beta * sum_4
    sum_5 = 2.0 * attenuation_beta - 3.0 * shortfall_beta
    sum_6 = attenuation_beta * sum_5 - 12.0 * shortfall_beta_squared
    sum_7 = attenuation_beta * sum_6 - 13.0 * shortfall_beta * shortfall_beta_squared
    del sum_3, sum_4, sum_5, sum_6
    sum_8 = attenuation_beta * sum_7 - 6.0 * shortfall_beta_squared**2
    sum_9 = attenuation_beta * sum_8 - shortfall_beta * shortfall_beta_squared**2
    part_01_cos_beta_sin_beta = sigma_r_squared * term_3 - product_4 * shortfall_beta * sum_9
    del sum_7, sum_8, product_4, sigma_r_squared, sum_9, term_3
    sum_10 = attenuation_beta - 4.0 * shortfall_beta
    sum_11 = attenuation_beta * sum_10 - 2.0 * shortfall_beta_squared
    product_1 = rho * sigma_rdot
    sum_12 = attenuation_beta * rdot * sigma_r + product_1 * product_3 * sum_11
    del shortfall_beta, shortfall_beta_squared, sum_10, attenuation_beta, product_3, sum_11
    part_02_cos_beta = sigma_r * sum_12
    cos_beta_squared = cos_beta**2
    sin_beta_squared = sin_beta**2
    sigma_rdot_squared = sigma_rdot**2
    sum_13 = rdot**2 + (1.0 + 5.0 * rho**2) * sigma_rdot_squared
    product_2 = r * rdot
    sum_14 = 2.0 * product_1 * product_2 + sigma_r * sum_13
    mean[..., 0] = cos_beta * part_0_cos_beta
    mean[..., 1] = part_0_cos_beta * sin_beta
    mean[..., 2] = product_2 - product_1 * sigma_r
    del sum_12, sum_13, part_0_cos_beta, product_1, product_2
    covariance[..., 0, 0] = cos_beta_squared * part_00_cos_beta2 + part_00_sin_beta2 * sin_beta_squared
    covariance[..., 0, 1] = cos_beta * part_01_cos_beta_sin_beta * sin_beta
    covariance[..., 0, 2] = cos_beta * part_02_cos_beta
    covariance[..., 1, 0] = covariance[..., 0, 1]
    covariance[..., 1, 1] = cos_beta_squared * part_00_sin_beta2 + part_00_cos_beta2 * sin_beta_squared
    del part_01_cos_beta_sin_beta, cos_beta, cos_beta_squared, part_00_cos_beta2, part_00_sin_beta2, sin_beta_squared
    covariance[..., 1, 2] = part_02_cos_beta * sin_beta
    covariance[..., 2, 0] = covariance[..., 0, 2]
    covariance[..., 2, 1] = covariance[..., 1, 2]
    covariance[..., 2, 2] = r_squared * sigma_rdot_squared + sigma_r * sum_14
    del part_02_cos_beta, sin_beta, r_squared, sigma_rdot_squared, sum_14


def polar_doppler_posterior(
    r: Floats,
    beta: Floats,
    rdot: Floats,
    sigma_r: Floats,
    sigma_beta: Floats,
    sigma_rdot: Floats,
    rho: Floats,
    mean: Filled,
    covariance: Filled,
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
    del sum_1, sum_2, sum_4, sum_5
    sum_6 = attenuation_beta_squared * sigma_r_squared - r_squared * shortfall_beta * sum_3
    part_01_cos_beta_sin_beta = attenuation_beta_squared * sum_6
    del shortfall_beta, sigma_r_squared, sum_3, attenuation_beta_squared, sum_6
    product_1 = rho * sigma_rdot
    sum_7 = product_1 * r + rdot * sigma_r
    part_02_cos_beta = attenuation_beta * sigma_r * sum_7
    cos_beta_squared = cos_beta**2
    sin_beta_squared = sin_beta**2
    sigma_rdot_squared = sigma_rdot**2
    sum_8 = rdot**2 + (1.0 + rho**2) * sigma_rdot_squared
    product_2 = r * rdot
    sum_9 = 2.0 * product_1 * product_2 + sigma_r * sum_8
    mean[..., 0] = cos_beta * part_0_cos_beta
    mean[..., 1] = part_0_cos_beta * sin_beta
    del attenuation_beta, sum_7, sum_8, part_0_cos_beta
    mean[..., 2] = product_1 * sigma_r + product_2
    covariance[..., 0, 0] = cos_beta_squared * part_00_cos_beta2 + part_00_sin_beta2 * sin_beta_squared
    covariance[..., 0, 1] = cos_beta * part_01_cos_beta_sin_beta * sin_beta
    covariance[..., 0, 2] = cos_beta * part_02_cos_beta
    del product_1, product_2, part_01_cos_beta_sin_beta, cos_beta
    covariance[..., 1, 0] = covariance[..., 0, 1]
    covariance[..., 1, 1] = cos_beta_squared * part_00_sin_beta2 + part_00_cos_beta2 * sin_beta_squared
    del cos_beta_squared, part_00_cos_beta2, part_00_sin_beta2, sin_beta_squared
    covariance[..., 1, 2] = part_02_cos_beta * sin_beta
    covariance[..., 2, 0] = covariance[..., 0, 2]
    covariance[..., 2, 1] = covariance[..., 1, 2]
    covariance[..., 2, 2] = r_squared * sigma_rdot_squared + sigma_r * sum_9
    del part_02_cos_beta, sin_beta, r_squared, sigma_rdot_squared, sum_9


def ruv_linear(
    r: Floats,
    u: Floats,
    v: Floats,
    sigma_r: Floats,
    sigma_u: Floats,
    sigma_v: Floats,
    rho: Floats,
    mean: Filled,
    covariance: Filled,
) -> None:
    """Conversion ruv, linear.

    Mean: map from the measured quantities to coordinates. Covariance: covariance of the linearised
    conversion.
    """
    u_squared = u**2
    v_squared = v**2
    sum_1 = 1.0 - u_squared - v_squared
    root_1 = np.sqrt(sum_1)
    r_squared = r**2
    sigma_r_squared = sigma_r**2
    term_1 = 1.0 / root_1
    product_3 = sigma_u * u
    product_1 = product_3
    product_2 = rho * sigma_v
    product_6 = product_2 * v
    product_4 = r_squared * sigma_u
    product_5 = sigma_r_squared * sum_1
    sum_2 = (product_1 + product_6) * product_4 - product_5 * u
    sigma_v_squared = sigma_v**2
    sum_3 = product_3 * rho + sigma_v * v
    sum_4 = r_squared * sigma_v * sum_3 - product_5 * v
    sum_5 = 2.0 * product_6 + product_1
    del sum_1, product_5, sum_3, product_1, product_6
    sum_6 = product_3 * sum_5 + sigma_v_squared * v_squared
    sum_7 = r_squared * sum_6 + (u_squared - 1.0 + v_squared)**2 * sigma_r_squared
    mean[..., 0] = r * u
    mean[..., 1] = r * v
    mean[..., 2] = r * root_1
    covariance[..., 0, 0] = r_squared * sigma_u**2 + sigma_r_squared * u_squared
    del product_3, sum_5, sum_6, u_squared
    covariance[..., 0, 1] = product_2 * product_4 + sigma_r_squared * u * v
    covariance[..., 0, 2] = -sum_2 * term_1
    covariance[..., 1, 0] = covariance[..., 0, 1]
    covariance[..., 1, 1] = r_squared * sigma_v_squared + sigma_r_squared * v_squared
    del product_2, product_4, sum_2, r_squared, sigma_r_squared, sigma_v_squared, v_squared
    covariance[..., 1, 2] = -sum_4 * term_1
    covariance[..., 2, 0] = covariance[..., 0, 2]
    covariance[..., 2, 1] = covariance[..., 1, 2]
    covariance[..., 2, 2] = sum_7 / root_1**2
    del sum_4, term_1, root_1, sum_7


def ruv_second_order(
    r: Floats,
    u: Floats,
    v: Floats,
    sigma_r: Floats,
    sigma_u: Floats,
    sigma_v: Floats,
    rho: Floats,
    mean: Filled,
    covariance: Filled,
) -> None:
    """Conversion ruv, second_order.

    Mean: map from the measured quantities to coordinates less the bias of the plain conversion to second
    order. Covariance: covariance of the conversion's quadratic Taylor polynomial.
    """
    u_squared = u**2
    v_squared = v**2
    sum_1 = 1.0 - u_squared - v_squared
    root_1 = np.sqrt(sum_1)
    sum_2 = 1.0 - v
    sum_3 = 1.0 + v
    product_7 = sum_2 * sum_3
    product_2 = rho * sigma_v
    product_4 = product_2 * v
    product_9 = product_4 * u
    sum_4 = 0.5 * product_7 * sigma_u + product_9
    sum_5 = 1.0 - u
    sigma_v_squared = sigma_v**2
    sum_6 = 1.0 + u
    product_6 = sigma_v_squared * sum_5
    product_8 = product_6 * sum_6
    sum_7 = 0.5 * product_8 + sigma_u * sum_4
    del sum_2, sum_5, product_6, sum_4
    sum_8 = root_1 + sum_7 / (root_1 * root_1**2)
    r_squared = r**2
    sigma_u_squared = sigma_u**2
    sigma_r_squared = sigma_r**2
    term_1 = 1.0 / root_1
    product_3 = sigma_u * u
    product_1 = product_3
    sum_9 = product_1 + product_4
    sum_10 = r_squared * sum_9 + sigma_r_squared * sum_9
    product_5 = sigma_r_squared * sum_1
    sum_11 = product_5 * u - sigma_u * sum_10
    del sum_7, sum_9, sum_1, sum_10
    sum_12 = product_3 * rho + sigma_v * v
    sum_13 = r_squared * sum_12 + sigma_r_squared * sum_12
    sum_14 = product_5 * v - sigma_v * sum_13
    term_2 = (u_squared - 1.0 + v_squared)**2
    sum_15 = 2.0 * product_8 + 2.0 * term_2
    del sum_12, product_5, sum_13, product_8
    sum_16 = 1.0 - (1.0 - 2.0 * v_squared) * u_squared - v_squared
    sum_17 = 2.0 * product_3 * product_7 * v + product_2 * sum_16
    sum_18 = rho * sum_17 + sigma_v * u_squared * v_squared
    sum_19 = 0.5 * (v - 1.0)**2 * sigma_u_squared * sum_3**2 + sigma_v * sum_18 + term_2 * u_squared
    del product_7, sum_16, sum_17, sum_18, sum_3
    sum_20 = product_9 * sum_15 + sigma_u * sum_19
    sum_21 = 0.5 * (u - 1.0)**2 * sigma_v_squared * sum_6**2 + term_2 * v_squared
    del product_9, sum_15, sum_19, sum_6
    sum_22 = sigma_v_squared * sum_21 + sigma_u * sum_20
    sum_23 = 2.0 * product_4 + product_1
    del sum_20, sum_21, product_1, product_4
    sum_24 = product_3 * sum_23 + sigma_v_squared * v_squared + term_2
    sum_25 = r_squared * sum_22 + sigma_r_squared * sum_24 * term_2
    del product_3, sum_23, sum_22, sum_24, term_2
    mean[..., 0] = r * u
    mean[..., 1] = r * v
    mean[..., 2] = r * sum_8
    covariance[..., 0, 0] = r_squared * sigma_u_squared + sigma_r_squared * (sigma_u_squared + u_squared)
    covariance[..., 0, 1] = product_2 * (r_squared + sigma_r_squared) * sigma_u + sigma_r_squared * u * v
    del sum_8, sigma_u_squared, u_squared, product_2
    covariance[..., 0, 2] = sum_11 * term_1
    covariance[..., 1, 0] = covariance[..., 0, 1]
    covariance[..., 1, 1] = r_squared * sigma_v_squared + sigma_r_squared * (sigma_v_squared + v_squared)
    del sum_11, r_squared, sigma_r_squared, sigma_v_squared, v_squared
    covariance[..., 1, 2] = sum_14 * term_1
    covariance[..., 2, 0] = covariance[..., 0, 2]
    covariance[..., 2, 1] = covariance[..., 1, 2]
    covariance[..., 2, 2] = sum_25 / (root_1 * root_1**2)**2
    del sum_14, term_1, root_1, sum_25


def ruv_averaged(
    r: Floats,
    u: Floats,
    v: Floats,
    sigma_r: Floats,
    sigma_u: Floats,
    sigma_v: Floats,
    rho: Floats,
    mean: Filled,
    covariance: Filled,
) -> None:
    """Conversion ruv, averaged.

    Mean: map from the measured quantities to coordinates less the bias of the plain conversion, averaged over
    the truth, to fourth order. Covariance: covariance of the plain conversion, averaged over the truth, to
    fourth order, completed to a sum of squares.
    """
    u_squared = u**2
    v_squared = v**2
    sum_1 = 1.0 - u_squared - v_squared
    root_1 = np.sqrt(sum_1)
    sum_2 = u_squared - 1.0 + v_squared
    sum_2_squared = sum_2**2
    sum_3 = 3.0 - 3.0 * u_squared + 2.0 * v_squared
    sigma_v_squared = sigma_v**2
    product_18 = sigma_v_squared * sum_3
    sum_4 = 4.5 * product_18 + sum_2_squared
    sum_5 = 1.0 - v
    sum_6 = 1.0 - v_squared + 4.0 * u_squared
    sigma_u_squared = sigma_u**2
    sum_7 = 1.0 + v
    sum_8 = 1.125 * sigma_u_squared * sum_6 + 0.5 * sum_2_squared
    sum_9 = 1.0 - 2.0 * u_squared + 11.0 * v_squared
    sum_10 = 1.0 + sum_9 * u_squared + (1.0 - 2.0 * v_squared) * v_squared
    sum_11 = 3.0 - 3.0 * v_squared + 2.0 * u_squared
    product_14 = rho * sigma_v
    product_6 = sigma_u * u
    sum_12 = 1.5 * product_14 * sum_10 + 4.5 * product_6 * sum_11 * v
    sum_13 = 0.75 * sigma_v * sum_10 + rho * sum_12
    del sum_3, sum_9, sum_10, sum_12
    product_20 = sum_5 * sum_7
    sum_14 = product_20 * sum_8 + sigma_v * sum_13
    product_3 = sigma_v * v
    product_4 = product_3 * rho
    product_12 = product_4 * u
    sum_15 = product_12 * sum_4 + sigma_u * sum_14
    del sum_13, sum_8, sum_14, sum_4
    sum_16 = 1.0 - u
    sum_17 = 1.0 - u_squared + 4.0 * v_squared
    sum_18 = 1.0 + u
    sum_19 = 1.125 * sigma_v_squared * sum_17 + 0.5 * sum_2_squared
    product_5 = sum_16 * sum_18
    product_8 = product_5 * sigma_v_squared
    sum_20 = product_8 * sum_19 + sigma_u * sum_15
    sum_21 = root_1 + sum_20 / (root_1 * (root_1 * root_1**2)**2)
    del sum_16, sum_15, sum_19, sum_20
    r_squared = r**2
    sigma_r_squared = sigma_r**2
    sum_22 = 3.0 * sigma_u_squared + u_squared
    sum_23 = 3.0 * sigma_r_squared + r_squared
    term_1 = 1.0 / (root_1 * (root_1**2)**2)
    product_1 = sum_2 * sum_2_squared
    sum_24 = product_1 + product_8 * sum_1
    sum_25 = 3.0 * product_8 + sum_2_squared
    sum_26 = 1.0 - v_squared + 2.0 * u_squared
    product_7 = sigma_u_squared * sum_7
    product_11 = product_7 * sum_5
    product_2 = 3.0 * product_11
    sum_27 = 1.0 - u_squared + 2.0 * v_squared
    rho_squared = rho**2
    product_17 = sigma_v_squared * sum_27
    sum_28 = (1.0 + 2.0 * rho_squared) * product_17 + product_2 + sum_2_squared
    product_10 = sigma_u * sum_26
    product_22 = product_10 * product_4
    sum_29 = 3.0 * product_22 + sum_28 * u
    sum_30 = product_4 * sum_25 + sigma_u * sum_29
    sum_31 = 3.0 - 3.0 * v_squared - u_squared
    sum_32 = 4.0 - 3.0 * u_squared - 4.0 * v_squared
    sum_33 = product_4 * sum_31 + product_6 * sum_32
    del sum_2, sum_28, sum_29, product_4, sum_31, sum_32
    product_15 = sigma_r_squared * sum_1
    sum_34 = product_15 * sum_33 + r_squared * sum_30
    product_16 = sigma_r_squared * u
    sum_35 = product_16 * sum_24 + sigma_u * sum_34
    del sum_30, sum_33, sum_24, sum_34
    sum_36 = 3.0 * sigma_v_squared + v_squared
    sum_37 = product_1 + product_11 * sum_1
    sum_38 = 3.0 * product_17 + product_2 + sum_2_squared
    del product_1, sum_1, product_17, product_2
    sum_39 = 2.0 * product_22 + sum_38 * u
    sum_40 = product_10 * product_3 + rho * sum_39
    del product_22, sum_38, product_10, sum_39
    sum_41 = product_3 * sum_25 + sigma_u * sum_40
    sum_42 = 3.0 - 3.0 * u_squared - v_squared
    sum_43 = 4.0 - 3.0 * v_squared - 4.0 * u_squared
    product_9 = product_6 * rho
    sum_44 = product_3 * sum_43 + product_9 * sum_42
    del sum_25, sum_40, sum_42, sum_43
    sum_45 = product_15 * sum_44 + r_squared * sum_41
    sum_46 = sigma_r_squared * sum_37 * v + sigma_v * sum_45
    del product_15, sum_41, sum_44, sum_37, sum_45
    sum_47 = 2.0 * sum_2_squared + 6.0 * product_18
    sum_48 = 2.0 * sum_2_squared + 4.0 * product_8
    sum_49 = r_squared * sum_47 + sigma_r_squared * sum_48
    sigma_v_squared_squared = sigma_v_squared**2
    product_13 = r_squared * sigma_v_squared_squared
    del product_18, sum_47, sum_48, sigma_v_squared_squared
    sum_50 = 18.0 * product_13 * product_5 * sum_27 + sum_2_squared * sum_49
    sum_51 = 2.0 - 2.0 * v_squared - 3.0 * u_squared
    term_2 = (v - 1.0)**2
    product_21 = product_9 * v
    sum_52 = 2.0 * product_5 * sigma_v + 4.0 * product_21
    sum_53 = 4.0 * rho_squared * sigma_v * u_squared * v_squared + product_20 * sum_52
    del sum_49, product_9, product_5, product_20, rho_squared, sum_52
    sum_54 = sum_2_squared * sum_51 - sigma_u_squared * sum_7**2 * term_2 - sigma_v * sum_53
    sum_55 = 1.5 * sum_2_squared * sum_5 * sum_6 + 9.0 * product_7 * term_2 * u_squared
    del sum_51, sum_53, sum_7, sum_5, sum_6, term_2
    sum_56 = 18.0 * product_11 * sum_26 + 6.0 * sum_11 * sum_2_squared
    sum_57 = 2.0 - 2.0 * u_squared + 11.0 * v_squared
    sum_58 = sum_57 * u_squared + (2.0 - 2.0 * v_squared) * v_squared
    sum_59 = 2.0 - 17.0 * v_squared + 5.0 * u_squared
    sum_60 = 7.0 - sum_59 * u_squared - (2.0 + 5.0 * v_squared) * v_squared
    del product_11, sum_11, sum_57, sum_59
    sum_61 = 1.0 - 4.0 * u_squared + 22.0 * v_squared
    sum_62 = 3.0 + sum_61 * u_squared + (1.0 - 4.0 * v_squared) * v_squared
    sum_63 = 4.0 - 2.0 * u_squared + 14.0 * v_squared
    sum_64 = 2.0 - sum_63 * u_squared + (11.0 + 11.0 * v_squared) * v_squared
    sum_65 = sum_64 * u_squared + (3.0 - 3.0 * v_squared) * v_squared
    sum_66 = 11.0 - 14.0 * v_squared + 11.0 * u_squared
    sum_67 = 2.0 - (4.0 - 2.0 * v_squared) * v_squared + sum_66 * u_squared
    del sum_61, sum_63, sum_64, sum_66
    sum_68 = sum_67 * v_squared + (3.0 - 3.0 * u_squared) * u_squared
    sum_69 = 4.0 * sigma_u * sum_68 + 8.0 * product_12 * sum_26 * sum_27
    del sum_67, sum_26, sum_27, sum_68
    sum_70 = 4.0 * sigma_v_squared * sum_65 + sum_2_squared * sum_62 + sigma_u * sum_69
    sum_71 = 4.0 * product_3 * product_6 * sum_60 + rho * sum_70
    del sum_62, sum_65, sum_69, product_3, product_6, sum_60, sum_70
    sum_72 = 10.0 - 16.0 * v_squared + 10.0 * u_squared
    sum_73 = 1.0 - (2.0 - v_squared) * v_squared + sum_72 * u_squared
    sum_74 = sum_73 * v_squared + (6.0 - 6.0 * u_squared) * u_squared
    sum_75 = 2.0 - u_squared + 16.0 * v_squared
    sum_76 = 1.0 - sum_75 * u_squared + (10.0 + 10.0 * v_squared) * v_squared
    sum_77 = sum_76 * u_squared + (6.0 - 6.0 * v_squared) * v_squared
    del sum_72, sum_73, sum_75, sum_76
    sum_78 = sigma_u_squared * sum_74 + sigma_v_squared * sum_77 + sum_2_squared * sum_58 + rho * sum_71
    del sum_58, sum_71, sum_74, sum_77
    sum_79 = product_21 * sum_56 + sigma_v * sum_78
    sum_80 = product_7 * sum_55 + sum_2_squared**2 * u_squared + sigma_v * sum_79
    del product_21, sum_56, sum_78, product_7, sum_55, sum_79
    sum_81 = r_squared * sum_80 - sigma_r_squared * sum_2_squared * sum_54
    sum_82 = product_12 * sum_50 + sigma_u * sum_81
    del sum_54, sum_80, product_12, sum_50, sum_81
    sum_83 = 2.0 - 2.0 * u_squared - 3.0 * v_squared
    sum_18_squared = sum_18**2
    term_3 = (u - 1.0)**2
    product_19 = sum_18_squared * term_3
    del u_squared, sum_18, sum_18_squared, term_3
    sum_84 = sum_2_squared * sum_83 - product_19 * sigma_v_squared
    sum_85 = 1.5 * product_8 * sum_17 + sum_2_squared * v_squared
    sum_86 = r_squared * sum_85 - sigma_r_squared * sum_84
    del sum_83, product_8, sum_17, sum_84, sum_85
    sum_87 = 9.0 * product_13 * product_19 * v_squared + sum_2_squared * sum_86
    del product_13, product_19, sum_86, v_squared
    sum_88 = sigma_r_squared * sum_2_squared * sum_2_squared**2 + sigma_v_squared * sum_87 + sigma_u * sum_82
    mean[..., 0] = r * u
    mean[..., 1] = r * v
    mean[..., 2] = r * sum_21
    del sum_2_squared, sum_82, sum_87, sum_21
    covariance[..., 0, 0] = r_squared * sigma_u_squared + sigma_r_squared * sum_22
    covariance[..., 0, 1] = product_14 * sigma_u * sum_23 + product_16 * v
    del sigma_u_squared, sum_22, product_14, product_16, sum_23
    covariance[..., 0, 2] = -sum_35 * term_1
    covariance[..., 1, 0] = covariance[..., 0, 1]
    covariance[..., 1, 1] = r_squared * sigma_v_squared + sigma_r_squared * sum_36
    del sum_35, r_squared, sigma_r_squared, sigma_v_squared, sum_36
    covariance[..., 1, 2] = -sum_46 * term_1
    covariance[..., 2, 0] = covariance[..., 0, 2]
    covariance[..., 2, 1] = covariance[..., 1, 2]
    covariance[..., 2, 2] = sum_88 / (root_1 * (root_1**2)**2)**2
    del sum_46, term_1, root_1, sum_88


def ruv_unbiased(
    r: Floats,
    u: Floats,
    v: Floats,
    sigma_r: Floats,
    sigma_u: Floats,
    sigma_v: Floats,
    rho: Floats,
    mean: Filled,
    covariance: Filled,
) -> None:
    """Conversion ruv, unbiased.

    Mean: unbiased estimate of the position, to fourth order. Covariance: error covariance of the unbiased
    estimate u, to fourth order, completed to a sum of squares.
    """
    u_squared = u**2
    v_squared = v**2
    sum_1 = 1.0 - u_squared - v_squared
    root_1 = np.sqrt(sum_1)
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
    product_14 = rho * sigma_v
    product_7 = sigma_u * u
    sum_12 = 1.5 * product_7 * sum_9 * v + 0.5 * product_14 * sum_11
    del sum_3, sum_5, sum_10, sum_9
    sum_13 = 0.25 * sigma_v * sum_11 + rho * sum_12
    product_9 = sum_6 * sum_7
    sum_14 = product_9 * sum_8 - sigma_v * sum_13
    del sum_11, sum_12, sum_13, sum_8
    product_4 = sigma_v * v
    product_6 = product_4 * rho
    product_13 = product_6 * u
    sum_15 = product_13 * sum_4 + sigma_u * sum_14
    sum_16 = 1.0 - u_squared + 4.0 * v_squared
    sum_17 = 1.0 - u
    sum_18 = 1.0 + u
    sum_19 = 0.5 * sum_2_squared - 0.375 * sigma_v_squared * sum_16
    product_5 = sum_17 * sum_18
    del sum_14, sum_4, sum_16, sum_17
    product_8 = product_5 * sigma_v_squared
    sum_20 = product_8 * sum_19 + sigma_u * sum_15 + sum_2_squared_squared
    r_squared = r**2
    sigma_r_squared = sigma_r**2
    term_1 = 1.0 / (root_1 * (root_1**2)**2)
    product_2 = sum_2 * sum_2_squared
    sum_21 = product_2 + 0.5 * product_8 * sum_1
    sum_22 = 1.5 * product_8 + sum_2_squared
    sum_23 = 1.0 - v_squared + 2.0 * u_squared
    product_12 = product_9 * sigma_u_squared
    product_3 = 1.5 * product_12
    sum_24 = 1.0 - u_squared + 2.0 * v_squared
    rho_squared = rho**2
    product_19 = sigma_v_squared * sum_24
    sum_25 = product_19 * (0.5 + rho_squared) + product_3 + sum_2_squared
    product_11 = sigma_u * sum_23
    product_23 = product_11 * product_6
    sum_26 = 1.5 * product_23 + sum_25 * u
    del sum_15, sum_19, sum_2, sum_25
    sum_27 = product_6 * sum_22 + sigma_u * sum_26
    sum_28 = 3.0 - 2.0 * u_squared - 3.0 * v_squared
    sum_29 = product_6 * product_9 + 0.5 * product_7 * sum_28
    product_15 = sigma_r_squared * sum_1
    sum_30 = product_15 * sum_29 + r_squared * sum_27
    del sum_26, product_6, sum_28, sum_27, sum_29
    product_17 = sigma_r_squared * u
    sum_31 = product_17 * sum_21 + sigma_u * sum_30
    sum_32 = 0.5 * product_12 * sum_1 + product_2
    sum_33 = 1.5 * product_19 + product_3 + sum_2_squared
    del sum_21, sum_30, sum_1, product_19, product_3
    sum_34 = product_23 + sum_33 * u
    sum_35 = 0.5 * product_11 * product_4 + rho * sum_34
    del product_23, sum_33, product_11, sum_34
    sum_36 = product_4 * sum_22 + sigma_u * sum_35
    sum_37 = 3.0 - 2.0 * v_squared - 3.0 * u_squared
    product_10 = product_7 * rho
    sum_38 = product_10 * product_5 + 0.5 * product_4 * sum_37
    sum_39 = product_15 * sum_38 + r_squared * sum_36
    del sum_22, sum_35, sum_37, product_15, sum_36, sum_38
    sum_40 = sigma_r_squared * sum_32 * v + sigma_v * sum_39
    sum_41 = 2.0 - 2.0 * u_squared + v_squared
    product_21 = product_8 * sum_24
    sum_42 = 6.0 * sum_2_squared * sum_41 + 4.5 * product_21
    sum_43 = 2.0 * sum_2_squared_squared + sigma_v_squared * sum_42
    del sum_32, sum_39, sum_41, sum_42
    product_16 = sigma_r_squared * sum_2_squared
    sum_44 = product_16 * product_8 + r_squared * sum_43
    term_2 = (v - 1.0)**2
    product_18 = sigma_u_squared * sum_7
    sum_45 = 1.5 * sum_23 * sum_2_squared * sum_6 + 2.25 * product_18 * term_2 * u_squared
    sum_46 = 2.0 - 2.0 * v_squared + u_squared
    sum_47 = 6.0 * sum_2_squared * sum_46 + 4.5 * product_12 * sum_23
    del product_8, sum_43, sum_6, product_12, sum_46
    sum_48 = 1.0 - 7.0 * v_squared + u_squared
    sum_49 = 2.0 - sum_48 * u_squared - v_squared * (1.0 + v_squared)
    sum_50 = 1.0 - 2.0 * u_squared + 14.0 * v_squared
    sum_51 = 1.0 + product_1 + sum_50 * u_squared
    sum_52 = 11.0 - 14.0 * v_squared + 11.0 * u_squared
    sum_53 = 2.0 - (4.0 - 2.0 * v_squared) * v_squared + sum_52 * u_squared
    del sum_48, product_1, sum_50, sum_52
    sum_54 = sum_53 * v_squared + (3.0 - 3.0 * u_squared) * u_squared
    sum_55 = 2.0 * product_13 * sum_23 * sum_24 + sigma_u * sum_54
    del sum_53, sum_23, sum_24, sum_54
    sum_56 = 4.0 - 2.0 * u_squared + 14.0 * v_squared
    sum_57 = 2.0 - sum_56 * u_squared + (11.0 + 11.0 * v_squared) * v_squared
    sum_58 = sum_57 * u_squared + (3.0 - 3.0 * v_squared) * v_squared
    sum_59 = sigma_v_squared * sum_58 + sum_2_squared * sum_51 + sigma_u * sum_55
    del sum_56, sum_57, sum_51, sum_55, sum_58
    sum_60 = 2.0 - 17.0 * v_squared + 5.0 * u_squared
    sum_61 = 7.0 - sum_60 * u_squared - (2.0 + 5.0 * v_squared) * v_squared
    sum_62 = product_4 * product_7 * sum_61 + rho * sum_59
    del sum_60, product_4, product_7, sum_59, sum_61
    sum_63 = 10.0 - 16.0 * v_squared + 10.0 * u_squared
    sum_64 = 1.0 - (2.0 - v_squared) * v_squared + sum_63 * u_squared
    sum_65 = sum_64 * v_squared + (6.0 - 6.0 * u_squared) * u_squared
    sum_66 = 2.0 - u_squared + 16.0 * v_squared
    sum_67 = 1.0 - sum_66 * u_squared + (10.0 + 10.0 * v_squared) * v_squared
    sum_68 = sum_67 * u_squared + (6.0 - 6.0 * v_squared) * v_squared
    del sum_63, sum_64, sum_66, sum_67
    sum_69 = (
        0.25 * sigma_u_squared * sum_65
        + 0.25 * sigma_v_squared * sum_68
        + sum_2_squared * sum_49
        + rho * sum_62
    )
    del sum_49, sum_62, sum_65, sum_68
    product_22 = product_10 * v
    sum_70 = product_22 * sum_47 + sigma_v * sum_69
    sum_71 = product_18 * sum_45 + sum_2_squared_squared * u_squared + sigma_v * sum_70
    del product_10, sum_47, sum_69, product_18, sum_2_squared_squared, sum_45, sum_70
    sum_72 = product_22 + 0.5 * product_5 * sigma_v
    sum_73 = product_9 * sum_72 + rho_squared * sigma_v * u_squared * v_squared
    del product_22, product_5, product_9, rho_squared, sum_72
    sum_74 = product_2 + 0.25 * sigma_u_squared * sum_7**2 * term_2 + sigma_v * sum_73
    sum_75 = product_16 * sum_74 + r_squared * sum_71
    del sum_7, sum_73, term_2, product_16, sum_71, sum_74
    sum_76 = product_13 * sum_44 + sigma_u * sum_75
    sum_77 = 1.5 * product_21 + sum_2_squared * v_squared
    del product_13, sum_44, sum_75, product_21
    sum_18_squared = sum_18**2
    term_3 = (u - 1.0)**2
    product_20 = sum_18_squared * term_3
    sum_78 = product_2 + 0.25 * product_20 * sigma_v_squared
    del sum_18, sum_18_squared, term_3, product_2
    sum_79 = r_squared * sum_77 + sigma_r_squared * sum_78
    sum_80 = 2.25 * product_20 * r_squared * sigma_v_squared**2 * v_squared + sum_2_squared * sum_79
    del sum_77, sum_78, product_20, sum_79
    sum_81 = sigma_r_squared * sum_2_squared * sum_2_squared**2 + sigma_v_squared * sum_80 + sigma_u * sum_76
    mean[..., 0] = r * u
    mean[..., 1] = r * v
    mean[..., 2] = r * sum_20 / (root_1 * (root_1 * root_1**2)**2)
    del sum_2_squared, sum_76, sum_80, sum_20
    covariance[..., 0, 0] = r_squared * sigma_u_squared + sigma_r_squared * (sigma_u_squared + u_squared)
    covariance[..., 0, 1] = product_14 * (r_squared + sigma_r_squared) * sigma_u + product_17 * v
    del sigma_u_squared, u_squared, product_14, product_17
    covariance[..., 0, 2] = -sum_31 * term_1
    covariance[..., 1, 0] = covariance[..., 0, 1]
    covariance[..., 1, 1] = r_squared * sigma_v_squared + sigma_r_squared * (sigma_v_squared + v_squared)
    del sum_31, r_squared, sigma_r_squared, sigma_v_squared, v_squared
    covariance[..., 1, 2] = -sum_40 * term_1
    covariance[..., 2, 0] = covariance[..., 0, 2]
    covariance[..., 2, 1] = covariance[..., 1, 2]
    covariance[..., 2, 2] = sum_81 / (root_1 * (root_1**2)**2)**2
    del sum_40, term_1, root_1, sum_81


def ruv_posterior(
    r: Floats,
    u: Floats,
    v: Floats,
    sigma_r: Floats,
    sigma_u: Floats,
    sigma_v: Floats,
    rho: Floats,
    mean: Filled,
    covariance: Filled,
) -> None:
    """Conversion ruv, posterior.

    Mean: posterior mean of the position under a flat prior, to fourth order. Covariance: posterior covariance
    of the position under a flat prior, to fourth order, completed to a sum of squares.
    """
    u_squared = u**2
    v_squared = v**2
    sum_1 = 1.0 - u_squared - v_squared
    root_1 = np.sqrt(sum_1)
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
    product_14 = rho * sigma_v
    product_7 = sigma_u * u
    sum_12 = 1.5 * product_7 * sum_9 * v + 0.5 * product_14 * sum_11
    del sum_3, sum_6, sum_10, sum_9
    sum_13 = 0.25 * sigma_v * sum_11 + rho * sum_12
    product_9 = sum_5 * sum_7
    sum_14 = product_9 * sum_8 + sigma_v * sum_13
    del sum_11, sum_12, sum_13, sum_8
    product_4 = sigma_v * v
    product_6 = product_4 * rho
    product_13 = product_6 * u
    sum_15 = product_13 * sum_4 + sigma_u * sum_14
    sum_16 = 1.0 - u
    sum_17 = 1.0 - u_squared + 4.0 * v_squared
    sum_18 = 1.0 + u
    sum_19 = 0.375 * sigma_v_squared * sum_17 + 0.5 * sum_2_squared
    product_5 = sum_16 * sum_18
    del sum_14, sum_4, sum_17, sum_16
    product_8 = product_5 * sigma_v_squared
    sum_20 = sum_2_squared_squared - product_8 * sum_19 - sigma_u * sum_15
    r_squared = r**2
    sigma_r_squared = sigma_r**2
    term_1 = 1.0 / (root_1 * (root_1**2)**2)
    product_2 = sum_2 * sum_2_squared
    sum_21 = product_2 + 0.5 * product_8 * sum_1
    sum_22 = 1.5 * product_8 + sum_2_squared
    sum_23 = 1.0 - v_squared + 2.0 * u_squared
    product_12 = product_9 * sigma_u_squared
    product_3 = 1.5 * product_12
    sum_24 = 1.0 - u_squared + 2.0 * v_squared
    rho_squared = rho**2
    product_19 = sigma_v_squared * sum_24
    sum_25 = product_19 * (0.5 + rho_squared) + product_3 + sum_2_squared
    product_11 = sigma_u * sum_23
    product_22 = product_11 * product_6
    sum_26 = 1.5 * product_22 + sum_25 * u
    del sum_15, sum_19, sum_2, sum_25
    sum_27 = product_6 * sum_22 + sigma_u * sum_26
    sum_28 = 3.0 - 2.0 * u_squared - 3.0 * v_squared
    sum_29 = product_6 * product_9 + 0.5 * product_7 * sum_28
    product_15 = sigma_r_squared * sum_1
    sum_30 = product_15 * sum_29 + r_squared * sum_27
    del sum_26, product_6, sum_28, sum_27, sum_29
    product_17 = sigma_r_squared * u
    sum_31 = product_17 * sum_21 + sigma_u * sum_30
    sum_32 = 0.5 * product_12 * sum_1 + product_2
    sum_33 = 1.5 * product_19 + product_3 + sum_2_squared
    del sum_21, sum_30, sum_1, product_19, product_3
    sum_34 = product_22 + sum_33 * u
    sum_35 = 0.5 * product_11 * product_4 + rho * sum_34
    del product_22, sum_33, product_11, sum_34
    sum_36 = product_4 * sum_22 + sigma_u * sum_35
    sum_37 = 3.0 - 2.0 * v_squared - 3.0 * u_squared
    product_10 = product_7 * rho
    sum_38 = product_10 * product_5 + 0.5 * product_4 * sum_37
    sum_39 = product_15 * sum_38 + r_squared * sum_36
    del sum_22, sum_35, sum_37, product_15, sum_36, sum_38
    sum_40 = sigma_r_squared * sum_32 * v + sigma_v * sum_39
    sum_41 = 4.0 - 4.0 * u_squared + 3.0 * v_squared
    sum_42 = 2.0 * sum_2_squared * sum_41 + 4.5 * product_8 * sum_24
    sum_43 = 2.0 * sum_2_squared_squared + sigma_v_squared * sum_42
    del sum_32, sum_39, sum_41, sum_42
    product_16 = sigma_r_squared * sum_2_squared
    sum_44 = product_16 * product_8 + r_squared * sum_43
    sum_45 = 1.0 - v_squared + 6.0 * u_squared
    term_2 = (v - 1.0)**2
    product_18 = sigma_u_squared * sum_7
    sum_46 = 2.25 * product_18 * term_2 * u_squared + 0.5 * sum_2_squared * sum_45 * sum_5
    sum_47 = 4.0 - 4.0 * v_squared + 3.0 * u_squared
    sum_48 = 2.0 * sum_2_squared * sum_47 + 4.5 * product_12 * sum_23
    del sum_43, sum_45, sum_5, product_12, sum_47
    sum_49 = 1.0 - u_squared + 5.0 * v_squared
    sum_50 = sum_49 * u_squared + (1.0 - v_squared) * v_squared
    sum_51 = 1.0 - 2.0 * u_squared + 10.0 * v_squared
    sum_52 = 1.0 + product_1 + sum_51 * u_squared
    sum_53 = 11.0 - 14.0 * v_squared + 11.0 * u_squared
    sum_54 = 2.0 - (4.0 - 2.0 * v_squared) * v_squared + sum_53 * u_squared
    del sum_49, product_1, sum_51, sum_53
    sum_55 = sum_54 * v_squared + (3.0 - 3.0 * u_squared) * u_squared
    sum_56 = 2.0 * product_13 * sum_23 * sum_24 + sigma_u * sum_55
    del sum_54, sum_23, sum_24, sum_55
    sum_57 = 4.0 - 2.0 * u_squared + 14.0 * v_squared
    sum_58 = 2.0 - sum_57 * u_squared + (11.0 + 11.0 * v_squared) * v_squared
    sum_59 = sum_58 * u_squared + (3.0 - 3.0 * v_squared) * v_squared
    sum_60 = sigma_v_squared * sum_59 + sum_2_squared * sum_52 + sigma_u * sum_56
    del sum_57, sum_58, sum_52, sum_56, sum_59
    sum_61 = 2.0 - 17.0 * v_squared + 5.0 * u_squared
    sum_62 = 7.0 - sum_61 * u_squared - (2.0 + 5.0 * v_squared) * v_squared
    sum_63 = product_4 * product_7 * sum_62 + rho * sum_60
    del sum_61, product_4, product_7, sum_60, sum_62
    sum_64 = 10.0 - 16.0 * v_squared + 10.0 * u_squared
    sum_65 = 1.0 - (2.0 - v_squared) * v_squared + sum_64 * u_squared
    sum_66 = sum_65 * v_squared + (6.0 - 6.0 * u_squared) * u_squared
    sum_67 = 2.0 - u_squared + 16.0 * v_squared
    sum_68 = 1.0 - sum_67 * u_squared + (10.0 + 10.0 * v_squared) * v_squared
    sum_69 = sum_68 * u_squared + (6.0 - 6.0 * v_squared) * v_squared
    del sum_64, sum_65, sum_67, sum_68
    sum_70 = (
        0.25 * sigma_u_squared * sum_66
        + 0.25 * sigma_v_squared * sum_69
        + sum_2_squared * sum_50
        + rho * sum_63
    )
    del sum_50, sum_63, sum_66, sum_69
    product_21 = product_10 * v
    sum_71 = product_21 * sum_48 + sigma_v * sum_70
    sum_72 = product_18 * sum_46 + sum_2_squared_squared * u_squared + sigma_v * sum_71
    del product_10, sum_48, sum_70, product_18, sum_2_squared_squared, sum_46, sum_71
    sum_73 = product_21 + 0.5 * product_5 * sigma_v
    sum_74 = product_9 * sum_73 + rho_squared * sigma_v * u_squared * v_squared
    del product_21, product_5, product_9, rho_squared, sum_73
    sum_75 = product_2 + 0.25 * sigma_u_squared * sum_7**2 * term_2 + sigma_v * sum_74
    sum_76 = product_16 * sum_75 + r_squared * sum_72
    del sum_7, sum_74, term_2, product_16, sum_72, sum_75
    sum_77 = product_13 * sum_44 + sigma_u * sum_76
    sum_78 = 1.0 - u_squared + 6.0 * v_squared
    sum_79 = 0.5 * product_8 * sum_78 + sum_2_squared * v_squared
    del product_13, sum_44, sum_76, product_8, sum_78
    sum_18_squared = sum_18**2
    term_3 = (u - 1.0)**2
    product_20 = sum_18_squared * term_3
    sum_80 = product_2 + 0.25 * product_20 * sigma_v_squared
    del sum_18, sum_18_squared, term_3, product_2
    sum_81 = r_squared * sum_79 + sigma_r_squared * sum_80
    sum_82 = 2.25 * product_20 * r_squared * sigma_v_squared**2 * v_squared + sum_2_squared * sum_81
    del sum_79, sum_80, product_20, sum_81
    sum_83 = sigma_r_squared * sum_2_squared * sum_2_squared**2 + sigma_v_squared * sum_82 + sigma_u * sum_77
    mean[..., 0] = r * u
    mean[..., 1] = r * v
    mean[..., 2] = r * sum_20 / (root_1 * (root_1 * root_1**2)**2)
    del sum_2_squared, sum_77, sum_82, sum_20
    covariance[..., 0, 0] = r_squared * sigma_u_squared + sigma_r_squared * (sigma_u_squared + u_squared)
    covariance[..., 0, 1] = product_14 * (r_squared + sigma_r_squared) * sigma_u + product_17 * v
    del sigma_u_squared, u_squared, product_14, product_17
    covariance[..., 0, 2] = -sum_31 * term_1
    covariance[..., 1, 0] = covariance[..., 0, 1]
    covariance[..., 1, 1] = r_squared * sigma_v_squared + sigma_r_squared * (sigma_v_squared + v_squared)
    del sum_31, r_squared, sigma_r_squared, sigma_v_squared, v_squared
    covariance[..., 1, 2] = -sum_40 * term_1
    covariance[..., 2, 0] = covariance[..., 0, 2]
    covariance[..., 2, 1] = covariance[..., 1, 2]
    covariance[..., 2, 2] = sum_83 / (root_1 * (root_1**2)**2)**2
    del sum_40, term_1, root_1, sum_83


def spherical_linear(
    r: Floats,
    beta: Floats,
    epsilon: Floats,
    sigma_r: Floats,
    sigma_beta: Floats,
    sigma_epsilon: Floats,
    rho: Floats,
    mean: Filled,
    covariance: Filled,
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
    product_8 = r_squared * sigma_beta_squared
    part_00_cos_beta2_cos_epsilon2 = product_8
    product_7 = r * rho
    product_10 = sigma_beta * sigma_r
    product_11 = product_10 * product_7
    part_00_cos_beta_cos_epsilon2_sin_beta = 2.0 * product_11
    sigma_epsilon_squared = sigma_epsilon**2
    product_9 = r_squared * sigma_epsilon_squared
    del sigma_beta_squared, product_10, product_7, r_squared, sigma_epsilon_squared
    part_00_sin_beta2_sin_epsilon2 = product_9
    part_01_cos_beta2_cos_epsilon2 = product_11
    sigma_r_squared = sigma_r**2
    part_01_cos_beta_cos_epsilon2_sin_beta = sigma_r_squared - product_8
    part_02_cos_epsilon_sin_beta_sin_epsilon = sigma_r_squared - product_9
    product_6 = part_00_cos_beta_cos_epsilon2_sin_beta * sin_beta
    del product_11, product_8, product_9, part_00_cos_beta_cos_epsilon2_sin_beta
    sum_1 = cos_beta * part_00_cos_beta2_cos_epsilon2 + product_6
    sin_beta_squared = sin_beta**2
    cos_epsilon_squared = cos_epsilon**2
    sum_2 = cos_beta * sum_1 + sigma_r_squared * sin_beta_squared
    sin_epsilon_squared = sin_epsilon**2
    product_1 = cos_beta * part_01_cos_beta2_cos_epsilon2
    sum_3 = part_01_cos_beta_cos_epsilon2_sin_beta * sin_beta + product_1
    product_2 = part_00_sin_beta2_sin_epsilon2 * sin_epsilon_squared
    sum_4 = cos_epsilon_squared * sum_3 + product_2 * sin_beta
    sum_5 = part_02_cos_epsilon_sin_beta_sin_epsilon * sin_beta + product_1
    del sum_1, part_01_cos_beta_cos_epsilon2_sin_beta, sum_3, product_1
    sum_6 = cos_epsilon_squared * sigma_r_squared + product_2
    sum_7 = cos_beta * sum_6 - cos_epsilon_squared * product_6
    sum_8 = cos_beta * part_02_cos_epsilon_sin_beta_sin_epsilon - part_01_cos_beta2_cos_epsilon2 * sin_beta
    product_3 = cos_epsilon * r
    product_5 = cos_epsilon_squared * sin_beta_squared
    product_4 = cos_epsilon * sin_epsilon
    del product_6, sum_6, part_02_cos_epsilon_sin_beta_sin_epsilon, cos_epsilon
    mean[..., 0] = product_3 * sin_beta
    mean[..., 1] = cos_beta * product_3
    mean[..., 2] = r * sin_epsilon
    covariance[..., 0, 0] = cos_epsilon_squared * sum_2 + product_2 * sin_beta_squared
    del sin_beta, product_3, sin_epsilon, product_2, sin_beta_squared, sum_2
    covariance[..., 0, 1] = cos_beta * sum_4 - part_01_cos_beta2_cos_epsilon2 * product_5
    covariance[..., 0, 2] = product_4 * sum_5
    covariance[..., 1, 0] = covariance[..., 0, 1]
    covariance[..., 1, 1] = cos_beta * sum_7 + part_00_cos_beta2_cos_epsilon2 * product_5
    del part_01_cos_beta2_cos_epsilon2, sum_4, sum_5, cos_beta, part_00_cos_beta2_cos_epsilon2, product_5, sum_7
    covariance[..., 1, 2] = product_4 * sum_8
    covariance[..., 2, 0] = covariance[..., 0, 2]
    covariance[..., 2, 1] = covariance[..., 1, 2]
    covariance[..., 2, 2] = (
        cos_epsilon_squared * part_00_sin_beta2_sin_epsilon2
        + sigma_r_squared * sin_epsilon_squared
    )
    del product_4, sum_8, cos_epsilon_squared, part_00_sin_beta2_sin_epsilon2, sigma_r_squared, sin_epsilon_squared


def spherical_second_order(
    r: Floats,
    beta: Floats,
    epsilon: Floats,
    sigma_r: Floats,
    sigma_beta: Floats,
    sigma_epsilon: Floats,
    rho: Floats,
    mean: Filled,
    covariance: Filled,
) -> None:
    """Conversion spherical, second_order.

    Mean: map from the measured quantities to coordinates less the bias of the plain conversion to second
    order. Covariance: covariance of the conversion's quadratic Taylor polynomial.
    """
    cos_beta = np.cos(beta)
    sin_beta = np.sin(beta)
    cos_epsilon = np.cos(epsilon)
    sin_epsilon = np.sin(epsilon)
    product_3 = rho * sigma_beta
    product_4 = product_3 * sigma_r
    part_0_cos_beta_cos_epsilon = product_4
    sigma_beta_squared = sigma_beta**2
    sigma_epsilon_squared = sigma_epsilon**2
    sum_1 = 0.5 * sigma_beta_squared + 0.5 * sigma_epsilon_squared
    part_0_cos_epsilon_sin_beta = -r * sum_1
    r_squared = r**2
    sigma_r_squared = sigma_r**2
    product_1 = (1.0 + rho**2) * sigma_r_squared
    part_00_cos_beta2_cos_epsilon2 = (product_1 + r_squared) * sigma_beta_squared
    part_00_cos_beta2_sin_epsilon2 = r_squared * sigma_beta_squared * sigma_epsilon_squared
    product_5 = product_4 * r
    part_00_cos_beta_cos_epsilon2_sin_beta = (2.0 - 2.0 * sigma_beta_squared) * product_5
    product_7 = product_5 * sigma_epsilon_squared
    part_00_cos_beta_sin_beta_sin_epsilon2 = 2.0 * product_7
    sigma_epsilon_squared_squared = sigma_epsilon_squared**2
    sum_2 = 0.5 * sigma_beta_squared**2 + 0.5 * sigma_epsilon_squared_squared
    part_00_cos_epsilon2_sin_beta2 = r_squared * sum_2 + sigma_r_squared
    del product_3, sum_1, product_4, sum_2
    part_00_sin_beta2_sin_epsilon2 = (r_squared + sigma_r_squared) * sigma_epsilon_squared
    sum_3 = 1.0 - sigma_beta_squared
    part_01_cos_beta2_cos_epsilon2 = product_5 * sum_3
    part_01_cos_beta2_sin_epsilon2 = product_7
    sum_4 = product_1 + (1.0 - 0.5 * sigma_beta_squared) * r_squared
    product_2 = 0.5 * r_squared * sigma_epsilon_squared_squared
    part_01_cos_beta_cos_epsilon2_sin_beta = product_2 - sigma_beta_squared * sum_4 + sigma_r_squared
    del product_7, product_1, sigma_epsilon_squared_squared, sigma_beta_squared, sum_4
    sum_5 = r_squared * sum_3 + sigma_r_squared
    part_01_cos_beta_sin_beta_sin_epsilon2 = sigma_epsilon_squared * sum_5
    part_02_cos_beta_cos_epsilon_sin_epsilon = (1.0 - sigma_epsilon_squared) * product_5
    sum_6 = 1.0 - 0.5 * sigma_epsilon_squared
    sum_7 = r_squared * sum_6 + sigma_r_squared
    del sum_3, sum_5, product_5, r_squared, sum_6
    part_02_cos_epsilon_sin_beta_sin_epsilon = sigma_r_squared - sigma_epsilon_squared * sum_7
    part_22_sin_epsilon2 = product_2 + sigma_r_squared
    sum_8 = part_0_cos_epsilon_sin_beta - r
    del sum_7, product_2, sigma_r_squared, part_0_cos_epsilon_sin_beta
    sum_9 = cos_beta * part_0_cos_beta_cos_epsilon + sin_beta * sum_8
    sum_10 = cos_beta * sum_8 - part_0_cos_beta_cos_epsilon * sin_beta
    sum_11 = 1.0 + 0.5 * sigma_epsilon_squared
    cos_epsilon_squared = cos_epsilon**2
    sin_epsilon_squared = sin_epsilon**2
    sum_12 = (
        cos_epsilon_squared * part_00_cos_beta2_cos_epsilon2
        + part_00_cos_beta2_sin_epsilon2 * sin_epsilon_squared
    )
    del part_0_cos_beta_cos_epsilon, sum_8, sigma_epsilon_squared, part_00_cos_beta2_cos_epsilon2, part_00_cos_beta2_sin_epsilon2
    sum_13 = (
        cos_epsilon_squared * part_00_cos_beta_cos_epsilon2_sin_beta
        + part_00_cos_beta_sin_beta_sin_epsilon2 * sin_epsilon_squared
    )
    product_8 = sin_beta * sum_13
    sum_14 = cos_beta * sum_12 + product_8
    sum_15 = (
        cos_epsilon_squared * part_00_cos_epsilon2_sin_beta2
        + part_00_sin_beta2_sin_epsilon2 * sin_epsilon_squared
    )
    del part_00_cos_beta_cos_epsilon2_sin_beta, part_00_cos_beta_sin_beta_sin_epsilon2, sum_13, part_00_cos_epsilon2_sin_beta2
    sin_beta_squared = sin_beta**2
    sum_16 = (
        cos_epsilon_squared * part_01_cos_beta2_cos_epsilon2
        + part_01_cos_beta2_sin_epsilon2 * sin_epsilon_squared
    )
    sum_17 = (
        cos_epsilon_squared * part_01_cos_beta_cos_epsilon2_sin_beta
        + part_01_cos_beta_sin_beta_sin_epsilon2 * sin_epsilon_squared
    )
    del part_01_cos_beta2_cos_epsilon2, part_01_cos_beta2_sin_epsilon2, part_01_cos_beta_cos_epsilon2_sin_beta, part_01_cos_beta_sin_beta_sin_epsilon2
    sum_18 = cos_beta * sum_16 + sin_beta * sum_17
    sum_19 = (
        cos_beta * part_02_cos_beta_cos_epsilon_sin_epsilon
        + part_02_cos_epsilon_sin_beta_sin_epsilon * sin_beta
    )
    sum_20 = cos_beta * sum_15 - product_8
    sum_21 = (
        cos_beta * part_02_cos_epsilon_sin_beta_sin_epsilon
        - part_02_cos_beta_cos_epsilon_sin_epsilon * sin_beta
    )
    del sum_17, product_8, part_02_cos_beta_cos_epsilon_sin_epsilon, part_02_cos_epsilon_sin_beta_sin_epsilon, sin_beta
    product_6 = cos_epsilon * sin_epsilon
    mean[..., 0] = -cos_epsilon * sum_9
    mean[..., 1] = -cos_epsilon * sum_10
    mean[..., 2] = r * sin_epsilon * sum_11
    del sum_9, cos_epsilon, sum_10, sin_epsilon, sum_11
    covariance[..., 0, 0] = cos_beta * sum_14 + sin_beta_squared * sum_15
    covariance[..., 0, 1] = cos_beta * sum_18 - sin_beta_squared * sum_16
    del sum_14, sum_15, sum_16, sum_18
    covariance[..., 0, 2] = product_6 * sum_19
    covariance[..., 1, 0] = covariance[..., 0, 1]
    covariance[..., 1, 1] = cos_beta * sum_20 + sin_beta_squared * sum_12
    del sum_19, cos_beta, sin_beta_squared, sum_12, sum_20
    covariance[..., 1, 2] = product_6 * sum_21
    covariance[..., 2, 0] = covariance[..., 0, 2]
    covariance[..., 2, 1] = covariance[..., 1, 2]
    covariance[..., 2, 2] = (
        cos_epsilon_squared * part_00_sin_beta2_sin_epsilon2
        + part_22_sin_epsilon2 * sin_epsilon_squared
    )
    del product_6, sum_21, cos_epsilon_squared, part_00_sin_beta2_sin_epsilon2, part_22_sin_epsilon2, sin_epsilon_squared


def spherical_averaged(
    r: Floats,
    beta: Floats,
    epsilon: Floats,
    sigma_r: Floats,
    sigma_beta: Floats,
    sigma_epsilon: Floats,
    rho: Floats,
    mean: Filled,
    covariance: Filled,
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
    term_1 = np.expm1(-0.5 * sigma_beta_squared)
    shortfall_beta = -term_1
    sigma_epsilon_squared = sigma_epsilon**2
    attenuation_epsilon = np.exp(-0.5 * sigma_epsilon_squared)
    term_2 = np.expm1(-0.5 * sigma_epsilon_squared)
    shortfall_epsilon = -term_2
    sum_1 = (1.0 - shortfall_epsilon) * shortfall_beta + shortfall_epsilon
    product_16 = attenuation_beta * attenuation_epsilon
    part_0_cos_epsilon_sin_beta = -product_16 * r * sum_1
    attenuation_beta_2 = np.exp(-sigma_beta_squared)
    attenuation_beta_less_one = term_1
    sum_2 = 2.0 + attenuation_beta_less_one
    shortfall_beta_2 = -attenuation_beta_less_one * sum_2
    del sum_1, term_1, attenuation_beta_less_one, sum_2
    attenuation_epsilon_2 = np.exp(-sigma_epsilon_squared)
    attenuation_epsilon_less_one = term_2
    sum_3 = 2.0 + attenuation_epsilon_less_one
    shortfall_epsilon_2 = -attenuation_epsilon_less_one * sum_3
    del sigma_epsilon_squared, term_2, attenuation_epsilon_less_one, sum_3
    attenuation_beta_2_squared = attenuation_beta_2**2
    product_1 = attenuation_beta_2 * attenuation_beta_2_squared
    shortfall_epsilon_2_squared = shortfall_epsilon_2**2
    shortfall_epsilon_2_squared_squared = shortfall_epsilon_2_squared**2
    product_2 = 16.0 * product_1 * shortfall_epsilon_2_squared_squared
    sum_4 = 2.0 * attenuation_epsilon_2 + 4.0 * shortfall_epsilon_2
    sum_5 = 3.0 * shortfall_epsilon_2_squared + attenuation_epsilon_2 * sum_4
    product_3 = shortfall_epsilon_2 * shortfall_epsilon_2_squared
    sum_6 = attenuation_epsilon_2 * sum_5 + product_3
    shortfall_beta_2_squared = shortfall_beta_2**2
    product_4 = shortfall_beta_2 * shortfall_beta_2_squared
    sum_7 = 12.0 * shortfall_epsilon_2 + 6.0 * attenuation_epsilon_2
    sum_8 = 9.0 * shortfall_epsilon_2_squared + attenuation_epsilon_2 * sum_7
    sum_9 = 24.0 * attenuation_epsilon_2 + 48.0 * shortfall_epsilon_2
    sum_10 = 12.0 * attenuation_epsilon_2 + 24.0 * shortfall_epsilon_2
    sum_11 = attenuation_beta_2 * sum_10 - shortfall_beta_2 * sum_9
    sum_12 = 66.0 * attenuation_beta_2 - 36.0 * shortfall_beta_2
    sum_13 = attenuation_epsilon_2 * sum_11 + shortfall_epsilon_2_squared * sum_12
    del sum_5, sum_9, sum_11, sum_12
    product_27 = shortfall_beta_2_squared * sum_8
    sum_14 = attenuation_beta_2 * sum_13 - product_27
    sum_15 = 54.0 * attenuation_beta_2 - 12.0 * shortfall_beta_2
    sum_16 = attenuation_beta_2 * sum_15 - 3.0 * shortfall_beta_2_squared
    sum_17 = attenuation_epsilon_2 * sum_14 + product_3 * sum_16
    del sum_8, sum_13, sum_15, sum_14, sum_16
    product_25 = product_4 * sum_6
    sum_18 = attenuation_beta_2 * sum_17 - product_25
    rho_squared = rho**2
    sigma_r_squared = sigma_r**2
    sum_19 = attenuation_epsilon_2 * sum_18 + product_2
    sum_20 = 1.0 + attenuation_beta_2
    attenuation_epsilon_2_squared = attenuation_epsilon_2**2
    product_17 = attenuation_beta_2 * attenuation_epsilon_2
    sum_21 = 1.0 - product_17
    sum_22 = 1.0 + attenuation_epsilon_2_squared * sum_21
    del sum_6, sum_17, sum_18, sum_21
    sum_23 = attenuation_beta_2 - attenuation_epsilon_2 * sum_22
    attenuation_epsilon_2_squared_squared = attenuation_epsilon_2_squared**2
    r_squared = r**2
    sum_24 = 1.0 + attenuation_beta_2 * sum_23 + attenuation_epsilon_2_squared_squared
    sum_25 = 1.0 - 2.0 * product_17
    sum_26 = 1.0 + attenuation_epsilon_2_squared * sum_25
    sum_27 = 2.0 * attenuation_beta_2 - attenuation_epsilon_2 * sum_26
    del sum_22, sum_23, sum_25, sum_26
    sum_28 = 2.0 + 2.0 * attenuation_epsilon_2_squared_squared + attenuation_beta_2 * sum_27
    sum_29 = 0.25 * r_squared * sum_24 + 0.25 * sigma_r_squared * sum_28
    product_26 = shortfall_beta_2 * sum_20
    del sum_27, sum_24, sum_28, sum_20
    product_11 = rho_squared * sigma_beta_squared
    product_14 = attenuation_beta_2 * product_11
    product_30 = product_14 * sigma_r_squared
    part_00_cos_beta2_cos_epsilon2 = product_26 * sum_29 + 0.25 * product_30 * sum_19
    del rho_squared, sigma_beta_squared, sum_19, sum_29
    sum_30 = attenuation_epsilon_2 + shortfall_epsilon_2
    sum_31 = 3.0 * attenuation_epsilon_2 + 3.0 * shortfall_epsilon_2
    sum_32 = 12.0 * attenuation_epsilon_2 + 12.0 * shortfall_epsilon_2
    sum_33 = 22.0 * attenuation_epsilon_2 + 22.0 * shortfall_epsilon_2
    sum_34 = attenuation_beta_2 * sum_33 - shortfall_beta_2 * sum_32
    sum_35 = attenuation_beta_2 * sum_34 - shortfall_beta_2_squared * sum_31
    sum_36 = attenuation_beta_2 * sum_35 - product_4 * sum_30
    del sum_32, sum_33, sum_34, product_4, sum_30, sum_35
    product_23 = product_1 * shortfall_epsilon_2_squared
    sum_37 = 16.0 * product_23 + attenuation_epsilon_2 * sum_36
    sum_38 = 1.0 + attenuation_epsilon_2_squared
    sum_39 = attenuation_beta_2 * sum_38 - attenuation_epsilon_2
    sum_40 = 1.0 + attenuation_beta_2 * sum_39 + attenuation_epsilon_2_squared
    sum_41 = 2.0 + 2.0 * attenuation_epsilon_2_squared
    sum_42 = attenuation_beta_2 * sum_41 - attenuation_epsilon_2
    sum_43 = 2.0 + 2.0 * attenuation_epsilon_2_squared + attenuation_beta_2 * sum_42
    sum_44 = 0.25 * r_squared * sum_40 + 0.25 * sigma_r_squared * sum_43
    del sum_36, sum_38, sum_41, sum_40, sum_43
    sum_45 = 1.0 + attenuation_epsilon_2
    sum_46 = product_26 * sum_44 + 0.25 * product_30 * sum_37
    del product_26, product_30, sum_37, sum_44
    product_29 = shortfall_epsilon_2 * sum_45
    part_00_cos_beta2_sin_epsilon2 = product_29 * sum_46
    sum_47 = 1.5 * attenuation_epsilon_2 + 1.5 * shortfall_epsilon_2
    sum_48 = attenuation_epsilon_2 * sum_47 + 0.5 * shortfall_epsilon_2_squared
    sum_49 = attenuation_epsilon_2 * sum_31 + shortfall_epsilon_2_squared
    sum_50 = 1.5 * attenuation_epsilon_2 + 3.0 * shortfall_epsilon_2
    sum_51 = attenuation_beta_2 * sum_50 + shortfall_beta_2 * sum_50
    sum_52 = 5.25 * shortfall_beta_2 + 6.75 * attenuation_beta_2
    sum_53 = attenuation_epsilon_2 * sum_51 + shortfall_epsilon_2_squared * sum_52
    del sum_46, sum_47, sum_50, sum_51, sum_52
    sum_54 = 0.5 * attenuation_epsilon_2 + shortfall_epsilon_2
    sum_55 = 1.5 * shortfall_epsilon_2_squared + attenuation_epsilon_2 * sum_54
    sum_56 = attenuation_beta_2 * sum_53 + shortfall_beta_2_squared * sum_55
    sum_57 = 3.75 * shortfall_beta_2 + 5.25 * attenuation_beta_2
    sum_58 = attenuation_beta_2 * sum_57 + shortfall_beta_2_squared
    del sum_54, sum_53, sum_55, sum_57
    sum_59 = attenuation_epsilon_2 * sum_56 + product_3 * sum_58
    sum_60 = 1.5 * attenuation_beta_2 + shortfall_beta_2
    sum_61 = attenuation_beta_2 * sum_60 + 0.25 * shortfall_beta_2_squared
    sum_62 = attenuation_epsilon_2 * sum_59 + shortfall_epsilon_2_squared_squared * sum_61
    del sum_56, sum_58, sum_60, sum_59, sum_61
    sum_63 = product_23 * sum_49 + shortfall_beta_2 * sum_62
    sum_64 = attenuation_beta_2_squared**2 * shortfall_epsilon_2_squared * sum_48 + shortfall_beta_2 * sum_63
    del product_23, sum_49, sum_62, sum_48, sum_63
    sum_65 = 16.0 * attenuation_epsilon_2 + 32.0 * shortfall_epsilon_2
    sum_66 = attenuation_beta_2 * sum_65 - shortfall_beta_2 * sum_10
    sum_67 = 72.0 * attenuation_beta_2 - 18.0 * shortfall_beta_2
    sum_68 = attenuation_epsilon_2 * sum_66 + shortfall_epsilon_2_squared * sum_67
    del sum_10, sum_65, sum_66, sum_67
    sum_69 = attenuation_beta_2 * sum_68 + product_27
    sum_70 = 56.0 * attenuation_beta_2 - 6.0 * shortfall_beta_2
    sum_71 = 3.0 * shortfall_beta_2_squared + attenuation_beta_2 * sum_70
    del product_27, sum_68, shortfall_beta_2_squared, sum_70
    sum_72 = attenuation_epsilon_2 * sum_69 + product_3 * sum_71
    sum_73 = attenuation_beta_2 * sum_72 + product_25
    del sum_69, sum_71, product_25, sum_72
    sum_74 = attenuation_epsilon_2 * sum_73 + product_2
    sum_75 = 0.25 - 0.5 * product_17
    sum_76 = 0.25 + attenuation_epsilon_2_squared * sum_75
    del product_2, sum_73, product_17, sum_75
    sum_77 = 0.25 + attenuation_beta_2_squared * sum_76 + 0.25 * attenuation_epsilon_2_squared
    sum_78 = 0.5 * product_1 - attenuation_epsilon_2 * sum_77
    sum_79 = (
        0.5
        - 0.25 * product_14 * sum_74
        + attenuation_beta_2 * sum_78
        + 0.5 * attenuation_epsilon_2_squared_squared
    )
    del sum_76, sum_77, attenuation_epsilon_2_squared_squared, sum_74, sum_78
    part_00_cos_epsilon2_sin_beta2 = r_squared * sum_64 + sigma_r_squared * sum_79
    sum_80 = attenuation_beta_2_squared * sum_39 - attenuation_epsilon_2
    sum_81 = 1.0 + attenuation_beta_2 * sum_80 + attenuation_epsilon_2_squared
    del sum_64, sum_79, sum_39, sum_80
    sum_82 = 16.0 + 16.0 * attenuation_epsilon_2_squared
    sum_83 = attenuation_beta_2 * sum_82 - 9.0 * attenuation_epsilon_2
    sum_84 = attenuation_beta_2_squared * sum_83 + attenuation_epsilon_2
    sum_85 = attenuation_beta_2_squared * sum_42 - attenuation_epsilon_2
    del sum_82, sum_83, attenuation_beta_2_squared, sum_42
    sum_86 = (
        0.5
        - 0.25 * product_14 * sum_84
        + 0.25 * attenuation_beta_2 * sum_85
        + 0.5 * attenuation_epsilon_2_squared
    )
    sum_87 = 0.25 * r_squared * sum_81 + sigma_r_squared * sum_86
    del product_14, sum_84, sum_85, sum_81, sum_86
    part_00_sin_beta2_sin_epsilon2 = product_29 * sum_87
    product_5 = attenuation_epsilon_2 * attenuation_epsilon_2_squared
    sum_88 = 3.0 * attenuation_epsilon_2 + shortfall_epsilon_2
    sum_89 = attenuation_beta_2 * sum_31 - shortfall_beta_2 * sum_88
    del product_29, sum_87, sum_31, sum_88
    sum_90 = 4.0 * attenuation_epsilon_2_squared * shortfall_beta_2 - shortfall_epsilon_2 * sum_89
    sum_91 = 2.0 * product_5 * shortfall_beta_2 + shortfall_epsilon_2 * sum_90
    product_20 = attenuation_beta_2 * shortfall_epsilon_2_squared_squared
    product_6 = product_20
    sum_92 = product_6 - attenuation_epsilon_2 * sum_91
    del sum_89, sum_90, shortfall_epsilon_2_squared_squared, sum_91
    sum_93 = 18.0 * attenuation_epsilon_2 + 36.0 * shortfall_epsilon_2
    sum_94 = 14.0 * attenuation_epsilon_2 + 28.0 * shortfall_epsilon_2
    sum_95 = attenuation_beta_2 * sum_94 - shortfall_beta_2 * sum_93
    sum_96 = 69.0 * attenuation_beta_2 - 27.0 * shortfall_beta_2
    sum_97 = attenuation_epsilon_2 * sum_95 + shortfall_epsilon_2_squared * sum_96
    del sum_93, sum_94, sum_95, sum_96
    sum_98 = 55.0 * attenuation_beta_2 - 9.0 * shortfall_beta_2
    sum_99 = attenuation_epsilon_2 * sum_97 + product_3 * sum_98
    sum_100 = 16.0 * product_20 + attenuation_epsilon_2 * sum_99
    product_7 = attenuation_beta_2 * sum_4
    sum_101 = product_7 - shortfall_beta_2 * sum_4
    sum_102 = 9.0 * attenuation_beta_2 - 3.0 * shortfall_beta_2
    sum_103 = attenuation_epsilon_2 * sum_101 + shortfall_epsilon_2_squared * sum_102
    del sum_97, sum_99, sum_4, sum_101, sum_102
    sum_104 = 7.0 * attenuation_beta_2 - shortfall_beta_2
    sum_105 = attenuation_epsilon_2 * sum_103 + product_3 * sum_104
    sum_106 = 0.5 * attenuation_epsilon_2 * sum_105 - 0.5 * product_11 * sum_100 + product_6
    del sum_103, product_6, sum_100, sum_105
    sum_107 = 0.5 * r_squared * sum_92 + sigma_r_squared * sum_106
    part_01_cos_beta_cos_epsilon2_sin_beta = product_1 * sum_107
    product_18 = attenuation_beta_2 * product_3
    product_8 = product_18
    sum_108 = 2.0 * attenuation_epsilon_2 + 3.0 * shortfall_epsilon_2
    product_9 = -shortfall_beta_2 * sum_108
    sum_109 = attenuation_beta_2 * sum_108 + product_9
    del sum_106, sum_92, sum_107, sum_108
    sum_110 = 3.0 * attenuation_beta_2 - shortfall_beta_2
    sum_111 = attenuation_epsilon_2 * sum_109 + shortfall_epsilon_2_squared * sum_110
    sum_112 = attenuation_epsilon_2 * sum_111 + product_8
    sum_113 = 18.0 * attenuation_epsilon_2 + 27.0 * shortfall_epsilon_2
    sum_114 = 46.0 * attenuation_epsilon_2 + 69.0 * shortfall_epsilon_2
    sum_115 = attenuation_beta_2 * sum_114 - shortfall_beta_2 * sum_113
    del sum_109, sum_110, sum_111, sum_113, sum_114
    sum_116 = attenuation_epsilon_2 * sum_115 + shortfall_epsilon_2_squared * sum_98
    sum_117 = 16.0 * product_18 + attenuation_epsilon_2 * sum_116
    sum_118 = 6.0 * attenuation_epsilon_2 + 9.0 * shortfall_epsilon_2
    sum_119 = attenuation_beta_2 * sum_118 + product_9
    del sum_115, sum_98, sum_116, product_9
    sum_120 = attenuation_epsilon_2 * sum_119 + shortfall_epsilon_2_squared * sum_104
    sum_121 = 0.5 * attenuation_epsilon_2 * sum_120 - 0.5 * product_11 * sum_117 + product_8
    del sum_104, sum_119, product_8, sum_117, sum_120
    sum_122 = 0.5 * r_squared * sum_112 + sigma_r_squared * sum_121
    part_01_cos_beta_sin_beta_sin_epsilon2 = product_1 * shortfall_epsilon_2 * sum_122
    sum_123 = 1.0 - 2.0 * product_11
    del sum_112, sum_121, sum_122, product_11
    sum_124 = attenuation_epsilon_2 - shortfall_epsilon_2
    sum_125 = r_squared * shortfall_epsilon_2 - sigma_r_squared * sum_123 * sum_124
    product_19 = attenuation_beta_2 * product_5
    part_02_cos_epsilon_sin_beta_sin_epsilon = -product_19 * sum_125
    sum_126 = 1.0 + 2.0 * attenuation_epsilon_2
    sum_127 = 1.0 + attenuation_epsilon_2 * sum_126
    del sum_123, sum_124, sum_125, sum_126
    sum_128 = 2.0 + attenuation_epsilon_2 * sum_127
    sum_129 = 0.5 * (1.0 + product_5) * r_squared + 0.5 * sigma_r_squared * sum_128
    part_22_cos_epsilon2 = shortfall_epsilon_2 * sum_129
    del sum_127, product_5, sum_128, sum_129
    sum_130 = 1.0 + attenuation_epsilon_2 * sum_45
    sum_131 = 0.5 + (0.5 - attenuation_epsilon_2) * attenuation_epsilon_2_squared
    sum_132 = 1.0 - attenuation_epsilon_2 * sum_131
    part_22_sin_epsilon2 = 0.5 * r_squared * shortfall_epsilon_2_squared * sum_130 + sigma_r_squared * sum_132
    del sum_45, attenuation_epsilon_2_squared, sum_131, r_squared, sigma_r_squared, sum_130, sum_132
    sum_133 = attenuation_epsilon + shortfall_epsilon
    sum_134 = attenuation_epsilon - shortfall_epsilon
    sum_135 = attenuation_beta * sum_134 - shortfall_beta * sum_133
    del attenuation_beta, shortfall_beta, sum_133, sum_134
    sum_136 = part_0_cos_epsilon_sin_beta - r
    product_12 = rho * sigma_beta
    product_13 = product_12 * sigma_r
    product_31 = product_13 * sum_135
    product_34 = product_16 * product_31
    del part_0_cos_epsilon_sin_beta, product_12, sum_135, product_16, product_31
    sum_137 = cos_beta * product_34 + sin_beta * sum_136
    sum_138 = product_34 * sin_beta - cos_beta * sum_136
    sum_139 = 1.0 + attenuation_epsilon * shortfall_epsilon
    del product_34, sum_136, attenuation_epsilon, shortfall_epsilon
    sum_140 = product_7 - shortfall_beta_2 * sum_7
    sum_141 = 15.0 * attenuation_beta_2 - 9.0 * shortfall_beta_2
    sum_142 = attenuation_epsilon_2 * sum_140 + shortfall_epsilon_2_squared * sum_141
    del product_7, sum_7, sum_140, sum_141
    sum_143 = 13.0 * attenuation_beta_2 - 3.0 * shortfall_beta_2
    sum_144 = attenuation_epsilon_2 * sum_142 + product_3 * sum_143
    sum_145 = 4.0 * product_20 + attenuation_epsilon_2 * sum_144
    del product_3, sum_142, product_20, sum_144
    cos_epsilon_squared = cos_epsilon**2
    sum_146 = 10.0 * attenuation_epsilon_2 + 15.0 * shortfall_epsilon_2
    sum_147 = attenuation_beta_2 * sum_146 - shortfall_beta_2 * sum_118
    del attenuation_beta_2, shortfall_beta_2, sum_118, sum_146
    sum_148 = attenuation_epsilon_2 * sum_147 + shortfall_epsilon_2_squared * sum_143
    sum_149 = 4.0 * product_18 + attenuation_epsilon_2 * sum_148
    del shortfall_epsilon_2_squared, sum_143, sum_147, product_18, sum_148
    sin_epsilon_squared = sin_epsilon**2
    product_22 = cos_epsilon_squared * sum_145
    product_28 = shortfall_epsilon_2 * sin_epsilon_squared
    product_32 = product_28 * sum_149
    sum_150 = product_22 + product_32
    product_15 = product_13 * r
    del sum_145, product_28, sum_149, product_13
    product_24 = product_1 * product_15
    product_10 = product_24 * sin_beta * sum_150
    sum_151 = (
        cos_epsilon_squared * part_00_cos_beta2_cos_epsilon2
        + part_00_cos_beta2_sin_epsilon2 * sin_epsilon_squared
    )
    del product_1, sum_150, part_00_cos_beta2_cos_epsilon2, part_00_cos_beta2_sin_epsilon2
    sum_152 = cos_beta * sum_151 + product_10
    sum_153 = (
        cos_epsilon_squared * part_00_cos_epsilon2_sin_beta2
        + part_00_sin_beta2_sin_epsilon2 * sin_epsilon_squared
    )
    sin_beta_squared = sin_beta**2
    sum_154 = 0.5 * cos_beta**2 - 0.5 * sin_beta_squared
    sum_155 = product_22 * sum_154 + product_32 * sum_154
    del part_00_cos_epsilon2_sin_beta2, part_00_sin_beta2_sin_epsilon2, product_22, product_32, sum_154
    sum_156 = (
        cos_epsilon_squared * part_01_cos_beta_cos_epsilon2_sin_beta
        + part_01_cos_beta_sin_beta_sin_epsilon2 * sin_epsilon_squared
    )
    sum_157 = attenuation_epsilon_2 - 3.0 * shortfall_epsilon_2
    del part_01_cos_beta_cos_epsilon2_sin_beta, part_01_cos_beta_sin_beta_sin_epsilon2, attenuation_epsilon_2, shortfall_epsilon_2
    product_33 = product_15 * sum_157
    product_35 = product_19 * product_33
    del product_15, sum_157, product_19, product_33
    sum_158 = cos_beta * product_35 + part_02_cos_epsilon_sin_beta_sin_epsilon * sin_beta
    sum_159 = product_10 - cos_beta * sum_153
    sum_160 = product_35 * sin_beta - cos_beta * part_02_cos_epsilon_sin_beta_sin_epsilon
    product_21 = cos_epsilon * sin_epsilon
    mean[..., 0] = -cos_epsilon * sum_137
    del product_10, part_02_cos_epsilon_sin_beta_sin_epsilon, product_35, sum_137
    mean[..., 1] = cos_epsilon * sum_138
    mean[..., 2] = r * sin_epsilon * sum_139
    del cos_epsilon, sum_138, sin_epsilon, sum_139
    covariance[..., 0, 0] = cos_beta * sum_152 + sin_beta_squared * sum_153
    covariance[..., 0, 1] = cos_beta * sin_beta * sum_156 + product_24 * sum_155
    del sum_152, sum_153, product_24, sin_beta, sum_155, sum_156
    covariance[..., 0, 2] = product_21 * sum_158
    covariance[..., 1, 0] = covariance[..., 0, 1]
    covariance[..., 1, 1] = sin_beta_squared * sum_151 - cos_beta * sum_159
    del sum_158, cos_beta, sin_beta_squared, sum_151, sum_159
    covariance[..., 1, 2] = -product_21 * sum_160
    covariance[..., 2, 0] = covariance[..., 0, 2]
    covariance[..., 2, 1] = covariance[..., 1, 2]
    covariance[..., 2, 2] = (
        cos_epsilon_squared * part_22_cos_epsilon2
        + part_22_sin_epsilon2 * sin_epsilon_squared
    )
    del product_21, sum_160, cos_epsilon_squared, part_22_cos_epsilon2, part_22_sin_epsilon2, sin_epsilon_squared


def spherical_unbiased(
    r: Floats,
    beta: Floats,
    epsilon: Floats,
    sigma_r: Floats,
    sigma_beta: Floats,
    sigma_epsilon: Floats,
    rho: Floats,
    mean: Filled,
    covariance: Filled,
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
    attenuation_epsilon = np.exp(-0.5 * sigma_epsilon**2)
    term_1 = 1.0 / attenuation_beta
    term_2 = 1.0 / attenuation_epsilon
    product_4 = rho * sigma_beta
    product_7 = product_4 * sigma_r
    part_0_cos_beta_cos_epsilon = -product_7 * term_1 * term_2
    product_23 = r * term_2
    part_0_cos_epsilon_sin_beta = product_23 * term_1
    shortfall_beta = -np.expm1(-0.5 * sigma_beta_squared)
    attenuation_epsilon_2 = attenuation_epsilon**2
    attenuation_epsilon_less_one = np.expm1(-0.5 * sigma_epsilon**2)
    sum_1 = 2.0 + attenuation_epsilon_less_one
    shortfall_epsilon = -attenuation_epsilon_less_one * sum_1
    del product_4, term_2, attenuation_epsilon, attenuation_epsilon_less_one, sum_1
    term_3 = 1.0 / attenuation_epsilon_2
    term_4 = 1.0 / attenuation_beta**2
    attenuation_beta_squared = attenuation_beta**2
    attenuation_beta_squared_squared = attenuation_beta_squared**2
    attenuation_epsilon_2_squared = attenuation_epsilon_2**2
    sum_2 = 1.0 + attenuation_epsilon_2_squared
    product_13 = attenuation_beta_squared_squared * sum_2
    sum_3 = 2.0 + product_13
    rho_squared = rho**2
    sigma_r_squared = sigma_r**2
    product_9 = attenuation_beta_squared * attenuation_epsilon_2
    sum_4 = 1.0 + product_9 * sum_3
    sum_5 = 1.0 + attenuation_beta
    sum_6 = 1.0 + attenuation_beta_squared
    r_squared = r**2
    sum_7 = 0.25 * r_squared + 0.25 * sigma_r_squared
    product_6 = shortfall_beta * sum_5
    product_28 = sum_6 * sum_7
    product_30 = product_28 * product_6
    del sum_3, sum_5, sum_6, product_28
    product_5 = rho_squared * sigma_beta_squared
    product_16 = product_5 * sigma_r_squared
    product_29 = term_3 * term_4
    part_00_cos_beta2_cos_epsilon2 = product_16 * product_29 * sum_4 + product_30 * sum_2
    sum_8 = 1.0 + attenuation_epsilon_2
    sum_9 = attenuation_beta_squared_squared * product_16 + product_30
    del rho_squared, sigma_beta_squared, sum_4, product_30
    product_24 = shortfall_epsilon * sum_8
    part_00_cos_beta2_sin_epsilon2 = product_24 * sum_9
    sum_10 = 1.0 + attenuation_beta_squared * sum_8 + attenuation_epsilon_2
    product_1 = product_9 * sum_10
    product_11 = shortfall_epsilon * term_3
    sum_11 = 0.25 * (4.0 + product_1) * product_11 + 0.5 * (2.0 + attenuation_beta_squared) * product_6
    sum_12 = 2.0 + attenuation_epsilon_2
    shortfall_epsilon_squared = shortfall_epsilon**2
    product_15 = shortfall_epsilon_squared * sum_12
    product_18 = product_15 * term_3
    del sum_9, sum_10, sum_12, product_15
    product_12 = product_6 * term_4
    sum_13 = product_12 * sum_11 + 0.5 * product_18
    sum_14 = 0.25 + 0.25 * attenuation_epsilon_2_squared
    sum_15 = (
        0.25
        - product_13 * product_5
        + attenuation_beta_squared_squared * sum_14
        + 0.25 * attenuation_epsilon_2_squared
    )
    del product_6, term_4, sum_11, sum_14
    part_00_cos_epsilon2_sin_beta2 = r_squared * sum_13 + sigma_r_squared * sum_15
    product_10 = attenuation_beta_squared_squared * sum_8
    sum_16 = 1.0 + attenuation_epsilon_2 + product_10
    sum_17 = sum_16 * sum_7 - product_10 * product_16
    del sum_13, sum_15, product_16, sum_16, sum_7
    part_00_sin_beta2_sin_epsilon2 = shortfall_epsilon * sum_17
    shortfall_beta_squared = shortfall_beta**2
    sum_18 = attenuation_beta - 2.0 * shortfall_beta
    sum_19 = attenuation_beta * sum_18 - 5.0 * shortfall_beta_squared
    sum_20 = attenuation_beta * sum_19 - 4.0 * shortfall_beta * shortfall_beta_squared
    sum_21 = attenuation_beta * sum_20 - 0.5 * (2.0 + product_1) * product_11 - shortfall_beta_squared**2
    del sum_17, sum_18, sum_19, product_1, shortfall_beta_squared, sum_20
    sum_22 = product_12 * sum_21 - 0.5 * product_18
    sum_23 = 2.0 + 2.0 * attenuation_epsilon_2_squared
    sum_24 = 2.0 + attenuation_beta_squared_squared * sum_23
    sum_25 = 1.0 + product_9 * sum_24
    del sum_21, attenuation_beta_squared_squared, sum_23, sum_24
    sum_26 = 0.5 * product_13 - product_29 * product_5 * sum_25
    part_01_cos_beta_cos_epsilon2_sin_beta = sigma_r_squared * sum_26 - r_squared * sum_22
    del product_13, product_29, sum_25, sum_22, sum_26
    sum_27 = 0.5 - 2.0 * product_5
    sum_28 = 0.5 * r_squared + sigma_r_squared * sum_27
    product_14 = product_10 * shortfall_epsilon
    part_01_cos_beta_sin_beta_sin_epsilon2 = product_14 * sum_28
    sum_29 = 1.0 + attenuation_beta * attenuation_epsilon_2 * sum_8
    del sum_27, product_10, sum_28, sum_8
    sum_30 = attenuation_epsilon_2 - shortfall_epsilon
    product_2 = attenuation_epsilon_2 * sum_30
    sum_31 = product_2 - shortfall_beta * sum_29 * term_1 - shortfall_epsilon_squared
    sum_32 = 1.0 - product_5
    del sum_30, shortfall_beta, sum_29, product_5
    part_02_cos_epsilon_sin_beta_sin_epsilon = (
        attenuation_beta * attenuation_epsilon_2_squared * sigma_r_squared * sum_32
        - product_11 * r_squared * sum_31
    )
    sum_33 = 0.5 * r_squared + 0.5 * sigma_r_squared
    part_22_cos_epsilon2 = product_24 * sum_33
    del sum_31, sum_32, product_24, sum_33
    sum_34 = 0.5 + 0.5 * attenuation_epsilon_2_squared
    part_22_sin_epsilon2 = 0.5 * product_18 * r_squared + sigma_r_squared * sum_34
    del product_18, r_squared, sigma_r_squared, sum_34
    sum_35 = cos_beta * part_0_cos_beta_cos_epsilon + part_0_cos_epsilon_sin_beta * sin_beta
    sum_36 = cos_beta * part_0_cos_epsilon_sin_beta - part_0_cos_beta_cos_epsilon * sin_beta
    cos_epsilon_squared = cos_epsilon**2
    sin_epsilon_squared = sin_epsilon**2
    sum_37 = (
        cos_epsilon_squared * part_00_cos_beta2_cos_epsilon2
        + part_00_cos_beta2_sin_epsilon2 * sin_epsilon_squared
    )
    del part_0_cos_beta_cos_epsilon, part_0_cos_epsilon_sin_beta, part_00_cos_beta2_cos_epsilon2, part_00_cos_beta2_sin_epsilon2
    sum_38 = 1.0 + attenuation_beta_squared * sum_2 + attenuation_epsilon_2_squared
    sum_39 = 1.0 + product_9 * sum_38
    del attenuation_beta_squared, attenuation_epsilon_2_squared, sum_2, sum_38
    product_3 = shortfall_epsilon * shortfall_epsilon_squared
    sum_40 = product_2 - 2.0 * shortfall_epsilon_squared
    product_19 = attenuation_epsilon_2 * sum_40
    del shortfall_epsilon, product_2, shortfall_epsilon_squared, sum_40
    product_26 = product_12 * sum_39
    sum_41 = 2.0 * product_19 - 2.0 * product_26 - 2.0 * product_3
    product_22 = cos_epsilon_squared * term_3
    product_25 = product_14 * sin_epsilon_squared
    del product_12, sum_39, term_3, product_14
    sum_42 = 2.0 * product_25 + product_22 * sum_41
    product_8 = product_7 * r
    product_17 = product_8 * sin_beta
    product_27 = product_17 * sum_42
    sum_43 = cos_beta * sum_37 + product_27
    sum_44 = (
        cos_epsilon_squared * part_00_cos_epsilon2_sin_beta2
        + part_00_sin_beta2_sin_epsilon2 * sin_epsilon_squared
    )
    del sum_41, product_7, sum_42, part_00_cos_epsilon2_sin_beta2, part_00_sin_beta2_sin_epsilon2
    sin_beta_squared = sin_beta**2
    sum_45 = product_19 - product_26 - product_3
    sum_46 = product_22 * sum_45 + product_25
    del product_19, product_26, product_3, product_22, product_25, sum_45
    sum_47 = (
        cos_epsilon_squared * part_01_cos_beta_cos_epsilon2_sin_beta
        + part_01_cos_beta_sin_beta_sin_epsilon2 * sin_epsilon_squared
    )
    product_20 = cos_beta * product_8
    sum_48 = product_20 * sum_46 + sin_beta * sum_47
    sum_49 = 2.0 + 2.0 * attenuation_epsilon_2
    del part_01_cos_beta_cos_epsilon2_sin_beta, part_01_cos_beta_sin_beta_sin_epsilon2, sum_47, attenuation_epsilon_2
    sum_50 = 1.0 + product_9 * sum_49
    sum_51 = attenuation_beta - product_11 * sum_50 * term_1
    del product_9, sum_49, attenuation_beta, product_11, sum_50, term_1
    sum_52 = part_02_cos_epsilon_sin_beta_sin_epsilon * sin_beta + product_20 * sum_51
    sum_53 = cos_beta * sum_44 - product_27
    sum_54 = cos_beta * part_02_cos_epsilon_sin_beta_sin_epsilon - product_17 * sum_51
    del product_20, sin_beta, product_27, part_02_cos_epsilon_sin_beta_sin_epsilon, product_17, sum_51
    product_21 = cos_epsilon * sin_epsilon
    mean[..., 0] = cos_epsilon * sum_35
    mean[..., 1] = cos_epsilon * sum_36
    mean[..., 2] = product_23 * sin_epsilon
    del sum_35, cos_epsilon, sum_36, product_23, sin_epsilon
    covariance[..., 0, 0] = cos_beta * sum_43 + sin_beta_squared * sum_44
    covariance[..., 0, 1] = cos_beta * sum_48 - product_8 * sin_beta_squared * sum_46
    del sum_43, sum_44, product_8, sum_46, sum_48
    covariance[..., 0, 2] = product_21 * sum_52
    covariance[..., 1, 0] = covariance[..., 0, 1]
    covariance[..., 1, 1] = cos_beta * sum_53 + sin_beta_squared * sum_37
    del sum_52, cos_beta, sin_beta_squared, sum_37, sum_53
    covariance[..., 1, 2] = product_21 * sum_54
    covariance[..., 2, 0] = covariance[..., 0, 2]
    covariance[..., 2, 1] = covariance[..., 1, 2]
    covariance[..., 2, 2] = (
        cos_epsilon_squared * part_22_cos_epsilon2
        + part_22_sin_epsilon2 * sin_epsilon_squared
    )
    del product_21, sum_54, cos_epsilon_squared, part_22_cos_epsilon2, part_22_sin_epsilon2, sin_epsilon_squared


def spherical_posterior(
    r: Floats,
    beta: Floats,
    epsilon: Floats,
    sigma_r: Floats,
    sigma_beta: Floats,
    sigma_epsilon: Floats,
    rho: Floats,
    mean: Filled,
    covariance: Filled,
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
    attenuation_epsilon = np.exp(-0.5 * sigma_epsilon**2)
    product_7 = rho * sigma_beta
    product_9 = product_7 * sigma_r
    product_14 = attenuation_beta * attenuation_epsilon
    part_0_cos_beta_cos_epsilon = product_14 * product_9
    part_0_cos_epsilon_sin_beta = product_14 * r
    shortfall_beta = -np.expm1(-0.5 * sigma_beta_squared)
    attenuation_epsilon_2 = attenuation_epsilon**2
    attenuation_epsilon_less_one = np.expm1(-0.5 * sigma_epsilon**2)
    sum_1 = 2.0 + attenuation_epsilon_less_one
    shortfall_epsilon = -attenuation_epsilon_less_one * sum_1
    del product_7, product_14, attenuation_epsilon_less_one, sum_1
    attenuation_beta_squared = attenuation_beta**2
    shortfall_epsilon_squared = shortfall_epsilon**2
    product_12 = attenuation_beta_squared * shortfall_epsilon_squared
    product_1 = product_12
    sum_2 = attenuation_epsilon_2 + shortfall_epsilon
    shortfall_beta_squared = shortfall_beta**2
    product_2 = -shortfall_beta_squared * sum_2
    sum_3 = 2.0 * attenuation_epsilon_2 + 2.0 * shortfall_epsilon
    product_20 = shortfall_beta * sum_3
    product_3 = -product_20
    sum_4 = attenuation_beta * sum_2 + product_3
    sum_5 = attenuation_beta * sum_4 + product_2
    sum_6 = attenuation_epsilon_2 * sum_5 + product_1
    rho_squared = rho**2
    sigma_r_squared = sigma_r**2
    sum_7 = 1.0 + attenuation_beta
    sum_8 = 1.0 + attenuation_beta_squared
    attenuation_epsilon_2_squared = attenuation_epsilon_2**2
    sum_9 = 1.0 + attenuation_epsilon_2_squared
    r_squared = r**2
    sum_10 = 0.25 * r_squared + 0.25 * sigma_r_squared
    product_6 = rho_squared * sigma_beta_squared
    del sum_2, sum_4, sum_5, rho_squared, sigma_beta_squared
    product_19 = shortfall_beta * sum_10
    product_23 = sum_7 * sum_8
    product_26 = product_19 * product_23
    del sum_7, sum_8, product_19, product_23
    part_00_cos_beta2_cos_epsilon2 = (
        attenuation_beta_squared * product_6 * sigma_r_squared * sum_6
        + product_26 * sum_9
    )
    attenuation_beta_squared_squared = attenuation_beta_squared**2
    sum_11 = 1.0 + attenuation_epsilon_2
    product_13 = attenuation_beta_squared_squared * product_6
    product_21 = product_13 * sigma_r_squared
    sum_12 = product_21 + product_26
    product_8 = shortfall_epsilon * sum_11
    part_00_cos_beta2_sin_epsilon2 = product_8 * sum_12
    product_4 = product_20
    sum_13 = attenuation_beta * sum_3 + product_4
    del product_26, sum_12, product_20, sum_3
    sum_14 = 1.5 * attenuation_beta + shortfall_beta
    sum_15 = attenuation_epsilon_2 * sum_13 + shortfall_epsilon_squared * sum_14
    sum_16 = 0.5 * attenuation_epsilon_2 + 0.5 * shortfall_epsilon
    sum_17 = attenuation_epsilon_2 * sum_16 + 0.25 * shortfall_epsilon_squared
    sum_18 = attenuation_beta * sum_15 + shortfall_beta_squared * sum_17
    del sum_13, sum_14, sum_16, shortfall_beta_squared, sum_15, sum_17
    sum_19 = attenuation_beta * product_12 + shortfall_beta * sum_18
    sum_20 = 0.5 * attenuation_beta_squared_squared * shortfall_epsilon_squared + shortfall_beta * sum_19
    sum_21 = 0.25 + 0.25 * attenuation_epsilon_2_squared
    sum_22 = (
        0.25
        - product_13 * sum_9
        + attenuation_beta_squared_squared * sum_21
        + 0.25 * attenuation_epsilon_2_squared
    )
    del sum_18, sum_19, product_13, sum_21
    part_00_cos_epsilon2_sin_beta2 = r_squared * sum_20 + sigma_r_squared * sum_22
    sum_23 = 1.0 + attenuation_beta_squared_squared * sum_11 + attenuation_epsilon_2
    sum_24 = sum_10 * sum_23 - product_21 * sum_11
    del sum_20, sum_22, product_21, sum_10, sum_11, sum_23
    part_00_sin_beta2_sin_epsilon2 = shortfall_epsilon * sum_24
    sum_25 = 4.0 * attenuation_epsilon_2 + 4.0 * shortfall_epsilon
    sum_26 = attenuation_beta * sum_25 + product_4
    sum_27 = product_1 - attenuation_epsilon_2 * shortfall_beta * sum_26
    del sum_24, product_4, sum_25, product_1, shortfall_beta, sum_26
    sum_28 = 3.0 * attenuation_epsilon_2 + 3.0 * shortfall_epsilon
    sum_29 = attenuation_beta * sum_28 + product_3
    sum_30 = attenuation_beta * sum_29 + product_2
    del product_3, sum_28, product_2, sum_29
    sum_31 = 2.0 * product_12 + attenuation_epsilon_2 * sum_30
    sum_32 = 0.5 * attenuation_beta_squared * sum_9 - product_6 * sum_31
    del product_12, sum_30, sum_31, sum_9
    sum_33 = 0.5 * r_squared * sum_27 + sigma_r_squared * sum_32
    part_01_cos_beta_cos_epsilon2_sin_beta = attenuation_beta_squared * sum_33
    sum_34 = 0.5 - 2.0 * product_6
    sum_35 = 0.5 * r_squared + sigma_r_squared * sum_34
    del sum_27, sum_32, sum_33, sum_34
    part_01_cos_beta_sin_beta_sin_epsilon2 = attenuation_beta_squared_squared * product_8 * sum_35
    sum_36 = 1.0 - product_6
    sum_37 = attenuation_epsilon_2 * sigma_r_squared * sum_36 - r_squared * shortfall_epsilon
    del attenuation_beta_squared_squared, sum_35, product_6, sum_36
    product_11 = attenuation_beta * attenuation_epsilon_2
    part_02_cos_epsilon_sin_beta_sin_epsilon = product_11 * sum_37
    sum_38 = 0.5 * r_squared + 0.5 * sigma_r_squared
    part_22_cos_epsilon2 = product_8 * sum_38
    sum_39 = 0.5 + 0.5 * attenuation_epsilon_2_squared
    del attenuation_beta, sum_37, sum_38, attenuation_epsilon_2_squared
    part_22_sin_epsilon2 = 0.5 * r_squared * shortfall_epsilon_squared + sigma_r_squared * sum_39
    del r_squared, shortfall_epsilon_squared, sigma_r_squared, sum_39
    sum_40 = cos_beta * part_0_cos_beta_cos_epsilon + part_0_cos_epsilon_sin_beta * sin_beta
    sum_41 = cos_beta * part_0_cos_epsilon_sin_beta - part_0_cos_beta_cos_epsilon * sin_beta
    sin_epsilon_squared = sin_epsilon**2
    cos_epsilon_squared = cos_epsilon**2
    product_18 = cos_epsilon_squared * sum_6
    product_15 = attenuation_beta_squared * sin_epsilon_squared
    product_24 = product_15 * product_8
    del part_0_cos_beta_cos_epsilon, part_0_cos_epsilon_sin_beta, sum_6, product_15, product_8
    sum_42 = 2.0 * product_18 + 2.0 * product_24
    product_10 = product_9 * r
    product_16 = attenuation_beta_squared * product_10
    product_5 = product_16 * sin_beta * sum_42
    sum_43 = (
        cos_epsilon_squared * part_00_cos_beta2_cos_epsilon2
        + part_00_cos_beta2_sin_epsilon2 * sin_epsilon_squared
    )
    del product_9, attenuation_beta_squared, sum_42, part_00_cos_beta2_cos_epsilon2, part_00_cos_beta2_sin_epsilon2
    sum_44 = (
        cos_epsilon_squared * part_00_cos_epsilon2_sin_beta2
        + part_00_sin_beta2_sin_epsilon2 * sin_epsilon_squared
    )
    sin_beta_squared = sin_beta**2
    sum_45 = cos_beta**2 - sin_beta_squared
    sum_46 = product_18 * sum_45 + product_24 * sum_45
    del part_00_cos_epsilon2_sin_beta2, part_00_sin_beta2_sin_epsilon2, product_18, product_24, sum_45
    sum_47 = (
        cos_epsilon_squared * part_01_cos_beta_cos_epsilon2_sin_beta
        + part_01_cos_beta_sin_beta_sin_epsilon2 * sin_epsilon_squared
    )
    sum_48 = attenuation_epsilon_2 - shortfall_epsilon
    del part_01_cos_beta_cos_epsilon2_sin_beta, part_01_cos_beta_sin_beta_sin_epsilon2, attenuation_epsilon_2, shortfall_epsilon
    product_22 = product_10 * sum_48
    product_25 = product_11 * product_22
    del product_10, sum_48, product_11, product_22
    sum_49 = cos_beta * product_25 + part_02_cos_epsilon_sin_beta_sin_epsilon * sin_beta
    sum_50 = product_25 * sin_beta - cos_beta * part_02_cos_epsilon_sin_beta_sin_epsilon
    product_17 = cos_epsilon * sin_epsilon
    mean[..., 0] = cos_epsilon * sum_40
    mean[..., 1] = cos_epsilon * sum_41
    del part_02_cos_epsilon_sin_beta_sin_epsilon, product_25, sum_40, cos_epsilon, sum_41
    mean[..., 2] = attenuation_epsilon * r * sin_epsilon
    covariance[..., 0, 0] = cos_beta * (cos_beta * sum_43 + product_5) + sin_beta_squared * sum_44
    covariance[..., 0, 1] = cos_beta * sin_beta * sum_47 + product_16 * sum_46
    del attenuation_epsilon, sin_epsilon, product_16, sin_beta, sum_46, sum_47
    covariance[..., 0, 2] = product_17 * sum_49
    covariance[..., 1, 0] = covariance[..., 0, 1]
    covariance[..., 1, 1] = sin_beta_squared * sum_43 - (product_5 - cos_beta * sum_44) * cos_beta
    del sum_49, cos_beta, product_5, sin_beta_squared, sum_43, sum_44
    covariance[..., 1, 2] = -product_17 * sum_50
    covariance[..., 2, 0] = covariance[..., 0, 2]
    covariance[..., 2, 1] = covariance[..., 1, 2]
    covariance[..., 2, 2] = (
        cos_epsilon_squared * part_22_cos_epsilon2
        + part_22_sin_epsilon2 * sin_epsilon_squared
    )
    del product_17, sum_50, cos_epsilon_squared, part_22_cos_epsilon2, part_22_sin_epsilon2, sin_epsilon_squared


def spherical_doppler_linear(
    r: Floats,
    beta: Floats,
    epsilon: Floats,
    rdot: Floats,
    sigma_r: Floats,
    sigma_beta: Floats,
    sigma_epsilon: Floats,
    sigma_rdot: Floats,
    rho: Floats,
    mean: Filled,
    covariance: Filled,
) -> None:
    """Conversion spherical_doppler, linear.

    Mean: map from the measured quantities to coordinates. Covariance: covariance of the linearised
    conversion.
    """
    cos_beta = np.cos(beta)
    sin_beta = np.sin(beta)
    cos_epsilon = np.cos(epsilon)
    sin_epsilon = np.sin(epsilon)
    r_squared = r**2
    sigma_beta_squared = sigma_beta**2
    product_7 = r_squared * sigma_beta_squared
    part_00_cos_beta2_cos_epsilon2 = product_7
    sigma_epsilon_squared = sigma_epsilon**2
    product_8 = r_squared * sigma_epsilon_squared
    part_00_sin_beta2_sin_epsilon2 = product_8
    sigma_r_squared = sigma_r**2
    part_01_cos_beta_cos_epsilon2_sin_beta = sigma_r_squared - product_7
    del sigma_beta_squared, r_squared, sigma_epsilon_squared, product_7
    part_02_cos_epsilon_sin_beta_sin_epsilon = sigma_r_squared - product_8
    product_9 = rdot * sigma_r
    product_4 = r * sigma_rdot
    sum_1 = product_4 * rho + product_9
    part_03_cos_epsilon_sin_beta = sigma_r * sum_1
    cos_beta_squared = cos_beta**2
    sin_beta_squared = sin_beta**2
    cos_epsilon_squared = cos_epsilon**2
    sum_2 = cos_beta_squared * part_00_cos_beta2_cos_epsilon2 + sigma_r_squared * sin_beta_squared
    sin_epsilon_squared = sin_epsilon**2
    product_5 = part_00_sin_beta2_sin_epsilon2 * sin_epsilon_squared
    product_1 = product_5
    sum_3 = cos_epsilon_squared * part_01_cos_beta_cos_epsilon2_sin_beta + product_1
    sum_4 = cos_epsilon_squared * sigma_r_squared + product_1
    del product_8, sum_1, part_01_cos_beta_cos_epsilon2_sin_beta, product_1
    sum_5 = 2.0 * product_9 * rho + product_4
    product_3 = cos_epsilon * sin_beta
    product_2 = cos_beta * cos_epsilon
    product_6 = part_02_cos_epsilon_sin_beta_sin_epsilon * sin_epsilon
    mean[..., 0] = product_3 * r
    mean[..., 1] = product_2 * r
    mean[..., 2] = r * sin_epsilon
    mean[..., 3] = r * rdot
    covariance[..., 0, 0] = cos_epsilon_squared * sum_2 + product_5 * sin_beta_squared
    del product_9, cos_epsilon, part_02_cos_epsilon_sin_beta_sin_epsilon, product_5, sum_2
    covariance[..., 0, 1] = cos_beta * sin_beta * sum_3
    covariance[..., 0, 2] = product_3 * product_6
    covariance[..., 0, 3] = part_03_cos_epsilon_sin_beta * product_3
    del cos_beta, sin_beta, sum_3, product_3
    covariance[..., 1, 0] = covariance[..., 0, 1]
    covariance[..., 1, 1] = (
        cos_beta_squared * sum_4
        + cos_epsilon_squared * part_00_cos_beta2_cos_epsilon2 * sin_beta_squared
    )
    del cos_beta_squared, part_00_cos_beta2_cos_epsilon2, sin_beta_squared, sum_4
    covariance[..., 1, 2] = product_2 * product_6
    covariance[..., 1, 3] = part_03_cos_epsilon_sin_beta * product_2
    covariance[..., 2, 0] = covariance[..., 0, 2]
    covariance[..., 2, 1] = covariance[..., 1, 2]
    covariance[..., 2, 2] = (
        cos_epsilon_squared * part_00_sin_beta2_sin_epsilon2
        + sigma_r_squared * sin_epsilon_squared
    )
    del product_6, product_2, cos_epsilon_squared, part_00_sin_beta2_sin_epsilon2, sin_epsilon_squared
    covariance[..., 2, 3] = part_03_cos_epsilon_sin_beta * sin_epsilon
    covariance[..., 3, 0] = covariance[..., 0, 3]
    covariance[..., 3, 1] = covariance[..., 1, 3]
    covariance[..., 3, 2] = covariance[..., 2, 3]
    covariance[..., 3, 3] = product_4 * sum_5 + rdot**2 * sigma_r_squared
    del part_03_cos_epsilon_sin_beta, sin_epsilon, product_4, sigma_r_squared, sum_5


def spherical_doppler_second_order(
    r: Floats,
    beta: Floats,
    epsilon: Floats,
    rdot: Floats,
    sigma_r: Floats,
    sigma_beta: Floats,
    sigma_epsilon: Floats,
    sigma_rdot: Floats,
    rho: Floats,
    mean: Filled,
    covariance: Filled,
) -> None:
    """Conversion spherical_doppler, second_order.

    Mean: map from the measured quantities to coordinates less the bias of the plain conversion to second
    order. Covariance: covariance of the conversion's quadratic Taylor polynomial.
    """
    cos_beta = np.cos(beta)
    sin_beta = np.sin(beta)
    cos_epsilon = np.cos(epsilon)
    sin_epsilon = np.sin(epsilon)
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
    del sum_1, sum_3, sum_2, sigma_beta_squared
    part_01_cos_beta_cos_epsilon2_sin_beta = sigma_r_squared * sum_5 - r_squared * sum_4
    sum_6 = r_squared * sum_5 + sigma_r_squared
    part_01_cos_beta_sin_beta_sin_epsilon2 = sigma_epsilon_squared * sum_6
    sum_7 = 1.0 - 0.5 * sigma_epsilon_squared
    sum_8 = r_squared * sum_7 + sigma_r_squared
    del sum_4, sum_5, sum_6, sum_7
    part_02_cos_epsilon_sin_beta_sin_epsilon = sigma_r_squared - sigma_epsilon_squared * sum_8
    product_3 = rho * sigma_rdot
    sum_9 = product_3 * r + rdot * sigma_r
    part_03_cos_epsilon_sin_beta = sigma_r * sum_9
    part_22_sin_epsilon2 = 0.5 * r_squared * sigma_epsilon_squared_squared + sigma_r_squared
    del sum_8, sum_9, sigma_epsilon_squared_squared, sigma_r_squared
    sum_10 = part_0_cos_epsilon_sin_beta - r
    sum_11 = 1.0 + 0.5 * sigma_epsilon_squared
    cos_beta_squared = cos_beta**2
    cos_epsilon_squared = cos_epsilon**2
    sin_epsilon_squared = sin_epsilon**2
    sum_12 = (
        cos_epsilon_squared * part_00_cos_beta2_cos_epsilon2
        + part_00_cos_beta2_sin_epsilon2 * sin_epsilon_squared
    )
    del part_0_cos_epsilon_sin_beta, sigma_epsilon_squared, part_00_cos_beta2_cos_epsilon2, part_00_cos_beta2_sin_epsilon2
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
    product_5 = r * rdot
    sum_16 = 2.0 * product_3 * product_5 + sigma_r * sum_15
    del part_00_cos_epsilon2_sin_beta2, part_01_cos_beta_cos_epsilon2_sin_beta, part_01_cos_beta_sin_beta_sin_epsilon2, sum_15
    product_2 = cos_epsilon * sin_beta
    product_1 = cos_beta * cos_epsilon
    product_4 = part_02_cos_epsilon_sin_beta_sin_epsilon * sin_epsilon
    mean[..., 0] = -product_2 * sum_10
    mean[..., 1] = -product_1 * sum_10
    mean[..., 2] = r * sin_epsilon * sum_11
    del cos_epsilon, part_02_cos_epsilon_sin_beta_sin_epsilon, sum_10, sum_11
    mean[..., 3] = product_5 - product_3 * sigma_r
    covariance[..., 0, 0] = cos_beta_squared * sum_12 + sin_beta_squared * sum_13
    covariance[..., 0, 1] = cos_beta * sin_beta * sum_14
    del product_3, product_5, cos_beta, sin_beta, sum_14
    covariance[..., 0, 2] = product_2 * product_4
    covariance[..., 0, 3] = part_03_cos_epsilon_sin_beta * product_2
    covariance[..., 1, 0] = covariance[..., 0, 1]
    covariance[..., 1, 1] = cos_beta_squared * sum_13 + sin_beta_squared * sum_12
    del product_2, cos_beta_squared, sin_beta_squared, sum_12, sum_13
    covariance[..., 1, 2] = product_1 * product_4
    covariance[..., 1, 3] = part_03_cos_epsilon_sin_beta * product_1
    covariance[..., 2, 0] = covariance[..., 0, 2]
    covariance[..., 2, 1] = covariance[..., 1, 2]
    covariance[..., 2, 2] = (
        cos_epsilon_squared * part_00_sin_beta2_sin_epsilon2
        + part_22_sin_epsilon2 * sin_epsilon_squared
    )
    del product_4, product_1, cos_epsilon_squared, part_00_sin_beta2_sin_epsilon2, part_22_sin_epsilon2, sin_epsilon_squared
    covariance[..., 2, 3] = part_03_cos_epsilon_sin_beta * sin_epsilon
    covariance[..., 3, 0] = covariance[..., 0, 3]
    covariance[..., 3, 1] = covariance[..., 1, 3]
    covariance[..., 3, 2] = covariance[..., 2, 3]
    covariance[..., 3, 3] = r_squared * sigma_rdot_squared + sigma_r * sum_16
    del part_03_cos_epsilon_sin_beta, sin_epsilon, r_squared, sigma_rdot_squared, sum_16


def spherical_doppler_averaged(
    r: Floats,
    beta: Floats,
    epsilon: Floats,
    rdot: Floats,
    sigma_r: Floats,
    sigma_beta: Floats,
    sigma_epsilon: Floats,
    sigma_rdot: Floats,
    rho: Floats,
    mean: Filled,
    covariance: Filled,
) -> None:
    """Conversion spherical_doppler, averaged.

    Mean: map from the measured quantities to coordinates less the exact bias of the plain conversion,
    averaged over the truth. Covariance: exact covariance of the plain conversion, averaged over the truth.
    """
    cos_beta = np.cos(beta)
    sin_beta = np.sin(beta)
    cos_epsilon = np.cos(epsilon)
    sin_epsilon = np.sin(epsilon)
    sigma_beta_squared = sigma_beta**2
    attenuation_beta = np.exp(-0.5 * sigma_beta_squared)
    term_1 = np.expm1(-0.5 * sigma_beta_squared)
    shortfall_beta = -term_1
    sigma_epsilon_squared = sigma_epsilon**2
    attenuation_epsilon = np.exp(-0.5 * sigma_epsilon_squared)
    term_2 = np.expm1(-0.5 * sigma_epsilon_squared)
    shortfall_epsilon = -term_2
    sum_1 = (1.0 - shortfall_epsilon) * shortfall_beta + shortfall_epsilon
    part_0_cos_epsilon_sin_beta = -attenuation_beta * attenuation_epsilon * r * sum_1
    attenuation_beta_2 = np.exp(-sigma_beta_squared)
    del shortfall_beta, attenuation_beta, sum_1, sigma_beta_squared
    attenuation_beta_less_one = term_1
    sum_2 = 2.0 + attenuation_beta_less_one
    shortfall_beta_2 = -attenuation_beta_less_one * sum_2
    attenuation_epsilon_2 = np.exp(-sigma_epsilon_squared)
    del term_1, attenuation_beta_less_one, sum_2, sigma_epsilon_squared
    attenuation_epsilon_less_one = term_2
    sum_3 = 2.0 + attenuation_epsilon_less_one
    shortfall_epsilon_2 = -attenuation_epsilon_less_one * sum_3
    sum_4 = 1.0 + attenuation_beta_2
    attenuation_epsilon_2_squared = attenuation_epsilon_2**2
    product_5 = attenuation_beta_2 * attenuation_epsilon_2
    sum_5 = 1.0 - product_5
    sum_6 = 1.0 + attenuation_epsilon_2_squared * sum_5
    del term_2, attenuation_epsilon_less_one, sum_3, sum_5
    sum_7 = attenuation_beta_2 - attenuation_epsilon_2 * sum_6
    attenuation_epsilon_2_squared_squared = attenuation_epsilon_2_squared**2
    r_squared = r**2
    sum_8 = 1.0 + attenuation_beta_2 * sum_7 + attenuation_epsilon_2_squared_squared
    sum_9 = 1.0 - 2.0 * product_5
    sum_10 = 1.0 + attenuation_epsilon_2_squared * sum_9
    sum_11 = 2.0 * attenuation_beta_2 - attenuation_epsilon_2 * sum_10
    del sum_6, sum_7, sum_9, sum_10
    sigma_r_squared = sigma_r**2
    sum_12 = 2.0 + 2.0 * attenuation_epsilon_2_squared_squared + attenuation_beta_2 * sum_11
    sum_13 = 0.25 * r_squared * sum_8 + 0.25 * sigma_r_squared * sum_12
    product_13 = shortfall_beta_2 * sum_4
    del sum_11, sum_12, sum_8, sum_4
    part_00_cos_beta2_cos_epsilon2 = product_13 * sum_13
    sum_14 = 1.0 + attenuation_epsilon_2
    sum_15 = 1.0 + attenuation_epsilon_2_squared
    sum_16 = attenuation_beta_2 * sum_15 - attenuation_epsilon_2
    sum_17 = 1.0 + attenuation_beta_2 * sum_16 + attenuation_epsilon_2_squared
    sum_18 = 2.0 + 2.0 * attenuation_epsilon_2_squared
    sum_19 = attenuation_beta_2 * sum_18 - attenuation_epsilon_2
    sum_20 = 2.0 + 2.0 * attenuation_epsilon_2_squared + attenuation_beta_2 * sum_19
    sum_21 = 0.25 * r_squared * sum_17 + 0.25 * sigma_r_squared * sum_20
    del sum_13, sum_15, sum_18, sum_17, sum_20
    product_14 = shortfall_epsilon_2 * sum_14
    part_00_cos_beta2_sin_epsilon2 = product_13 * product_14 * sum_21
    attenuation_beta_2_squared = attenuation_beta_2**2
    sum_22 = 1.5 * attenuation_epsilon_2 + 1.5 * shortfall_epsilon_2
    shortfall_epsilon_2_squared = shortfall_epsilon_2**2
    sum_23 = attenuation_epsilon_2 * sum_22 + 0.5 * shortfall_epsilon_2_squared
    product_1 = attenuation_beta_2 * attenuation_beta_2_squared
    sum_24 = 3.0 * attenuation_epsilon_2 + 3.0 * shortfall_epsilon_2
    sum_25 = attenuation_epsilon_2 * sum_24 + shortfall_epsilon_2_squared
    sum_26 = 1.5 * attenuation_epsilon_2 + 3.0 * shortfall_epsilon_2
    sum_27 = attenuation_beta_2 * sum_26 + shortfall_beta_2 * sum_26
    del product_13, sum_21, sum_22, sum_26
    sum_28 = 5.25 * shortfall_beta_2 + 6.75 * attenuation_beta_2
    sum_29 = attenuation_epsilon_2 * sum_27 + shortfall_epsilon_2_squared * sum_28
    sum_30 = 0.5 * attenuation_epsilon_2 + shortfall_epsilon_2
    shortfall_beta_2_squared = shortfall_beta_2**2
    sum_31 = 1.5 * shortfall_epsilon_2_squared + attenuation_epsilon_2 * sum_30
    sum_32 = attenuation_beta_2 * sum_29 + shortfall_beta_2_squared * sum_31
    del sum_27, sum_28, sum_30, sum_29, sum_31
    sum_33 = 3.75 * shortfall_beta_2 + 5.25 * attenuation_beta_2
    product_2 = shortfall_epsilon_2 * shortfall_epsilon_2_squared
    sum_34 = attenuation_beta_2 * sum_33 + shortfall_beta_2_squared
    sum_35 = attenuation_epsilon_2 * sum_32 + product_2 * sum_34
    sum_36 = 1.5 * attenuation_beta_2 + shortfall_beta_2
    shortfall_epsilon_2_squared_squared = shortfall_epsilon_2_squared**2
    sum_37 = attenuation_beta_2 * sum_36 + 0.25 * shortfall_beta_2_squared
    del sum_33, sum_32, sum_34, shortfall_beta_2_squared, sum_36
    sum_38 = attenuation_epsilon_2 * sum_35 + shortfall_epsilon_2_squared_squared * sum_37
    sum_39 = product_1 * shortfall_epsilon_2_squared * sum_25 + shortfall_beta_2 * sum_38
    del sum_35, sum_37, sum_25, sum_38
    sum_40 = attenuation_beta_2_squared**2 * shortfall_epsilon_2_squared * sum_23 + shortfall_beta_2 * sum_39
    sum_41 = 0.25 - 0.5 * product_5
    sum_42 = 0.25 + attenuation_epsilon_2_squared * sum_41
    sum_43 = 0.25 + attenuation_beta_2_squared * sum_42 + 0.25 * attenuation_epsilon_2_squared
    del sum_23, sum_39, sum_41, sum_42
    sum_44 = 0.5 * product_1 - attenuation_epsilon_2 * sum_43
    sum_45 = 0.5 + attenuation_beta_2 * sum_44 + 0.5 * attenuation_epsilon_2_squared_squared
    part_00_cos_epsilon2_sin_beta2 = r_squared * sum_40 + sigma_r_squared * sum_45
    del sum_43, attenuation_epsilon_2_squared_squared, sum_44, sum_40, sum_45
    sum_46 = attenuation_beta_2_squared * sum_16 - attenuation_epsilon_2
    sum_47 = 1.0 + attenuation_beta_2 * sum_46 + attenuation_epsilon_2_squared
    sum_48 = attenuation_beta_2_squared * sum_19 - attenuation_epsilon_2
    del sum_16, sum_46, attenuation_beta_2_squared, sum_19
    sum_49 = 2.0 + 2.0 * attenuation_epsilon_2_squared + attenuation_beta_2 * sum_48
    sum_50 = 0.25 * r_squared * sum_47 + 0.25 * sigma_r_squared * sum_49
    part_00_sin_beta2_sin_epsilon2 = product_14 * sum_50
    del sum_48, sum_47, sum_49, product_14, sum_50
    product_3 = attenuation_epsilon_2 * attenuation_epsilon_2_squared
    sum_51 = 3.0 * attenuation_epsilon_2 + shortfall_epsilon_2
    sum_52 = attenuation_beta_2 * sum_24 - shortfall_beta_2 * sum_51
    sum_53 = 4.0 * attenuation_epsilon_2_squared * shortfall_beta_2 - shortfall_epsilon_2 * sum_52
    sum_54 = 2.0 * product_3 * shortfall_beta_2 + shortfall_epsilon_2 * sum_53
    del sum_24, sum_51, sum_52, sum_53
    product_10 = attenuation_beta_2 * shortfall_epsilon_2_squared_squared
    sum_55 = product_10 - attenuation_epsilon_2 * sum_54
    sum_56 = 2.0 * attenuation_epsilon_2 + 4.0 * shortfall_epsilon_2
    sum_57 = attenuation_beta_2 * sum_56 - shortfall_beta_2 * sum_56
    sum_58 = 9.0 * attenuation_beta_2 - 3.0 * shortfall_beta_2
    sum_59 = attenuation_epsilon_2 * sum_57 + shortfall_epsilon_2_squared * sum_58
    del shortfall_epsilon_2_squared_squared, sum_54, sum_56, sum_57, sum_58
    sum_60 = 7.0 * attenuation_beta_2 - shortfall_beta_2
    sum_61 = attenuation_epsilon_2 * sum_59 + product_2 * sum_60
    sum_62 = 2.0 * product_10 + attenuation_epsilon_2 * sum_61
    sum_63 = 0.5 * r_squared * sum_55 + 0.5 * sigma_r_squared * sum_62
    del sum_59, product_10, sum_61, sum_55, sum_62
    part_01_cos_beta_cos_epsilon2_sin_beta = product_1 * sum_63
    sum_64 = 2.0 * attenuation_epsilon_2 + 3.0 * shortfall_epsilon_2
    product_4 = -shortfall_beta_2 * sum_64
    sum_65 = attenuation_beta_2 * sum_64 + product_4
    sum_66 = 3.0 * attenuation_beta_2 - shortfall_beta_2
    sum_67 = attenuation_epsilon_2 * sum_65 + shortfall_epsilon_2_squared * sum_66
    del sum_63, sum_64, shortfall_beta_2, sum_65, sum_66
    product_9 = attenuation_beta_2 * product_2
    sum_68 = attenuation_epsilon_2 * sum_67 + product_9
    sum_69 = 6.0 * attenuation_epsilon_2 + 9.0 * shortfall_epsilon_2
    sum_70 = attenuation_beta_2 * sum_69 + product_4
    del product_2, sum_67, product_4, sum_69
    sum_71 = attenuation_epsilon_2 * sum_70 + shortfall_epsilon_2_squared * sum_60
    sum_72 = 2.0 * product_9 + attenuation_epsilon_2 * sum_71
    del sum_60, sum_70, product_9, sum_71
    sum_73 = 0.5 * r_squared * sum_68 + 0.5 * sigma_r_squared * sum_72
    part_01_cos_beta_sin_beta_sin_epsilon2 = product_1 * shortfall_epsilon_2 * sum_73
    del sum_68, sum_72, product_1, sum_73
    sum_74 = attenuation_epsilon_2 - shortfall_epsilon_2
    sum_75 = r_squared * shortfall_epsilon_2 - sigma_r_squared * sum_74
    part_02_cos_epsilon_sin_beta_sin_epsilon = -attenuation_beta_2 * product_3 * sum_75
    product_8 = rho * sigma_rdot
    sum_76 = product_8 * r + rdot * sigma_r
    product_15 = sigma_r * sum_76
    del sum_74, attenuation_beta_2, sum_75, sum_76
    part_03_cos_epsilon_sin_beta = product_15 * product_5
    sum_77 = 1.0 + 2.0 * attenuation_epsilon_2
    sum_78 = 1.0 + attenuation_epsilon_2 * sum_77
    sum_79 = 2.0 + attenuation_epsilon_2 * sum_78
    sum_80 = 0.5 * (1.0 + product_3) * r_squared + 0.5 * sigma_r_squared * sum_79
    del product_5, sum_77, sum_78, product_3, sum_79
    part_22_cos_epsilon2 = shortfall_epsilon_2 * sum_80
    sum_81 = 1.0 + attenuation_epsilon_2 * sum_14
    sum_82 = 0.5 + (0.5 - attenuation_epsilon_2) * attenuation_epsilon_2_squared
    del shortfall_epsilon_2, sum_80, sum_14, attenuation_epsilon_2_squared
    sum_83 = 1.0 - attenuation_epsilon_2 * sum_82
    part_22_sin_epsilon2 = 0.5 * r_squared * shortfall_epsilon_2_squared * sum_81 + sigma_r_squared * sum_83
    del sum_82, shortfall_epsilon_2_squared, sigma_r_squared, sum_81, sum_83
    part_23_sin_epsilon = attenuation_epsilon_2 * product_15
    sum_84 = part_0_cos_epsilon_sin_beta - r
    sum_85 = 1.0 + attenuation_epsilon * shortfall_epsilon
    del attenuation_epsilon_2, product_15, part_0_cos_epsilon_sin_beta, attenuation_epsilon, shortfall_epsilon
    cos_beta_squared = cos_beta**2
    cos_epsilon_squared = cos_epsilon**2
    sin_epsilon_squared = sin_epsilon**2
    sum_86 = (
        cos_epsilon_squared * part_00_cos_beta2_cos_epsilon2
        + part_00_cos_beta2_sin_epsilon2 * sin_epsilon_squared
    )
    sum_87 = (
        cos_epsilon_squared * part_00_cos_epsilon2_sin_beta2
        + part_00_sin_beta2_sin_epsilon2 * sin_epsilon_squared
    )
    del part_00_cos_beta2_cos_epsilon2, part_00_cos_beta2_sin_epsilon2, part_00_cos_epsilon2_sin_beta2, part_00_sin_beta2_sin_epsilon2
    sin_beta_squared = sin_beta**2
    sum_88 = (
        cos_epsilon_squared * part_01_cos_beta_cos_epsilon2_sin_beta
        + part_01_cos_beta_sin_beta_sin_epsilon2 * sin_epsilon_squared
    )
    sigma_rdot_squared = sigma_rdot**2
    sum_89 = rdot**2 + (3.0 + 3.0 * rho**2) * sigma_rdot_squared
    product_12 = r * rdot
    sum_90 = 2.0 * product_12 * product_8 + sigma_r * sum_89
    product_7 = cos_epsilon * sin_beta
    product_6 = cos_beta * cos_epsilon
    del part_01_cos_beta_cos_epsilon2_sin_beta, part_01_cos_beta_sin_beta_sin_epsilon2, sum_89, cos_epsilon
    product_11 = part_02_cos_epsilon_sin_beta_sin_epsilon * sin_epsilon
    mean[..., 0] = -product_7 * sum_84
    mean[..., 1] = -product_6 * sum_84
    mean[..., 2] = r * sin_epsilon * sum_85
    mean[..., 3] = product_12 - product_8 * sigma_r
    del part_02_cos_epsilon_sin_beta_sin_epsilon, sum_84, sum_85, product_12, product_8
    covariance[..., 0, 0] = cos_beta_squared * sum_86 + sin_beta_squared * sum_87
    covariance[..., 0, 1] = cos_beta * sin_beta * sum_88
    covariance[..., 0, 2] = product_11 * product_7
    covariance[..., 0, 3] = part_03_cos_epsilon_sin_beta * product_7
    del cos_beta, sin_beta, sum_88, product_7
    covariance[..., 1, 0] = covariance[..., 0, 1]
    covariance[..., 1, 1] = cos_beta_squared * sum_87 + sin_beta_squared * sum_86
    del cos_beta_squared, sin_beta_squared, sum_86, sum_87
    covariance[..., 1, 2] = product_11 * product_6
    covariance[..., 1, 3] = part_03_cos_epsilon_sin_beta * product_6
    covariance[..., 2, 0] = covariance[..., 0, 2]
    covariance[..., 2, 1] = covariance[..., 1, 2]
    covariance[..., 2, 2] = (
        cos_epsilon_squared * part_22_cos_epsilon2
        + part_22_sin_epsilon2 * sin_epsilon_squared
    )
    del product_11, part_03_cos_epsilon_sin_beta, product_6, cos_epsilon_squared, part_22_cos_epsilon2, part_22_sin_epsilon2, sin_epsilon_squared
    covariance[..., 2, 3] = part_23_sin_epsilon * sin_epsilon
    covariance[..., 3, 0] = covariance[..., 0, 3]
    covariance[..., 3, 1] = covariance[..., 1, 3]
    covariance[..., 3, 2] = covariance[..., 2, 3]
    covariance[..., 3, 3] = r_squared * sigma_rdot_squared + sigma_r * sum_90
    del part_23_sin_epsilon, sin_epsilon, r_squared, sigma_rdot_squared, sum_90


def spherical_doppler_unbiased(
    r: Floats,
    beta: Floats,
    epsilon: Floats,
    rdot: Floats,
    sigma_r: Floats,
    sigma_beta: Floats,
    sigma_epsilon: Floats,
    sigma_rdot: Floats,
    rho: Floats,
    mean: Filled,
    covariance: Filled,
) -> None:
    """Conversion spherical_doppler, unbiased.

    Mean: exactly unbiased estimate of the position. Covariance: error covariance of the unbiased estimate u.
    """
    cos_beta = np.cos(beta)
    sin_beta = np.sin(beta)
    cos_epsilon = np.cos(epsilon)
    sin_epsilon = np.sin(epsilon)
    attenuation_beta = np.exp(-0.5 * sigma_beta**2)
    attenuation_epsilon = np.exp(-0.5 * sigma_epsilon**2)
    term_1 = 1.0 / attenuation_beta
    term_2 = 1.0 / attenuation_epsilon
    product_5 = r * term_2
    part_0_cos_epsilon_sin_beta = product_5 * term_1
    shortfall_beta = -np.expm1(-0.5 * sigma_beta**2)
    shortfall_epsilon = -np.expm1(-0.5 * sigma_epsilon**2)
    sum_1 = 1.0 + attenuation_beta
    attenuation_beta_squared = attenuation_beta**2
    sum_2 = 1.0 + attenuation_beta_squared
    attenuation_epsilon_squared = attenuation_epsilon**2
    attenuation_epsilon_squared_squared = attenuation_epsilon_squared**2
    sum_3 = 1.0 + attenuation_epsilon_squared_squared
    r_squared = r**2
    sigma_r_squared = sigma_r**2
    sum_4 = 0.25 * r_squared + 0.25 * sigma_r_squared
    product_3 = shortfall_beta * sum_1
    product_18 = sum_2 * sum_4
    product_23 = product_18 * product_3
    del term_2, sum_1, sum_2, product_18
    part_00_cos_beta2_cos_epsilon2 = product_23 * sum_3
    sum_5 = 1.0 + attenuation_epsilon
    sum_6 = 1.0 + attenuation_epsilon_squared
    product_4 = shortfall_epsilon * sum_5
    product_21 = product_4 * sum_6
    part_00_cos_beta2_sin_epsilon2 = product_21 * product_23
    term_3 = 1.0 / attenuation_beta**2
    sum_7 = 1.0 + attenuation_beta_squared * sum_6 + attenuation_epsilon_squared
    product_1 = attenuation_beta_squared * attenuation_epsilon_squared * sum_7
    term_4 = 1.0 / attenuation_epsilon**2
    product_10 = product_4 * term_4
    sum_8 = 0.25 * (4.0 + product_1) * product_10 + 0.5 * (2.0 + attenuation_beta_squared) * product_3
    sum_5_squared = sum_5**2
    sum_9 = 2.0 + attenuation_epsilon_squared
    shortfall_epsilon_squared = shortfall_epsilon**2
    product_22 = product_3 * term_3
    del product_23, sum_7, product_4, product_3, term_3
    product_9 = shortfall_epsilon_squared * term_4
    product_20 = sum_5_squared * sum_9
    product_25 = product_20 * product_9
    del term_4, sum_5_squared, sum_9, product_20
    sum_10 = product_22 * sum_8 + 0.5 * product_25
    attenuation_beta_squared_squared = attenuation_beta_squared**2
    sum_11 = 0.25 + 0.25 * attenuation_epsilon_squared_squared
    sum_12 = 0.25 + attenuation_beta_squared_squared * sum_11 + 0.25 * attenuation_epsilon_squared_squared
    part_00_cos_epsilon2_sin_beta2 = r_squared * sum_10 + sigma_r_squared * sum_12
    del sum_8, attenuation_beta_squared, sum_11, sum_10, sum_12
    sum_13 = 1.0 + attenuation_beta_squared_squared
    part_00_sin_beta2_sin_epsilon2 = product_21 * sum_13 * sum_4
    shortfall_beta_squared = shortfall_beta**2
    sum_14 = attenuation_beta - 2.0 * shortfall_beta
    sum_15 = attenuation_beta * sum_14 - 5.0 * shortfall_beta_squared
    del product_21, sum_13, sum_4, sum_14
    sum_16 = attenuation_beta * sum_15 - 4.0 * shortfall_beta * shortfall_beta_squared
    sum_17 = attenuation_beta * sum_16 - 0.5 * (2.0 + product_1) * product_10 - shortfall_beta_squared**2
    del sum_15, product_1, shortfall_beta_squared, sum_16
    sum_18 = product_22 * sum_17 - 0.5 * product_25
    part_01_cos_beta_cos_epsilon2_sin_beta = (
        0.5 * attenuation_beta_squared_squared * sigma_r_squared * sum_3
        - r_squared * sum_18
    )
    del product_22, product_25, sum_17, sum_18, sum_3
    sum_19 = 1.0 + attenuation_epsilon * sum_5
    sum_20 = 1.0 + attenuation_epsilon * sum_19
    sum_21 = 0.5 * r_squared + 0.5 * sigma_r_squared
    product_16 = shortfall_epsilon * sum_20
    product_19 = product_16 * sum_21
    del sum_5, sum_19, sum_20, product_16, sum_21
    part_01_cos_beta_sin_beta_sin_epsilon2 = attenuation_beta_squared_squared * product_19
    product_11 = attenuation_beta * attenuation_epsilon_squared
    sum_22 = 1.0 + product_11 * sum_6
    sum_23 = attenuation_epsilon - 2.0 * shortfall_epsilon
    sum_24 = attenuation_epsilon * sum_23 - 5.0 * shortfall_epsilon_squared
    del attenuation_beta_squared_squared, attenuation_epsilon_squared, sum_6, sum_23
    sum_25 = attenuation_epsilon * sum_24 - 4.0 * shortfall_epsilon * shortfall_epsilon_squared
    product_15 = shortfall_beta * term_1
    sum_26 = attenuation_epsilon * sum_25 - product_15 * sum_22 - shortfall_epsilon_squared**2
    del sum_24, shortfall_beta, term_1, sum_22, sum_25
    part_02_cos_epsilon_sin_beta_sin_epsilon = (
        attenuation_beta * attenuation_epsilon_squared_squared * sigma_r_squared
        - product_10 * r_squared * sum_26
    )
    sum_27 = 2.0 + 3.0 * product_11
    sum_28 = attenuation_epsilon - 4.0 * shortfall_epsilon
    del product_10, sum_26, product_11, shortfall_epsilon
    product_2 = attenuation_epsilon * sum_28
    sum_29 = product_2 - 2.0 * shortfall_epsilon_squared - product_15 * sum_27
    product_12 = attenuation_epsilon * rdot
    product_17 = product_12 * sigma_r
    del sum_28, product_15, sum_27, product_12
    product_6 = rho * sigma_rdot
    product_24 = product_5 * product_6
    sum_30 = attenuation_beta * product_17 + product_24 * sum_29
    part_03_cos_epsilon_sin_beta = sigma_r * sum_30
    part_22_cos_epsilon2 = product_19
    del attenuation_beta, sum_29, sum_30, product_19
    sum_31 = 3.0 + attenuation_epsilon * (2.0 + attenuation_epsilon)
    sum_32 = 4.0 + attenuation_epsilon * sum_31
    sum_33 = 2.0 + attenuation_epsilon * sum_32
    sum_34 = 0.5 + 0.5 * attenuation_epsilon_squared_squared
    del sum_31, attenuation_epsilon, sum_32, attenuation_epsilon_squared_squared
    part_22_sin_epsilon2 = 0.5 * product_9 * r_squared * sum_33 + sigma_r_squared * sum_34
    del product_9, sigma_r_squared, sum_33, sum_34
    sum_35 = product_2 - 2.0 * shortfall_epsilon_squared
    sum_36 = product_17 + product_24 * sum_35
    del product_2, shortfall_epsilon_squared, product_17, product_24, sum_35
    part_23_sin_epsilon = sigma_r * sum_36
    cos_beta_squared = cos_beta**2
    cos_epsilon_squared = cos_epsilon**2
    sin_epsilon_squared = sin_epsilon**2
    sum_37 = (
        cos_epsilon_squared * part_00_cos_beta2_cos_epsilon2
        + part_00_cos_beta2_sin_epsilon2 * sin_epsilon_squared
    )
    sum_38 = (
        cos_epsilon_squared * part_00_cos_epsilon2_sin_beta2
        + part_00_sin_beta2_sin_epsilon2 * sin_epsilon_squared
    )
    del sum_36, part_00_cos_beta2_cos_epsilon2, part_00_cos_beta2_sin_epsilon2, part_00_cos_epsilon2_sin_beta2, part_00_sin_beta2_sin_epsilon2
    sin_beta_squared = sin_beta**2
    sum_39 = (
        cos_epsilon_squared * part_01_cos_beta_cos_epsilon2_sin_beta
        + part_01_cos_beta_sin_beta_sin_epsilon2 * sin_epsilon_squared
    )
    sigma_rdot_squared = sigma_rdot**2
    sum_40 = rdot**2 + (1.0 + 5.0 * rho**2) * sigma_rdot_squared
    product_14 = r * rdot
    sum_41 = 2.0 * product_14 * product_6 + sigma_r * sum_40
    product_8 = cos_epsilon * sin_beta
    product_7 = cos_beta * cos_epsilon
    del part_01_cos_beta_cos_epsilon2_sin_beta, part_01_cos_beta_sin_beta_sin_epsilon2, sum_40, cos_epsilon
    product_13 = part_02_cos_epsilon_sin_beta_sin_epsilon * sin_epsilon
    mean[..., 0] = part_0_cos_epsilon_sin_beta * product_8
    mean[..., 1] = part_0_cos_epsilon_sin_beta * product_7
    mean[..., 2] = product_5 * sin_epsilon
    mean[..., 3] = product_14 - product_6 * sigma_r
    del part_02_cos_epsilon_sin_beta_sin_epsilon, part_0_cos_epsilon_sin_beta, product_5, product_14, product_6
    covariance[..., 0, 0] = cos_beta_squared * sum_37 + sin_beta_squared * sum_38
    covariance[..., 0, 1] = cos_beta * sin_beta * sum_39
    covariance[..., 0, 2] = product_13 * product_8
    covariance[..., 0, 3] = part_03_cos_epsilon_sin_beta * product_8
    del cos_beta, sin_beta, sum_39, product_8
    covariance[..., 1, 0] = covariance[..., 0, 1]
    covariance[..., 1, 1] = cos_beta_squared * sum_38 + sin_beta_squared * sum_37
    del cos_beta_squared, sin_beta_squared, sum_37, sum_38
    covariance[..., 1, 2] = product_13 * product_7
    covariance[..., 1, 3] = part_03_cos_epsilon_sin_beta * product_7
    covariance[..., 2, 0] = covariance[..., 0, 2]
    covariance[..., 2, 1] = covariance[..., 1, 2]
    covariance[..., 2, 2] = (
        cos_epsilon_squared * part_22_cos_epsilon2
        + part_22_sin_epsilon2 * sin_epsilon_squared
    )
    del product_13, part_03_cos_epsilon_sin_beta, product_7, cos_epsilon_squared, part_22_cos_epsilon2, part_22_sin_epsilon2, sin_epsilon_squared
    covariance[..., 2, 3] = part_23_sin_epsilon * sin_epsilon
    covariance[..., 3, 0] = covariance[..., 0, 3]
    covariance[..., 3, 1] = covariance[..., 1, 3]
    covariance[..., 3, 2] = covariance[..., 2, 3]
    covariance[..., 3, 3] = r_squared * sigma_rdot_squared + sigma_r * sum_41
    del part_23_sin_epsilon, sin_epsilon, r_squared, sigma_rdot_squared, sum_41


def spherical_doppler_posterior(
    r: Floats,
    beta: Floats,
    epsilon: Floats,
    rdot: Floats,
    sigma_r: Floats,
    sigma_beta: Floats,
    sigma_epsilon: Floats,
    sigma_rdot: Floats,
    rho: Floats,
    mean: Filled,
    covariance: Filled,
) -> None:
    """Conversion spherical_doppler, posterior.

    Mean: posterior mean of the position under a flat prior. Covariance: posterior covariance of the position
    under a flat prior.
    """
    cos_beta = np.cos(beta)
    sin_beta = np.sin(beta)
    cos_epsilon = np.cos(epsilon)
    sin_epsilon = np.sin(epsilon)
    attenuation_beta = np.exp(-0.5 * sigma_beta**2)
    attenuation_epsilon = np.exp(-0.5 * sigma_epsilon**2)
    product_7 = attenuation_beta * attenuation_epsilon
    part_0_cos_epsilon_sin_beta = product_7 * r
    shortfall_beta = -np.expm1(-0.5 * sigma_beta**2)
    shortfall_epsilon = -np.expm1(-0.5 * sigma_epsilon**2)
    sum_1 = 1.0 + attenuation_beta
    attenuation_beta_squared = attenuation_beta**2
    sum_2 = 1.0 + attenuation_beta_squared
    attenuation_epsilon_squared = attenuation_epsilon**2
    attenuation_epsilon_squared_squared = attenuation_epsilon_squared**2
    sum_3 = 1.0 + attenuation_epsilon_squared_squared
    r_squared = r**2
    sigma_r_squared = sigma_r**2
    sum_4 = 0.25 * r_squared + 0.25 * sigma_r_squared
    product_11 = shortfall_beta * sum_1
    product_14 = sum_2 * sum_4
    product_17 = product_11 * product_14
    del sum_1, sum_2, product_11, product_14
    part_00_cos_beta2_cos_epsilon2 = product_17 * sum_3
    sum_5 = 1.0 + attenuation_epsilon
    sum_6 = 1.0 + attenuation_epsilon_squared
    product_6 = shortfall_epsilon * sum_5
    product_16 = product_6 * sum_6
    part_00_cos_beta2_sin_epsilon2 = product_16 * product_17
    attenuation_beta_squared_squared = attenuation_beta_squared**2
    sum_7 = 2.0 * attenuation_epsilon + 2.0 * shortfall_epsilon
    shortfall_epsilon_squared = shortfall_epsilon**2
    sum_8 = attenuation_epsilon * sum_7 + 0.5 * shortfall_epsilon_squared
    sum_9 = 4.0 * attenuation_epsilon + 4.0 * shortfall_epsilon
    sum_10 = attenuation_epsilon * sum_9 + shortfall_epsilon_squared
    del sum_6, product_17, sum_7, sum_9
    sum_11 = 2.0 * attenuation_epsilon + 4.0 * shortfall_epsilon
    product_1 = shortfall_beta * sum_11
    sum_12 = attenuation_beta * sum_11 + product_1
    sum_13 = 6.0 * shortfall_beta + 8.0 * attenuation_beta
    sum_14 = attenuation_epsilon * sum_12 + shortfall_epsilon_squared * sum_13
    sum_15 = 0.5 * attenuation_epsilon + shortfall_epsilon
    shortfall_beta_squared = shortfall_beta**2
    sum_16 = 1.5 * shortfall_epsilon_squared + attenuation_epsilon * sum_15
    del sum_11, sum_12, sum_13, sum_15
    sum_17 = attenuation_beta * sum_14 + shortfall_beta_squared * sum_16
    sum_18 = 4.0 * shortfall_beta + 6.0 * attenuation_beta
    product_2 = shortfall_epsilon * shortfall_epsilon_squared
    sum_19 = attenuation_beta * sum_18 + shortfall_beta_squared
    sum_20 = attenuation_epsilon * sum_17 + product_2 * sum_19
    del sum_14, sum_16, sum_18, sum_17, sum_19
    sum_21 = 1.5 * attenuation_beta + shortfall_beta
    shortfall_epsilon_squared_squared = shortfall_epsilon_squared**2
    sum_22 = attenuation_beta * sum_21 + 0.25 * shortfall_beta_squared
    sum_23 = attenuation_epsilon * sum_20 + shortfall_epsilon_squared_squared * sum_22
    del shortfall_beta_squared, sum_21, sum_20, sum_22
    product_8 = attenuation_beta_squared * shortfall_epsilon_squared
    sum_24 = attenuation_beta * product_8 * sum_10 + shortfall_beta * sum_23
    sum_25 = attenuation_beta_squared_squared * shortfall_epsilon_squared * sum_8 + shortfall_beta * sum_24
    del sum_10, sum_23, sum_24, sum_8
    sum_26 = 0.25 + 0.25 * attenuation_epsilon_squared_squared
    sum_27 = 0.25 + attenuation_beta_squared_squared * sum_26 + 0.25 * attenuation_epsilon_squared_squared
    part_00_cos_epsilon2_sin_beta2 = r_squared * sum_25 + sigma_r_squared * sum_27
    sum_28 = 1.0 + attenuation_beta_squared_squared
    part_00_sin_beta2_sin_epsilon2 = product_16 * sum_28 * sum_4
    del sum_26, sum_25, sum_27, product_16, sum_28, sum_4
    sum_29 = 4.0 * attenuation_epsilon + 8.0 * shortfall_epsilon
    sum_30 = attenuation_beta * sum_29 + product_1
    sum_31 = 2.0 * shortfall_beta + 4.0 * attenuation_beta
    sum_32 = attenuation_epsilon * sum_30 + shortfall_epsilon_squared * sum_31
    del product_1, sum_29, sum_30, sum_31
    sum_33 = 4.0 * product_8 - shortfall_beta * sum_32
    sum_34 = 4.0 * attenuation_beta_squared * product_2 + attenuation_epsilon * sum_33
    del product_8, shortfall_beta, sum_32, product_2, sum_33
    sum_35 = attenuation_beta_squared * shortfall_epsilon_squared_squared + attenuation_epsilon * sum_34
    sum_36 = 0.5 * attenuation_beta_squared * sigma_r_squared * sum_3 + 0.5 * r_squared * sum_35
    del shortfall_epsilon_squared_squared, sum_34, sum_3, sum_35
    part_01_cos_beta_cos_epsilon2_sin_beta = attenuation_beta_squared * sum_36
    sum_37 = 1.0 + attenuation_epsilon * sum_5
    sum_38 = 1.0 + attenuation_epsilon * sum_37
    del attenuation_beta_squared, sum_36, sum_5, sum_37
    sum_39 = 0.5 * r_squared + 0.5 * sigma_r_squared
    product_12 = shortfall_epsilon * sum_38
    product_15 = product_12 * sum_39
    del shortfall_epsilon, sum_38, product_12, sum_39
    part_01_cos_beta_sin_beta_sin_epsilon2 = attenuation_beta_squared_squared * product_15
    sum_40 = attenuation_epsilon_squared * sigma_r_squared - product_6 * r_squared
    part_02_cos_epsilon_sin_beta_sin_epsilon = attenuation_beta * attenuation_epsilon_squared * sum_40
    del attenuation_beta_squared_squared, product_6, attenuation_beta, attenuation_epsilon_squared, sum_40
    product_5 = rho * sigma_rdot
    sum_41 = product_5 * r + rdot * sigma_r
    product_13 = sigma_r * sum_41
    part_03_cos_epsilon_sin_beta = product_13 * product_7
    part_22_cos_epsilon2 = product_15
    sum_42 = 1.0 + attenuation_epsilon * (2.0 + attenuation_epsilon)
    sum_43 = 0.5 + 0.5 * attenuation_epsilon_squared_squared
    del sum_41, product_7, product_15, attenuation_epsilon_squared_squared
    part_22_sin_epsilon2 = 0.5 * r_squared * shortfall_epsilon_squared * sum_42 + sigma_r_squared * sum_43
    del shortfall_epsilon_squared, sigma_r_squared, sum_42, sum_43
    part_23_sin_epsilon = attenuation_epsilon * product_13
    cos_beta_squared = cos_beta**2
    cos_epsilon_squared = cos_epsilon**2
    sin_epsilon_squared = sin_epsilon**2
    sum_44 = (
        cos_epsilon_squared * part_00_cos_beta2_cos_epsilon2
        + part_00_cos_beta2_sin_epsilon2 * sin_epsilon_squared
    )
    sum_45 = (
        cos_epsilon_squared * part_00_cos_epsilon2_sin_beta2
        + part_00_sin_beta2_sin_epsilon2 * sin_epsilon_squared
    )
    del product_13, part_00_cos_beta2_cos_epsilon2, part_00_cos_beta2_sin_epsilon2, part_00_cos_epsilon2_sin_beta2, part_00_sin_beta2_sin_epsilon2
    sin_beta_squared = sin_beta**2
    sum_46 = (
        cos_epsilon_squared * part_01_cos_beta_cos_epsilon2_sin_beta
        + part_01_cos_beta_sin_beta_sin_epsilon2 * sin_epsilon_squared
    )
    sigma_rdot_squared = sigma_rdot**2
    sum_47 = rdot**2 + (1.0 + rho**2) * sigma_rdot_squared
    product_10 = r * rdot
    sum_48 = 2.0 * product_10 * product_5 + sigma_r * sum_47
    product_4 = cos_epsilon * sin_beta
    product_3 = cos_beta * cos_epsilon
    del part_01_cos_beta_cos_epsilon2_sin_beta, part_01_cos_beta_sin_beta_sin_epsilon2, sum_47, cos_epsilon
    product_9 = part_02_cos_epsilon_sin_beta_sin_epsilon * sin_epsilon
    mean[..., 0] = part_0_cos_epsilon_sin_beta * product_4
    mean[..., 1] = part_0_cos_epsilon_sin_beta * product_3
    mean[..., 2] = attenuation_epsilon * r * sin_epsilon
    mean[..., 3] = product_10 + product_5 * sigma_r
    del part_02_cos_epsilon_sin_beta_sin_epsilon, part_0_cos_epsilon_sin_beta, attenuation_epsilon, product_10, product_5
    covariance[..., 0, 0] = cos_beta_squared * sum_44 + sin_beta_squared * sum_45
    covariance[..., 0, 1] = cos_beta * sin_beta * sum_46
    covariance[..., 0, 2] = product_4 * product_9
    covariance[..., 0, 3] = part_03_cos_epsilon_sin_beta * product_4
    del cos_beta, sin_beta, sum_46, product_4
    covariance[..., 1, 0] = covariance[..., 0, 1]
    covariance[..., 1, 1] = cos_beta_squared * sum_45 + sin_beta_squared * sum_44
    del cos_beta_squared, sin_beta_squared, sum_44, sum_45
    covariance[..., 1, 2] = product_3 * product_9
    covariance[..., 1, 3] = part_03_cos_epsilon_sin_beta * product_3
    covariance[..., 2, 0] = covariance[..., 0, 2]
    covariance[..., 2, 1] = covariance[..., 1, 2]
    covariance[..., 2, 2] = (
        cos_epsilon_squared * part_22_cos_epsilon2
        + part_22_sin_epsilon2 * sin_epsilon_squared
    )
    del product_9, part_03_cos_epsilon_sin_beta, product_3, cos_epsilon_squared, part_22_cos_epsilon2, part_22_sin_epsilon2, sin_epsilon_squared
    covariance[..., 2, 3] = part_23_sin_epsilon * sin_epsilon
    covariance[..., 3, 0] = covariance[..., 0, 3]
    covariance[..., 3, 1] = covariance[..., 1, 3]
    covariance[..., 3, 2] = covariance[..., 2, 3]
    covariance[..., 3, 3] = r_squared * sigma_rdot_squared + sigma_r * sum_48
    del part_23_sin_epsilon, sin_epsilon, r_squared, sigma_rdot_squared, sum_48
