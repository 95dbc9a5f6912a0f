"""Formulas of the catalogue, written in the dialects and languages of others, are read as what they are."""

from functools import cache

import pytest

from radartrack.derive.algebra.equality import proved_equal
from radartrack.derive.catalogue import find
from radartrack.derive.checking.reporting.derived_formula import as_printed
from radartrack.derive.formula.typeset import to_typeset
from radartrack.derive.reading import Call, Tree, names, read_formula, to_expression, walk
from radartrack.derive.symbolic import Expr, Symbol
from tests.derive.reading.printers import DIALECTS, LANGUAGES

SAMPLE = (
    "polar.map",
    "polar.bias.truth",
    "polar.covariance.linear",
    "polar.unbiased.estimate",
    "spherical.jacobian",
    "polar_doppler.map",
    "ruv.map",
    "observe.polar_doppler.jacobian",
    "observe.spherical.map",
    "motion.constant_velocity.process_noise.continuous",
    "finite_sample.degree1.gain",
)
LONGEST = 60  # nodes of an entry


@cache
def entries() -> list[tuple[str, Tree, Expr]]:
    """Entries as people print them, with the expressions that they are."""
    found: list[tuple[str, Tree, Expr]] = []
    for name in SAMPLE:
        for index, expression in find(name).expression.items():
            tree = as_printed(expression)
            if sum(1 for _ in walk(tree)) <= LONGEST and names(tree):
                found.append((f"{name}{list(index)}", tree, expression))
    return found


def check_equal(read: Tree, expression: Expr, where: str) -> None:
    symbols = {symbol.name: symbol for symbol in expression.free_symbols}
    assert names(read) <= symbols.keys(), where
    again = to_expression(read, symbols)
    assert not isinstance(again, tuple)
    assert again == expression or proved_equal(again, expression), where


def test_the_sample_has_formulas_of_every_kind():
    functions = {node.function for _, tree, _ in entries() for _, node in walk(tree) if isinstance(node, Call)}
    assert len(entries()) >= 40
    assert {"sin", "cos", "sqrt"} <= functions


@pytest.mark.parametrize("dialect", DIALECTS)
@pytest.mark.parametrize("is_known", [True, False], ids=["names known", "names not known"])
def test_latex_of_any_dialect_is_read_as_the_formula_that_it_is(dialect: str, is_known: bool):
    for where, tree, expression in entries():
        latex = DIALECTS[dialect].formula(tree)
        known = {symbol.name for symbol in expression.free_symbols} if is_known else None
        reading = read_formula(latex, "latex", known)
        check_equal(reading.tree, expression, f"{where}: {latex}")
        assert reading.unknown == (frozenset() if is_known else names(tree))


@pytest.mark.parametrize("language", LANGUAGES)
def test_code_of_any_language_is_read_as_the_formula_that_it_is(language: str):
    if language != "python":
        pytest.importorskip("tree_sitter")
    for where, tree, expression in entries():
        code = LANGUAGES[language].formula(tree)
        for source in (code, f"y = {code};", f"f = 2;\n\ny = {code};\n"):
            check_equal(read_formula(source, language, None).tree, expression, f"{where}: {source}")


def test_what_is_typeset_is_read_again_as_text_from_a_page():
    for where, tree, expression in entries():
        known = {symbol.name for symbol in expression.free_symbols}
        typeset = to_typeset(tree)
        if "/" not in typeset:  # after a slash print leaves open what is below
            check_equal(read_formula(typeset, "printed", known).tree, expression, f"{where}: {typeset}")


def test_a_spoilt_formula_is_not_read_as_the_right_one():
    """The property above would not see a reader that reads nothing."""
    expression = Symbol("r") * 2
    read = read_formula(r"\[ 3 \hat{r} \]", "latex", None).tree
    assert to_expression(read, {"r": Symbol("r")}) != expression
