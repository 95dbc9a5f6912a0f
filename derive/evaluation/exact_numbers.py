"""Numbers that are compared exactly: by enclosures of many digits, and by algebra where these do not tell."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import cached_property, lru_cache

import mpmath

from radartrack.derive import symbolic as sp
from radartrack.derive.algebra.equality import proved_equal
from radartrack.derive.evaluation.many_digits import DIGITS, GUARD, Evaluator, Number
from radartrack.derive.formula.to_expression import is_real
from radartrack.derive.language.tensor import Tensor
from radartrack.derive.symbolic import Expr, Symbol

FINER = 150  # digits carried beyond the first ones to see how many of these are rounding
LADDER = (600, 2400)  # digits carried where fewer do not tell


class NoRealValue(ArithmeticError):
    """A formula is infinite or imaginary where its value is wanted."""


class Undecidable(ArithmeticError):
    """Two numbers agree in all digits that were computed, and nothing proves them equal."""


class Exact:
    """A number: a formula whose symbols have exact values.

    Args:
        function: the formula.
        values: closed expressions for its symbols.
    """

    def __init__(self, function: Function, values: Mapping[Symbol, Expr]) -> None:
        self._function = function
        self._values = values
        self._known: dict[int, Number] = {}

    @classmethod
    def of(cls, closed: Expr) -> Exact:
        """The number that an expression without symbols is."""
        return cls(Function(closed, ()), {})

    @cached_property
    def closed(self) -> Expr:
        """The formula with the values put in.

        Raises:
            NoRealValue: where it is infinite or undefined.
        """
        closed = self._function.expression.xreplace(self._values)
        if not is_real(closed):
            raise NoRealValue
        return closed

    def value(self, more_digits: int = 0) -> Number:
        """The value in so many digits more than usual.

        Raises:
            NoRealValue: where it is infinite or imaginary.
        """
        if more_digits not in self._known:
            self._known[more_digits] = self._function.evaluated(self._values, more_digits)
        return self._known[more_digits]


class Function:
    """A formula of symbols, prepared for evaluation at many points."""

    def __init__(self, expression: Expr, symbols: Sequence[Symbol]) -> None:
        self.expression = expression
        self._symbols = symbols
        self._evaluator = Evaluator(Tensor((), (expression,)), symbols)

    def at(self, values: Mapping[Symbol, Expr]) -> Exact:
        """The number at one point; what the formula does not need may be left out."""
        return Exact(self, values)

    def evaluated(self, values: Mapping[Symbol, Expr], more: int) -> Number:
        """The value there, with so many digits more than usual.

        Raises:
            NoRealValue: where it is infinite or imaginary.
        """
        point = [_evaluated(values.get(symbol, sp.Integer(0)), more) for symbol in self._symbols]
        try:
            value = self._evaluator(point, more).entries[0]
        except (ArithmeticError, ValueError):
            raise NoRealValue from None
        if isinstance(value, mpmath.mpc):
            if abs(value.imag) > abs(value) * mpmath.mpf(10) ** -DIGITS:
                raise NoRealValue
            value = value.real
        if not mpmath.isfinite(value):
            raise NoRealValue
        return value


def compared(first: Exact, second: Exact) -> int:
    """-1, 0 or 1 as the first is less than, equal to or more than the second.

    Raises:
        Undecidable: where they agree in thousands of digits and are not proved equal.
    """
    return sign_of(lambda one, other: one - other, first, second)


def order(first: Expr, second: Expr) -> int:
    """The same of two closed expressions; at once where both are rational.

    Raises:
        Undecidable: as `compared`.
    """
    if isinstance(first, sp.Rational) and isinstance(second, sp.Rational):
        return bool(first > second) - bool(first < second)
    return compared(Exact.of(first), Exact.of(second))


def sign_of(combination: Callable[..., Number], *numbers: Exact) -> int:
    """The sign of a polynomial in these numbers, one that takes digits as well as expressions.

    Raises:
        Undecidable: where it vanishes in thousands of digits and is not proved to.
    """
    found = _sign(combination, numbers, 0, FINER)
    if found is not None:
        return found
    difference = combination(*(number.closed for number in numbers))
    if isinstance(difference, sp.Rational):
        return bool(difference > 0) - bool(difference < 0)
    for fewer, more in zip((FINER, *LADDER), LADDER, strict=False):
        found = _sign(combination, numbers, fewer, more)
        if found is not None:
            return found
    if proved_equal(difference, sp.Integer(0)):
        return 0
    raise Undecidable(f"they agree to {LADDER[-1]} digits, and nothing proves them equal")


def _sign(combination: Callable[..., Number], numbers: Sequence[Exact], fewer: int, more: int) -> int | None:
    """From values of two precisions, whose difference bounds the rounding; None where zero is not excluded."""
    with mpmath.workdps(DIGITS + GUARD + more):
        rough, fine = (combination(*(number.value(digits) for number in numbers)) for digits in (fewer, more))
        radius = 2 * abs(fine - rough)
    return None if abs(fine) <= radius else 1 if fine > 0 else -1


@lru_cache(maxsize=256)
def _evaluated(closed: Expr, more: int) -> Number:
    return Evaluator(Tensor((), (closed,)), ())((), more).entries[0]
