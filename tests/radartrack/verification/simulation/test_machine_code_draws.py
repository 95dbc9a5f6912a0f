"""Draws in machine code, or as Python where Numba is missing: the same sums as NumPy, within rounding."""

import dataclasses
import math
from functools import cache, partial
from typing import Any

import numpy as np
import pytest

from radartrack._arrays import machine_code
from radartrack.derive.catalogue import catalogue
from radartrack.derive.stable.quantity_form import form_of
from radartrack.generated.elementary import LARGEST_ANGLE
from radartrack.verification.array_program import Program
from radartrack.verification.program_compilation import compiled
from radartrack.verification.simulation import draws, machine_code_draws
from radartrack.verification.simulation.draws import Experiment, simulate
from radartrack.verification.simulation.experiments import Trial, trials
from radartrack.verification.simulation.machine_code_draws import LANES, is_possible, summation
from radartrack.verification.simulation.statistics import POWERS
from radartrack.verification.simulation.tracing import Tape, traced

NAMES = [
    "polar.bias.truth",
    "polar.covariance.averaged",
    "polar.decorrelated.covariance",
    "polar_doppler.unbiased.covariance",
    "spherical.bias.averaged",
]


@cache
def trial(name: str) -> Trial:
    quantity = catalogue()[name]
    return next(trials(quantity, compiled(form_of(quantity).expanded(), quantity.symbols), 0))


@pytest.mark.parametrize("function", [np.sin, np.cos])
def test_sines_of_any_size_are_those_of_numpy(function: Any) -> None:
    inputs = np.random.default_rng(3).normal(size=(1, LANES))
    tape = traced(lambda rows: [function(rows[0])], 1)
    for largest in (1.0, 2 * LARGEST_ANGLE, 1e300):
        inputs[0, 7] = largest
        expected = [(function(inputs) ** n).sum() for n in range(1, POWERS + 1)]
        assert summation(tape)([inputs]) == pytest.approx(expected, abs=1e-13)
    inputs[0, 7] = math.nan
    assert math.isnan(summation(tape)([inputs])[0])


@pytest.mark.parametrize("name", NAMES)
def test_sums_are_those_of_numpy(name: str) -> None:
    """Means within what rounding may move them by; it moves each power by at most its slope times that."""
    one = trial(name)
    powers = partial(draws._powers, one.experiment)
    tape = traced(partial(draws._residuals, one.experiment), one.experiment.normals)
    assert is_possible(tape) == machine_code.is_available()
    normals = np.random.default_rng(4).standard_normal((one.experiment.normals, LANES))
    found = summation(tape)([normals, normals]).reshape(-1, POWERS) / (2 * LANES)
    for mean, rounding, values in zip(found, one.rounding, _powers(powers(list(normals))), strict=True):
        sizes = np.abs(values).mean(axis=-1)
        slopes = np.array([1.0, *(n * size for n, size in enumerate(sizes[:-1], start=2))])
        assert (np.abs(mean - values.mean(axis=-1)) <= rounding * slopes + 1e-13 * sizes).all()


def _powers(arrays: list[np.ndarray]) -> np.ndarray:
    return np.array(arrays).reshape(-1, POWERS, LANES)


@pytest.fixture
def used(monkeypatch: pytest.MonkeyPatch) -> list[Tape]:
    """Two chunks repay the compiler; what was asked of it."""
    asked: list[Tape] = []

    def noted(tape: Tape) -> Any:
        asked.append(tape)
        return partial(draws._summed, trial("polar.bias.truth").experiment)

    monkeypatch.setattr(draws, "COMPILED_FROM", 2)
    monkeypatch.setattr("radartrack._arrays.machine_code.is_available", lambda: True)
    monkeypatch.setattr(machine_code_draws, "summation", noted)
    return asked


@pytest.mark.skipif(not machine_code.is_available(), reason="Numba compiles draws")
def test_many_draws_are_compiled_and_few_are_not(used: list[Tape]) -> None:
    few = simulate(trial("polar.bias.truth").experiment, [0])
    assert not used
    many = simulate(trial("polar.bias.truth").experiment, [0, 1])
    assert used
    assert many.draws == 2 * few.draws


def test_without_numba_numpy_draws(used: list[Tape], monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("radartrack._arrays.machine_code.is_available", lambda: False)
    simulate(trial("polar.bias.truth").experiment, [0, 1])
    assert not used


def squared_sine(**arguments: Any) -> Any:
    return np.sin([arguments["r"], arguments["beta"]]).T


@pytest.mark.parametrize(
    "function",
    [
        (squared_sine, ("r", "beta")),
        Program(("r", "beta"), (), (("tanh", (1,)),), (0, 2), (2,)),
        Program(("r", "beta"), (), (("ratio", (1, 0)),), (0, 2), (2,)),
    ],
)
def test_what_the_loop_does_not_know_is_left_to_numpy(used: list[Tape], function: Any) -> None:
    experiment: Experiment = dataclasses.replace(trial("polar.bias.truth").experiment, functions={"h": function})
    simulate(experiment, [0, 1])
    assert not used
