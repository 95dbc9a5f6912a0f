"""What is found out about a question: the verdict on all entries, then what is said beside it."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

from radartrack.derive.algebra.equality import proved_equal
from radartrack.derive.algebra.principal_angles import equal_angles
from radartrack.derive.catalogue import catalogue
from radartrack.derive.checking.comparing.canonical_terms import differing_terms
from radartrack.derive.checking.comparing.counterexample import (
    MATTERS,
    TELLS,
    Relative,
    counterexample,
    example,
    find_difference,
    measured_against,
    worst_over_domain,
)
from radartrack.derive.checking.comparing.difference_scale import squared_floor
from radartrack.derive.checking.comparing.numerical_comparison import Comparison, Here, Imaginary, Values
from radartrack.derive.checking.comparing.order_of_difference import orders
from radartrack.derive.checking.comparing.question_domain import Domain, everywhere
from radartrack.derive.checking.conventions.altered_question import Asked
from radartrack.derive.checking.conventions.limiting_case import limiting_case
from radartrack.derive.checking.conventions.other_quantity import other_quantities
from radartrack.derive.checking.question.compared_quantity import (
    Reference,
)
from radartrack.derive.checking.question.conditions import under
from radartrack.derive.checking.question.formula_units import WrongDimensions, check_dimension
from radartrack.derive.checking.question.letters.letter_readings import (
    AS_TYPED,
    Reading,
)
from radartrack.derive.checking.question.printed_formula import (
    Printed,
)
from radartrack.derive.checking.repairing.least_to_explain import Account, Print
from radartrack.derive.checking.repairing.slips_inside import Repair, Slip, has_inside
from radartrack.derive.checking.reporting.barrier import attempted
from radartrack.derive.checking.reporting.derived_formula import shown
from radartrack.derive.checking.reporting.verdict import GRAVITY, Counterexample, Outcome, Suggestion, Verdict
from radartrack.derive.evaluation.points import Point
from radartrack.derive.formula.from_expression import to_tree
from radartrack.derive.formula.to_expression import is_real
from radartrack.derive.formula.tree import Tree
from radartrack.derive.language.tensor import Index
from radartrack.derive.language.variable import Variable
from radartrack.derive.symbolic import Expr, Symbol


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
    """A printed formula, what it is compared with, under which conditions, where, and in which sense, in words."""

    reference: Reference
    printed: Printed
    conditions: Mapping[Symbol, Expr]
    sense: str = ""
    rounding: Rounding | None = None
    reading: Reading = AS_TYPED
    other_model: Callable[[Reference], Question | None] | None = None
    where: Callable[[Point], bool] = everywhere
    most: float = math.inf
    """The cost above which another explanation is of no use, as there is a better reading."""

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
        return all(finding.outcome in GRAVITY[:2] for finding in self._findings)

    @property
    def has_units(self) -> bool:
        """Whether no entry is wrong for its units."""
        return all(finding.outcome is not Outcome.WRONG_DIMENSIONS for finding in self._findings)

    @cached_property
    def domain(self) -> Domain:
        """Where the formulas are compared."""
        return Domain(self.symbols, self.conditions, where=self.where)

    def answers(self) -> Iterator[Verdict]:
        """The verdict on all entries together, the gravest of them; then again and again, each with more beside it.

        What is said beside it takes longest, and may fail: the verdict is known before.
        """
        findings = self._findings
        worst = max(findings, key=lambda finding: GRAVITY.index(finding.outcome))
        conditions = tuple(f"{symbol} = {value}" for symbol, value in self.conditions.items())
        wrong = [finding for finding in findings if finding.outcome in _WRONG]
        verdict = Verdict(
            verdict=worst.outcome,
            quantity=self.reference.text,
            printed=self.printed.text,
            derived="",
            reason=_reason(worst, findings, conditions, self.sense),
            counterexample=example(worst.values, worst.entry, self.symbols) if wrong else None,
            conditions=conditions,
            remarks=self.printed.remarks,
            reading=self.reading.words,
        )
        if self.rounding:
            reason, remark = f"{verdict.reason}, at the printed digits", f"at the printed digits: {self.rounding.words}"
            verdict = replace(verdict, printed=self.rounding.printed, reason=reason, remarks=(*verdict.remarks, remark))
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
            yield "another quantity", self._with_other_quantities
            yield "what is neglected", lambda verdict: self._with_limit(verdict, lacking=True)
            yield "what was perhaps meant", lambda verdict: self._with_edits(verdict, worst)
            yield "a limit in which it is right", lambda verdict: self._with_limit(verdict, lacking=False)
            yield "another quantity that was perhaps meant", self._with_siblings
            yield "the terms that differ", lambda verdict: self._with_terms(verdict, wrong)

    def derived_entry(self, entry: Index) -> Expr:
        """The derived formula under the conditions."""
        return under(self.conditions, self.reference.entries[entry])

    def printed_entry(self, entry: Index) -> Expr:
        """The printed formula under the conditions."""
        return under(self.conditions, self.printed.expressions[entry])

    @cached_property
    def _findings(self) -> list[Finding]:
        return [self.finding(entry) for entry, _ in self.printed.entries.items()]

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
        if attempted(lambda: proved_equal(printed, derived) or equal_angles(printed, derived), lambda _: False):
            return Finding(entry, Outcome.EQUAL)
        finding = _without_proof(entry, comparison, self.domain)
        return self._wrong(entry, finding.values) if finding.values else finding

    def _wrong(self, entry: Index, values: Values | Imaginary) -> Finding:
        if dimensions := attempted(lambda: self._wrong_dimensions(entry), lambda _: ""):
            return Finding(entry, Outcome.WRONG_DIMENSIONS, values, dimensions)
        reason = "the printed formula is not real everywhere" if isinstance(values, Imaginary) else ""
        return Finding(entry, Outcome.DIFFERS, values, reason)

    def _wrong_dimensions(self, entry: Index) -> str:
        """What does not fit in the dimensions of an entry; nothing where all does.

        The map of a model may add a number alone to a length: dimensions say nothing of what is printed for it then.
        """
        wrong, part = self._misfit(self.printed.entries[entry], entry), self.reference.part
        if not wrong or part is None or part.quantity.model is None:
            return wrong
        own = attempted(lambda: self._misfit(to_tree(self.reference.entries[entry]), entry), lambda _: "")
        return "" if own else wrong

    def _misfit(self, tree: Tree, entry: Index) -> str:
        try:
            check_dimension(self.printed.names.dimension_of(tree), self.reference.dimension(entry))
        except WrongDimensions as error:
            return str(error)
        return ""

    def _with_derived(self, verdict: Verdict) -> Verdict:
        """With the derived formula under the conditions, or without them where it has no value then."""
        entries = self.reference.entries
        conditioned = entries.map(lambda entry: under(self.conditions, entry))
        return replace(verdict, derived=shown(conditioned if all(map(is_real, conditioned)) else entries))

    def _with_worst(self, verdict: Verdict, finding: Finding) -> Verdict:
        if not isinstance(finding.values, Values):
            return verdict
        return replace(verdict, counterexample=self._real_counterexample(finding.entry, finding.values))

    def _with_order(self, verdict: Verdict, finding: Finding) -> Verdict:
        printed, derived = self.printed_entry(finding.entry), self.derived_entry(finding.entry)
        return replace(verdict, order=orders(printed - derived, derived, self.symbols))

    def _with_convention(self, verdict: Verdict) -> Verdict:
        found = self._print.complete
        return replace(verdict, remarks=(*verdict.remarks, f"equal{found.words}")) if found else verdict

    def _with_other_quantities(self, verdict: Verdict) -> Verdict:
        explained = attempted(lambda: self._print.complete is not None, lambda _: False)
        others = other_quantities(self._asked, uncorrelated=not explained)
        if not others and (others := self._other_models()):
            verdict = replace(verdict, reading=())  # its letters are said with the other model
        return replace(verdict, suggestions=(*verdict.suggestions, *others))

    def _other_models(self) -> tuple[Suggestion, ...]:
        """The same thing in another model that the formula is, in whatever letters, be they ours with other units."""
        fits = self.reading.fits and not any(one.outcome is Outcome.WRONG_DIMENSIONS for one in self._findings)
        found = self.other_model(self.reference) if self.other_model and not fits else None
        if found is None:
            return ()
        letters = f" with {' and '.join(found.reading.words)}" if found.reading.words else ""
        name = found.reference.text
        return (Suggestion(name, f"this is {name}{letters}, not {self.reference.text}"),)

    def _with_edits(self, verdict: Verdict, worst: Finding) -> Verdict:
        count = len(self.printed.entries.entries)
        others = verdict.suggestions
        known = others and self._is_rival(others[0].formula)
        limit = next((one for one in verdict.remarks if one.startswith("equal where ") and " goes to " in one), "")
        if limit and not known:
            return replace(verdict, reason=f"{verdict.reason}, but {limit}")
        if known and (count > 1 or limit):
            return replace(verdict, reason=f"{verdict.reason}, but {others[0].edit}")
        account = self._account
        likely = account.suggestions and account.cost <= LIKELY
        if known:  # of one entry, a slip may have made the other quantity of ours
            return replace(
                verdict,
                reason=f"{verdict.reason}, but {others[0].edit}",
                suggestions=(*others, *(account.suggestions if likely else ())),
                convention=account.convention.strip(),
            )
        if likely:  # another entry with another sign or in another convention is more to explain
            others = tuple(one for one in others if _is_plain_entry(one.formula))
        reason = f"{verdict.reason}{_explained(account, worst, count)}"
        suggestions = (*account.suggestions, *others)
        return replace(verdict, reason=reason, suggestions=suggestions, convention=account.convention.strip())

    def _with_siblings(self, verdict: Verdict) -> Verdict:
        near = verdict.suggestions or verdict.convention or verdict.remarks
        return verdict if near else replace(verdict, suggestions=tuple(self._print.of_siblings()))

    def _with_limit(self, verdict: Verdict, *, lacking: bool) -> Verdict:
        """With the limit in which the formula is right, where it is nothing else but perhaps another model's."""
        explained = verdict.convention or _is_explained(verdict)
        if explained or not all(self._is_rival(one.formula) for one in verdict.suggestions) or self.sense:
            return verdict
        if verdict.suggestions and not lacking:
            return verdict
        where = limiting_case(self._asked, lacking=lacking)
        return replace(verdict, remarks=(*verdict.remarks, f"equal{where}")) if where else verdict

    def _with_terms(self, verdict: Verdict, wrong: Sequence[Finding]) -> Verdict:
        explained = {suggestion.entry for suggestion in verdict.suggestions}
        left = [finding.entry for finding in wrong if finding.entry not in explained]
        whole = any(one.definition or (self.reference.shape and not one.entry) for one in verdict.suggestions)
        if verdict.convention or not left or whole:
            return verdict
        return replace(
            verdict, terms=differing_terms(self.printed_entry(left[0]), self.derived_entry(left[0]), left[0])
        )

    def _is_rival(self, name: str) -> bool:
        """Whether this is another quantity, right in its own model, not another entry of ours, nor a negative."""
        part = self.reference.part
        own = {part.quantity.name} if part else set()
        return re.split(r"[\[ ]", name)[0] in catalogue().keys() - own

    @cached_property
    def to_explain(self) -> float:
        """How much is left to explain of what is wrong: nothing where all is right."""
        return 0.0 if self.is_equal else attempted(lambda: self._account.cost, lambda _: math.inf)

    @cached_property
    def _account(self) -> Account:
        wrong = tuple(one.entry for one in self._findings if one.outcome in _WRONG)
        account = self._print.account(wrong)
        slips = [] if account.is_complete else attempted(lambda: self._slips_inside(account), lambda _: [])
        if not slips:
            return account
        inside = (Suggestion(slip.formula, slip.words, definition=slip.definition) for slip in slips)
        edits = () if account.convention or len(wrong) > 1 else account.suggestions
        return Account("", wrong, (*inside, *edits), slips[0].cost)

    def _slips_inside(self, account: Account) -> list[Slip]:
        """Slips inside of what is worked out that explain all that is wrong as well as that: no edit of an entry can.

        In plain definitions too where nothing else explains it: floating point does not see all that is wrong there.
        """
        unexplained = not account.suggestions and not account.convention
        is_inside = has_inside(self.printed) or (unexplained and bool(self.printed.names.definitions))
        if not (self._is_compared and is_inside):
            return []
        derived = self.reference.entries.map(lambda entry: under(self.conditions, entry))
        repair = Repair(self.printed, self.printed.names, derived, self.symbols, self.conditions)
        return repair.slips(min(self.most, account.cost))

    @cached_property
    def _is_compared(self) -> bool:
        """Whether what is compared is what is printed, and no polynomial or limit of it."""
        if not self.sense:
            return True
        entries = self.printed.entries.map(lambda tree: under(self.conditions, self.printed.names.read(tree)))
        return all(entries[index] == self.printed_entry(index) for index, _ in entries.items())

    @cached_property
    def _asked(self) -> Asked:
        letters = {name: letter.symbol for name, letter in self.reading.letters.items()}
        return Asked(self.reference, self.printed.expressions, self.printed.dimensions, self.conditions, letters)

    @cached_property
    def _print(self) -> Print:
        return Print(self._asked, self.printed, self._is_compared)

    def _real_counterexample(self, entry: Index, values: Values) -> Counterexample:
        pair = self.printed_entry(entry), self.derived_entry(entry)
        floor, beside = squared_floor(self.reference, entry)
        relative = Relative(*pair, pair[1] ** 2, self.symbols, under(self.conditions, floor))
        worst = worst_over_domain(relative, self.domain.working(), values.point)
        if values.relative < MATTERS <= worst.relative:
            values = Comparison(*pair, self.symbols).differ_at(worst.point) or values
        return counterexample(values, entry, worst, self.symbols, measured_against(beside))


def _is_explained(verdict: Verdict) -> bool:
    """Whether it is said how the formula is right."""
    return any(remark.startswith("equal ") for remark in verdict.remarks)


def _is_plain_entry(quantity: str) -> bool:
    """Whether another quantity is named without a sign before it and a convention behind it."""
    return re.fullmatch(r"[\w.]+(?:\[[\d,:]*\])?", quantity) is not None


LIKELY = 1.4  # the cost of one slip that print is prone to: beside it, farther explanations are only noise
_WRONG = {Outcome.DIFFERS, Outcome.WRONG_DIMENSIONS}


Addition = Callable[[Verdict], Verdict]


def _with(verdict: Verdict, words: str, addition: Addition) -> Verdict:
    """The verdict with something beside it, or a remark that it failed."""
    return attempted(
        lambda: addition(verdict),
        lambda why: replace(verdict, remarks=(*verdict.remarks, f"{words} {why}")),
    )


def _without_proof(entry: Index, comparison: Comparison, domain: Domain) -> Finding:
    points = domain.sample()
    if not points:
        return Finding(entry, Outcome.UNDECIDED, reason="no point of the domain was found where it can be compared")
    found = [comparison.at(point, thorough=True) for point in points]
    if differing := [one for one in found if isinstance(one, Values)]:
        return Finding(entry, Outcome.DIFFERS, max(differing, key=lambda one: (one.relative <= TELLS, one.relative)))
    if (imaginary := next((one for one in found if isinstance(one, Imaginary)), None)) is not None:
        return Finding(entry, Outcome.DIFFERS, imaginary)
    agree, unknown = found.count(Here.AGREE), found.count(Here.UNKNOWN)
    if not agree:
        return Finding(entry, Outcome.UNDECIDED, reason="at no point of the domain do both have a real value")
    if unknown:
        reason = f"equal to 50 digits at {agree} of {agree + unknown} points; at the others it has no value"
        return Finding(entry, Outcome.UNDECIDED, reason=reason)
    return Finding(entry, Outcome.EQUAL_NUMERICALLY, reason=f"equal to 50 digits at {agree} points")


def _explained(account: Account, worst: Finding, count: int) -> str:
    """What the account adds to the reason: the convention first, then the slip."""
    if account.is_complete:
        return f", but equal{account.convention}"
    edit = account.suggestions[0].edit.removesuffix(account.convention) if account.suggestions else ""
    if account.convention:
        wrong = len(account.wrong)
        are = "is" if wrong == 1 else "are"
        entries = f"{wrong} of {count} entries {are} wrong" if count > 1 else "there is a slip"
        return f", but{account.convention} {entries}{f': {edit}' if edit else ''}"
    return f": {edit}" if edit and worst.outcome is Outcome.DIFFERS else ""


def _reason(worst: Finding, findings: Sequence[Finding], conditions: Sequence[str], sense: str) -> str:
    when = (f" when {' and '.join(conditions)}" if conditions else "") + sense
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
