"""Conversion of plots: conventions, shapes, types, and what is refused."""

import math
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra import numpy as hnp

from radartrack.convert import Method, polar, polar_doppler, ruv, spherical, spherical_doppler
from radartrack.testing import strategies
from tests.examples import share
from tests.radartrack.plots import (
    COORDINATES,
    METHODS,
    OF_THE_PLOT,
    PLOTS,
    SENSORS,
    WITH_AZIMUTH,
    Plot,
    assert_agree,
    assert_covariances_agree,
    centre,
    convert,
    noise_covariance,
    plots,
    prediction,
    size,
)

PLOT = PLOTS["polar"]
PREDICTED = prediction("polar")


# The prediction.


@pytest.mark.parametrize("sensor", SENSORS)
def test_a_prediction_without_error_gives_the_covariance_at_that_truth(sensor: str) -> None:
    mean, matrix = prediction(sensor)
    got, expected = (convert(sensor, "decorrelated", predicted=(mean, matrix * s)) for s in (0, 1e-16))
    np.testing.assert_allclose(got.covariance, expected.covariance, rtol=1e-9)


@pytest.mark.parametrize("sensor", SENSORS)
def test_the_decorrelated_covariance_does_not_depend_on_the_plot(sensor: str) -> None:
    second = COORDINATES[sensor][1]
    got = convert(sensor, "decorrelated", r=[10.0, 900.0, 5e4], **{second: np.array([[-0.5], [0.2]])})
    assert got.covariance.shape == (2, 3, size(sensor), size(sensor))
    assert (got.covariance == got.covariance[0, 0]).all()


def test_a_correlation_of_the_prediction_beyond_one_by_rounding_counts_as_one() -> None:
    mean, root = PREDICTED[0], math.sqrt(0.3)
    exact, rounded = (
        polar(**PLOT, method="decorrelated", predicted=(mean, [[3.0, c], [c, 0.1]])) for c in (root, root * (1 + 1e-9))
    )
    np.testing.assert_allclose(rounded.covariance, exact.covariance, rtol=1e-12)


@pytest.mark.parametrize("sensor", SENSORS[1:])
def test_fully_correlated_predictions_are_those_of_almost_fully_correlated_ones(sensor: str) -> None:
    mean, matrix = prediction(sensor)
    deviations = np.sqrt(np.diagonal(matrix)) * [1, -1, 1, -1][: size(sensor)]
    full = np.outer(deviations, deviations)
    nearly = full + np.diag(1e-12 * deviations**2)
    got, expected = (convert(sensor, "decorrelated", predicted=(mean, each)) for each in (full, nearly))
    np.testing.assert_allclose(got.covariance, expected.covariance, rtol=1e-8)


# The covariance of every method.


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("sensor", SENSORS)
@given(data=st.data())
@share(0.5)
def test_covariances_are_symmetric_and_positive_semidefinite_for_correlated_errors(
    sensor: Any, method: Method, data: st.DataObject
) -> None:
    """All over the domain; the series of direction cosines too, up to the edge that they are taken to."""
    plot = data.draw(strategies.plots(sensor))
    plot["range_std"] = data.draw(st.just(0.0) | st.just(plot["range_std"]))
    if sensor == "ruv":
        plot |= data.draw(near_the_edge())
    predicted = (centre(sensor, plot), noise_covariance(sensor, plot) * data.draw(st.sampled_from([0, 1e-4, 0.1])))
    chosen = {"predicted": predicted} if method == "decorrelated" else {}
    if sensor == "ruv" and method == "decorrelated":  # prediction and measurement share the margin
        plot |= {"u_std": 0.9 * plot["u_std"], "v_std": 0.9 * plot["v_std"]}
    matrix = convert(sensor, method, **plot, **chosen).covariance
    assert_agree(matrix, matrix.T, np.abs(matrix), 1e-15)
    deviations = np.sqrt(np.diagonal(matrix))
    metres = slice(-1 if sensor.endswith("doppler") else None)
    # Full correlation may leave nothing of one variance but the rounding of what cancelled.
    deviations[metres] = np.maximum(deviations[metres], 1e-4 * deviations[metres].max())
    scale = np.where(deviations > 0, deviations, 1)
    assert np.linalg.eigvalsh(matrix / np.outer(scale, scale)).min() > -1e-9


@st.composite
def near_the_edge(draw: st.DrawFn) -> Plot:
    deviations = [10.0 ** draw(st.floats(-5, -1)) for _ in range(2)]
    reach, angle = 0.999 - 5 * max(deviations), draw(st.floats(-7, 7))
    reach *= draw(st.floats(0, 1) | st.just(1.0)) * (1 - 1e-12)
    return {
        "u": reach * math.cos(angle),
        "v": reach * math.sin(angle),
        "u_std": deviations[0],
        "v_std": deviations[1],
    }


@pytest.mark.parametrize("method", METHODS)
@given(plot=plots("polar"))
@share(0.5)
def test_spherical_without_elevation_and_its_error_is_polar(method: Method, plot: Plot) -> None:
    mean, matrix = centre("polar", plot) + np.array([20.0, 0.1]), noise_covariance("polar", plot)
    predicts = method == "decorrelated"
    in_plane = polar(**plot, method=method, azimuth_from="y", predicted=(mean, matrix) if predicts else None)
    mean, matrix = np.append(mean, 0.0), np.pad(matrix, (0, 1))
    chosen: Plot = {"predicted": (mean, matrix)} if predicts else {}
    in_space = convert("spherical", method, **plot, elevation=0.0, elevation_std=0.0, **chosen)
    assert_agree(in_space.mean, np.append(in_plane.mean, 0.0), plot["r"], 1e-14)
    assert_covariances_agree(in_space.covariance[:2, :2], in_plane.covariance, 1e-12)
    assert (in_space.covariance[2] == 0).all()
    assert (in_space.covariance[:, 2] == 0).all()


# Conventions.


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("sensor", WITH_AZIMUTH)
@given(data=st.data())
@share(0.4)
def test_the_compass_convention_is_the_other_one_with_the_axes_exchanged(
    sensor: Any, method: Method, data: st.DataObject
) -> None:
    plot = data.draw(strategies.plots(sensor))
    from_x, from_y = (convert(sensor, method, **plot, azimuth_from=axis) for axis in ("x", "y"))
    order = [1, 0, 2, 3][: size(sensor)]
    assert (from_y.mean == from_x.mean[order]).all()
    assert (from_y.covariance == from_x.covariance[np.ix_(order, order)]).all()


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("sensor", WITH_AZIMUTH)
@given(data=st.data())
@share(0.4)
def test_an_azimuth_counted_from_the_other_axis_gives_the_same_position(
    sensor: str, method: Method, data: st.DataObject
) -> None:
    """The sense of rotation changes too, and with it the sign of the azimuth's correlations."""
    plot = data.draw(plots(sensor))
    mirrored: Plot = {**plot, "azimuth": math.pi / 2 - plot["azimuth"]}
    if not sensor.endswith("doppler"):
        mirrored["correlation"] = -plot["correlation"]
    signs = np.array([1, -1, 1, 1])[: size(sensor)]
    mean, matrix = prediction(sensor)
    there = (mean * signs + [0, math.pi / 2, 0, 0][: size(sensor)], matrix * np.outer(signs, signs))
    got = convert(sensor, method, **plot, azimuth_from="x")
    chosen: Plot = {"predicted": there} if method == "decorrelated" else {}
    same = convert(sensor, method, **mirrored, azimuth_from="y", **chosen)
    assert_agree(same.mean, got.mean, np.linalg.norm(got.mean), 1e-13)
    assert_covariances_agree(same.covariance, got.covariance, 1e-11)


@pytest.mark.parametrize(
    ("azimuth_from", "azimuth", "expected"),
    [("x", 0.0, (1, 0)), ("x", 0.5, (0, 1)), ("y", 0.0, (0, 1)), ("y", 0.5, (1, 0)), ("y", -0.5, (-1, 0))],
)
def test_north_and_east(azimuth_from: Any, azimuth: float, expected: tuple[int, int]) -> None:
    angle = azimuth * math.pi
    plane = polar(1.0, angle, 0.0, 0.0, method="linear", azimuth_from=azimuth_from)
    space = spherical(1.0, angle, 0.0, 0.0, 0.0, 0.0, method="linear", azimuth_from=azimuth_from)
    doppler = polar_doppler(1.0, angle, 7.0, 0.0, 0.0, 0.0, method="linear", azimuth_from=azimuth_from)
    moving = spherical_doppler(1.0, angle, 0.0, 7.0, 0.0, 0.0, 0.0, 0.0, method="linear", azimuth_from=azimuth_from)
    np.testing.assert_allclose(plane.mean, expected, atol=1e-15)
    np.testing.assert_allclose(moving.mean, [*expected, 0, 7], atol=1e-15)
    np.testing.assert_allclose(space.mean, [*expected, 0], atol=1e-15)
    np.testing.assert_allclose(doppler.mean, [*expected, 7], atol=1e-15)


def test_the_azimuth_is_counted_as_each_model_does_unless_one_says_otherwise() -> None:
    assert polar(1.0, 0.0, 0.0, 0.0).mean.tolist() == [1, 0]
    assert polar_doppler(1.0, 0.0, 0.0, 0.0, 0.0, 0.0).mean.tolist() == [1, 0, 0]
    assert spherical(1.0, 0.0, 0.0, 0.0, 0.0, 0.0).mean.tolist() == [0, 1, 0]
    assert spherical_doppler(1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0).mean.tolist() == [0, 1, 0, 0]
    assert ruv(1.0, 0.0, 0.0, 0.0, 0.0, 0.0).mean.tolist() == [0, 0, 1]


# Shapes and types.


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("sensor", SENSORS)
@given(data=st.data(), seed=st.integers(0, 99))
@share(0.3)
def test_arguments_of_any_shapes_broadcast_as_if_converted_one_by_one(
    sensor: str, method: Method, data: st.DataObject, seed: int
) -> None:
    generator = np.random.default_rng(seed)
    count = len(PLOTS[sensor])
    shapes = data.draw(hnp.mutually_broadcastable_shapes(num_shapes=count + 2, min_side=0, max_side=3, max_dims=3))
    *of_plot, of_mean, of_matrix = shapes.input_shapes
    plot: Plot = {
        name: value * generator.uniform(0.5, 1, shape)
        for (name, value), shape in zip(PLOTS[sensor].items(), of_plot, strict=True)
    }
    mean, matrix = prediction(sensor)
    mean = mean * generator.uniform(0.5, 1, (*of_mean, 1))
    matrix = matrix * generator.uniform(0.5, 1, (*of_matrix, 1, 1))
    predicts = method == "decorrelated"
    shape = shapes.result_shape if predicts else np.broadcast_shapes(*of_plot)
    ends = (*shape, size(sensor)), (*shape, size(sensor), size(sensor))

    got = convert(sensor, method, **plot, **({"predicted": (mean, matrix)} if predicts else {}))
    assert (got.mean.shape, got.covariance.shape) == ends
    for index in np.ndindex(shape):
        one: Plot = {name: np.broadcast_to(values, shape)[index] for name, values in plot.items()}
        if predicts:
            one["predicted"] = tuple(
                np.broadcast_to(part, end)[index] for part, end in zip((mean, matrix), ends, strict=True)
            )
        alone = convert(sensor, method, **one)
        assert_agree(got.mean[index], alone.mean, np.linalg.norm(alone.mean), 1e-13)
        assert_covariances_agree(got.covariance[index], alone.covariance, 1e-13)


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("sensor", SENSORS)
def test_scalars_give_one_mean_and_one_matrix(sensor: str, method: Method) -> None:
    mean, matrix = got = convert(sensor, method)
    assert mean is got.mean
    assert matrix is got.covariance
    assert (mean.shape, matrix.shape) == ((size(sensor),), (size(sensor), size(sensor)))


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("sensor", SENSORS)
def test_no_plots_give_no_positions(sensor: str, method: Method) -> None:
    got = convert(sensor, method, r=np.empty(0))
    assert (got.mean.shape, got.covariance.shape) == ((0, size(sensor)), (0, size(sensor), size(sensor)))


@pytest.mark.parametrize("azimuth_from", ["x", "y"])
@pytest.mark.parametrize("range_std_shape", [(3, 2), (3, 1), (4, 1, 1)])
@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("sensor", SENSORS)
def test_results_may_be_written_to_and_arguments_stay_as_they_are(
    sensor: str, method: Method, azimuth_from: str, range_std_shape: tuple[int, ...]
) -> None:
    plot = PLOTS[sensor]
    given = {name: np.full((3, 2), value) for name, value in plot.items()}
    given["range_std"] = np.full(range_std_shape, plot["range_std"])
    convention = {"azimuth_from": azimuth_from} if sensor in WITH_AZIMUTH else {}
    predicted = prediction(sensor)
    chosen: Plot = {"predicted": predicted} if method == "decorrelated" else {}
    for result in convert(sensor, method, **given, **convention, **chosen):
        marks = np.arange(result.size).reshape(result.shape)
        result[...] = marks
        assert (result == marks).all()
    assert all((given[name] == value).all() for name, value in plot.items())
    assert all((a == b).all() for a, b in zip(predicted, prediction(sensor), strict=True))


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("sensor", SENSORS)
def test_float32_in_gives_float32_out_close_to_float64(sensor: str, method: Method) -> None:
    single: Plot = {name: np.full(3, value, np.float32) for name, value in PLOTS[sensor].items()}
    if method == "decorrelated":
        single["predicted"] = tuple(np.array(part, np.float32) for part in prediction(sensor))
    got, exact = convert(sensor, method, **single), convert(sensor, method)
    assert {part.dtype for part in got} == {np.dtype(np.float32)}
    np.testing.assert_allclose(got.mean, np.broadcast_to(exact.mean, got.mean.shape), rtol=1e-5)
    assert_covariances_agree(got.covariance, exact.covariance, 1e-5)


def test_one_float64_array_makes_the_result_float64() -> None:
    single: Plot = {name: np.full(3, value, np.float32) for name, value in PLOT.items()}
    for name in PLOT:
        got = polar(**{**single, name: single[name].astype(float)})
        assert {part.dtype for part in got} == {np.dtype(np.float64)}
    predicted = (np.array(PREDICTED[0], np.float32), np.array(PREDICTED[1]))
    got = polar(**single, method="decorrelated", predicted=predicted)
    assert {part.dtype for part in got} == {np.dtype(np.float64)}


LIMITS = {
    "r": (1e100, 1e10),
    "azimuth": (1e6, 1e3),
    "elevation": (math.pi / 2, math.pi / 2),
    "range_rate": (1e50, 1e8),
    "range_std": (1e100, 1e10),
    "azimuth_std": (math.pi, math.pi),
    "elevation_std": (math.pi, math.pi),
    "range_rate_std": (1e50, 1e8),
    "correlation": (1.0, 1.0),
}
SIGNED = {"azimuth", "elevation", "range_rate", "correlation"}
FRACTIONS = st.sampled_from([0.0, 1e-200, 1e-30, 1e-5, 0.3, 1.0])


def at_the_limits(sensor: str, dtype: type[np.floating[Any]], data: st.DataObject) -> Plot:
    signed = FRACTIONS | FRACTIONS.map(lambda fraction: -fraction)
    return {
        name: dtype(LIMITS[name][dtype is np.float32] * data.draw(signed if name in SIGNED else FRACTIONS))
        for name in PLOTS[sensor]
        if name in LIMITS
    }


def at_the_edge(dtype: type[np.floating[Any]], data: st.DataObject) -> Plot:
    """Direction cosines in the middle or, by rounding less than the limit, at the edge of what is taken."""
    std = data.draw(st.sampled_from([0.0, 1e-12, 1e-4, 0.04, 0.13]))
    other, angle = std * data.draw(FRACTIONS), data.draw(st.floats(-7, 7))
    reach = (0.999 - 5 * std) * (1 - 1e-5) * data.draw(st.sampled_from([0, 0.5, 1]))
    values = {"u": reach * math.cos(angle), "v": reach * math.sin(angle), "u_std": std, "v_std": other}
    return {name: dtype(value) for name, value in values.items()}


@pytest.mark.parametrize("dtype", [np.float64, np.float32])
@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("sensor", SENSORS)
@given(data=st.data())
@share(0.6)
def test_what_is_allowed_never_gives_infinity_or_nan(
    sensor: str, method: Method, dtype: type[np.floating[Any]], data: st.DataObject
) -> None:
    plot = at_the_limits(sensor, dtype, data)
    if sensor == "ruv":
        plot |= at_the_edge(dtype, data)
    if method == "decorrelated":
        certain = {**plot, "u_std": 0.0, "v_std": 0.0}  # the measurement's own deviations fill the margin
        matrix = noise_covariance(sensor, certain if sensor == "ruv" else plot)
        plot["predicted"] = centre(sensor, plot), np.diag(np.diag(matrix)).astype(dtype)
    got = convert(sensor, method, **plot)
    assert all(np.isfinite(part).all() for part in got)


# What is refused.


@pytest.mark.parametrize(
    ("arguments", "error", "message"),
    [
        ({"r": -1.0}, ValueError, r"r must be from 0 to 1e\+100 m .*; got -1.0$"),
        ({"r": 1e101}, ValueError, r"r must be from 0 to 1e\+100 m .*overflow\); got 1e\+101$"),
        (
            {
                "r": np.float32(2e10),
                "azimuth": np.float32(1),
                **dict.fromkeys(("range_std", "azimuth_std"), 1),
            },
            ValueError,
            r"r must be from 0 to 1e\+10 m in float32 ",
        ),
        ({"r": [1.0, math.nan]}, ValueError, r"r must be finite; got nan at \[1\], the first of 1 among 2$"),
        ({"r": "900"}, TypeError, r"r must be real numbers; got '900' \(str\)"),
        ({"r": True}, TypeError, r"r must be real numbers; got True \(bool\)"),
        ({"azimuth": math.inf}, ValueError, r"azimuth must be finite; got inf$"),
        (
            {"azimuth": -1.1e6},
            ValueError,
            r"azimuth must be from -1000000 to 1000000 rad .*; got -1100000.0$",
        ),
        ({"azimuth": 1j}, TypeError, r"azimuth must be real numbers; got 1j \(complex\)"),
        ({"range_std": -0.1}, ValueError, r"range_std must be from 0 to 1e\+100 m .*; got -0.1$"),
        ({"range_std": None}, TypeError, r"range_std must be real numbers; got None"),
        ({"azimuth_std": -0.1}, ValueError, r"azimuth_std must be from 0 to 3.141592653589793 rad .*; got -0.1$"),
        ({"azimuth_std": 3.2}, ValueError, r"azimuth_std must be .*says nothing about direction\); got 3.2$"),
        ({"correlation": 1.1}, ValueError, r"correlation must be from -1 to 1 .*; got 1.1$"),
        ({"correlation": [0, -2]}, ValueError, r"correlation must be from -1 to 1 .*; got -2.0 at \[1\]"),
        (
            {"r": [1, 2], "azimuth": [1, 2, 3]},
            ValueError,
            r"shapes must broadcast; got r \(2,\), azimuth \(3,\), range_std \(\), azimuth_std \(\), corr",
        ),
        ({"method": "unbaised"}, ValueError, r"method must be one of \['unbiased', .*; got 'unbaised'$"),
        ({"method": None}, TypeError, r"method must be one of \['linear', .*; got None"),
        ({"azimuth_from": "north"}, ValueError, r"azimuth_from must be one of \['x', 'y'\]; got 'north'$"),
    ],
)
def test_bad_arguments_are_named_with_what_was_given_and_what_is_allowed(
    arguments: dict[str, Any], error: type[Exception], message: str
) -> None:
    with pytest.raises(error, match=message):
        polar(**{**PLOT, **arguments})


OTHERS: list[tuple[str, Plot, type[Exception], str]] = [
    ("spherical", {"elevation": 1.6}, ValueError, r"elevation must be from -1.570796 to 1.570796 rad .*vertical"),
    ("spherical", {"elevation": math.nan}, ValueError, r"elevation must be finite; got nan"),
    ("spherical", {"elevation_std": -0.1}, ValueError, r"elevation_std must be from 0 to 3.14.*; got -0.1$"),
    ("spherical", {"elevation_std": "a"}, TypeError, r"elevation_std must be real numbers; got 'a'"),
    ("spherical", {"azimuth_from": None}, TypeError, r"azimuth_from must be one of \['x', 'y'\]; got None"),
    ("polar_doppler", {"range_rate": math.inf}, ValueError, r"range_rate must be finite; got inf$"),
    ("polar_doppler", {"range_rate": 1e51}, ValueError, r"range_rate must be from -1e\+50 to 1e\+50 m/s"),
    ("polar_doppler", {"range_rate_std": -1.0}, ValueError, r"range_rate_std must be from 0 to 1e\+50 m/s"),
    ("ruv", {"u": 1.5}, ValueError, r"u must be from -1 to 1 in float64 \(no cosine is larger\); got 1.5$"),
    ("ruv", {"v_std": -1e-3}, ValueError, r"v_std must be from 0 to 1 .*; got -0.001$"),
    ("ruv", {"u": 0.8, "v": 0.6}, ValueError, r"sqrt\(u\^2 \+ v\^2\) \+ 5 max\(u_std, v_std\) must be from 0"),
    ("ruv", {"u": [0, 0.9], "v": 0.0}, ValueError, r"to 0.999 in float64 .*; got 1\.0 at \[1\]"),
]


@pytest.mark.parametrize(("sensor", "arguments", "error", "message"), OTHERS)
def test_bad_arguments_of_the_other_sensors_are_named_too(
    sensor: str, arguments: Plot, error: type[Exception], message: str
) -> None:
    with pytest.raises(error, match=message):
        convert(sensor, "unbiased", **arguments)


def test_direction_cosines_have_no_azimuth() -> None:
    with pytest.raises(TypeError, match="azimuth_from"):
        convert("ruv", "unbiased", azimuth_from="x")


def test_a_prediction_with_impossible_correlations_is_refused() -> None:
    """Each correlation is possible alone."""
    mean, matrix = prediction("spherical")
    deviations = np.sqrt(np.diagonal(matrix))
    correlations = np.array([[1, 0.9, 0.9], [0.9, 1, -0.9], [0.9, -0.9, 1]])
    impossible = correlations * np.outer(deviations, deviations)
    with pytest.raises(ValueError, match="predicted covariance must be positive semidefinite; got"):
        convert("spherical", "decorrelated", predicted=(mean, impossible))


def test_a_predicted_direction_keeps_its_distance_from_the_edge_with_the_errors_of_the_plot() -> None:
    mean, matrix = np.array([900.0, 0.9, 0.0]), np.diag([100.0, 1e-4, 1e-4])
    convert("ruv", "decorrelated", predicted=(mean, matrix), u_std=0.01, v_std=0.01)
    with pytest.raises(ValueError, match=r"max\(u_std, v_std\) of predicted mean must be .*; got 1.01"):
        convert("ruv", "decorrelated", predicted=(mean, matrix), u_std=0.02, v_std=0.01)


@pytest.mark.parametrize("sensor", SENSORS)
def test_a_prediction_of_another_sensor_is_refused(sensor: str) -> None:
    other = prediction("spherical" if sensor == "polar" else "polar")
    with pytest.raises(ValueError, match=r"predicted mean must have shape \(..., \d\); got shape \(\d,\)"):
        convert(sensor, "decorrelated", predicted=other)


MEAN, MATRIX = PREDICTED


@pytest.mark.parametrize(
    ("predicted", "error", "message"),
    [
        (
            None,
            TypeError,
            r"predicted must be a pair \(mean, covariance\) for method 'decorrelated'; got None",
        ),
        ((MEAN,), TypeError, r"predicted must be a pair"),
        (np.zeros(2), TypeError, r"predicted must be a pair .*; got array"),
        ((MEAN, "matrix"), TypeError, r"predicted covariance must be real numbers; got 'matrix'"),
        (
            ([1.0, 2.0, 3.0], MATRIX),
            ValueError,
            r"predicted mean must have shape \(..., 2\); got shape \(3,\)",
        ),
        ((900.0, MATRIX), ValueError, r"predicted mean must have shape \(..., 2\); got shape \(\)"),
        (
            (MEAN, [1.0, 2.0]),
            ValueError,
            r"predicted covariance must have shape \(..., 2, 2\); got shape \(2,\)",
        ),
        (([-1.0, 0.0], MATRIX), ValueError, r"r of predicted mean must be from 0 to .*; got -1.0"),
        (([1.0, math.nan], MATRIX), ValueError, r"azimuth of predicted mean must be finite; got nan"),
        (
            (MEAN, [[1, 0], [0, math.nan]]),
            ValueError,
            r"predicted covariance must be finite; got nan at \[1, 1\]",
        ),
        (
            (MEAN, [[1, 0], [0, -1]]),
            ValueError,
            r"predicted covariance must be without a negative variance; got",
        ),
        (
            (MEAN, [[1, 0.1], [0.2, 1]]),
            ValueError,
            r"predicted covariance must be symmetric; got \[\[1.0, 0.1\]",
        ),
        ((MEAN, [[1, 2], [2, 1]]), ValueError, r"predicted covariance must be positive semidefinite; got"),
        (
            (MEAN, [[1, 0], [0, 10]]),
            ValueError,
            r"azimuth_std of predicted covariance must be from 0 to 3.14",
        ),
        (
            (np.tile(MEAN, (3, 1)), np.tile(MATRIX, (2, 1, 1))),
            ValueError,
            r"r of predicted mean \(3,\), .*azimuth_std of predicted covariance \(2,\)",
        ),
    ],
)
def test_bad_predictions_are_named_with_what_was_given_and_what_is_allowed(
    predicted: Any, error: type[Exception], message: str
) -> None:
    with pytest.raises(error, match=message):
        polar(**PLOT, method="decorrelated", predicted=predicted)


@pytest.mark.parametrize("method", OF_THE_PLOT)
@pytest.mark.parametrize("sensor", SENSORS)
def test_a_prediction_without_a_use_is_refused(sensor: str, method: Method) -> None:
    with pytest.raises(ValueError, match=rf"predicted must be None for method '{method}'; got \(array"):
        convert(sensor, method, predicted=prediction(sensor))
