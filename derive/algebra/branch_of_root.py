"""Whether an expression vanishes on a branch of its nested roots: exactly up to the sign of a root."""

from __future__ import annotations

from radartrack.derive import symbolic as sp
from radartrack.derive.algebra.equality import proved_equal
from radartrack.derive.symbolic import Expr

MOST_ROOTS = 4
HALF = sp.Rational(1, 2)


def vanishes_on_a_branch(expression: Expr, depth: int = MOST_ROOTS) -> bool:
    """Whether u + v √g is proved zero for one sign of √g, where that root holds others; False says nothing.

    Then u² = v² g. With which sign it vanishes has to be seen at points.
    """
    if proved_equal(expression, sp.Integer(0)):
        return True
    root = _nested_root(expression)
    if root is None or not depth:
        return False
    symbol = sp.Symbol("{root}", positive=True)
    changes = {power: symbol ** int(power.exp / HALF) for power in _powers(expression) if power.base == root}
    changes |= {size: symbol for size in expression.atoms(sp.Abs) if size.args[0] ** 2 == root}
    above, _ = sp.fraction(sp.together(expression.xreplace(changes)))
    if not above.is_polynomial(symbol):
        return False
    u: Expr = sp.Integer(0)
    v: Expr = sp.Integer(0)
    for (degree,), coefficient in sp.Poly(above, symbol).terms():
        part = coefficient * root ** (degree // 2)
        u, v = (u, v + part) if degree % 2 else (u + part, v)
    return vanishes_on_a_branch(u**2 - v**2 * root, depth - 1)


def _nested_root(expression: Expr) -> Expr | None:
    """The radicand that holds most other roots."""
    radicands = [power.base for power in _powers(expression)] + [one.args[0] ** 2 for one in expression.atoms(sp.Abs)]
    nested = [(len(_powers(radicand)), radicand) for radicand in radicands if _powers(radicand)]
    return max(nested, key=lambda pair: (pair[0], str(pair[1])))[1] if nested else None


def _powers(expression: Expr) -> set[Expr]:
    """The square roots in an expression, and their odd powers."""
    return {power for power in expression.atoms(sp.Pow) if isinstance(power.exp, sp.Rational) and power.exp.q == 2}
