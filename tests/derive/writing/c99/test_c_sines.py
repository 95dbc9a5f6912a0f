"""Sine, cosine and exponentials in C: the bits of the generated Python, far angles, and no library."""

import ctypes
import subprocess
from pathlib import Path

import numpy as np
import pytest

from radartrack._arrays import machine_code
from radartrack.derive.catalogue import catalogue
from radartrack.derive.writing.c99 import c_elementary, c_header
from radartrack.verification.compiled_c import FLAGS, compiler
from radartrack.verification.domain_points import sample
from radartrack.verification.elementary.elementary_campaign import TYPES, drawn, in_ulp, over_arrays
from radartrack.verification.elementary.elementary_checker import FUNCTIONS
from tests.c_programs import needs_compiler

pytestmark = needs_compiler
EACH = pytest.mark.parametrize(("name", "precision"), [(name, kind) for kind in TYPES for name in FUNCTIONS])
SUFFIX = {"double": "", "single": "f"}
ENTRANCE = """
void run_{name}{f}(size_t n, const {real} *x, {real} *result);
void run_{name}{f}(size_t n, const {real} *x, {real} *result)
{{
    size_t i;
    for (i = 0; i < n; ++i)
        result[i] = radartrack_{name}{f}(x[i]);
}}
"""


@pytest.fixture(scope="module")
def library(tmp_path_factory: pytest.TempPathFactory) -> ctypes.CDLL:
    """All functions over arrays; linked with no library."""
    folder = tmp_path_factory.mktemp("sines")
    entrances = [
        ENTRANCE.format(name=name, f=f, real="float" if f else "double") for name in FUNCTIONS for f in ("", "f")
    ]
    (folder / "sines.c").write_text(c_elementary.header() + "".join(entrances))
    command = [*(compiler() or ["cc"]), *FLAGS, "-Wl,--no-undefined", "-nostdlib", "sines.c", "-o", "sines.so"]
    subprocess.run(command, cwd=folder, check=True)
    return ctypes.CDLL(str(folder / "sines.so"))


def called(library: ctypes.CDLL, name: str, precision: str, arguments: np.ndarray) -> np.ndarray:
    results = np.empty_like(arguments)
    pointers = [array.ctypes.data_as(ctypes.c_void_p) for array in (arguments, results)]
    getattr(library, f"run_{name}{SUFFIX[precision]}")(ctypes.c_size_t(len(arguments)), *pointers)
    return results


@EACH
def test_they_have_the_bits_of_the_generated_python(library: ctypes.CDLL, name: str, precision: str):
    pytest.importorskip("flint")
    arguments = drawn(name, precision, 5000, np.random.default_rng(5))
    expected = over_arrays(name + ("" if precision == "double" else "_single"))(arguments)
    np.testing.assert_array_equal(called(library, name, precision, arguments), expected)


@pytest.mark.parametrize("precision", TYPES)
@pytest.mark.parametrize("name", ["sin", "cos"])
def test_far_angles_are_within_an_ulp_to_the_largest_number(library: ctypes.CDLL, name: str, precision: str):
    pytest.importorskip("flint")
    generator, kind = np.random.default_rng(6), TYPES[precision]
    sizes = 10.0 ** generator.uniform(2, np.log10(float(np.finfo(kind).max)), 1500)
    near_right_angles = np.pi / 2 * np.rint(10.0 ** generator.uniform(4.5, 9, 500))
    worst = [6381956970095103.0 * 2.0**797, np.finfo(kind).max]  # the double that is nearest to a right angle
    with np.errstate(over="ignore"):
        arguments = np.concatenate([sizes, -sizes, near_right_angles, worst]).astype(kind)
    arguments = arguments[np.isfinite(arguments)]
    assert in_ulp(name, arguments, called(library, name, precision, arguments)).max() <= 1.0


@EACH
def test_what_has_no_value_is_nan(library: ctypes.CDLL, name: str, precision: str):
    arguments = np.array([np.nan, np.inf, -np.inf], TYPES[precision])
    found = called(library, name, precision, arguments)
    ends = {"exp": [np.inf, 0.0], "expm1": [np.inf, -1.0]}.get(name, [np.nan, np.nan])
    np.testing.assert_array_equal(found, [np.nan, *ends])


@pytest.mark.parametrize("model", ["polar", "spherical"])
def test_a_conversion_has_the_bits_of_machine_code(model: str, tmp_path: Path):
    if not machine_code.is_available():
        pytest.skip("Numba is not installed")
    written = c_header.conversion_in_c(catalogue(), model, "unbiased").written
    names, size = written.arguments, written.outputs[0].size
    taken = "".join(f"const double *{name}, " for name in names)
    entrance = f"void run(size_t n, {taken}double *mean, double *covariance)"
    called = f"{written.name}_n(n, {', '.join(names)}, mean, covariance);"
    (tmp_path / "code.c").write_text(f"{c_elementary.header()}\n{written.text('')}\n{entrance} {{ {called} }}\n")
    subprocess.run([*(compiler() or ["cc"]), *FLAGS, "code.c", "-o", "code.so", "-lm"], cwd=tmp_path, check=True)
    points = sample(catalogue()[f"{model}.unbiased.covariance"], 2000, seed=4, correlated=True)
    columns = [np.ascontiguousarray(points[name]) for name in names]
    (mean, covariance), (others, more) = ((np.empty((2000, size)), np.empty((2000, size, size))) for _ in range(2))
    pointers = [array.ctypes.data_as(ctypes.c_void_p) for array in (*columns, mean, covariance)]
    ctypes.CDLL(str(tmp_path / "code.so")).run(ctypes.c_size_t(2000), *pointers)
    compiled = machine_code.conversion(f"{model}_unbiased", size)
    assert compiled is not None
    compiled(*columns, others, more)
    np.testing.assert_array_equal(mean, others)
    np.testing.assert_array_equal(covariance, more)
