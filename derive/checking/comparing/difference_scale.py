"""What the difference of an entry is measured against over the whole domain."""

from __future__ import annotations

from radartrack.derive import symbolic as sp
from radartrack.derive.checking.question.compared_quantity import Reference
from radartrack.derive.language.tensor import Index
from radartrack.derive.symbolic import Expr


def squared_scale(reference: Reference, entry: Index) -> Expr:
    """A vector's entry counts by the norm of those of its unit, a covariance by its variances, all else alone.

    Returns:
        The square of that, up to its sign: a root would be lost where rounding makes a variance negative.
    """
    part = reference.part
    if part is None:
        return reference.entries[entry] ** 2
    place = part.places[entry]
    whole = part.quantity.expression
    if part.quantity.is_covariance:
        first, second = place
        return whole[first, first] * whole[second, second]
    if len(place) != 1:
        return whole[place] ** 2
    unit = part.quantity.unit(place)
    return sp.Add(*(one**2 for index, one in whole.items() if part.quantity.unit(index) == unit))
