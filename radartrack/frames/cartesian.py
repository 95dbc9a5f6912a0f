"""Frames whose axes stand on each other: of the Earth, a site, an antenna, a face; at rest or under way."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import overload

import numpy as np
from numpy.typing import ArrayLike

from radartrack._arrays.validation import (
    ANGLE,
    RANGE_RATE,
    SINGLE,
    Domain,
    RealArray,
    broadcast_shape,
    kept,
    real_arrays,
    require_parts,
    require_trailing_shape,
    require_within,
    whole_number,
)
from radartrack._filtering.moved_beliefs import carried, with_covariance
from radartrack.frames.geodetic import COORDINATE, LATITUDE, ecef_from_geodetic, read_covariance, read_geodetic
from radartrack.frames.reference_ellipsoid import WGS84, Ellipsoid
from radartrack.generated import frames as formulas
from radartrack.kalman import Belief

BLOCKS = (3, 6, 9)  # components of a position, with a velocity, with an acceleration
RATE = Domain(" m/s", 1e50, 1e8, RANGE_RATE.reason, signed=True)
AXIS = Domain("", 1.0 + 1e-9, 1.0 + 1e-6, "axes have length one", signed=True)
TILT = LATITUDE._replace(reason="from straight down to straight up")
SQUARE = 1e-9  # how far products of axes may be from those of axes that stand on each other


@dataclass(frozen=True, eq=False)
class Frame:
    """An origin, axes, and a velocity, all in the axes of the Earth (ECEF); many at once where these are arrays.

    Positions are counted from the origin and velocities from that of the frame, both along its axes as they stand at
    the moment: that is what a radar under way measures, for a range rate is the radial part of the relative velocity
    however the radar turns.

    Attributes:
        origin: position [m], shape (..., 3).
        axes: its x, y and z axis, one a row, shape (..., 3, 3).
        velocity: of the origin [m/s], shape (..., 3).

    Raises:
        TypeError: an attribute is not made of real numbers.
        ValueError: one is not finite or out of place, shapes do not fit, or the axes do not stand on each other.
    """

    origin: RealArray
    axes: RealArray
    velocity: RealArray = field(default_factory=lambda: np.zeros(3))

    def __post_init__(self) -> None:
        given = {"origin": self.origin, "axes": self.axes, "velocity": self.velocity}
        arrays = {name: np.asarray(array, np.float64) for name, array in real_arrays(given).items()}
        for name, shape, domain in (("origin", (3,), COORDINATE), ("axes", (3, 3), AXIS), ("velocity", (3,), RATE)):
            require_trailing_shape(name, arrays[name], shape)
            require_within(name, arrays[name], domain)
            object.__setattr__(self, name, kept(arrays[name]))
        products = arrays["axes"] @ np.swapaxes(arrays["axes"], -1, -2)
        if np.abs(products - np.eye(3)).max(initial=0.0) > SQUARE:
            raise ValueError("axes must have length one and stand on each other; got axes that do not")
        one_row = {"axes": arrays["axes"][..., 0, 0]}
        broadcast_shape({name: one_row.get(name, array[..., 0]) for name, array in arrays.items()})

    def rotation(self, other: "Frame") -> RealArray:
        """What turns components along these axes into components along the other's, shape (..., 3, 3)."""
        _require_frame(other)
        return np.asarray(other.axes @ np.swapaxes(self.axes, -1, -2))

    def jacobian(self, other: "Frame", components: int = 3) -> RealArray:
        """First derivatives of what `to` gives by what it takes, shape (..., components, components).

        Raises:
            TypeError: components is no whole number.
            ValueError: it is not 3, 6 or 9.
        """
        if (size := whole_number("components", components, 0)) not in BLOCKS:
            raise ValueError(f"components must be one of {list(BLOCKS)}; got {components!r}")
        rotation = self.rotation(other)
        blocks = np.zeros((*rotation.shape[:-2], size, size))
        for first in range(0, size, 3):
            blocks[..., first : first + 3, first : first + 3] = rotation
        return blocks

    @overload
    def to(self, other: "Frame", mean: ArrayLike, covariance: None = ...) -> RealArray: ...
    @overload
    def to(self, other: "Frame", mean: ArrayLike, covariance: ArrayLike) -> Belief: ...
    def to(self, other: "Frame", mean: ArrayLike, covariance: ArrayLike | None = None) -> RealArray | Belief:
        """The same points or states in another frame, with the covariance of their errors if it is given.

        Between two sites on the Earth the difference of their positions is taken first, so nothing is rounded to
        digits of the Earth's radius that need not be. It is computed in float64, and is float32 where every array
        given is: of a position fixed to the Earth float32 knows half a metre.

        Args:
            other: where to.
            mean: in this frame: positions, then velocities, then accelerations if there are any, shape (..., 3),
                (..., 6) or (..., 9). Leading axes broadcast with those of the frames.
            covariance: of their errors, shape (..., n, n) or (n, n).

        Returns:
            The mean in the other frame; with a covariance given a `Belief` of both, a mean for each covariance.

        Raises:
            TypeError: an argument is not made of real numbers, or the other is no frame.
            ValueError: one is not finite or out of place, shapes do not fit, or the covariance is none.

        """
        _require_frame(other)
        arrays = real_arrays({"mean": mean} | ({} if covariance is None else {"covariance": covariance}))
        single = all(array.dtype == SINGLE for array in arrays.values())
        dtype = np.dtype(np.float32 if single else np.float64)
        values = np.asarray(arrays["mean"], np.float64)
        _require_states(values)
        numbers = {"mean": values[..., 0], "this frame": _number(self), "the other frame": _number(other)}
        shape = broadcast_shape(numbers)
        offsets = (self.origin - other.origin, self.velocity - other.velocity, np.zeros(3))
        parts = [
            _rotated(other.axes, _rotated(np.swapaxes(self.axes, -1, -2), values[..., first : first + 3]) + offset)
            for first, offset in zip(range(0, values.shape[-1], 3), offsets, strict=False)
        ]
        spread = [np.broadcast_to(part, (*shape, 3)) for part in parts]  # frames may differ in their velocities alone
        moved = np.concatenate(spread, axis=-1).astype(dtype, copy=False)
        if covariance is None:
            return moved
        size = values.shape[-1]
        errors = read_covariance(covariance, size)
        broadcast_shape({"mean": moved[..., 0], "covariance": errors[..., 0, 0]})
        return with_covariance(moved, carried(self.jacobian(other, size), errors, dtype))

    @overload
    def to_ecef(self, mean: ArrayLike, covariance: None = ...) -> RealArray: ...
    @overload
    def to_ecef(self, mean: ArrayLike, covariance: ArrayLike) -> Belief: ...
    def to_ecef(self, mean: ArrayLike, covariance: ArrayLike | None = None) -> RealArray | Belief:
        """`to(ECEF, ...)`."""
        return self.to(ECEF, mean) if covariance is None else self.to(ECEF, mean, covariance)

    @overload
    def from_ecef(self, mean: ArrayLike, covariance: None = ...) -> RealArray: ...
    @overload
    def from_ecef(self, mean: ArrayLike, covariance: ArrayLike) -> Belief: ...
    def from_ecef(self, mean: ArrayLike, covariance: ArrayLike | None = None) -> RealArray | Belief:
        """`ECEF.to(self, ...)`."""
        return ECEF.to(self, mean) if covariance is None else ECEF.to(self, mean, covariance)


ECEF = Frame(np.zeros(3), np.eye(3))


def enu(
    latitude: ArrayLike,
    longitude: ArrayLike,
    height: ArrayLike = 0.0,
    *,
    velocity: ArrayLike = (0.0, 0.0, 0.0),
    ellipsoid: Ellipsoid = WGS84,
) -> Frame:
    """East, north and up of a place.

    Args:
        latitude: geodetic [rad], from -pi/2 to pi/2. At a pole north is along the meridian of the longitude given.
        longitude: eastward [rad].
        height: above the ellipsoid [m].
        velocity: of the place towards east, north and up [m/s], shape (..., 3).
        ellipsoid: that the coordinates are of.

    Returns:
        The frame, or one for each place.

    Raises:
        TypeError: an argument is not made of real numbers.
        ValueError: one is not finite or out of place, or shapes do not fit.

    Source: Hofmann-Wellenhof & Moritz 2006, 5.6.1, doi:10.1007/978-3-211-33545-1.

    """
    return _standing(latitude, longitude, height, velocity, ellipsoid, np.eye(3), {})


def antenna(
    latitude: ArrayLike,
    longitude: ArrayLike,
    height: ArrayLike = 0.0,
    *,
    azimuth: ArrayLike = 0.0,
    tilt: ArrayLike = 0.0,
    roll: ArrayLike = 0.0,
    velocity: ArrayLike = (0.0, 0.0, 0.0),
    ellipsoid: Ellipsoid = WGS84,
) -> Frame:
    """Axes of a radar that measures range, azimuth and elevation: x to its right, y ahead, z upwards.

    Its own azimuth counts clockwise from ahead and its elevation from the plane of x and y, as `rt.convert.spherical`
    and `spherical_doppler` take them with `azimuth_from="y"`. With no angle given this is `enu`. Of a ship or an
    aircraft, azimuth is the heading, tilt the pitch, and roll the bank.

    Args:
        latitude: geodetic [rad], from -pi/2 to pi/2.
        longitude: eastward [rad].
        height: above the ellipsoid [m].
        azimuth: of where the radar looks, clockwise from north [rad].
        tilt: how far it looks up from the horizon [rad], from -pi/2 to pi/2.
        roll: how far it is turned about where it looks, its right side down [rad].
        velocity: of the radar towards east, north and up [m/s], shape (..., 3).
        ellipsoid: that the coordinates are of.

    Returns:
        The frame, or one for each place or attitude.

    Raises:
        TypeError: an argument is not made of real numbers.
        ValueError: one is not finite or out of place, or shapes do not fit.

    Source: Crouse 2014, local coordinate systems.

    """
    attitude = _attitude(azimuth, tilt, roll)
    turned = formulas.antenna_from_enu_jacobian(**attitude)
    return _standing(latitude, longitude, height, velocity, ellipsoid, turned, attitude)


def face(
    latitude: ArrayLike,
    longitude: ArrayLike,
    height: ArrayLike = 0.0,
    *,
    azimuth: ArrayLike = 0.0,
    tilt: ArrayLike = 0.0,
    roll: ArrayLike = 0.0,
    velocity: ArrayLike = (0.0, 0.0, 0.0),
    ellipsoid: Ellipsoid = WGS84,
) -> Frame:
    """Axes of a radar that measures range and direction cosines: z ahead, y upwards along the face, x to its left.

    So x is to the right of who looks at the face, and the axes are right-handed; `rt.convert.ruv` gives positions along
    them. Where u counts to the radar's right, hand -u to it.

    It differs from `antenna` in the order and names of the axes alone.

    Args:
        latitude: geodetic [rad], from -pi/2 to pi/2.
        longitude: eastward [rad].
        height: above the ellipsoid [m].
        azimuth: of the boresight, clockwise from north [rad].
        tilt: how far the boresight looks up from the horizon [rad], from -pi/2 to pi/2.
        roll: how far the face is turned about the boresight, its right side, seen from behind, down [rad].
        velocity: of the radar towards east, north and up [m/s], shape (..., 3).
        ellipsoid: that the coordinates are of.

    Returns:
        The frame, or one for each place or attitude.

    Raises:
        TypeError: an argument is not made of real numbers.
        ValueError: one is not finite or out of place, or shapes do not fit.

    Source: Crouse 2014, local coordinate systems.

    """
    attitude = _attitude(azimuth, tilt, roll)
    turned = formulas.face_from_enu_jacobian(**attitude)
    return _standing(latitude, longitude, height, velocity, ellipsoid, turned, attitude)


def _standing(
    latitude: ArrayLike,
    longitude: ArrayLike,
    height: ArrayLike,
    velocity: ArrayLike,
    ellipsoid: Ellipsoid,
    turned: RealArray,
    attitude: Mapping[str, RealArray],
) -> Frame:
    """A frame at a place, its axes given in terms of those of the horizon there, by an attitude."""
    places = read_geodetic(latitude, longitude, height)
    speeds = np.asarray(real_arrays({"velocity": velocity})["velocity"], np.float64)
    require_trailing_shape("velocity", speeds, (3,))
    require_within("velocity", speeds, RATE)
    broadcast_shape({**places._asdict(), **attitude, "velocity": speeds[..., 0]})
    origin = ecef_from_geodetic(*places, ellipsoid=ellipsoid)
    horizon = formulas.enu_from_ecef_jacobian(latitude=places.latitude, longitude=places.longitude)
    return Frame(origin, turned @ horizon, _rotated(np.swapaxes(horizon, -1, -2), speeds))


def _attitude(azimuth: ArrayLike, tilt: ArrayLike, roll: ArrayLike) -> dict[str, RealArray]:
    arrays = real_arrays({"azimuth": azimuth, "tilt": tilt, "roll": roll})
    for (name, values), domain in zip(arrays.items(), (ANGLE, TILT, ANGLE), strict=True):
        require_within(name, values, domain)
    broadcast_shape(arrays)
    return {name: np.asarray(values, np.float64) for name, values in arrays.items()}


def _require_frame(other: Frame) -> None:
    require_parts("other", other, ("origin", "axes", "velocity"), "a Frame")


def _require_states(values: RealArray) -> None:
    if values.shape[-1:] not in {(size,) for size in BLOCKS}:
        allowed = "3, 6 or 9 components: positions, velocities, accelerations"
        raise ValueError(f"mean must have {allowed}; got shape {values.shape}")
    require_within("positions of mean", values[..., :3], COORDINATE)
    require_within("rates of mean", values[..., 3:], RATE)


def _number(frame: Frame) -> RealArray:
    """One for each of the frames."""
    return np.asarray(frame.origin[..., 0] + frame.velocity[..., 0] + frame.axes[..., 0, 0])


def _rotated(axes: RealArray, vectors: RealArray) -> RealArray:
    """Components of vectors along axes, one for all or one for each."""
    if axes.ndim == 2:
        return np.asarray(vectors @ axes.T)
    return np.asarray((axes @ vectors[..., np.newaxis])[..., 0])
