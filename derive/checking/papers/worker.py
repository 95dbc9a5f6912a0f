"""A process of its own that decides claims: it can be ended at any moment.

It is told once what a file declares, as data. For each claim it writes lines of JSON: the verdict as soon as it is
known, the same with more beside it, and that it is done.

Run as `python -m radartrack.derive.checking.papers.worker`; see `radartrack.derive.checking.papers.deadline`.
"""

from __future__ import annotations

import json
import os
import queue
import signal
import sys
import threading
from collections.abc import Iterator, Mapping, Sequence
from io import TextIOWrapper
from typing import Any, cast

from radartrack.derive.checking.papers import audit, mathml
from radartrack.derive.checking.papers.claim import Claim, UnreadableClaim
from radartrack.derive.checking.papers.deadline import CATALOGUE, DONE
from radartrack.derive.checking.question import world
from radartrack.derive.checking.question.declared_world import world_of
from radartrack.derive.checking.question.world import World
from radartrack.derive.checking.reporting.barrier import attempted, reason
from radartrack.derive.reading.symbol_table import TableError

try:
    import resource
except ImportError:  # not on Windows
    resource = None  # type: ignore[assignment]

READY = "ready"
MEMORY = 400 * 2**20  # bytes of data


class Worlds:
    """What files declare, by number; it is read when a claim first needs it, in the time of that claim."""

    def __init__(self) -> None:
        self._files: dict[int, Sequence[Mapping[str, Any]]] = {}
        self._known = {CATALOGUE: world.CATALOGUE}

    def declare(self, number: int, files: Sequence[Mapping[str, Any]]) -> None:
        """Remember what the files of a world declare."""
        self._files[number] = files

    def find(self, number: int) -> World:
        """The world of this number.

        Raises:
            TableError: where it cannot be read.
        """
        if number not in self._known:
            self._known[number] = world_of(self._files[number])
        return self._known[number]


def main() -> None:
    """Answer requests for as long as there is somebody who asks."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C is for the parent
    _limit_memory()
    for stream in (sys.stdin, sys.stdout):
        cast("TextIOWrapper", stream).reconfigure(encoding="utf-8")  # as the parent has it, whatever the terminal has
    requests: queue.SimpleQueue[str] = queue.SimpleQueue()
    threading.Thread(target=_read, args=(requests,), daemon=True).start()
    _tell(READY)
    worlds = Worlds()
    while True:
        request = json.loads(requests.get())
        if "files" in request:
            worlds.declare(request["world"], request["files"])
            continue
        for answer in _answers(request, worlds):
            _tell(json.dumps(answer))


def _tell(line: str) -> None:
    try:
        sys.stdout.write(line + "\n")
        sys.stdout.flush()
    except OSError:
        os._exit(0)  # nobody listens any more


def _read(requests: queue.SimpleQueue[str]) -> None:
    """Hand on requests; the pipe ends with the parent, and so does this process, whatever it is computing."""
    for line in sys.stdin:
        requests.put(line)
    os._exit(0)


def _answers(request: Mapping[str, Any], worlds: Worlds) -> Iterator[dict[str, Any]]:
    """What is known of a claim, each time more; what fails after the verdict is known does not undo it."""
    claim = Claim(**request["claim"])
    known: dict[str, Any] = {}
    try:
        for verdict in audit.decisions(claim, worlds.find(request["world"])):
            known = audit.record(claim, verdict)
            yield known
        if request["typeset"]:
            yield known | attempted(lambda: mathml.formulas(claim, verdict), lambda _: {})
    except UnreadableClaim as error:
        yield {"error": str(error)}
    except TableError as error:
        yield {"error": f"claim {claim.id!r}: {error}"}
    except Exception as error:  # noqa: BLE001 - as in `barrier`
        yield known or {"undecided": f"this {reason(error)}"}
    yield DONE


def _limit_memory() -> None:
    """Refuse to grow without bound, where the system can limit a process."""
    if resource is None:
        return
    limit = resource.RLIMIT_DATA if sys.platform == "linux" else resource.RLIMIT_AS
    _, hard = resource.getrlimit(limit)
    if hard == resource.RLIM_INFINITY or hard > MEMORY:
        try:
            resource.setrlimit(limit, (MEMORY, hard))
        except (OSError, ValueError):
            return


if __name__ == "__main__":
    main()
