"""Conversion of radar plots to Cartesian positions, with the covariance of their errors.

With h the map to Cartesian coordinates and L half the noise covariance times the second derivatives, the
expectation of f(truth + noise) is e^L f(truth). The mean of each method is a word in L applied to h, taken at
the measurement; its covariance is

- linear, mean h: of the linear Taylor polynomial;
- second_order, mean h - L h: of the quadratic Taylor polynomial;
- averaged, mean h - (e^2L - e^L) h: of the plain conversion given the truth, averaged given the measurement;
- unbiased, mean e^-L h: of the error of that mean, given the measurement;
- posterior, mean e^L h: of the position, given the measurement and no other knowledge of it;
- decorrelated, mean e^-L h: of the error of that mean given the truth, averaged over a prediction of it.
"""

import reprlib
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from types import ModuleType
from typing import Literal, NamedTuple, TypeAlias, get_args

import numpy as np
from numpy.typing import ArrayLike

from radartrack.generated import polar as polar_formulas
from radartrack.validation import (
    ANGLE,
    ANGLE_STD,
    CORRELATION,
    RANGE,
    Domain,
    RealArray,
    broadcast_shape,
    one_of,
    real_arrays,
    require_covariance,
    require_trailing_shape,
    require_within,
)

Method: TypeAlias = Literal["linear", "second_order", "averaged", "unbiased", "posterior", "decorrelated"]
AzimuthFrom: TypeAlias = Literal["x", "y"]
Prediction: TypeAlias = tuple[ArrayLike, ArrayLike]


class Converted(NamedTuple):
    """Cartesian means, shape (..., n), and the covariances of their errors, shape (..., n, n)."""

    mean: RealArray
    covariance: RealArray


class _Words(NamedTuple):
    """The generated functions of a method; its mean is the estimate less the bias."""

    estimate: str
    bias: str | None
    covariance: str
    needs_prediction: bool = False


_METHODS: Mapping[Method, _Words] = {
    "linear": _Words("map", None, "covariance_linear"),
    "second_order": _Words("map", "bias_second_order", "covariance_second_order"),
    "averaged": _Words("map", "bias_averaged", "covariance_averaged"),
    "unbiased": _Words("unbiased_estimate", None, "unbiased_covariance"),
    "posterior": _Words("posterior_estimate", None, "posterior_covariance"),
    "decorrelated": _Words("unbiased_estimate", None, "decorrelated_covariance", needs_prediction=True),
}


class _Argument(NamedTuple):
    """A public argument: its symbol in the formulas, and the values it may have."""

    symbol: str
    domain: Domain


@dataclass(frozen=True, slots=True)
class _Sensor:
    """The public arguments of a measurement model, by name, and the formulas for it.

    The noise is the standard deviations of the coordinates, in their order, and a correlation.
    """

    formulas: ModuleType
    azimuth_from: AzimuthFrom
    coordinates: Mapping[str, _Argument]
    noise: Mapping[str, _Argument]


class _Input(NamedTuple):
    """The values for a symbol of the formulas, and their name in error messages."""

    name: str
    symbol: str
    domain: Domain
    values: RealArray


_POLAR = _Sensor(
    formulas=polar_formulas,
    azimuth_from="x",
    coordinates={"r": _Argument("r", RANGE), "azimuth": _Argument("beta", ANGLE)},
    noise={
        "range_std": _Argument("sigma_r", RANGE),
        "azimuth_std": _Argument("sigma_beta", ANGLE_STD),
        "correlation": _Argument("rho", CORRELATION),
    },
)


def polar(
    r: ArrayLike,
    azimuth: ArrayLike,
    range_std: ArrayLike,
    azimuth_std: ArrayLike,
    correlation: ArrayLike = 0.0,
    method: Method = "unbiased",
    azimuth_from: AzimuthFrom = "x",
    *,
    predicted: Prediction | None = None,
) -> Converted:
    """Convert range and azimuth to x and y.

    The arguments broadcast to the leading shape of the result. It is float32 where every array given is, and
    float64 otherwise.

    Args:
        r: measured range [m], from 0 to 1e100, in float32 to 1e10.
        azimuth: measured azimuth [rad], wrapped or not, from -1e6 to 1e6, in float32 from -1e3 to 1e3.
        range_std: standard deviation of the range [m], from 0 to 1e100, in float32 to 1e10.
        azimuth_std: standard deviation of the azimuth [rad], from 0 to pi.
        correlation: correlation of the errors of range and azimuth, from -1 to 1.
        method: which mean and covariance:
            "linear", the plain conversion and the covariance of first order;
            "second_order", less the bias of second order, and the covariance of second order (Prosov, (7));
            "averaged", less the bias averaged given the measurement, and the covariance averaged likewise
            (Lerro and Bar-Shalom 1993; Prosov, (10) and (11));
            "unbiased", the estimate whose expectation is the true position (Mo et al. 1998);
            "posterior", mean and covariance of the position given the measurement (Duan et al. 2004);
            "decorrelated", the unbiased estimate, and a covariance from a prediction, so that the error of a
            plot does not sway its own weight (Bordonaro et al. 2014).
        azimuth_from: "x", counter-clockwise from the x axis, or "y", clockwise from the y axis (compass).
        predicted: for the method "decorrelated", and only for it, a pair: the predicted range [m] and azimuth
            [rad], shape (..., 2), the azimuth counted like the measured one, and their covariance, shape
            (..., 2, 2). A correlation that rounding has made larger than 1 counts as 1.

    Returns:
        Mean [m], shape (..., 2), and covariance [m^2], shape (..., 2, 2), of x and y.

    Raises:
        TypeError: an argument is not made of real numbers (a bool is none), or `predicted` is no pair.
        ValueError: a number is not finite or lies outside the interval above, the shapes do not broadcast, a
            word is unknown, the predicted covariance is none, or a prediction is given without a use for it.

    """
    given = {
        "r": r,
        "azimuth": azimuth,
        "range_std": range_std,
        "azimuth_std": azimuth_std,
        "correlation": correlation,
    }
    return _convert(_POLAR, given, method, azimuth_from, predicted)


def _convert(
    sensor: _Sensor,
    given: Mapping[str, ArrayLike],
    method: Method,
    azimuth_from: AzimuthFrom,
    predicted: Prediction | None,
) -> Converted:
    words = _METHODS[one_of("method", method, _METHODS)]
    turned = one_of("azimuth_from", azimuth_from, get_args(AzimuthFrom)) != sensor.azimuth_from
    arrays = real_arrays({**given, **_predicted_arguments(method, words, predicted)})
    plot = _plot_inputs(sensor, arrays)
    prediction = _prediction_inputs(sensor, arrays) if words.needs_prediction else []
    shape = _checked_shape([*plot, *prediction])
    converted = _evaluate(sensor, words, plot, prediction)
    return _spread(_swap_x_and_y(converted) if turned else converted, shape)


def _predicted_arguments(
    method: Method, words: _Words, predicted: Prediction | None
) -> Mapping[str, ArrayLike]:
    if not words.needs_prediction:
        if predicted is not None:
            raise ValueError(f"predicted must be None for method {method!r}; got {reprlib.repr(predicted)}")
        return {}
    if not isinstance(predicted, (tuple, list)) or len(predicted) != 2:
        allowed = f"a pair (mean, covariance) for method {method!r}"
        raise TypeError(f"predicted must be {allowed}; got {reprlib.repr(predicted)}")
    return {"predicted mean": predicted[0], "predicted covariance": predicted[1]}


def _plot_inputs(sensor: _Sensor, arrays: Mapping[str, RealArray]) -> list[_Input]:
    arguments = {**sensor.coordinates, **sensor.noise}
    return [_Input(name, *argument, arrays[name]) for name, argument in arguments.items()]


def _prediction_inputs(sensor: _Sensor, arrays: Mapping[str, RealArray]) -> list[_Input]:
    """The predicted coordinates, in the place of the measured ones, and the prediction's own noise."""
    mean, covariance = arrays["predicted mean"], arrays["predicted covariance"]
    size = len(sensor.coordinates)
    require_trailing_shape("predicted mean", mean, (size,))
    require_trailing_shape("predicted covariance", covariance, (size, size))
    require_covariance("predicted covariance", covariance)
    coordinates = [
        _Input(f"{name} of predicted mean", symbol, domain, values)
        for (name, (symbol, domain)), values in zip(
            sensor.coordinates.items(), np.moveaxis(mean, -1, 0), strict=True
        )
    ]
    noise = [
        _Input(f"{name} of predicted covariance", f"predicted_{symbol}", domain, values)
        for (name, (symbol, domain)), values in zip(sensor.noise.items(), _noise_of(covariance), strict=True)
    ]
    return coordinates + noise


def _noise_of(covariance: RealArray) -> list[RealArray]:
    """Standard deviations, and the correlation: 0 beside a zero variance, at most 1 despite rounding."""
    deviations = np.sqrt(np.diagonal(covariance, axis1=-2, axis2=-1))
    first, second = deviations[..., 0], deviations[..., 1]
    quotient = covariance[..., 0, 1] / np.where(first > 0, first, 1) / np.where(second > 0, second, 1)
    return [*np.moveaxis(deviations, -1, 0), np.clip(quotient, -1, 1)]


def _checked_shape(inputs: Sequence[_Input]) -> tuple[int, ...]:
    for name, _, domain, values in inputs:
        require_within(name, values, domain)
    return broadcast_shape({name: values for name, _, _, values in inputs})


def _evaluate(
    sensor: _Sensor, words: _Words, plot: Sequence[_Input], prediction: Sequence[_Input]
) -> Converted:
    measured = {symbol: values for _, symbol, _, values in plot}
    expected = {symbol: values for _, symbol, _, values in prediction}
    mean = _evaluate_word(sensor, words.estimate, measured)
    if words.bias is not None:
        mean = mean - _evaluate_word(sensor, words.bias, measured)
    return Converted(mean, _evaluate_word(sensor, words.covariance, {**measured, **expected}))


def _evaluate_word(sensor: _Sensor, word: str, values: Mapping[str, RealArray]) -> RealArray:
    function: Callable[..., RealArray] = getattr(sensor.formulas, word)
    if word == "map":
        return function(**{symbol: values[symbol] for symbol, _ in sensor.coordinates.values()})
    return function(**values)


def _swap_x_and_y(converted: Converted) -> Converted:
    mean, covariance = converted
    size = mean.shape[-1]
    order = [1, 0, *range(2, size)]
    entries = np.arange(size**2).reshape(size, size)[np.ix_(order, order)]
    flat = covariance.reshape(*covariance.shape[:-2], size**2)
    return Converted(mean.take(order, axis=-1), flat.take(entries, axis=-1))


def _spread(converted: Converted, shape: tuple[int, ...]) -> Converted:
    """Both with the leading shape of all the arguments together, and writable."""
    size = converted.mean.shape[-1]
    return Converted(_full(converted.mean, (*shape, size)), _full(converted.covariance, (*shape, size, size)))


def _full(array: RealArray, shape: tuple[int, ...]) -> RealArray:
    return array if array.shape == shape else np.broadcast_to(array, shape).copy()
