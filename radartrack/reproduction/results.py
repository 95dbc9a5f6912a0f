"""What a reproduction of a paper gives: tables, and findings that stand beside the paper's own numbers."""

from __future__ import annotations

import csv
import io
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Literal, TypeAlias

import numpy as np

from radartrack._arrays.repeated_trials import Estimate
from radartrack._arrays.validation import RealArray

Verdict: TypeAlias = Literal["agrees", "differs", "depends"]
Cell: TypeAlias = str | int | float
Step: TypeAlias = Callable[[str], None]
"""Called with what is worked on next; experiments call it for each part, so that progress can be shown."""


@dataclass(frozen=True)
class Table:
    """Columns of one length, by name; the name says the unit."""

    columns: Mapping[str, Sequence[Cell]]

    def __post_init__(self) -> None:
        lengths = {name: len(column) for name, column in self.columns.items()}
        if len(set(lengths.values())) > 1:
            raise ValueError(f"columns must have one length; got {lengths}")

    def rows(self) -> Iterator[tuple[Cell, ...]]:
        """Row by row."""
        return zip(*self.columns.values(), strict=True)

    def records(self) -> Iterator[dict[str, Cell]]:
        """Row by row, each by the names of the columns."""
        return (dict(zip(self.columns, row, strict=True)) for row in self.rows())

    def column(self, name: str) -> RealArray:
        """A column of numbers as an array."""
        return np.asarray(self.columns[name], dtype=np.float64)

    def where(self, **wanted: Cell) -> Table:
        """The rows in which columns have these values."""
        chosen = [
            place
            for place in range(len(next(iter(self.columns.values()))))
            if all(self.columns[name][place] == value for name, value in wanted.items())
        ]
        return Table({name: [column[place] for place in chosen] for name, column in self.columns.items()})

    def csv(self) -> str:
        """The table as CSV; numbers with six digits, nothing where there is none."""
        text = io.StringIO()
        writer = csv.writer(text, lineterminator="\n")
        writer.writerow(self.columns)
        writer.writerows([_text(cell) for cell in row] for row in self.rows())
        return text.getvalue()


@dataclass(frozen=True)
class Finding:
    """A number or a statement of a paper beside what the experiment gives.

    Attributes:
        what: which quantity, under which conditions.
        printed: what the paper says of it.
        ours: what the experiment gives, with its unit.
        interval: in the same unit, of 95 % confidence if the remark says nothing else; empty for what has no
            sampling error.
        verdict: whether both agree; "depends" where the paper does not say what would decide it.
        remark: what there is to say about it.

    """

    what: str
    printed: str
    ours: str
    interval: str
    verdict: Verdict
    remark: str = ""


@dataclass(frozen=True)
class Reproduction:
    """One paper: its name, its tables by name, and what was found.

    Attributes:
        paper: its short name.
        title: the heading.
        tables: the data, by name.
        findings: the paper's numbers beside ours.
        found: what was found, in a sentence or two.
        shown_by: the name of the figure that shows it.

    """

    paper: str
    title: str
    tables: Mapping[str, Table]
    findings: tuple[Finding, ...]
    found: str = ""
    shown_by: str = ""

    def findings_table(self) -> Table:
        """The findings as columns."""
        names = ("what", "printed", "ours", "interval", "verdict", "remark")
        return Table({name: [getattr(finding, name) for finding in self.findings] for name in names})


def table(rows: Sequence[Mapping[str, Cell]]) -> Table:
    """A table from rows that all have the same keys."""
    return Table({name: [row[name] for row in rows] for name in rows[0]})


def columns(name: str, estimate: Estimate, place: Any = (), scale: float = 1.0) -> dict[str, Cell]:
    """One entry of an estimate as three columns: the value, and the ends of its interval."""
    suffixes = ("", "_lower", "_upper")
    return {f"{name}{suffix}": scale * float(part[place]) for suffix, part in zip(suffixes, estimate, strict=True)}


def interval(estimate: Estimate, place: Any = (), scale: float = 1.0, digits: int = 1) -> str:
    """The interval of one entry of an estimate, as it is read."""
    lower, upper = sorted(scale * float(end[place]) for end in (estimate.lower, estimate.upper))
    return f"[{number(lower, digits)}, {number(upper, digits)}]"


def number(value: float, digits: int = 1) -> str:
    """A number with so many decimals and a real minus sign; no minus before zero."""
    return f"{round(value, digits) + 0.0:.{digits}f}".replace("-", "−")


def _text(cell: Cell) -> str:
    if isinstance(cell, float):
        return "" if np.isnan(cell) else f"{cell:.6g}"
    return str(cell)


def silent(_: str) -> None:
    """A step that nobody watches."""
