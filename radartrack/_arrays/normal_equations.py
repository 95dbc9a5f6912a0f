"""Least squares of a polynomial through ranges and range rates at any times, some of them missing.

These are the normal equations of the finite-sample filter, solved through an orthogonal factorisation of
scaled polynomials. Ranges are counted from their mean, which splits the constant off; of the rest, the more
accurate kind of observation comes first, so that very unequal accuracies do no harm.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from radartrack._arrays.validation import RealArray

Mask = NDArray[np.bool_]
SMALLEST_PIVOT = 1e-11  # rounding leaves 1e-15 of a column that depends on others; C = 1e-12 leaves 1e-7


class Sample(NamedTuple):
    """What is observed when, each of shape (n, k): times [s], and whether there are a range and a range rate."""

    times: RealArray
    has_range: Mask
    has_rate: Mask

    def chosen(self, which: NDArray[np.int64]) -> Sample:
        """Some of the samples, by number."""
        return Sample(self.times[which], self.has_range[which], self.has_rate[which])


class Solution(NamedTuple):
    """Weights for n samples.

    Attributes:
        determined: shape (n,), whether the sample determines the polynomial; the rest holds for those only.
        range_weights: shape (n, degree + 1, k).
        rate_weights: shape (n, degree + 1, k).
        covariance: shape (n, degree + 1, degree + 1), for ranges with a standard deviation of one.

    """

    determined: Mask
    range_weights: RealArray
    rate_weights: RealArray
    covariance: RealArray


class _Basis(NamedTuple):
    """Scaled Legendre polynomials of degree 1 and up, without their mean over the ranges.

    Attributes:
        ranges: shape (n, k, degree), 0 where the range is missing.
        rates: shape (n, k, degree), the derivatives over the standard deviation of the rate, in that of the
            range; 0 where the rate is missing.
        wanted: shape (n, degree + 1, degree), value and derivatives at the time of the estimate.

    """

    ranges: RealArray
    rates: RealArray
    wanted: RealArray


def solve(sample: Sample, at: RealArray, degree: int, rate_weight: float, unit_of_time: float) -> Solution:
    """Weights and covariance of the estimate of value and derivatives.

    Args:
        sample: what is observed when.
        at: times of the estimates [s], shape (n,).
        degree: of the polynomial.
        rate_weight: standard deviation of the range over that of the range rate [s].
        unit_of_time: scale of time [s] where all observations are of one time.

    """
    counts = sample.has_range.sum(axis=1)
    basis = _basis(sample, at, degree, rate_weight, unit_of_time)
    by_rate, by_range, independent = _coefficients(basis, rates_first=rate_weight >= unit_of_time)
    determined = independent & (counts > 0)
    range_weights = basis.wanted @ by_range * sample.has_range[:, np.newaxis]
    rate_weights = basis.wanted @ by_rate * sample.has_rate[:, np.newaxis]
    covariance = _squares(range_weights) + _squares(rate_weights)
    share = 1 / np.maximum(counts, 1)
    covariance[:, 0, 0] += share
    range_weights[:, 0] += share[:, np.newaxis] * sample.has_range
    return Solution(determined, range_weights, rate_weights * rate_weight, covariance)


def _squares(weights: RealArray) -> RealArray:
    """The products of the rows of each matrix, summed over its columns in one order for every number of matrices."""
    squares: RealArray = (weights[:, :, np.newaxis] * weights[:, np.newaxis]).sum(axis=-1)
    return squares


def _basis(sample: Sample, at: RealArray, degree: int, rate_weight: float, unit_of_time: float) -> _Basis:
    seen = sample.has_range | sample.has_rate
    empty = ~seen.any(axis=1)
    first = np.where(empty, 0.0, np.where(seen, sample.times, np.inf).min(axis=1))
    last = np.where(empty, 0.0, np.where(seen, sample.times, -np.inf).max(axis=1))
    middle = first / 2 + last / 2
    half = np.where(first == last, unit_of_time, last / 2 - first / 2)
    scaled = (sample.times - middle[:, np.newaxis]) / half[:, np.newaxis]
    values, slopes = (_legendre(scaled, degree, order) for order in (0, 1))
    wanted = [
        _legendre((at - middle) / half, degree, order) / half[:, np.newaxis] ** order for order in range(degree + 1)
    ]
    counts = np.maximum(sample.has_range.sum(axis=1), 1)[:, np.newaxis]
    mean = (values * sample.has_range[..., np.newaxis]).sum(axis=1) / counts
    wanted[0] = wanted[0] - mean
    return _Basis(
        (values - mean[:, np.newaxis]) * sample.has_range[..., np.newaxis],
        slopes * (rate_weight / half)[:, np.newaxis, np.newaxis] * sample.has_rate[..., np.newaxis],
        np.stack(wanted, axis=1),
    )


def _legendre(x: RealArray, degree: int, order: int) -> RealArray:
    """The derivatives of this order of the polynomials of degree 1 to `degree`, along a new last axis."""
    columns = [
        np.polynomial.legendre.legval(x, np.polynomial.legendre.legder(unit, order)) for unit in np.eye(degree + 1)[1:]
    ]
    return np.stack(columns, axis=-1) if columns else np.empty((*x.shape, 0))


def _coefficients(basis: _Basis, *, rates_first: bool) -> tuple[RealArray, RealArray, Mask]:
    """What each rate and each range adds to the coefficients, and whether all coefficients are determined."""
    parts = (basis.rates, basis.ranges) if rates_first else (basis.ranges, basis.rates)
    rows = np.concatenate(parts, axis=1)
    norms = np.sqrt((rows**2).sum(axis=1))
    norms = np.where(norms > 0, norms, 1.0)
    orthogonal, triangular = _factorised(rows / norms[:, np.newaxis])
    pivots = np.abs(np.diagonal(triangular, axis1=1, axis2=2))
    independent = np.asarray((pivots > SMALLEST_PIVOT).all(axis=1))
    triangular = np.where(independent[:, np.newaxis, np.newaxis], triangular, np.eye(triangular.shape[-1]))
    weights = np.linalg.solve(triangular, np.swapaxes(orthogonal, 1, 2)) / norms[..., np.newaxis]
    first, second = np.split(weights, 2, axis=2)
    return (first, second, independent) if rates_first else (second, first, independent)


def _factorised(rows: RealArray) -> tuple[RealArray, RealArray]:
    """The reduced orthogonal factorisation; rows of zeros are added where there are too few."""
    missing = max(rows.shape[2] - rows.shape[1], 0)
    orthogonal, triangular = np.linalg.qr(np.pad(rows, ((0, 0), (0, missing), (0, 0))))
    return orthogonal[:, : rows.shape[1]], triangular
