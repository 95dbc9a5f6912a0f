"""Quantities that a paper defines, `[[define]]`: by a formula, or by equations that they satisfy."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Any

from radartrack.derive.catalogue import catalogue, common_symbols
from radartrack.derive.checking.question.formula_units import Dimension, WrongDimensions, in_definition
from radartrack.derive.checking.question.names import QUANTITY, Names, letters_of_catalogue, symbols_for
from radartrack.derive.checking.question.world import ImplicitDefinition, World
from radartrack.derive.formula.error import FormulaError
from radartrack.derive.formula.unknown_names import unusable
from radartrack.derive.language.quantity import Conditioning, Quantity
from radartrack.derive.language.source import Source
from radartrack.derive.language.tensor import Index
from radartrack.derive.language.variable import Variable
from radartrack.derive.reading.symbol_table import TableError, shown, shown_name
from radartrack.derive.units import ONE, Unit
from radartrack.derive.verbs.no_closed_form import NoClosedForm

FIELDS = ("name", "symbols", "is", "unknown", "equations", "where", "meaning")
MOST_DEFINITIONS = 200
MOST_EQUATIONS = 40
PARAMETER = (1e-3, 1e3)  # the domain of a letter of which nothing is said

Table = Mapping[str, Any]


def definition_tables(data: Table) -> list[Table]:
    """The definitions of a file; nothing in them is read.

    Raises:
        TableError: where these are no tables.
    """
    tables = data.get("define", [])
    if not isinstance(tables, list) or not all(isinstance(table, Mapping) for table in tables):
        raise TableError("define must be one or more tables, each begun by [[define]]")
    if len(tables) > MOST_DEFINITIONS:
        raise TableError(f"at most {MOST_DEFINITIONS} definitions are read, given {len(tables)}")
    return tables


def with_definitions(world: World, tables: Sequence[Table]) -> World:
    """The world and what it defines; a definition is read when something is asked of it."""
    makers: dict[str, Callable[[], Quantity]] = {}
    implicit: dict[str, ImplicitDefinition] = {}
    unreadable = dict(world.unreadable)
    for number, table in enumerate(tables, start=1):
        name = table.get("name")
        where = f"define {shown_name(name)}" if isinstance(name, str) else f"define {number}"
        try:
            known = {*makers, *implicit, *world.quantities, *catalogue()}
            name = _name(name, where, known)
            if "is" in table:
                makers[name] = lambda table=table, where=where: defined(table, where, complete())  # type: ignore[misc]
            else:
                implicit[name] = _implicit(table, where, world)
        except TableError as error:
            unreadable[str(name)] = str(error)
    found = replace(world, definitions=_Lazy(makers), implicit=implicit, unreadable=unreadable)

    def complete() -> World:
        return found

    return found


class _Lazy(Mapping[str, Quantity]):
    """Quantities that are made when they are asked for."""

    def __init__(self, makers: Mapping[str, Callable[[], Quantity]]) -> None:
        self._makers = makers
        self._known: dict[str, Quantity] = {}
        self._made: list[str] = []  # those that are being made

    def __getitem__(self, name: str) -> Quantity:
        if name in self._known:
            return self._known[name]
        if name in self._made:
            cycle = " needs ".join([*self._made[self._made.index(name) :], name])
            raise FormulaError(f"define {name}: it is defined by itself: {cycle}")
        self._made.append(name)
        try:
            self._known[name] = self._makers[name]()
        finally:
            self._made.pop()
        return self._known[name]

    def __contains__(self, name: object) -> bool:
        return name in self._makers

    def __iter__(self) -> Iterator[str]:
        return iter(self._makers)

    def __len__(self) -> int:
        return len(self._makers)


def defined(table: Table, where: str, world: World) -> Quantity:
    """A quantity that is a formula.

    Raises:
        TableError, FormulaError: naming the definition.
        NoClosedForm: when it cannot be worked out.
    """
    _check_fields(table, where, ("unknown", "equations", "where"))
    text = _text(table["is"], f"{where}: is")
    listed = parameters(table, where, world)
    symbols = {
        **letters_of_catalogue([text], world.let),
        **symbols_for([text], world.let, world, of_models=True),
        **listed,
    }
    names = Names(symbols, world.let, world)
    try:
        trees, opened = names.entries(names.tree(text))
        expressions = trees.map(opened.read)
    except FormulaError as error:
        if error.message.startswith("define "):  # another definition that it needs
            raise
        raise FormulaError(f"{where}: {error.message}", error.source or text, error.span) from None
    except NoClosedForm as error:
        raise NoClosedForm(f"{where}: {error}") from None
    used = {symbol for entry in expressions for symbol in entry.free_symbols if isinstance(symbol, Variable)}

    def unit(index: Index) -> Unit:
        try:
            dimension = opened.dimension_of(trees[index])
        except WrongDimensions as error:
            raise in_definition(where, error) from None
        return _unit(dimension)

    return Quantity(
        name=str(table["name"]),
        meaning=str(table.get("meaning", "a definition of the paper")),
        axes=tuple((ONE,) * size for size in trees.shape),
        symbols=tuple(dict.fromkeys([*listed.values(), *sorted(used, key=str)])),
        conditioning=Conditioning.NONE,
        source=Source("the paper", None, str(table["name"])),
        word=text,
        derivation=lambda: expressions,
        unit_of_entry=unit,
    )


def parameters(table: Table, where: str, world: World) -> dict[str, Variable]:
    """The letters that a definition depends on; one of which nothing is said is the catalogue's of that name.

    A letter that the catalogue does not have either is a positive number.
    """
    names = table.get("symbols", [])
    if not isinstance(names, list) or not all(isinstance(name, str) for name in names):
        raise TableError(f'{where}: symbols must be a list of letters, such as ["T"]; given {shown(names)}')
    found = {}
    for name in names:
        if why := world.spoiled.get(name) or unusable(name):
            raise TableError(f"{where}: symbols: {why}")
        if name not in world.let:
            known = world.letters.get(name) or common_symbols().get(name)
            found[name] = known or Variable(name, name, ONE, *PARAMETER)
    return found


def _implicit(table: Table, where: str, world: World) -> ImplicitDefinition:
    _check_fields(table, where, ("is",))
    for field in ("unknown", "equations"):
        if field not in table:
            raise TableError(f"{where}: {field} is missing; a definition has is, or unknown and equations")
    unknown = _texts(table["unknown"], f"{where}: unknown")
    for name in unknown:
        if why := unusable(name):
            raise TableError(f"{where}: unknown: {why}")
    return ImplicitDefinition(
        name=str(table["name"]),
        symbols=parameters(table, where, world),
        unknown=unknown,
        equations=_texts(table["equations"], f"{where}: equations"),
        where=_texts(table["where"], f"{where}: where") if "where" in table else (),
    )


def _name(name: object, where: str, known: set[str]) -> str:
    if not isinstance(name, str) or not QUANTITY.fullmatch(name):
        raise TableError(f'{where}: name must be words with dots between, such as "kalata.gain"; given {shown(name)}')
    if name in known:
        raise TableError(f"{where}: {name} is known already; a definition has a name of its own")
    return name


def _check_fields(table: Table, where: str, others: tuple[str, ...]) -> None:
    for field in table:
        if field not in FIELDS:
            raise TableError(f"{where}: {shown_name(field)} is no field; allowed: {', '.join(FIELDS)}")
        if field in others:
            raise TableError(f"{where}: {field} has no place here; a definition has is, or unknown and equations")


def _text(value: object, where: str) -> str:
    if not isinstance(value, str) or not value.strip():
        raise TableError(f"{where} must be a formula in quotes, given {shown(value)}")
    return value


def _texts(value: object, where: str) -> tuple[str, ...]:
    if not isinstance(value, list) or not 1 <= len(value) <= MOST_EQUATIONS:
        raise TableError(f"{where} must be a list of 1 to {MOST_EQUATIONS} texts, given {shown(value)}")
    return tuple(_text(one, where) for one in value)


def _unit(dimension: Dimension) -> Unit:
    return Unit(dimension.metre, dimension.second, dimension.radian or Unit().radian)
