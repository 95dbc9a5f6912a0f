"""The least-squares polynomial filter over the last k scans, from range or from range and range rate.

A target's range is taken as a polynomial of time, of degree 0 to 3, over the scans of a sample. The estimate
is its value and derivatives at the newest scan, or at any lag from it. Full, evenly spaced samples use closed
forms: one matrix product serves any number of tracks. Missing observations and uneven times use the normal
equations of each sample. Either way the result for a track has the same bits however many others are
estimated with it.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from radartrack import kalman
from radartrack._arrays import patterns
from radartrack._arrays.normal_equations import Sample, Solution, solve
from radartrack._arrays.row_products import Product, rowwise_product
from radartrack._arrays.validation import (
    RealArray,
    broadcast_shape,
    positive_number,
    real_arrays,
    real_number,
    require_variances,
    rounded_to,
    whole_number,
)
from radartrack.generated import finite_sample as formulas

HIGHEST_DEGREE = 3
MOST_SCANS = 1_000_000
LARGEST_RATIO = 1e12
SMALLEST_RATIO = 1e-60
LARGEST_SCALE = 1e60  # so that no square in the closed forms overflows, nor underflows
LONGEST_LAG = 1e12
LONGEST_KEPT = 4096
SCANS_AT_ONCE = 32


class Weights(NamedTuple):
    """Weights of the ranges and of the range rates, shape (degree + 1, k); None without range rates."""

    ranges: RealArray
    rates: RealArray | None


class Estimate(NamedTuple):
    """Range and derivatives, shape (..., degree + 1), and the covariance of their errors.

    The covariance has shape (..., degree + 1, degree + 1). Where many tracks share one, it is a read-only
    view.
    """

    state: RealArray
    covariance: RealArray


class Run(NamedTuple):
    """Estimates after 1, 2, … scans.

    Attributes:
        state: shape (..., scans, degree + 1); NaN in components that the observations do not determine yet.
        covariance: shape (..., scans, degree + 1, degree + 1), with NaN likewise; it may be a read-only view.
        degree: of the polynomial that was fitted, shape (..., scans); -1 where nothing could be.

    """

    state: RealArray
    covariance: RealArray
    degree: NDArray[np.int64]


class _Observed(NamedTuple):
    """Checked observations, all of the shape (..., k)."""

    ranges: RealArray
    rates: RealArray | None
    times: RealArray | None

    def window(self, first: int, end: int) -> _Observed:
        """The scans from number `first` to the one before `end`, counted from 0."""
        return _Observed(*(None if part is None else part[..., first:end] for part in self))  # type: ignore[arg-type]

    def in_double(self) -> _Observed:
        """The same in float64."""
        parts = (None if part is None else part.astype(np.float64, copy=False) for part in self)
        return _Observed(*parts)  # type: ignore[arg-type]

    def without_missing(self, tracks: NDArray[np.bool_]) -> _Observed:
        """Some tracks, with 0 for what is missing."""
        parts = (None if part is None else np.nan_to_num(part[tracks]) for part in self)
        return _Observed(*parts)  # type: ignore[arg-type]

    @property
    def uneven(self) -> NDArray[np.bool_]:
        """The tracks that miss something or have times of their own."""
        if self.times is not None:
            return np.ones(self.ranges.shape[:-1], dtype=bool)
        missing = np.isnan(self.ranges) if self.rates is None else np.isnan(self.ranges) | np.isnan(self.rates)
        return np.asarray(missing.any(axis=-1))


@dataclass(frozen=True)
class FiniteSampleFilter:
    """A filter of one degree for one radar.

    Attributes:
        period: time from scan to scan [s].
        range_std: standard deviation of the error of a range [m].
        rate_std: standard deviation of the error of a range rate [m/s]; None where none is measured.
        degree: of the polynomial, 0 to 3: 1 for constant velocity, 2 for constant acceleration.
        lag: scans from the newest one to the time of the estimate, negative to smooth.

    Raises:
        TypeError: a value is no real number, or the degree is no whole one.
        ValueError: a value is not finite or not positive, the degree is not from 0 to 3, the lag is longer than 1e12
            scans, range_std/period^n is not from 1e-60 to 1e60 for all n up to the degree, or
            C = range_std^2/(period rate_std)^2 is not from 1e-60 to 1e12.

    Source: Gorshkov & Zavizhenets, (1)-(20), for degree 2; the other degrees by the same derivation.

    """

    period: float
    range_std: float
    rate_std: float | None = None
    degree: int = 2
    lag: float = 0.0

    def __post_init__(self) -> None:
        numbers = {name: positive_number(name, getattr(self, name)) for name in ("period", "range_std")}
        if self.rate_std is not None:
            numbers["rate_std"] = positive_number("rate_std", self.rate_std)
        degree = whole_number("degree", self.degree, 0, HIGHEST_DEGREE)
        for name, number in {**numbers, "lag": real_number("lag", self.lag), "degree": degree}.items():
            object.__setattr__(self, name, number)
        self._require_moderate()

    def _require_moderate(self) -> None:
        if abs(self.lag) > LONGEST_LAG:
            raise ValueError(f"lag must be from {-LONGEST_LAG:g} to {LONGEST_LAG:g}; got {self.lag:g}")
        scales = [math.log10(self.range_std) - n * math.log10(self.period) for n in (0, self.degree)]
        if max(map(abs, scales)) > math.log10(LARGEST_SCALE):
            raise ValueError(
                f"range_std/period^n must be from {1 / LARGEST_SCALE:g} to {LARGEST_SCALE:g} for all n up to the "
                f"degree {self.degree}; got range_std {self.range_std:g} and period {self.period:g}"
            )
        if self.rate_std is not None and not SMALLEST_RATIO <= self.C <= LARGEST_RATIO:
            raise ValueError(
                f"range_std^2/(period rate_std)^2 must be at most {LARGEST_RATIO:g} and at least {SMALLEST_RATIO:g}; "
                f"got {self.C:g}"
            )

    @property
    def C(self) -> float:  # noqa: N802 - the letter of the literature
        """The weight of the range rate, range_std^2/(period rate_std)^2; 0 without range rate."""
        if self.rate_std is None:
            return 0.0
        with np.errstate(over="ignore", under="ignore"):
            return float((np.float64(self.range_std) / self.period / self.rate_std) ** 2)

    @property
    def fewest_scans(self) -> int:
        """The fewest full scans that determine the state."""
        return self.degree + 1 if self.rate_std is None else (self.degree + 2) // 2

    def at(self, lag: float) -> FiniteSampleFilter:
        """Return the same filter for the state at another time, `lag` scans after the newest one."""
        return replace(self, lag=lag)

    def covariance(self, k: int) -> RealArray:
        """Compute the covariance of the errors after k full scans.

        Args:
            k: number of scans, up to 1 000 000.

        Returns:
            Shape (degree + 1, degree + 1), in m and s.

        Raises:
            ValueError: so few scans do not determine the state, or there are too many.

        """
        return self._closed(self._checked_count(k)).covariance.copy()

    def weights(self, k: int) -> Weights:
        """Compute the weights of the observations of k full scans, oldest first.

        They are kept for the next call, and read-only.

        Raises:
            ValueError: so few scans do not determine the state, or there are too many.

        """
        return self._closed(self._checked_count(k)).weights

    def estimate(
        self, ranges: ArrayLike, rates: ArrayLike | None = None, *, times: ArrayLike | None = None
    ) -> Estimate:
        """Estimate the state of each track from its k scans, the newest last.

        Args:
            ranges: measured ranges [m], shape (..., k); NaN where one is missing.
            rates: measured range rates [m/s], shape (..., k), NaN where one is missing; only with `rate_std`.
            times: times of the scans [s], shape (k,) or (..., k), where they are uneven.

        Returns:
            The state at `lag` periods after the newest scan, missing or not, and its covariance.

        Raises:
            TypeError: an argument is not made of real numbers.
            ValueError: the shapes do not fit, a number is infinite, a time is NaN or earlier than the one
                before it, the observations of some track do not determine its state, or the state or its
                covariance is too large or too small for the type.

        """
        observed = self._checked(ranges, rates, times)
        count = observed.ranges.shape[-1]
        if times is None or not count:
            self._checked_count(count)
        state, covariance, degree = self._fit(observed, range(count, count + 1), count)
        if degree.min(initial=self.degree) < self.degree:
            self._refuse(degree[..., 0])
        return Estimate(state[..., 0, :], covariance[..., 0, :, :])

    def run(
        self,
        ranges: ArrayLike,
        rates: ArrayLike | None = None,
        *,
        times: ArrayLike | None = None,
        window: int | None = None,
    ) -> Run:
        """Estimate the state of each track after each of its scans.

        The degree grows with what the observations so far determine, up to that of the filter: with range
        rates, a velocity after one scan and an acceleration after two.

        Args:
            ranges: measured ranges [m], shape (..., scans); NaN where one is missing.
            rates: measured range rates [m/s], of the same shape, NaN where one is missing; only with
                `rate_std`.
            times: times of the scans [s], shape (scans,) or (..., scans), where they are uneven.
            window: number of scans that an estimate rests on at most; None for all so far.

        Raises:
            TypeError, ValueError: as `estimate`, but that too few observations are no error.

        """
        observed = self._checked(ranges, rates, times)
        count = observed.ranges.shape[-1]
        length = count if window is None else whole_number("window", window, 1, MOST_SCANS)
        starts = range(0, count, SCANS_AT_ONCE)
        parts = [self._fit(observed, range(n + 1, min(n + SCANS_AT_ONCE, count) + 1), length) for n in starts]
        return _joined(parts, observed.ranges.ndim - 1) if parts else self._nothing(observed.ranges)

    def kalman(self, k: int, process_noise: float = 0.0) -> HandOver:
        """Hand over to a Kalman filter of the same order after k scans.

        Args:
            k: number of scans that start it; 3 in the paper.
            process_noise: intensity of the white noise that drives the highest derivative of the state,
                m^2/s^(2 degree + 1); 0 continues the growing sample exactly.

        Raises:
            TypeError: k is no whole number, or the intensity no real one.
            ValueError: so few scans do not determine the state, the intensity is negative, or so large or small that
                the matrices of the motion overflow or lose their digits, or `lag` is not 0.

        """
        return HandOver(self, k, process_noise)

    def _checked_count(self, k: int) -> int:
        count = whole_number("k", k, 1, MOST_SCANS)
        if count < self.fewest_scans:
            highest = count - 1 if self.rate_std is None else 2 * count - 1
            raise ValueError(
                f"k must be at least {self.fewest_scans} for degree {self.degree} from {self._observed}; "
                f"got {count}, which supports degree {highest}"
            )
        return count

    @property
    def _observed(self) -> str:
        return "range alone" if self.rate_std is None else "range and range rate"

    def _refuse(self, degree: NDArray[np.int64]) -> None:
        track = np.unravel_index(np.argmax(degree < self.degree), degree.shape)
        few = np.count_nonzero(degree < self.degree)
        supported = f"degree {degree[track]}" if degree[track] >= 0 else "no degree"
        where = f"[{', '.join(map(str, track))}]" if track else "given"
        raise ValueError(
            f"observations must determine a polynomial of degree {self.degree}; those of track {where} support "
            f"{supported} ({few} of {degree.size} tracks have too few)"
        )

    def _checked(self, ranges: ArrayLike, rates: ArrayLike | None, times: ArrayLike | None) -> _Observed:
        if (rates is None) != (self.rate_std is None):
            wanted = "given for a filter with" if rates is None else "omitted for a filter without"
            raise ValueError(f"rates must be {wanted} rate_std")
        optional = {"rates": rates, "times": times}
        given = {name: value for name, value in optional.items() if value is not None}
        arrays = real_arrays({"ranges": ranges, **given})
        for name, array in arrays.items():
            if array.ndim == 0:
                raise ValueError(f"{name} must have shape (..., k); got a single number")
        if times is not None:
            _require_times(arrays["times"])
        shape = broadcast_shape(arrays)
        spread = {name: np.broadcast_to(array, shape) for name, array in arrays.items()}
        return _Observed(spread["ranges"], spread.get("rates"), spread.get("times"))

    def _nothing(self, ranges: RealArray) -> Run:
        """A run of as many scans, of which nothing is estimated yet."""
        size = self.degree + 1
        return Run(
            np.empty((*ranges.shape, size), ranges.dtype),
            np.empty((*ranges.shape, size, size), ranges.dtype),
            np.empty(ranges.shape, dtype=np.int64),
        )

    def _fit(self, observed: _Observed, ends: range, length: int) -> Run:
        """The estimates after each of these numbers of scans, from the last `length` of them."""
        if observed.times is not None:
            return self._with_uneven(self._nothing(observed.ranges[..., : len(ends)]), observed, ends, length)
        used = observed.window(max(ends.start - length, 0), ends.stop - 1)
        fitted, is_finite = self._banded(used, ends, length)
        if is_finite:
            return self._shared(fitted, ends, length)
        _require_finite_or_missing(observed)
        partial = used.uneven
        fitted[partial] = self._banded(used.without_missing(partial), ends, length).values
        return self._with_uneven(self._shared(fitted, ends, length), observed, ends, length)

    def _banded(self, used: _Observed, ends: range, length: int) -> Product:
        """All estimates as products with one matrix, which is zero where a scan is outside a window."""
        parts = [part for part in (used.ranges, used.rates) if part is not None]
        band = rounded_to(used.ranges.dtype, "weights", self._band(ends, max(ends.start - length, 0), length))
        fitted, is_finite = rowwise_product(parts, band)
        return Product(fitted.reshape(*fitted.shape[:-1], len(ends), self.degree + 1), is_finite)

    def _shared(self, fitted: RealArray, ends: range, length: int) -> Run:
        """With the covariances and degrees that all full tracks share, and NaN for what they do not determine."""
        closed = [self._closed(min(end, length)) for end in ends]
        degrees = np.array([part.degree for part in closed])
        size = self.degree + 1
        covariances = np.full((len(ends), size, size), np.nan)
        for n, part in enumerate(closed):
            covariances[n, : part.degree + 1, : part.degree + 1] = part.covariance
            fitted[..., n, part.degree + 1 :] = np.nan
        tracks = fitted.shape[:-2]
        return Run(
            fitted,
            np.broadcast_to(_in_type(covariances, fitted.dtype), (*tracks, *covariances.shape)),
            np.broadcast_to(degrees, (*tracks, *degrees.shape)),
        )

    def _band(self, ends: range, first: int, length: int) -> RealArray:
        """The weights of the ranges, then of the rates, from scan `first` on.

        There is a column for each component of each estimate, zero for components that the scans do not determine.
        """
        size = self.degree + 1
        bands = np.zeros((1 + (self.rate_std is not None), ends.stop - 1 - first, len(ends), size))
        for n, end in enumerate(ends):
            closed = self._closed(min(end, length))
            for band, weights in zip(bands, closed.weights, strict=False):
                if weights is not None:
                    band[max(end - length, 0) - first : end - first, n, : closed.degree + 1] = weights.T
        return bands.reshape(-1, len(ends) * size)

    def _closed(self, k: int) -> _Closed:
        """The filter of the highest degree that k scans support."""
        degree = min(self.degree, k - 1 if self.rate_std is None else 2 * k - 1)
        return _kept(self, k, degree) if k <= LONGEST_KEPT else _computed(self, k, degree)

    def _with_uneven(self, full: Run, observed: _Observed, ends: range, length: int) -> Run:
        """With the normal equations for the windows that miss something or have times of their own."""
        _require_finite_or_missing(observed)
        run = Run(full.state.copy(), full.covariance.copy(), full.degree.copy())
        for n, end in enumerate(ends):
            window = observed.window(max(end - length, 0), end)
            uneven = window.uneven
            if uneven.any():
                for part, replacement in zip(run, self._fit_each(window, uneven), strict=True):
                    part[uneven, n] = replacement
        _require_finite_estimates(run)
        return run

    def _fit_each(self, observed: _Observed, chosen: NDArray[np.bool_]) -> Run:
        """The estimates of the chosen tracks by the normal equations of each."""
        ranges = observed.ranges[chosen].astype(np.float64)
        rates = np.full_like(ranges, np.nan) if observed.rates is None else observed.rates[chosen].astype(np.float64)
        scans = np.broadcast_to(np.arange(1.0 - ranges.shape[1], 1.0), ranges.shape)
        unit = self.period if observed.times is None else 1.0  # in periods, even times are whole numbers, not rounded
        times = scans if observed.times is None else observed.times[chosen].astype(np.float64)
        size = self.degree + 1
        result = Run(
            np.full((len(ranges), size), np.nan),
            np.full((len(ranges), size, size), np.nan),
            np.full(len(ranges), -1),
        )
        samples, which = _distinct(Sample(times, np.isfinite(ranges), np.isfinite(rates)))
        newest = _newest(ranges)
        with np.errstate(over="ignore", under="ignore", invalid="ignore"):  # what is not finite is refused
            beyond = ranges - newest[:, np.newaxis]
            data = np.stack([np.where(np.isnan(values), 0.0, values) for values in (beyond, rates)])
            for degree in range(self.degree, -1, -1):
                self._fill(result, degree, samples, which, data, unit)
            result.state[:, 0] += newest
        _require_finite_estimates(result)
        dtype = observed.ranges.dtype
        return Run(rounded_to(dtype, "the state", result.state), _in_type(result.covariance, dtype), result.degree)

    def _fill(
        self, result: Run, degree: int, samples: Sample, which: NDArray[np.int64], data: RealArray, unit: float
    ) -> None:
        """Enter the estimates of this degree, less the newest range, for tracks that support it and no higher one."""
        waiting, place = np.unique(which[result.degree < 0], return_inverse=True)
        solution = self._solution(samples.chosen(waiting), degree, unit)
        determined = solution.determined[place]
        tracks, chosen = np.flatnonzero(result.degree < 0)[determined], place[determined]
        state = sum(
            (weights[chosen] * values[tracks, np.newaxis]).sum(axis=-1)
            for weights, values in zip((solution.range_weights, solution.rate_weights), data, strict=True)
        )
        result.state[tracks, : degree + 1] = state
        result.covariance[tracks, : degree + 1, : degree + 1] = solution.covariance[chosen]
        result.degree[tracks] = degree

    def _solution(self, samples: Sample, degree: int, unit: float) -> Solution:
        """The weights and the covariance of the errors in m and s, from times in a unit [s]."""
        rate_weight = 0.0 if self.rate_std is None else self.range_std / self.rate_std / unit
        per_unit = unit ** -np.arange(degree + 1.0)
        solved = solve(samples, self.lag * (self.period / unit), degree, rate_weight, self.period / unit)
        deviations = self.range_std * per_unit
        return Solution(
            solved.determined,
            solved.range_weights * per_unit[:, np.newaxis],
            solved.rate_weights * (per_unit * unit)[:, np.newaxis],
            solved.covariance * deviations[:, np.newaxis] * deviations,
        )


@dataclass(frozen=True)
class HandOver:
    """A Kalman filter that a finite-sample filter starts.

    Attributes:
        start: the filter that estimates the first state.
        k: number of scans that it rests on.
        process_noise: intensity of the white noise in the highest derivative, m^2/s^(2 degree + 1).

    """

    start: FiniteSampleFilter
    k: int
    process_noise: float = 0.0

    def __post_init__(self) -> None:
        if self.start.lag:
            raise ValueError(f"lag must be 0 to hand over to a Kalman filter; got {self.start.lag}")
        if real_number("process_noise", self.process_noise) < 0:
            raise ValueError(f"process_noise must be finite and at least 0; got {self.process_noise}")
        self.start._checked_count(self.k)  # noqa: SLF001 - one thought in two classes
        _ = self.motion  # whose matrices refuse an intensity that is too large, or too small beside the period

    @property
    def motion(self) -> kalman.Motion:
        """F and Q from scan to scan."""
        return kalman.polynomial_motion(self.start.degree, self.start.period, self.process_noise)

    @property
    def matrix(self) -> RealArray:
        """What is measured, by the components of the state: the range and, where it is, the range rate."""
        rows = 1 if self.start.rate_std is None else 2
        return np.eye(self.start.degree + 1)[:rows] if self.start.degree else np.eye(2)[:rows, :1]

    @property
    def noise(self) -> RealArray:
        """The covariance of the errors of a scan."""
        deviations = [self.start.range_std] + [self.start.rate_std] * (self.start.rate_std is not None)
        return np.diag(np.array(deviations, dtype=np.float64) ** 2)

    def run(self, ranges: ArrayLike, rates: ArrayLike | None = None) -> Estimate:
        """Filter tracks: the finite-sample estimate after scan k, then one Kalman step a scan.

        Args:
            ranges: measured ranges [m], shape (..., scans), at least k of them; NaN where one is missing.
            rates: measured range rates [m/s], of the same shape, NaN where one is missing; only with
                `rate_std`.

        Returns:
            States after scans k, k + 1, …, shape (..., scans - k + 1, degree + 1), and their covariances.

        Raises:
            TypeError, ValueError: as `FiniteSampleFilter.estimate`; or there are fewer than k scans.

        """
        given = self.start._checked(ranges, rates, None)  # noqa: SLF001 - one thought in two classes
        observed, dtype = given.in_double(), given.ranges.dtype  # states are rounded once, to the type that was given
        count = observed.ranges.shape[-1]
        if count < self.k:
            raise ValueError(f"ranges must have at least {self.k} scans to start from; got {count}")
        first, rest = observed.window(0, self.k), observed.window(self.k, count)
        started = self.start.estimate(first.ranges, first.rates)
        parts = [part for part in (rest.ranges, rest.rates) if part is not None]
        later = kalman.run(
            kalman.Belief(started.state, started.covariance),
            self.motion,
            np.stack(parts, axis=-1),
            self.matrix,
            self.noise,
        )
        states = np.concatenate([started.state[..., np.newaxis, :], later.mean], axis=-2)
        covariances = np.concatenate([started.covariance[..., np.newaxis, :, :], later.covariance], axis=-3)
        return Estimate(rounded_to(dtype, "the state", states), _in_type(covariances, dtype))


class _Closed(NamedTuple):
    """Weights and covariance of full samples, from the closed forms."""

    degree: int
    weights: Weights
    covariance: RealArray


@lru_cache(maxsize=256)
def _kept(of: FiniteSampleFilter, k: int, degree: int) -> _Closed:
    return _computed(of, k, degree)


def _computed(of: FiniteSampleFilter, k: int, degree: int) -> _Closed:
    observed, kinds = ("range", ["range"]) if of.rate_std is None else ("range_rate", ["range", "rate"])
    prefix = f"degree{degree}_{observed}_{'at_lag_' * bool(of.lag)}"
    arguments = {"k": float(k), "T": float(of.period)}
    arguments |= {} if of.rate_std is None else {"C": of.C}
    arguments |= {"tau": float(of.lag)} if of.lag else {}
    scans = np.arange(1.0, k + 1)
    weights = [getattr(formulas, f"{prefix}{kind}_weights")(j=scans, **arguments).T.copy() for kind in kinds]
    for array in weights:
        array.flags.writeable = False
    covariance = getattr(formulas, f"{prefix}covariance")(sigma_r=float(of.range_std), **arguments)
    return _Closed(degree, Weights(weights[0], weights[1] if len(weights) > 1 else None), covariance)


def _distinct(sample: Sample) -> tuple[Sample, NDArray[np.int64]]:
    """The distinct samples, and which of them each one is."""
    if (sample.times != sample.times[:1]).any():
        return sample, np.arange(len(sample.times))
    first, which = patterns.distinct(np.concatenate([sample.has_range, sample.has_rate], axis=1))
    return sample.chosen(first), which


def _newest(ranges: RealArray) -> RealArray:
    """The newest range of each track, 0 where all are missing.

    What is a constant of all ranges is one of the estimate, but weights know that only to rounding. Where nearly
    worthless rates determine the polynomial, weights of ranges are rounded like theirs, and of a range far beyond its
    errors that is much.
    """
    seen = np.isfinite(ranges)
    latest = ranges.shape[1] - 1 - np.argmax(seen[:, ::-1], axis=1)
    found: RealArray = np.where(seen.any(axis=1), ranges[np.arange(len(ranges)), latest], 0.0)
    return found


def _joined(parts: Sequence[Run], axis: int) -> Run:
    """Runs over successive scans as one; without a copy of what all tracks share."""
    if len(parts) == 1:
        return parts[0]
    return Run(*(_joined_arrays(arrays, axis) for arrays in zip(*parts, strict=True)))  # type: ignore[arg-type]


def _joined_arrays(arrays: tuple[RealArray, ...], axis: int) -> RealArray:
    if not axis or any(any(array.strides[:axis]) for array in arrays):
        return np.concatenate(arrays, axis=axis)
    tracks = arrays[0].shape[:axis]
    one = np.concatenate([array[(0,) * axis] for array in arrays])
    return np.broadcast_to(one, (*tracks, *one.shape))


def _require_finite_or_missing(observed: _Observed) -> None:
    for name, values in (("ranges", observed.ranges), ("rates", observed.rates)):
        if values is not None and np.isinf(values).any():
            count = np.count_nonzero(np.isinf(values))
            raise ValueError(f"{name} must be finite, or NaN where missing; got {count} infinite of {values.size}")


def _require_times(times: RealArray) -> None:
    if not np.isfinite(times).all():
        raise ValueError("times must be finite; a scan without observations has NaN in ranges and rates")
    if (np.diff(times, axis=-1) < 0).any():
        raise ValueError("times must not decrease along the last axis")


def _require_finite_estimates(run: Run) -> None:
    """Refuse what overflowed among the components that are determined."""
    known = np.arange(run.state.shape[-1]) <= run.degree[..., np.newaxis]
    both = known[..., np.newaxis] & known[..., np.newaxis, :]
    if not ((np.isfinite(run.state) | ~known).all() and (np.isfinite(run.covariance) | ~both).all()):
        raise ValueError(
            "ranges, rates and times must give a state and a covariance that float64 holds; got some that overflow"
        )


def _in_type(covariance: RealArray, dtype: np.dtype[Any]) -> RealArray:
    """Covariances, NaN where not determined, in the type of the observations."""
    result = rounded_to(dtype, "the covariance", covariance)
    require_variances("the covariance", np.diagonal(result, axis1=-2, axis2=-1))
    return result
