"""Covariances of many tracks in factors (Bierman 1977), component by component."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from radartrack._arrays.validation import RealArray


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
    variances = np.zeros_like(covariance[0])
    for j in reversed(range(size)):
        rounding = size * np.finfo(covariance.dtype).eps * covariance[j, j]
        kept = rest[j, j] > rounding
        variances[j] = np.where(kept, rest[j, j], rounding)
        upper[:j, j] = np.where(kept, rest[:j, j], 0) / np.where(kept, rest[j, j], 1)
        upper[j, j] = 1
        rest[:j, :j] -= upper[:j, j] * upper[:j, np.newaxis, j] * variances[j]
    return upper, variances


def product_of(columns: RealArray, variances: RealArray) -> RealArray:
    """Columns times variances times the columns transposed: a sum of squares, symmetric to the last bit."""
    roots = np.moveaxis(columns * np.sqrt(variances), 1, 0)
    return combination(roots[:, np.newaxis], roots[:, :, np.newaxis])


def combination(coefficients: RealArray, parts: RealArray) -> RealArray:
    """The sum of coefficient times part along the first axis, always in the same order."""
    total: RealArray = coefficients[0] * parts[0]
    for coefficient, part in zip(coefficients[1:], parts[1:], strict=True):
        total += coefficient * part
    return total
