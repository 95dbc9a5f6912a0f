"""The second derivations are right by themselves: they are oracles of the layer `identity`."""

from fractions import Fraction
from typing import Any

import mpmath
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from radartrack.derive import symbolic as sp
from radartrack.derive.catalogue import catalogue
from radartrack.derive.language.quantity import Quantity
from radartrack.derive.sensors import models
from radartrack.verification.layers.identity import Identity
from radartrack.verification.outcome import Verdict
from radartrack.verification.second_derivations.best_weights import constrained_minimum
from radartrack.verification.second_derivations.definitions import ROWS, defined
from radartrack.verification.second_derivations.direct_series import DirectSeries
from radartrack.verification.second_derivations.exact_least_squares import inverse
from radartrack.verification.second_derivations.moment_generating_function import GeneratingFunction
from radartrack.verification.second_derivations.point_sets import points_with
from radartrack.verification.second_derivations.power_series import gaussian_moment, jets
from radartrack.verification.second_derivations.van_loan_motion import drift, exponential
from tests import maps
from tests.examples import share

POWERS = st.tuples(*[st.integers(0, 3)] * 3)


@given(powers=POWERS, seed=st.integers(0, 100))
@share(0.4)
def test_moments_of_gaussian_errors_are_those_of_quadrature(powers: tuple[int, ...], seed: int):
    factor = np.random.default_rng(seed).normal(size=(3, 3))
    covariance = (factor @ factor.T).tolist()
    nodes, weights = np.polynomial.hermite_e.hermegauss(6)
    grid = np.stack(np.meshgrid(nodes, nodes, nodes), axis=-1).reshape(-1, 3) @ factor.T
    share_of_node = np.stack(np.meshgrid(weights, weights, weights), axis=-1).prod(axis=-1).ravel() / weights.sum() ** 3
    expected = share_of_node @ np.prod(grid ** np.array(powers), axis=1)
    size = share_of_node @ np.prod(np.abs(grid) ** np.array(powers), axis=1)
    assert float(gaussian_moment(powers, covariance)) == pytest.approx(expected, abs=1e-10 * size)


@pytest.mark.parametrize("name", ["polar", "polar_doppler", "ruv", "spherical"])
def test_series_of_a_map_are_its_derivatives(name: str):
    model = models()[name]
    at: dict[sp.Symbol, Any] = {variable: mpmath.mpf(n + 2) / 7 for n, variable in enumerate(model.measured)}
    series = jets(list(model.map), at, model.measured, 3)
    for a, jet in enumerate(series):
        for powers, value in jet.terms.items():
            with mpmath.workdps(50):
                orders = powers[:-1]
                slope = mpmath.diff(lambda *z, a=a: maps.MAPS[name](mpmath, *z)[a], tuple(at.values()), orders)
                expected = slope / mpmath.fprod(map(mpmath.factorial, orders))
            assert abs(value - expected) < 1e-12


def test_the_estimate_of_the_series_is_unbiased_to_its_order():
    model = models()["ruv"]
    at: dict[sp.Symbol, Any] = {symbol: mpmath.mpf("0.3") for symbol in model.symbols}
    series = DirectSeries(model, at, 4)
    for h, u in zip(series.h, series.u, strict=True):
        assert all(abs(value) < 1e-12 for value in (series.noise(u) - h).terms.values())


@given(st.lists(st.lists(st.integers(-5, 5), min_size=3, max_size=3), min_size=3, max_size=3))
@share(0.4)
def test_the_inverse_of_fractions_is_exact(rows: list[list[int]]):
    matrix = [[Fraction(sum(a * b for a, b in zip(p, q, strict=True)) + 9 * (p is q)) for q in rows] for p in rows]
    back = inverse(matrix)
    product = [[sum(matrix[i][k] * back[k][j] for k in range(3)) for j in range(3)] for i in range(3)]
    assert product == [[Fraction(int(i == j)) for j in range(3)] for i in range(3)]


def test_every_definition_is_one_of_exact_algebra():
    generating = GeneratingFunction(models()["polar"])
    assert all(defined(row, generating).entries for row in ROWS)


SUMS = ("W", "mean_x", "mean_y", "S_xx", "S_xy", "S_yy")


@given(st.tuples(*[st.integers(-1000, 1000)] * len(SUMS)))
def test_points_have_the_sums_that_were_asked_for(numbers: tuple[int, ...]):
    asked = dict(zip(SUMS, map(mpmath.mpf, numbers), strict=True))
    points, x, y = points_with(asked), asked["mean_x"], asked["mean_y"]
    found = {
        "W": sum(p.weight for p in points),
        "S_xx": sum(p.weight * (p.x - x) ** 2 for p in points),
        "S_xy": sum(p.weight * (p.x - x) * (p.y - y) for p in points),
        "S_yy": sum(p.weight * (p.y - y) ** 2 for p in points),
    }
    assert found == {name: asked[name] for name in found}
    assert sum(p.weight * (p.x - x) for p in points) == sum(p.weight * (p.y - y) for p in points) == 0


@given(seed=st.integers(0, 100))
@share(0.2)
def test_any_other_weights_that_sum_to_one_have_a_larger_trace(seed: int):
    generator = np.random.default_rng(seed)
    factors = generator.normal(size=(2, 2, 2))
    covariances = [factor @ factor.T for factor in factors]
    first, second = (
        np.array(w.tolist(), dtype=float) for w in constrained_minimum(list(map(mpmath.matrix, covariances)))
    )
    np.testing.assert_allclose(first + second, np.eye(2), atol=1e-12)

    def trace(move: np.ndarray) -> float:
        pairs = zip((first + move, second - move), covariances, strict=True)
        return sum(np.trace(weight @ covariance @ weight.T) for weight, covariance in pairs)

    assert all(trace(np.zeros((2, 2))) <= trace(generator.normal(size=(2, 2))) for _ in range(20))


def test_the_exponential_of_a_motion_is_made_of_its_halves():
    whole, half = (exponential(drift(4) * time) for time in (mpmath.mpf(3), mpmath.mpf("1.5")))
    assert mpmath.mnorm(half * half - whole) < 1e-13
    np.testing.assert_allclose(np.array(whole.tolist(), dtype=float)[0], [1, 3, 4.5, 4.5])


@pytest.mark.parametrize("quantity", catalogue().values(), ids=lambda quantity: quantity.name)
def test_every_quantity_has_a_second_derivation_that_agrees(quantity: Quantity):
    assert Identity()(quantity, lambda **_: None).verdict is Verdict.PASSED
