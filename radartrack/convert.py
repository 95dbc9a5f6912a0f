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

from collections.abc import Mapping
from typing import Literal, NamedTuple, TypeAlias, get_args

from numpy.typing import ArrayLike

from radartrack._arrays.validation import RealArray, one_of
from radartrack._conversion.many_plots import many_plots
from radartrack._conversion.one_plot import one_plot
from radartrack._conversion.prediction import Prediction
from radartrack._conversion.sensors import SENSORS, AzimuthFrom, Sensor
from radartrack._conversion.way import Way

__all__ = [
    "Converted",
    "Method",
    "bistatic",
    "polar",
    "polar_doppler",
    "ruv",
    "spherical",
    "spherical_doppler",
]


def __dir__() -> list[str]:
    return __all__


Method: TypeAlias = Literal["linear", "second_order", "averaged", "unbiased", "posterior", "decorrelated"]


class Converted(NamedTuple):
    """Cartesian means, shape (..., n), and the covariances of their errors, shape (..., n, n)."""

    mean: RealArray
    covariance: RealArray


_METHODS: tuple[Method, ...] = get_args(Method)


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


def spherical_doppler(
    r: ArrayLike,
    azimuth: ArrayLike,
    elevation: ArrayLike,
    range_rate: ArrayLike,
    range_std: ArrayLike,
    azimuth_std: ArrayLike,
    elevation_std: ArrayLike,
    range_rate_std: ArrayLike,
    correlation: ArrayLike = 0.0,
    method: Method = "unbiased",
    azimuth_from: AzimuthFrom = "y",
    *,
    predicted: Prediction | None = None,
) -> Converted:
    """Convert range, azimuth, elevation and range rate to x, y, z and eta, range times range rate.

    Of a target with the velocity (vx, vy, vz), eta is x vx + y vy + z vz, which has no root and no quotient.
    The arguments broadcast to the leading shape of the result. It is float32 where every array given is, and
    float64 otherwise.

    Args:
        r: measured range [m], from 0 to 1e100, in float32 to 1e10.
        azimuth: measured azimuth [rad], wrapped or not, from -1e6 to 1e6, in float32 from -1e3 to 1e3.
        elevation: measured elevation [rad], up from the horizontal plane, from -pi/2 to pi/2.
        range_rate: measured range rate [m/s], positive for a receding target, from -1e50 to 1e50, in float32
            from -1e8 to 1e8.
        range_std: standard deviation of the range [m], from 0 to 1e100, in float32 to 1e10.
        azimuth_std: standard deviation of the azimuth [rad], from 0 to pi.
        elevation_std: standard deviation of the elevation [rad], from 0 to pi.
        range_rate_std: standard deviation of the range rate [m/s], from 0 to 1e50, in float32 to 1e8.
        correlation: correlation of the errors of range and range rate, from -1 to 1.
        method: which mean and covariance, as for `polar` (eta from Duan et al. 2005).
        azimuth_from: "y", clockwise from the y axis (compass), or "x", counter-clockwise from the x axis.
        predicted: for the method "decorrelated", and only for it, a pair: the predicted range [m], azimuth [rad],
            elevation [rad] and range rate [m/s], shape (..., 4), the azimuth counted like the measured one, and
            their covariance, shape (..., 4, 4), with any correlations.

    Returns:
        Mean [m, m, m, m^2/s], shape (..., 4), and covariance, shape (..., 4, 4), of x, y, z and eta.

    Raises:
        TypeError: as for `polar`.
        ValueError: as for `polar`.

    """
    given = {
        "r": r,
        "azimuth": azimuth,
        "elevation": elevation,
        "range_rate": range_rate,
        "range_std": range_std,
        "azimuth_std": azimuth_std,
        "elevation_std": elevation_std,
        "range_rate_std": range_rate_std,
        "correlation": correlation,
    }
    return _convert(SENSORS["spherical_doppler"], given, method, predicted, azimuth_from)


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


def bistatic(
    path: ArrayLike,
    azimuth: ArrayLike,
    baseline: ArrayLike,
    path_std: ArrayLike,
    azimuth_std: ArrayLike,
    correlation: ArrayLike = 0.0,
    method: Method = "unbiased",
    azimuth_from: AzimuthFrom = "x",
    *,
    predicted: Prediction | None = None,
) -> Converted:
    """Convert the path from transmitter to target to receiver, and the azimuth at the receiver, to x and y.

    The receiver is at the origin, the transmitter on the axis that the azimuth is counted from. The range from the
    receiver, (path^2 - baseline^2)/(2 (path - baseline cos azimuth)), has no closed forms: the methods after
    "second_order" are series to the fourth order in the deviations, their covariances completed to sums of squares.
    Near the baseline they converge slowly, which the intervals below keep off.

    The arguments broadcast to the leading shape of the result. It is float32 where every array given is, and
    float64 otherwise.

    Args:
        path: measured length of the path [m], from 1e-30 to 1e100, in float32 to 1e10.
        azimuth: measured azimuth [rad], wrapped or not, from -1e6 to 1e6, in float32 from -1e3 to 1e3; 0 is where the
            transmitter stands.
        baseline: distance from transmitter to receiver [m], at least 0; baseline + 5 path_std is at most 0.999 path.
        path_std: standard deviation of the path [m].
        azimuth_std: standard deviation of the azimuth [rad], from 0 to 0.5, and to arccosh(path/baseline)/5.
        correlation: correlation of the errors of path and azimuth, from -1 to 1.
        method: which mean and covariance, as for `polar` (Willis 1991, bistatic triangle).
        azimuth_from: "x", counter-clockwise from the x axis, or "y", clockwise from the y axis (compass).
        predicted: for the method "decorrelated", and only for it, a pair: the predicted path [m] and azimuth [rad],
            shape (..., 2), the azimuth counted like the measured one, and their covariance, shape (..., 2, 2). They
            keep off the baseline likewise, with the deviations of prediction and measurement together.

    Returns:
        Mean [m], shape (..., 2), and covariance [m^2], shape (..., 2, 2), of x and y.

    Raises:
        TypeError: as for `polar`.
        ValueError: as for `polar`; also where the plot is too near the baseline for its deviations.

    """
    given = {
        "path": path,
        "azimuth": azimuth,
        "baseline": baseline,
        "path_std": path_std,
        "azimuth_std": azimuth_std,
        "correlation": correlation,
    }
    return _convert(SENSORS["bistatic"], given, method, predicted, azimuth_from)


def _convert(
    sensor: Sensor,
    given: Mapping[str, ArrayLike],
    method: Method,
    predicted: Prediction | None,
    azimuth_from: AzimuthFrom | None = None,
) -> Converted:
    """Check the words, then the numbers, then compute: plain numbers at once, arrays in blocks."""
    way = Way.chosen(sensor, one_of("method", method, _METHODS), predicted, azimuth_from)
    found = one_plot(way, given)
    return Converted(*(many_plots(way, given) if found is None else found))
