"""The finite-sample filter for a symbolic number of scans, and for numbers of scans against exact least squares."""

from fractions import Fraction
from functools import cache
from itertools import pairwise

import pytest
import sympy

from radartrack.derive.algebra.rational_function import is_zero
from radartrack.derive.finite_sample.least_squares_filter import (
    C,
    FiniteSample,
    fewest_scans,
    highest_degree,
    j,
    k,
    sigma_r,
    tau,
)
from radartrack.derive.language import matrix
from radartrack.derive.language.shared_symbols import T
from radartrack.derive.language.tensor import Tensor
from radartrack.derive.symbolic import Expr
from tests.least_squares import exact_fit, full_fit

FILTERS = [(degree, with_rate) for degree in range(4) for with_rate in (False, True)]
every_filter = pytest.mark.parametrize(("degree", "with_rate"), FILTERS)


@cache
def finite_sample(degree: int, *, with_rate: bool) -> FiniteSample:
    return FiniteSample(degree, with_rate)


def over_scans(polynomial: sympy.Expr) -> sympy.Expr:
    """The sum over j = 1 … k by Newton's formula, so that nothing is expanded: C(k, n + 1) times the nth difference."""
    differences = [polynomial.xreplace({j: sympy.Integer(scan)}) for scan in range(1, degree_bound(polynomial) + 2)]
    total = sympy.Integer(0)
    for n in range(len(differences)):
        total += sympy.ff(k, n + 1) / sympy.factorial(n + 1) * differences[0]
        differences = [after - before for before, after in pairwise(differences)]
    return total


def degree_bound(expression: sympy.Expr) -> int:
    """The degree in j, or more where terms cancel."""
    if not expression.has(j):
        return 0
    match expression:
        case sympy.Symbol():
            return 1
        case sympy.Add():
            return max(map(degree_bound, expression.args))
        case sympy.Mul():
            return sum(map(degree_bound, expression.args))
        case sympy.Pow(exp=sympy.Integer()) if expression.exp > 0:
            return degree_bound(expression.base) * int(expression.exp)
    raise AssertionError(f"{expression} is no polynomial in j")


@pytest.mark.parametrize("polynomial", [sympy.Integer(3), j, j**3 - k * j, (j - k) ** 2 * (j + C) ** 4])
def test_the_sum_over_scans_is_what_adding_up_gives(polynomial: sympy.Expr) -> None:
    for count in range(1, 9):
        added = sum(polynomial.subs({j: scan, k: count}) for scan in range(1, count + 1))
        assert is_zero(over_scans(polynomial).subs(k, count) - added)


def column(entries: Tensor[sympy.Expr]) -> Tensor[sympy.Expr]:
    return Tensor((len(entries.entries), 1), entries.entries)


def product(first: Tensor[Expr], second: Tensor[Expr]) -> Tensor[Expr]:
    shape = (first.shape[0], second.shape[1])
    found = matrix.product(matrix.rows(first), matrix.rows(second))
    return Tensor.build(shape, lambda m, n: found[m][n])


def transposed(of: Tensor[Expr]) -> Tensor[Expr]:
    return Tensor.build(of.shape[::-1], lambda m, n: of[n, m])


@every_filter
def test_covariance_times_information_is_the_identity_for_symbolic_k(degree: int, with_rate: bool) -> None:
    found = finite_sample(degree, with_rate=with_rate)
    for (m, n), entry in product(found.covariance, found.information).items():
        assert is_zero(entry - int(m == n))


@every_filter
def test_weights_reproduce_every_polynomial_for_symbolic_k(degree: int, with_rate: bool) -> None:
    found = finite_sample(degree, with_rate=with_rate)
    rows = Tensor((1, degree + 1), tuple(found.range_row()))
    slopes = Tensor((1, degree + 1), tuple(found.rate_row()))
    by_range = product(column(found.range_weights), rows)
    by_rate = product(column(found.rate_weights), slopes)
    for (m, n), entry in by_range.items():
        assert is_zero(over_scans(entry + by_rate[m, n]) - int(m == n))


@every_filter
def test_weights_give_back_the_covariance_for_symbolic_k(degree: int, with_rate: bool) -> None:
    found = finite_sample(degree, with_rate=with_rate)
    ranges, rates = column(found.range_weights), column(found.rate_weights)
    variance_of_rate = sigma_r**2 / (T**2 * C)
    by_range, by_rate = product(ranges, transposed(ranges)), product(rates, transposed(rates))
    for index, expected in found.covariance.items():
        noise = by_range[index] * sigma_r**2 + by_rate[index] * variance_of_rate
        assert is_zero(over_scans(noise) - expected)


@pytest.mark.parametrize("degree", range(4))
def test_without_weight_of_the_rate_the_expanding_memory_filter_remains(degree: int) -> None:
    with_rate, without = (finite_sample(degree, with_rate=rate) for rate in (True, False))
    for limit, expected in zip(with_rate.covariance, without.covariance, strict=True):
        assert is_zero(limit.xreplace({C: sympy.Integer(0)}) - expected)
    for limit, expected in zip(with_rate.range_weights, without.range_weights, strict=True):
        assert is_zero(limit.xreplace({C: sympy.Integer(0)}) - expected)


def test_degree_one_without_rate_has_the_classical_weights() -> None:
    """Those of the straight line through k values: 2(2(j − 1) − (k − 2))/(k(k + 1)) and the like, by hand."""
    value, slope = finite_sample(1, with_rate=False).range_weights
    assert is_zero(value - 2 * (3 * j - k - 1) / (k * (k + 1)))
    assert is_zero(slope - 6 * (2 * j - k - 1) / (T * k * (k**2 - 1)))


@pytest.mark.parametrize("degree", range(4))
def test_for_perfect_rates_ranges_fix_one_constant_and_nothing_else(degree: int) -> None:
    found = finite_sample(degree, with_rate=True)
    for (m, n), entry in found.covariance.items():
        limit = sympy.limit(entry.xreplace({k: sympy.Integer(7), T: sympy.Integer(3)}), C, sympy.oo)
        assert limit == (sigma_r**2 / 7 if m == n == 0 else 0)


@every_filter
def test_a_lag_moves_the_estimate_along_the_polynomial(degree: int, with_rate: bool) -> None:
    found = finite_sample(degree, with_rate=with_rate)
    rows = Tensor((1, degree + 1), tuple(found.range_row()))
    slopes = Tensor((1, degree + 1), tuple(found.rate_row()))
    by_range = product(column(found.lagged_range_weights), rows)
    by_rate = product(column(found.lagged_rate_weights), slopes)
    for (m, n), entry in by_range.items():
        moved = (tau * T) ** (n - m) / sympy.factorial(n - m) if n >= m else 0
        assert is_zero(over_scans(entry + by_rate[m, n]) - moved)


@every_filter
@pytest.mark.parametrize("count", [4, 5, 17])
def test_closed_forms_are_exact_least_squares(degree: int, with_rate: bool, count: int) -> None:
    found = finite_sample(degree, with_rate=with_rate)
    ratio = Fraction(7, 3) if with_rate else Fraction(0)
    period, lag = Fraction(5, 2), Fraction(-4, 3)
    at = {
        k: count,
        C: sympy.Rational(ratio / period**2),
        T: sympy.Rational(period),
        sigma_r: 1,
        tau: sympy.Rational(lag),
    }
    newest, lagged = (full_fit(count, degree, period, ratio, moved) for moved in (Fraction(0), lag))
    for fit, covariance, weights in (
        (newest, found.covariance, (found.range_weights, found.rate_weights)),
        (lagged, found.lagged_covariance, (found.lagged_range_weights, found.lagged_rate_weights)),
    ):
        for (m, n), entry in covariance.items():
            assert entry.subs(at) == sympy.Rational(fit.covariance[m][n])
        for formulas, expected in zip(weights, (fit.range_weights, fit.rate_weights), strict=True):
            for m, entry in enumerate(formulas):
                for scan in (1, 2, count):
                    assert entry.subs(at | {j: scan}) == sympy.Rational(expected[m][scan - 1])


def test_the_published_covariance_of_range_and_acceleration_is_right() -> None:
    """Gorshkov & Zavizhenets, (11), as printed; and what belongs before the printed denominator of (12)."""
    covariance = finite_sample(2, with_rate=True).covariance
    denominator = k * (k + 1) * (60 * C + k**2 - 4)
    assert is_zero(covariance[0, 2] - 60 * (k - 2) * sigma_r**2 / (T**2 * denominator))
    assert is_zero(covariance[1, 2] - 360 * sigma_r**2 / (T**3 * denominator))


@pytest.mark.parametrize("degree", range(4))
@pytest.mark.parametrize("with_rate", [False, True])
def test_the_fewest_scans_are_those_with_regular_normal_equations(degree: int, with_rate: bool) -> None:
    fewest = fewest_scans(degree, with_rate=with_rate)
    ratio = Fraction(1, 2) if with_rate else Fraction(0)
    full_fit(fewest, degree, Fraction(1), ratio)
    assert highest_degree(fewest, with_rate=with_rate) >= degree
    if fewest > 1:
        assert highest_degree(fewest - 1, with_rate=with_rate) < degree
        with pytest.raises(ZeroDivisionError):
            full_fit(fewest - 1, degree, Fraction(1), ratio)


def test_two_values_about_one_slope_do_not_determine_a_parabola() -> None:
    """Counting data is not enough where observations are missing: s² − 1 passes unseen."""
    times = [Fraction(n) for n in (-1, 0, 1)]
    with pytest.raises(ZeroDivisionError):
        exact_fit(times, 2, with_range=[True, False, True], with_rate=[False, True, False], squared_ratio=Fraction(1))


def test_any_degree_can_be_derived() -> None:
    found = FiniteSample(5, with_rate=False)
    expected = full_fit(8, 5, Fraction(1), Fraction(0)).covariance
    for (m, n), entry in found.covariance.items():
        assert entry.subs({k: 8, T: 1, sigma_r: 1}) == sympy.Rational(expected[m][n])
