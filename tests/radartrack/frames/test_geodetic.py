"""Geodetic coordinates against fifty digits, against pymap3d, and against the definition of the nearest point."""

import math
from collections.abc import Callable

import numpy as np
import pymap3d
import pytest
from hypothesis import given
from hypothesis import strategies as st

from radartrack import frames
from tests.examples import share
from tests.radartrack.frames.meridians import A, B, error, jacobian, mp, position

NANOMETRE = 1e-9
LATITUDES = st.floats(-math.pi / 2, math.pi / 2)
LONGITUDES = st.floats(-math.pi, math.pi)
AROUND = np.random.default_rng(1).standard_normal((300, 3))
COVARIANCE = np.array([[9.0, 2.0, -1.0], [2.0, 16.0, 3.0], [-1.0, 3.0, 25.0]]) * 1e2


def on_sphere(radius: float) -> np.ndarray:
    return radius * AROUND / np.linalg.norm(AROUND, axis=-1, keepdims=True)


@given(latitude=LATITUDES, longitude=LONGITUDES, height=st.floats(-6.4e6, 2e6))
@share(2.0)
def test_a_position_is_right_to_a_nanometre(latitude: float, longitude: float, height: float):
    found = frames.ecef_from_geodetic(latitude, longitude, height)
    assert error(found, position(latitude, longitude, height)) <= NANOMETRE


@given(latitude=LATITUDES, longitude=st.floats(-1e6, 1e6), height=st.floats(-1e9, 1e9))
@share(2.0)
def test_a_position_is_right_but_for_the_last_rounding(latitude: float, longitude: float, height: float):
    found = frames.ecef_from_geodetic(latitude, longitude, height)
    rounding = np.linalg.norm(np.spacing(found)) / 2
    assert error(found, position(latitude, longitude, height)) <= rounding + 3e-17 * max(abs(height), 6.4e6)


@pytest.mark.parametrize("radius", [1e-3, 1.0, 2e4, 42.7e3, 1e5, 3e6, 6.36e6, 6.378e6, 7e6, 4.2e7, 1e9])
def test_geodetic_coordinates_lead_back_to_the_position_but_for_their_last_rounding(radius: float):
    points = on_sphere(radius)
    found = frames.geodetic_from_ecef(points)
    to_normal = np.maximum(radius, 6.4e6)  # nowhere are turns about less than the radius of curvature
    for point, latitude, longitude, height in zip(points, *found, strict=True):
        turns = math.hypot(math.ulp(latitude), math.ulp(longitude) * math.cos(latitude)) / 2 * to_normal
        allowed = math.hypot(turns, math.ulp(height) / 2) + 3e-17 * to_normal
        assert error(point, position(latitude, longitude, height)) <= allowed


@pytest.mark.parametrize("radius", [1e5, 6.36e6, 6.378e6, 7e6])
def test_heights_are_right_to_their_last_digits(radius: float):
    """Seen from another centre of the same normal, a height is a distance: that of the position from its foot."""
    points = on_sphere(radius)
    for point, latitude, longitude, height in zip(points, *frames.geodetic_from_ecef(points), strict=True):
        foot = position(latitude, longitude, 0)
        along = position(latitude, longitude, 1)
        normal = [a - b for a, b in zip(along, foot, strict=True)]
        expected = mp.fdot(normal, [mp.mpf(float(c)) - f for c, f in zip(point, foot, strict=True)])
        assert abs(expected - mp.mpf(float(height))) <= 1e-12 + 0.6 * math.ulp(height)


@pytest.mark.parametrize("radius", [1.0, 3e4, 42.5e3, 42.8e3, 1e6, 8e6])
def test_no_point_of_the_ellipsoid_is_nearer(radius: float):
    points = on_sphere(radius)
    height = frames.geodetic_from_ecef(points).height
    parametric = np.linspace(0.0, math.pi / 2, 5001)
    out, up = np.hypot(points[:, 0], points[:, 1]), np.abs(points[:, 2])
    distances = np.hypot(
        out[:, np.newaxis] - float(A) * np.cos(parametric), up[:, np.newaxis] - float(B) * np.sin(parametric)
    )
    least = distances.min(axis=-1)
    assert (np.abs(height) <= least * (1 + 1e-14)).all()
    assert (np.abs(height) >= least - 1.0).all()  # the ellipse is sampled each two kilometres


def test_agrees_with_pymap3d():
    points = on_sphere(6.38e6) + 1e4 * AROUND  # its latitude is off by metres where satellites fly
    found = frames.geodetic_from_ecef(points)
    latitude, longitude, height = pymap3d.ecef2geodetic(*points.T, deg=False)
    np.testing.assert_allclose(found.latitude, latitude, atol=1e-11)
    np.testing.assert_allclose(found.longitude, longitude, atol=1e-15)
    np.testing.assert_allclose(found.height, height, atol=1e-4)
    back = pymap3d.geodetic2ecef(*found, deg=False)
    np.testing.assert_allclose(points, np.stack(back, axis=-1), atol=5e-8)


@pytest.mark.parametrize(
    ("point", "latitude", "longitude", "height"),
    [
        ((0.0, 0.0, 0.0), 90.0, 0.0, -float(B)),
        ((0.0, 0.0, 7e6), 90.0, 0.0, 7e6 - float(B)),
        ((0.0, 0.0, -7e6), -90.0, 0.0, 7e6 - float(B)),
        ((0.0, 0.0, -1.0), -90.0, 0.0, 1.0 - float(B)),
        ((-0.0, -0.0, 7e6), 90.0, 0.0, 7e6 - float(B)),
        ((float(A), 0.0, 0.0), 0.0, 0.0, 0.0),
        ((-float(A), -0.0, -0.0), 0.0, 180.0, 0.0),
        ((0.0, 7e6, 0.0), 0.0, 90.0, 7e6 - float(A)),
        ((1e50, 0.0, 0.0), 0.0, 0.0, 1e50),
    ],
)
def test_axis_centre_and_equator(point: tuple[float, ...], latitude: float, longitude: float, height: float):
    found = frames.geodetic_from_ecef(point)
    assert np.rad2deg(found.latitude) == pytest.approx(latitude, abs=1e-14)
    assert np.rad2deg(found.longitude) == pytest.approx(longitude, abs=1e-14)
    assert found.height == pytest.approx(height, rel=1e-15, abs=3e-10)


@given(share_of_ring=st.floats(0.0, 1.0), above=st.sampled_from([0.0, 5e-324, 1e-300, 1e-30, 1e-9, 1.0]))
def test_in_the_disc_about_the_centre_the_nearest_point_is_northern(share_of_ring: float, above: float):
    radius = share_of_ring * float((A**2 - B**2) / A)
    found = frames.geodetic_from_ecef([0.0, radius, above])
    assert found.latitude >= 0
    assert error(np.array([0.0, radius, above]), position(*found)) <= 2 * NANOMETRE


@given(latitude=st.floats(-1.5, 1.5), longitude=LONGITUDES, height=st.floats(-1e6, 4e7))
@share(0.3)
def test_jacobians_are_differences_and_inverses_of_each_other(latitude: float, longitude: float, height: float):
    there = frames.ecef_jacobian(latitude, longitude, height)
    np.testing.assert_allclose(there, jacobian(latitude, longitude, height), rtol=1e-13, atol=1e-8)
    back = frames.geodetic_jacobian(latitude, longitude, height)
    scale = np.array([1e7, 1e7, 1.0])
    np.testing.assert_allclose(scale[:, np.newaxis] * (back @ there) / scale, np.eye(3), atol=1e-13)


def test_a_covariance_follows_to_first_order_and_back():
    point = np.array([4e6, 1.5e6, 4.8e6])
    found = frames.geodetic_from_ecef(point, COVARIANCE)
    J = jacobian(float(found.latitude), float(found.longitude), float(found.height))
    expected = np.linalg.inv(J) @ COVARIANCE @ np.linalg.inv(J).T
    np.testing.assert_allclose(found.covariance, expected, rtol=1e-10)
    back = frames.ecef_from_geodetic(*found)
    np.testing.assert_allclose(back.mean, point, rtol=1e-15)
    np.testing.assert_allclose(back.covariance, COVARIANCE, rtol=1e-12)
    assert (back.covariance == back.covariance.T).all()


def test_the_spread_of_scattered_positions_is_what_the_covariance_says():
    generator = np.random.default_rng(5)
    point = np.array([-3e6, 4e6, -3.9e6])
    scattered = frames.geodetic_from_ecef(
        point + generator.multivariate_normal(np.zeros(3), COVARIANCE, 20_000, method="cholesky")
    )
    told = frames.geodetic_from_ecef(point, COVARIANCE)
    spread = np.cov(np.stack(scattered))
    scale = np.sqrt(np.diagonal(told.covariance))
    np.testing.assert_allclose(spread / np.outer(scale, scale), told.covariance / np.outer(scale, scale), atol=0.05)


def test_another_ellipsoid_and_a_sphere():
    krassovsky = frames.Ellipsoid(6_378_245.0, 1 / 298.3)
    other = pymap3d.Ellipsoid(6_378_245.0, 6_378_245.0 * (1 - 1 / 298.3))
    found = frames.ecef_from_geodetic(0.9, 0.5, 1e4, ellipsoid=krassovsky)
    np.testing.assert_allclose(found, pymap3d.geodetic2ecef(0.9, 0.5, 1e4, ell=other, deg=False), atol=1e-8)
    np.testing.assert_allclose(frames.geodetic_from_ecef(found, ellipsoid=krassovsky), (0.9, 0.5, 1e4), rtol=1e-13)
    ball = frames.Ellipsoid(2.0, 0.0)
    np.testing.assert_allclose(frames.geodetic_from_ecef([3.0, 0.0, 4.0], ellipsoid=ball), (math.atan2(4, 3), 0, 3))


@pytest.mark.parametrize("flattening", [0.0, 0.1, 0.5])
@pytest.mark.parametrize("radius", [1e-6, 0.3, 0.75, 1.0, 40.0])
def test_geodetic_coordinates_lead_back_on_any_ellipsoid(flattening: float, radius: float):
    ellipsoid = frames.Ellipsoid(1.0, flattening)
    points = np.concatenate([on_sphere(radius), radius * np.eye(3), [[radius, 0.0, 1e-200]]])
    found = frames.geodetic_from_ecef(points, ellipsoid=ellipsoid)
    np.testing.assert_allclose(
        frames.ecef_from_geodetic(*found, ellipsoid=ellipsoid), points, atol=1e-15 + 1e-15 * radius
    )


def test_arguments_broadcast_and_blocks_change_nothing():
    latitude, height = np.array([[0.1], [-0.4]]), np.array([0.0, 1e3, 2e4])
    found = frames.ecef_from_geodetic(latitude, 0.3, height)
    assert found.shape == (2, 3, 3)
    back = frames.geodetic_from_ecef(found)
    assert back.height.shape == (2, 3)
    np.testing.assert_allclose(back.height, np.broadcast_to(height, (2, 3)), atol=1e-8)
    many = np.tile(found.reshape(-1, 3), (20_000, 1))
    np.testing.assert_array_equal(frames.geodetic_from_ecef(many).height.reshape(-1, 2, 3)[-1], back.height)
    assert frames.ecef_from_geodetic(np.zeros((0,)), 0.0).shape == (0, 3)
    assert frames.geodetic_from_ecef(np.zeros((0, 3))).latitude.shape == (0,)


def test_float32_stays_float32_and_is_computed_in_double():
    points = on_sphere(6.4e6).astype(np.float32)
    found = frames.geodetic_from_ecef(points)
    assert {part.dtype for part in found} == {np.dtype(np.float32)}
    exact = frames.geodetic_from_ecef(points.astype(np.float64))
    np.testing.assert_allclose(found.height, exact.height, rtol=1e-7)
    pole = frames.ecef_from_geodetic(np.float32(np.pi / 2), np.float32(0.0), np.float32(0.0))
    assert pole.dtype == np.float32
    assert abs(pole[0]) < 1e-6


@pytest.mark.parametrize(
    ("call", "said"),
    [
        (lambda: frames.ecef_from_geodetic(1.6, 0.0), "latitude must be from -1.570796 to 1.570796 rad"),
        (lambda: frames.ecef_from_geodetic([0.1, math.nan], 0.0), "latitude must be finite"),
        (lambda: frames.ecef_from_geodetic(0.0, 0.0, 1e101), "height must be from -1e"),
        (lambda: frames.ecef_from_geodetic([0.0, 1.0], [0.0, 1.0, 2.0]), "the shapes must broadcast"),
        (lambda: frames.geodetic_from_ecef([1.0, 2.0]), r"position must have shape \(..., 3\)"),
        (lambda: frames.geodetic_from_ecef([1.0, 2.0, math.inf]), "position must be finite"),
        (lambda: frames.geodetic_from_ecef([7e6, 0.0, 0.0], np.eye(2)), r"covariance must have shape \(..., 3, 3\)"),
        (lambda: frames.geodetic_from_ecef([7e6, 0.0, 0.0], -np.eye(3)), "covariance must be without a negative"),
        (lambda: frames.geodetic_from_ecef([0.5, 0.0, 7e6], np.eye(3)), "distance from the axis must be from 1 to"),
        (lambda: frames.geodetic_from_ecef([1e4, 0.0, 0.0], np.eye(3)), "height must be from -1000000"),
        (lambda: frames.Ellipsoid(-1.0, 0.0), "semi_major_axis must be more than 0"),
        (lambda: frames.Ellipsoid(6e6, 298.257), "flattening must be from 0 to 0.5; got 298.257"),
    ],
)  # fmt: skip
def test_errors_name_the_argument_and_what_is_allowed(call: Callable[[], object], said: str):
    with pytest.raises(ValueError, match=said):
        call()


def test_text_is_no_latitude():
    with pytest.raises(TypeError, match="latitude must be real numbers"):
        frames.ecef_from_geodetic("55N", 0.0)


@pytest.mark.parametrize("variance", [1.1e200, 1e300, 1.7e308])
@pytest.mark.parametrize(
    "moved",
    [
        lambda covariance: frames.ecef_from_geodetic(0.5, 0.3, 100.0, covariance),
        lambda covariance: frames.geodetic_from_ecef([6e6, 1e6, 1e6], covariance),
        lambda covariance: frames.enu(0.5, 0.3).to(frames.ECEF, [1.0, 2.0, 3.0], covariance),
    ],
    ids=["to ECEF", "from ECEF", "between frames"],
)
def test_a_covariance_that_would_overflow_is_refused(moved: Callable[[np.ndarray], object], variance: float):
    with pytest.raises(ValueError, match=r"covariance must be from -1e\+200 to 1e\+200"):
        moved(variance * np.eye(3))
