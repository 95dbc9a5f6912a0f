"""Errors of generated code in units of the last place, against 50-digit arithmetic."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import mpmath
import numpy as np

from radartrack.derive.evaluation import Evaluator
from radartrack.derive.quantity import Quantity
from radartrack.derive.tensor import Index, Tensor
from radartrack.verification.sampling import Points


def errors(function: Callable[..., Any], quantity: Quantity, points: Points) -> np.ndarray[Any, np.dtype[np.float64]]:
    """The largest error of any entry at each point, in ulp of what the entry is measured against.

    A variance is measured against itself, a covariance against √(c_ii c_jj), any other entry against the norm of the
    entries that share its unit.
    """
    computed = np.asarray(function(**points), dtype=np.float64).reshape(-1, *quantity.shape)
    evaluator = Evaluator(quantity.expression, quantity.symbols)
    columns = [points[symbol.name].tolist() for symbol in quantity.symbols]
    rows = zip(*columns, strict=True) if columns else [()]
    return np.array([_error(quantity, computed[n], evaluator(row)) for n, row in enumerate(rows)])


def _error(quantity: Quantity, computed: Any, exact: Tensor[Any]) -> float:
    by_index = dict(exact.items())
    return max(
        _ulps(computed[index] if index else computed, value, _scale(quantity, index, by_index))
        for index, value in by_index.items()
    )


def _scale(quantity: Quantity, index: Index, exact: dict[Index, Any]) -> float:
    if quantity.is_covariance:
        first, second = index
        return float(mpmath.sqrt(abs(exact[first, first] * exact[second, second])))
    unit = quantity.unit(index)
    alike = (value for other, value in exact.items() if quantity.unit(other) == unit)
    return float(mpmath.sqrt(sum(value * value for value in alike)))


def _ulps(computed: float, exact: Any, scale: float) -> float:
    if not math.isfinite(computed):
        return math.inf
    difference = abs(mpmath.mpf(float(computed)) - exact)
    if difference == 0:
        return 0.0
    return math.inf if scale == 0 else float(difference / math.ulp(scale))
