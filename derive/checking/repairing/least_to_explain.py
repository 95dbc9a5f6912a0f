"""The account of a wrong print that leaves the least to explain: a convention, slips, or slips in a convention."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import islice

from radartrack.derive.algebra.equality import proved_equal
from radartrack.derive.checking.conventions.altered_question import Asked
from radartrack.derive.checking.conventions.explanation import Explanation, explanations
from radartrack.derive.checking.conventions.other_quantity import siblings
from radartrack.derive.checking.question.conditions import also_zero, under, when_zero
from radartrack.derive.checking.question.names import Names
from radartrack.derive.checking.question.printed_formula import Printed
from radartrack.derive.checking.repairing.definition_slips import Formula, mended_definitions
from radartrack.derive.checking.repairing.smallest_edit import suggest
from radartrack.derive.checking.reporting.barrier import attempted
from radartrack.derive.checking.reporting.verdict import Suggestion
from radartrack.derive.formula.tree import Name, Tree, names, walk
from radartrack.derive.language.tensor import Index, Tensor
from radartrack.derive.language.variable import Variable
from radartrack.derive.symbolic import Expr, Symbol

SHOWN_ENTRIES = 4  # of a tensor that differs in many, how many get suggestions
SUGGESTIONS = 3
SIBLINGS = 8  # other quantities of the model that a print may have been meant for
NEAR = 2.0  # the cost of an edit from which another quantity is not near
UNEXPLAINED = 4.0  # what an entry costs for which nothing is found


@dataclass(frozen=True)
class Account:
    """What may be said of a print that is wrong.

    Attributes:
        convention: in which it is looked at, in words after "equal"; nothing for ours.
        wrong: the entries that are wrong in it.
        suggestions: what was probably meant in these, the likeliest first.
        cost: how much is left to explain, on the scale of edits.
    """

    convention: str = ""
    wrong: tuple[Index, ...] = ()
    suggestions: tuple[Suggestion, ...] = ()
    cost: float = 0.0

    @property
    def is_complete(self) -> bool:
        """Whether the convention alone explains everything."""
        return bool(self.convention) and not self.wrong


@dataclass(frozen=True)
class Print:
    """A print and the question that it answers.

    Attributes:
        asked: the entries in the quantity's symbols, and what they are compared with.
        printed: as it was read.
        is_compared: whether what is compared is what is printed, and no polynomial or limit of it.
    """

    asked: Asked
    printed: Printed
    is_compared: bool = True

    @property
    def trees(self) -> Tensor[Tree]:
        """The entries as printed."""
        return self.printed.entries

    @property
    def names(self) -> Names:
        """What is said in them."""
        return self.printed.names

    def account(self, wrong: Sequence[Index]) -> Account:
        """The account that leaves the least to explain; ours has these wrong entries."""
        complete = attempted(lambda: self.complete, lambda _: None)
        if complete is not None and (not self.is_compared or not self._is_one_slip(complete)):
            return Account(complete.words, cost=complete.cost)
        if not self.is_compared:
            return Account(wrong=tuple(wrong), cost=UNEXPLAINED * len(wrong))
        best = self._edited(None, tuple(wrong))
        if complete is not None:
            return best if best.suggestions else Account(complete.words, cost=complete.cost)
        for one in attempted(lambda: self._explanations, lambda _: []):
            if one.arrangement.words and len(one.wrong) >= len(wrong):
                continue  # another order that mends nothing is no account, however cheap the edits in it
            if self._least(one) < best.cost:
                best = min(best, self._edited(one, one.wrong), key=lambda account: account.cost)
        return best

    def of_siblings(self) -> list[Suggestion]:
        """What was printed wrong if another quantity of the model was meant, from which it is one edit away.

        From a number alone any other is.
        """
        if not any(names(tree) for tree in self.trees):
            return []
        free = self.asked.correlations
        vanishing = () if self.asked.uses(free) else tuple(free)
        conditions = also_zero(self.asked.conditions, vanishing) or self.asked.conditions
        printed = {index: under(conditions, self.asked.printed[index]) for index, _ in self.trees.items()}
        for name, expected in islice(siblings(self.asked), SIBLINGS):
            pairs = {index: under(conditions, expected[index]) for index in printed}
            wrong = [index for index, entry in pairs.items() if not proved_equal(printed[index], entry)]
            if len(wrong) != 1:
                continue
            symbols = self._symbols(conditions)
            found = suggest(self.trees[wrong[0]], self._all_names, pairs[wrong[0]], symbols, conditions)
            if found and found[0].cost < NEAR:
                edit = f"{found[0].edit}, if {name} is meant{when_zero(vanishing)}"
                return [Suggestion(found[0].formula, edit, wrong[0], found[0].proved)]
        return []

    @cached_property
    def complete(self) -> Explanation | None:
        """The likeliest convention in which nothing is wrong."""
        found = (one for one in self._explanations if not one.wrong)
        return min(found, key=lambda one: one.cost, default=None)

    @cached_property
    def _all_names(self) -> Names:
        """Those that are printed, and what else may have been meant."""
        return self.names.completed()

    @cached_property
    def _explanations(self) -> list[Explanation]:
        return explanations(self.asked)

    def _least(self, one: Explanation) -> float:
        """What an explanation costs at least."""
        return one.cost + len({self.asked.printed[index] for index in one.wrong})

    def _is_one_slip(self, one: Explanation) -> bool:
        """Whether a convention changes one place only, which a slip may have done as well."""
        if one.arrangement.words or not one.convention.is_slip:
            return False
        changed = set(one.convention.changes)
        direct = {name for name, value in self.names.numbers.items() if set(value.free_symbols) & changed}
        direct -= self.names.definitions.keys()
        trees = [*self.trees, *self.names.definitions.values()]
        count = sum(isinstance(node, Name) and node.name in direct for tree in trees for _, node in walk(tree))
        return count <= 1 and (len(self.trees.entries) == 1 or bool(changed and self.names.definitions))

    def _edited(self, one: Explanation | None, wrong: tuple[Index, ...]) -> Account:
        """The edits of the wrong entries, in our convention or another."""
        words, cost = (one.words, one.cost) if one is not None else ("", 0.0)
        mended = self._mended(one, wrong)
        found = {index: self._edits(one, index) for index in self._different(wrong)[:SHOWN_ENTRIES]}
        left = set(self._different(wrong))
        suggestions: list[Suggestion] = []
        at_once = sum(edits[0].cost if edits else UNEXPLAINED for edits in found.values())
        if mended and mended[0].cost <= at_once:
            suggestions += [edit.suggestion(words) for edit in mended]
        if mended and mended[0].cost < at_once:
            cost += mended[0].cost
            left -= set(mended[0].mends)
        for index, edits in found.items():
            if index in left:
                suggestions += [edit.suggestion(words, index) for edit in edits]
        if mended and mended[0].cost > at_once:
            suggestions += [edit.suggestion(words) for edit in mended]
        distinct = {edits[0].words: edits[0].cost for index, edits in found.items() if edits and index in left}
        unexplained = sum(1 for index in left if index in found and not found[index])
        more = len(left - found.keys())
        cost += sum(distinct.values()) + UNEXPLAINED * unexplained + more
        return Account(words, wrong, tuple(suggestions), cost)

    def _different(self, wrong: Sequence[Index]) -> list[Index]:
        """The wrong entries, each once of those that are printed alike and should be alike."""
        pairs = {(self.asked.printed[i], self.asked.reference.entries[i]): i for i in reversed(wrong)}
        return sorted(pairs.values())

    def _expected(self, one: Explanation | None, index: Index) -> tuple[Expr, Mapping[Symbol, Expr]]:
        if one is not None:
            return one.in_print(index), one.conditions
        conditions = self.asked.conditions
        return under(conditions, self.asked.reference.entries[index]), conditions

    def _symbols(self, conditions: Mapping[Symbol, Expr]) -> list[Variable]:
        every = self.asked.reference.symbols
        free = set[Symbol](every) - conditions.keys()
        free = free.union(*(value.free_symbols for value in conditions.values()))
        return [symbol for symbol in every if symbol in free]

    def _edits(self, one: Explanation | None, index: Index) -> list[_Edit]:
        expected, conditions = self._expected(one, index)
        found = suggest(self.trees[index], self._all_names, expected, self._symbols(conditions), conditions)
        line_of = self.printed.line_of
        return [
            _Edit(edit.formula, line_of(edit.span) + edit.edit, edit.cost, edit.proved) for edit in found[:SUGGESTIONS]
        ]

    def _mended(self, one: Explanation | None, wrong: Sequence[Index]) -> list[_Edit]:
        if not self.names.definitions or not wrong:
            return []
        places = [index for index, _ in self.trees.items()]
        conditions = self.asked.conditions if one is None else one.conditions
        formulas = [Formula(self.trees[index], self._expected(one, index)[0]) for index in places]
        found = mended_definitions(formulas, self.names, self._symbols(conditions), conditions)
        return [
            _Edit(
                f"{edit.name} = {edit.formula}",
                f"in the definition of {edit.name}: {edit.edit}",
                edit.cost,
                proved=True,
                name=edit.name,
                mends=tuple(places[place] for place in edit.mends),
            )
            for edit in found
        ]


@dataclass(frozen=True)
class _Edit:
    """An edit of an entry, or of a definition that has a name and mends entries."""

    formula: str
    words: str
    cost: float
    proved: bool
    name: str = ""
    mends: tuple[Index, ...] = ()

    def suggestion(self, convention: str, entry: Index = ()) -> Suggestion:
        """The same as it is told, in a convention."""
        return Suggestion(self.formula, f"{self.words}{convention}", entry, self.proved, self.name)
