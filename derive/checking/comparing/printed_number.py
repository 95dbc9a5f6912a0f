"""A number as a paper prints it: its digits are its precision."""

from __future__ import annotations

from dataclasses import dataclass
from decimal import Decimal
from fractions import Fraction


@dataclass(frozen=True)
class PrintedNumber:
    """A number with the digits that count.

    Attributes:
        text: as printed.
        significant: how many of its digits count; None for all.
    """

    text: str
    significant: int | None = None

    @property
    def value(self) -> Fraction:
        """The number itself."""
        return Fraction(self.text)

    @property
    def last(self) -> Fraction:
        """A unit of the last digit that counts."""
        return Fraction(10) ** self.exponent

    @property
    def counts_whole(self) -> bool:
        """Whether the digits that do not count are zeros."""
        return (self.value / self.last).denominator == 1

    @property
    def exponent(self) -> int:
        """The power of ten of the last digit that counts."""
        number = Decimal(self.text)
        exponent = int(number.as_tuple().exponent)
        return exponent if self.significant is None else max(exponent, number.adjusted() - self.significant + 1)
