"""Units as one types them."""

import math
from fractions import Fraction
from typing import Any

import pytest
import sympy
from hypothesis import given
from hypothesis import strategies as st

from radartrack.derive.formula.to_expression import to_expression
from radartrack.derive.reading.text import read_text
from radartrack.derive.reading.unit_text import BASE, Scale, measured, read_unit
from radartrack.derive.symbolic import Expr
from radartrack.derive.units import METRE, RADIAN, SECOND, Unit

powers = st.builds(Fraction, st.integers(-12, 12), st.integers(1, 3))
SI: dict[str, tuple[Unit, Any]] = {
    "km": (METRE, sympy.Integer(1000)),
    "ms": (SECOND, sympy.Rational(1, 1000)),
    "kHz": (SECOND**-1, sympy.Integer(1000)),
    "deg": (RADIAN, sympy.pi / 180),
    "mrad": (RADIAN, sympy.Rational(1, 1000)),
    "cm": (METRE, sympy.Rational(1, 100)),
    "mm": (METRE, sympy.Rational(1, 1000)),
    "ft": (METRE, sympy.Rational(12 * 254, 10_000)),  # an inch is 25.4 mm
    "mi": (METRE, sympy.Rational(5280 * 12 * 254, 10_000)),
    "nmi": (METRE, sympy.Integer(1852)),
    "NM": (METRE, sympy.Integer(1852)),
    "us": (SECOND, sympy.Rational(1, 10**6)),
    "min": (SECOND, sympy.Integer(60)),
    "h": (SECOND, sympy.Integer(3600)),
    "kn": (METRE / SECOND, sympy.Rational(463, 900)),
    "kt": (METRE / SECOND, sympy.Rational(463, 900)),
    "MHz": (SECOND**-1, sympy.Integer(10**6)),
    "%": (Unit(), sympy.Rational(1, 100)),
}


@given(powers, powers, powers)
def test_what_a_unit_prints_is_read_back(metre: Fraction, second: Fraction, radian: Fraction):
    unit = Unit(metre, second, radian)
    found = read_unit(str(unit))
    assert found == Scale(unit)


@given(
    st.lists(
        st.tuples(st.sampled_from(sorted(SI)), st.integers(-12, 12), st.sampled_from("*/")), min_size=1, max_size=4
    )
)
def test_a_product_has_the_unit_and_the_size_of_its_factors(factors: list[tuple[str, int, str]]):
    text, unit, size = "1", Unit(), sympy.Integer(1)
    for name, power, sign in factors:
        text += f"{sign}{name}^{power}"
        signed = power if sign == "*" else -power
        unit, size = unit * SI[name][0] ** signed, size * SI[name][1] ** signed
    found = read_unit(text)
    assert found.unit == unit
    assert sympy.simplify(to_expression(read_text(found.formula, ()), {}) / size) == 1


@given(st.lists(st.tuples(st.sampled_from(sorted(SI)), powers), min_size=1, max_size=3))
def test_a_root_of_a_unit_has_the_root_of_its_size(factors: list[tuple[str, Fraction]]):
    found = read_unit("*".join(f"{name}^({power})" for name, power in factors))
    formula = to_expression(read_text(found.formula, ()), {})
    assert isinstance(formula, Expr)
    size = float(formula)
    assert found.size == pytest.approx(size, rel=1e-12)
    expected = [float(SI[name][1]) ** float(power) for name, power in factors]
    assert size == pytest.approx(math.prod(expected), rel=1e-12)
    assert found.unit == math.prod((SI[name][0] ** power for name, power in factors), start=Unit())


@pytest.mark.parametrize(
    "text", ["", "x", "m/", "m^", "m m", "m^x", "m^99", "m^(1/0)", "m" * 100, "__import__('os')", "m;s"]
)
def test_what_is_no_unit_is_refused_with_a_word(text: str):
    with pytest.raises(ValueError, match=r"unit"):
        read_unit(text)


def test_every_unit_that_is_offered_is_read():
    assert [name for name in BASE if read_unit(name) != BASE[name]] == []


@pytest.mark.parametrize(
    ("text", "formula", "unit"),
    [
        ("30deg", "30*(pi/180)", "rad"),
        ("30°", "30*(pi/180)", "rad"),
        (" -2.5e3 km ", "-2.5e3*(1000)", "m"),
        ("9.81 m/s^2", "9.81", "m/s^2"),
        (".5 mrad", ".5*(1/1000)", "rad"),
        ("60 NM", "60*(1852)", "m"),
        ("36 km/h", "36*(5/18)", "m/s"),
        ("3 µs", "3*(1/1000000)", "s"),
    ],
)
def test_a_number_with_a_unit_is_a_formula_in_si_units(text: str, formula: str, unit: str):
    found = measured(text)
    assert found is not None
    assert (found.formula, str(found.unit)) == (formula, unit)


@pytest.mark.parametrize(
    "text", ["30", "deg", "30*deg", "2r", "30 deg + 1", "1e", "5 %", "2 h", "2 min", "__import__('os') m", ""]
)
def test_what_is_no_number_with_a_unit_stays_a_formula(text: str):
    assert measured(text) is None
