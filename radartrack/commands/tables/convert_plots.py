"""`radartrack convert`: Parquet files of plots, each row with its Cartesian mean and covariance."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from enum import StrEnum
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, NoReturn

import typer
from rich.progress import BarColumn, TextColumn, TimeElapsedColumn, TimeRemainingColumn

from radartrack._system import output_files, terminal
from radartrack._system.progress import progress_on_terminals
from radartrack.commands.pairs import pairs
from radartrack.commands.verify import EngineName, chosen_engine

if TYPE_CHECKING:
    from radartrack.tables.parquet_stream import Outcome
    from radartrack.tables.plot_columns import PlotColumns

TOLD = 5  # bad rows of a file that are shown


class BadRowsOption(StrEnum):
    """What becomes of rows that cannot be converted."""

    RAISE = "raise"
    MARK = "mark"


def convert(
    files: Annotated[
        list[Path], typer.Argument(exists=True, dir_okay=False, help="Parquet files of plots.", show_default=False)
    ],
    sensor: Annotated[str, typer.Option(help="A conversion: polar, spherical, polar_doppler, …")] = "polar",
    out: Annotated[
        Path | None, typer.Option(help="The new file; of several files, their directory.", show_default=False)
    ] = None,
    column: Annotated[
        list[str] | None, typer.Option(help="ARGUMENT=COLUMN, such as r=slant_range; without, its own name.")
    ] = None,
    constant: Annotated[
        list[str] | None, typer.Option(help="ARGUMENT=NUMBER for all rows, such as range_std=50.")
    ] = None,
    unit: Annotated[list[str] | None, typer.Option(help="ARGUMENT=UNIT, such as azimuth=deg or r=nmi.")] = None,
    method: Annotated[str, typer.Option(help="linear, second_order, averaged, unbiased or posterior.")] = "unbiased",
    azimuth_from: Annotated[str | None, typer.Option(help="x, counter-clockwise, or y, clockwise.")] = None,
    bad_rows: Annotated[
        BadRowsOption, typer.Option(help="End at rows that cannot be converted, or mark them.")
    ] = BadRowsOption.RAISE,
    prefix: Annotated[str, typer.Option(help="Before the names of the new columns.")] = "",
    engine: Annotated[EngineName, typer.Option(help="This machine, or a Dask cluster.")] = EngineName.LOCAL,
    scheduler: Annotated[str | None, typer.Option(help="Address of the Dask scheduler.")] = None,
) -> None:
    """Convert plots in Parquet files, larger than memory or many of them, to Cartesian means and covariances.

    Exit 1 for rows that cannot be converted, 2 for what cannot be read or written; then nothing is written.
    """
    if find_spec("pyarrow") is None:
        _refuse("convert reads Parquet and needs the extra: pip install radartrack[tables]")
    chosen = _chosen(sensor, column or [], constant or [], unit or [], method, azimuth_from, bad_rows, prefix)
    where = None if engine is EngineName.LOCAL else chosen_engine(engine, scheduler, None)
    if engine is EngineName.LOCAL and scheduler is not None:
        raise typer.BadParameter("--scheduler is for --engine dask")
    target = _target(files, out)
    total = _rows(files)
    outcomes = _converted(files, target, chosen, where, total)
    _show(outcomes, target)


def _chosen(
    sensor: str,
    column: list[str],
    constant: list[str],
    unit: list[str],
    method: str,
    azimuth_from: str | None,
    bad_rows: str,
    prefix: str,
) -> PlotColumns:
    from radartrack.tables.plot_columns import PlotColumns

    named: dict[str, Any] = pairs(column, "--column", "ARGUMENT=COLUMN, such as r=slant_range")
    numbers = pairs(constant, "--constant", "ARGUMENT=NUMBER, such as range_std=50")
    units = pairs(unit, "--unit", "ARGUMENT=UNIT, such as azimuth=deg")
    for name, text in numbers.items():
        if name in named:
            raise typer.BadParameter(f"{name} is given by --column and by --constant")
        try:
            named[name] = float(text)
        except ValueError:
            raise typer.BadParameter(f"{name} must be a number; got {text!r}", param_hint="--constant") from None
    words: Any = (sensor, named, units, method, azimuth_from, bad_rows, prefix)
    try:
        return PlotColumns.chosen(*words)
    except (ImportError, TypeError, ValueError) as error:
        _refuse(str(error))


def _target(files: Sequence[Path], out: Path | None) -> Path:
    """Where the result goes; refused before anything is read."""
    if len(files) == 1:
        target = out or files[0].with_name(f"{files[0].stem}-converted.parquet")
        output_files.refuse_unwritable({"--out": target}, kept=files)
        return target
    if out is None:
        raise typer.BadParameter("several files need --out DIRECTORY")
    if twice := [name for name, count in Counter(file.name for file in files).items() if count > 1]:
        raise typer.BadParameter(f"files must have different names, which they keep; {twice[0]} is there twice")
    problem = output_files.problem_around(out)
    if not problem and out.exists() and (not out.is_dir() or any(out.iterdir())):
        problem = f"{out} holds something"
    if problem:
        _refuse(f"--out must be a directory that is empty or not there yet; {problem}")
    return out


def _rows(files: Sequence[Path]) -> int:
    from radartrack.tables.parquet_stream import NoPlots, rows_of

    try:
        return sum(map(rows_of, files))
    except NoPlots as error:
        _refuse(str(error))


def _converted(
    files: Sequence[Path], target: Path, chosen: PlotColumns, engine: Any, total: int
) -> Mapping[Path, Outcome]:
    from radartrack.commands.tables.plot_files import many_files, one_file
    from radartrack.tables.bad_rows import BadRows
    from radartrack.tables.parquet_stream import NoPlots
    from radartrack.verification.engines import Unreachable

    try:
        with _progress(total) as step:
            if len(files) == 1:
                return {files[0]: one_file(files[0], target, chosen, engine, step)}
            return many_files(files, target, chosen, engine, step)
    except BadRows as error:
        terminal.complain(f"{error}. Nothing is written; --bad-rows mark keeps such rows and says what is wrong.")
        raise typer.Exit(1) from None
    except (NoPlots, Unreachable) as error:
        _refuse(str(error))


@contextmanager
def _progress(total: int) -> Iterator[Callable[[int], None]]:
    """A bar with rows, speed and the time left, on the error stream."""
    columns = (
        BarColumn(),
        TextColumn("{task.completed:,.0f} of {task.total:,.0f} plots"),
        TextColumn("{task.fields[speed]}"),
        TimeElapsedColumn(),
        TimeRemainingColumn(),
    )
    with progress_on_terminals(*columns) as progress:
        task = progress.add_task("", total=total, speed="")

        def step(rows: int) -> None:
            speed = progress.tasks[0].speed
            progress.update(task, advance=rows, speed=f"{speed / 1e6:.2f} million a second" if speed else "")

        yield step


def _show(outcomes: Mapping[Path, Outcome], target: Path) -> None:
    rows = sum(outcome.rows for outcome in outcomes.values())
    bad = sum(outcome.bad for outcome in outcomes.values())
    terminal.say(f"{rows:,} plots converted, in {terminal.one_line(str(target))}")
    if bad:
        terminal.say(f"{bad:,} of them could not be, and are marked:")
    for file, outcome in outcomes.items():
        for row, problem in list(outcome.told.items())[:TOLD]:
            terminal.say(terminal.one_line(f"  {file.name}, row {row}: {problem}"))
        if outcome.bad > TOLD:
            terminal.say(f"  {terminal.one_line(file.name)}: and {outcome.bad - TOLD:,} more")


def _refuse(reason: str) -> NoReturn:
    terminal.complain(reason)
    raise typer.Exit(2)
