"""Symbols that carry a meaning, a unit and the domain over which formulas are held to their accuracy."""

from __future__ import annotations

import math
from typing import Any, Self

from radartrack.derive.language.identifiers import require_text
from radartrack.derive.symbolic import Symbol
from radartrack.derive.units import METRE, METRE_PER_SECOND, ONE, RADIAN, Unit

PREDICTED, DEVIATION = "predicted_", "sigma_"  # how names of deviations begin, but for those of one's own
KIND = ("whole", "least", "at_most", "is_correlation", "deviation_of")


class Variable(Symbol):
    """A real symbol with its meaning, unit and domain.

    Attributes:
        meaning: what the symbol stands for, in the field's words.
        unit: its unit.
        low: lower end of the domain, in that unit.
        high: upper end of the domain, in that unit.
        whole: whether it is a whole number; the algebra takes it as real.
        least: of a whole number, the least that it can be at all; the domain may begin above it.
        at_most: a symbol that it never exceeds.
        is_correlation: whether it is the correlation of two errors.
        deviation_of: of a standard deviation, the name of that whose error it is of; empty of anything else.
    """

    meaning: str
    unit: Unit
    low: float
    high: float
    whole: bool
    least: int
    at_most: Variable | None
    is_correlation: bool
    deviation_of: str
    _kind: str  # the unit as text, which SymPy asks for whenever it compares

    def __new__(
        cls,
        name: str,
        meaning: str,
        unit: Unit,
        low: float,
        high: float,
        *,
        whole: bool = False,
        least: int = 1,
        at_most: Variable | None = None,
        is_correlation: bool = False,
        deviation_of: str = "",
    ) -> Self:
        """Declare a symbol; one whose domain is above zero is positive in the algebra too.

        Raises:
            TypeError: the ends of the domain are no numbers.
            ValueError: they are not finite or not in order, or the meaning is not one line of text.
        """
        require_text(f"the meaning of {name}", meaning)
        if not (math.isfinite(low) and math.isfinite(high) and low <= high):
            raise ValueError(
                f"the domain of {name} must go from one finite number up to another; given {low} to {high}"
            )
        sign = "positive" if low > 0 else "nonnegative" if low == 0 else "real"
        variable: Self = Symbol.__xnew__(cls, name, **{sign: True})
        variable.meaning, variable.unit, variable._kind = meaning, unit, str(unit)
        variable.low, variable.high = map(_plain_number, (low, high))
        variable.whole, variable.least, variable.at_most, variable.is_correlation = (
            whole,
            least,
            at_most,
            is_correlation,
        )
        of, named, by_name = name.removeprefix(PREDICTED).partition(DEVIATION)
        variable.deviation_of = deviation_of or (by_name if named and not of else "")
        return variable

    def below(self, high: float) -> Self:
        """The same symbol with a domain that ends there at the latest, which is what bounds it then."""
        kind: dict[str, Any] = {name: getattr(self, name) for name in KIND if name != "at_most"}
        return type(self)(self.name, self.meaning, self.unit, self.low, min(self.high, high), **kind)

    def on(self, low: float, high: float) -> Variable:
        """The same symbol, to the algebra too, with another domain."""
        sign = "positive" if self.is_positive else "nonnegative" if self.is_nonnegative else "real"
        other: Variable = Symbol.__xnew__(type(self), self.name, **{sign: True})
        other.__dict__.update(self.__dict__)
        other.low, other.high = low, high
        return other

    def as_deviation_of(self, of: Variable) -> Variable:
        """The same symbol as the standard deviation of an error, whatever its name is."""
        other = self.on(self.low, self.high)
        other.deviation_of = of.name
        return other

    def _hashable_content(self) -> tuple[Any, ...]:
        """Symbols of one name and different units are different, to SymPy's cache of results too."""
        return (*super()._hashable_content(), self._kind)

    @property
    def logarithmic(self) -> bool:
        """Whether points of the domain are spread evenly over its scales (lengths) or over its values (angles)."""
        return self.low > 0

    @property
    def is_angle(self) -> bool:
        """Whether it is a direction; the deviation of one is no angle, though its unit is the same."""
        return self.unit == RADIAN and not self.logarithmic

    @property
    def symbol(self) -> Symbol:
        """A plain symbol of this name; SymPy's code printers, which have a Variable of their own, ask for it."""
        return Symbol(self.name)

    def __getnewargs_ex__(self) -> tuple[tuple[Any, ...], dict[str, Any]]:
        kind = {name: getattr(self, name) for name in KIND}
        return (self.name, self.meaning, self.unit, self.low, self.high), kind


def _plain_number(value: Any) -> float:
    """An end of a domain as it was given, unless it was a number of SymPy's or NumPy's."""
    return value if type(value) in {int, float} else float(value)


def length(name: str, meaning: str, low: float = 1.0, high: float = 1e8) -> Variable:
    """A length in metres."""
    return Variable(name, meaning, METRE, low, high)


def speed(name: str, meaning: str, low: float = -1e4, high: float = 1e4) -> Variable:
    """A signed speed in metres per second."""
    return Variable(name, meaning, METRE_PER_SECOND, low, high)


def angle(name: str, meaning: str, low: float = -3.141592653589793, high: float = 3.141592653589793) -> Variable:
    """An angle in radians."""
    return Variable(name, meaning, RADIAN, low, high)


def deviation(of: Variable, low: float, high: float) -> Variable:
    """The standard deviation of the measurement error of a variable, in its unit."""
    return Variable(f"sigma_{of.name}", f"standard deviation of the error of {of.name}", of.unit, low, high)


def correlation(name: str, first: Variable, second: Variable) -> Variable:
    """The correlation of two measurement errors, from -1 to 1."""
    meaning = f"correlation of the errors of {first.name} and {second.name}"
    return Variable(name, meaning, ONE, -1.0, 1.0, is_correlation=True)
