"""What a check says, as data."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import asdict, dataclass, field
from enum import StrEnum
from typing import Any

from radartrack.derive.language.tensor import Index


class Outcome(StrEnum):
    """The five verdicts."""

    EQUAL = "equal"
    EQUAL_NUMERICALLY = "equal_numerically"
    DIFFERS = "differs"
    WRONG_DIMENSIONS = "wrong_dimensions"
    UNDECIDED = "undecided"


GRAVITY = (
    Outcome.EQUAL,
    Outcome.EQUAL_NUMERICALLY,
    Outcome.UNDECIDED,
    Outcome.DIFFERS,
    Outcome.WRONG_DIMENSIONS,
)
"""From what is right to what is most wrong."""


@dataclass(frozen=True)
class Counterexample:
    """A point inside the domain where a printed formula is wrong.

    Attributes:
        point: the values of the symbols, in SI units and radians.
        entry: which entry is compared; empty for a scalar.
        printed: the value of the printed formula; None where it has no real one.
        derived: the value of the derived one.
        relative_difference: |printed - derived| / |derived|; by the printed value where the derived one is zero; None
            where the printed one is not real, and in a record where it is beyond the numbers of a machine.
        units: of the symbols.
        largest_relative_difference: the largest found where radars work, by the same measure; at points where the
            entry nearly vanishes beside others of its unit it is not looked for.
        largest_at: where that is.
        measured_against: what the largest is measured against, and where, in words.
    """

    point: Mapping[str, float]
    entry: Index
    printed: float | None
    derived: float
    relative_difference: float | None
    units: Mapping[str, str] = field(default_factory=dict)
    largest_relative_difference: float | None = None
    largest_at: Mapping[str, float] = field(default_factory=dict)
    measured_against: str = ""


@dataclass(frozen=True)
class Suggestion:
    """What was probably meant.

    Attributes:
        formula: the printed formula after the edit, or the name of another quantity that it equals.
        edit: what was changed, in words.
        entry: which entry it is about.
        proved: whether the result is proved equal to the derived formula.
        definition: the name of the definition to mend, where the slip is in one.
    """

    formula: str
    edit: str
    entry: Index = ()
    proved: bool = True
    definition: str = ""


@dataclass(frozen=True)
class TermDifference:
    """A term of the canonical form in which the print differs.

    Attributes:
        term: the term without its coefficient.
        printed: its coefficient in the printed formula.
        derived: its coefficient in the derived one.
        entry: which entry it is about.
    """

    term: str
    printed: str
    derived: str
    entry: Index = ()


@dataclass(frozen=True)
class Verdict:
    """The answer to one question.

    Attributes:
        verdict: one of five.
        quantity: what the formula was compared with.
        printed: the formula as it was read.
        derived: what was derived, as text that can be checked in turn.
        reason: why, in a sentence or two.
        counterexample: where it is wrong, when it differs.
        suggestions: what was probably meant, the likeliest first.
        order: the leading order of the difference in the standard deviations, and that of the quantity itself.
        conditions: under which it was compared: `rho = 0`.
        remarks: what else was found: conditions under which it is equal, other quantities that it equals.
        convention: in which the least is wrong, in words; nothing for ours.
        terms: where nothing is suggested, the terms of the canonical form that differ.
        reading: with what letters of its own the formula was read: `theta for beta`.
    """

    verdict: Outcome
    quantity: str
    printed: str
    derived: str
    reason: str
    counterexample: Counterexample | None = None
    suggestions: tuple[Suggestion, ...] = ()
    order: tuple[int, int] | None = None
    conditions: tuple[str, ...] = ()
    remarks: tuple[str, ...] = ()
    convention: str = ""
    terms: tuple[TermDifference, ...] = ()
    reading: tuple[str, ...] = ()

    @property
    def is_equal(self) -> bool:
        """Whether the formula is right."""
        return self.verdict in {Outcome.EQUAL, Outcome.EQUAL_NUMERICALLY}

    def record(self) -> dict[str, Any]:
        """The verdict as plain data for JSON, which has no infinity: a number beyond those of a machine is null."""
        record: dict[str, Any] = _finite(asdict(self) | {"verdict": self.verdict.value})
        return record


def _finite(data: Any) -> Any:
    match data:
        case dict():
            return {key: _finite(value) for key, value in data.items()}
        case list() | tuple():
            return [_finite(value) for value in data]
        case float() if not math.isfinite(data):
            return None
        case _:
            return data
