"""Beliefs as they are handed over, tracks first, and as they are worked on, tracks last."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray

from radartrack._arrays.batches import fill
from radartrack._arrays.validation import (
    RealArray,
    real_arrays,
    require_covariance,
    require_finite,
    require_parts,
    require_trailing_shape,
)
from radartrack._filtering.elimination import checked_covariances
from radartrack._filtering.factors import widened

Step: TypeAlias = Callable[[RealArray, RealArray, slice], tuple[RealArray, RealArray]]
BLOCK = 2048  # tracks; their covariances stay in the cache, and calls of NumPy are few beside the numbers


class Belief(NamedTuple):
    """Means, shape (..., n), and covariances, shape (..., n, n), or (n, n) where all tracks share one."""

    mean: RealArray
    covariance: RealArray


class Motion(NamedTuple):
    """The transition F and the covariance of the process noise Q from scan to scan, shape (n, n)."""

    transition: RealArray
    process_noise: RealArray


def require_belief(name: str, given: object) -> None:
    """Check that something has a mean and a covariance.

    Raises:
        TypeError: it has not.

    """
    require_parts(name, given, Belief._fields, "a Belief of a mean and a covariance")


def common(measured: tuple[int, ...], noise: tuple[int, ...], name: str = "noise") -> tuple[int, ...]:
    """The leading shape of measurements and their noise together, or of something else that is named."""
    try:
        return np.broadcast_shapes(measured, noise)
    except ValueError:
        raise ValueError(f"measured and {name} must broadcast; got leading shapes {measured} and {noise}") from None


def tracks_last(
    belief: Belief, others: tuple[int, ...], dtype: np.dtype[np.floating[Any]]
) -> tuple[tuple[int, ...], RealArray, RealArray]:
    """The shape of the tracks, means (n, tracks), and covariances (n, n, tracks), or (n, n, 1) if shared, in a type."""
    tracks, mean, covariance = flat_tracks(belief, others)
    last = checked_covariances("covariance", np.ascontiguousarray(np.moveaxis(covariance, 0, -1)))
    return tracks, np.ascontiguousarray(mean.T, dtype), widened(last, dtype)


def flat_tracks(belief: Belief, others: tuple[int, ...]) -> tuple[tuple[int, ...], RealArray, RealArray]:
    """The shape of the tracks, means (tracks, n), and matrices (tracks, n, n), or (1, n, n) if shared, not checked.

    The matrices are in the type that they were given in, for they are covariances to the rounding of that.
    """
    mean = real_arrays({"mean": belief.mean, "covariance": belief.covariance})["mean"]
    [covariance] = real_arrays({"covariance": belief.covariance}).values()
    if mean.ndim == 0:
        raise ValueError("mean must have shape (..., n); got a single number")
    require_finite("mean", mean)
    size = mean.shape[-1]
    require_trailing_shape("covariance", covariance, (size, size))
    try:
        tracks = np.broadcast_shapes(mean.shape[:-1], others)
        np.broadcast_to(covariance, (*tracks, size, size))
    except ValueError:
        shapes = f"{mean.shape} of mean, {covariance.shape} of covariance and {others} of the measured tracks"
        raise ValueError(f"shapes must broadcast; got {shapes}") from None
    flat = np.broadcast_to(mean, (*tracks, size)).reshape(-1, size)
    leading = zip(covariance.strides, covariance.shape[:-2], strict=False)
    if all(length == 1 or (length > 0 and stride == 0) for stride, length in leading):
        return tracks, flat, covariance[(0,) * (covariance.ndim - 2)][np.newaxis]
    return tracks, flat, np.broadcast_to(covariance, (*tracks, size, size)).reshape(-1, size, size)


def in_blocks(mean: RealArray, covariance: RealArray, step: Step) -> tuple[RealArray, RealArray]:
    """Beliefs after a step, block by block, on all cores.

    Args:
        mean: (tracks, n).
        covariance: (tracks or 1, n, n), not checked.
        step: makes of means (n, tracks) and covariances (n, n, tracks or 1), checked, of some tracks, whose places it
            is told, new means and covariances (n, n, tracks).

    Returns:
        Means (tracks, n) and covariances (tracks, n, n).

    Raises:
        ValueError: a covariance is none, or something found is not finite.

    """
    size = mean.shape[-1]
    means, covariances = np.empty(mean.shape, mean.dtype), np.empty((*mean.shape, size), mean.dtype)

    def block(numbers: NDArray[np.intp], new_means: RealArray, new_covariances: RealArray) -> None:
        own = slice(numbers[0], numbers[-1] + 1) if len(numbers) else slice(0)
        few = covariance if len(covariance) == 1 else covariance[own]
        at = np.ascontiguousarray(mean[own].T)
        spread = checked_covariances("covariance", np.ascontiguousarray(np.moveaxis(few, 0, -1)))
        spread = widened(spread, mean.dtype)
        with np.errstate(over="ignore", invalid="ignore", divide="ignore"):
            found, reduced = step(at, spread, own)
        new_means[...], new_covariances[...] = found.T, np.moveaxis(reduced, -1, 0)
        require_finite("the mean of the result", new_means)
        require_finite("the covariance of the result", new_covariances)

    try:
        fill(block, [np.arange(len(mean))], [means, covariances], BLOCK)
    except ValueError:  # of one block; the message is to count among all
        require_covariance("covariance", covariance if len(covariance) != 1 else covariance[0])
        raise
    return means, covariances


def checked_motion(motion: Motion, size: int) -> Motion:
    """The matrices of a linear motion of so many components.

    Raises:
        TypeError: it is none, or a part is not made of real numbers.
        ValueError: they do not fit, or the noise is no covariance.

    """
    require_parts("motion", motion, Motion._fields, "a Motion of a transition and a process noise")
    arrays = real_arrays({"transition": motion.transition, "process_noise": motion.process_noise})
    for name, array in arrays.items():
        if array.shape != (size, size) or not np.isfinite(array).all():
            raise ValueError(f"{name} must be finite, of shape ({size}, {size}); got {array.tolist()}")
    require_covariance("process_noise", arrays["process_noise"])
    return Motion(arrays["transition"], arrays["process_noise"])


def tracks_first(mean: RealArray, covariance: RealArray, tracks: tuple[int, ...]) -> Belief:
    """Means (..., n) and covariances (..., n, n) of all tracks, all of them finite."""
    means, covariances = np.moveaxis(mean, -1, 0), np.moveaxis(covariance, -1, 0)
    require_finite("the mean of the result", means)
    require_finite("the covariance of the result", covariances)
    first = means.reshape(*tracks, *means.shape[1:])
    if len(covariances) == 1:
        return Belief(first, np.broadcast_to(covariances[0], (*tracks, *covariances.shape[1:])))
    return Belief(first, covariances.reshape(*tracks, *covariances.shape[1:]))


def measured_values(values: RealArray, noise: ArrayLike, size: int) -> tuple[RealArray, RealArray]:
    """Measurements, and R in the type that it was given in, for it is a covariance to the rounding of that."""
    [R] = real_arrays({"noise": noise}).values()
    require_trailing_shape("noise", R, (size, size))
    require_trailing_shape("measured", values, (size,))
    if np.isinf(values).any():
        raise ValueError(f"measured must be finite, or NaN where missing; got {np.isinf(values).sum()} infinite")
    require_finite("noise", R)
    return values, _checked_noise(R)


def _checked_noise(R: RealArray) -> RealArray:
    """Covariances of errors (..., m, m), symmetric to the last bit. Errors may be one; none may be nothing.

    Raises:
        ValueError: a matrix is no covariance, or has a variance of 0.

    """
    size = R.shape[-1]
    own = R[tuple(slice(0, 1) if stride == 0 else slice(None) for stride in R.strides[:-2])]
    last = np.ascontiguousarray(np.moveaxis(own.reshape(-1, size, size), 0, -1))
    try:
        checked = checked_covariances("noise", last)
    except ValueError:  # the message is to count among all
        require_covariance("noise", R)
        raise
    if not (np.diagonal(checked) > 0).all():
        raise ValueError("noise must have variances of more than 0; got one that is 0")
    return R if checked is last else np.where(np.triu(np.ones((size, size), dtype=bool)), R, R.swapaxes(-1, -2))
