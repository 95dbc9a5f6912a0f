"""The leading order of a difference in the standard deviations: what tells an approximation from a misprint."""

from __future__ import annotations

from collections.abc import Sequence

import mpmath

from radartrack.derive.evaluation.many_digits import Evaluator
from radartrack.derive.evaluation.points import generic_points
from radartrack.derive.language.tensor import Tensor
from radartrack.derive.language.variable import Variable
from radartrack.derive.symbolic import Expr

HALVINGS = (40, 41)  # of the deviations: so small that only the leading order is left, one halving apart to read it
DIGITS = 400  # forty halvings to the twentieth order cost 240
HIGHEST = 20  # order; a difference of a higher one is none that a paper could mean


def orders(difference: Expr, quantity: Expr, symbols: Sequence[Variable]) -> tuple[int, int] | None:
    """The orders of a difference and of the quantity when all deviations shrink together.

    Found from the ratio of the values at two tiny scales, in arithmetic that carries hundreds of digits.

    Returns:
        None without deviations, and where one of the two has no such order.
    """
    deviations = [symbol for symbol in symbols if is_deviation(symbol)]
    if not deviations:
        return None
    found = [_order(expression, symbols, deviations) for expression in (difference, quantity)]
    known = [order for order in found if order is not None]
    return (known[0], known[1]) if len(known) == 2 else None


def is_deviation(symbol: Variable) -> bool:
    """Whether a symbol is the standard deviation of an error or of a prediction."""
    return bool(symbol.deviation_of)


def _order(expression: Expr, symbols: Sequence[Variable], deviations: Sequence[Variable]) -> int | None:
    evaluator = Evaluator(Tensor((), (expression,)), symbols, DIGITS)
    (point,) = generic_points(symbols, 1)
    values = []
    for halvings in HALVINGS:
        scaled = point | {symbol.name: point[symbol.name] * 2.0**-halvings for symbol in deviations}
        try:
            values.append(evaluator([scaled[symbol.name] for symbol in symbols]).entries[0])
        except (ArithmeticError, ValueError):
            return None
    if not values[0] or not values[1]:
        return None
    slope = mpmath.log(abs(values[0] / values[1]), 2)
    order = round(float(slope))
    return order if abs(slope - order) < 1e-6 and order <= HIGHEST else None
