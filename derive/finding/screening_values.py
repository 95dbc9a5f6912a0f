"""What every entry of a quantity is worth at three points: by that a formula is found among all in milliseconds.

Two points are generic, of ordinary size, where nothing cancels: formulas that are worth the same at both are one, but
for a proof. At the third, a round one, a radar works: formulas that are nearly the same there are near.
"""

from __future__ import annotations

from collections.abc import Sequence
from hashlib import sha256
from typing import Any

import mpmath

from radartrack.derive.checking.question.conditions import zero
from radartrack.derive.evaluation.many_digits import Evaluator
from radartrack.derive.evaluation.points import Point, round_points
from radartrack.derive.language.quantity import Quantity
from radartrack.derive.language.tensor import Tensor
from radartrack.derive.language.variable import Variable
from radartrack.derive.symbolic import Expr
from radartrack.derive.units import RADIAN

DIGITS = 14  # that are written: what floating point has, less its rounding
POINTS = 3  # two generic ones and a round one


def row(quantity: Quantity, letters: int | None = None) -> dict[str, Any]:
    """The values of a quantity as data: of its symbols, and of its entries with and without correlations.

    Args:
        quantity: the quantity.
        letters: where only a formula in so many letters is looked for: other entries have no values then.
    """
    points = _points(quantity.symbols)
    names = [symbol.name for symbol in quantity.symbols]
    entries = quantity.expression
    correlations = [symbol.name for symbol in quantity.symbols if symbol.is_correlation]
    used = _used(entries, quantity.symbols)
    data: dict[str, Any] = {
        "meaning": quantity.meaning,
        "source": quantity.source.reference,
        "shape": list(quantity.shape),
        "symbols": {name: [_rounded(point[name]) for point in points] for name in names},
        "angles": [symbol.name for symbol in quantity.symbols if symbol.is_angle],
        "kinds": {symbol.name: _kind(symbol) for symbol in quantity.symbols},
        "used": used,
        "values": _values(entries, quantity.symbols, points, _wanted(used, letters)),
    }
    if correlations:
        vanishing = zero([symbol for symbol in quantity.symbols if symbol.is_correlation])
        uncorrelated = [point | dict.fromkeys(correlations, 0.0) for point in points]
        used = _used(entries.map(lambda entry: entry.xreplace(vanishing)), quantity.symbols)
        data |= {
            "correlations": correlations,
            "used_uncorrelated": used,
            "uncorrelated": _values(entries, quantity.symbols, uncorrelated, _wanted(used, letters)),
        }
    return data


def _used(entries: Tensor[Expr], symbols: Sequence[Variable]) -> list[str]:
    """For each entry a word of 0 and 1: in which of the symbols it is."""
    return ["".join("01"[symbol in used] for symbol in symbols) for used in (entry.free_symbols for entry in entries)]


def _points(symbols: Sequence[Variable]) -> list[Point]:
    generic = [{s.name: _generic(s, number) for s in symbols} for number in range(POINTS - 1)]
    return [
        {name: _rounded(value) for name, value in point.items()} for point in (*generic, next(round_points(symbols)))
    ]


def _generic(symbol: Variable, number: int) -> float:
    """A value that depends on the name and the kind of a symbol alone, so that one formula serves many quantities."""
    share = int.from_bytes(sha256(f"{symbol.name} {number}".encode()).digest()[:6], "big") / 2**48
    low, high = _interval(symbol)
    return low + (high - low) * share


def _interval(symbol: Variable) -> tuple[float, float]:
    if symbol.whole:
        return (1.3, 3.3) if symbol.at_most else (6.3, 9.3)
    if symbol.unit == RADIAN or symbol.high <= 1:
        return 0.2, 0.5
    return (0.6, 1.7) if symbol.low < 1.7 else (symbol.low + 0.6, symbol.low + 1.7)


def _kind(symbol: Variable) -> str:
    return "angle" if symbol.is_angle else str(symbol.unit)


def _wanted(used: Sequence[str], letters: int | None) -> list[bool]:
    """The entries in so many symbols."""
    return [letters in {None, word.count("1")} for word in used]


def _values(
    entries: Tensor[Expr], symbols: Sequence[Variable], points: Sequence[Point], wanted: Sequence[bool]
) -> list[list[float] | None]:
    pairs = zip(entries, wanted, strict=True)
    return [_at_all(entry, symbols, points) if is_wanted else None for entry, is_wanted in pairs]


def _at_all(entry: Expr, symbols: Sequence[Variable], points: Sequence[Point]) -> list[float] | None:
    """The values of an entry; None where it has no real one at one of the points."""
    evaluator = Evaluator(Tensor((), (entry,)), symbols)
    try:
        found = [evaluator([point[symbol.name] for symbol in symbols]).entries[0] for point in points]
    except (ArithmeticError, ValueError):
        return None
    if not all(isinstance(value, mpmath.mpf) and mpmath.isfinite(value) for value in found):
        return None
    return [_rounded(value) for value in found]


def _rounded(value: Any) -> float:
    return float(mpmath.nstr(mpmath.mpf(value), DIGITS))
