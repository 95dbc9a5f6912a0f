"""Simulated targets and radars: motions against differences, plots against what they were asked to be."""

from collections.abc import Mapping
from typing import Any

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

import radartrack as rt
from radartrack import simulate
from radartrack._conversion.sensors import SENSORS
from radartrack.simulate import Accelerated, Radar, Straight, Target, Turning
from radartrack.testing import strategies
from tests.examples import share

TARGETS: list[Target] = [
    Straight((40e3, -20e3), (-150.0, 90.0)),
    Accelerated((40e3, -20e3, 3e3), (-150.0, 90.0, 5.0), (3.0, -2.0, 0.5)),
    Turning((40e3, -20e3, 3e3), (-150.0, 90.0, 5.0), 0.03),
    Turning((40e3, -20e3), (-150.0, 90.0), -0.03),
]
NOISE: dict[str, dict[str, float]] = {
    "polar": {"range_std": 50.0, "azimuth_std": 0.02, "correlation": -0.6},
    "spherical": {"range_std": 50.0, "azimuth_std": 0.02, "elevation_std": 0.01, "correlation": 0.7},
    "spherical_doppler": {"range_std": 50.0, "azimuth_std": 0.02, "elevation_std": 0.01, "range_rate_std": 3.0}
    | {"correlation": 0.9},
    "polar_doppler": {"range_std": 50.0, "azimuth_std": 0.02, "range_rate_std": 3.0, "correlation": 0.9},
    "ruv": {"range_std": 50.0, "u_std": 0.02, "v_std": 0.01, "correlation": 0.5},
}
TRIALS = 4000


@pytest.mark.parametrize("target", TARGETS)
def test_velocity_is_the_derivative_of_position(target: Target) -> None:
    t, step = np.array([0.0, 7.0, 130.0]), 1e-3
    difference = (target.states(t + step)[:, :3] - target.states(t - step)[:, :3]) / (2 * step)
    assert target.states(t)[:, 3:] == pytest.approx(difference, abs=1e-5)


@given(rate=st.floats(-0.2, 0.2), elapsed=st.floats(0, 500))
def test_a_turn_keeps_speed_and_radius_and_turns_counter_clockwise_by_its_rate(rate: float, elapsed: float) -> None:
    start, end = Turning((40e3, -20e3), (-150.0, 90.0), rate).states([0.0, elapsed])
    speed = np.hypot(-150.0, 90.0)
    assert np.hypot(end[3], end[4]) == pytest.approx(speed)
    assert complex(*end[3:5]) == pytest.approx(complex(-150.0, 90.0) * np.exp(1j * rate * elapsed), abs=1e-9 * speed)
    chord = speed * elapsed * abs(np.sinc(rate * elapsed / (2 * np.pi)))
    assert np.hypot(*(end - start)[:2]) == pytest.approx(chord, abs=1e-6)


def test_acceleration_is_constant_and_a_missing_height_is_zero() -> None:
    states = Accelerated((1.0, 2.0), (3.0, 4.0), (0.5, -0.25)).states([0.0, 2.0, 4.0])
    assert states == pytest.approx(np.array([[1, 2, 0, 3, 4, 0], [8, 9.5, 0, 4, 3.5, 0], [17, 16, 0, 5, 3, 0]]))


@pytest.mark.parametrize("sensor", list(NOISE))
def test_without_noise_the_conversion_leads_back_to_the_target(sensor: Any) -> None:
    noise = dict.fromkeys(NOISE[sensor], 0.0)
    site = (3e3, -5e3, 40.0)
    target = Accelerated((20e3, 10e3, 30e3 if sensor == "ruv" else 3e3), (150.0, 90.0, 5.0), (1.0, 2.0, 0.0))
    seen = simulate.plots(target, Radar(sensor, 5.0, noise, site), scans=6)
    converted = getattr(rt.convert, sensor)(**seen.measured, **noise, method="linear")
    axes = 2 if sensor.startswith("polar") else 3
    assert converted.mean[0, :, :axes] + site[:axes] == pytest.approx(seen.states[:, :axes])


@pytest.mark.parametrize("sensor", SENSORS)
@pytest.mark.parametrize("motion", strategies.MOTIONS)
@given(data=st.data())
@share(0.2)
def test_what_a_radar_would_measure_without_errors_leads_back_to_the_target(
    motion: Any, sensor: Any, data: st.DataObject
) -> None:
    """Of targets in any motion and on any side, behind the radar and above it too."""
    _, radar, seen = data.draw(strategies.tracks(motion, sensor))
    measured = {name: values[np.newaxis] for name, values in seen.truth.items()}
    assume(within_reach(seen, radar.known))
    noise = dict.fromkeys(radar.noise, 0.0)
    mean = getattr(rt.convert, sensor)(**measured, **radar.known, **noise, method="linear").mean[0]
    axes = 2 if sensor in {"polar", "polar_doppler", "bistatic"} else 3
    size = np.linalg.norm(seen.states[:, :axes], axis=1, keepdims=True)
    scale = size + sum(radar.known.values())
    assert (np.abs(mean[:, :axes] - seen.states[:, :axes]) <= 1e-9 * scale + 1e-9).all()


def within_reach(seen: simulate.Plots, known: Mapping[str, float]) -> bool:
    """Whether directions are in front, off the edge of the unit circle, and paths longer than the baseline."""
    truth = seen.truth
    if "u" in truth:
        return bool((seen.states[:, 2] > 0).all() and (np.hypot(truth["u"], truth["v"]) < 0.99).all())
    return "path" not in truth or bool((truth["path"] > 1.01 * known["baseline"]).all())


def test_a_compass_counts_the_azimuth_from_the_y_axis() -> None:
    for azimuth_from, azimuth in (
        ("y", np.arctan2(3.0, 4.0)),
        ("x", np.arctan2(4.0, 3.0)),
        (None, np.arctan2(4.0, 3.0)),
    ):
        radar = Radar("polar", 1.0, NOISE["polar"], azimuth_from=azimuth_from)  # type: ignore[arg-type]
        assert simulate.plots(Straight((3.0, 4.0), (0.0, 0.0)), radar, scans=1).truth["azimuth"][0] == pytest.approx(
            azimuth
        )


@pytest.mark.parametrize("sensor", list(NOISE))
def test_errors_have_the_mean_deviations_and_correlation_asked_for(sensor: Any) -> None:
    """Six standard errors of 80 000 draws: a deviation that is wrong by 1.5 % is found, a correlation by 0.02."""
    model = SENSORS[sensor]
    names = list(model.coordinates)
    bias = {names[0]: 30.0, names[1]: -0.05}
    seen = simulate.plots(
        Straight((20e3, 10e3, 30e3), (50.0, 0.0)), Radar(sensor, 2.0, NOISE[sensor], bias=bias), scans=20, trials=TRIALS
    )
    errors = np.stack([(seen.measured[name] - seen.truth[name]).ravel() for name in names])
    deviations = np.array([NOISE[sensor][f"{name}_std" if name != "r" else "range_std"] for name in names])
    expected = np.eye(len(names))
    first, second = model.correlated
    expected[first, second] = expected[second, first] = NOISE[sensor]["correlation"]
    count = errors.shape[1]
    wanted = np.array([bias.get(name, 0.0) for name in names])
    assert (np.abs(errors.mean(axis=1) - wanted) < 6 * deviations / np.sqrt(count)).all()
    assert errors.std(axis=1) == pytest.approx(deviations, rel=6 / np.sqrt(2 * count))
    assert np.corrcoef(errors) == pytest.approx(expected, abs=6 / np.sqrt(count))


def test_errors_of_different_scans_and_trials_are_independent() -> None:
    seen = simulate.plots(TARGETS[0], Radar("polar", 2.0, NOISE["polar"]), scans=3, trials=40_000)
    errors = (seen.measured["r"] - seen.truth["r"]) / 50.0
    assert np.corrcoef(errors.T) == pytest.approx(np.eye(3), abs=6 / 200)
    assert abs((errors[1:] * errors[:-1]).mean()) < 6 / np.sqrt(errors.size)


def test_missing_detections_are_nan_in_every_quantity_and_as_frequent_as_asked_for() -> None:
    radar = Radar("polar_doppler", 2.0, NOISE["polar_doppler"], detection_probability=0.7)
    seen = simulate.plots(TARGETS[0], radar, scans=20, trials=TRIALS)
    missing = np.isnan(np.stack(list(seen.measured.values())))
    assert (missing == missing[0]).all()
    assert missing.mean() == pytest.approx(0.3, abs=6 * np.sqrt(0.21 / (20 * TRIALS)))
    whole = simulate.plots(TARGETS[0], Radar("polar_doppler", 2.0, NOISE["polar_doppler"]), scans=20, trials=TRIALS)
    assert not np.isnan(whole.measured["r"]).any()
    np.testing.assert_array_equal(np.where(missing[0], np.nan, whole.measured["r"]), seen.measured["r"])


def test_the_same_seed_gives_the_same_plots_whatever_the_number_of_trials() -> None:
    radar = Radar("polar", 2.0, NOISE["polar"], detection_probability=0.9)
    few, many, other = (
        simulate.plots(TARGETS[0], radar, scans=5, trials=trials, seed=seed).measured["azimuth"]
        for trials, seed in ((3, (7, 1)), (300, (7, 1)), (3, (7, 2)))
    )
    np.testing.assert_array_equal(few, many[:3])
    assert (few != other).all()


SEEDS: list[simulate.Seed] = [
    0,
    (0,),
    (0, 0),
    (0, 0, 0),
    5,
    (5,),
    (5, 0),
    (0, 5),
    2**32,
    (0, 1),
    (2**32,),
    (2**64 + 3, 1),
    (),
]


def test_every_seed_is_a_stream_of_its_own() -> None:
    """NumPy joins the numbers of a sequence and drops zeros at its end."""
    radar = Radar("polar", 2.0, NOISE["polar"])
    drawn = [simulate.plots(TARGETS[0], radar, scans=1, seed=seed).measured["r"].item() for seed in SEEDS]
    assert len(set(drawn)) == len(SEEDS)


def test_a_sequence_of_seeds_is_its_numbers_whatever_holds_them() -> None:
    radar = Radar("polar", 2.0, NOISE["polar"])
    holders: list[Any] = [(7, 1), [7, 1], np.array([7, 1]), (np.int8(7), np.uint64(1))]
    drawn = {simulate.plots(TARGETS[0], radar, scans=1, seed=seed).measured["r"].item() for seed in holders}
    assert len(drawn) == 1


@pytest.mark.parametrize("seed", [-1, (1, -1), np.int64(-3)])
def test_a_negative_seed_is_refused(seed: Any) -> None:
    with pytest.raises(ValueError, match="seed must be at least 0; got"):
        simulate.plots(TARGETS[0], Radar("polar", 2.0, NOISE["polar"]), scans=1, seed=seed)


@pytest.mark.parametrize("sensor", list(NOISE))
@pytest.mark.parametrize("bad", [np.nan, np.inf, -np.inf, 1e300, "0.1", True, None, [0.1, 0.2]])
def test_a_value_that_is_no_number_of_its_domain_makes_no_radar(sensor: Any, bad: Any) -> None:
    right: dict[str, Any] = {"sensor": sensor, "period": 1.0, "noise": NOISE[sensor]}
    for name in NOISE[sensor]:
        with pytest.raises((TypeError, ValueError), match=f"^{name} must be "):
            Radar(**(right | {"noise": NOISE[sensor] | {name: bad}}))
    for name in SENSORS[sensor].coordinates:
        with pytest.raises((TypeError, ValueError), match=f"^bias of {name} must be "):
            Radar(**right, bias={name: bad})
    with pytest.raises((TypeError, ValueError), match=r"^detection_probability must be "):
        Radar(**right, detection_probability=bad)
    if bad != 1e300:
        with pytest.raises((TypeError, ValueError), match=r"^period must be "):
            Radar(**(right | {"period": bad}))


@pytest.mark.parametrize("sensor", list(NOISE))
@pytest.mark.parametrize("word", ["z", "X", "", "north", 1, True])
def test_an_azimuth_from_that_the_sensor_does_not_have_makes_no_radar(sensor: Any, word: Any) -> None:
    with pytest.raises((TypeError, ValueError), match=r"^azimuth_from must be "):
        Radar(sensor, 1.0, NOISE[sensor], azimuth_from=word)


def test_direction_cosines_count_no_azimuth() -> None:
    for word in ("x", "y"):
        with pytest.raises(ValueError, match="azimuth_from must be None for sensor 'ruv'; got "):
            Radar("ruv", 1.0, NOISE["ruv"], azimuth_from=word)


def test_a_negative_bias_and_no_scans_are_natural() -> None:
    radar = Radar("polar", 2.0, NOISE["polar"], bias={"r": -30.0, "azimuth": np.float32(-0.5)})  # type: ignore[dict-item]
    assert radar.times(0).shape == (0,)
    for target in TARGETS:
        assert target.states([]).shape == (0, 6)
        assert radar.truth(target.states([]))["r"].shape == (0,)


@pytest.mark.parametrize("bad", [np.nan, np.inf])
@pytest.mark.parametrize("target", TARGETS)
def test_a_time_that_is_none_is_refused(target: Target, bad: float) -> None:
    with pytest.raises(ValueError, match="t must be finite"):
        target.states([0.0, bad])


def test_the_filters_take_plots_with_missing_detections() -> None:
    radar = Radar("polar_doppler", 10.0, NOISE["polar_doppler"], detection_probability=0.8)
    seen = simulate.plots(Accelerated((80e3, 0.0), (-200.0, 0.0), (2.0, 0.0)), radar, scans=12, trials=200)
    run = rt.FiniteSampleFilter(10.0, 50.0, 3.0).run(seen.measured["r"], seen.measured["range_rate"])
    error = run.state[:, -1, 0] - seen.truth["r"][-1]
    assert np.sqrt(np.mean(error**2)) < 60.0


@pytest.mark.parametrize(
    ("change", "error", "message"),
    [
        ({"sensor": "polr"}, ValueError, "sensor must be one of"),
        ({"period": 0.0}, ValueError, "period must be finite and more than 0"),
        ({"noise": {"range_std": 1.0}}, TypeError, "noise must have"),
        ({"noise": {"range_std": -1.0, "azimuth_std": 0.1}}, ValueError, "range_std must be"),
        ({"noise": {"range_std": 1.0, "azimuth_std": 0.1, "correlation": 2.0}}, ValueError, "correlation must be"),
        ({"bias": {"elevation": 0.1}}, TypeError, "bias must be of"),
        ({"site": (1.0,)}, ValueError, "site must be two or three"),
        ({"detection_probability": 1.1}, ValueError, "detection_probability must be from 0 to 1"),
    ],
)
def test_what_is_no_radar_is_refused(change: dict[str, Any], error: type[Exception], message: str) -> None:
    right: dict[str, Any] = {"sensor": "polar", "period": 1.0, "noise": NOISE["polar"]}
    with pytest.raises(error, match=message):
        Radar(**(right | change))


@pytest.mark.parametrize(
    ("build", "message"),
    [
        (lambda: Straight((1.0, np.nan), (0.0, 0.0)), "position must be two or three finite"),
        (lambda: Accelerated((1.0, 2.0), (0.0, 0.0), (1.0,)), "acceleration must be two or three"),
        (lambda: Turning((1.0, 2.0), (0.0, 0.0), np.inf), "turn_rate must be finite"),
        (lambda: simulate.plots(TARGETS[0], Radar("polar", 1.0, NOISE["polar"]), scans=0), "scans must be at least 1"),
    ],
)
def test_what_is_no_target_and_no_number_of_scans_is_refused(build: Any, message: str) -> None:
    with pytest.raises(ValueError, match=message):
        build()


class Told:
    """A target of one's own, with the states that it was made of, whatever the times."""

    def __init__(self, states: Any) -> None:
        self.told = states

    def states(self, _: Any) -> Any:
        return self.told


@pytest.mark.parametrize("shape", [(), (6,), (1, 6), (4, 6), (3, 4), (3, 7), (2, 3, 6)])
def test_a_target_of_ones_own_has_one_state_a_time(shape: tuple[int, ...]) -> None:
    radar = Radar("polar", 1.0, NOISE["polar"])
    with pytest.raises(ValueError, match=r"states of the target must have shape \(3, 6\); got"):
        simulate.plots(Told(np.ones(shape)), radar, scans=3)
    with pytest.raises(TypeError, match="states of the target must be real numbers"):
        simulate.plots(Told("x"), radar, scans=3)
    seen = simulate.plots(Told([[1000, 0, 0, 0, 0, 0]] * 3), radar, scans=3)
    assert seen.states.shape == (3, 6)
    assert seen.states.dtype == np.float64


@pytest.mark.parametrize("sensor", SENSORS)
def test_a_noise_without_a_correlation_has_none_and_one_with_other_names_is_refused(sensor: Any) -> None:
    noise = {name: 0.25 for name in SENSORS[sensor].noise if name != "correlation"}
    np.testing.assert_array_equal(simulate.noise_covariance(sensor, noise), 0.0625 * np.eye(len(noise)))
    for wrong in ({}, noise | {"std": 1.0}):
        with pytest.raises(TypeError, match=r"noise must have \["):
            simulate.noise_covariance(sensor, wrong)


def test_targets_and_radars_stay_as_they_are_whatever_becomes_of_what_made_them() -> None:
    place: Any = np.array([30e3, 40e3])
    noise, bias, known = (
        {"path_std": 5.0, "azimuth_std": 0.01},
        {"path": 3.0},
        {"baseline": 2e3},
    )
    targets = Straight(place, place), Accelerated(place, place, place), Turning(place, place, 0.1)
    radar = Radar("bistatic", 4.0, noise, place, bias, known=known)
    assert targets[0] == Straight([30e3, 40e3], (30e3, 40e3))
    before = repr((targets, radar))
    place[...] = np.nan
    for part in (noise, bias, known):
        part.update(dict.fromkeys(part, -1.0))
    assert repr((targets, radar)) == before
