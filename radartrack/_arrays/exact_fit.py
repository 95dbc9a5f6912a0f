"""Least squares of a polynomial in rational arithmetic, for the samples that floating point cannot decide.

Where observations all but fail to determine a polynomial, rounding may be larger than what does determine it. Then
neither whether they do nor the weights can be had from a factorisation in floating point; both are exact here.
"""

import math
from collections.abc import Sequence
from fractions import Fraction
from typing import NamedTuple

import numpy as np

from radartrack._arrays.validation import RealArray

Row = list[Fraction]


class ExactFit(NamedTuple):
    """Weights of each observation, shape (degree + 1, k), and the covariance for ranges of variance one."""

    range_weights: RealArray
    rate_weights: RealArray
    covariance: RealArray


def exact_fit(
    times: Sequence[Fraction], has_range: Sequence[bool], has_rate: Sequence[bool], degree: int, squared_ratio: Fraction
) -> ExactFit | None:
    """Fit value and derivatives at time zero.

    Args:
        times: of the k scans, counted from the time of the estimate.
        has_range: whether there is a range at each.
        has_rate: whether there is a range rate at each.
        degree: of the polynomial.
        squared_ratio: variance of the range over that of the range rate.

    Returns:
        None where the observations do not determine the polynomial. What is too large for a float is infinite.

    """
    values = [[time**n / math.factorial(n) for n in range(degree + 1)] for time in times]
    rows = [
        *((row, Fraction(1)) for row, seen in zip(values, has_range, strict=True) if seen),
        *(([Fraction(0), *row[:-1]], squared_ratio) for row, seen in zip(values, has_rate, strict=True) if seen),
    ]
    covariance = _inverse(_information(rows, degree + 1))
    if covariance is None:
        return None
    weights = [[weight * _product(line, row) for row, weight in rows] for line in covariance]
    ranges, rates = (np.zeros((degree + 1, len(times))) for _ in range(2))
    split = sum(has_range)
    ranges[:, np.flatnonzero(has_range)] = [[_as_float(entry) for entry in line[:split]] for line in weights]
    rates[:, np.flatnonzero(has_rate)] = [[_as_float(entry) for entry in line[split:]] for line in weights]
    return ExactFit(ranges, rates, np.array([[_as_float(entry) for entry in line] for line in covariance]))


def _information(rows: Sequence[tuple[Row, Fraction]], size: int) -> list[Row]:
    return [[sum((w * row[m] * row[n] for row, w in rows), Fraction(0)) for n in range(size)] for m in range(size)]


def _inverse(matrix: list[Row]) -> list[Row] | None:
    """By elimination, without exchanges, as the matrix is positive semidefinite; None where it is singular."""
    size = len(matrix)
    rows = [[*row, *(Fraction(m == n) for n in range(size))] for m, row in enumerate(matrix)]
    for m in range(size):
        pivot = rows[m][m]
        if not pivot:
            return None
        rows[m] = [entry / pivot for entry in rows[m]]
        for n in range(size):
            if n != m:
                rows[n] = [b - rows[n][m] * a for a, b in zip(rows[m], rows[n], strict=True)]
    return [row[size:] for row in rows]


def _product(first: Row, second: Row) -> Fraction:
    return sum((a * b for a, b in zip(first, second, strict=True)), Fraction(0))


def _as_float(number: Fraction) -> float:
    try:
        return float(number)
    except OverflowError:
        return math.inf if number > 0 else -math.inf
