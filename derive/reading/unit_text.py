"""Reads a unit as one types it: `m`, `km`, `m/s^2`, `m*rad/s`, `1/s`, `m^(1/2)`."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from types import MappingProxyType

from radartrack.derive.formula.limits import MAX_DIGITS
from radartrack.derive.units import METRE, ONE, RADIAN, SECOND, Unit

LONGEST = 60  # characters
LARGEST_POWER = 12  # in absolute value; the largest denominator of one, too


@dataclass(frozen=True)
class Scale:
    """A unit, and how many of the SI unit one of it is: a fraction, perhaps times powers of pi and roots.

    No SymPy: what reads a claim is loaded with every command, and formulas are worked out in another process.
    """

    unit: Unit
    number: Fraction = Fraction(1)
    pi: Fraction = Fraction(0)
    roots: Mapping[Fraction, Fraction] = field(default_factory=dict)

    @property
    def formula(self) -> str:
        """The size as a formula."""
        bases = {"pi": self.pi, **{f"({base})": power for base, power in self.roots.items()}}
        powers = [name if power == 1 else f"{name}**({power})" for name, power in bases.items() if power]
        numerator, denominator = self.number.as_integer_ratio()
        above = "*".join([_digits(numerator)] * (numerator != 1 or not powers) + powers)
        return above if denominator == 1 else f"{above}/{_digits(denominator)}"

    @property
    def size(self) -> float:
        """The same in floating point."""
        roots = (float(base) ** float(power) for base, power in self.roots.items())
        return float(math.prod(roots, start=float(self.number) * math.pi ** float(self.pi)))

    def __mul__(self, other: Scale) -> Scale:
        number, roots = self.number * other.number, {}
        for base in {**self.roots, **other.roots}:
            power = self.roots.get(base, Fraction(0)) + other.roots.get(base, Fraction(0))
            number *= base ** math.floor(power)
            if power % 1:
                roots[base] = power % 1
        return Scale(self.unit * other.unit, number, self.pi + other.pi, roots)

    def __pow__(self, power: Fraction) -> Scale:
        whole = power.denominator == 1
        number = self.number ** int(power) if whole else Fraction(1)
        roots = {base: own * power for base, own in self.roots.items()}
        if not whole and self.number != 1:
            roots[self.number] = power
        return Scale(self.unit) * Scale(self.unit**power * self.unit**-1, number, self.pi * power, roots)


def _digits(whole: int) -> str:
    """A whole number in pieces that are not too long to be read."""
    upper, lower = divmod(whole, 10**MAX_DIGITS)
    return f"({_digits(upper)}*10**{MAX_DIGITS} + {lower})" if upper else str(lower)


BASE: Mapping[str, Scale] = MappingProxyType(
    {
        "1": Scale(ONE),
        "%": Scale(ONE, Fraction(1, 100)),
        "dB": Scale(ONE),  # a number of them; what it is ten logarithms of is the formula's affair
        "m": Scale(METRE),
        "km": Scale(METRE, Fraction(1000)),
        "cm": Scale(METRE, Fraction(1, 100)),
        "mm": Scale(METRE, Fraction(1, 1000)),
        "ft": Scale(METRE, Fraction(3048, 10_000)),
        "mi": Scale(METRE, Fraction(1_609_344, 1000)),
        "nmi": Scale(METRE, Fraction(1852)),
        "NM": Scale(METRE, Fraction(1852)),
        "s": Scale(SECOND),
        "ms": Scale(SECOND, Fraction(1, 1000)),
        "us": Scale(SECOND, Fraction(1, 10**6)),
        "min": Scale(SECOND, Fraction(60)),
        "h": Scale(SECOND, Fraction(3600)),
        "kn": Scale(METRE / SECOND, Fraction(1852, 3600)),
        "kt": Scale(METRE / SECOND, Fraction(1852, 3600)),
        "Hz": Scale(SECOND**-1),
        "kHz": Scale(SECOND**-1, Fraction(1000)),
        "MHz": Scale(SECOND**-1, Fraction(10**6)),
        "rad": Scale(RADIAN),
        "mrad": Scale(RADIAN, Fraction(1, 1000)),
        "deg": Scale(RADIAN, Fraction(1, 180), Fraction(1)),
    }
)
NUMBERS = {"1", "%", "dB"}
LETTERS = {"h", "min"}  # which alone are letters: 2 h is twice a height
_FACTOR = re.compile(
    r"\s*(?P<name>[A-Za-z]+|1|%)(?:\s*(?:\^|\*\*)\s*(?P<power>-?\d{1,2}|\(\s*-?\d{1,2}(?:\s*/\s*\d{1,2})?\s*\)))?\s*"
)
_MEASURED = re.compile(r"\s*(?P<number>[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)\s*(?P<unit>[A-Za-z°µμ1%].{0,59}?)\s*")
_SIGN = re.compile(r"[*·/]")


def read_unit(text: str) -> Scale:
    """A product of powers of units; a stroke divides by the one unit behind it.

    Raises:
        ValueError: naming what is no unit, and those that there are.
    """
    if len(text) > LONGEST:
        raise ValueError(f"a unit has at most {LONGEST} characters, given {text[:LONGEST]!r}...")
    total = BASE["1"]
    for sign, factor in _factors(text.replace("µ", "u").replace("μ", "u")):
        total = total * (factor ** Fraction(-1 if sign == "/" else 1))
    return total


@dataclass(frozen=True)
class Measured:
    """A number with a unit behind it: as a formula in SI units, and its unit."""

    formula: str
    unit: Unit


def measured(text: str) -> Measured | None:
    """A number with a unit, as one types it: `30deg`, `30°`, `10 km`; None for anything else."""
    found = _MEASURED.fullmatch(text)
    if found is None or found["unit"] in NUMBERS | LETTERS:
        return None
    try:
        scale = read_unit(found["unit"].replace("°", "deg"))
    except ValueError:
        return None
    formula = found["number"] if scale.formula == "1" else f"{found['number']}*({scale.formula})"
    return Measured(formula, scale.unit)


def _factors(text: str) -> Iterator[tuple[str, Scale]]:
    """What stands before each factor, and the factor."""
    sign, place = "*", 0
    while True:
        found = _FACTOR.match(text, place)
        if found is None or found["name"] not in BASE:
            raise ValueError(
                f"{text!r} is no unit; products and quotients of powers of {', '.join(BASE)} are, such as m/s^2"
            )
        yield sign, BASE[found["name"]] ** _power(found["power"] or "1")
        place = found.end()
        if place == len(text):
            return
        if not _SIGN.match(text, place):
            raise ValueError(f"{text!r} is no unit: * or / is missing before {text[place:]!r}")
        sign, place = text[place], place + 1


def _power(text: str) -> Fraction:
    above, _, below = text.strip("()").replace(" ", "").partition("/")
    power = Fraction(int(above), int(below or 1) or 1)
    if abs(power) > LARGEST_POWER or power.denominator > LARGEST_POWER or (below and not int(below)):
        raise ValueError(f"a power of a unit is at most {LARGEST_POWER}, given {text}")
    return power
