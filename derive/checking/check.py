"""Compares a printed formula with the derived one and says what it found."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from functools import cached_property, partial

from radartrack.derive.algebra.equality import proved_equal
from radartrack.derive.algebra.principal_angles import equal_angles
from radartrack.derive.catalogue import UnknownQuantity, catalogue
from radartrack.derive.checking.comparing.canonical_terms import differing_terms
from radartrack.derive.checking.comparing.counterexample import (
    MATTERS,
    TELLS,
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
from radartrack.derive.checking.comparing.question_domain import Domain, everywhere
from radartrack.derive.checking.conventions.altered_question import Asked
from radartrack.derive.checking.conventions.limiting_case import limiting_case
from radartrack.derive.checking.conventions.other_quantity import other_quantities, rivals
from radartrack.derive.checking.question.compared_quantity import (
    Reference,
    UnknownEntry,
    is_formula,
    of_formula,
    refer,
    refer_to,
)
from radartrack.derive.checking.question.conditions import under
from radartrack.derive.checking.question.declared_world import having_models
from radartrack.derive.checking.question.definitions.loose_definitions import without_arguments
from radartrack.derive.checking.question.formula_units import WrongDimensions, check_dimension
from radartrack.derive.checking.question.letters.letter_readings import (
    AS_TYPED,
    Letters,
    Reading,
    Typed,
    ambiguous,
    as_typed,
    unreadable,
)
from radartrack.derive.checking.question.letters.undeclared_letters import undeclared_letters
from radartrack.derive.checking.question.letters.undeclared_letters import words as assumed
from radartrack.derive.checking.question.letters.worked_out_letters import unmeant_letters
from radartrack.derive.checking.question.names import Names, indices_in, letters_of_catalogue, symbols_for
from radartrack.derive.checking.question.printed_formula import (
    Printed,
    applying,
    conditions_for,
    doubtful_angles,
    names_for,
    read_printed,
    symbol_called,
)
from radartrack.derive.checking.question.sense import EXACTLY, Sense
from radartrack.derive.checking.question.world import CATALOGUE, World
from radartrack.derive.checking.repairing.least_to_explain import UNEXPLAINED, Account, Print
from radartrack.derive.checking.repairing.rounded_decimals import Meant, as_rounded, meant
from radartrack.derive.checking.repairing.slips_inside import Repair, Slip, has_inside
from radartrack.derive.checking.reporting.barrier import attempted
from radartrack.derive.checking.reporting.derived_formula import shown
from radartrack.derive.checking.reporting.verdict import GRAVITY, Counterexample, Outcome, Suggestion, Verdict
from radartrack.derive.evaluation.points import Point
from radartrack.derive.formula.error import FormulaError
from radartrack.derive.formula.from_expression import to_tree
from radartrack.derive.formula.printing import to_text
from radartrack.derive.formula.shape import Shape
from radartrack.derive.formula.to_expression import is_real
from radartrack.derive.formula.tree import Tree
from radartrack.derive.language.model import Model
from radartrack.derive.language.quantity import Quantity
from radartrack.derive.language.tensor import Index
from radartrack.derive.language.variable import Variable
from radartrack.derive.reading.any_letters import plain_formulas, read_loosely, without_variants
from radartrack.derive.reading.notation import LANGUAGES, LATEX, TEXT
from radartrack.derive.symbolic import Expr, Symbol, unguarded
from radartrack.derive.verbs.no_closed_form import NoClosedForm


def check(
    quantity: str | Quantity,
    formula: str,
    *,
    latex: bool = False,
    code: str = "",
    function: str = "",
    given: Mapping[str, str] | None = None,
    let: Mapping[str, str] | None = None,
    models: Iterable[Model] = (),
    world: World = CATALOGUE,
) -> Verdict:
    """Compare a printed formula with what was derived.

    Args:
        quantity: one of the catalogue or of a model of one's own, `polar.covariance.linear`; one entry of it,
            `polar.covariance.linear[0,1]`; a slice, `polar.hessian[:,0,1]`; or an expression over several. A quantity
            itself, in place of its name, is compared whole.
        formula: as typed, or as printed in LaTeX; vectors and matrices as nested lists.
        latex: whether it is LaTeX.
        code: the language, where it is code: python, c, cpp or matlab.
        function: of code, the function that is meant.
        given: conditions under which to compare, `{"rho": "0"}`.
        let: the paper's own names, `{"D_beta": "sigma_beta**2"}`.
        models: of one's own, whose quantities may be named.
        world: quantities, letters, definitions and conditions of a paper.

    Raises:
        UnknownQuantity: for a name that neither the catalogue nor a model has.
        TableError: for a model with a name of the catalogue's, and two of one name.
        UnknownEntry: for an entry that the quantity does not have.
        FormulaError: when the formula, a condition or a definition cannot be read.
    """
    world = having_models(models, world)
    try:
        question = ask(quantity, formula, latex=latex, code=code, function=function, given=given, let=let, world=world)
        *_, verdict = question.answers()
    except NoClosedForm as error:
        return too_much(quantity if isinstance(quantity, str) else quantity.name, formula, error)
    return verdict


def too_much(quantity: str, printed: str, error: NoClosedForm) -> Verdict:
    """That nothing can be decided, and the part that was too much."""
    return Verdict(Outcome.UNDECIDED, quantity, printed, "", f"cannot decide: {error}")


def ask(
    quantity: str | Quantity,
    formula: str,
    *,
    latex: bool = False,
    code: str = "",
    function: str = "",
    given: Mapping[str, str] | None = None,
    let: Mapping[str, str] | None = None,
    world: World = CATALOGUE,
    sense: Sense = EXACTLY,
) -> Question:
    """The question of `check`, whose arguments these are but for the models.

    Raises:
        NoClosedForm: when something cannot be worked out; and what `check` raises.
    """
    if isinstance(quantity, str) and is_formula(quantity) and not (latex or code):
        return ask_identity(quantity, formula, given=given, let=let, world=world, sense=sense)
    conditions, definitions = plain_formulas(given or {}), plain_formulas(let or {})
    if latex:
        conditions, definitions = without_variants(conditions), without_variants(definitions)
    every = {**world.let, **definitions}
    definitions = {name: without_arguments(text, every) for name, text in definitions.items()}
    formula = formula if code else without_arguments(formula, every)
    paper = Paper(formula, code or (LATEX if latex else TEXT), function, conditions, definitions, world, sense)
    try:
        question = paper.ask(quantity)
    except FormulaError as error:
        question = _of_another_model(paper, quantity, error)
    return replace(question, paper=paper)


def _of_another_model(paper: Paper, quantity: str | Quantity, error: FormulaError) -> Question:
    """The question of a formula in letters that the quantity does not have, where it is one of another model."""
    found = attempted(lambda: paper.ask_although_unreadable(quantity), lambda _: None)
    if found is None:
        raise attempted(lambda: paper.refusal(quantity, error), lambda _: error) from None
    return found


@dataclass(frozen=True)
class Paper:
    """A formula as it stands in print, in a notation, with what is said about it there, and in which sense."""

    formula: str
    notation: str
    function: str
    given: Mapping[str, str]
    let: Mapping[str, str]
    world: World
    sense: Sense

    def ask(self, quantity: str | Quantity) -> Question:
        """The question whether it is this quantity, in the reading of its letters that leaves the least to explain."""
        reference, typed = self._typed(quantity)
        readings = (typed.readings() if typed else []) or [AS_TYPED]
        best = _likeliest([self._question(reference, reading) for reading in readings])
        return self._with_undeclared(quantity, reference, typed, best) or best

    def _with_undeclared(
        self, quantity: str | Quantity, reference: Reference, typed: Typed | None, best: Question
    ) -> Question | None:
        """The question with declared letters read as symbols of the quantity, where so there is less to explain.

        A paper that declares an angle theta for its own model calls the azimuth of ours so too.
        """
        own = {symbol.name for part in reference.parts for symbol in part.quantity.symbols}
        letters = {name for name in self.world.letters if typed and name in typed.used and name not in own}
        if not letters or best.is_equal or any(self.world.declares(part.quantity) for part in reference.parts):
            return None
        kept = {name: one for name, one in self.world.letters.items() if name not in letters}
        try:
            other = replace(self, world=replace(self.world, letters=kept)).ask(quantity)
        except (FormulaError, NoClosedForm):
            return None
        return other if other.to_explain < best.to_explain else None

    def ask_although_unreadable(self, quantity: str | Quantity) -> Question | None:
        """The same of a formula whose letters the quantity does not have, where it is one of another model."""
        reference, typed = self._typed(quantity)
        if typed is None or self.other_model(reference) is None:
            return None
        return next((self._question(reference, reading) for reading in typed.forced()), None)

    def refusal(self, quantity: str | Quantity, error: FormulaError) -> FormulaError:
        """What to say instead of an error: why the formula cannot be read at all, or whose letters it has."""
        reference, typed = self._typed(quantity)
        why = unreadable(partial(self._read_loosely, wanted=1), reference, {**self.world.let, **self.let})
        if why is not None:
            return why.within(self.formula)
        has_letters = typed is None or typed.readings()
        likely = None if has_letters else next((one for one in rivals(reference) if self._has_units_of(one)), None)
        words = f"{error.message}. With its letters and units it may be meant for {likely}"
        return FormulaError(words, error.source, error.span) if likely else error

    def _has_units_of(self, name: str) -> bool:
        """Whether the formula can be read as this quantity, with the units of it."""
        try:
            _, typed = self._typed(name)
            return typed is not None and any(reading.fits for reading in typed.readings())
        except (FormulaError, NoClosedForm, UnknownEntry, UnknownQuantity):
            return False

    def other_model(self, reference: Reference) -> Question | None:
        """The question whether it is the same thing in another model, if it is."""
        return next((found for name in rivals(reference) if (found := self._right(name)) is not None), None)

    def _right(self, name: str) -> Question | None:
        """The question whether it is this quantity, if it is."""
        try:
            reference, typed = self._typed(name)
            readings = (typed.readings() if typed else []) or [AS_TYPED]
            right = (self._question(reference, one) for one in readings if one.fits and not one.wrong)
            return next((question for question in right if question.is_equal), None)
        except (FormulaError, NoClosedForm, UnknownEntry, UnknownQuantity):
            return None

    def _typed(self, quantity: str | Quantity) -> tuple[Reference, Typed | None]:
        """What is compared with, and the formula before it is known what its names mean, where it can be read then."""
        definitions = {**self.world.let, **self.let}
        reference = refer_to(quantity) if isinstance(quantity, Quantity) else refer(quantity, self.world, definitions)
        conditions: Mapping[Symbol, Expr] = {}
        with suppress(FormulaError):  # in letters of the paper, or wrong: then it is told where the question is asked
            conditions = conditions_for(reference, self.given)
        symbols = symbols_for([], {}, self.world, [part.quantity for part in reference.parts])
        declared = {name: symbols[name] for name in self.world.letters}
        known = reference.with_symbols(declared.values())
        is_code = self.notation in LANGUAGES
        size = math.prod(known.shape) if len(known.shape) == 1 else 1
        read = partial(self._read_loosely, wanted=size)
        typed = as_typed(read, known, definitions, conditions, declared, row_by_row=is_code)
        return reference, typed or self._typed_when_worked_out(known, conditions, declared)

    def _typed_when_worked_out(
        self, reference: Reference, conditions: Mapping[Symbol, Expr], declared: Mapping[str, Variable]
    ) -> Typed | None:
        """What comes out of a formula in letters of its own, where something in it is worked out."""
        read = partial(self._read_loosely, wanted=1)
        letters = unmeant_letters(read, reference, {**self.world.let, **self.let}, declared)
        if not letters:
            return None
        try:
            printed = self._printed(reference, letters)
            entries = printed.expressions.map(lambda entry: to_tree(unguarded(entry)))
        except (FormulaError, NoClosedForm):
            return None
        return Typed(reference, entries, {}, conditions, declared, letters)

    def _read_loosely(self, names: Sequence[str], shapes: Mapping[str, Shape], wanted: int) -> Tree:
        return read_loosely(self.formula, names, self.notation, self.function, shapes, wanted)

    def _question(self, reference: Reference, reading: Reading) -> Question:
        printed = self._printed(reference, {**reading.vanished, **reading.letters})
        reference = reference.with_symbols(printed.names.symbols.values())
        question = asked(reference, printed, self.given, self.world, self.sense)
        return replace(question, reading=reading)

    def _printed(self, reference: Reference, letters: Letters) -> Printed:
        """The formula with the letters read so."""
        texts = [self.formula if self.notation == TEXT else "", *self.given.values()]
        indices = indices_in(self.formula, {**self.world.let, **self.let}, self.notation, self.function)
        names = names_for(reference, self.let, self.world, texts, letters, indices)
        return read_printed(self.formula, names, reference.shape, self.notation, self.function)


def _likeliest(questions: Sequence[Question]) -> Question:
    """The question whose reading of the letters leaves the least to explain.

    Raises:
        FormulaError: where nothing explains what is wrong, and several readings are as likely as each other.
    """
    if len(questions) == 1:
        return questions[0]
    best, *others = sorted(questions, key=lambda one: (one.to_explain, one.reading.wrong, one.reading.rank))
    alike = [one.reading for one in others if one.reading.rank == best.reading.rank and best.to_explain >= UNEXPLAINED]
    if alike:
        raise ambiguous([best.reading, *alike])
    return best


def asked(reference: Reference, printed: Printed, given: Mapping[str, str], world: World, sense: Sense) -> Question:
    """A formula as it was read, compared with that; raises as `ask`."""
    names = printed.names
    both = {**applying(world.given, reference, printed), **given} if world.given else given
    conditions = conditions_for(reference, both, names)
    if sense == EXACTLY and (limit := _limit_of(reference, conditions)):
        rest = {name: text for name, text in both.items() if str(symbol_called(name, names, reference)) not in limit}
        with suppress(FormulaError, NoClosedForm):
            return asked(reference, printed, rest, world, Sense(limit=limit))
    printed = replace(printed, remarks=(*printed.remarks, *doubtful_angles(reference, both, names)))
    reference, printed = (
        sense.applied(reference, printed, names, conditions) if sense != EXACTLY else (reference, printed)
    )
    question = Question(reference, printed, conditions, sense.words)
    for exact in _exact_numbers(question):
        if (rounded := replace(question, printed=exact.printed)).is_equal:
            return replace(rounded, rounding=Rounding(question.printed.text, exact.words))
    return question


def _limit_of(reference: Reference, conditions: Mapping[Symbol, Expr]) -> dict[str, str]:
    """Where symbols go, of conditions under which what was derived has no value, only perhaps a limit."""
    numbers = {symbol: value for symbol, value in conditions.items() if not value.free_symbols}
    singular = {
        symbol: value
        for symbol, value in numbers.items()
        if not all(is_real(under({symbol: value}, entry)) for entry in reference.entries)
    }
    return {str(symbol): to_text(to_tree(value)) for symbol, value in singular.items()}


def _exact_numbers(question: Question) -> Iterator[Meant]:
    """The formula with exact numbers for its rounded decimals."""
    if exact := meant(question.printed):
        yield exact
    if not question.reference.shape and (exact := as_rounded(question.printed, question.derived_entry(()))):
        yield exact


def ask_identity(
    left: str,
    right: str,
    *,
    given: Mapping[str, str] | None = None,
    let: Mapping[str, str] | None = None,
    world: World = CATALOGUE,
    sense: Sense = EXACTLY,
    alike: Sequence[str] = (),
) -> Question:
    """Whether two formulas of a paper are the same; what is printed is the right one, compared with the left one.

    Args:
        left: in the paper's letters, and with quantities by name; matrices with verbs or as nested lists.
        right: likewise.
        given: conditions.
        let: definitions.
        world: the paper's.
        sense: in which they are.
        alike: all formulas that are said to be the same, where there are more: they tell the units of letters of which
            the paper says nothing.

    Raises:
        FormulaError, UnknownQuantity: when something cannot be read.
        NoClosedForm: when something cannot be worked out.
    """
    given, let = plain_formulas(given or {}), plain_formulas(let or {})
    definitions = {**world.let, **let}
    texts = [left, right, *given.values(), *let.values()]
    symbols = {**letters_of_catalogue(texts, definitions), **symbols_for(texts, definitions, world, of_models=True)}
    names = Names(symbols, definitions, world)
    letters = undeclared_letters(alike or [left, right], names, world.letters)
    names = names.with_symbols(letters)
    reference = of_formula(left, names).with_symbols(names.symbols.values())
    printed = read_printed(right, names.fixing(names.tree(left)), reference.shape)
    remarks = (*printed.remarks, *([assumed(letters)] if letters else []))
    return asked(reference, replace(printed, remarks=remarks), given, world, sense)


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
    paper: Paper | None = None
    where: Callable[[Point], bool] = everywhere

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
        return all(self.finding(entry).outcome in GRAVITY[:2] for entry, _ in self.printed.entries.items())

    @cached_property
    def domain(self) -> Domain:
        """Where the formulas are compared."""
        return Domain(self.symbols, self.conditions, where=self.where)

    def answers(self) -> Iterator[Verdict]:
        """The verdict on all entries together, the gravest of them; then again and again, each with more beside it.

        What is said beside it takes longest, and may fail: the verdict is known before.
        """
        findings = [self.finding(entry) for entry, _ in self.printed.entries.items()]
        worst = max(findings, key=lambda finding: GRAVITY.index(finding.outcome))
        conditions = tuple(f"{symbol} = {value}" for symbol, value in self.conditions.items())
        wrong = [finding for finding in findings if finding.outcome in _WRONG]
        verdict = Verdict(
            verdict=worst.outcome,
            quantity=self.reference.text,
            printed=self.printed.text,
            derived="",
            reason=_reason(worst, findings, conditions, self.sense),
            counterexample=_example(worst, self.symbols) if wrong else None,
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
        """What does not fit in the dimensions of an entry; nothing where they do."""
        try:
            check_dimension(
                self.printed.names.dimension_of(self.printed.entries[entry]), self.reference.dimension(entry)
            )
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
        """The same thing in another model that the formula is, in whatever letters."""
        found = self.paper.other_model(self.reference) if self.paper and not self.reading.fits else None
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
        findings = [self.finding(entry) for entry, _ in self.printed.entries.items()]
        wrong = tuple(one.entry for one in findings if one.outcome in _WRONG)
        account = self._print.account(wrong)
        unexplained = not account.suggestions and not account.convention
        slips = [] if account.is_complete else attempted(lambda: self._slips_inside(plain=unexplained), lambda _: [])
        if not slips or slips[0].cost > account.cost:
            return account
        inside = (Suggestion(slip.formula, slip.words, definition=slip.definition) for slip in slips)
        edits = () if account.convention or len(wrong) > 1 else account.suggestions
        return Account("", wrong, (*inside, *edits), slips[0].cost)

    def _slips_inside(self, *, plain: bool) -> list[Slip]:
        """Slips inside of what is worked out, of which each explains all that is wrong: no edit of an entry can.

        In plain definitions too where nothing else explains it: floating point does not see all that is wrong there.
        """
        is_inside = has_inside(self.printed) or (plain and bool(self.printed.names.definitions))
        if not (self._is_compared and is_inside):
            return []
        derived = self.reference.entries.map(lambda entry: under(self.conditions, entry))
        return Repair(self.printed, self.printed.names, derived, self.symbols, self.conditions).slips()

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
