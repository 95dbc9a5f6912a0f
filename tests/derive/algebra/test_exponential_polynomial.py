"""Exponential polynomials: reading, writing, arithmetic, and equality that decides."""

import mpmath
import pytest
import sympy
from hypothesis import assume, given
from hypothesis import strategies as st

from radartrack.derive import symbolic as sp
from radartrack.derive.algebra.exponential_polynomial import ExponentialPolynomial, NotExponentialPolynomial, ring_over
from tests.examples import share
from tests.expressions import exponential_polynomials, linear, monomials, number, rational_points

x, y = sympy.symbols("x y", real=True)
RING = ring_over([y, x])
expressions = exponential_polynomials(x, y)
points = rational_points(x, y)


WAVES = [sympy.sin, sympy.cos, sympy.sinh, sympy.cosh]
Point = dict[sympy.Symbol, sympy.Rational]


def read(expression: sympy.Expr) -> ExponentialPolynomial:
    return ExponentialPolynomial.read(expression, RING)


def assert_close(first: sympy.Expr, second: sympy.Expr, point: Point) -> None:
    a, b = number(first, point), number(second, point)
    assert abs(a - b) <= mpmath.mpf("1e-40") * (1 + abs(a))


@given(expressions, points)
@share(0.4)
def test_writing_what_was_read_gives_the_same_function(expression: sympy.Expr, point: Point):
    written = read(expression).expression()
    assert_close(written, expression, point)
    assert not written.has(sympy.I)
    assert read(written) == read(expression)


@given(expressions, expressions, points)
@share(0.4)
def test_sums_products_and_powers_are_those_of_functions(first: sympy.Expr, second: sympy.Expr, point: Point):
    a, b = read(first), read(second)
    assert_close((a * b - a + b**2).expression(), first * second - first + second**2, point)
    assert -(a - b) == b - a


@given(expressions)
@share(0.4)
def test_reading_is_a_homomorphism_and_commutes_with_differentiation(expression: sympy.Expr):
    assert read(expression.diff(x)) == read(expression).differentiate(x)
    assert read(expression**2) == read(expression) ** 2


@given(expressions)
@share(0.4)
def test_expressions_that_are_the_same_function_are_equal_however_they_are_written(expression: sympy.Expr):
    for other in (expression.rewrite(WAVES, sympy.exp), sympy.expand(expression, trig=True), sympy.expand(expression)):
        assert read(other) == read(expression)
        assert hash(read(other)) == hash(read(expression))


@given(linear(x, y), linear(x, y))
@share(0.4)
def test_addition_theorems_hold(a: sympy.Expr, b: sympy.Expr):
    s, c = sympy.sin, sympy.cos
    assert read(s(a) * c(b) + c(a) * s(b)) == read(s(a + b))
    assert read(c(a) * c(b) - s(a) * s(b)) == read(c(a + b))
    assert read(sympy.cosh(a) ** 2 - sympy.sinh(a) ** 2) == read(c(b) ** 2 + s(b) ** 2)
    assert read(sp.expm1(a) + 1) == read(sympy.exp(a))
    assert read(sympy.exp(a) ** -3) == read(sympy.exp(-3 * a))


@given(expressions, monomials(x, y), linear(x, y))
@share(0.4)
def test_a_term_more_makes_another_function(expression: sympy.Expr, monomial: sympy.Expr, form: sympy.Expr):
    assert read(expression + monomial * sympy.exp(form)) != read(expression)
    assert read(expression) + read(monomial) != read(expression)


@given(expressions)
@share(0.4)
def test_the_difference_with_itself_is_zero_and_nothing_else_is(expression: sympy.Expr):
    value = read(expression)
    assert not value - value
    assume(value)
    assert any(
        abs(number(expression, {x: a, y: b})) > 1e-40 for a in (0, 1, sympy.Rational(-7, 5)) for b in (2, -3)
    ) or (not expression.free_symbols)


def test_exponents_of_different_kinds_are_kept_apart():
    values = [read(sympy.exp(e)) for e in (x, -x, 2 * x, x**2, x * y, sympy.Integer(1), sympy.Integer(2))]
    assert len({*values, read(sympy.Integer(1))}) == len(values) + 1


def test_complex_numbers_are_read():
    assert read(sympy.exp(sympy.I * x)) == read(sympy.cos(x) + sympy.I * sympy.sin(x))


@pytest.mark.parametrize(
    "expression",
    [
        1 / x,
        1 / (1 + sympy.exp(x)),
        sympy.sqrt(x),
        sympy.sqrt(2),
        x**y,
        2**x,
        sympy.log(x),
        sympy.tan(x),
        sympy.exp(sympy.exp(x)),
        sympy.cos(1 / x),
        sympy.sin(sympy.sin(x)),
        sympy.Float("0.5"),
        sympy.pi,
        sympy.oo,
        sympy.Symbol("z", real=True),
        sympy.Symbol("x"),
        sympy.Integral(x, (x, 0, y)),
        sympy.exp(sympy.pi * x),
    ],
    ids=str,
)
def test_what_is_no_exponential_polynomial_is_refused(expression: sympy.Expr):
    with pytest.raises(NotExponentialPolynomial):
        read(expression)


@given(st.permutations([x, y, *sympy.symbols("b a", real=True)]))
def test_the_ring_does_not_depend_on_the_order_in_which_symbols_are_named(symbols: list[sympy.Symbol]):
    assert [symbol.name for symbol in ring_over(symbols).symbols] == ["a", "b", "x", "y"]


def test_the_inverse_of_a_single_wave_is_that_of_the_function():
    wave = read(3 * sympy.exp(x - 2 * y))
    assert wave**-2 == read(sympy.exp(4 * y - 2 * x) / 9)
