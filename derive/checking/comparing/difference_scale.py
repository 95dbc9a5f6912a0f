"""Beside what an entry may not nearly vanish where its difference is measured against it.

Where its terms cancel, a formula is as small as one likes, and every difference as large beside it.
"""

from __future__ import annotations

from radartrack.derive import symbolic as sp
from radartrack.derive.checking.question.compared_quantity import Reference
from radartrack.derive.language.tensor import Index
from radartrack.derive.symbolic import Expr


def squared_scale(reference: Reference, entry: Index) -> tuple[Expr, str]:
    """Beside the entries of its unit for one of a tensor, beside its variances for a covariance, else beside itself.

    Returns:
        The square of that, up to its sign: a root would be lost where rounding makes a variance negative. And what it
        is in words; nothing for an entry itself.
    """
    part = reference.part
    if part is None:
        return reference.entries[entry] ** 2, ""
    place = part.places[entry if part.shape else ()]
    whole = part.quantity.expression
    if part.quantity.is_covariance and len(place) == 2:
        first, second = place
        if first == second:
            return whole[place] ** 2, ""
        return whole[first, first] * whole[second, second], "the root of the product of the variances"
    unit = part.quantity.unit(place)
    beside = [one for index, one in whole.items() if part.quantity.unit(index) == unit]
    words = "the entries of its unit together" if len(beside) > 1 else ""
    return sp.Add(*(one**2 for one in beside)), words


def squared_floor(reference: Reference, entry: Index) -> tuple[Expr, str]:
    """Beside what an entry may not nearly vanish: its scale; for a sum that is no quantity its terms, which cancel."""
    formula = sp.unguarded(reference.entries[entry])
    if reference.part is not None or not formula.is_Add:
        return squared_scale(reference, entry)
    return sp.Add(*(term**2 for term in formula.args)), "its terms together"
