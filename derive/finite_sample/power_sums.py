"""Sums of powers over equally spaced scans, in closed form for a symbolic number of them."""

from __future__ import annotations

from functools import cache
from math import comb

from radartrack.derive import symbolic as sp
from radartrack.derive.symbolic import Expr, Symbol


@cache
def power_sum(exponent: int, count: Symbol) -> Expr:
    """0^n + 1^n + … + (count − 1)^n, factored; 0^0 counts as 1.

    Summing (i + 1)^(n+1) − i^(n+1) over i telescopes to count^(n+1), which gives each sum from those before
    it (Pascal).
    """
    lower = sp.Add(*(comb(exponent + 1, n) * power_sum(n, count) for n in range(exponent)))
    return sp.factor((count ** (exponent + 1) - lower) / (exponent + 1))


def summed(polynomial: Expr, index: Symbol, count: Symbol) -> Expr:
    """The sum of a polynomial in `index` over index = 0, 1, …, count − 1; other symbols are constants."""
    return sp.Add(*(_summed(term, index, count) for term in sp.Add.make_args(sp.expand(polynomial))))


def _summed(term: Expr, index: Symbol, count: Symbol) -> Expr:
    exponent = int(term.as_powers_dict().get(index, sp.Integer(0)))
    return term / index**exponent * power_sum(exponent, count)
