"""Code on the command line: itself, or a file, a function in it, or some of its lines."""

from __future__ import annotations

import re
from pathlib import Path

import typer

_IN_FILE = re.compile(
    r"(?P<file>[^:\n]+(?::[^:\n]+)*?)(?::(?:(?P<function>[A-Za-z_]\w*)|(?P<first>\d{1,7})(?:-(?P<last>\d{1,7}))?))?"
)
_MOST_BYTES = 1_000_000


def code_argument(argument: str) -> tuple[str, str]:
    """The code, and the function that is meant; lines of a file keep their numbers.

    Args:
        argument: code, `FILE`, `FILE:function`, `FILE:line` or `FILE:first-last`.

    Raises:
        typer.BadParameter: for a file that cannot be read, and for lines that it does not have.
    """
    found = _IN_FILE.fullmatch(argument.strip())
    if not found or not (path := Path(found["file"])).is_file():
        return argument, ""
    try:
        with path.open("rb") as stream:
            content = stream.read(_MOST_BYTES + 1)
        text = content.decode("utf-8-sig")
    except (OSError, UnicodeDecodeError) as error:
        raise typer.BadParameter(f"{path}: {error}", param_hint="FORMULA") from None
    if len(content) > _MOST_BYTES:
        raise typer.BadParameter(f"{path}: more than {_MOST_BYTES} bytes are not read", param_hint="FORMULA")
    text = text.replace("\r\n", "\n")
    if not found["first"]:
        return text, found["function"] or ""
    lines = text.split("\n")
    first, last = int(found["first"]), int(found["last"] or found["first"])
    if not 1 <= first <= last <= len(lines):
        raise typer.BadParameter(f"{path} has the lines 1 to {len(lines)}", param_hint="FORMULA")
    return "\n" * (first - 1) + "\n".join(lines[first - 1 : last]), ""
