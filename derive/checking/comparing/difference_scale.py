"""Beside what an entry may not nearly vanish where its difference is measured against it.

Where its terms cancel, a formula is as small as one likes, and every difference as large beside it.
"""

from __future__ import annotations

from radartrack.derive import symbolic as sp
from radartrack.derive.checking.question.compared_quantity import Reference
from radartrack.derive.language.tensor import Index
from radartrack.derive.symbolic import Expr


def squared_floor(reference: Reference, entry: Index) -> tuple[Expr, str]:
    """Beside the entries of its unit for one of a tensor, beside its variances for a covariance, else beside its terms.

    Returns:
        The square of that, up to its sign: a root would be lost where rounding makes a variance negative. And what it
        is in words; nothing for an entry itself.
    """
    part = reference.part
    if part is None:
        return _beside_terms(reference.entries[entry])
    place = part.places[entry if part.shape else ()]
    whole = part.quantity.expression
    if part.quantity.is_covariance and len(place) == 2:
        first, second = place
        if first == second:
            return whole[place] ** 2, ""
        return whole[first, first] * whole[second, second], "the root of the product of the variances"
    unit = part.quantity.unit(place)
    beside = [one for index, one in whole.items() if part.quantity.unit(index) == unit]
    if len(beside) == 1:
        return _beside_terms(beside[0])
    return sp.Add(*(one**2 for one in beside)), "the entries of its unit together"


def _beside_terms(formula: Expr) -> tuple[Expr, str]:
    plain = sp.unguarded(formula)
    if not plain.is_Add:
        return formula**2, ""
    return sp.Add(*(term**2 for term in plain.args)), "its terms together"
