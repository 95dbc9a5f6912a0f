"""A process of its own that decides claims: it can be ended at any moment.

For each claim it writes lines of JSON: the verdict as soon as it is known, the same with more beside it, and that it
is done.

Run as `python -m radartrack.derive.checking.papers.worker`; see `radartrack.derive.checking.papers.deadline`.
"""

from __future__ import annotations

import json
import os
import queue
import signal
import sys
import threading
from collections.abc import Iterator, Mapping
from io import TextIOWrapper
from typing import Any, cast

from radartrack.derive.checking.papers import audit, mathml
from radartrack.derive.checking.papers.claims_file import Claim, UnreadableClaim
from radartrack.derive.checking.papers.deadline import DONE
from radartrack.derive.checking.reporting.barrier import attempted, reason

try:
    import resource
except ImportError:  # not on Windows
    resource = None  # type: ignore[assignment]

READY = "ready"
MEMORY = 400 * 2**20  # bytes of data


def main() -> None:
    """Answer requests for as long as there is somebody who asks."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C is for the parent
    _limit_memory()
    for stream in (sys.stdin, sys.stdout):
        cast("TextIOWrapper", stream).reconfigure(encoding="utf-8")  # as the parent has it, whatever the terminal has
    requests: queue.SimpleQueue[str] = queue.SimpleQueue()
    threading.Thread(target=_read, args=(requests,), daemon=True).start()
    _tell(READY)
    while True:
        for answer in _answers(json.loads(requests.get())):
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


def _answers(request: Mapping[str, Any]) -> Iterator[dict[str, Any]]:
    """What is known of a claim, each time more; what fails after the verdict is known does not undo it."""
    claim = Claim(**request["claim"])
    known: dict[str, Any] = {}
    try:
        for verdict in audit.decisions(claim):
            known = audit.record(claim, verdict)
            yield known
        if request["typeset"]:
            yield known | attempted(lambda: mathml.formulas(claim, verdict), lambda _: {})
    except UnreadableClaim as error:
        yield {"error": str(error)}
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
