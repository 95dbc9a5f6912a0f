"""How often an error goes into a scale: term by term, each by the one of the scale that it is smallest by."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import Any

import numpy as np

from radartrack.verification.rounding.checker.sums.ball_ends import Ball, largest, log_of, nearest_float
from radartrack.verification.rounding.checker.sums.products_of_powers import Key, Polynomial, half, product_of
from radartrack.verification.rounding.checker.sums.sizes import Sizes

CLOSE = 0.4  # an error's terms are shared among products whose logarithms are this close to the best
CLOSER = (0.0, 1.0, 2.0, 4.0)  # logarithms by which terms may be above those that a long sum is condensed to
MOST_PARTS = 160  # terms of a sum of sizes
MOST_PAIRS, MOST_SHARED = 4_000_000, 32  # of terms of two variances, and those of them that one error is shared among


def share(sizes: Sizes, error: Polynomial, scale: Polynomial) -> Ball | None:
    """A number κ with error ≤ κ · scale; a term of the error counts by that of the scale that it is smallest by."""
    if not error:
        return sizes.ball(0)
    if not scale:
        return None
    keys = list(scale.items())
    best = logarithms_of_ratios(sizes, error, keys).argmin(axis=1)
    loads: dict[Key, Ball] = {}
    for (key, coefficient), chosen in zip(error.items(), best, strict=True):
        other, size = keys[chosen]
        loads[other] = loads.get(other, sizes.ball(0)) + largest_ratio(sizes, key, coefficient, other, size)
    found = largest(list(loads.values()))
    return found if found.is_finite() else None


def paired(sizes: Sizes, error: Polynomial, first: Polynomial, second: Polynomial) -> Ball | None:
    """A number κ with error ≤ κ · √(first · second).

    Σ Mᵢⱼ √(aᵢ bⱼ) is at most ‖M‖ √(Σ aᵢ Σ bⱼ), and ‖M‖² at most the largest sum of a row by that of a column.
    """
    if not error:
        return sizes.ball(0)
    if len(first) * len(second) * len(error) > MOST_PAIRS:
        first, second = _leading(sizes, first), _leading(sizes, second)
    if not first or not second or len(first) * len(second) * len(error) > MOST_PAIRS:
        return None
    rows, columns = dict.fromkeys(first, sizes.ball(0)), dict.fromkeys(second, sizes.ball(0))
    left, right = list(first.items()), list(second.items())
    for (key, coefficient), shared in zip(error.items(), _best_pairs(sizes, error, first, second), strict=True):
        for m, n in shared:
            (i, a), (j, b) = left[m], right[n]
            ratio = largest_ratio(sizes, key, coefficient, product_of(half(i), half(j)), (a * b).sqrt()) / len(shared)
            rows[i] += ratio
            columns[j] += ratio
    found = ((largest(list(rows.values())) * largest(list(columns.values()))).sqrt()).upper()
    return found if found.is_finite() else None


def condensed(sizes: Sizes, sum_: Polynomial) -> Polynomial | None:
    """The same by its leading terms: each is as much more as the others that are shares of it."""
    found = (_leading(sizes, sum_, near) for near in CLOSER)
    parts = next((one for one in found if len(one) <= MOST_PARTS // 2), None)
    if parts is None:
        return None
    keys, others = list(parts.items()), {key: c for key, c in sum_.items() if key not in parts}
    spent: dict[Key, Ball] = dict.fromkeys(parts, sizes.ball(0))
    best = logarithms_of_ratios(sizes, others, keys).argmin(axis=1)
    for (key, size), chosen in zip(others.items(), best, strict=True):
        spent[keys[chosen][0]] += largest_ratio(sizes, key, size, *keys[chosen])
    return sizes.within({key: (c.lower(), (c * (1 + spent[key])).upper()) for key, c in keys})


def largest_ratio(sizes: Sizes, key: Key, coefficient: Ball, other: Key, size: Ball) -> Ball:
    """What a term is of another one at most, all over the box."""
    return sizes.monomial(product_of(key, other, -1.0), coefficient / size)[1].exp().upper()


def _table(sizes: Sizes, *sums: Iterable[Key]) -> tuple[list[Any], Any, Any]:
    """Of sums the exponents of their terms, and where the sizes lie that these are of: in floating point."""
    keys = [list(sum_) for sum_ in sums]
    numbers = sorted({n for one in keys for key in one for n, _ in key})
    place = {number: position for position, number in enumerate(numbers)}
    tables = [np.zeros((len(one), len(numbers))) for one in keys]
    for table, one in zip(tables, keys, strict=True):
        for row, key in enumerate(one):
            for number, exponent in key:
                table[row, place[number]] = exponent
    lows, highs = (np.array([nearest_float(sizes.atoms[n][i]) for n in numbers]) for i in (0, 1))
    return tables, lows, highs


def logarithms_of_ratios(sizes: Sizes, above: Polynomial, below: Sequence[tuple[Key, Ball]]) -> Any:
    """About the largest quotients of a sum's terms by some products; what is chosen by them is checked after."""
    (top, foot), lows, highs = _table(sizes, above, (key for key, _ in below))
    net = top[:, np.newaxis] - foot[np.newaxis]
    feet = np.array([log_of(c.lower()) for _, c in below])
    return _tops(above)[:, np.newaxis] - feet + np.maximum(net, 0) @ highs + np.minimum(net, 0) @ lows


def _leading(sizes: Sizes, sum_: Polynomial, near: float = 0.0) -> Polynomial:
    """Terms that no other is above all over the box, as nearly: a part of a sum that as a scale does as well."""
    under = logarithms_of_ratios(sizes, sum_, list(sum_.items())) <= near
    kept: list[int] = []
    for n in np.argsort(-under.sum(axis=0), kind="stable"):
        if not under[n, kept].any():
            kept.append(int(n))
    terms = list(sum_.items())
    return dict(terms[n] for n in sorted(kept))


def _best_pairs(sizes: Sizes, error: Polynomial, first: Polynomial, second: Polynomial) -> Iterator[Any]:
    """For every term of an error the pairs of two sums whose geometric mean it is smallest by, as nearly as any."""
    (rows, left, right), lows, highs = _table(sizes, error, first, second)
    halves = (left[:, np.newaxis] + right[np.newaxis]) / 2
    feet = [np.array([log_of(c.lower()) for c in one.values()]) / 2 for one in (first, second)]
    means = feet[0][:, np.newaxis] + feet[1]
    for row in rows:
        net = row - halves
        found = (np.maximum(net, 0) @ highs + np.minimum(net, 0) @ lows - means).ravel()
        near = np.flatnonzero(found <= found.min() + CLOSE)
        yield [divmod(int(n), len(second)) for n in near[np.argsort(found[near], kind="stable")][:MOST_SHARED]]


def _tops(sum_: Polynomial) -> Any:
    """About the logarithms of coefficients."""
    return np.array([log_of(c.upper()) for c in sum_.values()])
