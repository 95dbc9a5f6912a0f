"""Derived formulas as programs for arrays."""

from __future__ import annotations

import math
from collections.abc import Sequence

from radartrack.derive import symbolic as sp
from radartrack.derive.language.tensor import Tensor
from radartrack.derive.symbolic import Expr, Symbol
from radartrack.verification.array_program import OPERATIONS, Program


def compiled(entries: Tensor[Expr], symbols: Sequence[Symbol]) -> Program:
    """The formulas as a program over these symbols; every distinct subexpression is computed once."""
    return _Compiler(entries, symbols).program


class _Compiler:
    def __init__(self, entries: Tensor[Expr], symbols: Sequence[Symbol]) -> None:
        numbers = {e for entry in entries for e in leaves(entry) if e.is_number}
        constants = sorted(numbers | {sp.Rational(1, 2)}, key=str)
        first = [*symbols, *constants]
        self._places: dict[Expr, int] = {leaf: place for place, leaf in enumerate(first)}
        self._count = len(first)
        self._steps: list[tuple[str, tuple[int, ...]]] = []
        results = tuple(self._place(entry) for entry in entries)
        values = tuple(_value(constant) for constant in constants)
        names = tuple(symbol.name for symbol in symbols)
        self.program = Program(names, values, tuple(self._steps), results, entries.shape)

    def _place(self, expression: Expr) -> int:
        if expression not in self._places:
            step = self._step(expression)
            self._places[expression] = self._count + len(self._steps)
            self._steps.append(step)
        return self._places[expression]

    def _step(self, expression: Expr) -> tuple[str, tuple[int, ...]]:
        if isinstance(expression, sp.Pow) and expression.exp == sp.Rational(1, 2):
            return "sqrt", (self._place(expression.base),)
        if isinstance(expression, sp.Pow) and expression.exp == sp.Integer(2):
            return "square", (self._place(expression.base),)
        name = expression.func.__name__
        if name not in OPERATIONS:
            raise ValueError(f"{name} in {expression} has no NumPy operation")
        return name, tuple(self._place(argument) for argument in expression.args)


def leaves(expression: Expr) -> set[Expr]:
    """The symbols and numbers that occur."""
    if not expression.args:
        return {expression}
    return set().union(*(leaves(argument) for argument in expression.args))


def _value(number: Expr) -> float:
    if isinstance(number, sp.Rational):
        return int(number.p) / int(number.q)
    if number == sp.pi:
        return math.pi
    if number == sp.E:
        return math.e
    raise ValueError(f"{number} is no number that arrays are computed with")
