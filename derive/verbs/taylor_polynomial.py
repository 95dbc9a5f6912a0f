"""Taylor polynomials of printed formulas, of those too that are defined at zero by their limit alone: sin(x)/x."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations_with_replacement
from math import factorial, prod

from radartrack.derive import symbolic as sp
from radartrack.derive.symbolic import Expr, Symbol
from radartrack.derive.verbs.derivatives import is_finite
from radartrack.derive.verbs.limit import limit
from radartrack.derive.verbs.no_closed_form import NoClosedForm

MOST_TERMS = 500  # six variables to order 4 have 210, to order 5 462
ZERO: Expr = sp.Integer(0)


def taylor(function: Expr, increments: Sequence[Symbol], order: int) -> Expr:
    """The Taylor polynomial in some symbols about zero, to an order in all of them together.

    Raises:
        NoClosedForm: when it would be too long, or a derivative is not finite at zero.
    """
    terms = [
        choice
        for degree in range(order + 1)
        for choice in combinations_with_replacement(range(len(increments)), degree)
    ]
    if len(terms) > MOST_TERMS:
        raise NoClosedForm(f"a Taylor polynomial of {len(terms)} terms is too long; {MOST_TERMS} are allowed")
    known: dict[tuple[int, ...], Expr] = {(): function}
    at_zero = dict.fromkeys(increments, ZERO)
    parts = []
    for choice in terms:
        if choice:
            known[choice] = sp.diff(known[choice[:-1]], increments[choice[-1]])
        value = known[choice].xreplace(at_zero)
        if not is_finite(value):
            return _along_rays(function, increments, order)
        powers = [choice.count(place) for place in range(len(increments))]
        below = prod(factorial(power) for power in powers)
        parts.append(value * prod(i**p for i, p in zip(increments, powers, strict=True)) / sp.Integer(below))
    return sp.Add(*parts)


def _along_rays(function: Expr, increments: Sequence[Symbol], order: int) -> Expr:
    """The same, each coefficient as the limit of what those before it leave, along every ray from zero."""
    along = sp.Symbol("{along}", real=True)
    rest = function.xreplace({one: along * one for one in increments})
    total = ZERO
    for _ in range(order + 1):
        try:
            coefficient = limit(rest, along, ZERO)
        except NoClosedForm as error:
            raise NoClosedForm(f"the function has no Taylor polynomial at zero that is known here: {error}") from None
        if not coefficient.is_polynomial(*increments):
            raise NoClosedForm("the function has no Taylor polynomial at zero: it depends on the way there")
        total += coefficient
        rest = (rest - coefficient) / along
    return total
