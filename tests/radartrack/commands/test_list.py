"""`radartrack list`: every name, uncut, and what matches a pattern."""

from fnmatch import fnmatchcase

import pytest
from typer.testing import CliRunner

from radartrack.cli import app
from radartrack.derive.catalogue import catalogue


def listed(*arguments: str, columns: int = 80) -> str:
    result = CliRunner(env={"COLUMNS": str(columns)}).invoke(app, ["list", *arguments])
    assert result.exit_code == 0, result.output
    return result.stdout


def names(output: str) -> list[str]:
    return [line.split()[0] for line in output.splitlines() if line.split() and line.split()[0] in catalogue()]


@pytest.mark.parametrize("columns", [20, 80, 300])
def test_all_names_are_listed_uncut_in_terminals_of_any_width(columns: int):
    assert names(listed(columns=columns)) == list(catalogue())


def test_shapes_units_and_sources_stand_beside_the_names():
    text = " ".join(listed("polar.covariance.linear").split())
    for fact in ("polar.covariance.linear 2×2 m^2", "covariance of the linearised conversion", "Prosov (9)"):
        assert fact in text


def test_units_in_brackets_are_no_markup():
    assert "[m, m] × [1/m, 1/rad]" in listed("polar.jacobian")


@pytest.mark.parametrize("pattern", ["polar.*.linear", "*.map", "polar.bias.?ruth", "*[!a-z]map"])
def test_a_pattern_selects_whole_names(pattern: str):
    assert names(listed(pattern)) == [name for name in catalogue() if fnmatchcase(name, pattern)]


def test_plain_text_selects_names_that_hold_it_the_plainest_first():
    found = names(listed("averaged"))
    assert sorted(found) == sorted(name for name in catalogue() if "averaged" in name)
    sizes = [len(catalogue()[name].symbols) for name in found]
    assert sizes == sorted(sizes)


def test_nothing_found_is_said_with_exit_code_one():
    result = CliRunner().invoke(app, ["list", "nothing.like.this"])
    assert result.exit_code == 1
    assert "'nothing.like.this'" in result.stderr
    assert not result.stdout


@pytest.mark.parametrize("words", ["Kalman", "converted measurement", "mo", "EMP", "polar covariance"])
def test_words_of_the_field_are_listed_one_line_a_quantity_where_no_terminal_is(words: str):
    lines = listed(*words.split(), columns=20).splitlines()
    assert lines
    assert [line.split()[0] for line in lines] == names("\n".join(lines))
