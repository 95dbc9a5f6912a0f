"""Symbols for what holds no variable, so that 1/a and √a are coefficients like a itself."""

from __future__ import annotations

from collections.abc import Collection

from radartrack.derive import symbolic as sp
from radartrack.derive.symbolic import Expr, Symbol


class Constants:
    """Parts of formulas that are no polynomials and hold none of some variables, each as a symbol.

    Args:
        variables: what is not constant.
    """

    def __init__(self, variables: Collection[Symbol]) -> None:
        self._variables = set(variables)
        self._known: dict[Expr, Symbol] = {}

    def hidden(self, expression: Expr) -> Expr:
        """The expression with a symbol for each such part."""
        if not expression.args:
            return expression
        if not expression.free_symbols & self._variables:
            return self._constant(expression)
        return expression.func(*map(self.hidden, expression.args))

    def shown(self, expression: Expr) -> Expr:
        """The expression with the parts again."""
        return expression.xreplace({symbol: constant for constant, symbol in self._known.items()})

    def _constant(self, expression: Expr) -> Expr:
        if isinstance(expression, sp.Add | sp.Mul):
            return expression.func(*map(self.hidden, expression.args))
        if isinstance(expression, sp.Pow) and isinstance(expression.exp, sp.Integer):
            if expression.exp > 0:
                return self.hidden(expression.base) ** expression.exp
            return self._symbol(1 / expression.base) ** -expression.exp
        return self._symbol(expression) if expression.free_symbols else expression

    def _symbol(self, constant: Expr) -> Symbol:
        if constant not in self._known:
            kind = {"positive": True} if constant.is_positive else {"real": True}
            self._known[constant] = sp.Symbol(f"{{constant {len(self._known)}}}", **kind)
        return self._known[constant]
