"""Cuts LaTeX into pieces: letters, digits, commands and brackets, without what sets spaces and sizes."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from types import MappingProxyType

from radartrack.derive.formula.error import FormulaError, Span
from radartrack.derive.formula.latex_names import ACCENTS, GREEK

FUNCTIONS = MappingProxyType(
    {
        "arccos": "acos",
        "arcsin": "asin",
        "arctan": "atan",
        "arctg": "atan",
        "ch": "cosh",
        "cos": "cos",
        "cosh": "cosh",
        "cot": "cot",
        "coth": "coth",
        "csc": "csc",
        "ctg": "cot",
        "exp": "exp",
        "ln": "log",
        "log": "log",
        "sec": "sec",
        "sh": "sinh",
        "sin": "sin",
        "sinh": "sinh",
        "tan": "tan",
        "tanh": "tanh",
        "tg": "tan",
        "th": "tanh",
    }
)
CLOSERS = MappingProxyType(
    {"(": ")", "[": "]", "{": "}", "\\{": "\\}", "\\lvert": "\\rvert"}
    | {f"\\begin{{{name}}}": f"\\end{{{name}}}" for name in ("matrix", "pmatrix", "bmatrix", "Bmatrix", "array")}
)
_SAME = MappingProxyType(
    {"\\lbrace": "\\{", "\\rbrace": "\\}", "\\lbrack": "[", "\\rbrack": "]", "\\lparen": "(", "\\rparen": ")"}
)
_BEGIN = "\\begin"
_BRACKETS = frozenset(CLOSERS) | frozenset(CLOSERS.values())

_PIECE = re.compile(
    r"""
    (?P<space> \s+ | ~ | \\[,;:!>\ \n]
        | \\(?:quad|qquad|displaystyle|textstyle|limits|nolimits)(?![A-Za-z])
        | \\(?:left|right|[bB]igg?[lr]?)(?![A-Za-z])
          (?=\s*(?:[()\[\]]|\\[{}]|\\[lr](?:vert|brace|brack|paren)(?![A-Za-z]))) )
    | (?P<left_bar> \\(?:left|[bB]igg?l)\s*(?:\||\\vert(?![A-Za-z])) )
    | (?P<right_bar> \\(?:right|[bB]igg?r)\s*(?:\||\\vert(?![A-Za-z])) )
    | (?P<bar> \||\\vert(?![A-Za-z]) )
    | (?P<environment> \\(?:begin|end)\s*\{\s*(?P<kind>[A-Za-z]+)\s*\}(?:(?<=array\})\s*\{[lcr|\s]*\})? )
    | (?P<newline> \\\\(?:\s*\[\s*-?[\d.]+\s*[a-z]{2}\s*\])? )
    | (?P<word> \\(?:mathrm|mathit|mathsf|text|textrm|operatorname\*?)
        (?: \s*\{\s*(?P<braced>(?:[A-Za-z0-9]|\\_)+)\s*\} | \s+(?P<single>[A-Za-z]) ) )
    | (?P<command> \\[A-Za-z]+ | \\. )
    | (?P<digit> [0-9.] )
    | (?P<letter> [A-Za-z] )
    | (?P<sign> . )
    """,
    re.VERBOSE | re.DOTALL,
)
_COMMANDS = MappingProxyType(
    dict.fromkeys(GREEK, "greek")
    | dict.fromkeys(ACCENTS, "accent")
    | {f"\\{name}": "function" for name in FUNCTIONS}
    | dict.fromkeys(("\\frac", "\\dfrac", "\\tfrac", "\\cfrac"), "fraction")
    | {"\\sqrt": "root", "\\cdot": "times", "\\times": "times", "\\rm": "roman"}
)
_SIGNS = MappingProxyType(
    {
        "+": "plus",
        "-": "minus",
        "*": "times",
        "/": "slash",
        "^": "raised",
        "_": "lowered",
        ",": "comma",
        "&": "column",
    }
)
_UNREAD = MappingProxyType(
    dict.fromkeys(("\\pm", "\\mp"), "a formula has one sign: write + or -")
    | dict.fromkeys(
        ("\\sum", "\\prod", "\\int", "\\lim", "\\partial", "\\ldots", "\\cdots"),
        "write it out in closed form",
    )
    | dict.fromkeys(("\\hat", "\\bar", "\\tilde", "\\vec", "\\widehat", "\\overline"), "leave the accent out")
    | dict.fromkeys(
        ("\\mathbf", "\\boldsymbol", "\\bm", "\\mathcal", "\\bf"),
        "write the letter plain, or in \\mathrm{...}",
    )
    | dict.fromkeys(("\\circ", "\\degree"), "angles are in radians")
    | dict.fromkeys(("\\left", "\\right", "\\middle"), "a bracket follows it: ( ) [ ] \\{ \\} or |")
    | dict.fromkeys(("\\mathrm", "\\text", "\\operatorname"), "it holds one word of letters and digits")
    | dict.fromkeys(("\\tag", "\\label", "\\nonumber", "$", "\\(", "\\)", "\\[", "\\]"), "leave it out")
    | dict.fromkeys(("\\|", "\\Vert", "\\lVert", "\\rVert"), "norms are not read: write the root of a sum of squares")
    | {
        "\\lg": "write \\frac{\\ln x}{\\ln 10}",
        "\\over": "write \\frac{...}{...}",
        "\\div": "write \\frac{...}{...}",
        "=": "give the right-hand side alone",
        "%": "comments have no place in a formula",
        "'": "primes are not read: write \\dot{r} or a name of its own",
        "!": "factorials are not read",
    }
)


@dataclass(frozen=True, slots=True)
class Piece:
    """A piece of LaTeX: what it is, what it says, where it stands."""

    kind: str
    text: str
    span: Span


def pieces(source: str) -> list[Piece]:
    """Everything in a formula that is printed, in order; bars are told apart into opening and closing ones.

    Raises:
        FormulaError: for the first thing that formulas do not use.
    """
    return list(_sided(_piece(found) for found in _PIECE.finditer(source) if found.lastgroup != "space"))


def _piece(found: re.Match[str]) -> Piece:
    kind, text = found.lastgroup or "", found.group()
    match kind:
        case "environment":
            text = f"\\{'begin' if text.startswith(_BEGIN) else 'end'}{{{found['kind']}}}"
        case "word":
            text = (found["braced"] or found["single"]).replace("\\_", "_")
        case "left_bar" | "right_bar":
            text = "\\lvert" if kind == "left_bar" else "\\rvert"
        case "command":
            text = _SAME.get(text, text)
            kind = _COMMANDS.get(text, kind)
        case "sign":
            kind = _SIGNS.get(text, kind)
    if text in _BRACKETS:
        kind = "open" if text in CLOSERS else "close"
    if kind in {"command", "environment", "sign"}:
        raise FormulaError(
            f"{text} is not read: {_UNREAD.get(text, 'it has no meaning in a formula')}", span=found.span()
        )
    return Piece(kind, text, found.span())


def _sided(found: Iterable[Piece]) -> Iterator[Piece]:
    """Tell plain bars apart: one closes when the innermost open bracket is a plain bar, else it opens."""
    waiting: list[str] = []
    for piece in found:
        kind, text = piece.kind, piece.text
        if kind == "bar":
            closes = bool(waiting) and waiting[-1] == "bar"
            kind, text = ("close", "\\rvert") if closes else ("open", "\\lvert")
        if kind == "open":
            waiting.append(piece.kind)
        elif kind == "close" and waiting:
            waiting.pop()
        yield Piece(kind, text, piece.span)
