"""Models of one's own with the code that was written for them: data that a task takes along wherever it is done."""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping, Sequence
from contextlib import closing
from dataclasses import dataclass, replace
from functools import cached_property, lru_cache
from importlib.abc import InspectLoader
from importlib.util import module_from_spec, spec_from_loader
from types import ModuleType
from typing import Any

from radartrack.derive import catalogue
from radartrack.derive.language.model import Model
from radartrack.derive.language.quantity import Quantity
from radartrack.derive.moments.conversion_quantities import quantities_of
from radartrack.derive.reading.model_table import data_of, read_models
from radartrack.derive.stable.quantity_form import form_of
from radartrack.derive.writing.numpy_writer import Function, body, module_text
from radartrack.verification.engines import Engine

LOADED = 4  # sets of models that a process keeps


@dataclass(frozen=True)
class OwnModels:
    """Models as tables and their modules as text: equal content is one and the same to every process.

    Attributes:
        tables: of each model, as JSON.
        modules: by name of the model, what was written for it.
    """

    tables: tuple[str, ...] = ()
    modules: tuple[tuple[str, str], ...] = ()

    @property
    def quantities(self) -> Mapping[str, Quantity]:
        """Those of all the models, by name."""
        return _loaded(self).quantities

    def find(self, name: str) -> Quantity:
        """One of these, or of the catalogue.

        Raises:
            UnknownQuantity: when there is none.
        """
        return self.quantities[name] if name in self.quantities else catalogue.find(name)

    def function(self, quantity: Quantity) -> OwnFunction | None:
        """What was written for a quantity of one of the models; None for any other."""
        is_own = self.quantities.get(quantity.name) == quantity and quantity.module in dict(self.modules)
        return OwnFunction(dict(self.modules)[quantity.module], quantity.function) if is_own else None


NONE = OwnModels()


class NotWritten(ValueError):
    """A quantity of a model has no code: what it holds cannot be rewritten, proved or written."""


@dataclass(frozen=True)
class Writing:
    """A task: the statements of one quantity's function."""

    own: OwnModels
    name: str

    def __call__(self) -> str:
        """Derive and write it.

        Raises:
            NotWritten: saying of which quantity, and why.
        """
        quantity = self.own.find(self.name)
        try:
            return body(quantity, form_of(quantity))
        except (ArithmeticError, AssertionError, LookupError, RecursionError, TypeError, ValueError) as error:
            raise NotWritten(f"{self.name} cannot be derived: {error}") from None


def written(own: OwnModels, names: Sequence[str], engine: Engine, step: Callable[[str, int], None]) -> OwnModels:
    """The same models with the code of these of their quantities.

    Raises:
        NotWritten: for one that cannot be derived.
    """
    statements = {}
    with closing(engine.run(enumerate(Writing(own, name) for name in names))) as results:
        for number, text in results:
            statements[names[number]] = text
            step(f"{names[number]}: deriving", len(names))
    functions = [Function(own.quantities[name], statements[name]) for name in names]
    modules: dict[str, list[Function]] = {}
    for function in functions:
        modules.setdefault(function.quantity.module, []).append(function)
    unmeasured = dict.fromkeys(names, "not measured.")
    texts = {name: module_text(f"NumPy functions of {name}", group, unmeasured) for name, group in modules.items()}
    return replace(own, modules=tuple(texts.items()))


@dataclass(frozen=True)
class OwnFunction:
    """A generated function that other processes can be given, though they cannot import it.

    Attributes:
        module: the text that it stands in.
        name: of the function.
    """

    module: str
    name: str

    def __call__(self, *arguments: Any, **named: Any) -> Any:
        """As the function; an AttributeError where it is not in the text."""
        return getattr(_module(self.module), self.name)(*arguments, **named)


def tables_of(models: list[Model]) -> tuple[str, ...]:
    """Models as a task takes them along."""
    return tuple(json.dumps(data_of(model), sort_keys=False) for model in models)


class _Loaded:
    def __init__(self, own: OwnModels) -> None:
        self._tables = own.tables

    @cached_property
    def quantities(self) -> dict[str, Quantity]:
        models = [model for table in self._tables for model in read_models(json.loads(table))]
        return {quantity.name: quantity for model in models for quantity in quantities_of(model)}


@lru_cache(maxsize=LOADED)
def _loaded(own: OwnModels) -> _Loaded:
    return _Loaded(own)


class _OfText(InspectLoader):
    def __init__(self, text: str) -> None:
        self._text = text

    def get_source(self, fullname: str) -> str:
        """The text, whatever the module is called."""
        del fullname
        return self._text


@lru_cache(maxsize=LOADED * 8)
def _module(text: str) -> ModuleType:
    """What this package itself has written, as a module that stands nowhere."""
    spec = spec_from_loader("radartrack_own_model", _OfText(text))
    if spec is None or spec.loader is None:
        raise ImportError("what was written cannot be loaded")
    module = module_from_spec(spec)
    spec.loader.exec_module(module)
    return module
