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

import math
import reprlib
from collections.abc import Callable, Mapping
from typing import Any, Literal, NamedTuple, TypeAlias, get_args

import numpy as np
from numpy.typing import ArrayLike

from radartrack import compiled
from radartrack.batches import fill
from radartrack.generated import conversions
from radartrack.prediction import COVARIANCE, MEAN, Predicted, Prediction, prediction_arguments
from radartrack.sensors import SENSORS, AzimuthFrom, Sensor
from radartrack.validation import RealArray, broadcast_shape, one_of, real_arrays

Method: TypeAlias = Literal["linear", "second_order", "averaged", "unbiased", "posterior", "decorrelated"]


class Converted(NamedTuple):
    """Cartesian means, shape (..., n), and the covariances of their errors, shape (..., n, n)."""

    mean: RealArray
    covariance: RealArray


_METHODS: tuple[Method, ...] = get_args(Method)
_NEEDS_PREDICTION = "decorrelated"


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
    return _convert(SENSORS["polar"], given, method, predicted, azimuth_from)


def spherical(
    r: ArrayLike,
    azimuth: ArrayLike,
    elevation: ArrayLike,
    range_std: ArrayLike,
    azimuth_std: ArrayLike,
    elevation_std: ArrayLike,
    correlation: ArrayLike = 0.0,
    method: Method = "unbiased",
    azimuth_from: AzimuthFrom = "y",
    *,
    predicted: Prediction | None = None,
) -> Converted:
    """Convert range, azimuth and elevation to x, y and z.

    The arguments broadcast to the leading shape of the result. It is float32 where every array given is, and
    float64 otherwise.

    Args:
        r: measured range [m], from 0 to 1e100, in float32 to 1e10.
        azimuth: measured azimuth [rad], wrapped or not, from -1e6 to 1e6, in float32 from -1e3 to 1e3.
        elevation: measured elevation [rad], up from the horizontal plane, from -pi/2 to pi/2.
        range_std: standard deviation of the range [m], from 0 to 1e100, in float32 to 1e10.
        azimuth_std: standard deviation of the azimuth [rad], from 0 to pi.
        elevation_std: standard deviation of the elevation [rad], from 0 to pi.
        correlation: correlation of the errors of range and azimuth, from -1 to 1.
        method: which mean and covariance, as for `polar`.
        azimuth_from: "y", clockwise from the y axis (compass), or "x", counter-clockwise from the x axis.
        predicted: for the method "decorrelated", and only for it, a pair: the predicted range [m], azimuth [rad]
            and elevation [rad], shape (..., 3), the azimuth counted like the measured one, and their covariance,
            shape (..., 3, 3), with any correlations.

    Returns:
        Mean [m], shape (..., 3), and covariance [m^2], shape (..., 3, 3), of x, y and z.

    Raises:
        TypeError: as for `polar`.
        ValueError: as for `polar`.

    """
    given = {
        "r": r,
        "azimuth": azimuth,
        "elevation": elevation,
        "range_std": range_std,
        "azimuth_std": azimuth_std,
        "elevation_std": elevation_std,
        "correlation": correlation,
    }
    return _convert(SENSORS["spherical"], given, method, predicted, azimuth_from)


def polar_doppler(
    r: ArrayLike,
    azimuth: ArrayLike,
    range_rate: ArrayLike,
    range_std: ArrayLike,
    azimuth_std: ArrayLike,
    range_rate_std: ArrayLike,
    correlation: ArrayLike = 0.0,
    method: Method = "unbiased",
    azimuth_from: AzimuthFrom = "x",
    *,
    predicted: Prediction | None = None,
) -> Converted:
    """Convert range, azimuth and range rate to x, y and the pseudo-measurement eta, range times range rate.

    Of a target with the velocity (vx, vy), eta is x vx + y vy, which has no root and no quotient.
    The arguments broadcast to the leading shape of the result. It is float32 where every array given is, and
    float64 otherwise.

    Args:
        r: measured range [m], from 0 to 1e100, in float32 to 1e10.
        azimuth: measured azimuth [rad], wrapped or not, from -1e6 to 1e6, in float32 from -1e3 to 1e3.
        range_rate: measured range rate [m/s], positive for a receding target, from -1e50 to 1e50, in float32
            from -1e8 to 1e8.
        range_std: standard deviation of the range [m], from 0 to 1e100, in float32 to 1e10.
        azimuth_std: standard deviation of the azimuth [rad], from 0 to pi.
        range_rate_std: standard deviation of the range rate [m/s], from 0 to 1e50, in float32 to 1e8.
        correlation: correlation of the errors of range and range rate, from -1 to 1.
        method: which mean and covariance, as for `polar` (eta from Duan et al. 2005).
        azimuth_from: "x", counter-clockwise from the x axis, or "y", clockwise from the y axis (compass).
        predicted: for the method "decorrelated", and only for it, a pair: the predicted range [m], azimuth [rad]
            and range rate [m/s], shape (..., 3), the azimuth counted like the measured one, and their covariance,
            shape (..., 3, 3), with any correlations.

    Returns:
        Mean [m, m, m^2/s], shape (..., 3), and covariance, shape (..., 3, 3), of x, y and eta.

    Raises:
        TypeError: as for `polar`.
        ValueError: as for `polar`.

    """
    given = {
        "r": r,
        "azimuth": azimuth,
        "range_rate": range_rate,
        "range_std": range_std,
        "azimuth_std": azimuth_std,
        "range_rate_std": range_rate_std,
        "correlation": correlation,
    }
    return _convert(SENSORS["polar_doppler"], given, method, predicted, azimuth_from)


def ruv(
    r: ArrayLike,
    u: ArrayLike,
    v: ArrayLike,
    range_std: ArrayLike,
    u_std: ArrayLike,
    v_std: ArrayLike,
    correlation: ArrayLike = 0.0,
    method: Method = "unbiased",
    *,
    predicted: Prediction | None = None,
) -> Converted:
    """Convert range and two direction cosines to x, y and z, z along the normal of the array.

    The root in z = r sqrt(1 - u^2 - v^2) has no closed forms: the methods after "second_order" are series to the
    fourth order in the deviations. The accuracy of the generated functions is measured for |u| and |v| up to 0.6.
    Towards the edge of the unit circle the series converge slowly: at the five deviations from it demanded below,
    where the range is known well, the average normalised error squared is up to 1.27, for "unbiased" 1.09, where
    1 is right; at eight deviations up to 1.07. The covariances are positive semidefinite up to the edge.

    The arguments broadcast to the leading shape of the result. It is float32 where every array given is, and
    float64 otherwise.

    Args:
        r: measured range [m], from 0 to 1e100, in float32 to 1e10.
        u: measured direction cosine along the x axis.
        v: measured direction cosine along the y axis; sqrt(u^2 + v^2) + 5 max(u_std, v_std) is at most 0.999.
        range_std: standard deviation of the range [m], from 0 to 1e100, in float32 to 1e10.
        u_std: standard deviation of u.
        v_std: standard deviation of v.
        correlation: correlation of the errors of u and v, from -1 to 1.
        method: which mean and covariance, as for `polar` (with direction cosines, Bar-Shalom, Willett and Tian
            2011).
        predicted: for the method "decorrelated", and only for it, a pair: the predicted range [m], u and v,
            shape (..., 3), and their covariance, shape (..., 3, 3), with any correlations. The predicted u and v
            keep the same distance from the edge, with the deviations of prediction and measurement together.

    Returns:
        Mean [m], shape (..., 3), and covariance [m^2], shape (..., 3, 3), of x, y and z.

    Raises:
        TypeError: as for `polar`.
        ValueError: as for `polar`; also where the direction is too near the edge of the unit circle.

    """
    given = {
        "r": r,
        "u": u,
        "v": v,
        "range_std": range_std,
        "u_std": u_std,
        "v_std": v_std,
        "correlation": correlation,
    }
    return _convert(SENSORS["ruv"], given, method, predicted)


def _convert(
    sensor: Sensor,
    given: Mapping[str, ArrayLike],
    method: Method,
    predicted: Prediction | None,
    azimuth_from: AzimuthFrom | None = None,
) -> Converted:
    one_of("method", method, _METHODS)
    turned = sensor.is_turned(azimuth_from)
    arrays = real_arrays({**given, **_predicted_arguments(method, predicted)})
    plot = {name: arrays[name] for name in given}
    measured = sensor.read(plot)
    prediction = Predicted(sensor, arrays[MEAN], arrays[COVARIANCE]) if method == _NEEDS_PREDICTION else None
    shape = broadcast_shape({**plot, **(prediction.named() if prediction else {})})
    converted = _computed(sensor, method if prediction is None else "unbiased", measured, shape, turned=turned)
    if prediction is not None:
        converted.covariance[...] = _swapped(_decorrelated(sensor, measured, prediction), turned=turned)
    return converted


def _predicted_arguments(method: Method, predicted: Prediction | None) -> Mapping[str, ArrayLike]:
    if method == _NEEDS_PREDICTION:
        return prediction_arguments(predicted)
    if predicted is not None:
        raise ValueError(f"predicted must be None for method {method!r}; got {reprlib.repr(predicted)}")
    return {}


def _computed(
    sensor: Sensor, method: Method, measured: Mapping[str, RealArray], shape: tuple[int, ...], *, turned: bool
) -> Converted:
    dtype = measured["r"].dtype
    count, size = math.prod(shape), len(sensor.coordinates)  # as many coordinates as there are measured quantities
    mean, covariance = np.empty((count, size), dtype), np.empty((count, size, size), dtype)
    function = _function(f"{sensor.module}_{method}", count, dtype)

    def convert(*arrays: RealArray) -> None:
        function(*arrays)
        if turned:
            *_, means, covariances = arrays
            means[...] = means.take(_order(size), axis=-1)
            covariances[...] = _swapped(covariances, turned=True)

    fill(convert, [_flat(array, shape) for array in measured.values()], [mean, covariance])
    return Converted(mean.reshape(*shape, size), covariance.reshape(*shape, size, size))


def _function(name: str, count: int, dtype: np.dtype[Any]) -> Callable[..., None]:
    """Compiled where that is installed and worth while."""
    if count >= compiled.COMPILED_FROM and dtype == np.float64 and compiled.is_available():
        return compiled.conversion(name)
    function: Callable[..., None] = getattr(conversions, name)
    return function


def _decorrelated(sensor: Sensor, measured: Mapping[str, RealArray], prediction: Predicted) -> RealArray:
    prediction.require_possible(measured)
    word = "decorrelated_covariance"
    parts = ((weight, sensor.evaluate(word, {**measured, **part})) for weight, part in prediction.parts())
    weight, first = next(parts)
    return sum((weight * covariance for weight, covariance in parts), start=weight * first)


def _flat(array: RealArray, shape: tuple[int, ...]) -> RealArray:
    """One axis, or none where all plots share the value."""
    return array.reshape(()) if array.size == 1 else np.broadcast_to(array, shape).reshape(-1)


def _order(size: int) -> list[int]:
    """The coordinates with x and y exchanged."""
    return [1, 0, *range(2, size)]


def _swapped(covariance: RealArray, *, turned: bool) -> RealArray:
    """With x and y exchanged, where the azimuth is counted from the other axis."""
    if not turned:
        return covariance
    order = _order(covariance.shape[-1])
    return covariance[..., order, :][..., order]
