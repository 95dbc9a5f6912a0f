"""One claim of a paper: what it says, and which of its fields fit together."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from typing import Any, TypeAlias

from radartrack.derive.checking.comparing.printed_number import PrintedNumber
from radartrack.derive.code_languages import LANGUAGES

WORD = re.compile(r"(?<![\w.])[A-Za-z_]\w*")
OF_NUMBERS = {"e", "pi", "sqrt"}  # words that a number may be written with
TOLD = ("id", "equation", "page", "note", "file", "lines", "seen", "matters", "repair", "finding")

Along: TypeAlias = "tuple[str, tuple[str, ...]]"


class ClaimsError(ValueError):
    """A claims file that cannot be used: it says file, claim, field and what is allowed."""


class UnreadableClaim(ValueError):
    """A claim has fields that do not fit, names a quantity that there is not, or holds an unreadable formula."""


@dataclass(frozen=True)
class Claim:
    """One claim of a paper.

    Attributes:
        id: unique in its file, and stable.
        quantity: what the formula or number claims to be: a quantity, an entry, or an expression over several.
        formula: as typed.
        latex: the formula in LaTeX instead.
        left: one side of an identity of the paper's own, without a quantity.
        right: the other side.
        chain: formulas of which each is said to equal the one before it.
        to_order: the order in the standard deviations up to which a formula is said to be right.
        limit: where symbols go, for a formula that is right in the limit.
        within: from where to where symbols lie.
        error_at_most: how much the formula differs at most there, as a number with a unit.
        code: the formula as code instead.
        language: of the code: python, c, cpp or matlab.
        function: of the code, the one that is meant.
        value: a printed number instead, with its digits; or the number at a maximum.
        unit: of the number; without one it is in SI units.
        significant: how many of its digits count, where the last ones are zeros that round.
        at: values of symbols, as formulas.
        given: conditions under which a formula is compared.
        let: the paper's own names.
        maximum_over: the number is the largest over whole numbers from and to.
        attained_at: where the maximum is.
        along: a symbol and the values that it takes, for a trend, a crossing or a bound.
        trend: how the quantity changes along them.
        crosses: a level that the quantity passes between the two values of `along`.
        at_most: a bound from above.
        at_least: a bound from below.
        undecided: why nothing that is derived can decide the claim.
        equation: number in print.
        page: in print.
        note: what a reader should know, such as what is illegible.
        file: in the sources of a library.
        lines: of that file.
        seen: where the formula was seen printed, or from where its form is known, if not as the others of the file.
        matters: of a claim that is wrong, what a radar would see of it.
        repair: of a claim that is wrong, what would be right, where nothing is suggested.
        finding: of a claim that is wrong, the page of `docs/findings` about it, without its ending.
        unreadable: what is wrong with the fields in a file; nothing else of the claim is known then.
    """

    id: str
    quantity: str = ""
    formula: str = ""
    latex: str = ""
    left: str = ""
    right: str = ""
    chain: tuple[str, ...] = ()
    to_order: int | None = None
    limit: Mapping[str, str] = field(default_factory=dict)
    within: Mapping[str, tuple[str, str]] = field(default_factory=dict)
    error_at_most: str = ""
    code: str = ""
    language: str = ""
    function: str = ""
    value: str = ""
    unit: str = ""
    significant: int | None = None
    at: Mapping[str, str] = field(default_factory=dict)
    given: Mapping[str, str] = field(default_factory=dict)
    let: Mapping[str, str] = field(default_factory=dict)
    maximum_over: Along | None = None
    attained_at: str = ""
    along: Along | None = None
    trend: str = ""
    crosses: str = ""
    at_most: str = ""
    at_least: str = ""
    undecided: str = ""
    equation: str = ""
    page: str = ""
    note: str = ""
    file: str = ""
    lines: str = ""
    seen: str = ""
    matters: str = ""
    repair: str = ""
    finding: str = ""
    unreadable: str = ""

    @property
    def is_formula(self) -> bool:
        """Whether formulas are compared, not numbers."""
        return bool(self.formula or self.latex or self.code or self.is_identity)

    @property
    def is_identity(self) -> bool:
        """Whether formulas are compared with each other, not with a quantity."""
        return bool(self.left or self.right or self.chain)

    @property
    def printed(self) -> str:
        """What the paper says, in one line."""
        bounds = (("at_most", "at most"), ("at_least", "at least"), ("crosses", "crosses"))
        said = [f"{words} {self._in_unit(getattr(self, name))}" for name, words in bounds if getattr(self, name)]
        parts = [
            self.formula or self.latex or self.code or self.right or " = ".join(self.chain),
            self._in_unit(self.value) if self.value else "",
            f"at {self.maximum_over[0]} = {self.attained_at}" if self.attained_at and self.maximum_over else "",
            self.trend,
            *said,
        ]
        return " ".join(part for part in parts if part) or self.note

    def _in_unit(self, number: str) -> str:
        """A number with the unit; a formula in symbols has its own."""
        has_unit = self.unit not in {"", "1"} and set(WORD.findall(number)) <= OF_NUMBERS
        return f"{number} {self.unit}" if has_unit else number

    @property
    def told(self) -> dict[str, Any]:
        """What a record tells of the claim beside the verdict."""
        return {name: getattr(self, name) for name in TOLD} | {"sense": self.sense, "at": dict(self.at)}

    @property
    def sense(self) -> str:
        """In which sense a formula is right, where it is not exactly: to an order, in a limit, nearly."""
        return ", ".join(
            [
                *([f"to order {self.to_order}"] if self.to_order is not None else []),
                *(f"where {name} goes to {value}" for name, value in self.limit.items()),
                *([f"to {self.error_at_most}"] if self.error_at_most else []),
            ]
        )

    @property
    def settings(self) -> str:
        """Where a number is meant, as short text."""
        return ", ".join(f"{name} = {value}" for name, value in self.at.items())


def problems(claim: Claim) -> Iterator[str]:
    """What does not fit together in a claim."""
    if claim.undecided:
        if claim.value:
            yield "undecided excludes value"
        return
    if claim.is_identity and claim.quantity:
        yield "left, right and chain need no quantity: they are compared with each other"
    if bool(claim.left) != bool(claim.right):
        yield "left and right belong together"
    if not claim.quantity and not claim.is_identity:
        yield "quantity is missing: a catalogue name, one entry of it, or an expression over several"
    kinds = _kinds(claim)
    if len(kinds) != 1:
        given = " and ".join(kinds) or "none, or an empty one"
        yield f"exactly one of {', '.join(_KINDS)} is needed, given {given}"
    yield from _misplaced(claim)
    yield from _misplaced_senses(claim)
    yield from _contradictory(claim)


def _misplaced(claim: Claim) -> Iterator[str]:
    """Fields that need others, or belong to another kind of claim."""
    if claim.attained_at and not claim.maximum_over:
        yield "attained_at needs maximum_over"
    if (claim.trend or claim.crosses) and not claim.along:
        yield "along is missing: the symbol and its values, such as along = { k = [3, 20] }"
    if claim.crosses and claim.along and len(claim.along[1]) != 2:
        yield "along of a crossing has two values: before it and after it"
    if claim.along and (claim.value or claim.attained_at):
        yield "along belongs to trend, crosses, at_most and at_least; a value has at"
    if bool(claim.code) != bool(claim.language) or (claim.function and not claim.code):
        yield f"code and language stand together; the languages are {', '.join(LANGUAGES)}"
    if claim.significant is not None and not claim.value:
        yield "significant needs value"
    if claim.is_formula and (claim.at or claim.along or claim.maximum_over):
        yield "at, along and maximum_over belong to numbers; conditions on a formula are written as given"
    if claim.is_formula and claim.unit:
        yield "unit belongs to numbers; a formula has the units of its symbols"
    if not claim.is_formula and (claim.given or claim.let):
        yield "given and let belong to formulas; numbers have at"


def _misplaced_senses(claim: Claim) -> Iterator[str]:
    """In which sense a formula is meant, where there is none."""
    if not claim.is_formula and (claim.to_order is not None or claim.limit or claim.within or claim.error_at_most):
        yield "to_order, limit, within and error_at_most belong to formulas"
    if claim.error_at_most and (claim.to_order is not None or claim.limit or claim.chain):
        yield "error_at_most excludes to_order, limit and chain"


def _contradictory(claim: Claim) -> Iterator[str]:
    """Fields that set one thing twice, or say how a number rounds against its digits."""
    symbols = [*claim.at, *(one[0] for one in (claim.along, claim.maximum_over) if one)]
    for symbol in dict.fromkeys(one for one in symbols if symbols.count(one) > 1):
        yield f"{symbol} is set twice: it has one value in at, or several in along or maximum_over"
    if claim.value and not PrintedNumber(claim.value, claim.significant).counts_whole:
        yield f"significant = {claim.significant} leaves digits of {claim.value} that are not zero"


_KINDS = (
    "formula", "latex", "code", "left", "chain", "value", "attained_at", "trend", "crosses", "at_most", "at_least",
    "undecided",
)  # fmt: skip


def _kinds(claim: Claim) -> list[str]:
    """What the claim is about; a value at its maximum is one thing."""
    found = [kind for kind in _KINDS if getattr(claim, kind)]
    return [kind for kind in found if not (kind == "attained_at" and claim.value)]
