"""What is neglected, by its definition, and that it tells where formulas fail."""

import math
from typing import Any

import mpmath
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from radartrack import validity
from radartrack.consistency import experiment
from radartrack.validity import Formulas
from tests import maps
from tests.examples import share
from tests.radartrack.plots import DEVIATIONS, PLOTS, SENSORS, Floats, Plot, centre, noise_covariance, plots, size

ORDERS: dict[Formulas, int] = {"linear": 2, "second_order": 3}


def ratios(sensor: str, plot: Plot, formulas: Formulas = "linear") -> Floats:
    found: Floats = getattr(validity, sensor)(**plot, formulas=formulas)
    return found


def neglected(sensor: str, plot: Plot, order: int) -> Floats:
    """By Gauss-Hermite quadrature of derivatives along the errors, which mpmath takes numerically."""
    middle, matrix = centre(sensor, plot), noise_covariance(sensor, plot)
    nodes, weights = np.polynomial.hermite_e.hermegauss(4)  # exact for the squares of terms of third degree
    count = size(sensor)
    grid = np.stack(np.meshgrid(*[nodes] * count), axis=-1).reshape(-1, count)
    products = np.stack(np.meshgrid(*[weights / weights.sum()] * count), axis=-1).prod(axis=-1).ravel()
    errors = grid @ np.linalg.cholesky(matrix).T
    inverse = np.linalg.inv(np.array([along(sensor, middle, unit, 1) for unit in np.eye(count)]).T)
    terms = np.array([along(sensor, middle, error, order) for error in errors]) @ inverse.T
    mean_square = products @ terms**2 / math.factorial(order) ** 2
    found: Floats = np.sqrt(mean_square) / [plot[name] for name in DEVIATIONS[sensor]]
    return found


def along(sensor: str, middle: Floats, error: Floats, order: int) -> list[float]:
    """The derivative of the map in the direction of an error."""
    with mpmath.workdps(40):
        start, slope = ([mpmath.mpf(float(value)) for value in vector] for vector in (middle, error))

        def line(output: int) -> Any:
            return lambda t: maps.MAPS[sensor](mpmath, *(a + t * b for a, b in zip(start, slope, strict=True)))[output]

        return [float(mpmath.diff(line(output), 0, order)) for output in range(len(middle))]


@pytest.mark.parametrize("formulas", ORDERS)
@pytest.mark.parametrize("sensor", SENSORS)
@given(data=st.data())
@share(0.1)
def test_the_ratios_are_the_root_mean_square_of_the_next_taylor_term_over_the_deviation(
    sensor: str, formulas: Formulas, data: st.DataObject
) -> None:
    plot = data.draw(plots(sensor))
    expected = neglected(sensor, plot, ORDERS[formulas])
    np.testing.assert_allclose(ratios(sensor, plot, formulas), expected, rtol=1e-8, atol=1e-12)


def test_along_range_the_linear_conversion_neglects_the_sagitta() -> None:
    got = validity.polar([1e3, 1e4, 7e4], 0.3, 50.0, math.radians(10))
    sagitta = math.sqrt(3) / 2 * np.array([1e3, 1e4, 7e4]) * math.radians(10) ** 2 / 50
    np.testing.assert_allclose(got[:, 0], sagitta, rtol=1e-14)


@pytest.mark.parametrize("azimuth_std", [1e-4, 1e-3, 1e-2, 0.1])
def test_where_the_ratios_are_small_linear_conversion_is_consistent_and_where_they_are_large_it_is_not(
    azimuth_std: float,
) -> None:
    plot: Plot = {"r": 20e3, "azimuth": 0.4, "range_std": 50.0, "azimuth_std": azimuth_std}
    found = experiment("polar", plot, "linear", "measurement", draws=200_000)
    largest = ratios("polar", plot).max()
    assert (found.nees > 1.05) == (largest > 0.5)
    assert largest > 0.5 or largest < 0.1


@pytest.mark.parametrize("formulas", ORDERS)
@pytest.mark.parametrize("sensor", SENSORS)
def test_plots_of_any_shape_broadcast(sensor: str, formulas: Formulas) -> None:
    plot = PLOTS[sensor]
    arrays = plot | {"r": np.array([500.0, 900.0]), "range_std": np.array([[1.0], [20.0], [40.0]])}
    got = ratios(sensor, arrays, formulas)
    assert got.shape == (3, 2, size(sensor))
    for index in np.ndindex(3, 2):
        alone = plot | {"r": arrays["r"][index[1]], "range_std": arrays["range_std"][index[0], 0]}
        np.testing.assert_allclose(got[index], ratios(sensor, alone, formulas), rtol=1e-14)


@pytest.mark.parametrize("formulas", ORDERS)
@pytest.mark.parametrize("sensor", SENSORS)
def test_float32_in_gives_float32_out_close_to_float64(sensor: str, formulas: Formulas) -> None:
    plot = PLOTS[sensor] | dict.fromkeys(DEVIATIONS[sensor], 1e-09)
    single = ratios(sensor, {name: np.float32(value) for name, value in plot.items()}, formulas)
    assert single.dtype == np.float32
    np.testing.assert_allclose(single, ratios(sensor, plot, formulas), rtol=1e-5)


@pytest.mark.parametrize("formulas", ORDERS)
@pytest.mark.parametrize("sensor", SENSORS)
@given(data=st.data())
@share(0.6)
def test_what_is_allowed_never_gives_infinity_or_nan(sensor: str, formulas: Formulas, data: st.DataObject) -> None:
    sizes = st.sampled_from([1e-30, 1e-10, 1.0, 1e10, 1e30])
    angle = st.sampled_from([1e-30, 1e-5, 3.0])
    cosine = st.sampled_from([1e-30, 1e-5, 0.06])
    drawn = {
        "r": sizes,
        "range_std": sizes,
        "range_rate_std": sizes,
        "azimuth_std": angle,
        "elevation_std": angle,
        "u_std": cosine,
        "v_std": cosine,
        "azimuth": st.sampled_from([0.0, 1.0, -1e6]),
        "elevation": st.sampled_from([0.0, 1.0, math.pi / 2, -math.pi / 2]),
        "range_rate": sizes.map(lambda value: -value) | st.just(0.0),
        "u": st.sampled_from([0.0, 0.6, -1e-30]),
        "v": st.sampled_from([0.0, -0.3]),
        "correlation": st.sampled_from([-1.0, 0.0, 0.5, 1.0]),
    }
    plot = {name: data.draw(drawn[name]) for name in PLOTS[sensor]}
    assert np.isfinite(ratios(sensor, plot, formulas)).all()


@pytest.mark.parametrize(
    ("sensor", "changed", "error", "message"),
    [
        ("polar", {"r": 0.0}, ValueError, r"r must be from 1e-30 to 1e\+30 m .*a ratio to zero is none\); got 0.0$"),
        ("polar", {"azimuth_std": 0.0}, ValueError, r"azimuth_std must be from 1e-30 to 3.14"),
        ("polar", {"azimuth_std": math.nan}, ValueError, r"azimuth_std must be finite; got nan"),
        ("polar", {"formulas": "third"}, ValueError, r"formulas must be one of .*; got 'third'"),
        ("polar", {"r": "far"}, TypeError, r"r must be real numbers; got 'far'"),
        ("spherical", {"elevation": 2.0}, ValueError, r"elevation must be from -1.57"),
        ("polar_doppler", {"range_rate": 1e31}, ValueError, r"range_rate must be from -1e\+30 to 1e\+30"),
        ("ruv", {"u": 0.99}, ValueError, r"sqrt\(u\^2 \+ v\^2\) .* must be from 0 to 0.999"),
        ("polar", {"r": [1, 2], "azimuth": [1, 2, 3]}, ValueError, r"the shapes must broadcast; got r \(2,\)"),
    ],
)
def test_bad_arguments_are_named_with_what_was_given_and_what_is_allowed(
    sensor: str, changed: Plot, error: type[Exception], message: str
) -> None:
    with pytest.raises(error, match=message):
        getattr(validity, sensor)(**{**PLOTS[sensor], **changed})


@pytest.mark.parametrize("formulas", ORDERS)
@pytest.mark.parametrize("sensor", SENSORS)
@pytest.mark.parametrize("small", [1e-30, 1e-12])
def test_a_ratio_that_float32_cannot_hold_is_refused(sensor: str, formulas: Formulas, small: float) -> None:
    """Of a short range that is hardly known, which is what the ratios are largest for."""
    plot = PLOTS[sensor] | {"r": small, "range_std": 9e9}
    expected = ratios(sensor, plot, formulas)
    assert np.isfinite(expected).all()
    single = {name: np.float32(value) for name, value in plot.items()}
    if expected.max() > np.finfo(np.float32).max:
        with pytest.raises(ValueError, match=r"the ratios must be at most 3.40\d+e\+38 to be told in float32; got"):
            ratios(sensor, single, formulas)
    else:
        np.testing.assert_allclose(ratios(sensor, single, formulas), expected, rtol=1e-3)
