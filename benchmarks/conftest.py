"""What the benchmarks share: plots of a radar, and how many items a timing stands for."""

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Run = Callable[..., Any]
PLOTS = 1_000_000


@pytest.fixture(scope="session")
def plots() -> dict[str, Floats]:
    """A million plots with deviations of their own."""
    generator = np.random.default_rng(0)
    return {
        "r": generator.uniform(1e3, 1e5, PLOTS),
        "azimuth": generator.uniform(-3.0, 3.0, PLOTS),
        "elevation": generator.uniform(-1.0, 1.0, PLOTS),
        "range_rate": generator.uniform(-300.0, 300.0, PLOTS),
        "range_std": generator.uniform(10.0, 100.0, PLOTS),
        "azimuth_std": generator.uniform(1e-3, 2e-2, PLOTS),
        "elevation_std": generator.uniform(1e-3, 2e-2, PLOTS),
        "range_rate_std": generator.uniform(0.5, 5.0, PLOTS),
    }


@pytest.fixture
def timed(benchmark: Any) -> Callable[..., Any]:
    """Time a call; `items` is how many plots, tracks or samples it does, by which tables divide."""

    def run(function: Run, *arguments: Any, items: int, rounds: int = 5, **options: Any) -> Any:
        benchmark.extra_info["items"] = items
        return benchmark.pedantic(function, arguments, options, rounds=rounds, warmup_rounds=1)

    return run
