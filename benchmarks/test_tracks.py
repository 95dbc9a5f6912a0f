"""Starts, observations, fusion, consistency and steady filters of many tracks, beside what one would write or take."""

from collections.abc import Callable
from typing import Any

import numpy as np
from filterpy.gh import GHFilter
from scipy import optimize
from stonesoup.models.measurement.nonlinear import CartesianToElevationBearingRangeRate
from stonesoup.types.state import State

import radartrack as rt
from benchmarks.conftest import Floats
from radartrack import kalman, simulate

TRACKS, FEW = 100_000, 200
SIX = np.array([[300.0]] * 3 + [[20.0]] * 3)
NOISE = {"range_std": 30.0, "azimuth_std": 0.01, "elevation_std": 0.01, "range_rate_std": 2.0}
Timed = Callable[..., Any]


def plots(seed: int = 0) -> dict[str, Any]:
    generator = np.random.default_rng(seed)
    ranges = {"r": (1e3, 1e5), "azimuth": (-3.0, 3.0), "elevation": (0.0, 1.0), "range_rate": (-300.0, 300.0)}
    return {name: generator.uniform(*ends, TRACKS) for name, ends in ranges.items()} | NOISE


def states(tracks: int = TRACKS) -> Floats:
    generator = np.random.default_rng(1)
    return np.array([2e4, 1e4, 5e3, 0.0, 0.0, 0.0]) + SIX[:, 0] * generator.standard_normal((tracks, 6))


def covariances(tracks: int = TRACKS, of: int = 1, size: int = 6) -> Floats:
    generator = np.random.default_rng(2)
    root = (np.eye(size) + 0.3 * generator.standard_normal((tracks, of, size, size))) * SIX[:size]
    return np.asarray((root @ np.swapaxes(root, -1, -2)).squeeze(1) if of == 1 else root @ np.swapaxes(root, -1, -2))


class TestStart:
    """A track's first state, beside linearised ones by hand, without what range rates and prior tell of positions."""

    def test_one_plot(self, timed: Timed) -> None:
        timed(rt.initiate.one_plot, "spherical_doppler", plots(), 100.0, items=TRACKS)

    def test_one_by_hand(self, timed: Timed) -> None:
        timed(started_by_hand, plots(), items=TRACKS)

    def test_two_plots(self, timed: Timed) -> None:
        timed(rt.initiate.two_plots, "spherical_doppler", plots(), plots(1), 4.0, items=TRACKS)

    def test_two_by_hand(self, timed: Timed) -> None:
        timed(differenced_by_hand, plots(), plots(1), items=TRACKS)


def located_by_hand(plot: dict[str, Any]) -> tuple[Floats, Floats, Floats]:
    """Position, its covariance from the Jacobian, and the direction."""
    r, azimuth, elevation = (plot[name] for name in ("r", "azimuth", "elevation"))
    sine, cosine, up, level = np.sin(azimuth), np.cos(azimuth), np.sin(elevation), np.cos(elevation)
    u = np.stack([level * sine, level * cosine, up], axis=-1)
    turned = np.stack([r * level * cosine, -r * level * sine, 0 * r], axis=-1)
    raised = np.stack([-r * up * sine, -r * up * cosine, r * level], axis=-1)
    J = np.stack([u, turned, raised], axis=-1)
    R = np.diag([NOISE[f"{name}_std"] for name in ("range", "azimuth", "elevation")]) ** 2
    return r[:, np.newaxis] * u, J @ R @ np.swapaxes(J, -1, -2), u


def started_by_hand(plot: dict[str, Any]) -> tuple[Floats, Floats]:
    position, spread, u = located_by_hand(plot)
    share = 100.0**2 / (100.0**2 + NOISE["range_rate_std"] ** 2)
    covariance = np.zeros((len(position), 6, 6))
    covariance[:, :3, :3] = spread
    covariance[:, 3:, 3:] = 100.0**2 * (np.eye(3) - share * u[:, :, np.newaxis] * u[:, np.newaxis])
    return np.concatenate([position, share * plot["range_rate"][:, np.newaxis] * u], axis=-1), covariance


def differenced_by_hand(first: dict[str, Any], second: dict[str, Any], T: float = 4.0) -> tuple[Floats, Floats]:
    (p1, c1, _), (p2, c2, _) = located_by_hand(first), located_by_hand(second)
    covariance = np.empty((len(p1), 6, 6))
    covariance[:, :3, :3], covariance[:, 3:, 3:] = c2, (c1 + c2) / T**2
    covariance[:, :3, 3:] = covariance[:, 3:, :3] = c2 / T
    return np.concatenate([p2, (p2 - p1) / T], axis=-1), covariance


class TestObserve:
    """What a radar measures, and its derivatives; Stone Soup has the first ones, numerically."""

    def test_radartrack(self, timed: Timed) -> None:
        timed(rt.observe.spherical_doppler, states(), items=TRACKS)

    def test_stone_soup(self, timed: Timed) -> None:
        model = CartesianToElevationBearingRangeRate(
            ndim_state=6, mapping=(0, 1, 2), velocity_mapping=(3, 4, 5), noise_covar=np.eye(4)
        )

        def see(some: Floats) -> None:
            for state in some:
                model.function(State(state[:, np.newaxis]), noise=False)
                model.jacobian(State(state[:, np.newaxis]))

        timed(see, states(FEW), items=FEW)


class TestPredict:
    """A linear prediction in space."""

    def test_radartrack(self, timed: Timed) -> None:
        motion = kalman.motion("constant_velocity", 4.0, axes=3, std=2.0)
        timed(kalman.predict, kalman.Belief(states(), covariances()), motion, items=TRACKS)

    def test_by_hand(self, timed: Timed) -> None:
        F, Q = kalman.motion("constant_velocity", 4.0, axes=3, std=2.0)
        timed(lambda mean, P: (mean @ F.T, F @ P @ F.T + Q), states(), covariances(), items=TRACKS)


class TestFuse:
    """Three measurements of a point, beside inverses of their covariances."""

    def test_radartrack(self, timed: Timed) -> None:
        timed(rt.fusion.fuse, measured_thrice(), covariances(of=3, size=3), items=TRACKS)

    def test_by_hand(self, timed: Timed) -> None:
        def fused(mean: Floats, P: Floats) -> tuple[Floats, Floats]:
            information = np.linalg.inv(P)
            covariance = np.linalg.inv(information.sum(axis=1))
            return (covariance @ (information @ mean[..., np.newaxis]).sum(axis=1))[..., 0], covariance

        timed(fused, measured_thrice(), covariances(of=3, size=3), items=TRACKS)


def measured_thrice() -> Floats:
    return np.stack([states()[:, :3]] * 3, axis=1)


class TestIntersection:
    """Covariance intersection, beside SciPy's search for the weight, pair by pair."""

    def test_radartrack(self, timed: Timed) -> None:
        mean = np.stack([states()[:, :4]] * 2, axis=1)
        timed(rt.fusion.covariance_intersection, mean, covariances(of=2, size=4), items=TRACKS)

    def test_scipy(self, timed: Timed) -> None:
        def intersected(pairs: Floats) -> None:
            for first, second in np.linalg.inv(pairs):
                least = optimize.minimize_scalar(
                    lambda w, one=first, other=second: np.trace(np.linalg.inv(w * one + (1 - w) * other)),
                    bounds=(0, 1),
                    method="bounded",
                )
                np.linalg.inv(least.x * first + (1 - least.x) * second)

        timed(intersected, covariances(FEW, of=2, size=4), items=FEW)


class TestRegistration:
    """Biases of three radars from two hundred common targets, beside SciPy's least squares over all unknowns."""

    def test_radartrack(self, timed: Timed) -> None:
        r, azimuth, sites = common_targets()
        timed(rt.fusion.registration, r, azimuth, 30.0, 0.002, sites, items=1)

    def test_scipy(self, timed: Timed) -> None:
        r, azimuth, sites = common_targets()

        def residuals(unknown: Floats) -> Floats:
            bias, place = unknown[:6].reshape(3, 2, 1), unknown[6:].reshape(2, -1)
            x, y = place[:, np.newaxis] - sites.T[..., np.newaxis]
            return np.concatenate(
                [(r - np.hypot(x, y) - bias[:, 0]) / 30.0, (azimuth - np.arctan2(y, x) - bias[:, 1]) / 0.002]
            ).ravel()

        first = (sites[0] + r[0, :, np.newaxis] * np.stack([np.cos(azimuth[0]), np.sin(azimuth[0])], axis=-1)).T
        start = np.concatenate([np.zeros(6), first.ravel()])
        timed(lambda: optimize.least_squares(residuals, start, x_scale="jac"), items=1, rounds=1)


def common_targets() -> tuple[Floats, Floats, Floats]:
    generator = np.random.default_rng(3)
    sites = np.array([[0.0, 0.0], [60e3, 10e3], [20e3, 70e3]])
    offsets = generator.uniform(-10e3, 80e3, (1, FEW, 2)) - sites[:, np.newaxis]
    r = np.hypot(*np.moveaxis(offsets, -1, 0)) + 100.0 + 30.0 * generator.standard_normal((3, FEW))
    azimuth = np.arctan2(offsets[..., 1], offsets[..., 0]) + 0.003 + 0.002 * generator.standard_normal((3, FEW))
    return r, azimuth, sites


class TestNees:
    """Errors squared over their covariances."""

    def test_radartrack(self, timed: Timed) -> None:
        timed(rt.consistency.nees, states(), covariances(), states()[::-1], items=TRACKS)

    def test_by_hand(self, timed: Timed) -> None:
        def nees(mean: Floats, P: Floats, truth: Floats) -> Floats:
            error = mean - truth
            return np.asarray((error * np.linalg.solve(P, error[..., np.newaxis])[..., 0]).sum(axis=-1))

        timed(nees, states(), covariances(), states()[::-1], items=TRACKS)


class TestFixedGain:
    """An alpha-beta filter over 10 000 tracks of 100 scans; FilterPy's, update by update."""

    def test_radartrack(self, timed: Timed) -> None:
        tracker = rt.fixed_gain.alpha_beta(4.0, 50.0, 0.8)
        measured = np.random.default_rng(4).standard_normal((10_000, 100))
        timed(tracker.run, measured, np.zeros(2), items=measured.size)

    def test_filterpy(self, timed: Timed) -> None:
        alpha, beta = rt.fixed_gain.alpha_beta(4.0, 50.0, 0.8).gain * [1.0, 4.0]

        def track(measured: Floats) -> None:
            tracker = GHFilter(x=0.0, dx=0.0, dt=4.0, g=alpha, h=beta)
            for one in measured:
                tracker.update(one)

        timed(track, np.random.default_rng(4).standard_normal(2000), items=2000)


class TestSimulate:
    """A thousand trials of a thousand scans, beside the normal numbers alone."""

    def test_radartrack(self, timed: Timed) -> None:
        radar = simulate.Radar("spherical_doppler", period=0.1, noise=NOISE)
        target = simulate.Straight((50e3, 20e3, 5e3), (-100.0, 50.0, 0.0))
        timed(simulate.plots, target, radar, scans=1000, trials=1000, items=1000 * 1000)

    def test_normals(self, timed: Timed) -> None:
        timed(lambda: np.random.default_rng(0).standard_normal((1000, 1000, 4)), items=1000 * 1000)
