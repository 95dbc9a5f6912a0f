"""Definitions of a paper: in any order, of any shape, in letters that mean something else elsewhere."""

from __future__ import annotations

import re
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from radartrack.derive.catalogue import catalogue
from radartrack.derive.checking.asking import ask, ask_identity
from radartrack.derive.checking.check import check
from radartrack.derive.checking.question.declared_world import world_of
from radartrack.derive.checking.question.world import World
from radartrack.derive.checking.reporting.verdict import Outcome, Verdict
from radartrack.derive.formula.error import FormulaError
from radartrack.derive.verbs.no_closed_form import NoClosedForm

UNCORRELATED = {"rho": "0"}
COVARIANCE = "(r*sigma_beta*sin(beta))^2 + (sigma_r*cos(beta))^2"
LETTERS = {"x": {"unit": "m"}, "y": {"unit": "m"}, "t": {"unit": "s"}, "n": {"unit": "1"}}


def world(**tables: Any) -> World:
    return world_of([{"symbols": LETTERS, **tables}])


def verdict(left: str, right: str, world: World) -> Verdict:
    *_, last = ask_identity(left, right, world=world).answers()
    return last


parts = st.sampled_from(["{0} + {1}", "{0}*{1}", "{0} - 2*{1}", "({0})^2 + {1}", "sin({0}) + {1}", "{0}/(3 + {1}^2)"])


@given(st.lists(st.tuples(parts, st.integers(0, 9), st.integers(0, 9)), min_size=1, max_size=5), st.randoms())
@settings(max_examples=25)
def test_definitions_in_any_order_mean_what_is_put_in_for_them(rows: list[tuple[str, int, int]], random: Any):
    let = {"d0": "n + 1"}
    for place, (part, *others) in enumerate(rows, start=1):
        let[f"d{place}"] = part.format(*(f"d{other % place}" for other in others))
    put_in = f"d{len(rows)}"
    for place in reversed(range(len(rows) + 1)):
        put_in = re.sub(rf"\bd{place}\b", f"({let[f'd{place}']})", put_in)
    shuffled = list(let.items())
    random.shuffle(shuffled)
    found = verdict(f"d{len(rows)}", put_in, world(let=dict(shuffled)))
    assert found.verdict is Outcome.EQUAL
    assert not verdict(f"d{len(rows)}", f"{put_in} + n", world(let=dict(shuffled))).is_equal


@pytest.mark.parametrize("length", [1, 2, 3, 5])
def test_definitions_that_need_each_other_are_named(length: int):
    let = {f"d{place}": f"d{(place + 1) % length} + n" for place in range(length)}
    with pytest.raises(FormulaError, match="defined by itself: " + " needs ".join([*let, "d0"])):
        ask_identity("d0", "n", world=world(let=let))


UNUSED = ["unused + 1", "1 +", "no_such_letter", "no.such.quantity", "[1, 2; 3]", "sum(1/j, j, 1, n)", "x + t", "1/0"]


@pytest.mark.parametrize("definition", UNUSED)
def test_a_definition_of_a_file_that_is_not_used_does_no_harm(definition: str):
    assert verdict("2*a", "2*n", world(let={"unused": definition, "a": "n"})).is_equal
    assert check("polar.map[0]", "a*cos(beta)", world=world(let={"unused": definition, "a": "r"})).is_equal


@pytest.mark.parametrize("definition", [*UNUSED[:2], "sigma_bta", *UNUSED[3:6]])
def test_one_that_is_used_and_cannot_be_read_is_told_by_its_name(definition: str):
    with pytest.raises((FormulaError, NoClosedForm, KeyError), match=r"let unused|no\.such\.quantity"):
        ask_identity("unused", "n", world=world(let={"unused": definition}))


@pytest.mark.parametrize("symbol", ["r", "beta", "sigma_r", "sigma_beta"])
def test_a_letter_that_the_catalogue_uses_otherwise_has_the_meaning_of_the_paper(symbol: str):
    swapped = re.sub(rf"\b{symbol}\b", "rho", COVARIANCE)
    assert check("polar.covariance.linear[0,0]", swapped, let={"rho": symbol}, given=UNCORRELATED).is_equal
    assert not check(
        "polar.covariance.linear[0,0]", COVARIANCE, let={symbol: f"2*{symbol}"}, given=UNCORRELATED
    ).is_equal
    halved = re.sub(rf"\b{symbol}\b", f"({symbol}/2)", COVARIANCE)
    assert check("polar.covariance.linear[0,0]", halved, let={symbol: f"2*{symbol}"}, given=UNCORRELATED).is_equal


def test_a_letter_of_another_unit_is_another_symbol():
    own = world_of([{"symbols": {"rho": {"unit": "m"}}, "given": UNCORRELATED}])
    formula = "(rho*sigma_beta*sin(beta))^2 + (sigma_r*cos(beta))^2"
    assert not check("polar.covariance.linear[0,0]", formula, world=own).is_equal
    assert check("polar.covariance.linear[0,0]", formula, world=own, given={"r": "rho"}).is_equal


def test_a_letter_of_the_same_unit_is_the_symbol_of_the_quantity_where_the_paper_has_it():
    own = world_of([{"symbols": {"beta": {"unit": "deg", "low": 1, "high": 89}}}])
    assert check("polar.map[0]", "r*sqrt(cos(beta)^2)", world=own).is_equal
    assert check("polar.map[0]", "r*sqrt(cos(beta)^2)").verdict is Outcome.DIFFERS


@pytest.mark.parametrize("zero", ["0", "1 - 1", "n - n", "0*t", "[0, 0][1]", "trace([0, 1; 1, 0])"])
def test_zero_has_every_unit(zero: str):
    own = world(let={"b": zero, "d": "sqrt((x - b)^2 + y^2)"})
    assert verdict("d", "sqrt(x^2 + y^2)", own).is_equal
    assert verdict("d + x", "2*sqrt(x^2 + y^2)", own).verdict is Outcome.DIFFERS


@pytest.mark.parametrize("wrong", ["x + t", "[x + t, x][0]", "sqrt(x^2 + t)", "integral(x + s, s, 0, t)", "sin(x)*y"])
def test_a_wrong_unit_inside_of_a_definition_is_a_verdict_that_names_it(wrong: str):
    own = world(let={"b": wrong, "c": "2*b"}, define=[{"name": "own.b", "is": wrong}])
    for formula, name in (("b", "let b"), ("c", "let b"), ("own.b", "define own.b")):
        found = verdict("y", formula, own) if "." not in formula else check(formula, "y", world=own)
        assert found.verdict is Outcome.WRONG_DIMENSIONS
        assert name in found.reason


@pytest.mark.parametrize(
    ("formula", "is_right"),
    [
        ("A*B", True),
        ("B*A", False),
        ("A @ B", True),
        ("(A.T*B).T", False),
        ("inv(inv(A*B))", True),
        ("A*B*eye(2)", True),
    ],
)
def test_a_definition_may_be_a_matrix(formula: str, is_right: bool):
    own = world(let={"A": "[1, n; 0, 1]", "B": "[2, 0; n, 1]"})
    assert verdict("[2 + n^2, n; n, 1]", formula, own).is_equal is is_right


@pytest.mark.parametrize("name", [one for one in catalogue() if one.startswith(("polar.", "observe.polar."))][:12])
def test_a_quantity_by_its_name_is_that_quantity(name: str):
    assert ask(name, name).is_equal
    assert ask_identity(f"2*{name}", f"{name} + {name}").is_equal


GROWING = {
    "squares": ("d{0}*d{0}", "n"),
    "sums": ("d{0} + n*d{0}", "n"),
    "numbers": ("d{0}^2 + d{0}", "3"),
    "matrices": ("d{0}*d{0}", "[n, 1; 1, n]"),
    "transposes": ("d{0} + d{0}.T", "[n, 1; 2, n]"),
}


@pytest.mark.parametrize("kind", GROWING)
def test_definitions_that_grow_without_bound_are_refused_with_a_word(kind: str):
    step, first = GROWING[kind]
    let = {f"d{place}": step.format(place + 1) for place in range(60)} | {"d60": first}
    with pytest.raises(FormulaError, match=r"at most|more than"):
        ask_identity("d0", "n", world=world(let=let))


@pytest.mark.parametrize(
    "formula",
    [
        "sum(1/(n + j), j, 1, 10^9)",
        f"trace(expm([{'; '.join(', '.join(['n'] * 12) for _ in range(12))}]))",
        f"expm([{'; '.join(', '.join(f'n^{i + j}' for j in range(1, 8)) for i in range(7))}])[0, 0]",
        f"det([{'; '.join(', '.join(f'n + {i}*{j}' for j in range(12)) for i in range(12))}])",
        "integral(exp(-n*s)*s^60, s, 0, 1)",
        "limit(sin(n*k)/atan(k), k, inf)",
    ],
)
def test_what_is_too_much_says_so(formula: str):
    own = world_of([{"symbols": {**LETTERS, "k": {"unit": "1", "low": 1, "high": 9}}}])
    with pytest.raises(NoClosedForm):
        ask_identity("n", formula, world=own)
