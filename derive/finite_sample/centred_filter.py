"""The finite-sample filter about the middle of its sample, where the information falls into two blocks.

The scans lie evenly about their middle, so sums of odd powers of the time from there are zero: even and odd components
of the state do not mix. Two determinants of half the size take the place of one.

Time is counted in scans and the standard deviation of the range is one. Everything is a polynomial in the number of
scans and the other symbols of a ring, over the determinants.
"""

from __future__ import annotations

from collections import Counter, defaultdict
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property, reduce
from itertools import combinations, combinations_with_replacement
from math import factorial
from operator import mul, or_, sub

from radartrack.derive import symbolic as sp
from radartrack.derive.finite_sample.power_sums import summed
from radartrack.derive.language.tensor import Tensor
from radartrack.derive.symbolic import Expr, PolyElement, PolyRing, Symbol

Row = list[PolyElement]
Factors = Counter[PolyElement]


@dataclass(frozen=True)
class CentredFilter:
    """The filter of least squares over scans that lie evenly about the time 0.

    Attributes:
        ring: of all polynomials.
        scans: how many there are, a symbol of the ring.
        size: the number of components of the state, the value and its derivatives.
        weight_of_rate: that of a range rate beside a range, zero where none is measured.
    """

    ring: PolyRing
    scans: Symbol
    size: int
    weight_of_rate: PolyElement

    def covariance(self, time: PolyElement) -> Tensor[Expr]:
        """That of the state at a time, in lowest terms, numerators and denominators factored."""
        rows = [self._row(time, derivative) for derivative in range(self.size)]
        gains = [self._gains(row) for row in rows]
        pairs = combinations_with_replacement(range(self.size), 2)
        entries = {(m, n): self._fraction(gains[m], rows[n], [time]) for m, n in pairs}
        return Tensor.build((self.size, self.size), lambda m, n: entries[min(m, n), max(m, n)])

    def weights(self, time: PolyElement, scan: PolyElement, derivative: int) -> Tensor[Expr]:
        """What a value (derivative 0) or a rate (1) measured at one time adds to the state at another."""
        gains = self._gains(self._row(scan, derivative))
        rows = [self._row(time, component) for component in range(self.size)]
        return Tensor((self.size,), tuple(self._fraction(gains, row, [time, scan]) for row in rows))

    def _row(self, time: PolyElement, derivative: int) -> Row:
        """That derivative of the state's polynomial at a time, by the components of the state at the middle."""
        powers = (n - derivative for n in range(self.size))
        return [time**power * sp.QQ(1, factorial(power)) if power >= 0 else self.ring.zero for power in powers]

    def _gains(self, row: Row) -> list[Row]:
        return [block.times(part) for block, part in zip(self._blocks, _split(row), strict=True)]

    @cached_property
    def _blocks(self) -> tuple[_Block, _Block]:
        even, odd = range(0, self.size, 2), range(1, self.size, 2)
        return _Block(self.ring, self._information(even)), _Block(self.ring, self._information(odd))

    def _information(self, components: Sequence[int]) -> list[Row]:
        def entry(m: int, n: int) -> PolyElement:
            scale = sp.QQ(1, factorial(m) * factorial(n))
            slopes = self._moment(m + n - 2) * self.weight_of_rate * (m * n) if m and n else self.ring.zero
            return (self._moment(m + n) + slopes) * scale

        return [[entry(m, n) for n in components] for m in components]

    def _moment(self, exponent: int) -> PolyElement:
        """The sum of a power of the times of all scans."""
        index = Symbol("i", integer=True)
        time = index - (self.scans - 1) / 2
        return self.ring.from_expr(sp.expand(summed(time**exponent, index, self.scans)))

    def _fraction(self, gains: list[Row], row: Row, times: Sequence[PolyElement]) -> Expr:
        """The product of gains, each over its block's determinant, and a row, as one fraction in lowest terms."""
        numerators = (_dot(gain, part, self.ring) for gain, part in zip(gains, _split(row), strict=True))
        parts = [block.cancelled(numerator) for block, numerator in zip(self._blocks, numerators, strict=True)]
        below = reduce(or_, (left for _, left in parts))
        above = sum((part * _product(below - left, self.ring) for part, left in parts), start=self.ring.zero)
        if not above:
            return sp.Integer(0)
        above, below = _cancelled(above, below)
        return self._factored(above, times) / sp.Mul(*(factor.as_expr() ** power for factor, power in below.items()))

    def _factored(self, numerator: PolyElement, times: Sequence[PolyElement]) -> Expr:
        """What occurs: the times, by symmetry, factors of a determinant, polynomials in the scans; and the rest."""
        found: list[Expr] = []
        for factor in filter(_is_mixed, [*(time.primitive()[1] for time in times), *self._below]):
            while not (division := numerator.div(factor))[1]:
                numerator = division[0]
                found.append(factor.as_expr())
        common = self._common(numerator)
        content, factors = common.factor_list()
        scale, rest = numerator.exquo(common).primitive()
        number = content * scale
        found += [factor.as_expr() ** power for factor, power in factors]
        return sp.Rational(int(number.numerator), int(number.denominator)) * sp.Mul(*found, rest.as_expr())

    @property
    def _below(self) -> list[PolyElement]:
        return [factor for block in self._blocks for factor in block.factors]

    def _common(self, polynomial: PolyElement) -> PolyElement:
        """The greatest polynomial in the number of scans that divides another one."""
        place = self.ring.symbols.index(self.scans)
        coefficients: dict[tuple[int, ...], PolyElement] = defaultdict(lambda: self.ring.zero)
        for powers, coefficient in polynomial.terms():
            others = (*powers[:place], 0, *powers[place + 1 :])
            coefficients[others] += self.ring({tuple(map(sub, powers, others)): coefficient})
        return reduce(lambda one, other: one.gcd(other), coefficients.values())


def _is_mixed(polynomial: PolyElement) -> bool:
    """Whether it holds several symbols."""
    return sum(map(bool, polynomial.degrees())) > 1


def _split(row: Row) -> tuple[Row, Row]:
    """Even and odd components."""
    return row[::2], row[1::2]


class _Block:
    """The inverse of a matrix of polynomials as its adjoint over its determinant."""

    def __init__(self, ring: PolyRing, matrix: list[Row]) -> None:
        size = range(len(matrix))
        self._ring = ring
        self._adjoint = [[_determinant(_without(matrix, n, m), ring) * (-1) ** (m + n) for n in size] for m in size]
        self._content, factors = _determinant(matrix, ring).factor_list()
        self.factors: Factors = Counter(dict(factors))

    def times(self, row: Row) -> Row:
        """The adjoint times a vector."""
        return [_dot(line, row, self._ring) for line in self._adjoint]

    def cancelled(self, numerator: PolyElement) -> tuple[PolyElement, Factors]:
        """A numerator over the determinant: without the factors that both share, and those that are left below."""
        return _cancelled(numerator * (1 / self._content), self.factors)


def _cancelled(numerator: PolyElement, factors: Factors) -> tuple[PolyElement, Factors]:
    left: Factors = Counter()
    for factor in factors.elements():
        quotient, remainder = numerator.div(factor)
        if remainder:
            left[factor] += 1
        else:
            numerator = quotient
    return numerator, left


def _product(factors: Factors, ring: PolyRing) -> PolyElement:
    return reduce(mul, factors.elements(), ring.one)


def _dot(first: Row, second: Row, ring: PolyRing) -> PolyElement:
    return sum(map(mul, first, second), start=ring.zero)


def _determinant(matrix: list[Row], ring: PolyRing) -> PolyElement:
    """The determinant of polynomials, over the minors of the last rows, so that nothing is ever divided."""
    minors: dict[tuple[int, ...], PolyElement] = {(): ring.one}
    size = len(matrix)
    for taken in range(1, size + 1):
        row = matrix[size - taken]
        minors = {
            columns: sum(
                (
                    (-1) ** place * row[column] * minors[columns[:place] + columns[place + 1 :]]
                    for place, column in enumerate(columns)
                ),
                start=ring.zero,
            )
            for columns in combinations(range(size), taken)
        }
    return minors[tuple(range(size))]


def _without(matrix: list[Row], row: int, column: int) -> list[Row]:
    return [[entry for n, entry in enumerate(entries) if n != column] for m, entries in enumerate(matrix) if m != row]
