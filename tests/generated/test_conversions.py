"""Mean and covariance together: the same as the quantities that they join, over arrays and as loops."""

from itertools import product
from types import ModuleType

import numpy as np
import pytest

from radartrack._conversion.sensors import SENSORS
from radartrack.derive.catalogue import catalogue
from radartrack.derive.evaluation.balls import exact_arithmetic
from radartrack.derive.language.quantity import Quantity
from radartrack.derive.writing.conversion_functions import METHODS, conversions_of
from radartrack.generated import conversions, loops
from radartrack.verification.domain_points import Points, sample
from radartrack.verification.error_in_ulp import errors
from radartrack.verification.layers.ulp_search import Accuracy
from radartrack.verification.outcome import Verdict
from radartrack.verification.paths import ARRAYS, ONE_PLOT, along
from tests import conversions as generated

POINTS = 200
EACH = pytest.mark.parametrize(("model", "method"), conversions_of(catalogue()))


def symbols(model: str, method: str) -> list[str]:
    loop = getattr(conversions, f"{model}_{method}")
    return list(loop.__code__.co_varnames[: loop.__code__.co_argcount - 2])


def joined(model: str, word: str) -> Quantity:
    names = (f"{model}.{word}{series}" for series in ("", ".semidefinite", ".fourth_order"))
    return next(catalogue()[name] for name in names if name in catalogue())


def drawn(model: str, method: str) -> Points:
    return sample(joined(model, METHODS[method].covariance), POINTS, seed=5, correlated=True)


def separately(model: str, method: str, points: Points) -> tuple[np.ndarray, np.ndarray]:
    def value(word: str) -> np.ndarray:
        quantity = joined(model, word)
        return generated.generated(quantity)(**{s.name: points[s.name] for s in quantity.symbols})

    words = METHODS[method]
    mean = value(words.estimate) - (value(words.bias) if words.bias else 0)
    return mean, value(words.covariance)


def together(module: object, model: str, method: str, points: Points) -> tuple[np.ndarray, np.ndarray]:
    size = len(next(iter(points.values())))
    (count,) = joined(model, METHODS[method].estimate).shape
    mean, covariance = np.full((size, count), np.nan), np.full((size, count, count), np.nan)
    given = [points[name] for name in symbols(model, method)]
    arguments = [given] if module is loops else given
    getattr(module, f"{model}_{method}")(*arguments, mean, covariance)
    return mean, covariance


def assert_equal_within_rounding(
    found: tuple[np.ndarray, np.ndarray], expected: tuple[np.ndarray, np.ndarray], independent: np.ndarray
) -> None:
    """Means against their size, covariances against the deviations for independent errors."""
    size = np.linalg.norm(expected[0], axis=-1, keepdims=True)
    assert (np.abs(found[0] - expected[0]) <= 1e-14 * size).all()
    deviations = np.sqrt(np.diagonal(independent, axis1=-2, axis2=-1))
    scale = deviations[..., :, np.newaxis] * deviations[..., np.newaxis, :] + np.abs(expected[1])
    assert (np.abs(found[1] - expected[1]) <= 1e-13 * scale).all()


@EACH
def test_over_arrays_it_is_what_the_quantities_are_one_by_one(model: str, method: str) -> None:
    points = drawn(model, method)
    independent = separately(model, method, points | {"rho": np.zeros(POINTS)})[1]
    assert_equal_within_rounding(
        together(conversions, model, method, points), separately(model, method, points), independent
    )


@EACH
def test_the_loop_computes_the_same(model: str, method: str) -> None:
    points = drawn(model, method)
    independent = separately(model, method, points | {"rho": np.zeros(POINTS)})[1]
    assert_equal_within_rounding(
        together(loops, model, method, points), together(conversions, model, method, points), independent
    )


def test_every_method_of_every_sensor_is_there() -> None:
    assert sorted(conversions_of(catalogue())) == sorted(product(SENSORS, METHODS))


@EACH
@pytest.mark.parametrize("module", [conversions, loops], ids=["arrays", "loops"])
def test_errors_are_within_the_contract_of_the_quantities(module: ModuleType, model: str, method: str) -> None:
    """The covariance against fifty digits: at most 8 ulp for polar, and 16 for the other sensors."""
    quantity = joined(model, METHODS[method].covariance)

    def covariance(**points: np.ndarray) -> np.ndarray:
        return together(module, model, method, points)[1]

    found = errors(covariance, quantity, sample(quantity, 25, seed=20), exact_arithmetic()[1]).max()
    assert found <= (8 if model == "polar" else 16)


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("path", [ARRAYS, ONE_PLOT])
def test_of_polar_plots_they_are_within_it_where_a_search_makes_them_worst(path: str, method: str) -> None:
    quantity = joined("polar", METHODS[method].covariance)
    outcome = Accuracy(points=1000)(*along(path, quantity))
    assert outcome.bound == 8
    assert outcome.verdict is Verdict.PASSED, outcome.detail


@EACH
def test_the_loop_fills_dictionaries_in_the_order_of_their_places(model: str, method: str) -> None:
    points = drawn(model, method)
    arrays = together(loops, model, method, points)
    for plot in (0, POINTS - 1):
        mean: dict[tuple[int, ...], float] = {}
        covariance: dict[tuple[int, ...], float] = {}
        loop = getattr(loops, f"{model}_{method}")
        loop([[points[name][plot].item()] for name in symbols(model, method)], mean, covariance)
        for found, expected in zip((mean, covariance), arrays, strict=True):
            assert [*found] == [(0, *index) for index in np.ndindex(expected.shape[1:])]
            np.testing.assert_allclose([*found.values()], expected[plot].ravel(), rtol=1e-13)
