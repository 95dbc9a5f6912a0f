"""Which quantity a formula is: all entries of the catalogue are screened by values, what fits is left to be proved."""

from __future__ import annotations

import math
from bisect import bisect_left
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from fractions import Fraction
from itertools import chain, combinations, islice
from typing import Any, TypeAlias

from radartrack.derive.checking.question.letters.assignments import (
    ANY,
    HALF,
    Choice,
    assignments,
    choices,
    farther_choices,
)
from radartrack.derive.checking.question.letters.axis_letters import one_axis
from radartrack.derive.checking.question.letters.letter_meanings import (
    is_angle_word,
    is_known_word,
    is_word,
    meanings,
    means,
)
from radartrack.derive.checking.question.padding import still_states
from radartrack.derive.checking.repairing.print_slips import (
    Alternative,
    plain_words,
    slips,
)
from radartrack.derive.evaluation.tree_values import Program
from radartrack.derive.formula.error import FormulaError
from radartrack.derive.formula.fold import rebuild
from radartrack.derive.formula.printing import to_text
from radartrack.derive.formula.tree import (
    Call,
    Constant,
    Name,
    Negation,
    Number,
    Power,
    Product,
    Quotient,
    Sum,
    Tree,
    names,
    parts,
    replace_at,
    walk,
)
from radartrack.derive.formula.written_out import array_of, written_out
from radartrack.derive.language.tensor import Index, Tensor

SAME = 1e-8  # relative difference at generic points below which formulas are worth a proof
NEAR = 0.4  # and below which they are near: a coefficient of 1/3 for 1/2 is
NEAR_ANY = 0.02  # where letters that mean nothing are read as what fits best
FEW = 12  # readings of one set of symbols; by more of them, what is near is near by chance
MOST_CANDIDATES = 12
MOST_KEPT = 200  # before the plainest of them are chosen
AXES = (2, 3)  # of the plane and of space
MOST_NEAR = 3
MOST_READINGS = 5000  # of one set of symbols
MOST_REARRANGED = 4  # each is explained, which takes a good part of a second
LIKELY = 1.4  # the cost of the least likely slip that is undone
SHARE = 0.5  # of the entries that are another quantity's, from which it may be that one in another order or convention

Values = tuple[float, ...]  # at the points
Rows = Mapping[str, Mapping[str, Any]]
Reading: TypeAlias = "Mapping[str, Choice[Screened]]"


@dataclass(frozen=True)
class Candidate:
    """A quantity that a formula may be, and how the formula is read then.

    Attributes:
        quantity: its name, with the entry; with a sign before it for its negative.
        meaning: in the field's words, with the source.
        formula: in the quantity's own symbols.
        read: letters that stand for other symbols, and for which.
        convention: what is measured otherwise, in words.
        given: the conditions under which it is.
        difference: the largest relative one at the points.
        let: definitions that the formula uses; none where it is found.
        rank: how far-fetched the meanings of the letters are together.
        slip: what was undone in the formula, where it is the quantity only then.
        symbols: how many the quantity has, without correlations.
    """

    quantity: str
    meaning: str
    formula: str
    read: Mapping[str, str]
    convention: str = ""
    given: Mapping[str, str] = field(default_factory=dict)
    difference: float = 0.0
    let: Mapping[str, str] = field(default_factory=dict)
    rank: int = 0
    slip: str = ""
    symbols: int = 0

    @property
    def effort(self) -> tuple[bool, bool, int, int, bool, int]:
        """What has to be said of it: the less, the likelier; of the plainest quantity first."""
        is_negative = self.quantity.startswith("-")
        return bool(self.convention), is_negative, self.rank, self.symbols, bool(self.given), len(self.read)


@dataclass(frozen=True)
class Screened:
    """A symbol of a row of values: its name, its kind, and whether it is a correlation."""

    name: str
    unit: str
    is_correlation: bool = False
    meaning: str = ""


@dataclass(frozen=True)
class _Item:
    """An entry of a quantity, or all of them: what it is worth, and how many symbols the quantity has in all."""

    quantity: str
    meaning: str
    given: Mapping[str, str]
    values: tuple[Values, ...]
    symbols: int


@dataclass(frozen=True)
class _Family:
    """Items in the same symbols, by their first value.

    Attributes:
        points: the values of the symbols.
        symbols: their names and kinds.
    """

    points: tuple[Mapping[str, float], ...]
    symbols: tuple[Screened, ...]
    items: list[tuple[float, int, _Item]] = field(default_factory=list)


@dataclass(frozen=True)
class _Convention:
    """Another way to measure angles: in words, what it is worth, and what stands for it in the formula."""

    words: str
    value: Callable[[float], float]
    written: Callable[[Tree], Tree]


@dataclass(frozen=True)
class _Read:
    """A formula in one reading of its letters: the family, the angles that are measured otherwise, the values."""

    family: _Family
    letters: Reading
    convention: _Convention
    angles: tuple[str, ...]
    values: tuple[Values, ...]


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


@dataclass(frozen=True)
class _Rearranged:
    """A candidate that holds so many of the printed entries, in any order; perhaps these and no others."""

    common: int
    candidate: Candidate
    is_whole: bool


class FormulaSearch:
    """All entries of the catalogue by what they are worth.

    Args:
        rows: the values of each quantity, as `screening_values.row` gives them.
    """

    def __init__(self, rows: Rows) -> None:
        self._families: dict[tuple[int, tuple[int, ...], tuple[tuple[str, tuple[float, ...]], ...]], _Family] = {}
        self._rows = rows
        for name, row in rows.items():
            self._add(name, row)
        for family in self._families.values():
            family.items.sort(key=lambda item: item[:2])

    def among(self, prefix: str) -> FormulaSearch:
        """The search over the quantities whose names begin so."""
        return FormulaSearch({name: row for name, row in self._rows.items() if name.startswith(prefix)})

    def candidates(self, tree: Tree) -> list[Candidate]:
        """What a formula is worth the same as, the plainest reading first; each quantity once.

        Where it is none, what holds its entries in another order, or half of them: a convention may explain the rest.
        """
        printed = _entries(tree)
        if printed is None:
            return []
        found, whole, rearranged = self._worth_the_same(printed, tree)
        return found or whole or self._of_one_axis(printed, tree) or self._of_moving(printed, tree) or rearranged

    def _of_moving(self, printed: Tensor[Tree], tree: Tree) -> list[Candidate]:
        """What a transition is without states that stay as they are."""
        if len(printed.shape) != 2 or printed.shape[0] != printed.shape[1]:
            return []
        rows = [list(row.entries) for row in printed.parts()]
        still = still_states(rows)
        kept = [place for place in range(len(rows)) if place not in still]
        if not still or len(kept) < 2:
            return []
        moving = Tensor((len(kept), len(kept)), tuple(rows[row][column] for row in kept for column in kept))
        found, whole, _ = self._worth_the_same(moving, tree)
        words = f"without what never changes, {', '.join(map(str, still))}"
        return [replace(one, convention=f"{one.convention} {words}".strip()) for one in found or whole]

    def _of_one_axis(self, printed: Tensor[Tree], tree: Tree) -> list[Candidate]:
        """What the block is of a matrix that has the same one for each axis."""
        for axes in AXES:
            block = one_axis(printed, axes)
            found = self._worth_the_same(block[0], tree)[0] if block is not None else []
            if block and found:
                words = f"for each of {axes} axes{block[1]}"
                return [replace(one, convention=f"{one.convention} {words}".strip()) for one in found]
        return []

    def _worth_the_same(self, printed: Tensor[Tree], tree: Tree) -> tuple[list[Candidate], ...]:
        """What a formula is worth the same as, what holds its entries in another order, and what holds half of them."""
        found: dict[tuple[str, bool], Candidate] = {}
        rearranged: dict[str, _Rearranged] = {}
        for farther in (False, True):
            for read in self._readings(printed, farther=farther):
                for item, sign in _equal(read.family, read.values):
                    key = item.quantity, bool(item.given)
                    one = _candidate(printed, item, read, 0.0, sign)
                    if len(found) < MOST_KEPT and (key not in found or one.effort < found[key].effort):
                        found[key] = one
                if not found and not read.convention.words and printed.shape:
                    _keep_rearranged(rearranged, printed, read)
            if found or rearranged:
                break
        likely = [one for one in found.values() if one.rank < ANY or not is_of_letters_alone(tree)]
        whole = [one for one in rearranged.values() if one.is_whole]
        return _plainest(likely), _first_of(whole), _first_of(rearranged.values())

    def near(self, tree: Tree) -> list[Candidate]:
        """What a formula is worth nearly the same as, the nearest first."""
        printed = _entries(tree)
        if printed is None:
            return []
        best: dict[str, Candidate] = {}
        alone = is_of_letters_alone(tree)
        kinds = {name: kind for row in self._rows.values() for name, kind in row["kinds"].items() if len(name) > 1}
        for read in self._readings(printed, FEW, plain=True):
            if any(
                kinds.get(letter, one.symbol.unit) != one.symbol.unit and not meanings(letter).strong
                for letter, one in read.letters.items()
            ):
                continue  # S_xx is no deviation
            if alone and _rank(read.letters):
                continue
            most = NEAR if _rank(read.letters) < ANY else NEAR_ANY
            for _, _, item in read.family.items:
                if len(item.values) != len(read.values):
                    continue
                difference = _difference(read.values, item.values)
                known = best.get(item.quantity)
                if difference <= most and (known is None or difference < known.difference):
                    best[item.quantity] = _candidate(printed, item, read, difference)
        return sorted(best.values(), key=lambda one: one.difference)[:MOST_NEAR]

    def slipped(self, tree: Tree) -> list[Candidate]:
        """What a formula of a number is with one slip undone, each quantity with the likeliest of its slips.

        A few slips, each with a few quantities: those that have a likely one must not hide the others.
        """
        printed = _entries(tree)
        if printed is None or printed.shape:
            return []
        found: dict[str, tuple[float, Candidate]] = {}
        kinds = dict.fromkeys(names(tree), "")
        edits = [(edit, Tensor((), (edit.tree,)), [Program(edit.tree)]) for edit in _slips(tree, kinds)]
        for family, letters in self._likeliest(printed):
            for edit, edited, programs in edits:
                values = _values(programs, letters, (), _CONVENTIONS[0], family)
                for item, sign in _equal(family, values) if values is not None else ():
                    if sign > 0 and edit.cost < found.get(item.quantity, (math.inf, None))[0]:
                        read = _Read(family, letters, _CONVENTIONS[0], (), values or ())
                        one = replace(_candidate(edited, item, read, 0.0), slip=edit.words)
                        found[item.quantity] = edit.cost, one
        ordered = [one for _, one in sorted(found.values(), key=lambda pair: (pair[0], pair[1].effort))]
        by_slip: dict[str, list[Candidate]] = {}
        for one in ordered:
            by_slip.setdefault(one.slip, []).append(one)
        return [one for alike in islice(by_slip.values(), MOST_NEAR) for one in alike[:MOST_NEAR]]

    def _likeliest(self, printed: Tensor[Tree]) -> Iterator[tuple[_Family, Reading]]:
        """Each family with the likeliest reading of the letters as its symbols; none of letters that mean nothing."""
        letters = sorted(frozenset[str]().union(*map(names, printed)))
        alone = all(map(is_of_letters_alone, printed))
        for (size, of_shape, _), family in self._families.items():
            if size == len(letters) and of_shape == printed.shape:
                reading = next(_assigned(letters, family, farther=False, strict=True), None)
                if reading is not None and not (alone and _rank(reading)):
                    yield family, reading

    def _add(self, name: str, row: Mapping[str, Any]) -> None:
        meaning = f"{row['meaning']} ({row['source']})"
        shape = tuple(row["shape"])
        zeros = dict.fromkeys(row.get("correlations", ()), "0")
        size = len(row["symbols"]) - len(zeros)
        for values, words, given in (("values", "used", {}), ("uncorrelated", "used_uncorrelated", zeros)):
            if values not in row:
                continue
            used = [_used(row, word) for word in row[words]]
            if shape and None not in row[values]:
                whole = [symbol for symbol in row["symbols"] if any(symbol in one for one in used)]
                self._put(row, whole, shape, _Item(name, meaning, given, tuple(map(tuple, row[values])), size))
            for place, (own, worth) in enumerate(zip(used, row[values], strict=True)):
                if worth is not None:
                    item = _Item(f"{name}{_index(place, shape)}", meaning, given, (tuple(worth),), size)
                    self._put(row, own, (), item)

    def _put(self, row: Mapping[str, Any], symbols: Sequence[str], shape: tuple[int, ...], item: _Item) -> None:
        if not symbols or not any(map(any, item.values)):
            return  # a number is many things
        worth = tuple((symbol, tuple(row["symbols"][symbol])) for symbol in sorted(symbols))
        points = tuple({symbol: row["symbols"][symbol][n] for symbol in symbols} for n in range(len(worth[0][1])))
        zero = row.get("correlations", ())
        screened = tuple(Screened(symbol, row["kinds"][symbol], symbol in zero) for symbol in symbols)
        family = self._families.setdefault((len(symbols), shape, worth), _Family(points, screened))
        family.items.append((_first(item.values), len(family.items), item))

    def _readings(
        self, printed: Tensor[Tree], most: int | None = None, *, plain: bool = False, farther: bool = False
    ) -> Iterator[_Read]:
        """The values of a formula in every way in which its letters are the symbols of a family."""
        letters = sorted(frozenset[str]().union(*map(names, printed)))
        shapes = {printed.shape, printed.shape[::-1], _without_zeros(printed)}
        programs = [Program(entry) for entry in printed]
        for (size, of_shape, _), family in self._families.items():
            if size != len(letters) or of_shape not in shapes:
                continue
            assigned = _assigned(letters, family, farther=farther, strict=most is not None)
            readings = list(islice(assigned, most and most + 1))
            for reading in readings if most is None or len(readings) <= most else ():
                angles = [letter for letter in letters if reading[letter].symbol.unit == "angle"]
                for convention, turned in _in_conventions(angles, plain=plain):
                    values = _values(programs, reading, turned, convention, family)
                    if values is not None:
                        yield _Read(family, reading, convention, turned, values)


def _slips(tree: Tree, kinds: Mapping[str, object]) -> Iterator[Alternative]:
    """The formula after each slip that keeps its letters."""
    letters = names(tree)
    for path, node in walk(tree):
        for edit in slips(node, kinds):
            changed = replace_at(tree, path, edit.tree)
            if edit.cost <= LIKELY and edit.tree != node and names(changed) == letters:
                yield replace(edit, tree=changed, kind=plain_words(edit.words), about=())


def is_of_letters_alone(tree: Tree) -> bool:
    """Whether a formula is made of letters alone, which is many things if they mean nothing: F*x + w, r^2*s^2.

    Not P*Q/(P + Q): what divides by letters that it has above too is hardly the same as another by chance.
    """
    there = [*parts(tree)]
    if any(isinstance(node, Quotient) and names(node.numerator) & names(node.denominator) for node in there):
        return False
    bare = rebuild(tree, _bare)
    return all(isinstance(node, Name | Sum | Product | Quotient | Negation) for node in parts(bare))


def _bare(node: Tree) -> Tree:
    """A letter without its power and its bars."""
    match node:
        case Power(Name() as letter, _) | Call("abs", (Name() as letter,)):
            return letter
    return node


def letters_of(tree: Tree) -> int | None:
    """How many letters a formula has that is a number; None of an array."""
    entries = _entries(tree)
    return len(names(tree)) if entries is not None and not entries.shape else None


def _plainest(found: Sequence[Candidate]) -> list[Candidate]:
    """Those that need the least to be said: no convention and no sign where there are such, no needless condition."""
    exact = {one.quantity for one in found if not one.given}
    kept = [one for one in found if not one.given or one.quantity not in exact]
    for is_far in (lambda one: bool(one.convention), lambda one: one.quantity.startswith("-")):
        near = [one for one in kept if not is_far(one)]
        kept = near or kept
    return sorted(kept, key=lambda one: one.effort)[:MOST_CANDIDATES]


def _first_of(rearranged: Iterable[_Rearranged]) -> list[Candidate]:
    """Those with the most entries in common."""
    return [one.candidate for one in sorted(rearranged, key=lambda one: -one.common)][:MOST_REARRANGED]


def _assigned(letters: Sequence[str], family: _Family, *, farther: bool, strict: bool) -> Iterator[Reading]:
    """Ways to read letters as symbols, one to one, the likeliest first."""
    known = {}
    for letter in letters:
        free = [symbol for symbol in family.symbols if symbol.name == letter or symbol.name not in letters]
        known[letter] = [] if strict and _means_another(letter, free) else _choices(letter, free)
    if farther:
        known = {letter: farther_choices(letter, known, family.symbols) for letter in letters}
    yield from islice(assignments(known), MOST_READINGS)


def _means_another(letter: str, symbols: Sequence[Screened]) -> bool:
    """Whether a name means something, but none of these symbols: T is no ratio, and a latitude no azimuth."""
    if any(symbol.name == letter for symbol in symbols) or means(letter, symbols) or means(letter, symbols, weak=True):
        return False
    return is_word(letter) or bool(meanings(letter).strong)


def _choices(letter: str, symbols: Sequence[Screened]) -> list[Choice[Screened]]:
    """What a letter may stand for; a symbol of its name first, and else what it means."""
    own = [Choice(one) for one in symbols if one.name == letter]
    if own:
        return list(dict.fromkeys([*own, *(Choice(one, power, 1) for one, power in means(letter, symbols))]))
    if is_known_word(letter) and not means(letter, symbols):
        symbols = [one for one in symbols if (one.unit == "angle") == is_angle_word(letter)]
    return choices(letter, symbols)


def _in_conventions(angles: Sequence[str], *, plain: bool) -> Iterator[tuple[_Convention, tuple[str, ...]]]:
    """Ours, and each other one for each set of angles."""
    yield _CONVENTIONS[0], ()
    if plain:
        return
    for convention in _CONVENTIONS[1:]:
        for turned in chain.from_iterable(combinations(angles, count) for count in range(len(angles), 0, -1)):
            yield convention, turned


def _keep_rearranged(found: dict[str, _Rearranged], printed: Tensor[Tree], read: _Read) -> None:
    """Keep the items that hold at least half of what is printed, in any order and of any sign."""
    own = _unordered(read.values)
    for _, _, item in read.family.items:
        other = _unordered(item.values)
        common = (own & other).total()
        best = found.get(item.quantity)
        if common >= SHARE * max(own.total(), other.total(), 2) and (best is None or common > best.common):
            found[item.quantity] = _Rearranged(common, _candidate(printed, item, read, 0.0), is_whole=own == other)


def _unordered(values: tuple[Values, ...]) -> Counter[tuple[str, ...]]:
    """The entries that are not zero, whatever their order and sign."""
    return Counter(tuple(f"{abs(value):.7e}" for value in entry[:-1]) for entry in values if any(entry))


def _without_zeros(printed: Tensor[Tree]) -> Index:
    """The shape of a matrix without rows and columns of zeros."""
    if len(printed.shape) != 2:
        return printed.shape
    places = [index for index, entry in printed.items() if entry != Number("0")]
    return len({row for row, _ in places}), len({column for _, column in places})


def _entries(tree: Tree) -> Tensor[Tree] | None:
    """The entries of a formula, its arrays written out; None where something in it has to be worked out first."""
    try:
        found = written_out(tree)
    except FormulaError:
        return None
    if found is not None and len(found.shape) == 2 and 1 in found.shape:
        return Tensor((len(found.entries),), found.entries)  # a row or a column is a vector
    return found


def _values(
    programs: Sequence[Program],
    reading: Reading,
    angles: Sequence[str],
    convention: _Convention,
    family: _Family,
) -> tuple[Values, ...] | None:
    """What the entries are worth at the points; None where one is no number."""
    points = []
    for point in family.points:
        known = {letter: point[one.symbol.name] ** one.power for letter, one in reading.items()}
        points.append(known | {letter: convention.value(known[letter]) for letter in angles})
    found = []
    for program in programs:
        worth = [program(point) for point in points]
        if any(value is None or not math.isfinite(value[0]) for value in worth):
            return None
        found.append(tuple(value[0] for value in worth if value is not None))
    return tuple(found)


def _equal(family: _Family, values: tuple[Values, ...]) -> Iterator[tuple[_Item, int]]:
    """The items that are worth the same at the generic points, or the negative of it, and the sign."""
    for sign in (1, -1):
        first = sign * _first(values)
        low, high = sorted((first * (1 - SAME), first * (1 + SAME)))
        start = bisect_left(family.items, (low, -1), key=lambda item: item[:2])
        for worth, _, item in islice(family.items, start, None):
            if worth > high:
                break
            pairs = zip(values, item.values, strict=False)
            if len(values) == len(item.values) and all(
                _apart(sign * a, b) <= SAME for own, other in pairs for a, b in zip(own[:-1], other[:-1], strict=True)
            ):
                yield item, sign


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


def _candidate(printed: Tensor[Tree], item: _Item, read: _Read, difference: float, sign: int = 1) -> Candidate:
    def symbol(node: Tree) -> Tree:
        if not isinstance(node, Name):
            return node
        choice = read.letters[node.name]
        known = _raised(Name(choice.symbol.name), choice.power)
        return read.convention.written(known) if node.name in read.angles else known

    turned = [read.letters[letter].symbol.name for letter in read.angles]
    words = f"with {' and '.join(turned)} {read.convention.words}" if turned else ""
    renamed = {letter: str(choice) for letter, choice in read.letters.items() if letter != str(choice)}
    formula = to_text(array_of(printed.map(lambda entry: rebuild(entry, symbol))))
    name = item.quantity if sign > 0 else f"-{item.quantity}"
    return Candidate(
        name,
        item.meaning,
        formula,
        renamed,
        words,
        item.given,
        difference,
        rank=_rank(read.letters),
        symbols=item.symbols,
    )


def _rank(reading: Reading) -> int:
    """How far-fetched the meanings of the letters are together."""
    return sum(choice.rank for choice in reading.values())


def _raised(name: Name, power: Fraction | int) -> Tree:
    if power == 1:
        return name
    if power == HALF:
        return Call("sqrt", (name,))
    return Power(name, Number(str(power))) if power > 0 else Quotient(Number("1"), name)


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
