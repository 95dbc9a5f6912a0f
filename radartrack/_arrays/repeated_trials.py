"""Figures from repeated trials, each with its confidence interval; the trials run along the first axis.

The intervals are normal approximations from the variance of the sample. Where two figures come from the same
trials, the interval of what compares them uses that they do, and is much narrower for it.
"""

from statistics import NormalDist
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from radartrack._arrays.validation import RealArray, real_arrays, real_number, require_finite

CONFIDENCE = 0.95
FEWEST_TRIALS = 2  # one has no scatter


class Estimate(NamedTuple):
    """Estimated values and the ends of their confidence intervals, of one shape."""

    value: RealArray
    lower: RealArray
    upper: RealArray


def mean(values: ArrayLike, confidence: float = CONFIDENCE) -> Estimate:
    """The mean of values, shape (trials, ...).

    Raises:
        TypeError: the values are not made of real numbers, or the confidence is none.
        ValueError: a value is not finite, there are fewer than two trials, the confidence is not between 0 and 1, or
            the estimate overflows.

    """
    read = _trials("values", values)
    with np.errstate(over="ignore", invalid="ignore"):
        middle, half = read.mean(axis=0), _half_width(read, confidence)
        return _finite(Estimate(middle, middle - half, middle + half))


def root_mean(squares: ArrayLike, confidence: float = CONFIDENCE) -> Estimate:
    """The root of the mean of squares, shape (trials, ...).

    Raises:
        TypeError, ValueError: as `mean`.

    """
    return Estimate(*(np.sqrt(np.maximum(end, 0.0)) for end in mean(squares, confidence)))


def excess(squares: ArrayLike, reference: ArrayLike, confidence: float = CONFIDENCE) -> Estimate:
    """The mean of squares over that of a reference from the same trials, less 1; by linearisation.

    Raises:
        TypeError, ValueError: as `mean`; or the shapes differ, or a mean of the reference is not positive.

    """
    read, other = _trials("squares", squares), _trials("reference", reference)
    if read.shape != other.shape:
        raise ValueError(f"squares and reference must have one shape; got {read.shape} and {other.shape}")
    with np.errstate(over="ignore", invalid="ignore"):
        divisor = other.mean(axis=0)
        if not (divisor > 0).all():
            raise ValueError(f"reference must have a mean of more than 0; got {divisor.min():g}")
        ratio = read.mean(axis=0) / divisor
        half = _half_width(read - ratio * other, confidence) / divisor
        return _finite(Estimate(ratio - 1, ratio - 1 - half, ratio - 1 + half))


def root_excess(squares: ArrayLike, reference: ArrayLike, confidence: float = CONFIDENCE) -> Estimate:
    """The root mean square over that of a reference from the same trials, less 1.

    Raises:
        TypeError, ValueError: as `excess`.

    """
    return Estimate(*(np.sqrt(np.maximum(1 + end, 0.0)) - 1 for end in excess(squares, reference, confidence)))


def _trials(name: str, values: ArrayLike) -> RealArray:
    read = real_arrays({name: values})[name]
    require_finite(name, read)
    if read.ndim == 0 or len(read) < FEWEST_TRIALS:
        raise ValueError(f"{name} must have at least {FEWEST_TRIALS} trials, the first axis; got shape {read.shape}")
    return read


def _finite(found: Estimate) -> Estimate:
    for name, values in found._asdict().items():
        require_finite(f"the {name} of the estimate", values)
    return found


def _half_width(values: RealArray, confidence: float) -> RealArray:
    share = real_number("confidence", confidence)
    if not 0 < share < 1:
        raise ValueError(f"confidence must be between 0 and 1; got {share:g}")
    quantile = -NormalDist().inv_cdf((1 - share) / 2)  # of the small tail, which keeps its digits
    half: RealArray = quantile * values.std(axis=0, ddof=1) / np.sqrt(len(values))
    return half
