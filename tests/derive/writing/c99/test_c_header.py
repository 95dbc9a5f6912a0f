"""Headers: every function in two precisions, without a warning in C and C++, and safe with anything."""

from pathlib import Path

import pytest

from radartrack.derive.writing.c99 import c_header
from radartrack.derive.writing.expression_code import NotWritable
from tests.c_programs import (
    COMPILERS,
    DEFINED,
    LANGUAGES,
    NAMES,
    WARNINGS,
    built,
    calls_with_anything,
    every_function,
    in_c,
    needs_compiler,
    run,
    without_library,
    write_headers,
)

QUANTITIES = (
    "polar.map",
    "polar.unbiased.estimate",
    "polar.unbiased.covariance",
    "polar.bias.averaged",
    "polar.covariance.averaged",
    "polar.std.position",
    "spherical.unbiased.estimate",
    "observe.polar.hessian",
    "observe.bistatic.jacobian",
    "motion.turn.unknown_rate.map",
    "motion.plane.observation",
    "steady_state.alpha_beta_gamma.gain",
    "finite_sample.degree2.range_rate.covariance",
    "line.slope",
)
EACH_COMPILER = pytest.mark.parametrize(
    "compiler",
    [
        pytest.param(
            name, marks=pytest.mark.skipif(name not in COMPILERS, reason=f"there is no {name} on this machine")
        )
        for name in NAMES
    ],
)


@pytest.fixture(scope="module")
def headers(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("headers")
    write_headers(folder, *QUANTITIES, conversions=(("polar", "unbiased"), ("polar", "averaged")))
    return folder


def test_each_quantity_has_its_functions_in_both_precisions(headers: Path):
    defined = {match["name"] for path in headers.glob("*.h") for match in DEFINED.finditer(path.read_text())}
    for name in QUANTITIES:
        function = f"radartrack_{name.replace('.', '_')}"
        batches = set() if name == "motion.plane.observation" else {f"{function}_n", f"{function}_nf"}
        assert {function, f"{function}f", *batches} <= defined


def test_the_comment_says_what_the_docstring_says(headers: Path):
    text = (headers / "radartrack_polar.h").read_text()
    assert " * Name: polar.covariance.averaged.\n" in text
    assert " *     result[4], 2 x 2 in row-major order, unit m^2.\n" in text
    assert " *     sigma_beta: standard deviation of the error of beta [rad]" in text


@pytest.mark.parametrize("language", LANGUAGES)
@EACH_COMPILER
def test_headers_compile_without_a_warning(headers: Path, compiler: str, language: str, tmp_path: Path):
    built(every_function(headers), tmp_path, "-O2", *LANGUAGES[language], *WARNINGS, f"-I{headers}", by=[compiler])


@EACH_COMPILER
def test_sanitizers_find_nothing_with_numbers_of_every_kind(headers: Path, compiler: str, tmp_path: Path):
    flags = ["-O1", "-fsanitize=address,undefined", "-fno-sanitize-recover=all", f"-I{headers}"]
    try:
        run("int main(void) { return 0; }\n", tmp_path, *flags, by=[compiler])
    except AssertionError:
        pytest.skip(f"{compiler} has no sanitizers here")
    assert len(run(calls_with_anything(headers), tmp_path, *flags, by=[compiler]).splitlines()) > 2 * len(QUANTITIES)


@needs_compiler
@EACH_COMPILER
@pytest.mark.parametrize("level", ["-O0", "-O3"])
def test_what_needs_no_library_has_the_same_bits_under_every_compiler(
    headers: Path, compiler: str, level: str, tmp_path: Path
):
    source, same = calls_with_anything(headers), without_library(headers)
    found = run(source, tmp_path, f"-I{headers}", "-O1"), run(source, tmp_path, f"-I{headers}", level, by=[compiler])
    first, other = ([line for line in lines.splitlines() if line.split()[0] in same] for lines in found)
    assert len(first) > len(QUANTITIES)
    assert first == other


@needs_compiler
def test_own_elementary_functions_take_the_place_of_those_of_math_h(headers: Path, tmp_path: Path):
    inside = (
        (headers / "radartrack_elementary.h").read_text().partition("#include <math.h>\n")[2].partition("#endif")[0]
    )
    own = "#include <math.h>\n" + inside.replace("return hypot(x, y);", "return 7.0;")
    (tmp_path / "own.h").write_text(own)
    source = """#include <stdio.h>
#define RADARTRACK_ELEMENTARY "own.h"
#include "radartrack_polar.h"
int main(void)
{
    printf("%g %g\\n", radartrack_hypot(3.0, 4.0), radartrack_cos(0.0));
    return 0;
}
"""
    assert run(source, tmp_path, f"-I{headers}", f"-I{tmp_path}") == "7 1\n"


def test_two_functions_of_one_name_are_refused():
    with pytest.raises(NotWritable, match="radartrack_polar_map"):
        c_header.headers([in_c("polar.map"), in_c("polar.map")], [], {"polar.map": ["any"]})
