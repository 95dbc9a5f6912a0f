"""Draws of measurement errors and what they give: the part of Monte Carlo that runs in worker processes, NumPy alone.

A mean E[g(w)] is estimated by that of g(w) − c(w), with c the second-order Taylor polynomial of g, whose mean is
known: what is left is of third order in the errors, so that errors of a formula beyond its second order stand out.
Draws come from counter-based streams keyed by what is tested, the point and the number of the chunk. Sums over a chunk
are combined without rounding. The result does not depend on who computed which chunk when.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import reduce
from hashlib import blake2b
from operator import add
from typing import Any

import numpy as np
import numpy.typing as npt

from radartrack.verification.exact_sum import ExactSum
from radartrack.verification.programs import Program

Array = npt.NDArray[np.float64]
Function = Callable[..., Any]
CHUNK = 1 << 14
CHUNKS_OF_A_TASK = 64
POWERS = 4


@dataclass(frozen=True)
class Term:
    """One function of the measured quantities at a displaced point, with its sign.

    Attributes:
        sign: with which it enters.
        displacement: how often each error is added to the point.
        value: the function's name among those of the experiment.
    """

    sign: float
    displacement: tuple[float, ...]
    value: str


@dataclass(frozen=True)
class Polynomial:
    """c(w) = constant + linear·w + wᵀ quadratic w/2, one row a component, over all errors stacked."""

    constant: Array
    linear: Array
    quadratic: Array

    def means(self, covariance: Array) -> Array:
        """E[c], one a component."""
        return np.asarray(self.constant + 0.5 * np.einsum("aij,ij->a", self.quadratic, covariance))

    def second_moments(self, covariance: Array) -> Array:
        """E[c_a c_b] = mean mean + linear K linear + tr(quadratic K quadratic K)/2."""
        means, spread = self.means(covariance), self.quadratic @ covariance
        linear = self.linear @ covariance @ self.linear.T
        return np.asarray(np.outer(means, means) + linear + 0.5 * np.einsum("aij,bji->ab", spread, spread))


@dataclass(frozen=True)
class Experiment:
    """Everything that a worker needs to simulate one quantity at one point.

    Attributes:
        key: what keys the streams: seed, quantity and point.
        point: the number of every symbol.
        names: the measured quantities.
        factors: a Cholesky factor for each error that is drawn.
        terms: whose sum is g.
        functions: by name, each giving an array (draws, components) or, as a program, its components.
        control: the Taylor polynomial of g.
        pairs: products g_a g_b that are averaged; empty for the components themselves.
    """

    key: str
    point: Mapping[str, float]
    names: tuple[str, ...]
    factors: tuple[Array, ...]
    terms: tuple[Term, ...]
    functions: Mapping[str, Program | tuple[Function, tuple[str, ...]]]
    control: Polynomial
    pairs: tuple[tuple[int, int], ...]

    @property
    def count(self) -> int:
        """How many means are estimated."""
        return len(self.pairs) or len(self.control.constant)


@dataclass(frozen=True)
class Sums:
    """Numbers of draws, and for each mean the sums of the first powers of what was drawn."""

    draws: int
    powers: tuple[tuple[ExactSum, ...], ...]

    def __add__(self, other: Sums) -> Sums:
        rows = zip(self.powers, other.powers, strict=True)
        return Sums(self.draws + other.draws, tuple(tuple(map(add, a, b)) for a, b in rows))

    def record(self) -> dict[str, Any]:
        """For a file."""
        return {"draws": self.draws, "powers": [[total.text() for total in row] for row in self.powers]}

    @classmethod
    def read(cls, record: Mapping[str, Any]) -> Sums:
        """What `record` wrote."""
        return cls(record["draws"], tuple(tuple(map(ExactSum.read, row)) for row in record["powers"]))


def simulate(experiment: Experiment, chunks: Sequence[int], chunk: int = CHUNK) -> Sums:
    """The sums over some chunks."""
    return reduce(add, (_sums(_residuals(experiment, number, chunk)) for number in chunks))


def chunks_of(task: int, draws: int) -> range:
    """The chunks of a task, so many draws in all being wanted."""
    first = task * CHUNKS_OF_A_TASK
    return range(first, min(first + CHUNKS_OF_A_TASK, -(-draws // CHUNK)))


def tasks_for(draws: int) -> int:
    """How many tasks give at least so many draws."""
    return -(-draws // (CHUNK * CHUNKS_OF_A_TASK))


def _sums(residuals: list[Array]) -> Sums:
    rows = []
    for residual in residuals:
        square = residual * residual
        powers = (residual.sum(), square.sum(), (square * residual).sum(), (square * square).sum())
        rows.append(tuple(ExactSum.of([float(total)]) for total in powers))
    return Sums(len(residuals[0]), tuple(rows))


def _residuals(experiment: Experiment, number: int, chunk: int) -> list[Array]:
    """g − c for every mean, one array of draws each."""
    errors = _errors(experiment, number, chunk)
    stacked = [error for group in errors for error in group]
    values = _values(experiment, errors, chunk)
    control = _control(experiment.control, stacked)
    if not experiment.pairs:
        return [g - c for g, c in zip(values, control, strict=True)]
    return [values[a] * values[b] - control[a] * control[b] for a, b in experiment.pairs]


def _errors(experiment: Experiment, number: int, chunk: int) -> list[list[Array]]:
    """For each error that is drawn, one array a measured quantity."""
    key = int.from_bytes(blake2b(experiment.key.encode(), digest_size=16).digest(), "little")
    generator = np.random.Generator(np.random.Philox(key=key, counter=number << 128))
    return [_correlated(generator.standard_normal((len(f), chunk)), f) for f in experiment.factors]


def _correlated(normal: Array, factor: Array) -> list[Array]:
    """Row by row in a fixed order; a matrix product may sum in another one on another machine."""
    rows = []
    for i, line in enumerate(factor):
        total = line[0] * normal[0]
        for j in range(1, i + 1):
            if line[j]:
                total = total + line[j] * normal[j]
        rows.append(total)
    return rows


def _values(experiment: Experiment, errors: list[list[Array]], chunk: int) -> list[Array]:
    """g, one array a component."""
    total: list[Array] | None = None
    for term in experiment.terms:
        found = _evaluated(experiment, term, errors, chunk)
        if total is None:
            total = [term.sign * value for value in found]
        else:
            total = [a + b if term.sign > 0 else a - b for a, b in zip(total, found, strict=True)]
    return total or []


def _evaluated(experiment: Experiment, term: Term, errors: list[list[Array]], chunk: int) -> list[Array]:
    moved: dict[str, Any] = dict(experiment.point)
    for place, name in enumerate(experiment.names):
        for times, error in zip(term.displacement, errors, strict=True):
            if times:
                moved[name] = moved[name] + error[place] if times > 0 else moved[name] - error[place]
    function = experiment.functions[term.value]
    if isinstance(function, Program):
        return [np.broadcast_to(entry, (chunk,)) for entry in function.entries(moved)]
    call, names = function
    table = np.asarray(call(**{name: moved[name] for name in names}))
    return [np.broadcast_to(table[..., a], (chunk,)) for a in range(table.shape[-1])]


def _control(polynomial: Polynomial, errors: list[Array]) -> list[Array]:
    """c, one array a component; each product of two errors is computed once."""
    size = range(len(errors))
    used = [(i, j) for i in size for j in range(i + 1) if np.any(polynomial.quadratic[:, i, j])]
    products = {(i, j): errors[i] * errors[j] for i, j in used}
    components = []
    for start, linear, quadratic in zip(
        polynomial.constant, polynomial.linear, polynomial.quadratic, strict=True
    ):
        total = np.full(errors[0].shape, start)
        for i in size:
            if linear[i]:
                total = total + linear[i] * errors[i]
        for (i, j), product in products.items():
            weight = quadratic[i, j] if i != j else 0.5 * quadratic[i, j]
            if weight:
                total = total + weight * product
        components.append(total)
    return components
