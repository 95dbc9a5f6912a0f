"""Where sites stand and how radars are turned: parametric latitudes, gradients, cross products, turns about axes."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from itertools import product
from typing import Any

import mpmath

from radartrack.derive.language.tensor import Tensor
from radartrack.verification.second_derivations.van_loan_motion import without_residues

METHOD = "parametric latitudes, cross products, turns about axes, differences and inverse matrices"
DIGITS = 150  # a difference leaves half of them
GEODETIC = ("latitude", "longitude", "height")
Number = Any
At = Mapping[str, Number]
Vector = Sequence[Number]


def _radii(at: At) -> tuple[Number, Number]:
    return at["semi_major_axis"], at["semi_major_axis"] * (1 - at["flattening"])


def _foot(at: At) -> Vector:
    """The point of the ellipsoid below, from the angle of the circles about it."""
    equatorial, polar = _radii(at)
    parametric = mpmath.atan(polar / equatorial * mpmath.tan(at["latitude"]))
    turn = mpmath.expj(at["longitude"]) * equatorial * mpmath.cos(parametric)
    return [turn.real, turn.imag, polar * mpmath.sin(parametric)]


def _up(at: At) -> Vector:
    """The gradient of the ellipsoid's equation."""
    equatorial, polar = _radii(at)
    return _unit([c / radius**2 for c, radius in zip(_foot(at), (equatorial, equatorial, polar), strict=True)])


def _unit(vector: Vector) -> Vector:
    size = mpmath.norm(list(vector))
    return [component / size for component in vector]


def _cross(first: Vector, second: Vector) -> Vector:
    return [first[m - 2] * second[m - 1] - first[m - 1] * second[m - 2] for m in range(3)]


def _position(at: At) -> Vector:
    return [foot + at["height"] * up for foot, up in zip(_foot(at), _up(at), strict=True)]


def _axes_of_horizon(at: At) -> list[Vector]:
    """Of any ellipsoid: the normal does not depend on it."""
    up = _up({"semi_major_axis": mpmath.mpf(1), "flattening": mpmath.mpf("0.25"), **at})
    east = _unit(_cross([0, 0, 1], up))
    return [east, _cross(up, east), up]


def _turned(vector: Vector, about: Vector, by: Number) -> Vector:
    """By Rodrigues' formula."""
    along = mpmath.fdot(about, vector) * (1 - mpmath.cos(by))
    across = _cross(about, vector)
    return [v * mpmath.cos(by) + c * mpmath.sin(by) + a * along for v, c, a in zip(vector, across, about, strict=True)]


def _antenna(at: At) -> list[Vector]:
    """Axes to the right, ahead and upwards, turned about where they then are."""
    axes: list[Vector] = [[1, 0, 0], [0, 1, 0], [0, 0, 1]]
    for about, by in ((2, -at["azimuth"]), (0, at["tilt"]), (1, at["roll"])):
        axes = [_turned(axis, axes[about], by) for axis in axes]
    return axes


def _face(at: At) -> list[Vector]:
    right, ahead, upwards = _antenna(at)
    return [[-component for component in right], upwards, ahead]


def _vector(values: Vector) -> Tensor[Number]:
    return Tensor((3,), tuple(values))


def _matrix(rows: Sequence[Vector]) -> Tensor[Number]:
    return without_residues(Tensor.build((3, 3), lambda m, n: rows[m][n]))


def _along(axes: Callable[[At], list[Vector]]) -> Callable[[At], Tensor[Number]]:
    def seen(at: At) -> Tensor[Number]:
        return _vector([mpmath.fdot(axis, [at["east"], at["north"], at["up"]]) for axis in axes(at)])

    return seen


def _before_site(at: At) -> Tensor[Number]:
    offset = [at[axis] - site for axis, site in zip("xyz", _position(at), strict=True)]
    return _vector([mpmath.fdot(axis, offset) for axis in _axes_of_horizon(at)])


def _derivatives(at: At) -> Any:
    """Of the position by latitude, longitude and height, by differences."""
    found = mpmath.zeros(3)
    with mpmath.workdps(DIGITS):
        point = tuple(at[name] for name in GEODETIC)
        for out, by in product(range(3), repeat=2):

            def coordinate(*given: Number, out: int = out) -> Number:
                return _position({**at, **dict(zip(GEODETIC, given, strict=True))})[out]

            found[out, by] = mpmath.diff(coordinate, point, tuple(int(by == place) for place in range(3)))
    return found


def _rows(matrix: Any) -> list[Vector]:
    return [[matrix[m, n] for n in range(3)] for m in range(3)]


DERIVATIONS: dict[str, Callable[[At], Tensor[Number]]] = {
    "frames.ecef_from_geodetic.map": lambda at: _vector(_position(at)),
    "frames.ecef_from_geodetic.jacobian": lambda at: _matrix(_rows(_derivatives(at))),
    "frames.geodetic_from_ecef.jacobian": lambda at: _matrix(_rows(_derivatives(at) ** -1)),
    "frames.enu_from_ecef.map": _before_site,
    "frames.enu_from_ecef.jacobian": lambda at: _matrix(_axes_of_horizon(at)),
    "frames.antenna_from_enu.map": _along(_antenna),
    "frames.antenna_from_enu.jacobian": lambda at: _matrix(_antenna(at)),
    "frames.face_from_enu.map": _along(_face),
    "frames.face_from_enu.jacobian": lambda at: _matrix(_face(at)),
}
