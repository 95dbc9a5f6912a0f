"""Compiled conversions: the same results as NumPy, within the rounding that both are allowed."""

from typing import Any

import numpy as np
import pytest

from radartrack import convert
from radartrack._arrays import machine_code
from radartrack.convert import Converted
from tests.radartrack.plots import COORDINATES, DEVIATIONS, OF_THE_PLOT, SENSORS

SIZE = machine_code.COMPILED_FROM + 3


def plots(seed: int) -> dict[str, np.ndarray]:
    generator = np.random.default_rng(seed)
    return {
        "r": generator.uniform(1e3, 1e5, SIZE),
        "azimuth": generator.uniform(-3, 3, SIZE),
        "elevation": generator.uniform(-1, 1, SIZE),
        "range_rate": generator.uniform(-300, 300, SIZE),
        "u": generator.uniform(-0.6, 0.6, SIZE),
        "v": generator.uniform(-0.6, 0.6, SIZE),
        "range_std": generator.uniform(1, 100, SIZE),
        "azimuth_std": 10 ** generator.uniform(-7, -0.5, SIZE),
        "elevation_std": 10 ** generator.uniform(-7, -0.5, SIZE),
        "range_rate_std": generator.uniform(0.1, 10, SIZE),
        "u_std": 10 ** generator.uniform(-7, -2, SIZE),
        "v_std": 10 ** generator.uniform(-7, -2, SIZE),
        "correlation": generator.uniform(-1, 1, SIZE),
    }


def both(monkeypatch: pytest.MonkeyPatch, sensor: str, *arguments: Any, **options: Any) -> tuple[Converted, Converted]:
    found = getattr(convert, sensor)(*arguments, **options)
    monkeypatch.setattr(machine_code, "is_available", lambda: False)
    return found, getattr(convert, sensor)(*arguments, **options)


def assert_same(found: Converted, expected: Converted) -> None:
    size = np.linalg.norm(expected.mean, axis=-1, keepdims=True)
    assert (np.abs(found.mean - expected.mean) <= 16 * np.spacing(size)).all()
    deviations = np.sqrt(np.diagonal(expected.covariance, axis1=-2, axis2=-1))
    scale = deviations[:, :, np.newaxis] * deviations[:, np.newaxis, :]
    assert (np.abs(found.covariance - expected.covariance) <= 32 * np.spacing(scale)).all()


@pytest.mark.parametrize("method", OF_THE_PLOT)
@pytest.mark.parametrize("sensor", SENSORS)
def test_every_conversion(monkeypatch: pytest.MonkeyPatch, sensor: str, method: str) -> None:
    given = plots(1)
    names = (*COORDINATES[sensor], *DEVIATIONS[sensor], "correlation")
    assert_same(*both(monkeypatch, sensor, *(given[name] for name in names), method=method))


def test_azimuths_from_the_other_axis(monkeypatch: pytest.MonkeyPatch) -> None:
    given = plots(6)
    arguments = [given[name] for name in ("r", "azimuth", "range_std", "azimuth_std", "correlation")]
    assert_same(*both(monkeypatch, "polar", *arguments, azimuth_from="y"))


def test_spherical_with_deviations_that_all_plots_share(monkeypatch: pytest.MonkeyPatch) -> None:
    given = plots(2)
    arguments = [*(given[name] for name in ("r", "azimuth", "elevation")), 30.0, 2e-3, 3e-3]
    assert_same(*both(monkeypatch, "spherical", *arguments))


def test_polar_beside_a_prediction(monkeypatch: pytest.MonkeyPatch) -> None:
    given = plots(5)
    arguments = [*(given[name] for name in ("r", "azimuth")), 30.0, 2e-3]
    predicted = (np.array([5e4, 0.5]), np.diag([900.0, 1e-4]))
    assert_same(*both(monkeypatch, "polar", *arguments, method="decorrelated", predicted=predicted))


def test_shapes_and_strides_are_free(monkeypatch: pytest.MonkeyPatch) -> None:
    given = plots(3)
    shape = (SIZE // 7 + 1, 7)
    ranges = np.resize(given["r"], shape[::-1]).T
    azimuths = np.linspace(-3, 3, shape[1])
    found, expected = both(monkeypatch, "polar", ranges, azimuths, 20.0, 1e-3)
    assert found.mean.shape == (*shape, 2)
    np.testing.assert_allclose(found.mean, expected.mean, rtol=1e-13)
    np.testing.assert_allclose(found.covariance, expected.covariance, rtol=1e-11)


def test_few_plots_and_single_precision_are_not_worth_a_compiler(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(machine_code, "conversion", lambda name, _: pytest.fail(f"{name} was compiled"))
    few = np.ones(machine_code.COMPILED_FROM - 1)
    assert convert.polar(few, few, few, few / 100).mean.shape == (*few.shape, 2)
    single = np.ones(SIZE, np.float32)
    assert convert.polar(single, single, single, single / 100).mean.dtype == np.float32


def test_without_numba_numpy_does_it(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(machine_code, "is_available", lambda: False)
    monkeypatch.setattr(machine_code, "conversion", lambda name, _: pytest.fail(f"{name} was compiled"))
    given = plots(4)
    assert convert.polar(given["r"], given["azimuth"], 10.0, 1e-3).mean.shape == (SIZE, 2)
