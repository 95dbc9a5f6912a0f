"""Layer: simulated measurements."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from functools import partial

from radartrack.derive.language.quantity import Quantity
from radartrack.verification.layers.quadrature import not_applicable
from radartrack.verification.outcome import FUNCTION, Function, Outcome
from radartrack.verification.simulation.draws import Experiment, Sums, simulate
from radartrack.verification.simulation.experiments import Departures, Trial, budget, simulated, trials
from radartrack.verification.simulation.statistics import (
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

    draws: int = 1 << 20
    seed: int = 0
    name: str = NAME

    def __call__(self, quantity: Quantity, function: Function) -> Outcome:
        """Draws in this process; the command line spreads the same draws over many."""
        if not simulated(quantity):
            return reason(quantity)
        planned = trials(quantity, function, self.seed)
        none: Mapping[str, Departures] = {}
        results = ((trial, _sums(trial.experiment, self.draws), none) for trial in planned)
        return decided(results, budget(quantity))


def reason(quantity: Quantity) -> Outcome:
    """Why nothing is simulated."""
    said = not_applicable(quantity) or "a Taylor polynomial's moment; quadrature over the polynomial is exact"
    return Outcome.not_applicable(NAME, said)


def _sums(experiment: Experiment, draws: int) -> Sums | ValueError:
    try:
        return simulate(experiment, range(experiment.chunks(draws)))
    except ValueError as error:
        return error


@dataclass(frozen=True)
class Comparison:
    """One mean of what is drawn less what the function says, or what a conversion does."""

    label: str
    mean: Mean
    rounding: float
    relative: float
    beyond: float
    path: str = FUNCTION

    @property
    def z(self) -> float:
        """The standardised deviation."""
        return abs(self.mean.standardised(self.rounding))

    @property
    def p(self) -> float:
        """The corrected probability of a deviation like this by chance."""
        return self.mean.p_value(self.rounding)

    def correction(self, limit: float) -> float:
        """That of the tail at the limit; none where rounding hides the spread of the draws."""
        return self.mean.correction(limit) if limit * self.mean.error > self.rounding else 0.0

    def detectable(self, tests: int) -> float:
        """The smallest error that is found, relative to the scale of the entry."""
        return detectable(self.mean, self.rounding, tests) * self.relative


def comparisons(trial: Trial, sums: Sums) -> list[Comparison]:
    """Every mean of a trial."""
    rows = zip(trial.labels, sums.powers, trial.rounding, trial.scale, trial.beyond, strict=True)
    return [
        Comparison(label, Mean.of(sums.draws, powers), rounding, trial.factor / scale, beyond)
        for label, powers, rounding, scale, beyond in rows
    ]


def decided(results: Iterable[tuple[Trial, Sums | ValueError, Mapping[str, Departures]]], tests: int) -> Outcome:
    """All points of one quantity together; where conversions depart from the function, the means move as far.

    Args:
        results: each trial, what was drawn, and how far each conversion departs.
        tests: how many means share their false alarms with these.
    """
    found: list[Comparison] = []
    for trial, sums, departures in results:
        if isinstance(sums, ValueError) or not trial.finite:
            return Outcome.failed(NAME, "the function gave what is no number")
        by_function = comparisons(trial, sums)
        found += by_function
        for path, moved in departures.items():
            if not all(map(math.isfinite, moved)):
                return Outcome.failed(NAME, f"{path}: the conversion gave what is no number")
            found += map(partial(_moved, path), by_function, moved)
    return _outcome(found, tests)


def _moved(path: str, comparison: Comparison, by: float) -> Comparison:
    """The same draws less what another path says; the spread stays what it is."""
    mean = replace(comparison.mean, value=comparison.mean.value + by)
    return replace(comparison, mean=mean, path=path)


def _outcome(found: list[Comparison], tests: int) -> Outcome:
    limit = threshold(tests)
    smallest = min(c.p for c in found)
    worst = max(found, key=lambda c: c.z)
    means = sum(c.path == FUNCTION for c in found)
    shape = max(c.correction(limit) for c in found)
    seen = max(c.detectable(tests) for c in found)
    resolved = max((c.beyond / least for c in found if (least := c.detectable(tests))), default=0.0)
    detail = (
        f"{worst.path}: {means} of {tests} means, each of {worst.mean.draws} residuals, worst entry {worst.label} "
        f"{worst.z:.2f} standard errors, p {smallest:.2g} of {FALSE_ALARM / tests:.1g}; an error of {seen:.1g} is "
        f"found in any entry with probability {POWER}; what second order leaves out is up to {resolved:.2g} times what "
        f"would be found; "
        f"tails {math.exp(min(shape, 99.0)):.3g} times normal"
    )
    if shape > MOST_CORRECTION and smallest >= FALSE_ALARM / tests:
        return Outcome.failed(NAME, f"too few draws for the shape of what is drawn: {detail}")
    figures = {path: _figure([c.p for c in found if c.path == path], tests) for path in {c.path: None for c in found}}
    return Outcome.measured(NAME, max(figures.values()), 1.0, detail, figures)


def _figure(probabilities: Iterable[float], tests: int) -> float:
    """The logarithm of the smallest by that of the threshold."""
    return max(math.log(max(min(probabilities), 1e-300)) / math.log(FALSE_ALARM / tests), 0.0)
