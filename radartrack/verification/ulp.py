"""Errors of generated code in units of the last place, against 50-digit arithmetic."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import mpmath
import numpy as np

from radartrack.derive.evaluation import Evaluator
from radartrack.derive.forms import form_of
from radartrack.derive.quantity import Quantity
from radartrack.derive.tensor import Index, Tensor
from radartrack.derive.term_sizes import term_sizes
from radartrack.verification.sampling import Points


def errors(
    function: Callable[..., Any], quantity: Quantity, points: Points
) -> np.ndarray[Any, np.dtype[np.float64]]:
    """The largest error of any entry at each point, in ulp of what the entry is measured against.

    A variance is measured against itself, a covariance against √(c_ii c_jj), any other entry against the norm
    of the entries that share its unit, and an entry of a difference against the sizes of its terms.
    """
    computed = np.asarray(function(**points), dtype=np.float64).reshape(-1, *quantity.shape)
    evaluator = Evaluator(quantity.expression, quantity.symbols)
    scales = _scales(quantity)
    columns = [points[symbol.name].tolist() for symbol in quantity.symbols]
    rows = zip(*columns, strict=True) if columns else [()]
    exact = ((row, evaluator(row)) for row in rows)
    return np.array([_error(computed[n], value, scales(row, value)) for n, (row, value) in enumerate(exact)])


def _error(computed: Any, exact: Tensor[Any], scales: Tensor[float]) -> float:
    entries = zip(exact.items(), scales, strict=True)
    return max(
        _ulps(computed[index] if index else computed, value, scale) for (index, value), scale in entries
    )


def _scales(quantity: Quantity) -> Callable[[tuple[float, ...], Tensor[Any]], Tensor[float]]:
    """What the entries are measured against, as a function of the point and the exact values there."""
    if quantity.is_difference:
        sizes = Evaluator(form_of(quantity).expanded().map(term_sizes), quantity.symbols)
        return lambda row, _: sizes(row).map(float)
    return lambda _, exact: Tensor.build(
        exact.shape, lambda *index: _scale(quantity, index, dict(exact.items()))
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
