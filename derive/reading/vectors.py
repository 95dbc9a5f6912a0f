"""What print takes for granted about arrays: a·b and x' P x are numbers, and e^{FT} is a matrix."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from itertools import chain
from math import prod
from operator import is_

from radartrack.derive.formula.error import FormulaError
from radartrack.derive.formula.fold import rebuild
from radartrack.derive.formula.functions import VERBS
from radartrack.derive.formula.shape import MAX_ROWS, Shape, product_shape, shapes
from radartrack.derive.formula.tree import (
    Array,
    Call,
    Constant,
    Entries,
    Name,
    Number,
    Power,
    Product,
    Quotient,
    Sum,
    Tree,
    children,
    parts,
    with_children,
)

ZERO = Number("0")
MOST_FACTORS = 30  # of a product of vectors: each number among them is one bracket more
ShapeOf = Callable[[Tree], Shape | None]


def with_numbers(tree: Tree, names: Mapping[str, Shape]) -> Tree:
    """The formula with products of vectors as numbers, bars around a number as its magnitude, powers of e as matrices.

    Args:
        tree: the formula.
        names: the shapes of names that stand for arrays.
    """
    if not any(_may_be_array(node, names) for node in parts(tree)):
        return tree
    known = shapes(defaultdict(tuple, names))

    def shape_of(node: Tree) -> Shape | None:
        try:
            return known(node)
        except FormulaError:  # is told when the whole formula is looked at
            return None

    return rebuild(tree, lambda node: _changed(node, shape_of))


def _may_be_array(node: Tree, names: Mapping[str, Shape]) -> bool:
    is_name = isinstance(node, Name) and node.name in names
    return is_name or isinstance(node, Array | Entries) or (isinstance(node, Call) and node.function in VERBS)


def _changed(node: Tree, shape_of: ShapeOf) -> Tree:
    match node:
        case Product():
            return _multiplied(node, shape_of)
        case Array(rows) if (blocks := _blocks(rows, shape_of)) is not None:
            return replace(node, entries=blocks)
        case Sum() | Array() if any(shape_of(part) == () for part in children(node)):
            return _with_picked(node, children(node), shape_of)
        case Quotient(_, denominator):
            return _with_picked(node, (denominator,), shape_of)
        case Power(Constant("e"), exponent) | Call("exp", (exponent,)) if _is_matrix(shape_of(exponent)):
            return Call("expm", (exponent,), span=node.span)
        case Power(base, _) if shape_of(base) != (1, 1):  # whose power is one of a matrix as well
            return _with_picked(node, children(node), shape_of)
        case Call():
            return _called(node, shape_of)
    return node


def _called(node: Call, shape_of: ShapeOf) -> Tree:
    match node:
        case Call("norm", (argument,)) if shape_of(argument) == ():
            return replace(node, function="abs")
        case Call("diag", matrices) if len(matrices) > 1 and any(shape_of(one) for one in matrices):
            return _diagonal(node, matrices, shape_of)
        case Call("kron", (Call("eye", (Number() as order,)), block)) if shape_of(node):
            return _diagonal(node, [block] * int(order.text), shape_of)
        case Call("kron", (block, Call("eye", (Number() as order,)))) if shape_of(node):
            return _scattered(node, block, int(order.text), shape_of)
        case Call(function) if function not in VERBS:
            return _with_picked(node, children(node), shape_of)
    return node


def _blocks(rows: Sequence[Tree], shape_of: ShapeOf) -> tuple[Tree, ...] | None:
    """The rows of the matrix that rows of matrices make, in which 0 stands for any number of zeros."""
    cells = [row.entries for row in rows if isinstance(row, Array)]
    if len(cells) < len(rows) or len({len(row) for row in cells}) != 1:
        return None
    if not any(_is_matrix(shape_of(cell)) for cell in chain(*cells)):
        return None
    shapes = [[_as_block(shape_of(cell)) if cell != ZERO else None for cell in row] for row in cells]
    if len(cells) == len(cells[0]) == 1:
        return None
    heights = [max((one[0] for one in row if one), default=0) for row in shapes]
    widths = [max((one[1] for one in column if one), default=0) for column in zip(*shapes, strict=True)]
    if max(sum(heights), sum(widths)) > MAX_ROWS:
        return None
    made = []
    for row, found, height in zip(cells, shapes, heights, strict=True):
        fits = all(one == (height, width) or cell == ZERO for cell, one, width in zip(row, found, widths, strict=True))
        if not fits or not height or not all(widths):
            return None
        for at in range(height):
            entries = (
                _entry(cell, shape_of, at, j) for cell, width in zip(row, widths, strict=True) for j in range(width)
            )
            made.append(Array(tuple(entries)))
    return tuple(made)


def _diagonal(node: Tree, matrices: Sequence[Tree], shape_of: ShapeOf) -> Tree:
    """The matrix with these on its diagonal, where they are matrices; else the node as it stands."""
    places = range(len(matrices))
    rows = tuple(Array(tuple(matrices[at] if at == own else ZERO for at in places)) for own in places)
    blocks = _blocks(rows, shape_of)
    return node if blocks is None else Array(blocks, span=node.span)


def _scattered(node: Tree, block: Tree, axes: int, shape_of: ShapeOf) -> Tree:
    """The matrix with the entries of the block for each axis, one axis after the other in each row."""
    rows, columns = (range(axes * size) for size in shape_of(block) or ())

    def entry(row: int, column: int) -> Tree:
        return _entry(block, shape_of, row // axes, column // axes) if row % axes == column % axes else ZERO

    return Array(tuple(Array(tuple(entry(row, column) for column in columns)) for row in rows), span=node.span)


def _is_matrix(found: Shape | None) -> bool:
    return found is not None and len(found) == len(("rows", "columns"))


def _as_block(found: Shape | None) -> Shape | None:
    """The rows and columns of a cell: a vector is a column, a number one entry."""
    return found if found is None or len(found) > len(("rows", "columns")) else (*found, 1, 1)[:2]


def _entry(cell: Tree, shape_of: ShapeOf, row: int, column: int) -> Tree:
    rank = len(shape_of(cell) or ())
    if not rank:
        return cell
    if isinstance(cell, Array) and rank == 1:
        return cell.entries[row]
    if isinstance(cell, Array) and isinstance(inner := cell.entries[row], Array):
        return inner.entries[column]
    return Entries(cell, (row, column)[:rank], span=cell.span)


def _with_picked(node: Tree, chosen: Sequence[Tree], shape_of: ShapeOf) -> Tree:
    """The node with numbers for those of its parts that are arrays of one entry."""
    new = tuple(_number(part, shape_of(part)) if part in chosen else part for part in children(node))
    return node if all(map(is_, new, children(node))) else with_children(node, new)


def _number(tree: Tree, found: Shape | None) -> Tree:
    """The entry of an array of one."""
    return Entries(tree, (0,) * len(found), span=tree.span) if found and prod(found) == 1 else tree


def _multiplied(node: Product, shape_of: ShapeOf) -> Tree:
    """A product in which a vector before another one is a row, and an array of one entry a number before any array."""
    before: list[Tree] = []
    if len(node.factors) > MOST_FACTORS:
        return node
    for factor in node.factors:
        so_far, own = (shape_of(_product(before)) if before else ()), shape_of(factor)
        if not so_far or not own or product_shape(so_far, own) is not None:
            before.append(factor)
        elif own == so_far and prod(own) == max(own):
            before = [Call("transpose", (_product(before),), span=before[0].span), factor]
        else:
            before = [_number(_product(before), so_far), _number(factor, own)]
    is_same = len(before) == len(node.factors) and all(map(is_, before, node.factors))
    return node if is_same else replace(node, factors=tuple(before))


def _product(factors: Sequence[Tree]) -> Tree:
    return factors[0] if len(factors) == 1 else Product(tuple(factors), span=factors[0].span)
