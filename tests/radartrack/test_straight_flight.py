"""The comparison of weights around a straight flight."""

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from radartrack import straight_flight
from radartrack.simulate import Radar
from radartrack.straight_flight import CALIBRATED, FLIGHT, Comparison, Station, compare, situations

RUNS = 1000


@pytest.fixture(scope="module")
def results() -> dict[str, Comparison]:
    return {name: compare(radars, runs=RUNS) for name, radars in situations().items()}


def test_plots_scatter_about_the_flight_as_the_radar_says() -> None:
    """From 400 runs of 81 plots a deviation that is wrong by 3 % is detected at six standard errors."""
    noise = {"range_std": 60.0, "azimuth_std": 0.004, "elevation_std": 0.003}
    radar = Radar("spherical", 5.0, noise, (-30e3, -20e3), {"r": 500.0, "azimuth": 0.02})
    plots = straight_flight.plots_of(Station(radar, ageing=2.0), 400, 1)
    x, y, height = FLIGHT.states(plots.t)[:, :3].T
    east, north = x - radar.site[0], y - radar.site[1]
    truths = np.hypot(np.hypot(east, north), height), np.arctan2(east, north)
    for measured, truth, bias, std in (
        (plots.r, truths[0], 500.0, 120.0),
        (plots.azimuth, truths[1], 0.02, 0.008),
        (plots.elevation, np.arctan2(height, np.hypot(east, north)), 0.0, 0.006),
    ):
        error = measured - truth
        assert error.mean() == pytest.approx(bias, abs=6 * std / np.sqrt(error.size))
        assert error.std() == pytest.approx(std, rel=6 / np.sqrt(2 * error.size))


def test_with_errors_as_stated_propagation_has_the_best_weights_and_the_print_costs_a_quarter_more(
    results: dict[str, Comparison],
) -> None:
    excess = results["calibrated"].excess
    assert all(excess[name].lower > 0 for name in ("equal", "stated", "printed", "consistent"))
    assert 0.15 < excess["printed"].value < 0.4
    assert excess["consistent"].value < 0.05
    assert excess["covariance"].upper < -0.5


def test_with_aged_radars_scatter_has_better_weights_than_propagation(results: dict[str, Comparison]) -> None:
    excess = results["aged"].excess
    assert excess["consistent"].upper < -0.4
    assert excess["printed"].upper < -0.2


def test_a_missing_elevation_misleads_plot_covariances_most(results: dict[str, Comparison]) -> None:
    excess = results["no elevation"].excess
    assert excess["covariance"].lower > 1.0
    assert abs(excess["consistent"].value) < 0.1


def test_intervals_hold_what_another_thousand_runs_give(results: dict[str, Comparison]) -> None:
    """At 1 - 1e-6 both ways: the root mean square errors of other runs lie within twice the half width."""
    again = compare(runs=RUNS, seed=1, confidence=1 - 1e-6)
    for name, estimate in compare(runs=RUNS, confidence=1 - 1e-6).rmse.items():
        other = again.rmse[name]
        assert estimate.lower < other.upper
        assert other.lower < estimate.upper
        assert estimate.lower < results["calibrated"].rmse[name].value < estimate.upper


def test_the_same_seed_gives_the_same_numbers() -> None:
    assert compare(runs=20) == compare(runs=20)


def test_weights_from_any_source_are_equal_for_equal_radars_seen_alike() -> None:
    radar = CALIBRATED[0]
    plots = [straight_flight.plots_of(radar, 5, 1) for _ in range(3)]
    for weigh in straight_flight._SOURCES.values():
        assert weigh([radar] * 3, plots) == pytest.approx(1 / 3)


RADAR = CALIBRATED[0].radar
REFUSED: dict[str, tuple[Callable[[], object], str]] = {
    "one run": (lambda: compare(runs=1), "runs must be at least 2"),
    "no radar": (lambda: compare((), runs=2), "stations must be one or more"),
    "two plots": (lambda: compare([Station(replace(RADAR, period=300.0))], runs=2), "periods up to 200 s"),
    "certainty": (lambda: compare(runs=2, confidence=1.0), "confidence must be between"),
    "another sensor": (
        lambda: Station(Radar("polar", 5.0, {"range_std": 1.0, "azimuth_std": 0.1})),
        "must be spherical",
    ),
    "misses": (lambda: Station(replace(RADAR, detection_probability=0.9)), "miss nothing"),
    "azimuth from x": (lambda: Station(replace(RADAR, azimuth_from="x")), "azimuth from y"),
    "no errors": (lambda: Station(replace(RADAR, noise={**RADAR.noise, "range_std": 0.0})), "positive deviations"),
    "no age": (lambda: Station(RADAR, ageing=0.0), "ageing must be"),
}


@pytest.mark.parametrize("case", REFUSED)
def test_what_cannot_be_compared_is_refused_by_name(case: str) -> None:
    call, words = REFUSED[case]
    with pytest.raises(ValueError, match=words):
        call()


@pytest.mark.parametrize("correlation", [-1.0, -0.3, 0.0, 0.6, 1.0])
def test_deviations_age_and_a_correlation_does_not(correlation: float) -> None:
    station = Station(replace(RADAR, noise={**RADAR.noise, "correlation": correlation}), ageing=3.0)
    older = station.as_it_is()
    np.testing.assert_allclose(older.noise_covariance(), 9.0 * station.radar.noise_covariance(), rtol=1e-14)
    assert older.noise["correlation"] == correlation


@pytest.mark.parametrize(
    ("call", "name"),
    [
        (lambda word: Station(RADAR, ageing=word), "ageing"),
        (lambda word: compare(runs=2, confidence=word), "confidence"),
    ],
)
@pytest.mark.parametrize("word", ["3", None, True, [2.0]])
def test_what_is_no_number_is_refused_by_name(call: Any, name: str, word: Any) -> None:
    with pytest.raises(TypeError, match=f"{name} must be a real number"):
        call(word)


def test_one_radar_of_three_plots_has_all_the_weight_whatever_the_source() -> None:
    found = compare([Station(replace(RADAR, period=200.0))], runs=2)
    sources = [float(found.rmse[source].value) for source in straight_flight._SOURCES]
    assert sources == pytest.approx([sources[0]] * len(sources))
