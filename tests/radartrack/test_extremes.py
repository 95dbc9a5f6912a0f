"""Absurd scales: a right number or a ValueError, never infinity, NaN, a warning or another error."""

from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from radartrack import FiniteSampleFilter, simulate
from tests.radartrack.fits import assert_fits, fit_of

floats = st.integers(-323, 308).map(lambda exponent: float(f"1e{exponent}"))
moderate = st.integers(-12, 12).map(lambda exponent: 10.0**exponent)
sizes = floats | moderate
scales = sizes | st.just(10**400)


def attempted(call: Any) -> Any:
    """What a call returns, or None where it refuses."""
    try:
        return call()
    except ValueError:
        return None


@given(
    period=scales,
    range_std=scales,
    rate_std=st.none() | scales,
    degree=st.integers(0, 3),
    lag=st.sampled_from([0.0, -1.0, 1e8]) | scales,
    size=sizes,
    single=st.booleans(),
    path=st.sampled_from(["full", "missing", "times"]),
)
def test_an_estimate_of_any_scale_is_right_or_refused(
    period: Any, range_std: Any, rate_std: Any, degree: int, lag: Any, size: Any, path: str, *, single: bool
) -> None:
    f = attempted(lambda: FiniteSampleFilter(period, range_std, rate_std, degree, lag))
    if f is None:
        return
    ranges = np.array([1.0, 0.5, -0.25, 0.75, 1.0]) * size
    ranges[1] = np.nan if path == "missing" else ranges[1]
    rates = np.array([0.5, np.nan if path == "missing" else 1.0, 1.0, 0.5, -1.0])
    if single and size < 1e38:
        ranges, rates = ranges.astype(np.float32), rates.astype(np.float32)
    times = np.arange(5.0).astype(ranges.dtype) * ranges.dtype.type(3) if path == "times" else None
    arguments = (ranges,) if f.rate_std is None else (ranges, rates)
    found = attempted(lambda: f.estimate(*arguments, times=times))
    run = attempted(lambda: f.run(*arguments, times=times))
    if found is not None:
        exact = np.full(5, np.nan) if f.rate_std is None else rates
        scans = [n * (Fraction(f.period) if times is None else Fraction(3)) for n in range(5)]
        fit = fit_of(f, scans, ranges, exact)
        accuracy = 1e-8 if ranges.dtype == np.float64 else 1e-4
        assert_fits(found, fit, ranges, exact, f.range_std, accuracy, f.rate_std or np.inf)
    if run is not None:
        known = np.arange(f.degree + 1) <= run.degree[..., np.newaxis]
        assert np.isfinite(run.state[known]).all()
        assert (np.diagonal(run.covariance, axis1=-2, axis2=-1)[known] > 0).all()


@pytest.mark.parametrize("scans", [4, 40])
@pytest.mark.parametrize("missing", [0, 2])
@pytest.mark.parametrize("timed", [False, True])
def test_a_state_that_overflows_is_refused(scans: int, missing: int, *, timed: bool) -> None:
    f = FiniteSampleFilter(1e-3, 250.0)
    ranges = np.full((3, scans), 1e306) * (-1.0) ** np.arange(scans)
    ranges[1, :missing] = np.nan
    times = np.arange(scans) * 1e-3 if timed else None
    for filtered in (f.estimate, f.run):
        with pytest.raises(ValueError, match="must give a state and a covariance that float64 holds"):
            filtered(ranges, times=times)


@pytest.mark.parametrize("path", ["full", "missing", "times"])
@pytest.mark.parametrize(("period", "range_std"), [(10.0, 1e25), (1e12, 250.0), (1e-12, 1.0)])
def test_a_covariance_beyond_float32_is_refused_beside_data_in_float32_alone(
    path: str, period: float, range_std: float
) -> None:
    f = FiniteSampleFilter(period, range_std)
    ranges = np.array([[1.0, 2.0, 3.0, np.nan if path == "missing" else 4.0, 5.0]])
    times = np.arange(5.0) * period if path == "times" else None
    assert np.isfinite(f.estimate(ranges, times=times).covariance).all()
    single = None if times is None else times.astype(np.float32)
    for filtered in (f.estimate, f.run):
        with pytest.raises(ValueError, match="to compute in float32"):
            filtered(ranges.astype(np.float32), times=single)


@pytest.mark.parametrize("dtype", [np.float32, np.float64])
@pytest.mark.parametrize("degree", range(4))
@pytest.mark.parametrize("period", [1e-19, 1e-9, 10.0, 1e9, 1e19])
def test_where_the_times_are_given_the_period_is_of_no_account(dtype: Any, degree: int, period: float) -> None:
    """What even scans would have for a covariance is not asked then: in float32 it may be too large or too small."""
    ranges, times = np.array([[1.0, 2.0, 3.0, 5.0, 4.0]], dtype), np.array([0.0, 10.0, 20.0, 25.0, 40.0], dtype)
    f, other = FiniteSampleFilter(period, 20.0, None, degree), FiniteSampleFilter(7.0, 20.0, None, degree)
    for filtered, expected in ((f.estimate, other.estimate), (f.run, other.run)):
        for part, wanted in zip(filtered(ranges, times=times), expected(ranges, times=times), strict=True):
            np.testing.assert_array_equal(part, wanted)


@given(
    position=sizes, velocity=sizes, acceleration=sizes, period=scales, std=scales, rate=scales, turning=st.booleans()
)
def test_plots_of_any_scale_are_finite_or_refused(
    position: Any, velocity: Any, acceleration: Any, period: Any, std: Any, rate: Any, *, turning: bool
) -> None:
    def simulated() -> simulate.Plots:
        target: Any = (
            simulate.Turning((position, position), (velocity, -velocity), rate)
            if turning
            else simulate.Accelerated((position, 0.0), (velocity, 0.0), (acceleration, 0.0))
        )
        noise = {"range_std": std, "azimuth_std": 0.1, "range_rate_std": std}
        radar = simulate.Radar("polar_doppler", period, noise, bias={"r": std})
        return simulate.plots(target, radar, scans=3, trials=2)

    plots = attempted(simulated)
    if plots is not None:
        for values in (plots.t, plots.states, *plots.measured.values(), *plots.truth.values()):
            assert np.isfinite(values).all()
