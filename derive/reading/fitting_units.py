"""Units of letters of which nobody has said any: those in which formulas add up.

Every sum says that its terms are of one unit, every sine that it takes a number. With the powers of metre and second
of each letter as unknowns these are linear equations; a letter that they leave open is a number.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from fractions import Fraction

from radartrack.derive.formula.fold import Fold
from radartrack.derive.formula.tree import (
    Call,
    Name,
    Negation,
    Power,
    Product,
    Quotient,
    Sum,
    Tree,
    parts,
    rational_value,
)
from radartrack.derive.units import ONE, RADIAN, Unit

_PERIODIC = {"cos", "cot", "csc", "sec", "sin", "tan"}
_ALIKE = {"atan2", "hypot"}


@dataclass(frozen=True)
class _Powers:
    """A unit that is known, times powers of the units of letters; `free` marks a number, which may have any unit."""

    unit: Unit = ONE
    letters: Mapping[str, Fraction] = field(default_factory=dict)
    free: bool = False

    def times(self, other: _Powers, power: Fraction = Fraction(1)) -> _Powers:
        names = {**self.letters, **other.letters}
        letters = {name: self.letters.get(name, 0) + power * other.letters.get(name, 0) for name in names}
        return _Powers(self.unit * other.unit**power, letters, self.free and other.free)

    def raised(self, power: Fraction) -> _Powers:
        return replace(_NUMBER.times(self, power), free=self.free)


_NUMBER = _Powers()
_FREE = _Powers(free=True)


def fitting_units(
    known: Mapping[str, Unit], letters: Collection[str], formulas: Iterable[tuple[Sequence[Tree], Unit | None]]
) -> dict[str, Unit]:
    """The unit of each letter with which formulas are sums of one unit.

    Args:
        known: the units of the other names.
        letters: those of which nothing is known.
        formulas: those that have one unit, and which; None where nobody has said it.

    Returns:
        For what does not fit in any units, those of the equations that stand first.
    """
    equations = _Equations(known, letters)
    collect = Fold(equations.step)
    angles: set[str] = set()
    for trees, unit in formulas:
        equations.alike([*([] if unit is None else [_Powers(unit)]), *map(collect, trees)])
        angles.update(*map(turned_names, trees))
    units = _solved(sorted(letters), equations)
    return {name: RADIAN if unit == ONE and name in angles else unit for name, unit in units.items()}


class _Equations(list[_Powers]):
    """What formulas demand: each is the unit of a number."""

    def __init__(self, known: Mapping[str, Unit], letters: Collection[str]) -> None:
        super().__init__()
        self._known, self._letters = known, letters

    def alike(self, found: Sequence[_Powers]) -> _Powers:
        """The one unit of several; numbers may have any."""
        fixed = [one for one in found if not one.free]
        self.extend(one.times(fixed[0], Fraction(-1)) for one in fixed[1:])
        return fixed[0] if fixed else _FREE

    def step(self, node: Tree, below: Sequence[_Powers]) -> _Powers:
        """The unit of a formula from those of its parts."""
        match node:
            case Name(name):
                return _Powers(letters={name: Fraction(1)}) if name in self._letters else self._of_name(name)
            case Sum():
                return self.alike(below)
            case Product() | Quotient():
                first, *others = below
                return _product(first, others, Fraction(-1 if isinstance(node, Quotient) else 1))
            case Power(_, exponent) if (power := rational_value(exponent)) is not None:
                return below[0].raised(power)
            case Negation():
                return below[0]
            case Power() | Call():
                return self._of_function(node, below)
            case _:
                return _FREE

    def _of_name(self, name: str) -> _Powers:
        return _Powers(self._known.get(name, ONE))

    def _of_function(self, node: Power | Call, below: Sequence[_Powers]) -> _Powers:
        function = node.function if isinstance(node, Call) else ""
        if function in {"abs", "sqrt"}:
            return below[0].raised(Fraction(1, 2)) if function == "sqrt" else below[0]
        if function in _ALIKE:
            both = self.alike(below)
            return both if function == "hypot" else _NUMBER
        self.extend(one for one in below if not one.free)
        return _NUMBER


def _product(first: _Powers, others: Iterable[_Powers], power: Fraction) -> _Powers:
    for other in others:
        first = first.times(other, power)
    return first


def _solved(letters: Sequence[str], equations: Iterable[_Powers]) -> dict[str, Unit]:
    """By elimination; an equation that contradicts those before it is left out."""
    rows: dict[str, tuple[dict[str, Fraction], Unit]] = {}  # a letter is minus the others times the unit's inverse
    for equation in equations:
        left, unit = {name: power for name, power in equation.letters.items() if power}, equation.unit
        for name in [name for name in left if name in rows]:
            power = left.pop(name)
            others, other_unit = rows[name]
            unit = unit * other_unit**power
            for other, share in others.items():
                left[other] = left.get(other, Fraction(0)) + power * share
        left = {name: power for name, power in left.items() if power}
        if left:
            _resolve(rows, left, unit)
    return {name: rows[name][1] if name in rows else ONE for name in letters}


def _resolve(rows: dict[str, tuple[dict[str, Fraction], Unit]], left: dict[str, Fraction], unit: Unit) -> None:
    """Solve an equation for its first letter, and put that into the others."""
    name = min(left)
    power = left.pop(name)
    shares = {other: -share / power for other, share in left.items()}
    solved = shares, unit ** (-1 / power)
    for one, (others, own) in list(rows.items()):
        if share := others.pop(name, None):
            merged = {
                other: others.get(other, Fraction(0)) + share * shares.get(other, 0) for other in {*others, *shares}
            }
            rows[one] = {other: value for other, value in merged.items() if value}, own * solved[1] ** share
    rows[name] = solved


def turned_names(tree: Tree) -> set[str]:
    """The names that are an angle by themselves: terms of what a sine is taken of, perhaps some times."""
    found = set()
    for node in parts(tree):
        if isinstance(node, Call) and node.function in _PERIODIC:
            argument = node.arguments[0]
            found |= {name for term in _terms(argument) if (name := _multiplied(term))}
    return found


def _terms(tree: Tree) -> Iterable[Tree]:
    return tree.terms if isinstance(tree, Sum) else (tree,)


def _multiplied(term: Tree) -> str:
    """The name of which a term is a multiple; nothing where it is none."""
    if isinstance(term, Negation):
        return _multiplied(term.operand)
    if isinstance(term, Quotient):
        return _multiplied(term.numerator) if rational_value(term.denominator) is not None else ""
    factors = term.factors if isinstance(term, Product) else (term,)
    rest = [factor for factor in factors if rational_value(factor) is None]
    return rest[0].name if len(rest) == 1 and isinstance(rest[0], Name) else ""
