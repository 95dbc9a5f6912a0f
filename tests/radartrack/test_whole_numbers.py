"""Counts, degrees and seeds: every type of whole number is one, and a bool is none, wherever one is asked for."""

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from radartrack import FiniteSampleFilter, VarianceTable, consistency, frames, kalman, line, simulate
from radartrack._arrays.validation import whole_number
from radartrack.finite_sample_experiment import compare, radial_radar
from radartrack.simulate import Radar, Straight

POLAR = {"range_std": 1.0, "azimuth_std": 0.1}
RADAR, TARGET = Radar("polar", 1.0, POLAR), Straight((1e3, 2e3), (1.0, 2.0))
FILTER, RANGES = FiniteSampleFilter(10.0, 250.0, 15.0), np.array([3.0, 4.0, 6.0, 5.0])
RATES = np.array([0.1, 0.2, 0.3, 0.1])
PLOT = {"r": 1e3, "azimuth": 0.3, **POLAR}


def measured(**arguments: Any) -> Any:
    return simulate.plots(TARGET, RADAR, **{"scans": 2, **arguments}).measured["r"]


WANTED: dict[str, Callable[[Any], Any]] = {
    "degree": lambda given: FiniteSampleFilter(10.0, 250.0, 15.0, given).covariance(5),
    "k": FILTER.covariance,
    "k of weights": lambda given: FILTER.weights(given).ranges,
    "k of kalman": lambda given: FILTER.kalman(given).run(RANGES, RATES).state,
    "window": lambda given: FILTER.run(RANGES, RATES, window=given).state,
    "degree of a motion": lambda given: kalman.polynomial_motion(given, 1.0, 1.0).transition,
    "components": lambda given: frames.enu(0.1, 0.2).jacobian(frames.ECEF, given),
    "scans": lambda given: measured(scans=given),
    "scans of times": RADAR.times,
    "trials": lambda given: measured(trials=given),
    "seed": lambda given: measured(seed=given),
    "iterations": lambda given: line.fit(RANGES, RATES, method="reweighted", max_iterations=given).slope,
    "sectors": lambda given: VarianceTable.empty([0.0, 1e5], given).range_edges,
    "seed of a pair": lambda given: measured(seed=(1, given)),
    "draws": lambda given: consistency.experiment("polar", PLOT, draws=given).bias,
    "seed of draws": lambda given: consistency.experiment("polar", PLOT, draws=9, seed=given).bias,
    "trials compared": lambda given: compare(radial_radar(250.0, 15.0, 10.0), scans=3, trials=given).with_rate.measured,
}
TYPES = [np.int8, np.uint8, np.int16, np.int32, np.uint32, np.int64, np.uint64, np.array]


@pytest.mark.parametrize("kind", TYPES, ids=lambda kind: kind.__name__)
@pytest.mark.parametrize("call", WANTED.values(), ids=WANTED)
def test_every_type_of_whole_number_is_taken_as_the_int_that_it_is(call: Callable[[Any], Any], kind: Any) -> None:
    assert np.array_equal(call(kind(3)), call(3), equal_nan=True)


NO_WHOLE_NUMBERS = [True, np.True_, 3.0, np.float64(3), "3", [[3]], 3 + 0j, {}]


@pytest.mark.parametrize("given", NO_WHOLE_NUMBERS, ids=repr)
@pytest.mark.parametrize("call", WANTED.values(), ids=WANTED)
def test_what_is_no_whole_number_is_refused_by_name(call: Callable[[Any], Any], given: Any) -> None:
    with pytest.raises(TypeError, match=r"^\w+ must be a whole number; got "):
        call(given)


def test_a_whole_number_lies_within_its_bounds() -> None:
    assert [whole_number("n", n, 1, 3) for n in (1, np.int64(3))] == [1, 3]
    assert type(whole_number("n", np.int64(3), 1)) is int
    for n in (0, np.int64(4), 10**5000, -(10**5000)):
        with pytest.raises(ValueError, match=r"^n must be from 1 to 3; got "):
            whole_number("n", n, 1, 3)
    with pytest.raises(ValueError, match=r"^n must be at least 2; got 1"):
        whole_number("n", 1, 2)
