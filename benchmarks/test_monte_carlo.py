"""Monte Carlo of one polar quantity: beside drawing its normals alone, in one process each."""

from collections.abc import Callable
from typing import Any

import numpy as np

from radartrack.derive.catalogue import catalogue
from radartrack.generated import polar
from radartrack.verification.experiments import trials
from radartrack.verification.simulation import BLOCK, CHUNK, Sums, simulate

Timed = Callable[..., Any]
NAME = "polar.covariance.truth"
SAMPLES = 128 * CHUNK


class TestMonteCarlo:
    """With control variates and exact sums."""

    def test_radartrack(self, timed: Timed) -> None:
        trial = next(trials(catalogue()[NAME], polar.covariance_truth, seed=0))
        timed(by_radartrack, trial.experiment, items=SAMPLES, rounds=3)

    def test_normals(self, timed: Timed) -> None:
        timed(normals, items=SAMPLES, rounds=3)


def by_radartrack(experiment: Any) -> Sums:
    return simulate(experiment, range(SAMPLES // CHUNK))


def normals() -> None:
    for number in range(SAMPLES // CHUNK):
        generator = np.random.Generator(np.random.Philox(number))
        for _ in range(CHUNK // BLOCK):
            generator.standard_normal((4, BLOCK))  # a sample is two plots
