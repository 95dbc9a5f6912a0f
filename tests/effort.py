"""Limits of processor time that hold on slow machines too: they grow with what a fixed piece of work takes there."""

from collections.abc import Iterator
from contextlib import contextmanager
from time import process_time

USUAL = 0.01  # seconds that the fixed piece of work takes where a limit holds as it is written


@contextmanager
def at_most(seconds: float) -> Iterator[None]:
    """Fail where the block takes more time of this process's own than so many seconds of a usual machine."""
    start = process_time()
    yield
    spent = process_time() - start
    assert spent < seconds or spent < seconds * slowness()


def slowness() -> float:
    """How many times as long as usual the fixed piece of work takes now."""
    start = process_time()
    sorted(str(n)[::-1] for n in range(40_000))
    return (process_time() - start) / USUAL
