"""What a language writes of quantities: the catalogue in one process a core, a user's own models in this process."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from functools import partial
from multiprocessing import get_context
from typing import Any, NamedTuple

from radartrack._system.deriving_process import prepare
from radartrack._system.worker_processes import Workers, ended_on_failure
from radartrack.derive.catalogue import catalogue
from radartrack.derive.language.quantity import Quantity
from radartrack.derive.language.stable_form import NotProved
from radartrack.derive.writing.conversion_functions import conversions_of, covariance_of

CHUNK = 20  # neighbours in the catalogue share what they are derived from
Task = str | tuple[str, str]  # a quantity's name, or model and method of a conversion
Step = Callable[[str], None]


class Writer(NamedTuple):
    """How a language writes one quantity, and one conversion by model and method."""

    quantity: Callable[[Quantity], Any]
    conversion: Callable[[Mapping[str, Quantity], str, str], Any]


class NotDerived(ValueError):
    """A quantity has no code: what it holds cannot be rewritten, proved, written or measured."""


def worked_out(quantities: Mapping[str, Quantity], step: Step, writer: Writer) -> dict[Task, Any]:
    """What is written of each quantity and conversion.

    Those of the catalogue are derived in one process a core, a model of a user's own in this one.
    """
    tasks = _tasks(quantities)
    if quantities == catalogue():
        with ended_on_failure(Workers(mp_context=get_context("spawn"), initializer=prepare)) as pool:
            return _told(tasks, pool.map(partial(_of_catalogue, writer=writer), tasks, chunksize=CHUNK), step)
    return _told(tasks, (_done_or_refused(task, quantities, writer) for task in tasks), step)


def _tasks(quantities: Mapping[str, Quantity]) -> list[Task]:
    """Names of quantities, and each conversion behind the covariance that it shares most with."""
    tasks: list[Task] = list(quantities)
    for conversion in reversed(conversions_of(quantities)):
        tasks.insert(tasks.index(covariance_of(quantities, *conversion)) + 1, conversion)
    return tasks


def _of_catalogue(task: Task, writer: Writer) -> Any:
    return _done(task, catalogue(), writer)


def _done(task: Task, quantities: Mapping[str, Quantity], writer: Writer) -> Any:
    return writer.quantity(quantities[task]) if isinstance(task, str) else writer.conversion(quantities, *task)


def _done_or_refused(task: Task, quantities: Mapping[str, Quantity], writer: Writer) -> Any:
    """The code of one task of a model of a user's own.

    Raises:
        NotDerived: saying of which quantity, and why.
        NotProved: a rewritten form is not proved equal to its definition.
    """
    with _refusing(task if isinstance(task, str) else ".".join(task)):
        return _done(task, quantities, writer)


@contextmanager
def _refusing(name: str) -> Iterator[None]:
    """What goes wrong with a formula of a user's own, said of the quantity."""
    try:
        yield
    except NotProved:
        raise
    except (ArithmeticError, AssertionError, LookupError, RecursionError, TypeError, ValueError) as error:
        raise NotDerived(f"{name} cannot be derived: {on_one_line(error)}") from error


def on_one_line(said: object) -> str:
    """Text of a stranger's, without what a terminal would obey."""
    return "".join(c if c.isprintable() else " " for c in " ".join(str(said).split()))


def _told(tasks: Sequence[Task], done: Iterable[Any], step: Step) -> dict[Task, Any]:
    found = {}
    for task, result in zip(tasks, done, strict=True):
        if isinstance(task, str):
            step(task)
        found[task] = result
    return found
