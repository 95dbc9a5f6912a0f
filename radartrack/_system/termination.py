"""A request to end (SIGTERM), obeyed as Ctrl-C is: workers are ended, files beside files removed, nothing is left."""

from __future__ import annotations

import signal
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from typing import NoReturn

INTERRUPTED = 128 + signal.SIGINT  # what shells say of a process that was ended so
TERMINATED = 128 + signal.SIGTERM


class Terminated(KeyboardInterrupt):
    """The process was asked to end."""


@contextmanager
def obeyed() -> Iterator[None]:
    """Raise `Terminated` where the process is asked to end and nobody has said what else is to be done then."""
    mine = threading.current_thread() is threading.main_thread() and (
        signal.getsignal(signal.SIGTERM) is signal.SIG_DFL
    )
    if mine:
        signal.signal(signal.SIGTERM, _end)
    try:
        yield
    finally:
        if mine:
            signal.signal(signal.SIGTERM, signal.SIG_DFL)


def exit_code(interrupt: KeyboardInterrupt) -> int:
    """What the process that was interrupted ends with."""
    return TERMINATED if isinstance(interrupt, Terminated) else INTERRUPTED


def _end(_number: int, _frame: object) -> NoReturn:
    raise Terminated
