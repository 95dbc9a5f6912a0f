"""Motions from scan to scan that are no matrix, with their derivatives and the noise that they leave."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Literal, TypeAlias

import numpy as np

from radartrack._arrays.validation import RealArray, one_of, positive_number, real_number, require_covariance
from radartrack.generated import motion as formulas

OfStates: TypeAlias = Callable[[RealArray], RealArray]
Grouping: TypeAlias = Literal["axis", "derivative"]
GROUPINGS: tuple[Grouping, ...] = ("axis", "derivative")


@dataclass(frozen=True)
class NonlinearMotion:
    """Functions of states (..., n), each for all tracks at once; any functions will do.

    Attributes:
        size: n.
        map: f, where states are a scan later, (..., n).
        jacobian: its first derivatives [out, in], (..., n, n).
        hessian: its second derivatives [out, in, in], (..., n, n, n).
        process_noise: Q, what the motion of a target in this state may add to the covariance, (..., n, n).

    """

    size: int
    map: OfStates
    jacobian: OfStates
    hessian: OfStates
    process_noise: OfStates

    def evaluated(self, name: str, states: RealArray) -> RealArray:
        """One of the functions at states (tracks, n).

        Raises:
            ValueError: what it gives has another shape, or is a process noise that is no covariance.

        """
        functions = {
            "map": (self.map, 1),
            "jacobian": (self.jacobian, 2),
            "hessian": (self.hessian, 3),
            "process_noise": (self.process_noise, 2),
        }
        function, axes = functions[name]
        values = np.asarray(function(states))
        shape = (len(states), *(self.size,) * axes)
        if values.shape != shape or values.dtype.kind != "f":
            raise ValueError(f"{name} must give floats of shape {shape}; got {values.dtype} of shape {values.shape}")
        if name == "process_noise":
            require_covariance(f"{name} of the motion", values)
        return values


@dataclass(frozen=True)
class _Known:
    """A motion of the catalogue: its state as the formulas take it, and what of that the process noise depends on."""

    state: tuple[str, ...]
    in_noise: tuple[str, ...]


@dataclass(frozen=True)
class _Formula:
    """A generated function as one of states. Processes hand it to each other, as they could not a function in another.

    Attributes:
        name: of the function.
        axes: that its values have beside those of the tracks.
        state: the components of the states that are given, in their order.
        taken: which of them the function takes.
        parameters: what else it takes.
        order: of the components in its values.

    """

    name: str
    axes: int
    state: tuple[str, ...]
    taken: tuple[str, ...]
    parameters: tuple[tuple[str, float], ...]
    order: tuple[int, ...]

    def __call__(self, states: RealArray) -> RealArray:
        """The values at states (..., n)."""
        components = dict(zip(self.state, np.moveaxis(states, -1, 0), strict=True))
        formula: Callable[..., RealArray] = getattr(formulas, self.name)
        found = formula(**{name: components[name] for name in self.taken}, **dict(self.parameters))
        for axis in range(-self.axes, 0):
            found = np.take(found, self.order, axis=axis)
        return found


KNOWN: Mapping[str, _Known] = {
    "turn.unknown_rate": _Known(("x", "vx", "y", "vy", "omega"), ("vx", "vy", "omega")),
    "ctrv": _Known(("x", "y", "speed", "heading", "omega"), ("speed", "heading", "omega")),
}
BY_DERIVATIVE = {"turn.unknown_rate": ("x", "y", "vx", "vy", "omega")}


def known_motion(name: str, period: float, std: float, turn_std: float, grouped: Grouping) -> NonlinearMotion:
    """A motion of the catalogue with noise that is constant over a period.

    Raises:
        TypeError: an argument is of the wrong type.
        ValueError: a word is not known, the period is not positive, or a deviation is negative.

    """
    chosen = one_of("name", name, KNOWN)
    known = KNOWN[chosen]
    by_derivative = one_of("grouped", grouped, GROUPINGS) == "derivative"
    state = BY_DERIVATIVE.get(chosen, known.state) if by_derivative else known.state
    T = positive_number("period", period)
    deviations = {"sigma_w": real_number("std", std), "sigma_omega": real_number("turn_std", turn_std)}
    for argument, value in zip(("std", "turn_std"), deviations.values(), strict=True):
        if value < 0:
            raise ValueError(f"{argument} must be at least 0; got {value:g}")
    order = tuple(known.state.index(component) for component in state)

    def of(function: str, axes: int) -> OfStates:
        taken, parameters = (known.in_noise, deviations) if function.startswith("process_noise") else (known.state, {})
        name = f"{chosen.replace('.', '_')}_{function}"
        return _Formula(name, axes, state, taken, (*parameters.items(), ("T", T)), order)

    return NonlinearMotion(
        len(state), of("map", 1), of("jacobian", 2), of("hessian", 3), of("process_noise_piecewise", 2)
    )
