"""The axes of a site: east, north and up there (ENU), and those of a radar that is turned in some way.

A radar is turned by its azimuth about the vertical, then raised by its tilt, then rolled about where it looks. Its
antenna has the y axis ahead, x to the right and z upwards, as spherical measurements count; its face has z ahead,
y upwards and x so that the axes are right-handed: to the right of who looks at the face, as direction cosines count.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence

from radartrack.derive.bibliography import cite
from radartrack.derive.frames import earth
from radartrack.derive.language.matrix import Matrix, Vector, inner, product
from radartrack.derive.language.quantity import Conditioning, Quantity
from radartrack.derive.language.stable_form import StableForm
from radartrack.derive.language.tensor import Tensor
from radartrack.derive.language.variable import Variable, angle
from radartrack.derive.moments import taylor
from radartrack.derive.symbolic import Expr, Integer, Symbol, cos, sin
from radartrack.derive.units import METRE, ONE, Unit

SOURCE = cite("crouse2014", "local coordinate systems")
FARTHEST = 1e8  # metres, as high as targets go
NO_UNIT: tuple[Unit, ...] = (ONE,) * 3

x, y, z = (Variable(name, f"position along the {name} axis of the Earth", METRE, -FARTHEST, FARTHEST) for name in "xyz")
east, north, up = (
    Variable(name, f"position {where} of the site", METRE, -FARTHEST, FARTHEST)
    for name, where in (("east", "east"), ("north", "north"), ("up", "above the horizon"))
)
azimuth = angle("azimuth", "where the radar looks, clockwise from north")
tilt = angle("tilt", "how far it looks up from the horizon", -math.pi / 2, math.pi / 2)
roll = angle("roll", "how far it is turned about where it looks, its right side down")
SITE = (earth.latitude, earth.longitude, earth.height.on(-1e4, earth.HIGHEST))
IDENTITY: Matrix = tuple(tuple(Integer(int(m == n)) for n in range(3)) for m in range(3))


def horizon() -> Tensor[Expr]:
    """The directions east, north and up, which are those of steps in longitude, latitude and height; one a row."""
    axes = Tensor.build((3, 3), lambda row, column: (earth.EAST, earth.NORTH, earth.UP)[row][column])
    return StableForm(earth.NORMAL, axes).expanded()


def _turned(places: tuple[int, int], by: Expr) -> Matrix:
    """Axes of which the first of two turns towards the second, the second away from the first."""
    first, second = places
    entries = {(first, first): cos(by), (first, second): sin(by), (second, first): -sin(by), (second, second): cos(by)}
    return tuple(tuple(entries.get((m, n), IDENTITY[m][n]) for n in range(3)) for m in range(3))


def antenna() -> Matrix:
    """Its axes in terms of east, north and up: y goes to x by the azimuth, then to z by the tilt, then z to x."""
    to_azimuth, to_tilt, to_roll = _turned((1, 0), azimuth), _turned((1, 2), tilt), _turned((2, 0), roll)
    return product(to_roll, product(to_tilt, to_azimuth))


def face() -> Matrix:
    """The antenna's axes, left, up and ahead."""
    right, ahead, upwards = antenna()
    return tuple(-entry for entry in right), upwards, ahead


def _seen(axes: Matrix) -> Tensor[Expr]:
    """The coordinates of a position (east, north, up) along axes."""
    return Tensor((3,), tuple(inner(axis, (east, north, up)) for axis in axes))


def enu() -> Tensor[Expr]:
    """The position less that of the site, along east, north and up."""
    offset: Vector = tuple(at - site for at, site in zip((x, y, z), earth.ecef(), strict=True))
    return Tensor((3,), tuple(inner(axis, offset) for axis in _rows(horizon())))


def enu_form() -> StableForm:
    """The same over what the site's normal names; the difference is taken before anything is added up."""
    offsets = [Symbol(f"{axis}_from_site", real=True) for axis in "xyz"]
    site = earth.ecef_form()
    differences = {offset: at - entry for offset, at, entry in zip(offsets, (x, y, z), site.entries, strict=True)}
    entries = Tensor((3,), tuple(inner(axis, offsets) for axis in (earth.EAST, earth.NORTH, earth.UP)))
    return StableForm({**earth.NORMAL, **differences}, entries).only(entries)


def _rows(tensor: Tensor[Expr]) -> Sequence[Vector]:
    return [tuple(row) for row in tensor.parts()]


def _as_derived(entries: Callable[[], Tensor[Expr]]) -> Callable[[], StableForm]:
    return lambda: StableForm({}, entries())


def _of_axes(name: str, meaning: str, axes: Callable[[], Matrix]) -> Iterator[Quantity]:
    """Map and Jacobian of axes that are turned from those of the horizon."""

    def seen() -> Tensor[Expr]:
        return _seen(axes())

    def jacobian() -> Tensor[Expr]:
        return taylor.jacobian(seen(), (east, north, up))

    turns = (azimuth, tilt, roll)
    yield Quantity(
        f"frames.{name}_from_enu.map",
        f"position along the axes of a radar's {name}, {meaning}, from that east, north and up of it",
        (earth.COORDINATES,),
        (east, north, up, *turns),
        Conditioning.NONE,
        SOURCE,
        "R(roll) R(tilt) R(azimuth) (east, north, up)",
        seen,
        _as_derived(seen),
        is_difference=True,
    )
    yield Quantity(
        f"frames.{name}_from_enu.jacobian",
        f"axes of a radar's {name}, {meaning}, in terms of east, north and up, [out, in]",
        (NO_UNIT, NO_UNIT),
        turns,
        Conditioning.NONE,
        SOURCE,
        "R(roll) R(tilt) R(azimuth)",
        jacobian,
        _as_derived(jacobian),
        is_difference=True,
    )


def quantities() -> Iterator[Quantity]:
    """East, north and up of a site, and the axes of a radar there."""
    yield Quantity(
        "frames.enu_from_ecef.map",
        "position east, north and up of a site, from that fixed to the Earth",
        (earth.COORDINATES,),
        (x, y, z, *SITE, *earth.ELLIPSOID),
        Conditioning.NONE,
        earth.SOURCE,
        "R (ecef - site)",
        enu,
        enu_form,
        is_difference=True,
    )
    yield Quantity(
        "frames.enu_from_ecef.jacobian",
        "directions east, north and up of a site, in the axes of the Earth, [out, in]",
        (NO_UNIT, NO_UNIT),
        (earth.latitude, earth.longitude),
        Conditioning.NONE,
        earth.SOURCE,
        "R",
        horizon,
        _as_derived(horizon),
    )
    yield from _of_axes("antenna", "y ahead and z upwards", antenna)
    yield from _of_axes("face", "z ahead and y upwards", face)
