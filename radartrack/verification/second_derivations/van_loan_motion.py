"""Polynomial motion driven by white noise, from one exponential of a matrix (Van Loan 1978), in many digits."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

import mpmath

from radartrack.derive.language.tensor import Tensor
from radartrack.derive.motion.polynomial_motion import MOTIONS

METHOD = "the exponential of a matrix (Van Loan)"
Number = Any
Matrix = Any
At = Mapping[str, Number]
PLANE = ("x", "vx", "y", "vy")


def exponential(matrix: Matrix) -> Matrix:
    """e^M of a matrix some power of which is zero."""
    total, term, power = mpmath.eye(matrix.rows), mpmath.eye(matrix.rows), 0
    while any(term):
        power += 1
        term = term * matrix / power
        total += term
    return total


def drift(size: int) -> Matrix:
    """From each derivative of the position to the next."""
    found = mpmath.matrix(size, size)
    for m in range(size - 1):
        found[m, m + 1] = mpmath.mpf(1)
    return found


def moved(state: Sequence[Number], time: Number) -> list[Number]:
    """The state after some time."""
    return list(exponential(drift(len(state)) * time) * mpmath.matrix(list(state)))


def _transition_and_noise(size: int, time: Number, intensity: Number) -> tuple[Matrix, Matrix]:
    """F and Q, from e^(M T) with M = [[−A, q g gᵀ], [0, Aᵀ]], whose right blocks are F⁻¹ Q and Fᵀ."""
    both, a = mpmath.matrix(2 * size, 2 * size), drift(size)
    both[:size, :size], both[size:, size:] = -a, a.T
    both[size - 1, 2 * size - 1] = intensity
    found = exponential(both * time)
    transition = found[size:, size:].T
    return transition, transition * found[:size, size:]


def _tensor(matrix: Matrix) -> Tensor[Number]:
    return Tensor.build((matrix.rows, matrix.cols), lambda m, n: matrix[m, n])


def _transition(size: int) -> Callable[[At], Tensor[Number]]:
    return lambda at: _tensor(_transition_and_noise(size, at["T"], mpmath.mpf(1))[0])


def _noise(size: int) -> Callable[[At], Tensor[Number]]:
    return lambda at: _tensor(_transition_and_noise(size, at["T"], at["q"])[1])


def _plane_transition(at: At) -> Tensor[Number]:
    """Each velocity, and nothing else, moves the coordinate of its name."""
    a = mpmath.matrix(len(PLANE), len(PLANE))
    for axis in "xy":
        a[PLANE.index(axis), PLANE.index(f"v{axis}")] = mpmath.mpf(1)
    return _tensor(exponential(a * at["T"]))


def _plane_observation(_: At) -> Tensor[Number]:
    return Tensor.build((2, len(PLANE)), lambda a, n: mpmath.mpf(int(PLANE[n] == "xy"[a])))


DERIVATIONS: dict[str, Callable[[At], Tensor[Number]]] = {
    **{f"kinematics.{motion}.transition": _transition(size) for size, (motion, *_) in MOTIONS.items()},
    **{f"kinematics.{motion}.process_noise": _noise(size) for size, (motion, *_) in MOTIONS.items()},
    "kinematics.plane.transition": _plane_transition,
    "kinematics.plane.observation": _plane_observation,
}
