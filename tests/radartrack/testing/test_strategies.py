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
FEW = settings(max_examples=1000, database=None)


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


STATES: dict[str, tuple[str, Callable[[dict[str, float]], bool]]] = {
    "close to the vertical": ("observe.spherical.map", lambda s: math.hypot(s["x"], s["y"]) < 1e-3 * s["z"]),
    "in the plane of an axis": ("observe.spherical.map", lambda state: state["x"] == 0),
    "hardly a turn": ("motion.turn.known_rate.transition", lambda point: 0 < abs(point["omega"]) < 1e-9),
    "a turn the other way": ("motion.turn.known_rate.transition", lambda point: -1e-9 < point["omega"] < 0),
    "behind": ("motion.ctrv.map", lambda point: point["heading"] == -math.pi),
}


@pytest.mark.parametrize("edge", STATES)
def test_edges_of_states_and_rates_are_reached(edge: str) -> None:
    name, is_there = STATES[edge]
    assert is_there(find(strategies.arguments(name), is_there, settings=settings(FEW, phases=[Phase.generate])))


@settings(max_examples=60)
@given(st.data(), st.floats(0.5, 2), st.floats(1, 3))
def test_a_part_of_the_domain_is_drawn_with_its_own_edges(data: st.DataObject, low: float, factor: float) -> None:
    within = {"r": (low, low * factor), "azimuth": (0.0, 2 * math.pi), "correlation": (-0.9, 0.3)}
    plot = data.draw(strategies.plots("polar", within=within))
    assert all(least <= plot[name] <= largest for name, (least, largest) in within.items())
    name = "polar.covariance.linear"
    assert list(data.draw(strategies.arguments(name, within={"rho": (0, 0)}))) == [
        s.name for s in quantity_of(name).symbols
    ]
    noise = data.draw(strategies.correlated_noise("polar", within={"range_std": (low, low)}))
    assert noise[0, 0] == pytest.approx(low**2)
    track = data.draw(strategies.tracks("straight", "polar", within={"azimuth_std": (0.01, 0.02)}))
    assert 0.01 <= track.radar.noise["azimuth_std"] <= 0.02


@pytest.mark.parametrize("end", [1e4, 2e4])
def test_the_ends_of_a_part_are_reached(end: float) -> None:
    def is_there(plot: dict[str, float]) -> bool:
        return plot["r"] == end

    assert find(strategies.plots("polar", within={"r": (1e4, 2e4)}), is_there, settings=FEW)["r"] == end


@settings(max_examples=60)
@given(st.data(), st.lists(st.floats(1e-6, 1e6), min_size=1, max_size=4))
def test_covariances_of_given_deviations_have_these(data: st.DataObject, deviations: list[float]) -> None:
    matrix = data.draw(strategies.covariances(len(deviations), deviations=deviations))
    np.testing.assert_allclose(np.sqrt(np.diagonal(matrix)), deviations, rtol=1e-15)


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


@pytest.mark.parametrize("sensor", ["spherical", "spherical_doppler"])
def test_targets_pass_above_the_radar(sensor: SensorName) -> None:
    def is_above(track: strategies.Track) -> bool:
        x, y, z, *_ = track.plots.states[0]
        return x == y == 0 < z

    assert find(strategies.tracks("straight", sensor), is_above, settings=settings(FEW, phases=[Phase.generate]))


@pytest.mark.parametrize(
    ("within", "words"),
    [
        ({"rng": (1, 2)}, "within may name r, azimuth, range_std, azimuth_std, correlation; given rng"),
        ({"r": (2, 1)}, "within must give the least and the largest value of r; given \\(2, 1\\)"),
        ({"r": (1, math.inf)}, "within must give"),
        ({"r": (math.nan, 1)}, "within must give"),
    ],
)  # fmt: skip
def test_parts_that_are_none_are_refused(within: dict[str, tuple[float, float]], words: str) -> None:
    for strategy in (strategies.plots, strategies.correlated_noise):
        with pytest.raises(ValueError, match=words):
            strategy("polar", within=within)
    with pytest.raises(ValueError, match=r"deviations must be 2, one for each row; given 1"):
        find(strategies.covariances(2, deviations=[1.0]), bool)


def test_unknown_sensors_and_motions_are_refused() -> None:
    with pytest.raises(ValueError, match="sensor"):
        strategies.plots("sonar")  # type: ignore[arg-type]
    with pytest.raises(ValueError, match="motion"):
        find(strategies.tracks("idle", "polar"), bool)  # type: ignore[arg-type]
