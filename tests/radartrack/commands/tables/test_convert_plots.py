"""`radartrack convert`: files in batches, on clusters that lose workers, complete or not there."""

import os
import signal
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from typer.testing import CliRunner, Result

import radartrack as rt
from radartrack.cli import app
from radartrack.commands.tables.plot_files import PART, many_files, one_file
from radartrack.tables import parquet_stream
from radartrack.tables.plot_columns import PlotColumns
from radartrack.verification.engines import Dask

pa: Any = pytest.importorskip("pyarrow", reason="files are tested with pyarrow")
pq: Any = pytest.importorskip("pyarrow.parquet", reason="files are tested with pyarrow")
pytest.importorskip("pint", reason="units are tested with pint")

CONSTANTS = ["range_std=50", "azimuth_std=0.01", "elevation_std=0.02"]
ROWS = 1000


def table(rows: int = ROWS, seed: int = 0) -> Any:
    generator = np.random.default_rng(seed)
    return pa.table(
        {
            "r": generator.uniform(1.0, 100.0, rows),
            "azimuth": generator.uniform(-180.0, 180.0, rows),
            "elevation": generator.uniform(0.0, 60.0, rows),
            "name": [f"plot {row}" for row in range(rows)],
        }
    )


def converted(*arguments: str | Path) -> Result:
    constants = [word for constant in CONSTANTS for word in ("--constant", constant)]
    units = ["--unit", "r=km", "--unit", "azimuth=deg", "--unit", "elevation=deg"]
    return CliRunner().invoke(app, ["convert", *map(str, arguments), "--sensor", "spherical", *constants, *units])


def chosen(bad_rows: Any = "raise") -> PlotColumns:
    constants = {"range_std": 50.0, "azimuth_std": 0.01, "elevation_std": 0.02}
    units = {"r": "km", "azimuth": "deg", "elevation": "deg"}
    return PlotColumns.chosen("spherical", constants, units, "unbiased", None, bad_rows, "")


def requires_same(found: Any, given: Any) -> None:
    """What a file holds is what the conversion of all its rows at once gives."""
    mean, covariance = rt.convert.spherical(
        1e3 * np.asarray(given["r"]), np.deg2rad(given["azimuth"]), np.deg2rad(given["elevation"]), 50.0, 0.01, 0.02
    )
    assert found.select(given.column_names).equals(given)
    for i, first in enumerate("xyz"):
        np.testing.assert_allclose(found[first], mean[:, i], rtol=1e-12)
        for j, second in enumerate("xyz"[i:], i):
            np.testing.assert_allclose(found[f"cov_{first}_{second}"], covariance[:, i, j], rtol=1e-6, atol=1e-3)


@pytest.fixture
def plots(tmp_path: Path) -> Path:
    pq.write_table(table(), tmp_path / "plots.parquet", row_group_size=300)
    return tmp_path / "plots.parquet"


def test_batches_that_fit_no_row_group_give_what_one_conversion_of_all_gives(
    plots: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(parquet_stream, "BATCH", 128)
    found = converted(plots, "--out", tmp_path / "out.parquet")
    assert found.exit_code == 0, found.output
    assert "1,000 plots converted" in found.output
    requires_same(pq.read_table(tmp_path / "out.parquet"), table())


@pytest.mark.parametrize("compression", ["none", "snappy", "gzip", "brotli", "lz4", "zstd"])
def test_columns_that_are_kept_are_compressed_as_they_were(compression: str, tmp_path: Path) -> None:
    pq.write_table(table(), tmp_path / "plots.parquet", compression=compression)
    result = converted(tmp_path / "plots.parquet", "--out", tmp_path / "new.parquet")
    assert result.exit_code == 0, result.output
    old, new = (pq.ParquetFile(tmp_path / name).metadata.row_group(0) for name in ("plots.parquet", "new.parquet"))
    kept = range(old.num_columns)
    assert [new.column(i).compression for i in kept] == [old.column(i).compression for i in kept]


def test_a_long_file_is_never_in_memory_as_a_whole(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(parquet_stream, "BATCH", 1 << 12)
    pq.write_table(table(100 << 12), tmp_path / "plots.parquet", row_group_size=1 << 12, compression="none")
    before, allocated = pa.total_allocated_bytes(), []
    parquet_stream.convert_file(
        tmp_path / "plots.parquet",
        tmp_path / "new.parquet",
        chosen(),
        lambda _: allocated.append(pa.total_allocated_bytes() - before),
    )
    assert max(allocated) < (tmp_path / "plots.parquet").stat().st_size / 4


def test_without_out_the_new_file_is_beside_the_old_one(plots: Path) -> None:
    assert converted(plots).exit_code == 0
    assert sorted(path.name for path in plots.parent.iterdir()) == ["plots-converted.parquet", "plots.parquet"]


def with_bad_rows(path: Path) -> None:
    data = table()
    r = np.asarray(data["r"]).copy()
    r[[130, 700]] = [-1.0, np.nan]
    pq.write_table(data.set_column(0, "r", pa.array(r)), path)


def test_rows_that_cannot_be_converted_end_it_with_their_numbers_in_the_file_and_nothing_written(
    plots: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(parquet_stream, "BATCH", 128)
    with_bad_rows(plots)
    before = plots.read_bytes()
    found = converted(plots)
    assert found.exit_code == 1
    assert "row 130: r must be from 0 to 1e+100 m" in found.output
    assert "got -1 km" in found.output
    assert [path.name for path in plots.parent.iterdir()] == ["plots.parquet"]
    assert plots.read_bytes() == before


def test_marked_rows_are_kept_told_and_counted(plots: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(parquet_stream, "BATCH", 128)
    with_bad_rows(plots)
    found = converted(plots, "--bad-rows", "mark")
    assert found.exit_code == 0
    assert "2 of them could not be" in found.output
    assert "plots.parquet, row 700: r is missing" in found.output
    written = pq.read_table(plots.with_name("plots-converted.parquet"))
    assert written.num_rows == ROWS
    problems = written["problem"].to_pylist()
    assert [row for row, problem in enumerate(problems) if problem] == [130, 700]
    assert np.isnan(np.asarray(written["x"])[[130, 700]]).all()


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["--column", "r=slant"], "r must be one of the columns"),
        (["--unit", "r=volt"], "the unit of r must be a unit of length"),
        (["--constant", "correlation=2"], "correlation must be from -1 to 1"),
        (["--column", "r=name"], "r must be a column of real numbers; 'name' holds string"),
        (["--method", "best"], "method must be one of"),
        (["--scheduler", "tcp://127.0.0.1:1"], "--scheduler is for --engine dask"),
        (["--engine", "dask"], "needs --scheduler"),
    ],
)
def test_what_cannot_be_done_is_said_before_anything_is_written(plots: Path, arguments: list[str], said: str) -> None:
    if "r=volt" in arguments:
        found = CliRunner().invoke(app, ["convert", str(plots), *arguments])
    else:
        found = converted(plots, *arguments)
    assert found.exit_code == 2
    assert said in " ".join(found.output.replace("│", " ").split())
    assert [path.name for path in plots.parent.iterdir()] == ["plots.parquet"]


def test_what_is_no_parquet_file_is_said(tmp_path: Path) -> None:
    (tmp_path / "plots.csv").write_text("r,azimuth\n1,2\n")
    found = converted(tmp_path / "plots.csv")
    assert found.exit_code == 2
    assert "plots.csv is no Parquet file" in found.output
    assert converted(tmp_path / "nowhere.parquet").exit_code == 2


def several(folder: Path, count: int = 3) -> list[Path]:
    folder.mkdir()
    paths = [folder / f"scan{number}.parquet" for number in range(count)]
    for number, path in enumerate(paths):
        pq.write_table(table(200, number), path)
    return paths


def test_several_files_become_a_directory_that_is_complete(tmp_path: Path) -> None:
    paths = several(tmp_path / "in")
    found = converted(*paths, "--out", tmp_path / "out")
    assert found.exit_code == 0, found.output
    for number, path in enumerate(paths):
        requires_same(pq.read_table(tmp_path / "out" / path.name), table(200, number))
    again = converted(*paths, "--out", tmp_path / "out")
    assert again.exit_code == 2
    assert "--out must be a directory that is empty or not there yet" in again.output


@pytest.mark.parametrize("name", ["plots.part-1.parquet", ".part-0123456789abcdef", 240 * "x" + ".parquet"])
def test_a_file_of_several_stays_whatever_it_is_called(tmp_path: Path, name: str) -> None:
    """Many tools call what they write in parts like what was once taken for a remainder here."""
    paths = several(tmp_path / "in", 2)
    paths.append(paths.pop().rename(tmp_path / "in" / name))
    found = converted(*paths, "--out", tmp_path / "out")
    assert found.exit_code == 0, found.output
    assert {path.name for path in (tmp_path / "out").iterdir()} == {path.name for path in paths}
    requires_same(pq.read_table(tmp_path / "out" / name), pq.read_table(paths[-1]))


def test_a_bad_row_in_one_of_several_files_leaves_no_directory(tmp_path: Path) -> None:
    paths = several(tmp_path / "in")
    with_bad_rows(paths[2])
    assert converted(*paths, "--out", tmp_path / "out").exit_code == 1
    assert not (tmp_path / "out").exists()


KILLED = """
import sys
from pathlib import Path
from radartrack.commands.tables import plot_files
from radartrack.tables.plot_columns import PlotColumns
import os, signal
def step(rows):
    os.kill(os.getpid(), signal.SIGKILL)
chosen = PlotColumns.chosen("spherical", {"range_std": 50.0, "azimuth_std": 0.01, "elevation_std": 0.02}, None,
                            "unbiased", None, "raise", "")
plot_files.one_file(Path(sys.argv[1]), Path(sys.argv[2]), chosen, None, step)
"""


@pytest.mark.skipif(sys.platform == "win32", reason="there is no SIGKILL")
def test_killed_in_the_middle_it_leaves_what_was_there(tmp_path: Path) -> None:
    source, target = tmp_path / "in.parquet", tmp_path / "out.parquet"
    radians = (
        table().set_column(1, "azimuth", pa.array(np.zeros(ROWS))).set_column(2, "elevation", pa.array(np.zeros(ROWS)))
    )
    pq.write_table(radians, source)
    target.write_text("before")
    killed = subprocess.run([sys.executable, "-c", KILLED, source, target], check=False, capture_output=True)
    assert killed.returncode == -signal.SIGKILL
    assert target.read_text() == "before"
    one_file(source, target, chosen(), None, lambda _: None)
    assert pq.read_table(target).num_rows == ROWS


class Deadly(PlotColumns):
    """What ends the worker that first converts with it, in the middle of its file."""

    def converted(self, *given: Any, **more: Any) -> Any:
        mark = Path(os.environ["RADARTRACK_TEST_MARK"])
        if not mark.exists():
            mark.touch()
            os._exit(9)
        return super().converted(*given, **more)


def test_a_cluster_that_loses_a_worker_gives_all_files_whole(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    distributed = pytest.importorskip("distributed", reason="the cluster is one of Dask")
    monkeypatch.setenv("RADARTRACK_TEST_MARK", str(tmp_path / "mark"))
    paths = several(tmp_path / "in", 4)
    columns = Deadly(**{name: getattr(chosen(), name) for name in PlotColumns.__dataclass_fields__})
    with distributed.LocalCluster(
        n_workers=2, threads_per_worker=1, dashboard_address=None, silence_logs=50, local_directory=tmp_path / "dask"
    ) as cluster:
        outcomes = many_files(paths, tmp_path / "out", columns, Dask(cluster.scheduler_address), lambda _: None)
    assert (tmp_path / "mark").exists()
    assert {path.name: outcome.rows for path, outcome in outcomes.items()} == {path.name: 200 for path in paths}
    assert sorted(path.name for path in (tmp_path / "out").iterdir()) == [path.name for path in paths]
    assert not [path for path in (tmp_path / "out").iterdir() if PART in path.name]
    for number, path in enumerate(paths):
        requires_same(pq.read_table(tmp_path / "out" / path.name), table(200, number))


def test_a_file_that_is_not_there_is_told_as_that_and_not_as_the_output(tmp_path: Path) -> None:
    result = CliRunner().invoke(app, ["convert", str(tmp_path / "nosuch.parquet")])
    assert result.exit_code == 2
    said = "".join(letter for letter in result.output if letter.isalnum())  # in a box, which breaks lines anywhere
    assert "nosuchparquetdoesnotexist" in said
    assert "cannotbewritten" not in said


def test_categories_and_columns_without_a_value_are_read_as_tables_are(tmp_path: Path) -> None:
    given = table(6).set_column(1, "azimuth", pa.array([10.0, 20.0] * 3).dictionary_encode())
    pq.write_table(given, tmp_path / "categories.parquet")
    assert converted(tmp_path / "categories.parquet", "--out", tmp_path / "out.parquet").exit_code == 0
    decoded = given.set_column(1, "azimuth", given["azimuth"].cast(pa.float64()))
    found = pq.read_table(tmp_path / "out.parquet")
    requires_same(found.set_column(1, "azimuth", decoded["azimuth"]), decoded)
    pq.write_table(given.set_column(0, "r", pa.nulls(6)), tmp_path / "nothing.parquet")
    result = converted(tmp_path / "nothing.parquet", "--out", tmp_path / "no.parquet")
    assert result.exit_code != 0
    assert "r is missing" in result.output


def damaged(whole: bytes, seed: int) -> bytes:
    """With a few bytes changed, or without its middle."""
    generator = np.random.default_rng(seed)
    if seed % 3:
        changed = bytearray(whole)
        for place in generator.integers(4, len(whole), 3):
            changed[place] = generator.integers(256)
        return bytes(changed)
    cut = int(generator.integers(4, len(whole)))
    return whole[:cut] + whole[-8:]


READ = """
import sys
from radartrack.cli import app
for name in sys.argv[2:]:
    try:
        app(["convert", name, "--constant", "range_std=50", "--constant", "azimuth_std=0.01", "--out", sys.argv[1]])
    except SystemExit as end:
        print(name, end.code, "ENDED", file=sys.stderr)
"""


def test_of_a_damaged_file_it_is_said_that_it_cannot_be_read_and_which_it_is(tmp_path: Path) -> None:
    plots = table(50).set_column(1, "azimuth", pa.array(np.zeros(50))).drop_columns("elevation")
    pq.write_table(plots, tmp_path / "whole.parquet", compression="snappy")
    whole = (tmp_path / "whole.parquet").read_bytes()
    names = [f"{seed}.parquet" for seed in range(120)]
    for seed, name in enumerate(names):
        (tmp_path / name).write_bytes(damaged(whole, seed))
    outcomes = ended(names, tmp_path)
    for name, (code, said) in outcomes.items():
        if code == "2":
            (line,) = said
            renamed = "different names" in line or "must be one of the columns" in line
            assert renamed or (name in line and "is no Parquet file that can be read" in line)
    assert sum(code == "2" for code, _ in outcomes.values()) > 20


def ended(names: list[str], folder: Path) -> dict[str, tuple[str, list[str]]]:
    """The exit code for each file and what was said; in processes, as pyarrow ends the one that reads some damages."""
    outcomes: dict[str, tuple[str, list[str]]] = {}
    left = names
    while left:
        command = [sys.executable, "-c", READ, "out.parquet", *left]
        done = subprocess.run(command, cwd=folder, capture_output=True, encoding="utf-8", check=False)
        *told, _ = done.stderr.split("ENDED\n")
        for one in told:
            *said, last = one.splitlines()
            name, code = last.split()
            outcomes[name] = code, said
        left = left[len(told) + 1 :]
    return outcomes


def test_a_file_that_its_own_checksums_call_damaged_is_not_converted(plots: Path) -> None:
    pq.write_table(table(), plots, compression="none", use_dictionary=False, write_page_checksum=True)
    content = bytearray(plots.read_bytes())
    content[content.index(np.float64(np.asarray(table()["r"])[500]).tobytes()) + 6] ^= 1
    plots.write_bytes(content)
    found = converted(plots)
    assert found.exit_code == 2
    assert "plots.parquet is no Parquet file that can be read" in found.output
    assert [path.name for path in plots.parent.iterdir()] == ["plots.parquet"]


@pytest.mark.parametrize("kind", [pa.int64(), pa.uint64()], ids=str)
def test_whole_numbers_that_are_no_floats_are_rounded_as_libraries_round_them(tmp_path: Path, kind: Any) -> None:
    pq.write_table(table(2).set_column(0, "r", pa.array([2**53 + 1, 2**62 + 1], kind)), tmp_path / "large.parquet")
    result = converted(tmp_path / "large.parquet", "--out", tmp_path / "out.parquet")
    assert result.exit_code == 0, result.output
    as_floats = table(2).set_column(0, "r", pa.array([2.0**53, 2.0**62]))
    found = pq.read_table(tmp_path / "out.parquet")
    requires_same(found.set_column(0, "r", as_floats["r"]), as_floats)


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="there are no pipes with names")
def test_a_pipe_is_refused_at_once(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe")
    found = converted(tmp_path / "pipe")
    assert found.exit_code == 2
    assert "pipe must be a file" in found.output


def test_what_the_directory_of_several_files_is_to_be_in_is_made(tmp_path: Path) -> None:
    paths = several(tmp_path / "in")
    result = converted(*paths, "--out", tmp_path / "not" / "there" / "yet")
    assert result.exit_code == 0, result.output
    assert sorted(path.name for path in (tmp_path / "not" / "there" / "yet").iterdir()) == [p.name for p in paths]


def test_a_directory_that_is_mounted_is_refused_before_the_work(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    paths = several(tmp_path / "in")
    (tmp_path / "out").mkdir()
    monkeypatch.setattr(Path, "is_mount", lambda path: path == (tmp_path / "out").resolve())
    monkeypatch.setattr(PlotColumns, "converted", lambda *_: pytest.fail("the work has begun"))
    result = converted(*paths, "--out", tmp_path / "out")
    assert result.exit_code == 2
    assert "out is mounted, and cannot be replaced" in result.output
