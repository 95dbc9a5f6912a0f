"""Proves that two formulas are the same function."""

from __future__ import annotations

from radartrack.derive.checking.canonical import Field, NotCanonical
from radartrack.derive.symbolic import Expr


def proved_equal(first: Expr, second: Expr) -> bool:
    """Whether the two are proved equal wherever both are defined; False says nothing.

    Symbols are real, and positive where their assumptions say so.
    """
    difference = first - second  # terms that both have are gone
    field = Field([difference])
    try:
        return field.vanishes(field.read(difference))
    except NotCanonical:
        return False
