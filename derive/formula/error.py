"""What is said when a formula cannot be read."""

from __future__ import annotations

import unicodedata
from typing import TypeAlias

Span: TypeAlias = tuple[int, int]

WINDOW = 72  # characters of the formula shown around the fault


class FormulaError(ValueError):
    """A formula that is refused.

    Attributes:
        message: what is wrong and what to write instead, in one or two sentences.
        source: the formula as given; empty when it is too long to repeat.
        span: where the fault begins and ends in `source`, when it has a place.
    """

    def __init__(self, message: str, source: str = "", span: Span | None = None) -> None:
        super().__init__(message, source, span)  # all three, so that the error can be pickled
        self.message = message
        self.source = source
        self.span = span

    def within(self, source: str) -> FormulaError:
        """The same error, pointing into this formula."""
        return self.at(source, self.span)

    def at(self, source: str, span: Span | None) -> FormulaError:
        """The same error at a place of this formula."""
        return FormulaError(self.message, source, span)

    @property
    def line(self) -> int | None:
        """The line of the fault, counted from 1."""
        return self.source.count("\n", 0, self.span[0]) + 1 if self.span else None

    @property
    def column(self) -> int | None:
        """The column of the fault, counted from 1."""
        return self.span[0] - _line_start(self.source, self.span[0]) + 1 if self.span else None

    @property
    def excerpt(self) -> str:
        """The part of the formula around the fault with carets beneath, or nothing."""
        if self.span is None or not self.source:
            return ""
        start, end = self.span
        line_start = _line_start(self.source, start)
        line_end = self.source.find("\n", start)
        line_end = len(self.source) if line_end < 0 else line_end
        left = max(line_start, start - WINDOW // 2)
        right = min(line_end, left + WINDOW)
        carets = max(1, min(end, right) - start)
        shown = "".join(map(_printable, self.source[left:right]))
        return f"    {shown}\n    {' ' * (start - left)}{'^' * carets}"

    def __str__(self) -> str:
        if self.span is None or not self.source:
            return self.message
        line = f"line {self.line}, " if "\n" in self.source else ""
        return f"{self.message} ({line}column {self.column})\n{self.excerpt}"


def _line_start(source: str, position: int) -> int:
    return source.rfind("\n", 0, position) + 1


def _printable(character: str) -> str:
    """The character, unless it would break the line of carets below or do something to the terminal."""
    narrow = unicodedata.east_asian_width(character) not in "WF" and not unicodedata.combining(character)
    return character if character.isprintable() and narrow else " " if character.isspace() else "?"
