"""Polynomial motion of one axis, driven by white noise in its highest derivative, from scan to scan.

The n-th derivative of the position is white noise of intensity q: x⁽ⁿ⁾ = w, E w(t) w(s) = q δ(t − s). With A the
shift from each derivative to the next, exact discretisation gives F(T) = e^(AT) and
Q(T) = q ∫₀ᵀ e^(As) g gᵀ e^(As)ᵀ ds, where g is the last unit vector.
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from functools import cache
from math import factorial

from radartrack.derive import symbolic as sp
from radartrack.derive.bibliography import cite
from radartrack.derive.language.quantity import Conditioning, Quantity
from radartrack.derive.language.shared_symbols import T
from radartrack.derive.language.tensor import Tensor
from radartrack.derive.language.variable import Variable
from radartrack.derive.symbolic import Expr
from radartrack.derive.units import METRE, SECOND, Unit

SOURCE = cite("barshalom2001", "6.2")
MOTIONS = {
    1: ("constant_position", "position", "velocity"),
    2: ("constant_velocity", "position and velocity", "acceleration"),
    3: ("constant_acceleration", "position, velocity and acceleration", "jerk"),
    4: ("constant_jerk", "position, velocity, acceleration and jerk", "derivative of the jerk"),
}


@cache
def transition(size: int) -> Tensor[Expr]:
    """F(T) = e^(AT) for `size` derivatives; A shifts, so the series ends."""
    return Tensor.build((size, size), lambda m, n: _series(n - m))


@cache
def process_noise(size: int) -> Tensor[Expr]:
    """Q(T), the integral over the last column of F."""
    response = transition(size)

    def entry(m: int, n: int) -> Expr:
        return noise_intensity(size) * _integral(response[m, size - 1] * response[n, size - 1])

    return Tensor.build((size, size), entry)


@cache
def noise_intensity(size: int) -> Variable:
    """Q, the intensity of the white noise that drives a motion of `size` derivatives."""
    return Variable("q", f"intensity of the white noise in the {MOTIONS[size][2]}", _intensity(size), 1e-9, 1e6)


def quantities() -> list[Quantity]:
    """F(T) and Q(T) of every motion."""
    return [quantity for size in MOTIONS for quantity in (_transition(size), _process_noise(size))]


def _series(power: int) -> Expr:
    return T**power / sp.Integer(factorial(power)) if power >= 0 else sp.Integer(0)


def _integral(monomial: Expr) -> Expr:
    """∫₀ᵀ of c sᵖ, written with T for s."""
    power = int(monomial.as_powers_dict().get(T, sp.Integer(0)))
    return monomial * T / sp.Integer(power + 1)


def _units(size: int) -> tuple[Unit, ...]:
    return tuple(METRE / SECOND**n for n in range(size))


def _intensity(size: int) -> Unit:
    return METRE**2 / SECOND ** (2 * size - 1)


def _transition(size: int) -> Quantity:
    units = _units(size)
    inverse = tuple(unit ** Fraction(-1) for unit in units)
    return _quantity(size, "transition", "transition", "F = e^(AT)", (units, inverse), (T,), lambda: transition(size))


def _process_noise(size: int) -> Quantity:
    units = _units(size)
    return _quantity(
        size,
        "process_noise",
        "covariance of the process noise",
        "Q = q int_0^T e^(As) g g' e^(As)' ds",
        (units, units),
        (T, noise_intensity(size)),
        lambda: process_noise(size),
    )


def _quantity(
    size: int,
    name: str,
    meaning: str,
    word: str,
    axes: tuple[tuple[Unit, ...], ...],
    symbols: tuple[Variable, ...],
    derivation: Callable[[], Tensor[Expr]],
) -> Quantity:
    motion, state, driven = MOTIONS[size]
    return Quantity(
        name=f"kinematics.{motion}.{name}",
        meaning=f"{meaning} of {state} of one axis from scan to scan, with white noise in the {driven}",
        axes=axes,
        symbols=symbols,
        conditioning=Conditioning.NONE,
        source=SOURCE,
        word=word,
        derivation=derivation,
    )
