"""A single plot in plain numbers: a live tracker's call makes no arrays but its result."""

from collections.abc import Callable, Mapping
from functools import cache
from importlib import import_module
from typing import Any

import numpy as np

from radartrack._arrays.validation import RealArray
from radartrack._conversion.semidefinite import is_plain
from radartrack._conversion.sensors import Argument
from radartrack._conversion.way import Way

PLAIN = frozenset({float, int, np.float64})


def one_plot(way: Way, given: Mapping[str, Any]) -> tuple[RealArray, RealArray] | None:
    """Convert plain numbers, by name.

    Returns:
        Mean and covariance; None where an argument is no plain number or outside its interval, where there is a
        prediction, and where the covariance takes care.

    Raises:
        ValueError: each number is possible alone, but not beside the others.

    """
    sensor, arguments = way.sensor, way.sensor.arguments
    if way.prediction or not _are_plain(given, arguments):
        return None
    values = {symbol: float(given[name]) for name, (symbol, _) in arguments.items()}
    sensor.require_possible(values)
    if not is_plain(values):
        return None
    mean: dict[tuple[int, ...], float] = {}
    covariance: dict[tuple[int, ...], float] = {}
    _loop(way.function)([[value] for value in values.values()], mean, covariance)
    size = len(mean)
    return way.oriented(np.array([*mean.values()]), np.array([*covariance.values()]).reshape(size, size))


def _are_plain(given: Mapping[str, Any], arguments: Mapping[str, Argument]) -> bool:
    return all(type(given[name]) in PLAIN and domain.holds(given[name]) for name, (_, domain) in arguments.items())


@cache
def _loop(name: str) -> Callable[..., None]:
    """The conversion as a loop over plots, here of one, which fills dictionaries in the order of their places."""
    found: Callable[..., None] = getattr(import_module("radartrack.generated.loops"), name)
    return found
