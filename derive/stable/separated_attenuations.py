"""Polynomials in several attenuations by factors, and over what each attenuation adds by itself.

Brought to one degree in all attenuations at once, a polynomial without cancellation may have two hundred terms where

    1/(a b) − a b = (1 − a²b²)/(a b),    p(a, b) = p(1, 1) + [p(a, 1) − p(1, 1)] + [p(1, b) − p(1, 1)] + …

have ten: a product of positive factors cancels nowhere, nor does a sum of what each shortfall adds, where all add with
one sign. What vanishes with one of the errors has it as a factor then, whatever the others are. Of all such forms the
shortest is taken; of sums that change their sign the shortest whose terms are no larger.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from fractions import Fraction
from functools import lru_cache
from itertools import chain, combinations, product
from math import prod

from radartrack.derive import symbolic as sp
from radartrack.derive.stable.bernstein_polynomials import (
    Coefficients,
    Decay,
    Form,
    Monomial,
    Point,
    bernstein,
    common,
    rational_number,
    without_common_power,
)
from radartrack.derive.symbolic import Expr, PolyElement, PolyRing

Size = Callable[[Point], Fraction]
SHORT = 3  # terms: no sum over what two attenuations add has fewer
PLACES = (Fraction(1, 2**20), Fraction(1, 2), 1 - Fraction(1, 2**20))  # of an attenuation, where terms are compared
MORE = 2  # one bit that the terms of a sum of changing sign may be larger for being fewer


@lru_cache(maxsize=4096)
def without_cancellation(coefficients: Coefficients, decays: tuple[Decay, ...]) -> Expr:
    """A polynomial in attenuations as the shortest of its forms in which nothing cancels, if there is one.

    `coefficients` pairs the powers of each attenuation, negative ones included, with rationals.
    """
    whole = bernstein(coefficients, decays)
    live = {powers: value for powers, value in sorted(coefficients) if value}
    several = [d for d in range(len(decays)) if any(powers[d] for powers in live)]
    if len(several) < 2 or (whole.sign and whole.terms <= SHORT):
        return whole.expression
    forms = sorted((_separated(live, decays, chosen) for chosen in _choices(several)), key=lambda form: form.terms)
    return next((form for form in forms if _is_better(form, whole, several, len(decays))), whole).expression


def _is_better(form: Form, whole: Form, several: Sequence[int], decays: int) -> bool:
    """Whether it is shorter and loses no more; where only the whole cancels, it is better however long it is."""
    if whole.sign or form.sign:
        return bool(form.sign) and (form.terms < whole.terms or not whole.sign)
    points = product(*(PLACES if d in several else (Fraction(1),) for d in range(decays)))
    return form.terms < whole.terms and all(form.size(point) <= MORE * whole.size(point) for point in points)


def _choices(numbers: Sequence[int]) -> Iterator[tuple[int, ...]]:
    return chain.from_iterable(combinations(numbers, count) for count in range(len(numbers) + 1))


def _separated(coefficients: Mapping[Monomial, Fraction], decays: tuple[Decay, ...], chosen: Sequence[int]) -> Form:
    """The sum over what each of the chosen attenuations adds by itself, and with others, each part in factors."""
    parts = [_in_factors(part, decays) for part in _parts(coefficients, chosen)]
    signs = {part.sign for part in parts}
    expression = sp.Add(*(part.expression for part in parts))
    sign = signs.pop() if len(signs) == 1 else 0
    size = _sum_of([part.size for part in parts])
    return Form(expression, sum(part.terms for part in parts), sign, size)


def _sum_of(sizes: Sequence[Size]) -> Size:
    return lambda point: sum((size(point) for size in sizes), Fraction(0))


def _product_of(number: Fraction, lowest: Monomial, sizes: Sequence[tuple[Size, int]]) -> Size:
    return lambda point: (
        abs(number)
        * prod(a**n for a, n in zip(point, lowest, strict=True))
        * prod(size(point) ** power for size, power in sizes)
    )


def _parts(coefficients: Mapping[Monomial, Fraction], chosen: Sequence[int]) -> Iterator[dict[Monomial, Fraction]]:
    """What a polynomial is with all chosen attenuations 1, and what others than 1 add, one, two, … of them at once."""
    for changed in _choices(chosen):
        part: dict[Monomial, Fraction] = {}
        for powers, value in coefficients.items():
            for left in _choices(changed):
                key = tuple(p if d in left or d not in chosen else 0 for d, p in enumerate(powers))
                part[key] = part.get(key, Fraction(0)) + (-1) ** (len(changed) - len(left)) * value
        part = {powers: value for powers, value in part.items() if value}
        if part:
            yield part


def _in_factors(coefficients: Mapping[Monomial, Fraction], decays: tuple[Decay, ...]) -> Form:
    """A number times irreducible polynomials, each of which is written so that it is positive, where it has a sign."""
    lowest, left = without_common_power(coefficients)
    ring = PolyRing([decay.attenuation for decay in decays], sp.QQ)
    polynomial = ring.from_dict({powers: sp.QQ(c.numerator, c.denominator) for powers, c in left.items()})
    number, factors = rational_number(polynomial.LC), list[tuple[Form, int]]()
    for factor, power in _sorted(polynomial.factor_list()[1]):
        form, leading = bernstein(_coefficients(factor), decays), rational_number(factor.LC)
        if form.sign < 0:
            form, leading = bernstein(_coefficients(-factor), decays), -leading
        number /= leading**power
        factors.append((form, power))
    expression = sp.Mul(common(lowest, decays), *(form.expression**power for form, power in factors))
    terms = 1 + sum(form.terms for form, _ in factors if form.terms > 1)
    sign = prod(form.sign for form, _ in factors) * (1 if number > 0 else -1)
    size = _product_of(number, lowest, [(form.size, power) for form, power in factors])
    return Form(sp.Rational(number) * expression, terms, sign, size)


def _sorted(factors: Sequence[tuple[PolyElement, int]]) -> list[tuple[PolyElement, int]]:
    """With coprime whole coefficients, the first of them positive, in an order that no other library changes."""
    found = [(factor.primitive()[1], power) for factor, power in factors]
    positive = [(factor if factor.LC > 0 else -factor, power) for factor, power in found]
    return sorted(positive, key=lambda one: sorted(_coefficients(one[0])))


def _coefficients(polynomial: PolyElement) -> Coefficients:
    return frozenset((powers, rational_number(value)) for powers, value in polynomial.terms())
