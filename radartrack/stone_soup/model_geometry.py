"""How a measurement model of Stone Soup looks at a state: through which of our sensors, from where, turned how."""

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any, Self

import numpy as np
from stonesoup.models.measurement import nonlinear

from radartrack._arrays.validation import RealArray
from radartrack._conversion.sensors import SENSORS, Sensor
from radartrack._observation.sights import SIGHTS, Kind, SightName

# What a model measures, in its order, of what one of our sensors does.
KINDS: Mapping[type, tuple[SightName, tuple[str, ...]]] = {
    nonlinear.Cartesian2DToBearing: ("bearing", ("azimuth",)),
    nonlinear.CartesianToBearingRange: ("polar", ("azimuth", "r")),
    nonlinear.CartesianToBearingRangeRate2D: ("polar_doppler", ("azimuth", "r", "range_rate")),
    nonlinear.CartesianToElevationBearing: ("spherical", ("elevation", "azimuth")),
    nonlinear.CartesianToElevationBearingRange: ("spherical", ("elevation", "azimuth", "r")),
    nonlinear.CartesianToBearingRangeRate: ("spherical_doppler", ("azimuth", "r", "range_rate")),
    nonlinear.CartesianToElevationBearingRangeRate: (
        "spherical_doppler",
        ("elevation", "azimuth", "r", "range_rate"),
    ),
}
TILTED = "rotation_offset must be about the z axis alone in the plane; got a tilt"
WITHOUT_RATE = {"polar_doppler": "polar", "spherical_doppler": "spherical"}


@dataclass(frozen=True)
class Geometry:
    """A model in our terms.

    Attributes:
        sight: which of our sensors.
        outputs: what is measured, in the order of the model.
        places: of the components of the state that the sensor takes: positions, then velocities.
        rotation: of positions about the sensor, to its own axes, shape (k, k).
        origin: of the sensor: its position and, where velocities are taken, its velocity.
    """

    sight: SightName
    outputs: tuple[str, ...]
    places: list[int]
    rotation: RealArray
    origin: RealArray

    @classmethod
    def of(cls, model: Any) -> Self:
        """The geometry of a model.

        Raises:
            TypeError: it is none of Stone Soup's that we have a sensor for.
            ValueError: a sensor in the plane is tilted out of it, and measures a range rate.

        """
        kind = next((KINDS[base] for base in type(model).__mro__ if base in KINDS), None)
        if kind is None:
            allowed = ", ".join(base.__name__ for base in KINDS)
            raise TypeError(f"the measurement model must be one of {allowed}; got {type(model).__name__}")
        sight, outputs = kind
        size = len(SIGHTS[sight].positions)
        places, origin = [*model.mapping[:size]], _flat(model.translation_offset)[:size]
        rotation = np.asarray(model.rotation_matrix, dtype=np.float64)[:size, :size]
        if len(SIGHTS[sight].state) > size:
            if size < 3 and _tilted(model):
                raise ValueError(TILTED)
            places, origin = [*places, *model.velocity_mapping], np.concatenate([origin, _flat(model.velocity)])
        return cls(sight, outputs, places, rotation, origin)

    @property
    def axes(self) -> int:
        """How many coordinates a position has."""
        return len(self.rotation)

    @property
    def sensor(self) -> Sensor | None:
        """The conversion that takes all that is measured; None where it takes more."""
        sensor = next((one for name, one in SENSORS.items() if name == self.sight), None)
        return sensor if sensor is not None and set(sensor.coordinates) == set(self.outputs) else None

    @property
    def back(self) -> RealArray:
        """From positions in the axes of the sensor to those of the state, about the sensor.

        Raises:
            ValueError: a sensor in the plane is tilted out of it, which leaves no inverse.

        """
        inverse = np.asarray(self.rotation.T)
        if not np.allclose(inverse @ self.rotation, np.eye(self.axes)):
            raise ValueError(TILTED)
        return inverse

    @cached_property
    def turn(self) -> RealArray:
        """From components of the state, about the sensor, to those in its axes."""
        size, axes = len(self.places), self.axes
        turn = np.zeros((size, size))
        for first in range(0, size, axes):
            turn[first : first + axes, first : first + axes] = self.rotation
        return turn

    def measurement(self, state_vector: Any) -> RealArray:
        """What is measured of a state, shape (m,)."""
        return self._evaluated("map", _flat(state_vector))

    def jacobian(self, state_vector: Any) -> RealArray:
        """Its first derivatives by all components of the state, shape (m, n); 0 where there are none."""
        vector = _flat(state_vector)
        derivatives = self._evaluated("jacobian", vector)
        full = np.zeros((len(derivatives), len(vector)))
        full[:, self.places] = derivatives @ self.turn
        return full

    def hessian(self, state_vector: Any) -> RealArray:
        """Its second derivatives by all components of the state, shape (m, n, n); 0 where there are none."""
        vector = _flat(state_vector)
        derivatives = self._evaluated("hessian", vector)
        full = np.zeros((len(derivatives), len(vector), len(vector)))
        full[np.ix_(range(len(full)), self.places, self.places)] = self.turn.T @ derivatives @ self.turn
        return full

    def _evaluated(self, kind: Kind, vector: RealArray) -> RealArray:
        """By the components in the axes of the sensor, which counts azimuths from its x axis."""
        sight = SIGHTS[self.sight]
        places = sight.order("x")
        local = self.turn @ (vector[self.places] - self.origin) + 0.0  # -0.0 would turn an azimuth of pi into -pi
        components = [local[place] for place in places]
        rows = [sight.outputs.index(name) for name in self.outputs]
        if kind == "map":
            return sight.evaluate(kind, components, {})[rows]
        found = sight.evaluate(kind, sight.off_poles(components, {}), {})[rows]
        return found[:, places] if kind == "jacobian" else found[:, places][:, :, places]


def _flat(vector: Any) -> RealArray:
    return np.asarray(vector, dtype=np.float64).reshape(-1)


def _tilted(model: Any) -> bool:
    return bool(np.any(_flat(model.rotation_offset)[:2] != 0))
