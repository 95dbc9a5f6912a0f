"""Mean and covariance of every method, for every sensor, by their definitions, with quadrature."""

from collections.abc import Callable, Sequence

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from radartrack.convert import Converted, Method
from radartrack.testing import strategies
from tests.examples import share
from tests.radartrack.plots import (
    CLOSED,
    COORDINATES,
    SENSORS,
    Floats,
    Plot,
    assert_agree,
    assert_covariances_agree,
    cartesian,
    centre,
    convert,
    noise,
    noise_covariance,
    plots,
    prediction,
    size,
)

NODES = 9  # for each quantity; for angles with deviations up to 0.5 that leaves an error of 1e-12
FEWER = {"spherical_doppler": (4, 9, 6, 4)}  # two of them polynomials, and the elevation known better
OF_PREDICTIONS = {"spherical_doppler": (9, 9, 6, 5)}  # what is correlated with an azimuth bends with it
ROUNDING = 1e-9
SERIES = 2e-3  # what a fourth-order series leaves, of the deviations, at errors of 0.005 in u and v
FINITE_DIFFERENCES = 1e-4


def errors(covariance: Floats, counts: Sequence[int] = ()) -> tuple[Floats, Floats]:
    """Points and weights of a quadrature over errors."""
    rules = [np.polynomial.hermite_e.hermegauss(count) for count in counts or [NODES] * len(covariance)]
    grid = np.stack(np.meshgrid(*(nodes for nodes, _ in rules)), axis=-1).reshape(-1, len(rules))
    products = np.stack(np.meshgrid(*(weights / weights.sum() for _, weights in rules)), axis=-1).prod(axis=-1)
    return grid @ np.linalg.cholesky(covariance).T, products.ravel()


def expectation(values: Floats, weights: Floats) -> Floats:
    """Over the axis before the last."""
    mean: Floats = np.einsum("...wi,w->...i", values, weights)
    return mean


def second_moment(values: Floats, weights: Floats) -> Floats:
    moment: Floats = np.einsum("...wi,...wj,w->...ij", values, values, weights, optimize=True)
    return moment


def covariance(values: Floats, weights: Floats) -> Floats:
    return second_moment(values - expectation(values, weights)[..., np.newaxis, :], weights)


def tolerance(sensor: str) -> float:
    return ROUNDING if sensor in CLOSED else SERIES


def taylor(sensor: str, measured: Floats, points: Floats, order: int) -> Floats:
    """The Taylor polynomial of the conversion at the points, by central differences."""
    step = 1e-3
    middle, ahead, behind = (cartesian(sensor, measured + s * points) for s in (0, step, -step))
    slope, curvature = (ahead - behind) / (2 * step), (ahead - 2 * middle + behind) / step**2
    return middle + slope + (curvature / 2 if order == 2 else 0)


def linear(sensor: str, measured: Floats, points: Floats, weights: Floats) -> tuple[Floats, Floats]:
    return cartesian(sensor, measured), covariance(taylor(sensor, measured, points, 1), weights)


def second_order(sensor: str, measured: Floats, points: Floats, weights: Floats) -> tuple[Floats, Floats]:
    polynomial = taylor(sensor, measured, points, 2)
    bias = expectation(polynomial, weights) - cartesian(sensor, measured)
    return cartesian(sensor, measured) - bias, covariance(polynomial, weights)


def averaged(sensor: str, measured: Floats, points: Floats, weights: Floats) -> tuple[Floats, Floats]:
    truths = measured - points
    converted = cartesian(sensor, truths[:, np.newaxis] + points)
    bias = expectation(expectation(converted, weights) - cartesian(sensor, truths), weights)
    mean = np.einsum("wij,w->ij", covariance(converted, weights), weights)
    return cartesian(sensor, measured) - bias, mean


def posterior(sensor: str, measured: Floats, points: Floats, weights: Floats) -> tuple[Floats, Floats]:
    truths = cartesian(sensor, measured - points)
    return expectation(truths, weights), covariance(truths, weights)


Definition = Callable[[str, Floats, Floats, Floats], tuple[Floats, Floats]]
DEFINITIONS: dict[Method, Definition] = {
    "linear": linear,
    "second_order": second_order,
    "averaged": averaged,
    "posterior": posterior,
}


@pytest.mark.parametrize("method", DEFINITIONS)
@pytest.mark.parametrize("sensor", SENSORS)
@given(data=st.data())
@share(0.1)
def test_mean_and_covariance_are_those_of_the_definition(sensor: str, method: Method, data: st.DataObject) -> None:
    plot = data.draw(plots(sensor))
    points, weights = errors(noise_covariance(sensor, plot), FEWER.get(sensor, ()))
    mean, matrix = DEFINITIONS[method](sensor, centre(sensor, plot), points, weights)
    got = convert(sensor, method, **plot)
    allowed = FINITE_DIFFERENCES if method in {"linear", "second_order"} else tolerance(sensor)
    assert_covariances_agree(got.covariance, matrix, allowed)
    deviations = np.sqrt(np.diagonal(matrix))
    assert_agree(got.mean, mean, deviations + 1e-7 * np.abs(mean), allowed)


def converted_around(sensor: str, plot: Plot, middle: Floats, points: Floats, method: Method) -> Converted:
    moved = dict(zip(COORDINATES[sensor], np.moveaxis(middle + points, -1, 0), strict=True))
    return convert(sensor, method, **{**plot, **moved})


@pytest.mark.parametrize("method", ["unbiased", "decorrelated"])
@pytest.mark.parametrize("sensor", SENSORS)
@given(data=st.data())
@share(0.2)
def test_the_unbiased_mean_is_the_true_position_on_average(sensor: str, method: Method, data: st.DataObject) -> None:
    plot = data.draw(plots(sensor))
    truth = centre(sensor, plot)
    points, weights = errors(noise_covariance(sensor, plot), FEWER.get(sensor, ()))
    got = converted_around(sensor, plot, truth, points, method)
    deviations = np.sqrt(np.diagonal(covariance(got.mean, weights)))
    position = cartesian(sensor, truth)
    assert_agree(expectation(got.mean, weights), position, deviations + 1e-7 * np.abs(position), tolerance(sensor))


@pytest.mark.parametrize("sensor", SENSORS)
@given(data=st.data())
@share(0.2)
def test_the_unbiased_covariance_is_of_its_error_given_the_measurement(sensor: str, data: st.DataObject) -> None:
    plot = data.draw(plots(sensor))
    points, weights = errors(noise_covariance(sensor, plot), FEWER.get(sensor, ()))
    got = convert(sensor, "unbiased", **plot)
    truths = cartesian(sensor, centre(sensor, plot) - points)
    assert_covariances_agree(got.covariance, second_moment(got.mean - truths, weights), tolerance(sensor))


@st.composite
def predictions(draw: st.DrawFn, sensor: str) -> tuple[Floats, Floats]:
    """With any correlations of all quantities."""
    plot = draw(plots(sensor))
    deviations = np.sqrt(np.diagonal(noise_covariance(sensor, plot)))
    correlated = draw(strategies.covariances(size(sensor), deviations=deviations))
    return centre(sensor, plot), 0.7 * correlated + 0.3 * np.diag(deviations**2)  # quadrature asks for a root


@pytest.mark.parametrize("sensor", SENSORS)
@given(data=st.data())
@share(0.1)
def test_the_decorrelated_covariance_is_of_the_unbiased_error_averaged_over_the_whole_prediction(
    sensor: str, data: st.DataObject
) -> None:
    plot, (mean, matrix) = data.draw(plots(sensor)), data.draw(predictions(sensor))
    truths, prediction_weights = errors(matrix, OF_PREDICTIONS.get(sensor, ()))
    points, weights = errors(noise_covariance(sensor, plot), FEWER.get(sensor, ()))
    noisy = noise(sensor, plot)
    means = converted_around(sensor, noisy, (mean + truths)[:, np.newaxis], points, "unbiased").mean
    given_truth = second_moment(means - cartesian(sensor, mean + truths)[:, np.newaxis], weights)
    expected = np.einsum("wij,w->ij", given_truth, prediction_weights)
    got = convert(sensor, "decorrelated", **{**plot, "predicted": (mean, matrix)})
    assert_covariances_agree(got.covariance, expected, tolerance(sensor))


@pytest.mark.parametrize(
    ("sensor", "i", "j"),
    [(name, i, j) for name in SENSORS[1:] for i in range(size(name)) for j in range(i + 1, size(name))],
)
def test_every_correlation_of_the_prediction_matters(sensor: str, i: int, j: int) -> None:
    mean, matrix = prediction(sensor)
    changed = matrix.copy()
    changed[i, j] = changed[j, i] = 0
    got, other = (convert(sensor, "decorrelated", predicted=(mean, each)) for each in (matrix, changed))
    deviations = np.sqrt(np.diagonal(got.covariance))
    difference = np.abs(got.covariance - other.covariance) / np.outer(deviations, deviations)
    assert difference.max() > (1e-4 if sensor in CLOSED else 1e-6)


@pytest.mark.parametrize("azimuth_std", [0.5, 1.2, 3.0])
def test_a_prediction_of_large_and_correlated_errors_is_averaged_to_rounding(azimuth_std: float) -> None:
    """What the covariance is at a certain truth is tested above."""
    mean, deviations = np.array([0.4, 2000.0, -50.0]), np.array([azimuth_std, 100.0, 30.0])
    matrix = np.array([[1.0, 0.3, 0.6], [0.3, 1.0, 0.7], [0.6, 0.7, 1.0]]) * np.outer(deviations, deviations)
    rules = [np.polynomial.hermite_e.hermegauss(count) for count in (90, 4, 4)]  # the azimuth leads
    grid = np.stack(np.meshgrid(*(nodes for nodes, _ in rules)), axis=-1).reshape(-1, 3)
    weights = np.stack(np.meshgrid(*(weights for _, weights in rules)), axis=-1).prod(axis=-1).ravel()
    azimuth_first = mean + grid @ np.linalg.cholesky(matrix).T
    order = [1, 0, 2]
    certain = (azimuth_first[:, order], np.zeros((3, 3)))
    at_truths = convert("polar_doppler", "decorrelated", predicted=certain).covariance
    expected = np.einsum("wij,w->ij", at_truths, weights / weights.sum())
    whole = (mean[order], matrix[np.ix_(order, order)])
    got = convert("polar_doppler", "decorrelated", predicted=whole).covariance
    assert_covariances_agree(got, expected, ROUNDING)
