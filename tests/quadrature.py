"""Expectations over Gaussian errors by Gauss-Hermite quadrature, straight from their definition."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

Point = Mapping[str, np.ndarray | float]
Function = Callable[[Point], np.ndarray]
BLOCK = 64


@dataclass(frozen=True)
class Gaussian:
    """Nodes and weights that stand for errors w ~ N(0, K) of the named quantities."""

    offsets: Mapping[str, np.ndarray]
    weights: np.ndarray

    @classmethod
    def of(cls, names: Sequence[str], covariance: np.ndarray, orders: Mapping[str, int]) -> "Gaussian":
        """A product rule along the axes of a Cholesky factor that begins with the highest order.

        So what is correlated with an angle takes part in the angle's many nodes, and a quantity on which
        functions depend as polynomials of a low degree needs few of its own.
        """
        ranked = sorted(range(len(names)), key=lambda i: -orders[names[i]])
        factor = np.linalg.cholesky(covariance[np.ix_(ranked, ranked)])
        rules = [np.polynomial.hermite_e.hermegauss(orders[names[i]]) for i in ranked]
        grid = np.stack(np.meshgrid(*(nodes for nodes, _ in rules), indexing="ij"), axis=-1)
        weights = np.stack(np.meshgrid(*(weights for _, weights in rules), indexing="ij"), axis=-1).prod(axis=-1)
        errors = grid.reshape(-1, len(names)) @ factor.T
        offsets = {names[i]: errors[:, position] for position, i in enumerate(ranked)}
        return cls(offsets, weights.ravel() / weights.sum())

    def expectation(self, function: Function, point: Point, sign: int = 1) -> np.ndarray:
        """E[f(point + sign·w)]; the function takes arrays and adds the axes of its value after theirs."""
        shape = np.broadcast_shapes(*(np.shape(point[name]) for name in self.offsets))
        column = (-1, *[1] * len(shape))
        total: np.ndarray | float = 0.0
        for start in range(0, len(self.weights), BLOCK):
            part = slice(start, start + BLOCK)
            moved = {name: point[name] + sign * w[part].reshape(column) for name, w in self.offsets.items()}
            total = total + np.tensordot(self.weights[part], function({**point, **moved}), axes=(0, 0))
        return np.asarray(total)

    def covariance(self, function: Function, point: Point, sign: int = 1) -> np.ndarray:
        """Cov[f(point + sign·w)]."""
        mean = self.expectation(function, point, sign)
        return self.expectation(lambda moved: square(function(moved) - mean), point, sign)


def square(vectors: np.ndarray) -> np.ndarray:
    """v vᵀ along new last axes."""
    return vectors[..., :, np.newaxis] * vectors[..., np.newaxis, :]
