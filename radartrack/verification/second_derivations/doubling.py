"""Steady filters by doubling: each step takes twice as many scans as the one before (Anderson 1978), in many digits.

A filter of fading memory is known by its poles: all of them lie at the fading factor (Morrison 1969).
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from math import factorial
from typing import Any

import mpmath

from radartrack.derive.language.tensor import Tensor
from radartrack.verification.second_derivations.van_loan_motion import drift, exponential

METHOD = "doubling of the number of scans"
DIGITS = 120  # where the noise is small beside the errors, a steady state takes many scans
MOST_DOUBLINGS = 200
Number = Any
Matrix = Any
At = Mapping[str, Number]


def predicted(transition: Matrix, noise: Matrix) -> Matrix:
    """The steady covariance before a measurement of the first component, of variance one."""
    size = transition.rows
    a, g, h = transition.T, mpmath.matrix(size, size), noise
    g[0, 0] = mpmath.mpf(1)
    for _ in range(MOST_DOUBLINGS):
        between = mpmath.inverse(mpmath.eye(size) + g * h)
        added = a.T * h * between * a
        a, g, h = a * between * a, g + a * between * g * a.T, h + added
        if mpmath.norm(added) <= mpmath.eps * mpmath.norm(h):
            return h
    raise ArithmeticError("the doubling did not come to an end")


def accumulated(transition: Matrix, noise: Matrix) -> Matrix:
    """The sum of M^n N (M^n)' over all n."""
    power, total = transition, noise
    for _ in range(MOST_DOUBLINGS):
        added = power * total * power.T
        power, total = power * power, total + added
        if mpmath.norm(added) <= mpmath.eps * mpmath.norm(total):
            return total
    raise ArithmeticError("the doubling did not come to an end")


def _steady(size: int, at: At) -> tuple[Matrix, Matrix]:
    """Gain and covariance after a measurement, for T = 1 and errors of deviation one."""
    transition = exponential(drift(size))
    column = mpmath.matrix([mpmath.mpf(1) / factorial(n) for n in range(2, -1, -1)][:size])  # T^2/2, T, 1
    before = predicted(transition, at["index"] ** 2 * column * column.T)
    gain = before[:, 0] / (before[0, 0] + 1)
    return gain, before - gain * before[0, :]


def _fading(size: int, at: At) -> tuple[Matrix, Matrix]:
    """The same of a filter all of whose poles are θ."""
    transition, one = exponential(drift(size)), mpmath.eye(size)
    rows, right = mpmath.matrix(size, size), mpmath.matrix(size, 1)
    for n in range(size):
        z = mpmath.mpf(n + 2)
        rows[n, :] = (mpmath.inverse(z * one - transition) * transition)[0, :]
        right[n, 0] = ((z - at["theta"]) / (z - 1)) ** size - 1
    gain = mpmath.inverse(rows) * right
    seen = mpmath.matrix(1, size)
    seen[0, 0] = mpmath.mpf(1)
    return gain, accumulated((one - gain * seen) * transition, gain * gain.T)


def accumulated_between(first: Matrix, second: Matrix, noise: Matrix) -> Matrix:
    """The sum of M1^n N (M2^n)' over all n."""
    total = noise
    for _ in range(MOST_DOUBLINGS):
        added = first * total * second.T
        first, second, total = first * first, second * second, total + added
        if mpmath.norm(added) <= mpmath.eps * mpmath.norm(total):
            return total
    raise ArithmeticError("the doubling did not come to an end")


def _cross(at: At) -> Tensor[Number]:
    """Of two filters of one process, each with its own steady gain, from all accelerations that there were."""
    with mpmath.workdps(DIGITS):
        transition, one = exponential(drift(2)), mpmath.eye(2)
        column = mpmath.matrix([mpmath.mpf(1) / 2, mpmath.mpf(1)])
        reduced = []
        for number in (1, 2):
            gain, _ = _steady(2, {"index": at[f"index_{number}"]})
            seen = mpmath.matrix(1, 2)
            seen[0, 0] = mpmath.mpf(1)
            reduced.append(one - gain * seen)
        first, second = reduced
        noise = first * column * column.T * second.T
        found = accumulated_between(first * transition, second * transition, noise)
        scale = at["sigma_w"] ** 2
        return Tensor.build((2, 2), lambda m, n: scale * found[m, n] * at["T"] ** (4 - m - n))


def _cross_updated(at: At) -> Tensor[Number]:
    """One step in matrices, of states in metres and seconds."""
    transition = exponential(drift(2) * at["T"])
    column = mpmath.matrix([at["T"] ** 2 / 2, at["T"]])
    before = mpmath.matrix([[at["cross_00"], at["cross_01"]], [at["cross_10"], at["cross_11"]]])
    moved = transition * before * transition.T + at["sigma_w"] ** 2 * column * column.T
    first, second = (mpmath.matrix([[1 - at[f"alpha_{j}"], 0], [-at[f"beta_{j}"] / at["T"], 1]]) for j in (1, 2))
    found = first * moved * second.T
    return Tensor.build((2, 2), lambda m, n: found[m, n])


def _gain(filter_: Callable[[int, At], tuple[Matrix, Matrix]], size: int) -> Callable[[At], Tensor[Number]]:
    def values(at: At) -> Tensor[Number]:
        with mpmath.workdps(DIGITS):
            return Tensor((size,), tuple(filter_(size, at)[0]))

    return values


def _covariance(filter_: Callable[[int, At], tuple[Matrix, Matrix]], size: int) -> Callable[[At], Tensor[Number]]:
    """In the units of the point, where it has any."""

    def values(at: At) -> Tensor[Number]:
        with mpmath.workdps(DIGITS):
            found, of_errors, period = filter_(size, at)[1], at.get("sigma_r", 1) ** 2, at.get("T", 1)
            return Tensor.build((size, size), lambda m, n: found[m, n] * of_errors / period ** (m + n))

    return values


DERIVATIONS: dict[str, Callable[[At], Tensor[Number]]] = {
    "fusion.cross_covariance.steady": _cross,
    "fusion.cross_covariance.updated": _cross_updated,
    "steady_state.alpha_beta.gain": _gain(_steady, 2),
    "steady_state.alpha_beta.covariance": _covariance(_steady, 2),
    "steady_state.alpha_beta_gamma.gain": _gain(_steady, 3),
    "steady_state.alpha_beta_gamma.covariance": _covariance(_steady, 3),
    **{f"fading_memory.degree{degree}": _gain(_fading, degree + 1) for degree in range(4)},
    **{f"fading_memory.degree{degree}.covariance": _covariance(_fading, degree + 1) for degree in range(4)},
}
