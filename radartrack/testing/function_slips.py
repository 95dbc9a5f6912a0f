"""Searches for edits of a derived formula that give it the values of a function: the checker's search, the other way."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from contextlib import suppress

from radartrack.derive import symbolic as sp
from radartrack.derive.algebra.differential_ring import NotDifferentiable
from radartrack.derive.checking.question.names import Names
from radartrack.derive.checking.repairing.edit_search import Candidate, Search
from radartrack.derive.checking.reporting.derived_formula import as_printed
from radartrack.derive.evaluation.tree_values import TOLERANCE, Program, Screen, Values
from radartrack.derive.formula.from_expression import to_tree
from radartrack.derive.formula.printing import to_text
from radartrack.derive.formula.tree import Number, Power, Product, Sum, Tree, replace_at, walk
from radartrack.derive.language.tensor import Index, Tensor
from radartrack.derive.language.variable import Variable
from radartrack.derive.stable.roots_and_quotients import collected_form
from radartrack.derive.symbolic import Expr
from radartrack.testing.called_function import Array
from radartrack.testing.diagnosis import Slip
from radartrack.testing.edit_in_words import edit_in_words
from radartrack.testing.wanted import Expected

SAME = 1e-7  # of the sizes, at points at which an edit is tried once more
LONG = 300  # characters of a formula that is told
SHORT = 400  # characters of a formula that is tried over one denominator
LIKELY = 1.2  # the cost of an edit for which no other way to write the formula is searched


class SlipSearch:
    """The points at which a function is known, and its entries there.

    Args:
        screening: points of ordinary size.
        found: what the function has there, shape (points, entries).
        confirming: points in all directions.
        found_there: likewise.
    """

    def __init__(self, screening: Expected, found: Array, confirming: Expected, found_there: Array) -> None:
        self._screening, self._found = screening, found
        self._confirming, self._found_there = confirming, found_there
        symbols: Sequence[Variable] = screening.wanted.symbols
        self._names = Names({symbol.name: symbol for symbol in symbols})
        here, self._wider = (
            {symbol.name: tuple(map(float, one.points[symbol.name])) for symbol in symbols}
            for one in (screening, confirming)
        )
        self._screen = Screen(here, screening.count)

    def slip(self, place: int) -> Slip | None:
        """The likeliest edit of one entry, by its place among those that are wanted."""
        target = tuple(map(float, self._found[:, place]))
        if not all(map(math.isfinite, target)):
            return None
        wanted = self._screening.wanted
        entry = wanted.entries[place].xreplace(
            {s: s * 0 for s in wanted.quantity.symbols if wanted.given.get(s.name) == 0}
        )
        index = wanted.places[place] if wanted.shape else ()
        best: tuple[Candidate, Tree] | None = None
        for tree in _trees(entry):
            for candidate in self._edits(tree, target):
                if best is not None and candidate.cost >= best[0].cost:
                    break
                if self._is_confirmed(candidate.tree, place):
                    best = candidate, tree
                    break
            if best is not None and best[0].cost <= LIKELY:
                break
        return None if best is None else _told(best[1], best[0], index)

    def other_entry(self, place: int) -> int | None:
        """Another entry that the function has there."""
        expected, scales = self._screening.values, self._screening.scales
        for other in range(expected.shape[1]):
            difference = abs(self._found[:, place] - expected[:, other])
            if other != place and (difference <= TOLERANCE * scales[:, other]).all() and expected[:, other].any():
                return other
        return None

    def _edits(self, tree: Tree, target: Values) -> list[Candidate]:
        if all(value == 0 for value in target):
            return [Candidate(Number("0"), "", 1.0)]
        found = Search(self._screen, target, self._names, tree, ()).edits(tree)
        found += self._misread_powers(tree, target)
        return sorted(found, key=lambda candidate: candidate.cost)

    def _misread_powers(self, tree: Tree, target: Values) -> Iterator[Candidate]:
        """`x*2`, `x + 2` and `2 + x` for `x**2`: the sign of a power is lost where text is taken over."""
        for path, node in walk(tree):
            if isinstance(node, Power):
                for other in (Product((node.exponent, node.base)), Sum((node.base, node.exponent))):
                    edited = replace_at(tree, path, other)
                    if _near(self._screen(edited), target, target):
                        yield Candidate(edited, "", 1.3)

    def _is_confirmed(self, tree: Tree, place: int) -> bool:
        """Whether the edited formula is the function in all directions, wherever that has a value."""
        program, sizes = Program(tree), self._confirming.scales[:, place]
        for n, (target, size) in enumerate(zip(map(float, self._found_there[:, place]), sizes, strict=True)):
            values = program({name: column[n] for name, column in self._wider.items()})
            if not math.isfinite(target):
                continue
            if not _near(values, (target,), (size,)):
                return False
        return True


def _near(values: Values | None, target: Values, sizes: Sequence[float]) -> bool:
    if values is None:
        return False
    triples = zip(values, target, sizes, strict=True)
    return all(abs(a - b) <= SAME * max(abs(a), abs(b), abs(size)) for a, b, size in triples)


def _trees(entry: Expr) -> list[Tree]:
    """The formula over one denominator, as code has it; as it would be printed; and as it came out."""
    found = [as_printed(entry), to_tree(entry)]
    if len(to_text(found[-1])) <= SHORT:
        with suppress(NotDifferentiable):
            collected = collected_form(Tensor((), (entry,))).expanded().entries[0]
            found = [to_tree(sp.factor(collected)), *found]
    return list(dict.fromkeys(found))


def _told(derived: Tree, candidate: Candidate, index: Index) -> Slip:
    words = edit_in_words(derived, candidate.tree)
    formula, other = (_short(tree) for tree in (candidate.tree, derived))
    return Slip((index,), words, formula, other, candidate.cost)


def _short(tree: Tree) -> str:
    text = to_text(tree)
    return text if len(text) <= LONG else ""


def merged(slips: Sequence[Slip]) -> tuple[Slip, ...]:
    """Slips that are one: the same edit in several entries."""
    found: dict[str, Slip] = {}
    for slip in slips:
        if slip.edit in found:
            first = found[slip.edit]
            slip = Slip((*first.entries, *slip.entries), slip.edit, first.formula, first.derived, first.cost)  # noqa: PLW2901
        found[slip.edit] = slip
    return tuple(found.values())
