"""Determinants and inverses of matrices of expressions.

Determinants are expanded by rows with every minor computed once, so zeros cost nothing and nothing is divided.
"""

from __future__ import annotations

from itertools import combinations

from radartrack.derive import symbolic as sp
from radartrack.derive.language.matrix import ONE, ZERO, Matrix
from radartrack.derive.symbolic import Expr
from radartrack.derive.verbs.no_closed_form import NoClosedForm

MOST_MINORS = 4_000  # that are not zero; a full matrix of order 10 has a thousand, of order 12 four thousand
MOST_PARTS = 50_000  # of a minor written out, however much of it is shared: SymPy compares all of them, one by one


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
        self._parts: dict[Expr, int] = {}

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
            raise self._too_large("minors", MOST_MINORS)
        terms = (
            (-1) ** place * self._matrix[rows[0]][column] * self.of(rows[1:], left)
            for place, (column, left) in enumerate(_left_out(columns))
            if self._matrix[rows[0]][column] != ZERO
        )
        total = sp.Add(*terms)
        if self._size(total) > MOST_PARTS:
            raise self._too_large("parts", MOST_PARTS)
        return total

    def _size(self, expression: Expr) -> int:
        """How many parts an expression has, those that are shared counted each time."""
        if expression not in self._parts:
            self._parts[expression] = 1 + sum(map(self._size, expression.args))
        return self._parts[expression]

    def _too_large(self, what: str, most: int) -> NoClosedForm:
        return NoClosedForm(
            f"the determinant of a matrix of order {len(self._matrix)} with so few zeros has more than {most} {what}"
        )


def _left_out(columns: tuple[int, ...]) -> list[tuple[int, tuple[int, ...]]]:
    """Each column with the others."""
    others = reversed(list(combinations(columns, len(columns) - 1)))
    return list(zip(columns, others, strict=True))
