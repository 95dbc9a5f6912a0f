"""What the difference of an entry is measured against over the whole domain."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import mpmath

from radartrack.derive import symbolic as sp
from radartrack.derive.checking.points import Point
from radartrack.derive.checking.reference import Reference
from radartrack.derive.evaluation import Evaluator, Number
from radartrack.derive.symbolic import Expr, Symbol
from radartrack.derive.tensor import Index, Tensor


def scale_of(
    reference: Reference, entry: Index, symbols: Sequence[Symbol], under: dict[Symbol, Expr]
) -> Callable[[Point], Number]:
    """A vector's entry counts by the norm, a covariance by the root of its variances, everything else by itself."""
    part = reference.part
    if part is None:
        return _norm(Tensor((), (reference.entries[entry],)), symbols, under)
    place = part.places[entry]
    whole = part.quantity.expression
    if part.quantity.is_covariance:
        return _norm(Tensor((), (_deviations(whole, place),)), symbols, under)
    return _norm(whole if len(place) == 1 else Tensor((), (whole[place],)), symbols, under)


def _deviations(covariance: Tensor[Expr], place: Index) -> Expr:
    """The square root is taken of the product; of a variance it is the variance."""
    first, second = place
    if first == second:
        return covariance[place]
    product = covariance[first, first] * covariance[second, second]
    return sp.sqrt(product)


def _norm(entries: Tensor[Expr], symbols: Sequence[Symbol], under: dict[Symbol, Expr]) -> Callable[[Point], Number]:
    evaluator = Evaluator(entries.map(lambda entry: entry.xreplace(under)), symbols)

    def norm(point: Point) -> Number:
        try:
            values = evaluator([point[symbol.name] for symbol in symbols])
        except (ArithmeticError, ValueError):
            return 0
        return mpmath.sqrt(sum(abs(value) ** 2 for value in values))

    return norm
