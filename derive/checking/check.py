"""Compares a printed formula with the derived one and says what it found."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

from radartrack.derive.algebra.equality import proved_equal
from radartrack.derive.checking.comparing.counterexample import (
    MATTERS,
    Relative,
    counterexample,
    find_difference,
    measured_against,
    unreal_counterexample,
    worst_over_domain,
)
from radartrack.derive.checking.comparing.difference_scale import squared_floor
from radartrack.derive.checking.comparing.numerical_comparison import Comparison, Here, Imaginary, Values
from radartrack.derive.checking.comparing.order_of_difference import orders
from radartrack.derive.checking.comparing.question_domain import Domain
from radartrack.derive.checking.conventions.altered_question import Asked
from radartrack.derive.checking.conventions.other_convention import condition_that_helps, convention_that_helps
from radartrack.derive.checking.conventions.other_quantity import other_quantities
from radartrack.derive.checking.question.compared_quantity import Reference, refer
from radartrack.derive.checking.question.conditions import also_zero, under, when_zero
from radartrack.derive.checking.question.formula_units import WrongDimensions, check_dimension
from radartrack.derive.checking.question.printed_formula import Printed, conditions_for, names_for, read_printed
from radartrack.derive.checking.repairing.rounded_decimals import meant
from radartrack.derive.checking.repairing.smallest_edit import suggest
from radartrack.derive.checking.reporting.barrier import attempted
from radartrack.derive.checking.reporting.derived_formula import shown
from radartrack.derive.checking.reporting.verdict import Counterexample, Outcome, Suggestion, Verdict
from radartrack.derive.formula.to_expression import is_real
from radartrack.derive.language.tensor import Index
from radartrack.derive.language.variable import Variable
from radartrack.derive.symbolic import Expr, Symbol

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
    *_, verdict = ask(name, formula, latex=latex, given=given, let=let).answers()
    return verdict


def ask(
    name: str,
    formula: str,
    *,
    latex: bool = False,
    given: Mapping[str, str] | None = None,
    let: Mapping[str, str] | None = None,
) -> Question:
    """The question of `check`, whose arguments these are and which raises the same."""
    reference = refer(name)
    names = names_for(reference, let or {})
    conditions = conditions_for(reference, given or {})
    question = Question(reference, read_printed(formula, names, reference.shape, latex=latex), conditions)
    exact = meant(question.printed)
    if exact and (rounded := replace(question, printed=exact.printed)).is_equal:
        return replace(rounded, rounding=Rounding(question.printed.text, exact.words))
    return question


@dataclass(frozen=True)
class Finding:
    """What was found out about one entry."""

    entry: Index
    outcome: Outcome
    values: Values | Imaginary | None = None
    reason: str = ""


@dataclass(frozen=True)
class Rounding:
    """A formula whose decimals round simple numbers: as it is printed, and what its decimals stand for in words."""

    printed: str
    words: str


@dataclass(frozen=True)
class Question:
    """A printed formula, what it is compared with, and under which conditions."""

    reference: Reference
    printed: Printed
    conditions: Mapping[Symbol, Expr]
    rounding: Rounding | None = None

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

    @cached_property
    def domain(self) -> Domain:
        """Where the formulas are compared."""
        return Domain(self.symbols, self.conditions)

    def answers(self) -> Iterator[Verdict]:
        """The verdict on all entries together, the gravest of them; then again and again, each with more beside it.

        What is said beside it takes longest, and may fail: the verdict is known before.
        """
        findings = [self.finding(entry) for entry, _ in self.printed.entries.items()]
        worst = max(findings, key=lambda finding: _GRAVITY.index(finding.outcome))
        conditions = tuple(f"{symbol} = {value}" for symbol, value in self.conditions.items())
        wrong = [finding for finding in findings if finding.outcome in _WRONG]
        verdict = Verdict(
            verdict=worst.outcome,
            quantity=self.reference.text,
            printed=self.printed.text,
            derived="",
            reason=_reason(worst, findings, conditions),
            counterexample=_example(worst, self.symbols) if wrong else None,
            conditions=conditions,
        )
        if self.rounding:
            reason, remark = f"{verdict.reason}, at the printed digits", f"at the printed digits: {self.rounding.words}"
            verdict = replace(verdict, printed=self.rounding.printed, reason=reason, remarks=(remark,))
        yield verdict
        for words, addition in self._additions(worst, wrong):
            verdict = _with(verdict, words, addition)
            yield verdict

    def _additions(self, worst: Finding, wrong: Sequence[Finding]) -> Iterator[tuple[str, Addition]]:
        """What is said beside the verdict, one after the other, and what that is in words."""
        yield "the derived formula", self._with_derived
        if wrong:
            yield "the worst over the domain", lambda verdict: self._with_worst(verdict, worst)
            yield "the order of the difference", lambda verdict: self._with_order(verdict, worst)
            yield "another convention", self._with_convention
            yield "what was perhaps meant", lambda verdict: self._with_edits(verdict, worst, wrong)
            yield "another quantity", self._with_other_quantities

    def derived_entry(self, entry: Index) -> Expr:
        """The derived formula under the conditions."""
        return under(self.conditions, self.reference.entries[entry])

    def printed_entry(self, entry: Index) -> Expr:
        """The printed formula under the conditions."""
        return under(self.conditions, self.printed.expressions[entry])

    def finding(self, entry: Index) -> Finding:
        """What is found out about one entry: a difference, a proof, or neither."""
        return attempted(
            lambda: self._found(entry), lambda why: Finding(entry, Outcome.UNDECIDED, reason=f"this {why}")
        )

    def _found(self, entry: Index) -> Finding:
        printed, derived = self.printed_entry(entry), self.derived_entry(entry)
        for words, expression in (("what was derived", derived), ("what is printed", printed)):
            if self.conditions and not is_real(expression):
                return Finding(entry, Outcome.UNDECIDED, reason=f"{words} has no value")
        if printed == derived:
            return Finding(entry, Outcome.EQUAL)
        comparison = Comparison(printed, derived, self.symbols)
        values = find_difference(comparison, self.domain)
        if values is not None:
            return self._wrong(entry, values)
        if attempted(lambda: proved_equal(printed, derived), lambda _: False):
            return Finding(entry, Outcome.EQUAL)
        finding = _without_proof(entry, comparison, self.domain)
        return self._wrong(entry, finding.values) if finding.values else finding

    def _wrong(self, entry: Index, values: Values | Imaginary) -> Finding:
        if dimensions := attempted(lambda: self._wrong_dimensions(entry), lambda _: ""):
            return Finding(entry, Outcome.WRONG_DIMENSIONS, values, dimensions)
        reason = "the printed formula is not real everywhere" if isinstance(values, Imaginary) else ""
        return Finding(entry, Outcome.DIFFERS, values, reason)

    def _wrong_dimensions(self, entry: Index) -> str:
        """What does not fit in the dimensions of an entry; nothing where they do."""
        try:
            check_dimension(
                self.printed.names.dimension_of(self.printed.entries[entry]), self.reference.dimensions[entry]
            )
        except WrongDimensions as error:
            return str(error)
        return ""

    def _with_derived(self, verdict: Verdict) -> Verdict:
        return replace(verdict, derived=shown(self.reference.entries.map(lambda entry: under(self.conditions, entry))))

    def _with_worst(self, verdict: Verdict, finding: Finding) -> Verdict:
        if not isinstance(finding.values, Values):
            return verdict
        return replace(verdict, counterexample=self._real_counterexample(finding.entry, finding.values))

    def _with_order(self, verdict: Verdict, finding: Finding) -> Verdict:
        printed, derived = self.printed_entry(finding.entry), self.derived_entry(finding.entry)
        return replace(verdict, order=orders(printed - derived, derived, self.symbols))

    def _with_convention(self, verdict: Verdict) -> Verdict:
        found = (self._condition, self._convention)
        return replace(verdict, remarks=(*verdict.remarks, *(remark for remark in found if remark)))

    def _with_edits(self, verdict: Verdict, worst: Finding, wrong: Sequence[Finding]) -> Verdict:
        edits = [suggestion for finding in wrong[:SHOWN_ENTRIES] for suggestion in self._suggestions(finding.entry)]
        condition, convention = attempted(lambda: (self._condition, self._convention), lambda _: (None, None))
        found = condition or (convention if len(wrong) > 1 or not edits else None)
        reason = verdict.reason + (f", but {found}" if found else _edit(worst, edits))
        return replace(verdict, reason=reason, suggestions=(*verdict.suggestions, *edits))

    def _with_other_quantities(self, verdict: Verdict) -> Verdict:
        condition = attempted(lambda: self._condition, lambda _: None)
        others = other_quantities(self._asked, uncorrelated=condition is None)
        return replace(verdict, suggestions=(*verdict.suggestions, *others))

    @cached_property
    def _asked(self) -> Asked:
        return Asked(self.reference, self.printed.expressions, self.printed.dimensions, self.conditions)

    @cached_property
    def _condition(self) -> str | None:
        return condition_that_helps(self._asked)

    @cached_property
    def _convention(self) -> str | None:
        return None if self._condition else convention_that_helps(self._asked)

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
        left = set[Symbol](self.reference.symbols) - conditions.keys()
        free = left.union(*(value.free_symbols for value in conditions.values()))
        symbols = [symbol for symbol in self.reference.symbols if symbol in free]
        derived = under(conditions, self.reference.entries[entry])
        found = suggest(self.printed.entries[entry], self.printed.names, derived, symbols, conditions)
        return [Suggestion(one.formula, one.edit, entry, one.proved) for one in found[:SUGGESTIONS]]

    def _real_counterexample(self, entry: Index, values: Values) -> Counterexample:
        pair = self.printed_entry(entry), self.derived_entry(entry)
        floor, beside = squared_floor(self.reference, entry)
        relative = Relative(*pair, pair[1] ** 2, self.symbols, under(self.conditions, floor))
        worst = worst_over_domain(relative, self.domain.working(), values.point)
        if values.relative < MATTERS <= worst.relative:
            values = Comparison(*pair, self.symbols).differ_at(worst.point) or values
        return counterexample(values, entry, worst, self.symbols, measured_against(beside))


_GRAVITY = (
    Outcome.EQUAL,
    Outcome.EQUAL_NUMERICALLY,
    Outcome.UNDECIDED,
    Outcome.DIFFERS,
    Outcome.WRONG_DIMENSIONS,
)
_WRONG = {Outcome.DIFFERS, Outcome.WRONG_DIMENSIONS}


Addition = Callable[[Verdict], Verdict]


def _with(verdict: Verdict, words: str, addition: Addition) -> Verdict:
    """The verdict with something beside it, or a remark that it failed."""
    return attempted(
        lambda: addition(verdict),
        lambda why: replace(verdict, remarks=(*verdict.remarks, f"{words} {why}")),
    )


def _example(finding: Finding, symbols: Sequence[Variable]) -> Counterexample | None:
    match finding.values:
        case Values() as values:
            return counterexample(values, finding.entry, None, symbols)
        case Imaginary() as imaginary:
            return unreal_counterexample(imaginary, finding.entry, symbols)
        case None:
            return None


def _without_proof(entry: Index, comparison: Comparison, domain: Domain) -> Finding:
    points = domain.sample()
    if not points:
        return Finding(entry, Outcome.UNDECIDED, reason="no point of the domain was found where it can be compared")
    found = [comparison.at(point, thorough=True) for point in points]
    for kind in (Values, Imaginary):
        if (values := next((one for one in found if isinstance(one, kind)), None)) is not None:
            return Finding(entry, Outcome.DIFFERS, values)
    agree, unknown = found.count(Here.AGREE), found.count(Here.UNKNOWN)
    if not agree:
        return Finding(entry, Outcome.UNDECIDED, reason="at no point of the domain do both have a real value")
    if unknown:
        reason = f"equal to 50 digits at {agree} of {agree + unknown} points; at the others it has no value"
        return Finding(entry, Outcome.UNDECIDED, reason=reason)
    return Finding(entry, Outcome.EQUAL_NUMERICALLY, reason=f"equal to 50 digits at {agree} points")


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
