"""Compares a printed formula with the derived one and says what it found."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

from radartrack.derive.algebra.equality import proved_equal
from radartrack.derive.checking.comparing.counterexample import (
    MATTERS,
    Relative,
    counterexample,
    find_difference,
    unreal_counterexample,
    worst_over_domain,
)
from radartrack.derive.checking.comparing.difference_scale import squared_scale
from radartrack.derive.checking.comparing.numerical_comparison import Comparison, Imaginary, Values
from radartrack.derive.checking.comparing.order_of_difference import orders
from radartrack.derive.checking.conventions.altered_question import Asked
from radartrack.derive.checking.conventions.other_convention import condition_that_helps, convention_that_helps
from radartrack.derive.checking.conventions.other_quantity import other_quantities
from radartrack.derive.checking.question.compared_quantity import Reference, refer
from radartrack.derive.checking.question.conditions import also_zero, check_defined, under, when_zero
from radartrack.derive.checking.question.formula_units import WrongDimensions, check_dimension
from radartrack.derive.checking.question.printed_formula import Printed, conditions_for, names_for, read_printed
from radartrack.derive.checking.repairing.rounded_decimals import meant
from radartrack.derive.checking.repairing.smallest_edit import suggest
from radartrack.derive.checking.reporting.derived_formula import shown
from radartrack.derive.checking.reporting.verdict import Counterexample, Outcome, Suggestion, Verdict
from radartrack.derive.evaluation.points import domain_points, generic_points, round_points
from radartrack.derive.language.tensor import Index
from radartrack.derive.language.variable import Variable
from radartrack.derive.symbolic import Expr, Symbol

POINTS = 20
SHOWN_ENTRIES = 4  # of a tensor that differs in many, how many get suggestions
SUGGESTIONS = 3


def check(
    name: str,
    formula: str,
    *,
    latex: bool = False,
    given: Mapping[str, str] | None = None,
    let: Mapping[str, str] | None = None,
) -> Verdict:
    """Compare a printed formula with what was derived.

    Args:
        name: a quantity of the catalogue, `polar.covariance.linear`; one entry of it,
            `polar.covariance.linear[0,1]`; a slice, `polar.hessian[:,0,1]`; or an expression over several.
        formula: as typed, or as printed in LaTeX; vectors and matrices as nested lists.
        latex: whether it is LaTeX.
        given: conditions under which to compare, `{"rho": "0"}`.
        let: the paper's own names, `{"D_beta": "sigma_beta**2"}`.

    Raises:
        UnknownQuantity: for a name that the catalogue does not have.
        UnknownEntry: for an entry that the quantity does not have.
        FormulaError: when the formula, a condition or a definition cannot be read.
    """
    reference = refer(name)
    names = names_for(reference, let or {})
    conditions = conditions_for(reference, given or {})
    printed = read_printed(formula, names, reference.shape, latex=latex)
    check_defined(conditions, reference.entries, reference.text)
    check_defined(conditions, printed.expressions, "the printed formula")
    question = Question(reference, printed, conditions)
    exact = meant(printed)
    if exact and (rounded := replace(question, printed=exact.printed)).is_equal:
        verdict = rounded.answer()
        reason = f"{verdict.reason}, at the printed digits"
        return replace(verdict, printed=printed.text, reason=reason, remarks=(f"at the printed digits: {exact.words}",))
    return question.answer()


@dataclass(frozen=True)
class Finding:
    """What was found out about one entry."""

    entry: Index
    outcome: Outcome
    values: Values | Imaginary | None = None
    reason: str = ""


@dataclass(frozen=True)
class Question:
    """A printed formula, what it is compared with, and under which conditions."""

    reference: Reference
    printed: Printed
    conditions: Mapping[Symbol, Expr]

    @cached_property
    def symbols(self) -> tuple[Variable, ...]:
        """Those that the conditions leave and that occur."""
        part = self.reference.part
        derived = [*self.reference.entries, *(part.quantity.expression if part else ())]
        expressions = (under(self.conditions, expression) for expression in (*derived, *self.printed.expressions))
        used = set[Symbol]().union(*(expression.free_symbols for expression in expressions))
        return tuple(symbol for symbol in self.reference.symbols if symbol in used)

    @property
    def is_equal(self) -> bool:
        """Whether all entries are."""
        return all(self.finding(entry).outcome in _GRAVITY[:2] for entry, _ in self.printed.entries.items())

    def answer(self) -> Verdict:
        """The verdict on all entries together: the gravest of them."""
        findings = [self.finding(entry) for entry, _ in self.printed.entries.items()]
        worst = max(findings, key=lambda finding: _GRAVITY.index(finding.outcome))
        conditions = tuple(f"{symbol} = {value}" for symbol, value in self.conditions.items())
        verdict = Verdict(
            verdict=worst.outcome,
            quantity=self.reference.text,
            printed=self.printed.text,
            derived=shown(self.reference.entries.map(lambda entry: under(self.conditions, entry))),
            reason=_reason(worst, findings, conditions),
            conditions=conditions,
        )
        wrong = [finding for finding in findings if finding.outcome in _WRONG]
        return self._explained(verdict, wrong) if wrong else verdict

    def derived_entry(self, entry: Index) -> Expr:
        """The derived formula under the conditions."""
        return under(self.conditions, self.reference.entries[entry])

    def printed_entry(self, entry: Index) -> Expr:
        """The printed formula under the conditions."""
        return under(self.conditions, self.printed.expressions[entry])

    def finding(self, entry: Index) -> Finding:
        """What is found out about one entry: a difference, a proof, or neither."""
        printed, derived = self.printed_entry(entry), self.derived_entry(entry)
        if printed == derived:
            return Finding(entry, Outcome.EQUAL)
        comparison = Comparison(printed, derived, self.symbols)
        values = find_difference(comparison, self.symbols)
        if values is not None:
            return self._wrong(entry, values)
        if proved_equal(printed, derived):
            return Finding(entry, Outcome.EQUAL)
        finding = _without_proof(entry, comparison, self.symbols)
        return self._wrong(entry, finding.values) if finding.values else finding

    def _wrong(self, entry: Index, values: Values | Imaginary) -> Finding:
        try:
            found = self.printed.names.dimension_of(self.printed.entries[entry])
            check_dimension(found, self.reference.dimensions[entry])
        except WrongDimensions as error:
            return Finding(entry, Outcome.WRONG_DIMENSIONS, values, str(error))
        reason = "the printed formula is not real everywhere" if isinstance(values, Imaginary) else ""
        return Finding(entry, Outcome.DIFFERS, values, reason)

    def _explained(self, verdict: Verdict, wrong: Sequence[Finding]) -> Verdict:
        first = max(wrong, key=lambda finding: _GRAVITY.index(finding.outcome))
        edits = [suggestion for finding in wrong[:SHOWN_ENTRIES] for suggestion in self._suggestions(finding.entry)]
        asked = Asked(self.reference, self.printed.expressions, self.printed.dimensions, self.conditions)
        condition = condition_that_helps(asked)
        convention = None if condition else convention_that_helps(asked)
        found = condition or (convention if len(wrong) > 1 or not edits else None)
        order = orders(
            self.printed_entry(first.entry) - self.derived_entry(first.entry),
            self.derived_entry(first.entry),
            self.symbols,
        )
        return replace(
            verdict,
            reason=verdict.reason + (f", but {found}" if found else _edit(first, edits)),
            counterexample=self._counterexample(first),
            suggestions=(*edits, *other_quantities(asked, uncorrelated=condition is None)),
            order=order,
            remarks=tuple(remark for remark in (condition, convention) if remark),
        )

    def _suggestions(self, entry: Index) -> list[Suggestion]:
        """The smallest edits; where there is none and the print has no correlation, those without correlation."""
        found = self._edited(entry, self.conditions)
        free = [symbol for symbol in self.symbols if symbol.is_correlation]
        if found or not free or self.printed_entry(entry).free_symbols & set(free):
            return found
        uncorrelated = also_zero(self.conditions, free)
        pair = self.printed.expressions[entry], self.reference.entries[entry]
        if not uncorrelated or proved_equal(*(under(uncorrelated, one) for one in pair)):
            return []  # where it is right already, every edit that changes nothing would do
        edited = self._edited(entry, uncorrelated)
        return [replace(one, edit=one.edit + when_zero(free)) for one in edited]

    def _edited(self, entry: Index, conditions: Mapping[Symbol, Expr]) -> list[Suggestion]:
        symbols = [symbol for symbol in self.reference.symbols if symbol not in conditions]
        derived = under(conditions, self.reference.entries[entry])
        found = suggest(self.printed.entries[entry], self.printed.names, derived, symbols, conditions)
        return [Suggestion(one.formula, one.edit, entry, one.proved) for one in found[:SUGGESTIONS]]

    def _counterexample(self, finding: Finding) -> Counterexample | None:
        match finding.values:
            case Values() as values:
                return self._real_counterexample(finding.entry, values)
            case Imaginary() as imaginary:
                return unreal_counterexample(imaginary, finding.entry, self.symbols)
            case None:
                return None

    def _real_counterexample(self, entry: Index, values: Values) -> Counterexample:
        pair = self.printed_entry(entry), self.derived_entry(entry)
        scale = under(self.conditions, squared_scale(self.reference, entry))
        worst = worst_over_domain(Relative(*pair, scale, self.symbols), self.symbols, values.point)
        if values.relative < MATTERS <= worst.relative:
            values = Comparison(*pair, self.symbols).differ_at(worst.point) or values
        return counterexample(values, entry, worst, self.symbols)


_GRAVITY = (
    Outcome.EQUAL,
    Outcome.EQUAL_NUMERICALLY,
    Outcome.UNDECIDED,
    Outcome.DIFFERS,
    Outcome.WRONG_DIMENSIONS,
)
_WRONG = {Outcome.DIFFERS, Outcome.WRONG_DIMENSIONS}


def _without_proof(entry: Index, comparison: Comparison, symbols: Sequence[Variable]) -> Finding:
    points = (*round_points(symbols), *generic_points(symbols, POINTS), *domain_points(symbols, POINTS))
    compared = [point for point in points if comparison.at(point) is not None]
    for point in compared:
        values = comparison.differ_at(point)
        if values is not None:
            return Finding(entry, Outcome.DIFFERS, values)
    imaginary = next((found for point in points if (found := comparison.imaginary_at(point))), None)
    if imaginary is not None:
        return Finding(entry, Outcome.DIFFERS, imaginary)
    if not compared:
        return Finding(entry, Outcome.UNDECIDED, reason="at no point of the domain do both have a real value")
    return Finding(entry, Outcome.EQUAL_NUMERICALLY, reason=f"equal to 50 digits at {len(compared)} points")


def _edit(finding: Finding, edits: Sequence[Suggestion]) -> str:
    return f": {edits[0].edit}" if edits and finding.outcome is Outcome.DIFFERS else ""


def _reason(worst: Finding, findings: Sequence[Finding], conditions: Sequence[str]) -> str:
    when = f" when {' and '.join(conditions)}" if conditions else ""
    where = f" in entry {list(worst.entry)}" if worst.entry else ""
    wrong = sum(finding.outcome in _WRONG for finding in findings)
    count = f" ({wrong} of {len(findings)} entries are wrong)" if wrong and len(findings) > 1 else ""
    match worst.outcome:
        case Outcome.EQUAL:
            return f"proved equal{when}"
        case Outcome.EQUAL_NUMERICALLY:
            return f"{worst.reason}{when}{where}, not proved"
        case Outcome.DIFFERS:
            return f"{worst.reason or 'not equal'}{when}{where}{count}"
        case _:
            return f"{worst.reason}{when}{where}{count}"
