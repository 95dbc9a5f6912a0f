"""A covariance in single precision is one to the rounding of that, whatever it stands beside."""

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from radartrack import convert, frames, kalman, observe
from radartrack.kalman import Belief, Motion
from tests.examples import share

MOVES = kalman.motion("constant_velocity", 2.0, axes=2, std=0.0, grouped="derivative")
PLACE, OTHER = frames.enu(0.8, 0.1), frames.antenna(0.81, 0.1, azimuth=1.0, tilt=0.2)
NOTHING = np.full(2, np.nan)
SCANS = np.stack([NOTHING, [5e3, 0.9]])
WAYS: dict[str, Callable[[Any, Any], Belief]] = {
    "predict": lambda mean, P: kalman.predict(Belief(mean, P), MOVES),
    "predict each": lambda mean, P: kalman.predict(Belief(np.stack([mean] * 3), np.stack([P] * 3)), MOVES),
    "update": lambda mean, P: kalman.update(Belief(mean, P), [1.0], np.eye(1, 4), [[1.0]]),
    "update with nothing": lambda mean, P: kalman.update(Belief(mean, P), NOTHING, np.eye(2, 4), np.eye(2)),
    "update_with": lambda mean, P: kalman.update_with("polar", Belief(mean, P), [5e3, 0.9], np.diag([1.0, 1e-4])),
    "update_with nothing": lambda mean, P: kalman.update_with("polar", Belief(mean, P), NOTHING, np.eye(2), 2),
    "run": lambda mean, P: kalman.run(Belief(mean, P), MOVES, np.ones((3, 1)), np.eye(1, 4), [[1.0]]),
    "run_with": lambda mean, P: kalman.run_with("polar", Belief(mean, P), MOVES, SCANS, np.eye(2)),
}


@pytest.mark.parametrize("way", WAYS)
@given(rank=st.integers(1, 4), seed=st.integers(0, 10**6), single=st.booleans())
@share(0.5)
def test_a_belief_of_any_rank_is_filtered_and_what_comes_of_it_too(way: str, rank: int, seed: int, *, single: bool):
    root = np.random.default_rng(seed).standard_normal((4, rank)) * [[30.0], [1e-2], [1.0], [5.0]]
    P = (root @ root.T).astype(np.float32)
    mean = np.array([3e3, 4e3, 10.0, -20.0], np.float32 if single else np.float64)
    found = WAYS[way](mean, P)
    again = kalman.predict(found, Motion(np.eye(4), np.zeros((4, 4))))
    deviations = np.sqrt(np.maximum(np.diagonal(found.covariance, axis1=-2, axis2=-1), 1e-300))
    scale = deviations[..., :, np.newaxis] * deviations[..., np.newaxis, :]
    np.testing.assert_allclose(again.covariance / scale, found.covariance / scale, atol=1e-5)


@given(rank=st.integers(1, 3), seed=st.integers(0, 10**6), single=st.booleans())
@share(0.5)
def test_a_covariance_of_any_rank_is_turned_to_another_frame(rank: int, seed: int, *, single: bool):
    root = np.random.default_rng(seed).standard_normal((3, rank)) * [[30.0], [1e-2], [1.0]]
    P = (root @ root.T).astype(np.float32)
    mean = np.array([3e3, 4e3, 1e3], np.float32 if single else np.float64)
    found = PLACE.to(OTHER, mean, P)
    back = OTHER.to(PLACE, *found)
    np.testing.assert_allclose(back.covariance, P, atol=1e-3)
    frames.geodetic_from_ecef(*PLACE.to_ecef(mean, P))
    seen = observe.project("spherical", mean, P, "second_order")
    assert (np.diagonal(seen.covariance) >= 0).all()


@pytest.mark.parametrize("sign", [-1.0, 1.0])
@given(azimuth=st.floats(-3, 3), range_std=st.floats(1, 100), azimuth_std=st.floats(1e-4, 1e-2))
@share(0.3)
def test_a_plot_of_fully_correlated_errors_starts_a_track(
    sign: float, azimuth: float, range_std: float, azimuth_std: float
):
    r, *others = (np.full(2, value, np.float32) for value in (2e4, azimuth, range_std, azimuth_std, sign))
    plot = convert.polar(r, others[0], others[1], others[2], others[3], method="linear")
    assert plot.covariance.dtype == np.float32
    still = kalman.motion("constant_position", 1.0, axes=2, std=0.0)
    assert kalman.predict(Belief(*plot), still).mean.shape == (2, 2)
