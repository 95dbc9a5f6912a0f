"""The two blocks together are the inverse of the information summed scan by scan."""

from fractions import Fraction
from math import factorial

import pytest
import sympy

from radartrack.derive import symbolic as sp
from radartrack.derive.finite_sample.centred_filter import CentredFilter
from radartrack.derive.finite_sample.least_squares_filter import RING, C, j, k, tau

COUNT, WEIGHT, SCAN, TIME = 9, sympy.Rational(7, 3), sympy.Rational(-2), sympy.Rational(5, 4)
AT = {k: sympy.Integer(COUNT), C: WEIGHT, j: SCAN, tau: TIME}

every_size = pytest.mark.parametrize("size", [1, 2, 3, 5, 6])
with_and_without_rate = pytest.mark.parametrize("weight", [sympy.Integer(0), WEIGHT], ids=["ranges", "rates too"])


def state(time: sympy.Rational, size: int, derivative: int = 0) -> list[sympy.Rational]:
    """That derivative of every t^n/n!."""
    return [time ** (n - derivative) / factorial(n - derivative) if n >= derivative else 0 for n in range(size)]


def scan_by_scan(size: int, weight: sympy.Rational) -> sympy.Matrix:
    total = sympy.zeros(size, size)
    for scan in range(COUNT):
        time = sympy.Rational(Fraction(2 * scan + 1 - COUNT, 2))
        row, slope = (sympy.Matrix(state(time, size, derivative)) for derivative in (0, 1))
        total += row * row.T + weight * slope * slope.T
    return total.inv()


def centred(size: int, weight: sympy.Rational) -> CentredFilter:
    return CentredFilter(RING, k, size, RING.from_expr(C) if weight else RING.zero)


def moved(size: int) -> sympy.Matrix:
    return sympy.Matrix([state(TIME, size, derivative) for derivative in range(size)])


@every_size
@with_and_without_rate
def test_covariance_is_the_inverse_information_at_any_time(size: int, weight: sympy.Rational) -> None:
    found = centred(size, weight).covariance(RING.from_expr(tau))
    expected = moved(size) * scan_by_scan(size, weight) * moved(size).T
    assert [entry.xreplace(AT) for entry in found] == list(expected)


@every_size
@with_and_without_rate
@pytest.mark.parametrize("derivative", [0, 1], ids=["of a value", "of a rate"])
def test_weights_are_those_of_least_squares_at_any_time(size: int, weight: sympy.Rational, derivative: int) -> None:
    found = centred(size, weight).weights(RING.from_expr(tau), RING.from_expr(j), derivative)
    measured = sympy.Matrix(state(SCAN, size, derivative))
    assert [entry.xreplace(AT) for entry in found] == list(moved(size) * scan_by_scan(size, weight) * measured)


def test_numerators_and_denominators_are_factored_in_lowest_terms() -> None:
    newest = RING.from_expr(sp.expand((k - 1) / 2))
    found = centred(2, sympy.Integer(0)).covariance(newest)
    assert [found[0, 0], found[0, 1], found[1, 1]] == [
        2 * (2 * k - 1) / (k * (k + 1)),
        6 / (k * (k + 1)),
        12 / (k * (k - 1) * (k + 1)),
    ]
