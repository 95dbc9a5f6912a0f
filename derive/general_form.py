"""The rewriting for floating point that serves whatever has no rewriting of its own."""

from __future__ import annotations

from radartrack.derive.collected import collected_form
from radartrack.derive.differential_ring import NotDifferentiable
from radartrack.derive.exponential import NotExponentialPolynomial
from radartrack.derive.stable import StableForm, stable_form
from radartrack.derive.symbolic import Expr
from radartrack.derive.tensor import Tensor


def general_form(entries: Tensor[Expr]) -> StableForm:
    """The stable form of exponential polynomials, else roots and quotients over one denominator, else as derived.

    Raises:
        NotProved: when a rewritten entry is not the same function.
    """
    for rewrite in (stable_form, collected_form):
        try:
            return rewrite(entries)
        except (NotExponentialPolynomial, NotDifferentiable):
            continue
    return StableForm({}, entries)
