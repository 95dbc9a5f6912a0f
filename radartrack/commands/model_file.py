"""`--model FILE`: models of one's own, from TOML, which is data, or from the user's own Python file, which is run."""

from __future__ import annotations

import importlib.util
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from radartrack._system import terminal

if TYPE_CHECKING:
    from radartrack.derive.language.model import Model
    from radartrack.derive.language.quantity import Quantity

ModelFile = Annotated[
    Path | None,
    typer.Option(
        "--model", help="Models of your own: TOML with tables named model, or a Python file that defines MODEL."
    ),
]
PYTHON = ".py"


class NoModel(ValueError):
    """A file does not define a model."""


def load_models(path: Path) -> list[Model]:
    """The models of a TOML file, or the `MODEL` of a user's own Python file, which is run.

    Raises:
        NoModel: when the file is missing, cannot be read or fails to run, or defines no model.
    """
    from radartrack.derive.reading.model_table import read_models
    from radartrack.derive.reading.symbol_table import TableError

    if path.suffix == PYTHON:
        return [_run(path)]
    try:
        return read_models(_data(path))
    except TableError as error:
        raise NoModel(f"{path}: {terminal.one_line(str(error))}") from None


def own_quantities(path: Path | None) -> dict[str, Quantity]:
    """The quantities of the models of a file, by name; none without a file.

    Raises:
        typer.Exit: when there is no model in it, which is told.
    """
    from radartrack.derive.moments.conversion_quantities import quantities_of

    try:
        models = load_models(path) if path is not None else []
    except NoModel as error:
        terminal.complain(str(error))
        raise typer.Exit(2) from None
    return {quantity.name: quantity for model in models for quantity in quantities_of(model)}


def all_quantities(path: Path | None) -> dict[str, Quantity]:
    """Those of a file, then the catalogue."""
    from radartrack.derive.catalogue import catalogue

    return {**own_quantities(path), **catalogue()}


def declared(path: Path | None) -> tuple[Mapping[str, Any], ...]:
    """What a file declares, as data for the processes that check; of TOML nothing is worked out here.

    Raises:
        typer.Exit: when there is no model in it, which is told.
    """
    if path is None:
        return ()
    try:
        if path.suffix != PYTHON:
            return (_data(path),)
        from radartrack.derive.reading.model_table import data_of

        return (data_of(_run(path)),)
    except NoModel as error:
        terminal.complain(str(error))
        raise typer.Exit(2) from None


def _data(path: Path) -> dict[str, Any]:
    from radartrack.derive.checking.papers.claim import ClaimsError
    from radartrack.derive.checking.papers.claims_file import declarations, read_toml

    try:
        data = declarations(read_toml(path))
    except ClaimsError as error:
        raise NoModel(str(error)) from None
    if "model" not in data:
        raise NoModel(f"--model must be a file with [[model]], or a Python file (.py); {path} has no model")
    return data


def _run(path: Path) -> Model:
    from radartrack.derive.evaluation.real_outputs import require_real
    from radartrack.derive.language.model import Model
    from radartrack.derive.reading.model_table import require_own_name

    spec = importlib.util.spec_from_file_location(path.stem, path)
    if spec is None or spec.loader is None or not path.is_file():
        raise NoModel(f"--model must be a file; {path} is none")
    module = importlib.util.module_from_spec(spec)
    try:
        spec.loader.exec_module(module)
        model = getattr(module, "MODEL", None)
    except (Exception, SystemExit) as error:
        raise NoModel(f"{path} does not run: {type(error).__name__}: {terminal.one_line(str(error))}") from error
    if not isinstance(model, Model):
        shown = terminal.one_line(repr(model))
        raise NoModel(f"{path} must define MODEL = radartrack.derive.Model(...); MODEL is {shown}")
    try:
        require_own_name(model)
        require_real(model.outputs.items(), model.arguments, model.measured)
    except ValueError as error:
        raise NoModel(f"{path}: {error}") from error
    return model
