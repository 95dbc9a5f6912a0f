"""Other things than a quantity that functions return of it: its inverse, a root, deviations and correlations."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from functools import partial
from typing import Any

import numpy as np
import numpy.typing as npt

from radartrack.derive import symbolic as sp
from radartrack.derive.language.tensor import Index, Tensor
from radartrack.derive.symbolic import Expr
from radartrack.testing.calling.called_function import Array, as_array
from radartrack.testing.wanted import Wanted

Undone = Callable[[Array], Array]
TRIANGULAR = 1e-12  # of the largest entry, for what is zero in a triangular matrix


@dataclass(frozen=True)
class ReturnedForm:
    """What a function may return in place of a quantity.

    Attributes:
        words: of the result.
        wanted: what is left of the quantity then.
        undone: makes that of a result.
    """

    words: str
    wanted: Wanted
    undone: Undone

    def of(self, function: Callable[..., Any]) -> Callable[..., Any]:
        """The function as one that returns what is wanted."""

        def undone(*arguments: Any, **named: Any) -> Any:
            result = as_array(function(*arguments, **named))
            return result if result is None else self.undone(result)

        for name in ("argtypes", "nin", "__signature__"):
            if hasattr(function, name):
                setattr(undone, name, getattr(function, name))
        undone.__wrapped__ = function  # type: ignore[attr-defined]
        return undone


def remembered(function: Callable[..., Any]) -> Callable[..., Any]:
    """The function, which is called once with the same numbers and vectors: all forms are tried of one result."""
    known: dict[Any, Any] = {}

    def remembering(*arguments: Any, **named: Any) -> Any:
        values = (*arguments, *named.items())
        if not all(isinstance(value, float | np.ndarray) for value in (*arguments, *named.values())):
            return function(*arguments, **named)
        key = tuple((value.shape, value.tobytes()) if isinstance(value, np.ndarray) else value for value in values)
        if key not in known:
            known[key] = function(*arguments, **named)
        return known[key]

    for name in ("argtypes", "nin", "__signature__"):
        if hasattr(function, name):
            setattr(remembering, name, getattr(function, name))
    remembering.__wrapped__ = function  # type: ignore[attr-defined]
    return remembering


def returned_forms(wanted: Wanted) -> Iterator[ReturnedForm]:
    """Those that a quantity allows, the likeliest first."""
    shape = wanted.shape
    if len(shape) == 2 and shape[0] != shape[1]:
        yield ReturnedForm("the result transposed", wanted, partial(_transposed, shape))
    if len(shape) == 2 and wanted.quantity.is_covariance:
        yield from _of_a_covariance(wanted)
    if len(shape) < 2:
        yield ReturnedForm("the square root of the result (a deviation for a variance)", wanted, _of_one_sign)
        yield ReturnedForm("the result squared (a variance for a deviation)", wanted, np.sqrt)
        yield ReturnedForm("the reciprocal of the result", wanted, np.reciprocal)


def _of_a_covariance(wanted: Wanted) -> Iterator[ReturnedForm]:
    size = wanted.shape[0]
    places = [wanted.places[place * (size + 1)] for place in range(size)]
    diagonal = Wanted(wanted.quantity, tuple(places), (size,), wanted.given)
    yield ReturnedForm("the diagonal of the result alone", diagonal, _itself)
    yield ReturnedForm("deviations alone, the square roots of the diagonal", diagonal, _of_one_sign)
    yield ReturnedForm("the result inverted (the information matrix)", wanted, _inverse)
    if size == 1:
        return
    yield ReturnedForm("the lower Cholesky factor of the result", wanted, partial(_product, np.triu))
    yield ReturnedForm("the upper Cholesky factor of the result", wanted, partial(_product, np.tril))
    yield ReturnedForm("the square root of the result as a matrix", wanted, _square)
    yield ReturnedForm("deviations on the diagonal and correlations beside it", wanted, _of_deviations)
    if all(wanted.quantity.expression[place, place] for place in range(size)):  # what has no error correlates with none
        yield ReturnedForm("the result as a correlation matrix", _correlations(wanted), _itself)


def _correlations(wanted: Wanted) -> Wanted:
    """The correlation matrix of a covariance."""

    def derivation() -> Tensor[Expr]:
        table = dict(wanted.quantity.expression.items())
        entries = (
            entry / sp.sqrt(table[i, i] * table[j, j]) if i != j else sp.Integer(1) for (i, j), entry in table.items()
        )
        return Tensor(wanted.quantity.shape, tuple(entries))

    return replace(wanted, quantity=replace(wanted.quantity, derivation=derivation, scale=_ones(wanted.quantity.shape)))


def _ones(shape: Index) -> Callable[[], Tensor[Expr]]:
    return lambda: Tensor(shape, tuple(sp.Integer(1) for _ in range(int(np.prod(shape)))))


def _itself(found: Array) -> Array:
    return found


def _transposed(shape: Index, found: Array) -> Array:
    """From rows for columns, or from a list column by column."""
    if found.size != shape[0] * shape[1] or found.shape == shape:
        raise ValueError("the result is not transposed")
    return found.reshape(shape[::-1]).T


def _of_one_sign(found: Array) -> Array:
    """The square of roots, all of which are positive."""
    return np.where((found >= 0).all(), found * found, np.nan)


def _inverse(found: Array) -> Array:
    return np.asarray(np.linalg.inv(found))


def _product(beyond: Callable[..., npt.NDArray[Any]], found: Array) -> Array:
    """The square of a triangular factor: L Lᵀ of a lower, Uᵀ U of an upper one."""
    is_lower = beyond is np.triu
    if np.abs(beyond(found, 1 if is_lower else -1)).max() > TRIANGULAR * np.abs(found).max():
        raise ValueError("the result is not triangular")
    return np.asarray(found @ found.T if is_lower else found.T @ found)


def _square(found: Array) -> Array:
    return np.asarray(found @ found)


def _of_deviations(found: Array) -> Array:
    deviations = np.diagonal(found)
    correlations = found - np.diag(deviations) + np.eye(len(found))
    return np.asarray(correlations * np.outer(deviations, deviations))
