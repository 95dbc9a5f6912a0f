"""Evaluates formulas in floating point with a bound on its error: what that rules out needs no more digits."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import TypeAlias

from radartrack.derive import symbolic as sp
from radartrack.derive.evaluation.steps import steps
from radartrack.derive.symbolic import Expr, Symbol

Bounded: TypeAlias = "tuple[float, float]"  # a value, and how far it may be from the true one
ROUNDING = 1e-15  # of one operation, generously
TINY = 1e-300  # what underflow may lose


def _third(x: float) -> float:
    return math.cosh(math.acosh(x) / 3) if x > 1 else math.cos(math.acos(x) / 3)


_FUNCTIONS: dict[type[Expr], Callable[..., float]] = {
    sp.Abs: abs,
    sp.acos: math.acos,
    sp.asin: math.asin,
    sp.atan: math.atan,
    sp.atan2: math.atan2,
    sp.cos: math.cos,
    sp.cosh: math.cosh,
    sp.erf: math.erf,
    sp.exp: math.exp,
    sp.expm1: math.expm1,
    sp.hypot: math.hypot,
    sp.log: math.log,
    sp.ratio: lambda above, below: above / below if below else 0.0,
    sp.sin: math.sin,
    sp.sinh: math.sinh,
    sp.tan: math.tan,
    sp.tanh: math.tanh,
    sp.third: _third,
    sp.Pow: math.pow,
}


class RoughEvaluator:
    """Some expressions, prepared for evaluation at many points.

    Every distinct subexpression is computed once a point.
    """

    def __init__(self, expressions: Sequence[Expr], symbols: Sequence[Symbol]) -> None:
        self._steps = steps(expressions, symbols, _step)

    def __call__(self, point: Sequence[float]) -> list[Bounded] | None:
        """The expressions at a point; None where floating point has no finite value for all that they are made of."""
        slots = [(value, 0.0) for value in point]
        try:
            for operation, operands in self._steps.steps:
                slots.append(operation(*[slots[i] for i in operands]))
        except (ArithmeticError, ValueError):
            return None
        found = [slots[i] for i in self._steps.results]
        return found if all(map(math.isfinite, sum(found, ()))) else None


def _step(expression: Expr) -> tuple[Callable[..., Bounded], Sequence[Expr]]:
    """What makes a part of a formula from its own parts."""
    if not expression.args and expression.is_real:
        number = _rounded(float(expression))
        return lambda: number, ()
    if isinstance(expression, sp.Pow) and isinstance(expression.exp, sp.Rational):
        exponent = float(expression.exp)
        return _applied(lambda base: math.pow(base, exponent)), (expression.base,)
    if isinstance(expression, sp.Add):
        return _sum, expression.args
    if isinstance(expression, sp.Mul):
        return _product, expression.args
    return _applied(_FUNCTIONS.get(expression.func, _not_computed)), expression.args


def _not_computed(*_: float) -> float:
    raise ArithmeticError("this has no value in floating point")


def _rounded(value: float, error: float = 0.0) -> Bounded:
    """A value whose operands bring this error, with what rounding adds."""
    return value, error + ROUNDING * abs(value) + TINY


def _sum(*terms: Bounded) -> Bounded:
    return _rounded(math.fsum(value for value, _ in terms), sum(error for _, error in terms))


def _product(*factors: Bounded) -> Bounded:
    total, wrong = factors[0]
    for value, error in factors[1:]:
        wrong = abs(total) * error + (abs(value) + error) * wrong + TINY
        total *= value
        wrong += ROUNDING * abs(total)
    return total, wrong


def _applied(function: Callable[..., float]) -> Callable[..., Bounded]:
    """A function of bounded values; within so little it is monotonous."""

    def bounded(*operands: Bounded) -> Bounded:
        values = [value for value, _ in operands]
        result = function(*values)
        wrong = 0.0
        for place, (value, error) in enumerate(operands):
            for moved in (value - error, value + error) if error else ():
                wrong += abs(function(*values[:place], moved, *values[place + 1 :]) - result)
        return _rounded(result, wrong)

    return bounded
