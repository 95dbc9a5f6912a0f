"""`radartrack diagnose` and `points`: whatever a function does, there is a clear word and the right exit code."""

import csv
import json
import math
import re
from pathlib import Path

import pytest
from typer.testing import CliRunner, Result

from radartrack.cli import app
from radartrack.testing.function_process import CannotRun, loaded

SOURCE = """
import math, os, sys

def right(r, az):
    return r*math.cos(az), r*math.sin(az)

def squared(r, az):
    return r*math.cos(az)**2, r*math.sin(az)

def prints(r, az):
    print("to the output")
    os.write(1, b"to the descriptor")
    return right(r, az)

def asks(r, az):
    return input()

def leaves(r, az):
    sys.exit(3)

def ends(r, az):
    os._exit(4)

def hangs(r, az):
    while True:
        pass

def raises(r, az):
    raise RuntimeError("no calibration")

class Converter:
    prints = staticmethod(prints)

number = 3
"""


@pytest.fixture(scope="module")
def source(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("own") / "own.py"
    path.write_text(SOURCE)
    return path


def run(*arguments: str) -> Result:
    return CliRunner().invoke(app, ["diagnose", *arguments])


@pytest.mark.parametrize(
    ("function", "code", "words"),
    [
        ("squared", 1, "entry [0]: the power 1 is 2"),
        ("ends", 2, "ended the process that ran it, with exit code 4"),
    ],
)
def test_each_outcome_has_its_words_and_its_exit_code(source: Path, function: str, code: int, words: str) -> None:
    found = run(f"{source}:{function}", "polar.map")
    assert (found.exit_code, words in found.output) == (code, True), found.output


def test_a_function_that_does_not_return_is_stopped(source: Path) -> None:
    found = run(f"{source}:hangs", "polar.map", "--timeout", "2")
    assert found.exit_code == 2
    assert "hangs does not return when called with" in found.output


def test_what_a_function_prints_does_not_mix_with_the_diagnosis(source: Path) -> None:
    found = run(f"{source}:Converter.prints", "polar.map", "--json")
    record = json.loads(found.stdout)
    assert (found.exit_code, record["verdict"], record["agrees"]) == (0, "agrees", True)
    assert "it prints while it is called" in record["remarks"]


def test_what_its_file_prints_and_what_it_is_are_not_said_of_the_function(tmp_path: Path) -> None:
    path = tmp_path / "own.py"
    path.write_text(
        "import math\nprint('begins')\n"
        "def to_xy(r, az):\n    return r*math.cos(az), r*math.sin(az)\n"
        "async def later(r, az):\n    return to_xy(r, az)\n"
        "class Converter:\n    pass\n"
    )
    found = run(f"{path}:to_xy", "polar.map", "--json")
    assert json.loads(found.stdout)["remarks"] == []
    assert "it returns a coroutine" in run(f"{path}:later", "polar.map").output
    assert "Converter is a class" in run(f"{path}:Converter", "polar.map").output


@pytest.mark.parametrize(
    ("what", "words"),
    [("{}", "FILE.py:FUNCTION"), ("nowhere.py:right", "there is no file nowhere.py")],
    ids=["no function", "no file"],
)
def test_what_is_no_function_of_a_file_is_refused(source: Path, what: str, words: str) -> None:
    found = run(what.format(source), "polar.map")
    assert found.exit_code == 2
    assert words in " ".join(found.output.split())


@pytest.mark.parametrize(
    ("text", "name", "words"),
    [
        (SOURCE, "rihgt", "has no function rihgt; did you mean right"),
        (SOURCE, "number", "is no function but a int"),
        ("\nraise ValueError('at once')\n", "f", "cannot be imported: ValueError: at once, line 2"),
        ("import sys\nsys.exit(3)\n", "f", "cannot be imported: SystemExit: 3, line 2"),
        ("f = (\n", "f", "cannot be imported: SyntaxError"),
    ],
    ids=["misspelt", "number", "raises", "leaves", "syntax"],
)
def test_what_cannot_be_loaded_is_told_with_the_reason(tmp_path: Path, text: str, name: str, words: str) -> None:
    path = tmp_path / "broken.py"
    path.write_text(text)
    with pytest.raises(CannotRun, match=re.escape(words)):
        loaded(path, name)


@pytest.mark.parametrize("arguments", [["polar.mop"], ["polar.map[7]"], ["polar.map", "--given", "rho=0"]])
def test_unknown_names_entries_and_symbols_are_refused(source: Path, arguments: list[str]) -> None:
    assert run(f"{source}:right", *arguments).exit_code == 2


def test_points_are_written_and_a_table_of_values_is_diagnosed(tmp_path: Path) -> None:
    path = tmp_path / "points.csv"
    written = CliRunner().invoke(app, ["points", "polar.map[1]", "--out", str(path)])
    assert written.exit_code == 0, written.output
    names, *rows = list(csv.reader(path.read_text().splitlines()))
    for name, formula, code in (("right", math.sin, 0), ("wrong", math.cos, 1)):
        table = tmp_path / f"{name}.csv"
        values = [[*row, repr(float(row[0]) * formula(float(row[1])))] for row in rows]
        table.write_text("\n".join(",".join(row) for row in ([*names, "y"], *values)))
        assert run("polar.map[1]", "--table", str(table)).exit_code == code
    assert run("polar.map", "--table", str(tmp_path / "right.csv")).exit_code == 2
