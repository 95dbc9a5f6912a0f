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
    rows, columns = map(range, quantity.shape)
    return mpmath.matrix([[found[a, b] for b in columns] for a in rows])


def ruv(draw: random.Random) -> dict[str, float]:
    """Directions up to a few deviations from the edge; ranges known very well and not at all."""
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
    return point | {"predicted_sigma_v": deviation * draw.uniform(0, 1)}


def bistatic(draw: random.Random) -> dict[str, float]:
    """Paths as short as five deviations beyond the baseline, and azimuths known well and not at all."""
    baseline, deviation = 10 ** draw.uniform(0, 4.3), 10 ** draw.uniform(-3, 3)
    point = {"path": max(draw.choice([0.0, 3e4, 1e6]), baseline + 5 * deviation), "beta": draw.uniform(-4, 4)}
    point |= {"baseline": baseline, "sigma_path": deviation, "sigma_beta": 10 ** draw.uniform(-3, 0)}
    point |= {"predicted_sigma_path": deviation * draw.uniform(0, 1)}
    return point | {"predicted_sigma_beta": 10 ** draw.uniform(-3, 0)}


NEAR_THE_EDGE = {"bistatic": bistatic, "ruv": ruv}


def near_the_edge(quantity: Quantity, seed: int) -> dict[str, float]:
    """Where the series of the model are poor, with full correlations."""
    draw = random.Random(seed)
    point = NEAR_THE_EDGE[quantity.module](draw)
    return point | {name: draw.choice([-1.0, 1.0, draw.uniform(-1, 1)]) for name in ("rho", "predicted_rho")}


def test_every_covariance_of_a_conversion_without_closed_forms_is_completed() -> None:
    rows = {conversions.row(quantity).removesuffix(".semidefinite") for quantity in COMPLETED}
    assert rows == {"covariance.averaged", "unbiased.covariance", "posterior.covariance", "decorrelated.covariance"}


@pytest.mark.parametrize("quantity", COMPLETED, ids=conversions.ids)
@given(seed=st.integers(0, 10**9))
@share(0.06)
def test_it_is_positive_semidefinite_in_exact_arithmetic(quantity: Quantity, seed: int) -> None:
    with mpmath.workdps(DIGITS):
        matrix = value(quantity, near_the_edge(quantity, seed))
        size = matrix.rows
        deviations = [mpmath.sqrt(matrix[a, a]) for a in range(size)]
        correlations = mpmath.matrix(size, size)
        for a in range(size):
            for b in range(size):
                correlations[a, b] = matrix[a, b] / deviations[a] / deviations[b]
        assert min(mpmath.eigsy(correlations, eigvals_only=True)) > -(mpmath.mpf(10) ** -40)


@pytest.mark.parametrize("quantity", COMPLETED, ids=conversions.ids)
@given(seed=st.integers(0, 10**9))
@share(0.04)
def test_what_completes_it_is_of_sixth_order_in_the_deviations_and_no_other(quantity: Quantity, seed: int) -> None:
    series = catalogue()[quantity.name.replace(".semidefinite", ".fourth_order")]
    point = near_the_edge(quantity, seed)
    half = {name: number / 2 if "sigma" in name else number for name, number in point.items()}
    with mpmath.workdps(DIGITS):
        whole, rest = (value(quantity, at) - value(series, at) for at in (point, half))
        size = mpmath.mnorm(whole, "f")
        assert size > 0
        assert mpmath.mnorm(whole - 64 * rest, "f") < size * mpmath.mpf(10) ** -30
