"""The table of words against what each expectation means, for random maps with random correlated errors."""

from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
import sympy
from hypothesis import given
from hypothesis import strategies as st

from radartrack.derive import symbolic as sp
from radartrack.derive.algebra.exponential_polynomial import ExponentialPolynomial
from radartrack.derive.language.model import Model
from radartrack.derive.language.source import Source
from radartrack.derive.language.tensor import Tensor
from radartrack.derive.language.variable import Variable, correlation, deviation
from radartrack.derive.moments import debiased_conversion, taylor
from radartrack.derive.moments.closed_form import Closed
from radartrack.derive.moments.truncated_series import Truncated
from radartrack.derive.symbolic import Expr
from radartrack.derive.units import ONE
from tests.examples import share
from tests.expressions import linear, monomials, number
from tests.quadrature import Gaussian, Point, square

Word = Callable[[Any], Tensor[Any]]
# Names of their own: in SymPy's cache a symbol of one name is one symbol, and x is a length elsewhere.
x, y = (Variable(name, "a quantity", ONE, -2, 2) for name in ("x_one", "y_one"))
DEVIATIONS = (deviation(x, 0.01, 1), deviation(y, 0.01, 1))
RHO = correlation("rho", x, y)
VALUES = {"sigma_x_one": 0.25, "sigma_y_one": 0.375, "rho": -0.625}
VALUES |= {"predicted_sigma_x_one": 0.125, "predicted_sigma_y_one": 0.25, "predicted_rho": 0.5}
AT = {"x_one": 0.375, "y_one": -0.5}
ORDER = 12

gentle = st.builds(
    lambda m, f, form: m * f(form / 3),
    monomials(x, y, degree=1),
    st.sampled_from([sp.sin, sp.cos, sp.exp]),
    linear(x, y),
)
maps = st.tuples(gentle, gentle)


def model(first: Expr, second: Expr) -> Model:
    return Model(
        name="any",
        title="any map",
        measured=(x, y),
        deviations=DEVIATIONS,
        outputs={"a": first, "b": second},
        units=(ONE, ONE),
        source=Source("nobody", None),
        correlations={(x, y): RHO},
    )


@dataclass(frozen=True)
class Numbers:
    """Expectations of a map's numbers by quadrature, the words' oracle."""

    outputs: tuple[Expr, Expr]

    def gaussian(self, prefix: str = "") -> Gaussian:
        a, b, rho = (VALUES[f"{prefix}{name}"] for name in ("sigma_x_one", "sigma_y_one", "rho"))
        return Gaussian.of(
            ["x_one", "y_one"], np.array([[a * a, rho * a * b], [rho * a * b, b * b]]), {"x_one": ORDER, "y_one": ORDER}
        )

    def h(self, point: Point) -> np.ndarray:
        return evaluated(Tensor((2,), self.outputs), point)


def evaluated(tensor: Tensor[Expr], point: Point) -> np.ndarray:
    """Values at points of any shape, along new last axes."""
    shape = np.broadcast_shapes(*(np.shape(value) for value in point.values()))
    symbols = [sympy.Symbol(name) for name in point]
    plain = [entry.subs({s: sympy.Symbol(s.name) for s in entry.free_symbols}) for entry in tensor]
    values = sympy.lambdify(symbols, plain, "numpy")(*point.values())
    return np.stack([value * np.ones(shape) for value in values], axis=-1).reshape(*shape, *tensor.shape)


def derived(word: Word, outputs: tuple[Expr, Expr]) -> Tensor[Expr]:
    return word(Closed(model(*outputs))).map(ExponentialPolynomial.expression)


def assert_word_is(word: Word, outputs: tuple[Expr, Expr], expected: np.ndarray) -> None:
    found = evaluated(derived(word, outputs), AT | VALUES)
    np.testing.assert_allclose(found, expected, rtol=1e-8, atol=1e-10)


@given(maps)
@share(0.1)
def test_the_biases(outputs: tuple[Expr, Expr]):
    of = Numbers(outputs)
    noise = of.gaussian()

    def bias(truth: Point) -> np.ndarray:
        return np.asarray(noise.expectation(of.h, truth) - of.h(truth))

    assert_word_is(debiased_conversion.bias_truth, outputs, bias(AT))
    assert_word_is(debiased_conversion.bias_averaged, outputs, noise.expectation(bias, AT, sign=-1))
    assert_word_is(debiased_conversion.posterior_estimate, outputs, noise.expectation(of.h, AT, sign=-1))


@given(maps)
@share(0.04)
def test_the_covariances(outputs: tuple[Expr, Expr]):
    of = Numbers(outputs)
    noise = of.gaussian()
    assert_word_is(debiased_conversion.covariance_truth, outputs, noise.covariance(of.h, AT))
    averaged = noise.expectation(lambda truth: noise.covariance(of.h, truth), AT, sign=-1)
    assert_word_is(debiased_conversion.covariance_averaged, outputs, averaged)


@given(maps)
@share(0.04)
def test_the_unbiased_estimate_and_its_covariances(outputs: tuple[Expr, Expr]):
    of = Numbers(outputs)
    noise, prediction = of.gaussian(), of.gaussian("predicted_")
    estimate = derived(debiased_conversion.unbiased_estimate, outputs)

    def u(point: Point) -> np.ndarray:
        return evaluated(estimate, {**VALUES, **point})

    def given_truth(truth: Point) -> np.ndarray:
        return noise.expectation(lambda z: square(u(z) - of.h(truth)), truth)

    np.testing.assert_allclose(noise.expectation(u, AT), of.h(AT), rtol=1e-8, atol=1e-10)
    given_measurement = noise.expectation(lambda truth: square(u(AT) - of.h(truth)), AT, sign=-1)
    assert_word_is(debiased_conversion.unbiased_covariance, outputs, given_measurement)
    assert_word_is(
        debiased_conversion.decorrelated_covariance, outputs, prediction.expectation(given_truth, AT, sign=-1)
    )


@given(maps)
@share(0.2)
def test_the_laws_between_words_hold_exactly(outputs: tuple[Expr, Expr]):
    closed = Closed(model(*outputs))
    u, h = debiased_conversion.unbiased_estimate(closed), closed.map
    assert u.map(closed.expectation) == h
    assert debiased_conversion.bias_averaged(closed) == debiased_conversion.bias_truth(closed).map(closed.expectation)
    for word in (
        debiased_conversion.covariance_truth,
        debiased_conversion.unbiased_covariance,
        debiased_conversion.decorrelated_covariance,
    ):
        tensor = word(closed)
        assert tensor[0, 1] == tensor[1, 0]


polynomials = st.lists(monomials(x, y, degree=1), min_size=1, max_size=3).map(lambda terms: sympy.Add(*terms))


@given(st.tuples(polynomials, polynomials))
@share(0.1)
def test_for_quadratic_maps_the_second_order_formulas_are_exact(outputs: tuple[Expr, Expr]):
    quadratic = model(*outputs)
    bias = taylor.second_order_bias(quadratic.map, quadratic.measured, quadratic.covariance)
    covariance = taylor.second_order_covariance(quadratic.map, quadratic.measured, quadratic.covariance)
    for found, word in ((bias, debiased_conversion.bias_truth), (covariance, debiased_conversion.covariance_truth)):
        for entry, exact in zip(found, derived(word, outputs), strict=True):
            assert sympy.expand(entry - exact) == 0


@pytest.mark.parametrize(
    "word",
    [
        debiased_conversion.bias_averaged,
        debiased_conversion.unbiased_covariance,
        debiased_conversion.decorrelated_covariance,
    ],
)
@given(outputs=st.tuples(polynomials, polynomials))
@share(0.1)
def test_truncated_words_of_polynomials_are_exact_where_nothing_is_cut_off(word: Word, outputs: tuple[Expr, Expr]):
    truncated = Truncated(model(*outputs), 8)
    series = word(truncated).map(truncated.total)
    for found, exact in zip(series, derived(word, outputs), strict=True):
        assert sympy.expand(found - exact) == 0


@given(outputs=maps, order=st.sampled_from([2, 4, 6]))
@share(0.1)
def test_the_truncated_bias_leaves_out_only_what_is_of_higher_order(outputs: tuple[Expr, Expr], order: int):
    truncated = Truncated(model(*outputs), order)
    shrink = sympy.Symbol("shrink")
    at = {
        s: sympy.Rational((AT | VALUES)[s.name]) * (shrink if "sigma" in s.name else 1)
        for s in (x, y, *DEVIATIONS, RHO)
    }
    series = debiased_conversion.bias_truth(truncated).map(truncated.total)
    for found, exact in zip(series, derived(debiased_conversion.bias_truth, outputs), strict=True):
        rest = (exact - found).subs(at)
        for m in (2, 3):
            small = sympy.Rational(1, 10**m)
            assert abs(number(rest, {shrink: small})) <= 1e4 * Fraction(small.p, small.q) ** (order + 2)


@pytest.mark.parametrize("order", [0, -2, 1, 3])
def test_orders_that_are_odd_or_too_low_are_refused(order: int):
    with pytest.raises(ValueError, match="even and at least 2"):
        Truncated(model(x, y), order)
