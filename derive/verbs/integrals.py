"""Definite integrals with a closed form: exponential polynomials, and rational functions.

A polynomial times e^(αs), α complex, is integrated term by term; of a real function the real parts add up to the
integral. Rational functions fall into partial fractions over linear and quadratic factors.
"""

from __future__ import annotations

from math import comb, factorial

from radartrack.derive import symbolic as sp
from radartrack.derive.algebra.exponential_polynomial import (
    ExponentialPolynomial,
    NotExponentialPolynomial,
    ring_over,
    split,
)
from radartrack.derive.symbolic import Expr, PolyElement, Symbol
from radartrack.derive.verbs.constants import Constants
from radartrack.derive.verbs.no_closed_form import NoClosedForm, shown
from radartrack.derive.verbs.partial_fractions import PartialFraction, partial_fractions

HIGHEST_POWER = 30  # of the variable, beside an exponential
ZERO: Expr = sp.Integer(0)


def integrated(function: Expr, variable: Symbol, low: Expr, high: Expr) -> Expr:
    """The integral of a function from low to high, where the function is finite between them.

    Raises:
        NoClosedForm: when it is neither an exponential polynomial with exponents linear in the variable nor a
            rational function whose denominator has factors of degree one and two.
    """
    symbol = sp.Symbol(f"{{{variable.name}}}", real=True)  # the domain of the paper's letter does not hold here
    constants = Constants([symbol])
    hidden = sp.expand(constants.hidden(function.xreplace({variable: symbol})))
    antiderivative = constants.shown(_antiderivative(hidden, symbol))
    return antiderivative.xreplace({symbol: high}) - antiderivative.xreplace({symbol: low})


def _antiderivative(function: Expr, variable: Symbol) -> Expr:
    ring = ring_over({variable, *function.free_symbols})
    try:
        waves = ExponentialPolynomial.read(sp.expand(function), ring)
    except NotExponentialPolynomial:
        return sp.Add(*(_of_fraction(part, variable) for part in partial_fractions(function, variable)))
    return sp.Add(*(_of_wave(exponent, coefficient, variable) for exponent, coefficient in waves.terms.items()))


def _of_wave(exponent: PolyElement, coefficient: PolyElement, variable: Symbol) -> Expr:
    """The real part of the antiderivative of a polynomial times e^(αs)."""
    growth, frequency = (part.as_expr() for part in split(exponent))
    rates = sp.diff(growth, variable), sp.diff(frequency, variable)
    if any(variable in rate.free_symbols for rate in rates):
        raise NoClosedForm(f"the integral over {_plain(variable)} of e^({shown(growth)}) has no closed form here")
    real, imaginary = _coefficients(coefficient, variable)
    wave = sp.exp(growth)
    parts = []
    if max((*real, *imaginary)) > HIGHEST_POWER:
        raise NoClosedForm(f"the integral of a power of {_plain(variable)} above {HIGHEST_POWER} is too long")
    for power in {*real, *imaginary}:
        a, b = _of_power(power, *rates, variable)
        c, d = real.get(power, ZERO), imaginary.get(power, ZERO)
        # (c + id)(a + ib)(cos φ + i sin φ), its real part
        parts.append((c * a - d * b) * sp.cos(frequency) - (c * b + d * a) * sp.sin(frequency))
    return wave * sp.Add(*parts)


def _of_power(power: int, growth: Expr, frequency: Expr, variable: Symbol) -> tuple[Expr, Expr]:
    """Real and imaginary part of what stands before e^(αs) in the antiderivative of s^p e^(αs)."""
    if growth == ZERO and frequency == ZERO:
        return variable ** (power + 1) / sp.Integer(power + 1), ZERO
    size = growth**2 + frequency**2
    parts: list[tuple[Expr, Expr]] = []
    for n in range(power + 1):
        real, imaginary = _power_of_complex(growth, -frequency, n + 1)  # 1/α^m is conj(α)^m over |α|^2m
        factor = (-1) ** n * sp.Integer(factorial(power) // factorial(power - n)) * variable ** (power - n)
        parts.append((factor * real / size ** (n + 1), factor * imaginary / size ** (n + 1)))
    return sp.Add(*(a for a, _ in parts)), sp.Add(*(b for _, b in parts))


def _power_of_complex(real: Expr, imaginary: Expr, power: int) -> tuple[Expr, Expr]:
    terms: tuple[list[Expr], list[Expr]] = [], []
    for n in range(power + 1):
        sign = -1 if n % 4 > 1 else 1
        terms[n % 2].append(sign * sp.Integer(comb(power, n)) * real ** (power - n) * imaginary**n)
    return sp.Add(*terms[0]), sp.Add(*terms[1])


def _coefficients(coefficient: PolyElement, variable: Symbol) -> tuple[dict[int, Expr], dict[int, Expr]]:
    """Real and imaginary parts of the coefficient of each power of the variable."""
    ring = coefficient.ring
    place = ring.symbols.index(variable)
    parts: tuple[dict[int, Expr], dict[int, Expr]] = {}, {}
    for monomial, number in coefficient.terms():
        rest = ring.from_dict({(*monomial[:place], 0, *monomial[place + 1 :]): ring.domain.one}).as_expr()
        for found, value in zip(parts, (number.x, number.y), strict=True):
            if value:
                term = sp.Rational(int(value.numerator), int(value.denominator)) * rest
                found[monomial[place]] = found.get(monomial[place], ZERO) + term
    return parts


def _of_fraction(part: PartialFraction, variable: Symbol) -> Expr:
    """The antiderivative of one partial fraction."""
    if part.degree == 0:
        return part.numerator[0] * variable ** (part.power + 1) / sp.Integer(part.power + 1)
    if part.degree == 1:
        (factor,) = part.numerator
        beside = variable - part.root
        if part.power == 1:
            return factor * sp.log(sp.Abs(beside))
        return -factor / (sp.Integer(part.power - 1) * beside ** (part.power - 1))
    if part.power > 1:
        raise NoClosedForm(f"the integral over {_plain(variable)} holds a power of an irreducible quadratic factor")
    constant, slope = part.numerator
    beside = variable - part.root  # from the middle m of (s − m)² + v
    rest = constant + slope * part.root
    width = sp.sqrt(part.variance)
    return slope / 2 * sp.log(beside**2 + part.variance) + rest / width * sp.atan(beside / width)


def _plain(variable: Symbol) -> str:
    return variable.name.strip("{}")
