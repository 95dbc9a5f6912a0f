"""How large an expression is when it is multiplied out, counted without doing it."""

from __future__ import annotations

from math import comb, prod

from radartrack.derive import symbolic as sp
from radartrack.derive.symbolic import Expr

CEILING = 10**9  # from where on it is not counted more exactly
WAVES = (sp.cos, sp.cosh, sp.sin, sp.sinh)  # each is a sum of two exponentials
WIDEST = 400  # summands of a sum whose power is counted


def terms(expression: Expr, known: dict[Expr, int] | None = None) -> int:
    """A bound on the terms of an expression, or of any part of it, once products and whole powers are expanded."""
    known = {} if known is None else known
    if expression not in known:
        inner = [terms(part, known) for part in expression.args]
        known[expression] = min(_joined(expression, inner), CEILING)
    return known[expression]


def _joined(expression: Expr, inner: list[int]) -> int:
    if isinstance(expression, sp.Add):
        return sum(inner)
    if isinstance(expression, sp.Mul):
        return prod(inner)
    if isinstance(expression, sp.Pow) and isinstance(expression.exp, sp.Rational):
        power = -(-abs(int(expression.exp.p)) // int(expression.exp.q))
        return comb(min(inner[0], WIDEST) + power - 1, power)
    return max([2 if isinstance(expression, WAVES) else 1, *inner])
