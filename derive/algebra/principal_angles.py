"""Angles that inverse functions give: equal where their sines and their cosines are."""

from __future__ import annotations

from collections.abc import Callable

from radartrack.derive import symbolic as sp
from radartrack.derive.algebra.equality import proved_equal
from radartrack.derive.symbolic import Expr

_INVERSE = (sp.acos, sp.asin, sp.atan, sp.atan2)


def equal_modulo_turn(first: Expr, second: Expr) -> bool:
    """Whether two angles are proved to have the same sine and cosine: they are equal up to whole turns."""
    if not (first.has(*_INVERSE) and second.has(*_INVERSE)):
        return False
    return all(proved_equal(function(first), function(second)) for function in (sp.sin, sp.cos))


def equal_angles(first: Expr, second: Expr) -> bool:
    """Whether two values of inverse functions are proved equal: both lie between -pi and pi, the first excluded."""
    principal = isinstance(first, _INVERSE) and isinstance(second, _INVERSE)
    return principal and equal_modulo_turn(first, second)


def equal_function(first: Expr, second: Expr, function: Callable[[Expr], Expr]) -> bool:
    """Whether two values of inverse functions are proved to have the same sine, or the same cosine."""
    if not (first.has(*_INVERSE) and second.has(*_INVERSE)):
        return False
    return proved_equal(function(first), function(second))


def equal_modulo_half_turn(first: Expr, second: Expr) -> bool:
    """Whether two angles are proved to have the same tangent: a quotient has lost the signs of what it is made of."""
    if not (first.has(*_INVERSE) and second.has(*_INVERSE)):
        return False
    sine, cosine = (sp.sin(first), sp.sin(second)), (sp.cos(first), sp.cos(second))
    return proved_equal(sine[0] * cosine[1], cosine[0] * sine[1])
