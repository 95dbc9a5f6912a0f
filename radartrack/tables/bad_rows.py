"""Rows that cannot be converted: which they are, and what is wrong with each."""

from collections.abc import Callable, Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from radartrack._arrays.validation import Domain, RealArray
from radartrack._conversion.sensors import Sensor
from radartrack.tables.unit_factors import Unit

MOST_TOLD = 5  # rows in a message; the error has them all


class BadRows(ValueError):
    """Some rows of a table cannot be converted.

    Attributes:
        rows: their numbers, counted from 0.
        reasons: what is wrong with each.
    """

    def __init__(self, rows: Sequence[int], reasons: Sequence[str], total: int, labels: Sequence[str] = ()) -> None:
        self.rows = list(rows)
        self.reasons = list(reasons)
        self.total = total
        self.labels = list(labels) or [f"row {row}" for row in self.rows]
        super().__init__(self._message())

    def __reduce__(self) -> tuple[type["BadRows"], tuple[list[int], list[str], int, list[str]]]:
        """All parts, as processes hand errors to each other."""
        return BadRows, (self.rows, self.reasons, self.total, self.labels)

    def _message(self) -> str:
        told = [f"{label}: {reason}" for label, reason in zip(self.labels, self.reasons, strict=False)][:MOST_TOLD]
        left = len(self.rows) - len(told)
        more = f"; and {left} more" if left else ""
        return f"{len(self.rows)} of {self.total} rows cannot be converted: {'; '.join(told)}{more}"


def problems(sensor: Sensor, values: Mapping[str, RealArray], count: int, units: Mapping[str, Unit]) -> dict[int, str]:
    """What is wrong with rows that cannot be converted, by their numbers.

    Args:
        sensor: what is measured.
        values: of its arguments, by name, numbers or one for each row.
        count: of the rows.
        units: of the numbers that were given, where they were others.

    """
    found: dict[int, str] = {}

    def note(name: str, array: RealArray, domain: Domain, missing: str) -> None:
        low, high = domain.bounds(array.dtype)
        held = np.broadcast_to((array >= low) & (array <= high), count)
        for row in np.flatnonzero(~held).tolist():
            value = float(np.broadcast_to(array, count)[row])
            given = f"{value / units[name].factor:.7g} {units[name].name}" if name in units else f"{value:.7g}"
            allowed = f"{name} must be {domain.describe(array.dtype)}; got {given}"
            found.setdefault(row, missing if np.isnan(value) else allowed)

    for name, (_, domain) in sensor.arguments.items():
        note(name, values[name], domain, f"{name} is missing")
    possible = np.ones(count, dtype=bool)
    possible[list(found)] = False
    symbols = {symbol: values[name] for name, (symbol, _) in sensor.arguments.items()}
    with np.errstate(all="ignore"):  # of rows that are bad already
        for name, array, domain in sensor.conditions(symbols):
            note(name, np.where(possible, array, 0.5 * (domain.bounds(array.dtype)[1])), domain, f"{name} is no number")
    return found


def scattered(convert: Callable[[NDArray[np.bool_]], Sequence[RealArray]], good: NDArray[np.bool_]) -> list[RealArray]:
    """What is converted of the good rows, NaN in the others."""
    full = []
    for array in convert(good):
        spread = np.full((len(good), *array.shape[1:]), np.nan, array.dtype)
        spread[good] = array
        full.append(spread)
    return full
