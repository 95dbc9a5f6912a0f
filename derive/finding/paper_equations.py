r"""The equations of a paper's LaTeX source, displayed and within sentences, with their numbers and labels.

Nothing of the source is run: environments, labels and numbers are taken from its text, the author's commands are put
in as text.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from itertools import islice, pairwise

from radartrack.derive.formula.error import FormulaError
from radartrack.derive.reading.tex import latex_equations
from radartrack.derive.reading.tex.author_macros import Macro, defined_macros, expanded

MOST_CHARACTERS = 4_000_000
MOST_EQUATIONS = 1_500  # fewer than a claims file holds

_COMMENT = re.compile(r"(?<!\\)%[^\n]*")
_DISPLAY = re.compile(
    r"\\begin\{(?P<env>(?:equation|align|alignat|gather|multline|eqnarray|flalign)\*?)\}(?P<body>.*?)\\end\{(?P=env)\}"
    r"|\\\[(?P<bracket>.*?)\\\]|(?<!\\)\$\$(?P<dollars>.*?)\$\$",
    re.DOTALL,
)
_INLINE = re.compile(r"(?<![\\$])\$(?!\$)([^$]{1,600})(?<!\\)\$(?!\$)|\\\((.{1,600}?)\\\)", re.DOTALL)
_MATRIX = re.compile(r"\\begin\{([a-zA-Z]*matrix|array|cases)\}.*?\\end\{\1\}", re.DOTALL)
_ENVIRONMENT = re.compile(r"\\(?:begin|end)\s*\{")
_LABEL = re.compile(r"\\label\s*\{([^{}]*)\}")
_TAG = re.compile(r"\\(?:tag\*?\s*\{|l?eqno\s*[({])([^{}()]*)[)}]")
_UNNUMBERED = re.compile(r"\\(?:nonumber|notag)(?![a-zA-Z])")
_ARGUMENT = re.compile(r"^\s*\{\d+\}|^\s*\[[^\]]*\]")
_TITLE = re.compile(r"\\title\s*(?:\[[^\]]*\])?\s*\{((?:[^{}]|\{[^{}]*\})*)\}")
_COMMAND = re.compile(r"\\[a-zA-Z]+\*?|[{}~\\]")
_LINE = re.compile(r"\\\\")
_RELATED = re.compile(latex_equations.RELATION, re.VERBOSE)
_HIDDEN = "\x00"


@dataclass(frozen=True)
class Equation:
    """One equation of a paper.

    Attributes:
        number: in print, where it has one.
        label: by which the source refers to it.
        left: what is set.
        right: to what, as LaTeX.
        display: how many displays were before its own.
    """

    number: str
    label: str
    left: str
    right: str
    display: int = -1


def equations(source: str) -> list[Equation]:
    """The displayed equations of a source, with the numbers that they have in print.

    Raises:
        ValueError: when the source is too long.
    """
    found: list[Equation] = []
    count = 0
    macros, text = _without_macros(source)
    for place, display in enumerate(_DISPLAY.finditer(text)):
        environment = display["env"] or ""
        body = next(text for text in (display["body"], display["bracket"], display["dollars"]) if text is not None)
        body = _expanded(body, macros)
        numbered = bool(environment) and not environment.endswith("*")
        several = environment.rstrip("*") in {"align", "alignat", "gather", "eqnarray", "flalign"}
        for rows in _rows(_ARGUMENT.sub("", body)) if several else [[body]]:
            joined = "".join(rows)
            tag = _TAG.search(joined)
            counts = numbered and not tag and not all(_UNNUMBERED.search(row) for row in rows)
            count += counts
            found += _split(joined, tag[1].strip() if tag else str(count) if counts else "", place)
    return found[:MOST_EQUATIONS]


def equations_in_text(source: str) -> list[Equation]:
    """The equations within the sentences of a source, which say what letters stand for.

    Raises:
        ValueError: when the source is too long.
    """
    macros, text = _without_macros(source)
    sentences = _DISPLAY.sub(" ", text)
    formulas = ((one[1] or one[2]).strip() for one in _INLINE.finditer(sentences))
    found = (equation for formula in formulas if "=" in formula for equation in _split(_expanded(formula, macros)))
    return list(islice(found, MOST_EQUATIONS))


def title(source: str) -> str:
    """The title of a paper on one line, or that it has none."""
    said = _TITLE.search(_COMMENT.sub("", source))
    words = " ".join(_COMMAND.sub(" ", said[1]).split()) if said else ""
    return "".join(sign for sign in words if sign.isprintable()) or "untitled"


def _without_macros(source: str) -> tuple[dict[str, Macro], str]:
    """The author's commands, and the source without them and without comments."""
    if len(source) > MOST_CHARACTERS:
        raise ValueError(f"a source has at most {MOST_CHARACTERS} characters; given {len(source)}")
    macros, text = defined_macros(_COMMENT.sub("", source))
    return macros, _with_environments(text, macros)


def _expanded(formula: str, macros: dict[str, Macro]) -> str:
    """A formula by what the author's commands stand for; as it is where they cannot be put in, as reading it tells."""
    try:
        return expanded(formula, macros)
    except FormulaError:
        return formula


def _with_environments(source: str, macros: Mapping[str, Macro]) -> str:
    r"""The source with \begin{equation} for an author's \be, and the like."""
    short = {name: one.body for name, one in macros.items() if not one.count and _ENVIRONMENT.search(one.body)}
    if not short:
        return source
    used = re.compile(rf"\\({'|'.join(map(re.escape, short))})(?![A-Za-z])")
    return used.sub(lambda found: short[found[1]], source)


def _rows(body: str) -> list[list[str]]:
    """The rows of each of several equations; one that sets nothing goes on with the equation before it."""
    hidden = _MATRIX.sub(lambda found: _HIDDEN * len(found[0]), body)
    ends = [*(found.start() for found in _LINE.finditer(hidden)), len(body)]
    rows: list[list[str]] = []
    for start, end in pairwise([0, *ends]):
        if rows and not _RELATED.search(hidden, start, end):
            rows[-1].append(body[start:end])
        else:
            rows.append([body[start:end]])
    return rows


def _split(text: str, number: str = "", display: int = -1) -> Iterator[Equation]:
    """The equations of a line or of an inner environment, of which each has the number."""
    label = _LABEL.search(text)
    try:
        found = latex_equations.equations(text)
    except FormulaError:  # the reader will say what is wrong with it
        found = [latex_equations.Equation("", text)]
    for one in found:
        left, right = (" ".join(side.split()) for side in (one.left, one.right))
        if left and right:
            yield Equation(number, label[1].strip() if label else "", left, right, display)
