"""Large arrays in blocks that stay in the cache, on all cores.

NumPy computes a long formula step by step; over a block every intermediate result stays in the cache, over millions of
entries each travels to memory and back. NumPy and compiled loops release the interpreter, so blocks run side by side.
Every entry is computed alone: how the entries are divided changes no bit.
"""

import os
from collections.abc import Callable, Sequence

from radartrack.validation import RealArray

BLOCK = 16384  # entries; the intermediate results of a formula then fit into the cache of a core
THREADED_FROM = 65536  # entries; below, threads cost more than they save

Fill = Callable[..., None]


def fill(function: Fill, inputs: Sequence[RealArray], outputs: Sequence[RealArray]) -> None:
    """Call `function(*inputs, *outputs)` for each block of entries.

    Args:
        function: fills the outputs it is handed from inputs of the same length.
        inputs: of shape (n,), or () for what all entries share.
        outputs: of shape (n, ...).

    """
    size = len(outputs[0])

    def fill_block(start: int) -> None:
        block = slice(start, start + BLOCK)
        function(*(array[block] if array.ndim else array for array in inputs), *(array[block] for array in outputs))

    starts = range(0, size, BLOCK)
    if size < THREADED_FROM:
        for start in starts:
            fill_block(start)
    else:
        from concurrent.futures import ThreadPoolExecutor  # noqa: PLC0415 - it costs more to load than small arrays do

        with ThreadPoolExecutor(_cores()) as pool:
            list(pool.map(fill_block, starts))


def _cores() -> int:
    """The cores that this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
