"""Sums of the sizes of a box, cell by cell of it."""

from __future__ import annotations

from dataclasses import dataclass

from radartrack.verification.rounding.checker.sums.ball_ends import Ball
from radartrack.verification.rounding.checker.sums.cells import Along, Cell, cells, ends, largest_share
from radartrack.verification.rounding.checker.sums.products_of_powers import (
    Key,
    Polynomial,
    Signed,
    common_factor,
    product_of,
)
from radartrack.verification.rounding.checker.sums.sizes import Curve, Sizes

ARGUMENT = -4  # the size that others are functions of
SOME = 32  # terms of a sum that is looked at in cells


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


def in_cells(sizes: Sizes, value: Signed) -> Parts | None:
    """The box in parts in which a sum of few sizes is known well."""
    numbers = {n for key in value for n, _ in key}
    if len(value) > SOME or any(n in sizes.carriers or not sizes.atoms[n][0].is_finite() for n in numbers):
        return None
    sum_ = {key: sizes.flint.arb(c) for key, c in value.items()}
    curves = {n: sizes.curves[n] for n in sorted(numbers) if n in sizes.curves}
    if len({curve.argument for curve in curves.values()}) == 1:
        return _along(sizes, sum_, curves)
    found = cells(sum_, {n: sizes.atoms[n] for n in numbers})
    return Parts(found) if found else None


def _along(sizes: Sizes, sum_: Polynomial, curves: dict[int, Curve]) -> Parts | None:
    """The same, where sizes are functions of one argument, by that."""
    argument = next(iter(curves.values())).argument
    span = max(curve.low for curve in curves.values()), min(curve.high for curve in curves.values())
    by_argument = _by_argument(sum_, argument)
    common = common_factor(by_argument)
    rest = {product_of(key, common, -1.0): c for key, c in by_argument.items()}
    others = {n: sizes.atoms[n] for key in rest for n, _ in key if n not in curves and n != ARGUMENT}
    along = Along(ARGUMENT, {n: curve.logarithms for n, curve in curves.items()})
    found = cells(rest, {**others, ARGUMENT: span}, along)
    return Parts(found, common, argument, span) if found else None


def ends_of_logarithm(sizes: Sizes, parts: Parts) -> tuple[int, Ball, Ball]:
    """The sign of a sum in cells, and of the logarithm of its size the ends."""
    least, most = ends(parts.cells)
    sign, near, far = (1, least, most) if least > 0 else (-1, -most, -least)
    low, high = near.log(), far.log()
    for n, exponent in parts.common:
        of_size = parts.span if n == ARGUMENT and parts.span else sizes.atoms[n]
        first, last = of_size if exponent > 0 else of_size[::-1]
        low, high = low + first * exponent, high + last * exponent
    return sign, low.lower(), high.upper()


def share_in_cells(sizes: Sizes, error: Polynomial, parts: Parts | None) -> Ball | None:
    """A bound of an error by the sum that it is of, cell by cell."""
    if parts is None:
        return None
    turned = _by_argument(error, parts.argument) if parts.argument else error
    rest = {product_of(key, parts.common, -1.0): c for key, c in turned.items()}
    others = dict(enumerate(sizes.atoms)) | ({ARGUMENT: parts.span} if parts.span else {})
    return largest_share(rest, parts.cells, others)


def _by_argument(sum_: Polynomial, argument: Key) -> Polynomial:
    """A sum with one size for a product of powers, as often as a term has it."""
    found: Polynomial = {}
    for key, c in sum_.items():
        exponents = dict(key)
        power = max(min(exponents.get(n, 0.0) / e for n, e in argument), 0.0)
        turned = product_of(product_of(key, argument, -power), ((ARGUMENT, power),))
        found[turned] = found[turned] + c if turned in found else c
    return found
