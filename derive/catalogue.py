"""Every quantity by its dotted name."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from difflib import get_close_matches
from functools import cache

from radartrack.derive import (
    conversion,
    expansion,
    finite_sample_quantities,
    fusion,
    kinematics,
    line,
    observation,
    plane_motion,
    regression,
    straight_track,
)
from radartrack.derive.quantity import Quantity

FAMILIES: tuple[Callable[[], Iterable[Quantity]], ...] = (
    conversion.quantities,
    observation.quantities,
    line.quantities,
    regression.quantities,
    straight_track.quantities,
    fusion.quantities,
    finite_sample_quantities.quantities,
    kinematics.quantities,
    plane_motion.quantities,
    expansion.quantities,
)


class UnknownQuantity(KeyError):
    """No quantity of the catalogue has this name."""

    def __str__(self) -> str:
        return str(self.args[0])


@cache
def catalogue() -> dict[str, Quantity]:
    """All quantities, in the order in which they are listed and written; nothing is derived yet."""
    return {quantity.name: quantity for family in FAMILIES for quantity in family()}


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
