"""Which generated function a quantity has, what model it belongs to, and what errors of it are measured against."""

from __future__ import annotations

from functools import cache
from importlib import import_module

import numpy as np
import numpy.typing as npt

from radartrack.derive.language.model import Model
from radartrack.derive.language.quantity import Quantity
from radartrack.derive.moments.conversion_quantities import quantities_of
from radartrack.verification.domain_points import Points
from radartrack.verification.outcome import Function

Array = npt.NDArray[np.float64]


class NotGenerated(LookupError):
    """A quantity of the catalogue has no function in the generated package."""


def generated(quantity: Quantity) -> Function:
    """The function that was written for a quantity.

    Raises:
        NotGenerated: when there is none.
    """
    try:
        function: Function = getattr(import_module(f"radartrack.generated.{quantity.module}"), quantity.function)
    except (ImportError, AttributeError):
        raise NotGenerated(f"{quantity.name} has no generated function; radartrack regenerate writes it") from None
    return function


def model_of(quantity: Quantity) -> Model | None:
    """The measurement model that a quantity belongs to, if any."""
    return quantity.model


@cache
def quantity_of(model: Model, row: str) -> Quantity:
    """A quantity of a model by its name without the first part."""
    return next(quantity for quantity in quantities_of(model) if row_of(quantity) == row)


def row_of(quantity: Quantity) -> str:
    """The name without its first part: `bias.truth`."""
    return quantity.name.partition(".")[2]


def evaluated(function: Function, quantity: Quantity, points: Points) -> Array:
    """The values at points, shape (points, *tensor); what a constant function gives once is repeated."""
    count = len(next(iter(points.values()))) if points else 1
    named = {symbol.name: points[symbol.name] for symbol in quantity.symbols}
    with np.errstate(all="ignore"):
        values = np.asarray(function(**named), dtype=np.float64)
    return np.broadcast_to(values, (count, *quantity.shape))


def scale_of(quantity: Quantity, values: Array) -> Array:
    """For each entry √(c_ii c_jj) of a covariance, else the norm of the entries that share its unit."""
    if quantity.is_covariance:
        deviations = np.sqrt(np.abs(np.diagonal(values, axis1=-2, axis2=-1)))
        return np.asarray(deviations[..., :, np.newaxis] * deviations[..., np.newaxis, :])
    flat = values.reshape(values.shape[0], -1)
    return np.asarray(np.sqrt(flat**2 @ _alike(quantity)).reshape(values.shape))


@cache
def _alike(quantity: Quantity) -> Array:
    units = [quantity.unit(index) for index in np.ndindex(quantity.shape)]
    return np.array([[float(first == second) for second in units] for first in units])


def relative(found: Array, expected: Array, scale: Array) -> float:
    """The largest difference by the scale; what is not finite is infinitely wrong."""
    with np.errstate(all="ignore"):
        errors = np.where(found == expected, 0.0, np.abs(found - expected) / scale)
    return float(np.where(np.isfinite(errors), errors, np.inf).max(initial=0.0))
