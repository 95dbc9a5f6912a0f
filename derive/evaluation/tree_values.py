"""Evaluates printed trees at several points at once, in floating point: quick enough to screen thousands of edits."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from itertools import permutations
from operator import itemgetter, mul, neg, sub, truediv
from typing import TypeAlias

from radartrack.derive.evaluation.steps import steps
from radartrack.derive.formula.fold import Fold
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
    children,
)

Values = tuple[float, ...]
Running: TypeAlias = "list[Values | None]"  # of one part, of two, and so on
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


def combined(operation: Callable[..., float], *operands: Values | None) -> Values | None:
    """An operation at every point; None where it is not defined at one of them, or an operand is not."""
    if None in operands:
        return None
    try:
        values = tuple(map(operation, *operands))  # type: ignore[arg-type]  # none of them is None
        return values if all(map(math.isfinite, values)) else None
    except (ArithmeticError, TypeError, ValueError):  # a complex number is neither finite nor infinite
        return None


def added(*terms: float) -> float:
    """The sum."""
    return sum(terms)


def multiplied(*factors: float) -> float:
    """The product."""
    return math.prod(factors)


OPERATIONS: Mapping[type[Tree], Callable[..., float]] = {
    Sum: added,
    Product: multiplied,
    Quotient: truediv,
    Negation: neg,
    Power: pow,
    Array: lambda *_: math.nan,  # no number
}


def _operation(tree: Tree) -> Callable[..., float]:
    """What makes the value of a tree from those of its subtrees."""
    return FUNCTIONS[tree.function] if isinstance(tree, Call) else OPERATIONS[type(tree)]


def _number(tree: Tree) -> float:
    if isinstance(tree, Constant):
        return math.pi if tree.name == "pi" else math.e
    return float(tree.text) if isinstance(tree, Number) else math.nan


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
        self._values = Fold(self._step)
        self._running: dict[int, tuple[Tree, Running, Running]] = {}

    def constant(self, value: float) -> Values:
        """The same number at every point."""
        return (float(value),) * self.size

    def __call__(self, tree: Tree) -> Values | None:
        """The values of a tree; None when it is not a real number everywhere."""
        return self._values(tree)

    def first(self, size: int) -> Screen:
        """The first of the points alone."""
        return Screen({name: values[:size] for name, values in self.names.items()}, size)

    def _step(self, tree: Tree, below: Sequence[Values | None]) -> Values | None:
        if below:
            return combined(_operation(tree), *below)
        return self.names[tree.name] if isinstance(tree, Name) else self.constant(_number(tree))

    def required(self, tree: Tree, needed: Values) -> list[Values | None]:
        """What each subtree would have to be worth for the tree to be worth what is needed; None where nothing does.

        An inverse sine is never more than a right angle, an absolute value never negative.
        """
        found = self._inverted(tree, needed)
        if not isinstance(tree, Power | Call):
            return found
        return [value if self._gives(tree, place, value, needed) else None for place, value in enumerate(found)]

    def _gives(self, tree: Power | Call, place: int, value: Values | None, needed: Values) -> bool:
        """Whether the tree is worth what is needed with this value of one of its subtrees."""
        operands = [value if other == place else self(child) for other, child in enumerate(children(tree))]
        return close(combined(_operation(tree), *operands), needed)

    def _inverted(self, tree: Tree, needed: Values) -> list[Values | None]:
        """The same by inverse functions, which do not give it where their branch is another."""
        match tree:
            case Sum():
                return [combined(sub, needed, rest) for rest in self._rests(tree)]
            case Product():
                return [combined(truediv, needed, rest) for rest in self._rests(tree)]
            case Quotient(above, below):
                return [combined(mul, needed, self(below)), combined(truediv, self(above), needed)]
            case Negation():
                return [combined(neg, needed)]
            case Power(base, exponent):
                return self._required_of_power(self(base), self(exponent), needed)
            case Call("atan2", (above, below)):
                slope = combined(math.tan, needed)
                return [combined(mul, slope, self(below)), combined(truediv, self(above), slope)]
            case Call("hypot", (first, second)):
                return [combined(_leg, needed, self(other), self(leg)) for leg, other in permutations((first, second))]
            case Call("abs", (argument,)):
                return [combined(math.copysign, needed, self(argument))]
            case Call(function) if function in INVERSES:
                return [combined(INVERSES[function], needed)]
            case _:
                return []

    def _rests(self, node: Sum | Product) -> list[Values | None]:
        """For each part, what the others make together."""
        before, after = self.running(node)
        return [combined(OPERATIONS[type(node)], *two) for two in zip(before, after[1:], strict=False)]

    def running(self, node: Sum | Product) -> tuple[Running, Running]:
        """What the parts before each place make together, and those from each place on."""
        if id(node) not in self._running:
            values = [self(part) for part in children(node)]
            before, after = self._accumulated(node, values), self._accumulated(node, values[::-1])
            self._running[id(node)] = node, before, after[::-1]
        return self._running[id(node)][1:]

    def _accumulated(self, node: Sum | Product, values: Sequence[Values | None]) -> Running:
        operation = OPERATIONS[type(node)]
        totals: Running = [self.constant(operation())]
        for value in values:
            totals.append(combined(operation, totals[-1], value))
        return totals

    @staticmethod
    def _required_of_power(bases: Values | None, exponents: Values | None, needed: Values) -> list[Values | None]:
        root = combined(_base, needed, exponents)
        is_even = exponents is not None and not any(exponent % 2 for exponent in exponents)
        return [combined(math.copysign, root, bases) if is_even else root, combined(_exponent, needed, bases)]


class Program:
    """A tree as a list of steps, which is run at one point after another in less time than a walk takes."""

    def __init__(self, tree: Tree) -> None:
        self._tree = tree  # lives as long as its nodes are known by their identity
        self._steps = steps([tree], (), _step, _key)

    def __call__(self, names: Mapping[str, float]) -> Values | None:
        """The value where the symbols have these values; None where it is no real number."""
        slots: list[float] = []
        try:
            for operation, operands in self._steps.steps:
                slots.append(operation(*[slots[place] for place in operands]) if operands else operation(names))
        except (ArithmeticError, TypeError, ValueError):
            return None
        value = slots[self._steps.results[0]]
        return (value,) if not isinstance(value, complex) else None


def _step(tree: Tree) -> tuple[Callable[..., float], Sequence[Tree]]:
    below = children(tree)
    return (_operation(tree) if below else _reader(tree)), below


def _key(tree: Tree) -> str | int:
    """Names are told apart by what they are, other nodes by their identity."""
    return tree.name if isinstance(tree, Name) else id(tree)


def _reader(tree: Tree) -> Callable[[Mapping[str, float]], float]:
    """What gives the value of a leaf."""
    if isinstance(tree, Name):
        return itemgetter(tree.name)
    number = _number(tree)
    return lambda _: number


def _leg(hypotenuse: float, other: float, leg: float) -> float:
    """The leg of a right triangle, with the sign that it has."""
    return math.copysign(math.sqrt(hypotenuse**2 - other**2), leg)


def _exponent(power: float, base: float) -> float:
    return math.log(power) / math.log(base)


def _base(power: float, exponent: float) -> float:
    if power < 0 and exponent % 2 == 1:
        return -math.pow(-power, 1 / exponent)
    return math.pow(power, 1 / exponent)
