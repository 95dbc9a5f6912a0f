"""Intermediate results as the checker of certificates knows them: where they lie, and how far off they are.

Sizes are intervals of logarithms and sums of products of powers, errors are such sums, and exact values are sums with
signs, which show what cancels. All coefficients are rational or balls of Arb (python-flint), which round outward.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from fractions import Fraction
from functools import cached_property
from itertools import product as pairs_of
from typing import Any

import numpy as np

from radartrack.verification.rounding.checked_cells import Along, Cell, cells, largest_share
from radartrack.verification.rounding.checked_cells import ends as ends_of

Ball = Any
Rational = Any
Key = tuple[tuple[int, float], ...]  # atoms, by their numbers, and their exponents
Polynomial = dict[Key, Ball]  # coefficients are not negative
Signed = dict[Key, Rational]  # of any sign; atoms may be carriers of a sign
ARGUMENT = -4  # the size that others are functions of, where a sum is looked at in cells

CLOSE = 0.4  # an error's terms are shared among products whose logarithms are this close to the best
CLOSER = (0.0, 1.0, 2.0, 4.0)  # logarithms by which terms may be above those that a long sum is condensed to
NARROW = (0.0, 0.75, 3.0)  # of logarithms: sizes known so well count as coefficients when signs are looked for
MOST_VALUE, MOST_PARTS = 120, 160  # monomials of a sum that is multiplied out; beyond, it is taken as a whole
MOST_PAIRS, MOST_SHARED = 4_000_000, 32  # of terms of two variances, and those of them that one error is shared among
GOOD, FAIR = 8, 64  # relative errors up to which nothing better is looked for, and nothing slower
SOME = 32  # terms of a sum that is looked at in cells
FEW = 10  # parts of a variance whose error is shared among pairs of them while it is made
ENDLESS = 1e9
NOTHING: Polynomial = {}


class Refused(ValueError):
    """The certificate does not show what it claims."""


class Undefined(Refused):
    """The formula divides by zero all over the box: nothing is said of it there."""


@dataclass(frozen=True, eq=False)
class Precision:
    """A binary format, and what is assumed of the elementary functions in it.

    Attributes:
        bits: of the significand.
        normal: binary logarithm below which a number may not be normal.
        largest: binary logarithm that no number may reach.
        ulps: error of each elementary function, in units of the last place of the exact value.
    """

    bits: int
    normal: int
    largest: int
    ulps: dict[str, float]

    @property
    def underflow(self) -> float:
        """In units of rounding what a result that is too small to be normal is off by: half a distance of numbers."""
        return 2.0**self.normal


DOUBLE = Precision(53, -1021, 1023, {"sin": 1, "cos": 1, "exp": 1, "expm1": 1, "hypot": 1, "arctan2": 1, "square": 1})
SINGLE = Precision(24, -125, 127, {"sin": 4, "cos": 4, "exp": 4, "expm1": 4, "hypot": 4, "arctan2": 4, "square": 1})


@dataclass(frozen=True)
class Number:
    """What is known of an intermediate result in one box.

    Attributes:
        sign: 1, −1, or 0 where it is not known.
        low: of the logarithm of its size; minus infinity where nothing keeps it from zero.
        high: likewise.
        relative: bound of its error by itself, in units of rounding; None where there is none.
        size: a sum that the size is at most.
        exactly: a sum that the size is.
        error: a sum that the error is at most, in units of rounding.
        terms: the sum of the sizes of its terms.
        tiny: binary logarithm that a computed value is not below, unless it is zero.
        value: a sum with signs that it is.
        grid: binary logarithm of what it is a multiple of, where that is known.
    """

    sign: int
    low: Ball
    high: Ball
    relative: Ball | None
    size: Polynomial
    exactly: Polynomial
    error: Polynomial
    terms: Polynomial
    tiny: float
    value: Signed
    grid: int | None = None

    @cached_property
    def is_exact(self) -> bool:
        """Whether the computed value is the exact one."""
        return not self.error


@dataclass(frozen=True)
class Curve:
    """How a size depends on an argument of a function.

    Attributes:
        argument: a product of powers that is the argument's size.
        low: of the logarithm of that.
        high: likewise.
        ends: of the function by those of the argument's size; of either sign.
    """

    argument: Key
    low: Ball
    high: Ball
    ends: Callable[[Ball, Ball], tuple[Ball, Ball]]

    def logarithms(self, low: Ball, high: Ball) -> tuple[Ball, Ball]:
        """Of its size, by those of the argument's."""
        sizes = [abs(end) for end in self.ends(low.exp(), high.exp())]
        return min(size.lower() for size in sizes).log().lower(), max(size.upper() for size in sizes).log().upper()


@dataclass(frozen=True)
class Parts:
    """A sum in cells.

    Attributes:
        cells: of what is left of it.
        common: what all its terms have as a factor.
        argument: a product of powers that is the size `ARGUMENT`; empty where there is none.
        span: where that size lies.
    """

    cells: list[Cell]
    common: Key = ()
    argument: Key = ()
    span: tuple[Ball, Ball] | None = None


@dataclass
class Box:
    """The sizes that sums are made of in one box, and the rules of arithmetic."""

    flint: Any
    precision: Precision = DOUBLE
    in_parts: bool = False  # whether errors are told by the terms of a difference, or by the difference as a whole
    rounded_whole: bool = False  # whether a difference of exact numbers, which is rounded once, is not taken apart
    signed_whole: bool = False  # whether a difference whose sign is known is not taken apart
    factors_whole: bool = False  # whether such a difference is not taken apart where it is multiplied
    by_argument: bool = False  # whether e^a - 1 is a multiple of a, or a size of its own
    most_value: int = MOST_VALUE
    atoms: list[tuple[Ball, Ball]] = field(default_factory=list)
    carriers: set[int] = field(default_factory=set)
    waves: list[tuple[int, int]] = field(default_factory=list)
    shares: set[int] = field(default_factory=set)  # sizes that stand for what is not known of a part of a sum
    curves: dict[int, Curve] = field(default_factory=dict)
    known: dict[Any, Any] = field(default_factory=dict)
    signs: dict[Any, tuple[int, Polynomial] | None] = field(default_factory=dict)  # a value's parts are the same again

    def ball(self, value: float) -> Ball:
        """A number as it is."""
        return self.flint.arb(value)

    def rational(self, value: float | Fraction) -> Rational:
        """A number as it is."""
        exact = Fraction(value)
        return self.flint.fmpq(exact.numerator, exact.denominator)

    @cached_property
    def unit(self) -> Ball:
        """The unit of errors."""
        return self.ball(2.0**-self.precision.bits)

    @cached_property
    def one(self) -> Ball:
        """1."""
        return self.ball(1)

    def atom(self, low: Ball, high: Ball) -> Key:
        """A size that is not taken apart."""
        self.atoms.append((low, high))
        return ((len(self.atoms) - 1, 1.0),)

    def carrier(self) -> Key:
        """A sign that is not known: its square is 1."""
        key = self.atom(self.ball(0), self.ball(0))
        self.carriers.add(key[0][0])
        return key

    def whole(self, value: Signed, sign: int, low: Ball, high: Ball) -> tuple[Signed, Polynomial]:
        """A value as one size and a sign; the same value is the same size again."""
        name, turn = _normal(value)
        if name in self.known:
            number = self.known[name][0][0][0]
            ends = self.atoms[number]
            self.atoms[number] = (_highest((ends[0], low)), _lowest((ends[1], high)))
        else:
            self.known[name] = self.atom(low, high), () if sign else self.carrier(), sign * turn or 1
        size, carrier, turned = self.known[name]
        if sign:
            return {size: self.rational(sign)}, {size: self.one}
        return {_key(size, carrier, self.carriers): self.rational(turned * turn)}, {size: self.one}

    def bare(self, key: Key) -> Key:
        """A product of powers without signs."""
        return tuple(part for part in key if part[0] not in self.carriers) if self.carriers else key

    def bounds(self, sum_: Polynomial) -> tuple[Ball, Ball]:
        """Of the logarithm of a sum."""
        ends = [self.monomial(key, coefficient) for key, coefficient in sum_.items()]
        low, high = (sum((end[i].exp() for end in ends), self.ball(0)) for i in (0, 1))
        return _below(low.log() if low.lower() > 0 else self.ball(-math.inf)), _above(high.log())

    def monomial(self, key: Key, coefficient: Ball) -> tuple[Ball, Ball]:
        """Of the logarithm of one product of powers."""
        low, high = (
            end.log() if end > 0 else self.ball(-math.inf) for end in (coefficient.lower(), coefficient.upper())
        )
        for number, exponent in key:
            ends = self.atoms[number]
            first, last = (ends[0], ends[1]) if exponent > 0 else (ends[1], ends[0])
            low, high = low + first * exponent, high + last * exponent
        return low, high

    def _ratio(self, key: Key, coefficient: Ball, other: Key, size: Ball) -> Ball:
        return _above(self.monomial(product_of(key, other, -1.0), coefficient / size)[1].exp())

    def _table(self, *sums: Iterable[Key]) -> tuple[list[Any], Any, Any]:
        """Of sums the exponents of their terms, and where the sizes lie that these are of: in floating point."""
        keys = [list(sum_) for sum_ in sums]
        numbers = sorted({n for one in keys for key in one for n, _ in key})
        place = {number: position for position, number in enumerate(numbers)}
        tables = [np.zeros((len(one), len(numbers))) for one in keys]
        for table, one in zip(tables, keys, strict=True):
            for row, key in enumerate(one):
                for number, exponent in key:
                    table[row, place[number]] = exponent
        lows, highs = (np.array([_near(self.atoms[n][i]) for n in numbers]) for i in (0, 1))
        return tables, lows, highs

    def _logarithms(self, above: Polynomial, below: Sequence[tuple[Key, Ball]]) -> Any:
        """About the largest quotients of a sum's terms by some products; what is chosen by them is checked after."""
        (top, foot), lows, highs = self._table(above, (key for key, _ in below))
        net = top[:, np.newaxis] - foot[np.newaxis]
        feet = np.array([_log(c.lower()) for _, c in below])
        return _tops(above)[:, np.newaxis] - feet + np.maximum(net, 0) @ highs + np.minimum(net, 0) @ lows

    def _leading(self, sum_: Polynomial, near: float = 0.0) -> Polynomial:
        """Terms that no other is above all over the box, as nearly: a part of a sum that as a scale does as well."""
        under = self._logarithms(sum_, list(sum_.items())) <= near
        kept: list[int] = []
        for n in np.argsort(-under.sum(axis=0), kind="stable"):
            if not under[n, kept].any():
                kept.append(int(n))
        terms = list(sum_.items())
        return dict(terms[n] for n in sorted(kept))

    def condensed(self, sum_: Polynomial) -> Polynomial | None:
        """The same by its leading terms: each is as much more as the others that are shares of it."""
        found = (self._leading(sum_, near) for near in CLOSER)
        parts = next((one for one in found if len(one) <= MOST_PARTS // 2), None)
        if parts is None:
            return None
        keys, others = list(parts.items()), {key: c for key, c in sum_.items() if key not in parts}
        spent: dict[Key, Ball] = dict.fromkeys(parts, self.ball(0))
        for (key, size), chosen in zip(others.items(), self._logarithms(others, keys).argmin(axis=1), strict=True):
            spent[keys[chosen][0]] += self._ratio(key, size, *keys[chosen])
        return self._kept({key: (_below(c), _above(c * (1 + spent[key]))) for key, c in keys})

    def _best_pairs(self, error: Polynomial, first: Polynomial, second: Polynomial) -> Iterator[Any]:
        """For every term of an error the pairs of two sums whose geometric mean it is smallest by, as nearly as any."""
        (rows, left, right), lows, highs = self._table(error, first, second)
        halves = (left[:, np.newaxis] + right[np.newaxis]) / 2
        feet = [np.array([_log(c.lower()) for c in one.values()]) / 2 for one in (first, second)]
        means = feet[0][:, np.newaxis] + feet[1]
        for row in rows:
            net = row - halves
            found = (np.maximum(net, 0) @ highs + np.minimum(net, 0) @ lows - means).ravel()
            near = np.flatnonzero(found <= found.min() + CLOSE)
            yield [divmod(int(n), len(second)) for n in near[np.argsort(found[near], kind="stable")][:MOST_SHARED]]

    def share(self, error: Polynomial, scale: Polynomial) -> Ball | None:
        """A number κ with error ≤ κ · scale; a term of the error counts by that of the scale that it is smallest by."""
        if not error:
            return self.ball(0)
        if not scale:
            return None
        keys = list(scale.items())
        best = self._logarithms(error, keys).argmin(axis=1)
        loads: dict[Key, Ball] = {}
        for (key, coefficient), chosen in zip(error.items(), best, strict=True):
            other, size = keys[chosen]
            loads[other] = loads.get(other, self.ball(0)) + self._ratio(key, coefficient, other, size)
        found = _largest(list(loads.values()))
        return found if found.is_finite() else None

    def paired(self, error: Polynomial, first: Polynomial, second: Polynomial) -> Ball | None:
        """A number κ with error ≤ κ · √(first · second).

        Σ Mᵢⱼ √(aᵢ bⱼ) is at most ‖M‖ √(Σ aᵢ Σ bⱼ), and ‖M‖² at most the largest sum of a row by that of a column.
        """
        if not error:
            return self.ball(0)
        if len(first) * len(second) * len(error) > MOST_PAIRS:
            first, second = self._leading(first), self._leading(second)
        if not first or not second or len(first) * len(second) * len(error) > MOST_PAIRS:
            return None
        rows, columns = dict.fromkeys(first, self.ball(0)), dict.fromkeys(second, self.ball(0))
        left, right = list(first.items()), list(second.items())
        for (key, coefficient), shared in zip(error.items(), self._best_pairs(error, first, second), strict=True):
            for m, n in shared:
                (i, a), (j, b) = left[m], right[n]
                ratio = self._ratio(key, coefficient, product_of(half(i), half(j)), (a * b).sqrt()) / len(shared)
                rows[i] += ratio
                columns[j] += ratio
        found = _above((_largest(list(rows.values())) * _largest(list(columns.values()))).sqrt())
        return found if found.is_finite() else None

    def plain(self, value: Signed) -> Polynomial | None:
        """A sum whose terms have one sign as they stand."""
        if len({c > 0 for c in value.values()}) != 1 or any(n in self.carriers for key in value for n, _ in key):
            return None
        return {key: abs(self.flint.arb(c)) for key, c in value.items()}

    def of_one_sign(self, value: Signed) -> tuple[int, Polynomial] | None:
        """The sign of a sum and its size as a sum, where what is subtracted is part of what is there."""
        if len(value) > self.most_value:
            return None
        name, turn = _normal(value)
        if (name, turn) not in self.signs:
            self.signs[name, turn] = self._sign_found(value)
        return self.signs[name, turn]

    def _sign_found(self, value: Signed) -> tuple[int, Polynomial] | None:
        forms = list(self._forms(value))
        for narrow in NARROW:
            for form in forms:
                found = self._of_one_sign(form, narrow)
                if found is not None:
                    return found
        for form in forms:
            found = self._of_small_ones(form)
            if found is not None:
                return found
        return None

    def _forms(self, value: Signed) -> Iterator[Signed]:
        """The sum with sin² for 1 − cos² or the other way, of every angle."""
        there = [w for w in self.waves if any(e >= 2 and n in w for key in value for n, e in key)][:3]
        yield value
        for turns in pairs_of((0, 1), repeat=len(there)) if there else ():
            form = value
            for wave, turn in zip(there, turns, strict=True):
                form = self._with_square_replaced(form, wave[turn], wave[1 - turn])
            yield form

    def _with_square_replaced(self, value: Signed, gone: int, kept: int) -> Signed:
        found: Signed = {}
        rows = list(value.items())
        while rows:
            key, coefficient = rows.pop()
            exponents = dict(key)
            if exponents.get(gone, 0.0) >= 2:
                rest = product_of(key, ((gone, 2.0),), -1.0)
                rows += [(rest, coefficient), (product_of(rest, ((kept, 2.0),)), -coefficient)]
            else:
                _put(found, key, coefficient)
        return found

    def _of_one_sign(self, value: Signed, narrow: float) -> tuple[int, Polynomial] | None:
        if not value:
            return None
        shared = frozenset.intersection(*(frozenset(p for p in key if p[0] in self.carriers) for key in value))
        groups: dict[Key, Ball] = {}
        for key, coefficient in value.items():
            rest = tuple(part for part in key if part not in shared)
            wide = tuple(p for p in rest if p[0] not in self.carriers and not self._is_narrow(p[0], narrow))
            near = tuple(p for p in rest if p not in wide and p[0] not in self.carriers)
            size = self.flint.arb(coefficient)
            if near:
                low, high = (end.exp() for end in self.monomial(near, self.one))
                size *= _between(_below(low), _above(high))
            if any(p[0] in self.carriers for p in rest):
                size = _between(-abs(size).upper(), abs(size).upper())
            groups[wide] = groups[wide] + size if wide in groups else size
        return self._absorbed_in_either(groups, unknown=bool(shared))

    def _absorbed_in_either(self, groups: dict[Key, Ball], *, unknown: bool) -> tuple[int, Polynomial] | None:
        for sign in (1, -1):
            found = self._absorbed({key: sign * size for key, size in groups.items()})
            if found is not None:
                return (0 if unknown else sign), found
        return None

    def _of_small_ones(self, value: Signed) -> tuple[int, Polynomial] | None:
        """The same, with sums of sizes that are at most 1 looked at in cells: what has other sizes in common is one."""
        groups: dict[Key, Signed] = {}
        for key, coefficient in value.items():
            if any(n in self.carriers for n, _ in key):
                return None
            outer = tuple((n, e) for n, e in key if not self._is_small(n))
            groups.setdefault(outer, {})[tuple(p for p in key if p not in outer)] = coefficient
        found: dict[Key, Ball] = {}
        for outer, inner in groups.items():
            common = _common(inner)
            rest = {product_of(key, common, -1.0): c for key, c in inner.items()}
            parts = self._cells(rest) if _is_mixed(rest) else None
            if parts is None or parts.common:
                found |= {product_of(outer, key): self.flint.arb(c) for key, c in inner.items()}
            else:
                found[product_of(outer, common)] = _between(*ends_of(parts.cells))
        return self._absorbed_in_either(found, unknown=False) if len(found) < len(value) else None

    def _is_small(self, number: int) -> bool:
        low, high = self.atoms[number]
        return low.is_finite() and bool(high < 0.1)

    def _is_narrow(self, number: int, width: float) -> bool:
        low, high = self.atoms[number]
        return width > 0 and bool(high - low < width)

    def _absorbed(self, groups: dict[Key, Ball]) -> Polynomial | None:
        """Positive parts that hold all others: what may be negative is a share of a part, or of two by their mean."""
        parts = {key: size for key, size in groups.items() if size > 0}
        others = {key: _above(abs(size)) for key, size in groups.items() if not size > 0 and not size.is_zero()}
        if not parts or not others:
            return self._kept({key: (_below(size), _above(size)) for key, size in parts.items()}) if parts else None
        keys = list(parts)
        pairs = [(i, j) for n, i in enumerate(keys) for j in keys[n:]] if len(keys) <= 12 else [(i, i) for i in keys]
        roots = [(product_of(half(i), half(j)), (parts[i].lower() * parts[j].lower()).sqrt()) for i, j in pairs]
        best = self._logarithms(others, roots)
        if not best.size or not (best.min(axis=1) < 0.7).all():
            return None
        spent: dict[Key, Ball] = dict.fromkeys(keys, self.ball(0))
        for row, (key, size) in zip(best, others.items(), strict=True):
            chosen = int(row.argmin())
            ratio = self._ratio(key, size, *roots[chosen])
            for part in pairs[chosen]:
                spent[part] += ratio / 2
        found = {}
        for key, size in parts.items():
            share = _above(spent[key])
            if not share < 1:
                return None
            low = _below(size.lower() * (1 - share))
            if not low > 1e-6 * size.upper():
                return None
            found[key] = low, _above(size.upper() * (1 + share))
        return self._kept(found)

    def _kept(self, parts: dict[Key, tuple[Ball, Ball]]) -> Polynomial:
        """Sizes that are known within limits: what is not known is one size more, as balls are too wide to multiply."""
        found: Polynomial = {}
        for key, (low, high) in parts.items():
            if high < low * (1 + 1e-6):
                found[key] = low.union(high)
            else:
                share = self.atom(_below(low.log()), _above(high.log()))
                self.shares.add(share[0][0])
                found[product_of(key, share)] = self.one
        return found

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
            size, exactly = None if size is exactly else size, self.condensed(exactly)
        exactly, value = self._identified(exactly, value, sign, low, high)
        if size is None or not self.in_parts or len(size) > MOST_PARTS:
            size = exactly
        if error is not None and len(error) > MOST_PARTS:
            error = {(): _above(self.bounds(error)[1].exp())} if relative is None else None
        if tiny < self.precision.normal and may_underflow:
            lost = self.ball(self.precision.underflow)
            error = plus(_scaled(size, relative) if error is None else error, {(): lost})
            if relative is not None:
                relative = _above(relative + lost / low.exp()) if low.is_finite() else None
        if error is None:
            error = _scaled(size, relative)
        elif relative is None or not relative.is_finite() or relative > GOOD:
            relative = _least(relative, self._by_itself(error, exactly, value))
        return Number(sign, low, high, _least(relative), size, exactly, error, terms or exactly, tiny, value)

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
        found = self.share(error, exactly)
        if found is not None and not found > FAIR:
            return found
        plain = self.plain(value)
        others = [self.share(error, plain)] if plain else []
        others += [self.paired(error, one, one) for one in (exactly, plain) if one and len(one) <= FEW]
        return _least(found, *others)

    def _rounded(self, relative: Ball | None, units: float) -> Ball | None:
        return None if relative is None else _above(relative + units + self.unit * relative * units)

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
        error = _scaled(size, self.ball(roundings)) if roundings else NOTHING
        grid = 1 - int(exact.q).bit_length() if not roundings and int(exact.q).bit_count() == 1 else None
        return Number(
            1 if exact > 0 else -1, _below(log), _above(log), self.ball(roundings), size, size, error, size,
            float(log.lower()) / math.log(2) - 1e-3, {(): exact}, grid,
        )  # fmt: skip

    def argument(self, sign: int, low: Ball, high: Ball, roundings: float = 0.0) -> Number:
        """What is given: a size, and a sign that may be either."""
        key = self.atom(low, high)
        size: Polynomial = {key: self.one}
        value = {key: self.rational(sign)} if sign else {_key(key, self.carrier(), self.carriers): self.rational(1)}
        error = _scaled(size, self.ball(roundings)) if roundings else NOTHING
        tiny = float(low.lower()) / math.log(2) - 1e-3
        return Number(sign, low, high, self.ball(roundings), size, size, error, size, tiny, value)

    def multiply(self, a: Number | None, b: Number | None, units: float = 1.0) -> Number | None:
        """a · b."""
        if a is None or b is None:
            return None
        a, b = self._factor(a), self._factor(b)
        if len(a.size) * len(b.size) > 4 * MOST_PARTS:
            a, b = (self.as_whole(one) if len(one.size) > MOST_PARTS // 8 else one for one in (a, b))
        relative, u = None, self.unit
        if a.relative is not None and b.relative is not None:
            relative = self._rounded(a.relative + b.relative + u * a.relative * b.relative, units)
        exactly = times(a.exactly, b.exactly)
        size = times(a.size, b.size) if a.size is not a.exactly or b.size is not b.exactly else exactly
        error = None
        if relative is None or not (self._is_of_relative(a) and self._is_of_relative(b)):
            spread = plus(times(a.error, b.size), times(a.size, b.error), _scaled(times(a.error, b.error), u))
            error = plus(_scaled(spread, 1 + u * units), _scaled(size, self.ball(units)))
        ends = (_below(a.low + b.low), _above(a.high + b.high))
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
        error: Polynomial = {(): _above(self.bounds(a.error)[1].exp())} if a.error else NOTHING
        if a.relative is not None:
            error = _scaled(size, a.relative)
        return replace(a, value=value, size=size, exactly=size, error=error, terms=size)

    def _is_of_relative(self, a: Number) -> bool:
        """Whether its error says no more than the relative one."""
        return a.is_exact or (a.relative is not None and len(a.size) == 1)

    @staticmethod
    def total(a: Signed, b: Signed) -> Signed:
        """The sum of two sums with signs."""
        found = dict(a)
        for key, coefficient in b.items():
            _put(found, key, coefficient)
        return found

    def product(self, a: Signed, b: Signed) -> Signed | None:
        """The product of two sums with signs, unless it has too many terms."""
        if len(a) * len(b) > 4 * self.most_value:
            return None
        found: Signed = {}
        for (i, x), (j, y) in pairs_of(a.items(), b.items()):
            _put(found, _key(i, j, self.carriers), x * y)
        return found

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
        size = _scaled(a.size, f)
        return Number(
            a.sign if factor > 0 else -a.sign, _below(a.low + f.log()), _above(a.high + f.log()), a.relative,
            size, size if a.exactly is a.size else _scaled(a.exactly, f), _scaled(a.error, f), _scaled(a.terms, f),
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
        worse = _above(b.relative / (1 - self.small(b.relative)))
        if len(b.value) == 1 and len(b.exactly) == 1:
            of, below = b.value, b.exactly
        else:
            of, below = self.whole(b.value, b.sign, b.low, b.high)
        inverse = {_inverse(key): 1 / c for key, c in below.items()}
        size, terms, exactly = times(a.size, inverse), times(a.terms, inverse), times(a.exactly, inverse)
        relative = None if a.relative is None else self._rounded(a.relative + worse + u * a.relative * worse, 1.0)
        error = None
        if relative is None or not self._is_of_relative(a):
            error = plus(
                _scaled(times(a.error, inverse), (1 + u) * (1 + u * worse)), _scaled(size, 1 + (1 + u) * worse)
            )
        ends = (_below(a.low - b.high), _above(a.high - b.low))
        tiny = a.tiny - float(b.high.upper()) / math.log(2) - 1e-3
        value = self.product(a.value, {_inverse(key): 1 / c for key, c in of.items()})
        return self.made(a.sign * b.sign, exactly, error, relative, tiny, value, size, terms, ends)

    def _if_not_zero(self, a: Number) -> Number:
        """The same where it is not zero; a formula that divides by it is not defined there."""
        return a if a.low.is_finite() else replace(a, low=_below(self.ball(a.tiny - 1e-2) * self.ball(2).log()))

    def add(self, a: Number | None, b: Number | None) -> Number | None:
        """a + b."""
        if a is None or b is None:
            return a or b
        value = self.total(a.value, b.value)
        if not value and a.is_exact and b.is_exact:
            return None
        grid = None if a.grid is None or b.grid is None else min(a.grid, b.grid)
        u, size, terms = self.unit, plus(a.size, b.size), plus(a.terms, b.terms)
        high = _above((a.high.exp() + b.high.exp()).log())
        is_of_exact = a.is_exact and b.is_exact
        relative, parts = self.one if is_of_exact else None, None
        if a.sign * b.sign > 0:
            if a.relative is not None and b.relative is not None:
                relative = self._rounded(_largest([a.relative, b.relative]), 1.0)
            exactly: Polynomial | None = plus(a.exactly, b.exactly)
            least = a.low.exp() + b.low.exp()
            sign, ends = a.sign, (_below(least.log()) if least > 0 else self.ball(-math.inf), high)
            tiny = max(a.tiny, b.tiny) - 1e-3
        else:
            parts = self._cells(value) if value else None
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
        error = plus(_scaled(plus(a.error, b.error), 1 + u), size) if rounds else NOTHING
        relative = _least(relative, self._by_cells(error, parts)) if rounds else self.ball(0)
        made = self.made(sign, exactly, error, relative, tiny, value or None, size, terms, ends, may_underflow=False)
        return replace(made if a.sign * b.sign > 0 else self._known_well(made), grid=grid)

    def _known_well(self, difference: Number) -> Number:
        """A difference as one size, where that is the way, and its sign and size are known."""
        if not self.signed_whole or difference.relative is None or not difference.relative < FAIR:
            return difference
        return self.as_whole(difference) if difference.high - difference.low < NARROW[-1] else difference

    def _factor(self, a: Number) -> Number:
        """A difference that is multiplied as one size, where that is the way, and its sign and size are known."""
        if not self.factors_whole or a.relative is None or not a.relative < FAIR or not _is_mixed(a.value):
            return a
        return self.as_whole(a) if a.high - a.low < NARROW[-1] else a

    def _difference(
        self, a: Number, b: Number, value: Signed, parts: Parts | None, high: Ball
    ) -> tuple[int, Polynomial | None, tuple[Ball, Ball]]:
        """Sign, size and range of a sum whose terms may cancel."""
        low, sign = self.ball(-math.inf), 0
        if a.sign * b.sign < 0:
            apart = [_above(x.high.exp() - y.low.exp()) for x, y in ((a, b), (b, a))]
            high = _lowest((high, _above(_largest(apart).log()))) if _largest(apart) > 0 else high
        for major, minor in ((a, b), (b, a)):
            if major.sign and minor.high < major.low:
                low, sign = _below(major.low + (1 - (minor.high - major.low).exp()).log()), major.sign
        if parts:
            sign, least, most = self._ends_of(parts)
            low, high = _highest((low, least)), _lowest((high, most))
        found = (self.of_one_sign(value) or self._remainder(a, b)) if value else None
        if found is None:
            return sign, None, (low, high)
        ends = self.bounds(found[1])
        low, high, sign = _highest((low, ends[0])), _lowest((high, ends[1])), found[0] or sign
        spreads = [self.atoms[n] for key in found[1] for n, _ in key if n in self.shares]
        if any(b - a > high - low + 0.1 for a, b in spreads):
            return sign, self.whole(value, sign, low, high)[1], (low, high)
        return sign, found[1], (low, high)

    def _cells(self, value: Signed) -> Parts | None:
        """The box in parts in which a sum of few sizes is known well."""
        numbers = {n for key in value for n, _ in key}
        if len(value) > SOME or any(n in self.carriers or not self.atoms[n][0].is_finite() for n in numbers):
            return None
        sum_ = {key: self.flint.arb(c) for key, c in value.items()}
        curves = {n: self.curves[n] for n in sorted(numbers) if n in self.curves}
        if len({curve.argument for curve in curves.values()}) == 1:
            return self._cells_along(sum_, curves)
        found = cells(sum_, {n: self.atoms[n] for n in numbers})
        return Parts(found) if found else None

    def _cells_along(self, sum_: Polynomial, curves: dict[int, Curve]) -> Parts | None:
        """The same, where sizes are functions of one argument, by that."""
        argument = next(iter(curves.values())).argument
        span = max(curve.low for curve in curves.values()), min(curve.high for curve in curves.values())
        by_argument = _by_argument(sum_, argument)
        common = _common(by_argument)
        rest = {product_of(key, common, -1.0): c for key, c in by_argument.items()}
        others = {n: self.atoms[n] for key in rest for n, _ in key if n not in curves and n != ARGUMENT}
        along = Along(ARGUMENT, {n: curve.logarithms for n, curve in curves.items()})
        found = cells(rest, {**others, ARGUMENT: span}, along)
        return Parts(found, common, argument, span) if found else None

    def _ends_of(self, parts: Parts) -> tuple[int, Ball, Ball]:
        """The sign of a sum in cells, and of the logarithm of its size the ends."""
        least, most = ends_of(parts.cells)
        sign, sizes = (1, (least, most)) if least > 0 else (-1, (-most, -least))
        low, high = sizes[0].log(), sizes[1].log()
        for n, exponent in parts.common:
            ends = parts.span if n == ARGUMENT and parts.span else self.atoms[n]
            first, last = ends if exponent > 0 else ends[::-1]
            low, high = low + first * exponent, high + last * exponent
        return sign, _below(low), _above(high)

    def _by_cells(self, error: Polynomial, parts: Parts | None) -> Ball | None:
        """A bound of an error by the sum that it is of, cell by cell."""
        if parts is None:
            return None
        turned = _by_argument(error, parts.argument) if parts.argument else error
        rest = {product_of(key, parts.common, -1.0): c for key, c in turned.items()}
        others = dict(enumerate(self.atoms)) | ({ARGUMENT: parts.span} if parts.span else {})
        return largest_share(rest, parts.cells, others)

    def follows(self, key: Key, argument: Number, ends: Callable[[Ball, Ball], tuple[Ball, Ball]]) -> None:
        """Note that a size is a function of an argument."""
        if self.by_argument and len(argument.value) == len(argument.exactly) == 1 and argument.low.is_finite():
            ((of, size),) = argument.exactly.items()
            if size == 1:
                self.curves[key[0][0]] = Curve(of, argument.low, argument.high, ends)

    def _remainder(self, a: Number, b: Number) -> tuple[int, Polynomial] | None:
        """The same of the parts as they came about."""
        if a.sign * b.sign >= 0 or max(len(a.exactly), len(b.exactly)) > MOST_VALUE:
            return None
        left = plus(a.exactly, _scaled(b.exactly, self.ball(-1)))
        for sign in (1, -1):
            found = self._absorbed({key: sign * size for key, size in left.items()})
            if found is not None:
                return sign * a.sign, found
        return None

    def root(self, a: Number | None) -> Number | None:
        """√a."""
        if a is None:
            return None
        if a.sign <= 0 or a.relative is None:
            raise Refused("a root of what may be negative")
        part = self.small(a.relative)
        relative = self._rounded(a.relative / (1 + (1 - part).sqrt()), 1.0)
        (value, exactly), ends = self._root_of(a), (_below(a.low / 2), _above(a.high / 2))
        return self.made(1, exactly, None, relative, a.tiny / 2 - 1e-3, value, ends=ends, may_underflow=False)

    def _root_of(self, a: Number) -> tuple[Signed, Polynomial]:
        if len(a.value) == 1 and len(a.exactly) == 1:
            ((key, c),) = a.value.items()
            above, below = math.isqrt(int(c.p)), math.isqrt(int(c.q))
            if above**2 == int(c.p) and below**2 == int(c.q) and not any(n in self.carriers for n, _ in key):
                root = self.rational(Fraction(above, below))
                return {half(key): root}, {half(key): self.flint.arb(root)}
        return self.whole(
            {(*key, (-2, 1.0)): c for key, c in a.value.items()}, 1, _below(a.low / 2), _above(a.high / 2)
        )

    def hypotenuse(self, a: Number | None, b: Number | None) -> Number | None:
        """√(a² + b²)."""
        if a is None or b is None:
            return self.magnitude(a or b)
        if a.relative is None or b.relative is None:
            raise Refused("the length of a vector whose entries may vanish")
        relative = self._rounded(_largest([a.relative, b.relative]), 2.0 * self.precision.ulps["hypot"])
        low, high = (((2 * x).exp() + (2 * y).exp()).log() / 2 for x, y in ((a.low, b.low), (a.high, b.high)))
        return self._new(1, _below(low), _above(high), relative, max(a.tiny, b.tiny) - 1e-3)

    def magnitude(self, a: Number | None) -> Number | None:
        """|a|."""
        if a is None or a.sign > 0:
            return a
        if a.sign < 0:
            return self.by_power_of_two(a, -1.0)
        if len(a.exactly) == 1 and len(a.value) == 1:
            value: Signed = {self.bare(key): abs(c) for key, c in a.value.items()}
        else:
            value, _ = self.whole({(*key, (-3, 1.0)): c for key, c in a.value.items()}, 1, a.low, a.high)
        return replace(a, sign=1, value=value)

    def _new(self, sign: int, low: Ball, high: Ball, relative: Ball | None, tiny: float) -> Number:
        """A result of a function that nothing else is known of."""
        key = self.atom(low, high)
        value = {key: self.rational(sign)} if sign else {_key(key, self.carrier(), self.carriers): self.rational(1)}
        return self.made(sign, {key: self.one}, None, relative, tiny, value, ends=(low, high))

    def between(self, low: Ball, high: Ball, relative: Ball | None, error: Ball | None) -> Number:
        """A value of which its ends are known, and an error: relative, and where there is none in units of rounding."""
        size = _above(_largest([abs(low), abs(high)]).log())
        if relative is not None and (low > 0 or high < 0):
            least = _below(_lowest((abs(low), abs(high))).log())
            return self._new(1 if low > 0 else -1, least, size, relative, float(least) / math.log(2) - 1e-3)
        key, least = self.atom(self.ball(-math.inf), size), self.ball(-math.inf)
        value = {_key(key, self.carrier(), self.carriers): self.rational(1)}
        tiny = float(self.precision.normal - self.precision.bits)
        spread: Polynomial = {(): error}
        return self.made(0, {key: self.one}, spread, None, tiny, value, ends=(least, size), may_underflow=False)

    def wave(self, a: Number | None, *, is_sine: bool) -> Number | None:
        """Sine or cosine of a result: as far off as that, and never more than 1; a sine no more than what it is of."""
        if a is None:
            return None if is_sine else self.constant(1)
        high = _lowest((a.high, self.ball(0))) if is_sine else self.ball(0)
        own = self.ball(2.0 * self.precision.ulps["sin" if is_sine else "cos"])
        key, least = self.atom(self.ball(-math.inf), high), self.ball(-math.inf)
        value = {_key(key, self.carrier(), self.carriers): self.rational(1)}
        error = plus(_scaled(a.error, 1 + self.unit * own), {key: own})
        tiny = float(self.precision.normal - self.precision.bits)
        return self.made(0, {key: self.one}, error, None, tiny, value, ends=(least, high), may_underflow=False)

    def without_error(self, a: Number) -> Number:
        """A value that is taken for exact."""
        return replace(a, relative=self.ball(0), error=NOTHING)

    def direction(self, y: Number | None, x: Number | None) -> Number | None:
        """The angle of (x, y): half the sine of twice the angle, which is below the angle, is its condition."""
        known = [one for one in (y, x) if one is not None]
        if not known:
            return None
        relatives = [one.relative for one in known if one.relative is not None]
        if len(relatives) < len(known):
            raise Refused("the direction of a vector whose entries may vanish")
        both = sum(relatives, self.ball(0)) * (1 + self.ball(2.0**-10))
        self.small(both)
        tiny = min(one.tiny for one in known) - max(float(one.high.upper()) for one in known) / math.log(2) - 2
        relative = self._rounded(both, 2.0 * self.precision.ulps["arctan2"])
        return self._new(0, self.ball(-math.inf), _above(self.flint.arb.pi().log()), relative, tiny)

    def exponential(self, a: Number | None) -> Number | None:
        """e^a."""
        if a is None:
            return self.constant(1)
        if not a.sign:
            raise Refused("an exponential of either sign")
        ends = [a.sign * a.low.exp(), a.sign * a.high.exp()]
        low, high = (_below(ends[0]), _above(ends[1])) if a.sign > 0 else (_below(ends[1]), _above(ends[0]))
        off = self.bounds(a.error)[1].exp() if a.error else self.ball(0)
        off = off if a.relative is None else min(off, a.relative * a.high.exp(), key=_float)
        change = (self.unit * off).expm1() / self.unit
        relative = self._rounded(_above(change), 2.0 * self.precision.ulps["exp"])
        found = self._new(1, low, high, relative, float(low.lower()) / math.log(2) - 1e-3)
        self.follows(next(iter(found.exactly)), a, lambda low, high: ((a.sign * low).exp(), (a.sign * high).exp()))
        return found

    def exponential_less_one(self, a: Number | None) -> Number | None:
        """e^a − 1; its condition is below 1 on the left, a/(1 − e^−a) on the right."""
        if a is None:
            return None
        if not a.sign or a.relative is None:
            raise Refused("expm1 of either sign")
        low, high = ((a.sign * end.exp()).expm1() * a.sign for end in (a.low, a.high))
        low, high = _below(low.log()), _above(high.log())
        part = self.small(a.relative)
        farthest = a.high.exp() * (1 + part)
        condition = farthest / -(-farthest).expm1() if a.sign > 0 else self.ball(1)
        change = ((condition * -(1 - part).log()).expm1()) / self.unit
        relative = self._rounded(_above(change), 2.0 * self.precision.ulps["expm1"])
        tiny = float(low.lower()) / math.log(2) - 1e-3
        if not self.by_argument or not a.low.is_finite() or len(a.value) > 1 or len(a.exactly) > 1:
            return self._new(a.sign, low, high, relative, tiny)
        ends = [((a.sign * end.exp()).expm1() / end.exp() * a.sign).log() for end in (a.low, a.high)]
        share = self.atom(_below(min(ends, key=_float)), _above(max(ends, key=_float)))
        self.follows(share, a, lambda low, high: ((a.sign * low).expm1() / low, (a.sign * high).expm1() / high))
        of_a, size = ({product_of(key, share): c for key, c in one.items()} for one in (a.value, a.exactly))
        return self.made(a.sign, size, None, relative, tiny, of_a, ends=(low, high))


def _put(sum_: Signed, key: Key, coefficient: Rational) -> None:
    found = sum_.get(key, 0) + coefficient
    if found == 0:
        sum_.pop(key, None)
    else:
        sum_[key] = found


def _is_mixed(value: Signed) -> bool:
    """Whether its terms have both signs."""
    return len({c > 0 for c in value.values()}) > 1


def _common(value: Signed) -> Key:
    """What all terms have as a factor."""
    each = [dict(key) for key in value]
    least = ((n, min(one.get(n, 0.0) for one in each)) for n in sorted({n for one in each for n in one}))
    return tuple((n, exponent) for n, exponent in least if exponent)


def _by_argument(sum_: Polynomial, argument: Key) -> Polynomial:
    """A sum with one size for a product of powers, as often as a term has it."""
    found: Polynomial = {}
    for key, c in sum_.items():
        exponents = dict(key)
        power = max(min(exponents.get(n, 0.0) / e for n, e in argument), 0.0)
        turned = product_of(product_of(key, argument, -power), ((ARGUMENT, power),))
        found[turned] = found[turned] + c if turned in found else c
    return found


def _normal(value: Signed) -> tuple[Any, int]:
    """A name of a value and of its opposite, and which of the two it is."""
    first = min(value)
    turn = 1 if value[first] > 0 else -1
    return frozenset((key, str(c * turn)) for key, c in value.items()), turn


def _key(first: Key, second: Key, carriers: set[int]) -> Key:
    found = product_of(first, second)
    if carriers:
        return tuple((n, e % 2 if n in carriers else e) for n, e in found if n not in carriers or e % 2)
    return found


def product_of(first: Key, second: Key, power: float = 1.0) -> Key:
    """The product of one by a power of the other."""
    exponents = dict(first)
    for number, exponent in second:
        exponents[number] = exponents.get(number, 0.0) + power * exponent
    return tuple(sorted((number, exponent) for number, exponent in exponents.items() if exponent))


def half(key: Key) -> Key:
    """The root."""
    return tuple((number, exponent / 2) for number, exponent in key)


def _inverse(key: Key) -> Key:
    return tuple((number, -exponent) for number, exponent in key)


def plus(*sums: Polynomial) -> Polynomial:
    """The sum."""
    found: Polynomial = {}
    for one in sums:
        for key, coefficient in one.items():
            found[key] = found[key] + coefficient if key in found else coefficient
    return found


def times(first: Polynomial, second: Polynomial) -> Polynomial:
    """The product."""
    found: Polynomial = {}
    for (i, a), (j, b) in pairs_of(first.items(), second.items()):
        key = product_of(i, j)
        found[key] = found[key] + a * b if key in found else a * b
    return found


def _scaled(one: Polynomial, factor: Ball) -> Polynomial:
    return {key: coefficient * factor for key, coefficient in one.items()}


def _float(ball: Ball) -> float:
    """Close to its upper end; infinite where it is no number."""
    value = float(ball.upper())
    return math.inf if math.isnan(value) else value


def _near(ball: Ball) -> float:
    value = float(ball)
    return value if math.isfinite(value) else math.copysign(ENDLESS, -1.0 if math.isnan(value) else value)


def _log(ball: Ball) -> float:
    return _near(ball.log()) if ball > 0 else -ENDLESS


def _tops(sum_: Polynomial) -> Any:
    """About the logarithms of coefficients."""
    return np.array([_log(c.upper()) for c in sum_.values()])


def _largest(balls: Sequence[Ball]) -> Ball:
    """One that no other is above."""
    return max(balls, key=_float)


def _least(*bounds: Ball | None) -> Ball | None:
    """The smallest bound; none where no one is finite."""
    finite = [bound for bound in bounds if bound is not None and bound.is_finite()]
    return min(finite, key=_float, default=None)


def _between(low: Ball, high: Ball) -> Ball:
    return low.union(high)


def _highest(balls: tuple[Ball, Ball]) -> Ball:
    return max(balls)


def _lowest(balls: tuple[Ball, Ball]) -> Ball:
    return min(balls)


def _above(ball: Ball) -> Ball:
    return ball.upper()


def _below(ball: Ball) -> Ball:
    return ball.lower()


FUNCTIONS: dict[str, Callable[..., Number | None]] = {
    "abs": Box.magnitude, "arctan2": Box.direction, "exp": Box.exponential, "expm1": Box.exponential_less_one,
    "hypot": Box.hypotenuse, "sqrt": Box.root,
}  # fmt: skip
