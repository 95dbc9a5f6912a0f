"""Conversions and filters serve in every process: ending, forked, without a home, beside a broken compiler."""

import os
import pickle
import subprocess
import sys
from collections.abc import Iterator, Mapping
from pathlib import Path
from types import ModuleType, SimpleNamespace
from typing import Any

import numpy as np
import pytest

from radartrack import convert
from radartrack._arrays import batches, machine_code

MANY = 200_000
SERVED = f"""
import os, sys, threading, time
import numpy as np
import radartrack as rt
from radartrack._arrays import batches
from radartrack._arrays import machine_code

batches._most_at_once = lambda: 4  # whatever cores this machine has
if "numba" not in sys.argv:
    machine_code.is_available = lambda: False

def served():
    ranges, sums = np.linspace(1e3, 1e5, {MANY}), np.zeros(4)
    plots = rt.convert.polar(ranges, 1.0, 5.0, 0.05, method="linear")
    assert np.allclose(plots.mean[:, 0], ranges * np.cos(1.0), rtol=1e-14)
    tracks = rt.FiniteSampleFilter(period=1.0, range_std=5.0).estimate(np.tile(ranges[:100_000, np.newaxis], 4))
    assert np.allclose(tracks.state[:, 0], ranges[:100_000], rtol=1e-12)
    os.write(1, b"served\\n")
"""

LATE_THREAD = """
def late():
    while threading.main_thread().is_alive():
        time.sleep(1e-3)
    time.sleep(0.05)
    served()

threading.Thread(target=late).start()
"""
AT_EXIT = "import atexit; atexit.register(served)\n"
FORKED = """
child = os.fork()
served()
if child and os.waitpid(child, 0)[1]:
    sys.exit("the forked process failed")
"""
MULTIPROCESSING = """
from multiprocessing import get_context
process = get_context("fork").Process(target=served)
process.start()
process.join()
assert process.exitcode == 0
"""
FEW_THREADS = """
started = threading.Thread.start
def refuses(thread):
    if thread.name.startswith("radartrack"):
        raise RuntimeError("can't start new thread")
    started(thread)
threading.Thread.start = refuses
served()
"""
SCENES = {"late thread": LATE_THREAD, "at exit": AT_EXIT, "no threads": FEW_THREADS}
if hasattr(os, "fork"):
    SCENES |= {"fork": FORKED, "multiprocessing": MULTIPROCESSING}
if hasattr(os, "fork") and sys.version_info < (3, 12):  # where Python itself refuses it
    SCENES["fork in a late thread"] = LATE_THREAD.replace(
        "    served()", "    served()\n" + "\n".join(f"    {line}" for line in FORKED.strip().splitlines())
    )


def run(script: str, *arguments: str, **environment: str) -> str:
    done = subprocess.run(
        [sys.executable, "-W", "error", "-W", "ignore::DeprecationWarning", "-c", script, *arguments],
        capture_output=True,
        text=True,
        check=False,
        timeout=120,
        env={**os.environ, **environment},
    )
    assert (done.returncode, done.stderr) == (0, "")
    return done.stdout


@pytest.mark.parametrize("threads_before", [False, True], ids=["no threads yet", "threads before"])
@pytest.mark.parametrize("scene", SCENES)
def test_what_runs_on_all_cores_is_served_in_every_process(scene: str, threads_before: bool) -> None:
    script = SERVED + ("served()\n" if threads_before else "") + SCENES[scene]
    assert set(run(script).split()) == {"served"}


# Numba, present and broken.


@pytest.fixture
def _fresh() -> Iterator[None]:
    """Nothing is known of Numba yet."""
    for known in (machine_code.is_available, machine_code.conversion):
        known.cache_clear()
    yield
    for known in (machine_code.is_available, machine_code.conversion):
        known.cache_clear()


def numba(**failures: Exception) -> Any:
    """A package that compiles by doing nothing, or fails where a cache is wanted, and where none is."""

    def njit(*, cache: bool = False, **_: Any) -> Any:
        if failure := failures.get("cached" if cache else "plain"):
            raise failure
        return lambda loop: SimpleNamespace(compile=lambda _: None, disable_compile=lambda: None, __call__=loop)

    return njit


FAILURES = [
    RuntimeError("cannot cache function: no locator available"),
    OSError(28, "No space left on device"),
    PermissionError(13, "Permission denied"),
    pickle.UnpicklingError("pickle data was truncated"),
    EOFError("Ran out of input"),
    UnicodeDecodeError("utf-8", b"\xff", 0, 1, "invalid start byte"),
    MemoryError(),
    AttributeError("Can't get attribute"),
    ModuleNotFoundError("No module named 'llvmlite'"),
    SystemError("initialization failed"),
]


def plots() -> np.ndarray:
    return np.linspace(1e3, 1e5, 2 * machine_code.COMPILED_FROM)


@pytest.mark.usefixtures("_fresh")
@pytest.mark.parametrize("failure", FAILURES, ids=lambda failure: type(failure).__name__)
def test_numpy_serves_where_numba_compiles_nothing(failure: Exception, monkeypatch: pytest.MonkeyPatch) -> None:
    broken = ModuleType("numba")
    vars(broken).update(
        njit=numba(cached=failure, plain=failure),
        float64=np.empty((1, 1, 1)),
        types=SimpleNamespace(Array=lambda *_, **__: None),
    )
    monkeypatch.setitem(sys.modules, "numba", broken)
    found = convert.polar(plots(), 1.0, 5.0, 0.05)
    monkeypatch.setattr(machine_code, "is_available", lambda: False)
    expected = convert.polar(plots(), 1.0, 5.0, 0.05)
    np.testing.assert_array_equal(found.covariance, expected.covariance)


@pytest.mark.parametrize("failure", FAILURES, ids=lambda failure: type(failure).__name__)
def test_machine_code_that_cannot_be_kept_or_read_is_compiled_again(failure: Exception) -> None:
    def compiling(*, cache: bool = False, **_: Any) -> str:
        if cache:
            raise failure
        return "compiled"

    assert machine_code.machine_code(compiling) == "compiled"


BROKEN_PACKAGES = {
    "exit": "import sys; sys.exit('no processor that is known')",
    "version": "raise ImportError('Numba needs NumPy 2.4 or less. Got NumPy 9.9.')",
    "system": "raise SystemError('initialization of _internal failed')",
    "lacking": "",
    "syntax": "def",
    "binary": "raise OSError('libLLVM.so: cannot open shared object file')",
}


@pytest.mark.parametrize("text", BROKEN_PACKAGES.values(), ids=BROKEN_PACKAGES)
def test_numpy_serves_where_the_numba_that_is_installed_cannot_be_loaded(text: str, tmp_path: Path) -> None:
    (tmp_path / "numba").mkdir()
    (tmp_path / "numba" / "__init__.py").write_text(text)
    path = os.pathsep.join(filter(None, [str(tmp_path), os.environ.get("PYTHONPATH")]))
    assert run(SERVED + "served()", "numba", PYTHONPATH=path) == "served\n"


FORKED_WHILE_IT_LOADS = (
    SERVED.replace("os.write", "assert 'numba' in sys.modules; os.write")
    + f"""
threading.Thread(target=machine_code.is_available).start()
while "numba" not in sys.modules:
    time.sleep(1e-3)
{FORKED}"""
)


@pytest.mark.skipif(not hasattr(os, "fork"), reason="there is no fork here")
def test_a_process_that_is_forked_while_another_thread_loads_numba_is_served(tmp_path: Path) -> None:
    (tmp_path / "numba").mkdir()
    (tmp_path / "numba" / "__init__.py").write_text("import time; time.sleep(0.3)")
    path = os.pathsep.join(filter(None, [str(tmp_path), os.environ.get("PYTHONPATH")]))
    assert run(FORKED_WHILE_IT_LOADS, "numba", PYTHONPATH=path) == "served\nserved\n"


KEPT = """
import sys, numpy as np, radartrack as rt
from radartrack._arrays import machine_code
ranges = np.linspace(1e3, 1e5, 300)
plots = rt.convert.polar(ranges, 1.0, 5.0, 0.05, method="linear")
assert np.allclose(plots.mean[:, 0], ranges * np.cos(1.0), rtol=1e-14)
assert not machine_code.is_available() or machine_code.conversion("polar_linear", 2) is not None
"""


def damaged(files: Mapping[Path, bytes], kind: str) -> None:
    for path, whole in files.items():
        match kind:
            case "empty":
                path.write_bytes(b"")
            case "cut":
                path.write_bytes(whole[: len(whole) // 2])
            case _:
                path.write_bytes(b"\x80\x04garbage" + whole[10:])


def test_damaged_machine_code_on_disk_is_not_used(tmp_path: Path) -> None:
    run(KEPT, NUMBA_CACHE_DIR=str(tmp_path))
    files = {path: path.read_bytes() for path in tmp_path.rglob("*.nb[ic]")}
    assert len(files) == (2 if machine_code.is_available() else 0)
    for suffix, kind in ((".nbi", "cut"), (".nbc", "garbled")):
        for path, whole in files.items():
            path.write_bytes(whole)
        damaged({path: whole for path, whole in files.items() if path.suffix == suffix}, kind)
        run(KEPT, NUMBA_CACHE_DIR=str(tmp_path))


def test_machine_code_without_a_place_to_keep_it(tmp_path: Path) -> None:
    """A file stands where the cache should be: the package directory may be written to here, so it is not asked."""
    (tmp_path / "taken").write_text("")
    run(KEPT, NUMBA_CACHE_DIR=str(tmp_path / "taken" / "cache"))


def test_all_threads_that_are_to_be_had_help(monkeypatch: pytest.MonkeyPatch) -> None:
    """Two of three begin before the system refuses."""
    given: list[Any] = []

    class Pool:
        def submit(self, run: Any) -> Any:
            if len(given) == 2:
                raise RuntimeError("can't start new thread")
            given.append(run)
            return SimpleNamespace(cancel=lambda: True)

    monkeypatch.setattr(batches, "_threads", Pool)
    monkeypatch.setattr(batches, "_most_at_once", lambda: 4)
    values, out = np.arange(64.0), np.empty(64)
    batches.fill(np.square, [values], [out], block=1)
    assert len(given) == 2
    np.testing.assert_array_equal(out, values**2)
