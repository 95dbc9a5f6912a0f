r"""Drafts a claims file from a paper's LaTeX source: its equations, each found in the catalogue or left undecided.

Nothing of the source is run: environments, labels and numbers are taken from its text, formulas by the reader, and the
author's commands are put in as text.
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass
from itertools import islice

from radartrack.derive.finding.formula_search import Candidate
from radartrack.derive.formula.error import FormulaError
from radartrack.derive.formula.fold import rebuild
from radartrack.derive.formula.printing import to_text
from radartrack.derive.formula.tree import Name, Tree, names
from radartrack.derive.reading.any_letters import read_loosely
from radartrack.derive.reading.notation import LATEX
from radartrack.derive.reading.tex.author_macros import Macro, defined_macros, expanded
from radartrack.derive.reading.tex.latex_equations import without_braces

MOST_CHARACTERS = 4_000_000
MOST_EQUATIONS = 1_500  # fewer than a claims file holds
DEEPEST = 8  # definitions of definitions
NOTE = 600  # characters of a formula that are quoted

_COMMENT = re.compile(r"(?<!\\)%[^\n]*")
_DISPLAY = re.compile(
    r"\\begin\{(?P<env>(?:equation|align|alignat|gather|multline|eqnarray|flalign)\*?)\}(?P<body>.*?)\\end\{(?P=env)\}"
    r"|\\\[(?P<bracket>.*?)\\\]|(?<!\\)\$\$(?P<dollars>.*?)\$\$",
    re.DOTALL,
)
_INLINE = re.compile(r"(?<!\\)\$(?P<dollars>[^$]{3,300})(?<!\\)\$|\\\((?P<bracket>.{3,300}?)\\\)", re.DOTALL)
_INNER = re.compile(r"\\begin\{(aligned|split|gathered)\}(.*?)\\end\{\1\}", re.DOTALL)
_MATRIX = re.compile(r"\\begin\{([a-zA-Z]*matrix|array|cases)\}.*?\\end\{\1\}", re.DOTALL)
_ENVIRONMENT = re.compile(r"\\(?:begin|end)\s*\{")
_LABEL = re.compile(r"\\label\s*\{([^{}]*)\}")
_TAG = re.compile(r"\\tag\*?\s*\{([^{}]*)\}")
_UNNUMBERED = re.compile(r"\\(?:nonumber|notag)(?![a-zA-Z])")
_ARGUMENT = re.compile(r"^\s*\{\d+\}|^\s*\[[^\]]*\]")
_TITLE = re.compile(r"\\title\s*(?:\[[^\]]*\])?\s*\{((?:[^{}]|\{[^{}]*\})*)\}")
_COMMAND = re.compile(r"\\[a-zA-Z]+\*?|[{}~\\]")
_SPACE = re.compile(r"\\(?:[,;:!]|quad|qquad|,)(?![a-zA-Z])|&|\\(?:left|right)(?=\.)")
_STEP = re.compile(r"_\s*\{[^{}]*[a-z]\s*[+|-][^{}]*\}|\([a-z]\s*[+|-]")  # of a state from scan to scan: x_{k+1}
_ID = re.compile(r"[^A-Za-z0-9_]+")
_SEPARATOR = re.compile(
    r"\\[{}]|[{}()\[\]]|(?<!\\)[,;]|\\qquad|\\quad|\\(?:text|mbox|mathrm)\s*\{\s*(?:and|where|with|,)\s*\}"
)
_OPEN, _CLOSE = frozenset({"{", "(", "[", "\\{"}), frozenset({"}", ")", "]", "\\}"})
_LINE, _HIDDEN = "\\\\", "\x00"


@dataclass(frozen=True)
class Equation:
    """One equation of a paper.

    Attributes:
        number: in print, where it has one.
        label: by which the source refers to it.
        left: what is set; empty where nothing is.
        right: to what, as LaTeX.
    """

    number: str
    label: str
    left: str
    right: str


@dataclass(frozen=True)
class Printed:
    """A formula in the paper's own names, and what they are defined as."""

    formula: str
    let: Mapping[str, str]


@dataclass(frozen=True)
class Drafted:
    """An equation, the quantity that it is, if one was found, and the formula by the paper's own definitions."""

    understood: Understood
    candidate: Candidate | None = None
    printed: Printed | None = None


@dataclass(frozen=True)
class Understood:
    """An equation and what it was read as; nothing where it could not be, with the reason."""

    equation: Equation
    tree: Tree | None
    reason: str = ""
    name: str = ""  # of what it defines


def equations(source: str) -> list[Equation]:
    """The displayed equations of a source, with the numbers that they have in print.

    Raises:
        ValueError: when the source is too long.
    """
    if len(source) > MOST_CHARACTERS:
        raise ValueError(f"a source has at most {MOST_CHARACTERS} characters; given {len(source)}")
    found: list[Equation] = []
    count = 0
    macros, text = defined_macros(_COMMENT.sub("", source))
    for display in _DISPLAY.finditer(_with_environments(text, macros)):
        environment = display["env"] or ""
        body = next(text for text in (display["body"], display["bracket"], display["dollars"]) if text is not None)
        with suppress(FormulaError):  # of what cannot be put in, the equations cannot be read, and say so
            body = expanded(body, macros)
        numbered = bool(environment) and not environment.endswith("*")
        several = environment.rstrip("*") in {"align", "alignat", "gather", "eqnarray", "flalign"}
        for line in _lines(body) if several else [body]:
            tag = _TAG.search(line)
            counts = numbered and not tag and not _UNNUMBERED.search(line)
            count += counts
            number = tag[1].strip() if tag else str(count) if counts else ""
            found += _split(line, number)
    return found[:MOST_EQUATIONS]


def definitions_in_text(source: str) -> list[Understood]:
    r"""What is defined by a formula between dollars in the text, as $\lambda = e^{-\sigma^2/2}$ is; no bare number."""
    macros, text = defined_macros(_COMMENT.sub("", source[:MOST_CHARACTERS]))
    found: list[Understood] = []
    for inline in islice(_INLINE.finditer(_DISPLAY.sub(" ", _with_environments(text, macros))), MOST_EQUATIONS):
        line = inline["dollars"] or inline["bracket"]
        with suppress(FormulaError):
            line = expanded(line, macros)
        found += (one for one in map(_read, _split(line, "")) if one.name and one.tree is not None and names(one.tree))
    return found


def _with_environments(source: str, macros: Mapping[str, Macro]) -> str:
    r"""The source with \begin{equation} for an author's \be, and the like."""
    short = {name: one.body for name, one in macros.items() if not one.count and _ENVIRONMENT.search(one.body)}
    if not short:
        return source
    used = re.compile(rf"\\({'|'.join(map(re.escape, short))})(?![A-Za-z])")
    return used.sub(lambda found: short[found[1]], source)


def title(source: str) -> str:
    """The title of a paper on one line, or that it has none."""
    said = _TITLE.search(_COMMENT.sub("", source))
    words = " ".join(_COMMAND.sub(" ", said[1]).split()) if said else ""
    return "".join(sign for sign in words if sign.isprintable()) or "untitled"


def defined(everything: Sequence[Understood]) -> dict[str, Tree]:
    """What the paper defines by name."""
    return {one.name: one.tree for one in everything if one.name and one.tree is not None}


def understood(found: Iterable[Equation]) -> list[Understood]:
    """Each equation read, with earlier definitions' names known."""
    return [_read(one) for one in found]


def with_definitions(one: Understood, known: Mapping[str, Tree]) -> Tree | None:
    """What an equation says, with the paper's own names replaced by what they are defined as."""
    tree = one.tree
    for _ in range(DEEPEST):
        used = names(tree) & known.keys() - {one.name} if tree is not None else frozenset[str]()
        if tree is None or not used:
            return tree
        tree = _replaced(tree, {name: known[name] for name in used})
    return None  # in a circle


def _replaced(tree: Tree, by_name: Mapping[str, Tree]) -> Tree:
    return rebuild(tree, lambda node: by_name.get(node.name, node) if isinstance(node, Name) else node)


def by_definitions(one: Understood, known: Mapping[str, Tree], candidate: Candidate) -> Printed | None:
    """The formula as it is printed, with definitions for the paper's own names; None where it uses none.

    A name that the quantity's symbols have too cannot be defined, nor is what is in another convention taken apart.
    """
    used = _needed(one, known)
    symbols = names(read_loosely(candidate.formula))
    if symbols == {candidate.read.get(name, name) for name in names(one.tree or Name(""))}:
        return None  # it was found as it is printed
    taken = {*candidate.read.values(), *symbols}
    if one.tree is None or not used or candidate.convention or taken & set(used):
        return None

    symbols_of = {letter: Name(symbol) for letter, symbol in candidate.read.items()}
    let = {name: to_text(_replaced(known[name], symbols_of)) for name in used}
    return Printed(to_text(_replaced(one.tree, symbols_of)), let)


def _needed(one: Understood, known: Mapping[str, Tree]) -> list[str]:
    """The paper's own names that an equation needs, each behind those that it is defined by."""
    found: list[str] = []

    def visit(tree: Tree, depth: int) -> None:
        for name in sorted(names(tree) & known.keys() - {one.name}):
            if depth < DEEPEST:
                visit(known[name], depth + 1)
            if name not in found:
                found.append(name)

    if one.tree is not None:
        visit(one.tree, 0)
    return found


def claims(paper: str, drafted: Sequence[Drafted]) -> str:
    """The text of a claims file."""
    used: set[str] = set()
    blocks = [f"paper = {_quoted(paper)}\n"]
    for place, one in enumerate(drafted, start=1):
        name = _identifier(one.understood.equation, place, used)
        blocks.append("[[claim]]\n" + "".join(f"{key} = {value}\n" for key, value in _fields(name, one)))
    return "\n".join(blocks)


def _fields(name: str, drafted: Drafted) -> Iterator[tuple[str, str]]:
    one, candidate, printed = drafted.understood, drafted.candidate, drafted.printed
    yield "id", _quoted(name)
    if candidate is not None:
        yield "quantity", _quoted(candidate.quantity)
        yield "formula", _quoted(printed.formula if printed else candidate.formula)
        if printed:
            yield "let", _table(printed.let)
        if candidate.given:
            yield "given", _table(candidate.given)
    else:
        defines = f"it defines {one.name}, and is no quantity of the catalogue" if one.name else ""
        yield "undecided", _quoted(one.reason or defines or "it is no quantity of the catalogue")
    if one.equation.number:
        yield "equation", _quoted(one.equation.number)
    yield "note", _quoted(" ".join(_remarks(one, candidate)))


def _table(pairs: Mapping[str, str]) -> str:
    return "{ " + ", ".join(f"{name} = {_quoted(value)}" for name, value in pairs.items()) + " }"


def _remarks(one: Understood, candidate: Candidate | None) -> Iterator[str]:
    equation = one.equation
    yield f"{equation.left} = {equation.right}"[:NOTE] if equation.left else equation.right[:NOTE]
    if equation.label:
        yield f"(label {equation.label})"
    if candidate is not None and candidate.read:
        yield "(read with " + ", ".join(f"{letter} for {symbol}" for letter, symbol in candidate.read.items()) + ")"
    if candidate is not None and candidate.convention:
        yield f"({candidate.convention})"


def _lines(body: str) -> list[str]:
    """The lines of several equations; those of a matrix belong to it."""
    hidden = _MATRIX.sub(lambda found: found[0].replace(_LINE, _HIDDEN), _ARGUMENT.sub("", body))
    return [line.replace(_HIDDEN, _LINE) for line in hidden.split(_LINE)]


def _split(line: str, number: str) -> Iterator[Equation]:
    """The equation of a line, or those of an inner environment, of which each has the number."""
    line = line if (opened := without_braces(line)) == line else f"\\begin{{split}}{opened}\\end{{split}}"
    inner = _INNER.search(line)
    label = _LABEL.search(line)
    lines = _lines(inner[2]) if inner else [line]
    for one in (part for line in lines for part in _apart(line)):
        text = _cleaned(one)
        left, sign, right = _at_equals(text)
        if sign and right:
            yield Equation(number, label[1].strip() if label else "", left, right)


def _apart(line: str) -> list[str]:
    r"""The equations of one line: `x = a, \quad y = b` are two; what is no equation belongs to the one before."""
    hidden = _MATRIX.sub(lambda found: _HIDDEN * len(found[0]), line)
    parts: list[str] = []
    start = 0
    for end in [*_separators(hidden), len(line)]:
        if parts and "=" not in hidden[start:end]:
            parts[-1] += line[start:end]
        else:
            parts.append(line[start:end])
        start = end
    return parts


def _separators(line: str) -> Iterator[int]:
    """Where a comma, a semicolon, a wide space or a word parts equations, in no brackets."""
    depth = 0
    for found in _SEPARATOR.finditer(line):
        depth += (found[0] in _OPEN) - (found[0] in _CLOSE)
        if depth == 0 and found[0] not in _OPEN | _CLOSE:
            yield found.end()


def _cleaned(line: str) -> str:
    """A line without what is no formula: labels, numbers, alignment outside of matrices, the comma after it."""
    for pattern in (_LABEL, _TAG, _UNNUMBERED):
        line = pattern.sub(" ", line)
    kept: list[str] = []
    end = 0
    for matrix in _MATRIX.finditer(line):
        kept += [_SPACE.sub(" ", line[end : matrix.start()]), matrix[0]]
        end = matrix.end()
    kept.append(_SPACE.sub(" ", line[end:]))
    return " ".join("".join(kept).split()).rstrip(".,; ")


def _at_equals(text: str) -> tuple[str, str, str]:
    """Both sides of the last sign of equality that stands in no brackets; of a chain, what is set and the end of it."""
    depth = 0
    places = []
    for place, sign in enumerate(text):
        depth += (sign in "{[(") - (sign in "}])")
        if sign == "=" and depth == 0:
            places.append(place)
    if not places:
        return "", "", text
    return text[: places[0]].strip(), "=", text[places[-1] + 1 :].strip()


def _read(equation: Equation) -> Understood:
    try:
        tree = read_loosely(equation.right, notation=LATEX)
    except FormulaError as error:
        return Understood(equation, None, f"it cannot be read: {error.message}"[:NOTE])
    try:
        left = read_loosely(equation.left, notation=LATEX) if equation.left else None
    except FormulaError:
        left = None
    is_step = bool(_STEP.search(equation.left))
    defines = isinstance(left, Name) and left.name not in names(tree) and not is_step
    return Understood(equation, tree, name=left.name if defines and isinstance(left, Name) else "")


def _identifier(equation: Equation, place: int, used: set[str]) -> str:
    """The label, or the number, as an identifier that no other claim has."""
    word = _ID.sub("_", equation.label or (f"eq{equation.number}" if equation.number else f"display{place}")).strip("_")
    name = word or f"display{place}"
    while name in used:
        name = f"{name}_{place}"
    used.add(name)
    return name


def _quoted(text: str) -> str:
    """A basic string of TOML, which is one of JSON but for a character."""
    return json.dumps("".join(sign if sign.isprintable() else " " for sign in text), ensure_ascii=False)
