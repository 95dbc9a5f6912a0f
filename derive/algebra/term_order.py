"""An order of expressions that depends on names alone, so that what is written does not depend on the process."""

from __future__ import annotations

from collections.abc import Iterable

from radartrack.derive import symbolic as sp
from radartrack.derive.symbolic import Expr


def by_name(expressions: Iterable[Expr]) -> list[Expr]:
    """Numbers first, then by what is printed."""
    return sorted(expressions, key=lambda expression: (not expression.is_Number, _NAMES.doprint(expression)))


class _Names(sp.StrPrinter):
    """Prints each part once: the same parts are met again in every form of a formula, and printing takes long."""

    def __init__(self) -> None:
        super().__init__()
        self._known: dict[object, str] = {}

    def _print(self, expr: object, **kwargs: object) -> str:
        if expr not in self._known:
            self._known[expr] = super()._print(expr, **kwargs)
        return self._known[expr]


_NAMES = _Names()
