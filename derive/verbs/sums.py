"""Sums over an index with a closed form: polynomials times powers q^j, for a symbolic number of terms.

A term j^p q^j has the antidifference q^j P(j) with a polynomial P of degree p, found from the highest power downwards
by q P(j + 1) − P(j) = j^p; for q = 1 the degree is one more. The sum is what the antidifference grows by.
"""

from __future__ import annotations

from collections.abc import Iterator
from math import comb

from radartrack.derive import symbolic as sp
from radartrack.derive.symbolic import Expr, Symbol
from radartrack.derive.verbs.no_closed_form import NoClosedForm, shown

MOST_ADDED = 1_000  # terms that are added one by one where there is no closed form
HIGHEST_POWER = 64  # of the index; as of any power in a formula
ZERO: Expr = sp.Integer(0)
ONE: Expr = sp.Integer(1)


def summed(term: Expr, index: Symbol, first: Expr, last: Expr) -> Expr:
    """The sum of a term over index = first, first + 1, …, last.

    Raises:
        NoClosedForm: naming the part that is no polynomial times a power of the index, where the number of terms is
            symbolic or large.
    """
    try:
        return sp.Add(*(_summed(part, index, first, last) for part in sp.Add.make_args(sp.expand(term))))
    except NoClosedForm:
        count = last - first
        if not isinstance(count, sp.Integer) or not 0 <= int(count) < MOST_ADDED:
            raise
        return sp.Add(*(term.xreplace({index: first + sp.Integer(n)}) for n in range(int(count) + 1)))


def _summed(part: Expr, index: Symbol, first: Expr, last: Expr) -> Expr:
    """The sum of c · j^p · q^j."""
    factor, power, base = _split(part, index)
    if base == ONE:
        coefficients = _antidifference_of_power(power)
        grown = _at(coefficients, last + 1) - _at(coefficients, first)
    else:
        coefficients = _antidifference(power, base)
        grown = base ** (last + 1) * _at(coefficients, last + 1) - base**first * _at(coefficients, first)
    return factor * grown


def _split(part: Expr, index: Symbol) -> tuple[Expr, int, Expr]:
    """A product as c, p and q of c · j^p · q^j."""
    factor: Expr = ONE
    power, base = 0, ONE
    for one in sp.Mul.make_args(part):
        if index not in one.free_symbols:
            factor *= one
        elif (degree := _power_of(one, index)) is not None:
            power += degree
        else:
            constant, growing = _geometric(one, index)
            factor, base = factor * constant, base * growing
    if power > HIGHEST_POWER:
        raise NoClosedForm(f"the power {power} of {index} is too high; {HIGHEST_POWER} is allowed")
    return factor, power, base


def _power_of(one: Expr, index: Symbol) -> int | None:
    base, exponent = one.as_base_exp()
    return int(exponent) if base == index and isinstance(exponent, sp.Integer) and exponent > 0 else None


def _geometric(one: Expr, index: Symbol) -> tuple[Expr, Expr]:
    """A factor b^(m j + n) as b^n and b^m; e^x is one with the base e."""
    exponent = one.args[0] if isinstance(one, sp.exp) else one.exp if isinstance(one, sp.Pow) else None
    if exponent is not None and not (isinstance(one, sp.Pow) and index in one.base.free_symbols):
        step = sp.diff(exponent, index)
        if index not in step.free_symbols:
            base = sp.E if isinstance(one, sp.exp) else one.base
            return base ** sp.expand(exponent - step * index), base**step
    raise NoClosedForm(f"the sum over {index} of {shown(one)} has no closed form that is known here")


def _antidifference(power: int, base: Expr) -> list[Expr]:
    """Coefficients of P, the lowest first, with q P(j + 1) − P(j) = j^p for q other than 1."""
    found: list[Expr] = [ZERO] * (power + 1)
    for m in reversed(range(power + 1)):
        above = sp.Add(*(found[i] * sp.Integer(comb(i, m)) for i in range(m + 1, power + 1)))
        found[m] = (sp.Integer(int(m == power)) - base * above) / (base - 1)
    return found


def _antidifference_of_power(power: int) -> list[Expr]:
    """Coefficients of P with P(j + 1) − P(j) = j^p."""
    found: list[Expr] = [ZERO] * (power + 2)
    for m in reversed(range(power + 1)):
        above = sp.Add(*(found[i] * sp.Integer(comb(i, m)) for i in range(m + 2, power + 2)))
        found[m + 1] = (sp.Integer(int(m == power)) - above) / sp.Integer(m + 1)
    return found


def _at(coefficients: list[Expr], place: Expr) -> Expr:
    """The polynomial at a place."""
    return sp.Add(*_terms(coefficients, place))


def _terms(coefficients: list[Expr], place: Expr) -> Iterator[Expr]:
    return (coefficient * place**power for power, coefficient in enumerate(coefficients))
