"""Searches a printed formula for edits that give it the values it should have.

From what the whole formula should be worth at some points follows, step by step down the tree, what each of its
parts would have to be worth there. An edit of a part is right when it is worth that: so thousands are screened in no
time, and a factor or term that is missing shows in the ratio or the difference.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from operator import sub, truediv
from typing import TypeAlias

from radartrack.derive.checking.question.names import Names
from radartrack.derive.checking.repairing.known_parts import Pieces
from radartrack.derive.checking.repairing.monomial_fit import Fitter, Monomial, number_tree
from radartrack.derive.checking.repairing.print_slips import (
    PERIODIC,
    Alternative,
    alternatives,
    everywhere,
    exchanged,
    exchanges,
    other_numbers,
    undoes,
)
from radartrack.derive.evaluation.tree_values import OPERATIONS, Program, Screen, Values, close, combined
from radartrack.derive.formula.fold import Fold, rebuild
from radartrack.derive.formula.tree import (
    Call,
    Constant,
    Name,
    Negation,
    Number,
    Path,
    Power,
    Product,
    Quotient,
    Sum,
    Tree,
    children,
    parts,
    replace_at,
    walk,
)
from radartrack.derive.formula.tree import (
    names as names_of,
)

# Tuned by the campaign of slips (tests/derive/checking/repairing/test_mutants.py): slips are put into every entry of
# the catalogue, and what each came from must be among the first suggestions, in less than two seconds.
QUICK = 2  # points that rule out nearly every edit; at one, edits of even functions pass by chance and cost all points
FACTORS = 13  # powers that a fit solves for: with more, points run out and a fit means nothing; with fewer, the sine
# or the deviation that a long covariance misses is not among them
FIRST_EDITS = 150  # of two at once: each costs a whole search for the second; beyond, two seconds are over
SMALL = 6  # nodes that an edit may add to however short a formula: -cos(beta)**2; more for a 1 is no edit of it
LIKELY = 1.2  # the cost of an edit that may be one of two
PLAIN = 2.0  # the cost of one edit that is likelier than any two
SCATTERED = 0.6  # the cost of each different symbol of a factor after the second: without it, a factor of many symbols
# that fits by chance goes before the sign that was lost
FRACTION_BELOW = 2.0  # the cost of a fraction as a divisor: nobody prints one; a factor 2 above was lost instead
ODD_FRACTION = 1.6  # and of 25/6 for 6, where the numbers of a fraction may have changed places
LARGE = 60  # nodes from which two edits at once are not looked for: their number grows with the square
HUGE = 500  # nodes from which one edit in one place is enough: all edits of the longest covariance take ten seconds
EVEN = {"abs", "cos", "cosh"}
PARTNERS = {"sin": "cos", "cos": "sin", "sinh": "cosh", "cosh": "sinh"}
MOST_COMPLEX = 6  # powers and numbers in a missing factor; longer ones fit anything, and nobody loses them in print

Terms: TypeAlias = frozenset[Values | None]  # by what they are worth


@dataclass(frozen=True)
class Candidate:
    """A formula after one edit or two, the edit in words, and how unlikely the slip is."""

    tree: Tree
    words: str
    cost: float


@dataclass(frozen=True)
class Part:
    """A part of the printed formula, and what it would have to be worth.

    Attributes:
        path: where it stands.
        node: what is printed.
        parent: what it is directly part of; None for the whole formula.
        needed: what it would have to be worth.
        is_all: whether it is the whole formula but for signs.
    """

    path: Path
    node: Tree
    parent: Tree | None
    needed: Values
    is_all: bool

    @property
    def has_either_sign(self) -> bool:
        """Whether its sign is lost in what it is part of: what is needed is known but for that."""
        match self.parent:
            case Power(_, Number() as exponent):
                return self.path[-1] == 0 and exponent.value % 2 == 0
            case Call(function):
                return function in EVEN
            case _:
                return False

    @property
    def is_below(self) -> bool:
        """Whether it is what something is divided by."""
        return isinstance(self.parent, Quotient) and self.path[-1] == 1

    @property
    def is_shared(self) -> bool:
        """Whether a factor, divisor or sign of this part is one of its parent just as well."""
        return isinstance(self.parent, Product | Quotient | Negation)


class Search:
    """The points, what is wanted there, and the factors that may be missing.

    Args:
        screen: the points.
        target: what the formula should be worth there.
        names: what a formula may use.
        printed: the formula as it stands.
        derived: what it should be, as it may be printed.
    """

    def __init__(self, screen: Screen, target: Values, names: Names, printed: Tree, derived: Sequence[Tree]) -> None:
        self._screen = screen
        self._quick = screen.first(min(QUICK, screen.size))
        self._target = target
        dimensions, numbers = names.dimensions, names.numbers
        self._kinds = {name: dimensions[name] for name in screen.names}
        symbols = [name for name in screen.names if numbers[name].is_Symbol]
        self._fitter = Fitter(self._factors(symbols, (printed, *derived)), screen.size)
        self._pieces = Pieces((*derived, printed), screen)
        self._derived = derived

    def edits(self, tree: Tree) -> list[Candidate]:
        """One edit, or one that runs through the formula; where there is no likely one, two."""
        found = self.single_edits(tree)
        if not any(candidate.cost <= PLAIN for candidate in found):
            found += self.double_edits(tree)
        return sorted(found, key=lambda candidate: candidate.cost)

    def single_edits(self, tree: Tree) -> list[Candidate]:
        """One edit, or one that runs through the formula."""
        size = _size(tree)
        found = list(self._single(tree, besides=self._right_terms(tree))) if size > HUGE else []
        found = found or list(self._single(tree))
        if not found or size <= HUGE:
            found += self._everywhere(tree)
        return _small(found, tree)

    def double_edits(self, tree: Tree) -> list[Candidate]:
        """Two edits; none of a long formula."""
        return _small(self._double(tree), tree) if _size(tree) <= LARGE else []

    def _right_terms(self, tree: Tree) -> Terms:
        """Those that stand in different sums of the formula no more often than in those of the derived one."""
        printed, derived = self._terms([tree]), self._terms(self._derived)
        return frozenset(term for term, count in printed.items() if count <= derived[term])

    def _terms(self, trees: Sequence[Tree]) -> Counter[Values | None]:
        """How often terms of these values stand in different sums."""
        sums = [node for node in parts(*trees) if isinstance(node, Sum)]
        return Counter(_rounded(self._quick(term)) for node in sums for term in node.terms)

    def _everywhere(self, tree: Tree) -> Iterator[Candidate]:
        program = Program(tree)
        point = {name: values[0] for name, values in self._screen.names.items()}
        often = Counter(node.name for _, node in walk(tree) if isinstance(node, Name))
        for edit in everywhere({name: often[name] for name in sorted(often.keys() & self._kinds.keys())}, self._kinds):
            if edit.values is not None:
                changed = {name: value(point) for name, value in edit.values.items()}
                if not close(program(point | changed), self._target[:1]):
                    continue
            edited = rebuild(tree, edit.change)
            if edited is not tree and self._is_worth(edited, self._target):
                yield Candidate(edited, edit.words, edit.cost)

    def _is_worth(self, tree: Tree, needed: Values, *, either_sign: bool = False) -> bool:
        found = self._quick(tree)
        if not close(
            _sizes(found) if either_sign else found, _sizes(needed[:QUICK]) if either_sign else needed[:QUICK]
        ):
            return False
        found = self._screen(tree)
        return close(_sizes(found), _sizes(needed)) if either_sign else close(found, needed)

    def _single(self, tree: Tree, besides: Terms = frozenset()) -> Iterator[Candidate]:
        for part in self.parts(tree, besides):
            for edit in self._replacements(part):
                if edit.tree == part.node:  # no edit, though what is right in floating point seems one
                    continue
                yield Candidate(replace_at(tree, part.path, edit.tree), edit.words, edit.cost)

    def _double(self, tree: Tree) -> Iterator[Candidate]:
        firsts = [
            Candidate(replace_at(tree, path, edit.tree), edit.words, edit.cost)
            for path, node in walk(tree)
            for edit in (*alternatives(node, self._kinds), *exchanged(node), *other_numbers(node))
            if edit.cost <= LIKELY
        ]
        printed = self._screen(tree)
        for first in sorted(firsts, key=lambda candidate: candidate.cost)[:FIRST_EDITS]:
            if self._is_worth(first.tree, self._target):
                yield first
                continue
            if printed is not None and self._is_worth(first.tree, printed):
                continue  # it changes nothing, such as the sign of an angle in a cosine
            for second in self._single(first.tree):
                if second.tree != tree and second.cost < 2:
                    yield Candidate(second.tree, f"{first.words}; {second.words}", first.cost + second.cost + 1)

    def parts(self, tree: Tree, besides: Terms = frozenset()) -> Iterator[Part]:
        """Every part of which can be said what it would have to be worth, besides these terms of sums."""
        waiting = [Part((), tree, None, self._target, is_all=True)]
        while waiting:
            part = waiting.pop()
            wanted = self._screen.required(part.node, part.needed)
            yield part
            for place, (child, needed) in enumerate(zip(children(part.node), wanted, strict=False)):
                is_right = isinstance(part.node, Sum) and _rounded(self._quick(child)) in besides
                if needed is not None and not is_right:
                    is_all = part.is_all and isinstance(part.node, Negation)
                    waiting.append(Part((*part.path, place), child, part.node, needed, is_all))

    def _replacements(self, part: Part) -> Iterator[Alternative]:
        for edit in alternatives(part.node, self._kinds):
            if self._is_worth(edit.tree, part.needed, either_sign=part.has_either_sign):
                yield edit
        yield from self._exchanges(part)
        yield from self._number(part)
        if close(part.needed, self._screen.constant(0)):
            yield Alternative(Number("0"), "{} should be 0", 1.2, (part.node,))
            return
        ratio = self._fitter.fit(self._by(truediv, part))
        if ratio is not None:
            yield from self._sign_or_factor(part, ratio)
            return
        yield from self._piece_as_factor(part)
        yield from self._piece_as_term(part)
        yield from self._other_piece(part)
        yield from self._missing_term(part)
        yield from self._other_term(part)

    def _exchanges(self, part: Part) -> Iterator[Alternative]:
        """Other neighbouring terms or factors, weighed by what the rest of them make together."""
        node = part.node
        if not isinstance(node, Sum | Product):
            return
        if part.has_either_sign:
            every = (one.of(node) for one in exchanges(node))
            yield from (edit for edit in every if self._is_worth(edit.tree, part.needed, either_sign=True))
            return
        before, after = self._quick.running(node)
        for one in exchanges(node):
            values = combined(OPERATIONS[type(node)], before[one.place], *map(self._quick, one.new), after[one.end])
            if close(values, part.needed[:QUICK]) and close(self._screen((edit := one.of(node)).tree), part.needed):
                yield edit

    def _by(self, operation: Callable[[float, float], float], part: Part) -> Values | None:
        """What is needed by what is printed: the ratio or the difference."""
        return combined(operation, part.needed, self._screen(part.node))

    def _piece_as_factor(self, part: Part) -> Iterator[Alternative]:
        """A part of the derived formula that is missing as a factor or a divisor; to a number it is no edit."""
        if part.is_shared or _is_number(part.node):
            return
        ratio = self._by(truediv, part)
        for piece, sign in self._pieces.find(ratio):
            yield Alternative(_signed(_product(part.node, piece), sign), "a missing factor {}", 2.0, (piece,))
        for piece, sign in self._pieces.find(ratio and combined(lambda value: 1 / value, ratio)):
            yield Alternative(_signed(Quotient(part.node, piece), sign), "a missing divisor {}", 2.0, (piece,))

    def _piece_as_term(self, part: Part) -> Iterator[Alternative]:
        """A part of the derived formula that is missing as a term; of a sum it is one, whatever its sign."""
        if isinstance(part.parent, Sum | Negation):
            return
        for piece, sign in self._pieces.find(self._by(sub, part)):
            yield Alternative(Sum((*_terms(part.node), _signed(piece, sign))), "a missing term {}", 2.0, (piece,))

    def _other_piece(self, part: Part) -> Iterator[Alternative]:
        """A part of the derived formula for which another stands; all of it for all of it would be no edit."""
        if part.is_all or isinstance(part.node, Number | Name):
            return
        for piece, sign in self._pieces.find(part.needed):
            tree = _signed(piece, sign)
            yield Alternative(tree, "{} should be {}", 2.5, (part.node, tree))

    def _number(self, part: Part) -> Iterator[Alternative]:
        """A number that should be another."""
        if not _is_number(part.node) or (isinstance(part.node, Number) and isinstance(part.parent, Negation)):
            return
        monomial = self._fitter.fit(part.needed)
        if monomial is not None and monomial.is_number and monomial.number != _value(part.node):
            tree = number_tree(monomial.number)
            yield Alternative(tree, "{} should be {}", _cost_of_number(part, monomial.number), (part.node, tree))

    def _sign_or_factor(self, part: Part, ratio: Monomial) -> Iterator[Alternative]:
        is_base = isinstance(part.node, Constant) and isinstance(part.parent, Power)  # of e to a power nothing is lost
        if part.is_shared or is_base or ratio.complexity > MOST_COMPLEX:
            return
        node = part.node
        signed = node
        if ratio.number < 0:
            signed = node.operand if isinstance(node, Negation) else Negation(node)
        if not ratio.is_number or abs(ratio.number) != 1:
            kind = "a missing factor" if ratio.number > 0 else "a factor"
            cost = 1.5 + 0.3 * ratio.complexity + SCATTERED * max(len(ratio.powers) - 2, 0)
            where, about = ("", ()) if part.is_all else (" of {}", (node,))
            yield Alternative(_times(signed, ratio), f"{kind} {{}}{where}", cost, (ratio.signed(), *about))
        elif ratio.number < 0 and not isinstance(part.parent, Sum):
            cost = 1.4 if isinstance(part.parent, Call | Power) else 1.0
            yield Alternative(signed, "the sign of {}", cost, (node,))

    def _missing_term(self, part: Part) -> Iterator[Alternative]:
        if not isinstance(part.node, Sum) and part.parent is not None:
            return
        rest = self._fitter.fit(self._by(sub, part))
        if rest is not None and rest.complexity <= 2 * MOST_COMPLEX:
            term = rest.signed()
            tree = Sum((*_terms(part.node), term))
            yield Alternative(tree, "a missing term {}", 2.0 + 0.2 * rest.complexity, (term,))

    def _other_term(self, part: Part) -> Iterator[Alternative]:
        if not isinstance(part.parent, Sum) or isinstance(part.node, Number):
            return
        term = self._fitter.fit(part.needed)
        if term is not None and term.complexity <= 2 * MOST_COMPLEX:
            cost = 2.2 + 0.2 * term.complexity
            yield Alternative(term.signed(), "{} should be {}", cost, (part.node, term.signed()))

    def _factors(self, symbols: Sequence[str], trees: Sequence[Tree]) -> list[tuple[Tree, Values]]:
        """What a missing factor may consist of: the symbols, and functions like those that occur.

        A factor that follows from earlier ones is not seen. A function therefore comes with its partner: sin(2*x)
        follows from sin(x) and cos(x). An angle comes last: its powers are nearly those of its sine and cosine.
        """
        calls = [node for node in parts(*trees) if isinstance(node, Call)]
        paired = [call for call in calls if call.function in PARTNERS]
        pairs = [one for call in paired for one in (call, Call(PARTNERS[call.function], call.arguments))]
        growth = [call for call in calls if call.function == "exp"]
        angles = frozenset[str]().union(*(names_of(call) for call in paired if call.function in PERIODIC))
        first, last = ([Name(name) for name in symbols if (name in angles) is is_angle] for is_angle in (False, True))
        factors: list[Tree] = [*first, *pairs, *growth, *last]
        found = [(tree, self._screen(tree)) for tree in dict.fromkeys(factors)]
        return [(tree, values) for tree, values in found if values is not None][:FACTORS]


def _size(tree: Tree) -> int:
    return Fold[int](lambda _, below: 1 + sum(below))(tree)


def _small(found: Iterable[Candidate], tree: Tree) -> list[Candidate]:
    """Those that are an edit of the formula and not another one in its place, likely ones first.

    Nobody means a function of its inverse: an edit that makes one has found the values by a detour.
    """
    size_of = Fold[int](lambda _, below: 1 + sum(below))
    detours = Fold[int](lambda node, below: undoes(node) + sum(below))
    size = size_of(tree)
    most = size + max(size, 1 if isinstance(tree, Number) else SMALL)
    small = [one for one in found if tree == Number("0") or size_of(one.tree) <= most]  # a zero lacks its terms
    plain = [one for one in small if not detours(one.tree) or detours(one.tree) < detours(tree)]
    return sorted(plain, key=lambda candidate: candidate.cost)


def _sizes(values: Values | None) -> Values | None:
    """The absolute values."""
    return values and tuple(map(abs, values))


def _rounded(values: Values | None) -> Values | None:
    return values and tuple(float(f"{value:.8e}") for value in values)


def _terms(tree: Tree) -> tuple[Tree, ...]:
    return tree.terms if isinstance(tree, Sum) else (tree,)


def _cost_of_number(part: Part, number: Fraction) -> float:
    """How unlikely it is that another number was meant: a sign less, a fraction that nobody would print so least."""
    if number.denominator > 1 and not isinstance(part.parent, Power):
        if part.is_below:
            return FRACTION_BELOW
        if isinstance(part.node, Number) and part.node.value.denominator == 1 and number.numerator > 1:
            return ODD_FRACTION
    return 1.0 if number > 0 else 1.6


def _is_number(tree: Tree) -> bool:
    """Whether it is a rational number as it is written."""
    if isinstance(tree, Negation | Quotient):
        return all(isinstance(child, Number) for child in children(tree))
    return isinstance(tree, Number)


def _value(tree: Tree) -> Fraction | None:
    """That of a rational number as it is written."""
    match tree:
        case Number():
            return tree.value
        case Negation(Number() as operand):
            return -operand.value
        case Quotient(Number() as above, Number() as below) if below.value:
            return above.value / below.value
        case _:
            return None


def _signed(tree: Tree, sign: int) -> Tree:
    return tree if sign > 0 else Negation(tree)


def _times(node: Tree, factor: Monomial) -> Tree:
    """The node with a factor, whose sign the node has already."""
    if isinstance(node, Negation):
        return Negation(_times(node.operand, factor))
    tree = factor.tree()
    above, below = (tree.numerator, tree.denominator) if isinstance(tree, Quotient) else (tree, None)
    if isinstance(node, Quotient) and below is None:
        return Quotient(_product(above, node.numerator), node.denominator)
    product = _product(above, node)
    return product if below is None else Quotient(product, below)


def _product(first: Tree, second: Tree) -> Tree:
    parts = [part for tree in (first, second) for part in (tree.factors if isinstance(tree, Product) else (tree,))]
    kept = tuple(part for part in parts if part != Number("1")) or (Number("1"),)
    return kept[0] if len(kept) == 1 else Product(kept)
