"""C programs that tests compile and run, where this machine has a compiler."""

import re
import shutil
import subprocess
from collections.abc import Iterator
from itertools import count
from pathlib import Path

import pytest

from radartrack.derive.catalogue import find
from radartrack.derive.stable.quantity_form import form_of
from radartrack.derive.writing.c99 import c_elementary, c_header
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
    r"^(?:static inline|RADARTRACK_INLINE|RADARTRACK_BATCH) (?P<kind>void|double|float) (?P<name>radartrack_\w+)"
    r"\((?P<given>[^)]*)\)\n\{",
    re.MULTILINE,
)
WRAPPER = re.compile(r"^static inline \w+ (radartrack_\w+)\(.*\) \{ return \w+\(.*\); \}$", re.MULTILINE)
OURS = re.compile(r"\bradartrack_\w+")
EXACT = {f"radartrack_{name}{suffix}" for name in ("sqrt", "fabs") for suffix in ("", "f")}
SPECIAL = "0.0 -0.0 1.0 -1.0 0.5 3.0 1e-300 1e300 -1e300 1e-40 1e38 5e-324 1e4 1e-3 NAN INFINITY -INFINITY".split()  # noqa: SIM905 - as typed


def run(source: str, folder: Path, *flags: str, by: list[str] | None = None, emulator: tuple[str, ...] = ()) -> str:
    """What a program prints that a compiler, else that of this machine, makes, and a processor or its emulator runs."""
    program = built(source, folder, *flags, by=by)
    done = subprocess.run([*emulator, str(program)], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return done.stdout


def built(source: str, folder: Path, *flags: str, by: list[str] | None = None) -> Path:
    """The program that a compiler makes."""
    path = folder / f"program_{next(NUMBERS)}.c"
    path.write_text(source)
    command = by or compiler()
    assert command is not None
    done = subprocess.run(
        [*command, *([] if "-x" in flags else ["-std=c99"]), *flags, str(path), "-o", str(path.with_suffix("")), "-lm"],
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    return path.with_suffix("")


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


def every_function(folder: Path) -> str:
    """A program of all functions of the headers in a folder, whether anybody calls them or not."""
    names = [match["name"] for match in _defined(folder)]
    listed = "".join(f"    (function){name},\n" for name in names)
    return f"""
#include "radartrack.h"
#include "radartrack.h"
typedef void (*function)(void);
extern const function all[];
const function all[] = {{
{listed}}};
int main(void) {{ return 0; }}
"""


def without_library(folder: Path) -> set[str]:
    """The functions of the headers in a folder that call no function of math.h, but what IEEE 754 rounds exactly."""
    calling = set(WRAPPER.findall((folder / c_elementary.NAME).read_text())) - EXACT
    texts = {match["name"]: text for path in sorted(folder.glob("radartrack_*.h")) for match, text in _bodies(path)}
    while more := {name for name, text in texts.items() if calling & set(OURS.findall(text))} - calling:
        calling |= more
    return texts.keys() - calling


def calls_with_anything(folder: Path, rounds: int = 200) -> str:
    """A program that calls every function of the headers in a folder with numbers of every kind, in all mixtures.

    It prints a digest of what each returns, in which all that is no number counts as one.
    """
    functions = [match for match in _defined(folder) if "*" not in match["given"]]  # batches, and sines' own
    calls = "".join(_call(place, match["name"], match["given"], match["kind"]) for place, match in enumerate(functions))
    names = ", ".join(f'"{match["name"]}"' for match in functions)
    return f"""
#include <stdio.h>
#include <stdint.h>
#include "radartrack.h"
static const double special[] = {{{", ".join(SPECIAL)}}}, tens[] = {{1e-4, 1e-3, 1e-2, 1e-1, 1.0, 1e1, 1e3, 1e5}};
static const char *names[] = {{{names}}};
static uint64_t digests[{len(functions)}];
static uint32_t state = 1u;
static uint32_t drawn(void)
{{
    state = state * 1664525u + 1013904223u;
    return state >> 8;
}}
static double any(int is_special)
{{
    const uint32_t kind = drawn();
    if (is_special)
        return special[kind % (sizeof special / sizeof *special)];
    return (double)drawn() / 16777216.0 * tens[kind % 8u];
}}
static void keep(int place, double value)
{{
    union {{
        double value;
        uint64_t bits;
    }} number;
    number.value = value;
    digests[place] = (digests[place] ^ (value != value ? 1u : number.bits)) * 1099511628211u;
    digests[place] ^= digests[place] >> 29;
}}
int main(void)
{{
    int round, i;
    for (round = 0; round < {rounds}; ++round) {{
        const int s = round % 2;
{calls}    }}
    for (i = 0; i < {len(functions)}; ++i)
        printf("%s %08lx%08lx\\n", names[i], (unsigned long)(digests[i] >> 32),
               (unsigned long)(digests[i] & 0xffffffffu));
    return 0;
}}
"""


def _defined(folder: Path) -> list[re.Match[str]]:
    return [match for path in sorted(folder.glob("radartrack_*.h")) for match in DEFINED.finditer(path.read_text())]


def _bodies(header: Path) -> Iterator[tuple[re.Match[str], str]]:
    """Each function of a header, and its text to the end."""
    text = header.read_text()
    for match in DEFINED.finditer(text):
        yield match, text[match.end() : text.index("\n}", match.end())]


def _call(place: int, name: str, given: str, kind: str) -> str:
    arrays: list[str] = []
    drawn: list[str] = []  # one after the other: C leaves the order of arguments open
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
            drawn.append(f"const {real} in{len(drawn)} = ({real})any(s);")
            passed.append(f"in{len(drawn) - 1}")
    called = f"{name}({', '.join(passed)})"
    kept = "".join(
        f" for (i = 0; i < (int)(sizeof out{n} / sizeof *out{n}); ++i) keep({place}, (double)out{n}[i]);"
        for n in range(len(arrays))
    )
    last = f"{called};{kept}" if kind == "void" else f"keep({place}, (double){called});"
    return f"        {{ {' '.join([*arrays, *drawn])} {last} }}\n"
