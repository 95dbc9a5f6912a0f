"""Claims about formulas: identities, chains, orders, limits, errors, and solutions of equations."""

from __future__ import annotations

import math
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import pytest

from radartrack.derive.checking.papers.audit import decide
from radartrack.derive.checking.papers.claim import Claim, ClaimsError, UnreadableClaim
from radartrack.derive.checking.papers.claims_file import read_claims
from radartrack.derive.checking.question.declared_world import world_of
from radartrack.derive.checking.question.world import World
from radartrack.derive.checking.reporting.verdict import Outcome, Verdict

SYMBOLS = {"a": {"unit": "1", "low": 0.05, "high": 0.9}, "b": {"unit": "1", "low": 0.05, "high": 0.9}}
WORLD = world_of([{"symbols": SYMBOLS}])


def decided(world: World = WORLD, **fields: Any) -> Verdict:
    return decide(Claim("claim", **fields), world)


CHAIN = ("(a + b)^2", "a^2 + 2*a*b + b^2", "a*(a + b) + b*(a + b)", "(a + b)*(a + b)", "(a^2 - b^2)^2/(a - b)^2")
SLIPS = ("(a - b)^2", "a^2 + a*b + b^2", "a*(a + b) - b*(a + b)", "(a + b)*(a - b)", "(a^2 + b^2)^2/(a - b)^2")


def test_a_chain_of_right_steps_is_right():
    assert decided(chain=CHAIN).verdict is Outcome.EQUAL


@pytest.mark.parametrize("place", range(len(CHAIN)))
def test_the_first_wrong_step_of_a_chain_is_named_with_its_slip(place: int):
    verdict = decided(chain=(*CHAIN[:place], SLIPS[place], *CHAIN[place + 1 :]))
    assert verdict.verdict is Outcome.DIFFERS
    assert verdict.reason.startswith(f"step {max(place, 1)} of {len(CHAIN) - 1}: ")
    assert verdict.suggestions


@pytest.mark.parametrize(
    ("order", "formula", "is_right"),
    [
        (2, "-r*cos(beta)*sigma_beta^2/2", True),
        (3, "-r*cos(beta)*sigma_beta^2/2", True),
        (4, "-r*cos(beta)*sigma_beta^2/2", False),
        (4, "r*cos(beta)*(sigma_beta^4/8 - sigma_beta^2/2)", True),
        (2, "r*cos(beta)*(exp(-sigma_beta^2/2) - 1)", True),
        (2, "r*cos(beta)*sigma_beta^2/2", False),
    ],
)
def test_to_an_order_the_terms_up_to_it_count(order: int, formula: str, is_right: bool):
    verdict = decided(quantity="polar.bias.truth[0]", formula=formula, to_order=order, given={"rho": "0"})
    assert verdict.verdict is (Outcome.EQUAL if is_right else Outcome.DIFFERS)


@pytest.mark.parametrize(
    ("left", "right", "limit", "is_right"),
    [
        ("(1 - exp(-a*r))/a", "r", {"a": "0"}, True),
        ("(1 - exp(-a*r))/a", "r/2", {"a": "0"}, False),
        ("(2*k + 1)/k", "2", {"k": "inf"}, True),
        ("(2*k + 1)/(k^2 - 3)", "2/k", {"k": "inf"}, True),
        ("(2*k + 1)/(k^2 - 3)", "3/k", {"k": "inf"}, False),
        ("exp(-k)*k + a", "a", {"k": "inf"}, True),
    ],
)
def test_in_a_limit_what_is_left_counts(left: str, right: str, limit: Mapping[str, str], is_right: bool):
    assert decided(left=left, right=right, limit=limit).is_equal is is_right


END = 0.3
LARGEST = (math.cos(END) - (1 - END**2 / 2)) / math.cos(END)


@pytest.mark.parametrize("factor", [1.01, 2, 50, 0.99, 0.5, 0.01])
def test_an_error_is_at_most_what_it_is_at_the_end_where_it_is_largest(factor: float):
    bound = f"{100 * LARGEST * factor:.8f} %"
    verdict = decided(left="r*cos(a)", right="r*(1 - a^2/2)", within={"a": ("1e-3", str(END))}, error_at_most=bound)
    assert verdict.is_equal is (factor > 1)
    if factor < 1:
        assert verdict.counterexample is not None
        assert verdict.counterexample.point["a"] == END
    elif factor > 2:
        assert verdict.verdict is Outcome.EQUAL  # by proof


def test_an_error_in_a_unit_is_absolute():
    near: dict[str, Any] = {
        "left": "r",
        "right": "r + 3*a*r/r*r/1000",
        "within": {"r": ("1", "1000"), "a": ("0.1", "0.5")},
    }
    assert decided(**near, error_at_most="1.6 m").is_equal
    assert decided(**near, error_at_most="1.4 m").verdict is Outcome.DIFFERS
    assert decided(**near, error_at_most="1.6 s").verdict is Outcome.WRONG_DIMENSIONS


def test_a_claim_may_carry_its_formula_and_be_undecided():
    verdict = decided(quantity="polar.map[0]", formula="r*cos(beta)", undecided="not said which axis")
    assert (verdict.verdict, verdict.reason) == (Outcome.UNDECIDED, "not said which axis")


def test_what_has_no_closed_form_is_undecided_and_named():
    verdict = decided(left="sum(1/(a + j), j, 1, 10^9)", right="a")
    assert verdict.verdict is Outcome.UNDECIDED
    assert "the sum over j of 1/(a + j)" in verdict.reason


@pytest.mark.parametrize(
    ("unit", "value", "is_right"),
    [
        ("km^2", "0.0025", True),
        ("m*km", "2.5", True),
        ("m^2", "2500", True),
        ("km^2", "2.5", False),
        ("1/m^-2", "2500", True),
    ],
)
def test_a_number_may_be_in_any_product_of_units(unit: str, value: str, is_right: bool):
    at = {"r": "1000", "beta": "0", "sigma_r": "sqrt(2500)", "sigma_beta": "0", "rho": "0"}
    verdict = decided(quantity="polar.covariance.linear[0,0]", value=value, unit=unit, at=at)
    assert verdict.is_equal is is_right


def test_values_may_use_the_definitions_of_the_paper():
    own = world_of([{"symbols": SYMBOLS, "let": {"R0": "2*step", "step": "500"}}])
    assert decided(own, quantity="polar.map[0]", value="1", unit="km", at={"r": "R0", "beta": "0"}).is_equal


GOOD = 'paper = "P"\n[[claim]]\nid = "good"\nleft = "r"\nright = "r"\n[[claim]]\nid = "bad"\n'


@pytest.mark.parametrize(
    ("fields", "said"),
    [
        (
            'quantity = "polar.map[0]"\nvalue = "1"\nunit = "furlong"\nat = { r = "1", beta = "0" }',
            "unit must be one of",
        ),
        ('left = "r"', "left and right belong together"),
        ('left = "r"\nright = "r"\nquantity = "polar.map"', "need no quantity"),
        ('chain = ["r"]', "a list of 2 to 40 formulas"),
        ('quantity = "polar.map[0]"\nformula = "r"\nto_order = -1', "a whole number from 0 to 12"),
        ('quantity = "polar.map[0]"\nformula = "r"\nwithin = { r = "1" }', "from where to where"),
        ('quantity = "polar.map[0]"\nformula = "r"\nerror_at_most = "little"', "a number and a unit"),
        ('quantity = "polar.map[0]"\nvalue = "1"\nlimit = { r = "0" }', "belong to formulas"),
    ],
)
def test_a_field_that_does_not_fit_spoils_its_own_claim(tmp_path: Path, fields: str, said: str):
    path = tmp_path / "claims.toml"
    path.write_text(GOOD + fields)
    with pytest.raises(ClaimsError, match="bad.*" + said):
        read_claims(path)
    good, bad = read_claims(path, keep_unreadable=True).claims
    assert decide(good).is_equal
    with pytest.raises(UnreadableClaim):
        decide(bad)


def test_a_letter_whose_unit_there_is_not_spoils_what_needs_it_alone():
    own = world_of([{"symbols": {**SYMBOLS, "c": {"unit": "furlong"}}, "let": {"d": "2*c", "e2": "2*a"}}])
    assert decided(own, left="e2", right="2*a").is_equal
    for formula in ("c", "d"):
        with pytest.raises(UnreadableClaim, match="furlong"):
            decided(own, left=formula, right="2*a")


def implicit(unknown: list[str], equations: list[str], where: list[str] | None = None) -> World:
    table = {"name": "own.x", "symbols": ["a", "b"], "unknown": unknown, "equations": equations}
    return world_of([{"symbols": SYMBOLS, "define": [table | ({"where": where} if where else {})]}])


ROOTS = implicit(["x", "y"], ["x + y = a + b", "x*y - a*b"], ["x > y"])
SQUARE = implicit(["x"], ["x^2 = a^2 + 2*a*b + b^2"], ["x > 0"])


@pytest.mark.parametrize(
    ("own", "fields", "outcome"),
    [
        (SQUARE, {"formula": "a + b"}, Outcome.EQUAL),
        (SQUARE, {"formula": "sqrt((a + b)^2)"}, Outcome.EQUAL),
        (SQUARE, {"formula": "-a - b"}, Outcome.DIFFERS),
        (SQUARE, {"formula": "a - b"}, Outcome.DIFFERS),
        (ROOTS, {"formula": "[a, b]", "given": {"a": "2*b"}}, Outcome.EQUAL),
        (ROOTS, {"formula": "[b, a]", "given": {"a": "2*b"}}, Outcome.DIFFERS),
        (ROOTS, {"formula": "[a, b]"}, Outcome.DIFFERS),
        (ROOTS, {"formula": "[a, a]", "given": {"a": "2*b"}}, Outcome.DIFFERS),
        (implicit(["P"], ["P = a^2*P + [1, 0; 0, 1]"]), {"formula": "eye(2)/(1 - a^2)"}, Outcome.EQUAL),
        (implicit(["P"], ["P = a^2*P + [1, 0; 0, 1]"]), {"formula": "eye(2)/(1 + a^2)"}, Outcome.DIFFERS),
        (implicit(["x"], ["x = sqrt(a^2 + 1)"]), {"formula": "sqrt(1 + a^2)"}, Outcome.EQUAL),
        (implicit(["x"], ["0 = 1"]), {"formula": "a"}, Outcome.UNDECIDED),
        (implicit(["x"], ["x - x = b"]), {"formula": "a"}, Outcome.UNDECIDED),
        (implicit(["x"], ["x = a", "a = a + 1"]), {"formula": "a"}, Outcome.UNDECIDED),
        (implicit(["x"], ["x - x"]), {"formula": "a"}, Outcome.UNDECIDED),
        (implicit(["x"], ["x = 1", "x = 2"]), {"formula": "1"}, Outcome.UNDECIDED),
        (implicit(["x", "y"], ["x + y = a", "x*y = b", "x + y = b + 1"]), {"formula": "[a, b]"}, Outcome.UNDECIDED),
        (implicit(["x"], ["x^2 = a", "x = a"]), {"formula": "a"}, Outcome.UNDECIDED),
        (implicit(["x"], ["x = a", "x = b"]), {"formula": "a", "given": {"a": "b"}}, Outcome.EQUAL),
        (implicit(["x"], ["x = 1", "x = cos(a)^2 + sin(a)^2"]), {"formula": "1"}, Outcome.EQUAL),
        (implicit(["x"], ["x = exp(a)", "x = exp(b)"]), {"formula": "exp(a)"}, Outcome.DIFFERS),
    ],
)
def test_a_solution_is_right_where_it_satisfies_all_equations_on_the_branch_that_is_meant(
    own: World, fields: Mapping[str, Any], outcome: Outcome
):
    assert decided(own, quantity="own.x", **fields).verdict is outcome


@pytest.mark.parametrize(
    ("where", "formula", "outcome"),
    [
        (["x > 0", "b < 0"], "-b", Outcome.EQUAL),
        (["x > 0", "b > 0"], "b", Outcome.EQUAL),
        (["x > 0", "b > 0"], "-b", Outcome.DIFFERS),
        (["x > 0", "b > a"], "b - a + a", Outcome.EQUAL),
        (["x > 0", "2*b < a", "b > a"], "b", Outcome.UNDECIDED),
    ],
)
def test_a_condition_without_the_unknown_says_where_the_solution_is_to_hold(
    where: list[str], formula: str, outcome: Outcome
):
    signed = {**SYMBOLS, "b": {"unit": "1", "low": -9.0, "high": 9.0}}
    table = {"name": "own.x", "symbols": ["a", "b"], "unknown": ["x"], "equations": ["x^2 = b^2"], "where": where}
    own = world_of([{"symbols": signed, "define": [table]}])
    assert decided(own, quantity="own.x", formula=formula).verdict is outcome


def test_an_equation_holds_where_the_conditions_say_it_does():
    signed = {"a": {"unit": "1", "low": -9.0, "high": 9.0}, "b": {"unit": "1", "low": -9.0, "high": 9.0}}
    table = {"name": "own.x", "symbols": ["a", "b"], "unknown": ["x"], "equations": ["x = sqrt((a - b)^2)"]}
    for where, formula, is_right in (("a > b", "a - b", True), ("a > b", "b - a", False), ("a < b", "b - a", True)):
        own = world_of([{"symbols": signed, "define": [table | {"where": [where]}]}])
        assert (decided(own, quantity="own.x", formula=formula).verdict is not Outcome.DIFFERS) is is_right


def test_conditions_that_leave_a_symbol_no_value_are_refused():
    with pytest.raises(UnreadableClaim, match="no value"):
        decided(implicit(["x"], ["x = a"], ["a > 5", "a < 4"]), quantity="own.x", formula="a")


def test_one_unknown_is_checked_with_the_others_given():
    given = {"y": "b", "a": "2*b"}
    assert decided(ROOTS, quantity="own.x[0]", formula="a", given=given).verdict is Outcome.EQUAL
    assert decided(ROOTS, quantity="own.x[0]", formula="b", given=given).verdict is Outcome.DIFFERS
    with pytest.raises(UnreadableClaim, match="given y"):
        decided(ROOTS, quantity="own.x[0]", formula="a")


def test_what_a_wrong_solution_should_be_is_suggested():
    verdict = decided(SQUARE, quantity="own.x", formula="a - b")
    assert verdict.suggestions[0].formula == "a + b"


COMMON = {f"t{n}": f"{n}*a + b^2*t{n - 1}" for n in range(2, 13)} | {"t1": "a - b^2"}


@pytest.mark.parametrize("place", [1, 2, 5, 9, 12])
def test_a_wrong_sign_in_one_of_many_definitions_is_found_there(place: int):
    right = "a - b^2"
    for factor in range(2, 13):
        right = f"{factor}*a + b^2*({right})"
    sign = "+" if place == 1 else "-"
    slip = {f"t{place}": COMMON[f"t{place}"].replace("- b" if place == 1 else "+ b", f"{sign} b")}
    verdict = decided(left=right, right="t12 + 0*t1", let={**COMMON, **slip})
    assert verdict.verdict is Outcome.DIFFERS
    assert any(one.formula.startswith(f"t{place} = ") for one in verdict.suggestions)
    assert any(one.edit.startswith(f"in the definition of t{place}: the sign of") for one in verdict.suggestions)


@pytest.mark.parametrize(
    ("wrong", "right"),
    [
        ("jacobian([r*cos(beta), r*cos(beta)], [r, beta])", "jacobian([r*cos(beta), r*sin(beta)], [r, beta])"),
        ("jacobian([r*cos(beta), -r*sin(beta)], [r, beta])", "jacobian([r*cos(beta), r*sin(beta)], [r, beta])"),
        ("jacobian([2*r*cos(beta), r*sin(beta)], [r, beta])", "jacobian([r*cos(beta), r*sin(beta)], [r, beta])"),
    ],
)
def test_a_slip_inside_of_what_is_worked_out_is_found(wrong: str, right: str):
    verdict = decided(quantity="polar.jacobian", formula=wrong)
    assert right in [one.formula for one in verdict.suggestions]


@pytest.mark.parametrize(
    ("left", "right"),
    [
        ("sum(j^2, j, 1, n)", "n*(n + 1)*(2*n + 1)/6"),
        ("sum(i*c, i, 1, n)", "c*n*(n + 1)/2"),
        ("integral(exp(-b*j), j, 0, c)", "(1 - exp(-b*c))/b"),
        ("j + sum(j, j, 1, n)", "2*a + n*(n + 1)/2"),
    ],
)
def test_an_index_hides_a_definition_of_its_name_within_its_sum_alone(left: str, right: str):
    own = world_of([{"symbols": SYMBOLS | {"n": {"unit": "1", "low": 1, "high": 9, "whole": True}}}])
    let = {"j": "2*a", "c": "a*b"}
    assert decided(own, left=left, right=right, let=let).verdict is Outcome.EQUAL
    assert decided(own, left=left, right=f"2*({right})", let=let).verdict is Outcome.DIFFERS
