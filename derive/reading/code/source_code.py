"""Reads code as a formula: an expression, a block of assignments, or a function, in Python, C, C++ or MATLAB."""

from __future__ import annotations

import re
from collections.abc import Callable, Collection, Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import TypeAlias

from radartrack.derive.code_languages import LANGUAGES, SPOKEN
from radartrack.derive.formula.error import FormulaError
from radartrack.derive.formula.limits import check_brackets
from radartrack.derive.formula.shape import NO_SHAPES, Shape
from radartrack.derive.formula.tree import Name, Tree, parts
from radartrack.derive.formula.unknown_names import check_names, unknown_name
from radartrack.derive.reading.characters import check_characters
from radartrack.derive.reading.code.c_source import read_c
from radartrack.derive.reading.code.matlab_source import read_matlab
from radartrack.derive.reading.code.python_source import read_python
from radartrack.derive.reading.code.workspace import Remark, Value, Workspace
from radartrack.derive.reading.grammar import check_tree

Reader: TypeAlias = Callable[[str, Workspace, str], Value]

_READERS: Mapping[str, Reader] = MappingProxyType(
    {
        "python": read_python,
        "c": lambda text, space, function: read_c(text, "c", space, function),
        "cpp": lambda text, space, function: read_c(text, "cpp", space, function),
        "matlab": read_matlab,
    }
)
MAX_CODE = 40_000  # characters; parsers that recover from errors take longer than the grammars of formulas
MAX_PARTS = 50  # of a dotted name: the parser of MATLAB takes a time that grows with their square
_DOTTED = re.compile(rf"(?:\.\s*[A-Za-z_]\w*\s*){{{MAX_PARTS}}}")
_FOREIGN = re.compile(r"[^\x20-\x7e\t\n\r]")
_COMMENTS = MappingProxyType(
    {
        "python": re.compile(r"(?P<kept>\"\"\"[\s\S]*?\"\"\"|'''[\s\S]*?'''|\"[^\"\n]*\"|'[^'\n]*')|#[^\n]*"),
        "c": re.compile(r"(?P<kept>\"[^\"\n]*\")|//[^\n]*|/\*[\s\S]*?\*/"),
        "cpp": re.compile(r"(?P<kept>\"[^\"\n]*\")|//[^\n]*|/\*[\s\S]*?\*/"),
        "matlab": re.compile(r"(?P<kept>\"[^\"\n]*\")|[%#][^\n]*"),  # Octave has both
    }
)
_BRACKETS = re.compile(r"[()\[\]{}]")
_QUOTED = re.compile(r"\"[^\"\n]*\"|'[^'\n]*'")
_CLOSERS = MappingProxyType({"(": ")", "[": "]", "{": "}"})


@dataclass(frozen=True, slots=True)
class ReadCode:
    """Code as a formula, and what its language does that a formula does not: 3/2 is 1 in C."""

    tree: Tree
    remarks: tuple[Remark, ...]


def read_code(
    text: str,
    language: str,
    names: Collection[str] | None,
    shapes: Mapping[str, Shape] = NO_SHAPES,
    *,
    function: str = "",
    strangers: bool = False,
    wanted: int = 1,
) -> ReadCode:
    """Read code in these symbols, with the arithmetic of its language. It is parsed and never run.

    Of a block of assignments the last one is read, with those before it put in; where entries of an array are set, all
    that are. Of a function, what it returns.

    Args:
        text: the code.
        language: one of `LANGUAGES`.
        names: the symbols; None where none are known, and every name is let through.
        shapes: of those that stand for arrays.
        function: the function to read, where there are several.
        strangers: whether names that are not known are let through.
        wanted: how many numbers it is to compute: where as many are assigned that no other rests on, all of them.

    Raises:
        FormulaError: when it is no such code, does what formulas do not, or is too large.
        ValueError: when one of the names is a function's, or the language is none of these.
    """
    if language not in SPOKEN:
        raise ValueError(f"language: {language!r} is not read; it is one of {', '.join(LANGUAGES)}")
    (spoken, first), read = SPOKEN[language], _READERS[language]
    allowed = check_names(names or ())
    strangers = strangers or names is None
    space = Workspace(spoken, first, allowed, shapes, wanted)
    try:
        plain = _plain(text, language, allowed)
        _check_nesting(plain)
        tree = read(plain, space, function).tree
        if not strangers:  # lines on which the result does not rest may have what names they like
            _check_known(tree, allowed)
        # Equal parts stay apart: each knows the line that it stands in.
        return ReadCode(check_tree(tree, shapes=shapes, strangers=strangers), tuple(space.remarks))
    except FormulaError as error:
        raise error.within(text) from None
    except RecursionError:
        raise FormulaError("the code is nested too deeply to be read") from None


def _check_known(tree: Tree, names: frozenset[str]) -> None:
    unknown = [node for node in parts(tree) if isinstance(node, Name) and node.name not in names]
    if unknown:
        first = min(unknown, key=lambda node: node.span or (0, 0))
        raise FormulaError(unknown_name(first.name, names), span=first.span)


def _plain(text: str, language: str, names: frozenset[str]) -> str:
    """The code without comments, if it has nothing but ASCII then."""
    if len(text) > MAX_CODE:
        raise FormulaError(f"the code has {len(text)} characters; at most {MAX_CODE} are read: give some lines")

    def blank(found: re.Match[str]) -> str:
        return _FOREIGN.sub("?", found.group()) if found["kept"] else re.sub(r"[^\n]", " ", found.group())

    plain = _COMMENTS[language].sub(blank, text)
    check_characters(plain, names)
    return plain


def _check_nesting(text: str) -> None:
    """Refuse brackets that are nested so deeply that a parser would stumble."""
    bare = _QUOTED.sub(lambda found: " " * len(found.group()), text) if '"' in text else text
    check_brackets([(found.group(), found.span()) for found in _BRACKETS.finditer(bare)], _CLOSERS)
    if dotted := _DOTTED.search(bare):
        raise FormulaError(f"a dotted name has at most {MAX_PARTS} parts", span=dotted.span())
