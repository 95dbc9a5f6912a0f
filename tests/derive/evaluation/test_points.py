"""Corners of a domain: an orthogonal array of strength three, so that no two or three symbols are extreme unseen."""

from itertools import combinations, product

import pytest

from radartrack.derive.evaluation.points import BEFORE_THE_END, corner_points
from radartrack.derive.language.variable import Variable
from radartrack.derive.units import ONE, RADIAN


@pytest.mark.parametrize("count", range(1, 13))
def test_any_three_symbols_take_all_combinations_of_their_ends(count: int) -> None:
    symbols = [Variable(f"x{number}", "a symbol", ONE, -1.0 - number, 2.0 + number) for number in range(count)]
    corners = list(corner_points(symbols))
    assert len(corners) <= 4 * count
    for chosen in combinations(symbols, min(count, 3)):
        seen = {tuple(corner[symbol.name] for symbol in chosen) for corner in corners}
        assert seen == set(product(*((symbol.low, symbol.high) for symbol in chosen)))


def test_of_angles_the_corners_are_where_sines_and_cosines_do_not_vanish() -> None:
    corners = list(corner_points([Variable("beta", "an angle", RADIAN, -3.0, 3.0)]))
    assert {corner["beta"] for corner in corners} == {-BEFORE_THE_END * 3.0, BEFORE_THE_END * 3.0}


def test_of_no_symbols_there_is_one_corner() -> None:
    assert list(corner_points([])) == [{}]
