"""What the checker makes of sums with signs, against their values at points."""

from random import Random
from typing import Any

import pytest

from radartrack.verification.rounding.checker.sums.products_of_powers import Key, total
from radartrack.verification.rounding.checker.sums.signs import Signs
from radartrack.verification.rounding.checker.sums.sizes import Sizes
from tests.drawn_sums import Angle, Ends, drawn_point, drawn_sizes, power, size

flint = pytest.importorskip("flint")
COEFFICIENTS = (1, 2, 5, -1, -3, 0.25)


def test_the_sign_and_size_that_are_found_of_a_sum_hold_at_points_of_its_box():
    random, found = Random(3), 0
    for _ in range(400):
        sizes, ends, angle = drawn_sizes(flint, random)
        value = drawn_value(sizes, ends, angle, random)
        before = len(sizes.atoms)
        result = Signs(sizes).of_one_sign(value) if value else None
        if result is None:
            continue
        found += 1
        for _ in range(12):
            point = drawn_point(sizes, ends, angle, random)
            signed = sum(float(c.p) / float(c.q) * power(key, point) for key, c in value.items())
            rounding = 1e-9 * sum(abs(float(c.p) / float(c.q) * power(key, point)) for key, c in value.items())
            low, high = (size(result[1], sizes, point, before, end) for end in (0, 1))
            assert low - rounding <= abs(signed) <= high + rounding
            assert result[0] * signed >= -rounding
    assert found > 150


def drawn_value(sizes: Sizes, ends: Ends, angle: Angle | None, random: Random) -> dict[Key, Any]:
    value: dict[Key, Any] = {}
    for _ in range(random.randint(1, 6)):
        powers = {n: random.choice([0, 0, 1, 2]) for n in [*ends, *(angle[:2] if angle else ())]}
        key = tuple((n, float(e % 2 if n in sizes.carriers else e)) for n, e in sorted(powers.items()))
        value = total(value, {tuple(part for part in key if part[1]): sizes.rational(random.choice(COEFFICIENTS))})
    return value
