"""Decides claims in child processes, each within a time that is really kept: what runs longer is ended."""

from __future__ import annotations

import json
import queue
import subprocess
import sys
import threading
from collections.abc import Callable, Iterable
from concurrent.futures import ThreadPoolExecutor
from contextlib import suppress
from dataclasses import asdict
from types import TracebackType
from typing import Any, Self, TextIO, cast

from radartrack.derive.checking.papers.claims_file import Claim, UnreadableClaim

COMMAND = (sys.executable, "-P", "-m", "radartrack.derive.checking.papers.worker")
APART: dict[str, Any]  # from a terminal's Ctrl-C, which the parent answers
if sys.platform == "win32":
    APART = {"creationflags": subprocess.CREATE_NEW_PROCESS_GROUP}
else:
    APART = {"process_group": 0}
START = 60.0  # seconds that a child may take to load what it needs

Record = dict[str, Any]


class Decider:
    """A child process that is started when it is needed, and again after it was ended.

    Args:
        timeout: seconds for one claim.
        typeset: whether records hold the formulas as MathML too.
    """

    def __init__(self, timeout: float, *, typeset: bool = False) -> None:
        self._timeout = timeout
        self._typeset = typeset
        self._child: _Child | None = None

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, value: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._end()

    def decide(self, claim: Claim) -> Record:
        """The record of a claim; undecided when the time is over.

        Raises:
            UnreadableClaim: when the claim cannot be read.
        """
        child = self._child = self._child or _Child()
        answer = child.ask({"claim": asdict(claim), "typeset": self._typeset}, self._timeout)
        if answer is None:
            ended = child.has_ended
            self._end()
            reason = "the process that checks it has ended" if ended else f"cannot decide in {self._timeout:g} s"
            return undecided(claim, reason)
        if "error" in answer:
            raise UnreadableClaim(answer["error"])
        return undecided(claim, answer["undecided"]) if "undecided" in answer else answer

    def _end(self) -> None:
        if self._child is not None:
            self._child.end()
            self._child = None


def decide_all(
    claims: Iterable[Claim],
    timeout: float,
    processes: int,
    step: Callable[[], None],
    *,
    typeset: bool = False,
) -> list[Record | UnreadableClaim]:
    """The records of many claims, in their order; `step` is called after each."""
    free: queue.SimpleQueue[Decider] = queue.SimpleQueue()
    deciders = [Decider(timeout, typeset=typeset) for _ in range(processes)]
    for decider in deciders:
        free.put(decider)

    def decided(claim: Claim) -> Record | UnreadableClaim:
        decider = free.get()
        try:
            return decider.decide(claim)
        except UnreadableClaim as error:
            return error
        finally:
            free.put(decider)
            step()

    try:
        with ThreadPoolExecutor(processes) as pool:
            try:
                return list(pool.map(decided, claims))
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
        "id": claim.id,
        "equation": claim.equation,
        "page": claim.page,
        "note": claim.note,
        "at": dict(claim.at),
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

    @property
    def has_ended(self) -> bool:
        """Whether it ended by itself."""
        return self._process.poll() is not None

    def ask(self, request: Record, timeout: float) -> Record | None:
        """The answer, or None when there is none in time."""
        try:
            self._ready = self._ready or bool(self._answers.get(timeout=START))
            self._requests.write(json.dumps(request) + "\n")
            self._requests.flush()
            answer = self._answers.get(timeout=timeout)
        except (OSError, queue.Empty):
            return None
        return dict(json.loads(answer)) if answer else None

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
