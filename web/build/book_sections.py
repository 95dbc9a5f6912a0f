"""The formula book by quantity: what `radartrack regenerate` wrote of each, and what it proves to be today's."""

from __future__ import annotations

import re
from dataclasses import dataclass
from pathlib import Path

BOOK = Path(__file__).parents[2] / "docs" / "formulas.md"
_CHAPTER = re.compile(r"^## (?P<name>\w+)$", re.MULTILINE)
_SECTION = re.compile(r"^### (?P<name>[\w.]+)$", re.MULTILINE)
_FORMULA = re.compile(r"^```math\n(?P<latex>.*?)\n```$", re.MULTILINE | re.DOTALL)


@dataclass(frozen=True)
class Section:
    """What the book says of a quantity.

    Attributes:
        name: of the quantity.
        text: all of it, in Markdown, without its heading.
        latex: the formula; nothing where it is too long for the book.
        symbols: the table of its chapter's symbols, a row for each, by name.
    """

    name: str
    text: str
    latex: str
    symbols: dict[str, str]


def sections() -> list[Section]:
    """All quantities, in the order of the book."""
    found: list[Section] = []
    chapters = _CHAPTER.split(BOOK.read_text(encoding="utf-8"))
    for chapter in chapters[2::2]:
        head, *rest = _SECTION.split(chapter)
        symbols = {match[1]: match[0] for match in re.finditer(r"^\| `(\w+)` \|.*\|$", head, re.MULTILINE)}
        for name, text in zip(rest[::2], rest[1::2], strict=True):
            formula = _FORMULA.search(text)
            found.append(Section(name, text.strip(), formula["latex"] if formula else "", symbols))
    return found


def introduction() -> str:
    """What the book says first, without its heading."""
    text = BOOK.read_text(encoding="utf-8")
    return text[text.index("\n") : text.index("\n- [")].strip()


def bibliography() -> str:
    """The sources, as a list in Markdown."""
    return BOOK.read_text(encoding="utf-8").partition("\n## sources\n")[2].strip()
