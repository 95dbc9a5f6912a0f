"""Best polynomials: the error that theory gives, and coefficients of as many bits as are asked for."""

from fractions import Fraction

import mpmath
import pytest

from radartrack.derive.elementary import coefficients
from radartrack.derive.elementary.minimax import Sought, polynomial, rounded
from radartrack.derive.elementary.precision import DOUBLE, SINGLE, Precision


def largest_error(sought: Sought, found: tuple[float, ...]) -> float:
    low, high = sought.ends
    points = [low + (high - low) * i / 500 for i in range(501)]
    return float(max(abs(sought.weight(x) * (sought.function(x) - mpmath.polyval(found[::-1], x))) for x in points))


@pytest.mark.parametrize("degree", [1, 2, 3])
def test_of_the_next_power_what_is_left_is_chebyshev_s_polynomial(degree: int):
    """On an interval of length L, of x^n no more than 2 (L/4)^n is left."""
    sought = Sought(lambda x: x ** (degree + 1), lambda _: mpmath.mpf(1), (mpmath.mpf(1), mpmath.mpf(2)))
    assert largest_error(sought, polynomial(sought, degree, 53)) == pytest.approx(2 / 4 ** (degree + 1), rel=2e-3)


@pytest.mark.parametrize("bits", [12, 24, 53])
def test_rounded_coefficients_have_as_many_bits_and_cost_little(bits: int):
    sought = Sought(mpmath.exp, lambda _: mpmath.mpf(1), (-mpmath.mpf(1) / 3, mpmath.mpf(1) / 3))
    found = polynomial(sought, 2, bits)
    assert all(float(rounded(mpmath.mpf(value), bits)) == value for value in found)
    assert largest_error(sought, found) <= 1.3 * largest_error(sought, polynomial(sought, 2, 53)) + 2.0**-bits


@pytest.mark.parametrize("precision", [DOUBLE, SINGLE], ids=["double", "single"])
def test_parts_add_up_to_what_they_are_parts_of(precision: Precision):
    with mpmath.workprec(200):
        for parts, whole in (
            (coefficients.right_angle(precision), mpmath.pi / 2),
            (coefficients.doubling(precision), mpmath.log(2)),
        ):
            left = abs(whole - sum(map(mpmath.mpf, parts)))
            assert left <= abs(parts[-1]) * mpmath.mpf(2) ** -precision.bits
    *exact, _ = coefficients.right_angle(precision)
    for part in exact:
        assert Fraction(part).numerator.bit_length() <= precision.bits - precision.quarter_bits


def test_too_few_points_to_be_the_best_are_an_error():
    nothing = Sought(lambda _: mpmath.mpf(1), lambda _: mpmath.mpf(1), (mpmath.mpf(1), mpmath.mpf(2)))
    assert polynomial(nothing, 0, 53) == (1.0,)
