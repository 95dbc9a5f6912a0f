"""Series for a covariance that are completed to sums of squares: still covariances where the series is poor."""

import random
from functools import cache

import mpmath
import pytest
from hypothesis import given
from hypothesis import strategies as st

from radartrack.derive.catalogue import catalogue
from radartrack.derive.evaluation.many_digits import Evaluator
from radartrack.derive.language.quantity import Quantity
from tests import conversions
from tests.examples import share

DIGITS = 60
COMPLETED = [quantity for quantity in conversions.QUANTITIES if quantity.name.endswith(".semidefinite")]


@cache
def evaluator(name: str) -> Evaluator:
    quantity = catalogue()[name]
    return Evaluator(quantity.expression, quantity.symbols, DIGITS)


def value(quantity: Quantity, point: dict[str, float]) -> mpmath.matrix:
    found = evaluator(quantity.name)({s.name: point[s.name] for s in quantity.symbols})
    return mpmath.matrix([[found[a, b] for b in range(3)] for a in range(3)])


def near_the_edge(seed: int) -> dict[str, float]:
    """Directions up to a few deviations from the edge; ranges known very well and not at all; full correlations."""
    draw = random.Random(seed)
    deviation = 10 ** draw.uniform(-3, -0.8)
    reach = draw.choice([0.0, 0.5, 1.0]) * (0.999 - 5 * deviation)
    angle = mpmath.mpf(draw.uniform(-4, 4))
    point = {
        "r": 10 ** draw.uniform(-2, 2),
        "u": float(reach * mpmath.cos(angle)),
        "v": float(reach * mpmath.sin(angle)),
    }
    point |= {"sigma_r": 10 ** draw.uniform(-4, 4), "sigma_u": deviation, "sigma_v": deviation * draw.uniform(0, 1)}
    point |= {"predicted_sigma_r": 10 ** draw.uniform(-4, 4), "predicted_sigma_u": deviation * draw.uniform(0, 1)}
    point |= {"predicted_sigma_v": deviation * draw.uniform(0, 1)}
    return point | {name: draw.choice([-1.0, 1.0, draw.uniform(-1, 1)]) for name in ("rho", "predicted_rho")}


def test_every_covariance_of_a_conversion_without_closed_forms_is_completed() -> None:
    rows = {conversions.row(quantity).removesuffix(".semidefinite") for quantity in COMPLETED}
    assert rows == {"covariance.averaged", "unbiased.covariance", "posterior.covariance", "decorrelated.covariance"}


@pytest.mark.parametrize("quantity", COMPLETED, ids=conversions.ids)
@given(seed=st.integers(0, 10**9))
@share(0.06)
def test_it_is_positive_semidefinite_in_exact_arithmetic(quantity: Quantity, seed: int) -> None:
    with mpmath.workdps(DIGITS):
        matrix = value(quantity, near_the_edge(seed))
        deviations = [mpmath.sqrt(matrix[a, a]) for a in range(3)]
        correlations = mpmath.matrix(3, 3)
        for a in range(3):
            for b in range(3):
                correlations[a, b] = matrix[a, b] / deviations[a] / deviations[b]
        assert min(mpmath.eigsy(correlations, eigvals_only=True)) > -(mpmath.mpf(10) ** -40)


@pytest.mark.parametrize("quantity", COMPLETED, ids=conversions.ids)
@given(seed=st.integers(0, 10**9))
@share(0.04)
def test_what_completes_it_is_of_sixth_order_in_the_deviations_and_no_other(quantity: Quantity, seed: int) -> None:
    series = catalogue()[quantity.name.replace(".semidefinite", ".fourth_order")]
    point = near_the_edge(seed)
    half = {name: number / 2 if "sigma" in name else number for name, number in point.items()}
    with mpmath.workdps(DIGITS):
        whole, rest = (value(quantity, at) - value(series, at) for at in (point, half))
        size = mpmath.mnorm(whole, "f")
        assert size > 0
        assert mpmath.mnorm(whole - 64 * rest, "f") < size * mpmath.mpf(10) ** -30
