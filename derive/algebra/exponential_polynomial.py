"""Exponential polynomials: finite sums of monomial × e^(polynomial), an algebra in which equality is decidable.

Sines, cosines, hyperbolic functions and exponentials all become e^(...), so two expressions of this kind are the same
function exactly when their sums have the same terms: exponentials of different polynomials are linearly independent
over the rational functions, and those of different rational constants over the numbers (Lindemann & Weierstrass).
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from contextvars import ContextVar
from functools import lru_cache, reduce
from math import comb
from operator import mul
from typing import Self

from radartrack.derive import symbolic as sp
from radartrack.derive.symbolic import Expr, PolyElement, PolyRing, Symbol

Terms = Mapping[PolyElement, PolyElement]


Known = Mapping[Symbol, "ExponentialPolynomial"]


class TooLong(ValueError):
    """More products of monomials were asked for than are allowed."""


class Effort:
    """How many products of monomials may be made; where there is one, all arithmetic of this thread is counted.

    It is counted, not timed: what is done is the same everywhere.

    Args:
        products: how many, until `TooLong` is raised.
    """

    def __init__(self, products: int) -> None:
        self._left = products

    def __enter__(self) -> Self:
        self._outer = _effort.set(self)
        return self

    def __exit__(self, *_: object) -> None:
        _effort.reset(self._outer)

    def spend(self, products: int) -> None:
        """Count products that are about to be made.

        Raises:
            TooLong: when these are too many.
        """
        self._left -= products
        if self._left < 0:
            raise TooLong("the formula is too long for exact algebra")


_effort: ContextVar[Effort | None] = ContextVar("effort", default=None)


def _spend(products: int) -> None:
    if effort := _effort.get():
        effort.spend(products)


class NotExponentialPolynomial(ValueError):
    """The expression is no finite sum of monomials times exponentials of polynomials."""


def ring_over(symbols: Iterable[Symbol]) -> PolyRing:
    """The ring of polynomials in these symbols with coefficients in Q(i), in an order that depends on names alone."""
    return _ring(*sorted(set(symbols), key=lambda symbol: symbol.name))


@lru_cache(maxsize=256)
def _ring(*symbols: Symbol) -> PolyRing:
    """One ring for the same symbols: elements of one and the same are compared sooner."""
    return PolyRing(symbols, sp.QQ_I)


class ExponentialPolynomial:
    """A sum of polynomials times exponentials, `{exponent: coefficient}`, both elements of one ring."""

    __slots__ = ("ring", "terms")

    def __init__(self, ring: PolyRing, terms: Terms) -> None:
        self.ring = ring
        self.terms = {exponent: coefficient for exponent, coefficient in terms.items() if coefficient}

    @classmethod
    def constant(cls, ring: PolyRing, value: PolyElement) -> ExponentialPolynomial:
        """A polynomial as an exponential polynomial."""
        return cls(ring, {ring.zero: value})

    @classmethod
    def read(cls, expression: Expr, ring: PolyRing, known: Known | None = None) -> ExponentialPolynomial:
        """Read a SymPy expression.

        Args:
            expression: what to read.
            ring: over its symbols.
            known: values of symbols that are no generators of the ring.

        Raises:
            NotExponentialPolynomial: when it is not one, for example a quotient or a root.
        """
        return _Reader(ring, known or {}).read(expression)

    @classmethod
    def total(cls, ring: PolyRing, values: Iterable[ExponentialPolynomial]) -> ExponentialPolynomial:
        """The sum of elements over one ring."""
        terms: dict[PolyElement, PolyElement] = {}
        for value in values:
            for exponent, coefficient in value.terms.items():
                terms[exponent] = terms[exponent] + coefficient if exponent in terms else coefficient
        return cls(ring, terms)

    def __add__(self, other: ExponentialPolynomial) -> ExponentialPolynomial:
        return self.total(self.ring, (self, other))

    def __neg__(self) -> ExponentialPolynomial:
        return ExponentialPolynomial(self.ring, {e: -c for e, c in self.terms.items()})

    def __sub__(self, other: ExponentialPolynomial) -> ExponentialPolynomial:
        return self + (-other)

    def __mul__(self, other: ExponentialPolynomial) -> ExponentialPolynomial:
        _spend(self._length * other._length)
        terms: dict[PolyElement, PolyElement] = {}
        for exponent, coefficient in self.terms.items():
            for other_exponent, other_coefficient in other.terms.items():
                total = _sum(exponent, other_exponent)
                product = coefficient * other_coefficient
                terms[total] = terms[total] + product if total in terms else product
        return ExponentialPolynomial(self.ring, terms)

    def __pow__(self, exponent: int) -> ExponentialPolynomial:
        if exponent < 0:
            return self._inverse() ** -exponent
        if len(self.terms) == 1:
            ((growth, coefficient),) = self.terms.items()
            _spend(comb(self._length + exponent - 1, exponent))  # monomials of the power
            return ExponentialPolynomial(self.ring, {growth * exponent: coefficient**exponent})
        one = ExponentialPolynomial.constant(self.ring, self.ring.one)
        return reduce(mul, [self] * exponent, one)

    @property
    def _length(self) -> int:
        """The number of monomials."""
        return sum(map(len, self.terms.values()))

    def __eq__(self, other: object) -> bool:
        return isinstance(other, ExponentialPolynomial) and self.terms == other.terms

    def __hash__(self) -> int:
        return hash(frozenset(self.terms.items()))

    def __bool__(self) -> bool:
        return bool(self.terms)

    def scale(self, factor: Expr) -> ExponentialPolynomial:
        """Multiply by a number or polynomial given as an expression."""
        return self * ExponentialPolynomial.read(factor, self.ring)

    def differentiate(self, symbol: Symbol) -> ExponentialPolynomial:
        """Partial derivative."""
        generator = self.ring(symbol)
        return ExponentialPolynomial(
            self.ring, {e: c.diff(generator) + c * e.diff(generator) for e, c in self.terms.items()}
        )

    def expression(self) -> Expr:
        """The same as a SymPy expression in sines, cosines and exponentials with real arguments."""
        parts = []
        for exponent in sorted(self.terms, key=_order):
            growth, frequency = split(exponent)
            if frequency and leading_is_negative(frequency) and growth - frequency * sp.QQ_I(0, 1) in self.terms:
                continue
            parts.append(sp.exp(growth.as_expr()) * self._oscillation(growth, frequency))
        return sp.Add(*parts)

    def _oscillation(self, growth: PolyElement, frequency: PolyElement) -> Expr:
        imaginary = sp.QQ_I(0, 1)
        forward = self.terms[growth + frequency * imaginary]
        if not frequency:
            return forward.as_expr()
        backward = self.terms.get(growth - frequency * imaginary, self.ring.zero)
        cosine, sine = forward + backward, (forward - backward) * imaginary
        argument = frequency.as_expr()
        return cosine.as_expr() * sp.cos(argument) + sine.as_expr() * sp.sin(argument)

    def _inverse(self) -> ExponentialPolynomial:
        if len(self.terms) == 1:
            ((exponent, coefficient),) = self.terms.items()
            if coefficient.is_ground:
                return ExponentialPolynomial(self.ring, {-exponent: self.ring(1 / coefficient.LC)})
        raise NotExponentialPolynomial("a sum has no inverse among the exponential polynomials")


@lru_cache(maxsize=1 << 14)
def _sum(first: PolyElement, second: PolyElement) -> PolyElement:
    """Few different ones are met; a sum that was met before knows its hash, a new one has to find it."""
    return first + second


def split(exponent: PolyElement) -> tuple[PolyElement, PolyElement]:
    """An exponent's real part (growth or decay) and imaginary part (frequency), both with real coefficients."""
    ring = exponent.ring
    growth = ring.from_dict({m: sp.QQ_I(c.x, 0) for m, c in exponent.terms() if c.x})
    frequency = ring.from_dict({m: sp.QQ_I(c.y, 0) for m, c in exponent.terms() if c.y})
    return growth, frequency


def leading_is_negative(frequency: PolyElement) -> bool:
    """Whether the first coefficient of a polynomial with real coefficients is below zero."""
    return bool(frequency.LC.x < 0)


def _order(exponent: PolyElement) -> list[tuple[tuple[int, ...], str]]:
    return [(monomial, str(coefficient)) for monomial, coefficient in exponent.terms()]


class _Reader:
    """Reads expressions over one ring, each subexpression once."""

    def __init__(self, ring: PolyRing, known: Known) -> None:
        self.ring = ring
        self.values: dict[Expr, ExponentialPolynomial] = dict(known.items())

    def read(self, expression: Expr) -> ExponentialPolynomial:
        if expression not in self.values:
            self.values[expression] = self._read(expression)
        return self.values[expression]

    def _read(self, expression: Expr) -> ExponentialPolynomial:
        ring = self.ring
        if isinstance(expression, sp.Add):
            return ExponentialPolynomial.total(ring, map(self.read, expression.args))
        if isinstance(expression, sp.Mul):
            return reduce(mul, map(self.read, expression.args))
        if isinstance(expression, sp.Pow) and isinstance(expression.exp, sp.Integer):
            return self.read(expression.base) ** int(expression.exp)
        if expression == sp.E:  # what SymPy makes of exp(1)
            return _exponential(ring.one)
        if isinstance(expression, sp.remainder):
            return self.read(expression.expanded())
        build = _FUNCTIONS.get(expression.func)
        if build is not None:
            return build(self._exponent(expression.args[0]))
        return ExponentialPolynomial.constant(ring, _atom(expression, ring))

    def _exponent(self, argument: Expr) -> PolyElement:
        value = self.read(argument)
        if any(value.terms.keys() - {self.ring.zero}):
            raise NotExponentialPolynomial(f"{argument} inside a function is not a polynomial")
        return value.terms.get(self.ring.zero, self.ring.zero)


def _atom(expression: Expr, ring: PolyRing) -> PolyElement:
    if isinstance(expression, Symbol) and expression in ring.symbols:
        return ring.gens[ring.symbols.index(expression)]
    if isinstance(expression, sp.Rational):
        return ring(sp.QQ_I(sp.QQ(int(expression.p), int(expression.q)), 0))
    if isinstance(expression, sp.ImaginaryUnit):
        return ring(sp.QQ_I(0, 1))
    raise NotExponentialPolynomial(f"{expression} is not a polynomial times sines, cosines and exponentials")


def _combination(
    factor: complex, forward: tuple[int, int], backward: tuple[int, int]
) -> Callable[[PolyElement], ExponentialPolynomial]:
    """x ↦ a·e^(fx) + b·e^(-fx) with f = 1 or i; a and b are halves of the Gaussian integers given."""
    turn = sp.QQ_I(int(factor.real), int(factor.imag))

    def build(argument: PolyElement) -> ExponentialPolynomial:
        ring = argument.ring
        first, second = (ring(sp.QQ_I(sp.QQ(re, 2), sp.QQ(im, 2))) for re, im in (forward, backward))
        rising = ExponentialPolynomial(ring, {argument * turn: first})
        return rising + ExponentialPolynomial(ring, {-argument * turn: second})

    return build


def _exponential(argument: PolyElement) -> ExponentialPolynomial:
    return ExponentialPolynomial(argument.ring, {argument: argument.ring.one})


def _exponential_less_one(argument: PolyElement) -> ExponentialPolynomial:
    return _exponential(argument) - ExponentialPolynomial.constant(argument.ring, argument.ring.one)


_FUNCTIONS: dict[type[Expr], Callable[[PolyElement], ExponentialPolynomial]] = {
    sp.exp: _exponential,
    sp.expm1: _exponential_less_one,
    sp.cos: _combination(1j, (1, 0), (1, 0)),
    sp.sin: _combination(1j, (0, -1), (0, 1)),
    sp.cosh: _combination(1, (1, 0), (1, 0)),
    sp.sinh: _combination(1, (1, 0), (-1, 0)),
}
