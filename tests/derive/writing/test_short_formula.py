"""What is shown is what the reader takes back, without guards, and a verdict shows nothing longer."""

from __future__ import annotations

import pytest

from radartrack.derive.catalogue import catalogue
from radartrack.derive.checking.check import check
from radartrack.derive.language.quantity import Quantity
from radartrack.derive.writing import quantity_text

GUARDS = ("ratio(", "hypot(", "expm1(", "remainder(")
SHOWN = [
    quantity
    for quantity in catalogue().values()
    if quantity.name.startswith(("observe.", "line.", "polar.map", "polar.bias", "polar.unbiased", "polar.covariance"))
]


@pytest.mark.parametrize("quantity", SHOWN, ids=lambda quantity: quantity.name)
def test_no_guard_of_the_code_is_shown(quantity: Quantity) -> None:
    last = tuple(size - 1 for size in quantity.shape)
    text = quantity_text.text(quantity, last or None)
    assert not [guard for guard in GUARDS if guard in text]


@pytest.mark.parametrize(
    "name", ["observe.spherical.jacobian[2,0]", "polar.bias.truth[0]", "polar.unbiased.estimate[1]"]
)
def test_a_verdict_is_as_short_as_what_is_shown_and_is_equal_itself(name: str) -> None:
    quantity, place = name.rstrip("]").split("[")
    shown = quantity_text.text(catalogue()[quantity], tuple(map(int, place.split(","))))
    assert check(name, "7").derived == shown
    assert check(name, shown).verdict == "equal"
