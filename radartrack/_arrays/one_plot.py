"""A single plot in plain numbers: a live tracker's call makes no arrays but its result."""

from collections.abc import Callable, Mapping
from functools import cache
from importlib import import_module
from typing import Any

import numpy as np

from radartrack._arrays.semidefinite import is_plain
from radartrack._arrays.sensors import Sensor
from radartrack._arrays.validation import RealArray

PLAIN = frozenset({float, int, np.float64})


def one_plot(sensor: Sensor, method: str, given: Mapping[str, Any]) -> tuple[RealArray, RealArray] | None:
    """Convert plain numbers, by name.

    Returns:
        Mean and covariance; None where an argument is no plain number or outside its interval, and where the
        covariance takes care.

    Raises:
        ValueError: each number is possible alone, but not beside the others.

    """
    arguments = sensor.arguments
    if not all(type(given[name]) in PLAIN and domain.holds(given[name]) for name, (_, domain) in arguments.items()):
        return None
    values = {symbol: float(given[name]) for name, (symbol, _) in arguments.items()}
    sensor.require_possible(values)
    if not is_plain(values):
        return None
    mean: dict[tuple[int, ...], float] = {}
    covariance: dict[tuple[int, ...], float] = {}
    _loop(f"{sensor.module}_{method}")(*([value] for value in values.values()), mean, covariance)
    size = len(mean)
    return np.array([*mean.values()]), np.array([*covariance.values()]).reshape(size, size)


@cache
def _loop(name: str) -> Callable[..., None]:
    """The conversion as a loop over plots, here of one, which fills dictionaries in the order of their places."""
    found: Callable[..., None] = getattr(import_module("radartrack.generated.loops"), name)
    return found
