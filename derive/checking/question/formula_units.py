"""The dimension of a printed formula: metres and seconds strictly, angles where something can be said.

A derivative of a sine takes a radian away without a trace in print, so the sum r²σ_β² sin²β + σ_r² cos²β mixes rad²
and 1 and is right. Angles are therefore not compared between terms. What is checked: sines and cosines take an
angle, never an angle squared; exponentials and hyperbolic functions take a number or an even power of an angle, as
variances are.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction

from radartrack.derive.checking.question.definitions.known_constants import has_any_unit
from radartrack.derive.formula.fold import Fold
from radartrack.derive.formula.printing import to_text
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
    rational_value,
)
from radartrack.derive.units import Unit

SHOWN = 60


class WrongDimensions(ValueError):
    """Terms of different dimension are added, or a function is given what it cannot take."""


class WrongDefinition(WrongDimensions):
    """The same inside a definition, which the message names."""


def in_definition(what: str, error: WrongDimensions) -> WrongDefinition:
    """The error as one of a definition, unless it is one already."""
    return error if isinstance(error, WrongDefinition) else WrongDefinition(f"{what}: {error}")


@dataclass(frozen=True, slots=True)
class Dimension:
    """Powers of metre and second, and of the radian where it is known.

    `free` marks a number on its own, which may stand for a value in any unit; `zero` one that is nothing in any unit,
    beside which terms of every dimension may stand.
    """

    metre: Fraction = Fraction(0)
    second: Fraction = Fraction(0)
    radian: Fraction | None = Fraction(0)
    free: bool = False
    zero: bool = False

    @classmethod
    def of(cls, unit: Unit) -> Dimension:
        """That of a unit."""
        return cls(unit.metre, unit.second, unit.radian)

    def __mul__(self, other: Dimension) -> Dimension:
        radian = None if self.radian is None or other.radian is None else self.radian + other.radian
        free, zero = self.free and other.free, self.zero or other.zero
        return Dimension(self.metre + other.metre, self.second + other.second, radian, free, zero)

    def __pow__(self, exponent: Fraction | int) -> Dimension:
        radian = None if self.radian is None else self.radian * exponent
        return Dimension(self.metre * exponent, self.second * exponent, radian, self.free, self.zero and exponent > 0)

    @property
    def is_number(self) -> bool:
        """Whether it has neither metres nor seconds."""
        return not self.metre and not self.second

    def agrees(self, other: Dimension) -> bool:
        """Whether both have the same metres and seconds, or one is nothing."""
        return self.zero or other.zero or (self.metre, self.second) == (other.metre, other.second)

    def __str__(self) -> str:
        if self.is_number:
            return "no unit" if not self.radian else str(Unit(radian=self.radian))
        return str(Unit(self.metre, self.second))


FREE = Dimension(free=True)
NOTHING = Dimension(free=True, zero=True)
ANYTHING = Dimension(radian=None, free=True, zero=True)
UNKNOWN = Dimension(radian=None, free=True)
ANGLE = Dimension(radian=Fraction(1))
_PERIODIC = {"cos", "cot", "csc", "sec", "sin", "tan"}
_GROWING = {"cosh", "coth", "exp", "expm1", "sinh", "tanh"}
_TO_ANGLE = {"acos", "asin", "atan"}


def dimensions(known: Mapping[str, Dimension]) -> Fold[Dimension]:
    """Finds the dimensions of scalar formulas in names of known dimension.

    What it returns raises `WrongDimensions` for a formula that has none.
    """

    def step(tree: Tree, below: Sequence[Dimension]) -> Dimension:
        if isinstance(tree, Name):
            return known[tree.name]
        return NOTHING if _is_zero(tree) else _dimension(tree, below)

    return Fold(step)


def misfits(tree: Tree, known: Mapping[str, Dimension]) -> tuple[Dimension, int]:
    """The dimension of a formula, and how many of its parts have none; these fit into whatever they stand in."""
    count = 0

    def step(node: Tree, below: Sequence[Dimension]) -> Dimension:
        nonlocal count
        if isinstance(node, Name):
            return known.get(node.name, ANYTHING)
        try:
            return NOTHING if _is_zero(node) else _dimension(node, below)
        except WrongDimensions:
            count += 1
            return ANYTHING

    return Fold(step)(tree), count


def check_dimension(found: Dimension, expected: Dimension) -> None:
    """Compare the dimension of a formula with that of a quantity.

    Raises:
        WrongDimensions: saying what does not fit.
    """
    if not found.free and not found.agrees(expected):
        raise WrongDimensions(f"the formula has {_unit(found)}, the quantity {_unit(expected)}")


def _unit(dimension: Dimension) -> str:
    """In words after "has"."""
    return str(dimension) if dimension.is_number and not dimension.radian else f"the unit {dimension}"


def _dimension(tree: Tree, below: Sequence[Dimension]) -> Dimension:
    match tree:
        case Sum(terms):
            return _sum(terms, below)
        case Product():
            return _product(below)
        case Quotient():
            return below[0] * below[1] ** -1
        case Negation():
            return below[0]
        case Power(base, exponent):
            return _power(base, exponent, *below)
        case Call(function, arguments):
            return _call(function, arguments, below)
        case Number() if has_any_unit(tree):
            return ANYTHING
        case Array():
            raise WrongDimensions("an array has no dimension of its own")
        case _:
            return FREE


def _product(parts: Sequence[Dimension]) -> Dimension:
    result = FREE
    for part in parts:
        result = result * part
    return result


def _sum(terms: Sequence[Tree], below: Sequence[Dimension]) -> Dimension:
    both = zip(terms, below, strict=True)
    found = [(term, dimension) for term, dimension in both if not dimension.zero]
    if not found:
        return NOTHING
    first_term, first = found[0]
    for term, dimension in found[1:]:
        if not dimension.agrees(first):
            raise WrongDimensions(f"{_shown(first_term)} [{first}] and {_shown(term)} [{dimension}] cannot be added")
    radians = {dimension.radian for _, dimension in found}
    radian = radians.pop() if len(radians) == 1 else None
    return Dimension(first.metre, first.second, radian, all(dimension.free for _, dimension in found))


def _power(base: Tree, exponent: Tree, dimension: Dimension, power: Dimension) -> Dimension:
    if base == Constant("e"):
        return _call("exp", (exponent,), (power,))
    if not power.is_number:
        raise WrongDimensions(f"the exponent {_shown(exponent)} has the unit {power}")
    value = rational_value(exponent)
    if value is None:
        if not dimension.is_number:
            raise WrongDimensions(f"{_shown(base)} has the unit {dimension} and a variable exponent")
        return Dimension(radian=None)
    return dimension**value


def _call(function: str, arguments: Sequence[Tree], given: Sequence[Dimension]) -> Dimension:
    if function == "abs":
        return given[0]
    if function == "sqrt":
        return given[0] ** Fraction(1, 2)
    if function in {"atan2", "hypot"}:
        return _pair(function, arguments, given)
    _check_argument(function, arguments[0], given[0])
    return ANGLE if function in _TO_ANGLE else FREE if given[0].free else Dimension()


def _pair(function: str, arguments: Sequence[Tree], given: Sequence[Dimension]) -> Dimension:
    if not given[0].agrees(given[1]):
        raise WrongDimensions(
            f"{function} takes two of one unit, {_shown(arguments[0])} has {given[0]}, "
            f"{_shown(arguments[1])} has {given[1]}"
        )
    return (given[1] if given[0].zero else given[0]) if function == "hypot" else ANGLE


def _check_argument(function: str, argument: Tree, given: Dimension) -> None:
    if not given.is_number or not _ANGLES.get(function, _any)(given.radian):
        wanted = _WANTED.get(function, "a number")
        raise WrongDimensions(f"{function} takes {wanted}; {_shown(argument)} has the unit {given}")


def _angle(radian: Fraction | None) -> bool:
    return radian is None or radian in {0, 1}


def _even(radian: Fraction | None) -> bool:
    return radian is None or radian % 2 == 0


def _any(_radian: Fraction | None) -> bool:
    return True


_ANGLES: Mapping[str, Callable[[Fraction | None], bool]] = dict.fromkeys(_PERIODIC, _angle) | dict.fromkeys(
    _GROWING, _even
)
_WANTED = dict.fromkeys(_PERIODIC, "an angle") | dict.fromkeys(_GROWING, "a number or an angle squared")


def _is_zero(tree: Tree) -> bool:
    return rational_value(tree) == 0


def _shown(tree: Tree) -> str:
    text = to_text(tree)
    return text if len(text) <= SHOWN else f"{text[: SHOWN - 3]}..."
