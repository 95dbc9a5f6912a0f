"""Expectations of printed formulas over independent Gaussian errors, by the operator e^L."""

from __future__ import annotations

from collections.abc import Mapping

from radartrack.derive import symbolic as sp
from radartrack.derive.algebra.exponential_polynomial import (
    ExponentialPolynomial,
    NotExponentialPolynomial,
    ring_over,
)
from radartrack.derive.moments.gaussian_operator import GaussianOperator
from radartrack.derive.symbolic import Expr, Symbol
from radartrack.derive.verbs.constants import Constants
from radartrack.derive.verbs.no_closed_form import NoClosedForm


def expectation(function: Expr, deviations: Mapping[Symbol, Expr]) -> Expr:
    """E f(x + w) with an independent error w of the deviation given for each symbol.

    Raises:
        NoClosedForm: when the function is no polynomial times sines, cosines and exponentials of linear forms in the
            symbols, or a deviation is no polynomial.
    """
    variables = tuple(deviations)
    constants = Constants(variables)
    function = sp.expand(constants.hidden(function))
    deviations = {symbol: constants.hidden(sigma) for symbol, sigma in deviations.items()}
    covariance = [[sigma**2 if a is b else sp.Integer(0) for b in variables] for a, sigma in deviations.items()]
    symbols = {*variables, *function.free_symbols}.union(*(sigma.free_symbols for sigma in deviations.values()))
    try:
        value = ExponentialPolynomial.read(function, ring_over(symbols))
        return constants.shown(GaussianOperator(variables, covariance).exponential(value).expression())
    except NotExponentialPolynomial as error:
        raise NoClosedForm(f"the expectation has no closed form: {error}") from None
