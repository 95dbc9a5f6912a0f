"""Derived formulas as programs for arrays."""

from __future__ import annotations

import math
from collections.abc import Sequence

from radartrack.derive import symbolic as sp
from radartrack.derive.evaluation.steps import leaves, steps
from radartrack.derive.language.tensor import Tensor
from radartrack.derive.symbolic import Expr, Symbol
from radartrack.verification.array_program import OPERATIONS, Program


def compiled(entries: Tensor[Expr], symbols: Sequence[Symbol]) -> Program:
    """The formulas as a program over these symbols; every distinct subexpression is computed once."""
    numbers = {e for entry in entries for e in leaves(entry) if e.is_number}
    constants = sorted(numbers | {sp.Rational(1, 2)}, key=str)
    planned = steps(entries, [*symbols, *constants], _step)
    names, values = tuple(symbol.name for symbol in symbols), tuple(map(_value, constants))
    return Program(names, values, planned.steps, planned.results, entries.shape)


def _step(expression: Expr) -> tuple[str, Sequence[Expr]]:
    """The operation that makes a part of a formula from its own parts."""
    if isinstance(expression, sp.Pow) and expression.exp == sp.Rational(1, 2):
        return "sqrt", (expression.base,)
    if isinstance(expression, sp.Pow) and expression.exp == sp.Integer(2):
        return "square", (expression.base,)
    name = expression.func.__name__
    if name not in OPERATIONS:
        raise ValueError(f"{name} in {expression} has no NumPy operation")
    return name, expression.args


def _value(number: Expr) -> float:
    if isinstance(number, sp.Rational):
        return int(number.p) / int(number.q)
    if number == sp.pi:
        return math.pi
    if number == sp.E:
        return math.e
    raise ValueError(f"{number} is no number that arrays are computed with")
