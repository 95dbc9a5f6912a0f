"""Where work is done: in this process, in processes of this machine, or on a Dask cluster."""

from __future__ import annotations

import logging
import multiprocessing
import os
from collections.abc import Callable, Generator, Iterable, Iterator
from concurrent.futures import FIRST_COMPLETED, CancelledError, Executor, Future, wait
from dataclasses import dataclass
from importlib import import_module
from itertools import islice
from typing import Any, Protocol, TypeAlias

from radartrack._system.worker_processes import Workers, ended_on_failure, serve

Task = Callable[[], Any]
Results: TypeAlias = Generator[tuple[int, Any], None, None]
AHEAD = 3  # tasks per worker that wait for their turn; the rest is not made before it is needed
PATIENCE = 10  # seconds for a scheduler to answer


class Unreachable(RuntimeError):
    """Who was to do the work cannot be reached."""


class Engine(Protocol):
    """Runs tasks and yields the number of each with its result, in whatever order they end."""

    def run(self, tasks: Iterable[tuple[int, Task]]) -> Results:
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

    def run(self, tasks: Iterable[tuple[int, Task]]) -> Results:
        """Every task once."""
        if self.workers == 1:
            for number, task in tasks:
                yield number, task()
            return
        available = multiprocessing.get_all_start_methods()
        context = multiprocessing.get_context("forkserver" if "forkserver" in available else "spawn")
        with ended_on_failure(Workers(self.workers, context, initializer=serve)) as pool:
            yield from _in_flight(pool, iter(tasks), AHEAD * self.workers)


def _in_flight(pool: Executor, tasks: Iterator[tuple[int, Task]], most: int) -> Results:
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

    def run(self, tasks: Iterable[tuple[int, Task]]) -> Results:
        """Every task once.

        Raises:
            Unreachable: when the scheduler does not answer, or no longer.
        """
        source = iter(tasks)
        distributed: Any = import_module("distributed")  # an optional extra
        with self._client(distributed) as client:
            threads = sum(client.nthreads().values()) or 1
            numbers: dict[str, int] = {}

            def submitted(number: int, task: Task) -> Any:
                future = client.submit(task, key=f"{client.id}-{number}")
                numbers[future.key] = number
                return future

            first = [submitted(*each) for each in islice(source, AHEAD * threads)]
            running = distributed.as_completed(first, loop=client.loop)
            for future in running:
                try:
                    result = future.result()
                except CancelledError:
                    raise Unreachable(f"the Dask scheduler {self.scheduler} no longer answers") from None
                yield numbers.pop(future.key), result
                for each in islice(source, 1):
                    running.add(submitted(*each))

    def _client(self, distributed: Any) -> Any:
        """A connection; while it is made, what distributed logs of its attempts is the same as what it raises."""
        before = logging.root.manager.disable
        logging.disable(logging.CRITICAL)
        try:
            distributed.comm.resolve_address(self.scheduler)
            return distributed.Client(self.scheduler, timeout=PATIENCE, set_as_default=False)
        except (OSError, OverflowError, ValueError) as error:
            raise Unreachable(f"the Dask scheduler {self.scheduler!r} cannot be reached: {error}") from None
        finally:
            logging.disable(before)
