"""Factors of covariances: their product is the covariance to rounding, be it singular and on whatever scales."""

from typing import Any

import numpy as np
import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from radartrack import kalman
from radartrack._filtering.extended import curvature_of
from radartrack._filtering.factors import factored, product_of
from radartrack.kalman import Belief
from radartrack.testing import strategies
from tests.examples import share


def worst(found: Any, covariance: Any) -> float:
    """The largest error over the deviations."""
    deviations = np.sqrt(np.diagonal(covariance, axis1=-2, axis2=-1))
    scale = deviations[..., :, np.newaxis] * deviations[..., np.newaxis, :]
    return float(np.abs((found - covariance) / np.where(scale > 0, scale, 1)).max())


@pytest.mark.parametrize("size", [1, 2, 4, 6])
@given(data=st.data(), dtype=st.sampled_from([np.float32, np.float64]))
@share(0.5)
def test_the_product_of_the_factors_is_the_covariance_of_any_rank(size: int, dtype: Any, data: st.DataObject) -> None:
    matrices = [data.draw(strategies.covariances(size)).astype(dtype) for _ in range(3)]
    last = np.stack(matrices, axis=-1)
    upper, variances = factored(last)
    found = np.moveaxis(product_of(upper, variances), -1, 0)
    assert worst(found, np.stack(matrices)) <= 16 * size * np.finfo(dtype).eps
    for number, matrix in enumerate(matrices):
        alone = factored(matrix[..., np.newaxis])
        np.testing.assert_array_equal(alone[0][..., 0], upper[..., number])
        np.testing.assert_array_equal(alone[1][..., 0], variances[..., number])


@given(seed=st.integers(0, 10**6), rank=st.integers(1, 5), below=st.floats(-16, -8.5), spread=st.floats(0, 140))
@share(0.5)
@example(seed=0, rank=5, below=-16.0, spread=0.0)
def test_a_motion_that_moves_nothing_changes_no_covariance_that_is_accepted(
    seed: int, rank: int, below: float, spread: float
) -> None:
    """Also of deviations of any sizes, and where an eigenvalue is negative by as much as rounding of others may be."""
    generator = np.random.default_rng(seed)
    root = generator.standard_normal((4, 5, rank))
    correlations = root @ np.swapaxes(root, -1, -2)
    lengths = np.sqrt(np.diagonal(correlations, axis1=-2, axis2=-1))
    correlations /= lengths[..., :, np.newaxis] * lengths[..., np.newaxis, :]
    bent = generator.uniform(-1, 1, correlations.shape) * (1 - np.eye(5)) * 10.0**below
    correlations = (correlations + np.swapaxes(correlations, -1, -2) + bent + np.swapaxes(bent, -1, -2)) / 2
    deviations = 10.0 ** generator.uniform(-spread, spread, (4, 5))
    believed = correlations * deviations[..., :, np.newaxis] * deviations[..., np.newaxis, :]
    moved = kalman.predict(Belief(np.zeros((4, 5)), believed), kalman.Motion(np.eye(5), np.zeros((5, 5))))
    assert worst(moved.covariance, believed) <= 1e-14 + 20 * 10.0**below
    assert (np.diagonal(moved.covariance, axis1=-2, axis2=-1) > 0).all()


@given(seed=st.integers(0, 10**6), size=st.integers(2, 5), rank=st.integers(1, 5))
@share(0.3)
def test_what_curvature_adds_is_a_covariance_and_right_to_rounding(seed: int, size: int, rank: int) -> None:
    """Of a covariance of any rank; of rank one, in a direction in which there is no curvature, it is nearly nothing."""
    generator = np.random.default_rng(seed)
    hessian = generator.standard_normal((4, 3, size, size))
    hessian += np.swapaxes(hessian, -1, -2)
    root = generator.standard_normal((4, size, rank))
    along = root[1, :, 0]
    root[1, :, 1:] = 0
    hessian[1] -= (
        (along @ hessian[1] @ along)[:, np.newaxis, np.newaxis] * np.outer(along, along) / (along @ along) ** 2
    )
    P = root @ np.swapaxes(root, -1, -2)
    shift, spread = curvature_of(hessian, np.moveaxis(P, 0, -1))
    turned = np.swapaxes(root, -1, -2)[:, np.newaxis] @ hessian @ root[:, np.newaxis]
    np.testing.assert_allclose(shift.T, np.trace(turned, axis1=-2, axis2=-1) / 2, atol=1e-12 * np.abs(P).max() * size)
    flat = turned.reshape(4, 3, -1)
    expected = flat @ np.swapaxes(flat, -1, -2) / 2
    norms = np.sqrt((hessian**2).sum(axis=(-2, -1))) * np.trace(P, axis1=-2, axis2=-1)[:, np.newaxis]
    scale = norms[:, :, np.newaxis] * norms[:, np.newaxis]
    assert (np.abs(np.moveaxis(spread, -1, 0) - expected) <= 1e-13 * scale).all()
    assert (np.linalg.eigvalsh(np.moveaxis(spread, -1, 0) / scale) >= -1e-15).all()
    assert (np.diagonal(spread) >= 0).all()


@given(seed=st.integers(0, 10**6), size=st.integers(3, 6), bad=st.sampled_from([np.inf, -np.inf, np.nan]))
@share(0.3)
def test_what_has_overflowed_is_left_to_be_refused_in_the_result(seed: int, size: int, bad: float) -> None:
    """It has no eigenvalues, and others beside it have their factors."""
    generator = np.random.default_rng(seed)
    root = generator.standard_normal((size, 2))
    good = root @ root.T
    broken = good.copy()
    place, other = generator.integers(0, size, 2)
    broken[place, other] = broken[other, place] = bad
    broken[0, 1] = broken[1, 0] = 1e3  # so that the elimination is lost
    with np.errstate(all="ignore"):
        product = product_of(*factored(np.stack([broken, good], axis=-1)))
    assert worst(product[..., 1], good) <= 1e-13
