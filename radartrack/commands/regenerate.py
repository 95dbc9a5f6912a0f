"""`radartrack regenerate`: derive everything and write the generated code, or compare it with what is on disk."""

from __future__ import annotations

import os
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping
from contextlib import contextmanager
from enum import StrEnum
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, NoReturn

import typer
from rich.progress import MofNCompleteColumn, SpinnerColumn, TextColumn, TimeElapsedColumn

from radartrack._system import output_files, terminal
from radartrack._system.progress import progress_on_terminals
from radartrack.commands.model_file import ModelFile, own_quantities

if TYPE_CHECKING:
    from radartrack.derive.language.quantity import Quantity


class Language(StrEnum):
    """What is written."""

    NUMPY = "numpy"
    C = "c"


SIGN = {Language.NUMPY: "__init__.py", Language.C: "radartrack.h"}  # by which a directory of each is known


def regenerate(
    check: Annotated[bool, typer.Option("--check", help="Write nothing; print how the disk differs.")] = False,
    out: Annotated[Path | None, typer.Option(help="Write here instead of the checkout's generated/.")] = None,
    model: ModelFile = None,
    language: Annotated[Language, typer.Option(help="NumPy modules, or C99 headers.")] = Language.NUMPY,
) -> None:
    """Derive everything and write generated/ and the formula book; with --check, exit 1 where they differ from that.

    With --model, what is derived is your models alone, and it wants --out; so does --language c.
    """
    from radartrack._regeneration import accuracy, output_directory
    from radartrack._regeneration.deriving import NotDerived
    from radartrack._regeneration.measuring import with_measured
    from radartrack.derive.language.stable_form import NotProved

    directory = _directory(out, model, language)
    quantities = _quantities(model)
    target = _target(language)
    if not check:
        _refuse_unwritable(directory, target.names(quantities))
    try:
        with _progress(len(quantities)) as step:
            derivation = target.derive(quantities, step)
            functions = derivation.functions
            known = accuracy.read_records(directory, quantities)
            measured = accuracy.as_recorded(functions, known)
            if not check:
                measured = with_measured(functions, known, step)
        files = target.texts(derivation, measured)
    except NotDerived as error:
        _refuse(f"Nothing was written: {error}")
    except NotProved as error:
        terminal.complain(f"Nothing was written: {error}")
        raise typer.Exit(2 if model else 1) from None
    found = [difference for difference in output_directory.differences(directory, files) if difference]
    if check:
        _report(found, directory)
    elif found:
        _write(directory, files)
    _tell_kept(output_directory.kept(directory, files))
    done = "written to" if found else "derived, as they stand in"
    terminal.say(f"{terminal.counted(len(functions), 'function')} {done} {terminal.one_line(str(directory))}")


def _target(language: Language) -> Any:
    """The module that names, derives and writes the files of a language."""
    from radartrack._regeneration import c_headers, numpy_modules

    return c_headers if language is Language.C else numpy_modules


def _directory(out: Path | None, model: Path | None, language: Language) -> Path:
    """Where the modules or headers go.

    Raises:
        typer.Exit: when that is not said, or is a place with files that no derivation wrote.
    """
    from radartrack._regeneration import output_directory

    if out is None and language is Language.C:
        _refuse("--language c wants --out DIR, the directory for the headers.")
    if out is None:
        source = None if model else output_directory.source_directory()
        if source is None:
            reason = "A model of your own" if model else "This is no source checkout and"
            _refuse(f"{reason} wants --out DIR, the directory for the generated modules.")
        return source
    if os.path.lexists(os.path.realpath(out)) and not out.is_dir():
        _refuse(f"--out must be a directory; {out} is a file.")
    if not output_directory.may_be_written(out):
        _refuse(f"--out must be new, empty or written by this command; {out} holds other files.")
    found = output_directory.owners(out)
    for other in Language:
        if other is not language and SIGN[other] in found.ours | found.edited:
            _refuse(f"--out must be a directory for --language {language} alone; {out} is one of --language {other}.")
    return out


def _refuse_unwritable(directory: Path, names: Collection[str]) -> None:
    """The directory is written beside and put in place, so it is the place around it that must take files."""
    from radartrack._regeneration import output_directory

    if others := output_directory.in_the_way(directory, names):
        _refuse(f"--out: {directory / others[0]} is in the way, and was not written by this command.")
    if problem := output_files.problem_around(directory):
        _refuse(f"--out must be a directory that can be written; {problem}")


def _write(directory: Path, files: dict[str, str]) -> None:
    from radartrack._regeneration import output_directory

    edited, orphans = output_directory.edited(directory, files), output_directory.orphans(directory, files)
    aside = output_directory.write(directory, files)
    for name in edited:
        terminal.complain(f"{name}: edited since it was written; what was there is kept in {aside}")
    for orphan in orphans:
        terminal.complain(f"{orphan}: no derivation owns this file; removed")


def _tell_kept(names: Iterable[str]) -> None:
    for name in names:
        terminal.complain(f"{name}: no derivation owns this file; kept")


def _quantities(model: Path | None) -> Mapping[str, Quantity]:
    from radartrack.derive.catalogue import catalogue

    return catalogue() if model is None else own_quantities(model)


def _refuse(reason: str) -> NoReturn:
    terminal.complain(reason)
    raise typer.Exit(2)


def _report(found: list[str], directory: Path) -> None:
    for difference in found:
        terminal.say(difference)
    if found:
        terminal.complain(f"{directory} is not what the derivations give: {len(found)} files differ.")
        raise typer.Exit(1)


@contextmanager
def _progress(total: int) -> Iterator[Callable[[str], None]]:
    """A bar on the error stream; each step names what is being worked on."""
    columns = (SpinnerColumn(), MofNCompleteColumn(), TimeElapsedColumn(), TextColumn("{task.description}"))
    with progress_on_terminals(*columns) as progress:
        task = progress.add_task("", total=total)

        def step(description: str) -> None:
            progress.update(task, advance=1, description=description)

        yield step
