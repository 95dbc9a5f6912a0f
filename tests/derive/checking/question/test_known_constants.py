"""The numbers of an ellipsoid are read as what they are of it, at the digits that are printed."""

from __future__ import annotations

import pytest

from radartrack.derive import check
from radartrack.derive.checking.question.definitions.known_constants import (
    ELLIPSOIDS,
    has_any_unit,
    nearly,
    with_symbols,
)
from radartrack.derive.checking.question.formula_units import Dimension, misfits
from radartrack.derive.formula.printing import to_text
from radartrack.derive.formula.tree import Number
from radartrack.derive.reading.text import read_text
from radartrack.derive.units import METRE, SECOND

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


def _misprints(text: str) -> list[str]:
    """A number after each slip of one digit: another digit, two exchanged, one missing or too many."""
    places = [at for at, sign in enumerate(text) if sign.isdigit() and text[:at].strip("0.")]
    found = [f"{text[:at]}{(int(text[at]) + 3) % 10}{text[at + 1 :]}" for at in places]
    found += [
        f"{text[:at]}{text[at + 1]}{text[at]}{text[at + 2 :]}"
        for at in places[:-1]
        if text[at + 1].isdigit() and text[at] != text[at + 1]
    ]
    return found + [f"{text[:at]}{text[at + 1 :]}" for at in places] + [f"{text[:at]}7{text[at:]}" for at in places]


@pytest.mark.parametrize(
    ("right", "what"),
    [
        ("6378137", "semi_major_axis of WGS 84"),
        ("298.257223563", "1/flattening of WGS 84"),
        ("0.00669437999", "flattening*(2 - flattening) of WGS 84"),
        ("0.081819190843", "sqrt(flattening*(2 - flattening)) of WGS 84"),
        ("299792458", "the speed of light"),
        ("9.80665", "standard gravity"),
    ],
)
def test_a_constant_with_one_digit_wrong_is_told(right: str, what: str) -> None:
    for wrong in _misprints(right):
        said = [words for words, _ in nearly(Number(wrong), SYMBOLS)]
        exact = with_symbols(Number(wrong), SYMBOLS)[1] or has_any_unit(Number(wrong))  # another ellipsoid's, or fewer
        assert exact or any(what in words for words in said), wrong
    assert not any(what in words for words, _ in nearly(Number(right), SYMBOLS))


@pytest.mark.parametrize("number", ["12345", "0.5", "3.14159", "6370000", "1234567", "0.0066", "90000"])
def test_other_numbers_are_no_misprints(number: str) -> None:
    assert list(nearly(Number(number), SYMBOLS)) == []


@pytest.mark.parametrize(
    ("let", "words"),
    [
        ({"a": "6378173", "e2": "0.00669437999"}, "6378173 should be 6378137"),
        ({"a": "6378137", "e2": "0.00669473999"}, "0.00669473999 should be 0.00669437999"),
    ],
)
def test_a_wrong_digit_is_told_in_a_formula_and_in_a_definition(let: dict[str, str], words: str) -> None:
    formula = "(N + h)*cos(lat)*cos(lon)"
    defined = {**let, "N": "a/sqrt(1 - e2*sin(lat)^2)"}
    told = check("frames.ecef_from_geodetic.map[0]", formula, let=defined)
    assert words in told.suggestions[0].edit
    bare = f"({let['a']}/sqrt(1 - {let['e2']}*sin(lat)^2) + h)*cos(lat)*cos(lon)"
    told = check("frames.ecef_from_geodetic.map[0]", bare)
    assert words in told.suggestions[0].edit


@pytest.mark.parametrize("constant", ["299792458", "2.998e8", "3e8", "9.81", "9.80665"])
def test_a_bare_number_that_is_a_constant_stands_in_every_unit(constant: str) -> None:
    known = {"tau": Dimension.of(SECOND), "r": Dimension.of(METRE)}
    for formula, wrong in ((f"{constant}*tau + r", 0), ("7*tau + r", 1)):
        assert misfits(read_text(formula, known), known)[1] == wrong
