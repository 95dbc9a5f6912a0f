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

Covariances are symmetric and, within 16 units in the last place of their correlations, positive semidefinite. A
variance below 4.5e-277, in float32 1.2e-38, is 0, and its covariances with it.
"""

import math
import reprlib
from collections.abc import Callable, Mapping
from typing import Any, Literal, NamedTuple, TypeAlias, get_args

import numpy as np
from numpy.typing import ArrayLike

from radartrack._arrays import machine_code, semidefinite
from radartrack._arrays.batches import BLOCK, fill
from radartrack._arrays.one_plot import one_plot
from radartrack._arrays.prediction import COVARIANCE, MEAN, Predicted, Prediction, prediction_arguments
from radartrack._arrays.sensors import SENSORS, AzimuthFrom, Sensor
from radartrack._arrays.validation import RealArray, broadcast_shape, common_shape, one_of, real_arrays
from radartrack.generated import conversions

Method: TypeAlias = Literal["linear", "second_order", "averaged", "unbiased", "posterior", "decorrelated"]


class Converted(NamedTuple):
    """Cartesian means, shape (..., n), and the covariances of their errors, shape (..., n, n)."""

    mean: RealArray
    covariance: RealArray


_METHODS: tuple[Method, ...] = get_args(Method)
_NEEDS_PREDICTION = "decorrelated"
PREDICTED_BLOCK = 16384  # plots; the average over a prediction has ten times as many intermediate results
_AXES = {MEAN: 1, COVARIANCE: 2}  # of one plot; of what is measured it is a number


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
            word is unknown, the predicted covariance is none, a prediction is given without a use for it, or
            formulas give what is, beyond rounding, no covariance.

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
    1 is right; at eight deviations up to 1.07. The covariances are those series completed to sums of squares, so
    that they are positive semidefinite up to the edge and for any deviation of the range.

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
    prediction = _predicted_arguments(method, predicted)
    if not prediction and (found := one_plot(sensor, method, given)) is not None:
        return Converted(*_turned(*found)) if turned else Converted(*found)
    arrays = real_arrays({**given, **prediction})
    try:
        return _computed(sensor, method, arrays, turned=turned)
    except ValueError:  # from one block; the message is about all
        _checked(sensor, arrays)
        raise


def _predicted_arguments(method: Method, predicted: Prediction | None) -> Mapping[str, ArrayLike]:
    if method == _NEEDS_PREDICTION:
        return prediction_arguments(predicted)
    if predicted is not None:
        raise ValueError(f"predicted must be None for method {method!r}; got {reprlib.repr(predicted)}")
    return {}


def _computed(sensor: Sensor, method: Method, arrays: Mapping[str, RealArray], *, turned: bool) -> Converted:
    """In blocks, each of which is checked while it is in the cache."""
    size = len(sensor.coordinates)  # as many coordinates as there are measured quantities
    axes = {name: _AXES.get(name, 0) for name in arrays}
    shape = common_shape(array.shape[: array.ndim - axes[name]] for name, array in arrays.items())
    count, dtype = math.prod(shape), arrays["r"].dtype
    mean, covariance = np.empty((count, size), dtype), np.empty((count, size, size), dtype)
    function, block = _function(sensor, method, count, dtype)
    flat = {name: _flat(array, shape, axes[name]) for name, array in arrays.items()}
    varying = {name: array for name, array in flat.items() if array.ndim > axes[name]}

    def convert(*parts: RealArray) -> None:
        *inputs, means, covariances = parts
        measured, prediction = _checked(sensor, flat | dict(zip(varying, inputs, strict=True)))
        function(*measured.values(), means, covariances)
        if prediction is not None:
            covariances[...] = _decorrelated(sensor, measured, prediction)
        _make_sound(sensor, method, measured, prediction, covariances)
        if turned:
            means[...], covariances[...] = _turned(means, covariances)

    fill(convert, [*varying.values()], [mean, covariance], block)
    return Converted(mean.reshape(*shape, size), covariance.reshape(*shape, size, size))


def _checked(sensor: Sensor, arrays: Mapping[str, RealArray]) -> tuple[dict[str, RealArray], Predicted | None]:
    """What was measured, by symbol, and the prediction, if there is one.

    Raises:
        ValueError: a value is out of place, or the shapes do not broadcast.

    """
    plot = {name: arrays[name] for name in sensor.arguments}
    measured = sensor.read(plot)
    if MEAN not in arrays:
        return measured, None
    prediction = Predicted(sensor, arrays[MEAN], arrays[COVARIANCE])
    prediction.require_valid()
    broadcast_shape({**plot, **prediction.named()})
    prediction.require_possible(measured)
    return measured, prediction


def _function(sensor: Sensor, method: Method, count: int, dtype: np.dtype[Any]) -> tuple[Callable[..., None], int]:
    """The conversion without a prediction, and the size of its blocks; compiled where that is worth while."""
    decorrelated = method == _NEEDS_PREDICTION
    name = f"{sensor.module}_{'unbiased' if decorrelated else method}"
    function, block = getattr(conversions, name), BLOCK
    if count >= machine_code.COMPILED_FROM and dtype == np.float64 and machine_code.is_available():
        fast = machine_code.conversion(name)
        function, block = (function, block) if fast is None else (fast, machine_code.BLOCK)
    return function, PREDICTED_BLOCK if decorrelated else block


def _decorrelated(sensor: Sensor, measured: Mapping[str, RealArray], prediction: Predicted) -> RealArray:
    word = "decorrelated_covariance"
    parts = ((weight, sensor.evaluate(word, {**measured, **part})) for weight, part in prediction.parts())
    weight, first = next(parts)
    return sum((weight * covariance for weight, covariance in parts), start=weight * first)


def _make_sound(
    sensor: Sensor,
    method: Method,
    measured: Mapping[str, RealArray],
    prediction: Predicted | None,
    covariances: RealArray,
) -> None:
    """Compute those covariances again, with care, of which rounding may have made something else."""
    values = measured if prediction is None else {**prediction.symbols(), **measured}
    if semidefinite.are_plain(values, covariances):
        return
    doubtful = ~semidefinite.are_sound(covariances)
    if doubtful.any():
        few = {symbol: array[doubtful] if array.ndim else array for symbol, array in measured.items()}
        part = None if prediction is None else prediction.only(doubtful)
        covariances[doubtful] = _with_care(sensor, method, few, part, covariances[doubtful])


def _with_care(
    sensor: Sensor,
    method: Method,
    measured: Mapping[str, RealArray],
    prediction: Predicted | None,
    like: RealArray,
) -> RealArray:
    """Covariances in float64 and, where that is not enough, the nearest that are positive semidefinite."""
    wide = {symbol: semidefinite.without_nothing(array) for symbol, array in measured.items()}

    def computed(**other: RealArray) -> RealArray:
        values, covariances = {**wide, **other}, np.empty(like.shape)
        if prediction is None:
            getattr(conversions, f"{sensor.module}_{method}")(*values.values(), np.empty(like.shape[:-1]), covariances)
        else:
            covariances[...] = _decorrelated(sensor, values, prediction)
        return semidefinite.cast(covariances, covariances.dtype)

    covariances = computed()
    doubtful = ~semidefinite.are_sound(covariances)
    if doubtful.any():
        independent = computed(rho=np.zeros(()))
        covariances[doubtful] = semidefinite.nearest(covariances[doubtful], independent[doubtful])
    return semidefinite.cast(covariances, like.dtype)


def _flat(array: RealArray, shape: tuple[int, ...], axes: int) -> RealArray:
    """One axis of plots before the array's own axes; none where all plots share the value."""
    if array.ndim == axes + 1 and array.shape[:1] == shape:
        return array
    own = array.shape[array.ndim - axes :]
    if array.size == math.prod(own):
        return array.reshape(own)
    spread = array if array.shape == (*shape, *own) else np.broadcast_to(array, (*shape, *own))
    return spread.reshape(-1, *own)


def _order(size: int) -> list[int]:
    """The coordinates with x and y exchanged."""
    return [1, 0, *range(2, size)]


def _turned(mean: RealArray, covariance: RealArray) -> tuple[RealArray, RealArray]:
    """With x and y exchanged, where the azimuth is counted from the other axis."""
    order = _order(mean.shape[-1])
    return mean[..., order], covariance[..., order, :][..., order]
