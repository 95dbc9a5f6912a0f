"""One expression as a line of NumPy."""

from __future__ import annotations

from collections.abc import Sequence

from radartrack.derive import symbolic as sp
from radartrack.derive.symbolic import Expr
from radartrack.derive.writing.expression_code import ATOM, POWER, Code, ExpressionCode, NotWritable, enclosed

__all__ = ["FUNCTIONS", "NotWritable", "code", "terms"]

FUNCTIONS: dict[type[Expr], str] = {
    sp.Abs: "np.abs",
    sp.acos: "np.arccos",
    sp.asin: "np.arcsin",
    sp.atan: "np.arctan",
    sp.atan2: "np.arctan2",
    sp.below: "np.less",
    sp.cos: "np.cos",
    sp.cosh: "np.cosh",
    sp.exp: "np.exp",
    sp.expm1: "np.expm1",
    sp.hypot: "np.hypot",
    sp.log: "np.log",
    sp.ratio: "_ratio",
    sp.sin: "np.sin",
    sp.sinh: "np.sinh",
    sp.tan: "np.tan",
    sp.tanh: "np.tanh",
    sp.third: "_third",
}
HELPERS: dict[type[Expr], str] = {sp.remainder: "_remainder", sp.stumpff: "_stumpff"}


class _NumPy(ExpressionCode):
    language = "NumPy"

    def number(self, value: float) -> str:
        return f"{value}.0" if isinstance(value, int) else repr(value)

    def constant(self, expression: Expr) -> str:
        return f"np.{'pi' if expression == sp.pi else 'e'}"

    def call(self, expression: Expr, arguments: Sequence[str]) -> str | None:
        name = (FUNCTIONS | HELPERS).get(expression.func)
        return f"{name}({', '.join(arguments)})" if name else None

    def square(self, base: str, level: int) -> Code:
        """Fast in NumPy."""
        return f"{enclosed((base, level), ATOM)}**2", POWER

    def root(self, base: str) -> str:
        return f"np.sqrt({base})"

    def fractional_power(self, base: Code, above: str, below: str) -> Code:
        return f"{enclosed(base, ATOM)} ** ({above} / {below})", POWER


NUMPY = _NumPy()
code, terms = NUMPY.code, NUMPY.terms
