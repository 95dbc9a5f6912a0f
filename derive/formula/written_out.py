"""Arrays written out: what products of matrices, transposes and slices are, entry by entry, as printed formulas.

Nothing is worked out in symbols, so it serves formulas of which it is not known yet what their letters mean.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import reduce
from operator import is_
from types import MappingProxyType

from radartrack.derive.formula.error import FormulaError
from radartrack.derive.formula.fold import Fold
from radartrack.derive.formula.functions import VERBS
from radartrack.derive.formula.shape import shape
from radartrack.derive.formula.tree import (
    Array,
    Call,
    Entries,
    Name,
    Negation,
    Number,
    Place,
    Power,
    Product,
    Quotient,
    Sum,
    Tree,
    children,
    with_children,
)
from radartrack.derive.language.tensor import Tensor

MOST = 20_000  # parts of an entry: of a product of many matrices it has many terms
HIGHEST = 12  # power of a matrix
LARGEST = 3  # rows of a matrix that is inverted
ZERO, ONE = Number("0"), Number("1")

Opened = Tensor[Tree] | None
_BY_COFACTORS = {"det", "inv"}
NO_ARRAYS: Mapping[str, Tensor[Tree]] = MappingProxyType({})


def written_out(tree: Tree, arrays: Mapping[str, Tensor[Tree]] = NO_ARRAYS) -> Opened:
    """The entries of a formula; None where something in it has to be worked out, such as a sum or a derivative.

    Args:
        tree: the formula.
        arrays: the entries of names that stand for arrays.

    Raises:
        FormulaError: where an array stands that has no meaning there, and for entries that become too long.
    """
    shape(tree, {name: entries.shape for name, entries in arrays.items()})

    def step(node: Tree, below: Sequence[Opened]) -> Opened:
        known = [one for one in below if one is not None]
        if len(known) < len(below):
            return None
        if isinstance(node, Name):
            return arrays.get(node.name, Tensor((), (node,)))
        return _opened(node, known)

    found = Fold(step)(tree)
    length = Fold(_length)
    if found is not None and sum(map(length, found)) > MOST:
        raise FormulaError(f"written out, the formula has more than {MOST} parts", span=tree.span)
    return found


def _length(_node: Tree, below: Sequence[int]) -> int:
    return 1 + sum(below)


def _opened(node: Tree, below: list[Tensor[Tree]]) -> Opened:
    if isinstance(node, Array):
        return Tensor((len(below), *below[0].shape), tuple(entry for part in below for entry in part))
    if isinstance(node, Entries):
        return _picked(below[0], node.places)
    if isinstance(node, Call) and node.function in VERBS:
        is_large = node.function in _BY_COFACTORS and below[0].shape[0] > LARGEST
        return None if is_large or node.function not in _OPENED else _OPENED[node.function](below)
    if any(one.shape for one in below):
        return _of_arrays(node, below)
    new = tuple(one.entries[0] for one in below)
    return Tensor((), (node if all(map(is_, new, children(node))) else with_children(node, new),))


def _of_arrays(node: Tree, below: list[Tensor[Tree]]) -> Opened:
    match node:
        case Sum():
            return Tensor(below[0].shape, tuple(Sum(terms) for terms in zip(*below, strict=True)))
        case Negation():
            return below[0].map(Negation)
        case Quotient():
            return below[0].map(lambda entry: Quotient(entry, below[1].entries[0]))
        case Product():
            return reduce(_times, below)
        case Power(_, Number() as exponent) if exponent.text.isdigit() and 1 <= int(exponent.text) <= HIGHEST:
            return reduce(_times, [below[0]] * int(exponent.text))
        case _:
            return None


def _times(first: Tensor[Tree], second: Tensor[Tree]) -> Tensor[Tree]:
    """The product of arrays, of which either may be a number; a vector before a row is a column."""
    if not first.shape or not second.shape:
        return Tensor(first.shape or second.shape, tuple(product_of((one, other)) for one in first for other in second))
    if len(first.shape) == 1:
        first = Tensor((*first.shape, 1), first.entries)
    rows, columns = dict(first.items()), dict(second.items())
    return Tensor.build(
        (first.shape[0], *second.shape[1:]),
        lambda i, *j: _sum([product_of((rows[i, k], columns[(k, *j)])) for k in range(first.shape[1])]),
    )


def _picked(array: Tensor[Tree], places: Sequence[Place]) -> Tensor[Tree]:
    known = dict(array.items())
    axes: list[list[int]] = []
    for axis, size in enumerate(array.shape):
        place = places[axis] if axis < len(places) else (None, None)
        axes.append([place] if isinstance(place, int) else list(range(size))[slice(*place)])
    kept = [axis for axis in range(len(axes)) if axis >= len(places) or not isinstance(places[axis], int)]
    fixed = [axis[0] for axis in axes]

    def entry(*index: int) -> Tree:
        whole = list(fixed)
        for axis, at in zip(kept, index, strict=True):
            whole[axis] = axes[axis][at]
        return known[tuple(whole)]

    return Tensor.build(tuple(len(axes[axis]) for axis in kept), entry)


def _transposed(below: list[Tensor[Tree]]) -> Tensor[Tree]:
    array = below[0]
    if len(array.shape) == 1:
        return Tensor((1, *array.shape), array.entries)
    known = dict(array.items())
    return Tensor.build(array.shape[::-1], lambda i, j: known[j, i])


def _diagonal(below: list[Tensor[Tree]]) -> Tensor[Tree]:
    entries = [entry for one in below for entry in one]
    return Tensor.build((len(entries),) * 2, lambda i, j: entries[i] if i == j else ZERO)


def _unit(below: list[Tensor[Tree]]) -> Tensor[Tree]:
    order = below[0].entries[0]
    size = int(order.text) if isinstance(order, Number) else 0
    return _diagonal([Tensor((size,), (ONE,) * size)])


def _outer(below: list[Tensor[Tree]]) -> Tensor[Tree]:
    first, second = below
    return Tensor((*first.shape, *second.shape), tuple(product_of((a, b)) for a in first for b in second))


def kronecker(below: Sequence[Tensor[Tree]]) -> Tensor[Tree]:
    """The second matrix, times an entry of the first one, for each of these."""
    first, second = (dict(one.items()) for one in below)
    rows, columns = below[1].shape
    return Tensor.build(
        (below[0].shape[0] * rows, below[0].shape[1] * columns),
        lambda i, j: product_of((first[i // rows, j // columns], second[i % rows, j % columns])),
    )


def _determinant(below: list[Tensor[Tree]]) -> Tensor[Tree]:
    return Tensor((), (_minor(_rows(below[0])),))


def _inverse(below: list[Tensor[Tree]]) -> Tensor[Tree]:
    """By cofactors: of the small matrices that are printed these are short enough."""
    rows = _rows(below[0])
    size, determinant = len(rows), _minor(rows)

    def entry(i: int, j: int) -> Tree:
        rest = [[one for column, one in enumerate(row) if column != i] for place, row in enumerate(rows) if place != j]
        cofactor = _minor(rest)
        return Quotient(cofactor if (i + j) % 2 == 0 else Negation(cofactor), determinant)

    return Tensor.build((size, size), entry)


def _rows(array: Tensor[Tree]) -> list[list[Tree]]:
    return [list(row.entries) for row in array.parts()]


def _minor(rows: list[list[Tree]]) -> Tree:
    """The determinant by its first row."""
    if not rows:
        return ONE
    terms = []
    for place, first in enumerate(rows[0]):
        if first != ZERO:
            rest = [row[:place] + row[place + 1 :] for row in rows[1:]]
            term = product_of([first, _minor(rest)])
            terms.append(Negation(term) if place % 2 and term != ZERO else term)
    return _sum(terms)


def _length_of(below: list[Tensor[Tree]]) -> Tensor[Tree]:
    """The root of the squares of a vector; the magnitude of a number."""
    entries = below[0].entries
    if not below[0].shape:
        return Tensor((), (Call("abs", entries),))
    return Tensor((), (Call("sqrt", (_sum([product_of((entry, entry)) for entry in entries]),)),))


def _trace(below: list[Tensor[Tree]]) -> Tensor[Tree]:
    known = dict(below[0].items())
    return Tensor((), (_sum([known[i, i] for i in range(below[0].shape[0])]),))


_OPENED: Mapping[str, Callable[[list[Tensor[Tree]]], Tensor[Tree]]] = MappingProxyType(
    {
        "det": _determinant,
        "diag": _diagonal,
        "eye": _unit,
        "inv": _inverse,
        "kron": kronecker,
        "norm": _length_of,
        "outer": _outer,
        "trace": _trace,
        "transpose": _transposed,
    }
)


def array_of(entries: Tensor[Tree]) -> Tree:
    """The entries as a formula: nested lists, or the number that it is."""
    if not entries.shape:
        return entries.entries[0]
    return Array(tuple(map(array_of, entries.parts())))


def product_of(factors: Sequence[Tree]) -> Tree:
    """A product without ones; zero where a factor is."""
    kept = [part for factor in factors for part in (factor.factors if isinstance(factor, Product) else (factor,))]
    if ZERO in kept:
        return ZERO
    kept = [part for part in kept if part != ONE] or [ONE]
    return kept[0] if len(kept) == 1 else Product(tuple(kept))


def _sum(terms: Sequence[Tree]) -> Tree:
    """A sum without zeros."""
    kept = tuple(term for term in terms if term != ZERO) or (ZERO,)
    return kept[0] if len(kept) == 1 else Sum(kept)
