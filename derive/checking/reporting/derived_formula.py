"""Derived formulas as short ones that the reader takes back, as `radartrack show` prints them."""

from __future__ import annotations

from functools import lru_cache

from radartrack.derive.formula.from_expression import to_tree
from radartrack.derive.formula.tree import Tree
from radartrack.derive.language.tensor import Tensor, nested
from radartrack.derive.symbolic import Expr
from radartrack.derive.writing.short_formula import printed, short


@lru_cache(maxsize=256)
def shown(entries: Tensor[Expr]) -> str:
    """A formula, or nested lists of formulas."""
    return nested(entries.map(lambda entry: printed(short(entry))))


def as_printed(expression: Expr) -> Tree:
    """One entry as a tree."""
    return to_tree(short(expression))
