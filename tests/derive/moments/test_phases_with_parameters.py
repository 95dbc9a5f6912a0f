"""Closed forms where the phase of a wave is a product of what is measured and a parameter, as in sin(ωT)."""

import tomllib
from collections.abc import Callable
from typing import Any

import mpmath
import numpy as np
import pytest

from radartrack.derive.algebra.exponential_polynomial import ExponentialPolynomial, NotExponentialPolynomial, ring_over
from radartrack.derive.evaluation.many_digits import Evaluator
from radartrack.derive.language.quantity import Quantity
from radartrack.derive.language.variable import Variable
from radartrack.derive.moments.conversion_quantities import quantities_of
from radartrack.derive.moments.gaussian_operator import GaussianOperator
from radartrack.derive.reading.model_table import read_models
from radartrack.derive.symbolic import cos
from radartrack.derive.units import ONE
from tests import own_models

AT = {"r": 2000, "w": 0.07, "T": 8, "s_r": 90, "s_w": 0.04, "c": 0.6}


@pytest.fixture(scope="module")
def rotor() -> dict[str, Quantity]:
    (model,) = read_models(tomllib.loads(own_models.TOML))
    return {quantity.name: quantity for quantity in quantities_of(model)}


def integral(function: Callable[[Any, Any], Any]) -> float:
    """E[f(r + w₁, ω + w₂)] by quadrature over two independent normals."""
    nodes, weights = np.polynomial.hermite_e.hermegauss(40)
    x, y = np.meshgrid(nodes, nodes)
    correlation = AT["c"]
    r = AT["r"] + AT["s_r"] * x
    w = AT["w"] + AT["s_w"] * (correlation * x + np.sqrt(1 - correlation**2) * y)
    return float((np.outer(weights, weights) * function(r, w)).sum() / weights.sum() ** 2)


def value(quantity: Quantity, index: tuple[int, ...]) -> Any:
    numbers = [mpmath.mpf(AT[symbol.name]) for symbol in quantity.symbols]
    return Evaluator(quantity.expression, quantity.symbols)(numbers)[index]


def test_expectations_are_those_of_the_integral(rotor: dict[str, Quantity]):
    mean = [integral(lambda r, w: r * np.cos(w * AT["T"])), integral(lambda r, w: r * np.sin(w * AT["T"]))]
    square = integral(lambda r, w: r**2 * np.cos(w * AT["T"]) * np.sin(w * AT["T"]))
    assert [float(value(rotor["rotor.posterior.estimate"], (n,))) for n in range(2)] == pytest.approx(mean, rel=1e-12)
    covariance = square - mean[0] * mean[1]
    assert float(value(rotor["rotor.covariance.truth"], (0, 1))) == pytest.approx(covariance, rel=1e-9)


def test_a_phase_that_is_a_product_of_two_measured_quantities_has_no_closed_form():
    a, b = Variable("a", "a", ONE, 0, 1), Variable("b", "b", ONE, 0, 1)
    ring = ring_over((a, b))
    operator = GaussianOperator((a, b), ((a * 0 + 1, a * 0), (a * 0, a * 0 + 1)))
    with pytest.raises(NotExponentialPolynomial, match="is not linear in a"):
        operator.exponential(ExponentialPolynomial.read(cos(a * b), ring))
    with pytest.raises(NotExponentialPolynomial, match="is not linear in b"):
        operator.exponential(ExponentialPolynomial.read(cos(b**2), ring))
