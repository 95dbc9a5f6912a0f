"""Decides claims about numbers: a value at its printed precision, a maximum, a trend, a crossing, a bound."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from decimal import Decimal
from fractions import Fraction
from itertools import pairwise

import mpmath

from radartrack.derive import symbolic as sp
from radartrack.derive.checking.papers.claims_file import Along, Claim
from radartrack.derive.checking.question.compared_quantity import Reference, refer
from radartrack.derive.checking.question.formula_units import Dimension
from radartrack.derive.checking.question.single_number import scalar_expression
from radartrack.derive.checking.reporting.verdict import Counterexample, Outcome, Verdict
from radartrack.derive.evaluation.many_digits import DIGITS, GUARD, Evaluator, Number
from radartrack.derive.formula.error import FormulaError
from radartrack.derive.language.tensor import Tensor
from radartrack.derive.reading.text import read_text
from radartrack.derive.symbolic import Expr
from radartrack.derive.units import METRE, METRE_PER_SECOND, ONE, RADIAN, SECOND, Unit

UNITS: Mapping[str, tuple[Unit, Expr]] = {
    "1": (ONE, sp.Integer(1)),
    "%": (ONE, sp.Rational(1, 100)),
    "m": (METRE, sp.Integer(1)),
    "km": (METRE, sp.Integer(1000)),
    "m^2": (METRE**2, sp.Integer(1)),
    "s": (SECOND, sp.Integer(1)),
    "m/s": (METRE_PER_SECOND, sp.Integer(1)),
    "m/s^2": (METRE_PER_SECOND / SECOND, sp.Integer(1)),
    "rad": (RADIAN, sp.Integer(1)),
    "deg": (RADIAN, sp.pi / 180),
    "mrad": (RADIAN, sp.Rational(1, 1000)),
}
SHOWN_DIGITS = 6


@dataclass(frozen=True)
class Answer:
    """Whether the claim holds, what was derived, and why."""

    derived: str
    reason: str
    printed_value: float | None = None
    derived_value: float | None = None
    holds: bool = field(kw_only=True)


def check_number(claim: Claim) -> Verdict:
    """Decide a claim about a number.

    Raises:
        UnknownQuantity, UnknownEntry, FormulaError: when the claim names what there is not, or cannot be read.
    """
    quantity = _Quantity(claim)
    if not quantity.fits_unit:
        return _verdict(
            claim,
            Outcome.WRONG_DIMENSIONS,
            Answer("", f"the unit is {claim.unit}, the quantity has {quantity.dimension}", holds=False),
            quantity,
        )
    answer = _answer(claim, quantity)
    return _verdict(claim, Outcome.EQUAL if answer.holds else Outcome.DIFFERS, answer, quantity)


class _Quantity:
    """The quantity as a number, with the symbols that the claim sets."""

    def __init__(self, claim: Claim) -> None:
        self._claim = claim
        self.reference: Reference = refer(claim.quantity)
        if self.reference.shape:
            raise FormulaError(f"{claim.quantity} has the shape {list(self.reference.shape)}: name one entry")
        self._symbols = list(self.reference.symbols)
        used = self.reference.entries.entries[0].free_symbols
        free = {name for one in (claim.along, claim.maximum_over) if one for name in one[:1]}
        self._check_names(free, {symbol.name for symbol in used})
        unit, self._scale = UNITS[claim.unit or "1"]
        self.dimension: Dimension = self.reference.dimensions.entries[0]
        self.fits_unit = not claim.unit or self.dimension.free or self.dimension.agrees(Dimension.of(unit))
        self._fixed = {name: self.number(text) for name, text in claim.at.items()}
        self._evaluator = Evaluator(self.reference.entries, self._symbols)

    def _check_names(self, free: set[str], used: set[str]) -> None:
        names = [symbol.name for symbol in self._symbols]
        needed = [name for name in names if name in used - free - self._claim.at.keys()]
        if needed:
            raise FormulaError(f"at: the value of {', '.join(needed)} is missing")
        for name in (*self._claim.at, *sorted(free)):
            if name not in names:
                raise FormulaError(f"{name} is no symbol of {self._claim.quantity}; it has {', '.join(names)}")

    @property
    def point(self) -> dict[str, float]:
        """The values that the claim sets."""
        return {name: float(value) for name, value in self._fixed.items()}

    @property
    def units(self) -> dict[str, str]:
        """The units of these."""
        return {symbol.name: str(symbol.unit) for symbol in self._symbols if symbol.name in self._fixed}

    @property
    def scale(self) -> Number:
        """The claim's unit in SI."""
        return _evaluated(self._scale)

    def number(self, text: str) -> Number:
        """A formula without symbols."""
        return _evaluated(scalar_expression(read_text(text, set()), {}))

    def level(self, text: str, more: Mapping[str, Number]) -> Number:
        """A formula in the quantity's symbols, in SI."""
        known: dict[str, Expr] = {symbol.name: symbol for symbol in self._symbols}
        expression = scalar_expression(read_text(text, known), known)
        missing = {symbol.name for symbol in expression.free_symbols} - self._fixed.keys() - more.keys()
        if missing:
            raise FormulaError(f"at: the value of {', '.join(sorted(missing))} is missing, which {text} needs")
        evaluator = Evaluator(Tensor((), (expression,)), self._symbols)
        return self._at(evaluator, more)

    def value(self, more: Mapping[str, Number]) -> Number:
        """The quantity, or its maximum, in SI."""
        if self._claim.maximum_over is None:
            return self._at(self._evaluator, more)
        return self.maximum(more, self._claim.maximum_over)[1]

    def maximum(self, more: Mapping[str, Number], over: Along) -> tuple[str, Number]:
        """Where the quantity is largest, and how large."""
        symbol, values = over
        found = [(text, self._at(self._evaluator, {**more, symbol: self.number(text)})) for text in values]
        return max(found, key=lambda pair: pair[1])

    def along(self) -> Iterator[tuple[str, Mapping[str, Number]]]:
        """The points along the claim's symbol; one without a name when there is none."""
        if self._claim.along is None:
            yield "", {}
            return
        symbol, values = self._claim.along
        for text in values:
            yield f"{symbol} = {text}", {symbol: self.number(text)}

    def _at(self, evaluator: Evaluator, more: Mapping[str, Number]) -> Number:
        point = {**self._fixed, **more}
        value = evaluator([point.get(symbol.name, 0) for symbol in self._symbols]).entries[0]
        if isinstance(value, mpmath.mpc) or not mpmath.isfinite(value):
            raise FormulaError(f"{self._claim.quantity} has no real value there")
        return value


def _answer(claim: Claim, quantity: _Quantity) -> Answer:
    if claim.maximum_over and claim.along is None:
        return _maximum(claim, quantity, claim.maximum_over)
    if claim.value:
        return _value(claim, quantity.value({}), quantity.scale)
    if claim.trend:
        return _trend(claim, quantity)
    if claim.crosses:
        return _crossing(claim, quantity)
    return _bound(claim, quantity)


def _maximum(claim: Claim, quantity: _Quantity, over: Along) -> Answer:
    where, largest = quantity.maximum({}, over)
    found = f"{_shown(largest / quantity.scale)} {_unit(claim)}at {over[0]} = {where}"
    is_there = not claim.attained_at or quantity.number(claim.attained_at) == quantity.number(where)
    value = _value(claim, largest, quantity.scale) if claim.value else None
    holds = is_there and (value is None or value.holds)
    said = "the maximum is" if holds else "the maximum is instead"
    printed = value.printed_value if value else None
    return Answer(found, f"{said} {found}", printed, float(largest / quantity.scale), holds=holds)


def _value(claim: Claim, value: Number, scale: Number) -> Answer:
    printed, half = Fraction(claim.value), _half_of_last_digit(claim)
    derived = value / scale
    with mpmath.workdps(DIGITS + GUARD):
        error = abs(derived - mpmath.mpf(printed.numerator) / printed.denominator)
        holds = bool(error <= mpmath.mpf(half.numerator) / half.denominator)
    shown = f"{_shown(derived)} {_unit(claim)}".strip()
    reason = f"{shown} rounds to {claim.value}" if holds else f"derived is {shown}, printed {claim.value}"
    return Answer(shown, reason, float(printed), float(derived), holds=holds)


def _half_of_last_digit(claim: Claim) -> Fraction:
    """Half a unit of the last digit that counts."""
    number = Decimal(claim.value)
    exponent = int(number.as_tuple().exponent)
    if claim.significant is not None:
        exponent = max(exponent, number.adjusted() - claim.significant + 1)
    return Fraction(10) ** exponent / 2


def _trend(claim: Claim, quantity: _Quantity) -> Answer:
    found = [(where, quantity.value(more), more) for where, more in quantity.along()]
    steps = _steps(found)
    if claim.trend in {"convex", "concave"}:
        steps = [(where, after - before) for (_, before), (where, after) in pairwise(steps)]
    wanted = 1 if claim.trend in {"increasing", "convex"} else -1
    against = [where for where, step in steps if step * wanted <= 0]
    shown = ", ".join(f"{_shown(value / quantity.scale)}" for _, value, _ in _few(found))
    ends = f"from {found[0][0]} to {found[-1][0]}"
    if not against:
        return Answer(shown, f"{claim.trend} {ends}", holds=True)
    return Answer(shown, f"not {claim.trend} at {against[0]}: the values {ends} are {shown}", holds=False)


def _steps(found: Sequence[tuple[str, Number, Mapping[str, Number]]]) -> list[tuple[str, Number]]:
    """The slopes between neighbours, by the symbol along which they lie."""
    slopes = []
    for (_, before, first), (where, after, second) in pairwise(found):
        distance = next(iter(second.values())) - next(iter(first.values()))
        slopes.append((where, (after - before) / distance))
    return slopes


def _crossing(claim: Claim, quantity: _Quantity) -> Answer:
    points = list(quantity.along())
    gaps = [quantity.value(more) - quantity.level(claim.crosses, more) for _, more in points]
    values = [f"{_shown(quantity.value(more) / quantity.scale)} at {where}" for where, more in points]
    level = _shown(quantity.level(claim.crosses, points[0][1]) / quantity.scale)
    shown = " and ".join(values)
    holds = bool(gaps[0] * gaps[1] <= 0)
    between = f"the level {level} is {'' if holds else 'not '}crossed between them"
    return Answer(shown, f"{shown}: {between}", holds=holds)


def _bound(claim: Claim, quantity: _Quantity) -> Answer:
    above = bool(claim.at_most)
    text = claim.at_most or claim.at_least
    found = [(where, quantity.value(more), quantity.level(text, more)) for where, more in quantity.along()]
    broken = [(where, value, level) for where, value, level in found if (value > level if above else value < level)]
    extreme = (max if above else min)(found, key=lambda one: one[1])
    shown = f"{_shown(extreme[1] / quantity.scale)}{f' at {extreme[0]}' if extreme[0] else ''}"
    if not broken:
        return Answer(shown, f"the {'largest' if above else 'smallest'} value is {shown}", holds=True)
    where, value, level = broken[0]
    place = f" at {where}" if where else ""
    reason = (
        f"{_shown(value / quantity.scale)}{place} is {'above' if above else 'below'} {_shown(level / quantity.scale)}"
    )
    return Answer(shown, reason, holds=False)


def _verdict(claim: Claim, outcome: Outcome, answer: Answer, quantity: _Quantity) -> Verdict:
    counterexample = None
    if outcome is Outcome.DIFFERS and answer.printed_value is not None and answer.derived_value is not None:
        relative = abs(answer.printed_value - answer.derived_value) / abs(
            answer.derived_value or answer.printed_value or 1
        )
        counterexample = Counterexample(
            quantity.point, (), answer.printed_value, answer.derived_value, relative, quantity.units
        )
    return Verdict(
        verdict=outcome,
        quantity=claim.quantity,
        printed=claim.printed,
        derived=answer.derived,
        reason=answer.reason,
        counterexample=counterexample,
    )


def _evaluated(expression: Expr) -> Number:
    return Evaluator(Tensor((), (expression,)), ())([]).entries[0]


def _shown(value: Number) -> str:
    return str(mpmath.nstr(value, SHOWN_DIGITS)).removesuffix(".0")


def _unit(claim: Claim) -> str:
    return f"{claim.unit} " if claim.unit not in {"", "1"} else ""


def _few(
    found: Sequence[tuple[str, Number, Mapping[str, Number]]],
) -> list[tuple[str, Number, Mapping[str, Number]]]:
    """All values, or the first and last of many."""
    return list(found) if len(found) <= 8 else [*found[:4], *found[-3:]]
