"""What commands say: on any terminal, in any encoding, with any stream closed, and without a stranger's escapes."""

from __future__ import annotations

import codecs
import os
import re
import sys
import unicodedata
from contextlib import suppress
from io import TextIOWrapper
from typing import Any, Literal

import typer
from rich.console import Console

from radartrack._system.harmless_text import harmless, one_line, shown

__all__ = [
    "NARROWEST",
    "PLAIN_WIDTH",
    "SPELLED",
    "complain",
    "console",
    "counted",
    "error_console",
    "harmless",
    "one_line",
    "prepare",
    "report_lost_output",
    "say",
    "shown",
]

PLAIN_WIDTH = 120  # in a file or a pipe
NARROWEST = 40  # columns below which nothing is laid out any more
SPELLED = "radartrack.spelled"

_WIDTHS = ("COLUMNS", "LINES", "TERMINAL_WIDTH")
_A_WIDTH = re.compile(r"[1-9][0-9]{0,3}")
_SIGNS = {
    "−": "-", "–": "-", "—": "-", "×": "x", "·": "*", "⋅": "*", "…": "...", "⁄": "/", "≤": "<=", "≥": ">=", "≠": "!=",
    "±": "+-", "√": "sqrt", "∞": "inf", "→": "->", "°": " deg", "∂": "d", "✗": "x", "“": '"', "”": '"', "„": '"',
    "‘": "'", "’": "'", "⋮": ":", "█": "#", "━": "-", "╸": "-", "╺": "-", "─": "-", "│": "|", "•": "*",
}  # fmt: skip


def prepare() -> None:
    """Make the streams of this process usable whatever they are; what an encoding lacks is spelled."""
    _open_what_is_closed()
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, TextIOWrapper):
            stream.reconfigure(errors=SPELLED)
    for name in _WIDTHS:
        if not _A_WIDTH.fullmatch(os.environ.get(name, "1")):
            del os.environ[name]  # whoever reads it expects a number


def counted(number: int, thing: str) -> str:
    """So many of a thing: 1 function, 2 functions."""
    return f"{number} {thing}{'' if number == 1 else 's'}"


def console(plain_width: int = PLAIN_WIDTH) -> Console:
    """For results: as wide as the terminal or as COLUMNS says, else `plain_width`; no colours where NO_COLOR is set."""
    known = sys.stdout.isatty() or "COLUMNS" in os.environ
    return _console(width=None if known else plain_width)


def error_console() -> Console:
    """For progress, on the error stream."""
    return _console(stderr=True)


def say(text: str) -> None:
    """Write lines of text to the output."""
    typer.echo(harmless(text))


def complain(text: str) -> None:
    """Write one line to the error stream; when nobody can read it, that is no failure of what was asked for."""
    with suppress(OSError):
        typer.echo(one_line(text), err=True)


def report_lost_output(error: OSError) -> None:
    """Say what could not be read or written, in one line; a reader that went away needs no word."""
    if not isinstance(error, BrokenPipeError):
        reason = error.strerror or str(error) or type(error).__name__
        complain(f"{error.filename}: {reason}" if error.filename else f"The output cannot be written: {reason}")
    _drop_what_is_left()


class _Console(Console):
    def on_broken_pipe(self) -> None:
        """Say so, as every stream does; Rich would end the process with a code that means something else here."""
        raise BrokenPipeError


def _console(**settings: Any) -> Console:
    colours: Literal["auto"] | None = None if os.environ.get("NO_COLOR") else "auto"
    made = _Console(color_system=colours, emoji=False, highlight=False, **settings)
    made.width = max(made.width, NARROWEST)
    return made


def _open_what_is_closed() -> None:
    """A closed descriptor would be given to the next file that is opened, and output would land in it."""
    for descriptor in range(3):
        try:
            os.fstat(descriptor)
        except OSError:
            os.open(os.devnull, os.O_RDWR)
    sys.stdout = sys.stdout or _nowhere()
    sys.stderr = sys.stderr or _nowhere()


def _nowhere() -> TextIOWrapper:
    return open(os.devnull, "w", encoding="utf-8")  # noqa: PTH123 - lasts as long as the process


def _drop_what_is_left() -> None:
    """What waits in the buffers would fail again when the interpreter ends, with a code of its own."""
    nowhere = os.open(os.devnull, os.O_WRONLY)
    for stream in (sys.stdout, sys.stderr):
        try:
            stream.flush()
        except OSError:
            with suppress(OSError):
                os.dup2(nowhere, stream.fileno())
    os.close(nowhere)


def _spelled(error: UnicodeError) -> tuple[str, int]:
    if not isinstance(error, UnicodeEncodeError):
        raise error
    return "".join(map(_spelling, error.object[error.start : error.end])), error.end


def _spelling(sign: str) -> str:
    """In ASCII: Greek letters by name, signs by what is typed for them, letters without accents."""
    if sign.isascii() or sign in _SIGNS:
        return _SIGNS.get(sign, sign)
    name = unicodedata.name(sign, "")
    parts = unicodedata.normalize("NFKD", sign)
    if parts != sign:
        mark = "^" if "SUPERSCRIPT" in name else "_" if "SUBSCRIPT" in name else ""
        return mark + "".join(map(_spelling, parts))
    kind, _, letter = name.partition(" LETTER ")
    if kind in {"GREEK SMALL", "GREEK CAPITAL"}:
        word = letter.removeprefix("FINAL ").split()[0].lower()
        return word.capitalize() if kind == "GREEK CAPITAL" else word
    return "" if unicodedata.combining(sign) else "?"


codecs.register_error(SPELLED, _spelled)
