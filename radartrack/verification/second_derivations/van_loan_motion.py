"""Linear motions driven by noise, from one exponential of a matrix (Van Loan 1978), in many digits."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import mpmath

from radartrack.derive.language.tensor import Tensor
from radartrack.derive.motion.polynomial_motion import MOTIONS

METHOD = "the exponential of a matrix (Van Loan)"
Number = Any
Matrix = Any
At = Mapping[str, Number]
Row = tuple[str, Callable[[At], Tensor[Number]]]
RESIDUE = 1e-50  # of 60 digits
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


@dataclass(frozen=True)
class Driven:
    """x' = A x + G w at one point of the domain.

    Attributes:
        drift: A.
        inputs: G, one column a noise.
        time: from scan to scan.
    """

    drift: Matrix
    inputs: Matrix
    time: Number

    def transition(self) -> Matrix:
        """F."""
        return self._exponential(self.drift)

    def white(self, intensity: Number) -> Matrix:
        """Q, from e^(M T) with M = [[−A, q G Gᵀ], [0, Aᵀ]], whose right blocks are F⁻¹ Q and Fᵀ."""
        found = self._exponential(_blocks(-self.drift, intensity * self.inputs * self.inputs.T, self.drift.T))
        size = self.drift.rows
        return found[size:, size:].T * found[:size, size:]

    def constant(self, deviation: Number) -> Matrix:
        """Q, from e^(M T) with M = [[A, G], [0, 0]], whose right upper block is ∫ e^(As) G ds."""
        size, noises = self.inputs.rows, self.inputs.cols
        found = self._exponential(_blocks(self.drift, self.inputs, mpmath.matrix(noises, noises)))
        return self._covariance(found[:size, size:], deviation)

    def jumping(self, deviation: Number) -> Matrix:
        """Q of jumps at the beginning of the period."""
        return self._covariance(self.transition() * self.inputs, deviation)

    def _exponential(self, matrix: Matrix) -> Matrix:
        return mpmath.expm(matrix * self.time)

    @staticmethod
    def _covariance(columns: Matrix, deviation: Number) -> Matrix:
        return deviation**2 * columns * columns.T


def _blocks(upper: Matrix, beside: Matrix, lower: Matrix) -> Matrix:
    """[[upper, beside], [0, lower]]."""
    size = upper.rows + lower.rows
    both = mpmath.matrix(size, size)
    both[: upper.rows, : upper.rows], both[: upper.rows, upper.rows :] = upper, beside
    both[upper.rows :, upper.rows :] = lower
    return both


def _polynomial(size: int) -> Callable[[At], Driven]:
    return lambda at: Driven(drift(size), _last(size), at["T"])


def _forgetting(size: int) -> Callable[[At], Driven]:
    """The last derivative decays."""

    def driven(at: At) -> Driven:
        a = drift(size)
        a[size - 1, size - 1] = -at["alpha"]
        return Driven(a, _last(size), at["T"])

    return driven


def _turning(at: At) -> Driven:
    """The velocities turn into each other; each is driven."""
    a, g = _plane_drift(), mpmath.matrix(len(PLANE), 2)
    across, along = PLANE.index("vx"), PLANE.index("vy")
    a[across, along], a[along, across] = -at["omega"], at["omega"]
    g[across, 0] = g[along, 1] = mpmath.mpf(1)
    return Driven(a, g, at["T"])


def _spun(at: At, first: Sequence[Number]) -> Matrix:
    """e, s e, s^2 e/2 and the integrals of the last two after a period, of a vector e in the plane that turns."""
    size, turn = 10, mpmath.matrix([[0, -at["omega"]], [at["omega"], 0]])
    rates = mpmath.matrix(size, size)
    for k in range(3):
        rates[2 * k : 2 * k + 2, 2 * k : 2 * k + 2] = turn
    one = mpmath.eye(2)
    rates[2:4, 0:2] = rates[4:6, 2:4] = rates[6:8, 2:4] = rates[8:10, 4:6] = one
    start = mpmath.matrix(size, 1)
    start[0, 0], start[1, 0] = first
    return mpmath.expm(rates * at["T"]) * start


def _bent_turn(at: At) -> Tensor[Number]:
    """Of a velocity that turns, and is turned by s^2/2 more: a quarter of a turn aside of s^2 v/2."""
    spun, T = _spun(at, (at["vx"], at["vy"])), at["T"]
    aside = mpmath.matrix([-spun[9], -spun[5], spun[8], spun[4], T])
    plain = _turning(at).constant(at["sigma_w"])
    found = at["sigma_omega"] ** 2 * aside * aside.T
    found[:4, :4] = found[:4, :4] + plain
    return _tensor(found)


def _bent_heading(at: At) -> Tensor[Number]:
    """Of a heading that turns: a push of s along it, and one of s^2/2 times the speed aside."""
    spun, T = _spun(at, (mpmath.cos(at["heading"]), mpmath.sin(at["heading"]))), at["T"]
    ahead = mpmath.matrix([spun[6], spun[7], T, 0, 0])
    aside = mpmath.matrix([-at["speed"] * spun[9], at["speed"] * spun[8], 0, T**2 / 2, T])
    return _tensor(at["sigma_w"] ** 2 * ahead * ahead.T + at["sigma_omega"] ** 2 * aside * aside.T)


def _last(size: int) -> Matrix:
    found = mpmath.matrix(size, 1)
    found[size - 1, 0] = mpmath.mpf(1)
    return found


def _plane_drift() -> Matrix:
    """Each velocity, and nothing else, moves the coordinate of its name."""
    a = mpmath.matrix(len(PLANE), len(PLANE))
    for axis in "xy":
        a[PLANE.index(axis), PLANE.index(f"v{axis}")] = mpmath.mpf(1)
    return a


def without_residues(values: Tensor[Number]) -> Tensor[Number]:
    """With zeros for what is nothing but rounding beside the largest entry."""
    least = RESIDUE * max(abs(value) for value in values)
    return values.map(lambda value: value if abs(value) > least else mpmath.mpf(0))


def _tensor(matrix: Matrix) -> Tensor[Number]:
    return without_residues(Tensor.build((matrix.rows, matrix.cols), lambda m, n: matrix[m, n]))


def _plane_transition(at: At) -> Tensor[Number]:
    return _tensor(exponential(_plane_drift() * at["T"]))


def _plane_observation(_: At) -> Tensor[Number]:
    return Tensor.build((2, len(PLANE)), lambda a, n: mpmath.mpf(int(PLANE[n] == "xy"[a])))


def _rows(
    name: str, driven: Callable[[At], Driven], noises: Mapping[str, Callable[[Driven, At], Matrix]]
) -> Iterator[Row]:
    yield f"motion.{name}.transition", lambda at: _tensor(driven(at).transition())
    for row, noise in noises.items():
        yield f"motion.{name}.process_noise{row}", _process_noise(driven, noise)


def _process_noise(
    driven: Callable[[At], Driven], noise: Callable[[Driven, At], Matrix]
) -> Callable[[At], Tensor[Number]]:
    return lambda at: _tensor(noise(driven(at), at))


def _white(driven: Driven, at: At) -> Matrix:
    return driven.white(at["q"])


def _constant(driven: Driven, at: At) -> Matrix:
    return driven.constant(at["sigma_w"])


def _jumping(driven: Driven, at: At) -> Matrix:
    return driven.jumping(at["sigma_w"])


def _stationary(driven: Driven, at: At) -> Matrix:
    """Singer's: as strong as leaves the acceleration its deviation for ever."""
    return driven.white(2 * at["alpha"] * at["sigma_m"] ** 2)


STEPWISE = {".continuous": _white, ".piecewise": _constant}
DERIVATIONS: dict[str, Callable[[At], Tensor[Number]]] = {
    **{
        row: values
        for size, (motion, *_) in MOTIONS.items()
        for row, values in _rows(motion, _polynomial(size), {**STEPWISE, ".wiener_sequence": _jumping})
    },
    **dict(_rows("singer", _forgetting(3), {"": _stationary})),
    **dict(_rows("ornstein_uhlenbeck", _forgetting(2), {"": _white})),
    **dict(_rows("turn.known_rate", _turning, STEPWISE)),
    "motion.turn.unknown_rate.process_noise.piecewise": _bent_turn,
    "motion.ctrv.process_noise.piecewise": _bent_heading,
    "motion.plane.transition": _plane_transition,
    "motion.plane.observation": _plane_observation,
}
