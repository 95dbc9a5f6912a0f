"""The Kalman filter against the textbook recursion and against batch least squares, and one track like many."""

from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from radartrack import kalman
from radartrack._filtering.beliefs import BLOCK
from radartrack.kalman import Belief, Motion
from radartrack.testing import strategies

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
    truth = generator.multivariate_normal(np.zeros(2), start, tracks, method="cholesky")
    measured = np.empty((tracks, scans, 2))
    for scan in range(scans):
        truth = truth @ motion.transition.T + generator.multivariate_normal(
            np.zeros(2), motion.process_noise, tracks, method="cholesky"
        )
        measured[:, scan] = truth + generator.multivariate_normal(np.zeros(2), noise, tracks, method="cholesky")
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


@pytest.mark.parametrize("size", [1, 2, 7, 8, 9, 31, 33, 62, 63, 64, 65, 66, 70, 130])
@pytest.mark.parametrize("shared", [True, False])
def test_whatever_is_missing_of_any_number_of_components_the_update_is_the_textbook_one(
    size: int, *, shared: bool
) -> None:
    """Patterns that differ in one component alone, at either end, among them."""
    generator = np.random.default_rng(size)
    matrix, root = generator.normal(size=(size, 2)), generator.normal(size=(size, size)) / size
    noise = root @ root.T + np.diag(generator.uniform(1, 9, size))
    noise = (noise + noise.T) / 2
    values = generator.normal(size=(8, size))
    values[generator.random(values.shape) < 0.3] = np.nan
    values[0], values[1], values[2] = 1.0, 1.0, 1.0
    values[1, -1] = values[2, 0] = np.nan
    values[3] = np.nan
    start, still = Belief(np.ones(2), np.array([[400.0, 30.0], [30.0, 100.0]])), Motion(np.eye(2), np.zeros((2, 2)))
    found = kalman.update(start, values, matrix, noise if shared else np.broadcast_to(noise, (8, size, size)))
    for track, measured in enumerate(values):
        mean, covariance = textbook(start, still, measured[np.newaxis], matrix, noise)
        assert found.mean[track] == pytest.approx(mean, rel=1e-9, abs=1e-9)
        assert found.covariance[track] == pytest.approx(covariance, rel=1e-7, abs=1e-9)


@pytest.mark.parametrize("tracks", [(), (1,), (0,), (0, 3), (3, 0), (2, 1)])
@pytest.mark.parametrize("scans", [0, 1, 3])
@pytest.mark.parametrize("own", [False, True])
@pytest.mark.parametrize("noise_shape", [(), "scans", "all"])
def test_no_tracks_and_no_scans_give_results_of_their_shape(
    tracks: tuple[int, ...], scans: int, noise_shape: Any, *, own: bool
) -> None:
    motion = kalman.constant_velocity(1.0, 1.0)
    start = Belief(np.zeros((*tracks, 2)), np.broadcast_to(np.eye(2), (*tracks, 2, 2)) if own else np.eye(2))
    start = start._replace(covariance=start.covariance.copy())
    leading = {"scans": (scans,), "all": (*tracks, scans)}.get(noise_shape, ())
    noise = np.broadcast_to(np.eye(2), (*leading, 2, 2))
    found = kalman.run(start, motion, np.zeros((*tracks, scans, 2)), np.eye(2), noise)
    assert found.mean.shape == (*tracks, scans, 2)
    assert found.covariance.shape == (*tracks, scans, 2, 2)
    step = kalman.update(kalman.predict(start, motion), np.zeros((*tracks, 2)), np.eye(2), np.eye(2))
    assert (step.mean.shape, step.covariance.shape) == ((*tracks, 2), (*tracks, 2, 2))
    if scans:
        assert np.array_equal(step.mean, found.mean[..., 0, :])


@given(scale=st.floats(-100, 100), prior=st.floats(0, 40), believed=strategies.covariances(3))
def test_what_a_step_returns_the_next_step_takes(scale: float, prior: float, believed: np.ndarray) -> None:
    """However much a measurement tells beside what was believed: up to 40 orders of magnitude in the variances."""
    belief = Belief(np.zeros(3), believed * 10.0 ** (scale + prior))
    motion = kalman.constant_acceleration(1.0, 10.0**scale * 1e-3)
    noise = np.diag([10.0**scale, 10.0 ** (scale + 1)])
    for _ in range(6):
        belief = kalman.update(kalman.predict(belief, motion), [1.0, np.nan], np.eye(3)[:2], noise)
    assert np.all(np.diagonal(belief.covariance) > 0)


@pytest.mark.parametrize("double", ["mean", "covariance", "F", "Q", "measured", "H", "R", "", "receiver"])
@pytest.mark.parametrize("call", ["predict", "update", "run", "update_with", "run_with"])
def test_a_step_is_in_float32_where_all_that_is_given_is_and_else_as_in_float64(call: str, double: str) -> None:
    """Also where only what was believed is in float32: nothing is rounded to seven digits beside float64."""
    generator = np.random.default_rng(2)
    arrays: dict[str, Any] = {"mean": generator.normal(size=(4, 6)) * 1e3, "covariance": np.diag([1e3] * 6)}
    arrays |= {"F": np.eye(6) + np.eye(6, k=3) / 3, "Q": np.eye(6) / 7, "R": np.eye(1) / 3}
    arrays |= {"measured": generator.normal(size=(4, 3, 1)), "H": generator.normal(size=(1, 6)), "receiver": np.ones(3)}
    single = {name: array.astype(np.float32) for name, array in arrays.items()}
    used = {
        "predict": ["mean", "covariance", "F", "Q"],
        "update": ["mean", "covariance", "measured", "H", "R"],
        "run": ["mean", "covariance", "F", "Q", "measured", "H", "R"],
        "update_with": ["mean", "covariance", "measured", "R", "receiver"],
        "run_with": ["mean", "covariance", "F", "Q", "measured", "R", "receiver"],
    }

    def step(of: dict[str, Any]) -> Belief:
        belief, motion, z = Belief(of["mean"], of["covariance"]), Motion(of["F"], of["Q"]), of["measured"]
        return {
            "predict": lambda: kalman.predict(belief, motion),
            "update": lambda: kalman.update(belief, z[:, 0], of["H"], of["R"]),
            "run": lambda: kalman.run(belief, motion, z, of["H"], of["R"]),
            "update_with": lambda: kalman.update_with(
                "range_difference", belief, z[:, 0], of["R"], receiver=of["receiver"]
            ),
            "run_with": lambda: kalman.run_with(
                "range_difference", belief, motion, z, of["R"], receiver=of["receiver"]
            ),
        }[call]()

    exact = {name: array.astype(np.float64) for name, array in single.items()}
    got, expected = step(single | {name: exact[name] for name in [double] if name}), step(exact)
    in_double = double in used[call]
    assert {part.dtype for part in got} == {np.dtype(np.float64 if in_double else np.float32)}
    for part, other in zip(got, expected, strict=True):
        np.testing.assert_allclose(part, other, rtol=1e-12 if in_double else 1e-3, atol=1e-9 if in_double else 1.0)


@pytest.mark.parametrize("bad", [np.nan, np.inf, -np.inf])
@pytest.mark.parametrize("call", ["predict", "update", "run"])
def test_a_belief_that_is_none_is_refused(bad: float, call: str) -> None:
    good = Belief(np.zeros((2, 3)), np.broadcast_to(np.eye(3), (2, 3, 3)).copy())
    mean, entry, skew, negative, impossible = (part.copy() for part in (good.mean, *[good.covariance] * 4))
    mean[1, 1] = entry[1, 0, 0] = bad
    skew[1, 0, 1] = 0.1
    negative[1] *= -1
    impossible[1] = [[1.0, 0.9, -0.9], [0.9, 1.0, 0.9], [-0.9, 0.9, 1.0]]
    motion = kalman.constant_acceleration(1.0, 1.0)
    calls: dict[str, Any] = {
        "predict": lambda belief: kalman.predict(belief, motion),
        "update": lambda belief: kalman.update(belief, [0.0], [[1.0, 0.0, 0.0]], [[1.0]]),
        "run": lambda belief: kalman.run(belief, motion, np.zeros((2, 4, 1)), [[1.0, 0.0, 0.0]], [[1.0]]),
    }
    with pytest.raises(ValueError, match="mean must be finite"):
        calls[call](good._replace(mean=mean))
    for covariance, reason in (
        (entry, "finite"),
        (skew, "symmetric"),
        (negative, "without a negative variance"),
        (impossible, "positive semidefinite"),
    ):
        for given_covariance in (covariance, covariance[1]):
            with pytest.raises(ValueError, match=f"covariance must be {reason}"):
                calls[call](good._replace(covariance=given_covariance))


@pytest.mark.parametrize("value", [1e200, 1e308])
def test_what_overflows_is_refused(value: float) -> None:
    motion = Motion(np.eye(2) * value, np.zeros((2, 2)))
    with pytest.raises(ValueError, match="of the result must be finite"):
        kalman.predict(Belief(np.zeros(2), np.eye(2) * value), motion)
    with pytest.raises(ValueError, match="of the result must be finite"):
        kalman.run(Belief(np.full(2, value), np.eye(2)), motion, np.zeros((3, 1)), [[1.0, 0.0]], [[1.0]])


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"noise": [[np.inf, 0.0], [0.0, 1.0]]}, "noise must be finite"),
        ({"noise": [[np.nan, 0.0], [0.0, 1.0]]}, "noise must be finite"),
        ({"noise": -np.eye(2)}, "noise must be without a negative variance"),
        ({"matrix": np.empty((0, 2)), "noise": np.empty((0, 0)), "measured": np.empty((4, 0))}, "neither of them 0"),
        ({"motion": Motion(np.eye(2), -np.eye(2))}, "process_noise must be without a negative variance"),
        ({"motion": Motion(np.eye(2), np.array([[1.0, 0.5], [0.0, 1.0]]))}, "process_noise must be symmetric"),
        ({"motion": Motion(np.eye(2), np.array([[1.0, 2.0], [2.0, 1.0]]))}, "process_noise must be positive semidef"),
        ({"noise": [[1.0, 2.0], [2.0, 1.0]]}, "noise must be positive semidefinite"),
        ({"noise": [[1.0]]}, "noise must have shape"),
        ({"noise": np.broadcast_to([[1.0, 2.0], [2.0, 1.0]], (4, 2, 2))}, "noise must be positive semidefinite"),
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
        ((1, 1.0, np.nan), "intensity must be finite"),
        ((1, 10**400, 1.0), "period must be finite"),
        ((3, 1e200, 1.0), "period 1e.200 must be finite"),
        ((3, 1e-60, 1.0), "process noise of intensity 1.0 over 1e-60 s must be of variances from"),
    ],
)
def test_a_motion_that_makes_no_sense_is_refused(arguments: Any, message: str) -> None:
    with pytest.raises(ValueError, match=message):
        kalman.polynomial_motion(*arguments)


@pytest.mark.parametrize("degree", [True, 1.0, "1", None, np.bool_(1)])
def test_a_degree_that_is_no_whole_number_is_refused(degree: Any) -> None:
    with pytest.raises(TypeError, match="degree must be a whole number; got"):
        kalman.polynomial_motion(degree, 1.0, 1.0)


@pytest.mark.parametrize("arguments", [(True, 1.0), ("1", 1.0), (1.0, None), (1.0, [1.0])])
def test_a_period_or_an_intensity_that_is_no_number_is_refused(arguments: Any) -> None:
    with pytest.raises(TypeError, match="must be a real number; got"):
        kalman.constant_velocity(*arguments)


def test_whole_numbers_of_numpy_are_degrees() -> None:
    for degree in (np.int64(2), np.uint8(2)):
        motion = kalman.polynomial_motion(degree, np.float32(2.0), np.int16(3))  # type: ignore[arg-type]
        assert np.array_equal(motion, kalman.polynomial_motion(2, 2.0, 3.0))


@pytest.mark.parametrize("dtype", [np.float64, np.float32])
def test_more_tracks_than_a_block_holds_are_predicted_each_with_the_bits_of_one_alone(dtype: Any) -> None:
    count = BLOCK + 3
    generator = np.random.default_rng(3)
    root = generator.standard_normal((count, 4, 4)) * [[100.0], [100.0], [5.0], [5.0]]
    belief = Belief(generator.standard_normal((count, 4)).astype(dtype), (root @ np.swapaxes(root, 1, 2)).astype(dtype))
    motion = kalman.motion("constant_velocity", 2.0, axes=2, std=3.0, grouped="derivative")
    got = kalman.predict(belief, motion)
    assert got.mean.dtype == got.covariance.dtype == np.float64
    for index in (0, BLOCK, count - 1):
        alone = kalman.predict(Belief(belief.mean[index], belief.covariance[index]), motion)
        np.testing.assert_array_equal(got.mean[index], alone.mean)
        np.testing.assert_array_equal(got.covariance[index], alone.covariance)
        expected = motion.transition @ belief.covariance[index] @ motion.transition.T + motion.process_noise
        np.testing.assert_allclose(alone.covariance, expected, rtol=1e-4, atol=1e-2)
    bad = belief.covariance.copy()
    bad[count - 2, 0, 0] = -1
    with pytest.raises(ValueError, match=rf"negative variance; .* at \[{count - 2}\], the first of 1 among {count}"):
        kalman.predict(Belief(belief.mean, bad), motion)
