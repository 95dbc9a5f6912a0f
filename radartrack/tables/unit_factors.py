"""Units of columns: what a number in one is worth in the unit that a conversion takes."""

import re
from importlib import import_module
from importlib.util import find_spec
from typing import Any, NamedTuple

from radartrack._arrays.validation import Domain

NAMED = re.compile(r"[^\W\d][\w°]*(?: ?[*/] ?[^\W\d][\w°]*){0,3}")  # names alone: no powers of anybody's choosing
INVERSE = re.compile(r"(?<=[\w°])[ .]([^\W\d]+)(?:\^|\*\*)?-1$")  # "m s-1", as the conventions of netCDF write it
LONGEST = 64
SMALLEST = 1e-7  # of what metres or metres a second are given in: nobody means a nanometre by the "nm" of a range
_KINDS = {"m": "length", "rad": "angle", "m/s": "speed"}


class Unit(NamedTuple):
    """The name of a unit, and what numbers in it are multiplied by to be in metres, radians and seconds."""

    name: str
    factor: float


def read_unit(name: str, unit: object, domain: Domain) -> Unit:
    """The unit of an argument.

    Args:
        name: of the argument.
        unit: as pint reads it, such as "deg", "km", "nautical_mile", "knot" or "km/h".
        domain: of the argument.

    Raises:
        ImportError: pint is not there.
        TypeError: the unit is no text.
        ValueError: the unit is unknown, or is one of something else.

    """
    wanted = domain.unit.strip()
    if not isinstance(unit, str):
        raise TypeError(f"the unit of {name} must be a text such as {_example(wanted)!r}; got {unit!r}")
    if unit == wanted or (not wanted and unit.strip() == "1"):  # as netCDF writes it
        return Unit(unit, 1.0)
    allowed = f"a unit of {_KINDS.get(wanted, 'pure numbers')} such as {_example(wanted)!r}"
    pint = _pint()
    text = INVERSE.sub(r"/\1", unit[:LONGEST].strip())
    if len(unit) > LONGEST or not NAMED.fullmatch(text):
        raise ValueError(f"the unit of {name} must be {allowed}; got {unit[:LONGEST]!r}")
    quantity = pint.get_application_registry().Quantity
    something_else = ValueError(f"the unit of {name} must be {allowed}; got {unit!r}, which is one of something else")
    try:
        one, two = quantity(1.0, text), quantity(2.0, text)
        factor, twice = float(one.to(wanted).magnitude), float(two.to(wanted).magnitude)
    except pint.UndefinedUnitError:
        raise ValueError(f"the unit of {name} must be {allowed}; pint knows no unit {unit!r}") from None
    except pint.errors.PintTypeError:
        raise something_else from None
    # A decibel is no multiple of one; and of what has no dimension only some are angles: a per cent is none.
    if twice != 2 * factor or one.to_root_units().units != quantity(1.0, wanted).to_root_units().units:
        raise something_else
    if factor < SMALLEST and wanted in {"m", "m/s"}:
        told = f"{unit!r}, which is {factor:.3g} {wanted}; a nautical mile is 'nautical_mile' or 'nmi'"
        raise ValueError(f"the unit of {name} must be {allowed}, of a size that radars measure; got {told}")
    return Unit(unit.strip(), factor)


def _example(wanted: str) -> str:
    return {"m": "km", "rad": "deg", "m/s": "knot"}.get(wanted, "percent")


def _pint() -> Any:
    if find_spec("pint") is None:
        raise ImportError("units need the extra: pip install radartrack[tables]; without it numbers are in m, rad, m/s")
    return import_module("pint")
