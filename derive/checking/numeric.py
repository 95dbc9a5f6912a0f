"""Evaluates printed trees at several points at once, in floating point: quick enough to screen thousands of edits."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from operator import add, mul, sub, truediv

from radartrack.derive.formula.tree import (
    Array,
    Call,
    Constant,
    Name,
    Negation,
    Number,
    Power,
    Product,
    Quotient,
    Sum,
    Tree,
)

Values = tuple[float, ...]
TOLERANCE = 1e-9

FUNCTIONS: Mapping[str, Callable[..., float]] = {
    "abs": abs,
    "acos": math.acos,
    "asin": math.asin,
    "atan": math.atan,
    "atan2": math.atan2,
    "cos": math.cos,
    "cosh": math.cosh,
    "cot": lambda x: 1 / math.tan(x),
    "coth": lambda x: 1 / math.tanh(x),
    "csc": lambda x: 1 / math.sin(x),
    "exp": math.exp,
    "expm1": math.expm1,
    "hypot": math.hypot,
    "log": math.log,
    "sec": lambda x: 1 / math.cos(x),
    "sin": math.sin,
    "sinh": math.sinh,
    "sqrt": math.sqrt,
    "tan": math.tan,
    "tanh": math.tanh,
}
INVERSES: Mapping[str, Callable[[float], float]] = {
    "acos": math.cos,
    "asin": math.sin,
    "atan": math.tan,
    "cos": math.acos,
    "cosh": math.acosh,
    "exp": math.log,
    "expm1": math.log1p,
    "log": math.exp,
    "sin": math.asin,
    "sinh": math.asinh,
    "sqrt": lambda x: x * x,
    "tan": math.atan,
    "tanh": math.atanh,
}


def combined(operation: Callable[..., float], *operands: Values) -> Values | None:
    """An operation at every point; None where it is not defined at one of them."""
    try:
        values = tuple(map(operation, *operands))
    except (ArithmeticError, ValueError):
        return None
    return values if not any(isinstance(v, complex) or not math.isfinite(v) for v in values) else None


def total(parts: Sequence[Values], operation: Callable[[float, float], float], start: float) -> Values | None:
    """A sum or product of parts; of none it is `start`, once."""
    result = (start,) * len(parts[0]) if parts else None
    for part in parts:
        if result is not None:
            result = combined(operation, result, part)
    return result


def close(first: Values | None, second: Values | None) -> bool:
    """Whether both are the same at every point, up to rounding."""
    if first is None or second is None:
        return False
    return all(abs(a - b) <= TOLERANCE * max(abs(a), abs(b), 1e-6) for a, b in zip(first, second, strict=True))


class Screen:
    """A set of points: what the symbols are worth there, and what trees are.

    Args:
        names: the values of every symbol that a tree may use.
        size: how many points there are.
    """

    def __init__(self, names: Mapping[str, Values], size: int) -> None:
        self.names = names
        self.size = size
        self._known: dict[int, tuple[Tree, Values | None]] = {}

    def constant(self, value: float) -> Values:
        """The same number at every point."""
        return (float(value),) * self.size

    def __call__(self, tree: Tree) -> Values | None:
        """The values of a tree; None when it is not a real number everywhere."""
        known = self._known.get(id(tree))  # to hash a tree would take as long as to evaluate it
        if known is None:
            known = self._known[id(tree)] = (tree, self._evaluate(tree))
        return known[1]

    def first(self, size: int) -> Screen:
        """The first of the points alone."""
        return Screen({name: values[:size] for name, values in self.names.items()}, size)

    def _evaluate(self, tree: Tree) -> Values | None:
        match tree:
            case Number() | Constant() | Name():
                return self._atom(tree)
            case Sum(parts):
                return self._folded(parts, add, 0.0)
            case Product(parts):
                return self._folded(parts, mul, 1.0)
            case Quotient(numerator, denominator):
                return self._applied(truediv, (numerator, denominator))
            case Negation(operand):
                return self._applied(lambda value: -value, (operand,))
            case Power(base, exponent):
                return self._applied(lambda x, n: x**n, (base, exponent))
            case Call(function, arguments):
                return self._applied(FUNCTIONS[function], arguments)
            case Array():
                return None

    def _atom(self, tree: Number | Constant | Name) -> Values:
        if isinstance(tree, Name):
            return self.names[tree.name]
        if isinstance(tree, Constant):
            return self.constant(math.pi if tree.name == "pi" else math.e)
        return self.constant(float(tree.value))

    def _applied(self, operation: Callable[..., float], operands: Sequence[Tree]) -> Values | None:
        values = [self(operand) for operand in operands]
        known = [value for value in values if value is not None]
        return combined(operation, *known) if len(known) == len(values) else None

    def _folded(self, parts: Sequence[Tree], operation: Callable[[float, float], float], start: float) -> Values | None:
        values = [self(part) for part in parts]
        known = [value for value in values if value is not None]
        return total(known, operation, start) if len(known) == len(values) else None

    def required(self, tree: Tree, child: int, needed: Values) -> Values | None:
        """What a subtree would have to be worth for the tree to be worth what is needed."""
        match tree:
            case Sum(parts):
                rest = self._folded([*parts[:child], *parts[child + 1 :]], add, 0.0)
                return rest and combined(sub, needed, rest)
            case Product(parts):
                rest = self._folded([*parts[:child], *parts[child + 1 :]], mul, 1.0)
                return rest and combined(truediv, needed, rest)
            case Quotient(numerator, denominator):
                return self._required_of_quotient(numerator, denominator, child, needed)
            case Negation():
                return combined(lambda value: -value, needed)
            case Power(base, exponent):
                return self._required_of_power(base, exponent, child, needed)
            case Call("abs", (argument,)):
                inside = self(argument)
                return inside and combined(math.copysign, needed, inside)
            case Call(function) if function in INVERSES:
                return combined(INVERSES[function], needed)
            case _:
                return None

    def _required_of_quotient(self, numerator: Tree, denominator: Tree, child: int, needed: Values) -> Values | None:
        if child == 0:
            below = self(denominator)
            return below and combined(mul, needed, below)
        above = self(numerator)
        return above and combined(truediv, above, needed)

    def _required_of_power(self, base: Tree, exponent: Tree, child: int, needed: Values) -> Values | None:
        bases, exponents = self(base), self(exponent)
        if bases is None or exponents is None:
            return None
        if child:
            return combined(_exponent, needed, bases)
        root = combined(_base, needed, exponents)
        is_even = not any(exponent % 2 for exponent in exponents)
        return combined(math.copysign, root, bases) if root and is_even else root


def _exponent(power: float, base: float) -> float:
    return math.log(power) / math.log(base)


def _base(power: float, exponent: float) -> float:
    if power < 0 and exponent % 2 == 1:
        return -math.pow(-power, 1 / exponent)
    return math.pow(power, 1 / exponent)
