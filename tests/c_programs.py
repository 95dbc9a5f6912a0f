"""C programs that tests compile and run, where this machine has a compiler."""

import re
import shutil
import subprocess
from itertools import count
from pathlib import Path

import pytest

from radartrack.derive.catalogue import find
from radartrack.derive.stable.quantity_form import form_of
from radartrack.derive.writing.c99 import c_header
from radartrack.derive.writing.c99.c_function import of_quantity
from radartrack.derive.writing.c99.c_header import QuantityInC
from radartrack.derive.writing.numpy_writer import Function, body
from radartrack.verification.compiled_c import compiler

NAMES = ("gcc", "clang")
COMPILERS = [name for name in NAMES if shutil.which(name)]
WARNINGS = "-Wall -Wextra -pedantic -Wconversion -Wdouble-promotion -Wshadow -Werror".split()  # noqa: SIM905 - as typed
LANGUAGES = {"C99": ["-std=c99"], "C++17": ["-x", "c++", "-std=c++17"]}
NUMBERS = count()
needs_compiler = pytest.mark.skipif(compiler() is None, reason="there is no C compiler on this machine")
DEFINED = re.compile(
    r"^static inline (?P<kind>void|double|float) (?P<name>radartrack_\w+)\((?P<given>[^)]*)\)\n\{", re.MULTILINE
)
SPECIAL = "0.0 -0.0 1.0 -1.0 0.5 3.0 1e-300 1e300 -1e300 1e-40 1e38 5e-324 1e4 1e-3 NAN INFINITY -INFINITY".split()  # noqa: SIM905 - as typed


def run(source: str, folder: Path, *flags: str) -> str:
    """What a program prints."""
    path = folder / f"program_{next(NUMBERS)}.c"
    path.write_text(source)
    program = path.with_suffix("")
    command = compiler()
    assert command is not None
    built = subprocess.run(
        [*command, *([] if "-x" in flags else ["-std=c99"]), *flags, str(path), "-o", str(program), "-lm"],
        capture_output=True,
        text=True,
        check=False,
    )
    assert built.returncode == 0, built.stderr
    done = subprocess.run([str(program)], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return done.stdout


def in_c(name: str) -> QuantityInC:
    """A quantity of the catalogue."""
    quantity = find(name)
    form = form_of(quantity)
    return QuantityInC(quantity, Function(quantity, body(quantity, form)), of_quantity(quantity, form))


def write_headers(folder: Path, *names: str, conversions: tuple[tuple[str, str], ...] = ()) -> None:
    """Headers of some quantities, and of conversions whose parts are among them."""
    found = [in_c(name) for name in names]
    quantities = {one.quantity.name: one.quantity for one in found}
    joined = [c_header.conversion_in_c(quantities, *conversion) for conversion in conversions]
    for name, text in c_header.headers(found, joined, {name: ["Accuracy: any."] for name in quantities}).items():
        (folder / name).write_text(text)


def calls_with_anything(folder: Path, rounds: int = 200) -> str:
    """A program that calls every function of the headers in a folder with numbers of every kind, in all mixtures."""
    headers = sorted(folder.glob("radartrack_*.h"))
    functions = [match for header in headers for match in DEFINED.finditer(header.read_text())]
    calls = "".join(
        _call(match["name"], match["given"], match["kind"])
        for match in functions
        if "*" not in match["given"]  # batches, and what sine and cosine call
    )
    return f"""
#include <stdio.h>
#include "radartrack.h"
static const double special[] = {{{", ".join(SPECIAL)}}};
static unsigned state = 1u;
static double any(void)
{{
    state = state * 1664525u + 1013904223u;
    return special[(state >> 16) % (sizeof special / sizeof *special)];
}}
int main(void)
{{
    volatile double kept = 0.0;
    int round;
    for (round = 0; round < {rounds}; ++round) {{
{calls}    }}
    printf("{len(functions)}\\n");
    return kept < 0.0 && kept > 0.0;
}}
"""


def _call(name: str, given: str, kind: str) -> str:
    arrays: list[str] = []
    passed: list[str] = []
    for argument in given.replace("\n", " ").split(","):
        words = argument.split()
        if len(words) < 2:
            assert words == ["void"], argument
            continue
        real, named = words[-2], words[-1]
        if "[" in named:
            size = named.partition("[")[2].removesuffix("]")
            arrays.append(f"{real} out{len(arrays)}[{size}];")
            passed.append(f"out{len(arrays) - 1}")
        elif real == "int":
            passed.append("2")
        else:
            passed.append(f"({real})any()")
    called = f"{name}({', '.join(passed)})"
    last = f"{called}; kept = (double)out0[0];" if kind == "void" else f"kept = (double){called};"
    return f"        {{ {' '.join([*arrays])} {last} }}\n"
