"""Numbers that are printed for the constants of an ellipsoid: 6378137 is its semi-major axis, however it is called.

They are read as the symbols of the quantity, of which they are values; so they have units, and are compared at the
digits that are printed.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import cache, cached_property
from math import isqrt
from types import MappingProxyType

from radartrack.derive.formula.fold import rebuild
from radartrack.derive.formula.tree import Number, Tree, parts
from radartrack.derive.reading.text import read_text

FEWEST = 4  # significant digits: fewer are near to other numbers
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
