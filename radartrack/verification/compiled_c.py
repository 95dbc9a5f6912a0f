"""Generated C, compiled by the compiler of this machine and called like a function of NumPy's.

The code is derived and written anew, so that what is verified is what `regenerate --language c` writes.
"""

from __future__ import annotations

import ctypes
import os
import shlex
import shutil
import subprocess
import tempfile
from dataclasses import dataclass
from functools import cached_property, lru_cache
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

from radartrack.derive.language.quantity import Quantity
from radartrack.derive.stable.quantity_form import form_of
from radartrack.derive.writing.c99 import c_elementary
from radartrack.derive.writing.c99.c_function import CFunction, of_quantity, real_of
from radartrack.verification.domain_points import Points

DOUBLE, SINGLE = "C", "C single"  # paths to a quantity
PATHS = (DOUBLE, SINGLE)
FLAGS = ("-std=c99", "-O2", "-ffp-contract=off", "-shared", "-fPIC")
COMPILERS = ("cc", "gcc", "clang")
LIBRARIES = 64  # that a process keeps

Array = npt.NDArray[np.float64]


class NotCompiled(RuntimeError):
    """There is no compiler for C, or it does not take what is written."""


@dataclass(frozen=True)
class InC:
    """A quantity as C computes it, called like its generated function.

    Attributes:
        quantity: what is computed.
        path: in double or in single precision.
    """

    quantity: Quantity
    path: str

    @property
    def dtype(self) -> type[np.floating[Any]]:
        """The type that it computes in."""
        return np.float32 if self.path == SINGLE else np.float64

    def __call__(self, **given: npt.ArrayLike) -> Array:
        """Keywords that broadcast; shape (..., *tensor)."""
        return self._run(given)[0]

    def within_range(self, points: Points) -> npt.NDArray[np.bool_]:
        """At which points no operation overflows, underflows, divides by zero or has no value."""
        return np.asarray(self._run(points)[1] == 0)

    def _run(self, given: Any) -> tuple[Array, npt.NDArray[np.int32]]:
        names = [symbol.name for symbol in self.quantity.symbols]
        spread = np.broadcast_arrays(*(np.asarray(given[name], dtype=np.float64) for name in names))
        shape = spread[0].shape if names else ()
        columns = [np.ascontiguousarray(column.ravel().astype(self.dtype)) for column in spread]
        count = len(columns[0]) if names else 1
        found = np.full((count, *self.quantity.shape), np.nan, self.dtype)
        flags = np.zeros(count, np.int32)
        pointers = [column.ctypes.data_as(ctypes.c_void_p) for column in [*columns, found, flags]]
        run = getattr(self._library, f"run{'f' if self.path == SINGLE else ''}")
        run(ctypes.c_size_t(count), *pointers)
        return found.astype(np.float64).reshape((*shape, *self.quantity.shape)), flags.reshape(shape)

    @cached_property
    def _library(self) -> ctypes.CDLL:
        return library(_written(self.quantity))


def along(path: str, quantity: Quantity) -> InC:
    """What computes a quantity on this path."""
    return InC(quantity, path)


def compiler() -> list[str] | None:
    """The command of the C compiler: that of the variable CC, or one that is found; None where there is none."""
    named = shlex.split(os.environ.get("CC", ""))
    if named:
        return named if shutil.which(named[0]) else None
    found = next(filter(None, map(shutil.which, COMPILERS)), None)
    return [found] if found else None


@lru_cache(maxsize=LIBRARIES)
def _written(quantity: Quantity) -> CFunction:
    return of_quantity(quantity, form_of(quantity))


@lru_cache(maxsize=LIBRARIES)
def library(function: CFunction) -> ctypes.CDLL:
    """A function in both precisions, compiled: `run` and `runf` take a count and arrays.

    Raises:
        NotCompiled: when that fails.
    """
    command = compiler()
    if command is None:
        raise NotCompiled("there is no C compiler; CC may name one")
    with tempfile.TemporaryDirectory(prefix="radartrack-") as folder:
        source, target = Path(folder) / "code.c", Path(folder) / "code.so"
        source.write_text(program(function), encoding="utf-8")
        done = subprocess.run(  # noqa: S603 - the user's own compiler, on what was written here
            [*command, *FLAGS, str(source), "-o", str(target), "-lm"], capture_output=True, text=True, check=False
        )
        if done.returncode:
            raise NotCompiled(f"{command[0]} does not compile {function.name}: {done.stderr[:500]}")
        return ctypes.CDLL(str(target))


def program(function: CFunction) -> str:
    """The function with an entrance for arrays, which also says what exceptions each point raises."""
    elementary = c_elementary.header()
    entrances = "".join(_entrance(function, suffix) for suffix in ("", "f"))
    return f"#include <fenv.h>\n{elementary}\n{function.text(function.name)}\n{entrances}"


def _entrance(function: CFunction, suffix: str) -> str:
    """Not inlined, so that no operation leaves the place between the flags' clearing and their reading.

    No argument of a function has one of the names that are used here.
    """
    real = real_of(suffix)
    taken = "".join(f"const {real} *{name}, " for name in function.arguments)
    at = [f"{name}[i]" for name in function.arguments]
    called = f"{function.name}{suffix}({', '.join([*at, *(['result'] if function.outputs else [])])});"
    return f"""
static __attribute__((noinline)) void radartrack_one{suffix}(size_t i, {taken}{real} *result)
{{
    (void)i;
    {called if function.outputs else f"*result = {called}"}
}}

void run{suffix}(size_t n, {taken}{real} *result, int *radartrack_flags)
{{
    size_t i;
    for (i = 0; i < n; ++i) {{
        feclearexcept(FE_ALL_EXCEPT);
        radartrack_one{suffix}(i, {"".join(f"{name}, " for name in function.arguments)}result + {function.size}u * i);
        radartrack_flags[i] = fetestexcept(FE_DIVBYZERO | FE_INVALID | FE_OVERFLOW | FE_UNDERFLOW);
    }}
}}
"""
