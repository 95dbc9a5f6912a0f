"""A formula under the conditions of a question."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from radartrack.derive import symbolic as sp
from radartrack.derive.symbolic import Expr, Symbol


def under(conditions: Mapping[Symbol, Expr], expression: Expr) -> Expr:
    """The expression with symbols replaced; without conditions no walk over it is taken, as SymPy would take it."""
    return expression.xreplace(conditions) if conditions else expression


def zero(symbols: Sequence[Symbol]) -> dict[Symbol, Expr]:
    """The condition that all of these vanish."""
    return {symbol: sp.Integer(0) for symbol in symbols}


def when_zero(symbols: Sequence[Symbol]) -> str:
    """The same in words after a verdict: " when rho = 0"; nothing for no symbols."""
    return " when " + " and ".join(f"{symbol} = 0" for symbol in symbols) if symbols else ""
