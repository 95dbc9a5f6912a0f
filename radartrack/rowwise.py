"""Products of many rows with one matrix, each row with the same bits however many rows there are.

BLAS picks its order of summation by the shape of the whole product, so a row alone and the same row among a
million may differ in the last place. Blocks of one shape are all treated alike.
"""

from __future__ import annotations

import math

import numpy as np

from radartrack.batches import fill
from radartrack.validation import RealArray

BLOCK = 256
AT_ONCE = 32  # blocks, by one thread
FEW = 3  # columns; BLAS takes fewer than four one by one in two thirds of the time


def rowwise_product(rows: RealArray, matrix: RealArray) -> RealArray:
    """Multiply rows, shape (..., k), with a matrix, shape (k, m).

    Returns:
        Shape (..., m).

    """
    *shape, inner = rows.shape
    if rows.strides[-1] != rows.itemsize:
        rows = np.ascontiguousarray(rows)
    flat = rows.reshape(math.prod(shape), inner)
    blocks, columns = len(flat) // BLOCK, matrix.shape[1]
    whole = blocks * BLOCK
    result = np.empty((len(flat), columns), rows.dtype)
    full = flat[:whole].reshape(blocks, BLOCK, inner)
    products = result[:whole].reshape(blocks, BLOCK, columns)
    fill(lambda some, out: _multiply(some, matrix, out), [full], [products], AT_ONCE)
    if whole < len(flat):
        rest, last = np.zeros((1, BLOCK, inner), rows.dtype), np.empty((1, BLOCK, columns), rows.dtype)
        rest[0, : len(flat) - whole] = flat[whole:]
        _multiply(rest, matrix, last)
        result[whole:] = last[0, : len(flat) - whole]
    return result.reshape(*shape, columns)


def _multiply(blocks: RealArray, matrix: RealArray, out: RealArray) -> None:
    if matrix.shape[1] > FEW:
        np.matmul(blocks, matrix, out=out)
        return
    columns = np.ascontiguousarray(matrix.T)[:, :, np.newaxis]
    np.matmul(blocks[:, np.newaxis], columns, out=out.transpose(0, 2, 1)[..., np.newaxis])
