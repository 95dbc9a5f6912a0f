"""Tables and findings."""

import csv

import numpy as np
import pytest

from radartrack._arrays.repeated_trials import Estimate
from radartrack.reproduction.results import Finding, Reproduction, Table, columns, interval, number, table


def test_a_table_is_written_with_six_digits_and_nothing_for_what_is_not_there() -> None:
    text = table([{"k": 1, "name": "a, b", "x": 1.23456789}, {"k": 2, "name": "c", "x": np.nan}]).csv()
    assert text.endswith("\n")
    assert list(csv.reader(text.splitlines())) == [["k", "name", "x"], ["1", "a, b", "1.23457"], ["2", "c", ""]]


def test_rows_are_chosen_by_their_values() -> None:
    rows = Table({"a": [1, 1, 2], "b": ["x", "y", "x"], "c": [0.5, 1.5, 2.5]})
    assert rows.where(a=1, b="y").column("c").tolist() == [1.5]
    assert rows.where(a=3).column("c").size == 0


def test_columns_of_different_lengths_are_refused() -> None:
    with pytest.raises(ValueError, match=r"columns must have one length; got \{'a': 2, 'b': 1\}"):
        Table({"a": [1, 2], "b": [1]})


def test_numbers_are_read_as_people_write_them() -> None:
    found = Estimate(np.array([0.5]), np.array([-0.04]), np.array([1.26]))
    assert number(-0.04) == "0.0"
    assert number(-1.25, 2) == "−1.25"
    assert interval(found, 0) == "[0.0, 1.3]"
    assert interval(found, 0, scale=-100, digits=0) == "[−126, 4]"
    assert columns("x", found, 0, 2.0) == {"x": 1.0, "x_lower": -0.08, "x_upper": 2.52}


def test_findings_become_a_table() -> None:
    found = Reproduction("p", "P", {}, (Finding("a", "1", "2", "", "differs", "why"),))
    assert list(found.findings_table().rows()) == [("a", "1", "2", "", "differs", "why")]
