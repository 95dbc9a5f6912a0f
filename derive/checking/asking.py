"""Asks whether a printed formula is a quantity, in the reading of its letters that leaves the least to explain."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field, replace
from functools import partial

from radartrack.derive.catalogue import UnknownQuantity
from radartrack.derive.checking.answers import Question, Rounding
from radartrack.derive.checking.conventions.other_quantity import rivals
from radartrack.derive.checking.question.compared_quantity import (
    Reference,
    UnknownEntry,
    is_formula,
    of_formula,
    refer,
    refer_to,
)
from radartrack.derive.checking.question.conditions import under
from radartrack.derive.checking.question.definitions.loose_definitions import (
    LooseDefinitions,
    without_arguments,
    without_function_arguments,
)
from radartrack.derive.checking.question.letters.array_letters import array_letters
from radartrack.derive.checking.question.letters.axis_letters import Axis, axes_of
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
from radartrack.derive.checking.repairing.least_to_explain import UNEXPLAINED
from radartrack.derive.checking.repairing.rounded_decimals import Meant, as_rounded, meant
from radartrack.derive.checking.reporting.barrier import attempted
from radartrack.derive.formula.error import FormulaError
from radartrack.derive.formula.from_expression import to_tree
from radartrack.derive.formula.printing import to_text
from radartrack.derive.formula.shape import Shape
from radartrack.derive.formula.to_expression import is_real
from radartrack.derive.formula.tree import Tree
from radartrack.derive.formula.written_out import array_of, written_out
from radartrack.derive.language.quantity import Quantity
from radartrack.derive.language.variable import Variable
from radartrack.derive.reading.any_letters import plain_formulas, read_loosely, without_variants
from radartrack.derive.reading.notation import LANGUAGES, LATEX, TEXT
from radartrack.derive.reading.tex.latex_arguments import AmbiguousArgument
from radartrack.derive.symbolic import Expr, Symbol, unguarded
from radartrack.derive.verbs.no_closed_form import NoClosedForm


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
        return _of_any_model(paper, quantity)
    except AmbiguousArgument as error:
        return _with_brackets(paper, quantity, error)


def _of_any_model(paper: Paper, quantity: str | Quantity) -> Question:
    try:
        return paper.ask(quantity)
    except AmbiguousArgument:
        raise
    except FormulaError as error:
        return _of_another_model(paper, quantity, error)


def _with_brackets(paper: Paper, quantity: str | Quantity, error: AmbiguousArgument) -> Question:
    """The question of a formula with brackets around the arguments of functions, where only one way explains it.

    Raises:
        AmbiguousArgument: where none does, or several do as well.
    """
    questions = []
    for formula in error.readings:
        with suppress(FormulaError, NoClosedForm):
            questions.append(_of_any_model(replace(paper, formula=formula, notation=LATEX), quantity))
    fitting = [question for question in questions if question.has_units]
    if len(fitting) == 1 or any(question.is_equal for question in fitting):
        return next((question for question in fitting if question.is_equal), fitting[0])
    best = sorted(fitting, key=lambda question: question.to_explain)
    if not best or best[0].to_explain >= min([UNEXPLAINED, *(question.to_explain for question in best[1:])]):
        raise error.within(paper.formula)
    return best[0]


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
    arrays: Mapping[str, str] = field(default_factory=dict)

    def ask(self, quantity: str | Quantity) -> Question:
        """The question whether it is this quantity, in the reading of its letters that leaves the least to explain.

        Letters for arrays are taken for such only where without it nothing can be read, or the formula is wrong.
        """
        try:
            best = self._asked(quantity)
        except FormulaError:
            found = self._with_arrays(quantity, None) or self._of_axes(quantity)
            if found is None:
                raise
            return found
        return self._with_arrays(quantity, best) or best

    def _with_arrays(self, quantity: str | Quantity, best: Question | None) -> Question | None:
        """The question with letters for arrays of the quantity's symbols, where so there is less to explain."""
        arrays = {} if self.arrays or self.notation in LANGUAGES else self._array_letters(quantity)
        if not arrays or (best is not None and best.is_equal):
            return None
        other = replace(self, let={**self.let, **arrays}, arrays=arrays)
        if best is not None:
            return other.likelier(quantity, best)
        with suppress(FormulaError, NoClosedForm):
            return other.ask(quantity)
        return None

    def _of_axes(self, quantity: str | Quantity) -> Question | None:
        """The question of the first block that is wrong, where a matrix has one for each axis, in its own letters."""
        question: Question | None = None
        axes = self._axes(quantity)
        for axis in axes:
            alone = replace(self, formula=to_text(array_of(axis.block)), notation=TEXT, function="")
            question = alone.ask(quantity)
            if not question.is_equal or len(axes) == 1:
                return _noted(question, axis.words)
        return _noted(question, f"each of {len(axes)} axes is read alone") if question else None

    def _axes(self, quantity: str | Quantity) -> list[Axis]:
        with suppress(FormulaError, NoClosedForm, UnknownEntry, UnknownQuantity, ValueError):
            reference = refer_to(quantity) if isinstance(quantity, Quantity) else refer(quantity, self.world, self.let)
            definitions = {**self.world.let, **self.let}
            own = [*(symbol.name for symbol in reference.symbols), *self.world.letters]
            known = LooseDefinitions(definitions, own)
            read = self._read_loosely([*own, *definitions], known.shapes, _size(reference.shape))
            entries = written_out(read, known.arrays)
            return axes_of(entries, reference.shape, {*own, *definitions}) if entries is not None else []
        return []

    def _array_letters(self, quantity: str | Quantity) -> dict[str, str]:
        with suppress(FormulaError, NoClosedForm, UnknownEntry, UnknownQuantity):
            reference = refer_to(quantity) if isinstance(quantity, Quantity) else refer(quantity, self.world, self.let)
            taken = {*self.let, *self.world.let, *self.world.letters}
            return array_letters({symbol.name for symbol in reference.symbols}, self.formula, taken)
        return {}

    def _asked(self, quantity: str | Quantity) -> Question:
        reference, typed = self._typed(quantity)
        readings = (typed.readings() if typed else []) or [AS_TYPED]
        best = _likeliest([self._question(reference, reading) for reading in readings])
        return self._with_undeclared(quantity, reference, typed, best) or self._with_functions(quantity, best) or best

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
        return replace(self, world=replace(self.world, letters=kept)).likelier(quantity, best)

    def _with_functions(self, quantity: str | Quantity, best: Question) -> Question | None:
        r"""The question with N(\phi) as a function and no product, where so there is less to explain."""
        plain = without_function_arguments(self.formula) if self.notation == LATEX else self.formula
        if plain == self.formula or best.is_equal:
            return None
        return replace(self, formula=plain).likelier(quantity, best)

    def likelier(self, quantity: str | Quantity, best: Question) -> Question | None:
        """The question, where it leaves less to explain than another one."""
        try:
            other = self.ask(quantity)
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
        read = partial(self._read_loosely, wanted=_size(reference.shape))
        why = unreadable(read, reference, {**self.world.let, **self.let})
        if why is not None and self._axes(quantity):
            return error
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
        read = partial(self._read_loosely, wanted=_size(known.shape))
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
        return replace(question, reading=reading, other_model=self.other_model)

    def _printed(self, reference: Reference, letters: Letters) -> Printed:
        """The formula with the letters read so."""
        texts = [self.formula if self.notation == TEXT else "", *self.given.values()]
        indices = indices_in(self.formula, {**self.world.let, **self.let}, self.notation, self.function)
        names = names_for(reference, self.let, self.world, texts, letters, indices)
        found = read_printed(self.formula, names, reference.shape, self.notation, self.function)
        read = tuple(f"{name} is read as {array}" for name, array in self.arrays.items())
        return replace(found, remarks=(*found.remarks, *read)) if read else found


def _size(shape: Sequence[int]) -> int:
    """How many numbers a formula is to be: as many as a vector has, else one."""
    return math.prod(shape) if len(shape) == 1 else 1


def _noted(question: Question, words: str) -> Question:
    return replace(question, printed=replace(question.printed, remarks=(*question.printed.remarks, words)))


def _likeliest(questions: Sequence[Question]) -> Question:
    """The question whose reading of the letters leaves the least to explain.

    Raises:
        FormulaError: where nothing explains what is wrong, and several readings are as likely as each other.
    """
    if len(questions) == 1:
        return questions[0]
    considered: list[Question] = []
    for question in questions:
        least = min((one.to_explain for one in considered), default=math.inf)
        considered.append(replace(question, most=least))
    best, *others = sorted(considered, key=lambda one: (one.to_explain, one.reading.wrong, one.reading.rank))
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
