"""Turned, mirrored or scaled measurements give turned, mirrored or scaled results."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from radartrack.derive.catalogue import catalogue
from radartrack.derive.language.quantity import Quantity
from radartrack.derive.units import Unit
from radartrack.testing import strategies
from radartrack.verification.domain_points import sample
from tests import conversions, maps
from tests.examples import share

MOVING = [q for q in conversions.BY_HAND if not conversions.row(q).startswith(("jacobian", "hessian", "std."))]
EXACT = 1e-13


def turned(matrix: np.ndarray, quantity: Quantity, value: np.ndarray) -> np.ndarray:
    if "validity" in quantity.name:  # of the measured quantities, which directions in space do not concern
        return value
    return matrix @ value @ matrix.T if quantity.is_covariance else matrix @ value


def natural_scale(quantity: Quantity, point: dict[str, float]) -> np.ndarray:
    """The scale of each entry where the errors are independent and nothing can cancel."""
    independent = {name: 0.0 if name.endswith("rho") else value for name, value in point.items()}
    value = conversions.generated(quantity)(**independent)
    diagonal = np.diagonal(value) if quantity.is_covariance else value
    return np.full(quantity.shape, np.abs(diagonal).max())


@pytest.mark.parametrize("quantity", [q for q in MOVING if q.module in maps.ROTATIONS], ids=conversions.ids)
@given(data=st.data(), angle=st.floats(-3, 3))
@share(0.4)
def test_turning_the_azimuth_turns_the_result(quantity: Quantity, data: st.DataObject, angle: float):
    point = data.draw(conversions.points(quantity))
    function, matrix = conversions.generated(quantity), maps.ROTATIONS[quantity.module](angle)
    expected = turned(matrix, quantity, function(**point))
    computed = function(**point | {"beta": point["beta"] + angle})
    scale = natural_scale(quantity, point) + np.abs(expected).max()
    np.testing.assert_array_less(np.abs(computed - expected), EXACT * scale)


@pytest.mark.parametrize("quantity", [q for q in MOVING if q.module in maps.REFLECTIONS], ids=conversions.ids)
@given(data=st.data())
@share(0.4)
def test_mirroring_a_measured_quantity_and_its_correlations_mirrors_the_result(quantity: Quantity, data: st.DataObject):
    point = data.draw(conversions.points(quantity))
    function = conversions.generated(quantity)
    for name, signs in maps.REFLECTIONS[quantity.module]:
        mirrored = point | {name: -point[name]}
        if name in maps.CORRELATED[quantity.module]:
            mirrored |= {rho: -value for rho, value in point.items() if rho.endswith("rho")}
        expected = turned(np.diag(signs), quantity, function(**point))
        scale = natural_scale(quantity, point) + np.abs(expected).max()
        np.testing.assert_array_less(np.abs(function(**mirrored) - expected), EXACT * scale)


@pytest.mark.parametrize("quantity", catalogue().values(), ids=conversions.ids)
def test_other_units_of_length_and_time_give_the_same_result_to_the_last_bit(quantity: Quantity):
    points = sample(quantity, 50, seed=22, correlated=True)

    def factor(unit: Unit) -> float:
        return math.ldexp(1.0, int(4 * unit.metre - 6 * unit.second))

    function = conversions.generated(quantity)
    scaled = function(**{s.name: points[s.name] * factor(s.unit) for s in quantity.symbols})
    factors = np.array([factor(quantity.unit(index)) for index in np.ndindex(quantity.shape)])
    np.testing.assert_array_equal(scaled, function(**points) * factors.reshape(quantity.shape))


@pytest.mark.parametrize(
    "quantity",
    [
        q for q in conversions.covariances() if not q.name.endswith("fourth_order")
    ],  # a series cut off has no definite sign
    ids=conversions.ids,
)
@given(data=st.data())
@share(0.4)
def test_covariances_are_symmetric_to_the_last_bit_and_positive_semidefinite(quantity: Quantity, data: st.DataObject):
    point = data.draw(strategies.arguments(quantity.name))
    covariance = conversions.generated(quantity)(**point)
    np.testing.assert_array_equal(covariance, covariance.T)
    independent = point | {s.name: 0.0 for s in quantity.symbols if s.is_correlation}
    deviations = np.sqrt(np.diagonal(conversions.generated(quantity)(**independent)))
    assert np.linalg.eigvalsh(covariance / np.outer(deviations, deviations)).min() > -1e-12


@pytest.mark.parametrize("quantity", conversions.of("hessian"), ids=conversions.ids)
@given(data=st.data())
@share(0.4)
def test_the_hessian_is_symmetric_to_the_last_bit(quantity: Quantity, data: st.DataObject):
    hessian = conversions.generated(quantity)(**data.draw(strategies.arguments(quantity.name)))
    np.testing.assert_array_equal(hessian, np.swapaxes(hessian, -1, -2))
