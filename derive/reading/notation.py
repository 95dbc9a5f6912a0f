"""The notations that a formula may be in, and the one door through which all of them are read."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping
from contextlib import suppress
from dataclasses import dataclass
from functools import partial

from radartrack.derive.code_languages import LANGUAGES
from radartrack.derive.formula.error import FormulaError
from radartrack.derive.formula.shape import NO_SHAPES, Shape
from radartrack.derive.formula.tree import Tree, bound_names, names
from radartrack.derive.reading.code.source_code import read_code
from radartrack.derive.reading.linear_format import with_commas
from radartrack.derive.reading.printed_text import is_printed, read_printed_text
from radartrack.derive.reading.tex.latex import read_latex
from radartrack.derive.reading.text import read_text

TEXT, LATEX, PRINTED = "text", "latex", "printed"
NOTATIONS = (TEXT, LATEX, PRINTED, *LANGUAGES)


@dataclass(frozen=True, slots=True)
class Reading:
    """A formula as it was read.

    Attributes:
        tree: the formula.
        unknown: the names in it that were not known.
        notation: the one of `NOTATIONS` that it was read in.
        remarks: what the language of code does that a formula does not, with the line: 3/2 is 1 in C.
    """

    tree: Tree
    unknown: frozenset[str]
    notation: str
    remarks: tuple[str, ...] = ()


def read_formula(
    text: str,
    notation: str,
    known: Collection[str] | None,
    shapes: Mapping[str, Shape] = NO_SHAPES,
    *,
    strangers: bool = False,
    function: str = "",
    wanted: int = 1,
) -> Reading:
    """Read a formula in any notation.

    Args:
        text: the formula.
        notation: one of `NOTATIONS`; in `text`, one with signs of a printed page is read as `printed`.
        known: the symbols; None where none are known, and every name is let through.
        shapes: of those that stand for arrays.
        strangers: whether names that are not known are let through.
        function: of code, the function to read.
        wanted: how many numbers it is to be.

    Raises:
        FormulaError: when it cannot be read, has two meanings, or is too large.
        ValueError: when one of the names is a function's, or the notation is none of these.
    """
    remarks: tuple[str, ...] = ()
    if notation == TEXT and is_printed(text):
        notation = PRINTED
    if notation in LANGUAGES:
        code = read_code(text, notation, known, shapes, function=function, strangers=strangers, wanted=wanted)
        tree = code.tree
        remarks = tuple(f"line {_line(text, one.span[0])}: {one.words}" for one in code.remarks)
    elif notation in {TEXT, LATEX, PRINTED}:
        read = {TEXT: read_text, LATEX: read_latex, PRINTED: read_printed_text}[notation]
        readable = partial(read, names=known, shapes=shapes, strangers=strangers, wanted=wanted)
        tree = readable(text) if notation == LATEX else _without_commas(readable, text)
    else:
        raise ValueError(f"notation: {notation!r} is not read; it is one of {', '.join(NOTATIONS)}")
    unknown = names(tree) - frozenset(known or ()) - bound_names(tree)
    return Reading(tree, unknown, notation, remarks)


def _without_commas(read: Callable[[str], Tree], text: str) -> Tree:
    """The formula as it stands, or with what parts the entries of its matrices where only so it can be read."""
    try:
        return read(text)
    except FormulaError:
        if (parted := with_commas(text)) != text:
            with suppress(FormulaError):
                return read(parted)
        raise


def _line(text: str, at: int) -> int:
    return text.count("\n", 0, at) + 1


__all__ = ["LANGUAGES", "LATEX", "NOTATIONS", "PRINTED", "TEXT", "FormulaError", "Reading", "read_formula"]
