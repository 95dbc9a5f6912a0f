"""What a run has done so far, one line of JSON a task, appended as tasks end; a later run of the same code goes on."""

from __future__ import annotations

import json
from dataclasses import dataclass, field
from hashlib import sha256
from pathlib import Path
from typing import Any


@dataclass
class Checkpoint:
    """Results by key.

    Attributes:
        path: of the file; None keeps nothing.
        digest: of the code and the settings; lines of another digest are left alone and not used.
    """

    path: Path | None
    digest: str
    done: dict[str, Any] = field(default_factory=dict)

    def __post_init__(self) -> None:
        if self.path is not None and self.path.exists():
            for line in self.path.read_text(encoding="utf-8").splitlines():
                self._read(line)

    def add(self, key: str, result: Any) -> None:
        """Remember a result, on disk before this returns."""
        self.done[key] = result
        if self.path is not None:
            line = json.dumps({"digest": self.digest, "key": key, "result": result})
            with self.path.open("a", encoding="utf-8") as file:
                file.write(line + "\n")

    def finish(self) -> None:
        """Forget the file: everything is done."""
        if self.path is not None:
            self.path.unlink(missing_ok=True)

    def _read(self, line: str) -> None:
        try:
            row = json.loads(line)
            if row["digest"] == self.digest:
                self.done[row["key"]] = row["result"]
        except (ValueError, TypeError, KeyError):
            return  # the last line of a run that was killed


def digest_of(folders: list[Path], settings: str) -> str:
    """Of all Python files in some folders and the settings of a run."""
    found = sha256(settings.encode())
    for folder in folders:
        for path in sorted(folder.rglob("*.py")):
            found.update(path.relative_to(folder).as_posix().encode() + b"\0" + path.read_bytes())
    return found.hexdigest()
