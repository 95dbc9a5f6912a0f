"""The ellipsoid that stands for the Earth, and the point of it that is nearest to another."""

from dataclasses import dataclass

import numpy as np

from radartrack._arrays.validation import RealArray, number_between, positive_number
from radartrack.frames.exact_products import Pair, product, square_root

MOST_STEPS = 64  # of Newton's; from these starts ten have always been enough
FLATTEST = 0.5  # beyond, the bounds from which the search starts are worth little
SETTLED = 4 * np.finfo(np.float64).eps


@dataclass(frozen=True)
class Ellipsoid:
    """An ellipsoid of revolution.

    Attributes:
        semi_major_axis: its equatorial radius [m].
        flattening: one less the ratio of its polar radius to that, from 0, a sphere, to 0.5.

    Raises:
        TypeError: an attribute is no real number.
        ValueError: it is not finite or out of place.
    """

    semi_major_axis: float
    flattening: float

    def __post_init__(self) -> None:
        positive_number("semi_major_axis", self.semi_major_axis)
        number_between("flattening", self.flattening, 0.0, FLATTEST)

    @property
    def squared_eccentricity(self) -> float:
        """One less the square of the ratio of the radii."""
        return self.flattening * (2.0 - self.flattening)

    def normal_through(self, from_axis: RealArray, above: RealArray) -> tuple[RealArray, RealArray]:
        """The normal to the nearest point of the meridian's ellipse, as components of no stated length.

        The nearest point is (P a^2/(k + e^2), Z b^2/k ...) over its radii, where k is the root of
        (P/(k + e^2))^2 + (Q/k)^2 = 1, P the distance from the axis over a, Q that from the equator times b over a^2.
        The left side falls and is convex, so Newton's steps from below the root stay below and never fail.

        Args:
            from_axis: distance from the axis, not negative.
            above: distance from the plane of the equator, not negative.

        """
        ratio, e2 = 1.0 - self.flattening, self.squared_eccentricity
        P, Q = from_axis / self.semi_major_axis, above / self.semi_major_axis * ratio
        k = _below_root(P, Q, e2)
        with np.errstate(divide="ignore", invalid="ignore", over="ignore", under="ignore"):
            for _ in range(MOST_STEPS):
                cosine, sine = _over(P, k + e2), _over(Q, k)
                slope = cosine**2 / (k + e2) + sine * _over(sine, k)
                step = np.where(slope > 0, 0.5 * (cosine**2 + sine**2 - 1.0) / slope, 0.0)
                step = np.where(k > 0, step, 0.0)
                k = k + step
                if np.all(np.abs(step) <= SETTLED * k):
                    break
        cosine = _over(P, k + e2)
        # In the disc about the centre, in the plane of the equator, the two nearest points lie off the plane.
        sine = np.where(k > 0, _over(Q, k), np.sqrt(np.maximum(1.0 - cosine**2, 0.0)))
        return cosine * ratio, sine

    def height_along(
        self, position: tuple[RealArray, RealArray, RealArray], cosine: RealArray, sine: RealArray
    ) -> RealArray:
        """How far a position is outside, along a normal of this direction in its meridian.

        It is n'x less the support function of the ellipsoid, which is the least where n is right: an error of the
        direction enters squared. Of the two large numbers the difference is taken in twice the digits.
        """
        x, y, z = position
        squares = product(x, x) + product(y, y)
        along = square_root(squares) * cosine + product(z, sine)
        ratio = Pair.of_difference(1.0, self.flattening)
        support = square_root(product(cosine, cosine) + ratio.squared() * sine * sine) * self.semi_major_axis
        return (along - support).rounded()


def _over(above: RealArray, below: RealArray) -> RealArray:
    """Quotients, zero where nothing is divided by nothing."""
    return np.asarray(np.divide(above, below, out=np.zeros_like(above), where=below > 0))


def _below_root(P: RealArray, Q: RealArray, e2: float) -> RealArray:
    """A bound of the root from below that is near it, wherever the point lies.

    Far out it is that of Jensen's inequality, off by the square of e^2. About the ring in which the curvature of the
    ellipse is centred, the first term is bounded by its tangent, and the cubic that results by its two terms.
    """
    size, beyond, cubed = np.hypot(P, Q), P - e2, Q * Q * P / 2.0
    with np.errstate(divide="ignore", invalid="ignore", under="ignore"):
        outside = size - e2 * _over(P, size) ** 2
        inside = np.minimum(np.cbrt(cubed / 2.0), Q * np.sqrt(_over(P, np.maximum(-4.0 * beyond, 0.0))))
    about = np.where(beyond >= 0, np.cbrt(cubed), inside)
    return np.asarray(np.maximum.reduce([np.zeros_like(P), Q, beyond, outside, about]))


WGS84 = Ellipsoid(6_378_137.0, 1.0 / 298.257223563)
