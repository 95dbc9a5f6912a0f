import pytest

from radartrack.derive.checking.question.formula_units import Dimension, WrongDimensions, check_dimension, dimensions
from radartrack.derive.reading.text import read_text
from radartrack.derive.units import METRE, METRE_PER_SECOND, ONE, RADIAN, SECOND, Unit

UNITS = {"r": METRE, "x": METRE, "v": METRE_PER_SECOND, "T": SECOND, "beta": RADIAN, "s": RADIAN, "u": ONE}
KNOWN = {name: Dimension.of(unit) for name, unit in UNITS.items()}

RIGHT: list[tuple[str, Unit]] = [
    ("r + 2*x", METRE),
    ("r*cos(beta) - x*sin(2*beta)", METRE),
    ("r**2*s**2*sin(beta)**2 + x**2*cos(beta)**2", METRE**2),
    ("sqrt(r**2 + x**2)", METRE),
    ("hypot(r, x)/T", METRE_PER_SECOND),
    ("r*exp(-s**2/2)*(cosh(s**2) - 1)", METRE),
    ("v*T + abs(r)", METRE),
    ("atan2(r, x) + beta", RADIAN),
    ("r*sqrt(1 - u**2)", METRE),
    ("r**2/x*u", METRE),
    ("r + 0", METRE),
    ("e**(-s**2)*r", METRE),
    ("2*7", METRE),
    ("0", METRE**2),
]

WRONG: list[tuple[str, Unit]] = [
    ("r + 1", METRE),
    ("r + x**2", METRE),
    ("r + v", METRE),
    ("sqrt(1 + v**2)", ONE),
    ("sin(r)", ONE),
    ("r*sin(beta**2)", METRE),
    ("r*exp(-s)", METRE),
    ("r*cosh(r)", METRE),
    ("atan2(r, T)", RADIAN),
    ("hypot(r, v)", METRE),
    ("r**2", METRE),
    ("u", METRE),
    ("2**r", ONE),
    ("r*log(x)", METRE),
]


@pytest.mark.parametrize(("formula", "unit"), RIGHT)
def test_formulas_with_the_right_unit_pass(formula: str, unit: Unit) -> None:
    check_dimension(dimensions(KNOWN)(read_text(formula, UNITS)), Dimension.of(unit))


@pytest.mark.parametrize(("formula", "unit"), WRONG)
def test_formulas_with_another_unit_or_none_are_refused(formula: str, unit: Unit) -> None:
    with pytest.raises(WrongDimensions):
        check_dimension(dimensions(KNOWN)(read_text(formula, UNITS)), Dimension.of(unit))


def test_the_refusal_names_both_terms_and_their_units() -> None:
    with pytest.raises(WrongDimensions, match=r"v\*\*2 \[m\^2/s\^2\]") as refused:
        dimensions(KNOWN)(read_text("1 + v**2", UNITS))
    assert "1 [no unit]" in str(refused.value)
