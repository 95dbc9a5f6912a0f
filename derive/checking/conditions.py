"""A formula under the conditions of a question."""

from __future__ import annotations

from collections.abc import Mapping

from radartrack.derive.symbolic import Expr, Symbol


def under(conditions: Mapping[Symbol, Expr], expression: Expr) -> Expr:
    """The expression with symbols replaced; without conditions no walk over it is taken, as SymPy would take it."""
    return expression.xreplace(conditions) if conditions else expression
