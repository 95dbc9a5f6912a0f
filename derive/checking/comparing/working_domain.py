"""Where radars work: the part of a domain in which the worst of a difference is looked for.

Domains of symbols are as wide as the generated code is held to its accuracy: a deviation of a millimetre at a range
of 100 000 km is inside them. What is worst there tells nobody how much a misprint matters.
"""

from __future__ import annotations

from collections.abc import Sequence

from radartrack.derive.evaluation.points import Point
from radartrack.derive.language.variable import Variable
from radartrack.derive.units import METRE, METRE_PER_SECOND, RADIAN, SECOND, Unit

WORDS = "where radars work"
_POSITIVE: dict[Unit, tuple[float, float]] = {METRE: (10.0, 5e6), SECOND: (1e-2, 1e2)}
_DEVIATIONS: dict[Unit, tuple[float, float]] = {
    METRE: (0.1, 2e3),
    METRE_PER_SECOND: (1e-2, 1e2),
    RADIAN: (1e-5, 0.262),  # to 15 degrees
}
_OF_NO_UNIT = (1e-5, 0.3)  # deviations of direction cosines
_SHARE = (1e-7, 0.2)  # of a deviation in the length that it belongs to


def working(symbols: Sequence[Variable]) -> list[Variable]:
    """The symbols with the part of their domain in which radars work; all of it where they work in none of it."""
    return [_narrowed(symbol) for symbol in symbols]


def works(symbols: Sequence[Variable], point: Point) -> bool:
    """Whether a radar measures a length as well, and as badly, as this."""
    lengths = ((s.name, s.deviation_of) for s in symbols if s.deviation_of and s.unit == METRE)
    low, high = _SHARE
    return all(low * point[of] <= point[name] <= high * point[of] for name, of in lengths if point.get(of, 0.0) > 0)


def _narrowed(symbol: Variable) -> Variable:
    known = _DEVIATIONS.get(symbol.unit, _OF_NO_UNIT) if symbol.deviation_of else _POSITIVE.get(symbol.unit)
    if known is None or symbol.low <= 0 or symbol.at_most or symbol.whole:
        return symbol
    low, high = max(symbol.low, known[0]), min(symbol.high, known[1])
    if low >= high:
        return symbol
    return symbol.on(low, high)
