"""Covariances of many tracks in factors (Bierman 1977), component by component."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from radartrack._arrays.validation import RealArray
from radartrack._conversion.semidefinite import roots
from radartrack._filtering.elimination import eliminate, pivots


class Observation(NamedTuple):
    """Independent measurements of variance one: values (m, tracks), and what they measure, (m, n, tracks or 1)."""

    values: RealArray
    rows: RealArray


def updated(mean: RealArray, covariance: RealArray, observation: Observation) -> tuple[RealArray, RealArray]:
    """The belief after independent measurements of variance one, taken one by one; so no matrix is inverted."""
    factors = factored(covariance)
    for value, row in zip(*observation, strict=True):
        gain, factors = _measured(factors, row)
        mean = mean + gain * (value - combination(row, mean))
    told = (observation.rows != 0).any(axis=(0, 1))  # what measures nothing leaves the last bit as it was
    return mean, np.where(told, product_of(*factors), covariance)


def _measured(factors: tuple[RealArray, RealArray], row: RealArray) -> tuple[RealArray, tuple[RealArray, RealArray]]:
    """The gain of a measurement of variance one, and the factors after it (Bierman 1977, V.3).

    Differences of covariances, in the form of Joseph too, turn negative where the measurement is better than what was
    believed by as many digits as a float has.
    """
    upper, variances = factors
    along = combination(row[:, np.newaxis], upper)
    weighted = variances * along
    gain, total = np.zeros_like(weighted), np.ones_like(weighted[0])
    columns, reduced = [], []
    for place, column in enumerate(np.moveaxis(upper, 1, 0)):
        before, total = total, total + along[place] * weighted[place]
        reduced.append(variances[place] * (before / total))
        columns.append(column - gain * (along[place] / before))
        gain = gain + column * weighted[place]
    return gain / total, (np.stack(columns, axis=1), np.stack(reduced))


def factored(covariance: RealArray) -> tuple[RealArray, RealArray]:
    """Columns U, upper triangular with a diagonal of ones, and variances D with U D U' the covariance.

    Where others determine a component but for rounding, its own variance counts as what rounding may have been: so
    nothing is believed better than the covariance can say.
    """
    size = len(covariance)
    upper, rest = np.zeros_like(covariance), covariance.copy()
    variances, lost = np.zeros_like(covariance[0]), np.zeros(covariance.shape[2:], dtype=bool)
    share = size * float(np.finfo(covariance.dtype).eps)
    for j in reversed(range(size)):
        rounding = share * covariance[j, j]
        kept = rest[j, j] > rounding
        if not kept.all():
            lost |= ~kept & _is_more_than_rounding(rest[: j + 1, j], covariance, share)
        variances[j] = np.where(kept, rest[j, j], rounding)
        upper[:j, j] = np.where(kept, rest[:j, j], 0) / np.where(kept, rest[j, j], 1)
        upper[j, j] = 1
        rest[:j, :j] -= upper[:j, j] * (upper[:j, np.newaxis, j] * variances[j])
    if lost.any():
        lost &= np.isfinite(covariance).all(axis=(0, 1))  # what overflowed is refused in the result
        upper[..., lost], variances[..., lost] = _factored_by_root(covariance[..., lost], share)
    return upper, variances


def _is_more_than_rounding(column: RealArray, covariance: RealArray, share: float) -> NDArray[np.bool_]:
    """Whether an elimination has left more beside a variance that it took for nothing, or less than nothing of it.

    A pivot that is itself little more than rounding may leave that: nearly all of another variance goes with it.
    """
    j = len(column) - 1
    deviations = np.sqrt(np.stack([covariance[i, i] for i in range(len(column))]))
    return np.asarray((np.abs(column) > share * deviations * deviations[j]).any(axis=0))


def _factored_by_root(covariance: RealArray, share: float) -> tuple[RealArray, RealArray]:
    """The same by eigenvalues, in which all of a covariance is right to rounding, for (n, n, tracks).

    Each component gets a share of its variance more, independent of the others: what rounding may have been.
    """
    first = np.moveaxis(covariance, -1, 0)
    more = np.sqrt(share * np.diagonal(first, axis1=1, axis2=2))[:, np.newaxis] * np.eye(len(covariance))
    rows = np.concatenate([np.swapaxes(roots(first), 1, 2), more], axis=1).astype(first.dtype)
    triangle = np.asarray(np.linalg.qr(rows[..., ::-1], mode="r"))
    columns = np.moveaxis(triangle[..., ::-1, ::-1], 0, -1).swapaxes(0, 1)  # upper, and it times its transpose is P
    places = range(len(covariance))
    scale = columns[places, places]
    upper = columns / np.where(scale == 0, 1, scale)
    upper[places, places] = 1
    return upper, scale**2


def product_of(columns: RealArray, variances: RealArray) -> RealArray:
    """Columns times variances times the columns transposed: a sum of squares, symmetric to the last bit."""
    roots = np.moveaxis(columns * np.sqrt(variances), 1, 0)
    return combination(roots[:, np.newaxis], roots[:, :, np.newaxis])


def widened(covariance: RealArray, dtype: np.dtype[np.floating[Any]]) -> RealArray:
    """Covariances (n, n, tracks) in a type: what is one to the rounding of float32 becomes one to that of float64."""
    wide = covariance.astype(dtype, copy=False)
    if covariance.dtype == dtype:
        return wide
    table = wide.copy()
    with np.errstate(invalid="ignore", divide="ignore"):
        eliminate(table)
        definite = (pivots(table) > 0).all(axis=0)
    return wide if definite.all() else np.where(definite, wide, product_of(*factored(wide)))


def combination(coefficients: RealArray, parts: RealArray) -> RealArray:
    """The sum of coefficient times part along the first axis, always in the same order."""
    total: RealArray = coefficients[0] * parts[0]
    for coefficient, part in zip(coefficients[1:], parts[1:], strict=True):
        total += coefficient * part
    return total
