"""What the range rate adds: bounded in range, unbounded in the derivatives."""

from functools import cache

import pytest
import sympy

from radartrack.derive.finite_sample.least_squares_filter import C, FiniteSample, k
from radartrack.derive.finite_sample.range_rate_gain import Gain, limit

DEGREES = range(4)


@cache
def gain(degree: int) -> Gain:
    return Gain(FiniteSample(degree, with_rate=False), FiniteSample(degree, with_rate=True))


def is_positive_from(polynomial: sympy.Expr, first: int, *symbols: sympy.Symbol) -> bool:
    """Whether k ≥ first and C ≥ 0 leave only terms that are not negative, one of them a constant in C or k."""
    shifted = sympy.Poly(sympy.expand(polynomial.subs(k, k + first)), *symbols)
    return all(coefficient >= 0 for coefficient in shifted.coeffs()) and not shifted.is_zero


@pytest.mark.parametrize("degree", DEGREES)
def test_the_gain_is_one_minus_the_root_of_the_variance_ratio(degree: int) -> None:
    for n, entry in gain(degree).gain.items():
        ratio = gain(degree).variance_ratios[n]
        at = {k: sympy.Integer(11), C: sympy.Rational(3, 7)}
        assert abs(sympy.N(entry.subs(at) - 1 + sympy.sqrt(ratio.subs(at)), 40)) < 1e-38


@pytest.mark.parametrize("degree", DEGREES)
def test_the_least_upper_bound_of_the_range_gain_is_degree_over_degree_plus_one(degree: int) -> None:
    assert gain(degree).range_gain_bound == sympy.Rational(degree, degree + 1)


@pytest.mark.parametrize("degree", range(1, 4))
def test_no_sample_reaches_the_bound_of_the_range_gain(degree: int) -> None:
    """ρ − 1/(degree + 1)² is positive for every k from degree + 1 on and every C ≥ 0."""
    ratio = gain(degree).variance_ratios[0,]
    numerator, denominator = sympy.fraction(sympy.together(ratio - sympy.Rational(1, (degree + 1) ** 2)))
    assert is_positive_from(numerator, degree + 1, k, C)
    assert is_positive_from(denominator, degree + 1, k, C)


@pytest.mark.parametrize("degree", DEGREES)
def test_for_long_samples_the_gain_vanishes(degree: int) -> None:
    for ratio in gain(degree).variance_ratios:
        assert limit(ratio, k) == 1


@pytest.mark.parametrize("degree", range(1, 4))
def test_for_perfect_rates_derivatives_gain_everything(degree: int) -> None:
    ranges, *derivatives = gain(degree).variance_ratios
    assert all(limit(ratio, C) == 0 for ratio in derivatives)
    assert 0 < limit(ranges, C).subs(k, 10) < 1


def test_a_limit_that_does_not_exist_is_refused() -> None:
    with pytest.raises(ValueError, match="no finite limit"):
        limit((k**2 + C) / (k + 1), k)
