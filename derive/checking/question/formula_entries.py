"""The entries of a formula of arrays as formulas of numbers.

Factors and terms are distributed to the entries. What is worked out and not only written, such as a product of matrices
or a sum over an index, stands in an entry as one name that is spelled as it is printed; so an entry can be searched for
slips and printed again.
"""

from __future__ import annotations

from operator import is_
from typing import Protocol

from radartrack.derive.checking.question.formula_units import Dimension
from radartrack.derive.checking.question.meaning import Meaning, shape_of
from radartrack.derive.formula.functions import VERBS
from radartrack.derive.formula.printing import to_text
from radartrack.derive.formula.shape import Shape, shapes
from radartrack.derive.formula.to_expression import Expression
from radartrack.derive.formula.tree import (
    Array,
    Call,
    Entries,
    Name,
    Negation,
    Number,
    Product,
    Quotient,
    Sum,
    Tree,
    children,
    with_children,
)
from radartrack.derive.language.tensor import Index, Tensor
from radartrack.derive.symbolic import Expr


class Vocabulary(Protocol):
    """What is known of names, and of what is made of them."""

    def __contains__(self, name: object) -> bool: ...
    def __getitem__(self, name: str) -> Expression: ...
    def read(self, tree: Tree) -> Expr:
        """A tree that is a number, worked out."""
        ...

    def dimension_of_part(self, node: Tree) -> Dimension:
        """The dimension of what is worked out."""
        ...


def entries_of(tree: Tree, names: Vocabulary) -> tuple[Tensor[Tree], dict[str, Meaning]]:
    """The entries of a formula, and what the names in them stand for that were parts of it."""
    opener = _Opener(names)
    found = Tensor.build(opener.shape(tree), lambda *index: opener.entry(tree, index))
    return found, opener.parts


class _Opener:
    def __init__(self, names: Vocabulary) -> None:
        self._names = names
        self._known: dict[int, tuple[Tree, Tree]] = {}
        self.shape = shapes(_Shapes(names))
        self.parts: dict[str, Meaning] = {}

    def entry(self, tree: Tree, index: Index) -> Tree:
        """One entry of an array, or a number."""
        if not index or not self.shape(tree):
            return self._number(tree)
        match tree:
            case Array(entries):
                return self.entry(entries[index[0]], index[1:])
            case Sum(terms):
                return Sum(tuple(self.entry(term, index) for term in terms))
            case Negation(operand):
                return Negation(self.entry(operand, index))
            case Quotient(numerator, denominator):
                return Quotient(self.entry(numerator, index), self._number(denominator))
            case Product(factors) if sum(bool(self.shape(factor)) for factor in factors) == 1:
                return _product(tuple(self.entry(factor, index) for factor in factors))
            case _:
                return self._part(Entries(tree, index, span=tree.span))

    def _number(self, tree: Tree) -> Tree:
        if id(tree) not in self._known:
            self._known[id(tree)] = tree, self._opened(tree)
        return self._known[id(tree)][1]

    def _opened(self, tree: Tree) -> Tree:
        if isinstance(tree, Entries) or (isinstance(tree, Call) and tree.function in VERBS):
            return self._part(tree)
        below = children(tree)
        new = tuple(map(self._number, below))
        return tree if all(map(is_, below, new)) else with_children(tree, new)

    def _part(self, node: Tree) -> Name:
        name = to_text(node)
        if name not in self.parts:
            value, names = self._names.read(node), self._names
            self.parts[name] = Meaning(value, lambda _: names.dimension_of_part(node))
        return Name(name, span=node.span)


class _Shapes(dict[str, Shape]):
    """The shapes of names, found when they are asked for."""

    def __init__(self, names: Vocabulary) -> None:
        super().__init__()
        self._names = names

    def __missing__(self, name: str) -> Shape:
        self[name] = shape_of(self._names[name]) if name in self._names else ()
        return self[name]


def _product(factors: tuple[Tree, ...]) -> Tree:
    """The factors without ones, those of products among them side by side."""
    kept = tuple(factor for factor in factors if factor != Number("1")) or (Number("1"),)
    flat = tuple(part for factor in kept for part in (factor.factors if isinstance(factor, Product) else (factor,)))
    return flat[0] if len(flat) == 1 else Product(flat)
