"""Large arrays in blocks that stay in the cache, on all cores.

NumPy computes a long formula step by step; over a block every intermediate result stays in the cache, over millions of
entries each travels to memory and back. NumPy and compiled loops release the interpreter, so blocks run side by side.
Every entry is computed alone: how the entries are divided changes no bit.
"""

import math
import os
from collections.abc import Callable, Sequence
from functools import cache
from typing import TYPE_CHECKING, Any

from numpy.typing import NDArray

from radartrack._arrays.validation import RealArray

if TYPE_CHECKING:
    from concurrent.futures import Future, ThreadPoolExecutor

BLOCK = 32768  # entries; few enough to stay in the cache, enough that threads seldom wait for the interpreter
MOST_THREADS = 8  # each has intermediate results of its own, and all wait for one interpreter

Fill = Callable[..., None]


def fill(function: Fill, inputs: Sequence[NDArray[Any]], outputs: Sequence[RealArray], block: int = BLOCK) -> None:
    """Call `function(*inputs, *outputs)` for each block of entries; once where there are none.

    Args:
        function: fills the outputs it is handed from inputs of the same length.
        inputs: of shape (n, ...).
        outputs: of shape (n, ...).
        block: entries in a block at most; a quarter of them is worth a thread's while, and all threads have
            as many blocks.

    """
    size = len(outputs[0])
    threads = max(min(_most_at_once(), 4 * size // block), 1)
    count = threads * max(math.ceil(size / block / threads), 1)

    def fill_block(number: int) -> None:
        part = slice(size * number // count, size * (number + 1) // count)
        function(*(array[part] for array in (*inputs, *outputs)))

    if count == 1:
        function(*inputs, *outputs)
    else:
        _side_by_side(fill_block, range(count))


def _side_by_side(work: Callable[[int], None], items: Sequence[int]) -> None:
    """On all cores, this thread's among them; each takes the next item when it is ready for it.

    What is under way is waited for, whoever does it: an executor that is refused a new thread says so after an older
    one may have begun.
    """
    from threading import Condition  # noqa: PLC0415 - it costs more to load than small arrays do

    waiting, turn = iter(items), Condition()
    under_way: list[int] = []
    failures: list[BaseException] = []

    def run() -> None:
        while (item := taken()) is not None:
            try:
                work(item)
            except BaseException as error:  # noqa: BLE001 - raised below, where the result is waited for
                failures.append(error)
            finally:
                with turn:
                    under_way.remove(item)
                    turn.notify_all()

    def taken() -> int | None:
        with turn:
            item = None if failures else next(waiting, None)
            if item is not None:
                under_way.append(item)
            return item

    others = _helped(run, min(_most_at_once(), len(items)) - 1)
    run()
    with turn:
        turn.wait_for(lambda: not under_way)
    for other in others:
        other.cancel()  # what has not begun is not needed
    if failures:
        raise failures.pop(0)


def _helped(run: Callable[[], None], most: int) -> "list[Future[None]]":
    """As many threads as there are to be had, each about to run it; this thread does what is left undone."""
    helpers: list[Future[None]] = []
    try:
        for _ in range(most):
            helpers.append(_threads().submit(run))  # noqa: PERF401 - those before the one that is refused count
    except RuntimeError:  # the main thread has ended, whereafter no thread is given work, or the system has no more
        pass
    return helpers


@cache
def _threads() -> "ThreadPoolExecutor":
    """Kept: to start a thread takes longer than a block of a short formula."""
    from concurrent.futures import ThreadPoolExecutor  # noqa: PLC0415 - it costs more to load than small arrays do

    return ThreadPoolExecutor(MOST_THREADS, "radartrack")


if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_threads.cache_clear)  # threads do not come along


def _most_at_once() -> int:
    """A thread for each core that this process may use."""
    cores = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
    return min(cores, MOST_THREADS)
