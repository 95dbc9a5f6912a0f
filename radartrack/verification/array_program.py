"""Formulas as lists of NumPy operations: evaluated on arrays in any process, without SymPy and without written code."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import reduce
from operator import add, mul
from typing import Any

import numpy as np
import numpy.typing as npt

Array = npt.NDArray[np.float64]
Value = Any


def _ratio(above: Value, below: Value) -> Value:
    return np.divide(above, below, out=np.zeros(np.broadcast(above, below).shape), where=np.asarray(below != 0))


def _third(x: Value) -> Value:
    return np.where(x > 1, np.cosh(np.arccosh(np.maximum(x, 1)) / 3), np.cos(np.arccos(np.minimum(x, 1)) / 3))


def _power(base: Value, exponent: Value) -> Value:
    if isinstance(exponent, float) and exponent.is_integer() and abs(exponent) <= 16:
        whole = int(abs(exponent))
        result = reduce(mul, [base] * whole) if whole else 1.0
        return result if exponent >= 0 else 1.0 / result
    return np.power(base, exponent)


OPERATIONS: dict[str, Callable[..., Value]] = {
    "Abs": np.abs,
    "Add": lambda *terms: reduce(add, terms),
    "Mul": lambda *factors: reduce(mul, factors),
    "Pow": _power,
    "acos": np.arccos,
    "asin": np.arcsin,
    "atan": np.arctan,
    "atan2": np.arctan2,
    "cos": np.cos,
    "cosh": np.cosh,
    "exp": np.exp,
    "expm1": np.expm1,
    "hypot": np.hypot,
    "log": np.log,
    "ratio": _ratio,
    "sin": np.sin,
    "sinh": np.sinh,
    "sqrt": np.sqrt,
    "square": np.square,
    "tan": np.tan,
    "tanh": np.tanh,
    "third": _third,
}


@dataclass(frozen=True)
class Program:
    """A tensor of formulas over named arguments.

    Attributes:
        arguments: the names, which take the first slots.
        constants: the numbers, which take the next ones.
        steps: operations and the slots of their operands; each fills the next slot.
        results: the slots of the entries, in row-major order.
        shape: of the tensor.
    """

    arguments: tuple[str, ...]
    constants: tuple[float, ...]
    steps: tuple[tuple[str, tuple[int, ...]], ...]
    results: tuple[int, ...]
    shape: tuple[int, ...]

    def entries(self, point: Mapping[str, Value]) -> list[Value]:
        """The entries, each an array of the shape that its own arguments broadcast to."""
        slots: list[Value] = [point[name] for name in self.arguments]
        slots += self.constants
        for operation, operands in self.steps:
            slots.append(OPERATIONS[operation](*(slots[i] for i in operands)))
        return [slots[i] for i in self.results]

    def __call__(self, **arguments: Value) -> Array:
        """As a generated function: the shape of the broadcast arguments, then that of the tensor."""
        given = {name: np.asarray(value, dtype=np.float64) for name, value in arguments.items()}
        outer = np.broadcast_shapes(*(value.shape for value in given.values()))
        with np.errstate(all="ignore"):
            columns = [np.broadcast_to(entry, outer) for entry in self.entries(given)]
        if not columns:
            return np.empty((*outer, *self.shape))
        return np.stack(columns, axis=-1).reshape((*outer, *self.shape))
