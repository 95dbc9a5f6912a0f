"""A formula under the conditions of a question."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from radartrack.derive import symbolic as sp
from radartrack.derive.checking.question.possible_values import check_domain, check_domain_somewhere
from radartrack.derive.formula.error import FormulaError
from radartrack.derive.formula.to_expression import is_real
from radartrack.derive.language.variable import Variable
from radartrack.derive.symbolic import Expr, Symbol


def resolved(conditions: Mapping[Variable, Expr]) -> dict[Symbol, Expr]:
    """Conditions put into each other in the order of dependence, so that none names what another one sets.

    Raises:
        FormulaError: for a symbol that is set by itself, alone or by way of others, and for a value that it cannot
            have.
    """
    waiting = dict(conditions)
    found: dict[Symbol, Expr] = {}
    while waiting:
        symbol = next((one for one, value in waiting.items() if not value.free_symbols & waiting.keys()), None)
        if symbol is None:
            raise FormulaError(_circular(waiting))
        found[symbol] = _put_in(found, symbol, waiting.pop(symbol))
    check_domain({one: found[one] for one in conditions if not found[one].free_symbols}, "given")
    for one in conditions:
        check_domain_somewhere(one, found[one], "given")
    return {one: found[one] for one in conditions}


def _put_in(found: Mapping[Symbol, Expr], symbol: Variable, value: Expr) -> Expr:
    closed = under(found, value)
    if not is_real(closed):
        raise FormulaError(f"given {symbol}: {value} has no value under the other conditions")
    return closed


def _circular(waiting: Mapping[Variable, Expr]) -> str:
    """Why these conditions set nothing, and how to write what may be meant."""
    itself = next((one for one, value in waiting.items() if one in value.free_symbols), None)
    if itself is not None:
        return (
            f"given {itself}: {waiting[itself]} is a condition of {itself} on itself; a condition sets a symbol to a "
            f"number or to other symbols. To write a formula in another variable, define that one: "
            f"let new = {waiting[itself]}"
        )
    names = " and ".join(map(str, waiting))
    return f"given: {names} are set by each other; leave one of these conditions out"


def under(conditions: Mapping[Symbol, Expr], expression: Expr) -> Expr:
    """The expression with symbols replaced; without conditions no walk over it is taken, as SymPy would take it."""
    return expression.xreplace(conditions) if conditions else expression


def zero(symbols: Sequence[Symbol]) -> dict[Symbol, Expr]:
    """The condition that all of these vanish."""
    return {symbol: sp.Integer(0) for symbol in symbols}


def also_zero(conditions: Mapping[Symbol, Expr], symbols: Sequence[Symbol]) -> dict[Symbol, Expr] | None:
    """Conditions and that all of these symbols vanish besides; None where a condition has no value then."""
    return joined(conditions, zero(symbols))


def joined(conditions: Mapping[Symbol, Expr], more: Mapping[Symbol, Expr]) -> dict[Symbol, Expr] | None:
    """Conditions and others that hold besides; None where one has no value then."""
    both = {symbol: under(more, value) for symbol, value in conditions.items()} | dict(more)
    return both if all(map(is_real, both.values())) else None


def when_zero(symbols: Sequence[Symbol]) -> str:
    """The same in words after a verdict: " when rho = 0"; nothing for no symbols."""
    return when(zero(symbols))


def when(conditions: Mapping[Symbol, Expr]) -> str:
    """Conditions in words after a verdict; nothing for none."""
    return " when " + " and ".join(f"{symbol} = {value}" for symbol, value in conditions.items()) if conditions else ""
