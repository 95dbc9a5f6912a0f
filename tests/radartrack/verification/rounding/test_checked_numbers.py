"""What the checker makes of sums with signs, against their values at points."""

import math
from random import Random
from typing import Any

import pytest

from radartrack.verification.rounding import checked_numbers
from radartrack.verification.rounding.checked_numbers import MOST_PAIRS, Box, Key, Polynomial

flint = pytest.importorskip("flint")
WIDTHS = (0.01, 0.3, 2.0, 8.0)
COEFFICIENTS = (1, 2, 5, -1, -3, 0.25)
Ends = dict[int, tuple[float, float]]


def test_the_sign_and_size_that_are_found_of_a_sum_hold_at_points_of_its_box():
    random, found = Random(3), 0
    for _ in range(400):
        box, ends, angle = drawn_box(random)
        value = drawn_value(box, ends, angle, random)
        before = len(box.atoms)
        result = box.of_one_sign(value) if value else None
        if result is None:
            continue
        found += 1
        for _ in range(12):
            point = drawn_point(box, ends, angle, random)
            signed = sum(float(c.p) / float(c.q) * power(key, point) for key, c in value.items())
            rounding = 1e-9 * sum(abs(float(c.p) / float(c.q) * power(key, point)) for key, c in value.items())
            low, high = (size(result[1], box, point, before, end) for end in (0, 1))
            assert low - rounding <= abs(signed) <= high + rounding
            assert result[0] * signed >= -rounding
    assert found > 150


def drawn_box(random: Random) -> tuple[Box, Ends, tuple[int, int, float, float] | None]:
    box, ends = Box(flint), {}
    for _ in range(random.randint(1, 4)):
        low = random.uniform(-3, 3)
        high = low + random.choice(WIDTHS)
        ends[box.atom(box.ball(low), box.ball(high))[0][0]] = low, high
    if random.random() < 0.5:
        ends[box.carrier()[0][0]] = 0.0, 0.0
    if random.random() < 0.5:
        return box, ends, None
    low = random.uniform(-3, -0.8)
    high = min(low + random.choice(WIDTHS), math.log(math.pi / 4))
    first, last = box.ball(low).exp(), box.ball(high).exp()
    sine = box.atom(first.sin().log().lower(), last.sin().log().upper())[0][0]
    cosine = box.atom(last.cos().log().lower(), first.cos().log().upper())[0][0]
    box.waves.append((sine, cosine))
    return box, ends, (sine, cosine, low, high)


def drawn_value(box: Box, ends: Ends, angle: Any, random: Random) -> dict[Key, Any]:
    value: dict[Key, Any] = {}
    for _ in range(random.randint(1, 6)):
        powers = {n: random.choice([0, 0, 1, 2]) for n in [*ends, *(angle[:2] if angle else ())]}
        key = tuple((n, float(e % 2 if n in box.carriers else e)) for n, e in sorted(powers.items()))
        value = box.total(value, {tuple(part for part in key if part[1]): box.rational(random.choice(COEFFICIENTS))})
    return value


def drawn_point(box: Box, ends: Ends, angle: Any, random: Random) -> dict[int, float]:
    point = {n: math.exp(random.choice([low, high, random.uniform(low, high)])) for n, (low, high) in ends.items()}
    point |= {n: random.choice([-1.0, 1.0]) for n in box.carriers}
    if angle:
        turn = math.exp(random.choice([angle[2], angle[3], random.uniform(angle[2], angle[3])]))
        point |= {angle[0]: math.sin(turn), angle[1]: math.cos(turn)}
    return point


def power(key: Key, point: dict[int, float]) -> float:
    return math.prod(point[n] ** e for n, e in key)


def size(sum_: Polynomial, box: Box, point: dict[int, float], before: int, end: int) -> float:
    """Of a sum, with an end of every size that was made for it."""

    def of(n: int) -> float:
        return point[n] if n < before else math.exp(float(box.atoms[n][end]))

    return sum(float(c) * math.prod(of(n) ** e for n, e in key) for key, c in sum_.items())


def drawn_sum(box: Box, ends: Ends, random: Random, terms: int) -> Polynomial:
    found: Polynomial = {}
    for _ in range(terms):
        key = tuple((n, float(e)) for n, e in ((n, random.choice([0, 1, 2, 3, -1])) for n in ends) if e)
        found[key] = box.ball(random.choice((0.25, 1.0, 3.0)))
    return found


def wide_box(random: Random) -> tuple[Box, Ends]:
    box, ends = Box(flint), {}
    for _ in range(3):
        low = random.uniform(-3, 0)
        high = low + random.choice((0.3, 2.0, 8.0))
        ends[box.atom(box.ball(low), box.ball(high))[0][0]] = low, high
    return box, ends


def test_a_long_sum_is_condensed_to_few_terms_that_are_as_much():
    random, shorter = Random(7), 0
    for _ in range(40):
        box, ends = wide_box(random)
        sum_ = drawn_sum(box, ends, random, 100)
        before = len(box.atoms)
        found = box.condensed(sum_)
        if found is None:
            continue
        shorter += len(found) < len(sum_) / 2
        for _ in range(20):
            point = drawn_point(box, ends, None, random)
            exact = size(sum_, box, point, before, 0)
            low, high = (size(found, box, point, before, end) for end in (0, 1))
            assert low * (1 - 1e-12) <= exact <= high * (1 + 1e-12)
    assert shorter > 20


@pytest.mark.parametrize("most", [MOST_PAIRS, 500])
def test_no_error_is_above_its_share_of_two_variances(most: int, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setattr(checked_numbers, "MOST_PAIRS", most)
    random, found = Random(12), 0
    for _ in range(40):
        box, ends = wide_box(random)
        first, second, error = (drawn_sum(box, ends, random, n) for n in (12, 9, 5))
        share = box.paired(error, first, second)
        if share is None:
            continue
        found += 1
        for _ in range(20):
            point = drawn_point(box, ends, None, random)
            a, b, e = (size(one, box, point, len(box.atoms), 0) for one in (first, second, error))
            assert e <= float(share) * math.sqrt(a * b) * (1 + 1e-12)
    assert found > 10
