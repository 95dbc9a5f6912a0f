"""Decides claims in child processes, each within a time that is really kept: what runs longer is ended."""

from __future__ import annotations

import json
import queue
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from contextlib import suppress
from dataclasses import asdict, dataclass
from types import TracebackType
from typing import Any, Self, TextIO, cast

from radartrack.derive.checking.papers.claim import Claim, UnreadableClaim
from radartrack.derive.checking.papers.processor_time import processor_time

COMMAND = (sys.executable, "-P", "-m", "radartrack.derive.checking.papers.worker")
APART: dict[str, Any]  # from a terminal's Ctrl-C, which the parent answers
if sys.platform == "win32":
    APART = {"creationflags": subprocess.CREATE_NEW_PROCESS_GROUP}
else:
    APART = {"process_group": 0}
START = 60.0  # seconds that a child may take to load what it needs
EXPLANATION = 10.0  # seconds, of those that are left, for what is said beside a verdict that is known
PATIENCE = 8.0  # times as long is waited at most where other work keeps a child from computing

UNFINISHED = "what else is said beside a verdict was not found in time"
DONE = {"done": True}  # what a child writes last
CATALOGUE = 0  # the number of the world of claims that declare nothing

Record = dict[str, Any]
Files = Sequence[Mapping[str, Any]]  # what files declare beside claims: models, symbols and definitions, as data


@dataclass(frozen=True)
class Answer:
    """What a child said last, and whether it had no more to say."""

    known: Record
    complete: bool


class Decider:
    """A child process that is started when it is needed, and again after it was ended.

    Args:
        timeout: seconds of work for one claim; infinite for no limit.
        typeset: whether records hold the formulas as MathML too.

    Raises:
        ValueError: when the timeout is not positive.
    """

    def __init__(self, timeout: float, *, typeset: bool = False) -> None:
        if not timeout > 0:
            raise ValueError(f"timeout must be more than 0 seconds; got {timeout}")
        self._timeout = timeout
        self._typeset = typeset
        self._child: _Child | None = None

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, value: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._end()

    def start(self) -> None:
        """Let the child load what it needs while the caller does something else."""
        self._child = self._child or _Child()

    def decide(self, claim: Claim, files: Files = ()) -> Record:
        """The record of a claim, with what was found beside the verdict in time; undecided when there is no verdict.

        Args:
            claim: what is decided.
            files: what it may use beside the catalogue. A child reads what is the same object only once.

        Raises:
            UnreadableClaim: when the claim cannot be read.
        """
        child = self._child = self._child or _Child()
        answer = child.ask({"claim": asdict(claim), "typeset": self._typeset}, self._timeout, files)
        late = ""
        if not answer.complete:
            late = (
                "the process that checks it has ended" if child.has_ended else f"cannot decide in {self._timeout:g} s"
            )
            self._end()
        if "error" in answer.known:
            raise UnreadableClaim(answer.known["error"])
        if "undecided" in answer.known or not answer.known:
            return undecided(claim, answer.known.get("undecided", late))
        return answer.known | {"remarks": [*answer.known["remarks"], *([UNFINISHED] if late else [])]}

    def _end(self) -> None:
        if self._child is not None:
            self._child.end()
            self._child = None


def decide_all(
    claims: Sequence[Claim],
    timeout: float,
    processes: int,
    step: Callable[[], None],
    *,
    worlds: Sequence[Files] | None = None,
    typeset: bool = False,
) -> list[Record | UnreadableClaim]:
    """The records of many claims, in their order; `step` is called after each.

    Args:
        claims: what is decided.
        timeout: seconds for each.
        processes: how many decide.
        step: called after each.
        worlds: what the file of each claim declares, if any does.
        typeset: whether records hold the formulas as MathML too.
    """
    free: queue.SimpleQueue[Decider] = queue.SimpleQueue()
    deciders = [Decider(timeout, typeset=typeset) for _ in range(processes)]
    for decider in deciders:
        free.put(decider)

    def decided(claim: Claim, files: Files) -> Record | UnreadableClaim:
        decider = free.get()
        try:
            return decider.decide(claim, files)
        except UnreadableClaim as error:
            return error
        finally:
            free.put(decider)
            step()

    try:
        with ThreadPoolExecutor(processes) as pool:
            try:
                return list(pool.map(decided, claims, worlds or [()] * len(claims)))
            except BaseException:
                for decider in deciders:  # what is being decided is not waited for
                    decider.__exit__(None, None, None)
                raise
    finally:
        for decider in deciders:
            decider.__exit__(None, None, None)


def undecided(claim: Claim, reason: str) -> Record:
    """The record of a claim on which nothing can be said."""
    return {
        **claim.told,
        "verdict": "undecided",
        "quantity": claim.quantity,
        "printed": claim.printed,
        "derived": "",
        "reason": reason,
        "counterexample": None,
        "suggestions": [],
        "order": None,
        "conditions": [],
        "remarks": [],
        "convention": "",
        "terms": [],
        "reading": [],
    }


class _Child:
    """The process, and the thread that waits for its answers."""

    def __init__(self) -> None:
        self._process = subprocess.Popen(  # noqa: S603 - this interpreter, and a module of this package
            COMMAND,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            encoding="utf-8",
            **APART,
        )
        self._requests = cast("TextIO", self._process.stdin)
        self._lines = cast("TextIO", self._process.stdout)
        self._answers: queue.SimpleQueue[str] = queue.SimpleQueue()
        self._reader = threading.Thread(target=self._read, daemon=True)
        self._reader.start()
        self._ready = False
        self._worlds: dict[int, tuple[Files, int]] = {}  # by identity; what is known by it is kept for as long

    @property
    def has_ended(self) -> bool:
        """Whether it ended by itself."""
        return self._process.poll() is not None

    def ask(self, request: Record, timeout: float, files: Files) -> Answer:
        """The last that is said in time."""
        known: Record = {}
        try:
            self._ready = self._ready or bool(self._answers.get(timeout=START))
            self._send(request | {"world": self._declared(files)})
            limit = _Limit(self._process.pid, timeout)
            while line := self._next(limit):
                answer = json.loads(line)
                if answer == DONE:
                    return Answer(known, complete=True)
                limit = limit if known else _Limit(self._process.pid, min(limit.left, EXPLANATION))
                known = dict(answer)
        except (OSError, queue.Empty):
            pass
        return Answer(known, complete=False)

    def _next(self, limit: _Limit) -> str:
        """The next line, empty at the end.

        Raises:
            queue.Empty: none was written in time.
        """
        while True:
            try:
                return self._answers.get(timeout=min(limit.left, threading.TIMEOUT_MAX))
            except queue.Empty:
                if not limit.left:
                    raise

    def _declared(self, files: Files) -> int:
        """The number by which the child knows what these files declare."""
        if not files:
            return CATALOGUE
        if id(files) not in self._worlds:
            self._worlds[id(files)] = files, len(self._worlds) + 1
            self._send({"world": self._worlds[id(files)][1], "files": list(files)})
        return self._worlds[id(files)][1]

    def _send(self, request: Record) -> None:
        self._requests.write(json.dumps(request, default=str) + "\n")  # TOML has dates, which nothing asks for
        self._requests.flush()

    def end(self) -> None:
        """End the process, whatever it does."""
        self._process.kill()
        self._process.wait()
        self._reader.join()
        with suppress(OSError):
            self._requests.close()
        self._lines.close()

    def _read(self) -> None:
        for line in self._lines:
            self._answers.put(line)
        self._answers.put("")


class _Limit:
    """Seconds for which a child may compute; where the system tells what it computed, others' work is not its own."""

    def __init__(self, child: int, seconds: float) -> None:
        self._child, self._seconds = child, seconds
        self._start, self._computed = time.monotonic(), processor_time(child)

    @property
    def left(self) -> float:
        """Seconds that are left, at least."""
        waited = time.monotonic() - self._start
        computed = processor_time(self._child)
        spent = waited if computed is None or self._computed is None else computed - self._computed
        return max(min(self._seconds - spent, PATIENCE * self._seconds - waited), 0.0)
