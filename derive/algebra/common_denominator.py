"""Expressions with roots and quotients over one denominator each.

In a differential ring √P and P·P^(−1/2) are different polynomials. Here every power of an inverse root or quotient is
brought to the highest one that occurs, and common factors of numerator and denominator are divided out. For one root
the result is unique, which is what a rewritten form is proved by.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from functools import reduce
from operator import add
from typing import TYPE_CHECKING

from radartrack.derive import symbolic as sp
from radartrack.derive.algebra.differential_ring import DifferentialRing
from radartrack.derive.symbolic import Expr, PolyElement, Symbol

if TYPE_CHECKING:
    from radartrack.derive.symbolic import PolyCoefficient

Powers = tuple[int, ...]


@dataclass(frozen=True)
class Denominator:
    """A generator that stands for P^(−1/2) or 1/P.

    Attributes:
        generator: its placeholder in the ring.
        radicand: P, as an element.
        step: two where P is the square of what stands in the denominator, one where it stands there itself.
        name: what the root or P itself is called in code.
    """

    generator: Symbol
    radicand: PolyElement
    step: int
    name: Symbol

    def definition(self, ring: DifferentialRing) -> Expr:
        """√P or P in the plain symbols."""
        plain = ring.expression(self.radicand)
        return sp.sqrt(plain) if self.step == 2 else plain


def vanishes(expression: Expr) -> bool:
    """Whether an expression with roots, quotients and elementary functions is proved to be zero."""
    ring = DifferentialRing([expression], expression.free_symbols)
    return not any(collect(ring.read(expression), ring, denominators(ring)).values())


def collect(element: PolyElement, ring: DifferentialRing, found: Iterable[Denominator]) -> dict[Powers, PolyElement]:
    """Powers of the denominators' generators, negative ones for roots in the numerator → numerator.

    Sines occur to the first power only: what is one function with sin² + cos² = 1 is one polynomial.
    """
    parts: dict[Powers, PolyElement] = {(): without_squares(element, ring, sp.sin)}
    for denominator in found:
        parts = {
            (*powers, power): numerator
            for powers, polynomial in parts.items()
            for power, numerator in _collect(polynomial, ring, denominator).items()
        }
    return parts


def _collect(polynomial: PolyElement, ring: DifferentialRing, denominator: Denominator) -> dict[int, PolyElement]:
    position = ring.ring.symbols.index(denominator.generator)
    by_power: dict[int, dict[Powers, PolyCoefficient]] = {}
    for powers, value in polynomial.terms():
        rest = (*powers[:position], 0, *powers[position + 1 :])
        by_power.setdefault(powers[position], {})[rest] = value
    result: dict[int, PolyElement] = {}
    for parity in range(denominator.step):
        alike = {k: ring.ring.from_dict(terms) for k, terms in by_power.items() if k % denominator.step == parity}
        if alike:
            power, numerator = _over_one(alike, denominator)
            if numerator:
                result[power] = numerator
    return result


def _over_one(alike: dict[int, PolyElement], denominator: Denominator) -> tuple[int, PolyElement]:
    highest, step, radicand = max(alike), denominator.step, denominator.radicand
    numerator = reduce(add, (p * radicand ** ((highest - k) // step) for k, p in alike.items()))
    while numerator:
        quotient, remainder = numerator.div(radicand)
        if remainder:
            break
        numerator, highest = quotient, highest - step
    return highest, numerator


def denominators(ring: DifferentialRing) -> list[Denominator]:
    """The generators that stand for inverse roots and quotients."""
    found: list[Denominator] = []
    for placeholder, key in ring.generators.items():
        base, exponent = key.as_base_exp()
        if exponent in (sp.Integer(-1), sp.Rational(-1, 2)):
            step = 1 if exponent == sp.Integer(-1) else 2
            kind = "divisor" if step == 1 else "root"
            name = sp.Symbol(f"{kind}_{len(found) + 1}", positive=True)
            found.append(Denominator(placeholder, ring.read(base), step, name))
    return found


def without_squares(element: PolyElement, ring: DifferentialRing, function: type[Expr]) -> PolyElement:
    """An element with every square of a sine (or cosine) replaced by one less the square of the other."""
    other = sp.cos if function is sp.sin else sp.sin
    for placeholder, key in ring.generators.items():
        if isinstance(key, function):
            element = even_powers(element, placeholder, 1 - ring.read(other(*key.args)) ** 2)
        elif isinstance(key, sp.Pow) and isinstance(key.exp, sp.Rational) and key.exp.p == 1:
            element = even_powers(element, placeholder, ring.read(key.base), int(key.exp.q))
    return element


def even_powers(value: PolyElement, symbol: Symbol, square: PolyElement, degree: int = 2) -> PolyElement:
    """The polynomial with every even power of a generator expressed through its square, or through a higher power."""
    ring = value.ring
    position = ring.symbols.index(symbol)
    total = ring.zero
    for powers, coefficient in value.terms():
        power = powers[position]
        rest = ring.from_dict({(*powers[:position], power % degree, *powers[position + 1 :]): coefficient})
        total = total + rest * square ** (power // degree)
    return total
