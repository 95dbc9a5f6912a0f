"""Double and single precision, and for what arguments and by how many terms functions are computed in each."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Precision:
    """A type of numbers.

    Attributes:
        suffix: behind the names of functions.
        bits: of the significand.
        largest_angle: of sine and cosine.
        quarter_bits: enough for the number of right angles in that.
        exact_parts: of π/2 that are multiplied without rounding; one more is rounded.
        powers: degrees of the polynomials of sine, cosine and exponential.
        exponents: beyond which e^x is zero and infinite.
        doubling_bits: enough for the binary logarithms of these.
    """

    suffix: str
    bits: int
    largest_angle: float
    quarter_bits: int
    exact_parts: int
    powers: tuple[int, int, int]
    exponents: tuple[float, float]
    doubling_bits: int

    @property
    def to_whole(self) -> float:
        """What leaves a number rounded to a whole one when it is added and taken off again."""
        return 1.5 * 2.0 ** (self.bits - 1)


# With 15 and 8 bits for the turns, parts of π/2 are so short that the rest of an angle is off by less than a hundredth
# of its last place even where it is smallest; the proof of radartrack.verification.rounding says by how much.
DOUBLE = Precision("", 53, 2.0**15, 15, 2, (5, 5, 9), (-750.0, 710.0), 11)
SINGLE = Precision("_single", 24, 2.0**8, 8, 3, (2, 2, 4), (-105.0, 89.0), 8)
