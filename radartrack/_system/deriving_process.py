"""What a process that only derives is told before it imports SymPy, so this imports nothing of the derivations."""

import gc
import os


def prepare() -> None:
    """It ends soon, and what SymPy makes is kept: no search for garbage, and room for what a catalogue needs."""
    gc.disable()
    os.environ.setdefault("SYMPY_CACHE_SIZE", "10000")
