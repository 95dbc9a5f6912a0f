"""Processes end with the one that they work for, however it ends, and Ctrl-C is its alone to answer."""

import os
import signal
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

import pytest

from tests.processes import PATIENCE

POOL = """
import sys, time
from multiprocessing import get_context
from radartrack._system.worker_processes import Workers, ended_on_failure, serve

if __name__ == "__main__":
    with ended_on_failure(Workers(2, get_context(sys.argv[1]), initializer=serve)) as pool:
        first = pool.submit(time.sleep, 0)
        busy = [pool.submit(time.sleep, 600) for _ in range(8)]
        first.result()
        print("busy", flush=True)
        busy[0].result()
"""
CHECKER = """
import sys
from radartrack.derive.checking.papers.claim import Claim
from radartrack.derive.checking.papers.deadline import Decider, decide_all

WHOLE = "+".join(f"(sin(beta) + cos({n}*beta) + exp(sigma_beta**2) + rho)**50" for n in range(2, 9))
SLOW = Claim("slow", "polar.covariance.linear[0,0]", formula=f"r**2*sigma_beta**2*({WHOLE})")
decider = Decider.decide

def decide(self, claim, files=()):
    if claim is SLOW:
        print("busy", flush=True)
    return decider(self, claim, files)

Decider.decide = decide
decide_all([Claim("quick", "polar.map[0]", formula="r*cos(beta)"), SLOW, SLOW, SLOW], 600, 1, lambda: None)
"""
PROGRAMS = {"spawn": [POOL, "spawn"], "forkserver": [POOL, "forkserver"], "checker": [CHECKER]}


@contextmanager
def busy(program: list[str], folder: Path) -> Iterator["subprocess.Popen[str]"]:
    """A process whose workers are in the middle of work of ten minutes."""
    code, *arguments = program
    (folder / "program.py").write_text(code)
    process = subprocess.Popen(
        [sys.executable, folder / "program.py", *arguments],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        start_new_session=True,
    )
    try:
        assert process.stdout is not None
        assert process.stdout.readline() == "busy\n"
        yield process
    finally:
        with suppress(ProcessLookupError):
            os.killpg(process.pid, signal.SIGKILL)  # workers that did not end by themselves
        process.communicate(timeout=PATIENCE)


each_program = pytest.mark.parametrize("program", PROGRAMS.values(), ids=PROGRAMS.keys())


@each_program
@pytest.mark.parametrize("number", [signal.SIGKILL, signal.SIGTERM])
def test_workers_end_when_the_process_they_work_for_is_ended(
    program: list[str], number: signal.Signals, tmp_path: Path
) -> None:
    with busy(program, tmp_path) as process:
        process.send_signal(number)
        process.communicate(timeout=PATIENCE)  # ends when nobody holds the error stream any more, workers among them
        assert process.returncode == -number


@each_program
def test_an_interrupt_of_all_ends_all_at_once_and_only_the_parent_speaks(program: list[str], tmp_path: Path) -> None:
    with busy(program, tmp_path) as process:
        os.killpg(process.pid, signal.SIGINT)
        _, said = process.communicate(timeout=PATIENCE)
        assert said.count("Traceback") == 1  # of this program; the commands have none
        assert said.splitlines()[-1] == "KeyboardInterrupt"
        assert process.returncode == -signal.SIGINT


COMMAND = CHECKER.partition("decide_all([")[0] + (
    "import radartrack.derive.checking.papers.claim as claims; claims.Claim = lambda *_, **__: SLOW\n"
    'from radartrack.cli import app; app(["check", "polar.map[0]", "r"])\n'
)
REGENERATION = """
import sys, time
from concurrent.futures import Future
from radartrack._regeneration import deriving

def begun(*_):
    print("busy", flush=True)
    return original(*_)

original = Future.result
Future.result = begun
if __name__ == "__main__":
    from radartrack.cli import app
    app(["regenerate", "--out", sys.argv[1]])
"""


def test_an_interrupted_command_says_nothing_of_it(tmp_path: Path) -> None:
    with busy([COMMAND], tmp_path) as process:
        os.killpg(process.pid, signal.SIGINT)
        _, said = process.communicate(timeout=PATIENCE)
        assert (process.returncode, said) == (130, "")


@pytest.mark.parametrize("code", [COMMAND, REGENERATION], ids=["check", "regenerate"])
def test_a_command_that_is_asked_to_end_says_and_leaves_nothing(code: str, tmp_path: Path) -> None:
    with busy([code, str(tmp_path / "out")], tmp_path) as process:
        process.send_signal(signal.SIGTERM)
        _, said = process.communicate(timeout=PATIENCE)
        assert (process.returncode, said) == (143, "")
    assert [path.name for path in tmp_path.iterdir()] == ["program.py"]
