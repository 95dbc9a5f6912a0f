"""What a sensor tells of the error of a mean, to first and to second order."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from radartrack._arrays.validation import RealArray
from radartrack._filtering.factors import combination, factored
from radartrack._filtering.refinement import Told
from radartrack._observation.sights import Sight


class Look(NamedTuple):
    """How a sensor looks at many tracks.

    Attributes:
        sight: what it measures.
        places: of the components, in the order in which the formulas take them.
        second: whether curvature counts.
        site: the other site, by symbol, one for all tracks or one for each.
        noise: R, (m, m) or (tracks, m, m).

    """

    sight: Sight
    places: list[int]
    second: bool
    site: dict[str, RealArray]
    noise: RealArray

    def told(self, mean: RealArray, covariance: RealArray, measured: RealArray, own: slice) -> Told:
        """What some tracks, with means (n, tracks), learn of the error of the mean from measurements (m, tracks)."""
        sight, places = self.sight, self.places
        site = {symbol: array[own] if array.ndim else array for symbol, array in self.site.items()}
        components = [mean[place] for place in places]
        near = sight.off_poles(components, site)
        rows = np.ascontiguousarray(np.moveaxis(sight.evaluate("jacobian", near, site), 0, -1))
        innovation = measured - sight.evaluate("map", components, site).T
        noise = self.noise[..., np.newaxis] if self.noise.ndim == 2 else np.moveaxis(self.noise[own], 0, -1)
        spread = None
        if self.second:
            shift, spread = curvature_of(sight.evaluate("hessian", near, site), covariance[np.ix_(places, places)])
            innovation -= shift
        for place in sight.azimuths:
            innovation[place] -= 2 * np.pi * np.round(innovation[place] / (2 * np.pi))
        silent = np.isnan(innovation) | ~rows.any(axis=1)
        if spread is not None:  # a spread whose square overflows says that nothing is known
            silent |= ~(np.sqrt(np.finfo(spread.dtype).max) >= np.diagonal(spread).T)
        told = Told(innovation, rows, places, noise, spread)
        return told.without(silent) if silent.any() else told


def curvature_of(hessian: RealArray, covariance: RealArray) -> tuple[RealArray, RealArray]:
    """What curvature adds to a mean and its covariance: tr(G P)/2, (m, tracks), and tr(G_a P G_b P)/2, (m, m, tracks).

    Both are taken of a root of P: so the latter are sums of squares, and small where P is large along straight lines.

    Args:
        hessian: (tracks, m, n, n), as formulas give it.
        covariance: of what is differentiated by, (n, n, tracks or 1).

    """
    columns, variances = factored(covariance)
    root = columns * np.sqrt(variances)
    curvature = np.ascontiguousarray(np.moveaxis(hessian, 0, -1))
    half = combination(np.moveaxis(curvature, 2, 0)[:, :, :, np.newaxis], root[:, np.newaxis, np.newaxis])
    turned = combination(np.moveaxis(half, 1, 0)[:, :, np.newaxis], root[:, np.newaxis, :, np.newaxis])
    size, tracks = len(turned), turned.shape[-1]
    flat = turned.reshape(size, turned.shape[1] ** 2, tracks)
    spread = np.empty((size, size, tracks), turned.dtype)
    for i in range(size):
        for j in range(i + 1):
            spread[i, j] = spread[j, i] = combination(flat[i], flat[j]) / 2
    return np.trace(turned, axis1=1, axis2=2) / 2, spread
