"""The Kalman filter against the textbook recursion and against batch least squares, and one track like many."""

from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from radartrack import kalman
from radartrack.kalman import Belief, Motion

GENERATOR = np.random.default_rng(8)
NOISE = np.array([[9.0, 2.0, 0.5], [2.0, 4.0, -0.3], [0.5, -0.3, 1.0]])
MATRIX = GENERATOR.normal(size=(3, 3))


def measurements(shape: tuple[int, ...], missing: float, seed: int = 1) -> Any:
    generator = np.random.default_rng(seed)
    values = 30 * generator.normal(size=shape)
    return np.where(generator.random(shape) < missing, np.nan, values)


def textbook(start: Belief, motion: Motion, measured: Any, matrix: Any, noise: Any) -> tuple[Any, Any]:
    """Predict and update one track, with the rows that are seen."""
    mean, covariance = start
    F, Q = motion
    for z in measured:
        mean, covariance = F @ mean, F @ covariance @ F.T + Q
        seen = ~np.isnan(z)
        H, R = matrix[seen], noise[np.ix_(seen, seen)]
        gain = covariance @ H.T @ np.linalg.inv(H @ covariance @ H.T + R)
        mean = mean + gain @ (z[seen] - H @ mean)
        covariance = covariance - gain @ H @ covariance
    return mean, covariance


@pytest.mark.parametrize("missing", [0.0, 0.3])
@given(seed=st.integers(0, 1000), intensity=st.sampled_from([0.0, 0.1, 10.0]))
def test_a_run_is_the_textbook_recursion(missing: float, seed: int, intensity: float) -> None:
    motion = kalman.constant_acceleration(2.0, intensity)
    measured = measurements((3, 12, 3), missing, seed)
    start = Belief(np.zeros(3), np.diag([400.0, 100.0, 25.0]))
    found = kalman.run(start, motion, measured, MATRIX, NOISE)
    for track in range(3):
        mean, covariance = textbook(start, motion, measured[track], MATRIX, NOISE)
        deviations = np.sqrt(np.diagonal(covariance))
        assert np.all(np.abs(found.mean[track, -1] - mean) <= 1e-7 * deviations)
        assert np.all(np.abs(found.covariance[track, -1] - covariance) <= 1e-7 * np.outer(deviations, deviations))


def test_predict_and_update_are_a_step_of_a_run() -> None:
    motion = kalman.constant_velocity(3.0, 0.5)
    measured = measurements((4, 1, 2), 0.0)
    start = Belief(measurements((4, 2), 0.0, 3), np.diag([400.0, 100.0]))
    matrix, noise = MATRIX[:2, :2], NOISE[:2, :2]
    step = kalman.update(kalman.predict(start, motion), measured[:, 0], matrix, noise)
    run = kalman.run(start, motion, measured, matrix, noise)
    assert np.array_equal(step.mean, run.mean[:, 0])
    assert np.array_equal(step.covariance, run.covariance[:, 0])


@pytest.mark.parametrize("missing", [0.0, 0.01])
def test_one_track_and_ten_thousand_give_the_same_bits(missing: float) -> None:
    motion = kalman.constant_acceleration(2.0, 0.1)
    measured = measurements((10_000, 8, 3), missing)
    start = Belief(np.zeros(3), np.diag([400.0, 100.0, 25.0]))
    many = kalman.run(start, motion, measured, MATRIX, NOISE)
    for track in (0, 1, 4_999, 9_999):
        one = kalman.run(start, motion, measured[track], MATRIX, NOISE)
        assert one.mean.tobytes() == many.mean[track].tobytes()
        assert np.array_equal(one.covariance, many.covariance[track])


def test_covariances_stay_symmetric_and_positive_where_measurements_are_almost_perfect() -> None:
    motion = kalman.constant_acceleration(1.0, 1e-9)
    start = Belief(np.zeros(3), np.eye(3) * 1e10)
    found = kalman.run(start, motion, np.zeros((200, 1)), np.array([[1.0, 0.0, 0.0]]), np.array([[1e-8]]))
    assert np.array_equal(found.covariance, np.swapaxes(found.covariance, -1, -2))
    assert np.all(np.linalg.eigvalsh(found.covariance[5:]) > 0)


def test_normalised_errors_of_a_simulated_motion_are_chi_square() -> None:
    """NEES of 20 000 tracks: its mean is off by more than 6 deviations once in 5e8; a 1 % error of Q or R shows."""
    tracks, scans = 20_000, 10
    generator = np.random.default_rng(4)
    motion = kalman.constant_velocity(5.0, 2.0)
    noise = np.diag([30.0**2, 4.0**2])
    start = np.diag([100.0**2, 20.0**2])
    truth = generator.multivariate_normal(np.zeros(2), start, tracks)
    measured = np.empty((tracks, scans, 2))
    for scan in range(scans):
        truth = truth @ motion.transition.T + generator.multivariate_normal(np.zeros(2), motion.process_noise, tracks)
        measured[:, scan] = truth + generator.multivariate_normal(np.zeros(2), noise, tracks)
    found = kalman.run(Belief(np.zeros((tracks, 2)), start), motion, measured, np.eye(2), noise)
    error = found.mean[:, -1] - truth
    squares = np.einsum("ni,ij,nj->n", error, np.linalg.inv(found.covariance[0, -1]), error)
    assert abs(squares.mean() - 2) < 6 * np.sqrt(4 / tracks)


@pytest.mark.parametrize("missing", [0.0, 0.3])
def test_a_run_with_a_noise_for_each_plot_is_the_textbook_recursion(missing: float) -> None:
    motion = kalman.constant_acceleration(2.0, 0.1)
    measured = measurements((3, 12, 3), missing)
    roots = np.random.default_rng(5).normal(size=(3, 12, 3, 3))
    noise = NOISE + roots @ roots.swapaxes(-1, -2)
    noise = (noise + noise.swapaxes(-1, -2)) / 2
    start = Belief(np.zeros(3), np.diag([400.0, 100.0, 25.0]))
    found = kalman.run(start, motion, measured, MATRIX, noise)
    for track in range(3):
        belief = start
        for scan in range(12):
            belief = Belief(*textbook(belief, motion, measured[track, scan : scan + 1], MATRIX, noise[track, scan]))
            assert found.mean[track, scan] == pytest.approx(belief.mean, abs=1e-7)
            assert found.covariance[track, scan] == pytest.approx(belief.covariance, abs=1e-7)


def test_tracks_share_covariances_where_the_noise_changes_from_scan_to_scan_alone() -> None:
    motion = kalman.constant_acceleration(2.0, 0.1)
    noise = NOISE * np.arange(1, 13)[:, np.newaxis, np.newaxis]
    measured = measurements((3, 12, 3), 0.0)
    start = Belief(np.zeros(3), np.diag([400.0, 100.0, 25.0]))
    shared = kalman.run(start, motion, measured, MATRIX, noise)
    each = kalman.run(start, motion, measured, MATRIX, np.broadcast_to(noise, (3, 12, 3, 3)))
    assert shared.covariance.strides[0] == 0
    assert shared.mean == pytest.approx(each.mean, rel=1e-12)
    assert shared.covariance == pytest.approx(each.covariance, rel=1e-12)


def test_an_update_takes_a_noise_for_each_track_and_broadcasts() -> None:
    noise = np.stack([np.diag([1.0, 2.0]), np.diag([3.0, 4.0])])
    start = Belief(np.zeros(2), np.diag([400.0, 100.0]))
    found = kalman.update(start, [5.0, 6.0], np.eye(2), noise)
    for track in range(2):
        alone = kalman.update(start, [5.0, 6.0], np.eye(2), noise[track])
        assert np.array_equal(found.mean[track], alone.mean)
        assert np.array_equal(found.covariance[track], alone.covariance)


def test_a_track_without_measurements_only_moves() -> None:
    motion = kalman.constant_velocity(2.0, 0.1)
    start = Belief(np.array([[1.0, 2.0]]), np.eye(2))
    found = kalman.run(start, motion, np.full((1, 1, 2), np.nan), np.eye(2), np.eye(2))
    moved = kalman.predict(start, motion)
    assert np.array_equal(found.mean[:, 0], moved.mean)
    assert np.array_equal(found.covariance[:, 0], moved.covariance)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"noise": [[1.0, 2.0], [2.0, 1.0]]}, "noise must be symmetric and positive definite"),
        ({"noise": [[1.0]]}, "noise must have shape"),
        (
            {"noise": np.broadcast_to([[1.0, 2.0], [2.0, 1.0]], (4, 2, 2))},
            "noise must be symmetric and positive definite",
        ),
        ({"noise": np.broadcast_to(np.eye(2), (7, 2, 2))}, "measured and noise must broadcast"),
        ({"matrix": [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]}, "matrix must have 2 columns, one a component; got 3"),
        ({"measured": np.full((3, 4, 2), np.inf)}, "measured must be finite, or NaN where missing; got 24 infinite"),
        ({"measured": np.zeros(2)}, "measured must have shape"),
        ({"start": Belief(np.zeros(2), np.eye(3))}, "covariance must have shape"),
        ({"motion": Motion(np.eye(3), np.eye(3))}, "transition must be finite, of shape"),
    ],
)
def test_what_does_not_fit_is_refused(change: dict[str, Any], message: str) -> None:
    arguments: dict[str, Any] = {
        "start": Belief(np.zeros(2), np.eye(2)),
        "motion": kalman.constant_velocity(1.0, 1.0),
        "measured": np.zeros((3, 4, 2)),
        "matrix": np.eye(2),
        "noise": np.eye(2),
    }
    with pytest.raises(ValueError, match=message):
        kalman.run(**(arguments | change))


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ((4, 1.0, 1.0), "degree must be from 0 to 3"),
        ((1, 0.0, 1.0), "period must be"),
        ((1, 1.0, -1.0), "intensity must"),
    ],
)
def test_a_motion_that_makes_no_sense_is_refused(arguments: Any, message: str) -> None:
    with pytest.raises(ValueError, match=message):
        kalman.polynomial_motion(*arguments)
