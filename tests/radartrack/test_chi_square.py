"""Quantiles against SciPy's."""

import pytest
from scipy import stats

from radartrack import chi_square


@pytest.mark.parametrize("degrees_of_freedom", [1, 2, 3, 17.5, 400, 10_000])
@pytest.mark.parametrize("probability", [1e-12, 0.025, 0.5, 0.975, 1 - 1e-6, 1 - 1e-9])
def test_quantiles_are_those_of_scipy(probability: float, degrees_of_freedom: float) -> None:
    expected = stats.chi2.ppf(probability, degrees_of_freedom)
    assert chi_square.quantile(probability, degrees_of_freedom) == pytest.approx(expected, rel=1e-8)


def test_quantiles_of_a_million_degrees_of_freedom_are_those_of_scipy() -> None:
    expected = stats.chi2.ppf(0.975, 1e6)
    assert chi_square.quantile(0.975, 1e6) == pytest.approx(expected, rel=1e-7)
