"""Rows times a matrix: the right product, and the same bits in any company and layout."""

import numpy as np
import pytest

from radartrack.rowwise import BLOCK, rowwise_product


@pytest.mark.parametrize("shape", [(7,), (1, 7), (BLOCK, 7), (3 * BLOCK + 5, 7), (2, 3, 7), (0, 7), (4, 0)])
def test_the_product_is_right(shape: tuple[int, ...]) -> None:
    rows = np.random.default_rng(0).normal(size=shape)
    matrix = np.random.default_rng(1).normal(size=(shape[-1], 3))
    assert np.allclose(rowwise_product(rows, matrix), rows @ matrix, rtol=1e-13, atol=1e-13)
    assert rowwise_product(rows, matrix).shape == (rows @ matrix).shape


@pytest.mark.parametrize("columns", [0, 1, 2, 3, 4, 60])
def test_a_row_has_the_same_bits_in_any_company_and_layout(columns: int) -> None:
    rows = np.random.default_rng(0).normal(size=(5 * BLOCK + 77, 23))
    matrix = np.random.default_rng(1).normal(size=(23, columns))
    many = rowwise_product(rows, matrix)
    for n in range(0, len(rows), 13):
        assert rowwise_product(rows[n], matrix).tobytes() == many[n].tobytes()
    assert np.array_equal(rowwise_product(np.asfortranarray(rows), matrix), many)
    wide = np.concatenate([rows, rows], axis=1)
    assert np.array_equal(rowwise_product(wide[:, :23], matrix), many)
