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
AT_ONCE = 64  # blocks, by one thread


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
    fill(lambda some, out: np.matmul(some, matrix, out=out), [full], [products], AT_ONCE)
    if whole < len(flat):
        rest = np.zeros((BLOCK, inner), rows.dtype)
        rest[: len(flat) - whole] = flat[whole:]
        result[whole:] = np.matmul(rest, matrix)[: len(flat) - whole]
    return result.reshape(*shape, columns)
