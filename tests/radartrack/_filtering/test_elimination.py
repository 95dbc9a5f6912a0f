"""Elimination of many tables at once: Cholesky's factors, and covariances that are shown to be such."""

from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from radartrack._arrays.validation import require_covariance
from radartrack._filtering.elimination import checked_covariances, eliminate, pivots

TYPES = (np.dtype(np.float64), np.dtype(np.float32))


def covariances(size: int, tracks: int, seed: int) -> Any:
    generator = np.random.default_rng(seed)
    root = np.eye(size) + 0.4 * generator.standard_normal((tracks, size, size))
    root *= 10.0 ** generator.uniform(-6, 6, (tracks, size, 1))
    products = root @ np.swapaxes(root, -1, -2)
    return (products + np.swapaxes(products, -1, -2)) / 2


@given(size=st.integers(1, 6), more=st.integers(0, 3), tracks=st.integers(1, 4), seed=st.integers(0, 10**6))
def test_elimination_gives_the_factor_and_what_it_solves(size: int, more: int, tracks: int, seed: int) -> None:
    S = covariances(size, tracks, seed)
    B = (
        np.random.default_rng(seed).standard_normal((tracks, size, more))
        * np.sqrt(np.diagonal(S, axis1=1, axis2=2))[..., np.newaxis]
    )
    root = np.linalg.cholesky(S)
    table = np.ascontiguousarray(np.moveaxis(np.concatenate([S, B], axis=-1), 0, -1))
    eliminate(table)
    upper = np.moveaxis(table, -1, 0)
    scale = np.sqrt(np.diagonal(S, axis1=1, axis2=2))[:, np.newaxis]
    assert (np.abs(np.triu(upper[:, :, :size]) - np.swapaxes(root, -1, -2)) <= 1e-9 * scale).all()
    np.testing.assert_allclose(upper[:, :, size:], np.linalg.solve(root, B), rtol=1e-9, atol=1e-7)
    np.testing.assert_allclose(pivots(table).T, np.diagonal(root, axis1=1, axis2=2) ** 2, rtol=1e-9)


def refused(matrices: Any) -> str:
    try:
        require_covariance("covariance", matrices)
    except ValueError as error:
        return str(error)
    return ""


@pytest.mark.parametrize("dtype", TYPES, ids=str)
@given(
    size=st.integers(1, 5),
    seed=st.integers(0, 10**6),
    change=st.sampled_from([0.0, 1e-12, 1e-6, 1e-3, 0.5, -2.0, np.nan, np.inf, -np.inf]),
    entries=st.tuples(st.integers(0, 4), st.integers(0, 4)),
)
def test_what_is_a_covariance_is_that_of_the_full_check_and_comes_symmetric(
    dtype: Any, size: int, seed: int, change: float, entries: tuple[int, int]
) -> None:
    """Whatever entry is altered, by how much: so the short way lets nothing pass that the full check refuses."""
    matrices = covariances(size, 3, seed)
    i, j = (entry % size for entry in entries)
    matrices[1, i, j] += change * np.sqrt(matrices[1, i, i] * matrices[1, j, j])
    matrices = matrices.astype(dtype)
    last = np.ascontiguousarray(np.moveaxis(matrices, 0, -1))
    if message := refused(matrices):
        with pytest.raises(ValueError, match="covariance must be") as raised:
            checked_covariances("covariance", last)
        assert str(raised.value) == message
    else:
        got = checked_covariances("covariance", last)
        assert got.dtype == dtype
        np.testing.assert_array_equal(got, got.swapaxes(0, 1))
        upper = np.triu_indices(size)
        np.testing.assert_array_equal(got[upper], last[upper])


@pytest.mark.parametrize("dtype", TYPES, ids=str)
@given(size=st.integers(2, 5), rank=st.integers(0, 4), seed=st.integers(0, 10**6))
def test_singular_covariances_pass(dtype: Any, size: int, rank: int, seed: int) -> None:
    root = np.random.default_rng(seed).integers(-3, 4, (size, rank)).astype(dtype)
    matrices = (root @ root.T)[..., np.newaxis]
    np.testing.assert_array_equal(checked_covariances("covariance", matrices), matrices)
