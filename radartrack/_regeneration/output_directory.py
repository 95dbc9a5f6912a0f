"""The directory that generated code is written to: whose its files are, what differs, and one step to replace it."""

from __future__ import annotations

import difflib
import errno
import importlib.util
import os
from collections.abc import Collection, Iterator
from pathlib import Path

from radartrack._system import written_files
from radartrack._system.directory_swap import replace_directory, replace_file
from radartrack._system.written_files import Owners

BOOK = "formulas.md"
Files = dict[str, str]


def source_directory() -> Path | None:
    """`generated/` of the source checkout that this package is imported from; None for an installed wheel."""
    folder = package()
    return folder if _is_of_checkout(folder) else None


def package() -> Path:
    """Where `radartrack.generated` is imported from."""
    here = importlib.util.find_spec("radartrack.generated")
    places = list(here.submodule_search_locations or ()) if here else []
    return Path(places[0]) if places else Path(__file__).with_name("generated")


def _is_of_checkout(folder: Path) -> bool:
    """Whether it is the one of this package, with its project around it; a user's own folder may be called the same."""
    own = Path(os.path.realpath(package()))
    of_checkout = own.name == "generated" and (own.parent / "pyproject.toml").exists()
    return of_checkout and Path(os.path.realpath(folder)) == own


def place(directory: Path, name: str) -> Path:
    """Where a file stands: with the modules, and in a checkout the formula book among the documents."""
    return directory.parent / "docs" / name if name == BOOK and _is_of_checkout(directory) else directory / name


def owners(directory: Path) -> Owners:
    """Whose the files of a directory are; those that come with the package are ours wherever they are found."""
    return written_files.owners(directory, written_files.read_record(package()))


def may_be_written(directory: Path) -> bool:
    """Whether a directory is for generated code: by the record in it, or because it holds nothing else."""
    found = owners(directory)
    return found.recorded or not found.others or _is_of_checkout(directory)


def differences(directory: Path, expected: Files) -> Iterator[str]:
    """What stands on disk against what the derivations give, file by file, as unified diffs."""
    for orphan in orphans(directory, expected):
        yield f"{orphan}: no derivation owns this file\n"
    for name, text in sorted(expected.items()):
        path = place(directory, name)
        yield _difference(path, text) if path.exists() else f"{name}: missing\n"


def _difference(path: Path, expected: str) -> str:
    if not path.is_file():  # a pipe would be waited for
        return f"{path.name}: cannot be read (it is no file)\n"
    try:
        found = path.read_bytes().decode()
    except (OSError, UnicodeDecodeError) as error:
        return f"{path.name}: cannot be read ({error})\n"
    lines = difflib.unified_diff(
        found.splitlines(keepends=True), expected.splitlines(keepends=True), f"{path.name} on disk", "as derived"
    )
    shown = "".join(line if line.endswith("\n") else f"{line}\n" for line in lines)
    return shown or ("" if found == expected else f"{path.name}: line endings differ\n")


def orphans(directory: Path, expected: Files) -> list[str]:
    """The names of what was written to the directory and no derivation owns any more; not what was edited since."""
    return sorted(owners(directory).ours - expected.keys())


def in_the_way(directory: Path, wanted: Collection[str]) -> list[str]:
    """The names that are to be written and are somebody else's."""
    return [] if _is_of_checkout(directory) else sorted(owners(directory).others.intersection(wanted))


def kept(directory: Path, files: Files) -> list[str]:
    """The names of what is not ours, or not any more, and stays where it is."""
    found = owners(directory)
    return sorted((found.others | found.edited) - files.keys())


def edited(directory: Path, files: Files) -> list[str]:
    """The names of what was edited since it was written, and is written anew; a checkout keeps a history of its own."""
    return [] if _is_of_checkout(directory) else sorted(owners(directory).edited & files.keys())


def write(directory: Path, files: Files) -> Path | None:
    """Replace the directory in one step: whoever looks sees the old set or the new one, and what is kept in both.

    Returns:
        Where what was edited is kept; None when nothing was.

    Raises:
        OSError: naming the directory or file, when it cannot be written or is somebody else's; all is then as before.
    """
    if others := in_the_way(directory, files):
        raise FileExistsError(errno.EEXIST, "this was not written by this command", str(directory / others[0]))
    changed = edited(directory, files)
    beside = {name: place(directory, name) for name in files if place(directory, name).parent == directory}
    stay = kept(directory, files) + [name for name in (written_files.CACHE,) if (directory / name).is_dir()]

    def fill(folder: Path) -> None:
        for name in beside:
            (folder / name).write_bytes(files[name].encode())
        written_files.keep(directory, stay, folder)

    try:
        directory.parent.mkdir(parents=True, exist_ok=True)
        aside = written_files.keep_beside(directory, changed) if changed else None
        replace_directory(directory, fill)
        for name in files.keys() - beside.keys():
            replace_file(place(directory, name), files[name])
    except OSError as error:
        raise type(error)(error.errno, error.strerror, error.filename or str(directory)) from None
    return aside
