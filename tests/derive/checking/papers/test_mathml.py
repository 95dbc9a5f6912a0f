"""Formulas as MathML: names as print has them."""

from xml.etree import ElementTree as ET

import pytest

from radartrack.derive.checking.papers.mathml import mathml


@pytest.mark.parametrize(
    ("formula", "letters"),
    [
        ("sigma_beta**2", ["σ", "β", "2"]),
        ("dtheta_1", ["d", "θ", "1"]),
        ("dtheta_1**2", ["d", "θ", "1", "2"]),
        ("dx*dy", ["d", "x", "d", "y"]),
        ("d_1", ["d", "1"]),
        ("delta_x", ["δ", "x"]),
        ("design", ["design"]),
    ],
)
def test_names_are_set_as_letters_with_what_stands_below(formula: str, letters: list[str]) -> None:
    tree = ET.fromstring(mathml(formula))  # noqa: S314 - our own markup
    assert [element.text for element in tree.iter() if element.tag in {"mi", "mn"}] == letters


def test_the_power_of_a_differential_stands_above_the_letter_and_its_index() -> None:
    tree = ET.fromstring(mathml("dtheta_1**2"))  # noqa: S314 - our own markup
    (with_index_and_power,) = tree.iter("msubsup")
    assert [element.text for element in with_index_and_power.iter() if element.text] == ["θ", "1", "2"]


def test_what_is_no_formula_is_not_set() -> None:
    assert mathml("r +") == ""
    assert mathml("r+" * 3_000 + "r") == ""
