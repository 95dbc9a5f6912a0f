"""Errors of generated code in units of the last place, against 50-digit arithmetic."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import mpmath
import numpy as np
import numpy.typing as npt

from radartrack.derive.evaluation import Evaluator
from radartrack.derive.quantity import Quantity
from radartrack.derive.tensor import indices
from radartrack.verification.sampling import Points

Norm = Callable[[list[float]], float]


def errors(function: Callable[..., Any], quantity: Quantity, points: Points) -> npt.NDArray[np.float64]:
    """The largest error of any entry at each point, in ulp of what the entry is measured against.

    A variance is measured against itself, a covariance against √(c_ii c_jj), any other entry against the norm of the
    entries that share its unit.
    """
    computed = np.asarray(function(**points), dtype=np.float64)
    flat = computed.reshape(computed.shape[0], -1).tolist()
    evaluator = Evaluator(quantity.expression, quantity.symbols)
    rows = zip(*(points[symbol.name].tolist() for symbol in quantity.symbols), strict=True)
    peers, norm = _peers(quantity), _geometric_mean if quantity.is_covariance else _euclidean
    return np.array(
        [_error(found, evaluator(row).entries, peers, norm) for found, row in zip(flat, rows, strict=True)]
    )


def _peers(quantity: Quantity) -> list[list[int]]:
    """For each entry the positions of the entries that make its scale."""
    positions = {index: n for n, index in enumerate(indices(quantity.shape))}
    if quantity.is_covariance:
        return [[positions[i, i], positions[j, j]] for i, j in positions]
    alike: dict[Any, list[int]] = {}
    for index, position in positions.items():
        alike.setdefault(quantity.unit(index), []).append(position)
    return [alike[quantity.unit(index)] for index in positions]


def _euclidean(magnitudes: list[float]) -> float:
    return math.hypot(*magnitudes)


def _geometric_mean(magnitudes: list[float]) -> float:
    return math.sqrt(magnitudes[0]) * math.sqrt(magnitudes[1])


def _error(computed: list[float], exact: tuple[Any, ...], peers: list[list[int]], norm: Norm) -> float:
    magnitudes = [abs(float(value)) for value in exact]
    return max(
        _ulps(found, value, norm([magnitudes[n] for n in group]))
        for found, value, group in zip(computed, exact, peers, strict=True)
    )


def _ulps(computed: float, exact: Any, scale: float) -> float:
    if not math.isfinite(computed):
        return math.inf
    difference = float(abs(mpmath.mpf(computed) - exact))
    if difference == 0:
        return 0.0
    return math.inf if scale == 0 else difference / math.ulp(scale)
