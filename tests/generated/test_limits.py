"""What becomes of the moments as errors vanish."""

import math
from collections.abc import Mapping

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from radartrack.derive.catalogue import catalogue
from radartrack.derive.language.quantity import Quantity
from tests import conversions
from tests.examples import share

SHRINK = 2.0**-12
HALF = st.just(0.5)
NEGLECTED = 20 * SHRINK**2  # what second-order terms leave of the first order, at errors of up to a radian
BIASES = conversions.of("bias.truth", "bias.averaged")
COVARIANCES = [q for q in conversions.covariances() if conversions.row(q) != "covariance.linear"]


def value(name: str, point: Mapping[str, float]) -> np.ndarray:
    quantity = catalogue()[name]
    return conversions.generated(quantity)(**{symbol.name: point[symbol.name] for symbol in quantity.symbols})


def shrunk(point: Mapping[str, float], factor: float) -> dict[str, float]:
    """The point with all deviations multiplied by a factor."""
    return {name: number * factor if "sigma_" in name else number for name, number in point.items()}


def largest_alike(quantity: Quantity, variances: np.ndarray) -> np.ndarray:
    """For each variance the largest one of its unit: along some direction the linear one may vanish."""
    units = quantity.axes[0]
    return np.array([max(v for v, other in zip(variances, units, strict=True) if other == unit) for unit in units])


@pytest.mark.parametrize("quantity", BIASES, ids=conversions.ids)
@given(data=st.data())
@share(0.4)
def test_the_bias_approaches_the_one_of_second_order(quantity: Quantity, data: st.DataObject):
    point = shrunk(data.draw(conversions.points(quantity, rho=HALF)), SHRINK)
    expected = value(f"{quantity.module}.bias.second_order", point)
    error = np.abs(conversions.generated(quantity)(**point) - expected) / conversions.scale(quantity, expected)
    assert error.max() < NEGLECTED


@pytest.mark.parametrize("quantity", COVARIANCES, ids=conversions.ids)
@given(data=st.data())
@share(0.4)
def test_the_covariance_approaches_the_linear_one(quantity: Quantity, data: st.DataObject):
    point = shrunk(data.draw(conversions.long_paths(quantity)), SHRINK)
    expected = value(f"{quantity.module}.covariance.linear", point)
    independent = value(f"{quantity.module}.covariance.linear", point | {"rho": 0.0})
    scale = conversions.scale(quantity, np.diag(largest_alike(quantity, np.diagonal(independent))))
    assert (np.abs(conversions.generated(quantity)(**point) - expected) / scale).max() < 100 * NEGLECTED


@pytest.mark.parametrize(("row", "sign"), [("unbiased.estimate", -1), ("posterior.estimate", 1)])
@pytest.mark.parametrize("model", sorted({q.module for q in conversions.of("unbiased.estimate")}))
@given(data=st.data())
@share(0.4)
def test_the_estimate_approaches_the_plain_conversion_corrected_to_second_order(
    model: str, row: str, sign: int, data: st.DataObject
):
    quantity = catalogue()[f"{model}.{row}"]
    point = shrunk(data.draw(conversions.points(quantity, rho=HALF)), SHRINK)
    bias = value(f"{model}.bias.second_order", point)
    plain = value(f"{model}.map", point)
    error = np.abs(value(quantity.name, point) - plain - sign * bias)
    rounding = 4 * math.ulp(1.0) * conversions.scale(quantity, plain)
    np.testing.assert_array_less(error, NEGLECTED * conversions.scale(quantity, bias) + rounding)


@pytest.mark.parametrize(
    "quantity", [q for q in conversions.QUANTITIES if "validity" not in q.name], ids=conversions.ids
)
@given(data=st.data())
@share(0.2)
def test_without_errors_there_is_no_bias_and_no_covariance(quantity: Quantity, data: st.DataObject):
    point = shrunk(data.draw(conversions.long_paths(quantity)), 0.0)
    result = conversions.generated(quantity)(**point)
    if quantity.is_covariance or conversions.row(quantity).startswith("bias."):
        np.testing.assert_array_equal(result, np.zeros(quantity.shape))
    else:
        assert np.isfinite(result).all()


@pytest.mark.parametrize("quantity", conversions.covariances(), ids=conversions.ids)
@given(data=st.data())
@share(0.4)
def test_variances_stay_positive_down_to_the_smallest_errors(quantity: Quantity, data: st.DataObject):
    point = shrunk(data.draw(conversions.long_paths(quantity)), 1e-9)
    assert (np.diagonal(conversions.generated(quantity)(**point)) > 0).all()
