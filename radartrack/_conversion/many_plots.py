"""Many plots: arrays in blocks, each checked and converted while it is in the cache."""

import math
from collections.abc import Callable, Mapping
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from radartrack._arrays import machine_code
from radartrack._arrays.batches import BLOCK, fill
from radartrack._arrays.validation import DOUBLE, RealArray, broadcast_shape, common_shape, real_arrays
from radartrack._conversion.careful_covariance import decorrelated, make_sound
from radartrack._conversion.prediction import COVARIANCE, MEAN, Predicted
from radartrack._conversion.semidefinite import plain_interval
from radartrack._conversion.sensors import Sensor
from radartrack._conversion.way import Way
from radartrack.generated import conversions

PREDICTED_BLOCK = 16384  # plots; the average over a prediction has ten times as many intermediate results
_AXES = {MEAN: 1, COVARIANCE: 2}  # of one plot; of what is measured it is a number


def many_plots(way: Way, given: Mapping[str, ArrayLike]) -> tuple[RealArray, RealArray]:
    """Convert arrays, by name.

    Returns:
        Means, shape (..., n), and covariances, shape (..., n, n).

    Raises:
        TypeError, ValueError: a value is out of place, or the shapes do not broadcast.

    """
    arrays = real_arrays({**given, **way.prediction})
    try:
        return _computed(way, arrays)
    except ValueError:  # from one block; the message is about all
        _checked(way.sensor, arrays)
        raise


def _computed(way: Way, arrays: Mapping[str, RealArray]) -> tuple[RealArray, RealArray]:
    """In blocks. Machine code tells whether a block is plain; other blocks are checked while they are in the cache."""
    sensor = way.sensor
    size = len(sensor.coordinates)  # as many coordinates as there are measured quantities
    axes = {name: _AXES.get(name, 0) for name in arrays}
    shape = common_shape(array.shape[: array.ndim - axes[name]] for name, array in arrays.items())
    count, dtype = math.prod(shape), next(iter(arrays.values())).dtype
    mean, covariance = np.empty((count, size), dtype), np.empty((count, size, size), dtype)
    compiled, block = _compiled(way, count, dtype, size)
    limits = _plain_limits(sensor)
    flat = {name: _flat(array, shape, axes[name]) for name, array in arrays.items()}
    varying = {name: array for name, array in flat.items() if array.ndim > axes[name]}

    def convert(*parts: RealArray) -> None:
        *inputs, means, covariances = parts
        values = flat | dict(zip(varying, inputs, strict=True))
        measured = sensor.by_symbol(values)
        if compiled and compiled(*measured.values(), means, covariances, limits=limits) and not way.prediction:
            sensor.require_possible(measured)
        else:
            measured, prediction = _checked(sensor, values)
            if not compiled:
                getattr(conversions, way.function)(*measured.values(), means, covariances)
            if prediction is not None:
                covariances[...] = decorrelated(sensor, measured, prediction)
            make_sound(way, measured, prediction, covariances)
        if way.turned:
            means[...], covariances[...] = way.oriented(means, covariances)

    fill(convert, [*varying.values()], [mean, covariance], block)
    return mean.reshape(*shape, size), covariance.reshape(*shape, size, size)


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


def _compiled(way: Way, count: int, dtype: np.dtype[Any], size: int) -> tuple[Callable[..., bool] | None, int]:
    """The conversion without a prediction as machine code, where that is worth while, and the size of blocks."""
    found = None
    if count >= machine_code.COMPILED_FROM and dtype == np.float64 and machine_code.is_available():
        found = machine_code.conversion(way.function, size)
    return found, PREDICTED_BLOCK if way.prediction else machine_code.BLOCK if found else BLOCK


def _plain_limits(sensor: Sensor) -> NDArray[np.float64]:
    """Of each argument in float64: where nothing else has to be checked of it, and covariances need no care."""
    domains = sensor.arguments.values()
    return np.array([plain_interval(symbol, *domain.bounds(DOUBLE)) for symbol, domain in domains])


def _flat(array: RealArray, shape: tuple[int, ...], axes: int) -> RealArray:
    """One axis of plots before the array's own axes; none where all plots share the value."""
    if array.ndim == axes + 1 and array.shape[:1] == shape:
        return array
    own = array.shape[array.ndim - axes :]
    if array.size == math.prod(own):
        return array.reshape(own)
    spread = array if array.shape == (*shape, *own) else np.broadcast_to(array, (*shape, *own))
    return spread.reshape(-1, *own)
