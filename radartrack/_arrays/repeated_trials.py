"""Figures from repeated trials, each with its confidence interval; the trials run along the first axis.

The intervals are normal approximations from the variance of the sample. Where two figures come from the same
trials, the interval of what compares them uses that they do, and is much narrower for it.
"""

from statistics import NormalDist
from typing import NamedTuple

import numpy as np

from radartrack._arrays.validation import RealArray

CONFIDENCE = 0.95


class Estimate(NamedTuple):
    """Estimated values and the ends of their confidence intervals, of one shape."""

    value: RealArray
    lower: RealArray
    upper: RealArray


def mean(values: RealArray, confidence: float = CONFIDENCE) -> Estimate:
    """The mean of values, shape (trials, ...)."""
    middle, half = values.mean(axis=0), _half_width(values, confidence)
    return Estimate(middle, middle - half, middle + half)


def root_mean(squares: RealArray, confidence: float = CONFIDENCE) -> Estimate:
    """The root of the mean of squares, shape (trials, ...)."""
    return Estimate(*(np.sqrt(np.maximum(end, 0.0)) for end in mean(squares, confidence)))


def excess(squares: RealArray, reference: RealArray, confidence: float = CONFIDENCE) -> Estimate:
    """The mean of squares over that of a reference from the same trials, less 1; by linearisation."""
    ratio = squares.mean(axis=0) / reference.mean(axis=0)
    half = _half_width(squares - ratio * reference, confidence) / reference.mean(axis=0)
    return Estimate(ratio - 1, ratio - 1 - half, ratio - 1 + half)


def root_excess(squares: RealArray, reference: RealArray, confidence: float = CONFIDENCE) -> Estimate:
    """The root mean square over that of a reference from the same trials, less 1."""
    return Estimate(*(np.sqrt(np.maximum(1 + end, 0.0)) - 1 for end in excess(squares, reference, confidence)))


def _half_width(values: RealArray, confidence: float) -> RealArray:
    quantile = NormalDist().inv_cdf((1 + confidence) / 2)
    half: RealArray = quantile * values.std(axis=0, ddof=1) / np.sqrt(len(values))
    return half
