"""Generated filters against exact rational least squares of every sample, and where floating point is at its limits."""

from collections.abc import Callable
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from radartrack.derive.finite_sample.least_squares_filter import fewest_scans
from radartrack.generated import finite_sample, motion
from tests.least_squares import ExactFit, full_fit

ULP = 2.0**-52
BOUND = 16 * ULP
DEGREES = st.integers(0, 3)
PERIODS = st.sampled_from([0.125, 1.0, 10.0, 12.7])
RATIOS = st.one_of(st.just(0.0), st.floats(-12, 12).map(lambda exponent: 10.0**exponent))


def function(degree: int, name: str, *, with_rate: bool) -> Callable[..., Any]:
    found: Callable[..., Any] = getattr(
        finite_sample, f"degree{degree}_{'range_rate' if with_rate else 'range'}_{name}"
    )
    return found


def exact(k: int, degree: int, period: float, C: float, lag: float = 0.0) -> ExactFit:
    return full_fit(k, degree, Fraction(period), Fraction(C) * Fraction(period) ** 2, Fraction(lag))


def assert_covariance(computed: Any, fit: ExactFit) -> None:
    """A variance to itself, a covariance to the two deviations."""
    expected = np.array([[float(entry) for entry in row] for row in fit.covariance])
    deviations = np.sqrt(np.diagonal(expected))
    assert np.all(np.abs(computed - expected) <= BOUND * deviations[:, np.newaxis] * deviations)


def assert_weights(computed: Any, exact_weights: list[list[Fraction]], slack: float = 1.0) -> None:
    """Each to the root mean square of the weights of its component."""
    expected = np.array([[float(entry) for entry in row] for row in exact_weights])
    scale = np.sqrt((expected**2).mean(axis=1, keepdims=True))
    assert np.all(np.abs(computed.T - expected) <= slack * BOUND * scale)


@given(degree=DEGREES, more=st.integers(0, 40), period=PERIODS, C=RATIOS)
def test_filters_are_exact_least_squares(degree: int, more: int, period: float, C: float) -> None:
    k = degree + 1 + more
    fit = exact(k, degree, period, C)
    given_to_all = {"k": k, "T": period, "C": C}
    scans = {"j": np.arange(1, k + 1), **given_to_all}
    assert_covariance(function(degree, "covariance", with_rate=True)(sigma_r=1.0, **given_to_all), fit)
    assert_weights(function(degree, "range_weights", with_rate=True)(**scans), fit.range_weights)
    assert_weights(function(degree, "rate_weights", with_rate=True)(**scans), fit.rate_weights)


@given(degree=DEGREES, more=st.integers(0, 40), period=PERIODS)
def test_filters_of_range_alone_are_exact_least_squares(degree: int, more: int, period: float) -> None:
    k = degree + 1 + more
    fit = exact(k, degree, period, 0.0)
    assert_covariance(function(degree, "covariance", with_rate=False)(k=k, T=period, sigma_r=1.0), fit)
    weights = function(degree, "range_weights", with_rate=False)(k=k, T=period, j=np.arange(1, k + 1))
    assert_weights(weights, fit.range_weights)


@given(degree=DEGREES, more=st.integers(0, 20), C=RATIOS, lag=st.floats(-30, 30))
def test_filters_at_any_lag_are_exact_least_squares(degree: int, more: int, C: float, lag: float) -> None:
    k = degree + 1 + more
    fit = exact(k, degree, 2.0, C, lag)
    given_to_all = {"k": k, "T": 2.0, "C": C, "tau": lag}
    scans = {"j": np.arange(1, k + 1), **given_to_all}
    assert_covariance(function(degree, "at_lag_covariance", with_rate=True)(sigma_r=1.0, **given_to_all), fit)
    assert_weights(function(degree, "at_lag_range_weights", with_rate=True)(**scans), fit.range_weights, slack=4)
    assert_weights(function(degree, "at_lag_rate_weights", with_rate=True)(**scans), fit.rate_weights, slack=4)


@pytest.mark.parametrize("degree", range(4))
@pytest.mark.parametrize("C", [0.0, 1e-12, 0.51, 11.0, 1e12])
def test_two_hundred_scans_are_exact_least_squares(degree: int, C: float) -> None:
    fit = exact(200, degree, 10.0, C)
    scans = {"k": 200, "T": 10.0, "C": C, "j": np.arange(1, 201)}
    assert_covariance(function(degree, "covariance", with_rate=True)(k=200, T=10.0, C=C, sigma_r=1.0), fit)
    assert_weights(function(degree, "range_weights", with_rate=True)(**scans), fit.range_weights)
    assert_weights(function(degree, "rate_weights", with_rate=True)(**scans), fit.rate_weights)


@pytest.mark.parametrize("degree", range(4))
@pytest.mark.parametrize("C", [1e-12, 1e-6, 0.51, 100.0, 1e12])
def test_the_fewest_scans_with_rate_lose_nothing(degree: int, C: float) -> None:
    for k in range(fewest_scans(degree, with_rate=True), degree + 1):
        fit = exact(k, degree, 10.0, C)
        covariance = function(degree, "covariance", with_rate=True)(k=k, T=10.0, C=C, sigma_r=1.0)
        assert_covariance(covariance, fit)
        scans = {"k": k, "T": 10.0, "C": C, "j": np.arange(1, k + 1)}
        ranges = function(degree, "range_weights", with_rate=True)(**scans).T
        rates = function(degree, "rate_weights", with_rate=True)(**scans).T
        spread = np.sqrt(np.diagonal(covariance))[:, np.newaxis]
        for computed, fitted, unit in ((ranges, fit.range_weights, 1.0), (rates, fit.rate_weights, 10 * np.sqrt(C))):
            expected = np.array([[float(entry) for entry in row] for row in fitted])
            assert np.all(np.abs(computed - expected) <= BOUND * spread * unit)


@pytest.mark.parametrize("degree", range(4))
@pytest.mark.parametrize("C", [0.0, 1.0, 1e12])
def test_a_million_scans_neither_overflow_nor_cancel(degree: int, C: float) -> None:
    """Whole numbers of any type, and unbiasedness summed over all scans as the witness."""
    k, T = 10**6, 10.0
    j = np.arange(1, k + 1)
    with np.errstate(all="raise"):
        covariance = function(degree, "covariance", with_rate=True)(k=np.int32(k), T=T, C=C, sigma_r=1.0)
        ranges = function(degree, "range_weights", with_rate=True)(k=k, T=T, C=C, j=j)
        rates = function(degree, "rate_weights", with_rate=True)(k=k, T=T, C=C, j=j)
    assert np.all(np.linalg.eigvalsh(covariance / np.sqrt(np.outer(*[np.diagonal(covariance)] * 2))) > 0)
    times = (j - k) * T
    for n in range(degree + 1):
        slope = n * times ** max(n - 1, 0)
        reproduced = (ranges * (times**n)[:, np.newaxis] + rates * slope[:, np.newaxis]).sum(axis=0)
        scale = np.abs(ranges * (times**n)[:, np.newaxis]).sum(axis=0) + np.abs(rates * slope[:, np.newaxis]).sum(
            axis=0
        )
        expected = np.where(np.arange(degree + 1) == n, float(np.prod(np.arange(1, n + 1))), 0.0)
        assert np.all(np.abs(reproduced - expected) <= 1e-12 * scale)


def test_arguments_broadcast_together() -> None:
    k, C = np.array([[4], [9], [30]]), np.array([0.0, 2.5])
    covariance = finite_sample.degree3_range_rate_covariance(k=k, T=10.0, sigma_r=50.0, C=C)
    assert covariance.shape == (3, 2, 4, 4)
    alone = finite_sample.degree3_range_rate_covariance(k=9, T=10.0, sigma_r=50.0, C=2.5)
    assert np.array_equal(covariance[1, 1], alone)


@given(k=st.integers(4, 10**6), C=RATIOS, degree=DEGREES)
def test_the_gain_is_what_the_covariances_say(k: int, C: float, degree: int) -> None:
    without = np.diagonal(function(degree, "covariance", with_rate=False)(k=k, T=1.0, sigma_r=1.0))
    with_rate = np.diagonal(function(degree, "covariance", with_rate=True)(k=k, T=1.0, sigma_r=1.0, C=C))
    gain = getattr(finite_sample, f"degree{degree}_gain")(k=k, C=C)
    assert np.all(np.abs(gain - (1 - np.sqrt(with_rate / without))) <= BOUND)
    assert np.all(gain >= 0)
    assert gain[0] <= getattr(finite_sample, f"degree{degree}_range_gain_of_perfect_rate")(k=k) + BOUND


def test_process_noise_of_constant_velocity_is_the_known_one() -> None:
    noise = motion.constant_velocity_process_noise_continuous(T=2.0, q=3.0)
    assert np.allclose(noise, 3.0 * np.array([[8 / 3, 2.0], [2.0, 2.0]]), rtol=1e-15)
