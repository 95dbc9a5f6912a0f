"""Units as exponents of metre, second and radian; the angle counts as a base dimension."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction


@dataclass(frozen=True, slots=True)
class Unit:
    """A product of powers of metre, second and radian."""

    metre: Fraction = Fraction(0)
    second: Fraction = Fraction(0)
    radian: Fraction = Fraction(0)

    def __mul__(self, other: Unit) -> Unit:
        return Unit(self.metre + other.metre, self.second + other.second, self.radian + other.radian)

    def __truediv__(self, other: Unit) -> Unit:
        return self * other**-1

    def __pow__(self, exponent: int | Fraction) -> Unit:
        return Unit(self.metre * exponent, self.second * exponent, self.radian * exponent)

    def __str__(self) -> str:
        powers = (("m", self.metre), ("rad", self.radian), ("s", self.second))
        above = [_power(name, exponent) for name, exponent in powers if exponent > 0]
        below = [_power(name, -exponent) for name, exponent in powers if exponent < 0]
        return "/".join(["·".join(above) or "1", *below])


def _power(name: str, exponent: Fraction) -> str:
    if exponent == 1:
        return name
    return f"{name}^{exponent}" if exponent.denominator == 1 else f"{name}^({exponent})"


ONE = Unit()
METRE = Unit(metre=Fraction(1))
SECOND = Unit(second=Fraction(1))
RADIAN = Unit(radian=Fraction(1))
METRE_PER_SECOND = METRE / SECOND
