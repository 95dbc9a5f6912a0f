"""Functions of which is known what they are: derived formulas, in any convention, with a slip or without."""

import inspect
import math
from collections.abc import Callable, Sequence
from random import Random
from typing import Any

import numpy as np

from radartrack.derive.language.quantity import Quantity
from radartrack.derive.language.tensor import Tensor
from radartrack.derive.symbolic import Expr
from radartrack.derive.units import RADIAN
from radartrack.verification.program_compilation import compiled

Function = Callable[..., Any]


def function_of(entries: Tensor[Expr], quantity: Quantity, names: Sequence[str] | None = None) -> Function:
    """Entries as a function of the symbols, in this order of their names."""
    program = compiled(entries, quantity.symbols)
    order = [symbol.name for symbol in quantity.symbols] if names is None else list(names)
    return named(lambda *values: program(**dict(zip(order, values, strict=True))), order)


def named(function: Function, names: Sequence[str]) -> Function:
    """The function with parameters of these names."""
    kind = inspect.Parameter.POSITIONAL_OR_KEYWORD
    function.__signature__ = inspect.Signature([inspect.Parameter(name, kind) for name in names])  # type: ignore[attr-defined]
    return function


def rewritings(function: Function, quantity: Quantity, chance: Random) -> dict[str, Function]:
    """Right functions that take or return the quantity in other ways.

    Args:
        function: of the symbols, by name.
        quantity: which it is.
        chance: which orders are taken.
    """
    names = [symbol.name for symbol in quantity.symbols]
    angles = {symbol.name for symbol in quantity.symbols if symbol.unit == RADIAN}
    spread = {name for name in names if name.removeprefix("predicted_").startswith("sigma_")}
    shuffled = chance.sample(names, len(names))

    def taking(
        order: Sequence[str], read: Callable[[str, float], float], put: Callable[[Any], Any] = np.asarray
    ) -> Function:
        def call(*values: float) -> Any:
            return put(function(**{name: read(name, value) for name, value in zip(order, values, strict=True)}))

        return named(call, order)

    def plain(_: str, value: float) -> float:
        return value

    found = {
        "as it is": taking(names, plain),
        "another order of arguments": taking(shuffled, plain),
        "lists": taking(shuffled, plain, lambda result: np.asarray(result).tolist()),
        "single precision": taking(names, plain, lambda result: np.asarray(result, dtype=np.float32)),
    }
    if len(names) > 1:
        found["a vector"] = named(lambda state: function(**dict(zip(names, state, strict=True))), ["state"])
    if angles:
        found["degrees"] = taking(names, lambda name, value: math.radians(value) if name in angles else value)
    if spread:
        found["variances"] = taking(names, lambda name, value: math.sqrt(value) if name in spread else value)
    if "beta" in names:
        found["azimuth"] = taking(names, lambda name, value: math.pi / 2 - value if name == "beta" else value)
    if len(quantity.shape) == 2 and quantity.shape[0] == quantity.shape[1]:
        found["transposed"] = taking(names, plain, lambda result: np.swapaxes(result, -1, -2))
    if quantity.shape:
        found["order of rows"] = taking(names, plain, lambda result: np.roll(result, 1, axis=0))
    return found
