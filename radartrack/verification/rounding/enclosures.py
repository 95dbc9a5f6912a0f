"""Positive quantities over many boxes at once, enclosed in the logarithm by affine functions of the coordinates.

Formulas of tracking are sums of products of positive sizes. In the logarithm a product is a sum, a power a multiple,
and a quotient of two sums loses what they share, over boxes as wide as ten decades; a plain interval would
not. Sums are linearised about the centre of a box, and what that neglects is bounded.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
import numpy.typing as npt

Array = npt.NDArray[np.float64]
Function = Callable[[Array], Array]
SLACK = 1e-12  # added where plain floating point rounds; the checker rounds outward
CERTAIN = -1e-6  # of a logarithm of a quotient: what is closer to one is not said to be below it


@dataclass(frozen=True)
class Enclosure:
    """log q ∈ middle + slopes · t + [−below, above], t in the cube [−1, 1]ⁿ of each box.

    Attributes:
        middle: shape (boxes,).
        slopes: shape (boxes, coordinates), for half the width of a box.
        below: infinite where nothing keeps q from zero.
        above: finite, unless q has no bound.
        least: a bound of log q from below that need not follow from the rest.
        most: likewise from above.
    """

    middle: Array
    slopes: Array
    below: Array
    above: Array
    least: Array
    most: Array

    @cached_property
    def spread(self) -> Array:
        """How far the affine part goes from its middle."""
        return np.asarray(np.abs(self.slopes).sum(axis=-1))

    @cached_property
    def high(self) -> Array:
        """The largest logarithm."""
        return np.minimum(self.middle + self.spread + self.above, self.most)

    @cached_property
    def low(self) -> Array:
        """The smallest logarithm."""
        return np.maximum(self.middle - self.spread - self.below, self.least)

    def __mul__(self, other: Enclosure) -> Enclosure:
        return Enclosure(
            self.middle + other.middle,
            self.slopes + other.slopes,
            self.below + other.below,
            self.above + other.above,
            self.low + other.low,
            self.high + other.high,
        )

    def __truediv__(self, other: Enclosure) -> Enclosure:
        return self * other.power(-1.0)

    def power(self, exponent: float) -> Enclosure:
        """q to a power."""
        ends = (self.below, self.above, self.low, self.high)
        below, above, low, high = ends if exponent > 0 else (self.above, self.below, self.high, self.low)
        size = abs(exponent)
        return Enclosure(
            exponent * self.middle, exponent * self.slopes, size * below, size * above, exponent * low, exponent * high
        )

    def times(self, factor: Array | float) -> Enclosure:
        """q times a positive number, one a box."""
        with np.errstate(divide="ignore"):
            shift = np.log(factor)
        return replace(self, middle=self.middle + shift, least=self.low + shift, most=self.high + shift)

    def without_floor(self) -> Enclosure:
        """The same, where q may also be anything smaller."""
        nothing = np.full_like(self.middle, -np.inf)
        return replace(self, below=-nothing, least=nothing)


def either(condition: npt.NDArray[np.bool_], first: Enclosure, second: Enclosure) -> Enclosure:
    """The first where the condition holds, else the second."""
    return Enclosure(
        np.where(condition, first.middle, second.middle),
        np.where(condition[:, np.newaxis], first.slopes, second.slopes),
        np.where(condition, first.below, second.below),
        np.where(condition, first.above, second.above),
        np.where(condition, first.least, second.least),
        np.where(condition, first.most, second.most),
    )


def total(terms: Sequence[Enclosure]) -> Enclosure:
    """The sum of positive quantities.

    With weights w of the terms at the centre and r their largest departure from the mean slope, Σ w e^d lies between
    1 and 1 + Σ w (e^r − 1 − r), as Σ w d is zero.
    """
    if len(terms) == 1:
        return terms[0]
    middles = np.stack([term.middle for term in terms])
    top = middles.max(axis=0)
    shares = np.exp(middles - top)
    whole = shares.sum(axis=0)
    weights = shares / whole
    slopes = sum(w[:, np.newaxis] * term.slopes for w, term in zip(weights, terms, strict=True))
    departures = np.stack([np.abs(term.slopes - slopes).sum(axis=-1) for term in terms])
    above, below = (np.stack([getattr(term, end) for term in terms]) for end in ("above", "below"))
    with np.errstate(over="ignore", invalid="ignore", divide="ignore"):
        grown = np.exp(departures)
        excess = weights * (grown - 1 - departures) + weights * grown * np.expm1(above)
        upper = np.log1p(excess.sum(axis=0))
        lost = (weights * grown * -np.expm1(-below)).sum(axis=0)
        lower = np.where(lost < 1, -np.log1p(-np.minimum(lost, 0.9999999)), np.inf)
        kept = np.isfinite(below)
        share = np.where(kept, weights, 0.0).sum(axis=0)
        spent = np.where(kept, weights * np.where(kept, below, 0.0), weights * departures).sum(axis=0)
        lower = np.minimum(lower, np.where(share > 0, spent / share - np.log(share), np.inf))
        least = np.logaddexp.reduce([term.low for term in terms])
        most = np.logaddexp.reduce([term.high for term in terms])
    return Enclosure(top + np.log(whole), slopes, lower + SLACK, upper + SLACK, least - SLACK, most + SLACK)


def curve(of: Enclosure, value: Function, slope: Function, *, concave: bool) -> Enclosure:
    """log q as a concave or convex function of another logarithm, between its chord and a parallel."""
    low, high = of.low, of.high
    width = high - low
    with np.errstate(all="ignore"):
        first, last = value(low), value(high)
        first_slope, last_slope = slope(low), slope(high)
        incline = np.where(width > 1e-9, (last - first) / np.maximum(width, 1e-300), first_slope)
        before, after = np.abs(first_slope - incline), np.abs(incline - last_slope)
        gap = width * before * after / np.maximum(before + after, 1e-300)  # the triangle of both tangents
        gap = np.minimum(np.where(np.isfinite(gap), gap, np.inf), np.abs(first - last)) + SLACK
    off = of.middle - low  # the chord at the centre of the box
    rising = incline >= 0
    above = np.abs(incline) * np.where(rising, of.above, of.below)
    below = np.abs(incline) * np.where(rising, of.below, of.above)
    return Enclosure(
        first + incline * off,
        incline[:, np.newaxis] * of.slopes,
        below + (SLACK if concave else gap),
        above + (gap if concave else SLACK),
        np.minimum(first, last) - SLACK,
        np.maximum(first, last) + SLACK,
    )


def remainder(quotient: Enclosure) -> Enclosure:
    """1 − q, where q is certainly below one."""
    capped = replace(quotient, most=np.minimum(quotient.high, CERTAIN))

    def slope(logarithm: Array) -> Array:
        return 1 / (1 - np.exp(-logarithm))

    return curve(capped, lambda logarithm: np.log(-np.expm1(logarithm)), slope, concave=True)
