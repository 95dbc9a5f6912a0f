"""Geodetic coordinates on an ellipsoid of revolution, and the Cartesian ones that turn with the Earth (ECEF).

The normal n at the geodetic latitude touches the ellipsoid where its support function h(n) = max n'x has its gradient;
a point stands so much farther along the normal as it is high. Textbooks then write the radius N of the prime vertical,
which is the semi-major axis and a few kilometres: these kilometres are written here, so that the sum is rounded once.

The inverse of the Jacobian is written in the geodetic coordinates too, along the directions east, north and up.
"""

from __future__ import annotations

import math
from collections.abc import Iterator

from radartrack.derive import symbolic as sp
from radartrack.derive.bibliography import cite
from radartrack.derive.language.quantity import Conditioning, Quantity
from radartrack.derive.language.stable_form import StableForm
from radartrack.derive.language.tensor import Tensor
from radartrack.derive.language.variable import Variable, angle, length
from radartrack.derive.moments import taylor
from radartrack.derive.symbolic import Expr, Symbol, cos, sin
from radartrack.derive.units import METRE, ONE, RADIAN

SOURCE = cite("hofmannwellenhof2006", "5.6.1")
HIGHEST = 1e8  # metres: beyond the orbits of satellites that a radar follows

latitude = angle("latitude", "geodetic latitude", -math.pi / 2, math.pi / 2)
longitude = angle("longitude", "longitude, eastward")
height = Variable("height", "height above the ellipsoid", METRE, -6.3e6, HIGHEST)
semi_major_axis = length("semi_major_axis", "equatorial radius of the ellipsoid", 6.3e6, 6.5e6)
flattening = Variable("flattening", "one less the ratio of the polar radius to the equatorial one", ONE, 0.0, 0.01)
GEODETIC = (latitude, longitude, height)
ELLIPSOID = (semi_major_axis, flattening)
COORDINATES = (METRE,) * 3
ANGLES_AND_HEIGHT = (RADIAN, RADIAN, METRE)


def _named(name: str) -> Symbol:
    return sp.Symbol(name, real=True)


cos_latitude, sin_latitude = _named("cos_latitude"), _named("sin_latitude")
cos_longitude, sin_longitude = _named("cos_longitude"), _named("sin_longitude")
squared_eccentricity, root = _named("squared_eccentricity"), sp.Symbol("root", positive=True)
lift, drop = _named("lift"), _named("drop")
to_axis, to_equator, to_meridian_centre = _named("to_axis"), _named("to_equator"), _named("to_meridian_centre")

# Distances along the normal: to the axis, to the plane of the equator, and to the centre of the meridian's curvature.
NORMAL = {
    cos_latitude: cos(latitude),
    sin_latitude: sin(latitude),
    cos_longitude: cos(longitude),
    sin_longitude: sin(longitude),
    squared_eccentricity: flattening * (2 - flattening),
    root: sp.sqrt(1 - squared_eccentricity * sin_latitude**2),
    lift: height + semi_major_axis * squared_eccentricity * sin_latitude**2 / (root * (1 + root)),
    drop: height - semi_major_axis * squared_eccentricity * (root + cos_latitude**2) / (root * (1 + root)),
    to_axis: semi_major_axis + lift,
    to_equator: semi_major_axis + drop,
    to_meridian_centre: height + semi_major_axis * (1 - flattening) ** 2 / root**3,
}
EAST = (-sin_longitude, cos_longitude, sp.Integer(0))
NORTH = (-sin_latitude * cos_longitude, -sin_latitude * sin_longitude, cos_latitude)
UP = (cos_latitude * cos_longitude, cos_latitude * sin_longitude, sin_latitude)


def written(entries: Tensor[Expr]) -> StableForm:
    """Entries over what `NORMAL` names."""
    return StableForm(NORMAL, entries).only(entries)


def meridian() -> tuple[Expr, Expr]:
    """Distances from the axis and from the plane of the equator, by the support function of the meridian's ellipse."""
    outward, along = sp.Symbol("outward", positive=True), sp.Symbol("along", real=True)
    support = semi_major_axis * sp.sqrt(outward**2 + (1 - flattening) ** 2 * along**2)
    normal = {outward: cos(latitude), along: sin(latitude)}
    from_axis, above = ((sp.diff(support, axis) + height * axis).xreplace(normal) for axis in normal)
    return from_axis, above


def ecef() -> Tensor[Expr]:
    """The position, the meridian turned to its longitude."""
    from_axis, above = meridian()
    return Tensor((3,), (from_axis * cos(longitude), from_axis * sin(longitude), above))


def ecef_form() -> StableForm:
    """The position along the normal."""
    return written(Tensor((3,), (to_axis * UP[0], to_axis * UP[1], to_equator * UP[2])))


def ecef_jacobian() -> Tensor[Expr]:
    """First derivatives of the position, [out, in]."""
    return taylor.jacobian(ecef(), GEODETIC)


def ecef_jacobian_form() -> StableForm:
    """A step in latitude goes north, one in longitude east, one in height up."""
    lengths = to_meridian_centre, to_axis * cos_latitude
    columns = (*([length * axis for axis in to] for length, to in zip(lengths, (NORTH, EAST), strict=True)), UP)
    return written(Tensor.build((3, 3), lambda row, column: columns[column][row]))


def geodetic_jacobian() -> Tensor[Expr]:
    """First derivatives of the geodetic coordinates by the position, [out, in]: the inverse of the matrix above.

    Its columns stand on each other, so the rows of the inverse are their directions, each over the column's length.
    """
    from_axis, above = meridian()
    northward = cos(latitude) * sp.diff(above, latitude) - sin(latitude) * sp.diff(from_axis, latitude)
    lengths = northward, from_axis, sp.Integer(1)
    plain = Tensor.build((3, 3), lambda row, column: (NORTH, EAST, UP)[row][column] / lengths[row])
    return StableForm(NORMAL, plain).expanded()


def geodetic_jacobian_form() -> StableForm:
    """The same steps back; on the axis no direction is east, and the longitude has no derivative."""
    rows = (
        [sp.ratio(axis, to_meridian_centre) for axis in NORTH],
        [sp.ratio(axis, to_axis * cos_latitude) if axis.free_symbols else axis for axis in EAST],
        UP,
    )
    return written(Tensor.build((3, 3), lambda row, column: rows[row][column]))


def quantities() -> Iterator[Quantity]:
    """Position from geodetic coordinates, its Jacobian and the inverse of that."""
    yield Quantity(
        "frames.ecef_from_geodetic.map",
        "position (x, y, z) fixed to the Earth, from geodetic latitude, longitude and height",
        (COORDINATES,),
        (*GEODETIC, *ELLIPSOID),
        Conditioning.NONE,
        SOURCE,
        "grad max(n'x) + height n, for x on the ellipsoid and n its normal",
        ecef,
        ecef_form,
        is_difference=True,
    )
    yield Quantity(
        "frames.ecef_from_geodetic.jacobian",
        "first derivatives of the position (x, y, z) by latitude, longitude and height, [out, in]",
        (COORDINATES, tuple(unit**-1 for unit in ANGLES_AND_HEIGHT)),
        (*GEODETIC, *ELLIPSOID),
        Conditioning.NONE,
        SOURCE,
        "d(x, y, z)/d(latitude, longitude, height)",
        ecef_jacobian,
        ecef_jacobian_form,
        is_difference=True,
    )
    yield Quantity(
        "frames.geodetic_from_ecef.jacobian",
        "first derivatives of latitude, longitude and height by the position (x, y, z), [out, in]; "
        "those of the longitude are zero on the axis, where they do not exist",
        (ANGLES_AND_HEIGHT, tuple(unit**-1 for unit in COORDINATES)),
        (latitude, longitude, height.on(-1e6, HIGHEST), *ELLIPSOID),
        Conditioning.NONE,
        SOURCE,
        "the inverse of d(x, y, z)/d(latitude, longitude, height)",
        geodetic_jacobian,
        geodetic_jacobian_form,
    )
