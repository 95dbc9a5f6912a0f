"""Derived formulas as short ones that the reader takes back, as `radartrack show` prints them."""

from __future__ import annotations

from functools import lru_cache

from radartrack.derive import symbolic as sp
from radartrack.derive.formula.from_expression import to_tree
from radartrack.derive.formula.tree import Tree
from radartrack.derive.language.tensor import Tensor, nested
from radartrack.derive.symbolic import Expr
from radartrack.derive.writing.short_formula import printed, short

FEW_DECIMALS = 12  # with which a number is as short as a fraction


@lru_cache(maxsize=256)
def shown(entries: Tensor[Expr]) -> str:
    """A formula, or nested lists of formulas."""
    return nested(entries.map(lambda entry: _decimal(entry) or printed(short(entry))))


def _decimal(entry: Expr) -> str:
    """A number of many decimals as one; nothing for anything else."""
    if not isinstance(entry, sp.Rational) or entry.q < 10**FEW_DECIMALS:
        return ""
    places = len(str(entry.q)) - 1
    if entry.q != 10**places:
        return ""
    digits = str(abs(entry.p)).rjust(places + 1, "0")
    return f"{'-' * (entry.p < 0)}{digits[:-places]}.{digits[-places:]}"


def as_printed(expression: Expr) -> Tree:
    """One entry as a tree."""
    return to_tree(short(expression))
