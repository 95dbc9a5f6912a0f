"""What single precision costs: errors of the float32 functions where nothing in them leaves the range of float32."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from typing import Any

import numpy as np
import numpy.typing as npt

from radartrack.derive.language.quantity import Quantity
from radartrack.derive.stable.quantity_form import form_of
from radartrack.derive.stable.term_sizes import term_sizes
from radartrack.verification.domain_points import Points
from radartrack.verification.error_in_ulp import SINGLE, in_single
from radartrack.verification.program_compilation import compiled
from radartrack.verification.subject import scale_of

Array = npt.NDArray[np.float64]


def error_in_single(function: Callable[..., Any], quantity: Quantity, points: Points) -> tuple[float, int]:
    """The largest error in ulp of single precision, and at how many points nothing leaves its range.

    The function in double precision, whose own error is some 2^-29 of that, is what it is measured against.
    """
    points = in_single(points)
    count = len(next(iter(points.values()))) if points else 1
    within = _within_range(function, quantity, points, np.arange(count))
    if not within.size:
        return math.nan, 0
    some = {name: values[within] for name, values in points.items()}
    with np.errstate(all="ignore"):
        exact = _values(function, quantity, some)
        found = _values(function, quantity, {name: v.astype(np.float32) for name, v in some.items()})
        scale = _scale(quantity, some, exact)
        wrong = np.where(found == exact, 0.0, np.abs(found - exact) / (np.spacing(scale) * SINGLE))
    return float(np.where(np.isfinite(wrong), wrong, np.inf).max()), int(within.size)


def _within_range(
    function: Callable[..., Any], quantity: Quantity, points: Points, places: npt.NDArray[np.int_]
) -> npt.NDArray[np.int_]:
    """The places at which no operation overflows or underflows; halved until all of a part do or do not."""
    some = {name: values[places].astype(np.float32) for name, values in points.items()}
    try:
        with np.errstate(all="raise"):
            _values(function, quantity, some)
    except FloatingPointError:
        if len(places) == 1:
            return places[:0]
        halves = np.array_split(places, 2)
        return np.concatenate([_within_range(function, quantity, points, half) for half in halves])
    return places


def _values(
    function: Callable[..., Any], quantity: Quantity, points: Mapping[str, npt.NDArray[np.floating[Any]]]
) -> Array:
    named = {symbol.name: points[symbol.name] for symbol in quantity.symbols}
    values = np.asarray(function(**named)).astype(np.float64)
    return np.broadcast_to(values, (len(next(iter(points.values()))) if points else 1, *quantity.shape))


def _scale(quantity: Quantity, points: Points, exact: Array) -> Array:
    """What the entries are measured against, as `error_in_ulp` does."""
    if quantity.scale is None and not quantity.is_difference:
        return scale_of(quantity, exact)
    stated = quantity.scale() if quantity.scale else form_of(quantity).expanded().map(term_sizes)
    return np.broadcast_to(np.abs(compiled(stated, quantity.symbols)(**points)), exact.shape)
