"""Weights of least variance as solutions of the linear system that a constrained minimum solves, in many digits."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

import mpmath

from radartrack.derive.language.tensor import Tensor

METHOD = "the linear system of the constrained minimum"
Number = Any
Matrix = Any
At = Mapping[str, Number]


def constrained_minimum(covariances: Sequence[Matrix]) -> list[Matrix]:
    """The matrices W_j that sum to one and make tr Σ W_j P_j W_jᵀ least: 2 W_j P_j = M, with multipliers M.

    One system of linear equations for all of them, transposed: diag(2 P_1, 2 P_2, …) under their sum.
    """
    size, count = covariances[0].rows, len(covariances)
    whole = mpmath.matrix((count + 1) * size, (count + 1) * size)
    right = mpmath.matrix((count + 1) * size, size)
    for j, covariance in enumerate(covariances):
        for m in range(size):
            for n in range(size):
                whole[j * size + m, j * size + n] = 2 * covariance[m, n]
            whole[j * size + m, count * size + m] = mpmath.mpf(-1)
            whole[count * size + m, j * size + m] = mpmath.mpf(1)
    for m in range(size):
        right[count * size + m, m] = mpmath.mpf(1)
    columns = [mpmath.lu_solve(whole, right[:, m]) for m in range(size)]
    return [_gathered(columns, j * size, size) for j in range(count)]


def _gathered(columns: Sequence[Matrix], start: int, size: int) -> Matrix:
    """One weight from the solutions, each of which is a row of it."""
    return mpmath.matrix([[columns[m][start + n] for n in range(size)] for m in range(size)])


def _scalars(deviations: Sequence[Number]) -> list[Number]:
    return [w[0, 0] for w in constrained_minimum([mpmath.matrix([[one**2]]) for one in deviations])]


def _weights(at: At) -> Tensor[Number]:
    return Tensor((len(at),), tuple(_scalars(list(at.values()))))


def _variance(at: At) -> Tensor[Number]:
    deviations = list(at.values())
    pairs = zip(_scalars(deviations), deviations, strict=True)
    return Tensor((), (mpmath.fsum((weight * one) ** 2 for weight, one in pairs),))


def _weight(at: At) -> Tensor[Number]:
    """All other measurements as one."""
    others = at["information"] - 1 / at["sigma_1"] ** 2
    return Tensor((), (_scalars([at["sigma_1"], 1 / mpmath.sqrt(others)])[0],))


def _matrix_weights(at: At) -> Tensor[Number]:
    first = constrained_minimum([_plane_covariance(at, number) for number in (1, 2)])[0]
    return Tensor.build((2, 2), lambda m, n: first[m, n])


def _plane_covariance(at: At, number: int) -> Matrix:
    x, y, rho = (at[f"{name}{number}"] for name in ("sigma_x", "sigma_y", "rho_"))
    return mpmath.matrix([[x**2, rho * x * y], [rho * x * y, y**2]])


def _correlated(at: At) -> tuple[Matrix, Matrix]:
    """The joint covariance of two errors, and the weights: its inverse times ones, scaled to the sum of one."""
    one, two = at["sigma_1"], at["sigma_2"]
    joint = mpmath.matrix([[one**2, at["rho_12"] * one * two], [at["rho_12"] * one * two, two**2]])
    weights = mpmath.lu_solve(joint, mpmath.matrix([1, 1]))
    return joint, weights / (weights[0] + weights[1])


def _correlated_weights(at: At) -> Tensor[Number]:
    _, weights = _correlated(at)
    return Tensor((2,), (weights[0], weights[1]))


def _correlated_variance(at: At) -> Tensor[Number]:
    joint, weights = _correlated(at)
    return Tensor((), ((weights.T * joint * weights)[0, 0],))


def _intersection(at: At) -> Tensor[Number]:
    first, second = (mpmath.inverse(_plane_covariance(at, number)) for number in (1, 2))
    found = mpmath.inverse(at["weight"] * first + (1 - at["weight"]) * second)
    return Tensor.build((2, 2), lambda m, n: found[m, n])


DERIVATIONS: dict[str, Callable[[At], Tensor[Number]]] = {
    "fusion.weights.two": _weights,
    "fusion.variance.two": _variance,
    "fusion.weights.three": _weights,
    "fusion.variance.three": _variance,
    "fusion.weight": _weight,
    "fusion.matrix_weights.two": _matrix_weights,
    "fusion.correlated.weights": _correlated_weights,
    "fusion.correlated.variance": _correlated_variance,
    "fusion.covariance_intersection.covariance": _intersection,
}
