"""Straight flights with the small wobble of real ones, as tests want them."""

import csv
from pathlib import Path
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

EARTH = 6_371_000.0
LOG = Path(__file__).parents[3] / "shared" / "data" / "UAV_Rot.csv"
LENGTH = 85


class Flight(NamedTuple):
    """Where it is from, times [s], and x and y [m] in a plane that touches the Earth near the flight."""

    source: str
    t: NDArray[np.float64]
    x: NDArray[np.float64]
    y: NDArray[np.float64]


def great_circle() -> Flight:
    """An airliner at constant speed on a great circle, its position wobbling by some metres, seen in a plane."""
    t = np.arange(0.0, 400.0, 4.0)
    along = 230.0 * (t - t.mean()) / EARTH
    course = np.radians(62.0)
    latitude = (
        np.radians(50.0) + along * np.cos(course) - 0.5 * along**2 * np.sin(course) ** 2 * np.tan(np.radians(50.0))
    )
    longitude = along * np.sin(course) / np.cos(latitude)
    wobble = np.random.default_rng(5).normal(size=(2, t.size)).cumsum(axis=1)
    east = EARTH * np.cos(latitude) * np.sin(longitude)
    north = EARTH * (
        np.sin(latitude) * np.cos(np.radians(50.0)) - np.cos(latitude) * np.sin(np.radians(50.0)) * np.cos(longitude)
    )
    return Flight("simulated airliner on a great circle", t, east + 0.3 * wobble[0], north + 0.3 * wobble[1])


def logged() -> Flight:
    """The straightest stretch of a GPS log of a small aircraft."""
    with LOG.open() as file:
        rows = list(csv.DictReader(file))
    t, latitude, longitude = (
        np.array([float(row[name]) for row in rows]) for name in ("timestamp", "latitude", "longitude")
    )
    x = np.radians(longitude - longitude[0]) * EARTH * np.cos(np.radians(latitude[0]))
    y = np.radians(latitude - latitude[0]) * EARTH
    windows = [slice(start, start + LENGTH) for start in range(len(t) - LENGTH)]
    flying = [w for w in windows if np.hypot(x[w][-1] - x[w][0], y[w][-1] - y[w][0]) > 8.0 * LENGTH]
    best = min(flying, key=lambda w: wobble(t[w], x[w], y[w]))
    return Flight(f"GPS log {LOG.name}", t[best], x[best], y[best])


def wobble(t: NDArray[np.float64], x: NDArray[np.float64], y: NDArray[np.float64]) -> float:
    """Root mean square distance from straight motion [m]."""
    left = [values - np.polyval(np.polyfit(t - t[0], values, 1), t - t[0]) for values in (x, y)]
    return float(np.sqrt(np.mean(left[0] ** 2 + left[1] ** 2)))


def flights() -> list[Flight]:
    """The simulated flight always, and the logged one where the log is there; where it is not, the name says so."""
    if LOG.exists():
        return [great_circle(), logged()]
    simulated = great_circle()
    return [simulated._replace(source=f"{simulated.source} alone ({LOG.name} is not there)")]
