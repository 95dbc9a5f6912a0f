"""Closed power sums, against adding up, and against the step from one count to the next for every count."""

import pytest
import sympy

from radartrack.derive.finite_sample.power_sums import power_sum, summed

K = sympy.Symbol("k", positive=True)
I = sympy.Symbol("i")  # noqa: E741 - the index of a sum
EXPONENTS = range(9)


@pytest.mark.parametrize("exponent", EXPONENTS)
def test_power_sums_are_what_adding_up_gives(exponent: int) -> None:
    for count in range(1, 30):
        added = sum(i**exponent for i in range(count))
        assert power_sum(exponent, K).subs(K, count) == added


@pytest.mark.parametrize("exponent", EXPONENTS)
def test_one_more_term_adds_its_power_for_a_symbolic_count(exponent: int) -> None:
    closed = power_sum(exponent, K)
    assert sympy.expand(closed.subs(K, K + 1) - closed - K**exponent) == 0
    assert closed.subs(K, 0) == 0


def test_a_polynomial_with_other_symbols_is_summed_term_by_term() -> None:
    a = sympy.Symbol("a")
    closed = summed((a * I - 2) ** 3 / a, I, K)
    assert sympy.expand(closed.subs(K, 7) - sum((a * i - 2) ** 3 / a for i in range(7))) == 0
