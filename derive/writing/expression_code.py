"""One expression as a line of code, in an order that depends on names alone, so that every language rounds alike."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Sequence

from radartrack.derive import symbolic as sp
from radartrack.derive.algebra.term_order import by_name
from radartrack.derive.symbolic import Expr

SUM, PRODUCT, POWER, ATOM = range(4)
LONGEST_PART = 2**32  # of a fraction: what is multiplied by a longer one may leave single precision on the way
Code = tuple[str, int]  # text, and how tightly it binds


class NotWritable(ValueError):
    """An expression holds a node that has no code, such as an unevaluated integral."""


class ExpressionCode(ABC):
    """How a language says what an expression is made of; signs, fractions and parentheses are the same in all."""

    language: str

    def code(self, expression: Expr) -> str:
        """The expression as code.

        Raises:
            NotWritable: for a node that the language has no function for, and for inexact numbers.
        """
        return self._code(expression)[0]

    def terms(self, expression: Expr) -> list[str]:
        """The terms of a sum as code, each after the first with its sign and a space in front."""
        pieces = [self._signed(term) for term in by_name(expression.args)]
        first = min((i for i, (sign, _) in enumerate(pieces) if sign == "+"), default=0)
        pieces.insert(0, pieces.pop(first))
        (sign, text), *rest = pieces
        return [text if sign == "+" else f"-{text}", *(f"{sign} {text}" for sign, text in rest)]

    def name(self, symbol: str) -> str:
        """What a symbol is called."""
        return symbol

    @abstractmethod
    def number(self, value: float) -> str:
        """A number that a double holds, or the whole number nearest to which it rounds."""

    @abstractmethod
    def constant(self, expression: Expr) -> str:
        """The number pi or e."""

    @abstractmethod
    def call(self, expression: Expr, arguments: Sequence[str]) -> str | None:
        """A function of arguments; None where the language has none."""

    @abstractmethod
    def square(self, base: str, level: int) -> Code:
        """The square of code that binds so tightly."""

    @abstractmethod
    def root(self, base: str) -> str:
        """The square root."""

    @abstractmethod
    def fractional_power(self, base: Code, above: str, below: str) -> Code:
        """A power whose exponent is a fraction."""

    def _code(self, expression: Expr) -> Code:
        if isinstance(expression, sp.Symbol):
            return self.name(expression.name), ATOM
        if isinstance(expression, sp.Add):
            return " ".join(self.terms(expression)), SUM
        if isinstance(expression, sp.Mul | sp.Rational):
            sign, text = self._signed(expression)
            return (text, PRODUCT) if sign == "+" else (f"-{text}", SUM)
        if isinstance(expression, sp.Pow):
            return self._power(expression)
        if expression in (sp.pi, sp.E):
            return self.constant(expression), ATOM
        indexed = isinstance(expression, sp.remainder | sp.stumpff)
        arguments = [self.code(argument) for argument in expression.args[: 1 if indexed else None]]
        called = self.call(expression, [*arguments, str(expression.args[1])] if indexed else arguments)
        if called is None:
            raise NotWritable(f"{type(expression).__name__} in {expression} has no {self.language} code")
        return called, ATOM

    def _signed(self, expression: Expr) -> tuple[str, str]:
        """Sign and magnitude of a term."""
        number, rest = expression.as_coeff_Mul(rational=True)
        if not isinstance(number, sp.Rational):
            raise NotWritable(f"{number} in {expression} is not exact")
        sign = "-" if number < 0 else "+"
        above, below = [], []
        numerator, denominator = int(abs(number.p)), int(number.q)
        if _is_one_number(numerator, denominator):
            above.append(self.number(numerator / denominator))
            denominator = 1
        elif numerator != 1:
            above.append(self.number(numerator))
        for factor in by_name(sp.Mul.make_args(rest)) if rest != 1 else []:
            base, exponent = factor.as_base_exp()
            if isinstance(exponent, sp.Rational) and exponent < 0 and not isinstance(factor, sp.exp):
                below.append(self._wrapped(base**-exponent, POWER))
            else:
                above.append(self._wrapped(factor, PRODUCT))
        if denominator > 1:
            below.append(self.number(denominator))
        product = " * ".join(above) or self.number(1)
        if not below:
            return sign, product
        divisor = below[0] if len(below) == 1 else f"({' * '.join(below)})"
        return sign, f"{product} / {divisor}"

    def _power(self, expression: Expr) -> Code:
        base, exponent = expression.as_base_exp()
        if exponent == sp.Rational(1, 2):
            return self.root(self.code(base)), ATOM
        if isinstance(exponent, sp.Rational) and exponent < 0:
            return f"{self.number(1)} / {self._wrapped(base**-exponent, POWER)}", PRODUCT
        if isinstance(exponent, sp.Rational) and exponent.q == 2:
            return self._integer_power((self.root(self.code(base)), ATOM), int(exponent.p))
        if isinstance(exponent, sp.Rational) and exponent.q > 2:
            return self.fractional_power(self._code(base), self.number(int(exponent.p)), self.number(int(exponent.q)))
        if not isinstance(exponent, sp.Integer):
            raise NotWritable(f"the power {expression} has an exponent that is no number")
        return self._integer_power(self._code(base), int(exponent))

    def _integer_power(self, base: Code, exponent: int) -> Code:
        """Squares are rounded once; other powers are made of them."""
        if exponent == 1:
            return base
        if exponent == 2:
            return self.square(*base)
        half = self._integer_power(base, exponent // 2)
        squared = self.square(*half)
        if exponent % 2 == 0:
            return squared
        return f"{enclosed(base, ATOM)} * {enclosed(squared, POWER)}", PRODUCT

    def _wrapped(self, expression: Expr, level: int) -> str:
        return enclosed(self._code(expression), level)


def _is_one_number(numerator: int, denominator: int) -> bool:
    """Whether a fraction is written as the double nearest to it: what is one, and what a long decimal leaves."""
    is_double = denominator & (denominator - 1) == 0
    return denominator > 1 and (is_double or max(numerator, denominator) > LONGEST_PART)


def enclosed(code: Code, level: int) -> str:
    """In parentheses unless it binds as tightly as that."""
    text, found = code
    return text if found >= level else f"({text})"
