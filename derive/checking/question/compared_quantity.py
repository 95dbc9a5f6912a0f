"""What a printed formula is compared with: a catalogue quantity, entries of one, or an expression over several.

`polar.covariance.linear`, `polar.covariance.linear[0,1]`, `polar.hessian[:,0,1]`,
`polar.map - polar.bias.second_order`.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from types import MappingProxyType

from radartrack.derive.catalogue import common_symbols
from radartrack.derive.checking.question.definitions.loose_definitions import WORD
from radartrack.derive.checking.question.formula_units import Dimension, WrongDefinition, WrongDimensions, dimensions
from radartrack.derive.checking.question.names import Names, each_once, symbols_for
from radartrack.derive.checking.question.single_number import scalar_expression
from radartrack.derive.checking.question.world import CATALOGUE, World
from radartrack.derive.formula.error import FormulaError
from radartrack.derive.formula.functions import VERBS
from radartrack.derive.formula.tree import Array, Name, Product, Tree
from radartrack.derive.formula.tree import names as names_of
from radartrack.derive.formula.tree import parts as tree_parts
from radartrack.derive.language.quantity import Quantity
from radartrack.derive.language.shared_symbols import T
from radartrack.derive.language.tensor import Index, Tensor
from radartrack.derive.language.variable import Variable
from radartrack.derive.reading.text import read_text
from radartrack.derive.symbolic import Expr

MAX_CHARACTERS = 2000
OF_GAINS = {"fading_memory", "steady_state"}
_MENTION = re.compile(r"(?<![\w.])(?P<name>[A-Za-z_]\w*(?:\.(?!T\b)[A-Za-z_]\w*)+)(?:\[(?P<index>[^\]]{0,40})\])?")
_WORD = re.compile(r"\w+")
_WORKED_OUT = re.compile(rf"\.T\b|@|\[\s*\[|;|(?<![\w.])(?:{'|'.join(VERBS)})\s*\(")
_POSITION = re.compile(r"(?P<one>\d{1,3})|(?P<first>\d{1,3})?:(?P<end>\d{1,3})?")


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
    """What is compared with: one quantity, several that are combined, or a formula of the paper's own.

    Attributes:
        text: as it was asked for.
        shape: the shape that a printed formula must have.
        symbols: all that may occur, each once.
        parts: the quantities in it.
        entry: the derived formula of an entry, exact.
        dimension: that of an entry; raises `WrongDimensions` where it has none.
        part: the part, when there is one and nothing is done with it.
    """

    text: str
    shape: Index
    symbols: tuple[Variable, ...]
    parts: tuple[Part, ...]
    entry: Callable[[Index], Expr]
    dimension: Callable[[Index], Dimension]
    part: Part | None = None

    def with_symbols(self, symbols: Iterable[Variable]) -> Reference:
        """The same, where more symbols may occur."""
        known = {symbol.name: symbol for symbol in (*self.symbols, *symbols)}
        return replace(self, symbols=tuple(known.values()))

    @cached_property
    def entries(self) -> Tensor[Expr]:
        """The derived formulas, exact."""
        return Tensor.build(self.shape, lambda *index: self.entry(index))

    @cached_property
    def dimensions(self) -> Tensor[Dimension]:
        """The dimension of each entry."""
        return Tensor.build(self.shape, lambda *index: self.dimension(index))


def is_formula(text: str) -> bool:
    """Whether what is asked for is a formula with something to work out, and no quantity: chi2inv(0.99, 2)."""
    return not _mentions(text) and bool(_WORKED_OUT.search(text))


def refer_to(quantity: Quantity) -> Reference:
    """All of one quantity, whatever it is."""
    whole = "quantity"
    return _combined(quantity.name, Name(whole), {whole: _part(quantity, None)}, CATALOGUE)


def refer(text: str, world: World = CATALOGUE, let: Mapping[str, str] = MappingProxyType({})) -> Reference:
    """Read what is meant.

    Args:
        text: a quantity, an entry, or an expression over several, in which matrices are multiplied as matrices.
        world: where quantities are found by name, and letters.
        let: definitions that an expression with verbs may use.

    Raises:
        UnknownQuantity: for a name that there is not.
        UnknownEntry: for an index that the quantity does not have, shapes that do not fit each other, or an
            expression that cannot be read.
        NoClosedForm: when an expression cannot be worked out.
    """
    if len(text) > MAX_CHARACTERS:
        raise UnknownEntry(f"{text[:80]!r} names no quantity: it has more than {MAX_CHARACTERS} characters")
    names = {found[0]: f"{_unused(text)}{place}" for place, found in enumerate(_mentions(text))}
    quantities = {found[0]: world.find(found["name"]) for found in _mentions(text)}
    if not quantities:
        world.find(text[:80].strip())
    own = {symbol.name for quantity in quantities.values() for symbol in quantity.symbols}
    of_paper = set(WORD.findall(text)) & {*let, *world.letters} - own
    if of_paper or _WORKED_OUT.search(text):
        return _worked_out(text, list(quantities.values()), world, let)
    parts = {names[found[0]]: _part(quantities[found[0]], found["index"]) for found in _mentions(text)}
    tree = _combination(text, names, parts)
    if _multiplies_arrays(tree, parts):
        return _worked_out(text, list(quantities.values()), world, let)
    reference = _combined(text, tree, parts, world)
    try:
        _ = reference.dimensions
    except WrongDefinition:  # is a verdict on what is asked
        pass
    except WrongDimensions as error:
        raise UnknownEntry(f"{text}: {_with_names(str(error), names)}") from None
    return reference


def of_formula(text: str, names: Names, quantities: Sequence[Quantity] = (), *, latex: bool = False) -> Reference:
    """A formula of the paper's own as what another one is compared with.

    Raises:
        FormulaError, UnknownQuantity: when it cannot be read.
        NoClosedForm: when it cannot be worked out.
    """
    tree = names.tree(text, latex=latex)
    trees, opened = names.entries(tree)
    entries = trees.map(opened.read)
    return Reference(
        text.strip(),
        trees.shape,
        tuple(dict.fromkeys(names.symbols.values())),
        tuple(_part(quantity, None) for quantity in quantities),
        entries.__getitem__,
        lambda index: opened.dimension_of(trees[index]),
    )


def _worked_out(text: str, quantities: Sequence[Quantity], world: World, let: Mapping[str, str]) -> Reference:
    names = Names(symbols_for([text], let, world, quantities, of_models=True), let, world)
    try:
        return of_formula(text, names, quantities)
    except FormulaError as error:
        raise UnknownEntry(f"{text}: {error.message}") from None


def _combined(text: str, tree: Tree, parts: Mapping[str, Part], world: World) -> Reference:
    """Quantities combined entry by entry."""
    own = each_once(symbol for part in parts.values() for symbol in part.quantity.symbols)
    letters = symbols_for([], {}, world, [part.quantity for part in parts.values()])
    understood = [symbol for part in parts.values() for symbol in understood_by(part.quantity)]

    def entry(index: Index) -> Expr:
        known: dict[str, Expr] = {**own, **{name: part.entry(index) for name, part in parts.items()}}
        return scalar_expression(tree, known)

    def dimension(index: Index) -> Dimension:
        known = {symbol.name: Dimension.of(symbol.unit) for symbol in own.values()}
        return dimensions(known | {name: part.dimension(index) for name, part in parts.items()})(tree)

    return Reference(
        text.strip(),
        max((part.shape for part in parts.values()), key=len),
        tuple({symbol.name: symbol for symbol in (*understood, *own.values(), *letters.values())}.values()),
        tuple(parts.values()),
        entry,
        dimension,
        parts.get(tree.name) if isinstance(tree, Name) else None,
    )


def understood_by(quantity: Quantity) -> tuple[Variable, ...]:
    """Symbols that a print may have and ours leaves out: the period by which gains are divided, a factor sigma_r^2."""
    if quantity.module not in OF_GAINS:
        return ()
    every = (T, common_symbols()["sigma_r"]) if quantity.is_covariance else (T,)
    own = {symbol.name for symbol in quantity.symbols}
    return tuple(symbol for symbol in every if symbol.name not in own)


def _multiplies_arrays(tree: Tree, parts: Mapping[str, Part]) -> bool:
    """Whether two arrays stand in one product."""
    arrays = {name for name, part in parts.items() if part.shape}
    products = (node for node in tree_parts(tree) if isinstance(node, Product))
    return any(sum(bool(names_of(factor) & arrays) for factor in product.factors) > 1 for product in products)


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
    positions = list(map(range, quantity.shape)) if index is None else _positions(quantity, index)
    shape = tuple(len(position) for position in positions if isinstance(position, range))

    def place(*free: int) -> Index:
        rest = iter(free)
        return tuple(position[next(rest)] if isinstance(position, range) else position for position in positions)

    return Part(quantity, shape, Tensor.build(shape, place))


def _positions(quantity: Quantity, index: str) -> list[int | range]:
    """A number along each axis, or those of a slice: `0`, `:`, `0:2`; an axis that is not said is taken whole."""
    found = [_POSITION.fullmatch(part.strip()) for part in index.split(",")]
    if len(found) <= len(quantity.shape):
        said = [_position(one, size) for one, size in zip(found, quantity.shape, strict=False) if one]
        fits = len(said) == len(found) and all(
            bool(one) and one[-1] < size if isinstance(one, range) else one < size
            for one, size in zip(said, quantity.shape, strict=False)
        )
        if fits:
            return [*said, *map(range, quantity.shape[len(said) :])]
    shape = list(quantity.shape)
    raise UnknownEntry(f"{quantity.name}[{index}]: the quantity has shape {shape}, indices count from 0")


def _position(found: re.Match[str], size: int) -> int | range:
    if found["one"]:
        return int(found["one"])
    return range(int(found["first"] or 0), int(found["end"] or size))
