"""The numbers of an ellipsoid are read as what they are of it, at the digits that are printed."""

from __future__ import annotations

import pytest

from radartrack.derive import check
from radartrack.derive.checking.question.known_constants import ELLIPSOIDS, with_symbols
from radartrack.derive.formula.printing import to_text
from radartrack.derive.reading.text import read_text

SYMBOLS = ("semi_major_axis", "flattening")


@pytest.mark.parametrize(
    ("number", "meant"),
    [
        ("6378137", "semi_major_axis"),
        ("6378137.0", "semi_major_axis"),
        ("6.378137e6", "semi_major_axis"),
        ("6356752.3142", "semi_major_axis*(1 - flattening)"),
        ("298.257223563", "1/flattening"),
        ("0.00669437999014", "flattening*(2 - flattening)"),
        ("0.00669438", "flattening*(2 - flattening)"),
        ("6.69437999014e-3", "flattening*(2 - flattening)"),
        ("0.0818191908426", "sqrt(flattening*(2 - flattening))"),
        ("0.00673949674228", "flattening*(2 - flattening)/(1 - flattening)**2"),
    ],
)
def test_a_number_is_known_at_its_printed_digits(number: str, meant: str) -> None:
    tree, said = with_symbols(read_text(number, SYMBOLS), SYMBOLS)
    assert to_text(tree) == meant
    assert said == (f"{number} is read as {meant} of WGS 84",)


@pytest.mark.parametrize("number", ["6378", "6378.137", "6378147", "0.0067", "0.00669458", "298", "2", "0.5"])
def test_other_numbers_stay(number: str) -> None:
    tree = read_text(number, SYMBOLS)
    assert with_symbols(tree, SYMBOLS) == (tree, ())


def test_all_numbers_of_a_formula_are_of_one_ellipsoid() -> None:
    for ellipsoid in ELLIPSOIDS:
        text = f"{float(ellipsoid.semi_major_axis)}/{float(ellipsoid.inverse_flattening)}"
        assert all(said.endswith(ellipsoid.name) for said in with_symbols(read_text(text, SYMBOLS), SYMBOLS)[1])


def test_where_the_quantity_has_no_ellipsoid_they_are_numbers() -> None:
    tree = read_text("6378137*r", {"r"})
    assert with_symbols(tree, {"r"}) == (tree, ())


def test_a_formula_with_bare_numbers_is_equal_and_a_slip_beside_them_is_told() -> None:
    formula = "(6378137/sqrt(1 - 0.00669438*sin(phi)^2) + h)*cos(phi)*cos(lambda)"
    right = check("frames.ecef_from_geodetic.map[0]", formula)
    assert right.is_equal
    assert len(right.remarks) == 2
    let = {"a": "6378137", "e2": "0.00669437999014", "N": "a/sqrt(1 - e2*sin(phi)^2)"}
    wrong = check("frames.ecef_from_geodetic.map[2]", "(N*(1 + e2) + h)*sin(phi)", let=let)
    assert "(N*(1 - e2) + h)*sin(phi)" in {one.formula for one in wrong.suggestions}
