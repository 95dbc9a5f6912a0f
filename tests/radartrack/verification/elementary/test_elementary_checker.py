"""Certificates of the elementary functions hold of the code as it stands; forged ones and faulty code are refused."""

import os
import re
from collections.abc import Callable
from typing import Any

import pytest

pytest.importorskip("flint")
from radartrack.verification.elementary import elementary_checker
from radartrack.verification.elementary.ball_arithmetic import Refused
from radartrack.verification.elementary.elementary_certificates import (
    PRECISIONS,
    certificate,
    code_of,
    confirmed_bound,
    kept,
    source,
)
from radartrack.verification.elementary.elementary_checker import FUNCTIONS, cases, confirmed, read

KEPT, SOURCE = kept(), source()
EACH = [(precision, name) for precision in PRECISIONS for name in FUNCTIONS]
QUICK = [one for one in EACH if one[1] != "expm1" or os.environ.get("RADARTRACK_PROOFS")]  # the others take seconds
NUMBER = re.compile(r"(?<![\w.])\d+\.\d+(?:e[-+]\d+)?")


@pytest.mark.parametrize(("precision", "name"), QUICK)
def test_the_bounds_are_proved_of_the_code_that_is_there(precision: str, name: str):
    row = KEPT[precision][name]
    assert 0.5 < confirmed_bound(precision, name, row, SOURCE) <= row["bound"] <= 1.0


@pytest.mark.parametrize("precision", PRECISIONS)
def test_of_the_longest_proof_a_share_is_checked(precision: str):
    """Where e^x − 1 is small, where it doubles once, and at the ends; RADARTRACK_PROOFS has all checked."""
    bits, row = PRECISIONS[precision], KEPT[precision]["expm1"]
    text = read(SOURCE, "expm1", bits)
    assert row["trees"].keys() == cases(text).keys()
    for case in ("0+", "0-", "1", "-1", "64", "-64", str(-bits)):
        for low, high in elementary_checker.cells(cases(text)[case], row["trees"][case]):
            assert elementary_checker.bound(text, case, low, high) <= row["bound"]


def test_a_certificate_is_found_again():
    assert certificate("single", "cos", SOURCE) == KEPT["single"]["cos"]


@pytest.mark.parametrize(
    "forge",
    [
        lambda row: row | {"bound": 0.6},
        lambda row: row | {"code": "0" * 16},
        lambda row: row | {"trees": {}},
        lambda row: row | {"trees": {"": row["trees"][""][:-1]}},
        lambda row: row | {"trees": {"": row["trees"][""] + "."}},
        lambda row: row | {"trees": {"": "."}},
        lambda row: row | {"trees": {"": row["trees"][""].replace(".", "x", 1)}},
    ],
    ids=["bound", "code", "no case", "not covered", "too many cells", "one cell", "letters"],
)
def test_forged_certificates_are_refused(forge: Callable[[dict[str, Any]], dict[str, Any]]):
    with pytest.raises(Refused):
        confirmed_bound("single", "sin", forge(KEPT["single"]["sin"]), SOURCE)


def places(name: str) -> list[tuple[int, int]]:
    """Of every number in a function."""
    start = SOURCE.index(f"def {name}(")
    end = SOURCE.find("\n\n\n", start)
    return [match.span() for match in NUMBER.finditer(SOURCE, start, end if end > 0 else len(SOURCE))]


@pytest.mark.parametrize(("function", "name"), [("sin_and_cos_single", "sin"), ("exp_single", "exp")])
def test_a_change_of_any_number_is_refused_or_proves_less(function: str, name: str):
    """By a thousandth; those of the functions of which no proof here speaks are seen by none."""
    others = {"sin": "cos"}.get(name)
    for start, end in places(function):
        value = float(SOURCE[start:end])
        changed = SOURCE[:start] + repr(float(f"{value * 1.001:.6g}")) + SOURCE[end:]
        refused = 0
        for one in filter(None, (name, others)):
            try:
                row = KEPT["single"][one]
                refused += confirmed(changed, one, 24, row["trees"]) > row["bound"]
            except Refused:
                refused += 1
        assert refused, SOURCE[start - 40 : end]


@pytest.mark.parametrize(
    ("before", "after"),
    [
        ("low = low_2 -", "low = low_2 +"),
        ("y_low = (rest_2 - y) + low", "y_low = (y - rest_2) + low"),
        ("half_square = 0.5 * square", "half_square = 0.25 * square"),
        ("(y_low - half_square * y_low)", "(y_low + half_square * y_low)"),
        ("odd = quadrant * (2.0 - turned)", "odd = quadrant * (1.0 - turned)"),
        ("cosine_of_y - odd * sine_of_y", "cosine_of_y + odd * sine_of_y"),
        ("abs(angle) <= LARGEST_ANGLE, angle", "abs(angle) >= LARGEST_ANGLE, angle"),
        ("return sin_and_cos(angle)[0]", "return sin_and_cos(angle)[1]"),
        ("lost = (high - rest) - low", "lost = (high - rest) + low"),
        ("power_of_two(doublings - half)", "power_of_two(doublings + half)"),
        ("unshifted = (scale - kept) +", "unshifted = (scale - kept) -"),
        ("chosen(doublings > 64.0, 64.0, doublings)", "chosen(doublings < 64.0, 64.0, doublings)"),
        ("lost_again = (shifted - (total - back)) + (scaled - back)", "lost_again = (shifted - (total - back))"),
        ("tail = lost + rest", "tail = lost - rest"),
    ],
)
def test_faulty_statements_are_refused_or_prove_less(before: str, after: str):
    assert before in SOURCE
    faulty = SOURCE.replace(before, after, 1)
    for name in FUNCTIONS:
        row = KEPT["double"][name]
        try:
            text = read(faulty, name, 53)
            if code_of(text) == row["code"]:
                continue
            for case in cases(text).keys() & {"", "0+", "1", "54"}:
                *_, widest = elementary_checker.cells(cases(text)[case], row["trees"][case])
                if elementary_checker.bound(text, case, *widest) > row["bound"]:
                    return
        except Refused:
            return
    pytest.fail("nothing was noticed")
