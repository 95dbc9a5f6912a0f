"""Transition and process noise of linear motions by their names."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from radartrack._arrays.validation import (
    RealArray,
    one_of,
    positive_number,
    real_number,
    require_finite,
    require_variances,
    whole_number,
)
from radartrack.generated import motion

MOST_AXES = 3
Number = Callable[[str, float], float]


class Noise(NamedTuple):
    """The generated function of a process noise, behind the name of the motion, and the symbol of its strength."""

    function: str
    symbol: str


@dataclass(frozen=True)
class LinearMotion:
    """What is to be said of a motion.

    Attributes:
        given: the parameter that the transition needs beside the period, if any: its symbol, and what makes its value.
        noises: the parameter of each process noise; one of them must be given.
        most_axes: how many axes may move like that.
    """

    noises: Mapping[str, Noise]
    given: Mapping[str, tuple[str, Number]]
    most_axes: int = MOST_AXES


def _rate_of_forgetting(name: str, value: float) -> float:
    return 1.0 / positive_number(name, value)


INTENSITY, STD = Noise("process_noise_continuous", "q"), Noise("process_noise_piecewise", "sigma_w")
NOISES = {"intensity": INTENSITY, "std": STD, "jump_std": Noise("process_noise_wiener_sequence", "sigma_w")}
FORGETTING = {"time_constant": ("alpha", _rate_of_forgetting)}
MOTIONS: Mapping[str, LinearMotion] = {
    "constant_position": LinearMotion(NOISES, {}),
    "constant_velocity": LinearMotion(NOISES, {}),
    "constant_acceleration": LinearMotion(NOISES, {}),
    "constant_jerk": LinearMotion(NOISES, {}),
    "singer": LinearMotion({"std": Noise("process_noise", "sigma_m")}, FORGETTING),
    "ornstein_uhlenbeck": LinearMotion({"intensity": Noise("process_noise", "q")}, FORGETTING),
    "turn.known_rate": LinearMotion({"intensity": INTENSITY, "std": STD}, {"rate": ("omega", real_number)}, 1),
}


def matrices(name: str, period: float, axes: int, parameters: Mapping[str, float]) -> tuple[RealArray, RealArray]:
    """F and Q of a motion, one block for each axis.

    Raises:
        TypeError: an argument is of the wrong type.
        ValueError: an argument is not allowed, or the matrices overflow or lose their digits.
    """
    known = MOTIONS[one_of("name", name, MOTIONS)]
    noise = _noise(name, known, parameters)
    blocks = whole_number("axes", axes, 1, known.most_axes)
    symbols = {"T": positive_number("period", period)}
    symbols |= {symbol: value(given, parameters[given]) for given, (symbol, value) in known.given.items()}
    strength = real_number(noise, parameters[noise])
    if strength < 0:
        raise ValueError(f"{noise} must be finite and at least 0; got {parameters[noise]}")
    function, symbol = known.noises[noise]
    prefix = name.replace(".", "_")
    with np.errstate(all="ignore"):  # what is not finite is refused below
        transition: RealArray = getattr(motion, f"{prefix}_transition")(**symbols)
        process_noise: RealArray = getattr(motion, f"{prefix}_{function}")(**symbols, **{symbol: strength})
    require_finite(f"the transition over the period {period}", transition)
    title = f"the process noise of {noise} {strength} over {period} s"
    require_finite(title, process_noise)
    if strength:
        require_variances(title, np.diagonal(process_noise))
    return np.kron(np.eye(blocks), transition), np.kron(np.eye(blocks), process_noise)


def _noise(name: str, known: LinearMotion, parameters: Mapping[str, float]) -> str:
    """The parameter that says how strong the noise is, where those given are those of the motion."""
    chosen = [parameter for parameter in parameters if parameter in known.noises]
    if len(chosen) != 1 or set(parameters) != {*known.given, *chosen}:
        wanted = [*known.given, " or ".join(known.noises)]
        raise ValueError(f"parameters of {name} must be {' and '.join(wanted)}; got {', '.join(parameters) or 'none'}")
    return chosen[0]
