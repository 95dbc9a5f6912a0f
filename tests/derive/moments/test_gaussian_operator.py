"""The operator e^(tL): against its series, against the expectation that it stands for, and by its laws."""

from fractions import Fraction
from math import factorial

import mpmath
import numpy as np
import pytest
import sympy
from hypothesis import given
from hypothesis import strategies as st

from radartrack.derive.algebra.exponential_polynomial import ExponentialPolynomial, NotExponentialPolynomial, ring_over
from radartrack.derive.moments.gaussian_operator import GaussianOperator
from tests.examples import share
from tests.expressions import NUMBERS, exponential_polynomials, number, rational_points

x, y, t = sympy.symbols("x y t", real=True)
RING = ring_over([x, y, t])
expressions = exponential_polynomials(x, y)
times = st.fractions(min_value=-2, max_value=2, max_denominator=5)
NODES = 100  # of quadrature along each axis: an exponential of ten deviations needs more than 60
Covariance = list[list[sympy.Expr]]
Point = dict[sympy.Symbol, sympy.Rational]


@st.composite
def covariances(draw: st.DrawFn) -> Covariance:
    """A Aᵀ for a random A: generic, correlated."""
    a = sympy.Matrix(2, 2, draw(st.tuples(*[NUMBERS] * 4))) / 3
    return [list(row) for row in (a * a.T).tolist()]


def read(expression: sympy.Expr) -> ExponentialPolynomial:
    return ExponentialPolynomial.read(expression, RING)


def by_differentiation(expression: sympy.Expr, covariance: Covariance) -> sympy.Expr:
    """L f by SymPy's differentiation."""
    pairs = [(i, j) for i in range(2) for j in range(2)]
    return sympy.Add(*(covariance[i][j] * expression.diff((x, y)[i], (x, y)[j]) / 2 for i, j in pairs))


@given(expressions, covariances())
@share(0.2)
def test_the_generator_is_half_the_weighted_sum_of_second_derivatives(expression: sympy.Expr, covariance: Covariance):
    operator = GaussianOperator((x, y), covariance)
    assert operator.generator(read(expression)) == read(by_differentiation(expression, covariance))


@given(exponential_polynomials(x, y), covariances(), rational_points(x, y), times)
@share(0.2)
def test_the_exponential_is_the_sum_of_its_series(
    expression: sympy.Expr,
    covariance: Covariance,
    point: Point,
    time: Fraction,
):
    operator, small = GaussianOperator((x, y), covariance), time / 400
    total, term = sympy.Integer(0), read(expression)
    for m in range(12):
        total += sympy.Rational(small.numerator, small.denominator) ** m / factorial(m) * term.expression()
        term = operator.generator(term)
    closed = operator.exponential(read(expression), small).expression()
    difference = number(closed, point) - number(total, point)
    assert abs(difference) < mpmath.mpf("1e-12") * (1 + abs(number(closed, point)))


@given(exponential_polynomials(x, y), covariances(), rational_points(x, y))
@share(0.2)
def test_the_exponential_is_the_expectation_over_gaussian_errors(
    expression: sympy.Expr, covariance: Covariance, point: Point
):
    closed = GaussianOperator((x, y), covariance).exponential(read(expression)).expression()
    expected = number(closed, point, digits=30)
    nodes, weights = np.polynomial.hermite_e.hermegauss(NODES)
    variances, axes = np.linalg.eigh(np.array(covariance, dtype=float))
    errors = axes * np.sqrt(np.clip(variances, 0, None)) @ np.stack(np.meshgrid(nodes, nodes)).reshape(2, -1)
    values = sympy.lambdify((x, y), expression, [{"expm1": np.expm1}, "numpy"])(
        float(point[x]) + errors[0], float(point[y]) + errors[1]
    )
    weight = np.outer(weights, weights).ravel() / weights.sum() ** 2
    everywhere, real = values * np.ones(NODES**2), float(expected.real)
    assert abs(weight @ everywhere - real) <= 1e-9 * (weight @ np.abs(everywhere) + abs(real))


@given(expressions, covariances(), times, times)
@share(0.2)
def test_times_add_and_minus_the_time_undoes_it(
    expression: sympy.Expr, covariance: Covariance, first: Fraction, second: Fraction
):
    operator, value = GaussianOperator((x, y), covariance), read(expression)
    twice = operator.exponential(operator.exponential(value, first), second)
    assert twice == operator.exponential(value, first + second)
    assert operator.exponential(operator.exponential(value, -first), first) == value
    assert operator.exponential(value, Fraction(0)) == value


@given(expressions, covariances())
@share(0.2)
def test_it_solves_the_heat_equation(expression: sympy.Expr, covariance: Covariance):
    growing = [[t * entry for entry in row] for row in covariance]
    value = GaussianOperator((x, y), growing).exponential(read(expression))
    assert value.differentiate(t) == GaussianOperator((x, y), covariance).generator(value)


@given(expressions, expressions, covariances(), NUMBERS)
@share(0.2)
def test_it_is_linear(first: sympy.Expr, second: sympy.Expr, covariance: Covariance, weight: sympy.Expr):
    operator = GaussianOperator((x, y), covariance)
    together = operator.exponential(read(first) + read(second).scale(weight))
    assert together == operator.exponential(read(first)) + operator.exponential(read(second)).scale(weight)


@pytest.mark.parametrize("exponent", [x**2, x * y, -(y**2) / 2 + x], ids=str)
def test_exponents_that_are_not_linear_are_refused(exponent: sympy.Expr):
    operator = GaussianOperator((x, y), [[sympy.Integer(1), sympy.Integer(0)], [sympy.Integer(0), sympy.Integer(1)]])
    for function in (sympy.exp, sympy.cos):
        with pytest.raises(NotExponentialPolynomial):
            operator.exponential(read(function(exponent)))


def test_what_does_not_vary_is_left_alone():
    one_variable = GaussianOperator((x,), [[sympy.Integer(3)]])
    assert one_variable.exponential(read(sympy.exp(y**2) * y)) == read(sympy.exp(y**2) * y)
