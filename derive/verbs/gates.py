"""The chi-square distribution in formulas: its probabilities in closed form, and its quantiles, which are gates.

For a whole number n of degrees of freedom integration by parts ends. The probability below x is
1 − e^(−x/2) Σ (x/2)^k/k! over k < n/2 for an even n, and erf √(x/2) − e^(−x/2) Σ (x/2)^(k − 1/2)/Γ(k + 1/2) over
0 < k < n/2 for an odd one. Quantiles have a closed form for two degrees alone; others are numbers, to as many digits
as no print has.
"""

from __future__ import annotations

from math import factorial

import mpmath

from radartrack.derive import symbolic as sp
from radartrack.derive.formula.error import FormulaError
from radartrack.derive.symbolic import Expr
from radartrack.derive.verbs.no_closed_form import NoClosedForm

MOST_DEGREES = 1000
DIGITS = 60  # of a quantile; what is compared with it has fewer
MOST_STEPS = 2000  # halvings down to a quantile of 1e-600; Newton takes a dozen
HALF = sp.Rational(1, 2)


def probability(value: Expr, degrees: Expr) -> Expr:
    """The probability with which a chi-square variable is at most a value.

    Raises:
        FormulaError: the degrees of freedom are no whole number from 1 on, or too many, or the value is negative.
    """
    n, half = _degrees(degrees), value / 2
    if value.is_number and value.is_nonnegative is False:
        raise FormulaError(f"chi2cdf takes a value from 0 on; given {value}")
    if n % 2 == 0:
        terms = [half**k / sp.Integer(factorial(k)) for k in range(n // 2)]
        return 1 - sp.exp(-half) * sp.Add(*terms)
    at = sp.Integer(1) / sp.sqrt(sp.pi)  # over Γ(k + 1/2), k being 0
    terms = []
    for k in range(1, n // 2 + 1):
        at = at / (sp.Integer(2 * k - 1) * HALF)
        terms.append(at * sp.sqrt(half) * half ** (k - 1))
    return sp.erf(sp.sqrt(half)) - sp.exp(-half) * sp.Add(*terms)


def quantile(below: Expr, degrees: Expr) -> Expr:
    """The value that a chi-square variable does not exceed with a probability: a gate for a NIS or a NEES.

    Raises:
        FormulaError: as `probability`, or the probability is no rational number between 0 and 1.
        NoClosedForm: the quantile is less than a number has digits for.
    """
    n = _degrees(degrees)
    is_possible = below.is_positive and (1 - below).is_positive
    if n == 2 and (is_possible or not below.is_number):
        return -2 * sp.log(1 - below)
    if not (is_possible and isinstance(below, sp.Rational)):
        raise FormulaError(f"chi2inv takes a probability between 0 and 1 as a number; given {below}")
    with mpmath.workdps(DIGITS + 10):
        return sp.Rational(mpmath.nstr(_root(mpmath.mpf(int(below.p)) / int(below.q), n), DIGITS))


def _root(wanted: mpmath.mpf, degrees: int) -> mpmath.mpf:
    """By Newton's steps on the probability, and halves of the interval where a step would leave it, as in a tail."""
    low, high = mpmath.mpf(0), mpmath.mpf(degrees)
    while _below(high, degrees) < wanted:
        low, high = high, 2 * high
    half = mpmath.mpf(degrees) / 2
    value = (low + high) / 2
    for _ in range(MOST_STEPS):
        excess = _below(value, degrees) - wanted
        low, high = (value, high) if excess < 0 else (low, value)
        density = mpmath.exp((half - 1) * mpmath.log(value) - value / 2 - half * mpmath.log(2) - mpmath.loggamma(half))
        following = value - excess / density
        if not low <= following <= high:
            following = (low + high) / 2
        if abs(following - value) <= value * mpmath.mpf(10) ** (1 - DIGITS):
            return following
        value = following
    raise NoClosedForm("the quantile is too small to be found")


def _below(value: mpmath.mpf, degrees: int) -> mpmath.mpf:
    return mpmath.gammainc(mpmath.mpf(degrees) / 2, 0, value / 2, regularized=True)


def _degrees(degrees: Expr) -> int:
    if not isinstance(degrees, sp.Integer) or not 1 <= int(degrees) <= MOST_DEGREES:
        raise FormulaError(f"degrees of freedom are a whole number from 1 to {MOST_DEGREES}; given {degrees}")
    return int(degrees)
