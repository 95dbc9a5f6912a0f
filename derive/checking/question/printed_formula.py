"""A printed formula with the names a paper uses, entry by entry."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property

from radartrack.derive.checking.question.compared_quantity import Reference
from radartrack.derive.checking.question.conditions import resolved
from radartrack.derive.checking.question.formula_units import NOTHING, UNKNOWN, Dimension, WrongDimensions, dimensions
from radartrack.derive.checking.question.letters import (
    AS_TYPED,
    NO_LETTERS,
    Letters,
    Reading,
    Typed,
    read_loosely,
)
from radartrack.derive.checking.question.padding import without_padding
from radartrack.derive.checking.question.single_number import only_scalar
from radartrack.derive.formula.error import FormulaError
from radartrack.derive.formula.fold import Fold
from radartrack.derive.formula.functions import SPELLINGS
from radartrack.derive.formula.printing import to_text
from radartrack.derive.formula.shape import shape
from radartrack.derive.formula.to_expression import Reader
from radartrack.derive.formula.tree import Array, Negation, Number, Product, Quotient, Sum, Tree
from radartrack.derive.formula.tree import names as names_of
from radartrack.derive.formula.unknown_names import unusable
from radartrack.derive.language.tensor import Index, Tensor
from radartrack.derive.language.variable import Variable
from radartrack.derive.reading.latex import read_latex
from radartrack.derive.reading.text import read_text
from radartrack.derive.symbolic import Expr, Symbol

NAME = re.compile(r"[A-Za-z_][A-Za-z0-9_]*")
SHOWN = 40  # characters of a name that is refused


@dataclass(frozen=True)
class Names:
    """The names that a formula may use.

    Attributes:
        values: what each stands for in the quantity's symbols.
        dimensions: and its dimension, where it has one.
        definitions: those that are defined, as printed, each in names that stand before it.
        faults: what is wrong with the units of those that have no dimension.
    """

    values: Mapping[str, Expr]
    dimensions: Mapping[str, Dimension]
    definitions: Mapping[str, Tree] = field(default_factory=dict)
    faults: Mapping[str, str] = field(default_factory=dict)

    def read(self, tree: Tree) -> Expr:
        """A scalar tree in the quantity's symbols."""
        return only_scalar(self._reader(tree), tree)

    def dimension_of(self, tree: Tree) -> Dimension:
        """The dimension of a scalar tree.

        Raises:
            WrongDimensions: when it has none.
        """
        for name in sorted(self.faults.keys() & (names_of(tree) if self.faults else set())):
            raise WrongDimensions(f"{name} has no dimension: {self.faults[name]}")
        return self._dimension_of(tree)

    @cached_property
    def _reader(self) -> Reader:
        return Reader(self.values)

    @cached_property
    def _dimension_of(self) -> Fold[Dimension]:
        return dimensions(self.dimensions)


@dataclass(frozen=True)
class Printed:
    """A formula as printed.

    Attributes:
        tree: the whole.
        entries: its entries as trees.
        expressions: the entries in the quantity's symbols.
        names: what its names stand for.
        padding: which rows and columns of zeros were left out, in words.
    """

    tree: Tree
    entries: Tensor[Tree]
    expressions: Tensor[Expr]
    names: Names
    padding: str = ""

    @property
    def text(self) -> str:
        """The formula as it was read."""
        return to_text(self.tree)

    @property
    def dimensions(self) -> Tensor[Dimension | None]:
        """The dimension of each entry; None where terms of different dimension are added, and the like."""
        return self.entries.map(self._dimension)

    def _dimension(self, entry: Tree) -> Dimension | None:
        try:
            return self.names.dimension_of(entry)
        except WrongDimensions:
            return None


def names_for(reference: Reference, let: Mapping[str, str], letters: Letters = NO_LETTERS) -> Names:
    """The quantity's symbols, in the paper's letters where it has its own, and its names for expressions in them.

    Raises:
        FormulaError: for a definition that cannot be read, or a name that is already taken or is none.
    """
    meant = {letter.symbol.name for letter in letters.values() if letter.power == 1}
    symbols = [symbol for symbol in reference.symbols if symbol.name not in meant]
    values: dict[str, Expr] = {symbol.name: symbol for symbol in symbols}
    dimensions = {symbol.name: Dimension.of(symbol.unit) for symbol in symbols}
    values |= {name: letter.value for name, letter in letters.items()}
    dimensions |= {name: letter.dimension for name, letter in letters.items()}
    definitions: dict[str, Tree] = {}
    faults: dict[str, str] = {}
    for name, definition in let.items():
        _check_name(name)
        if name in values:
            raise FormulaError(f"let {name}: {name} is already a symbol of {reference.text}")
        if why := unusable(name):
            raise FormulaError(f"let {name}: {why}")
        known = Names(dict(values), dict(dimensions), faults=dict(faults))
        tree, values[name] = _definition("let", name, definition, known)
        definitions[name] = tree
        try:
            dimensions[name] = known.dimension_of(tree) if values[name] != 0 else NOTHING
        except WrongDimensions as error:
            dimensions[name], faults[name] = UNKNOWN, str(error)
    return Names(values, dimensions, definitions, faults)


def conditions_for(reference: Reference, given: Mapping[str, str]) -> dict[Symbol, Expr]:
    """What symbols are replaced by under the conditions.

    Raises:
        FormulaError: for a condition that cannot be read, a name that is no symbol of the quantity, a value in another
            unit, and where `resolved` raises it.
    """
    symbols = {symbol.name: symbol for symbol in reference.symbols}
    known = Names(symbols, {name: Dimension.of(symbol.unit) for name, symbol in symbols.items()})
    conditions: dict[Variable, Expr] = {}
    trees: dict[str, Tree] = {}
    for name, value in given.items():
        if name not in symbols:
            raise FormulaError(f"given {name}: the symbols of {reference.text} are {', '.join(symbols)}")
        trees[name], conditions[symbols[name]] = _definition("given", name, value, known)
    found = resolved(conditions)
    for name, tree in trees.items():
        _check_unit(name, tree, known)
    return found


def read_printed(formula: str, names: Names, expected: Index, *, latex: bool) -> Printed:
    """Read a formula of the expected shape.

    Raises:
        FormulaError: when it cannot be read, or has another shape.
    """
    tree = (read_latex if latex else read_text)(formula, names.values)
    inner, padding = _without_padding(tree, expected)
    found = shape(inner)
    if found != expected:
        raise FormulaError(f"the formula is {_spoken(found)}, the quantity is {_spoken(expected)}")
    entries = Tensor.build(expected, lambda *index: entry_of(inner, index))
    try:
        return Printed(tree, entries, entries.map(names.read), names, padding)
    except FormulaError as error:
        raise error.within(formula) from None


def _without_padding(tree: Tree, expected: Index) -> tuple[Tree, str]:
    """The formula without rows and columns of zeros that are too many, where there are such."""
    found = without_padding(tree, expected) if shape(tree) != expected else None
    return found or (tree, "")


def letter_readings(
    formula: str, reference: Reference, let: Mapping[str, str], conditions: Mapping[Symbol, Expr], *, latex: bool
) -> list[Reading]:
    """What the letters of a formula may stand for, the likeliest first; `AS_TYPED` alone where it has none of its own.

    A formula that cannot be read, whatever its names mean, is left to `read_printed` to refuse.
    """
    typed = as_typed(formula, reference, let, conditions, latex=latex)
    return (typed.readings() if typed else []) or [AS_TYPED]


def as_typed(
    formula: str, reference: Reference, let: Mapping[str, str], conditions: Mapping[Symbol, Expr], *, latex: bool
) -> Typed | None:
    """A formula before it is known what its names mean; None where it cannot be read whatever they mean."""
    own = [symbol.name for symbol in reference.symbols]
    if any(unusable(name) for name in let) or set(own) & set(let):
        return None
    try:
        definitions = {name: read_loosely(text, [*own, *let]) for name, text in let.items()}
        tree, _ = _without_padding(read_loosely(formula, [*own, *let], latex=latex), reference.shape)
    except FormulaError:
        return None
    if shape(tree) != reference.shape:
        return None
    entries = Tensor.build(reference.shape, lambda *index: entry_of(tree, index))
    return Typed(reference, entries, definitions, conditions)


def entry_of(tree: Tree, index: Index) -> Tree:
    """One entry of a formula of arrays, factors and terms distributed to it."""
    if not index:
        return tree
    match tree:
        case Array(entries):
            return entry_of(entries[index[0]], index[1:])
        case Sum(terms):
            return Sum(tuple(entry_of(term, index) for term in terms))
        case Negation(operand):
            return Negation(entry_of(operand, index))
        case Quotient(numerator, denominator):
            return Quotient(entry_of(numerator, index), denominator)
        case Product(factors):
            return _factors(factors, index)
        case _:
            return tree


def _factors(factors: tuple[Tree, ...], index: Index) -> Tree:
    chosen = tuple(entry_of(factor, index) if shape(factor) else factor for factor in factors)
    kept = tuple(factor for factor in chosen if factor != Number("1")) or (Number("1"),)
    flat = tuple(part for factor in kept for part in (factor.factors if isinstance(factor, Product) else (factor,)))
    return flat[0] if len(flat) == 1 else Product(flat)


def _definition(kind: str, name: str, text: str, known: Names) -> tuple[Tree, Expr]:
    try:
        tree = read_text(text, known.values)
        return tree, known.read(tree)
    except FormulaError as error:
        raise FormulaError(f"{kind} {name}: {error.message}", error.source or text, error.span) from None


def _dimension(what: str, tree: Tree, known: Names) -> Dimension:
    try:
        return known.dimension_of(tree)
    except WrongDimensions as error:
        raise FormulaError(f"{what}: it has no dimension: {error}") from None


def _check_unit(name: str, tree: Tree, known: Names) -> None:
    """Refuse a condition that sets a symbol to what has another unit."""
    found, own = _dimension(f"given {name}", tree, known), known.dimensions[name]
    if not found.free and not found.agrees(own):
        raise FormulaError(f"given {name}: {to_text(tree)} has {found}, {name} has {own}; both need one unit")


def _check_name(name: str) -> None:
    """Refuse what no formula is read to contain."""
    if name in SPELLINGS:
        raise FormulaError(f"let {name}: {name} is a function; define another name")
    if not NAME.fullmatch(name):
        raise FormulaError(
            f"let {name[:SHOWN]}: a name is letters, digits and _, and begins with no digit; "
            r"\dot{x} is defined as xdot, \sigma_\theta as sigma_theta, and g(x) cannot be defined"
        )


def _spoken(one: Index) -> str:
    return f"an array of shape {list(one)}" if one else "a scalar"
