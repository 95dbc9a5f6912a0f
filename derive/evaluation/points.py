"""Points at which formulas are compared: round ones a radar might see, the whole domain, and ones for screening."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from itertools import cycle, islice

from radartrack.derive.language.variable import Variable
from radartrack.derive.units import METRE, METRE_PER_SECOND, ONE, RADIAN, SECOND, Unit

Point = dict[str, float]
Range = Callable[[float], float]  # a value for a fraction between 0 and 1
BEFORE_THE_END = 0.95
SMALL = 1e-3  # where the scales of what may be zero begin

# What stands in an example: a target 50 km away, a deviation of 50 m and of one degree.
_ROUND: Mapping[tuple[str, Unit], float] = {
    ("r", METRE): 5e4,
    ("beta", RADIAN): math.radians(30),
    ("epsilon", RADIAN): math.radians(20),
    ("rdot", METRE_PER_SECOND): -200.0,
    ("u", ONE): 0.3,
    ("v", ONE): 0.4,
    ("v", METRE_PER_SECOND): 200.0,
    ("x", METRE): 3e4,
    ("y", METRE): 2e4,
    ("z", METRE): 1e4,
    ("sigma_r", METRE): 50.0,
    ("sigma_beta", RADIAN): math.radians(1),
    ("sigma_epsilon", RADIAN): math.radians(1),
    ("sigma_rdot", METRE_PER_SECOND): 2.0,
    ("sigma_u", ONE): 0.02,
    ("sigma_v", ONE): 0.02,
    ("rho", ONE): 0.5,
    ("k", ONE): 8.0,
    ("j", ONE): 3.0,
    ("T", SECOND): 10.0,
    ("C", ONE): 2.0,
}
_BY_UNIT = {METRE: 1e3, RADIAN: math.radians(10), METRE_PER_SECOND: 50.0, SECOND: 10.0, ONE: 1.0}
_DEVIATION = {METRE: 10.0, RADIAN: math.radians(1), METRE_PER_SECOND: 1.0, ONE: 0.01}
# How the round point is varied until a difference matters: the range divided, the deviations of ranges and of angles
# multiplied, the angles turned.
_VARIATIONS = (
    (1.0, 1.0, 1.0, 0.0),
    (1.0, 1.0, 5.0, 0.0),
    (1.0, 1.0, 15.0, 0.0),
    (10.0, 5.0, 1.0, 0.0),
    (50.0, 6.0, 15.0, 0.0),
    (1.0, 1.0, 1.0, math.radians(20)),
    (1.0, 1.0, 15.0, math.radians(75)),
    (50.0, 6.0, 15.0, math.radians(55)),
)
_PRIMES = (2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37)


def round_points(symbols: Sequence[Variable]) -> Iterator[Point]:
    """Round points inside the domain, the plainest first; later ones have larger errors and other directions."""
    for variation in _VARIATIONS:
        values = {s.name: _rounded(s, prime, *variation) for s, prime in zip(symbols, cycle(_PRIMES), strict=False)}
        yield _ordered(symbols, values)


def domain_points(symbols: Sequence[Variable], count: int) -> list[Point]:
    """Points spread over the domain by a Halton sequence."""
    return list(_spread(symbols, count, lambda symbol: _between(symbol.low, symbol.high)))


def scattered_points(symbols: Sequence[Variable], count: int) -> list[Point]:
    """Points all over the domain on every scale: of lengths with a sign, small ones beside large ones too."""
    return list(_spread(symbols, count, _on_any_scale, first=1000))


def corner_points(symbols: Sequence[Variable]) -> Iterator[Point]:
    """Corners of the domain: of any three symbols every combination of their lowest and highest values.

    They are an orthogonal array of strength three: signs are products of the digits of the corner's number, and of the
    columns that count its first digit no three depend on each other.
    """
    columns = range(1, 2 * len(symbols), 2)
    for number in range(2 ** max(columns, default=0).bit_length()):
        point: Point = {}
        for symbol, column in sorted(zip(symbols, columns, strict=True), key=lambda pair: bool(pair[0].at_most)):
            bound = point.get(symbol.at_most.name) if symbol.at_most else None
            inside = symbol if bound is None else symbol.below(bound)
            point[symbol.name] = _end(inside, high=(number & column).bit_count() % 2 == 1)
        yield _ordered(symbols, {symbol.name: point[symbol.name] for symbol in symbols})


def ordinary_points(symbols: Sequence[Variable], count: int) -> list[Point]:
    """Points inside the domain, of ordinary size where that is inside."""
    return list(_spread(symbols, count, lambda symbol: _between(*_ordinary_inside(symbol))))


def generic_points(symbols: Sequence[Variable], count: int) -> list[Point]:
    """Points for screening, of ordinary size and well inside principal branches, where floating point loses nothing.

    Some lie outside the domain, with fractions for whole numbers: what is found there says nothing about it.
    """
    return list(_spread(symbols, count, lambda symbol: _between(*_ordinary(symbol)), whole=False))


def _rounded(symbol: Variable, prime: int, nearer: float, rougher: float, wider: float, turn: float) -> float:
    name = symbol.name.removeprefix("predicted_")
    by_unit = _DEVIATION if name.startswith("sigma") else _BY_UNIT
    value = _ROUND.get((name, symbol.unit), by_unit.get(symbol.unit, 1.0) * prime)
    if symbol.unit == RADIAN:
        value = value * wider if name.startswith("sigma") else value + turn
    elif name == "sigma_r":
        value *= rougher
    elif name == "r":
        value /= nearer
    return _inside(symbol, value)


def _inside(symbol: Variable, value: float) -> float:
    if symbol.low <= value <= symbol.high:
        return value
    value = math.sqrt(symbol.low * symbol.high) if symbol.low > 0 else symbol.low + (symbol.high - symbol.low) * 0.3
    return float(math.ceil(value)) if symbol.whole else value


def _spread(
    symbols: Sequence[Variable],
    count: int,
    range_of: Callable[[Variable], Range],
    *,
    whole: bool = True,
    first: int = 20,
) -> Iterator[Point]:
    """Points whose values come from fractions between 0 and 1; those of bounded symbols after those that bound them."""
    sequences = [islice(_halton(_PRIMES[i % len(_PRIMES)]), first + 7 * i, None) for i, _ in enumerate(symbols)]
    for fractions in islice(zip(*sequences, strict=False), count):
        point: Point = {}
        for symbol, fraction in sorted(zip(symbols, fractions, strict=True), key=lambda pair: bool(pair[0].at_most)):
            bound = point.get(symbol.at_most.name) if symbol.at_most and whole else None
            value = range_of(symbol if bound is None else symbol.below(bound))(fraction)
            point[symbol.name] = float(round(value)) if symbol.whole and whole else value
        yield _ordered(symbols, {symbol.name: point[symbol.name] for symbol in symbols})
    if not symbols:
        yield {}


def _between(low: float, high: float) -> Range:
    """Evenly over the scales of what is positive, else over the values."""
    if low > 0:
        return lambda fraction: low * (high / low) ** fraction
    return lambda fraction: low + (high - low) * fraction


def _on_any_scale(symbol: Variable) -> Range:
    if symbol.low > 0 or symbol.high <= math.tau:
        return _between(symbol.low, symbol.high)

    def value(fraction: float) -> float:
        place = 2 * fraction - 1 if symbol.low < 0 else fraction
        end = symbol.high if place > 0 else symbol.low
        return math.copysign(abs(end) ** abs(place) * SMALL ** (1 - abs(place)), end)

    return value


def _ordinary(symbol: Variable) -> tuple[float, float]:
    """An interval of ordinary numbers, inside the domain where that has such."""
    if symbol.is_angle:
        return 0.13, 0.38
    if symbol.whole:
        low = max(symbol.low, 1.0) + (0.3 if symbol.at_most else 3.3)
        return low, low + 3
    low, high = (0.2, 0.55) if symbol.high <= 1 else (0.6, 1.7)
    if symbol.low >= high:  # larger than the others, as its domain is, but not so that these are lost beside it
        scale = (symbol.low / high) ** 0.2
        return 2.6 * scale, 3.7 * scale
    return (low, high) if symbol.low < high < symbol.high else (symbol.low + 0.6, symbol.low + 1.7)


def _ordinary_inside(symbol: Variable) -> tuple[float, float]:
    """The part of that interval that is inside the domain; where none is, the nearest scale of the domain."""
    low, high = _ordinary(symbol)
    if low >= symbol.high:
        return max(symbol.low, symbol.high / 5), symbol.high / 2
    if high <= symbol.low:
        return symbol.low, min(3 * symbol.low, symbol.high)
    return max(low, symbol.low), min(high, symbol.high)


def _end(symbol: Variable, *, high: bool) -> float:
    """The highest or the lowest value; of an angle one before its end, where sines and cosines vanish."""
    value = symbol.high if high else symbol.low
    return BEFORE_THE_END * value if symbol.is_angle and symbol.low < 0 else value


def _ordered(symbols: Sequence[Variable], point: Point) -> Point:
    """The point, moved where one symbol would exceed another that bounds it."""
    bounded = {
        s.name: min(point[s.name], point[s.at_most.name]) for s in symbols if s.at_most and s.at_most.name in point
    }
    return point | bounded


def _halton(base: int) -> Iterator[float]:
    number = 0
    while True:
        number += 1
        value, fraction, left = 0.0, 1.0 / base, number
        while left:
            left, digit = divmod(left, base)
            value += digit * fraction
            fraction /= base
        yield value
