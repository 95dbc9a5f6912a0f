"""Functions in C: names that C can have, comments that end where they should, batches."""

from collections.abc import Callable
from pathlib import Path

import pytest
import sympy

from radartrack.derive import symbolic as sp
from radartrack.derive.writing.c99 import c_elementary
from radartrack.derive.writing.c99.c_function import CFunction, Output, function, in_comment
from radartrack.derive.writing.computed_statements import Statements
from tests.c_programs import LANGUAGES, WARNINGS, needs_compiler, run

new, count, other, name = (sympy.Symbol(text, real=True) for text in ("new", "n", "n_", "radartrack_sin"))


def awkward() -> CFunction:
    """A function whose symbols are words of C++, its own names, and one that is not used."""
    statements = Statements(
        (("double", new + count), ("radartrack_exp", sp.sin(sympy.Symbol("double", real=True)))),
        (sympy.Symbol("radartrack_exp", real=True) + other + name, new),
    )
    return function(
        "radartrack_a_b", ["new", "n", "n_", "radartrack_sin", "unused"], [Output("result", (2,))], statements
    )


def test_no_argument_is_a_word_of_c_or_a_name_of_ours_and_all_differ():
    found = awkward().arguments
    assert found == ("new_", "n__", "n_", "of_radartrack_sin", "unused")


@needs_compiler
@pytest.mark.parametrize("language", LANGUAGES)
def test_awkward_names_compile_and_compute(language: str, tmp_path: Path):
    written = awkward()
    source = f"""#include <stdio.h>
{c_elementary.header()}
{written.text("any")}
int main(void)
{{
    const double a[2] = {{1.0, 2.0}}, b[2] = {{0.5, 0.25}}, c[2] = {{3.0, 4.0}}, d[2] = {{5.0, 6.0}};
    const double e[2] = {{0.0, 0.0}};
    double one[2], many[4];
    float single[2];
    radartrack_a_b(1.0, 0.5, 3.0, 5.0, 0.0, one);
    radartrack_a_bf(1.0f, 0.5f, 3.0f, 5.0f, 0.0f, single);
    radartrack_a_b_n(2, a, b, c, d, e, many);
    printf("%.17g %.17g %.17g %.17g %.17g %.17g %.9g\\n", one[0], one[1], many[0], many[1], many[2], many[3],
           (double)single[0]);
    return 0;
}}
"""
    first, second, *many, single = map(float, run(source, tmp_path, *LANGUAGES[language], *WARNINGS).split())
    assert (first, second) == pytest.approx((float(sympy.sin(1.5)) + 8, 1.0))
    assert many == pytest.approx([first, second, float(sympy.sin(2.25)) + 10, 2.0])
    assert single == pytest.approx(first, rel=1e-6)


@needs_compiler
@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("wave", [sp.sin, sp.cos])
def test_one_of_sine_and_cosine_alone_compiles_without_a_warning(
    language: str, wave: Callable[[sp.Expr], sp.Expr], tmp_path: Path
):
    x = sympy.Symbol("x", real=True)
    vector = function("radartrack_v", ["x"], [Output("result", (1,))], Statements((), (wave(x),)))
    number = function("radartrack_s", ["x"], [], Statements((), (wave(x),)))
    source = f"#include <stdio.h>\n{c_elementary.header()}\n{vector.text('any')}\n{number.text('any')}"
    calls = 'double v[1]; radartrack_v(1.5, v); printf("%d", v[0] == radartrack_s(1.5)); return 0;'
    assert run(f"{source}\nint main(void) {{ {calls} }}\n", tmp_path, *LANGUAGES[language], *WARNINGS) == "1"


@needs_compiler
@pytest.mark.parametrize("standard", ["-std=c99", "-std=gnu11", "-std=gnu++17"])
def test_symbols_may_be_called_like_sines_of_others_and_like_what_math_h_defines(standard: str, tmp_path: Path):
    defined = ["M_PI", "M_E", "M_SQRT1_2", "FP_NAN", "MATH_ERRNO", "HUGE_VAL", "MAXFLOAT", "NAN", "I", "SNAN"]
    given = ["x", "sine_of_x", "sine_of_sine_of_x", "cosine_of_x_", *defined]
    symbols = [sympy.Symbol(text, real=True) for text in given]
    x, other, *others = symbols
    inner = sympy.Symbol("sine_of_x_", real=True)
    statements = Statements(((inner.name, sp.sin(x)),), (inner + sp.cos(x) + sp.sin(other) + sp.Add(*others),))
    written = function("radartrack_a", given, [], statements)
    assert len({*written.arguments, *(name for _, *names in written.angles for name in names)}) == len(given) + 4
    language = ["-x", "c++", standard] if "++" in standard else [standard]
    calls = f'printf("%.17g", radartrack_a({", ".join(["0.5"] * len(given))}));'
    source = (
        f"#include <stdio.h>\n{c_elementary.header()}\n{written.text('any')}\nint main(void) {{ {calls} return 0; }}\n"
    )
    expected = float(sympy.cos(0.5) + 2 * sympy.sin(0.5)) + 0.5 * len(others)
    assert float(run(source, tmp_path, *language, *WARNINGS, "-Wno-pedantic")) == pytest.approx(expected)


@needs_compiler
def test_no_text_of_a_comment_gets_out_of_it(tmp_path: Path):
    evil = 'a */ int main(void) { return 1; } /* "b" ??/\n\\\nπ'
    assert in_comment(evil).count("*/") == 1
    assert run(f"{in_comment(evil)}\nint main(void) {{ return 0; }}\n", tmp_path, *WARNINGS) == ""


def test_what_is_computed_once_is_copied_and_what_is_one_number_is_returned():
    x = sympy.Symbol("x", real=True)
    twice = function("radartrack_t", ["x"], [Output("result", (2,))], Statements((), (sp.sin(x) + 1, sp.sin(x) + 1)))
    assert "result[1] = result[0];" in twice.bodies[0]
    one = function("radartrack_one", ["x"], [], Statements((), (x / 2,)))
    assert "static inline double radartrack_one(double x)\n{\n    return 0.5 * x;\n}" in one.text("")
    assert "result[i] = radartrack_onef(x[i]);" in one.text("")
    assert twice.digest != one.digest
