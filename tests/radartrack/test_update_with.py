"""Extended updates: the formulas of the books, angles the short way round, and where nothing has a derivative."""

import math
from typing import Any, cast

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from radartrack import kalman, observe
from radartrack._filtering import beliefs
from radartrack._observation.sights import SIGHTS, SightName
from radartrack.kalman import Belief
from radartrack.testing import strategies
from tests.examples import share
from tests.radartrack.plots import Floats

DEVIATIONS = {"azimuth": 0.02, "elevation": 0.03, "u": 0.01, "v": 0.02}
SITES: dict[str, dict[str, Any]] = {name: {"baseline": 7e3} for name in ("bistatic", "bistatic_range_rate")}
SITES |= {name: {"receiver": [3e3, -4e3, 50.0]} for name in ("range_difference", "range_rate_difference")}


def observed(sensor: str, state: Any, **convention: str) -> observe.Observed:
    found: observe.Observed = getattr(observe, sensor)(state, **SITES.get(sensor, {}), **convention)
    return found


def update(sensor: Any, belief: Belief, measured: Any, noise: Any, order: Any = 1, **more: Any) -> Belief:
    return kalman.update_with(sensor, belief, measured, noise, order, **SITES.get(sensor, {}), **more)


def scene(sensor: str, seed: int, tracks: tuple[int, ...] = (), more: int = 0) -> tuple[Belief, Floats, Floats]:
    """Beliefs with all correlations, what is measured of the truth, and noise with all correlations."""
    generator, sight = np.random.default_rng(seed), SIGHTS[sensor]  # type: ignore[index]
    size, count = len(sight.state) + more, len(sight.outputs)
    unit = np.array([300.0 if name in "xyz" else 20.0 for name in sight.state] + [5.0] * more)
    mean = generator.uniform(2e3, 9e3, (*tracks, size)) * generator.choice([-1, 1], (*tracks, size)) * unit / 300
    root = (np.eye(size) + 0.3 * generator.standard_normal((*tracks, size, size))) * unit[:, np.newaxis]
    covariance = root @ np.swapaxes(root, -1, -2)
    state = (mean + (root @ generator.standard_normal((*tracks, size, 1)))[..., 0])[..., : len(sight.state)]
    errors = np.diag([DEVIATIONS.get(name, 3.0 if "rate" in name else 40.0) for name in sight.outputs])
    errors = errors @ (np.eye(count) + np.tril(np.full((count, count), 0.3), -1))
    measured = observed(sensor, state).measurement + generator.standard_normal((*tracks, count)) @ errors.T
    return Belief(mean, covariance), measured, errors @ errors.T


def by_the_book(sensor: str, belief: Belief, measured: Floats, noise: Floats, order: int) -> Belief:
    """One track: gain, innovation and its covariance in dense matrices."""
    mean, P = belief
    size = len(SIGHTS[sensor].state)  # type: ignore[index]
    g, J, G = observed(sensor, mean[:size])
    H = np.zeros((len(g), len(mean)))
    H[:, :size] = J
    S = H @ P @ H.T + noise
    if order == 2:
        products = [curvature @ P[:size, :size] for curvature in G]
        g = g + [np.trace(product) / 2 for product in products]
        S = S + [[np.trace(a @ b) / 2 for b in products] for a in products]
    innovation = measured - g
    for place, name in enumerate(SIGHTS[sensor].outputs):  # type: ignore[index]
        if name == "azimuth":
            innovation[place] = math.remainder(innovation[place], 2 * math.pi)
    gain = np.linalg.solve(S, H @ P).T
    return Belief(mean + gain @ innovation, P - gain @ S @ gain.T)


def assert_same(got: Belief, expected: Belief, tolerance: float = 1e-9) -> None:
    deviations = np.sqrt(np.diagonal(expected.covariance, axis1=-2, axis2=-1))
    assert (np.abs(got.mean - expected.mean) <= tolerance * deviations).all()
    scale = deviations[..., :, np.newaxis] * deviations[..., np.newaxis, :]
    assert (np.abs(got.covariance - expected.covariance) <= tolerance * scale).all()


@pytest.mark.parametrize("order", [1, 2])
@pytest.mark.parametrize("more", [0, 3])
@pytest.mark.parametrize("sensor", SIGHTS)
@given(seed=st.integers(0, 10**6))
@share(0.1)
def test_the_update_is_that_of_the_books_also_of_states_of_more_than_is_measured(
    sensor: str, order: int, more: int, seed: int
) -> None:
    belief, measured, noise = scene(sensor, seed, more=more)
    assert_same(update(sensor, belief, measured, noise, order), by_the_book(sensor, belief, measured, noise, order))


@pytest.mark.parametrize("order", [1, 2])
@pytest.mark.parametrize("sensor", SIGHTS)
def test_tracks_of_any_shape_are_updated_as_if_one_by_one(sensor: str, order: int) -> None:
    belief, measured, noise = scene(sensor, 3, (2, 5))
    noises = noise * np.arange(1.0, 6.0)[:, np.newaxis, np.newaxis]
    for errors in (noise, noises):
        got = update(sensor, belief, measured, errors, order)
        assert (got.mean.shape, got.covariance.shape) == (belief.mean.shape, belief.covariance.shape)
        for index in np.ndindex(2, 5):
            own = errors if errors.ndim == 2 else errors[index[1]]
            alone = update(sensor, Belief(belief.mean[index], belief.covariance[index]), measured[index], own, order)
            assert_same(Belief(got.mean[index], got.covariance[index]), alone)
    shared = update(sensor, Belief(belief.mean, belief.covariance[0, 0]), measured, noise, order)
    alone = update(sensor, Belief(belief.mean[1, 2], belief.covariance[0, 0]), measured[1, 2], noise, order)
    assert_same(Belief(shared.mean[1, 2], shared.covariance[1, 2]), alone)


@pytest.mark.parametrize("order", [1, 2])
def test_float32_in_gives_float32_out_close_to_float64(order: int) -> None:
    belief, measured, noise = scene("spherical", 5)
    got = update(
        "spherical", Belief(*(p.astype(np.float32) for p in belief)), np.float32(measured), np.float32(noise), order
    )
    assert {got.mean.dtype, got.covariance.dtype} == {np.dtype(np.float32)}
    assert_same(got, update("spherical", belief, measured, noise, order), 1e-2)


def test_more_tracks_than_a_block_holds_are_updated_each_with_its_own_plot() -> None:
    count = 2 * beliefs.BLOCK + 3
    belief, measured, noise = scene("polar", 4, (count,), more=2)
    got = update("polar", belief, measured, noise, 2)
    for index in (0, beliefs.BLOCK, count - 1):
        alone = by_the_book("polar", Belief(belief.mean[index], belief.covariance[index]), measured[index], noise, 2)
        assert_same(Belief(got.mean[index], got.covariance[index]), alone)


@pytest.mark.parametrize("order", [1, 2])
@pytest.mark.parametrize("sensor", [name for name, sight in SIGHTS.items() if "azimuth" in sight.outputs])
@given(turns=st.integers(-3, 3), seed=st.integers(0, 99))
@share(0.1)
def test_whole_turns_of_the_azimuth_make_no_difference(sensor: str, order: int, turns: int, seed: int) -> None:
    belief, measured, noise = scene(sensor, seed)
    turned = measured + 2 * math.pi * turns * (np.array(SIGHTS[cast("SightName", sensor)].outputs) == "azimuth")
    assert_same(update(sensor, belief, turned, noise, order), update(sensor, belief, measured, noise, order))


@pytest.mark.parametrize("sensor", [name for name, sight in SIGHTS.items() if sight.azimuth_from])
@given(seed=st.integers(0, 99))
@share(0.1)
def test_the_other_azimuth_is_the_same_update_with_the_axes_exchanged(sensor: str, seed: int) -> None:
    belief, measured, noise = scene(sensor, seed)
    state = SIGHTS[sensor].state  # type: ignore[index]
    exchanged = [state.index({"x": "y", "y": "x", "vx": "vy", "vy": "vx"}.get(name, name)) for name in state]
    other = "y" if SIGHTS[sensor].azimuth_from == "x" else "x"  # type: ignore[index]
    mirrored = Belief(belief.mean[exchanged], belief.covariance[np.ix_(exchanged, exchanged)])
    got = update(sensor, mirrored, measured, noise, 2, azimuth_from=other)
    expected = update(sensor, belief, measured, noise, 2)
    assert_same(Belief(got.mean[exchanged], got.covariance[np.ix_(exchanged, exchanged)]), expected)


@pytest.mark.parametrize("order", [1, 2])
@given(seed=st.integers(0, 99))
@share(0.2)
def test_a_missing_quantity_is_as_if_the_sensor_did_not_measure_it(order: int, seed: int) -> None:
    belief, measured, noise = scene("polar", seed)
    alone = update("bearing", belief, measured[1:], noise[1:, 1:], order)
    assert_same(update("polar", belief, [np.nan, measured[1]], noise, order), alone)
    nothing = update("polar", belief, [np.nan, np.nan], noise, order)
    np.testing.assert_array_equal(nothing.mean, belief.mean)
    np.testing.assert_array_equal(nothing.covariance, belief.covariance)


@pytest.mark.parametrize("order", [1, 2])
def test_at_the_radar_a_plot_tells_nothing(order: int) -> None:
    belief = Belief(np.zeros(4), np.diag([1e4, 1e4, 100.0, 100.0]))
    got = update("polar", belief, [500.0, 1.0], [[100.0, 0.1], [0.1, 1e-3]], order)
    np.testing.assert_array_equal(got.mean, belief.mean)
    np.testing.assert_array_equal(got.covariance, belief.covariance)


@pytest.mark.parametrize("order", [1, 2])
@pytest.mark.parametrize("sensor", ["spherical", "spherical_doppler"])
def test_above_the_radar_range_and_its_rate_count_and_the_angles_do_not(sensor: str, order: int) -> None:
    size = len(SIGHTS[sensor].state)  # type: ignore[index]
    state = np.array([0.0, 0.0, 5e3, 100.0, 50.0, -10.0])[:size]
    belief = Belief(state, np.diag([300.0, 300.0, 300.0, 9.0, 9.0, 9.0])[:size, :size] ** 2)
    measured, noise = np.array([5.1e3, 2.0, 1.5, -12.0]), np.diag([50.0, 0.01, 0.01, 2.0]) ** 2
    noise[0, 1] = noise[1, 0] = 0.4
    count = 3 if sensor == "spherical" else 4
    got = update(sensor, belief, measured[:count], noise[:count, :count], order)
    without = np.where([True, False, False, True], measured, np.nan)[:count]
    assert_same(got, update(sensor, belief, without, noise[:count, :count], order))
    assert 5e3 < got.mean[2] < 5.1e3
    assert got.covariance[2, 2] < 0.1 * 300.0**2


@given(
    distance=st.floats(-100, 3).map(lambda power: 10.0**power),
    angle=st.floats(-math.pi, math.pi),
    noise=strategies.correlated_noise("spherical", within={"correlation": (-0.99, 0.99)}),
    order=st.sampled_from([1, 2]),
)
def test_near_the_vertical_axis_the_result_is_a_belief(
    distance: float, angle: float, noise: Floats, order: int
) -> None:
    mean = np.array([distance * math.cos(angle), distance * math.sin(angle), 2e3])
    belief = Belief(mean, np.diag([200.0, 200.0, 100.0]) ** 2)
    got = update("spherical", belief, [2010.0, 0.4, 1.4], noise, order)
    assert np.isfinite(got.mean).all()
    deviations = np.sqrt(np.diagonal(got.covariance))
    assert (deviations <= np.sqrt(np.diagonal(belief.covariance)) * (1 + 1e-9)).all()


def test_the_second_order_believes_less_where_the_azimuth_bends() -> None:
    """Errors of a track that is near: their NEES over the number of coordinates is 1 where the covariance is right."""
    generator = np.random.default_rng(2)
    spread, noise = np.diag([400.0, 400.0]) ** 2, np.diag([2.0, 0.2]) ** 2
    truth = np.array([2e3, 0.0]) + generator.standard_normal((20_000, 2)) * 400.0
    measured = observe.polar(truth).measurement + generator.standard_normal((20_000, 2)) * [2.0, 0.2]
    nees = {}
    for order in (1, 2):
        got = update("polar", Belief(np.array([2e3, 0.0]), spread), measured, noise, order)
        error = got.mean - truth
        nees[order] = (error * np.linalg.solve(got.covariance, error[..., np.newaxis])[..., 0]).sum(axis=-1).mean() / 2
    assert nees[1] > 5
    assert nees[2] < 1.3


@pytest.mark.parametrize(
    ("arguments", "error", "message"),
    [
        (("radar", [1e3, 1e3], [1.0, 1.0], np.eye(2)), ValueError, "sensor must be one of"),
        (("spherical", [1e3, 1e3], [1.0] * 3, np.eye(3)), ValueError, "mean must have at least 3 components"),
        (("polar", [1e3, 1e3], [1.0] * 3, np.eye(2)), ValueError, r"measured must have shape \(..., 2\)"),
        (("polar", [1e3, 1e3], [1.0, math.inf], np.eye(2)), ValueError, "measured must be finite, or NaN"),
        (("polar", [1e3, 1e3], [1.0, 1.0], np.eye(3)), ValueError, r"noise must have shape \(..., 2, 2\)"),
        (("polar", [1e3, 1e3], [1.0, 1.0], np.zeros((2, 2))), ValueError, "noise must have variances of more than 0"),
        (("polar", [1e3, 1e3], [1.0, 1.0], np.eye(2), 3), ValueError, "order must be from 1 to 2; got 3"),
        (("polar", [1e3, 1e151], [1.0, 1.0], np.eye(2)), ValueError, "y of mean must be from"),
        (("polar", ["1", 2], [1.0, 1.0], np.eye(2)), TypeError, "mean must be real numbers"),
    ],
)
def test_bad_arguments_are_named(arguments: Any, error: type[Exception], message: str) -> None:
    sensor, mean, measured, noise, *order = arguments
    with pytest.raises(error, match=message):
        update(sensor, Belief(mean, np.eye(len(mean))), measured, noise, *order)


def test_a_site_is_demanded_where_there_is_one() -> None:
    belief: Any = Belief(np.array([1e3, 1e3]), np.eye(2))
    with pytest.raises(TypeError, match=r"takes \['baseline'\] beside the state; got \[\]"):
        kalman.update_with("bistatic", belief, [3e3, 0.1], np.eye(2))
    with pytest.raises(ValueError, match="azimuth_from must be None for sensor 'ruv'"):
        kalman.update_with("ruv", Belief(np.ones(3), np.eye(3)), [3e3, 0.1, 0.1], np.eye(3), azimuth_from="x")
