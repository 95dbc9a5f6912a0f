"""A printed formula with the names a paper uses, entry by entry."""

from __future__ import annotations

import math
import re
from collections.abc import Collection, Iterable, Mapping
from dataclasses import dataclass, replace
from math import prod
from types import MappingProxyType

from radartrack.derive.catalogue import common_symbols
from radartrack.derive.checking.question.compared_quantity import Reference
from radartrack.derive.checking.question.conditions import resolved
from radartrack.derive.checking.question.definitions.known_constants import with_symbols
from radartrack.derive.checking.question.formula_units import Dimension, WrongDimensions
from radartrack.derive.checking.question.letters.letter_meanings import alike, means
from radartrack.derive.checking.question.letters.letter_readings import NO_LETTERS, Letter, Letters
from radartrack.derive.checking.question.meaning import Meaning
from radartrack.derive.checking.question.names import Names, check_name, indices_in, symbols_for
from radartrack.derive.checking.question.padding import trimmed
from radartrack.derive.checking.question.printed_shape import blocks_of, is_transposed, reshaped, wrong_shape
from radartrack.derive.checking.question.world import CATALOGUE, World
from radartrack.derive.formula.error import FormulaError, Span
from radartrack.derive.formula.printing import to_text
from radartrack.derive.formula.tree import Tree
from radartrack.derive.language.tensor import Index, Tensor
from radartrack.derive.language.variable import Variable
from radartrack.derive.reading.notation import LANGUAGES, TEXT
from radartrack.derive.reading.unit_text import measured
from radartrack.derive.symbolic import Expr, Symbol
from radartrack.derive.units import RADIAN

_PLAIN = re.compile(r"\s*[+-]?(\d+\.?\d*|\.\d+)\s*")
NOTHING: Mapping[str, str] = MappingProxyType({})


@dataclass(frozen=True)
class Printed:
    """A formula as printed.

    Attributes:
        tree: the whole.
        entries: its entries as trees.
        expressions: the entries in the quantity's symbols.
        names: what its names stand for.
        worked_out: the names in the entries that stand for parts that are worked out.
        source: what was read, where places in it are told by lines.
        remarks: what the reader has to say, such as which rows and columns of zeros were left out.
    """

    tree: Tree
    entries: Tensor[Tree]
    expressions: Tensor[Expr]
    names: Names
    worked_out: frozenset[str] = frozenset()
    source: str = ""
    remarks: tuple[str, ...] = ()

    @property
    def text(self) -> str:
        """The formula as it was read."""
        return to_text(self.tree)

    def line_of(self, span: Span | None) -> str:
        """The line of the code in words; nothing where there is but one."""
        if span is None or "\n" not in self.source.strip("\n"):
            return ""
        return f"line {self.source.count(chr(10), 0, span[0]) + 1}: "

    @property
    def dimensions(self) -> Tensor[Dimension | None]:
        """The dimension of each entry; None where terms of different dimension are added, and the like."""
        return self.entries.map(self._dimension)

    def _dimension(self, entry: Tree) -> Dimension | None:
        try:
            return self.names.dimension_of(entry)
        except WrongDimensions:
            return None


def names_for(
    reference: Reference,
    let: Mapping[str, str],
    world: World = CATALOGUE,
    texts: Iterable[str] = (),
    letters: Letters = NO_LETTERS,
    indices: Collection[str] = (),
) -> Names:
    """The symbols that a formula may use, and the paper's names: definitions of a claim, and those of its file.

    Args:
        reference: what is compared with.
        let: the definitions of the claim.
        world: the paper's.
        texts: formulas that are read in these names.
        letters: that stand for symbols, which have no other name then.
        indices: of sums and the like in the formula, of which definitions may be functions, as of those in definitions.

    Raises:
        FormulaError: for a definition of the claim that cannot be read, or a name that is none.
        NoClosedForm: for one that cannot be worked out.
    """
    both = {**world.let, **let}
    quantities = [part.quantity for part in reference.parts]
    own = {symbol.name: symbol for symbol in reference.symbols}
    own |= symbols_for([*let.values(), *texts], both, world, quantities)
    meant = {letter.symbol for letter in letters.values() if letter.is_symbol}
    symbols = {name: symbol for name, symbol in own.items() if symbol not in meant}
    symbols |= {name: letter.symbol for name, letter in letters.items() if letter.is_symbol}
    powers = {name: _meaning(letter) for name, letter in letters.items() if not letter.is_symbol}
    names = Names(symbols, both, world, powers)
    functions = names.resting_on({*indices, *(index for text in let.values() for index in indices_in(text, both))})
    for name in let:
        check_name(name)
        if name not in functions:
            names.meaning(name)
    return names


def conditions_for(reference: Reference, given: Mapping[str, str], names: Names | None = None) -> dict[Symbol, Expr]:
    """What symbols are replaced by under the conditions.

    Args:
        reference: what is compared with.
        given: the conditions.
        names: what their formulas may use; without them, the symbols.

    Raises:
        FormulaError: for a condition that cannot be read, a name that is no symbol of the quantity, a value in another
            unit, and where `resolved` raises it.
    """
    symbols = {symbol.name: symbol for symbol in reference.symbols}
    known = names.besides(symbols) if names else Names(symbols)
    conditions: dict[Variable, Expr] = {}
    trees: dict[Variable, Tree] = {}
    for name, value in given.items():
        symbol = symbol_called(name, known, reference)
        if symbol is None:
            near = alike(name, reference.symbols)
            guess = f"did you mean {near}? The" if near else "the"
            raise FormulaError(f"given {name}: {guess} symbols of {reference.text} are {', '.join(symbols)}")
        tree, expression = _condition(name, _with_unit(symbol, value), known)
        if (
            expression != symbol or value.strip() == name
        ):  # a letter of the print that is read as this symbol says nothing
            trees[symbol], conditions[symbol] = tree, expression
    found = resolved(conditions)
    for symbol, tree in trees.items():
        _check_unit(symbol, tree, known)
    return found


def applying(conditions: Mapping[str, str], reference: Reference, printed: Printed) -> dict[str, str]:
    """Those conditions of a file whose symbols occur in a question."""
    formulas = (*reference.entries, *printed.expressions)
    occurring = {symbol.name for formula in formulas for symbol in formula.free_symbols}
    occurring |= {symbol.name for part in reference.parts for symbol in part.quantity.symbols}
    return {name: value for name, value in conditions.items() if name in occurring}


def read_printed(formula: str, names: Names, expected: Index, notation: str = TEXT, function: str = "") -> Printed:
    """Read a formula of the expected shape, in one of the `NOTATIONS`; of code, perhaps one function.

    Raises:
        FormulaError: when it cannot be read, or has another shape.
        NoClosedForm: when it cannot be worked out.
    """
    try:
        reading = names.reading(formula, notation, function, prod(expected) if len(expected) == 1 else 1)
        tree, constants = with_symbols(reading.tree, names.symbols)
        inner, padding = trimmed(tree, expected)
        source = formula if reading.notation in LANGUAGES else ""
        remarks = (*reading.remarks, *names.remarks, *constants, *((padding,) if padding else ()))
        found = printed(inner, names, expected, row_by_row=bool(source))
        return replace(found, tree=tree, source=source, remarks=tuple(dict.fromkeys((*remarks, *found.remarks))))
    except FormulaError as error:
        raise error.within(formula) from None


def printed(tree: Tree, names: Names, expected: Index, *, row_by_row: bool = False) -> Printed:
    """A formula that was read; raises as `read_printed`."""
    entries, opened = names.entries(tree)
    turned = is_transposed(entries.shape, expected)
    remarks = [f"read transposed: it has shape {list(entries.shape)}, the quantity {list(expected)}"] if turned else []
    if blocks := blocks_of(entries, expected):
        remarks.append(f"read for one axis of {len(blocks)}: all have the same block, and the rest is zero")
    entries = reshaped(entries, expected, row_by_row=row_by_row)
    if entries.shape != expected:
        raise wrong_shape(entries, expected)
    parts = frozenset(opened) - frozenset(names)
    return Printed(tree, entries, entries.map(opened.read), opened, parts, remarks=tuple(remarks))


def symbol_called(name: str, names: Names, reference: Reference) -> Variable | None:
    """The symbol of this name, or the one for which a name of the paper stands."""
    if (found := next((symbol for symbol in reference.symbols if symbol.name == name), None)) is not None:
        return found
    value = names.meaning(name).value if name in names.let else names.symbols.get(name)
    is_correlation = name in common_symbols() and common_symbols()[name].is_correlation  # rho is no range here
    if value is None and not is_correlation and len(meant := means(name, reference.symbols)) == 1 and meant[0][1] == 1:
        return meant[0][0]  # as in a formula: azimuth for beta
    return value if isinstance(value, Variable) else None


def _meaning(letter: Letter) -> Meaning:
    return Meaning(letter.value, lambda _: letter.dimension)


def _condition(name: str, text: str, known: Names) -> tuple[Tree, Expr]:
    try:
        tree = known.tree(text)
        return tree, known.read(tree)
    except FormulaError as error:
        raise FormulaError(f"given {name}: {error.message}", error.source or text, error.span) from None


def _with_unit(symbol: Variable, text: str) -> str:
    """What a symbol is set to, where it is a number with a unit, in SI units."""
    number = measured(text)
    if number is None:
        return text
    if number.unit != symbol.unit:
        raise FormulaError(f"given {symbol}: {text.strip()} has the unit {number.unit}, {symbol} has {symbol.unit}")
    return number.formula


def doubtful_angles(reference: Reference, given: Mapping[str, str], names: Names) -> tuple[str, ...]:
    """What to say of angles that are set to a number beyond a turn, which was perhaps meant in degrees."""
    found = []
    for name, text in given.items():
        symbol = symbol_called(name, names, reference)
        if symbol is None or symbol.unit != RADIAN or not _PLAIN.fullmatch(text):
            continue
        if abs(float(text)) > (2 * math.pi if symbol.is_angle else 1):
            found.append(f"{name} = {text.strip()} is {text.strip()} rad; for degrees write {name}={text.strip()}deg")
    return tuple(found)


def _check_unit(symbol: Variable, tree: Tree, known: Names) -> None:
    """Refuse a condition that sets a symbol to what has another unit."""
    entries, opened = known.entries(tree)
    try:
        found = opened.dimension_of(entries[()])
    except WrongDimensions as error:
        raise FormulaError(f"given {symbol}: it has no dimension: {error}") from None
    own = Dimension.of(symbol.unit)
    if not found.free and not found.agrees(own):
        raise FormulaError(f"given {symbol}: {to_text(tree)} has {found}, {symbol} has {own}; both need one unit")
