"""The second derivations are right by themselves: they are oracles of the layer `identity`."""

from fractions import Fraction

import mpmath
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from radartrack.derive.models import models
from radartrack.verification.definitions import ROWS, defined
from radartrack.verification.direct_series import DirectSeries
from radartrack.verification.generating import GeneratingFunction
from radartrack.verification.jets import gaussian_moment, jets
from radartrack.verification.least_squares import inverse
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
    at = {variable: mpmath.mpf(n + 2) / 7 for n, variable in enumerate(model.measured)}
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
    at = {symbol: mpmath.mpf("0.3") for symbol in model.symbols}
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
