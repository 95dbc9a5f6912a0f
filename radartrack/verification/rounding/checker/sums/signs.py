"""The sign of a sum whose terms have both, and its size, where what is subtracted is part of what is there."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from itertools import product as pairs_of
from typing import Any

from radartrack.verification.rounding.checker.sums.ball_ends import Ball
from radartrack.verification.rounding.checker.sums.cells import ends
from radartrack.verification.rounding.checker.sums.products_of_powers import (
    Key,
    Polynomial,
    Signed,
    common_factor,
    half,
    is_mixed,
    normalised,
    product_of,
    put,
)
from radartrack.verification.rounding.checker.sums.shares import largest_ratio, logarithms_of_ratios
from radartrack.verification.rounding.checker.sums.sizes import Sizes
from radartrack.verification.rounding.checker.sums.sums_in_cells import in_cells

NARROW = (0.0, 0.75, 3.0)  # of logarithms: sizes known so well count as coefficients when signs are looked for


@dataclass
class Signs:
    """Of sums of the sizes of one box; a sum's parts are the same again when it is asked for again."""

    sizes: Sizes
    found: dict[Any, tuple[int, Polynomial] | None] = field(default_factory=dict)

    def of_one_sign(self, value: Signed) -> tuple[int, Polynomial] | None:
        """The sign of a sum and its size as a sum, where what is subtracted is part of what is there."""
        if len(value) > self.sizes.most_value:
            return None
        name, turn = normalised(value)
        if (name, turn) not in self.found:
            self.found[name, turn] = self._sign_found(value)
        return self.found[name, turn]

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
        there = [w for w in self.sizes.waves if any(e >= 2 and n in w for key in value for n, e in key)][:3]
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
                put(found, key, coefficient)
        return found

    def _of_one_sign(self, value: Signed, narrow: float) -> tuple[int, Polynomial] | None:
        if not value:
            return None
        shared = frozenset.intersection(*(frozenset(p for p in key if p[0] in self.sizes.carriers) for key in value))
        groups: dict[Key, Ball] = {}
        for key, coefficient in value.items():
            rest = tuple(part for part in key if part not in shared)
            wide = tuple(p for p in rest if p[0] not in self.sizes.carriers and not self._is_narrow(p[0], narrow))
            near = tuple(p for p in rest if p not in wide and p[0] not in self.sizes.carriers)
            size = self.sizes.flint.arb(coefficient)
            if near:
                low, high = (end.exp() for end in self.sizes.monomial(near, self.sizes.one))
                size *= low.lower().union(high.upper())
            if any(p[0] in self.sizes.carriers for p in rest):
                size = (-abs(size).upper()).union(abs(size).upper())
            groups[wide] = groups[wide] + size if wide in groups else size
        return self._absorbed_in_either(groups, unknown=bool(shared))

    def _absorbed_in_either(self, groups: dict[Key, Ball], *, unknown: bool) -> tuple[int, Polynomial] | None:
        for sign in (1, -1):
            found = self.absorbed({key: sign * size for key, size in groups.items()})
            if found is not None:
                return (0 if unknown else sign), found
        return None

    def _of_small_ones(self, value: Signed) -> tuple[int, Polynomial] | None:
        """The same, with sums of sizes that are at most 1 looked at in cells: what has other sizes in common is one."""
        groups: dict[Key, Signed] = {}
        for key, coefficient in value.items():
            if any(n in self.sizes.carriers for n, _ in key):
                return None
            outer = tuple((n, e) for n, e in key if not self._is_small(n))
            groups.setdefault(outer, {})[tuple(p for p in key if p not in outer)] = coefficient
        found: dict[Key, Ball] = {}
        for outer, inner in groups.items():
            common = common_factor(inner)
            rest = {product_of(key, common, -1.0): c for key, c in inner.items()}
            parts = in_cells(self.sizes, rest) if is_mixed(rest) else None
            if parts is None or parts.common:
                found |= {product_of(outer, key): self.sizes.flint.arb(c) for key, c in inner.items()}
            else:
                low, high = ends(parts.cells)
                found[product_of(outer, common)] = low.union(high)
        return self._absorbed_in_either(found, unknown=False) if len(found) < len(value) else None

    def _is_small(self, number: int) -> bool:
        low, high = self.sizes.atoms[number]
        return low.is_finite() and bool(high < 0.1)

    def _is_narrow(self, number: int, width: float) -> bool:
        low, high = self.sizes.atoms[number]
        return width > 0 and bool(high - low < width)

    def absorbed(self, groups: dict[Key, Ball]) -> Polynomial | None:
        """Positive parts that hold all others: what may be negative is a share of a part, or of two by their mean."""
        parts = {key: size for key, size in groups.items() if size > 0}
        others = {key: abs(size).upper() for key, size in groups.items() if not size > 0 and not size.is_zero()}
        if not parts:
            return None
        if not others:
            return self.sizes.within({key: (size.lower(), size.upper()) for key, size in parts.items()})
        keys = list(parts)
        pairs = [(i, j) for n, i in enumerate(keys) for j in keys[n:]] if len(keys) <= 12 else [(i, i) for i in keys]
        roots = [(product_of(half(i), half(j)), (parts[i].lower() * parts[j].lower()).sqrt()) for i, j in pairs]
        best = logarithms_of_ratios(self.sizes, others, roots)
        if not best.size or not (best.min(axis=1) < 0.7).all():
            return None
        spent: dict[Key, Ball] = dict.fromkeys(keys, self.sizes.ball(0))
        for row, (key, size) in zip(best, others.items(), strict=True):
            chosen = int(row.argmin())
            ratio = largest_ratio(self.sizes, key, size, *roots[chosen])
            for part in pairs[chosen]:
                spent[part] += ratio / 2
        found = {}
        for key, size in parts.items():
            share = spent[key].upper()
            if not share < 1:
                return None
            low = (size.lower() * (1 - share)).lower()
            if not low > 1e-6 * size.upper():
                return None
            found[key] = low, (size.upper() * (1 + share)).upper()
        return self.sizes.within(found)
