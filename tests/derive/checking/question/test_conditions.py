"""Conditions and definitions: what they may be, and that they are put into each other in the order of dependence."""

from collections.abc import Mapping
from itertools import permutations

import pytest

from radartrack.derive import check
from radartrack.derive.checking.papers.audit import decide
from radartrack.derive.checking.papers.claim import Claim, UnreadableClaim
from radartrack.derive.checking.question.compared_quantity import refer
from radartrack.derive.formula.error import FormulaError

COVARIANCE = "polar.covariance.linear[0,0]"
PRINTED = "r**2*sigma_beta**2*sin(beta)**2 + sigma_r**2*cos(beta)**2"


def _decided(given: Mapping[str, str], *, quantity: str = COVARIANCE, formula: str = PRINTED) -> str:
    return str(decide(Claim("a", quantity, formula=formula, given=given)).verdict)


@pytest.mark.parametrize("order", list(permutations(["r", "sigma_r", "sigma_beta", "rho"])))
def test_conditions_are_applied_in_the_order_of_dependence(order: tuple[str, ...]) -> None:
    conditions = {"r": "2*sigma_r", "sigma_r": "5", "sigma_beta": "sigma_r/r", "rho": "0"}
    given = {name: conditions[name] for name in order}
    formula = "100*(1/2)**2*sin(beta)**2 + 25*cos(beta)**2"
    verdict = decide(Claim("a", COVARIANCE, formula=formula, given=given))
    assert verdict.verdict == "equal"
    assert set(verdict.conditions) == {"r = 10", "sigma_r = 5", "sigma_beta = 1/2", "rho = 0"}
    assert not decide(Claim("a", COVARIANCE, formula=f"2*({formula})", given=given)).is_equal


@pytest.mark.parametrize(
    ("given", "said"),
    [
        ({"rho": "rho"}, "given rho: .* on itself.* let"),
        ({"beta": "pi/2 - beta"}, "given beta: .* on itself.* let"),
        ({"r": "r^2"}, "given r: .* on itself.* let"),
        ({"r": "2*r - sigma_r"}, "given r: .* on itself"),
        ({"rho": "0", "sigma_r": "sqrt(sigma_r*r)"}, "given sigma_r: .* on itself"),
        ({"r": "sigma_r", "sigma_r": "r"}, "r and sigma_r are set by each other"),
        ({"r": "2*sigma_r", "rho": "0", "sigma_r": "r*sigma_beta", "sigma_beta": "sigma_r/r"}, "set by each other"),
        ({"sigma_beta": "r"}, "given sigma_beta: r has m, sigma_beta has rad"),
        ({"r": "sigma_beta"}, "given r: sigma_beta has rad, r has m"),
        ({"r": "sigma_r**2"}, "given r: .* has m\\^2, r has m"),
        ({"r": "1 + sigma_r"}, "given r: .* cannot be added"),
        ({"beta": "sin(r)"}, "given beta: .* sin takes an angle"),
        ({"r": "-5"}, "r = -5 is outside the domain of r: at least 0 m"),
        ({"rho": "2"}, "rho = 2 is outside the domain of rho"),
        ({"r": "-sigma_r"}, "r = -sigma_r is outside the domain of r everywhere"),
        ({"rho": "1 + sigma_beta"}, "outside the domain of rho everywhere"),
        ({"sigma_r": "1", "r": "-2*sigma_r"}, "r = -2 is outside the domain of r"),
        ({"sigma_r": "0", "r": "1/sigma_r"}, "no value under the other conditions|cannot|no real"),
        ({"r": "1/0"}, "given r: this divides by zero"),
        ({"r": "sqrt(-1)"}, "given r: this is not a real number"),
        ({"q": "1"}, "given q: the symbols of"),
    ],
)
def test_a_condition_that_sets_nothing_or_what_cannot_be_is_refused_with_a_word(
    given: dict[str, str], said: str
) -> None:
    with pytest.raises(UnreadableClaim, match=said):
        _decided(given)


@pytest.mark.parametrize(
    ("quantity", "formula", "given"),
    [
        ("observe.polar.map[1]", "0", {"x": "0", "y": "0"}),
        ("line.slope", "0", {"S_xy": "0"}),
        (COVARIANCE, PRINTED + "*rho/sigma_beta", {"sigma_beta": "0"}),
        (COVARIANCE, "log(rho)", {"rho": "0"}),
        (COVARIANCE, "sqrt(rho)", {"rho": "-1"}),
    ],
)
def test_under_conditions_in_which_a_formula_has_no_value_nothing_is_decided(
    quantity: str, formula: str, given: dict[str, str]
) -> None:
    verdict = check(quantity, formula, given=given)
    assert verdict.verdict == "undecided"
    assert "has no value when" in verdict.reason


@pytest.mark.parametrize(
    ("given", "formula"),
    [
        ({"rho": "0", "sigma_beta": "0"}, "sigma_r**2*cos(beta)**2"),
        ({"rho": "0", "sigma_beta": "sigma_r/r"}, "sigma_r**2"),
        ({"rho": "0", "beta": "pi/2"}, "r**2*sigma_beta**2"),
        ({"rho": "-1", "beta": "5*pi"}, "sigma_r**2"),
        ({"rho": "0", "r": "0"}, "sigma_r**2*cos(beta)**2"),
    ],
)
def test_conditions_at_the_limits_and_between_symbols_hold(given: dict[str, str], formula: str) -> None:
    assert _decided(given, formula=formula) == "equal"
    assert _decided(given, formula=f"{formula} + sigma_r**2/7") == "differs"


@pytest.mark.parametrize(
    ("name", "said"),
    [
        *((name, "is a function") for name in ("sin", "tan", "sqrt", "abs", "ln", "arctan", "atan2")),
        *((name, "letters, digits and _") for name in ("g(x)", "3b", r"\frac{x}{y}", "a.b", "x'", "é", "a b", "")),
        ("x[0]", "letters, digits and _"),
    ],
)
def test_a_name_that_no_formula_holds_is_not_defined(name: str, said: str) -> None:
    for latex in (False, True):
        formula = {"latex": r"r\cos\beta"} if latex else {"formula": "r*cos(beta)"}
        with pytest.raises(UnreadableClaim, match=said):
            decide(Claim("a", "polar.map[0]", **formula, let={name: "r"}))  # type: ignore[arg-type]


@pytest.mark.parametrize("zero", ["0", "0.0", "1 - 1", "x - x", "0*y"])
@pytest.mark.parametrize(
    "distance", ["sqrt((x - b)**2 + y**2)", "sqrt(x**2 - 2*b*x + b**2 + y**2)", "hypot(b, hypot(x - 3*b, y))"]
)
def test_a_name_for_zero_stands_beside_every_unit(zero: str, distance: str) -> None:
    let = {"b": zero, "d": distance}
    assert decide(Claim("a", "observe.polar.map[0]", formula="d", let=let)).is_equal
    assert decide(Claim("a", "observe.polar.map[0]", formula="d + x + b", let=let)).verdict == "differs"
    assert decide(Claim("a", "observe.polar.map[0]", formula="d**2 + b", let=let)).verdict == "wrong_dimensions"


@pytest.mark.parametrize("name", ["x", "x_0", "R", "D_beta", "xdot", "lambda_theta", "_q"])
def test_a_name_of_letters_digits_and_underscores_is_understood(name: str) -> None:
    claim = Claim("a", "polar.map[0]", formula=f"{name}*cos(beta)", let={name: "r"})
    assert decide(claim).verdict == "equal"


@pytest.mark.parametrize("given", [{"sigma_beta": "rho"}, {"sigma_beta": "rho**2"}, {"sigma_r": "r/rho"}])
@pytest.mark.parametrize("formula", [PRINTED, "r*cos(beta)", "r**2", "sigma_r**2*cos(beta)**2"])
def test_what_follows_when_a_correlation_vanishes_is_put_into_the_conditions(
    given: dict[str, str], formula: str
) -> None:
    verdict = decide(Claim("a", COVARIANCE, formula=formula, given=given))
    helps = [remark for remark in verdict.remarks if "when rho = 0" in remark]
    is_right = "sigma_r" not in given and _decided({"sigma_beta": "0", "rho": "0"}, formula=formula) == "equal"
    assert bool(helps) is is_right


def test_the_names_that_stand_for_quantities_are_no_symbols() -> None:
    for quantity in ("polar.map[0] + quantity_1", "quantity_0 + polar.map[0]", "quantity_0*polar.map[0]/quantity_7"):
        with pytest.raises(UnreadableClaim, match=r"quantity_\d is not a name here"):
            decide(Claim("a", quantity, formula="r"))


@pytest.mark.parametrize(
    "quantity",
    [
        "polar.bias.second_order[1]",
        "polar.covariance.second_order[1,1]",
        "spherical.bias.second_order[0]",
        "ruv.bias.second_order[2]",
        "polar.covariance.linear[0,1]",
    ],
)
def test_a_formula_that_is_right_without_correlation_gets_no_edit_that_changes_nothing(quantity: str) -> None:
    printed = decide(Claim("a", quantity, formula="0", given=dict.fromkeys(_correlations(quantity), "0"))).derived
    verdict = decide(Claim("a", quantity, formula=printed))
    assert verdict.verdict == "differs"
    for suggestion in verdict.suggestions:
        before, _, after = suggestion.edit.partition(" should be ")
        assert before != after.partition(" when ")[0]
        assert " when " not in suggestion.edit


def test_no_edit_is_the_formula_itself() -> None:
    """One that is wrong near one point only, which the search for edits does not see."""
    near = "(abs(r/sigma_r - 1000) - 1/2)"
    formula = f"{PRINTED} + sigma_r**2*(abs{near} - {near})/3"
    edits = [
        suggestion.edit
        for suggestion in decide(Claim("a", COVARIANCE, formula=formula, given={"rho": "0"})).suggestions
    ]
    assert edits
    assert all(before != after for before, _, after in (edit.partition(" should be ") for edit in edits))


def _correlations(quantity: str) -> list[str]:
    return [symbol.name for symbol in refer(quantity).symbols if symbol.is_correlation]


@pytest.mark.parametrize(
    ("given", "formula"),
    [
        ({"beta": "30deg"}, "r*sqrt(3)/2"),
        ({"beta": " 30 deg"}, "r*sqrt(3)/2"),
        ({"beta": "30°"}, "r*sqrt(3)/2"),
        ({"beta": "-1.5e1deg"}, "r*(sqrt(6) + sqrt(2))/4"),
        ({"r": "10km"}, "10000*cos(beta)"),
        ({"azimuth": "500 mrad"}, "r*cos(1/2)"),
    ],
)
def test_a_number_may_have_a_unit(given: dict[str, str], formula: str) -> None:
    verdict = check("polar.map[0]", formula, given=given)
    assert verdict.is_equal
    assert not verdict.remarks


@pytest.mark.parametrize("given", [{"r": "30deg"}, {"beta": "10 km"}, {"r": "5s"}])
def test_a_number_in_another_unit_is_refused(given: dict[str, str]) -> None:
    with pytest.raises(FormulaError, match="has the unit"):
        check("polar.map[0]", "r*cos(beta)", given=given)


def test_a_definition_may_be_a_number_with_a_unit() -> None:
    assert check("polar.map[0]", "R*cos(beta)", let={"R": "10km"}, given={"r": "10km"}).is_equal
    wrong = check("polar.map[0]", "r*cos(beta) + R", let={"R": "10s"})
    assert wrong.verdict == "wrong_dimensions"


@pytest.mark.parametrize(("value", "is_told"), [("30", True), ("-90", True), ("6.2", False), ("30*pi/180", False)])
def test_an_angle_beyond_a_turn_is_told_to_be_in_radians(value: str, is_told: bool) -> None:
    remarks = check("polar.map[0]", "r*cos(beta)", given={"beta": value}).remarks
    assert any(f"beta={value}deg" in one for one in remarks) is is_told


def test_definitions_may_be_latex() -> None:
    formula = r"\left(\lambda^{-2}-2\right) r^2\cos^2\theta+\frac{1}{2}(r^2+\sigma_r^2)(1+\lambda'\cos 2\theta)"
    let = {r"\lambda": r"e^{-\sigma_\theta^2/2}", r"\lambda'": r"\lambda^{4}"}
    assert check("polar.unbiased.covariance[0,0]", formula, latex=True, let=let, given={"rho": "0"}).is_equal


def _of_scans() -> list[tuple[str, int]]:
    """Quantities of the finite-sample filter, with the fewest scans that determine them."""
    kinds = ("range.covariance", "range.correlation", "range.range_weights", "range.at_lag.covariance", "gain")
    found = [(f"finite_sample.degree{degree}.{kind}", degree + 1) for degree in range(4) for kind in kinds]
    found += [(f"finite_sample.degree{degree}.range_rate.covariance", degree // 2 + 1) for degree in range(4)]
    return found + [(f"finite_sample.degree{degree}.range.information", 1) for degree in range(4)]


@pytest.mark.parametrize(("quantity", "least"), _of_scans())
def test_fewer_scans_than_determine_a_quantity_are_no_condition(quantity: str, least: int) -> None:
    entry = f"{quantity}[0]" if "weights" in quantity or "gain" in quantity else f"{quantity}[0,0]"
    for count in range(-1, least):
        with pytest.raises(
            UnreadableClaim, match=f"k = {count} is outside the domain of k: whole numbers from {least}"
        ):
            _decided({"k": str(count)}, quantity=entry, formula="1")
    assert _decided({"k": str(least)}, quantity=entry, formula="1") in {
        "differs",
        "wrong_dimensions",
        "equal",
        "undecided",
    }
