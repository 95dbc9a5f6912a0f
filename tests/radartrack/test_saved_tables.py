"""What is saved of a table loads; what is damaged, forged or too large is refused, at once and in little memory."""

import io
import os
import resource
import struct
import subprocess
import sys
import tempfile
import tracemalloc
import zipfile
from collections.abc import Callable, Iterator, Mapping
from fractions import Fraction
from pathlib import Path
from typing import Any
from unittest import mock

import numpy as np
import pytest
from hypothesis import example, given
from hypothesis import strategies as st
from numpy.typing import NDArray

from radartrack import VarianceTable, variance_table
from radartrack._arrays import bounded_archive
from radartrack.variance_table import Contributions, VarianceTableError
from tests.effort import at_most

Array = NDArray[Any]
SMALL = VarianceTable.empty([0, 1e5], 2).with_flights([0.0, 1.0, 2.5], [1e4, 2e4, 4e4], [0.1, 0.2, 4.0], label="é")
HUGE = 10**8
EPSILON = np.finfo(float).eps
SECONDS, BYTES = 1.0, 100 * 2**20


FOLDER = tempfile.TemporaryDirectory()
PLACE = Path(FOLDER.name) / "table.npz"


def saved(table: VarianceTable) -> bytes:
    table.save(PLACE)
    return PLACE.read_bytes()


def loaded(content: bytes) -> VarianceTable:
    """From a file that is not on a disk: there are thousands of them."""
    with mock.patch.object(Path, "open", return_value=io.BytesIO(content)):
        return VarianceTable.load("table")


def columns(content: bytes) -> dict[str, Array]:
    with np.load(io.BytesIO(content)) as archive:
        return dict(archive)


def archived(stored: Mapping[str, Array]) -> bytes:
    file = io.BytesIO()
    np.savez_compressed(file, **dict[str, Any](stored))
    return file.getvalue()


CONTENT = saved(SMALL)
WITHOUT_CHECKSUM = archived(columns(CONTENT))


def same(first: VarianceTable, second: VarianceTable) -> bool:
    pairs = zip(first.contributions.columns.values(), second.contributions.columns.values(), strict=True)
    return (
        first.sectors == second.sectors
        and np.array_equal(first.range_edges, second.range_edges)
        and first.labels == second.labels
        and all(a.dtype == b.dtype and np.array_equal(a, b) for a, b in pairs)
    )


def is_refused(content: bytes) -> bool:
    try:
        loaded(content)
    except VarianceTableError:
        return True
    return False


# What is saved loads

BEGINNINGS = st.sampled_from([0.0, 9320.596866133783, 1.7e9, -1e15])
STEPS = st.sampled_from([0.0, 5e-324, 1e-200, 1e-12, 2.0**-22, 1e-3, 1.0, 71.40314492, 1e4, 1e100])
LENGTHS = st.one_of(st.floats(0.0, 1e5), st.sampled_from([0.0, 5e-324, 1e-170, 1e-9, 5e4, 1e5]))


@st.composite
def flights(draw: st.DrawFn) -> tuple[list[float], list[float], list[float]]:
    """Times that repeat, or nearly, ranges and azimuths."""
    count, beginning = draw(st.integers(3, 6)), draw(BEGINNINGS)
    t = [beginning + draw(STEPS) for _ in range(count)]
    r = draw(st.lists(LENGTHS, min_size=count, max_size=count))
    azimuth = draw(st.lists(st.floats(-7.0, 7.0), min_size=count, max_size=count))
    return (t if max(t) - min(t) > 1e-90 else [*t[1:], 5e99]), r, azimuth


LABELS = st.text(st.characters(exclude_categories=()), max_size=4).map(lambda text: text.rstrip("\0"))


@given(parts=st.lists(st.tuples(flights(), LABELS), max_size=4), sectors=st.integers(1, 12))
def test_every_table_that_can_be_built_loads_as_it_was_saved(
    parts: list[tuple[tuple[list[float], list[float], list[float]], str]], sectors: int
) -> None:
    table = VarianceTable.empty([0.0, 5e4, 1e5], sectors)
    for flight, label in parts:
        table = table.with_flights(*flight, label=label)
    assert same(loaded(saved(table)), table)


@given(flight=flights())
def test_degrees_of_freedom_are_those_of_exact_arithmetic(flight: tuple[list[float], list[float], list[float]]) -> None:
    t, r, _ = flight
    count = len(t)
    azimuths = (np.arange(count) + 0.5) * 2 * np.pi / count
    table = VarianceTable.empty([0.0, 1e5], count).with_flights(t, r, azimuths)
    times = [Fraction(time) for time in t]
    mean = sum(times) / count
    spread = sum((time - mean) ** 2 for time in times)
    expected = [float(1 - Fraction(1, count) - (time - mean) ** 2 / spread) for time in times]
    found = table.degrees_of_freedom()[0]
    assert found == pytest.approx(expected, abs=2e-9)
    assert np.all(found[np.array(expected) == 0.0] == 0.0)


@given(flight=flights(), azimuth=st.floats(-7.0, 7.0), r=st.floats(0.0, 2e5))
@example(flight=([0.0, 0.0, 5e99], [0.0, 1.0, 0.0], [0.0, 0.0, 0.0]), azimuth=5.319783519052005e-302, r=0.0)
def test_covariances_of_cells_and_of_lookups_are_symmetric_and_positive_semidefinite(
    flight: tuple[list[float], list[float], list[float]], azimuth: float, r: float
) -> None:
    table = VarianceTable.empty([0.0, 5e4, 1e5], 3).with_flights(*flight)
    found = table.lookup(r, azimuth, np.zeros((2, 2)), minimum_degrees=1e-9).covariance
    cells = table.covariance()
    for matrix in (*cells[~np.isnan(cells[..., 0, 0])], found):
        assert matrix[0, 1] == matrix[1, 0]
        assert matrix.diagonal().min() >= 0
        assert abs(matrix[0, 1]) <= np.sqrt(matrix[0, 0]) * np.sqrt(matrix[1, 1]) * (1 + 1e-12)


def test_a_plot_that_the_line_goes_through_whatever_its_error_leaves_its_cell_empty() -> None:
    table = VarianceTable.empty([0, 5e4, 1e5], 1).with_flights([9320.596] * 2 + [9392.0], [2e4, 2.1e4, 7e4], [0.3] * 3)
    assert table.degrees_of_freedom()[:, 0].tolist() == [pytest.approx(1.0), 0.0]
    assert np.isnan(table.covariance()[1]).all()


@pytest.mark.parametrize("label", ["a\0", "\0", "a\0\0"])
def test_labels_that_arrays_cannot_keep_are_refused(label: str) -> None:
    with pytest.raises(ValueError, match="label must not end in a NUL"):
        SMALL.with_flights([0.0, 1.0, 2.0], [1e3] * 3, [0.1] * 3, label=label)


@pytest.mark.parametrize("count", [1, 3])
def test_no_flights_leave_the_table_as_it_is(count: int) -> None:
    none = np.zeros((0, 3 * count))
    assert same(SMALL.with_flights(np.arange(3.0 * count), none, none), SMALL)
    assert same(loaded(saved(VarianceTable.empty([0, 1e5], 2))), VarianceTable.empty([0, 1e5], 2))


def test_tables_of_earlier_versions_load_also_where_rounding_made_a_degree_of_freedom_negative() -> None:
    old = columns(CONTENT)
    old["degrees_of_freedom"] = np.where(old["sector"] == 0, old["degrees_of_freedom"], -2.2e-16)
    old["degrees_of_freedom"][0] = -2.2e-16
    table = loaded(archived(old | {"digest": np.array(variance_table._digest(old))}))
    assert table.contributions.degrees_of_freedom[0] == 0.0
    assert same(loaded(WITHOUT_CHECKSUM), SMALL)


def test_a_table_that_compresses_far_is_saved_so_that_it_loads(monkeypatch: pytest.MonkeyPatch) -> None:
    """With a tenth of the room that there is, the table of equal contributions is as large as one of many flights."""
    monkeypatch.setattr(bounded_archive, "ALWAYS_ALLOWED", 2**20)
    count = 2**15
    alike = {name: np.repeat(column[:1], count) for name, column in SMALL.contributions.columns.items()}
    table = VarianceTable(SMALL.range_edges, SMALL.sectors, Contributions(**alike))
    assert same(loaded(saved(table)), table)
    assert is_refused(archived(columns(saved(table))))


# Damage


def test_every_changed_byte_is_refused() -> None:
    for place in range(len(CONTENT)):
        damaged = bytearray(CONTENT)
        damaged[place] ^= 1 << place % 8
        assert is_refused(bytes(damaged)), place


def test_every_truncation_and_every_addition_is_refused() -> None:
    for content in (CONTENT, WITHOUT_CHECKSUM):
        assert all(is_refused(content[:length]) for length in range(0, len(content), 3))
        assert is_refused(content + b"\0")
        assert is_refused(b"\0" + content)
        assert is_refused(content + content)


def test_every_changed_byte_of_an_archive_without_checksum_is_refused_or_changes_nothing() -> None:
    for place in range(len(WITHOUT_CHECKSUM)):
        damaged = bytearray(WITHOUT_CHECKSUM)
        damaged[place] ^= 255
        assert is_refused(bytes(damaged)) or same(loaded(bytes(damaged)), SMALL), place


# Forgery: the checksums fit

Change = Callable[[dict[str, Array]], None]


def forged(change: Change) -> bytes:
    stored = columns(CONTENT)
    change(stored)
    return archived(stored | {"digest": np.array(variance_table._digest(stored))})


def converted(name: str, dtype: Any) -> Change:
    return lambda stored: stored.update({name: stored[name].astype(dtype)})


def replaced(name: str, value: object) -> Change:
    return lambda stored: stored.update({name: np.asarray(value)})


def entry(name: str, value: object) -> Change:
    return lambda stored: stored[name].__setitem__(0, value)


REAL = "range_edges", "degrees_of_freedom", "radial", "mixed", "transverse"
NOT_REAL = np.float32, np.longdouble, ">f8", np.int64, complex, "U9"
NOT_WHOLE = np.int32, np.uint64, float, "U9"
NO_COUNTS = "12", 12.7, 2**62, 10**10, 0, -1, [2], True, 2.0
IMPOSSIBLE = {
    "degrees_of_freedom": (-1.0, np.nan, np.inf, 1e300),
    "radial": (-1.0, np.nan, np.inf, 1e300),
    "transverse": (-1.0, np.nan, np.inf, 1e300),
    "mixed": (np.nan, np.inf, 1e20),
    "sector": (-1, 2, 2**62),
    "range_bin": (-1, 1, 2**62),
}
NO_CHARACTERS = np.array([0x110000] * SMALL.contributions.label.size, "<u4").view("<U1")
FORGERIES: dict[str, Change] = {
    **{f"{name} as {dtype}": converted(name, dtype) for name in REAL for dtype in NOT_REAL},
    **{f"{name} as {dtype}": converted(name, dtype) for name in ("range_bin", "sector") for dtype in NOT_WHOLE},
    "label as bytes": replaced("label", [b"a"] * SMALL.contributions.label.size),
    "label with the bytes of each character in another order": converted("label", ">U4"),
    **{f"{value!r} sectors": replaced("sectors", value) for value in NO_COUNTS},
    **{f"{name} {value}": entry(name, value) for name, values in IMPOSSIBLE.items() for value in values},
    "a million bins": replaced("range_edges", np.linspace(0, 1e5, 2**20)),
    "bins without centres": replaced("range_edges", 1 + EPSILON * np.arange(1, 4)),
    "edges in rows": replaced("range_edges", [[0.0, 1e5]]),
    "no characters": replaced("label", NO_CHARACTERS),
    "a column in rows": lambda stored: stored.update(radial=stored["radial"][:, np.newaxis]),
    "short columns": lambda stored: stored.update({name: stored[name][:0] for name in ("radial", "mixed")}),
}


@pytest.mark.parametrize("forgery", FORGERIES)
def test_impossible_contents_are_refused_though_the_checksum_fits(forgery: str) -> None:
    assert is_refused(forged(FORGERIES[forgery]))


def header(content: bytes, descr: str, shape: str) -> bytes:
    """The array `radial` announces another type and shape, in an archive that is otherwise whole."""
    file = io.BytesIO()
    text = f"{{'descr': {descr}, 'fortran_order': False, 'shape': {shape}, }}".encode()
    with zipfile.ZipFile(io.BytesIO(content)) as old, zipfile.ZipFile(file, "w") as new:
        for name in old.namelist():
            changed = b"\x93NUMPY\x01\x00" + struct.pack("<H", len(text) + 1) + text + b"\n" + bytes(24)
            new.writestr(name, changed if name == "radial.npy" else old.read(name))
    return file.getvalue()


@pytest.mark.parametrize(
    ("descr", "shape"),
    [
        ("'<f8'", f"({10**15},)"),
        ("'<f8'", f"({10**30},)"),
        ("'<f8'", "(0, 100000000000000000000)"),
        ("'<f8'", "(-3,)"),
        ("'|O'", "(3,)"),
        ("[('a', '<f8')]", "(3,)"),
        ("'<U999999999'", "(3,)"),
        ("'<U0'", f"({10**15},)"),
        ("'<f8'", "(" * 10_000),
        ("'<f8'", "__import__('os').abort()"),
    ],
)
def test_headers_that_lie_are_refused(descr: str, shape: str) -> None:
    assert is_refused(header(CONTENT, descr, shape))


def with_directory(content: bytes, place: int, value: int, size: str = "H") -> bytes:
    """All entries of the list of members changed at a place."""
    changed, start = bytearray(content), content.find(b"PK\1\2")
    while start >= 0:
        struct.pack_into(f"<{size}", changed, start + place, value)
        start = content.find(b"PK\1\2", start + 1)
    return bytes(changed)


@pytest.mark.parametrize(
    ("place", "value", "size"),
    [
        pytest.param(6, 99, "H", id="version of another time"),
        pytest.param(8, 0x01, "H", id="encrypted"),
        pytest.param(8, 0x41, "H", id="strongly encrypted"),
        pytest.param(10, 12, "H", id="bzip2"),
        pytest.param(10, 14, "H", id="lzma"),
        pytest.param(10, 99, "H", id="unknown method"),
        pytest.param(24, 2**32 - 2, "I", id="size"),
        pytest.param(42, 2**31, "I", id="place"),
    ],
)
def test_archives_that_are_not_as_saved_are_refused(place: int, value: int, size: str) -> None:
    assert is_refused(with_directory(WITHOUT_CHECKSUM, place, value, size))


def nothing_like_it() -> Iterator[bytes]:
    yield b""
    yield b"PK\5\6" + bytes(18)
    yield b"PK\5\6" + bytes(4) + b"\xff" * 14
    yield b"PK" * 500
    yield b"\x93NUMPY" + bytes(100)
    file = io.BytesIO()
    np.save(file, np.zeros(3))
    yield file.getvalue()
    with zipfile.ZipFile(file := io.BytesIO(), "w") as archive:
        for number in range(100):
            archive.writestr(f"{number}.npy", b"")
    yield file.getvalue()
    with zipfile.ZipFile(file := io.BytesIO(), "w") as archive:
        archive.writestr("format.npy", b"neither")
        archive.writestr("version", b"nor")
    yield file.getvalue()


def test_other_files_are_refused() -> None:
    for content in nothing_like_it():
        assert is_refused(content), content[:40]


def zeros(count: int) -> Iterator[bytes]:
    """The member file of an array of zeros, piece by piece."""
    head = io.BytesIO()
    np.lib.format.write_array_header_1_0(head, {"descr": "<f8", "fortran_order": False, "shape": (count,)})
    yield head.getvalue()
    yield from (bytes(2**20) for _ in range(8 * count // 2**20))
    yield bytes(8 * count % 2**20)


@pytest.fixture(scope="module")
def bomb(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A table whose radial sums are a hundred million zeros, in less than a megabyte."""
    path = tmp_path_factory.mktemp("bomb") / "bomb.npz"
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED, compresslevel=1) as new:
        with zipfile.ZipFile(io.BytesIO(CONTENT)) as old:
            for name in {*old.namelist()} - {"radial.npy"}:
                new.writestr(name, old.read(name))
        with new.open("radial.npy", "w", force_zip64=True) as member:
            for piece in zeros(HUGE // 4):
                member.write(piece)
    return path


def lying(path: Path) -> bytes:
    """The bomb, whose list of members says that it is small."""
    content = bytearray(path.read_bytes())
    struct.pack_into("<I", content, content.rfind(b"radial.npy") - 22, 200)
    return bytes(content)


def test_bombs_are_refused_before_they_are_unpacked(bomb: Path, tmp_path: Path) -> None:
    (tmp_path / "lying").write_bytes(lying(bomb))
    for path in (bomb, tmp_path / "lying"):
        tracemalloc.start()
        try:
            with at_most(SECONDS), pytest.raises(VarianceTableError):
                VarianceTable.load(path)
            assert tracemalloc.get_traced_memory()[1] < BYTES / 10
        finally:
            tracemalloc.stop()


# Saving

OTHER = SMALL.with_flights([0.0, 1.0, 3.5], [1e4, 2e4, 4e4], [0.1, 0.2, 0.4], label="other")

KILLED = """
import os, sys
from itertools import count
from pathlib import Path
from radartrack import VarianceTable
from tests.radartrack._system.replacements import kill_at
table, target = VarianceTable.load(sys.argv[1]), Path(sys.argv[2])
for step in count():
    child = os.fork()
    if child == 0:
        kill_at(step)
        table.save(target / str(step))
        os._exit(0)
    if not os.WIFSIGNALED(os.waitpid(child, 0)[1]):
        print(step)
        break
"""


def test_a_table_whose_saving_is_killed_at_any_step_is_the_old_or_the_new_one(tmp_path: Path) -> None:
    OTHER.save(tmp_path / "other")
    for step in range(40):
        SMALL.save(tmp_path / str(step))
    command = [sys.executable, "-c", KILLED, str(tmp_path / "other"), str(tmp_path)]
    root = Path(__file__).parents[2]
    environment = os.environ | {"PYTHONPATH": str(root)}
    steps = int(subprocess.run(command, check=True, capture_output=True, cwd=root, env=environment, timeout=60).stdout)
    assert 5 <= steps < 40
    found = [VarianceTable.load(tmp_path / str(step)) for step in range(steps + 1)]
    assert all(same(table, SMALL) or same(table, OTHER) for table in found)
    assert same(found[0], SMALL)
    assert same(found[-1], OTHER)


def test_a_full_disk_leaves_the_old_table_and_nothing_beside_it(tmp_path: Path) -> None:
    SMALL.save(tmp_path / "table")
    soft, hard = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (1000, hard))  # no file may be longer: writing fails as on a full disk
    try:
        with pytest.raises(OSError, match="table"):
            OTHER.save(tmp_path / "table")
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, (soft, hard))
    assert same(VarianceTable.load(tmp_path / "table"), SMALL)
    assert [path.name for path in tmp_path.iterdir()] == ["table"]


def test_places_that_hold_no_table_are_named(tmp_path: Path) -> None:
    (tmp_path / "folder").mkdir()
    os.mkfifo(tmp_path / "pipe")
    for place, error in (("folder", IsADirectoryError), ("pipe", OSError), ("none/table", FileNotFoundError)):
        with pytest.raises(error, match=place) as raised:
            SMALL.save(tmp_path / place)
        assert ".swap" not in str(raised.value)
    assert sorted(path.name for path in tmp_path.iterdir()) == ["folder", "pipe"]
    assert (tmp_path / "pipe").is_fifo()
    with pytest.raises(IsADirectoryError):
        VarianceTable.load(tmp_path / "folder")


# Arguments

SINGLE: Any = np.array([0.0, 1.0], np.float32)


@pytest.mark.parametrize(
    ("call", "error", "words"),
    [
        (lambda: VarianceTable.empty([0, 1], 2**62), ValueError, "sectors must make at most 1048576 cells"),
        (
            lambda: VarianceTable.empty(1 + EPSILON * np.arange(1, 4), 1),
            ValueError,
            "range_edges must be further apart",
        ),
        (lambda: VarianceTable(SINGLE, 1, Contributions.none()), TypeError, "range_edges must be an array"),
        (lambda: VarianceTable(np.array([0.0, 1.0]), 1, SMALL.contributions), ValueError, "sector must be"),
        (lambda: SMALL.lookup(1.0, 0.0, [[1.0, 2.0], [2.0, 1.0]]), ValueError, "fallback must be positive"),
        (lambda: SMALL.lookup(1.0, 0.0, [[1.0, 0.5], [0.0, 1.0]]), ValueError, "fallback must be symmetric"),
    ],
)
def test_bad_arguments_are_named(call: Callable[[], object], error: type[Exception], words: str) -> None:
    with pytest.raises(error, match=words):
        call()


@pytest.mark.parametrize("sectors", [np.int8(100), np.int64(100)])
def test_integers_of_numpy_are_whole_numbers(sectors: Any) -> None:
    table = VarianceTable.empty(np.linspace(0, 1e5, 50), sectors).with_flights([0, 1, 2], [1e4, 9e4, 9e4], [0, 3, 6])
    assert type(table.sectors) is int
    assert same(loaded(saved(table)), table)
