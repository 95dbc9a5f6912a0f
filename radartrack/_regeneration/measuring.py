"""The errors of generated functions, measured where no record knows them."""

from __future__ import annotations

import importlib.util
import math
import tempfile
from collections.abc import Iterable, Sequence
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np

from radartrack._regeneration import accuracy
from radartrack._regeneration.accuracy import Accuracy, Record, as_recorded
from radartrack._regeneration.deriving import NotDerived, Step, on_one_line
from radartrack._regeneration.numpy_modules import modules_of
from radartrack._regeneration.output_directory import Files
from radartrack._regeneration.single_precision import error_in_single
from radartrack.derive.language.quantity import Quantity
from radartrack.derive.writing.numpy_writer import Function
from radartrack.verification.domain_points import sample
from radartrack.verification.error_in_ulp import errors


def with_measured(functions: Iterable[Function], known: Sequence[Record], step: Step) -> Record:
    """The same with the missing measurements made.

    Raises:
        NotDerived: the formula cannot be evaluated over its domain.
    """
    by_name = {function.quantity.name: function for function in functions}
    record = as_recorded(by_name.values(), known)
    missing = [by_name[name] for name, known_of in record.items() if not known_of.is_complete]
    with tempfile.TemporaryDirectory() as folder:
        modules = _load(modules_of(missing, record), Path(folder))
        for function in missing:
            quantity = function.quantity
            step(f"{quantity.name}: measuring")
            try:
                record[quantity.name] = measured(modules[quantity.module], function, record[quantity.name])
            except (ArithmeticError, TypeError, ValueError) as error:
                raise NotDerived(f"{quantity.name} cannot be measured: {on_one_line(error)}") from error
    return record


def measured(module: ModuleType, function: Function, known: Accuracy) -> Accuracy:
    """What is known of a function with what is missing."""
    quantity = function.quantity
    ulp = measure(module, quantity) if math.isnan(known.ulp) else known.ulp
    single, points = error_in_single(getattr(module, quantity.function), quantity, sample(quantity, accuracy.POINTS))
    everywhere = points if quantity.symbols else accuracy.POINTS * points
    return Accuracy(function.digest, ulp, _rounded_up(single) if points else math.nan, everywhere)


def measure(module: ModuleType, quantity: Quantity) -> float:
    """The largest error over random points, rounded up to half an ulp."""
    with np.errstate(all="ignore"):  # what overflows is an infinite error
        found = errors(getattr(module, quantity.function), quantity, sample(quantity, accuracy.POINTS)).max()
    return _rounded_up(found)


def _rounded_up(ulp: float) -> float:
    """To half an ulp; what is no number is infinitely wrong."""
    return math.ceil(2 * ulp) / 2 if math.isfinite(ulp) else math.inf


def _load(files: Files, folder: Path) -> dict[str, ModuleType]:
    modules: dict[str, ModuleType] = {}
    for name, text in files.items():
        path = folder / name
        path.write_bytes(text.encode())
        spec = importlib.util.spec_from_file_location(f"_measured_{path.stem}", path)
        modules[path.stem] = _executed(spec)
    return modules


def _executed(spec: Any) -> ModuleType:
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module
