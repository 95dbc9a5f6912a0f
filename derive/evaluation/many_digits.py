"""Evaluates formulas as they were derived in arithmetic of many digits, the yardstick for generated code."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from itertools import cycle
from typing import Any

import mpmath

from radartrack.derive import symbolic as sp
from radartrack.derive.evaluation.steps import steps
from radartrack.derive.language.tensor import Tensor
from radartrack.derive.symbolic import Expr, Symbol

DIGITS = 50
GUARD = 90  # an unstable textbook form may lose as many digits as a fourth power of 1e-9 against 1e8 squared
Number = Any

LARGEST_EXPONENT = 1e6
DIGITS_OF_AN_ANGLE = 10_000  # before the point: for as many more pi is not soon known
RESIDUE = 30  # of the digits carried, those that rounding may reach in the part of a complex number that is zero


NOISE = (1, -3, 5, -2, 7, -5, 3, -1, 2, -7, 4)  # what is added to one result after the other, in units of a last digit
LAST = 4  # digits from the last of those carried to that one


class NotComputed(ArithmeticError):
    """A formula holds a function or a constant that is not evaluated here."""


def _growing(function: Callable[[Number], Number]) -> Callable[[Number], Number]:
    """The function, refusing arguments at which it would take for ever."""

    def bounded(argument: Number) -> Number:
        if abs(argument) > LARGEST_EXPONENT:
            raise OverflowError(f"the exponential of {mpmath.nstr(argument, 3)} is not evaluated")
        return function(argument)

    return bounded


def _turning(function: Callable[[Number], Number]) -> Callable[[Number], Number]:
    """The function of an angle, refusing those for which whole turns take for ever to take off."""

    def bounded(angle: Number) -> Number:
        if mpmath.mag(angle) > DIGITS_OF_AN_ANGLE * math.log2(10):
            raise OverflowError(f"an angle of more than {DIGITS_OF_AN_ANGLE} digits is not turned back")
        return function(angle)

    return bounded


def _hypot(first: Number, second: Number) -> Number:
    return mpmath.sqrt(first * first + second * second)


def _atan2(above: Number, beside: Number) -> Number:
    """Of complex numbers, which the root of a negative one gives, by the logarithm; mpmath's own is for real ones."""
    if isinstance(above, mpmath.mpf) and isinstance(beside, mpmath.mpf):
        return mpmath.atan2(above, beside)
    return -mpmath.j * mpmath.log((beside + mpmath.j * above) / _hypot(above, beside))


def _direction(above: Number, beside: Number) -> Number:
    """The angle of a direction, where there is one."""
    if not (above or beside):
        raise ZeroDivisionError("no direction: atan2(0, 0)")
    return _atan2(above, beside)


def _remainder(argument: Number, order: Number) -> Number:
    return mpmath.exp(argument) - sum(argument**n / mpmath.factorial(n) for n in range(int(order)))


def _stumpff(argument: Number, order: Number) -> Number:
    """c_n of the square: where the argument is small, in as many more digits as the closed form loses."""
    n = int(order)
    if not argument:
        return 1 / mpmath.factorial(n)
    with mpmath.extradps(max(0, -n * int(mpmath.floor(mpmath.log10(abs(argument)))))):
        square, value = argument * argument, mpmath.sin(argument) / argument if n % 2 else mpmath.cos(argument)
        for k in range(n % 2, n, 2):
            value = (1 / mpmath.factorial(k) - value) / square
    return +value


def _third(argument: Number) -> Number:
    if argument > 1:
        return mpmath.cosh(mpmath.acosh(argument) / 3)
    return mpmath.cos(mpmath.acos(argument) / 3)


# Those that formulas are written with, and those that SymPy makes of them.
_FUNCTIONS: dict[type[Expr], Callable[..., Number]] = {
    sp.Abs: mpmath.fabs,
    sp.Heaviside: lambda value, at_zero: (1 + mpmath.sign(value)) / 2 if value else at_zero,
    sp.acos: mpmath.acos,
    sp.acot: mpmath.acot,
    sp.acoth: mpmath.acoth,
    sp.acsc: mpmath.acsc,
    sp.arg: mpmath.arg,
    sp.asec: mpmath.asec,
    sp.asin: mpmath.asin,
    sp.asinh: mpmath.asinh,
    sp.atan: mpmath.atan,
    sp.atan2: _atan2,
    sp.atanh: mpmath.atanh,
    sp.below: lambda value, limit: mpmath.mpf(int(value < limit)),
    sp.conjugate: mpmath.conj,
    sp.cos: _turning(mpmath.cos),
    sp.cosh: _growing(mpmath.cosh),
    sp.cot: _turning(mpmath.cot),
    sp.coth: mpmath.coth,
    sp.csc: _turning(mpmath.csc),
    sp.csch: _growing(mpmath.csch),
    sp.erf: mpmath.erf,
    sp.exp: _growing(mpmath.exp),
    sp.expm1: _growing(mpmath.expm1),
    sp.hypot: _hypot,
    sp.im: mpmath.im,
    sp.log: mpmath.log,
    sp.ratio: lambda above, below: above / below if below else mpmath.mpf(0),
    sp.re: mpmath.re,
    sp.remainder: _remainder,
    sp.sec: _turning(mpmath.sec),
    sp.sech: _growing(mpmath.sech),
    sp.sign: mpmath.sign,
    sp.sin: _turning(mpmath.sin),
    sp.sinh: _growing(mpmath.sinh),
    sp.stumpff: _stumpff,
    sp.tan: _turning(mpmath.tan),
    sp.tanh: mpmath.tanh,
    sp.third: _third,
}
_CONSTANTS: dict[Expr, Callable[[], Number]] = {
    sp.pi: lambda: +mpmath.pi,
    sp.E: lambda: +mpmath.e,
    sp.I: lambda: mpmath.mpc(0, 1),
}


class Evaluator:
    """A tensor of expressions, prepared for evaluation at many points.

    Every distinct subexpression is computed once a point.

    Args:
        entries: the expressions.
        symbols: what they are made of.
        digits: how many are right, unless some cancel.
        strict: whether atan2(0, 0) has no value; else it is zero, as in generated code.
    """

    def __init__(
        self, entries: Tensor[Expr], symbols: Sequence[Symbol], digits: int = DIGITS, *, strict: bool = False
    ) -> None:
        self._precision = digits + GUARD
        self._steps = steps(entries, symbols, _strict_step if strict else _step)
        self._shape = entries.shape

    def __call__(
        self, point: Mapping[str, float] | Sequence[float], more_digits: int = 0, *, noise: int = 0
    ) -> Tensor[Number]:
        """The entries at one point, given in the order of the symbols; floats are taken as exact.

        Args:
            point: the values of the symbols.
            more_digits: beyond those for which this was made.
            noise: 1 or -1 to change the last digits of every intermediate value, one way or the other: an entry that
                stays what it is owes nothing to how they are rounded, however many are lost.

        Raises:
            OverflowError: for an exponential of more than a million, and the sine of an angle of too many digits.
            ZeroDivisionError: where a formula divides by zero.
            NotComputed: for a formula that holds what is not evaluated.
        """
        values = point.values() if isinstance(point, Mapping) else point
        with mpmath.workdps(self._precision + more_digits):
            residue = mpmath.mpf(10) ** (RESIDUE - self._precision - more_digits)
            slots: list[Number] = [mpmath.mpf(value) for value in values]
            unit = noise * mpmath.mpf(10) ** (LAST - self._precision - more_digits)
            factors = cycle([1 + n * unit for n in NOISE])
            for (operation, operands), factor in zip(self._steps.steps, factors, strict=False):
                value = operation(*(slots[i] for i in operands))
                value = value * factor if noise and operands else value
                slots.append(_tidied(value, residue) if isinstance(value, mpmath.mpc) else value)
            return Tensor(self._shape, tuple(slots[i] for i in self._steps.results))


def _step(expression: Expr) -> tuple[Callable[..., Number], Sequence[Expr]]:
    """What makes a part of a formula from its own parts."""
    if isinstance(expression, sp.Rational):
        numerator, denominator = int(expression.p), int(expression.q)
        return lambda: mpmath.mpf(numerator) / denominator, ()
    if expression in _CONSTANTS:
        return _CONSTANTS[expression], ()
    if isinstance(expression, sp.Add):
        return lambda *terms: mpmath.fsum(terms), expression.args
    if isinstance(expression, sp.Mul):
        return _product, expression.args
    if isinstance(expression, sp.Pow):
        return _power(expression)
    if expression.func in _FUNCTIONS:
        return _FUNCTIONS[expression.func], expression.args
    return _refusal(expression), ()


def _strict_step(expression: Expr) -> tuple[Callable[..., Number], Sequence[Expr]]:
    """The same, but nothing is the angle of no direction."""
    return (_direction, expression.args) if isinstance(expression, sp.atan2) else _step(expression)


def _refusal(expression: Expr) -> Callable[[], Number]:
    """What is done for a formula without a value: infinite, undefined, or of a function that is not known."""
    infinite = expression in (sp.oo, -sp.oo, sp.zoo, sp.nan)

    def refuse() -> Number:
        if infinite:
            raise ZeroDivisionError(f"{expression} is no number")
        raise NotComputed(f"{expression.func.__name__} is not evaluated")

    return refuse


def _tidied(value: Number, residue: Number) -> Number:
    """A complex number without a part that is rounding: the sign of that would choose the branch of a root."""
    if abs(value.imag) <= residue * abs(value.real):
        return value.real
    return mpmath.mpc(0, value.imag) if abs(value.real) <= residue * abs(value.imag) else value


def _product(*factors: Number) -> Number:
    result = factors[0]
    for factor in factors[1:]:
        result = result * factor
    return result


def _power(expression: Expr) -> tuple[Callable[..., Number], Sequence[Expr]]:
    if isinstance(expression.exp, sp.Integer):
        exponent = int(expression.exp)
        return lambda base: base**exponent, (expression.base,)
    return lambda base, power: base**power, expression.args


def evaluate(expression: Expr, values: Mapping[Symbol, float], digits: int = DIGITS) -> Number:
    """One expression at one point."""
    names: Iterable[Symbol] = values
    evaluator = Evaluator(Tensor((), (expression,)), list(names), digits)
    return evaluator(list(values.values())).entries[0]
