"""Extended predictions and runs of motions that are no matrix, beside differences, simulation and plain filters."""

import pickle
from typing import Any

import numpy as np
import pytest

from radartrack import consistency, kalman
from radartrack.kalman import Belief, NonlinearMotion

STATES = {
    "turn.unknown_rate": np.array([4e3, 120.0, -2e3, -90.0, 0.11]),
    "ctrv": np.array([4e3, -2e3, 150.0, 2.2, 0.11]),
}
P = np.diag([50.0, 4.0, 60.0, 5.0, 0.02]) ** 2
P[0, 1] = P[1, 0] = 120.0
OF_HEADING = np.diag([50.0, 60.0, 4.0, 0.05, 0.02]) ** 2


def moves(name: str, **more: Any) -> NonlinearMotion:
    return kalman.nonlinear_motion(name, 2.0, std=3.0, turn_std=0.01, **more)


def start(name: str) -> Belief:
    return Belief(STATES[name], P if name != "ctrv" else OF_HEADING)


def pushed(name: str, states: Any, accelerations: Any, period: float, steps: int = 400) -> Any:
    """The state a period later, by midpoint steps of the differential equation; accelerations on the last axis."""

    def rate(state: Any) -> Any:
        if name == "ctrv":
            _, _, speed, heading, omega = np.moveaxis(state, -1, 0)
            parts = (speed * np.cos(heading), speed * np.sin(heading), accelerations[..., 0], omega)
        else:
            _, vx, _, vy, omega = np.moveaxis(state, -1, 0)
            parts = (vx, accelerations[..., 0] - omega * vy, vy, accelerations[..., 1] + omega * vx)
        return np.stack(np.broadcast_arrays(*parts, accelerations[..., -1]), axis=-1)

    step = period / steps
    for _ in range(steps):
        states = states + step * rate(states + step / 2 * rate(states))
    return states


@pytest.mark.parametrize("name", STATES)
def test_the_map_is_the_flow_and_the_noise_what_accelerations_leave_of_it(name: str) -> None:
    size = 2 if name == "ctrv" else 3
    motion, state = moves(name), STATES[name]
    flow = pushed(name, state, np.zeros(size), 2.0)
    np.testing.assert_allclose(motion.map(state), flow, rtol=1e-6)
    small = 1e-4
    unit = small * np.eye(size)
    columns = (pushed(name, state, unit, 2.0) - pushed(name, state, -unit, 2.0)).T / (2 * small)
    deviations = np.array([3.0] * (size - 1) + [0.01])
    expected = columns @ np.diag(deviations**2) @ columns.T
    scale = np.sqrt(np.diagonal(expected))
    assert (np.abs(motion.process_noise(state) - expected) <= 1e-4 * np.outer(scale, scale)).all()


@pytest.mark.parametrize("order", [1, 2])
@pytest.mark.parametrize("name", STATES)
def test_a_prediction_is_that_of_the_books_for_each_of_many_tracks(name: str, order: Any) -> None:
    motion, belief = moves(name), start(name)
    shifts = np.array([[0.0] * 5, [900.0, 30.0, 40.0, 3.0, -0.3]])
    got = kalman.predict(Belief(belief.mean + shifts, belief.covariance), motion, order)
    for k, state in enumerate(belief.mean + shifts):
        F, G, Q = motion.jacobian(state), motion.hessian(state), motion.process_noise(state)
        mean, spread = motion.map(state), F @ belief.covariance @ F.T + Q
        if order == 2:
            products = [curvature @ belief.covariance for curvature in G]
            mean = mean + [np.trace(one) / 2 for one in products]
            spread = spread + np.array([[np.trace(a @ b) / 2 for b in products] for a in products])
        deviations = np.sqrt(np.diagonal(spread))
        assert (np.abs(got.mean[k] - mean) <= 1e-9 * deviations).all()
        assert (np.abs(got.covariance[k] - spread) <= 1e-9 * np.outer(deviations, deviations)).all()


def test_the_second_order_tells_where_a_turning_target_will_be() -> None:
    generator = np.random.default_rng(1)
    belief = Belief(STATES["ctrv"], np.diag([5.0, 5.0, 4.0, 0.2, 0.05]) ** 2)
    draws = generator.multivariate_normal(belief.mean, belief.covariance, 4000, method="cholesky")
    accelerations = generator.standard_normal((4000, 2)) * [3.0, 0.01]
    later = pushed("ctrv", draws, accelerations, 2.0, 40)
    ratios = []
    for order in (1, 2):
        predicted = kalman.predict(belief, moves("ctrv"), order)
        ratios.append(consistency.nees(predicted.mean, predicted.covariance, later).mean() / 5)
    assert abs(ratios[1] - 1) < 0.06
    assert ratios[0] > 1.15


def test_a_linear_motion_as_functions_is_filtered_as_its_matrices_are() -> None:
    linear = kalman.motion("turn.known_rate", 2.0, rate=0.05, intensity=2.0)
    F, Q = linear
    functions = NonlinearMotion(
        4,
        lambda states: states @ F.T,
        lambda states: np.broadcast_to(F, (*states.shape[:-1], 4, 4)),
        lambda states: np.zeros((*states.shape[:-1], 4, 4, 4)),
        lambda states: np.broadcast_to(Q, (*states.shape[:-1], 4, 4)),
    )
    generator = np.random.default_rng(2)
    plots = generator.normal(0, 100.0, (3, 7, 2))
    plots[1, 3] = np.nan
    belief = Belief(np.zeros((3, 4)), np.diag([1e4, 1e3, 1e4, 1e3]))
    sees = np.array([[1.0, 0, 0, 0], [0, 0, 1.0, 0]])
    expected = kalman.run(belief, linear, plots, sees, 25.0 * np.eye(2))
    for order in (1, 2):
        got = kalman.run(belief, functions, plots, sees, 25.0 * np.eye(2), order)
        np.testing.assert_allclose(got.mean, expected.mean, rtol=1e-9, atol=1e-9)
        np.testing.assert_allclose(got.covariance, expected.covariance, rtol=1e-9, atol=1e-9)


def test_grouping_by_derivative_exchanges_components_of_matrices_and_of_functions() -> None:
    order = [0, 2, 1, 3]
    for arguments in (("turn.known_rate", 2.0), ("constant_velocity", 2.0)):
        more: dict[str, Any] = {"rate": 0.1} if arguments[0].startswith("turn") else {"axes": 2}
        by_axis = kalman.motion(*arguments, std=1.0, **more)
        grouped = kalman.motion(*arguments, std=1.0, grouped="derivative", **more)
        for one, other in zip(by_axis, grouped, strict=True):
            np.testing.assert_array_equal(other, one[np.ix_(order, order)])
    state, order = STATES["turn.unknown_rate"], [0, 2, 1, 3, 4]
    plain, grouped_too = moves("turn.unknown_rate"), moves("turn.unknown_rate", grouped="derivative")
    np.testing.assert_array_equal(grouped_too.map(state[order]), plain.map(state)[order])
    np.testing.assert_array_equal(grouped_too.jacobian(state[order]), plain.jacobian(state)[np.ix_(order, order)])
    np.testing.assert_array_equal(grouped_too.hessian(state[order]), plain.hessian(state)[np.ix_(order, order, order)])
    noise = plain.process_noise(state)[np.ix_(order, order)]
    np.testing.assert_array_equal(grouped_too.process_noise(state[order]), noise)


@pytest.mark.parametrize("order", [1, 2])
def test_a_run_with_a_sensor_is_predictions_and_updates_in_turn(order: Any) -> None:
    motion = moves("ctrv")
    generator = np.random.default_rng(3)
    noise = np.diag([30.0, 0.01]) ** 2
    noises = noise * np.arange(1.0, 5.0)[:, np.newaxis, np.newaxis]
    measured = np.array([4.4e3, -0.4]) + generator.standard_normal((2, 4, 2)) * [30.0, 0.01]
    measured[1, 2, 1] = np.nan
    for errors in (noise, noises):
        got = kalman.run_with("polar", start("ctrv"), motion, measured, errors, order)
        assert (got.mean.shape, got.covariance.shape) == ((2, 4, 5), (2, 4, 5, 5))
        belief = Belief(np.stack([STATES["ctrv"]] * 2), np.stack([OF_HEADING] * 2))
        for scan in range(4):
            own = errors if errors.ndim == 2 else errors[scan]
            predicted = kalman.predict(belief, motion, order)
            belief = kalman.update_with("polar", predicted, measured[:, scan], own, order)
            np.testing.assert_allclose(got.mean[:, scan], belief.mean, rtol=1e-12)
            np.testing.assert_allclose(got.covariance[:, scan], belief.covariance, rtol=1e-9)


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda: kalman.nonlinear_motion("ctrl", 2.0, std=1.0, turn_std=0.1), "name must be one of"),
        (lambda: kalman.nonlinear_motion("ctrv", 2.0, std=-1.0, turn_std=0.1), "std must be at least 0"),
        (lambda: kalman.nonlinear_motion("ctrv", 0.0, std=1.0, turn_std=0.1), "period must be more than 0"),
        (lambda: kalman.predict(Belief(np.zeros(4), np.eye(4)), moves("ctrv")), "the 5 components of the motion"),
        (
            lambda: kalman.predict(Belief(np.zeros(5), np.eye(5)), NonlinearMotion(5, *[lambda states: states] * 4)),
            r"jacobian must give floats of shape \(1, 5, 5\)",
        ),
        (lambda: kalman.run_with("polar", start("ctrv"), moves("ctrv"), [1.0, 2.0], np.eye(2)), "scans"),
    ],
)
def test_what_does_not_fit_is_refused(call: Any, message: str) -> None:
    with pytest.raises(ValueError, match=message):
        call()


def test_a_sharp_measurement_of_a_vague_track_keeps_its_digits() -> None:
    P = np.diag([1e8, 1e8, 1e4, 1e4]).astype(float)
    P[0, 2] = P[2, 0] = 0.9e6
    belief = Belief(np.array([3e4, 4e4, 10.0, -20.0]), P)
    got = kalman.update_with("polar", belief, [5e4, 0.9272952180016122], np.diag([1e-3, 1e-8]) ** 2)
    information = np.linalg.inv(P)
    H = np.zeros((2, 4))
    H[:, :2] = [[0.6, 0.8], [-0.8 / 5e4, 0.6 / 5e4]]
    expected = np.linalg.inv(information + H.T @ np.diag([1e6, 1e16]) @ H)
    deviations = np.sqrt(np.diagonal(expected))
    assert (np.abs(got.covariance - expected) <= 1e-6 * np.outer(deviations, deviations)).all()
    assert (np.linalg.eigvalsh(got.covariance / np.outer(deviations, deviations)) > 0).all()


@pytest.mark.parametrize("name", ["turn.unknown_rate", "ctrv"])
def test_a_motion_is_handed_to_another_process_as_it_is(name: str) -> None:
    motion = kalman.nonlinear_motion(name, 2.0, std=1.0, turn_std=0.01)
    received = pickle.loads(pickle.dumps(motion))  # noqa: S301 - what was made here
    assert (received, hash(received)) == (motion, hash(motion))
    states = np.array([[1e3, 50.0, 2e3, 0.3, 0.01]])
    for part in ("map", "jacobian", "hessian", "process_noise"):
        np.testing.assert_array_equal(getattr(received, part)(states), getattr(motion, part)(states))
