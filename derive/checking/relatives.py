"""What else a formula that differs may be: right under a condition, or another quantity of the catalogue."""

from __future__ import annotations

import time
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from difflib import SequenceMatcher

from radartrack.derive import symbolic as sp
from radartrack.derive.catalogue import catalogue
from radartrack.derive.checking.comparison import Comparison
from radartrack.derive.checking.equality import proved_equal
from radartrack.derive.checking.points import generic_points
from radartrack.derive.checking.reference import Part, Reference
from radartrack.derive.checking.verdict import Suggestion
from radartrack.derive.quantity import Quantity
from radartrack.derive.symbolic import Expr, Symbol
from radartrack.derive.tensor import Index, Tensor, indices
from radartrack.derive.variable import Variable

SECONDS = 0.5  # spent on deriving other quantities to compare with


@dataclass(frozen=True)
class Asked:
    """What is printed, what it was compared with, and under which conditions."""

    reference: Reference
    printed: Tensor[Expr]
    conditions: Mapping[Symbol, Expr]


def conditions_that_help(asked: Asked) -> tuple[str, ...]:
    """`equal when rho = 0`, where that is proved."""
    symbols = [symbol for symbol in asked.reference.symbols if symbol not in asked.conditions]
    independent = _without_correlation(symbols)
    if not independent or not _equal_under(asked, asked.reference.entries, {**asked.conditions, **independent}):
        return ()
    return (f"equal when {' and '.join(f'{symbol} = 0' for symbol in independent)}",)


def other_quantities(asked: Asked) -> tuple[Suggestion, ...]:
    """Other quantities of the same model that the formula equals, up to a sign, the one nearest by name first."""
    found = _others(asked)
    return tuple(
        Suggestion(name, f"this is {name}{when}, not {asked.reference.text}", proved=True) for name, when in found
    )


def _others(asked: Asked) -> Iterator[tuple[str, str]]:
    part = asked.reference.part
    if part is None:
        return
    deadline = time.monotonic() + SECONDS
    for quantity in _candidates(part.quantity):
        for shape, places, name in _slices(part, quantity):
            entries = Tensor(shape, tuple(quantity.expression[place] for place in places))
            for signed, prefix in ((entries, ""), (entries.map(lambda entry: -entry), "-")):
                when = _match(asked, signed, quantity.symbols)
                if when is not None:
                    yield prefix + name, when
                    return
        if time.monotonic() > deadline:
            return


def _match(asked: Asked, entries: Tensor[Expr], symbols: Sequence[Variable]) -> str | None:
    """Under which condition the formula equals these entries: "" for none, None when it does not."""
    if _equal_under(asked, entries, asked.conditions, symbols):
        return ""
    independent = _without_correlation(symbols)
    if independent and _equal_under(asked, entries, {**asked.conditions, **independent}, symbols):
        return " when " + " and ".join(f"{symbol} = 0" for symbol in independent)
    return None


def _without_correlation(symbols: Sequence[Variable]) -> dict[Symbol, Expr]:
    return {symbol: sp.Integer(0) for symbol in symbols if symbol.is_correlation}


def _equal_under(
    asked: Asked, entries: Tensor[Expr], conditions: Mapping[Symbol, Expr], more: Sequence[Variable] = ()
) -> bool:
    pairs = [
        (printed.xreplace(conditions), other.xreplace(conditions))
        for printed, other in zip(asked.printed, entries, strict=True)
    ]
    symbols = {symbol.name: symbol for symbol in (*asked.reference.symbols, *more) if symbol not in conditions}
    return all(_alike(a, b, list(symbols.values())) for a, b in pairs) and all(proved_equal(a, b) for a, b in pairs)


def _alike(first: Expr, second: Expr, symbols: Sequence[Variable]) -> bool:
    (point,) = generic_points(symbols, 1)
    values = Comparison(first, second, symbols).at(point)
    return values is not None and values.relative < 1e-40


def _candidates(quantity: Quantity) -> list[Quantity]:
    """Quantities of the same model and rank, the most similar names first; the quantity itself leads."""
    family = [
        other
        for other in catalogue().values()
        if other.module == quantity.module and len(other.shape) == len(quantity.shape)
    ]
    return sorted(family, key=lambda other: -SequenceMatcher(None, other.name, quantity.name).ratio())


def _slices(part: Part, quantity: Quantity) -> Iterator[tuple[Index, list[Index], str]]:
    """The same entries of another quantity; of a single entry, every entry of either."""
    places = list(part.places)
    fits = all(all(i < n for i, n in zip(place, quantity.shape, strict=True)) for place in places)
    if fits and quantity is not part.quantity:
        yield part.shape, places, quantity.name + _brackets(part, quantity)
    if not part.shape and quantity.shape:
        for place in indices(quantity.shape):
            if place != places[0]:
                yield (), [place], f"{quantity.name}[{','.join(map(str, place))}]"


def _brackets(part: Part, quantity: Quantity) -> str:
    """The index as it was given, where it was: entries of a tensor, or all of it."""
    whole = part.shape == part.quantity.shape and list(part.places) == list(indices(quantity.shape))
    if whole:
        return ""
    first, last = part.places.entries[0], part.places.entries[-1]
    return "[" + ",".join(str(i) if i == j else ":" for i, j in zip(first, last, strict=True)) + "]"
