"""Moments of a map without closed forms, cut off at an order, from the exact moments of its Taylor polynomial.

To fourth order in the deviations a moment depends on derivatives up to the fourth: the map's Taylor polynomial of
that degree, for which the exact words are polynomials, has the same moment once that is cut off.
"""

import functools
import itertools
import math
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
import sympy

from radartrack.derive.algebra.exponential_polynomial import ExponentialPolynomial, ring_over
from radartrack.derive.language.quantity import Quantity
from radartrack.derive.language.tensor import Tensor
from radartrack.derive.moments import debiased_conversion
from radartrack.derive.moments.gaussian_operator import GaussianOperator
from tests import conversions, maps

DEGREES = {"second_order": 2, "fourth_order": 4}
WORDS: dict[str, Callable[[Any], Any]] = {
    "bias.truth": debiased_conversion.bias_truth,
    "bias.averaged": debiased_conversion.bias_averaged,
    "covariance.truth": debiased_conversion.covariance_truth,
    "covariance.averaged": debiased_conversion.covariance_averaged,
    "unbiased.estimate": debiased_conversion.unbiased_estimate,
    "unbiased.covariance": debiased_conversion.unbiased_covariance,
    "posterior.estimate": debiased_conversion.posterior_estimate,
    "posterior.covariance": debiased_conversion.covariance_truth,
    "decorrelated.covariance": debiased_conversion.decorrelated_covariance,
}
TRUNCATED = {f"{word}.{order}" for word in WORDS for order in DEGREES}
SHRINK = sympy.Symbol("shrink", real=True)
SEVENTH = sympy.Rational(1, 7)
POINT = {"r": sympy.Integer(900), "u": 2 * SEVENTH, "v": -3 * SEVENTH}
NOISE = {"sigma_r": 150.0, "sigma_u": 0.05, "sigma_v": 0.08, "rho": 0.6}
NOISE |= {"predicted_sigma_r": 90.0, "predicted_sigma_u": 0.07, "predicted_sigma_v": 0.03, "predicted_rho": -0.7}


def taylor_polynomial(expression: sympy.Expr, variables: tuple[sympy.Symbol, ...]) -> sympy.Expr:
    at = {variable: POINT[variable.name] for variable in variables}
    total = sympy.Integer(0)
    for powers in itertools.product(range(5), repeat=len(variables)):
        if sum(powers) <= 4:
            steps = [(variable, power) for variable, power in zip(variables, powers, strict=True) if power]
            slope = expression.diff(*steps) if steps else expression
            factors = ((variable - at[variable]) ** power for variable, power in steps)
            total += slope.subs(at) * sympy.Mul(*factors) / math.prod(map(math.factorial, powers))
    return sympy.expand(total)


class Numbers:
    """The calculus of a model's Taylor polynomial at POINT with numbers for the noise, deviations times `shrink`."""

    def __init__(self, name: str) -> None:
        variables = tuple(symbols(maps.measured(name)))
        ring = ring_over((*variables, SHRINK))
        plain = maps.evaluated(name, sympy, dict(zip(maps.measured(name), variables, strict=True)))
        polynomials = [ExponentialPolynomial.read(taylor_polynomial(h, variables), ring) for h in plain]
        self.map = Tensor((len(plain),), tuple(polynomials))
        measurement, prediction = (exact(maps.covariance(name, NOISE, prefix)) for prefix in ("", "predicted_"))
        self.expectation = GaussianOperator(variables, measurement).exponential
        self.prediction = GaussianOperator(variables, prediction).exponential


def symbols(names: list[str]) -> list[sympy.Symbol]:
    return [sympy.Symbol(name, real=True) for name in names]


def exact(covariance: np.ndarray) -> list[list[sympy.Expr]]:
    return [[sympy.Rational(float(entry)) * SHRINK**2 for entry in row] for row in covariance]


@functools.cache
def polynomials_of(name: str, word: str) -> Tensor[sympy.Poly]:
    """The word for the Taylor polynomial as polynomials in `shrink`."""
    at = {symbol: POINT[symbol.name] for symbol in symbols(maps.measured(name))}
    return WORDS[word](Numbers(name)).map(lambda value: sympy.Poly(value.expression().subs(at), SHRINK))


def moment(name: str, word: str, degree: int) -> np.ndarray:
    """The word without what is beyond a degree in the deviations."""
    tensor = polynomials_of(name, word)
    kept = [sum(c for (power,), c in polynomial.terms() if power <= degree) for polynomial in tensor]
    return np.array([float(value) for value in kept]).reshape(tensor.shape)


@pytest.mark.parametrize("quantity", conversions.of(*TRUNCATED), ids=conversions.ids)
def test_the_truncated_moment_is_that_of_the_taylor_polynomial_cut_off(quantity: Quantity):
    word, _, order = conversions.row(quantity).rpartition(".")
    expected = moment(quantity.module, word, DEGREES[order])
    point = {name: float(value) for name, value in (POINT | NOISE).items()}
    computed = conversions.generated(quantity)(**{symbol.name: point[symbol.name] for symbol in quantity.symbols})
    assert (np.abs(computed - expected) / conversions.scale(quantity, expected)).max() < 1e-12
