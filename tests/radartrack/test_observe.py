"""Observation of Cartesian states: inverse of the conversions, derivatives, projections, and where they end."""

import math
from typing import Any

import mpmath
import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from radartrack import convert, observe
from radartrack._observation.sights import SIGHTS
from radartrack.derive.catalogue import find
from radartrack.observe import Observed, Projected
from radartrack.testing import strategies
from tests.examples import share
from tests.radartrack.plots import SENSORS, WITH_AZIMUTH, Floats, assert_agree, cartesian

POSITIONS = {"polar": 2, "spherical": 3, "polar_doppler": 2, "spherical_doppler": 3, "ruv": 3}
SIZES = {"polar": 2, "spherical": 3, "polar_doppler": 4, "spherical_doppler": 6, "ruv": 3}
POSITIONS |= {"bearing": 2, "bistatic": 2, "bistatic_range_rate": 2, "range_difference": 3, "range_rate_difference": 3}
SIZES |= {"bearing": 2, "bistatic": 2, "bistatic_range_rate": 4, "range_difference": 3, "range_rate_difference": 6}
BASELINE, RECEIVER = 7e3, [3e3, -4e3, 50.0]
SITES: dict[str, Any] = {"bistatic": {"baseline": BASELINE}, "bistatic_range_rate": {"baseline": BASELINE}}
SITES |= {"range_difference": {"receiver": RECEIVER}, "range_rate_difference": {"receiver": RECEIVER}}
OF_ONE_SITE = (*SENSORS, "bearing")
ALL = (*OF_ONE_SITE, *SITES)

KNOWN = {"baseline": BASELINE} | dict(zip(("receiver_x", "receiver_y", "receiver_z"), RECEIVER, strict=True))


def states(sensor: str) -> st.SearchStrategy[Floats]:
    """Of targets on any side, in the planes of the axes too."""
    name = f"observe.{sensor}.map"
    ends = {**dict.fromkeys("xyz", 1e5), **dict.fromkeys(("vx", "vy", "vz"), 300.0)}
    within = {s.name: (-ends[s.name], ends[s.name]) for s in find(name).symbols if s.name in ends}
    within |= {s.name: (KNOWN[s.name], KNOWN[s.name]) for s in find(name).symbols if s.name in KNOWN}
    drawn = strategies.arguments(name, within=within)
    return drawn.map(lambda state: clear(sensor, np.array(list(state.values())[: SIZES[sensor]])))


def clear(sensor: str, state: Floats) -> Floats:
    """Away from the radar, where all derivatives grow, and off the edge of the unit circle."""
    state[: POSITIONS[sensor]] += np.where(np.hypot(*state[:2]) < 100, 100.0, 0.0)
    if sensor == "ruv":
        state[2] = abs(state[2]) + np.hypot(*state[:2]) / 10
    return state


def project(sensor: Any, mean: Any, covariance: Any, *words: Any, **chosen: Any) -> Projected:
    return observe.project(sensor, mean, covariance, *words, **chosen)


def observed(sensor: str, state: Any, **convention: str) -> Observed:
    site = {name: np.asarray(place, np.asarray(state).dtype) for name, place in SITES.get(sensor, {}).items()}
    found: Observed = getattr(observe, sensor)(state, **site, **convention)
    return found


def measured_by_mpmath(sensor: str, *state: Any) -> list[Any]:
    """Range, angles, rates and cosines from their definitions, in 50 digits."""
    x, y, *rest = state
    if sensor in SITES:
        return [measured_at_two_sites(sensor, state)] if sensor != "bistatic" else measured_by_bistatic_radar(x, y)
    if sensor == "bearing":
        return [mpmath.atan2(y, x)]
    if sensor == "spherical_doppler":
        z, *velocity = rest
        r, beta, epsilon = measured_by_mpmath("spherical", x, y, z)
        return [r, beta, epsilon, sum(a * b for a, b in zip((x, y, z), velocity, strict=True)) / r]
    if sensor == "polar":
        return [mpmath.hypot(x, y), mpmath.atan2(y, x)]
    if sensor == "polar_doppler":
        vx, vy = rest
        return [mpmath.hypot(x, y), mpmath.atan2(y, x), (x * vx + y * vy) / mpmath.hypot(x, y)]
    r = mpmath.sqrt(x * x + y * y + rest[0] * rest[0])
    if sensor == "ruv":
        return [r, x / r, y / r]
    return [r, mpmath.atan2(x, y), mpmath.asin(rest[0] / r)]


def measured_by_bistatic_radar(x: Any, y: Any) -> list[Any]:
    return [mpmath.hypot(x, y) + mpmath.hypot(x - BASELINE, y), mpmath.atan2(y, x)]


def measured_at_two_sites(sensor: str, state: tuple[Any, ...]) -> Any:
    """Rates are those of lengths, by the chain rule along the flight."""
    size = POSITIONS[sensor]
    position, velocity = state[:size], state[size:]
    there = [a - b for a, b in zip(position, RECEIVER if size == 3 else [BASELINE, 0.0], strict=True)]
    sign = 1 if sensor.startswith("bistatic") else -1
    near, far = (mpmath.sqrt(sum(a * a for a in offset)) for offset in (position, there))
    if not velocity:
        return far + sign * near
    rates = [
        sum(a * v for a, v in zip(offset, velocity, strict=True)) / length
        for offset, length in ((position, near), (there, far))
    ]
    return rates[1] + sign * rates[0]


def derivative(sensor: str, state: Floats, orders: tuple[int, ...], output: int) -> float:
    with mpmath.workdps(50):
        point = [mpmath.mpf(float(value)) for value in state]
        return float(mpmath.diff(lambda *s: measured_by_mpmath(sensor, *s)[output], point, orders))


@pytest.mark.parametrize("sensor", ALL)
@given(data=st.data())
@share(0.1)
def test_measurement_jacobian_and_hessian_are_those_of_the_definition_differentiated_numerically(
    sensor: str, data: st.DataObject
) -> None:
    state = data.draw(states(sensor))
    assume(np.abs(state[:2]).min() > 1e-6)  # differences do not step over the half line at which an azimuth jumps
    got = observed(sensor, state)
    distance = np.hypot(*state[:2])
    unit = np.where(np.arange(SIZES[sensor]) < POSITIONS[sensor], distance, 300.0)
    with mpmath.workdps(50):
        measured = measured_by_mpmath(sensor, *map(mpmath.mpf, state.tolist()))
    for output, value in enumerate(measured):
        scale = {"r": distance, "rdot": 300.0}.get("r" if output == 0 else "", 1.0)
        if sensor == "bearing":
            scale = 1.0
        if "rate" in sensor or (sensor.endswith("doppler") and output == len(got.measurement) - 1):
            scale = 300.0
        if sensor in SITES:  # the term of each site is to rounding what it is
            scale *= 10 * max(1.0, 1e4 / distance_from_the_other_site(sensor, state))
        assert abs(got.measurement[output] - float(value)) <= 1e-14 * max(scale, float(abs(value)))
        for i in range(SIZES[sensor]):
            first = tuple(int(k == i) for k in range(SIZES[sensor]))
            expected = derivative(sensor, state, first, output)
            assert abs(got.jacobian[output, i] - expected) * unit[i] <= 1e-13 * scale
            for j in range(SIZES[sensor]):
                second = tuple(int(k == i) + int(k == j) for k in range(SIZES[sensor]))
                expected = derivative(sensor, state, second, output)
                assert abs(got.hessian[output, i, j] - expected) * unit[i] * unit[j] <= 1e-12 * scale


def distance_from_the_other_site(sensor: str, state: Floats) -> float:
    size = POSITIONS[sensor]
    return float(np.linalg.norm(state[:size] - (RECEIVER if size == 3 else [BASELINE, 0.0])))


@pytest.mark.parametrize("azimuth_from", ["x", "y"])
@pytest.mark.parametrize("sensor", SENSORS)
@given(data=st.data())
@share(0.5)
def test_observation_undoes_conversion(sensor: str, azimuth_from: str, data: st.DataObject) -> None:
    state = data.draw(states(sensor))
    convention = {"azimuth_from": azimuth_from} if sensor in WITH_AZIMUTH else {}
    got = observed(sensor, state, **convention).measurement
    function: Any = getattr(convert, sensor)
    back = function(*got, *[0.0] * len(got), method="linear", **convention).mean
    size = POSITIONS[sensor]
    assert_agree(back[:size], state[:size], np.linalg.norm(state[:size]), 1e-13)
    if sensor.endswith("doppler"):
        radial = state[:size] @ state[size:]
        speed = math.hypot(*state[size:])  # of velocities whose squares vanish, too
        assert abs(back[-1] - radial) <= 1e-13 * np.linalg.norm(state[:size]) * max(speed, 1e-300)


@pytest.mark.parametrize("sensor", WITH_AZIMUTH)
@given(data=st.data())
def test_the_other_azimuth_is_the_complement_and_its_derivatives_those_of_the_complement(
    sensor: str, data: st.DataObject
) -> None:
    state = data.draw(states(sensor))
    from_x, from_y = (observed(sensor, state, azimuth_from=axis) for axis in ("x", "y"))
    both = from_x.measurement[1] + from_y.measurement[1]
    assert math.remainder(both - math.pi / 2, 2 * math.pi) == pytest.approx(0, abs=1e-14)
    signs = np.array([1, -1, 1, 1])[: len(from_x.measurement)]
    scale = np.abs(from_x.jacobian).max(axis=1, keepdims=True)
    assert (np.abs(from_y.jacobian - signs[:, np.newaxis] * from_x.jacobian) <= 1e-13 * scale).all()
    scale = np.abs(from_x.hessian).max(axis=(1, 2), keepdims=True)
    turned = signs[:, np.newaxis, np.newaxis] * from_x.hessian
    assert (np.abs(from_y.hessian - turned) <= 1e-12 * scale).all()


# The ends.


@pytest.mark.parametrize("sensor", OF_ONE_SITE)
@pytest.mark.parametrize("zero", [0.0, -0.0])
def test_at_the_radar_the_measurement_and_all_its_derivatives_are_zero(sensor: str, zero: float) -> None:
    state = np.full(SIZES[sensor], zero)
    state[POSITIONS[sensor] :] = 100.0
    for part in observed(sensor, state):
        assert (part == 0).all()


@pytest.mark.parametrize("sign", [-1, 1])
def test_on_the_vertical_axis_the_range_has_its_derivatives_and_the_angles_have_none(sign: int) -> None:
    measurement, jacobian, hessian = observe.spherical([0.0, 0.0, 500.0 * sign])
    assert measurement.tolist() == [500.0, 0.0, sign * math.pi / 2]
    np.testing.assert_array_equal(jacobian, [[0, 0, sign], [0, 0, 0], [0, 0, 0]])
    np.testing.assert_array_equal(hessian[0], np.diag([1 / 500, 1 / 500, 0]))
    assert (hessian[1:] == 0).all()


def test_direction_cosines_have_their_derivatives_on_the_normal_of_the_array() -> None:
    measurement, jacobian, _ = observe.ruv([0.0, 0.0, 500.0])
    assert measurement.tolist() == [500.0, 0.0, 0.0]
    np.testing.assert_array_equal(jacobian, [[0, 0, 1], [1 / 500, 0, 0], [0, 1 / 500, 0]])


@pytest.mark.parametrize("dtype", [np.float64, np.float32])
@pytest.mark.parametrize("sensor", ALL)
@given(data=st.data())
@share(0.5)
def test_what_is_allowed_never_gives_infinity_or_nan(
    sensor: str, dtype: type[np.floating[Any]], data: st.DataObject
) -> None:
    single = dtype is np.float32
    largest, fastest = (1e15, 1e8) if single else (1e150, 1e50)
    tiny = [1e-45, 1e-30, 1e-13, 1e-12] if single else [5e-324, 1e-150, 1e-101, 1e-100]
    sizes = st.sampled_from([0.0, *tiny, 1e-5, 1.0, 1e5, largest])
    signs = st.sampled_from([-1, 1])
    state = [data.draw(sizes) * data.draw(signs) for _ in range(POSITIONS[sensor])]
    if sensor in SITES and data.draw(st.booleans()):  # about the other site
        site = RECEIVER if POSITIONS[sensor] == 3 else [BASELINE, 0.0]
        state = [a + b for a, b in zip(state, site, strict=True)] if max(map(abs, state)) < largest else state
    state += [data.draw(st.sampled_from([0.0, 1.0, fastest])) for _ in range(SIZES[sensor] - len(state))]
    got = observed(sensor, np.array(state, dtype))
    assert all(np.isfinite(part).all() for part in got)
    assert {part.dtype for part in got} == {np.dtype(dtype)}


@pytest.mark.parametrize("scale", [1e-90, 1e-20, 1e20, 1e149])
@pytest.mark.parametrize("sensor", ["polar", "spherical", "ruv"])
def test_derivatives_scale_with_distance_however_near_or_far(sensor: str, scale: float) -> None:
    state = np.array([0.3, -0.8, 0.5])[: SIZES[sensor]]
    near, far = observed(sensor, state), observed(sensor, state * scale)
    angles = slice(1, None)
    np.testing.assert_allclose(far.measurement[angles], near.measurement[angles], rtol=1e-14)
    np.testing.assert_allclose(far.measurement[0], near.measurement[0] * scale, rtol=1e-14)
    np.testing.assert_allclose(far.jacobian[angles] * scale, near.jacobian[angles], rtol=1e-13, atol=1e-14)
    np.testing.assert_allclose(far.hessian[0] * scale, near.hessian[0], rtol=1e-13, atol=1e-14)
    curved = far.hessian[angles] * scale * scale if scale < 1e100 else near.hessian[angles]
    np.testing.assert_allclose(curved, near.hessian[angles], rtol=1e-12, atol=1e-13)


def test_the_range_of_the_nearest_positions_is_still_exact() -> None:
    assert observe.polar([3e-150, 4e-150]).measurement[0] == pytest.approx(5e-150, rel=1e-15)


def test_behind_the_radar_the_azimuth_is_pi_whatever_the_sign_of_zero() -> None:
    for zero in (0.0, -0.0):
        assert observe.polar([-1.0, zero]).measurement[1] == math.pi
        assert observe.spherical([zero, -1.0, 0.0]).measurement[1] == math.pi


# Shapes.


@pytest.mark.parametrize("shape", [(), (0,), (4,), (2, 3)])
@pytest.mark.parametrize("sensor", SENSORS)
def test_states_of_any_leading_shape_are_observed_one_by_one(sensor: str, shape: tuple[int, ...]) -> None:
    state = np.random.default_rng(5).uniform(10, 1000, (*shape, SIZES[sensor]))
    got = observed(sensor, state)
    out, size = len(observed(sensor, np.ones(SIZES[sensor])).measurement), SIZES[sensor]
    assert [part.shape for part in got] == [(*shape, out), (*shape, out, size), (*shape, out, size, size)]
    for index in np.ndindex(shape):
        for part, alone in zip(got, observed(sensor, state[index]), strict=True):
            np.testing.assert_array_equal(part[index], alone)


# Projection.


@st.composite
def tracks(draw: st.DrawFn, sensor: str) -> tuple[Floats, Floats]:
    state = draw(states(sensor))
    deviations = np.where(np.arange(SIZES[sensor]) < POSITIONS[sensor], np.hypot(*state[:2]) / 100, 10.0)
    return state, draw(strategies.covariances(SIZES[sensor], deviations=deviations))


@pytest.mark.parametrize("order", ["linear", "second_order"])
@pytest.mark.parametrize("sensor", SENSORS)
@given(data=st.data())
@share(0.3)
def test_the_projection_has_the_moments_of_the_taylor_polynomial(sensor: str, order: Any, data: st.DataObject) -> None:
    mean, matrix = data.draw(tracks(sensor))
    got = project(sensor, mean, matrix, order)
    nodes, weights = np.polynomial.hermite_e.hermegauss(3)  # exact for squares of quadratic polynomials
    size = len(mean)
    grid = np.stack(np.meshgrid(*[nodes] * size), axis=-1).reshape(-1, size)
    products = np.stack(np.meshgrid(*[weights / weights.sum()] * size), axis=-1).prod(axis=-1).ravel()
    eigenvalues, vectors = np.linalg.eigh(matrix)
    errors = grid * np.sqrt(np.maximum(eigenvalues, 0)) @ vectors.T
    measurement, jacobian, hessian = observed(sensor, mean)
    values = measurement + errors @ jacobian.T
    if order == "second_order":
        values = values + np.einsum("iab,wa,wb->wi", hessian, errors, errors) / 2
    expected = products @ values
    centred = values - expected
    # Full correlation may leave nothing of a variance but the rounding of what cancelled.
    scale = np.maximum(np.sqrt(np.diagonal(got.covariance)), np.sqrt(jacobian**2 @ np.diagonal(matrix)))
    assert (np.abs(got.mean - expected) <= 1e-10 * scale + 1e-12 * np.abs(expected)).all()
    spread = np.einsum("wi,wj,w->ij", centred, centred, products)
    assert (np.abs(got.covariance - spread) <= 1e-9 * np.outer(scale, scale)).all()


@pytest.mark.parametrize("azimuth_from", ["x", "y"])
@pytest.mark.parametrize("sensor", SENSORS)
@given(data=st.data())
@share(0.5)
def test_a_projected_track_serves_the_decorrelated_conversion(
    sensor: str, azimuth_from: Any, data: st.DataObject
) -> None:
    """Its covariance is then about that of the linear conversion at the prediction."""
    mean, matrix = data.draw(tracks(sensor))
    if sensor == "ruv":
        mean[2] += np.hypot(*mean[:2])
    elif sensor.startswith("spherical"):  # near the vertical axis nothing is linear
        assume(np.hypot(*mean[:2]) > 0.1 * abs(mean[2]))
    convention = {"azimuth_from": azimuth_from} if sensor in WITH_AZIMUTH else {}
    predicted = project(sensor, mean, 1e-4 * matrix, **convention)
    deviations = {"polar": [10.0, 1e-3], "spherical": [10.0, 1e-3, 1e-3]} | {
        "polar_doppler": [10.0, 1e-3, 1.0],
        "spherical_doppler": [10.0, 1e-3, 1e-3, 1.0],
        "ruv": [10.0, 1e-3, 1e-3],
    }
    function: Any = getattr(convert, sensor)
    arguments = (*predicted.mean, *deviations[sensor])
    got = function(*arguments, method="decorrelated", predicted=predicted, **convention)
    linear = function(*arguments, method="linear", **convention)
    scale = np.sqrt(np.diagonal(linear.covariance))
    assert (np.abs(got.covariance - linear.covariance) <= 0.2 * np.outer(scale, scale)).all()
    assert (np.abs(got.mean[:2] - cartesian_mean(sensor, mean)[:2]) <= 0.2 * scale[:2]).all()


def cartesian_mean(sensor: str, mean: Floats) -> Floats:
    size = POSITIONS[sensor]
    if sensor.endswith("doppler"):
        return np.array([*mean[:size], mean[:size] @ mean[size:]])
    return mean


def test_projections_broadcast_mean_and_covariance() -> None:
    means = np.array([[1e3, 2e3], [3e3, -1e3], [5e3, 0.0]])
    matrices = np.stack([np.eye(2), 100 * np.eye(2)])[:, np.newaxis]
    got = observe.project("polar", means, matrices, "second_order")
    assert (got.mean.shape, got.covariance.shape) == ((2, 3, 2), (2, 3, 2, 2))
    alone = observe.project("polar", means[2], matrices[1, 0], "second_order")
    np.testing.assert_allclose(got.covariance[1, 2], alone.covariance, rtol=1e-14)
    np.testing.assert_allclose(got.mean[1, 2], alone.mean, rtol=1e-14)


# What is refused.


@pytest.mark.parametrize(
    ("call", "error", "message"),
    [
        (lambda: observe.polar([1.0, 2.0, 3.0]), ValueError, r"state must have shape \(..., 2\); got shape \(3,\)"),
        (lambda: observe.polar(1.0), ValueError, r"state must have shape \(..., 2\); got shape \(\)"),
        (lambda: observe.polar([1.0, math.nan]), ValueError, r"y of state must be finite; got nan"),
        (lambda: observe.polar([1e151, 0.0]), ValueError, r"x of state must be from -1e\+150 to 1e\+150 m"),
        (lambda: observe.polar_doppler([1, 1, 1e51, 0]), ValueError, r"vx of state must be from -1e\+50 to"),
        (lambda: observe.polar(["1", "2"]), TypeError, r"state must be real numbers"),
        (lambda: observe.polar([1, 2j]), TypeError, r"state must be real numbers; .* complex128"),
        (lambda: observe.range_difference([1, 2, 3], [1, 2]), ValueError, r"receiver must have shape \(..., 3\)"),
        (lambda: observe.range_difference([1, 2, 3], [1, 2, 1e151]), ValueError, r"receiver must be from -1e\+150"),
        (lambda: observe.bistatic([1, 2], -1.0), ValueError, r"baseline must be from 0 to 1e\+100 m"),
        (lambda: observe.bistatic([[1, 2]] * 3, [1.0, 2.0]), ValueError, r"state \(3,\), baseline \(2,\)"),
        (lambda: project("bistatic", [1, 2], np.eye(2)), TypeError, r"takes \['baseline'\] beside the state; got \[\]"),
        (lambda: project("polar", [1, 2], np.eye(2), baseline=1.0), TypeError, r"takes no site beside the state"),
        (
            lambda: project("bistatic", [5, 0], np.eye(2), baseline=5.0),
            ValueError,
            r"mean's distance from the transmitter must be",
        ),
        (lambda: observed("polar", [1.0, 2.0], azimuth_from="north"), ValueError, r"azimuth_from must be one of"),
        (lambda: project("radar", [1.0], [[1.0]]), ValueError, r"sensor must be one of .*; got 'radar'"),
        (lambda: project("polar", [1, 2], np.eye(3)), ValueError, r"covariance must have shape \(..., 2, 2\)"),
        (lambda: project("polar", [1, 2], -np.eye(2)), ValueError, r"covariance must be without a negative"),
        (lambda: project("polar", [1, 2], np.eye(2), "third"), ValueError, r"order must be one of"),
        (lambda: project("polar", [0, 0], np.eye(2)), ValueError, r"mean's distance from the radar must be"),
        (
            lambda: project("spherical", [0, 0, 9], np.eye(3)),
            ValueError,
            r"mean's distance from the vertical axis must be",
        ),
        (
            lambda: project("polar", [1e-90, 0], np.eye(2) * 1e150),
            ValueError,
            r"projected covariance must be finite; got inf",
        ),
        (
            lambda: project("polar", np.ones((2, 2)), np.ones((3, 1, 1)) * np.eye(2)),
            ValueError,
            r"the shapes must broadcast; got mean \(2,\), covariance \(3,\)",
        ),
        (
            lambda: project("ruv", [1, 2, 3], np.eye(3), azimuth_from="x"),
            ValueError,
            r"azimuth_from must be None for sensor 'ruv'; got 'x'",
        ),
    ],
)
def test_bad_arguments_are_named_with_what_was_given_and_what_is_allowed(
    call: Any, error: type[Exception], message: str
) -> None:
    with pytest.raises(error, match=message):
        call()


def test_the_map_of_these_tests_is_the_one_observed() -> None:
    state = np.array([300.0, -400.0, 200.0])
    np.testing.assert_allclose(cartesian("spherical", observe.spherical(state).measurement), state, rtol=1e-14)


@pytest.mark.parametrize("azimuth_from", ["x", "y"])
@pytest.mark.parametrize("sensor", SIGHTS)
def test_more_states_than_a_block_holds_are_observed_each_as_alone(sensor: str, azimuth_from: str) -> None:
    generator = np.random.default_rng(1)
    sight = SIGHTS[sensor]  # type: ignore[index]
    count = 2 * observe.BLOCK + 5
    positions = generator.uniform(-1e4, 1e4, (2, count, len(sight.state)))
    site: dict[str, Any] = {}
    if "baseline" in sight.site:
        site = {"baseline": generator.uniform(1e3, 2e3, count)}
    if "receiver" in sight.site:
        site = {"receiver": generator.uniform(1e3, 2e3, (count, 3))}
    convention = {"azimuth_from": azimuth_from} if sight.azimuth_from else {}
    see = getattr(observe, sensor)
    found = see(positions, **site, **convention)
    for index in ((0, 0), (1, observe.BLOCK), (1, count - 1)):
        alone = see(positions[index], **{name: part[index[1]] for name, part in site.items()}, **convention)
        for got, expected in zip(found, alone, strict=True):
            np.testing.assert_array_equal(got[index], expected)
            assert got.flags.c_contiguous
