"""What may be taken out of a root: the factors of its radicand that are never negative."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Mapping
from operator import sub

import mpmath

from radartrack.derive import symbolic as sp
from radartrack.derive.language.variable import Variable
from radartrack.derive.symbolic import PolyElement, PolyRing

DIGITS = 60  # of constants such as pi, to tell the sign of a coefficient
CERTAIN = 1e-40  # a coefficient nearer to zero has no sign that is known

Constants = Mapping[PolyElement, mpmath.mpf]


def split(
    value: PolyElement, times: int, constants: Constants, *, thorough: bool
) -> tuple[list[tuple[PolyElement, int]], PolyElement]:
    """Factors that are never negative, with their powers, and what is left of a power of a polynomial.

    Args:
        value: the polynomial.
        times: the power.
        constants: symbols of the ring that stand for numbers.
        thorough: whether all of its factors are looked for, which may take long, or symbols only.
    """
    ring = value.ring
    if any(number.y for number in value.coeffs()):
        return [], value**times
    real = PolyRing(ring.symbols, sp.QQ).from_dict({monomial: number.x for monomial, number in value.terms()})
    number, factors = real.factor_list() if thorough else _by_symbols(real)
    rest, found = ring(sp.QQ_I(number, 0)) ** times, []
    for factor, power in ((factor, power * times) for factor, power in factors):
        monic = ring.from_dict({monomial: sp.QQ_I(one / factor.LC, 0) for monomial, one in factor.terms()})
        rest = rest * ring(sp.QQ_I(factor.LC, 0)) ** power
        if sign := _sign(monic, constants):
            rest = rest * ring(sign) ** power
            found.append((monic * sign, power))
        elif power % 2 == 0 and _is_real(monic, constants):
            found.append((monic**2, power // 2))
        else:
            rest = rest * monic**power
    return found, rest


def _by_symbols(value: PolyElement) -> tuple[sp.PolyCoefficient, list[tuple[PolyElement, int]]]:
    """The symbols that divide all of a polynomial, and the rest of it."""
    powers = [min(of_one) for of_one in zip(*value.monoms(), strict=True)]
    left = {tuple(map(sub, monomial, powers)): number for monomial, number in value.terms()}
    symbols = [(symbol, power) for symbol, power in zip(value.ring.gens, powers, strict=True) if power]
    return sp.QQ(1), [*symbols, (value.ring.from_dict(left), 1)]


def _sign(value: PolyElement, constants: Constants) -> int:
    """1 where a polynomial is never negative, -1 where it is never positive, 0 where neither is seen."""
    numbers = _coefficients(_from_the_least(value), constants)
    if all(number > CERTAIN for number in numbers):
        return 1
    return -1 if all(number < -CERTAIN for number in numbers) else 0


def _from_the_least(value: PolyElement) -> PolyElement:
    """The polynomial in how far its whole numbers exceed the least that they may be: k**2 - 4 is (k + 3)**2 - 4."""
    for symbol, generator in zip(value.ring.symbols, value.ring.gens, strict=True):
        if isinstance(symbol, Variable) and symbol.whole and symbol.low > 0:
            value = value.compose(generator, generator + int(symbol.low))
    return value


def _coefficients(value: PolyElement, constants: Constants) -> list[mpmath.mpf]:
    """The coefficients of a polynomial in what is no constant; nan for one of a monomial that may have either sign."""
    places = {value.ring.gens.index(generator): number for generator, number in constants.items()}
    collected: dict[tuple[int, ...], mpmath.mpf] = defaultdict(mpmath.mpf)
    with mpmath.workdps(DIGITS):
        for monomial, coefficient in value.terms():
            number = mpmath.mpf(int(coefficient.x.numerator)) / int(coefficient.x.denominator)
            for place, constant in places.items():
                number *= constant ** monomial[place]
            left = tuple(0 if place in places else power for place, power in enumerate(monomial))
            collected[left] += number
    return [number if _is_never_negative(value.ring, left) else mpmath.nan for left, number in collected.items()]


def _is_never_negative(ring: PolyRing, monomial: tuple[int, ...]) -> bool:
    powers = [(symbol, power) for symbol, power in zip(ring.symbols, monomial, strict=True) if power]
    return all(symbol.is_nonnegative or (symbol.is_real and power % 2 == 0) for symbol, power in powers)


def _is_real(value: PolyElement, constants: Constants) -> bool:
    """Whether it is made of real symbols alone; roots may be imaginary."""
    real = [symbol.is_real or one in constants for symbol, one in zip(value.ring.symbols, value.ring.gens, strict=True)]
    return all(may or not power for monomial in value.monoms() for may, power in zip(real, monomial, strict=True))
