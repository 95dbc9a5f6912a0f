"""Matrices of expressions as rows: products, transposes, traces, and how they are made."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TypeAlias

from radartrack.derive import symbolic as sp
from radartrack.derive.language.tensor import Tensor
from radartrack.derive.symbolic import Expr

Vector: TypeAlias = tuple[Expr, ...]
Matrix: TypeAlias = tuple[Vector, ...]

ZERO: Expr = sp.Integer(0)
ONE: Expr = sp.Integer(1)


def rows(tensor: Tensor[Expr]) -> Matrix:
    """A tensor of rank two by rows."""
    return tuple(tuple(row) for row in tensor.parts())


def product(first: Matrix, second: Matrix) -> Matrix:
    """The matrix product, shape (rows of the first, columns of the second)."""
    columns = transposed(second)
    return tuple(tuple(inner(row, column) for column in columns) for row in first)


def inner(first: Sequence[Expr], second: Sequence[Expr]) -> Expr:
    """The sum of the products of entries."""
    return sp.Add(*(a * b for a, b in zip(first, second, strict=True)))


def outer(first: Sequence[Expr], second: Sequence[Expr]) -> Matrix:
    """All products of an entry of one with an entry of the other."""
    return tuple(tuple(a * b for b in second) for a in first)


def kronecker(first: Matrix, second: Matrix) -> Matrix:
    """The second matrix, times an entry of the first one, for each of these."""
    return tuple(tuple(a * b for a in above for b in row) for above in first for row in second)


def transposed(matrix: Matrix) -> Matrix:
    """Rows as columns."""
    return tuple(zip(*matrix, strict=True))


def identity(order: int) -> Matrix:
    """The unit matrix."""
    return diagonal([ONE] * order)


def diagonal(entries: Sequence[Expr]) -> Matrix:
    """A matrix with these entries on its diagonal and zeros elsewhere."""
    places = range(len(entries))
    return tuple(tuple(entries[m] if m == n else ZERO for n in places) for m in places)


def trace(matrix: Matrix) -> Expr:
    """The sum of the diagonal."""
    return sp.Add(*(row[place] for place, row in enumerate(matrix)))
