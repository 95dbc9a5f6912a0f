"""The filter: against exact least squares, for any pattern of what is missing, and one track like many."""

import re
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import radartrack as rt
from radartrack import FiniteSampleFilter
from tests.radartrack.fits import assert_fits, fit_of, observations, state_of

RADARS = [
    (10.0, 250.0, 35.0),
    (10.0, 250.0, 25.0),
    (10.0, 250.0, 15.0),
    (5.0, 250.0, 15.0),
    (10.0, 50.0, 1.0),
    (5.0, 50.0, 1.0),
]
filters = st.builds(
    FiniteSampleFilter,
    period=st.sampled_from([1.0, 5.0, 10.0]),
    range_std=st.sampled_from([5.0, 50.0, 250.0]),
    rate_std=st.sampled_from([None, 0.5, 15.0, 400.0]),
    degree=st.integers(0, 3),
    lag=st.sampled_from([0.0, -3.0, 1.5]),
)


@pytest.mark.parametrize(("period", "range_std", "rate_std"), RADARS)
@pytest.mark.parametrize("degree", range(4))
def test_the_six_radars_get_the_exact_least_squares_estimate(
    period: float, range_std: float, rate_std: float, degree: int
) -> None:
    ranges, rates = observations((12,))
    f = FiniteSampleFilter(period, range_std, rate_std, degree)
    fit = fit_of(f, np.arange(12) * period, ranges, rates)
    assert_fits(f.estimate(ranges, rates), fit, ranges, rates, range_std, 1e-13)


@given(f=filters, count=st.integers(1, 12), data=st.data())
def test_any_pattern_of_missing_observations_gets_the_exact_estimate(
    f: FiniteSampleFilter, count: int, data: st.DataObject
) -> None:
    present = st.lists(st.booleans(), min_size=count, max_size=count)
    ranges, rates = (
        np.where(data.draw(present), values, np.nan) for values in observations((count,), data.draw(st.integers(0, 99)))
    )
    given_rates = None if f.rate_std is None else rates
    rates = np.full(count, np.nan) if f.rate_std is None else rates
    try:
        fit = fit_of(f, np.arange(count) * f.period, ranges, rates)
    except ZeroDivisionError:
        with pytest.raises(ValueError, match=r"must determine a polynomial|k must be at least"):
            f.estimate(ranges, given_rates)
    else:
        assert_fits(f.estimate(ranges, given_rates), fit, ranges, rates, f.range_std, 1e-10)


@given(f=filters, gaps=st.lists(st.floats(0.5, 30.0), min_size=5, max_size=9), seed=st.integers(0, 99))
def test_uneven_times_get_the_exact_estimate(f: FiniteSampleFilter, gaps: list[float], seed: int) -> None:
    times = np.cumsum(gaps)
    ranges, rates = observations(times.shape, seed)
    if f.rate_std is None:
        estimate = f.estimate(ranges, times=times)
        rates = np.full_like(ranges, np.nan)
    else:
        estimate = f.estimate(ranges, rates, times=times)
    assert_fits(estimate, fit_of(f, times, ranges, rates), ranges, rates, f.range_std, 1e-11)


@given(f=filters, count=st.integers(4, 40))
def test_normal_equations_agree_with_closed_forms(f: FiniteSampleFilter, count: int) -> None:
    ranges, rates = observations((3, count))
    given_rates = None if f.rate_std is None else rates
    closed = f.estimate(ranges, given_rates)
    general = f.estimate(ranges, given_rates, times=np.arange(count) * f.period)
    deviations = np.sqrt(np.diagonal(closed.covariance[0]))
    assert np.all(np.abs(closed.state - general.state) <= 1e-12 * deviations * 1e5 / f.range_std * 4)
    assert np.allclose(closed.covariance, general.covariance, rtol=1e-9, atol=0) or np.all(
        np.abs(closed.covariance - general.covariance) <= 1e-12 * np.outer(deviations, deviations)
    )


@pytest.mark.parametrize("rate_std", [None, 15.0])
@pytest.mark.parametrize("missing", [0.0, 0.05])
@pytest.mark.parametrize("dtype", [np.float64, np.float32])
def test_one_track_and_a_hundred_thousand_give_the_same_bits(
    rate_std: float | None, missing: float, dtype: type[np.floating[Any]]
) -> None:
    f = FiniteSampleFilter(10.0, 250.0, rate_std)
    ranges, rates = (values.astype(dtype) for values in observations((100_000, 20)))
    holes = np.random.default_rng(5).random(ranges.shape) < missing
    holes[:50_000] = False
    ranges[holes] = np.nan
    many = f.estimate(ranges, None if rate_std is None else rates)
    for track in [0, 1, 255, 256, 49_999, 50_000, 77_777, 99_840, 99_999]:
        one = f.estimate(ranges[track], None if rate_std is None else rates[track])
        assert one.state.dtype == dtype
        assert one.state.tobytes() == many.state[track].tobytes()
        assert np.array_equal(one.covariance, many.covariance[track])


@pytest.mark.parametrize("window", [None, 5, 100])
@pytest.mark.parametrize("holes", [False, True])
def test_a_run_is_the_estimates_of_its_windows(window: int | None, holes: bool) -> None:
    f = FiniteSampleFilter(10.0, 250.0, 15.0)
    ranges, rates = observations((2, 3, 70))
    if holes:
        ranges[1, 2, [3, 50]] = rates[1, 2, 50] = np.nan
    run = f.run(ranges, rates, window=window)
    assert run.state.shape == (2, 3, 70, 3)
    assert run.covariance.shape == (2, 3, 70, 3, 3)
    for end in (2, 3, 32, 33, 51, 70):
        part = slice(0 if window is None else max(end - window, 0), end)
        estimate = f.estimate(ranges[..., part], rates[..., part])
        deviations = np.sqrt(np.diagonal(estimate.covariance, axis1=-2, axis2=-1))
        assert np.all(np.abs(run.state[..., end - 1, :] - estimate.state) <= 1e-12 * deviations * 4e2)
        assert np.allclose(run.covariance[..., end - 1, :, :], estimate.covariance, rtol=1e-12, atol=1e-12)


@pytest.mark.parametrize("window", [None, 6])
def test_no_estimate_depends_on_later_observations(window: int | None) -> None:
    f = FiniteSampleFilter(10.0, 250.0, 15.0)
    ranges, rates = observations((3, 60))
    before = f.run(ranges, rates, window=window)
    ranges[1, 40:] = rates[2, 40:] = np.nan
    after = f.run(ranges, rates, window=window)
    assert before.state[:, :40].tobytes() == after.state[:, :40].tobytes()
    assert np.array_equal(before.covariance[:, :40], after.covariance[:, :40], equal_nan=True)


def test_a_run_of_one_track_has_the_bits_of_a_run_of_many() -> None:
    f = FiniteSampleFilter(10.0, 250.0, 15.0)
    ranges, rates = observations((1000, 45))
    ranges[::7, 11] = np.nan
    many = f.run(ranges, rates)
    for track in (0, 1, 500, 994, 999):
        one = f.run(ranges[track], rates[track])
        assert one.state.tobytes() == many.state[track].tobytes()
        assert np.array_equal(one.covariance, many.covariance[track], equal_nan=True)


def test_the_degree_grows_with_the_scans() -> None:
    ranges, rates = observations((5,))
    alone = FiniteSampleFilter(10.0, 250.0, degree=3).run(ranges)
    assert alone.degree.tolist() == [0, 1, 2, 3, 3]
    run = FiniteSampleFilter(10.0, 250.0, 15.0, 3).run(ranges, rates)
    assert run.degree.tolist() == [1, 3, 3, 3, 3]
    assert np.isnan(run.state[0]).tolist() == [False, False, True, True]
    assert run.state[0, :2].tolist() == [ranges[0], rates[0]]
    assert np.sqrt(np.diagonal(run.covariance[0])[:2]).tolist() == [250.0, 15.0]
    nothing = FiniteSampleFilter(10.0, 250.0, 15.0).run(np.full(2, np.nan), np.array([np.nan, 3.0]))
    assert nothing.degree.tolist() == [-1, -1]
    assert np.isnan(nothing.state).all()


@given(f=filters, k=st.integers(4, 30), lag=st.floats(-20, 20))
def test_a_noiseless_polynomial_is_found_at_every_lag(f: FiniteSampleFilter, k: int, lag: float) -> None:
    f = f.at(lag)
    derivatives = np.array([1e5, -200.0, 2.0, 0.01])[: f.degree + 1]
    polynomial = np.polynomial.Polynomial(derivatives / [1, 1, 2, 6][: f.degree + 1])
    times = (np.arange(k) - (k - 1 + lag)) * f.period
    slopes = polynomial.deriv()(times) if f.degree else np.zeros(k)
    found = f.estimate(polynomial(times), None if f.rate_std is None else slopes)
    scale = 1e-11 * np.abs(polynomial(times)).max() * np.sqrt(np.diagonal(found.covariance)) / f.range_std
    assert np.all(np.abs(found.state - derivatives) <= 10 * scale)


def test_weights_are_kept_and_cannot_be_changed() -> None:
    f = FiniteSampleFilter(10.0, 250.0, 15.0)
    first = f.weights(9)
    assert first is f.weights(9)
    assert first.rates is not None
    assert (first.ranges.shape, first.rates.shape) == ((3, 9), (3, 9))
    with pytest.raises(ValueError, match="read-only"):
        first.ranges[0, 0] = 1.0
    covariance = f.covariance(9)
    covariance[:] = 0
    assert f.covariance(9)[0, 0] > 0
    assert FiniteSampleFilter(10.0, 250.0).weights(3).rates is None


def test_weights_and_covariance_belong_together() -> None:
    f = FiniteSampleFilter(5.0, 250.0, 15.0, 3, lag=-2.0)
    ranges, rates = f.weights(25)
    assert rates is not None
    noise = 250.0**2 * ranges @ ranges.T + 15.0**2 * rates @ rates.T
    assert np.allclose(noise, f.covariance(25), rtol=1e-12)


@pytest.mark.parametrize("degree", range(4))
@pytest.mark.parametrize("rate_std", [None, 15.0])
def test_a_kalman_filter_without_process_noise_continues_the_growing_sample(
    degree: int, rate_std: float | None
) -> None:
    f = FiniteSampleFilter(10.0, 250.0, rate_std, degree)
    ranges, rates = observations((4, 30))
    given_rates = None if rate_std is None else rates
    handed = f.kalman(degree + 1).run(ranges, given_rates)
    grown = f.run(ranges, given_rates)
    deviations = np.sqrt(np.diagonal(grown.covariance[0, degree:], axis1=-2, axis2=-1))
    assert np.all(np.abs(handed.state - grown.state[:, degree:]) <= 1e-9 * deviations * 4e2)
    assert np.allclose(handed.covariance, grown.covariance[:, degree:], rtol=1e-7)


@pytest.mark.parametrize("degree", range(4))
@pytest.mark.parametrize("rate_std", [None, 15.0])
def test_a_kalman_filter_that_is_handed_float32_gives_float32(degree: int, rate_std: float | None) -> None:
    f = FiniteSampleFilter(10.0, 250.0, rate_std, degree)
    ranges, rates = (part.astype(np.float32) for part in observations((4, 30)))
    ranges[1, 5] = np.nan
    single, double = (
        f.kalman(degree + 1, 0.1).run(ranges.astype(kind), None if rate_std is None else rates.astype(kind))
        for kind in (np.float32, np.float64)
    )
    assert {part.dtype for part in single} == {np.dtype(np.float32)}
    for part, other in zip(single, double, strict=True):
        np.testing.assert_array_equal(part, other.astype(np.float32))


def test_process_noise_keeps_the_kalman_filter_awake() -> None:
    f = FiniteSampleFilter(10.0, 250.0, 15.0)
    ranges, rates = observations((30,))
    asleep, awake = (f.kalman(3, noise).run(ranges, rates) for noise in (0.0, 1.0))
    assert np.array_equal(asleep.state[0], awake.state[0])
    assert np.all(np.diagonal(awake.covariance[-1]) > 1.5 * np.diagonal(asleep.covariance[-1]))


@pytest.mark.parametrize(
    ("arguments", "error", "message"),
    [
        ((0.0, 1.0), ValueError, "period must be more than 0; got 0"),
        ((1.0, -2.0), ValueError, "range_std must be more than 0; got -2"),
        ((1.0, np.nan), ValueError, "range_std must be finite"),
        ((1.0, 1.0, 0.0), ValueError, "rate_std must be more than 0"),
        ((1.0, 1.0, "3"), TypeError, "rate_std must be a real number; got '3'"),
        ((True, 1.0), TypeError, "period must be a real number; got True"),
        ((1.0, 1.0, None, 4), ValueError, "degree must be from 0 to 3; got 4"),
        ((1.0, 1.0, None, 1.5), TypeError, "degree must be a whole number; got 1.5"),
        ((1.0, 1.0, None, 2, np.inf), ValueError, "lag must be finite"),
        ((1.0, 1.0, None, 2, 1e13), ValueError, r"lag must be from -1e\+12 to 1e\+12; got 1e\+13"),
        ((10**400, 1.0), ValueError, "period must be finite; got 1000"),
        ((1e-100, 1.0), ValueError, r"range_std/period\^n must be from 1e-60 to 1e\+60 .*; got range_std 1 and period"),
        ((1.0, 1e200), ValueError, r"range_std/period\^n must be from"),
        ((1.0, 1.0, 1e40), ValueError, r"must be at most 1e\+12 and at least 1e-60; got 1e-80"),
        ((1e-3, 1e4, 1e-3), ValueError, r"range_std\^2/\(period rate_std\)\^2 must be at most 1e\+12"),
    ],
)
def test_a_filter_that_makes_no_sense_is_refused(arguments: Any, error: type[Exception], message: str) -> None:
    with pytest.raises(error, match=message):
        FiniteSampleFilter(*arguments)


@pytest.mark.parametrize(
    ("rate_std", "k", "message"),
    [
        (None, 2, "k must be at least 3 for degree 2 from range alone; got 2, which supports degree 1"),
        (15.0, 1, "k must be at least 2 for degree 2 from range and range rate; got 1, which supports degree 1"),
        (15.0, 0, "k must be from 1 to 1000000; got 0"),
        (15.0, 1_000_001, "k must be from 1 to 1000000; got 1000001"),
    ],
)
def test_too_few_scans_are_refused_with_what_they_support(rate_std: float | None, k: int, message: str) -> None:
    f = FiniteSampleFilter(10.0, 250.0, rate_std)
    for call in (f.covariance, f.weights, f.kalman):
        with pytest.raises(ValueError, match=message):
            call(k)


@pytest.mark.parametrize("call", [FiniteSampleFilter.estimate, FiniteSampleFilter.run])
@pytest.mark.parametrize("given", [None, "1", [1.0, None], [True, 2.0], object()])
def test_ranges_that_are_no_numbers_are_named(call: Any, given: Any) -> None:
    with pytest.raises(TypeError, match="ranges must be real numbers"):
        call(FiniteSampleFilter(10.0, 250.0), given)


@pytest.mark.parametrize("intensity", [1e308, 1e-320])
def test_an_intensity_whose_matrices_no_float_holds_is_refused_where_it_is_given(intensity: float) -> None:
    with pytest.raises(ValueError, match=re.escape(f"the process noise of intensity {intensity} over 10.0 s")):
        FiniteSampleFilter(10.0, 250.0, degree=2).kalman(3, intensity)


def test_bad_observations_are_refused() -> None:
    f, alone = FiniteSampleFilter(10.0, 250.0, 15.0), FiniteSampleFilter(10.0, 250.0)
    ranges, rates = observations((3, 6))
    with pytest.raises(ValueError, match="rates must be given for a filter with rate_std"):
        f.estimate(ranges)
    with pytest.raises(ValueError, match="rates must be omitted for a filter without rate_std"):
        alone.estimate(ranges, rates)
    with pytest.raises(ValueError, match=r"shapes must broadcast; got ranges \(3, 6\), rates \(3, 5\)"):
        f.estimate(ranges, rates[:, :5])
    with pytest.raises(ValueError, match=r"ranges must be finite, or NaN where missing; got 1 infinite of 18"):
        f.estimate(np.where(np.arange(18).reshape(3, 6) == 7, np.inf, ranges), rates)
    with pytest.raises(ValueError, match=r"rates must be finite, or NaN where missing; got 18 infinite"):
        f.run(ranges, rates - np.inf)
    with pytest.raises(TypeError, match="ranges must be real numbers"):
        f.estimate(ranges.astype(complex), rates)
    with pytest.raises(ValueError, match="ranges must have shape"):
        alone.estimate(3.0)
    with pytest.raises(ValueError, match=r"times must have shape \(\.\.\., k\); got a single number"):
        alone.estimate(ranges, times=1)
    with pytest.raises(ValueError, match="times must not decrease"):
        alone.estimate(ranges, times=[0, 1, 2, 1, 3, 4])
    with pytest.raises(ValueError, match="times must be finite"):
        alone.estimate(ranges, times=[0, 1, 2, np.nan, 3, 4])
    with pytest.raises(ValueError, match="window must be from 1"):
        alone.run(ranges, window=0)
    ranges[1, 2:] = np.nan
    with pytest.raises(ValueError, match=r"track \[1\] support degree 1 \(1 of 3 tracks have too few\)"):
        alone.estimate(ranges)
    with pytest.raises(ValueError, match="lag must be 0 to hand over"):
        f.at(1.0).kalman(3)
    with pytest.raises(ValueError, match="process_noise must be finite and at least 0; got -1"):
        f.kalman(3, -1.0)
    with pytest.raises(ValueError, match="ranges must have at least 7 scans to start from; got 6"):
        f.kalman(7).run(*observations((6,)))


def test_no_tracks_give_no_estimates() -> None:
    f = FiniteSampleFilter(10.0, 250.0, 15.0)
    ranges, rates = observations((0, 6))
    assert f.estimate(ranges, rates).state.shape == (0, 3)
    assert f.run(ranges, rates).state.shape == (0, 6, 3)
    assert rt.FiniteSampleFilter is FiniteSampleFilter


@pytest.mark.parametrize("rate_std", [1e5, 1e-5])
def test_very_unequal_accuracies_are_no_obstacle_to_the_normal_equations(rate_std: float) -> None:
    """C of 1e-10 and 1e10: two scans determine a cubic whatever the range rate is worth."""
    f = FiniteSampleFilter(1.0, 1.0, rate_std, 3)
    ranges, rates = np.array([3.0, 5.0]), np.array([-1.0, 2.0])
    closed, general = f.estimate(ranges, rates), f.estimate(ranges, rates, times=[0.0, 1.0])
    deviations = np.sqrt(np.diagonal(closed.covariance))
    assert np.all(np.abs(general.covariance - closed.covariance) <= 1e-9 * np.outer(deviations, deviations))
    assert np.all(np.abs(general.state - closed.state) <= 1e-9 * deviations)


@pytest.mark.parametrize("offset", [0.0, 1e9])
def test_far_ranges_keep_their_digits_where_a_worthless_rate_determines_the_cubic(offset: float) -> None:
    """Three ranges of 1e9 deviations; the weight of the rate is 1e5 times theirs, and must not round them."""
    f = FiniteSampleFilter(1.0, 50.0, 8e6, 3, lag=1.0)
    ranges, rates, times = 5e10 + np.array([0.0, 3.0, 9.0]), np.array([np.nan, 6e6, np.nan]), offset + np.arange(3.0)
    fit = fit_of(f, times, ranges, rates)
    deviations = 50.0 * np.sqrt([float(row[n]) for n, row in enumerate(fit.covariance)])
    for estimate in (f.estimate(ranges, rates), f.estimate(ranges, rates, times=times)):
        assert np.all(np.abs(estimate.state - state_of(fit, ranges, rates)) <= 1e-6 * deviations)


@pytest.mark.parametrize("window", [None, 4])
def test_observations_whose_sum_overflows_are_none_the_less_finite(window: int | None) -> None:
    f, huge = FiniteSampleFilter(10.0, 250.0, degree=0), np.full((3, 40), 1e308)
    np.testing.assert_allclose(f.estimate(huge).state, 1e308, rtol=1e-14)
    np.testing.assert_allclose(f.run(huge, window=window).state, 1e308, rtol=1e-14)


@pytest.mark.parametrize("scan", [0, 17, 39])
def test_infinities_that_cancel_are_refused(scan: int) -> None:
    f, ranges = FiniteSampleFilter(10.0, 250.0), np.zeros((3, 40))
    ranges[1, scan], ranges[2, scan] = np.inf, -np.inf
    for filtered in (f.estimate, f.run):
        with pytest.raises(ValueError, match="ranges must be finite, or NaN where missing; got 2 infinite of 120"):
            filtered(ranges)


def test_numbers_of_any_type_are_kept_as_floats() -> None:
    """In float32, 0.1 over 0.3 would have seven digits."""
    kinds = FiniteSampleFilter(np.float32(0.5), np.float32(0.1), np.float32(0.3), np.int64(1), np.int8(-2))  # type: ignore[arg-type]
    plain = FiniteSampleFilter(0.5, float(np.float32(0.1)), float(np.float32(0.3)), 1, -2.0)
    assert kinds == plain
    assert {type(getattr(kinds, name)) for name in ("period", "range_std", "rate_std", "lag")} == {float}
