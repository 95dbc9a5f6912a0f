"""A printed formula as a tree: what was printed, in the order it was printed, before any algebra.

Brackets leave no trace but the shape of the tree; signs, quotients and the grouping of sums and products
stay as printed. Trees are equal when they print the same; where a node stood in the text (`span`) does not
count.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from fractions import Fraction
from functools import lru_cache
from operator import attrgetter
from types import MappingProxyType
from typing import TypeAlias, TypeVar

from radartrack.derive.formula.error import Span
from radartrack.derive.formula.functions import BINDING, VERBS

Path: TypeAlias = tuple[int, ...]


@dataclass(frozen=True, slots=True, kw_only=True)
class Node:
    """What every node has: where in the text it stood, brackets included, if it was read from text."""

    span: Span | None = field(default=None, compare=False, repr=False)


@dataclass(frozen=True, slots=True)
class Number(Node):
    """A number without a sign, as printed: `2`, `0.50`, `1e-3`."""

    text: str

    @property
    def value(self) -> Fraction:
        """The exact value of the decimal."""
        return _fraction(self.text)


_fraction = lru_cache(maxsize=1024)(Fraction)


@dataclass(frozen=True, slots=True)
class Constant(Node):
    """`pi`, or `e` for Euler's number."""

    name: str


@dataclass(frozen=True, slots=True)
class Name(Node):
    """A symbol."""

    name: str


@dataclass(frozen=True, slots=True)
class Sum(Node):
    """Two or more terms; one that is subtracted is a `Negation`."""

    terms: tuple[Tree, ...]


@dataclass(frozen=True, slots=True)
class Product(Node):
    """Two or more factors."""

    factors: tuple[Tree, ...]


@dataclass(frozen=True, slots=True)
class Quotient(Node):
    """A fraction or a division."""

    numerator: Tree
    denominator: Tree


@dataclass(frozen=True, slots=True)
class Negation(Node):
    """A minus sign before something."""

    operand: Tree


@dataclass(frozen=True, slots=True)
class Power(Node):
    """A base raised to an exponent."""

    base: Tree
    exponent: Tree


@dataclass(frozen=True, slots=True)
class Call(Node):
    """A function or a verb of `radartrack.derive.formula.functions`, by its name there, and its arguments."""

    function: str
    arguments: tuple[Tree, ...]


@dataclass(frozen=True, slots=True)
class Array(Node):
    """A vector, or, when its entries are arrays, a matrix or a tensor by rows."""

    entries: tuple[Tree, ...]


@dataclass(frozen=True, slots=True)
class Entries(Node):
    """One entry of an array, or those of a slice: along each axis a place, or from where to where, None for an end."""

    array: Tree
    places: tuple[Place, ...]


Place: TypeAlias = "int | tuple[int | None, int | None]"
Tree: TypeAlias = Number | Constant | Name | Sum | Product | Quotient | Negation | Power | Call | Array | Entries
AnyTree = TypeVar("AnyTree", bound=Node)


def children(tree: Tree) -> tuple[Tree, ...]:
    """The subtrees directly below, in the order printed."""
    return _CHILDREN[type(tree)](tree)


_CHILDREN: Mapping[type[Tree], Callable[..., tuple[Tree, ...]]] = MappingProxyType(
    {
        Sum: attrgetter("terms"),
        Product: attrgetter("factors"),
        Call: attrgetter("arguments"),
        Array: attrgetter("entries"),
        Quotient: attrgetter("numerator", "denominator"),
        Power: attrgetter("base", "exponent"),
        Negation: lambda tree: (tree.operand,),
        Entries: lambda tree: (tree.array,),
        **dict.fromkeys((Number, Constant, Name), lambda _: ()),
    }
)


def with_children(tree: Tree, new: tuple[Tree, ...]) -> Tree:
    """The same node over other subtrees, as many as it has."""
    match tree:
        case Sum():
            return replace(tree, terms=new)
        case Product():
            return replace(tree, factors=new)
        case Call():
            return replace(tree, arguments=new)
        case Array():
            return replace(tree, entries=new)
        case _:
            return _with_fixed_children(tree, new)


def _with_fixed_children(
    tree: Number | Constant | Name | Quotient | Negation | Power | Entries, new: tuple[Tree, ...]
) -> Tree:
    match tree:
        case Quotient():
            numerator, denominator = new
            return replace(tree, numerator=numerator, denominator=denominator)
        case Power():
            base, exponent = new
            return replace(tree, base=base, exponent=exponent)
        case Negation():
            (operand,) = new
            return replace(tree, operand=operand)
        case Entries():
            (array,) = new
            return replace(tree, array=array)
        case Number() | Constant() | Name():
            return tree


def with_span(tree: AnyTree, span: Span | None) -> AnyTree:
    """The same tree, said to stand elsewhere in the text."""
    return replace(tree, span=span)


def walk(tree: Tree) -> Iterator[tuple[Path, Tree]]:
    """Every subtree with the path that leads to it, the whole tree first."""
    waiting: list[tuple[Path, Tree]] = [((), tree)]
    while waiting:
        path, node = waiting.pop()
        yield path, node
        below = enumerate(children(node))
        waiting.extend(reversed([((*path, index), child) for index, child in below]))


def subtree(tree: Tree, path: Path) -> Tree:
    """The subtree that a path leads to."""
    for index in path:
        tree = children(tree)[index]
    return tree


def replace_at(tree: Tree, path: Path, new: Tree) -> Tree:
    """The tree with the subtree at a path replaced."""
    if not path:
        return new
    below = list(children(tree))
    below[path[0]] = replace_at(below[path[0]], path[1:], new)
    return with_children(tree, tuple(below))


def parts(*trees: Tree) -> Iterator[Tree]:
    """Every subtree, each object once however often it stands there, the whole trees first."""
    seen: set[int] = set()
    waiting = list(reversed(trees))
    while waiting:
        node = waiting.pop()
        if id(node) not in seen:
            seen.add(id(node))
            yield node
            waiting.extend(reversed(children(node)))


def names(tree: Tree) -> frozenset[str]:
    """The symbols that occur; the constants pi and e are none."""
    return frozenset(node.name for node in parts(tree) if isinstance(node, Name))


def bound_names(tree: Tree) -> frozenset[str]:
    """The names that verbs bring with them: indices of sums, variables of integration."""
    verbs = (node for node in parts(tree) if isinstance(node, Call) and node.function in BINDING)
    return frozenset(verb.arguments[1].name for verb in verbs if isinstance(verb.arguments[1], Name))


def has_verbs(tree: Tree) -> bool:
    """Whether verbs, products of arrays or picked entries occur, which are worked out and not only written."""
    return any(isinstance(node, Entries) or (isinstance(node, Call) and node.function in VERBS) for node in parts(tree))


def rational_value(tree: Tree) -> Fraction | None:
    """The value of a formula of rational numbers alone; None of any other."""
    match tree:
        case Number():
            return tree.value
        case Negation(operand):
            value = rational_value(operand)
            return None if value is None else -value
        case Quotient(numerator, denominator):
            above, below = rational_value(numerator), rational_value(denominator)
            return None if above is None or not below else above / below
        case _:
            return None
