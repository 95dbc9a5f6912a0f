"""Polynomials with the smallest largest error, their coefficients rounded one after the other.

Remez's exchange (Remez 1934; Cheney, Introduction to Approximation Theory, 1966, chapter 3) on a grid, in fifty digits.
Coefficients rounded all at once would lose two or three bits: so the lowest is rounded, the others are fitted
again to what is left, and so on (Brisebarre & Chevillard 2007 look further, for less than a bit more).
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import mpmath

BITS = 170  # of the arithmetic
GRID = 160  # points, denser at the ends; between two of them an error grows by less than a thousandth
SETTLED = 1e-3  # relative difference of the largest error and the levelled one
EXCHANGES = 40

Real = Any
Function = Callable[[Real], Real]


@dataclass(frozen=True)
class Sought:
    """What a polynomial is to come close to.

    Attributes:
        function: of one variable.
        weight: by which its error counts; it may vanish at zero.
        ends: of the interval; zero may lie inside, but is no end.
    """

    function: Function
    weight: Function
    ends: tuple[Real, Real]


def polynomial(sought: Sought, degree: int, bits: int) -> tuple[float, ...]:
    """Coefficients from the constant upward, each of as many bits.

    Raises:
        ArithmeticError: the exchange does not settle.
    """
    with mpmath.workprec(BITS):
        low, high = sought.ends
        points = [(low + high) / 2 - (high - low) / 2 * mpmath.cos(mpmath.pi * i / (GRID - 1)) for i in range(GRID)]
        weights = [sought.weight(x) for x in points]
        rest = [sought.function(x) for x in points]
        found = []
        for power in range(degree + 1):
            found.append(rounded(_levelled(points, rest, weights, degree - power)[0], bits))
            rest = [(value - found[-1]) / x for x, value in zip(points, rest, strict=True)]
            weights = [weight * abs(x) for x, weight in zip(points, weights, strict=True)]
    return tuple(found)


def rounded(value: Real, bits: int) -> float:
    """The nearest number of so many bits."""
    scale = Fraction(2) ** (bits - int(mpmath.frexp(value)[1]))
    return float(round(_fraction(value) * scale) / scale)


def _fraction(value: Real) -> Fraction:
    significand, exponent = mpmath.mpf(abs(value)).man_exp
    size: Fraction = int(significand) * Fraction(2) ** int(exponent)
    return -size if value < 0 else size


def _levelled(points: Sequence[Real], values: Sequence[Real], weights: Sequence[Real], degree: int) -> list[Real]:
    """The coefficients of the best polynomial."""
    count = degree + 2
    places = [round((len(points) - 1) * i / (count - 1)) for i in range(count)]
    for _ in range(EXCHANGES):
        rows = [
            [*(points[n] ** power for power in range(degree + 1)), (-1) ** turn / weights[n]]
            for turn, n in enumerate(places)
        ]
        *coefficients, level = mpmath.lu_solve(mpmath.matrix(rows), mpmath.matrix([values[n] for n in places]))
        errors = [
            weight * (value - mpmath.polyval(coefficients[::-1], x))
            for x, value, weight in zip(points, values, weights, strict=True)
        ]
        if max(map(abs, errors)) <= abs(level) * (1 + SETTLED):
            return list(coefficients)
        places = _exchanged(errors, count)
    raise ArithmeticError(f"no best polynomial of degree {degree} was found")


def _exchanged(errors: Sequence[Real], count: int) -> list[int]:
    """Where the error is largest between its changes of sign; of too many, small ones are left out."""
    found: list[int] = []
    for place, error in enumerate(errors):
        if found and (error > 0) == (errors[found[-1]] > 0):
            if abs(error) > abs(errors[found[-1]]):
                found[-1] = place
        else:
            found.append(place)
    while len(found) > count:
        sizes = [abs(errors[n]) for n in found]
        least = sizes.index(min(sizes))
        if len(found) == count + 1 or least in {0, len(found) - 1}:
            found.pop(0 if sizes[0] < sizes[-1] else -1)
        else:  # with its smaller neighbour, so that the signs still alternate
            beside = least if sizes[least + 1] < sizes[least - 1] else least - 1
            del found[beside : beside + 2]
    if len(found) < count:
        raise ArithmeticError("an error changes its sign too seldom to be the smallest")
    return found
