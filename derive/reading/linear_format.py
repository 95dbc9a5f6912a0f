"""Matrices and invisible brackets in one line of text: ■(a&b@c&d) and 〖a+b〗 of Word's linear format, [a, b; c, d].

A page that is copied loses the commas: [a b; c d], or a row on each line.
"""

from __future__ import annotations

import re
from bisect import bisect
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from itertools import pairwise
from types import MappingProxyType

from radartrack.derive.formula.error import FormulaError
from radartrack.derive.formula.functions import SPELLINGS

_PAIRS: Mapping[str, str] = MappingProxyType({"(": ")", "[": "]", "{": "}", "〖": "〗", "├": "┤"})
MATRIX, ALIGNED, GROUP, OPERAND = "■", "█", "〖", "▒"
SILENT = OPERAND + "├┤"
SIGNS = frozenset(MATRIX + ALIGNED + GROUP + "〗" + SILENT)
APPLIED = "\N{FUNCTION APPLICATION}"
_SUM, _INTEGRAL = "∑", "∫"
_FUNCTIONS = "|".join(SPELLINGS)
_INNERMOST = re.compile(r"\[[^\[\]]*\]")
_NEAR = 12  # signs around a space


@dataclass(frozen=True)
class Structure:
    """A structure in a line.

    Attributes:
        parts: LaTeX, and between it places in the text from where to where text is read on.
        end: where it ends.
    """

    parts: tuple[str | tuple[int, int], ...]
    end: int


def structure_at(text: str, at: int) -> Structure | None:
    """The structure that begins at a place, if one does.

    Raises:
        FormulaError: for a bracket that is never closed.
    """
    character, after = text[at], text[at + 1 : at + 2]
    if character in MATRIX + ALIGNED and after == "(":
        return _array(text, at, at + 1, "&", "@")
    if character == "{" and after == ALIGNED and text[at + 2 : at + 3] == "(":
        found = _array(text, at, at + 2, "&", "@", of="cases")
        return Structure(found.parts, found.end + text.startswith("┤", found.end))
    if character == "[" and ";" in text and _top_level(text, at, ";"):
        return _array(text, at, at, ",", ";")
    if character == "√" and after == "(" and _top_level(text, at + 1, "&"):
        return _root(text, at + 1)
    if character == OPERAND and after == GROUP:
        return _group(text, at + 1, bare=text.rfind(_INTEGRAL, 0, at) > text.rfind(_SUM, 0, at))
    if character == GROUP:
        is_argument = at > 0 and text[at - 1] == APPLIED
        return _group(text, at, bare=not (is_argument or _top_level(text, at, "+") or _top_level(text, at, "-")))
    return Structure((" ",), at + 1) if character in SILENT else None


def _array(text: str, at: int, opening: int, beside: str, below: str, of: str = "") -> Structure:
    """Rows of cells, as an environment of LaTeX."""
    end = _closing(text, opening)
    environment = of or ("aligned" if text[at] == ALIGNED and "=" in text[opening:end] else "matrix")
    parts: list[str | tuple[int, int]] = [rf"\begin{{{environment}}}"]
    start = opening + 1
    for place in (*_separators(text, opening, beside + below), end - 1):
        parts.append((start, place))
        parts.append({beside: " & ", below: r" \\ "}.get(text[place], " ") if place < end - 1 else " ")
        start = place + 1
    return Structure((*parts, rf"\end{{{environment}}}"), end)


def with_commas(text: str) -> str:
    """The text with commas and semicolons for the spaces and the ends of lines that part entries of its matrices.

    A space parts two entries unless it stands beside the sign of an operation or behind a function; before a sign that
    touches what follows it, it does. Brackets in which commas part something stay as they are, and so do those whose
    rows would differ in length.
    """
    return _INNERMOST.sub(_parted, text)


def _parted(found: re.Match[str]) -> str:
    text = found.group()
    try:
        if _top_level(text, 0, ",&"):
            return text
        rows = [*_separators(text, 0, ";")] or [*_separators(text, 0, "\n")]
        gaps = [place for place in _separators(text, 0, " \t") if _is_gap(text, place)]
    except FormulaError:
        return text
    passed = [bisect(gaps, end) for end in (0, *rows, len(text))]
    lengths = [after - before for before, after in pairwise(passed)]
    if not lengths or min(lengths) != max(lengths) or not gaps:
        return text
    signs = dict.fromkeys(gaps, ",") | dict.fromkeys(rows, ";")
    return "".join(signs.get(at, sign) for at, sign in enumerate(text))


def _is_gap(text: str, place: int) -> bool:
    """Whether a space parts two entries; of several side by side the first one."""
    before, after = text[max(place - _NEAR, 0) : place], text[place : place + _NEAR].lstrip()
    is_behind = re.search(rf"[-+−*/^=×·⋅;\n\[\s]$|(?<![A-Za-z])(?:{_FUNCTIONS})(?:\^?[\d²³]+)?$", before)
    return not is_behind and re.match(r"[-+−][^\s]|[^-+−*/^=×·⋅;\n\]]", after) is not None


def _root(text: str, at: int) -> Structure:
    """A root of which degree: √(3&x)."""
    end, degree = _closing(text, at), next(_separators(text, at, "&"))
    return Structure((r"\sqrt[", (at + 1, degree), "]{", (degree + 1, end - 1), "}"), end)


def _group(text: str, at: int, *, bare: bool) -> Structure:
    """What an invisible bracket holds; a sum in it needs a visible one, but the integrand ends with its variable."""
    end = _closing(text, at)
    raised = text[end : end + 1] in {"^", "_"}
    left, right = ("{", "}") if raised else ("", "") if bare else ("(", ")")
    return Structure((left, (at + 1, end - 1), right), end)


def _top_level(text: str, at: int, sign: str) -> bool:
    """Whether a sign stands in a bracket, in none of the brackets in it."""
    return next(_separators(text, at, sign), None) is not None


def _separators(text: str, at: int, signs: str) -> Iterator[int]:
    """Where these signs stand in the bracket that opens at a place, in none of the brackets in it."""
    place = at + 1
    end = _closing(text, at) - 1
    while place < end:
        if text[place] in _PAIRS:
            place = _closing(text, place)
            continue
        if text[place] in signs:
            yield place
        place += 1


def _closing(text: str, at: int) -> int:
    """One past the bracket that closes the one at a place.

    Raises:
        FormulaError: where none does.
    """
    waiting = [_PAIRS[text[at]]]
    for place in range(at + 1, len(text)):
        if text[place] in _PAIRS:
            waiting.append(_PAIRS[text[place]])
        elif text[place] == waiting[-1]:
            waiting.pop()
            if not waiting:
                return place + 1
    raise FormulaError(f"{text[at]} is never closed", span=(at, at + 1))
