"""The C of a conversion beside loops that are written by hand, compiled alike."""

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

FLAGS = ("-std=c99", "-O2", "-shared", "-fPIC")  # what most build with
POLAR = ("r", "azimuth", "range_std", "azimuth_std")
TAKEN = "const double *r, const double *b, const double *sr, const double *sb, const double *c"
Timed = Callable[..., Any]


@pytest.fixture(scope="module")
def library(tmp_path_factory: pytest.TempPathFactory) -> ctypes.CDLL:
    """All in one library."""
    folder = tmp_path_factory.mktemp("c")
    shutil.copy(Path(__file__).with_name("hand_written.c"), folder)
    written = c_header.conversion_in_c(catalogue(), "polar", "unbiased").written
    entrance = f"{written.name}_n(n, r, b, sr, sb, c, m, v);"
    (folder / "ours.c").write_text(
        f"{c_elementary.header()}\n{written.text('')}\n"
        f"void unbiased(size_t n, {TAKEN}, double *m, double *v) {{ {entrance} }}\n"
    )
    subprocess.run(
        [*(compiler() or ["cc"]), *FLAGS, "ours.c", "hand_written.c", "-o", "all.so", "-lm"], cwd=folder, check=True
    )
    return ctypes.CDLL(str(folder / "all.so"))


class TestCPolar:
    """Mean and covariance of a million plots, one thread."""

    def test_ours(self, timed: Timed, library: ctypes.CDLL, plots: dict[str, Floats]) -> None:
        timed(_call(library.unbiased, plots), items=PLOTS, rounds=20)

    def test_by_hand(self, timed: Timed, library: ctypes.CDLL, plots: dict[str, Floats]) -> None:
        timed(_call(library.unbiased_by_hand, plots), items=PLOTS, rounds=20)

    def test_as_printed(self, timed: Timed, library: ctypes.CDLL, plots: dict[str, Floats]) -> None:
        timed(_call(library.unbiased_as_printed, plots), items=PLOTS, rounds=20)


def _call(function: Any, plots: dict[str, Floats]) -> Callable[[], None]:
    arrays = [*(plots[name] for name in POLAR), np.zeros(PLOTS), np.empty((PLOTS, 2)), np.empty((PLOTS, 2, 2))]

    def run() -> None:
        function(ctypes.c_size_t(PLOTS), *(array.ctypes.data_as(ctypes.c_void_p) for array in arrays))

    return run
