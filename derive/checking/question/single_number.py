"""A formula that must be one number, as an expression."""

from __future__ import annotations

from collections.abc import Mapping

from radartrack.derive.formula.error import FormulaError
from radartrack.derive.formula.to_expression import Expression, to_expression
from radartrack.derive.formula.tree import Tree
from radartrack.derive.symbolic import Expr


def scalar_expression(tree: Tree, symbols: Mapping[str, Expr]) -> Expr:
    """The tree in these symbols.

    Raises:
        FormulaError: for an array, and where `to_expression` raises it.
    """
    return only_scalar(to_expression(tree, symbols), tree)


def only_scalar(expression: Expression, tree: Tree) -> Expr:
    """What was read from a tree.

    Raises:
        FormulaError: for an array.
    """
    if isinstance(expression, tuple):
        raise FormulaError("a vector or matrix stands where one number is wanted", span=tree.span)
    return expression
