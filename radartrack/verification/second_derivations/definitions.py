"""What each quantity of a measurement model means, as expectations over errors; no closed form and no operator.

θ is the true value, w ~ N(0, K) its measurement error, z = θ + w. A measurement-conditioned quantity averages over
θ = z − w, a prediction-conditioned one over θ = θₚ − wₚ; both errors are symmetric, so the sign does not matter.
The same definitions serve exact algebra, power series and quadrature.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, Protocol, Self, TypeVar

from radartrack.derive.language.tensor import Tensor


class Value(Protocol):
    """A function of the measured quantities."""

    def __add__(self, other: Self, /) -> Self: ...
    def __sub__(self, other: Self, /) -> Self: ...
    def __mul__(self, other: Self, /) -> Self: ...


V = TypeVar("V", bound=Value)


class Expectations(Protocol[V]):
    """The map of a model, its unbiased estimate, and averages over the errors."""

    @property
    def h(self) -> Sequence[V]:
        """The coordinates, as functions of the true values."""
        ...

    @property
    def u(self) -> Sequence[V]:
        """The estimate with E[u(θ + w)] = h(θ), as functions of the measurement."""
        ...

    def noise(self, value: V) -> V:
        """θ ↦ E[f(θ + w)]."""
        ...

    def prediction(self, value: V) -> V:
        """θₚ ↦ E[f(θₚ − wₚ)]."""
        ...


def _bias(of: Expectations[V]) -> list[V]:
    return [of.noise(h) - h for h in of.h]


def _averaged_bias(of: Expectations[V]) -> list[V]:
    return [of.noise(bias) for bias in _bias(of)]


def _estimate(of: Expectations[V]) -> list[V]:
    return list(of.u)


def _posterior(of: Expectations[V]) -> list[V]:
    return [of.noise(h) for h in of.h]


def _covariance(of: Expectations[V], a: int, b: int) -> V:
    return of.noise(of.h[a] * of.h[b]) - of.noise(of.h[a]) * of.noise(of.h[b])


def _averaged_covariance(of: Expectations[V], a: int, b: int) -> V:
    return of.noise(_covariance(of, a, b))


def _error_of_estimate(of: Expectations[V], a: int, b: int) -> V:
    """E[(u_a(z) − h_a(z − w)) (u_b(z) − h_b(z − w))], with u held fixed."""
    h, u = of.h, of.u
    return of.noise(h[a] * h[b]) - of.noise(h[a]) * u[b] - u[a] * of.noise(h[b]) + u[a] * u[b]


def _error_over_prediction(of: Expectations[V], a: int, b: int) -> V:
    """The average over θ = θₚ − wₚ of E[(u_a(θ + w) − h_a(θ)) (u_b(θ + w) − h_b(θ))]."""
    return of.prediction(_about_truth(of, a, b))


def _about_truth(of: Expectations[V], a: int, b: int) -> V:
    """E[(u_a(θ + w) − h_a(θ)) (u_b(θ + w) − h_b(θ))]."""
    h, u = of.h, of.u
    return of.noise(u[a] * u[b]) - of.noise(u[a]) * h[b] - h[a] * of.noise(u[b]) + h[a] * h[b]


def _about_truth_averaged(of: Expectations[V], a: int, b: int) -> V:
    return of.noise(_about_truth(of, a, b))


Vector = Callable[[Any], list[Any]]
Matrix = Callable[[Any, int, int], Any]
VECTORS: dict[str, Vector] = {
    "bias.truth": _bias,
    "bias.averaged": _averaged_bias,
    "unbiased.estimate": _estimate,
    "posterior.estimate": _posterior,
}
MATRICES: dict[str, Matrix] = {
    "covariance.truth": _covariance,
    "covariance.averaged": _averaged_covariance,
    "unbiased.covariance": _error_of_estimate,
    "posterior.covariance": _covariance,
    "decorrelated.covariance": _error_over_prediction,
    "unbiased.covariance.truth": _about_truth,
    "unbiased.covariance.averaged": _about_truth_averaged,
}
ROWS = VECTORS.keys() | MATRICES.keys()


def defined(row: str, of: Expectations[V]) -> Tensor[V]:
    """The quantity of this row, by its definition."""
    size = len(of.h)
    if row in VECTORS:
        return Tensor((size,), tuple(VECTORS[row](of)))
    upper = {(a, b): MATRICES[row](of, a, b) for a in range(size) for b in range(a, size)}
    return Tensor.build((size, size), lambda a, b: upper[min(a, b), max(a, b)])
