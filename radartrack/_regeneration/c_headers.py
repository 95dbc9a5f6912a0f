"""The derivations as C99 headers, with what others need to build with them."""

from __future__ import annotations

import importlib.metadata
from collections.abc import Mapping
from dataclasses import dataclass

from radartrack._regeneration.accuracy import RECORD, Record, record_text
from radartrack._regeneration.deriving import NotDerived, Step, Writer, worked_out
from radartrack._regeneration.output_directory import Files
from radartrack._system import written_files
from radartrack.derive.language.quantity import Quantity
from radartrack.derive.stable.quantity_form import form_of
from radartrack.derive.writing.c99 import c_elementary, c_header, c_package
from radartrack.derive.writing.c99.c_function import CFunction, of_quantity
from radartrack.derive.writing.c99.c_header import ConversionInC, QuantityInC
from radartrack.derive.writing.conversion_functions import conversions_of
from radartrack.derive.writing.expression_code import NotWritable
from radartrack.derive.writing.numpy_writer import Function, body

PACKAGE = frozenset({"CMakeLists.txt", "radartrack.pc"})
EXAMPLE = "example.c"


@dataclass(frozen=True)
class CDerivation:
    """All that is written."""

    quantities: list[QuantityInC]
    conversions: list[ConversionInC]

    @property
    def functions(self) -> list[Function]:
        """The same statements for NumPy, by whose digests errors are recorded."""
        return [one.numpy for one in self.quantities]


def derive(quantities: Mapping[str, Quantity], step: Step) -> CDerivation:
    """The code of all quantities and their conversions; `step` is told each name as its turn comes."""
    done = worked_out(quantities, step, Writer(written, c_header.conversion_in_c))
    found = [one for one in done.values() if isinstance(one, ConversionInC)]
    in_c = [
        QuantityInC(quantity, Function(quantity, done[name][0]), done[name][1]) for name, quantity in quantities.items()
    ]
    return CDerivation(in_c, found)


def written(quantity: Quantity) -> tuple[str, CFunction]:
    """The statements of one quantity for NumPy, and the function in C: what a process can send."""
    form = form_of(quantity)
    return body(quantity, form), of_quantity(quantity, form)


def names(quantities: Mapping[str, Quantity]) -> set[str]:
    """Of the files that are written for quantities, before anything is derived."""
    conversions = conversions_of(quantities)
    families = {quantity.module for quantity in quantities.values()} | (
        {c_header.CONVERSIONS} if conversions else set()
    )
    example = {EXAMPLE} if ("polar", "unbiased") in conversions else set()
    fixed = {c_header.ALL, c_elementary.NAME, RECORD, written_files.RECORD}
    return fixed | PACKAGE | example | {c_header.header_name(family) for family in families}


def texts(derivation: CDerivation, record: Record) -> Files:
    """The headers, the files beside them, and the records of what was measured and written.

    Raises:
        NotDerived: two functions would have one name.
    """
    accuracy = {name: [one.in_double, one.in_single] for name, one in record.items()}
    try:
        files = c_header.headers(derivation.quantities, derivation.conversions, accuracy)
    except NotWritable as error:
        raise NotDerived(str(error)) from None
    every = [one.written for one in derivation.quantities] + [one.written for one in derivation.conversions]
    defined = frozenset(name for one in every for name in one.names)
    files |= c_package.package(own_version(), defined)
    files[RECORD] = record_text(record)
    return files | {written_files.RECORD: written_files.record(files)}


def own_version() -> str:
    """Of the installed package."""
    try:
        return importlib.metadata.version("radartrack")
    except importlib.metadata.PackageNotFoundError:
        return "0"
