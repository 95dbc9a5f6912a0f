"""The recursion of a filter of fixed gain, over any number of tracks at once."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from radartrack._arrays.validation import (
    RealArray,
    broadcast_shape,
    kept,
    real_arrays,
    require_covariance,
    require_finite,
    require_trailing_shape,
)


@dataclass(frozen=True, init=False, eq=False)
class FixedGainFilter:
    """A filter of one coordinate, or one for each of many tracks.

    Attributes:
        period: time from scan to scan [s], shape (...).
        gain: what a residual adds to position, velocity, ... [1, 1/s, ...], shape (..., n).
        covariance: of the steady error of the state after a measurement [m, m/s, ...], shape (..., n, n).

    Raises:
        TypeError: a part is not made of real numbers.
        ValueError: the shapes do not fit, a number is not finite, the period is not positive, or the covariance is
            none.

    """

    period: RealArray
    gain: RealArray
    covariance: RealArray

    def __init__(self, period: ArrayLike, gain: ArrayLike, covariance: ArrayLike) -> None:
        arrays = real_arrays({"period": period, "gain": gain, "covariance": covariance})
        for name, array in arrays.items():
            require_finite(name, array)
            object.__setattr__(self, name, kept(array))
        if self.gain.ndim == 0:
            raise ValueError("gain must have shape (..., n); got a single number")
        if not (self.period > 0).all():
            raise ValueError(f"period must be more than 0; got {self.period.min()}")
        require_trailing_shape("covariance", self.covariance, self.gain.shape[-1:] * 2)
        require_covariance("covariance", self.covariance)
        _tracks({"period": self.period[..., np.newaxis], "gain": self.gain, "covariance": self.covariance[..., 0]})

    def run(self, measured: ArrayLike, start: ArrayLike) -> RealArray:
        """Predict at a constant highest derivative, and add the gain times the residual, scan by scan.

        Args:
            measured: positions [m], shape (..., scans); NaN where one is missing, whereafter the steady covariance
                holds no more for some scans.
            start: states at the scan before the first measured one [m, m/s, ...], shape (..., n).

        Returns:
            States after each scan [m, m/s, ...], shape (..., scans, n).

        Raises:
            TypeError: an argument is not made of real numbers.
            ValueError: the shapes do not fit, a measurement is infinite, a state is not finite, or the result
                overflows.

        """
        arrays = real_arrays({"measured": measured, "start": start})
        values, state = arrays["measured"], arrays["start"]
        size = self.gain.shape[-1]
        if values.ndim == 0:
            raise ValueError("measured must have shape (..., scans); got a single number")
        if np.isinf(values).any():
            raise ValueError(f"measured must be finite, or NaN where missing; got {np.isinf(values).sum()} infinite")
        require_trailing_shape("start", state, (size,))
        require_finite("start", state)
        own = {"gain": self.gain, "period": self.period[..., np.newaxis]}
        tracks = _tracks({"measured": values, "start": state, **own})
        dtype = np.result_type(values, state, self.gain)
        moving, gains = (
            np.array(np.moveaxis(np.broadcast_to(array, (*tracks, size)), -1, 0), dtype) for array in (state, self.gain)
        )
        scans = np.ascontiguousarray(np.moveaxis(values, -1, 0))
        states = np.empty((len(scans), size, *tracks), dtype)
        with np.errstate(over="ignore", invalid="ignore"):
            for number, scan in enumerate(scans):
                for order in range(size - 1):
                    for more in range(1, size - order):
                        moving[order] += moving[order + more] * (self.period**more / math.factorial(more))
                moving += gains * np.where(np.isnan(scan), 0, scan - moving[0])
                states[number] = moving
        require_finite("the states of the result", states)
        return np.moveaxis(states, (0, 1), (-2, -1))


def _tracks(arrays: dict[str, RealArray]) -> tuple[int, ...]:
    """The leading shape of arrays without their last axes.

    Raises:
        ValueError: they do not broadcast.

    """
    return broadcast_shape({name: np.broadcast_to(0.0, array.shape[:-1]) for name, array in arrays.items()})
