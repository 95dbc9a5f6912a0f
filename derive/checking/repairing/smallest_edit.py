"""Suggests the smallest edits of a printed formula that make it right: what the search finds, proved."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import chain

from radartrack.derive.algebra.equality import proved_equal
from radartrack.derive.checking.comparing.numerical_comparison import Comparison
from radartrack.derive.checking.comparing.question_domain import Domain
from radartrack.derive.checking.question.conditions import under
from radartrack.derive.checking.question.names import Names
from radartrack.derive.checking.repairing.edit_search import Candidate, Search
from radartrack.derive.checking.reporting.derived_formula import as_printed
from radartrack.derive.evaluation.floating_point import RoughEvaluator
from radartrack.derive.evaluation.many_digits import Evaluator
from radartrack.derive.evaluation.points import generic_points
from radartrack.derive.evaluation.tree_values import Screen, Values
from radartrack.derive.formula.error import FormulaError, Span
from radartrack.derive.formula.fold import Fold, rebuild
from radartrack.derive.formula.functions import NUMBER_OF_ARGUMENTS
from radartrack.derive.formula.magnitude import magnitudes
from radartrack.derive.formula.printing import to_text
from radartrack.derive.formula.tree import (
    Call,
    Name,
    Negation,
    Number,
    Path,
    Power,
    Product,
    Sum,
    Tree,
    children,
    parts,
)
from radartrack.derive.formula.tree import names as names_of
from radartrack.derive.language.tensor import Tensor
from radartrack.derive.language.variable import Variable
from radartrack.derive.reading.grammar import check_tree
from radartrack.derive.symbolic import Expr, Symbol

ZERO = Number("0")
SIZE = 18
DIGITS = 20
GOOD = 1e-10  # relative error of a value that edits are screened by
ENOUGH = 5
EVERYWHERE = 12  # points of the domain, where signs and branches are others
FARTHER = 1.0  # costlier than the best, and a suggestion is only noise
AT_ONE_PLACE = 0.3  # so much costlier than an edit of the same part, and it says the same in a longer way


@dataclass(frozen=True)
class Edited:
    """A formula after an edit that makes it right, and where the edit is in the text, if that is known."""

    formula: str
    edit: str
    cost: float
    proved: bool
    span: Span | None = None


def suggest(
    printed: Tree, names: Names, derived: Expr, symbols: Sequence[Variable], conditions: Mapping[Symbol, Expr]
) -> list[Edited]:
    """The edits that make a printed formula equal to the derived one, the smallest first."""
    points = [[point[symbol.name] for symbol in symbols] for point in generic_points(symbols, SIZE)]
    values = {name: values_at(under(conditions, value), symbols, points) for name, value in names.numbers.items()}
    target = values_at(derived, symbols, points)
    if target is None:
        return []
    screen = Screen({name: value for name, value in values.items() if value is not None}, len(points))
    search = Search(screen, target, names, printed, _derived_trees(derived, names))
    found = search.edits(printed)
    confirmed = _confirmed(found, names, derived, Domain(symbols, conditions))
    told: list[tuple[Edited, Path]] = []
    for edited, tree in confirmed:
        path = changed_part(printed, tree)
        longer = [(one, place) for one, place in told if len(edited.formula) >= len(one.formula)]
        if not any(edited.cost >= one.cost + AT_ONE_PLACE and is_within(path, place) for one, place in longer):
            told.append((edited, path))
    return [replace(edited, span=_span_at(printed, path)) for edited, path in told]


def changed_part(printed: Tree, edited: Tree) -> Path:
    """Where a formula was edited: the way to the smallest part of it that has all that differs."""
    path: list[int] = []
    while type(printed) is type(edited) and len(children(printed)) == len(children(edited)):
        pairs = list(zip(children(printed), children(edited), strict=True))
        places = [place for place, (one, other) in enumerate(pairs) if one != other]
        if len(places) != 1:
            break
        path.append(places[0])
        printed, edited = pairs[places[0]]
    return tuple(path)


def is_within(path: Path, other: Path) -> bool:
    """Whether one of two parts is in the other."""
    shorter = min(len(path), len(other))
    return path[:shorter] == other[:shorter]


def _span_at(tree: Tree, path: Path) -> Span | None:
    """Where a part stands in the text, or else the smallest around it of which that is known."""
    span = tree.span
    for step in path:
        tree = children(tree)[step]
        span = tree.span or span
    return span


def _derived_trees(derived: Expr, names: Names) -> list[Tree]:
    """The derived formula as it would be printed, in the paper's letters, where the readers know its functions."""
    letters = {str(value): name for name, value in names.numbers.items() if value.is_Symbol and name.isidentifier()}
    tree = rebuild(as_printed(derived), lambda node: _in_letters(node, letters))
    calls = {node.function for node in parts(tree) if isinstance(node, Call)}
    return [tree] if NUMBER_OF_ARGUMENTS.keys() >= calls and names.numbers.keys() >= names_of(tree) else []


def _in_letters(node: Tree, letters: Mapping[str, str]) -> Tree:
    if isinstance(node, Name) and node.name not in letters.values() and node.name in letters:
        return Name(letters[node.name])
    return node


def values_at(expression: Expr, symbols: Sequence[Symbol], points: Sequence[Sequence[float]]) -> Values | None:
    """What an expression is worth at some points; None where it has no value at one of them."""
    rough = RoughEvaluator([expression], symbols)
    found = [rough(point) for point in points]
    try:
        if all(one and one[0][1] <= GOOD * abs(one[0][0]) for one in found):
            return tuple(one[0][0] for one in found if one)
        exact = Evaluator(Tensor((), (expression,)), symbols, DIGITS)
        return tuple(float(exact(point).entries[0]) for point in points)
    except (ArithmeticError, TypeError, ValueError):
        return None


def _confirmed(
    candidates: Sequence[Candidate],
    names: Names,
    derived: Expr,
    domain: Domain,
) -> Iterator[tuple[Edited, Tree]]:
    """Those that can be read and are right with their trees, the best first; what is not proved is said to be so.

    Each formula comes once, in whatever order its terms and factors stand.
    """
    seen: set[str] = set()
    measure, written = magnitudes(), Fold(_in_any_order)
    best = math.inf
    for candidate in candidates:
        if len(seen) >= ENOUGH or candidate.cost > best + FARTHER:
            return
        tidied = _tidied(candidate.tree)
        if written(tidied) in seen:
            continue
        try:
            expression = under(domain.conditions, names.read(check_tree(candidate.tree, measure)))
        except FormulaError:
            continue
        seen.add(written(tidied))
        proved = proved_equal(expression, derived)
        if proved or _confirmed_by_numbers(expression, derived, domain):
            best = min(best, candidate.cost)
            yield Edited(to_text(tidied), candidate.words, candidate.cost, proved), candidate.tree


def _in_any_order(node: Tree, below: Sequence[str]) -> str:
    """The same for formulas that differ in the order of terms and factors."""
    if not below:
        return to_text(node)
    kind = node.function if isinstance(node, Call) else type(node).__name__
    ordered = sorted(below) if isinstance(node, Sum | Product) else below
    return f"{kind}({', '.join(ordered)})"


def _tidied(tree: Tree) -> Tree:
    """The tree with x for x**1 and for 0 + x."""
    return rebuild(tree, _plain)


def _plain(node: Tree) -> Tree:
    match node:
        case Power(base, Number("1")):
            return base
        case Sum(terms) if ZERO in terms or Negation(ZERO) in terms:
            kept = tuple(term for term in terms if term not in {ZERO, Negation(ZERO)}) or (ZERO,)
            return kept[0] if len(kept) == 1 else Sum(kept)
        case _:
            return node


def _confirmed_by_numbers(expression: Expr, derived: Expr, domain: Domain) -> bool:
    comparison = Comparison(expression, derived, domain.symbols)
    return comparison.agree_at(chain(domain.ordinary(ENOUGH), domain.spread(EVERYWHERE), domain.corners()))
