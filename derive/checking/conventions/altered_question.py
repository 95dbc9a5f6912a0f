"""Trials of a printed formula: compared under further conditions, or after a change of convention."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property

from radartrack.derive.algebra.equality import proved_equal
from radartrack.derive.catalogue import family
from radartrack.derive.checking.question.compared_quantity import Reference
from radartrack.derive.checking.question.conditions import also_zero, under, when_zero
from radartrack.derive.checking.question.formula_units import Dimension
from radartrack.derive.evaluation.many_digits import Evaluator, Number
from radartrack.derive.evaluation.points import generic_points
from radartrack.derive.language.quantity import Quantity
from radartrack.derive.language.tensor import Index, Tensor
from radartrack.derive.language.variable import Variable
from radartrack.derive.symbolic import Expr, Symbol

ALIKE = 1e-40

Point = tuple[tuple[str, Number], ...]


@dataclass(frozen=True)
class Asked:
    """What is printed and of what dimension, what it was compared with, and under which conditions.

    Attributes:
        letters: what the letters of the print that are no symbols of ours stand for, by name.
    """

    reference: Reference
    printed: Tensor[Expr]
    dimensions: Tensor[Dimension | None]
    conditions: Mapping[Symbol, Expr]
    letters: Mapping[str, Variable] = field(default_factory=dict)

    def may_be(self, quantity: Quantity, places: Sequence[Index]) -> bool:
        """Whether these entries of a quantity have the dimensions and the symbols that are printed."""
        units = (Dimension.of(quantity.unit(place)) for place in places)
        return self._symbols <= set(quantity.symbols) and all(
            found is not None and (found.free or found.agrees(unit))
            for found, unit in zip(self.dimensions, units, strict=True)
        )

    def uses(self, symbols: Sequence[Symbol]) -> bool:
        """Whether any of these is printed."""
        return any(entry.free_symbols & set(symbols) for entry in self.printed)

    @property
    def correlations(self) -> list[Variable]:
        """Those that the conditions leave free."""
        return [one for one in self.reference.symbols if one.is_correlation and one not in self.conditions]

    @cached_property
    def family(self) -> list[Variable]:
        """The symbols of all quantities of the model, so that one point serves them all."""
        parts = self.reference.parts
        symbols = (symbol for part in parts for one in family(part.quantity) for symbol in one.symbols)
        known = {symbol.name: symbol for symbol in (*symbols, *self.reference.symbols)}
        return list(known.values())

    @cached_property
    def _symbols(self) -> set[Symbol]:
        """Those that stay, whatever is set to zero."""
        used = set[Symbol]().union(*(under(self.conditions, entry).free_symbols for entry in self.printed))
        return used - {symbol for symbol in self.reference.symbols if symbol.is_correlation}


@dataclass(frozen=True)
class Trial:
    """A comparison at a point and, where the values there are the same, by proof.

    Attributes:
        conditions: what symbols are replaced by.
        words: what is changed, where it is not what was asked for: " when rho = 0".
        printed: the entries of the formula.
        symbols: those of the model.
        point: their values, with which the conditions hold.
        values: what the entries are worth there; None where they, or the conditions, have no value.
    """

    conditions: Mapping[Symbol, Expr]
    words: str
    printed: Tensor[Expr]
    symbols: Sequence[Variable]
    point: Point
    values: tuple[Number, ...] | None

    def equals(self, entries: Tensor[Expr]) -> bool:
        """Whether the formula is proved equal to these entries."""
        return self.is_worth(evaluated(entries, self.symbols, self.point)) and self.proves(entries)

    def is_worth(self, values: Sequence[Number] | None, sign: int = 1) -> bool:
        """Whether the formula has these values, times the sign, at the point."""
        if self.values is None or values is None:
            return False
        return all(_alike(own, value, sign) for own, value in zip(self.values, values, strict=True))

    def proves(self, entries: Tensor[Expr]) -> bool:
        """Whether there is a proof that the formula equals these entries."""
        pairs = zip(self.printed, entries, strict=True)
        return all(proved_equal(under(self.conditions, a), under(self.conditions, b)) for a, b in pairs)


def trial(
    asked: Asked, words: str = "", *, vanishing: Sequence[Symbol] = (), changes: Mapping[Symbol, Expr] | None = None
) -> Trial:
    """What was asked, with some symbols vanishing, and others in the print replaced."""
    (values,) = generic_points(asked.family, 1)
    both = also_zero(asked.conditions, vanishing)
    conditions = asked.conditions if both is None else both
    replaced = evaluated(Tensor((len(conditions),), tuple(conditions.values())), asked.family, tuple(values.items()))
    names = [symbol.name for symbol in conditions]
    point = tuple((values | dict(zip(names, replaced or (), strict=False))).items())
    printed = asked.printed.map(lambda entry: under(changes or {}, entry))
    worth = None if both is None else evaluated(printed, asked.family, point)
    return Trial(conditions, words, printed, asked.family, point, worth)


def without_correlation(asked: Asked) -> list[Trial]:
    """What was asked, with all correlations zero; nothing where there is none to set."""
    free = asked.correlations
    return [trial(asked, when_zero(free), vanishing=free)] if free else []


def evaluated(entries: Tensor[Expr], symbols: Sequence[Variable], point: Point) -> tuple[Number, ...] | None:
    """The entries at a point; None where one has no value."""
    known = dict(point)
    try:
        return Evaluator(entries, symbols)([known[symbol.name] for symbol in symbols]).entries
    except (ArithmeticError, ValueError):
        return None


def _alike(first: Number, second: Number, sign: int) -> bool:
    difference = first - second if sign > 0 else first + second  # a product would be rounded to few digits
    return bool(abs(difference) <= ALIKE * max(abs(first), abs(second)))
