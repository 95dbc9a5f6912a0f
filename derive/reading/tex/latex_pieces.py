"""Cuts LaTeX into pieces: letters, digits, commands and brackets, without what sets spaces and sizes."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from types import MappingProxyType

from radartrack.derive.formula.error import FormulaError, Span
from radartrack.derive.formula.functions import VERBS
from radartrack.derive.formula.latex_names import ACCENTS, GREEK
from radartrack.derive.reading.tex.latex_letters import DECORATIONS, SAYS_NOTHING

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
VERB_WORDS = MappingProxyType(
    {
        name: name
        for name in VERBS
        if name in {"det", "diag", "expm", "eye", "inv", "kron", "norm", "outer", "trace", "transpose"}
    }
    | {"tr": "trace", "Tr": "trace"}
)
BOLD = frozenset({"\\mathbf", "\\boldsymbol", "\\bm", "\\pmb", "\\bf"})
CLOSERS = MappingProxyType(
    {"(": ")", "[": "]", "{": "}", "\\{": "\\}", "\\lvert": "\\rvert"}
    | {
        f"\\begin{{{name}}}": f"\\end{{{name}}}"
        for name in ("matrix", "pmatrix", "bmatrix", "Bmatrix", "smallmatrix", "array")
    }
)
_SAME = MappingProxyType(
    {"\\lbrace": "\\{", "\\rbrace": "\\}", "\\lbrack": "[", "\\rbrack": "]", "\\lparen": "(", "\\rparen": ")"}
)
_BEGIN = "\\begin"
_STAR = re.compile(r"[\w)\]}]\s*\*(?!\s*[{}])")  # between factors, not that of align* or of x^*
_DOUBLE = frozenset({"\\|", "\\Vert"})
_BRACKETS = frozenset(CLOSERS) | frozenset(CLOSERS.values())

_PIECE = re.compile(
    r"""
    (?P<space> \s+ | ~ | \\[,;:!>\ \n]
        | \\(?:quad|qquad|enspace|thinspace|negthinspace|medspace|thickspace|displaystyle|textstyle|scriptstyle
            |limits|nolimits|hfill|strut|relax|mathop|mathrel|mathord|mathstrut)(?![A-Za-z])
        | \\(?:hspace|vspace|phantom|hphantom|vphantom|mspace)\*?\s*\{[^{}]*\}
        | \\(?:text|mbox|textrm)\s*\{\s*[.,;]?\s*\}
        | (?:(?<=\\\|)|(?<=Vert))_(?:2(?!\d)|\{2\})
        | \\(?:left|right|[bB]igg?[lrm]?)(?![A-Za-z])
          (?=\s*(?:[()\[\]]|\\[{}]|\\[lr](?:[vV]ert|brace|brack|paren)(?![A-Za-z]))) )
    | (?P<left_bar> \\lVert(?![A-Za-z]) | \\(?:left|[bB]igg?l)\s*(?:\\?\||\\[vV]ert(?![A-Za-z])) )
    | (?P<right_bar> \\rVert(?![A-Za-z]) | \\(?:right|[bB]igg?r)\s*(?:\\?\||\\[vV]ert(?![A-Za-z])) )
    | (?P<bar> \\?\||\\[vV]ert(?![A-Za-z]) )
    | (?P<environment> \\(?:begin|end)\s*\{\s*(?P<kind>[A-Za-z]+)\s*\}
        (?:(?<=array\})\s*\{(?:[lcr|@*\d\s]|\{[^{}]*\})*\})? )
    | (?P<newline> \\\\(?:\s*\[\s*-?[\d.]+\s*[a-z]{2}\s*\])? )
    | (?P<word> \\(?:mathrm|mathit|mathsf|text|textrm|mbox|operatorname\*?)
        (?: \s*\{\s*(?P<braced>(?:[A-Za-z0-9]|\\_)+)\s*\} | \s+(?P<single>[A-Za-z]) ) )
    | (?P<command> \\[A-Za-z]+ | \\. )
    | (?P<digit> [0-9.] )
    | (?P<letter> [A-Za-z] )
    | (?P<sign> . )
    """,
    re.VERBOSE | re.DOTALL,
)
_PROSE = re.compile(r"\\(?:text|textrm|mbox)\s*\{(?:\s|[^{}]*\s\}$)")
_COMMANDS = MappingProxyType(
    dict.fromkeys(GREEK, "greek")
    | dict.fromkeys((*ACCENTS, *DECORATIONS, *SAYS_NOTHING), "accent")
    | {f"\\{name}": "function" for name in (*FUNCTIONS, *VERB_WORDS)}
    | dict.fromkeys((*BOLD, "\\mathcal", "\\mathbb", "\\mathscr", "\\mathnormal", "\\cal", "\\it", "\\sf"), "font")
    | dict.fromkeys(("\\mathit", "\\mathsf", "\\mathrm", "\\textbf", "\\operatorname"), "font")
    | dict.fromkeys(("\\top", "\\intercal", "\\dagger", "\\ast", "\\star"), "beside")
    | dict.fromkeys(("\\frac", "\\dfrac", "\\tfrac", "\\cfrac"), "fraction")
    | {"\\sqrt": "root", "\\cdot": "times", "\\times": "times", "\\rm": "roman", "\\prime": "prime"}
    | {"\\sum": "bigsum", "\\int": "integral", "\\over": "over"}
    | dict.fromkeys(("\\mid", "\\vert"), "bar")
    | dict.fromkeys(("\\circ", "\\degree"), "degree")
    | dict.fromkeys(("\\abs", "\\norm"), "bars")
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
        ";": "semicolon",
        "&": "column",
        "'": "prime",
        "=": "equals",
    }
)
_UNREAD = MappingProxyType(
    dict.fromkeys(("\\pm", "\\mp"), "a formula has one sign: write + or -")
    | dict.fromkeys(
        ("\\prod", "\\lim", "\\partial", "\\ldots", "\\cdots", "\\iint", "\\oint"),
        "write it out in closed form",
    )
    | dict.fromkeys(("\\left", "\\right", "\\middle"), "a bracket follows it: ( ) [ ] \\{ \\} or |")
    | dict.fromkeys(("\\text", "\\textrm", "\\mbox"), "it holds one word of letters and digits")
    | dict.fromkeys(("\\tag", "\\label"), "leave it out")
    | {
        "\\lg": "write \\frac{\\ln x}{\\ln 10}",
        "\\div": "write \\frac{...}{...}",
        "\\begin{cases}": "give the branch that is meant",
        "\\begin{dcases}": "give the branch that is meant",
        "!": "factorials are not read",
    }
)


@dataclass(frozen=True, slots=True)
class Piece:
    """A piece of LaTeX: what it is, what it says, where it stands, whether it is set bold, or is a word of letters."""

    kind: str
    text: str
    span: Span
    is_bold: bool = False
    is_typed: bool = False


def is_typed(source: str) -> bool:
    """Whether factors are parted by `*`, as whoever types code writes them."""
    return _STAR.search(source) is not None


def pieces(source: str) -> list[Piece]:
    """Everything in a formula that is printed, in order.

    Raises:
        FormulaError: for the first thing that formulas do not use.
    """
    return [_piece(found) for found in _PIECE.finditer(source) if found.lastgroup != "space"]


def _piece(found: re.Match[str]) -> Piece:
    kind, text = found.lastgroup or "", found.group()
    match kind:
        case "environment":
            text = f"\\{'begin' if text.startswith(_BEGIN) else 'end'}{{{found['kind']}}}"
        case "word":
            if _PROSE.match(text):
                raise FormulaError("words between formulas are not read: leave them out", span=found.span())
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


def with_typed_words(found: Sequence[Piece], names: Collection[str]) -> list[Piece]:
    r"""The pieces with px and atan as words, as they stand in code.

    Letters that are known one by one stay a product.
    """
    result: list[Piece] = []
    for piece in found:
        before = result[-1] if result else None
        goes_on = before is not None and before.kind in {"letter", "typed"} and before.span[1] == piece.span[0]
        if before and goes_on and (piece.kind == "letter" or (piece.kind == "digit" and piece.text != ".")):
            result[-1] = Piece("typed", before.text + piece.text, (before.span[0], piece.span[1]))
        else:
            result.append(piece)
    whole = (one.kind == "typed" and (one.text in names or not set(one.text) <= set(names)) for one in result)
    return [
        part
        for one, is_word in zip(result, whole, strict=True)
        for part in ([replace(one, kind="word", is_typed=True)] if is_word else _one_by_one(one))
    ]


def _one_by_one(piece: Piece) -> list[Piece]:
    if piece.kind != "typed":
        return [piece]
    places = enumerate(piece.text, piece.span[0])
    return [Piece("digit" if sign.isdigit() else "letter", sign, (at, at + 1)) for at, sign in places]


def sided(found: Iterable[Piece]) -> Iterator[Piece]:
    """Tell plain bars apart: one closes when the innermost open bracket is a plain bar, else it opens.

    In a subscript, as in k|k-1, a bar is neither.
    """
    waiting: list[str] = []
    before = ""
    for piece in found:
        kind, text = piece.kind, piece.text
        if kind == "bar" and text not in _DOUBLE and ("subscript" in waiting or before == "lowered"):
            kind, text = "given", "|"
        bar = "norm" if text in _DOUBLE else "bar"
        if kind == "bar":
            closes = bool(waiting) and waiting[-1] == bar
            kind, text = ("close", "\\rvert") if closes else ("open", "\\lvert")
        if kind == "open":
            waiting.append("subscript" if before == "lowered" else bar if piece.kind == "bar" else piece.kind)
        elif kind == "close" and waiting:
            waiting.pop()
        before = kind
        yield replace(piece, kind=kind, text=text)
