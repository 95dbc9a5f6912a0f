"""Quantiles of the chi-square distribution, for gates and for confidence intervals of variances."""

import math
from collections.abc import Callable

_STEPS = 200
_SMALL = 1e-300  # in place of a divisor that vanishes, as Lentz's algorithm has it
_MOST_TERMS = 100_000


def quantile(probability: float, degrees_of_freedom: float) -> float:
    """The value below which a chi-square variable falls with a given probability.

    Found by halving an interval of logarithms until it cannot be halved, from the smaller of both tails. For
    probabilities from 1e-12 to 1 - 1e-12 the relative error is below 1e-8 up to ten thousand degrees of freedom, and
    below 1e-7 up to a million.

    Args:
        probability: between 0 and 1, both excluded.
        degrees_of_freedom: positive; so many that the quantile is more than 1e-300.
    """
    if probability > 1 / 2:
        return upper_quantile(1 - probability, degrees_of_freedom)
    return _first(lambda value: _below(value, degrees_of_freedom) >= probability, degrees_of_freedom + 1.0)


def upper_quantile(probability: float, degrees_of_freedom: float) -> float:
    """The value above which a chi-square variable lies with a given probability, at most a half.

    Of a small one it keeps the digits, of which one less it has few.
    """
    return _first(lambda value: _above(value, degrees_of_freedom) <= probability, degrees_of_freedom + 1.0)


def _first(reached: Callable[[float], bool], start: float) -> float:
    """The least value at which a condition holds that holds from there on."""
    low, high = _SMALL, start
    while not reached(high):
        low, high = high, 2 * high
    for _ in range(_STEPS):
        middle = math.sqrt(low) * math.sqrt(high)
        if not low < middle < high:
            break
        low, high = (low, middle) if reached(middle) else (middle, high)
    return high


def _below(value: float, degrees_of_freedom: float) -> float:
    """The regularised incomplete gamma function by its power series, whose terms are all positive."""
    shape, half = degrees_of_freedom / 2, value / 2
    term = total = 1.0
    divisor = shape
    while term > total * 1e-17:
        divisor += 1
        term *= half / divisor
        total += term
    return total * math.exp(shape * math.log(half) - half - math.lgamma(shape + 1))


def _above(value: float, degrees_of_freedom: float) -> float:
    """One minus the same: beyond the middle by Legendre's continued fraction, whose parts are all positive."""
    shape, half = degrees_of_freedom / 2, value / 2
    if half < shape + 1:
        return 1 - _below(value, degrees_of_freedom)
    b = half + 1 - shape
    c, d = 1 / _SMALL, 1 / b
    fraction = d
    for n in range(1, _MOST_TERMS):
        a = -n * (n - shape)
        b += 2
        d = 1 / ((a * d + b) or _SMALL)
        c = (b + a / c) or _SMALL
        fraction *= c * d
        if abs(c * d - 1) <= 1e-16:
            break
    return fraction * math.exp(shape * math.log(half) - half - math.lgamma(shape))
