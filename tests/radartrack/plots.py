"""A plot and a prediction of it for each sensor, with large and correlated errors, and strategies for more."""

from collections.abc import Callable, Mapping, Sequence
from typing import Any, get_args

import numpy as np
import numpy.typing as npt
from hypothesis import strategies as st

from radartrack import convert as conversions
from radartrack.convert import Converted, Method
from radartrack.testing import strategies
from tests import maps

Floats = npt.NDArray[np.floating[Any]]
Plot = dict[str, Any]

METHODS: tuple[Method, ...] = get_args(Method)
OF_THE_PLOT = [method for method in METHODS if method != "decorrelated"]
SENSORS = ("polar", "spherical", "polar_doppler", "spherical_doppler", "ruv")
WITH_AZIMUTH = SENSORS[:4]
CLOSED = WITH_AZIMUTH
CORRELATED = {"polar": (0, 1), "spherical": (0, 1), "polar_doppler": (0, 2), "spherical_doppler": (0, 3), "ruv": (1, 2)}

ANGLES = {"azimuth": 2.3, "range_std": 40.0, "azimuth_std": 0.3, "correlation": -0.6}
PLOTS: Mapping[str, Plot] = {
    "polar": {"r": 900.0} | ANGLES,
    "spherical": {"r": 900.0, "elevation": -0.4, "elevation_std": 0.15} | ANGLES,
    "polar_doppler": {"r": 900.0, "range_rate": -80.0, "range_rate_std": 15.0} | ANGLES,
    "spherical_doppler": {"r": 900.0, "elevation": -0.4, "range_rate": -80.0}
    | {"elevation_std": 0.15, "range_rate_std": 15.0}
    | ANGLES,
    "ruv": {"r": 900.0, "u": 0.3, "v": -0.4, "range_std": 9.0, "u_std": 0.01, "v_std": 0.02, "correlation": -0.6},
}
COORDINATES: Mapping[str, Sequence[str]] = {
    "polar": ("r", "azimuth"),
    "spherical": ("r", "azimuth", "elevation"),
    "polar_doppler": ("r", "azimuth", "range_rate"),
    "spherical_doppler": ("r", "azimuth", "elevation", "range_rate"),
    "ruv": ("r", "u", "v"),
}
DEVIATIONS: Mapping[str, Sequence[str]] = {
    "polar": ("range_std", "azimuth_std"),
    "spherical": ("range_std", "azimuth_std", "elevation_std"),
    "polar_doppler": ("range_std", "azimuth_std", "range_rate_std"),
    "spherical_doppler": ("range_std", "azimuth_std", "elevation_std", "range_rate_std"),
    "ruv": ("range_std", "u_std", "v_std"),
}
CORRELATIONS = np.array([[1.0, 0.25, -0.5, 0.2], [0.25, 1.0, 0.4, -0.3], [-0.5, 0.4, 1.0, 0.3], [0.2, -0.3, 0.3, 1.0]])
"""Of predictions: all quantities with all others, as a track has them."""

PREDICTED_DEVIATIONS = {
    "polar": [40.0, 0.2],
    "spherical": [40.0, 0.2, 0.1],
    "polar_doppler": [40.0, 0.2, 8.0],
    "spherical_doppler": [40.0, 0.2, 0.1, 8.0],
    "ruv": [20.0, 0.02, 0.01],
}
STEP = {"polar": [-50.0, -0.1], "spherical": [-50.0, -0.1, 0.1], "polar_doppler": [-50.0, -0.1, 9.0]}
STEP["spherical_doppler"] = [-50.0, -0.1, 0.1, 9.0]
STEP["ruv"] = [-50.0, -0.05, 0.05]


def function(sensor: str) -> Callable[..., Converted]:
    """The conversion under test."""
    found: Callable[..., Converted] = getattr(conversions, sensor)
    return found


def size(sensor: str) -> int:
    return len(COORDINATES[sensor])


def centre(sensor: str, plot: Plot) -> Floats:
    """The measured quantities along a last axis."""
    return np.stack(np.broadcast_arrays(*(plot[name] for name in COORDINATES[sensor])), axis=-1)


def noise(sensor: str, plot: Plot) -> Plot:
    return {name: plot[name] for name in (*DEVIATIONS[sensor], "correlation")}


def noise_covariance(sensor: str, plot: Plot) -> Floats:
    deviations = np.array([plot[name] for name in DEVIATIONS[sensor]])
    matrix = np.diag(deviations**2)
    i, j = CORRELATED[sensor]
    matrix[i, j] = matrix[j, i] = plot["correlation"] * deviations[i] * deviations[j]
    return matrix


def prediction(sensor: str) -> tuple[Floats, Floats]:
    deviations = np.array(PREDICTED_DEVIATIONS[sensor])
    correlations = CORRELATIONS[: len(deviations), : len(deviations)]
    return centre(sensor, PLOTS[sensor]) + STEP[sensor], correlations * np.outer(deviations, deviations)


def convert(sensor: str, method: Method, **arguments: Any) -> Converted:
    """The sensor's plot, with some arguments replaced."""
    if method == "decorrelated":
        arguments = {"predicted": prediction(sensor)} | arguments
    return function(sensor)(**{**PLOTS[sensor], **arguments}, method=method)


def cartesian(sensor: str, coordinates: Floats) -> Floats:
    """The map, written down by hand."""
    return np.stack(maps.MAPS[sensor](np, *np.moveaxis(coordinates, -1, 0)), axis=-1)


# Every r is more than 15 deviations from zero, so that quadrature stays within ranges that can be measured.
_SPREAD = {
    "r": (1e3, 1e4),
    "azimuth": (-7.0, 7.0),
    "elevation": (-0.5, 0.5),
    "range_rate": (-300.0, 300.0),
    "u": (-0.6, 0.6),
    "v": (-0.6, 0.6),
    "range_std": (1.0, 60.0),
    "azimuth_std": (1e-3, 0.4),
    "elevation_std": (1e-3, 0.085),  # and correlated predictions and errors within 90 degrees
    "range_rate_std": (0.1, 40.0),
    "u_std": (1e-3, 5e-3),
    "v_std": (1e-3, 5e-3),
    "correlation": (-0.95, 0.95),
}


def plots(sensor: Any) -> st.SearchStrategy[Plot]:
    return strategies.plots(sensor, within={name: _SPREAD[name] for name in PLOTS[sensor]})


def assert_agree(got: Floats, expected: Floats, scale: Any, tolerance: float) -> None:
    assert (np.abs(got - expected) <= tolerance * scale).all()


def assert_covariances_agree(got: Floats, expected: Floats, tolerance: float) -> None:
    deviations = np.sqrt(np.diagonal(expected, axis1=-2, axis2=-1))
    scale = deviations[..., :, np.newaxis] * deviations[..., np.newaxis, :]
    assert_agree(got, expected, scale, tolerance)
