"""Checks certificates of the elementary functions: in every cell the claimed bound is derived again, in balls.

What is read is the text of the generated module, which is never run. Four things are shown of each function: the
argument is reduced, with an error that is bounded; in exact arithmetic, the statements behind that are the polynomial
that they should be; it is so close to the function (its difference from Taylor's series, whose rest is bounded, in
exact coefficients); and the roundings of the written operations add up to so much. Assumed is IEEE 754 arithmetic, to
nearest, and nothing else.
"""

from __future__ import annotations

import ast
import math
from collections.abc import Iterator, Mapping
from fractions import Fraction
from functools import lru_cache
from typing import Any

from radartrack.verification.elementary.argument_reduction import (
    SATURATED,
    mantissa_of,
    reach_of,
    reduction_of_angles,
    reduction_of_exponents,
    require_angle,
    require_exponent,
)
from radartrack.verification.elementary.ball_arithmetic import (
    PRECISION,
    Ball,
    Refused,
    around,
    between,
    flint,
    half_ulp,
    nearest,
    point,
    ulp_at_least,
)
from radartrack.verification.elementary.elementary_text import PARTS_OF_BOTH, Text, number_of, polynomial_of
from radartrack.verification.elementary.rounded_sums import Cell, Form

TERMS = 26  # of Taylor's series
TINY = 2.0**-30  # below, a function is its argument but for less than a hundredth of an ulp
OF_TINY = 0.51
FUNCTIONS = ("sin", "cos", "exp", "expm1")


def confirmed(source: str, name: str, bits: int, trees: Mapping[str, str]) -> float:
    """The bound that a certificate proves, in units of the last place of the exact value.

    Args:
        source: the text of the generated module.
        name: of the function in double precision.
        bits: 53, or 24 for the function in single precision.
        trees: of every case how its interval is halved: a dot is a cell, a bar halves.

    Raises:
        Refused: the cells do not cover the domain, or a statement is none that can be followed.
    """
    text = read(source, name, bits)
    wanted = cases(text)
    if set(trees) != set(wanted):
        raise Refused(f"{name}: the cases are not those of the domain")
    return max(bound(text, case, low, high) for case, ends in wanted.items() for low, high in cells(ends, trees[case]))


def cells(ends: tuple[float, float], tree: str) -> Iterator[tuple[float, float]]:
    """The cells of a tree in preorder; halves meet in one number, so nothing is left out between them."""
    waiting = [ends]
    for letter in tree:
        if not waiting or letter not in ".|":
            raise Refused("a tree goes on after its end, or holds what is neither a dot nor a bar")
        low, high = waiting.pop()
        if letter == ".":
            yield low, high
        else:
            middle = (low + high) / 2
            waiting += [(middle, high), (low, middle)]
    if waiting:
        raise Refused("a tree ends before its cells cover the interval")


def bound(text: Text, case: str, low: float, high: float) -> float:
    """In one cell, in units of the last place."""
    flint().ctx.prec = PRECISION
    if text.name in PARTS_OF_BOTH:
        found = _of_angle(text, low, high)
    elif text.name == "exp":
        found = _of_exponential(text, low, high)
    else:
        found = _of_exponential_less_one(text, case, low, high)
    return float(found.upper()) * (1 + 1e-12)


@lru_cache(maxsize=16)
def read(source: str, name: str, bits: int) -> Text:
    """A function's statements, each of whose numbers has as many bits as the precision.

    Raises:
        Refused: it holds something else.
    """
    end = {53: "", 24: "_single"}[bits]
    tree = ast.parse(source)
    wanted = f"sin_and_cos{end}" if name in PARTS_OF_BOTH else f"{name}{end}"
    function = next((n for n in tree.body if isinstance(n, ast.FunctionDef) and n.name == wanted), None)
    if function is None:
        raise Refused(f"there is no function {wanted}")
    *lines, last = function.body[1:]
    if not isinstance(last, ast.Return) or not all(isinstance(line, ast.Assign) for line in lines):
        raise Refused(f"{wanted} holds what is no assignment")
    for node in ast.walk(function):
        if isinstance(node, ast.Constant) and isinstance(node.value, float):
            number = Fraction(node.value)
            if nearest(number, bits) != number:
                raise Refused(f"{wanted}: {node.value} has more than {bits} bits")
    statements = tuple((ast.unparse(line.targets[0]), line.value) for line in lines if isinstance(line, ast.Assign))
    results = tuple(last.value.elts) if isinstance(last.value, ast.Tuple) else (last.value,)
    if not all(isinstance(result, ast.expr) for result in results):
        raise Refused(f"{wanted} returns nothing")
    angle = _largest_angle(tree, bits)
    text = Text(name, bits, statements, results, angle)  # type: ignore[arg-type] # asserted above
    _require_alone(tree, name, end)
    (require_angle if name in PARTS_OF_BOTH else require_exponent)(text)
    return text


def cases(text: Text) -> dict[str, tuple[float, float]]:
    """The reduced arguments: intervals by what else they are told apart by."""
    reach = reach_of(text)
    if text.name in PARTS_OF_BOTH:  # odd and even functions of operations that are so too
        return {"": (0.0, reach)}
    if text.name == "exp":
        return {"": (-reach, reach)}
    whole = {str(k): (-reach, reach) for k in range(-SATURATED, SATURATED + 1) if k}
    return {"0-": (-reach, 0.0), "0+": (0.0, reach), **whole}


def _largest_angle(tree: ast.Module, bits: int) -> float:
    for node in tree.body:
        match node:
            case ast.Assign(targets=[ast.Tuple(elts=[ast.Name("LARGEST_ANGLE"), _])], value=ast.Tuple(elts=values)):
                return float(number_of(values[bits != 53]))
    raise Refused("there is no largest angle")


def _require_alone(tree: ast.Module, name: str, end: str) -> None:
    """A function of one of the two results returns that."""
    if name not in PARTS_OF_BOTH:
        return
    wanted = f"return sin_and_cos{end}(angle)[{int(name == 'cos')}]"
    function = next((n for n in tree.body if isinstance(n, ast.FunctionDef) and n.name == f"{name}{end}"), None)
    if function is None or [ast.unparse(line) for line in function.body[1:]] != [wanted]:
        raise Refused(f"{name}{end} is not one of sin_and_cos{end}")


def _of_angle(text: Text, low: float, high: float) -> Ball:
    """The reduced angle y in a cell; what y lacks is at most half its last place."""
    lost = reduction_of_angles(text)
    result, series = PARTS_OF_BOTH[text.name]
    if text.name == "sin" and high <= TINY:
        return point(OF_TINY) + lost
    y, half_last = between(low, high), half_ulp(point(high), text.bits)
    cell = Cell(text, {"y": Form(y), "y_low": Form(around(half_last))})
    names = [name for name, _ in text.statements]
    cell.follow("square", names[names.index(result) - 1])
    error = cell.before_rounding(text.value(result))
    square = y * y
    rest = abs(y) ** (2 * TERMS) / _factorial(2 * TERMS + 3)  # the first term that is left out
    if text.name == "sin":
        taylor = [Fraction((-1) ** (n + 1), _factorial(2 * n + 3)) for n in range(TERMS)]
        off = abs(y) ** 3 * _differs(text.value(series), "square", square, taylor, rest)
        beside, exact = half_last * y**4 / 24, y.sin()
    else:
        taylor = [Fraction((-1) ** n, _factorial(2 * n + 4)) for n in range(TERMS)]
        off = y**4 * _differs(text.value(series), "square", square, taylor, rest)
        beside, exact = half_last * abs(y) ** 3 / 6, y.cos()
    exact = exact + around(half_last)
    return point(0.5) + (error + off + beside + half_last**2) / ulp_at_least(exact, text.bits) + lost


def _of_exponential(text: Text, low: float, high: float) -> Ball:
    """2^k e^y for any k: the power of two is exact; where it is not, half of this bound and half an ulp are less."""
    y, half_last = between(low, high), half_ulp(point(max(-low, high)), text.bits)
    cell = Cell(text, {"rest": Form(y), "lost": Form(around(half_last))})
    cell.follow("square", "tail")
    error = cell.before_rounding(mantissa_of(text))
    error = error + _exponential_is_off(text, y, half_last) + reduction_of_exponents(text) * 3 / 2
    found = point(0.5) + error / ulp_at_least(y.exp() + around(half_last * 2), text.bits)
    if not found < 1:
        raise Refused("the bound of e^x is above one ulp, and subnormal numbers may have more")
    return found


def _of_exponential_less_one(text: Text, case: str, low: float, high: float) -> Ball:
    k = int(case.rstrip("+-"))
    if k == 0 and max(-low, high) <= TINY:
        return point(OF_TINY)
    y = between(low, high)
    half_last = half_ulp(point(max(-low, high)), text.bits) if k else point(0)
    scale = Fraction(2) ** k
    lost = Form(around(half_last)) if k else Form(point(0), {}, Fraction(0))
    cell = Cell(text, {"rest": Form(y), "lost": lost, "scale": Form(point(scale), {}, scale)})
    cell.follow("square", "tail")
    cell.follow("shifted", "lost_again")
    error = cell.before_rounding(text.value("near"))
    error = error + point(scale) * _exponential_is_off(text, y, half_last)
    if k:
        error = error + point(scale) * reduction_of_exponents(text) * 3 / 2
    if k == SATURATED:  # more doublings come last, when one is off already
        error = error + 1
    if k == -SATURATED:  # and fewer are taken for these
        error = error + 2 * point(scale)
    exact = point(scale) * (y.exp() + around(2 * half_last)) - 1 if k else y.expm1()
    return point(0.5) + error / ulp_at_least(exact, text.bits)


def _exponential_is_off(text: Text, y: Ball, half_last: Ball) -> Ball:
    """The polynomial, and what is left out of the product with what the reduced argument lacks."""
    taylor = [Fraction(1, _factorial(n + 3)) for n in range(TERMS)]
    rest = 2 * abs(y) ** TERMS / _factorial(TERMS + 3)
    cubic = abs(y) ** 3 * _differs(text.value("series"), "rest", y, taylor, rest)
    return cubic + half_last * (abs(y.expm1() - y) + half_last)


def _differs(node: ast.expr, variable: str, at: Ball, taylor: list[Fraction], rest: Ball) -> Ball:
    """By how much a polynomial may differ from a series of which these are the first coefficients."""
    series = flint().fmpq_poly([flint().fmpq(c.numerator, c.denominator) for c in taylor])
    difference = polynomial_of(node, variable) - series
    middle, radius = at.mid(), at.rad()
    return abs(_at(difference, middle)) + radius * abs(_at(difference.derivative(), at)) + rest


def _at(polynomial: Any, place: Ball) -> Ball:
    value = point(0)
    for coefficient in reversed(polynomial.coeffs()):
        value = value * place + flint().arb(coefficient)
    return value


def _factorial(n: int) -> int:
    return math.factorial(n)
