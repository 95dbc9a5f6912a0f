"""What else a formula that differs may be: right under a condition, or another quantity of the catalogue.

Only quantities of the same dimension, in the symbols that are printed, are derived; what is worth the same at a point
is looked up, so that only few equalities are left to prove.
"""

from __future__ import annotations

import time
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from difflib import SequenceMatcher
from functools import cached_property, lru_cache

from radartrack.derive import symbolic as sp
from radartrack.derive.catalogue import catalogue
from radartrack.derive.checking.dimensions import Dimension
from radartrack.derive.checking.equality import proved_equal
from radartrack.derive.checking.points import generic_points
from radartrack.derive.checking.reference import Part, Reference
from radartrack.derive.checking.verdict import Suggestion
from radartrack.derive.evaluation import Evaluator, Number
from radartrack.derive.quantity import Quantity
from radartrack.derive.symbolic import Expr, Symbol
from radartrack.derive.tensor import Index, Tensor, indices
from radartrack.derive.variable import Variable

SECONDS = 0.3  # spent on deriving other quantities to compare with
ALIKE = 1e-40

Point = tuple[tuple[str, Number], ...]


@dataclass(frozen=True)
class Asked:
    """What is printed and of what dimension, what it was compared with, and under which conditions."""

    reference: Reference
    printed: Tensor[Expr]
    dimensions: Tensor[Dimension | None]
    conditions: Mapping[Symbol, Expr]

    def may_be(self, quantity: Quantity, places: Sequence[Index]) -> bool:
        """Whether these entries of a quantity have the dimensions and the symbols that are printed."""
        units = (Dimension.of(quantity.unit(place)) for place in places)
        return self._symbols <= set(quantity.symbols) and all(
            found is not None and (found.free or found.agrees(unit))
            for found, unit in zip(self.dimensions, units, strict=True)
        )

    @cached_property
    def _symbols(self) -> set[Symbol]:
        """Those that stay, whatever is set to zero."""
        used = set[Symbol]().union(*(entry.xreplace(self.conditions).free_symbols for entry in self.printed))
        return used - {symbol for symbol in self.reference.symbols if symbol.is_correlation}


@dataclass(frozen=True)
class _Trial:
    """A comparison under conditions.

    Attributes:
        conditions: what symbols are replaced by.
        when: the condition in words, where it is not one that was asked for.
        printed: the entries of the formula.
        point: the values of the model's symbols at a point where the conditions hold.
        values: what the entries are worth there; None where they have no value.
    """

    conditions: Mapping[Symbol, Expr]
    when: str
    printed: Tensor[Expr]
    point: Point
    values: tuple[Number, ...] | None

    def equals(self, quantity: Quantity, places: Sequence[Index], sign: int) -> bool:
        """Whether the formula is proved to be these entries of a quantity, with this sign."""
        values = _values(quantity, self.point)
        if self.values is None or values is None:
            return False
        pairs = zip(self.values, places, strict=True)
        return all(_alike(value, values[place], sign) for value, place in pairs) and self.proves(
            Tensor(self.printed.shape, tuple(sign * quantity.expression[place] for place in places))
        )

    def proves(self, entries: Tensor[Expr]) -> bool:
        """Whether the formula is proved equal to these entries."""
        pairs = zip(self.printed, entries, strict=True)
        return all(proved_equal(a.xreplace(self.conditions), b.xreplace(self.conditions)) for a, b in pairs)


def conditions_that_help(asked: Asked) -> tuple[str, ...]:
    """`equal when rho = 0`, where that is proved."""
    trial = _without_correlation(asked)
    if trial is None or trial.values is None:
        return ()
    derived = _evaluated(asked.reference.entries, _symbols(asked), trial.point)
    alike = derived is not None and all(map(_alike, trial.values, derived))
    return (f"equal{trial.when}",) if alike and trial.proves(asked.reference.entries) else ()


def other_quantities(asked: Asked, *, uncorrelated: bool) -> tuple[Suggestion, ...]:
    """The quantity of the same model that the formula equals, up to a sign: the one nearest by name.

    Args:
        asked: what is printed, and what it was compared with.
        uncorrelated: whether it may equal that only where all correlations are zero.
    """
    part = asked.reference.part
    if part is None or not any(expression.free_symbols for expression in asked.printed):
        return ()  # a number is many things
    trials = [_as_asked(asked), _without_correlation(asked) if uncorrelated else None]
    found = next(_others(asked, part, [trial for trial in trials if trial]), None)
    return (Suggestion(found, f"this is {found}, not {asked.reference.text}", proved=True),) if found else ()


def _others(asked: Asked, part: Part, trials: Sequence[_Trial]) -> Iterator[str]:
    deadline = time.monotonic() + SECONDS
    for quantity in _candidates(part.quantity):
        for places, name in _slices(part, quantity):
            if time.monotonic() > deadline:
                return
            if asked.may_be(quantity, places):
                yield from (f"{sign}{name}{trial.when}" for sign, trial in _equalities(trials, quantity, places))


def _equalities(trials: Sequence[_Trial], quantity: Quantity, places: Sequence[Index]) -> Iterator[tuple[str, _Trial]]:
    """With which sign, and in which trials, the formula is these entries of a quantity."""
    for sign, prefix in ((1, ""), (-1, "-")):
        yield from ((prefix, trial) for trial in trials if trial.equals(quantity, places, sign))


def _as_asked(asked: Asked) -> _Trial:
    return _trial(asked, asked.conditions, "")


def _without_correlation(asked: Asked) -> _Trial | None:
    """The comparison with all correlations zero; None where there is none to set."""
    free = [one for one in asked.reference.symbols if one.is_correlation and one not in asked.conditions]
    if not free:
        return None
    zero: dict[Symbol, Expr] = {symbol: sp.Integer(0) for symbol in free}
    return _trial(asked, {**asked.conditions, **zero}, " when " + " and ".join(f"{symbol} = 0" for symbol in free))


def _trial(asked: Asked, conditions: Mapping[Symbol, Expr], when: str) -> _Trial:
    symbols = _symbols(asked)
    (values,) = generic_points(symbols, 1)
    point: Point = tuple(values.items())
    replaced = _evaluated(Tensor((len(conditions),), tuple(conditions.values())), symbols, point)
    names = [symbol.name for symbol in conditions]
    point = tuple((values | dict(zip(names, replaced or (), strict=False))).items())
    return _Trial(conditions, when, asked.printed, point, _evaluated(asked.printed, symbols, point))


def _symbols(asked: Asked) -> list[Variable]:
    """Those of all quantities of the model, so that one point serves them all."""
    modules = {part.quantity.module for part in asked.reference.parts.values()}
    family = (symbol for one in catalogue().values() if one.module in modules for symbol in one.symbols)
    known = {symbol.name: symbol for symbol in (*family, *asked.reference.symbols)}
    return list(known.values())


@lru_cache(maxsize=1024)
def _values(quantity: Quantity, point: Point) -> dict[Index, Number] | None:
    """The entries of a quantity at a point; None where they have no value."""
    values = _evaluated(quantity.expression, quantity.symbols, point)
    return dict(zip(indices(quantity.shape), values, strict=True)) if values is not None else None


def _evaluated(entries: Tensor[Expr], symbols: Sequence[Variable], point: Point) -> tuple[Number, ...] | None:
    known = dict(point)
    try:
        return Evaluator(entries, symbols)([known[symbol.name] for symbol in symbols]).entries
    except (ArithmeticError, ValueError):
        return None


def _alike(first: Number, second: Number, sign: int = 1) -> bool:
    difference = first - second if sign > 0 else first + second
    return bool(abs(difference) <= ALIKE * max(abs(first), abs(second)))


def _candidates(quantity: Quantity) -> list[Quantity]:
    """Quantities of the same model and rank, the most similar names first; the quantity itself leads."""
    family = [
        other
        for other in catalogue().values()
        if other.module == quantity.module and len(other.shape) == len(quantity.shape)
    ]
    return sorted(family, key=lambda other: -SequenceMatcher(None, other.name, quantity.name).ratio())


def _slices(part: Part, quantity: Quantity) -> Iterator[tuple[list[Index], str]]:
    """The same entries of another quantity; of a single entry, every entry of either."""
    places = list(part.places)
    fits = all(all(i < n for i, n in zip(place, quantity.shape, strict=True)) for place in places)
    if fits and quantity is not part.quantity:
        yield places, quantity.name + _brackets(part, quantity)
    if not part.shape and quantity.shape:
        for place in indices(quantity.shape):
            if place != places[0]:
                yield [place], f"{quantity.name}[{','.join(map(str, place))}]"


def _brackets(part: Part, quantity: Quantity) -> str:
    """The index as it was given, where it was: entries of a tensor, or all of it."""
    whole = part.shape == part.quantity.shape and list(part.places) == list(indices(quantity.shape))
    if whole:
        return ""
    first, last = part.places.entries[0], part.places.entries[-1]
    return "[" + ",".join(str(i) if i == j else ":" for i, j in zip(first, last, strict=True)) + "]"
