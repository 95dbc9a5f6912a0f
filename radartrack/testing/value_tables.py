"""Points for another language to compute values at, and a table of its values as a function."""

from __future__ import annotations

import csv
import io
import math
from collections.abc import Callable, Iterator, Sequence

import numpy as np
import numpy.typing as npt

from radartrack.testing.called_function import NotKnown
from radartrack.testing.examination import CONFIRMING, DOMAIN, FEW, SCREENING, CannotDiagnose
from radartrack.testing.function_conventions import argument_changes
from radartrack.testing.wanted import Wanted

CLOSE = 1e-9  # of an argument that another program has written again
MOST = 50_000_000  # characters of a table

Row = tuple[float, ...]


def points_table(wanted: Wanted) -> str:
    """All points at which a function is called, as comma-separated values under the names of the symbols."""
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow([symbol.name for symbol in wanted.symbols])
    writer.writerows([repr(value) for value in row] for row in _rows(wanted))
    return text.getvalue()


def tabulated(wanted: Wanted, text: str) -> Callable[..., npt.NDArray[np.float64]]:
    """A table as a function of the symbols, in their order.

    Args:
        wanted: for which the points were written.
        text: comma-separated values: a line of names, then a line a point, in the order in which they were written.
            The columns that are called as symbols are compared with the points; the others are the entries, row by
            row.

    Raises:
        CannotDiagnose: it is no such table.
    """
    if len(text) > MOST:
        raise CannotDiagnose(f"a table may have {MOST} characters, not {len(text)}")
    names, *lines = [line for line in csv.reader(io.StringIO(text.removeprefix("\ufeff"))) if line] or [[]]
    names = [name.strip() for name in names]
    rows = list(_rows(wanted))
    if len(lines) != len(rows):
        raise CannotDiagnose(f"the table has {len(lines)} lines of values; {wanted.name} has {len(rows)} points")
    own = [symbol.name for symbol in wanted.symbols]
    entries = [place for place, name in enumerate(names) if name not in own]
    if len(entries) != len(wanted.places):
        raise CannotDiagnose(
            f"beside {', '.join(own)} the table has {len(entries)} columns; "
            f"{wanted.name} has {len(wanted.places)} entries"
        )
    given = {name: names.index(name) for name in own if name in names}
    known: dict[Row, npt.NDArray[np.float64]] = {}
    for number, (line, row) in enumerate(zip(lines, rows, strict=True), start=2):
        if len(line) != len(names):
            raise CannotDiagnose(
                f"line {number} of the table has {len(line)} values; the first line has {len(names)} names"
            )
        values = [_number(cell, number) for cell in line]
        for symbol, value in zip(own, row, strict=True):
            if symbol in given and not math.isclose(values[given[symbol]], value, rel_tol=CLOSE, abs_tol=1e-300):
                raise CannotDiagnose(
                    f"line {number} of the table is at {symbol} = {values[given[symbol]]!r}; that point has {value!r}"
                )
        known[row] = np.array([values[place] for place in entries]).reshape(wanted.shape)

    def look_up(*arguments: float) -> npt.NDArray[np.float64]:
        if tuple(arguments) not in known:
            raise NotKnown
        return known[tuple(arguments)]

    look_up.is_table = True  # type: ignore[attr-defined]
    return look_up


def _rows(wanted: Wanted) -> Iterator[Row]:
    """Each point once, in the order of the symbols."""
    return iter(dict.fromkeys(_all(wanted)))


def _all(wanted: Wanted) -> Iterator[Row]:
    names = [symbol.name for symbol in wanted.symbols]
    few = wanted.ordinary(FEW)
    for expected in (wanted.ordinary(SCREENING), wanted.coarse(CONFIRMING), wanted.domain(DOMAIN)):
        for place in range(expected.count):
            yield _row(names, expected.point(place))
    for change in argument_changes(wanted.symbols):
        for place in range(few.count):
            point = few.point(place)
            yield _row(names, point | {name: change.changes[name](point[name]) for name in change.changes})


def _row(names: Sequence[str], point: dict[str, float]) -> Row:
    return tuple(float(point[name]) for name in names)


def _number(cell: str, line: int) -> float:
    """A number; an empty cell, or one that says that there is none, is no number, as other languages write it."""
    text = cell.strip().replace("D", "e")
    try:
        return float(text or "nan")
    except ValueError:
        if text.startswith("#") or text.lower() in {"na", "missing", "null"}:
            return math.nan
        raise CannotDiagnose(f"line {line} of the table: {cell!r} is no number") from None
