"""Beliefs of many tracks after one measurement each, by plain differences where these keep their digits."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from radartrack._arrays.validation import RealArray
from radartrack._filtering.elimination import eliminate, pivots
from radartrack._filtering.factors import combination, updated
from radartrack._filtering.whitening import independent


class Told(NamedTuple):
    """What measurements tell of the errors of means, the tracks last.

    Attributes:
        innovation: measured less expected, (m, tracks).
        rows: H, by the components at `places`, (m, k, tracks).
        places: of these components in the state; the others are not measured.
        noise: R, (m, m, tracks or 1).
        spread: what curvature adds to it, (m, m, tracks), of second order.

    """

    innovation: RealArray
    rows: RealArray
    places: list[int]
    noise: RealArray
    spread: RealArray | None

    def without(self, silent: NDArray[np.bool_]) -> Told:
        """The same where some measurements, (m, tracks), tell nothing."""
        either = silent | silent[:, np.newaxis]
        return self._replace(
            innovation=np.where(silent, 0, self.innovation),
            rows=np.where(silent[:, np.newaxis], 0, self.rows),
            noise=np.where(either, np.eye(len(silent), dtype=self.noise.dtype)[..., np.newaxis], self.noise),
            spread=None if self.spread is None else np.where(either, 0, self.spread),
        )

    def of(self, tracks: NDArray[np.bool_]) -> Told:
        """The same of some tracks."""
        noise = self.noise if self.noise.shape[-1] == 1 else self.noise[..., tracks]
        spread = None if self.spread is None else self.spread[..., tracks]
        return Told(self.innovation[:, tracks], self.rows[..., tracks], self.places, noise, spread)

    @property
    def errors(self) -> RealArray:
        """The covariance of the innovation but for what is believed, (m, m, tracks or 1)."""
        return self.noise if self.spread is None else self.noise + self.spread


def refined(covariance: RealArray, told: Told) -> tuple[RealArray, RealArray]:
    """The step of the mean, (n, tracks), and the covariance after it, (n, n, tracks).

    With S = H P H' + R the share det R/det S is the least that can be left of the variance in any direction. So the
    plain difference P - P H' S^-1 H P keeps all but the digits of its inverse, in every direction, and S all but those
    that correlations of the noise take. It takes a fourth of the time of factors, which are for the tracks that would
    lose more than six of a float's sixteen digits.

    Args:
        covariance: P, (n, n, tracks or 1).
        told: to as many tracks.

    """
    step, reduced, lost = _plainly(covariance, told)
    doubtful = ~(lost <= np.finfo(reduced.dtype).eps ** -0.375)
    if doubtful.any():
        few = covariance if covariance.shape[-1] == 1 else covariance[..., doubtful]
        step[:, doubtful], reduced[..., doubtful] = _in_factors(few, told.of(doubtful))
    return step, reduced


def _plainly(covariance: RealArray, told: Told) -> tuple[RealArray, RealArray, RealArray]:
    """The same by differences, and how many times the rounding of a float may be lost in them."""
    (m, tracks), n = told.innovation.shape, len(covariance)
    table = np.empty((m, m + n + 1, tracks), covariance.dtype)  # [S | H P | -innovation]
    seen, along = table[:, :m], table[:, m : m + n]
    by_component = np.moveaxis(told.rows, 1, 0)
    along[...] = combination(by_component[:, :, np.newaxis], covariance[told.places][:, np.newaxis])
    seen[...] = combination(by_component[:, np.newaxis], np.moveaxis(along[:, told.places], 1, 0)[:, :, np.newaxis])
    seen += told.errors
    np.negative(told.innovation, out=table[:, -1])
    eliminate(table)
    result = np.empty((n, n + 1, tracks), covariance.dtype)  # [P | 0], of which the upper triangle counts
    result[:, :n] = covariance
    result[:, n] = 0
    for row in table[:, m:]:
        for i in range(n):
            result[i, i:] -= row[i] * row[i:]
    for i in range(1, n):
        result[i, :i] = result[:i, i]
    return result[:, n], result[:, :n], _lost(told.noise, pivots(table))


def _lost(noise: RealArray, left: RealArray) -> RealArray:
    """How often det S/det R is, times what correlations take of R."""
    table = noise.copy()
    eliminate(table)
    own = pivots(table)
    share = left / own * (np.diagonal(noise).T / own)
    possible = ((own > 0) & (left > own / 2)).all(axis=0)  # no covariance takes from the noise, but by rounding
    return np.where(possible, share.prod(axis=0), np.inf)


def _in_factors(covariance: RealArray, told: Told) -> tuple[RealArray, RealArray]:
    (m, tracks), n = told.innovation.shape, len(covariance)
    rows = np.zeros((m, n, tracks), covariance.dtype)
    rows[:, told.places] = told.rows
    none = np.zeros((n, tracks), covariance.dtype)
    return updated(none, covariance, independent(told.innovation, rows, told.errors))
