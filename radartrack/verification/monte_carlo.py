"""Layer: simulated measurements."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from functools import reduce
from operator import add

from radartrack.derive.quantity import Quantity
from radartrack.verification.experiments import Trial, simulated, tests_of_catalogue, trials
from radartrack.verification.outcome import Function, Outcome
from radartrack.verification.quadrature import not_applicable
from radartrack.verification.simulation import CHUNK, Experiment, Sums, simulate
from radartrack.verification.statistics import (
    FALSE_ALARM,
    MOST_CORRECTION,
    POWER,
    Mean,
    detectable,
    threshold,
)

NAME = "Monte Carlo"


@dataclass(frozen=True)
class MonteCarlo:
    """The function against means over draws.

    Attributes:
        draws: how many a point, rounded up to whole chunks.
        seed: of the points and the streams.
    """

    draws: int = 1 << 18
    seed: int = 0
    name: str = NAME

    def __call__(self, quantity: Quantity, function: Function) -> Outcome:
        """Draws in this process; the command line spreads the same draws over many."""
        if not simulated(quantity):
            return reason(quantity)
        chunks = range(-(-self.draws // CHUNK))
        return decided((trial, _sums(trial.experiment, chunks)) for trial in trials(quantity, function, self.seed))


def reason(quantity: Quantity) -> Outcome:
    """Why nothing is simulated."""
    said = not_applicable(quantity) or "a Taylor polynomial's moment; quadrature over the polynomial is exact"
    return Outcome.not_applicable(NAME, said)


def _sums(experiment: Experiment, chunks: Iterable[int]) -> Sums | ValueError:
    try:
        return reduce(add, (simulate(experiment, [number]) for number in chunks))
    except ValueError as error:
        return error


@dataclass(frozen=True)
class Comparison:
    """One mean against what the function says."""

    label: str
    mean: Mean
    expected: float
    relative: float

    @property
    def z(self) -> float:
        """The standardised deviation."""
        return abs(self.mean.standardised(self.expected))


def comparisons(trial: Trial, sums: Sums) -> list[Comparison]:
    """Every mean of a trial."""
    rows = zip(trial.labels, sums.powers, trial.expected, trial.scale, strict=True)
    return [
        Comparison(label, Mean.of(sums.draws, powers), expected, trial.factor / scale)
        for label, powers, expected, scale in rows
    ]


def decided(results: Iterable[tuple[Trial, Sums | ValueError]]) -> Outcome:
    """All points of one quantity together."""
    found: list[Comparison] = []
    beyond = math.inf
    for trial, sums in results:
        if isinstance(sums, ValueError):
            return Outcome.failed(NAME, f"the simulation gave what is no number: {sums}")
        if not all(map(math.isfinite, trial.expected)):
            return Outcome.failed(NAME, "the function gave what is no number")
        found += comparisons(trial, sums)
        beyond = min(beyond, trial.beyond)
    return _outcome(found, beyond)


def _outcome(found: list[Comparison], beyond: float) -> Outcome:
    tests = tests_of_catalogue()
    limit = threshold(tests)
    smallest = min(c.mean.p_value(c.expected) for c in found)
    worst = max(found, key=lambda c: c.z)
    shape = max(c.mean.correction(limit) for c in found)
    seen = max(detectable(c.mean, tests) * c.relative for c in found)
    detail = (
        f"{len(found)} of {tests} means, {worst.mean.draws} draws each, worst entry {worst.label} "
        f"{worst.z:.2f} standard errors, p {smallest:.2g} of {FALSE_ALARM / tests:.1g}; an error of {seen:.1g} is found with "
        f"probability {POWER} (beyond second order: {beyond:.1g}); tails {math.exp(min(shape, 99.0)):.3g} times normal"
    )
    if shape > MOST_CORRECTION and smallest >= FALSE_ALARM / tests:
        return Outcome.failed(NAME, f"too few draws for the shape of what is drawn: {detail}")
    figure = math.log(max(smallest, 1e-300)) / math.log(FALSE_ALARM / tests)
    return Outcome.measured(NAME, max(figure, 0.0), 1.0, detail)
