"""A slip in J or K of a covariance J K Jᵀ, told where it was made: in the covariance it shows in many entries.

What an entry of J would have to be, or K, follows at each point from what the covariance is there. Then that entry is
a function of its own, whose slip is looked for.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from itertools import chain, combinations
from typing import Any

import numpy as np
import numpy.typing as npt

from radartrack.derive.language.tensor import Index, indices
from radartrack.testing.calling.called_function import Array
from radartrack.testing.diagnosis import Slip, place
from radartrack.testing.slips.function_slips import SlipSearch, merged
from radartrack.testing.slips.matrix_product import MatrixProduct, matrix_product
from radartrack.testing.wanted import Expected

ORDER, EXCHANGED = 1.5, 1.2  # the cost of matrices multiplied in another order, and of exchanged entries
OTHER = 1e-7  # of its scale, from where on an entry of K is another
MOVED = 50.0  # times which an entry of J may be off where the covariance has few digits
MOST = 2  # entries of a matrix that are wrong; of more it is likelier that there is no product
OTHER_PRODUCTS: dict[str, Callable[[Array, Array], Array]] = {
    "J^T K J for J K J^T": lambda J, K: J.mT @ K @ J,
    "J K J for J K J^T": lambda J, K: J @ K @ J,
    "J^T K J^T for J K J^T": lambda J, K: J.mT @ K @ J.mT,
}
Both = tuple[MatrixProduct, MatrixProduct]  # at points of ordinary size, and in all directions


def product_slips(
    screening: Expected, found: Array, confirming: Expected, found_there: Array, share: float = 0.0
) -> tuple[Slip, ...]:
    """The slips in J or K, or in the order of the product J K Jᵀ; none for what is no such product.

    Args:
        screening: points of ordinary size.
        found: what the function has there, shape (points, entries).
        confirming: points in all directions.
        found_there: likewise.
        share: of a value, by which what is found may be off, where that is more than double precision makes.
    """
    here, there = matrix_product(screening, found, share), matrix_product(confirming, found_there, share)
    if here is None or there is None:
        return ()
    both = here, there
    ways = chain(_other_products(both), _in_errors(both), _in_one_entry(both), _in_two_rows(both))
    return next(filter(None, ways), ())


def _other_products(both: Both) -> Iterator[tuple[Slip, ...]]:
    square = both[0].J.shape[1] == both[0].J.shape[2]
    for words, product in OTHER_PRODUCTS.items() if square else ():
        if all(one.is_found(product(one.J, one.K)) for one in both):
            yield (Slip((), words, "", "", ORDER),)


# In K


def _in_errors(both: Both) -> Iterator[tuple[Slip, ...]]:
    """What K would have to be follows from J, where that is square."""
    here, there = both
    if here.J.shape[1] != here.J.shape[2] or not np.isfinite(here.needed_errors).all():
        return
    off = np.abs(here.needed_errors - here.K) > max(OTHER, here.share_of_errors) * here.scales_of_errors
    wrong = [index for index in indices(here.K.shape[1:]) if _entry(off, index).any()]
    if wrong and not _is_one_of_all(wrong, here):
        yield from _exchanged_errors(wrong, here)
        flat, flat_there = (one.needed_errors.reshape(len(one.K), -1) for one in both)
        search = SlipSearch(here.errors, flat, there.errors, flat_there, here.share_of_errors)
        yield _slips_of(search, wrong, here.K.shape[1:], "K")


def _is_one_of_all(wrong: Sequence[Index], product: MatrixProduct) -> bool:
    """Whether so many entries are wrong that they tell no more than those of the covariance."""
    pairs = {tuple(sorted(index)) for index in wrong}
    every = {tuple(sorted(index)) for index in indices(product.K.shape[1:]) if _entry(product.K, index).any()}
    return len(pairs) > MOST or (len(pairs) > 1 and not every - pairs and not _exchange(wrong, product))


def _exchanged_errors(wrong: Sequence[Index], product: MatrixProduct) -> Iterator[tuple[Slip, ...]]:
    if (exchange := _exchange(wrong, product)) is not None:
        yield (Slip((), f"in J K J^T, K's {place(*exchange)}exchanged", "", "", EXCHANGED),)


def _exchange(wrong: Sequence[Index], product: MatrixProduct) -> tuple[Index, Index] | None:
    """Two entries of the diagonal that stand in each other's places."""
    if len(wrong) != 2 or any(i != j for i, j in wrong):
        return None
    first, second = wrong
    pairs = ((first, second), (second, first))
    away = (_entry(product.needed_errors, one) - _entry(product.K, other) for one, other in pairs)
    allowed = max(OTHER, product.share_of_errors) * product.scales_of_errors.max(axis=(1, 2))
    return (first, second) if all((np.abs(one) <= allowed).all() for one in away) else None


def _entry(matrices: npt.NDArray[Any], index: Index) -> npt.NDArray[Any]:
    """One entry of each matrix."""
    return np.asarray(matrices[:, index[0], index[1]])


# In J


def _in_one_entry(both: Both) -> Iterator[tuple[Slip, ...]]:
    for row, column in indices(both[0].J.shape[1:]):
        yield _slips_in_jacobian(both, {row: column})


def _in_two_rows(both: Both) -> Iterator[tuple[Slip, ...]]:
    """One entry in each of two rows, where others are left from which they follow."""
    rows, columns = both[0].J.shape[1:]
    for first, second in combinations(range(rows), 2) if rows > 2 else ():
        for column in range(columns):
            for other in range(columns):
                yield _slips_in_jacobian(both, {first: column, second: other})


def _slips_in_jacobian(both: Both, places: dict[int, int]) -> tuple[Slip, ...]:
    """Slips in one entry of each of some rows; none where no values there make the covariance what it is."""
    here, there = both
    if (needed := _needed(here, places)) is None or (needed_there := _needed(there, places)) is None:
        return ()
    flat, flat_there = (one.reshape(len(one), -1) for one in (needed, needed_there))
    share = here.share * MOVED  # as the entry of J follows from a small part of the covariance
    search = SlipSearch(here.jacobian, flat, there.jacobian, flat_there, share)
    return _slips_of(search, list(places.items()), here.J.shape[1:], "the Jacobian")


def _needed(product: MatrixProduct, places: dict[int, int]) -> Array | None:
    """J with entries as they have to be for what the function has; None where none make it so.

    The entries of its row of the covariance, beside columns of other such rows, are linear in each.
    """
    J, K = product.J.copy(), product.K
    others = [row for row in range(J.shape[1]) if row not in places]
    for row, column in places.items():
        slopes, away = (K @ product.J.mT)[:, column, others], product.off[:, row, others]
        with np.errstate(all="ignore"):
            J[:, row, column] += (away * slopes).sum(axis=1) / (slopes**2).sum(axis=1)
    return J if np.isfinite(J).all() and product.is_found(J @ K @ J.mT) else None


def _slips_of(search: SlipSearch, wrong: Sequence[Index], shape: Index, matrix: str) -> tuple[Slip, ...]:
    """A slip for each entry of a matrix that is wrong; none where one is left."""
    found = [search.slip(row * shape[1] + column) for row, column in wrong]
    told = merged([replace(slip, entries=(index,)) for slip, index in zip(found, wrong, strict=True) if slip])
    if None in found:
        return ()
    return tuple(
        replace(slip, entries=(), edit=f"in J K J^T, {matrix}'s {place(*slip.entries)}{slip.edit}") for slip in told
    )
