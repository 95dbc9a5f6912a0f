"""The table of variances: unbiased cells, merges in any order, files that are checked, lookups that fall back.

Monte Carlo checks fail by chance with a probability below 2e-9 each.
"""

import itertools
import math
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy import stats

from radartrack import VarianceTable, fusion, line
from radartrack.variance_table import Contributions, VarianceTableError

Array = NDArray[Any]
EDGES = [0.0, 20e3, 40e3, 60e3, 100e3]
SECTORS = 12
RANGE_STD, AZIMUTH_STD = 60.0, 0.004
CHANCE = 1e-9


def flight(course: float, offset: float, *, flights: int, seed: int, plots: int = 60) -> tuple[Array, Array, Array]:
    """Times, ranges and azimuths of noisy plots of flights past the radar."""
    generator = np.random.default_rng(seed)
    t = np.arange(plots) * 5.0
    along = 200.0 * (t - t.mean())
    east = along * np.sin(course) + offset * np.cos(course)
    north = along * np.cos(course) - offset * np.sin(course)
    shape = (flights, plots)
    r = np.hypot(east, north) + generator.normal(0.0, RANGE_STD, shape)
    return t, r, np.arctan2(east, north) + generator.normal(0.0, AZIMUTH_STD, shape)


def filled(seed: int = 0, flights: int = 40) -> VarianceTable:
    table = VarianceTable.empty(EDGES, SECTORS)
    for number, (course, offset) in enumerate(itertools.product((0.3, 2.0, 4.0), (15e3, -35e3, 70e3))):
        table = table.with_flights(*flight(course, offset, flights=flights, seed=seed + number))
    return table


def test_degrees_of_freedom_of_a_flight_sum_to_the_plots_less_two() -> None:
    table = VarianceTable.empty(EDGES, SECTORS).with_flights(*flight(0.3, 15e3, flights=7, seed=1))
    assert table.degrees_of_freedom().sum() == pytest.approx(7 * 58)
    assert np.count_nonzero(table.degrees_of_freedom()) > 5


def test_the_sums_of_squares_are_those_of_the_residuals() -> None:
    t, r, azimuth = flight(0.3, 15e3, flights=1, seed=1)
    table = VarianceTable.empty(EDGES, SECTORS).with_flights(t, r, azimuth)
    x, y = line.to_plane(r[0], azimuth[0])
    squares = sum(np.sum((c - np.polyval(np.polyfit(t, c, 1), t)) ** 2) for c in (x, y))
    sums = table.covariance() * table.degrees_of_freedom()[..., np.newaxis, np.newaxis]
    assert np.nansum(np.trace(sums, axis1=-2, axis2=-1)) == pytest.approx(squares)


def test_cells_estimate_the_variances_along_and_across_the_line_of_sight() -> None:
    """Courses at constant range and azimuth noise in each cell: plots across 3 km of range at 50 km.

    About 5800 degrees of freedom in a cell: an error of 11 % of a variance is detected.
    """
    generator = np.random.default_rng(8)
    t, distance = np.arange(60) * 5.0, 50e3
    east = 20.0 * (t - t.mean())
    r = np.hypot(east, distance) + generator.normal(0.0, RANGE_STD, (100, 60))
    azimuth = np.arctan2(east, distance) + generator.normal(0.0, AZIMUTH_STD, (100, 60)) + 0.3
    table = VarianceTable.empty(EDGES, SECTORS).with_flights(t, r, azimuth)
    assert table.degrees_of_freedom()[2, 0] == pytest.approx(5800)
    low, high = stats.chi2.ppf([CHANCE, 1 - CHANCE], 5800) / 5800
    along, across = np.diag(table.covariance()[2, 0])
    assert low < along / RANGE_STD**2 < high
    assert low < across / (distance * AZIMUTH_STD) ** 2 < high


def test_tables_merge_in_any_order_to_exactly_the_same_numbers() -> None:
    parts = [
        VarianceTable.empty(EDGES, SECTORS).with_flights(*flight(course, offset, flights=5, seed=seed), label=label)
        for seed, (course, offset, label) in enumerate(
            [(0.3, 15e3, "winter"), (2.0, 30e3, ""), (0.3, 15e3, "winter"), (5.0, -60e3, "winter")]
        )
    ]
    merged = [first.merged(*rest) for first, *rest in itertools.permutations(parts)]
    stepwise = parts[0].merged(parts[1]).merged(parts[2].merged(parts[3]))
    for table in [*merged, stepwise]:
        assert table.labels == ("", "winter")
        for label in table.labels:
            assert np.array_equal(table.covariance(label), merged[0].covariance(label), equal_nan=True)
            assert np.array_equal(table.degrees_of_freedom(label), merged[0].degrees_of_freedom(label))


def test_labels_are_kept_apart() -> None:
    table = VarianceTable.empty(EDGES, SECTORS).with_flights(*flight(0.3, 15e3, flights=2, seed=1), label="rain")
    assert table.degrees_of_freedom("rain").sum() > 0
    assert table.degrees_of_freedom("snow").sum() == 0
    assert np.isnan(table.covariance("snow")).all()


def test_tables_with_other_cells_do_not_merge() -> None:
    with pytest.raises(ValueError, match="same cells"):
        filled(flights=1).merged(VarianceTable.empty(EDGES, 8))


# Lookups

FALLBACK = np.array([[4.0, 1.0], [1.0, 9.0]])


def test_an_empty_table_leaves_all_to_the_fallback() -> None:
    found = VarianceTable.empty(EDGES, SECTORS).lookup([1e3, 5e4], 1.0, FALLBACK)
    assert found.share.tolist() == [0.0, 0.0]
    assert np.array_equal(found.covariance, np.stack([FALLBACK] * 2))


def uniform(radial: float, transverse: float) -> VarianceTable:
    """A table with the same covariance in all cells, each with a hundred degrees of freedom."""
    cells = np.arange((len(EDGES) - 1) * SECTORS)
    alike = np.full(cells.size, 100.0)
    contributions = Contributions(
        np.full(cells.size, ""),
        cells // SECTORS,
        cells % SECTORS,
        alike,
        radial * alike,
        0 * alike,
        transverse * alike,
    )
    return VarianceTable(np.array(EDGES), SECTORS, contributions)


@pytest.mark.parametrize("azimuth", [0.0, 0.7, np.pi, -0.01, 2 * np.pi - 1e-9, -9.3])
def test_a_uniform_table_gives_its_covariance_turned_to_every_azimuth(azimuth: float) -> None:
    found = uniform(100.0, 2500.0).lookup([5e3, 33e3, 99e3], azimuth, FALLBACK)
    toward = np.array([np.sin(azimuth), np.cos(azimuth)])
    across = np.array([np.cos(azimuth), -np.sin(azimuth)])
    expected = 100.0 * np.outer(toward, toward) + 2500.0 * np.outer(across, across)
    assert found.share == pytest.approx(1.0)
    assert found.covariance == pytest.approx(np.stack([expected] * 3))


def test_lookups_are_exact_at_centres_and_linear_between_them_across_north() -> None:
    table = filled()
    counts, cells = table.degrees_of_freedom(), table.covariance()
    thin = counts < 30
    centres, width = (np.array(EDGES[:-1]) + np.array(EDGES[1:])) / 2, 2 * np.pi / SECTORS
    checked = 0
    for i, j in itertools.product(range(len(centres)), range(SECTORS)):
        following = (j + 1) % SECTORS
        if thin[i, j] or thin[i, following]:
            continue
        for part in (0.0, 0.25, 1.0):
            azimuth = (j + 0.5 + part) * width
            found = table.lookup(centres[i], azimuth, FALLBACK).covariance
            mixed = (1 - part) * cells[i, j] + part * cells[i, following]
            assert np.trace(found) == pytest.approx(np.trace(mixed))
            toward = np.array([np.sin(azimuth), np.cos(azimuth)])
            assert toward @ found @ toward == pytest.approx(mixed[0, 0])
        checked += following in {0, 6}
    assert checked


def test_thin_cells_and_ranges_beyond_the_table_leave_their_share_to_the_fallback() -> None:
    table = filled()
    r, azimuth = np.meshgrid(np.linspace(0.0, 120e3, 50), np.linspace(-4.0, 4.0, 41))
    found = table.lookup(r, azimuth, FALLBACK)
    assert np.all((found.share >= 0) & (found.share <= 1))
    assert np.all(found.share[r > 100e3] == 0)
    assert 0 < np.mean((found.share > 0) & (found.share < 1)) < 1
    strict = table.lookup(r, azimuth, FALLBACK, minimum_degrees=math.inf)
    assert np.array_equal(strict.covariance, np.broadcast_to(FALLBACK, (*r.shape, 2, 2)))
    eigenvalues = np.linalg.eigvalsh(found.covariance)
    assert eigenvalues.min() > 0


def test_a_table_of_true_errors_agrees_with_error_propagation() -> None:
    """Within what interpolation between bins of 20 km and 30 degrees costs: 30 % of a variance."""
    table = filled(flights=400)
    r, azimuth = np.array([30e3, 50e3, 36e3]), np.array([0.3, 2.4, 5.3])
    propagated = fusion.propagated_covariance(r, azimuth, RANGE_STD, AZIMUTH_STD)
    found = table.lookup(r, azimuth, propagated)
    kept = found.share > 0.9
    assert kept.any()
    assert np.trace(found.covariance[kept], axis1=-2, axis2=-1) == pytest.approx(
        np.trace(propagated[kept], axis1=-2, axis2=-1), rel=0.3
    )


# Files


def test_a_saved_table_is_loaded_as_it_was_and_goes_on_accumulating(tmp_path: Path) -> None:
    table = filled().merged(
        VarianceTable.empty(EDGES, SECTORS).with_flights(*flight(1.0, 5e3, flights=2, seed=3), label="Föhn")
    )
    table.save(tmp_path / "table")
    loaded = VarianceTable.load(tmp_path / "table")
    more = flight(1.0, 5e3, flights=2, seed=4)
    for before, after in ((table, loaded), (table.with_flights(*more), loaded.with_flights(*more))):
        assert after.labels == before.labels
        for label in before.labels:
            assert np.array_equal(after.covariance(label), before.covariance(label), equal_nan=True)


def test_the_same_flights_give_the_same_file_in_any_order(tmp_path: Path) -> None:
    parts = [VarianceTable.empty(EDGES, SECTORS).with_flights(*flight(0.3, 15e3, flights=3, seed=s)) for s in (1, 2)]
    parts[0].merged(parts[1]).save(tmp_path / "a")
    parts[1].merged(parts[0]).save(tmp_path / "b")
    assert (tmp_path / "a").read_bytes() == (tmp_path / "b").read_bytes()


def stored(path: Path) -> dict[str, NDArray[Any]]:
    with np.load(path) as archive:
        return dict(archive)


def resaved(path: Path, columns: dict[str, NDArray[Any]]) -> None:
    with path.open("wb") as file:
        np.savez(file, **dict[str, Any](columns))


def forge(change: Callable[[dict[str, NDArray[Any]]], None]) -> Callable[[Path], None]:
    """A change of the stored columns, with a checksum that fits it."""

    def forged(path: Path) -> None:
        from radartrack import variance_table  # noqa: PLC0415

        columns = stored(path)
        change(columns)
        columns["digest"] = np.array(variance_table._digest(columns))
        resaved(path, columns)

    return forged


def edit(name: str, value: object) -> Callable[[Path], None]:
    """A change of one column, the checksum left alone."""
    return lambda path: resaved(path, stored(path) | {name: np.asarray(value)})


def empty(path: Path) -> None:
    path.write_bytes(b"")


def spreadsheet(path: Path) -> None:
    path.write_text("range,azimuth\n1,2\n")


def pickled(path: Path) -> None:
    resaved(path, {"format": np.array([{}])})


def truncate(path: Path) -> None:
    path.write_bytes(path.read_bytes()[:200])


def flip(path: Path) -> None:
    content = bytearray(path.read_bytes())
    content[len(content) // 2] ^= 255
    path.write_bytes(bytes(content))


def drop(path: Path) -> None:
    columns = stored(path)
    del columns["sector"]
    resaved(path, columns)


@pytest.mark.parametrize(
    ("damage", "words"),
    [
        (empty, "no variance table"),
        (spreadsheet, "no variance table"),
        (lambda path: resaved(path, {"radial": np.zeros(3)}), "does not say so"),
        (pickled, "no variance table"),
        (truncate, "no variance table"),
        (flip, "variance table|checksum"),
        (drop, "lacks sector"),
        (edit("version", 2), "reads up to 1"),
        (edit("version", "1"), "format version"),
        (edit("sectors", 36), "checksum does not fit"),
        (forge(lambda c: c.update(sectors=np.array(0))), "sectors must be"),
        (forge(lambda c: c.update(range_edges=np.array([2.0, 1.0]))), "range_edges"),
        (forge(lambda c: c["sector"].__setitem__(0, 99)), "sector must be"),
        (forge(lambda c: c["range_bin"].__setitem__(0, -1)), "range_bin must be"),
        (forge(lambda c: c["radial"].__setitem__(0, -1.0)), "not negative"),
        (forge(lambda c: c["radial"].__setitem__(0, np.nan)), "finite"),
        (forge(lambda c: c["mixed"].__setitem__(0, 1e20)), "mixed"),
        (forge(lambda c: c.update(radial=c["radial"][1:])), "column radial"),
        (forge(lambda c: c.update(label=np.arange(c["label"].size))), "column label"),
    ],
)
def test_damaged_changed_forged_and_newer_files_are_refused(
    damage: Callable[[Path], object], words: str, tmp_path: Path
) -> None:
    path = tmp_path / "table.npz"
    filled(flights=1).save(path)
    damage(path)
    with pytest.raises(VarianceTableError, match=words):
        VarianceTable.load(path)


def test_a_missing_file_is_reported_by_the_system(tmp_path: Path) -> None:
    with pytest.raises(FileNotFoundError):
        VarianceTable.load(tmp_path / "none")


# Arguments

PLOTS: tuple[Any, ...] = ([0.0, 1.0, 2.0], [1e3, 2e3, 3e3], [0.1, 0.1, 0.1])


@pytest.mark.parametrize(
    ("call", "error", "words"),
    [
        (lambda _: VarianceTable.empty([1.0], 4), ValueError, "two or more ascending"),
        (lambda _: VarianceTable.empty([1.0, 1.0], 4), ValueError, "range_edges must be"),
        (lambda _: VarianceTable.empty([0.0, 1.0], 0), ValueError, "sectors must be"),
        (lambda _: VarianceTable.empty([0.0, 1.0], True), TypeError, "sectors must be"),
        (lambda t: t.with_flights(*PLOTS, label=3), TypeError, "label must be"),
        (lambda t: t.with_flights([0.0, 1.0], [1e3, 2e3], [0.1, 0.1]), ValueError, "at least 3 plots"),
        (lambda t: t.with_flights([1.0, 1.0, 1.0], *PLOTS[1:]), ValueError, "identical times"),
        (lambda t: t.with_flights(PLOTS[0], [1e3, 2e3, 3e5], PLOTS[2]), ValueError, "within the table"),
        (lambda t: t.lookup(-1.0, 0.0, FALLBACK), ValueError, "r must be"),
        (lambda t: t.lookup(1.0, 0.0, np.eye(3)), ValueError, "fallback must have shape"),
        (lambda t: t.lookup(1.0, 0.0, FALLBACK, minimum_degrees=0.0), ValueError, "minimum_degrees"),
        (lambda t: t.lookup(1.0, 0.0, FALLBACK, minimum_degrees=math.nan), ValueError, "minimum_degrees must be from"),
    ],
)  # fmt: skip
def test_bad_arguments_are_named(call: Callable[[VarianceTable], object], error: type[Exception], words: str) -> None:
    with pytest.raises(error, match=words):
        call(VarianceTable.empty(EDGES, SECTORS))


@pytest.mark.parametrize("bad", ["x", None, True, [3.0]])
def test_what_is_no_number_of_degrees_is_refused_by_name(bad: Any) -> None:
    with pytest.raises(TypeError, match="minimum_degrees must be a real number"):
        VarianceTable.empty([0.0, 1e5], 4).lookup(1.0, 0.0, FALLBACK, minimum_degrees=bad)


@pytest.mark.parametrize("bad", [3, None, [], b""])
def test_what_is_no_label_has_no_cells_of_its_own(bad: Any) -> None:
    table = VarianceTable.empty([0.0, 1e5], 4)
    for read in (lambda: table.lookup(1.0, 0.0, FALLBACK, label=bad), lambda: table.covariance(bad)):
        with pytest.raises(TypeError, match="label must be text"):
            read()


def test_a_table_keeps_its_edges_whatever_becomes_of_the_array_that_gave_them() -> None:
    edges = np.array([0.0, 5e4, 1e5])
    tables = VarianceTable.empty(edges, 4), VarianceTable(edges, 4, VarianceTable.empty(edges, 4).contributions)
    edges[1] = 1.0
    for table in tables:
        assert table.range_edges.tolist() == [0.0, 5e4, 1e5]


def test_flights_give_the_same_table_however_they_lie_in_memory(tmp_path: Path) -> None:
    """A data frame of pandas keeps a column in one piece, where rows are flights."""
    generator = np.random.default_rng(4)
    flights = (
        5.0 * np.arange(30.0) + np.zeros((12, 1)),
        5e4 + 100.0 * generator.standard_normal((12, 30)),
        0.5 + 0.001 * generator.standard_normal((12, 30)),
    )
    for name, order in (("rows", np.ascontiguousarray), ("columns", np.asfortranarray)):
        VarianceTable.empty([0, 1e5], 6).with_flights(*map(order, flights)).save(tmp_path / name)
    assert (tmp_path / "rows").read_bytes() == (tmp_path / "columns").read_bytes()
