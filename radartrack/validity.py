"""Where linear or second-order formulas are good enough, plot by plot.

Each function gives, for each measured quantity, the root mean square of the leading term that the formulas
neglect, brought back to that quantity, over its standard deviation. Far below 1 the formulas will do; near 1 and
above they will not. Along range the linear polar conversion neglects sqrt(3)/2 r azimuth_std^2/range_std. The
ratios do not depend on how the axes lie, nor on where the azimuth is counted from.
"""

from collections.abc import Mapping
from typing import Any, Literal, TypeAlias, get_args

import numpy as np
from numpy.typing import ArrayLike

from radartrack._arrays.validation import Domain, RealArray, one_of, real_arrays, require_within
from radartrack._conversion.sensors import SENSORS, AzimuthFrom, SensorName

__all__ = ["bistatic", "polar", "polar_doppler", "ruv", "spherical", "spherical_doppler"]


def __dir__() -> list[str]:
    return __all__


Formulas: TypeAlias = Literal["linear", "second_order"]

SMALLEST, LARGEST = 1e-30, 1e30


def polar(
    r: ArrayLike,
    azimuth: ArrayLike,
    range_std: ArrayLike,
    azimuth_std: ArrayLike,
    correlation: ArrayLike = 0.0,
    formulas: Formulas = "linear",
    azimuth_from: AzimuthFrom = "x",
) -> RealArray:
    """Tell what formulas neglect for range and azimuth.

    The arguments broadcast. The result is float32 where every array given is, and float64 otherwise.

    Args:
        r: range [m].
        azimuth: azimuth [rad], from -1e6 to 1e6, in float32 from -1e3 to 1e3.
        range_std: standard deviation of the range [m].
        azimuth_std: standard deviation of the azimuth [rad], to pi.
        correlation: correlation of the errors of range and azimuth, from -1 to 1.
        formulas: "linear", whose leading neglected term is of second order, or "second_order", of third (Prosov,
            the question of validity). Range and deviations are from 1e-30 to 1e30.
        azimuth_from: "x", counter-clockwise from the x axis, or "y", clockwise from the y axis (compass); the ratios
            are the same.

    Returns:
        Ratios for range and azimuth, shape (..., 2).

    Raises:
        TypeError: an argument is not made of real numbers.
        ValueError: a number is not finite or lies outside the interval above, the shapes do not broadcast, a word
            is unknown, or a ratio is too large for float32.

    """
    given = {
        "r": r,
        "azimuth": azimuth,
        "range_std": range_std,
        "azimuth_std": azimuth_std,
        "correlation": correlation,
    }
    return _ratios("polar", given, formulas, azimuth_from)


def spherical(
    r: ArrayLike,
    azimuth: ArrayLike,
    elevation: ArrayLike,
    range_std: ArrayLike,
    azimuth_std: ArrayLike,
    elevation_std: ArrayLike,
    correlation: ArrayLike = 0.0,
    formulas: Formulas = "linear",
    azimuth_from: AzimuthFrom = "y",
) -> RealArray:
    """Tell what formulas neglect for range, azimuth and elevation.

    Towards the vertical the ratios grow without bound: there a position does not tell the azimuth.

    Args:
        r: as for `polar`.
        azimuth: as for `polar`.
        elevation: elevation [rad], from -pi/2 to pi/2.
        range_std: as for `polar`.
        azimuth_std: as for `polar`.
        elevation_std: standard deviation of the elevation [rad], to pi.
        correlation: as for `polar`.
        formulas: as for `polar`.
        azimuth_from: as for `polar`.

    Returns:
        Ratios for range, azimuth and elevation, shape (..., 3).

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
    return _ratios("spherical", given, formulas, azimuth_from)


def polar_doppler(
    r: ArrayLike,
    azimuth: ArrayLike,
    range_rate: ArrayLike,
    range_std: ArrayLike,
    azimuth_std: ArrayLike,
    range_rate_std: ArrayLike,
    correlation: ArrayLike = 0.0,
    formulas: Formulas = "linear",
    azimuth_from: AzimuthFrom = "x",
) -> RealArray:
    """Tell what formulas neglect for range, azimuth and range rate.

    Args:
        r: as for `polar`.
        azimuth: as for `polar`.
        range_rate: range rate [m/s], from -1e30 to 1e30, in float32 from -1e8 to 1e8.
        range_std: as for `polar`.
        azimuth_std: as for `polar`.
        range_rate_std: standard deviation of the range rate [m/s].
        correlation: correlation of the errors of range and range rate, from -1 to 1.
        formulas: as for `polar`.
        azimuth_from: as for `polar`.

    Returns:
        Ratios for range, azimuth and range rate, shape (..., 3).

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
    return _ratios("polar_doppler", given, formulas, azimuth_from)


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
    formulas: Formulas = "linear",
    azimuth_from: AzimuthFrom = "y",
) -> RealArray:
    """Tell what formulas neglect for range, azimuth, elevation and range rate.

    Args:
        r: as for `polar`.
        azimuth: as for `polar`.
        elevation: as for `spherical`.
        range_rate: as for `polar_doppler`.
        range_std: as for `polar`.
        azimuth_std: as for `polar`.
        elevation_std: as for `spherical`.
        range_rate_std: as for `polar_doppler`.
        correlation: correlation of the errors of range and range rate, from -1 to 1.
        formulas: as for `polar`.
        azimuth_from: as for `polar`.

    Returns:
        Ratios for range, azimuth, elevation and range rate, shape (..., 4).

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
    return _ratios("spherical_doppler", given, formulas, azimuth_from)


def ruv(
    r: ArrayLike,
    u: ArrayLike,
    v: ArrayLike,
    range_std: ArrayLike,
    u_std: ArrayLike,
    v_std: ArrayLike,
    correlation: ArrayLike = 0.0,
    formulas: Formulas = "linear",
) -> RealArray:
    """Tell what formulas neglect for range and two direction cosines.

    Args:
        r: as for `polar`.
        u: direction cosine along the x axis.
        v: direction cosine along the y axis; sqrt(u^2 + v^2) + 5 max(u_std, v_std) is at most 0.999.
        range_std: as for `polar`.
        u_std: standard deviation of u.
        v_std: standard deviation of v.
        correlation: correlation of the errors of u and v, from -1 to 1.
        formulas: as for `polar`.

    Returns:
        Ratios for range, u and v, shape (..., 3).

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
    return _ratios("ruv", given, formulas)


def bistatic(
    path: ArrayLike,
    azimuth: ArrayLike,
    baseline: ArrayLike,
    path_std: ArrayLike,
    azimuth_std: ArrayLike,
    correlation: ArrayLike = 0.0,
    formulas: Formulas = "linear",
    azimuth_from: AzimuthFrom = "x",
) -> RealArray:
    """Tell what formulas neglect for the bistatic path and the azimuth.

    Args:
        path: from transmitter to target to receiver [m], as the conversion `bistatic` takes it.
        azimuth: azimuth at the receiver [rad], as for `polar`; 0 is where the transmitter stands.
        baseline: distance from transmitter to receiver [m], as the conversion takes it.
        path_std: standard deviation of the path [m].
        azimuth_std: standard deviation of the azimuth [rad], to 0.5.
        correlation: correlation of the errors of path and azimuth, from -1 to 1.
        formulas: as for `polar`.
        azimuth_from: as for `polar`.

    Returns:
        Ratios for path and azimuth, shape (..., 2).

    Raises:
        TypeError: as for `polar`.
        ValueError: as for `polar`; also where the conversion refuses path, baseline and deviations.

    """
    given = {
        "path": path,
        "azimuth": azimuth,
        "baseline": baseline,
        "path_std": path_std,
        "azimuth_std": azimuth_std,
        "correlation": correlation,
    }
    return _ratios("bistatic", given, formulas, azimuth_from)


def _ratios(
    name: SensorName,
    given: Mapping[str, ArrayLike],
    formulas: Formulas,
    azimuth_from: AzimuthFrom | None = None,
) -> RealArray:
    word = one_of("formulas", formulas, get_args(Formulas))
    sensor = SENSORS[name]
    sensor.is_turned(azimuth_from)  # which changes no ratio
    arrays = real_arrays(given)
    for argument, (_, domain) in {**sensor.coordinates, **sensor.noise}.items():
        if argument in {"r", "path"} or argument.endswith("_std"):
            require_within(argument, arrays[argument], _positive(domain))
        elif argument == "range_rate":
            require_within(argument, arrays[argument], domain._replace(largest=LARGEST))
    # Powers of the deviations, up to the eighth, underflow in float32.
    values = {symbol: array.astype(np.float64) for symbol, array in sensor.read(arrays).items()}
    return _cast(sensor.evaluate(f"validity_{word}", values), next(iter(arrays.values())).dtype)


def _cast(ratios: RealArray, dtype: np.dtype[Any]) -> RealArray:
    largest, limit = ratios.max(initial=0), float(np.finfo(dtype).max)
    if not largest <= limit:
        raise ValueError(f"the ratios must be at most {limit:.7g} to be told in {dtype}; got {largest:.7g}")
    return ratios.astype(dtype, copy=False)


def _positive(domain: Domain) -> Domain:
    smallest, largest = max(domain.smallest, SMALLEST), min(domain.largest, LARGEST)
    return domain._replace(smallest=smallest, largest=largest, reason="a ratio to zero is none")
