"""Files of plots beside what reading and writing alone takes; first states of a scan beside Stone Soup's."""

from collections.abc import Callable
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

import numpy as np
import pyarrow as pa
import pyarrow.parquet as pq
import pytest
from stonesoup.initiator.simple import SimpleMeasurementInitiator
from stonesoup.models.measurement.nonlinear import CartesianToElevationBearingRange
from stonesoup.types.detection import Detection
from stonesoup.types.state import GaussianState

from benchmarks.conftest import PLOTS, Floats
from radartrack.stone_soup import OnePlotInitiator
from radartrack.tables.parquet_stream import BATCH, convert_file
from radartrack.tables.plot_columns import PlotColumns

MEASURED = ("r", "azimuth", "elevation")
NOW = datetime(2026, 1, 1, tzinfo=UTC)
SCAN = 300
Timed = Callable[..., Any]


@pytest.fixture
def file(plots: dict[str, Floats], tmp_path: Path) -> Path:
    """Plots in Parquet, as pyarrow writes it."""
    pq.write_table(pa.table({name: plots[name] for name in MEASURED}), tmp_path / "plots.parquet")
    return tmp_path / "plots.parquet"


class TestParquet:
    """A million spherical plots, from file to file."""

    def test_radartrack(self, timed: Timed, file: Path) -> None:
        constants = {"range_std": 50.0, "azimuth_std": 0.01, "elevation_std": 0.01}
        chosen = PlotColumns.chosen("spherical", constants, None, "unbiased", None, "raise", "")
        timed(convert_file, file, file.with_name("out.parquet"), chosen, items=PLOTS)

    def test_copied(self, timed: Timed, file: Path) -> None:
        timed(copied, file, file.with_name("out.parquet"), items=PLOTS)


def copied(source: Path, target: Path) -> None:
    """Read the columns and write four times as many, as many as a conversion writes, and none computed."""
    reader = pq.ParquetFile(source)
    schema = pa.schema([(f"{name}{copy}", pa.float64()) for copy in range(4) for name in MEASURED])
    with pq.ParquetWriter(target, schema, compression="NONE", use_dictionary=False) as writer:
        for batch in reader.iter_batches(BATCH):
            writer.write_table(pa.Table.from_arrays(batch.columns * 4, schema=schema))


class TestOneScan:
    """The first states of 300 tracks."""

    def test_radartrack(self, timed: Timed) -> None:
        timed(OnePlotInitiator(prior()).initiate, scan(), NOW, items=SCAN)

    def test_stone_soup(self, timed: Timed) -> None:
        timed(SimpleMeasurementInitiator(prior()).initiate, scan(), NOW, items=SCAN)


def prior() -> GaussianState:
    return GaussianState(np.zeros((6, 1)), 1e4 * np.eye(6), timestamp=NOW)


def scan() -> set[Detection]:
    generator = np.random.default_rng(3)
    radar = CartesianToElevationBearingRange(6, (0, 2, 4), np.diag([0.01, 0.01, 50.0]) ** 2)
    vectors = generator.uniform([0.0, -3.0, 1e3], [1.0, 3.0, 1e5], (SCAN, 3))
    return {Detection(vector[:, np.newaxis], timestamp=NOW, measurement_model=radar) for vector in vectors}
