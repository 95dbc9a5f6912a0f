"""Whether an approximation is as good as a paper says: the largest error over a domain, searched and then proved.

The search can only find an error that is too large; that none is, is proved with intervals over boxes that are halved
until each is small enough, or left open when there are too many: how many is no question of the machine's speed.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from itertools import islice, product
from types import MappingProxyType
from typing import Any

from mpmath import iv

from radartrack.derive import symbolic as sp
from radartrack.derive.checking.comparing.counterexample import Relative, Worst, worst_over_domain
from radartrack.derive.checking.comparing.question_domain import Domain
from radartrack.derive.evaluation.points import Point
from radartrack.derive.language.model_outputs import parts
from radartrack.derive.language.variable import Variable
from radartrack.derive.symbolic import Expr

CORNERS = 256
MOST_PARTS = 400_000  # of formulas over boxes: some five seconds of mpmath's intervals
Interval = Any
_FUNCTIONS: Mapping[type[Expr], Callable[[Interval], Interval]] = MappingProxyType(
    {sp.cos: iv.cos, sp.sin: iv.sin, sp.exp: iv.exp, sp.log: iv.log, sp.tan: iv.tan}
)


def largest_error(relative: Relative, domain: Domain) -> Worst:
    """The largest error that is found: at the corners, inside, and from the worst point along each symbol."""
    corners = islice(product(*((symbol.low, symbol.high) for symbol in domain.symbols)), CORNERS)
    points: list[Point] = [dict(zip((s.name for s in domain.symbols), corner, strict=True)) for corner in corners]
    points = [point for point in (*points, *domain.round(), *domain.ordinary(1)) if domain.contains(point)]
    found = [relative.at(point) for point in points]
    start = max(found, key=lambda one: one.relative, default=None)
    return worst_over_domain(relative, domain, start.point) if start else Worst(0.0, {})


def proved_within(error: Expr, bound: float, symbols: Sequence[Variable], most: int = MOST_PARTS) -> bool:
    """Whether an error is proved to stay within a bound over a domain; False says nothing."""
    shortened = _shortened(error)
    used = [symbol for symbol in symbols if symbol in shortened.free_symbols]
    forms = [shortened]
    if error.free_symbols == shortened.free_symbols:
        forms.append(error)  # it may be narrow where the other is not
    waiting = [tuple((symbol.low, symbol.high) for symbol in used)]
    size = sum(1 for form in (*forms, shortened) for _ in parts(form))
    boxes = 0
    while waiting:
        boxes += 1
        if boxes * size > most:
            return False
        box = waiting.pop()
        try:
            values = [value for form in forms if (value := _value(form, used, box)) is not None]
            if any(value.a >= -bound and value.b <= bound for value in values):
                continue
            middle = _value(forms[0], used, [(_middle(*ends),) * 2 for ends in box])
        except KeyError:  # a function without intervals here
            return False
        if not box or (middle is not None and (middle.a > bound or middle.b < -bound)):
            return False
        waiting += _halves(box)
    return True


def _shortened(error: Expr) -> Expr:
    return sp.factor(error) if error.atoms(sp.Function) else sp.cancel(sp.together(error))


def _value(expression: Expr, symbols: Sequence[Variable], box: Sequence[tuple[float, float]]) -> Interval | None:
    """An interval that holds all values over a box; None where there may be none."""
    try:
        return _over(expression, {s: iv.mpf(ends) for s, ends in zip(symbols, box, strict=True)}, {})
    except (ArithmeticError, ValueError):
        return None


def _middle(low: float, high: float) -> float:
    return (low * high) ** 0.5 if low > 0 else (low + high) / 2


def _halves(box: tuple[tuple[float, float], ...]) -> list[tuple[tuple[float, float], ...]]:
    """Two boxes, halved where it is longest for its size."""
    place = max(range(len(box)), key=lambda at: (box[at][1] - box[at][0]) / max(map(abs, box[at])))
    low, high = box[place]
    middle = _middle(low, high)
    return [(*box[:place], ends, *box[place + 1 :]) for ends in ((low, middle), (middle, high))]


def _over(expression: Expr, box: Mapping[Expr, Interval], known: dict[Expr, Interval]) -> Interval:
    """An interval that holds all values over a box."""
    if expression not in known:
        known[expression] = _made(expression, box, known)
    return known[expression]


def _made(expression: Expr, box: Mapping[Expr, Interval], known: dict[Expr, Interval]) -> Interval:
    if expression in box:
        return box[expression]
    if isinstance(expression, sp.Rational):
        return iv.mpf(int(expression.p)) / int(expression.q)
    if expression == sp.pi:
        return iv.pi
    arguments = [_over(argument, box, known) for argument in expression.args]
    if isinstance(expression, sp.Add):
        return sum(arguments, iv.mpf(0))
    if isinstance(expression, sp.Mul):
        total = iv.mpf(1)
        for argument in arguments:
            total = total * argument
        return total
    if isinstance(expression, sp.Pow) and isinstance(expression.exp, sp.Rational):
        return _power(arguments[0], expression.exp)
    return _FUNCTIONS[expression.func](arguments[0])


def _power(base: Interval, exponent: Expr) -> Interval:
    if exponent.q == 1:
        return base ** int(exponent.p)
    if base.a < 0:
        raise ValueError("a root of what may be negative")
    root = iv.sqrt(base) if exponent.q == 2 else iv.exp(iv.log(base) / int(exponent.q))
    return root ** int(exponent.p)
