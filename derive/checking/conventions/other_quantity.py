"""What else a formula that differs may be: another quantity of the catalogue.

Only quantities of the same dimension, in the symbols that are printed, are derived; what is worth the same at a point
is looked up, so that only few equalities are left to prove.
"""

from __future__ import annotations

import time
from collections.abc import Iterator, Sequence
from difflib import SequenceMatcher
from functools import lru_cache

from radartrack.derive.catalogue import family
from radartrack.derive.checking.conventions.altered_question import (
    Asked,
    Point,
    Trial,
    evaluated,
    trial,
    without_correlation,
)
from radartrack.derive.checking.question.compared_quantity import Part
from radartrack.derive.checking.reporting.verdict import Suggestion
from radartrack.derive.evaluation.many_digits import Number
from radartrack.derive.language.quantity import Quantity
from radartrack.derive.language.tensor import Index, Tensor, indices

SECONDS = 0.3  # spent on deriving other quantities to compare with


def other_quantities(asked: Asked, *, uncorrelated: bool) -> tuple[Suggestion, ...]:
    """The quantity of the same model that the formula equals, up to a sign: the one nearest by name.

    Args:
        asked: what is printed, and what it was compared with.
        uncorrelated: whether it may equal that only where all correlations are zero.
    """
    part = asked.reference.part
    if part is None or not any(expression.free_symbols for expression in asked.printed):
        return ()  # a number is many things
    trials = [trial(asked), *(without_correlation(asked) if uncorrelated else ())]
    found = next(_others(asked, part, trials), None)
    return (Suggestion(found, f"this is {found}, not {asked.reference.text}", proved=True),) if found else ()


def _others(asked: Asked, part: Part, trials: Sequence[Trial]) -> Iterator[str]:
    deadline = time.monotonic() + SECONDS
    for quantity in _candidates(part.quantity):
        for places, name in _slices(part, quantity):
            if time.monotonic() > deadline:
                return
            if asked.may_be(quantity, places):
                yield from (f"{sign}{name}{found.words}" for sign, found in _equalities(trials, quantity, places))


def _equalities(trials: Sequence[Trial], quantity: Quantity, places: Sequence[Index]) -> Iterator[tuple[str, Trial]]:
    """With which sign, and in which trials, the formula is these entries of a quantity."""
    for sign, prefix in ((1, ""), (-1, "-")):
        yield from ((prefix, one) for one in trials if _is(one, quantity, places, sign))


def _is(one: Trial, quantity: Quantity, places: Sequence[Index], sign: int) -> bool:
    """Whether the formula is proved to be these entries of a quantity, with this sign."""
    values = _values(quantity, one.point)
    if values is None:
        return False
    return one.is_worth([values[place] for place in places], sign) and one.proves(
        Tensor(one.printed.shape, tuple(sign * quantity.expression[place] for place in places))
    )


@lru_cache(maxsize=1024)
def _values(quantity: Quantity, point: Point) -> dict[Index, Number] | None:
    """The entries of a quantity at a point; None where they have no value."""
    values = evaluated(quantity.expression, quantity.symbols, point)
    return dict(zip(indices(quantity.shape), values, strict=True)) if values is not None else None


def _candidates(quantity: Quantity) -> list[Quantity]:
    """Quantities of the same model and rank, the most similar names first; the quantity itself leads."""
    alike = [other for other in dict.fromkeys([quantity, *family(quantity)]) if len(other.shape) == len(quantity.shape)]
    return sorted(alike, key=lambda other: -SequenceMatcher(None, other.name, quantity.name).ratio())


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
