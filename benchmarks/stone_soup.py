"""A plot to Cartesian coordinates as Stone Soup's initiators do it: inverse function and Jacobian."""

import numpy as np
from numpy.typing import NDArray
from stonesoup.models.measurement.nonlinear import CartesianToBearingRange
from stonesoup.types.detection import Detection
from stonesoup.types.state import State

Floats = NDArray[np.float64]


def stone_soup_plot(r: float, azimuth: float, range_std: float, azimuth_std: float) -> tuple[Floats, Floats]:
    """Position, and its covariance from the inverse of the Jacobian there."""
    noise = np.diag([azimuth_std**2, range_std**2])
    model = CartesianToBearingRange(ndim_state=2, mapping=(0, 1), noise_covar=noise)
    mean = model.inverse_function(Detection(np.array([[azimuth], [r]]), measurement_model=model))
    inverse = np.linalg.inv(model.jacobian(State(mean)))
    return mean, inverse @ noise @ inverse.T
