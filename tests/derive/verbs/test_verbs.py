"""Verbs against definitions: sums term by term, integrals by quadrature, exponentials by their series."""

import math
import random
from collections.abc import Callable

import mpmath
import numpy as np
import pytest
import sympy
from hypothesis import given
from hypothesis import strategies as st

from radartrack.derive import symbolic as sp
from radartrack.derive.algebra.equality import proved_equal
from radartrack.derive.language.matrix import Matrix, identity, product, transposed
from radartrack.derive.symbolic import Expr
from radartrack.derive.verbs.derivatives import hessian, jacobian
from radartrack.derive.verbs.determinants import determinant, inverse
from radartrack.derive.verbs.expectation import expectation
from radartrack.derive.verbs.gates import probability, quantile
from radartrack.derive.verbs.integrals import integrated
from radartrack.derive.verbs.limit import limit
from radartrack.derive.verbs.matrix_exponential import exponential
from radartrack.derive.verbs.no_closed_form import NoClosedForm
from radartrack.derive.verbs.sums import summed
from radartrack.derive.verbs.taylor_polynomial import taylor
from tests.examples import share

a, q, T, sigma = (sp.Symbol(name, positive=True) for name in ("alpha", "q", "T", "sigma"))
w, x, y, s = (sp.Symbol(name, real=True) for name in ("omega", "x", "y", "s"))
j, k = sp.Symbol("j", positive=True), sp.Symbol("k", positive=True)
VALUES = {a: 0.37, q: 0.83, T: 1.9, sigma: 0.6, w: -1.3, x: 0.7, y: -1.1}
ZERO, ONE = sp.Integer(0), sp.Integer(1)
SMALL = st.integers(-4, 4)


def number(expression: Expr, **more: object) -> mpmath.mpf:
    """The value at generic points, by SymPy's own evaluation to 30 digits."""
    values = {**VALUES, **{sp.Symbol(name, positive=True): value for name, value in more.items()}}
    return mpmath.mpf(sympy.N(expression.xreplace({s: sympy.Float(v, 30) for s, v in values.items()}), 30))


TERMS = {
    "polynomial": 3 * j**4 - j * w + 2,
    "geometric": q**j,
    "mixed": j**2 * q ** (k - j) * w,
    "exponential": j * sp.exp(-a * j),
    "several bases": q**j * sp.exp(w * j) + (j - k) ** 3,
    "a power of a power": q ** (2 * j + 1) * j,
}


@pytest.mark.parametrize("term", TERMS.values(), ids=TERMS)
@pytest.mark.parametrize(("first", "last"), [(1, 9), (0, 0), (-3, 5)])
def test_a_sum_is_what_its_terms_add_up_to(term: Expr, first: int, last: int):
    closed = summed(term, j, sp.Integer(first), k)
    added = sum(number(term, j=sympy.Integer(n), k=sympy.Integer(last)) for n in range(first, last + 1))
    assert abs(number(closed, k=sympy.Integer(last)) - added) < 1e-12 * (1 + abs(added))


@share(1 / 2)
@given(st.lists(SMALL, min_size=1, max_size=7))
def test_the_sum_of_a_polynomial_to_one_more_grows_by_its_value(coefficients: list[int]):
    polynomial = sp.Add(*(c * j**n for n, c in enumerate(coefficients)))
    growth = summed(polynomial, j, ONE, k + 1) - summed(polynomial, j, ONE, k)
    assert proved_equal(growth, polynomial.xreplace({j: k + 1}))


def test_a_sum_without_a_closed_form_is_added_up_where_it_is_short_and_refused_where_it_is_not():
    assert summed(1 / j, j, ONE, sp.Integer(4)) == sp.Rational(25, 12)
    for last in (k, sp.Integer(10**9)):
        with pytest.raises(NoClosedForm, match="sum over j of 1/j"):
            summed(1 / j, j, ONE, last)


def test_a_long_sum_with_a_closed_form_takes_no_longer():
    assert summed(j, j, ONE, sp.Integer(10**9)) == sp.Integer(10**9 * (10**9 + 1) // 2)


INTEGRANDS = {
    "polynomial": s**3 - w * s,
    "decay": s**2 * sp.exp(-a * s),
    "wave": sp.cos(w * s) * sp.sin(2 * s + x),
    "damped wave": s * sp.exp(-a * s) * sp.sin(w * s + x) ** 2,
    "rational": (s + 1) / ((s + a) ** 2 * (s + q)),
    "circle": 1 / (s**2 + a**2),
    "shifted circle": (2 * s - 1) / (3 * s**2 + 2 * a * s + 5 * a**2),
    "improper": s**4 / (s + a),
}


@pytest.mark.parametrize("function", INTEGRANDS.values(), ids=INTEGRANDS)
def test_an_integral_is_what_quadrature_gives(function: Expr):
    closed = integrated(function, s, sp.Rational(1, 3), T)
    values = {symbol: value for symbol, value in VALUES.items() if symbol in function.free_symbols}
    plain = sympy.lambdify(s, function.xreplace(values), "mpmath")
    assert abs(number(closed) - mpmath.quad(plain, [mpmath.mpf(1) / 3, VALUES[T]])) < 1e-12


@pytest.mark.parametrize("function", [sp.exp(-(s**2)), sp.sqrt(s + a), 1 / (s**5 + s + a), sp.log(s)])
def test_an_integral_without_a_closed_form_is_refused(function: Expr):
    with pytest.raises(NoClosedForm):
        integrated(function, s, ZERO, T)


LIMITS = {
    "same degree": ((4 * k - 2) * k / (k * (k + 1)), sp.oo, 4),
    "lower degree": ((4 * k - 2) / (k * (k + 1)), sp.oo, 0),
    "decay beats powers": (k**9 * sp.exp(-a * k), sp.oo, 0),
    "growth against growth": ((sp.exp(a * k) + k) / (3 * sp.exp(a * k) - 1), sp.oo, sp.Rational(1, 3)),
    "a root": (sp.sqrt(1 + 1 / k) + sp.atan(1 / k), sp.oo, 1),
    "towards minus infinity": ((k**3 + 1) / (2 * k**3 - k), -sp.oo, sp.Rational(1, 2)),
    "a removable point": ((1 - sp.exp(-k * T)) / k, ZERO, T),
    "second order": ((1 - sp.cos(w * k)) / k**2, ZERO, w**2 / 2),
    "a regular point": ((k + 1) / (k + a), ONE, 2 / (1 + a)),
}


@pytest.mark.parametrize(("function", "point", "value"), LIMITS.values(), ids=LIMITS)
def test_limits(function: Expr, point: Expr, value: Expr | int):
    assert proved_equal(limit(function, k, point), ZERO + value)


ROOTS_AT_INFINITY = {
    "a difference": sp.sqrt(k**2 + k) - k,
    "two radicands": sp.sqrt(k**2 + a * k) - sp.sqrt(k**2 + w * k),
    "a cube root": k * ((k**3 + a * k) ** sp.Rational(1, 3) - k),
    "a quotient": k / sp.sqrt(k**2 + a**2),
    "a root of a quotient": sp.sqrt((4 * k**3 + 1) / (k**3 + k)),
    "a steady gain by its tracking index": 1 - ((4 + k - sp.sqrt(8 * k + k**2)) / 4) ** 2,
    "inside a cosine": sp.cos(a * (sp.sqrt(k + 1) - sp.sqrt(k)) * sp.sqrt(k)),
}


@pytest.mark.parametrize("function", ROOTS_AT_INFINITY.values(), ids=ROOTS_AT_INFINITY)
def test_a_limit_of_roots_is_what_they_come_to_far_out(function: Expr):
    exact = {symbol: sympy.Rational(str(value)) for symbol, value in VALUES.items()}
    far = sympy.N(function.xreplace({**exact, k: sympy.Integer(10) ** 24}), 30)
    assert abs(sympy.N(limit(function, k, sp.oo).xreplace(exact), 30) - far) < 1e-20


def test_a_limit_of_roots_where_both_vanish():
    assert proved_equal(limit((sp.sqrt(a**2 + k**2) - a) / k**2, k, ZERO), 1 / (2 * a))


@pytest.mark.parametrize(
    ("function", "point"),
    [
        (k**2 / (k + 1), sp.oo),
        (sp.sqrt(k), sp.oo),
        (sp.sqrt(k**2 + k) - k, -sp.oo),
        (sp.exp(w * k), sp.oo),
        (1 / k, ZERO),
        (sp.sin(k), sp.oo),
        (sp.log(k), sp.oo),
    ],
)
def test_a_limit_that_is_infinite_missing_or_open_is_refused(function: Expr, point: Expr):
    with pytest.raises(NoClosedForm):
        limit(function, k, point)


MATRICES = {
    "shift": ((ZERO, T, ZERO), (ZERO, ZERO, T), (ZERO, ZERO, ZERO)),
    "shift with one decay": ((ZERO, T, ZERO), (ZERO, ZERO, T), (ZERO, ZERO, -a * T)),
    "two decays": ((-a, x), (ZERO, -q)),
    "full": ((x, y), (w, a)),
    "turn": (
        (ZERO, T, ZERO, ZERO),
        (ZERO, ZERO, ZERO, -w * T),
        (ZERO, ZERO, ZERO, T),
        (ZERO, w * T, ZERO, ZERO),
    ),
    "rotation": ((ZERO, -w), (w, ZERO)),
    "saddle": ((ZERO, a**2), (ONE, ZERO)),
    "blocks apart": ((ZERO, ZERO, T), (ZERO, -a, ZERO), (ZERO, ZERO, ZERO)),
    "a double decay": ((-a, ONE), (ZERO, -a)),
}


@pytest.mark.parametrize("matrix", MATRICES.values(), ids=MATRICES)
def test_an_exponential_is_what_its_series_gives(matrix: tuple[tuple[Expr, ...], ...]):
    closed = exponential(matrix)
    expected = mpmath.expm(mpmath.matrix([[number(entry) for entry in row] for row in matrix]), method="taylor")
    for m, row in enumerate(closed):
        for n, entry in enumerate(row):
            assert abs(number(entry) - expected[m, n]) < 1e-13 * (1 + abs(expected[m, n]))


def test_an_exponential_too_large_or_without_closed_eigenvalues_is_refused():
    large = tuple(tuple(sp.Symbol(f"a_{m}_{n}") for n in range(12)) for m in range(12))
    companion = ((ZERO, ONE, ZERO), (ZERO, ZERO, ONE), (x, y, w))
    for matrix in (large, companion):
        with pytest.raises(NoClosedForm):
            exponential(matrix)


@share(1 / 2)
@given(st.integers(1, 5), st.randoms(use_true_random=False))
def test_inverse_and_determinant_of_whole_numbers_are_sympys(order: int, source: random.Random):
    rows = [[source.randint(-5, 5) for _ in range(order)] for _ in range(order)]
    matrix = tuple(tuple(map(sp.Integer, row)) for row in rows)
    expected = sympy.Matrix(rows)
    assert determinant(matrix) == expected.det()
    if expected.det() == 0:
        with pytest.raises(NoClosedForm, match="determinant is zero"):
            inverse(matrix)
    else:
        assert product(matrix, inverse(matrix)) == identity(order)
        assert inverse(transposed(matrix)) == transposed(inverse(matrix))


def test_a_matrix_times_its_inverse_is_the_unit_matrix_for_symbols():
    matrix = ((x, y, a), (w, x, q), (T, a, y))
    back = product(matrix, inverse(matrix))
    assert all(proved_equal(back[m][n], ONE if m == n else ZERO) for m in range(3) for n in range(3))


FUNCTIONS: dict[str, Callable[[Expr, Expr], Expr]] = {
    "polynomial": lambda u, v: u**3 * v - u * v**2,
    "wave": lambda u, v: u * sp.cos(v),
    "growth": lambda u, v: sp.exp(u - 2 * v) + v,
}


@pytest.mark.parametrize("function", FUNCTIONS.values(), ids=FUNCTIONS)
def test_an_expectation_is_what_quadrature_of_the_density_gives(function: Callable[[Expr, Expr], Expr]):
    closed = expectation(function(x, y), {x: sigma, y: a})
    plain = sympy.lambdify((x, y), function(x, y), "numpy")
    nodes, weights = np.polynomial.hermite_e.hermegauss(40)
    u, v = VALUES[x] + VALUES[sigma] * nodes[:, None], VALUES[y] + VALUES[a] * nodes[None, :]
    found = weights @ plain(u, v) @ weights / (2 * math.pi)
    assert abs(number(closed) - found) < 1e-11


def test_an_expectation_without_a_closed_form_is_refused():
    with pytest.raises(NoClosedForm, match="no closed form"):
        expectation(sp.sqrt(x), {x: sigma})


def test_derivatives_are_those_of_differences():
    f = x**2 * sp.sin(y) + sp.exp(x * y)
    step = mpmath.mpf("1e-9")
    plain = sympy.lambdify((x, y), f, "mpmath")
    with mpmath.workdps(40):
        u, v = mpmath.mpf(VALUES[x]), mpmath.mpf(VALUES[y])
        by_x = (plain(u + step, v) - plain(u - step, v)) / (2 * step)
        mixed = (
            plain(u + step, v + step)
            - plain(u + step, v - step)
            - plain(u - step, v + step)
            + plain(u - step, v - step)
        ) / (4 * step**2)
    assert abs(number(jacobian([f], [x, y])[0][0]) - by_x) < 1e-12
    assert abs(number(hessian(f, [x, y])[0][1]) - mixed) < 1e-12


def test_a_taylor_polynomial_leaves_an_error_of_the_next_order():
    f = sp.exp(x) * sp.cos(y - 2 * x)
    polynomial = taylor(f, [x, y], 4)
    errors = []
    for scale in (1e-2, 5e-3):
        point = {x: sympy.Float(0.7 * scale, 40), y: sympy.Float(-1.1 * scale, 40)}
        errors.append(abs(sympy.N((f - polynomial).xreplace(point), 40)))
    assert 28 < errors[0] / errors[1] < 36  # 2^5, up to the order after


@pytest.mark.parametrize(
    "f", [(1 - sp.exp(-x * y)) / x, sp.sin(x) / x, (x - sp.sin(x)) / x**3, (sp.exp(x * y) - 1 - x * y) / (x * y) ** 2]
)
def test_a_function_that_its_limit_completes_has_a_taylor_polynomial(f: Expr):
    errors = []
    polynomial = taylor(f, [x], 2)
    for scale in (1e-2, 5e-3):
        point = {x: sympy.Float(scale, 60), y: sympy.Float("0.8", 60)}
        errors.append(abs(sympy.N((f - polynomial).xreplace(point), 50)))
    assert 7.7 < errors[0] / errors[1] < 17  # 2^3 for the order after, and 2^4 where that has no term


@pytest.mark.parametrize("f", [1 / x, sp.sqrt(x), x * y / (x + y), sp.log(x)])
def test_a_function_without_a_taylor_polynomial_is_refused(f: Expr):
    with pytest.raises(NoClosedForm, match="no Taylor polynomial"):
        taylor(f, [x, y], 2)


@pytest.mark.parametrize("order", [8, 10, 12])
@pytest.mark.parametrize("verb", [determinant, inverse])
def test_a_full_matrix_that_is_too_large_is_refused_at_once(verb: Callable[[Matrix], object], order: int):
    for _ in range(2):  # SymPy compares what it kept of the first with the second, part by part
        matrix = tuple(tuple(sp.Symbol(f"a{i}_{j}", real=True) for j in range(order)) for i in range(order))
        with pytest.raises(NoClosedForm, match=f"order {order}"):
            verb(matrix)


@pytest.mark.parametrize("degrees", [1, 2, 3, 4, 7, 30])
@pytest.mark.parametrize("at", ["0.1", "3", "41.7"])
def test_chi_square_probabilities_are_integrals_of_the_density(degrees: int, at: str) -> None:
    half = mpmath.mpf(degrees) / 2
    expected = mpmath.quad(lambda t: 2 * t ** (degrees - 1) * mpmath.exp(-t * t / 2), [0, mpmath.sqrt(mpmath.mpf(at))])
    expected /= 2**half * mpmath.gamma(half)
    got = number(probability(sp.Rational(at), sp.Integer(degrees)))
    assert abs(got - expected) <= mpmath.mpf(10) ** -12 * max(expected, mpmath.mpf(10) ** -12)


@pytest.mark.parametrize("degrees", [1, 2, 3, 6, 100])
@pytest.mark.parametrize("below", ["1/1000", "1/2", "0.99", "0.999999"])
def test_chi_square_quantiles_are_exceeded_with_what_is_left_of_one(degrees: int, below: str) -> None:
    gate = quantile(sp.Rational(below), sp.Integer(degrees))
    assert abs(number(probability(gate, sp.Integer(degrees))) - number(sp.Rational(below))) <= mpmath.mpf(10) ** -14
