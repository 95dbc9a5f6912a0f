"""Layer: the function does not depend on the units in which its arguments are given, angles included.

Metres and seconds are exchanged for other units, and every entry must change by the power that its unit says. A radian
that a derivative of a sine takes away leaves no trace in a formula, so a unit of angle cannot be exchanged in the same
way. What angle as a base dimension does say is tried instead: an angle is known up to full turns, its direction may be
counted the other way (Siano's orientation: a sine is odd, a cosine is even), and a standard deviation enters as the
root of a variance, whose sign is arbitrary.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cache

import numpy as np
import numpy.typing as npt

from radartrack.derive.language.model import Model
from radartrack.derive.language.quantity import Quantity
from radartrack.derive.language.variable import Variable
from radartrack.derive.units import RADIAN, Unit
from radartrack.verification.domain_points import Points, coarse
from radartrack.verification.outcome import Function, Outcome
from radartrack.verification.program_compilation import compiled
from radartrack.verification.subject import evaluated, model_of, relative, row_of, scale_of

NAME = "dimensions"
TOLERANCE = 1e-9
POINTS = 16
METRES, SECONDS = 4.0, 16.0
GOLDEN = (math.sqrt(5) - 1) / 2
Signs = npt.NDArray[np.float64]


@dataclass(frozen=True)
class Change:
    """Another way to say the same thing: what it does to the arguments and to the result."""

    title: str
    arguments: Mapping[str, tuple[float, float]]
    result: Signs

    def applied(self, points: Points) -> Points:
        """Each argument times a factor, plus an offset."""
        return {name: self._moved(name, values) for name, values in points.items()}

    def _moved(self, name: str, values: Signs) -> Signs:
        factor, offset = self.arguments.get(name, (1.0, 0.0))
        return values * factor + offset


@dataclass(frozen=True)
class Dimensions:
    """The function at random points, in one set of units and in others."""

    seed: int = 0
    name: str = NAME

    def __call__(self, quantity: Quantity, function: Function) -> Outcome:
        """The largest relative change that should not be there."""
        points = coarse(quantity, POINTS, self.seed + 2)
        before = evaluated(function, quantity, points)
        scale = scale_of(quantity, before)
        worst, title = 0.0, ""
        for change in changes(quantity):
            after = evaluated(function, quantity, change.applied(points))
            if row_of(quantity).startswith("std"):
                before, after = np.abs(before), np.abs(after)  # a root of a square is written without its sign
            found = relative(after, before * change.result, scale * np.abs(change.result))
            if found > worst or not title:
                worst, title = found, change.title
        if not title:
            return Outcome.not_applicable(NAME, "a number alone in the map has a unit, and nothing else can be changed")
        return Outcome.measured(NAME, worst, TOLERANCE, f"largest for {title}")


def changes(quantity: Quantity) -> Iterator[Change]:
    """The changes that a quantity must follow."""
    model = model_of(quantity)
    for title, metre, second in (("another unit of length", METRES, 1.0), ("another unit of time", 1.0, SECONDS)):
        if model is None or _is_homogeneous(model, metre, second):
            yield _units(quantity, title, metre, second)
    if model is None:
        return
    for angle in (v for v in model.measured if v in quantity.symbols and _is_periodic(model, v)):
        yield Change(f"{angle.name} a full turn further", {angle.name: (1.0, math.tau)}, np.ones(quantity.shape))
    if row_of(quantity).startswith("validity"):
        return
    for variable, deviation in zip(model.measured, model.deviations, strict=False):
        yield _opposite_deviation(quantity, model, variable, deviation)
    for variable in model.measured:
        mirrored = _mirrored(quantity, model, variable)
        if mirrored is not None:
            yield mirrored


def _units(quantity: Quantity, title: str, metre: float, second: float) -> Change:
    entries = [_factor(quantity.unit(index), metre, second) for index in np.ndindex(quantity.shape)]
    arguments = {symbol.name: (_factor(symbol.unit, metre, second), 0.0) for symbol in quantity.symbols}
    return Change(title, arguments, np.array(entries).reshape(quantity.shape))


def _factor(unit: Unit, metre: float, second: float) -> float:
    return float(metre ** float(unit.metre) * second ** float(unit.second))


def _correlated(model: Model, variable: Variable) -> list[str]:
    return [rho.name for pair, rho in model.correlations.items() if variable in pair]


def _opposite_deviation(quantity: Quantity, model: Model, variable: Variable, deviation: Variable) -> Change:
    flipped = [deviation.name, *_correlated(model, variable)]
    both = [*flipped, *(f"predicted_{name}" for name in flipped)]
    return Change(f"the other sign of {deviation.name}", dict.fromkeys(both, (-1.0, 0.0)), np.ones(quantity.shape))


def _mirrored(quantity: Quantity, model: Model, variable: Variable) -> Change | None:
    """The variable counted the other way, where every coordinate of the map is even or odd in it."""
    parities = _parities(model, variable)
    if parities is None:
        return None
    if row_of(quantity).startswith("std"):
        parities = np.abs(parities)
    inputs = np.array([-1.0 if other is variable else 1.0 for other in model.measured])
    result = np.ones(())
    for position, _ in enumerate(quantity.axes):
        is_output = position == 0 or row_of(quantity) not in {"jacobian", "hessian"}
        result = np.multiply.outer(result, parities if is_output else inputs)
    flipped = _correlated(model, variable)
    names = [variable.name, *flipped, *(f"predicted_{name}" for name in flipped)]
    return Change(f"{variable.name} counted the other way", dict.fromkeys(names, (-1.0, 0.0)), result)


@cache
def _is_periodic(model: Model, variable: Variable) -> bool:
    """Whether the variable is an angle that the map knows up to full turns; an arc r·beta is longer after each."""
    if variable.unit != RADIAN:
        return False
    program, point = compiled(model.map, model.arguments), _somewhere(model)
    before, after = (program(**point | {variable.name: point[variable.name] + turn}) for turn in (0.0, math.tau))
    return bool(_same(after, before).all())


@cache
def _is_homogeneous(model: Model, metre: float, second: float) -> bool:
    """Whether the map itself follows a change of units: in x + 100, the number has one that nobody can tell."""
    program, point = compiled(model.map, model.arguments), _somewhere(model)
    moved = {symbol.name: point[symbol.name] * _factor(symbol.unit, metre, second) for symbol in model.arguments}
    factors = np.array([_factor(unit, metre, second) for unit in model.units])
    return bool(_same(program(**moved), program(**point) * factors).all())


def _same(first: Signs, second: Signs) -> npt.NDArray[np.bool_]:
    return np.isclose(first, second, rtol=TOLERANCE, atol=0.0)


def _somewhere(model: Model) -> dict[str, np.float64]:
    """A point of the model's domain, off its ends and its middle."""
    shares = ((symbol, 0.3 + 0.4 * math.modf(n * GOLDEN)[0]) for n, symbol in enumerate(model.arguments, start=1))
    return {symbol.name: np.float64(symbol.low + (symbol.high - symbol.low) * share) for symbol, share in shares}


@cache
def _parities(model: Model, variable: Variable) -> Signs | None:
    """For each coordinate 1 where it is even in the variable, -1 where it is odd; None where one is neither."""
    program, point = compiled(model.map, model.arguments), _somewhere(model)
    plus = program(**point)
    minus = program(**{**point, variable.name: -point[variable.name]})
    signs = np.where(_same(minus, plus), 1.0, np.where(_same(minus, -plus), -1.0, 0.0))
    return None if (signs == 0).any() else signs
