"""Many files of plots into a directory that is complete or not there, by whoever does the work."""

from __future__ import annotations

import secrets
from collections.abc import Callable, Sequence
from contextlib import closing
from dataclasses import dataclass
from pathlib import Path

from radartrack._system.directory_swap import replace_directory, replace_file_by
from radartrack.tables.parquet_stream import Outcome, convert_file
from radartrack.tables.plot_columns import PlotColumns
from radartrack.verification.engines import Engine

PART = ".part-"  # what a task writes before it is complete; one that was lost leaves it behind

Step = Callable[[int], None]


@dataclass(frozen=True)
class Conversion:
    """A task: one file.

    Attributes:
        source: what is read.
        target: what is there when the task has ended, and not before.
        chosen: where the arguments are found.
    """

    source: Path
    target: Path
    chosen: PlotColumns

    def __call__(self, step: Step = lambda _: None) -> Outcome:
        """Convert it; a second run of a task, whose worker was lost or is late, does not meet the first."""
        part = self.target.with_name(f"{PART}{secrets.token_hex(8)}")  # no longer than a name may be
        try:
            outcome = convert_file(self.source, part, self.chosen, step)
            part.replace(self.target)
        finally:
            part.unlink(missing_ok=True)
        return outcome


def one_file(source: Path, target: Path, chosen: PlotColumns, engine: Engine | None, step: Step) -> Outcome:
    """Convert a file; without an engine here."""
    outcomes: list[Outcome] = []

    def write(new: Path) -> None:
        task = Conversion(source.resolve(), new, chosen)
        outcomes.extend([task(step)] if engine is None else _run(engine, [task], step).values())

    replace_file_by(target, write)
    return outcomes[0]


def many_files(
    sources: Sequence[Path], directory: Path, chosen: PlotColumns, engine: Engine | None, step: Step
) -> dict[Path, Outcome]:
    """Convert files into a new directory, in which they keep their names; what it is to be in is made."""
    outcomes: dict[Path, Outcome] = {}

    def write(new: Path) -> None:
        tasks = [Conversion(source.resolve(), new / source.name, chosen) for source in sources]
        done = {n: task(step) for n, task in enumerate(tasks)} if engine is None else _run(engine, tasks, step)
        outcomes.update({sources[n]: outcome for n, outcome in sorted(done.items())})
        names = {task.target.name for task in tasks}
        for left in [path for path in new.iterdir() if path.name not in names]:
            left.unlink(missing_ok=True)

    directory.resolve().parent.mkdir(parents=True, exist_ok=True)
    replace_directory(directory, write)
    return outcomes


def _run(engine: Engine, tasks: Sequence[Conversion], step: Step) -> dict[int, Outcome]:
    found: dict[int, Outcome] = {}
    with closing(engine.run(enumerate(tasks))) as results:
        for number, outcome in results:
            found[number] = outcome
            step(outcome.rows)
    return found
