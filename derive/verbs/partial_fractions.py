"""Partial fractions over linear and quadratic factors, with symbols as coefficients."""

from __future__ import annotations

from dataclasses import dataclass

from radartrack.derive import symbolic as sp
from radartrack.derive.symbolic import Expr, Symbol
from radartrack.derive.verbs.no_closed_form import NoClosedForm, shown

HIGHEST_DEGREE = 12  # of a denominator
ZERO: Expr = sp.Integer(0)


@dataclass(frozen=True)
class PartialFraction:
    """A numerator over a power of one factor.

    Attributes:
        degree: of the factor: 0 for a term c·s^power, 1 for s − root, 2 for (s − root)² + variance.
        power: of the factor, or of the variable.
        numerator: c, or c + d·s as (c, d).
        root: of a linear factor; the middle of a quadratic one.
        variance: of a quadratic factor; negative where it has real roots.
    """

    degree: int
    power: int
    numerator: tuple[Expr, ...]
    root: Expr = ZERO
    variance: Expr = ZERO


def partial_fractions(function: Expr, variable: Symbol) -> list[PartialFraction]:
    """A rational function of one variable as a sum.

    Raises:
        NoClosedForm: when it is none, or its denominator has a factor of higher degree.
    """
    above, below = sp.fraction(sp.cancel(sp.together(function)))
    if not all(part.is_polynomial(variable) for part in (above, below)):
        raise NoClosedForm(f"{shown(function)} is neither an exponential polynomial nor a rational function here")
    numerator, denominator = sp.Poly(above, variable), sp.Poly(below, variable)
    if denominator.degree() > HIGHEST_DEGREE:
        raise NoClosedForm(f"the denominator {shown(below)} is of too high a degree; {HIGHEST_DEGREE} is allowed")
    whole, rest = numerator.div(denominator)
    found = [PartialFraction(0, powers[0], (coefficient,)) for powers, coefficient in whole.terms() if coefficient != 0]
    constant, factors = sp.factor_list(below, variable)
    for factor, power in factors:
        others = sp.Poly(constant, variable) * _product(factors, factor, variable)
        found += _of_factor(rest, others, sp.Poly(factor, variable), power)
    return found


def _product(factors: list[tuple[Expr, int]], left_out: Expr, variable: Symbol) -> sp.Poly:
    result = sp.Poly(1, variable)
    for factor, power in factors:
        if factor != left_out:
            result = result * sp.Poly(factor, variable) ** power
    return result


def _of_factor(numerator: sp.Poly, others: sp.Poly, factor: sp.Poly, power: int) -> list[PartialFraction]:
    """The fractions over powers of one factor: its expansion in that factor, digit by digit."""
    if factor.degree() > 2:
        raise NoClosedForm(f"the factor {shown(factor.as_expr())} is of degree {factor.degree()}; 2 is allowed")
    leading = factor.LC()
    monic = factor.monic()
    modulus = monic**power
    residue = (numerator * _inverted(others, modulus)).rem(modulus)
    found = []
    for n in reversed(range(1, power + 1)):
        residue, digit = residue.div(monic)
        if not digit.is_zero:
            found.append(_fraction(digit, monic, n, leading**power))
    return found


def _inverted(value: sp.Poly, modulus: sp.Poly) -> sp.Poly:
    """The inverse modulo a polynomial that shares no factor with it."""
    return value.to_field().invert(modulus.to_field())


def _fraction(digit: sp.Poly, factor: sp.Poly, power: int, leading: Expr) -> PartialFraction:
    numbers = [coefficient / leading for coefficient in reversed(digit.all_coeffs())]
    if factor.degree() == 1:
        return PartialFraction(1, power, (numbers[0],), root=-factor.all_coeffs()[1])
    _, slope, constant = factor.all_coeffs()
    middle = -slope / 2
    numerator = (numbers[0], numbers[1] if len(numbers) > 1 else ZERO)
    return PartialFraction(2, power, numerator, root=middle, variance=sp.cancel(constant - middle**2))
