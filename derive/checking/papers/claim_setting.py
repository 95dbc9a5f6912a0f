"""The quantity of a claim where the claim sets it: its values, its largest one, and the levels beside them."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cmp_to_key
from itertools import pairwise
from typing import TypeAlias

from radartrack.derive import symbolic as sp
from radartrack.derive.checking.comparing.rounding_to_print import in_unit
from radartrack.derive.checking.papers.claim import Along, Claim
from radartrack.derive.checking.question.compared_quantity import Reference, refer
from radartrack.derive.checking.question.formula_units import Dimension, WrongDimensions, dimensions
from radartrack.derive.checking.question.names import Names
from radartrack.derive.checking.question.possible_values import check_domain
from radartrack.derive.checking.question.single_number import scalar_expression
from radartrack.derive.checking.question.world import CATALOGUE, World
from radartrack.derive.evaluation.exact_numbers import Exact, Function, NoRealValue, compared, order
from radartrack.derive.evaluation.many_digits import Number
from radartrack.derive.formula.error import FormulaError
from radartrack.derive.language.variable import Variable
from radartrack.derive.reading.text import read_text
from radartrack.derive.reading.unit_text import Scale, read_unit
from radartrack.derive.symbolic import Expr, Symbol

Values: TypeAlias = Mapping[Variable, Expr]


@dataclass(frozen=True)
class Place:
    """One point along a symbol.

    Attributes:
        values: of the symbols that vary.
        where: the same in words, `k = 3`; empty where nothing varies.
        position: the value of the symbol along which the point lies.
    """

    values: Values
    where: str
    position: Expr


HERE = Place({}, "", sp.Integer(0))


class Setting:
    """The quantity as a number, with the symbols that the claim sets.

    Raises:
        UnknownQuantity, UnknownEntry, FormulaError: when the claim names what there is not, cannot be read, or sets a
            symbol to what it cannot be.
    """

    def __init__(self, claim: Claim, world: World = CATALOGUE) -> None:
        self._claim = claim
        self._names = Names({}, world.let, world)
        self._reference: Reference = refer(claim.quantity, world, world.let)
        if self._reference.shape:
            raise FormulaError(f"{claim.quantity} has the shape {list(self._reference.shape)}: name one entry")
        self._symbols = {symbol.name: symbol for symbol in self._reference.symbols}
        self._expression = self._reference.entries.entries[0]
        self._check_names()
        self._fixed: Values = {self._symbols[name]: self._closed(text, f"at.{name}") for name, text in claim.at.items()}
        check_domain(self._fixed, "at")
        self._dimension: Dimension = self._reference.dimensions.entries[0]
        self._function = Function(self._expression, tuple(self._symbols.values()))
        self.unit = size_of(_scale(claim.unit or "1"))
        self._candidates: list[Place] | None = None  # for the maximum

    def _check_names(self) -> None:
        varied = [one[0] for one in (self._claim.along, self._claim.maximum_over) if one]
        for name in (*self._claim.at, *varied):
            if name not in self._symbols:
                raise FormulaError(f"{name} is no symbol of {self._claim.quantity}; it has {', '.join(self._symbols)}")
        needed = {symbol.name for symbol in self._expression.free_symbols} - {*self._claim.at, *varied}
        if needed:
            missing = (name for name in self._symbols if name in needed)
            raise FormulaError(f"at: the value of {', '.join(missing)} is missing")

    def check_unit(self) -> None:
        """Compare the claim's unit with the quantity's.

        Raises:
            WrongDimensions: where they do not fit.
        """
        unit = self._claim.unit
        if not unit or self._dimension.free:
            return
        given = Dimension.of(_scale(unit).unit)
        fits = self._dimension.agrees(given)
        if fits and given.is_number and unit != "1" and self._dimension.radian is not None:
            fits = (given.radian == 1) == (self._dimension.radian == 1)  # one in rad may stand without a unit
        if not fits:
            raise WrongDimensions(f"the unit is {unit}, the quantity has {self._dimension}")

    @property
    def point(self) -> dict[str, float]:
        """The values that the claim sets."""
        return {symbol.name: float(value) for symbol, value in self._fixed.items()}

    @property
    def units(self) -> dict[str, str]:
        """The units of these."""
        return {symbol.name: str(symbol.unit) for symbol in self._fixed}

    def places(self, along: Along | None) -> list[Place]:
        """The points along a symbol in the order in which it grows; one point where there is none.

        Raises:
            FormulaError: for a value that cannot be, and one that occurs twice.
        """
        if along is None:
            return [HERE]
        name, texts = along
        symbol = self._symbols[name]
        found = []
        for text in texts:
            value = self._closed(text, name)
            check_domain({**self._fixed, symbol: value}, f"the values of {name}")
            found.append(Place({symbol: value}, f"{name} = {text}", value))
        found.sort(key=cmp_to_key(lambda one, other: order(one.position, other.position)))
        for one, other in pairwise(found):
            if order(one.position, other.position) == 0:
                raise FormulaError(f"{one.where} and {other.where} are the same; each value is given once")
        return found

    def value(self, place: Place) -> Exact:
        """The quantity, or its maximum, in SI."""
        over = self._claim.maximum_over
        return self._at(self._function, place.values) if over is None else self.maximum(place, over)[1]

    def maximum(self, place: Place, over: Along) -> tuple[list[Place], Exact]:
        """All the points at which the quantity is largest, and how large."""
        found = [(one, self._at(self._function, {**place.values, **one.values})) for one in self._varied(place, over)]
        largest: list[tuple[Place, Exact]] = found[:1]
        for one in found[1:]:
            difference = compared(one[1], largest[0][1])
            largest = [one] if difference > 0 else [*largest, one] if difference == 0 else largest
        return [one for one, _ in largest], largest[0][1]

    def _varied(self, place: Place, over: Along) -> list[Place]:
        """The points along another symbol, at one of the first."""
        if self._candidates is None:
            self._candidates = self.places(over)
        for one in self._candidates if place.values else ():
            check_domain({**self._fixed, **place.values, **one.values}, "along and maximum_over")
        return self._candidates

    def attained(self, over: Along, text: str) -> Expr:
        """Where the maximum is said to be."""
        symbol = self._symbols[over[0]]
        value = self._closed(text, "attained_at")
        check_domain({**self._fixed, symbol: value}, "attained_at")
        return value

    def _closed(self, text: str, where: str) -> Expr:
        """A formula without symbols, which may use the definitions of the paper."""
        try:
            return self._names.read(self._names.tree(text))
        except FormulaError as error:
            raise FormulaError(f"{where}: {error.message}", error.source or text, error.span) from None

    def level(self, text: str) -> Callable[[Place], Exact]:
        """A number in the claim's unit, or a formula in the quantity's symbols, in SI at each point.

        Raises:
            WrongDimensions: where it has another dimension than the quantity.
        """
        tree = read_text(text, self._symbols)
        expression = scalar_expression(tree, self._symbols)
        found = dimensions({name: Dimension.of(symbol.unit) for name, symbol in self._symbols.items()})(tree)
        if found.free:
            expression = expression * self.unit
        elif not self._dimension.free and not found.agrees(self._dimension):
            raise WrongDimensions(f"{text} has {found}, the quantity has {self._dimension}")
        elif self.unit != 1 and found.is_number and not found.radian:
            raise FormulaError(
                f"{text} is a formula, which is in SI units, and unit is {self._claim.unit}: leave one of them out"
            )
        function = Function(expression, tuple(self._symbols.values()))
        self._check_known(expression, text)
        if not expression.free_symbols:
            fixed = self._at(function, {})
            return lambda _: fixed
        return lambda place: self._at(function, place.values)

    def shown(self, *numbers: Exact) -> list[Number]:
        """Numbers in the claim's unit."""
        return [in_unit(number, self.unit) for number in numbers]

    def _check_known(self, expression: Expr, text: str) -> None:
        known = {*self._claim.at, *(self._claim.along[:1] if self._claim.along else ())}
        missing = sorted(symbol.name for symbol in expression.free_symbols if symbol.name not in known)
        if missing:
            raise FormulaError(f"at: the value of {', '.join(missing)} is missing, which {text} needs")

    def _at(self, function: Function, varied: Values) -> Exact:
        point: dict[Symbol, Expr] = {symbol: value for part in (self._fixed, varied) for symbol, value in part.items()}
        number = function.at(point)
        try:
            number.value()
        except NoRealValue:
            values = ", ".join(f"{symbol} = {value}" for symbol, value in varied.items())
            there = f"at {values}" if values else "there"
            raise FormulaError(f"{self._claim.quantity} has no real value {there}") from None
        return number


def size_of(scale: Scale) -> Expr:
    """How many of the SI unit one of a unit is."""
    return scalar_expression(read_text(scale.formula, ()), {})


def _scale(unit: str) -> Scale:
    try:
        return read_unit(unit)
    except ValueError as error:
        raise FormulaError(f"unit: {error}") from None
