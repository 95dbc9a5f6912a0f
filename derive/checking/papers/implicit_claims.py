"""Decides claims about quantities that equations define: a printed solution is right when it satisfies them.

Nothing is solved. The solution is put into each equation, which is then proved to vanish; of several solutions the
conditions tell the one that is meant, at points of the domain. A condition in which no unknown occurs says where the
solution is to hold.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import pairwise

import mpmath

from radartrack.derive import symbolic as sp
from radartrack.derive.algebra.branch_of_root import vanishes_on_a_branch
from radartrack.derive.algebra.equality import proved_equal
from radartrack.derive.checking.answers import Finding, Question
from radartrack.derive.checking.comparing.counterexample import example
from radartrack.derive.checking.comparing.question_domain import Domain, everywhere
from radartrack.derive.checking.papers.claim import Claim
from radartrack.derive.checking.question.compared_quantity import Reference
from radartrack.derive.checking.question.conditions import under
from radartrack.derive.checking.question.definitions.loose_definitions import WORD
from radartrack.derive.checking.question.formula_units import NOTHING
from radartrack.derive.checking.question.meaning import Meaning, shape_of, tensor
from radartrack.derive.checking.question.names import Names, letters_of_catalogue, symbols_for
from radartrack.derive.checking.question.printed_formula import conditions_for, printed
from radartrack.derive.checking.question.world import ImplicitDefinition, World
from radartrack.derive.checking.repairing.reworked_edits import edits_that
from radartrack.derive.checking.reporting.barrier import attempted
from radartrack.derive.checking.reporting.verdict import GRAVITY, Counterexample, Outcome, Suggestion, Verdict
from radartrack.derive.evaluation.many_digits import Evaluator
from radartrack.derive.evaluation.points import Point, generic_points
from radartrack.derive.formula.error import FormulaError
from radartrack.derive.formula.printing import to_text
from radartrack.derive.formula.to_expression import Expression
from radartrack.derive.formula.tree import Tree
from radartrack.derive.language.tensor import Index, Tensor
from radartrack.derive.language.variable import Variable
from radartrack.derive.symbolic import Expr, Symbol
from radartrack.derive.units import ONE

_NAME = re.compile(r"(?P<name>[\w.]+?)\s*(?:\[\s*(?P<place>\d{1,2})\s*\])?")
_COMPARED = re.compile(r"(<=|>=|<|>)")
SMALL = 1e-25  # what is left of nothing in many digits, relative to what an equation is made of
MOST_EQUATIONS, MOST_TERMS, HIGHEST_DEGREE = 4, 12, 3  # of which a contradiction is looked for
POINTS = 3  # at which edits are screened


def asked_of_equations(claim: Claim, world: World) -> tuple[ImplicitDefinition, int | None] | None:
    """The definition that a claim is about, and which of its unknown; None where it is about something else."""
    found = _NAME.fullmatch(claim.quantity.strip())
    if found is None or found["name"] not in world.implicit:
        return None
    definition, place = world.implicit[found["name"]], found["place"]
    if place is not None and int(place) >= len(definition.unknown):
        raise FormulaError(f"{claim.quantity}: the unknown of {definition.name} are {', '.join(definition.unknown)}")
    return definition, int(place) if place is not None else None


def solution_verdicts(
    claim: Claim, definition: ImplicitDefinition, place: int | None, world: World
) -> Iterator[Verdict]:
    """The verdict on a printed solution, then the same with what was perhaps meant.

    Raises:
        FormulaError, UnknownQuantity: when the solution, an equation or a condition cannot be read.
        NoClosedForm: when one cannot be worked out.
    """
    solution = _read(claim, definition, place, world)
    if words := solution.says_nothing:
        yield solution.verdict(Outcome.UNDECIDED, words)
        return
    yield from solution.answers()


def _read(claim: Claim, definition: ImplicitDefinition, place: int | None, world: World) -> _Solution:
    let = {**world.let, **claim.let}
    others = {name: text for name, text in claim.given.items() if name in definition.unknown}
    given = {name: text for name, text in claim.given.items() if name not in others}
    texts = [claim.formula, *definition.equations, *definition.where, *claim.given.values(), *claim.let.values()]
    symbols = {
        **letters_of_catalogue(texts, let),
        **symbols_for(texts, let, world, of_models=True),
        **definition.symbols,
    }
    names = Names({name: one for name, one in symbols.items() if name not in definition.unknown}, let, world)
    names = _narrowed(names, definition)
    tree = names.tree(claim.formula or claim.latex, latex=bool(claim.latex))
    chosen = definition.unknown if place is None else (definition.unknown[place],)
    missing = [name for name in definition.unknown if name not in {*chosen, *others}]
    if missing:
        raise FormulaError(f"given {missing[0]}: it is missing; one unknown is checked with the others given")
    beside = {name: _meaning(names.tree(text), names) for name, text in others.items()}
    return _Solution(claim, definition, names, tree, chosen, beside, given, world.given)


@dataclass(frozen=True)
class _Solution:
    """A printed solution in its equations.

    Attributes:
        claim: the claim.
        definition: the equations.
        names: what formulas may use beside the unknown.
        tree: the solution as it is printed.
        chosen: the unknown that it gives.
        beside: the others.
        given: the conditions of the claim.
        given_in_file: and those of its file.
    """

    claim: Claim
    definition: ImplicitDefinition
    names: Names
    tree: Tree
    chosen: tuple[str, ...]
    beside: Mapping[str, Meaning]
    given: Mapping[str, str]
    given_in_file: Mapping[str, str]

    def verdict(
        self,
        outcome: Outcome,
        reason: str,
        example: Counterexample | None = None,
        suggestions: tuple[Suggestion, ...] = (),
    ) -> Verdict:
        """The verdict with these words."""
        conditions = tuple(f"{symbol} = {value}" for symbol, value in self._conditions.items())
        return Verdict(
            outcome, self.claim.quantity, to_text(self.tree), "", reason, example, suggestions, conditions=conditions
        )

    def answers(self) -> Iterator[Verdict]:
        """What is found of the equations, then of the conditions."""
        questions = self._questions(self._values(self.tree))
        findings = [
            (question, _found(question, entry)) for question in questions for entry in question.printed.entries.indices
        ]
        question, worst = max(findings, key=lambda pair: GRAVITY.index(pair[1].outcome))
        if worst.outcome in (Outcome.DIFFERS, Outcome.WRONG_DIMENSIONS):
            told = worst.reason if worst.outcome is Outcome.WRONG_DIMENSIONS else "it is not satisfied"
            wrong = self.verdict(
                worst.outcome,
                f"{question.reference.text}: {told}",
                example(worst.values, worst.entry, question.symbols),
            )
        elif (found := self.against_conditions()) is not None:
            wrong = found
        else:
            yield self._right(worst, len(questions))
            return
        yield wrong
        if wrong.verdict is not Outcome.UNDECIDED and (edits := attempted(self._edits, lambda _: ())):
            reason = f"{wrong.reason}: {edits[0].edit}" if wrong.verdict is Outcome.DIFFERS else wrong.reason
            yield self.verdict(wrong.verdict, reason, wrong.counterexample, edits)

    def _right(self, worst: Finding, count: int) -> Verdict:
        equations = "the equation" if count == 1 else f"all {count} equations"
        told = {
            Outcome.EQUAL: f"satisfies {equations}, by proof",
            Outcome.EQUAL_NUMERICALLY: f"satisfies {equations}: {worst.reason}, not proved",
            Outcome.UNDECIDED: worst.reason,
        }[worst.outcome]
        where = f"; {' and '.join(self.definition.where)} where it was tried" if self.definition.where else ""
        return self.verdict(worst.outcome, told + (where if worst.outcome is not Outcome.UNDECIDED else ""))

    @cached_property
    def says_nothing(self) -> str:
        """That everything satisfies the equations, or nothing; empty where they say something."""
        values = self._values(self.tree)
        unknown = {name: _letters(name, one.value) for name, one in values.items()}
        letters = {symbol for value in unknown.values() for symbol in tensor(value) if isinstance(symbol, Variable)}
        names = self.names.knowing({name: Meaning(value, lambda _: NOTHING) for name, value in unknown.items()})
        said: list[Expr] = []
        for text in self.definition.equations:
            for entry in tensor(names.worked_out(_difference(text, names))):
                rest = sp.expand(under(self._conditions, entry))
                if rest.free_symbols & letters:
                    said.append(rest)
                elif not proved_equal(rest, sp.Integer(0)):
                    return f"nothing satisfies the equation {text}: no unknown is left in it, and it is not zero"
        if not said:
            return f"everything satisfies the equations of {self.definition.name}: they say nothing"
        if attempted(lambda: _contradict(said, sorted(letters, key=str)), lambda _: False):
            return f"nothing satisfies the equations of {self.definition.name} together"
        return ""

    @cached_property
    def _conditions(self) -> dict[Symbol, Expr]:
        question = self._questions(self._values(self.tree), {})[0].reference
        question = question.with_symbols(self.names.symbols.values())
        of_file = {name: text for name, text in self.given_in_file.items() if name in self.definition.symbols}
        return conditions_for(question, {**of_file, **self.given}, self.names)

    def _values(self, tree: Tree) -> dict[str, Meaning]:
        """What each unknown is worth."""
        entries, opened = self.names.entries(tree)
        if len(self.chosen) == 1 and entries.shape != (1,):
            return {**self.beside, self.chosen[0]: _meaning(tree, self.names)}
        if entries.shape != (len(self.chosen),):
            raise FormulaError(
                f"the formula must be a vector of {len(self.chosen)} entries: {', '.join(self.chosen)}", span=tree.span
            )
        found = {name: _meaning(entry, opened) for name, entry in zip(self.chosen, entries, strict=True)}
        return {**self.beside, **found}

    def _questions(
        self, values: Mapping[str, Meaning], conditions: Mapping[Symbol, Expr] | None = None
    ) -> list[Question]:
        """For each equation whether it vanishes."""
        names = self.names.knowing(values)
        if conditions is not None:
            return [_vanishing(text, tree, names, conditions) for text, tree in self._equations.items()]
        vanishing = (_vanishing(text, tree, names, self._conditions) for text, tree in self._equations.items())
        return [replace(question, where=self._restriction(question.symbols)) for question in vanishing]

    @cached_property
    def _equations(self) -> dict[str, Tree]:
        """The equations as they are read, which is done once for all that is tried as a solution."""
        names = self.names.knowing(self._values(self.tree))
        return {text: _difference(text, names) for text in self.definition.equations}

    def against_conditions(self) -> Verdict | None:
        """The verdict where a condition does not hold; None where all do."""
        names = self.names.knowing(self._values(self.tree))
        for text in self.definition.where:
            if text in self._restrictions:
                continue
            formulas, signs = _compared(text, names, self._conditions)
            symbols = _variables([*formulas, *(one for own, _ in self._restrictions.values() for one in own)], names)
            tried = 0
            for point in Domain(symbols, self._conditions, where=self._restriction(symbols)).sample():
                worth = _worth(formulas, symbols, point)
                tried += worth is not None
                if worth is not None and not _holds(worth, signs):
                    return self._not_meant(text, symbols, point)
            if not tried:
                return self.verdict(Outcome.UNDECIDED, f"the condition {text} has a value at no point that was tried")
        return None

    @cached_property
    def _restrictions(self) -> dict[str, tuple[list[Expr], list[str]]]:
        """The conditions in which no unknown occurs, by their texts: what is compared in them, and the signs."""
        restrict = [
            text for text in self.definition.where if not set(WORD.findall(text)) & set(self.definition.unknown)
        ]
        return {text: _compared(text, self.names, self._conditions) for text in restrict}

    def _restriction(self, symbols: Sequence[Variable]) -> Callable[[Point], bool]:
        """Whether those conditions hold at a point that have a value there."""
        own = [
            (formulas, signs)
            for formulas, signs in self._restrictions.values()
            if set(_variables(formulas, self.names)) <= set(symbols)
        ]

        def holds(point: Point) -> bool:
            values = ((_worth(formulas, symbols, point), signs) for formulas, signs in own)
            return all(worth is not None and _holds(worth, signs) for worth, signs in values)

        return holds if own else everywhere

    def _not_meant(self, text: str, symbols: Sequence[Variable], point: Point) -> Verdict:
        where = ", ".join(f"{symbol} = {point[symbol.name]:.6g}" for symbol in symbols)
        at = f" at {where}" if where else ""
        return self.verdict(Outcome.DIFFERS, f"the condition {text} does not hold{at}: another solution is meant")

    def _edits(self) -> tuple[Suggestion, ...]:
        """What makes the solution satisfy everything."""
        found = edits_that(self._is_right, self.tree, self.names.dimensions)
        return tuple(Suggestion(to_text(one.tree), one.words) for one in found)

    def _is_right(self, tree: Tree) -> bool:
        questions = self._questions(self._values(tree))
        for question in questions:
            for entry in question.printed.expressions:
                if not _vanishes_roughly(under(self._conditions, entry), question.symbols):
                    return False
        changed = replace(self, tree=tree)
        proved = all(
            vanishes_on_a_branch(under(self._conditions, entry))
            for question in questions
            for entry in question.printed.expressions
        )
        return proved and changed.against_conditions() is None


def _narrowed(names: Names, definition: ImplicitDefinition) -> Names:
    """The names, with symbols that lie where a condition compares them with numbers: n > 0, 0 < alpha < 1."""
    ends: dict[Variable, tuple[float, float]] = {}
    for text in _restricting(definition):
        formulas, signs = _compared(text, names, {})
        for (first, second), sign in zip(pairwise(formulas), signs, strict=True):
            small, large = (first, second) if "<" in sign else (second, first)
            if isinstance(small, Variable) and large.is_number:
                low, high = ends.get(small, (small.low, small.high))
                ends[small] = low, min(high, float(large))
            elif isinstance(large, Variable) and small.is_number:
                low, high = ends.get(large, (large.low, large.high))
                ends[large] = max(low, float(small)), high
    for symbol, (low, high) in ends.items():
        if not low < high:
            raise FormulaError(f"where: {' and '.join(definition.where)} leaves {symbol} no value")
    return names.with_symbols({symbol.name: symbol.on(low, high) for symbol, (low, high) in ends.items()})


def _restricting(definition: ImplicitDefinition) -> list[str]:
    """The conditions in which no unknown occurs."""
    return [text for text in definition.where if not set(WORD.findall(text)) & set(definition.unknown)]


def _compared(text: str, names: Names, conditions: Mapping[Symbol, Expr]) -> tuple[list[Expr], list[str]]:
    """What a condition compares, and the signs between."""
    parts = _COMPARED.split(text)
    if len(parts) == 1:
        raise FormulaError(f"where: {text} compares nothing; a condition has < or >, such as 0 < alpha")
    return [under(conditions, names.read(names.tree(part))) for part in parts[::2]], parts[1::2]


def _found(question: Question, entry: Index) -> Finding:
    """What is found of an entry of an equation; points tell the sign of a root, and a proof the rest."""
    finding = question.finding(entry)
    on_branch = finding.outcome is Outcome.EQUAL_NUMERICALLY and attempted(
        lambda: vanishes_on_a_branch(question.printed_entry(entry)), lambda _: False
    )
    return Finding(entry, Outcome.EQUAL) if on_branch else finding


def _meaning(tree: Tree, names: Names) -> Meaning:
    entries, opened = names.entries(tree)
    return Meaning(names.worked_out(tree), lambda index: opened.dimension_of(entries[index]))


def _difference(text: str, names: Names) -> Tree:
    """What must vanish: an equation that has two sides, or one."""
    left, sign, right = text.partition("=")
    return names.tree(f"({left}) - ({right})" if sign else text)


def _vanishing(text: str, tree: Tree, names: Names, conditions: Mapping[Symbol, Expr]) -> Question:
    entries, _ = names.entries(tree)
    residual = printed(tree, names, entries.shape)
    shown = text if "=" in text else f"{text} = 0"
    reference = Reference(
        shown,
        entries.shape,
        tuple(_variables([*residual.expressions, *conditions.values(), *conditions], names)),
        (),
        lambda _: sp.Integer(0),
        lambda _: NOTHING,
    )
    return Question(reference, residual, conditions)


def _contradict(equations: Sequence[Expr], letters: Sequence[Symbol]) -> bool:
    """Whether small polynomials in the unknown have no common zero, whatever the parameters are: they give one."""
    # coefficients that are no polynomials, such as sines, may depend on each other
    small = all(one.is_polynomial(*one.free_symbols) for one in equations) and all(
        len(sp.Add.make_args(one)) <= MOST_TERMS and sp.Poly(one, *letters).total_degree() <= HIGHEST_DEGREE
        for one in equations
    )
    if not small or not 2 <= len(equations) <= MOST_EQUATIONS or len(letters) > MOST_EQUATIONS:
        return False
    return sp.groebner(equations, *letters).exprs == [sp.Integer(1)]


def _letters(name: str, value: Expression) -> Expression:
    """A symbol for each entry of an unknown."""
    shape = shape_of(value)
    if not shape:
        return Variable(name, name, ONE, -1e6, 1e6)

    def rows(index: tuple[int, ...]) -> Expression:
        if len(index) == len(shape):
            return Variable(f"{name}_{'_'.join(map(str, index))}", name, ONE, -1e6, 1e6)
        return tuple(rows((*index, place)) for place in range(shape[len(index)]))

    return rows(())


def _variables(formulas: Sequence[Expr], names: Names) -> list[Variable]:
    """The symbols of formulas, with the domains that the names say: what SymPy keeps may hold another domain's."""
    found = {symbol for formula in formulas for symbol in formula.free_symbols if isinstance(symbol, Variable)}
    known = {symbol: symbol for symbol in names.symbols.values()}
    return sorted((known.get(symbol, symbol) for symbol in found), key=str)


def _worth(formulas: Sequence[Expr], symbols: Sequence[Variable], point: Point) -> list[float] | None:
    try:
        found = Evaluator(Tensor((len(formulas),), tuple(formulas)), symbols)([point[one.name] for one in symbols])
    except (ArithmeticError, ValueError):
        return None
    if any(isinstance(value, mpmath.mpc) for value in found):
        return None
    return list(found)


def _holds(values: Sequence[float], signs: Sequence[str]) -> bool:
    compare = {"<": lambda a, b: a < b, ">": lambda a, b: a > b, "<=": lambda a, b: a <= b, ">=": lambda a, b: a >= b}
    return all(compare[sign](a, b) for sign, a, b in zip(signs, values, values[1:], strict=False))


def _vanishes_roughly(entry: Expr, symbols: Sequence[Variable]) -> bool:
    """Whether an expression is zero at some points, as far as many digits tell."""
    terms = [sp.Add(*(sp.Abs(term) for term in sp.Add.make_args(entry)))]
    for point in generic_points(symbols, POINTS):
        worth = _worth([entry, *terms], symbols, point)
        if worth is None or abs(worth[0]) > SMALL * abs(worth[1]):
            return False
    return True
