"""A derived formula in the shortest form that is known, as `show` and verdicts print it and the reader reads it."""

from __future__ import annotations

from functools import lru_cache

from radartrack.derive import symbolic as sp
from radartrack.derive.algebra.exponential_polynomial import NotExponentialPolynomial
from radartrack.derive.formula.from_expression import to_tree
from radartrack.derive.formula.printing import to_text
from radartrack.derive.language.stable_form import NotProved
from radartrack.derive.language.tensor import Tensor
from radartrack.derive.stable.attenuation import stable_form
from radartrack.derive.stable.quantity_form import without_expm1
from radartrack.derive.symbolic import Expr

LONG = 600  # characters from which a derivation is shown as it came: rewriting it takes long


@lru_cache(maxsize=512)
def short(expression: Expr) -> Expr:
    """The formula as it came, or as it is written for floating point, whichever is shorter to print.

    What code needs besides, such as guards against a division by zero and e^x - 1 as one call, is not printed.
    """
    derived = plain(expression)
    if len(printed(derived)) > LONG:
        return derived
    try:
        rewritten = plain(stable_form(Tensor((), (expression,))).expanded().entries[0])
    except (NotExponentialPolynomial, NotProved):  # or no form that is known to be the same
        return derived
    return min(derived, rewritten, key=lambda one: len(printed(one)))


def plain(expression: Expr) -> Expr:
    """The formula in functions that people write."""
    without = without_expm1(expression)
    return sp.unguarded(without) if without.has(sp.ratio, sp.hypot) else without


def printed(expression: Expr) -> str:
    """The formula as the reader takes it back."""
    return to_text(to_tree(expression))
