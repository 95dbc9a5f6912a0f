"""Discretised motion against the differential equations that it solves, not against the integrals it came from."""

import pytest
import sympy

from radartrack.derive.language.shared_symbols import T
from radartrack.derive.language.tensor import Tensor
from radartrack.derive.motion.polynomial_motion import MOTIONS, noise_intensity, process_noise, transition


def matrix(entries: Tensor[sympy.Expr]) -> sympy.Matrix:
    return sympy.Matrix(*entries.shape, list(entries))


def shift(size: int) -> sympy.Matrix:
    return sympy.Matrix(size, size, lambda m, n: int(n == m + 1))


@pytest.mark.parametrize("size", MOTIONS)
def test_the_transition_solves_its_differential_equation(size: int) -> None:
    F = matrix(transition(size))
    assert F.diff(T) == (shift(size) * F).expand()
    assert F.subs(T, 0) == sympy.eye(size)


@pytest.mark.parametrize("size", MOTIONS)
def test_the_process_noise_solves_the_lyapunov_equation(size: int) -> None:
    Q, A = matrix(process_noise(size)), shift(size)
    driving = sympy.zeros(size)
    driving[-1, -1] = noise_intensity(size)
    assert (Q.diff(T) - A * Q - Q * A.T - driving).expand() == sympy.zeros(size)
    assert Q.subs(T, 0) == sympy.zeros(size)


@pytest.mark.parametrize("size", MOTIONS)
def test_two_steps_are_one_of_twice_the_time(size: int) -> None:
    F, Q = matrix(transition(size)), matrix(process_noise(size))
    assert (F * F).expand() == F.subs(T, 2 * T).expand()
    assert (F * Q * F.T + Q).expand() == Q.subs(T, 2 * T).expand()
