"""Turns as arcs of circles: the chord has half the turn's direction, and derivatives are differences in many digits."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from itertools import product
from typing import Any

import mpmath

from radartrack.derive.language.tensor import Tensor
from radartrack.verification.second_derivations.van_loan_motion import without_residues

METHOD = "chords of arcs, and their differences"
DIGITS = 150  # a second difference leaves a third of them
Number = Any
At = Mapping[str, Number]
Map = Callable[..., list[Number]]


def along_heading(x: Number, y: Number, speed: Number, heading: Number, omega: Number, T: Number) -> list[Number]:
    """The state (x, y, speed, heading, omega) after a period."""
    half = omega * T / 2
    chord = speed * T * mpmath.sin(half) / half
    middle = heading + half
    return [x + chord * mpmath.cos(middle), y + chord * mpmath.sin(middle), speed, heading + 2 * half, omega]


def along_velocity(x: Number, vx: Number, y: Number, vy: Number, omega: Number, T: Number) -> list[Number]:
    """The state (x, vx, y, vy, omega) after a period, by speed and heading."""
    speed, heading = mpmath.hypot(vx, vy), mpmath.atan2(vy, vx)
    x, y, speed, heading, omega = along_heading(x, y, speed, heading, omega, T)
    return [x, speed * mpmath.cos(heading), y, speed * mpmath.sin(heading), omega]


MAPS: dict[str, tuple[Map, Sequence[str]]] = {
    "motion.turn.unknown_rate": (along_velocity, ("x", "vx", "y", "vy", "omega")),
    "motion.ctrv": (along_heading, ("x", "y", "speed", "heading", "omega")),
}


def _values(moved: Map, state: Sequence[str]) -> Callable[[At], Tensor[Number]]:
    return lambda at: Tensor((len(state),), tuple(moved(*(at[name] for name in (*state, "T")))))


def _differences(moved: Map, state: Sequence[str], order: int) -> Callable[[At], Tensor[Number]]:
    """The derivatives of one order, [out, in, ...]."""
    size = len(state)

    def values(at: At) -> Tensor[Number]:
        with mpmath.workdps(DIGITS):
            point = tuple(at[name] for name in (*state, "T"))
            found = {
                (out, *by): mpmath.diff(
                    lambda *given, out=out: moved(*given)[out],
                    point,
                    (*(by.count(place) for place in range(size)), 0),
                )
                for out, by in product(range(size), product(range(size), repeat=order))
            }
        return without_residues(Tensor.build((size,) * (order + 1), lambda *index: found[index]))

    return values


DERIVATIONS: dict[str, Callable[[At], Tensor[Number]]] = {
    f"{name}.{row}": derivation
    for name, (moved, state) in MAPS.items()
    for row, derivation in (
        ("map", _values(moved, state)),
        ("jacobian", _differences(moved, state, 1)),
        ("hessian", _differences(moved, state, 2)),
    )
}
