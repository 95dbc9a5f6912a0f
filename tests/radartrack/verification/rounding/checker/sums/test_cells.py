"""What cells say of a sum of few sizes, against its values at points."""

import math
from random import Random
from typing import Any

import pytest

from radartrack.verification.rounding.checker.sums import cells as module_of_cells
from radartrack.verification.rounding.checker.sums.cells import Along, Cell, Key, cells, ends, largest_share, sum_on

flint = pytest.importorskip("flint")
COEFFICIENTS = (1.0, 2.0, 0.5, -1.0, -0.75, -3.0)
Sum = dict[Key, float]
Point = dict[int, float]


def drawn_sum(random: Random, numbers: int, terms: int) -> Sum:
    drawn = (
        tuple((n, float(random.choice((1, 2, -1)))) for n in range(numbers) if random.random() < 0.6)
        for _ in range(terms)
    )
    return {key: random.choice(COEFFICIENTS) for key in drawn}


def at(sum_: Sum, point: Point) -> float:
    return sum(c * math.exp(sum(e * point[n] for n, e in key)) for key, c in sum_.items())


def balls(sum_: Sum) -> dict[Key, Any]:
    return {key: flint.arb(c) for key, c in sum_.items()}


def drawn_box(random: Random) -> dict[int, tuple[float, float]]:
    lows = {n: random.uniform(-2.0, 1.0) for n in range(random.randint(1, 3))}
    return {n: (low, low + random.choice((0.01, 0.5, 2.0))) for n, low in lows.items()}


def share_of(error: Sum, parts: list[Cell], others: dict[int, tuple[Any, Any]] | None = None) -> float:
    found = largest_share(balls(error), parts, others or {})
    assert found is not None
    return float(found)


def in_balls(box: dict[int, tuple[float, float]]) -> dict[int, tuple[Any, Any]]:
    return {n: (flint.arb(low), flint.arb(high)) for n, (low, high) in box.items()}


def test_a_sum_lies_between_its_ends_and_an_error_is_no_larger_a_share():
    random, found, tight = Random(8), 0, 0
    for _ in range(300):
        box = drawn_box(random)
        value, error = drawn_sum(random, len(box), 4), drawn_sum(random, len(box), 3)
        error = {key: abs(c) for key, c in error.items()}
        parts = cells(balls(value), in_balls(box))
        if parts is None:
            continue
        found += 1
        low, high = (float(end) for end in ends(parts))
        share = share_of(error, parts)
        worst = 0.0
        for _ in range(60):
            point = {n: random.choice((a, b, random.uniform(a, b))) for n, (a, b) in box.items()}
            here = at(value, point)
            assert low - 1e-12 * abs(low) <= here <= high + 1e-12 * abs(high)
            worst = max(worst, at(error, point) / abs(here))
        assert worst <= share * (1 + 1e-12)
        tight += share < 3 * worst
    assert found > 100
    assert tight > found / 2  # a share that nothing comes near would show nothing


def test_the_cells_cover_the_box():
    box = {0: (-20.0, 0.0), 1: (-20.0, 0.0)}
    value = {(): 1.0, ((0, 2.0),): -1.0, ((0, 4.0),): 5 / 12, ((1, 2.0),): -1.0, ((1, 4.0),): 0.75}
    value[((0, 2.0), (1, 2.0))] = 0.5
    parts = cells(balls(value), in_balls(box))
    assert parts is not None
    assert 10 < len(parts) <= module_of_cells.MOST
    area = sum(math.prod(float(high - low) for low, high in part.sizes.values()) for part in parts)
    assert area == pytest.approx(400.0)
    random = Random(2)
    for _ in range(300):
        point = {n: random.uniform(*span) for n, span in box.items()}
        inside = [p for p in parts if all(low <= point[n] <= high for n, (low, high) in p.sizes.items())]
        assert inside
        assert all(part.low <= at(value, point) + 1e-12 <= part.high + 2e-12 for part in inside)


@pytest.mark.parametrize(
    "value",
    [
        {(): 1.0, ((0, 1.0),): -1.0},  # vanishes at an end
        {(): 1.0, ((0, 1.0),): -2.0},  # changes its sign
        {(): 1.0, ((0, 1.0),): -4.0, ((0, 2.0),): 4.0},  # vanishes between
        {((0, 1.0),): 1.0, ((0, 1.0), (1, 1.0)): -1.0},
    ],
)
def test_a_sum_that_vanishes_has_no_cells(value: Sum):
    assert cells(balls(value), in_balls({0: (-3.0, 0.0), 1: (-1.0, 0.0)})) is None


def test_an_error_without_a_bound_has_no_share():
    parts = cells(balls({(): 1.0}), {})
    assert parts is not None
    endless = {7: (flint.arb(-math.inf), flint.arb(0))}
    assert share_of({((7, 1.0),): 1.0}, parts, endless) == pytest.approx(1)
    assert largest_share(balls({((7, -1.0),): 1.0}), parts, endless) is None


def test_a_sum_on_a_box_has_each_size_anywhere_between_its_ends():
    low, high = in_balls({0: (0.0, 1.0)})[0]
    found = sum_on(balls({((0, 1.0),): 1.0, ((0, -1.0),): -1.0}), {0: (low, high)})
    assert found.contains(0)
    assert found.contains(flint.arb(1).exp() - flint.arb(-1).exp())


def test_sizes_that_are_functions_of_one_argument_are_looked_at_together():
    value = {((1, 1.0),): 1.0, ((2, 1.0),): 1.0, (): -0.9}  # e^-x + (1 - e^-x) - 0.9
    span = in_balls({0: (-7.0, 1.5)})
    along = Along(
        0,
        {
            1: lambda low, high: (-high.exp(), -low.exp()),
            2: lambda low, high: ((-(-low.exp()).expm1()).log(), (-(-high.exp()).expm1()).log()),
        },
    )
    parts = cells(balls(value), span, along)
    assert parts is not None
    low, high = (float(end) for end in ends(parts))
    assert 0.03 < low <= 0.1 <= high < 0.3
    assert cells(balls(value), along(span)) is None
    share = share_of({((1, 1.0),): 1.0, ((2, 1.0),): 1.0}, parts)
    assert 10 <= share < 40
    for part in parts:
        at_low, at_high = (float(end.exp()) for end in part.sizes[0])
        assert float(part.sizes[1][0].exp()) <= math.exp(-at_high) * (1 + 1e-12)
        assert float(part.sizes[1][1].exp()) >= math.exp(-at_low) * (1 - 1e-12)
