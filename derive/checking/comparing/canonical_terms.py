"""Two formulas term by term in one canonical form: of several slips in a long one, the terms that differ say where."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from radartrack.derive import symbolic as sp
from radartrack.derive.algebra.exponential_polynomial import (
    Effort,
    ExponentialPolynomial,
    NotExponentialPolynomial,
    TooLong,
    ring_over,
)
from radartrack.derive.checking.reporting.verdict import TermDifference
from radartrack.derive.formula.from_expression import to_tree
from radartrack.derive.formula.printing import to_text
from radartrack.derive.language.tensor import Index
from radartrack.derive.symbolic import Expr

MOST = 12  # terms that differ; a formula that differs in more is another one
PRODUCTS = 20_000


def differing_terms(printed: Expr, derived: Expr, entry: Index) -> tuple[TermDifference, ...]:
    """The terms of sines, cosines and exponentials whose coefficients differ; nothing where that says nothing.

    That is where one of the two is no such sum, and where more terms differ than are alike.
    """
    try:
        with Effort(PRODUCTS):
            first, second = _terms(printed, derived), _terms(derived, printed)
    except (NotExponentialPolynomial, TooLong):
        return ()
    differing = [term for term in {**second, **first} if first.get(term, ZERO) != second.get(term, ZERO)]
    if len(differing) > min(MOST, len(second)):
        return ()
    return tuple(
        TermDifference(_text(term), str(first.get(term, ZERO)), str(second.get(term, ZERO)), entry)
        for term in sorted(differing, key=_text)
    )


ZERO = sp.Integer(0)


def _terms(expression: Expr, beside: Expr) -> Mapping[Expr, Expr]:
    """The coefficients of a formula in its canonical form, over the symbols of both formulas."""
    ring = ring_over(sorted(expression.free_symbols | beside.free_symbols, key=str))
    canonical = sp.expand(ExponentialPolynomial.read(expression, ring).expression())
    return dict(_split(canonical))


def _split(total: Expr) -> Iterator[tuple[Expr, Expr]]:
    for term in sp.Add.make_args(total):
        coefficient, rest = term.as_coeff_Mul()
        if coefficient:
            yield rest, coefficient


def _text(term: Expr) -> str:
    return to_text(to_tree(term))
