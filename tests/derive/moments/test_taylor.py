"""Jacobian, Hessian and second-order moments of random maps by their definitions, in indices."""

import mpmath
import sympy
from hypothesis import given
from hypothesis import strategies as st

from radartrack.derive.language.tensor import Tensor
from radartrack.derive.moments import taylor
from tests.examples import share
from tests.expressions import NUMBERS, exponential_polynomials, number, rational_points

Outputs = Tensor[sympy.Expr]
x, y = sympy.symbols("x y", real=True)
maps = st.tuples(*[exponential_polynomials(x, y)] * 3).map(lambda entries: Tensor((3,), entries))
covariances = st.tuples(NUMBERS, NUMBERS, NUMBERS).map(lambda k: ((k[0], k[1]), (k[1], k[2])))


@given(maps, rational_points(x, y))
@share(0.1)
def test_derivatives_are_those_that_mpmath_takes(outputs: Outputs, point: dict[sympy.Symbol, sympy.Rational]):
    first, second = taylor.jacobian(outputs, (x, y)), taylor.hessian(outputs, (x, y))
    assert (first.shape, second.shape) == ((3, 2), (3, 2, 2))
    with mpmath.workdps(60):
        at = (mpmath.mpf(point[x].p) / point[x].q, mpmath.mpf(point[y].p) / point[y].q)
        for a, h in enumerate(outputs):
            plain = sympy.lambdify((x, y), h, [{"expm1": mpmath.expm1}, "mpmath"])
            for orders in ((1, 0), (0, 1), (2, 0), (1, 1), (0, 2)):
                index = (a, *[0] * orders[0], *[1] * orders[1])
                found = number((first if sum(orders) == 1 else second)[index], point)
                assert abs(found - mpmath.diff(plain, at, orders)) < mpmath.mpf("1e-25") * (1 + abs(found))


@given(maps, covariances)
@share(0.04)
def test_moments_are_their_definitions_in_matrices(outputs: Outputs, covariance: tuple[tuple[sympy.Expr, ...], ...]):
    K, J = sympy.Matrix(covariance), sympy.Matrix(list(outputs)).jacobian([x, y])
    G = [sympy.hessian(h, (x, y)) for h in outputs]
    linear = taylor.linear_covariance(outputs, (x, y), covariance)
    quadratic = taylor.second_order_covariance(outputs, (x, y), covariance)
    bias = taylor.second_order_bias(outputs, (x, y), covariance)
    for a in range(3):
        assert sympy.expand(bias[a,] - (K * G[a]).trace() / 2) == 0
        for b in range(3):
            assert sympy.expand(linear[a, b] - (J * K * J.T)[a, b]) == 0
            assert sympy.expand(quadratic[a, b] - linear[a, b] - (G[a] * K * G[b] * K).trace() / 2) == 0
