"""Output is tried before work begins, complete or not there, and JSON that every reader takes."""

import json
import math
import os
from pathlib import Path

import pytest
import typer
from hypothesis import given
from hypothesis import strategies as st

from radartrack._system import output_files


def places(tmp_path: Path) -> dict[str, Path]:
    (tmp_path / "file").touch()
    (tmp_path / "loop").symlink_to(tmp_path / "loop")
    return {
        "a directory": tmp_path,
        "below a file": tmp_path / "file" / "out",
        "in no directory": tmp_path / "missing" / "out",
        "too long": tmp_path / ("n" * 300),
        "a loop of links": tmp_path / "loop",
        "in a directory that takes nothing": Path("/proc/out"),
    }


@pytest.mark.parametrize("kind", ["a directory", "below a file", "in no directory", "in a directory that takes nothing",
                                  "too long", "a loop of links"])  # fmt: skip
def test_a_place_that_takes_no_file_is_refused_by_the_option_s_name(
    tmp_path: Path, kind: str, capsys: pytest.CaptureFixture[str]
) -> None:
    path = places(tmp_path)[kind]
    with pytest.raises(typer.Exit) as refused:
        output_files.refuse_unwritable({"--json": None, "--html": path})
    assert refused.value.exit_code == 2
    (line,) = capsys.readouterr().err.splitlines()
    assert line.startswith("--html must be a file that can be written; ")


@pytest.mark.parametrize("same", ["out", "link", "./out"])
def test_a_file_that_is_read_or_written_already_is_refused(tmp_path: Path, same: str) -> None:
    (tmp_path / "out").write_text("mine")
    (tmp_path / "link").symlink_to(tmp_path / "out")
    for wanted, kept in (
        ({"--json": tmp_path / "out"}, [tmp_path / same]),
        ({"--json": tmp_path / "out", "--html": tmp_path / same}, []),
    ):
        with pytest.raises(typer.Exit):
            output_files.refuse_unwritable(wanted, kept)
    assert (tmp_path / "out").read_text() == "mine"


def test_trying_leaves_nothing(tmp_path: Path) -> None:
    (tmp_path / "there").write_text("old")
    output_files.refuse_unwritable({"--json": tmp_path / "new", "--html": tmp_path / "there"})
    assert {path.name: path.read_text() for path in tmp_path.iterdir()} == {"there": "old"}


def test_what_is_no_file_gets_the_text_and_stays_what_it_is(tmp_path: Path) -> None:
    pipe = tmp_path / "pipe"
    os.mkfifo(pipe)
    reader = os.open(pipe, os.O_RDONLY | os.O_NONBLOCK)
    assert output_files.problem_with(pipe) == ""
    output_files.write(pipe, "σ\n")
    assert os.read(reader, 100).decode() == "σ\n"
    os.close(reader)
    assert pipe.is_fifo()


JSON = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats() | st.text(st.characters()),
    lambda inner: st.lists(inner, max_size=3) | st.dictionaries(st.text(st.characters()), inner, max_size=3),
    max_leaves=8,
)


def same(value: object, read: object) -> bool:
    if isinstance(value, float) and not math.isfinite(value):
        return read is None
    if isinstance(value, dict) and isinstance(read, dict):
        return value.keys() == read.keys() and all(same(value[name], read[name]) for name in value)
    if isinstance(value, list) and isinstance(read, list):
        return len(value) == len(read) and all(map(same, value, read))
    return value == read


@given(value=JSON)
def test_json_is_ascii_without_escapes_of_a_terminal_and_what_is_not_finite_is_null(value: object) -> None:
    text = output_files.json_text(value)
    assert text.isascii()
    assert all(sign.isprintable() or sign == "\n" for sign in text)
    assert same(value, json.loads(text, parse_constant=pytest.fail))


@pytest.mark.skipif(not Path("/dev/fd").exists(), reason="open files have no names")
@pytest.mark.parametrize("content", ["text", b"bytes"])
def test_a_pipe_gets_it_directly(content: str | bytes, tmp_path: Path) -> None:
    """As in `radartrack audit --json /dev/stdout | jq`: the name that such a link leads to is none of a file."""
    reading, writing = os.pipe()
    (tmp_path / "link").symlink_to(f"/dev/fd/{writing}")
    for path in (Path(f"/dev/fd/{writing}"), tmp_path / "link"):
        output_files.refuse_unwritable({"--json": path})
        output_files.write(path, content)
        expected = content.encode() if isinstance(content, str) else content
        assert os.read(reading, 100) == expected
    os.close(reading)
    os.close(writing)
    assert [path.name for path in tmp_path.iterdir()] == ["link"]


def test_where_a_link_leads_a_file_is_made(tmp_path: Path) -> None:
    (tmp_path / "link").symlink_to("new")
    output_files.refuse_unwritable({"--json": tmp_path / "link"})
    output_files.write(tmp_path / "link", "text")
    assert (tmp_path / "link").is_symlink()
    assert (tmp_path / "new").read_text() == "text"
