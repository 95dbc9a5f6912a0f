"""Covariances over all that is accepted: symmetric, positive semidefinite, and right, on every path."""

import math
from collections.abc import Callable, Iterator
from fractions import Fraction
from typing import Any

import mpmath
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from radartrack import initiate
from radartrack._arrays import machine_code
from radartrack._conversion import semidefinite, sensors
from radartrack.convert import Converted, Method
from radartrack.derive.catalogue import catalogue
from radartrack.derive.evaluation.many_digits import Evaluator
from radartrack.derive.language.tensor import Tensor
from radartrack.derive.writing.conversion_functions import covariance_of
from tests.examples import share
from tests.radartrack.plots import DEVIATIONS, METHODS, OF_THE_PLOT, SENSORS, Floats, Plot, centre, function, size

TOLERANCE = 16  # units in the last place that an eigenvalue of the correlations may be below zero
SEEDS = st.integers(0, 10**9)
DTYPES = (np.float64, np.float32)
KINDS = ("any", "ordinary sizes", "small correlations")  # what is computed with care is found for each reason alone
FULL = [1.0, -1.0, 1 - 2.0**-53, 2.0**-24 - 1, 1 - 1e-6, 0.0]


def arguments(sensor: str) -> dict[str, sensors.Argument]:
    found: Any = sensors.SENSORS
    return dict(found[sensor].arguments)


def some(generator: np.random.Generator, count: int, low: float, high: float, least: float) -> Floats:
    """Zeros, extremes and sizes of any order, from the least, but mostly of ordinary ones, up to `high`."""
    ordinary = np.exp(generator.uniform(math.log(low), math.log(high), count))
    any_size = np.exp(generator.uniform(math.log(least), math.log(high), count))
    edges = generator.choice([0.0, least, high], count)
    return np.where(generator.random(count) < 0.1, edges, np.where(generator.random(count) < 0.4, any_size, ordinary))


def drawn(sensor: str, count: int, dtype: type[np.floating[Any]], seed: int, kind: str = "any") -> Plot:
    """Plots from the whole domain, or of ordinary sizes, or with small correlations."""
    generator = np.random.default_rng(seed)
    single = dtype is np.float32
    least = 1.4e-45 if single else 5e-324
    most = {"r": 1e10, "rate": 1e8} if single else {"r": 1e100, "rate": 1e50}

    def sizes(low: float, high: float) -> Floats:
        if kind == "ordinary sizes":
            return np.exp(generator.uniform(math.log(low), math.log(min(high, 1e5)), count))
        return some(generator, count, low, high, least)

    def angles(largest: float) -> Floats:
        right = generator.integers(-3, 4, count) * (largest / 2)
        return np.clip(
            np.where(generator.random(count) < 0.4, right, generator.uniform(-7, 7, count)), -largest, largest
        )

    length = np.where(generator.random(count) < 0.5, 1e6, most["r"])
    plots: Plot = {
        "r": np.minimum(sizes(1e-3, most["r"]), length),
        "azimuth": angles(math.pi),
        "elevation": angles(1.5707963),
        "range_rate": generator.choice([-1, 1], count) * sizes(1e-3, most["rate"]),
        "range_std": np.minimum(sizes(1e-3, most["r"]), length),
        "azimuth_std": sizes(1e-7, 3.14159),
        "elevation_std": sizes(1e-7, 3.14159),
        "range_rate_std": sizes(1e-3, most["rate"]),
        "correlation": np.where(
            generator.random(count) < 0.5, generator.choice(FULL, count), generator.uniform(-1, 1, count)
        ),
    }
    cancelling = generator.random(count) < 0.3  # at full correlation the variance along one axis vanishes there
    there = generator.choice([-1, 1], count) * np.arctan2(plots["range_std"], plots["r"] * plots["azimuth_std"])
    for name, values in (("azimuth", there), ("elevation", 0.0), ("elevation_std", 0.0)):
        plots[name] = np.where(cancelling, values, plots[name])
    larger = sizes(1e-7, 0.19)
    smaller = larger * generator.choice([1e-3, 1.0] if kind == "ordinary sizes" else [0.0, 1e-30, 1e-3, 1.0], count)
    reach = (0.999 - 5 * larger) * (1 - 1e-6) * generator.choice([0.0, 0.5, 1.0], count)
    plots |= {"u": reach * np.cos(plots["azimuth"]), "v": reach * np.sin(plots["azimuth"])}
    swapped = generator.random(count) < 0.5
    plots["correlation"] *= 0.5 if kind == "small correlations" else 1
    plots |= {"u_std": np.where(swapped, smaller, larger), "v_std": np.where(swapped, larger, smaller)}
    return {name: plots[name].astype(dtype) for name in arguments(sensor)}


def predicted(sensor: str, plot: Plot, seed: int) -> tuple[Floats, Floats]:
    """Predictions about the plots, in a fourth of their deviations and less, with correlations up to full ones."""
    count, generator = len(plot["r"]), np.random.default_rng(seed)
    roots = generator.standard_normal((count, size(sensor), size(sensor)))
    roots[generator.random(count) < 0.5, :, 1:] = 0
    deviations = np.stack([plot[name] for name in DEVIATIONS[sensor]], axis=-1).astype(np.float64)
    roots *= (deviations * generator.choice([0.0, 1e-9, 0.1], (count, 1)) / 4)[:, :, np.newaxis]
    matrices = (roots[:, :, np.newaxis] * roots[:, np.newaxis]).sum(axis=-1)
    vanishing = np.diagonal(matrices, axis1=1, axis2=2) < (1e-37 if plot["r"].dtype == np.float32 else 1e-290)
    matrices[vanishing[:, :, np.newaxis] | vanishing[:, np.newaxis]] = 0
    return centre(sensor, plot), matrices.astype(plot["r"].dtype)


def converted(sensor: str, method: str, plot: Plot, seed: int) -> Converted:
    if method != "decorrelated":
        return function(sensor)(**plot, method=method)
    if sensor == "ruv":  # prediction and measurement share the margin
        plot |= {name: plot[name] / 2 for name in ("u_std", "v_std")}
    return function(sensor)(**plot, method=method, predicted=predicted(sensor, plot, seed))


# An oracle in fractions: what is returned, with nothing rounded.


def is_semidefinite(matrix: Floats, tolerance: float) -> bool:
    """Whether no eigenvalue of the correlations is below the negative tolerance; where a variance is 0, all is."""
    rows = [[Fraction(float(entry)) for entry in row] for row in matrix]
    for i, row in enumerate(rows):
        row[i] *= 1 + Fraction(tolerance)
    while rows:
        (pivot, *top), rest = rows[0], rows[1:]
        if pivot < 0 or (pivot == 0 and any(top)):
            return False
        rows = [[b - a[0] * t / pivot if pivot else b for b, t in zip(a[1:], top, strict=True)] for a in rest]
    return True


def assert_covariances(matrices: Floats) -> None:
    tolerance = TOLERANCE * float(np.finfo(matrices.dtype).eps)
    assert np.isfinite(matrices).all()
    np.testing.assert_array_equal(matrices, np.swapaxes(matrices, -1, -2))
    assert [matrix.tolist() for matrix in matrices if not is_semidefinite(matrix, tolerance)] == []


@pytest.mark.parametrize(
    ("matrix", "expected"),
    [
        ([[1.0, 1.0], [1.0, 1.0]], True),
        ([[1.0, 1 + 1e-15], [1 + 1e-15, 1.0]], True),
        ([[1.0, 1 + 1e-14], [1 + 1e-14, 1.0]], False),
        ([[1e-300, 1.1e-150], [1.1e-150, 1.0]], False),
        ([[0.0, 1e-300], [1e-300, 1.0]], False),
        ([[-1e-300, 0.0], [0.0, 1.0]], False),
        ([[0.0, 0.0], [0.0, 0.0]], True),
        ([[1.0, 0.9, 0.9], [0.9, 1.0, -0.9], [0.9, -0.9, 1.0]], False),
    ],
)
def test_the_oracle_knows_covariances(matrix: list[list[float]], expected: bool) -> None:
    assert is_semidefinite(np.array(matrix), TOLERANCE * 2.0**-52) == expected


@pytest.mark.parametrize("dtype", DTYPES)
@pytest.mark.parametrize("sensor", SENSORS)
@given(seed=SEEDS, period=st.sampled_from([1e-6, 1.0, 1e9]), velocity_std=st.sampled_from([1e-3, 100.0, 1e6]))
@share(0.05)
def test_first_states_of_tracks_have_covariances_or_are_refused(
    sensor: Any, dtype: Any, seed: int, period: float, velocity_std: float
) -> None:
    first, second = (drawn(sensor, 8, dtype, seed + number) for number in range(2))
    assert_covariances(initiate.one_plot(sensor, first, dtype(velocity_std)).covariance)
    for place in range(8):
        earlier, later = ({name: values[place] for name, values in plot.items()} for plot in (first, second))
        try:
            found = initiate.two_plots(sensor, earlier, later, period)
        except ValueError:  # a velocity beyond its domain, or what overflows
            continue
        assert_covariances(found.covariance[np.newaxis])


@pytest.mark.parametrize("dtype", DTYPES)
@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("sensor", SENSORS)
@given(seed=SEEDS)
@share(0.02)
def test_covariances_from_arrays_are_covariances(
    sensor: str, method: Method, dtype: type[np.floating[Any]], seed: int
) -> None:
    for kind in KINDS:
        assert_covariances(converted(sensor, method, drawn(sensor, 40, dtype, seed, kind), seed).covariance)


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("sensor", SENSORS)
@given(seed=SEEDS)
@share(0.02)
def test_covariances_from_machine_code_are_covariances(sensor: str, method: Method, seed: int) -> None:
    """Where Numba is not installed, from arrays once more."""
    for kind in KINDS:
        plot = drawn(sensor, machine_code.COMPILED_FROM, np.float64, seed, kind)
        assert_covariances(converted(sensor, method, plot, seed).covariance[::6])


@pytest.mark.parametrize("method", OF_THE_PLOT)
@pytest.mark.parametrize("sensor", SENSORS)
@given(seed=SEEDS)
@share(0.02)
def test_the_covariance_of_one_plot_is_one_and_the_same_as_in_an_array(sensor: str, method: Method, seed: int) -> None:
    plot = drawn(sensor, 30, np.float64, seed)
    for n, together in enumerate(converted(sensor, method, plot, seed).covariance):
        alone = function(sensor)(**{name: values[n].item() for name, values in plot.items()}, method=method).covariance
        assert_covariances(alone[np.newaxis])
        independent = function(sensor)(
            **{name: values[n].item() for name, values in plot.items()} | {"correlation": 0.0}, method=method
        ).covariance
        deviations = np.sqrt(np.diagonal(independent))
        assert (np.abs(alone - together) <= 1e-13 * np.outer(deviations, deviations)).all()


# The right numbers, where rounding or underflow left others.


def numbers(matrix: Tensor[Any]) -> Floats:
    return np.array([float(entry) for entry in matrix]).reshape(matrix.shape)


def exact(sensor: str, method: str, plot: Plot) -> Iterator[tuple[Floats, Floats]]:
    """Covariances with and without correlation, in so many digits that nothing that cancels matters."""
    quantity = catalogue()[covariance_of(catalogue(), sensor, method)]
    evaluator = Evaluator(quantity.expression, quantity.symbols, 400)
    symbols = [argument.symbol for argument in arguments(sensor).values()]
    with mpmath.workdps(400):
        for values in zip(*plot.values(), strict=True):
            point = dict(zip(symbols, map(float, values), strict=True))
            correlated, independent = (evaluator(point | other) for other in ({}, {"rho": 0.0}))
            yield numbers(correlated), numbers(independent)


@pytest.mark.parametrize("dtype", DTYPES)
@pytest.mark.parametrize("method", OF_THE_PLOT)
@pytest.mark.parametrize("sensor", SENSORS)
@given(seed=SEEDS)
@share(0.02)
def test_covariances_are_right_within_rounding_down_to_what_the_type_can_hold(
    sensor: str, method: Method, dtype: type[np.floating[Any]], seed: int
) -> None:
    """In float64 from 1e-30 on, for the sake of the oracle; 1 - u^2 - v^2 loses digits towards the edge."""
    plot = drawn(sensor, 4, np.float32, seed)
    if dtype is np.float64:
        plot = {name: np.where(np.abs(values) < 1e-30, 0, values).astype(dtype) for name, values in plot.items()}
    found = converted(sensor, method, plot, seed).covariance
    cosines = [plot[name].astype(float) for name in ("u", "v") if name in plot]
    conditions = 4 / (1 - sum(cosine**2 for cosine in cosines)) ** 2 * np.ones(len(found)) if cosines else np.ones(4)
    for matrix, (expected, independent), condition in zip(found, exact(sensor, method, plot), conditions, strict=True):
        deviations = np.sqrt(np.maximum(np.diagonal(independent), np.diagonal(expected)))
        deviations = np.where(np.diagonal(expected) < np.finfo(dtype).tiny, 0, deviations)
        allowed = 64 * condition * np.finfo(dtype).eps * np.outer(deviations, deviations)
        wanted = np.where(np.outer(deviations, deviations) > 0, expected, 0)
        assert (np.abs(matrix - wanted) <= allowed).all()


def test_a_variance_that_the_type_cannot_hold_is_none_nor_are_its_covariances() -> None:
    plot: Plot = {"r": 1e10, "azimuth": 0.0, "range_std": 1e10, "azimuth_std": 1e-35, "correlation": 0.5}
    single = function("polar")(**{name: np.float32(value) for name, value in plot.items()}, method="linear")
    assert single.covariance.tolist() == [[np.float32(1e10) ** 2, 0], [0, 0]]
    double = function("polar")(**plot, method="linear").covariance
    np.testing.assert_allclose(double, [[1e20, 5e-16], [5e-16, 1e-50]], rtol=1e-14)


def test_what_is_no_covariance_beyond_rounding_is_refused() -> None:
    matrices = np.array([[[1.0, 0.0], [0.0, 1.0]], [[1.0, 1.001], [1.001, 1.0]]])
    with pytest.raises(ValueError, match=r"covariance must be positive semidefinite: .* from -5.7e-14; got -0.001,"):
        semidefinite.nearest(matrices, matrices)


@pytest.mark.parametrize("order", [np.negative, np.positive])
@given(seed=SEEDS)
@share(0.2)
def test_the_nearest_covariance_is_within_rounding(order: Callable[[Floats], Floats], seed: int) -> None:
    """Of a product of a column and its transpose, with a rounding error put in."""
    generator = np.random.default_rng(seed)
    columns = generator.standard_normal((9, 3)) * 10.0 ** generator.uniform(-100, 100, (9, 3))
    matrices = columns[:, :, np.newaxis] * columns[:, np.newaxis]
    slips = 1 + order(generator.uniform(0, 16 * 2.0**-52, (9, 1, 1))) * (1 - np.eye(3))
    found = semidefinite.nearest(matrices * slips, matrices)
    assert_covariances(found)
    assert (np.abs(found - matrices) <= 1e-13 * np.abs(matrices)).all()
