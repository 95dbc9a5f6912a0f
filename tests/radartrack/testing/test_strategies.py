"""What is drawn lies in the physical domain, reaches its edges, and shrinks to plain numbers."""

import math
from collections.abc import Callable

import numpy as np
import pytest
from hypothesis import Phase, find, given, settings
from hypothesis import strategies as st

from radartrack import convert
from radartrack._conversion.sensors import SENSORS, SensorName
from radartrack.derive.catalogue import find as quantity_of
from radartrack.testing import strategies
from radartrack.verification.subject import generated

NAMES = ("polar.covariance.truth", "observe.spherical.jacobian", "finite_sample.degree1.range.range_weights")
FEW = settings(max_examples=300, database=None)


@pytest.mark.parametrize("name", NAMES)
def test_arguments_lie_in_the_domain_and_have_a_value(name: str) -> None:
    quantity = quantity_of(name)

    @settings(max_examples=25)
    @given(strategies.arguments(name))
    def check(point: dict[str, float]) -> None:
        assert list(point) == [symbol.name for symbol in quantity.symbols]
        for symbol in quantity.symbols:
            assert symbol.low <= point[symbol.name] <= symbol.high
            assert symbol.at_most is None or point[symbol.name] <= point[symbol.at_most.name]
            assert not symbol.whole or point[symbol.name].is_integer()
        assert np.isfinite(generated(quantity)(**point)).all()

    check()


@pytest.mark.parametrize("sensor", SENSORS)
def test_plots_are_what_conversions_take(sensor: SensorName) -> None:
    @settings(max_examples=25)
    @given(strategies.plots(sensor))
    def check(plot: dict[str, float]) -> None:
        converted = getattr(convert, sensor)(**plot)
        assert np.isfinite(converted.mean).all()
        deviations = np.sqrt(np.diagonal(converted.covariance))
        scales = np.where(deviations > 0, deviations, 1)
        assert np.linalg.eigvalsh(converted.covariance / np.outer(scales, scales)).min() > -1e-12

    check()


EDGES: dict[str, tuple[SensorName, Callable[[dict[str, float]], bool]]] = {
    "zero range": ("polar", lambda plot: plot["r"] == 0),
    "straight behind": ("polar", lambda plot: plot["azimuth"] == -math.pi),
    "full correlation": ("polar", lambda plot: plot["correlation"] == -1),
    "a tiny deviation": ("polar", lambda plot: plot["azimuth_std"] < 1e-7),
    "a large deviation": ("polar", lambda plot: plot["range_std"] > 5e3),
    "vertical": ("spherical", lambda plot: plot["elevation"] == math.pi / 2),
    "no baseline": ("bistatic", lambda plot: plot["baseline"] == 0),
    "the edge of the field of view": ("ruv", lambda plot: abs(plot["u"]) == 0.6),
}


@pytest.mark.parametrize("edge", EDGES)
def test_edges_are_reached(edge: str) -> None:
    sensor, is_there = EDGES[edge]
    assert is_there(find(strategies.plots(sensor), is_there, settings=settings(FEW, phases=[Phase.generate])))


def test_what_is_found_shrinks_to_plain_numbers() -> None:
    assert find(strategies.plots("polar"), lambda plot: plot["r"] > 0, settings=FEW) == {
        "r": 1.0, "azimuth": 0.0, "range_std": 1.0, "azimuth_std": 1.0, "correlation": 0.0,
    }  # fmt: skip


@settings(max_examples=60)
@given(st.integers(1, 5).flatmap(strategies.covariances))
def test_covariances_are_symmetric_and_semidefinite_on_any_scale(matrix: np.ndarray) -> None:
    deviations = np.sqrt(np.diagonal(matrix))
    assert (matrix == matrix.T).all()
    assert (deviations > 0).all()
    assert np.linalg.eigvalsh(matrix / np.outer(deviations, deviations)).min() > -1e-12


@pytest.mark.parametrize("sensor", SENSORS)
def test_noise_is_a_covariance_of_what_the_sensor_measures(sensor: SensorName) -> None:
    @settings(max_examples=20)
    @given(strategies.correlated_noise(sensor))
    def check(noise: np.ndarray) -> None:
        size = len(SENSORS[sensor].coordinates)
        deviations = np.sqrt(np.diagonal(noise))
        assert noise.shape == (size, size)
        assert np.linalg.eigvalsh(noise / np.outer(deviations, deviations)).min() > -1e-12

    check()


@pytest.mark.parametrize("sensor", SENSORS)
@pytest.mark.parametrize("motion", strategies.MOTIONS)
def test_tracks_are_seen_as_their_targets_move(motion: strategies.Motion, sensor: SensorName) -> None:
    @settings(max_examples=15)
    @given(strategies.tracks(motion, sensor))
    def check(track: strategies.Track) -> None:
        assert np.allclose(track.plots.states, track.target.states(track.plots.t), rtol=0, atol=0)
        assert all(np.isfinite(values).all() for values in track.plots.measured.values())

    check()


def test_unknown_sensors_and_motions_are_refused() -> None:
    with pytest.raises(ValueError, match="sensor"):
        strategies.plots("sonar")  # type: ignore[arg-type]
    with pytest.raises(ValueError, match="motion"):
        find(strategies.tracks("idle", "polar"), bool)  # type: ignore[arg-type]
