"""A fault anywhere in the generated code is found: in the functions, the conversions over arrays, and the loops."""

import ast
import json
import os
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from typer.testing import CliRunner, Result

from radartrack._arrays import machine_code
from radartrack.cli import app
from radartrack.derive.catalogue import catalogue, find
from radartrack.derive.writing.conversion_functions import conversions_of
from radartrack.verification.campaign import Effort
from radartrack.verification.domain_points import coarse, sample
from radartrack.verification.outcome import FUNCTION, Verdict, examined
from radartrack.verification.paths import ARRAYS, MACHINE_CODE, ONE_PLOT, along, conversion_of, paths_of
from radartrack.verification.subject import evaluated, scale_of
from tests.faulty_code import Fault, faults, faults_of, parsed, put_in

HELPERS = ("_floats", "_empty", "_ratio", "_remainder", "_stumpff", "_third")
SEED = 2
COUNT = int(os.environ.get("RADARTRACK_FAULTS", "10"))
EFFORT = Effort(points=40, nodes=1, draws=1, mutants=0)
WHOLE = Effort(points=2000, nodes=1, draws=1, mutants=0)  # as `verify` does it, for terms that matter at few points
SAME = 2.0**-44
OF_THE_FORMULA = "identity"  # not of the code
OF_THE_FILE = "rounding"  # its certificate is of the text, which it refuses whatever was changed
PATHS = {"conversions": ARRAYS, "loops": ONE_PLOT}


@cache
def computed_by(module: str, function: str) -> list[str]:
    """The quantities that a generated function computes; of a helper, all of its module."""
    if module in PATHS:
        return [name for name in catalogue() if conversion_of(name) == function]
    own = [quantity for quantity in catalogue().values() if quantity.module == module]
    return [quantity.name for quantity in own if function in {quantity.function, *HELPERS}]


def is_found(fault: Fault, effort: Effort = EFFORT) -> bool:
    path = PATHS.get(fault.module, FUNCTION)
    return any(
        examined(layer, *along(path, find(name))).verdict is Verdict.FAILED
        for name in computed_by(fault.module, fault.function)
        for layer in effort.layers_along(path)
        if layer.name not in {OF_THE_FORMULA, OF_THE_FILE}
    )


def values(fault: Fault) -> list[np.ndarray]:
    """What the function in which the fault is, or is to be, gives at many points, each entry by its scale."""
    found = []
    for name in computed_by(fault.module, fault.function):
        quantity, function = along(PATHS.get(fault.module, FUNCTION), find(name))
        for points in (sample(quantity, 1000, 1, correlated=True), sample(quantity, 1000, 2), coarse(quantity, 100, 3)):
            at_points = evaluated(function, quantity, points)
            with np.errstate(all="ignore"):
                found.append(at_points / scale_of(quantity, at_points))
    return found


@pytest.mark.parametrize("number", range(COUNT))
def test_a_fault_in_any_place_of_the_generated_code_is_found(number: int, monkeypatch: pytest.MonkeyPatch):
    """Unless it makes no difference, as where numerator and denominator share what it changes."""
    fault = faults(COUNT, seed=SEED)[number]  # looking for them takes seconds
    right = values(fault)
    fault.put_in(monkeypatch)
    if not is_found(fault) and not is_found(fault, WHOLE):
        for before, after in zip(right, values(fault), strict=True):
            np.testing.assert_allclose(after, before, rtol=0, atol=SAME, err_msg=str(fault))


@pytest.mark.parametrize("module", ["polar", "steady_state", *PATHS])
def test_right_code_that_is_put_in_as_a_fault_is_passes_every_layer(module: str, monkeypatch: pytest.MonkeyPatch):
    fault = next(faults_of(module))
    put_in(module, ast.unparse(parsed(module)), monkeypatch)
    assert computed_by(module, fault.function)
    assert not is_found(fault)


def test_every_conversion_is_looked_at_through_its_mean_and_its_covariance():
    seen = [conversion_of(name) for name in catalogue() if ARRAYS in paths_of(find(name))]
    assert sorted(filter(None, seen)) == sorted(2 * [f"{m}_{method}" for m, method in conversions_of(catalogue())])


def verify(*arguments: str) -> Result:
    settings = ["--points", "40", "--workers", "1", "--checkpoint", str(Path.cwd() / "checkpoint.jsonl")]
    return CliRunner().invoke(app, ["verify", *arguments, *settings], env={"COLUMNS": "200"})


def cosines_for_sines(module: str) -> Fault:
    """The first one in the conversion of a polar plot."""
    return next(f for f in faults_of(module) if (f.function, f.kind) == ("polar_unbiased", "function"))


@pytest.mark.parametrize(("module", "path"), PATHS.items())
def test_the_command_finds_what_users_run_to_be_wrong_where_the_function_is_right(
    module: str, path: str, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(machine_code, "is_available", lambda: False)
    cosines_for_sines(module).put_in(monkeypatch)
    record = tmp_path / "record.json"
    result = verify("polar.unbiased.estimate", "--draws", str(1 << 17), "--json", str(record))
    assert result.exit_code == 1
    assert f"polar.unbiased.estimate, ulp: {path}: " in result.stdout
    (found,) = json.loads(record.read_text())["functions"]
    failed = {layer["layer"] for layer in found["layers"] if layer["verdict"] == "failed"}
    assert failed >= {"ulp", "quadrature", "Monte Carlo"}
    assert found["paths"] == [FUNCTION, ARRAYS, ONE_PLOT]
    figures = next(layer["figures"] for layer in found["layers"] if layer["layer"] == "ulp")
    assert {name for name, figure in figures.items() if figure > 8} == {path}


def test_machine_code_is_looked_at_where_numba_is_there(monkeypatch: pytest.MonkeyPatch, tmp_path: Path):
    def wrong(*arrays: np.ndarray) -> None:
        arrays[-1][:] = 1.0

    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(machine_code, "is_available", lambda: True)
    monkeypatch.setattr(machine_code, "conversion", lambda *_: wrong)
    result = verify("polar.covariance.linear")
    assert result.exit_code == 1
    assert f"polar.covariance.linear, ulp: {MACHINE_CODE}: " in result.stdout
    assert "fa1m" in result.stdout


@pytest.mark.parametrize("module", ["conversions", "polar"])
def test_code_that_breaks_down_has_failed_and_the_run_goes_on(
    module: str, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
):
    def broken(*_: object, **__: object) -> None:
        raise IndexError("no such place")

    monkeypatch.chdir(tmp_path)
    function = {"conversions": "polar_averaged", "polar": "bias_averaged"}[module]
    monkeypatch.setattr(f"radartrack.generated.{module}.{function}", broken)
    result = verify("polar.bias.averaged", "--draws", str(1 << 17))
    assert result.exit_code == 1
    assert "no such place" in result.stdout
    assert "polar.bias.averaged, Monte Carlo: " in result.stdout


def test_plots_that_are_filled_in_elsewhere_are_wrong(monkeypatch: pytest.MonkeyPatch):
    fault = next(f for f in faults_of("loops") if f.kind == "index")
    fault.put_in(monkeypatch)
    assert is_found(fault)
