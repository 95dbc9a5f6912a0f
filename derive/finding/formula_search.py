"""Which quantity a formula is: all entries of the catalogue are screened by values, what fits is left to be proved."""

from __future__ import annotations

import math
from bisect import bisect_left
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import islice
from typing import Any

from radartrack.derive.evaluation.tree_values import Program
from radartrack.derive.finding.free_letters import assignments
from radartrack.derive.formula.fold import rebuild
from radartrack.derive.formula.printing import to_text
from radartrack.derive.formula.tree import (
    Array,
    Constant,
    Name,
    Negation,
    Number,
    Product,
    Quotient,
    Sum,
    Tree,
    has_verbs,
    names,
)

SAME = 1e-8  # relative difference at generic points below which formulas are worth a proof
NEAR = 0.4  # and below which they are near: a coefficient of 1/3 for 1/2 is
FEW = 12  # readings of one set of symbols; by more of them, what is near is near by chance
MOST_CANDIDATES = 12
MOST_NEAR = 3

Values = tuple[float, ...]  # at the points
Rows = Mapping[str, Mapping[str, Any]]


@dataclass(frozen=True)
class Candidate:
    """A quantity that a formula may be, and how the formula is read then.

    Attributes:
        quantity: its name, with the entry.
        meaning: in the field's words, with the source.
        formula: in the quantity's own symbols.
        read: letters that stand for other symbols, and for which.
        convention: what is measured otherwise, in words.
        given: the conditions under which it is.
        difference: the largest relative one at the points.
        let: definitions that the formula uses; none where it is found.
    """

    quantity: str
    meaning: str
    formula: str
    read: Mapping[str, str]
    convention: str = ""
    given: Mapping[str, str] = field(default_factory=dict)
    difference: float = 0.0
    let: Mapping[str, str] = field(default_factory=dict)


@dataclass(frozen=True)
class _Item:
    """An entry of a quantity, or all of them: what it is worth, and in which symbols."""

    quantity: str
    meaning: str
    given: Mapping[str, str]
    values: tuple[Values, ...]


@dataclass(frozen=True)
class _Family:
    """Items in the same symbols, by their first value.

    Attributes:
        points: the values of the symbols.
        kinds: of what kind each is.
    """

    points: tuple[Mapping[str, float], ...]
    kinds: Mapping[str, str]
    items: list[tuple[float, int, _Item]] = field(default_factory=list)


@dataclass(frozen=True)
class _Convention:
    """Another way to measure angles: in words, what it is worth, and what stands for it in the formula."""

    words: str
    value: Callable[[float], float]
    written: Callable[[Tree], Tree]


_RIGHT_ANGLE = Quotient(Constant("pi"), Number("2"))
_DEGREES = Quotient(Number("180"), Constant("pi"))
_CONVENTIONS = (
    _Convention("", lambda angle: angle, lambda angle: angle),
    _Convention(
        "counted from the other axis",
        lambda angle: math.pi / 2 - angle,
        lambda angle: Sum((_RIGHT_ANGLE, Negation(angle))),
    ),
    _Convention("in degrees", math.degrees, lambda angle: Product((angle, _DEGREES))),
)


class FormulaSearch:
    """All entries of the catalogue by what they are worth.

    Args:
        rows: the values of each quantity, as `screening_values.row` gives them.
    """

    def __init__(self, rows: Rows) -> None:
        self._families: dict[tuple[int, tuple[int, ...], tuple[tuple[str, tuple[float, ...]], ...]], _Family] = {}
        for name, row in rows.items():
            self._add(name, row)
        for family in self._families.values():
            family.items.sort(key=lambda item: item[:2])

    def candidates(self, tree: Tree) -> list[Candidate]:
        """What a formula is worth the same as, the plainest reading first; each quantity once."""
        found: dict[tuple[str, bool], Candidate] = {}
        for family, reading, convention, values in self._readings(tree):
            for item in _equal(family, values):
                key = item.quantity, bool(item.given)
                if key not in found and len(found) < MOST_CANDIDATES:
                    found[key] = _candidate(tree, item, reading, convention, family, 0.0)
        exact = [one for one in found.values() if not one.given]
        names = {one.quantity for one in exact}
        others = [one for one in found.values() if one.given and one.quantity not in names]
        return sorted([*exact, *others], key=lambda one: (bool(one.convention), bool(one.given), len(one.read)))

    def near(self, tree: Tree) -> list[Candidate]:
        """What a formula is worth nearly the same as, the nearest first."""
        best: dict[str, Candidate] = {}
        for family, reading, convention, values in self._readings(tree, FEW, conventions=1):
            for _, _, item in family.items:
                difference = _difference(values, item.values)
                known = best.get(item.quantity)
                if difference <= NEAR and (known is None or difference < known.difference):
                    best[item.quantity] = _candidate(tree, item, reading, convention, family, difference)
        return sorted(best.values(), key=lambda one: one.difference)[:MOST_NEAR]

    def _add(self, name: str, row: Mapping[str, Any]) -> None:
        meaning = f"{row['meaning']} ({row['source']})"
        shape = tuple(row["shape"])
        zeros = dict.fromkeys(row.get("correlations", ()), "0")
        for values, words, given in (("values", "used", {}), ("uncorrelated", "used_uncorrelated", zeros)):
            if values in row and None not in row[values]:
                used = [_used(row, word) for word in row[words]]
                if shape:
                    whole = [symbol for symbol in row["symbols"] if any(symbol in one for one in used)]
                    self._put(row, whole, shape, _Item(name, meaning, given, tuple(map(tuple, row[values]))))
                for place, (own, worth) in enumerate(zip(used, row[values], strict=True)):
                    item = _Item(f"{name}{_index(place, shape)}", meaning, given, (tuple(worth),))
                    self._put(row, own, (), item)

    def _put(self, row: Mapping[str, Any], symbols: Sequence[str], shape: tuple[int, ...], item: _Item) -> None:
        if not symbols or not any(map(any, item.values)):
            return  # a number is many things
        worth = tuple((symbol, tuple(row["symbols"][symbol])) for symbol in sorted(symbols))
        points = tuple({symbol: row["symbols"][symbol][n] for symbol in symbols} for n in range(len(worth[0][1])))
        kinds = {symbol: row["kinds"][symbol] for symbol in symbols}
        family = self._families.setdefault((len(symbols), shape, worth), _Family(points, kinds))
        family.items.append((_first(item.values), len(family.items), item))

    def _readings(
        self, tree: Tree, most: int | None = None, conventions: int = len(_CONVENTIONS)
    ) -> Iterator[tuple[_Family, dict[str, str], _Convention, tuple[Values, ...]]]:
        """The values of a formula in every way in which its letters are the symbols of a family."""
        if has_verbs(tree):
            return  # what has to be worked out first has no value here
        letters = sorted(names(tree))
        shape, entries = _entries(tree)
        programs = [Program(entry) for entry in entries]
        for (size, of_shape, _), family in self._families.items():
            if size != len(letters) or of_shape != shape:
                continue
            readings = list(islice(assignments(letters, family.kinds), most and most + 1))
            for reading in readings if most is None or len(readings) <= most else ():
                angles = [letter for letter in letters if family.kinds[reading[letter]] == "angle"]
                for convention in _CONVENTIONS[: conventions if angles else 1]:
                    values = _values(programs, reading, angles, convention, family)
                    if values is not None:
                        yield family, reading, convention, values


def _entries(tree: Tree) -> tuple[tuple[int, ...], list[Tree]]:
    """The shape of a formula and its entries; one that is no list of lists is one entry."""
    if not isinstance(tree, Array):
        return (), [tree]
    below = [_entries(entry) for entry in tree.entries]
    return (len(below), *below[0][0]), [entry for _, entries in below for entry in entries]


def _values(
    programs: Sequence[Program],
    reading: Mapping[str, str],
    angles: Sequence[str],
    convention: _Convention,
    family: _Family,
) -> tuple[Values, ...] | None:
    """What the entries are worth at the points; None where one is no number."""
    points = []
    for point in family.points:
        known = {letter: point[symbol] for letter, symbol in reading.items()}
        points.append(known | {letter: convention.value(known[letter]) for letter in angles})
    found = []
    for program in programs:
        worth = [program(point) for point in points]
        if any(value is None or not math.isfinite(value[0]) for value in worth):
            return None
        found.append(tuple(value[0] for value in worth if value is not None))
    return tuple(found)


def _equal(family: _Family, values: tuple[Values, ...]) -> Iterator[_Item]:
    """The items that are worth the same at the generic points."""
    first = _first(values)
    low, high = sorted((first * (1 - SAME), first * (1 + SAME)))
    start = bisect_left(family.items, (low, -1), key=lambda item: item[:2])
    for worth, _, item in islice(family.items, start, None):
        if worth > high:
            return
        pairs = zip(values, item.values, strict=True)
        if all(_apart(a, b) <= SAME for own, other in pairs for a, b in zip(own[:-1], other[:-1], strict=True)):
            yield item


def _first(values: tuple[Values, ...]) -> float:
    """The first value that is not zero, which items are sorted by."""
    return next((entry[0] for entry in values if abs(entry[0]) > SAME), 0.0)


def _difference(values: tuple[Values, ...], others: tuple[Values, ...]) -> float:
    """The largest relative difference of entries at all points."""
    pairs = zip(values, others, strict=True)
    return max(_apart(a, b) for own, other in pairs for a, b in zip(own, other, strict=True))


def _apart(first: float, second: float) -> float:
    scale = max(abs(first), abs(second))
    return abs(first - second) / scale if scale > SAME**2 else 0.0


def _candidate(
    tree: Tree, item: _Item, reading: Mapping[str, str], convention: _Convention, family: _Family, difference: float
) -> Candidate:
    def symbol(node: Tree) -> Tree:
        if not isinstance(node, Name):
            return node
        known = Name(reading[node.name])
        return convention.written(known) if family.kinds[known.name] == "angle" else known

    angles = [name for name in reading.values() if family.kinds[name] == "angle"]
    words = f"with {' and '.join(angles)} {convention.words}" if convention.words else ""
    renamed = {letter: name for letter, name in reading.items() if letter != name}
    formula = to_text(rebuild(tree, symbol))
    return Candidate(item.quantity, item.meaning, formula, renamed, words, item.given, difference)


def _used(row: Mapping[str, Any], word: str) -> list[str]:
    """The symbols that a word of 0 and 1 says."""
    return [symbol for symbol, sign in zip(row["symbols"], word, strict=True) if sign == "1"]


def _index(place: int, shape: Sequence[int]) -> str:
    """`[0,1]` for a place among the entries in the order of rows."""
    index: list[str] = []
    for size in reversed(shape):
        place, last = divmod(place, size)
        index.insert(0, str(last))
    return f"[{','.join(index)}]" if shape else ""
