"""`radartrack verify`: how well each generated function is known to be right."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from difflib import get_close_matches
from enum import StrEnum
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer
from rich.progress import BarColumn, MofNCompleteColumn, TextColumn, TimeElapsedColumn, TimeRemainingColumn

from radartrack._system import output_files, terminal
from radartrack._system.progress import progress_on_terminals
from radartrack._system.termination import exit_code
from radartrack.commands.model_file import ModelFile, NoModel, load_models

if TYPE_CHECKING:
    from radartrack.derive.language.quantity import Quantity
    from radartrack.verification.campaign import Campaign
    from radartrack.verification.engines import Engine
    from radartrack.verification.own_models import OwnModels

CHECKPOINT = "radartrack-verify.jsonl"
PLAIN_WIDTH = 140  # in a file or a pipe
PATHS = {
    "function": "f",
    "arrays": "a",
    "one plot": "1",
    "machine code": "m",
    "C": "c",
    "C single": "s",
}  # in the table


class Language(StrEnum):
    """Which code is verified."""

    NUMPY = "numpy"
    C = "c"


class EngineName(StrEnum):
    """Where the work is done."""

    LOCAL = "local"
    DASK = "dask"


def verify(  # noqa: PLR0913, PLR0917 - one argument an option
    names: Annotated[list[str] | None, typer.Argument(help="Quantities or parts of names; without any, all.")] = None,
    full: Annotated[bool, typer.Option("--full", help="100 000 points, 100 000 000 draws, and mutants.")] = False,
    draws: Annotated[int | None, typer.Option(help="Draws at each point of the simulation.", min=1)] = None,
    points: Annotated[int | None, typer.Option(help="Points compared with 50 digits.", min=20)] = None,
    mutants: Annotated[int | None, typer.Option(help="Mutants of each formula.", min=0)] = None,
    seed: Annotated[int, typer.Option(help="Of everything random.", min=0)] = 0,
    engine: Annotated[
        EngineName, typer.Option(help="Processes of this machine, or a Dask cluster.")
    ] = EngineName.LOCAL,
    scheduler: Annotated[str | None, typer.Option(help="Address of the Dask scheduler.")] = None,
    workers: Annotated[int | None, typer.Option(help="Local processes.", min=1)] = None,
    checkpoint: Annotated[
        Path | None,
        typer.Option(help="Kept while a run is not complete; the same run goes on from it.", show_default=CHECKPOINT),
    ] = None,
    model: ModelFile = None,
    language: Annotated[
        Language, typer.Option(help="NumPy as it is generated, or C99 as it would be, compiled here.")
    ] = Language.NUMPY,
    json_out: Annotated[Path | None, typer.Option("--json", help="Write the record here.")] = None,
    prove: Annotated[
        Path | None,
        typer.Option(help="Only look for proofs of rounding errors, and write the certificates of all functions here."),
    ] = None,
    worst: Annotated[
        Path | None,
        typer.Option(
            help="Only search for where rounding errors are worst, and write the points of all functions here."
        ),
    ] = None,
    plot: Annotated[
        Path | None,
        typer.Option(help="Only draw the rounding errors of one function over its domain, to this SVG or PNG."),
    ] = None,
) -> None:
    """Measure every layer of verification and show the worst function first.

    With --model, what is verified is the quantities of your models, whose code is derived first. With --language c
    it is the functions of C in double and single precision, which take a C compiler: cc, or what CC names.

    Exit 1 when a layer fails, 2 for names that fit nothing or what cannot be written, 130 when interrupted.
    """
    from dataclasses import replace

    from radartrack.derive.catalogue import catalogue
    from radartrack.verification.campaign import FULL, QUICK, Campaign, report
    from radartrack.verification.engines import Unreachable

    where = chosen_engine(engine, scheduler, workers)
    _refuse_without_compiler(language)
    declared = _declared(model)
    chosen = _chosen(names or [], declared.quantities or catalogue(), model)
    of_rounding = {"--prove": (prove, _prove), "--worst": (worst, _search), "--plot": (plot, _draw)}
    if _of_rounding_alone(of_rounding, chosen, {"--model": model, "--json": json_out}):
        return
    asked = {"draws": draws, "points": points, "mutants": mutants, "seed": seed}
    effort = replace(FULL if full else QUICK, **{k: v for k, v in asked.items() if v is not None})
    work = Campaign(chosen, effort, checkpoint or Path(CHECKPOINT), declared, language is Language.C)
    work = _with_checkpoint(work, asked_for=checkpoint is not None)
    output_files.refuse_unwritable({"--json": json_out}, kept=[path for path in (work.kept.path, model) if path])
    try:
        work.own = _written(declared, chosen, where)
        with _progress() as step:
            records = work.run(where, step)
    except KeyboardInterrupt as interrupt:
        if work.kept.path is not None and work.kept.done:
            terminal.complain(f"Interrupted; what was done stands in {work.kept.path}, and the same command goes on.")
        raise typer.Exit(exit_code(interrupt)) from None
    except Unreachable as error:
        terminal.complain(str(error))
        raise typer.Exit(2) from None
    try:
        if json_out is not None:
            output_files.write(json_out, output_files.json_text(report(records, effort)))
    finally:  # what was found is told in any case
        _show(records)
    work.kept.finish()
    if any(record["verdict"] == "failed" for record in records):
        raise typer.Exit(1)


def _of_rounding_alone(
    tasks: Mapping[str, tuple[Path | None, Callable[[Sequence[str], Path], None]]],
    chosen: Sequence[str],
    others: Mapping[str, Path | None],
) -> bool:
    """Do what is asked for of rounding errors alone; whether anything is.

    Raises:
        typer.BadParameter: for more than one of these, and for options that would do nothing beside one.
    """
    asked_for = [(option, path, task) for option, (path, task) in tasks.items() if path is not None]
    if len(asked_for) > 1:
        raise typer.BadParameter(f"{' and '.join(option for option, *_ in asked_for)} are done one at a time; give one")
    for option, path, task in asked_for:
        if idle := [other for other, given in others.items() if given is not None]:
            raise typer.BadParameter(f"{option} only looks at functions of the catalogue; leave {idle[0]} out")
        output_files.refuse_unwritable({option: path})
        task(chosen, path)
    return bool(asked_for)


def _prove(chosen: Sequence[str], path: Path) -> None:
    """Write the certificates that the package holds, with new ones of the chosen functions."""
    from radartrack._regeneration.accuracy import read_record
    from radartrack._regeneration.output_directory import source_directory
    from radartrack.derive.catalogue import catalogue
    from radartrack.verification.rounding.certificates import (
        BOXES,
        ENOUGH,
        SECONDS,
        certificate,
        kept,
        source_of,
        written,
    )

    rows, directory = kept(), source_directory()
    measured = read_record(directory) if directory is not None else {}
    with _progress() as step:
        for name in chosen:
            step(name, len(chosen))
            quantity, known = catalogue()[name], measured.get(name)
            enough = ENOUGH * max(known.ulp, 0.5) if known is not None else 0.0
            rows[name] = certificate(quantity, source_of(quantity), enough, BOXES, SECONDS)
    output_files.write(path, written(rows))


def _search(chosen: Sequence[str], path: Path) -> None:
    """Write the worst points that the package holds, with new ones of the chosen functions."""
    _refuse_without("flint", "--worst needs python-flint")
    from radartrack.derive.catalogue import catalogue
    from radartrack.verification.rounding.certificates import source_of
    from radartrack.verification.rounding.worst_points import kept, worst_point, written

    rows = kept()
    with _progress() as step:
        for name in chosen:
            step(name, len(chosen))
            rows[name] = worst_point(catalogue()[name], source_of(catalogue()[name]))
    output_files.write(path, written(rows))


def _draw(chosen: Sequence[str], path: Path) -> None:
    """Write the picture of one function.

    Raises:
        typer.BadParameter: for several functions, one without arguments, or another kind of file.
    """
    _refuse_without("matplotlib", "--plot needs the extra: pip install radartrack[plots]")
    from radartrack._reports.error_plot import error_plot
    from radartrack.derive.catalogue import catalogue
    from radartrack.verification.errors_over_domain import errors_over_domain
    from radartrack.verification.rounding.certificates import kept, proved_bounds

    kind = path.suffix.lower().removeprefix(".")
    if kind not in {"svg", "png"}:
        raise typer.BadParameter(f"--plot writes .svg or .png; given {path.name!r}")
    if len(chosen) != 1:
        raise typer.BadParameter(f"--plot draws one function; {len(chosen)} fit, such as {', '.join(chosen[:3])}")
    quantity = catalogue()[chosen[0]]
    if not quantity.symbols:
        raise typer.BadParameter(f"{quantity.name} has no arguments to draw its errors over")
    picture = error_plot(errors_over_domain(quantity), proved_bounds(kept().get(quantity.name, {})))
    output_files.write(path, picture.svg() if kind == "svg" else picture.png())
    terminal.say(picture.caption)


def _refuse_without(module: str, message: str) -> None:
    if find_spec(module) is None:
        terminal.complain(message)
        raise typer.Exit(2)


def _refuse_without_compiler(language: Language) -> None:
    from radartrack.verification.compiled_c import COMPILERS, compiler

    if language is Language.C and compiler() is None:
        terminal.complain(f"--language c needs a C compiler; there is no {', '.join(COMPILERS)}, nor what CC names.")
        raise typer.Exit(2)


def _with_checkpoint(work: Campaign, *, asked_for: bool) -> Campaign:
    """The same; without a checkpoint where its usual place cannot be written.

    Raises:
        typer.Exit: when the place that was asked for is not for a checkpoint.
    """
    from dataclasses import replace

    from radartrack.verification.checkpoint import NotACheckpoint

    try:
        problem = output_files.problem_with(work.kept.path) if work.kept.path else ""
    except (NotACheckpoint, OSError) as error:
        problem = str(error)
    if not problem:
        return work
    if asked_for:
        terminal.complain(f"--checkpoint must be a file for this run alone; {problem}")
        raise typer.Exit(2)
    terminal.complain(f"No checkpoint is kept; {problem}")
    return replace(work, checkpoint=None)


def _declared(path: Path | None) -> OwnModels:
    """The models of a file, without code.

    Raises:
        typer.Exit: when there is none in it.
    """
    from radartrack.derive.reading.symbol_table import TableError
    from radartrack.verification.own_models import NONE, OwnModels, tables_of

    if path is None:
        return NONE
    try:
        declared = OwnModels(tables_of(load_models(path)))
        _ = declared.quantities
    except (NoModel, TableError) as error:
        terminal.complain(str(error))
        raise typer.Exit(2) from None
    return declared


def _written(declared: OwnModels, names: Sequence[str], engine: Engine) -> OwnModels:
    """The same with the code of these quantities.

    Raises:
        typer.Exit: when one cannot be derived.
    """
    from radartrack.verification.own_models import NotWritten, written

    wanted = [name for name in names if name in declared.quantities]
    try:
        with _progress() as step:
            return written(declared, wanted, engine, step) if wanted else declared
    except NotWritten as error:
        terminal.complain(str(error))
        raise typer.Exit(2) from None


def _chosen(patterns: Sequence[str], quantities: Mapping[str, Quantity], model: Path | None) -> list[str]:
    """Names that are one of the patterns, or hold one; of the models in a file, where there is one."""
    known = list(quantities)
    found: dict[str, None] = {}
    for pattern in patterns:
        fitting = [pattern] if pattern in known else [name for name in known if pattern in name]
        if not fitting:
            close = get_close_matches(pattern, known, n=3, cutoff=0.5)
            hint = f"did you mean {' or '.join(close)}?" if close else "`radartrack list` shows all names"
            within = f" of {terminal.one_line(str(model))}" if model else ""
            raise typer.BadParameter(f"no quantity{within} is called {pattern!r}; {hint}")
        found |= dict.fromkeys(fitting)
    return list(found) if patterns else known


def chosen_engine(name: EngineName, scheduler: str | None, workers: int | None) -> Engine:
    """Who does the work.

    Raises:
        typer.BadParameter: for options that do not go together, and without what is needed.
    """
    from radartrack.verification.engines import Dask, Local

    if name is EngineName.LOCAL:
        if scheduler is not None:
            raise typer.BadParameter("--scheduler is for --engine dask")
        return Local(workers) if workers else Local.of_this_machine()
    if scheduler is None:
        raise typer.BadParameter("--engine dask needs --scheduler ADDRESS, such as tcp://host:8786")
    if find_spec("distributed") is None:
        raise typer.BadParameter("--engine dask needs the extra: pip install radartrack[dask]")
    return Dask(scheduler)


@contextmanager
def _progress() -> Iterator[Callable[[str, int], None]]:
    """A bar with the time left, on the error stream."""
    columns = (BarColumn(), MofNCompleteColumn(), TimeElapsedColumn(), TimeRemainingColumn())
    named = TextColumn("{task.description}")
    with progress_on_terminals(*columns, named) as progress:
        task = progress.add_task("", total=None)

        def step(description: str, total: int) -> None:
            progress.update(task, advance=1, total=total, description=description)

        yield step


def _badness(layer: Mapping[str, Any]) -> float:
    """The figure by its bound; infinite for a failure without one."""
    if layer["verdict"] == "failed":
        return float("inf") if not layer["bound"] else 1e6 + (layer["figure"] or 0.0) / layer["bound"]
    return (layer["figure"] or 0.0) / layer["bound"] if layer["bound"] else 0.0


def _show(records: Sequence[Mapping[str, Any]]) -> None:
    """One row a function, worst first, then what failed in words."""
    from rich.box import SIMPLE_HEAD
    from rich.table import Table

    console = terminal.console(PLAIN_WIDTH)
    records = terminal.shown(records)
    titles = [layer["layer"] for layer in records[0]["layers"]] if records else []
    table = Table(box=SIMPLE_HEAD, padding=(0, 1, 0, 0))
    table.add_column("function", overflow="fold")
    table.add_column("paths", no_wrap=True)
    for title in titles:
        table.add_column(title.replace(" ", "\n"), justify="right", no_wrap=True)
    for record in sorted(records, key=lambda r: -max(map(_badness, r["layers"]))):
        paths = "".join(PATHS[path] for path in record["paths"])
        table.add_row(record["quantity"], paths, *map(_cell, record["layers"]))
    console.print(table)
    covered = dict.fromkeys(path for record in records for path in record["paths"])
    console.print(f"Paths: {', '.join(f'{PATHS[path]} {path}' for path in covered)}.")
    for record in records:
        for layer in record["layers"]:
            if layer["verdict"] == "failed":
                words = f"{record['quantity']}, {layer['layer']}: {layer['detail']}"
                console.print(words, style="red", markup=False)
    failed = sum(record["verdict"] == "failed" for record in records)
    console.print(f"{terminal.counted(len(records), 'function')}, {failed} failed.")


def _cell(layer: Mapping[str, Any]) -> str:
    if layer["verdict"] == "not applicable":
        return "–"
    figure = "" if layer["figure"] is None else f"{layer['figure']:.2g}"
    return f"[bold red]✗ {figure}[/]" if layer["verdict"] == "failed" else figure
