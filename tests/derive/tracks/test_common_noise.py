"""Correlated tracks beside the recursion that they come of, dense inverses, and limits that are known."""

import pytest

from radartrack.derive import symbolic as sp
from radartrack.derive.algebra.equality import proved_equal
from radartrack.derive.catalogue import find
from radartrack.derive.language.tensor import Tensor
from radartrack.derive.motion.steady_state import ALPHA_BETA, w
from radartrack.derive.symbolic import Expr
from radartrack.derive.tracks import common_noise
from radartrack.derive.tracks.common_noise import w_1, w_2
from radartrack.derive.tracks.fusion_weights import sigma


def at(quantity: str, **values: int) -> Tensor[Expr]:
    numbers = {symbol: sp.Rational(values[symbol.name]) for symbol in find(quantity).symbols if symbol.name in values}
    return find(quantity).expression.map(lambda entry: entry.xreplace(numbers))


def test_of_filters_that_are_alike_the_cross_covariance_is_less_than_the_covariance_and_of_its_size() -> None:
    cross = common_noise.steady()
    own = ALPHA_BETA.filtered
    for root in (sp.Rational(3, 2), sp.Integer(4), sp.Integer(50)):
        both = {w_1: root, w_2: root, w: root}
        scale = (
            ALPHA_BETA.index.xreplace(both) ** 2
        )  # that of the covariance has the measurement's deviation as its unit
        shares = [scale * cross[n][n].xreplace(both) / own[n][n].xreplace(both) for n in range(2)]
        assert all(0 < share < 1 for share in shares)


def test_the_steady_cross_covariance_is_symmetric_and_the_same_for_the_filters_exchanged() -> None:
    cross = common_noise.steady()
    exchanged = {w_1: w_2, w_2: w_1}
    assert proved_equal(cross[0][1], cross[1][0])
    assert all(proved_equal(entry.xreplace(exchanged), entry) for row in cross for entry in row)


def test_without_correlation_the_weights_are_those_of_independent_measurements() -> None:
    for name, plain in (
        ("fusion.correlated.weights", "fusion.weights.two"),
        ("fusion.correlated.variance", "fusion.variance.two"),
    ):
        for got, expected in zip(at(name, rho_12=0), find(plain).expression, strict=True):
            assert proved_equal(got, expected)


def test_the_fused_variance_is_that_of_the_weights() -> None:
    first, second = find("fusion.correlated.weights").expression
    one, two = (weight * std for weight, std in zip((first, second), sigma, strict=False))
    (variance,) = find("fusion.correlated.variance").expression
    assert proved_equal(one**2 + two**2 + 2 * common_noise.rho * one * two, variance)


@pytest.mark.parametrize("weight", [0, 1])
def test_with_all_weight_on_one_the_intersection_is_its_covariance(weight: int) -> None:
    number = 2 - weight
    got = at("fusion.covariance_intersection.covariance", weight=weight)
    x, y, rho = (
        next(s for s in find("fusion.covariance_intersection.covariance").symbols if s.name == name)
        for name in (f"sigma_x{number}", f"sigma_y{number}", f"rho_{number}")
    )
    for entry, expected in zip(got, (x**2, rho * x * y, rho * x * y, y**2), strict=True):
        assert proved_equal(entry, expected)
