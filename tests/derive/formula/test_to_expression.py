"""Trees as algebra: exact, and worth what the formula is worth."""

import operator
from collections.abc import Callable, Mapping
from fractions import Fraction
from functools import reduce

import mpmath
import pytest
import sympy
from hypothesis import given, reject
from hypothesis import strategies as st

from radartrack.derive.formula.functions import NUMBER_OF_ARGUMENTS
from radartrack.derive.reading import (
    Call,
    Constant,
    FormulaError,
    Name,
    Negation,
    Number,
    Power,
    Product,
    Quotient,
    Sum,
    Tree,
    children,
    read_latex,
    read_text,
    shape,
    to_expression,
)
from radartrack.derive.reading.grammar import check_tree
from radartrack.derive.symbolic import Expr, Integer, Rational, Symbol, cos, exp, pi
from tests.derive.formula.random_trees import NAMES, scalars

SYMBOLS = {name: Symbol(name, positive=True) for name in (*NAMES, "t")}
POINT = {name: mpmath.mpf(3 + 7 * index) / 11 for index, name in enumerate(SYMBOLS)}

FUNCTIONS: dict[str, Callable[..., mpmath.mpf]] = {
    "abs": abs,
    "hypot": mpmath.hypot,
    "log": mpmath.ln,
} | {name: getattr(mpmath, name) for name in NUMBER_OF_ARGUMENTS if name not in {"abs", "hypot", "log"}}
OPERATORS: dict[type, Callable[..., mpmath.mpf]] = {
    Sum: lambda *terms: mpmath.fsum(terms),
    Product: lambda *factors: reduce(operator.mul, factors),
    Quotient: operator.truediv,
    Power: operator.pow,
    Negation: operator.neg,
}


def value(tree: Tree) -> mpmath.mpf:
    """What a tree is worth at the point, computed node by node."""
    match tree:
        case Number(text):
            return mpmath.mpf(text)
        case Constant(name) | Name(name):
            return POINT[name] if isinstance(tree, Name) else getattr(mpmath, name) + 0
        case Call(function):
            return FUNCTIONS[function](*map(value, children(tree)))
        case _:
            return OPERATORS[type(tree)](*map(value, children(tree)))


def scalar(tree: Tree, symbols: Mapping[str, Expr]) -> Expr:
    expression = to_expression(tree, symbols)
    assert not isinstance(expression, tuple)
    return expression


def at_the_point(expression: Expr) -> mpmath.mpf:
    places = {SYMBOLS[name]: sympy.Float(x, 80) for name, x in POINT.items()}
    return mpmath.mpmathify(sympy.N(expression.subs(places), 60))


def well_conditioned(tree: Tree) -> mpmath.mpf:
    """The value of a tree, when 60 digits and 90 agree on what it is and it is a moderate real number."""
    try:
        with mpmath.workdps(90):
            fine = value(check_tree(tree))
        with mpmath.workdps(60):
            coarse = value(tree)
    except (FormulaError, ZeroDivisionError, OverflowError, ValueError):
        reject()
    if isinstance(fine, mpmath.mpc) or not 1e-30 < abs(fine) < 1e30 or abs(coarse / fine - 1) > 1e-45:
        reject()
    return fine


@given(scalars)
def test_an_expression_is_worth_what_its_tree_is_worth(tree: Tree):
    expected = well_conditioned(tree)
    try:
        expression = scalar(tree, SYMBOLS)
    except FormulaError:
        reject()
    assert abs(at_the_point(expression) / expected - 1) < 1e-30


@pytest.mark.parametrize("function", sorted(NUMBER_OF_ARGUMENTS))
@given(st.fractions(-3, 3, max_denominator=50))
def test_every_function_is_the_one_of_its_name(function: str, at: Fraction):
    number = NUMBER_OF_ARGUMENTS[function]
    arguments = [mpmath.mpf(at.numerator) / at.denominator, mpmath.mpf(2)][:number]
    try:
        expected = FUNCTIONS[function](*arguments)
    except ZeroDivisionError:
        reject()
    if isinstance(expected, mpmath.mpc) or not mpmath.isfinite(expected):
        reject()
    tree = read_text(f"{function}({', '.join(['x', '2'][:number])})", ["x"])
    expression = to_expression(tree, {"x": Rational(at.numerator, at.denominator)})
    assert abs(mpmath.mpmathify(sympy.N(expression, 30)) - expected) < 1e-12 * (1 + abs(expected))


def test_decimals_are_exact():
    assert scalar(read_text("0.1 + 0.2 - 0.3", []), {}) == Integer(0)
    assert to_expression(read_text("2.5e-3", []), {}) == Rational(1, 400)
    assert not scalar(read_text("0.5*t**0.5", ["t"]), SYMBOLS).has(sympy.Float)


def test_constants_are_symbolic():
    assert to_expression(read_text("pi*e**2", []), {}) == pi * exp(2)


def test_powers_of_e_are_exponentials():
    t = SYMBOLS["t"]
    assert to_expression(read_text("e**(-t)", ["t"]), SYMBOLS) == exp(-t)
    assert to_expression(read_latex("e^{-t}", ["t"]), SYMBOLS) == exp(-t)


def test_arrays_become_nested_tuples():
    t = SYMBOLS["t"]
    tree = read_text("2*[[t, 1], [0, -t]]/3 - [[1, 0], [0, t]]", ["t"])
    assert shape(tree) == (2, 2)
    assert to_expression(tree, SYMBOLS) == (
        (2 * t / 3 - 1, Rational(2, 3)),
        (Integer(0), -5 * t / 3),
    )


def test_a_symbol_may_stand_for_an_expression():
    t = SYMBOLS["t"]
    assert to_expression(read_text("cos(D)", ["D"]), {"D": t**2}) == cos(t**2)


def test_a_vector_in_a_power_is_refused_even_if_no_reader_saw_it():
    with pytest.raises(FormulaError, match="as many rows as columns"):
        to_expression(Power(read_text("[t, 1]", ["t"]), Number("2")), SYMBOLS)


def test_a_name_without_a_symbol_is_refused():
    with pytest.raises(FormulaError, match="D is not a name here"):
        to_expression(read_text("2*D", ["D"]), {"t": SYMBOLS["t"]})


@pytest.mark.parametrize(
    "formula",
    [
        "1/(t - t)",
        "log(t - t)",
        "t*tan(pi/2)",
        "0*tan(pi/2)",
        "sqrt(-t)",
        "(-t)**0.5",
        "atan2(t - t, t - t)",
        "[1, sqrt(-t)]",
    ],
)
def test_what_is_infinite_or_imaginary_is_refused(formula: str):
    with pytest.raises(FormulaError, match="this is not a real number"):
        to_expression(read_text(formula, ["t"]), SYMBOLS)


@pytest.mark.parametrize("around", ["1/{}", "t + 1/{}", "exp(-{}**2)", "tanh{}", "{}**0", "{}**(-2)"])
@pytest.mark.parametrize("part", ["1/(t - t)", "(0*t)**(-1)", "csc(t - t)", "cot(t - t)", "atan2(0*t, t - t)"])
def test_what_stands_around_it_does_not_hide_that_a_part_has_no_value(around: str, part: str):
    with pytest.raises(FormulaError, match="this is not a real number"):
        to_expression(read_text(around.format(f"({part})"), ["t"]), SYMBOLS)


@pytest.mark.parametrize(
    ("formula", "fault"),
    [
        ("2*t + cos(1/(t - t))", "1/(t - t)"),
        ("[t, t**2*(1 + sqrt(-t))]", "sqrt(-t)"),
        ("t/(t - t) + log(t - t)", "t/(t - t)"),
    ],
)
def test_the_first_part_that_is_not_real_is_pointed_at(formula: str, fault: str):
    with pytest.raises(FormulaError) as refused:
        to_expression(read_text(formula, ["t"]), SYMBOLS)
    assert refused.value.span is not None
    assert formula[slice(*refused.value.span)] == fault
