"""Sums of floating-point numbers without rounding, so that no order of adding them changes a bit."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass
from fractions import Fraction

UNIT = 1074  # every double is a whole multiple of 2^-1074


@dataclass(frozen=True)
class ExactSum:
    """A whole number of the smallest doubles."""

    units: int = 0

    @classmethod
    def of(cls, values: Iterable[float]) -> ExactSum:
        """The sum of finite numbers.

        Raises:
            ValueError: when a number is not finite.
        """
        total = 0
        for value in values:
            if not math.isfinite(value):
                raise ValueError(f"only finite numbers can be summed, given {value}")
            above, below = value.as_integer_ratio()
            total += above << (UNIT + 1 - below.bit_length())
        return cls(total)

    def __add__(self, other: ExactSum) -> ExactSum:
        return ExactSum(self.units + other.units)

    @property
    def fraction(self) -> Fraction:
        """Its value."""
        return Fraction(self.units, 1 << UNIT)

    def text(self) -> str:
        """For a file."""
        return hex(self.units)

    @classmethod
    def read(cls, text: str) -> ExactSum:
        """What `text` wrote."""
        return cls(int(text, 16))
