r"""What a paper's equations say by its own definitions: \lambda is e^{-\sigma^2/2} in whatever comes after."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import combinations

from radartrack.derive.checking.question.letters.assignments import ANY
from radartrack.derive.checking.question.letters.elapsed_time import PERIOD, elapsed, with_period
from radartrack.derive.finding.formula_search import Candidate
from radartrack.derive.finding.paper_equations import Equation
from radartrack.derive.formula.error import FormulaError
from radartrack.derive.formula.fold import rebuild
from radartrack.derive.formula.printing import to_text
from radartrack.derive.formula.tree import Name, Negation, Sum, Tree, names
from radartrack.derive.reading.any_letters import possible_trees, read_loosely
from radartrack.derive.reading.notation import LATEX
from radartrack.derive.reading.tex.latex import latex_name

DEEPEST = 8  # definitions of definitions
MOST_PUT_IN = 3  # definitions of which each choice is tried

_STEP = re.compile(r"_\s*\{[^{}]*[a-z]\s*[+|-][^{}]*\}|\([a-z]\s*[+|-]")  # of a state from scan to scan: x_{k+1}


@dataclass(frozen=True)
class Understood:
    """An equation and what it was read as; nothing where it could not be, with the reason."""

    equation: Equation
    tree: Tree | None
    reason: str = ""
    name: str = ""  # of what it defines


@dataclass(frozen=True)
class Printed:
    """A formula in the paper's own names, and what they are defined as."""

    formula: str
    let: Mapping[str, str]


def understood(found: Sequence[Equation]) -> list[Understood]:
    """Each equation read; what the paper sets is named with all that decorates it: lambda' is another than lambda."""
    set_by = [_set_name(one) for one in found]
    known = {name for name in set_by if name}
    return [_read(one, name, known) for one, name in zip(found, set_by, strict=True)]


def _set_name(equation: Equation) -> str:
    """The name of what an equation sets, if it is one letter and no step of a state from scan to scan."""
    name = latex_name(equation.left) if equation.left and not _STEP.search(equation.left) else None
    return name or ""


def _read(equation: Equation, name: str, known: Collection[str]) -> Understood:
    try:
        tree, *_ = possible_trees(equation.right, known, notation=LATEX)
    except FormulaError as error:
        return Understood(equation, None, f"it cannot be read: {error.message}")
    return Understood(equation, tree, name="" if name in names(tree) else name)


def beside(one: Understood, everything: Iterable[Understood]) -> frozenset[str]:
    """The names that are defined in the display of an equation."""
    return frozenset(other.name for other in everything if other.equation.display == one.equation.display)


def defined(everything: Iterable[Understood]) -> dict[str, Tree]:
    """What the paper defines by name; a number is the value of one example."""
    return {one.name: one.tree for one in everything if one.name and one.tree is not None and names(one.tree)}


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
        if (times := elapsed([one.tree])) and PERIOD not in {*known, *names(one.tree)}:
            yield with_period(one.tree, times, Name(PERIOD)), {}


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
    visited: set[str] = set()

    def visit(tree: Tree) -> None:
        for name in sorted(names(tree) & known.keys() - {one.name}):
            if name not in visited:
                visited.add(name)
                visit(known[name])
                found.append(name)

    if one.tree is not None:
        visit(one.tree)
    return found
