"""The headers on Arm, where this machine has compilers for it and can run what they make."""

import shutil
import subprocess
from pathlib import Path

import pytest

from radartrack.derive.writing.c99.c_package import EXAMPLE
from tests.c_programs import WARNINGS, needs_compiler, run, write_headers

LINUX = {"arm-linux-gnueabihf-gcc": "qemu-arm", "aarch64-linux-gnu-gcc": "qemu-aarch64"}
BARE = "arm-none-eabi-gcc"
CORTEX_M4 = ["-mcpu=cortex-m4", "-mthumb", "-mfpu=fpv4-sp-d16", "-mfloat-abi=hard"]
SINGLY = """
#include "radartrack.h"
void convert(float r, float beta, float mean[2], float covariance[4]);
void convert(float r, float beta, float mean[2], float covariance[4])
{
    radartrack_convert_polar_unbiasedf(r, beta, 20.0f, 1e-3f, 0.0f, mean, covariance);
}
"""


@pytest.fixture(scope="module")
def headers(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("headers")
    names = ("polar.unbiased.estimate", "polar.unbiased.covariance")
    write_headers(folder, *names, conversions=(("polar", "unbiased"),))
    return folder


@needs_compiler
@pytest.mark.parametrize("compiler", LINUX)
def test_the_example_prints_the_same_on_arm(headers: Path, compiler: str, tmp_path: Path):
    if not (shutil.which(compiler) and shutil.which(LINUX[compiler])):
        pytest.skip(f"there is no {compiler} or no {LINUX[compiler]} on this machine")
    source, program = tmp_path / "example.c", tmp_path / "example"
    source.write_text(EXAMPLE)
    command = [compiler, "-std=c99", "-static", *WARNINGS, f"-I{headers}", str(source), "-o", str(program), "-lm"]
    subprocess.run(command, check=True)
    done = subprocess.run([LINUX[compiler], str(program)], capture_output=True, text=True, check=True)
    assert done.stdout == run(EXAMPLE, tmp_path, f"-I{headers}")


@pytest.mark.skipif(not shutil.which(BARE), reason=f"there is no {BARE} on this machine")
def test_freestanding_code_calls_no_library_but_the_compiler_s_own(headers: Path, tmp_path: Path):
    source, code = tmp_path / "convert.c", tmp_path / "convert.o"
    source.write_text(SINGLY)
    command = [BARE, "-std=c99", "-ffreestanding", "-O2", *CORTEX_M4, *WARNINGS, f"-I{headers}", "-c", str(source)]
    subprocess.run([*command, "-o", str(code)], check=True)
    listed = subprocess.run([BARE.replace("gcc", "nm"), "-u", str(code)], capture_output=True, text=True, check=True)
    assert [name for name in listed.stdout.split() if name != "U" and not name.startswith("__aeabi_")] == []
