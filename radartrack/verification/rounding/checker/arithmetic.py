"""Rules of arithmetic for intermediate results: where each result lies, and how far off it is.

Sizes are intervals of logarithms and sums of products of powers, errors are such sums, and exact values are sums with
signs, which show what cancels. All coefficients are rational or balls of Arb (python-flint), which round outward.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cached_property

from radartrack.verification.rounding.checker.known_numbers import DOUBLE, Number, Precision, Refused, Undefined
from radartrack.verification.rounding.checker.sums.ball_ends import Ball, largest, smallest
from radartrack.verification.rounding.checker.sums.products_of_powers import (
    NOTHING,
    Key,
    Polynomial,
    Signed,
    is_mixed,
    plus,
    reciprocal,
    scaled,
    times,
    total,
)
from radartrack.verification.rounding.checker.sums.shares import MOST_PARTS, condensed, paired, share
from radartrack.verification.rounding.checker.sums.signs import NARROW, Signs
from radartrack.verification.rounding.checker.sums.sizes import MOST_VALUE, Curve, Sizes
from radartrack.verification.rounding.checker.sums.sums_in_cells import (
    Parts,
    ends_of_logarithm,
    in_cells,
    share_in_cells,
)

GOOD, FAIR = 8, 64  # relative errors up to which nothing better is looked for, and nothing slower
FEW = 10  # parts of a variance whose error is shared among pairs of them while it is made


@dataclass
class Box(Sizes):
    """The sizes in one box, and the rules of arithmetic.

    Attributes:
        precision: of the numbers.
        in_parts: whether errors are told by the terms of a difference, or by the difference as a whole.
        rounded_whole: whether a difference of exact numbers, which is rounded once, is not taken apart.
        signed_whole: whether a difference whose sign is known is not taken apart.
        factors_whole: whether such a difference is not taken apart where it is multiplied.
        by_argument: whether e^a - 1 is a multiple of a, or a size of its own.
    """

    precision: Precision = DOUBLE
    in_parts: bool = False
    rounded_whole: bool = False
    signed_whole: bool = False
    factors_whole: bool = False
    by_argument: bool = False

    @cached_property
    def signs(self) -> Signs:
        """Of sums of its sizes."""
        return Signs(self)

    @cached_property
    def unit(self) -> Ball:
        """The unit of errors."""
        return self.ball(2.0**-self.precision.bits)

    def made(
        self,
        sign: int,
        exactly: Polynomial | None,
        error: Polynomial | None,
        relative: Ball | None,
        tiny: float,
        value: Signed | None,
        size: Polynomial | None = None,
        terms: Polynomial | None = None,
        ends: tuple[Ball, Ball] | None = None,
        *,
        may_underflow: bool = True,
    ) -> Number:
        """A result with both bounds of its error; one that may overflow is refused."""
        low, high = ends or self.bounds(exactly or size or NOTHING)
        if not high < self.precision.largest * self.ball(2).log():
            raise Refused("a result may overflow")
        if exactly is not None and len(exactly) > MOST_PARTS:
            size, exactly = None if size is exactly else size, condensed(self, exactly)
        exactly, value = self._identified(exactly, value, sign, low, high)
        if size is None or not self.in_parts or len(size) > MOST_PARTS:
            size = exactly
        if error is not None and len(error) > MOST_PARTS:
            error = {(): (self.bounds(error)[1].exp()).upper()} if relative is None else None
        if tiny < self.precision.normal and may_underflow:
            lost = self.ball(self.precision.underflow)
            error = plus(scaled(size, relative) if error is None else error, {(): lost})
            if relative is not None:
                relative = (relative + lost / low.exp()).upper() if low.is_finite() else None
        if error is None:
            error = scaled(size, relative)
        elif relative is None or not relative.is_finite() or relative > GOOD:
            relative = smallest(relative, self._by_itself(error, exactly, value))
        return Number(sign, low, high, smallest(relative), size, exactly, error, terms or exactly, tiny, value)

    def _identified(
        self, exactly: Polynomial | None, value: Signed | None, sign: int, low: Ball, high: Ball
    ) -> tuple[Polynomial, Signed]:
        """Both ways to say what a result is; where one is missing or too long, as a whole."""
        if value is not None and len(value) > self.most_value:
            value = None
        if exactly is not None and len(exactly) <= MOST_PARTS and value is not None:
            return exactly, value
        unheard: Signed = {((-1, float(len(self.atoms))),): self.one}
        whole, exact = self.whole(unheard if value is None else value, sign, low, high)
        return (
            exact if exactly is None or len(exactly) > MOST_PARTS else exactly,
            whole if value is None else value,
        )

    def _by_itself(self, error: Polynomial, exactly: Polynomial, value: Signed) -> Ball | None:
        """A bound of an error by what it is the error of."""
        found = share(self, error, exactly)
        if found is not None and not found > FAIR:
            return found
        plain = self.plain(value)
        others = [share(self, error, plain)] if plain else []
        others += [paired(self, error, one, one) for one in (exactly, plain) if one and len(one) <= FEW]
        return smallest(found, *others)

    def rounded(self, relative: Ball | None, units: float) -> Ball | None:
        """A relative error after one more operation, whose own are so many units."""
        return None if relative is None else (relative + units + self.unit * relative * units).upper()

    def small(self, relative: Ball) -> Ball:
        """A relative error as a share, of operands of what is known for small ones only."""
        part = self.unit * relative
        if not part < self.ball(1e-3):
            raise Refused("an operand with a relative error above one in a thousand")
        return part

    def _exact_by_grid(self, grid: int | None, high: Ball) -> bool:
        return grid is not None and bool(high < (self.precision.bits + grid) * self.ball(2).log())

    def constant(self, value: float | Fraction, roundings: float = 0.0) -> Number | None:
        """A number that is written down."""
        exact = self.rational(value)
        if exact == 0:
            return None
        size: Polynomial = {(): abs(self.flint.arb(exact))}
        log = size[()].log()
        error = scaled(size, self.ball(roundings)) if roundings else NOTHING
        grid = 1 - int(exact.q).bit_length() if not roundings and int(exact.q).bit_count() == 1 else None
        return Number(
            1 if exact > 0 else -1, log.lower(), log.upper(), self.ball(roundings), size, size, error, size,
            float(log.lower()) / math.log(2) - 1e-3, {(): exact}, grid,
        )  # fmt: skip

    def argument(self, sign: int, low: Ball, high: Ball, roundings: float = 0.0) -> Number:
        """What is given: a size, and a sign that may be either."""
        key = self.atom(low, high)
        size: Polynomial = {key: self.one}
        value = self.with_sign(key, sign)
        error = scaled(size, self.ball(roundings)) if roundings else NOTHING
        tiny = float(low.lower()) / math.log(2) - 1e-3
        return Number(sign, low, high, self.ball(roundings), size, size, error, size, tiny, value)

    def fresh(self, sign: int, low: Ball, high: Ball, relative: Ball | None, tiny: float) -> Number:
        """A result of a function that nothing else is known of."""
        key = self.atom(low, high)
        value = self.with_sign(key, sign)
        return self.made(sign, {key: self.one}, None, relative, tiny, value, ends=(low, high))

    def between(self, low: Ball, high: Ball, relative: Ball | None, error: Ball | None) -> Number:
        """A value of which its ends are known, and an error: relative, and where there is none in units of rounding."""
        size = largest([abs(low), abs(high)]).log().upper()
        if relative is not None and (low > 0 or high < 0):
            least = (min(abs(low), abs(high)).log()).lower()
            return self.fresh(1 if low > 0 else -1, least, size, relative, float(least) / math.log(2) - 1e-3)
        key, least = self.atom(self.ball(-math.inf), size), self.ball(-math.inf)
        value = self.with_sign(key, 0)
        tiny = float(self.precision.normal - self.precision.bits)
        spread: Polynomial = {(): error}
        return self.made(0, {key: self.one}, spread, None, tiny, value, ends=(least, size), may_underflow=False)

    def multiply(self, a: Number | None, b: Number | None, units: float = 1.0) -> Number | None:
        """a · b."""
        if a is None or b is None:
            return None
        a, b = self._factor(a), self._factor(b)
        if len(a.size) * len(b.size) > 4 * MOST_PARTS:
            a, b = (self.as_whole(one) if len(one.size) > MOST_PARTS // 8 else one for one in (a, b))
        relative, u = None, self.unit
        if a.relative is not None and b.relative is not None:
            relative = self.rounded(a.relative + b.relative + u * a.relative * b.relative, units)
        exactly = times(a.exactly, b.exactly)
        size = times(a.size, b.size) if a.size is not a.exactly or b.size is not b.exactly else exactly
        error = None
        if relative is None or not (self._is_of_relative(a) and self._is_of_relative(b)):
            spread = plus(times(a.error, b.size), times(a.size, b.error), scaled(times(a.error, b.error), u))
            error = plus(scaled(spread, 1 + u * units), scaled(size, self.ball(units)))
        ends = ((a.low + b.low).lower(), (a.high + b.high).upper())
        grid = None if a.grid is None or b.grid is None else a.grid + b.grid
        is_exact = a.is_exact and b.is_exact and units <= 2 and self._exact_by_grid(grid, ends[1])
        if is_exact:
            relative, error = self.ball(0), NOTHING
        value = self.product(a.value, b.value)
        made = self.made(
            a.sign * b.sign, exactly, error, relative, a.tiny + b.tiny, value, size, times(a.terms, b.terms), ends,
            may_underflow=not is_exact,
        )  # fmt: skip
        return replace(made, grid=grid)

    def as_whole(self, a: Number) -> Number:
        """The same, not taken apart."""
        value, size = self.whole(a.value, a.sign, a.low, a.high)
        error: Polynomial = {(): (self.bounds(a.error)[1].exp()).upper()} if a.error else NOTHING
        if a.relative is not None:
            error = scaled(size, a.relative)
        return replace(a, value=value, size=size, exactly=size, error=error, terms=size)

    def without_error(self, a: Number) -> Number:
        """A value that is taken for exact."""
        return replace(a, relative=self.ball(0), error=NOTHING)

    def _is_of_relative(self, a: Number) -> bool:
        """Whether its error says no more than the relative one."""
        return a.is_exact or (a.relative is not None and len(a.size) == 1)

    def squared(self, a: Number | None) -> Number | None:
        """a²."""
        found = self.multiply(a, a, 2.0 * self.precision.ulps["square"])
        if found is None or found.sign > 0:
            return found
        return replace(found, sign=1)

    def by_power_of_two(self, a: Number | None, factor: float) -> Number | None:
        """A product that rounds nothing."""
        if a is None:
            return None
        f, g, shift = self.ball(abs(factor)), self.rational(factor), int(math.log2(abs(factor)))
        size = scaled(a.size, f)
        return Number(
            a.sign if factor > 0 else -a.sign, (a.low + f.log()).lower(), (a.high + f.log()).upper(), a.relative,
            size, size if a.exactly is a.size else scaled(a.exactly, f), scaled(a.error, f), scaled(a.terms, f),
            a.tiny + shift, {key: c * g for key, c in a.value.items()}, None if a.grid is None else a.grid + shift,
        )  # fmt: skip

    def divide(self, a: Number | None, b: Number | None) -> Number | None:
        """a / b."""
        if a is None:
            return None
        if b is None:
            raise Undefined("a divisor that is zero")
        if b.relative is None:
            raise Refused("a divisor that may be zero")
        u, b = self.unit, self._if_not_zero(b)
        worse = (b.relative / (1 - self.small(b.relative))).upper()
        if len(b.value) == 1 and len(b.exactly) == 1:
            of, below = b.value, b.exactly
        else:
            of, below = self.whole(b.value, b.sign, b.low, b.high)
        inverse = {reciprocal(key): 1 / c for key, c in below.items()}
        size, terms, exactly = times(a.size, inverse), times(a.terms, inverse), times(a.exactly, inverse)
        relative = None if a.relative is None else self.rounded(a.relative + worse + u * a.relative * worse, 1.0)
        error = None
        if relative is None or not self._is_of_relative(a):
            error = plus(scaled(times(a.error, inverse), (1 + u) * (1 + u * worse)), scaled(size, 1 + (1 + u) * worse))
        ends = ((a.low - b.high).lower(), (a.high - b.low).upper())
        tiny = a.tiny - float(b.high.upper()) / math.log(2) - 1e-3
        value = self.product(a.value, {reciprocal(key): 1 / c for key, c in of.items()})
        return self.made(a.sign * b.sign, exactly, error, relative, tiny, value, size, terms, ends)

    def _if_not_zero(self, a: Number) -> Number:
        """The same where it is not zero; a formula that divides by it is not defined there."""
        return a if a.low.is_finite() else replace(a, low=(self.ball(a.tiny - 1e-2) * self.ball(2).log()).lower())

    def add(self, a: Number | None, b: Number | None) -> Number | None:
        """a + b."""
        if a is None or b is None:
            return a or b
        value = total(a.value, b.value)
        if not value and a.is_exact and b.is_exact:
            return None
        grid = None if a.grid is None or b.grid is None else min(a.grid, b.grid)
        u, size, terms = self.unit, plus(a.size, b.size), plus(a.terms, b.terms)
        high = ((a.high.exp() + b.high.exp()).log()).upper()
        is_of_exact = a.is_exact and b.is_exact
        relative, parts = self.one if is_of_exact else None, None
        if a.sign * b.sign > 0:
            if a.relative is not None and b.relative is not None:
                relative = self.rounded(largest([a.relative, b.relative]), 1.0)
            exactly: Polynomial | None = plus(a.exactly, b.exactly)
            least = a.low.exp() + b.low.exp()
            sign, ends = a.sign, (least.log().lower() if least > 0 else self.ball(-math.inf), high)
            tiny = max(a.tiny, b.tiny) - 1e-3
        else:
            parts = in_cells(self, value) if value else None
            sign, exactly, ends = self._difference(a, b, value, parts, high)
            tiny = min(a.tiny, b.tiny) - self.precision.bits
            if grid is not None:
                tiny = max(tiny, float(grid))
            if exactly is not None:
                size = exactly
            elif value and not self.in_parts:
                exactly = size = self.whole(value, sign, *ends)[1]
        if self.rounded_whole and is_of_exact and not sign and value and not self._exact_by_grid(grid, ends[1]):
            value, size = self.whole(value, sign, *ends)
            exactly = terms = size
        rounds = not (is_of_exact and self._exact_by_grid(grid, ends[1]))
        error = plus(scaled(plus(a.error, b.error), 1 + u), size) if rounds else NOTHING
        relative = smallest(relative, share_in_cells(self, error, parts)) if rounds else self.ball(0)
        made = self.made(sign, exactly, error, relative, tiny, value or None, size, terms, ends, may_underflow=False)
        return replace(made if a.sign * b.sign > 0 else self._known_well(made), grid=grid)

    def _known_well(self, difference: Number) -> Number:
        """A difference as one size, where that is the way, and its sign and size are known."""
        if not self.signed_whole or difference.relative is None or not difference.relative < FAIR:
            return difference
        return self.as_whole(difference) if difference.high - difference.low < NARROW[-1] else difference

    def _factor(self, a: Number) -> Number:
        """A difference that is multiplied as one size, where that is the way, and its sign and size are known."""
        if not self.factors_whole or a.relative is None or not a.relative < FAIR or not is_mixed(a.value):
            return a
        return self.as_whole(a) if a.high - a.low < NARROW[-1] else a

    def _difference(
        self, a: Number, b: Number, value: Signed, parts: Parts | None, high: Ball
    ) -> tuple[int, Polynomial | None, tuple[Ball, Ball]]:
        """Sign, size and range of a sum whose terms may cancel."""
        low, sign = self.ball(-math.inf), 0
        if a.sign * b.sign < 0:
            apart = [(x.high.exp() - y.low.exp()).upper() for x, y in ((a, b), (b, a))]
            high = min(high, largest(apart).log().upper()) if largest(apart) > 0 else high
        for major, minor in ((a, b), (b, a)):
            if major.sign and minor.high < major.low:
                low, sign = (major.low + (1 - (minor.high - major.low).exp()).log()).lower(), major.sign
        if parts:
            sign, least, most = ends_of_logarithm(self, parts)
            low, high = max(low, least), min(high, most)
        found = (self.signs.of_one_sign(value) or self._remainder(a, b)) if value else None
        if found is None:
            return sign, None, (low, high)
        ends = self.bounds(found[1])
        low, high, sign = max(low, ends[0]), min(high, ends[1]), found[0] or sign
        spreads = [self.atoms[n] for key in found[1] for n, _ in key if n in self.shares]
        if any(b - a > high - low + 0.1 for a, b in spreads):
            return sign, self.whole(value, sign, low, high)[1], (low, high)
        return sign, found[1], (low, high)

    def _remainder(self, a: Number, b: Number) -> tuple[int, Polynomial] | None:
        """The same of the parts as they came about."""
        if a.sign * b.sign >= 0 or max(len(a.exactly), len(b.exactly)) > MOST_VALUE:
            return None
        left = plus(a.exactly, scaled(b.exactly, self.ball(-1)))
        for sign in (1, -1):
            found = self.signs.absorbed({key: sign * size for key, size in left.items()})
            if found is not None:
                return sign * a.sign, found
        return None

    def follows(self, key: Key, argument: Number, ends: Callable[[Ball, Ball], tuple[Ball, Ball]]) -> None:
        """Note that a size is a function of an argument."""
        if self.by_argument and len(argument.value) == len(argument.exactly) == 1 and argument.low.is_finite():
            ((of, size),) = argument.exactly.items()
            if size == 1:
                self.curves[key[0][0]] = Curve(of, argument.low, argument.high, ends)
