"""Units of letters of which nobody has said any."""

from collections.abc import Sequence
from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from radartrack.derive.reading.fitting_units import fitting_units
from radartrack.derive.reading.text import read_text
from radartrack.derive.reading.unit_text import read_unit
from radartrack.derive.units import METRE, ONE, RADIAN, SECOND, Unit

KNOWN = {"r": METRE, "T": SECOND, "beta": RADIAN, "v": METRE / SECOND}

CASES = [
    (["r + L"], "m", {"L": "m"}),
    (["sqrt(r^2 + p)"], "m", {"p": "m^2"}),
    (["r*cos(w*T + phi)"], "m", {"w": "1/s", "phi": "rad"}),
    (["a*T^2/2 + v*T + r"], None, {"a": "m/s^2"}),
    (["a^2*T", "v^2*T/b"], None, {"a": "m/s", "b": "1"}),
    (["exp(-T/tau)*s"], "m", {"tau": "s", "s": "m"}),
    (["atan2(h, r)"], None, {"h": "m"}),
    (["q*T^3/3"], "m^2", {"q": "m^2/s^3"}),
    (["x^n*(r/x)"], "m", {"x": "1", "n": "1"}),
    (["a*b", "r"], None, {"a": "m", "b": "1"}),
]


@pytest.mark.parametrize(("formulas", "unit", "found"), CASES, ids=[" = ".join(case[0]) for case in CASES])
def test_letters_have_the_units_in_which_formulas_add_up(
    formulas: Sequence[str], unit: str | None, found: dict[str, str]
):
    trees = [read_text(formula, {*KNOWN, *found}) for formula in formulas]
    wanted = None if unit is None else read_unit(unit).unit
    units = fitting_units(KNOWN, found, [(trees, wanted)])
    assert units == {
        name: ONE if one == "1" else RADIAN if one == "rad" else read_unit(one).unit for name, one in found.items()
    }


@given(st.lists(st.integers(-3, 3), min_size=2, max_size=2), st.integers(1, 4))
def test_a_letter_in_a_power_has_the_root_of_the_unit_that_is_asked_for(powers: list[int], power: int):
    unit = Unit(*map(Fraction, powers))
    tree = read_text(f"a^{power} + 0", {"a"})
    assert fitting_units({}, ["a"], [([tree], unit**power)])["a"] in ({unit} if unit != ONE else {ONE, RADIAN})


def test_what_fits_in_no_units_is_decided_by_what_stands_first():
    trees = [read_text(text, {*KNOWN, "a"}) for text in ("r + a", "T + a")]
    assert fitting_units(KNOWN, ["a"], [(trees, None)]) == {"a": METRE}
