"""Points for another language to compute values at, and a table of its values as a function."""

from __future__ import annotations

import csv
import io
import math
import re
from collections.abc import Callable, Iterator, Sequence

import numpy as np
import numpy.typing as npt

from radartrack.testing.calling.called_function import NotKnown, Precision
from radartrack.testing.examination import CONFIRMING, DOMAIN, FEW, SCREENING
from radartrack.testing.function_conventions import argument_changes
from radartrack.testing.reading import CannotDiagnose
from radartrack.testing.wanted import Wanted

CLOSE = 1e-9  # of an argument that another program has written again
FEWEST = 0.5  # of the points, which a table must have
WRITTEN = re.compile(r"[-+]?\d*(?:\.(?P<decimals>\d*))?(?:[eEdD](?P<power>[-+]?\d+))?")
DIGITS_OF_SINGLE = 7
MOST = 50_000_000  # characters of a table

Row = tuple[float, ...]


def points_table(wanted: Wanted) -> str:
    """All points at which a function is called, as comma-separated values under the names of the symbols."""
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow([symbol.name for symbol in wanted.symbols])
    writer.writerows([repr(value) for value in row] for row in _rows(wanted))
    return text.getvalue()


def tabulated(wanted: Wanted, text: str) -> Callable[..., npt.NDArray[np.floating]]:
    """A table as a function of the symbols, in their order.

    Args:
        wanted: for which the points were written.
        text: a line of names, then a line a point, in the order in which they were written; separated by commas, by
            semicolons (then numbers may have decimal commas) or tabulators. The columns that are called as symbols are
            compared with the points, and where they are there, lines may be missing; the others are the entries, row
            by row, or those of one triangle of a covariance.

    Raises:
        CannotDiagnose: it is no such table.
    """
    if len(text) > MOST:
        raise CannotDiagnose(f"a table may have {MOST} characters, not {len(text)}")
    names, lines = _columns(text)
    own = [symbol.name for symbol in wanted.symbols]
    entries = [place for place, name in enumerate(names) if name not in own]
    if lines and len(entries) not in _sizes(wanted):
        raise CannotDiagnose(
            f"beside {', '.join(own)} the table has {len(entries)} columns; "
            f"{wanted.name} has {len(wanted.places)} entries"
        )
    given = {name: names.index(name) for name in own if name in names}
    placed = list(_placed(list(_rows(wanted)), lines, own, given, wanted))
    shape = wanted.shape if len(entries) == len(wanted.places) else (len(entries),)
    values = [[_number(line[place], number) for place in entries] for _, line, number in placed]
    cells = [[line[place] for place in entries] for _, line, _ in placed]
    kind: type[np.floating] = np.float32 if _are_single(values, cells) else np.float64
    known: dict[Row, npt.NDArray[np.floating]] = {
        row: np.array(one).astype(kind).reshape(shape) for (row, *_), one in zip(placed, values, strict=True)
    }

    def look_up(*arguments: float) -> npt.NDArray[np.floating]:
        if tuple(arguments) not in known:
            raise NotKnown
        return known[tuple(arguments)]

    look_up.table = _precision(cells)  # type: ignore[attr-defined]
    return look_up


def _sizes(wanted: Wanted) -> set[int]:
    """How many columns of entries there may be: of a covariance one triangle says all."""
    rows = wanted.shape[0] if wanted.quantity.is_covariance and len(wanted.shape) == 2 else 0
    return {len(wanted.places), *([rows * (rows + 1) // 2] if rows else [])}


def _columns(text: str) -> tuple[list[str], list[list[str]]]:
    """The names, and the lines under them, without columns that have no name, such as one of line numbers."""
    text = text.removeprefix("\ufeff")
    heading = next(iter(text.splitlines()), "")
    separator = max((";", "\t", ","), key=heading.count)
    try:  # any ends of lines, as the old ones of a Macintosh
        lines = [*csv.reader(io.StringIO(text, newline=""), delimiter=separator)]
    except csv.Error as error:
        raise CannotDiagnose(f"it cannot be read as a table: {error}") from None
    rows = [line for line in lines if any(cell.strip() for cell in line)]
    names, *lines = rows or [[]]
    for number, line in enumerate(lines, start=2):
        if len(line) != len(names):
            raise CannotDiagnose(
                f"line {number} of the table has {len(line)} values; the first line has {len(names)} names"
            )
    kept = [place for place, name in enumerate(names) if name.strip()]
    if separator != ",":
        lines = [[cell.replace(",", ".") for cell in line] for line in lines]
    return [names[place].strip() for place in kept], [[line[place].strip() for place in kept] for line in lines]


def _placed(
    rows: Sequence[Row], lines: Sequence[list[str]], own: Sequence[str], given: dict[str, int], wanted: Wanted
) -> Iterator[tuple[Row, list[str], int]]:
    """Each line with its point and its number; lines may be missing where the points are in the table."""
    if len(lines) > len(rows) or len(lines) < (len(rows) if len(given) < len(own) else FEWEST * len(rows)):
        raise CannotDiagnose(f"the table has {len(lines)} lines of values; {wanted.name} has {len(rows)} points")
    left = iter(rows)
    spare = len(rows) - len(lines)
    for number, line in enumerate(lines, start=2):
        row = next(left)
        while spare and not _is_at(line, row, own, given):
            row, spare = next(left), spare - 1
        for symbol, value in zip(own, row, strict=True):
            if symbol in given and not _is_written(line[given[symbol]], value, number):
                raise CannotDiagnose(
                    f"line {number} of the table is at {symbol} = {line[given[symbol]]}; that point has {value!r}"
                )
        yield row, line, number


def _is_at(line: Sequence[str], row: Row, own: Sequence[str], given: dict[str, int]) -> bool:
    return all(_is_written(line[given[symbol]], value, 0) for symbol, value in zip(own, row, strict=True))


def _is_written(cell: str, value: float, number: int) -> bool:
    """Whether a value is what a program has written, with the digits that it has."""
    found = _number(cell, number)
    return math.isclose(found, value, rel_tol=CLOSE, abs_tol=max(1e-300, 1.01 * _half_unit(cell)))


def _half_unit(cell: str) -> float:
    """Half a unit of the last digit that is written."""
    match = WRITTEN.fullmatch(cell)
    if match is None:
        return 0.0
    return 0.5 * 10.0 ** (int(match["power"] or 0) - len(match["decimals"] or ""))


def _are_single(values: Sequence[Sequence[float]], cells: Sequence[Sequence[str]]) -> bool:
    """Whether all are numbers of single precision, written with more digits than it holds."""
    found = np.array(values, np.float64).ravel()
    written = [cell for line in cells for cell in line]
    with np.errstate(over="ignore", invalid="ignore"):
        away = np.abs(found - found.astype(np.float32))
    fitting = ~np.isfinite(found) | (away <= 1.01 * np.array([_half_unit(cell) for cell in written]))
    return bool(fitting.all()) and any(_digits(cell) > DIGITS_OF_SINGLE for cell in written)


def _precision(cells: Sequence[Sequence[str]]) -> Precision:
    """How exact the entries are written: with as many decimals all, or with as many digits as the longest has.

    Of a single number nothing follows: 0, 1.0 and 0.25 may be exact.
    """
    halves = {_half_unit(cell) for line in cells for cell in line if WRITTEN.fullmatch(cell)}
    if len(halves) == 1:
        (half,) = halves
        return Precision(max(half / _typical(column) for column in zip(*cells[:SCREENING], strict=True)), half)
    longest = max((_digits(cell) for line in cells[:SCREENING] for cell in line), default=0)
    return Precision(0.5 * 10.0 ** (1 - longest) if longest else 0.0, 0.0)


def _typical(column: Sequence[str]) -> float:
    """The size of a value of ordinary size."""
    sizes = (abs(_number(cell, 0)) for cell in column)
    return float(np.median([size for size in sizes if math.isfinite(size) and size] or [1.0]))


def _digits(cell: str) -> int:
    """How many digits a number is written with."""
    return len(re.split("[eEdD]", cell)[0].strip("+-").replace(".", "").lstrip("0"))


def _rows(wanted: Wanted) -> Iterator[Row]:
    """Each point once, in the order of the symbols."""
    return iter(dict.fromkeys(_all(wanted)))


def _all(wanted: Wanted) -> Iterator[Row]:
    names = [symbol.name for symbol in wanted.symbols]
    few = wanted.ordinary(FEW)
    for expected in (wanted.ordinary(SCREENING), few, wanted.coarse(CONFIRMING), wanted.domain(DOMAIN)):
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
