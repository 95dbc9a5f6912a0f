"""`radartrack regenerate`: derive everything and write the generated code, or compare it with what is on disk."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Annotated

import typer
from rich.console import Console
from rich.progress import MofNCompleteColumn, Progress, SpinnerColumn, TextColumn, TimeElapsedColumn


def regenerate(
    check: Annotated[bool, typer.Option("--check", help="Write nothing; print how the disk differs.")] = False,
    out: Annotated[Path | None, typer.Option(help="Write here instead of the checkout's generated/.")] = None,
) -> None:
    """Derive everything and write generated/; with --check, exit 1 where it is not what the derivations give."""
    from radartrack import regeneration
    from radartrack.derive.catalogue import catalogue

    directory = out or regeneration.source_directory()
    if directory is None:
        typer.echo("This is no source checkout: say with --out where the generated modules shall go.", err=True)
        raise typer.Exit(2)
    if out is not None and out.exists() and not out.is_dir():
        typer.echo(f"--out must be a directory; {out} is a file.", err=True)
        raise typer.Exit(2)
    quantities = catalogue()
    with _progress(len(quantities)) as step:
        functions = regeneration.derive(quantities.values(), step)
        known = regeneration.read_record(directory)
        measured = regeneration.as_recorded(functions, known)
        if not check:
            measured = regeneration.with_measured(functions, known, step)
    files = regeneration.texts(functions, measured)
    found = [difference for difference in regeneration.differences(directory, files) if difference]
    if check:
        _report(found, directory)
    elif found:
        regeneration.write(directory, files)
    typer.echo(f"{len(functions)} functions {'written to' if found else 'derived, as they stand in'} {directory}")


def _report(found: list[str], directory: Path) -> None:
    for difference in found:
        typer.echo(difference)
    if found:
        typer.echo(f"{directory} is not what the derivations give: {len(found)} files differ.", err=True)
        raise typer.Exit(1)


@contextmanager
def _progress(total: int) -> Iterator[Callable[[str], None]]:
    """A bar on the error stream; each step names what is being worked on."""
    columns = (SpinnerColumn(), MofNCompleteColumn(), TimeElapsedColumn(), TextColumn("{task.description}"))
    with Progress(*columns, console=Console(stderr=True), transient=True) as progress:
        task = progress.add_task("", total=total)

        def step(description: str) -> None:
            progress.update(task, advance=1, description=description)

        yield step
