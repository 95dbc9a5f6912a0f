"""Sine, cosine, e^x and e^x − 1 as statements without a branch, so that compilers compute several at once.

An argument is reduced to a small one by a multiple of π/2 or ln 2 (Cody & Waite, Software Manual for the Elementary
Functions, 1980), whose last bits are kept beside it; then come polynomials. Nothing is assumed of the order in which a
processor rounds but IEEE 754 in the type's own precision, without products and sums in one rounding.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Protocol

from radartrack.derive.elementary import coefficients
from radartrack.derive.elementary.precision import Precision

SATURATED = 64.0  # binary logarithm of e^x above which 1 less is nothing, and below minus which e^x is
ARGUMENT = "x"


class Dialect(Protocol):
    """How a language writes what languages write differently."""

    def number(self, value: float) -> str:
        """A number of the precision."""

    def absolute(self, value: str) -> str:
        """The size of a number."""

    def chosen(self, condition: str, first: str, second: str) -> str:
        """The first where the condition holds, else the second: names or numbers, as compilers branch to compute."""

    def power_of_two(self, exponent: str) -> str:
        """2 to a whole power."""

    def in_type(self, value: str) -> str:
        """A value rounded to the precision, where a language may compute in a wider one."""


@dataclass(frozen=True)
class Steps:
    """What is computed of `x`.

    Attributes:
        assignments: names and expressions of + − × and what a dialect has, in order.
        results: expressions.
    """

    assignments: tuple[tuple[str, str], ...]
    results: tuple[str, ...]


def angle_less_quarters(precision: Precision, say: Dialect) -> Steps:
    """x less its nearest multiple of π/2, up to the largest angle: `quarters`, the rest `y`, and what `y` lacks.

    What a difference loses is kept, and the last part of π/2 is taken from that.
    """
    first, *others, last = (say.number(part) for part in coefficients.right_angle(precision))
    steps = [
        ("quarters", _whole(f"{ARGUMENT} * {say.number(coefficients.inverses(precision)[0])}", precision, say)),
        ("rest", f"{ARGUMENT} - quarters * {first}"),
    ]
    rest, low = "rest", ""
    for n, part in enumerate(others, start=2):
        steps += [
            (f"part_{n}", f"quarters * {part}"),
            (f"rest_{n}", f"{rest} - part_{n}"),
            (f"low_{n}", f"{low}(({rest} - rest_{n}) - part_{n})" if low else f"({rest} - rest_{n}) - part_{n}"),
        ]
        rest, low = f"rest_{n}", f"low_{n} + "
    steps += [
        ("low", f"{low.removesuffix(' + ')} - quarters * {last}"),
        ("y", f"{rest} + low"),
        ("y_low", f"({rest} - y) + low"),
    ]
    return Steps(tuple(steps), ("quarters", "y", "y_low"))


def sine_and_cosine(precision: Precision, say: Dialect) -> Steps:
    """Of `quarters` π/2 + `y` + `y_low`."""
    one, quarter = say.number(1.0), f"quarters * {say.number(0.25)}"
    steps = [
        ("square", "y * y"),
        ("half_square", f"{say.number(0.5)} * square"),
        ("sine_series", _horner(coefficients.sine(precision), "square", say)),
        ("sine_of_y", "y + (square * y * sine_series + (y_low - half_square * y_low))"),
        ("head", f"{one} - half_square"),
        ("cosine_series", _horner(coefficients.cosine(precision), "square", say)),
        ("cosine_of_y", f"head + ((({one} - head) - half_square) + (square * square * cosine_series - y * y_low))"),
        ("quadrant", f"quarters - {say.number(4.0)} * ({_whole(quarter, precision, say)})"),
        ("turned", say.absolute("quadrant")),
        ("even", f"{one} - turned"),
        ("odd", f"quadrant * ({say.number(2.0)} - turned)"),
    ]  # one of the two is zero, the other one or minus one
    results = ("odd * cosine_of_y + even * sine_of_y", "even * cosine_of_y - odd * sine_of_y")
    return Steps(tuple(steps), results)


def exponential(precision: Precision, say: Dialect) -> Steps:
    """e^x for every number: zero and infinite where it is too small and too large."""
    half = _whole(f"doublings * {say.number(0.5)}", precision, say)  # one factor may be out of range
    powers = f"{say.power_of_two('half')} * {say.power_of_two('doublings - half')}"
    mantissa = f"({say.number(1.0)} + (rest + (half_square + tail)))"
    return Steps((*_reduced_exponent(precision, say), ("half", half)), (f"{mantissa} * {powers}",))


def exponential_less_one(precision: Precision, say: Dialect) -> Steps:
    """e^x − 1 for every number."""
    n = say.number
    one, most = n(1.0), n(SATURATED)
    steps = [
        *_reduced_exponent(precision, say),
        ("not_many", say.chosen(f"doublings > {most}", most, "doublings")),
        ("few", say.chosen(f"not_many < -{most}", f"-{most}", "not_many")),
        ("scale", say.power_of_two("few")),
        ("shifted", f"scale - {one}"),
        ("kept", f"shifted + {one}"),
        ("unshifted", f"(scale - kept) + ((kept - shifted) - {one})"),
        ("scaled", "scale * rest"),
        ("total", "shifted + scaled"),
        ("back", "total - shifted"),
        ("lost_again", "(shifted - (total - back)) + (scaled - back)"),
        ("near", "total + (scale * half_square + (lost_again + (unshifted + scale * tail)))"),
    ]
    return Steps(tuple(steps), (f"near * {say.power_of_two('doublings - not_many')}",))


def _reduced_exponent(precision: Precision, say: Dialect) -> list[tuple[str, str]]:
    """What e^x and e^x − 1 share: e^x = 2^doublings (1 + rest + half_square + tail)."""
    n = say.number
    (lowest, highest), (first, second) = precision.exponents, coefficients.doubling(precision)
    return [
        ("not_huge", say.chosen(f"{ARGUMENT} > {n(highest)}", n(highest), ARGUMENT)),
        ("given", say.chosen(f"not_huge < {n(lowest)}", n(lowest), "not_huge")),
        ("doublings", _whole(f"given * {n(coefficients.inverses(precision)[1])}", precision, say)),
        ("high", f"given - doublings * {n(first)}"),
        ("low", f"doublings * {n(second)}"),
        ("rest", "high - low"),
        ("lost", "(high - rest) - low"),
        ("square", "rest * rest"),
        ("series", _horner(coefficients.exponential(precision), "rest", say)),
        ("half_square", f"{n(0.5)} * square"),
        ("tail", "lost + rest * (lost + square * series)"),
    ]


def _whole(value: str, precision: Precision, say: Dialect) -> str:
    """The nearest whole number: what is added leaves no place for more, and is taken off again."""
    more = say.number(precision.to_whole)
    return f"{say.in_type(f'{value} + {more}')} - {more}"


def _horner(values: Sequence[float], variable: str, say: Dialect) -> str:
    """A polynomial from the inside outward."""
    *others, last = values
    text = say.number(last)
    for value in reversed(others):
        text = f"{say.number(value)} + {variable} * {text if text == say.number(last) else f'({text})'}"
    return text
