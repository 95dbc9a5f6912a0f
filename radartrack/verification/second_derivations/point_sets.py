"""A few weighted points in the plane whose sums are given numbers, and straight lines among them by definition.

Sums are linear in the weights, so that these may be negative: six points with the right sums of degree two stand for
any number of points. Nothing is symbolic; numbers have many digits.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import mpmath

from radartrack.derive import symbolic as sp
from radartrack.verification.second_derivations.power_series import Jet, jets

Number = Any
PX, PY, K, D = (sp.Symbol(name, real=True) for name in ("point_x", "point_y", "slope", "intercept"))


def squared_distance(x: Any, y: Any, slope: Any, intercept: Any) -> Any:
    """Of a point from the foot of its perpendicular on a line, of numbers or of symbols."""
    along = (x + slope * (y - intercept)) / (1 + slope**2)
    return (x - along) ** 2 + (y - intercept - slope * along) ** 2


SQUARED = squared_distance(PX, PY, K, D)


@dataclass(frozen=True)
class WeightedPoint:
    """One point of the plane and how often it counts."""

    weight: Number
    x: Number
    y: Number

    def from_line(self, slope: Number, intercept: Number, degree: int) -> Jet:
        """The weighted square of the distance, as a power series in changes of slope and intercept."""
        at = {PX: self.x, PY: self.y, K: slope, D: intercept}
        return jets([SQUARED], at, (K, D), degree)[0].scaled(self.weight)


def points_with(sums: Mapping[str, Number]) -> list[WeightedPoint]:
    """Points whose sums are these: W, mean_x, mean_y, S_xx, S_xy, S_yy; what is not given is 1 or, for means, 0."""
    given = {"W": 1, "mean_x": 0, "mean_y": 0, "S_xx": 1, "S_xy": 0, "S_yy": 1} | dict(sums)
    both = mpmath.mpf(given["S_xy"]) / 2
    along_x, along_y = mpmath.mpf(given["S_xx"]) / 2 - both, mpmath.mpf(given["S_yy"]) / 2 - both
    pairs = [(along_x, 1, 0), (along_y, 0, 1), (both, 1, 1)]
    rest = given["W"] - 2 * (along_x + along_y + both)
    around = [(weight, side * x, side * y) for weight, x, y in pairs for side in (-1, 1)]
    return [WeightedPoint(w, given["mean_x"] + x, given["mean_y"] + y) for w, x, y in (*around, (rest, 0, 0))]


def objective(points: Sequence[WeightedPoint], slope: Number, intercept: Number, degree: int = 0) -> Jet:
    """The weighted sum of squared distances, as a power series in changes of slope and intercept."""
    first, *rest = (point.from_line(slope, intercept, degree) for point in points)
    return sum(rest, first)


def principal_axis(points: Sequence[WeightedPoint]) -> tuple[Number, Number, Number]:
    """The direction in which points about the origin scatter most, to the right; and how little they scatter across."""
    scatter = mpmath.matrix(2, 2)
    for point in points:
        place = mpmath.matrix([point.x, point.y])
        scatter += point.weight * place * place.T
    values, vectors = mpmath.eigsy(scatter)
    x, y = (vectors[i, 1] for i in range(2))
    return (x, y, values[0]) if x > 0 else (-x, -y, values[0])


@dataclass(frozen=True)
class OrdinaryFit:
    """The line of least squares along y, by its normal equations."""

    points: Sequence[WeightedPoint]

    @property
    def information(self) -> Any:
        """Σ w (1, x)ᵀ (1, x)."""
        total = mpmath.matrix(2, 2)
        for point in self.points:
            total += point.weight * _row(point.x) * _row(point.x).T
        return total

    @property
    def intercept_and_slope(self) -> Any:
        """The solution of the normal equations."""
        right = mpmath.matrix(2, 1)
        for point in self.points:
            right += point.weight * point.y * _row(point.x)
        return mpmath.lu_solve(self.information, right)

    @property
    def residual_squares(self) -> Number:
        """Their weighted sum."""
        line = self.intercept_and_slope
        return sum(point.weight * (point.y - (_row(point.x).T * line)[0]) ** 2 for point in self.points)

    def leverage(self, x: Number) -> Number:
        """What the fitted line at x changes by when an observation there does."""
        return (_row(x).T * mpmath.lu_solve(self.information, _row(x)))[0]

    @property
    def degrees_of_freedom(self) -> Number:
        """The trace of one less the hat matrix."""
        return sum(point.weight * (1 - self.leverage(point.x)) for point in self.points)


def _row(x: Number) -> Any:
    return mpmath.matrix([1, x])
