"""Reads what a table says of a symbol: unit, domain and meaning, each in the words of TOML."""

from __future__ import annotations

import math
from collections.abc import Mapping
from types import MappingProxyType
from typing import Any

from radartrack.derive.formula.unknown_names import unusable
from radartrack.derive.language.variable import Variable
from radartrack.derive.reading.unit_text import read_unit
from radartrack.derive.units import METRE, METRE_PER_SECOND, ONE, RADIAN, SECOND, Unit

FIELDS = ("unit", "low", "high", "meaning", "whole")
DOMAINS: Mapping[Unit, tuple[float, float]] = MappingProxyType(
    {
        ONE: (-1.0, 1.0),
        METRE: (1.0, 1e8),
        RADIAN: (-math.pi, math.pi),
        SECOND: (1e-3, 1e3),
        SECOND**-1: (1e-3, 1e12),
        METRE_PER_SECOND: (-1e4, 1e4),
        METRE_PER_SECOND / SECOND: (-1e3, 1e3),
        RADIAN / SECOND: (-1.0, 1.0),
    }
)
"""Of a symbol of which only the unit is said: lengths and times are positive; a coordinate says where it begins."""
ANY: tuple[float, float] = (-1e6, 1e6)
DEVIATIONS: Mapping[Unit, tuple[float, float]] = MappingProxyType(
    {
        ONE: (1e-9, 0.1),
        METRE: (1e-3, 1e4),
        RADIAN: (1e-9, 1.0),
        METRE_PER_SECOND: (1e-4, 1e3),
    }
)
"""Of the standard deviation of an error, likewise; in other units, from these shares of what is measured."""
SHARES = (1e-9, 0.1)
SHOWN = 60  # characters of what was given


class TableError(ValueError):
    """A table that says what cannot be used: it names table, field, what was given and what is allowed."""


def read_symbol(name: str, table: object, *, deviation_of: Variable | None = None) -> Variable:
    """A symbol as `[symbols]` says it.

    Args:
        name: of the symbol.
        table: with `unit` and perhaps `low`, `high`, both in that unit, `meaning`, and `whole` for whole numbers.
        deviation_of: what is measured, where it is the standard deviation of its error.

    Raises:
        TableError: naming the field.
    """
    where = f"symbols.{shown_name(name)}"
    if not isinstance(table, Mapping):
        raise TableError(f'{where} must be a table, such as {{ unit = "m" }}; given {shown(table)}')
    if unknown := sorted(table.keys() - set(FIELDS)):
        raise TableError(f"{where}: {unknown[0][:SHOWN]} is no field of a symbol; allowed: {', '.join(FIELDS)}")
    if why := unusable(name):
        raise TableError(f"{where}: {why}")
    if not isinstance(table.get("unit"), str):
        raise TableError(f'{where}.unit must be a unit in quotes, such as "m/s"; given {shown(table.get("unit"))}')
    try:
        scale = read_unit(table["unit"])
    except ValueError as error:
        raise TableError(f"{where}.unit: {error}") from None
    low, high = _domain(scale.unit, deviation_of)
    ends = [_end(table, end, default, scale.size, where) for end, default in (("low", low), ("high", high))]
    meaning = table.get("meaning", name)
    try:
        return Variable(name, meaning, scale.unit, *ends, whole=_flag(table, "whole", where))
    except ValueError as error:
        raise TableError(f"{where}: {error}") from None


def _domain(unit: Unit, deviation_of: Variable | None) -> tuple[float, float]:
    if deviation_of is None:
        return DOMAINS.get(unit, ANY)
    size = max(abs(deviation_of.low), abs(deviation_of.high)) or 1.0
    return DEVIATIONS.get(unit, (SHARES[0] * size, SHARES[1] * size))


def _end(table: Mapping[str, Any], field: str, otherwise: float, factor: float, where: str) -> float:
    """An end of the domain in SI units."""
    if field not in table:
        return otherwise
    value = table[field]
    if isinstance(value, bool) or not isinstance(value, int | float):
        raise TableError(f"{where}.{field} must be a number, given {shown(value)}")
    try:
        return value * factor if factor != 1 else float(value)
    except OverflowError:
        raise TableError(f"{where}.{field} must be a number that floats hold, given {shown(value)}") from None


def _flag(table: Mapping[str, Any], field: str, where: str) -> bool:
    value = table.get(field, False)
    if not isinstance(value, bool):
        raise TableError(f"{where}.{field} must be true or false, given {shown(value)}")
    return value


def shown(value: object) -> str:
    """What was given, cut short."""
    try:
        text = repr(value)
    except (RecursionError, ValueError):  # a whole number of more digits than Python prints
        return "what is too long to show"
    return text if len(text) <= SHOWN else f"{text[: SHOWN - 3]}..."


def shown_name(name: str) -> str:
    """A key of a table, cut short and without what a terminal would obey."""
    return "".join(c if c.isprintable() else "?" for c in name[:SHOWN])
