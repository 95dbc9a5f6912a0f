"""Linear motions by their names: every one runs, in blocks, and what is not one is refused."""

from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from radartrack import kalman
from radartrack._arrays.linear_motions import MOTIONS
from radartrack.generated import motion as formulas
from radartrack.kalman import Belief
from tests.examples import share

VALUES = {"intensity": 0.3, "std": 0.7, "jump_std": 0.2, "time_constant": 20.0, "rate": -0.05}
CASES = [(name, noise) for name, known in MOTIONS.items() for noise in known.noises]


def parameters(name: str, noise: str) -> dict[str, Any]:
    return {word: VALUES[word] for word in (*MOTIONS[name].given, noise)}


@pytest.mark.parametrize(("name", "noise"), CASES)
def test_every_motion_predicts_and_runs_by_its_name(name: str, noise: str) -> None:
    moves = kalman.motion(name, 2.0, **parameters(name, noise))
    size = len(moves.transition)
    start = Belief(np.arange(1.0, size + 1), np.eye(size))
    ahead = kalman.predict(start, moves)
    np.testing.assert_allclose(ahead.mean, moves.transition @ start.mean, rtol=1e-12)
    np.testing.assert_allclose(
        ahead.covariance, moves.transition @ moves.transition.T + moves.process_noise, rtol=1e-12, atol=1e-12
    )
    found = kalman.run(start, moves, np.ones((5, 1)), np.eye(1, size), [[4.0]])
    assert found.mean.shape == (5, size)
    assert (found.covariance[:, 0, 0] < 4.0).all()


@pytest.mark.parametrize(("name", "noise"), [case for case in CASES if MOTIONS[case[0]].most_axes > 1])
@pytest.mark.parametrize("axes", [2, 3])
def test_axes_move_in_blocks_each_on_its_own(name: str, noise: str, axes: int) -> None:
    one, more = (kalman.motion(name, 2.0, axes=n, **parameters(name, noise)) for n in (1, axes))
    size = len(one.transition)
    for found, block in zip(more, one, strict=True):
        for m in range(axes):
            for n in range(axes):
                part = found[m * size : (m + 1) * size, n * size : (n + 1) * size]
                np.testing.assert_array_equal(part, block if m == n else np.zeros_like(block))


def test_a_polynomial_motion_with_white_noise_is_the_one_of_its_degree() -> None:
    for degree, name in enumerate(kalman.POLYNOMIAL):
        by_degree, by_name = kalman.polynomial_motion(degree, 2.0, 0.5), kalman.motion(name, 2.0, intensity=0.5)
        for found, expected in zip(by_degree, by_name, strict=True):
            np.testing.assert_array_equal(found, expected)


def test_the_time_constant_is_one_over_alpha() -> None:
    moves = kalman.motion("singer", 2.0, time_constant=20.0, std=3.0)
    np.testing.assert_array_equal(moves.transition, formulas.singer_transition(T=2.0, alpha=0.05))
    np.testing.assert_array_equal(moves.process_noise, formulas.singer_process_noise(T=2.0, alpha=0.05, sigma_m=3.0))


@pytest.mark.parametrize(
    ("name", "words", "said"),
    [
        ("constant_speed", {"intensity": 1.0}, "name must be one of .*constant_velocity"),
        ("constant_velocity", {}, "intensity or std or jump_std; got none"),
        ("constant_velocity", {"intensity": 1.0, "std": 1.0}, "got intensity, std"),
        ("constant_velocity", {"intensity": 1.0, "rate": 1.0}, "got intensity, rate"),
        ("constant_velocity", {"std": -1.0}, "std must be finite and at least 0; got -1"),
        ("constant_velocity", {"std": np.inf}, "std must be finite"),
        ("constant_velocity", {"std": 1e200}, "process noise of std"),
        ("singer", {"std": 1.0}, "time_constant and std; got std"),
        ("singer", {"std": 1.0, "time_constant": 0.0}, "time_constant must be more than 0"),
        ("turn.known_rate", {"std": 1.0, "rate": np.nan}, "rate must be finite"),
    ],
)
def test_what_is_no_motion_is_refused_by_name(name: str, words: dict[str, Any], said: str) -> None:
    with pytest.raises(ValueError, match=said):
        kalman.motion(name, 2.0, **words)


@pytest.mark.parametrize(("name", "noise"), CASES)
@given(period=st.floats(-250, 250), given_power=st.floats(-307, 300), noise_power=st.floats(-100, 100))
@share(0.2)
def test_matrices_of_any_size_are_finite_or_refused(
    name: str, noise: str, period: float, given_power: float, noise_power: float
) -> None:
    words = dict.fromkeys(MOTIONS[name].given, 10.0**given_power) | {noise: 10.0**noise_power}
    try:
        moves = kalman.motion(name, 10.0**period, **words)
    except ValueError as error:
        assert str(error).startswith(("the transition over", "the process noise of"))  # noqa: PT017 - most are fine
    else:
        assert np.isfinite(moves.transition).all()
        assert np.isfinite(moves.process_noise).all()


@pytest.mark.parametrize("period", [0.0, -1.0, np.nan])
def test_a_period_is_positive(period: float) -> None:
    with pytest.raises(ValueError, match="period"):
        kalman.motion("constant_velocity", period, intensity=1.0)


def test_a_turn_has_two_axes_already() -> None:
    with pytest.raises(ValueError, match="axes"):
        kalman.motion("turn.known_rate", 1.0, axes=2, rate=0.1, std=1.0)
