"""Blocks and threads change nothing but the time."""

import numpy as np
import pytest

from radartrack import batches, convert


def cubes(values: np.ndarray, factor: np.ndarray, out: np.ndarray) -> None:
    out[:, 0] = factor * values**3
    out[:, 1] = values


@pytest.mark.parametrize("size", [0, 1, batches.BLOCK, batches.BLOCK + 1, batches.THREADED_FROM + 17])
def test_every_entry_is_filled_once(size: int) -> None:
    values, out = np.linspace(-1, 1, size), np.full((size, 2), np.nan)
    batches.fill(cubes, [values, np.array(3.0)], [out])
    np.testing.assert_array_equal(out, np.stack([3 * values**3, values], axis=-1))


def test_an_error_in_a_block_reaches_the_caller() -> None:
    def fails(values: np.ndarray, out: np.ndarray) -> None:
        raise FloatingPointError(f"{len(values)} {len(out)}")

    size = batches.THREADED_FROM
    with pytest.raises(FloatingPointError, match=str(batches.BLOCK)):
        batches.fill(fails, [np.zeros(size)], [np.zeros(size)])


@pytest.mark.parametrize("azimuth_from", ["x", "y"])
def test_a_plot_converts_to_the_same_bits_alone_and_in_a_large_batch(
    azimuth_from: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("radartrack.compiled.is_available", lambda: False)
    size = batches.THREADED_FROM + 5
    generator = np.random.default_rng(1)
    ranges, azimuths = generator.uniform(1e3, 1e5, size), generator.uniform(-3, 3, size)
    deviations = generator.uniform(1e-3, 0.2, size)
    whole = convert.polar(ranges, azimuths, 50.0, deviations, 0.3, azimuth_from=azimuth_from)
    for n in (0, batches.BLOCK - 1, batches.BLOCK, size - 1):
        alone = convert.polar(ranges[n], azimuths[n], 50.0, deviations[n], 0.3, azimuth_from=azimuth_from)
        np.testing.assert_array_equal(whole.mean[n], alone.mean)
        np.testing.assert_array_equal(whole.covariance[n], alone.covariance)
