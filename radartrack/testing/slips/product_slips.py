"""A slip in J of a covariance J K Jᵀ, told where it was made: in the covariance it shows in a row and a column.

What one entry of J would have to be follows, at each point, from what the covariance is there. Then that entry is a
function of its own, whose slip is looked for.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace

import numpy as np

from radartrack.derive.catalogue import family
from radartrack.derive.language.quantity import Quantity
from radartrack.derive.language.tensor import indices
from radartrack.testing.calling.called_function import Array
from radartrack.testing.diagnosis import Slip
from radartrack.testing.slips.function_slips import SlipSearch
from radartrack.testing.wanted import Expected, Wanted

LINEAR, JACOBIAN = ".covariance.linear", ".jacobian"
SAME, CLEARLY = 1e-9, 1e-3  # of the largest entry, and of what the function is off by
ORDER = 1.5  # the cost of matrices multiplied in another order
OTHER_PRODUCTS: dict[str, Callable[[Array, Array], Array]] = {
    "J^T K J": lambda J, K: J.mT @ K @ J,
    "J K J": lambda J, K: J @ K @ J,
    "J^T K J^T": lambda J, K: J.mT @ K @ J.mT,
}


@dataclass(frozen=True)
class _Product:
    """A covariance at some points, as J K Jᵀ.

    Attributes:
        expected: the exact covariance.
        found: what the function has, shape (points, rows, rows).
        jacobian: the exact J there.
        J: its values, shape (points, rows, columns).
        K: the covariance of the errors, shape (points, columns, columns).
    """

    expected: Expected
    found: Array
    jacobian: Expected
    J: Array
    K: Array

    def is_found(self, other: Array) -> bool:
        """Whether the function has this in place of the covariance, and is not as near to that itself."""
        exact = self.expected.values.reshape(self.found.shape)
        size = np.abs(self.found).max(axis=(1, 2), keepdims=True)
        with np.errstate(all="ignore"):
            away = np.abs(self.found - other)
            return bool((away <= SAME * size).all() and away.max() <= CLEARLY * np.abs(self.found - exact).max())

    def needed(self, row: int, column: int) -> Array | None:
        """J with one entry as it has to be for what the function has; None where none makes it so.

        The other entries of its row of the covariance are linear in it.
        """
        others = [other for other in range(len(self.J[0])) if other != row]
        slopes = (self.K @ self.J.mT)[:, column, others]
        away = self.found[:, row, others] - self.expected.values.reshape(self.found.shape)[:, row, others]
        with np.errstate(all="ignore"):
            J = self.J.copy()
            J[:, row, column] += (away * slopes).sum(axis=1) / (slopes**2).sum(axis=1)
        return J if np.isfinite(J).all() and self.is_found(J @ self.K @ J.mT) else None


def product_slip(screening: Expected, found: Array, confirming: Expected, found_there: Array) -> Slip | None:
    """A slip in J, or in the order of the product J K Jᵀ; None without any, and for what is no such product.

    Args:
        screening: points of ordinary size.
        found: what the function has there, shape (points, entries).
        confirming: points in all directions.
        found_there: likewise.
    """
    jacobian = _jacobian(screening.wanted)
    if jacobian is None or not (np.isfinite(found).all() and np.isfinite(found_there).all()):
        return None
    here, there = _product(screening, found, jacobian), _product(confirming, found_there, jacobian)
    if here is None or there is None:
        return None
    return next(_other_products(here, there), None) or next(_slips_of_entries(here, there), None)


def _other_products(here: _Product, there: _Product) -> Iterator[Slip]:
    square = here.J.shape[1] == here.J.shape[2]
    for words, product in OTHER_PRODUCTS.items() if square else ():
        if all(one.is_found(product(one.J, one.K)) for one in (here, there)):
            yield Slip((), f"{words} for J K J^T", "", "", ORDER)


def _slips_of_entries(here: _Product, there: _Product) -> Iterator[Slip]:
    for row, column in indices(here.J.shape[1:]):
        needed, needed_there = here.needed(row, column), there.needed(row, column)
        if needed is None or needed_there is None:
            continue
        flat, flat_there = (one.reshape(len(one), -1) for one in (needed, needed_there))
        slip = SlipSearch(here.jacobian, flat, there.jacobian, flat_there).slip(row * here.J.shape[2] + column)
        if slip is not None:
            yield replace(slip, entries=(), edit=f"in J K J^T, the Jacobian's entry [{row}, {column}]: {slip.edit}")


def _jacobian(wanted: Wanted) -> Quantity | None:
    """The Jacobian of a whole linear covariance of a conversion."""
    quantity = wanted.quantity
    if quantity.model is None or not quantity.name.endswith(LINEAR) or wanted.shape != quantity.shape:
        return None
    name = quantity.name.removesuffix(LINEAR) + JACOBIAN
    return next((one for one in family(quantity) if one.name == name), None)


def _product(expected: Expected, found: Array, jacobian: Quantity) -> _Product | None:
    names = [symbol.name for symbol in jacobian.symbols]
    wanted = Wanted(jacobian, tuple(indices(jacobian.shape)), jacobian.shape, {})
    exact = wanted.at({name: expected.points[name] for name in names})
    if exact.count < expected.count:
        return None
    rows = expected.wanted.shape[0]
    J = exact.values.reshape(-1, *jacobian.shape)
    return _Product(expected, found.reshape(-1, rows, rows), exact, J, _errors(expected))


def _errors(expected: Expected) -> Array:
    """The covariance matrix of the errors at each point."""
    model = expected.wanted.quantity.model
    assert model is not None  # noqa: S101 - asked before
    deviations = np.stack([expected.points[sigma.name] for sigma in model.deviations], axis=-1)
    correlations = np.zeros((len(deviations), deviations.shape[1], deviations.shape[1])) + np.eye(deviations.shape[1])
    for (first, second), rho in model.correlations.items():
        i, j = model.measured.index(first), model.measured.index(second)
        correlations[:, i, j] = correlations[:, j, i] = expected.points[rho.name]
    return np.asarray(correlations * deviations[:, :, np.newaxis] * deviations[:, np.newaxis, :])
