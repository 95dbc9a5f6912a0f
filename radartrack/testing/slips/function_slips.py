"""Searches for edits of a derived formula that give it a function's values: the checker's search, the other way."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import suppress
from fractions import Fraction

import numpy as np

from radartrack.derive import symbolic as sp
from radartrack.derive.algebra.differential_ring import NotDifferentiable
from radartrack.derive.checking.question.names import Names
from radartrack.derive.checking.repairing.edit_in_words import edit_in_words
from radartrack.derive.checking.repairing.edit_search import Candidate, Search
from radartrack.derive.checking.repairing.monomial_fit import number_tree
from radartrack.derive.checking.repairing.print_slips import Alternative, alternatives, exchanged, other_numbers
from radartrack.derive.checking.reporting.derived_formula import as_printed
from radartrack.derive.evaluation.tree_values import TOLERANCE, Program, Screen, Values
from radartrack.derive.formula.error import FormulaError
from radartrack.derive.formula.fold import rebuild
from radartrack.derive.formula.from_expression import to_tree
from radartrack.derive.formula.printing import to_text
from radartrack.derive.formula.tree import (
    Constant,
    Name,
    Negation,
    Number,
    Power,
    Product,
    Quotient,
    Sum,
    Tree,
    replace_at,
    walk,
)
from radartrack.derive.language.tensor import Index, Tensor
from radartrack.derive.stable.roots_and_quotients import collected_form
from radartrack.derive.symbolic import Expr
from radartrack.testing.calling.called_function import Array
from radartrack.testing.diagnosis import Slip
from radartrack.testing.function_conventions import angles_of
from radartrack.testing.slips.constant_parts import constant_parts
from radartrack.testing.wanted import Expected

ONE = Number("1")
DECIMAL = re.compile(r"(10+)/(\d+) for (\d+)")
SAME = 1e-7  # of the sizes, at points at which an edit is tried once more
SOUND = 1e-9  # of the sizes, which a formula keeps to where an edit of it may be tried
LAST_DIGITS = (0.0, 2.0**-52, -(2.0**-52), 3 * 2.0**-52)  # by which arguments are moved
SMALL, QUICK = 120, 2  # nodes of a formula that is edited forwards, and points that rule out nearly every edit
LARGEST = 12  # divisor of a factor of a number
IN_A_SUM = 1e-12  # of the largest term, by which rounding moves a sum
SHORTEST = 30  # nodes of a formula of which two edits are tried forwards: their number grows with the square
SHORT = 400  # characters of a formula that is tried over one denominator
POINTS, FEWEST = 18, 8  # at which edits are screened, and fewer than which say nothing
PLAIN = 2.0  # the cost of one edit that is likelier than any other kind
TWICE = 3.0  # the cost below which no two edits are
CLEARLY, TINY = 0.1, 1e-300  # of what the function is off by, up to where an edit explains it; the least size
DROPPED = 1.5  # the cost of a factor or a term that is missing
CANCELLED = 50.0  # times which a function of single precision may be off where it cancels
LIKELY = 1.2  # the cost of an edit for which no other way to write the formula is searched

Edits = Callable[[Search, Tree, Values], Iterable[Candidate]]


class SlipSearch:
    """The points at which a function is known, and its entries there.

    Args:
        screening: points of ordinary size.
        found: what the function has there, shape (points, entries).
        confirming: points in all directions.
        found_there: likewise.
        share: of a value, by which what is found may be off, where that is more than double precision makes.
    """

    def __init__(
        self, screening: Expected, found: Array, confirming: Expected, found_there: Array, share: float = 0.0
    ) -> None:
        self._share = max(share, SAME)
        self._screening, self._found = screening, found
        self._confirming, self._found_there = confirming, found_there
        wanted = screening.wanted
        symbols = [symbol for symbol in wanted.quantity.symbols if wanted.given.get(symbol.name) != 0]
        self._angles = angles_of(symbols)
        self._names = Names({symbol.name: symbol for symbol in symbols})
        self._here, self._wider = (
            {symbol.name: tuple(map(float, one.points[symbol.name])) for symbol in symbols}
            for one in (screening, confirming)
        )

    def slip(self, place: int) -> Slip | None:
        """The likeliest edit of one entry, by its place among those that are wanted."""
        known = np.flatnonzero(np.isfinite(self._found[:, place]))[:POINTS]
        if len(known) < (FEWEST if self._here else 1):
            return None
        self._target = target = tuple(map(float, self._found[known, place]))
        self._exact = tuple(map(float, self._screening.values[known, place]))
        self._screen = Screen(
            {name: tuple(values[n] for n in known) for name, values in self._here.items()}, len(known)
        )
        wanted = self._screening.wanted
        index = wanted.places[place] if wanted.shape else ()
        trees = self.trees(place)
        searches = [Search(self._screen, target, self._names, tree, ()) for tree in trees]
        found: tuple[Candidate, Tree] | None = None
        exactly: Sequence[tuple[Edits, float]] = (
            (self._single, PLAIN),
            (self._forwards_and_below, TWICE),
            (self._double, math.inf),
        )
        roughly: Sequence[tuple[Edits, float]] = ((self._roughly, TWICE), (self._two_roughly, math.inf))
        for edits, is_enough in exactly if self._share == SAME else roughly:
            found = self._likeliest(edits, searches, trees, target, place, found)
            if found is not None and found[0].cost <= is_enough:
                break
        return None if found is None else _told(found[1], found[0], index, self._names)

    def trees(self, place: int) -> list[Tree]:
        """Ways to write an entry."""
        wanted = self._screening.wanted
        zero = {s: s * 0 for s in wanted.quantity.symbols if wanted.given.get(s.name) == 0}
        return _trees(wanted.entries[place].xreplace(zero))

    def is_entry(self, place: int, other: int) -> bool:
        """Whether the function has in one place what belongs in another."""
        expected, scales = self._screening.values, self._screening.scales
        share = TOLERANCE if self._share == SAME else self._share
        near = np.abs(self._found[:, place] - expected[:, other]) <= share * scales[:, other]
        return bool(near.all())

    def _likeliest(
        self,
        edits: Edits,
        searches: Sequence[Search],
        trees: Sequence[Tree],
        target: Values,
        place: int,
        best: tuple[Candidate, Tree] | None,
    ) -> tuple[Candidate, Tree] | None:
        """The likeliest edit that holds in all directions, in any way to write the formula."""
        for search, tree in zip(searches, trees, strict=True):
            if best is not None and best[0].cost <= LIKELY:
                break
            limit = math.inf if best is None else best[0].cost
            candidates = [one for one in edits(search, tree, target) if one.cost < limit and self._is_nearer(one.tree)]
            sound = self._sound(tree, place) if candidates else []
            confirmed = (one for one in sorted(candidates, key=_by_cost) if self._is_confirmed(one.tree, place, sound))
            likeliest = next(confirmed, None)
            best = best if likeliest is None else (likeliest, tree)
        return best

    def _single(self, search: Search, tree: Tree, target: Values) -> Iterator[Candidate]:
        if all(value == 0 for value in target):
            yield Candidate(Number("0"), "", 1.0)
        elif self._here:
            yield from search.single_edits(tree)
            yield from self._misread_powers(search, tree)
            yield from constant_parts(search, self._screen, tree, target)
        elif (values := self._screen(tree)) and values[0]:
            share = Fraction(target[0] / values[0]).limit_denominator(LARGEST)
            if share and abs(target[0] - share * values[0]) <= TOLERANCE * abs(target[0]):
                yield Candidate(Product((number_tree(share), tree)), "", PLAIN)

    def _forwards_and_below(self, search: Search, tree: Tree, target: Values) -> Iterator[Candidate]:
        yield from self._forwards(tree, target)
        yield from self._in_terms(tree, target)
        if self._here:
            yield from self._below_even_powers(search, tree)

    def _roughly(self, _: Search, tree: Tree, target: Values) -> Iterator[Candidate]:
        """Of values with few digits: from what they are nothing follows for the parts, so that all edits are tried."""
        if not any(target):
            yield Candidate(Number("0"), "", 1.0)
            return
        if self._is_roughly(Negation(tree)):
            yield Candidate(Negation(tree), "", 1.0)
        yield from (one for one in self._forwards(tree, target) if self._is_roughly(one.tree))

    def _two_roughly(self, _: Search, tree: Tree, target: Values) -> Iterator[Candidate]:
        """Two likely edits of a short formula, likewise."""
        if not self._here or len(list(walk(tree))) > SHORTEST:
            return
        for first, cost in dict(self._edits(tree)).items():
            for second in self._forwards(first, target) if cost <= LIKELY else ():
                if second.cost < PLAIN and self._is_roughly(second.tree):
                    yield Candidate(second.tree, "", cost + second.cost + 1)

    def _is_roughly(self, tree: Tree) -> bool:
        return _near(self._screen(tree), self._target, self._target, self._share)

    def _double(self, search: Search, tree: Tree, _: Values) -> list[Candidate]:
        """Of a number, which many things are worth, only what is plainly an edit of it is taken."""
        return search.double_edits(tree) if self._here else []

    def _misread_powers(self, search: Search, tree: Tree) -> Iterator[Candidate]:
        """`x*2`, `x + 2` and `2 + x` for `x**2`: the sign of a power is lost where text is taken over."""
        for part in search.parts(tree):
            if isinstance(part.node, Power):
                for other in (Product((part.node.exponent, part.node.base)), Sum((part.node.base, part.node.exponent))):
                    if _near(self._screen(other), part.needed, part.needed):
                        yield Candidate(replace_at(tree, part.path, other), "", 1.3)

    def _in_terms(self, tree: Tree, target: Values) -> Iterator[Candidate]:
        """Edits of the terms of a long sum, by what is left for each: rounding of the sum hides what its parts need."""
        if not isinstance(tree, Sum) or len(list(walk(tree))) <= SMALL:
            return
        values = [self._screen(term) for term in tree.terms]
        if None in values:
            return
        table = np.array(values)
        sizes, left = np.abs(table).max(axis=0), np.array(target) - table.sum(axis=0)
        points = [{name: column[n] for name, column in self._screen.names.items()} for n in range(self._screen.size)]
        for place, term in enumerate(tree.terms):
            needed = table[place] + left
            for edited, cost in self._edits(term):
                program = Program(edited)
                found = (program(point) for point in points)
                if all(
                    one is not None and abs(one[0] - value) <= IN_A_SUM * size
                    for one, value, size in zip(found, needed, sizes, strict=True)
                ):
                    yield Candidate(replace_at(tree, (place,), edited), "", cost)

    def _below_even_powers(self, search: Search, tree: Tree) -> Iterator[Candidate]:
        """Edits of what is raised to even powers: of its value nothing but the size follows from that of the power."""
        for part in search.parts(tree):
            match part.node:
                case Power(base, Number() as exponent) if _is_even(exponent.value) and min(part.needed) >= 0:
                    size = tuple(value ** (1 / float(exponent.value)) for value in part.needed)
                    for edit in self._forwards(base, size, abs):
                        edited = replace_at(tree, part.path, Power(edit.tree, exponent))
                        yield Candidate(edited, edit.words, edit.cost)

    def _forwards(self, tree: Tree, target: Values, seen: Callable[[float], float] = float) -> Iterator[Candidate]:
        """Edits by what they make of the whole.

        Args:
            tree: what is edited.
            target: what is to be seen of its values.
            seen: what that is, of a value.
        """
        quick = [{name: values[n] for name, values in self._screen.names.items()} for n in range(QUICK)]
        for edited, cost in self._edits(tree):
            program = Program(edited)
            if all(
                _near(_each(seen, program(point)), (value,), (value,), self._share)
                for point, value in zip(quick, target, strict=False)
            ):
                yield Candidate(edited, "", cost)

    def _edits(self, tree: Tree) -> Iterator[tuple[Tree, float]]:
        """A short formula after every likely slip, and its cost."""
        nodes = list(walk(tree))
        kinds = {name: self._names.dimensions[name] for name in self._here}
        for path, node in nodes if len(nodes) <= SMALL else ():
            edits = (*alternatives(node, kinds), *exchanged(node), *other_numbers(node), *_more(node))
            for edit in (*edits, *_without_one_of(node), *_in_another_unit(node, self._angles)):
                yield replace_at(tree, path, edit.tree), edit.cost

    def _is_nearer(self, tree: Tree) -> bool:
        """Whether an edited formula is the function, and not what that is all but for a small term."""
        values = self._screen(tree)
        return values is not None and self._away(values) <= CLEARLY * self._away(self._exact)

    def _away(self, values: Values) -> float:
        """By how much values are off from those of the function, at most, in units of these."""
        pairs = zip(values, self._target, strict=True)
        return max(abs(one - target) / max(abs(one), abs(target), TINY) for one, target in pairs)

    def _sound(self, tree: Tree, place: int) -> list[int]:
        """The points in all directions at which the formula as it stands does not lose its digits.

        There it stays where it is when arguments move by their last digits.
        """
        exact, sizes = self._confirming.values[:, place], self._confirming.scales[:, place]
        program = Program(tree)
        found = []
        for n, (value, size) in enumerate(zip(map(float, exact), sizes, strict=True)):
            moved = [{name: one * (1 + step) for name, one in self._wider_point(n).items()} for step in LAST_DIGITS]
            if all(_near(program(point), (value,), (size,), SOUND) for point in moved):
                found.append(n)
        return found

    def _wider_point(self, place: int) -> dict[str, float]:
        return {name: column[place] for name, column in self._wider.items()}

    def _is_confirmed(self, tree: Tree, place: int, sound: Sequence[int]) -> bool:
        """Whether the edited formula is the function in all directions, wherever that has a value."""
        program, sizes = Program(tree), self._confirming.scales[:, place]
        share = SAME if self._share == SAME else CANCELLED * self._share
        targets = [(n, float(self._found_there[n, place])) for n in sound]
        return all(
            _near(program(self._wider_point(n)), (target,), (sizes[n],), share)
            for n, target in targets
            if math.isfinite(target)
        )


def _by_cost(candidate: Candidate) -> float:
    return candidate.cost


def _near(values: Values | None, target: Values, sizes: Sequence[float], share: float = SAME) -> bool:
    if values is None:
        return False
    triples = zip(values, target, sizes, strict=True)
    return all(abs(a - b) <= share * max(abs(a), abs(b), abs(size)) for a, b, size in triples)


def _is_even(exponent: Fraction) -> bool:
    return exponent > 0 and exponent % 2 == 0


def _more(node: Tree) -> Iterator[Alternative]:
    """A number with the other sign; a sum with one of its terms twice."""
    if isinstance(node, Number):
        yield Alternative(Negation(node), "the sign of {}", 1.0, (node,))
    if isinstance(node, Name):
        yield Alternative(ONE, "{} should be {}", DROPPED, (node, ONE))
    for place, term in enumerate(node.terms) if isinstance(node, Sum) else ():
        inner, sign = (term.operand, Negation) if isinstance(term, Negation) else (term, lambda tree: tree)
        factors = inner.factors if isinstance(inner, Product) else (inner,)
        twice = sign(Product((Number("2"), *factors)))
        yield Alternative(replace_at(node, (place,), twice), "{} should be {}", LIKELY, (term, twice))


def _without_one_of(node: Tree) -> Iterator[Alternative]:
    """A product without one of its factors, a sum without one of its terms."""
    if not isinstance(node, Product | Sum):
        return
    parts = node.factors if isinstance(node, Product) else node.terms
    for place in range(len(parts)):
        rest = (*parts[:place], *parts[place + 1 :])
        without = rest[0] if len(rest) == 1 else type(node)(rest)
        yield Alternative(without, "{} should be {}", DROPPED, (node, without))


def _in_another_unit(node: Tree, angles: Sequence[str]) -> Iterator[Alternative]:
    """An angle that is not converted from degrees, or once too often."""
    if isinstance(node, Name) and node.name in angles:
        half_turn, pi = Number("180"), Constant("pi")
        for above, below in ((half_turn, pi), (pi, half_turn)):
            yield Alternative(Quotient(Product((above, node)), below), "{} should be {}", LIKELY, (node,))


def _each(seen: Callable[[float], float], values: Values | None) -> Values | None:
    return values and tuple(map(seen, values))


def _trees(entry: Expr) -> list[Tree]:
    """The formula over one denominator, as code has it; as it would be printed; and as it came out."""
    found = [as_printed(entry), to_tree(entry)]
    if len(to_text(found[-1])) <= SHORT:
        with suppress(NotDifferentiable):
            collected = collected_form(Tensor((), (entry,))).expanded().entries[0]
            found = [to_tree(sp.factor(collected)), *found]
    return list(dict.fromkeys(found))


def _told(derived: Tree, candidate: Candidate, index: Index, names: Names) -> Slip:
    """In the words of the formula as it was edited, or as it would be written then, whichever are shorter."""
    edited = rebuild(candidate.tree, _without_one)
    words, tree = min(((edit_in_words(derived, one), one) for one in (edited, _rewritten(edited, names))), key=_length)
    return Slip((index,), _in_decimals(words), to_text(tree), to_text(derived), candidate.cost)


def _in_decimals(words: str) -> str:
    """0.333 for 1/3, in place of 1000/333 for 3."""
    match = DECIMAL.fullmatch(words)
    return f"{int(match[2]) / int(match[1]):g} for 1/{match[3]}" if match else words


def _without_one(node: Tree) -> Tree:
    """Without a factor or a divisor 1, which nobody writes."""
    match node:
        case Product(factors) if ONE in factors:
            kept = tuple(factor for factor in factors if factor != ONE)
            return kept[0] if len(kept) == 1 else Product(kept) if kept else ONE
        case Quotient(numerator, denominator) if denominator == ONE:
            return numerator
        case _:
            return node


def _length(told: tuple[str, Tree]) -> int:
    return len(told[0])


def _rewritten(tree: Tree, names: Names) -> Tree:
    """A short formula with its factors put together; a long one as it is."""
    if len(to_text(tree)) > SHORT:
        return tree
    try:
        return to_tree(names.read(tree))
    except FormulaError:
        return tree


def merged(slips: Sequence[Slip]) -> tuple[Slip, ...]:
    """Slips that are one: the same edit in several entries."""
    found: dict[str, Slip] = {}
    for slip in slips:
        if slip.edit in found:
            first = found[slip.edit]
            slip = Slip((*first.entries, *slip.entries), slip.edit, first.formula, first.derived, first.cost)  # noqa: PLW2901
        found[slip.edit] = slip
    return tuple(found.values())
