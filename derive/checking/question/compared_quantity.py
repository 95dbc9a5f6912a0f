"""What a printed formula is compared with: a catalogue quantity, entries of one, or an expression over several.

`polar.covariance.linear`, `polar.covariance.linear[0,1]`, `polar.hessian[:,0,1]`,
`polar.map - polar.bias.second_order`.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property

from radartrack.derive.checking.question.formula_units import Dimension, WrongDimensions, dimensions
from radartrack.derive.checking.question.single_number import scalar_expression
from radartrack.derive.checking.question.world import CATALOGUE, World
from radartrack.derive.formula.error import FormulaError
from radartrack.derive.formula.tree import Array, Name, Tree
from radartrack.derive.language.quantity import Quantity
from radartrack.derive.language.tensor import Index, Tensor
from radartrack.derive.language.variable import Variable
from radartrack.derive.reading.text import read_text
from radartrack.derive.symbolic import Expr

MAX_CHARACTERS = 2000
_MENTION = re.compile(r"(?<![\w.])(?P<name>[A-Za-z_]\w*(?:\.[A-Za-z_]\w*)+)(?:\[(?P<index>[^\]]{0,40})\])?")
_WORD = re.compile(r"\w+")
_POSITION = re.compile(r"\s*(\d{1,3}|:)\s*")


class UnknownEntry(ValueError):
    """A quantity has no such entry, or an expression over quantities makes no sense."""


@dataclass(frozen=True)
class Part:
    """Entries of one quantity; `places` leads from an index here to the index in the quantity."""

    quantity: Quantity
    shape: Index
    places: Tensor[Index]

    def entry(self, index: Index) -> Expr:
        """The derived formula of one entry; a scalar serves every index."""
        return self.quantity.expression[self.places[index if self.shape else ()]]

    def dimension(self, index: Index) -> Dimension:
        """Its dimension."""
        return Dimension.of(self.quantity.unit(self.places[index if self.shape else ()]))


@dataclass(frozen=True)
class Reference:
    """One or more quantities, combined.

    Attributes:
        text: as it was asked for.
        tree: the combination, over placeholders.
        parts: what each placeholder stands for.
    """

    text: str
    tree: Tree
    parts: Mapping[str, Part]

    @property
    def part(self) -> Part | None:
        """The part, when there is one and nothing is done with it."""
        return self.parts.get(self.tree.name) if isinstance(self.tree, Name) else None

    @property
    def symbols(self) -> tuple[Variable, ...]:
        """All symbols, each once."""
        found: dict[str, Variable] = {}
        for part in self.parts.values():
            found.update({symbol.name: symbol for symbol in part.quantity.symbols})
        return tuple(found.values())

    @property
    def shape(self) -> Index:
        """The shape that a printed formula must have."""
        return max((part.shape for part in self.parts.values()), key=len)

    @cached_property
    def entries(self) -> Tensor[Expr]:
        """The derived formulas, exact."""
        return Tensor.build(self.shape, lambda *index: self._entry(index))

    @cached_property
    def dimensions(self) -> Tensor[Dimension]:
        """The dimension of each entry."""
        return Tensor.build(self.shape, lambda *index: self._dimension(index))

    def _entry(self, index: Index) -> Expr:
        known: dict[str, Expr] = {symbol.name: symbol for symbol in self.symbols}
        known |= {name: part.entry(index) for name, part in self.parts.items()}
        return scalar_expression(self.tree, known)

    def _dimension(self, index: Index) -> Dimension:
        known = {symbol.name: Dimension.of(symbol.unit) for symbol in self.symbols}
        known |= {name: part.dimension(index) for name, part in self.parts.items()}
        return dimensions(known)(self.tree)


def refer_to(quantity: Quantity) -> Reference:
    """All of one quantity, whatever it is."""
    whole = "quantity"
    return Reference(quantity.name, Name(whole), {whole: _part(quantity, None)})


def refer(text: str, world: World = CATALOGUE) -> Reference:
    """Read what is meant.

    Raises:
        UnknownQuantity: for a name that the world does not have.
        UnknownEntry: for an index that the quantity does not have, shapes that do not fit each other, or an
            expression that cannot be read.
    """
    if len(text) > MAX_CHARACTERS:
        raise UnknownEntry(f"{text[:80]!r} names no quantity: it has more than {MAX_CHARACTERS} characters")
    names = {found[0]: f"{_unused(text)}{place}" for place, found in enumerate(_mentions(text))}
    parts = {names[found[0]]: _part(world.find(found["name"]), found["index"]) for found in _mentions(text)}
    if not parts:
        world.find(text[:80].strip())
    reference = Reference(text.strip(), _combination(text, names, parts), parts)
    try:
        _ = reference.dimensions
    except WrongDimensions as error:
        raise UnknownEntry(f"{text}: {_with_names(str(error), names)}") from None
    return reference


def _mentions(text: str) -> list[re.Match[str]]:
    """The quantities of an expression, each once."""
    return list({found[0]: found for found in _MENTION.finditer(text)}.values())


def _combination(text: str, names: Mapping[str, str], parts: Mapping[str, Part]) -> Tree:
    """The expression over placeholders for its quantities, all of one shape or scalars."""
    symbols = {symbol.name for part in parts.values() for symbol in part.quantity.symbols}
    try:
        tree = read_text(_MENTION.sub(lambda found: names[found[0]], text), symbols | set(parts))
    except FormulaError as error:
        raise UnknownEntry(f"{text}: {_with_names(error.message, names)}") from None
    if isinstance(tree, Array):
        raise UnknownEntry(f"{text}: an expression over quantities is no array")
    shapes = {part.shape for part in parts.values() if part.shape}
    if len(shapes) > 1:
        raise UnknownEntry(f"{text}: the shapes {' and '.join(map(str, sorted(shapes)))} do not fit each other")
    return tree


def _with_names(message: str, names: Mapping[str, str]) -> str:
    """What is said about placeholders, said about quantities."""
    quantities = {placeholder: quantity for quantity, placeholder in names.items()}
    return _WORD.sub(lambda found: quantities.get(found[0], found[0]), message)


def _unused(text: str) -> str:
    """How the names of placeholders begin: as no word of the text does."""
    start = "quantity_"
    while start in text:
        start += "_"
    return start


def _part(quantity: Quantity, index: str | None) -> Part:
    positions = [":"] * len(quantity.shape) if index is None else _positions(quantity, index)
    choices = [range(n) if p == ":" else [int(p)] for p, n in zip(positions, quantity.shape, strict=True)]
    shape = tuple(n for p, n in zip(positions, quantity.shape, strict=True) if p == ":")

    def place(*free: int) -> Index:
        rest = iter(free)
        return tuple(next(rest) if p == ":" else chosen[0] for p, chosen in zip(positions, choices, strict=True))

    return Part(quantity, shape, Tensor.build(shape, place))


def _positions(quantity: Quantity, index: str) -> list[str]:
    positions = [part.strip() for part in index.split(",")]
    fits = len(positions) == len(quantity.shape) and all(
        _POSITION.fullmatch(p) and (p == ":" or int(p) < n) for p, n in zip(positions, quantity.shape, strict=False)
    )
    if not fits:
        shape = list(quantity.shape)
        raise UnknownEntry(f"{quantity.name}[{index}]: the quantity has shape {shape}, indices count from 0")
    return positions
