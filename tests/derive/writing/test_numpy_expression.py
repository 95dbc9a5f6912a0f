"""One expression as NumPy code: the same function, and a refusal of what is none."""

import itertools
import re
from collections.abc import Callable

import mpmath
import numpy as np
import pytest
import sympy
from hypothesis import example, given
from hypothesis import strategies as st

from radartrack.derive import symbolic as sp
from radartrack.derive.writing.numpy_expression import NotWritable, code, terms
from tests.examples import share
from tests.expressions import NONZERO, number
from tests.written import module_of

x, y = sympy.symbols("x y", positive=True)
POINT = {x: sympy.Rational(7, 10), y: sympy.Rational(13, 8)}
EXPONENTS = [-3, -2, -1, 2, 3, 4, 5, 7, *(sympy.Rational(n, 2) for n in (-5, -3, -1, 1, 3, 5))]
EXPONENTS += [sympy.Rational(n, 3) for n in (-4, -1, 1, 2)] + [sympy.Rational(3, 10)]
SMOOTH = [sp.Abs, sp.acos, sp.asin, sp.atan, sp.cos, sp.cosh, sp.exp, sp.expm1, sp.sin, sp.sinh, sp.tan, sp.tanh]


def composed(inner: st.SearchStrategy[sympy.Expr]) -> st.SearchStrategy[sympy.Expr]:
    """Sums, products, powers and functions, signs and numbers anywhere."""
    return st.one_of(
        st.lists(inner, min_size=2, max_size=3).map(lambda parts: sympy.Add(*parts)),
        st.lists(inner, min_size=2, max_size=3).map(lambda parts: sympy.Mul(*parts)),
        st.builds(sympy.Mul, NONZERO, inner),
        st.builds(lambda e, n: (e**2 + 1) ** n, inner, st.sampled_from(EXPONENTS)),
        st.builds(lambda f, e: f(e / (1 + e**2)), st.sampled_from(SMOOTH), inner),
        st.builds(lambda f, e, g: f(e, g**2 + 1), st.sampled_from([sp.atan2, sp.hypot]), inner, inner),
    )


expressions = st.recursive(st.sampled_from([x, y]) | NONZERO, composed, max_leaves=8).filter(
    lambda expression: not expression.has(sympy.I)  # code is about real numbers
)


@given(found=st.lists(expressions, min_size=1, max_size=5))
@share(0.6)
def test_the_code_computes_what_the_expression_is(found: list[sympy.Expr], tmp_path_factory: pytest.TempPathFactory):
    body = ", ".join(code(expression) for expression in found)
    source = f"import numpy as np\n\n\ndef run(x, y):\n    return [{body}]\n"
    with np.errstate(over="ignore"):
        values = module_of(source, tmp_path_factory.mktemp("code")).run(np.float64(0.7), np.float64(1.625))
    for expression, value in zip(found, values, strict=True):
        if np.isinf(value):  # what was drawn, or a part of it, is more than a double holds
            continue
        expected = number(expression, POINT, 30)
        condition = number(sympy.Add(*map(abs, sympy.Add.make_args(expression))), POINT, 30)
        assert abs(mpmath.mpf(float(value)) - expected) <= 1e-9 * (1 + abs(condition)), code(expression)


@given(st.permutations([x, y, x * y, sympy.sin(x), x**2 / 3, sympy.Integer(2), sympy.sqrt(y)]))
@share(0.4)
def test_the_code_does_not_depend_on_the_order_in_which_parts_were_given(parts: list[sympy.Expr]):
    assert code(sympy.Add(*parts)) == code(sum(reversed(parts)))
    assert code(sympy.Mul(*parts[:5])) == code(sympy.Mul(*reversed(parts[:5])))


def test_numbers_are_written_without_loss_and_no_power_but_the_square():
    assert code(sympy.Rational(3, 8) * x) == "0.375 * x"
    assert code(-x / 3) == "-x / 3.0"
    assert code(x**2) == "x**2"
    for exponent in (3, 4, 5, 6, -3, sympy.Rational(3, 2)):
        assert not re.search(r"\*\*[^2]", code(x**exponent))


@given(decimal=st.floats(1e-2, 1e2), power=st.integers(1, 4))
@example(decimal=1 / 3, power=4)
@share(0.4)
def test_the_parts_of_a_long_fraction_do_not_leave_single_precision(
    decimal: float, power: int, tmp_path_factory: pytest.TempPathFactory
):
    exact = sympy.Rational(repr(decimal)) ** power
    found = [code(exact * x**4 / y**4), code(-exact * y**4 / x**4), code(x**4 * y**-4 / exact)]
    source = f"import numpy as np\n\n\ndef run(x, y):\n    return [{', '.join(found)}]\n"
    values = module_of(source, tmp_path_factory.mktemp("code")).run(np.float32(1e4), np.float32(1.25e4))
    assert [value.dtype for value in values] == [np.float32] * 3
    ratio = 0.8**4
    expected = [float(exact) * ratio, -float(exact) / ratio, ratio / float(exact)]
    assert np.asarray(values, float) == pytest.approx(expected, rel=1e-5)


def test_the_terms_of_a_sum_are_its_code():
    expression = x - y**2 - 3 + sympy.sin(x)
    assert " ".join(terms(expression)) == code(expression)


@pytest.mark.parametrize(
    "expression",
    [
        sympy.Integral(sympy.exp(-(x**2)), (x, 0, y)),
        sympy.Derivative(sympy.Function("f")(x), x),
        sympy.Sum(x**y, (y, 0, 3)),
        sympy.Product(x**y, (y, 0, 3)),
        sympy.Piecewise((x, x > 1), (y, x < 2)),
        sympy.Limit(x, x, 0),
        sympy.Function("f")(x),
        sympy.Float("0.1"),
        sympy.Float("0.1") * x,
        sympy.I,
        sympy.I * x,
        sympy.oo,
        sympy.zoo,
        sympy.nan,
        sympy.EulerGamma,
        x**y,
        sympy.gamma(x),
        sympy.factorial(x),
        sympy.Heaviside(x - 1),
    ],
    ids=str,
)
def test_what_numpy_has_no_words_for_is_refused_wherever_it_stands(expression: sympy.Expr):
    contexts: tuple[Callable[[sympy.Expr], sympy.Expr], ...] = (
        lambda e: e,
        lambda e: e + x,
        lambda e: 2 * e,
        lambda e: sympy.sin(e, evaluate=False),
        lambda e: y / e,
    )
    for context in itertools.islice(contexts, 1 if expression in (sympy.oo, sympy.zoo, sympy.nan) else None):
        with pytest.raises(NotWritable):
            code(context(expression))
