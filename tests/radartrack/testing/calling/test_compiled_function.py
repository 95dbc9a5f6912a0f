"""Functions compiled from C are called as they are declared: results returned, or put where pointers point."""

import ctypes
import subprocess
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from radartrack.testing import CannotDiagnose, assert_derived, diagnose
from radartrack.verification.compiled_c import compiler
from tests.c_programs import needs_compiler

DOUBLE, FLOAT = ctypes.c_double, ctypes.c_float
POINTER = ctypes.POINTER(DOUBLE)
DECLARED = {
    "into_array": "void into_array(double r, double b, double *out);",
    "into_numbers": "void into_numbers(double r, double b, double *x, double *y);",
    "of_array": "int of_array(const double *plot, double *out);",
    "of_array_into_numbers": "void of_array_into_numbers(const double *plot, double *x, double *y);",
    "single": "void single(float r, float b, float *out);",
    "covariance": "void covariance(double r, double b, double sr, double sb, double c[2][2]);",
    "both": "void both(double r, double b, double sr, double sb, double *mean, double c[2][2]);",
    "whole_number_power": "void whole_number_power(const double *state, double *row);",
    "range": "double range(const double *position);",
}
SOURCE = """
#include <math.h>
void into_array(double r, double b, double *out) { out[0] = r * cos(b); out[1] = r * sin(b); }
void into_numbers(double r, double b, double *x, double *y) { *x = r * cos(b); *y = r * sin(b); }
int of_array(const double *plot, double *out) { into_array(plot[0], plot[1], out); return 0; }
void of_array_into_numbers(const double *plot, double *x, double *y) { into_numbers(plot[0], plot[1], x, y); }
void single(float r, float b, float *out) { out[0] = r * cosf(b); out[1] = r * sinf(b); }
void covariance(double r, double b, double sr, double sb, double c[2][2])
{
    double along = sr * sr, across = r * r * sb * sb;
    c[0][0] = along * cos(b) * cos(b) + across * sin(b) * sin(b);
    c[1][1] = along * sin(b) * sin(b) + across * cos(b) * cos(b);
    c[0][1] = c[1][0] = (along - across) * sin(b) * cos(b);
}
void both(double r, double b, double sr, double sb, double *mean, double c[2][2])
{
    into_array(r, b, mean);
    covariance(r, b, sr, sb, c);
}
void whole_number_power(const double *state, double *row)
{
    double x = state[0], y = state[1], squared = x * x + y * y;
    double turning = y * (state[2] * y - state[3] * x) / pow(squared, 3 / 2);
    row[0] = x / sqrt(squared); row[1] = y / sqrt(squared); row[2] = row[3] = 0;
    row[4] = -y / squared; row[5] = x / squared; row[6] = row[7] = 0;
    row[8] = turning; row[9] = -turning * x / y; row[10] = row[0]; row[11] = row[1];
}
double range(const double *position) { return hypot(position[0], position[1]); }
"""
PLOT, ERRORS = (DOUBLE, DOUBLE), (DOUBLE,) * 4
TYPES: dict[str, tuple[Any, ...]] = {
    "into_array": (*PLOT, POINTER), "into_numbers": (*PLOT, POINTER, POINTER), "of_array": (POINTER, POINTER),
    "of_array_into_numbers": (POINTER,) * 3, "single": (FLOAT, FLOAT, ctypes.POINTER(FLOAT)),
    "covariance": (*ERRORS, ctypes.POINTER(DOUBLE * 2)), "both": (*ERRORS, POINTER, ctypes.POINTER(DOUBLE * 2)),
    "whole_number_power": (POINTER, POINTER), "range": (POINTER,),
}  # fmt: skip
RETURNED = {"of_array": ctypes.c_int, "range": DOUBLE}
QUANTITIES = {
    "into_array": "polar.map", "into_numbers": "polar.map", "of_array": "polar.map",
    "of_array_into_numbers": "polar.map", "single": "polar.map", "covariance": "polar.covariance.linear",
    "both": "polar.covariance.linear", "range": "observe.polar.map[0]",
}  # fmt: skip

pytestmark = needs_compiler


@pytest.fixture(scope="module")
def library(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("library")
    (folder / "own.c").write_text(SOURCE)
    command, path = compiler(), folder / "own.so"
    assert command is not None
    flags = ["-std=c99", "-shared", "-fPIC"]
    subprocess.run([*command, *flags, str(folder / "own.c"), "-o", str(path), "-lm"], check=True)
    return path


@pytest.fixture(scope="module", params=["ctypes", "cffi"])
def function_of(request: pytest.FixtureRequest, library: Path) -> Callable[[str], Any]:
    """A function of the library, as one of both packages declares it."""
    if request.param == "cffi":
        ffi = pytest.importorskip("cffi").FFI()
        ffi.cdef("\n".join(DECLARED.values()))
        opened = ffi.dlopen(str(library))
        return lambda name: getattr(opened, name)

    def of_ctypes(name: str) -> Any:
        found = getattr(ctypes.CDLL(str(library)), name)
        found.argtypes, found.restype = TYPES[name], RETURNED.get(name)
        return found

    return of_ctypes


@pytest.mark.parametrize(("name", "quantity"), QUANTITIES.items())
def test_right_functions_of_c_agree_whatever_they_take_and_wherever_they_put_it(
    function_of: Callable[[str], Any], name: str, quantity: str
) -> None:
    assert_derived(function_of(name), quantity)


def test_a_slip_of_c_is_named(function_of: Callable[[str], Any]) -> None:
    found = diagnose(function_of("whole_number_power"), "observe.polar_doppler.jacobian")
    assert "entries [2, 0] and [2, 1]: the power 3/2 is 1" in found.slip


@pytest.mark.parametrize(
    "kind",
    [DOUBLE * 4, np.ctypeslib.ndpointer(np.float64), np.ctypeslib.ndpointer(np.float64, ndim=2, shape=(2, 2))],
    ids=str,
)
def test_arrays_and_numpy_pointers_are_filled(library: Path, kind: Any) -> None:
    function = ctypes.CDLL(str(library)).covariance
    function.argtypes, function.restype = (*ERRORS, kind), None
    assert_derived(function, "polar.covariance.linear")


@pytest.mark.parametrize(
    ("types", "returned", "words"),
    [(None, DOUBLE, "argtypes"), ((DOUBLE, DOUBLE), ctypes.c_int, "restype")],
)
def test_what_ctypes_is_not_told_is_asked_for(library: Path, types: Any, returned: Any, words: str) -> None:
    function = ctypes.CDLL(str(library)).into_array
    function.argtypes, function.restype = types, returned
    with pytest.raises(CannotDiagnose, match=words):
        diagnose(function, "polar.map[0]")
