"""First states of tracks: by the definition with quadrature, by least squares, and by simulated targets."""

import math
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from radartrack import convert, initiate, observe
from radartrack.kalman import Belief
from radartrack.testing import strategies
from tests.examples import share
from tests.radartrack.plots import PLOTS, SENSORS, Floats, Plot, noise_covariance, plots

BISTATIC: Plot = {
    "path": 30e3,
    "azimuth": 0.7,
    "baseline": 9e3,
    "path_std": 30.0,
    "azimuth_std": 0.01,
    "correlation": 0.3,
}
DOPPLER = ("polar_doppler", "spherical_doppler")
SPEED = 120.0


def one_plot(sensor: Any, plot: Plot, velocity_std: Any = SPEED, **words: Any) -> Belief:
    return initiate.one_plot(sensor, plot, velocity_std, **words)


def two_plots(sensor: Any, first: Plot, second: Plot, period: Any, **words: Any) -> Belief:
    return initiate.two_plots(sensor, first, second, period, **words)


def axes(angles: list[Floats]) -> list[list[Any]]:
    """The line of sight and the directions across it."""
    sine, cosine = np.sin(angles[0]), np.cos(angles[0])
    if len(angles) == 1:
        return [[cosine, sine], [-sine, cosine]]
    up, out = np.sin(angles[1]), np.cos(angles[1])
    return [[out * sine, out * cosine, up], [cosine, -sine, 0 * up], [-up * sine, -up * cosine, out]]


def defined(sensor: str, plot: Plot) -> tuple[Floats, Floats]:
    """Moments of position and velocity over the posterior of range, angles and components of the velocity."""
    noise = noise_covariance(sensor, plot)
    last = len(noise) - 1
    pair = np.ix_([0, last], [0, last])
    information = np.linalg.inv(noise[pair])
    posterior = np.linalg.inv(information + np.diag([0.0, SPEED**-2]))
    mean = posterior @ information @ [plot["r"], plot["range_rate"]]
    names = ("azimuth", "elevation")[: last - 1]
    across = [SPEED**2] * len(names)
    covariance = np.zeros((2 + 2 * len(names),) * 2)
    covariance[:2, :2] = posterior
    covariance[2:, 2:] = np.diag([*np.diagonal(noise)[1:last], *across])
    rules = [np.polynomial.hermite_e.hermegauss(count) for count in (3, 3, *[10] * len(names), *[3] * len(names))]
    grid = np.stack(np.meshgrid(*(nodes for nodes, _ in rules)), axis=-1).reshape(-1, len(rules))
    weights = np.stack(np.meshgrid(*(weights for _, weights in rules)), axis=-1).prod(axis=-1).ravel()
    weights /= weights.sum()
    r, rate, *rest = (
        np.r_[mean, [plot[name] for name in names], [0.0] * len(names)] + grid @ np.linalg.cholesky(covariance).T
    ).T
    directions = axes(rest[: len(names)])
    components = [rate, *rest[len(names) :]]
    velocity = [
        sum(component * axis[k] for component, axis in zip(components, directions, strict=True))
        for k in range(len(directions))
    ]
    states = np.stack([*(r * cosine for cosine in directions[0]), *velocity], axis=-1)
    centre = weights @ states
    return centre, np.einsum("wi,wj,w->ij", states - centre, states - centre, weights, optimize=True)


@pytest.mark.parametrize("sensor", DOPPLER)
@given(data=st.data())
@share(0.1)
def test_the_state_from_one_plot_has_the_moments_of_its_posterior(sensor: str, data: st.DataObject) -> None:
    plot = data.draw(plots(sensor))
    mean, covariance = defined(sensor, plot)
    got = one_plot(sensor, plot)
    deviations = np.sqrt(np.diagonal(covariance))
    assert (np.abs(got.mean - mean) <= 1e-9 * deviations).all()
    assert (np.abs(got.covariance - covariance) <= 1e-8 * np.outer(deviations, deviations)).all()


@pytest.mark.parametrize("sensor", ["polar", "spherical", "ruv", "bistatic"])
def test_without_a_range_rate_the_velocity_is_what_was_known_of_it(sensor: str) -> None:
    plot = BISTATIC if sensor == "bistatic" else PLOTS[sensor]
    mean, covariance = one_plot(sensor, plot)
    position = getattr(convert, sensor)(**plot, method="posterior")
    size = len(position.mean)
    np.testing.assert_allclose(mean, [*position.mean, *[0.0] * size], rtol=1e-14)
    np.testing.assert_allclose(covariance[:size, :size], position.covariance, rtol=1e-13)
    np.testing.assert_array_equal(covariance[size:, size:], SPEED**2 * np.eye(size))
    assert (covariance[:size, size:] == 0).all()


@pytest.mark.parametrize("sensor", DOPPLER)
def test_a_range_rate_that_tells_nothing_leaves_what_was_known_and_one_that_is_exact_leaves_the_rest(
    sensor: str,
) -> None:
    plot = PLOTS[sensor] | {"correlation": 0.0, "azimuth_std": 0.0}
    plot |= {"elevation_std": 0.0} if "elevation" in plot else {}
    poor = one_plot(sensor, plot | {"range_rate_std": 1e12})
    size = len(poor.mean) // 2
    np.testing.assert_allclose(poor.covariance[size:, size:], SPEED**2 * np.eye(size), atol=1e-6 * SPEED**2)
    np.testing.assert_allclose(poor.mean[size:], 0, atol=1e-6)
    exact = one_plot(sensor, plot | {"range_rate_std": 0.0})
    sight = exact.mean[:size] / np.linalg.norm(exact.mean[:size])
    np.testing.assert_allclose(exact.mean[size:], plot["range_rate"] * sight, rtol=1e-12)
    across = SPEED**2 * (np.eye(size) - np.outer(sight, sight))
    np.testing.assert_allclose(exact.covariance[size:, size:], across, atol=1e-9 * SPEED**2)


@pytest.mark.parametrize("sensor", [name for name in SENSORS if name != "ruv"] + ["bistatic"])
def test_the_azimuth_from_the_other_axis_exchanges_the_axes(sensor: str) -> None:
    plot = BISTATIC if sensor == "bistatic" else PLOTS[sensor]
    for start in (one_plot, lambda *given, **words: two_plots(given[0], given[1], given[1], 4.0, **words)):
        from_x, from_y = (start(sensor, plot, azimuth_from=axis) for axis in ("x", "y"))
        size = len(from_x.mean) // 2
        order = [1, 0, 2][:size] + [size + k for k in [1, 0, 2][:size]]
        np.testing.assert_allclose(from_y.mean, from_x.mean[order], rtol=1e-9, atol=1e-9)
        deviations = np.sqrt(np.diagonal(from_x.covariance))
        difference = from_y.covariance[order][:, order] - from_x.covariance
        assert (np.abs(difference) <= 1e-9 * np.outer(deviations, deviations)).all()


@pytest.mark.parametrize("sensor", ["polar", "spherical", "ruv", "bistatic"])
@pytest.mark.parametrize("period", [0.5, 12.0])
def test_two_plots_without_range_rates_are_differenced(sensor: str, period: float) -> None:
    first = BISTATIC if sensor == "bistatic" else PLOTS[sensor]
    step = {"path": 31e3} if sensor == "bistatic" else {"r": 1300.0}
    second = first | step | {"correlation": 0.1}
    (p1, c1), (p2, c2) = (getattr(convert, sensor)(**plot, method="posterior") for plot in (first, second))
    size = len(p1)
    unit = np.eye(size)
    matrix = np.block([[0 * unit, unit], [-unit / period, unit / period]])
    both = np.block([[c1, 0 * unit], [0 * unit, c2]])
    got = two_plots(sensor, first, second, period)
    np.testing.assert_allclose(got.mean, matrix @ np.r_[p1, p2], rtol=1e-13)
    np.testing.assert_allclose(got.covariance, matrix @ both @ matrix.T, rtol=1e-12, atol=1e-12)


ALONG_A_LINE = {
    "r": (2e4, 2.2e4),
    "azimuth": (0.0, 0.0),
    "range_rate": (-90.0, 90.0),
    "range_std": (1.0, 100.0),
    "azimuth_std": (1e-9, 1e-9),
    "range_rate_std": (0.1, 30.0),
    "correlation": (-0.99, 0.99),
}


@given(
    first=strategies.plots("polar_doppler", within=ALONG_A_LINE),
    second=strategies.plots("polar_doppler", within=ALONG_A_LINE),
    period=st.floats(0.1, 20),
)
def test_along_a_line_of_sight_that_is_known_two_plots_are_least_squares(
    first: Plot, second: Plot, period: float
) -> None:
    """Four measurements of a position and a velocity, the errors of each plot correlated."""
    noise = np.zeros((4, 4))
    for place, plot in enumerate((first, second)):
        part = slice(2 * place, 2 * place + 2)
        noise[part, part] = noise_covariance("polar_doppler", plot)[np.ix_([0, 2], [0, 2])]
    matrix = np.array([[1, -period], [0, 1], [1, 0], [0, 1]])
    information = matrix.T @ np.linalg.solve(noise, matrix)
    seen = [first["r"], first["range_rate"], second["r"], second["range_rate"]]
    expected = np.linalg.solve(information, matrix.T @ np.linalg.solve(noise, seen))
    covariance = np.linalg.inv(information)
    got = two_plots("polar_doppler", first, second, period)
    deviations = np.sqrt(np.diagonal(covariance))
    assert (np.abs(got.mean[[0, 2]] - expected) <= 1e-6 * deviations).all()
    along = got.covariance[np.ix_([0, 2], [0, 2])]
    assert (np.abs(along - covariance) <= 1e-6 * np.outer(deviations, deviations)).all()


NOISE: dict[str, Plot] = {
    "polar_doppler": {"range_std": 30.0, "azimuth_std": 0.01, "range_rate_std": 2.0, "correlation": 0.8},
    "spherical_doppler": {"range_std": 30.0, "azimuth_std": 0.01, "range_rate_std": 2.0, "correlation": 0.8}
    | {"elevation_std": 0.01},
}
TRIALS = 20_000


def simulated(sensor: str, states: Floats, seed: int) -> Plot:
    names = {"polar_doppler": ("r", "azimuth", "range_rate")}.get(sensor, ("r", "azimuth", "elevation", "range_rate"))
    errors = np.random.default_rng(seed).multivariate_normal(
        np.zeros(len(names)), noise_covariance(sensor, NOISE[sensor]), len(states), method="cholesky"
    )
    truth = getattr(observe, sensor)(states).measurement
    return {name: truth[:, k] + errors[:, k] for k, name in enumerate(names)} | NOISE[sensor]


def nees(belief: Belief, states: Floats) -> Floats:
    error = belief.mean - states
    weighted = np.linalg.solve(belief.covariance, error[..., np.newaxis])[..., 0]
    squares: Floats = (error * weighted).sum(axis=-1) / error.shape[-1]
    return squares


def flights(sensor: str, period: float) -> tuple[Floats, Floats]:
    """States at both plots, at random places and with random velocities."""
    size = 2 if sensor == "polar_doppler" else 3
    generator = np.random.default_rng(3)
    position = np.array([20e3, 12e3, 9e3])[:size] + 500 * generator.standard_normal((TRIALS, size))
    velocity = SPEED * generator.standard_normal((TRIALS, size))
    return tuple(np.concatenate([position + t * velocity, velocity], axis=1) for t in (0.0, period))  # type: ignore[return-value]


@pytest.mark.parametrize("sensor", DOPPLER)
def test_the_covariance_tells_the_size_of_the_error_of_simulated_tracks(sensor: str) -> None:
    """Six standard errors; those of an average over 20 000 tracks are 0.005."""
    before, after = flights(sensor, 10.0)
    first, second = simulated(sensor, before, 1), simulated(sensor, after, 2)
    for squares in (nees(one_plot(sensor, second), after), nees(two_plots(sensor, first, second, 10.0), after)):
        assert abs(squares.mean() - 1) < 6 * squares.std() / math.sqrt(TRIALS)
    with_rates = two_plots(sensor, first, second, 10.0).covariance[0]
    without = two_plots(sensor, first | {"range_rate_std": 1e6}, second | {"range_rate_std": 1e6}, 10.0).covariance[0]
    assert np.trace(with_rates[len(with_rates) // 2 :]) < np.trace(without[len(without) // 2 :])


@pytest.mark.parametrize("sensor", DOPPLER)
def test_plots_of_any_shape_broadcast(sensor: str) -> None:
    plot = PLOTS[sensor] | {"r": np.array([900.0, 2e3, 3e3]), "range_std": np.array([[10.0], [20.0]])}
    period = np.array([[4.0], [5.0]])
    both = one_plot(sensor, plot), two_plots(sensor, plot, PLOTS[sensor], period)
    size = both[0].mean.shape[-1]
    for got in both:
        assert (got.mean.shape, got.covariance.shape) == ((2, 3, size), (2, 3, size, size))
    few = PLOTS[sensor] | {"r": 2e3, "range_std": 20.0}
    alone = one_plot(sensor, few), two_plots(sensor, few, PLOTS[sensor], 5.0)
    for got, expected in zip(both, alone, strict=True):
        np.testing.assert_allclose(got.mean[1, 1], expected.mean, rtol=1e-9, atol=1e-9)


@pytest.mark.parametrize(
    ("call", "error", "message"),
    [
        (lambda: one_plot("radar", {}), ValueError, "sensor must be one of"),
        (lambda: one_plot("polar", {"r": 1.0}), TypeError, r"a plot must have the arguments \['r', 'azimuth'"),
        (lambda: one_plot("polar", PLOTS["polar"], 0.0), ValueError, "velocity_std must be from 0.001 to 1000000 m/s"),
        (lambda: one_plot("polar", PLOTS["polar"] | {"r": -1.0}), ValueError, "r must be from 0 to"),
        (lambda: one_plot("ruv", PLOTS["ruv"], azimuth_from="x"), ValueError, "azimuth_from must be None for sensor"),
        (lambda: two_plots("polar", PLOTS["polar"], PLOTS["polar"], 0.0), ValueError, "period must be from 1e-06 to"),
        (lambda: two_plots("polar", PLOTS["polar"], {"r": 1.0}, 1.0), TypeError, "a plot must have the arguments"),
    ],
)
def test_bad_arguments_are_named(call: Any, error: type[Exception], message: str) -> None:
    with pytest.raises(error, match=message):
        call()


@pytest.mark.parametrize("axis", ["x", "y"])
def test_more_pairs_of_plots_than_a_block_holds_are_started_each_as_alone(axis: Any) -> None:
    generator = np.random.default_rng(1)
    count = initiate.BLOCK + 5
    plot = {"azimuth": 0.7, "range_rate": -80.0, "range_std": 30.0, "azimuth_std": 0.02, "range_rate_std": 1.0}
    first: dict[str, Any] = plot | {"r": generator.uniform(1e4, 2e4, count), "correlation": 0.5}
    second: dict[str, Any] = plot | {"r": 1.5e4, "range_rate": generator.uniform(-90, 90, (2, 1))}
    got = initiate.two_plots("polar_doppler", first, second, 4.0, azimuth_from=axis)
    assert got.mean.shape == (2, count, 4)
    for row, column in ((0, 0), (1, count - 1)):
        own = first | {"r": first["r"][column]}, second | {"range_rate": second["range_rate"][row, 0]}
        alone = initiate.two_plots("polar_doppler", *own, 4.0, azimuth_from=axis)
        np.testing.assert_allclose(got.mean[row, column], alone.mean, rtol=1e-12)
        np.testing.assert_allclose(got.covariance[row, column], alone.covariance, rtol=1e-9)


@pytest.mark.parametrize("sensor", SENSORS)
def test_the_type_is_that_of_all_that_is_given(sensor: str) -> None:
    plot = PLOTS[sensor]
    single, double = ({name: kind(value) for name, value in plot.items()} for kind in (np.float32, np.float64))
    for found in (one_plot(sensor, single), two_plots(sensor, single, single, 2.0)):
        assert {found.mean.dtype, found.covariance.dtype} == {np.dtype(np.float32)}
    for first, period in ((double, 2.0), (single, np.float64(2.0))):
        found = two_plots(sensor, first, single, period)
        assert {found.mean.dtype, found.covariance.dtype} == {np.dtype(np.float64)}
    exact = two_plots(sensor, single, single, np.float64(2.0))
    rounded = two_plots(sensor, single, single, np.float32(2.0))
    np.testing.assert_array_equal(rounded.mean, exact.mean.astype(np.float32))
    np.testing.assert_array_equal(rounded.covariance, exact.covariance.astype(np.float32))


@pytest.mark.parametrize("sensor", ["spherical", "spherical_doppler"])
@pytest.mark.parametrize("sign", [-1.0, 1.0])
def test_a_right_angle_in_single_precision_is_none_beyond_the_vertical(sensor: str, sign: float) -> None:
    """As the conversion takes it: pi and its half are rounded up there."""
    at_the_end = {"elevation": sign * np.pi / 2, "azimuth_std": np.pi, "elevation_std": np.pi}
    single = {name: np.full(3, value, np.float32) for name, value in (PLOTS[sensor] | at_the_end).items()}
    for found in (one_plot(sensor, single), two_plots(sensor, single, single, 2.0)):
        assert np.isfinite(found.mean).all()
        assert found.mean.dtype == np.float32
