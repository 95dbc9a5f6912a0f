"""Functions of tracks refuse what is no number, not finite, or of another shape, and name the argument."""

from collections.abc import Callable, Iterator
from functools import partial
from itertools import permutations
from typing import Any

import numpy as np
import pytest

from radartrack import VarianceTable, consistency, frames, fusion, initiate, kalman, observe, simulate
from radartrack._conversion.sensors import SENSORS
from radartrack._observation.sights import SIGHTS
from tests.radartrack.plots import Floats

SITES = {"baseline": np.float64(500.0), "receiver": np.array([100.0, 200.0, 30.0])}
SYNONYMS = {"F": "transition", "Q": "process_noise"}
SAME = np.stack([100.0 * np.eye(2)] * 2)
STRAIGHT = kalman.motion("constant_velocity", 1.0, std=1.0)
PLOT = {"r": 5e3, "azimuth": 0.7, "range_std": 30.0, "azimuth_std": 0.05}
MEANS_MISSING = {"measured"}  # where NaN stands for

Arguments = dict[str, Any]
Function = Callable[..., Any]


def believing(function: Function) -> Function:
    return lambda mean, covariance, **others: function(kalman.Belief(mean, covariance), **others)


def run_with(sensor: Any, motion: kalman.Motion, start: kalman.Belief, **others: Any) -> kalman.Belief:
    return kalman.run_with(sensor, start, motion, **others)


def of_sensors() -> Iterator[tuple[str, Function, Arguments]]:
    for name, sight in SIGHTS.items():
        mean, errors = np.full(len(sight.state), 1e3), 100.0 * np.eye(len(sight.state))
        site = {key: SITES[key] for key in sight.site}
        see: Function = getattr(observe, name)
        yield f"observe.{name}", see, {"state": mean, **site}
        yield f"project {name}", partial(observe.project, name), {"mean": mean, "covariance": errors, **site}
        plot = {"measured": see(mean, **site).measurement, "noise": np.eye(len(sight.outputs))}
        update = believing(lambda belief, name=name, **others: kalman.update_with(name, belief, **others))
        yield f"update_with {name}", update, {"mean": mean, "covariance": errors, **plot, **site}
        still = kalman.Motion(np.eye(len(mean)), errors)
        scans = believing(partial(run_with, name, still))
        believed = {"mean": mean, "covariance": errors, "noise": plot["noise"], **site}
        yield f"run_with {name}", scans, {**believed, "measured": np.stack([plot["measured"]] * 2)}
        none = np.empty((0, len(sight.outputs)))
        yield f"run_with {name} no scans", partial(scans, measured=none), believed


def of_filters() -> Iterator[tuple[str, Function, Arguments]]:
    start = {"mean": np.zeros(2), "covariance": np.eye(2)}
    seen = {"measured": np.ones((3, 1)), "matrix": np.eye(1, 2), "noise": np.eye(1)}
    moves = {"F": STRAIGHT.transition, "Q": STRAIGHT.process_noise}
    yield "predict", believing(lambda belief, F, Q: kalman.predict(belief, kalman.Motion(F, Q))), start | moves
    yield "update", believing(kalman.update), start | seen | {"measured": np.ones(1)}
    yield "run", believing(partial(kalman.run, motion=STRAIGHT)), start | seen
    yield (
        "one_plot",
        lambda velocity_std, **plot: initiate.one_plot("polar", plot, velocity_std),
        PLOT | {"velocity_std": 9.0},
    )
    yield "two_plots", lambda period, **plot: initiate.two_plots("polar", plot, PLOT, period), PLOT | {"period": 9.0}


def of_simulation() -> Iterator[tuple[str, Function, Arguments]]:
    for name, sensor in SENSORS.items():
        noise = {argument: 0.0 if argument == "correlation" else 0.1 for argument in sensor.noise}
        yield f"noise of {name}", lambda name=name, **noise: simulate.noise_covariance(name, noise), noise
        radar = simulate.Radar(name, 1.0, noise, known=dict.fromkeys(sensor.parameters, 500.0))
        yield f"truth of {name}", radar.truth, {"states": np.full((2, 6), 1e3)}


def of_fusion() -> Iterator[tuple[str, Function, Arguments]]:
    pair = {"mean": np.zeros((2, 2)), "covariance": SAME}
    yield "fuse", fusion.fuse, pair
    yield "fuse_correlated", fusion.fuse_correlated, pair | {"cross_covariance": np.eye(2)}
    yield "covariance_intersection", fusion.covariance_intersection, pair
    filtered = fusion.Filtered(np.stack([np.eye(2)] * 3), np.eye(1, 2), np.eye(1))
    yield "cross_covariances", partial(fusion.cross_covariances, STRAIGHT, filtered, filtered), {"start": np.eye(2)}
    yield "nees", consistency.nees, {"mean": np.zeros(2), "covariance": np.eye(2), "truth": np.ones(2)}
    yield "gate", consistency.gate, {"components": 2.0, "probability": 0.9, "runs": 3.0}
    yield "band", consistency.band, {"components": 2.0, "probability": 0.9, "runs": 3.0}
    place = {"latitude": 0.1, "longitude": 0.2, "height": 10.0}
    yield "ecef", frames.ecef_from_geodetic, place | {"covariance": 1e-6 * np.eye(3)}
    yield "geodetic", frames.geodetic_from_ecef, {"position": np.array([6.4e6, 1e5, 1e5]), "covariance": np.eye(3)}
    yield "antenna", frames.antenna, place | {"azimuth": 0.1, "tilt": 0.1, "roll": 0.1, "velocity": np.zeros(3)}
    yield "Frame.to", partial(frames.enu(0.1, 0.2).to, frames.ECEF), {"mean": np.zeros(6), "covariance": np.eye(6)}


def calls() -> Iterator[tuple[str, Function, Arguments]]:
    yield from (*of_sensors(), *of_filters(), *of_simulation(), *of_fusion())


CALLS = {name: (function, arguments) for name, function, arguments in calls()}


def spoilt(name: str, value: Any) -> Iterator[Any]:
    yield from ("text", object(), [[1.0, 2.0], [3.0]], np.asarray(value) + 1j, np.asarray(value) > 0)
    first = np.zeros(np.shape(value))
    first.flat[0] = 1
    yield np.where(first, np.inf, value)
    if name not in MEANS_MISSING:
        yield np.where(first, np.nan, value)
    if np.ndim(value):
        yield from (1.0, np.asarray(value)[..., :-1], np.concatenate([value, value], axis=-1))


@pytest.mark.parametrize("name", CALLS)
def test_each_argument_is_checked_and_named(name: str) -> None:
    function, arguments = CALLS[name]
    function(**arguments)
    for argument, value in arguments.items():
        for bad in spoilt(argument, value):
            with pytest.raises((TypeError, ValueError)) as caught:
                function(**arguments | {argument: bad})
            words = {
                argument,
                SYNONYMS.get(argument, argument),
                "covariance",
                "matrix",
            }  # whose shapes follow from the mean
            assert any(word in str(caught.value) for word in words), (argument, bad, str(caught.value))


OF_SCANS = "noise"  # whose first axis, in a run, is one of scans


@pytest.mark.parametrize("name", CALLS)
def test_two_arguments_that_do_not_broadcast_are_refused_by_name(name: str) -> None:
    """Two of the one and three of the other."""
    function, arguments = CALLS[name]
    those = [argument for argument in arguments if not (name.startswith("run") and argument == OF_SCANS)]
    for first, second in permutations(those, 2):
        many = {first: np.stack([arguments[first]] * 2), second: np.stack([arguments[second]] * 3)}
        with pytest.raises((TypeError, ValueError)) as caught:
            function(**arguments | many)
        words = {word for argument in (first, second) for word in (argument, SYNONYMS.get(argument, argument))}
        assert any(word in str(caught.value) for word in words), (first, second, str(caught.value))
        assert "could not be broadcast" not in str(caught.value)


@pytest.mark.parametrize("name", [name for name in CALLS if name.startswith("project bistatic")])
def test_many_baselines_are_projected_each_as_alone(name: str) -> None:
    function, arguments = CALLS[name]
    baselines: Floats = np.array([[300.0, 500.0], [700.0, 900.0]])
    found = function(**arguments | {"baseline": baselines})
    alone = function(**arguments | {"baseline": baselines[1, 0]})
    np.testing.assert_array_equal(found.mean[1, 0], alone.mean)
    np.testing.assert_array_equal(found.covariance[1, 0], alone.covariance)


@pytest.mark.parametrize("bad", ["x", None, True, [], 1.0, np.zeros(2), object()])
@pytest.mark.parametrize(
    ("name", "call"),
    [
        ("a plot", lambda bad: initiate.one_plot("polar", bad, 10.0)),
        ("a plot", lambda bad: initiate.two_plots("polar", PLOT, bad, 1.0)),
        ("plot", lambda bad: consistency.experiment("polar", bad)),
        ("noise", lambda bad: simulate.Radar("polar", 1.0, bad)),
        ("noise", lambda bad: simulate.noise_covariance("polar", bad)),
        ("bias", lambda bad: simulate.Radar("polar", 1.0, {"range_std": 1.0, "azimuth_std": 0.1}, bias=bad)),
        ("known", lambda bad: simulate.Radar("polar", 1.0, {"range_std": 1.0, "azimuth_std": 0.1}, known=bad)),
    ],
    ids=["one plot", "two plots", "experiment", "radar", "noise", "bias", "known"],
)
def test_what_has_no_names_is_refused_by_its_own(name: str, call: Function, bad: Any) -> None:
    with pytest.raises(TypeError, match=f"^{name} must be arguments by name, such as a dict; got "):
        call(bad)


BELIEF = kalman.Belief(np.full(2, 1e3), np.eye(2))
RADAR = simulate.Radar("polar", 1.0, {"range_std": 1.0, "azimuth_std": 0.1})
TABLE = VarianceTable.empty([0.0, 5e4], 3)
SEEN = np.ones((3, 2))


WANTED: dict[str, tuple[Function, str]] = {
    "predict": (lambda other: kalman.predict(other, STRAIGHT), "belief must be a Belief"),
    "update": (lambda other: kalman.update(other, [1.0], np.eye(1, 2), np.eye(1)), "belief must be a Belief"),
    "update_with": (lambda other: kalman.update_with("polar", other, [1.0, 0.0], np.eye(2)), "belief must be a Belief"),
    "run": (lambda other: kalman.run(other, STRAIGHT, SEEN, np.eye(2), np.eye(2)), "start must be a Belief"),
    "run_with": (lambda other: kalman.run_with("polar", other, STRAIGHT, SEEN, np.eye(2)), "start must be a Belief"),
    "predicted by": (lambda other: kalman.predict(BELIEF, other), "motion must be a Motion"),
    "run by": (lambda other: kalman.run(BELIEF, other, SEEN, np.eye(2), np.eye(2)), "motion must be a Motion"),
    "run_with by": (lambda other: kalman.run_with("polar", BELIEF, other, SEEN, np.eye(2)), "motion must be a Motion"),
    "cross": (lambda other: fusion.cross_covariances(STRAIGHT, other, other), "first must be a Filtered"),
    "steady": (lambda other: fusion.steady_cross_covariance(STRAIGHT, other, other), "first must be a Filtered"),
    "to": (lambda other: frames.ECEF.to(other, np.ones(3)), "other must be a Frame"),
    "jacobian": (frames.ECEF.jacobian, "other must be a Frame"),
    "enu": (lambda other: frames.enu(0.1, 0.2, ellipsoid=other), "ellipsoid must be an Ellipsoid"),
    "place": (lambda other: frames.geodetic_from_ecef([7e6, 0, 0], ellipsoid=other), "ellipsoid must be an Ellipsoid"),
    "ecef_jacobian": (lambda other: frames.ecef_jacobian(0.1, 0.2, ellipsoid=other), "ellipsoid must be an Ellipsoid"),
    "target": (lambda other: simulate.plots(other, RADAR, scans=3), "target must be a target"),
    "radar": (lambda other: simulate.plots(simulate.Straight((1, 2), (1, 2)), other, scans=3), "radar must be a Radar"),
    "merged": (lambda other: TABLE.merged(TABLE, other), "others must be each a VarianceTable"),
}


@pytest.mark.parametrize("name", WANTED)
@pytest.mark.parametrize("other", [None, "WGS84", (np.full(2, 1e3), np.eye(2))], ids=["none", "text", "tuple"])
def test_what_is_something_else_is_told_with_what_it_should_be(name: str, other: object) -> None:
    call, told = WANTED[name]
    with pytest.raises(TypeError, match=f"^{told}.*; got .*(NoneType|str|tuple)"):
        call(other)
