"""Cholesky's elimination of many small tables at once, the tracks last, and what follows from its pivots."""

from __future__ import annotations

import numpy as np

from radartrack._arrays.validation import RealArray, require_covariance


def eliminate(table: RealArray) -> None:
    """Make of rows [S | B], (m, m + k, tracks), in place, the upper triangle of [L' | L^-1 B], where S = L L'.

    Of S the upper triangle counts. A pivot that is not positive leaves NaN or infinity on the diagonal.
    """
    size = len(table)
    for k in range(size):
        table[k, k:] *= 1 / np.sqrt(table[k, k])
        table[k + 1 :, k + 1 :] -= table[k, k + 1 : size, np.newaxis] * table[k, k + 1 :]


def pivots(table: RealArray) -> RealArray:
    """The squares on the diagonal of an eliminated table, (m, tracks): what the rows before leave of each variance."""
    size = len(table)
    return np.square(table[np.arange(size), np.arange(size)])


def checked_covariances(name: str, matrices: RealArray) -> RealArray:
    """Covariances (n, n, tracks), symmetric to the last bit.

    One elimination shows it of nearly all; the full check is for those that are singular or asymmetric, or none.

    Raises:
        ValueError: as `require_covariance`.

    """
    if (matrices == matrices.swapaxes(0, 1)).all() and _is_definite(matrices):
        return matrices
    require_covariance(name, np.moveaxis(matrices, -1, 0) if matrices.shape[-1] != 1 else matrices[..., 0])
    upper = np.triu(np.ones(matrices.shape[:2], dtype=bool))[..., np.newaxis]
    return np.where(upper, matrices, matrices.swapaxes(0, 1))


def _is_definite(matrices: RealArray) -> bool:
    """Whether all matrices are finite and, but for rounding, positive definite."""
    table = matrices.copy()
    with np.errstate(over="ignore", invalid="ignore", divide="ignore"):
        eliminate(table)
        return bool((pivots(table) > 0).all())
