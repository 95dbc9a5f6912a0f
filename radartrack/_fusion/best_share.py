"""The weight of covariance intersection: the least of a convex function between 0 and 1, for any number at once."""

from typing import Literal, NamedTuple, TypeAlias

import numpy as np
from numpy.typing import NDArray

Floats: TypeAlias = NDArray[np.float64]
Criterion: TypeAlias = Literal["trace", "determinant"]
CRITERIA: tuple[Criterion, ...] = ("trace", "determinant")

MOST_STEPS = 1100  # halvings of the interval come to an end before; Newton's steps take about six
SHARP = 4e-16  # of the interval from 0 to 1
SAME = 1e-14  # ratios of variances no farther from one, which no weight changes beyond rounding
LEAST_RATIO = 1e-12  # of deviations along one axis to those along another; rounding leaves four digits of it
LARGEST_RATIO = 1e60  # of variances of one component; cubes of what is far larger overflow
UNEQUAL = (
    "covariance must hold two that are not too unequal: along one axis the first may be better than the second by 1e12 "
    "times what it is along another, in deviations, and no variance may be more than 1e60 times the other"
)


class Pencil(NamedTuple):
    """Two covariances on common axes: P1 = C C' and P2 = C diag(s) C'.

    Attributes:
        axes: C, shape (..., d, d).
        inverse: of C.
        ratios: s, shape (..., d).
    """

    axes: Floats
    inverse: Floats
    ratios: Floats

    def intersected(self, share: Floats) -> Floats:
        """(w P1^-1 + (1 - w) P2^-1)^-1, a sum of squares, for w of shape (...)."""
        root = self.axes * np.sqrt(self.ratios / self.mixed(share))[..., np.newaxis, :]
        squares: Floats = (root[..., :, np.newaxis, :] * root[..., np.newaxis, :, :]).sum(axis=-1)
        return squares

    def mixed(self, share: Floats) -> Floats:
        """w s + 1 - w."""
        w = share[..., np.newaxis]
        return w * self.ratios + (1 - w)

    def best_share(self, criterion: Criterion) -> Floats:
        """The w of least trace, or of least determinant.

        Both, the latter's logarithm, are convex in w; so the slope changes sign once. Newton's steps for its zero, and
        halves of the interval where such a step would leave it. Of equal covariances every w is best: a half.
        """
        sizes = (self.axes**2).sum(axis=-2) * self.ratios
        sizes = sizes / sizes.max(axis=-1, keepdims=True)

        def slopes(share: Floats) -> tuple[Floats, Floats]:
            relative = (self.ratios - 1) / self.mixed(share)
            terms = sizes / self.mixed(share) * relative if criterion == "trace" else relative
            return -terms.sum(axis=-1), (terms * relative).sum(axis=-1) * (2 if criterion == "trace" else 1)

        low, high = np.zeros(self.ratios.shape[:-1]), np.ones(self.ratios.shape[:-1])
        ends = slopes(low)[0] >= 0, slopes(high)[0] <= 0
        share = np.full_like(low, 0.5)
        for _ in range(MOST_STEPS):
            slope, bend = slopes(share)
            low, high = np.where(slope < 0, share, low), np.where(slope > 0, share, high)
            with np.errstate(divide="ignore", invalid="ignore"):
                step = share - slope / bend
            following = np.where((step > low) & (step < high), step, (low + high) / 2)
            done = (np.abs(following - share) <= SHARP) | (slope == 0)
            share = np.where(slope == 0, share, following)
            if done.all():
                break
        found = np.where(ends[0], 0.0, np.where(ends[1], 1.0, share))
        return np.where((np.abs(self.ratios - 1) <= SAME).all(axis=-1), 0.5, found)


def pencil_of(first: Floats, second: Floats) -> Pencil:
    """Common axes of two covariances, shape (..., d, d), positive definite by more than rounding.

    From singular values of factors, which keep twice as many digits of s as eigenvalues of the product do.

    Raises:
        ValueError: they are too unequal for the digits of a float.
    """
    variances, others = (np.diagonal(part, axis1=-2, axis2=-1) for part in (first, second))
    distance = np.abs(np.log10(variances) - np.log10(others))
    if not (distance <= np.log10(LARGEST_RATIO)).all():
        raise ValueError(UNEQUAL)
    scale = np.sqrt(variances)
    one, other = (part / scale[..., :, np.newaxis] / scale[..., np.newaxis, :] for part in (first, second))
    factor = np.linalg.cholesky(one)
    size = np.sqrt(np.trace(other, axis1=-2, axis2=-1))[..., np.newaxis]
    inner = np.linalg.solve(factor, np.linalg.cholesky(other / size[..., np.newaxis] ** 2))
    vectors, roots, _ = np.linalg.svd(inner)
    if not (roots[..., -1] > LEAST_RATIO * roots[..., 0]).all():
        raise ValueError(UNEQUAL)
    inverse = np.swapaxes(np.linalg.solve(np.swapaxes(factor, -1, -2), vectors), -1, -2)
    return Pencil(scale[..., np.newaxis] * (factor @ vectors), inverse / scale[..., np.newaxis, :], (size * roots) ** 2)
