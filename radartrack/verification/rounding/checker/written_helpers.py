"""Errors of the functions that generated modules bring along, rests of series and a root, as they are written there.

Their statements are followed, piece by piece of the argument, by the same rules as all others. What is known of them
beside is which function they stand for: where its values lie, how steep it is, and what a series that ends leaves out.
"""

from __future__ import annotations

import ast
import math
import operator
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import Any

from radartrack.verification.rounding.checker.arithmetic import Box
from radartrack.verification.rounding.checker.function_rules import FUNCTIONS, magnitude
from radartrack.verification.rounding.checker.known_numbers import Number, Precision, Refused
from radartrack.verification.rounding.checker.sums.ball_ends import Ball

TINY, LITTLE, STEP = 2.0**-30, 2.0**-2, 2.0**0.125  # pieces: squares underflow, all that is little, then in this ratio
NEWTON = "c - ((4.0 * c ** 2 - 3.0) * c - x) / (12.0 * c ** 2 - 3.0)"  # the step that the rule of a root is of
LEAST, OVERLAP = 2.0**-200, 1e-5  # of an argument: its least size, and what pieces share
WHOLE: dict[type[ast.operator], Callable[[int, int], int]] = {
    ast.Add: operator.add,
    ast.Sub: operator.sub,
    ast.Mult: operator.mul,
    ast.Mod: operator.mod,
}
Followed = Number | int | bool | None


@dataclass(frozen=True)
class Piece:
    """A helper on a piece of its argument, which is exact.

    Attributes:
        low: of the value over a power of the argument's size, for every power that is looked at.
        high: likewise.
        relative: error of a computed value by itself, in units of rounding; None where it may vanish.
        error: the same as it is.
        slope: at most |x f'(x)|.
        condition: at most |x f'(x)/f(x)|.
    """

    low: tuple[Ball, ...]
    high: tuple[Ball, ...]
    relative: Ball | None
    error: Ball
    slope: Ball
    condition: Ball | None


@dataclass(frozen=True)
class Known:
    """The function that a helper stands for.

    Attributes:
        ends: the ends of f(x)/|x|^k, of a size of x from one point to another.
        slope: at most |x f'(x)|, likewise.
        condition: at most |x f'(x)/f(x)| by the order; None where f may vanish.
        powers: which k are looked at; the first is that of `left_out`.
        left_out: at most what its series leaves out over |x|^k, of a size of the argument.
        turn: where it is written in another way, from its order.
        signs: the signs that its argument may have.
    """

    ends: Callable[[Ball, Ball, int, int], tuple[Ball, Ball]]
    slope: Callable[[Ball, Ball, int], Ball]
    condition: Callable[[int], float | None]
    powers: Callable[[int], tuple[int, ...]]
    left_out: Callable[[Ball, int], Ball]
    turn: Callable[[int], float]
    signs: tuple[int, ...]


def helped(box: Box, function: ast.FunctionDef, x: Number | None, order: int) -> Number:
    """What a helper makes of an argument that has an error of its own.

    Args:
        box: where the argument lies.
        function: the helper as its module defines it.
        x: its argument.
        order: its second argument, 0 if it takes none.

    Raises:
        Refused: a statement of the helper cannot be followed, or the argument may have a sign it is not known for.
    """
    known, text = KNOWN[function.name], ast.unparse(function)
    if x is not None and (x.relative is None or x.sign not in known.signs):
        raise Refused(f"an argument of {function.name} of either sign")
    if x is None:
        pieces, off = [_piece(text, order, 0, 0.0, 0.0, box.precision)], box.ball(0)
    else:
        ends = float(x.low.exp().lower()), float(x.high.exp().upper())
        pieces = [_piece(text, order, x.sign or 1, *piece, box.precision) for piece in _cut(*ends)]
        off = -(1 - _beside(box, x)).log() / box.unit
    error = max((p.error + p.slope * off for p in pieces), key=_upper).upper()
    each = [_both(box, p, off) for p in pieces]
    relative = max((one for one in each if one is not None), key=_upper).upper() if None not in each else None
    ranges = [(min(p.low[n] for p in pieces), max(p.high[n] for p in pieces)) for n in range(len(pieces[0].low))]
    powers = known.powers(order)
    if relative is None:
        return box.between(*ranges[powers.index(0)], None, error)
    first = min(range(len(ranges)), key=lambda n: _upper(abs(ranges[n][1] / ranges[n][0]).log().__abs__()))
    rest = box.between(*ranges[first], relative, error)
    if x is None:
        return rest
    box.follows(next(iter(rest.exactly)), x, lambda low, high: known.ends(low, high, order, powers[first]))
    for _ in range(powers[first]):
        rest = _not_zero(box.multiply(rest, magnitude(box, box.without_error(x)), 0.0))
    return rest


def _not_zero(number: Number | None) -> Number:
    if number is None:
        raise Refused("a helper is zero")
    return number


def _beside(box: Box, x: Number) -> Ball:
    """How far from its argument a helper is asked, as a share: no farther than pieces overlap."""
    part = box.unit * x.relative
    if not part < OVERLAP:
        raise Refused("an argument of a helper that is too far off")
    return part


def _both(box: Box, piece: Piece, off: Ball) -> Ball | None:
    """A relative error of what is computed, and one of the argument."""
    if piece.relative is None or piece.condition is None:
        return None
    moved = (piece.condition * off * box.unit).expm1() / box.unit
    return (piece.relative + moved + box.unit * piece.relative * moved).upper()


def _upper(ball: Ball) -> float:
    value = float(ball.upper())
    return math.inf if math.isnan(value) else value


def _cut(low: float, high: float) -> list[tuple[float, float]]:
    """Pieces of a fixed grid that cover an interval; the first has all that is little."""
    if low < LEAST:
        raise Refused("an argument of a helper that may vanish")
    first = math.floor(math.log(max(low, LITTLE) / LITTLE) / math.log(STEP) - 1e-9)
    last = math.ceil(math.log(max(high, LITTLE) / LITTLE) / math.log(STEP) + 1e-9)
    pieces = [(LITTLE * STEP**n * (1 - OVERLAP), LITTLE * STEP ** (n + 1) * (1 + OVERLAP)) for n in range(first, last)]
    if low < LITTLE:
        pieces.insert(0, (min(TINY, low), LITTLE * (1 + OVERLAP)))
    if low < TINY:
        pieces[0] = TINY / 2, pieces[0][1]
        pieces.insert(0, (2.0 ** (math.floor(math.log2(low)) - 1), TINY))
    return pieces


@lru_cache(maxsize=4096)
def _piece(text: str, order: int, sign: int, low: float, high: float, precision: Precision) -> Piece:
    import flint  # noqa: PLC0415

    (function,) = (node for node in ast.parse(text).body if isinstance(node, ast.FunctionDef))
    known, turn = KNOWN[function.name], KNOWN[function.name].turn(order)
    powers, ends = known.powers(order), (flint.arb(low), flint.arb(high))
    ranges = [known.ends(*ends, order, power) for power in powers]
    lost = known.left_out(ends[1], order) / flint.arb(2.0**-precision.bits)
    errors: list[Any] = []
    relatives: list[Any] = []
    for is_below in [True] * (low < turn) + [False] * (high >= turn):
        box = Box(flint, precision, most_value=1)
        there = [min(end, turn) if is_below else max(end, turn) for end in (low, high)]
        lowest, highest = (flint.arb(end).log() for end in there)
        x = box.argument(sign, lowest, highest) if sign else None
        found = _Follower(box, order, x, is_below=is_below).result(function)
        left = lost if is_below else 0 * lost
        least = min(abs(ranges[0][0]), abs(ranges[0][1])) if ranges[0][0] * ranges[0][1] > 0 else None
        errors.append((box.bounds(found.error)[1].exp() if found.error else 0) + left * ends[1] ** powers[0])
        relatives.append(None if found.relative is None or least is None else found.relative + left / least)
    slope, size = known.slope(*ends, order), ranges[powers.index(0)]
    condition = known.condition(order)
    if condition is None and size[0] * size[1] > 0:
        condition = slope / min(abs(size[0]), abs(size[1]))
    sure = condition is not None and all(one is not None and one.is_finite() for one in relatives)
    return Piece(
        tuple(one[0].lower() for one in ranges),
        tuple(one[1].upper() for one in ranges),
        max(relatives, key=_upper).upper() if sure else None,
        max(errors, key=_upper).upper(),
        slope.upper(),
        flint.arb(condition).upper() if sure else None,
    )


class _Follower:
    """The statements of a helper on a piece, where its conditions are known.

    Args:
        box: where the argument lies.
        order: the second argument.
        x: the first.
        is_below: whether it is below where the helper turns to another way.
    """

    def __init__(self, box: Box, order: int, x: Number | None, *, is_below: bool) -> None:
        self.box, self.is_below = box, is_below
        self.names: dict[str, Any] = {"x": x, "order": order}

    def result(self, function: ast.FunctionDef) -> Number:
        """What it returns."""
        *body, last = function.body
        if not isinstance(last, ast.Return) or last.value is None:
            raise Refused(f"{function.name} does not end in what it returns")
        self._statements(body)
        found = self._newton(last.value) if "c" in self.names else self._number(last.value)
        if found is None:
            raise Refused(f"{function.name} is zero")
        return found

    def _statements(self, statements: list[ast.stmt]) -> None:
        for statement in statements:
            match statement:
                case ast.Expr(value=ast.Constant(value=str())):
                    continue
                case ast.For(target=ast.Name(id=name), iter=ast.Call(func=ast.Name(id="range"), args=ends), body=body):
                    for number in range(*(self._int(end) for end in ends)):
                        self.names[name] = number
                        self._statements(body)
                case ast.Assign(targets=[ast.Tuple(elts=targets)], value=value):
                    for target, found in zip(targets, self._several(value), strict=True):
                        self.names[ast.unparse(target)] = found
                case ast.Assign(targets=[ast.Name(id=name)], value=value):
                    self.names[name] = self._value(value)
                case ast.AugAssign(target=ast.Name(id=name) as target, op=sign, value=value):
                    self.names[name] = self._value(ast.BinOp(target, sign, value))
                case _:
                    raise Refused(f"there is no rule for {ast.unparse(statement)[:60]}")

    def _several(self, node: ast.expr) -> list[Followed]:
        match node:
            case ast.IfExp(test=test, body=first, orelse=second):
                return self._several(first if self._int(test) else second)
            case ast.Tuple(elts=parts):
                return [self._value(part) for part in parts]
        raise Refused(f"there is no rule for {ast.unparse(node)[:60]}")

    def _int(self, node: ast.expr) -> int:
        found = self._value(node)
        if not isinstance(found, int):
            raise Refused(f"{ast.unparse(node)} is no whole number")
        return found

    def _number(self, node: ast.expr) -> Number | None:
        found = self._value(node)
        return self.box.constant(found) if isinstance(found, int) else found

    def _value(self, node: ast.expr) -> Followed:
        match node:
            case ast.Constant(value=int() as number):
                return number
            case ast.Constant(value=float() as number):
                return self.box.constant(number)
            case ast.Name(id=name) if name in self.names:
                known: Followed = self.names[name]
                return known
            case ast.UnaryOp(op=ast.USub(), operand=ast.Constant(value=int() as number)):
                return -number
            case ast.Compare():
                return self.is_below
            case ast.BinOp(left=left, op=sign, right=right):
                return self._operation(self._value(left), sign, self._value(right))
            case ast.Call(func=ast.Attribute(attr=name), args=arguments):
                return self._called(name, arguments)
        raise Refused(f"there is no rule for {ast.unparse(node)[:60]}")

    def _operation(self, a: Followed, sign: ast.operator, b: Followed) -> Followed:
        box = self.box
        if isinstance(a, int) and isinstance(b, int):
            return WHOLE[type(sign)](a, b)
        if isinstance(sign, ast.Pow) and b == 2 and not isinstance(a, int):
            return box.squared(a)
        a, b = (box.constant(one) if isinstance(one, int) else one for one in (a, b))
        match sign:
            case ast.Mult():
                return box.multiply(a, b)
            case ast.Add():
                return box.add(a, b)
            case ast.Sub():
                return box.add(a, box.by_power_of_two(b, -1.0))
            case ast.Div():
                return box.divide(a, b)
        raise Refused("there is no rule for an operation of a helper")

    def _called(self, name: str, arguments: list[ast.expr]) -> Followed:
        match name:
            case "where":
                is_first = self.is_below == (not _is_above(arguments[0]))
                return self._value(arguments[1 if is_first else 2])
            case "ones_like":
                return self.box.constant(1)
            case "zeros_like":
                return None
            case "maximum" | "minimum":
                return self._value(arguments[int(self.is_below == (name == "maximum"))])
            case "abs":
                return self._value(arguments[0])
        a = self._number(arguments[0])
        if name in FUNCTIONS:
            return FUNCTIONS[name](self.box, a)
        if name not in SMOOTH:
            raise Refused(f"there is no rule for {name}")
        return self._smooth(name, a)

    def _smooth(self, name: str, a: Number | None) -> Number | None:
        """A function of an argument that is known well: its own error, and its slope by the argument's."""
        if a is None:
            raise Refused(f"{name} of zero")
        box, (value, slope) = self.box, SMOOTH[name]
        off = box.bounds(a.error)[1].exp().upper() if a.error else box.ball(0)
        least = a.low.exp() if a.sign else -a.high.exp()
        at = (a.sign or 1) * least.union(a.high.exp())
        found, ulps = value(at), box.precision.ulps.get(name, 4 * box.precision.ulps["hypot"])
        farther = (at - box.unit * off).union(at + box.unit * off)
        moved = box.ball(0) if a.is_exact else abs(slope(farther)).upper() * off
        error = (moved + (abs(found).upper() + box.unit * moved) * 2 * ulps).upper()
        relative = (error / abs(found).lower()).upper() if abs(found) > 0 else None
        return box.between(found.lower(), found.upper(), relative, error)

    def _newton(self, node: ast.expr) -> Number:
        """A step from where a root was found: what is left of its error is a square, what counts is rounding."""
        box, c = self.box, self.names["c"]
        if ast.unparse(node) != NEWTON or not isinstance(node, ast.BinOp) or not isinstance(node.right, ast.BinOp):
            raise Refused("a step of Newton's that there is no rule for")
        off = box.small(c.relative) * c.high.exp()
        steep = 12 * c.high.exp() ** 2 - 3
        self.names["c"] = box.without_error(c)
        above, below = self._number(node.right.left), self._number(node.right.right)
        if above is None:
            raise Refused("a root that is exact")
        near = box.between(
            -(off * steep * 2).upper(), (off * steep * 2).upper(), None, box.bounds(above.error)[1].exp()
        )
        found = box.add(self.names["c"], box.by_power_of_two(box.divide(near, below), -1.0))
        if found is None:
            raise Refused("a root that is zero")
        square = (off**2 * 12 * c.high.exp() / (12 * c.low.exp() ** 2 - 3) / c.low.exp() / box.unit).upper()
        total = box.bounds(found.error)[1].exp() / c.low.exp() + square
        return replace(found, relative=total.upper(), error={(): (total * c.high.exp()).upper()})


def _is_above(node: ast.expr) -> bool:
    return isinstance(node, ast.Compare) and isinstance(node.ops[0], ast.Gt)


def _rest(low: Ball, high: Ball, order: int, power: int) -> tuple[Ball, Ball]:
    """Σ xⁿ/n! from an order on over |x|^k, of x < 0: it falls as |x| grows where k is the order, else it grows."""
    ends = [_rest_at(end, order, power) for end in ((high, low) if power == order else (low, high))]
    return (ends[0].lower(), ends[1].upper()) if order % 2 == 0 else (-ends[1].upper(), -ends[0].lower())


def _rest_at(d: Ball, order: int, power: int) -> Ball:
    if d < 1:
        total, term = 0 * d, 1 / _factorial(d, order)
        for n in range(order, order + 30):
            total, term = total + term, -term * d / (n + 1)
        return total.union(total + term) * d ** (order - power)
    total = (-d).exp() - sum(((-d) ** n / _factorial(d, n) for n in range(order)), 0 * d)
    return abs(total) / d**power


def _factorial(like: Ball, n: int) -> Ball:
    return 0 * like + math.factorial(n)


def _stumpff(low: Ball, high: Ball, order: int, power: int = 0) -> tuple[Ball, Ball]:
    """1/n! − x²/(n+2)! + …, which falls from n = 2 on: x^n c_n is the integral of x^(n-1) c_(n-1); c_2 falls to 2π."""
    del power
    if not high < 6.28:
        raise Refused("a whole turn and more")
    if order < 2:
        whole = low.union(high)
        value = (
            whole.cos()
            if order == 0
            else whole.sin() / whole
            if low > 0.1
            else 1 - whole**2 / 6 * (0 * low).union(1 + 0 * low)
        )
        return value.lower(), value.upper()
    return _stumpff_at(high, order).lower(), _stumpff_at(low, order).upper()


def _stumpff_at(x: Ball, order: int) -> Ball:
    total, term = 0 * x, 1 / _factorial(x, order)
    for n in range(order, order + 60, 2):
        total, term = total + term, -term * x * x / ((n + 1) * (n + 2))
    return total.union(total + term)


def _slope_of_stumpff(low: Ball, high: Ball, order: int) -> Ball:
    """|x c_n'| = |c_(n-1) − n c_n|, and no more than x²/(n+1)! times what its series begins with."""
    before, here = (_stumpff(low, high, n) for n in (order - 1, order))
    by_ends = max(abs(before[1] - order * here[0]), abs(before[0] - order * here[1]), key=_upper)
    return min(by_ends, 2 * high**2 / _factorial(low, order + 2) if high < 2 else by_ends, key=_upper)


def _third(low: Ball, high: Ball, order: int, power: int) -> tuple[Ball, Ball]:
    """The positive root c of 4c³ − 3c = x, which grows."""
    del order, power
    ends = [(end.acosh() / 3).cosh() if end > 1 else (end.acos() / 3).cos() for end in (low, high)]
    return ends[0].lower(), ends[1].upper()


KNOWN: Mapping[str, Known] = {
    "_remainder": Known(
        _rest,
        lambda low, high, n: n * max(map(abs, _rest(low, high, n, 0)), key=_upper),  # as |f|/|x|^n falls
        float,
        lambda n: (n, n - 1, 0),
        lambda d, n: d**31 / _factorial(d, n + 31),
        float,
        (-1,),
    ),
    "_stumpff": Known(
        _stumpff,
        _slope_of_stumpff,
        lambda _: None,
        lambda _: (0,),
        lambda d, n: d**32 / _factorial(d, n + 32),
        float,
        (1, -1, 0),
    ),
    "_third": Known(
        _third,
        lambda low, high, _: _third(low, high, 0, 0)[1] / 3,  # (4c² − 3)/(12c² − 3) of c
        lambda _: 1 / 3,
        lambda _: (0,),
        lambda d, _: 0 * d,
        lambda _: 1.0,
        (1,),
    ),
}


def _by_ends(function: Callable[[Ball], Ball], least: float, most: float) -> Callable[[Ball], Ball]:
    """Of one that grows or falls, where it is defined."""

    def ends(x: Ball) -> Ball:
        first, last = (function(min(max(end, least + 0 * end), most + 0 * end)) for end in (x.lower(), x.upper()))
        return first.union(last)

    return ends


SMOOTH: Mapping[str, tuple[Callable[[Ball], Ball], Callable[[Ball], Ball]]] = {  # and their derivatives
    "sin": (lambda x: x.sin(), lambda x: x.cos()),
    "cos": (lambda x: x.cos(), lambda x: x.sin()),
    "cosh": (lambda x: abs(x).cosh(), lambda x: x.sinh()),
    "arccosh": (_by_ends(lambda x: x.acosh(), 1.0, math.inf), lambda x: 1 / (x * x - 1).sqrt()),
    "arccos": (_by_ends(lambda x: x.acos(), -1.0, 1.0), lambda x: 1 / (1 - x * x).sqrt()),
}
