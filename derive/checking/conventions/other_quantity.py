"""What else a formula that differs may be: another quantity of the catalogue.

Only quantities of the same dimension, in the symbols that are printed, are derived; what is worth the same at a point
is looked up, so that only few equalities are left to prove.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from difflib import SequenceMatcher
from functools import lru_cache
from itertools import islice

from radartrack.derive import symbolic as sp
from radartrack.derive.catalogue import catalogue, family
from radartrack.derive.checking.conventions.altered_question import (
    Asked,
    Point,
    Trial,
    evaluated,
    trial,
    without_correlation,
)
from radartrack.derive.checking.conventions.convention import conventions
from radartrack.derive.checking.question.compared_quantity import Part, Reference
from radartrack.derive.checking.question.conditions import under
from radartrack.derive.checking.question.formula_units import Dimension
from radartrack.derive.checking.reporting.verdict import Suggestion
from radartrack.derive.evaluation.many_digits import Number
from radartrack.derive.language.quantity import Quantity
from radartrack.derive.language.tensor import Index, Tensor, indices
from radartrack.derive.symbolic import Expr, Symbol
from radartrack.derive.units import Unit

SECONDS = 2.0  # of one core, spent on deriving other quantities to compare with
RIVALS = 6  # quantities of other models that a formula is read again for
PREDICTED = "predicted_"
TRIALS = 8  # conventions in which the print is compared with them
_processor_time: Callable[[], float] = getattr(time, "thread_time", time.perf_counter)  # browsers do not count it


@dataclass(frozen=True)
class Setting:
    """A condition on what only the other quantity has: a prediction as good as the measurement, or a perfect one."""

    words: str = ""
    changes: Mapping[Symbol, Expr] = field(default_factory=dict)


def other_quantities(asked: Asked, *, uncorrelated: bool) -> tuple[Suggestion, ...]:
    """The quantity of the same model that the formula equals, up to a sign: the one nearest by name.

    Args:
        asked: what is printed, and what it was compared with.
        uncorrelated: whether it may equal that only where all correlations are zero, or in another convention.
    """
    part = asked.reference.part
    if part is None or not any(expression.free_symbols for expression in asked.printed):
        return ()  # a number is many things
    plain = uncorrelated and not asked.uses(asked.correlations)
    trials = [trial(asked), *(without_correlation(asked) if plain else ())]
    trials += _in_other_conventions(asked) if uncorrelated else ()
    found = next(_others(asked, part, trials, _candidates(part.quantity)), None)
    if found is None:
        return ()
    general = _general(found, asked, part, trials)
    return tuple(
        Suggestion(one, f"this is {one}, not {asked.reference.text}", proved=True) for one in (found, *general)
    )


def _general(found: str, asked: Asked, part: Part, trials: Sequence[Trial]) -> tuple[str, ...]:
    """Of a covariance of the unbiased estimate, of which prediction the decorrelated one is the same."""
    if ".unbiased.covariance." not in found:
        return ()
    decorrelated = [one for one in _candidates(part.quantity) if ".decorrelated.covariance" in one.name]
    return tuple(islice(_others(asked, part, trials, decorrelated), 1))


def _in_other_conventions(asked: Asked) -> list[Trial]:
    """The print in the conventions that change no sign of an entry."""
    plain = (one for one in conventions(asked) if one.changes and not one.factors and not one.offsets)
    likely = sorted(islice(plain, 3 * TRIALS), key=lambda one: one.cost)[:TRIALS]
    return [trial(asked, one.words, vanishing=one.vanishing, changes=one.changes) for one in likely]


def siblings(asked: Asked) -> Iterator[tuple[str, Tensor[Expr]]]:
    """Quantities of the same model that the print may be meant for, by name and entries, the nearest by name first."""
    part, known = asked.reference.part, set(asked.reference.symbols)
    if part is None:
        return
    for quantity in _candidates(part.quantity):
        if quantity is part.quantity or not set(quantity.symbols) <= known:
            continue
        for places, name in _slices(part, quantity)[:1]:
            if asked.may_be(quantity, places):
                yield name, Tensor(part.shape, tuple(quantity.expression[place] for place in places))


def _others(asked: Asked, part: Part, trials: Sequence[Trial], candidates: Iterable[Quantity]) -> Iterator[str]:
    deadline = _processor_time() + SECONDS
    for quantity in candidates:
        for places, name in _slices(part, quantity):
            if _processor_time() > deadline:
                return
            if asked.may_be(quantity, places):
                yield from (f"{sign}{name}{words}" for sign, words in _equalities(trials, quantity, places))


def _equalities(trials: Sequence[Trial], quantity: Quantity, places: Sequence[Index]) -> Iterator[tuple[str, str]]:
    """With which sign, in which trials and settings the formula is these entries of a quantity."""
    for setting in _settings(quantity):
        for sign, prefix in ((1, ""), (-1, "-")):
            for one in trials:
                if _is(one, quantity, places, sign, setting):
                    yield prefix, f"{setting.words}{one.words}"


def _settings(quantity: Quantity) -> list[Setting]:
    """None, and those of the prediction that the quantity is averaged over, where it is over one."""
    predicted = [one for one in quantity.symbols if one.name.startswith(PREDICTED)]
    known = {symbol.name: symbol for symbol in quantity.symbols}
    same = {one: known.get(one.name.removeprefix(PREDICTED)) for one in predicted}
    if not predicted or None in same.values():
        return [Setting()]
    alike: dict[Symbol, Expr] = {symbol: value for symbol, value in same.items() if value is not None}
    return [
        Setting(),
        Setting(" with a prediction as good as the measurement", alike),
        Setting(" with a perfect prediction", {symbol: sp.Integer(0) for symbol in predicted}),
    ]


def _is(one: Trial, quantity: Quantity, places: Sequence[Index], sign: int, setting: Setting) -> bool:
    """Whether the formula is proved to be these entries of a quantity, with this sign."""
    values = _values(quantity, _moved(one.point, setting))
    if values is None:
        return False
    return one.is_worth([values[place] for place in places], sign) and one.proves(
        Tensor(one.printed.shape, tuple(sign * under(setting.changes, quantity.expression[place]) for place in places))
    )


def _moved(point: Point, setting: Setting) -> Point:
    """The point with the symbols of a prediction set."""
    values = dict(point)
    moved = {
        symbol.name: values[str(value)] if value.is_Symbol else 0 * values[symbol.name]
        for symbol, value in setting.changes.items()
    }
    return tuple((values | moved).items())


@lru_cache(maxsize=1024)
def _values(quantity: Quantity, point: Point) -> dict[Index, Number] | None:
    """The entries of a quantity at a point; None where they have no value."""
    values = evaluated(quantity.expression, quantity.symbols, point)
    return dict(zip(indices(quantity.shape), values, strict=True)) if values is not None else None


def rivals(reference: Reference) -> list[str]:
    """Quantities of the same shape, units and kind that may be in other symbols: the same thing in another model."""
    part = reference.part
    if part is None:
        return []
    dimensions = list(reference.dimensions)
    words = set(part.quantity.name.split(".")[1:])
    found = []
    for other in catalogue().values():
        common = words & set(other.name.split(".")[1:])
        if other is part.quantity or other.shape != part.quantity.shape or not common:
            continue
        if _with_units(other) == _with_units(part.quantity):
            continue  # one of those that are compared by value
        if all(Dimension.of(other.unit(p)).agrees(d) for p, d in zip(part.places, dimensions, strict=True)):
            found.append((-len(common), other.name + _brackets(part, other)))
    return [name for _, name in sorted(found)[:RIVALS]]


def _with_units(quantity: Quantity) -> set[tuple[str, Unit]]:
    """The symbols of a quantity; those of one name may be of several units."""
    return {(symbol.name, symbol.unit) for symbol in quantity.symbols}


def _candidates(quantity: Quantity) -> list[Quantity]:
    """Quantities of the same model and rank, the most similar names first; the quantity itself leads."""
    alike = [other for other in dict.fromkeys([quantity, *family(quantity)]) if len(other.shape) == len(quantity.shape)]
    return sorted(alike, key=lambda other: -SequenceMatcher(None, other.name, quantity.name).ratio())


def _slices(part: Part, quantity: Quantity) -> list[tuple[list[Index], str]]:
    """The same entries of another quantity; of a single entry, every entry of either that is not the same formula.

    A matrix is no corner of a larger one: that is not even derived.
    """
    is_matrix = bool(part.shape) and part.shape == part.quantity.shape
    return [] if is_matrix and quantity.shape != part.shape else list(_all_slices(part, quantity))


def _all_slices(part: Part, quantity: Quantity) -> Iterator[tuple[list[Index], str]]:
    places = list(part.places)
    fits = all(all(i < n for i, n in zip(place, quantity.shape, strict=True)) for place in places)
    if fits and quantity is not part.quantity:
        yield places, quantity.name + _brackets(part, quantity)
    if not part.shape and quantity.shape:
        for place in indices(quantity.shape):
            if place != places[0] and (quantity is not part.quantity or not _is_same(quantity, place, places[0])):
                yield [place], f"{quantity.name}[{','.join(map(str, place))}]"


def _is_same(quantity: Quantity, first: Index, second: Index) -> bool:
    """Whether two entries are one formula, as they are in a symmetric matrix."""
    return quantity.expression[first] == quantity.expression[second]


def _brackets(part: Part, quantity: Quantity) -> str:
    """The index as it was given, where it was: entries of a tensor, or all of it."""
    whole = part.shape == part.quantity.shape and list(part.places) == list(indices(quantity.shape))
    if whole:
        return ""
    ends = zip(part.places.entries[0], part.places.entries[-1], quantity.shape, strict=True)
    return "[" + ",".join(map(_range, *zip(*ends, strict=True))) + "]"


def _range(first: int, last: int, size: int) -> str:
    """A place, or places side by side, along an axis of this size."""
    if first == last:
        return str(first)
    return ":" if (first, last) == (0, size - 1) else f"{first}:{last + 1}"
