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
        across = _whitening_of_each(np.ones((len(noise), 1), dtype=bool), noise).swapaxes(0, 1)
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
    """Measurements, (m, tracks), of tracks that each have an H, (m, n, tracks), with their errors made independent."""
    told = np.concatenate([values[:, np.newaxis], matrix], axis=1)
    _make_independent(told, noise)
    return Observation(told[:, 0], told[:, 1:])


def _rows(across: RealArray, matrix: RealArray) -> RealArray:
    """What whitened measurements measure, (m, n, tracks or 1)."""
    of_each = matrix if matrix.ndim == 3 else matrix[..., np.newaxis]
    return combination(across[:, :, np.newaxis], of_each[:, np.newaxis])


def _whitening_of_each(seen: NDArray[np.bool_], noise: RealArray) -> RealArray:
    """The whitening of each track, (m, m, tracks), from one noise for all or one for each, (m, m, tracks)."""
    if noise.ndim > 2:
        return _whitening(seen, noise)
    first, which = patterns.distinct(seen.T)
    return _whitening(seen[:, first], noise[..., np.newaxis])[..., which]


def _whitening(seen: NDArray[np.bool_], noise: RealArray) -> RealArray:
    """What makes the errors of the measurements that are seen independent, of variance one; 0 for the others."""
    both = seen[:, np.newaxis] & seen
    alone = np.eye(len(noise), dtype=noise.dtype)[..., np.newaxis]
    errors = np.where(both, noise, alone)
    found = np.zeros_like(errors) + alone
    _make_independent(found, errors)
    return np.where(both, found, 0)


def _make_independent(told: RealArray, noise: RealArray) -> None:
    """Combine what is told, (m, k, tracks), in place, so that its errors are independent, of variance one.

    R is (m, m, tracks or 1), semidefinite but for rounding, as it is for errors that are one, and where curvature has
    added far more than there was: what others determine of an error counts as what rounding may have been.
    """
    upper, variances = factored(noise)
    for j in reversed(range(len(told))):
        told[:j] -= upper[:j, np.newaxis, j] * told[j]
    told /= np.sqrt(variances)[:, np.newaxis]
