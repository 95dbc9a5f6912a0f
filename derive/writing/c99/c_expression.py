"""One expression as C99, in double or single precision: every operation is the one that NumPy code has."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from types import MappingProxyType

from radartrack.derive import symbolic as sp
from radartrack.derive.symbolic import Expr
from radartrack.derive.writing.expression_code import ATOM, SUM, Code, ExpressionCode

FUNCTIONS: dict[type[Expr], str] = {
    sp.Abs: "fabs",
    sp.acos: "acos",
    sp.asin: "asin",
    sp.atan: "atan",
    sp.atan2: "atan2",
    sp.cos: "cos",
    sp.cosh: "cosh",
    sp.exp: "exp",
    sp.expm1: "expm1",
    sp.hypot: "hypot",
    sp.log: "log",
    sp.sin: "sin",
    sp.sinh: "sinh",
    sp.tan: "tan",
    sp.tanh: "tanh",
}
HELPERS: dict[type[Expr], str] = {
    sp.below: "below",
    sp.ratio: "ratio",
    sp.remainder: "remainder",
    sp.stumpff: "stumpff",
    sp.third: "third",
}
ROOT, POWER, SQUARE = "sqrt", "pow", "square"
CONSTANTS = {sp.pi: "3.14159265358979323846", sp.E: "2.71828182845904523536"}
PREFIX = "radartrack_"


def in_header(name: str) -> str:
    """What headers call: everything by a name of their own, so that a user may replace math.h."""
    return PREFIX + name


def in_listing(name: str) -> str:
    """What code to be read calls: the functions of math.h by their own names."""
    return name if name in {*FUNCTIONS.values(), ROOT, POWER} else PREFIX + name


@dataclass(frozen=True)
class CExpression(ExpressionCode):
    """C in one precision.

    Attributes:
        suffix: of functions and numbers: "" in double precision, "f" in single.
        name_of: what a function is called, without the suffix.
        names: of symbols, where they are not their own.
    """

    suffix: str = ""
    name_of: Callable[[str], str] = in_header
    names: Mapping[str, str] = field(default_factory=lambda: MappingProxyType({}))
    language = "C"

    @property
    def real(self) -> str:
        """The type."""
        return "float" if self.suffix else "double"

    def name(self, symbol: str) -> str:
        """What a symbol is called."""
        return self.names.get(symbol, symbol)

    def number(self, value: float) -> str:
        """With the point that makes it no integer, and the suffix of the type."""
        return (f"{value}.0" if isinstance(value, int) else repr(value)) + self.suffix

    def constant(self, expression: Expr) -> str:
        """By its digits: M_PI is no part of C99."""
        return CONSTANTS[expression] + self.suffix

    def call(self, expression: Expr, arguments: Sequence[str]) -> str | None:
        """A function of math.h, or of the headers."""
        name = (FUNCTIONS | HELPERS).get(expression.func)
        return self._called(name, arguments) if name else None

    def square(self, base: str, level: int) -> Code:
        """A product that is rounded before anything else is done with it."""
        if level == ATOM and base.isidentifier():
            return f"{base} * {base}", SUM
        return self._called(SQUARE, [base]), ATOM

    def root(self, base: str) -> str:
        """The square root."""
        return self._called(ROOT, [base])

    def fractional_power(self, base: Code, above: str, below: str) -> Code:
        """By pow."""
        return self._called(POWER, [base[0], f"{above} / {below}"]), ATOM

    def _called(self, name: str, arguments: Sequence[str]) -> str:
        return f"{self.name_of(name)}{self.suffix}({', '.join(arguments)})"
