"""Where things stand: geodetic coordinates, axes fixed to the Earth, those of a site, of an antenna, of a face.

A `Frame` has an origin, axes and a velocity; `ECEF` is one, `enu`, `antenna` and `face` make others at a place on the
Earth. `frame.to(other, ...)` takes points, states and covariances from one to another. Geodetic coordinates are no such
frame: `ecef_from_geodetic` and `geodetic_from_ecef` lead there and back. Angles are in radians, lengths in metres.
"""

from radartrack.frames.cartesian import ECEF, Frame, antenna, enu, face
from radartrack.frames.geodetic import (
    Geodetic,
    GeodeticBelief,
    ecef_from_geodetic,
    ecef_jacobian,
    geodetic_from_ecef,
    geodetic_jacobian,
)
from radartrack.frames.reference_ellipsoid import WGS84, Ellipsoid

__all__ = [
    "ECEF",
    "WGS84",
    "Ellipsoid",
    "Frame",
    "Geodetic",
    "GeodeticBelief",
    "antenna",
    "ecef_from_geodetic",
    "ecef_jacobian",
    "enu",
    "face",
    "geodetic_from_ecef",
    "geodetic_jacobian",
]


def __dir__() -> list[str]:
    return __all__
