"""The steady state of filters on positions: gains and covariances of α-β and α-β-γ filters by Kalata's tracking index.

A position is measured at each scan, with errors of deviation σ_r. An α-β filter moves at constant velocity, with an
acceleration that is noise, constant over a period; an α-β-γ filter at constant acceleration, which jumps at each scan.
With σ_w the deviation of either, the tracking index is λ = T² σ_w/σ_r, and the steady state of the Kalman filter
depends on nothing else: its gains are α, β/T and γ/T².

With r = √(1 − α), Kalata's relations are β = 2(1 − r)² and γ = β²/(2α). All is rational in w = (1 + r)/(1 − r), and λ
too: 8/λ is w² − 1 for the first filter and w³ − w for the second. So w is a root of a quadratic and of a cubic,
the largest of each, as r is between 0 and 1. Nothing cancels in what is made of w and λ.

That these satisfy the Riccati equation P = F (1 − K H) P Fᵀ + Q is proved as an identity of rational functions of w.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import cached_property

from radartrack.derive import symbolic as sp
from radartrack.derive.algebra.rational_function import is_zero
from radartrack.derive.bibliography import cite
from radartrack.derive.language.matrix import Matrix, outer, product, rows, transposed
from radartrack.derive.language.quantity import Conditioning, Quantity
from radartrack.derive.language.shared_symbols import T
from radartrack.derive.language.stable_form import NotProved, StableForm
from radartrack.derive.language.tensor import Tensor
from radartrack.derive.language.variable import Variable
from radartrack.derive.motion.polynomial_motion import motion, units
from radartrack.derive.symbolic import Expr, Symbol
from radartrack.derive.units import METRE, ONE

SOURCE = cite("kalata1984")
index = Variable("index", "tracking index T^2 sigma_w/sigma_r", ONE, 1e-9, 1e3)
sigma_r = Variable("sigma_r", "standard deviation of the error of a measured position", METRE, 1e-3, 1e4)
w = sp.Symbol("w", positive=True)


@dataclass(frozen=True)
class SteadyState:
    """A filter in its steady state, for T = 1 and σ_r = 1.

    Attributes:
        gain: α, β and so on, over w and the index.
        index: the index, over w.
        root: w, over the index.
        noise: the covariance of the process noise for σ_w = 1, over T.
    """

    gain: tuple[Expr, ...]
    index: Expr
    root: Expr
    noise: Tensor[Expr]

    @property
    def size(self) -> int:
        """The number of components of the state."""
        return len(self.gain)

    @cached_property
    def predicted(self) -> Matrix:
        """The covariance P before a measurement, over w.

        For a known gain P⁺ = (1 − K H) (F P⁺ Fᵀ + Q) is linear, and P⁺ has the first column K.

        Raises:
            NotProved: when this is no solution of the Riccati equation.
        """
        unknown = {(m, n): sp.Symbol(f"p_{m}_{n}", real=True) for m in range(1, self.size) for n in range(m, self.size)}
        filtered = tuple(
            tuple(self.gain[max(m, n)] if min(m, n) == 0 else unknown[min(m, n), max(m, n)] for n in range(self.size))
            for m in range(self.size)
        )
        moved = self._moved(filtered)
        equations = [
            filtered[m][n] - moved[m][n] + self.gain[m] * moved[0][n]
            for m in range(self.size)
            for n in range(self.size)
        ]
        known = solved(equations, list(unknown.values()))
        found = tuple(tuple(sp.factor(entry.xreplace(known)) for entry in row) for row in moved)
        self._prove(found)
        return found

    @cached_property
    def filtered(self) -> Matrix:
        """The covariance P⁺ = (1 − K H) P after a measurement, over w."""
        reduced = outer(self.gain, self.predicted[0])
        return tuple(
            tuple(sp.factor(a - b) for a, b in zip(*pair, strict=True))
            for pair in zip(self.predicted, reduced, strict=True)
        )

    def without_cancellation(self, entry: Expr) -> Expr:
        """An entry with w − 1, which is small where the index is large, by the index.

        Raises:
            NotProved: when that is another function.
        """
        excess = sp.cancel(self.index * (w - 1)) / index
        written = entry.xreplace({1 / (w - 1): 1 / sp.factor(excess)})
        if not is_zero(written.xreplace({index: self.index}) - entry):
            raise NotProved(f"{written} is not {entry}")
        return written

    def _moved(self, filtered: Matrix) -> Matrix:
        """F P⁺ Fᵀ + Q."""
        unit = {T: sp.Integer(1)}
        transition = rows(motion(self.size).transition.map(lambda entry: entry.xreplace(unit)))
        moved = product(transition, product(filtered, transposed(transition)))
        noise = rows(self.noise.map(lambda entry: entry.xreplace(unit) * self.index**2))
        return tuple(tuple(a + b for a, b in zip(*pair, strict=True)) for pair in zip(moved, noise, strict=True))

    def _prove(self, predicted: Matrix) -> None:
        """That the gain is that of P, and that P is what comes of it a scan later."""
        innovation = predicted[0][0] + 1
        reduced = outer(self.gain, predicted[0])
        filtered = tuple(
            tuple(a - b for a, b in zip(*pair, strict=True)) for pair in zip(predicted, reduced, strict=True)
        )
        gains = [k * innovation - p for k, p in zip(self.gain, predicted[0], strict=True)]
        scans = [
            a - b for pair in zip(self._moved(filtered), predicted, strict=True) for a, b in zip(*pair, strict=True)
        ]
        if not all(map(is_zero, (*gains, *scans))):
            raise NotProved("the steady state does not satisfy the Riccati equation")


def solved(equations: list[Expr], unknown: list[Symbol]) -> dict[Symbol, Expr]:
    """The solution of linear equations by elimination; those that are left over are left to the proof."""
    known: dict[Symbol, Expr] = {}
    for symbol in unknown:
        slope, equation = next(
            (slope, equation)
            for slope, equation in ((sp.cancel(sp.diff(equation, symbol)), equation) for equation in equations)
            if slope != 0
        )
        value = sp.cancel(symbol - equation / slope)
        step = {symbol: value}
        known = {other: sp.cancel(found.xreplace(step)) for other, found in known.items()} | step
        equations = [sp.cancel(equation.xreplace(step)) for equation in equations]
    return known


ALPHA, BETA, GAMMA = 4 * w / (w + 1) ** 2, 8 / (w + 1) ** 2, 8 / (w * (w + 1) ** 2)
ALPHA_BETA = SteadyState(
    (ALPHA, BETA),
    8 / (w**2 - 1),
    sp.sqrt(1 + 8 / index),
    motion(2).piecewise_noise(sp.Integer(1)),
)
ALPHA_BETA_GAMMA = SteadyState(
    (ALPHA, BETA, GAMMA),
    8 / (w**3 - w),
    2 / sp.sqrt(3) * sp.third(12 * sp.sqrt(3) / index),
    motion(3).jump_noise(sp.Integer(1)),
)
FILTERS = {
    "alpha_beta": (
        ALPHA_BETA,
        "alpha and beta",
        "position and velocity",
        "an acceleration that is constant over a period",
    ),
    "alpha_beta_gamma": (
        ALPHA_BETA_GAMMA,
        "alpha, beta and gamma",
        "position, velocity and acceleration",
        "an acceleration that jumps at each scan",
    ),
}


def quantities() -> Iterator[Quantity]:
    """Gain and covariance of both filters."""
    for name, (filter_, letters, state, driven) in FILTERS.items():
        yield Quantity(
            name=f"steady_state.{name}.gain",
            meaning=f"{letters}, the steady gains times 1, T, ... of a filter of {state}, with {driven}",
            axes=((ONE,) * filter_.size,),
            symbols=(index,),
            conditioning=Conditioning.NONE,
            source=SOURCE,
            word="K = P H'/(H P H' + sigma_r^2), P = F (1 - K H) P F' + Q",
            derivation=_over_index(filter_, _gain),
            rewriting=_over_root(filter_, _gain),
            scale=_over_index(filter_, _gain),
            measured_against="itself",
        )
        yield Quantity(
            name=f"steady_state.{name}.covariance",
            meaning=f"steady error covariance of {state} after a measurement, with {driven}",
            axes=(units(filter_.size),) * 2,
            symbols=(index, sigma_r, T),
            conditioning=Conditioning.NONE,
            source=SOURCE,
            word="(1 - K H) P, P = F (1 - K H) P F' + Q",
            derivation=_over_index(filter_, _covariance),
            rewriting=_over_root(filter_, _covariance),
        )


def _gain(of: SteadyState) -> Tensor[Expr]:
    of.predicted  # noqa: B018 - the proof that this is the gain
    return Tensor((of.size,), of.gain)


def _covariance(of: SteadyState) -> Tensor[Expr]:
    def entry(m: int, n: int) -> Expr:
        return sigma_r**2 * of.without_cancellation(of.filtered[m][n]) / T ** (m + n)

    return Tensor.build((of.size, of.size), entry)


def _over_index(of: SteadyState, derive: Callable[[SteadyState], Tensor[Expr]]) -> Callable[[], Tensor[Expr]]:
    return lambda: derive(of).map(lambda entry: entry.xreplace({w: of.root}))


def _over_root(of: SteadyState, derive: Callable[[SteadyState], Tensor[Expr]]) -> Callable[[], StableForm]:
    return lambda: StableForm({w: of.root}, derive(of))
