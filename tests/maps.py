"""The measurement models written down by hand, in no words of the derivations: what their tests compare with.

`m` is `numpy` or `mpmath`; the arguments after it are the measured quantities in their order.
"""

import inspect
from collections.abc import Callable, Mapping, Sequence
from types import ModuleType
from typing import Any

import numpy as np

Point = Mapping[str, Any]


def polar(m: Any, r: Any, beta: Any) -> list[Any]:
    return [r * m.cos(beta), r * m.sin(beta)]


def polar_doppler(m: Any, r: Any, beta: Any, rdot: Any) -> list[Any]:
    return [r * m.cos(beta), r * m.sin(beta), r * rdot]


def spherical_doppler(m: Any, r: Any, beta: Any, epsilon: Any, rdot: Any) -> list[Any]:
    return [*spherical(m, r, beta, epsilon), r * rdot]


def spherical(m: Any, r: Any, beta: Any, epsilon: Any) -> list[Any]:
    return [r * m.cos(epsilon) * m.sin(beta), r * m.cos(epsilon) * m.cos(beta), r * m.sin(epsilon)]


def ruv(m: Any, r: Any, u: Any, v: Any) -> list[Any]:
    return [r * u, r * v, r * m.sqrt(1 - u * u - v * v)]


MAPS: dict[str, Callable[..., list[Any]]] = {
    f.__name__: f for f in (polar, polar_doppler, ruv, spherical, spherical_doppler)
}
CORRELATED = {"polar": ("r", "beta"), "polar_doppler": ("r", "rdot"), "ruv": ("u", "v"), "spherical": ("r", "beta")}
CORRELATED["spherical_doppler"] = ("r", "rdot")


def rotated(angle: float, x: int, y: int, size: int) -> np.ndarray:
    """The matrix that turns coordinate x towards coordinate y."""
    matrix = np.eye(size)
    matrix[np.ix_([x, y], [x, y])] = [[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]]
    return matrix


ROTATIONS: dict[str, Callable[[float], np.ndarray]] = {
    "polar": lambda angle: rotated(angle, 0, 1, 2),
    "polar_doppler": lambda angle: rotated(angle, 0, 1, 3),
    "spherical": lambda angle: rotated(angle, 1, 0, 3),
    "spherical_doppler": lambda angle: rotated(angle, 1, 0, 4),
}
"""What adding an angle to the azimuth does to the coordinates."""

REFLECTIONS: dict[str, Sequence[tuple[str, Sequence[float]]]] = {
    "polar": [("beta", (1, -1))],
    "polar_doppler": [("beta", (1, -1, 1)), ("rdot", (1, 1, -1))],
    "ruv": [("u", (-1, 1, 1)), ("v", (1, -1, 1))],
    "spherical": [("beta", (-1, 1, 1)), ("epsilon", (1, 1, -1))],
    "spherical_doppler": [("beta", (-1, 1, 1, 1)), ("epsilon", (1, 1, -1, 1)), ("rdot", (1, 1, 1, -1))],
}
"""Measured quantities whose sign can be turned, and what that does to the coordinates."""


def measured(model: str) -> list[str]:
    """The names of the measured quantities."""
    return list(inspect.signature(MAPS[model]).parameters)[1:]


def evaluated(model: str, m: ModuleType, point: Point) -> list[Any]:
    """The coordinates of a point, which may hold other symbols too."""
    return MAPS[model](m, *(point[name] for name in measured(model)))


def position(model: str, point: Point) -> np.ndarray:
    """The coordinates of points of any shape, along a new last axis."""
    return np.stack(np.broadcast_arrays(*evaluated(model, np, point)), axis=-1)


def covariance(model: str, point: Point, prefix: str = "") -> np.ndarray:
    """K of the measurement's error, or of what a prefix says, such as `predicted_`."""
    names = measured(model)
    deviations = np.array([float(point[f"{prefix}sigma_{name}"]) for name in names])
    correlation = np.eye(len(names))
    first, second = map(names.index, CORRELATED[model])
    correlation[first, second] = correlation[second, first] = float(point[f"{prefix}rho"])
    return correlation * np.outer(deviations, deviations)
