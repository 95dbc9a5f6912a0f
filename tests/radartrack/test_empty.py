"""No plots, no tracks, no scans, and as few as there may be: the natural result, of its shape, everywhere."""

from typing import Any

import numpy as np
import pytest

from radartrack import FiniteSampleFilter, convert, kalman, observe, validity
from radartrack._arrays.patterns import distinct
from tests.radartrack.plots import COORDINATES, METHODS, PLOTS, PREDICTED_DEVIATIONS, SENSORS

SHAPES = [(0,), (0, 3), (3, 0), (1,), ()]
STATES = {"polar": 2, "spherical": 3, "polar_doppler": 4, "spherical_doppler": 6, "ruv": 3}
FILTERS = [FiniteSampleFilter(10.0, 250.0, rate_std, degree) for rate_std in (None, 15.0) for degree in (0, 2)]


def plots(sensor: str, shape: tuple[int, ...]) -> dict[str, Any]:
    return {name: np.full(shape, value) for name, value in PLOTS[sensor].items()}


@pytest.mark.parametrize("shape", SHAPES)
@pytest.mark.parametrize("dtype", [np.float32, np.float64])
@pytest.mark.parametrize("sensor", SENSORS)
def test_conversions_and_validity_of_any_shape_of_plots(sensor: str, shape: tuple[int, ...], dtype: Any) -> None:
    given = {name: values.astype(dtype) for name, values in plots(sensor, shape).items()}
    size = len(COORDINATES[sensor])
    predicted = np.zeros((*shape, size), dtype), np.diag(np.square(PREDICTED_DEVIATIONS[sensor])).astype(dtype)
    predicted[0][...] = [PLOTS[sensor][name] for name in COORDINATES[sensor]]
    for method in METHODS:
        with_prediction = {"predicted": predicted} if method == "decorrelated" else {}
        found = getattr(convert, sensor)(**given, method=method, **with_prediction)
        assert (found.mean.shape, found.covariance.shape) == ((*shape, size), (*shape, size, size))
        assert found.mean.dtype == dtype
    assert getattr(validity, sensor)(**given).shape == (*shape, size)


@pytest.mark.parametrize("shape", SHAPES)
@pytest.mark.parametrize("sensor", SENSORS)
def test_observations_and_projections_of_any_shape_of_states(sensor: Any, shape: tuple[int, ...]) -> None:
    axes, size = STATES[sensor], len(COORDINATES[sensor])
    states = np.full((*shape, axes), 3e3)
    found = getattr(observe, sensor)(states)
    assert [part.shape for part in found] == [(*shape, size), (*shape, size, axes), (*shape, size, axes, axes)]
    for covariance in (np.eye(axes), np.broadcast_to(np.eye(axes), (*shape, axes, axes))):
        for order in ("linear", "second_order"):
            projected = observe.project(sensor, states, covariance, order)
            assert [part.shape for part in projected] == [(*shape, size), (*shape, size, size)]


TRACKS = [(), (0,), (0, 3), (3, 0), (2,)]


@pytest.mark.parametrize("f", FILTERS)
@pytest.mark.parametrize("tracks", TRACKS)
@pytest.mark.parametrize("kind", ["full", "missing", "times", "own times"])
def test_runs_of_any_number_of_tracks_and_scans(f: FiniteSampleFilter, tracks: tuple[int, ...], kind: str) -> None:
    size = f.degree + 1
    for scans in (0, 1, 4):
        ranges = np.full((*tracks, scans), np.nan if kind == "missing" else 1e4)
        times = {"times": np.arange(scans) * 3.0, "own times": np.broadcast_to(np.arange(scans) * 3.0, ranges.shape)}
        arguments = (ranges,) if f.rate_std is None else (ranges, ranges / 100)
        for window in (None, 2):
            run = f.run(*arguments, times=times.get(kind), window=window)
            assert run.state.shape == (*tracks, scans, size)
            assert run.covariance.shape == (*tracks, scans, size, size)
            assert (run.degree.shape, run.degree.dtype.kind) == ((*tracks, scans), "i")
        if scans == 4 and (kind != "missing" or not ranges.size):
            assert f.estimate(*arguments, times=times.get(kind)).state.shape == (*tracks, size)


@pytest.mark.parametrize("f", FILTERS)
def test_no_scans_determine_nothing(f: FiniteSampleFilter) -> None:
    arguments: tuple[list[float], ...] = ([],) if f.rate_std is None else ([], [])
    nothing: list[float] = []
    for times in (None, nothing):
        with pytest.raises(ValueError, match="k must be from 1 to 1000000; got 0"):
            f.estimate(*arguments, times=times)


@pytest.mark.parametrize("f", FILTERS)
@pytest.mark.parametrize("tracks", TRACKS)
@pytest.mark.parametrize("later", [0, 1])
def test_a_kalman_filter_that_starts_at_the_last_scan_or_before_it(
    f: FiniteSampleFilter, tracks: tuple[int, ...], later: int
) -> None:
    ranges = np.broadcast_to([1e4, 1.1e4, 1.2e4, 1.4e4, 1.3e4][: 4 + later], (*tracks, 4 + later))
    arguments = (ranges,) if f.rate_std is None else (ranges, ranges / 100)
    found, first = f.kalman(4).run(*arguments), f.estimate(*(part[..., :4] for part in arguments))
    assert found.state.shape == (*tracks, 1 + later, f.degree + 1)
    assert found.covariance.shape == (*tracks, 1 + later, f.degree + 1, f.degree + 1)
    assert np.array_equal(found.state[..., 0, :], first.state)
    assert np.array_equal(found.covariance[..., 0, :, :], first.covariance)


@pytest.mark.parametrize(("rows", "flags"), [(0, 0), (0, 3), (3, 0), (1, 1)])
def test_patterns_of_no_rows_or_flags(rows: int, flags: int) -> None:
    first, which = distinct(np.zeros((rows, flags), dtype=bool))
    assert (len(first), which.tolist()) == (min(rows, 1), [0] * rows)


@pytest.mark.parametrize("order", [1, 2])
@pytest.mark.parametrize("tracks", [(0,), (3, 0)])
def test_no_track_is_updated_and_run_with_any_sensor(tracks: tuple[int, ...], order: Any) -> None:
    belief = kalman.Belief(np.zeros((*tracks, 5)), np.eye(5))
    motion = kalman.nonlinear_motion("turn.unknown_rate", 1.0, std=1.0, turn_std=0.1, grouped="derivative")
    noise = np.eye(2)
    found = kalman.update_with("polar", belief, np.zeros((*tracks, 2)), noise, order)
    ran = kalman.run_with("polar", belief, motion, np.zeros((*tracks, 4, 2)), noise, order)
    assert [part.shape for part in (*found, *ran)] == [
        (*tracks, 5), (*tracks, 5, 5), (*tracks, 4, 5), (*tracks, 4, 5, 5)
    ]  # fmt: skip


def test_no_scan_of_a_sensor_leaves_no_belief() -> None:
    motion = kalman.motion("constant_velocity", 1.0, axes=2, std=1.0, grouped="derivative")
    start = kalman.Belief(np.full((3, 4), 1e3), np.eye(4))
    ran = kalman.run_with("polar", start, motion, np.zeros((3, 0, 2)), np.eye(2))
    assert [part.shape for part in ran] == [(3, 0, 4), (3, 0, 4, 4)]
