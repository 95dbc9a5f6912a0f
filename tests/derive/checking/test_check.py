import math
import re
from collections.abc import Mapping
from fractions import Fraction

import pytest

from radartrack.derive import check
from radartrack.derive.catalogue import UnknownQuantity
from radartrack.derive.checking.conventions import other_quantity
from radartrack.derive.checking.conventions.altered_question import Point
from radartrack.derive.checking.question.compared_quantity import UnknownEntry, refer
from radartrack.derive.checking.reporting.derived_formula import shown
from radartrack.derive.checking.reporting.verdict import Outcome, Verdict
from radartrack.derive.formula.error import FormulaError
from radartrack.derive.language.quantity import Quantity
from radartrack.derive.units import METRE
from tests.effort import at_most

LINEAR = "r**2*sigma_beta**2*sin(beta)**2 + sigma_r**2*cos(beta)**2"
INDEPENDENT = {"rho": "0"}


def test_a_formula_that_is_right_is_proved_equal() -> None:
    verdict = check("polar.covariance.linear[0,0]", LINEAR, given=INDEPENDENT)
    assert verdict.verdict is Outcome.EQUAL
    assert verdict.counterexample is None
    assert verdict.suggestions == ()
    assert verdict.conditions == ("rho = 0",)


def test_a_formula_that_is_right_under_a_condition_only_differs_and_is_told_so() -> None:
    verdict = check("polar.covariance.linear[0,0]", LINEAR)
    assert verdict.verdict is Outcome.DIFFERS
    assert "equal when rho = 0" in verdict.remarks


def test_the_printed_forms_of_equation_11_are_proved() -> None:
    attenuated = "exp(-2*sigma_beta**2)*(cos(beta)**2*({c}cosh(2*sigma_beta**2) - cosh(sigma_beta**2))"
    attenuated += " + sin(beta)**2*({c}sinh(2*sigma_beta**2) - sinh(sigma_beta**2)))"
    formula = f"r**2*{attenuated.format(c='')} + sigma_r**2*{attenuated.format(c='2*')}"
    assert check("polar.covariance.averaged[0,0]", formula, given=INDEPENDENT).verdict is Outcome.EQUAL


def test_a_counterexample_is_what_anyone_computes_at_that_point() -> None:
    verdict = check("polar.bias.second_order[0]", "-r*cos(beta)*sigma_beta**2", given=INDEPENDENT)
    example = verdict.counterexample
    assert example is not None
    r, beta, sigma = (example.point[name] for name in ("r", "beta", "sigma_beta"))
    assert r == 5e4
    assert beta == math.radians(30)
    assert sigma == math.radians(1)
    assert example.printed == pytest.approx(-r * math.cos(beta) * sigma**2)
    assert example.derived == pytest.approx(-r * math.cos(beta) * sigma**2 / 2)
    assert example.relative_difference == pytest.approx(1)
    assert example.largest_relative_difference == pytest.approx(1)


def test_a_difference_that_is_tiny_at_the_usual_point_is_shown_where_it_matters() -> None:
    formula = "r**2*sigma_beta**2*sin(beta)**2 + sigma_r**2*cos(beta)**2 + sigma_r**2*sigma_beta**2"
    example = check("polar.covariance.linear[0,0]", formula, given=INDEPENDENT).counterexample
    assert example is not None
    assert example.relative_difference is not None
    assert example.relative_difference > 0.01


@pytest.mark.parametrize(
    ("name", "formula", "order"),
    [
        ("polar.bias.averaged[0]", "-r*sigma_beta**2/2*cos(beta)", (4, 2)),
        ("polar.bias.second_order[0]", "-r*sigma_beta**2*cos(beta)", (2, 2)),
        ("polar.covariance.truth[0,0]", LINEAR, (4, 2)),
        ("polar.unbiased.estimate[0]", "r*cos(beta)", (2, 0)),
        ("polar.map[0]", "r*sin(beta)", None),
    ],
)
def test_the_order_of_the_difference_tells_an_approximation_from_a_misprint(
    name: str, formula: str, order: tuple[int, int] | None
) -> None:
    given = INDEPENDENT if "map" not in name else None
    assert check(name, formula, given=given).order == order


def test_another_quantity_that_the_formula_equals_is_named() -> None:
    formula = "[r*cos(beta)*(exp(-sigma_beta**2/2) - 1), r*sin(beta)*(exp(-sigma_beta**2/2) - 1)]"
    verdict = check("polar.bias.averaged", formula, given=INDEPENDENT)
    assert "this is polar.bias.truth, not polar.bias.averaged" in _edits(verdict)


def test_the_negative_of_another_quantity_is_named() -> None:
    verdict = check("polar.bias.averaged[0]", "r*sigma_beta**2*cos(beta)/2", given=INDEPENDENT)
    assert "this is -polar.bias.second_order[0], not polar.bias.averaged[0]" in _edits(verdict)


def test_a_number_is_not_taken_for_another_quantity() -> None:
    assert not any(edit.startswith("this is") for edit in _edits(check("polar.jacobian[0,0]", "1")))


def test_a_missing_term_is_named_and_a_zero_that_stood_for_it_is_gone() -> None:
    twice = "-r*(1 - exp(-sigma_beta^2/2))*cos(beta) - rho^2*r"
    (lost, *_) = check("polar.bias.truth[0] - r*rho**2", twice).suggestions
    assert lost.formula.endswith(" - sigma_r*sigma_beta*rho*sin(beta)*exp(-sigma_beta**2/2)")
    (whole, *_) = check("polar.covariance.linear[0,1]", "0", given=INDEPENDENT).suggestions
    assert whole.formula == "(-r**2*sigma_beta**2/2 + sigma_r**2/2)*sin(2*beta)"


@pytest.mark.parametrize(
    ("name", "printed"),
    [("motion.ctrv.jacobian[0,2]", "1"), ("observe.spherical.jacobian[0,0]", "1"), ("polar.hessian[0,0,1]", "2")],
)
def test_a_number_alone_is_not_corrected_by_all_of_the_derived_formula(name: str, printed: str) -> None:
    verdict = check(name, printed)
    assert verdict.verdict in {Outcome.DIFFERS, Outcome.WRONG_DIMENSIONS}
    assert verdict.suggestions == ()
    assert verdict.derived


def test_the_whole_derived_formula_is_no_edit_of_the_printed_one() -> None:
    verdict = check("polar.bias.averaged[0]", "-r*sigma_beta**2/2*cos(beta)", given=INDEPENDENT)
    assert _edits(verdict) == ["this is polar.bias.second_order[0], not polar.bias.averaged[0]"]


def test_a_formula_is_suggested_once_however_it_is_written() -> None:
    printed = "sigma_r**2*cos(beta)**2 - 2*r*rho*sigma_r*sigma_beta*sin(beta)*cos(beta)"
    edits = _edits(check("polar.covariance.linear[0,0]", printed))
    assert sum(edit.startswith("a missing term") for edit in edits) == 1


def test_a_slip_in_a_formula_without_correlation_is_found_though_nobody_said_so() -> None:
    verdict = check("polar_doppler.covariance.linear[2,2]", "r**2*sigma_rdot**2 + rdot*sigma_r**2")
    assert _edits(verdict)[0] == "rdot should be rdot**2 when rho = 0"
    assert verdict.suggestions[0].formula == "r**2*sigma_rdot**2 + rdot**2*sigma_r**2"
    assert verdict.suggestions[0].proved


def test_a_missing_term_is_suggested_once_whatever_the_signs_around_it() -> None:
    name, right = "polar.covariance.averaged[0,0]", "cosh(2*s) - cosh(s)"
    entry = (
        f"exp(-2*s)*(r**2*(cos(beta)**2*({right}) + sin(beta)**2*(sinh(2*s) - sinh(s)))"
        f" + sigma_r**2*(cos(beta)**2*({right} + cosh(2*s)) + sin(beta)**2*(2*sinh(2*s) - sinh(s))))"
    )
    let = {"s": "sigma_beta**2"}
    assert check(name, entry, given=INDEPENDENT, let=let).verdict is Outcome.EQUAL
    edits = _edits(check(name, entry.replace(f"{right} + cosh(2*s)", right), given=INDEPENDENT, let=let))
    assert edits.count("a missing term cosh(2*s)") == 1


def test_another_entry_of_the_same_quantity_is_named() -> None:
    verdict = check("polar.covariance.linear[1,1]", LINEAR, given=INDEPENDENT)
    assert any("polar.covariance.linear[0,0]" in edit for edit in _edits(verdict))


@pytest.mark.parametrize(
    ("name", "formula", "edit"),
    [
        ("polar.bias.second_order[0]", "r*sigma_beta**2*cos(beta)/2", "the sign"),
        ("polar.bias.second_order[0]", "-r*sigma_beta**2*cos(beta)", "a missing factor 1/2"),
        ("polar.bias.second_order[0]", "-r*sigma_beta**2*cos(beta)/3", "3 should be 2"),
        ("polar.bias.second_order[0]", "-sigma_beta**2*cos(beta)/2", "a missing factor r"),
        ("polar.bias.second_order[0]", "-r*sigma_beta*cos(beta)/2", "sigma_beta should be sigma_beta**2"),
        ("polar.bias.second_order[0]", "-r*sigma_beta**3*cos(beta)/2", "3 should be 2"),
        ("polar.bias.second_order[0]", "-r*sigma_beta**2*cos(beta)*sin(beta)/2", "an extra factor: sin(beta)"),
        ("polar.bias.second_order[0]", "-r*sigma_beta**2*sin(beta)/2", "sin should be cos"),
        ("polar.covariance.linear[0,0]", LINEAR.replace("**2*s", "*s", 1), "r should be r**2"),
        ("polar.covariance.linear[0,0]", LINEAR.replace("sigma_r", "r"), "r should be sigma_r"),
        ("polar.covariance.linear[0,0]", "r**2*sigma_beta**2*sin(beta)**2", "a missing term"),
        ("polar.covariance.linear[0,0]", f"{LINEAR} + r**2*sigma_beta**4", "an extra term"),
        ("polar.covariance.linear[0,0]", "r**2*sigma_beta**2*sin(beta**2) + sigma_r**2*cos(beta)**2", "a bracket"),
        ("polar.bias.truth[0]", "r*cos(beta)*exp(-sigma_beta**2/2) - 1", "a bracket"),
        ("polar.unbiased.estimate[0]", "r*cos(beta)*exp(-sigma_beta**2/2)", "the sign"),
        ("polar.jacobian[0,1]", "-r*cos(beta)", "cos should be sin"),
        ("polar.jacobian[0,0]", "cosh(beta)", "cosh should be cos"),
        ("finite_sample.degree2.range_rate.design[0,2]", "T**2*((j - k)/3)**2/2", "an extra divisor: 3"),
        (
            "finite_sample.degree2.range_rate.covariance[0,2]",
            "60*(k - 2)*sigma_r**2/(T**2*k*(k + 1)*(60*C + k**2 + 4))",
            "the sign of 4",
        ),
        (
            "finite_sample.degree2.range_rate.covariance[0,2]",
            "60*(k - 2)*sigma_r**2/(T*k*(k + 1)*(60*C + k**2 - 4))",
            "T should be T**2",
        ),
        ("observe.polar.map[1]", "atan2(y, x)/2", "an extra divisor: 2"),
        ("observe.polar.map[1]", "atan2(y, x*y)", "an extra factor: y"),
        ("polar.bias.second_order[0]", "-r*sigma_beta**2*cos(7*beta)/2", "an extra factor: 7"),
        ("observe.polar.jacobian[1,0]", "y/(x**2 + y**2)", "the sign"),
        ("fusion.weights.two[0]", "sigma_1**2/(sigma_1**2 + sigma_2**2)", "sigma_1 should be sigma_2"),
        ("polar.covariance.linear[0,0]", "0", "a missing term r**2*sigma_beta**2*sin(beta)**2"),
        ("polar.covariance.linear[0,1]", "(sigma_r**2 - r**2*sigma_beta**2)*sin(beta)", "a missing factor cos(beta)"),
        ("ruv.map[2]", "r*(1 - u**2 - v**2)", "a missing root: sqrt(1 - u**2 - v**2)"),
        ("observe.polar.map[0]", "x**2 + y**2", "a missing root: sqrt(x**2 + y**2)"),
        ("ruv.map[2]", "r*sqrt(1) - u**2 - v**2", "a bracket"),
        ("observe.polar.map[0]", "sqrt(x**2) + y**2", "a bracket"),
        ("polar.bias.averaged[0]", "r*cos(beta)*(exp(-sigma_beta**2) - exp(-sigma_beta**2)/2)", "a bracket"),
        ("polar.covariance.linear[0,1]", "(sigma_r**2 - r**2*sigma_beta**2)/2*2*sin(beta)", "a missing factor cos"),
        ("observe.bistatic.map[0]", "sqrt(x**2 + y**2) + sqrt((x + baseline)**2 + y**2)", "the sign of baseline"),
        ("taylor.mean_shift", "1/2*(f_xx*D_1 + 2*f_xy*K_12 + f_yy*D_1)", "D_1 should be D_2"),
    ],
)
def test_the_smallest_edit_that_makes_it_right_comes_first(name: str, formula: str, edit: str) -> None:
    given = INDEPENDENT if name.startswith("polar.") and "jacobian" not in name else None
    verdict = check(name, formula, given=given)
    assert verdict.verdict in {Outcome.DIFFERS, Outcome.WRONG_DIMENSIONS}
    assert any(said.startswith(edit) for said in _edits(verdict)[:3]), _edits(verdict)
    assert all(one.proved for one in verdict.suggestions)


def test_every_suggestion_is_itself_found_equal() -> None:
    verdict = check("polar.bias.second_order[0]", "r*sigma_beta**3*cos(beta)/2", given=INDEPENDENT)
    for suggestion in verdict.suggestions:
        assert check("polar.bias.second_order[0]", suggestion.formula, given=INDEPENDENT).is_equal


def test_what_cannot_be_read_is_not_suggested() -> None:
    name, formula = "finite_sample.degree0.range.covariance[0,0]", "((sigma_r**3)**3)**2/k"
    suggestions = check(name, formula).suggestions  # not ((sigma_r**3)**3)**(2/9)/k
    assert suggestions
    assert all(check(name, one.formula).is_equal for one in suggestions)


def test_only_quantities_of_the_printed_dimension_and_symbols_are_derived(monkeypatch: pytest.MonkeyPatch) -> None:
    asked: list[Quantity] = []
    values = other_quantity._values

    def noted(quantity: Quantity, point: Point) -> object:
        asked.append(quantity)
        return values(quantity, point)

    monkeypatch.setattr(other_quantity, "_values", noted)
    check("polar.decorrelated.covariance[0,0]", "predicted_sigma_r**2*cos(beta)**2")
    assert {quantity.unit((0, 0)) for quantity in asked} == {METRE**2}
    assert {quantity.name for quantity in asked} == {"polar.decorrelated.covariance"}
    asked.clear()
    check("polar.jacobian[0,1]", "2*r*cos(beta)")
    assert {quantity.name for quantity in asked} == {"polar.jacobian"}
    asked.clear()
    check("polar.covariance.linear[0,0]", f"{LINEAR} + r")
    assert not asked


def test_two_slips_at_once_are_found() -> None:
    verdict = check(
        "polar.covariance.linear[0,1]", "(sigma_r**2 + r**2*sigma_beta)*sin(beta)*cos(beta)", given=INDEPENDENT
    )
    assert verdict.suggestions
    assert check("polar.covariance.linear[0,1]", verdict.suggestions[0].formula, given=INDEPENDENT).is_equal


def test_two_likely_slips_are_named_beside_one_that_is_unlikely() -> None:
    assert "atan2(y, x)" in [one.formula for one in check("observe.polar.map[1]", "atan2(y/3, x*x)").suggestions[:3]]


def test_metres_added_to_square_metres_are_wrong_dimensions() -> None:
    verdict = check("polar.covariance.linear[0,0]", LINEAR.replace("r**2*", "r*", 1), given=INDEPENDENT)
    assert verdict.verdict is Outcome.WRONG_DIMENSIONS
    assert "cannot be added" in verdict.reason
    assert verdict.suggestions[0].formula == LINEAR


def test_a_paper_s_own_names_are_read() -> None:
    let = {"D_beta": "sigma_beta**2", "a": "D_beta/2"}
    assert check("polar.bias.second_order[0]", "-a*r*cos(beta)", given=INDEPENDENT, let=let).is_equal


def test_latex_is_compared_as_it_is_read() -> None:
    formula = r"-\frac{1}{2}\sigma_\beta^2 r\cos\beta"
    verdict = check("polar.bias.second_order[0]", formula, latex=True, given=INDEPENDENT)
    assert verdict.verdict is Outcome.EQUAL
    assert "sigma_beta**2" in verdict.printed


@pytest.mark.parametrize(
    ("name", "formula"),
    [
        ("polar.jacobian", "[[cos(beta), -r*sin(beta)], [sin(beta), r*cos(beta)]]"),
        ("polar.hessian[:,0,1]", "[-sin(beta), cos(beta)]"),
        ("polar.hessian[0,:,:]", "[[0, -sin(beta)], [-sin(beta), -r*cos(beta)]]"),
        ("polar.map + polar.bias.truth - polar.posterior.estimate", "[0, 0]"),
    ],
)
def test_tensors_slices_and_expressions_may_be_checked(name: str, formula: str) -> None:
    assert check(name, formula).verdict is Outcome.EQUAL


def test_of_a_tensor_the_wrong_entry_is_named() -> None:
    verdict = check("polar.jacobian", "[[cos(beta), -r*sin(beta)], [sin(beta), -r*cos(beta)]]")
    assert verdict.verdict is Outcome.DIFFERS
    assert verdict.counterexample is not None
    assert verdict.counterexample.entry == (1, 1)
    assert {one.entry for one in verdict.suggestions} == {(1, 1)}


def test_what_algebra_cannot_decide_is_compared_in_numbers_and_said_to_be_unproved() -> None:
    verdict = check("observe.polar.map[1]", "2*atan2(y, x + sqrt(x**2 + y**2))")
    assert verdict.verdict is Outcome.EQUAL_NUMERICALLY
    assert "not proved" in verdict.reason


def test_a_formula_that_is_real_only_where_both_vanish_differs() -> None:
    verdict = check("finite_sample.degree2.range_rate.design[0,2]", "T**2*(j - k)**(1/2)/2")
    assert verdict.verdict is Outcome.DIFFERS
    assert "not real everywhere" in verdict.reason
    example = verdict.counterexample
    assert example is not None
    assert (example.point["k"], example.point["j"]) == (8, 3)
    assert example.printed is None
    assert example.relative_difference is None
    assert example.derived == pytest.approx(10**2 * (3 - 8) ** 2 / 2)


def test_a_root_of_what_rounding_brings_below_zero_is_not_taken_for_imaginary() -> None:
    formula = "2*atan2(y, x + sqrt(x**2 + y**2)) + sqrt(cos(x/y)**2 + sin(x/y)**2 - 1)"
    assert check("observe.polar.map[1]", formula).verdict is Outcome.EQUAL_NUMERICALLY


def test_a_difference_far_below_rounding_in_floating_point_is_seen() -> None:
    verdict = check("polar.map[0]", "r*cos(beta) + 1e-38*r")
    assert verdict.verdict is Outcome.DIFFERS


def test_rounding_is_not_taken_for_a_difference() -> None:
    verdict = check("polar.hessian[0,0,0]", "(sin(beta)**2 + cos(beta)**2 - 1)/r")
    assert verdict.verdict is Outcome.EQUAL


@pytest.mark.parametrize(
    ("name", "formula", "options", "error"),
    [
        ("polar.covariance.linaer", "r", {}, UnknownQuantity),
        ("polar.covariance.linear[2]", "r", {}, UnknownEntry),
        ("polar.covariance.linear[0,2]", "r", {}, UnknownEntry),
        ("polar.map + polar.jacobian", "r", {}, UnknownEntry),
        ("r + 1", "r", {}, UnknownQuantity),
        ("polar.map", "r*cos(beta)", {}, FormulaError),
        ("polar.map[0]", "[r, r]", {}, FormulaError),
        ("polar.map[0]", "r*cos(sigma_theta)", {}, FormulaError),
        ("polar.map[0]", "r", {"given": {"rho": "0"}}, FormulaError),
        ("polar.map[0]", "r", {"given": {"r": "1 +"}}, FormulaError),
        ("polar.map[0]", "r", {"let": {"a": "b"}}, FormulaError),
    ],
)
def test_what_makes_no_sense_is_refused(
    name: str, formula: str, options: Mapping[str, Mapping[str, str]], error: type[Exception]
) -> None:
    with pytest.raises(error):
        check(name, formula, **options)  # type: ignore[arg-type]


def test_a_verdict_is_quick() -> None:
    check("polar.covariance.averaged[0,0]", LINEAR, given=INDEPENDENT)
    with at_most(2):
        check("polar.covariance.averaged[0,0]", LINEAR, given=INDEPENDENT)


def test_the_longest_derived_matrix_is_read_and_proved() -> None:
    name = "ruv.decorrelated.covariance.fourth_order"
    formula = shown(refer(name).entries)
    assert len(formula) > 50_000
    assert check(name, formula).verdict is Outcome.EQUAL


def test_a_verdict_on_a_long_formula_with_a_slip_is_quick() -> None:
    name = "ruv.covariance.truth.fourth_order[0,2]"
    formula = check(name, "0").derived
    slip = formula.replace("(5/2)", "(3/2)", 1)
    assert len(slip) > 4000
    with at_most(4):
        verdict = check(name, slip)
    assert verdict.suggestions[0].formula == formula


@pytest.mark.parametrize(
    "formula", [f"r*{'sin(' * 40}beta{')' * 40}", f"r*cos({' + '.join(f'{n}*beta/{n + 1}' for n in range(1, 500))})"]
)
def test_odd_angles_take_no_longer_than_other_formulas(formula: str) -> None:
    with at_most(4):
        assert check("polar.map[0]", formula).verdict is Outcome.DIFFERS


def test_a_slip_that_makes_a_term_of_a_long_formula_another_of_its_terms_is_found() -> None:
    name = "spherical.unbiased.covariance[0,0]"
    formula = check(name, "0").derived
    slip = formula.replace("/4)*cos(2*beta - 2*epsilon)", "/4)*cos(2*beta + 2*epsilon)", 1)
    assert slip != formula
    assert "the sign of 2*epsilon" in _edits(check(name, slip))[:3]


def _edits(verdict: Verdict) -> list[str]:
    return [suggestion.edit for suggestion in verdict.suggestions]


@pytest.mark.parametrize("formula", ["atan2(y, sqrt(x**2 - y**2))", "atan2(y, hypot(x, sqrt(x**2 - 2*y**2)))"])
def test_angles_of_what_is_not_real_everywhere_are_compared_where_they_are(formula: str) -> None:
    assert check("observe.polar.map[1]", formula).verdict is Outcome.DIFFERS


def test_what_is_equal_on_one_side_of_the_radar_alone_is_no_suggestion() -> None:
    verdict = check("observe.polar.map[1]", "atan2(y*y, y*x)")
    assert verdict.verdict is Outcome.DIFFERS
    assert not [one.formula for one in verdict.suggestions if "y*y" in one.formula]


def test_an_angle_beside_a_length_is_measured_against_itself() -> None:
    found = check("observe.polar.map[1]", "atan2(y, 2*x)").counterexample
    assert found is not None
    assert found.relative_difference is not None
    assert (found.largest_relative_difference or 0.0) >= found.relative_difference


@pytest.mark.parametrize("fraction", [Fraction(5, 6), Fraction(7, 3), Fraction(2, 15)])
def test_a_fraction_of_numbers_upside_down_is_told(fraction: Fraction) -> None:
    above, below = fraction.numerator, fraction.denominator
    verdict = check(f"{fraction}*polar.map[0]", f"{below}*r*cos(beta)/{above}")
    assert verdict.verdict is Outcome.DIFFERS
    assert verdict.suggestions[0].edit == f"the fraction upside down: {above}/{below}"


@pytest.mark.parametrize("inner", ["atan(tan(beta))", "acos(cos(beta))", "asin(sin(beta))"])
@pytest.mark.parametrize("outer", ["r*cos({})", "2*r*sin({})", "r*cos({}) + r"])
def test_no_suggestion_takes_a_function_of_its_inverse(inner: str, outer: str) -> None:
    detour = re.compile(r"a(sin|cos|tan)\(\1\(|(sin|cos|tan)\(a\2\(")
    printed = outer.format(inner)
    for suggestion in check("polar.map[0]", printed).suggestions:
        assert len(detour.findall(suggestion.formula)) <= len(detour.findall(printed)), suggestion


@pytest.mark.parametrize(
    ("formula", "printed", "outcome"),
    [
        ("chi2inv(0.99, 3)", "11.34", Outcome.EQUAL),
        ("chi2inv(0.99, 3)", "11.35", Outcome.DIFFERS),
        ("chi2cdf(9.21, 2)", "0.99", Outcome.EQUAL),
        ("integral(q*s^2, s, 0, T)", "q*T^3/3", Outcome.EQUAL),
        ("expm([0, 1; 0, 0]*T)", "[1, T; 0, 2]", Outcome.DIFFERS),
    ],
)
def test_a_formula_that_has_something_to_work_out_needs_no_quantity(
    formula: str, printed: str, outcome: Outcome
) -> None:
    verdict = check(formula, printed)
    assert verdict.verdict is outcome
    assert not re.search(r"\d{20}/", f"{verdict.derived} {verdict.remarks}")  # nobody reads such a fraction
