"""Whether an argument is reduced as it should be, and the error that this leaves."""

from __future__ import annotations

import ast
import math
from collections.abc import Mapping
from fractions import Fraction
from functools import lru_cache

from radartrack.verification.elementary.ball_arithmetic import PRECISION, Ball, Refused, flint, nearest, point
from radartrack.verification.elementary.elementary_text import (
    PARTS_OF_BOTH,
    Text,
    grid_of,
    number_of,
    require_exactly,
    require_shape,
)

SHAPES = {
    "angle": [
        "x = chosen(abs(angle) <= L, angle, NAN)",
        "quarters = (x * C + C) - C",
        "rest = x - quarters * C",
    ],
    "exponent": [
        "not_huge = chosen(x > C, C, x)",
        "given = chosen(not_huge < C, C, not_huge)",
        "doublings = (given * C + C) - C",
        "high = given - doublings * C",
        "low = doublings * C",
        "rest = high - low",
        "lost = (high - rest) - low",
    ],
}
SATURATED = 64


def require_angle(text: Text) -> None:
    """The reduction is the one of which the bound speaks, its products and differences are exact, signs are right."""
    parts = _parts(text)
    shape = list(SHAPES["angle"])
    rest, low = "rest", ""
    for n in range(2, len(parts)):
        now = f"rest_{n}"
        lost = f"({rest} - {now} - part_{n})" if low else f"{rest} - {now} - part_{n}"
        shape += [f"part_{n} = quarters * C", f"{now} = {rest} - part_{n}", f"low_{n} = {low}{lost}"]
        rest, low = now, f"low_{n} + "
    shape += [f"low = {low.removesuffix(' + ')} - quarters * C", f"y = {rest} + low", f"y_low = {rest} - y + low"]
    require_shape(text, shape)
    _require_whole(text, "quarters", text.largest_angle)
    bits, most = text.bits, _most_quarters(text)
    for n, part in enumerate(map(number_of, parts[:-1])):
        grid = grid_of(part)
        # A multiple is exact. From the angle, which is a multiple of 2^-bits, it leaves less than one; later ones are
        # either smaller than what they are taken from, or both are multiples of the grid and few of them.
        largest = most * abs(part)
        if not largest <= grid * 2**bits:
            raise Refused("a multiple of a part of π/2 that is rounded")
        if not (grid >= Fraction(1, 2**bits) if n == 0 else 2 * largest <= grid * 2**bits):
            raise Refused("a difference of multiples of parts of π/2 that is not kept")
    _require_quadrants(text)
    require_exactly(text, text.value(PARTS_OF_BOTH[text.name][0]), text.name)


def _require_quadrants(text: Text) -> None:
    """Which of sine and cosine is taken with which sign, for every number of right angles, with 3 and 5 for them.

    Numbers of right angles are whole and exact, and so is their rounded quarter: what is left depends
    on no more than the rest by four, but for a tie, which is one at every fourth and rounds to an even quarter.
    """
    names = [name for name, _ in text.statements]
    last = [*text.statements[names.index("cosine_of_y") + 1 :]]
    expected = {0: (3, 5), 1: (5, -3), 2: (-3, -5), 3: (-5, 3)}
    if len(text.results) != 2:
        raise Refused("there are not two results")
    most = _most_quarters(text)
    for k in (*range(-16, 17), *range(most - 8, most + 1), *range(-most, 9 - most)):
        values = {"quarters": Fraction(k), "sine_of_y": Fraction(3), "cosine_of_y": Fraction(5)}
        for name, value in last:
            values[name] = _evaluated(value, values, text.bits)
        if [_evaluated(result, values, text.bits) for result in text.results] != [*map(Fraction, expected[k % 4])]:
            raise Refused(f"sine and cosine of {k} right angles are not what they should be")


def _evaluated(node: ast.expr, values: Mapping[str, Fraction], bits: int) -> Fraction:
    """An expression of numbers as it is computed."""
    match node:
        case ast.Constant(value=float(value)):
            return Fraction(value)
        case ast.Name(id=name) if name in values:
            return values[name]
        case ast.UnaryOp(op=ast.USub(), operand=operand):
            return -_evaluated(operand, values, bits)
        case ast.BinOp(left, operation, right):
            a, b = _evaluated(left, values, bits), _evaluated(right, values, bits)
            match operation:
                case ast.Add():
                    return nearest(a + b, bits)
                case ast.Sub():
                    return nearest(a - b, bits)
                case ast.Mult():
                    return nearest(a * b, bits)
        case ast.Call(func=ast.Name("abs"), args=[inside]):
            return abs(_evaluated(inside, values, bits))
        case ast.Call(func=ast.Name("chosen"), args=[ast.Compare(left, [ast.Eq()], [right]), first, second]):
            equal = _evaluated(left, values, bits) == _evaluated(right, values, bits)
            return _evaluated(first if equal else second, values, bits)
    raise Refused(f"{ast.unparse(node)} cannot be followed")


def require_exponent(text: Text) -> None:
    """The reduction is the one of which the bound speaks, powers of two are in range, and results are put together."""
    require_shape(text, SHAPES["exponent"])
    high, low = limits(text)
    largest = {53: (709.79, -745.14), 24: (88.73, -103.98)}[text.bits]  # beyond, e^x is infinite and zero
    if not (high >= largest[0] and low <= largest[1]):
        raise Refused("exponents are limited to fewer than have a value")
    _require_whole(text, "doublings", max(high, -low))
    first, _ = _ln_two(text)
    grid, most = grid_of(first), _most_doublings(text)
    if not (most * first <= grid * 2**text.bits and grid >= Fraction(1, 2 ** (text.bits + 1))):
        raise Refused("a multiple of ln 2 that is rounded")
    whole, limit = whole_of(text, "doublings"), float(SATURATED)
    shapes = {
        "exp": {"half": f"doublings * 0.5 + {whole!r} - {whole!r}"},
        "expm1": {
            "not_many": f"chosen(doublings > {limit}, {limit}, doublings)",
            "few": f"chosen(not_many < -{limit}, -{limit}, not_many)",
            "scale": "power_of_two(few)",
            "shifted": "scale - 1.0",
        },
    }[text.name]
    result = {
        "exp": "(1.0 + (rest + (half_square + tail))) * power_of_two(half) * power_of_two(doublings - half)",
        "expm1": "near * power_of_two(doublings - not_many)",
    }[text.name]
    if any(ast.unparse(text.value(name)) != shape for name, shape in shapes.items()):
        raise Refused(f"{text.name}: doublings are not counted as they should be")
    if [ast.unparse(one) for one in text.results] != [result]:
        raise Refused(f"{text.name} returns something else")
    require_exactly(text, mantissa_of(text) if text.name == "exp" else text.value("near"), text.name)


def _require_whole(text: Text, name: str, largest: float) -> None:
    """It is the quotient by the step, rounded to the nearest whole number but for the rounding of the quotient."""
    whole_of(text, name)
    match text.value(name):
        case ast.BinOp(ast.BinOp(ast.BinOp(_, ast.Mult(), factor), _, _), _, _):
            inverse = flint().arb.pi() / 2 if name == "quarters" else flint().arb(2).log()
            if not abs(point(number_of(factor)) * inverse - 1) < 2 * point(text.unit):
                raise Refused(f"{name} is not counted by the inverse")
            if not largest * float(number_of(factor)) < 2.0 ** (text.bits - 3):
                raise Refused(f"{name} may be more than whole numbers are exact")


def whole_of(text: Text, name: str) -> float:
    """What is added to leave a whole number, and taken off."""
    match text.value(name):
        case ast.BinOp(ast.BinOp(ast.BinOp(_, ast.Mult(), _), ast.Add(), first), ast.Sub(), second):
            if number_of(first) == number_of(second) == Fraction(3, 2) * 2 ** (text.bits - 1):
                return float(number_of(first))
    raise Refused(f"{name} is not rounded to a whole number")


def reach_of(text: Text) -> float:
    """A number that no reduced argument is above."""
    if text.name in PARTS_OF_BOTH:
        largest, step = text.largest_angle, math.pi / 2
    else:
        largest, step = max(map(abs, limits(text))), math.log(2)
    return step / 2 + 4 * step * (largest / step + 1) * float(text.unit)


@lru_cache(maxsize=8)
def reduction_of_angles(text: Text) -> Ball:
    """The error that the reduction leaves, in units of the last place of the sine or cosine."""
    flint().ctx.prec = PRECISION
    half_pi, unit = flint().arb.pi() / 2, point(text.unit)
    parts = [number_of(value) for value in _parts(text)]
    off = abs(half_pi - sum(map(point, parts), point(0)))
    worst = point(0)
    for k in range(1, _most_quarters(text) + 1):
        exact = k * half_pi
        middle = Fraction(float(exact)) if text.bits == 53 else nearest(Fraction(float(exact)), text.bits)
        step = _step(middle, text.bits)
        distance = min(abs(point(middle + n * step) - exact).lower() for n in (-1, 0, 1))
        last = k * abs(point(parts[-1]))
        if not 4 * last < distance:
            raise Refused("an angle so near a right one that what is kept of it is larger than the rest")
        error = (k * off + 2 * unit * last) / distance + 8 * unit * unit
        worst = error if float(error.upper()) > float(worst.upper()) else worst
    return worst * point(1.2) / unit


def _step(value: Fraction, bits: int) -> Fraction:
    exponent = math.frexp(float(value))[1]
    return Fraction(2) ** (exponent - bits)


def _most_quarters(text: Text) -> int:
    return math.ceil(text.largest_angle * 2 / math.pi + 0.5)


def _parts(text: Text) -> list[ast.expr]:
    """Of π/2, as the statements take them."""
    names = [name for name, _ in text.statements]
    found = []
    for _, value in text.statements[: names.index("y")]:
        for node in ast.walk(value):
            match node:
                case ast.BinOp(ast.Name("quarters"), ast.Mult(), factor):
                    found.append(factor)
    return found


@lru_cache(maxsize=8)
def reduction_of_exponents(text: Text) -> Ball:
    """Of the reduced argument, in its own unit."""
    flint().ctx.prec = PRECISION
    first, second = _ln_two(text)
    most, unit = _most_doublings(text), point(text.unit)
    off = abs(flint().arb(2).log() - point(first) - point(second))
    return most * off + 5 * unit * most * abs(point(second))


def _ln_two(text: Text) -> tuple[Fraction, Fraction]:
    match text.value("high"), text.value("low"):
        case ast.BinOp(_, _, ast.BinOp(_, _, first)), ast.BinOp(_, _, second):
            return number_of(first), number_of(second)
    raise Refused("ln 2 is not taken in two parts")


def limits(text: Text) -> tuple[float, float]:
    """The largest and the smallest exponent."""
    found = []
    for name in ("not_huge", "given"):
        match text.value(name):
            case ast.Call(args=[ast.Compare(_, _, [limit]), same, _]):
                if number_of(limit) != number_of(same):
                    raise Refused("an exponent is not held at the limit that it exceeds")
                found.append(float(number_of(limit)))
    if len(found) != 2:
        raise Refused("exponents are not limited")
    return found[0], found[1]


def _most_doublings(text: Text) -> int:
    return math.ceil(max(map(abs, limits(text))) / math.log(2) + 0.5)


def mantissa_of(text: Text) -> ast.expr:
    """What is multiplied by powers of two to give e^x."""
    match text.results[-1]:
        case ast.BinOp(ast.BinOp(mantissa, ast.Mult(), ast.Call()), ast.Mult(), ast.Call()):
            return mantissa
    raise Refused("e^x is no number times two powers of two")
