"""From sums to p-values that hold without a normal distribution, and the smallest error that would have been seen."""

from __future__ import annotations

import math
from dataclasses import dataclass
from fractions import Fraction
from statistics import NormalDist

from radartrack.verification.simulation.exact_sum import ExactSum

POWERS = 4  # of draws, whose sums say mean, deviation, skewness and kurtosis
FALSE_ALARM = 1e-6
POWER = 0.999
MOST_CORRECTION = 4.0
_NORMAL = NormalDist()


@dataclass(frozen=True)
class Mean:
    """An estimated mean and the shape of what was averaged.

    Attributes:
        draws: how many.
        value: their mean.
        deviation: their standard deviation.
        skewness: E[(x − mean)³]/deviation³.
        kurtosis: E[(x − mean)⁴]/deviation⁴ − 3.
    """

    draws: int
    value: float
    deviation: float
    skewness: float
    kurtosis: float

    @classmethod
    def of(cls, draws: int, powers: tuple[ExactSum, ...]) -> Mean:
        """From the exact sums of the first four powers; central moments lose nothing to cancellation."""
        first, second, third, fourth = (total.fraction / draws for total in powers)
        variance = second - first**2
        deviation = math.sqrt(max(variance, Fraction(0)))
        if deviation == 0:
            return cls(draws, float(first), 0.0, 0.0, 0.0)
        cubed = third - 3 * first * second + 2 * first**3
        quartic = fourth - 4 * first * third + 6 * first**2 * second - 3 * first**4
        return cls(
            draws, float(first), deviation, float(cubed / variance) / deviation, float(quartic / variance**2) - 3
        )

    @property
    def error(self) -> float:
        """The standard error of the mean."""
        return self.deviation / math.sqrt(self.draws)

    def standardised(self, rounding: float = 0.0) -> float:
        """By how many standard errors the mean is off zero, beyond what rounding may do."""
        beyond = max(abs(self.value) - rounding, 0.0)
        if not beyond:
            return 0.0
        return math.copysign(beyond / self.error if self.error else math.inf, self.value)

    def correction(self, z: float) -> float:
        """The logarithm of how much larger than the normal one the tail beyond z may be.

        The leading terms of the Cramér-Petrov series for large deviations, with their absolute values; a mean that
        is divided by its own estimated deviation has a third of the skewness term twice, which is within it.
        """
        root, x = math.sqrt(self.draws), abs(z)
        cubic = x**3 * abs(self.skewness) / (3 * root)
        return cubic + x**4 * (abs(self.kurtosis) + 3 * self.skewness**2) / (8 * self.draws)

    def p_value(self, rounding: float = 0.0) -> float:
        """The probability, two-sided and corrected, of a mean at least as far off by chance."""
        z = abs(self.standardised(rounding))
        if math.isinf(z):
            return 0.0
        return min(1.0, math.erfc(z / math.sqrt(2)) * math.exp(min(700.0, self.correction(z))))

    def plain_p_value(self) -> float:
        """The same by the normal distribution alone: uniform on correct code, for calibration."""
        return math.erfc(abs(self.standardised()) / math.sqrt(2))


def threshold(tests: int) -> float:
    """The standardised deviation beyond which a test, one of so many that share the false alarms, fails."""
    return -_NORMAL.inv_cdf(FALSE_ALARM / tests / 2)


def detectable(mean: Mean, rounding: float, tests: int) -> float:
    """The smallest error of the mean that is found with probability POWER, rounding and correction included."""
    limit = threshold(tests)
    widened = math.sqrt(limit**2 + 2 * mean.correction(limit))
    return (widened + _NORMAL.inv_cdf(POWER)) * mean.error + 2 * rounding
