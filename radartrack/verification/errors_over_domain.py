"""Rounding errors at points of a domain: of the stable form of a formula, and of the one that textbooks print."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from radartrack.derive.evaluation.balls import exact_arithmetic
from radartrack.derive.language.quantity import Quantity
from radartrack.derive.language.variable import Variable
from radartrack.verification.domain_points import sample
from radartrack.verification.error_in_ulp import Yardstick
from radartrack.verification.program_compilation import compiled
from radartrack.verification.subject import evaluated, generated

Array = npt.NDArray[np.float64]
NEAR_ZERO = 1e-6  # of the largest value, below which a scale that has zero is even


@dataclass(frozen=True)
class Axis:
    """One argument at all points.

    Attributes:
        label: its name and unit.
        values: shape (points,).
        scale: "log", "linear", or "symlog" where values of all sizes have either sign.
        even_below: the size up to which a scale with zero is even.
    """

    label: str
    values: Array
    scale: str
    even_below: float


@dataclass(frozen=True)
class ErrorsOverDomain:
    """What two ways to compute a quantity are off by, in ulp.

    Attributes:
        name: of the quantity.
        axes: its arguments that vary.
        stable: of the generated function, shape (points,).
        textbook: of the formula as it is derived.
    """

    name: str
    axes: tuple[Axis, ...]
    stable: Array
    textbook: Array


def errors_over_domain(quantity: Quantity, count: int = 600, seed: int = 0) -> ErrorsOverDomain:
    """The errors of the generated function and of the formula as it is derived, in double precision."""
    points = sample(quantity, count, seed)
    yardstick = Yardstick(quantity, points, exact_arithmetic()[1])
    entries = math.prod(quantity.shape)
    found = []
    for function in (generated(quantity), compiled(quantity.expression, quantity.symbols)):
        values = evaluated(function, quantity, points).reshape(-1, entries)
        found.append(yardstick.errors(values).max(axis=-1))
    axes = [_axis(symbol, points[symbol.name]) for symbol in quantity.symbols if np.ptp(points[symbol.name])]
    return ErrorsOverDomain(quantity.name, tuple(axes), *found)


def _axis(symbol: Variable, values: Array) -> Axis:
    scale = "log" if symbol.logarithmic else "linear" if symbol.is_angle else "symlog"
    largest = max(abs(symbol.low), abs(symbol.high))
    return Axis(f"{symbol.name} [{symbol.unit}]", values, scale, largest * NEAR_ZERO)
