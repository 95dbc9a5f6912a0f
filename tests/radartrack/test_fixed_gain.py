"""Filters of fixed gain: against the Kalman filter that settles, against fitted polynomials, and by simulation."""

import math
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from radartrack import consistency, fixed_gain, kalman
from radartrack.fixed_gain import FixedGainFilter
from tests.examples import share

BY_INDEX = {"alpha_beta": ("constant_velocity", "std"), "alpha_beta_gamma": ("constant_acceleration", "jump_std")}


@pytest.mark.parametrize("name", BY_INDEX)
@given(T=st.floats(0.5, 5), range_std=st.floats(1, 100), index=st.floats(-1, 2).map(lambda power: 10.0**power))
@share(0.2)
def test_a_kalman_filter_settles_at_the_gain_and_covariance(
    name: str, T: float, range_std: float, index: float
) -> None:
    std = index * range_std / T**2
    steady: FixedGainFilter = getattr(fixed_gain, name)(T, range_std, std)
    size = len(steady.gain)
    moves, parameter = BY_INDEX[name]
    noise: Any = {parameter: std}
    motion = kalman.motion(moves, T, **noise)
    H, R, start = np.eye(1, size), [[range_std**2]], np.diag([1e3 * range_std] * size) ** 2
    plots = range_std * np.random.default_rng(1).standard_normal((400, 1))
    settled = kalman.run(kalman.Belief(np.zeros(size), start), motion, plots, H, R)
    deviations = np.sqrt(np.diagonal(steady.covariance))
    scale = np.outer(deviations, deviations)
    assert (np.abs(settled.covariance[-1] - steady.covariance) <= 1e-8 * scale).all()
    assert (np.abs(steady.covariance[:, 0] / range_std**2 - steady.gain) <= 1e-11 * steady.gain).all()
    states = steady.run(plots[200:, 0], settled.mean[199])
    assert (np.abs(states - settled.mean[200:]) <= 1e-6 * deviations).all()


@pytest.mark.parametrize("degree", range(4))
@given(fading=st.floats(0.05, 0.9), T=st.floats(0.2, 5), seed=st.integers(0, 99))
@share(0.2)
def test_a_fading_memory_fits_the_polynomial_of_discounted_least_squares(
    degree: int, fading: float, T: float, seed: int
) -> None:
    """Of so many scans that those before count for nothing."""
    scans = math.ceil(40 / -math.log(fading)) + 40
    plots = np.random.default_rng(seed).standard_normal(scans)
    state = fixed_gain.fading_memory(degree, fading, T, 1.0).run(plots, np.ones(degree + 1))[-1]
    ages = np.arange(scans - 1, -1, -1.0)
    terms = (-ages[:, np.newaxis]) ** np.arange(degree + 1) / [math.factorial(k) for k in range(degree + 1)]
    weights = fading ** (ages / 2)
    fitted = np.linalg.lstsq(terms * weights[:, np.newaxis], plots * weights, rcond=None)[0]
    np.testing.assert_allclose(state * T ** np.arange(degree + 1), fitted, rtol=1e-6, atol=1e-6)


@pytest.mark.parametrize("degree", range(4))
@pytest.mark.parametrize("fading", [0.3, 0.8, 0.95])
def test_the_covariance_of_a_fading_memory_is_that_of_its_errors(degree: int, fading: float) -> None:
    """Of a target that moves as the polynomial; with a false alarm of 1e-6, six per cent of a variance show."""
    runs, T, range_std = 40_000, 0.7, 3.0
    tracker = fixed_gain.fading_memory(degree, fading, T, range_std)
    scans = math.ceil(25 / -math.log(fading)) + 25
    generator = np.random.default_rng(7)
    truth = np.array([10.0, 1.0, 0.1, 0.01])[: degree + 1]
    times = T * np.arange(1, scans + 1)
    powers = times[:, np.newaxis] ** np.arange(degree + 1) / [math.factorial(k) for k in range(degree + 1)]
    plots = powers @ truth + range_std * generator.standard_normal((runs, scans))
    error = tracker.run(plots, truth)[:, -1]
    shift = np.array([
        sum(truth[k + j] * times[-1] ** j / math.factorial(j) for j in range(degree + 1 - k)) for k in range(degree + 1)
    ])  # fmt: skip
    low, high = consistency.band(degree + 1, runs, 1 - 1e-6)
    assert low < consistency.nees(error, tracker.covariance, shift).mean() < high
    for slip in (1.06, 1 / 1.06):
        assert not low < consistency.nees(error, tracker.covariance * slip, shift).mean() < high


def test_tracks_and_filters_broadcast_each_as_alone() -> None:
    generator = np.random.default_rng(2)
    tracker = fixed_gain.alpha_beta_gamma(generator.uniform(1, 3, 4), 20.0, generator.uniform(1, 3, (3, 1)))
    assert (tracker.gain.shape, tracker.covariance.shape) == ((3, 4, 3), (3, 4, 3, 3))
    plots, start = generator.standard_normal((4, 6)), generator.standard_normal((2, 1, 1, 3))
    states = tracker.run(plots, start)
    assert states.shape == (2, 3, 4, 6, 3)
    alone = FixedGainFilter(tracker.period[2], tracker.gain[1, 2], tracker.covariance[1, 2])
    np.testing.assert_array_equal(states[1, 1, 2], alone.run(plots[2], start[1, 0, 0]))


def test_a_missing_plot_only_moves_the_state() -> None:
    tracker = fixed_gain.alpha_beta_gamma(2.0, 20.0, 1.0)
    start = np.array([3.0, 4.0, 5.0])
    np.testing.assert_allclose(tracker.run([np.nan], start), [[3 + 2 * 4 + 2 * 5, 4 + 2 * 5, 5]])
    plots = np.array([1.0, np.nan, 2.0])
    on = tracker.run(plots[1:], tracker.run(plots[:1], start)[-1])
    np.testing.assert_array_equal(tracker.run(plots, start)[1:], on)


def test_single_precision_stays_single_and_no_scans_are_natural() -> None:
    tracker = fixed_gain.fading_memory(2, np.float32(0.8), np.float32(2), np.float32(30))
    assert {tracker.gain.dtype, tracker.covariance.dtype} == {np.dtype(np.float32)}
    states = tracker.run(np.zeros((5, 3), np.float32), np.zeros(3, np.float32))
    assert (states.dtype, states.shape) == (np.dtype(np.float32), (5, 3, 3))
    assert tracker.run(np.zeros((0, 3)), np.zeros(3)).shape == (0, 3, 3)
    assert tracker.run(np.zeros((5, 0)), np.zeros(3)).shape == (5, 0, 3)


@given(T=st.floats(-3, 3), std=st.floats(-6, 6), index=st.floats(-8.9, 2.9), fading=st.floats(1e-3, 0.9999))
@share(0.2)
def test_no_filter_of_the_domain_is_refused_for_its_covariance(
    T: float, std: float, index: float, fading: float
) -> None:
    period, deviation, acceleration = (10.0**power for power in (T, std, index + std - 2 * T))
    fixed_gain.alpha_beta(period, deviation, acceleration)
    fixed_gain.alpha_beta_gamma(period, deviation, acceleration)
    for degree in range(4):
        fixed_gain.fading_memory(degree, fading, period, deviation)


STEADY = fixed_gain.alpha_beta(2.0, 20.0, 1.0)


@pytest.mark.parametrize(
    ("call", "error", "message"),
    [
        (lambda: fixed_gain.alpha_beta(0.0, 1.0, 1.0), ValueError, "period must be from 0.001 to 1000 s"),
        (lambda: fixed_gain.alpha_beta(1.0, np.nan, 1.0), ValueError, "range_std must be finite"),
        (lambda: fixed_gain.alpha_beta(1.0, 1.0, -1.0), ValueError, "acceleration_std must be from"),
        (lambda: fixed_gain.alpha_beta(1.0, 1.0, "1"), TypeError, "acceleration_std must be real"),
        (
            lambda: fixed_gain.alpha_beta_gamma(1.0, 1.0, 2e3),
            ValueError,
            "tracking index .* must be from 1e-09 to 1000",
        ),
        (lambda: fixed_gain.alpha_beta([1.0] * 2, [1.0] * 3, 1.0), ValueError, r"period \(2,\), range_std \(3,\)"),
        (lambda: fixed_gain.fading_memory(4, 0.5, 1.0, 1.0), ValueError, "degree must be from 0 to 3; got 4"),
        (lambda: fixed_gain.fading_memory(True, 0.5, 1.0, 1.0), TypeError, "degree must be a whole number"),
        (lambda: fixed_gain.fading_memory(1, 1.0, 1.0, 1.0), ValueError, "fading must be from 0.001 to 0.9999"),
        (
            lambda: fixed_gain.fading_memory(3, *(np.float32(x) for x in (0.9999, 1e3, 1e-6))),
            ValueError,
            "covariance of the filter must be of variances",
        ),
        (lambda: STEADY.run(1.0, [0.0, 0.0]), ValueError, r"measured must have shape \(..., scans\)"),
        (lambda: STEADY.run([np.inf], [0.0, 0.0]), ValueError, "measured must be finite, or NaN where missing"),
        (lambda: STEADY.run([1.0], [0.0]), ValueError, r"start must have shape \(..., 2\)"),
        (lambda: STEADY.run([1.0], [0.0, np.nan]), ValueError, "start must be finite"),
        (lambda: STEADY.run(np.ones((2, 1)), np.ones((3, 2))), ValueError, r"measured \(2,\), start \(3,\)"),
        (lambda: STEADY.run([1.0], [1.7e308, 1.7e308]), ValueError, "states of the result must be finite"),
        (lambda: FixedGainFilter(-1.0, [0.5], [[1.0]]), ValueError, "period must be more than 0"),
        (lambda: FixedGainFilter(1.0, 0.5, [[1.0]]), ValueError, r"gain must have shape \(..., n\)"),
        (lambda: FixedGainFilter(1.0, [0.5, 0.1], [[1.0]]), ValueError, r"covariance must have shape \(..., 2, 2\)"),
        (lambda: FixedGainFilter(1.0, [0.5], [[-1.0]]), ValueError, "covariance must be without a negative variance"),
        (
            lambda: FixedGainFilter(1.0, [0.5, 0.1], [[1.0, 0.0], [0.5, 1.0]]),
            ValueError,
            "covariance must be symmetric",
        ),
    ],
)
def test_bad_arguments_are_named(call: Any, error: type[Exception], message: str) -> None:
    with pytest.raises(error, match=message):
        call()


def test_a_filter_stays_as_it_is_whatever_becomes_of_the_arrays_that_made_it() -> None:
    parts = np.array(2.0), np.array([0.5, 0.1]), np.eye(2)
    tracker = fixed_gain.FixedGainFilter(*parts)
    for part, own in zip(parts, (tracker.period, tracker.gain, tracker.covariance), strict=True):
        before = own.copy()
        part[...] = 7.0
        np.testing.assert_array_equal(own, before)
        with pytest.raises(ValueError, match="read-only"):
            own[...] = 7.0
