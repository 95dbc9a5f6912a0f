"""Steady filters against solvers of the Riccati equation that know nothing of the tracking index."""

import mpmath
import numpy as np
import pytest
import scipy.linalg
from hypothesis import given
from hypothesis import strategies as st

from radartrack.generated import fading_memory, motion, steady_state
from radartrack.verification.second_derivations import doubling
from tests.examples import share

FILTERS = {
    "alpha_beta": ("constant_velocity", "piecewise"),
    "alpha_beta_gamma": ("constant_acceleration", "wiener_sequence"),
}
INDICES = st.floats(-9, 3).map(lambda exponent: 10.0**exponent)


def gain(name: str, index: float) -> np.ndarray:
    return getattr(steady_state, f"{name}_gain")(index=index)


def covariance(name: str, index: float, sigma_r: float, period: float) -> np.ndarray:
    return getattr(steady_state, f"{name}_covariance")(index=index, sigma_r=sigma_r, T=period)


@pytest.mark.parametrize("name", FILTERS)
@given(index=st.floats(-2, 3).map(lambda e: 10.0**e), sigma_r=st.floats(0.1, 10), period=st.floats(0.1, 10))
@share(0.3)
def test_the_steady_state_solves_the_riccati_equation(name: str, index: float, sigma_r: float, period: float) -> None:
    moves, noise = FILTERS[name]
    sigma_w = index * sigma_r / period**2
    F = getattr(motion, f"{moves}_transition")(T=period)
    Q = getattr(motion, f"{moves}_process_noise_{noise}")(T=period, sigma_w=sigma_w)
    H = np.eye(1, len(F))
    before = scipy.linalg.solve_discrete_are(F.T, H.T, Q, [[sigma_r**2]])
    gains = before[:, 0] / (before[0, 0] + sigma_r**2)
    after = before - np.outer(gains, before[0])
    scale = period ** np.arange(len(F))
    np.testing.assert_allclose(gain(name, index), gains * scale, rtol=1e-6)
    deviations = np.sqrt(np.diag(after))
    error = abs(covariance(name, index, sigma_r, period) - after) / np.outer(deviations, deviations)
    np.testing.assert_array_less(error, 1e-5)


@pytest.mark.parametrize("name", FILTERS)
@given(index=INDICES)
@share(0.1)
def test_gains_and_covariances_keep_their_digits_from_the_smallest_index_to_the_largest(name: str, index: float):
    with mpmath.workdps(80):
        expected_gain, expected = doubling._steady(1 + name.count("_"), {"index": mpmath.mpf(index)})
        size = len(expected_gain)
        gains = np.array([float(value) for value in expected_gain])
        after = np.array([[float(expected[m, n]) for n in range(size)] for m in range(size)])
    np.testing.assert_allclose(gain(name, index), gains, rtol=4e-15)
    np.testing.assert_allclose(covariance(name, index, 1.0, 1.0), after, rtol=8e-15)


@given(index=INDICES)
@share(0.5)
def test_gains_satisfy_the_relations_of_kalata(index: float) -> None:
    alpha, beta = gain("alpha_beta", index)
    assert beta**2 / (1 - alpha) == pytest.approx(index**2, rel=1e-6 + 1e-12 * index**2)
    alpha, beta, gamma = gain("alpha_beta_gamma", index)
    assert gamma == pytest.approx(beta**2 / (2 * alpha), rel=1e-13)
    assert 0 < gamma < beta
    assert 0 < alpha < 1


@pytest.mark.parametrize("degree", range(4))
@given(theta=st.floats(0.05, 0.9))
@share(0.2)
def test_a_fading_memory_is_weighted_least_squares_over_all_scans(degree: int, theta: float) -> None:
    ages = np.arange(3 + int(80 / -np.log(theta)))
    design = np.stack([(-ages.astype(float)) ** n / float(mpmath.factorial(n)) for n in range(degree + 1)], axis=1)
    weighted = design * np.sqrt(theta**ages)[:, np.newaxis]
    _, triangle = np.linalg.qr(weighted)
    root = np.linalg.inv(triangle)
    estimate = root @ root.T @ (design * (theta**ages)[:, np.newaxis]).T  # one column a scan
    np.testing.assert_allclose(getattr(fading_memory, f"degree{degree}")(theta=theta), estimate[:, 0], rtol=1e-6)
    found = getattr(fading_memory, f"degree{degree}_covariance")(theta=theta)
    np.testing.assert_allclose(found, estimate @ estimate.T, rtol=1e-5)
