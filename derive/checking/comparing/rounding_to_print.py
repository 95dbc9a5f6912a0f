"""Whether a derived number rounds to a printed one, decided exactly and as people round."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass
from fractions import Fraction
from itertools import pairwise

import mpmath

from radartrack.derive import symbolic as sp
from radartrack.derive.checking.comparing.printed_number import PrintedNumber
from radartrack.derive.evaluation.exact_numbers import Exact, Undecidable, compared, sign_of
from radartrack.derive.evaluation.many_digits import Number
from radartrack.derive.symbolic import Expr

SHOWN_DIGITS = 6
MOST_DIGITS = 60  # shown where fewer would hide a difference
BEYOND = 2  # digits shown beyond those that are printed


@dataclass(frozen=True)
class Rounded:
    """How a derived number stands to a printed one.

    Attributes:
        holds: whether it rounds to the printed one.
        is_tie: whether it lies midway between two printed numbers.
        shown: the derived number, with enough digits to see that.
    """

    holds: bool
    is_tie: bool
    shown: str


def rounded(printed: PrintedNumber, derived: Exact, unit: Expr) -> Rounded:
    """Compare a number in SI units with a printed one, which is in a unit.

    A number midway may be rounded up, away from zero, as schools teach, or to the even digit.

    Raises:
        Undecidable: where exact arithmetic cannot tell.
    """
    ends = [printed.value + side * printed.last / 2 for side in (-1, 1)]
    beyond = [compared(derived, Exact.of(sp.Rational(end) * unit)) for end in ends]
    is_tie = 0 in beyond
    holds = _accepts_tie(printed, ends[beyond.index(0)]) if is_tie else beyond == [1, -1]
    return Rounded(holds, is_tie, _shown(printed, in_unit(derived, unit), ends, beyond))


def _accepts_tie(printed: PrintedNumber, midway: Fraction) -> bool:
    return abs(printed.value) > abs(midway) or printed.value / printed.last % 2 == 0


def _shown(printed: PrintedNumber, derived: Number, ends: list[Fraction], beyond: list[int]) -> str:
    """With digits beyond the printed ones, and so many that what is shown rounds as the number does."""
    return next(
        text
        for text in _in_more_digits(derived, _digits_shown(printed, derived))
        if [_sign(Fraction(text) - end) for end in ends] == beyond or len(text) > MOST_DIGITS
    )


def _digits_shown(printed: PrintedNumber, derived: Number) -> int:
    if not derived:
        return SHOWN_DIGITS
    leading = int(mpmath.floor(mpmath.log10(abs(derived))))
    return min(MOST_DIGITS, max(SHOWN_DIGITS, leading - printed.exponent + 1 + BEYOND))


def shown(value: Number, digits: int = SHOWN_DIGITS) -> str:
    """A number for people."""
    return str(mpmath.nstr(value, digits)).removesuffix(".0")


def shown_apart(*values: Number) -> list[str]:
    """Numbers with so many digits that neighbours that differ are seen to."""
    texts = [shown(value, MOST_DIGITS) for value in values]
    different = _steps(texts)
    few = ([shown(value, digits) for value in values] for digits in range(SHOWN_DIGITS, MOST_DIGITS))
    return next((some for some in few if _steps(some) == different), texts)


def in_unit(number: Exact, unit: Expr) -> Number:
    """A number in SI units in another unit, in many digits; zero without its rounding."""
    with suppress(Undecidable):
        if sign_of(lambda value: value, number) == 0:
            return mpmath.mpf(0)
    with mpmath.workdps(2 * MOST_DIGITS):
        return number.value() / Exact.of(unit).value()


def _steps(texts: Sequence[str]) -> list[bool]:
    return [one != other for one, other in pairwise(texts)]


def _sign(number: Fraction) -> int:
    return (number > 0) - (number < 0)


def _in_more_digits(value: Number, fewest: int) -> Iterator[str]:
    for digits in range(fewest, 2 * MOST_DIGITS):
        yield shown(value, digits)
