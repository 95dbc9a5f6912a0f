"""How large the powers and numbers of a formula may become, decided before any algebra begins.

Degrees bound what expanding a formula could give: `(((x + 1)^64)^64)^64` is refused. The size of an exact number is known
before it is computed: so is `9^9^9^9`. Whatever has no symbol in it must have a real value of moderate magnitude.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from types import MappingProxyType
from typing import TypeAlias

from radartrack.derive.formula.error import FormulaError
from radartrack.derive.formula.functions import EXPONENTIAL
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

MAX_EXPONENT = 64
MAX_ROOT = 8  # the largest denominator of an exponent
MAX_DEGREE = 512  # of products and powers of powers, as if expanded
MAX_DIGITS = 4_000  # of an exact number that arises from others
LARGEST = Fraction(10) ** 300
SMALLEST = 1 / LARGEST

Value: TypeAlias = Fraction | float

_FUNCTIONS: MappingProxyType[str, Callable[..., Value]] = MappingProxyType(
    {
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
)


@dataclass(frozen=True, slots=True)
class Measure:
    """What is known of a subtree: its value, when no symbol occurs, and its degree, or of a number its digits."""

    size: int
    value: Value | None
    has_logarithm: bool


def check_magnitude(tree: Tree) -> None:
    """Refuse exponents, degrees and numbers that are too large, and numbers that are not real.

    Raises:
        FormulaError: naming the limit.
    """
    _measure(tree)


def _measure(tree: Tree) -> Measure:
    parts = [_measure(child) for child in children(tree)]
    if isinstance(tree, Power):
        _check_power(tree, *parts)
    if isinstance(tree, Call) and tree.function in EXPONENTIAL:
        _check_exponential(tree, parts[0])
    constant = not isinstance(tree, Name | Array) and all(part.value is not None for part in parts)
    size = _size(tree, parts, constant=constant)
    if size > (MAX_DIGITS if constant else MAX_DEGREE):
        raise FormulaError(_too_large(size, constant=constant), span=tree.span)
    value = _checked_value(tree, [part.value for part in parts if part.value is not None]) if constant else None
    logarithm = any(part.has_logarithm for part in parts)
    return Measure(size, value, logarithm or (isinstance(tree, Call) and tree.function == "log"))


def _too_large(size: int, *, constant: bool) -> str:
    if constant:
        return f"a number that arises here has some {size} digits; at most {MAX_DIGITS} are allowed"
    return f"expanded, this has degree {size}; at most {MAX_DEGREE} is allowed"


def _size(tree: Tree, parts: Sequence[Measure], *, constant: bool) -> int:
    sizes = [part.size for part in parts if constant or part.value is None]
    match tree:
        case Number(text):
            return len(text) + abs(int(text.lower().partition("e")[2] or 0))
        case Product() | Quotient():
            return sum(sizes)
        case Sum() if constant:
            return sum(sizes)
        case Power():
            return _size_of_power(parts[0], parts[1])
        case _:
            return max(sizes, default=1)


def _size_of_power(base: Measure, exponent: Measure) -> int:
    if isinstance(exponent.value, Fraction) and not isinstance(base.value, float):
        return max(1, math.ceil(base.size * abs(exponent.value)))
    return max(base.size, exponent.size)


def _check_power(tree: Power, base: Measure, exponent: Measure) -> None:
    natural = tree.base == Constant("e")
    if not isinstance(exponent.value, Fraction):
        _check_exponential(tree, exponent)
        if not (natural or (base.value is not None and base.value > 0)):
            raise FormulaError(
                "an exponent that is not a plain number is read only over e or a positive number",
                span=tree.exponent.span,
            )
    elif not natural and abs(exponent.value) > MAX_EXPONENT:
        raise FormulaError(f"exponents lie between -{MAX_EXPONENT} and {MAX_EXPONENT}", span=tree.exponent.span)
    elif not natural and exponent.value.denominator > MAX_ROOT:
        raise FormulaError(
            f"the denominator of an exponent is at most {MAX_ROOT}; this one is {exponent.value}"[:200],
            span=tree.exponent.span,
        )


def _check_exponential(tree: Tree, exponent: Measure) -> None:
    """Refuse exp(n*log(x)): it is x^n, past every limit on exponents."""
    if exponent.has_logarithm:
        raise FormulaError("an exponential of a logarithm is not read: write it as a power", span=tree.span)


def _checked_value(tree: Tree, operands: Sequence[Value]) -> Value:
    try:
        value = _value(tree, operands)
    except ZeroDivisionError:
        raise FormulaError("this divides by zero", span=tree.span) from None
    except OverflowError:
        raise FormulaError("a number that arises here is larger than 1e300", span=tree.span) from None
    except ValueError:
        value = math.nan
    if isinstance(value, complex) or math.isnan(value):
        raise FormulaError("this is not a real number", span=tree.span)
    if abs(value) > LARGEST:
        raise FormulaError("a number that arises here is larger than 1e300", span=tree.span)
    if _vanishes(tree, value, operands):
        raise FormulaError("a number that arises here is smaller than 1e-300", span=tree.span)
    return value


def _vanishes(tree: Tree, value: Value, operands: Sequence[Value]) -> bool:
    if value == 0:
        multiplies = isinstance(tree, Product | Quotient | Power) or tree == Call("exp", getattr(tree, "arguments", ()))
        return multiplies and 0 not in operands
    return abs(value) < SMALLEST


def _value(tree: Tree, operands: Sequence[Value]) -> Value:
    match tree:
        case Number():
            return tree.value
        case Constant(name):
            return math.pi if name == "pi" else math.e
        case Call(function):
            return _FUNCTIONS[function](*operands)
        case Sum():
            return sum(operands, Fraction(0))
        case Product():
            return math.prod(operands, start=Fraction(1))
        case Quotient():
            return operands[0] / operands[1]
        case Negation():
            return -operands[0]
        case Power():
            return operands[0] ** operands[1]
    raise AssertionError(tree)
