"""What a function is compared with: a quantity of the catalogue or an entry of it, its exact values, and where."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property, lru_cache
from typing import Any

import numpy as np
import numpy.typing as npt

from radartrack.derive.checking.comparing.order_of_difference import is_deviation
from radartrack.derive.checking.question.world import CATALOGUE
from radartrack.derive.evaluation.balls import exact_arithmetic
from radartrack.derive.evaluation.points import ordinary_points, round_points
from radartrack.derive.language.quantity import Quantity
from radartrack.derive.language.tensor import Index, Tensor, indices
from radartrack.derive.language.variable import Variable
from radartrack.derive.symbolic import Expr, Symbol
from radartrack.derive.units import ONE
from radartrack.verification.domain_points import Points, coarse, sample
from radartrack.verification.error_in_ulp import Yardstick

Array = npt.NDArray[np.float64]

NAME = re.compile(r"(?P<name>[\w.]+)(?:\[(?P<index>\s*\d+\s*(?:,\s*\d+\s*)*)\])?")
WIDE = 1.1  # twice an ordinary deviation without a unit
WHOLE = 11  # how far whole numbers are spread at ordinary points; high powers of larger ones drown other terms
BESIDE = 10.0  # times which a value may be larger than others of its unit at ordinary points: it drowns them beyond
TINY = 1e-3  # of an ordinary value, at which a small constant stands out
NEARLY_ZERO = (1e-3, -1e-6, 1e-9)  # of the upper end: where a formula divides by what may be zero it loses digits
INSIDE = 0.6  # of the upper end of a domain, up to which values are raised beside larger ones


@dataclass(frozen=True, eq=False)
class Wanted:
    """A quantity, or one entry of it, with some of its symbols fixed.

    Attributes:
        quantity: of the catalogue, or of a model of one's own.
        places: the entries that are wanted, in row-major order.
        shape: of what the function is to return.
        given: values of the symbols that are fixed.
    """

    quantity: Quantity
    places: tuple[Index, ...]
    shape: Index
    given: Mapping[str, float]

    @property
    def name(self) -> str:
        """As it was asked for."""
        whole = self.shape == self.quantity.shape or len(self.places) > 1
        return self.quantity.name if whole else f"{self.quantity.name}[{', '.join(map(str, self.places[0]))}]"

    @cached_property
    def symbols(self) -> tuple[Variable, ...]:
        """Those that are free."""
        return tuple(symbol for symbol in self.quantity.symbols if symbol.name not in self.given)

    @cached_property
    def entries(self) -> list[Expr]:
        """The formulas that are wanted, in row-major order."""
        table = dict(self.quantity.expression.items())
        return [table[place] for place in self.places]

    @cached_property
    def needed(self) -> set[str]:
        """The symbols on which the entries depend where all correlations are zero."""
        zero = {symbol: symbol * 0 for symbol in self.quantity.symbols if symbol.is_correlation}
        zero |= {symbol: symbol * 0 for symbol in self.quantity.symbols if self.given.get(symbol.name) == 0}
        used = set[Symbol]().union(*(entry.xreplace(zero).free_symbols for entry in self.entries))
        return {symbol.name for symbol in used}

    @property
    def columns(self) -> list[int]:
        """Where the entries stand among all of the quantity."""
        every = list(indices(self.quantity.shape))
        return [every.index(place) for place in self.places]

    def having(self, values: Mapping[str, float]) -> Wanted:
        """The same with more of its symbols fixed."""
        return Wanted(self.quantity, self.places, self.shape, {**self.given, **values})

    def at(self, points: Points) -> Expected:
        """The exact values at some points, without those at which there are none."""
        count = len(next(iter(points.values()))) if points else 1
        points = dict(points)
        full = points | {name: np.full(count, value) for name, value in self.given.items()}
        full = {symbol.name: full[symbol.name] for symbol in self.quantity.symbols}
        rows = [tuple(float(values[n]) for values in full.values()) for n in range(count)]
        kept = [n for n, row in enumerate(rows) if self._is_defined(row)]
        return Expected(self, {name: values[kept] for name, values in full.items()}, len(kept))

    def _is_defined(self, row: tuple[float, ...]) -> bool:
        try:
            return all(np.isfinite(float(value)) for value in self.evaluate(row))
        except (ArithmeticError, TypeError, ValueError):
            return False

    @cached_property
    def evaluate(self) -> Callable[[Sequence[float]], Tensor[Any]]:
        """The exact entries of the whole quantity at a point; they are kept."""
        return lru_cache(maxsize=4096)(exact_arithmetic()[1](self.quantity.expression, self.quantity.symbols))

    def exactly(self, entries: Tensor[Expr], symbols: Sequence[Symbol]) -> Callable[[Sequence[float]], Tensor[Any]]:
        """Exact arithmetic, which for the quantity itself keeps what is known."""
        return self.evaluate if entries is self.quantity.expression else exact_arithmetic()[1](entries, symbols)

    def ordinary(self, count: int) -> Expected:
        """At points of ordinary size inside the domain, where floating point loses nothing."""
        found = ordinary_points(self.quantity.symbols, count)
        points = {s.name: np.array([point[s.name] for point in found]) for s in self.quantity.symbols}
        for place, symbol in enumerate(self.quantity.symbols):
            if symbol.whole:
                highest = points[symbol.at_most.name] if symbol.at_most else np.full(count, symbol.high)
                least = min(symbol.low + 2 * (symbol.at_most is None), symbol.high)
                room = np.minimum(highest - least, WHOLE) + 1
                points[symbol.name] = least + (np.arange(count) * (5 + 2 * place)) % room
        return self.at(self._side_by_side(points))

    def _side_by_side(self, points: Points) -> Points:
        """The points with values of one unit of one size, as far as their domains allow.

        A path of 30 km, which is the shortest, drowns a baseline of 2 m.
        """
        raised = dict(points)
        for symbol in self.quantity.symbols:
            alike = [points[other.name].min() for other in self.quantity.symbols if other.unit == symbol.unit]
            values, largest = points[symbol.name], max(alike)
            if symbol.unit != ONE and symbol.low > 0 and values.max() * BESIDE < largest:
                raised[symbol.name] = values * max(min(INSIDE * symbol.high, largest) / values.max(), 1.0)
        return raised

    def wide(self, count: int) -> Expected:
        """As `ordinary`, with deviations of ordinary size also where the domain ends before: no term is tiny then."""
        found = self.ordinary(count).points
        for symbol in self.quantity.symbols:
            if is_deviation(symbol) and symbol.high < WIDE:
                found[symbol.name] = found[symbol.name] * (WIDE / symbol.high)
        return self.at({name: values for name, values in found.items() if name not in self.given})

    def small(self, count: int) -> Expected:
        """As `ordinary`, with whatever has a unit as small as its domain allows, beside which no constant is small."""
        found = self.ordinary(count).points
        for symbol in self.quantity.symbols:
            if symbol.unit != ONE and not symbol.is_angle and not symbol.whole:
                values = found[symbol.name]
                found[symbol.name] = values * max(TINY, symbol.low / np.abs(values).min())
        return self.at({name: values for name, values in found.items() if name not in self.given})

    def coarse(self, count: int) -> Expected:
        """At points with large errors in all directions, where every effect stands out."""
        return self.at(coarse(self.quantity, count, seed=5))

    def domain(self, count: int) -> Expected:
        """All over the domain, on all scales, with independent errors, and at its edges."""
        spread, edges = sample(self.quantity, count, seed=23), edge_points(self.quantity.symbols)
        return self.at({name: np.concatenate([edges[name], values]) for name, values in spread.items()})


class Expected:
    """Exact values at some points.

    Attributes:
        wanted: what they are values of.
        points: symbol name → array of shape (count,), fixed symbols too.
        count: of points.
    """

    def __init__(self, wanted: Wanted, points: Points, count: int) -> None:
        self.wanted, self.points, self.count = wanted, points, count

    @cached_property
    def yardstick(self) -> Yardstick:
        """The exact values and scales of all entries of the quantity."""
        return Yardstick(self.wanted.quantity, self.points, self.wanted.exactly)

    @cached_property
    def values(self) -> Array:
        """The entries that are wanted, rounded; shape (points, entries)."""
        rows = [[float(row[n]) for n in self.wanted.columns] for row in self.yardstick.exact[: self.count]]
        return np.array(rows, dtype=np.float64).reshape(self.count, len(self.wanted.columns))

    @cached_property
    def scales(self) -> Array:
        """What errors of the entries are measured against."""
        rows = [[row[n] for n in self.wanted.columns] for row in self.yardstick.scales[: self.count]]
        return np.array(rows, dtype=np.float64).reshape(self.count, len(self.wanted.columns))

    def errors(self, found: Array) -> Array:
        """Errors in ulp; shape (points, entries)."""
        every = np.zeros((self.count, len(self.yardstick.exact[0]) if self.yardstick.exact else 0))
        every[:, self.wanted.columns] = found
        return self.yardstick.errors(every)[:, self.wanted.columns]

    def point(self, place: int) -> dict[str, float]:
        """One of the points."""
        return {name: float(values[place]) for name, values in self.points.items()}


def wanted_by(name: str, given: Mapping[str, float], own: Iterable[Quantity] = ()) -> Wanted:
    """What a name asks for: `polar.map`, or one entry, `polar.map[0]`.

    Args:
        name: of a quantity of the catalogue, or of those of one's own.
        given: values of the symbols that are fixed.
        own: quantities beside the catalogue's.

    Raises:
        UnknownQuantity: there is no quantity of that name.
        ValueError: there is no such entry, or no symbol of a name that is given.
    """
    match = NAME.fullmatch(name.strip())
    if match is None:
        raise ValueError(f"name must be that of a quantity, polar.map, or of an entry, polar.map[0]; given {name!r}")
    quantity = CATALOGUE.having(own).find(match["name"])
    unknown = sorted(set(given) - {symbol.name for symbol in quantity.symbols})
    if unknown:
        allowed = ", ".join(symbol.name for symbol in quantity.symbols)
        raise ValueError(f"given may fix {allowed} of {quantity.name}; given also {', '.join(unknown)}")
    every = tuple(indices(quantity.shape))
    if match["index"] is None:
        return Wanted(quantity, every, quantity.shape, given)
    index = tuple(int(number) for number in match["index"].split(","))
    if index not in every:
        raise ValueError(f"name: {quantity.name} has shape {list(quantity.shape)}, indices count from 0; given {name}")
    return Wanted(quantity, (index,), (), given)


def edge_points(symbols: Sequence[Variable]) -> Points:
    """Round points, then ends of the domain and zero, one symbol at a time, then all deviations small, or large."""
    rows = list(round_points(symbols))
    (middle,) = ordinary_points(symbols, 1)
    for symbol in symbols:
        is_both = symbol.low < 0 < symbol.high and not symbol.is_correlation
        ends = [symbol.low, symbol.high, *([0.0, *(symbol.high * share for share in NEARLY_ZERO)] if is_both else [])]
        rows += [middle | {symbol.name: float(end)} for end in ends]
    deviations = [symbol for symbol in symbols if is_deviation(symbol)]
    for end in ("low", "high") if deviations else ():
        rows.append(middle | {symbol.name: float(getattr(symbol, end)) for symbol in deviations})
    kept = [row for row in rows if all(s.at_most is None or row[s.name] <= row[s.at_most.name] for s in symbols)]
    points = {symbol.name: np.array([row[symbol.name] for row in kept]) for symbol in symbols}
    return {s.name: np.zeros(len(kept)) if s.is_correlation else points[s.name] for s in symbols}
