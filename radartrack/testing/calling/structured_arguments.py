"""Several values that a function takes as one argument which is no vector: an object with fields, a complex number."""

from __future__ import annotations

import inspect
import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from functools import partial
from typing import Any, get_type_hints

from radartrack.derive.checking.comparing.order_of_difference import is_deviation
from radartrack.derive.language.variable import Variable
from radartrack.testing.calling.argument_names import meanings
from radartrack.testing.calling.called_function import Made, Parameter

OWN = {"builtins", "collections", "collections.abc", "numpy", "typing"}  # modules whose types are no records


class Record(dict[str, float]):
    """Values by the names of their symbols, or by what else code calls those; as keys, and as attributes."""

    def __init__(self, symbols: Sequence[Variable], values: Sequence[float]) -> None:
        super().__init__(zip((symbol.name for symbol in symbols), values, strict=True))
        self.__dict__["_symbols"] = symbols
        self.__dict__["_meant"] = dict[str, str]()

    def __missing__(self, key: object) -> float:
        meant: dict[str, str] = self.__dict__["_meant"]
        found = meanings(key, self.__dict__["_symbols"]) if isinstance(key, str) else []
        free = [name for name in found if name not in meant.values()] or found  # theta and phi may mean the same two
        if not free:
            raise KeyError(key)
        return self[meant.setdefault(str(key), free[0])]

    def __getattr__(self, name: str) -> float:
        try:
            return self[name]
        except KeyError:
            raise AttributeError(f"{name!r}, which is none of {', '.join(self)}") from None

    def get(self, key: str, default: Any = None) -> Any:
        """As of any mapping."""
        try:
            return self[key]
        except KeyError:
            return default


def structured(
    parameter: Parameter, function: Callable[..., Any], symbols: Mapping[str, Variable]
) -> Iterator[Parameter]:
    """Other ways to pass what a parameter takes as a vector, the likeliest first.

    Args:
        parameter: takes several symbols.
        function: whose it is.
        symbols: by name.
    """
    taken = [symbols[name] for name in parameter.symbols]
    kind = _annotated(function, parameter.name)
    if kind is not None and (order := _fields(kind, taken)) is not None:
        yield replace(parameter, made=Made(f"a {kind.__name__}", partial(_constructed, kind, order)))
    yield replace(parameter, made=Made("a record", partial(Record, taken)))
    if len(taken) == 2 and all(_is_coordinate(one) for one in taken) and taken[0].unit == taken[1].unit:
        yield replace(parameter, made=Made("the complex number", _complex, is_ordered=True))


def _is_coordinate(symbol: Variable) -> bool:
    """Whether it is a position or one of its derivatives, two of which a plane's point has."""
    return symbol.unit.metre == 1 and symbol.unit.radian == 0 and not is_deviation(symbol)


def _annotated(function: Callable[..., Any], parameter: str) -> type | None:
    """The class that a parameter is said to be of, where that is one of the user's."""
    try:
        hint = get_type_hints(inspect.unwrap(function)).get(parameter)
    except (AttributeError, NameError, TypeError):  # of what cannot be resolved nothing is known
        return None
    return hint if isinstance(hint, type) and hint.__module__.split(".")[0] not in OWN else None


def _fields(kind: type, symbols: Sequence[Variable]) -> list[int] | None:
    """For each field that a class must be given, which of the symbols it takes; None where they do not match."""
    try:
        parameters = inspect.signature(kind).parameters.values()
    except (TypeError, ValueError):
        return None
    names = [one.name for one in parameters if one.default is one.empty and one.kind is one.POSITIONAL_OR_KEYWORD]
    if len(names) != len(symbols):
        return None
    order: list[int] = []
    for name in names:
        meant = meanings(name, symbols)
        order.append(next((place for place, one in enumerate(symbols) if one.name in meant and place not in order), -1))
    left = [place for place in range(len(symbols)) if place not in order]
    return [place if place >= 0 else left.pop(0) for place in order]


def _constructed(kind: type, order: Sequence[int], values: Sequence[float]) -> Any:
    return kind(*(values[place] for place in order))


def _complex(values: Sequence[float]) -> complex:
    return complex(*values) if all(map(math.isfinite, values)) else complex(math.nan, math.nan)
