"""Fractions of exponential polynomials with roots and inverse functions adjoined: the form that proves equality.

Polynomials, sines, cosines, exponentials and hyperbolic functions are exponential polynomials. What is none becomes
a generator: a root, with its defining relation w^n = a; an inverse function or a logarithm, known by its arguments
alone. Two formulas are proved equal when the numerator of their difference vanishes modulo the relations.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable
from dataclasses import dataclass, field
from functools import reduce

import mpmath

from radartrack.derive import symbolic as sp
from radartrack.derive.algebra.exponential_polynomial import ExponentialPolynomial, ring_over
from radartrack.derive.algebra.radicands import DIGITS, split
from radartrack.derive.symbolic import Expr, PolyElement, PolyRing, Symbol

LARGEST_PRIME = (
    1000  # that is divided out of a number under a root; larger ones stay together, and are proved less often
)
PRIMES = 8  # different ones whose roots a number may need
FACTORS = 6  # different ones whose roots a radicand may need


class NotCanonical(ValueError):
    """The expression has no such form: it divides by zero, or holds what the algebra does not know."""


@dataclass(frozen=True)
class Quotient:
    """A numerator over a product of powers."""

    numerator: ExponentialPolynomial
    denominators: Counter[ExponentialPolynomial] = field(default_factory=Counter)

    def __add__(self, other: Quotient) -> Quotient:
        common = self.denominators | other.denominators
        return Quotient(self._over(common) + other._over(common), common)

    def __neg__(self) -> Quotient:
        return Quotient(-self.numerator, self.denominators)

    def __sub__(self, other: Quotient) -> Quotient:
        return self + (-other)

    def __mul__(self, other: Quotient) -> Quotient:
        return Quotient(self.numerator * other.numerator, self.denominators + other.denominators)

    def __pow__(self, exponent: int) -> Quotient:
        powers = Counter({base: power * exponent for base, power in self.denominators.items() if exponent})
        return Quotient(self.numerator**exponent, powers)

    def _over(self, common: Counter[ExponentialPolynomial]) -> ExponentialPolynomial:
        missing = common - self.denominators
        return reduce(lambda product, one: product * one[0] ** one[1], missing.items(), self.numerator)

    @property
    def polynomial(self) -> PolyElement | None:
        """The same as a polynomial, if it is one."""
        zero = self.numerator.ring.zero
        if self.denominators or self.numerator.terms.keys() - {zero}:
            return None
        return self.numerator.terms.get(zero, zero)

    @property
    def number(self) -> sp.PolyCoefficient | None:
        """The same as a number, if it is one."""
        return self.polynomial.LC if self.polynomial is not None and self.polynomial.is_ground else None


@dataclass(frozen=True)
class Generator:
    """A symbol for what is no exponential polynomial.

    Attributes:
        symbol: its place in the ring.
        kind: what it is: the name of a function, or "root" or "argument".
        arguments: of that function.
        degree: of a root; the degree-th power of the symbol is the argument.
    """

    symbol: PolyElement
    kind: str
    arguments: tuple[Quotient, ...]
    degree: int = 1


class Field:
    """The fractions over some symbols and the generators met while reading.

    Args:
        expressions: what will be read; they decide how many generators there is room for.
        thorough: whether radicands are factored, so that roots of products are told from products of roots.
    """

    def __init__(self, expressions: Iterable[Expr], *, thorough: bool) -> None:
        given = list(expressions)
        self._thorough = thorough
        symbols: set[Symbol] = set().union(*(expression.free_symbols for expression in given))
        room = sum(_generators_needed(expression) for expression in given)
        spare = [sp.Symbol(f"{{{number}}}") for number in range(room)]
        self._ring: PolyRing = ring_over([*symbols, *spare])
        self._spare = iter([self._ring(symbol) for symbol in spare])
        self.generators: list[Generator] = []
        self._read: dict[Expr, Quotient] = {}

    @property
    def has_roots(self) -> bool:
        """Whether a root was met."""
        return any(one.kind == "root" for one in self.generators)

    def read(self, expression: Expr) -> Quotient:
        """An expression as a fraction.

        Raises:
            NotCanonical: when it is none, or divides by zero.
        """
        if expression not in self._read:
            self._read[expression] = self._translate(expression)
        return self._read[expression]

    def vanishes(self, value: Quotient) -> bool:
        """Whether the value is proved to be zero."""
        return self._vanishes(value, len(self.generators))

    def _vanishes(self, value: Quotient, known: int) -> bool:
        """Split the numerator by powers of the latest generator, modulo its relation; each part must vanish."""
        if not value.numerator:
            return True
        if not known:
            return False
        generator = self.generators[known - 1]
        return all(self._vanishes(part, known - 1) for part in self._parts(value.numerator, generator))

    def _parts(self, numerator: ExponentialPolynomial, generator: Generator) -> list[Quotient]:
        coefficients = _by_degree(numerator, generator.symbol)
        if generator.kind != "root":
            return list(coefficients.values())
        (radicand,) = generator.arguments
        parts: dict[int, Quotient] = {}
        for degree, coefficient in coefficients.items():
            times, left = divmod(degree, generator.degree)
            parts[left] = parts.get(left, self._number(0)) + coefficient * radicand**times
        return list(parts.values())

    def _translate(self, expression: Expr) -> Quotient:
        if isinstance(expression, sp.Add):
            return reduce(Quotient.__add__, map(self.read, expression.args))
        if isinstance(expression, sp.Mul):
            return reduce(Quotient.__mul__, map(self.read, expression.args))
        if isinstance(expression, sp.Pow):
            return self._power(expression)
        if isinstance(expression, sp.Rational):
            return self._number(int(expression.p), int(expression.q))
        if isinstance(expression, sp.ImaginaryUnit):
            return self._ground(self._ring(sp.QQ_I(0, 1)))
        if isinstance(expression, Symbol):
            return self._ground(self._ring(expression))
        return self._function(expression)

    def _ground(self, value: PolyElement) -> Quotient:
        return Quotient(ExponentialPolynomial.constant(self._ring, value))

    def _number(self, numerator: int, denominator: int = 1) -> Quotient:
        return self._ground(self._ring(sp.QQ_I(sp.QQ(numerator, denominator), 0)))

    def _power(self, expression: Expr) -> Quotient:
        base, exponent = expression.base, expression.exp
        if not isinstance(exponent, sp.Rational):
            number, rest = sp.expand(exponent).as_coeff_Add()  # q^(k + 1) is q q^k
            grown = self._exponential(self.read(rest) * self.read(sp.log(base)))
            return grown * self.read(base**number) if isinstance(number, sp.Rational) else grown
        root = self.read(base) if exponent.q == 1 else self._root(self.read(base), int(exponent.q))
        return root ** int(exponent.p) if exponent.p >= 0 else self._inverse(root) ** int(-exponent.p)

    def _inverse(self, value: Quotient) -> Quotient:
        """One over the value, the symbols that divide all of it as divisors of their own."""
        if self.vanishes(value):
            raise NotCanonical("this divides by zero")
        above = reduce(
            lambda product, one: product * one[0] ** one[1],
            value.denominators.items(),
            self._number(1).numerator,
        )
        exponent = min(value.numerator.terms, key=str)
        leading = value.numerator.terms[exponent].LC
        unit = ExponentialPolynomial(self._ring, {-exponent: self._ring(1 / leading)})
        base = value.numerator * unit
        monomial = _shared_powers(base)
        divisors = {self._ground(gen).numerator: power for gen, power in zip(self._ring.gens, monomial, strict=True)}
        powers = Counter({divisor: power for divisor, power in divisors.items() if power})
        rest = ExponentialPolynomial(self._ring, {e: _divided(c, monomial) for e, c in base.terms.items()})
        return Quotient(above * unit, powers + Counter({rest: 1} if rest != self._number(1).numerator else {}))

    def _function(self, expression: Expr) -> Quotient:
        arguments = tuple(map(self.read, expression.args))
        if expression.func in _WAVES:
            return self._wave(expression.func, arguments[0])
        if expression.func in _RATIOS:
            above, below = _RATIOS[expression.func]
            return self._wave(above, arguments[0]) * self._inverse(self._wave(below, arguments[0]))
        if expression.func in _RECIPROCALS:
            return self._inverse(self._wave(_RECIPROCALS[expression.func], arguments[0]))
        if expression.func is sp.Abs and expression.args[0].is_extended_real:
            return self._root(arguments[0] * arguments[0], 2)
        if expression.func is sp.hypot:
            return self._root(arguments[0] ** 2 + arguments[1] ** 2, 2)
        if expression.func in _OPAQUE or expression == sp.pi:
            return self._ground(self._generator(str(expression.func), arguments).symbol)
        if expression == sp.E:
            return self._exponential(self._number(1))
        raise NotCanonical(f"{expression.func} is not known to the algebra")

    def _exponential(self, argument: Quotient) -> Quotient:
        return Quotient(ExponentialPolynomial(self._ring, {self._exponent(argument): self._ring.one}))

    def _wave(self, function: type[Expr], argument: Quotient) -> Quotient:
        """A sum of e^x and e^(−x), e^(ix) and e^(−ix), or e^x and 1."""
        turn, forward, backward, constant = _WAVES[function]
        exponent = self._exponent(argument) * turn
        terms = [(exponent, forward), (-exponent, backward), (self._ring.zero, constant)]
        total = ExponentialPolynomial(self._ring, {})
        for power, factor in terms:
            total = total + ExponentialPolynomial(self._ring, {power: self._ring(factor)})
        return Quotient(total)

    def _exponent(self, argument: Quotient) -> PolyElement:
        """The argument as a polynomial; one that is none becomes a multiple of a generator."""
        polynomial = argument.polynomial
        if polynomial is not None:
            return polynomial
        for generator in self.generators:
            if generator.kind == "argument" and (ratio := self._ratio(argument, generator.arguments[0])):
                return generator.symbol * ratio
        return self._generator("argument", (argument,)).symbol

    def _ratio(self, value: Quotient, other: Quotient) -> PolyElement | None:
        """The rational number by which two values differ, if they do."""
        above, below = value - other * self._number(0), other - value * self._number(0)
        exponent = min(above.numerator.terms, key=str)
        monomial = above.numerator.terms[exponent].monoms()[0]
        mine = above.numerator.terms[exponent].get(monomial)
        theirs = below.numerator.terms.get(exponent, self._ring.zero).get(monomial)
        if not mine or not theirs or (mine / theirs).y:
            return None
        ratio = mine / theirs
        return self._ring(ratio) if self.vanishes(value - other * self._ground(self._ring(ratio))) else None

    def _root(self, radicand: Quotient, degree: int) -> Quotient:
        """The principal root, with numbers and positive symbols taken out of it."""
        if self.vanishes(radicand):
            return self._number(0)
        outside, inside = self._without_powers(radicand, degree)
        if inside.number is not None and not inside.number.y:
            return outside * self._root_of_number(inside.number.x, degree)
        for generator in self.generators:
            if generator.kind != "root" or generator.degree != degree:
                continue
            ratio = self._ratio(inside, generator.arguments[0])
            if ratio is not None and ratio.LC.x > 0:
                return outside * self._root_of_number(ratio.LC.x, degree) * self._ground(generator.symbol)
        return outside * self._ground(self._generator("root", (inside,), degree).symbol)

    def _without_powers(self, radicand: Quotient, degree: int) -> tuple[Quotient, Quotient]:
        """The root of what is never negative and multiplies or divides everything, and what is left inside."""
        outside, inside = self._taken_out(radicand.numerator, 1, degree)
        denominators: Counter[ExponentialPolynomial] = Counter()
        for base, power in radicand.denominators.items():
            root, rest = self._taken_out(base, power, degree)
            outside = outside * self._inverse(root)
            if number := Quotient(rest).number:
                inside = inside * ExponentialPolynomial.constant(self._ring, self._ring(1 / number))
            else:
                denominators[rest] += 1
        return outside, Quotient(inside, denominators)

    def _taken_out(
        self, value: ExponentialPolynomial, times: int, degree: int
    ) -> tuple[Quotient, ExponentialPolynomial]:
        """The root of what is never negative in a power, and the rest; of exponentials, only symbols are factors."""
        zero = self._ring.zero
        if value.terms.keys() == {zero}:
            factors, left = split(value.terms[zero], times, self._constants, thorough=self._thorough)
            return self._root_of_factors(factors, degree), ExponentialPolynomial.constant(self._ring, left)
        powers = zip(_shared_powers(value), self._ring.symbols, strict=True)
        shared = [power if symbol.is_nonnegative else 0 for power, symbol in powers]
        rest = ExponentialPolynomial(self._ring, {e: _divided(c, shared) for e, c in value.terms.items()})
        factors = [(symbol, power * times) for symbol, power in zip(self._ring.gens, shared, strict=True)]
        return self._root_of_factors(factors, degree), rest**times

    @property
    def _constants(self) -> dict[PolyElement, mpmath.mpf]:
        """The symbols of the ring that stand for numbers."""
        with mpmath.workdps(DIGITS):
            return {one.symbol: +mpmath.pi for one in self.generators if one.kind == str(sp.pi.func)}

    def _root_of_factors(self, factors: Iterable[tuple[PolyElement, int]], degree: int) -> Quotient:
        """The root of a product of what is never negative, a root of its own for each."""
        result = self._number(1)
        for factor, power in factors:
            times, left = divmod(power, degree)
            result = result * self._ground(factor) ** times
            if left:
                root = self._generator("root", (self._ground(factor),), degree).symbol
                result = result * self._ground(root) ** left
        return result

    def _root_of_number(self, value: sp.PolyCoefficient, degree: int) -> Quotient:
        """The root of a rational number through those of primes; a negative number keeps its sign inside."""
        above, below = int(value.numerator), int(value.denominator)
        whole = above * below ** (degree - 1)
        factors = _factors(abs(whole))
        result = self._number(1, below)
        for prime, power in factors.items():
            times, left = divmod(power, degree)
            result = result * self._number(prime) ** times
            if left:
                result = result * self._prime_root(prime, degree) ** left
        return result if whole > 0 else result * self._prime_root(-1, degree)

    def _prime_root(self, prime: int, degree: int) -> Quotient:
        if prime == -1 and degree == 2:
            return self._ground(self._ring(sp.QQ_I(0, 1)))
        return self._ground(self._generator("root", (self._number(prime),), degree).symbol)

    def _generator(self, kind: str, arguments: tuple[Quotient, ...], degree: int = 1) -> Generator:
        for known in self.generators:
            same = known.kind == kind and known.degree == degree and len(known.arguments) == len(arguments)
            if same and all(self.vanishes(a - b) for a, b in zip(known.arguments, arguments, strict=True)):
                return known
        symbol = next(self._spare, None)
        if symbol is None:
            raise NotCanonical("the formula holds more roots than there is room for")
        self.generators.append(Generator(symbol, kind, arguments, degree))
        return self.generators[-1]


def _by_degree(value: ExponentialPolynomial, symbol: PolyElement) -> dict[int, Quotient]:
    """The coefficients of the powers of a symbol."""
    ring = value.ring
    place = ring.gens.index(symbol)
    terms: dict[int, dict[PolyElement, dict[tuple[int, ...], sp.PolyCoefficient]]] = {}
    for exponent, coefficient in value.terms.items():
        for monomial, number in coefficient.terms():
            rest = (*monomial[:place], 0, *monomial[place + 1 :])
            terms.setdefault(monomial[place], {}).setdefault(exponent, {})[rest] = number
    return {
        degree: Quotient(ExponentialPolynomial(ring, {e: ring.from_dict(c) for e, c in parts.items()}))
        for degree, parts in terms.items()
    }


def _shared_powers(value: ExponentialPolynomial) -> list[int]:
    """The powers of the symbols that divide every term."""
    monomials = [m for c in value.terms.values() for m in c.monoms()]
    return [min(powers) for powers in zip(*monomials, strict=True)]


def _divided(coefficient: PolyElement, powers: list[int]) -> PolyElement:
    return coefficient.ring.from_dict(
        {tuple(a - b for a, b in zip(m, powers, strict=True)): number for m, number in coefficient.terms()}
    )


def _factors(number: int) -> dict[int, int]:
    """Small prime factors, and what is left of the number as if it were prime."""
    found: Counter[int] = Counter()
    for prime in range(2, LARGEST_PRIME):
        while number % prime == 0:
            found[prime] += 1
            number //= prime
    return {**found, number: 1} if number > 1 else dict(found)


def _generators_needed(expression: Expr) -> int:
    """How many generators an expression needs at most; the roots of a number and of a product may be many."""
    calls = [*expression.atoms(sp.Function, sp.Pow), *expression.atoms(sp.NumberSymbol)]
    shared = len({call.exp.q for call in calls if _is_root(call)} | {2}) * (PRIMES + len(expression.free_symbols))
    return shared + sum(map(_room, calls))


def _is_root(call: Expr) -> bool:
    return isinstance(call, sp.Pow) and isinstance(call.exp, sp.Rational) and call.exp.q > 1


def _room(call: Expr) -> int:
    if isinstance(call, sp.Pow):
        return 0 if isinstance(call.exp, sp.Integer) else FACTORS
    if call.func in _WAVES or call.func in _RATIOS or call.func in _RECIPROCALS:
        return 0 if _is_polynomial(call.args[0]) else 1
    return FACTORS if call.func in {sp.Abs, sp.hypot} else 1


def _is_polynomial(expression: Expr) -> bool:
    if isinstance(expression, sp.Add | sp.Mul):
        return all(map(_is_polynomial, expression.args))
    if isinstance(expression, sp.Pow):
        return isinstance(expression.exp, sp.Integer) and expression.exp > 0 and _is_polynomial(expression.base)
    return isinstance(expression, Symbol | sp.Rational)


_HALF = sp.QQ_I(sp.QQ(1, 2), 0)
_ONE, _ZERO, _I = sp.QQ_I(1, 0), sp.QQ_I(0, 0), sp.QQ_I(0, 1)

# turn t and factors a, b, c: the function is a e^(tx) + b e^(−tx) + c
_WAVES: dict[type[Expr], tuple[sp.PolyCoefficient, ...]] = {
    sp.exp: (_ONE, _ONE, _ZERO, _ZERO),
    sp.expm1: (_ONE, _ONE, _ZERO, -_ONE),
    sp.cos: (_I, _HALF, _HALF, _ZERO),
    sp.sin: (_I, -_HALF * _I, _HALF * _I, _ZERO),
    sp.cosh: (_ONE, _HALF, _HALF, _ZERO),
    sp.sinh: (_ONE, _HALF, -_HALF, _ZERO),
}
_RATIOS: dict[type[Expr], tuple[type[Expr], type[Expr]]] = {
    sp.cot: (sp.cos, sp.sin),
    sp.coth: (sp.cosh, sp.sinh),
    sp.tan: (sp.sin, sp.cos),
    sp.tanh: (sp.sinh, sp.cosh),
}
_RECIPROCALS: dict[type[Expr], type[Expr]] = {sp.csc: sp.sin, sp.csch: sp.sinh, sp.sec: sp.cos, sp.sech: sp.cosh}
_OPAQUE = {sp.Abs, sp.acos, sp.asin, sp.atan, sp.atan2, sp.log}  # the absolute value of what may be complex
