"""Geodetic coordinates of a million positions, beside PROJ and pymap3d."""

from collections.abc import Callable
from typing import Any

import numpy as np
import pymap3d
import pyproj

import radartrack as rt
from benchmarks.conftest import Floats

POSITIONS = 1_000_000
Timed = Callable[..., Any]


def positions() -> Floats:
    """From the ground to 500 km above it."""
    generator = np.random.default_rng(6)
    places = generator.standard_normal((POSITIONS, 3))
    radius = generator.uniform(6.4e6, 6.9e6, (POSITIONS, 1))
    return np.asarray(radius * places / np.linalg.norm(places, axis=-1, keepdims=True))


class TestGeodetic:
    """Latitude, longitude and height from positions."""

    def test_radartrack(self, timed: Timed) -> None:
        timed(rt.frames.geodetic_from_ecef, positions(), items=POSITIONS)

    def test_proj(self, timed: Timed) -> None:
        to_geodetic = pyproj.Transformer.from_crs(4978, 4979, always_xy=True)
        timed(to_geodetic.transform, *positions().T.copy(), items=POSITIONS)

    def test_pymap3d(self, timed: Timed) -> None:
        timed(pymap3d.ecef2geodetic, *positions().T.copy(), items=POSITIONS)


class TestEcef:
    """And back."""

    def test_radartrack(self, timed: Timed) -> None:
        timed(rt.frames.ecef_from_geodetic, *rt.frames.geodetic_from_ecef(positions()), items=POSITIONS)

    def test_proj(self, timed: Timed) -> None:
        latitude, longitude, height = rt.frames.geodetic_from_ecef(positions())
        to_ecef = pyproj.Transformer.from_crs(4979, 4978, always_xy=True)
        timed(to_ecef.transform, np.degrees(longitude), np.degrees(latitude), height, items=POSITIONS)

    def test_pymap3d(self, timed: Timed) -> None:
        latitude, longitude, height = rt.frames.geodetic_from_ecef(positions())
        timed(pymap3d.geodetic2ecef, latitude, longitude, height, deg=False, items=POSITIONS)
