"""Least squares of measurements with any covariances, by which errors become uncorrelated ones of variance one."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from radartrack._conversion.semidefinite import ROUNDING

Floats = npt.NDArray[np.float64]

SYMMETRY = 1e-9
DOUBT = 1e-3  # of its deviation may be rounding in a parameter,
DIGITS = 1e-9  # or of what is measured


class Whitener(NamedTuple):
    """What turns errors into uncorrelated ones of variance one.

    Attributes:
        matrix: the inverses of the Cholesky factors, shape (..., n, d, d).
        doubt: how far rounding may have changed what they give, as a share, shape (..., n).
    """

    matrix: Floats
    doubt: Floats


class Estimate(NamedTuple):
    """Parameters, shape (..., p), and a root of the covariance of their errors, shape (..., p, p)."""

    value: Floats
    root: Floats


def whitener(name: str, covariance: Floats) -> Whitener:
    """The inverses of the roots of covariances, shape (..., n, d, d).

    Raises:
        ValueError: one is not symmetric, or not positive definite by more than rounding; it names the argument.
    """
    variances = np.diagonal(covariance, axis1=-2, axis2=-1)
    indefinite = ValueError(f"{name} must be positive definite, by more than rounding; got a matrix that is not")
    if not np.all(variances > 0):
        raise indefinite
    scale = np.sqrt(variances)
    with np.errstate(over="ignore"):
        correlations = covariance / scale[..., :, np.newaxis] / scale[..., np.newaxis, :]
    if not np.all(np.abs(correlations) < 1 + SYMMETRY):
        raise indefinite
    if not np.all(np.abs(correlations - np.swapaxes(correlations, -1, -2)) <= SYMMETRY):
        raise ValueError(f"{name} must be symmetric; got a matrix that is not")
    try:
        factor = np.linalg.cholesky(correlations).astype(np.float64, copy=False)
    except np.linalg.LinAlgError:
        raise indefinite from None
    if not np.all(np.diagonal(factor, axis1=-2, axis2=-1) ** 2 > ROUNDING * np.finfo(np.float64).eps):
        raise indefinite
    inverse = _inverse(factor)
    doubt = np.finfo(np.float64).eps * np.abs(inverse).max(axis=(-2, -1)) ** 2
    return Whitener(inverse / scale[..., np.newaxis, :], doubt)


def _inverse(factor: Floats) -> Floats:
    inverse = np.linalg.solve(factor, np.broadcast_to(np.eye(factor.shape[-1]), factor.shape))
    return inverse.astype(np.float64, copy=False)


def applied(matrices: Floats, values: Floats) -> Floats:
    """Each matrix times its vector."""
    found: Floats = (matrices @ values[..., np.newaxis])[..., 0]
    return found


def of_most_accurate(values: Floats, white: Whitener) -> Floats:
    """For each coordinate the value that the most accurate measurement of it has, shape (..., 1, d).

    Counted from there no rounding error gets the weight of an accurate measurement.
    """
    accuracy = np.broadcast_to(np.abs(white.matrix).max(axis=-2), values.shape)
    return np.take_along_axis(values, np.argmax(accuracy, axis=-2)[..., np.newaxis, :], axis=-2)


def least_squares(design: Floats, white: Whitener, observed: Floats) -> Estimate:
    """Parameters from observations, shape (..., n, d), of which each has a design, shape (..., n, d, p).

    What the estimate leaves is fitted once more: its rounding then goes with the residuals. Another fit must add
    nothing.

    Raises:
        ValueError: double precision cannot tell the parameters.
    """
    rows = np.broadcast_to(white.matrix @ design, (*observed.shape, design.shape[-1]))
    first = factorised(rows, applied(white.matrix, observed))
    second = factorised(rows, left := _left(first.value, design, white, observed))
    value, deviations = first.value + second.value, np.abs(first.root).max(axis=-1)
    again = factorised(rows, _left(value, design, white, observed))
    doubt = (np.abs(left).max(axis=-1) * white.doubt).max(axis=-1)[..., np.newaxis] * deviations
    size = np.concatenate([np.abs(observed).max(axis=-2)] * (design.shape[-1] // observed.shape[-1]), axis=-1)
    if not np.all(np.maximum(doubt, np.abs(again.value)) <= DOUBT * deviations + DIGITS * size):
        raise ValueError("covariance must be less unequal for measurements that differ by so many deviations")
    return Estimate(value, first.root)


def _left(value: Floats, design: Floats, white: Whitener, observed: Floats) -> Floats:
    """What parameters leave of the observations, in deviations."""
    return applied(white.matrix, observed - applied(design, value[..., np.newaxis, :]))


def factorised(rows: Floats, observed: Floats) -> Estimate:
    """Parameters from white observations, shape (..., n, d), by an orthogonal factorisation of their rows."""
    *tracks, count, size, parameters = rows.shape
    rows = rows.reshape(*tracks, count * size, parameters)
    scale = np.abs(rows).max(axis=-2, keepdims=True)
    both = np.concatenate([rows / scale, observed.reshape(*tracks, count * size, 1)], axis=-1)
    factor = np.asarray(np.linalg.qr(both, mode="r"), np.float64)[..., :parameters, :]
    root = _inverse(factor[..., :parameters]) / np.swapaxes(scale, -1, -2)
    return Estimate(applied(root, factor[..., parameters]), root)


def squares(root: Floats) -> Floats:
    """The products of the rows of each matrix, symmetric to the last bit."""
    found: Floats = (root[..., :, np.newaxis, :] * root[..., np.newaxis, :, :]).sum(axis=-1)
    return found
