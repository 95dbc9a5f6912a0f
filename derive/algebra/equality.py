"""Proves that two formulas are the same function."""

from __future__ import annotations

from contextlib import suppress

from radartrack.derive import symbolic as sp
from radartrack.derive.algebra.canonical_form import Field, NotCanonical
from radartrack.derive.algebra.exponential_polynomial import Effort, TooLong
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
