"""A process of its own that decides claims, one line of JSON for each: it can be ended at any moment.

Run as `python -m radartrack.derive.checking.papers.worker`; see `radartrack.derive.checking.papers.deadline`.
"""

from __future__ import annotations

import json
import sys
from collections.abc import Mapping
from typing import Any

from radartrack.derive.checking.papers import audit, mathml
from radartrack.derive.checking.papers.claims_file import Claim, UnreadableClaim

try:
    import resource
except ImportError:  # not on Windows
    resource = None  # type: ignore[assignment]

READY = "ready"
MEMORY = 400 * 2**20  # bytes of data


def main() -> None:
    """Answer requests until there are no more."""
    _limit_memory()
    sys.stdout.write(READY + "\n")
    sys.stdout.flush()
    for line in sys.stdin:
        sys.stdout.write(json.dumps(_answer(json.loads(line))) + "\n")
        sys.stdout.flush()


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
