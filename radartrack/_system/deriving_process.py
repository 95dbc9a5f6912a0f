"""What a process that only derives is told before it imports SymPy, so this imports nothing of the derivations."""

import gc
import os

from radartrack._system.worker_processes import serve


def prepare() -> None:
    """It ends soon, with its parent at the latest, and what SymPy makes is kept: no search for garbage, much room."""
    serve()
    gc.disable()
    os.environ.setdefault("SYMPY_CACHE_SIZE", "10000")
