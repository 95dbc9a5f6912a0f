"""Monte Carlo: what it can see, how often it is wrong, and that nobody can tell who computed it."""

import json
import math
import random
from collections.abc import Iterable
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from radartrack.derive.catalogue import catalogue
from radartrack.derive.stable.quantity_form import form_of
from radartrack.verification.array_program import Program
from radartrack.verification.engines import Local
from radartrack.verification.layers.monte_carlo import MonteCarlo, comparisons
from radartrack.verification.outcome import Verdict
from radartrack.verification.program_compilation import compiled
from radartrack.verification.simulation import experiments
from radartrack.verification.simulation.draws import Draws, Sums, simulate
from radartrack.verification.simulation.experiments import Polynomial, Trial, trials
from radartrack.verification.simulation.statistics import Mean, threshold
from tests.processes import python

CHUNKS = 12


@cache
def right(name: str) -> Program:
    quantity = catalogue()[name]
    return compiled(form_of(quantity).expanded(), quantity.symbols)


@cache
def trial(name: str, seed: int = 0) -> Trial:
    return next(trials(catalogue()[name], right(name), seed))


def tasks() -> list[Draws]:
    return [Draws(trial("polar.covariance.averaged").experiment, range(n, n + 1)) for n in range(CHUNKS)]


def summed(results: Iterable[tuple[int, dict[str, Any]]]) -> dict[str, Any]:
    read = [Sums.read(record) for _, record in results]
    return sum(read[1:], read[0]).record()


@cache
def expected() -> dict[str, Any]:
    return simulate(trial("polar.covariance.averaged").experiment, range(CHUNKS)).record()


@pytest.mark.parametrize("workers", [1, 2, 8])
def test_any_number_of_processes_gives_the_same_bits(workers: int):
    assert summed(Local(workers).run(enumerate(tasks()))) == expected()


def test_the_order_in_which_chunks_end_changes_no_bit():
    shuffled = tasks()
    random.Random(1).shuffle(shuffled)
    assert summed(Local(1).run(enumerate(shuffled))) == expected()


LOSING_A_WORKER = """
import json, os, signal
from contextlib import suppress
from distributed import LocalCluster
from radartrack.verification.engines import Dask
from tests.radartrack.verification.simulation.test_draws import tasks

if __name__ == "__main__":
    results = []
    with (
        suppress(TimeoutError),  # on a busy machine its processes do not end in the time it gives them
        LocalCluster(n_workers=2, threads_per_worker=1, processes=True, dashboard_address=":0") as cluster,
    ):
        for result in Dask(cluster.scheduler_address).run(enumerate(tasks())):
            if not results:
                os.kill(next(iter(cluster.workers.values())).pid, signal.SIGKILL)
            results.append(result)
        print(json.dumps(results), flush=True)
"""


def test_dask_gives_the_same_bits_when_a_worker_is_killed_on_the_way(tmp_path: Path):
    pytest.importorskip("distributed")
    program = tmp_path / "program.py"  # a file, from which the workers can import what they are sent
    program.write_text(LOSING_A_WORKER)
    root = Path(__file__).parents[4]
    done = python(
        f"import runpy; runpy.run_path({str(program)!r}, run_name='__main__')", environment={"PYTHONPATH": str(root)}
    )
    results = json.loads(done.stdout)
    assert sorted(number for number, _ in results) == list(range(CHUNKS))
    assert summed(results) == expected()


def test_streams_of_functions_points_and_chunks_differ():
    quantity = catalogue()["polar.bias.truth"]
    first, second = trials(quantity, right(quantity.name), 0)
    other = trial("polar.posterior.estimate")
    totals = [simulate(t.experiment, [n]).powers for t in (first, second, other) for n in (0, 1)]
    assert len(set(totals)) == len(totals)


def test_the_mean_of_the_control_variate_is_exact():
    generator = np.random.default_rng(3)
    factor = generator.normal(size=(3, 3))
    curvature = generator.normal(size=(2, 3, 3))
    control = Polynomial(
        generator.normal(size=2), generator.normal(size=(2, 3)), curvature + np.swapaxes(curvature, 1, 2)
    )
    nodes, weights = np.polynomial.hermite_e.hermegauss(4)
    grid = np.stack(np.meshgrid(nodes, nodes, nodes), axis=-1).reshape(-1, 3)
    share = np.stack(np.meshgrid(weights, weights, weights), axis=-1).prod(axis=-1).ravel() / weights.sum() ** 3
    w = grid @ factor.T
    values = control.constant + w @ control.linear.T + 0.5 * np.einsum("ni,aij,nj->na", w, control.quadratic, w)
    covariance = factor @ factor.T
    np.testing.assert_allclose(control.means(covariance), share @ values, rtol=1e-12)
    np.testing.assert_allclose(
        control.second_moments(covariance), np.einsum("n,na,nb->ab", share, values, values), rtol=1e-12
    )


@pytest.mark.parametrize(
    ("name", "cut_off"),
    [("polar.posterior.estimate", "polar.map"), ("polar.covariance.truth", "polar.covariance.second_order")],
)
def test_what_the_second_order_leaves_out_is_noticed(name: str, cut_off: str):
    quantity, known = catalogue()[name], {symbol.name for symbol in catalogue()[cut_off].symbols}

    def second_order(**arguments: Any) -> np.ndarray:
        value = right(cut_off)(**{n: v for n, v in arguments.items() if n in known})
        return value + right("polar.bias.second_order")(**arguments) if cut_off == "polar.map" else value

    assert MonteCarlo(draws=1 << 20)(quantity, right(name)).verdict is Verdict.PASSED
    assert MonteCarlo(draws=1 << 20)(quantity, second_order).verdict is Verdict.FAILED


@pytest.mark.parametrize("name", ["polar.bias.truth", "polar.covariance.truth", "spherical.bias.averaged"])
def test_what_the_second_order_leaves_out_is_several_times_what_would_be_found(name: str):
    one = trial(name)
    found = comparisons(one, simulate(one.experiment, range(4)))
    assert max(c.beyond / c.detectable(experiments.tests_of_catalogue()) for c in found) > 4


SEEDS = 60
KOLMOGOROV = math.sqrt(math.log(2 / 1e-6) / 2)  # Massart: the distribution function is off by more once in a million


def test_p_values_of_correct_code_are_uniform():
    """False alarms: one in a million. A distribution function off by more than about 0.35 would be found."""
    found = []
    for seed in range(SEEDS):
        one = trial("polar.posterior.estimate", seed)
        sums = simulate(one.experiment, range(1))
        found.append(comparisons(one, sums)[0].mean.plain_p_value())
    ranked = np.sort(found)
    steps = np.arange(SEEDS + 1) / SEEDS
    distance = max(np.abs(ranked - steps[1:]).max(), np.abs(ranked - steps[:-1]).max())
    assert distance < KOLMOGOROV / math.sqrt(SEEDS)


def test_the_threshold_shares_the_false_alarms_between_all_tests():
    one, many = threshold(1), threshold(1000)
    assert math.erfc(one / math.sqrt(2)) == pytest.approx(1e-6, rel=1e-6)
    assert math.erfc(many / math.sqrt(2)) == pytest.approx(1e-9, rel=1e-6)


@pytest.mark.parametrize(("count", "z"), [(10, 2.0), (10, 3.0), (10, 3.5), (4000, 5.0)])
def test_the_corrected_tail_is_no_smaller_than_the_true_one_of_skewed_draws(count: int, z: float):
    """Means of exponential draws, whose tail is known: that of a gamma distribution."""
    mean = Mean(count, 0.0, 1.0, 2.0, 6.0)
    x = count + z * math.sqrt(count)
    tail = sum(math.exp(-x + n * math.log(x) - math.lgamma(n + 1)) for n in range(count))
    normal = math.erfc(z / math.sqrt(2)) / 2
    assert tail > normal
    assert normal * math.exp(mean.correction(z)) >= tail
