"""Polynomial motion of one axis, driven by noise in its next derivative, from scan to scan.

The n-th derivative of the position is noise: x⁽ⁿ⁾ = w. It is white, E w(t) w(s) = q δ(t − s), or constant over a
period, of deviation σ_w. In a Wiener sequence it is neither: the (n−1)-th derivative jumps at each scan, by σ_w.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache

from radartrack.derive.bibliography import cite
from radartrack.derive.language.matrix import ONE, ZERO
from radartrack.derive.language.quantity import Quantity
from radartrack.derive.language.shared_symbols import T
from radartrack.derive.language.tensor import Tensor
from radartrack.derive.language.variable import Variable
from radartrack.derive.motion.linear_motion import LinearMotion
from radartrack.derive.motion.motion_quantities import CONTINUOUS, PIECEWISE, WIENER_SEQUENCE, State, as_derived
from radartrack.derive.symbolic import Expr
from radartrack.derive.units import METRE, SECOND, Unit

SOURCE = cite("barshalom2001", "6.2-6.3")
MOTIONS = {
    1: ("constant_position", "position", "position", "velocity"),
    2: ("constant_velocity", "position and velocity", "velocity", "acceleration"),
    3: ("constant_acceleration", "position, velocity and acceleration", "acceleration", "jerk"),
    4: ("constant_jerk", "position, velocity, acceleration and jerk", "jerk", "derivative of the jerk"),
}


@cache
def motion(size: int) -> LinearMotion:
    """A position and its derivatives, `size` in all; noise drives the last one."""
    drift = tuple(tuple(ONE if n == m + 1 else ZERO for n in range(size)) for m in range(size))
    return LinearMotion(drift, (size - 1,))


def transition(size: int) -> Tensor[Expr]:
    """F(T) = e^(AT) for `size` derivatives; A shifts, so the series ends."""
    return motion(size).transition


@cache
def process_noise(size: int) -> Tensor[Expr]:
    """Q(T) for white noise in the next derivative."""
    return motion(size).continuous_noise(noise_intensity(size))


@cache
def noise_intensity(size: int) -> Variable:
    """Q, the intensity of the white noise that drives a motion of `size` derivatives."""
    unit = METRE**2 / SECOND ** (2 * size - 1)
    return Variable("q", f"intensity of the white noise in the {MOTIONS[size][3]}", unit, 1e-9, 1e6)


@cache
def noise_deviation(size: int) -> Variable:
    """The deviation of a noise that is constant over a period."""
    meaning = f"standard deviation of the {MOTIONS[size][3]}, constant over a period"
    return Variable("sigma_w", meaning, METRE / SECOND**size, 1e-6, 1e3)


@cache
def jump_deviation(size: int) -> Variable:
    """The deviation of a jump at a scan."""
    meaning = f"standard deviation of the jump of the {MOTIONS[size][2]} at a scan"
    return Variable("sigma_w", meaning, METRE / SECOND ** (size - 1), 1e-6, 1e3)


def quantities() -> Iterator[Quantity]:
    """F and Q of every motion."""
    for size in MOTIONS:
        yield from _quantities(size)


def units(size: int) -> tuple[Unit, ...]:
    """Those of a position and its derivatives."""
    return tuple(METRE / SECOND**n for n in range(size))


def _quantities(size: int) -> Iterator[Quantity]:
    name, text, last, driven = MOTIONS[size]
    state, of = State(name, f"{text} of one axis", units(size), SOURCE), motion(size)
    q, steady, jump = noise_intensity(size), noise_deviation(size), jump_deviation(size)
    white = f"white noise in the {driven}"
    article = "an" if driven[0] in "aeiou" else "a"
    constant = f"{article} {driven} that is noise, constant over a period"
    jumping = f"jumps of the {last} at each scan, a Wiener sequence"

    def piecewise() -> Tensor[Expr]:
        return of.piecewise_noise(steady)

    def sequence() -> Tensor[Expr]:
        return of.jump_noise(jump)

    def continuous() -> Tensor[Expr]:
        return process_noise(size)

    yield state.transition((T,), lambda: of.transition, as_derived(lambda: of.transition))
    yield state.noise(".continuous", white, CONTINUOUS, (T, q), continuous, as_derived(continuous))
    yield state.noise(".piecewise", constant, PIECEWISE, (T, steady), piecewise, as_derived(piecewise))
    yield state.noise(".wiener_sequence", jumping, WIENER_SEQUENCE, (T, jump), sequence, as_derived(sequence))
