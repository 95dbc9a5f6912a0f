"""The experiments of Gao, Dong and Zhang."""

import math

import numpy as np
import pytest

from radartrack import straight_flight
from radartrack.reproduction import gao
from radartrack.reproduction.results import Reproduction


def test_the_printed_deviation_is_what_folding_and_mixed_units_leave_of_it(gao_found: Reproduction) -> None:
    rows = gao_found.tables["deviation_9"]
    fast = rows.column("speed_m_s") >= 10
    folded = math.sqrt(1 - 2 / math.pi) * gao.TRUE_STD / np.hypot(1, rows.column("speed_m_s"))
    assert rows.column("derived_m") == pytest.approx(folded)
    assert rows.column("printed_m")[fast] == pytest.approx(folded[fast], rel=0.04)
    assert rows.column("consistent_m") == pytest.approx(gao.TRUE_STD, rel=0.02)


def test_findings_say_what_the_comparison_of_weights_says(gao_found: Reproduction) -> None:
    aged = straight_flight.compare(straight_flight.situations()["aged"], runs=100)
    [finding] = [f for f in gao_found.findings if "aged, scatter, consistent" in f.what]
    assert finding.verdict == "agrees"
    assert finding.ours == f"{100 * aged.excess['consistent'].value:.1f} %".replace("-", "−")


def test_the_papers_examples_are_the_distance_across(gao_found: Reproduction) -> None:
    assert [f.verdict for f in gao_found.findings[:2]] == ["agrees", "agrees"]
    assert gao_found.findings[0].ours == f"{50e3 * math.pi / 180:.1f} m"


def test_the_picture_has_all_radars_and_lines(gao_found: Reproduction) -> None:
    what = set(gao_found.tables["figure_1"].columns["what"])
    assert {f"plots of radar {n}" for n in (1, 2, 3, 4)} < what
    assert {"flight", "line by propagated", "line by consistent"} < what
