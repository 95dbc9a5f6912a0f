"""Weights and fused lines, against definitions, and against what their covariances say.

Monte Carlo checks fail by chance with a probability below 2e-9 each.
"""

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray
from scipy import stats

from radartrack import convert, fusion, line
from radartrack.generated import fusion as formulas

Array = NDArray[Any]
CHANCE = 1e-9
DEGREE = np.pi / 180


def covariances(generator: np.random.Generator, *shape: int, size: int) -> Array:
    factor = generator.normal(size=(*shape, size, size))
    return factor @ np.swapaxes(factor, -1, -2) + 0.2 * np.eye(size)


@given(std=st.lists(st.floats(1e-90, 1e90), min_size=1, max_size=6))
def test_weights_sum_to_one_and_are_inversely_proportional_to_the_variances(std: list[float]) -> None:
    found = fusion.weights(std)
    assert found.sum() == pytest.approx(1)
    scaled = np.sqrt(found) * np.array(std)
    kept = found > 1e-300
    assert scaled[kept] == pytest.approx(scaled[np.argmax(found)], rel=1e-9)


def test_weights_are_the_derived_ones() -> None:
    std = np.array([[3.0, 1.0, 20.0], [5.0, 5.0, 0.1]])
    expected = formulas.weights_three(sigma_1=std[:, 0], sigma_2=std[:, 1], sigma_3=std[:, 2])
    assert fusion.weights(std) == pytest.approx(expected, rel=1e-14)


@given(seed=st.integers(0, 10**6), count=st.integers(1, 5), size=st.integers(1, 4))
def test_fused_means_are_those_of_stacked_generalised_least_squares(seed: int, count: int, size: int) -> None:
    generator = np.random.default_rng(seed)
    means, errors = generator.normal(size=(count, size)) * 1e3 + 1e6, covariances(generator, count, size=size)
    whole = np.zeros((count * size, count * size))
    for j in range(count):
        whole[j * size : (j + 1) * size, j * size : (j + 1) * size] = errors[j]
    design, inverse = np.tile(np.eye(size), (count, 1)), np.linalg.inv(whole)
    covariance = np.linalg.inv(design.T @ inverse @ design)
    fused = fusion.fuse(means, errors)
    assert fused.mean == pytest.approx(covariance @ design.T @ inverse @ means.ravel(), rel=1e-9)
    assert fused.covariance == pytest.approx(covariance, rel=1e-7, abs=1e-9)


def test_fusion_of_converted_measurements_is_batched_and_its_covariance_holds() -> None:
    """Normalised squared errors of 20000 fusions: a covariance that is wrong by 4 % is detected."""
    generator = np.random.default_rng(4)
    target, sites = np.array([2e4, 5e4]), np.array([[0.0, 0.0], [6e4, 1e4], [-1e4, 9e4]])
    toward = target - sites
    range_std, azimuth_std = np.array([50.0, 120.0, 30.0]), np.array([0.002, 0.001, 0.004])
    r = np.hypot(*toward.T) + range_std * generator.normal(size=(20000, 3))
    azimuth = np.arctan2(*toward.T) + azimuth_std * generator.normal(size=(20000, 3))
    plots = convert.polar(r, azimuth, range_std, azimuth_std, azimuth_from="y")
    fused = fusion.fuse(plots.mean + sites, plots.covariance)
    error = fused.mean - target
    squares = np.einsum("ni,nij,nj", error, np.linalg.inv(fused.covariance), error)
    low, high = stats.chi2.ppf([CHANCE, 1 - CHANCE], 2 * 20000)
    assert low < squares < high


def test_propagated_covariances_are_those_of_small_errors() -> None:
    """From 200000 plots the standard error of an entry is 0.4 %; an entry wrong by 2.5 % is detected."""
    generator = np.random.default_rng(2)
    plot = {"r": 4e4, "azimuth": 0.8, "elevation": 0.5}
    std = {"range_std": 30.0, "azimuth_std": 2e-3, "elevation_std": 3e-3}
    noise = generator.normal(size=(3, 200_000)) * np.array(list(std.values()))[:, np.newaxis]
    measured = [value + error for value, error in zip(plot.values(), noise, strict=True)]
    expected = np.cov(line.to_plane(*measured))
    found = fusion.propagated_covariance(**plot, **std)
    scale = np.sqrt(np.outer(np.diag(expected), np.diag(expected)))
    assert np.abs(found - expected).max() / scale.max() < 0.025
    assert fusion.position_std(found) == pytest.approx(np.sqrt(np.trace(found) / 2))


def test_the_stated_deviation_takes_one_length_for_all() -> None:
    found = fusion.stated_std([0.0, 100.0], [1.0 * DEGREE, 0.0], 5e4)
    assert found == pytest.approx([872.66 / np.sqrt(2), 100 / np.sqrt(2)], rel=1e-5)


# Lines


def radars(generator: np.random.Generator, runs: int) -> tuple[list[Array], list[Array], list[Array], Array]:
    """Three radars with different periods and correlated errors of x and y; truth x = 100 + 3 t, y = 50 - 2 t."""
    times = [np.arange(0.0, 100.0, step) + start for step, start in ((5.0, 0.0), (8.0, 3.0), (10.0, 1.0))]
    errors = np.array([[[9.0, 4.0], [4.0, 25.0]], [[100.0, -50.0], [-50.0, 64.0]], [[4.0, 1.0], [1.0, 1.0]]])
    x, y = [], []
    for t, error in zip(times, errors, strict=True):
        noise = generator.normal(size=(runs, t.size, 2)) @ np.linalg.cholesky(error).T
        x.append(100.0 + 3.0 * t + noise[..., 0])
        y.append(50.0 - 2.0 * t + noise[..., 1])
    return times, x, y, errors


def test_the_two_layer_line_is_one_weighted_regression_over_all_plots() -> None:
    times, x, y, _ = radars(np.random.default_rng(1), 3)
    weights = np.array([[0.2, 0.5, 0.3], [0.6, 0.2, 0.2], [0.1, 0.1, 0.8]])
    fused = fusion.fuse_lines(times, x, y, weights)
    t = np.concatenate(times)
    for run in range(3):
        each = np.sqrt(np.repeat(weights[run], [time.size for time in times]))
        for axis, coordinate in enumerate((x, y)):
            slope, intercept = np.polyfit(t, np.concatenate([values[run] for values in coordinate]), 1, w=each)
            assert fused.velocity[run, axis] == pytest.approx(slope)
            assert fused.at([0.0])[run, 0, axis] == pytest.approx(intercept)


def test_the_reweighted_first_layer_weighs_each_radar_by_the_printed_iteration() -> None:
    times, x, y, _ = radars(np.random.default_rng(1), 1)
    fused = fusion.fuse_lines(times, x, y, [0.2, 0.5, 0.3], first_layer="reweighted")
    own = [line.fit(t, values[0], method="reweighted").weights for t, values in zip(times, x, strict=True)]
    total = np.concatenate([w * v / v.mean() for w, v in zip([0.2, 0.5, 0.3], own, strict=True)])
    slope, _ = np.polyfit(np.concatenate(times), np.concatenate([v[0] for v in x]), 1, w=np.sqrt(total))
    assert fused.velocity[0, 0] == pytest.approx(slope)


def test_covariance_weighted_lines_keep_what_their_covariance_promises_and_beat_two_layers() -> None:
    """Normalised squared errors of 10000 runs, four degrees of freedom each: 4 % of a covariance is detected."""
    times, x, y, errors = radars(np.random.default_rng(7), 10_000)
    t, z = np.concatenate(times), np.stack([np.concatenate(c, axis=-1) for c in (x, y)], axis=-1)
    motion = fusion.fuse_plots(t, z, np.repeat(errors, [time.size for time in times], axis=0))
    assert motion.covariance is not None
    truth = np.stack([100 + 3 * motion.time, 50 - 2 * motion.time], axis=-1)
    error = np.concatenate([motion.position - truth, motion.velocity - [3.0, -2.0]], axis=-1)
    squares = np.einsum("ni,nij,nj", error, np.linalg.inv(motion.covariance), error)
    low, high = stats.chi2.ppf([CHANCE, 1 - CHANCE], 4 * 10_000)
    assert low < squares < high
    weights = fusion.weights([fusion.position_std(error) for error in errors])
    layered = fusion.fuse_lines(times, x, y, weights)
    assert np.var(layered.velocity[:, 0]) > 1.1 * np.var(motion.velocity[:, 0])


def test_a_constant_bias_goes_into_the_line_by_the_weight_of_its_radar() -> None:
    times = [np.arange(0.0, 60.0, 5.0)] * 3
    weights, bias = np.array([0.5, 0.2, 0.3]), np.array([0.0, 70.0, -20.0])
    x = [2.0 * t + b for t, b in zip(times, bias, strict=True)]
    fused = fusion.fuse_lines(times, x, [0 * t for t in times], weights)
    assert fused.at([0.0, 33.0])[:, 0] == pytest.approx(2 * np.array([0.0, 33.0]) + weights @ bias)


def test_the_scatter_about_a_line_sees_neither_constant_bias_nor_wrong_north() -> None:
    generator = np.random.default_rng(3)
    t = np.arange(0.0, 300.0, 5.0)
    x, y = 1e4 + 150 * t + generator.normal(0, 30, t.size), 3e4 - 60 * t + generator.normal(0, 30, t.size)
    plain = line.measurement_std(t, x, y)
    moved = line.measurement_std(t, x + 400.0, y - 250.0)
    assert moved.x == pytest.approx(plain.x)
    assert moved.y == pytest.approx(plain.y)
    turned = (x + 1j * y) * np.exp(1j * DEGREE)
    assert line.measurement_std(t, turned.real, turned.imag).position == pytest.approx(plain.position)


def test_a_missing_elevation_bends_the_track_and_part_of_it_counts_as_scatter() -> None:
    t = np.arange(0.0, 400.0, 5.0)
    east, north = -3e4 + 150 * t, np.full(t.size, 1.2e4)
    slant, azimuth = np.sqrt(east**2 + north**2 + 9e3**2), np.arctan2(east, north)
    x, y = line.to_plane(slant, azimuth)
    offset = np.hypot(x - east, y - north)
    scatter = line.measurement_std(t, x, y)
    assert offset.mean() > 1500
    assert 300 < np.hypot(scatter.x, scatter.y) < offset.mean()


@pytest.mark.parametrize(
    ("call", "error", "words"),
    [
        (lambda: fusion.weights([1.0, 0.0]), ValueError, "std must be positive"),
        (lambda: fusion.weights([]), ValueError, "at least one"),
        (lambda: fusion.weights(1.0), ValueError, "on its last axis"),
        (lambda: fusion.weights([1.0, -1.0]), ValueError, "std must be"),
        (lambda: fusion.weights([1.0, np.inf]), ValueError, "std must be finite"),
        (lambda: fusion.weights(["a"]), TypeError, "std must be real"),
        (lambda: fusion.fuse([[0.0, 0.0]], [[[1.0, 2.0], [2.0, 1.0]]]), ValueError, "positive definite"),
        (lambda: fusion.fuse([[0.0, 0.0]], [[[1.0, 0.5], [0.2, 1.0]]]), ValueError, "symmetric"),
        (lambda: fusion.fuse([[0.0, 0.0]], [np.eye(3)]), ValueError, "covariance must have shape"),
        (lambda: fusion.fuse([0.0, 0.0], [np.eye(2)]), ValueError, "mean must have shape"),
        (lambda: fusion.fuse_lines([[0.0, 1.0]], [[0.0, 1.0]], [[0.0, 1.0]], [0.5, 0.5]), ValueError, "radar_weights"),
        (lambda: fusion.fuse_lines([[0.0, 1.0]], [], [[0.0, 1.0]], [1.0]), ValueError, "same radars"),
        (lambda: fusion.fuse_lines([[1.0, 1.0]], [[0.0, 1.0]], [[0.0, 1.0]], [1.0]), ValueError, "different times"),
        (lambda: fusion.fuse_lines([[]], [[]], [[]], [1.0]), ValueError, "t of radar 0"),
        (lambda: fusion.fuse_plots([1.0, 1.0], np.zeros((2, 2)), np.eye(2)), ValueError, "different times for each"),
        (lambda: fusion.fuse_plots([0.0, 1.0], np.zeros((2, 3)), np.eye(2)), ValueError, "position must have"),
        (lambda: fusion.position_std([[-1.0, 0.0], [0.0, 1.0]]), ValueError, "negative variance"),
        (lambda: fusion.propagated_covariance(1.0, 0.0, -1.0, 0.1), ValueError, "range_std must be"),
    ],
)  # fmt: skip
def test_bad_arguments_are_named(call: Callable[[], object], error: type[Exception], words: str) -> None:
    with pytest.raises(error, match=words):
        call()


@pytest.mark.parametrize("name", ["t", "x", "y"])
@pytest.mark.parametrize("wrong", [1.0, None, {1.0, 2.0}, np.float32(3)])
def test_what_is_no_list_of_radars_is_refused_by_name(name: str, wrong: Any) -> None:
    plots: dict[str, Any] = {one: [[0.0, 1.0, 2.0], [0.0, 1.5, 3.0]] for one in "txy"}
    with pytest.raises(TypeError, match=f"^{name} must be a list of arrays"):
        fusion.fuse_lines(**{**plots, name: wrong}, radar_weights=[0.5, 0.5])


def test_plots_give_the_same_bits_however_they_lie_in_memory() -> None:
    generator = np.random.default_rng(5)
    times = np.sort(generator.uniform(0, 100, (5, 9)), axis=-1)
    places, errors = 1e4 * generator.standard_normal((5, 9, 2)), np.broadcast_to(np.diag([4.0, 9.0]), (5, 9, 2, 2))
    rows, columns = (fusion.fuse_plots(*map(order, (times, places, errors))) for order in (np.copy, np.asfortranarray))
    for one, other in zip(rows, columns, strict=True):
        np.testing.assert_array_equal(one, other)
