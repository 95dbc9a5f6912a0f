"""The exponential of a matrix with symbols, where its eigenvalues have closed forms.

The resolvent (s·1 − A)⁻¹ is the Laplace transform of e^(At). Its entries fall into partial fractions over the factors
of the characteristic polynomial: linear ones give powers of t times e^(λt), quadratic ones sines and cosines or their
hyperbolic sisters. Of a nilpotent matrix the series ends.
"""

from __future__ import annotations

from math import factorial

from radartrack.derive import symbolic as sp
from radartrack.derive.language.matrix import Matrix, identity
from radartrack.derive.symbolic import Expr, Symbol
from radartrack.derive.verbs.determinants import inverse
from radartrack.derive.verbs.no_closed_form import NoClosedForm
from radartrack.derive.verbs.partial_fractions import PartialFraction, partial_fractions

LARGEST_ORDER = 8
LARGEST_FULL = 4  # with entries everywhere
MOST_ENTRIES = 20  # that are not zero, of a larger one
ZERO: Expr = sp.Integer(0)


def exponential(matrix: Matrix) -> Matrix:
    """e^A.

    Raises:
        NoClosedForm: when the order is too large, or an eigenvalue has no closed form.
    """
    order = len(matrix)
    if order > LARGEST_ORDER:
        raise NoClosedForm(f"the exponential of a matrix of order {order}; {LARGEST_ORDER} is allowed")
    blocks = _blocks(matrix)
    result = [list(row) for row in identity(order)]
    for block in blocks:
        part = _exponential(tuple(tuple(matrix[m][n] for n in block) for m in block))
        for m, row in zip(block, part, strict=True):
            for n, entry in zip(block, row, strict=True):
                result[m][n] = entry
    return tuple(map(tuple, result))


def _blocks(matrix: Matrix) -> list[list[int]]:
    """The sets of rows that have to do with each other."""
    left, found = set(range(len(matrix))), []
    while left:
        block, waiting = set(), [min(left)]
        while waiting:
            place = waiting.pop()
            if place not in block:
                block.add(place)
                waiting += [other for other in left if matrix[place][other] != ZERO or matrix[other][place] != ZERO]
        left -= block
        found.append(sorted(block))
    return found


def _exponential(matrix: Matrix) -> Matrix:
    """Of a block: nilpotent ones by the series, others by the resolvent."""
    if _is_full(matrix):
        raise NoClosedForm(f"the eigenvalues of a full matrix of order {len(matrix)} have no closed form here")
    series = _nilpotent(matrix)
    if series is not None:
        return series
    s = sp.Symbol("{s}")
    shifted = tuple(
        tuple((s if m == n else ZERO) - entry for n, entry in enumerate(row)) for m, row in enumerate(matrix)
    )
    return tuple(tuple(_original(entry, s) for entry in row) for row in inverse(shifted))


def _is_full(matrix: Matrix) -> bool:
    """Whether a large matrix has entries nearly everywhere, and rows that depend on each other in a circle."""
    places = range(len(matrix))
    filled = {(m, n) for m in places for n in places if matrix[m][n] != ZERO}
    if len(matrix) <= LARGEST_FULL or len(filled) <= MOST_ENTRIES:
        return False
    left = set(places)
    while leaves := {m for m in left if not any((m, n) in filled for n in left)}:
        left -= leaves
    return bool(left)


def _nilpotent(matrix: Matrix) -> Matrix | None:
    """1 + A + A²/2 + …, where it ends."""
    order = len(matrix)
    total, power = identity(order), identity(order)
    for n in range(1, order + 1):
        power = tuple(
            tuple(sp.expand(sp.Add(*(power[m][i] * matrix[i][k] for i in range(order)))) for k in range(order))
            for m in range(order)
        )
        if all(entry == ZERO for row in power for entry in row):
            return total
        below = sp.Integer(factorial(n))
        total = tuple(
            tuple(a + b / below for a, b in zip(*rows, strict=True)) for rows in zip(total, power, strict=True)
        )
    return None


def _original(transform: Expr, s: Symbol) -> Expr:
    """The function whose Laplace transform is given, at time 1."""
    if transform == ZERO:
        return ZERO
    return sp.Add(*(_of_fraction(part) for part in partial_fractions(transform, s)))


def _of_fraction(part: PartialFraction) -> Expr:
    if part.degree == 1:
        return part.numerator[0] * sp.exp(part.root) / sp.Integer(factorial(part.power - 1))
    if part.degree == 2 and part.power == 1:
        constant, slope = part.numerator
        cosine, sine = _oscillation(part.variance)
        return sp.exp(part.root) * (slope * cosine + (constant + slope * part.root) * sine)
    raise NoClosedForm("an eigenvalue with a quadratic factor occurs several times")


def _oscillation(variance: Expr) -> tuple[Expr, Expr]:
    """Originals of s/(s² + v) and 1/(s² + v): cos √v and sin √v / √v, hyperbolic where v is a negative square."""
    above, below = sp.fraction(sp.factor(variance))
    number, rest = above.as_coeff_Mul()
    if number < 0:
        width = _root(-number * rest / below)
        return sp.cosh(width), sp.sinh(width) / width
    width = _root(variance)
    return sp.cos(width), sp.sin(width) / width


def _root(square: Expr) -> Expr:
    """A root of a square, its sign left open: what is made of it is even; or the principal one."""
    parts = []
    for factor in sp.Mul.make_args(sp.factor(square)):
        base, exponent = factor.as_base_exp()
        even = isinstance(exponent, sp.Integer) and exponent % 2 == 0
        parts.append(base ** (exponent / 2) if even else sp.sqrt(factor))
    return sp.Mul(*parts)
