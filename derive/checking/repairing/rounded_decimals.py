"""Decimals that round a simple number: 0.3333333333333333 is printed for 1/3, and compared as that."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from math import pi

from radartrack.derive import symbolic as sp
from radartrack.derive.checking.comparing.printed_number import PrintedNumber
from radartrack.derive.checking.comparing.rounding_to_print import rounded
from radartrack.derive.checking.question.printed_formula import Printed
from radartrack.derive.checking.question.printed_formula import printed as printed_of
from radartrack.derive.checking.repairing.monomial_fit import number_tree
from radartrack.derive.evaluation.exact_numbers import Exact, Undecidable
from radartrack.derive.formula.error import FormulaError
from radartrack.derive.formula.fold import rebuild
from radartrack.derive.formula.from_expression import to_tree
from radartrack.derive.formula.printing import to_text
from radartrack.derive.formula.to_expression import is_real
from radartrack.derive.formula.tree import Call, Constant, Negation, Number, Product, Tree, parts
from radartrack.derive.symbolic import Expr, unguarded
from radartrack.derive.verbs.no_closed_form import NoClosedForm

FEWEST = 5  # significant digits; fewer are near to too many simple numbers
SHORT = 30  # characters of an exact number that is told beside its digits
MOST = 15  # significant digits of a floating-point number, whose last ones may be rounding


@dataclass(frozen=True)
class Meant:
    """A formula with exact numbers for its rounded decimals.

    Attributes:
        printed: the formula.
        words: what is taken for what.
    """

    printed: Printed
    words: str


def meant(printed: Printed) -> Meant | None:
    """The formula with the simple numbers that its decimals round; None where there are none."""
    decimals = {node: simple for node in parts(printed.tree) if isinstance(node, Number) and (simple := _simple(node))}
    if not decimals:
        return None
    tree = rebuild(printed.tree, lambda node: decimals.get(node, node) if isinstance(node, Number) else node)
    try:
        exact = printed_of(tree, printed.names, printed.entries.shape)
    except (FormulaError, NoClosedForm):
        return None
    said = " and ".join(f"{to_text(node)} is taken as {to_text(simple)}" for node, simple in decimals.items())
    return Meant(exact, said)


def as_rounded(printed: Printed, derived: Expr) -> Meant | None:
    """What was derived, where it is a number and a decimal is printed that it rounds to; None else."""
    decimal, sign = (printed.tree.operand, -1) if isinstance(printed.tree, Negation) else (printed.tree, 1)
    if not isinstance(decimal, Number) or "." not in decimal.text or derived.free_symbols or not is_real(derived):
        return None
    number = PrintedNumber("-" * (sign < 0) + decimal.text)
    try:
        found = rounded(number, Exact.of(derived), sp.Integer(1))
        exact = printed_of(to_tree(unguarded(derived)), printed.names, printed.entries.shape)
    except (FormulaError, NoClosedForm, Undecidable):
        return None
    if not found.holds or derived == sp.Rational(number.value):
        return None
    value = f"{exact.text} = {found.shown}" if len(exact.text) <= SHORT else found.shown
    return Meant(exact, f"{to_text(printed.tree)} is what {value} rounds to")


def _simple(number: Number) -> Tree | None:
    """The simplest of a fraction, a fraction of pi and the root of a fraction that a long decimal is rounded from."""
    digits, last = _digits(number.text)
    if digits < FEWEST or "." not in number.text:
        return None
    value, most = number.value, 10 ** ((min(digits, MOST) - 1) // 2)
    last = max(last, value / 10**MOST)
    return min(_candidates(value, last, most), key=lambda pair: pair[0], default=(0, None))[1]


def _candidates(value: Fraction, last: Fraction, most: int) -> Iterator[tuple[int, Tree]]:
    """Exact numbers that are rounded or cut off to a value, with how much there is to write."""
    fraction = value.limit_denominator(most)
    if fraction == value:
        return
    if _gives(fraction - value, last):
        yield fraction.denominator, number_tree(fraction)
    turns = (value / Fraction(pi)).limit_denominator(most)
    if turns and _gives(turns * Fraction(pi) - value, last):
        yield 2 * turns.denominator, Constant("pi") if turns == 1 else Product((number_tree(turns), Constant("pi")))
    square = (value**2).limit_denominator(most)
    if square and _gives((square - value**2) / (2 * value), last):
        yield 3 * square.denominator, Call("sqrt", (number_tree(square),))


def _gives(rest: Fraction, last: Fraction) -> bool:
    """Whether what is lost is at most half a unit of the last digit where it is rounded up, and one where it is cut."""
    return -last / 2 <= rest < last


def _digits(text: str) -> tuple[int, Fraction]:
    """How many significant digits a decimal has, and a unit of the last."""
    mantissa, _, exponent = text.lower().partition("e")
    whole, _, decimals = mantissa.partition(".")
    return len((whole + decimals).lstrip("0")), Fraction(10) ** (int(exponent or 0) - len(decimals))
