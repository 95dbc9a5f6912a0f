"""Stone Soup's models at generic places, turned, shifted and moving, and targets before them."""

import datetime as dt
from typing import Any

import numpy as np
from stonesoup.types.array import CovarianceMatrix, StateVector
from stonesoup.types.detection import Detection
from stonesoup.types.state import State

TIME = dt.datetime(2026, 1, 1, tzinfo=dt.UTC)
SHIFT, MOTION = np.array([[300.0], [-200.0], [40.0]]), np.array([[30.0], [-8.0], [3.0]])
TILTED, TURNED = np.array([[0.2], [-0.3], [0.7]]), np.array([[0.0], [0.0], [0.7]])
PLANE = {"ndim_state": 4, "mapping": (0, 2)}
SPACE = {"ndim_state": 6, "mapping": (0, 2, 4)}
IN_PLANE = {"translation_offset": StateVector(SHIFT[:2]), "rotation_offset": StateVector(TURNED)}
IN_SPACE = {"translation_offset": StateVector(SHIFT), "rotation_offset": StateVector(TILTED)}
MOVING_IN_PLANE = {"velocity_mapping": (1, 3), "velocity": StateVector(MOTION[:2])}
MOVING_IN_SPACE = {"velocity_mapping": (1, 3, 5), "velocity": StateVector(MOTION)}


def noise(*deviations: float) -> CovarianceMatrix:
    return CovarianceMatrix(np.diag(np.square(deviations)))


def detections(model: Any, states: Any, seed: int) -> list[Detection]:
    """Plots of states, one a row, with the errors of the model."""
    generator = np.random.default_rng(seed)
    root = np.linalg.cholesky(np.asarray(model.covar(), dtype=float))
    found = []
    for state in states:
        exact = model.function(State(StateVector(state)), noise=False)
        error = root @ generator.standard_normal((len(root), 1))
        found.append(Detection(exact + error, timestamp=TIME, measurement_model=model))
    return found


def nees(mean: Any, covariance: Any, truth: Any, places: Any) -> float:
    """The normalised error squared of some components, over their number."""
    error = (np.asarray(mean, dtype=float).reshape(-1) - truth)[places]
    own = np.asarray(covariance, dtype=float)[np.ix_(places, places)]
    return float(error @ np.linalg.solve(own, error)) / len(error)
