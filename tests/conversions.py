"""The generated functions of the measurement models, and points at which to try them."""

import math
from collections.abc import Callable
from functools import cache
from importlib import import_module

import numpy as np
from hypothesis import strategies as st

from radartrack.derive.catalogue import catalogue
from radartrack.derive.language.quantity import Quantity
from radartrack.derive.language.variable import Variable
from radartrack.derive.sensors import models
from radartrack.derive.units import ONE, RADIAN
from tests import maps

QUANTITIES = [quantity for quantity in catalogue().values() if quantity.module in models()]
BY_HAND = [quantity for quantity in QUANTITIES if quantity.module in maps.MAPS]
"""Of the models whose maps are written down by hand; the bistatic radar, whose map has a parameter, has own tests."""


def generated(quantity: Quantity) -> Callable[..., np.ndarray]:
    """The generated function of a quantity."""
    function: Callable[..., np.ndarray] = getattr(
        import_module(f"radartrack.generated.{quantity.module}"), quantity.function
    )
    return function


def of(*rows: str) -> list[Quantity]:
    """The quantities of all models whose names, without the model's, are these."""
    return [quantity for quantity in BY_HAND if row(quantity) in rows]


def covariances() -> list[Quantity]:
    """The covariance matrices of all models."""
    return [quantity for quantity in QUANTITIES if quantity.is_covariance]


def row(quantity: Quantity) -> str:
    """The name without the model's."""
    return quantity.name.partition(".")[2]


def scale(quantity: Quantity, value: np.ndarray) -> np.ndarray:
    """What errors of each entry are measured against: √(c_ii c_jj), or the norm of the entries of one unit."""
    if quantity.is_covariance:
        deviations = np.sqrt(np.diagonal(value, axis1=-2, axis2=-1))
        return deviations[..., :, np.newaxis] * deviations[..., np.newaxis, :]
    units = [quantity.unit(index) for index in np.ndindex(quantity.shape)]
    flat = value.reshape(*value.shape[: value.ndim - len(quantity.shape)], -1)
    alike = np.array([[first == second for second in units] for first in units])
    return np.sqrt(flat**2 @ alike).reshape(value.shape)


@cache  # Hypothesis examines a strategy whenever it is made anew, which takes longer than to draw from it
def points(quantity: Quantity, **own: st.SearchStrategy[float]) -> st.SearchStrategy[dict[str, float]]:
    """Points with large, correlated errors, off the axes, where every effect that a formula holds shows."""
    drawn = {s.name: own[s.name] if s.name in own else coarse(s) for s in quantity.symbols}
    return st.fixed_dictionaries(drawn)


@cache
def long_paths(quantity: Quantity) -> st.SearchStrategy[dict[str, float]]:
    """As `points`, but of a bistatic radar with a path that is longer than the baseline."""
    lengths = {"path": st.floats(3e4, 1e6), "baseline": st.floats(1, 2e4)}
    return points(quantity, **{s.name: lengths[s.name] for s in quantity.symbols if s.name in lengths})


def coarse(symbol: Variable) -> st.SearchStrategy[float]:
    """Values of a symbol that stand out against rounding."""
    if symbol.is_correlation:
        return st.floats(0.1, 0.95) | st.floats(-0.95, -0.1)
    is_deviation = "sigma_" in symbol.name
    if symbol.unit == RADIAN:
        return st.floats(0.05, 1.0) if is_deviation else st.floats(symbol.low, symbol.high)
    if symbol.unit == ONE:
        return st.floats(symbol.high / 10, symbol.high / 2) if is_deviation else signed(symbol.high)
    if is_deviation:
        middle = math.sqrt(symbol.low * symbol.high)
        return st.floats(10 * middle, 100 * middle)
    if symbol.low > 0:
        return st.floats(1e2, 1e3)
    return signed(symbol.high)


def signed(high: float) -> st.SearchStrategy[float]:
    """Values of either sign, away from zero."""
    return st.floats(high / 8, high / 2) | st.floats(-high / 2, -high / 8)


def ids(quantity: Quantity) -> str:
    return quantity.name
