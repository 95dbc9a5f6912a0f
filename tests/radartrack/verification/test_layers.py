"""Ball arithmetic, exact sums, checkpoints, mutants, and the command."""

import json
import os
import re
import subprocess
import sys
from collections.abc import Iterable
from fractions import Fraction
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from radartrack.derive.catalogue import catalogue
from radartrack.derive.evaluation import balls
from radartrack.derive.evaluation.balls import Balls, exact_arithmetic, trustworthy
from radartrack.verification.campaign import Campaign, Effort
from radartrack.verification.domain_points import sample
from radartrack.verification.engines import Local, Results
from radartrack.verification.error_in_ulp import errors
from radartrack.verification.layers import mutants
from radartrack.verification.layers.formula_mutants import mutants as mutants_of
from radartrack.verification.layers.ulp_search import Accuracy
from radartrack.verification.outcome import Verdict
from radartrack.verification.program_compilation import compiled
from radartrack.verification.simulation.exact_sum import ExactSum

FINITE = st.floats(allow_nan=False, allow_infinity=False)
SMALL = Effort(points=40, nodes=1, draws=1 << 13, mutants=0)


@given(st.lists(FINITE, max_size=20))
def test_a_sum_is_exact_in_any_order_and_survives_a_file(values: list[float]):
    total = ExactSum.of(values)
    assert total.fraction == sum(map(Fraction, values), Fraction(0))
    assert total == ExactSum.of(values[::2]) + ExactSum.of(values[1::2])
    assert ExactSum.read(total.text()) == total


@pytest.mark.parametrize("value", [float("nan"), float("inf")])
def test_what_is_not_finite_is_no_summand(value: float):
    with pytest.raises(ValueError, match="finite"):
        ExactSum.of([value])


@pytest.fixture
def flint() -> None:
    """What the balls are made of."""
    pytest.importorskip("flint")


@pytest.mark.usefixtures("flint")
@pytest.mark.parametrize("name", ["polar.covariance.truth", "line.gradient", "observe.spherical.map"])
def test_balls_and_mpmath_measure_the_same_errors(name: str):
    quantity = catalogue()[name]
    function = compiled(quantity.expression, quantity.symbols)
    points = sample(quantity, 20, seed=3)
    found = errors(function, quantity, points, Balls), errors(function, quantity, points)
    np.testing.assert_allclose(*found, rtol=1e-6)


@pytest.mark.usefixtures("flint")
def test_the_installed_balls_keep_their_digits():
    assert trustworthy()


@pytest.mark.usefixtures("flint")
def test_balls_that_lose_digits_are_not_trusted(monkeypatch: pytest.MonkeyPatch):
    exact = balls._precision
    monkeypatch.setattr(balls, "_precision", lambda _: exact(53))
    trustworthy.cache_clear()
    try:
        assert not trustworthy()
    finally:
        trustworthy.cache_clear()


def test_without_balls_mpmath_measures(monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setattr(balls, "trustworthy", lambda: False)
    assert exact_arithmetic()[0] == "mpmath"


def test_the_search_finds_worse_points_than_chance():
    quantity = catalogue()["polar.map"]
    right = compiled(quantity.expression, quantity.symbols)

    def wrong_nearby(r: np.ndarray, beta: np.ndarray) -> np.ndarray:
        near = np.exp(-(((np.log(r) - 9) / 0.5) ** 2) - ((beta - 1) / 0.2) ** 2)
        return right(r=r, beta=beta) * (1 + 1e-12 * near)[..., np.newaxis]

    outcome = Accuracy(points=400)(quantity, wrong_nearby)
    before = re.search(r"points, (\S+) ulp before the search", outcome.detail)
    assert outcome.verdict is Verdict.FAILED
    assert before is not None
    assert outcome.figure is not None
    assert outcome.figure > 3 * float(before[1])


EXAMPLES = ["polar.jacobian", "polar.bias.averaged", "polar.unbiased.covariance", "ruv.bias.truth.fourth_order"]
EXAMPLES += [
    "line.slope",
    "line.gradient",
    "fusion.matrix_weights.two",
    "motion.constant_jerk.process_noise.continuous",
]
EXAMPLES += ["taylor.mean_shift", "spherical.std.linear", "finite_sample.degree2.range_rate.at_lag.covariance"]
EXAMPLES += ["observe.polar.jacobian", "finite_sample.degree1.range_rate.covariance", "polar.covariance.second_order"]


@pytest.mark.parametrize("name", EXAMPLES)
def test_every_mutant_is_caught_by_other_layers_than_monte_carlo(name: str):
    found = mutants.caught(catalogue()[name], 10, seed=1)
    assert len(found) > 6
    assert [each.mutant for each in found if not each.derivation or not each.code] == []


def test_mutants_are_of_every_kind_and_none_is_the_formula_itself():
    quantity = catalogue()["polar.covariance.truth"]
    found = mutants_of(quantity, 60, seed=0)
    kinds = {"sign", "coefficient", "exponent", "sine and cosine", "symbol swap", "dropped term", "transposed index"}
    assert kinds <= {mutant.kind for mutant in found}
    assert all(mutant.entries != quantity.expression for mutant in found)


class Interrupted:
    """An engine that is stopped after some tasks."""

    def __init__(self, after: int) -> None:
        self.after = after

    def run(self, tasks: Iterable[tuple[int, Any]]) -> Results:
        for done, result in enumerate(Local(1).run(tasks)):
            if done == self.after:
                raise KeyboardInterrupt
            yield result


def test_a_run_that_was_interrupted_goes_on_and_ends_with_the_same_record(tmp_path: Path):
    names = ["polar.bias.truth", "line.slope"]
    whole = Campaign(names, SMALL).run(Local(1), lambda *_: None)
    path = tmp_path / "checkpoint.jsonl"
    with pytest.raises(KeyboardInterrupt):
        Campaign(names, SMALL, path).run(Interrupted(after=5), lambda *_: None)
    with path.open("a") as file:
        file.write('{"digest": "cut sh')
    assert len(path.read_text().splitlines()) == 6
    steps: list[str] = []
    campaign = Campaign(names, SMALL, path)
    resumed = campaign.run(Local(1), lambda name, _: steps.append(name))
    assert resumed == whole
    assert steps.count("done before") == 5
    assert path.exists()  # until what was found is told
    campaign.kept.finish()
    assert not path.exists()


def test_a_checkpoint_of_other_settings_is_not_used(tmp_path: Path):
    path = tmp_path / "checkpoint.jsonl"
    path.write_text(json.dumps({"digest": "another", "key": "line.slope/ulp", "result": {}}) + "\n")
    steps: list[str] = []
    Campaign(["line.slope"], SMALL, path).run(Local(1), lambda name, _: steps.append(name))
    assert "done before" not in steps


def command(*arguments: str, cwd: Path) -> subprocess.CompletedProcess[str]:
    call = [sys.executable, "-c", "from radartrack.cli import app; app()", "verify", *arguments]
    environment = os.environ | {"COLUMNS": "160"}
    return subprocess.run(call, capture_output=True, text=True, check=False, cwd=cwd, env=environment)


def test_the_command_writes_a_record_and_shows_a_table(tmp_path: Path):
    done = command("polar.map", "--points", "40", "--workers", "1", "--json", "record.json", cwd=tmp_path)
    assert (done.returncode, done.stderr) == (0, "")
    assert "polar.map" in done.stdout
    record = json.loads((tmp_path / "record.json").read_text())
    assert record["effort"]["seed"] == 0
    assert {"numpy", "python", "radartrack"} <= record["versions"].keys()
    (function,) = record["functions"]
    layers = {layer["layer"]: layer for layer in function["layers"]}
    assert layers.keys() == {"dimensions", "identity", "rounding", "ulp", "quadrature", "Monte Carlo"}
    assert layers["ulp"]["figure"] <= layers["ulp"]["bound"]
    assert layers["Monte Carlo"]["verdict"] == "not applicable"
    assert list(tmp_path.iterdir()) == [tmp_path / "record.json"]


@pytest.mark.parametrize(
    ("arguments", "said"),
    [(["nonsense.name"], "nonsense.name"), (["polar.map", "--engine", "dask"], "--scheduler")],
)
def test_the_command_says_what_it_cannot_do(arguments: list[str], said: str, tmp_path: Path):
    done = command(*arguments, cwd=tmp_path)
    assert done.returncode == 2
    assert said in done.stderr
