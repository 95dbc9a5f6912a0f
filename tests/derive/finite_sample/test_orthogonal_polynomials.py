"""The rewriting over orthogonal polynomials is proved equal, and a slip in its table does not pass."""

import pytest
import sympy

from radartrack.derive.algebra.rational_function import is_zero
from radartrack.derive.catalogue import catalogue
from radartrack.derive.finite_sample import orthogonal_polynomials
from radartrack.derive.finite_sample.least_squares_filter import C, FiniteSample
from radartrack.derive.finite_sample.orthogonal_polynomials import GramForm
from radartrack.derive.language.quantity import Quantity
from radartrack.derive.stable.quantity_form import form_of

REWRITTEN = [q for q in catalogue().values() if q.name.startswith("finite_sample.") and q.rewriting is not None]


@pytest.mark.parametrize("quantity", REWRITTEN, ids=lambda quantity: quantity.name)
def test_every_rewritten_quantity_is_proved(quantity: Quantity) -> None:
    form_of(quantity)


@pytest.mark.parametrize("symbol", orthogonal_polynomials.PER_NORM, ids=str)
@pytest.mark.parametrize("factor", [-1, sympy.Rational(1001, 1000), 1 + C])
def test_a_wrong_norm_is_noticed(symbol: sympy.Symbol, factor: sympy.Expr) -> None:
    found = FiniteSample(3, with_rate=True)
    form = GramForm(found).covariance
    spoiled = {name: value * factor if name == symbol else value for name, value in form.definitions.items()}
    entry = type(form)(spoiled, form.entries).expanded()[0, 0]
    assert not is_zero(entry - found.covariance[0, 0])
