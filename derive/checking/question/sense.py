"""In which sense a formula claims to be a quantity: exactly, to an order in the deviations, in a limit, on a domain."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace

from radartrack.derive import symbolic as sp
from radartrack.derive.checking.question.compared_quantity import Reference
from radartrack.derive.checking.question.conditions import under
from radartrack.derive.checking.question.names import Names
from radartrack.derive.checking.question.printed_formula import Printed, symbol_called
from radartrack.derive.formula.error import FormulaError
from radartrack.derive.language.tensor import Tensor
from radartrack.derive.language.variable import Variable
from radartrack.derive.symbolic import Expr, Symbol
from radartrack.derive.verbs.limit import limit
from radartrack.derive.verbs.taylor_polynomial import taylor

DEVIATION = "sigma"


@dataclass(frozen=True)
class Sense:
    """How a formula is meant.

    Attributes:
        to_order: compared are the Taylor polynomials in all standard deviations together, up to this order.
        limit: compared are the limits where these symbols go to these points. Where the printed formula holds the
            symbol still, it is said to be asymptotically the quantity: the limit of their quotient is one.
        within: from where to where symbols lie.
    """

    to_order: int | None = None
    limit: Mapping[str, str] = field(default_factory=dict)
    within: Mapping[str, tuple[str, str]] = field(default_factory=dict)

    @property
    def words(self) -> str:
        """After a verdict: " to order 4"."""
        order = f" to order {self.to_order}" if self.to_order is not None else ""
        limits = " and ".join(f"{name} goes to {point}" for name, point in self.limit.items())
        ends = " and ".join(f"{name} from {low} to {high}" for name, (low, high) in self.within.items())
        return order + (f" where {limits}" if limits else "") + (f" for {ends}" if ends else "")

    def applied(
        self, reference: Reference, printed: Printed, names: Names, conditions: Mapping[Symbol, Expr]
    ) -> tuple[Reference, Printed]:
        """What is compared in this sense, under conditions.

        Raises:
            FormulaError: naming the field.
            NoClosedForm: when there is no such polynomial, or no such limit.
        """
        both = zip(printed.expressions, reference.entries, strict=True)
        pairs = [(under(conditions, ours), under(conditions, theirs)) for ours, theirs in both]
        if self.to_order is not None:
            pairs = _truncated(pairs, reference.symbols, self.to_order)
        for name, point in self.limit.items():
            pairs = [_limits(pair, symbol_in("limit", name, names, reference), _point(point, names)) for pair in pairs]
        symbols = _within(reference.symbols, self.within, names, reference) if self.within else reference.symbols
        ours, theirs = (Tensor(reference.shape, tuple(side)) for side in zip(*pairs, strict=True))
        if self.to_order is None and not self.limit:
            return replace(reference, symbols=symbols), printed
        changed = replace(reference, entry=theirs.__getitem__, symbols=symbols, part=None)
        return changed, replace(printed, expressions=ours)


EXACTLY = Sense()
Pair = tuple[Expr, Expr]


def symbol_in(what: str, name: str, names: Names, reference: Reference) -> Variable:
    """The symbol that a field names.

    Raises:
        FormulaError: where there is none.
    """
    symbol = symbol_called(name, names, reference)
    if symbol is None:
        known = ", ".join(one.name for one in reference.symbols)
        raise FormulaError(f"{what}.{name}: the symbols of {reference.text} are {known}")
    return symbol


def _truncated(pairs: Sequence[Pair], symbols: Sequence[Variable], order: int) -> list[Pair]:
    deviations = [symbol for symbol in symbols if symbol.name.removeprefix("predicted_").startswith(DEVIATION)]
    if not deviations:
        raise FormulaError(f"to_order: no deviation occurs; the name of one begins with {DEVIATION}")
    return [(taylor(ours, deviations, order), taylor(theirs, deviations, order)) for ours, theirs in pairs]


def _limits(pair: Pair, symbol: Variable, point: Expr) -> Pair:
    ours, theirs = pair
    if symbol not in ours.free_symbols:
        return ours, limit(theirs, symbol, point)
    return limit(ours / theirs, symbol, point), sp.Integer(1)


def _point(text: str, names: Names) -> Expr:
    sign, number = (-1, text[1:]) if text.strip().startswith("-") else (1, text)
    if number.strip() == "inf":
        return sign * sp.oo
    return _closed(text, names, "limit")


def _closed(text: str, names: Names, field_name: str) -> Expr:
    try:
        return names.read(names.tree(text))
    except FormulaError as error:
        raise FormulaError(f"{field_name}: {error.message}", error.source or text, error.span) from None


def _within(
    symbols: Sequence[Variable], ends: Mapping[str, tuple[str, str]], names: Names, reference: Reference
) -> tuple[Variable, ...]:

    found = dict(zip(symbols, symbols, strict=True))
    for name, (low, high) in ends.items():
        symbol = symbol_in("within", name, names, reference)
        values = [_closed(end, names, f"within.{name}") for end in (low, high)]
        if any(value.free_symbols for value in values):
            raise FormulaError(f"within.{name}: from {low} to {high}: both must be numbers")
        first, last = map(float, values)
        if not first < last:
            raise FormulaError(f"within.{name}: from {low} to {high}: the first must be less than the second")
        if symbol.is_positive and first <= 0:
            raise FormulaError(f"within.{name}: from {low} to {high}: {name} is above 0, so its domain begins there")
        found[symbol] = symbol.on(first, last)
    return tuple(found.values())
