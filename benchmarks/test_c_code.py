"""The C of conversions beside loops that are written by hand from print, compiled alike."""

import ctypes
import shutil
import subprocess
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from benchmarks.conftest import PLOTS, Floats
from radartrack.derive.catalogue import catalogue
from radartrack.derive.writing.c99 import c_elementary, c_header
from radartrack.verification.compiled_c import compiler

FLAGS = ("-std=c99", "-O3", "-march=native", "-shared", "-fPIC")
POLAR = ("r", "azimuth", "range_std", "azimuth_std")
METHODS = ["averaged", "unbiased"]
TAKEN = "const double *r, const double *b, const double *sr, const double *sb, const double *c"
Timed = Callable[..., Any]


@pytest.fixture(scope="module")
def library(tmp_path_factory: pytest.TempPathFactory) -> ctypes.CDLL:
    """Both in one library."""
    folder = tmp_path_factory.mktemp("c")
    shutil.copy(Path(__file__).with_name("hand_written.c"), folder)
    written = [c_header.conversion_in_c(catalogue(), "polar", method).written for method in METHODS]
    entrances = "".join(
        f"void {method}(size_t n, {TAKEN}, double *m, double *v) {{ {one.name}_n(n, r, b, sr, sb, c, m, v); }}\n"
        for method, one in zip(METHODS, written, strict=True)
    )
    texts = "\n".join(one.text("") for one in written)
    (folder / "ours.c").write_text(f"{c_elementary.header()}\n{texts}\n{entrances}")
    subprocess.run(
        [*(compiler() or ["cc"]), *FLAGS, "ours.c", "hand_written.c", "-o", "both.so", "-lm"], cwd=folder, check=True
    )
    return ctypes.CDLL(str(folder / "both.so"))


@pytest.mark.parametrize("method", METHODS)
class TestCPolar:
    """Mean and covariance of a million plots."""

    def test_ours(self, timed: Timed, library: ctypes.CDLL, plots: dict[str, Floats], method: str) -> None:
        timed(_call(getattr(library, method), plots), items=PLOTS, rounds=20)

    def test_by_hand(self, timed: Timed, library: ctypes.CDLL, plots: dict[str, Floats], method: str) -> None:
        timed(_call(getattr(library, f"{method}_by_hand"), plots), items=PLOTS, rounds=20)


def _call(function: Any, plots: dict[str, Floats]) -> Callable[[], None]:
    arrays = [*(plots[name] for name in POLAR), np.zeros(PLOTS), np.empty((PLOTS, 2)), np.empty((PLOTS, 2, 2))]
    pointers = [array.ctypes.data_as(ctypes.c_void_p) for array in arrays]

    def run() -> None:
        del arrays[len(pointers) :]  # they are kept as long as this is
        function(ctypes.c_size_t(PLOTS), *pointers)

    return run
