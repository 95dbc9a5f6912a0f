"""Sums of exponentials of variances and covariances, written so that what cancels in them is left out beforehand.

A sum c₁ e^(x + y) + c₂ e^(2x − y) + … that vanishes without errors is written over the products of what each variance
or covariance adds by itself, e^x − 1. What vanishes with x then has it as a factor in each product, however large the
other errors are. Where the sum begins with a higher power of x, the first terms of the series of e^x cancel between the
products; they are left out of each: x^2/2 + x^3/6 + … is written.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from functools import cached_property
from itertools import chain, combinations

from radartrack.derive import symbolic as sp
from radartrack.derive.stable.bernstein_polynomials import Decay, Monomial
from radartrack.derive.stable.horner import nested
from radartrack.derive.symbolic import Expr, Symbol

HIGHEST = 6


class Exponents:
    """The exponents of sums of e^(−n₁ step₁ product₁ − …), by the counts n.

    Args:
        decays: step and product of each.
    """

    def __init__(self, decays: Sequence[Decay]) -> None:
        self._decays = decays

    @cached_property
    def names(self) -> dict[Symbol, Expr]:
        """A name for each product: that of a variance or a covariance, where it is one."""
        found: dict[Symbol, Expr] = {}
        for decay in self._decays:
            kind = _kind(decay)
            name = f"{kind}_{decay.attenuation.name.removeprefix('attenuation_')}"
            while sp.Symbol(name, real=True) in found:
                name += "_"
            found[sp.Symbol(name, real=True)] = decay.product
        return found

    def total(self, coefficients: Mapping[Monomial, Fraction]) -> Expr:
        """Σ coefficient · e^(exponent), as it stands where it does not vanish with all errors."""
        live = {counts: value for counts, value in sorted(coefficients.items()) if value}
        if sum(live.values()):
            return sp.Add(*(sp.Rational(value) * sp.exp(self._exponent(counts)) for counts, value in live.items()))
        return nested(sp.Add(*self._products(live)))

    def _products(self, coefficients: Mapping[Monomial, Fraction]) -> Iterator[Expr]:
        """e^(x + y) as 1 + (e^x − 1) + (e^y − 1) + (e^x − 1)(e^y − 1): what vanishes with x vanishes in each factor."""
        variables = range(len(self._decays))
        for chosen in chain.from_iterable(combinations(variables, n) for n in range(1, len(variables) + 1)):
            live = _only(coefficients, chosen)
            for place, variable in enumerate(chosen):
                if not self._decays[variable].variance_is_positive:
                    live = _by_parity(live, place)
            factors = [self._factors(live, place, variable) for place, variable in enumerate(chosen)]
            for counts, value in live.items():
                yield sp.Mul(sp.Rational(value), *(found[count] for found, count in zip(factors, counts, strict=True)))

    def _factors(self, coefficients: Mapping[Monomial, Fraction], place: int, variable: int) -> dict[int, Expr]:
        """What one variable contributes to a product, by its count: negative ones stand for the odd part."""
        step = {counts[place]: self._step(variable, counts[place]) for counts in coefficients}
        if self._decays[variable].variance_is_positive:
            order = _order(coefficients, place)
            return {count: _rest(exponent, order) for count, exponent in step.items()}
        even = _order({c: value for c, value in coefficients.items() if c[place] > 0}, place, 2, 2)
        odd = _order({c: value for c, value in coefficients.items() if c[place] < 0}, place, 1, 2)
        return {count: _even(x, even) if count > 0 else _odd(x, odd) for count, x in step.items()}

    def _exponent(self, counts: Monomial) -> Expr:
        return sp.Add(*(self._step(variable, count) for variable, count in enumerate(counts)))

    def _step(self, variable: int, count: int) -> Expr:
        return sp.Rational(-count * self._decays[variable].step) * list(self.names)[variable]


def _kind(decay: Decay) -> str:
    if decay.variance_is_positive:
        return "variance"
    return "covariance" if any(getattr(s, "is_correlation", False) for s in decay.product.free_symbols) else "exponent"


def _only(coefficients: Mapping[Monomial, Fraction], chosen: Sequence[int]) -> dict[Monomial, Fraction]:
    """The coefficients by the counts of some variables, all of which occur."""
    found: dict[Monomial, Fraction] = {}
    for counts, value in coefficients.items():
        kept = tuple(counts[variable] for variable in chosen)
        if all(kept):
            found[kept] = found.get(kept, Fraction(0)) + value
    return {counts: value for counts, value in sorted(found.items()) if value}


def _by_parity(coefficients: Mapping[Monomial, Fraction], place: int) -> dict[Monomial, Fraction]:
    """e^(−nx) − 1 as (cosh nx − 1) − sinh nx, at the counts n and −n: of a covariance both signs of n occur."""
    found: dict[Monomial, Fraction] = {}
    for counts, value in coefficients.items():
        count = counts[place]
        for other, part in ((abs(count), value), (-abs(count), value if count > 0 else -value)):
            key = (*counts[:place], other, *counts[place + 1 :])
            found[key] = found.get(key, Fraction(0)) + part
    return {counts: value for counts, value in sorted(found.items()) if value}


def _order(coefficients: Mapping[Monomial, Fraction], place: int, first: int = 1, step: int = 1) -> int:
    """The power of one variable with which a sum of products begins, whatever the others are."""
    for order in range(first, HIGHEST, step):
        found: dict[Monomial, Fraction] = {}
        for counts, value in coefficients.items():
            others = counts[:place] + counts[place + 1 :]
            found[others] = found.get(others, Fraction(0)) + value * counts[place] ** order
        if any(found.values()):
            return order
    return HIGHEST


def _rest(exponent: Expr, order: int) -> Expr:
    return sp.expm1(exponent) if order == 1 else sp.remainder(exponent, order)


def _even(exponent: Expr, order: int) -> Expr:
    """cosh x − 1, without the terms of its series below an order."""
    if order == 2:
        return 2 * sp.sinh(exponent / 2) ** 2
    return (sp.remainder(exponent, order) + sp.remainder(-exponent, order)) / 2


def _odd(exponent: Expr, order: int) -> Expr:
    """−sinh |n| x of an exponent −nx with a negative count n, without the terms of its series below an order."""
    if order == 1:
        return -sp.sinh(exponent)
    return (sp.remainder(-exponent, order) - sp.remainder(exponent, order)) / 2
