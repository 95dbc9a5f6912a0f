"""A verdict that is known is told, whatever becomes of what is said beside it."""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeVar

Found = TypeVar("Found")


def attempted(work: Callable[[], Found], failed: Callable[[str], Found]) -> Found:
    """What the work gives; where it fails, whatever the reason, what is made of that reason in words."""
    try:
        return work()
    except Exception as error:  # noqa: BLE001 - a stranger's formula may find a fault anywhere, of SymPy's or ours
        return failed(reason(error))


def reason(error: Exception) -> str:
    """Why something could not be worked out."""
    if isinstance(error, MemoryError | RecursionError):
        return "needs more memory than is allowed"
    return f"cannot be worked out: {type(error).__name__}"
