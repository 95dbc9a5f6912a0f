"""Polynomials in attenuations between 0 and 1 as sums of terms of one sign, which cannot cancel.

With the shortfall u = 1 − q of an attenuation q, every term can be multiplied by powers of q + u = 1 until all have
one degree. A polynomial that is positive between 0 and 1 then ends, at some degree, as a sum of positive terms
(Bernstein), and what cancels does so between exact rationals.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache
from itertools import product
from math import lcm, prod
from typing import TYPE_CHECKING, NamedTuple

from radartrack.derive import symbolic as sp
from radartrack.derive.symbolic import Expr, PolyElement, PolyRing, Symbol, expm1

if TYPE_CHECKING:
    from radartrack.derive.symbolic import PolyCoefficient

Monomial = tuple[int, ...]
Point = tuple[Fraction, ...]
Coefficients = frozenset[tuple[Monomial, Fraction]]
Factored = tuple[PolyElement, PolyElement]
HEADROOM = 3  # how often terms may outweigh their sum, two bits; less, and short forms are refused for longer ones
GRID = 8  # intervals a side for two attenuations at which that is tried, fewer for more: their number is a power
ELEVATIONS = 3  # degrees that are tried: a higher one may give terms of one sign, and is longer


@dataclass(frozen=True)
class Decay:
    """The attenuation e^(−step·variance) and its shortfall from one."""

    variance: Monomial
    product: Expr
    step: Fraction
    attenuation: Symbol
    shortfall: Symbol

    @classmethod
    def of(cls, variance: Monomial, product: Expr, step: Fraction) -> Decay:
        """Named after the measured quantities whose deviations the variance holds."""
        name = "_".join(symbol.name.replace("sigma_", "") for symbol in sorted(product.free_symbols, key=str))
        attenuation = sp.Symbol(f"attenuation_{name}", positive=True)
        return cls(variance, product, step, attenuation, sp.Symbol(f"shortfall_{name}", real=True))

    @property
    def variance_is_positive(self) -> bool:
        """Whether it is a product of squares."""
        return all(power % 2 == 0 for power in self.variance)

    def definitions(self) -> dict[Symbol, Expr]:
        """Attenuation and shortfall in the plain symbols."""
        exponent = -sp.Rational(self.step) * self.product
        return {self.attenuation: sp.exp(exponent), self.shortfall: -expm1(exponent)}


class Form(NamedTuple):
    """A polynomial as it is written.

    Attributes:
        expression: in attenuations and shortfalls.
        terms: of its sums, together.
        sign: that it has wherever the attenuations are between 0 and 1; 0 where its terms cancel somewhere.
        size: the sum of the sizes of its terms, by the values of the attenuations.
    """

    expression: Expr
    terms: int
    sign: int
    size: Callable[[Point], Fraction]


@lru_cache(maxsize=4096)
def bernstein(coefficients: Coefficients, decays: tuple[Decay, ...]) -> Form:
    """A polynomial in attenuations as a product of powers and, where one exists, a sum of terms of one sign.

    `coefficients` pairs the powers of each attenuation, negative ones included, with rationals.
    """
    live = {powers: value for powers, value in sorted(coefficients) if value}
    if not live:
        return Form(sp.Integer(0), 0, 0, lambda _: Fraction(0))
    if not decays:
        return Form(sp.Rational(live[()]), 1, _sign_of(live[()]), lambda _: abs(live[()]))
    lowest, shifted = without_common_power(live)
    ring = PolyRing([symbol for decay in decays for symbol in (decay.attenuation, decay.shortfall)], sp.QQ)
    degrees = tuple(max(powers[d] for powers in shifted) for d in range(len(decays)))
    power, rest = _best(shifted, degrees, ring)
    content, primitive = rest.primitive()
    expression = sp.Rational(rational_number(content)) * common(lowest, decays) * power.as_expr() * primitive.as_expr()
    return Form(expression, len(rest.terms()), _sign(rest), lambda point: _size(power * rest, lowest, point))


def without_common_power(coefficients: Mapping[Monomial, Fraction]) -> tuple[Monomial, dict[Monomial, Fraction]]:
    """The powers of attenuations that all terms share, and the polynomial that is left."""
    lowest = tuple(map(min, zip(*coefficients, strict=True)))
    left = {tuple(p - low for p, low in zip(powers, lowest, strict=True)): c for powers, c in coefficients.items()}
    return lowest, left


def common(powers: Monomial, decays: Sequence[Decay]) -> Expr:
    """A product of powers of attenuations."""
    return sp.Mul(*(decay.attenuation**power for decay, power in zip(decays, powers, strict=True)))


def _size(polynomial: PolyElement, lowest: Monomial, point: Point) -> Fraction:
    values = [value for attenuation in point for value in (attenuation, 1 - attenuation)]
    terms = (
        abs(rational_number(c)) * prod(value**n for value, n in zip(values, powers, strict=True))
        for powers, c in polynomial.terms()
    )
    return sum(terms, Fraction(0)) * prod(a**n for a, n in zip(point, lowest, strict=True))


def _best(coefficients: Mapping[Monomial, Fraction], degrees: Monomial, ring: PolyRing) -> Factored:
    """The shortest representation that does not cancel, of a higher degree only where the lowest has none.

    A polynomial that changes sign between 0 and 1 has none at all; then the homogeneous form, in which every term is
    as small as the powers of the shortfalls that it holds, loses the least.
    """
    for extra in range(ELEVATIONS):
        form = _homogeneous(coefficients, tuple(degree + extra for degree in degrees), ring)
        for candidate in sorted(_representations(form, ring), key=_length):
            if not _cancels(candidate[1]):
                return candidate
    return _split_monomial(_homogeneous(coefficients, degrees, ring), ring)


def _homogeneous(coefficients: Mapping[Monomial, Fraction], degrees: Monomial, ring: PolyRing) -> PolyElement:
    """Multiply every term by powers of attenuation + shortfall = 1 until it has the given degree in each pair."""
    pairs = [(ring.gens[2 * d], ring.gens[2 * d + 1]) for d in range(len(degrees))]
    total = ring.zero
    for powers, value in coefficients.items():
        term = ring(sp.QQ(value.numerator, value.denominator))
        for (attenuation, shortfall), power, degree in zip(pairs, powers, degrees, strict=True):
            term = term * attenuation**power * (attenuation + shortfall) ** (degree - power)
        total = total + term
    return total


def _representations(form: PolyElement, ring: PolyRing) -> Iterable[Factored]:
    """Ways to write a homogeneous form as a monomial times a rest, all equal because attenuation + shortfall = 1."""
    monomial, rest = _split_monomial(form, ring)
    yield monomial, rest
    for keep in (0, 1):
        replaced = rest
        for d in range(0, len(ring.gens), 2):
            replaced = replaced.compose(ring.gens[d + 1 - keep], 1 - ring.gens[d + keep])
        extra, shorter = _split_monomial(replaced, ring)
        yield monomial * extra, shorter


def _split_monomial(form: PolyElement, ring: PolyRing) -> Factored:
    lowest = tuple(min(powers) for powers in zip(*form.monoms(), strict=True))
    monomial = ring.from_dict({lowest: ring.domain.one})
    return monomial, form.exquo(monomial)


def _length(candidate: Factored) -> tuple[int, int]:
    """Few terms first, then a low degree."""
    _, rest = candidate
    return len(rest.terms()), sum(sum(powers) for powers in rest.monoms())


def _cancels(polynomial: PolyElement) -> bool:
    """Whether somewhere the terms outweigh their sum more than HEADROOM times; on a grid, in exact arithmetic."""
    return any(sum(map(abs, terms)) > HEADROOM * abs(sum(terms)) for terms in _on_grid(polynomial))


def _sign(polynomial: PolyElement) -> int:
    """Where its terms cancel nowhere the sign of their sum, else 0."""
    found = {0} if _cancels(polynomial) else {_sign_of(sum(terms)) for terms in _on_grid(polynomial)} - {0}
    return found.pop() if len(found) == 1 else 0


def _sign_of(number: Fraction | int) -> int:
    return (number > 0) - (number < 0)


def _on_grid(polynomial: PolyElement) -> Iterator[list[int]]:
    """The terms at points between 0 and 1, in one unit; of terms of one sign at the middle alone."""
    decays = len(polynomial.ring.gens) // 2
    side = max(2, round(GRID ** (2 / max(2, decays))))
    total = max(sum(monomial) for monomial in polynomial.monoms())
    powers = [[k**n for n in range(_degree(polynomial) + 1)] for k in range(side + 1)]
    weights = _integers(polynomial)
    of_one_sign = len({value > 0 for value in polynomial.coeffs()}) == 1
    for point in [(side // 2,) * decays] if of_one_sign else product(range(side + 1), repeat=decays):
        values = [powers[k] for part in point for k in (part, side - part)]
        yield [
            value * prod(table[n] for table, n in zip(values, monomial, strict=True)) * side ** (total - sum(monomial))
            for monomial, value in weights
        ]


def _degree(polynomial: PolyElement) -> int:
    return max(max(monomial) for monomial in polynomial.monoms())


def _integers(polynomial: PolyElement) -> list[tuple[Monomial, int]]:
    """The terms with all coefficients multiplied by their common denominator."""
    fractions = [(monomial, rational_number(value)) for monomial, value in polynomial.terms()]
    denominator = lcm(*(value.denominator for _, value in fractions))
    return [(monomial, int(value * denominator)) for monomial, value in fractions]


def rational_number(number: PolyCoefficient) -> Fraction:
    """A coefficient as a fraction."""
    return Fraction(int(number.numerator), int(number.denominator))
