"""Derived formulas as short ones that the reader takes back."""

from __future__ import annotations

from functools import lru_cache

from radartrack.derive import symbolic as sp
from radartrack.derive.algebra.exponential_polynomial import NotExponentialPolynomial
from radartrack.derive.formula.from_expression import to_tree
from radartrack.derive.formula.printing import to_text
from radartrack.derive.formula.tree import Tree
from radartrack.derive.language.stable_form import NotProved
from radartrack.derive.language.tensor import Tensor
from radartrack.derive.stable.attenuation import stable_form
from radartrack.derive.symbolic import Expr

LONG = 600  # characters from which a derivation is shown as it came


@lru_cache(maxsize=256)
def shown(entries: Tensor[Expr]) -> str:
    """A formula, or nested lists of formulas."""
    if not entries.shape:
        return to_text(as_printed(entries.entries[0]))
    return "[" + ", ".join(shown(part) for part in entries.parts()) + "]"


@lru_cache(maxsize=256)
def as_printed(expression: Expr) -> Tree:
    """A derived formula as it came, or its stable form where that is shorter."""
    derived = to_tree(_spelled(expression))
    if len(to_text(derived)) > LONG:
        return derived
    try:
        stable = stable_form(Tensor((), (expression,))).expanded().entries[0]
    except (NotExponentialPolynomial, NotProved):  # or no stable form that is known to be the same
        return derived
    return min(derived, to_tree(_spelled(stable)), key=lambda tree: len(to_text(tree)))


def _spelled(expression: Expr) -> Expr:
    """The formula in functions that people write."""
    found = expression.atoms(sp.expm1)
    calls: dict[Expr, Expr] = {-call: 1 - sp.exp(call.args[0]) for call in found}
    calls |= {call: sp.exp(call.args[0]) - 1 for call in found}
    return expression.xreplace(calls) if calls else expression
