"""One expression as C: the same function as the expression, and a refusal of what is none."""

import math
from pathlib import Path

import mpmath
import pytest
import sympy
from hypothesis import given
from hypothesis import strategies as st

from radartrack.derive import symbolic as sp
from radartrack.derive.writing.c99 import c_elementary
from radartrack.derive.writing.c99.c_expression import CExpression, in_listing
from radartrack.derive.writing.expression_code import NotWritable
from tests.c_programs import needs_compiler, run
from tests.derive.writing.test_numpy_expression import POINT, expressions, x, y
from tests.examples import share
from tests.expressions import number

DOUBLE, SINGLE = CExpression(), CExpression("f")


def program(found: list[str], real: str) -> str:
    body = "".join(f'    printf("%.17g\\n", (double)({text}));\n' for text in found)
    given = f"    const {real} x = ({real})0.7, y = ({real})1.625;\n    (void)x; (void)y;\n"
    return f"#include <stdio.h>\n{c_elementary.header()}\nint main(void)\n{{\n{given}{body}    return 0;\n}}\n"


@needs_compiler
@given(found=st.lists(expressions, min_size=5, max_size=30))
@share(0.1)
def test_the_code_computes_what_the_expression_is(found: list[sympy.Expr], tmp_path_factory: pytest.TempPathFactory):
    for language, tolerance in ((DOUBLE, 1e-9), (SINGLE, 1e-2)):
        printed = run(program([language.code(one) for one in found], language.real), tmp_path_factory.mktemp("c"))
        for expression, line in zip(found, printed.split(), strict=True):
            value = mpmath.mpf(line)
            if not mpmath.isfinite(value):  # what was drawn, or a part of it, is more than the type holds
                continue
            expected = number(expression, POINT, 30)
            if language is SINGLE and not 1e-30 < abs(expected) < 1e30:
                continue
            condition = number(sympy.Add(*map(abs, sympy.Add.make_args(expression))), POINT, 30)
            if language is DOUBLE or condition < 1e3 * abs(expected):
                assert abs(value - expected) <= tolerance * (1 + abs(condition)), language.code(expression)


@pytest.mark.parametrize(
    ("expression", "text"),
    [
        (x**2 * 2, "2.0 * (x * x)"),
        (x**2, "x * x"),
        ((x + y) ** 2, "radartrack_square(x + y)"),
        (x / 3, "x / 3.0"),
        (x / 4, "0.25 * x"),
        (sp.pi * x, "3.14159265358979323846 * x"),
        (x - y**2, "x - (y * y)"),
        (sp.hypot(x, y), "radartrack_hypot(x, y)"),
        (sp.stumpff(x, sp.Integer(2)), "radartrack_stumpff(x, 2)"),
        (sympy.cbrt(x), "radartrack_pow(x, 1.0 / 3.0)"),
    ],
)
def test_the_code_is_this(expression: sympy.Expr, text: str):
    assert DOUBLE.code(expression) == text


def test_every_number_and_function_of_single_precision_says_so():
    assert SINGLE.code(2 * sp.sin(x) / 3 + sp.pi) == "2.0f * radartrack_sinf(x) / 3.0f + 3.14159265358979323846f"


def test_a_listing_calls_math_h_by_its_own_names():
    listing = CExpression(name_of=in_listing)
    assert listing.code(sp.expm1(x) + sp.third(y)) == "expm1(x) + radartrack_third(y)"


def test_unevaluated_integrals_and_inexact_numbers_are_refused():
    for wrong in (sympy.Integral(sympy.exp(x**2), x), sympy.Float(0.1) * x, sympy.gamma(x)):
        with pytest.raises(NotWritable):
            DOUBLE.code(wrong)


@needs_compiler
def test_the_helpers_are_continuous_where_they_change_their_way(tmp_path: Path):
    source = f"""#include <stdio.h>
{c_elementary.header()}
int main(void)
{{
    printf("%.17g %.17g %.17g %.17g ", radartrack_remainder(2.0, 2), radartrack_remainder(1.9999999999999998, 2),
           radartrack_stumpff(3.0, 3), radartrack_stumpff(2.9999999999999996, 3));
    printf("%.17g %.17g ", radartrack_third(1.0), radartrack_third(1.0000000000000002));
    printf("%g %g %g %g\\n", radartrack_ratio(3.0, 0.0), radartrack_ratio(3.0, -2.0), radartrack_below(1.0, 2.0),
           radartrack_ratio(1.0, 0.0 / 0.0));
    return 0;
}}
"""
    *pairs, at_zero, quotient, less, no_number = map(float, run(source, tmp_path).split())
    for first, second in zip(pairs[::2], pairs[1::2], strict=True):
        assert first == pytest.approx(second, rel=1e-13)
    assert pairs[0] == pytest.approx(float(mpmath.e**2 - 3), rel=1e-14)
    assert pairs[2] == pytest.approx(float((3 - mpmath.sin(3)) / 27), rel=1e-14)
    assert (at_zero, quotient, less) == (0.0, -1.5, 1.0)
    assert math.isnan(no_number)
