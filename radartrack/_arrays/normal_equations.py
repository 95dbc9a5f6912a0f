"""Least squares of a polynomial through ranges and range rates at any times, some of them missing.

These are the normal equations of the finite-sample filter, solved through an orthogonal factorisation of
scaled polynomials. Ranges are counted from their mean, which splits the constant off; of the rest, the more
accurate kind of observation comes first, so that very unequal accuracies do no harm.

Whether a sample determines the polynomial is decided exactly. Too few different times are counted. What floating
point resolves well, against the size before anything cancels, is determined. The rest is solved in rational numbers.
"""

from __future__ import annotations

from fractions import Fraction
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from radartrack._arrays.exact_fit import exact_fit
from radartrack._arrays.validation import RealArray

Mask = NDArray[np.bool_]
WELL_RESOLVED = 1e-6  # rounding leaves 1e-15 of a column that depends on others; a share of 1e-6 keeps nine digits


class Sample(NamedTuple):
    """What is observed when, each of shape (n, k): times, and whether there are a range and a range rate.

    The times do not decrease; they and all that has to do with time may have any unit.
    """

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
        covariance: shape (n, degree + 1, degree + 1), for ranges with a standard deviation of one. What overflows is
            not finite.

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
        sizes: shape (n, degree), what the columns of ranges and rates measure at most before anything cancels.

    """

    ranges: RealArray
    rates: RealArray
    wanted: RealArray
    sizes: RealArray


def solve(sample: Sample, after: float, degree: int, rate_weight: float, unit_of_time: float) -> Solution:
    """Weights and covariance of the estimate of value and derivatives.

    Args:
        sample: what is observed when.
        after: time from the newest scan to the estimate.
        degree: of the polynomial.
        rate_weight: standard deviation of the range over that of the range rate, a time.
        unit_of_time: scale of time where all observations are of one time.

    """
    with np.errstate(over="ignore", under="ignore", invalid="ignore", divide="ignore"):  # then nothing is resolved
        solution = _in_floating_point(sample, after, degree, rate_weight, unit_of_time)
    possible = _has_enough_times(sample, degree)
    doubtful = possible & ~solution.determined
    solution.determined[:] &= possible
    for number in np.flatnonzero(doubtful):
        _solve_exactly(sample, int(number), after, rate_weight, solution)
    return solution


def _has_enough_times(sample: Sample, degree: int) -> Mask:
    """Whether there is a range, and as many different times of ranges and of rates as coefficients: what it takes."""
    ranges, rates = (_different(sample.times, seen) for seen in (sample.has_range, sample.has_rate))
    return np.asarray((ranges > 0) & (ranges + rates > degree))


def _different(times: RealArray, seen: Mask) -> NDArray[np.int64]:
    """The number of different times at which something is seen, shape (n,)."""
    places = np.maximum.accumulate(np.where(seen, np.arange(seen.shape[1]), -1), axis=1)
    before = np.concatenate([np.full((len(seen), 1), -1), places[:, :-1]], axis=1)
    is_new = (before < 0) | (np.take_along_axis(times, np.maximum(before, 0), axis=1) != times)
    return np.asarray((seen & is_new).sum(axis=1))


def _solve_exactly(sample: Sample, number: int, after: float, rate_weight: float, solution: Solution) -> None:
    """Enter the solution of one sample, if it has any."""
    times, has_range, has_rate = (part[number].tolist() for part in sample)
    at = Fraction(times[-1]) + Fraction(after)
    since = [Fraction(time) - at for time in times]
    found = exact_fit(since, has_range, has_rate, solution.covariance.shape[-1] - 1, Fraction(rate_weight) ** 2)
    if found is not None:
        solution.determined[number] = True
        for all_samples, one in zip(solution[1:], found, strict=True):
            all_samples[number] = one


def _in_floating_point(sample: Sample, after: float, degree: int, rate_weight: float, unit_of_time: float) -> Solution:
    """The solutions; determined is what rounding left the digits of."""
    counts = sample.has_range.sum(axis=1)
    basis = _basis(sample, after, degree, rate_weight, unit_of_time)
    by_rate, by_range, resolved = _coefficients(basis, rates_first=rate_weight >= unit_of_time)
    range_weights = basis.wanted @ by_range * sample.has_range[:, np.newaxis]
    rate_weights = basis.wanted @ by_rate * sample.has_rate[:, np.newaxis]
    covariance = _squares(range_weights) + _squares(rate_weights)
    share = 1 / np.maximum(counts, 1)
    covariance[:, 0, 0] += share
    range_weights[:, 0] += share[:, np.newaxis] * sample.has_range
    return Solution(resolved, range_weights, rate_weights * rate_weight, covariance)


def _squares(weights: RealArray) -> RealArray:
    """The products of the rows of each matrix, summed over its columns in one order for every number of matrices."""
    squares: RealArray = (weights[:, :, np.newaxis] * weights[:, np.newaxis]).sum(axis=-1)
    return squares


def _basis(sample: Sample, after: float, degree: int, rate_weight: float, unit_of_time: float) -> _Basis:
    seen = sample.has_range | sample.has_rate
    empty = ~seen.any(axis=1)
    # Beside times of 1e9 s a fraction of a period would be rounded away, and what is seen beside a scan that is missed.
    latest = sample.times.shape[1] - 1 - np.argmax(seen[:, ::-1], axis=1)
    since = sample.times - np.take_along_axis(sample.times, latest[:, np.newaxis], axis=1)
    first = np.where(empty, 0.0, np.where(seen, since, np.inf).min(axis=1))
    last = np.where(empty, 0.0, np.where(seen, since, -np.inf).max(axis=1))
    middle = first / 2 + last / 2
    half = np.where(first == last, unit_of_time, last / 2 - first / 2)
    scaled = (since - middle[:, np.newaxis]) / half[:, np.newaxis]
    values, slopes = (_legendre(scaled, degree, order) for order in (0, 1))
    wanted = [
        _legendre((since[:, -1] + after - middle) / half, degree, order) / half[:, np.newaxis] ** order
        for order in range(degree + 1)
    ]
    counts = sample.has_range.sum(axis=1)[:, np.newaxis]
    mean = (values * sample.has_range[..., np.newaxis]).sum(axis=1) / np.maximum(counts, 1)
    wanted[0] = wanted[0] - mean
    weight = (rate_weight / half)[:, np.newaxis]
    steepest = _legendre(np.ones(()), degree, 1) * weight
    return _Basis(
        (values - mean[:, np.newaxis]) * sample.has_range[..., np.newaxis],
        slopes * weight[..., np.newaxis] * sample.has_rate[..., np.newaxis],
        np.stack(wanted, axis=1),
        np.sqrt(counts + sample.has_rate.sum(axis=1)[:, np.newaxis] * steepest**2),
    )


def _legendre(x: RealArray, degree: int, order: int) -> RealArray:
    """The derivatives of this order of the polynomials of degree 1 to `degree`, along a new last axis."""
    columns = [
        np.polynomial.legendre.legval(x, np.polynomial.legendre.legder(unit, order)) for unit in np.eye(degree + 1)[1:]
    ]
    return np.stack(columns, axis=-1) if columns else np.empty((*x.shape, 0))


def _coefficients(basis: _Basis, *, rates_first: bool) -> tuple[RealArray, RealArray, Mask]:
    """What each rate and each range adds to the coefficients, and whether rounding left them their digits."""
    parts = (basis.rates, basis.ranges) if rates_first else (basis.ranges, basis.rates)
    rows = np.concatenate(parts, axis=1)
    norms = np.sqrt((rows**2).sum(axis=1))
    norms = np.where(norms > 0, norms, 1.0)
    orthogonal, triangular = _factorised(rows / norms[:, np.newaxis])
    pivots = np.abs(np.diagonal(triangular, axis1=1, axis2=2))
    resolved = np.asarray((pivots * norms > WELL_RESOLVED * basis.sizes).all(axis=1))
    triangular = np.where(resolved[:, np.newaxis, np.newaxis], triangular, np.eye(triangular.shape[-1]))
    weights = np.linalg.solve(triangular, np.swapaxes(orthogonal, 1, 2)) / norms[..., np.newaxis]
    first, second = np.split(weights, 2, axis=2)
    return (first, second, resolved) if rates_first else (second, first, resolved)


def _factorised(rows: RealArray) -> tuple[RealArray, RealArray]:
    """The reduced orthogonal factorisation; rows of zeros are added where there are too few."""
    missing = max(rows.shape[2] - rows.shape[1], 0)
    orthogonal, triangular = np.linalg.qr(np.pad(rows, ((0, 0), (0, missing), (0, 0))))
    return orthogonal[:, : rows.shape[1]], triangular
