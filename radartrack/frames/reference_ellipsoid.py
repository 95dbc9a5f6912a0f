"""The ellipsoid that stands for the Earth, and the point of it that is nearest to another."""

from dataclasses import dataclass

import numpy as np

from radartrack._arrays.validation import RealArray, number_between, positive_number
from radartrack.frames.exact_products import product, square_root, sum_of
from radartrack.frames.exact_sines import sine_and_cosine

MOST_STEPS = 64  # of Newton's; from these starts ten have always been enough
FLATTEST = 0.5  # beyond, the bounds from which the search starts are worth little
SETTLED = 2.0**-28  # a relative step of Newton's here leaves one and a half times its square
SMALLEST = 1e-290  # stands for a root of zero: the square of what is divided by it does not overflow
LEAST_CURVATURE = 1.0  # metres from the centre of curvature; nearer, a latitude is what the search has found
NEAR_THE_RING = 1.0  # in semi-major axes: everywhere inside of the ellipsoid, whatever its flattening


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

    def position(self, latitude: RealArray, longitude: RealArray, height: RealArray) -> tuple[RealArray, ...]:
        """x, y and z, each but for its last rounding: sines, products and sums are taken in twice the digits."""
        sine, cosine = sine_and_cosine(latitude)
        sine_of_longitude, cosine_of_longitude = sine_and_cosine(longitude)
        excess = self._excess(sine.high)
        raised = sum_of(height, np.asarray(self.semi_major_axis))
        out = (raised + excess) * cosine
        up = raised + (excess - self.squared_eccentricity * (self.semi_major_axis + excess))
        parts = out * cosine_of_longitude, out * sine_of_longitude, up * sine
        return tuple(part.rounded() for part in parts)

    def _excess(self, sine: RealArray) -> RealArray:
        """By how much the radius of curvature across the meridian is longer than the semi-major axis."""
        less = self.squared_eccentricity * sine**2
        root = np.sqrt(1.0 - less)
        return np.asarray(self.semi_major_axis * less / (root * (1.0 + root)))

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
        with np.errstate(under="ignore"):
            for _ in range(MOST_STEPS):
                by_axis, by_equator = 1.0 / (k + e2), 1.0 / k
                cosines, sines = (P * by_axis) ** 2, (Q * by_equator) ** 2
                step = 0.5 * (cosines + sines - 1.0) / (cosines * by_axis + sines * by_equator + SMALLEST)
                k = k + np.maximum(step, 0.0)
                if np.all(step <= SETTLED * k):
                    break
            cosine, sine = P / (k + e2), Q / k
        # In the disc about the centre the root is zero: the nearest points lie off the plane of the equator.
        off_plane = np.sqrt(np.maximum(1.0 - cosine**2, 0.0))
        return cosine * ratio, np.where(k > SMALLEST, sine, off_plane)

    def along_the_normal(
        self, position: tuple[RealArray, RealArray, RealArray], latitude: RealArray
    ) -> tuple[RealArray, RealArray]:
        """Latitude and height of a position, from a latitude that is right but for rounding.

        How far the normal of that latitude passes the position by tells what it lacks. The height is n'x less the
        support function of the ellipsoid, which is the least where n is right: an error of the direction enters
        squared. Of large numbers the differences are taken in twice the digits.
        """
        x, y, z = position
        sine, cosine = sine_and_cosine(latitude)
        from_axis = square_root(product(x, x) + product(y, y))
        along = from_axis * cosine + sine * z
        ratio = sum_of(np.asarray(1.0), np.asarray(-self.flattening))
        support = square_root(cosine.squared() + (ratio * sine).squared())
        height = (along - support * self.semi_major_axis).rounded()
        across = self.semi_major_axis + self._excess(sine.high)
        bent = self.squared_eccentricity * across * sine.high * cosine.high
        aside = (cosine * z - from_axis * sine + bent).rounded()
        lengthening = across / self.semi_major_axis
        curvature = (1.0 - self.squared_eccentricity) * across * lengthening**2 + height
        missing = np.divide(aside, curvature, out=np.zeros_like(aside), where=curvature > LEAST_CURVATURE)
        return latitude + missing, height


def _below_root(P: RealArray, Q: RealArray, e2: float) -> RealArray:
    """A bound of the root from below that is near it, wherever the point lies.

    Far out it is that of Jensen's inequality, off by the square of e^2. About the ring in which the curvature of the
    ellipse is centred, the first term is bounded by its tangent, and the cubic that results by its two terms.
    """
    with np.errstate(under="ignore"):
        size = np.maximum(np.hypot(P, Q), SMALLEST)
        bound = np.maximum(np.maximum(size - e2 * (P / size) ** 2, Q), SMALLEST)
        if (inside := size < NEAR_THE_RING).any():
            p, q = P[inside], Q[inside]
            beyond, cubed = p - e2, q * q * p / 2.0
            short = np.minimum(np.cbrt(cubed / 2.0), q * np.sqrt(p / np.maximum(-4.0 * beyond, SMALLEST)))
            about = np.where(beyond >= 0, np.maximum(beyond, np.cbrt(cubed)), short)
            bound[inside] = np.maximum(bound[inside], about)
    return np.asarray(bound)


WGS84 = Ellipsoid(6_378_137.0, 1.0 / 298.257223563)
