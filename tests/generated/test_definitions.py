"""Every exact moment is the expectation that its name promises, by quadrature of that expectation."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from radartrack.derive.language.quantity import Quantity
from tests import conversions, maps
from tests.examples import share
from tests.generated.definitions import DEFINITIONS, Expectations
from tests.generated.test_taylor_moments import DERIVATIVES, MOMENTS
from tests.generated.test_truncated_moments import TRUNCATED

RELATIVE = 1e-9
DEFINED = conversions.of(*DEFINITIONS)
ESTIMATES = conversions.of("unbiased.estimate")


def test_every_quantity_of_a_model_has_a_definition_that_is_tested():
    rows = {conversions.row(quantity) for quantity in conversions.BY_HAND}
    rows = {
        row for row in rows if not row.endswith(".semidefinite")
    }  # tests/derive/moments/test_sums_of_squares.py has them
    assert rows <= {"unbiased.estimate", *DERIVATIVES, *MOMENTS, *DEFINITIONS, *TRUNCATED}


@pytest.mark.parametrize("quantity", DEFINED, ids=conversions.ids)
@given(data=st.data())
@share(0.1)
def test_the_exact_moment_is_the_quadrature_of_its_definition(quantity: Quantity, data: st.DataObject):
    point = data.draw(conversions.points(quantity))
    defined = DEFINITIONS[conversions.row(quantity)](Expectations(quantity.module, point, order=18), point)
    error = np.abs(conversions.generated(quantity)(**point) - defined) / conversions.scale(quantity, defined)
    assert error.max() < RELATIVE


@pytest.mark.parametrize("quantity", ESTIMATES, ids=conversions.ids)
@given(data=st.data())
@share(0.2)
def test_the_expectation_of_the_unbiased_estimate_is_the_true_position(quantity: Quantity, data: st.DataObject):
    truth = data.draw(conversions.points(quantity))
    of = Expectations(quantity.module, truth, order=24)
    expected = maps.position(quantity.module, truth)
    error = np.abs(of.noise.expectation(of.u, truth) - expected) / conversions.scale(quantity, expected)
    assert error.max() < RELATIVE


@pytest.mark.parametrize("quantity", [q for q in DEFINED if q.module == "polar"], ids=conversions.ids)
def test_the_quadrature_has_converged_at_the_largest_errors(quantity: Quantity):
    point = {s.name: {"r": 100.0, "beta": 0.7, "rho": 0.9}.get(s.name, s.high / 100) for s in quantity.symbols}
    point |= {name: 1.0 for name in point if name.endswith("sigma_beta")}
    point |= {"predicted_rho": -0.9} if "predicted_rho" in point else {}
    coarse, fine = (
        DEFINITIONS[conversions.row(quantity)](Expectations(quantity.module, point, order=order), point)
        for order in (18, 30)
    )
    np.testing.assert_allclose(coarse, fine, rtol=0, atol=RELATIVE / 10 * conversions.scale(quantity, fine).min())
