"""Bias and NEES of every method on simulated targets, each under what it holds fixed.

The bands together miss what they should hold with probability 1e-6 at most. At DRAWS draws an error of the mean
of 3 % of the deviations, and of the NEES of 4 %, is found with probability 0.999.
"""

import contextlib
import math
from statistics import NormalDist
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from radartrack.consistency import Consistency, Given, experiment
from radartrack.convert import Method
from tests.radartrack.plots import CLOSED, METHODS, PLOTS, SENSORS, noise_covariance

PLOT = {"r": 1000.0, "azimuth": 0.0, "range_std": 10.0, "azimuth_std": 0.1}
DRAWS = 100_000
FALSE_ALARM = 1e-6 / 400  # there are fewer bands than 400 here
DEVIATIONS = 1e-3
DEGREES = math.radians(1)

# Errors that matter, far from zero range and from the vertical; the last are within what the series is good for.
POINTS = {name: PLOTS[name] | {"r": 3000.0} for name in SENSORS}
POINTS["ruv"] |= {"range_std": 30.0}


def run(sensor: str, method: Method, given: Given, **changed: Any) -> Consistency:
    """An experiment at the sensor's point; a prediction is as uncertain as half the plot, and differently."""
    point = {**POINTS[sensor], **changed}
    predicts = method == "decorrelated" or given == "prediction"
    matrix = noise_covariance(sensor, {**point, "correlation": 0.7}) / 4 if predicts else None
    name: Any = sensor
    return experiment(
        name, point, method, given, predicted_covariance=matrix, draws=DRAWS, seed=11, false_alarm=FALSE_ALARM
    )


@pytest.mark.parametrize("given", ["truth", "prediction"])
@pytest.mark.parametrize("method", ["unbiased", "decorrelated"])
@pytest.mark.parametrize("sensor", SENSORS)
def test_the_unbiased_estimate_has_no_bias_given_the_truth_nor_averaged_over_a_prediction(
    sensor: str, method: Method, given: Given
) -> None:
    assert run(sensor, method, given).is_unbiased


@pytest.mark.parametrize("sensor", SENSORS)
def test_the_posterior_mean_has_no_bias_given_the_measurement(sensor: str) -> None:
    assert run(sensor, "posterior", "measurement").is_unbiased


@pytest.mark.parametrize(
    ("method", "given"),
    [("unbiased", "measurement"), ("posterior", "measurement"), ("decorrelated", "prediction")],
)
@pytest.mark.parametrize("sensor", SENSORS)
def test_the_covariance_tells_the_size_of_the_error_under_its_own_condition(
    sensor: str, method: Method, given: Given
) -> None:
    assert run(sensor, method, given).is_consistent


@pytest.mark.parametrize("given", ["truth", "measurement"])
@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("sensor", SENSORS)
def test_where_errors_are_small_every_method_is_unbiased_and_consistent_under_every_condition(
    sensor: str, method: Method, given: Given
) -> None:
    plot = POINTS[sensor]
    small = {name: DEVIATIONS * plot[name] for name in plot if name.endswith("_std")} | {"range_std": 0.3}
    found = run(sensor, method, given, **small)
    assert found.is_unbiased
    assert found.is_consistent


@pytest.mark.parametrize(
    ("method", "given"),
    [("linear", "truth"), ("linear", "measurement"), ("unbiased", "measurement"), ("posterior", "truth")],
)
@pytest.mark.parametrize("sensor", CLOSED)
def test_bias_under_another_condition_is_noticed(sensor: str, method: Method, given: Given) -> None:
    assert not run(sensor, method, given).is_unbiased


@pytest.mark.parametrize("method", ["linear", "second_order"])
@pytest.mark.parametrize("sensor", CLOSED)
def test_covariances_that_are_too_small_are_noticed(sensor: str, method: Method) -> None:
    found = run(sensor, method, "measurement", r=30_000.0)
    assert not found.is_consistent
    assert found.nees > 1.2


FAR_OFF = {1e3: 1.1, 10e3: 10.0, 70e3: 500.0}


@pytest.mark.parametrize("given", ["truth", "measurement"])
@pytest.mark.parametrize("r", FAR_OFF)
def test_at_ten_degrees_linear_conversion_is_far_off_and_the_others_are_consistent(r: float, given: Given) -> None:
    plot = {"r": r, "azimuth": 45 * DEGREES, "range_std": 50.0, "azimuth_std": 10 * DEGREES}
    nees = {method: experiment("polar", plot, method, given, draws=DRAWS).nees for method in METHODS[:5]}
    assert nees["linear"] > FAR_OFF[r]
    assert nees["second_order"] > 1.1
    assert nees["averaged"] == pytest.approx(1, abs=0.05)
    assert nees["unbiased"] == pytest.approx(1, abs=0.03)
    assert nees["posterior"] == pytest.approx(1, abs=0.03)


# The instrument itself.


def test_the_bias_is_converted_minus_true() -> None:
    """The plain conversion shortens: e^(-σ²/2) of the range is left."""
    found = experiment("polar", PLOT | {"range_std": 1.0, "azimuth_std": 0.5}, "linear")
    expected = 1000 * math.expm1(-0.125)
    assert found.bias_band[0, 0] < expected < found.bias_band[0, 1]
    assert found.bias_band[1, 0] < 0 < found.bias_band[1, 1]


def test_the_nees_is_one_where_error_and_covariance_are_those_of_a_normal_variable() -> None:
    found = experiment("polar", PLOT | {"r": 1e6, "range_std": 1.0, "azimuth_std": 1e-9}, "linear", draws=50_000)
    half_width = NormalDist().inv_cdf(1 - 1e-3 / 2) / math.sqrt(50_000)  # the variance of χ²/2 with two degrees is 1
    assert found.nees_band == pytest.approx([found.nees - half_width, found.nees + half_width], rel=1e-3)
    assert found.is_consistent


@pytest.mark.parametrize("false_alarm", [0.5, 0.2])
def test_the_bands_miss_as_often_as_stated(false_alarm: float) -> None:
    """In 400 experiments, two-sided at 1e-6 by the normal quantile; a rate wrong by a half is found."""
    plot = {"r": 1000.0, "azimuth": 0.3, "range_std": 10.0, "azimuth_std": 0.2}
    runs = [
        experiment("polar", plot, "posterior", "measurement", draws=400, seed=seed, false_alarm=false_alarm)
        for seed in range(400)
    ]
    missed = np.mean([not run.is_consistent for run in runs])
    spread = math.sqrt(false_alarm * (1 - false_alarm) / 400)
    assert abs(missed - false_alarm) < -NormalDist().inv_cdf(1e-6 / 2) * spread


def test_a_correlation_of_errors_is_simulated() -> None:
    plot = {"r": 1000.0, "azimuth": 0.0, "range_std": 10.0, "azimuth_std": 0.01}
    right = experiment("polar", plot | {"correlation": 0.9}, "linear", "truth")
    assert right.nees == pytest.approx(1, abs=0.02)


def test_the_same_seed_gives_the_same_result() -> None:
    plot = {"r": 1000.0, "azimuth": 0.0, "range_std": 10.0, "azimuth_std": 0.1}
    first, same, other = (experiment("polar", plot, draws=100, seed=seed) for seed in (1, 1, 2))
    assert first.nees == same.nees
    assert first.nees != other.nees


@pytest.mark.parametrize(
    ("changed", "error", "message"),
    [
        ({"sensor": "sonar"}, ValueError, r"sensor must be one of .*; got 'sonar'"),
        ({"method": "best"}, ValueError, r"method must be one of .*; got 'best'"),
        ({"given": "nothing"}, ValueError, r"given must be one of \['truth', .*; got 'nothing'"),
        ({"draws": 1}, ValueError, r"draws must be at least 2; got 1"),
        ({"draws": 2.5}, TypeError, r"draws must be a whole number; got 2.5"),
        ({"false_alarm": 0.0}, ValueError, r"false_alarm must be from 1e-09 to 0.5; got 0.0"),
        ({"false_alarm": math.nan}, ValueError, r"false_alarm must be from 1e-09 to 0.5; got nan"),
        (
            {"plot": PLOT | {"elevation": 0.1}},
            TypeError,
            r"plot must have the arguments \['r', 'azimuth', .*; got .*'elevation'",
        ),
        ({"plot": PLOT | {"r": [1.0, 2.0]}}, TypeError, r"r must be one number; got shape \(2,\)"),
        ({"plot": PLOT | {"r": -1.0}}, ValueError, r"r must be from 0 to"),
        ({"plot": PLOT | {"range_std": 1e3}}, ValueError, r"r must be from 0 to 1e\+100 m .*; got -.* at \["),
        ({"plot": PLOT | {"azimuth_std": 0.0}}, ValueError, r"the covariance is singular: deviations must be positive"),
        ({"method": "decorrelated"}, ValueError, r"predicted_covariance must be given for the method 'decorr"),
        ({"given": "prediction"}, ValueError, r"predicted_covariance must be given for .*; got None"),
        ({"predicted_covariance": np.eye(2)}, ValueError, r"and only there; got array"),
        (
            {"given": "prediction", "predicted_covariance": np.broadcast_to(np.eye(2), (3, 2, 2))},
            ValueError,
            r"predicted_covariance must be one matrix, shape \(n, n\); got shape \(3, 2, 2\)",
        ),
        ({"seed": -1}, ValueError, "seed must be at least 0; got -1"),
        ({"false_alarm": "0.1"}, TypeError, "false_alarm must be a real number; got '0.1'"),
        (
            {"method": "decorrelated", "predicted_covariance": -np.eye(2)},
            ValueError,
            r"predicted covariance must be without a negative variance",
        ),
    ],
)
def test_bad_arguments_are_named_with_what_was_given_and_what_is_allowed(
    changed: dict[str, Any], error: type[Exception], message: str
) -> None:
    with pytest.raises(error, match=message):
        experiment(**{"sensor": "polar", "plot": PLOT, "draws": 1000, **changed})


@pytest.mark.parametrize("range_std", [0.0, 5e-324, 1e-139, 1e-3, 1e98])
@pytest.mark.parametrize("r", [0.0, 5e-324, 1e-139, 1e4, 1e99])
@pytest.mark.parametrize("sensor", SENSORS)
def test_any_size_gives_finite_averages_or_a_refusal(sensor: Any, r: float, range_std: float) -> None:
    plot = {name: value for name, value in PLOTS[sensor].items() if name != "correlation"}
    rates = {name: value for name, value in (("range_rate", -1e49), ("range_rate_std", 1e-139)) if name in plot}
    for changed in ({}, rates):
        finite = True
        refused = ""
        try:
            found = experiment(sensor, plot | {"r": r, "range_std": range_std} | changed, draws=20)
            finite = all(np.isfinite(part).all() for part in found)
        except ValueError as error:
            refused = str(error)
        assert finite
        assert refused.startswith(("the covariance is singular", "r must be from 0")) or not refused


@pytest.mark.parametrize("correlation", [1.0, -1.0])
def test_a_covariance_that_is_singular_but_for_rounding_is_refused(correlation: float) -> None:
    plot = {"r": 1e4, "azimuth": 0.3, "range_std": 50.0, "azimuth_std": 0.01, "correlation": correlation}
    with pytest.raises(ValueError, match="the covariance is singular"):
        experiment("polar", plot, "linear", draws=20)


POWERS = st.integers(-100, 60).map(lambda power: 10.0**power)


@given(
    ranges=st.tuples(POWERS, POWERS), rates=st.tuples(POWERS, POWERS), azimuth_std=st.sampled_from([1e-9, 1e-4, 1.0])
)
def test_averages_of_any_scale_are_finite_or_refused(
    ranges: tuple[float, float], rates: tuple[float, float], azimuth_std: float
) -> None:
    (r, range_std), (range_rate, range_rate_std) = ranges, (min(rate, 1e50) for rate in rates)
    plot = {"r": r, "azimuth": 0.0, "range_rate": range_rate, "range_std": range_std, "azimuth_std": azimuth_std}
    for method in ("linear", "unbiased"):
        with contextlib.suppress(ValueError):
            found = experiment("polar_doppler", plot | {"range_rate_std": range_rate_std}, method, draws=4)
            assert all(np.isfinite(part).all() for part in found)
