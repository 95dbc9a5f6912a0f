"""A formula in letters of its own, matched to the symbols of a quantity: by meaning, by units, by trial.

A name that carries a meaning binds, however well an exchange would fit: sigma_r and sigma_theta are never exchanged.
Only letters without a meaning are free. Each symbol is meant by one letter at most.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from fractions import Fraction
from functools import cached_property
from itertools import islice
from types import MappingProxyType

from radartrack.derive import symbolic as sp
from radartrack.derive.checking.question.compared_quantity import Reference
from radartrack.derive.checking.question.definitions.known_constants import with_symbols
from radartrack.derive.checking.question.definitions.loose_definitions import LooseDefinitions
from radartrack.derive.checking.question.formula_units import Dimension, misfits
from radartrack.derive.checking.question.letters.assignments import (
    HALF,
    STRONG,
    Choice,
    assignments,
    choices,
    farther_choices,
    keeps_numbers,
    stem,
)
from radartrack.derive.checking.question.letters.dependent_letters import Dependent, dependents
from radartrack.derive.checking.question.letters.elapsed_time import ORIGIN, Elapsed, elapsed
from radartrack.derive.checking.question.letters.letter_meanings import alike, is_word, meaning_of, means, says_degrees
from radartrack.derive.checking.question.padding import trimmed
from radartrack.derive.checking.question.printed_shape import reshaped, wrong_shape
from radartrack.derive.evaluation.floating_point import RoughEvaluator
from radartrack.derive.evaluation.points import Point, generic_points
from radartrack.derive.evaluation.tree_values import Program, close
from radartrack.derive.formula.error import FormulaError
from radartrack.derive.formula.shape import Shape
from radartrack.derive.formula.tree import Name, Tree, parts
from radartrack.derive.formula.tree import names as names_of
from radartrack.derive.formula.written_out import written_out
from radartrack.derive.language.tensor import Tensor
from radartrack.derive.language.variable import Variable
from radartrack.derive.symbolic import Expr, Symbol

POINTS = 2  # at which assignments are tried; those that fit by chance are told by proof
LONGEST = 40  # characters of a letter; what is longer is a word
MOST = 5040  # assignments that are tried: all of seven letters
PERIOD = "period"  # as meanings call it
KEPT = 5  # assignments of a wrong formula that are looked at closely


@dataclass(frozen=True)
class Letter(Choice[Variable]):
    """What a letter stands for: a symbol, its square or root if it is a variance or a deviation, or its inverse.

    Attributes:
        function: of symbols for which the letter stands instead; then the symbol only says its unit and meaning.
    """

    function: Expr | None = None

    @property
    def value(self) -> Expr:
        """The same as an expression."""
        return self.symbol ** sp.Rational(self.power) if self.function is None else self.function

    @property
    def is_symbol(self) -> bool:
        """Whether it is another name of a symbol."""
        return self.function is None and self.power == 1

    @property
    def dimension(self) -> Dimension:
        """Its dimension."""
        return Dimension.of(self.symbol.unit) ** self.power

    def __str__(self) -> str:
        return str(self.value)


Letters = Mapping[str, Letter]
NO_LETTERS: Letters = MappingProxyType({})


@dataclass(frozen=True)
class Reading:
    """Letters with what they stand for.

    Attributes:
        letters: those that are no symbols of the quantity, or are read as another symbol than that of their name.
        wrong: how many entries have other values than the quantity at some points, as far as floating point tells.
        rank: how far-fetched the meanings are together.
        misfits: how many parts of the formula, or entries, have units that do not fit.
        vanished: letters that are no part of what comes out, as they stand.
    """

    letters: Letters
    wrong: int = 0
    rank: int = 0
    misfits: int = 0
    vanished: Letters = field(default_factory=dict)

    @property
    def fits(self) -> bool:
        """Whether the units of the formula are those of the quantity."""
        return not self.misfits

    @property
    def is_right(self) -> bool:
        """Whether it makes the formula what it should be, as far as can be told without a proof."""
        return self.fits and not self.wrong

    @property
    def words(self) -> tuple[str, ...]:
        """With what it was read: "theta for beta"."""
        return tuple(
            f"{name}{', in radians,' if says_degrees(name) else ''} for {letter}"
            for name, letter in self.letters.items()
        )


AS_TYPED = Reading({})


@dataclass(frozen=True)
class Typed:
    """A formula and definitions that are read before it is known what the names in them mean.

    Attributes:
        reference: what the formula is compared with.
        entries: those of the formula.
        definitions: the trees of what is defined, in their order.
        conditions: under which both are compared.
        declared: letters of which the paper says what they are; one may hide a symbol of the quantity.
        letters: those of a formula that was worked out with them as numbers of which nothing is known.
    """

    reference: Reference
    entries: Tensor[Tree]
    definitions: Mapping[str, Tree]
    conditions: Mapping[Symbol, Expr]
    declared: Mapping[str, Variable]
    letters: Letters = field(default_factory=dict)

    def readings(self) -> list[Reading]:
        """What the letters may stand for, the likeliest first: with the units of the quantity, where any has them.

        One that makes the formula right stands alone. Nothing where the quantity has too few symbols.
        """
        unknown = [name for name in self.used if name not in self._own]
        fixed = [name for name in self.used if name in self._own]
        stems = {stem(name) for name in unknown} - {""}  # sigma_0 beside sigma_1: it may be counted from zero
        doubtful = [
            name for name in fixed if name not in self.declared and (stem(name) in stems or self._other_meanings(name))
        ]
        if any(len(name) > LONGEST for name in unknown):
            return []
        if not unknown and (not doubtful or not self._misfits({})):
            return [AS_TYPED]
        words = [name for name in unknown if is_word(name) and not self._means(name)]
        found = self._readings(unknown, fixed, doubtful)
        if words:
            raise self._unmeant(words[0], found)
        vanished = {name: letter for name, letter in self.letters.items() if name not in self.used}
        return [replace(reading, vanished=vanished) for reading in found] if vanished else found

    def _readings(self, unknown: Sequence[str], fixed: Sequence[str], doubtful: Sequence[str]) -> list[Reading]:
        found = self._judged(self._assignments(unknown, fixed))
        if not any(reading.is_right for reading in found):
            farther = [
                one for one in self._judged(self._assignments(unknown, fixed, farther=True)) if self._may_be(one)
            ]
            least = min((reading.misfits for reading in found), default=math.inf)
            found = [one for one in farther if one.is_right or one.misfits < least] or found
        if doubtful and not any(reading.fits for reading in found):
            free = self._judged(self._assignments([*unknown, *doubtful], [n for n in fixed if n not in doubtful]))
            found = [reading for reading in free if reading.fits] or found
        least_misfits = min((reading.misfits for reading in found), default=0)
        fitting = [reading for reading in found if reading.misfits == least_misfits]
        ordered = sorted(fitting, key=lambda reading: (reading.wrong, reading.rank))
        return ordered[:1] if ordered and not ordered[0].wrong else ordered[:KEPT]

    def _may_be(self, reading: Reading) -> bool:
        """Whether a reading may be told: a letter is the root of a variance where most entries have its unit then."""
        has_root = any(letter.power == HALF for letter in reading.letters.values())
        return not has_root or 2 * reading.misfits <= len(self.entries.entries)

    def _means(self, name: str) -> bool:
        """Whether a name has a meaning by which it is a symbol of the quantity, or a function of these."""
        symbols = [*self.reference.symbols, *self._functions]
        return bool(means(name, symbols) or means(name, symbols, weak=True))

    def _unmeant(self, word: str, readings: Sequence[Reading]) -> FormulaError:
        """What to say of a word that means no symbol of the quantity, although some would fit."""
        near = alike(word, self.reference.symbols)
        fitting = readings[0].letters.get(word) if readings else None
        meant = str(near or fitting or "")
        where = next((node.span for entry in self.entries for node in parts(entry) if node == Name(word)), None)
        guess = f": did you mean {near}?" if near else "."
        symbols = ", ".join(symbol.name for symbol in self.reference.symbols)
        say = f"Say what it is: --let {word}={meant}" if meant else f"Say with --let what it is of {symbols}"
        return FormulaError(f"{word} is no name that is known here{guess} {say}", span=where)

    def forced(self) -> list[Reading]:
        """Readings as symbols that the letters cannot mean: of a formula that is known to be another model's."""
        unknown = [name for name in self.used if name not in self._own]
        left = [symbol for symbol in self.reference.symbols if symbol.name not in self.used]
        pairs = dict(zip(unknown, map(Letter, left), strict=False))
        return [Reading(pairs, len(self.entries.entries), misfits=1)] if len(pairs) == len(unknown) else []

    @cached_property
    def _own(self) -> dict[str, Variable]:
        """What the names mean that need no reading."""
        return {**{symbol.name: symbol for symbol in self.reference.symbols}, **self.declared}

    @cached_property
    def used(self) -> tuple[str, ...]:
        """The names that occur and are not defined, in the order of the formula."""
        trees = [*self.entries, *(self.definitions[name] for name in self._needed)]
        names = dict.fromkeys(node.name for node in parts(*trees) if isinstance(node, Name))
        return tuple(name for name in names if name not in self.definitions)

    @cached_property
    def _needed(self) -> list[str]:
        """The definitions that the formula rests on, in their order."""
        needed = set[str]().union(*map(names_of, self.entries))
        for name in reversed(list(self.definitions)):
            if name in needed:
                needed |= names_of(self.definitions[name])
        return [name for name in self.definitions if name in needed]

    def _other_meanings(self, name: str) -> list[tuple[Variable, int]]:
        """What a symbol of the quantity may mean if not itself."""
        return [(one, power) for one, power in means(name, self.reference.symbols) if one.name != name]

    def _assignments(self, unknown: Sequence[str], fixed: Sequence[str], *, farther: bool = False) -> Iterator[Letters]:
        """What the letters may stand for; farther, also what they seldom do."""
        taken = frozenset[tuple[str, Fraction | int]]((name, 1) for name in fixed)
        symbols = [one for one in self.reference.symbols if (one.name, 1) not in taken]
        candidates = {name: self._choices(name, symbols) for name in unknown}
        if farther:
            candidates = {name: farther_choices(name, candidates, symbols) for name in unknown}
        known = {name: Choice(self._own[name]) for name in fixed}
        for one in islice(assignments(candidates, taken), MOST):
            if not keeps_numbers({**known, **one}):
                continue
            yield {name: self._letter(choice) for name, choice in one.items()}

    def _choices(self, name: str, symbols: Sequence[Variable]) -> list[Choice[Variable]]:
        """What a letter may stand for: what it means, a function that it is usual for, or anything."""
        if self._elapsed and name == self._elapsed.later:
            return [Choice(one) for one in symbols if meaning_of(one).of == PERIOD]
        usual = [] if means(name, symbols) else [one for one in self._dependents if one.is_called(name)]
        found = [Choice(one.variable, rank=one.rank) for one in usual]
        binds = any(one.rank == STRONG for one in found)
        return found if binds else [*found, *choices(name, symbols)]

    def _letter(self, choice: Choice[Variable]) -> Letter:
        return Letter(choice.symbol, choice.power, choice.rank, self._functions.get(choice.symbol))

    @cached_property
    def _dependents(self) -> list[Dependent]:
        earlier = [Dependent(ORIGIN, sp.Integer(0), frozenset({self._elapsed.earlier}))] if self._elapsed else []
        return [*earlier, *dependents(part.quantity for part in self.reference.parts)]

    @cached_property
    def _elapsed(self) -> Elapsed | None:
        """The two times whose difference is the period, where the quantity has one that stands nowhere itself."""
        periods = {symbol.name for symbol in self.reference.symbols if meaning_of(symbol).of == PERIOD}
        found = elapsed([*self.entries, *(self.definitions[name] for name in self._needed)])
        is_free = found is not None and not {found.later, found.earlier} & (self._own.keys() | self.definitions.keys())
        return found if is_free and periods and periods.isdisjoint(self.used) else None

    @cached_property
    def _functions(self) -> dict[Variable, Expr]:
        return {one.variable: one.value for one in self._dependents}

    def _judged(self, assignments: Iterator[Letters]) -> list[Reading]:
        found = []
        known: dict[tuple[Dimension, ...], int] = {}
        for letters in assignments:
            kinds = tuple(letter.dimension for letter in letters.values())
            if kinds not in known:
                known[kinds] = self._misfits(letters)
            rank = sum(letter.rank for letter in letters.values())
            found.append(Reading(dict(sorted(letters.items())), len(self.entries.entries), rank, known[kinds]))
        if any(reading.fits for reading in found):
            found = [reading for reading in found if reading.fits]
        judged = []
        for reading in sorted(found, key=lambda reading: reading.rank):
            judged.append(Reading(reading.letters, self._wrong(reading.letters), reading.rank, reading.misfits))
            if not judged[-1].wrong:
                break
        return judged

    def _misfits(self, letters: Letters) -> int:
        """How many parts of the formula, or entries, have units that do not fit."""
        known = {name: Dimension.of(symbol.unit) for name, symbol in self._own.items()}
        known |= {name: letter.dimension for name, letter in letters.items()}
        count = 0
        for name in self._needed:
            known[name], wrong = misfits(self.definitions[name], known)
            count += wrong
        for entry, expected in zip(self.entries, self.reference.dimensions, strict=True):
            found, wrong = misfits(entry, known)
            count += wrong + (0 if found.free or found.agrees(expected) else 1)
        return count

    def _wrong(self, letters: Letters) -> int:
        """How many entries have other values than the quantity."""
        return sum(
            1
            for place, program in enumerate(self._programs)
            if not all(
                close(self._value(program, letters, point), values[place])
                for point, values in zip(self._points, self._derived, strict=True)
            )
        )

    def _value(self, program: Program, letters: Letters, point: Point) -> tuple[float, ...] | None:
        known = {name: point[symbol.name] for name, symbol in self._own.items()}
        known |= {name: point[one.symbol.name] ** one.power for name, one in letters.items()}
        for name, definition in self._definition_programs.items():
            value = definition(known)
            if value is None:
                return None
            known[name] = value[0]
        return program(known)

    @cached_property
    def _programs(self) -> list[Program]:
        return [Program(entry) for entry in self.entries]

    @cached_property
    def _definition_programs(self) -> dict[str, Program]:
        return {name: Program(self.definitions[name]) for name in self._needed}

    @cached_property
    def _points(self) -> list[Point]:
        """Values of all symbols, with which the conditions hold."""
        return [self._conditioned(point) for point in generic_points(self.reference.symbols, POINTS)]

    def _conditioned(self, point: Point) -> Point:
        symbols = self.reference.symbols
        found = RoughEvaluator(list(self.conditions.values()), symbols)([point[one.name] for one in symbols])
        values = zip(self.conditions, found or (), strict=False)
        known = point | {symbol.name: value for symbol, (value, _) in values}
        rough = [(one, RoughEvaluator([one.value], symbols)) for one in self._dependents]
        at_point = [known[one.name] for one in symbols]
        found_there = ((one, value(at_point)) for one, value in rough)
        return known | {one.variable.name: value[0][0] for one, value in found_there if value}

    @cached_property
    def _derived(self) -> list[list[tuple[float, ...] | None]]:
        """What the entries of the quantity are worth at the points."""
        symbols = self.reference.symbols
        rough = [RoughEvaluator([entry], symbols) for entry in self.reference.entries]
        found: list[list[tuple[float, ...] | None]] = []
        for point in self._points:
            values = [one([point[symbol.name] for symbol in symbols]) for one in rough]
            found.append([(value[0][0],) if value else None for value in values])
        return found


def as_typed(
    read: Callable[[Sequence[str], Mapping[str, Shape]], Tree],
    reference: Reference,
    let: Mapping[str, str],
    conditions: Mapping[Symbol, Expr],
    declared: Mapping[str, Variable],
    *,
    row_by_row: bool = False,
) -> Typed | None:
    """A formula before it is known what its names mean; None where it cannot be read whatever they mean.

    So it is of a formula in which something is worked out: a sum over an index has a value only when its letters are
    known. Products of matrices and the like are written out.

    Args:
        read: the formula as it is read where names are known, with shapes if they are arrays, and others let through.
        reference: what it is compared with.
        let: definitions, in any order.
        conditions: of the comparison.
        declared: letters of which the paper says what they are, of the symbols of `reference`.
        row_by_row: whether a list may be a matrix, row by row.
    """
    own = list(dict.fromkeys([*(symbol.name for symbol in reference.symbols), *declared]))
    try:
        known = LooseDefinitions(let, own)
        tree, _ = with_symbols(read([*own, *let], known.shapes), own)
        tree, _ = trimmed(tree, reference.shape)
        needed = known.needed_by(tree)
        entries = written_out(tree, known.arrays)
    except (FormulaError, ValueError):
        return None
    if entries is None or needed is None:
        return None
    entries = reshaped(entries, reference.shape, row_by_row=row_by_row)
    return Typed(reference, entries, needed, conditions, declared) if entries.shape == reference.shape else None


def unreadable(
    read: Callable[[Sequence[str], Mapping[str, Shape]], Tree], reference: Reference, let: Mapping[str, str]
) -> FormulaError | None:
    """Why a formula cannot be read whatever its letters mean, or has another shape; None where it can."""
    own = [symbol.name for symbol in reference.symbols]
    try:
        known = LooseDefinitions(let, own)
        if known.has_unread:
            return None
        tree, _ = trimmed(read([*own, *let], known.shapes), reference.shape)
        entries = written_out(tree, known.arrays)
    except FormulaError as error:
        return error
    found = None if entries is None else reshaped(entries, reference.shape, row_by_row=True)
    return None if found is None or found.shape == reference.shape else wrong_shape(found, reference.shape)


def ambiguous(readings: Sequence[Reading]) -> FormulaError:
    """What to say where several readings explain a formula equally well, which none of them makes right."""
    kinds = {tuple(letter.dimension for letter in one.letters.values()) for one in readings}
    if len(kinds) > 1 and not any(one.fits for one in readings):
        names = ", ".join(readings[0].letters)
        verb = "is" if len(readings[0].letters) == 1 else "are"
        return FormulaError(
            f"the formula has the units of the quantity for none of its symbols: say with --let what {names} {verb}"
        )
    options = [" ".join(f"--let {name}={letter}" for name, letter in one.letters.items()) for one in readings]
    return FormulaError(f"the letters of the formula may mean more than one thing; say which: {', or '.join(options)}")
