"""The world that the tables of files declare."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

from radartrack.derive.checking.question.world import CATALOGUE, World
from radartrack.derive.language.model import Model
from radartrack.derive.moments.conversion_quantities import quantities_of
from radartrack.derive.reading.model_table import model_tables, read_model, require_own_name
from radartrack.derive.reading.symbol_table import TableError


def world_of(files: Iterable[Mapping[str, Any]]) -> World:
    """What files declare together; a model that cannot be read spoils only what is asked of it.

    Args:
        files: the data of each, as TOML gives it.

    Raises:
        TableError: where it is not even known which models there are.
    """
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
    return World(unreadable=unreadable).having(one for model in models.values() for one in quantities_of(model))


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
