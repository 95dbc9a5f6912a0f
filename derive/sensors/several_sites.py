"""Observation maps of several sites: sums and differences of what two sites would measure.

One site is at the origin. The other one's term is that of the first, of the position and distance from it: so its
derivatives are written over its own direction. At a site its own term and the derivatives of that are zero, where they
do not exist; the other site's are what they are.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import reduce
from operator import add

from radartrack.derive import symbolic as sp
from radartrack.derive.language.quantity import Quantity
from radartrack.derive.language.stable_form import StableForm
from radartrack.derive.language.tensor import Tensor
from radartrack.derive.language.variable import Variable, length
from radartrack.derive.sensors.observation_maps import (
    BY_COSINES,
    IN_PLANE,
    Derived,
    Observation,
    plane,
    quantities_of,
    space,
    vx,
    vy,
    vz,
    x,
    y,
    z,
)
from radartrack.derive.symbolic import Expr, Symbol
from radartrack.derive.units import METRE, METRE_PER_SECOND, RADIAN

AT_A_SITE = "at a site its own term is zero"


@dataclass(frozen=True)
class Site:
    """A site away from the origin.

    Attributes:
        name: what it is, as it ends the names of what belongs to it.
        place: its position, by coordinate of the state; a coordinate that is not there is zero.
        parameters: the symbols in that.
    """

    name: str
    place: Mapping[Symbol, Expr]
    parameters: tuple[Variable, ...]

    @property
    def offsets(self) -> dict[Symbol, Expr]:
        """The position of the target from the site, by name."""
        return {self._named(axis): axis - place for axis, place in self.place.items()}

    def seen(self, entry: Expr) -> Expr:
        """What the origin sees, as the site sees it."""
        return entry.xreplace({axis: axis - place for axis, place in self.place.items()})

    def renamed(self, form: StableForm) -> StableForm:
        """The same in the words of the site."""
        names = {axis: self._named(axis) for axis in self.place}
        names |= {symbol: self._named(symbol) for symbol in form.definitions}
        definitions = {names[symbol]: value.xreplace(names) for symbol, value in form.definitions.items()}
        entries = form.entries.map(lambda entry: entry.xreplace(names))
        return StableForm({**self.offsets, **definitions}, entries)

    def _named(self, symbol: Symbol) -> Symbol:
        return sp.Symbol(f"{symbol.name}_from_{self.name}", real=True)


@dataclass(frozen=True, eq=False)
class SeveralSites(Observation):
    """What the origin sees, and the other site's sight of something, with a sign.

    Attributes:
        site: the other one.
        there: what it adds to each output, as if it stood at the origin.
    """

    site: Site = Site("", {}, ())
    there: tuple[Expr, ...] = ()

    @property
    def symbols(self) -> tuple[Variable, ...]:
        """The state and the site."""
        return (*self.state, *self.site.parameters)

    @property
    def map(self) -> Tensor[Expr]:
        """The measured quantities, shape [out]."""
        return self._sum(self._here, self._there.map(self.site.seen))

    def form(self, derived: Derived) -> StableForm:
        """The terms of both sites, each over its own direction."""
        here = self.written(derived(self._here))
        there = self.site.renamed(self.written(derived(self._there)))
        entries = self._sum(here.entries, there.entries)
        return StableForm({**here.definitions, **there.definitions}, entries).only(entries)

    @property
    def _here(self) -> Tensor[Expr]:
        return Tensor((len(self.outputs),), tuple(self.outputs.values()))

    @property
    def _there(self) -> Tensor[Expr]:
        return Tensor((len(self.outputs),), self.there)

    @staticmethod
    def _sum(*terms: Tensor[Expr]) -> Tensor[Expr]:
        return Tensor(terms[0].shape, tuple(reduce(add, parts) for parts in zip(*terms, strict=True)))


def _receiver(axis: str) -> Variable:
    return Variable(f"receiver_{axis}", f"position of the other receiver along the {axis} axis", METRE, -1e5, 1e5)


baseline = length("baseline", "distance of the transmitter, which stands on the x axis", low=1.0, high=1e5)
receiver = tuple(_receiver(axis) for axis in "xyz")
TRANSMITTER = Site("transmitter", {x: baseline}, (baseline,))
RECEIVER = Site("receiver", dict(zip((x, y, z), receiver, strict=True)), receiver)
RATE = (x * vx + y * vy + z * vz) / space
RATE_IN_PLANE = (x * vx + y * vy) / plane
ZERO = sp.Integer(0)

# fmt: off - a table reads best with few lines a row
OBSERVATIONS = (
    SeveralSites(
        "bistatic",
        "length of the path from transmitter to target to receiver, and azimuth at the receiver",
        (x, y),
        {"path": plane, "beta": sp.atan2(y, x)},
        (METRE, RADIAN),
        (IN_PLANE,),
        AT_A_SITE,
        TRANSMITTER,
        (plane, ZERO),
    ),
    SeveralSites(
        "bistatic_range_rate",
        "rate of the length of the path from transmitter to target to receiver",
        (x, y, vx, vy),
        {"path_rate": RATE_IN_PLANE},
        (METRE_PER_SECOND,),
        (IN_PLANE,),
        AT_A_SITE,
        TRANSMITTER,
        (RATE_IN_PLANE,),
    ),
    SeveralSites(
        "range_difference",
        "range from the other receiver less that from the origin (time difference of arrival)",
        (x, y, z),
        {"range_difference": -space},
        (METRE,),
        (BY_COSINES,),
        AT_A_SITE,
        RECEIVER,
        (space,),
    ),
    SeveralSites(
        "range_rate_difference",
        "range rate at the other receiver less that at the origin (frequency difference of arrival)",
        (x, y, z, vx, vy, vz),
        {"range_rate_difference": -RATE},
        (METRE_PER_SECOND,),
        (BY_COSINES,),
        AT_A_SITE,
        RECEIVER,
        (RATE,),
    ),
)
# fmt: on


def quantities() -> list[Quantity]:
    """Those of all observations."""
    return [quantity for observation in OBSERVATIONS for quantity in quantities_of(observation)]
