"""Suggests what was meant in a definition, or inside of what a formula works out: there an edit changes many places."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

from radartrack.derive.algebra.equality import proved_equal
from radartrack.derive.checking.question.conditions import under
from radartrack.derive.checking.question.meaning import shape_of, tensor
from radartrack.derive.checking.question.names import Names
from radartrack.derive.checking.question.padding import trimmed
from radartrack.derive.checking.question.printed_formula import Printed, printed
from radartrack.derive.checking.question.printed_shape import reshaped
from radartrack.derive.checking.repairing.edit_search import Candidate
from radartrack.derive.checking.repairing.reworked_edits import ENOUGH, MOST, SECONDS, processor_time, single_edits
from radartrack.derive.checking.reporting.barrier import attempted
from radartrack.derive.checking.reporting.derived_formula import as_printed
from radartrack.derive.evaluation.many_digits import Evaluator, Number
from radartrack.derive.evaluation.points import generic_points
from radartrack.derive.evaluation.tree_values import Screen, Values, close
from radartrack.derive.formula.error import FormulaError
from radartrack.derive.formula.printing import to_text
from radartrack.derive.formula.shape import Shape
from radartrack.derive.formula.tree import Tree
from radartrack.derive.formula.tree import names as names_of
from radartrack.derive.formula.written_out import written_out
from radartrack.derive.language.tensor import Tensor
from radartrack.derive.language.variable import Variable
from radartrack.derive.symbolic import Expr, Symbol

POINTS = 3
SAME = 1e-30
FORMULA = ""  # where a slip is that stands in no definition


@dataclass(frozen=True)
class Slip:
    """A slip that was undone.

    Attributes:
        formula: the definition or the formula without it.
        words: what was changed.
        cost: how unlikely it is.
        definition: of what it is, where it is one.
    """

    formula: str
    words: str
    cost: float
    definition: str = ""


@dataclass(frozen=True)
class Repair:
    """A formula, what it should be, and what it is made of.

    Attributes:
        formula: as printed.
        names: without those of its parts.
        derived: what its entries should be, under the conditions.
        symbols: that occur.
        conditions: of the question.
    """

    formula: Printed
    names: Names
    derived: Tensor[Expr]
    symbols: Sequence[Variable]
    conditions: Mapping[Symbol, Expr]

    def slips(self, most: float = math.inf) -> list[Slip]:
        """The likeliest single slips of which each explains every entry, none of them above a cost."""
        until = processor_time() + SECONDS
        found: list[Slip] = []
        told: list[object] = []  # what is the same in other words is told once
        candidates = (pair for pair in self._candidates() if pair[1].cost <= most)
        for where, one in sorted(candidates, key=lambda pair: pair[1].cost)[:MOST]:
            if processor_time() > until or len(found) >= ENOUGH or (found and one.cost > found[0].cost):
                break
            if self._screened(where, one.tree) and attempted(self._confirmation(where, one.tree), lambda _: False):
                text = to_text(one.tree)
                worth = attempted(lambda tree=one.tree: self.names.worked_out(tree), lambda _, text=text: text)  # type: ignore[misc]
                if worth not in told:
                    told.append(worth)
                    found.append(_of_definition(where, text, one) if where else Slip(text, one.words, one.cost))
        return found

    @cached_property
    def _definitions(self) -> dict[str, Tree]:
        """Those that the formula needs, each after those that it needs itself."""
        return self.names.definitions_in(self.formula.tree)

    def _candidates(self) -> Iterator[tuple[str, Candidate]]:
        kinds = self.names.dimensions
        later = set(self._definitions)  # what a definition cannot mention
        for name, tree in self._definitions.items():
            others = {one: kind for one, kind in kinds.items() if one not in later}
            later.discard(name)
            arrays = {one: shape for one, shape in self._arrays.items() if one not in later and one != name}
            edits = () if name in self.names.fixed else single_edits(tree, others, arrays)
            yield from ((name, candidate) for candidate in edits)
        if _is_worked_out(self.formula):
            yield from ((FORMULA, one) for one in single_edits(self.formula.tree, kinds, self._arrays))

    @cached_property
    def _arrays(self) -> dict[str, Shape]:
        """The shapes of the names that stand for arrays."""
        mentioned = names_of(self.formula.tree).union(*map(names_of, self._definitions.values()))
        found = {name: shape_of(self.names[name]) for name in mentioned if name in self.names}
        return {name: shape for name, shape in found.items() if shape}

    def _confirmation(self, where: str, tree: Tree) -> Callable[[], bool]:
        return lambda: self._is_right(where, tree)

    def _is_right(self, where: str, tree: Tree) -> bool:
        """Whether every entry is proved with the edit, all worked out again."""
        names = self.names.redefined(where, tree) if where else self.names
        again = printed(self.formula.tree if where else tree, names, self.formula.entries.shape)
        entries = again.expressions.map(lambda entry: under(self.conditions, entry))
        pairs = list(zip(entries, self.derived, strict=True))
        return self._alike(entries) and all(proved_equal(*pair) for pair in pairs)

    def _alike(self, entries: Tensor[Expr]) -> bool:
        """Whether the entries are right at a point."""
        (point,) = generic_points(self.symbols, 1)
        values = [point[symbol.name] for symbol in self.symbols]
        found = Evaluator(entries, self.symbols)(values)
        return all(_near(one, other) for one, other in zip(found, self._worth, strict=True))

    @cached_property
    def _worth(self) -> Tensor[Number]:
        (point,) = generic_points(self.symbols, 1)
        return Evaluator(self.derived, self.symbols)([point[symbol.name] for symbol in self.symbols])

    def _screened(self, where: str, tree: Tree) -> bool:
        """Whether an edit may be right by its values in floating point; where these do not tell, it may."""
        if self._targets is None:
            return True
        values: dict[str, Values] = dict(self._symbols)
        arrays = dict(self._quantities)
        for name, definition in self._definitions.items():
            opened = _opened(tree if name == where else definition, arrays)
            if opened is None:
                return True
            if opened.shape:
                arrays[name] = opened
                continue
            if (value := Screen(values, POINTS)(opened.entries[0])) is None:
                return False
            values[name] = value
        inner, _ = trimmed(self.formula.tree if where else tree, self.derived.shape)
        entries = _opened(inner, arrays)
        if entries is None:
            return True
        screen = Screen(values, POINTS)
        entries = reshaped(entries, self.derived.shape, row_by_row=bool(self.formula.source))
        return entries.shape == self.derived.shape and all(
            close(screen(entry), wanted) for entry, wanted in zip(entries, self._targets, strict=True)
        )

    @cached_property
    def _quantities(self) -> dict[str, Tensor[Tree]]:
        """The entries of those that are called by name, as formulas."""
        own = self._arrays.keys() - self._definitions.keys()
        return {name: tensor(self.names[name]).map(as_printed) for name in own}

    @cached_property
    def _targets(self) -> list[Values] | None:
        """What the entries should be worth at some points; None where floating point does not tell."""
        found = [self._at_points(entry) for entry in self.derived]
        return [value for value in found if value is not None] if None not in found else None

    @cached_property
    def _symbols(self) -> dict[str, Values]:
        used = {name: symbol for name, symbol in self.names.symbols.items() if name not in self._definitions}
        found = {name: self._at_points(under(self.conditions, symbol)) for name, symbol in used.items()}
        return {name: values for name, values in found.items() if values is not None}

    def _at_points(self, expression: Expr) -> Values | None:
        try:
            evaluate = Evaluator(Tensor((), (expression,)), self.symbols)
            points = generic_points(self.symbols, POINTS)
            return tuple(float(evaluate([p[s.name] for s in self.symbols]).entries[0]) for p in points)
        except (ArithmeticError, KeyError, TypeError, ValueError):
            return None


def has_inside(formula: Printed) -> bool:
    """Whether there is more in a formula than its entries and plain definitions: there other searches do not look."""
    definitions = formula.names.definitions_in(formula.tree).keys() - formula.names.definitions.keys()
    return _is_worked_out(formula) or bool(definitions)


def _of_definition(name: str, text: str, one: Candidate) -> Slip:
    return Slip(f"{name} = {text}", f"in the definition of {name}: {one.words}", one.cost, name)


def _near(one: Number, other: Number) -> bool:
    return bool(abs(one - other) <= SAME * max(abs(one), abs(other)))


def _is_worked_out(formula: Printed) -> bool:
    """Whether parts of the formula are worked out, inside of which no other search looks."""
    return bool(formula.worked_out)


def _opened(tree: Tree, arrays: Mapping[str, Tensor[Tree]]) -> Tensor[Tree] | None:
    """The entries of a formula of arrays, none of one that has no meaning; None where it has to be worked out."""
    try:
        return written_out(tree, arrays)
    except FormulaError:
        return Tensor((0,), ())
