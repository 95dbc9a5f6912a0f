r"""Formulas as algebra systems print them, in the notation of typed ones, each sign where it stood.

SymPy and Maple write Matrix([[a, b]]) and Abs(x); Mathematica {a, b}, Sqrt[x], r Cos[b] and \[Beta], and its
ArcTan[x, y] takes the abscissa first.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Mapping, Sequence

from radartrack.derive.formula.error import Span
from radartrack.derive.formula.functions import SPELLINGS

LONGEST_WORD = 24  # ImmutableDenseMatrix and some spaces
_WORD_BEFORE = re.compile(r"(?<![\w.])[A-Za-z][A-Za-z0-9]*\Z")
_MATRIX = re.compile(r"(?:(?:Immutable|Mutable)?(?:Dense|Sparse)?M|m)atrix")
_LETTER = re.compile(r"\\\[(?:Capital|Curly)?(?P<name>[A-Z][a-z]+)\]")
# Factors with a space between, but for words that part equations.
_SIDE_BY_SIDE = re.compile(
    r"(?<=[\w)\]])(?<!\bwhere)(?<!\bwith)(?<!\band)[ \t](?=[ \t]*[A-Za-z0-9_(])(?!\s*(?:where|with|and)\b)"
)
_PI = re.compile(r"(?<![\w.])Pi(?!\w)")


def with_plain_letters(text: str) -> str:
    r"""The text, as long, with \[Beta] as beta, which is how the front end of Mathematica writes letters."""
    return _LETTER.sub(lambda found: found["name"].lower().ljust(len(found.group())), text)


def with_plain_functions(
    text: str, brackets: Sequence[tuple[str, Span]], pairs: Mapping[int, int], names: Collection[str]
) -> str:
    """The text, as long, with functions and arrays as one types them.

    Args:
        text: the formula.
        brackets: all of them, with where they stand.
        pairs: which one closes which, by their order, inner ones first: what is turned around them moves them.
        names: the symbols, which are no functions.
    """
    signs = list(text)
    is_mathematica = False
    for opener, closer in pairs.items():
        (start, _), (end, _) = brackets[opener][1], brackets[closer][1]
        word = _WORD_BEFORE.search(text, max(start - LONGEST_WORD, 0), start)
        if text[start] == "{":
            if _is_list(text, start, end):
                signs[start], signs[end] = "[", "]"
        elif word and word[0] not in names and _MATRIX.fullmatch(word[0]) and text[start] == "(":
            signs[word.start() : start] = " " * len(word[0])
        elif word and word[0] not in names and word[0].lower() in SPELLINGS.keys() - {word[0]}:
            signs[word.start() : start + 1] = f"{word[0].lower()}("
            signs[end] = ")"
            is_mathematica |= text[start] == "["
            if text[start] == "[" and word[0] == "ArcTan":
                _turn(signs, word.start(), start, end)
    plain = "".join(signs) if "Pi" in names else _PI.sub("pi", "".join(signs))
    return _SIDE_BY_SIDE.sub("*", plain) if is_mathematica else plain


def _is_list(text: str, start: int, end: int) -> bool:
    """Whether braces are around the entries of an array: no exponent, and no deviations of an expectation."""
    inside = text[start + 1 : end]
    return "," in inside and ":" not in inside and text[:start].rstrip()[-1:] not in {"^", "_"}


def _turn(signs: list[str], name: int, start: int, end: int) -> None:
    """ArcTan[x, y] as atan2(y, x), as long."""
    depth = 0
    for at in range(start + 1, end):
        depth += (signs[at] in "([{") - (signs[at] in ")]}")
        if signs[at] == "," and depth == 0:
            signs[start + 1 : end] = [*signs[at + 1 : end], ",", *signs[start + 1 : at]]
            signs[name:start] = "atan2".rjust(start - name)
            return
