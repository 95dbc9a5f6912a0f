"""Whether the outputs of a model, and their first two derivatives, are real numbers over its domain."""

from __future__ import annotations

import random
from collections.abc import Iterable, Iterator, Sequence
from itertools import islice, product
from operator import itemgetter

import mpmath

from radartrack.derive import symbolic as sp
from radartrack.derive.evaluation.many_digits import Evaluator
from radartrack.derive.evaluation.vanishing_parts import critical_parts, vanishing_points
from radartrack.derive.language.model_outputs import is_power, parts, shown
from radartrack.derive.language.tensor import Tensor
from radartrack.derive.language.variable import Variable
from radartrack.derive.symbolic import Expr

CORNERS = 512
INSIDE = 128
HALVINGS = 60
NEAR = 1e-9  # of a domain


def require_real(
    outputs: Iterable[tuple[str, Expr]], symbols: Sequence[Variable], measured: Sequence[Variable]
) -> None:
    """Check that outputs and their first two derivatives are real numbers, at the corners of the domain and inside.

    Points inside seldom meet a pole; it is between two points at which a divisor has different signs. What is
    only touched, as the end of an arc cosine by acos(cos(b)), is looked for along lines.

    Raises:
        ValueError: naming the part that is none, and where.
    """
    points = list(_points(symbols))
    for output, expression in outputs:
        slopes = [sp.diff(expression, variable) for variable in measured]
        bends = [sp.diff(slope, variable) for slope in slopes for variable in measured]
        everything = Evaluator(Tensor((1 + len(slopes) + len(bends),), (expression, *slopes, *bends)), symbols)
        for point in points:
            if not _real(everything, point):
                raise ValueError(f"output {output}: {_culprit(expression, symbols, measured, point)}")
        for part, divisor in _divisors(expression):
            pole = _zero(Evaluator(Tensor((), (divisor,)), symbols), points)
            if pole is not None:
                raise ValueError(f"output {output}: {shown(part)} has no value{_where(part, symbols, pole)}")
        critical = dict(critical_parts(expression))
        for number, place in vanishing_points(list(critical.values()), symbols):
            part, point = list(critical)[number], [_plain(place[symbol], symbol) for symbol in symbols]
            raise ValueError(f"output {output}: {_lack(part, point, symbols)}")


def _plain(value: mpmath.mpf, symbol: Variable) -> float:
    """A value as it is told: zero, where it is that beside the domain."""
    width = symbol.high - symbol.low
    return 0.0 if abs(value) < NEAR * width else float(value)


def _culprit(expression: Expr, symbols: Sequence[Variable], measured: Sequence[Variable], point: list[float]) -> str:
    """The smallest part that is not real at a point, else that a derivative is not."""
    for part in parts(expression):
        if not _real(Evaluator(Tensor((), (part,)), symbols), point):
            return f"{shown(part)} is no real number{_where(part, symbols, point)}"
    for part in parts(expression):
        slopes = (sp.diff(part, variable) for variable in measured if variable in part.free_symbols)
        if not all(_real(Evaluator(Tensor((), (slope,)), symbols), point) for slope in slopes):
            return f"{shown(part)} has no derivative{_where(part, symbols, point)}"
    return f"{shown(expression)} has no second derivative{_where(expression, symbols, point)}"


def _lack(part: Expr, point: list[float], symbols: Sequence[Variable]) -> str:
    """What a part has not, where what it is taken of ends."""
    is_pole = isinstance(part, sp.tan) or (is_power(part) and part.exp < sp.Integer(0))
    if not is_pole and not _real(Evaluator(Tensor((), (part,)), symbols), point):
        lack = "is no real number"
    else:
        lack = "has no value" if is_pole or isinstance(part, sp.log) else "lacks derivatives"
    return f"{shown(part)} {lack}{_where(part, symbols, point)}"


def _divisors(expression: Expr) -> Iterator[tuple[Expr, Expr]]:
    """What has poles, and what vanishes there."""
    for part in parts(expression):
        if is_power(part) and part.exp < sp.Integer(0) and part.base.free_symbols:
            yield part, part.base
        elif isinstance(part, sp.tan):
            yield part, sp.cos(part.args[0])


def _zero(divisor: Evaluator, points: Sequence[list[float]]) -> list[float] | None:
    """A zero of a continuous function between two of the points; None where it has one sign at all."""
    (lowest, below), (highest, above) = (
        choose(((divisor(point).entries[0], point) for point in points), key=itemgetter(0)) for choose in (min, max)
    )
    if lowest >= 0 or highest <= 0:
        return None
    for _ in range(HALVINGS):
        middle = [(first + second) / 2 for first, second in zip(below, above, strict=True)]
        if divisor(middle).entries[0] < 0:
            below = middle
        else:
            above = middle
    return above


def _where(part: Expr, symbols: Sequence[Variable], point: list[float]) -> str:
    at = {s: value for s, value in zip(symbols, point, strict=True) if s in part.free_symbols}
    places = ", ".join(f"{s.name} = {value:.6g}" for s, value in at.items())
    domains = ", ".join(f"{s.name} is {s.low:.6g} to {s.high:.6g}" for s in at)
    return f" at {places}, and {domains}" if at else ""


def _real(evaluator: Evaluator, point: list[float]) -> bool:
    try:
        return all(isinstance(value, mpmath.mpf) and mpmath.isfinite(value) for value in evaluator(point))
    except (ArithmeticError, TypeError, ValueError):
        return False


def _points(symbols: Sequence[Variable]) -> Iterator[list[float]]:
    """Corners of the domain, many where there are many, and points inside, the same each time."""
    yield from map(list, islice(product(*((s.low, s.high) for s in symbols)), CORNERS))
    chance = random.Random(0)  # noqa: S311 - no secret
    for _ in range(INSIDE):
        yield [_between(symbol, chance.random()) for symbol in symbols]


def _between(symbol: Variable, share: float) -> float:
    return (
        symbol.low * (symbol.high / symbol.low) ** share
        if symbol.logarithmic
        else (symbol.low + (symbol.high - symbol.low) * share)
    )
