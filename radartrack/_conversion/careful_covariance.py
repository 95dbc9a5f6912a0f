"""Covariances of a conversion, averaged over a prediction, and computed again with care where rounding asks for it."""

from collections.abc import Mapping, Sequence
from itertools import islice

import numpy as np

from radartrack._arrays.validation import RealArray
from radartrack._conversion import semidefinite
from radartrack._conversion.prediction import Predicted
from radartrack._conversion.sensors import Sensor
from radartrack._conversion.way import Way
from radartrack.generated import conversions

TOGETHER = 1024  # plots times parts; calls cost more than numbers up to there


def decorrelated(sensor: Sensor, measured: Mapping[str, RealArray], prediction: Predicted) -> RealArray:
    """The average of the covariance over a prediction, by quadrature over its parts; many at once of few plots."""
    plots = np.broadcast(*measured.values(), *prediction.symbols().values())
    parts = prediction.parts()
    averaged: RealArray | int = 0
    while some := list(islice(parts, max(1, TOGETHER // max(1, plots.size)))):
        weights, symbols = zip(*some, strict=True)
        values = {name: _stacked([part[name] for part in symbols], plots.ndim) for name in symbols[0]}
        covariances = sensor.evaluate("decorrelated_covariance", {**measured, **values})
        for weight, covariance in zip(weights, covariances, strict=True):
            averaged = averaged + weight * covariance
    return np.asarray(averaged)


def _stacked(arrays: Sequence[RealArray], axes: int) -> RealArray:
    """The same symbol of several parts along a new first axis, before the axes of plots."""
    first = arrays[0]
    return np.stack(arrays).reshape(len(arrays), *(1,) * (axes - first.ndim), *first.shape)


def make_sound(
    way: Way,
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
        covariances[doubtful] = _with_care(way, few, part, covariances[doubtful])


def _with_care(
    way: Way,
    measured: Mapping[str, RealArray],
    prediction: Predicted | None,
    like: RealArray,
) -> RealArray:
    """Covariances in float64 and, where that is not enough, the nearest that are positive semidefinite."""
    wide = {symbol: semidefinite.without_nothing(array) for symbol, array in measured.items()}

    def computed(**other: RealArray) -> RealArray:
        values, covariances = {**wide, **other}, np.empty(like.shape)
        if prediction is None:
            getattr(conversions, way.function)(*values.values(), np.empty(like.shape[:-1]), covariances)
        else:
            covariances[...] = decorrelated(way.sensor, values, prediction)
        return semidefinite.cast(covariances, covariances.dtype)

    covariances = computed()
    doubtful = ~semidefinite.are_sound(covariances)
    if doubtful.any():
        independent = computed(rho=np.zeros(()))
        covariances[doubtful] = semidefinite.nearest(covariances[doubtful], independent[doubtful])
    return semidefinite.cast(covariances, like.dtype)
