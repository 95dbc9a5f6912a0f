"""Bias and consistency of a conversion on simulated measurements, and gates for filters.

A converted measurement is consistent if its covariance tells the size of its error: the error squared over the
covariance, averaged, is then the number of coordinates (average normalised estimation error squared, NEES). The
answer depends on what is held fixed, and most disagreement between published comparisons comes from there:

- "truth": the target stays where it is, and measurements scatter about it;
- "measurement": one measurement is given, and the targets that may have caused it scatter about it;
- "prediction": targets scatter about a prediction, and measurements about the targets.

Of a filter `nees` and `nis` are the errors and the innovations squared over their covariances, chi-square variables
where the filter is consistent. `gate` is what they seldom exceed, and `band` holds their average over runs.
"""

import math
from collections.abc import Callable, Mapping
from typing import Literal, NamedTuple, TypeAlias, get_args

import numpy as np
from numpy.typing import ArrayLike, NDArray

from radartrack import convert
from radartrack._arrays.batches import fill
from radartrack._arrays.validation import (
    Domain,
    RealArray,
    broadcast_shape,
    by_name,
    number_between,
    one_of,
    real_arrays,
    require_covariance,
    require_finite,
    require_trailing_shape,
    require_within,
    whole_number,
)
from radartrack._conversion.prediction import Predicted
from radartrack._conversion.semidefinite import ROUNDING, are_sound
from radartrack._conversion.sensors import SENSORS, AzimuthFrom, Sensor, SensorName
from radartrack._filtering.elimination import checked_covariances, eliminate, pivots
from radartrack.chi_square import quantile, upper_quantile
from radartrack.convert import Converted, Method
from radartrack.simulate import noise_covariance, scatter

__all__ = ["Consistency", "band", "chi_square_quantile", "experiment", "gate", "nees", "nis"]


def __dir__() -> list[str]:
    return __all__


Given: TypeAlias = Literal["truth", "measurement", "prediction"]

MINIMUM = 2
BLOCK = 2048  # errors; their covariances stay in the cache
SMALLEST_FALSE_ALARM = 1e-9
PROBABILITY = Domain(
    "",
    1 - 1e-12,
    1 - 1e-6,
    "nearer to 1 than 1e-12, in float32 than 1e-6, a float tells little of a tail",
    smallest=1e-12,
)
DEGREES = Domain("", 1e6, 1e6, "more are as good as normal, and quantiles of fewer underflow", smallest=0.1)
RUNS = Domain("", 1e6, 1e6, "more are as good as normal", smallest=1.0)
_SINGULAR = "the covariance is singular: deviations must be positive, correlations below 1"


class Consistency(NamedTuple):
    """Averages over simulated errors, each with the interval that holds the expectation.

    Attributes:
        bias: mean error of each coordinate, converted minus true, shape (n,).
        bias_band: lower and upper end, shape (n, 2).
        nees: average NEES over the number of coordinates; 1 where consistent, larger where the covariance is too
            small.
        nees_band: lower and upper end, shape (2,).

    """

    bias: RealArray
    bias_band: RealArray
    nees: float
    nees_band: RealArray

    @property
    def is_unbiased(self) -> bool:
        """Whether every band of the bias holds zero."""
        return bool(((self.bias_band[:, 0] <= 0) & (self.bias_band[:, 1] >= 0)).all())

    @property
    def is_consistent(self) -> bool:
        """Whether the band of the NEES holds one."""
        return bool(self.nees_band[0] <= 1 <= self.nees_band[1])


def chi_square_quantile(probability: ArrayLike, degrees_of_freedom: ArrayLike) -> RealArray:
    """The value below which a chi-square variable falls with a probability.

    The relative error is at most 1e-8 up to 1e4 degrees of freedom, and 1e-7 beyond.

    Args:
        probability: from 1e-12 to 1 - 1e-12.
        degrees_of_freedom: from 0.1 to 1e6; they need not be whole.

    Returns:
        Quantiles, of the shape that both broadcast to.

    Raises:
        TypeError: an argument is not made of real numbers.
        ValueError: an argument is out of its domain, or the shapes do not broadcast.

    Source: Abramowitz & Stegun 1964, 6.5.29 and 6.5.31: power series and continued fraction of the incomplete gamma
    function.

    """
    arrays = real_arrays({"probability": probability, "degrees_of_freedom": degrees_of_freedom})
    require_within("probability", arrays["probability"], PROBABILITY)
    require_within("degrees_of_freedom", arrays["degrees_of_freedom"], DEGREES)
    return _of_each(quantile, arrays)


def _of_each(function: Callable[[float, float], float], arrays: Mapping[str, RealArray]) -> RealArray:
    """A function of two numbers for each pair, and once for those that are alike."""
    shape = broadcast_shape(arrays)
    pairs = np.stack([np.broadcast_to(array, shape).reshape(-1).astype(np.float64) for array in arrays.values()], -1)
    distinct, which = np.unique(pairs, axis=0, return_inverse=True)
    values = np.array([function(*map(float, pair)) for pair in distinct])
    return values[which.reshape(-1)].reshape(shape) if len(values) else np.empty(shape)


def gate(components: ArrayLike, probability: ArrayLike = 0.99, runs: ArrayLike = 1) -> RealArray:
    """What a NIS or NEES does not exceed with a probability: 9.21 for two components and 99 %.

    Args:
        components: of the innovation or of the state.
        probability: with which a consistent filter stays within, from 1e-12 to 1 - 1e-12.
        runs: how many independent ones the NIS or NEES is an average of.

    Returns:
        Gates, of the shape that all broadcast to.

    Raises:
        TypeError: an argument is not made of real numbers.
        ValueError: an argument is out of its domain, or the shapes do not broadcast.

    Source: Bar-Shalom, Li & Kirubarajan 2001, 1.5.4 and 5.4.2, doi:10.1002/0471221279.

    """
    return _averaged(quantile, components, runs, probability, lambda inside: inside)


def band(components: ArrayLike, runs: ArrayLike = 1, probability: ArrayLike = 0.95) -> RealArray:
    """The interval that holds the average NIS or NEES of a consistent filter, as often on either side of it.

    Args:
        components: of the innovation or of the state.
        runs: how many independent ones are averaged.
        probability: with which it is held, from 1e-12 to 1 - 1e-12.

    Returns:
        Lower and upper ends along the last axis, shape (..., 2).

    Raises:
        TypeError: an argument is not made of real numbers.
        ValueError: an argument is out of its domain, or the shapes do not broadcast.

    Source: Bar-Shalom, Li & Kirubarajan 2001, 5.4.2, doi:10.1002/0471221279.

    """
    ends = [
        _averaged(function, components, runs, probability, lambda inside: (1 - inside) / 2)
        for function in (quantile, upper_quantile)
    ]
    return np.stack(ends, axis=-1)


def _averaged(
    function: Callable[[float, float], float],
    components: ArrayLike,
    runs: ArrayLike,
    probability: ArrayLike,
    tail: Callable[[RealArray], RealArray],
) -> RealArray:
    """A quantile of the average over runs, of a tail that follows from a probability."""
    arrays = real_arrays({"components": components, "runs": runs, "probability": probability})
    require_within("probability", arrays["probability"], PROBABILITY)
    require_within("runs", arrays["runs"], RUNS)
    broadcast_shape(arrays)
    degrees = arrays["components"] * arrays["runs"]
    require_within("components times runs", degrees, DEGREES)
    return _of_each(function, {"probability": tail(arrays["probability"]), "degrees": degrees}) / arrays["runs"]


def nees(mean: ArrayLike, covariance: ArrayLike, truth: ArrayLike) -> RealArray:
    """The normalised estimation error squared, e' P^-1 e, whose expectation is the number of components.

    Args:
        mean: estimates, shape (..., n).
        covariance: what is said of their errors, positive definite by more than rounding, shape (..., n, n).
        truth: shape (..., n).

    Returns:
        Shape (...).

    Raises:
        TypeError: an argument is not made of real numbers.
        ValueError: an entry is not finite, a covariance is not symmetric and positive definite, the shapes do not
            fit, or the result overflows.

    Source: Bar-Shalom, Li & Kirubarajan 2001, 5.4.2, doi:10.1002/0471221279.

    """
    arrays = real_arrays({"mean": mean, "covariance": covariance, "truth": truth})
    for name in ("mean", "truth"):
        require_finite(name, arrays[name])
    shapes = arrays["mean"].shape, arrays["truth"].shape
    if not shapes[0] or shapes[0][-1:] != shapes[1][-1:]:
        raise ValueError(f"mean and truth must both have shape (..., n); got {shapes[0]} and {shapes[1]}")
    broadcast_shape({name: arrays[name] for name in ("mean", "truth")})
    with np.errstate(over="ignore"):
        errors = arrays["mean"] - arrays["truth"]
    return _normalised(errors, arrays["covariance"])


def nis(innovation: ArrayLike, covariance: ArrayLike) -> RealArray:
    """The normalised innovation squared, v' S^-1 v.

    Args:
        innovation: measured less predicted, shape (..., m).
        covariance: S, that of the innovation, H P H' + R, as for `nees`, shape (..., m, m).

    Returns:
        Shape (...).

    Raises:
        TypeError: an argument is not made of real numbers.
        ValueError: as `nees`.

    Source: Bar-Shalom, Li & Kirubarajan 2001, 5.4.2, doi:10.1002/0471221279.

    """
    arrays = real_arrays({"innovation": innovation, "covariance": covariance})
    require_finite("innovation", arrays["innovation"])
    return _normalised(arrays["innovation"], arrays["covariance"])


def _normalised(errors: RealArray, covariance: RealArray) -> RealArray:
    """Errors squared over covariances, by elimination, which minds no units, however far apart they are."""
    if not errors.ndim or not errors.shape[-1]:
        raise ValueError(f"errors must have shape (..., n), with n from 1; got {errors.shape}")
    size = errors.shape[-1]
    require_trailing_shape("covariance", covariance, (size, size))
    shape = broadcast_shape({"errors": errors[..., 0], "covariance": covariance[..., 0, 0]})
    flat = np.broadcast_to(errors, (*shape, size)).reshape(-1, size)
    own = covariance[np.newaxis] if covariance.ndim == 2 else np.broadcast_to(covariance, (*shape, size, size))
    matrices = own.reshape(-1, size, size)
    squares = np.empty(len(flat), np.result_type(flat, matrices))

    def block(numbers: NDArray[np.intp], found: RealArray) -> None:
        some = matrices if covariance.ndim == 2 else matrices[numbers]
        checked = checked_covariances("covariance", np.ascontiguousarray(np.moveaxis(some, 0, -1)))
        table = np.empty((size, size + 1, len(numbers)), squares.dtype)  # [P | e]
        table[:, :size], table[:, size] = checked, flat[numbers].T
        with np.errstate(invalid="ignore", divide="ignore", over="ignore"):
            eliminate(table)
            rounding = ROUNDING * np.finfo(squares.dtype).eps * np.diagonal(checked).T
            if not (pivots(table) > rounding).all():
                raise ValueError(
                    "covariance must be positive definite, by more than rounding; got a matrix that is not"
                )
            found[...] = np.square(table[:, size]).sum(axis=0)

    try:
        fill(block, [np.arange(len(flat))], [squares], BLOCK)
    except ValueError:  # of one block; the message is to count among all
        require_covariance("covariance", covariance)
        raise
    require_finite("the square of the result", squares.reshape(shape))
    return np.asarray(squares.reshape(shape))[()]


def experiment(
    sensor: SensorName,
    plot: Mapping[str, float],
    method: Method = "unbiased",
    given: Given = "truth",
    *,
    predicted_covariance: ArrayLike | None = None,
    azimuth_from: AzimuthFrom | None = None,
    draws: int = 100_000,
    seed: int = 0,
    false_alarm: float = 1e-3,
) -> Consistency:
    """Simulate measurements, convert them, and compare the errors with what the conversion says of them.

    The bands come from the variance of the sample: each misses the expectation with the stated probability, for
    as many draws as make the mean normal.

    Args:
        sensor: a conversion's name, such as "polar" or "spherical_doppler".
        plot: the arguments of the conversion of this name, one number each: measured quantities, what else it takes
            (`baseline`), deviations, and `correlation`, which is 0 if it is not given.
        method: as the conversion of this name takes it.
        given: what is held fixed; it is at the values in `plot`.
        predicted_covariance: of a prediction of the measured quantities, whose mean is in `plot`; for the method
            "decorrelated" and for `given` "prediction", and only there.
        azimuth_from: as the conversion takes it; None for its default. "ruv" has none.
        draws: how many simulated errors, at least 2.
        seed: of the random numbers; the same one gives the same result.
        false_alarm: probability with which one band misses, from 1e-9 to 0.5.

    Returns:
        Averages and bands.

    Raises:
        TypeError: an argument is no number, is missing, or is none of the conversion's.
        ValueError: a simulated measurement or another number lies outside what the conversion takes, a word is
            unknown, a covariance is singular, or an average overflows.

    Source: Lerro & Bar-Shalom 1993, doi:10.1109/7.220948, for the normalised error of conversions.

    """
    chosen = one_of("sensor", sensor, SENSORS)
    condition = one_of("given", given, get_args(Given))
    model = SENSORS[chosen]
    axis = model.chosen_axis(azimuth_from)
    centre, known, noise = _point(model, plot)
    needed = method == "decorrelated" or condition == "prediction"
    prediction = _prediction(model, centre, predicted_covariance, needed=needed)
    truth, measured = _simulated(
        condition, centre, noise_covariance(chosen, noise), prediction, _generator(draws, seed)
    )
    function: Callable[..., Converted] = getattr(convert, chosen)
    predicted = prediction if method == "decorrelated" else None
    convention = {} if axis is None else {"azimuth_from": axis}
    arguments = {**dict(zip(model.coordinates, np.moveaxis(measured, -1, 0), strict=True)), **known, **noise}
    converted = function(**arguments, method=method, predicted=predicted, **convention)
    positions = model.cartesian(truth, known, axis)
    return _summary(converted.mean - positions, converted.covariance, _width(false_alarm))


def _point(sensor: Sensor, plot: Mapping[str, float]) -> tuple[RealArray, dict[str, float], dict[str, float]]:
    """The centre of the simulation, and by name what is known, and deviations and correlation."""
    names = [*sensor.arguments]
    values = {"correlation": 0.0} | by_name("plot", plot)
    if set(values) != set(names):
        raise TypeError(f"plot must have the arguments {names}; got {sorted(plot)}")
    arrays = real_arrays({name: values[name] for name in names})
    for name, array in arrays.items():
        if array.shape:
            raise TypeError(f"{name} must be one number; got shape {array.shape}")
    sensor.read(arrays)
    centre = np.array([float(arrays[name]) for name in sensor.coordinates])
    known, noise = ({name: float(arrays[name]) for name in part} for part in (sensor.parameters, sensor.noise))
    return centre, known, noise


def _prediction(
    sensor: Sensor, centre: RealArray, covariance: ArrayLike | None, *, needed: bool
) -> tuple[RealArray, RealArray] | None:
    if needed != (covariance is not None):
        uses = "for the method 'decorrelated' or given 'prediction', and only there"
        raise ValueError(f"predicted_covariance must be given {uses}; got {covariance!r}")
    if covariance is None:
        return None
    matrix = real_arrays({"predicted_covariance": covariance})["predicted_covariance"]
    if matrix.ndim != 2:
        raise ValueError(f"predicted_covariance must be one matrix, shape (n, n); got shape {matrix.shape}")
    Predicted(sensor, centre, matrix).require_valid()
    return centre, matrix


def _simulated(
    given: Given,
    centre: RealArray,
    noise: RealArray,
    prediction: tuple[RealArray, RealArray] | None,
    normal: Callable[[int], RealArray],
) -> tuple[RealArray, RealArray]:
    """True and measured values, one row a draw."""
    errors = scatter(noise, normal(len(noise)))
    if given == "measurement":
        return centre - errors, np.broadcast_to(centre, errors.shape)
    truth = np.broadcast_to(centre, errors.shape)
    if given == "prediction" and prediction is not None:
        truth = truth + scatter(prediction[1], normal(len(noise)))
    return truth, truth + errors


def _generator(draws: int, seed: int) -> Callable[[int], RealArray]:
    count = whole_number("draws", draws, MINIMUM)
    generator = np.random.default_rng(whole_number("seed", seed, 0))
    return lambda size: generator.standard_normal((count, size))


def _width(false_alarm: float) -> float:
    """By how many standard errors a normal mean is off with this probability."""
    probability = number_between("false_alarm", false_alarm, SMALLEST_FALSE_ALARM, 1 / 2)
    return math.sqrt(quantile(1 - probability, 1))  # the square of a normal variable


def _summary(errors: RealArray, covariance: RealArray, width: float) -> Consistency:
    singular = ~are_sound(covariance, least_pivot=ROUNDING * float(np.finfo(covariance.dtype).eps))
    if singular.any():
        raise ValueError(_SINGULAR)
    # In units of the deviations, whose squares may differ by hundreds of orders.
    deviations = np.sqrt(np.diagonal(covariance, axis1=-2, axis2=-1))
    correlations = covariance / deviations[:, :, np.newaxis] / deviations[:, np.newaxis, :]
    with np.errstate(over="ignore", invalid="ignore"):  # what overflows is refused below
        scaled = errors / deviations
        weighted = np.linalg.solve(correlations, scaled[..., np.newaxis])[..., 0]
        squares = (scaled * weighted).sum(axis=-1) / errors.shape[-1]
        found = Consistency(errors.mean(axis=0), _band(errors, width), float(squares.mean()), _band(squares, width))
    if not all(np.isfinite(part).all() for part in found):
        raise ValueError(f"{_SINGULAR}, and errors not so unequal that their squares overflow")
    return found


def _band(values: RealArray, width: float) -> RealArray:
    """The interval about the mean over the first axis, its ends along the last."""
    mean, deviation = values.mean(axis=0), values.std(axis=0, ddof=1)
    half = width * deviation / math.sqrt(len(values))
    return np.stack([mean - half, mean + half], axis=-1)
