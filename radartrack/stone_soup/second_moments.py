"""The first two moments of what a model measures of a Gaussian state, to the second order of the measurement."""

from typing import Any, NamedTuple

import numpy as np
from stonesoup.models.base import LinearModel
from stonesoup.types.state import State

from radartrack._arrays.validation import RealArray
from radartrack._filtering.extended import curvature_of
from radartrack.stone_soup.model_geometry import Geometry


class Moments(NamedTuple):
    """With G the Hessian and P the covariance of the state.

    Attributes:
        shift: tr(G P)/2, which the mean has beside the measurement of the mean, shape (m,).
        jacobian: J, shape (m, n).
        spread: tr(G_a P G_b P)/2, which the covariance has beside J P J', shape (m, m).
    """

    shift: RealArray
    jacobian: RealArray
    spread: RealArray


def moments(model: Any, mean: Any, covariance: Any) -> Moments:
    """Of a state with this mean and covariance.

    Raises:
        TypeError: the model has no second derivatives that we know.

    Source: Bar-Shalom, Willett & Tian 2011, second-order extended Kalman filter.

    """
    jacobian, hessian = _derivatives(model, mean)
    shift, spread = curvature_of(hessian[np.newaxis], np.asarray(covariance, dtype=np.float64)[..., np.newaxis])
    return Moments(shift[:, 0], jacobian, spread[..., 0])


def _derivatives(model: Any, mean: Any) -> tuple[RealArray, RealArray]:
    if isinstance(model, LinearModel):
        matrix = np.asarray(model.matrix(), dtype=np.float64)
        return matrix, np.zeros((*matrix.shape, matrix.shape[1]))
    if hasattr(model, "hessian") and not hasattr(model, "rotation_matrix"):
        return model.jacobian(State(mean)), model.hessian(State(mean))
    geometry = Geometry.of(model)
    return geometry.jacobian(mean), geometry.hessian(mean)
