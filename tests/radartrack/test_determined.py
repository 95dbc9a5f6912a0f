"""Which observations determine a polynomial: the filter against the rank in rational arithmetic."""

from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from radartrack import FiniteSampleFilter, kalman
from tests.least_squares import ExactFit
from tests.radartrack.fits import assert_fits, fit_of, observations

REFUSED = r"must determine a polynomial|k must be at least"
BEST = 2e-8  # what is determined least by floating point alone keeps some nine digits
periods = st.sampled_from([0.1, 1 / 3, 2.7, 4.8, 12.3, 10.0, 1e-3]) | st.floats(1e-3, 1e3)
filters = st.builds(
    FiniteSampleFilter,
    period=periods,
    range_std=st.sampled_from([5.0, 250.0]),
    rate_std=st.sampled_from([None, None, 0.5, 15.0]),
    degree=st.integers(0, 3),
    lag=st.sampled_from([0.0, -3.0, 1.5]),
)


@st.composite
def presence(draw: st.DrawFn, count: int) -> list[bool]:
    """Few of many are present as often as most."""
    some = draw(st.sets(st.integers(0, count - 1), max_size=4))
    most = draw(st.booleans())
    return [(place in some) != most for place in range(count)]


@st.composite
def even_plots(draw: st.DrawFn, f: FiniteSampleFilter) -> tuple[Any, Any, Any]:
    """Exact times, and ranges and rates, some of them missing."""
    count = draw(st.integers(1, 12))
    ranges, rates = observations((count,), draw(st.integers(0, 9)))
    ranges = np.where(draw(presence(count)), ranges, np.nan)
    rates = np.where(draw(presence(count)), rates, np.nan) if f.rate_std is not None else np.full(count, np.nan)
    return [n * Fraction(f.period) for n in range(count)], ranges, rates


@st.composite
def uneven_plots(draw: st.DrawFn, f: FiniteSampleFilter) -> tuple[Any, Any, Any]:
    """Times of which some are equal, nearly equal, or midway between others; and ranges and rates, some missing."""
    pool = draw(st.lists(st.floats(0, 100), min_size=1, max_size=3, unique=True))
    pool += [(pool[0] + pool[-1]) / 2, pool[0] + draw(st.sampled_from([2.0**-n for n in range(4, 46)]))]
    offset = draw(st.sampled_from([0.0, 0.0, 1e6, 1e9]))
    times = np.sort(draw(st.lists(st.sampled_from(pool), min_size=1, max_size=7))) + offset
    ranges, rates = observations(times.shape, draw(st.integers(0, 9)))
    if draw(st.booleans()):
        ranges = np.where(draw(presence(len(times))), ranges, np.nan)
    if f.rate_std is None or draw(st.booleans()):
        rates = np.where(draw(presence(len(times))), rates, np.nan) if f.rate_std is not None else np.nan * rates
    return times, ranges, rates


def exact(f: FiniteSampleFilter, times: Any, ranges: Any, rates: Any) -> ExactFit | None:
    try:
        return fit_of(f, times, ranges, rates)
    except ZeroDivisionError:
        return None


def supported(f: FiniteSampleFilter, times: Any, ranges: Any, rates: Any) -> int:
    """The highest degree that is determined, at most that of the filter; -1 for none."""
    degrees = range(f.degree, -1, -1)
    kinds = [FiniteSampleFilter(f.period, f.range_std, f.rate_std, degree, f.lag) for degree in degrees]
    return next((kind.degree for kind in kinds if exact(kind, times, ranges, rates) is not None), -1)


def assert_decides_as(f: FiniteSampleFilter, plots: tuple[Any, Any, Any], **arguments: Any) -> None:
    times, ranges, rates = plots
    given_rates = None if f.rate_std is None else rates
    fit = exact(f, times, ranges, rates)
    if fit is None:
        with pytest.raises(ValueError, match=REFUSED):
            f.estimate(ranges, given_rates, **arguments)
    else:
        assert_fits(f.estimate(ranges, given_rates, **arguments), fit, ranges, rates, f.range_std, BEST)


@given(f=filters, data=st.data())
def test_an_estimate_of_even_scans_is_refused_where_the_exact_rank_is_short_and_right_elsewhere(
    f: FiniteSampleFilter, data: st.DataObject
) -> None:
    assert_decides_as(f, data.draw(even_plots(f)))


@given(f=filters, data=st.data())
def test_an_estimate_of_uneven_times_is_refused_where_the_exact_rank_is_short_and_right_elsewhere(
    f: FiniteSampleFilter, data: st.DataObject
) -> None:
    plots = data.draw(uneven_plots(f))
    assert_decides_as(f, plots, times=plots[0])


@given(f=filters, data=st.data(), uneven=st.booleans(), window=st.sampled_from([None, 3]))
def test_a_run_fits_the_degree_that_the_exact_rank_supports(
    f: FiniteSampleFilter, data: st.DataObject, *, uneven: bool, window: int | None
) -> None:
    times, ranges, rates = data.draw(uneven_plots(f) if uneven else even_plots(f))
    run = f.run(ranges, None if f.rate_std is None else rates, times=np.array(times) if uneven else None, window=window)
    for end in range(1, len(times) + 1):
        part = slice(0 if window is None else max(end - window, 0), end)
        assert run.degree[end - 1] == supported(f, times[part], ranges[part], rates[part])
        known = np.arange(f.degree + 1) <= run.degree[end - 1]
        assert np.array_equal(np.isfinite(run.state[end - 1]), known)
        assert np.array_equal(np.isfinite(run.covariance[end - 1]), np.outer(known, known))


@given(f=filters.filter(lambda f: not f.lag), data=st.data())
def test_a_kalman_filter_starts_where_the_exact_rank_is_full(f: FiniteSampleFilter, data: st.DataObject) -> None:
    times, ranges, rates = data.draw(even_plots(f))
    k = len(times)
    if k < f.fewest_scans:
        return
    handed, given_rates = f.kalman(k), None if f.rate_std is None else rates
    if exact(f, times, ranges, rates) is None:
        with pytest.raises(ValueError, match=REFUSED):
            handed.run(ranges, given_rates)
    else:
        found, estimate = handed.run(ranges, given_rates), f.estimate(ranges, given_rates)
        assert np.array_equal(found.state, estimate.state[np.newaxis])
        assert np.array_equal(found.covariance, estimate.covariance[np.newaxis])


@pytest.mark.parametrize("gap", [10.0**-n for n in (0, 3, 6, 8, 10, 12, 14, 15, 16, 18, 40, 100, 150, 299)])
@pytest.mark.parametrize("rate_std", [None, 15.0])
def test_two_plots_however_near_determine_what_they_determine(gap: float, rate_std: float | None) -> None:
    """Two of three times differ by as little as 1e-299 s: what determines the parabola is tiny, but there.

    At 1e-299 s its variance is more than a float holds.
    """
    f = FiniteSampleFilter(10.0, 250.0, rate_std)
    times, ranges = np.array([-30.0, 0.0, gap]), np.array([1e4, 1.01e4, 1.02e4])
    rates = np.array([np.nan, np.nan, np.nan if rate_std is None else -3.0])
    arguments = (ranges,) if rate_std is None else (ranges, rates)
    if gap > 1e-200 or rate_std is not None:
        assert_fits(f.estimate(*arguments, times=times), fit_of(f, times, ranges, rates), ranges, rates, 250.0, 1e-7)
    else:
        with pytest.raises(ValueError, match="must give a state and a covariance that float64 holds"):
            f.estimate(*arguments, times=times)


@pytest.mark.parametrize("missed", [1.0, 1e3, 1e9])
@pytest.mark.parametrize("gap", [10.0**-n for n in (0, 3, 6, 9, 10, 11, 12, 13, 16, 40)])
@pytest.mark.parametrize(("degree", "lag"), [(1, 0.0), (2, 0.0), (3, -2.5)])
def test_scans_near_each_other_keep_their_digits_beside_a_newest_one_that_is_missed(
    degree: int, lag: float, gap: float, missed: float
) -> None:
    """Counted from the newest scan, the times of what is seen would be rounded to its digits."""
    f = FiniteSampleFilter(10.0, 250.0, degree=degree, lag=lag)
    times = np.array([*gap * np.array([0.3, 1.3, 1.9, 2.4])[: degree + 1], missed + 3 * gap])
    ranges = np.append(1e4 + 20.0 * np.arange(degree + 1), np.nan)
    fit = fit_of(f, times, ranges, np.full(degree + 2, np.nan))
    assert_fits(f.estimate(ranges, times=times), fit, ranges, np.zeros(degree + 2), 250.0, BEST)


@pytest.mark.parametrize("ratio", [1e-50, 1e-20, 1e-9, 1e9, 1e12])
@pytest.mark.parametrize("count", [2, 3])
def test_the_worth_of_the_rates_does_not_change_what_is_determined(ratio: float, count: int) -> None:
    """Closed forms and normal equations alike, from C = 1e-50 to 1e12."""
    rate_std = 20.0 / 3.0 / np.sqrt(ratio) * (1 + 1e-12)
    f = FiniteSampleFilter(3.0, 20.0, rate_std, 3)
    ranges, rates = np.array([3.0, 5.0, 4.0])[:count], np.array([-1.0, 2.0, 1.5])[:count]
    times = np.arange(count) * 3.0
    fit = fit_of(f, times, ranges, rates)
    for found in (f.estimate(ranges, rates), f.estimate(ranges, rates, times=times)):
        assert_fits(found, fit, ranges, rates, 20.0, 1e-9, rate_std)


@pytest.mark.parametrize("offset", [1e9, -1e9, 3e12])
@given(period=st.sampled_from([4.0, 0.5, 2.0**-6]), lag=st.floats(-20, 20))
def test_a_lag_keeps_its_digits_beside_large_time_stamps(offset: float, period: float, lag: float) -> None:
    f = FiniteSampleFilter(period, 250.0, lag=lag)
    ranges, _ = observations((8,))
    near, far = (f.estimate(ranges, times=start + np.arange(8) * period) for start in (0.0, offset))
    assert np.array_equal(near.state, far.state)
    assert np.array_equal(near.covariance, far.covariance)


def test_a_rate_just_midway_between_two_ranges_never_makes_a_parabola() -> None:
    """However the times round: a thousand triples of which the middle one is exactly the middle."""
    first, last = np.sort(np.random.default_rng(3).uniform(0, 100, size=(2, 3000)), axis=0)
    middle = (first + last) / 2
    exactly = [Fraction(a) + Fraction(b) == 2 * Fraction(m) for a, b, m in zip(first, last, middle, strict=True)]
    times = np.stack([first, middle, last], axis=-1)[exactly]
    assert len(times) > 1000
    ranges, rates = np.array([1e4, np.nan, 1.1e4]), np.array([np.nan, -3.0, np.nan])
    run = FiniteSampleFilter(10.0, 250.0, 15.0).run(ranges, rates, times=times)
    assert (run.degree == [0, 1, 1]).all()
    off = times + np.array([0.0, 1e-3, 0.0])
    assert (FiniteSampleFilter(10.0, 250.0, 15.0).run(ranges, rates, times=off).degree == [0, 1, 2]).all()


@pytest.mark.parametrize("period", [1.0, 0.1, 2.7, 1 / 3, 1e-3])
@pytest.mark.parametrize(("ranges", "rates"), [([0, 6], [0, 4]), ([0, 3, 8], [6]), ([0, 6], [2, 6]), ([2, 5, 10], [8])])
def test_as_many_data_as_coefficients_that_leave_a_cubic_open(
    period: float, ranges: list[int], rates: list[int]
) -> None:
    """A cubic whose value is 0 at the ranges and whose slope is 0 at the rates, by construction."""
    values = [np.where(np.isin(np.arange(11), places), 1.0, np.nan) for places in (ranges, rates)]
    f = FiniteSampleFilter(period, 250.0, 15.0, 3)
    for first in (0, max(ranges[0], rates[0]) // 2):
        with pytest.raises(ValueError, match="support degree 2"):
            f.estimate(*(part[first:] for part in values))
    values[1][rates[0] + 1] = 1.0
    assert np.isfinite(f.estimate(*values).state).all()


def test_the_reported_tracks_with_too_few_ranges_are_refused() -> None:
    nan = np.nan
    f = FiniteSampleFilter(0.1, 100.0)
    with pytest.raises(ValueError, match="support degree 1"):
        f.estimate([1e4, nan, 1.01e4, nan, nan])
    assert f.run([1e4, nan, 1.01e4, nan, nan]).degree.tolist() == [0, 0, 1, 1, 1]
    with pytest.raises(ValueError, match="support degree 1"):
        f.estimate([1e4, 1.01e4, 1.02e4], times=[50.762171791287244, 95.26484164164926, 95.26484164164926])


def test_a_belief_of_a_start_is_one_that_kalman_takes() -> None:
    started = FiniteSampleFilter(0.1, 100.0).estimate(observations((6,))[0])
    kalman.predict(kalman.Belief(*started), kalman.constant_acceleration(0.1, 1.0))
