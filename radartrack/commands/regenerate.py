"""`radartrack regenerate`: derive everything and write the generated code, or compare it with what is on disk."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, NoReturn

import typer
from rich.console import Console
from rich.progress import MofNCompleteColumn, Progress, SpinnerColumn, TextColumn, TimeElapsedColumn

if TYPE_CHECKING:
    from radartrack.derive.language.quantity import Quantity


def regenerate(
    check: Annotated[bool, typer.Option("--check", help="Write nothing; print how the disk differs.")] = False,
    out: Annotated[Path | None, typer.Option(help="Write here instead of the checkout's generated/.")] = None,
    model: Annotated[Path | None, typer.Option(help="Python file of your own that defines MODEL; wants --out.")] = None,
) -> None:
    """Derive everything and write generated/ and the formula book; with --check, exit 1 where they differ from that."""
    from radartrack._regeneration import regeneration
    from radartrack.derive.language.stable_form import NotProved

    directory = _directory(out, model)
    quantities = _quantities(model)
    try:
        with _progress(len(quantities)) as step:
            derivation = regeneration.derive(quantities, step)
            functions = derivation.functions
            known = regeneration.read_record(directory)
            measured = regeneration.as_recorded(functions, known)
            if not check:
                measured = regeneration.with_measured(functions, known, step)
    except NotProved as error:
        typer.echo(f"Nothing was written: {error}", err=True)
        raise typer.Exit(1) from None
    files = regeneration.texts(derivation, measured)
    found = [difference for difference in regeneration.differences(directory, files) if difference]
    if check:
        _report(found, directory)
    elif found:
        for orphan in regeneration.orphans(directory, files):
            typer.echo(f"{orphan}: no derivation owns this file; removed", err=True)
        regeneration.write(directory, files)
    typer.echo(f"{len(functions)} functions {'written to' if found else 'derived, as they stand in'} {directory}")


def _directory(out: Path | None, model: Path | None) -> Path:
    """Where the modules go.

    Raises:
        typer.Exit: when that is not said, or is a place with files that no derivation wrote.
    """
    from radartrack._regeneration import regeneration

    if out is None:
        source = None if model else regeneration.source_directory()
        if source is None:
            reason = "A model of your own" if model else "This is no source checkout and"
            _refuse(f"{reason} wants --out DIR, the directory for the generated modules.")
        return source
    if out.exists() and not out.is_dir():
        _refuse(f"--out must be a directory; {out} is a file.")
    if not regeneration.is_ours(out):
        _refuse(f"--out must be new, empty or written by this command; {out} holds other files.")
    return out


def _quantities(model: Path | None) -> Mapping[str, Quantity]:
    from radartrack._regeneration import regeneration
    from radartrack.derive.catalogue import catalogue
    from radartrack.derive.moments.conversion_quantities import quantities_of

    if model is None:
        return catalogue()
    try:
        return {quantity.name: quantity for quantity in quantities_of(regeneration.load_model(model))}
    except regeneration.NoModel as error:
        return _refuse(str(error))


def _refuse(reason: str) -> NoReturn:
    typer.echo(reason, err=True)
    raise typer.Exit(2)


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
