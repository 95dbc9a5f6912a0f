"""The table of words: everything the literature on converted measurements computes, as words in one operator.

With h the map to Cartesian coordinates, w ~ N(0, K) the measurement error and L = ½ Σ K_ij ∂_i ∂_j,
E[f(θ + w)] = e^L f (θ). Each word below is a function of a calculus: the map, and the operator e^(tL) either in
closed form (`Closed`) or cut off at a stated order in K (`Truncated`, in `radartrack.derive.moments.truncated_series`).
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from typing import Protocol, Self, TypeVar

from radartrack.derive.language.tensor import Tensor


class Value(Protocol):
    """What words compute with: values that add and multiply."""

    def __add__(self, other: Self, /) -> Self: ...
    def __sub__(self, other: Self, /) -> Self: ...
    def __mul__(self, other: Self, /) -> Self: ...


V = TypeVar("V", bound=Value)


class Calculus(Protocol[V]):
    """A map and the expectations over its Gaussian errors."""

    @property
    def map(self) -> Tensor[V]:
        """H, one value an output."""
        ...

    def expectation(self, value: V, time: Fraction | int = 1) -> V:
        """e^(tL) f over the measurement error; negative times undo it."""
        ...

    def prediction(self, value: V) -> V:
        """e^(Lₚ) f over the error of a prediction."""
        ...


def bias_truth(calculus: Calculus[V]) -> Tensor[V]:
    """(e^L − 1) h: the exact bias of the plain conversion, given the true position."""
    return calculus.map.map(lambda h: calculus.expectation(h) - h)


def bias_averaged(calculus: Calculus[V]) -> Tensor[V]:
    """(e^2L − e^L) h: the truth-conditioned bias averaged over the truth given the measurement."""
    return calculus.map.map(lambda h: calculus.expectation(h, 2) - calculus.expectation(h))


def unbiased_estimate(calculus: Calculus[V]) -> Tensor[V]:
    """e^(−L) h: the estimate whose expectation is the true position."""
    return calculus.map.map(lambda h: calculus.expectation(h, -1))


def posterior_estimate(calculus: Calculus[V]) -> Tensor[V]:
    """e^L h: the posterior mean under a flat prior."""
    return calculus.map.map(calculus.expectation)


def covariance_truth(calculus: Calculus[V]) -> Tensor[V]:
    """C = e^L(h hᵀ) − (e^L h)(e^L h)ᵀ: the covariance of the plain conversion, given the truth."""
    mean = posterior_estimate(calculus)
    return _symmetric(calculus, lambda a, b, h: calculus.expectation(h[a] * h[b]) - mean[a,] * mean[b,])


def covariance_averaged(calculus: Calculus[V]) -> Tensor[V]:
    """e^L C: the truth-conditioned covariance averaged over the truth given the measurement."""
    return covariance_truth(calculus).map(calculus.expectation)


def unbiased_covariance(calculus: Calculus[V]) -> Tensor[V]:
    """u uᵀ − u (e^L h)ᵀ − (e^L h) uᵀ + e^L(h hᵀ): the error covariance of u = e^(−L) h, given the measurement."""
    u, mean = unbiased_estimate(calculus), posterior_estimate(calculus)

    def entry(a: int, b: int, h: list[V]) -> V:
        cross = u[a,] * mean[b,] + mean[a,] * u[b,]
        return u[a,] * u[b,] - cross + calculus.expectation(h[a] * h[b])

    return _symmetric(calculus, entry)


def decorrelated_covariance(calculus: Calculus[V]) -> Tensor[V]:
    """e^(Lₚ)[e^L(u uᵀ) − h hᵀ]: the truth-conditioned covariance of u = e^(−L) h, averaged over a prediction."""
    u = unbiased_estimate(calculus)
    return _symmetric(calculus, lambda a, b, h: calculus.prediction(calculus.expectation(u[a,] * u[b,]) - h[a] * h[b]))


def unbiased_covariance_truth(calculus: Calculus[V]) -> Tensor[V]:
    """e^L(u uᵀ) − h hᵀ: the covariance of u = e^(−L) h, given the truth."""
    u = unbiased_estimate(calculus)
    return _symmetric(calculus, lambda a, b, h: calculus.expectation(u[a,] * u[b,]) - h[a] * h[b])


def unbiased_covariance_averaged(calculus: Calculus[V]) -> Tensor[V]:
    """e^L[e^L(u uᵀ) − h hᵀ]: the same, averaged over the truth given the measurement."""
    return unbiased_covariance_truth(calculus).map(calculus.expectation)


def _symmetric(calculus: Calculus[V], entry: Callable[[int, int, list[V]], V]) -> Tensor[V]:
    outputs = list(calculus.map)
    size = len(outputs)
    upper = {(a, b): entry(a, b, outputs) for a in range(size) for b in range(a, size)}
    return Tensor.build((size, size), lambda a, b: upper[min(a, b), max(a, b)])
