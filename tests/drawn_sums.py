"""Sizes drawn at random, points among them, and what sums are there: for tests of what the checker says of sums."""

import math
from random import Random
from typing import Any

from radartrack.verification.rounding.checker.sums.products_of_powers import Key, Polynomial
from radartrack.verification.rounding.checker.sums.sizes import Sizes

WIDTHS = (0.01, 0.3, 2.0, 8.0)
Ends = dict[int, tuple[float, float]]
Angle = tuple[int, int, float, float]


def drawn_sizes(flint: Any, random: Random) -> tuple[Sizes, Ends, Angle | None]:
    sizes, ends = Sizes(flint), {}
    for _ in range(random.randint(1, 4)):
        low = random.uniform(-3, 3)
        high = low + random.choice(WIDTHS)
        ends[sizes.atom(sizes.ball(low), sizes.ball(high))[0][0]] = low, high
    if random.random() < 0.5:
        ends[sizes.carrier()[0][0]] = 0.0, 0.0
    if random.random() < 0.5:
        return sizes, ends, None
    low = random.uniform(-3, -0.8)
    high = min(low + random.choice(WIDTHS), math.log(math.pi / 4))
    first, last = sizes.ball(low).exp(), sizes.ball(high).exp()
    sine = sizes.atom(first.sin().log().lower(), last.sin().log().upper())[0][0]
    cosine = sizes.atom(last.cos().log().lower(), first.cos().log().upper())[0][0]
    sizes.waves.append((sine, cosine))
    return sizes, ends, (sine, cosine, low, high)


def wide_sizes(flint: Any, random: Random) -> tuple[Sizes, Ends]:
    sizes, ends = Sizes(flint), {}
    for _ in range(3):
        low = random.uniform(-3, 0)
        high = low + random.choice((0.3, 2.0, 8.0))
        ends[sizes.atom(sizes.ball(low), sizes.ball(high))[0][0]] = low, high
    return sizes, ends


def drawn_point(sizes: Sizes, ends: Ends, angle: Angle | None, random: Random) -> dict[int, float]:
    point = {n: math.exp(random.choice([low, high, random.uniform(low, high)])) for n, (low, high) in ends.items()}
    point |= {n: random.choice([-1.0, 1.0]) for n in sizes.carriers}
    if angle:
        turn = math.exp(random.choice([angle[2], angle[3], random.uniform(angle[2], angle[3])]))
        point |= {angle[0]: math.sin(turn), angle[1]: math.cos(turn)}
    return point


def power(key: Key, point: dict[int, float]) -> float:
    return math.prod(point[n] ** e for n, e in key)


def size(sum_: Polynomial, sizes: Sizes, point: dict[int, float], before: int, end: int) -> float:
    """Of a sum, with an end of every size that was made for it."""

    def of(n: int) -> float:
        return point[n] if n < before else math.exp(float(sizes.atoms[n][end]))

    return sum(float(c) * math.prod(of(n) ** e for n, e in key) for key, c in sum_.items())


def drawn_sum(sizes: Sizes, ends: Ends, random: Random, terms: int) -> Polynomial:
    found: Polynomial = {}
    for _ in range(terms):
        key = tuple((n, float(e)) for n, e in ((n, random.choice([0, 1, 2, 3, -1])) for n in ends) if e)
        found[key] = sizes.ball(random.choice((0.25, 1.0, 3.0)))
    return found
