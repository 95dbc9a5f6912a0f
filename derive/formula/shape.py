"""Scalars, vectors, matrices and tensors: which may be added, multiplied and put into which.

A product of arrays is the matrix product; a vector before a row, which is a vector transposed, stands as a column.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Mapping, Sequence
from types import MappingProxyType
from typing import TypeAlias

from radartrack.derive.formula.error import FormulaError
from radartrack.derive.formula.fold import Fold
from radartrack.derive.formula.functions import VERBS
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
)

MAX_RANK = 3
MAX_ROWS = 12  # of a unit or diagonal matrix

Shape: TypeAlias = tuple[int, ...]
NO_SHAPES: Mapping[str, Shape] = MappingProxyType({})


def shape(tree: Tree, names: Mapping[str, Shape] = NO_SHAPES) -> Shape:
    """The shape of a formula, as of a NumPy array: () for a scalar.

    Args:
        tree: the formula.
        names: the shapes of names that stand for arrays; the others are scalars.

    Raises:
        FormulaError: where an array stands that has no meaning there, or its rows are of different lengths.
    """
    return shapes(defaultdict(tuple, names))(tree)


def shapes(names: Mapping[str, Shape]) -> Fold[Shape]:
    """Finds the shapes of formulas in names of known shape; what it returns raises as `shape` does."""

    def step(node: Tree, below: Sequence[Shape]) -> Shape:
        return names[node.name] if isinstance(node, Name) else _shape(node, below)

    return Fold(step)


def shape_of_node(tree: Tree, shapes: Sequence[Shape]) -> Shape:
    """The shape of a formula whose parts have these shapes; a name is a scalar.

    Raises:
        FormulaError: as `shape`.
    """
    return _shape(tree, shapes)


def product_shape(first: Shape, second: Shape) -> Shape | None:
    """The shape of a product; None where there is none."""
    if not first or not second:
        return first or second
    if len(first) == 1 and len(second) == 2 and second[0] == 1:
        return first[0], second[1]  # a column times a row
    if len(first) == 2 and len(second) <= 2 and first[1] == second[0]:
        return (first[0], *second[1:])
    return None


def _shape(tree: Tree, shapes: Sequence[Shape]) -> Shape:
    match tree:
        case Array():
            return _stacked(tree, shapes)
        case Sum():
            return _common(tree, shapes)
        case Negation():
            return shapes[0]
        case Product():
            return _multiplied(tree, shapes)
        case Quotient() if not shapes[1]:
            return shapes[0]
        case Power() if shapes[0] and not shapes[1]:
            return _square(tree, shapes[0], "a power of a matrix")
        case Entries(_, places):
            return _picked(tree, shapes[0], places)
        case Call(function) if function in VERBS:
            return _VERBS[function](tree, shapes)
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


def _multiplied(tree: Product, shapes: Sequence[Shape]) -> Shape:
    result: Shape = ()
    for factor in shapes:
        found = product_shape(result, factor)
        if found is None:
            raise FormulaError(
                f"{_spoken(result)} and {_spoken(factor)} cannot be multiplied: the columns of the first must be as "
                "many as the rows of the second; a vector before a matrix is written as a row, x.T",
                span=tree.span,
            )
        result = found
    return result


def _square(tree: Tree, found: Shape, what: str) -> Shape:
    if len(found) != 2 or found[0] != found[1]:
        raise FormulaError(f"{what} needs as many rows as columns, this is {_spoken(found)}", span=tree.span)
    return found


def _picked(tree: Tree, found: Shape, places: Sequence[Place]) -> Shape:
    if len(places) > len(found):
        raise FormulaError(f"{_spoken(found)} has no entry with {len(places)} places", span=tree.span)
    result: list[int] = []
    for place, size in zip(places, found, strict=False):
        if isinstance(place, int):
            if place >= size:
                raise FormulaError(
                    f"the entry {place} is beyond {_spoken(found)}; counting begins at 0", span=tree.span
                )
            continue
        count = len(range(*slice(*place).indices(size)))
        if not count:
            raise FormulaError(f"this picks no entry of {_spoken(found)}", span=tree.span)
        result.append(count)
    return (*result, *found[len(places) :])


def _of_first(_tree: Call, shapes: Sequence[Shape]) -> Shape:
    """Verbs that change entries one by one; what else they are given are numbers."""
    return shapes[0]


def _matrix(tree: Call, shapes: Sequence[Shape]) -> Shape:
    return _square(tree, shapes[0], tree.function)


def _number_of_matrix(tree: Call, shapes: Sequence[Shape]) -> Shape:
    _square(tree, shapes[0], tree.function)
    return ()


def _length(tree: Call, shapes: Sequence[Shape]) -> Shape:
    """Of a vector, be it a column or a row; of a number it is the magnitude."""
    if sum(size > 1 for size in shapes[0]) > 1:
        raise FormulaError(f"the length of a vector is meant, this is {_spoken(shapes[0])}", span=tree.span)
    return ()


def _transposed(tree: Call, shapes: Sequence[Shape]) -> Shape:
    if len(shapes[0]) > 2 or not shapes[0]:
        raise FormulaError(f"a vector or a matrix is transposed, this is {_spoken(shapes[0])}", span=tree.span)
    return (1, *shapes[0]) if len(shapes[0]) == 1 else shapes[0][::-1]


def _diagonal(tree: Call, shapes: Sequence[Shape]) -> Shape:
    order = shapes[0][0] if len(shapes) == 1 and len(shapes[0]) == 1 else len(shapes)
    if (len(shapes) > 1 and any(shapes)) or len(shapes[0]) > 1:
        raise FormulaError("diag takes the entries of the diagonal, or a vector of them", span=tree.span)
    return order, order


def _unit(tree: Call, _shapes: Sequence[Shape]) -> Shape:
    order = tree.arguments[0]
    if not isinstance(order, Number) or not order.text.isdigit() or not 1 <= int(order.text) <= MAX_ROWS:
        raise FormulaError(f"eye takes a whole number from 1 to {MAX_ROWS}", span=tree.span)
    return int(order.text), int(order.text)


def _outer(tree: Call, shapes: Sequence[Shape]) -> Shape:
    if any(len(one) != 1 for one in shapes):
        raise FormulaError("outer takes two vectors", span=tree.span)
    return shapes[0][0], shapes[1][0]


def _kronecker(tree: Call, shapes: Sequence[Shape]) -> Shape:
    if any(len(one) != 2 for one in shapes):
        raise FormulaError("kron takes two matrices", span=tree.span)
    (rows, columns), (inner_rows, inner_columns) = shapes
    found = rows * inner_rows, columns * inner_columns
    if max(found) > MAX_ROWS:
        raise FormulaError(f"a matrix has at most {MAX_ROWS} rows and columns", span=tree.span)
    return found


def _derivatives(times: int) -> Callable[[Call, Sequence[Shape]], Shape]:
    def found(tree: Call, shapes: Sequence[Shape]) -> Shape:
        outputs, variables = shapes[0], shapes[1]
        if len(variables) != 1 or len(outputs) > 1:
            raise FormulaError(f"{tree.function} takes a formula or a vector, and a list of names", span=tree.span)
        return (*outputs, *variables * times)

    return found


_VERBS: Mapping[str, Callable[[Call, Sequence[Shape]], Shape]] = MappingProxyType(
    {
        **dict.fromkeys(("chi2cdf", "chi2inv", "diff", "expectation", "integral", "limit", "sum", "taylor"), _of_first),
        **dict.fromkeys(("expm", "inv"), _matrix),
        **dict.fromkeys(("det", "trace"), _number_of_matrix),
        "diag": _diagonal,
        "eye": _unit,
        "hessian": _derivatives(2),
        "jacobian": _derivatives(1),
        "kron": _kronecker,
        "norm": _length,
        "outer": _outer,
        "transpose": _transposed,
    }
)


def _spoken(one: Shape) -> str:
    return f"an array of shape {one}" if one else "a scalar"
