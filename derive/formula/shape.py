"""Scalars, vectors, matrices and tensors: which may be added, multiplied and put into which."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TypeAlias

from radartrack.derive.formula.error import FormulaError
from radartrack.derive.formula.fold import Fold
from radartrack.derive.formula.tree import Array, Negation, Product, Quotient, Sum, Tree

MAX_RANK = 3

Shape: TypeAlias = tuple[int, ...]


def shape(tree: Tree) -> Shape:
    """The shape of a formula, as of a NumPy array: () for a scalar.

    Raises:
        FormulaError: where an array stands that has no meaning there, or its rows are of different lengths.
    """
    return Fold(_shape)(tree)


def _shape(tree: Tree, shapes: Sequence[Shape]) -> Shape:
    match tree:
        case Array():
            return _stacked(tree, shapes)
        case Sum():
            return _common(tree, shapes)
        case Negation():
            return shapes[0]
        case Product():
            return _scaled(tree, shapes)
        case Quotient() if not shapes[1]:
            return shapes[0]
        case _ if any(shapes):
            raise FormulaError(
                "a vector or matrix cannot stand in a denominator, a power or a function", span=tree.span
            )
        case _:
            return ()


def _stacked(tree: Array, shapes: Sequence[Shape]) -> Shape:
    if len(set(shapes)) > 1:
        raise FormulaError("the rows of this array differ in length", span=tree.span)
    if len(shapes[0]) >= MAX_RANK:
        raise FormulaError(f"arrays are nested at most {MAX_RANK} deep", span=tree.span)
    return (len(shapes), *shapes[0])


def _common(tree: Sum, shapes: Sequence[Shape]) -> Shape:
    if len(set(shapes)) > 1:
        different = " and ".join(dict.fromkeys(map(_spoken, shapes)))
        raise FormulaError(f"{different} cannot be added", span=tree.span)
    return shapes[0]


def _scaled(tree: Product, shapes: Sequence[Shape]) -> Shape:
    arrays = [factor for factor in shapes if factor]
    if len(arrays) > 1:
        raise FormulaError("a product holds at most one vector or matrix: write out its entries", span=tree.span)
    return arrays[0] if arrays else ()


def _spoken(one: Shape) -> str:
    return f"an array of shape {one}" if one else "a scalar"
