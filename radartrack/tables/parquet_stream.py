"""Parquet files of plots, converted in batches: memory does not grow with them."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Iterator
from concurrent.futures import Future, ThreadPoolExecutor
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass, field
from importlib import import_module
from itertools import islice
from pathlib import Path
from typing import Any

from radartrack._arrays.validation import RealArray
from radartrack.tables.plot_columns import Columns, PlotColumns

BATCH = 1 << 18  # rows: a row group of some 30 MB; fewer cost a Parquet reader time, more cost memory
BUFFER = 1 << 20  # bytes read at once of a column, however large the row groups of the file are
TOLD = 20  # bad rows that are remembered; all are counted, and marked in the file
AHEAD = 2  # batches that wait to be written


class NoPlots(ValueError):
    """A file is no table of plots."""


@dataclass
class Outcome:
    """What was done with a file.

    Attributes:
        rows: that were read and written.
        bad: of them, how many could not be converted and are marked.
        told: what is wrong with the first of those, by their numbers.
    """

    rows: int = 0
    bad: int = 0
    told: dict[int, str] = field(default_factory=dict)

    def add(self, rows: int, problems: dict[int, str]) -> None:
        """Count a batch, in which rows have numbers of its own."""
        for row, problem in islice(problems.items(), TOLD - len(self.told)):
            self.told[self.rows + row] = problem
        self.rows += rows
        self.bad += len(problems)


def rows_of(source: Path) -> int:
    """How many rows a file has, by what it says at its end.

    Raises:
        NoPlots: it is no Parquet file.
        OSError: it cannot be read.

    """
    with _opened(source) as file:
        return int(file.metadata.num_rows)


_NAMES = {"UNCOMPRESSED": "NONE"}  # what pyarrow reads of a file and how it wants to be told, where they differ


def convert_file(
    source: Path, target: Path, chosen: PlotColumns, step: Callable[[int], None] = lambda _: None
) -> Outcome:
    """Write what a file holds, and the new columns beside it, to another file.

    Reading, converting and writing go on at the same time. Columns that are kept are compressed as they were; the
    numbers of the new ones hold no pattern that a compression would find.

    Args:
        source: a Parquet file.
        target: the new one; what is written when this fails is not complete.
        chosen: where the arguments are found.
        step: is told of rows that are done.

    Raises:
        BadRows: some rows cannot be converted, and are not to be marked; their numbers are those of the file.
        NoPlots: it is no Parquet file, is damaged, or has not the columns.
        OSError: a file cannot be read or written.

    """
    pa, pq = import_module("pyarrow"), import_module("pyarrow.parquet")
    outcome = Outcome()
    with ExitStack() as stack:
        file = stack.enter_context(_opened(source))
        with _reading(source):
            schema, options = _schema(file.schema_arrow, chosen, pa), _options(file, chosen)
        writer = stack.enter_context(pq.ParquetWriter(target, schema, **options))
        one = stack.enter_context(ThreadPoolExecutor(1, "radartrack-write"))
        waiting: deque[Future[None]] = deque()
        reader = stack.enter_context(ThreadPoolExecutor(1, "radartrack-read"))
        for batch in _ahead(file.iter_batches(BATCH), reader, source):
            with _reading(source):
                numbers = {column: _numbers(batch.column(column), pa) for column in chosen.needed.values()}
            found = chosen.converted(numbers, len(batch), outcome.rows)
            outcome.add(len(batch), found.problems)
            while len(waiting) >= AHEAD:
                waiting.popleft().result()
            waiting.append(one.submit(writer.write_table, _beside(batch, found, chosen, schema, pa)))
            step(len(batch))
        for written in waiting:
            written.result()
    return outcome


def _opened(source: Path) -> Any:
    pq = import_module("pyarrow.parquet")
    if source.exists() and not source.is_file():
        raise NoPlots(f"{source} must be a file: what a Parquet file holds stands at its end, which is read first")
    with _reading(source):  # what is read ahead is never let go; checksums are tried where the file has them
        return pq.ParquetFile(source, buffer_size=BUFFER, pre_buffer=False, page_checksum_verification=True)


@contextmanager
def _reading(source: Path) -> Iterator[None]:
    """Name the file that cannot be read: of a damaged one pyarrow raises whatever it stumbles over, without a name."""
    pa = import_module("pyarrow")
    try:
        yield
    except (pa.ArrowException, UnicodeDecodeError, OSError) as error:
        if getattr(error, "filename", None) is not None:
            raise
        raise NoPlots(f"{source} is no Parquet file that can be read: {error}") from None


def _schema(given: Any, chosen: PlotColumns, pa: Any) -> Any:
    """Of the new file.

    Raises:
        NoPlots: the columns are not there, are no numbers, or are there already.

    """
    try:
        chosen.require_room(given.names)
    except ValueError as error:
        raise NoPlots(str(error)) from None
    types = {name: _type_of_values(given.field(column).type, pa) for name, column in chosen.needed.items()}
    for name, kind in types.items():
        numeric = pa.types.is_integer(kind) or pa.types.is_floating(kind) or pa.types.is_decimal(kind)
        if not (numeric or pa.types.is_null(kind)):
            raise NoPlots(f"{name} must be a column of real numbers; {chosen.needed[name]!r} holds {kind}")
    number = pa.float32() if all(kind == pa.float32() for kind in types.values()) else pa.float64()
    for name in chosen.outputs:
        given = given.append(pa.field(name, number))
    return given.append(pa.field(chosen.problem, pa.string())) if chosen.mark else given


def _type_of_values(kind: Any, pa: Any) -> Any:
    """That of what a dictionary has, as pandas writes categories."""
    return kind.value_type if pa.types.is_dictionary(kind) else kind


def _options(file: Any, chosen: PlotColumns) -> dict[str, Any]:
    """How columns are written: those that are kept as they were."""
    group = file.metadata.row_group(0) if file.metadata.num_row_groups else None
    kept = [group.column(i) for i in range(group.num_columns)] if group is not None else []
    compression = {column.path_in_schema: _NAMES.get(column.compression, column.compression) for column in kept}
    # What was measured seldom repeats: a dictionary of it takes half of all the time, and is given up in the end.
    words = [column.path_in_schema for column in kept if _has_words(column)]
    new = dict.fromkeys(chosen.outputs, "NONE")
    if chosen.mark:
        words, new = [*words, chosen.problem], {**new, chosen.problem: "ZSTD"}
    return {
        "compression": {**compression, **new},
        "use_dictionary": words or False,
        "write_statistics": [*compression] or False,
    }


def _has_words(column: Any) -> bool:
    """Whether a column has a dictionary, and is none of floating-point numbers."""
    return column.physical_type not in {"FLOAT", "DOUBLE"} and any("DICTIONARY" in each for each in column.encodings)


def _numbers(column: Any, pa: Any) -> RealArray:
    """A column in float32 or float64, NaN where nothing is."""
    if pa.types.is_dictionary(column.type):
        column = column.dictionary_decode()
    kind = column.type if column.type == pa.float32() else pa.float64()
    numbers: RealArray = column.cast(kind, safe=False).to_numpy(zero_copy_only=False)  # large whole ones are rounded
    return numbers


def _beside(batch: Any, found: Columns, chosen: PlotColumns, schema: Any, pa: Any) -> Any:
    arrays = [*batch.columns, *(pa.array(values) for values in found.values.values())]
    if chosen.mark:
        arrays.append(pa.array([found.problems.get(row) for row in range(len(batch))], pa.string()))
    return pa.Table.from_arrays(arrays, schema=schema)


def _ahead(batches: Iterator[Any], reader: ThreadPoolExecutor, source: Path) -> Iterator[Any]:
    """The same, each read while what is before it is worked on."""
    coming = reader.submit(next, batches, None)
    while (batch := _result(coming, source)) is not None:
        coming = reader.submit(next, batches, None)
        yield batch


def _result(coming: Future[Any], source: Path) -> Any:
    with _reading(source):
        return coming.result()
