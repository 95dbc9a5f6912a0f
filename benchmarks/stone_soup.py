"""What Stone Soup does: a plot by inverse function and Jacobian, and the extended update."""

import numpy as np
from numpy.typing import NDArray
from stonesoup.models.measurement.nonlinear import CartesianToBearingRange, CartesianToElevationBearingRange
from stonesoup.types.detection import Detection
from stonesoup.types.hypothesis import SingleHypothesis
from stonesoup.types.prediction import GaussianStatePrediction
from stonesoup.types.state import State
from stonesoup.updater.kalman import ExtendedKalmanUpdater

Floats = NDArray[np.float64]


def stone_soup_plot(r: float, azimuth: float, range_std: float, azimuth_std: float) -> tuple[Floats, Floats]:
    """Position, and its covariance from the inverse of the Jacobian there."""
    noise = np.diag([azimuth_std**2, range_std**2])
    model = CartesianToBearingRange(ndim_state=2, mapping=(0, 1), noise_covar=noise)
    mean = model.inverse_function(Detection(np.array([[azimuth], [r]]), measurement_model=model))
    inverse = np.linalg.inv(model.jacobian(State(mean)))
    return mean, inverse @ noise @ inverse.T


def updated_by_stone_soup(means: Floats, covariances: Floats, measured: Floats, noise: Floats) -> None:
    """Tracks (x, y, z, vx, vy, vz), each updated with range, azimuth and elevation; its bearing is from the x axis."""
    model = CartesianToElevationBearingRange(ndim_state=6, mapping=(0, 1, 2), noise_covar=noise[::-1, ::-1])
    updater = ExtendedKalmanUpdater(model)
    for mean, covariance, (r, azimuth, elevation) in zip(means, covariances, measured, strict=True):
        plot = Detection(np.array([[elevation], [np.pi / 2 - azimuth], [r]]), measurement_model=model)
        updater.update(SingleHypothesis(GaussianStatePrediction(mean[:, np.newaxis], covariance), plot))
