"""What a run has done so far, one line of JSON a task, appended as tasks end; a later run of the same goes on."""

from __future__ import annotations

import json
import os
from dataclasses import dataclass, field
from hashlib import sha256
from pathlib import Path
from typing import Any

from radartrack._system.directory_swap import replace_file

LONGEST = 1 << 16  # bytes read of a file to find out whose it is
ROW = {"digest", "key", "result"}


class NotACheckpoint(ValueError):
    """A file holds something else than what a run has done."""


@dataclass
class Checkpoint:
    """Results by key.

    Where another run keeps its results in the file that is asked for, this one takes a file beside it.

    Attributes:
        path: of the file; None keeps nothing.
        digest: of what is run: the code, the names and the settings.

    Raises:
        NotACheckpoint: when the file was not written by a run; it is left as it is.
        OSError: when it cannot be read.
    """

    path: Path | None
    digest: str
    done: dict[str, Any] = field(default_factory=dict)
    _begun: bool = False

    def __post_init__(self) -> None:
        if self.path is not None:
            self.path = self._own(self.path)
            self._read(self.path)

    def add(self, key: str, result: Any) -> None:
        """Remember a result, on disk before this returns."""
        self.done[key] = result
        if self.path is None:
            return
        line = json.dumps({"digest": self.digest, "key": key, "result": result}) + "\n"
        if self._begun:
            with self.path.open("a", encoding="utf-8") as file:
                file.write(line)
        else:
            replace_file(self.path, line)  # so that the file is known as ours from its first moment
            self._begun = True

    def finish(self) -> None:
        """Forget the file: everything is done."""
        if self.path is not None and self._begun:
            self.path.unlink(missing_ok=True)

    def _own(self, asked: Path) -> Path:
        """The file that holds this run, or may."""
        asked = Path(os.path.realpath(asked))
        beside = asked.with_name(f"{asked.stem}-{self.digest[:12]}{asked.suffix}")
        owners = {path: _owner(path) for path in (asked, beside)}
        held = [path for path, owner in owners.items() if owner == self.digest]
        free = [path for path, owner in owners.items() if owner is None]
        return (held or free)[0]

    def _read(self, path: Path) -> None:
        if not path.exists():
            return
        text = path.read_text(encoding="utf-8", errors="replace")
        for line in text.splitlines():
            if (row := _row(line)) is not None and row["digest"] == self.digest:
                self.done[row["key"]] = row["result"]
        self._begun = bool(text)
        if not text.endswith("\n") and text:  # a run was killed in the middle of a line
            with path.open("a", encoding="utf-8") as file:
                file.write("\n")


def digest_of(folders: list[Path], settings: str) -> str:
    """Of all Python files in some folders and the settings of a run."""
    found = sha256(settings.encode())
    for folder in folders:
        for path in sorted(folder.rglob("*.py")):
            found.update(path.relative_to(folder).as_posix().encode() + b"\0" + path.read_bytes())
    return found.hexdigest()


def _owner(path: Path) -> str | None:
    """The digest of the run whose results a file holds; None for a file that is empty or not there."""
    if path.is_symlink() or (path.exists() and not path.is_file()):
        raise NotACheckpoint(f"{path} is no file")
    if not path.exists():
        return None
    with path.open("rb") as file:
        first = file.readline(LONGEST)
    if not first:
        return None
    row = _row(first.decode(errors="replace"))
    if row is None:
        raise NotACheckpoint(f"{path} holds something else than the checkpoint of a run; it is left as it is")
    return str(row["digest"])


def _row(line: str) -> dict[str, Any] | None:
    try:
        row = json.loads(line)
    except (ValueError, RecursionError):
        return None
    return row if isinstance(row, dict) and row.keys() == ROW and isinstance(row["key"], str) else None
