"""Every catalogue entry: rewritings are proved equal, slips are told from it and traced to it.

Here a few slips of one entry of each quantity; RADARTRACK_MUTANTS=100 takes every entry and a hundred slips.
"""

from __future__ import annotations

import os
from functools import cache
from random import Random

import mpmath
import pytest
import sympy

from radartrack.derive.algebra.equality import proved_equal
from radartrack.derive.catalogue import catalogue
from radartrack.derive.checking.answers import Question
from radartrack.derive.checking.question.compared_quantity import Reference, refer
from radartrack.derive.checking.question.names import Names
from radartrack.derive.checking.question.printed_formula import Printed, names_for
from radartrack.derive.checking.repairing.smallest_edit import suggest
from radartrack.derive.checking.reporting.derived_formula import shown
from radartrack.derive.checking.reporting.verdict import Outcome
from radartrack.derive.evaluation.points import domain_points, generic_points
from radartrack.derive.formula.error import FormulaError
from radartrack.derive.formula.printing import to_text
from radartrack.derive.formula.tree import Tree
from radartrack.derive.language.tensor import Tensor
from radartrack.derive.language.variable import Variable
from radartrack.derive.reading.characters import MAX_CHARACTERS
from radartrack.derive.reading.text import read_text
from radartrack.derive.symbolic import Abbreviation, Expr
from tests.derive.checking.repairing.mutants import mutants, rewritings

MUTANTS = int(os.environ.get("RADARTRACK_MUTANTS", "2"))
THOROUGH = MUTANTS >= 100
LONG = MAX_CHARACTERS if THOROUGH else 500  # characters of a formula
SHARE = 0.9
DIGITS = 60  # of the oracle: one more in a number of six digits may change a gain by a part in 10**10
SAME = 1e-30


@cache
def _entries(name: str) -> list[tuple[Reference, Expr]]:
    """Different entries of a quantity that are formulas, not numbers; outside the thorough run one of them."""
    quantity = catalogue()[name]
    found: dict[Expr, str] = {}
    for index, expression in quantity.expression.items():
        if expression.free_symbols:
            found.setdefault(expression, f"{name}[{','.join(map(str, index))}]" if index else name)
    chosen = [(expression, entry) for expression, entry in found.items() if len(str(expression)) <= LONG]
    if not THOROUGH:
        chosen = Random(name).sample(chosen, min(1, len(chosen)))
    return [(refer(entry), expression) for expression, entry in chosen]


@pytest.mark.parametrize("name", sorted(catalogue()))
def test_rewritten_formulas_are_proved_equal(name: str) -> None:
    for _, expression in _entries(name):
        for kind, rewritten in rewritings(expression).items():
            assert proved_equal(rewritten, expression), kind


@pytest.mark.parametrize("name", sorted(catalogue()))
def test_slips_are_told_from_the_formula_and_traced_to_it(name: str) -> None:
    for reference, expression in _entries(name):
        names = names_for(reference, {})
        tree = read_text(shown(Tensor((), (expression,))), names.values)
        slips = mutants(tree, names.dimensions, MUTANTS, Random(reference.text))
        told = [slip for slip in slips if _is_told_apart(slip, reference, names, expression)]
        traced = sum(_is_traced(slip, tree, reference, names, expression) for slip in told)
        assert traced >= SHARE * len(told) - (not THOROUGH), reference.text


def _is_told_apart(slip: Tree, reference: Reference, names: Names, expression: Expr) -> bool:
    """Whether the verdict is that it differs; False for a slip that changes nothing, or leaves no real number."""
    try:
        changed = names.read(slip)
    except FormulaError:
        return False
    printed = Printed(slip, Tensor((), (slip,)), Tensor((), (changed,)), names)
    outcome = Question(reference, printed, {}).finding(()).outcome
    if not _differ(changed, expression, reference.symbols):
        assert outcome in {Outcome.EQUAL, Outcome.EQUAL_NUMERICALLY}, to_text(slip)
        return False
    assert outcome in {Outcome.DIFFERS, Outcome.WRONG_DIMENSIONS}, to_text(slip)
    return True


def _is_traced(slip: Tree, tree: Tree, reference: Reference, names: Names, expression: Expr) -> bool:
    """Whether one of the first three suggestions is the formula itself, not only one that is equal to it."""
    found = suggest(slip, names, expression, reference.symbols, {})[:3]
    return any(names.read(read_text(one.formula, names.values)) == names.read(tree) for one in found)


def _without_abbreviations(expression: Expr) -> Expr:
    return expression.xreplace({call: call.expanded() for call in expression.atoms(Abbreviation)})


def _differ(first: Expr, second: Expr, symbols: tuple[Variable, ...]) -> bool:
    """Whether both differ at a point; an oracle that shares nothing with the checker."""
    plain = {symbol: sympy.Symbol(f"plain_{symbol.name}") for symbol in symbols}
    expressions = (_without_abbreviations(expression).xreplace(plain) for expression in (first, second))
    one, other = (sympy.lambdify(list(plain.values()), e, "mpmath") for e in expressions)
    for point in (*generic_points(symbols, 4), *domain_points(symbols, 12)):
        with mpmath.workdps(DIGITS):
            values = [mpmath.mpf(point[symbol.name]) for symbol in symbols]
            try:
                if not mpmath.almosteq(one(*values), other(*values), rel_eps=SAME, abs_eps=SAME):
                    return True
            except (ArithmeticError, AttributeError, TypeError, ValueError):  # mpmath of complex numbers
                return True
    return False


def test_a_checker_that_calls_everything_equal_is_caught(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("radartrack.derive.checking.answers.find_difference", lambda *_: None)
    monkeypatch.setattr("radartrack.derive.checking.answers.proved_equal", lambda *_: True)
    with pytest.raises(AssertionError):
        test_slips_are_told_from_the_formula_and_traced_to_it("polar.covariance.linear")


def test_a_search_that_finds_nothing_is_caught(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(globals(), "suggest", lambda *_: [])
    monkeypatch.setitem(globals(), "MUTANTS", 20)
    with pytest.raises(AssertionError):
        test_slips_are_told_from_the_formula_and_traced_to_it("polar.covariance.linear")
