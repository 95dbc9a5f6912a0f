"""How a measurement model of Stone Soup looks at a state: through which of our sensors, from where, turned how."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any, Self

import numpy as np
from stonesoup.models.measurement import nonlinear

from radartrack import observe
from radartrack._arrays.validation import RealArray
from radartrack._conversion.sensors import SENSORS, Sensor
from radartrack._observation.sights import SIGHTS, SightName

Kind = tuple[SightName, tuple[str, ...]]

# What a model measures, in its order, of what one of our sensors does.
KINDS: Mapping[type, Kind] = {
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
                raise ValueError("rotation_offset must be about the z axis alone in the plane; got a tilt")
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
    def turn(self) -> RealArray:
        """From components of the state, about the sensor, to those in its axes."""
        return np.kron(np.eye(len(self.places) // self.axes), self.rotation)

    def look(self, state_vector: Any) -> observe.Observed:
        """What is measured of a state, shape (m,), and its derivatives by all its components."""
        vector = _flat(state_vector)
        see: Callable[..., observe.Observed] = getattr(observe, self.sight)
        measured, jacobian, hessian = see(self.turn @ (vector[self.places] - self.origin), azimuth_from="x")
        rows = [SIGHTS[self.sight].outputs.index(name) for name in self.outputs]
        full = np.zeros((len(rows), len(vector)))
        full[:, self.places] = jacobian[rows] @ self.turn
        curved = np.zeros((len(rows), len(vector), len(vector)))
        curved[np.ix_(range(len(rows)), self.places, self.places)] = self.turn.T @ hessian[rows] @ self.turn
        return observe.Observed(measured[rows], full, curved)


def _flat(vector: Any) -> RealArray:
    return np.asarray(vector, dtype=np.float64).reshape(-1)


def _tilted(model: Any) -> bool:
    return bool(np.any(_flat(model.rotation_offset)[:2] != 0))
