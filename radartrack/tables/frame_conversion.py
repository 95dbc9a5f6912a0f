"""Tables in memory: pandas, polars, pyarrow and whatever else narwhals reads, and datasets of xarray."""

import math
import reprlib
import sys
from collections.abc import Iterable, Mapping, Sequence
from decimal import Decimal
from importlib import import_module
from importlib.util import find_spec
from typing import Any, TypeVar

import numpy as np

from radartrack._arrays.validation import RealArray
from radartrack._conversion.sensors import SENSORS, AzimuthFrom, SensorName
from radartrack.tables.bad_rows import BadRows
from radartrack.tables.plot_columns import BadRowsWord, Columns, Method, PlotColumns

Frame = TypeVar("Frame")

PACKED = {"scale_factor": 1, "add_offset": 0}  # attributes of netCDF, and what they are where they say nothing
MISSING = ("_FillValue", "missing_value")
LIBRARIES = "a table of pandas, polars, pyarrow or another library that narwhals reads, or a Dataset of xarray"


def convert(
    frame: Frame,
    sensor: SensorName = "polar",
    columns: Mapping[str, str | float] | None = None,
    units: Mapping[str, str] | None = None,
    *,
    method: Method = "unbiased",
    azimuth_from: AzimuthFrom | None = None,
    bad_rows: BadRowsWord = "raise",
    prefix: str = "",
) -> Frame:
    """Convert each row of a table of plots to a Cartesian mean and the covariance of its errors.

    Args:
        frame: a table in memory of pandas, polars, pyarrow or another library that narwhals reads; or a Dataset of
            xarray, whose variables may have any dimensions and are broadcast.
        sensor: the name of a conversion of `rt.convert`.
        columns: for arguments of the conversion, by name, the name of a column, or one number for all rows. An
            argument that is left out has the column of its own name; `correlation` is 0 then.
        units: for arguments, by name, the unit of their numbers as pint reads it: "deg", "km", "nautical_mile",
            "knot", "km/h". Without one they are in metres, radians and metres a second; a variable of xarray has the
            unit that its attribute `units` says.
        method: which mean and covariance, as for `rt.convert.polar`; "decorrelated" needs predictions and is not here.
        azimuth_from: as the conversion takes it; None for its default. "ruv" has none.
        bad_rows: "raise", so that a row that cannot be converted is an error that has their numbers; or "mark", so
            that all rows are kept, those have NaN, and a column `problem` says what is wrong with them.
        prefix: before the names of the new columns.

    Returns:
        A table of the same library: the columns given, then the components of the mean, `x`, `y` [m] and where the
        conversion has them `z` [m] and `eta` [m^2/s], then the covariances `cov_x_x`, `cov_x_y`, … [their units]. They
        are float32 where every column that is read is, and float64 otherwise.

    Raises:
        ImportError: narwhals is not there, or pint is not and units are given.
        BadRows: some rows cannot be converted and are not to be marked; a ValueError.
        TypeError: what is given is no such table, or a column holds no real numbers.
        ValueError: a word is unknown, a column is missing or would be added twice, or a unit is one of something else.

    """
    xarray = sys.modules.get("xarray")  # who has a Dataset has loaded it
    if xarray is not None and isinstance(frame, xarray.Dataset):
        units = {**_units_of(frame, columns or {}, sensor), **(units or {})}
        chosen = PlotColumns.chosen(sensor, columns, units, method, azimuth_from, bad_rows, prefix)
        dataset: Frame = _of_dataset(frame, chosen, xarray)
        return dataset
    chosen = PlotColumns.chosen(sensor, columns, units, method, azimuth_from, bad_rows, prefix)
    return _of_table(frame, chosen)


def _of_table(frame: Frame, chosen: PlotColumns) -> Frame:
    if find_spec("narwhals") is None:
        raise ImportError("tables need the extra: pip install radartrack[tables]")
    nw = import_module("narwhals")
    try:
        table = nw.from_native(frame)
    except TypeError:
        raise TypeError(f"frame must be {LIBRARIES}; got {reprlib.repr(type(frame).__name__)}") from None
    except nw.exceptions.DuplicateError:
        raise ValueError("the columns of the table must have different names; some have the same") from None
    if not isinstance(table, nw.DataFrame):
        how = "collect it first, or convert files with `radartrack convert`, which streams them"
        raise TypeError(
            f"frame must be a table in memory; got {type(frame).__name__}, which is not computed yet: {how}"
        )
    chosen.require_room(table.columns)
    numbers = {column: _numbers(table[column], nw, name) for name, column in chosen.needed.items()}
    try:
        found = chosen.converted(numbers, len(table))
    except BadRows as error:
        raise _labelled(error, nw.maybe_get_index(table)) from None
    converted: Frame = _with_columns(table, found, chosen, nw)
    return converted


def _numbers(series: Any, nw: Any, argument: str) -> RealArray:
    """A column in float32 or float64, NaN where nothing is."""
    if not series.dtype.is_numeric():
        return _unpacked(series, nw, argument)
    dtype = np.float32 if series.dtype == nw.Float32 else np.float64
    try:
        wide = series.cast(nw.Float32 if dtype is np.float32 else nw.Float64)
    except ValueError:  # of pyarrow, which rounds no whole number
        return _rounded(series.to_list(), series.is_null())
    return np.asarray(wide.to_numpy(), dtype=dtype)


def _unpacked(series: Any, nw: Any, argument: str) -> RealArray:
    """Numbers that are kept as something else: as categories, in a sparse column, one object each; or no number at all.

    Raises:
        TypeError: there is something that is no real number.

    """
    if series.null_count() == len(series):  # it may have any type: none of its rows has told it
        return np.full(len(series), np.nan)
    values, missing = series.to_numpy(), series.is_null().to_numpy()
    of_objects = values.ndim == 1 and values.dtype == object
    if of_objects and all(gone or _is_real(value) for value, gone in zip(values, missing, strict=True)):
        return _rounded(values, missing)
    of_floats = values.ndim == 1 and values.dtype.kind in "iuf"
    if series.dtype == nw.Boolean or not of_floats or series.dtype.is_temporal():
        raise TypeError(f"{argument} must be a column of real numbers; {series.name!r} holds {series.dtype}")
    return np.where(missing, np.nan, values.astype(np.float64))  # of a dictionary, pyarrow has any number there


def _rounded(values: Iterable[Any], missing: Iterable[bool]) -> RealArray:
    """Numbers of any kind as floats: infinite where one is beyond all floats."""
    return np.array([np.nan if gone else _float(value) for value, gone in zip(values, missing, strict=True)])


def _float(value: Any) -> float:
    try:
        return float(value)
    except OverflowError:
        return math.inf if value > 0 else -math.inf


def _is_real(value: object) -> bool:
    return isinstance(value, (int, float, np.integer, np.floating, Decimal)) and not isinstance(value, bool)


def _labelled(error: BadRows, index: Any) -> BadRows:
    """With the labels of a pandas index beside the numbers, where it is more than a count."""
    if index is None or type(index).__name__ == "RangeIndex":
        return error
    labels = [f"row {row} (index {index[row]!r})" for row in error.rows]
    return BadRows(error.rows, error.reasons, error.total, labels)


def _with_columns(table: Any, found: Columns, chosen: PlotColumns, nw: Any) -> Any:
    backend = table.implementation
    new = [nw.new_series(name, values, backend=backend) for name, values in found.values.items()]
    if chosen.mark:
        said = [found.problems.get(row) for row in range(len(table))]
        new.append(nw.new_series(chosen.problem, said, nw.String(), backend=backend))
    index = nw.maybe_get_index(table)
    if index is not None:  # else a library with an index would join by it
        new = [nw.maybe_set_index(series, index=index) for series in new]
    return table.with_columns(*new).to_native()


def _units_of(dataset: Any, columns: Mapping[str, str | float], sensor: str) -> dict[str, str]:
    """What the variables of a dataset say of their units."""
    found = {}
    known = {str(name): one.arguments for name, one in SENSORS.items()}
    for name in known.get(sensor, ()):
        column = columns.get(name, name)
        if isinstance(column, str) and column in dataset:
            array = dataset[column]
            if "units" in array.attrs:
                found[name] = array.attrs["units"]
            if hasattr(array.data, "units"):  # of a quantity of pint, as `quantify` makes of numbers with an attribute
                found[name] = str(array.data.units)
    return found


def _floats(array: Any) -> RealArray:
    """Numbers of xarray's in single precision where they are in that, else in double."""
    numbers = getattr(array.data, "magnitude", array.data)
    return np.asarray(numbers, np.float32 if array.dtype == np.float32 else np.float64)


def _require_decoded(name: str, column: str, array: Any) -> None:
    """Check that numbers are what was measured, and do not stand for that as in a file.

    Raises:
        ValueError: attributes say that they do.

    """
    told = array.attrs
    words = [word for word, nothing in PACKED.items() if told.get(word, nothing) != nothing]
    words += [word for word in MISSING if word in told and np.isin(array, told[word]).any()]
    if words:
        decoded = "numbers as they were measured, which xarray.decode_cf makes of those in a file"
        raise ValueError(f"{name} must be {decoded}; {column!r} still has the attributes {words}")


def _of_dataset(dataset: Any, chosen: PlotColumns, xarray: Any) -> Any:
    chosen.require_room([*map(str, dataset.variables)], [*map(str, dataset.dims)])
    needed = chosen.needed
    for name, column in needed.items():
        if dataset[column].dtype.kind not in "iuf":
            raise TypeError(f"{name} must be a variable of real numbers; {column!r} holds {dataset[column].dtype}")
        _require_decoded(name, column, dataset[column])
    spread = xarray.broadcast(*(dataset[column] for column in needed.values()))
    shape, dims = spread[0].shape, spread[0].dims
    numbers: dict[str, RealArray] = {
        column: _floats(array).ravel() for column, array in zip(needed.values(), spread, strict=True)
    }
    try:
        found = chosen.converted(numbers, spread[0].size)
    except BadRows as error:
        labels = [f"entry {_place(row, shape, dims)}" for row in error.rows]
        raise BadRows(error.rows, error.reasons, error.total, labels) from None
    added = {name: (dims, values.reshape(shape)) for name, values in found.values.items()}
    if chosen.mark:
        said = np.array([found.problems.get(row, "") for row in range(spread[0].size)], dtype=object)
        added[chosen.problem] = (dims, said.reshape(shape))
    return dataset.assign(added)


def _place(row: int, shape: tuple[int, ...], dims: Sequence[str]) -> str:
    places = np.unravel_index(row, shape)
    return ", ".join(f"{dim}={place}" for dim, place in zip(dims, places, strict=True))
