"""The way back from an expression to a formula."""

import pytest
from hypothesis import given, reject

from radartrack.derive import symbolic as sp
from radartrack.derive.catalogue import catalogue
from radartrack.derive.formula.from_expression import to_tree
from radartrack.derive.formula.tree import parts
from radartrack.derive.language.quantity import Quantity
from radartrack.derive.reading import FormulaError, Tree, read_text, to_expression, to_text
from radartrack.derive.reading.grammar import check_tree
from radartrack.derive.symbolic import Expr
from tests.derive.formula.random_trees import NAMES, trees

x, y, z = (sp.Symbol(name, positive=True) for name in "xyz")
SYMBOLS = {name: sp.Symbol(name, positive=True) for name in NAMES}


@given(trees)
def test_the_formula_of_an_expression_is_read_as_that_expression(tree: Tree):
    try:
        expression = to_expression(check_tree(tree), SYMBOLS)
        found = check_tree(to_tree(expression)) if not isinstance(expression, tuple) else reject()
    except FormulaError:
        reject()
    assert to_expression(found, SYMBOLS) == expression


@pytest.mark.parametrize("quantity", catalogue().values(), ids=lambda quantity: quantity.name)
def test_derived_formulas_are_ordered_as_the_algebra_system_orders_them(quantity: Quantity):
    derived = quantity.expression.entries[0]
    expression = derived.xreplace({call: call.expanded() for call in derived.atoms(sp.Abbreviation)})
    assert to_text(to_tree(expression)) == str(expression).replace("Abs(", "abs(")


@pytest.mark.parametrize(
    ("expression", "formula"),
    [
        (-3 * x / 4, "-3*x/4"),
        (x**-2, "x**(-2)"),
        (y / x**2, "y/x**2"),
        (1 / x, "1/x"),
        (1 / (x * (x + y)), "1/(x*(x + y))"),
        (sp.sqrt(x), "sqrt(x)"),
        (1 / sp.sqrt(x), "1/sqrt(x)"),
        (y * x ** sp.Rational(-3, 2), "y/x**(3/2)"),
        (sp.sqrt(2) / (2 * sp.sqrt(sp.pi)), "sqrt(2)/(2*sqrt(pi))"),
        (z * x**-y, "z/x**y"),
        (sp.Rational(1, 2) ** x, "(1/2)**x"),
        (x - sp.sqrt(2), "x - sqrt(2)"),
        (z * (-x - y), "z*(-x - y)"),
        (-sp.Integer(2), "-2"),
        (sp.exp(-x) * sp.exp(sp.Integer(1)), "e*exp(-x)"),
        (sp.Abs(sp.Symbol("a")), "abs(a)"),
        (sp.hypot(x, y), "hypot(x, y)"),
        (sp.erf(x), "erf(x)"),
    ],
)
def test_it_is_written_as_people_write(expression: Expr, formula: str):
    assert to_text(to_tree(expression)) == formula


def test_equal_parts_are_one_object():
    tree = to_tree(x**2 * sp.cos(x) + sp.cos(x) ** 2 * sp.exp(x**2))
    assert tree == read_text(to_text(tree), ["x"])
    assert len(list(parts(tree))) == len(set(parts(tree)))
