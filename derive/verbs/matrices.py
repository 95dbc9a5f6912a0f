"""Matrices of expressions: products, transposes, inverses, determinants, traces, and how they are made.

Determinants are expanded by rows with every minor computed once, so zeros cost nothing and nothing is divided.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations
from typing import TypeAlias

from radartrack.derive import symbolic as sp
from radartrack.derive.symbolic import Expr
from radartrack.derive.verbs.no_closed_form import NoClosedForm

Vector: TypeAlias = tuple[Expr, ...]
Matrix: TypeAlias = tuple[Vector, ...]

MOST_ROWS = 12  # of a matrix that is multiplied or transposed
MOST_MINORS = 4_000  # that are not zero; a full matrix of order 10 has a thousand, of order 12 four thousand
ZERO: Expr = sp.Integer(0)
ONE: Expr = sp.Integer(1)


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


def determinant(matrix: Matrix) -> Expr:
    """The determinant of a square matrix.

    Raises:
        NoClosedForm: when it has too many minors that are not zero.
    """
    return _Minors(matrix).of(tuple(range(len(matrix))), tuple(range(len(matrix))))


def inverse(matrix: Matrix) -> Matrix:
    """The adjugate over the determinant.

    Raises:
        NoClosedForm: when there are too many minors that are not zero, or the determinant is zero as it stands.
    """
    order = range(len(matrix))
    minors = _Minors(matrix)
    whole = minors.of(tuple(order), tuple(order))
    if whole == ZERO:
        raise NoClosedForm("this matrix has no inverse: its determinant is zero")

    def entry(m: int, n: int) -> Expr:
        rows, columns = (tuple(place for place in order if place != left_out) for left_out in (n, m))
        minor = minors.of(rows, columns)
        return (-minor if (m + n) % 2 else minor) / whole

    return tuple(tuple(entry(m, n) for n in order) for m in order)


class _Minors:
    """The determinants of parts of a matrix, each computed once."""

    def __init__(self, matrix: Matrix) -> None:
        self._matrix = matrix
        self._count = 0
        self._known: dict[tuple[tuple[int, ...], tuple[int, ...]], Expr] = {}

    def of(self, rows: tuple[int, ...], columns: tuple[int, ...]) -> Expr:
        """The minor of some rows and columns."""
        if (rows, columns) not in self._known:
            self._known[rows, columns] = self._expanded(rows, columns)
        return self._known[rows, columns]

    def _expanded(self, rows: tuple[int, ...], columns: tuple[int, ...]) -> Expr:
        """By the first row."""
        if not rows:
            return ONE
        self._count += 1
        if self._count > MOST_MINORS:
            raise NoClosedForm(f"a matrix of order {len(self._matrix)} with so few zeros is too large to invert")
        terms = (
            (-1) ** place * self._matrix[rows[0]][column] * self.of(rows[1:], left)
            for place, (column, left) in enumerate(_left_out(columns))
            if self._matrix[rows[0]][column] != ZERO
        )
        return sp.Add(*terms)


def _left_out(columns: tuple[int, ...]) -> list[tuple[int, tuple[int, ...]]]:
    """Each column with the others."""
    others = reversed(list(combinations(columns, len(columns) - 1)))
    return list(zip(columns, others, strict=True))
