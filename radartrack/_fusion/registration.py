"""Constant biases of radars from targets that several of them see: least squares in what is measured."""

from typing import NamedTuple, TypeAlias

import numpy as np
from numpy.typing import NDArray

from radartrack._conversion.sensors import AzimuthFrom
from radartrack.generated import observe as formulas

Floats: TypeAlias = NDArray[np.float64]
MOST_STEPS = 50
SMALL = 1e-6  # of a deviation; steps shrink by far more from one to the next
SINGULAR = 1e-9  # of the best determined combination of biases; rounding leaves about 1e-14


class Plots(NamedTuple):
    """What radars measured of common targets, (..., radars, targets), and where they stand.

    Attributes:
        measured: range and azimuth, (..., radars, targets, 2); NaN where a radar does not see a target.
        deviations: of their errors, of the same shape.
        sites: x and y, (radars, 2).
        azimuth_from: the axis from which azimuths are counted.
    """

    measured: Floats
    deviations: Floats
    sites: Floats
    azimuth_from: AzimuthFrom


class Estimated(NamedTuple):
    """Biases of range and azimuth, (..., radars, 2), and the covariance of their errors, (..., 2 radars, 2 radars)."""

    bias: Floats
    covariance: Floats


def estimated(plots: Plots, unknown: NDArray[np.bool_]) -> Estimated:
    """Positions and biases that together leave the least squares of the deviations, by Gauss and Newton.

    Args:
        plots: of the radars.
        unknown: which biases are to be estimated, (radars, 2); the others are zero.

    Raises:
        ValueError: the targets do not determine the biases, or no least squares are found.
    """
    seen = ~np.isnan(plots.measured).any(axis=-1)
    seen &= seen.sum(axis=-2, keepdims=True) > 1  # who is seen by one radar tells nothing of biases
    weights = np.where(seen[..., np.newaxis], 1 / plots.deviations, 0.0)
    position = _start(plots, seen)
    bias = np.zeros((*plots.measured.shape[:-2], 2))
    for _ in range(MOST_STEPS):
        step = _step(plots, seen, weights, position, bias, unknown.ravel())
        position, bias = position + step.position, bias + step.bias
        deviations = np.sqrt(np.diagonal(step.covariance, axis1=-2, axis2=-1))
        if (np.abs(step.bias.reshape(deviations.shape)) <= SMALL * deviations).all():
            return Estimated(bias, step.covariance)
    raise ValueError("plots must be of common targets; positions and biases that fit them are not found")


class _Step(NamedTuple):
    position: Floats
    bias: Floats
    covariance: Floats


def _start(plots: Plots, seen: NDArray[np.bool_]) -> Floats:
    """The middle of where the radars see each target, (..., targets, 2)."""
    r, azimuth = np.moveaxis(np.nan_to_num(plots.measured), -1, 0)
    along = [r * np.cos(azimuth), r * np.sin(azimuth)]
    places = np.stack(along if plots.azimuth_from == "x" else along[::-1], axis=-1) + plots.sites[:, np.newaxis]
    count = np.maximum(seen.sum(axis=-2), 1)[..., np.newaxis]
    middle: Floats = np.where(seen[..., np.newaxis], places, 0.0).sum(axis=-3) / count
    return middle


def _step(
    plots: Plots,
    seen: NDArray[np.bool_],
    weights: Floats,
    position: Floats,
    bias: Floats,
    unknown: NDArray[np.bool_],
) -> _Step:
    """The least squares of the linearised measurements; each target's position is taken out by a factorisation."""
    offsets = position[..., np.newaxis, :, :] - plots.sites[:, np.newaxis]
    order = [0, 1] if plots.azimuth_from == "x" else [1, 0]
    at = dict(zip(("x", "y"), np.moveaxis(offsets[..., order], -1, 0), strict=True))
    residuals = np.nan_to_num(plots.measured) - formulas.polar_map(**at) - bias[..., np.newaxis, :]
    residuals[..., 1] -= 2 * np.pi * np.round(residuals[..., 1] / (2 * np.pi))
    by_position = formulas.polar_jacobian(**at)[..., order]
    # From here on with the targets before the radars, as every target has equations of its own.
    slopes, white, left = (np.swapaxes(a, a.ndim - b, a.ndim - b + 1) for a, b in (
        (by_position * weights[..., np.newaxis], 4), (weights, 3), (residuals * weights, 3),
    ))  # fmt: skip
    *others, targets, radars, _ = white.shape
    count = 2 * radars
    slopes, white, left = (
        slopes.reshape(*others, targets, count, 2),
        white.reshape(*others, targets, count),
        left.reshape(*others, targets, count),
    )
    columns = white[..., np.newaxis] * np.eye(count)
    whole = np.concatenate([slopes, columns[..., unknown], left[..., np.newaxis]], axis=-1)
    factor = _triangle(whole)
    told = np.asarray(np.swapaxes(seen, -1, -2).any(axis=-1))
    rest = factor[..., 2:, 2:]
    stacked = rest.reshape(*others, targets * rest.shape[-2], rest.shape[-1])
    change, covariance = _solved(stacked)
    before = factor[..., :2, :]
    triangle = np.where(told[..., np.newaxis, np.newaxis], before[..., :2], np.eye(2))
    known = before[..., -1] - (before[..., 2:-1] @ change[..., np.newaxis, :, np.newaxis])[..., 0]
    moved = np.linalg.solve(triangle, np.where(told[..., np.newaxis], known, 0.0)[..., np.newaxis])[..., 0]
    full, spread = np.zeros((*others, count)), np.zeros((*others, count, count))
    full[..., unknown] = change
    places = np.flatnonzero(unknown)
    spread[..., places[:, np.newaxis], places] = covariance
    return _Step(moved, full.reshape(*others, radars, 2), spread)


def _solved(rows: Floats) -> tuple[Floats, Floats]:
    """The least squares of rows, whose last column is the right side, and the covariance of the solution."""
    size = rows.shape[-1] - 1
    scale = np.sqrt((rows[..., :size] ** 2).sum(axis=-2))
    undetermined = ValueError(
        "targets must determine the biases: more of them, seen by two radars or more at different sites, not all on "
        "the line through the sites; or a reference radar must be named, or the plots are not of common targets"
    )
    if rows.shape[-2] < size or not (scale > 0).all():
        raise undetermined
    scaled = np.concatenate([rows[..., :size] / scale[..., np.newaxis, :], rows[..., size:]], axis=-1)
    factor = _triangle(scaled)
    triangle = factor[..., :size, :size]
    sizes = np.linalg.svd(triangle, compute_uv=False)
    if not (sizes[..., -1] > SINGULAR * sizes[..., 0]).all():
        raise undetermined
    root = np.linalg.solve(triangle, np.broadcast_to(np.eye(size), triangle.shape)) / scale[..., :, np.newaxis]
    change: Floats = (root @ factor[..., :size, size:])[..., 0]
    return change, root @ np.swapaxes(root, -1, -2)


def _triangle(rows: Floats) -> Floats:
    """R of an orthogonal factorisation."""
    return np.asarray(np.linalg.qr(rows, mode="r"), np.float64)
