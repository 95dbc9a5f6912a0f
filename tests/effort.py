"""Limits of processor time that only work without end exceeds: they grow with what a fixed piece of work takes."""

from collections.abc import Iterator
from contextlib import contextmanager
from time import thread_time

USUAL = 0.01  # seconds that the fixed piece of work takes where a limit holds as it is written

# What such a test is for grows with a power or without end and takes minutes; what is right takes a twentieth of
# the limit. Between the two lies every machine: other threads are not counted, a slow one is allowed more.
ALLOWANCE = 20


@contextmanager
def at_most(seconds: float) -> Iterator[None]:
    """Fail where the block takes this thread far more than so many seconds of a usual machine."""
    start = thread_time()
    yield
    spent = thread_time() - start
    assert spent < ALLOWANCE * seconds or spent < ALLOWANCE * seconds * slowness()


def slowness() -> float:
    """How many times as long as usual the fixed piece of work takes now."""
    start = thread_time()
    sorted(str(n)[::-1] for n in range(40_000))
    return (thread_time() - start) / USUAL
