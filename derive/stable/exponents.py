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
            kind = "variance" if decay.variance_is_positive else "covariance"
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
            orders = [_order(live, i) for i in range(len(chosen))]
            for counts, value in live.items():
                rests = (
                    _rest(self._step(variable, count), order)
                    for variable, count, order in zip(chosen, counts, orders, strict=True)
                )
                yield sp.Mul(sp.Rational(value), *rests)

    def _exponent(self, counts: Monomial) -> Expr:
        return sp.Add(*(self._step(variable, count) for variable, count in enumerate(counts)))

    def _step(self, variable: int, count: int) -> Expr:
        return sp.Rational(-count * self._decays[variable].step) * list(self.names)[variable]


def _only(coefficients: Mapping[Monomial, Fraction], chosen: Sequence[int]) -> dict[Monomial, Fraction]:
    """The coefficients by the counts of some variables, all of which occur."""
    found: dict[Monomial, Fraction] = {}
    for counts, value in coefficients.items():
        kept = tuple(counts[variable] for variable in chosen)
        if all(kept):
            found[kept] = found.get(kept, Fraction(0)) + value
    return {counts: value for counts, value in sorted(found.items()) if value}


def _order(coefficients: Mapping[Monomial, Fraction], place: int) -> int:
    """The power of one variable with which a sum of products begins, whatever the others are."""
    for order in range(1, HIGHEST):
        found: dict[Monomial, Fraction] = {}
        for counts, value in coefficients.items():
            others = counts[:place] + counts[place + 1 :]
            found[others] = found.get(others, Fraction(0)) + value * counts[place] ** order
        if any(found.values()):
            return order
    return HIGHEST


def _rest(exponent: Expr, order: int) -> Expr:
    return sp.expm1(exponent) if order == 1 else sp.remainder(exponent, order)
