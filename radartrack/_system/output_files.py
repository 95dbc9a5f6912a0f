"""The files that a command is asked to write: tried before its work begins, and complete or not there at all."""

from __future__ import annotations

import errno
import json
import math
import os
import tempfile
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import Any

import typer

from radartrack._system import terminal
from radartrack._system.directory_swap import replace_file


def refuse_unwritable(wanted: Mapping[str, Path | None], kept: Iterable[Path] = ()) -> None:
    """Try the places of files that will be written.

    Args:
        wanted: the option that asks for each, such as --json.
        kept: files that are read and must not be written.

    Raises:
        typer.Exit: with one line that names the option, when a file cannot be written there.
    """
    taken = {_real(path): f"{path} is read" for path in kept}
    for option, path in wanted.items():
        if path is None:
            continue
        problem = taken.get(_real(path)) or problem_with(path)
        if problem:
            terminal.complain(f"{option} must be a file that can be written; {problem}")
            raise typer.Exit(2)
        taken[_real(path)] = f"{path} is asked for twice"


def problem_with(path: Path) -> str:
    """Why a file cannot be written there; empty when it can."""
    path = _real(path)
    try:
        number = _refusal(path)
        if number is None and (path.is_file() or not path.exists()):
            _try(path.parent)
    except OSError as error:
        return f"{path}: {error.strerror or error}"
    return "" if number is None else f"{path}: {os.strerror(number)}"


def problem_around(path: Path) -> str:
    """Why nothing can be put in the place of a path, whose parents may still be missing; empty when it can."""
    real = _real(path)
    if real.is_mount():
        return f"{path} is mounted, and cannot be replaced; a directory in it can"
    around = next(parent for parent in real.parents if parent.exists())
    try:
        _try(around)
    except OSError as error:
        return f"{around}: {error.strerror or error}"
    return ""


def _refusal(path: Path) -> int | None:
    if path.is_symlink() and not path.exists():
        return errno.ELOOP
    if path.is_dir():
        return errno.EISDIR
    return errno.EACCES if path.exists() and not os.access(path, os.W_OK) else None


def _try(directory: Path) -> None:
    with tempfile.TemporaryFile(dir=directory):
        pass


def write(path: Path, content: str | bytes) -> None:
    """Write content beside the file and put it in place; what is no file, such as /dev/stdout, gets it directly.

    Raises:
        OSError: naming the file, when it cannot be written; a file that was there is then as before.
    """
    path = _real(path)
    try:
        if path.exists() and not path.is_file():
            path.write_bytes(content.encode() if isinstance(content, str) else content)
        else:
            replace_file(path, content)
    except OSError as error:
        raise OSError(error.errno, error.strerror, str(path)) from None


def json_text(value: Any) -> str:
    """JSON in ASCII, so that every terminal and every encoding holds it; a number that is not finite becomes null."""
    return json.dumps(_finite(value), indent=2, allow_nan=False) + "\n"


def _real(path: Path) -> Path:
    """Where links lead; a loop of them leads to a link, and one to an open pipe, such as /dev/stdout, to itself."""
    real = os.path.realpath(path)
    leads_nowhere = os.path.exists(path) and not os.path.exists(real)  # noqa: PTH110 - a long name is no error here
    return path if leads_nowhere else Path(real)


def _finite(value: Any) -> Any:
    match value:
        case float():
            return value if math.isfinite(value) else None
        case str():
            return value
        case Mapping():
            return {name: _finite(one) for name, one in value.items()}
        case Sequence():
            return [_finite(one) for one in value]
    return value
