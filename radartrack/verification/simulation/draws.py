"""Draws of measurement errors and what they give: the part of Monte Carlo that runs in worker processes.

A mean E[g(w)] is estimated by that of g(w) − c(w), with c the second-order Taylor polynomial of g, whose mean is
known: what is left is of third order in the errors, so that errors of a formula beyond its second order stand out.
Where g itself is averaged, each w is drawn with −w: third orders cancel, and what is left is of fourth order. What is
left of a product g_a g_b is of fourth order as it is.
Draws come from counter-based streams keyed by what is tested, the point and the number of the chunk. Sums over a chunk
are combined without rounding. The result does not depend on who computed which chunk when.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property, partial, reduce
from hashlib import blake2b
from importlib import import_module
from itertools import islice
from operator import add
from typing import Any, cast

import numpy as np
import numpy.typing as npt

from radartrack._arrays import machine_code
from radartrack.verification.array_program import Program
from radartrack.verification.simulation.exact_sum import ExactSum
from radartrack.verification.simulation.statistics import POWERS
from radartrack.verification.simulation.tracing import traced

Array = npt.NDArray[np.float64]
Function = Callable[..., Any]
Summation = Callable[[Iterable[Array]], Array]
BLOCK = 1 << 12  # times that all errors are drawn at once: what is computed from them stays in the cache
CHUNK = 1 << 16  # times that they are drawn from one stream
CHUNKS_OF_A_TASK = 64
COMPILED_FROM = CHUNKS_OF_A_TASK  # chunks; for fewer, loading the compiler takes longer than it saves


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
class Slopes:
    """The first two derivatives of the map at the point, [out, in] and [out, in, in]."""

    jacobian: Array
    hessian: Array

    @cached_property
    def products(self) -> list[tuple[int, int]]:
        """The pairs of displacements whose products occur."""
        size = range(self.hessian.shape[-1])
        return [(i, j) for i in size for j in range(i + 1) if np.any(self.hessian[:, i, j])]

    @cached_property
    def weights(self) -> Array:
        """One row a component: for each displacement, then for each product of two."""
        squares = [self.hessian[:, i, j] * (0.5 if i == j else 1.0) for i, j in self.products]
        return np.concatenate([self.jacobian, np.stack(squares, axis=-1)], axis=-1) if squares else self.jacobian


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
        start: g without any error, one number a component.
        slopes: of the map, for the Taylor polynomial of g.
        pairs: products g_a g_b that are averaged; empty for the components themselves.
        shift: what each mean should be; it is taken from every draw, so that squares keep their digits.
    """

    key: str
    point: Mapping[str, float]
    names: tuple[str, ...]
    factors: tuple[Array, ...]
    terms: tuple[Term, ...]
    functions: Mapping[str, Program | tuple[Function, tuple[str, ...]]]
    start: Array
    slopes: Slopes
    pairs: tuple[tuple[int, int], ...]
    shift: tuple[float, ...]

    @property
    def normals(self) -> int:
        """How many make one draw of all errors."""
        return sum(map(len, self.factors))

    def chunks(self, draws: int) -> int:
        """How many give at least so many draws; w and −w are two."""
        return -(-draws // (CHUNK if self.pairs else 2 * CHUNK))


@dataclass(frozen=True)
class Sums:
    """How many residuals there are, w and −w giving one, and for each mean the sums of their first powers."""

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


def simulate(experiment: Experiment, chunks: Sequence[int]) -> Sums:
    """The sums over some chunks.

    Raises:
        ValueError: when what was drawn is no number.

    """
    summed = _summation(experiment, len(chunks))
    return reduce(add, (_chunk(experiment, number, summed) for number in chunks))


@dataclass(frozen=True)
class Draws:
    """A task: some chunks of one simulation."""

    experiment: Experiment
    chunks: range

    @property
    def key(self) -> str:
        """Its name in a checkpoint."""
        return f"{self.experiment.key}/{self.chunks.start}-{self.chunks.stop}"

    def __call__(self) -> dict[str, Any] | None:
        """The sums as JSON has them; None where what was drawn is no number."""
        try:
            return simulate(self.experiment, self.chunks).record()
        except ValueError:
            return None


def tasks_for(experiment: Experiment, draws: int) -> list[Draws]:
    """Those that give at least so many draws."""
    chunks = experiment.chunks(draws)
    starts = range(0, chunks, CHUNKS_OF_A_TASK)
    return [Draws(experiment, range(start, min(start + CHUNKS_OF_A_TASK, chunks))) for start in starts]


def _chunk(experiment: Experiment, number: int, summed: Summation) -> Sums:
    key = int.from_bytes(blake2b(experiment.key.encode(), digest_size=16).digest(), "little")
    generator = np.random.Generator(np.random.Philox(key=key, counter=number << 128))
    normals = np.empty((experiment.normals, BLOCK))  # of one block after the other: new memory is slow at first
    totals = summed(generator.standard_normal(out=normals) for _ in range(CHUNK // BLOCK))
    powers = [ExactSum.of([float(total)]) for total in totals]
    return Sums(CHUNK, tuple(zip(*[iter(powers)] * POWERS, strict=True)))


def _summation(experiment: Experiment, chunks: int) -> Summation:
    """What gives the sums of all powers over blocks of normals [normal, draw]."""
    worthwhile = chunks >= COMPILED_FROM and machine_code.is_available()
    return (_compiled(experiment) if worthwhile else None) or partial(_summed, experiment)


def _compiled(experiment: Experiment) -> Summation | None:
    """None where more is done than the compiled loop knows."""
    if not all(isinstance(function, Program) for function in experiment.functions.values()):
        return None
    compiled_draws = import_module("radartrack.verification.simulation.machine_code_draws")  # loads Numba
    try:
        tape = traced(partial(_residuals, experiment), experiment.normals)
    except TypeError:
        return None
    return cast("Summation", compiled_draws.summation(tape)) if compiled_draws.is_possible(tape) else None


def _summed(experiment: Experiment, blocks: Iterable[Array]) -> Array:
    return reduce(add, (np.array([power.sum() for power in _powers(experiment, list(block))]) for block in blocks))


def _powers(experiment: Experiment, normals: list[Any]) -> list[Any]:
    """For each mean the first four powers of the residuals, one array each."""
    found: list[Any] = []
    for residual in _residuals(experiment, normals):
        square = residual * residual
        found += [residual, square, residual * square, square * square]
    return found


def _residuals(experiment: Experiment, normals: list[Any]) -> list[Any]:
    """g − c, or products of them, less what the mean should be, one array a mean."""
    rows = iter(normals)
    errors = [_correlated(list(islice(rows, len(factor))), factor) for factor in experiment.factors]
    left = _of_products(experiment, errors) if experiment.pairs else _of_values(experiment, errors)
    return [residual - shift for residual, shift in zip(left, experiment.shift, strict=True)]


def _of_products(experiment: Experiment, errors: list[list[Array]]) -> list[Array]:
    """g_a g_b − c_a c_b."""
    displacements = [_displacement(term, errors, 1.0) for term in experiment.terms]
    values = _values(experiment, displacements)
    control = _control(experiment, displacements, both_ways=False)
    return [values[a] * values[b] - control[a] * control[b] for a, b in experiment.pairs]


def _of_values(experiment: Experiment, errors: list[list[Array]]) -> list[Array]:
    """The mean of g at w and at −w, less c."""
    forth, back = ([_displacement(term, errors, way) for term in experiment.terms] for way in (1.0, -1.0))
    both = zip(_values(experiment, forth), _values(experiment, back), strict=True)
    control = _control(experiment, forth, both_ways=True)
    return [(one + other) * 0.5 - known for (one, other), known in zip(both, control, strict=True)]


def _correlated(normal: Sequence[Array], factor: Array) -> list[Array]:
    """Row by row in a fixed order; a matrix product may sum in another one elsewhere."""
    rows = []
    for i, line in enumerate(factor):
        total = line[0] * normal[0]
        for j in range(1, i + 1):
            if line[j]:
                total = total + line[j] * normal[j]
        rows.append(total)
    return rows


def _scaled(factor: float, values: Array) -> Array:
    return values if factor == 1 else factor * values


def _displacement(term: Term, errors: list[list[Array]], way: float) -> list[Array]:
    """One array a measured quantity; empty where the term stays at the point."""
    moved: list[Array] = []
    for times, group in zip(term.displacement, errors, strict=True):
        if times and not moved:
            moved = [_scaled(way * times, error) for error in group]
        elif times:
            moved = [so_far + _scaled(way * times, error) for so_far, error in zip(moved, group, strict=True)]
    return moved


def _values(experiment: Experiment, displacements: list[list[Array]]) -> list[Array]:
    """g, one array a component."""
    found: list[Array] = []
    for term, displacement in zip(experiment.terms, displacements, strict=True):
        values = _evaluated(experiment, term, displacement)
        combine = np.add if term.sign > 0 else np.subtract
        found = list(map(combine, found, values)) if found else [_scaled(term.sign, value) for value in values]
    return found


def _evaluated(experiment: Experiment, term: Term, displacement: list[Array]) -> list[Array]:
    moved: dict[str, Any] = dict(experiment.point)
    for name, distance in zip(experiment.names, displacement, strict=False):
        moved[name] = moved[name] + distance
    function = experiment.functions[term.value]
    if isinstance(function, Program):
        return function.entries(moved)
    call, names = function
    table = np.asarray(call(**{name: moved[name] for name in names}))
    return [table[..., a] for a in range(table.shape[-1])]


def _control(experiment: Experiment, displacements: list[list[Array]], *, both_ways: bool) -> list[Array]:
    """c, one array a component: the sum of the terms' second-order Taylor polynomials.

    The linear parts of w and −w cancel.
    """
    totals: dict[int, Array] = {}
    slopes = experiment.slopes
    for term, displacement in zip(experiment.terms, displacements, strict=True):
        for place, feature in _features(slopes, displacement, both_ways=both_ways):
            combine = np.add if term.sign > 0 else np.subtract
            totals[place] = combine(totals[place], feature) if place in totals else _scaled(term.sign, feature)
    weights = slopes.weights
    return [
        reduce(add, (weights[a, place] * total for place, total in totals.items() if weights[a, place]), start)
        for a, start in enumerate(experiment.start)
    ]


def _features(slopes: Slopes, displacement: list[Array], *, both_ways: bool) -> Iterator[tuple[int, Array]]:
    """What the weights of the slopes multiply, with the places of these."""
    if not displacement:
        return
    if not both_ways:
        yield from enumerate(displacement)
    for place, (i, j) in enumerate(slopes.products, start=len(displacement)):
        yield place, displacement[i] * displacement[j]
