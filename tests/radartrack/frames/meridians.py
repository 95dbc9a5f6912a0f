"""Geodetic coordinates in fifty digits, by their definition: a foot on the ellipsoid, and a height along the normal."""

from typing import Any

import mpmath
import numpy as np

from radartrack.frames import WGS84

mp = mpmath.mp.clone()
mp.dps = 50
A, F = mp.mpf(WGS84.semi_major_axis), mp.mpf(WGS84.flattening)
B = A * (1 - F)


def position(latitude: Any, longitude: Any, height: Any) -> list[Any]:
    """Of the foot by the angle of the ellipse's circles, then along the gradient."""
    latitude, longitude, height = map(mp.mpf, (latitude, longitude, height))
    parametric = mp.atan2(B * mp.sin(latitude), A * mp.cos(latitude))
    out, up = A * mp.cos(parametric), B * mp.sin(parametric)
    gradient = mp.mpc(out / A**2, up / B**2)
    normal = gradient / abs(gradient)
    out, up = out + height * normal.real, up + height * normal.imag
    return [out * mp.cos(longitude), out * mp.sin(longitude), up]


def error(found: np.ndarray, expected: list[Any]) -> float:
    """The distance of a position in float64 from one in many digits."""
    return float(mp.norm([mp.mpf(float(a)) - b for a, b in zip(found, expected, strict=True)]))


def jacobian(latitude: float, longitude: float, height: float) -> np.ndarray:
    """By central differences that leave thirty digits."""
    point, step = [mp.mpf(value) for value in (latitude, longitude, height)], mp.mpf(10) ** -15
    columns = []
    for place in range(3):
        ends = [position(*(c + sign * step * (m == place) for m, c in enumerate(point))) for sign in (1, -1)]
        columns.append([float((a - b) / (2 * step)) for a, b in zip(*ends, strict=True)])
    return np.array(columns).T
