"""The cross covariance of two filters' errors that common process noise makes (Bar-Shalom & Campo 1986)."""

from typing import NamedTuple, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray

from radartrack._arrays.validation import (
    broadcast_shape,
    real_arrays,
    require_covariance,
    require_finite,
    require_parts,
    require_trailing_shape,
)
from radartrack._filtering.beliefs import Motion, checked_motion
from radartrack._fusion.whitened_least_squares import whitener

Floats: TypeAlias = NDArray[np.float64]
MOST_DOUBLINGS = 100
SMALL = 1e-16  # of the sum; what is added next is the square of it


class Filtered(NamedTuple):
    """What is to be known of a filter.

    Attributes:
        covariance: after each scan, shape (..., scans, n, n); of a steady filter (..., n, n).
        matrix: H, what its radar measures of the state, shape (m, n).
        noise: R, shape (m, m).
        seen: whether there was a plot at each scan, shape (..., scans).
    """

    covariance: ArrayLike
    matrix: ArrayLike
    noise: ArrayLike
    seen: ArrayLike = True

    def reductions(self, name: str) -> Floats:
        """1 - K H, by which an update multiplies an error, with K = P H' R^-1 of the covariance P after it.

        Raises:
            TypeError: a part is not made of real numbers.
            ValueError: the shapes do not fit, or a covariance is none.
        """
        names = [f"{name}.{part}" for part in ("covariance", "matrix", "noise")]
        arrays = real_arrays(dict(zip(names, self[:3], strict=True)))
        P, H, R = (array.astype(np.float64) for array in arrays.values())
        if H.ndim != 2:
            raise ValueError(f"{names[1]} must have shape (m, n); got shape {H.shape}")
        m, n = H.shape
        require_trailing_shape(names[0], P, (n, n))
        if R.shape != (m, m):
            raise ValueError(f"{names[2]} must have shape {(m, m)}; got {R.shape}")
        require_covariance(names[0], P)
        require_finite(names[1], H)
        require_covariance(names[2], R)
        white = whitener(names[2], R).matrix
        seen = np.asarray(self.seen)
        if seen.dtype != np.bool_:
            raise TypeError(f"{name}.seen must be of booleans; got {seen.dtype}")
        found: Floats = np.eye(n) - P @ ((white @ H).T @ (white @ H))
        broadcast_shape({f"{name}.seen": seen, f"{name}.covariance": P[..., 0, 0]})
        return np.where(seen[..., np.newaxis, np.newaxis], found, np.eye(n))


def recursion(motion: Motion, first: Filtered, second: Filtered, start: ArrayLike) -> Floats:
    """The cross covariance after each scan, shape (..., scans, n, n)."""
    one, other = _reductions(first, second)
    F, Q = checked_motion(motion, one.shape[-1])
    [cross] = real_arrays({"start": start}).values()
    require_finite("start", cross)
    if min(one.ndim, other.ndim) < 3:
        raise ValueError("covariance must have shape (..., scans, n, n); got one matrix: steady_cross_covariance")
    *tracks, scans, size, _ = broadcast_shape({"first.covariance": one, "second.covariance": other})
    if cross.ndim:
        require_trailing_shape("start", cross, (size, size))
        tracks = [*broadcast_shape({"start": cross[..., 0, 0], "covariance": np.broadcast_to(0.0, tracks)})]
    elif cross:
        raise ValueError(f"start must be 0 or have shape (..., {size}, {size}); got {cross}")
    shape = (*tracks, scans, size, size)
    one, other = np.broadcast_to(one, shape), np.broadcast_to(other, shape)
    cross = np.broadcast_to(cross, (*tracks, size, size))
    found = np.empty(shape)
    with np.errstate(over="ignore", invalid="ignore"):  # what overflows is refused
        for scan in range(scans):
            moved = F @ cross @ F.T + Q
            cross = one[..., scan, :, :] @ moved @ np.swapaxes(other[..., scan, :, :], -1, -2)
            found[..., scan, :, :] = cross
    require_finite("the cross covariance of the result", found)
    return found


def steady(motion: Motion, first: Filtered, second: Filtered) -> Floats:
    """The sum over all scans of what their noise leaves, by doubling their number.

    Raises:
        ValueError: it does not come to an end.
    """
    one, other = _reductions(first, second)
    broadcast_shape({"first.covariance": one, "second.covariance": other})
    F, Q = checked_motion(motion, one.shape[-1])
    total = one @ Q @ np.swapaxes(other, -1, -2)
    one, other = one @ F, other @ F
    for _ in range(MOST_DOUBLINGS):
        with np.errstate(over="ignore", invalid="ignore"):
            added = one @ total @ np.swapaxes(other, -1, -2)
            one, other, total = one @ one, other @ other, total + added
        if not np.isfinite(total).all():
            break
        if (np.abs(added).max(axis=(-2, -1)) <= SMALL * np.abs(total).max(axis=(-2, -1))).all():
            return np.asarray(total, np.float64)
    raise ValueError("covariance must be that of filters in a steady state; got one whose errors do not die away")


def _reductions(first: Filtered, second: Filtered) -> tuple[Floats, Floats]:
    """Those of both filters."""
    for name, given in (("first", first), ("second", second)):
        require_parts(name, given, ["reductions"], "a Filtered of a covariance, a matrix and a noise")
    return first.reductions("first"), second.reductions("second")
