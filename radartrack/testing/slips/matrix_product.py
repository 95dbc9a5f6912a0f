"""A covariance that is computed as J K Jᵀ, at points: what its matrices are, and what they would have to be."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from radartrack.derive import symbolic as sp
from radartrack.derive.catalogue import family
from radartrack.derive.language.quantity import Quantity
from radartrack.derive.language.tensor import Tensor, indices
from radartrack.derive.symbolic import Expr
from radartrack.testing.calling.called_function import Array
from radartrack.testing.wanted import Expected, Wanted

LINEAR, JACOBIAN = ".covariance.linear", ".jacobian"
SAME, CLEARLY = 1e-9, 1e-3  # of the largest entry, and of what the function is off by
FEW = 4.0  # times which what has few digits may be off
ROUGHLY = 0.03  # likewise of what has few digits
ROUNDING = 2.0**-50  # of the terms of a product
TELLING = 1e-8  # of the scale of an entry of K: what is less is none; where rounding makes more, nothing follows


@dataclass(frozen=True, eq=False)
class MatrixProduct:
    """A covariance at some points, as J K Jᵀ.

    Attributes:
        expected: the exact covariance.
        found: what the function has, shape (points, rows, rows).
        jacobian: the exact J there.
        errors: the exact K there, the covariance of the errors.
        J: its values, shape (points, rows, columns).
        K: likewise, shape (points, columns, columns).
        share: of a value, by which what is found may be off, where that is more than double precision makes.
    """

    expected: Expected
    found: Array
    jacobian: Expected
    errors: Expected
    J: Array
    K: Array
    share: float = 0.0

    @property
    def off(self) -> Array:
        """The function less what is exact."""
        return self.found - self.expected.values.reshape(self.found.shape)

    def is_found(self, other: Array) -> bool:
        """Whether the function has this in place of the covariance, and is not as near to that itself."""
        size = np.abs(self.found).max(axis=(1, 2), keepdims=True)
        with np.errstate(all="ignore"):
            away, off = np.abs(self.found - other), np.abs(self.off).max()
            near = (away <= max(SAME, FEW * self.share) * size).all()
            return bool(near and away.max() <= max(CLEARLY, ROUGHLY * (self.share > 0)) * off)

    @cached_property
    def needed_errors(self) -> Array:
        """What K would have to be, J⁻¹ C J⁻ᵀ; no number where rounding leaves nothing of it.

        Shape (points, columns, columns).
        """
        with np.errstate(all="ignore"):
            found = self._inverse @ self.found @ self._inverse.mT
            nothing = np.maximum(self._rounding, TELLING * self.scales_of_errors)
            found = np.where(np.abs(found) <= nothing, 0.0, found)
            return np.where(self._rounding <= self._least * self.scales_of_errors, found, np.nan)

    @property
    def share_of_errors(self) -> float:
        """Of an entry of K, by which it may be off then, where the function has few digits."""
        return float((self._rounding / self.scales_of_errors).max()) if self.share else 0.0

    @property
    def _least(self) -> float:
        return ROUGHLY if self.share else TELLING

    @cached_property
    def _inverse(self) -> Array:
        return np.asarray(np.linalg.inv(self.J))

    @cached_property
    def _rounding(self) -> Array:
        """By how much rounding may move an entry of K."""
        sizes = np.abs(self._inverse)
        return np.asarray(max(ROUNDING, self.share) * (sizes @ np.abs(self.found) @ sizes.mT))

    @cached_property
    def scales_of_errors(self) -> Array:
        """What entries of K are measured against: the deviations that they join, or would have to."""
        with np.errstate(all="ignore"):
            needed = self._inverse @ self.found @ self._inverse.mT
            largest = np.fmax(np.diagonal(self.K, axis1=1, axis2=2), np.diagonal(needed, axis1=1, axis2=2))
        deviations = np.sqrt(largest)
        return np.asarray(deviations[:, :, np.newaxis] * deviations[:, np.newaxis, :])


def matrix_product(expected: Expected, found: Array, share: float = 0.0) -> MatrixProduct | None:
    """The covariance as a product; None for what is none.

    Args:
        expected: points, and what the function should have there.
        found: what it has, shape (points, entries).
        share: of a value, by which that may be off, where that is more than double precision makes.
    """
    quantities = _matrices_of(expected.wanted)
    if quantities is None or not np.isfinite(found).all():
        return None
    jacobian, errors = (_at(expected, one) for one in quantities)
    if min(jacobian.count, errors.count) < expected.count:
        return None
    rows = expected.wanted.shape[0]
    J, K = map(_matrices, (jacobian, errors))
    return MatrixProduct(expected, found.reshape(-1, rows, rows), jacobian, errors, J, K, share)


def _matrices(expected: Expected) -> Array:
    return expected.values.reshape(-1, *expected.wanted.shape)


def _at(expected: Expected, quantity: Quantity) -> Expected:
    names = [symbol.name for symbol in quantity.symbols]
    given = {name: value for name, value in expected.wanted.given.items() if name in names}
    wanted = Wanted(quantity, tuple(indices(quantity.shape)), quantity.shape, given)
    return wanted.at({name: expected.points[name] for name in names if name not in given})


def _matrices_of(wanted: Wanted) -> tuple[Quantity, Quantity] | None:
    """J and K of a whole linear covariance of a conversion."""
    quantity = wanted.quantity
    if quantity.model is None or not quantity.name.endswith(LINEAR) or wanted.shape != quantity.shape:
        return None
    name = quantity.name.removesuffix(LINEAR) + JACOBIAN
    jacobian = next((one for one in family(quantity) if one.name == name), None)
    return None if jacobian is None else (jacobian, _errors(quantity, jacobian))


def _errors(quantity: Quantity, jacobian: Quantity) -> Quantity:
    """The covariance matrix of what is measured, as a quantity."""
    model = quantity.model
    assert model is not None  # noqa: S101 - asked before

    def derivation() -> Tensor[Expr]:
        size = len(model.measured)
        table: dict[tuple[int, ...], Expr] = dict.fromkeys(indices((size, size)), sp.Integer(0))
        table |= {(place, place): sigma**2 for place, sigma in enumerate(model.deviations)}
        for pair, rho in model.correlations.items():
            i, j = map(model.measured.index, pair)
            table[i, j] = table[j, i] = rho * model.deviations[i] * model.deviations[j]
        return Tensor((size, size), tuple(table.values()))

    axis = tuple(unit**-1 for unit in jacobian.axes[1])
    symbols = (*model.deviations, *model.correlations.values())  # an error that depends on the range is no slip in K
    return replace(quantity, axes=(axis, axis), symbols=symbols, derivation=derivation, scale=None)
