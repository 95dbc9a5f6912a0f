"""Finite-sample filters by exact least squares: matrices of fractions, summed scan by scan and inverted.

The design is written about the time of the estimate itself, whatever its lag; no sum is closed, nothing is symbolic.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from math import factorial
from typing import Any

import mpmath

from radartrack.derive.language.tensor import Tensor

Matrix = list[list[Fraction]]
Number = Any
FILTER = re.compile(r"degree(?P<degree>\d+)\.(?P<observed>range|range_rate)\.(?P<lag>at_lag\.)?(?P<what>\w+)")
GAIN = re.compile(r"degree(?P<degree>\d+)\.(?P<what>gain|range_gain_of_perfect_rate)")


@dataclass(frozen=True)
class LeastSquares:
    """One filter with the numbers of one point."""

    degree: int
    with_rate: bool
    at: Mapping[str, Fraction]

    @property
    def size(self) -> int:
        """The number of components of the state."""
        return self.degree + 1

    @property
    def scans(self) -> int:
        """How many there are."""
        return int(self.at["k"])

    def rows(self, scan: Fraction | int) -> Matrix:
        """What the state at the time of the estimate says of the observations of a scan."""
        time = (Fraction(scan) - self.at["k"] - self.at.get("tau", Fraction(0))) * self.at["T"]
        ranges = [time**n / factorial(n) for n in range(self.size)]
        return [ranges, [Fraction(0), *ranges[:-1]]][: 1 + self.with_rate]

    @property
    def precisions(self) -> list[Fraction]:
        """The inverse variances of range and range rate; for weights and shapes the range's variance is one."""
        inverse = 1 / self.at.get("sigma_r", Fraction(1)) ** 2
        return [inverse, *([inverse * self.at["C"] * self.at["T"] ** 2] if self.with_rate else [])]

    @cached_property
    def information(self) -> Matrix:
        """Q, summed over the scans."""
        total = [[Fraction(0)] * self.size for _ in range(self.size)]
        for scan in range(1, self.scans + 1):
            for row, precision in zip(self.rows(scan), self.precisions, strict=True):
                for m in range(self.size):
                    for n in range(self.size):
                        total[m][n] += row[m] * row[n] * precision
        return total

    @cached_property
    def covariance(self) -> Matrix:
        """Q⁻¹."""
        return inverse(self.information)

    def weights(self, observation: int) -> list[Fraction]:
        """What one observation of scan j adds to each component."""
        row, precision = self.rows(self.at["j"])[observation], self.precisions[observation]
        return [
            sum((r * h for r, h in zip(line, row, strict=True)), Fraction(0)) * precision for line in self.covariance
        ]


def inverse(matrix: Matrix) -> Matrix:
    """By elimination; exact."""
    size = len(matrix)
    work = [[*row, *(Fraction(int(m == n)) for n in range(size))] for m, row in enumerate(matrix)]
    for column in range(size):
        pivot = next(m for m in range(column, size) if work[m][column])
        work[column], work[pivot] = work[pivot], work[column]
        work[column] = [entry / work[column][column] for entry in work[column]]
        for m in range(size):
            if m != column:
                factor = work[m][column]
                work[m] = [a - factor * b for a, b in zip(work[m], work[column], strict=True)]
    return [row[size:] for row in work]


def _square(matrix: Matrix) -> Tensor[Number]:
    return Tensor((len(matrix), len(matrix[0])), tuple(_number(entry) for row in matrix for entry in row))


def _vector(entries: list[Fraction]) -> Tensor[Number]:
    return Tensor((len(entries),), tuple(_number(entry) for entry in entries))


def _number(value: Fraction) -> Number:
    return mpmath.mpf(value.numerator) / value.denominator


def _root(value: Fraction) -> Number:
    return mpmath.sqrt(_number(value))


def _precision(of: LeastSquares) -> Tensor[Number]:
    size = len(of.precisions)
    return Tensor.build((size, size), lambda a, b: _number(of.precisions[a] if a == b else Fraction(0)))


def _correlation(of: LeastSquares) -> Tensor[Number]:
    matrix = of.covariance
    return Tensor.build((of.size, of.size), lambda m, n: _number(matrix[m][n]) / _root(matrix[m][m] * matrix[n][n]))


QUANTITIES: dict[str, Callable[[LeastSquares], Tensor[Number]]] = {
    "design": lambda of: _square(of.rows(of.at["j"])),
    "precision": _precision,
    "information": lambda of: _square(of.information),
    "covariance": lambda of: _square(of.covariance),
    "correlation": _correlation,
    "range_weights": lambda of: _vector(of.weights(0)),
    "rate_weights": lambda of: _vector(of.weights(1)),
}


def least_squares(row: str, point: Mapping[str, float]) -> Tensor[Number] | None:
    """The quantity of a row of `finite_sample` at a point; None for a row that is not known."""
    at = {"T": Fraction(1)} | {name: Fraction(value) for name, value in point.items()}
    if row == "C":
        return Tensor((), (_number(at["sigma_r"] ** 2 / (at["T"] * at["sigma_v"]) ** 2),))
    if found := GAIN.fullmatch(row):
        return _gain(int(found["degree"]), at, perfect=found["what"] != "gain")
    found = FILTER.fullmatch(row)
    if found is None or found["what"] not in QUANTITIES:
        return None
    return QUANTITIES[found["what"]](LeastSquares(int(found["degree"]), found["observed"] == "range_rate", at))


def _gain(degree: int, at: Mapping[str, Fraction], *, perfect: bool) -> Tensor[Number]:
    """1 − √(variance with range rates / variance without); errorless rates leave the mean of the ranges."""
    without = LeastSquares(degree, with_rate=False, at=at).covariance
    if perfect:
        return Tensor((), (1 - _root(1 / at["k"] / without[0][0]),))
    with_rates = LeastSquares(degree, with_rate=True, at=at).covariance
    return Tensor.build((degree + 1,), lambda m: 1 - _root(with_rates[m][m] / without[m][m]))
