"""Recognises values that are a simple number times powers of known factors."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction

from radartrack.derive.evaluation.tree_values import Values, close
from radartrack.derive.formula.tree import Call, Negation, Number, Power, Product, Quotient, Tree

# Numbers and powers as formulas of the field have them (the finite-sample filters have the largest); beyond, noise of a
# part in 1e9 fits some fraction, and every ratio would be "a number".
LARGEST_DENOMINATOR = 10_000
LARGEST_NUMERATOR = 10_000
LARGEST_POWER = 6
SPARE = 3  # points beyond the unknowns, so that a fit means something
INDEPENDENT = 1e-3  # of a factor's logarithm that earlier ones leave; less, and its power is made of rounding
EXACT = 1e-6  # how far a power may be from a whole number: values are good to 1e-10, the system costs four digits


@dataclass(frozen=True)
class Monomial:
    """A number times powers."""

    number: Fraction
    powers: tuple[tuple[Tree, int], ...]

    @property
    def is_number(self) -> bool:
        """Whether there is nothing but the number."""
        return not self.powers

    @property
    def complexity(self) -> float:
        """How much there is to write."""
        number = 0 if abs(self.number) == 1 else 1 if abs(self.number) in _COMMON else 2
        return number + sum(abs(power) for _, power in self.powers)

    def tree(self) -> Tree:
        """The monomial without its sign."""
        number = abs(self.number)
        above = [_power(base, power) for base, power in self.powers if power > 0]
        below = [_power(base, -power) for base, power in self.powers if power < 0]
        if number.numerator != 1:
            above.insert(0, Number(str(number.numerator)))
        if number.denominator != 1:
            below.insert(0, Number(str(number.denominator)))
        numerator = product(above)
        return Quotient(numerator, product(below)) if below else numerator

    def signed(self) -> Tree:
        """The monomial."""
        return Negation(self.tree()) if self.number < 0 else self.tree()


_COMMON = {Fraction(2), Fraction(1, 2)}


class Fitter:
    """Fits monomials in some factors, all positive at the points, to values there.

    Args:
        factors: trees with their values; those that depend on earlier ones are left out.
        size: how many points there are.
    """

    def __init__(self, factors: Sequence[tuple[Tree, Values]], size: int) -> None:
        self._one = (1.0,) * size
        self._factors: list[tuple[Tree, Values]] = []
        self._columns: list[Values] = []
        self._directions: list[Values] = []
        self._add(self._one)
        for tree, values in factors:
            if len(self._columns) + SPARE < size and all(value > 0 for value in values):
                self._add_factor(tree, values)
        axes = [tuple(float(place == axis) for place in range(size)) for axis in range(size)]
        self._normal = max(map(self._beside, axes), key=lambda rest: _dot(rest, rest))

    def fit(self, values: Values | None) -> Monomial | None:
        """The monomial with these values, if there is one."""
        if values is None or not all(values) or len({value > 0 for value in values}) > 1:
            return None
        logarithms = tuple(math.log(abs(value)) for value in values)
        if abs(_dot(self._normal, logarithms)) > EXACT:
            return None
        solution = self._solve(logarithms)
        powers = [round(power) for power in solution[1:]]
        if any(abs(p - q) > EXACT or abs(q) > LARGEST_POWER for p, q in zip(solution[1:], powers, strict=True)):
            return None
        number = simple_number(math.exp(solution[0]) if abs(solution[0]) < 50 else 0.0)
        if number is None:
            return None
        found = tuple((tree, power) for (tree, _), power in zip(self._factors, powers, strict=True) if power)
        sign = 1 if values[0] > 0 else -1
        monomial = Monomial(number * sign, found)
        return monomial if close(self._values(monomial, powers), values) else None

    def _values(self, monomial: Monomial, powers: Sequence[int]) -> Values:
        result = [float(monomial.number)] * len(self._one)
        for (_, values), power in zip(self._factors, powers, strict=True):
            result = [total * value**power for total, value in zip(result, values, strict=True)]
        return tuple(result)

    def _add_factor(self, tree: Tree, values: Values) -> None:
        if self._add(tuple(map(math.log, values))):
            self._factors.append((tree, values))

    def _add(self, column: Values) -> bool:
        rest = self._beside(column)
        length = math.sqrt(_dot(rest, rest))
        if length < INDEPENDENT * (math.sqrt(_dot(column, column)) or 1.0):
            return False
        self._columns.append(column)
        self._directions.append(tuple(value / length for value in rest))
        return True

    def _beside(self, column: Values) -> Values:
        """What is left of a column beside the known ones; projected twice, as rounding spoils the first."""
        rest = column
        for direction in 2 * self._directions:
            rest = _less(rest, direction, _dot(rest, direction))
        return rest

    def _solve(self, values: Values) -> list[float]:
        """Least squares through the orthonormal directions, by back substitution."""
        solution = [0.0] * len(self._columns)
        rest = values
        for place in reversed(range(len(self._columns))):
            direction = self._directions[place]
            solution[place] = _dot(rest, direction) / _dot(self._columns[place], direction)
            rest = _less(rest, self._columns[place], solution[place])
        return solution


def simple_number(value: float) -> Fraction | None:
    """A positive number as a fraction with few digits, if it is one."""
    if not 1e-6 < value < 1e6:
        return None
    number = Fraction(value).limit_denominator(LARGEST_DENOMINATOR)
    simple = abs(number.numerator) <= LARGEST_NUMERATOR
    return number if simple and number and abs(float(number) / value - 1) < EXACT else None


def number_tree(number: Fraction) -> Tree:
    """A rational number as it is written."""
    size = abs(number)
    above = Number(str(size.numerator))
    tree: Tree = above if size.denominator == 1 else Quotient(above, Number(str(size.denominator)))
    return Negation(tree) if number < 0 else tree


def product(factors: Sequence[Tree]) -> Tree:
    """Factors side by side; 1 for none."""
    if not factors:
        return Number("1")
    return factors[0] if len(factors) == 1 else Product(tuple(factors))


def _power(base: Tree, power: int) -> Tree:
    if power == 1:
        return base
    if isinstance(base, Call) and base.function == "exp":
        return Call("exp", (Product((Number(str(power)), *base.arguments)),))
    return Power(base, Number(str(power)))


def _dot(first: Values, second: Values) -> float:
    return sum(map(float.__mul__, first, second))


def _less(first: Values, second: Values, factor: float) -> Values:
    return tuple(a - factor * b for a, b in zip(first, second, strict=True))
