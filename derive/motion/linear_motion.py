"""Linear motions from their differential equations, as they are seen from scan to scan.

The state moves by x' = A x + G w, with as many independent noises w as G has columns. Exact discretisation gives
F(T) = e^(AT). Where the noises are white, of intensity q, the process noise has the covariance
Q(T) = q ∫₀ᵀ e^(As) G Gᵀ e^(As)ᵀ ds; where each is constant over a period, of deviation σ_w, it is σ_w² Γ Γᵀ with
Γ = ∫₀ᵀ e^(As) G ds; where they are jumps of the state at a scan, σ_w² F G (F G)ᵀ.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

from radartrack.derive import symbolic as sp
from radartrack.derive.language.matrix import ONE, ZERO, Matrix, Vector, outer
from radartrack.derive.language.shared_symbols import T
from radartrack.derive.language.tensor import Tensor
from radartrack.derive.symbolic import Expr
from radartrack.derive.verbs.integrals import integrated
from radartrack.derive.verbs.matrix_exponential import exponential


@dataclass(frozen=True)
class LinearMotion:
    """x' = A x + G w.

    Attributes:
        drift: A.
        driven: the components that a noise drives; each has its own.
        rate: what A is made of, 1 where it is made of numbers.
    """

    drift: Matrix
    driven: tuple[int, ...]
    rate: Expr = ONE

    @cached_property
    def transition(self) -> Tensor[Expr]:
        """F."""
        return _tensor(exponential(tuple(tuple(entry * T for entry in row) for row in self.drift)))

    @cached_property
    def jumps(self) -> tuple[Vector, ...]:
        """The columns of F G: what is left at the next scan of a jump of each driven component."""
        size = len(self.drift)
        return tuple(tuple(self.transition[m, n] for m in range(size)) for n in self.driven)

    @cached_property
    def shifts(self) -> tuple[Vector, ...]:
        """The columns of Γ: what a constant noise of 1 adds over a period."""
        return tuple(tuple(map(self._integral, column)) for column in self.jumps)

    def continuous_noise(self, intensity: Expr) -> Tensor[Expr]:
        """Q for white noises of this intensity."""
        return _total([tuple(tuple(map(self._integral, row)) for row in outer(c, c)) for c in self.jumps], intensity)

    def piecewise_noise(self, deviation: Expr) -> Tensor[Expr]:
        """Q for noises of this deviation that are constant over a period."""
        return noise_of(self.shifts, deviation)

    def jump_noise(self, deviation: Expr) -> Tensor[Expr]:
        """Q for jumps of this deviation at each scan."""
        return noise_of(self.jumps, deviation)

    def _integral(self, function: Expr) -> Expr:
        """From 0 to T, of a polynomial, exponentials and sines over powers of the rate."""
        over = self.rate ** (2 * len(self.drift))
        scaled = sp.expand(sp.expand(function) * over)
        return sp.expand(integrated(scaled, T, ZERO, T) / over)


def noise_of(columns: Sequence[Vector], deviation: Expr) -> Tensor[Expr]:
    """The covariance of the sum of columns, each times a number of its own of this deviation."""
    return _total([outer(column, column) for column in columns], deviation**2)


def _total(parts: Sequence[Matrix], factor: Expr) -> Tensor[Expr]:
    size = len(parts[0])
    return Tensor.build((size, size), lambda m, n: factor * sp.Add(*(part[m][n] for part in parts)))


def _tensor(matrix: Matrix) -> Tensor[Expr]:
    return Tensor.build((len(matrix), len(matrix)), lambda m, n: matrix[m][n])
