"""Slips in definitions: what a paper calls lambda may be misprinted, and every formula in lambda is wrong with it.

A definition is tried with each of the slips that print is prone to; what is wanted of it does not follow from what is
wanted of the formulas, as they may hold it several times and by way of other definitions.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

from radartrack.derive.algebra.equality import proved_equal
from radartrack.derive.checking.question.conditions import under
from radartrack.derive.checking.question.names import Names
from radartrack.derive.checking.repairing.edit_search import Search
from radartrack.derive.checking.repairing.print_slips import (
    Alternative,
    plain_words,
    slips,
)
from radartrack.derive.checking.repairing.smallest_edit import AT_ONE_PLACE, values_at
from radartrack.derive.evaluation.points import generic_points
from radartrack.derive.evaluation.tree_values import Program, Screen, Values, close
from radartrack.derive.formula.error import FormulaError
from radartrack.derive.formula.printing import to_text
from radartrack.derive.formula.tree import (
    Name,
    Negation,
    Number,
    Product,
    Quotient,
    Tree,
    children,
    replace_at,
    walk,
)
from radartrack.derive.formula.tree import names as names_of
from radartrack.derive.language.variable import Variable
from radartrack.derive.reading.grammar import check_tree
from radartrack.derive.symbolic import Expr, Symbol

POINTS = 4
POINTS_OF_SEARCH = 18  # as many as the search for edits of a formula takes
ENOUGH = 3
TRIES = 4000  # slips that are tried: of twelve long definitions only so many


@dataclass(frozen=True)
class Mended:
    """A definition without its slip.

    Attributes:
        name: what is defined.
        formula: how it should be defined.
        edit: what was changed, in words.
        cost: how unlikely the slip is.
        mends: which of the formulas it makes right; by their places.
    """

    name: str
    formula: str
    edit: str
    cost: float
    mends: tuple[int, ...]


@dataclass(frozen=True)
class Formula:
    """A printed formula over definitions, and what it should be in the quantity's symbols."""

    tree: Tree
    expected: Expr


def mended_definitions(
    formulas: Sequence[Formula], names: Names, symbols: Sequence[Variable], conditions: Mapping[Symbol, Expr]
) -> list[Mended]:
    """The slips in definitions without which the most formulas are right, and none is wrong that was right."""
    if not names.definitions:
        return []
    trial = _Trial(formulas, names, symbols, conditions)
    found: list[Mended] = []
    told: list[tuple[str, Expr | None]] = []  # what is the same in other words is told once
    most = 1
    candidates = list(trial.candidates()) or list(trial.wanted())
    for candidate in sorted(candidates, key=lambda one: (-len(one.mends), one.cost)):
        if len(candidate.mends) < most or len(found) == ENOUGH:
            break
        if any(one.name == candidate.name and candidate.cost >= one.cost + AT_ONE_PLACE for one in found):
            continue
        worth = candidate.name, trial.worth(candidate)
        if worth in told:
            place = told.index(worth)
            found[place] = min(found[place], candidate.mended, key=lambda one: len(one.formula))
        elif trial.is_proved(candidate):
            most = len(candidate.mends)
            told.append(worth)
            found.append(candidate.mended)
    return found


@dataclass(frozen=True)
class _Candidate:
    name: str
    tree: Tree
    edit: Alternative
    mends: tuple[int, ...]

    @property
    def cost(self) -> float:
        return self.edit.cost

    @property
    def mended(self) -> Mended:
        return Mended(self.name, to_text(self.tree), self.edit.words, self.cost, self.mends)


class _Trial:
    """The formulas at some points, with definitions that are changed."""

    def __init__(
        self,
        formulas: Sequence[Formula],
        names: Names,
        symbols: Sequence[Variable],
        conditions: Mapping[Symbol, Expr],
    ) -> None:
        self._formulas, self._names, self._symbols, self._conditions = formulas, names, symbols, conditions
        self._trees, self._kinds = names.definitions, names.dimensions
        points = [[point[symbol.name] for symbol in symbols] for point in generic_points(symbols, POINTS)]
        own = {name: value for name, value in names.numbers.items() if name not in self._trees}
        values = {name: values_at(under(conditions, value), symbols, points) for name, value in own.items()}
        known = {name: value for name, value in values.items() if value is not None}
        self._own = [{name: value[place] for name, value in known.items()} for place in range(POINTS)]
        self._wanted = [values_at(formula.expected, symbols, points) for formula in formulas]
        self._programs = {name: Program(tree) for name, tree in self._trees.items()}
        self._printed = [Program(formula.tree) for formula in formulas]
        self._defined = [self._definitions(own, {}) for own in self._own]
        self._right = self._rightness(self._defined)

    def candidates(self) -> Iterator[_Candidate]:
        """Slips without which more formulas have the values that they should have, and none is spoilt."""
        tries = 0
        for name in self._needed():
            tree = self._trees[name]
            for path, node in walk(tree):
                for edit in self._slips(node, name, whole=not path):
                    tries += 1
                    if tries > TRIES:
                        return
                    changed = replace_at(tree, path, edit.tree)
                    if changed != tree and (mends := self._mends(name, changed)):
                        yield _Candidate(name, changed, edit, mends)

    def wanted(self) -> Iterator[_Candidate]:
        """Edits that give a definition the values that a formula wants of it, in which it stands once."""
        for name in self._needed():
            for place, formula in enumerate(self._formulas):
                if self._right[place] or (needed := self._needed_of(name, place)) is None:
                    continue
                before = list(self._trees)[list(self._trees).index(name) :]
                known = {one: value for one, value in self._screen.names.items() if one not in before}
                tree, screen = self._trees[name], Screen(known, POINTS_OF_SEARCH)
                for edit in Search(screen, needed, self._names, tree, [formula.tree]).edits(tree)[:ENOUGH]:
                    if edit.tree != tree and (mends := self._mends(name, edit.tree)):
                        yield _Candidate(
                            name, edit.tree, Alternative(edit.tree, plain_words(edit.words), edit.cost), mends
                        )
                break

    def _needed_of(self, name: str, place: int) -> Values | None:
        """What a definition would have to be worth for a formula; None where it does not stand there just once."""
        tree, needed = self._formulas[place].tree, self._search_wanted(place)
        paths = [path for path, node in walk(tree) if isinstance(node, Name) and node.name == name]
        others = names_of(tree) & self._trees.keys() - {name}
        if len(paths) != 1 or needed is None or any(name in self._rests_on(one) for one in others):
            return None
        for step in paths[0]:
            found = self._screen.required(tree, needed)
            if step >= len(found) or (value := found[step]) is None:
                return None
            needed, tree = value, children(tree)[step]
        return needed

    def _rests_on(self, name: str) -> frozenset[str]:
        """The definitions on which one rests."""
        below = names_of(self._trees[name]) & self._trees.keys()
        return below.union(*map(self._rests_on, below))

    def _search_wanted(self, place: int) -> Values | None:
        return values_at(self._formulas[place].expected, self._symbols, self._points)

    @cached_property
    def _points(self) -> list[list[float]]:
        found = generic_points(self._symbols, POINTS_OF_SEARCH)
        return [[point[symbol.name] for symbol in self._symbols] for point in found]

    @cached_property
    def _screen(self) -> Screen:
        """What all names are worth at the points of a search."""
        values = {
            name: values_at(under(self._conditions, value), self._symbols, self._points)
            for name, value in self._names.numbers.items()
        }
        return Screen({name: value for name, value in values.items() if value is not None}, POINTS_OF_SEARCH)

    def worth(self, candidate: _Candidate) -> Expr | None:
        """What the definition stands for then."""
        try:
            return self._names.redefined(candidate.name, candidate.tree).numbers.get(candidate.name)
        except FormulaError:
            return None

    def is_proved(self, candidate: _Candidate) -> bool:
        """Whether the formulas are proved right with the definition changed."""
        try:
            check_tree(candidate.tree)
            names = self._names.redefined(candidate.name, candidate.tree)
            return all(
                proved_equal(under(self._conditions, names.read(formula.tree)), formula.expected)
                for place, formula in enumerate(self._formulas)
                if place in candidate.mends
            )
        except FormulaError:
            return False

    def _needed(self) -> list[str]:
        """The definitions on which formulas rest that are wrong, the first on which the others rest last."""
        wrong = (one.tree for one, is_right in zip(self._formulas, self._right, strict=True) if not is_right)
        needed = set[str]().union(*map(names_of, wrong))
        for name in reversed(self._trees):
            if name in needed:
                needed |= names_of(self._trees[name])
        return [name for name in reversed(self._trees) if name in needed - self._names.fixed]

    def _slips(self, node: Tree, name: str, *, whole: bool) -> Iterator[Alternative]:
        before = list(self._trees)[list(self._trees).index(name) :]
        kinds = {one: kind for one, kind in self._kinds.items() if one not in before}
        yield from slips(node, kinds)
        if whole:
            two = Number("2")
            yield Alternative(Product((two, node)), "a missing factor 2", 1.8)
            yield Alternative(Quotient(node, two), "a missing factor 1/2", 1.8)
            yield Alternative(Negation(node), "the sign of {}", 2.5, (node,))  # squares are mostly meant

    def _mends(self, name: str, changed: Tree) -> tuple[int, ...]:
        """The formulas that are right then and were not; none where one is spoilt."""
        first = self._definitions(self._own[0], {name: Program(changed)}, self._defined[0])
        if not any(self._is_worth(place, 0, first) for place, right in enumerate(self._right) if not right):
            return ()
        after = self._rightness([self._definitions(own, {name: Program(changed)}) for own in self._own])
        both = list(zip(self._right, after, strict=True))
        return () if (True, False) in both else tuple(place for place, pair in enumerate(both) if pair == (False, True))

    def _definitions(
        self, own: Mapping[str, float], changed: Mapping[str, Program], known: Mapping[str, float] | None = None
    ) -> dict[str, float]:
        """What the names are worth at a point; those known stay up to the first that is changed."""
        values, is_changed = dict(own), False
        for name, program in {**self._programs, **changed}.items():
            is_changed = is_changed or name in changed
            if known is not None and not is_changed and name in known:
                values[name] = known[name]
                continue
            if (value := program(values)) is not None:
                values[name] = value[0]
        return values

    def _rightness(self, known: Sequence[Mapping[str, float]]) -> list[bool]:
        return [
            all(self._is_worth(place, point, values) for point, values in enumerate(known))
            for place in range(len(self._formulas))
        ]

    def _is_worth(self, place: int, point: int, values: Mapping[str, float]) -> bool:
        wanted = self._wanted[place]
        found = self._printed[place](values)
        return wanted is not None and close(found, wanted[point : point + 1])
