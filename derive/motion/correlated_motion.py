"""Motions whose highest derivative forgets itself: Singer's acceleration, and the velocity of Ornstein and Uhlenbeck.

That derivative obeys a' = −α a + w with white noise w; α is one over its time constant. In Singer's model w has the
intensity 2 α σ_m², so that the acceleration has the deviation σ_m once it has forgotten how it began.

With x = αT, what noise leaves in the derivatives is r₀ = e^(−x) and r_n = ∫ r_(n−1): 1 − e^(−x), x − 1 + e^(−x), …,
what is left of the series of e^(−x), whose digits `remainder` keeps. Process noise is made of ∫ r_m r_n. In closed
form its terms cancel where x is small: x⁵/20 is left of terms like 1. Integrated by parts it is made of products of
r_n, which do not cancel there, but where x is large. So both are written, with a weight between them.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache
from math import factorial

from radartrack.derive import symbolic as sp
from radartrack.derive.bibliography import cite
from radartrack.derive.language.matrix import ONE, ZERO
from radartrack.derive.language.quantity import Quantity
from radartrack.derive.language.shared_symbols import T
from radartrack.derive.language.stable_form import StableForm
from radartrack.derive.language.tensor import Tensor
from radartrack.derive.language.variable import Variable
from radartrack.derive.motion.linear_motion import LinearMotion
from radartrack.derive.motion.motion_quantities import CONTINUOUS, State, symmetric
from radartrack.derive.motion.polynomial_motion import units
from radartrack.derive.symbolic import Expr, Symbol
from radartrack.derive.units import METRE, SECOND

CROSSING = 2  # the largest x for which products are better: there either form loses three bits, at 3 products lose four

alpha = Variable("alpha", "one over the time constant", SECOND**-1, 1e-6, 1.0)
sigma_m = Variable("sigma_m", "standard deviation of the acceleration", METRE / SECOND**2, 1e-6, 1e3)
q = Variable("q", "intensity of the white noise that drives the velocity", METRE**2 / SECOND**3, 1e-9, 1e6)
SINGER = State("singer", "position, velocity and acceleration of one axis", units(3), cite("singer1970"))
ORNSTEIN_UHLENBECK = State("ornstein_uhlenbeck", "position and velocity of one axis", units(2), cite("uhlenbeck1930"))

decay, near = sp.Symbol("decay", real=True), sp.Symbol("near", real=True)
rest = tuple(sp.Symbol(f"rest_{n}", real=True) for n in range(6))


@cache
def motion(size: int) -> LinearMotion:
    """A position and its derivatives, `size` in all, the last of which forgets itself and is driven."""
    last = size - 1
    drift = tuple(
        tuple(ONE if n == m + 1 else -alpha if m == n == last else ZERO for n in range(size)) for m in range(size)
    )
    return LinearMotion(drift, (last,), alpha)


def intensity(state: State) -> Expr:
    """Of the noise that drives the last derivative."""
    return 2 * alpha * sigma_m**2 if state is SINGER else q


def quantities() -> Iterator[Quantity]:
    """F and Q of both motions."""
    yield from _quantities(SINGER, sigma_m, "a correlated acceleration")
    yield from _quantities(ORNSTEIN_UHLENBECK, q, "a velocity that is an Ornstein-Uhlenbeck process")


def _quantities(state: State, strength: Variable, driven: str) -> Iterator[Quantity]:
    size = len(state.units)
    word = f"{CONTINUOUS}, q = 2 alpha sigma_m^2" if state is SINGER else CONTINUOUS
    yield state.transition((T, alpha), lambda: motion(size).transition, lambda: _transition(size))
    yield state.noise(
        "",
        driven,
        word,
        (T, alpha, strength),
        lambda: motion(size).continuous_noise(intensity(state)),
        lambda: _noise(size, intensity(state)),
    )


def _transition(size: int) -> StableForm:
    """What is left of the last derivative in it and those before; the others move as polynomials do."""

    def entry(m: int, n: int) -> Expr:
        if n < size - 1:
            return T ** (n - m) / sp.Integer(factorial(n - m)) if n >= m else ZERO
        return rest[n - m] / alpha ** (n - m)

    return _over_rests(Tensor.build((size, size), entry))


def _noise(size: int, strength: Expr) -> StableForm:
    def entry(m: int, n: int) -> Expr:
        order = 2 * size - 1 - m - n
        return strength * _overlap(size - 1 - n, size - 1 - m) / alpha**order

    return _over_rests(symmetric(entry, size))


def _overlap(low: int, high: int) -> Expr:
    """∫ r_low r_high from 0 to x."""
    r = rest
    beside = r[3] - r[2] ** 2 / 2  # of r_0 and r_2, from r_0 = 1 - r_1
    forgotten = -sp.expm1(-2 * decay) / 2
    by_parts: dict[tuple[int, int], Expr] = {
        (0, 0): forgotten,
        (0, 1): r[1] ** 2 / 2,
        (1, 2): r[2] ** 2 / 2,
        (0, 2): beside,
        (1, 1): r[1] * r[2] - beside,
        (2, 2): r[2] * r[3] - r[1] * r[4] + r[5] - r[2] * r[4] + r[3] ** 2 / 2,
    }
    closed: dict[tuple[int, int], Expr] = {
        (0, 2): forgotten - decay * r[0],
        (1, 1): r[2] - r[1] ** 2 / 2,
        (2, 2): forgotten + decay - decay**2 + decay**3 / 3 - 2 * decay * r[0],
    }
    both = by_parts[low, high]
    return near * both + (1 - near) * closed[low, high] if (low, high) in closed else both


def _over_rests(entries: Tensor[Expr]) -> StableForm:
    definitions: dict[Symbol, Expr] = {
        decay: alpha * T,
        near: sp.below(decay, sp.Integer(CROSSING)),
        rest[0]: sp.exp(-decay),
        rest[1]: -sp.expm1(-decay),
        **{rest[n]: (-1) ** n * sp.remainder(-decay, sp.Integer(n)) for n in range(2, len(rest))},
    }
    return StableForm(definitions, entries, frozenset({near})).only(entries)
