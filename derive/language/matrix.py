"""Products and transposes of matrices of expressions."""

from __future__ import annotations

from functools import reduce
from itertools import chain
from operator import add, mul

from radartrack.derive.language.tensor import Tensor
from radartrack.derive.symbolic import Expr


def product(first: Tensor[Expr], second: Tensor[Expr]) -> Tensor[Expr]:
    """The matrix product."""
    rows, columns = first.parts(), list(zip(*second.parts(), strict=True))
    return Tensor.build((len(rows), len(columns)), lambda m, n: reduce(add, map(mul, rows[m], columns[n])))


def transposed(matrix: Tensor[Expr]) -> Tensor[Expr]:
    """The transpose."""
    return Tensor((matrix.shape[1], matrix.shape[0]), tuple(chain.from_iterable(zip(*matrix.parts(), strict=True))))
