"""The experiments of Gorshkov and Zavizhenets."""

import pytest

from radartrack.reproduction import gorshkov
from radartrack.reproduction.results import Finding, Reproduction


def _finding(found: Reproduction, begin: str) -> Finding:
    [finding] = [f for f in found.findings if f.what.startswith(begin)]
    return finding


def test_the_papers_gains_are_those_of_the_closed_forms(gorshkov_found: Reproduction) -> None:
    assert _finding(gorshkov_found, "Largest gain in range of radar 1").verdict == "agrees"
    assert _finding(gorshkov_found, "Largest gain in range of radar 6").verdict == "agrees"


def test_one_printed_coefficient_is_wrong(gorshkov_found: Reproduction) -> None:
    verdicts = {n: _finding(gorshkov_found, f"C of radar {n}").verdict for n in gorshkov.RADARS}
    assert [n for n, verdict in verdicts.items() if verdict == "differs"] == [4]
    assert gorshkov.coefficient(gorshkov.RADARS[4]) == pytest.approx((250 / 5 / 15) ** 2)


def test_largest_gains_do_not_grow_exponentially(gorshkov_found: Reproduction) -> None:
    assert _finding(gorshkov_found, "Largest gain in range over C").verdict == "differs"


def test_simulation_and_closed_forms_stand_side_by_side(gorshkov_found: Reproduction) -> None:
    assert _finding(gorshkov_found, "Simulated errors").verdict == "agrees"
    gains = gorshkov_found.tables["gains"].where(radar=6, component="range", k=9)
    assert gains.column("closed_form_percent")[0] == pytest.approx(55.4, abs=0.05)
    assert gains.column("simulated_percent")[0] == pytest.approx(55.4, abs=3)
    errors = gorshkov_found.tables["errors"].where(radar=3, observed="range", component="speed", k=8)
    assert errors.column("low")[0] < errors.column("measured")[0] < errors.column("high")[0]
