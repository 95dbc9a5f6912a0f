"""How large the terms of an expression are, whatever their signs: what a difference is accurate against."""

from __future__ import annotations

from radartrack.derive import symbolic as sp
from radartrack.derive.symbolic import Expr


def term_sizes(expression: Expr) -> Expr:
    """The expression with every sum replaced by the sum of the absolute values of its terms.

    Divisors and arguments of functions stay as they are: a size is asked for where terms meet, not before.
    """
    if isinstance(expression, sp.Add | sp.Mul):
        return expression.func(*(term_sizes(argument) for argument in expression.args))
    if isinstance(expression, sp.ratio):
        return sp.ratio(term_sizes(expression.args[0]), sp.Abs(expression.args[1]))
    if isinstance(expression, sp.Pow) and expression.exp.is_positive:
        return term_sizes(expression.base) ** expression.exp
    return sp.Abs(expression)
