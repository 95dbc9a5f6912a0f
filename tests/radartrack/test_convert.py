"""Conversion of plots: the methods by their definitions, conventions, shapes, types, and what is refused."""

import math
from collections.abc import Callable
from typing import Any, get_args

import numpy as np
import numpy.typing as npt
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra import numpy as hnp

from radartrack.convert import Converted, Method, Prediction, polar

Floats = npt.NDArray[np.floating[Any]]
Plot = dict[str, Any]
METHODS: tuple[Method, ...] = get_args(Method)
OF_THE_PLOT = [method for method in METHODS if method != "decorrelated"]
PLOT: Plot = {"r": 900.0, "azimuth": 2.3, "range_std": 40.0, "azimuth_std": 0.3, "correlation": -0.6}
PREDICTED = (np.array([850.0, 2.2]), np.array([[1600.0, 2.0], [2.0, 0.04]]))

# Every r is more than 15 deviations from zero, so that quadrature stays within ranges that can be measured.
plots = st.fixed_dictionaries(
    {
        "r": st.floats(1e3, 1e4),
        "azimuth": st.floats(-7, 7),
        "range_std": st.floats(1, 60),
        "azimuth_std": st.floats(1e-3, 0.7),
        "correlation": st.floats(-0.95, 0.95),
    }
)


def prediction_for(method: Method) -> Prediction | None:
    return PREDICTED if method == "decorrelated" else None


def convert(method: Method, **arguments: Any) -> Converted:
    return polar(**{**PLOT, **arguments}, method=method, predicted=prediction_for(method))


# The definitions, by quadrature.


def cartesian(coordinates: Floats) -> Floats:
    r, azimuth = np.moveaxis(coordinates, -1, 0)
    return np.stack([r * np.cos(azimuth), r * np.sin(azimuth)], axis=-1)


def errors(range_std: float, azimuth_std: float, correlation: float) -> tuple[Floats, Floats]:
    """Points and weights of a quadrature over the measurement errors."""
    nodes, weights = np.polynomial.hermite_e.hermegauss(14)
    first, second = np.meshgrid(nodes, nodes)
    second = correlation * first + math.sqrt(1 - correlation**2) * second
    points = np.stack([range_std * first, azimuth_std * second], axis=-1).reshape(-1, 2)
    return points, np.outer(weights, weights).ravel() / (2 * np.pi)


def expectation(values: Floats, weights: Floats) -> Floats:
    """Over the axis before the last."""
    mean: Floats = np.einsum("...wi,w->...i", values, weights)
    return mean


def second_moment(values: Floats, weights: Floats) -> Floats:
    moment: Floats = np.einsum("...wi,...wj,w->...ij", values, values, weights)
    return moment


def covariance(values: Floats, weights: Floats) -> Floats:
    return second_moment(values - expectation(values, weights)[..., np.newaxis, :], weights)


Definition = Callable[[Floats, Floats, Floats], tuple[Floats, Floats]]
FINITE_DIFFERENCES = 1e-4
EXACT = 1e-10


def taylor(measured: Floats, points: Floats, order: int) -> Floats:
    """The Taylor polynomial of the conversion at the points, by central differences."""
    step = 1e-3
    centre, ahead, behind = (cartesian(measured + s * points) for s in (0, step, -step))
    slope, curvature = (ahead - behind) / (2 * step), (ahead - 2 * centre + behind) / step**2
    return centre + slope + (curvature / 2 if order == 2 else 0)


def linear(measured: Floats, points: Floats, weights: Floats) -> tuple[Floats, Floats]:
    return cartesian(measured), covariance(taylor(measured, points, 1), weights)


def second_order(measured: Floats, points: Floats, weights: Floats) -> tuple[Floats, Floats]:
    polynomial = taylor(measured, points, 2)
    bias = expectation(polynomial, weights) - cartesian(measured)
    return cartesian(measured) - bias, covariance(polynomial, weights)


def averaged(measured: Floats, points: Floats, weights: Floats) -> tuple[Floats, Floats]:
    truths = measured - points
    plots = cartesian(truths[:, np.newaxis] + points)
    bias = expectation(expectation(plots, weights) - cartesian(truths), weights)
    return cartesian(measured) - bias, np.einsum("wij,w->ij", covariance(plots, weights), weights)


def posterior(measured: Floats, points: Floats, weights: Floats) -> tuple[Floats, Floats]:
    truths = cartesian(measured - points)
    return expectation(truths, weights), covariance(truths, weights)


def assert_agree(got: Floats, expected: Floats, scale: Any, tolerance: float) -> None:
    assert (np.abs(got - expected) <= tolerance * scale).all()


def assert_covariances_agree(got: Floats, expected: Floats, tolerance: float) -> None:
    deviations = np.sqrt(np.diagonal(expected))
    assert_agree(got, expected, np.outer(deviations, deviations), tolerance)


@pytest.mark.parametrize(
    ("method", "definition", "tolerance"),
    [
        ("linear", linear, FINITE_DIFFERENCES),
        ("second_order", second_order, FINITE_DIFFERENCES),
        ("averaged", averaged, EXACT),
        ("posterior", posterior, EXACT),
    ],
)
@given(plot=plots)
def test_mean_and_covariance_are_those_of_the_definition(
    method: Method, definition: Definition, tolerance: float, plot: Plot
) -> None:
    mean, matrix = definition(np.array([plot["r"], plot["azimuth"]]), *errors(**noise(plot)))
    got = polar(**plot, method=method)
    assert_agree(got.mean, mean, plot["r"], tolerance)
    assert_covariances_agree(got.covariance, matrix, tolerance)


def noise(plot: Plot) -> Plot:
    return {name: plot[name] for name in ("range_std", "azimuth_std", "correlation")}


def converted_around(plot: Plot, centres: Floats, points: Floats, **chosen: Any) -> Converted:
    r, azimuth = np.moveaxis(centres[..., np.newaxis, :] + points, -1, 0)
    return polar(**{**plot, "r": r, "azimuth": azimuth}, **chosen)


@pytest.mark.parametrize("method", ["unbiased", "decorrelated"])
@given(truth=plots)
def test_the_unbiased_mean_is_the_true_position_on_average(method: Method, truth: Plot) -> None:
    centre = np.array([truth["r"], truth["azimuth"]])
    points, weights = errors(**noise(truth))
    got = converted_around(truth, centre, points, method=method, predicted=prediction_for(method))
    assert_agree(expectation(got.mean, weights), cartesian(centre), truth["r"], EXACT)


@given(plot=plots)
def test_the_unbiased_covariance_is_of_its_error_given_the_measurement(plot: Plot) -> None:
    points, weights = errors(**noise(plot))
    got = polar(**plot, method="unbiased")
    truths = cartesian(np.array([plot["r"], plot["azimuth"]]) - points)
    assert_covariances_agree(got.covariance, second_moment(got.mean - truths, weights), EXACT)


@given(plot=plots, predicted=plots)
def test_the_decorrelated_covariance_is_of_the_unbiased_error_averaged_over_the_prediction(
    plot: Plot, predicted: Plot
) -> None:
    mean = np.array([predicted["r"], predicted["azimuth"]])
    truths, prediction_weights = errors(**noise(predicted))
    points, weights = errors(**noise(plot))
    means = converted_around(plot, mean + truths, points, method="unbiased").mean
    given_truth = second_moment(means - cartesian(mean + truths)[:, np.newaxis], weights)
    expected = np.einsum("wij,w->ij", given_truth, prediction_weights)
    got = polar(**plot, method="decorrelated", predicted=(mean, matrix_of(predicted)))
    assert_covariances_agree(got.covariance, expected, EXACT)


def matrix_of(plot: Plot) -> Floats:
    deviations = np.array([plot["range_std"], plot["azimuth_std"]])
    matrix: Floats = np.outer(deviations, deviations)
    matrix[[0, 1], [1, 0]] *= plot["correlation"]
    return matrix


# The prediction.


def test_a_prediction_without_error_gives_the_covariance_at_that_truth() -> None:
    certain = (PREDICTED[0], np.zeros((2, 2)))
    nearly = (PREDICTED[0], np.diag([1e-12, 1e-16]))
    got, expected = (polar(**PLOT, method="decorrelated", predicted=each) for each in (certain, nearly))
    np.testing.assert_allclose(got.covariance, expected.covariance, rtol=1e-9)


def test_the_decorrelated_covariance_does_not_depend_on_the_plot() -> None:
    r, azimuth = np.array([10.0, 900.0, 5e4]), np.array([[-1.0], [2.0]])
    got = convert("decorrelated", r=r, azimuth=azimuth)
    assert got.covariance.shape == (2, 3, 2, 2)
    assert (got.covariance == got.covariance[0, 0]).all()


def test_a_correlation_of_the_prediction_beyond_one_by_rounding_counts_as_one() -> None:
    mean, root = PREDICTED[0], math.sqrt(0.3)
    exact, rounded = (
        polar(**PLOT, method="decorrelated", predicted=(mean, [[3.0, c], [c, 0.1]]))
        for c in (root, root * (1 + 1e-9))
    )
    np.testing.assert_allclose(rounded.covariance, exact.covariance, rtol=1e-12)


# Conventions.


@pytest.mark.parametrize("method", METHODS)
@given(plot=plots)
def test_the_compass_convention_is_the_other_one_with_the_axes_exchanged(method: Method, plot: Plot) -> None:
    predicted = prediction_for(method)
    from_x = polar(**plot, method=method, azimuth_from="x", predicted=predicted)
    from_y = polar(**plot, method=method, azimuth_from="y", predicted=predicted)
    assert (from_y.mean == from_x.mean[::-1]).all()
    assert (from_y.covariance == from_x.covariance[::-1, ::-1]).all()


@pytest.mark.parametrize("method", METHODS)
@given(plot=plots)
def test_an_azimuth_counted_from_the_other_axis_gives_the_same_position(method: Method, plot: Plot) -> None:
    """The sense of rotation changes too, and with it the sign of the correlation."""
    mirrored = {**plot, "azimuth": math.pi / 2 - plot["azimuth"], "correlation": -plot["correlation"]}
    other = ([850.0, math.pi / 2 - 2.2], [[1600.0, -2.0], [-2.0, 0.04]]) if prediction_for(method) else None
    got = polar(**plot, method=method, predicted=prediction_for(method))
    same = polar(**mirrored, method=method, azimuth_from="y", predicted=other)
    assert_agree(same.mean, got.mean, plot["r"], 1e-13)
    assert_covariances_agree(same.covariance, got.covariance, 1e-11)


@pytest.mark.parametrize(
    ("azimuth_from", "azimuth", "expected"),
    [("x", 0.0, (1, 0)), ("x", 0.5, (0, 1)), ("y", 0.0, (0, 1)), ("y", 0.5, (1, 0)), ("y", -0.5, (-1, 0))],
)
def test_north_and_east(azimuth_from: Any, azimuth: float, expected: tuple[int, int]) -> None:
    got = polar(1.0, azimuth * math.pi, 0.0, 0.0, method="linear", azimuth_from=azimuth_from)
    np.testing.assert_allclose(got.mean, expected, atol=1e-15)


# Shapes and types.


@pytest.mark.parametrize("method", METHODS)
@given(
    shapes=hnp.mutually_broadcastable_shapes(num_shapes=7, min_side=0, max_side=3, max_dims=3),
    seed=st.integers(0, 99),
)
def test_arguments_of_any_shapes_broadcast_as_if_converted_one_by_one(
    method: Method, shapes: hnp.BroadcastableShapes, seed: int
) -> None:
    generator = np.random.default_rng(seed)
    *of_plot, of_mean, of_matrix = shapes.input_shapes
    plot: Plot = {
        name: value * generator.uniform(0.5, 1, shape)
        for (name, value), shape in zip(PLOT.items(), of_plot, strict=True)
    }
    mean = PREDICTED[0] * generator.uniform(0.5, 1, (*of_mean, 1))
    matrix = PREDICTED[1] * generator.uniform(0.5, 1, (*of_matrix, 1, 1))
    predicts = method == "decorrelated"
    shape = shapes.result_shape if predicts else np.broadcast_shapes(*of_plot)

    got = polar(**plot, method=method, predicted=(mean, matrix) if predicts else None)
    assert (got.mean.shape, got.covariance.shape) == ((*shape, 2), (*shape, 2, 2))
    for index in np.ndindex(shape):
        one: Plot = {name: np.broadcast_to(values, shape)[index] for name, values in plot.items()}
        if predicts:
            ends = (*shape, 2), (*shape, 2, 2)
            one["predicted"] = tuple(
                np.broadcast_to(part, end)[index] for part, end in zip((mean, matrix), ends, strict=True)
            )
        alone = polar(**one, method=method)
        assert_agree(got.mean[index], alone.mean, np.linalg.norm(alone.mean), 1e-13)
        assert_covariances_agree(got.covariance[index], alone.covariance, 1e-13)


@pytest.mark.parametrize("method", METHODS)
def test_scalars_give_one_mean_and_one_matrix(method: Method) -> None:
    mean, matrix = got = convert(method)
    assert mean is got.mean
    assert matrix is got.covariance
    assert (mean.shape, matrix.shape) == ((2,), (2, 2))


@pytest.mark.parametrize("azimuth_from", ["x", "y"])
@pytest.mark.parametrize("method", METHODS)
def test_no_plots_give_no_positions(method: Method, azimuth_from: str) -> None:
    got = convert(method, r=np.empty(0), azimuth=[], azimuth_from=azimuth_from)
    assert (got.mean.shape, got.covariance.shape) == ((0, 2), (0, 2, 2))


@pytest.mark.parametrize("azimuth_from", ["x", "y"])
@pytest.mark.parametrize("range_std_shape", [(3, 2), (3, 1), (4, 1, 1)])
@pytest.mark.parametrize("method", METHODS)
def test_results_may_be_written_to_and_arguments_stay_as_they_are(
    method: Method, azimuth_from: str, range_std_shape: tuple[int, ...]
) -> None:
    given = {name: np.full((3, 2), value) for name, value in PLOT.items()}
    given["range_std"] = np.full(range_std_shape, PLOT["range_std"])
    for result in convert(method, **given, azimuth_from=azimuth_from):
        marks = np.arange(result.size).reshape(result.shape)
        result[...] = marks
        assert (result == marks).all()
    assert all((given[name] == value).all() for name, value in PLOT.items())


@pytest.mark.parametrize("method", METHODS)
def test_float32_in_gives_float32_out_close_to_float64(method: Method) -> None:
    single: Plot = {name: np.full(3, value, np.float32) for name, value in PLOT.items()}
    if method == "decorrelated":
        single["predicted"] = tuple(np.array(part, np.float32) for part in PREDICTED)
    got = polar(**single, method=method)
    assert {part.dtype for part in got} == {np.dtype(np.float32)}
    for part, exact in zip(got, convert(method), strict=True):
        np.testing.assert_allclose(part, np.broadcast_to(exact, part.shape), rtol=1e-5)


def test_one_float64_array_makes_the_result_float64() -> None:
    single: Plot = {name: np.full(3, value, np.float32) for name, value in PLOT.items()}
    for name in PLOT:
        got = polar(**{**single, name: single[name].astype(float)})
        assert {part.dtype for part in got} == {np.dtype(np.float64)}
    predicted = (np.array(PREDICTED[0], np.float32), np.array(PREDICTED[1]))
    got = polar(**single, method="decorrelated", predicted=predicted)
    assert {part.dtype for part in got} == {np.dtype(np.float64)}


LIMITS = {
    np.float64: {"r": 1e100, "azimuth": 1e6, "range_std": 1e100, "azimuth_std": math.pi, "correlation": 1.0},
    np.float32: {"r": 1e10, "azimuth": 1e3, "range_std": 1e10, "azimuth_std": math.pi, "correlation": 1.0},
}


@pytest.mark.parametrize("dtype", LIMITS)
@pytest.mark.parametrize("method", METHODS)
@given(data=st.data())
def test_what_is_allowed_never_gives_infinity_or_nan(
    method: Method, dtype: type[np.floating[Any]], data: st.DataObject
) -> None:
    fractions = st.sampled_from([0.0, 1e-200, 1e-30, 1e-5, 0.3, 1.0])
    signed = fractions | fractions.map(lambda fraction: -fraction)
    plot: Plot = {
        name: dtype(limit * data.draw(signed if name in {"azimuth", "correlation"} else fractions))
        for name, limit in LIMITS[dtype].items()
    }
    if method == "decorrelated":
        deviations = np.array([plot["range_std"], plot["azimuth_std"]])
        plot["predicted"] = np.array([plot["r"], plot["azimuth"]]), np.diag(deviations**2)
    got = polar(**plot, method=method)
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
        ({"azimuth_std": -0.1}, ValueError, r"azimuth_std must be from 0 to 3.141593 rad .*; got -0.1$"),
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
def test_a_prediction_without_a_use_is_refused(method: Method) -> None:
    with pytest.raises(ValueError, match=rf"predicted must be None for method '{method}'; got \(array"):
        polar(**PLOT, method=method, predicted=PREDICTED)
