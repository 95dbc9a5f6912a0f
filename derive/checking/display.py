"""Derived formulas as short text that the reader takes back."""

from __future__ import annotations

from functools import lru_cache

from radartrack.derive import symbolic as sp
from radartrack.derive.exponential import NotExponentialPolynomial
from radartrack.derive.stable import stable_form
from radartrack.derive.symbolic import Expr
from radartrack.derive.tensor import Tensor

LONG = 600  # characters from which a derivation is shown as it came


@lru_cache(maxsize=256)
def shown(entries: Tensor[Expr]) -> str:
    """A formula, or nested lists of formulas."""
    if not entries.shape:
        return _entry(entries.entries[0])
    return "[" + ", ".join(shown(part) for part in entries.parts()) + "]"


def _entry(expression: Expr) -> str:
    derived = _text(expression)
    if len(derived) > LONG:
        return derived
    try:
        stable = stable_form(Tensor((), (expression,))).expanded().entries[0]
    except NotExponentialPolynomial:
        return derived
    return min(derived, _text(stable), key=len)


def _text(expression: Expr) -> str:
    return str(expression.xreplace(_spelled(expression))).replace("Abs(", "abs(")


def _spelled(expression: Expr) -> dict[Expr, Expr]:
    """Functions that the writer knows, as those that people write."""
    calls: dict[Expr, Expr] = {-call: 1 - sp.exp(call.args[0]) for call in expression.atoms(sp.expm1)}
    calls |= {call: sp.exp(call.args[0]) - 1 for call in expression.atoms(sp.expm1)}
    return calls
