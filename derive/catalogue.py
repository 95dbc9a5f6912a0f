"""Every quantity by its dotted name."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from difflib import get_close_matches
from functools import cache

from radartrack.derive.finite_sample import fading_memory, filter_quantities
from radartrack.derive.frames import earth, site
from radartrack.derive.language.quantity import Quantity
from radartrack.derive.language.variable import Variable
from radartrack.derive.moments import taylor_quantities
from radartrack.derive.moments.conversion_quantities import quantities_of
from radartrack.derive.motion import correlated_motion, plane_motion, polynomial_motion, steady_state, turning
from radartrack.derive.sensors import converted_measurements, observation_maps, several_sites
from radartrack.derive.tracks import (
    common_noise,
    deviation_from_line,
    fusion_weights,
    least_squares_line,
    line_over_time,
    track_initiation,
)

FAMILIES: tuple[Callable[[], Iterable[Quantity]], ...] = (
    converted_measurements.quantities,
    observation_maps.quantities,
    several_sites.quantities,
    earth.quantities,
    site.quantities,
    least_squares_line.quantities,
    line_over_time.quantities,
    deviation_from_line.quantities,
    fusion_weights.quantities,
    common_noise.quantities,
    track_initiation.quantities,
    filter_quantities.quantities,
    polynomial_motion.quantities,
    plane_motion.quantities,
    correlated_motion.quantities,
    turning.quantities,
    steady_state.quantities,
    fading_memory.quantities,
    taylor_quantities.quantities,
)


class UnknownQuantity(KeyError):
    """No quantity of the catalogue has this name."""

    def __str__(self) -> str:
        return str(self.args[0])


@cache
def catalogue() -> dict[str, Quantity]:
    """All quantities, in the order in which they are listed and written; nothing is derived yet."""
    return {quantity.name: quantity for family in FAMILIES for quantity in family()}


@cache
def common_symbols() -> dict[str, Variable]:
    """The symbols of the catalogue that have one unit wherever they occur."""
    found: dict[str, Variable] = {}
    different: set[str] = set()
    for quantity in catalogue().values():
        for symbol in quantity.symbols:
            if found.setdefault(symbol.name, symbol).unit != symbol.unit:
                different.add(symbol.name)
    return {name: symbol for name, symbol in found.items() if name not in different}


def find(name: str) -> Quantity:
    """The quantity of this name.

    Raises:
        UnknownQuantity: with the closest names there are.
    """
    known = catalogue()
    if name not in known:
        close = get_close_matches(name, known, n=3, cutoff=0.5)
        hint = f"; did you mean {' or '.join(close)}?" if close else "; `radartrack list` shows all names"
        raise UnknownQuantity(f"no quantity is called {name!r}{hint}")
    return known[name]


def family(quantity: Quantity) -> list[Quantity]:
    """The quantities whose names begin alike: of the catalogue, or of the model of one's own that it belongs to."""
    known = catalogue()
    if quantity.model is not None and known.get(quantity.name) != quantity:
        return quantities_of(quantity.model)
    return [other for other in known.values() if other.module == quantity.module]
