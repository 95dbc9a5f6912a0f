"""Jacobian, Hessian, moments of Taylor polynomials and what they neglect, from derivatives of the plain map by mpmath.

A moment of the Taylor polynomial of degree n is a polynomial's: few Gauss-Hermite nodes give it exactly. Along the
line from the point to a node the polynomial's coefficients are the derivatives in one variable.
"""

import itertools
from collections.abc import Callable
from functools import cache

import mpmath
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from radartrack.derive.language.quantity import Quantity
from tests import conversions, maps
from tests.examples import share
from tests.quadrature import Gaussian, Point, square

DIGITS = 60


def map_itself(model: str, point: Point) -> np.ndarray:
    with mpmath.workdps(DIGITS):
        return np.array([float(value) for value in maps.evaluated(model, mpmath, point)])


def jacobian(model: str, point: Point) -> np.ndarray:
    return derivatives(model, point, 1)


def hessian(model: str, point: Point) -> np.ndarray:
    return derivatives(model, point, 2)


def derivatives(model: str, point: Point, order: int) -> np.ndarray:
    """All partial derivatives of one order, shape [out, in, ...]."""
    at = tuple(point[name] for name in maps.measured(model))
    size = len(maps.evaluated(model, np, point))
    result = np.empty((size, *[len(at)] * order))
    for index in np.ndindex(result.shape):
        orders = tuple(index[1:].count(i) for i in range(len(at)))
        with mpmath.workdps(DIGITS):
            result[index] = mpmath.diff(lambda *z, a=index[0]: maps.MAPS[model](mpmath, *z)[a], at, orders)
    return result


def taylor_values(model: str, point: Point, degree: int) -> tuple[np.ndarray, np.ndarray]:
    """h_n(θ + w) − h(θ) at nodes w, h_n the Taylor polynomial of a degree, and the weights of the nodes."""
    names = maps.measured(model)
    rule = Gaussian.of(names, maps.covariance(model, point), dict.fromkeys(names, degree + 1))
    nodes = np.stack([rule.offsets[name] for name in names], axis=-1)
    return np.array([np.sum(_along(model, point, node, degree), axis=-1) for node in nodes]), rule.weights


def _along(model: str, point: Point, node: np.ndarray, degree: int) -> list[list[float]]:
    """For each coordinate the terms of degree 1, 2, ... of the error."""
    names = maps.measured(model)
    with mpmath.workdps(DIGITS):
        start = [mpmath.mpf(point[name]) for name in names]

        @cache  # all coordinates are wanted at the same places, in as many bits
        def coordinates(s: mpmath.mpf, _: int) -> list[mpmath.mpf]:
            return maps.MAPS[model](mpmath, *(x + s * w for x, w in zip(start, node.tolist(), strict=True)))

        series = (mpmath.taylor(lambda s, a=a: coordinates(s, mpmath.mp.prec)[a], 0, degree) for a in itertools.count())
        return [
            list(map(float, terms[1:])) for terms in itertools.islice(series, len(maps.evaluated(model, np, point)))
        ]


def mean_of(degree: int) -> Callable[[str, Point], np.ndarray]:
    def moment(model: str, point: Point) -> np.ndarray:
        values, weights = taylor_values(model, point, degree)
        return weights @ values

    return moment


def covariance_of(degree: int) -> Callable[[str, Point], np.ndarray]:
    def moment(model: str, point: Point) -> np.ndarray:
        values, weights = taylor_values(model, point, degree)
        return np.tensordot(weights, square(values - weights @ values), axes=1)

    return moment


def neglected_after(degree: int) -> Callable[[str, Point], np.ndarray]:
    """Root mean square of the next term, brought back to the measured quantities, over their deviations."""

    def moment(model: str, point: Point) -> np.ndarray:
        names = maps.measured(model)
        rule = Gaussian.of(names, maps.covariance(model, point), dict.fromkeys(names, degree + 2))
        nodes = np.stack([rule.offsets[name] for name in names], axis=-1)
        terms = np.array([np.array(_along(model, point, node, degree + 1))[:, -1] for node in nodes])
        brought_back = np.linalg.solve(jacobian(model, point), terms.T).T
        return np.sqrt(rule.weights @ brought_back**2) / [point[f"sigma_{name}"] for name in names]

    return moment


def linear_deviations(model: str, point: Point) -> np.ndarray:
    return np.sqrt(np.diagonal(covariance_of(1)(model, point)))


def root_mean_square_deviation(model: str, point: Point) -> np.ndarray:
    return np.sqrt(np.mean(linear_deviations(model, point) ** 2))


DERIVATIVES = {"map": map_itself, "jacobian": jacobian, "hessian": hessian}
MOMENTS = {
    "bias.second_order": mean_of(2),
    "bias.fourth_order": mean_of(4),
    "covariance.linear": covariance_of(1),
    "covariance.second_order": covariance_of(2),
    "covariance.third_order": covariance_of(3),
    "std.linear": linear_deviations,
    "std.position": root_mean_square_deviation,
    "validity.linear": neglected_after(1),
    "validity.second_order": neglected_after(2),
}


@pytest.mark.parametrize("quantity", conversions.of(*DERIVATIVES), ids=conversions.ids)
@given(data=st.data())
@share(0.2)
def test_derivatives_are_those_of_the_plain_map(quantity: Quantity, data: st.DataObject):
    point = data.draw(conversions.points(quantity))
    expected = DERIVATIVES[conversions.row(quantity)](quantity.module, point)
    computed = conversions.generated(quantity)(**point)
    np.testing.assert_array_less(np.abs(computed - expected), 1e-14 * conversions.scale(quantity, expected) + 1e-40)


@pytest.mark.parametrize("quantity", conversions.of(*MOMENTS), ids=conversions.ids)
@given(data=st.data())
@share(0.06)
def test_the_moment_is_that_of_the_taylor_polynomial(quantity: Quantity, data: st.DataObject):
    point = data.draw(conversions.points(quantity))
    expected = MOMENTS[conversions.row(quantity)](quantity.module, point)
    error = np.abs(conversions.generated(quantity)(**point) - expected) / conversions.scale(quantity, expected)
    assert error.max() < 1e-12
