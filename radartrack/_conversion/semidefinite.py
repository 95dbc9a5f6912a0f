"""Covariances that are symmetric and positive semidefinite, whatever rounding leaves of them.

Rounding is relative to what a formula adds up. Where errors are fully correlated a variance may cancel to less than
that, and where numbers are so small that their products underflow it may vanish beside covariances that do not. Such
plots are rare; they are known by their arguments, told from the others by Cholesky's pivots, and computed again with
care.
"""

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from radartrack._arrays.validation import SINGLE, RealArray

CORRELATED = 0.9  # up to here no variance is less than a tenth of what it is without the correlation
SMALL = 1e-60  # products of four such numbers, and of the sines at a right angle, do not underflow
NOTHING = 1e-140  # the square of a smaller number, times a small factor, has lost digits
ROUNDING = 256  # units in the last place that an eigenvalue of the correlations may be off

Symbols = Mapping[str, RealArray]


def is_plain(values: Mapping[str, float]) -> bool:
    """Whether one plot, in plain numbers by symbol, has a sound covariance without care."""
    return abs(values["rho"]) <= CORRELATED and not any(0 < abs(value) < SMALL for value in values.values())


def are_plain(values: Symbols, covariances: RealArray) -> bool:
    """Whether plots, by symbol, have sound covariances without care.

    In float32 the covariances themselves tell what underflowed, in float64 the arguments are quicker to ask.
    """
    if _largest(values["rho"]) > CORRELATED:
        return False
    if covariances.dtype == SINGLE:
        return bool(_variances(covariances).min(initial=1) >= _least(covariances.dtype))
    if all(_smallest(array) >= SMALL for symbol, array in values.items() if _is_size(symbol)):
        return True
    return all(bool((sizes >= SMALL)[sizes > 0].all()) for sizes in map(np.abs, values.values()))


def plain_interval(symbol: str, low: float, high: float) -> tuple[float, float]:
    """The part of an interval in which plots are plain, whatever the other numbers: what most plots are."""
    if symbol == "rho":
        return max(low, -CORRELATED), min(high, CORRELATED)
    return (max(low, SMALL), high) if _is_size(symbol) else (low, high)


def _is_size(symbol: str) -> bool:
    """Whether, where none of these is small, every variance has a term that is not, whatever the angles."""
    return symbol in {"r", "path"} or "sigma" in symbol


def _smallest(array: RealArray) -> float:
    return float(array.min(initial=SMALL)) if array.ndim else float(array)


def _largest(array: RealArray) -> float:
    return max(float(array.max(initial=0)), -float(array.min(initial=0))) if array.ndim else abs(float(array))


def are_sound(covariances: RealArray, least_pivot: float = 0.0) -> NDArray[np.bool_]:
    """Which of the matrices, shape (plots, n, n), have variances with all their digits, and larger pivots than that."""
    variances = _variances(covariances)
    sound: NDArray[np.bool_] = np.all(variances >= _least(covariances.dtype), axis=-1)
    deviations = np.sqrt(np.where(sound[:, np.newaxis], variances, 1))
    with np.errstate(over="ignore", invalid="ignore"):  # in those that are not
        rest = covariances / deviations[:, :, np.newaxis] / deviations[:, np.newaxis, :]
        while rest.shape[-1]:
            pivot, column = rest[:, :1, :1], rest[:, 1:, :1]
            sound &= pivot[:, 0, 0] > least_pivot
            rest = rest[:, 1:, 1:] - column * column.swapaxes(-1, -2) / np.where(pivot > 0, pivot, 1)
    return sound


def nearest(covariances: RealArray, independent: RealArray) -> RealArray:
    """Make matrices, shape (plots, n, n), products of a matrix and its transpose, changing them within rounding.

    Args:
        covariances: what formulas give.
        independent: what they give without correlation; rounding is relative to its variances.

    Raises:
        ValueError: a matrix is further from being positive semidefinite.

    """
    variances = np.maximum(_variances(independent), np.abs(_variances(covariances)))
    deviations, values, vectors = _correlations(covariances, variances)
    least, limit = values.min(initial=0), -ROUNDING * np.finfo(covariances.dtype).eps
    if not least >= limit:
        allowed = f"positive semidefinite: eigenvalues of its correlations from {limit:.2g}"
        raise ValueError(f"the covariance must be {allowed}; got {least:.2g}, for which the formulas are no use")
    return squares(_roots(deviations, values, vectors))


def roots(covariances: RealArray) -> RealArray:
    """Matrices, shape (..., n, n), that times their transposes are these covariances within rounding."""
    return _roots(*_correlations(covariances, _variances(covariances)))


def squares(matrices: RealArray) -> RealArray:
    """Matrices, shape (..., n, m), times their transposes, symmetric to the last bit."""
    products: RealArray = (matrices[..., :, np.newaxis, :] * matrices[..., np.newaxis, :, :]).sum(axis=-1)
    return products


def _correlations(covariances: RealArray, variances: RealArray) -> tuple[RealArray, RealArray, RealArray]:
    """Deviations, and the eigenvalues and eigenvectors of the correlations."""
    deviations = np.sqrt(variances)  # what has none keeps none, whatever eigenvectors rounding mixes
    divisors = np.where(deviations > 0, deviations, 1)
    values, vectors = np.linalg.eigh(covariances / divisors[..., :, np.newaxis] / divisors[..., np.newaxis, :])
    return deviations, values, vectors


def _roots(deviations: RealArray, values: RealArray, vectors: RealArray) -> RealArray:
    found: RealArray = deviations[..., :, np.newaxis] * vectors * np.sqrt(np.maximum(values, 0))[..., np.newaxis, :]
    return found


def cast(covariances: RealArray, dtype: np.dtype[Any]) -> RealArray:
    """In a type in which a variance may be too small; it is 0 then, and its covariances with it."""
    too_small = _variances(covariances) < (np.finfo(dtype).tiny if dtype == SINGLE else _least(dtype))
    either = too_small[..., :, np.newaxis] | too_small[..., np.newaxis, :]
    return np.where(either, 0, covariances).astype(dtype)


def without_nothing(array: RealArray) -> RealArray:
    """In float64; numbers whose squares underflow are 0."""
    return np.where(np.abs(array) < NOTHING, 0.0, array).astype(np.float64)


def _variances(covariances: RealArray) -> RealArray:
    return np.diagonal(covariances, axis1=-2, axis2=-1)


def _least(dtype: np.dtype[Any]) -> float:
    """The least variance in whose sum no product that matters has underflowed."""
    kind = np.finfo(dtype)
    return float(kind.tiny) / float(kind.eps) ** 2
