"""The fields of a claim as a file has them: how each is read, and what it may be."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from typing import Any

from radartrack.derive.checking.papers.claim import Along, ClaimsError
from radartrack.derive.code_languages import LANGUAGES
from radartrack.derive.reading.unit_text import BASE

MAX_WHOLE = 10_000  # values of a range
MOST_STEPS = 40  # of a chain
ID = re.compile(r"[A-Za-z0-9_]+(?:[.-][A-Za-z0-9_]+)*")
NUMBER = re.compile(r"[+-]?\d{1,40}(?:\.\d{1,40})?(?:[eE][+-]?\d{1,2})?")
WORD = re.compile(r"(?<![\w.])[A-Za-z_]\w*")
UNITS = tuple(BASE)
OF_UNIT = re.compile(r"[^\W\d_]+")
HIGHEST_ORDER = 12  # in the deviations
BOUND = re.compile(rf"(?P<number>{NUMBER.pattern})\s*(?P<unit>.*)")
KINDS = ("paper", "library")
TRENDS = ("increasing", "decreasing", "convex", "concave")


def _text(value: object, where: str) -> str:
    if not isinstance(value, str) or not value.strip():
        raise ClaimsError(f"{where} must be text, given {shown(value)}")
    return value.strip()


def _code(value: object, where: str) -> str:
    _text(value, where)
    return str(value)  # with the spaces before its lines


def _id(value: object, where: str) -> str:
    if not isinstance(value, str) or not ID.fullmatch(value):
        raise ClaimsError(f"{where} must be letters, digits and _ with dots between, given {shown(value)}")
    return value


def _number(value: object, where: str) -> str:
    if not isinstance(value, str) or not NUMBER.fullmatch(value):
        raise ClaimsError(f'{where} must be a number in quotes, as printed, such as "2.78"; given {shown(value)}')
    return value


def _one_of(allowed: tuple[str, ...]) -> Callable[[object, str], str]:
    def read(value: object, where: str) -> str:
        if value not in allowed:
            raise ClaimsError(f"{where} must be one of {', '.join(allowed)}; given {shown(value)}")
        return str(value)

    return read


def _unit(value: object, where: str) -> str:
    if not isinstance(value, str) or not value or set(OF_UNIT.findall(value)) - set(UNITS):
        raise ClaimsError(
            f"{where} must be one of {', '.join(UNITS)}, or a product of their powers such as m/s^2; "
            f"given {shown(value)}"
        )
    return value


def _chain(value: object, where: str) -> tuple[str, ...]:
    if not isinstance(value, list) or not 2 <= len(value) <= MOST_STEPS:
        raise ClaimsError(f"{where} must be a list of 2 to {MOST_STEPS} formulas, given {shown(value)}")
    return tuple(_text(one, where) for one in value)


def _order(value: object, where: str) -> int:
    if not isinstance(value, int) or isinstance(value, bool) or not 0 <= value <= HIGHEST_ORDER:
        raise ClaimsError(f"{where} must be a whole number from 0 to {HIGHEST_ORDER}, given {shown(value)}")
    return value


def _within(value: object, where: str) -> dict[str, tuple[str, str]]:
    fits = (
        isinstance(value, dict) and value and all(isinstance(ends, list) and len(ends) == 2 for ends in value.values())
    )
    if not fits or not isinstance(value, dict):
        raise ClaimsError(
            f'{where} must be from where to where, such as {{ r = ["1e3", "1e5"] }}; given {shown(value)}'
        )
    return {name: (_formula(low, where), _formula(high, where)) for name, (low, high) in value.items()}


def _bound(value: object, where: str) -> str:
    found = BOUND.fullmatch(value.strip()) if isinstance(value, str) else None
    if found is None:
        raise ClaimsError(f'{where} must be a number and a unit, such as "1 %" or "5 m"; given {shown(value)}')
    if found["unit"]:
        _unit(found["unit"], where)
    return str(value).strip()


def _positive(value: object, where: str) -> int:
    if not isinstance(value, int) or isinstance(value, bool) or not 1 <= value <= 40:
        raise ClaimsError(f"{where} must be a whole number from 1 to 40, given {shown(value)}")
    return value


def _page(value: object, where: str) -> str:
    if isinstance(value, bool) or not isinstance(value, int | str):
        raise ClaimsError(f"{where} must be a number or text, given {shown(value)}")
    return str(value)


def _formulas(value: object, where: str) -> dict[str, str]:
    if not isinstance(value, dict) or not value:
        raise ClaimsError(f'{where} must be a table of formulas, such as {{ rho = "0" }}; given {shown(value)}')
    return {name: _formula(one, f"{where}.{name}") for name, one in value.items()}


def _formula(value: object, where: str) -> str:
    if isinstance(value, bool) or not isinstance(value, int | str) or not str(value).strip():
        raise ClaimsError(f'{where} must be a whole number or a formula in quotes, such as "0.5"; given {shown(value)}')
    return str(value)


def _along(value: object, where: str) -> Along:
    if not isinstance(value, dict) or len(value) != 1:
        raise ClaimsError(f"{where} must name one symbol, such as {{ k = [3, 20] }}; given {shown(value)}")
    ((symbol, values),) = value.items()
    if not isinstance(values, list) or not values:
        raise ClaimsError(f"{where}.{symbol} must be two whole numbers, from and to, or a list of formulas in quotes")
    if all(isinstance(one, str) and one.strip() for one in values):
        return symbol, tuple(values)
    whole = len(values) == 2 and all(isinstance(one, int) and not isinstance(one, bool) for one in values)
    if not whole or not 0 < values[1] - values[0] <= MAX_WHOLE:
        raise ClaimsError(f"{where}.{symbol} must be two whole numbers, from and to, or a list of formulas in quotes")
    return symbol, tuple(str(number) for number in range(values[0], values[1] + 1))


def shown(value: object) -> str:
    """A value of a file in a message, cut short."""
    text = repr(value)
    return text if len(text) <= 60 else f"{text[:57]}..."


FIELDS: Mapping[str, Callable[[object, str], Any]] = {
    "id": _id,
    "quantity": _text,
    "formula": _text,
    "latex": _text,
    "left": _text,
    "right": _text,
    "chain": _chain,
    "to_order": _order,
    "limit": _formulas,
    "within": _within,
    "error_at_most": _bound,
    "code": _code,
    "language": _one_of(LANGUAGES),
    "function": _text,
    "value": _number,
    "unit": _unit,
    "significant": _positive,
    "at": _formulas,
    "given": _formulas,
    "let": _formulas,
    "maximum_over": _along,
    "attained_at": _formula,
    "along": _along,
    "trend": _one_of(TRENDS),
    "crosses": _text,
    "at_most": _text,
    "at_least": _text,
    "undecided": _text,
    "equation": _text,
    "page": _page,
    "note": _text,
    "file": _text,
    "lines": _text,
    "seen": _text,
    "matters": _text,
    "repair": _text,
    "finding": _id,
}
ORIGIN_FIELDS: Mapping[str, Callable[[object, str], str]] = {
    "doi": _text,
    "kind": _one_of(KINDS),
    "url": _text,
    "commit": _text,
    "seen": _text,
}
