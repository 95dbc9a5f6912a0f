"""Products of many rows with one matrix, each row with the same bits however many rows there are.

BLAS picks its order of summation by the shape of the whole product, so a row alone and the same row among a
million may differ in the last place. Blocks of one shape are all treated alike.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from radartrack.batches import fill
from radartrack.validation import RealArray

BLOCK = 256
AT_ONCE = 32  # blocks, by one thread
FEW = 3  # columns; BLAS takes fewer than four one by one in two thirds of the time


class Product(NamedTuple):
    """Rows times a matrix, and whether what shows in fewer numbers is finite: all rows or all products."""

    values: RealArray
    is_finite: bool


def rowwise_product(rows: RealArray, matrix: RealArray) -> Product:
    """Multiply rows, shape (..., k), with a matrix, shape (k, m).

    Returns:
        Shape (..., m).

    """
    *shape, inner = rows.shape
    if rows.strides[-1] != rows.itemsize:
        rows = np.ascontiguousarray(rows)
    flat = rows.reshape(math.prod(shape), inner)
    blocks, columns = math.ceil(len(flat) / BLOCK), matrix.shape[1]
    whole = len(flat) // BLOCK
    result, sums = np.empty((len(flat), columns), rows.dtype), np.empty(blocks, rows.dtype)
    full = flat[: whole * BLOCK].reshape(whole, BLOCK, inner)
    products = result[: whole * BLOCK].reshape(whole, BLOCK, columns)
    fill(lambda some, *out: _multiply(some, matrix, *out), [full], [products, sums[:whole]], AT_ONCE)
    if whole < blocks:
        rest, last = np.zeros((1, BLOCK, inner), rows.dtype), np.empty((1, BLOCK, columns), rows.dtype)
        count = len(flat) - whole * BLOCK
        rest[0, :count] = flat[-count:]
        _multiply(rest, matrix, last, sums[whole:])
        result[-count:] = last[0, :count]
    return Product(result.reshape(*shape, columns), bool(np.isfinite(sums).all()))


def _multiply(blocks: RealArray, matrix: RealArray, out: RealArray, sums: RealArray) -> None:
    """Fill the products, and the sums, which show what is not finite; they are from the cache."""
    with np.errstate(invalid="ignore", over="ignore"):
        if matrix.shape[1] > FEW:
            np.matmul(blocks, matrix, out=out)
        else:
            columns = np.ascontiguousarray(matrix.T)[:, :, np.newaxis]
            np.matmul(blocks[:, np.newaxis], columns, out=out.transpose(0, 2, 1)[..., np.newaxis])
        np.sum(out if out.size < blocks.size else blocks, axis=(1, 2), out=sums)
