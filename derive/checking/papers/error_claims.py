"""Decides claims about the error of an approximation: `error_at_most = "1 %"`, over the domain of its symbols."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from radartrack.derive import symbolic as sp
from radartrack.derive.checking.answers import Question
from radartrack.derive.checking.comparing.counterexample import Relative, counterexample
from radartrack.derive.checking.comparing.difference_scale import squared_scale
from radartrack.derive.checking.comparing.error_bound import largest_error, proved_within
from radartrack.derive.checking.comparing.numerical_comparison import Comparison
from radartrack.derive.checking.papers.claim_fields import BOUND
from radartrack.derive.checking.question.conditions import under
from radartrack.derive.checking.question.formula_units import Dimension, WrongDimensions, check_dimension
from radartrack.derive.checking.reporting.derived_formula import shown
from radartrack.derive.checking.reporting.verdict import Outcome, Verdict
from radartrack.derive.formula.error import FormulaError
from radartrack.derive.language.tensor import Index
from radartrack.derive.reading.unit_text import Scale, read_unit
from radartrack.derive.symbolic import Expr

SHARES = ("", "1", "%")


def bounded(question: Question, bound: str) -> Iterator[Verdict]:
    """The verdict, as it is before the proof and after it.

    It differs where a larger error is found, is equal where a proof excludes one, and else equal numerically.
    A bound in % or without a unit is relative, to what the worst difference is relative to; one in a unit is absolute.

    Raises:
        FormulaError: when the bound cannot be read, or has another unit than the quantity.
    """
    most, is_relative, scale = _read(bound)
    worst = 0.0
    errors = []
    for entry in question.printed.entries.indices:
        try:
            found = question.printed.names.dimension_of(question.printed.entries[entry])
            check_dimension(found, question.reference.dimension(entry))
            if not is_relative:
                check_dimension(Dimension.of(scale.unit), question.reference.dimension(entry))
        except WrongDimensions as error:
            yield _verdict(question, Outcome.WRONG_DIMENSIONS, str(error))
            return
        printed, derived = question.printed_entry(entry), question.derived_entry(entry)
        square = (
            under(question.conditions, squared_scale(question.reference, entry)[0]) if is_relative else sp.Integer(1)
        )
        largest = largest_error(Relative(printed, derived, square, question.symbols), question.domain)
        if largest.relative > most:
            yield _too_large(question, entry, largest.relative, largest.point, bound, scale)
            return
        worst = max(worst, largest.relative)
        errors.append((printed - derived) / (sp.sqrt(square) if not _is_square(square, derived) else derived))
    told = f"the largest error found is {_spoken(worst, scale)}, at most {bound}"
    yield _verdict(question, Outcome.EQUAL_NUMERICALLY, f"{told}{question.sense}, not proved")
    if question.symbols and all(proved_within(error, most, question.symbols) for error in errors):
        yield _verdict(question, Outcome.EQUAL, f"{told} by proof{question.sense}")


def _read(bound: str) -> tuple[float, bool, Scale]:
    found = BOUND.fullmatch(bound.strip())
    if found is None:
        raise FormulaError(f'error_at_most must be a number and a unit, such as "1 %"; given {bound[:40]}')
    try:
        scale = read_unit(found["unit"] or "1")
    except ValueError as error:
        raise FormulaError(f"error_at_most: {error}") from None
    return float(found["number"]) * scale.size, found["unit"] in SHARES, scale


def _is_square(square: Expr, derived: Expr) -> bool:
    return square in (derived**2, sp.Integer(0))


def _too_large(
    question: Question, entry: Index, error: float, point: dict[str, float], bound: str, scale: Scale
) -> Verdict:
    values = Comparison(question.printed_entry(entry), question.derived_entry(entry), question.symbols)
    there = values.differ_at(point)
    place = f" in entry {list(entry)}" if entry else ""
    verdict = _verdict(
        question,
        Outcome.DIFFERS,
        f"the error{place} is up to {_spoken(error, scale)}, more than {bound}{question.sense}",
    )
    return replace(verdict, counterexample=counterexample(there, entry, None, question.symbols) if there else None)


def _spoken(error: float, scale: Scale) -> str:
    unit = "%" if str(scale.unit) == "1" else str(scale.unit)
    return f"{100 * error if unit == '%' else error:.3g} {unit}"


def _verdict(question: Question, outcome: Outcome, reason: str) -> Verdict:
    conditions = tuple(f"{symbol} = {value}" for symbol, value in question.conditions.items())
    derived = question.reference.entries.map(lambda entry: under(question.conditions, entry))
    return Verdict(
        outcome, question.reference.text, question.printed.text, shown(derived), reason, conditions=conditions
    )
