"""Rows times a matrix: the right product, and the same bits in any company and layout."""

import numpy as np
import pytest

from radartrack._arrays.row_products import BLOCK, rowwise_product


@pytest.mark.parametrize("shape", [(7,), (1, 7), (BLOCK, 7), (3 * BLOCK + 5, 7), (2, 3, 7), (0, 7), (4, 0)])
def test_the_product_is_right(shape: tuple[int, ...]) -> None:
    rows = np.random.default_rng(0).normal(size=shape)
    matrix = np.random.default_rng(1).normal(size=(shape[-1], 3))
    product = rowwise_product([rows], matrix)
    assert np.allclose(product.values, rows @ matrix, rtol=1e-13, atol=1e-13)
    assert product.values.shape == (rows @ matrix).shape
    assert product.is_finite


@pytest.mark.parametrize("columns", [0, 1, 2, 3, 4, 60, 300, 1000])
def test_a_row_has_the_same_bits_in_any_company_and_layout(columns: int) -> None:
    rows = np.random.default_rng(0).normal(size=(5 * BLOCK + 77, 23))
    matrix = np.random.default_rng(1).normal(size=(23, columns))
    many = rowwise_product([rows], matrix).values
    for n in range(0, len(rows), 13):
        assert rowwise_product([rows[n]], matrix).values.tobytes() == many[n].tobytes()
    assert np.array_equal(rowwise_product([np.asfortranarray(rows)], matrix).values, many)
    wide = np.concatenate([rows, rows], axis=1)
    assert np.array_equal(rowwise_product([wide[:, :23]], matrix).values, many)
    joined = rowwise_product([rows[:, :9], rows[:, 9:]], matrix)
    assert np.array_equal(joined.values, many)


@pytest.mark.parametrize("columns", [3, 60])
@pytest.mark.parametrize("bad", [[np.nan, 1], [np.inf, 1], [-np.inf, 1], [np.inf, -np.inf]])
@pytest.mark.parametrize("place", [0, 2 * BLOCK, 3 * BLOCK + 4])
def test_what_is_not_finite_shows(columns: int, bad: list[float], place: int) -> None:
    rows = np.ones((3 * BLOCK + 5, 23))
    rows[place, 7:9] = bad
    assert not rowwise_product([rows], np.ones((23, columns))).is_finite


@pytest.mark.parametrize("columns", [1, 5, 300])
def test_products_that_overflow_are_told_however_many_they_are(columns: int) -> None:
    assert not rowwise_product([np.full((300, 23), 1e300)], np.full((23, columns), 1e9)).is_finite
