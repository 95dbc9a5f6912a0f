"""Whose the files of a directory are: a record among them says what was written there, by digests of the content.

A file is ours when it holds what the record says. One that is named there and holds something else was edited by
somebody since; every other file is somebody else's. Neither is ever deleted.
"""

from __future__ import annotations

import json
import os
import re
import shutil
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from hashlib import sha256
from itertools import count
from pathlib import Path
from types import MappingProxyType

from radartrack._system.directory_swap import replace_file

RECORD = "written.json"
CACHE = "__pycache__"
DIGEST = re.compile(r"[0-9a-f]{64}")

Digests = Mapping[str, str]


@dataclass(frozen=True)
class Owners:
    """The names in a directory, each in one of three sets; the cache of imported modules is in none.

    Attributes:
        recorded: whether there is a record.
        ours: as they were written.
        edited: written, and changed since.
        others: of somebody else.
    """

    recorded: bool
    ours: frozenset[str]
    edited: frozenset[str]
    others: frozenset[str]


def record(files: Mapping[str, str]) -> str:
    """The record of what is written to a directory."""
    return _text({name: digest(text.encode()) for name, text in files.items()})


def write(directory: Path, name: str, content: str | bytes) -> None:
    """Write one file of a directory that may hold others' too, and record it.

    Raises:
        OSError: the file system refuses.
    """
    data = content.encode() if isinstance(content, str) else content
    replace_file(directory / RECORD, _text({**read_record(directory), name: digest(data)}))
    replace_file(directory / name, data)


def read_record(directory: Path) -> Digests:
    """What was written to a directory, by name; empty where no record can be read."""
    try:
        stored = json.loads((directory / RECORD).read_bytes())
    except (OSError, ValueError, RecursionError):
        return {}
    if not isinstance(stored, dict) or not all(map(_is_entry, stored, stored.values())):
        return {}
    return stored


def owners(directory: Path, shipped: Digests = MappingProxyType({})) -> Owners:
    """Who owns what is in a directory.

    Args:
        directory: which may not be there.
        shipped: digests of files that are ours wherever they are found under their names.
    """
    written = read_record(directory)
    names = {path.name for path in directory.iterdir()} - {CACHE} if directory.is_dir() else set()
    ours = {name for name in names if _digest_of(directory / name) in {written.get(name), shipped.get(name)} - {None}}
    ours |= names & {RECORD} if written else set()
    edited = names & written.keys() - ours
    return Owners(bool(written), frozenset(ours), frozenset(edited), frozenset(names - ours - edited))


def keep(directory: Path, names: Iterable[str], folder: Path) -> None:
    """Let files and folders of a directory be in another one too; on one file system no copy is made."""
    for name in names:
        source, target = directory / name, folder / name
        if source.is_dir() and not source.is_symlink():
            shutil.copytree(source, target, symlinks=True, copy_function=_link)
        else:
            _link(str(source), str(target))


def keep_beside(directory: Path, names: Iterable[str]) -> Path:
    """Let files of a directory be in a new one beside it too, which is called after it."""
    target = directory.resolve()
    places = (target.with_name(f"{target.name}.edited{number or ''}") for number in count())
    folder = next(place for place in places if not os.path.lexists(place))
    folder.mkdir()
    keep(directory, names, folder)
    return folder


def digest(content: bytes) -> str:
    """Of a text, whatever ends its lines."""
    return sha256(content.replace(b"\r\n", b"\n")).hexdigest()


def _text(digests: Digests) -> str:
    return json.dumps(dict(sorted(digests.items())), indent=1) + "\n"


def _digest_of(path: Path) -> str | None:
    try:
        return digest(path.read_bytes()) if path.is_file() else None
    except OSError:
        return None


def _is_entry(name: str, stored: object) -> bool:
    return Path(name).name == name and isinstance(stored, str) and DIGEST.fullmatch(stored) is not None


def _link(source: str, target: str) -> None:
    try:
        os.link(source, target, follow_symlinks=False)
    except (OSError, NotImplementedError):  # a system or a file system without second names
        shutil.copy2(source, target, follow_symlinks=False)
