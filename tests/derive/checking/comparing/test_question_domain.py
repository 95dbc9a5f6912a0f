"""Points of comparison lie in the domain of their question, and verdicts are about that."""

import re
from collections.abc import Mapping
from math import inf, pi

import pytest

from radartrack.derive import check
from radartrack.derive.catalogue import catalogue
from radartrack.derive.checking.asking import ask
from radartrack.derive.checking.comparing.question_domain import Domain
from radartrack.derive.checking.question.compared_quantity import refer
from radartrack.derive.checking.reporting.derived_formula import shown
from radartrack.derive.checking.reporting.verdict import Outcome
from radartrack.derive.language.quantity import Quantity
from radartrack.derive.language.variable import Variable
from radartrack.derive.units import ONE
from tests.derive.checking.own_values import inside

FRACTION = Variable("x", "a symbol", ONE, -0.5, 0.5)
REALS = [(1e-9, 1e-3), (50.0, 60.0), (-7.0, -6.5), (0.0, 0.01)]
WHOLE = [(2.0, 3.0), (9.0, 1e6)]
NARROW = [
    Variable("x", "a symbol", ONE, low, high, whole=whole)
    for ranges, whole in ((REALS, False), (WHOLE, True))
    for low, high in ranges
]


def _distinct(quantities: Mapping[str, Quantity]) -> list[Quantity]:
    """One quantity for each set of symbols."""
    return list({tuple((s.name, s.low, s.high) for s in one.symbols): one for one in quantities.values()}.values())


@pytest.mark.parametrize("quantity", _distinct(catalogue()), ids=lambda quantity: quantity.name)
def test_every_point_of_comparison_is_inside_the_domain_and_whole_numbers_are_whole(quantity: Quantity) -> None:
    points = Domain(quantity.symbols).sample()
    assert len(points) > 20 or not any(symbol.low < symbol.high for symbol in quantity.symbols)
    assert all(inside(quantity.symbols, point) for point in points)
    assert all(list(point) == [symbol.name for symbol in quantity.symbols] for point in points)


@pytest.mark.parametrize("symbol", NARROW, ids=lambda symbol: f"{symbol.low:g} to {symbol.high:g}")
def test_points_stay_inside_narrow_domains(symbol: Variable) -> None:
    points = Domain([symbol]).sample()
    assert points
    assert all(inside([symbol], point) for point in points)


def test_angles_and_speeds_are_compared_in_all_directions_and_on_all_scales() -> None:
    points = Domain(catalogue()["observe.polar_doppler.map"].symbols).sample()
    quadrants = {(point["x"] > 0, point["y"] > 0, point["vx"] > 0) for point in points}
    assert len(quadrants) == 8
    assert any(abs(point["y"] / point["x"]) > 100 for point in points)
    assert any(abs(point["x"] / point["y"]) > 100 for point in points)


def test_a_symbol_never_exceeds_what_bounds_it_where_a_condition_sets_that() -> None:
    question = ask("finite_sample.degree1.range.design[0,1]", "T*(j - k)", given={"k": "5"})
    points = question.domain.sample()
    assert {point["j"] for point in points} == {1, 2, 3, 4, 5}
    assert question.finding((0,) if question.reference.shape else ()).outcome is Outcome.EQUAL


@pytest.mark.parametrize("order", [1, -1])
def test_where_several_quantities_are_compared_the_number_of_scans_is_as_large_as_all_of_them_ask(order: int) -> None:
    names = [f"finite_sample.degree{degree}.range.covariance[0,0]" for degree in (1, 3)]
    question = ask(" + ".join(names[::order]), "sigma_r**2")
    assert min(point["k"] for point in question.domain.sample()) == 4


def test_where_a_condition_sets_a_symbol_to_a_formula_that_stays_in_its_domain_too() -> None:
    question = ask("finite_sample.degree1.range_rate.covariance[0,0]", "sigma_r**2*C", given={"k": "C"})
    points = question.domain.sample()
    assert points
    assert all(point["C"].is_integer() and point["C"] >= 2 for point in points)


# Each differs from what is derived outside the domain alone: at fractions of whole numbers, beyond an end.
RIGHT_INSIDE = [
    ("finite_sample.degree1.range.covariance[0,0]", "sigma_r**2*(4*k-2)/(k*(k+1))*cos(2*pi*k)"),
    ("finite_sample.degree1.range.covariance[0,0]", "sigma_r**2*(4*k-2)/(k*(k+1)) + sigma_r**2*sin(pi*k)"),
    ("finite_sample.degree1.range.design[0,1]", "T*(j - k)*cos(2*pi*j)"),
    ("finite_sample.degree1.range.design[0,1]", "-T*abs(j - k)"),
    ("finite_sample.degree2.range.covariance[0,0]", "3*sigma_r**2*(3*k**2 - 3*k + 2)/(k*(k + 1)*(abs(k - 3) + 5))"),
    ("spherical.map[2]", "r*asin(sin(epsilon))/epsilon*sin(epsilon)"),
    ("spherical.map[0]", "r*sin(beta)*sqrt(cos(epsilon)**2)"),
    ("polar.map[0]", "r*cos(acos(cos(beta)))*acos(cos(beta))/abs(beta)"),
    ("ruv.map[0]", "r*u*sqrt(1 - u**2)/sqrt((1 - u)*(1 + u))"),
    ("ruv.map[0]", "r*sin(u)*u/sqrt(1 - cos(u)**2)*abs(u)/u"),
    ("polar.jacobian[0,0]", "cos(beta)*sqrt(1 - cos(beta))*sqrt(1 + cos(beta))/abs(sin(beta))"),
]  # fmt: skip


@pytest.mark.parametrize(("name", "formula"), RIGHT_INSIDE)
def test_what_differs_outside_the_domain_alone_is_not_called_different(name: str, formula: str) -> None:
    assert check(name, formula).is_equal


# Intermediate values are complex and the result is real, with another sign or size on a part of the domain.
ANOTHER_BRANCH = [
    ("observe.ruv.map[0]", "x/sqrt(x**2 + y**2 + z**2)*sqrt(cos(x/(1 + y**2)))*sqrt(1/cos(x/(1 + y**2)))"),
    ("finite_sample.degree1.gain[0]*0 + C/k", "C/k*atan(tan(k/(1 + C**2)))/(k/(1 + C**2))"),
    ("polar.map[0]", "r*cos(beta)*sqrt(cos(beta))*sqrt(1/cos(beta))"),
    ("spherical.map[2]", "r*sin(epsilon)*sqrt(1/sin(epsilon))*sqrt(sin(epsilon))"),
    ("polar_doppler.map[2]", "r*rdot**(3/2)/log(exp(rdot**(1/2)))"),
    ("polar.map[0]", "r*abs(sqrt(cos(beta)))**2"),
    ("polar.map[0]", "r*sqrt(cos(beta))*sqrt(cos(beta)**3)/cos(beta)"),
    ("polar.map[1]", "r*sqrt(sin(beta) - 2)*sqrt(1/(sin(beta) - 2))*sin(beta)"),
    ("observe.polar.map[1]", "atan2(y*sqrt(x)*sqrt(1/x), x)"),
    ("observe.polar.map[1]", "atan2(y, x)*sqrt(y)*sqrt(1/y)"),
    ("observe.polar.map[0]", "sqrt(x**2 + y**2)*sqrt(x)*sqrt(y)/sqrt(x*y)"),
    ("polar.map[0]", "r*cos(beta)*(cos(beta)**3)**(1/3)/cos(beta)*abs((cos(beta)**3)**(1/3))/abs(cos(beta))"),
    ("polar.map[0]", "r*cos(beta)*log(cos(beta)**2)/log(cos(beta))/2"),
    ("finite_sample.degree1.range.design[0,1]", "T*(j - k)*sqrt(j - k - 1)*sqrt(1/(j - k - 1))"),
]  # fmt: skip


@pytest.mark.parametrize(("name", "formula"), ANOTHER_BRANCH)
def test_what_is_right_on_one_branch_alone_differs_and_the_example_is_on_the_other(name: str, formula: str) -> None:
    verdict = check(name, formula)
    assert verdict.verdict in {Outcome.DIFFERS, Outcome.WRONG_DIMENSIONS}
    assert verdict.counterexample is not None
    assert inside(ask(name, formula).symbols, verdict.counterexample.point)


@pytest.mark.parametrize(
    ("name", "formula"),
    [
        ("polar.map[0]", "r*cos(beta)*(1/(sin(beta)**2 + cos(beta)**2 - 1) + 1)"),
        ("polar.map[0]", "r*cos(beta)*(sqrt(1 + 2*exp(-r) + exp(-2*r)) - 1)/exp(-r)"),
        ("polar.map[0]", "r*cos(beta)*asin(sin(beta)**2 + cos(beta)**2)*2/pi"),
        ("polar.map[0]", "r*cos(beta)*(1 + (sin(beta)**2 + cos(beta)**2 - 1)**(1/8))"),
        ("polar.map[0]", "r*cos(beta)*sqrt((-1)**3*(sin(beta)**2 + cos(beta)**2))**2*(-1)"),
        ("polar.map[0]", "r*cos(beta) + atan2(sin(beta)**2 + cos(beta)**2 - 1, -1) - pi"),
    ],
)  # fmt: skip
def test_what_rounding_alone_would_tell_is_never_called_different(name: str, formula: str) -> None:
    assert check(name, formula).counterexample is None


def test_where_the_printed_formula_has_no_value_the_share_of_the_points_is_said() -> None:
    found = check("finite_sample.degree1.range.design[0,1]", "T*(j - k)*cos(2*pi*k)*tan(j - 1)*cot(j - 1)")
    assert found.verdict is Outcome.UNDECIDED
    share = re.fullmatch(r"equal to 50 digits at (\d+) of (\d+) points; at the others it has no value", found.reason)
    assert share
    assert 0 < int(share[1]) < int(share[2])


@pytest.mark.parametrize(
    ("name", "factor"),
    [
        ("finite_sample.degree1.range_rate.covariance[0,1]", "atan2(C, C)*4/pi"),
        ("finite_sample.degree1.range_rate.at_lag.covariance[0,1]", "2 - 4*atan2(C, C)/pi"),
        ("observe.polar.map[1]", "atan2(x**2, x**2)*4/pi"),
    ],
)
def test_where_a_printed_angle_has_no_direction_nothing_is_compared(name: str, factor: str) -> None:
    formula = {"polar.map[0]": "r*cos(beta)", "observe.polar.map[1]": "atan2(y, x)"}.get(name) or check(
        name, "1"
    ).derived
    found = check(name, f"({formula})*({factor})")
    assert found.verdict is (Outcome.UNDECIDED if "C" in factor else Outcome.EQUAL_NUMERICALLY)
    assert "C" not in factor or "at the others it has no value" in found.reason


def test_an_angle_that_is_derived_needs_no_direction_either() -> None:
    assert check("observe.polar.map[1]", "atan2(2*y, 2*x)").verdict in {Outcome.EQUAL, Outcome.EQUAL_NUMERICALLY}


def test_limits_are_those_of_the_variables() -> None:
    assert not Domain([FRACTION]).contains({"x": 0.6})
    assert Domain([FRACTION]).contains({"x": 0.5})
    assert not Domain([FRACTION]).contains({"x": inf})
    assert not Domain([FRACTION]).contains({"x": pi})


ENDS_IN_A_CORNER = [
    ("polar_doppler.covariance.linear[0,0]", "atan(tan(sigma_beta - rho))/(sigma_beta - rho)"),
    ("polar_doppler.covariance.linear[0,0]", "asin(sin(sigma_beta + rho))/(sigma_beta + rho)"),
    ("spherical.covariance.linear[2,2]", "atan(tan(sigma_beta + sigma_epsilon))/(sigma_beta + sigma_epsilon)"),
    ("spherical.covariance.linear[2,2]", "asin(sin(rho - sigma_beta))/(rho - sigma_beta)"),
    ("polar.covariance.linear[0,0]", "sqrt((1.9 + rho - sigma_beta)**2)/(1.9 + rho - sigma_beta)"),
    ("polar.covariance.linear[0,0]", "abs(2.9 - rho**2 - 2*sigma_beta)/(2.9 - rho**2 - 2*sigma_beta)"),
]


@pytest.mark.parametrize(("entry", "factor"), ENDS_IN_A_CORNER)
def test_what_is_right_but_in_a_corner_differs_and_nothing_as_wrong_is_suggested(entry: str, factor: str) -> None:
    verdict = check(entry, f"({shown(refer(entry).entries)})*{factor}")
    assert verdict.verdict == "differs", verdict.reason
    assert verdict.counterexample is not None
    assert not [one.formula for one in verdict.suggestions if factor in one.formula]
