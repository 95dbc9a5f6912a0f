"""The derivations as the generated package: NumPy modules, and the formula book."""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Any

from radartrack._regeneration.accuracy import RECORD, Record, record_text, with_proofs
from radartrack._regeneration.deriving import Step, Writer, worked_out
from radartrack._regeneration.output_directory import BOOK, Files
from radartrack._system import written_files
from radartrack.derive.catalogue import catalogue
from radartrack.derive.finding import screening_values
from radartrack.derive.language.quantity import Quantity
from radartrack.derive.stable.quantity_form import form_of
from radartrack.derive.writing import elementary_functions
from radartrack.derive.writing.conversion_functions import (
    ARRAYS,
    LOOPS,
    ConversionCode,
    conversion_code,
    conversions_of,
)
from radartrack.derive.writing.conversion_functions import module_text as conversion_code_text
from radartrack.derive.writing.formula_book import Page, book, formula
from radartrack.derive.writing.numpy_writer import Function, body, module_text

PACKAGE = '"""NumPy functions written from the derivations; see the docstring of each for source and accuracy."""\n'
SCREENING = "screening.json"
Written = tuple[str, str, dict[str, Any]]  # statements, formula, and values to screen formulas by


@dataclass(frozen=True)
class Derived:
    """A quantity as code, as a formula to read, and as values."""

    function: Function
    formula: str
    values: Mapping[str, Any]


@dataclass(frozen=True)
class Derivation:
    """All that is written: the quantities, and the conversions that join some of them."""

    quantities: list[Derived]
    conversions: list[ConversionCode]

    @property
    def functions(self) -> list[Function]:
        """Those of the quantities."""
        return [derived.function for derived in self.quantities]


def derive(quantities: Mapping[str, Quantity], step: Step) -> Derivation:
    """The code and formula of all quantities, and their conversions; `step` is told each name as its turn comes."""
    done = worked_out(quantities, step, Writer(written, conversion_code))
    derived = []
    for name, quantity in quantities.items():
        statements, typeset, values = done[name]
        derived.append(Derived(Function(quantity, statements), typeset, values))
    return Derivation(derived, [code for code in done.values() if isinstance(code, ConversionCode)])


def written(quantity: Quantity) -> Written:
    """The statements, the typeset formula and the values of one quantity."""
    form = form_of(quantity)
    values = screening_values.row(quantity) if catalogue().get(quantity.name) is quantity else {}
    return body(quantity, form), formula(quantity, form), values


def names(quantities: Mapping[str, Quantity]) -> set[str]:
    """Of the files that are written for quantities; as in `texts`, before anything is derived."""
    conversions = {"conversions.py", "loops.py"} if conversions_of(quantities) else set()
    modules = {f"{quantity.module}.py" for quantity in quantities.values()}
    of_catalogue = {SCREENING, elementary_functions.NAME} if quantities.keys() == catalogue().keys() else set()
    return {"__init__.py", "py.typed", RECORD, BOOK, written_files.RECORD} | modules | conversions | of_catalogue


def texts(derivation: Derivation, record: Record) -> Files:
    """The files of the generated package, the formula book, of the catalogue its values, and the record of them all."""
    proved = with_proofs(derivation.functions, record)
    pages = [
        Page(derived.function.quantity, derived.formula, proved[derived.function.quantity.name].sentence)
        for derived in derivation.quantities
    ]
    files = {
        "__init__.py": PACKAGE,
        "py.typed": "",
        RECORD: record_text(record),
        BOOK: book(pages),
        **modules_of(derivation.functions, proved),
    }
    if record.keys() == catalogue().keys():
        files[SCREENING] = _screening(derivation.quantities)
    if derivation.conversions:
        files["conversions.py"] = conversion_code_text(derivation.conversions, ARRAYS)
        files["loops.py"] = conversion_code_text(derivation.conversions, LOOPS)
    if SCREENING in files:
        files[elementary_functions.NAME] = elementary_functions.module_text()
    return files | {written_files.RECORD: written_files.record(files)}


def _screening(quantities: Iterable[Derived]) -> str:
    """The values of all quantities, a line each."""
    rows = [f"{json.dumps(one.function.quantity.name)}: {json.dumps(one.values)}" for one in quantities]
    return "{\n" + ",\n".join(rows) + "\n}\n"


def modules_of(functions: Iterable[Function], record: Record) -> Files:
    by_module: dict[str, list[Function]] = {}
    for function in functions:
        by_module.setdefault(function.quantity.module, []).append(function)
    sentences = {name: accuracy.sentence for name, accuracy in record.items()}
    return {f"{name}.py": module_text(_title(name), group, sentences) for name, group in by_module.items()}


def _title(module: str) -> str:
    return f"NumPy functions of the quantities {module}.*"
