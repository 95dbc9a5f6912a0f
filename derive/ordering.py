"""An order of expressions that depends on names alone, so that what is written does not depend on the process."""

from __future__ import annotations

from collections.abc import Iterable
from functools import cache

from radartrack.derive.symbolic import Expr


def by_name(expressions: Iterable[Expr]) -> list[Expr]:
    """Numbers first, then by what is printed."""
    return sorted(expressions, key=_key)


@cache  # the same parts are met again in every form of a formula, and printing them takes long
def _key(expression: Expr) -> tuple[bool, str]:
    return not expression.is_Number, str(expression)
