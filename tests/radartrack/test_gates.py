"""Gates and bands beside SciPy's quantiles, and normalised squares beside dense algebra."""

from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy import stats

from radartrack import consistency, kalman
from tests.examples import share


def test_quantiles_of_arrays_are_those_of_scipy() -> None:
    probability = np.array([1e-12, 1e-3, 0.5, 0.99, 1 - 1e-12])[:, np.newaxis]
    degrees = np.array([0.5, 1.0, 2.0, 7.0, 600.0, 1e4])
    expected = np.where(
        probability < 0.5, stats.chi2.ppf(probability, degrees), stats.chi2.isf(1 - probability, degrees)
    )
    np.testing.assert_allclose(consistency.chi_square_quantile(probability, degrees), expected, rtol=1e-8)


@given(n=st.integers(1, 12), runs=st.integers(1, 200), inside=st.floats(0.5, 0.9999))
@share(0.3)
def test_gates_and_bands_are_quantiles_of_the_sum_over_the_runs(n: int, runs: int, inside: float) -> None:
    sums = stats.chi2(n * runs)
    assert consistency.gate(n, inside, runs) == pytest.approx(sums.ppf(inside) / runs, rel=1e-7)
    tail = (1 - inside) / 2
    expected = [sums.ppf(tail) / runs, sums.isf(tail) / runs]
    np.testing.assert_allclose(consistency.band(n, runs, inside), expected, rtol=1e-7)


@pytest.mark.parametrize("inside", [1e-12, 0.3, 1 - 1e-12])
@pytest.mark.parametrize("n", [1, 1000])
def test_bands_of_any_probability_have_half_of_the_rest_on_either_side(n: int, inside: float) -> None:
    low, high = consistency.band(n, probability=inside)
    tail = (1 - inside) / 2
    np.testing.assert_allclose([stats.chi2.cdf(low, n), stats.chi2.sf(high, n)], [tail, tail], rtol=1e-8)


def test_the_gates_of_the_books() -> None:
    assert [round(float(value), 2) for value in consistency.gate([1, 2, 3, 4])] == [6.63, 9.21, 11.34, 13.28]
    assert consistency.band(2, 50).round(2).tolist() == [1.48, 2.59]
    assert consistency.gate([2, 3], [[0.9], [0.99]]).shape == (2, 2)
    assert consistency.band([2, 3, 4], 10).shape == (3, 2)


@given(seed=st.integers(0, 10**6), size=st.integers(1, 6))
@share(0.3)
def test_normalised_squares_are_those_of_dense_algebra(seed: int, size: int) -> None:
    generator = np.random.default_rng(seed)
    root = generator.standard_normal((4, size, size)) * 10.0 ** generator.uniform(-8, 8, (size, 1))
    P = root @ np.swapaxes(root, -1, -2)
    mean = generator.standard_normal((3, 4, size)) * np.sqrt(np.diagonal(P, axis1=-2, axis2=-1))
    truth = 0.3 * mean[0]
    scale = np.sqrt(np.diagonal(P, axis1=-2, axis2=-1))
    R = P / scale[..., :, np.newaxis] / scale[..., np.newaxis, :]
    error = (mean - truth) / scale
    expected = (error[..., np.newaxis, :] @ np.linalg.inv(R) @ error[..., np.newaxis])[..., 0, 0]
    tolerance = 1e-13 * np.linalg.cond(R).max()
    np.testing.assert_allclose(consistency.nees(mean, P, truth), expected, rtol=max(tolerance, 1e-12))
    np.testing.assert_allclose(consistency.nis(mean - truth, P), expected, rtol=max(tolerance, 1e-12))


@pytest.mark.parametrize("dtype", [np.float32, np.float64])
@given(seed=st.integers(0, 10**6), size=st.integers(2, 6), scale=st.floats(-3, 3))
@share(0.3)
def test_a_covariance_that_is_singular_but_for_rounding_is_refused(
    seed: int, size: int, scale: float, dtype: Any
) -> None:
    """Whatever rounding leaves of its last pivot: what it would give is an error squared over rounding."""
    generator = np.random.default_rng(seed)
    root = np.concatenate([np.eye(size - 1), generator.uniform(0.1, 1.0, (1, size - 1))])
    deviations = 10.0 ** (scale * generator.uniform(-1, 1, size))
    P = ((root @ root.T) * np.outer(deviations, deviations)).astype(dtype)
    for few in (P, np.stack([np.diag(np.diagonal(P)), P])):
        with pytest.raises(ValueError, match="covariance must be positive definite, by more than rounding"):
            consistency.nis(np.ones(size, dtype), few)


def test_the_nees_of_a_kalman_filter_lies_in_its_band() -> None:
    generator = np.random.default_rng(3)
    runs, moves, start = 2000, kalman.constant_velocity(2.0, 0.5), np.diag([100.0, 25.0])
    truth = generator.multivariate_normal(np.zeros(2), start, runs, method="cholesky")
    truth = truth @ moves.transition.T + generator.multivariate_normal(
        np.zeros(2), moves.process_noise, runs, method="cholesky"
    )
    plots = truth[:, :1] + 8.0 * generator.standard_normal((runs, 1))
    belief = kalman.update(
        kalman.predict(kalman.Belief(np.zeros((runs, 2)), start), moves), plots, [[1.0, 0.0]], [[64.0]]
    )
    low, high = consistency.band(2, runs, 0.9999)
    assert low <= consistency.nees(belief.mean, belief.covariance, truth).mean() <= high
    too_sure = consistency.nees(belief.mean, belief.covariance / 1.3, truth).mean()
    assert too_sure > high


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda: consistency.gate(2, 1.0), "probability must be from"),
        (lambda: consistency.gate(0), "components times runs must be from"),
        (lambda: consistency.chi_square_quantile(1e-9, 0.05), "degrees_of_freedom must be from 0.1"),
        (lambda: consistency.gate(2, runs=0), "runs must be from"),
        (lambda: consistency.band([2, 3], [1, 2, 3]), "shapes must broadcast"),
        (lambda: consistency.nis([1.0, 2.0], np.diag([1.0, 0.0])), "covariance must be positive definite"),
        (lambda: consistency.nis([1.0, np.nan], np.eye(2)), "innovation must be finite"),
        (lambda: consistency.nees([1e200, 1.0], np.eye(2), np.zeros(2)), "result must be finite; got inf"),
        (lambda: consistency.nees([1.7e308, 0.0], np.eye(2), [-1.7e308, 0.0]), "result must be finite; got nan"),
        (
            lambda: consistency.nis(np.array([1e30, 1.0], np.float32), np.eye(2, dtype=np.float32)),
            "square of the result must",
        ),
        (lambda: consistency.nees([1.0, 2.0], np.eye(3), [0.0, 0.0]), "covariance must have shape"),
    ],
)
def test_what_does_not_fit_is_refused(call: Any, message: str) -> None:
    with pytest.raises(ValueError, match=message):
        call()
