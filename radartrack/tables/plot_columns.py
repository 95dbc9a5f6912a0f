"""What the columns of a table of plots mean, and what they are converted to."""

import reprlib
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from numbers import Integral
from typing import Any, Literal, NamedTuple, Self, TypeAlias, get_args

import numpy as np
from numpy.typing import NDArray

from radartrack import convert
from radartrack._arrays.validation import RealArray, one_of, real_arrays, real_number, require_within
from radartrack._conversion.sensors import SENSORS, AzimuthFrom, Sensor, SensorName
from radartrack.tables.bad_rows import BadRows, problems, scattered
from radartrack.tables.unit_factors import Unit, read_unit

Method: TypeAlias = Literal["linear", "second_order", "averaged", "unbiased", "posterior"]
BadRowsWord: TypeAlias = Literal["raise", "mark"]

PROBLEM = "problem"
TURNED = 2048  # rows that are made columns at once: 200 kB, which stays in the cache
OPTIONAL = {"correlation": 0.0}


class Columns(NamedTuple):
    """New columns by name, and what is wrong with the rows that are bad, by their numbers."""

    values: dict[str, RealArray]
    problems: dict[int, str]


@dataclass(frozen=True)
class PlotColumns:
    """Where the arguments of a conversion are found in a table, in words that were checked.

    Attributes:
        sensor: what is measured.
        columns: the name of the column of an argument, or one number for all rows.
        units: of arguments, where they are not those of the conversion.
        method: which mean and covariance.
        azimuth_from: as the conversion takes it.
        mark: whether bad rows are marked, not refused.
        prefix: before the names of new columns.
    """

    sensor: SensorName
    columns: Mapping[str, str | float]
    units: Mapping[str, Unit]
    method: Method
    azimuth_from: AzimuthFrom | None
    mark: bool
    prefix: str

    @classmethod
    def chosen(
        cls,
        sensor: SensorName,
        columns: Mapping[str, str | float] | None,
        units: Mapping[str, str] | None,
        method: Method,
        azimuth_from: AzimuthFrom | None,
        bad_rows: BadRowsWord,
        prefix: str,
    ) -> Self:
        """Check the words.

        Raises:
            TypeError, ValueError: a word is unknown, a number is out of place, or a unit is one of something else.

        """
        model = SENSORS[one_of("sensor", sensor, SENSORS)]
        arguments = model.arguments
        for option, given in (("columns", columns), ("units", units)):
            if given is not None and not isinstance(given, Mapping):
                raise TypeError(f"{option} must be a mapping from arguments; got {reprlib.repr(given)}")
            for name in given or {}:
                one_of(f"an argument in {option}", name, arguments)
        read = {name: read_unit(name, unit, arguments[name].domain) for name, unit in (units or {}).items()}
        if not isinstance(prefix, str):
            raise TypeError(f"prefix must be a text; got {reprlib.repr(prefix)}")
        found: dict[str, str | float] = {name: name for name in arguments if name not in OPTIONAL}
        found |= {**OPTIONAL, **(columns or {})}
        if not any(isinstance(source, str) for source in found.values()):
            raise ValueError(f"columns must name a column for at least one argument; got {reprlib.repr(found)}")
        for name, source in found.items():
            if not isinstance(source, str):
                value = np.asarray(
                    real_number(f"columns[{name!r}]", source) * (read[name].factor if name in read else 1)
                )
                require_within(name, value, arguments[name].domain)
        return cls(
            model.module,
            {name: found[name] for name in arguments},
            read,
            one_of("method", method, get_args(Method)),
            model.chosen_axis(azimuth_from),
            one_of("bad_rows", bad_rows, get_args(BadRowsWord)) == "mark",
            prefix,
        )

    @property
    def model(self) -> Sensor:
        """What is measured, with its formulas."""
        return SENSORS[self.sensor]

    @property
    def needed(self) -> dict[str, str]:
        """The names of columns, by argument."""
        return {name: source for name, source in self.columns.items() if isinstance(source, str)}

    @property
    def components(self) -> list[str]:
        """Of a mean."""
        size = len(self.model.coordinates)
        return [*"xyz"[: size - 1], "eta"] if "range_rate" in self.model.coordinates else [*"xyz"[:size]]

    @property
    def outputs(self) -> list[str]:
        """The names of the new columns of numbers: the mean, then the upper triangle of the covariance by rows."""
        names = self.components
        pairs = [f"cov_{a}_{b}" for i, a in enumerate(names) for b in names[i:]]
        return [f"{self.prefix}{name}" for name in (*names, *pairs)]

    @property
    def problem(self) -> str:
        """The name of the column that says what is wrong with a row."""
        return f"{self.prefix}{PROBLEM}"

    def require_room(self, present: Sequence[str], reserved: Sequence[str] = ()) -> None:
        """Check that a table has the columns that are needed, and none that are to be added.

        Args:
            present: the names of its columns.
            reserved: further names that no column may get: one that is called as a dimension becomes its index.

        Raises:
            ValueError: it has not, or has; or a whole number may be the name of one.

        """
        if len({*present}) < len(present):
            raise ValueError(f"the columns of the table must have different names; got {[*present]}")
        for name, column in self.needed.items():
            if column not in present:
                hint = ": say which column it is" if column == name else ""
                raise ValueError(f"{name} must be one of the columns {[*present]}; got {column!r}{hint}")
        for name, source in self.columns.items():
            if isinstance(source, Integral) and source in present:
                raise ValueError(
                    f"columns[{name!r}] must be a text, or a number that is no column's name; got {source}, which is "
                    f"one: rename the columns, or write {float(source)!r} for the number"
                )
        added = [*self.outputs, *([self.problem] if self.mark else [])]
        if taken := [name for name in added if name in {*present, *reserved}]:
            raise ValueError(f"the table must have no columns {taken} yet; give a prefix for the new ones")

    def converted(self, table: Mapping[str, RealArray], count: int, first: int = 0) -> Columns:
        """Convert rows.

        Args:
            table: the columns that are needed, in float32 or float64, NaN where nothing is.
            count: of the rows.
            first: the number of the first of them in an error.

        Raises:
            BadRows: some cannot be converted, and are not to be marked.

        """
        plot = {name: self._argument(name, table) for name in self.columns}
        arrays = real_arrays(plot)
        try:
            return self._named(self._computed(arrays), {})
        except ValueError:
            found = problems(self.model, arrays, count, self.units)
            if not found:
                raise
        found = dict(sorted(found.items()))
        if not self.mark:
            raise BadRows([first + row for row in found], [*found.values()], count)
        good = np.ones(count, dtype=bool)
        good[[*found]] = False
        return self._named(scattered(lambda rows: self._computed(_only(arrays, rows)), good), found)

    def _argument(self, name: str, table: Mapping[str, RealArray]) -> RealArray | float:
        source, times = self.columns[name], self.units[name].factor if name in self.units else 1.0
        if not isinstance(source, str):
            return float(source) * times
        numbers = table[source]
        return numbers if times == 1 else numbers * numbers.dtype.type(times)

    def _computed(self, arrays: Mapping[str, RealArray]) -> tuple[RealArray, RealArray]:
        function: Callable[..., convert.Converted] = getattr(convert, self.sensor)
        axis = {} if self.azimuth_from is None else {"azimuth_from": self.azimuth_from}
        mean, covariance = function(**arrays, method=self.method, **axis)
        return mean, covariance

    def _named(self, found: Sequence[RealArray], wrong: dict[int, str]) -> Columns:
        mean, covariance = found
        count, size = mean.shape
        upper = [i * size + j for i in range(size) for j in range(i, size)]
        entries = covariance.reshape(count, size * size)
        columns = np.empty((size + len(upper), count), mean.dtype)
        for start in range(0, count, TURNED):  # at once, each column would fetch every row from memory again
            rows = slice(start, start + TURNED)
            columns[:size, rows] = mean[rows].T
            columns[size:, rows] = entries[rows][:, upper].T
        return Columns(dict(zip(self.outputs, columns, strict=True)), wrong)


def _only(arrays: Mapping[str, RealArray], rows: NDArray[Any]) -> dict[str, RealArray]:
    return {name: array[rows] if array.ndim else array for name, array in arrays.items()}
