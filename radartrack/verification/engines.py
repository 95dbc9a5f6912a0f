"""Where work is done: in this process, in processes of this machine, or on a Dask cluster."""

from __future__ import annotations

import multiprocessing
import os
import signal
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import FIRST_COMPLETED, Future, ProcessPoolExecutor, wait
from dataclasses import dataclass
from importlib import import_module
from itertools import islice
from typing import Any, Protocol

Task = Callable[[], Any]
AHEAD = 3  # tasks per worker that wait for their turn; the rest is not made before it is needed


class Engine(Protocol):
    """Runs tasks and yields the number of each with its result, in whatever order they end."""

    def run(self, tasks: Iterable[tuple[int, Task]]) -> Iterator[tuple[int, Any]]:
        """Every task once; an exception of a task is raised here."""
        ...


@dataclass(frozen=True)
class Local:
    """Processes of this machine.

    Attributes:
        workers: how many; with one, everything runs in this process.
    """

    workers: int

    @classmethod
    def of_this_machine(cls) -> Local:
        """One for each processor that this process may use."""
        return cls(len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1)

    def run(self, tasks: Iterable[tuple[int, Task]]) -> Iterator[tuple[int, Any]]:
        """Every task once."""
        if self.workers == 1:
            for number, task in tasks:
                yield number, task()
            return
        available = multiprocessing.get_all_start_methods()
        context = multiprocessing.get_context("forkserver" if "forkserver" in available else "spawn")
        pool = ProcessPoolExecutor(self.workers, context, initializer=_left_to_the_parent)
        try:
            yield from _in_flight(pool, iter(tasks), AHEAD * self.workers)
        finally:
            pool.shutdown(wait=True, cancel_futures=True)


def _left_to_the_parent() -> None:
    """Ctrl-C reaches all processes of a terminal; the parent alone decides what it means."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)


def _in_flight(pool: ProcessPoolExecutor, tasks: Iterator[tuple[int, Task]], most: int) -> Iterator[tuple[int, Any]]:
    pending: dict[Future[Any], int] = {}
    while True:
        for number, task in islice(tasks, most - len(pending)):
            pending[pool.submit(task)] = number
        if not pending:
            return
        done, _ = wait(pending, return_when=FIRST_COMPLETED)
        for future in done:
            yield pending.pop(future), future.result()


@dataclass(frozen=True)
class Dask:
    """A Dask cluster; what a lost worker was doing is done again by another.

    Attributes:
        scheduler: its address, such as tcp://host:8786.
    """

    scheduler: str

    def run(self, tasks: Iterable[tuple[int, Task]]) -> Iterator[tuple[int, Any]]:
        """Every task once."""
        distributed: Any = import_module("distributed")  # an optional extra
        source = iter(tasks)
        with distributed.Client(self.scheduler, set_as_default=False) as client:
            threads = sum(client.nthreads().values()) or 1
            numbers: dict[str, int] = {}

            def submitted(number: int, task: Task) -> Any:
                future = client.submit(task, key=f"{client.id}-{number}")
                numbers[future.key] = number
                return future

            first = [submitted(*each) for each in islice(source, AHEAD * threads)]
            running = distributed.as_completed(first, loop=client.loop)
            for future in running:
                yield numbers.pop(future.key), future.result()
                for each in islice(source, 1):
                    running.add(submitted(*each))
