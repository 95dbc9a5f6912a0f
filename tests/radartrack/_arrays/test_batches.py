"""Blocks and threads change nothing but the time."""

import subprocess
import sys
import threading
import time
import tracemalloc
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest

from radartrack._arrays import batches
from radartrack._conversion.sensors import SENSORS, SensorName
from tests.radartrack.plots import function, prediction


def cubes(values: np.ndarray, out: np.ndarray) -> None:
    out[:, 0] = values**3
    out[:, 1] = values


@pytest.mark.parametrize("size", [0, 1, batches.BLOCK, 3 * batches.BLOCK + 17])
def test_every_entry_is_filled_once(size: int) -> None:
    values, out = np.linspace(-1, 1, size), np.full((size, 2), np.nan)
    batches.fill(cubes, [values], [out])
    np.testing.assert_array_equal(out, np.stack([values**3, values], axis=-1))


def test_an_error_in_a_block_reaches_the_caller() -> None:
    def fails(values: np.ndarray, out: np.ndarray) -> None:
        raise FloatingPointError(f"{len(values)} {len(out)}")

    size = 3 * batches.BLOCK
    with pytest.raises(FloatingPointError, match=r"^(\d+) \1$"):
        batches.fill(fails, [np.zeros(size)], [np.zeros(size)])


def test_an_error_in_one_block_of_many_reaches_the_caller() -> None:
    def fails(values: np.ndarray, out: np.ndarray) -> None:
        out[0] = values[0]
        if values[0] == 9:
            raise FloatingPointError("nine")

    for _ in range(20):  # by any of the threads
        with pytest.raises(FloatingPointError, match="nine"):
            batches.fill(fails, [np.arange(16.0)], [np.zeros(16)], block=1)


@pytest.mark.parametrize("fails", [False, True])
def test_what_an_older_thread_has_begun_is_waited_for_where_a_new_one_is_refused(
    monkeypatch: pytest.MonkeyPatch, *, fails: bool
) -> None:
    """An executor hands work over, and then says that it can start no thread."""

    class Refused:
        def submit(self, run: Callable[[], None]) -> None:
            threading.Thread(target=run).start()
            time.sleep(0.05)  # it has begun
            raise RuntimeError("can't start new thread")

    def fill_slowly(numbers: np.ndarray) -> None:
        if threading.current_thread() is not threading.main_thread():
            time.sleep(0.3)
            if fails:
                raise ValueError("late")
        numbers += 1.0

    monkeypatch.setattr(batches, "_most_at_once", lambda: 2)
    monkeypatch.setattr(batches, "_threads", Refused)
    filled = np.zeros(4 * batches.BLOCK)
    if fails:
        with pytest.raises(ValueError, match="late"):
            batches.fill(fill_slowly, [], [filled])
    else:
        batches.fill(fill_slowly, [], [filled])
        assert np.all(filled == 1.0)


def test_blocks_may_be_filled_in_blocks(monkeypatch: pytest.MonkeyPatch) -> None:
    """With one thread to help, which waits for blocks of its own while its own help is asked for."""
    helper = ThreadPoolExecutor(1)
    monkeypatch.setattr(batches, "_threads", lambda: helper)
    monkeypatch.setattr(batches, "_most_at_once", lambda: 2)

    def rows(values: np.ndarray, out: np.ndarray) -> None:
        time.sleep(1e-3)
        batches.fill(np.square, [values[0]], [out[0]], block=1)

    values, out = np.arange(3200.0).reshape(64, 50), np.empty((64, 50))
    batches.fill(rows, [values], [out], block=1)
    np.testing.assert_array_equal(out, values**2)
    helper.shutdown()


FORKED = """
import os, numpy as np
from radartrack._arrays.batches import fill

def squared():
    out = np.empty(99)
    fill(np.square, [np.arange(99.0)], [out], block=1)
    return (out == np.arange(99.0) ** 2).all()

assert squared()
child = os.fork() if hasattr(os, "fork") else -1
if not child:
    os._exit(0 if squared() else 1)
assert child < 0 or os.waitpid(child, 0)[1] == 0
"""


def test_a_forked_process_has_threads_of_its_own() -> None:
    subprocess.run([sys.executable, "-W", "ignore", "-c", FORKED], check=True)


BISTATIC = np.array([3e5, 2.2]), np.array([[1600.0, 1.0], [1.0, 0.01]])  # a prediction that keeps off the baseline
SIZE = 2 * batches.BLOCK + 5  # plots, in three blocks or a few more


def plots(sensor: SensorName) -> list[np.ndarray]:
    generator = np.random.default_rng(1)
    between = {
        "r": (1e3, 1e5),
        "path": (3e4, 1e6),
        "baseline": (1, 2e4),
        "azimuth": (-3, 3),
        "elevation": (-1, 1),
        "range_rate": (-300, 300),
        "u": (-0.5, 0.5),
        "v": (-0.5, 0.5),
        "range_std": (1, 60),
        "path_std": (1, 60),
        "azimuth_std": (1e-3, 0.2),
        "elevation_std": (1e-3, 0.2),
        "range_rate_std": (0.1, 9),
        "u_std": (1e-4, 5e-3),
        "v_std": (1e-4, 5e-3),
        "correlation": (-0.9, 0.9),
    }
    return [generator.uniform(*between[name], SIZE) for name in SENSORS[sensor].arguments]


@pytest.mark.parametrize("azimuth_from", ["x", "y"])
def test_a_plot_converts_to_the_same_bits_in_a_small_and_in_a_large_batch(
    azimuth_from: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("radartrack._arrays.machine_code.is_available", lambda: False)
    arrays = plots("polar")
    whole = function("polar")(*arrays, azimuth_from=azimuth_from)
    ends = {SIZE * part // 12 for part in range(1, 13)}
    for n in (0, *ends - {SIZE}, *(end - 1 for end in ends)):
        few = function("polar")(*(array[n : n + 1] for array in arrays), azimuth_from=azimuth_from)
        np.testing.assert_array_equal(whole.mean[n : n + 1], few.mean)
        np.testing.assert_array_equal(whole.covariance[n : n + 1], few.covariance)


@pytest.mark.parametrize("shared", [True, False])
@pytest.mark.parametrize("sensor", SENSORS)
def test_predictions_are_taken_plot_by_plot_in_blocks(
    sensor: SensorName, shared: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Blocks of seven: the same as in one block, for one prediction or one for each plot."""
    arrays = [array[:23] for array in plots(sensor)]
    mean, matrix = BISTATIC if sensor == "bistatic" else prediction(sensor)
    if not shared:
        factors = np.random.default_rng(2).uniform(0.5, 1, 23)
        mean, matrix = mean * factors[:, np.newaxis], matrix * factors[:, np.newaxis, np.newaxis]
    whole = function(sensor)(*arrays, method="decorrelated", predicted=(mean, matrix))
    monkeypatch.setattr("radartrack._conversion.many_plots.PREDICTED_BLOCK", 7)
    blocks = function(sensor)(*arrays, method="decorrelated", predicted=(mean, matrix))
    np.testing.assert_array_equal(blocks.mean, whole.mean)
    np.testing.assert_allclose(blocks.covariance, whole.covariance, rtol=1e-13)


@pytest.mark.parametrize("method", ["unbiased", "decorrelated"])
@pytest.mark.parametrize(
    ("name", "value", "message"),
    [
        ("r", -1.0, r"r must be from 0 .*; got -1.0 at \[19\], the first of 2 among 23$"),
        ("azimuth_std", np.nan, r"azimuth_std must be finite; got nan at \[19\], the first of 2 among 23$"),
    ],
)
def test_what_is_refused_in_a_late_block_is_named_by_its_place_in_the_whole(
    method: str, name: str, value: float, message: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    for block in ("BLOCK", "PREDICTED_BLOCK"):
        monkeypatch.setattr(f"radartrack._conversion.many_plots.{block}", 7)
    given = dict(zip(SENSORS["polar"].arguments, (array[:23] for array in plots("polar")), strict=True))
    given[name][[19, 22]] = value
    chosen = {"predicted": prediction("polar")} if method == "decorrelated" else {}
    with pytest.raises(ValueError, match=message):
        function("polar")(**given, method=method, **chosen)


def test_a_prediction_refused_in_a_late_block_is_named_by_its_place_in_the_whole(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr("radartrack._conversion.many_plots.PREDICTED_BLOCK", 7)
    mean, matrix = prediction("polar")
    matrices = np.tile(matrix, (23, 1, 1))
    matrices[19, 0, 0] = -1
    with pytest.raises(ValueError, match=r"predicted covariance must be without a negative .* at \[19\]"):
        function("polar")(*(a[:23] for a in plots("polar")), method="decorrelated", predicted=(mean, matrices))


@pytest.mark.parametrize("method", ["unbiased", "decorrelated"])
def test_a_conversion_takes_little_memory_beside_its_result(method: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """In small blocks of one thread, as a share of a result that is small too."""
    monkeypatch.setattr("radartrack._arrays.machine_code.is_available", lambda: False)
    monkeypatch.setattr("radartrack._arrays.batches.MOST_THREADS", 1)
    for block in ("BLOCK", "PREDICTED_BLOCK"):
        monkeypatch.setattr(f"radartrack._conversion.many_plots.{block}", 64)
    arrays, (mean, matrix) = [array[:40_000] for array in plots("polar")], prediction("polar")
    each = (np.tile(mean, (40_000, 1)), np.tile(matrix, (40_000, 1, 1)))
    chosen = {"predicted": each} if method == "decorrelated" else {}
    function("polar")(*arrays, method=method, **chosen)  # loads modules
    tracemalloc.start()
    result = function("polar")(*arrays, method=method, **chosen)
    _, most = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert most < 1.15 * sum(part.nbytes for part in result)
