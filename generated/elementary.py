"""Elementary functions without a branch, in double and, for NumPy's float32, single precision.

Each is within one unit in the last place of the exact value; sine and cosine up to a largest angle,
beyond which they are NaN. The bits are the same on every processor. A zero has no sign.

Written by radartrack regenerate, generator 1, derivation e83b77c4efdaf362; not to be edited.
"""

import math

LARGEST_ANGLE, LARGEST_ANGLE_SINGLE = 32768.0, 256.0
NAN = math.nan


def chosen(condition: bool, first: float, second: float) -> float:  # noqa: FBT001 - as a selection has it
    """The first where the condition holds, else the second; a compiler puts a selection in place of this."""
    return first if condition else second


def power_of_two(exponent: float) -> float:
    """2 to a whole power, from -1074 to 1023; a compiler puts its bits in place of this."""
    return math.ldexp(1.0, int(exponent)) if abs(exponent) < math.inf else exponent


def sin_and_cos(angle: float) -> tuple[float, float]:
    """Sine and cosine of an angle in radians."""
    x = chosen(abs(angle) <= LARGEST_ANGLE, angle, NAN)
    quarters = (x * 0.6366197723675814 + 6755399441055744.0) - 6755399441055744.0
    rest = x - quarters * 1.5707963267923333
    part_2 = quarters * 2.5633441515839558e-12
    rest_2 = rest - part_2
    low_2 = (rest - rest_2) - part_2
    low = low_2 - quarters * 1.0562999066987428e-23
    y = rest_2 + low
    y_low = (rest_2 - y) + low
    square = y * y
    half_square = 0.5 * square
    sine_series = -0.1666666666666663 + square * (0.00833333333332184 + square * (-0.0001984126982935879 + square * (2.7557313538704223e-06 + square * (-2.5050734432917588e-08 + square * 1.5895436509772881e-10))))
    sine_of_y = y + (square * y * sine_series + (y_low - half_square * y_low))
    head = 1.0 - half_square
    cosine_series = 0.041666666666666595 + square * (-0.0013888888888873338 + square * (2.4801587288997356e-05 + square * (-2.755731421522648e-07 + square * (2.0875705101376363e-09 + square * -1.1358731946151996e-11))))
    cosine_of_y = head + (((1.0 - head) - half_square) + (square * square * cosine_series - y * y_low))
    quadrant = quarters - 4.0 * ((quarters * 0.25 + 6755399441055744.0) - 6755399441055744.0)
    turned = abs(quadrant)
    even = 1.0 - turned
    odd = quadrant * (2.0 - turned)
    return odd * cosine_of_y + even * sine_of_y, even * cosine_of_y - odd * sine_of_y


def sin(angle: float) -> float:
    """Sine of an angle in radians."""
    return sin_and_cos(angle)[0]


def cos(angle: float) -> float:
    """Cosine of an angle in radians."""
    return sin_and_cos(angle)[1]


def exp(x: float) -> float:
    """e^x."""
    not_huge = chosen(x > 710.0, 710.0, x)
    given = chosen(not_huge < -750.0, -750.0, not_huge)
    doublings = (given * 1.4426950408889634 + 6755399441055744.0) - 6755399441055744.0
    high = given - doublings * 0.6931471805598903
    low = doublings * 5.497923018708371e-14
    rest = high - low
    lost = (high - rest) - low
    square = rest * rest
    series = 0.16666666666666677 + rest * (0.04166666666666669 + rest * (0.008333333333321776 + rest * (0.0013888888888887085 + rest * (0.0001984126988534903 + rest * (2.480158729409885e-05 + rest * (2.7557245196161155e-06 + rest * (2.755731641442066e-07 + rest * (2.510865616449033e-08 + rest * 2.0897835056122505e-09))))))))
    half_square = 0.5 * square
    tail = lost + rest * (lost + square * series)
    half = (doublings * 0.5 + 6755399441055744.0) - 6755399441055744.0
    return (1.0 + (rest + (half_square + tail))) * power_of_two(half) * power_of_two(doublings - half)


def expm1(x: float) -> float:
    """e^x less one."""
    not_huge = chosen(x > 710.0, 710.0, x)
    given = chosen(not_huge < -750.0, -750.0, not_huge)
    doublings = (given * 1.4426950408889634 + 6755399441055744.0) - 6755399441055744.0
    high = given - doublings * 0.6931471805598903
    low = doublings * 5.497923018708371e-14
    rest = high - low
    lost = (high - rest) - low
    square = rest * rest
    series = 0.16666666666666677 + rest * (0.04166666666666669 + rest * (0.008333333333321776 + rest * (0.0013888888888887085 + rest * (0.0001984126988534903 + rest * (2.480158729409885e-05 + rest * (2.7557245196161155e-06 + rest * (2.755731641442066e-07 + rest * (2.510865616449033e-08 + rest * 2.0897835056122505e-09))))))))
    half_square = 0.5 * square
    tail = lost + rest * (lost + square * series)
    not_many = chosen(doublings > 64.0, 64.0, doublings)
    few = chosen(not_many < -64.0, -64.0, not_many)
    scale = power_of_two(few)
    shifted = scale - 1.0
    kept = shifted + 1.0
    unshifted = (scale - kept) + ((kept - shifted) - 1.0)
    scaled = scale * rest
    total = shifted + scaled
    back = total - shifted
    lost_again = (shifted - (total - back)) + (scaled - back)
    near = total + (scale * half_square + (lost_again + (unshifted + scale * tail)))
    return near * power_of_two(doublings - not_many)


def sin_and_cos_single(angle: float) -> tuple[float, float]:
    """Sine and cosine of an angle in radians."""
    x = chosen(abs(angle) <= LARGEST_ANGLE_SINGLE, angle, NAN)
    quarters = (x * 0.6366197466850281 + 12582912.0) - 12582912.0
    rest = x - quarters * 1.57080078125
    part_2 = quarters * -4.454515874385834e-06
    rest_2 = rest - part_2
    low_2 = (rest - rest_2) - part_2
    part_3 = quarters * 6.077272018956137e-11
    rest_3 = rest_2 - part_3
    low_3 = low_2 + ((rest_2 - rest_3) - part_3)
    low = low_3 - quarters * -1.7151245100058819e-15
    y = rest_3 + low
    y_low = (rest_3 - y) + low
    square = y * y
    half_square = 0.5 * square
    sine_series = -0.16666655242443085 + square * (0.008332189172506332 + square * -0.0001951828453456983)
    sine_of_y = y + (square * y * sine_series + (y_low - half_square * y_low))
    head = 1.0 - half_square
    cosine_series = 0.04166664555668831 + square * (-0.0013887309469282627 + square * 2.4432327336398885e-05)
    cosine_of_y = head + (((1.0 - head) - half_square) + (square * square * cosine_series - y * y_low))
    quadrant = quarters - 4.0 * ((quarters * 0.25 + 12582912.0) - 12582912.0)
    turned = abs(quadrant)
    even = 1.0 - turned
    odd = quadrant * (2.0 - turned)
    return odd * cosine_of_y + even * sine_of_y, even * cosine_of_y - odd * sine_of_y


def sin_single(angle: float) -> float:
    """Sine of an angle in radians."""
    return sin_and_cos_single(angle)[0]


def cos_single(angle: float) -> float:
    """Cosine of an angle in radians."""
    return sin_and_cos_single(angle)[1]


def exp_single(x: float) -> float:
    """e^x."""
    not_huge = chosen(x > 89.0, 89.0, x)
    given = chosen(not_huge < -105.0, -105.0, not_huge)
    doublings = (given * 1.4426950216293335 + 12582912.0) - 12582912.0
    high = given - doublings * 0.693145751953125
    low = doublings * 1.428606765330187e-06
    rest = high - low
    lost = (high - rest) - low
    square = rest * rest
    series = 0.1666666567325592 + rest * (0.04166649281978607 + rest * (0.008333547040820122 + rest * (0.0013932316796854138 + rest * 0.00019760899886023253)))
    half_square = 0.5 * square
    tail = lost + rest * (lost + square * series)
    half = (doublings * 0.5 + 12582912.0) - 12582912.0
    return (1.0 + (rest + (half_square + tail))) * power_of_two(half) * power_of_two(doublings - half)


def expm1_single(x: float) -> float:
    """e^x less one."""
    not_huge = chosen(x > 89.0, 89.0, x)
    given = chosen(not_huge < -105.0, -105.0, not_huge)
    doublings = (given * 1.4426950216293335 + 12582912.0) - 12582912.0
    high = given - doublings * 0.693145751953125
    low = doublings * 1.428606765330187e-06
    rest = high - low
    lost = (high - rest) - low
    square = rest * rest
    series = 0.1666666567325592 + rest * (0.04166649281978607 + rest * (0.008333547040820122 + rest * (0.0013932316796854138 + rest * 0.00019760899886023253)))
    half_square = 0.5 * square
    tail = lost + rest * (lost + square * series)
    not_many = chosen(doublings > 64.0, 64.0, doublings)
    few = chosen(not_many < -64.0, -64.0, not_many)
    scale = power_of_two(few)
    shifted = scale - 1.0
    kept = shifted + 1.0
    unshifted = (scale - kept) + ((kept - shifted) - 1.0)
    scaled = scale * rest
    total = shifted + scaled
    back = total - shifted
    lost_again = (shifted - (total - back)) + (scaled - back)
    near = total + (scale * half_square + (lost_again + (unshifted + scale * tail)))
    return near * power_of_two(doublings - not_many)
