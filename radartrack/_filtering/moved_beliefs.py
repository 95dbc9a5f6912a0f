"""Beliefs moved from scan to scan, by matrices or by a motion that is none."""

from __future__ import annotations

from typing import Any

import numpy as np

from radartrack._arrays.validation import RealArray
from radartrack._conversion.semidefinite import cast
from radartrack._filtering.beliefs import Belief, Motion
from radartrack._filtering.extended import curvature_of
from radartrack._filtering.factors import combination, factored, product_of
from radartrack._filtering.nonlinear_motion import NonlinearMotion


def predicted(
    mean: RealArray, covariance: RealArray, motion: Motion | NonlinearMotion, *, second: bool
) -> tuple[RealArray, RealArray]:
    """Means (n, tracks) and covariances (n, n, tracks), or (n, n, 1) if shared, a scan later."""
    if isinstance(motion, NonlinearMotion):
        return _extended(mean, covariance, motion, second=second)
    F, Q = motion
    moved = combination(F.T[:, :, np.newaxis], mean[:, np.newaxis])
    return moved, _carried(F[..., np.newaxis], covariance) + Q[:, :, np.newaxis]


def _extended(
    mean: RealArray, covariance: RealArray, motion: NonlinearMotion, *, second: bool
) -> tuple[RealArray, RealArray]:
    """f, and with its Jacobian F the covariance F P F' + Q; of second order also what curvature adds to each."""
    states = np.ascontiguousarray(mean.T)
    moved, F, Q = (motion.evaluated(name, states) for name in ("map", "jacobian", "process_noise"))
    found, spread = moved.T, _carried(np.moveaxis(F, 0, -1), covariance) + np.moveaxis(Q, 0, -1)
    if second:
        shift, curved = curvature_of(motion.evaluated("hessian", states), covariance)
        found, spread = found + shift, spread + curved
    return found.astype(mean.dtype, copy=False), spread.astype(covariance.dtype, copy=False)


def carried(jacobian: RealArray, covariance: RealArray, dtype: np.dtype[Any]) -> RealArray:
    """J P J' of matrices (..., n, n), a sum of squares: no variance turns negative, whatever axes it is turned to.

    A variance that underflows takes its covariances with it.
    """
    shape = np.broadcast_shapes(jacobian.shape, covariance.shape)
    J, P = (np.moveaxis(np.broadcast_to(part, shape), (-2, -1), (0, 1)) for part in (jacobian, covariance))
    return cast(np.moveaxis(_carried(J, P), (0, 1), (-2, -1)), dtype)


def with_covariance(mean: RealArray, covariance: RealArray) -> Belief:
    """Means and their covariances; of one mean with many covariances as many means."""
    tracks = np.broadcast_shapes(mean.shape[:-1], covariance.shape[:-2])
    means = mean if mean.shape[:-1] == tracks else np.broadcast_to(mean, (*tracks, mean.shape[-1])).copy()
    return Belief(means, covariance)


def _carried(F: RealArray, covariance: RealArray) -> RealArray:
    """F P F', a sum of squares, with F of shape (n, n, tracks or 1)."""
    upper, variances = factored(covariance)
    columns = combination(F.swapaxes(0, 1)[:, :, np.newaxis], upper[:, np.newaxis])
    return product_of(columns, variances)
