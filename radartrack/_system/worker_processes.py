"""Pools of processes that end with the process that they work for, and leave Ctrl-C to it."""

from __future__ import annotations

import multiprocessing
import os
import signal
import threading
import time
from collections.abc import Callable, Iterator
from concurrent.futures import Future, ProcessPoolExecutor
from contextlib import contextmanager
from typing import Any


class Workers(ProcessPoolExecutor):
    """A pool whose processes never see Ctrl-C, not even while they start; their initializer is `serve`, or calls it."""

    def submit(self, function: Callable[..., Any], /, *args: Any, **kwargs: Any) -> Future[Any]:
        """Submit a task; processes that are started for it inherit that an interrupt is held back."""
        with _interrupts_held():
            return super().submit(function, *args, **kwargs)

    def end(self) -> None:
        """End the processes, whatever they do; what waits is not done."""
        processes = list((self._processes or {}).values())
        manager = self._executor_manager_thread
        self.shutdown(wait=False, cancel_futures=True)
        if manager is not None:
            _wait_until_forgotten(manager)
        for process in processes:
            process.terminate()


def _wait_until_forgotten(manager: Any) -> None:
    """Wait for a pool's thread to drop what is cancelled; it stumbles over that where its processes end before."""
    for _ in range(1_000):
        waiting = [work.future for work in [*manager.pending_work_items.values()]]
        if not manager.is_alive() or not any(future.cancelled() for future in waiting):
            return
        time.sleep(1e-3)


@contextmanager
def ended_on_failure(workers: Workers) -> Iterator[Workers]:
    """Use a pool; where that fails or is interrupted, its processes are ended at once."""
    try:
        yield workers
    except BaseException:
        workers.end()
        raise
    workers.shutdown()


def serve() -> None:
    """Tell a process that it works for its parent: the parent decides what Ctrl-C means, and dies with its workers."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    signal.signal(signal.SIGTERM, signal.SIG_DFL)  # where it is a fork of a command
    threading.Thread(target=_end_with_the_parent, daemon=True).start()


def _end_with_the_parent() -> None:
    parent = multiprocessing.parent_process()
    if parent is not None:
        parent.join()
        os._exit(1)


@contextmanager
def _interrupts_held() -> Iterator[None]:
    if not hasattr(signal, "pthread_sigmask"):
        yield
        return
    before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)
