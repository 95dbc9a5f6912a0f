"""Equality of rational functions is proved, and only equality."""

import pytest
import sympy

from radartrack.derive.algebra.rational_function import NotRational, is_zero

x, y = sympy.symbols("x y")
EQUAL = [
    (1 / (x - y) - 1 / (x + y), 2 * y / (x**2 - y**2)),
    ((x + 1 / x) ** -2, x**2 / (x**2 + 1) ** 2),
    (x / 3 + sympy.Rational(1, 7), (7 * x + 3) / 21),
    (1 / (1 + 1 / (1 + 1 / x)), (x + 1) / (2 * x + 1)),
    ((x - y) ** -2, 1 / (x**2 - 2 * x * y + y**2)),
]


@pytest.mark.parametrize(("first", "second"), EQUAL)
def test_equal_rational_functions_are_proved_equal(first: sympy.Expr, second: sympy.Expr) -> None:
    assert is_zero(first - second)


@pytest.mark.parametrize(("first", "second"), EQUAL)
def test_a_small_change_is_noticed(first: sympy.Expr, second: sympy.Expr) -> None:
    assert not is_zero(first - second * (1 + sympy.Rational(1, 10**9)))
    assert not is_zero(first - second - x * y / 10**9)


def test_constants_are_compared_too() -> None:
    assert is_zero(sympy.Integer(0))
    assert not is_zero(sympy.Rational(1, 10**30))
    assert not is_zero(sympy.Rational(-1, 10**30))


@pytest.mark.parametrize("expression", [sympy.sqrt(x), sympy.sin(x), x**y, sympy.pi * x])
def test_what_is_not_rational_is_refused(expression: sympy.Expr) -> None:
    with pytest.raises(NotRational):
        is_zero(expression - x)


def test_a_denominator_that_vanishes_identically_is_refused() -> None:
    vanishing = sympy.Pow(sympy.Add(x, y, sympy.Mul(-1, x + y, evaluate=False), evaluate=False), -1, evaluate=False)
    with pytest.raises(NotRational, match="denominator"):
        is_zero(vanishing + x)
