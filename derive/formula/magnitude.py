"""How large the powers and numbers of a formula may become, decided before any algebra begins.

Degrees bound what expanding a formula could give: `(((x + 1)^64)^64)^64` is refused. The digits of an exact
number are counted before it is computed: so is `9^9^9^9`. What has no symbol in it must be real and of
moderate size.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from types import MappingProxyType
from typing import TypeAlias

from radartrack.derive.formula.error import FormulaError
from radartrack.derive.formula.fold import Fold
from radartrack.derive.formula.functions import EXPONENTIAL, VERBS
from radartrack.derive.formula.tree import (
    Array,
    Call,
    Constant,
    Entries,
    Name,
    Negation,
    Number,
    Power,
    Product,
    Quotient,
    Sum,
    Tree,
)

MAX_EXPONENT = 64
MAX_ROOT = 8  # the largest denominator of an exponent
MAX_DEGREE = 512  # of products and powers of powers, as if expanded
MAX_DIGITS = 10_000  # of all exact numbers together
LARGEST = Fraction(10) ** 300
SMALLEST = 1 / LARGEST
INFINITY = Constant("inf")

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
    """What is known of a subtree.

    Attributes:
        degree: in the symbols, were it expanded.
        digits: bound on those of its exact numbers together, were it expanded.
        value: what it is worth, when no symbol occurs.
        has_logarithm: whether one occurs.
        is_infinite: whether it is infinity, where a limit goes.
    """

    degree: int
    digits: int
    value: Value | None
    has_logarithm: bool
    is_infinite: bool = False


_SYMBOL = Measure(degree=1, digits=0, value=None, has_logarithm=False)
_INFINITY = Measure(degree=0, digits=1, value=None, has_logarithm=False, is_infinite=True)


def magnitudes(names: Mapping[str, Measure] = MappingProxyType({})) -> Fold[Measure]:
    """Measures formulas; what two of them share is measured once.

    Args:
        names: what is known of names that are defined; the others are symbols.

    What it returns refuses exponents, degrees and numbers that are too large, and numbers that are not real: it
    raises `FormulaError`, naming the limit.
    """

    def step(tree: Tree, parts: Sequence[Measure]) -> Measure:
        known = names.get(tree.name) if isinstance(tree, Name) else None
        return known or _measure(tree, parts)

    return Fold(step)


def _measure(tree: Tree, parts: Sequence[Measure]) -> Measure:
    if isinstance(tree, Name):
        return _SYMBOL
    if tree == INFINITY or (isinstance(tree, Negation) and parts[0].is_infinite):
        return _INFINITY
    if any(part.is_infinite for part in parts) and not (isinstance(tree, Call) and tree.function == "limit"):
        raise FormulaError("inf stands only where a limit goes, limit(f, x, inf)", span=tree.span)
    if isinstance(tree, Power):
        _check_power(tree, *parts)
    if isinstance(tree, Call) and tree.function in EXPONENTIAL:
        _check_exponential(tree, parts[0])
    degree, digits = _degree(tree, parts), _digits(tree, parts)
    if degree > MAX_DEGREE:
        raise FormulaError(f"expanded, this has degree {degree}; at most {MAX_DEGREE} is allowed", span=tree.span)
    if digits > MAX_DIGITS:
        raise FormulaError(
            f"the numbers that arise here have some {digits} digits; at most {MAX_DIGITS} are allowed",
            span=tree.span,
        )
    values = [part.value for part in parts if part.value is not None]
    constant = len(values) == len(parts) and not _is_worked_out(tree)
    logarithm = any(part.has_logarithm for part in parts) or (isinstance(tree, Call) and tree.function == "log")
    return Measure(degree, digits, _checked_value(tree, values) if constant else None, logarithm)


def _is_worked_out(tree: Tree) -> bool:
    """Whether it is an array, or made of one by a verb: no number that is known at once."""
    return isinstance(tree, Array | Entries) or (isinstance(tree, Call) and tree.function in VERBS)


def _degree(tree: Tree, parts: Sequence[Measure]) -> int:
    degrees = [part.degree for part in parts]
    match tree:
        case Product() | Quotient():
            return sum(degrees)
        case Power() if isinstance(parts[1].value, Fraction):
            return math.ceil(degrees[0] * abs(parts[1].value))
        case _:
            return max(degrees, default=0)


def _digits(tree: Tree, parts: Sequence[Measure]) -> int:
    digits = [part.digits for part in parts]
    match tree:
        case Number(text):
            return len(text) + abs(int(text.lower().partition("e")[2] or 0))
        case Constant():
            return 1
        case Power() if isinstance(parts[1].value, Fraction):
            return max(digits[0], math.ceil(digits[0] * abs(parts[1].value)))
        case _:
            return sum(digits)


def _check_power(tree: Power, base: Measure, exponent: Measure) -> None:
    if tree.base == Constant("e") or not isinstance(exponent.value, Fraction):
        _check_exponential(tree, exponent)
    if tree.base == Constant("e"):
        return
    span = tree.exponent.span
    if not isinstance(exponent.value, Fraction):
        is_positive = base.value is not None and base.value > 0
        if not is_positive and not isinstance(tree.base, Name):  # a name may stand for something positive
            raise FormulaError(
                "an exponent that is no plain number is read only over e, a positive number or a name", span=span
            )
    elif abs(exponent.value) > MAX_EXPONENT:
        raise FormulaError(f"exponents lie between -{MAX_EXPONENT} and {MAX_EXPONENT}", span=span)
    elif exponent.value.denominator > MAX_ROOT:
        raise FormulaError(f"the denominator of an exponent is at most {MAX_ROOT}", span=span)


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
        raise FormulaError("this is not a real number", span=tree.span) from None
    if isinstance(value, complex):
        raise FormulaError("this is not a real number", span=tree.span)
    if not -LARGEST <= value <= LARGEST:
        raise FormulaError("a number that arises here is larger than 1e300", span=tree.span)
    if _vanishes(tree, value, operands):
        raise FormulaError("a number that arises here is smaller than 1e-300", span=tree.span)
    return value


def _vanishes(tree: Tree, value: Value, operands: Sequence[Value]) -> bool:
    if value == 0:
        exponential = isinstance(tree, Call) and tree.function == "exp"
        return (exponential or isinstance(tree, Product | Quotient | Power)) and 0 not in operands
    return -SMALLEST < value < SMALLEST


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
        case _:  # a power: arrays have no value
            return operands[0] ** operands[1]
