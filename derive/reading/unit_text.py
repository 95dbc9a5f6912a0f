"""Reads a unit as one types it: `m`, `km`, `m/s^2`, `m*rad/s`, `1/s`, `m^(1/2)`."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from fractions import Fraction
from types import MappingProxyType

from radartrack.derive import symbolic as sp
from radartrack.derive.symbolic import Expr
from radartrack.derive.units import METRE, ONE, RADIAN, SECOND, Unit

LONGEST = 60  # characters
LARGEST_POWER = 12  # in absolute value; the largest denominator of one, too


@dataclass(frozen=True)
class Scale:
    """A unit, and how many of the SI unit one of it is."""

    unit: Unit
    factor: Expr

    def __mul__(self, other: Scale) -> Scale:
        return Scale(self.unit * other.unit, self.factor * other.factor)

    def __pow__(self, power: Fraction) -> Scale:
        return Scale(self.unit**power, self.factor ** sp.Rational(power.numerator, power.denominator))


BASE: Mapping[str, Scale] = MappingProxyType(
    {
        "1": Scale(ONE, sp.Integer(1)),
        "%": Scale(ONE, sp.Rational(1, 100)),
        "dB": Scale(ONE, sp.Integer(1)),  # a number of them; what it is ten logarithms of is the formula's affair
        "m": Scale(METRE, sp.Integer(1)),
        "km": Scale(METRE, sp.Integer(1000)),
        "cm": Scale(METRE, sp.Rational(1, 100)),
        "mm": Scale(METRE, sp.Rational(1, 1000)),
        "ft": Scale(METRE, sp.Rational(3048, 10_000)),
        "mi": Scale(METRE, sp.Rational(1_609_344, 1000)),
        "nmi": Scale(METRE, sp.Integer(1852)),
        "NM": Scale(METRE, sp.Integer(1852)),
        "s": Scale(SECOND, sp.Integer(1)),
        "ms": Scale(SECOND, sp.Rational(1, 1000)),
        "us": Scale(SECOND, sp.Rational(1, 10**6)),
        "min": Scale(SECOND, sp.Integer(60)),
        "h": Scale(SECOND, sp.Integer(3600)),
        "kn": Scale(METRE / SECOND, sp.Rational(1852, 3600)),
        "kt": Scale(METRE / SECOND, sp.Rational(1852, 3600)),
        "Hz": Scale(SECOND**-1, sp.Integer(1)),
        "kHz": Scale(SECOND**-1, sp.Integer(1000)),
        "MHz": Scale(SECOND**-1, sp.Integer(10**6)),
        "rad": Scale(RADIAN, sp.Integer(1)),
        "mrad": Scale(RADIAN, sp.Rational(1, 1000)),
        "deg": Scale(RADIAN, sp.pi / 180),
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
    formula = found["number"] if scale.factor == 1 else f"{found['number']}*({scale.factor})"
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
