"""A million plots at once: beside a fused loop, FilterPy's unscented transform and Stone Soup."""

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from filterpy.kalman import MerweScaledSigmaPoints, unscented_transform

from benchmarks.conftest import PLOTS, Floats
from benchmarks.fused_loop import fused_loop
from benchmarks.stone_soup import stone_soup_plot
from radartrack import convert
from radartrack._arrays import batches, machine_code

POLAR = ("r", "azimuth", "range_std", "azimuth_std")
SPHERICAL = ("r", "azimuth", "elevation", "range_std", "azimuth_std", "elevation_std")
SPHERICAL_DOPPLER = (*SPHERICAL[:3], "range_rate", *SPHERICAL[3:], "range_rate_std")
FEW = 300
Timed = Callable[..., Any]


@pytest.mark.parametrize("method", ["averaged", "unbiased"])
class TestPolar:
    """convert.polar with deviations of each plot."""

    def test_numpy(self, timed: Timed, plots: dict[str, Floats], method: str, monkeypatch: pytest.MonkeyPatch) -> None:
        monkeypatch.setattr(machine_code, "is_available", lambda: False)
        timed(convert.polar, *(plots[n] for n in POLAR), method=method, items=PLOTS)

    def test_fast(self, timed: Timed, plots: dict[str, Floats], method: str) -> None:
        timed(convert.polar, *(plots[n] for n in POLAR), method=method, items=PLOTS, rounds=60)

    def test_fast_on_one_core(
        self, timed: Timed, plots: dict[str, Floats], method: str, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        monkeypatch.setattr(batches, "_most_at_once", lambda: 1)
        timed(convert.polar, *(plots[n] for n in POLAR), method=method, items=PLOTS, rounds=60)

    def test_fused(self, timed: Timed, plots: dict[str, Floats], method: str) -> None:
        arrays = [*(plots[n] for n in POLAR), np.zeros(PLOTS)]
        timed(fused_loop(f"polar_{method}", 2), *arrays, items=PLOTS, rounds=60)


class TestCopied:
    """Memory's own limit: arguments are copied, results filled with a number, on one core."""

    def test_polar(self, timed: Timed, plots: dict[str, Floats]) -> None:
        timed(copied, [plots[n] for n in POLAR], 2, items=PLOTS, rounds=60)

    def test_spherical(self, timed: Timed, plots: dict[str, Floats]) -> None:
        timed(copied, [plots[n] for n in SPHERICAL], 3, items=PLOTS, rounds=20)


class TestPolarPeers:
    """Plot by plot; they know no methods."""

    def test_filterpy(self, timed: Timed, plots: dict[str, Floats]) -> None:
        timed(unscented, *(plots[n][:FEW] for n in POLAR), items=FEW)

    def test_stone_soup(self, timed: Timed, plots: dict[str, Floats]) -> None:
        timed(by_stone_soup, *(plots[n][:FEW] for n in POLAR), items=FEW)


class TestSpherical:
    """convert.spherical with deviations of each plot."""

    def test_numpy(self, timed: Timed, plots: dict[str, Floats], monkeypatch: pytest.MonkeyPatch) -> None:
        monkeypatch.setattr(machine_code, "is_available", lambda: False)
        timed(convert.spherical, *(plots[n] for n in SPHERICAL), items=PLOTS, rounds=20)

    def test_fast(self, timed: Timed, plots: dict[str, Floats]) -> None:
        timed(convert.spherical, *(plots[n] for n in SPHERICAL), items=PLOTS, rounds=20)

    def test_fast_on_one_core(self, timed: Timed, plots: dict[str, Floats], monkeypatch: pytest.MonkeyPatch) -> None:
        monkeypatch.setattr(batches, "_most_at_once", lambda: 1)
        timed(convert.spherical, *(plots[n] for n in SPHERICAL), items=PLOTS, rounds=20)

    def test_fused(self, timed: Timed, plots: dict[str, Floats]) -> None:
        arrays = [*(plots[n] for n in SPHERICAL), np.zeros(PLOTS)]
        timed(fused_loop("spherical_unbiased", 3), *arrays, items=PLOTS, rounds=20)


class TestSphericalDoppler:
    """convert.spherical_doppler with deviations of each plot."""

    def test_numpy(self, timed: Timed, plots: dict[str, Floats], monkeypatch: pytest.MonkeyPatch) -> None:
        monkeypatch.setattr(machine_code, "is_available", lambda: False)
        timed(convert.spherical_doppler, *(plots[n] for n in SPHERICAL_DOPPLER), items=PLOTS, rounds=10)

    def test_fast(self, timed: Timed, plots: dict[str, Floats]) -> None:
        timed(convert.spherical_doppler, *(plots[n] for n in SPHERICAL_DOPPLER), items=PLOTS, rounds=10)

    def test_fused(self, timed: Timed, plots: dict[str, Floats]) -> None:
        arrays = [*(plots[n] for n in SPHERICAL_DOPPLER), np.zeros(PLOTS)]
        timed(fused_loop("spherical_doppler_unbiased", 4), *arrays, items=PLOTS, rounds=10)


class TestOnePlot:
    """A live tracker's call."""

    def test_numpy(self, timed: Timed) -> None:
        timed(repeated, lambda: convert.polar(5e4, 0.3, 50.0, 0.01), items=FEW)

    def test_stone_soup(self, timed: Timed) -> None:
        timed(repeated, lambda: stone_soup_plot(5e4, 0.3, 50.0, 0.01), items=FEW)


def copied(arrays: list[Floats], size: int) -> tuple[list[Floats], Floats, Floats]:
    mean, covariance = np.full((PLOTS, size), 1.0), np.full((PLOTS, size, size), 1.0)
    return [array.copy() for array in arrays], mean, covariance


def repeated(call: Callable[[], Any]) -> None:
    for _ in range(FEW):
        call()


def to_cartesian(point: Floats) -> Floats:
    return np.array([point[0] * np.cos(point[1]), point[0] * np.sin(point[1])])


def unscented(ranges: Floats, azimuths: Floats, range_stds: Floats, azimuth_stds: Floats) -> None:
    points = MerweScaledSigmaPoints(2, alpha=0.1, beta=2.0, kappa=1.0)
    for plot in zip(ranges, azimuths, range_stds, azimuth_stds, strict=True):
        sigmas = points.sigma_points(np.array(plot[:2]), np.diag(np.square(plot[2:])))
        unscented_transform(np.array([to_cartesian(sigma) for sigma in sigmas]), points.Wm, points.Wc)


def by_stone_soup(*arrays: Floats) -> None:
    for plot in zip(*arrays, strict=True):
        stone_soup_plot(*plot)
