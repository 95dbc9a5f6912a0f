"""What is known of the errors of generated functions: measured, proved, and kept in a record by their very code."""

from __future__ import annotations

import json
import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

from radartrack._regeneration.output_directory import package
from radartrack.derive.catalogue import catalogue
from radartrack.derive.language.quantity import Quantity
from radartrack.derive.writing.numpy_writer import Function, helpers
from radartrack.verification.rounding.certificates import code_of, proved_bounds
from radartrack.verification.rounding.certificates import kept as kept_certificates

RECORD = "accuracy.json"
POINTS = 500
PROVED_FOR = {
    "double": ", proved for elementary functions within 1 ulp (float64)",
    "independent": " with independent errors, proved for elementary functions within 1 ulp (float64)",
    "correlated": "with correlations up to 0.99 in size",
    "single": "in float32, with functions within 4 of its ulp,",
}


@dataclass(frozen=True)
class Accuracy:
    """What was measured of one function.

    Attributes:
        code: the digest of its code.
        ulp: the largest error in double precision.
        single: that in single precision, in ulp of that.
        single_points: at how many points that was: where nothing leaves the range of single precision.
        proved: bounds that certificates prove, in ulp, by what they are for, a key of `PROVED_FOR`.
    """

    code: str
    ulp: float
    single: float = math.nan
    single_points: int | None = None
    proved: Mapping[str, float] = field(default_factory=dict)

    @property
    def is_complete(self) -> bool:
        """Whether nothing is left to be measured."""
        return not math.isnan(self.ulp) and self.single_points is not None

    @property
    def sentence(self) -> str:
        """For the docstring: what is proved, else what was measured."""
        if not self.proved:
            return f"measured, not proved: {self.measured}" if not math.isnan(self.ulp) else self.measured
        said = [
            f"at most {bound:g} ulp anywhere in this domain{PROVED_FOR[kind]}"
            if kind in {"double", "independent"}
            else f"{PROVED_FOR[kind]} at most {bound:g}"
            for kind, bound in self.proved.items()
        ]
        return f"{'; '.join(said)}."

    @property
    def measured(self) -> str:
        """The error at points."""
        if math.isnan(self.ulp):
            return "not measured."
        return (
            f"at most {self.ulp:g} ulp from 50-digit arithmetic at {POINTS} points of this domain "
            "(float64, independent errors)."
        )

    @property
    def in_double(self) -> str:
        """For the comment in C."""
        return f"Accuracy in double: {self.measured.replace('float64', 'double, by the same statements in NumPy')}"

    @property
    def in_single(self) -> str:
        """For the comment in C."""
        if self.single_points is None:
            return "Accuracy in float: not measured."
        if not self.single_points:
            return "Accuracy in float: none; everywhere in this domain something leaves the range of float."
        where = "these points" if self.single_points >= POINTS else f"the {self.single_points} of these points"
        outside = "" if self.single_points >= POINTS else " at which nothing leaves the range of float"
        return f"Accuracy in float: at most {self.single:g} ulp of float at {where}{outside}."


Record = dict[str, Accuracy]  # by quantity


def read_record(directory: Path) -> Record:
    """The accuracy measured before, by quantity; empty where there is none or it cannot be read."""
    try:
        stored = json.loads((directory / RECORD).read_bytes())
        return {name: _accuracy(row) for name, row in stored.items()}
    except (OSError, ValueError, TypeError, KeyError, AttributeError):
        return {}


def _accuracy(row: Mapping[str, Any]) -> Accuracy:
    single = row.get("single")
    known = Accuracy(str(row["code"]), float(row["ulp"]))
    if single is None:
        return known
    return replace(
        known, single=math.nan if single["ulp"] is None else float(single["ulp"]), single_points=int(single["points"])
    )


def read_records(directory: Path, quantities: Mapping[str, Quantity]) -> list[Record]:
    """What is known of quantities: the record in the directory and, for the catalogue, the one in the package."""
    known = catalogue()
    shipped = read_record(package())
    same = {name: shipped[name] for name in quantities.keys() & shipped if quantities[name] is known.get(name)}
    return [read_record(directory), same]


def as_recorded(functions: Iterable[Function], records: Sequence[Record]) -> Record:
    """The accuracy of each function from the first record that knows its very code; else it is NaN, not measured."""
    return {function.quantity.name: _recorded(function, records) for function in functions}


def _recorded(function: Function, records: Sequence[Record]) -> Accuracy:
    known = (record.get(function.quantity.name) for record in records)
    fitting = (accuracy for accuracy in known if accuracy is not None and accuracy.code == function.digest)
    return next(fitting, Accuracy(function.digest, math.nan))


def with_proofs(functions: Iterable[Function], record: Record) -> Record:
    """The same with the bounds that certificates of the package prove of the very code, over the very domain."""
    rows, known = kept_certificates(), catalogue()
    found = dict(record)
    for function in functions:
        name, row = function.quantity.name, rows.get(function.quantity.name, {})
        if known.get(name) is function.quantity and row.get("code") == _code(function):
            found[name] = replace(record[name], proved=_said(function.quantity, proved_bounds(row)))
    return found


def _code(function: Function) -> str:
    text = function.text("")
    return code_of(helpers(text) + text, function.quantity.function)


def _said(quantity: Quantity, bounds: Mapping[str, float]) -> Mapping[str, float]:
    """The bounds of a docstring: none without one in double precision, which is not all where errors correlate."""
    if "double" not in bounds or not any(symbol.is_correlation for symbol in quantity.symbols):
        return bounds if "double" in bounds else {}
    return {"independent": bounds["double"]} | {kind: bound for kind, bound in bounds.items() if kind != "double"}


def record_text(record: Record) -> str:
    """The file of what was measured."""
    rows = {name: _row(accuracy) for name, accuracy in sorted(record.items())}
    return json.dumps(rows, indent=1) + "\n"


def _row(accuracy: Accuracy) -> dict[str, Any]:
    row: dict[str, Any] = {"code": accuracy.code, "ulp": accuracy.ulp}
    if accuracy.single_points is not None:
        ulp = None if math.isnan(accuracy.single) else accuracy.single
        row["single"] = {"ulp": ulp, "points": accuracy.single_points}
    return row
