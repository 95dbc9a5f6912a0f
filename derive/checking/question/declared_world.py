"""The world that the tables of files declare."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import Any

from radartrack.derive.checking.question.definitions.paper_definitions import definition_tables, with_definitions
from radartrack.derive.checking.question.world import CATALOGUE, World
from radartrack.derive.language.model import Model
from radartrack.derive.language.variable import Variable
from radartrack.derive.moments.conversion_quantities import quantities_of
from radartrack.derive.reading.any_letters import plain_formulas
from radartrack.derive.reading.model_table import model_tables, read_model, require_own_name
from radartrack.derive.reading.symbol_table import TableError, read_symbol, shown, shown_name

DEVIATION = "sigma"
MOST = 2_000  # entries of a table


def world_of(files: Sequence[Mapping[str, Any]]) -> World:
    """What files declare together; what cannot be read spoils only what is asked of it.

    Args:
        files: the data of each, as TOML gives it.

    Raises:
        TableError: where it is not even known which models there are, or which definitions.
    """
    letters, spoiled = _letters(files)
    let, given = (_formulas(files, field, spoiled) for field in ("let", "given"))
    models: dict[str, Model] = {}
    unreadable: dict[str, str] = {}
    for data in files:
        for name, table in model_tables(data).items():
            try:
                if name in models:
                    raise TableError(f"model {name}: two files declare one")  # noqa: TRY301 - told like the others
                models[name] = read_model(table, data)
            except TableError as error:
                unreadable[name] = str(error)
    own = [one for model in models.values() for one in quantities_of(model)]
    world = World(letters=letters, let=let, given=given, unreadable=unreadable, spoiled=spoiled).having(own)
    return with_definitions(world, [table for data in files for table in definition_tables(data)])


def _letters(files: Iterable[Mapping[str, Any]]) -> tuple[dict[str, Variable], dict[str, str]]:
    """The symbols that can be read, and what is wrong with the others."""
    found: dict[str, Variable] = {}
    spoiled: dict[str, str] = {}
    for data in files:
        for name, table in _table(data, "symbols").items():
            try:
                found[name] = read_symbol(name, table, deviation_of=_measured(name, table))
            except TableError as error:
                spoiled[name] = str(error)
    return found, spoiled


def _measured(name: str, table: object) -> Variable | None:
    """What a symbol that is named as a deviation is the deviation of, in the unit that it has itself."""
    if not name.startswith(DEVIATION) or not isinstance(table, Mapping):
        return None
    return read_symbol(name.removeprefix(DEVIATION).strip("_") or "error", {"unit": table.get("unit")})


def _formulas(files: Iterable[Mapping[str, Any]], field: str, spoiled: dict[str, str]) -> dict[str, str]:
    """A table of formulas as text; one that is none is added to what is wrong."""
    found: dict[str, str] = {}
    for data in files:
        for name, value in _table(data, field).items():
            if isinstance(value, bool) or not isinstance(value, str | int | float):
                spoiled[name] = f"{field}.{shown_name(name)} must be a formula in quotes, given {shown(value)}"
            else:
                found[name] = str(value)
    return plain_formulas(found)


def _table(data: Mapping[str, Any], field: str) -> Mapping[str, Any]:
    table = data.get(field, {})
    if not isinstance(table, Mapping):
        raise TableError(f"{field} must be one table, begun by [{field}]; given {shown(table)}")
    if len(table) > MOST:
        raise TableError(f"{field} has at most {MOST} entries, given {len(table)}")
    return table


def having_models(models: Iterable[Model], world: World = CATALOGUE) -> World:
    """A world, and the quantities of models of one's own.

    Raises:
        TableError: for a model with a name of the catalogue's, and two of one name.
    """
    by_name: dict[str, Model] = {}
    for model in models:
        require_own_name(model)
        if model.name in by_name:
            raise TableError(f"model {model.name}: name occurs twice; every model has a name of its own")
        by_name[model.name] = model
    return world.having(one for model in by_name.values() for one in quantities_of(model))
