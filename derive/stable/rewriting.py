"""The rewriting for floating point that serves whatever has no rewriting of its own."""

from __future__ import annotations

from radartrack.derive.algebra.differential_ring import NotDifferentiable
from radartrack.derive.algebra.exponential_polynomial import NotExponentialPolynomial
from radartrack.derive.language.stable_form import NotProved, StableForm
from radartrack.derive.language.tensor import Tensor
from radartrack.derive.stable.attenuation import stable_form
from radartrack.derive.stable.roots_and_quotients import collected_form
from radartrack.derive.symbolic import Expr


def general_form(entries: Tensor[Expr]) -> StableForm:
    """The stable form of exponential polynomials, else roots and quotients over one denominator, else as derived.

    Raises:
        NotProved: when a rewritten entry is not the same function.
    """
    try:
        return stable_form(entries)
    except NotExponentialPolynomial:
        pass
    try:
        return collected_form(entries)
    except (NotDifferentiable, NotProved):  # where denominators stand in denominators there is no unique form
        return StableForm({}, entries)
