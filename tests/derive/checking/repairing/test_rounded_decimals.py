"""Decimals of a formula are compared at the digits that are printed."""

import math
from decimal import ROUND_DOWN, ROUND_HALF_EVEN, Decimal
from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from radartrack.derive.checking.asking import ask_identity
from radartrack.derive.checking.check import check

fractions = st.builds(Fraction, st.integers(1, 40), st.sampled_from([3, 6, 7, 9, 12, 24, 30]))


def _printed(value: Fraction, digits: int, how: str) -> str:
    number = Decimal(value.numerator) / Decimal(value.denominator)
    return str(number.quantize(Decimal(1).scaleb(number.adjusted() - digits + 1), how))


@given(fractions, st.integers(6, 16), st.sampled_from([ROUND_HALF_EVEN, ROUND_DOWN]))
def test_a_fraction_that_is_rounded_or_cut_off_is_equal_and_said_so(value: Fraction, digits: int, how: str) -> None:
    printed = _printed(value, digits, how)
    verdict = check(f"{value}*polar.map[0]", f"{printed}*r*cos(beta)")
    assert verdict.verdict == "equal"
    is_exact = Fraction(printed) == value
    assert bool(verdict.remarks) is not is_exact
    assert verdict.printed == f"{printed}*r*cos(beta)"


@given(fractions, st.integers(6, 14), st.sampled_from([2, -2, 30, -1000]))
def test_a_decimal_that_is_wrong_in_its_last_digits_differs(value: Fraction, digits: int, units: int) -> None:
    printed = Decimal(_printed(value, digits, ROUND_DOWN))
    digits_left = -int(printed.as_tuple().exponent)
    wrong = printed + units * Decimal(1).scaleb(-digits_left)
    assert check(f"{value}*polar.map[0]", f"{wrong}*r*cos(beta)").verdict == "differs"


@pytest.mark.parametrize(
    ("exact", "value"),
    [
        ("pi", math.pi),
        ("pi/180", math.pi / 180),
        ("2*pi/3", 2 * math.pi / 3),
        ("sqrt(2)", 2**0.5),
        ("sqrt(1/2)", 0.5**0.5),
    ],
)
@pytest.mark.parametrize("digits", [7, 10, 16, 17])
def test_a_multiple_of_pi_and_a_root_are_known_by_their_digits(exact: str, value: float, digits: int) -> None:
    formula = f"{value:.{digits}g}*r*cos(beta)"
    verdict = check(f"{exact}*polar.map[0]", formula)
    assert verdict.verdict == "equal"
    assert "is taken as" in verdict.remarks[0]


@pytest.mark.parametrize("printed", ["0.333", "0.33", "0.3", "0.34"])
def test_a_decimal_of_few_digits_is_no_fraction(printed: str) -> None:
    assert check("polar.map[0]/3", f"{printed}*r*cos(beta)").verdict == "differs"


def test_several_decimals_and_arrays_are_compared_together() -> None:
    verdict = check("polar.map/3", "[0.33333333*r*cos(beta), 0.666666667*r*sin(beta)/2.0]")
    assert verdict.verdict == "equal"
    assert check("polar.map/3", "[0.33333333*r*cos(beta), 0.666666667*r*sin(beta)]").verdict == "differs"


NUMBERS = {
    "chi2inv(0.99, 2)": 2 * math.log(100),
    "sqrt(2)/2": math.sqrt(2) / 2,
    "-pi^3": -(math.pi**3),
    "exp(-1/2)*1000": 1000 * math.exp(-0.5),
}


@pytest.mark.parametrize("number", NUMBERS)
@pytest.mark.parametrize("digits", [1, 2, 3, 7])
def test_a_decimal_alone_is_equal_to_the_number_that_it_rounds(number: str, digits: int) -> None:
    rounded = Decimal(NUMBERS[number]).quantize(Decimal(1).scaleb(-digits))
    assert ask_identity(number, f"{rounded}").is_equal
    for units in (-2, 2):  # cut off instead of rounded, a long decimal may be one unit less
        *_, verdict = ask_identity(number, f"{rounded + units * Decimal(1).scaleb(-digits)}").answers()
        assert verdict.verdict == "differs"


@pytest.mark.parametrize(("printed", "outcome"), [("4.33", "equal"), ("4.32", "differs"), ("-4.33", "differs")])
def test_a_quantity_at_a_point_is_the_decimal_that_it_rounds_to(printed: str, outcome: str) -> None:
    verdict = check("polar.map[0]", printed, given={"r": "5", "beta": "pi/6"})
    assert verdict.verdict == outcome
    assert verdict.printed == printed


def test_half_a_unit_may_be_rounded_either_way() -> None:
    for printed in ("0.2", "0.3"):
        assert ask_identity("1/4", printed).is_equal
    assert not ask_identity("1/4", "0.4").is_equal


@pytest.mark.parametrize(
    ("exact", "printed", "holds"),
    [
        ("7/20", "0.4", True),
        ("7/20", "0.3", False),
        ("-7/20", "-0.4", True),
        ("-7/20", "-0.3", False),
        ("-1/4", "-0.2", True),
        ("-1/4", "-0.3", True),
    ],
)
def test_half_a_unit_is_not_cut_off_to_an_odd_digit(exact: str, printed: str, holds: bool) -> None:
    assert ask_identity(exact, printed).is_equal is holds


def test_a_whole_number_is_no_rounded_one() -> None:
    assert not ask_identity("pi", "3").is_equal
