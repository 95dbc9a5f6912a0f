"""Filters over many tracks: beside the bare matrix product, FilterPy's filter, and the same arithmetic by hand."""

from collections.abc import Callable
from typing import Any

import numpy as np
from filterpy.leastsq import LeastSquaresFilter

import radartrack as rt
from benchmarks.conftest import Floats
from radartrack import kalman

TRACKS, SCANS = 100_000, 20
FEW = 200
Timed = Callable[..., Any]


def ranges(tracks: int = TRACKS, scans: int = SCANS) -> Floats:
    generator = np.random.default_rng(2)
    return 1e5 - 2000.0 * np.arange(scans) + generator.normal(0, 250.0, (tracks, scans))


class TestEstimate:
    """FiniteSampleFilter.estimate."""

    def test_radartrack(self, timed: Timed) -> None:
        timed(finite_sample().estimate, ranges(), items=TRACKS)

    def test_bare_product(self, timed: Timed) -> None:
        weights = finite_sample().weights(SCANS).ranges.T.copy()
        timed(np.matmul, ranges(), weights, items=TRACKS)


class TestRun:
    """The growing window: an estimate after each scan."""

    def test_radartrack(self, timed: Timed) -> None:
        timed(finite_sample().run, ranges(), items=TRACKS * SCANS, rounds=20)

    def test_filterpy(self, timed: Timed) -> None:
        timed(by_filterpy, ranges(FEW), items=FEW * SCANS, rounds=20)


class TestKalman:
    """A constant-velocity filter over 10 000 tracks of 100 steps."""

    def test_radartrack(self, timed: Timed) -> None:
        timed(by_radartrack, ranges(10_000, 100), items=10_000 * 100, rounds=3)

    def test_by_hand(self, timed: Timed) -> None:
        timed(by_hand, ranges(10_000, 100), items=10_000 * 100, rounds=3)


def finite_sample() -> rt.FiniteSampleFilter:
    return rt.FiniteSampleFilter(period=10.0, range_std=250.0, degree=2)


def by_filterpy(tracks: Floats) -> None:
    for track in tracks:
        fitted = LeastSquaresFilter(dt=10.0, order=2)
        for measured in track:
            fitted.update(measured)


MATRIX = np.array([[1.0, 0.0]])
NOISE = np.array([[250.0**2]])
START = np.diag([250.0**2, 300.0**2])


def by_radartrack(tracks: Floats) -> Any:
    mean = np.stack([tracks[:, 0], np.zeros(len(tracks))], axis=-1)
    belief = kalman.Belief(mean, np.broadcast_to(START, (len(tracks), 2, 2)))
    return kalman.run(belief, kalman.constant_velocity(10.0, 1.0), tracks[..., np.newaxis], MATRIX, NOISE)


def by_hand(tracks: Floats) -> tuple[Floats, Floats]:
    transition = np.array([[1.0, 10.0], [0.0, 1.0]])
    process = np.array([[10.0**3 / 3, 10.0**2 / 2], [10.0**2 / 2, 10.0]])
    state = np.stack([tracks[:, 0], np.zeros(len(tracks))], axis=-1)
    covariance = np.broadcast_to(START, (len(tracks), 2, 2)).copy()
    states = np.empty((*tracks.shape, 2))
    covariances = np.empty((*tracks.shape, 2, 2))
    for step in range(tracks.shape[1]):
        state = np.einsum("ij,nj->ni", transition, state)
        covariance = transition @ covariance @ transition.T + process
        innovation = tracks[:, step] - state[:, 0]
        gain = covariance[:, :, 0] / (covariance[:, 0, 0] + NOISE[0, 0])[:, np.newaxis]
        state = state + gain * innovation[:, np.newaxis]
        covariance = covariance - gain[:, :, np.newaxis] * covariance[:, :1, :]
        states[:, step], covariances[:, step] = state, covariance
    return states, covariances
