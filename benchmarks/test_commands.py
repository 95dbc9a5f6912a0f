"""Deriving, checking and importing."""

import os
import subprocess
import sys
from collections.abc import Callable
from typing import Any

import pytest
import sympy

from radartrack._regeneration import numpy_modules
from radartrack.derive import check
from radartrack.derive.catalogue import catalogue

Timed = Callable[..., Any]
SET = tuple(name for name in catalogue() if name.startswith("polar."))


class TestRegenerate:
    """The polar quantities, derived, rewritten, proved and written, in a fresh process."""

    def test_radartrack(self, timed: Timed) -> None:
        timed(in_a_process, f"from benchmarks.test_commands import ours; ours({SET})", items=len(SET), rounds=2)

    def test_plain_sympy(self, timed: Timed) -> None:
        call = f"from benchmarks.test_commands import plain; plain({SET})"
        timed(in_a_process, call, items=len(SET), rounds=1)


class TestCheck:
    """A warm process checks a formula of the catalogue."""

    @pytest.mark.parametrize("name", ["polar.covariance.averaged[0,0]", "spherical.covariance.linear[0,0]"])
    def test_radartrack(self, timed: Timed, name: str) -> None:
        quantity, _, index = name.partition("[")
        entry = catalogue()[quantity].expression[tuple(int(n) for n in index.rstrip("]").split(","))]
        timed(check, name, str(sympy.expand(entry)), items=1)


EVERYTHING = (
    "import radartrack as r; r.convert, r.observe, r.validity, r.FiniteSampleFilter, r.kalman, r.line, r.fusion"
)


class TestImport:
    """In a process of its own; what is loaded on first use is used."""

    def test_radartrack(self, timed: Timed) -> None:
        timed(in_a_process, EVERYTHING, items=1, rounds=15)

    def test_numpy(self, timed: Timed) -> None:
        timed(in_a_process, "import numpy", items=1, rounds=15)


def in_a_process(statements: str) -> None:
    """With the modules' bytecode on disk, as installers leave it."""
    kept = {name: value for name, value in os.environ.items() if name != "PYTHONDONTWRITEBYTECODE"}
    subprocess.run([sys.executable, "-c", statements], check=True, env=kept)


def ours(names: tuple[str, ...]) -> None:
    """What `regenerate` does with each quantity."""
    for name in names:
        numpy_modules.written(catalogue()[name])


def plain(names: tuple[str, ...]) -> None:
    """The same set with `simplify` and `lambdify(cse=True)`."""
    for name in names:
        quantity = catalogue()[name]
        entries = [sympy.simplify(entry) for entry in quantity.expression]
        sympy.lambdify(quantity.symbols, entries, "numpy", cse=True)
