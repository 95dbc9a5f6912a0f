"""The headers on Arm, where this machine has compilers for it and can run what they make."""

import shutil
import subprocess
from pathlib import Path

import pytest

from radartrack.derive.writing.c99.c_package import EXAMPLE
from tests.c_programs import (
    WARNINGS,
    built,
    calls_with_anything,
    every_function,
    needs_compiler,
    run,
    without_library,
    write_headers,
)

LINUX = {
    "arm-linux-gnueabihf-gcc": "qemu-arm",
    "aarch64-linux-gnu-gcc": "qemu-aarch64",
    "clang --target=arm-linux-gnueabihf": "qemu-arm",
    "clang --target=aarch64-linux-gnu": "qemu-aarch64",
}
CORTEX_M4 = ["-mcpu=cortex-m4", "-mthumb", "-mfpu=fpv4-sp-d16", "-mfloat-abi=hard"]
BARE = {"arm-none-eabi-gcc": CORTEX_M4, "aarch64-linux-gnu-gcc": []}
QUANTITIES = ("polar.unbiased.estimate", "polar.unbiased.covariance", "spherical.map", "observe.polar.map")
EMPTY = "#include <math.h>\n#include <stdio.h>\nint main(void) { return 0; }\n"
OF_MATH = "acos acosh asin atan atan2 cosh fabs hypot log pow sinh sqrt tan tanh".split()  # noqa: SIM905 - as typed
CONVERT = """
#include "radartrack.h"
void convert({real} r, {real} beta, {real} mean[2], {real} covariance[4]);
void convert({real} r, {real} beta, {real} mean[2], {real} covariance[4])
{{
    radartrack_convert_polar_unbiased{f}(r, beta, 20, ({real})1e-3, 0, mean, covariance);
}}
"""


@pytest.fixture(scope="module")
def headers(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("headers")
    write_headers(folder, *QUANTITIES, conversions=(("polar", "unbiased"),))
    return folder


@pytest.fixture(params=LINUX)
def arm(request: pytest.FixtureRequest, tmp_path: Path) -> tuple[list[str], tuple[str, ...]]:
    """A compiler for Arm, and what runs its programs here."""
    command, emulator = request.param.split(), LINUX[request.param]
    for name in (command[0], emulator):
        if not shutil.which(name):
            pytest.skip(f"there is no {name} on this machine")
    try:
        built(EMPTY, tmp_path, "-static", by=command)
    except AssertionError as error:
        pytest.skip(f"{request.param} has no library of C here: {error}")
    return command, (emulator,)


@needs_compiler
def test_the_example_prints_the_same_on_arm(headers: Path, arm: tuple[list[str], tuple[str, ...]], tmp_path: Path):
    command, emulator = arm
    printed = run(EXAMPLE, tmp_path, "-static", *WARNINGS, f"-I{headers}", by=command, emulator=emulator)
    assert printed == run(EXAMPLE, tmp_path, f"-I{headers}")


@needs_compiler
def test_what_needs_no_library_has_the_same_bits_on_arm(
    headers: Path, arm: tuple[list[str], tuple[str, ...]], tmp_path: Path
):
    command, emulator = arm
    source, same = calls_with_anything(headers), without_library(headers)
    here = run(source, tmp_path, "-O1", f"-I{headers}").splitlines()
    there = run(source, tmp_path, "-O1", "-static", f"-I{headers}", by=command, emulator=emulator).splitlines()
    compared = [(a, b) for a, b in zip(here, there, strict=True) if a.split()[0] in same]
    assert "radartrack_convert_polar_unbiased" in same
    assert "radartrack_observe_polar_map" not in same
    assert [a for a, _ in compared] == [b for _, b in compared]


@pytest.mark.parametrize("compiler", BARE)
def test_freestanding_headers_call_nothing_but_math_h(headers: Path, compiler: str, tmp_path: Path):
    found = undefined(compiler, every_function(headers), headers, tmp_path)
    assert found <= {f"{name}{suffix}" for name in OF_MATH for suffix in ("", "f")}


@pytest.mark.parametrize(("real", "f"), [("double", ""), ("float", "f")])
@pytest.mark.parametrize("compiler", BARE)
def test_a_freestanding_conversion_calls_no_library(headers: Path, compiler: str, real: str, f: str, tmp_path: Path):
    assert undefined(compiler, CONVERT.format(real=real, f=f), headers, tmp_path) == set()


def undefined(compiler: str, source: str, headers: Path, folder: Path) -> set[str]:
    """What a freestanding program calls that it does not bring, but what belongs to the compiler itself."""
    if not shutil.which(compiler):
        pytest.skip(f"there is no {compiler} on this machine")
    (folder / "code.c").write_text(source)
    flags = ["-std=c99", "-ffreestanding", "-O2", *BARE[compiler], *WARNINGS, f"-I{headers}"]
    subprocess.run([compiler, *flags, "-c", "code.c", "-o", "code.o"], cwd=folder, check=True)
    listed = subprocess.run(
        [compiler.replace("gcc", "nm"), "-u", "code.o"], cwd=folder, capture_output=True, text=True, check=True
    )
    return {name for name in listed.stdout.split() if name != "U" and not name.startswith("__aeabi_")}
