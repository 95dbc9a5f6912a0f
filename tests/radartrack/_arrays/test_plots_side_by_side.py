"""Several plots at once in machine code: the bits of the generated functions, on every processor; far angles."""

import os
import platform
import subprocess
import sys
from hashlib import sha256
from pathlib import Path

import numpy as np
import pytest

from radartrack import convert
from radartrack._arrays import machine_code
from radartrack.generated import elementary, loops
from radartrack.verification.elementary.elementary_campaign import over_arrays

numba = pytest.importorskip("numba")
side_by_side = pytest.importorskip("radartrack._arrays.plots_side_by_side")
SIZE = 1000
SIMPLEST = {"x86_64": "x86-64", "AMD64": "x86-64"}.get(platform.machine(), "generic")
PROCESSORS = os.environ.get("RADARTRACK_PROCESSORS", SIMPLEST).split()  # as LLVM calls them, of this machine's kind
DIGESTS = {"polar": "0ae500d1686fafcc", "spherical": "991d1985c60e01e8"}


def share(step: float) -> np.ndarray:
    """Numbers between 0 and 1 that no library has computed."""
    return (np.arange(1, SIZE + 1) * step) % 1.0


def digest(sensor: str) -> str:
    r, azimuth, range_std = 1e3 + 1e5 * share(0.618), 6.0 * share(0.414) - 3.0, 1.0 + 100.0 * share(0.732)
    azimuth_std = 1e-3 + 0.3 * share(0.236)
    if sensor == "polar":
        found = convert.polar(r, azimuth, range_std, azimuth_std, 0.3)
    else:
        elevation = 2.0 * share(0.646) - 1.0
        found = convert.spherical(r, azimuth, elevation, range_std, azimuth_std, azimuth_std / 2)
    return sha256(found.mean.astype("<f8").tobytes() + found.covariance.astype("<f8").tobytes()).hexdigest()[:16]


@pytest.mark.parametrize("sensor", DIGESTS)
def test_results_have_the_same_bits_on_every_processor(sensor: str):
    assert digest(sensor) == DIGESTS[sensor]


@pytest.mark.parametrize("processor", PROCESSORS)
def test_results_have_the_same_bits_compiled_for_another_processor(processor: str):
    module = "tests.radartrack._arrays.test_plots_side_by_side"
    program = f"from {module} import DIGESTS, digest; assert all(digest(s) == d for s, d in DIGESTS.items())"
    environment = os.environ | {"NUMBA_CPU_NAME": processor, "NUMBA_CPU_FEATURES": "", "PYTHONPATH": str(Path.cwd())}
    subprocess.run([sys.executable, "-c", program], check=True, env=environment)


@pytest.mark.parametrize("name", side_by_side.ELEMENTARY[1:])
def test_compiled_functions_have_the_bits_of_the_generated_ones(name: str):
    function = side_by_side.elementary_functions()[name]

    def loop(arguments: np.ndarray, results: np.ndarray) -> None:
        for i in range(len(arguments)):
            results[i] = function(arguments[i])

    arguments = np.append(2000.0 * share(0.618) - 1000.0, [0.0, 1e-300, -1e-9, 1e5, np.inf, -np.inf, np.nan])
    results = np.empty_like(arguments)
    numba.njit(error_model="numpy")(loop)(arguments, results)
    with np.errstate(all="ignore"):
        np.testing.assert_array_equal(results, over_arrays(name)(arguments))


def test_plots_at_angles_beyond_the_largest_are_converted_by_numpy(monkeypatch: pytest.MonkeyPatch):
    azimuths = np.linspace(-3.0, 3.0, SIZE)
    azimuths[SIZE // 2] = 2 * elementary.LARGEST_ANGLE
    found = convert.polar(5e4, azimuths, 20.0, 1e-3)
    monkeypatch.setattr(machine_code, "is_available", lambda: False)
    expected = convert.polar(5e4, azimuths, 20.0, 1e-3)
    np.testing.assert_array_equal(found.mean, expected.mean)
    np.testing.assert_array_equal(found.covariance, expected.covariance)


def test_every_plot_is_filled_alone_whatever_their_number_and_nothing_is_written_beside_them():
    """However far ahead memory is asked for."""
    filled = machine_code.conversion("polar_unbiased", 2)
    assert filled is not None
    arrays = [1e3 + 1e5 * share(0.618), 6.0 * share(0.414) - 3.0, 10.0 + share(0.732), 1e-3 + 0.3 * share(0.236)]
    whole_mean, whole_covariance = np.empty((SIZE, 2)), np.empty((SIZE, 2, 2))
    filled(*arrays, np.array(0.3), whole_mean, whole_covariance)
    for start, count in (
        (0, 0),
        (0, 1),
        (1, side_by_side.PLOTS - 1),
        (3, side_by_side.PLOTS + 1),
        (5, 200),
        (900, 100),
    ):
        some = slice(start, start + count)
        mean, covariance = np.full((SIZE + 2, 2), -7.0), np.full((SIZE + 2, 2, 2), -7.0)
        inside = slice(start + 1, start + 1 + count)
        filled(*(array[some] for array in arrays), np.array(0.3), mean[inside], covariance[inside])
        np.testing.assert_array_equal(mean[inside], whole_mean[some])
        np.testing.assert_array_equal(covariance[inside], whole_covariance[some])
        mean[inside], covariance[inside] = -7.0, -7.0
        assert np.all(mean == -7.0)
        assert np.all(covariance == -7.0)


def test_code_that_changed_is_not_taken_from_what_was_kept(monkeypatch: pytest.MonkeyPatch):
    before = side_by_side._digest(loops.polar_linear)
    monkeypatch.setattr(side_by_side, "PLOTS", 64)
    assert side_by_side._digest(loops.polar_linear) != before != side_by_side._digest(loops.polar_averaged)
