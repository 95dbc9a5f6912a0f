"""Filters over many tracks: beside the bare matrix product, FilterPy's filter, and the same arithmetic by hand."""

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from filterpy.leastsq import LeastSquaresFilter

import radartrack as rt
from benchmarks.conftest import Floats
from benchmarks.stone_soup import updated_by_stone_soup
from radartrack import kalman
from radartrack.generated import observe as formulas

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


@pytest.mark.parametrize("order", [1, 2])
class TestUpdateWith:
    """The extended update of 100 000 tracks in space with a spherical plot each."""

    def test_radartrack(self, timed: Timed, order: int) -> None:
        belief, measured = scene(TRACKS)
        timed(kalman.update_with, "spherical", belief, measured, SPHERICAL_NOISE, order, items=TRACKS)

    def test_by_hand(self, timed: Timed, order: int) -> None:
        belief, measured = scene(TRACKS)
        timed(updated_by_hand, *belief, measured, order, items=TRACKS)


class TestUpdateWithPeer:
    """Track by track."""

    def test_stone_soup(self, timed: Timed) -> None:
        belief, measured = scene(FEW)
        timed(updated_by_stone_soup, *belief, measured, SPHERICAL_NOISE, items=FEW)


SPHERICAL_NOISE = np.diag([50.0, 0.01, 0.01]) ** 2


def scene(tracks: int) -> tuple[kalman.Belief, Floats]:
    """Tracks (x, y, z, vx, vy, vz) with correlations of their own, and what a radar measures of them."""
    generator = np.random.default_rng(4)
    mean = np.array([2e4, 1e4, 5e3, 0.0, 0.0, 0.0]) + 100.0 * generator.standard_normal((tracks, 6))
    root = (np.eye(6) + 0.3 * generator.standard_normal((tracks, 6, 6))) * np.array([[300.0]] * 3 + [[20.0]] * 3)
    measured = rt.observe.spherical(mean[:, :3]).measurement
    measured = measured + generator.standard_normal((tracks, 3)) * [50.0, 0.01, 0.01]
    return kalman.Belief(mean, root @ np.swapaxes(root, -1, -2)), measured


def updated_by_hand(mean: Floats, P: Floats, measured: Floats, order: int) -> tuple[Floats, Floats]:
    """As one writes it: gain and covariance in batched matrices."""
    x, y, z = mean[:, :3].T
    seen = {"x": x, "y": y, "z": z}
    innovation = measured - formulas.spherical_map(**seen)
    H = np.zeros((len(mean), 3, 6))
    H[:, :, :3] = formulas.spherical_jacobian(**seen)
    S = SPHERICAL_NOISE
    if order == 2:
        products = formulas.spherical_hessian(**seen) @ P[:, np.newaxis, :3, :3]
        innovation -= np.trace(products, axis1=-2, axis2=-1) / 2
        S = S + np.einsum("taij,tbji->tab", products, products) / 2
    innovation[:, 1] = (innovation[:, 1] + np.pi) % (2 * np.pi) - np.pi
    across = P @ np.swapaxes(H, 1, 2)
    S = H @ across + S
    gain = np.swapaxes(np.linalg.solve(S, np.swapaxes(across, 1, 2)), 1, 2)
    return mean + (gain @ innovation[..., np.newaxis])[..., 0], P - gain @ S @ np.swapaxes(gain, 1, 2)


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
