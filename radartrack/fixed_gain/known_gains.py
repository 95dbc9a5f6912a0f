"""Gains that are known in closed form: by the tracking index, and of fading memory."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from radartrack._arrays.validation import (
    Domain,
    RealArray,
    broadcast_shape,
    real_arrays,
    require_variances,
    require_within,
    whole_number,
)
from radartrack.fixed_gain.fixed_gain_filter import FixedGainFilter
from radartrack.generated import fading_memory as of_fading_memory
from radartrack.generated import steady_state

PERIOD = Domain(" s", 1e3, 1e3, "powers of others over- or underflow in single precision", smallest=1e-3)
POSITION_STD = Domain(" m", 1e6, 1e6, "no radar measures worse", smallest=1e-6)
ACCELERATION_STD = Domain(" m/s^2", 1e15, 1e15, "the tracking index allows no more", smallest=1e-21)
INDEX = Domain("", 1e3, 1e3, "beyond, a filter hardly listens or hardly remembers", smallest=1e-9)
FADING = Domain("", 0.9999, 0.9999, "nearer to 1 nothing is forgotten, nearer to 0 all is", smallest=1e-3)
HIGHEST_DEGREE = 3


def tracking_index(period: ArrayLike, range_std: ArrayLike, acceleration_std: ArrayLike) -> RealArray:
    """T^2 sigma_w/sigma_r: how far an acceleration may move a target from scan to scan, by the error of a measurement.

    Args:
        period: T, the time from scan to scan [s], from 1e-3 to 1e3.
        range_std: sigma_r, the standard deviation of a measured position [m], from 1e-6 to 1e6.
        acceleration_std: sigma_w, that of the acceleration over a period, or of its jumps [m/s^2].

    Returns:
        The index, from 1e-9 to 1e3, shape (...).

    Raises:
        TypeError: an argument is not made of real numbers.
        ValueError: a number or the index is out of place, or the shapes do not broadcast.

    Source: Kalata 1984, doi:10.1109/TAES.1984.310438.

    """
    return _indexed(period, range_std, acceleration_std)[0]


def alpha_beta(period: ArrayLike, range_std: ArrayLike, acceleration_std: ArrayLike) -> FixedGainFilter:
    """The steady Kalman filter of position and velocity, with an acceleration that is constant over a period.

    Args:
        period: T, the time from scan to scan [s], from 1e-3 to 1e3.
        range_std: the standard deviation of a measured position [m], from 1e-6 to 1e6.
        acceleration_std: that of the acceleration, new at each scan [m/s^2].

    Returns:
        The filter, with gains (alpha, beta/T) and the steady covariance; all shapes broadcast.

    Raises:
        TypeError: as `tracking_index`.
        ValueError: as `tracking_index`, which must be from 1e-9 to 1e3.

    Source: Kalata 1984, doi:10.1109/TAES.1984.310438; proved to solve the Riccati equation.

    """
    index, T, sigma_r = _indexed(period, range_std, acceleration_std)
    covariance = steady_state.alpha_beta_covariance(index=index, sigma_r=sigma_r, T=T)
    return _per_period(T, steady_state.alpha_beta_gain(index=index), covariance)


def alpha_beta_gamma(period: ArrayLike, range_std: ArrayLike, acceleration_std: ArrayLike) -> FixedGainFilter:
    """The steady Kalman filter of position, velocity and acceleration, which jumps at each scan.

    Args:
        period: T, the time from scan to scan [s], from 1e-3 to 1e3.
        range_std: the standard deviation of a measured position [m], from 1e-6 to 1e6.
        acceleration_std: that of a jump of the acceleration [m/s^2].

    Returns:
        The filter, with gains (alpha, beta/T, gamma/T^2) and the steady covariance; all shapes broadcast. Where a book
        has gamma/(2 T^2), its gamma is twice this one.

    Raises:
        TypeError: as `tracking_index`.
        ValueError: as `tracking_index`, which must be from 1e-9 to 1e3.

    Source: Kalata 1984, doi:10.1109/TAES.1984.310438; proved to solve the Riccati equation.

    """
    index, T, sigma_r = _indexed(period, range_std, acceleration_std)
    covariance = steady_state.alpha_beta_gamma_covariance(index=index, sigma_r=sigma_r, T=T)
    return _per_period(T, steady_state.alpha_beta_gamma_gain(index=index), covariance)


def fading_memory(degree: int, fading: ArrayLike, period: ArrayLike, range_std: ArrayLike) -> FixedGainFilter:
    """The filter that fits a polynomial to all scans so far, a residual n scans old weighed by `fading`^n.

    Args:
        degree: of the polynomial, 0 to 3.
        fading: from 1e-3 to 0.9999.
        period: T, the time from scan to scan [s], from 1e-3 to 1e3.
        range_std: the standard deviation of a measured position [m], from 1e-6 to 1e6.

    Returns:
        The filter of position and `degree` derivatives. Its covariance is what the errors of the measurements leave:
        it holds where the target moves as the polynomial. All shapes broadcast.

    Raises:
        TypeError: the degree is no whole number, or another argument not made of real numbers.
        ValueError: a number is out of place, or the shapes do not broadcast.

    Source: Morrison 1969.

    """
    d = whole_number("degree", degree, 0, HIGHEST_DEGREE)
    arrays = _read({"fading": (fading, FADING), "period": (period, PERIOD), "range_std": (range_std, POSITION_STD)})
    gain: RealArray = getattr(of_fading_memory, f"degree{d}")(theta=arrays["fading"])
    spread: RealArray = getattr(of_fading_memory, f"degree{d}_covariance")(theta=arrays["fading"])
    powers = _powers(arrays["period"], d + 1)
    scaled = np.square(arrays["range_std"])[..., np.newaxis, np.newaxis] * spread
    return _per_period(arrays["period"], gain, scaled / (powers[..., :, np.newaxis] * powers[..., np.newaxis, :]))


def _indexed(
    period: ArrayLike, range_std: ArrayLike, acceleration_std: ArrayLike
) -> tuple[RealArray, RealArray, RealArray]:
    """Index, period and deviation of a position."""
    given = {"period": (period, PERIOD), "range_std": (range_std, POSITION_STD)}
    arrays = _read(given | {"acceleration_std": (acceleration_std, ACCELERATION_STD)})
    T, sigma_r, sigma_w = arrays.values()
    index = np.asarray(np.square(T) * (sigma_w / sigma_r))
    require_within("the tracking index period^2 acceleration_std/range_std", index, INDEX)
    return index, T, sigma_r


def _read(given: dict[str, tuple[ArrayLike, Domain]]) -> dict[str, RealArray]:
    arrays = real_arrays({name: value for name, (value, _) in given.items()})
    for name, (_, domain) in given.items():
        require_within(name, arrays[name], domain)
    broadcast_shape(arrays)
    return arrays


def _powers(T: RealArray, size: int) -> RealArray:
    """1, T, T^2, ..., shape (..., size)."""
    return T[..., np.newaxis] ** np.arange(size).astype(T.dtype)


def _per_period(T: RealArray, gain: RealArray, covariance: RealArray) -> FixedGainFilter:
    """The filter whose gains are given times powers of T."""
    require_variances("the covariance of the filter", np.diagonal(covariance, axis1=-2, axis2=-1))
    return FixedGainFilter(T, gain / _powers(T, gain.shape[-1]), covariance)
