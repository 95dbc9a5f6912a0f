"""A process of its own that decides claims, one line of JSON for each: it can be ended at any moment.

Run as `python -m radartrack.derive.checking.papers.worker`; see `radartrack.derive.checking.papers.deadline`.
"""

from __future__ import annotations

import json
import os
import queue
import signal
import sys
import threading
from collections.abc import Mapping
from io import TextIOWrapper
from typing import Any, cast

from radartrack.derive.checking.papers import audit, mathml
from radartrack.derive.checking.papers.claims_file import Claim, UnreadableClaim

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
    sys.stdout.write(READY + "\n")
    sys.stdout.flush()
    while True:
        line = requests.get()
        sys.stdout.write(json.dumps(_answer(json.loads(line))) + "\n")
        sys.stdout.flush()


def _read(requests: queue.SimpleQueue[str]) -> None:
    """Hand on requests; the pipe ends with the parent, and so does this process, whatever it is computing."""
    for line in sys.stdin:
        requests.put(line)
    os._exit(0)


def _answer(request: Mapping[str, Any]) -> dict[str, Any]:
    claim = Claim(**request["claim"])
    try:
        verdict = audit.decide(claim)
    except UnreadableClaim as error:
        return {"error": str(error)}
    except (MemoryError, RecursionError):
        return {"undecided": "needs more memory than is allowed"}
    answer = audit.record(claim, verdict)
    return answer | (mathml.formulas(claim, verdict) if request["typeset"] else {})


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
