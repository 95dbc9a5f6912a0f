"""What the statements of a generated function are in exact arithmetic, and how far off it is at a point.

The statements are read, not run: every operation is of balls (Arb) with so many bits that what rounding does to a
double is seen to many digits. It is the oracle for certificates, and shares no code with them.
"""

from __future__ import annotations

import ast
import math
from collections.abc import Callable, Mapping, Sequence
from contextlib import AbstractContextManager
from functools import cache
from typing import Any

import numpy as np
import numpy.typing as npt

from radartrack.derive.language.quantity import Quantity
from radartrack.verification.domain_points import Points
from radartrack.verification.error_in_ulp import peers
from radartrack.verification.program_compilation import compiled
from radartrack.verification.rounding.scales import ITSELF, WEIGHTS

Ball = Any
Pair = tuple[Ball, Ball]  # a value, and the sum of the sizes of its terms
BITS = 900  # a difference of powers of 1e8 and 1e-9 loses some 400
SERIES = 60  # terms, of what is written as the rest of a series


class ExactStatements:
    """The statements of one function.

    Args:
        source: the text of its module.
        quantity: whose function it is.
    """

    def __init__(self, source: str, quantity: Quantity) -> None:
        self._function = _functions(source)[quantity.function]
        self._quantity = quantity
        self._peers = peers(quantity)

    def errors(self, computed: npt.NDArray[np.floating[Any]], points: Points) -> npt.NDArray[np.float64]:
        """The largest error of an entry at each point, in ulp of double precision.

        Args:
            computed: what the function gave, shape (points, entries).
            points: the arguments.
        """
        names = [symbol.name for symbol in self._quantity.symbols]
        rows = zip(*(points[name].tolist() for name in names), strict=True) if names else [()] * len(computed)
        stated = self._stated(points, computed.shape)
        return np.array([
            self._error(row, dict(zip(names, at, strict=True)), scales)
            for row, at, scales in zip(computed.tolist(), rows, stated, strict=True)
        ])  # fmt: skip

    def _stated(self, points: Points, shape: tuple[int, ...]) -> list[list[float] | None]:
        """The scales that a quantity states as formulas of their own, at each point."""
        if self._quantity.scale is None or self._quantity.measured_against in {ITSELF, WEIGHTS}:
            return [None] * shape[0]
        scales = np.abs(compiled(self._quantity.scale(), self._quantity.symbols)(**points))
        found: list[list[float] | None] = np.broadcast_to(scales.reshape(len(scales), -1), shape).tolist()
        return found

    def _error(self, computed: Sequence[float], point: Mapping[str, float], stated: Sequence[float] | None) -> float:
        with _precision():
            entries = self._entries(point)
            worst = 0.0
            for number, value, scale in zip(computed, entries, stated or self._scales(point, entries), strict=True):
                off = abs(value[0] - number)
                if not off.is_zero():
                    size = float(scale)
                    worst = max(worst, float(off) / math.ulp(size) if size and math.isfinite(number) else math.inf)
        return worst

    def _entries(self, point: Mapping[str, float]) -> list[Pair]:
        import flint  # noqa: PLC0415

        names = {name: (flint.arb(value), abs(flint.arb(value))) for name, value in point.items()}
        entries: dict[str, Pair] = {}
        for statement in self._function.body:
            match statement:
                case ast.Assign(targets=[ast.Subscript() as place], value=value):
                    entries[ast.unparse(place)] = _value(value, names, entries)
                case ast.Assign(targets=[ast.Name(id=name)], value=value) if not _is_shape(name, value):
                    names[name] = _value(value, names, entries)
                case ast.Return(value=ast.Subscript(value=ast.Call(args=[whole]))):
                    return [_value(leaf, names, entries) for leaf in _leaves(whole)]
        return list(entries.values())

    def _scales(self, point: Mapping[str, float], entries: Sequence[Pair]) -> list[Ball]:
        sizes = [abs(value) for value, _ in entries]
        bounded = next((symbol for symbol in self._quantity.symbols if symbol.at_most is not None), None)
        if self._quantity.is_difference:
            return [terms for _, terms in entries]
        if self._quantity.is_covariance:
            return [(sizes[i] * sizes[j]).sqrt() for i, j in self._peers]
        if self._quantity.measured_against == WEIGHTS and bounded is not None and bounded.at_most is not None:
            ends = (bounded.low, point[bounded.at_most.name])
            others = [self._entries({**point, bounded.name: end}) for end in ends]
            return [_norm([v, *(other[n][0] for other in others)]) for n, (v, _) in enumerate(entries)]
        groups = [[n] for n in range(len(entries))] if self._quantity.scale is not None else self._peers
        return [_norm([sizes[n] for n in group]) for group in groups]


def _precision() -> AbstractContextManager[Any]:
    import flint  # noqa: PLC0415

    found: AbstractContextManager[Any] = flint.ctx.workprec(BITS)
    return found


@cache
def _functions(source: str) -> dict[str, ast.FunctionDef]:
    return {node.name: node for node in ast.parse(source).body if isinstance(node, ast.FunctionDef)}


def _is_shape(name: str, value: ast.expr) -> bool:
    return name in {"arguments", "result"} or ast.unparse(value) == "arguments"


def _leaves(node: ast.expr) -> list[ast.expr]:
    return [leaf for part in node.elts for leaf in _leaves(part)] if isinstance(node, ast.List) else [node]


def _norm(values: Sequence[Ball]) -> Ball:
    total = sum(value * value for value in values)
    return total.sqrt() if not total.is_zero() else total


def _value(node: ast.expr, names: Mapping[str, Pair], entries: Mapping[str, Pair]) -> Pair:
    import flint  # noqa: PLC0415

    match node:
        case ast.Constant(value=int() | float() as number):
            return flint.arb(number), abs(flint.arb(number))
        case ast.Name(id=name):
            return names[name]
        case ast.Subscript():
            return entries[ast.unparse(node)]
        case ast.Attribute(attr="pi"):
            return flint.arb.pi(), flint.arb.pi()
        case ast.UnaryOp(op=ast.USub(), operand=operand):
            value, terms = _value(operand, names, entries)
            return -value, terms
        case ast.BinOp(left=left, op=operator, right=right):
            first, second = (_value(side, names, entries) for side in (left, right))
            return _operation(operator, first, second)
        case ast.Call(func=ast.Attribute(attr=name) | ast.Name(id=name), args=arguments):
            values = [_value(argument, names, entries)[0] for argument in arguments]
            found = _FUNCTIONS[name](*values)
            if name == "_ratio" and not found.is_zero():
                return found, _value(arguments[0], names, entries)[1] / abs(values[1])
            return found, abs(found)
    raise LookupError(f"there is no rule for {ast.unparse(node)}")


def _operation(operator: ast.operator, a: Pair, b: Pair) -> Pair:
    match operator:
        case ast.Add():
            return a[0] + b[0], a[1] + b[1]
        case ast.Sub():
            return a[0] - b[0], a[1] + b[1]
        case ast.Mult():
            return a[0] * b[0], a[1] * b[1]
        case ast.Div():
            return a[0] / b[0], a[1] / abs(b[0])
        case ast.Pow():
            return a[0] ** b[0], a[1] ** b[0]
    raise LookupError(f"there is no rule for {type(operator).__name__}")


def _hypot(x: Ball, y: Ball) -> Ball:
    return _norm([x, y])


def _ratio(above: Ball, below: Ball) -> Ball:
    return below if below.is_zero() else above / below


def _remainder(x: Ball, order: Ball) -> Ball:
    """Σ xⁿ/n! from an order on; e^x less what is before it."""
    total, term = x.exp(), 1 + 0 * x
    for n in range(int(float(order))):
        total, term = total - term, term * x / (n + 1)
    return total


def _stumpff(x: Ball, order: Ball) -> Ball:
    """1/n! − x²/(n+2)! + …, by its series; of arguments below some tens."""
    n = int(float(order))
    term = total = 1 / (0 * x + math.factorial(n))
    for k in range(1, 20 * SERIES):
        term = -term * x * x / ((n + 2 * k - 1) * (n + 2 * k))
        total += term
    return total


def _third(x: Ball) -> Ball:
    """The positive root c of 4c³ − 3c = x."""
    return (x.acosh() / 3).cosh() if x > 1 else (x.acos() / 3).cos()


def _less(x: Ball, y: Ball) -> Ball:
    return 0 * x + (1 if x < y else 0)


def _direction(y: Ball, x: Ball) -> Ball:
    import flint  # noqa: PLC0415

    return 0 * x if y.is_zero() and x >= 0 else flint.arb.atan2(y, x)


_FUNCTIONS: dict[str, Callable[..., Ball]] = {
    "_ratio": _ratio, "_remainder": _remainder, "_stumpff": _stumpff, "_third": _third, "abs": abs,
    "arctan2": _direction, "cos": lambda x: x.cos(), "exp": lambda x: x.exp(), "expm1": lambda x: x.expm1(),
    "hypot": _hypot, "less": _less, "sin": lambda x: x.sin(), "sqrt": lambda x: x.sqrt() if not x.is_zero() else x,
}  # fmt: skip
