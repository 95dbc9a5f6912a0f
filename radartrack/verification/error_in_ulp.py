"""Errors of generated code in units of the last place, against 50-digit arithmetic."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
import numpy.typing as npt

from radartrack.derive.evaluation.many_digits import Evaluator
from radartrack.derive.language.quantity import Quantity
from radartrack.derive.language.tensor import Tensor, indices
from radartrack.derive.stable.quantity_form import form_of
from radartrack.derive.stable.term_sizes import term_sizes
from radartrack.derive.symbolic import Expr, Symbol
from radartrack.verification.domain_points import Points

Norm = Callable[[list[float]], float]
SINGLE = 2.0**29  # ulp of double precision in one of single precision
Exact = Callable[[Tensor[Expr], Sequence[Symbol]], Callable[[Sequence[float]], Tensor[Any]]]


class Yardstick:
    """The exact entries of a quantity at some points, and what errors of them are measured against.

    A variance is measured against itself, a covariance against √(c_ii c_jj), any other entry against the norm
    of the entries that share its unit, and an entry of a difference against the sizes of its terms. A scale
    that the quantity states goes before all of these.

    Attributes:
        exact: at each point the entries, in row-major order.
        scales: likewise.
    """

    def __init__(self, quantity: Quantity, points: Points, exact_arithmetic: Exact = Evaluator) -> None:
        evaluator = exact_arithmetic(quantity.expression, quantity.symbols)
        columns = [points[symbol.name].tolist() for symbol in quantity.symbols]
        rows = list(zip(*columns, strict=True)) if columns else [()]
        scales = _scales(quantity, exact_arithmetic)
        self.exact = [evaluator(row).entries for row in rows]
        self.scales = [scales(row, values) for row, values in zip(rows, self.exact, strict=True)]

    def errors(self, computed: npt.NDArray[np.float64]) -> npt.NDArray[np.float64]:
        """The errors of computed entries in ulp of their scales; both of shape (points, entries)."""
        rows = zip(computed.tolist(), self.exact, self.scales, strict=True)
        return np.array([list(map(_ulps, *row)) for row in rows])


def errors(
    function: Callable[..., Any], quantity: Quantity, points: Points, exact_arithmetic: Exact = Evaluator
) -> npt.NDArray[np.float64]:
    """The largest error of any entry at each point, in ulp of what `Yardstick` measures it against."""
    computed = np.asarray(function(**points), dtype=np.float64).reshape(-1, math.prod(quantity.shape))
    return np.asarray(Yardstick(quantity, points, exact_arithmetic).errors(computed).max(axis=-1))


def in_single(points: Points) -> Points:
    """The points that single precision has closest to these."""
    return {name: values.astype(np.float32).astype(np.float64) for name, values in points.items()}


def _scales(quantity: Quantity, exact_arithmetic: Exact) -> Callable[[tuple[float, ...], tuple[Any, ...]], list[float]]:
    """What the entries are measured against, as a function of the point and the exact values there."""
    if quantity.scale is not None or quantity.is_difference:
        stated = quantity.scale() if quantity.scale else form_of(quantity).expanded().map(term_sizes)
        evaluator = exact_arithmetic(stated, quantity.symbols)
        return lambda row, _: [float(value) for value in evaluator(row)]
    groups, norm = peers(quantity), _geometric_mean if quantity.is_covariance else _euclidean

    def scales(_: tuple[float, ...], exact: tuple[Any, ...]) -> list[float]:
        magnitudes = [abs(float(value)) for value in exact]
        return [norm([magnitudes[n] for n in group]) for group in groups]

    return scales


def peers(quantity: Quantity) -> list[list[int]]:
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


def _ulps(computed: float, exact: Any, scale: float) -> float:
    if not math.isfinite(computed):
        return math.inf
    difference = float(abs(exact - computed))
    if difference == 0:
        return 0.0
    return math.inf if scale == 0 else difference / math.ulp(scale)
