"""Stone Soup's measurement models with exact first and second derivatives, and inverse functions of many plots.

Each is a subclass of Stone Soup's own, with its arguments: offset, rotation and velocity of the sensor count as there.
"""

from typing import Any

import numpy as np
from stonesoup.models.base import ReversibleModel
from stonesoup.models.measurement import nonlinear
from stonesoup.types.array import StateVector, StateVectors

from radartrack._arrays.validation import RealArray
from radartrack._conversion.sensors import SENSORS
from radartrack.stone_soup.model_geometry import WITHOUT_RATE, Geometry


class Exact:
    """Derivatives by formula, where Stone Soup takes differences."""

    def jacobian(self, state: Any, **_: Any) -> RealArray:
        """The first derivatives at a state, shape (measured, components of the state).

        Where the sensor is, and on the vertical axis for bearing and elevation, what does not exist is 0.

        Source: Bar-Shalom, Willett & Tian 2011, extended Kalman filter.
        """
        return Geometry.of(self).jacobian(state.state_vector)

    def hessian(self, state: Any, **_: Any) -> RealArray:
        """The second derivatives at a state, shape (measured, components, components).

        Source: Bar-Shalom, Willett & Tian 2011, second-order extended Kalman filter.
        """
        return Geometry.of(self).hessian(state.state_vector)


class Reversible(Exact):
    """Inverse functions of one plot, or of many at once."""

    ndim_state: int

    def inverse_function(self, detection: Any, **_: Any) -> Any:
        """The states that plots are of, shape (components, plots); of a velocity what the range rate says of it.

        Raises:
            ValueError: a range is negative, an elevation beyond the vertical, a number not finite, or a sensor in the
                plane is tilted out of it.
        """
        geometry = Geometry.of(self)
        rows = np.asarray(detection.state_vector, dtype=np.float64)
        plot = dict(zip(geometry.outputs, rows, strict=True))
        turned = geometry.back
        sensor = SENSORS[WITHOUT_RATE.get(geometry.sight, geometry.sight)]  # type: ignore[index]
        measured = np.stack([plot[name] for name in sensor.coordinates], axis=-1)
        states = np.zeros((self.ndim_state, rows.shape[1]))
        axes, origin = geometry.axes, geometry.origin[:, np.newaxis]
        states[geometry.places[:axes]] = turned @ sensor.cartesian(measured, {}, "x").T + origin[:axes]
        if "range_rate" in plot:
            along = measured.copy()
            along[:, [*sensor.coordinates].index("r")] = plot["range_rate"]
            states[geometry.places[axes:]] = turned @ sensor.cartesian(along, {}, "x").T + origin[axes:]
        return states.view(StateVector if states.shape[1] == 1 else StateVectors)


class ExactBearing2D(Exact, nonlinear.Cartesian2DToBearing):
    """`Cartesian2DToBearing`, exact."""


class ExactBearingRange(Reversible, nonlinear.CartesianToBearingRange):
    """`CartesianToBearingRange`, exact."""


class ExactElevationBearing(Exact, nonlinear.CartesianToElevationBearing):
    """`CartesianToElevationBearing`, exact."""


class ExactElevationBearingRange(Reversible, nonlinear.CartesianToElevationBearingRange):
    """`CartesianToElevationBearingRange`, exact."""


class ExactBearingRangeRate(Exact, nonlinear.CartesianToBearingRangeRate):
    """`CartesianToBearingRangeRate`, exact: in space, without an elevation, which no inverse function replaces."""


class ExactBearingRangeRate2D(Reversible, nonlinear.CartesianToBearingRangeRate2D, ReversibleModel):
    """`CartesianToBearingRangeRate2D`, exact, and with an inverse function, which Stone Soup's has not."""


class ExactElevationBearingRangeRate(Reversible, nonlinear.CartesianToElevationBearingRangeRate):
    """`CartesianToElevationBearingRangeRate`, exact."""
