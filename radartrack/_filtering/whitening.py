"""Measurements with their errors made independent, of variance one; what is missing measures nothing."""

from __future__ import annotations

import math
from collections.abc import Iterator
from itertools import repeat
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from radartrack._arrays import patterns
from radartrack._arrays.validation import RealArray
from radartrack._filtering.factors import Observation, combination, factored


class Sensor(NamedTuple):
    """H and R, and what they are with independent errors of variance one where nothing is missing.

    Attributes:
        matrix: H, (m, n), or (m, n, tracks) where each track has its own.
        noise: R, (m, m), or (m, m, tracks) where each track has its own.
        across: the transpose of the whitening, (m, m, 1 or tracks).
        rows: what is measured then, (m, n, 1 or tracks).

    """

    matrix: RealArray
    noise: RealArray
    across: RealArray
    rows: RealArray


def whitened(values: RealArray, sensor: Sensor) -> Observation:
    """Measurements, (m, tracks), with their errors made independent; a missing one measures nothing."""
    seen = ~np.isnan(values)
    if seen.all():
        return Observation(combination(sensor.across, values[:, np.newaxis]), sensor.rows)
    across = _whitening_of_each(seen, sensor.noise).swapaxes(0, 1)
    present = np.where(seen, values, 0.0)
    return Observation(combination(across, present[:, np.newaxis]), _rows(across, sensor.matrix))


def sensors(matrix: RealArray, noise: RealArray, tracks: tuple[int, ...], scans: int) -> Iterator[Sensor]:
    """The sensor at each scan, the same one where the noise is one matrix."""
    if noise.ndim == 2:
        across = _whitening(np.ones(len(noise), dtype=bool), noise).T[..., np.newaxis]
        yield from repeat(Sensor(matrix, noise, across, _rows(across, matrix)), scans)
        return
    size = len(matrix)
    leading = (1,) if math.prod(noise.shape[:-3]) == 1 else tracks
    spread = np.broadcast_to(
        noise.reshape(1, *noise.shape[-3:]) if leading == (1,) else noise, (*leading, scans, size, size)
    )
    for part in np.moveaxis(spread, -3, 0):
        own = np.ascontiguousarray(np.moveaxis(part.reshape(-1, size, size), 0, -1))
        across = _whitening_of_each(np.ones((size, 1), dtype=bool), own).swapaxes(0, 1)
        yield Sensor(matrix, own, across, _rows(across, matrix))


def independent(values: RealArray, matrix: RealArray, noise: RealArray) -> Observation:
    """Measurements, (m, tracks), of tracks that each have an H, (m, n, tracks), with their errors made independent.

    R is (m, m, tracks or 1), semidefinite but for rounding, as it is where curvature has added far more than there was:
    what others determine of an error counts as what rounding may have been.
    """
    upper, variances = factored(noise)
    told = np.concatenate([values[:, np.newaxis], matrix], axis=1)
    for j in reversed(range(len(told))):
        told[:j] -= upper[:j, np.newaxis, j] * told[j]
    told /= np.sqrt(variances)[:, np.newaxis]
    return Observation(told[:, 0], told[:, 1:])


def _rows(across: RealArray, matrix: RealArray) -> RealArray:
    """What whitened measurements measure, (m, n, tracks or 1)."""
    of_each = matrix if matrix.ndim == 3 else matrix[..., np.newaxis]
    return combination(across[:, :, np.newaxis], of_each[:, np.newaxis])


def _whitening_of_each(seen: NDArray[np.bool_], noise: RealArray) -> RealArray:
    """The whitening of each track, (m, m, tracks), from one noise for all or one for each, (m, m, tracks)."""
    if noise.ndim > 2:
        both = seen[:, np.newaxis] & seen
        return np.where(both, _inverse_roots(np.where(both, noise, np.eye(len(noise))[..., np.newaxis])), 0.0)
    first, which = patterns.distinct(seen.T)
    return np.stack([_whitening(pattern, noise) for pattern in seen.T[first]], axis=-1)[..., which]


def _whitening(seen: NDArray[np.bool_], noise: RealArray) -> RealArray:
    """What makes the errors of the measurements that are seen independent, of variance one; 0 for the others."""
    result = np.zeros_like(noise)
    chosen = np.ix_(seen, seen)
    result[chosen] = _inverse_root(noise[chosen])
    return result


def _inverse_root(noise: RealArray) -> RealArray:
    """Inverses of the Cholesky factors of matrices, (..., m, m)."""
    try:
        return np.linalg.inv(np.linalg.cholesky(noise))
    except np.linalg.LinAlgError:
        raise ValueError("noise must be symmetric and positive definite; got a matrix that is not") from None


def _inverse_roots(noise: RealArray) -> RealArray:
    """The same of matrices with the tracks last, (m, m, tracks), which is faster than to factor them one by one."""
    size = len(noise)
    root, inverse = np.zeros_like(noise), np.zeros_like(noise)
    with np.errstate(invalid="ignore", divide="ignore"):
        for j in range(size):
            for i in range(j, size):
                left = noise[i, j] - (root[i, :j] * root[j, :j]).sum(axis=0)
                root[i, j] = left / root[j, j] if i > j else np.sqrt(left)
            inverse[j, j] = 1
            for k in range(j):
                inverse[j] -= root[j, k] * inverse[k]
            inverse[j] /= root[j, j]
    if not (np.diagonal(root) > 0).all():
        raise ValueError("noise must be symmetric and positive definite; got a matrix that is not")
    return inverse
