"""What values a symbol can have at all: a correlation of 2, half a scan and a negative range are none.

The domain of a variable is where formulas are held to their accuracy; a paper may go beyond its largest range, or below
its smallest error. What is refused here is what no radar has.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from contextlib import suppress
from fractions import Fraction

from radartrack.derive import symbolic as sp
from radartrack.derive.evaluation.exact_numbers import Function, NoRealValue, Undecidable, order
from radartrack.derive.evaluation.points import domain_points, round_points
from radartrack.derive.formula.error import FormulaError
from radartrack.derive.language.variable import Variable
from radartrack.derive.symbolic import Expr
from radartrack.derive.units import ONE

TRIED = 20  # points


def check_domain(values: Mapping[Variable, Expr], where: str) -> None:
    """Refuse numbers that these symbols cannot be.

    Args:
        values: closed expressions, in SI units.
        where: what sets them, such as `at`.

    Raises:
        FormulaError: naming the symbol, its value and its domain.
    """
    for symbol, value in values.items():
        if not _is_possible(symbol, value):
            raise FormulaError(f"{where}: {symbol} = {value} is outside the domain of {symbol}: {domain(symbol)}")
        bound = symbol.at_most and values.get(symbol.at_most)
        if bound is not None and _compared(value, bound) > 0:
            raise FormulaError(
                f"{where}: {symbol} = {value} is outside the domain of {symbol}: "
                f"at most {symbol.at_most}, which is {bound}"
            )


def check_domain_somewhere(symbol: Variable, value: Expr, where: str) -> None:
    """Refuse a formula that lies outside the domain of a symbol wherever it was tried.

    Raises:
        FormulaError: naming the symbol, the formula and the domain.
    """
    low, high = _limits(symbol)
    used = sorted((one for one in value.free_symbols if isinstance(one, Variable)), key=str)
    if not used or low is None:
        return
    function = Function(value, used)
    for point in (*round_points(used), *domain_points(used, TRIED)):
        with suppress(NoRealValue):
            found = function.at({one: sp.Rational(Fraction(point[one.name])) for one in used}).value()
            if found >= float(low) and (high is None or found <= float(high)):
                return
    raise FormulaError(f"{where}: {symbol} = {value} is outside the domain of {symbol} everywhere: {domain(symbol)}")


def domain(symbol: Variable) -> str:
    """The values that a symbol can have, in words."""
    if symbol.whole:
        return f"whole numbers from {symbol.least}"
    low, high = _limits(symbol)
    unit = "" if symbol.unit == ONE else f" {symbol.unit}"
    limits = (("at least", low), ("at most", high))
    return " and ".join(f"{words} {limit}{unit}" for words, limit in limits if limit is not None)


def _is_possible(symbol: Variable, value: Expr) -> bool:
    if symbol.whole and not isinstance(value, sp.Integer):
        return False
    low, high = _limits(symbol)
    return (low is None or _compared(value, low) >= 0) and (high is None or _compared(value, high) <= 0)


def _limits(symbol: Variable) -> tuple[Expr | None, Expr | None]:
    """Least and largest possible value; what is symmetric and at most one is a correlation or a cosine."""
    if symbol.whole:
        return sp.Integer(symbol.least), None
    if symbol.low >= 0:
        return sp.Integer(0), None
    if symbol.is_angle:
        return (-sp.pi / 2, sp.pi / 2) if symbol.high <= math.pi / 2 else (None, None)  # a direction may turn further
    if symbol.unit == ONE and symbol.high <= 1:
        return sp.Integer(-1), sp.Integer(1)
    return None, None


def _compared(first: Expr, second: Expr) -> int:
    try:
        return order(first, second)
    except Undecidable:
        return 0  # on the limit, as far as thousands of digits tell
