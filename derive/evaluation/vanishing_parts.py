"""Where, inside of a domain, what stands under a root, in a divisor or in an arc cosine reaches its end."""

from __future__ import annotations

import math
import random
from collections.abc import Callable, Iterator, Sequence

import mpmath

from radartrack.derive import symbolic as sp
from radartrack.derive.evaluation.floating_point import RoughEvaluator
from radartrack.derive.evaluation.many_digits import DIGITS, Evaluator
from radartrack.derive.language.model_outputs import is_power, parts
from radartrack.derive.language.tensor import Tensor
from radartrack.derive.language.variable import Variable
from radartrack.derive.symbolic import Expr

LINES = 24  # in any direction through a domain of several symbols, beside one along each
STEPS = 48  # of a line
PROMISING = 0.2  # of what is beside a minimum, below which a parabola has to fall for it to be followed
GOLDEN = (5**0.5 - 1) / 2
FIRST, ALL = 14, 64  # steps of a search; after the first ones it is seen whether a minimum goes on falling
FALLING = 1e-3  # of what is beside the minimum
NOTHING = 1e-20  # likewise

Line = Callable[[mpmath.mpf], list[mpmath.mpf]]
Place = tuple[int, int]  # steps between which an expression may vanish


def critical_parts(expression: Expr) -> Iterator[tuple[Expr, Expr]]:
    """Parts that lack derivatives somewhere, and what vanishes there."""
    for part in parts(expression):
        if is_power(part) and part.base.free_symbols:
            if part.exp < sp.Integer(0) or not isinstance(part.exp, sp.Integer):
                yield part, part.base
        elif isinstance(part, sp.log):
            yield part, part.args[0]
        elif isinstance(part, sp.tan):
            yield part, sp.cos(part.args[0])
        elif isinstance(part, sp.asin | sp.acos):
            yield part, 1 - part.args[0] ** 2
        elif isinstance(part, sp.atan2 | sp.hypot):
            yield part, part.args[0] ** 2 + part.args[1] ** 2


def vanishing_points(
    expressions: Sequence[Expr], symbols: Sequence[Variable]
) -> Iterator[tuple[int, dict[Variable, mpmath.mpf]]]:
    """Expressions, by number, that are zero or change their sign inside of a domain, and a point where they do.

    It is looked for along lines. What vanishes at single points of a plane, as the distance from the radar does, is
    not met; what vanishes on a curve is.
    """
    rough = RoughEvaluator(expressions, symbols)
    precise = [Evaluator(Tensor((), (one,)), symbols) for one in expressions]
    with mpmath.workdps(DIGITS):
        for line in _lines(symbols):
            sampled = [rough([float(value) for value in line(_share(step))]) for step in range(STEPS + 1)]
            for number, evaluator in enumerate(precise):
                values = [math.nan if one is None else one[number][0] for one in sampled]
                along = _Along(evaluator, line)
                found = next((at for place in _places(values) if (at := _followed(along, place)) is not None), None)
                if found is not None:
                    yield number, dict(zip(symbols, line(found), strict=True))


def _share(step: int) -> mpmath.mpf:
    return mpmath.mpf(step) / STEPS


def _places(values: Sequence[float]) -> Iterator[Place]:
    """Where an expression changes its sign, then where it may touch zero, the likeliest first."""
    yield from ((step - 1, step) for step in range(1, STEPS + 1) if values[step - 1] * values[step] < 0)
    promising = ((_fallen(values[step - 1 : step + 2]), step) for step in range(1, STEPS))
    yield from ((step - 1, step + 1) for fallen, step in sorted(promising) if fallen < PROMISING)


def _fallen(values: Sequence[float]) -> float:
    """How deep a parabola through a minimum of the size goes, in units of what is beside it; 1 of no minimum."""
    before, here, after = map(abs, values)
    if not here <= min(before, after) < math.inf or not before + after > 0:
        return 1.0
    if not (bend := before - 2 * here + after):
        return here / min(before, after)
    return (here - (after - before) ** 2 / (8 * bend)) / min(before, after)


class _Along:
    """An expression along a line."""

    def __init__(self, evaluator: Evaluator, line: Line) -> None:
        self._evaluator, self._line = evaluator, line

    def __call__(self, share: mpmath.mpf) -> mpmath.mpf:
        """Its value; infinite where it has none, as another part is at its end there."""
        try:
            value = self._evaluator(self._line(share)).entries[0]
        except ArithmeticError:
            return mpmath.inf
        return value if isinstance(value, mpmath.mpf) else mpmath.inf


def _followed(value: _Along, place: Place) -> mpmath.mpf | None:
    """The share of a line at which an expression vanishes, between two steps; None where it does not."""
    start, end = map(_share, place)
    at_start, at_end = value(start), value(end)
    if not at_start * at_end:  # a step is where it vanishes
        return next(share for share, one in ((start, at_start), (end, at_end)) if not one)
    if (at_start < 0) != (at_end < 0):
        return _crossing(value, start, end)
    return _lowest(value, start, end)


def _crossing(value: _Along, below: mpmath.mpf, above: mpmath.mpf) -> mpmath.mpf:
    """Where the sign changes, on the negative side."""
    is_negative = value(below) < 0
    for _ in range(ALL):
        middle = (below + above) / 2
        below, above = (middle, above) if (value(middle) < 0) == is_negative else (below, middle)
    return below if is_negative else above


def _lowest(value: _Along, start: mpmath.mpf, end: mpmath.mpf) -> mpmath.mpf | None:
    """Where the size of what has one sign beside a minimum is zero, or the sign the other; by golden sections."""
    sign = 1 if value(start) > 0 else -1
    beside = min(abs(value(start)), abs(value(end)))
    first, second = end - GOLDEN * (end - start), start + GOLDEN * (end - start)
    at_first, at_second = sign * value(first), sign * value(second)
    for step in range(ALL):
        lowest, place = min((at_first, first), (at_second, second))
        if lowest <= NOTHING * beside:
            return place
        if step == FIRST and lowest > FALLING * beside:
            return None
        if at_first < at_second:
            end, second, at_second = second, first, at_first
            first = end - GOLDEN * (end - start)
            at_first = sign * value(first)
        else:
            start, first, at_first = first, second, at_second
            second = start + GOLDEN * (end - start)
            at_second = sign * value(second)
    return None


def _lines(symbols: Sequence[Variable]) -> Iterator[Line]:
    """Through the domain: along each symbol and, of several, in any direction; the same each time."""
    chance = random.Random(0)  # noqa: S311 - no secret
    count = len(symbols)
    directions = [[float(one == other) for other in range(count)] for one in range(count)]
    directions += [[chance.gauss(0, 1) for _ in symbols] for _ in range(LINES if count > 1 else 0)]
    for direction in directions:
        inside = [chance.random() for _ in symbols]
        ends = [sorted((-at / slope, (1 - at) / slope)) for at, slope in zip(inside, direction, strict=True) if slope]
        yield _Chord(symbols, inside, direction, max(low for low, _ in ends), min(high for _, high in ends))


class _Chord:
    """A straight line from one face of the domain to another, in the shares of the symbols."""

    def __init__(
        self, symbols: Sequence[Variable], inside: list[float], direction: list[float], start: float, end: float
    ) -> None:
        self._symbols, self._inside, self._direction = symbols, inside, direction
        self._start, self._length = start, end - start

    def __call__(self, share: mpmath.mpf) -> list[mpmath.mpf]:
        along = self._start + share * self._length
        every = zip(self._symbols, self._inside, self._direction, strict=True)
        return [_between(symbol, at + along * slope) for symbol, at, slope in every]


def _between(symbol: Variable, share: mpmath.mpf) -> mpmath.mpf:
    if symbol.logarithmic:
        return symbol.low * (mpmath.mpf(symbol.high) / symbol.low) ** share
    return symbol.low + (mpmath.mpf(symbol.high) - symbol.low) * share
