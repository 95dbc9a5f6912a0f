r"""Drafts a claims file from a paper's LaTeX source: its equations, each found in the catalogue or left undecided.

Nothing of the source is run: environments, labels and numbers are taken from its text, formulas by the reader, and the
author's commands are put in as text.
"""

from __future__ import annotations

import json
import re
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import combinations, islice, pairwise

from radartrack.derive.checking.question.letters.assignments import ANY
from radartrack.derive.finding.formula_search import Candidate
from radartrack.derive.formula.error import FormulaError
from radartrack.derive.formula.fold import rebuild
from radartrack.derive.formula.printing import to_text
from radartrack.derive.formula.tree import Name, Negation, Sum, Tree, names
from radartrack.derive.reading.any_letters import read_loosely
from radartrack.derive.reading.notation import LATEX
from radartrack.derive.reading.tex import latex_equations
from radartrack.derive.reading.tex.author_macros import Macro, defined_macros, expanded
from radartrack.derive.reading.tex.latex import latex_name

MOST_CHARACTERS = 4_000_000
MOST_EQUATIONS = 1_500  # fewer than a claims file holds
DEEPEST = 8  # definitions of definitions
MOST_PUT_IN = 3  # definitions of which each choice is tried
NOTE = 600  # characters of a formula that are quoted

_COMMENT = re.compile(r"(?<!\\)%[^\n]*")
_DISPLAY = re.compile(
    r"\\begin\{(?P<env>(?:equation|align|alignat|gather|multline|eqnarray|flalign)\*?)\}(?P<body>.*?)\\end\{(?P=env)\}"
    r"|\\\[(?P<bracket>.*?)\\\]|(?<!\\)\$\$(?P<dollars>.*?)\$\$",
    re.DOTALL,
)
_INLINE = re.compile(r"(?<![\\$])\$(?!\$)([^$]+)(?<!\\)\$(?!\$)|\\\((.+?)\\\)", re.DOTALL)
_MATRIX = re.compile(r"\\begin\{([a-zA-Z]*matrix|array|cases)\}.*?\\end\{\1\}", re.DOTALL)
_ENVIRONMENT = re.compile(r"\\(?:begin|end)\s*\{")
_LABEL = re.compile(r"\\label\s*\{([^{}]*)\}")
_TAG = re.compile(r"\\(?:tag\*?\s*\{|l?eqno\s*[({])([^{}()]*)[)}]")
_UNNUMBERED = re.compile(r"\\(?:nonumber|notag)(?![a-zA-Z])")
_ARGUMENT = re.compile(r"^\s*\{\d+\}|^\s*\[[^\]]*\]")
_TITLE = re.compile(r"\\title\s*(?:\[[^\]]*\])?\s*\{((?:[^{}]|\{[^{}]*\})*)\}")
_COMMAND = re.compile(r"\\[a-zA-Z]+\*?|[{}~\\]")
_STEP = re.compile(r"_\s*\{[^{}]*[a-z]\s*[+|-][^{}]*\}|\([a-z]\s*[+|-]")  # of a state from scan to scan: x_{k+1}
_ID = re.compile(r"[^A-Za-z0-9_]+")
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


@dataclass(frozen=True)
class Printed:
    """A formula in the paper's own names, and what they are defined as."""

    formula: str
    let: Mapping[str, str]


@dataclass(frozen=True)
class Drafted:
    """An equation and what was found of it.

    Attributes:
        understood: the equation.
        candidate: the quantity that it is.
        printed: the formula by the paper's own definitions, where it uses some.
        near: the quantity that it is but for a slip.
    """

    understood: Understood
    candidate: Candidate | None = None
    printed: Printed | None = None
    near: Candidate | None = None


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


def title(source: str) -> str:
    """The title of a paper on one line, or that it has none."""
    said = _TITLE.search(_COMMENT.sub("", source))
    words = " ".join(_COMMAND.sub(" ", said[1]).split()) if said else ""
    return "".join(sign for sign in words if sign.isprintable()) or "untitled"


def beside(one: Understood, everything: Iterable[Understood]) -> frozenset[str]:
    """The names that are defined in the display of an equation."""
    return frozenset(other.name for other in everything if other.equation.display == one.equation.display)


def defined(everything: Iterable[Understood]) -> dict[str, Tree]:
    """What the paper defines by name; a number is the value of one example."""
    return {one.name: one.tree for one in everything if one.name and one.tree is not None and names(one.tree)}


def understood(found: Sequence[Equation]) -> list[Understood]:
    """Each equation read; what the paper sets is named with all that decorates it: lambda' is another than lambda."""
    set_by = [_set_name(one) for one in found]
    known = {name for name in set_by if name}
    return [_read(one, name, known) for one, name in zip(found, set_by, strict=True)]


def readings(
    one: Understood, known: Mapping[str, Tree], beside: Collection[str] = ()
) -> Iterator[tuple[Tree, Mapping[str, Tree]]]:
    """What an equation says with the paper's definitions put in, and with which: most first, in the end none.

    Some are best left: rho_m = rho + error says what is measured, Lambda = T**2*sigma_w/sigma_v is a symbol here too.

    Args:
        one: the equation.
        known: the paper's definitions.
        beside: the names of those that stand in the same display; where all go in a circle, it may be these.
    """
    used = _needed(one, known)
    likely = [name for name in used if not _is_sum_of_names(known[name])]
    sizes = range(len(likely), 0, -1) if len(likely) <= MOST_PUT_IN else [len(likely)]
    choices = [tuple(used), *(chosen for size in sizes for chosen in combinations(likely, size))]
    choices.append(tuple(name for name in used if name in beside))
    seen = {one.tree, None}
    for chosen in choices:
        put_in = {name: known[name] for name in chosen}
        tree = _with_definitions(one, put_in)
        if tree is not None and tree not in seen:
            seen.add(tree)
            yield tree, put_in
    if one.tree is not None:
        yield one.tree, {}


def _is_sum_of_names(tree: Tree) -> bool:
    return isinstance(tree, Sum) and all(isinstance(part, Name | Negation) for part in tree.terms)


def _with_definitions(one: Understood, known: Mapping[str, Tree]) -> Tree | None:
    """What an equation says, with names replaced by what they are defined as; nothing where that goes in a circle."""
    tree = one.tree
    for _ in range(DEEPEST):
        used = names(tree) & known.keys() - {one.name} if tree is not None else frozenset[str]()
        if tree is None or not used:
            return tree
        tree = _replaced(tree, {name: known[name] for name in used})
    return None


def _replaced(tree: Tree, by_name: Mapping[str, Tree]) -> Tree:
    return rebuild(tree, lambda node: by_name.get(node.name, node) if isinstance(node, Name) else node)


def is_credible(candidate: Candidate, known: Mapping[str, Tree], put_in: Mapping[str, Tree]) -> bool:
    """Whether no letter that the paper defines stands for a symbol that it never means: r for a forgetting."""
    left = candidate.read.keys() & known.keys() - put_in.keys()
    return candidate.rank < ANY or all(_is_sum_of_names(known[letter]) for letter in left)


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
        yield "undecided", _quoted(_open_question(one, drafted.near))
    if one.equation.number:
        yield "equation", _quoted(one.equation.number)
    yield "note", _quoted(" ".join(_remarks(one, candidate)))


def _open_question(one: Understood, near: Candidate | None) -> str:
    if near is not None:
        return f"it is near {near.quantity}: {near.slip}; perhaps meant: {near.formula}"
    is_none = "is no quantity of the catalogue"
    return one.reason or (f"it defines {one.name}, and {is_none}" if one.name else f"it {is_none}")


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


def _set_name(equation: Equation) -> str:
    """The name of what an equation sets, if it is one letter and no step of a state from scan to scan."""
    name = latex_name(equation.left) if equation.left and not _STEP.search(equation.left) else None
    return name or ""


def _read(equation: Equation, name: str, known: Collection[str]) -> Understood:
    try:
        tree = read_loosely(equation.right, known, notation=LATEX)
    except FormulaError as error:
        return Understood(equation, None, f"it cannot be read: {error.message}"[:NOTE])
    return Understood(equation, tree, name="" if name in names(tree) else name)


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
