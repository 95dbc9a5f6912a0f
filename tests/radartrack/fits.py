"""Estimates of a finite-sample filter beside exact least squares."""

from fractions import Fraction
from typing import Any

import numpy as np

from radartrack import FiniteSampleFilter
from tests.least_squares import ExactFit, exact_fit


def observations(shape: tuple[int, ...], seed: int = 0) -> tuple[Any, Any]:
    generator = np.random.default_rng(seed)
    return 1e5 + 250 * generator.normal(size=shape), 15 * generator.normal(size=shape)


def fit_of(f: FiniteSampleFilter, times: Any, ranges: Any, rates: Any) -> ExactFit:
    at = Fraction(times[-1]) + Fraction(f.lag) * Fraction(f.period)
    ratio = Fraction(0) if f.rate_std is None else Fraction(f.range_std) ** 2 / Fraction(f.rate_std) ** 2
    return exact_fit(
        [Fraction(time) - at for time in times],
        f.degree,
        with_range=[not np.isnan(value) for value in ranges],
        with_rate=[not np.isnan(value) for value in rates],
        squared_ratio=ratio,
    )


def state_of(fit: ExactFit, ranges: Any, rates: Any) -> list[float]:
    values = [[Fraction(float(np.nan_to_num(value))) for value in data] for data in (ranges, rates)]
    return [
        float(sum(w * z for row, data in zip((a, b), values, strict=True) for w, z in zip(row, data, strict=True)))
        for a, b in zip(fit.range_weights, fit.rate_weights, strict=True)
    ]


def assert_fits(
    estimate: Any,
    fit: ExactFit,
    ranges: Any,
    rates: Any,
    range_std: float,
    accuracy: float,
    rate_std: float = np.inf,
) -> None:
    shares = np.sqrt([float(row[n]) for n, row in enumerate(fit.covariance)])
    deviations = shares * range_std
    covariance = np.array([[float(entry) for entry in row] for row in fit.covariance]) * range_std**2
    scale = deviations[:, np.newaxis] * deviations
    assert np.all(np.abs(estimate.covariance - covariance) <= accuracy * scale)
    largest, fastest = (float(np.abs(np.nan_to_num(values)).max()) for values in (ranges, rates))
    size = max(largest, fastest * (range_std / rate_std))  # as a range, which is as large as a float at most
    least = 100 * np.finfo(estimate.state.dtype).smallest_subnormal  # below, digits end before rounding does
    allowed = (accuracy * size + least) * shares * 4 + least
    assert np.all(np.abs(estimate.state - state_of(fit, ranges, rates)) <= allowed)
