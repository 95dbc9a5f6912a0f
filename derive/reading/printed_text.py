"""Text as it comes out of a printed page: c₁₁ = r²σβ² sin²β + σr² cos²β, with signs and letters that no keyboard has.

It is put into LaTeX, whose grammar knows what belongs to what on a page; where each character came from is kept.
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Collection, Iterator, Mapping
from dataclasses import dataclass
from types import MappingProxyType

from radartrack.derive.formula.error import FormulaError, Span
from radartrack.derive.formula.fold import rebuild
from radartrack.derive.formula.functions import SPELLINGS
from radartrack.derive.formula.latex_names import GREEK
from radartrack.derive.formula.shape import NO_SHAPES, Shape
from radartrack.derive.formula.tree import Tree, with_span
from radartrack.derive.formula.unknown_names import check_names
from radartrack.derive.reading.characters import (
    LATIN,
    MAX_PRINTED,
    check_characters,
    is_mathematical,
    without_alphabets,
)
from radartrack.derive.reading.linear_format import SIGNS, structure_at
from radartrack.derive.reading.tex.latex import read_latex
from radartrack.derive.reading.tex.latex_pieces import FUNCTIONS, VERB_WORDS
from radartrack.derive.reading.text import read_text

_SIGNS = MappingProxyType(
    {
        **dict.fromkeys("−–—‐‒", "-"),
        **dict.fromkeys("×·⋅∙•∗⨯*", r"\cdot "),
        **dict.fromkeys("÷∕⁄", "/"),
        **dict.fromkeys("   \u2009\u200a\u202f\u00a0\u2002\u2003\u2061\u2062", " "),
        **dict.fromkeys("′ʹ’", "'"),
        "∣": "|",
        **dict.fromkeys("‖∥", r"\|"),
        "≈": r"\approx ",
        "≡": r"\equiv ",
        "≜": r"\triangleq ",
        "∑": r"\sum ",
        "∫": r"\int ",
        "ᵀ": r"^{\top}",
        "⊤": r"\top ",
        "{": r"\{",
        "}": r"\}",
        "∆": r"\Delta ",
        "°": r"^{\circ}",
    }
)
_FUNCTIONS = "|".join(sorted((*SPELLINGS, "tg", "ctg", "diag", "det", "tr"), key=len, reverse=True))
_TOKEN = re.compile(
    r"""
    (?P<accented> [A-Za-z](?=[\u0302-\u0305\u0307\u0308]) )
    | (?P<name> [A-Za-z][A-Za-z0-9]*_[A-Za-z0-9_]+ )
    | (?P<word> atan2 | expm1 | (?:[A-Za-z](?![\u0302-\u0305\u0307\u0308]))+\d* )
    | (?P<decimal> (?:\d+\.\d+|\d+) )
    | (?P<power> \*\* | \^ )
    | (?P<lowered> _ )
    | (?P<root> √ )
    | (?P<other> . )
    """,
    re.VERBOSE | re.DOTALL,
)
_MATHEMATICAL = re.compile(
    rf"(?P<letters>[{LATIN}]{{2,}})|[\u00c0-\u024f\u1e00-\u1eff]|[^{LATIN}\u00c0-\u024f\u1e00-\u1eff]+|.", re.DOTALL
)
_WITH_ARGUMENT = MappingProxyType({"power": "^{", "lowered": "_{", "root": r"\sqrt{"})
_FUNCTION_BEHIND = re.compile(rf"(?P<letter>[A-Za-z]?)(?P<function>{_FUNCTIONS})")
_COMBINING = MappingProxyType(
    {
        "\u0302": r"\hat",
        "\u0303": r"\tilde",
        "\u0304": r"\bar",
        "\u0305": r"\bar",
        "\u0307": r"\dot",
        "\u0308": r"\ddot",
    }
)
_DOTS = MappingProxyType({"\u0307": "dot", "\u0308": "ddot"})
_NOT_ASCII = re.compile(r"[^\x00-\x7f]")


def is_printed(text: str) -> bool:
    """Whether a text has letters or signs of a printed page."""
    return any(_known(character) for character in set(_NOT_ASCII.findall(text)))


def read_printed_text(
    text: str,
    names: Collection[str] | None,
    shapes: Mapping[str, Shape] = NO_SHAPES,
    *,
    strangers: bool = False,
    wanted: int = 1,
) -> Tree:
    """Read text that was copied from a page.

    Raised and lowered digits are exponents and subscripts, Greek letters are symbols, factors may stand side by side;
    a letter that touches a σ is its subscript, as it was in print: σβ² is sigma_beta squared. Of an equation the right
    side is read.

    Args:
        text: the formula.
        names: the symbols; None where none are known, and every name is let through.
        shapes: of those that stand for arrays.
        strangers: whether names that are not known are let through.
        wanted: of how many numbers it is to be.

    Raises:
        FormulaError: when it is no such formula, is ambiguous, or too large.
    """
    allowed = check_names(names or ())
    given, (text, places) = text, _with_plain_letters(text)
    is_typed = "*" in text  # products are written out, as one types them, only with other letters
    if len(text) > MAX_PRINTED:
        raise FormulaError(f"the formula has {len(text)} characters; at most {MAX_PRINTED} are read")
    try:
        known = _Known(allowed, strangers or names is None, "∫" in text)
        source, origins = _as_typed(text, allowed) if is_typed else _as_latex(text, known)
    except FormulaError as error:
        raise error.at(given, _back(error.span, places)) from None
    origins = [places[origin] for origin in origins]
    try:
        tree = (read_text if is_typed else read_latex)(source, names, shapes, strangers=strangers, wanted=wanted)
    except FormulaError as error:
        raise error.at(given, _back(error.span, origins)) from None
    return rebuild(tree, lambda node: with_span(node, _back(node.span, origins)))


def _with_plain_letters(text: str) -> tuple[str, list[int]]:
    """The text with plain letters for mathematical ones, each of which is a symbol, and where each sign stood.

    What stands over a letter stands behind it then: ẋ is x and a dot.
    """
    parts: list[str] = []
    places: list[int] = []
    for found in _MATHEMATICAL.finditer(text):
        if accented := _taken_apart(found.group()):
            parts.append(accented)
            places += [found.start()] * len(accented)
            continue
        said = without_alphabets(found.group())
        is_product = found["letters"] and not _FUNCTION_BEHIND.fullmatch(said)
        step = 2 if is_product else 1
        parts.append(" ".join(said) if is_product else said)
        places += [found.start() + at // step for at in range(len(parts[-1]))]
    return "".join(parts), [*places, len(text)]


def _taken_apart(character: str) -> str:
    """A letter and what stands over it, of a character that is both; nothing of others."""
    apart = unicodedata.normalize("NFD", character) if len(character) == 1 and not character.isascii() else ""
    return apart if len(apart) == 2 and apart[1] in _COMBINING and (apart[0].isascii() or _greek(apart[0])) else ""


def _as_latex(text: str, known: _Known) -> tuple[str, list[int]]:
    """The formula in LaTeX, and the place in the text of each of its characters."""
    pieces: list[str] = []
    origins: list[int] = []
    for latex, place in _pieces(text, known):
        pieces.append(latex)
        origins += [place] * len(latex)
    return "".join(pieces), [*origins, len(text)]


def _as_typed(text: str, names: frozenset[str]) -> tuple[str, list[int]]:
    """The formula as one types it: letters by their names, raised digits as powers."""
    pieces: list[str] = []
    origins: list[int] = []
    at = 0
    while at < len(text):
        end = at + 1
        place = "" if text[at].isascii() else _place(text[at])
        while place and end < len(text) and _place(text[end]) == place:
            end += 1
        typed = _typed(text[at:end], place, text, at, names)
        pieces.append(typed)
        origins += [at] * len(typed)
        at = end
    return "".join(pieces), [*origins, len(text)]


def _typed(said: str, place: str, text: str, at: int, names: frozenset[str]) -> str:
    fraction = re.fullmatch(r"(\d+)\N{FRACTION SLASH}(\d+)", unicodedata.normalize("NFKC", said))
    if said.isascii():
        return said
    if said in _COMBINING:  # ẋ is xdot, and a hat says nothing
        return _DOTS.get(said, "")
    if place:
        inside = "".join(map(_plain, said)).strip()
        return f"**({inside})" if place == "^" else f"_{inside}".replace("\\", "")
    if fraction:
        return f"({fraction[1]}/{fraction[2]})"
    known = {r"\cdot ": "*", r"\Delta ": "Delta", r"^{\circ}": "*pi/180", r"\|": "|"}
    typed = known.get(_SIGNS[said], _SIGNS[said]) if said in _SIGNS else _greek(said).removeprefix("\\")
    typed = "sqrt" if said == "√" else typed
    if not typed or typed.startswith(("\\", "^")):
        check_characters(" " * at + text[at], names)
    return typed


@dataclass(frozen=True)
class _Known:
    """What is known of a text: names, whether others are let through, whether it has an integral."""

    names: frozenset[str]
    free: bool
    integrates: bool


def _pieces(text: str, known: _Known) -> Iterator[tuple[str, int]]:
    at = 0
    while at < len(text):
        if structure := structure_at(text, at):
            for part in structure.parts:
                if isinstance(part, str):
                    yield part, at
                else:
                    inside = _pieces(text[slice(*part)], known)
                    yield from ((latex, part[0] + place) for latex, place in inside)
            at = structure.end
            continue
        found = _TOKEN.match(text, at)
        if found is None:
            break
        kind, said = found.lastgroup or "", found.group()
        if kind == "name":
            yield _name(said), at
        elif kind == "word":
            yield from _word(said, at, known)
        elif kind in _WITH_ARGUMENT:
            end = (_root_end if kind == "root" else _argument)(text, found.end())
            start, stop = _without_brackets(text, found.end(), end) if kind != "root" else (found.end(), end)
            yield _WITH_ARGUMENT[kind], at
            for latex, place in _pieces(text[start:stop], known):
                yield latex, start + place
            yield "}", max(end - 1, at)
            at = end
            continue
        else:
            latex, length = (said, len(said)) if kind == "decimal" else _sign(text, at, known)
            yield latex, at
            at += length
            continue
        at = found.end()


def _name(said: str) -> str:
    return r"\mathrm{" + said.replace("_", r"\_") + "}"


def _word(said: str, at: int, known: _Known) -> Iterator[tuple[str, int]]:
    """A known name, a function, a letter before one (rcos), or letters side by side, perhaps with digits behind."""
    letters = said.rstrip("0123456789")
    if said in known.names and len(said) > 1:
        yield _name(said), at
    elif said in SPELLINGS:
        yield _function(said), at
    elif letters != said:
        yield from _word(letters, at, known)
        yield said[len(letters) :], at + len(letters)
    elif applied := _FUNCTION_BEHIND.fullmatch(said):
        yield applied["letter"], at
        yield _function(applied["function"]), at + len(applied["letter"])
    elif len(said) == len("dx") and said[0] == "d" and known.integrates:
        yield f"{said[0]} {said[1]}", at
    elif len(said) > 1 and (known.free or not set(said) <= known.names):
        yield _name(said), at
    else:
        yield said, at


def _function(name: str) -> str:
    """A function in LaTeX, by the command that it has."""
    command = {"asin": "arcsin", "acos": "arccos", "atan": "arctan"}.get(name, name)
    return f"\\{command} " if command in FUNCTIONS or command in VERB_WORDS else rf"\operatorname{{{command}}}"


def _argument(text: str, at: int) -> int:
    """Where what is raised or lowered by a typed sign ends: a bracket, a signed number, a word, or one sign."""
    found = re.compile(r"\s*(?:-?\d+(?:\.\d+)?|[A-Za-z]+|[^\x00-\x7f])?").match(text, at)
    end = found.end() if found else at
    if end < len(text) and text[end] in "({" and not text[at:end].strip():
        return _closing(text, end)
    return end


def _without_brackets(text: str, start: int, end: int) -> tuple[int, int]:
    """What is in the bracket that is all there is from one place to another; a raised letter in one is no exponent."""
    is_one = text[start : start + 1] in {"(", "{"} and _closing(text, start) == end
    is_index = text[start : start + 1] == "(" and end - start == len("(k)") and text[start + 1].isalpha()
    return (start + 1, end - 1) if is_one and not is_index else (start, end)


def _root_end(text: str, at: int) -> int:
    """Where the radicand ends: a bracket, or one letter or number with what is raised and lowered there."""
    if at < len(text) and text[at] == "(":
        return _closing(text, at)
    found = re.compile(r"\s*(?:\d+(?:\.\d+)?|[A-Za-z]|\w)?").match(text, at)
    return found.end() if found else at


def _closing(text: str, at: int) -> int:
    opening, closing = text[at], {"(": ")", "{": "}"}[text[at]]
    depth = 0
    for end in range(at, len(text)):
        depth += (text[end] == opening) - (text[end] == closing)
        if not depth:
            return end + 1
    return len(text)


def _sign(text: str, at: int, known: _Known) -> tuple[str, int]:
    """A sign or a letter that is no ASCII, in LaTeX, and how many characters it takes."""
    character, after = text[at], text[at + 1 : at + 2]
    if character.isalpha() and character.isascii() and after in _COMBINING:
        return f"{_COMBINING[after]}{{{character}}}", 2
    if character in _SIGNS:
        return _SIGNS[character], 1
    if character.isascii():
        return character, 1
    if fraction := re.fullmatch(r"(\d+)\N{FRACTION SLASH}(\d+)", unicodedata.normalize("NFKC", character)):
        return f"\\frac{{{fraction[1]}}}{{{fraction[2]}}}", 1
    if place := _place(character):
        end = at
        while end < len(text) and _place(text[end]) == place:
            end += 1
        return f"{place}{{{''.join(map(_plain, text[at:end]))}}}", end - at
    greek = _greek(character)
    if not greek:
        _refuse(text, at, known.names)
    return _greek_letter(greek, text, at, known)


def _greek_letter(greek: str, text: str, at: int, known: _Known) -> tuple[str, int]:
    """A Greek letter with what stands over it, a deviation with what it is of; and how many characters that takes."""
    after = text[at + 1 : at + 2]
    if after in _COMBINING:
        return f"{_COMBINING[after]}{{{greek}}}", 2
    if greek == r"\sigma" and (below := _greek(after) or (after if after.isascii() and after.isalpha() else "")):
        name = f"sigma_{below.removeprefix(chr(92))}"
        if name in known.names or (known.free and not _continues(text, at + 2)):
            return rf"\sigma_{{{below}}}", 2
    return f"{greek} ", 1


def _continues(text: str, at: int) -> bool:
    """Whether a word of letters goes on here, so that the one before is not alone."""
    return at < len(text) and text[at].isascii() and text[at].isalpha() and text[at - 1].isascii()


def _known(character: str) -> bool:
    is_sign = character in _SIGNS or character in _COMBINING or character in SIGNS or character == "√"
    return (
        is_sign
        or is_mathematical(character)
        or unicodedata.decomposition(character).startswith("<fraction>")
        or bool(_place(character) or _greek(character) or _taken_apart(character))
    )


def _place(character: str) -> str:
    """How a character that is raised or lowered is set, by ^ or _."""
    how = unicodedata.decomposition(character)
    raised, lowered = how.startswith("<super>"), how.startswith("<sub>")
    return ("^" if raised else "_") if (raised or lowered) and _plain(character) else ""


def _plain(character: str) -> str:
    plain = unicodedata.normalize("NFKC", character).replace("\N{MINUS SIGN}", "-")
    return plain if plain.isascii() else (f"{_greek(plain)} " if _greek(plain) else "")


def _greek(character: str) -> str:
    """The command of a Greek letter, be it a mathematical one."""
    plain = unicodedata.normalize("NFKC", character) if character else ""
    name = unicodedata.name(plain, "") if len(plain) == 1 else ""
    found = re.fullmatch(r"GREEK (?:(SMALL|CAPITAL) LETTER (?:FINAL )?|)(?P<word>[A-Z]+)(?: SYMBOL)?", name)
    word = found["word"].lower().replace("lamda", "lambda") if found else ""
    command = "\\" + (word.capitalize() if found and found[1] == "CAPITAL" else word)
    return command if command in GREEK else ""


def _refuse(text: str, at: int, names: frozenset[str]) -> None:
    check_characters(" " * at + text[at], names)


def _back(span: Span | None, origins: list[int]) -> Span | None:
    if span is None:
        return None
    last = len(origins) - 1
    start, end = origins[min(span[0], last)], origins[min(max(span[1] - 1, 0), last)] + 1
    return start, max(end, start)
