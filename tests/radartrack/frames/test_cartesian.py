"""Frames of sites and radars against pymap3d, against lines of sight, and against flights that are differenced."""

import math
from collections.abc import Callable
from typing import Any

import numpy as np
import pymap3d
import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from radartrack import convert, frames, kalman, observe
from radartrack.generated import frames as formulas
from radartrack.kalman import Belief
from radartrack.testing import strategies
from tests.examples import share

SITE: dict[str, Any] = {"latitude": 0.81, "longitude": -2.1, "height": 1234.5}
ATTITUDE: dict[str, Any] = {"azimuth": 2.3, "tilt": 0.2, "roll": -0.4}
ANGLES = st.floats(-3.0, 3.0)
TILTS = st.floats(-1.5, 1.5)


def root(size: int) -> np.ndarray:
    return np.random.default_rng(size).standard_normal((size, size)) + 2 * np.eye(size)


def beside(distance: float, count: int = 50) -> np.ndarray:
    """Positions about the site, in the axes of the Earth."""
    offsets = distance * np.random.default_rng(7).standard_normal((count, 3))
    return np.array(pymap3d.geodetic2ecef(*SITE.values(), deg=False)) + offsets


def test_east_north_and_up_are_those_of_pymap3d():
    points = beside(5e4)
    expected = np.stack(pymap3d.ecef2enu(*points.T, *SITE.values(), deg=False), axis=-1)
    np.testing.assert_allclose(frames.enu(**SITE).from_ecef(points), expected, atol=5e-8)


def test_a_frame_is_the_generated_map():
    x, y, z = beside(3e5).T
    shape = {"semi_major_axis": frames.WGS84.semi_major_axis, "flattening": frames.WGS84.flattening}
    expected = formulas.enu_from_ecef_map(x=x, y=y, z=z, **SITE, **shape)
    np.testing.assert_allclose(frames.enu(**SITE).from_ecef(np.stack([x, y, z], axis=-1)), expected, atol=1e-8)


@given(azimuth=ANGLES, tilt=TILTS, roll=ANGLES)
@share(1.0)
def test_what_stands_where_the_radar_looks_is_straight_ahead(azimuth: float, tilt: float, roll: float):
    there = np.array(pymap3d.aer2ecef(azimuth, tilt, 3e4, *SITE.values(), deg=False))
    words: dict[str, Any] = {"azimuth": azimuth, "tilt": tilt, "roll": roll}
    np.testing.assert_allclose(frames.antenna(**SITE, **words).from_ecef(there), [0, 3e4, 0], atol=1e-7)
    np.testing.assert_allclose(frames.face(**SITE, **words).from_ecef(there), [0, 0, 3e4], atol=1e-7)


def test_a_level_antenna_measures_azimuth_and_elevation_as_pymap3d_does():
    points = beside(2e4)
    azimuth, elevation, r = pymap3d.ecef2aer(*points.T, *SITE.values(), deg=False)
    seen = observe.spherical(frames.antenna(**SITE).from_ecef(points)).measurement
    turned = observe.spherical(frames.antenna(**SITE, azimuth=0.5).from_ecef(points)).measurement
    np.testing.assert_allclose(seen[:, 0], r, atol=1e-7)
    np.testing.assert_allclose(np.mod(seen[:, 1], math.tau), azimuth, atol=1e-9)
    np.testing.assert_allclose(seen[:, 2], elevation, atol=1e-9)
    np.testing.assert_allclose(np.mod(turned[:, 1] + 0.5, math.tau), azimuth, atol=1e-9)


def test_tilt_looks_up_and_roll_turns_the_right_side_down():
    level, tilted = frames.antenna(**SITE), frames.antenna(**SITE, tilt=0.3)
    ahead = level.to(tilted, [0.0, 1e4, 0.0])
    assert ahead[2] == pytest.approx(-1e4 * math.sin(0.3))
    rolled = frames.antenna(**SITE, roll=0.3)
    assert rolled.to(level, [1e4, 0.0, 0.0])[2] == pytest.approx(-1e4 * math.sin(0.3))
    assert frames.face(**SITE, **ATTITUDE).axes == pytest.approx(
        np.array([[-1, 1, 1]]).T * frames.antenna(**SITE, **ATTITUDE).axes[[0, 2, 1]]
    )


def test_direction_cosines_of_a_face_are_converted_to_where_the_target_is():
    radar = frames.face(**SITE, **ATTITUDE)
    local = np.array([9e3, -4e3, 3e4])
    r = np.linalg.norm(local)
    plot = convert.ruv(r, local[0] / r, local[1] / r, range_std=0.0, u_std=0.0, v_std=0.0)
    there = radar.to_ecef(plot.mean)
    seen = pymap3d.ecef2aer(*there, *SITE.values(), deg=False)
    assert seen[2] == pytest.approx(r)
    assert (radar.axes[2] @ (there - radar.origin)) / r == pytest.approx(local[2] / r)


@given(turn=st.floats(0.0, 6.0), tilt=TILTS)
@share(0.5)
def test_between_radars_under_way_the_range_rate_is_that_of_the_range(turn: float, tilt: float):
    ship = frames.antenna(**SITE, azimuth=turn, tilt=tilt, roll=0.2, velocity=[8.0, -5.0, 1.0])
    state = np.concatenate([beside(2e4, 1)[0], [200.0, -150.0, 90.0]])
    seen = observe.spherical_doppler(ship.from_ecef(state)).measurement
    step = 1e-3
    ends = [state[:3] + s * state[3:] - (ship.origin + s * ship.velocity) for s in (-step, step)]
    rate = (np.linalg.norm(ends[1]) - np.linalg.norm(ends[0])) / (2 * step)
    assert seen[3] == pytest.approx(rate, abs=1e-4)
    east, north, up = frames.enu(**SITE).axes @ ship.velocity
    np.testing.assert_allclose([east, north, up], [8.0, -5.0, 1.0], atol=1e-12)


@pytest.mark.parametrize("size", [3, 6, 9])
def test_states_and_covariances_go_there_and_back(size: int):
    here = frames.antenna(**SITE, **ATTITUDE, velocity=[3.0, 4.0, 0.0])
    there = frames.face(0.83, -2.05, 80.0, azimuth=1.0, tilt=0.4)
    mean = np.concatenate([[1e4, 2e4, 3e3], [150.0, -90.0, 10.0], [3.0, 1.0, -2.0]])[:size]
    covariance = root(size) @ root(size).T
    moved = here.to(there, mean, covariance)
    assert isinstance(moved, Belief)
    J = here.jacobian(there, size)
    np.testing.assert_allclose(moved.covariance, J @ covariance @ J.T, rtol=1e-12)
    np.testing.assert_allclose(np.linalg.det(moved.covariance), np.linalg.det(covariance))
    differences = [(here.to(there, mean + 10.0 * e) - here.to(there, mean - 10.0 * e)) / 20.0 for e in np.eye(size)]
    np.testing.assert_allclose(J, np.array(differences).T, atol=1e-9)
    back = there.to(here, *moved)
    np.testing.assert_allclose(back.mean, mean, atol=1e-9)
    np.testing.assert_allclose(back.covariance, covariance, rtol=1e-12)
    np.testing.assert_allclose(there.from_ecef(here.to_ecef(mean)), moved.mean, atol=1e-8)
    by_points = here.to(there, mean)
    np.testing.assert_array_equal(by_points, moved.mean)


def test_a_short_way_from_site_to_site_keeps_its_digits():
    here, there = frames.enu(0.8, 0.3, 100.0), frames.enu(0.8, 0.3 + 1e-5, 90.0)
    point = np.array([1e-3, 2e-3, 3e-3])
    assert np.abs(there.to(here, here.to(there, point)) - point).max() < 1e-13


def test_at_a_pole_north_is_along_the_meridian_of_the_longitude():
    pole = frames.enu(math.pi / 2, 0.0)
    np.testing.assert_allclose(pole.axes, [[0, 1, 0], [-1, 0, 0], [0, 0, 1]], atol=1e-15)
    np.testing.assert_allclose(pole.from_ecef([0.0, 0.0, 6_356_752.314245179 + 5.0]), [0, 0, 5], atol=1e-8)


def test_a_site_for_each_point_and_all_sites_for_each():
    sites = frames.antenna([0.1, 0.2, 0.3], 0.5, 10.0, azimuth=[0.0, 1.0, 2.0])
    states = np.random.default_rng(2).normal(scale=1e4, size=(4, 3, 6))
    covariance = root(6) @ root(6).T
    moved = sites.to_ecef(states, covariance)
    assert moved.mean.shape == (4, 3, 6)
    one = frames.antenna(0.2, 0.5, 10.0, azimuth=1.0).to_ecef(states[2, 1], covariance)
    np.testing.assert_allclose(moved.mean[2, 1], one.mean, rtol=1e-14)
    np.testing.assert_allclose(moved.covariance[1], one.covariance, rtol=1e-10, atol=1e-10)
    assert sites.from_ecef(np.zeros((0, 3, 3))).shape == (0, 3, 3)


@pytest.mark.parametrize("size", [3, 6, 9])
@pytest.mark.parametrize("leading", [(), (1,), (4,), (2, 1)])
def test_frames_that_differ_in_their_velocities_alone_are_a_frame_each(size: int, leading: tuple[int, ...]):
    velocities = np.random.default_rng(3).normal(scale=9.0, size=(4, 3))
    mean = np.random.default_rng(4).normal(scale=1e3, size=(*leading, size))
    sites, other = frames.antenna(**SITE, **ATTITUDE, velocity=velocities), frames.enu(0.83, -2.05, 80.0)
    for moved, there in ((sites.to(other, mean), False), (other.to(sites, mean), True)):
        assert moved.shape == (*np.broadcast_shapes(leading, (4,)), size)
        for number, own in enumerate(np.broadcast_to(mean, moved.shape)[..., k, :] for k in range(4)):
            site = frames.antenna(**SITE, **ATTITUDE, velocity=velocities[number])
            alone = other.to(site, own) if there else site.to(other, own)
            np.testing.assert_allclose(moved[..., number, :], alone, rtol=1e-13, atol=1e-9)


@pytest.mark.parametrize(
    ("leading", "of_mean", "sites"),
    [
        ((), (), ()), ((5,), (), ()), ((1,), (), ()), ((0,), (), ()), ((3, 5), (), ()), ((3, 5), (5,), ()),
        ((3, 1), (5,), ()), ((3, 1), (1, 5), ()), ((5,), (), (5,)), ((3, 1), (), (5,)), ((3, 1), (5,), (5,)),
        ((), (), (5,)),
    ],
)  # fmt: skip
def test_one_mean_with_many_covariances_is_many_beliefs(
    leading: tuple[int, ...], of_mean: tuple[int, ...], sites: tuple[int, ...]
):
    """Which a filter takes as they are: each has a mean of its own."""
    mean, covariance = np.full((*of_mean, 3), 5e3), np.broadcast_to(np.eye(3), (*leading, 3, 3))
    here, there = frames.enu(np.full(sites, 0.5), 0.3), frames.enu(0.51, 0.3)
    tracks = np.broadcast_shapes(leading, of_mean, sites)
    fixed = here.to_ecef(mean, covariance)
    places = [np.full(of_mean, part) for part in (0.5, 0.3, 10.0)]
    for found in (here.to(there, mean, covariance), fixed, here.from_ecef(*fixed)):
        assert found.mean.shape == (*tracks, 3)
        assert kalman.update(found, [0.0], [[1.0, 0.0, 0.0]], [[1.0]]).mean.shape == (*tracks, 3)
    assert {part.shape for part in frames.geodetic_from_ecef(*fixed)[:3]} == {tracks}
    found = frames.ecef_from_geodetic(places[0], places[1], places[2], covariance)
    assert found.mean.shape == (*np.broadcast_shapes(leading, of_mean), 3)


@given(latitude=TILTS, azimuth=ANGLES, tilt=TILTS, seed=st.integers(0, 10**6), rank=st.integers(0, 6))
@example(latitude=1e-213, azimuth=1e-213, tilt=1e-213, seed=1, rank=1)  # a variance underflows, its covariances do not
@share(0.5)
def test_what_a_frame_returns_of_a_covariance_of_any_rank_is_taken_by_what_comes_next(
    latitude: float, azimuth: float, tilt: float, seed: int, rank: int
):
    """Such as of a target in the plane, whose height is known: turned away and back, no variance may be negative."""
    root = np.random.default_rng(seed).standard_normal((2, 6, 6))
    root[0], root[1, :, rank:] = np.diag(np.arange(6) < rank), 0
    here, there = frames.enu(**SITE), frames.antenna(latitude, 1.0, azimuth=azimuth, tilt=tilt)
    moves = kalman.Motion(np.eye(6), np.zeros((6, 6)))
    belief = Belief(np.zeros((2, 6)), 1e6 * root @ np.swapaxes(root, -1, -2))
    for _ in range(2):
        belief = kalman.predict(there.to(here, *here.to(there, *belief)), moves)
    np.testing.assert_allclose(belief.covariance, 1e6 * root @ np.swapaxes(root, -1, -2), atol=1e-7)
    point = here.to_ecef(np.zeros((2, 3)), belief.covariance[:, :3, :3])
    back = frames.ecef_from_geodetic(*frames.geodetic_from_ecef(*point))
    np.testing.assert_allclose(back.covariance, point.covariance, atol=1e-6)


def test_in_single_precision_too_a_variance_that_underflows_takes_its_covariances_with_it():
    one, other = frames.antenna(0.0, 0.0, azimuth=1e-26), frames.antenna(0.0, 0.0)
    along = np.diag([1e6, 0.0, 0.0]).astype(np.float32)
    for _ in range(2):
        found = one.to(other, np.zeros(3, np.float32), along)
        assert found.covariance.dtype == np.float32
        np.testing.assert_array_equal(other.to(one, *found).covariance, along)
        along = np.diag([0.0, 1e6, 0.0]).astype(np.float32)


@given(believed=strategies.covariances(6), azimuth=ANGLES)
@share(0.3)
def test_covariances_on_any_scales_are_turned_to_covariances(believed: np.ndarray, azimuth: float):
    moved = frames.enu(**SITE).to(frames.antenna(**SITE, azimuth=azimuth, tilt=0.1), np.zeros(6), 1e100 * believed)
    for block in (slice(0, 3), slice(3, 6)):
        trace = np.trace(believed[block, block])
        np.testing.assert_allclose(np.trace(moved.covariance[block, block]), 1e100 * trace, rtol=1e-12)
    assert (np.diagonal(moved.covariance) >= 0).all()


def test_float32_stays_float32():
    radar = frames.enu(**SITE)
    points = np.array([[1e4, 2e4, 3e3]], np.float32)
    assert radar.to(frames.antenna(**SITE, azimuth=1.0), points).dtype == np.float32
    assert radar.to_ecef(points, np.eye(3)).covariance.dtype == np.float64


@pytest.mark.parametrize("sign", [-1.0, 1.0])
@pytest.mark.parametrize("of_others", [float, np.float32, np.float64])
def test_a_right_angle_in_single_precision_is_none_beyond_the_pole(sign: float, of_others: Any):
    """Where half of pi is rounded up."""
    pole, others = np.float32(sign * np.pi / 2), [of_others(value) for value in (0.25, 64.0)]
    exact = [sign * np.pi / 2, 0.25, 64.0]
    np.testing.assert_allclose(frames.enu(pole, *others).origin, frames.enu(*exact).origin, atol=1e-6)
    np.testing.assert_allclose(
        frames.antenna(*exact, tilt=pole).axes, frames.antenna(*exact, tilt=exact[0]).axes, atol=1e-7
    )
    found = frames.ecef_from_geodetic(np.full(2, pole), *(np.full(2, value) for value in others))
    np.testing.assert_allclose(found, [frames.ecef_from_geodetic(*exact)] * 2, rtol=1e-7, atol=1e-6)
    assert frames.ecef_jacobian(pole, *others).shape == (3, 3)


@pytest.mark.parametrize(
    ("call", "said"),
    [
        (lambda: frames.enu(2.0, 0.0), "latitude must be from"),
        (lambda: frames.antenna(0.0, 0.0, tilt=2.0), "tilt must be from -1.570796 to 1.570796 rad"),
        (lambda: frames.antenna(0.0, 0.0, azimuth=[1.0, 2.0], roll=[1.0, 2.0, 3.0]), "the shapes must broadcast"),
        (lambda: frames.antenna([0.0, 1.0], 0.0, azimuth=[1.0, 2.0, 3.0]), "azimuth"),
        (lambda: frames.enu(0.0, 0.0, velocity=[1.0, 2.0]), r"velocity must have shape \(..., 3\)"),
        (lambda: frames.enu(0.0, 0.0).from_ecef(np.zeros(4)), "mean must have 3, 6 or 9 components"),
        (lambda: frames.enu(0.0, 0.0).from_ecef(5.0), r"mean must have 3, 6 or 9 .* got shape \(\)"),
        (lambda: frames.enu(0.0, 0.0).to_ecef(np.zeros(6), np.eye(3)), r"covariance must have shape \(..., 6, 6\)"),
        (lambda: frames.enu(0.0, 0.0).to_ecef([1.0, math.nan, 0.0]), "positions of mean must be finite"),
        (lambda: frames.enu([0.0, 1.0], 0.0).to_ecef(np.zeros((3, 3))), r"the shapes must broadcast; got mean \(3,\)"),
        (lambda: frames.ECEF.jacobian(frames.ECEF, 4), r"components must be one of \[3, 6, 9\]; got 4"),
        (lambda: frames.Frame(np.zeros(3), np.ones((3, 3))), "axes must have length one and stand on each other"),
        (lambda: frames.Frame(np.zeros(2), np.eye(3)), r"origin must have shape \(..., 3\)"),
    ],
)  # fmt: skip
def test_errors_name_the_argument_and_what_is_allowed(call: Callable[[], object], said: str):
    with pytest.raises(ValueError, match=said):
        call()


def test_a_frame_stays_as_it_is_whatever_becomes_of_the_arrays_that_made_it():
    parts = np.zeros(3), np.eye(3), np.ones(3)
    frame = frames.Frame(*parts)
    for part, own in zip(parts, (frame.origin, frame.axes, frame.velocity), strict=True):
        before = own.copy()
        part[...] = 7.0
        np.testing.assert_array_equal(own, before)
        with pytest.raises(ValueError, match="read-only"):
            own[...] = 7.0
