"""Monte Carlo of one polar quantity: beside drawing its normals alone, in one process each."""

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from radartrack._arrays import machine_code
from radartrack.derive.catalogue import catalogue
from radartrack.generated import polar
from radartrack.verification.simulation.draws import BLOCK, CHUNK, Experiment, Sums, simulate
from radartrack.verification.simulation.experiments import trials

Timed = Callable[..., Any]
NAME = "polar.covariance.truth"
SAMPLES = 128 * CHUNK


class TestMonteCarlo:
    """With control variates and exact sums."""

    def test_machine_code(self, timed: Timed) -> None:
        timed(by_radartrack, experiment(), items=SAMPLES, rounds=3)

    def test_numpy(self, timed: Timed, monkeypatch: pytest.MonkeyPatch) -> None:
        monkeypatch.setattr(machine_code, "is_available", lambda: False)
        timed(by_radartrack, experiment(), items=SAMPLES, rounds=3)

    def test_normals(self, timed: Timed) -> None:
        timed(normals, items=SAMPLES, rounds=3)


def experiment() -> Experiment:
    return next(trials(catalogue()[NAME], polar.covariance_truth, seed=0)).experiment


def by_radartrack(experiment: Experiment) -> Sums:
    return simulate(experiment, range(SAMPLES // CHUNK))


def normals() -> None:
    for number in range(SAMPLES // CHUNK):
        generator = np.random.Generator(np.random.Philox(number))
        for _ in range(CHUNK // BLOCK):
            generator.standard_normal((4, BLOCK))  # a sample is two plots
