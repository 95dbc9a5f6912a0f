"""Errors that are one, or hardly more than one, are covariances too, whichever way rounding has taken them."""

from collections.abc import Callable
from typing import Any, cast

import mpmath
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from radartrack import kalman, observe, simulate
from radartrack.kalman import Belief, Motion
from tests.examples import share

AT_REST = Motion(np.eye(4), np.zeros((4, 4)))


def of_rank(size: int, rank: int, power: float, seed: int) -> tuple[Any, Any]:
    """A root (size, rank), of deviations that differ by up to so many powers of ten, and its square in floats."""
    generator = np.random.default_rng(seed)
    root = generator.standard_normal((size, rank)) * 10.0 ** generator.uniform(-power, power, (size, 1))
    return root, root @ root.T


def exactly(belief: Belief, measured: Any, H: Any, root: Any) -> tuple[Any, Any]:
    """The update in fifty digits, with the product of a root for the noise."""
    with mpmath.workdps(50):
        P, matrix, mean, rows = (mpmath.matrix(part.tolist()) for part in (belief.covariance, H, belief.mean, root))
        gain = P * matrix.T * mpmath.inverse(matrix * P * matrix.T + rows * rows.T)
        moved = mean + gain * (mpmath.matrix(measured.tolist()) - matrix * mean)
        reduced = P - gain * matrix * P
        return np.array(moved.tolist(), float)[:, 0], np.array(reduced.tolist(), float)


@pytest.mark.parametrize("way", ["one", "each", "run", "each scan"])
@given(size=st.integers(2, 4), rank=st.integers(1, 3), power=st.floats(0, 3), seed=st.integers(0, 10**6))
@share(0.5)
def test_a_noise_of_any_rank_is_taken_for_what_it_is(way: str, size: int, rank: int, power: float, seed: int):
    root, noise = of_rank(size, min(rank, size), power, seed)
    generator = np.random.default_rng(seed + 1)
    H, spread = generator.standard_normal((size, 4)), generator.standard_normal((4, 4))
    belief, measured = Belief(generator.standard_normal(4), spread @ spread.T), generator.standard_normal(size)
    expected = exactly(belief, measured, H, root)
    if way in {"one", "each"}:
        errors = noise if way == "one" else np.stack([noise, 2.0 * noise])
        found = kalman.update(belief, np.stack([measured] * 2), H, errors)
        got = found.mean[0], found.covariance[0]
    else:
        errors = noise if way == "run" else np.stack([noise, 2.0 * noise])
        found = kalman.run(belief, AT_REST, np.stack([measured, np.full(size, np.nan)]), H, errors)
        got = found.mean[1], found.covariance[1]
    deviations = np.sqrt(np.diagonal(belief.covariance))
    np.testing.assert_allclose(got[0] / deviations, expected[0] / deviations, atol=1e-6)
    np.testing.assert_allclose(
        got[1] / np.outer(deviations, deviations), expected[1] / np.outer(deviations, deviations), atol=1e-8
    )


@pytest.mark.parametrize("order", [1, 2])
@pytest.mark.parametrize("sensor", ["polar", "spherical", "polar_doppler", "spherical_doppler"])
@given(powers=st.tuples(*[st.floats(-3, 0)] * 4), sign=st.sampled_from([-1.0, 1.0]), single=st.booleans())
@share(0.3)
def test_fully_correlated_errors_of_a_simulated_radar_are_taken_by_a_filter(
    sensor: Any, order: Any, powers: tuple[float, ...], sign: float, *, single: bool
):
    """Which of the two the last rounding makes of them, more or less than one error, is no difference."""
    names = [f"{name}_std" for name in ("range", "azimuth", "elevation", "range_rate")]
    size = {"polar": 2, "spherical": 3, "polar_doppler": 4, "spherical_doppler": 6}[sensor]
    chosen = [0, 1, *([2] if "spherical" in sensor else []), *([3] if "doppler" in sensor else [])]
    noise = {names[place]: 10.0 ** powers[place] for place in chosen}
    found = []
    for correlation in (sign, sign * (1 - 1e-13)):
        radar = simulate.Radar(sensor, 1.0, {**noise, "correlation": correlation})
        R = radar.noise_covariance().astype(np.float32 if single else np.float64)
        mean = np.array([3e3, 4e3, 500.0, 20.0, -10.0, 5.0], R.dtype)
        mean = mean[[0, 1, 3, 4]] if sensor == "polar_doppler" else mean[:size]
        belief = Belief(mean, np.eye(size, dtype=R.dtype) * 100)
        seen = cast("Any", getattr(observe, sensor))(mean).measurement + R.sum(axis=1) / np.sqrt(np.diagonal(R))
        updated = kalman.update_with(sensor, belief, seen, R, order)
        rest = Motion(np.eye(size), np.zeros((size, size)))  # in double precision, as all motions by name are
        track = kalman.run_with(sensor, belief, rest, seen[np.newaxis], R, order)
        np.testing.assert_allclose(track.covariance[0], updated.covariance, atol=2e-2 if single else 1e-3)
        found.append(updated)
    np.testing.assert_allclose(found[0].mean, found[1].mean, atol=1e-3)
    np.testing.assert_allclose(found[0].covariance, found[1].covariance, atol=1e-2)


@given(size=st.integers(2, 4), seed=st.integers(0, 10**6))
@share(0.5)
def test_a_noise_that_is_asymmetric_by_rounding_counts_by_its_upper_triangle(size: int, seed: int):
    """As a covariance does, that of what is believed or of what moves."""
    _, noise = of_rank(size, size, 2, seed)
    lower = np.where(np.tril(np.ones((size, size)), -1), noise * (1 + 1e-15), noise)
    H, measured = np.eye(size, 4), np.random.default_rng(seed).standard_normal((3, size))
    belief = Belief(np.zeros(4), np.eye(4))
    for errors in (lower, np.broadcast_to(lower, (3, size, size)), np.stack([lower] * 3)):
        got, expected = (kalman.update(belief, measured, H, each) for each in (errors, noise))
        np.testing.assert_array_equal(got.mean, expected.mean)
        np.testing.assert_array_equal(got.covariance, expected.covariance)


@pytest.mark.parametrize(
    ("noise", "message"),
    [
        ([[1.0, 2.0], [2.0, 1.0]], "noise must be positive semidefinite"),
        ([[1.0, 0.5], [0.2, 1.0]], "noise must be symmetric"),
        ([[1.0, 0.0], [0.0, -1.0]], "noise must be without a negative variance"),
        ([[1.0, 0.0], [0.0, 0.0]], "noise must have variances of more than 0"),
        ([[0.0, 0.0], [0.0, 0.0]], "noise must have variances of more than 0"),
    ],
)
@pytest.mark.parametrize("leading", [(), (5,)])
def test_what_is_no_noise_is_refused_in_each_filter(noise: Any, message: str, leading: tuple[int, ...]):
    errors = np.tile(np.eye(2), (*leading, 1, 1))
    errors[(3,) * len(leading)] = noise
    belief, moves, values = Belief(np.ones(2), np.eye(2)), Motion(np.eye(2), np.eye(2)), np.ones((5, 2))
    calls: list[Callable[[], Belief]] = [
        lambda: kalman.update(belief, values, np.eye(2), errors),
        lambda: kalman.update_with("polar", belief, values, errors),
        lambda: kalman.run(belief, moves, values, np.eye(2), errors),
        lambda: kalman.run_with("polar", belief, moves, values, errors),
    ]
    for call in calls:
        with pytest.raises(ValueError, match=message):
            call()
