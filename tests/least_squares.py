"""Least squares of a polynomial in exact rational arithmetic, straight from the normal equations of one sample."""

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from math import factorial

Row = list[Fraction]


@dataclass(frozen=True)
class ExactFit:
    """Covariance for ranges of unit variance, and the weights of every scan."""

    covariance: list[Row]
    range_weights: list[Row]
    rate_weights: list[Row]


def exact_fit(
    times: Sequence[Fraction],
    degree: int,
    *,
    with_range: Sequence[bool],
    with_rate: Sequence[bool],
    squared_ratio: Fraction,
) -> ExactFit:
    """Fit value and derivatives at time 0 to ranges and rates; `squared_ratio` is σ_r²/σ_v² in s²."""
    size = degree + 1
    ranges = [[time**n / Fraction(factorial(n)) for n in range(size)] for time in times]
    rates = [[Fraction(0), *row[:-1]] for row in ranges]
    information = [
        [
            sum(
                (a[m] * a[n] * seen + b[m] * b[n] * squared_ratio * rated
                 for a, b, seen, rated in zip(ranges, rates, with_range, with_rate, strict=True)),
                Fraction(0),
            )
            for n in range(size)
        ]
        for m in range(size)
    ]  # fmt: skip
    covariance = inverse(information)
    return ExactFit(
        covariance,
        [[dot(line, row) * seen for row, seen in zip(ranges, with_range, strict=True)] for line in covariance],
        [[dot(line, row) * squared_ratio * rated for row, rated in zip(rates, with_rate, strict=True)]
         for line in covariance],
    )  # fmt: skip


def full_fit(k: int, degree: int, period: Fraction, squared_ratio: Fraction, lag: Fraction = Fraction(0)) -> ExactFit:
    """The fit of k full scans; without range rate where the ratio is 0."""
    times = [(n - k - lag) * period for n in range(1, k + 1)]
    seen = [True] * k
    return exact_fit(times, degree, with_range=seen, with_rate=seen, squared_ratio=squared_ratio)


def dot(first: Row, second: Row) -> Fraction:
    return sum((a * b for a, b in zip(first, second, strict=True)), Fraction(0))


def inverse(matrix: list[Row]) -> list[Row]:
    """The inverse by elimination; a ZeroDivisionError where the matrix is singular."""
    size = len(matrix)
    rows = [list(row) + [Fraction(m == n) for n in range(size)] for m, row in enumerate(matrix)]
    for m in range(size):
        pivot = next((n for n in range(m, size) if rows[n][m]), m)
        rows[m], rows[pivot] = rows[pivot], rows[m]
        rows[m] = [entry / rows[m][m] for entry in rows[m]]
        for n in range(size):
            if n != m:
                rows[n] = [b - rows[n][m] * a for a, b in zip(rows[m], rows[n], strict=True)]
    return [row[size:] for row in rows]
