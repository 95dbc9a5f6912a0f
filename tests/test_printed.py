"""A last digit may be rounded otherwise; a word, a count or a second unit may not."""

import pytest

from tests.printed import say_the_same


@pytest.mark.parametrize(
    ("printed", "written"),
    [
        ("NEES 1.80 RMSE 1226 m", "NEES 1.80 RMSE 1225 m"),
        ("3.2e-16 at -0.10", "3.1e-16 at -0.09"),
        ("−19.3 %", "−19.2 %"),
        ("9.99", "10.00"),
    ],
)
def test_one_unit_of_the_last_place_says_the_same(printed: str, written: str) -> None:
    assert say_the_same(printed, written)
    assert say_the_same(written, printed)


@pytest.mark.parametrize(
    ("printed", "written"),
    [
        ("NEES 1.82", "NEES 1.80"),
        ("33 claims: 9 undecided", "33 claims: 8 undecided"),
        ("1.5 km", "1.5 m"),
        ("x 1.5", "x 1.5 y"),
        ("0.1", "-0.1"),
        ("1.5 2.5", "1.5"),
    ],
)
def test_all_else_does_not(printed: str, written: str) -> None:
    assert not say_the_same(printed, written)
    assert not say_the_same(written, printed)
