"""Sums of exponentials keep their digits however small some of the errors are, and stay short."""

import math
from fractions import Fraction
from pathlib import Path

import mpmath
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from radartrack.derive import symbolic as sp
from radartrack.derive.evaluation.many_digits import evaluate
from radartrack.derive.language.model import Model
from radartrack.derive.language.quantity import Quantity
from radartrack.derive.language.source import Source
from radartrack.derive.language.variable import angle, correlation, deviation, length
from radartrack.derive.moments.conversion_quantities import quantities_of
from radartrack.derive.stable.bernstein_polynomials import Decay
from radartrack.derive.stable.exponents import Exponents
from radartrack.derive.stable.quantity_form import form_of, without_expm1
from radartrack.derive.symbolic import cos, sin
from radartrack.derive.units import METRE
from radartrack.derive.writing.conversion_functions import REMAINDER_OF_A_NUMBER
from radartrack.derive.writing.numpy_writer import PRELUDE, REMAINDER, Function, body, module_text
from radartrack.verification.domain_points import coarse, sample
from radartrack.verification.error_in_ulp import errors
from tests.examples import share
from tests.written import module_of

a, b, c = (sp.Symbol(name, real=True) for name in "abc")
DECAYS = (
    Decay.of((2, 0, 0), a**2, Fraction(1, 2)),
    Decay.of((0, 2, 0), b**2, Fraction(1)),
    Decay.of((1, 1, 1), a * b * c, Fraction(1)),
)
COUNTS = st.tuples(st.integers(0, 3), st.integers(0, 3), st.integers(-3, 3))
SUMS = st.dictionaries(COUNTS, st.fractions(-2, 2, max_denominator=4), min_size=1, max_size=6)
POINT = {a: 0.75, b: 0.5, c: -0.875}


@given(SUMS, st.booleans())
@share(0.5)
def test_what_is_written_is_the_sum_of_exponentials(coefficients: dict[tuple[int, ...], Fraction], vanishes: bool):
    if vanishes:
        coefficients[0, 0, 0] = coefficients.get((0, 0, 0), Fraction(0)) - sum(coefficients.values())
    exponents = Exponents(DECAYS)
    written = without_expm1(exponents.total(coefficients)).xreplace(exponents.names)
    with mpmath.workdps(50):
        expected = mpmath.fsum(
            mpmath.mpf(value.numerator)
            / value.denominator
            * mpmath.exp(-sum(n * d.step * evaluate(d.product, POINT) for n, d in zip(counts, DECAYS, strict=True)))
            for counts, value in coefficients.items()
        )
        assert abs(evaluate(written, POINT) - expected) < mpmath.mpf(10) ** -40


@pytest.mark.parametrize("order", [2, 3, 4, 5])
def test_what_is_left_of_the_exponential_series_keeps_its_digits(order: int, tmp_path: Path):
    arrays = module_of(PRELUDE + REMAINDER, tmp_path)
    numbers = module_of("import math\n" + REMAINDER_OF_A_NUMBER, tmp_path)
    sizes = np.concatenate([np.geomspace(1e-12, 30, 60), [order, np.nextafter(order, 0)]])
    points = np.concatenate([-sizes, [0.0], sizes])
    with mpmath.workdps(400):
        exact = [
            mpmath.exp(x) - mpmath.fsum(mpmath.mpf(x) ** n / math.factorial(n) for n in range(order)) for x in points
        ]
        expected = np.array([float(value) for value in exact])
    np.testing.assert_allclose(arrays._remainder(points, order), expected, rtol=3e-14)
    np.testing.assert_allclose([numbers._remainder(x, order) for x in points.tolist()], expected, rtol=3e-14)


def spherical_with_all_correlations() -> Model:
    r = length("r", "range", low=1e2, high=1e6)
    beta = angle("beta", "azimuth")
    epsilon = angle("epsilon", "elevation", low=-1.5, high=1.5)
    return Model(
        name="correlated",
        title="Range, azimuth and elevation with errors that are all correlated",
        measured=(r, beta, epsilon),
        deviations=(deviation(r, 1e-3, 1e4), deviation(beta, 1e-9, 1.0), deviation(epsilon, 1e-9, 1.0)),
        correlations={
            (r, beta): correlation("rho_1", r, beta),
            (r, epsilon): correlation("rho_2", r, epsilon),
            (beta, epsilon): correlation("rho_3", beta, epsilon),
        },
        outputs={"x": r * cos(epsilon) * cos(beta), "y": r * cos(epsilon) * sin(beta), "z": r * sin(epsilon)},
        units=(METRE,) * 3,
        source=Source("a user", None),
    )


CORRELATED = {quantity.name: quantity for quantity in quantities_of(spherical_with_all_correlations())}


def written(quantity: Quantity, folder: Path) -> tuple[str, object]:
    function = Function(quantity, body(quantity, form_of(quantity)))
    module = module_of(module_text("One function", [function], {quantity.name: "not measured."}), folder)
    return function.body, getattr(module, quantity.function)


@pytest.mark.parametrize("word", ["bias.averaged", "covariance.truth", "unbiased.estimate"])
def test_three_correlations_of_three_quantities_give_short_code_that_keeps_its_digits(word: str, tmp_path: Path):
    quantity = CORRELATED[f"correlated.{word}"]
    statements, function = written(quantity, tmp_path)
    assert len(statements) < 40_000
    independent = sample(quantity, 60, seed=1)
    assert errors(function, quantity, independent).max() <= 16  # type: ignore[arg-type]
    assert errors(function, quantity, coarse(quantity, 20, seed=2)).max() <= 64  # type: ignore[arg-type]
