"""The values of printed trees, worked out by nothing that the checker uses: the oracle of its verdicts.

Complex numbers wherever a root or a logarithm needs them, principal branches, and several precisions, at each with
other errors by chance in every step: what rounding makes of a value shrinks with more digits, and a value that the
errors change is none.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from enum import Enum
from functools import reduce
from itertools import pairwise
from operator import mul, neg, truediv
from random import Random
from typing import Any

import mpmath

from radartrack.derive.formula.tree import (
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
from radartrack.derive.language.variable import Variable

DIGITS = (80, 200, 500, 1500)
SAME = 1e-45  # relative: more than the rounding of fifty digits, less than any slip
ROUNDING = 1e-100  # relative: of what two precisions settle
LARGEST = 1e5  # of exponents
Point = dict[str, float]


class No(Enum):
    """Why a formula has no real value somewhere."""

    UNREAL = "not real"
    UNDEFINED = "undefined"
    UNKNOWN = "not determined by rounding"


def worth(tree: Tree, point: Mapping[str, float]) -> Any:
    """The real value of a tree at a point to 60 digits or more, or why it has none."""
    before = _with_digits(tree, point, DIGITS[0], exact=True)
    if before is No.UNDEFINED:
        return before
    for fewer, digits in pairwise(DIGITS):
        after = _with_digits(tree, point, digits)
        found = _settled(before, after)
        if found is No.UNKNOWN and digits == DIGITS[-1] and _vanishes(before, after, digits - fewer):
            return mpmath.mpf(0)
        if found is not No.UNKNOWN:
            return found
        before = after
    return No.UNKNOWN


def same(first: Any, second: Any, *, beside: Any = 0, within: float = SAME) -> bool:
    """Whether two values are the same within a share of themselves, or of a larger one beside them."""
    with mpmath.workdps(DIGITS[-1]):
        return bool(abs(first - second) <= within * max(abs(first), abs(second), abs(beside)))


def soon_same(first: Tree, second: Tree, point: Mapping[str, float]) -> bool:
    """Whether two trees have the same real value in the fewest digits already: what rounding makes agrees never."""
    values = [_with_digits(tree, point, DIGITS[0], exact=True) for tree in (first, second)]
    return all(isinstance(value, mpmath.mpf) for value in values) and same(*values)


def inside(symbols: Sequence[Variable], point: Mapping[str, float]) -> bool:
    """Whether a point is in the domain."""
    return all(
        symbol.low <= point[symbol.name] <= symbol.high
        and (not symbol.whole or point[symbol.name].is_integer())
        and (symbol.at_most is None or point[symbol.name] <= point.get(symbol.at_most.name, math.inf))
        for symbol in symbols
    )


def anywhere(symbols: Sequence[Variable], random: Random) -> Point:
    """A point of the domain by chance: near the usual sizes or over all scales."""
    point = {symbol.name: _anywhere(symbol, random) for symbol in symbols}
    for symbol in symbols:
        if symbol.at_most is not None and symbol.at_most.name in point:
            point[symbol.name] = min(point[symbol.name], point[symbol.at_most.name])
    return point


def _anywhere(symbol: Variable, random: Random) -> float:
    low, high = symbol.low, symbol.high
    if random.random() < 0.4:
        low, high = max(low, -5.0), min(high, 9.0)
    if low >= high:
        low, high = symbol.low, symbol.high
    value = math.exp(random.uniform(math.log(low), math.log(high))) if low > 0 else random.uniform(low, high)
    return float(min(max(round(value), symbol.low), symbol.high)) if symbol.whole else value


def _settled(before: Any, after: Any) -> Any:
    """What two precisions say of a value."""
    if isinstance(before, No) or isinstance(after, No):
        return after if before is after else No.UNKNOWN
    if abs(mpmath.im(after)) > max(1e-30 * abs(after), abs(mpmath.im(before)) / 1e6):
        steady = abs(mpmath.im(after) - mpmath.im(before)) <= 1e-9 * abs(mpmath.im(after))
        return No.UNREAL if steady else No.UNKNOWN
    after, before = mpmath.re(after), mpmath.re(before)
    return after if abs(after - before) <= 1e-30 * abs(after) else No.UNKNOWN


def _vanishes(before: Any, after: Any, more_digits: int) -> bool:
    """Whether a value is rounding alone: with more digits it is by all of them smaller, unlike a small difference."""
    if isinstance(before, No) or isinstance(after, No):
        return False
    return bool(abs(after) < 1e-60 and abs(after) <= mpmath.mpf(10) ** (-0.9 * more_digits) * abs(before))


def _with_digits(tree: Tree, point: Mapping[str, float], digits: int, *, exact: bool = False) -> Any:
    known: dict[int, Any] = {}

    errors = Random(digits)

    def value(node: Tree) -> Any:
        if id(node) not in known:
            found = _value(node, [value(child) for child in children(node)], point)
            error = errors.choice((-1, 1)) * errors.uniform(0.3, 1) if children(node) and not exact else 0
            known[id(node)] = _plain(found * (1 + error * mpmath.mpf(10) ** (4 - digits)), digits)
        return known[id(node)]

    with mpmath.workdps(digits):
        try:
            found = value(tree)
        except OverflowError:
            return No.UNKNOWN
        except (ZeroDivisionError, ValueError):
            return No.UNDEFINED
        return found if mpmath.isfinite(found) else No.UNDEFINED


def _plain(value: Any, digits: int) -> Any:
    """Without the part of a complex number that is rounding: it would choose the branch of what follows."""
    if not isinstance(value, mpmath.mpc):
        return value
    real, imaginary = abs(value.real), abs(value.imag)
    nothing = mpmath.mpf(10) ** (20 - digits) * (real + imaginary)
    if imaginary <= nothing:
        return value.real
    return mpmath.mpc(0, value.imag) if real <= nothing else value


def _value(node: Tree, below: Sequence[Any], point: Mapping[str, float]) -> Any:
    match node:
        case Number(text):
            return mpmath.mpf(text)
        case Constant(name):
            return +mpmath.pi if name == "pi" else +mpmath.e
        case Name(name):
            return mpmath.mpf(point[name])
        case Power(_, exponent):
            return _power(below[0], below[1], exponent)
        case Call(function):
            return _CALLS[function](*below)
        case _:
            return _OPERATIONS[type(node)](*below)


_OPERATIONS: Mapping[type, Callable[..., Any]] = {
    Sum: lambda *terms: sum(terms),
    Product: lambda *factors: reduce(mul, factors),
    Quotient: truediv,
    Negation: neg,
}


def _power(base: Any, exponent: Any, tree: Tree) -> Any:
    if isinstance(tree, Number) and tree.value.denominator == 1:
        return base ** int(tree.value)
    if not base:
        return mpmath.mpf(0) if mpmath.re(exponent) > 0 else 1 / base
    return _exp(exponent * mpmath.log(base)) if exponent != int(mpmath.re(exponent)) else base ** int(exponent)


def _exp(value: Any) -> Any:
    if abs(value) > LARGEST:
        raise OverflowError
    return mpmath.exp(value)


def _root(value: Any) -> Any:
    return mpmath.sqrt(value)


def _angle(above: Any, beside: Any) -> Any:
    if isinstance(above, mpmath.mpf) and isinstance(beside, mpmath.mpf):
        if not above and not beside:
            raise ZeroDivisionError
        return mpmath.atan2(above, beside)
    return -1j * mpmath.log((beside + 1j * above) / _root(above**2 + beside**2))


_CALLS: dict[str, Callable[..., Any]] = {
    "abs": abs,
    "acos": mpmath.acos,
    "asin": mpmath.asin,
    "atan": mpmath.atan,
    "atan2": _angle,
    "cos": lambda x: (_exp(1j * x) + _exp(-1j * x)) / 2 if isinstance(x, mpmath.mpc) else mpmath.cos(x),
    "cosh": lambda x: (_exp(x) + _exp(-x)) / 2,
    "cot": lambda x: 1 / mpmath.tan(x),
    "coth": lambda x: 1 / mpmath.tanh(x),
    "csc": lambda x: 1 / mpmath.sin(x),
    "exp": _exp,
    "expm1": lambda x: _exp(x) - 1,
    "hypot": lambda x, y: _root(x * x + y * y),
    "log": mpmath.log,
    "sec": lambda x: 1 / mpmath.cos(x),
    "sin": lambda x: (_exp(1j * x) - _exp(-1j * x)) / 2j if isinstance(x, mpmath.mpc) else mpmath.sin(x),
    "sinh": lambda x: (_exp(x) - _exp(-x)) / 2,
    "sqrt": _root,
    "tan": mpmath.tan,
    "tanh": mpmath.tanh,
}
