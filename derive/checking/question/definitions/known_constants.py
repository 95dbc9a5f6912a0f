"""Numbers that are printed for known constants: 6378137 is the semi-major axis of an ellipsoid, however it is called.

Those of an ellipsoid are read as the symbols of the quantity, of which they are values; so they have units, and are
compared at the digits that are printed. A number that is one of them but for a digit is told.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from dataclasses import dataclass
from decimal import Decimal
from fractions import Fraction
from functools import cache, cached_property
from math import isqrt
from types import MappingProxyType

from radartrack.derive.formula.fold import rebuild
from radartrack.derive.formula.tree import Number, Tree, parts
from radartrack.derive.reading.text import read_text

FEWEST = 4  # significant digits: fewer are near to other numbers
FEWEST_MISPRINTED = 5  # of a number that is a constant but for one of them
MOST_APART = 20  # a number with a digit too many is ten times as large
SCALE = 10**40
SQUARED = "flattening*(2 - flattening)"
SYMBOLS = ("semi_major_axis", "flattening")


@dataclass(frozen=True)
class Ellipsoid:
    """One that is in use, with the two numbers that define it."""

    name: str
    semi_major_axis: Fraction
    inverse_flattening: Fraction

    @cached_property
    def constants(self) -> Mapping[str, Fraction]:
        """The numbers that are printed of it, by what they are of the symbols."""
        a, f = self.semi_major_axis, 1 / self.inverse_flattening
        squared = f * (2 - f)
        return {
            "semi_major_axis": a,
            "semi_major_axis*(1 - flattening)": a * (1 - f),
            "flattening": f,
            "1/flattening": 1 / f,
            SQUARED: squared,
            f"sqrt({SQUARED})": _root(squared),
            f"1 - {SQUARED}": 1 - squared,
            f"{SQUARED}/(1 - flattening)**2": squared / (1 - f) ** 2,
        }


ELLIPSOIDS = tuple(
    Ellipsoid(name, Fraction(axis), Fraction(flattening))
    for name, axis, flattening in (
        ("WGS 84", "6378137", "298.257223563"),
        ("GRS 80", "6378137", "298.257222101"),
        ("PZ-90", "6378136", "298.25784"),
        ("WGS 72", "6378135", "298.26"),
        ("Krassovsky 1940", "6378245", "298.3"),
    )
)


@dataclass(frozen=True)
class Constant:
    """A number with a unit that formulas hold as a bare number."""

    name: str
    value: Fraction
    rounded: tuple[Fraction, ...]  # as it is printed in fewer digits than tell it

    def is_printed_as(self, number: Number) -> bool:
        """Whether a number is this one at the digits that are printed."""
        last = _last(number)
        is_rounded = _digits(number) >= FEWEST and -last / 2 <= self.value - number.value < last
        return is_rounded or number.value in self.rounded


CONSTANTS = (
    Constant("the speed of light", Fraction(299792458), (Fraction(3 * 10**8),)),
    Constant("standard gravity", Fraction("9.80665"), (Fraction("9.81"), Fraction("9.8"))),
)


def has_any_unit(number: Number) -> bool:
    """Whether a bare number stands for a constant with a unit, which the number does not show."""
    return any(constant.is_printed_as(number) for constant in CONSTANTS)


def nearly(number: Number, names: Collection[str]) -> Iterator[tuple[str, Tree]]:
    """The constants that a number is but for one digit: their digits with what they are, and what they are read as.

    Args:
        number: as printed.
        names: the symbols that a formula may have.
    """
    if _digits(number) < FEWEST_MISPRINTED:
        return
    for constant in CONSTANTS:
        if (right := _misprint_of(number, constant.value)) is not None:
            yield f"{right}, {constant.name}", Number(right)
    if not all(symbol in names for symbol in SYMBOLS):
        return
    for ellipsoid in ELLIPSOIDS:
        for text, value in ellipsoid.constants.items():
            if (right := _misprint_of(number, value)) is not None:
                yield f"{right}, {text} of {ellipsoid.name}", _tree(text)


def with_symbols(tree: Tree, names: Collection[str]) -> tuple[Tree, tuple[str, ...]]:
    """The formula with symbols for the constants in it, and what was read as what; as it is where none are known.

    Args:
        tree: the formula.
        names: the symbols that it may have.
    """
    numbers = {node for node in parts(tree) if isinstance(node, Number) and _digits(node) >= FEWEST}
    if not numbers or not all(symbol in names for symbol in SYMBOLS):
        return tree, ()
    found = max((_read(numbers, one) for one in ELLIPSOIDS), key=len)
    if not found:
        return tree, ()
    changed = rebuild(tree, lambda node: found[node][1] if isinstance(node, Number) and node in found else node)
    return changed, tuple(f"{node.text} is read as {text}" for node, (text, _) in found.items())


def _read(numbers: Collection[Number], ellipsoid: Ellipsoid) -> Mapping[Number, tuple[str, Tree]]:
    found = {}
    for number in sorted(numbers, key=lambda one: one.text):
        last = _last(number)
        for text, value in ellipsoid.constants.items():
            if -last / 2 <= value - number.value < last:  # rounded or cut off
                found[number] = (f"{text} of {ellipsoid.name}", _tree(text))
                break
    return MappingProxyType(found)


@cache
def _tree(text: str) -> Tree:
    return read_text(text, SYMBOLS)


def _misprint_of(number: Number, value: Fraction) -> str | None:
    """A value as it should have been printed, where one digit is wrong, missing, too many or two are exchanged."""
    if number.value <= 0 or not Fraction(1, MOST_APART) < number.value / value < MOST_APART:
        return None
    printed = _significant(number.text)
    for count in (len(printed), len(printed) + 1, len(printed) - 1):
        right = f"{Decimal(value.numerator) / Decimal(value.denominator):.{count - 1}e}"
        digits = _significant(right)
        if printed == digits:
            return None
        if _is_one_slip(printed, digits):
            return f"{Decimal(right):f}"
    return None


def _significant(text: str) -> str:
    return text.lower().partition("e")[0].replace(".", "").lstrip("0")


def _is_one_slip(printed: str, right: str) -> bool:
    """Whether one digit is another, two neighbours are exchanged, or one digit is missing or too many."""
    shorter, longer = sorted((printed, right), key=len)
    if len(longer) == len(shorter) + 1:
        return any(longer[:at] + longer[at + 1 :] == shorter for at in range(len(longer)))
    wrong = [at for at, (one, other) in enumerate(zip(printed, right, strict=True)) if one != other]
    return len(wrong) == 1 or (
        wrong == [*range(wrong[0], wrong[0] + 2)]
        and printed[wrong[0]] + printed[wrong[1]] == right[wrong[1]] + right[wrong[0]]
    )


def _digits(number: Number) -> int:
    mantissa = number.text.lower().partition("e")[0].replace(".", "")
    return len(mantissa.lstrip("0"))


def _last(number: Number) -> Fraction:
    """A unit of the last digit."""
    mantissa, _, exponent = number.text.lower().partition("e")
    return Fraction(10) ** (int(exponent or 0) - len(mantissa.partition(".")[2]))


def _root(value: Fraction) -> Fraction:
    """To more digits than anybody prints."""
    return Fraction(isqrt(int(value * SCALE**2)), SCALE)
