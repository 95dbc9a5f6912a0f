"""The layers along compiled C: right code passes in both precisions, and a slip is noticed in both."""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from typer.testing import CliRunner

from radartrack.cli import app
from radartrack.derive.catalogue import find
from radartrack.verification import compiled_c
from radartrack.verification.compiled_c import DOUBLE, PATHS, SINGLE, InC
from radartrack.verification.domain_points import coarse
from radartrack.verification.layers.dimensions import Dimensions
from radartrack.verification.layers.loosened import in_single
from radartrack.verification.layers.quadrature import Quadrature
from radartrack.verification.layers.ulp_search import Accuracy
from radartrack.verification.outcome import Layer, Verdict, examined
from radartrack.verification.subject import generated
from tests.c_programs import needs_compiler

LAYERS: list[Layer] = [Accuracy(60), Quadrature(1), Dimensions()]
UNBIASED = find("polar.unbiased.covariance")


def verdicts(path: str) -> dict[str, Verdict]:
    layers = [in_single(layer) if path == SINGLE else layer for layer in LAYERS]
    return {layer.name: examined(layer, UNBIASED, InC(UNBIASED, path)).verdict for layer in layers}


@needs_compiler
@pytest.mark.parametrize("path", PATHS)
def test_what_is_written_passes(path: str):
    assert set(verdicts(path).values()) == {Verdict.PASSED}


@needs_compiler
@pytest.mark.parametrize("path", PATHS)
def test_a_slip_is_noticed(path: str, monkeypatch: pytest.MonkeyPatch):
    right = compiled_c._written(UNBIASED)
    double, single = (text.replace("0.5", "0.501", 1) for text in right.bodies)
    monkeypatch.setattr(compiled_c, "_written", lambda _: replace(right, bodies=(double, single)))
    found = verdicts(path)
    assert (found["ulp"], found["quadrature"]) == (Verdict.FAILED, Verdict.FAILED)


@needs_compiler
@pytest.mark.parametrize("path", PATHS)
@pytest.mark.parametrize(
    "name",
    [
        "polar.covariance.averaged",
        "observe.polar.jacobian",
        "line.slope",
        "motion.plane.observation",
        "line.folded_mean_factor",
    ],
)
def test_it_computes_what_numpy_does_at_arguments_that_broadcast(name: str, path: str):
    quantity = find(name)
    points: dict[str, Any] = {key: values.reshape(2, 3) for key, values in coarse(quantity, 6).items()}
    if len(points) > 1:
        points["rho" if "rho" in points else next(iter(points))] = np.float64(0.5)
    expected = generated(quantity)(**points)
    found = InC(quantity, path)(**points)
    size = np.abs(expected).max() if path == SINGLE else np.abs(expected)
    assert np.all(np.abs(found - expected) <= {DOUBLE: 1e-12, SINGLE: 1e-4}[path] * size)
    assert found.shape == expected.shape


@needs_compiler
def test_points_outside_of_the_range_of_single_precision_are_known():
    points = {
        "r": np.array([1e3, 1e30]),
        "beta": np.ones(2),
        "sigma_r": np.ones(2),
        "sigma_beta": np.full(2, 0.1),
        "rho": np.zeros(2),
    }
    assert InC(UNBIASED, SINGLE).within_range(points).tolist() == [True, False]
    assert InC(UNBIASED, DOUBLE).within_range(points).tolist() == [True, True]


@needs_compiler
def test_the_command_says_both_precisions():
    arguments = ["verify", "polar.map", "--language", "c", "--points", "40", "--workers", "1"]
    result = CliRunner().invoke(app, arguments)
    assert result.exit_code == 0, result.output
    assert "c C, s C single" in result.output


def test_without_a_compiler_the_command_says_so(monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setenv("CC", "there-is-no-such-compiler")
    result = CliRunner().invoke(app, ["verify", "polar.map", "--language", "c"])
    assert result.exit_code == 2
    assert "C compiler" in result.output
