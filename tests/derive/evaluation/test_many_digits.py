"""The yardstick itself: many digits, exact floats, no loss where a textbook form cancels."""

from typing import Any

import mpmath
import pytest
import sympy
from hypothesis import given

from radartrack.derive import symbolic as sp
from radartrack.derive.evaluation.many_digits import Evaluator, evaluate
from radartrack.derive.language.tensor import Tensor
from tests.examples import share
from tests.expressions import NUMBERS, exponential_polynomials, number

x, y = sympy.symbols("x y", real=True)


@given(expression=exponential_polynomials(x, y), a=NUMBERS, b=NUMBERS)
@share(0.4)
def test_values_are_those_that_sympy_finds(expression: sympy.Expr, a: sympy.Rational, b: sympy.Rational):
    at = {x: float(a), y: float(b)}
    expected = number(expression, {symbol: sympy.Rational(value) for symbol, value in at.items()}, 60)
    assert abs(evaluate(expression, at) - expected) <= mpmath.mpf("1e-50") * (1 + abs(expected))


@pytest.mark.parametrize(
    ("expression", "expected"),
    [
        (sp.Abs(x), 0.1),
        (sp.acos(x), mpmath.acos),
        (sp.asin(x), mpmath.asin),
        (sp.atan(x), mpmath.atan),
        (sp.atan2(x, sp.Integer(-2)), lambda v: mpmath.atan2(v, -2)),
        (sp.hypot(x, sp.Integer(2)), lambda v: mpmath.sqrt(v * v + 4)),
        (sp.log(x), mpmath.log),
        (sp.tan(x), mpmath.tan),
        (sp.tanh(x), mpmath.tanh),
        (sp.sqrt(x), mpmath.sqrt),
        (x ** sympy.Rational(-3, 2), lambda v: 1 / (v * mpmath.sqrt(v))),
        (sp.pi * x, lambda v: mpmath.pi * v),
        (sp.E * x, lambda v: mpmath.e * v),
        (sp.ratio(x, x - x), 0),
    ],
    ids=lambda value: str(value) if isinstance(value, sympy.Expr) else "",
)
def test_every_function_is_the_one_of_mpmath(expression: sympy.Expr, expected: Any):
    with mpmath.workdps(100):
        value = expected(mpmath.mpf(0.1)) if callable(expected) else mpmath.mpf(expected)
        assert abs(evaluate(expression, {x: 0.1}) - value) < mpmath.mpf("1e-60")


def test_what_cancels_at_a_nanoradian_keeps_fifty_digits():
    textbook = sp.exp(-2 * x**2) * (sp.cosh(2 * x**2) - sp.cosh(x**2)) * y**2
    with mpmath.workdps(300):
        s = mpmath.mpf(1e-9) ** 2
        expected = mpmath.expm1(-s) * mpmath.expm1(-3 * s) / 2 * mpmath.mpf(1e8) ** 2
        assert abs(evaluate(textbook, {x: 1e-9, y: 1e8}) / expected - 1) < mpmath.mpf("1e-50")


def test_entries_keep_their_places_and_points_may_be_rows_or_mappings():
    evaluator = Evaluator(Tensor((2, 2), (x, y, x + y, x * y)), [x, y])
    for point in ([3.0, 5.0], {"x": 3.0, "y": 5.0}):
        values = evaluator(point)
        assert values.shape == (2, 2)
        assert list(values) == [3, 5, 8, 15]


def test_numbers_are_exact_rationals_not_floats():
    assert abs(evaluate(sympy.Rational(1, 3) + 0 * x, {x: 1.0}) * 3 - 1) < mpmath.mpf("1e-100")


@pytest.mark.parametrize("beside", [2, -3])
def test_the_angle_of_complex_numbers_has_the_tangent_of_their_quotient(beside: int):
    value = evaluate(sp.atan2(sp.sqrt(x) + 1, sp.Integer(beside)), {x: -0.25})
    assert abs(mpmath.tan(value) - mpmath.mpc(1, 0.5) / beside) < mpmath.mpf("1e-45")


@pytest.mark.parametrize("digits", [50, 60, 70, 80])
@pytest.mark.parametrize("noise", [-1, 0, 1])
def test_rounding_does_not_choose_the_branch_of_a_root(digits: int, noise: int) -> None:
    whole = sympy.Mul(*((x - n) ** sympy.Rational(1, 3) for n in (5, 6, 7)))  # negative, of complex factors
    evaluator = Evaluator(Tensor((1,), (sympy.sqrt(whole),)), [x], digits)
    for place in range(1, 20):
        (root,) = evaluator([place / 7], noise=noise)
        assert root.imag > 0


def test_noise_changes_what_owes_its_value_to_rounding_and_nothing_else() -> None:
    lost = (sympy.sqrt(1 + sympy.exp(-x)) - 1) * sympy.exp(x) * 2  # nearly 1, where the digits carried do not reach
    evaluator = Evaluator(Tensor((2,), (lost, sympy.sin(x) ** 2)), [x])
    for value, is_lost in ((3.0, False), (3000.0, True)):
        plain, noisy = evaluator([value]), evaluator([value], noise=1)
        assert (abs(plain[0,] - noisy[0,]) > 1e-50 * abs(noisy[0,])) == is_lost
        assert abs(plain[1,] - noisy[1,]) < 1e-120


@pytest.mark.parametrize("function", [sp.sin, sp.cos, sp.tan, sp.cot, sp.sec, sp.csc])
def test_an_angle_of_too_many_digits_is_refused_instead_of_turned_back_for_ever(function: Any) -> None:
    assert abs(evaluate(function(x**2), {x: 1e300})) > 0
    with pytest.raises(OverflowError, match="turned back"):
        evaluate(function(sp.exp(x)), {x: 4e5})


def test_an_angle_of_no_direction_has_a_value_in_generated_code_and_none_where_formulas_are_compared() -> None:
    entries: Tensor[sp.Expr] = Tensor((), (sp.atan2(y, x),))
    assert Evaluator(entries, [y, x])([0.0, 0.0]).entries == (0,)
    with pytest.raises(ZeroDivisionError):
        Evaluator(entries, [y, x], strict=True)([0.0, 0.0])
    assert Evaluator(entries, [y, x], strict=True)([0.0, -1.0]).entries[0] == pytest.approx(mpmath.pi)
