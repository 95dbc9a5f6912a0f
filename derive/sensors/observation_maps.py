"""Observation maps: from a Cartesian state to what the radar measures, with first and second derivatives.

Derivatives are written over the direction of the target (its cosines) and its distance, so that nothing overflows and
nothing cancels that does not have to. Where a derivative does not exist, at the radar and on the vertical axis, what
would be divided by zero is zero: a measurement then says nothing about the state, and a Kalman filter leaves it alone.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass

from radartrack.derive import symbolic as sp
from radartrack.derive.bibliography import cite
from radartrack.derive.language.quantity import Conditioning, Quantity
from radartrack.derive.language.stable_form import StableForm
from radartrack.derive.language.tensor import Tensor
from radartrack.derive.language.variable import Variable
from radartrack.derive.moments import taylor
from radartrack.derive.stable.roots_and_quotients import collected_form
from radartrack.derive.symbolic import Expr, Symbol
from radartrack.derive.units import METRE, METRE_PER_SECOND, ONE, RADIAN, Unit

Axes = tuple[tuple[Unit, ...], ...]
Derived = Callable[[Tensor[Expr]], Tensor[Expr]]
SINGULAR = "zero where they do not exist, at the radar and for angles on the vertical axis"


@dataclass(frozen=True)
class Direction:
    """The direction of the target, over which derivatives are written.

    Attributes:
        definitions: distance and direction of the target, in terms of the state.
        norms: the roots that the map and its derivatives hold → their names.
        coordinates: coordinates and norms as products of distance and cosines.
    """

    definitions: Mapping[Symbol, Expr]
    norms: Mapping[Expr, Symbol]
    coordinates: Mapping[Expr, Expr]

    def is_enough_for(self, entry: Expr) -> bool:
        """Whether every root and sum of squares in an entry is one of the norms, or its square."""
        return {power.base for power in entry.atoms(sp.Pow) if power.base.args} <= {root**2 for root in self.norms}

    def norm(self, definition: Expr) -> Expr:
        """A root or a sum of squares in terms of the norms."""
        squares = {root**2: norm**2 for root, norm in self.norms.items()}
        return {**self.norms, **squares}[definition]


@dataclass(frozen=True, eq=False)
class Observation:
    """A map from state to measurement.

    Attributes:
        name: of the model whose measurement it is.
        title: one line in the field's words.
        state: the symbols of the state.
        outputs: name and expression of each measured quantity.
        units: the unit of each output.
        directions: over which the derivatives are written, each over the first whose norms are enough.
        where: the derivatives do not exist, and what they are there.
    """

    name: str
    title: str
    state: tuple[Variable, ...]
    outputs: Mapping[str, Expr]
    units: tuple[Unit, ...]
    directions: tuple[Direction, ...]
    where: str = SINGULAR

    @property
    def symbols(self) -> tuple[Variable, ...]:
        """What the map depends on."""
        return self.state

    @property
    def map(self) -> Tensor[Expr]:
        """The measured quantities, shape [out]."""
        return Tensor((len(self.outputs),), tuple(self.outputs.values()))

    def form(self, derived: Derived) -> StableForm:
        """What is derived of the outputs, as it is written."""
        return self.written(derived(self.map))

    def written(self, derived: Tensor[Expr]) -> StableForm:
        """The same entries over distance and direction."""
        entries = derived.map_distinct(self._rewritten)
        definitions = {name: value for direction in self.directions for name, value in direction.definitions.items()}
        return StableForm(definitions, entries).only(entries)

    def _rewritten(self, entry: Expr) -> Expr:
        """Cosines and distance for coordinates and norms; what they have in common is divided out."""
        direction = next(direction for direction in self.directions if direction.is_enough_for(entry))
        if entry.has(sp.atan2):
            return entry.xreplace(dict(direction.norms))
        over_one = collected_form(Tensor((), (entry,)))
        normed = over_one.entries.entries[0].xreplace(
            {name: direction.norm(definition) for name, definition in over_one.definitions.items()}
        )
        above, below = sp.fraction(sp.factor(normed.xreplace(dict(direction.coordinates))))
        return sp.ratio(above, below) if below.free_symbols else above / below


def quantities_of(observation: Observation) -> list[Quantity]:
    """Map, Jacobian and Hessian of an observation."""
    inward = tuple(variable.unit**-1 for variable in observation.state)
    state = observation.state
    rows: tuple[tuple[str, str, str, Axes, Derived], ...] = (
        ("map", "g", observation.title, (observation.units,), lambda outputs: outputs),
        (
            "jacobian",
            "dg/dstate",
            f"first derivatives of {observation.title}, [out, in]; {observation.where}",
            (observation.units, inward),
            lambda outputs: taylor.jacobian(outputs, state),
        ),
        (
            "hessian",
            "d2g/dstate2",
            f"second derivatives of {observation.title}, [out, in, in]; {observation.where}",
            (observation.units, inward, inward),
            lambda outputs: taylor.hessian(outputs, state),
        ),
    )
    return [_quantity(observation, *row) for row in rows]


def _quantity(observation: Observation, name: str, word: str, meaning: str, axes: Axes, derived: Derived) -> Quantity:
    return Quantity(
        name=f"observe.{observation.name}.{name}",
        meaning=meaning,
        axes=axes,
        symbols=observation.symbols,
        conditioning=Conditioning.NONE,
        source=cite("barshalom2011", "extended Kalman filter"),
        word=word,
        derivation=lambda: derived(observation.map),
        rewriting=lambda: observation.form(derived),
        is_difference=True,
    )


def _coordinate(name: str) -> Variable:
    return Variable(name, f"position along the {name} axis, from the radar", METRE, -1e6, 1e6)


def _speed(name: str, axis: str) -> Variable:
    return Variable(name, f"velocity along the {axis} axis", METRE_PER_SECOND, -1e3, 1e3)


def _named(name: str) -> Symbol:
    """An intermediate; of no stated sign, or SymPy would turn atan2 into atan of a quotient."""
    return sp.Symbol(name, real=True)


x, y, z = (_coordinate(name) for name in "xyz")
vx, vy, vz = (_speed(f"v{axis}", axis) for axis in "xyz")
distance, ground = _named("distance"), _named("ground_distance")
cos_azimuth, sin_azimuth = _named("cos_azimuth"), _named("sin_azimuth")
cos_elevation, sin_elevation = _named("cos_elevation"), _named("sin_elevation")
cosine_x, cosine_y, cosine_z = (_named(f"cosine_{axis}") for axis in "xyz")
plane, space = sp.sqrt(x**2 + y**2), sp.sqrt(x**2 + y**2 + z**2)

# Where a target lies, seen from the radar: the direction in terms of the state, and the state in terms of it.
IN_PLANE = Direction(
    {distance: sp.hypot(x, y), cos_azimuth: sp.ratio(x, distance), sin_azimuth: sp.ratio(y, distance)},
    {plane: distance},
    {x: distance * cos_azimuth, y: distance * sin_azimuth},
)
BY_COSINES = Direction(
    {
        ground: sp.hypot(x, y),
        distance: sp.hypot(ground, z),
        cosine_x: sp.ratio(x, distance),
        cosine_y: sp.ratio(y, distance),
        cosine_z: sp.ratio(z, distance),
    },
    {space: distance},
    {x: distance * cosine_x, y: distance * cosine_y, z: distance * cosine_z},
)
BY_ANGLES = Direction(
    {
        ground: sp.hypot(x, y),
        distance: sp.hypot(ground, z),
        cos_azimuth: sp.ratio(y, ground),
        sin_azimuth: sp.ratio(x, ground),
        cos_elevation: sp.ratio(ground, distance),
        sin_elevation: sp.ratio(z, distance),
    },
    {plane: ground, space: distance},
    {
        x: distance * cos_elevation * sin_azimuth,
        y: distance * cos_elevation * cos_azimuth,
        z: distance * sin_elevation,
        ground: distance * cos_elevation,
    },
)
POLAR = {"r": plane, "beta": sp.atan2(y, x)}
SPHERICAL = {"r": space, "beta": sp.atan2(x, y), "epsilon": sp.atan2(z, plane)}

# fmt: off - a table reads best with few lines a row
OBSERVATIONS = (
    Observation(
        "bearing",
        "azimuth of a position in the plane",
        (x, y),
        {"beta": sp.atan2(y, x)},
        (RADIAN,),
        (IN_PLANE,),
    ),
    Observation("polar", "range and azimuth of a position in the plane", (x, y), POLAR, (METRE, RADIAN), (IN_PLANE,)),
    Observation(
        "polar_doppler",
        "range, azimuth and range rate of a position and velocity in the plane",
        (x, y, vx, vy),
        POLAR | {"rdot": (x * vx + y * vy) / plane},
        (METRE, RADIAN, METRE_PER_SECOND),
        (IN_PLANE,),
    ),
    Observation(
        "ruv",
        "range and direction cosines of a position in space",
        (x, y, z),
        {"r": space, "u": x / space, "v": y / space},
        (METRE, ONE, ONE),
        (BY_COSINES,),
    ),
    Observation(
        "spherical",
        "range, azimuth and elevation of a position in space",
        (x, y, z),
        SPHERICAL,
        (METRE, RADIAN, RADIAN),
        (BY_COSINES, BY_ANGLES),
    ),
    Observation(
        "spherical_doppler",
        "range, azimuth, elevation and range rate of a position and velocity in space",
        (x, y, z, vx, vy, vz),
        SPHERICAL | {"rdot": (x * vx + y * vy + z * vz) / space},
        (METRE, RADIAN, RADIAN, METRE_PER_SECOND),
        (BY_COSINES, BY_ANGLES),
    ),
)
# fmt: on


def quantities() -> list[Quantity]:
    """Those of all observations."""
    return [quantity for observation in OBSERVATIONS for quantity in quantities_of(observation)]
