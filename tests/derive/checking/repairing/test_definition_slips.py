"""A slip in a definition is looked for there, through definitions of definitions, and counts once."""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping
from itertools import islice
from random import Random

import pytest
import sympy

from radartrack.derive import check
from radartrack.derive.catalogue import catalogue
from radartrack.derive.checking.question.compared_quantity import refer
from radartrack.derive.checking.question.printed_formula import names_for
from radartrack.derive.checking.reporting.verdict import Outcome
from radartrack.derive.formula.error import FormulaError
from radartrack.derive.formula.from_expression import to_tree
from radartrack.derive.formula.printing import to_text
from radartrack.derive.language.tensor import Tensor
from radartrack.derive.reading.text import read_text
from radartrack.derive.symbolic import Expr
from tests.derive.checking.repairing.mutants import mutants

THOROUGH = int(os.environ.get("RADARTRACK_MUTANTS", "2")) >= 100
SLIPS = 200 if THOROUGH else 12
LONG = 1500  # characters of a tensor
MOST = 12  # definitions
SHARE = 0.9
WRONG = {Outcome.DIFFERS, Outcome.WRONG_DIMENSIONS}


def _text(expression: Expr) -> str:
    return to_text(to_tree(expression))


def _printed(entries: Tensor[Expr]) -> str:
    if not entries.shape:
        return _text(entries.entries[0])
    return "[" + ", ".join(map(_printed, entries.parts())) + "]"


def _over_definitions(name: str) -> tuple[str, dict[str, str]] | None:
    """A quantity over its common subexpressions t1, t2 and so on, as code is printed."""
    expression = catalogue()[name].expression
    if len(str(expression.entries)) > LONG or any(entry.has(sympy.erf, sympy.Heaviside) for entry in expression):
        return None
    names = (sympy.Symbol(f"t{place}", real=True) for place in range(1, 100))
    definitions, entries = sympy.cse(expression.entries, symbols=names)
    if not 1 <= len(definitions) <= MOST:
        return None
    return _printed(Tensor(expression.shape, tuple(entries))), {str(one): _text(value) for one, value in definitions}


def _slips() -> Iterator[tuple[str, str, dict[str, str], str]]:
    """Quantities over definitions one of which is misprinted, and which."""
    random = Random("definitions")
    names = sorted(catalogue())
    while True:
        name = random.choice(names)
        if (found := _over_definitions(name)) is None:
            continue
        printed, let = found
        chosen = random.choice(sorted(let))
        before = list(let)[: list(let).index(chosen)]
        dimensions = names_for(refer(name), {one: let[one] for one in before}).dimensions
        tree = read_text(let[chosen], dimensions)
        for slip in mutants(tree, dimensions, 1, random):
            yield name, printed, let | {chosen: to_text(slip)}, chosen


def test_a_slip_in_a_definition_is_told_there() -> None:
    told = []
    for name, printed, let, chosen in islice(_slips(), SLIPS):
        right = _over_definitions(name)
        assert right is not None
        try:
            verdict = check(name, printed, let=let)
        except FormulaError:
            continue  # a slip may leave no real number
        if verdict.is_equal:
            assert _is_the_same(name, printed, let, right[1])
            continue
        assert verdict.verdict in WRONG
        definitions = {one.definition for one in verdict.suggestions}
        found = bool(definitions - {""})  # another definition may undo the slip as well
        told.append(found)
        if not found:
            print(name, chosen, let[chosen], "for", right[1][chosen], "|", verdict.reason)
    assert sum(told) >= SHARE * len(told), f"{sum(told)} of {len(told)}"


def _is_the_same(name: str, printed: str, first: Mapping[str, str], second: Mapping[str, str]) -> bool:
    """Whether both definitions give the same formula, by SymPy alone."""
    one, other = (names_for(refer(name), dict(let)) for let in (first, second))
    changed = [key for key in first if first[key] != second[key]]
    return all(sympy.simplify(one.numbers[key] - other.numbers[key]) == 0 for key in changed) or key_unused(
        printed, changed
    )


def key_unused(printed: str, changed: list[str]) -> bool:
    """Whether what was changed changes nothing as it does not occur."""
    return not any(key in printed for key in changed)


def test_definitions_that_are_right_are_equal_through_all_of_them() -> None:
    found = ((name, one) for name in sorted(catalogue()) if (one := _over_definitions(name)) is not None)
    for name, (printed, let) in islice(found, None if THOROUGH else 8):
        assert check(name, printed, let=let).is_equal, name


@pytest.mark.parametrize(
    ("name", "formula", "let", "mended"),
    [
        (
            "polar.unbiased.estimate",
            "[r*cos(beta)/lam, r*sin(beta)/lam]",
            {"lam": "exp(-sigma_beta/2)"},
            "lam = exp(-sigma_beta**2/2)",
        ),
        (
            "polar.unbiased.covariance[0,0]",
            "(1/l^2 - 2)*r^2*cos(beta)^2 + (r^2 + sigma_r^2)*(1 + lp*cos(2*beta))/2",
            {"l": "exp(-sigma_beta^2/2)", "lp": "l^2"},
            "lp = l**4",
        ),
        (
            "ruv.covariance.linear[2,2]",
            "w^2*sigma_r^2 + r^2*(u^2*sigma_u^2 + v^2*sigma_v^2)/w^2",
            {"w": "sqrt(1 - u^2 + v^2)"},
            "w = sqrt(1 - u**2 - v**2)",
        ),
        (
            "observe.spherical.jacobian",
            "[[t12, y*t8, z*t8], [y/t4, -x/t4, 0], [-t9*t11, -t10*t11, t6*t7]]",
            {
                "t1": "x^2",
                "t2": "y^2",
                "t3": "z^2",
                "t4": "t1 - t2",
                "t5": "t4 + t3",
                "t6": "sqrt(t4)",
                "t7": "1/t5",
                "t8": "sqrt(t7)",
                "t9": "x*z",
                "t10": "y*z",
                "t11": "t7/t6",
                "t12": "x*t8",
            },
            "t4 = t1 + t2",
        ),
    ],
)
def test_the_definition_to_mend_is_named_with_what_it_should_be(
    name: str, formula: str, let: Mapping[str, str], mended: str
) -> None:
    given = {"rho": "0"} if "observe" not in name else None
    verdict = check(name, formula, given=given, let=let)
    assert verdict.verdict in WRONG
    assert mended in [one.formula for one in verdict.suggestions]
    (one,) = (suggestion for suggestion in verdict.suggestions if suggestion.formula == mended)
    assert one.definition == mended.partition(" ")[0]
    assert one.proved


def test_two_slips_in_a_long_formula_are_told_term_by_term() -> None:
    right = (
        "r**2*exp(sigma_beta**2)*cos(2*beta)/2 + r**2*exp(sigma_beta**2)/2 - r**2*cos(2*beta) - r**2/2 + sigma_r**2/2"
        " + (r**2/2 + sigma_r**2/2)*exp(-2*sigma_beta**2)*cos(2*beta)"
    )
    name, given = "polar.unbiased.covariance[0,0]", {"rho": "0"}
    assert check(name, right, given=given).is_equal
    wrong = right.replace("exp(sigma_beta**2)/2", "exp(sigma_beta**2)/3").replace("- r**2/2", "- 5*r**2/7")
    terms = {(one.term, one.printed, one.derived) for one in check(name, wrong, given=given).terms}
    assert terms == {("r**2*exp(sigma_beta**2)", "1/3", "1/2"), ("r**2", "-5/7", "-1/2")}


def test_a_formula_that_is_one_edit_from_another_quantity_is_told_so() -> None:
    formula = "[-r*sigma_beta**2*cos(beta)/2, r*sigma_beta**2*sin(beta)/2]"
    (one,) = check("polar.bias.averaged", formula).suggestions
    assert one.entry == (1,)
    assert "if polar.bias.second_order is meant when rho = 0" in one.edit


@pytest.mark.parametrize(
    ("name", "formula"),
    [
        ("polar.bias.truth[1]", "r*sin(beta)*(exp(-sigma_beta^2/2) - 1)"),
        ("polar.map[0]", "r*cos(beta)^2"),
        ("polar.bias.second_order[0]", "-r*cos(beta)*sigma_beta^2/3 + r"),
        ("polar.covariance.linear[0,1]", "r^2*sin(2*beta)"),
    ],
)
def test_no_suggestion_is_what_is_printed(name: str, formula: str) -> None:
    for one in check(name, formula).suggestions:
        before, should, after = one.edit.partition(" should be ")
        assert not should or before != after.removesuffix(" when rho = 0")
