"""Finds the smallest edits of a printed formula that make it right.

From what the whole formula should be worth at some points follows, step by step down the tree, what each of its
parts would have to be worth there. An edit of a part is right when it is worth that: so thousands are screened in no
time, and a factor or term that is missing shows in the ratio or the difference. What passes is proved.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from operator import sub, truediv

from radartrack.derive.checking.comparison import Comparison
from radartrack.derive.checking.edits import Alternative, alternatives, everywhere
from radartrack.derive.checking.equality import proved_equal
from radartrack.derive.checking.monomials import Fitter, Monomial, number_tree
from radartrack.derive.checking.numeric import Screen, Values, close, combined
from radartrack.derive.checking.points import generic_points
from radartrack.derive.checking.printed import Names
from radartrack.derive.evaluation import Evaluator
from radartrack.derive.formula.error import FormulaError
from radartrack.derive.formula.printing import to_text
from radartrack.derive.formula.tree import (
    Call,
    Name,
    Negation,
    Number,
    Path,
    Power,
    Product,
    Quotient,
    Sum,
    Tree,
    children,
    rebuild,
    replace_at,
    walk,
)
from radartrack.derive.symbolic import Expr, Symbol
from radartrack.derive.tensor import Tensor
from radartrack.derive.variable import Variable

SIZE = 18
DIGITS = 20
FACTORS = 13
FIRST_EDITS = 150
ENOUGH = 5
FARTHER = 1.0  # costlier than the best, and a suggestion is only noise
LARGE = 60  # nodes from which two edits at once are not looked for
PARTNERS = {"sin": "cos", "cos": "sin", "sinh": "cosh", "cosh": "sinh"}
MOST_COMPLEX = 6


@dataclass(frozen=True)
class Edited:
    """A formula after an edit that makes it right."""

    formula: str
    edit: str
    cost: float
    proved: bool


@dataclass(frozen=True)
class _Candidate:
    tree: Tree
    words: str
    cost: float


def suggest(
    printed: Tree, names: Names, derived: Expr, symbols: Sequence[Variable], conditions: Mapping[Symbol, Expr]
) -> list[Edited]:
    """The edits that make a printed formula equal to the derived one, the smallest first."""
    points = [[point[symbol.name] for symbol in symbols] for point in generic_points(symbols, SIZE)]
    values = {
        name: _values(value.xreplace(conditions), symbols, points) for name, value in names.values.items()
    }
    target = _values(derived, symbols, points)
    if target is None:
        return []
    screen = Screen({name: value for name, value in values.items() if value is not None}, len(points))
    search = _Search(screen, target, names, printed)
    found = search.edits(printed)
    return list(_confirmed(found, names, derived, symbols, conditions))


class _Search:
    """The points, what is wanted there, and the factors that may be missing."""

    def __init__(self, screen: Screen, target: Values, names: Names, printed: Tree) -> None:
        self._screen = screen
        self._target = target
        self._kinds = {name: names.dimensions[name] for name in screen.names}
        symbols = [name for name in screen.names if names.values[name].is_Symbol]
        self._fitter = Fitter(self._factors(symbols, printed), screen.size)

    def edits(self, tree: Tree) -> list[_Candidate]:
        """One edit, or one that runs through the formula; where there is none, two."""
        found = [*self._single(tree), *self._everywhere(tree)]
        if not found and sum(1 for _ in walk(tree)) <= LARGE:
            found = list(self._double(tree))
        return sorted(found, key=lambda candidate: candidate.cost)

    def _everywhere(self, tree: Tree) -> Iterator[_Candidate]:
        for edit in everywhere(tree, self._kinds):
            if close(self._screen(edit.tree), self._target):
                yield _Candidate(edit.tree, edit.words, edit.cost)

    def _single(self, tree: Tree) -> Iterator[_Candidate]:
        for path, node, parent, needed in self._needs(tree):
            for edit in self._replacements(node, parent, needed):
                yield _Candidate(replace_at(tree, path, edit.tree), edit.words, edit.cost)

    def _double(self, tree: Tree) -> Iterator[_Candidate]:
        firsts = [
            _Candidate(replace_at(tree, path, edit.tree), edit.words, edit.cost)
            for path, node in walk(tree)
            for edit in (*alternatives(node, self._kinds), *_other_numbers(node))
            if edit.cost <= 1.1
        ]
        for first in sorted(firsts, key=lambda candidate: candidate.cost)[:FIRST_EDITS]:
            for second in self._single(first.tree):
                if second.tree != tree and second.cost < 2:
                    yield _Candidate(
                        second.tree, f"{first.words}; {second.words}", first.cost + second.cost + 1
                    )

    def _needs(self, tree: Tree) -> Iterator[tuple[Path, Tree, Tree | None, Values]]:
        """Every part with what it would have to be worth, where that can be said."""
        waiting: list[tuple[Path, Tree, Tree | None, Values]] = [((), tree, None, self._target)]
        while waiting:
            path, node, parent, needed = waiting.pop()
            yield path, node, parent, needed
            for place, child in enumerate(children(node)):
                wanted = self._screen.required(node, place, needed)
                if wanted is not None:
                    waiting.append(((*path, place), child, node, wanted))

    def _replacements(self, node: Tree, parent: Tree | None, needed: Values) -> Iterator[Alternative]:
        for edit in alternatives(node, self._kinds):
            if close(self._screen(edit.tree), needed):
                yield edit
        yield from self._number(node, parent, needed)
        yield from self._zero(node, needed)
        values = self._screen(node)
        ratio = self._fitter.fit(values and combined(truediv, needed, values))
        if ratio is not None:
            if not isinstance(parent, Product | Quotient | Negation):
                yield from self._sign_or_factor(node, parent, ratio)
            return
        if isinstance(node, Sum) or parent is None:
            yield from self._missing_term(node, needed)
        if isinstance(parent, Sum) or parent is None:
            yield from self._other_term(node, needed)

    def _zero(self, node: Tree, needed: Values) -> Iterator[Alternative]:
        if close(needed, self._screen.constant(0)):
            yield Alternative(Number("0"), f"{to_text(node)} should be 0", 1.2)

    def _number(self, node: Tree, parent: Tree | None, needed: Values) -> Iterator[Alternative]:
        """A number that should be another."""
        if not isinstance(node, Number) or isinstance(parent, Negation):
            constant = isinstance(node, Negation | Quotient) and all(
                isinstance(c, Number) for c in children(node)
            )
            if not constant:
                return
        monomial = self._fitter.fit(needed)
        if monomial is not None and monomial.is_number:
            tree = number_tree(monomial.number)
            cost = 1.0 if monomial.number > 0 else 1.6
            yield Alternative(tree, f"{to_text(node)} should be {to_text(tree)}", cost)

    def _sign_or_factor(self, node: Tree, parent: Tree | None, ratio: Monomial) -> Iterator[Alternative]:
        if ratio.complexity > MOST_COMPLEX:
            return
        signed = node
        if ratio.number < 0:
            signed = node.operand if isinstance(node, Negation) else Negation(node)
        if not ratio.is_number or abs(ratio.number) != 1:
            kind = "a missing factor" if ratio.number > 0 else "a factor"
            yield Alternative(
                _times(signed, ratio), f"{kind} {to_text(ratio.signed())}", 1.5 + 0.3 * ratio.complexity
            )
        elif not isinstance(parent, Sum):
            cost = 1.4 if isinstance(parent, Call | Power) else 1.0
            yield Alternative(signed, f"the sign of {to_text(node)}", cost)

    def _missing_term(self, node: Tree, needed: Values) -> Iterator[Alternative]:
        values = self._screen(node)
        rest = self._fitter.fit(values and combined(sub, needed, values))
        if rest is None or rest.complexity > 2 * MOST_COMPLEX:
            return
        terms = node.terms if isinstance(node, Sum) else (node,)
        words = f"a missing term {to_text(rest.signed())}"
        yield Alternative(Sum((*terms, rest.signed())), words, 2.0 + 0.2 * rest.complexity)

    def _other_term(self, node: Tree, needed: Values) -> Iterator[Alternative]:
        term = self._fitter.fit(needed)
        if term is not None and not isinstance(node, Number) and term.complexity <= 2 * MOST_COMPLEX:
            words = f"{to_text(node)} should be {to_text(term.signed())}"
            yield Alternative(term.signed(), words, 2.2 + 0.2 * term.complexity)

    def _factors(self, symbols: Sequence[str], printed: Tree) -> list[tuple[Tree, Values]]:
        """What a missing factor may consist of: the symbols, and functions like those printed."""
        calls = [node for _, node in walk(printed) if isinstance(node, Call) and node.function in PARTNERS]
        partners = [Call(PARTNERS[call.function], call.arguments) for call in calls]
        growth = [node for _, node in walk(printed) if isinstance(node, Call) and node.function == "exp"]
        trees: list[Tree] = [*map(Name, symbols), *calls, *partners, *growth]
        found = [(tree, self._screen(tree)) for tree in dict.fromkeys(trees)]
        return [(tree, values) for tree, values in found if values is not None][:FACTORS]


def _values(expression: Expr, symbols: Sequence[Symbol], points: Sequence[Sequence[float]]) -> Values | None:
    evaluator = Evaluator(Tensor((), (expression,)), symbols, DIGITS)
    try:
        return tuple(float(evaluator(point).entries[0]) for point in points)
    except (ArithmeticError, TypeError, ValueError):
        return None


def _other_numbers(node: Tree) -> Iterator[Alternative]:
    if isinstance(node, Number):
        for number in dict.fromkeys((node.value * 2, node.value / 2, node.value + 1, node.value - 1)):
            tree = number_tree(number)
            yield Alternative(tree, f"{to_text(node)} should be {to_text(tree)}", 1.1)


def _times(node: Tree, factor: Monomial) -> Tree:
    """The node with a factor, whose sign the node has already."""
    if isinstance(node, Negation):
        return Negation(_times(node.operand, factor))
    tree = factor.tree()
    above, below = (tree.numerator, tree.denominator) if isinstance(tree, Quotient) else (tree, None)
    if isinstance(node, Quotient) and below is None:
        return Quotient(_product(above, node.numerator), node.denominator)
    product = _product(above, node)
    return product if below is None else Quotient(product, below)


def _product(first: Tree, second: Tree) -> Tree:
    parts = [
        part for tree in (first, second) for part in (tree.factors if isinstance(tree, Product) else (tree,))
    ]
    kept = tuple(part for part in parts if part != Number("1")) or (Number("1"),)
    return kept[0] if len(kept) == 1 else Product(kept)


def _confirmed(
    candidates: Sequence[_Candidate],
    names: Names,
    derived: Expr,
    symbols: Sequence[Variable],
    conditions: Mapping[Symbol, Expr],
) -> Iterator[Edited]:
    """Those that are proved, each formula once; one that cannot be proved is said to be so."""
    seen: set[str] = set()
    best = math.inf
    for candidate in candidates:
        formula = to_text(_tidied(candidate.tree))
        if formula in seen or len(seen) >= ENOUGH or candidate.cost > best + FARTHER:
            continue
        try:
            expression = names.read(candidate.tree).xreplace(conditions)
        except FormulaError:
            continue
        seen.add(formula)
        proved = proved_equal(expression, derived)
        if proved or _confirmed_by_numbers(expression, derived, symbols):
            best = min(best, candidate.cost)
            yield Edited(formula, candidate.words, candidate.cost, proved)


def _tidied(tree: Tree) -> Tree:
    """The tree with x for x**1."""
    return rebuild(
        tree, lambda node: node.base if isinstance(node, Power) and node.exponent == Number("1") else node
    )


def _confirmed_by_numbers(expression: Expr, derived: Expr, symbols: Sequence[Variable]) -> bool:
    comparison = Comparison(expression, derived, symbols)
    return all(comparison.differ_at(point) is None for point in generic_points(symbols, ENOUGH))
