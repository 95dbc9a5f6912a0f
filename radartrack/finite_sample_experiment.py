"""Monte Carlo errors of finite-sample filters beside their closed forms, with and without range rate.

A target with constant acceleration is observed scan by scan. After each scan every filter estimates range, speed and
acceleration by the highest degree that the sample supports. The root mean square error over the trials is compared
with the root of variance plus squared bias; a bias there is where the degree is still below two.
"""

from __future__ import annotations

from statistics import NormalDist
from typing import NamedTuple

import numpy as np

from radartrack._arrays.validation import RealArray, number_between
from radartrack.finite_sample_filter import FiniteSampleFilter, Run
from radartrack.simulate import Accelerated, Radar, Seed, plots

SMALLEST_FALSE_ALARM = 1e-9
COMPONENTS = ("range", "speed", "acceleration")


def radial_radar(range_std: float, rate_std: float, period: float) -> Radar:
    """A radar of ranges and range rates; its azimuth is not used.

    Args:
        range_std: standard deviation of the range [m].
        rate_std: standard deviation of the range rate [m/s].
        period: time from scan to scan [s].

    """
    return Radar("polar_doppler", period, {"range_std": range_std, "azimuth_std": 0.0, "range_rate_std": rate_std})


class Errors(NamedTuple):
    """Errors of one filter, shape (scans, 3) each; NaN where a component is not estimated yet.

    Attributes:
        measured: root mean square over the trials.
        expected: the same from the closed forms.
        low: lower end of the band in which the measured one is expected.
        high: upper end of that band.

    """

    measured: RealArray
    expected: RealArray
    low: RealArray
    high: RealArray

    @property
    def inside(self) -> bool:
        """Whether every measured error lies in its band."""
        known = ~np.isnan(self.expected)
        above, below = self.measured[known] >= self.low[known], self.measured[known] <= self.high[known]
        return bool(above.all() and below.all())


class Comparison(NamedTuple):
    """The errors with range alone, and with range and range rate."""

    without: Errors
    with_rate: Errors

    @property
    def gain(self) -> RealArray:
        """What the range rate removes of the measured error, shape (scans, 3)."""
        return 1 - self.with_rate.measured / self.without.measured

    @property
    def expected_gain(self) -> RealArray:
        """The same from the closed forms."""
        return 1 - self.with_rate.expected / self.without.expected

    @property
    def gain_band(self) -> tuple[RealArray, RealArray]:
        """What the gain lies between wherever the errors lie in their bands."""
        return 1 - self.with_rate.high / self.without.low, 1 - self.with_rate.low / self.without.high


def compare(
    radar: Radar,
    *,
    scans: int = 20,
    trials: int = 100_000,
    start: tuple[float, float, float] = (100e3, -200.0, 2.0),
    false_alarm: float = 1e-6,
    seed: Seed = 0,
) -> Comparison:
    """Simulate both filters of degree 2 on the same trials.

    Args:
        radar: of the sensor "polar_doppler", at the origin, that misses nothing; its errors are told to no filter but
            by their deviations.
        scans: number of scans.
        trials: number of independent trials.
        start: range [m], speed [m/s] and acceleration [m/s^2] of the target at the first scan, along the line of
            sight.
        false_alarm: probability that a correct filter leaves any band of this comparison, by Bonferroni. A
            mean of squares counts as chi-square distributed, with the freedom that fits its variance. From 1e-9 to 0.5.
        seed: of the simulation; the same seed gives the same numbers.

    Raises:
        TypeError: an argument is not made of real numbers, or a count is no whole one.
        ValueError: the radar is another, or a number is out of place.

    """
    if radar.sensor != "polar_doppler" or any(radar.site) or radar.detection_probability < 1:
        raise ValueError(f"radar must be of the sensor 'polar_doppler', at the origin, and miss nothing; got {radar}")
    if len(start) != len(COMPONENTS):
        raise ValueError(f"start must be range, speed and acceleration; got {start!r}")
    number_between("false_alarm", false_alarm, SMALLEST_FALSE_ALARM, 1 / 2)
    r, v, a = start
    seen = plots(Accelerated((r, 0.0), (v, 0.0), (a, 0.0)), radar, scans=scans, trials=trials, seed=seed)
    ranges, rates = seen.measured["r"], seen.measured["range_rate"]
    truth = np.stack([seen.truth["r"], seen.truth["range_rate"], np.full(scans, a)], axis=-1)
    single = false_alarm / (2 * scans * len(COMPONENTS))
    without = FiniteSampleFilter(radar.period, radar.noise["range_std"])
    with_rate = FiniteSampleFilter(radar.period, radar.noise["range_std"], radar.noise["range_rate_std"])
    return Comparison(
        _errors(without.run(ranges), without.run(truth[:, 0]), truth, single),
        _errors(with_rate.run(ranges, rates), with_rate.run(truth[:, 0], truth[:, 1]), truth, single),
    )


def _errors(noisy: Run, noiseless: Run, truth: RealArray, false_alarm: float) -> Errors:
    trials = len(noisy.state)
    measured = np.sqrt(((noisy.state - truth) ** 2).mean(axis=0))
    variance = np.diagonal(noiseless.covariance, axis1=-2, axis2=-1)
    square = (noiseless.state - truth) ** 2
    mean = variance + square
    freedom = trials * mean**2 / (variance**2 + 2 * variance * square)
    low, high = (np.sqrt(mean * chi_square_ratio(freedom, tail)) for tail in (false_alarm / 2, 1 - false_alarm / 2))
    return Errors(measured, np.sqrt(mean), low, high)


def chi_square_ratio(freedom: RealArray, probability: float) -> RealArray:
    """The quantile of a chi-square variable over its degrees of freedom, many of them (Wilson & Hilferty 1931).

    Of few, the approximation of a low one may be negative; it is 0 then, as no chi-square variable is less.
    """
    share = 2 / (9 * freedom)
    root = 1 - share + NormalDist().inv_cdf(probability) * np.sqrt(share)
    ratio: RealArray = np.maximum(root, 0.0) ** 3
    return ratio
