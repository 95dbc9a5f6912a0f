"""Rewrites expressions with roots and quotients: one denominator each, their numerators factored."""

from __future__ import annotations

from functools import reduce
from operator import mul
from typing import TYPE_CHECKING

from radartrack.derive import symbolic as sp
from radartrack.derive.algebra.common_denominator import Denominator, Powers, collect, denominators, without_squares
from radartrack.derive.algebra.differential_ring import DifferentialRing
from radartrack.derive.language.stable_form import NotProved, StableForm
from radartrack.derive.language.tensor import Tensor
from radartrack.derive.symbolic import Expr, PolyElement, Symbol

SHORT = 4  # terms of a sum that is not worth another factorization: the sums of the series have up to fifty

if TYPE_CHECKING:
    from radartrack.derive.symbolic import PolyCoefficient


def collected_form(entries: Tensor[Expr]) -> StableForm:
    """Rewrite a tensor of expressions with roots, quotients and elementary functions.

    Raises:
        NotDifferentiable: when an entry holds anything else.
        NotProved: when a rewritten entry is not the same function.
    """
    symbols = {symbol for entry in entries for symbol in entry.free_symbols}
    ring = DifferentialRing(entries, symbols)
    found = denominators(ring)
    elements = entries.map_distinct(ring.read)
    collected = elements.map_distinct(lambda element: collect(element, ring, found))
    plain = _outside(ring)
    written = collected.map(lambda parts: _written(parts, ring, found, plain))
    definitions = {denominator.name: denominator.definition(ring) for denominator in found}
    form = StableForm(definitions, written).only(written)
    for entry, parts in zip(form.expanded(), collected, strict=True):
        if collect(ring.read(entry), ring, found) != parts:
            raise NotProved(f"{entry} is not what it was collected from")
    return form


def _outside(ring: DifferentialRing) -> set[Symbol]:
    """The symbols that no generator depends on."""
    inside = {symbol for key in ring.generators.values() for symbol in key.free_symbols}
    return set(ring.symbols) - inside


def _written(
    parts: dict[Powers, PolyElement], ring: DifferentialRing, found: list[Denominator], outside: set[Symbol]
) -> Expr:
    terms = []
    for powers, numerator in parts.items():
        below = reduce(mul, (d.name ** (-power) for d, power in zip(found, powers, strict=True)), sp.Integer(1))
        terms.append(below * _factored(numerator, ring, outside))
    return sp.Add(*terms)


def _factored(numerator: PolyElement, ring: DifferentialRing, outside: set[Symbol]) -> Expr:
    """Grouped by monomials in the symbols outside of roots; the coefficient of each is factored."""
    groups: dict[Powers, dict[Powers, PolyCoefficient]] = {}
    is_outside = [symbol in outside for symbol in ring.ring.symbols]
    for powers, value in numerator.terms():
        monomial = tuple(n if out else 0 for n, out in zip(powers, is_outside, strict=True))
        rest = tuple(0 if out else n for n, out in zip(powers, is_outside, strict=True))
        groups.setdefault(monomial, {})[rest] = value
    terms = (
        ring.expression(ring.ring.from_dict({monomial: ring.ring.domain.one}))
        * _in_factors(ring.ring.from_dict(rest), ring)
        for monomial, rest in groups.items()
    )
    return sp.Add(*terms)


def _in_factors(polynomial: PolyElement, ring: DifferentialRing) -> Expr:
    """With cos² or with sin², whichever has fewer terms: 1 − cos² cancels where sin² does not.

    Where that leaves a long sum, and the other falls into shorter factors, the other: the square of a slope that
    vanishes somewhere is a sum of any size over sines alone, whose terms cancel there, and exact as a square.
    """
    forms = sorted((polynomial, without_squares(polynomial, ring, sp.cos)), key=lambda one: len(one.terms()))
    shorter = sp.factor(ring.expression(forms[0]))
    if _longest_sum(shorter) <= SHORT:
        return shorter
    other = _with_sines(sp.factor(ring.expression(forms[1])))
    return min((shorter, other), key=_longest_sum)


def _longest_sum(expression: Expr) -> int:
    """The terms of the longest sum among the factors."""
    bases = [factor.as_base_exp()[0] for factor in sp.Mul.make_args(expression)]
    return max((len(base.args) for base in bases if isinstance(base, sp.Add)), default=1)


def _with_sines(product: Expr) -> Expr:
    """A product in which −sin² stands for (cos − 1)(cos + 1)."""
    powers = dict(factor.as_base_exp() for factor in sp.Mul.make_args(product))
    found: Expr = sp.Integer(1)
    for cosine in sorted(product.atoms(sp.cos), key=str):
        both = [powers.get(cosine + sign, sp.Integer(0)) for sign in (-1, 1)]
        if all(power.is_positive for power in both):
            common = min(both)
            found *= (-(sp.sin(*cosine.args) ** 2)) ** common
            powers |= {cosine - 1: both[0] - common, cosine + 1: both[1] - common}
    return sp.Mul(found, *(base**power for base, power in powers.items()))
