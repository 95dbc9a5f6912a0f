"""Products of many rows with one matrix, each row with the same bits however many rows there are.

BLAS picks its order of summation by the shape of the whole product, so a row alone and the same row among a
million may differ in the last place. Blocks of one shape are all treated alike.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from radartrack._arrays.batches import fill
from radartrack._arrays.validation import RealArray

BLOCK = 256  # rows at most
FEWEST = 16  # rows, however large the matrix
PRODUCTS = 2**17  # in a block; above twice that OpenBLAS divides it among its own threads, in ten times the time
AT_ONCE = 32  # blocks, by one thread
FEW = 3  # columns; BLAS takes fewer than four one by one in two thirds of the time


class Product(NamedTuple):
    """Rows times a matrix, and whether rows and products are all finite, judged by sums, which may overflow."""

    values: RealArray
    is_finite: bool


def rowwise_product(parts: Sequence[RealArray], matrix: RealArray) -> Product:
    """Multiply rows with a matrix, shape (k, m).

    Args:
        parts: what a row is joined from, arrays of one shape but for the last axis; there they have k in all.
        matrix: shape (k, m).

    Returns:
        Shape (..., m).

    """
    shape, columns = parts[0].shape[:-1], matrix.shape[1]
    rows = math.prod(shape)
    block = _block(matrix.size)
    blocks, whole = math.ceil(rows / block), rows // block
    flat = [_contiguous(part).reshape(rows, part.shape[-1]) for part in parts]
    result, sums = np.empty((rows, columns), matrix.dtype), np.empty(blocks, matrix.dtype)

    def multiply(*arrays: RealArray) -> None:
        *some, out, totals = arrays
        _multiply(some[0] if len(some) == 1 else np.concatenate(some, axis=-1), matrix, out, totals)

    full = [_divided(array[: whole * block], block) for array in (*flat, result)]
    fill(multiply, full[:-1], [full[-1], sums[:whole]], AT_ONCE)
    if whole < blocks:
        rest = [np.zeros((1, block, array.shape[1]), matrix.dtype) for array in (*flat, result)]
        for array, last in zip(flat, rest, strict=False):
            last[0, : rows - whole * block] = array[whole * block :]
        multiply(*rest, sums[whole:])
        result[whole * block :] = rest[-1][0, : rows - whole * block]
    return Product(result.reshape(*shape, columns), bool(np.isfinite(sums).all()))


def _contiguous(rows: RealArray) -> RealArray:
    """With each row in one piece."""
    return rows if rows.strides[-1] == rows.itemsize else np.ascontiguousarray(rows)


def _block(size: int) -> int:
    """The rows of a block, a power of two that depends on nothing but the size of the matrix."""
    rows = max(PRODUCTS // max(size, 1), FEWEST)
    return min(1 << (rows.bit_length() - 1), BLOCK)


def _divided(rows: RealArray, block: int) -> RealArray:
    return rows.reshape(len(rows) // block, block, rows.shape[1])


def _multiply(blocks: RealArray, matrix: RealArray, out: RealArray, totals: RealArray) -> None:
    """Fill the products, and the sums of each block, in which what is not finite shows.

    It shows in the products, but that a routine may pass over what is multiplied by zero.
    """
    with np.errstate(invalid="ignore", over="ignore"):
        if matrix.shape[1] > FEW:
            np.matmul(blocks, matrix, out=out)
        else:
            columns = np.ascontiguousarray(matrix.T)[:, :, np.newaxis]
            np.matmul(blocks[:, np.newaxis], columns, out=out.transpose(0, 2, 1)[..., np.newaxis])
        np.sum(out, axis=(1, 2), out=totals)
        if blocks.size <= out.size:  # the fewer numbers, in time
            totals += blocks.sum(axis=(1, 2))
