"""The one door through which two expressions are proved to be the same function.

What is printed is compared in one algebra, which knows roots and inverse functions, with a bound on its effort: it may
be anything. What was derived is tried first in the cheapest ring in which it lies, and may take as long as it takes: a
form that is not proved is not written.
"""

from __future__ import annotations

from contextlib import suppress

from radartrack.derive import symbolic as sp
from radartrack.derive.algebra.canonical_form import Field, NotCanonical
from radartrack.derive.algebra.common_denominator import vanishes
from radartrack.derive.algebra.differential_ring import NotDifferentiable
from radartrack.derive.algebra.exponential_polynomial import Effort, TooLong
from radartrack.derive.algebra.rational_function import NotRational, is_zero
from radartrack.derive.symbolic import Expr

PRODUCTS = 200_000  # of monomials, for one proof; the longest formulas of the catalogue take 24 000


def proved_equal(first: Expr, second: Expr) -> bool:
    """Whether the two are proved equal wherever both are defined; False says nothing.

    Symbols are real, and lie in their domains: positive where their assumptions say so, whole numbers from their least.
    """
    difference = first - second  # terms that both have are gone
    difference = difference.xreplace({call: call.expanded() for call in difference.atoms(sp.Abbreviation)})
    for thorough in (False, True):
        field = Field([difference], thorough=thorough)
        with suppress(NotCanonical, TooLong), Effort(PRODUCTS):
            if field.vanishes(field.read(difference)):
                return True
        if not field.has_roots:
            break
    return False


def proved_zero(expression: Expr) -> bool:
    """Whether a difference of derived expressions is proved to vanish; False says nothing."""
    with suppress(NotRational):
        return is_zero(expression)  # among rational functions this is decided
    with suppress(NotDifferentiable):
        if vanishes(expression):
            return True
    return proved_equal(expression, sp.Integer(0))
